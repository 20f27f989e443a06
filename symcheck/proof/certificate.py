"""Certificates: what a decided statement claims, what it rests on, and the proof or the point, as the checker reads it.

Polynomials of the search have variables such as sin_x for what is no letter: a certificate says what these stand for.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from symcheck.checker.theorems import NAMES, theorem
from symcheck.core import certificates
from symcheck.core.calculus import substituted
from symcheck.core.formulas import FALSE, conjuncts
from symcheck.core.problems import Outcome, Problem
from symcheck.core.terms import Formula, Node, Quantified, Term, node
from symcheck.core.verdicts import Certificate, Verdict
from symcheck.proof.applied import HAVE, Instance
from symcheck.proof.mentions import nonzero_terms, term_of_text, terms_in, texts_in
from symcheck.proof.methods import proof_of
from symcheck.proof.polynomial import subterms
from symcheck.proof.witness import find_witnesses, implications, with_definitions

VARIABLE = re.compile(r"[A-Za-z]\w*")


class Lemmas(NamedTuple):
    """Relations from which a statement is proved, and the statement itself.

    Parameters
    ----------
    facts
        The relations, each as (id, formula).
    whole
        The statement.
    under
        The hypotheses under which the lemmas are proved, by name.
    defined
        All definitions on which the statement and the lemmas rest.
    """

    facts: Sequence[tuple[str, Formula]]
    whole: Problem
    under: Sequence[tuple[str, Sequence[Formula]]]
    defined: Sequence[tuple[str, Term]]


def certificate(problem: Problem, outcome: Outcome, lemmas: Lemmas | None = None) -> certificates.Certificate:
    """Write what a method found as JSON data that the checker reads.

    Parameters
    ----------
    problem
        What was decided. With lemmas, that these imply the claim.
    outcome
        What the method said of it.
    lemmas
        The relations from which the proof starts.

    Returns
    -------
    dict
        The certificate. A proof lists only the hypotheses and definitions that it uses, with points where all that is
        assumed holds together; a refutation lists all hypotheses.

    Raises
    ------
    ValueError
        If the outcome is undecided.

    See Also
    --------
    symcheck.checker.check : Whether a certificate holds.
    """
    if outcome.verdict is Verdict.UNDECIDED:
        raise ValueError(f"{problem.id} is undecided: there is nothing to certify")
    hypotheses = {name: [part for f in formulas for part in conjuncts(f)] for name, formulas in problem.hypotheses}
    body: dict[str, Any]
    if outcome.verdict is Verdict.PROVED:
        assert outcome.proof is not None
        proof = outcome.proof
        given = {(name, k) for name, k in proof["given"]}
        kept = {name: [k for k in range(len(fs)) if (name, k) in given] for name, fs in hypotheses.items()}
        hypotheses = {name: [hypotheses[name][k] for k in ks] for name, ks in kept.items() if ks}
        whole = lemmas.whole if lemmas else problem
        points = find_witnesses(whole, nonzero_terms(proof), proof_of) if lemmas else proof.get("witnesses")
        body = _proved(whole.claim, proof, kept, points or ())
        mentioned: list[Term] = terms_in(proof, dict(problem.definitions))
    else:
        assert outcome.point is not None
        body = {"point": point(outcome.point, problem.claim)}
        mentioned = []
    names = {*subterms(*with_definitions(dict(problem.definitions), problem.claim, *_formulas(hypotheses), *mentioned))}
    stated: dict[str, Any] = {
        "id": problem.id,
        "verdict": outcome.verdict,
        "claim": problem.claim,
        "definitions": [[name, term] for name, term in problem.definitions if name in names],
        "hypotheses": hypotheses,
    }
    if lemmas:
        body |= _resting(stated, lemmas)
        known = {name for name, _ in stated["definitions"]}  # of others the proof knows what the lemmas say
        free = {name for name, _ in lemmas.defined} - known
        body["proof"]["atoms"] = {name: name for name in sorted(free)} | body["proof"].get("atoms", {})
    found: certificates.Certificate = json.loads(json.dumps({**stated, **body}))
    return found


def _formulas(hypotheses: Mapping[str, Iterable[Formula]]) -> list[Formula]:
    return [formula for formulas in hypotheses.values() for formula in formulas]


def _resting(stated: Mapping[str, Any], lemmas: Lemmas) -> dict[str, Any]:
    """What is stated where lemmas are used: the claim alone, under all that is in force for the lemmas too."""
    hypotheses = {name: [*formulas] for name, formulas in stated["hypotheses"].items()}
    for name, formulas in lemmas.under:
        own = hypotheses.setdefault(name, [])
        own += [part for formula in formulas for part in conjuncts(formula) if part not in own]
    return {
        "claim": lemmas.whole.claim,
        "definitions": lemmas.defined,
        "lemmas": lemmas.facts,
        "hypotheses": hypotheses,
    }


def _proved(
    claim: Formula, found: Certificate, kept: Mapping[str, Sequence[int]], points: Sequence[Certificate]
) -> dict[str, Any]:
    """The proof with its conditions, and a point for each implication of the claim."""
    listed = {"nonzero": conditions} if (conditions := nonzero_terms(found)) else {}
    if points and len(points) == 1:
        points = [*points] * (len(implications(claim)) or 1)
    shown = {"witnesses": [witness(each) for each in points]} if points else {}
    return {"proof": proof(found, kept), **listed, **shown}


def witness(found: Certificate) -> dict[str, Any]:
    """A point where something holds, which is computed: what is shown at it is left out."""
    return point({key: value for key, value in found.items() if key in ("values", "calls", "functions")})


def proof(found: Certificate, kept: Mapping[str, Sequence[int]] | None = None) -> dict[str, Any]:
    """A whole proof, hypotheses counted among those kept, with what its variables stand for."""
    meant = found.get("atoms", {})
    new = _step(_renumbered(found, kept) if kept is not None else found, meant)
    used = {name for text in texts_in(new) for name in VARIABLE.findall(text)}
    atoms = {name: meant[name] for name in sorted(used & meant.keys())}
    positive = found.get("positive", ())
    return {**new, **({"atoms": atoms} if atoms else {}), **({"positive": positive} if positive else {})}


def _renumbered(tree: Any, kept: Mapping[str, Sequence[int]]) -> Any:
    """The proof with ["hyp", name, k] counted among the kept formulas."""
    if isinstance(tree, dict):
        return {key: _renumbered(value, kept) for key, value in tree.items() if key != "witnesses"}
    if isinstance(tree, list):
        if len(tree) == 3 and tree[0] == "hyp":
            return ["hyp", tree[1], kept[tree[1]].index(tree[2])]
        return [_renumbered(child, kept) for child in tree]
    return tree


def _step(found: Certificate, meant: Mapping[str, Term]) -> dict[str, Any]:
    """One step, with those above it."""
    new: dict[str, Any] = {}
    for key, value in found.items():
        match key:
            case "premises" | "parts" | "cases":
                new[key] = [_step(each, meant) for each in value]
            case "then":
                new[key] = _step(value, meant)
            case "factors":
                new["form"] = node("*", *(node("^", term_of_text(text, meant), n) for text, n in value))
            case "clear" | "times":
                new["times"] = [*new.get("times", ()), *value]
            case "rule" | "of" | "form" | "point" | "cofactors" | "index" | "or":
                new[key] = value
    return new if "of" not in new else _theorem(new["of"], new["premises"], new["then"])


def _theorem(instance: Instance, premises: list[Any], then: Any) -> dict[str, Any]:
    """A theorem with its arguments by name; a premise about all numbers is proved for a new letter."""
    if instance.name == HAVE:
        return {"rule": HAVE, "formula": instance.given[0][1], "proof": premises[0], "then": then}
    given: dict[str, Any] = {
        name: argument if isinstance(argument, int | str | Node) else {"letter": argument[0][0], "term": argument[1]}
        for name, argument in instance.given
    }
    new: dict[str, Any] = {"rule": "theorem", "of": instance.name, "with": given, "then": then}
    stated = theorem(instance.name) if instance.name in NAMES else None
    every = [isinstance(each, Quantified) for each in stated.premises] if stated else [False] * len(premises)
    new["premises"] = [
        {"rule": "every", "letters": [instance.letter], "then": each} if about_all else each
        for each, about_all in zip(premises, every, strict=True)
    ]
    if stated and isinstance(stated.conclusion, Quantified):
        new["letters"] = [instance.letter]
    if instance.numbers or instance.name == "enclosure":
        new["numbers"] = dict(instance.numbers)
    return new


def point(found: Certificate, claim: Formula | None = None) -> dict[str, Any]:
    """A point, with the proofs that go with it, and what is shown of the claim there."""
    values = dict(found["values"])
    for _ in values:  # coordinates may be given by others
        values = {x: substituted(value, values) for x, value in values.items()}
    new: dict[str, Any] = {"values": dict(sorted(values.items()))}
    shown = [_valued(*pair) for pair in zip(claim.outside, found.get("sides", ()), strict=False)] if claim else []
    shown += [node("and", node("<=", low, t), node("<=", t, high)) for t, _, low, high in found.get("enclosed", ())]
    new |= {"shown": shown} if shown else {}
    new |= {"calls": found["calls"]} if "calls" in found else {}
    known = [(node("=", substituted(t, values), v), proof(why)) for t, v, why in found.get("functions", ())]
    known += [(fact, proof(why)) for fact, why in found.get("facts", ())]
    last: Any = {"rule": "compute", "values": [["here", k] for k in range(len(known))]}
    if "proof" in found:
        last = proof(found["proof"])
    if known or "proof" in found:
        facts = 0
        steps: list[tuple[Formula, Any]] = []
        for formula, why in known:
            steps.append((formula, _shifted(why, len(values), facts)))
            facts += len(conjuncts(formula))
        new["proof"] = _shifted(last, len(values), facts) if "proof" in found else last
        for formula, why in reversed(steps):
            new["proof"] = {"rule": HAVE, "formula": formula, "proof": why, "then": new["proof"]}
    return new


def _valued(side: Term, value: Term) -> Formula:
    """That a side of a claim has a value there; one that is a formula is true or false."""
    if not isinstance(value, bool):
        return node("=", side, value)
    assert isinstance(side, Node)
    return side if value else node("=>", side, FALSE)


def _shifted(tree: Any, own: int, facts: int) -> Any:
    """References to facts at a point: its coordinates, what was proved there before, and what a step assumes."""
    if isinstance(tree, dict):
        return {key: _shifted(value, own, facts) for key, value in tree.items()}
    if isinstance(tree, list):
        match tree:
            case ["hyp", "point", int(k)]:
                return ["point", k] if k < own else ["here", k - own]
            case ["here", int(k)]:
                return ["here", k + facts]
        return [_shifted(value, own, facts) for value in tree]
    return tree
