"""Sabotaged proof methods: whatever they answer, nothing false may come with a certificate that holds."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from random import Random
from typing import Any

from symcheck.evidence.record import Record
from symcheck.proof import fails_at, identity
from symcheck.proof.theorems import CONSTANTS, Terms
from symcheck.selftest.evidence import answered, problem_of
from symcheck.selftest.trial import Fate, FaultClass, Trial
from symcheck.statement import Formula, Outcome, Problem, Verdict

PROVED = Outcome(Verdict.PROVED, proof={"rule": "identity", "cofactors": [], "given": []})
MOST = 20_000  # characters of a statement that is put to them: some proofs hang on longer ones for minutes


def always_yes(problem: Problem) -> Outcome:
    """Everything is proved."""
    return PROVED


def always_no(problem: Problem) -> Outcome:
    """Everything is refuted, at the point where all letters are 1."""
    stated = ["0", "1"] if len(problem.claim) == 3 else []
    return Outcome(Verdict.REFUTED, point={"values": dict.fromkeys(_letters(problem), "1"), "sides": stated})


def compares_with_itself(problem: Problem) -> Outcome:
    """The left side equals the left side."""
    claim = problem.claim
    same: Formula = ("=", claim[1], claim[1]) if claim[0] == "=" else ("=", 0, 0)
    return identity.decide(replace(problem, claim=same))


def swallows_exceptions(problem: Problem) -> Outcome:
    """What fails is taken for done."""
    try:
        raise NotImplementedError
    except Exception:
        return PROVED


def none_is_true(problem: Problem) -> Outcome:
    """Where no proof was found, none is taken for one."""
    outcome = identity.decide(replace(problem, hypotheses=()))
    return PROVED if outcome.proof is None else outcome


def one_sample_point(problem: Problem) -> Outcome:
    """Holds where all letters are 1, so it holds."""
    return Outcome(Verdict.UNDECIDED, reason="no") if fails_at(problem, dict.fromkeys(_letters(problem), 1)) else PROVED


def ignores_the_domain(problem: Problem) -> Outcome:
    """Takes a counterexample where it finds one, in force or not."""
    return identity.decide(replace(problem, hypotheses=()))


def assumes_the_claim(problem: Problem) -> Outcome:
    """Treats the claim as one of its own hypotheses: everything follows."""
    return identity.decide(replace(problem, hypotheses=(*problem.hypotheses, ("assumed", (problem.claim,)))))


SABOTEURS: tuple[Callable[[Problem], Outcome], ...] = (
    always_yes,
    always_no,
    compares_with_itself,
    swallows_exceptions,
    none_is_true,
    one_sample_point,
    ignores_the_domain,
    assumes_the_claim,
)


def _letters(problem: Problem) -> list[str]:
    """The letters without a definition."""
    algebra = Terms(dict(problem.definitions))
    formulas = [problem.claim, *(formula for _, stated in problem.hypotheses for formula in stated)]
    return sorted(set().union(*map(algebra.names, formulas)) - {*CONSTANTS})


def _kind(saboteur: Callable[[Problem], Outcome]) -> str:
    return saboteur.__name__.replace("_", " ")


def _places(records: Sequence[Record]) -> list[str]:
    """All refuted statements with their certificates, and as many proved ones."""
    found: dict[Verdict, list[str]] = {Verdict.REFUTED: [], Verdict.PROVED: []}
    for record in records:
        for each in record.certificates:
            if "exists" not in json.dumps(each["claim"]) and len(text := json.dumps(each)) < MOST:
                found[Verdict(each["verdict"])].append(text)
    refuted, proved = found.values()
    return refuted + proved[:: max(1, len(proved) // max(1, len(refuted)))]


def trials(place: str, count: int, rng: Random) -> Iterator[Trial]:
    """Each sabotaged method before one decided statement."""
    evidence: dict[str, Any] = json.loads(place)
    problem, truth = problem_of(evidence), Verdict(evidence["verdict"])
    for saboteur in rng.sample(SABOTEURS, min(count, len(SABOTEURS))):
        worth = answered(problem, _answer(saboteur, problem))
        fates = {Verdict.UNDECIDED: Fate.REJECTED, truth: Fate.EQUIVALENT}
        yield Trial(_kind(saboteur), problem.id, fates.get(worth, Fate.ACCEPTED))


def _answer(saboteur: Callable[[Problem], Outcome], problem: Problem) -> Outcome | None:
    try:
        return saboteur(problem)
    except Exception:  # a method that fails answers nothing
        return None


CLASS = FaultClass(
    "methods",
    "sabotaged proof methods, before statements that are decided",
    tuple(map(_kind, SABOTEURS)),
    share=400,
    places=_places,
    trials=trials,
)
