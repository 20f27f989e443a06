"""Functions that the C target writes out where a kernel needs them: what libm has not, and sin, cos, tan.

libm's sin, cos and tan do not become vector instructions, and those of glibc's vector library err by three units in
the last place, which a fourth power makes twelve. These err by 0.8, the tangent by 1.3, and have no branch; sine and
cosine of one angle take no longer than there. They are for angles up to REACH; where a point has another, its kernel
asks libm. The functions below use those above them.

Processors divide and take roots in one unit, which kernels keep busy: there the inverse of a tangent is a few products
of its own instead. A choice between two numbers that depends on an earlier choice is avoided: GCC computes all that
lies between them twice.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from symcheck.kernels.ratios import SHIFT, STIRLING

CIRCULAR = ("sin", "cos", "tan")
REACH = 1e6  # a multiple of pi/2 up to here has 20 bits, and the product with a part of 33 bits is exact
_HORNER = "\n    ".join(f"total = total * square + {x!r};" for x in STIRLING[-2::-1])
# (tan(r)/r - 1)/z at Chebyshev's points of z = r^2: tan(r) errs by 2^-55 at most by that
_TANGENT = (
    *(0.3333333333333333, 0.13333333333333, 0.05396825396865546, 0.021869488517074376, 0.00886323600348583),
    *(0.003592120980561423, 0.0014559027390518477, 0.0005895756061451823, 0.00024122635355143795),
    *(8.998520286965796e-05, 5.558784733950443e-05, -1.1013613551066105e-05, 3.651618223875854e-05),
    *(-1.831534296558283e-05, 8.483347292046082e-06),
)
# of f(x), where the square of Gamma(x + 1/2)/(Gamma(x) sqrt x) is x/(x + f(x)), from 0 to infinity
HALF_ABOVE = (
    *(0.3183098861837907, 1.3519171431967776, 2.538802307797305, 2.728160920260253),
    *(1.833535267581526, 0.7918618164397344, 0.21585978492972566, 0.0342268451382369),
    *(0.002442505603793217,),
)
HALF_UNDER = (
    *(1.0, 4.616176896679106, 9.1255141241255, 10.142846059823302),
    *(6.9785765330055405, 3.0659349068524526, 0.8467836869479071, 0.13568612775108652),
    *(0.009770022415172702,),
)


def _polynomial(name: str, of: str, coefficients: Sequence[float]) -> str:
    """A polynomial by Horner's scheme; the first coefficient is that of the power 0."""
    last, *others = reversed(coefficients)
    steps = [f"{name} = MULTIPLY_ADD({of}, {name}, {x!r});" for x in others]
    return "\n    ".join([f"double {name} = {last!r};", *steps])


