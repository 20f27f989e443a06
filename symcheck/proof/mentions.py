"""What a proof mentions: hypotheses, terms, polynomials."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from symcheck.core.formulas import sides
from symcheck.core.terms import Term, node
from symcheck.core.verdicts import Certificate
from symcheck.proof.applied import theorem_of


def references(tree: Any) -> set[tuple[str, int]]:
    """The hypotheses a proof refers to."""
    if isinstance(tree, dict):
        own = {(name, k) for name, k in tree.get("given", ())}
        return own.union(*(references(value) for key, value in tree.items() if key not in ("given", "witnesses")))
    if isinstance(tree, list):
        if len(tree) == 3 and tree[0] == "hyp":
            return {(tree[1], tree[2])}
        return set().union(*(references(child) for child in tree))
    return set()


def terms_in(tree: Any, definitions: Mapping[str, Term]) -> list[Any]:
    """The terms (forms, points, what theorems speak of) a proof mentions."""
    if isinstance(tree, dict):
        own = [tree["form"]] if "form" in tree else [*tree.get("point", {}).values()]
        if "of" in tree:
            theorem = theorem_of(tree["of"], definitions)
            own += [side for formula in (*theorem.premises, theorem.conclusion) for side in sides(formula)]
        return own + [
            t for key, value in tree.items() if key not in ("of", "witnesses") for t in terms_in(value, definitions)
        ]
    if isinstance(tree, list):
        if len(tree) == 2 and tree[0] == "positive":
            return [tree[1]]
        return [t for child in tree for t in terms_in(child, definitions)]
    return []


def texts_in(tree: Any) -> Iterator[str]:
    """The polynomials a proof mentions, as they are printed."""
    if isinstance(tree, dict):
        yield from (text for text in (*tree.get("clear", ()), *tree.get("times", ())) if isinstance(text, str))
        yield from (text for _, *texts in tree.get("cofactors", ()) for text in texts)
        yield from (text for text, _ in tree.get("factors", ()))
        yield from (text for texts in tree.get("nonzero", ()) for text in texts)
        for part in tree.values():
            yield from texts_in(part)
    elif isinstance(tree, list):
        for part in tree:
            yield from texts_in(part)


def nonzero_terms(proof: Certificate) -> list[Term]:
    """The denominators of a statement about which no hypothesis speaks; one with denominators in it is a fraction."""
    meant = proof.get("atoms", {})
    return [_fraction(*(term_of_text(text, meant) for text in texts)) for texts in proof.get("nonzero", ())]


def _fraction(top: Term, *below: Term) -> Term:
    return node("/", top, below[0] if len(below) == 1 else node("*", *below)) if below else top


def term_of_text(text: str, meant: Mapping[str, Term]) -> Term:
    """A polynomial as it is printed, as a term."""
    addends = [_product(term, meant) for term in text.replace(" - ", " + -").split(" + ")]
    return addends[0] if len(addends) == 1 else node("+", *addends)


def _product(text: str, meant: Mapping[str, Term]) -> Term:
    if text.startswith("-"):
        return node("-", _product(text[1:], meant))
    factors: list[Term] = []
    for factor in text.split("*"):
        name, _, exponent = factor.partition("^")
        top, _, bottom = name.partition("/")
        number: Term = (
            node("/", int(top), int(bottom)) if bottom else int(top) if top.isdigit() else meant.get(name, name)
        )
        factors.append(node("^", number, int(exponent)) if exponent else number)
    return factors[0] if len(factors) == 1 else node("*", *factors)
