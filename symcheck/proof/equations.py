"""Equations by ideal membership: left - right is a combination of the hypotheses, with the cofactors."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from symcheck.proof.ideal import Fact
from symcheck.proof.knowledge import Knowledge, starting
from symcheck.proof.polynomial import Poly, Ring
from symcheck.statement import Certificate, Formula, Problem


def written(cofactors: list[Fact]) -> list[list[object]]:
    """Cofactors as they stand in a certificate."""
    return [[ref, str(poly)] for ref, poly in cofactors]


def subsets(problem: Problem) -> Iterator[tuple[str, ...]]:
    """Names of the hypotheses that state equalities, fewest first and in declared order."""
    stating = [name for name, formulas in problem.hypotheses if any("=" in _signs(f) for f in formulas)]
    for size in range(len(stating) + 1):
        yield from combinations(stating, size)


def _signs(formula: Formula) -> set[str]:
    if formula[0] == "and":
        return set().union(*(_signs(part) for part in formula[1:]))
    return {formula[0]}


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
    cofactors = fewest(problem, ring, ring.difference(problem.claim))
    return None if cofactors is None else {"rule": "identity", "cofactors": written(cofactors)}


def identity_here(goal: Formula, known: Knowledge) -> Certificate | None:
    """The same inside a larger proof, from everything known at that place."""
    poly = known.ring.difference(goal)
    cofactors = [] if poly == 0 else known.ideal().cofactors(poly)
    return None if cofactors is None else {"rule": "identity", "cofactors": written(cofactors)}
