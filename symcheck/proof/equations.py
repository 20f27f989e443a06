"""Equations by ideal membership: left - right is a combination of the hypotheses, with the cofactors."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from symcheck.core.problems import Problem
from symcheck.core.terms import Formula
from symcheck.core.verdicts import Certificate
from symcheck.proof.ideal import Fact
from symcheck.proof.knowledge import Knowledge, starting
from symcheck.proof.polynomial import Poly, Ratio, Ring


def written(cofactors: list[Fact]) -> list[list[object]]:
    """Cofactors as they stand in a certificate: those of what holds by construction are left out."""
    return [[ref, str(poly), *getattr(ref, "den", ())] for ref, poly in cofactors if ref[0] != "axiom"]


def cleared(value: Ratio) -> Certificate:
    """The denominators that a value is multiplied with before it is written as a combination of facts."""
    texts = [text for text, (_, exponent) in value.den.items() for _ in range(exponent)]
    return {"clear": texts} if texts else {}


def subsets(problem: Problem) -> Iterator[tuple[str, ...]]:
    """Names of the hypotheses that state equalities, fewest first and in declared order."""
    stating = [name for name, formulas in problem.hypotheses if any("=" in _signs(f) for f in formulas)]
    for size in range(len(stating) + 1):
        yield from combinations(stating, size)


def _signs(formula: Formula) -> set[str]:
    if formula[0] == "and":
        return set().union(*map(_signs, formula.formulas))
    return {formula.tag}


def fewest(problem: Problem, ring: Ring, poly: Poly) -> list[Fact] | None:
    """Cofactors of the polynomial over as few hypotheses as will do, or None."""
    if poly == 0:
        return []
    everything = starting(problem, ring).ideal()
    if everything.reduce(poly) != 0:
        return None
    for names in subsets(problem):
        ideal = starting(problem, ring, names).ideal()
        if (cofactors := ideal.cofactors(poly)) is not None:
            return cofactors
    return None


def prove_identity(problem: Problem, ring: Ring) -> Certificate | None:
    """The proof of an equation, or None if left - right is not in the ideal of the hypotheses."""
    gap = ring.subtract(*problem.claim[1:])
    cofactors = fewest(problem, ring, gap.num)
    return None if cofactors is None else {"rule": "identity", **cleared(gap), "cofactors": written(cofactors)}


def identity_here(goal: Formula, known: Knowledge) -> Certificate | None:
    """The same inside a larger proof, from everything known at that place."""
    gap = known.ring.subtract(*goal[1:])
    cofactors = [] if gap.num == 0 else known.ideal().cofactors(gap.num)
    return None if cofactors is None else {"rule": "identity", **cleared(gap), "cofactors": written(cofactors)}


def equations_here(goal: Formula, known: Knowledge) -> Certificate | None:
    """Equations one by one, from everything known at that place."""
    if goal.tag == "and":
        parts = []
        for part in goal.formulas:
            if (proof := equations_here(part, known)) is None:
                return None
            parts.append(proof)
        return {"rule": "each", "parts": parts}
    return identity_here(goal, known) if goal.tag == "=" else None
