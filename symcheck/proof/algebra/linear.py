"""Combinations of facts with numbers for cofactors, up to what holds of roots, sines and cosines by construction.

They need no Groebner basis of all facts, which takes minutes where there are dozens of equations in dozens of letters.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TypeVar

from symcheck.proof.algebra.facts import Fact, by_construction
from symcheck.proof.algebra.flint import Poly, fraction
from symcheck.proof.algebra.ideal import Ideal
from symcheck.proof.algebra.polynomial import Ring

K = TypeVar("K")
Row = dict[object, Fraction]
MOST_TERMS = 20_000  # of all facts together; dense elimination of more takes seconds


def combined(poly: Poly, facts: Sequence[Fact], ring: Ring) -> list[Fact] | None:
    """Cofactors of a polynomial over facts, or None if no combination with numbers is found."""
    axioms = ring.remembered("axioms", lambda: Ideal(ring, by_construction(ring)))
    known = [(ref, q) for ref, q in facts if q != 0]
    if sum(len(q) for _, q in known) > MOST_TERMS:
        return None
    numbers = _solved(_row(axioms.reduce(poly)), [_row(axioms.reduce(q)) for _, q in known])
    if numbers is None:
        return None
    rest = poly
    used = [(ref, q, ring.number(number)) for (ref, q), number in zip(known, numbers, strict=True) if number]
    for _, q, number in used:
        rest = rest - q * number
    outer = axioms.cofactors(rest)
    return None if outer is None else [*outer, *((ref, number) for ref, _, number in used)]


def _row(poly: Poly) -> Row:
    return {tuple(map(int, exponents)): fraction(coefficient) for exponents, coefficient in poly.terms()}


def _solved(target: Row, rows: Sequence[Row]) -> list[Fraction] | None:
    """Numbers by which rows are multiplied to add up to the target."""
    pivots: list[tuple[object, Row, dict[int, Fraction]]] = []  # a column, a row, and how it is made of those given

    def reduced(row: Row, made: dict[int, Fraction]) -> tuple[Row, dict[int, Fraction]]:
        for column, pivot, of in pivots:
            if factor := row.get(column):
                row, made = _less(row, factor, pivot), _less(made, factor, of)
        return row, made

    for k, given in enumerate(rows):
        row, made = reduced(given, {k: Fraction(1)})
        if row:
            column, lead = next(iter(row.items()))
            pivots.append((column, {x: c / lead for x, c in row.items()}, {n: c / lead for n, c in made.items()}))
    left, made = reduced(target, {})
    return None if left else [-made.get(k, Fraction(0)) for k in range(len(rows))]


def _less(row: Mapping[K, Fraction], factor: Fraction, other: Mapping[K, Fraction]) -> dict[K, Fraction]:
    """row - factor * other, without zeros."""
    new = dict(row)
    for x, c in other.items():
        value = new.pop(x, Fraction(0)) - factor * c
        if value:
            new[x] = value
    return new
