"""Ratios of powers and of gamma functions, of numbers and of arrays, without loss of digits.

NumPy and `math`, and SciPy for gamma functions of arrays.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence
from functools import cache
from math import gamma, log, nan
from typing import Any, NamedTuple

import numpy as np

TINY = 2.0**-100  # below it log(1 + x) and exp(x) - 1 are x
STIRLING = tuple(p / q for p, q in ((1, 12), (-1, 360), (1, 1260), (-1, 1680), (1, 1188), (-691, 360360), (1, 156)))
NEXT = -3617 / 122400  # the next term of the series
HALF = tuple((2.0 ** (-1 - 2 * n) - 2) * c for n, c in enumerate((*STIRLING, NEXT)))
# Between these neither Gamma nor powers overflow, and their quotients have more digits than the series (measured: 10
# ulp against 32) in a tenth of the time; what x + h loses by rounding is made good by its slope, log(x + h).
LOW, HIGH = 2.0**-12, 64.0
DOUBLE = np.dtype(np.float64)
ONE = np.array(1.0)
SHIFT = 9  # from here on seven terms of Stirling's series are enough for doubles


class Numbers(NamedTuple):
    """The numbers that ratios are computed with; of arrays as arrays, since NumPy converts others in every operation.

    least  from here on x, of which (x + SHIFT)/x is no infinity, has a ratio of gamma functions
    half   the coefficients of log Gamma(x + 1/2)/(Gamma(x) sqrt x), by Bernoulli's polynomials at 1/2
    pairs  k (m - k) of the pairs of factors (x + k)(x + m - k), where m is the last
    """

    tiny: Any
    least: Any
    largest: Any
    shift: Any
    last: Any
    middle: Any
    stirling: Sequence[Any]
    half: Sequence[Any]
    pairs: Sequence[Any]


FLOATS = Numbers(
    TINY,
    4 * sys.float_info.min,
    sys.float_info.max,
    float(SHIFT),
    SHIFT - 1.0,
    (SHIFT - 1) / 2,
    STIRLING,
    HALF,
    tuple(float(k * (SHIFT - 1 - k)) for k in range(1, SHIFT // 2)),
)


def _arrays(kind: Any) -> Numbers:
    ends = np.finfo(kind)
    few = FLOATS._replace(least=4 * ends.smallest_normal, largest=ends.max)
    return Numbers._make([np.array(y, kind) for y in x] if isinstance(x, tuple) else np.array(x, kind) for x in few)


S0, S1, S2, S3, S4, S5, S6 = STIRLING
H0, H1, H2, H3, H4, H5, H6, H7 = HALF
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
    """Gamma(x + h)/(Gamma(x) x^h) for positive x and x + h: 1 at infinity; NaN for others, and for subnormal x.

    Of ordinary x and x + h it is a quotient. Where x or x + h is small otherwise the functional equation moves both up
    to where Stirling's series holds. Of the logarithms of two values there only the difference is formed,
    with what is large in it cancelled beforehand: nothing overflows unless the ratio does.
    """
    if type(x) is float is type(h):
        y = x + h
        if LOW <= x <= HIGH and LOW <= y <= HIGH:
            value = gamma(y) if x == 1.0 else gamma(y) / (gamma(x) * x**h)
            own = y - x
            lost = (x - (y - own)) + (h - own)  # x + h less y, exactly
            return value * (1.0 + lost * log(y)) if lost else value
        return _of_extreme_floats(x, h)
    y = np.add(x, h)
    if y.dtype is not DOUBLE:  # Gamma overflows early
        return _by_series(np.where((x >= ARRAYS[y.dtype].least) & (y > 0), x, np.float32(nan)), y, h, out)
    number = h.item() if not h.ndim else nan  # which takes less time to compare
    if h.ndim:
        least, most = np.minimum(x, y), np.maximum(x, y)
    else:
        least, most = (x, y) if number >= 0 else (y, x)
    if y.size and (lower := np.minimum.reduce(least, None)) >= LOW and np.maximum.reduce(most, None) <= HIGH:
        return _quotient(x, y, h, number, out, fast=number <= lower)
    positive = (x >= ARRAYS[DOUBLE].least) & (y > 0)
    extreme = positive & ((most > HIGH) | (least < LOW))
    if y.size and extreme.all():
        return _by_series(x, y, h, out)
    # Each point as if it were alone, so that its bits do not depend on its neighbours.
    one, other = (np.where(extreme, ONE, np.where(positive, each, nan)) for each in (x, y))
    value = _quotient(one, other, h, number, None)
    if extreme.any():
        given = [each if not each.ndim else np.broadcast_to(each, y.shape)[extreme] for each in (x, y, h)]
        value[extreme] = _by_series(given[0], given[1], given[2])
    return np.positive(value, out)


def _of_extreme_floats(x: float, h: float) -> float:
    """gamma_ratio(x, h) where Gamma or the power may leave the range of doubles."""
    x = min(x, 1 / TINY)  # beyond, the ratio is 1
    y = x + h
    if x < FLOATS.least or y <= 0.0:
        return nan
    if min(x, y) >= SHIFT:
        return math.exp(_logarithm_of_floats(x, h))
    moved = x + SHIFT
    rising, other = x * (x + 8.0), y * (y + 8.0)  # of pairs: (x + k)(x + 8 - k) = x (x + 8) + k (8 - k)
    above = rising * (rising + 7.0) * (rising + 12.0) * (rising + 15.0) * (x + 4.0)
    below = other * (other + 7.0) * (other + 12.0) * (other + 15.0) * (y + 4.0)
    return math.exp(_logarithm_of_floats(moved, h)) * (math.pow(moved / x, h) * above / below)


def _quotient(x: Any, y: Any, h: Any, number: float, out: Any, *, fast: bool = False) -> Any:
    """gamma_ratio(x, h) where neither Gamma nor the power leaves the range of doubles; y is x + h, rounded.

    `number` is h, if that is one; `fast` says that it is nowhere larger than x.
    """
    function = _gamma()
    value = function(y)
    if x.ndim or x.item() != 1.0:
        below = np.multiply(function(x), np.sqrt(x) if number == 0.5 else np.power(x, h))
        value = np.divide(value, below, value)
    own = np.subtract(y, x)
    lost = np.subtract(h, own, own) if fast else (x - (y - own)) + (h - own)
    lost *= np.log(y)
    lost += ONE
    return np.multiply(value, lost, out)


def _by_series(x: Any, y: Any, h: Any, out: Any = None) -> Any:
    """gamma_ratio(x, h) of any arguments; y has the shape of the result."""
    own = ARRAYS[y.dtype]
    both = np.empty((2, *y.shape), y.dtype)  # x and x + h: half as many calls
    np.minimum(x, 1 / own.tiny, out=both[0])
    np.add(both[0], h, out=both[1])
    small = np.minimum(both[0], both[1]) < own.shift
    everywhere = small.all()
    if not everywhere and not small.any():
        return np.exp(_logarithm(both, h, own), out)
    value = np.exp(_logarithm(both + own.shift if everywhere else both + own.shift * small, h, own))
    if everywhere:
        return np.multiply(value, _back(both, h, own), out)
    value *= np.where(small, _back(np.where(small, both, 1), h, own), 1)
    return np.positive(value, out)  # last, as x and h may lie in it


@cache
def _gamma() -> Any:
    """SciPy's function, which is there when it is first asked for: it takes longer to import than all kernels."""
    from scipy.special import gamma

    return gamma


