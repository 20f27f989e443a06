"""The certificate of one decided statement: what it claims, what it rests on, and the proof or the point."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Mapping
from typing import Any

from symcheck.proof.polynomial import subterms, theorem_of
from symcheck.statement import Certificate, Outcome, Problem, Term, Verdict
from symcheck.theorems import conjuncts, sides


def certificate(problem: Problem, outcome: Outcome) -> Certificate:
    """The outcome as JSON data. A proof lists just the hypotheses and definitions it uses, a refutation all hypotheses.

    ValueError for an undecided outcome: it has no certificate.
    """
    if outcome.verdict is Verdict.UNDECIDED:
        raise ValueError(f"{problem.id} is undecided: there is nothing to certify")
    hypotheses = {name: [part for f in formulas for part in conjuncts(f)] for name, formulas in problem.hypotheses}
    body: Certificate
    if outcome.verdict is Verdict.PROVED:
        assert outcome.proof is not None
        proof = outcome.proof
        given = {(name, k) for name, k in outcome.proof["given"]}
        kept = {name: [k for k in range(len(fs)) if (name, k) in given] for name, fs in hypotheses.items()}
        hypotheses = {name: [hypotheses[name][k] for k in ks] for name, ks in kept.items() if ks}
        body = {"verdict": "proved", "proof": _renumber(proof, kept)}
        body |= {"witnesses": proof["witnesses"]} if "witnesses" in proof else {}
        mentioned: list[Any] = [problem.claim, list(hypotheses.values()), *terms_in(proof, dict(problem.definitions))]
    else:
        assert outcome.point is not None
        body = {"verdict": "refuted", "point": outcome.point}
        mentioned = [problem.claim, list(hypotheses.values())]
    reached = _reached(problem, mentioned)
    stated = {
        "id": problem.id,
        "claim": problem.claim,
        "definitions": [[name, term] for name, term in problem.definitions if name in reached],
        "hypotheses": hypotheses,
    }
    plain: Certificate = json.loads(json.dumps(stated))
    return {**plain, "digest": digest(plain), **json.loads(json.dumps(body))}


def digest(stated: Certificate) -> str:
    """SHA-256 of the canonical JSON of id, claim, definitions and hypotheses."""
    subject = {key: stated[key] for key in ("id", "claim", "definitions", "hypotheses")}
    return hashlib.sha256(json.dumps(subject, sort_keys=True, separators=(",", ":")).encode()).hexdigest()


def _renumber(node: Any, kept: dict[str, list[int]]) -> Any:
    """The proof with ["hyp", name, k] counted among the kept formulas."""
    if isinstance(node, dict):
        return {key: _renumber(value, kept) for key, value in node.items() if key not in ("given", "witnesses")}
    if isinstance(node, list):
        if len(node) == 3 and node[0] == "hyp":
            return ["hyp", node[1], kept[node[1]].index(node[2])]
        return [_renumber(child, kept) for child in node]
    return node


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


def _reached(problem: Problem, mentioned: list[Any]) -> set[str]:
    definitions = dict(problem.definitions)
    open_, reached = list(mentioned), set()
    while open_:
        node = open_.pop()
        if isinstance(node, list):
            open_ += node
            continue
        for name in subterms(node):
            if isinstance(name, str) and name in definitions and name not in reached:
                reached.add(name)
                open_.append(definitions[name])
    return reached
