"""A harness that catches unsound proof methods."""

from __future__ import annotations

from statements import FALSE

from symcheck.core.problems import Method, Outcome, Problem
from symcheck.core.verdicts import Verdict
from symcheck.selftest.evidence import answered


def unsound(method: Method) -> list[str]:
    """The ids of the false statements that the method lets pass: called proved, or left with a certificate that holds.

    A method that raises, answers something else than an Outcome, or cannot back up its verdict is caught too.
    """
    return [problem.id for problem in FALSE if _fooled(method, problem)]


def _fooled(method: Method, problem: Problem) -> bool:
    try:
        outcome = method.decide(problem)
    except Exception:
        return True
    if not isinstance(outcome, Outcome) or outcome.verdict is Verdict.PROVED:
        return True
    if outcome.verdict is Verdict.REFUTED:
        return answered(problem, outcome) is not Verdict.REFUTED
    return not outcome.reason
