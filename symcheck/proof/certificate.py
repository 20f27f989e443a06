"""The certificate of one decided statement: what it claims, what it rests on, and the proof or the point."""

from __future__ import annotations

import hashlib
import json
from typing import Any

from symcheck.proof.mentions import nonzero_terms, terms_in
from symcheck.proof.methods import proof_of
from symcheck.proof.polynomial import subterms
from symcheck.proof.theorems import conjuncts
from symcheck.proof.witness import find_witnesses
from symcheck.statement import Certificate, Outcome, Problem, Verdict


def certificate(problem: Problem, outcome: Outcome, whole: Problem | None = None) -> Certificate:
    """The outcome as JSON data. A proof lists just the hypotheses and definitions it uses, a refutation all hypotheses.

    A proof comes with points where all that is assumed holds together, if such are found; where it starts from lemmas,
    of the `whole` problem that is proved with them.

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
        points = find_witnesses(whole, nonzero_terms(proof), proof_of) if whole else proof.get("witnesses")
        body |= {"witnesses": points} if points else {}
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
