"""Whether numbers in a formula may stand for quantities, as in x = 3 t^2 - 2 t with x in metres and t in seconds.

So do exercises, and laws fitted to measurements. The laws of physics have small numbers, and products of quantities.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from symcheck.core.terms import Call, Formula, Node, Term
from symcheck.dimensions.rules import Equation

LARGEST, SMOOTH = 9, (2, 3)  # factors of laws: up to 9, or products of these, such as 12 and 64


def numbers_may_measure(formulas: Sequence[Formula], conflict: Sequence[Equation]) -> bool:
    """Whether these equations of formulas would hold if some number in them measured something."""
    every = [each for formula in formulas for each in _parts(formula)]
    if not any(isinstance(each, Node) and each.tag in ("*", "/") and _quantities(each) > 1 for each in every):
        return True  # not one product of two quantities
    if any(isinstance(each, int) and not _is_of_laws(each) for each in every):
        return True
    return any(_is_open(equation) for equation in conflict)


def _parts(of: Term) -> Iterator[Term]:
    """A term or formula and all in it, but for exponents and the order of a derivative."""
    yield of
    if isinstance(of, Node):
        outside = of.outside[:1] if of.tag in ("^", "pow") else of.outside[1:] if of.tag == "diff" else of.outside
        for part in (*of.inside, *outside):
            yield from _parts(part)


def _is_of_laws(number: int) -> bool:
    rest = abs(number)
    for prime in SMOOTH:
        while rest and rest % prime == 0:
            rest //= prime
    return abs(number) <= LARGEST or rest == 1


def _is_open(equation: Equation) -> bool:
    """Does a term that does not fit have a number, or none, beside no more than one quantity?"""
    if equation.second is None:
        return _quantities(equation.first) < 2
    terms = (equation.first, equation.second)
    single = [each for each in terms if _quantities(each) < 2]
    if any(isinstance(part, int) and part not in (1, -1) for each in single for part in _parts(each)):
        return True
    return len(single) == len(terms) and any(isinstance(part, int) for each in single for part in _parts(each))


def _quantities(of: Term) -> int:
    """How many letters stand in a term, with the functions."""
    return len(
        {each.function if isinstance(each, Call) else each for each in _parts(of) if isinstance(each, str | Call)}
    )
