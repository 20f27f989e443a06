"""Kernels of mirer2009. Written by `symcheck generate`: what is changed here is lost."""

import math

from numpy import add, arctan, cos, divide, multiply, negative, sin, sqrt, subtract, tan, array, ndarray

from symcheck.kernels.runtime import DOUBLE, FEW, SMALL, evaluate, evaluate_alike, evaluate_handful

__all__ = ["axial_moments", "bound_at_given_moment", "bounds_of_products", "characteristic_coefficients", "characteristic_coefficients_at_common_ratio", "damping_matrix", "direction_cosines", "distances_from_bounds", "equal_moment_pitch", "gain_of_rates", "gains_in_proportion", "product_of_axial_moments", "product_of_two_axial_moments", "product_with_second_moment", "second_order_moments", "stability_degree_in_pitch", "sum_of_products"]

DECLARED = {  # name, meaning and unit of the arguments and of the results; docstrings may be stripped
    'direction_cosines': (
        (
            ('alpha', 'pitch', 'rad'),
            ('beta', 'yaw', 'rad'),
            ('gamma', 'roll', 'rad'),
        ),
        (
            ('a_11', 'cosine between axis 1 and principal axis 1', '1'),
            ('a_12', 'cosine between axis 1 and principal axis 2', '1'),
            ('a_13', 'cosine between axis 1 and principal axis 3', '1'),
            ('a_21', 'cosine between axis 2 and principal axis 1', '1'),
            ('a_22', 'cosine between axis 2 and principal axis 2', '1'),
            ('a_23', 'cosine between axis 2 and principal axis 3', '1'),
            ('a_31', 'cosine between axis 3 and principal axis 1', '1'),
            ('a_32', 'cosine between axis 3 and principal axis 2', '1'),
            ('a_33', 'cosine between axis 3 and principal axis 3', '1'),
        ),
    ),
    'axial_moments': (
        (
            ('I_1', 'principal moment of inertia', 'kg m^2'),
            ('I_2', 'principal moment of inertia', 'kg m^2'),
            ('I_3', 'principal moment of inertia', 'kg m^2'),
            ('a_11', 'cosine between axis 1 and principal axis 1', '1'),
            ('a_12', 'cosine between axis 1 and principal axis 2', '1'),
            ('a_13', 'cosine between axis 1 and principal axis 3', '1'),
            ('a_21', 'cosine between axis 2 and principal axis 1', '1'),
            ('a_22', 'cosine between axis 2 and principal axis 2', '1'),
            ('a_23', 'cosine between axis 2 and principal axis 3', '1'),
            ('a_31', 'cosine between axis 3 and principal axis 1', '1'),
            ('a_32', 'cosine between axis 3 and principal axis 2', '1'),
            ('a_33', 'cosine between axis 3 and principal axis 3', '1'),
        ),
        (
            ('J_1', 'moment of inertia about axis 1', 'kg m^2'),
            ('J_2', 'moment of inertia about axis 2', 'kg m^2'),
            ('J_3', 'moment of inertia about axis 3', 'kg m^2'),
        ),
    ),
    'second_order_moments': (
        (
            ('I_1', 'principal moment of inertia', 'kg m^2'),
            ('I_2', 'principal moment of inertia', 'kg m^2'),
            ('I_3', 'principal moment of inertia', 'kg m^2'),
            ('a_11', 'cosine between axis 1 and principal axis 1', '1'),
            ('a_12', 'cosine between axis 1 and principal axis 2', '1'),
            ('a_13', 'cosine between axis 1 and principal axis 3', '1'),
            ('a_21', 'cosine between axis 2 and principal axis 1', '1'),
            ('a_22', 'cosine between axis 2 and principal axis 2', '1'),
            ('a_23', 'cosine between axis 2 and principal axis 3', '1'),
            ('a_31', 'cosine between axis 3 and principal axis 1', '1'),
            ('a_32', 'cosine between axis 3 and principal axis 2', '1'),
            ('a_33', 'cosine between axis 3 and principal axis 3', '1'),
        ),
        (
            ('L_1', 'product of two moments, of axis 1', 'kg^2 m^4'),
            ('L_2', 'product of two moments, of axis 2', 'kg^2 m^4'),
            ('L_3', 'product of two moments, of axis 3', 'kg^2 m^4'),
        ),
    ),
    'product_of_axial_moments': (
        (
            ('I_1', 'principal moment of inertia', 'kg m^2'),
            ('I_2', 'principal moment of inertia', 'kg m^2'),
            ('I_3', 'principal moment of inertia', 'kg m^2'),
            ('a_11', 'cosine between axis 1 and principal axis 1', '1'),
            ('a_12', 'cosine between axis 1 and principal axis 2', '1'),
            ('a_13', 'cosine between axis 1 and principal axis 3', '1'),
            ('a_21', 'cosine between axis 2 and principal axis 1', '1'),
            ('a_22', 'cosine between axis 2 and principal axis 2', '1'),
            ('a_23', 'cosine between axis 2 and principal axis 3', '1'),
            ('a_31', 'cosine between axis 3 and principal axis 1', '1'),
            ('a_32', 'cosine between axis 3 and principal axis 2', '1'),
            ('a_33', 'cosine between axis 3 and principal axis 3', '1'),
        ),
        (
            ('f', 'J_1 J_2 J_3', 'kg^3 m^6'),
        ),
    ),
    'sum_of_products': (
        (
            ('I_1', 'principal moment of inertia', 'kg m^2'),
            ('I_2', 'principal moment of inertia', 'kg m^2'),
            ('I_3', 'principal moment of inertia', 'kg m^2'),
            ('a_11', 'cosine between axis 1 and principal axis 1', '1'),
            ('a_12', 'cosine between axis 1 and principal axis 2', '1'),
            ('a_13', 'cosine between axis 1 and principal axis 3', '1'),
            ('a_21', 'cosine between axis 2 and principal axis 1', '1'),
            ('a_22', 'cosine between axis 2 and principal axis 2', '1'),
            ('a_23', 'cosine between axis 2 and principal axis 3', '1'),
            ('a_31', 'cosine between axis 3 and principal axis 1', '1'),
            ('a_32', 'cosine between axis 3 and principal axis 2', '1'),
            ('a_33', 'cosine between axis 3 and principal axis 3', '1'),
        ),
        (
            ('S', 'J_1 L_1 + J_2 L_2 + J_3 L_3', 'kg^3 m^6'),
        ),
    ),
    'bounds_of_products': (
        (
            ('I_1', 'principal moment of inertia', 'kg m^2'),
            ('I_2', 'principal moment of inertia', 'kg m^2'),
            ('I_3', 'principal moment of inertia', 'kg m^2'),
        ),
        (
            ('f_least', 'least J_1 J_2 J_3, about principal axes', 'kg^3 m^6'),
            ('f_greatest', 'greatest J_1 J_2 J_3, about axes of equal moments', 'kg^3 m^6'),
            ('S_least', 'least J_1 L_1 + J_2 L_2 + J_3 L_3, about principal axes', 'kg^3 m^6'),
        ),
    ),
    'distances_from_bounds': (
        (
            ('I_1', 'principal moment of inertia', 'kg m^2'),
            ('I_2', 'principal moment of inertia', 'kg m^2'),
            ('I_3', 'principal moment of inertia', 'kg m^2'),
            ('a_11', 'cosine between axis 1 and principal axis 1', '1'),
            ('a_12', 'cosine between axis 1 and principal axis 2', '1'),
            ('a_13', 'cosine between axis 1 and principal axis 3', '1'),
            ('a_21', 'cosine between axis 2 and principal axis 1', '1'),
            ('a_22', 'cosine between axis 2 and principal axis 2', '1'),
            ('a_23', 'cosine between axis 2 and principal axis 3', '1'),
            ('a_31', 'cosine between axis 3 and principal axis 1', '1'),
            ('a_32', 'cosine between axis 3 and principal axis 2', '1'),
            ('a_33', 'cosine between axis 3 and principal axis 3', '1'),
        ),
        (
            ('f_excess', 'J_1 J_2 J_3 - I_1 I_2 I_3', 'kg^3 m^6'),
            ('f_deficit', '((I_1 + I_2 + I_3)/3)^3 - J_1 J_2 J_3', 'kg^3 m^6'),
            ('S_excess', 'J_1 L_1 + J_2 L_2 + J_3 L_3 - 3 I_1 I_2 I_3', 'kg^3 m^6'),
        ),
    ),
    'bound_at_given_moment': (
        (
            ('I_1', 'principal moment of inertia', 'kg m^2'),
            ('I_2', 'principal moment of inertia', 'kg m^2'),
            ('I_3', 'principal moment of inertia', 'kg m^2'),
            ('J_2', 'moment of inertia about axis 2', 'kg m^2'),
        ),
        (
            ('f_1', 'greatest J_1 J_2 J_3', 'kg^3 m^6'),
        ),
    ),
    'product_of_two_axial_moments': (
        (
            ('I_1', 'principal moment of inertia', 'kg m^2'),
            ('I_2', 'principal moment of inertia', 'kg m^2'),
            ('I_3', 'principal moment of inertia', 'kg m^2'),
            ('a_11', 'cosine between axis 1 and principal axis 1', '1'),
            ('a_12', 'cosine between axis 1 and principal axis 2', '1'),
            ('a_13', 'cosine between axis 1 and principal axis 3', '1'),
            ('a_31', 'cosine between axis 3 and principal axis 1', '1'),
            ('a_32', 'cosine between axis 3 and principal axis 2', '1'),
            ('a_33', 'cosine between axis 3 and principal axis 3', '1'),
        ),
        (
            ('J_1_J_3', 'J_1 J_3', 'kg^2 m^4'),
        ),
    ),
    'product_with_second_moment': (
        (
            ('I_1', 'principal moment of inertia', 'kg m^2'),
            ('I_2', 'principal moment of inertia', 'kg m^2'),
            ('I_3', 'principal moment of inertia', 'kg m^2'),
            ('a_21', 'cosine between axis 2 and principal axis 1', '1'),
            ('a_22', 'cosine between axis 2 and principal axis 2', '1'),
            ('a_23', 'cosine between axis 2 and principal axis 3', '1'),
        ),
        (
            ('J_2_L_2', 'J_2 (I_1 I_2 a_23^2 + I_2 I_3 a_21^2 + I_3 I_1 a_22^2)', 'kg^3 m^6'),
        ),
    ),
    'damping_matrix': (
        (
            ('k_1', 'gain of the damping device along axis 1', 'N m s/rad'),
            ('k_2', 'gain of the damping device along axis 2', 'N m s/rad'),
            ('k_3', 'gain of the damping device along axis 3', 'N m s/rad'),
            ('a_11', 'cosine between axis 1 and principal axis 1', '1'),
            ('a_12', 'cosine between axis 1 and principal axis 2', '1'),
            ('a_13', 'cosine between axis 1 and principal axis 3', '1'),
            ('a_21', 'cosine between axis 2 and principal axis 1', '1'),
            ('a_22', 'cosine between axis 2 and principal axis 2', '1'),
            ('a_23', 'cosine between axis 2 and principal axis 3', '1'),
            ('a_31', 'cosine between axis 3 and principal axis 1', '1'),
            ('a_32', 'cosine between axis 3 and principal axis 2', '1'),
            ('a_33', 'cosine between axis 3 and principal axis 3', '1'),
        ),
        (
            ('m_11', 'entry 1, 1', 'N m s/rad'),
            ('m_12', 'entry 1, 2', 'N m s/rad'),
            ('m_13', 'entry 1, 3', 'N m s/rad'),
            ('m_22', 'entry 2, 2', 'N m s/rad'),
            ('m_23', 'entry 2, 3', 'N m s/rad'),
            ('m_33', 'entry 3, 3', 'N m s/rad'),
        ),
    ),
    'characteristic_coefficients': (
        (
            ('I_1', 'principal moment of inertia', 'kg m^2'),
            ('I_2', 'principal moment of inertia', 'kg m^2'),
            ('I_3', 'principal moment of inertia', 'kg m^2'),
            ('k_1', 'gain of the damping device along axis 1', 'N m s/rad'),
            ('k_2', 'gain of the damping device along axis 2', 'N m s/rad'),
            ('k_3', 'gain of the damping device along axis 3', 'N m s/rad'),
            ('a_11', 'cosine between axis 1 and principal axis 1', '1'),
            ('a_12', 'cosine between axis 1 and principal axis 2', '1'),
            ('a_13', 'cosine between axis 1 and principal axis 3', '1'),
            ('a_21', 'cosine between axis 2 and principal axis 1', '1'),
            ('a_22', 'cosine between axis 2 and principal axis 2', '1'),
            ('a_23', 'cosine between axis 2 and principal axis 3', '1'),
            ('a_31', 'cosine between axis 3 and principal axis 1', '1'),
            ('a_32', 'cosine between axis 3 and principal axis 2', '1'),
            ('a_33', 'cosine between axis 3 and principal axis 3', '1'),
        ),
        (
            ('c_3', 'coefficient of p^3, for orthogonal axes', 'kg^3 m^6'),
            ('c_2', 'coefficient of p^2, for orthogonal axes', 'kg^3 m^6/s'),
            ('c_1', 'coefficient of p^1, for orthogonal axes', 'kg^3 m^6/s^2'),
            ('c_0', 'coefficient of p^0, for orthogonal axes', 'kg^3 m^6/s^3'),
        ),
    ),
    'characteristic_coefficients_at_common_ratio': (
        (
            ('I_1', 'principal moment of inertia', 'kg m^2'),
            ('I_2', 'principal moment of inertia', 'kg m^2'),
            ('I_3', 'principal moment of inertia', 'kg m^2'),
            ('k', 'gains divided by the moments of inertia about their axes', '1/s'),
            ('a_11', 'cosine between axis 1 and principal axis 1', '1'),
            ('a_12', 'cosine between axis 1 and principal axis 2', '1'),
            ('a_13', 'cosine between axis 1 and principal axis 3', '1'),
            ('a_21', 'cosine between axis 2 and principal axis 1', '1'),
            ('a_22', 'cosine between axis 2 and principal axis 2', '1'),
            ('a_23', 'cosine between axis 2 and principal axis 3', '1'),
            ('a_31', 'cosine between axis 3 and principal axis 1', '1'),
            ('a_32', 'cosine between axis 3 and principal axis 2', '1'),
            ('a_33', 'cosine between axis 3 and principal axis 3', '1'),
        ),
        (
            ('c_3', 'coefficient of p^3, for gains k J_i', 'kg^3 m^6'),
            ('c_2', 'coefficient of p^2, for gains k J_i', 'kg^3 m^6/s'),
            ('c_1', 'coefficient of p^1, for gains k J_i', 'kg^3 m^6/s^2'),
            ('c_0', 'coefficient of p^0, for gains k J_i', 'kg^3 m^6/s^3'),
        ),
    ),
    'gains_in_proportion': (
        (
            ('k', 'gains divided by the moments of inertia about their axes', '1/s'),
            ('I_1', 'principal moment of inertia', 'kg m^2'),
            ('I_2', 'principal moment of inertia', 'kg m^2'),
            ('I_3', 'principal moment of inertia', 'kg m^2'),
            ('a_11', 'cosine between axis 1 and principal axis 1', '1'),
            ('a_12', 'cosine between axis 1 and principal axis 2', '1'),
            ('a_13', 'cosine between axis 1 and principal axis 3', '1'),
            ('a_21', 'cosine between axis 2 and principal axis 1', '1'),
            ('a_22', 'cosine between axis 2 and principal axis 2', '1'),
            ('a_23', 'cosine between axis 2 and principal axis 3', '1'),
            ('a_31', 'cosine between axis 3 and principal axis 1', '1'),
            ('a_32', 'cosine between axis 3 and principal axis 2', '1'),
            ('a_33', 'cosine between axis 3 and principal axis 3', '1'),
        ),
        (
            ('k_1', 'gain of the damping device along axis 1', 'N m s/rad'),
            ('k_2', 'gain of the damping device along axis 2', 'N m s/rad'),
            ('k_3', 'gain of the damping device along axis 3', 'N m s/rad'),
        ),
    ),
    'gain_of_rates': (
        (
            ('xi', 'least damping rate', '1/s'),
            ('s_1', 'rate 1 less the least one', '1/s'),
            ('s_2', 'rate 2 less the least one', '1/s'),
            ('s_3', 'rate 3 less the least one', '1/s'),
        ),
        (
            ('k', 'harmonic mean of the rates: the greatest stability degree for these gains', '1/s'),
            ('k_excess', 'k - xi', '1/s'),
        ),
    ),
    'stability_degree_in_pitch': (
        (
            ('k', 'gains divided by the moments of inertia about their axes', '1/s'),
            ('I_1', 'principal moment of inertia', 'kg m^2'),
            ('I_3', 'principal moment of inertia', 'kg m^2'),
            ('alpha', 'pitch', 'rad'),
        ),
        (
            ('xi', 'stability degree', '1/s'),
        ),
    ),
    'equal_moment_pitch': (
        (
            ('I_1', 'principal moment of inertia', 'kg m^2'),
            ('I_2', 'principal moment of inertia', 'kg m^2'),
            ('I_3', 'principal moment of inertia', 'kg m^2'),
        ),
        (
            ('alpha', 'pitch', 'rad'),
        ),
    ),
}


