"""Functions that a compiler turns into vector instructions: no branch, no table, no call. Targets write them out.

Both sides of every choice are computed and one is selected. Within its range a function is near one unit of the last
place; beyond it, and for NaN, it returns NaN, and the caller asks the C library instead. The polynomials are
Chebyshev fits of the functions named in the docstrings.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

ROUND = 6755399441055744.0  # 1.5 * 2**52: added, it leaves a whole number in the last bits
FAR = 1000.0  # angles up to here are reduced with 137 bits of pi/2, in three parts
# three parts; products of the first two with n < 2^11 are exact
QUARTER, QUARTER_2, QUARTER_3 = 1.570796326794607, 2.8960739716218175e-13, 1.6446256936324258e-26
LOG2, LOG2_REST = 0.6931471803691238, 1.9082149292705877e-10  # log 2 in two parts, the first with 32 bits
INVERSE = 0x7FDE623822FC16E6  # less the bits of a number it is nearly the bits of its inverse
EXPONENT = 0x3FF0000000000000  # the bits of 1.0
ROOT_HALF = 0x3FE6A09E667F3BCD  # the bits of sqrt(1/2)
TINY = 2.0**-100  # below it log(1 + x) and exp(x) - 1 are x
SMALLEST, LARGEST = 2.2250738585072014e-308, 1.7976931348623157e308  # with all their digits
SHIFT = 9  # from here on seven terms of Stirling's series are enough for doubles


def quarters(x: float) -> tuple[np.int64, float, float]:
    """n in the last bits of a whole number, y and z with x = n pi/2 + y + z."""
    shifted = (x if abs(x) <= FAR else math.nan) * (2 / math.pi) + ROUND
    n = shifted - ROUND
    first = x - n * QUARTER
    rest = first - n * QUARTER_2
    second = n * QUARTER_3 - ((first - rest) - n * QUARTER_2)
    y = rest - second
    return np.float64(shifted).view(np.int64), y, (rest - y) - second


def sine(y: float, z: float) -> float:
    """What sin(y + z) is more than y, up to pi/4: (sin(sqrt t)/sqrt t - 1)/t."""
    t = y * y
    p = (1.5918115263265974e-10 * t - 2.505113165023518e-08) * t + 2.7557316101617874e-06
    p = ((p * t - 0.00019841269836756774) * t + 0.008333333333330948) * t - 0.16666666666666666
    return p * t * y + z * (1.0 - 0.5 * t)


def cosine(y: float, z: float) -> tuple[float, float]:
    """cos(y + z) in two parts, up to pi/4: (cos(sqrt t) - 1 + t/2)/t^2."""
    t = y * y
    p = ((-1.1382623647474604e-11 * t + 2.087614614655861e-09) * t - 2.7557317271145144e-07) * t + 2.480158729876456e-05
    p = ((p * t - 0.0013888888888887398) * t + 0.041666666666666664) * t
    half = 0.5 * t
    large = 1.0 - half
    return large, ((1.0 - large) - half) + (t * p - y * z)


def sin(x: float) -> float:
    """The sine."""
    n, y, z = quarters(x)
    large, small = cosine(y, z)
    s, c = y + sine(y, z), large + small
    value = c if n & 1 else s
    return -value if n & 2 else value


def cos(x: float) -> float:
    """The cosine."""
    n, y, z = quarters(x)
    large, small = cosine(y, z)
    s, c = y + sine(y, z), large + small
    value = s if n & 1 else c
    return -value if (n + 1) & 2 else value


def near_inverse(x: float) -> float:
    """1/x with 38 bits, in less time than a division takes: its bits taken from a constant give 1/x within 5 %."""
    first = np.uint64(np.uint64(INVERSE) - np.float64(x).view(np.uint64)).view(np.float64)
    error = 1.0 - x * first
    second = first + first * (error + error * error)
    error = 1.0 - x * second
    return second + second * (error + error * error)


def tan(x: float) -> float:
    """The tangent from the nearest multiple of pi/2, (tan(sqrt t)/sqrt t - 1)/t; from an odd one minus its inverse."""
    n, y, z = quarters(x)
    t = y * y
    s = t * t  # even and odd powers are apart, so that neither waits for the other
    even = (8.483347292046082e-06 * s + 3.651618223875854e-05) * s + 5.558784733950443e-05
    even = ((even * s + 0.00024122635355143795) * s + 0.0014559027390518477) * s + 0.00886323600348583
    even = (even * s + 0.05396825396865546) * s + 0.3333333333333333
    odd = (-1.831534296558283e-05 * s - 1.1013613551066105e-05) * s + 8.998520286965796e-05
    odd = ((odd * s + 0.0005895756061451823) * s + 0.003592120980561423) * s + 0.021869488517074376
    odd = odd * s + 0.13333333333333
    low = (odd * t + even) * (t * y) + (z * t + z)
    value = y + low
    rest = (y - value) + low
    inverse = -near_inverse(value)
    corrected = inverse + inverse * ((1.0 + inverse * value) + inverse * rest)
    return corrected if n & 1 else value


def arctan(x: float) -> float:
    """The arctangent, up to tan(pi/8) after a turn by 0, pi/4 or pi/2: (arctan(sqrt t)/sqrt t - 1)/t."""
    a = abs(x)
    large, middle = a > 2.414213562373095, a > 0.41421356237309503
    u = (-1.0 if large else a - 1.0 if middle else a) / (a if large else a + 1.0 if middle else 1.0)
    t = u * u
    p = ((-0.019175404711104935 * t + 0.03923044778479309) * t - 0.050854078345894844) * t + 0.05858140904866328
    p = ((p * t - 0.06664510525508936) * t + 0.07692183125376892) * t - 0.0909090457530649
    p = ((p * t + 0.11111111015187018) * t - 0.14285714284665682) * t + 0.19999999999995516
    p = (p * t - 0.3333333333333333) * t * u
    turn = math.pi / 2 if large else math.pi / 4 if middle else 0.0
    rest = 6.123233995736766e-17 if large else 3.061616997868383e-17 if middle else 0.0
    return math.copysign(turn + (u + (p + rest)), x)


def growth(x: float) -> tuple[float, float]:
    """g and h with exp x = g + g h, where g is a power of 2: (exp r - 1 - r)/r^2."""
    shifted = (x if abs(x) < 708.0 else math.nan) * (1 / math.log(2)) + ROUND
    n = shifted - ROUND
    first = x - n * LOG2
    second = n * LOG2_REST
    r = first - second
    p = ((2.0914686968086876e-09 * r + 2.5105217004720745e-08) * r + 2.75572736431103e-07) * r + 2.7557255400206422e-06
    p = ((p * r + 2.4801587325547743e-05) * r + 0.00019841269874820627) * r + 0.0013888888888883748
    p = ((p * r + 0.008333333333326136) * r + 0.04166666666666667) * r + 0.1666666666666667
    h = (p * r + 0.5) * r * r + ((first - r) - second)
    bits = (np.float64(shifted).view(np.int64) << 52) + EXPONENT
    return np.int64(bits).view(np.float64), r + h


def exp(x: float) -> float:
    """The exponential function."""
    g, h = growth(x)
    return g + g * h


def expm1(x: float) -> float:
    """exp x - 1 without loss of digits at 0."""
    g, h = growth(x)
    return (g - 1.0) + g * h


def logarithm(u: float, f: float, rest: float) -> float:
    """log(u + rest), where u = 1 + f unless u is far from 1: (log((1 + s)/(1 - s))/s - 2)/s^2, s = f/(2 + f)."""
    shifted = np.float64(u).view(np.int64) - ROOT_HALF
    k = shifted >> 52
    f = f if k == 0 else np.int64((shifted & 0xFFFFFFFFFFFFF) + ROOT_HALF).view(np.float64) - 1.0
    n = np.float64(k)
    s = f / (2.0 + f)
    t = s * s
    p = ((0.14616585424888623 * t + 0.15331710618210773) * t + 0.18182889455674947) * t + 0.22222211130259878
    p = ((p * t + 0.2857142862600327) * t + 0.39999999999899444) * t + 0.666666666666667
    half = 0.5 * f * f
    value = n * LOG2 - ((half - (s * (half + p * t) + (n * LOG2_REST + rest))) - f)
    return value if SMALLEST <= u <= LARGEST else math.nan  # the bits of NaN would give a number


def log(x: float) -> float:
    """The logarithm."""
    return logarithm(x, x - 1.0, 0.0)


def log1p(x: float) -> float:
    """log(1 + x) without loss of digits at 0."""
    u = 1.0 + x
    rest = (1.0 - (u - x) if x > 1.0 else x - (u - 1.0)) / u
    near = 0.7071067811865476 <= u < 1.4142135623730951
    return logarithm(u, x, 0.0 if near else rest)


def log1p_ratio(x: float, log1p: Callable[[float], float]) -> float:
    """log(1 + x)/x for x > -1, continued by 1 at 0 and by a number that is not 0 at infinity."""
    x = LARGEST if x > LARGEST else x
    ratio = log1p(x) / x
    return 1.0 if abs(x) <= TINY else ratio


def expm1_ratio(x: float, expm1: Callable[[float], float]) -> float:
    """(exp(x) - 1)/x, continued by 1 at 0."""
    ratio = expm1(x) / x
    return 1.0 if abs(x) <= TINY else ratio


def gamma_ratio(x: float, h: float) -> float:
    """Gamma(x + h)/(Gamma(x) x^h) for positive x and x + h: 1 at infinity; NaN for others, and for subnormal x.

    Where one of them is small the functional equation moves both up to where Stirling's series holds.
    """
    x = 1 / TINY if x > 1 / TINY else x if x >= 4 * SMALLEST and x + h > 0.0 else math.nan
    small = min(x, x + h) < SHIFT
    moved = x + SHIFT if small else x
    value = math.exp((moved + (h - 0.5)) * math.log1p(h / moved) - h + (stirling(moved + h) - stirling(moved)))
    if small:
        above, under = x, x + h
        for k in range(1, SHIFT):
            above, under = above * (x + k), under * (x + h + k)
        value = value * (moved / x) ** h * (above / under)
    return value


def stirling(x: float) -> float:
    """log Gamma(x) less (x - 1/2) log x - x + log(2 pi)/2, for large x."""
    inverse = 1.0 / x
    square, total = inverse * inverse, 1.0 / 156.0
    total = total * square - 691.0 / 360360.0
    total = total * square + 1.0 / 1188.0
    total = total * square - 1.0 / 1680.0
    total = total * square + 1.0 / 1260.0
    total = total * square - 1.0 / 360.0
    return (total * square + 1.0 / 12.0) * inverse


def gamma_ratio_of_half(x: float) -> float:
    """Gamma(x + 1/2)/(Gamma(x) sqrt x): its square is x/(x + f), where f, a quotient here, falls from 1/pi to 1/4."""
    y = 1 / TINY if x > 1 / TINY else x
    above = ((0.002442505603793217 * y + 0.0342268451382369) * y + 0.21585978492972566) * y + 0.7918618164397344
    above = ((above * y + 1.833535267581526) * y + 2.728160920260253) * y + 2.538802307797305
    above = (above * y + 1.3519171431967776) * y + 0.3183098861837907
    under = ((0.009770022415172702 * y + 0.13568612775108652) * y + 0.8467836869479071) * y + 3.0659349068524526
    under = ((under * y + 6.9785765330055405) * y + 10.142846059823302) * y + 9.1255141241255
    under = (under * y + 4.616176896679106) * y + 1.0
    under = under * y
    return math.sqrt(under / (under + above)) if x >= 4 * SMALLEST else math.nan
