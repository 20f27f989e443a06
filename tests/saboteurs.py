"""A harness that catches unsound proof methods, and six methods that ought to be caught."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace

from statements import FALSE

from symcheck.checker import check
from symcheck.proof import certificate, identity
from symcheck.statement import Formula, Method, Outcome, Problem, Verdict


def unsound(method: Method) -> list[str]:
    """The ids of the false statements that the method lets pass: called proved, or left with a certificate that holds.

    A method that raises, answers something else than an Outcome, or cannot back up its verdict is caught too.
    """
    return [problem.id for problem in FALSE if _fooled(method, problem)]


def _fooled(method: Method, problem: Problem) -> bool:
    try:
        outcome = method.decide(problem)
        if not isinstance(outcome, Outcome) or outcome.verdict is Verdict.PROVED:
            return True
        if outcome.verdict is Verdict.REFUTED:
            return check(json.loads(json.dumps(certificate(problem, outcome)))) is not None
    except Exception:
        return True
    return not outcome.reason


EMPTY = {"rule": "identity", "cofactors": [], "given": []}
PROVED = Outcome(Verdict.PROVED, proof=EMPTY)


def always_yes(problem: Problem) -> Outcome:
    return PROVED


def compares_with_itself(problem: Problem) -> Outcome:
    claim = problem.claim
    same: Formula = ("=", claim[1], claim[1]) if claim[0] == "=" else ("=", 0, 0)
    return identity.decide(replace(problem, claim=same))


def swallows_exceptions(problem: Problem) -> Outcome:
    try:
        raise NotImplementedError
    except Exception:
        return PROVED


def none_is_true(problem: Problem) -> Outcome:
    outcome = identity.decide(replace(problem, hypotheses=()))
    return PROVED if outcome.proof is None else outcome


def one_sample_point(problem: Problem) -> Outcome:
    """Looks at the origin only, where nearly all of these statements hold."""
    origin = replace(problem, claim=("=", 0, 0))
    return PROVED if identity.decide(origin).verdict is Verdict.PROVED else Outcome(Verdict.UNDECIDED, reason="no")


def ignores_hypotheses(problem: Problem) -> Outcome:
    """Treats the claim as one of its own hypotheses: everything follows."""
    return identity.decide(replace(problem, hypotheses=(*problem.hypotheses, ("assumed", (problem.claim,)))))


SABOTEURS: tuple[Callable[[Problem], Outcome], ...] = (
    always_yes,
    compares_with_itself,
    swallows_exceptions,
    none_is_true,
    one_sample_point,
    ignores_hypotheses,
)
