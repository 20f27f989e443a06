r"""Printed numbers as roundings: `l \approx 1.95` says that l, rounded to the last printed digit, is 1.95."""

from __future__ import annotations

from fractions import Fraction

from symcheck.core.terms import PI, Formula, Term, node
from symcheck.reading.tree import Degrees, Neg, Number, Tree


def is_number(tree: Tree) -> bool:
    r"""Is this a printed number, `0.75`, `-2` or `54.7^\circ`?"""
    return isinstance(_bare(tree), Number)


def is_decimal(tree: Tree) -> bool:
    """Is this a printed number with a decimal point?"""
    number = _bare(tree)
    return isinstance(number, Number) and "." in number.text


def rounds(value: Term, tree: Tree) -> Formula:
    """The value is not farther from the printed number than half a unit of its last digit; both ends are allowed.

    So both neighbours are right of a value that lies just between them: how a half is rounded is not prescribed.
    """
    number, degrees = _bare(tree), isinstance(tree.value if isinstance(tree, Neg) else tree, Degrees)
    assert isinstance(number, Number)
    half = Fraction(1, 2 * 10 ** len(number.text.partition(".")[2]))
    middle = Fraction(number.text) * (-1 if isinstance(tree, Neg) else 1)
    low, high = (_number(end, degrees=degrees) for end in (middle - half, middle + half))
    return node("and", node("<=", low, value), node("<=", value, high))


def _bare(tree: Tree) -> Tree:
    """What stands behind the sign and before the degree sign."""
    inner = tree.value if isinstance(tree, Neg) else tree
    return inner.value if isinstance(inner, Degrees) else inner


def _number(value: Fraction, *, degrees: bool) -> Term:
    if degrees:
        top: Term = node("*", value.numerator, PI)
        return node("/", top, 180 * value.denominator)
    return value.numerator if value.denominator == 1 else node("/", value.numerator, value.denominator)
