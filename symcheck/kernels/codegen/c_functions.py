"""Functions that the C target writes out where a kernel needs them: what libm has not, and sin, cos, tan.

libm's sin, cos and tan do not become vector instructions, and those of glibc's vector library err by three units in
the last place, which a fourth power makes twelve. These err by 0.8, the tangent by 1.3, and have no branch; sine and
cosine of one angle take no longer than there. They are for angles up to REACH; where a point has another, its kernel
asks libm. The functions below use those above them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from symcheck.kernels.ratios import HALF, SHIFT, STIRLING

CIRCULAR = ("sin", "cos", "tan")
REACH = 1e6  # a multiple of pi/2 up to here has 20 bits, and the product with a part of 33 bits is exact
_HORNER = "\n    ".join(f"total = total * square + {x!r};" for x in STIRLING[-2::-1])
_HORNER_OF_HALF = "\n    ".join(f"total = total * square + {x!r};" for x in HALF[-2::-1])

FUNCTIONS = {
    "MULTIPLY_ADD": """\
#ifdef FP_FAST_FMA
#define MULTIPLY_ADD(x, y, z) fma(x, y, z)
#else
#define MULTIPLY_ADD(x, y, z) ((x) * (y) + (z))
#endif
""",
    "turns": """\
/* The whole number nearest to x y, up to 2^51: there a double has no digits left behind the point. */
static INLINE double turns(double x, double y)
{
    return MULTIPLY_ADD(x, y, 0x1.8p52) - 0x1.8p52;
}
""",
    "pair": """\
/* A number as a sum of which the second term is far smaller than the first. */
typedef struct { double high, low; } pair;
""",
    "turned": """\
/* x - n pi/2: of the parts of pi/2 the first three have 33 bits, so that their products with n are exact. */
static INLINE pair turned(double x, double n)
{
    const double a = MULTIPLY_ADD(-n, 0x1.921fb544p+0, x);
    const double b = MULTIPLY_ADD(-n, 0x1.0b4611a6p-34, a), b_rest = MULTIPLY_ADD(-n, 0x1.0b4611a6p-34, a - b);
    const double c = MULTIPLY_ADD(-n, 0x1.3198a2ep-69, b), c_rest = MULTIPLY_ADD(-n, 0x1.3198a2ep-69, b - c);
    const pair result = {c, MULTIPLY_ADD(-n, 0x1.b839a252049c1p-104, b_rest) + c_rest};
    return result;
}
""",
    "near_sin": """\
/* The sine of an angle between -pi/4 and pi/4; the polynomials here and below are those of Sun's fdlibm. */
static INLINE pair near_sin(pair x)
{
    const double z = x.high * x.high;
    double p = MULTIPLY_ADD(z, 1.58969099521155010221e-10, -2.50507602534068634195e-08);
    p = MULTIPLY_ADD(z, p, 2.75573137070700676789e-06);
    p = MULTIPLY_ADD(z, p, -1.98412698298579493134e-04);
    p = MULTIPLY_ADD(z, p, 8.33333333332248946124e-03);
    p = MULTIPLY_ADD(z, p, -1.66666666666666324348e-01);
    const pair result = {x.high, MULTIPLY_ADD(z * x.high, p, x.low * MULTIPLY_ADD(-0.5, z, 1.0))};
    return result;
}
""",
    "near_cos": """\
/* The cosine of such an angle. */
static INLINE pair near_cos(pair x)
{
    const double z = x.high * x.high, half = 0.5 * z, high = 1.0 - half;
    double p = MULTIPLY_ADD(z, -1.13596475577881948265e-11, 2.08757232129817482790e-09);
    p = MULTIPLY_ADD(z, p, -2.75573143513906633035e-07);
    p = MULTIPLY_ADD(z, p, 2.48015872894767294178e-05);
    p = MULTIPLY_ADD(z, p, -1.38888888888741095749e-03);
    p = MULTIPLY_ADD(z, p, 4.16666666666666019037e-02);
    const pair result = {high, ((1.0 - high) - half) + MULTIPLY_ADD(z * z, p, -(x.high * x.low))};
    return result;
}
""",
    "vector_sin": """\
