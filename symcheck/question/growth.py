"""Inequalities of functions, by where their sides are equal and how the difference grows from there on.

`e^x >= 1 + x` holds as both sides are 1 at 0, and as the derivative of the difference is not negative to the right of 0
and not positive to the left. The sign of a derivative may be shown in the same way.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from itertools import cycle, islice

from symcheck.checker.enclosures import enclosed
from symcheck.core.calculus import Unknown, derivative, fresh, letters, nodes, substituted
from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import Binder, Connective, Formula, Malformed, Node, Relation, Term, node
from symcheck.core.verdicts import SymcheckError
from symcheck.proof.algebra.polynomial import unfold
from symcheck.question.series import FAULTS
from symcheck.reading import from_sympy, to_sympy

ARITHMETIC = ("+", "-", "*", "/", "^")
ORDERS = {"<": "rising_strictly", ">": "rising_strictly", "<=": "rising", ">=": "rising"}
PLACES: tuple[Term, ...] = (0, 1)  # where the sides of printed inequalities are equal
DEPTHS = (1, 2, 4)  # derivatives: the sine less its cubic needs three


def hinted(problem: Problem) -> Iterator[Problem]:
    """The problem with theorems about the growth of the difference of its sides, for each letter and place."""
    claim = unfold(_concluded(problem.claim), dict(problem.definitions))
    if not isinstance(claim, Relation) or claim.tag not in ORDERS:
        return
    small, large = claim.terms if claim.tag[0] == "<" else claim.terms[::-1]
    gap: Term = node("+", large, node("-", small))
    if any(isinstance(part, Binder) for part in nodes(gap)):
        return
    taken = letters(gap)
    of = [x for x in sorted(taken) if any(x in letters(part) for part in _functions(gap))]
    for depth in DEPTHS:
        for x in sorted(of, key=lambda x: len(_functions(_rate(gap, x)))):
            for place in PLACES:
                if (least := _at_least(gap, {x: place})) is not None:
                    theorem = ORDERS[claim.tag] if least == 0 else "rising"
                    hints = islice(_growing(gap, x, place, theorem, taken), 2 * depth)
                    yield replace(problem, hints=(*problem.hints, *hints))


def _concluded(claim: Formula) -> Formula:
    return claim.formulas[1] if isinstance(claim, Connective) and claim.tag == "=>" else claim


def _functions(tree: Term) -> list[Node]:
    return [part for part in nodes(tree) if part.tag not in ARITHMETIC]


def _at_least(gap: Term, at: Mapping[str, Term]) -> int | None:
    """1 where it is positive; 0 where it may be zero, as digits or other letters do not tell; otherwise None."""
    there = substituted(gap, at)
    if letters(there):
        return 0
    with suppress(Unknown, Malformed, RecursionError, ArithmeticError):
        digits = enclosed(there)
        return None if digits.high < 0 else int(digits.low > 0)
    return None


def _rate(gap: Term, x: str) -> Term:
    """The derivative, simplified where SymPy can; 0 if there is none."""
    rate: Term = 0
    with suppress(Unknown, SymcheckError, *FAULTS):
        rate = derivative(gap, x)
        rate = from_sympy(to_sympy(rate))
    return rate


def _growing(gap: Term, x: str, place: Term, theorem: str, taken: set[str]) -> Iterator[Applied[Term]]:
    """On both sides of a place, and the same of its derivatives between the place and where they are looked at.

    To the right all of them are to be positive; to the left every second one is to be negative.
    """
    end, names = x, {*taken}
    for falls in cycle((True, False)):
        z = fresh(x, names)
        names.add(z)
        for ends, of in (((place, end), gap), ((end, place), node("-", gap) if falls else gap)):
            yield Applied(theorem, ends, (((z,), substituted(of, {x: z})),))
        gap, end = _rate(gap, x), z
        if x not in letters(gap):
            return