def _logarithm_of_floats(x: float, h: float) -> float:
    """log gamma_ratio(x, h) for x and x + h from SHIFT on, written out: a loop takes three times as long."""
    if h == 0.5:
        i = 1.0 / x
        s = i * i
        return ((((((((H7 * s + H6) * s + H5) * s + H4) * s + H3) * s + H2) * s + H1) * s) + H0) * i
    return math.log1p(h / x) * (x + (h - 0.5)) - h + (_stirling(x + h) - _stirling(x))


def _stirling(x: float) -> float:
    i = 1.0 / x
    s = i * i
    return ((((((S6 * s + S5) * s + S4) * s + S3) * s + S2) * s + S1) * s + S0) * i


def _logarithm(both: Any, h: Any, own: Numbers) -> Any:
    """log gamma_ratio(x, h) for x and x + h from SHIFT on; for h = 1/2 the difference of two series is one itself."""
    x = both[0]
    if not h.ndim and h.item() == 0.5:
        return _series(x, own.half)
    series = _series(both, own.stirling)
    value = np.log1p(h / x)
    value *= x + (h - 0.5)
    value -= h
    value += series[1] - series[0]
    return value


def _back(both: Any, h: Any, own: Numbers) -> Any:
    """gamma_ratio(x, h) divided by the same for x + SHIFT, by the products of x + k and of x + h + k for k < SHIFT.

    These are of pairs: (x + k)(x + m - k) = x (x + m) + k (m - k).
    """
    pair = both * (both + own.last)
    rising = pair * (both + own.middle)
    for more in own.pairs:
        rising *= pair + more
    value = np.power((both[0] + own.shift) / both[0], h)
    value *= rising[0]
    value /= rising[1]
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
