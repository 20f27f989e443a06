"""Kernels of mirer2009. Written by `symcheck generate`: what is changed here is lost."""

from math import atan, cos, sin, sqrt, tan

from symcheck.kernels.runtime import Argument, Output, kernel

__all__ = [
    "axial_moments",
    "bound_at_given_moment",
    "bounds_of_products",
    "characteristic_coefficients",
    "characteristic_coefficients_at_common_ratio",
    "damping_matrix",
    "direction_cosines",
    "distances_from_bounds",
    "equal_moment_pitch",
    "gain_of_rates",
    "gains_in_proportion",
    "product_of_axial_moments",
    "product_of_two_axial_moments",
    "product_with_second_moment",
    "second_order_moments",
    "stability_degree_in_pitch",
    "sum_of_products",
]


@kernel(
    Argument("alpha", "pitch", "rad"),
    Argument("beta", "yaw", "rad"),
    Argument("gamma", "roll", "rad"),
    Output("a_11", "cosine between axis 1 and principal axis 1"),
    Output("a_12", "cosine between axis 1 and principal axis 2"),
    Output("a_13", "cosine between axis 1 and principal axis 3"),
    Output("a_21", "cosine between axis 2 and principal axis 1"),
    Output("a_22", "cosine between axis 2 and principal axis 2"),
    Output("a_23", "cosine between axis 2 and principal axis 3"),
    Output("a_31", "cosine between axis 3 and principal axis 1"),
    Output("a_32", "cosine between axis 3 and principal axis 2"),
    Output("a_33", "cosine between axis 3 and principal axis 3"),
    ulp=6,
    condition="Where terms cancel, the error is in units of the last place of the largest of them.",
    claims={"2.7.5": "83a8c2d03ec4", "2.7.6": "8f13ceef2eb7", "2.7.7": "7e6c16e705d1", "2.7.8": "4f5a6feccc69",
        "2.7.9": "ea069919e801", "2.7.10": "08a921761314", "2.7.11": "7b8a8163deea", "2.7.12": "aae2b2a25553",
        "2.7.13": "25956c4dfd04"},
)
def direction_cosines(alpha, beta, gamma):
    """Cosines between the turned axes and the principal ones, by pitch, yaw and roll.

    a_11 = cos(alpha)*cos(beta)
    a_12 = sin(alpha)*sin(gamma) - sin(beta)*cos(alpha)*cos(gamma)
    a_13 = sin(alpha)*cos(gamma) + sin(beta)*sin(gamma)*cos(alpha)
    a_21 = sin(beta)
    a_22 = cos(beta)*cos(gamma)
    a_23 = -sin(gamma)*cos(beta)
    a_31 = -sin(alpha)*cos(beta)
    a_32 = sin(alpha)*sin(beta)*cos(gamma) + sin(gamma)*cos(alpha)
    a_33 = -sin(alpha)*sin(beta)*sin(gamma) + cos(alpha)*cos(gamma)

    >>> [f"{x:.6g}" for x in direction_cosines(1.25, 1.5, 1.75)]  # doctest: +NORMALIZE_WHITESPACE
    ['0.022305', '0.989852', '0.140343', '0.997495', '-0.0126086', '-0.0696044', '-0.0671285', '0.141544',
     '-0.987653']
    """
    cos_alpha = cos(alpha)
    cos_beta = cos(beta)
    sin_alpha = sin(alpha)
    sin_gamma = sin(gamma)
    t1 = sin_alpha * sin_gamma
    sin_beta = sin(beta)
    cos_gamma = cos(gamma)
    t2 = cos_gamma * sin_alpha
    t3 = cos_alpha * sin_gamma
    a_11 = cos_alpha * cos_beta
    a_12 = t1 - cos_gamma * (cos_alpha * sin_beta)
    a_13 = t2 + sin_beta * t3
    a_22 = cos_beta * cos_gamma
    a_23 = -(cos_beta * sin_gamma)
    a_31 = -(cos_beta * sin_alpha)
    a_32 = sin_beta * t2 + t3
    a_33 = cos_alpha * cos_gamma - sin_beta * t1
    return a_11, a_12, a_13, sin_beta, a_22, a_23, a_31, a_32, a_33


@kernel(
    Argument("I_1", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_2", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_3", "principal moment of inertia", "kg m^2", low="0"),
    Argument("a_11", "cosine between axis 1 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_12", "cosine between axis 1 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_13", "cosine between axis 1 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_21", "cosine between axis 2 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_22", "cosine between axis 2 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_23", "cosine between axis 2 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_31", "cosine between axis 3 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_32", "cosine between axis 3 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_33", "cosine between axis 3 and principal axis 3", low="-1", high="1", closed=True),
    Output("J_1", "moment of inertia about axis 1", "kg m^2"),
    Output("J_2", "moment of inertia about axis 2", "kg m^2"),
    Output("J_3", "moment of inertia about axis 3", "kg m^2"),
    ulp=4,
    claims={"2.0.4": "433ac82c664e", "1.4.1": "5629ced6590c"},
)
def axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
    """Moments of inertia about three turned axes.

    J_1 = I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2
    J_2 = I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2
    J_3 = I_1*a_31**2 + I_2*a_32**2 + I_3*a_33**2

    >>> [f"{x:.6g}" for x in axial_moments(0.08, 0.15, 0.23, -0.38, -0.23, -0.08, 0.08, 0.23, 0.38, 0.54, 0.69,
    ...     0.85)]
    ['0.020959', '0.041659', '0.260918']
    """
    J_1 = I_3 * (a_13 * a_13) + (I_1 * (a_11 * a_11) + I_2 * (a_12 * a_12))
    J_2 = I_3 * (a_23 * a_23) + (I_1 * (a_21 * a_21) + I_2 * (a_22 * a_22))
    J_3 = I_3 * (a_33 * a_33) + (I_1 * (a_31 * a_31) + I_2 * (a_32 * a_32))
    return J_1, J_2, J_3