FUNCTIONS = {
    "MULTIPLY_ADD": """\
#ifdef FP_FAST_FMA
#define MULTIPLY_ADD(x, y, z) fma(x, y, z)
#else
#define MULTIPLY_ADD(x, y, z) ((x) * (y) + (z))
#endif
""",
    "pair": """\
/* A number as a sum of which the second term is far smaller than the first. */
typedef struct { double high, low; } pair;
""",
    "bits_of": """\
static INLINE uint64_t bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}
""",
    "double_of": """\
static INLINE double double_of(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}
""",
    "turn": """\
/* An angle as n pi/2 and a rest between -pi/4 and pi/4; the last bits of the first number are those of n. */
typedef struct { uint64_t quarters; pair rest; } turn;
""",
    "turned": """\
/* Parts of pi/2 with 33 bits have exact products with n; fused ones are exact with 53 bits where x is near n pi/2. */
static INLINE turn turned(double x)
{
    const double shifted = MULTIPLY_ADD(x, 0x1.45f306dc9c883p-1, 0x1.8p52), n = shifted - 0x1.8p52;
#ifdef FP_FAST_FMA
    const double a = fma(-n, 0x1.921fb54442d18p+0, x);
    const double b = fma(-n, 0x1.1a626331p-54, a), b_rest = fma(-n, 0x1.1a626331p-54, a - b);
    const turn result = {bits_of(shifted), {b, fma(-n, 0x1.1701b839a252p-88, b_rest)}};
#else
    const double a = x - n * 0x1.921fb544p+0;
    const double b = a - n * 0x1.0b4611a6p-34, b_rest = (a - b) - n * 0x1.0b4611a6p-34;
    const double c = b - n * 0x1.3198a2ep-69, c_rest = (b - c) - n * 0x1.3198a2ep-69;
    const turn result = {bits_of(shifted), {c, (b_rest - n * 0x1.b839a252049c1p-104) + c_rest}};
#endif
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
    "negated": """\
/* x, or -x where a number has the bit before its last. */
static INLINE double negated(double x, uint64_t number)
{
    return double_of(bits_of(x) ^ (number & 2) << 62);
}
""",
    "vector_sin": """\
static INLINE double vector_sin(double x)
{
    const turn t = turned(x);
    const pair s = near_sin(t.rest), c = near_cos(t.rest);
    const double value = negated(t.quarters & 1 ? c.high + c.low : s.high + s.low, t.quarters);
    return x == 0.0 ? x : value; /* -0 stays -0 */
}
""",
    "vector_cos": """\
static INLINE double vector_cos(double x)
{
    const turn t = turned(x);
    const pair s = near_sin(t.rest), c = near_cos(t.rest);
    return negated(t.quarters & 1 ? s.high + s.low : c.high + c.low, t.quarters + 1);
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
    "near_inverse": """\
/* 1/x with 38 bits, of x far from the ends of the range: the bits of x taken from a constant give 1/x within 5 %, and
   each step the cube of that. */
static INLINE double near_inverse(double x)
{
    const double first = double_of(0x7fde623822fc16e6 - bits_of(x)), e = MULTIPLY_ADD(-x, first, 1.0);
    const double second = MULTIPLY_ADD(first, MULTIPLY_ADD(e, e, e), first), f = MULTIPLY_ADD(-x, second, 1.0);
    return MULTIPLY_ADD(second, MULTIPLY_ADD(f, f, f), second);
}
""",
    "vector_tan": f"""\
/* That of the angle from the nearest multiple of pi/2; from an odd multiple minus its inverse, corrected. Of the
   polynomial even and odd powers are apart, so that neither waits for the other. */
static INLINE double vector_tan(double x)
{{
    const turn t = turned(x);
    const double r = t.rest.high, z = r * r, square = z * z;
    {_polynomial("even", "square", _TANGENT[::2])}
    {_polynomial("odd", "square", _TANGENT[1::2])}
    const double low = MULTIPLY_ADD(z * r, MULTIPLY_ADD(z, odd, even), MULTIPLY_ADD(t.rest.low, z, t.rest.low));
    const double tangent = r + low, rest = (r - tangent) + low, inverse = -near_inverse(tangent);
    const double wrong = MULTIPLY_ADD(inverse, rest, remainder_of(1.0, -inverse, tangent));
    const double value = t.quarters & 1 ? MULTIPLY_ADD(inverse, wrong, inverse) : tangent;
    return x == 0.0 ? x : value;
}}
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
/* Gamma(x + 1/2)/(Gamma(x) sqrt x), likewise. Its square is x/(x + f), where f falls from 1/pi to 1/4; here f is a
   quotient of polynomials, by which the ratio errs by 2^-54 at most. */
static INLINE double gamma_ratio_of_half(double x)
{{
    const double y = x > 0x1p100 ? 0x1p100 : x;
    {_polynomial("above", "y", HALF_ABOVE)}
    {_polynomial("under", "y", HALF_UNDER)}
    under *= y;
    return x >= 4.0 * DBL_MIN ? sqrt(under / (under + above)) : NAN;
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