def direction_cosines(alpha, beta, gamma, out=None):
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

    Arguments:
        alpha: pitch, in rad; any number
        beta: yaw, in rad; any number
        gamma: roll, in rad; any number

    Returns a tuple:
        a_11: cosine between axis 1 and principal axis 1, a number
        a_12: cosine between axis 1 and principal axis 2, a number
        a_13: cosine between axis 1 and principal axis 3, a number
        a_21: cosine between axis 2 and principal axis 1, a number
        a_22: cosine between axis 2 and principal axis 2, a number
        a_23: cosine between axis 2 and principal axis 3, a number
        a_31: cosine between axis 3 and principal axis 1, a number
        a_32: cosine between axis 3 and principal axis 2, a number
        a_33: cosine between axis 3 and principal axis 3, a number

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 9 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 6 ulp over the domain. Where terms cancel, the error is in units of the last place of the largest of
    them.

    Rests on mirer2009:2.7.5 (sha256 83a8c2d03ec4), mirer2009:2.7.6 (sha256 8f13ceef2eb7), mirer2009:2.7.7 (sha256
    7e6c16e705d1), mirer2009:2.7.8 (sha256 4f5a6feccc69), mirer2009:2.7.9 (sha256 ea069919e801), mirer2009:2.7.10
    (sha256 08a921761314), mirer2009:2.7.11 (sha256 7b8a8163deea), mirer2009:2.7.12 (sha256 aae2b2a25553),
    mirer2009:2.7.13 (sha256 25956c4dfd04).
    """
    if out is None:
        try:
            if float is type(alpha) is type(beta) is type(gamma):
                return _direction_cosines(alpha, beta, gamma)
            if ndarray is type(alpha) is type(beta) is type(gamma) and DOUBLE is alpha.dtype is beta.dtype is gamma.dtype and () != alpha.shape == beta.shape == gamma.shape:
                size = alpha.size
                if 0 < size <= 2:
                    return evaluate_handful(_direction_cosines, (alpha, beta, gamma,))
                if size <= SMALL:
                    return _direction_cosines_block(alpha, beta, gamma)
                return evaluate_alike(_direction_cosines_block, 9, (0, 1, 2, 3, 4, 5, 6, 7, 8,), (alpha, beta, gamma,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_direction_cosines_block, 9, (0, 1, 2, 3, 4, 5, 6, 7, 8,), (alpha, beta, gamma,), out)


def _direction_cosines(alpha, beta, gamma):
    cos_alpha = math.cos(alpha)
    cos_beta = math.cos(beta)
    sin_alpha = math.sin(alpha)
    sin_gamma = math.sin(gamma)
    t1 = sin_alpha * sin_gamma
    sin_beta = math.sin(beta)
    cos_gamma = math.cos(gamma)
    t2 = cos_gamma * sin_alpha
    t3 = cos_alpha * sin_gamma
    return cos_alpha * cos_beta, t1 - (cos_gamma * (cos_alpha * sin_beta)), t2 + (sin_beta * t3), sin_beta, cos_beta * cos_gamma, -(cos_beta * sin_gamma), -(cos_beta * sin_alpha), (sin_beta * t2) + t3, (cos_alpha * cos_gamma) - (sin_beta * t1)


def _direction_cosines_block(alpha, beta, gamma, out_a_11=None, out_a_12=None, out_a_13=None, out_a_21=None, out_a_22=None, out_a_23=None, out_a_31=None, out_a_32=None, out_a_33=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None):
    r0 = cos(alpha, r0)  # cos_alpha
    r1 = cos(beta, r1)  # cos_beta
    r2 = sin(alpha, r2)  # sin_alpha
    r3 = sin(gamma, r3)  # sin_gamma
    r4 = multiply(r2, r3, r4)  # t1
    out_a_21 = sin(beta, out_a_21)  # sin_beta
    r5 = cos(gamma, r5)  # cos_gamma
    r6 = multiply(r5, r2, r6)  # t2
    r7 = multiply(r0, r3, r7)  # t3
    out_a_11 = multiply(r0, r1, out_a_11)  # t4
    r8 = multiply(r0, out_a_21, r8)  # t5
    r8 = multiply(r5, r8, r8)  # t6
    out_a_12 = subtract(r4, r8, out_a_12)  # t7
    r8 = multiply(out_a_21, r7, r8)  # t8
    out_a_13 = add(r6, r8, out_a_13)  # t9
    out_a_22 = multiply(r1, r5, out_a_22)  # t10
    r3 = multiply(r1, r3, r3)  # t11
    out_a_23 = negative(r3, out_a_23)  # t12
    r2 = multiply(r1, r2, r2)  # t13
    out_a_31 = negative(r2, out_a_31)  # t14
    r6 = multiply(out_a_21, r6, r6)  # t15
    out_a_32 = add(r6, r7, out_a_32)  # t16
    r5 = multiply(r0, r5, r5)  # t17
    r4 = multiply(out_a_21, r4, r4)  # t18
    out_a_33 = subtract(r5, r4, out_a_33)  # t19
    return out_a_11, out_a_12, out_a_13, out_a_21, out_a_22, out_a_23, out_a_31, out_a_32, out_a_33


def axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
    """Moments of inertia about three turned axes.

        J_1 = I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2
        J_2 = I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2
        J_3 = I_1*a_31**2 + I_2*a_32**2 + I_3*a_33**2

    Arguments:
        I_1: principal moment of inertia, in kg m^2; 0 < I_1
        I_2: principal moment of inertia, in kg m^2; 0 < I_2
        I_3: principal moment of inertia, in kg m^2; 0 < I_3
        a_11: cosine between axis 1 and principal axis 1, a number; -1 <= a_11 <= 1
        a_12: cosine between axis 1 and principal axis 2, a number; -1 <= a_12 <= 1
        a_13: cosine between axis 1 and principal axis 3, a number; -1 <= a_13 <= 1
        a_21: cosine between axis 2 and principal axis 1, a number; -1 <= a_21 <= 1
        a_22: cosine between axis 2 and principal axis 2, a number; -1 <= a_22 <= 1
        a_23: cosine between axis 2 and principal axis 3, a number; -1 <= a_23 <= 1
        a_31: cosine between axis 3 and principal axis 1, a number; -1 <= a_31 <= 1
        a_32: cosine between axis 3 and principal axis 2, a number; -1 <= a_32 <= 1
        a_33: cosine between axis 3 and principal axis 3, a number; -1 <= a_33 <= 1

    Returns a tuple:
        J_1: moment of inertia about axis 1, in kg m^2
        J_2: moment of inertia about axis 2, in kg m^2
        J_3: moment of inertia about axis 3, in kg m^2

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain.

    Rests on mirer2009:2.0.4 (sha256 433ac82c664e), mirer2009:1.4.1 (sha256 5629ced6590c).
    """
    if out is None:
        try:
            if float is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                return _axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
            if ndarray is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != I_1.shape == I_2.shape == I_3.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                size = I_1.size
                if 0 < size <= 5:
                    return evaluate_handful(_axial_moments, (I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
                if size <= SMALL:
                    return _axial_moments_block(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return evaluate_alike(_axial_moments_block, 3, (0, 1, 2,), (I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_axial_moments_block, 3, (0, 1, 2,), (I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)


def _axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
    return (I_3 * (a_13 * a_13)) + ((I_1 * (a_11 * a_11)) + (I_2 * (a_12 * a_12))), (I_3 * (a_23 * a_23)) + ((I_1 * (a_21 * a_21)) + (I_2 * (a_22 * a_22))), (I_3 * (a_33 * a_33)) + ((I_1 * (a_31 * a_31)) + (I_2 * (a_32 * a_32)))


def _axial_moments_block(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_J_1=None, out_J_2=None, out_J_3=None, r0=None, r1=None, r2=None):
    r0 = multiply(a_11, a_11, r0)  # a_11_squared
    r0 = multiply(I_1, r0, r0)  # t1
    r1 = multiply(a_12, a_12, r1)  # a_12_squared
    r1 = multiply(I_2, r1, r1)  # t2
    r2 = multiply(a_13, a_13, r2)  # a_13_squared
    r2 = multiply(I_3, r2, r2)  # t3
    r1 = add(r0, r1, r1)  # t4
    out_J_1 = add(r2, r1, out_J_1)  # t5
    r1 = multiply(a_21, a_21, r1)  # a_21_squared
    r1 = multiply(I_1, r1, r1)  # t6
    r2 = multiply(a_22, a_22, r2)  # a_22_squared
    r2 = multiply(I_2, r2, r2)  # t7
    r0 = multiply(a_23, a_23, r0)  # a_23_squared
    r0 = multiply(I_3, r0, r0)  # t8
    r2 = add(r1, r2, r2)  # t9
    out_J_2 = add(r0, r2, out_J_2)  # t10
    r2 = multiply(a_31, a_31, r2)  # a_31_squared
    r2 = multiply(I_1, r2, r2)  # t11
    r0 = multiply(a_32, a_32, r0)  # a_32_squared
    r0 = multiply(I_2, r0, r0)  # t12
    r1 = multiply(a_33, a_33, r1)  # a_33_squared
    r1 = multiply(I_3, r1, r1)  # t13
    r0 = add(r2, r0, r0)  # t14
    out_J_3 = add(r1, r0, out_J_3)  # t15
    return out_J_1, out_J_2, out_J_3


def second_order_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
    """The quadratic forms L_i of the adjugate of the inertia tensor, for three turned axes.

        L_1 = I_1*I_2*a_13**2 + I_1*I_3*a_12**2 + I_2*I_3*a_11**2
        L_2 = I_1*I_2*a_23**2 + I_1*I_3*a_22**2 + I_2*I_3*a_21**2
        L_3 = I_1*I_2*a_33**2 + I_1*I_3*a_32**2 + I_2*I_3*a_31**2

    Arguments:
        I_1: principal moment of inertia, in kg m^2; 0 < I_1
        I_2: principal moment of inertia, in kg m^2; 0 < I_2
        I_3: principal moment of inertia, in kg m^2; 0 < I_3
        a_11: cosine between axis 1 and principal axis 1, a number; -1 <= a_11 <= 1
        a_12: cosine between axis 1 and principal axis 2, a number; -1 <= a_12 <= 1
        a_13: cosine between axis 1 and principal axis 3, a number; -1 <= a_13 <= 1
        a_21: cosine between axis 2 and principal axis 1, a number; -1 <= a_21 <= 1
        a_22: cosine between axis 2 and principal axis 2, a number; -1 <= a_22 <= 1
        a_23: cosine between axis 2 and principal axis 3, a number; -1 <= a_23 <= 1
        a_31: cosine between axis 3 and principal axis 1, a number; -1 <= a_31 <= 1
        a_32: cosine between axis 3 and principal axis 2, a number; -1 <= a_32 <= 1
        a_33: cosine between axis 3 and principal axis 3, a number; -1 <= a_33 <= 1

    Returns a tuple:
        L_1: product of two moments, of axis 1, in kg^2 m^4
        L_2: product of two moments, of axis 2, in kg^2 m^4
        L_3: product of two moments, of axis 3, in kg^2 m^4

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain.

    Rests on mirer2009:1.3.2 (sha256 f55f08c0281c), mirer2009:1.3.3 (sha256 5dc933bd040b).
    """
    if out is None:
        try:
            if float is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                return _second_order_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
            if ndarray is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != I_1.shape == I_2.shape == I_3.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                size = I_1.size
                if 0 < size <= 6:
                    return evaluate_handful(_second_order_moments, (I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
                if size <= SMALL:
                    return _second_order_moments_block(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return evaluate_alike(_second_order_moments_block, 6, (0, 1, 2,), (I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_second_order_moments_block, 6, (0, 1, 2,), (I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)


def _second_order_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
    t1 = I_1 * I_2
    t2 = I_1 * I_3
    t3 = I_2 * I_3
    return ((a_13 * a_13) * t1) + (((a_11 * a_11) * t3) + ((a_12 * a_12) * t2)), ((a_23 * a_23) * t1) + (((a_22 * a_22) * t2) + ((a_21 * a_21) * t3)), ((a_33 * a_33) * t1) + (((a_31 * a_31) * t3) + ((a_32 * a_32) * t2))


def _second_order_moments_block(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_L_1=None, out_L_2=None, out_L_3=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None):
    r0 = multiply(I_1, I_2, r0)  # t1
    r1 = multiply(I_1, I_3, r1)  # t2
    r2 = multiply(I_2, I_3, r2)  # t3
    r3 = multiply(a_11, a_11, r3)  # a_11_squared
    r3 = multiply(r3, r2, r3)  # t4
    r4 = multiply(a_12, a_12, r4)  # a_12_squared
    r4 = multiply(r4, r1, r4)  # t5
    r5 = multiply(a_13, a_13, r5)  # a_13_squared
    r5 = multiply(r5, r0, r5)  # t6
    r4 = add(r3, r4, r4)  # t7
    out_L_1 = add(r5, r4, out_L_1)  # t8
    r4 = multiply(a_21, a_21, r4)  # a_21_squared
    r4 = multiply(r4, r2, r4)  # t9
    r5 = multiply(a_22, a_22, r5)  # a_22_squared
    r5 = multiply(r5, r1, r5)  # t10
    r3 = multiply(a_23, a_23, r3)  # a_23_squared
    r3 = multiply(r3, r0, r3)  # t11
    r4 = add(r5, r4, r4)  # t12
    out_L_2 = add(r3, r4, out_L_2)  # t13
    r4 = multiply(a_31, a_31, r4)  # a_31_squared
    r2 = multiply(r4, r2, r2)  # t14
    r4 = multiply(a_32, a_32, r4)  # a_32_squared
    r1 = multiply(r4, r1, r1)  # t15
    r4 = multiply(a_33, a_33, r4)  # a_33_squared
    r0 = multiply(r4, r0, r0)  # t16
    r1 = add(r2, r1, r1)  # t17
    out_L_3 = add(r0, r1, out_L_3)  # t18
    return out_L_1, out_L_2, out_L_3


def product_of_axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
    """The product f of the moments of inertia about three turned axes.

        f = (I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2)*(I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)*(I_1*a_31**2 + I_2*a_32**2 + I_3*a_33**2)

    Arguments:
        I_1: principal moment of inertia, in kg m^2; 0 < I_1
        I_2: principal moment of inertia, in kg m^2; 0 < I_2
        I_3: principal moment of inertia, in kg m^2; 0 < I_3
        a_11: cosine between axis 1 and principal axis 1, a number; -1 <= a_11 <= 1
        a_12: cosine between axis 1 and principal axis 2, a number; -1 <= a_12 <= 1
        a_13: cosine between axis 1 and principal axis 3, a number; -1 <= a_13 <= 1
        a_21: cosine between axis 2 and principal axis 1, a number; -1 <= a_21 <= 1
        a_22: cosine between axis 2 and principal axis 2, a number; -1 <= a_22 <= 1
        a_23: cosine between axis 2 and principal axis 3, a number; -1 <= a_23 <= 1
        a_31: cosine between axis 3 and principal axis 1, a number; -1 <= a_31 <= 1
        a_32: cosine between axis 3 and principal axis 2, a number; -1 <= a_32 <= 1
        a_33: cosine between axis 3 and principal axis 3, a number; -1 <= a_33 <= 1

    Returns:
        f: J_1 J_2 J_3, in kg^3 m^6

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 14 ulp over the domain. A product of sums keeps the roundings of all its factors, as many operations
    follow one another; its condition number is 9, so that arguments rounded to the nearest double change it by as
    many half units.

    Rests on mirer2009:2.1 (sha256 96cb35e8b636), mirer2009:2.13.4 (sha256 e9ade4ef247e).
    """
    if out is None:
        try:
            if float is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                return _product_of_axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
            if ndarray is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != I_1.shape == I_2.shape == I_3.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                size = I_1.size
                if 0 < size <= 8:
                    return evaluate_handful(_product_of_axial_moments, (I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
                if size <= SMALL:
                    return _product_of_axial_moments_block(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return evaluate_alike(_product_of_axial_moments_block, 5, (0,), (I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_product_of_axial_moments_block, 5, (0,), (I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)


def _product_of_axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
    t16 = ((I_3 * (a_23 * a_23)) + ((I_1 * (a_21 * a_21)) + (I_2 * (a_22 * a_22)))) * ((I_3 * (a_13 * a_13)) + ((I_1 * (a_11 * a_11)) + (I_2 * (a_12 * a_12))))
    return ((I_3 * (a_33 * a_33)) + ((I_1 * (a_31 * a_31)) + (I_2 * (a_32 * a_32)))) * t16


def _product_of_axial_moments_block(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_f=None, r0=None, r1=None, r2=None, r3=None, r4=None):
    r0 = multiply(a_11, a_11, r0)  # a_11_squared
    r0 = multiply(I_1, r0, r0)  # t1
    r1 = multiply(a_12, a_12, r1)  # a_12_squared
    r1 = multiply(I_2, r1, r1)  # t2
    r2 = multiply(a_13, a_13, r2)  # a_13_squared
    r2 = multiply(I_3, r2, r2)  # t3
    r1 = add(r0, r1, r1)  # t4
    r1 = add(r2, r1, r1)  # t5
    r2 = multiply(a_21, a_21, r2)  # a_21_squared
    r2 = multiply(I_1, r2, r2)  # t6
    r0 = multiply(a_22, a_22, r0)  # a_22_squared
    r0 = multiply(I_2, r0, r0)  # t7
    r3 = multiply(a_23, a_23, r3)  # a_23_squared
    r3 = multiply(I_3, r3, r3)  # t8
    r0 = add(r2, r0, r0)  # t9
    r0 = add(r3, r0, r0)  # t10
    r3 = multiply(a_31, a_31, r3)  # a_31_squared
    r3 = multiply(I_1, r3, r3)  # t11
    r2 = multiply(a_32, a_32, r2)  # a_32_squared
    r2 = multiply(I_2, r2, r2)  # t12
    r4 = multiply(a_33, a_33, r4)  # a_33_squared
    r4 = multiply(I_3, r4, r4)  # t13
    r2 = add(r3, r2, r2)  # t14
    r2 = add(r4, r2, r2)  # t15
    r1 = multiply(r0, r1, r1)  # t16
    out_f = multiply(r2, r1, out_f)  # t17
    return out_f


def sum_of_products(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
    """The sum of the products J_i L_i, the coefficient that decides how far the damping is from its optimum.

        S = (I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2)*(I_1*I_2*a_13**2 + I_1*I_3*a_12**2 + I_2*I_3*a_11**2) + (I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)*(I_1*I_2*a_23**2 + I_1*I_3*a_22**2 + I_2*I_3*a_21**2) + (I_1*a_31**2 + I_2*a_32**2 + I_3*a_33**2)*(I_1*I_2*a_33**2 + I_1*I_3*a_32**2 + I_2*I_3*a_31**2)

    Arguments:
        I_1: principal moment of inertia, in kg m^2; 0 < I_1
        I_2: principal moment of inertia, in kg m^2; 0 < I_2
        I_3: principal moment of inertia, in kg m^2; 0 < I_3
        a_11: cosine between axis 1 and principal axis 1, a number; -1 <= a_11 <= 1
        a_12: cosine between axis 1 and principal axis 2, a number; -1 <= a_12 <= 1
        a_13: cosine between axis 1 and principal axis 3, a number; -1 <= a_13 <= 1
        a_21: cosine between axis 2 and principal axis 1, a number; -1 <= a_21 <= 1
        a_22: cosine between axis 2 and principal axis 2, a number; -1 <= a_22 <= 1
        a_23: cosine between axis 2 and principal axis 3, a number; -1 <= a_23 <= 1
        a_31: cosine between axis 3 and principal axis 1, a number; -1 <= a_31 <= 1
        a_32: cosine between axis 3 and principal axis 2, a number; -1 <= a_32 <= 1
        a_33: cosine between axis 3 and principal axis 3, a number; -1 <= a_33 <= 1

    Returns:
        S: J_1 L_1 + J_2 L_2 + J_3 L_3, in kg^3 m^6

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 12 ulp over the domain. A product of sums keeps the roundings of all its factors, as many operations
    follow one another; its condition number is 7, so that arguments rounded to the nearest double change it by as
    many half units.

    Rests on mirer2009:2.18 (sha256 b56edba0ec5c), mirer2009:2.19.4 (sha256 b8cfa770eb92).
    """
    if out is None:
        try:
            if float is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                return _sum_of_products(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
            if ndarray is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != I_1.shape == I_2.shape == I_3.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                size = I_1.size
                if 0 < size <= 15:
                    return evaluate_handful(_sum_of_products, (I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
                if size <= SMALL:
                    return _sum_of_products_block(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return evaluate_alike(_sum_of_products_block, 15, (0,), (I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_sum_of_products_block, 15, (0,), (I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)


def _sum_of_products(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
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
    t14 = ((I_3 * a_13_squared) + ((I_2 * a_12_squared) + (I_1 * a_11_squared))) * ((a_13_squared * t1) + ((a_11_squared * t3) + (a_12_squared * t2)))
    t25 = ((a_21_squared * t3) + ((a_23_squared * t1) + (a_22_squared * t2))) * ((I_3 * a_23_squared) + ((I_1 * a_21_squared) + (I_2 * a_22_squared)))
    t36 = ((a_31_squared * t3) + ((a_32_squared * t2) + (a_33_squared * t1))) * ((I_3 * a_33_squared) + ((I_1 * a_31_squared) + (I_2 * a_32_squared)))
    return t36 + (t14 + t25)


def _sum_of_products_block(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_S=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None, r9=None, r10=None, r11=None, r12=None, r13=None, r14=None):
    r0 = multiply(a_11, a_11, r0)  # a_11_squared
    r1 = multiply(a_12, a_12, r1)  # a_12_squared
    r2 = multiply(a_13, a_13, r2)  # a_13_squared
    r3 = multiply(I_1, I_2, r3)  # t1
    r4 = multiply(I_1, I_3, r4)  # t2
    r5 = multiply(I_2, I_3, r5)  # t3
    r6 = multiply(a_21, a_21, r6)  # a_21_squared
    r7 = multiply(a_22, a_22, r7)  # a_22_squared
    r8 = multiply(a_23, a_23, r8)  # a_23_squared
    r9 = multiply(a_31, a_31, r9)  # a_31_squared
    r10 = multiply(a_32, a_32, r10)  # a_32_squared
    r11 = multiply(a_33, a_33, r11)  # a_33_squared
    r12 = multiply(r0, r5, r12)  # t4
    r13 = multiply(r1, r4, r13)  # t5
    r14 = multiply(r2, r3, r14)  # t6
    r13 = add(r12, r13, r13)  # t7
    r13 = add(r14, r13, r13)  # t8
    r0 = multiply(I_1, r0, r0)  # t9
    r1 = multiply(I_2, r1, r1)  # t10
    r2 = multiply(I_3, r2, r2)  # t11
    r0 = add(r1, r0, r0)  # t12
    r0 = add(r2, r0, r0)  # t13
    r13 = multiply(r0, r13, r13)  # t14
    r0 = multiply(r8, r3, r0)  # t15
    r2 = multiply(r7, r4, r2)  # t16
    r1 = multiply(r6, r5, r1)  # t17
    r2 = add(r0, r2, r2)  # t18
    r2 = add(r1, r2, r2)  # t19
    r6 = multiply(I_1, r6, r6)  # t20
    r7 = multiply(I_2, r7, r7)  # t21
    r8 = multiply(I_3, r8, r8)  # t22
    r7 = add(r6, r7, r7)  # t23
    r7 = add(r8, r7, r7)  # t24
    r7 = multiply(r2, r7, r7)  # t25
    r4 = multiply(r10, r4, r4)  # t26
    r3 = multiply(r11, r3, r3)  # t27
    r5 = multiply(r9, r5, r5)  # t28
    r3 = add(r4, r3, r3)  # t29
    r3 = add(r5, r3, r3)  # t30
    r9 = multiply(I_1, r9, r9)  # t31
    r10 = multiply(I_2, r10, r10)  # t32
    r11 = multiply(I_3, r11, r11)  # t33
    r10 = add(r9, r10, r10)  # t34
    r10 = add(r11, r10, r10)  # t35
    r10 = multiply(r3, r10, r10)  # t36
    r7 = add(r13, r7, r7)  # t37
    out_S = add(r10, r7, out_S)  # t38
    return out_S


def bounds_of_products(I_1, I_2, I_3, out=None):
    """The least and greatest product of moments about orthogonal axes, and the least sum of the products J_i L_i.

        f_least = I_1*I_2*I_3
        f_greatest = (I_1/3 + I_2/3 + I_3/3)**3
        S_least = 3*I_1*I_2*I_3

    Arguments:
        I_1: principal moment of inertia, in kg m^2; 0 < I_1
        I_2: principal moment of inertia, in kg m^2; 0 < I_2
        I_3: principal moment of inertia, in kg m^2; 0 < I_3

    Returns a tuple:
        f_least: least J_1 J_2 J_3, about principal axes, in kg^3 m^6
        f_greatest: greatest J_1 J_2 J_3, about axes of equal moments, in kg^3 m^6
        S_least: least J_1 L_1 + J_2 L_2 + J_3 L_3, about principal axes, in kg^3 m^6

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 9 ulp over the domain. A cube triples the error of the mean moment: its condition number is 3.

    Rests on mirer2009:2.1 (sha256 96cb35e8b636), mirer2009:2.3.7 (sha256 a4d42e35dcb0), mirer2009:2.18 (sha256
    b56edba0ec5c). The forms computed are proved equal to those shown (sha256 89ad4823d9b6).
    """
    if out is None:
        try:
            if float is type(I_1) is type(I_2) is type(I_3):
                return _bounds_of_products(I_1, I_2, I_3)
            if ndarray is type(I_1) is type(I_2) is type(I_3) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype and () != I_1.shape == I_2.shape == I_3.shape:
                size = I_1.size
                if 0 < size <= 1:
                    return evaluate_handful(_bounds_of_products, (I_1, I_2, I_3,))
                if size <= SMALL:
                    return _bounds_of_products_block(I_1, I_2, I_3)
                return evaluate_alike(_bounds_of_products_block, 2, (0, 1, 2,), (I_1, I_2, I_3,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_bounds_of_products_block, 2, (0, 1, 2,), (I_1, I_2, I_3,), out)


def _bounds_of_products(I_1, I_2, I_3):
    t2 = I_3 * (I_1 * I_2)
    t4 = I_3 + (I_1 + I_2)
    return t2, (1.0 / 27.0) * (t4 * (t4 * t4)), 3.0 * t2


def _bounds_of_products_block(I_1, I_2, I_3, out_f_least=None, out_f_greatest=None, out_S_least=None, r0=None, r1=None, n1_27=array(1.0 / 27.0), n3=array(3.0)):
    r0 = multiply(I_1, I_2, r0)  # t1
    out_f_least = multiply(I_3, r0, out_f_least)  # t2
    r0 = add(I_1, I_2, r0)  # t3
    r0 = add(I_3, r0, r0)  # t4
    r1 = multiply(r0, r0, r1)  # t5
    r1 = multiply(r0, r1, r1)  # t6
    out_f_greatest = multiply(n1_27, r1, out_f_greatest)  # t7
    out_S_least = multiply(n3, out_f_least, out_S_least)  # t8
    return out_f_least, out_f_greatest, out_S_least


def distances_from_bounds(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
    """How far J_1 J_2 J_3 and the sum of J_i L_i of orthogonal axes are from their bounds; never negative.

        f_excess = I_1*a_22**2*a_23**2*(I_2 - I_3)**2 + I_2*a_21**2*a_23**2*(-I_1 + I_3)**2 + I_3*a_21**2*a_22**2*(I_1 - I_2)**2 + (I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)*(I_1*a_11*a_31 + I_2*a_12*a_32 + I_3*a_13*a_33)**2
        f_deficit = (I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)*(I_1*a_11**2 - I_1*a_31**2 + I_2*a_12**2 - I_2*a_32**2 + I_3*a_13**2 - I_3*a_33**2)**2/4 + (-I_1*a_21**2 + I_1/3 - I_2*a_22**2 + I_2/3 - I_3*a_23**2 + I_3/3)**2*(I_1*a_11**2 + I_1*a_31**2 + I_1/3 + I_2*a_12**2 + I_2*a_32**2 + I_2/3 + I_3*a_13**2 + I_3*a_33**2 + I_3/3)/4
        S_excess = I_1*a_12**2*a_13**2*(I_2 - I_3)**2 + I_1*a_22**2*a_23**2*(I_2 - I_3)**2 + I_1*a_32**2*a_33**2*(I_2 - I_3)**2 + I_2*a_11**2*a_13**2*(-I_1 + I_3)**2 + I_2*a_21**2*a_23**2*(-I_1 + I_3)**2 + I_2*a_31**2*a_33**2*(-I_1 + I_3)**2 + I_3*a_11**2*a_12**2*(I_1 - I_2)**2 + I_3*a_21**2*a_22**2*(I_1 - I_2)**2 + I_3*a_31**2*a_32**2*(I_1 - I_2)**2

    Arguments:
        I_1: principal moment of inertia, in kg m^2; 0 < I_1
        I_2: principal moment of inertia, in kg m^2; 0 < I_2
        I_3: principal moment of inertia, in kg m^2; 0 < I_3
        a_11: cosine between axis 1 and principal axis 1, a number; -1 <= a_11 <= 1
        a_12: cosine between axis 1 and principal axis 2, a number; -1 <= a_12 <= 1
        a_13: cosine between axis 1 and principal axis 3, a number; -1 <= a_13 <= 1
        a_21: cosine between axis 2 and principal axis 1, a number; -1 <= a_21 <= 1
        a_22: cosine between axis 2 and principal axis 2, a number; -1 <= a_22 <= 1
        a_23: cosine between axis 2 and principal axis 3, a number; -1 <= a_23 <= 1
        a_31: cosine between axis 3 and principal axis 1, a number; -1 <= a_31 <= 1
        a_32: cosine between axis 3 and principal axis 2, a number; -1 <= a_32 <= 1
        a_33: cosine between axis 3 and principal axis 3, a number; -1 <= a_33 <= 1

    Returns a tuple:
        f_excess: J_1 J_2 J_3 - I_1 I_2 I_3, in kg^3 m^6
        f_deficit: ((I_1 + I_2 + I_3)/3)^3 - J_1 J_2 J_3, in kg^3 m^6
        S_excess: J_1 L_1 + J_2 L_2 + J_3 L_3 - 3 I_1 I_2 I_3, in kg^3 m^6

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 12 ulp over the domain. Sums of squares: near a bound they keep the digits that a difference loses.
    Within a square J_1 - J_3, the mean moment less J_2, and a product of inertia may cancel; the error is in
    units of the last place of what it were if they did not.

    Rests on mirer2009:2.13.4 (sha256 e9ade4ef247e), mirer2009:2.19.4 (sha256 b8cfa770eb92), mirer2009:2.2 (sha256
    c8d1ca2b73d8), mirer2009:2.1 (sha256 96cb35e8b636).
    """
    if out is None:
        try:
            if float is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                return _distances_from_bounds(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
            if ndarray is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != I_1.shape == I_2.shape == I_3.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                size = I_1.size
                if 0 < size <= 18:
                    return evaluate_handful(_distances_from_bounds, (I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
                if size <= SMALL:
                    return _distances_from_bounds_block(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return evaluate_alike(_distances_from_bounds_block, 19, (0, 1, 2,), (I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_distances_from_bounds_block, 19, (0, 1, 2,), (I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)


def _distances_from_bounds(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
    a_21_squared = a_21 * a_21
    a_22_squared = a_22 * a_22
    a_23_squared = a_23 * a_23
    t5 = (I_3 * a_23_squared) + ((I_1 * a_21_squared) + (I_2 * a_22_squared))
    t6 = -I_3
    t7 = I_2 + t6
    t9 = I_1 * (t7 * t7)
    t11 = -(I_1 + t6)
    t13 = I_2 * (t11 * t11)
    t14 = I_1 - I_2
    t16 = I_3 * (t14 * t14)
    t24 = ((a_22_squared * a_23_squared) * t9) + ((t16 * (a_21_squared * a_22_squared)) + (t13 * (a_21_squared * a_23_squared)))
    a_31_squared = a_31 * a_31
    t25 = I_1 * a_31_squared
    a_32_squared = a_32 * a_32
    t26 = I_2 * a_32_squared
    a_33_squared = a_33 * a_33
    t27 = I_3 * a_33_squared
    a_11_squared = a_11 * a_11
    a_12_squared = a_12 * a_12
    a_13_squared = a_13 * a_13
    t32 = (I_3 * a_13_squared) + ((I_1 * a_11_squared) + (I_2 * a_12_squared))
    t40 = (a_33 * (I_3 * a_13)) + ((a_31 * (I_1 * a_11)) + (a_32 * (I_2 * a_12)))
    t46 = ((t32 - t25) - t26) - t27
    t54 = ((1.0 / 3.0) * I_3) + (((1.0 / 3.0) * I_1) + ((1.0 / 3.0) * I_2))
    t55 = t54 - t5
    t63 = ((1.0 / 4.0) * ((t46 * t46) * t5)) + ((1.0 / 4.0) * ((t55 * t55) * (t32 + (t27 + (t26 + (t25 + t54))))))
    t77 = (a_31_squared * (a_33_squared * t13)) + (((a_32_squared * a_33_squared) * t9) + (a_31_squared * (a_32_squared * t16)))
    t80 = ((a_12_squared * a_13_squared) * t9) + ((t13 * (a_11_squared * a_13_squared)) + ((t16 * (a_11_squared * a_12_squared)) + t77))
    return t24 + ((t40 * t40) * t5), t63, t24 + t80


def _distances_from_bounds_block(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_f_excess=None, out_f_deficit=None, out_S_excess=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None, r9=None, r10=None, r11=None, r12=None, r13=None, r14=None, r15=None, r16=None, r17=None, r18=None, n1_4=array(1.0 / 4.0), n1_3=array(1.0 / 3.0)):
    r0 = multiply(a_21, a_21, r0)  # a_21_squared
    r1 = multiply(a_22, a_22, r1)  # a_22_squared
    r2 = multiply(a_23, a_23, r2)  # a_23_squared
    r3 = multiply(I_1, r0, r3)  # t1
    r4 = multiply(I_2, r1, r4)  # t2
    r5 = multiply(I_3, r2, r5)  # t3
    r4 = add(r3, r4, r4)  # t4
    r4 = add(r5, r4, r4)  # t5
    r5 = negative(I_3, r5)  # t6
    r3 = add(I_2, r5, r3)  # t7
    r3 = multiply(r3, r3, r3)  # t8
    r3 = multiply(I_1, r3, r3)  # t9
    r5 = add(I_1, r5, r5)  # t10
    r5 = negative(r5, r5)  # t11
    r5 = multiply(r5, r5, r5)  # t12
    r5 = multiply(I_2, r5, r5)  # t13
    r6 = subtract(I_1, I_2, r6)  # t14
    r6 = multiply(r6, r6, r6)  # t15
    r6 = multiply(I_3, r6, r6)  # t16
    r7 = multiply(r0, r1, r7)  # t17
    r7 = multiply(r6, r7, r7)  # t18
    r0 = multiply(r0, r2, r0)  # t19
    r0 = multiply(r5, r0, r0)  # t20
    r2 = multiply(r1, r2, r2)  # t21
    r2 = multiply(r2, r3, r2)  # t22
    r0 = add(r7, r0, r0)  # t23
    r0 = add(r2, r0, r0)  # t24
    r2 = multiply(a_31, a_31, r2)  # a_31_squared
    r7 = multiply(I_1, r2, r7)  # t25
    r1 = multiply(a_32, a_32, r1)  # a_32_squared
    r8 = multiply(I_2, r1, r8)  # t26
    r9 = multiply(a_33, a_33, r9)  # a_33_squared
    r10 = multiply(I_3, r9, r10)  # t27
    r11 = multiply(a_11, a_11, r11)  # a_11_squared
    r12 = multiply(a_12, a_12, r12)  # a_12_squared
    r13 = multiply(a_13, a_13, r13)  # a_13_squared
    r14 = multiply(I_1, r11, r14)  # t28
    r15 = multiply(I_2, r12, r15)  # t29
    r16 = multiply(I_3, r13, r16)  # t30
    r15 = add(r14, r15, r15)  # t31
    r15 = add(r16, r15, r15)  # t32
    r16 = multiply(I_1, a_11, r16)  # t33
    r16 = multiply(a_31, r16, r16)  # t34
    r14 = multiply(I_2, a_12, r14)  # t35
    r14 = multiply(a_32, r14, r14)  # t36
    r17 = multiply(I_3, a_13, r17)  # t37
    r17 = multiply(a_33, r17, r17)  # t38
    r14 = add(r16, r14, r14)  # t39
    r14 = add(r17, r14, r14)  # t40
    r14 = multiply(r14, r14, r14)  # t41
    r14 = multiply(r14, r4, r14)  # t42
    out_f_excess = add(r0, r14, out_f_excess)  # t43
    r14 = subtract(r15, r7, r14)  # t44
    r14 = subtract(r14, r8, r14)  # t45
    r14 = subtract(r14, r10, r14)  # t46
    r14 = multiply(r14, r14, r14)  # t47
    r14 = multiply(r14, r4, r14)  # t48
    r14 = multiply(n1_4, r14, r14)  # t49
    r17 = multiply(n1_3, I_1, r17)  # t50
    r16 = multiply(n1_3, I_2, r16)  # t51
    r18 = multiply(n1_3, I_3, r18)  # t52
    r16 = add(r17, r16, r16)  # t53
    r16 = add(r18, r16, r16)  # t54
    r4 = subtract(r16, r4, r4)  # t55
    r4 = multiply(r4, r4, r4)  # t56
    r16 = add(r7, r16, r16)  # t57
    r16 = add(r8, r16, r16)  # t58
    r16 = add(r10, r16, r16)  # t59
    r16 = add(r15, r16, r16)  # t60
    r16 = multiply(r4, r16, r16)  # t61
    r16 = multiply(n1_4, r16, r16)  # t62
    out_f_deficit = add(r14, r16, out_f_deficit)  # t63
    r16 = multiply(r1, r9, r16)  # t64
    r16 = multiply(r16, r3, r16)  # t65
    r1 = multiply(r1, r6, r1)  # t66
    r1 = multiply(r2, r1, r1)  # t67
    r9 = multiply(r9, r5, r9)  # t68
    r9 = multiply(r2, r9, r9)  # t69
    r2 = multiply(r11, r12, r2)  # t70
    r2 = multiply(r6, r2, r2)  # t71
    r11 = multiply(r11, r13, r11)  # t72
    r11 = multiply(r5, r11, r11)  # t73
    r13 = multiply(r12, r13, r13)  # t74
    r3 = multiply(r13, r3, r3)  # t75
    r1 = add(r16, r1, r1)  # t76
    r1 = add(r9, r1, r1)  # t77
    r1 = add(r2, r1, r1)  # t78
    r1 = add(r11, r1, r1)  # t79
    r1 = add(r3, r1, r1)  # t80
    out_S_excess = add(r0, r1, out_S_excess)  # t81
    return out_f_excess, out_f_deficit, out_S_excess


def bound_at_given_moment(I_1, I_2, I_3, J_2, out=None):
    """The greatest product J_1 J_2 J_3 of moments about orthogonal axes for a given J_2.

        f_1 = J_2*(I_1/2 + I_2/2 + I_3/2 - J_2/2)**2

    Arguments:
        I_1: principal moment of inertia, in kg m^2; 0 < I_1
        I_2: principal moment of inertia, in kg m^2; 0 < I_2
        I_3: principal moment of inertia, in kg m^2; 0 < I_3
        J_2: moment of inertia about axis 2, in kg m^2; 0 <= J_2 <= (I_1 + I_2 + I_3)/2

    Returns:
        f_1: greatest J_1 J_2 J_3, in kg^3 m^6

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. A square doubles the error of the two other moments, which are at least half
    of all three.

    Rests on mirer2009:2.2 (sha256 c8d1ca2b73d8).
    """
    if out is None:
        try:
            if float is type(I_1) is type(I_2) is type(I_3) is type(J_2):
                return _bound_at_given_moment(I_1, I_2, I_3, J_2)
            if ndarray is type(I_1) is type(I_2) is type(I_3) is type(J_2) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is J_2.dtype and () != I_1.shape == I_2.shape == I_3.shape == J_2.shape:
                size = I_1.size
                if 0 < size <= 1:
                    return evaluate_handful(_bound_at_given_moment, (I_1, I_2, I_3, J_2,))
                if size <= SMALL:
                    return _bound_at_given_moment_block(I_1, I_2, I_3, J_2)
                return evaluate_alike(_bound_at_given_moment_block, 4, (0,), (I_1, I_2, I_3, J_2,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_bound_at_given_moment_block, 4, (0,), (I_1, I_2, I_3, J_2,), out)


def _bound_at_given_moment(I_1, I_2, I_3, J_2):
    t7 = (((1.0 / 2.0) * I_3) + (((1.0 / 2.0) * I_1) + ((1.0 / 2.0) * I_2))) - ((1.0 / 2.0) * J_2)
    return J_2 * (t7 * t7)


def _bound_at_given_moment_block(I_1, I_2, I_3, J_2, out_f_1=None, r0=None, r1=None, r2=None, r3=None, n1_2=array(1.0 / 2.0)):
    r0 = multiply(n1_2, I_1, r0)  # t1
    r1 = multiply(n1_2, I_2, r1)  # t2
    r2 = multiply(n1_2, I_3, r2)  # t3
    r3 = multiply(n1_2, J_2, r3)  # t4
    r1 = add(r0, r1, r1)  # t5
    r1 = add(r2, r1, r1)  # t6
    r3 = subtract(r1, r3, r3)  # t7
    r3 = multiply(r3, r3, r3)  # t8
    out_f_1 = multiply(J_2, r3, out_f_1)  # t9
    return out_f_1


def product_of_two_axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_31, a_32, a_33, out=None):
    """The product of the moments of inertia about two axes.

        J_1_J_3 = (I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2)*(I_1*a_31**2 + I_2*a_32**2 + I_3*a_33**2)

    Arguments:
        I_1: principal moment of inertia, in kg m^2; 0 < I_1
        I_2: principal moment of inertia, in kg m^2; 0 < I_2
        I_3: principal moment of inertia, in kg m^2; 0 < I_3
        a_11: cosine between axis 1 and principal axis 1, a number; -1 <= a_11 <= 1
        a_12: cosine between axis 1 and principal axis 2, a number; -1 <= a_12 <= 1
        a_13: cosine between axis 1 and principal axis 3, a number; -1 <= a_13 <= 1
        a_31: cosine between axis 3 and principal axis 1, a number; -1 <= a_31 <= 1
        a_32: cosine between axis 3 and principal axis 2, a number; -1 <= a_32 <= 1
        a_33: cosine between axis 3 and principal axis 3, a number; -1 <= a_33 <= 1

    Returns:
        J_1_J_3: J_1 J_3, in kg^2 m^4

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 9 ulp over the domain. A product of sums keeps the roundings of all its factors, as many operations
    follow one another; its condition number is 6, so that arguments rounded to the nearest double change it by as
    many half units.

    Rests on mirer2009:2.11.3 (sha256 3c51b73d012a), mirer2009:2.12 (sha256 545d295f403b).
    """
    if out is None:
        try:
            if float is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_31) is type(a_32) is type(a_33):
                return _product_of_two_axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_31, a_32, a_33)
            if ndarray is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != I_1.shape == I_2.shape == I_3.shape == a_11.shape == a_12.shape == a_13.shape == a_31.shape == a_32.shape == a_33.shape:
                size = I_1.size
                if 0 < size <= 5:
                    return evaluate_handful(_product_of_two_axial_moments, (I_1, I_2, I_3, a_11, a_12, a_13, a_31, a_32, a_33,))
                if size <= SMALL:
                    return _product_of_two_axial_moments_block(I_1, I_2, I_3, a_11, a_12, a_13, a_31, a_32, a_33)
                return evaluate_alike(_product_of_two_axial_moments_block, 4, (0,), (I_1, I_2, I_3, a_11, a_12, a_13, a_31, a_32, a_33,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_product_of_two_axial_moments_block, 4, (0,), (I_1, I_2, I_3, a_11, a_12, a_13, a_31, a_32, a_33,), out)


def _product_of_two_axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_31, a_32, a_33):
    t11 = ((I_3 * (a_33 * a_33)) + ((I_1 * (a_31 * a_31)) + (I_2 * (a_32 * a_32)))) * ((I_3 * (a_13 * a_13)) + ((I_1 * (a_11 * a_11)) + (I_2 * (a_12 * a_12))))
    return t11


def _product_of_two_axial_moments_block(I_1, I_2, I_3, a_11, a_12, a_13, a_31, a_32, a_33, out_J_1_J_3=None, r0=None, r1=None, r2=None, r3=None):
    r0 = multiply(a_11, a_11, r0)  # a_11_squared
    r0 = multiply(I_1, r0, r0)  # t1
    r1 = multiply(a_12, a_12, r1)  # a_12_squared
    r1 = multiply(I_2, r1, r1)  # t2
    r2 = multiply(a_13, a_13, r2)  # a_13_squared
    r2 = multiply(I_3, r2, r2)  # t3
    r1 = add(r0, r1, r1)  # t4
    r1 = add(r2, r1, r1)  # t5
    r2 = multiply(a_31, a_31, r2)  # a_31_squared
    r2 = multiply(I_1, r2, r2)  # t6
    r0 = multiply(a_32, a_32, r0)  # a_32_squared
    r0 = multiply(I_2, r0, r0)  # t7
    r3 = multiply(a_33, a_33, r3)  # a_33_squared
    r3 = multiply(I_3, r3, r3)  # t8
    r0 = add(r2, r0, r0)  # t9
    r0 = add(r3, r0, r0)  # t10
    out_J_1_J_3 = multiply(r0, r1, out_J_1_J_3)  # t11
    return out_J_1_J_3


def product_with_second_moment(I_1, I_2, I_3, a_21, a_22, a_23, out=None):
    """The product of the moment of inertia J_2 and the form L_2 of the same axis.

        J_2_L_2 = (I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)*(I_1*I_2*a_23**2 + I_1*I_3*a_22**2 + I_2*I_3*a_21**2)

    Arguments:
        I_1: principal moment of inertia, in kg m^2; 0 < I_1
        I_2: principal moment of inertia, in kg m^2; 0 < I_2
        I_3: principal moment of inertia, in kg m^2; 0 < I_3
        a_21: cosine between axis 2 and principal axis 1, a number; -1 <= a_21 <= 1
        a_22: cosine between axis 2 and principal axis 2, a number; -1 <= a_22 <= 1
        a_23: cosine between axis 2 and principal axis 3, a number; -1 <= a_23 <= 1

    Returns:
        J_2_L_2: J_2 (I_1 I_2 a_23^2 + I_2 I_3 a_21^2 + I_3 I_1 a_22^2), in kg^3 m^6

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 10 ulp over the domain. A product of sums keeps the roundings of all its factors, as many operations
    follow one another; its condition number is 7, so that arguments rounded to the nearest double change it by as
    many half units.

    Rests on mirer2009:2.12.1 (sha256 0bd72d06e149), mirer2009:2.13 (sha256 43549f7163b3).
    """
    if out is None:
        try:
            if float is type(I_1) is type(I_2) is type(I_3) is type(a_21) is type(a_22) is type(a_23):
                return _product_with_second_moment(I_1, I_2, I_3, a_21, a_22, a_23)
            if ndarray is type(I_1) is type(I_2) is type(I_3) is type(a_21) is type(a_22) is type(a_23) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is a_21.dtype is a_22.dtype is a_23.dtype and () != I_1.shape == I_2.shape == I_3.shape == a_21.shape == a_22.shape == a_23.shape:
                size = I_1.size
                if 0 < size <= 6:
                    return evaluate_handful(_product_with_second_moment, (I_1, I_2, I_3, a_21, a_22, a_23,))
                if size <= SMALL:
                    return _product_with_second_moment_block(I_1, I_2, I_3, a_21, a_22, a_23)
                return evaluate_alike(_product_with_second_moment_block, 6, (0,), (I_1, I_2, I_3, a_21, a_22, a_23,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_product_with_second_moment_block, 6, (0,), (I_1, I_2, I_3, a_21, a_22, a_23,), out)


def _product_with_second_moment(I_1, I_2, I_3, a_21, a_22, a_23):
    a_21_squared = a_21 * a_21
    a_22_squared = a_22 * a_22
    a_23_squared = a_23 * a_23
    t13 = (I_3 * (I_2 * a_21_squared)) + ((I_2 * (I_1 * a_23_squared)) + (I_3 * (I_1 * a_22_squared)))
    return t13 * ((I_3 * a_23_squared) + ((I_1 * a_21_squared) + (I_2 * a_22_squared)))


def _product_with_second_moment_block(I_1, I_2, I_3, a_21, a_22, a_23, out_J_2_L_2=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None):
    r0 = multiply(a_21, a_21, r0)  # a_21_squared
    r1 = multiply(a_22, a_22, r1)  # a_22_squared
    r2 = multiply(a_23, a_23, r2)  # a_23_squared
    r3 = multiply(I_1, r0, r3)  # t1
    r4 = multiply(I_2, r1, r4)  # t2
    r5 = multiply(I_3, r2, r5)  # t3
    r4 = add(r3, r4, r4)  # t4
    r4 = add(r5, r4, r4)  # t5
    r2 = multiply(I_1, r2, r2)  # t6
    r2 = multiply(I_2, r2, r2)  # t7
    r1 = multiply(I_1, r1, r1)  # t8
    r1 = multiply(I_3, r1, r1)  # t9
    r0 = multiply(I_2, r0, r0)  # t10
    r0 = multiply(I_3, r0, r0)  # t11
    r1 = add(r2, r1, r1)  # t12
    r1 = add(r0, r1, r1)  # t13
    out_J_2_L_2 = multiply(r1, r4, out_J_2_L_2)  # t14
    return out_J_2_L_2


def damping_matrix(k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
    """The damping matrix of three devices in principal axes, on its diagonal and above; it is symmetric.

        m_11 = a_11**2*k_1 + a_21**2*k_2 + a_31**2*k_3
        m_12 = a_11*a_12*k_1 + a_21*a_22*k_2 + a_31*a_32*k_3
        m_13 = a_11*a_13*k_1 + a_21*a_23*k_2 + a_31*a_33*k_3
        m_22 = a_12**2*k_1 + a_22**2*k_2 + a_32**2*k_3
        m_23 = a_12*a_13*k_1 + a_22*a_23*k_2 + a_32*a_33*k_3
        m_33 = a_13**2*k_1 + a_23**2*k_2 + a_33**2*k_3

    Arguments:
        k_1: gain of the damping device along axis 1, in N m s/rad; 0 < k_1
        k_2: gain of the damping device along axis 2, in N m s/rad; 0 < k_2
        k_3: gain of the damping device along axis 3, in N m s/rad; 0 < k_3
        a_11: cosine between axis 1 and principal axis 1, a number; -1 <= a_11 <= 1
        a_12: cosine between axis 1 and principal axis 2, a number; -1 <= a_12 <= 1
        a_13: cosine between axis 1 and principal axis 3, a number; -1 <= a_13 <= 1
        a_21: cosine between axis 2 and principal axis 1, a number; -1 <= a_21 <= 1
        a_22: cosine between axis 2 and principal axis 2, a number; -1 <= a_22 <= 1
        a_23: cosine between axis 2 and principal axis 3, a number; -1 <= a_23 <= 1
        a_31: cosine between axis 3 and principal axis 1, a number; -1 <= a_31 <= 1
        a_32: cosine between axis 3 and principal axis 2, a number; -1 <= a_32 <= 1
        a_33: cosine between axis 3 and principal axis 3, a number; -1 <= a_33 <= 1

    Returns a tuple:
        m_11: entry 1, 1, in N m s/rad
        m_12: entry 1, 2, in N m s/rad
        m_13: entry 1, 3, in N m s/rad
        m_22: entry 2, 2, in N m s/rad
        m_23: entry 2, 3, in N m s/rad
        m_33: entry 3, 3, in N m s/rad

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 6 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain. Where terms cancel, the error is in units of the last place of the largest of
    them.

    Rests on mirer2009:1.2.6 (sha256 6d5ed42cccc0), mirer2009:1.2.12 (sha256 3363a6b3e5b0).
    """
    if out is None:
        try:
            if float is type(k_1) is type(k_2) is type(k_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                return _damping_matrix(k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
            if ndarray is type(k_1) is type(k_2) is type(k_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is k_1.dtype is k_2.dtype is k_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != k_1.shape == k_2.shape == k_3.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                size = k_1.size
                if 0 < size <= 8:
                    return evaluate_handful(_damping_matrix, (k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
                if size <= SMALL:
                    return _damping_matrix_block(k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return evaluate_alike(_damping_matrix_block, 6, (0, 1, 2, 3, 4, 5,), (k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_damping_matrix_block, 6, (0, 1, 2, 3, 4, 5,), (k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)


def _damping_matrix(k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
    t1 = a_11 * k_1
    t2 = a_21 * k_2
    t3 = a_31 * k_3
    return ((a_31 * a_31) * k_3) + (((a_11 * a_11) * k_1) + ((a_21 * a_21) * k_2)), (a_32 * t3) + ((a_22 * t2) + (a_12 * t1)), (a_33 * t3) + ((a_13 * t1) + (a_23 * t2)), ((a_32 * a_32) * k_3) + (((a_12 * a_12) * k_1) + ((a_22 * a_22) * k_2)), (k_3 * (a_32 * a_33)) + ((k_1 * (a_12 * a_13)) + (k_2 * (a_22 * a_23))), ((a_33 * a_33) * k_3) + (((a_13 * a_13) * k_1) + ((a_23 * a_23) * k_2))


def _damping_matrix_block(k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_m_11=None, out_m_12=None, out_m_13=None, out_m_22=None, out_m_23=None, out_m_33=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None):
    r0 = multiply(a_11, k_1, r0)  # t1
    r1 = multiply(a_21, k_2, r1)  # t2
    r2 = multiply(a_31, k_3, r2)  # t3
    r3 = multiply(a_11, a_11, r3)  # a_11_squared
    r3 = multiply(r3, k_1, r3)  # t4
    r4 = multiply(a_21, a_21, r4)  # a_21_squared
    r4 = multiply(r4, k_2, r4)  # t5
    r5 = multiply(a_31, a_31, r5)  # a_31_squared
    r5 = multiply(r5, k_3, r5)  # t6
    r4 = add(r3, r4, r4)  # t7
    out_m_11 = add(r5, r4, out_m_11)  # t8
    r4 = multiply(a_12, r0, r4)  # t9
    r5 = multiply(a_22, r1, r5)  # t10
    r3 = multiply(a_32, r2, r3)  # t11
    r4 = add(r5, r4, r4)  # t12
    out_m_12 = add(r3, r4, out_m_12)  # t13
    r0 = multiply(a_13, r0, r0)  # t14
    r1 = multiply(a_23, r1, r1)  # t15
    r2 = multiply(a_33, r2, r2)  # t16
    r1 = add(r0, r1, r1)  # t17
    out_m_13 = add(r2, r1, out_m_13)  # t18
    r1 = multiply(a_12, a_12, r1)  # a_12_squared
    r1 = multiply(r1, k_1, r1)  # t19
    r2 = multiply(a_22, a_22, r2)  # a_22_squared
    r2 = multiply(r2, k_2, r2)  # t20
    r0 = multiply(a_32, a_32, r0)  # a_32_squared
    r0 = multiply(r0, k_3, r0)  # t21
    r2 = add(r1, r2, r2)  # t22
    out_m_22 = add(r0, r2, out_m_22)  # t23
    r2 = multiply(a_12, a_13, r2)  # t24
    r2 = multiply(k_1, r2, r2)  # t25
    r0 = multiply(a_22, a_23, r0)  # t26
    r0 = multiply(k_2, r0, r0)  # t27
    r1 = multiply(a_32, a_33, r1)  # t28
    r1 = multiply(k_3, r1, r1)  # t29
    r0 = add(r2, r0, r0)  # t30
    out_m_23 = add(r1, r0, out_m_23)  # t31
    r0 = multiply(a_13, a_13, r0)  # a_13_squared
    r0 = multiply(r0, k_1, r0)  # t32
    r1 = multiply(a_23, a_23, r1)  # a_23_squared
    r1 = multiply(r1, k_2, r1)  # t33
    r2 = multiply(a_33, a_33, r2)  # a_33_squared
    r2 = multiply(r2, k_3, r2)  # t34
    r1 = add(r0, r1, r1)  # t35
    out_m_33 = add(r2, r1, out_m_33)  # t36
    return out_m_11, out_m_12, out_m_13, out_m_22, out_m_23, out_m_33


def characteristic_coefficients(I_1, I_2, I_3, k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
    """Coefficients of the characteristic equation (1.3) of the damped rotation.

        c_3 = I_1*I_2*I_3
        c_2 = k_1*(I_1*I_2*a_13**2 + I_1*I_3*a_12**2 + I_2*I_3*a_11**2) + k_2*(I_1*I_2*a_23**2 + I_1*I_3*a_22**2 + I_2*I_3*a_21**2) + k_3*(I_1*I_2*a_33**2 + I_1*I_3*a_32**2 + I_2*I_3*a_31**2)
        c_1 = k_1*k_2*(I_1*a_31**2 + I_2*a_32**2 + I_3*a_33**2) + k_1*k_3*(I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2) + k_2*k_3*(I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2)
        c_0 = k_1*k_2*k_3

    Arguments:
        I_1: principal moment of inertia, in kg m^2; 0 < I_1
        I_2: principal moment of inertia, in kg m^2; 0 < I_2
        I_3: principal moment of inertia, in kg m^2; 0 < I_3
        k_1: gain of the damping device along axis 1, in N m s/rad; 0 < k_1
        k_2: gain of the damping device along axis 2, in N m s/rad; 0 < k_2
        k_3: gain of the damping device along axis 3, in N m s/rad; 0 < k_3
        a_11: cosine between axis 1 and principal axis 1, a number; -1 <= a_11 <= 1
        a_12: cosine between axis 1 and principal axis 2, a number; -1 <= a_12 <= 1
        a_13: cosine between axis 1 and principal axis 3, a number; -1 <= a_13 <= 1
        a_21: cosine between axis 2 and principal axis 1, a number; -1 <= a_21 <= 1
        a_22: cosine between axis 2 and principal axis 2, a number; -1 <= a_22 <= 1
        a_23: cosine between axis 2 and principal axis 3, a number; -1 <= a_23 <= 1
        a_31: cosine between axis 3 and principal axis 1, a number; -1 <= a_31 <= 1
        a_32: cosine between axis 3 and principal axis 2, a number; -1 <= a_32 <= 1
        a_33: cosine between axis 3 and principal axis 3, a number; -1 <= a_33 <= 1

    Returns a tuple:
        c_3: coefficient of p^3, for orthogonal axes, in kg^3 m^6
        c_2: coefficient of p^2, for orthogonal axes, in kg^3 m^6/s
        c_1: coefficient of p^1, for orthogonal axes, in kg^3 m^6/s^2
        c_0: coefficient of p^0, for orthogonal axes, in kg^3 m^6/s^3

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 4 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. A product of sums keeps the roundings of all its factors, as many operations
    follow one another; its condition number is 5, so that arguments rounded to the nearest double change it by as
    many half units.

    Rests on mirer2009:1.3 (sha256 f08642819e8b), mirer2009:1.3.2 (sha256 f55f08c0281c), mirer2009:1.3.3 (sha256
    5dc933bd040b).
    """
    if out is None:
        try:
            if float is type(I_1) is type(I_2) is type(I_3) is type(k_1) is type(k_2) is type(k_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                return _characteristic_coefficients(I_1, I_2, I_3, k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
            if ndarray is type(I_1) is type(I_2) is type(I_3) is type(k_1) is type(k_2) is type(k_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is k_1.dtype is k_2.dtype is k_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != I_1.shape == I_2.shape == I_3.shape == k_1.shape == k_2.shape == k_3.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                size = I_1.size
                if 0 < size <= 12:
                    return evaluate_handful(_characteristic_coefficients, (I_1, I_2, I_3, k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
                if size <= SMALL:
                    return _characteristic_coefficients_block(I_1, I_2, I_3, k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return evaluate_alike(_characteristic_coefficients_block, 17, (0, 1, 2, 3,), (I_1, I_2, I_3, k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_characteristic_coefficients_block, 17, (0, 1, 2, 3,), (I_1, I_2, I_3, k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)


def _characteristic_coefficients(I_1, I_2, I_3, k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
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
    t24 = (k_1 * ((a_11_squared * t3) + ((a_13_squared * t1) + (a_12_squared * t2)))) + (k_2 * ((a_21_squared * t3) + ((a_23_squared * t1) + (a_22_squared * t2))))
    t46 = (((I_3 * a_23_squared) + ((I_1 * a_21_squared) + (I_2 * a_22_squared))) * (k_1 * k_3)) + (((I_3 * a_13_squared) + ((I_1 * a_11_squared) + (I_2 * a_12_squared))) * (k_2 * k_3))
    return I_3 * t1, (k_3 * ((a_31_squared * t3) + ((a_33_squared * t1) + (a_32_squared * t2)))) + t24, (t4 * ((I_3 * a_33_squared) + ((I_1 * a_31_squared) + (I_2 * a_32_squared)))) + t46, k_3 * t4


def _characteristic_coefficients_block(I_1, I_2, I_3, k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_c_3=None, out_c_2=None, out_c_1=None, out_c_0=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None, r9=None, r10=None, r11=None, r12=None, r13=None, r14=None, r15=None, r16=None):
    r0 = multiply(I_1, I_2, r0)  # t1
    r1 = multiply(a_13, a_13, r1)  # a_13_squared
    r2 = multiply(a_12, a_12, r2)  # a_12_squared
    r3 = multiply(I_1, I_3, r3)  # t2
    r4 = multiply(a_11, a_11, r4)  # a_11_squared
    r5 = multiply(I_2, I_3, r5)  # t3
    r6 = multiply(a_23, a_23, r6)  # a_23_squared
    r7 = multiply(a_22, a_22, r7)  # a_22_squared
    r8 = multiply(a_21, a_21, r8)  # a_21_squared
    r9 = multiply(a_33, a_33, r9)  # a_33_squared
    r10 = multiply(a_32, a_32, r10)  # a_32_squared
    r11 = multiply(a_31, a_31, r11)  # a_31_squared
    r12 = multiply(k_1, k_2, r12)  # t4
    out_c_3 = multiply(I_3, r0, out_c_3)  # t5
    r13 = multiply(r1, r0, r13)  # t6
    r14 = multiply(r2, r3, r14)  # t7
    r15 = multiply(r4, r5, r15)  # t8
    r14 = add(r13, r14, r14)  # t9
    r14 = add(r15, r14, r14)  # t10
    r14 = multiply(k_1, r14, r14)  # t11
    r15 = multiply(r6, r0, r15)  # t12
    r13 = multiply(r7, r3, r13)  # t13
    r16 = multiply(r8, r5, r16)  # t14
    r13 = add(r15, r13, r13)  # t15
    r13 = add(r16, r13, r13)  # t16
    r13 = multiply(k_2, r13, r13)  # t17
    r0 = multiply(r9, r0, r0)  # t18
    r3 = multiply(r10, r3, r3)  # t19
    r5 = multiply(r11, r5, r5)  # t20
    r3 = add(r0, r3, r3)  # t21
    r3 = add(r5, r3, r3)  # t22
    r3 = multiply(k_3, r3, r3)  # t23
    r13 = add(r14, r13, r13)  # t24
    out_c_2 = add(r3, r13, out_c_2)  # t25
    r8 = multiply(I_1, r8, r8)  # t26
    r7 = multiply(I_2, r7, r7)  # t27
    r6 = multiply(I_3, r6, r6)  # t28
    r7 = add(r8, r7, r7)  # t29
    r7 = add(r6, r7, r7)  # t30
    r6 = multiply(k_1, k_3, r6)  # t31
    r6 = multiply(r7, r6, r6)  # t32
    r4 = multiply(I_1, r4, r4)  # t33
    r2 = multiply(I_2, r2, r2)  # t34
    r1 = multiply(I_3, r1, r1)  # t35
    r2 = add(r4, r2, r2)  # t36
    r2 = add(r1, r2, r2)  # t37
    r1 = multiply(k_2, k_3, r1)  # t38
    r1 = multiply(r2, r1, r1)  # t39
    r11 = multiply(I_1, r11, r11)  # t40
    r10 = multiply(I_2, r10, r10)  # t41
    r9 = multiply(I_3, r9, r9)  # t42
    r10 = add(r11, r10, r10)  # t43
    r10 = add(r9, r10, r10)  # t44
    r10 = multiply(r12, r10, r10)  # t45
    r1 = add(r6, r1, r1)  # t46
    out_c_1 = add(r10, r1, out_c_1)  # t47
    out_c_0 = multiply(k_3, r12, out_c_0)  # t48
    return out_c_3, out_c_2, out_c_1, out_c_0


def characteristic_coefficients_at_common_ratio(I_1, I_2, I_3, k, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
    """Coefficients of the characteristic equation (1.5): gains in proportion to the moments about their axes.

        c_3 = I_1*I_2*I_3
        c_2 = k*((I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2)*(I_1*I_2*a_13**2 + I_1*I_3*a_12**2 + I_2*I_3*a_11**2) + (I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)*(I_1*I_2*a_23**2 + I_1*I_3*a_22**2 + I_2*I_3*a_21**2) + (I_1*a_31**2 + I_2*a_32**2 + I_3*a_33**2)*(I_1*I_2*a_33**2 + I_1*I_3*a_32**2 + I_2*I_3*a_31**2))
        c_1 = 3*k**2*(I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2)*(I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)*(I_1*a_31**2 + I_2*a_32**2 + I_3*a_33**2)
        c_0 = k**3*(I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2)*(I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)*(I_1*a_31**2 + I_2*a_32**2 + I_3*a_33**2)

    Arguments:
        I_1: principal moment of inertia, in kg m^2; 0 < I_1
        I_2: principal moment of inertia, in kg m^2; 0 < I_2
        I_3: principal moment of inertia, in kg m^2; 0 < I_3
        k: gains divided by the moments of inertia about their axes, in 1/s; 0 < k
        a_11: cosine between axis 1 and principal axis 1, a number; -1 <= a_11 <= 1
        a_12: cosine between axis 1 and principal axis 2, a number; -1 <= a_12 <= 1
        a_13: cosine between axis 1 and principal axis 3, a number; -1 <= a_13 <= 1
        a_21: cosine between axis 2 and principal axis 1, a number; -1 <= a_21 <= 1
        a_22: cosine between axis 2 and principal axis 2, a number; -1 <= a_22 <= 1
        a_23: cosine between axis 2 and principal axis 3, a number; -1 <= a_23 <= 1
        a_31: cosine between axis 3 and principal axis 1, a number; -1 <= a_31 <= 1
        a_32: cosine between axis 3 and principal axis 2, a number; -1 <= a_32 <= 1
        a_33: cosine between axis 3 and principal axis 3, a number; -1 <= a_33 <= 1

    Returns a tuple:
        c_3: coefficient of p^3, for gains k J_i, in kg^3 m^6
        c_2: coefficient of p^2, for gains k J_i, in kg^3 m^6/s
        c_1: coefficient of p^1, for gains k J_i, in kg^3 m^6/s^2
        c_0: coefficient of p^0, for gains k J_i, in kg^3 m^6/s^3

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 4 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 16 ulp over the domain. A product of sums keeps the roundings of all its factors, as many operations
    follow one another; its condition number is 12, so that arguments rounded to the nearest double change it by
    as many half units.

    Rests on mirer2009:1.5 (sha256 3b17564964dd), mirer2009:1.3.3 (sha256 5dc933bd040b).
    """
    if out is None:
        try:
            if float is type(I_1) is type(I_2) is type(I_3) is type(k) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                return _characteristic_coefficients_at_common_ratio(I_1, I_2, I_3, k, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
            if ndarray is type(I_1) is type(I_2) is type(I_3) is type(k) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is k.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != I_1.shape == I_2.shape == I_3.shape == k.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                size = I_1.size
                if 0 < size <= 12:
                    return evaluate_handful(_characteristic_coefficients_at_common_ratio, (I_1, I_2, I_3, k, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
                if size <= SMALL:
                    return _characteristic_coefficients_at_common_ratio_block(I_1, I_2, I_3, k, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return evaluate_alike(_characteristic_coefficients_at_common_ratio_block, 17, (0, 1, 2, 3,), (I_1, I_2, I_3, k, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_characteristic_coefficients_at_common_ratio_block, 17, (0, 1, 2, 3,), (I_1, I_2, I_3, k, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)


def _characteristic_coefficients_at_common_ratio(I_1, I_2, I_3, k, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
    t1 = I_1 * I_2
    a_11_squared = a_11 * a_11
    a_12_squared = a_12 * a_12
    a_13_squared = a_13 * a_13
    t6 = (I_3 * a_13_squared) + ((I_1 * a_11_squared) + (I_2 * a_12_squared))
    t7 = I_1 * I_3
    t8 = I_2 * I_3
    a_21_squared = a_21 * a_21
    a_22_squared = a_22 * a_22
    a_23_squared = a_23 * a_23
    t13 = (I_3 * a_23_squared) + ((I_2 * a_22_squared) + (I_1 * a_21_squared))
    a_31_squared = a_31 * a_31
    a_32_squared = a_32 * a_32
    a_33_squared = a_33 * a_33
    t18 = (I_3 * a_33_squared) + ((I_1 * a_31_squared) + (I_2 * a_32_squared))
    t20 = (t13 * t18) * t6
    t40 = (t13 * ((a_21_squared * t8) + ((a_23_squared * t1) + (a_22_squared * t7)))) + (t18 * ((a_32_squared * t7) + ((a_33_squared * t1) + (a_31_squared * t8))))
    k_squared = k * k
    return I_3 * t1, k * ((((a_12_squared * t7) + ((a_13_squared * t1) + (a_11_squared * t8))) * t6) + t40), 3.0 * (k_squared * t20), t20 * (k * k_squared)


def _characteristic_coefficients_at_common_ratio_block(I_1, I_2, I_3, k, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_c_3=None, out_c_2=None, out_c_1=None, out_c_0=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None, r9=None, r10=None, r11=None, r12=None, r13=None, r14=None, r15=None, r16=None, n3=array(3.0)):
    r0 = multiply(I_1, I_2, r0)  # t1
    r1 = multiply(a_11, a_11, r1)  # a_11_squared
    r2 = multiply(a_12, a_12, r2)  # a_12_squared
    r3 = multiply(a_13, a_13, r3)  # a_13_squared
    r4 = multiply(I_1, r1, r4)  # t2
    r5 = multiply(I_2, r2, r5)  # t3
    r6 = multiply(I_3, r3, r6)  # t4
    r5 = add(r4, r5, r5)  # t5
    r5 = add(r6, r5, r5)  # t6
    r6 = multiply(I_1, I_3, r6)  # t7
    r4 = multiply(I_2, I_3, r4)  # t8
    r7 = multiply(a_21, a_21, r7)  # a_21_squared
    r8 = multiply(a_22, a_22, r8)  # a_22_squared
    r9 = multiply(a_23, a_23, r9)  # a_23_squared
    r10 = multiply(I_1, r7, r10)  # t9
    r11 = multiply(I_2, r8, r11)  # t10
    r12 = multiply(I_3, r9, r12)  # t11
    r10 = add(r11, r10, r10)  # t12
    r10 = add(r12, r10, r10)  # t13
    r12 = multiply(a_31, a_31, r12)  # a_31_squared
    r11 = multiply(a_32, a_32, r11)  # a_32_squared
    r13 = multiply(a_33, a_33, r13)  # a_33_squared
    r14 = multiply(I_1, r12, r14)  # t14
    r15 = multiply(I_2, r11, r15)  # t15
    r16 = multiply(I_3, r13, r16)  # t16
    r15 = add(r14, r15, r15)  # t17
    r15 = add(r16, r15, r15)  # t18
    r16 = multiply(r10, r15, r16)  # t19
    r16 = multiply(r16, r5, r16)  # t20
    out_c_3 = multiply(I_3, r0, out_c_3)  # t21
    r9 = multiply(r9, r0, r9)  # t22
    r8 = multiply(r8, r6, r8)  # t23
    r7 = multiply(r7, r4, r7)  # t24
    r8 = add(r9, r8, r8)  # t25
    r8 = add(r7, r8, r8)  # t26
    r8 = multiply(r10, r8, r8)  # t27
    r13 = multiply(r13, r0, r13)  # t28
    r12 = multiply(r12, r4, r12)  # t29
    r11 = multiply(r11, r6, r11)  # t30
    r12 = add(r13, r12, r12)  # t31
    r12 = add(r11, r12, r12)  # t32
    r12 = multiply(r15, r12, r12)  # t33
    r0 = multiply(r3, r0, r0)  # t34
    r4 = multiply(r1, r4, r4)  # t35
    r6 = multiply(r2, r6, r6)  # t36
    r4 = add(r0, r4, r4)  # t37
    r4 = add(r6, r4, r4)  # t38
    r5 = multiply(r4, r5, r5)  # t39
    r12 = add(r8, r12, r12)  # t40
    r12 = add(r5, r12, r12)  # t41
    out_c_2 = multiply(k, r12, out_c_2)  # t42
    r12 = multiply(k, k, r12)  # k_squared
    r5 = multiply(r12, r16, r5)  # t43
    out_c_1 = multiply(n3, r5, out_c_1)  # t44
    r12 = multiply(k, r12, r12)  # t45
    out_c_0 = multiply(r16, r12, out_c_0)  # t46
    return out_c_3, out_c_2, out_c_1, out_c_0


def gains_in_proportion(k, I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
    """Gains in proportion to the moments of inertia about their axes; along principal axes k is the stability degree.

        k_1 = k*(I_1*a_11**2 + I_2*a_12**2 + I_3*a_13**2)
        k_2 = k*(I_1*a_21**2 + I_2*a_22**2 + I_3*a_23**2)
        k_3 = k*(I_1*a_31**2 + I_2*a_32**2 + I_3*a_33**2)

    Arguments:
        k: gains divided by the moments of inertia about their axes, in 1/s; 0 < k
        I_1: principal moment of inertia, in kg m^2; 0 < I_1
        I_2: principal moment of inertia, in kg m^2; 0 < I_2
        I_3: principal moment of inertia, in kg m^2; 0 < I_3
        a_11: cosine between axis 1 and principal axis 1, a number; -1 <= a_11 <= 1
        a_12: cosine between axis 1 and principal axis 2, a number; -1 <= a_12 <= 1
        a_13: cosine between axis 1 and principal axis 3, a number; -1 <= a_13 <= 1
        a_21: cosine between axis 2 and principal axis 1, a number; -1 <= a_21 <= 1
        a_22: cosine between axis 2 and principal axis 2, a number; -1 <= a_22 <= 1
        a_23: cosine between axis 2 and principal axis 3, a number; -1 <= a_23 <= 1
        a_31: cosine between axis 3 and principal axis 1, a number; -1 <= a_31 <= 1
        a_32: cosine between axis 3 and principal axis 2, a number; -1 <= a_32 <= 1
        a_33: cosine between axis 3 and principal axis 3, a number; -1 <= a_33 <= 1

    Returns a tuple:
        k_1: gain of the damping device along axis 1, in N m s/rad
        k_2: gain of the damping device along axis 2, in N m s/rad
        k_3: gain of the damping device along axis 3, in N m s/rad

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain.

    Rests on mirer2009:1.5 (sha256 3b17564964dd), mirer2009:1.8 (sha256 940f5957d1cf), mirer2009:1.8.1 (sha256
    6dfe84901600).
    """
    if out is None:
        try:
            if float is type(k) is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                return _gains_in_proportion(k, I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
            if ndarray is type(k) is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is k.dtype is I_1.dtype is I_2.dtype is I_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != k.shape == I_1.shape == I_2.shape == I_3.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                size = k.size
                if 0 < size <= 6:
                    return evaluate_handful(_gains_in_proportion, (k, I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
                if size <= SMALL:
                    return _gains_in_proportion_block(k, I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return evaluate_alike(_gains_in_proportion_block, 3, (0, 1, 2,), (k, I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_gains_in_proportion_block, 3, (0, 1, 2,), (k, I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)


def _gains_in_proportion(k, I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33):
    return k * ((I_3 * (a_13 * a_13)) + ((I_1 * (a_11 * a_11)) + (I_2 * (a_12 * a_12)))), k * (((I_1 * (a_21 * a_21)) + (I_2 * (a_22 * a_22))) + (I_3 * (a_23 * a_23))), k * ((I_3 * (a_33 * a_33)) + ((I_1 * (a_31 * a_31)) + (I_2 * (a_32 * a_32))))


def _gains_in_proportion_block(k, I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_k_1=None, out_k_2=None, out_k_3=None, r0=None, r1=None, r2=None):
    r0 = multiply(a_11, a_11, r0)  # a_11_squared
    r0 = multiply(I_1, r0, r0)  # t1
    r1 = multiply(a_12, a_12, r1)  # a_12_squared
    r1 = multiply(I_2, r1, r1)  # t2
    r2 = multiply(a_13, a_13, r2)  # a_13_squared
    r2 = multiply(I_3, r2, r2)  # t3
    r1 = add(r0, r1, r1)  # t4
    r1 = add(r2, r1, r1)  # t5
    out_k_1 = multiply(k, r1, out_k_1)  # t6
    r1 = multiply(a_21, a_21, r1)  # a_21_squared
    r1 = multiply(I_1, r1, r1)  # t7
    r2 = multiply(a_22, a_22, r2)  # a_22_squared
    r2 = multiply(I_2, r2, r2)  # t8
    r0 = multiply(a_23, a_23, r0)  # a_23_squared
    r0 = multiply(I_3, r0, r0)  # t9
    r2 = add(r1, r2, r2)  # t10
    r0 = add(r2, r0, r0)  # t11
    out_k_2 = multiply(k, r0, out_k_2)  # t12
    r0 = multiply(a_31, a_31, r0)  # a_31_squared
    r0 = multiply(I_1, r0, r0)  # t13
    r2 = multiply(a_32, a_32, r2)  # a_32_squared
    r2 = multiply(I_2, r2, r2)  # t14
    r1 = multiply(a_33, a_33, r1)  # a_33_squared
    r1 = multiply(I_3, r1, r1)  # t15
    r2 = add(r0, r2, r2)  # t16
    r2 = add(r1, r2, r2)  # t17
    out_k_3 = multiply(k, r2, out_k_3)  # t18
    return out_k_1, out_k_2, out_k_3


def gain_of_rates(xi, s_1, s_2, s_3, out=None):
    """The gain ratio k that three damping rates need, and how far it is above the least of them, the stability degree.

        k = 3/(1/(s_3 + xi) + 1/(s_2 + xi) + 1/(s_1 + xi))
        k_excess = -xi + 3/(1/(s_3 + xi) + 1/(s_2 + xi) + 1/(s_1 + xi))

    Arguments:
        xi: least damping rate, in 1/s; 0 < xi
        s_1: rate 1 less the least one, in 1/s; 0 <= s_1
        s_2: rate 2 less the least one, in 1/s; 0 <= s_2
        s_3: rate 3 less the least one, in 1/s; 0 <= s_3

    Returns a tuple:
        k: harmonic mean of the rates: the greatest stability degree for these gains, in 1/s
        k_excess: k - xi, in 1/s

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 2 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 10 ulp over the domain. Ten operations follow one another in k_excess, none of which cancels. With
    s_1 = s_2 = s_3 = 0, the triple root, k is xi.

    Rests on mirer2009:B.3 (sha256 11825ee30064), mirer2009:B.4 (sha256 269f1a96d135). The forms computed are
    proved equal to those shown (sha256 5d56f449afb7).
    """
    if out is None:
        try:
            if float is type(xi) is type(s_1) is type(s_2) is type(s_3):
                return _gain_of_rates(xi, s_1, s_2, s_3)
            if ndarray is type(xi) is type(s_1) is type(s_2) is type(s_3) and DOUBLE is xi.dtype is s_1.dtype is s_2.dtype is s_3.dtype and () != xi.shape == s_1.shape == s_2.shape == s_3.shape:
                size = xi.size
                if 0 < size <= 5:
                    return evaluate_handful(_gain_of_rates, (xi, s_1, s_2, s_3,))
                if size <= SMALL:
                    return _gain_of_rates_block(xi, s_1, s_2, s_3)
                return evaluate_alike(_gain_of_rates_block, 4, (0, 1,), (xi, s_1, s_2, s_3,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_gain_of_rates_block, 4, (0, 1,), (xi, s_1, s_2, s_3,), out)


def _gain_of_rates(xi, s_1, s_2, s_3):
    t2 = 1.0 / (s_1 + xi)
    t4 = 1.0 / (s_2 + xi)
    t6 = 1.0 / (s_3 + xi)
    t9 = 1.0 / (t6 + (t2 + t4))
    return 3.0 * t9, ((s_3 * t6) + ((s_1 * t2) + (s_2 * t4))) * t9


def _gain_of_rates_block(xi, s_1, s_2, s_3, out_k=None, out_k_excess=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0), n3=array(3.0)):
    r0 = add(s_1, xi, r0)  # t1
    r0 = divide(n1, r0, r0)  # t2
    r1 = add(s_2, xi, r1)  # t3
    r1 = divide(n1, r1, r1)  # t4
    r2 = add(s_3, xi, r2)  # t5
    r2 = divide(n1, r2, r2)  # t6
    r3 = add(r0, r1, r3)  # t7
    r3 = add(r2, r3, r3)  # t8
    r3 = divide(n1, r3, r3)  # t9
    out_k = multiply(n3, r3, out_k)  # t10
    r0 = multiply(s_1, r0, r0)  # t11
    r1 = multiply(s_2, r1, r1)  # t12
    r2 = multiply(s_3, r2, r2)  # t13
    r1 = add(r0, r1, r1)  # t14
    r1 = add(r2, r1, r1)  # t15
    out_k_excess = multiply(r1, r3, out_k_excess)  # t16
    return out_k, out_k_excess


def stability_degree_in_pitch(k, I_1, I_3, alpha, out=None):
    """The stability degree, the least damping rate, of gains k J_i along axes that are turned by the pitch alone.

        xi = k/(sqrt(I_1*I_3/((I_1*sin(alpha)**2 - I_1 - I_3*sin(alpha)**2)*(I_1*sin(alpha)**2 - I_3*sin(alpha)**2 + I_3)) + 1) + 1)

    Arguments:
        k: gains divided by the moments of inertia about their axes, in 1/s; 0 < k
        I_1: principal moment of inertia, in kg m^2; 0 < I_1
        I_3: principal moment of inertia, in kg m^2; 0 < I_3
        alpha: pitch, in rad; 0 < alpha < pi/2

    Returns:
        xi: stability degree, in 1/s

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain. For I_1 = I_3 and for the pitch 0 the stability degree is k, the greatest
    there is.

    Rests on mirer2009:1.5 (sha256 3b17564964dd), mirer2009:B.2 (sha256 283b9a75437b), mirer2009:B.3 (sha256
    11825ee30064), mirer2009:B.4 (sha256 269f1a96d135). The forms computed are proved equal to those shown (sha256
    4c82a6f9dadb).
    """
    if out is None:
        try:
            if float is type(k) is type(I_1) is type(I_3) is type(alpha):
                return _stability_degree_in_pitch(k, I_1, I_3, alpha)
            if ndarray is type(k) is type(I_1) is type(I_3) is type(alpha) and DOUBLE is k.dtype is I_1.dtype is I_3.dtype is alpha.dtype and () != k.shape == I_1.shape == I_3.shape == alpha.shape:
                size = k.size
                if 0 < size <= 6:
                    return evaluate_handful(_stability_degree_in_pitch, (k, I_1, I_3, alpha,))
                if size <= SMALL:
                    return _stability_degree_in_pitch_block(k, I_1, I_3, alpha)
                return evaluate_alike(_stability_degree_in_pitch_block, 4, (0,), (k, I_1, I_3, alpha,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_stability_degree_in_pitch_block, 4, (0,), (k, I_1, I_3, alpha,), out)


def _stability_degree_in_pitch(k, I_1, I_3, alpha):
    tan_alpha = math.tan(alpha)
    tan_alpha_squared = tan_alpha * tan_alpha
    t1 = 1.0 + tan_alpha_squared
    t3 = I_1 - I_3
    t12 = 1.0 + math.sqrt(1.0 / (1.0 + (((t1 * t1) * (I_1 * I_3)) / ((t3 * t3) * tan_alpha_squared))))
    return k / t12


def _stability_degree_in_pitch_block(k, I_1, I_3, alpha, out_xi=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0)):
    r0 = tan(alpha, r0)  # tan_alpha
    r0 = multiply(r0, r0, r0)  # tan_alpha_squared
    r1 = add(n1, r0, r1)  # t1
    r1 = multiply(r1, r1, r1)  # t2
    r2 = subtract(I_1, I_3, r2)  # t3
    r2 = multiply(r2, r2, r2)  # t4
    r3 = multiply(I_1, I_3, r3)  # t5
    r3 = multiply(r1, r3, r3)  # t6
    r0 = multiply(r2, r0, r0)  # t7
    r0 = divide(r3, r0, r0)  # t8
    r0 = add(n1, r0, r0)  # t9
    r0 = divide(n1, r0, r0)  # t10
    r0 = sqrt(r0, r0)  # t11
    r0 = add(n1, r0, r0)  # t12
    out_xi = divide(k, r0, out_xi)  # t13
    return out_xi


def equal_moment_pitch(I_1, I_2, I_3, out=None):
    """The pitch at which the moments about all three axes are equal, with the yaw arcsin(1/sqrt 3) and the roll pi/4.

        alpha = atan(sqrt(3)*(2*I_1 - I_2 - I_3)/(3*(I_2 - I_3)))/2

    Arguments:
        I_1: principal moment of inertia, in kg m^2; 0 < I_1
        I_2: principal moment of inertia, in kg m^2; 0 < I_2
        I_3: principal moment of inertia, in kg m^2; 0 < I_3

    Returns:
        alpha: pitch, in rad

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain. The pitch is zero where I_1 is the mean moment; the error is in units of the
    last place of the greatest, pi/4. For I_2 = I_3 it is pi/4 or -pi/4; if all three moments are equal, every
    pitch serves, and there is no number.

    Rests on mirer2009:2.8.1 (sha256 19a49102279d), mirer2009:2.9 (sha256 b20d0080930c), mirer2009:2.9.2 (sha256
    1f958d6caea2). The forms computed are proved equal to those shown (sha256 d6a7df8cd518).
    """
    if out is None:
        try:
            if float is type(I_1) is type(I_2) is type(I_3):
                return _equal_moment_pitch(I_1, I_2, I_3)
            if ndarray is type(I_1) is type(I_2) is type(I_3) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype and () != I_1.shape == I_2.shape == I_3.shape:
                size = I_1.size
                if 0 < size <= 2:
                    return evaluate_handful(_equal_moment_pitch, (I_1, I_2, I_3,))
                if size <= SMALL:
                    return _equal_moment_pitch_block(I_1, I_2, I_3)
                return evaluate_alike(_equal_moment_pitch_block, 2, (0,), (I_1, I_2, I_3,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_equal_moment_pitch_block, 2, (0,), (I_1, I_2, I_3,), out)


def _equal_moment_pitch(I_1, I_2, I_3):
    t9 = (1.0 / 2.0) * math.atan((1.0 / 3.0) * (math.sqrt(3.0) * (1.0 + ((2.0 * (I_1 - I_2)) / (I_2 - I_3)))))
    return t9


def _equal_moment_pitch_block(I_1, I_2, I_3, out_alpha=None, r0=None, r1=None, n2=array(2.0), n1=array(1.0), sqrt_3=array(math.sqrt(3.0)), n1_3=array(1.0 / 3.0), n1_2=array(1.0 / 2.0)):
    r0 = subtract(I_2, I_3, r0)  # t1
    r1 = subtract(I_1, I_2, r1)  # t2
    r1 = multiply(n2, r1, r1)  # t3
    r0 = divide(r1, r0, r0)  # t4
    r0 = add(n1, r0, r0)  # t5
    r0 = multiply(sqrt_3, r0, r0)  # t6
    r0 = multiply(n1_3, r0, r0)  # t7
    r0 = arctan(r0, r0)  # t8
    out_alpha = multiply(n1_2, r0, out_alpha)  # t9
    return out_alpha
