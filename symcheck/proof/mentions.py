"""What a proof mentions: hypotheses, terms, polynomials."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from symcheck.proof.polynomial import theorem_of
from symcheck.proof.theorems import sides
from symcheck.statement import Certificate, Term


def references(node: Any) -> set[tuple[str, int]]:
    """The hypotheses a proof refers to."""
    if isinstance(node, dict):
        own = {(name, k) for name, k in node.get("given", ())}
        return own.union(*(references(value) for key, value in node.items() if key not in ("given", "witnesses")))
    if isinstance(node, list):
        if len(node) == 3 and node[0] == "hyp":
            return {(node[1], node[2])}
        return set().union(*(references(child) for child in node))
    return set()


def terms_in(node: Any, definitions: Mapping[str, Term]) -> list[Any]:
    """The terms (forms, points, what theorems speak of) a proof mentions."""
    if isinstance(node, dict):
        own = [node["form"]] if "form" in node else [*node.get("point", {}).values()]
        if "of" in node:
            theorem = theorem_of(node["of"], definitions)
            own += [side for formula in (*theorem.premises, theorem.conclusion) for side in sides(formula)]
        return own + [
            t for key, value in node.items() if key not in ("of", "witnesses") for t in terms_in(value, definitions)
        ]
    if isinstance(node, list):
        if len(node) == 2 and node[0] == "positive":
            return [node[1]]
        return [t for child in node for t in terms_in(child, definitions)]
    return []


def texts_in(node: Any) -> Iterator[str]:
    """The polynomials a proof mentions, as they are printed."""
    if isinstance(node, dict):
        yield from node.get("clear", ())
        yield from (text for _, *texts in node.get("cofactors", ()) for text in texts)
        yield from (text for text, _ in node.get("factors", ()))
        yield from (text for texts in node.get("nonzero", ()) for text in texts)
        for part in node.values():
            yield from texts_in(part)
    elif isinstance(node, list):
        for part in node:
            yield from texts_in(part)


def nonzero_terms(proof: Certificate) -> list[Term]:
    """The denominators of a statement about which no hypothesis speaks, as terms."""
    meant = proof.get("atoms", {})
    return list(dict.fromkeys(_term(text, meant) for texts in proof.get("nonzero", ()) for text in texts))


def _term(text: str, meant: Mapping[str, Term]) -> Term:
    """A polynomial as it is printed, as a term."""
    addends = [_product(term, meant) for term in text.replace(" - ", " + -").split(" + ")]
    return addends[0] if len(addends) == 1 else ("+", *addends)


def _product(text: str, meant: Mapping[str, Term]) -> Term:
    if text.startswith("-"):
        return "-", _product(text[1:], meant)
    factors: list[Term] = []
    for factor in text.split("*"):
        name, _, exponent = factor.partition("^")
        top, _, bottom = name.partition("/")
        number: Term = ("/", int(top), int(bottom)) if bottom else int(top) if top.isdigit() else meant.get(name, name)
        factors.append(("^", number, int(exponent)) if exponent else number)
    return factors[0] if len(factors) == 1 else ("*", *factors)
