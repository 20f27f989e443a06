"""Equations by ideal membership: left - right is a combination of the facts, with the cofactors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from math import prod
from typing import ClassVar

from symcheck.core.problems import Problem
from symcheck.core.terms import Formula
from symcheck.proof.algebra.facts import Fact, Nonzero, merged
from symcheck.proof.algebra.flint import Poly, occurring
from symcheck.proof.algebra.knowledge import Knowledge, proportional, starting
from symcheck.proof.algebra.linear import combined
from symcheck.proof.algebra.place import Place
from symcheck.proof.algebra.polynomial import Ring
from symcheck.proof.algebra.products import nonzero
from symcheck.proof.rules.each import all_of
from symcheck.proof.rules.step import Cofactor, Factor, Step, cleared, combination

MANY = 9  # equations, such as those of a matrix: a basis of all of them takes longer than a combination with numbers
MANY_ADDENDS = 20  # of a difference that is multiplied with what is not zero: that of long ones takes long to reduce


@dataclass(frozen=True)
class Identity(Step):
    """l = r: the difference, times what is not zero, is a combination of facts."""

    rule: ClassVar[str] = "identity"
    optional: ClassVar[tuple[str, ...]] = ("times",)
    times: tuple[Factor, ...] = ()
    cofactors: tuple[Cofactor, ...] = ()


def prove_identity(problem: Problem, ring: Ring) -> Identity | None:
    """The proof of an equation over as few hypotheses as will do."""
    gap = ring.subtract(*problem.claim.terms)
    cofactors = [] if gap.num == 0 else fewest(gap.num, starting(problem, ring), problem)
    return None if cofactors is None else Identity(cleared(gap), combination(cofactors))


def fewest(poly: Poly, known: Knowledge, problem: Problem) -> list[Fact] | None:
    """Cofactors of a polynomial over as few hypotheses of a problem as will do, or None."""
    if len(known.facts) >= MANY and (few := combined(poly, known.facts, known.ring)) is not None:
        return few
    if known.ideal().reduce(poly) != 0:
        return None
    stating = [name for name, formulas in problem.hypotheses if any(map(_states_equation, formulas))]
    smaller = (names for size in range(len(stating) + 1) for names in combinations(stating, size))
    found = (starting(problem, known.ring, names).ideal().cofactors(poly) for names in smaller)
    return next((cofactors for cofactors in found if cofactors is not None), None)


def _states_equation(formula: Formula) -> bool:
    return any(map(_states_equation, formula.formulas)) if formula.tag == "and" else formula.tag == "="


def identity_here(goal: Formula, known: Knowledge) -> Identity | None:
    """The same inside a larger proof, from everything known at that place."""
    gap = known.ring.subtract(*goal.terms)
    cofactors = [] if gap.num == 0 else known.ideal().cofactors(gap.num)
    return None if cofactors is None else Identity(cleared(gap), combination(cofactors))


def equations_here(goal: Formula, known: Knowledge) -> Step | None:
    """Equations one by one, from everything known at that place."""
    if goal.tag == "and":
        return all_of(goal, known, equations_here)
    return identity_here(goal, known) if goal.tag == "=" else None


def identity_at(goal: Formula, place: Place) -> Identity | None:
    """The same at a place of a search, by way of a hinted form where that helps."""
    gap = place.known.ring.subtract(*goal.terms)
    cofactors = _through_form(gap.num, place) or place.cofactors(gap.num)
    return None if cofactors is None else Identity(cleared(gap), combination(cofactors))


def identity_times(goal: Formula, place: Place) -> Identity | None:
    """The same for the difference times what is known not to be zero, which no basis divides out by itself."""
    known = place.known
    gap = known.ring.subtract(*goal.terms)
    if len(known.facts) < 2 or len(gap.num) > MANY_ADDENDS:
        return None
    occurring_ = sorted(set().union(*(occurring(poly) for _, poly in known.facts)))
    letters = [nonzero(known.ring.generator[x], known) for x in occurring_]
    factors = [(ground, poly) for ground, poly in letters if ground is not None]
    factors += [(ref, poly) for ref, poly in known.conditions if len(poly) > 1]
    if not 0 < len(factors) <= MANY:
        return None

    def is_zero(kept: Sequence[tuple[Nonzero, Poly]]) -> bool:
        return place.ideal.reduce(prod((poly for _, poly in kept), start=gap.num)) == 0

    for kept in (factors, [*factors, *factors]):
        if is_zero(kept):
            for each in factors * (len(kept) // len(factors)):
                fewer = [*kept]
                fewer.remove(each)
                kept = fewer if is_zero(fewer) else kept
            cofactors = place.ideal.cofactors(prod((poly for _, poly in kept), start=gap.num))
            times = (*cleared(gap), *(ground for ground, _ in kept))
            return None if cofactors is None else Identity(times, combination(cofactors))
    return None


def _through_form(gap: Poly, place: Place) -> list[Fact] | None:
    """left - right is a multiple of a hinted form by linear combination, and the form is zero here."""
    for form in place.forms:
        ratio = place.known.ring.ratio(form)
        if ratio.den or (inner := place.of_term(form)) is None:
            continue
        for factor in (proportional(place.normal(gap), place.normal(ratio.num)) or 1, -1):
            multiple = place.known.ring.number(factor)
            outer = place.cofactors(gap - ratio.num * multiple)
            if outer is not None:
                return merged([*outer, *((ref, q * multiple) for ref, q in inner)])
    return None
