"""Envelopes of wheels whose axes depend on angles between 0 and 90 degrees: exact over whole ranges of the angles.

With t = tan(x/2) for each angle x every triple product is a fraction of polynomials; it is factored, and where each
factor has one t alone its zeros are isolated. Between the zeros no sign changes, so the combinatorics does not either.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from itertools import combinations, pairwise, product
from typing import Any

from symcheck.core.lazy import lazy
from symcheck.core.verdicts import SymcheckError
from symcheck.mechanics import zonotope
from symcheck.mechanics.zonotope import Combinatorics, Envelope, Vector

sp = lazy("sympy")

Interval = tuple[Any, Any]  # of t = tan(x/2): a point, with equal ends, or what lies between two


@dataclass(frozen=True)
class Piece:
    """Values of the angles over which the combinatorics is one: each angle has a value or is between two."""

    angles: tuple[Any, ...]
    intervals: tuple[Interval, ...]
    combinatorics: Combinatorics

    @property
    def fixed(self) -> dict[Any, Any]:
        """The angles that have a value here, with it."""
        return {x: angle(low) for x, (low, high) in zip(self.angles, self.intervals, strict=True) if low == high}

    @property
    def type(self) -> tuple[int, tuple[int, int, int], tuple[tuple[int, int], ...]]:
        """Dimension; numbers of vertices, edges and faces; how many faces have how many sides."""
        found = self.combinatorics
        return found.dimension, found.counts, tuple(found.sides.items())


def angle(t: Any) -> Any:
    """The angle x with tan(x/2) = t, 0 <= t <= 1."""
    return sp.pi / 2 if t == 1 else sp.atan(sp.radsimp(2 * t / (1 - t**2)))


@dataclass(frozen=True)
class Family:
    """Wheels whose axes are polynomials in sines and cosines of the angles, each between 0 and 90 degrees."""

    axes: tuple[Vector, ...]
    angles: tuple[Any, ...]
    _factored: dict[Any, tuple[int, tuple[tuple[Any, int], ...]]] = field(default_factory=dict, compare=False)
    _signs: dict[Any, int] = field(default_factory=dict, compare=False)

    def without(self, *wheels: int) -> Family:
        """The family in which these wheels have failed; the others keep their order."""
        left = tuple(axis for k, axis in enumerate(self.axes, 1) if k not in wheels)
        return Family(left, self.angles, self._factored, self._signs)

    @cached_property
    def envelope(self) -> Envelope:
        """The envelope over the open range of all angles. SymcheckError if that falls into several pieces."""
        inner = [place for place in self._places() if all(low != high for low, high in place)]
        if len(inner) > 1:
            changes = "; ".join(f"{x} = {', '.join(map(str, found))}" for x, found in self.degenerate_angles().items())
            raise SymcheckError(f"the envelope changes at {changes}; ask for its pieces")
        return zonotope.envelope(self.axes, self._sign_on(inner[0]))

    def pieces(self) -> Iterator[Piece]:
        """All pieces of the closed range: the degenerate values of the angles, and what lies between them."""
        for place in self._places():
            yield Piece(self.angles, place, zonotope.envelope(self.axes, self._sign_on(place)).combinatorics)

    def degenerate_angles(self) -> dict[Any, tuple[Any, ...]]:
        """For each angle both ends of its range, and what is between them where a triple product vanishes."""
        return {x: tuple(map(angle, self._degenerate(t))) for x, t in zip(self.angles, self._halves, strict=True)}

    def isometries(self) -> tuple[tuple[int, ...], ...]:
        """The isometries that keep the envelope whatever the angles are, as signed permutations of the wheels."""
        return zonotope.isometries(self.axes, self._identical_sign)

    def reduced(self, expression: Any) -> Any:
        """The expression with even powers of cosines written as sines, expanded."""
        for x in self.angles:
            c = sp.Symbol(f"cos({x})", real=True)
            by = sp.Poly(c**2 + sp.sin(x) ** 2 - 1, c)
            expression = sp.rem(sp.Poly(sp.expand(expression).subs(sp.cos(x), c), c), by).as_expr().subs(c, sp.cos(x))
        return sp.expand(expression)

    @cached_property
    def _halves(self) -> tuple[Any, ...]:
        return tuple(sp.Symbol(f"tan({x}/2)", real=True) for x in self.angles)

    def _places(self) -> Iterator[tuple[Interval, ...]]:
        """Where the pieces are."""
        yield from product(*(_intervals(self._degenerate(t)) for t in self._halves))

    def _identical_sign(self, expression: Any) -> int:
        """0 for what vanishes whatever the angles are; the sign of a number; 1 for all else."""
        if expression not in self._signs:
            value = self.reduced(expression)
            self._signs[expression] = zonotope.sign(value) if value.is_number else 1
        return self._signs[expression]

    def _degenerate(self, t: Any) -> list[Any]:
        """The zeros of triple products in 0 <= t <= 1, and both ends."""
        found = {sp.Integer(0), sp.Integer(1)}
        for expression in self._triple_products:
            for factor, _ in self._factors(expression)[1]:
                if factor.gen == t:
                    found |= {root for root in factor.real_roots() if 0 <= root <= 1}
        return sorted(found)

    @cached_property
    def _triple_products(self) -> list[Any]:
        """Those of the axes; where these never span space, with unit vectors that complete them."""
        for count in range(3):
            for added in combinations(zonotope.UNIT_VECTORS, count):
                triples = combinations((*self.axes, *added), 3)
                found = [
                    value for three in triples if (value := zonotope.triple_product(*three)) and self._factors(value)[0]
                ]
                if found:
                    return found
        return []

    def _factors(self, expression: Any) -> tuple[int, tuple[tuple[Any, int], ...]]:
        """(sign of the number, irreducible factors in one t each with exponents); positive factors are left out."""
        key = sp.sympify(expression)
        if key not in self._factored:
            self._factored[key] = self._factor(key)
        return self._factored[key]

    def _factor(self, expression: Any) -> tuple[int, tuple[tuple[Any, int], ...]]:
        for x, t in zip(self.angles, self._halves, strict=True):
            below = 1 + t**2
            expression = expression.subs({sp.sin(x): 2 * t / below, sp.cos(x): (1 - t**2) / below}, simultaneous=True)
        top, bottom = sp.fraction(sp.cancel(sp.together(expression), extension=True))
        if top == 0:
            return 0, ()
        sign, factors = 1, []
        for part, turn in ((top, 1), (bottom, -1)):
            poly = sp.Poly(part, *self._halves, extension=True)
            sign *= zonotope.sign(poly.LC())
            try:
                _, found = sp.factor_list(poly.monic().set_domain(sp.QQ))
            except sp.CoercionFailed:
                raise SymcheckError(f"{part} has irrational coefficients; its zeros cannot be isolated") from None
            factors += [(self._in_one_angle(each), turn * exponent) for each, exponent in found]
        return sign, tuple(factors)

    def _in_one_angle(self, factor: Any) -> Any:
        letters = sorted(factor.free_symbols, key=str)
        if len(letters) != 1:
            raise SymcheckError(f"the factor {factor.as_expr()} of a triple product joins angles; fix one of them")
        return sp.Poly(factor.as_expr(), letters[0], domain=sp.QQ)

    def _sign_on(self, intervals: tuple[Interval, ...]) -> Callable[[Any], int]:
        """The sign of an expression on a piece; SymcheckError where it is not constant there."""
        place = dict(zip(self._halves, intervals, strict=True))

        def sign_of(expression: Any) -> int:
            sign, factors = self._factors(expression)
            for factor, exponent in factors:
                sign *= _sign_between(factor, *place[factor.gen]) ** abs(exponent)
            return sign

        return sign_of


def _intervals(points: list[Any]) -> list[Interval]:
    """Points and what lies between them, in order."""
    between = [((low, low), (low, high)) for low, high in pairwise(points)]
    return [interval for pair in between for interval in pair] + [(points[-1], points[-1])]


def _sign_between(factor: Any, low: Any, high: Any) -> int:
    """The sign of an irreducible polynomial at a point, or between two, where it may have no zero."""
    roots = factor.real_roots()
    if low == high:
        return 0 if low in roots else zonotope.sign(factor.as_expr().subs(factor.gen, low).evalf())
    if any(low < root < high for root in roots):
        raise SymcheckError(f"{factor.as_expr()} changes its sign between {low} and {high}; narrow the range")
    inside = next(q for n in range(1, 99) for q in (sp.Rational(k, n + 1) for k in range(1, n + 1)) if low < q < high)
    return zonotope.sign(factor.eval(inside))
