"""Points of a kernel's domain: spread over it, or crowding its ends."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache

import numpy as np
import sympy as sp

from symcheck.kernels.codegen.kernel import Argument, Kernel
from symcheck.kernels.runtime import Array

Columns = tuple[Array, ...]  # an array of doubles for each argument
End = float | Array  # of a domain: the same at all points, or another argument's

ORDINARY = 3.0  # decades about 1 that random points of an unbounded domain fill
CROWD = 300  # points crowd a place as closely as 10^-300


def random_points(kernel: Kernel, count: int, rng: np.random.Generator, decades: float = ORDINARY) -> Columns:
    """Points spread over the domain, where it is unbounded over some decades about 1."""
    return _sampled(kernel, lambda argument, low, high: _spread(low, high, count, rng, decades))


def crowded_points(kernel: Kernel, count: int, rng: np.random.Generator) -> Columns:
    """Points at which some arguments crowd an end of their domain, as closely as doubles do, or one another."""
    names = [argument.name for argument in kernel.arguments]
    columns = dict(zip(names, random_points(kernel, count, rng), strict=True))

    def moved(argument: Argument, low: End, high: End) -> Array:
        column, kind = _spread(low, high, count, rng), rng.integers(0, 4, count)
        column = np.where(kind == 2, _near_an_end(argument, low, high, count, rng), column)
        comparable = [each.name for each in kernel.arguments if each.unit == argument.unit and each.name in columns]
        other = columns[str(rng.choice(comparable))] * (1 + _closely(count, rng) * rng.choice([-1, 0, 1], count))
        columns[argument.name] = np.where(kind == 3, _inside(argument, other, low, high), column)
        return columns[argument.name]

    return _sampled(kernel, moved)


def inside(kernel: Kernel, points: Columns) -> Array:
    """Which points lie in the domain."""
    columns = dict(zip((argument.name for argument in kernel.arguments), points, strict=True))
    found = np.ones(points[0].shape, bool)
    for argument in kernel.arguments:
        low, high = _ends(argument, columns)
        column = columns[argument.name]
        found &= np.isfinite(column) & (_inside(argument, column, low, high) == column)
    return found


def _sampled(kernel: Kernel, sample: Callable[[Argument, End, End], Array]) -> Columns:
    """A column for each argument; those whose ends are other arguments come after these."""
    columns: dict[str, Array] = {}
    waiting = list(kernel.arguments)
    while waiting:
        argument = waiting.pop(0)
        if not all({*_letters(end)} <= columns.keys() for end in (argument.low, argument.high)):
            waiting.append(argument)
            continue
        low, high = _ends(argument, columns)
        columns[argument.name] = _inside(argument, sample(argument, low, high), low, high)
    return tuple(columns[argument.name] for argument in kernel.arguments)


def _ends(argument: Argument, columns: dict[str, Array]) -> tuple[End, End]:
    """The ends of a domain, infinite where there is none."""
    low, high = (
        _function(end)(*(columns[letter] for letter in _letters(end))) if end else infinite
        for end, infinite in ((argument.low, -np.inf), (argument.high, np.inf))
    )
    return low, high


@cache
def _letters(end: str) -> list[str]:
    """The arguments that an end depends on."""
    return sorted(letter.name for letter in sp.sympify(end).free_symbols) if end else []


@cache
def _function(end: str) -> Callable[..., End]:
    """An end as a function of the arguments it depends on."""
    function: Callable[..., End] = sp.lambdify(_letters(end), sp.sympify(end), "numpy")
    return function


def _inside(argument: Argument, column: Array, low: End, high: End) -> Array:
    """A column, moved into the domain where it is not: an open end itself is not in it, the double below pi/2 is."""
    first, last = low, high
    if not argument.closed:
        first = low if _rounded(argument.low) > 0 else _next(low, np.inf)
        last = high if _rounded(argument.high) < 0 else _next(high, -np.inf)
    return np.clip(column, first, last)


def _next(end: End, towards: float) -> Array:
    """The next number; next to 0 the nearest one that crowds it, since closer doubles have fewer digits."""
    return np.where(end == 0, np.copysign(10.0**-CROWD, towards), np.nextafter(end, towards))


@cache
def _rounded(end: str) -> int:
    """The sign of what rounding did to an end, 0 for other arguments."""
    exact = sp.sympify(end) if end else sp.oo
    if not (exact.is_number and exact.is_finite):
        return 0
    return int(sp.sign(sp.Rational(float(exact)) - exact))


def _spread(low: End, high: End, count: int, rng: np.random.Generator, decades: float = ORDINARY) -> Array:
    """Evenly between two ends, else evenly in the logarithm of the distance from the one end or from zero."""
    far = 10 ** rng.uniform(-decades, decades, count)
    if np.all(np.isfinite(low)) and np.all(np.isfinite(high)):
        return low + (high - low) * rng.random(count)
    if np.all(np.isfinite(low)):
        return low + far
    return high - far if np.all(np.isfinite(high)) else far * rng.choice([-1, 1], count)


def _near_an_end(argument: Argument, low: End, high: End, count: int, rng: np.random.Generator) -> Array:
    """Close to an end, or to zero where there is none, or to a quarter turn."""
    near = _closely(count, rng)
    if np.isinf(low).all() and np.isinf(high).all():
        turns = rng.integers(-4, 5, count) if argument.unit == "rad" else np.zeros(count)
        beside: Array = turns * (math.pi / 2) + near * rng.choice([-1, 1], count)
        return beside
    from_low = np.isinf(high) | (rng.random(count) < 0.5) & ~np.isinf(low)
    return np.where(from_low, np.where(np.isinf(low), 0, low) + near, np.where(np.isinf(high), 0, high) - near)


def _closely(count: int, rng: np.random.Generator) -> Array:
    """10^-k for k from 1 to 300; half of them within the digits of a double."""
    powers = rng.permutation(np.resize(np.arange(1, CROWD + 1), count))
    return 10.0 ** -np.where(rng.random(count) < 0.5, 1 + powers % 17, powers)