static INLINE double vector_sin(double x)
{
    const double n = turns(x, 0x1.45f306dc9c883p-1), quarter = MULTIPLY_ADD(-4.0, turns(n, 0.25), n); /* -2 to 2 */
    const pair turn = turned(x, n), s = near_sin(turn), c = near_cos(turn);
    const double size = fabs(quarter) == 1.0 ? c.high + c.low : s.high + s.low;
    const double value = fabs(quarter) == 2.0 || quarter == -1.0 ? -size : size;
    return x == 0.0 ? x : value; /* -0 stays -0 */
}
""",
    "vector_cos": """\
static INLINE double vector_cos(double x)
{
    const double n = turns(x, 0x1.45f306dc9c883p-1), quarter = MULTIPLY_ADD(-4.0, turns(n, 0.25), n);
    const pair turn = turned(x, n), s = near_sin(turn), c = near_cos(turn);
    const double size = fabs(quarter) == 1.0 ? s.high + s.low : c.high + c.low;
    return fabs(quarter) == 2.0 || quarter == 1.0 ? -size : size;
}
""",
    "remainder_of": """\
/* x - q y, exact: halves of the digits are multiplied where there is no fused multiplication. */
static INLINE double remainder_of(double x, double q, double y)
{
#ifdef FP_FAST_FMA
    return fma(-q, y, x);
#else
    const double p = q * 134217729.0, a = p - (p - q), b = q - a;
    const double r = y * 134217729.0, c = r - (r - y), d = y - c;
    return ((x - a * c) - a * d - b * c) - b * d;
#endif
}
""",
    "vector_tan": """\
/* That of the angle from the nearest multiple of pi/2; from an odd multiple minus its inverse, corrected. The
   polynomial interpolates (tan(r)/r - 1)/z, z = r^2, at Chebyshev's points; tan(r) errs by 2^-55 at most by that. */
static INLINE double vector_tan(double x)
{
    const double n = turns(x, 0x1.45f306dc9c883p-1);
    const pair turn = turned(x, n);
    const double z = turn.high * turn.high;
    double p = MULTIPLY_ADD(z, 8.483347292046082e-06, -1.831534296558283e-05);
    p = MULTIPLY_ADD(z, p, 3.651618223875854e-05);
    p = MULTIPLY_ADD(z, p, -1.1013613551066105e-05);
    p = MULTIPLY_ADD(z, p, 5.558784733950443e-05);
    p = MULTIPLY_ADD(z, p, 8.998520286965796e-05);
    p = MULTIPLY_ADD(z, p, 0.00024122635355143795);
    p = MULTIPLY_ADD(z, p, 0.0005895756061451823);
    p = MULTIPLY_ADD(z, p, 0.0014559027390518477);
    p = MULTIPLY_ADD(z, p, 0.003592120980561423);
    p = MULTIPLY_ADD(z, p, 0.00886323600348583);
    p = MULTIPLY_ADD(z, p, 0.021869488517074376);
    p = MULTIPLY_ADD(z, p, 0.05396825396865546);
    p = MULTIPLY_ADD(z, p, 0.13333333333333);
    p = MULTIPLY_ADD(z, p, 0.3333333333333333);
    const double low = MULTIPLY_ADD(z * turn.high, p, MULTIPLY_ADD(turn.low, z, turn.low));
    const double tangent = turn.high + low, rest = (turn.high - tangent) + low, inverse = -1.0 / tangent;
    const double wrong = MULTIPLY_ADD(inverse, rest, remainder_of(1.0, -inverse, tangent));
    const double value = n == 2.0 * turns(n, 0.5) ? tangent : MULTIPLY_ADD(inverse, wrong, inverse);
    return x == 0.0 ? x : value;
}
""",
    "log1p_ratio": """\
