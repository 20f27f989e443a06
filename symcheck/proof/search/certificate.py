"""Certificates: what a decided statement claims, what it rests on, and the proof or the point."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from symcheck.core.certificates import Certificate
from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Outcome, Problem
from symcheck.core.terms import JSON, Formula, Term
from symcheck.core.verdicts import Verdict
from symcheck.proof.algebra.facts import Hypothesis, Reference
from symcheck.proof.algebra.polynomial import subterms
from symcheck.proof.rules.proof import Proof
from symcheck.proof.rules.step import mentioned, written
from symcheck.proof.search.methods import whole_proof
from symcheck.proof.search.witnesses import find_witnesses, implications, with_definitions


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


def certificate(problem: Problem, outcome: Outcome, lemmas: Lemmas | None = None) -> Certificate:
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
    terms: list[Term] = []
    body: dict[str, object]
    if outcome.verdict is Verdict.PROVED:
        assert outcome.proof is not None
        proof = outcome.proof
        given = {n: [k for k in range(len(fs)) if Hypothesis(n, k) in proof.given] for n, fs in hypotheses.items()}
        hypotheses = {name: [hypotheses[name][k] for k in ks] for name, ks in given.items() if ks}
        body = _proved(proof, given, problem, lemmas)
        terms = mentioned(proof.step, dict(problem.definitions))
    else:
        assert outcome.point is not None
        body = {"point": outcome.point.certificate(problem.claim)}
    stated = (f for formulas in hypotheses.values() for f in formulas)
    names = {*subterms(*with_definitions(dict(problem.definitions), problem.claim, *stated, *terms))}
    definitions: Sequence[tuple[str, Term]] = [(name, term) for name, term in problem.definitions if name in names]
    whole: dict[str, object] = {
        "id": problem.id,
        "verdict": outcome.verdict,
        "claim": lemmas.whole.claim if lemmas else problem.claim,
        "definitions": lemmas.defined if lemmas else definitions,
        "hypotheses": _in_force(hypotheses, lemmas.under) if lemmas else hypotheses,
    }
    plain: Certificate = json.loads(written(whole | body | ({"lemmas": lemmas.facts} if lemmas else {})))
    if lemmas:  # of definitions that it does not use the proof knows what the lemmas say
        free = {name for name, _ in lemmas.defined} - {name for name, _ in definitions}
        atoms = plain["proof"].get("atoms")
        named: dict[str, JSON] = {name: name for name in sorted(free)}
        plain["proof"]["atoms"] = named | (atoms if isinstance(atoms, dict) else {})
    return plain


def _in_force(
    hypotheses: Mapping[str, Sequence[Formula]], under: Iterable[tuple[str, Sequence[Formula]]]
) -> dict[str, list[Formula]]:
    """The hypotheses with those that lemmas are proved under."""
    found = {name: [*formulas] for name, formulas in hypotheses.items()}
    for name, formulas in under:
        own = found.setdefault(name, [])
        own += [part for formula in formulas for part in conjuncts(formula) if part not in own]
    return found


def _proved(
    proof: Proof, given: Mapping[str, Sequence[int]], problem: Problem, lemmas: Lemmas | None
) -> dict[str, object]:
    """The proof, hypotheses counted among those given, with its conditions, and a point for each implication."""

    def change(ref: Reference) -> Reference:
        return Hypothesis(ref.name, given[ref.name].index(ref.number)) if isinstance(ref, Hypothesis) else ref

    whole, points = problem, proof.witnesses
    if lemmas:
        whole = lemmas.whole
        points = tuple(find_witnesses(whole, proof.nonzero, whole_proof) or ())
    if len(points) == 1:
        points *= len(implications(whole.claim)) or 1
    witnesses = [point.certificate() for point in points]
    listed = {"nonzero": proof.nonzero, "witnesses": witnesses}
    return {"proof": proof.step.mapped(change)} | {name: part for name, part in listed.items() if part}
