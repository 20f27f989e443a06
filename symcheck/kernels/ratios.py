"""Ratios of powers and of gamma functions, of numbers and of arrays, without loss of digits. NumPy and `math` alone."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

TINY = 2.0**-100  # below it log(1 + x) and exp(x) - 1 are x
STIRLING = tuple(p / q for p, q in ((1, 12), (-1, 360), (1, 1260), (-1, 1680), (1, 1188), (-691, 360360), (1, 156)))
NEXT = -3617 / 122400  # the next term of the series
SHIFT = 9  # from here on seven terms of Stirling's series are enough for doubles


class Numbers(NamedTuple):
    """The numbers that ratios are computed with; of arrays as arrays, since NumPy converts others in every operation.

    half   the coefficients of log Gamma(x + 1/2)/(Gamma(x) sqrt x), by Bernoulli's polynomials at 1/2
    pairs  k (m - k) of the pairs of factors (x + k)(x + m - k), where m is the last
    """

    tiny: Any
    largest: Any
    shift: Any
    last: Any
    middle: Any
    stirling: Sequence[Any]
    half: Sequence[Any]
    pairs: Sequence[Any]


FLOATS = Numbers(
    TINY,
    sys.float_info.max,
    float(SHIFT),
    SHIFT - 1.0,
    (SHIFT - 1) / 2,
    STIRLING,
    tuple((2.0 ** (-1 - 2 * n) - 2) * c for n, c in enumerate((*STIRLING, NEXT))),
    tuple(float(k * (SHIFT - 1 - k)) for k in range(1, SHIFT // 2)),
)


def _arrays(kind: Any) -> Numbers:
    few = FLOATS._replace(largest=np.finfo(kind).max)
    return Numbers._make([np.array(y, kind) for y in x] if isinstance(x, tuple) else np.array(x, kind) for x in few)


ARRAYS = {np.dtype(kind): _arrays(kind) for kind in (np.float32, np.float64)}


def log1p_ratio(x: Any, out: Any = None) -> Any:
    """log(1 + x)/x for x > -1, continued by 1 at 0 and by a number that is not 0 at infinity."""
    if type(x) is float:
        x = min(x, FLOATS.largest)
        return math.log1p(x) / x if abs(x) > TINY else 1.0
    own = ARRAYS[x.dtype]
    x = _away_from_zero(x, own.tiny)
    np.minimum(x, own.largest, out=x)
    return np.divide(np.log1p(x), x, out)


def expm1_ratio(x: Any, out: Any = None) -> Any:
    """(exp(x) - 1)/x, continued by 1 at 0."""
    if type(x) is float:
        return math.expm1(x) / x if abs(x) > TINY else 1.0
    x = _away_from_zero(x, ARRAYS[x.dtype].tiny)
    return np.divide(np.expm1(x), x, out)


def _away_from_zero(x: Any, tiny: Any) -> Any:
    size = np.abs(x)
    np.maximum(size, tiny, out=size)
    return np.copysign(size, x, size)


def gamma_ratio(x: Any, h: Any, out: Any = None) -> Any:
    """Gamma(x + h)/(Gamma(x) x^h) for positive x and x + h: 1 at infinity.

    Where x or x + h is small the functional equation moves both up to where Stirling's series holds. Of the logarithms
    of two values there only the difference is formed, with what is large in it cancelled beforehand: nothing overflows
    unless the ratio does.
    """
    if type(x) is type(h) is float:
        x = min(x, 1 / TINY)  # beyond, the ratio is 1
        logarithm: Callable[..., Any] = _half if h == 0.5 else _logarithm
        if min(x, x + h) >= SHIFT:
            return math.exp(logarithm(x, h, math.log1p, FLOATS))
        return math.exp(logarithm(x + SHIFT, h, math.log1p, FLOATS)) * _back(x, h, math.pow, FLOATS)
    own = ARRAYS[np.result_type(x, h)]
    x = np.minimum(x, 1 / own.tiny)
    logarithm = _half if h.ndim == 0 and h == 0.5 else _logarithm
    small = np.minimum(x, x + h) < own.shift
    everywhere = small.all()
    value = np.exp(logarithm(x + own.shift if everywhere else x + own.shift * small, h, np.log1p, own))
    if everywhere:
        return np.multiply(value, _back(x, h, np.power, own), out)
    if small.any():
        value *= np.where(small, _back(np.where(small, x, 1), h, np.power, own), 1)
    return np.positive(value, out)  # last, as x and h may lie in it


def _logarithm(x: Any, h: Any, log1p: Any, own: Numbers) -> Any:
    """log gamma_ratio(x, h) for x and x + h from SHIFT on."""
    value = log1p(h / x)
    value *= x + (h - 0.5)
    value -= h
    value += _series(x + h, own.stirling) - _series(x, own.stirling)
    return value


def _half(x: Any, h: Any, log1p: Any, own: Numbers) -> Any:
    """The same for h = 1/2, where the difference is a series itself."""
    return _series(x, own.half)


def _back(x: Any, h: Any, power: Any, own: Numbers) -> Any:
    """gamma_ratio(x, h) divided by the same for x + SHIFT."""
    value = power((x + own.shift) / x, h)
    value *= _rising(x, own)
    value /= _rising(x + h, own)
    return value


def _rising(x: Any, own: Numbers) -> Any:
    """x (x + 1)...(x + SHIFT - 1), of pairs: (x + k)(x + m - k) = x (x + m) + k (m - k)."""
    pair = x * (x + own.last)
    value = pair * (x + own.middle)
    for more in own.pairs:
        value *= pair + more
    return value


def _series(x: Any, coefficients: Sequence[Any]) -> Any:
    """The sum of c_n/x^(2n + 1). With STIRLING: log Gamma(x) less (x - 1/2) log x - x + log(2 pi)/2, for large x."""
    inverse = 1.0 / x
    square = inverse * inverse
    total = coefficients[-1] * square
    for coefficient in coefficients[-2:0:-1]:
        total += coefficient
        total *= square
    total += coefficients[0]
    total *= inverse
    return total