@kernel(
    Argument("I_1", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_2", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_3", "principal moment of inertia", "kg m^2", low="0"),
    Argument("a_11", "cosine between axis 1 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_12", "cosine between axis 1 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_13", "cosine between axis 1 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_21", "cosine between axis 2 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_22", "cosine between axis 2 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_23", "cosine between axis 2 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_31", "cosine between axis 3 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_32", "cosine between axis 3 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_33", "cosine between axis 3 and principal axis 3", low="-1", high="1", closed=True),
    Output("L_1", "product of two moments, of axis 1", "kg^2 m^4"),
    Output("L_2", "product of two moments, of axis 2", "kg^2 m^4"),
    Output("L_3", "product of two moments, of axis 3", "kg^2 m^4"),
    ulp=4,
    claims={"1.3.2": "f55f08c0281c", "1.3.3": "5dc933bd040b"},
)
def second_order_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
    """The quadratic forms L_i of the adjugate of the inertia tensor, for three turned axes.

    L_1 = I_1*I_2*a_13**2 + I_1*I_3*a_12**2 + I_2*I_3*a_11**2
    L_2 = I_1*I_2*a_23**2 + I_1*I_3*a_22**2 + I_2*I_3*a_21**2
    L_3 = I_1*I_2*a_33**2 + I_1*I_3*a_32**2 + I_2*I_3*a_31**2

    >>> [f"{x:.6g}" for x in second_order_moments(0.08, 0.15, 0.23, -0.38, -0.23, -0.08, 0.08, 0.23, 0.38,
    ...     0.54, 0.69, 0.85)]
    ['0.00603196', '0.00292696', '0.0274904']
    """
    t1 = I_1 * I_2
    t2 = I_1 * I_3
    t3 = I_2 * I_3
    L_1 = a_13 * a_13 * t1 + (a_11 * a_11 * t3 + a_12 * a_12 * t2)
    L_2 = a_23 * a_23 * t1 + (a_22 * a_22 * t2 + a_21 * a_21 * t3)
    L_3 = a_33 * a_33 * t1 + (a_31 * a_31 * t3 + a_32 * a_32 * t2)
    return L_1, L_2, L_3


@kernel(
    Argument("I_1", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_2", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_3", "principal moment of inertia", "kg m^2", low="0"),
    Argument("a_11", "cosine between axis 1 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_12", "cosine between axis 1 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_13", "cosine between axis 1 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_21", "cosine between axis 2 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_22", "cosine between axis 2 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_23", "cosine between axis 2 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_31", "cosine between axis 3 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_32", "cosine between axis 3 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_33", "cosine between axis 3 and principal axis 3", low="-1", high="1", closed=True),
    Output("f", "J_1 J_2 J_3", "kg^3 m^6"),
    ulp=14,
    condition=(
        "A product of sums keeps the roundings of all its factors, as many operations follow one another; its "
        "condition number is 9, so that arguments rounded to the nearest double change it by as many half units."
    ),
    claims={"2.1": "96cb35e8b636", "2.13.4": "e9ade4ef247e"},
)
def product_of_axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
    """The product f of the moments of inertia about three turned axes.

    f = (I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2)*(I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)*(I_1*a_31**2 +
        I_2*a_32**2 + I_3*a_33**2)

    >>> format(product_of_axial_moments(0.08, 0.15, 0.23, -0.38, -0.23, -0.08, 0.08, 0.23, 0.38,
    ...     0.54, 0.69, 0.85), ".6g")
    '0.000227816'
    """
    t16 = (
        (I_3 * (a_23 * a_23) + (I_1 * (a_21 * a_21) + I_2 * (a_22 * a_22))) * (I_3 * (a_13 * a_13) + (I_1 * (a_11 *
        a_11) + I_2 * (a_12 * a_12)))
    )
    return (I_3 * (a_33 * a_33) + (I_1 * (a_31 * a_31) + I_2 * (a_32 * a_32))) * t16


