"""Whether what fails somewhere holds elsewhere: texts rarely say that letters are positive, or count."""

from __future__ import annotations

import operator
import random
from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from symcheck.core.verdicts import SymcheckError
from symcheck.proof.algebra.polynomial import unfold
from symcheck.question.antiderivatives import FAULTS
from symcheck.question.cases import CASE
from symcheck.question.prepare import Asked, plainly, readings
from symcheck.reading import to_sympy

if TYPE_CHECKING:
    from sympy import Expr

COUNTING = frozenset("ijklmnpqNMKL")  # letters that are whole numbers in many texts
POINTS = 10  # positive numbers, large and small, that are tried for all letters together
ENOUGH = 2  # points at which it holds, that are no accident
HOLDS: dict[str, Callable[[float, float], bool]] = {  # of the signs of conditions
    "=": operator.eq, "!=": operator.ne, "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge,
}  # fmt: skip
CLOSE = 1e-9  # relative difference of sides that are equal; they are worked out to 15 digits


def holds_elsewhere(asked: Asked) -> bool | None:
    """Whether a relation holds at several positive points, whole ones where letters may count; None if it is not known.

    What holds there is no error, but a statement with a condition: the root of a square, the cosine of n pi.
    """
    try:
        sides = _sides(asked)
        points = [_at(sides, k) for k in range(POINTS)]
    except (SymcheckError, *FAULTS):
        return None
    known = [point for point in points if point is not None]
    return sum(known) >= ENOUGH if len(known) > ENOUGH else None


class Component(NamedTuple):
    """Both sides of a component, and what holds in the case of which it speaks: a sign, and what has it."""

    left: Expr
    right: Expr
    case: tuple[tuple[str, Expr], ...]


def _sides(asked: Asked) -> list[Component]:
    """Both sides of each component, with the definitions put in."""
    from sympy.core.function import AppliedUndef

    found = []
    for problem in readings(plainly(asked))[0].problems:
        definitions = dict(problem.definitions)
        left, right = (to_sympy(unfold(side, definitions)) for side in problem.claim.terms)
        if left.has(AppliedUndef) or right.has(AppliedUndef):
            raise SymcheckError("nothing is known of a function")
        stated = [f for name, formulas in problem.hypotheses if name == CASE for f in formulas]
        case = [(f.tag, [to_sympy(unfold(side, definitions)) for side in f.terms]) for f in stated]
        found.append(Component(left, right, tuple((tag, first - second) for tag, (first, second) in case)))
    return found


def _at(sides: list[Component], seed: int) -> bool | None:
    """Whether all components hold at one point of their case; None if one of them has no value there."""
    symbols = sorted({x for each in sides for side in each[:2] for x in side.free_symbols}, key=str)
    numbers = random.Random(seed)
    whole = numbers.sample(range(2, 7 + len(symbols)), len(symbols))  # different ones: equal ones are a case
    values = {
        x: n if x.name.partition("_")[0] in COUNTING else numbers.uniform(0.2, 1.0 + seed)
        for x, n in zip(symbols, whole, strict=True)
    }
    applying = [each for each in sides if all(HOLDS[sign](float(gap.subs(values)), 0.0) for sign, gap in each.case)]
    if not applying:
        return None
    for each in applying:
        left, right = (side.subs(values).evalf(15) for side in each[:2])
        if not (left.is_real and right.is_real and left.is_number and right.is_number):
            return None
        if abs(left - right) > CLOSE * max(abs(left), abs(right), 1):
            return False
    return True