/* log(1 + x)/x for x > -1, continued by 1 at 0 and by a number that is not 0 at infinity. */
static INLINE double log1p_ratio(double x)
{
    const double finite = x > DBL_MAX ? DBL_MAX : x, ratio = log1p(finite) / finite;
    return fabs(x) < 0x1p-100 ? 1.0 : ratio;
}
""",
    "expm1_ratio": """\
/* (exp(x) - 1)/x, continued by 1 at 0. */
static INLINE double expm1_ratio(double x)
{
    const double ratio = expm1(x) / x;
    return fabs(x) < 0x1p-100 ? 1.0 : ratio;
}
""",
    "stirling": f"""\
/* log Gamma(x) less (x - 1/2) log x - x + log(2 pi)/2, for large x. */
static INLINE double stirling(double x)
{{
    const double inverse = 1.0 / x, square = inverse * inverse;
    double total = {STIRLING[-1]!r};
    {_HORNER}
    return total * inverse;
}}
""",
    "gamma_ratio": f"""\
/* Gamma(x + h)/(Gamma(x) x^h) for positive x and x + h: 1 at infinity; NaN for others, and for subnormal x. Where x or
   x + h is small the functional equation moves both up by {SHIFT}, to where Stirling's series holds; of two logarithms
   the difference is formed. */
static INLINE double gamma_ratio(double x, double h)
{{
    const double y = x > 0x1p100 ? 0x1p100 : x >= 4.0 * DBL_MIN && x + h > 0.0 ? x : NAN; /* beyond, the ratio is 1 */
    const int small = y < {SHIFT}.0 || y + h < {SHIFT}.0;
    const double moved = small ? y + {SHIFT}.0 : y;
    const double logarithm = (moved + (h - 0.5)) * log1p(h / moved) - h + (stirling(moved + h) - stirling(moved));
    const double value = exp(logarithm);
    double above = y, under = y + h;
    for (int k = 1; k < {SHIFT}; ++k) {{
        above *= y + k;
        under *= y + h + k;
    }}
    const double lifted = value * (pow(moved / y, h) * (above / under));
    return small ? lifted : value;
}}
""",
    "gamma_ratio_of_half": f"""\
/* Gamma(x + 1/2)/(Gamma(x) sqrt x), likewise: the difference of two series is one itself; of exp, as what it is of is
   1/72 at most, eight terms are enough. The factors are of pairs, (x + k)(x + 8 - k) = x (x + 8) + k (8 - k). */
static INLINE double gamma_ratio_of_half(double x)
{{
    const double y = x > 0x1p100 ? 0x1p100 : x >= 4.0 * DBL_MIN ? x : NAN, z = y + 0.5;
    const double moved = y < {SHIFT}.0 ? y + {SHIFT}.0 : y, p = y * (y + 8.0), q = z * (z + 8.0);
    const double above = (p + 7.0) * ((p + 12.0) * (p + 15.0)) * ((y + 4.0) * (y + 8.0)); /* less the factor y */
    const double under = q * (q + 7.0) * ((q + 12.0) * (q + 15.0)) * (z + 4.0), both = 1.0 / (moved * under);
    const double inverse = both * under, square = inverse * inverse;
    double total = {HALF[-1]!r}, value = 1.0 / 40320.0;
    {_HORNER_OF_HALF}
    total *= inverse;
    value = ((value * total + 1.0 / 5040.0) * total + 1.0 / 720.0) * total + 1.0 / 120.0;
    value = ((value * total + 1.0 / 24.0) * total + 1.0 / 6.0) * total + 0.5;
    value = (value * total + 1.0) * total + 1.0;
    const double lifted = value * (sqrt(moved * y) * above) * (both * moved);
    return y < {SHIFT}.0 ? lifted : value;
}}
""",
}


def written(text: str) -> Iterator[str]:
    """The functions that a text needs, those that others call before these."""
    needed: list[str] = []
    for name, function in reversed(FUNCTIONS.items()):
        if re.search(rf"\b{name}\b", text):
            text += function
            needed.append(function)
    return reversed(needed)