@kernel(
    Argument("I_1", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_2", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_3", "principal moment of inertia", "kg m^2", low="0"),
    Argument("a_11", "cosine between axis 1 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_12", "cosine between axis 1 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_13", "cosine between axis 1 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_21", "cosine between axis 2 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_22", "cosine between axis 2 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_23", "cosine between axis 2 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_31", "cosine between axis 3 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_32", "cosine between axis 3 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_33", "cosine between axis 3 and principal axis 3", low="-1", high="1", closed=True),
    Output("S", "J_1 L_1 + J_2 L_2 + J_3 L_3", "kg^3 m^6"),
    ulp=12,
    condition=(
        "A product of sums keeps the roundings of all its factors, as many operations follow one another; its "
        "condition number is 7, so that arguments rounded to the nearest double change it by as many half units."
    ),
    claims={"2.18": "b56edba0ec5c", "2.19.4": "b8cfa770eb92"},
)
def sum_of_products(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
    """The sum of the products J_i L_i, the coefficient that decides how far the damping is from its optimum.

    S = (I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2)*(I_1*I_2*a_13**2 + I_1*I_3*a_12**2 + I_2*I_3*a_11**2) +
        (I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)*(I_1*I_2*a_23**2 + I_1*I_3*a_22**2 + I_2*I_3*a_21**2) +
        (I_1*a_31**2 + I_2*a_32**2 + I_3*a_33**2)*(I_1*I_2*a_33**2 + I_1*I_3*a_32**2 + I_2*I_3*a_31**2)

    >>> format(sum_of_products(0.08, 0.15, 0.23, -0.38, -0.23, -0.08, 0.08, 0.23, 0.38, 0.54,
    ...     0.69, 0.85), ".6g")
    '0.00742111'
    """
    a_11_squared = a_11 * a_11
    a_12_squared = a_12 * a_12
    a_13_squared = a_13 * a_13
    t1 = I_1 * I_2
    t2 = I_1 * I_3
    t3 = I_2 * I_3
    a_21_squared = a_21 * a_21
    a_22_squared = a_22 * a_22
    a_23_squared = a_23 * a_23
    a_31_squared = a_31 * a_31
    a_32_squared = a_32 * a_32
    a_33_squared = a_33 * a_33
    t14 = (
        (I_3 * a_13_squared + (I_2 * a_12_squared + I_1 * a_11_squared)) * (a_13_squared * t1 + (a_11_squared * t3 +
        a_12_squared * t2))
    )
    t25 = (
        (a_21_squared * t3 + (a_23_squared * t1 + a_22_squared * t2)) * (I_3 * a_23_squared + (I_1 * a_21_squared + I_2
        * a_22_squared))
    )
    t36 = (
        (a_31_squared * t3 + (a_32_squared * t2 + a_33_squared * t1)) * (I_3 * a_33_squared + (I_1 * a_31_squared + I_2
        * a_32_squared))
    )
    return t36 + (t14 + t25)


@kernel(
    Argument("I_1", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_2", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_3", "principal moment of inertia", "kg m^2", low="0"),
    Output("f_least", "least J_1 J_2 J_3, about principal axes", "kg^3 m^6"),
    Output("f_greatest", "greatest J_1 J_2 J_3, about axes of equal moments", "kg^3 m^6"),
    Output("S_least", "least J_1 L_1 + J_2 L_2 + J_3 L_3, about principal axes", "kg^3 m^6"),
    ulp=9,
    condition="A cube triples the error of the mean moment: its condition number is 3.",
    claims={"2.1": "96cb35e8b636", "2.3.7": "a4d42e35dcb0", "2.18": "b56edba0ec5c"},
    forms="89ad4823d9b6",
)
def bounds_of_products(I_1, I_2, I_3):
    """The least and greatest product of moments about orthogonal axes, and the least sum of the products J_i L_i.

    f_least = I_1*I_2*I_3
    f_greatest = (I_1/3 + I_2/3 + I_3/3)**3
    S_least = 3*I_1*I_2*I_3

    >>> [f"{x:.6g}" for x in bounds_of_products(0.25, 0.5, 0.75)]
    ['0.09375', '0.125', '0.28125']
    """
    t2 = I_3 * (I_1 * I_2)
    t4 = I_3 + (I_1 + I_2)
    f_greatest = (1.0 / 27.0) * (t4 * (t4 * t4))
    S_least = 3.0 * t2
    return t2, f_greatest, S_least


@kernel(
    Argument("I_1", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_2", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_3", "principal moment of inertia", "kg m^2", low="0"),
    Argument("a_11", "cosine between axis 1 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_12", "cosine between axis 1 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_13", "cosine between axis 1 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_21", "cosine between axis 2 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_22", "cosine between axis 2 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_23", "cosine between axis 2 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_31", "cosine between axis 3 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_32", "cosine between axis 3 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_33", "cosine between axis 3 and principal axis 3", low="-1", high="1", closed=True),
    Output("f_excess", "J_1 J_2 J_3 - I_1 I_2 I_3", "kg^3 m^6"),
    Output("f_deficit", "((I_1 + I_2 + I_3)/3)^3 - J_1 J_2 J_3", "kg^3 m^6"),
    Output("S_excess", "J_1 L_1 + J_2 L_2 + J_3 L_3 - 3 I_1 I_2 I_3", "kg^3 m^6"),
    ulp=12,
    condition=(
        "Sums of squares: near a bound they keep the digits that a difference loses. Within a square J_1 - J_3, the"
        " mean moment less J_2, and a product of inertia may cancel; the error is in units of the last place of "
        "what it were if they did not."
    ),
    claims={"2.13.4": "e9ade4ef247e", "2.19.4": "b8cfa770eb92", "2.2": "c8d1ca2b73d8", "2.1": "96cb35e8b636"},
)
def distances_from_bounds(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
    """How far J_1 J_2 J_3 and the sum of J_i L_i of orthogonal axes are from their bounds; never negative.

    f_excess = I_1*a_22**2*a_23**2*(I_2 - I_3)**2 + I_2*a_21**2*a_23**2*(-I_1 + I_3)**2 + I_3*a_21**2*a_22**2*(I_1 -
        I_2)**2 + (I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)*(I_1*a_11*a_31 + I_2*a_12*a_32 + I_3*a_13*a_33)**2
    f_deficit = (I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)*(I_1*a_11**2 - I_1*a_31**2 + I_2*a_12**2 - I_2*a_32**2 +
        I_3*a_13**2 - I_3*a_33**2)**2/4 + (-I_1*a_21**2 + I_1/3 - I_2*a_22**2 + I_2/3 - I_3*a_23**2 +
        I_3/3)**2*(I_1*a_11**2 + I_1*a_31**2 + I_1/3 + I_2*a_12**2 + I_2*a_32**2 + I_2/3 + I_3*a_13**2 + I_3*a_33**2
        + I_3/3)/4
    S_excess = I_1*a_12**2*a_13**2*(I_2 - I_3)**2 + I_1*a_22**2*a_23**2*(I_2 - I_3)**2 + I_1*a_32**2*a_33**2*(I_2 -
        I_3)**2 + I_2*a_11**2*a_13**2*(-I_1 + I_3)**2 + I_2*a_21**2*a_23**2*(-I_1 + I_3)**2 +
        I_2*a_31**2*a_33**2*(-I_1 + I_3)**2 + I_3*a_11**2*a_12**2*(I_1 - I_2)**2 + I_3*a_21**2*a_22**2*(I_1 -
        I_2)**2 + I_3*a_31**2*a_32**2*(I_1 - I_2)**2

    >>> [f"{x:.6g}" for x in distances_from_bounds(0.08, 0.15, 0.23, -0.38, -0.23, -0.08, 0.08, 0.23, 0.38,
    ...     0.54, 0.69, 0.85)]
    ['0.000137407', '0.00195658', '0.00106294']
    """
    a_21_squared = a_21 * a_21
    a_22_squared = a_22 * a_22
    a_23_squared = a_23 * a_23
    t5 = I_3 * a_23_squared + (I_1 * a_21_squared + I_2 * a_22_squared)
    t6 = -I_3
    t7 = I_2 + t6
    t9 = I_1 * (t7 * t7)
    t11 = -(I_1 + t6)
    t13 = I_2 * (t11 * t11)
    t14 = I_1 - I_2
    t16 = I_3 * (t14 * t14)
    t24 = a_22_squared * a_23_squared * t9 + (t16 * (a_21_squared * a_22_squared) + t13 * (a_21_squared * a_23_squared))
    a_31_squared = a_31 * a_31
    t25 = I_1 * a_31_squared
    a_32_squared = a_32 * a_32
    t26 = I_2 * a_32_squared
    a_33_squared = a_33 * a_33
    t27 = I_3 * a_33_squared
    a_11_squared = a_11 * a_11
    a_12_squared = a_12 * a_12
    a_13_squared = a_13 * a_13
    t32 = I_3 * a_13_squared + (I_1 * a_11_squared + I_2 * a_12_squared)
    t40 = a_33 * (I_3 * a_13) + (a_31 * (I_1 * a_11) + a_32 * (I_2 * a_12))
    t46 = t32 - t25 - t26 - t27
    t54 = (1.0 / 3.0) * I_3 + ((1.0 / 3.0) * I_1 + (1.0 / 3.0) * I_2)
    t55 = t54 - t5
    t63 = (1.0 / 4.0) * (t46 * t46 * t5) + (1.0 / 4.0) * (t55 * t55 * (t32 + (t27 + (t26 + (t25 + t54)))))
    t77 = a_31_squared * (a_33_squared * t13) + (a_32_squared * a_33_squared * t9 + a_31_squared * (a_32_squared * t16))
    t80 = (
        a_12_squared * a_13_squared * t9 + (t13 * (a_11_squared * a_13_squared) + (t16 * (a_11_squared * a_12_squared) +
        t77))
    )
    f_excess = t24 + t40 * t40 * t5
    S_excess = t24 + t80
    return f_excess, t63, S_excess


@kernel(
    Argument("I_1", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_2", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_3", "principal moment of inertia", "kg m^2", low="0"),
    Argument("J_2", "moment of inertia about axis 2", "kg m^2", low="0", high="(I_1 + I_2 + I_3)/2", closed=True),
    Output("f_1", "greatest J_1 J_2 J_3", "kg^3 m^6"),
    ulp=8,
    condition="A square doubles the error of the two other moments, which are at least half of all three.",
    claims={"2.2": "c8d1ca2b73d8"},
)
def bound_at_given_moment(I_1, I_2, I_3, J_2):
    """The greatest product J_1 J_2 J_3 of moments about orthogonal axes for a given J_2.

    f_1 = J_2*(I_1/2 + I_2/2 + I_3/2 - J_2/2)**2

    >>> format(bound_at_given_moment(0.2, 0.4, 0.6, 0.48), ".6g")
    '0.062208'
    """
    t7 = (1.0 / 2.0) * I_3 + ((1.0 / 2.0) * I_1 + (1.0 / 2.0) * I_2) - (1.0 / 2.0) * J_2
    return J_2 * (t7 * t7)


@kernel(
    Argument("I_1", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_2", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_3", "principal moment of inertia", "kg m^2", low="0"),
    Argument("a_11", "cosine between axis 1 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_12", "cosine between axis 1 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_13", "cosine between axis 1 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_31", "cosine between axis 3 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_32", "cosine between axis 3 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_33", "cosine between axis 3 and principal axis 3", low="-1", high="1", closed=True),
    Output("J_1_J_3", "J_1 J_3", "kg^2 m^4"),
    ulp=9,
    condition=(
        "A product of sums keeps the roundings of all its factors, as many operations follow one another; its "
        "condition number is 6, so that arguments rounded to the nearest double change it by as many half units."
    ),
    claims={"2.11.3": "3c51b73d012a", "2.12": "545d295f403b"},
)
def product_of_two_axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_31, a_32, a_33):
    """The product of the moments of inertia about two axes.

    J_1_J_3 = (I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2)*(I_1*a_31**2 + I_2*a_32**2 + I_3*a_33**2)

    >>> format(product_of_two_axial_moments(0.1, 0.2, 0.3, -0.2, 0.0, 0.2, 0.4, 0.6, 0.8), ".6g")
    '0.00448'
    """
    t11 = (
        (I_3 * (a_33 * a_33) + (I_1 * (a_31 * a_31) + I_2 * (a_32 * a_32))) * (I_3 * (a_13 * a_13) + (I_1 * (a_11 *
        a_11) + I_2 * (a_12 * a_12)))
    )
    return t11


@kernel(
    Argument("I_1", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_2", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_3", "principal moment of inertia", "kg m^2", low="0"),
    Argument("a_21", "cosine between axis 2 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_22", "cosine between axis 2 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_23", "cosine between axis 2 and principal axis 3", low="-1", high="1", closed=True),
    Output("J_2_L_2", "J_2 (I_1 I_2 a_23^2 + I_2 I_3 a_21^2 + I_3 I_1 a_22^2)", "kg^3 m^6"),
    ulp=10,
    condition=(
        "A product of sums keeps the roundings of all its factors, as many operations follow one another; its "
        "condition number is 7, so that arguments rounded to the nearest double change it by as many half units."
    ),
    claims={"2.12.1": "0bd72d06e149", "2.13": "43549f7163b3"},
)
def product_with_second_moment(I_1, I_2, I_3, a_21, a_22, a_23):
    """The product of the moment of inertia J_2 and the form L_2 of the same axis.

    J_2_L_2 = (I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)*(I_1*I_2*a_23**2 + I_1*I_3*a_22**2 + I_2*I_3*a_21**2)

    >>> format(product_with_second_moment(0.14, 0.29, 0.43, 0.14, 0.43, 0.71), ".6g")
    '0.0092977'
    """
    a_21_squared = a_21 * a_21
    a_22_squared = a_22 * a_22
    a_23_squared = a_23 * a_23
    t14 = (
        (I_3 * (I_2 * a_21_squared) + (I_2 * (I_1 * a_23_squared) + I_3 * (I_1 * a_22_squared))) * (I_3 * a_23_squared +
        (I_1 * a_21_squared + I_2 * a_22_squared))
    )
    return t14


@kernel(
    Argument("k_1", "gain of the damping device along axis 1", "N m s/rad", low="0"),
    Argument("k_2", "gain of the damping device along axis 2", "N m s/rad", low="0"),
    Argument("k_3", "gain of the damping device along axis 3", "N m s/rad", low="0"),
    Argument("a_11", "cosine between axis 1 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_12", "cosine between axis 1 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_13", "cosine between axis 1 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_21", "cosine between axis 2 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_22", "cosine between axis 2 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_23", "cosine between axis 2 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_31", "cosine between axis 3 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_32", "cosine between axis 3 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_33", "cosine between axis 3 and principal axis 3", low="-1", high="1", closed=True),
    Output("m_11", "entry 1, 1", "N m s/rad"),
    Output("m_12", "entry 1, 2", "N m s/rad"),
    Output("m_13", "entry 1, 3", "N m s/rad"),
    Output("m_22", "entry 2, 2", "N m s/rad"),
    Output("m_23", "entry 2, 3", "N m s/rad"),
    Output("m_33", "entry 3, 3", "N m s/rad"),
    ulp=4,
    condition="Where terms cancel, the error is in units of the last place of the largest of them.",
    claims={"1.2.6": "6d5ed42cccc0", "1.2.12": "3363a6b3e5b0"},
)
def damping_matrix(k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
    """The damping matrix of three devices in principal axes, on its diagonal and above; it is symmetric.

    m_11 = a_11**2*k_1 + a_21**2*k_2 + a_31**2*k_3
    m_12 = a_11*a_12*k_1 + a_21*a_22*k_2 + a_31*a_32*k_3
    m_13 = a_11*a_13*k_1 + a_21*a_23*k_2 + a_31*a_33*k_3
    m_22 = a_12**2*k_1 + a_22**2*k_2 + a_32**2*k_3
    m_23 = a_12*a_13*k_1 + a_22*a_23*k_2 + a_32*a_33*k_3
    m_33 = a_13**2*k_1 + a_23**2*k_2 + a_33**2*k_3

    >>> [f"{x:.6g}" for x in damping_matrix(0.08, 0.15, 0.23, -0.38, -0.23, -0.08, 0.08, 0.23, 0.38, 0.54,
    ...     0.69, 0.85)]
    ['0.07958', '0.09545', '0.112562', '0.12167', '0.149477', '0.188347']
    """
    t1 = a_11 * k_1
    t2 = a_21 * k_2
    t3 = a_31 * k_3
    m_11 = a_31 * a_31 * k_3 + (a_11 * a_11 * k_1 + a_21 * a_21 * k_2)
    m_12 = a_32 * t3 + (a_22 * t2 + a_12 * t1)
    m_13 = a_33 * t3 + (a_13 * t1 + a_23 * t2)
    m_22 = a_32 * a_32 * k_3 + (a_12 * a_12 * k_1 + a_22 * a_22 * k_2)
    m_23 = k_3 * (a_32 * a_33) + (k_1 * (a_12 * a_13) + k_2 * (a_22 * a_23))
    m_33 = a_33 * a_33 * k_3 + (a_13 * a_13 * k_1 + a_23 * a_23 * k_2)
    return m_11, m_12, m_13, m_22, m_23, m_33


@kernel(
    Argument("I_1", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_2", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_3", "principal moment of inertia", "kg m^2", low="0"),
    Argument("k_1", "gain of the damping device along axis 1", "N m s/rad", low="0"),
    Argument("k_2", "gain of the damping device along axis 2", "N m s/rad", low="0"),
    Argument("k_3", "gain of the damping device along axis 3", "N m s/rad", low="0"),
    Argument("a_11", "cosine between axis 1 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_12", "cosine between axis 1 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_13", "cosine between axis 1 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_21", "cosine between axis 2 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_22", "cosine between axis 2 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_23", "cosine between axis 2 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_31", "cosine between axis 3 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_32", "cosine between axis 3 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_33", "cosine between axis 3 and principal axis 3", low="-1", high="1", closed=True),
    Output("c_3", "coefficient of p^3, for orthogonal axes", "kg^3 m^6"),
    Output("c_2", "coefficient of p^2, for orthogonal axes", "kg^3 m^6/s"),
    Output("c_1", "coefficient of p^1, for orthogonal axes", "kg^3 m^6/s^2"),
    Output("c_0", "coefficient of p^0, for orthogonal axes", "kg^3 m^6/s^3"),
    ulp=8,
    condition=(
        "A product of sums keeps the roundings of all its factors, as many operations follow one another; its "
        "condition number is 5, so that arguments rounded to the nearest double change it by as many half units."
    ),
    claims={"1.3": "f08642819e8b", "1.3.2": "f55f08c0281c", "1.3.3": "5dc933bd040b"},
)
def characteristic_coefficients(I_1, I_2, I_3, k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
    """Coefficients of the characteristic equation (1.3) of the damped rotation.

    c_3 = I_1*I_2*I_3
    c_2 = k_1*(I_1*I_2*a_13**2 + I_1*I_3*a_12**2 + I_2*I_3*a_11**2) + k_2*(I_1*I_2*a_23**2 + I_1*I_3*a_22**2 +
        I_2*I_3*a_21**2) + k_3*(I_1*I_2*a_33**2 + I_1*I_3*a_32**2 + I_2*I_3*a_31**2)
    c_1 = k_1*k_2*(I_1*a_31**2 + I_2*a_32**2 + I_3*a_33**2) + k_1*k_3*(I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2) +
        k_2*k_3*(I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2)
    c_0 = k_1*k_2*k_3

    >>> [f"{x:.6g}" for x in characteristic_coefficients(0.06, 0.12, 0.19, 0.25, 0.31, 0.38, -0.12, 0.0, 0.12,
    ...     0.25, 0.38, 0.5, 0.62, 0.75, 0.88)]
    ['0.001368', '0.00950401', '0.0253607', '0.02945']
    """
    t1 = I_1 * I_2
    a_13_squared = a_13 * a_13
    a_12_squared = a_12 * a_12
    t2 = I_1 * I_3
    a_11_squared = a_11 * a_11
    t3 = I_2 * I_3
    a_23_squared = a_23 * a_23
    a_22_squared = a_22 * a_22
    a_21_squared = a_21 * a_21
    a_33_squared = a_33 * a_33
    a_32_squared = a_32 * a_32
    a_31_squared = a_31 * a_31
    t4 = k_1 * k_2
    t24 = (
        k_1 * (a_11_squared * t3 + (a_13_squared * t1 + a_12_squared * t2)) + k_2 * (a_21_squared * t3 + (a_23_squared *
        t1 + a_22_squared * t2))
    )
    t46 = (
        (I_3 * a_23_squared + (I_1 * a_21_squared + I_2 * a_22_squared)) * (k_1 * k_3) + (I_3 * a_13_squared + (I_1 *
        a_11_squared + I_2 * a_12_squared)) * (k_2 * k_3)
    )
    c_3 = I_3 * t1
    c_2 = k_3 * (a_31_squared * t3 + (a_33_squared * t1 + a_32_squared * t2)) + t24
    c_1 = t4 * (I_3 * a_33_squared + (I_1 * a_31_squared + I_2 * a_32_squared)) + t46
    c_0 = k_3 * t4
    return c_3, c_2, c_1, c_0


@kernel(
    Argument("I_1", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_2", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_3", "principal moment of inertia", "kg m^2", low="0"),
    Argument("k", "gains divided by the moments of inertia about their axes", "1/s", low="0"),
    Argument("a_11", "cosine between axis 1 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_12", "cosine between axis 1 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_13", "cosine between axis 1 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_21", "cosine between axis 2 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_22", "cosine between axis 2 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_23", "cosine between axis 2 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_31", "cosine between axis 3 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_32", "cosine between axis 3 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_33", "cosine between axis 3 and principal axis 3", low="-1", high="1", closed=True),
    Output("c_3", "coefficient of p^3, for gains k J_i", "kg^3 m^6"),
    Output("c_2", "coefficient of p^2, for gains k J_i", "kg^3 m^6/s"),
    Output("c_1", "coefficient of p^1, for gains k J_i", "kg^3 m^6/s^2"),
    Output("c_0", "coefficient of p^0, for gains k J_i", "kg^3 m^6/s^3"),
    ulp=16,
    condition=(
        "A product of sums keeps the roundings of all its factors, as many operations follow one another; its "
        "condition number is 12, so that arguments rounded to the nearest double change it by as many half units."
    ),
    claims={"1.5": "3b17564964dd", "1.3.3": "5dc933bd040b"},
)
def characteristic_coefficients_at_common_ratio(
    I_1, I_2, I_3, k, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,
):
    """Coefficients of the characteristic equation (1.5): gains in proportion to the moments about their axes.

    c_3 = I_1*I_2*I_3
    c_2 = k*((I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2)*(I_1*I_2*a_13**2 + I_1*I_3*a_12**2 + I_2*I_3*a_11**2) +
        (I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)*(I_1*I_2*a_23**2 + I_1*I_3*a_22**2 + I_2*I_3*a_21**2) +
        (I_1*a_31**2 + I_2*a_32**2 + I_3*a_33**2)*(I_1*I_2*a_33**2 + I_1*I_3*a_32**2 + I_2*I_3*a_31**2))
    c_1 = 3*k**2*(I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2)*(I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)*(I_1*a_31**2 +
        I_2*a_32**2 + I_3*a_33**2)
    c_0 = k**3*(I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2)*(I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)*(I_1*a_31**2 +
        I_2*a_32**2 + I_3*a_33**2)

    >>> [f"{x:.6g}" for x in characteristic_coefficients_at_common_ratio(0.07, 0.14, 0.21, 0.29, -0.29, -0.14,
    ...     0.0, 0.14, 0.29, 0.43, 0.57, 0.71, 0.86)]
    ['0.002058', '0.0018072', '2.81405e-05', '2.72025e-06']
    """
    t1 = I_1 * I_2
    a_11_squared = a_11 * a_11
    a_12_squared = a_12 * a_12
    a_13_squared = a_13 * a_13
    t6 = I_3 * a_13_squared + (I_1 * a_11_squared + I_2 * a_12_squared)
    t7 = I_1 * I_3
    t8 = I_2 * I_3
    a_21_squared = a_21 * a_21
    a_22_squared = a_22 * a_22
    a_23_squared = a_23 * a_23
    t13 = I_3 * a_23_squared + (I_2 * a_22_squared + I_1 * a_21_squared)
    a_31_squared = a_31 * a_31
    a_32_squared = a_32 * a_32
    a_33_squared = a_33 * a_33
    t18 = I_3 * a_33_squared + (I_1 * a_31_squared + I_2 * a_32_squared)
    t20 = t13 * t18 * t6
    t40 = (
        t13 * (a_21_squared * t8 + (a_23_squared * t1 + a_22_squared * t7)) + t18 * (a_32_squared * t7 + (a_33_squared *
        t1 + a_31_squared * t8))
    )
    k_squared = k * k
    c_3 = I_3 * t1
    c_2 = k * ((a_12_squared * t7 + (a_13_squared * t1 + a_11_squared * t8)) * t6 + t40)
    c_1 = 3.0 * (k_squared * t20)
    c_0 = t20 * (k * k_squared)
    return c_3, c_2, c_1, c_0


@kernel(
    Argument("k", "gains divided by the moments of inertia about their axes", "1/s", low="0"),
    Argument("I_1", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_2", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_3", "principal moment of inertia", "kg m^2", low="0"),
    Argument("a_11", "cosine between axis 1 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_12", "cosine between axis 1 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_13", "cosine between axis 1 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_21", "cosine between axis 2 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_22", "cosine between axis 2 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_23", "cosine between axis 2 and principal axis 3", low="-1", high="1", closed=True),
    Argument("a_31", "cosine between axis 3 and principal axis 1", low="-1", high="1", closed=True),
    Argument("a_32", "cosine between axis 3 and principal axis 2", low="-1", high="1", closed=True),
    Argument("a_33", "cosine between axis 3 and principal axis 3", low="-1", high="1", closed=True),
    Output("k_1", "gain of the damping device along axis 1", "N m s/rad"),
    Output("k_2", "gain of the damping device along axis 2", "N m s/rad"),
    Output("k_3", "gain of the damping device along axis 3", "N m s/rad"),
    ulp=4,
    claims={"1.5": "3b17564964dd", "1.8": "940f5957d1cf", "1.8.1": "6dfe84901600"},
)
def gains_in_proportion(k, I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
    """Gains in proportion to the moments of inertia about their axes; along principal axes k is the stability degree.

    k_1 = k*(I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2)
    k_2 = k*(I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)
    k_3 = k*(I_1*a_31**2 + I_2*a_32**2 + I_3*a_33**2)

    >>> [f"{x:.6g}" for x in gains_in_proportion(0.07, 0.14, 0.21, 0.29, -0.29, -0.14, 0.0, 0.14, 0.29, 0.43,
    ...     0.57, 0.71, 0.86)]
    ['0.0011123', '0.00518182', '0.0256082']
    """
    k_1 = k * (I_3 * (a_13 * a_13) + (I_1 * (a_11 * a_11) + I_2 * (a_12 * a_12)))
    k_2 = k * (I_1 * (a_21 * a_21) + I_2 * (a_22 * a_22) + I_3 * (a_23 * a_23))
    k_3 = k * (I_3 * (a_33 * a_33) + (I_1 * (a_31 * a_31) + I_2 * (a_32 * a_32)))
    return k_1, k_2, k_3


@kernel(
    Argument("xi", "least damping rate", "1/s", low="0"),
    Argument("s_1", "rate 1 less the least one", "1/s", low="0", closed=True),
    Argument("s_2", "rate 2 less the least one", "1/s", low="0", closed=True),
    Argument("s_3", "rate 3 less the least one", "1/s", low="0", closed=True),
    Output("k", "harmonic mean of the rates: the greatest stability degree for these gains", "1/s"),
    Output("k_excess", "k - xi", "1/s"),
    ulp=10,
    condition="Ten operations follow one another in k_excess, none of which cancels.",
    degenerate="With s_1 = s_2 = s_3 = 0, the triple root, k is xi.",
    claims={"B.3": "11825ee30064", "B.4": "269f1a96d135"},
    forms="5d56f449afb7",
)
def gain_of_rates(xi, s_1, s_2, s_3):
    """The gain ratio k that three damping rates need, and how far it is above the least of them, the stability degree.

    k = 3/(1/(s_3 + xi) + 1/(s_2 + xi) + 1/(s_1 + xi))
    k_excess = -xi + 3/(1/(s_3 + xi) + 1/(s_2 + xi) + 1/(s_1 + xi))

    >>> [f"{x:.6g}" for x in gain_of_rates(0.2, 0.4, 0.6, 0.8)]
    ['0.765957', '0.565957']
    """
    t2 = 1.0 / (s_1 + xi)
    t4 = 1.0 / (s_2 + xi)
    t6 = 1.0 / (s_3 + xi)
    t9 = 1.0 / (t6 + (t2 + t4))
    k = 3.0 * t9
    k_excess = (s_3 * t6 + (s_1 * t2 + s_2 * t4)) * t9
    return k, k_excess


@kernel(
    Argument("k", "gains divided by the moments of inertia about their axes", "1/s", low="0"),
    Argument("I_1", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_3", "principal moment of inertia", "kg m^2", low="0"),
    Argument("alpha", "pitch", "rad", low="0", high="pi/2"),
    Output("xi", "stability degree", "1/s"),
    ulp=4,
    degenerate="For I_1 = I_3 and for the pitch 0 the stability degree is k, the greatest there is.",
    claims={"1.5": "3b17564964dd", "B.2": "f17408ae5d05", "B.3": "11825ee30064", "B.4": "269f1a96d135"},
    forms="4c82a6f9dadb",
)
def stability_degree_in_pitch(k, I_1, I_3, alpha):
    """The stability degree, the least damping rate, of gains k J_i along axes that are turned by the pitch alone.

    xi = k/(sqrt(I_1*I_3/((I_1*sin(alpha)**2 - I_1 - I_3*sin(alpha)**2)*(I_1*sin(alpha)**2 - I_3*sin(alpha)**2 +
        I_3)) + 1) + 1)

    >>> format(stability_degree_in_pitch(0.2, 0.4, 0.6, 1.26), ".6g")
    '0.178885'
    """
    tan_alpha = tan(alpha)
    tan_alpha_squared = tan_alpha * tan_alpha
    t1 = 1.0 + tan_alpha_squared
    t3 = I_1 - I_3
    return k / (1.0 + sqrt(1.0 / (1.0 + t1 * t1 * (I_1 * I_3) / (t3 * t3 * tan_alpha_squared))))


@kernel(
    Argument("I_1", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_2", "principal moment of inertia", "kg m^2", low="0"),
    Argument("I_3", "principal moment of inertia", "kg m^2", low="0"),
    Output("alpha", "pitch", "rad"),
    ulp=4,
    condition=(
        "The pitch is zero where I_1 is the mean moment; the error is in units of the last place of the greatest, "
        "pi/4."
    ),
    degenerate=(
        "For I_2 = I_3 it is pi/4 or -pi/4; if all three moments are equal, every pitch serves, and there is no "
        "number."
    ),
    claims={"2.8.1": "19a49102279d", "2.9": "b20d0080930c", "2.9.2": "1f958d6caea2"},
    forms="d6a7df8cd518",
)
def equal_moment_pitch(I_1, I_2, I_3):
    """The pitch at which the moments about all three axes are equal, with the yaw arcsin(1/sqrt 3) and the roll pi/4.

    alpha = atan(sqrt(3)*(2*I_1 - I_2 - I_3)/(3*(I_2 - I_3)))/2

    >>> format(equal_moment_pitch(0.25, 0.5, 0.75), ".6g")
    '0.523599'
    """
    t9 = (1.0 / 2.0) * atan((1.0 / 3.0) * (sqrt(3.0) * (1.0 + 2.0 * (I_1 - I_2) / (I_2 - I_3))))
    return t9


KERNELS = {
    "direction_cosines": direction_cosines,
    "axial_moments": axial_moments,
    "second_order_moments": second_order_moments,
    "product_of_axial_moments": product_of_axial_moments,
    "sum_of_products": sum_of_products,
    "bounds_of_products": bounds_of_products,
    "distances_from_bounds": distances_from_bounds,
    "bound_at_given_moment": bound_at_given_moment,
    "product_of_two_axial_moments": product_of_two_axial_moments,
    "product_with_second_moment": product_with_second_moment,
    "damping_matrix": damping_matrix,
    "characteristic_coefficients": characteristic_coefficients,
    "characteristic_coefficients_at_common_ratio": characteristic_coefficients_at_common_ratio,
    "gains_in_proportion": gains_in_proportion,
    "gain_of_rates": gain_of_rates,
    "stability_degree_in_pitch": stability_degree_in_pitch,
    "equal_moment_pitch": equal_moment_pitch,
}
