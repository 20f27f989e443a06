"""Kernels of esenkov2006. Written by `symcheck generate`: what is changed here is lost."""

import math

from numpy import add, divide, multiply, negative, sqrt, subtract, array, ndarray

from symcheck.kernels.runtime import DOUBLE, FEW, SMALL, evaluate, evaluate_alike, evaluate_handful

__all__ = ["boundary_of_stability", "characteristic_coefficients", "critical_frequencies", "discriminant", "frequencies", "greatest_growth_rate", "mode_inertia", "residue_of_a_mode", "width_of_the_unstable_interval"]

DECLARED = {  # name, meaning and unit of the arguments and of the results; docstrings may be stripped
    'mode_inertia': (
        (
            ('a_1', 'angular momentum of the liquid for the amplitude 1 of a mode of dimensionless shape', 'kg m'),
            ('chi_1', 'coupling of the mode to the turning body', 'm^4'),
            ('N_1', 'norm of the mode', 'm^(3/2)'),
        ),
        (
            ('E_1', 'moment of inertia of the mode', 'kg m^2'),
        ),
    ),
    'residue_of_a_mode': (
        (
            ('E_1', 'moment of inertia that the mode carries', 'kg m^2'),
            ('lambda_1', 'natural frequency of the mode', 'rad/s'),
            ('omega_0', 'spin', 'rad/s'),
        ),
        (
            ('R_1', 'minus the residue', 'kg m^2 rad^2/s^2'),
        ),
    ),
    'characteristic_coefficients': (
        (
            ('A', 'transverse moment of inertia, with the liquid at rest', 'kg m^2'),
            ('C', 'axial moment of inertia', 'kg m^2'),
            ('E_1', 'moment of inertia that the mode carries', 'kg m^2'),
            ('lambda_1', 'natural frequency of the mode', 'rad/s'),
            ('omega_0', 'spin', 'rad/s'),
        ),
        (
            ('c_2', 'coefficient of eta^2', 'kg m^2'),
            ('c_1', 'coefficient of eta', 'kg m^2 rad/s'),
            ('c_0', 'constant term', 'kg m^2 rad^2/s^2'),
        ),
    ),
    'discriminant': (
        (
            ('A', 'transverse moment of inertia, with the liquid at rest', 'kg m^2'),
            ('C', 'axial moment of inertia', 'kg m^2'),
            ('E_1', 'moment of inertia that the mode carries', 'kg m^2'),
            ('lambda_1', 'natural frequency of the mode', 'rad/s'),
            ('omega_0', 'spin', 'rad/s'),
        ),
        (
            ('D', 'discriminant in eta', 'kg^2 m^4 rad^2/s^2'),
        ),
    ),
    'boundary_of_stability': (
        (
            ('A', 'transverse moment of inertia, with the liquid at rest', 'kg m^2'),
            ('E_1', 'moment of inertia that the mode carries', 'kg m^2'),
            ('b_1', 'natural frequency of the mode, divided by the spin', '1'),
        ),
        (
            ('Delta_1', 'upper end', 'kg m^2'),
            ('Delta_2', 'lower end', 'kg m^2'),
        ),
    ),
    'width_of_the_unstable_interval': (
        (
            ('A', 'transverse moment of inertia, with the liquid at rest', 'kg m^2'),
            ('E_1', 'moment of inertia that the mode carries', 'kg m^2'),
            ('b_1', 'natural frequency of the mode, divided by the spin', '1'),
        ),
        (
            ('width', 'length of the interval', 'kg m^2'),
        ),
    ),
    'critical_frequencies': (
        (
            ('A', 'transverse moment of inertia, with the liquid at rest', 'kg m^2'),
            ('E_1', 'moment of inertia that the mode carries', 'kg m^2'),
            ('b_1', 'natural frequency of the mode, divided by the spin', '1'),
            ('omega_0', 'spin', 'rad/s'),
        ),
        (
            ('eta_1', 'frequency at the upper end', 'rad/s'),
            ('eta_2', 'frequency at the lower end', 'rad/s'),
        ),
    ),
    'greatest_growth_rate': (
        (
            ('A', 'transverse moment of inertia, with the liquid at rest', 'kg m^2'),
            ('E_1', 'moment of inertia that the mode carries', 'kg m^2'),
            ('b_1', 'natural frequency of the mode, divided by the spin', '1'),
            ('omega_0', 'spin', 'rad/s'),
        ),
        (
            ('y', 'growth rate', '1/s'),
        ),
    ),
    'frequencies': (
        (
            ('A', 'transverse moment of inertia, with the liquid at rest', 'kg m^2'),
            ('Delta', 'C - A: a flattened body', 'kg m^2'),
            ('E_1', 'moment of inertia that the mode carries', 'kg m^2'),
            ('b_1', 'natural frequency of the mode, divided by the spin', '1'),
            ('omega_0', 'spin', 'rad/s'),
        ),
        (
            ('eta_1', 'frequency against the spin', 'rad/s'),
            ('eta_2', 'frequency with the spin', 'rad/s'),
        ),
    ),
}


def mode_inertia(a_1, chi_1, N_1, out=None):
    """The moment of inertia that a mode of the liquid carries.

        E_1 = a_1*chi_1/N_1**2

    Arguments:
        a_1: angular momentum of the liquid for the amplitude 1 of a mode of dimensionless shape, in kg m; any number
        chi_1: coupling of the mode to the turning body, in m^4; any number
        N_1: norm of the mode, in m^(3/2); 0 < N_1

    Returns:
        E_1: moment of inertia of the mode, in kg m^2

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain.

    Rests on esenkov2006:1.32 (sha256 91c691dc84d1), esenkov2006:B.1 (sha256 d62232d82a4e).
    """
    if out is None:
        try:
            if float is type(a_1) is type(chi_1) is type(N_1):
                return _mode_inertia(a_1, chi_1, N_1)
            if ndarray is type(a_1) is type(chi_1) is type(N_1) and DOUBLE is a_1.dtype is chi_1.dtype is N_1.dtype and () != a_1.shape == chi_1.shape == N_1.shape:
                size = a_1.size
                if size <= SMALL:
                    return _mode_inertia_block(a_1, chi_1, N_1)
                return evaluate_alike(_mode_inertia_block, 2, (0,), (a_1, chi_1, N_1,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_mode_inertia_block, 2, (0,), (a_1, chi_1, N_1,), out)


def _mode_inertia(a_1, chi_1, N_1):
    return (a_1 * chi_1) / (N_1 * N_1)


def _mode_inertia_block(a_1, chi_1, N_1, out_E_1=None, r0=None, r1=None):
    r0 = multiply(N_1, N_1, r0)  # N_1_squared
    r1 = multiply(a_1, chi_1, r1)  # t1
    out_E_1 = divide(r1, r0, out_E_1)  # t2
    return out_E_1


def residue_of_a_mode(E_1, lambda_1, omega_0, out=None):
    """Minus the residue of the characteristic equation at a natural frequency; modes with positive ones are harmless.

        R_1 = E_1*lambda_1**2 - E_1*lambda_1*omega_0

    Arguments:
        E_1: moment of inertia that the mode carries, in kg m^2; 0 < E_1
        lambda_1: natural frequency of the mode, in rad/s; any number
        omega_0: spin, in rad/s; 0 < omega_0

    Returns:
        R_1: minus the residue, in kg m^2 rad^2/s^2

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain.

    Rests on esenkov2006:N.3 (sha256 10f423309148), esenkov2006:N.5 (sha256 b88788105c9d). The forms computed are
    proved equal to those shown (sha256 1273b10d4eb2).
    """
    if out is None:
        try:
            if float is type(E_1) is type(lambda_1) is type(omega_0):
                return _residue_of_a_mode(E_1, lambda_1, omega_0)
            if ndarray is type(E_1) is type(lambda_1) is type(omega_0) and DOUBLE is E_1.dtype is lambda_1.dtype is omega_0.dtype and () != E_1.shape == lambda_1.shape == omega_0.shape:
                size = E_1.size
                if size <= SMALL:
                    return _residue_of_a_mode_block(E_1, lambda_1, omega_0)
                return evaluate_alike(_residue_of_a_mode_block, 2, (0,), (E_1, lambda_1, omega_0,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_residue_of_a_mode_block, 2, (0,), (E_1, lambda_1, omega_0,), out)


def _residue_of_a_mode(E_1, lambda_1, omega_0):
    return (lambda_1 - omega_0) * (E_1 * lambda_1)


def _residue_of_a_mode_block(E_1, lambda_1, omega_0, out_R_1=None, r0=None, r1=None):
    r0 = subtract(lambda_1, omega_0, r0)  # t1
    r1 = multiply(E_1, lambda_1, r1)  # t2
    out_R_1 = multiply(r0, r1, out_R_1)  # t3
    return out_R_1


def characteristic_coefficients(A, C, E_1, lambda_1, omega_0, out=None):
    """Coefficients of the quadratic equation (1.33) for the frequencies.

        c_2 = A - E_1
        c_1 = -A*lambda_1 - A*omega_0 + C*omega_0 + E_1*omega_0
        c_0 = A*lambda_1*omega_0 - C*lambda_1*omega_0

    Arguments:
        A: transverse moment of inertia, with the liquid at rest, in kg m^2; 0 < A
        C: axial moment of inertia, in kg m^2; 0 < C
        E_1: moment of inertia that the mode carries, in kg m^2; 0 < E_1 < A
        lambda_1: natural frequency of the mode, in rad/s; any number
        omega_0: spin, in rad/s; 0 < omega_0

    Returns a tuple:
        c_2: coefficient of eta^2, in kg m^2
        c_1: coefficient of eta, in kg m^2 rad/s
        c_0: constant term, in kg m^2 rad^2/s^2

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain. Where terms cancel, the error is in units of the last place of the largest of
    them.

    Rests on esenkov2006:1.32 (sha256 91c691dc84d1), esenkov2006:1.33 (sha256 5dfcf91b92f9). The forms computed
    are proved equal to those shown (sha256 8d1a6c39f1e8).
    """
    if out is None:
        try:
            if float is type(A) is type(C) is type(E_1) is type(lambda_1) is type(omega_0):
                return _characteristic_coefficients(A, C, E_1, lambda_1, omega_0)
            if ndarray is type(A) is type(C) is type(E_1) is type(lambda_1) is type(omega_0) and DOUBLE is A.dtype is C.dtype is E_1.dtype is lambda_1.dtype is omega_0.dtype and () != A.shape == C.shape == E_1.shape == lambda_1.shape == omega_0.shape:
                size = A.size
                if 0 < size <= 1:
                    return evaluate_handful(_characteristic_coefficients, (A, C, E_1, lambda_1, omega_0,))
                if size <= SMALL:
                    return _characteristic_coefficients_block(A, C, E_1, lambda_1, omega_0)
                return evaluate_alike(_characteristic_coefficients_block, 4, (0, 1, 2,), (A, C, E_1, lambda_1, omega_0,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_characteristic_coefficients_block, 4, (0, 1, 2,), (A, C, E_1, lambda_1, omega_0,), out)


def _characteristic_coefficients(A, C, E_1, lambda_1, omega_0):
    t1 = A - C
    return A - E_1, ((E_1 * omega_0) - (A * lambda_1)) - (omega_0 * t1), omega_0 * (lambda_1 * t1)


def _characteristic_coefficients_block(A, C, E_1, lambda_1, omega_0, out_c_2=None, out_c_1=None, out_c_0=None, r0=None, r1=None, r2=None, r3=None):
    r0 = subtract(A, C, r0)  # t1
    out_c_2 = subtract(A, E_1, out_c_2)  # t2
    r1 = multiply(A, lambda_1, r1)  # t3
    r2 = multiply(E_1, omega_0, r2)  # t4
    r3 = multiply(omega_0, r0, r3)  # t5
    r1 = subtract(r2, r1, r1)  # t6
    out_c_1 = subtract(r1, r3, out_c_1)  # t7
    r0 = multiply(lambda_1, r0, r0)  # t8
    out_c_0 = multiply(omega_0, r0, out_c_0)  # t9
    return out_c_2, out_c_1, out_c_0


def discriminant(A, C, E_1, lambda_1, omega_0, out=None):
    """The discriminant of the quadratic equation (1.33): the body is stable where it is positive.

        D = A**2*lambda_1**2 - 2*A**2*lambda_1*omega_0 + A**2*omega_0**2 + 2*A*C*lambda_1*omega_0 - 2*A*C*omega_0**2 + 2*A*E_1*lambda_1*omega_0 - 2*A*E_1*omega_0**2 + C**2*omega_0**2 - 4*C*E_1*lambda_1*omega_0 + 2*C*E_1*omega_0**2 + E_1**2*omega_0**2

    Arguments:
        A: transverse moment of inertia, with the liquid at rest, in kg m^2; 0 < A
        C: axial moment of inertia, in kg m^2; 0 < C
        E_1: moment of inertia that the mode carries, in kg m^2; 0 < E_1 < A
        lambda_1: natural frequency of the mode, in rad/s; any number
        omega_0: spin, in rad/s; 0 < omega_0

    Returns:
        D: discriminant in eta, in kg^2 m^4 rad^2/s^2

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 10 ulp over the domain. It is zero at the boundary of stability; the error is in units of the last
    place of what it were if nothing cancelled, the square of |C - A| omega_0 + E_1 omega_0 + A |lambda_1|; ten
    operations follow one another.

    Rests on esenkov2006:1.33.3a (sha256 85a55af1a21e), esenkov2006:1.33.4 (sha256 eef05166bf2c), esenkov2006:B.2
    (sha256 1846771b4c5a), esenkov2006:B.6 (sha256 3465e26c0810). The forms computed are proved equal to those
    shown (sha256 69b0e962ebfb).
    """
    if out is None:
        try:
            if float is type(A) is type(C) is type(E_1) is type(lambda_1) is type(omega_0):
                return _discriminant(A, C, E_1, lambda_1, omega_0)
            if ndarray is type(A) is type(C) is type(E_1) is type(lambda_1) is type(omega_0) and DOUBLE is A.dtype is C.dtype is E_1.dtype is lambda_1.dtype is omega_0.dtype and () != A.shape == C.shape == E_1.shape == lambda_1.shape == omega_0.shape:
                size = A.size
                if 0 < size <= 6:
                    return evaluate_handful(_discriminant, (A, C, E_1, lambda_1, omega_0,))
                if size <= SMALL:
                    return _discriminant_block(A, C, E_1, lambda_1, omega_0)
                return evaluate_alike(_discriminant_block, 4, (0,), (A, C, E_1, lambda_1, omega_0,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_discriminant_block, 4, (0,), (A, C, E_1, lambda_1, omega_0,), out)


def _discriminant(A, C, E_1, lambda_1, omega_0):
    t5 = E_1 * (lambda_1 - omega_0)
    t13 = ((omega_0 * (C - A)) + (lambda_1 * (A - E_1))) - t5
    return (t13 * t13) + (((4.0 * A) - (4.0 * E_1)) * (lambda_1 * t5))


def _discriminant_block(A, C, E_1, lambda_1, omega_0, out_D=None, r0=None, r1=None, r2=None, r3=None, n4=array(4.0)):
    r0 = subtract(lambda_1, omega_0, r0)  # t1
    r1 = multiply(n4, A, r1)  # t2
    r2 = multiply(n4, E_1, r2)  # t3
    r2 = subtract(r1, r2, r2)  # t4
    r0 = multiply(E_1, r0, r0)  # t5
    r1 = multiply(lambda_1, r0, r1)  # t6
    r1 = multiply(r2, r1, r1)  # t7
    r2 = subtract(A, E_1, r2)  # t8
    r2 = multiply(lambda_1, r2, r2)  # t9
    r3 = subtract(C, A, r3)  # t10
    r3 = multiply(omega_0, r3, r3)  # t11
    r2 = add(r3, r2, r2)  # t12
    r0 = subtract(r2, r0, r0)  # t13
    r0 = multiply(r0, r0, r0)  # t14
    out_D = add(r0, r1, out_D)  # t15
    return out_D


def boundary_of_stability(A, E_1, b_1, out=None):
    """The two values of C - A between which the body is unstable.

        Delta_1 = -A*b_1 + 2*sqrt(E_1)*sqrt(b_1)*sqrt(1 - b_1)*sqrt(A - E_1) + 2*E_1*b_1 - E_1
        Delta_2 = -A*b_1 - 2*sqrt(E_1)*sqrt(b_1)*sqrt(1 - b_1)*sqrt(A - E_1) + 2*E_1*b_1 - E_1

    Arguments:
        A: transverse moment of inertia, with the liquid at rest, in kg m^2; 0 < A
        E_1: moment of inertia that the mode carries, in kg m^2; 0 < E_1 < A
        b_1: natural frequency of the mode, divided by the spin, a number; 0 < b_1 < 1

    Returns a tuple:
        Delta_1: upper end, in kg m^2
        Delta_2: lower end, in kg m^2

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 2 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain. The upper end is zero where A b_1 = E_1; its error is in units of the last
    place of the larger of E_1 (1 - b_1) and b_1 (A - E_1).

    Rests on esenkov2006:1.34.3 (sha256 d8869e67ad9a), esenkov2006:1.34.5 (sha256 5bd5d83cdfe1), esenkov2006:1.35a
    (sha256 b5ffc014e2a4), esenkov2006:1.35c (sha256 aa7f3e52c939), esenkov2006:B.11 (sha256 742d7c68ca61). The
    forms computed are proved equal to those shown (sha256 c587d73ba2b4).
    """
    if out is None:
        try:
            if float is type(A) is type(E_1) is type(b_1):
                return _boundary_of_stability(A, E_1, b_1)
            if ndarray is type(A) is type(E_1) is type(b_1) and DOUBLE is A.dtype is E_1.dtype is b_1.dtype and () != A.shape == E_1.shape == b_1.shape:
                size = A.size
                if 0 < size <= 8:
                    return evaluate_handful(_boundary_of_stability, (A, E_1, b_1,))
                if size <= SMALL:
                    return _boundary_of_stability_block(A, E_1, b_1)
                return evaluate_alike(_boundary_of_stability_block, 6, (0, 1,), (A, E_1, b_1,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_boundary_of_stability_block, 6, (0, 1,), (A, E_1, b_1,), out)


def _boundary_of_stability(A, E_1, b_1):
    t1 = 1.0 - b_1
    t2 = E_1 * t1
    t3 = A - E_1
    t4 = b_1 * t3
    t11 = (t2 + (2.0 * (math.sqrt(t1 * t3) * (math.sqrt(E_1) * math.sqrt(b_1))))) + t4
    t12 = 1.0 / t11
    return (t2 - t4) * ((b_1 * (t12 * t3)) - (t12 * t2)), -t11


def _boundary_of_stability_block(A, E_1, b_1, out_Delta_1=None, out_Delta_2=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, n1=array(1.0), n2=array(2.0)):
    r0 = subtract(n1, b_1, r0)  # t1
    r1 = multiply(E_1, r0, r1)  # t2
    r2 = subtract(A, E_1, r2)  # t3
    r3 = multiply(b_1, r2, r3)  # t4
    r4 = sqrt(E_1, r4)  # sqrt_E_1
    r5 = sqrt(b_1, r5)  # sqrt_b_1
    r0 = multiply(r0, r2, r0)  # t5
    r0 = sqrt(r0, r0)  # t6
    r5 = multiply(r4, r5, r5)  # t7
    r5 = multiply(r0, r5, r5)  # t8
    r5 = multiply(n2, r5, r5)  # t9
    r5 = add(r1, r5, r5)  # t10
    r5 = add(r5, r3, r5)  # t11
    r0 = divide(n1, r5, r0)  # t12
    r3 = subtract(r1, r3, r3)  # t13
    r2 = multiply(r0, r2, r2)  # t14
    r2 = multiply(b_1, r2, r2)  # t15
    r1 = multiply(r0, r1, r1)  # t16
    r1 = subtract(r2, r1, r1)  # t17
    out_Delta_1 = multiply(r3, r1, out_Delta_1)  # t18
    out_Delta_2 = negative(r5, out_Delta_2)  # t19
    return out_Delta_1, out_Delta_2


def width_of_the_unstable_interval(A, E_1, b_1, out=None):
    """The length of the interval of C - A in which the body is unstable.

        width = 4*sqrt(E_1)*sqrt(b_1)*sqrt(1 - b_1)*sqrt(A - E_1)

    Arguments:
        A: transverse moment of inertia, with the liquid at rest, in kg m^2; 0 < A
        E_1: moment of inertia that the mode carries, in kg m^2; 0 < E_1 < A
        b_1: natural frequency of the mode, divided by the spin, a number; 0 < b_1 < 1

    Returns:
        width: length of the interval, in kg m^2

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain.

    Rests on esenkov2006:1.34.4 (sha256 d7e201757da1), esenkov2006:B.16 (sha256 4515d9596d9c), esenkov2006:B.28
    (sha256 d39dfa450602). The forms computed are proved equal to those shown (sha256 69c2846fab1b).
    """
    if out is None:
        try:
            if float is type(A) is type(E_1) is type(b_1):
                return _width_of_the_unstable_interval(A, E_1, b_1)
            if ndarray is type(A) is type(E_1) is type(b_1) and DOUBLE is A.dtype is E_1.dtype is b_1.dtype and () != A.shape == E_1.shape == b_1.shape:
                size = A.size
                if 0 < size <= 2:
                    return evaluate_handful(_width_of_the_unstable_interval, (A, E_1, b_1,))
                if size <= SMALL:
                    return _width_of_the_unstable_interval_block(A, E_1, b_1)
                return evaluate_alike(_width_of_the_unstable_interval_block, 4, (0,), (A, E_1, b_1,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_width_of_the_unstable_interval_block, 4, (0,), (A, E_1, b_1,), out)


def _width_of_the_unstable_interval(A, E_1, b_1):
    return 4.0 * (math.sqrt((1.0 - b_1) * (A - E_1)) * (math.sqrt(E_1) * math.sqrt(b_1)))


def _width_of_the_unstable_interval_block(A, E_1, b_1, out_width=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0), n4=array(4.0)):
    r0 = sqrt(E_1, r0)  # sqrt_E_1
    r1 = sqrt(b_1, r1)  # sqrt_b_1
    r2 = subtract(n1, b_1, r2)  # t1
    r3 = subtract(A, E_1, r3)  # t2
    r3 = multiply(r2, r3, r3)  # t3
    r3 = sqrt(r3, r3)  # t4
    r1 = multiply(r0, r1, r1)  # t5
    r1 = multiply(r3, r1, r1)  # t6
    out_width = multiply(n4, r1, out_width)  # t7
    return out_width


def critical_frequencies(A, E_1, b_1, omega_0, out=None):
    """The double frequencies at the two ends of the interval in which the body is unstable.

        eta_1 = omega_0*(-sqrt(E_1)*sqrt(-b_1*(b_1 - 1)/(A - E_1)) + b_1)
        eta_2 = omega_0*(sqrt(E_1)*sqrt(-b_1*(b_1 - 1)/(A - E_1)) + b_1)

    Arguments:
        A: transverse moment of inertia, with the liquid at rest, in kg m^2; 0 < A
        E_1: moment of inertia that the mode carries, in kg m^2; 0 < E_1 < A
        b_1: natural frequency of the mode, divided by the spin, a number; 0 < b_1 < 1
        omega_0: spin, in rad/s; 0 < omega_0

    Returns a tuple:
        eta_1: frequency at the upper end, in rad/s
        eta_2: frequency at the lower end, in rad/s

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 2 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain. The frequency at the upper end is zero where A b_1 = E_1. Where terms cancel,
    the error is in units of the last place of the largest of them.

    Rests on esenkov2006:B.4 (sha256 0e6afd49f325), esenkov2006:B.26 (sha256 520e09812ec5), esenkov2006:B.27
    (sha256 416470da3f23).
    """
    if out is None:
        try:
            if float is type(A) is type(E_1) is type(b_1) is type(omega_0):
                return _critical_frequencies(A, E_1, b_1, omega_0)
            if ndarray is type(A) is type(E_1) is type(b_1) is type(omega_0) and DOUBLE is A.dtype is E_1.dtype is b_1.dtype is omega_0.dtype and () != A.shape == E_1.shape == b_1.shape == omega_0.shape:
                size = A.size
                if 0 < size <= 2:
                    return evaluate_handful(_critical_frequencies, (A, E_1, b_1, omega_0,))
                if size <= SMALL:
                    return _critical_frequencies_block(A, E_1, b_1, omega_0)
                return evaluate_alike(_critical_frequencies_block, 3, (0, 1,), (A, E_1, b_1, omega_0,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_critical_frequencies_block, 3, (0, 1,), (A, E_1, b_1, omega_0,), out)


def _critical_frequencies(A, E_1, b_1, omega_0):
    t7 = math.sqrt(E_1) * math.sqrt(-((b_1 * (b_1 - 1.0)) / (A - E_1)))
    return omega_0 * (b_1 - t7), omega_0 * (b_1 + t7)


def _critical_frequencies_block(A, E_1, b_1, omega_0, out_eta_1=None, out_eta_2=None, r0=None, r1=None, r2=None, n1=array(1.0)):
    r0 = sqrt(E_1, r0)  # sqrt_E_1
    r1 = subtract(A, E_1, r1)  # t1
    r2 = subtract(b_1, n1, r2)  # t2
    r2 = multiply(b_1, r2, r2)  # t3
    r1 = divide(r2, r1, r1)  # t4
    r1 = negative(r1, r1)  # t5
    r1 = sqrt(r1, r1)  # t6
    r1 = multiply(r0, r1, r1)  # t7
    r0 = subtract(b_1, r1, r0)  # t8
    out_eta_1 = multiply(omega_0, r0, out_eta_1)  # t9
    r1 = add(b_1, r1, r1)  # t10
    out_eta_2 = multiply(omega_0, r1, out_eta_2)  # t11
    return out_eta_1, out_eta_2


def greatest_growth_rate(A, E_1, b_1, omega_0, out=None):
    """The rate at which the motion grows in the middle of the interval in which the body is unstable; nowhere is it greater.

        y = sqrt(E_1)*omega_0*sqrt(-b_1*(b_1 - 1)/(A - E_1))

    Arguments:
        A: transverse moment of inertia, with the liquid at rest, in kg m^2; 0 < A
        E_1: moment of inertia that the mode carries, in kg m^2; 0 < E_1 < A
        b_1: natural frequency of the mode, divided by the spin, a number; 0 < b_1 < 1
        omega_0: spin, in rad/s; 0 < omega_0

    Returns:
        y: growth rate, in 1/s

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain.

    Rests on esenkov2006:B.6 (sha256 3465e26c0810), esenkov2006:B.7 (sha256 e0d23e2e841f), esenkov2006:B.8 (sha256
    274537c8998c).
    """
    if out is None:
        try:
            if float is type(A) is type(E_1) is type(b_1) is type(omega_0):
                return _greatest_growth_rate(A, E_1, b_1, omega_0)
            if ndarray is type(A) is type(E_1) is type(b_1) is type(omega_0) and DOUBLE is A.dtype is E_1.dtype is b_1.dtype is omega_0.dtype and () != A.shape == E_1.shape == b_1.shape == omega_0.shape:
                size = A.size
                if 0 < size <= 1:
                    return evaluate_handful(_greatest_growth_rate, (A, E_1, b_1, omega_0,))
                if size <= SMALL:
                    return _greatest_growth_rate_block(A, E_1, b_1, omega_0)
                return evaluate_alike(_greatest_growth_rate_block, 3, (0,), (A, E_1, b_1, omega_0,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_greatest_growth_rate_block, 3, (0,), (A, E_1, b_1, omega_0,), out)


def _greatest_growth_rate(A, E_1, b_1, omega_0):
    return math.sqrt(-((b_1 * (b_1 - 1.0)) / (A - E_1))) * (omega_0 * math.sqrt(E_1))


def _greatest_growth_rate_block(A, E_1, b_1, omega_0, out_y=None, r0=None, r1=None, r2=None, n1=array(1.0)):
    r0 = sqrt(E_1, r0)  # sqrt_E_1
    r1 = subtract(A, E_1, r1)  # t1
    r2 = subtract(b_1, n1, r2)  # t2
    r2 = multiply(b_1, r2, r2)  # t3
    r1 = divide(r2, r1, r1)  # t4
    r1 = negative(r1, r1)  # t5
    r1 = sqrt(r1, r1)  # t6
    r0 = multiply(omega_0, r0, r0)  # t7
    out_y = multiply(r1, r0, out_y)  # t8
    return out_y


def frequencies(A, Delta, E_1, b_1, omega_0, out=None):
    """The two frequencies of a flattened body with one mode, which is stable.

        eta_1 = omega_0*((A*b_1 - Delta - E_1)/(2*A - 2*E_1) - sqrt(A**2*b_1**2 + 2*A*Delta*b_1 - 2*A*E_1*b_1 + Delta**2 - 4*Delta*E_1*b_1 + 2*Delta*E_1 + E_1**2)/(2*A - 2*E_1))
        eta_2 = omega_0*((A*b_1 - Delta - E_1)/(2*A - 2*E_1) + sqrt(A**2*b_1**2 + 2*A*Delta*b_1 - 2*A*E_1*b_1 + Delta**2 - 4*Delta*E_1*b_1 + 2*Delta*E_1 + E_1**2)/(2*A - 2*E_1))

    Arguments:
        A: transverse moment of inertia, with the liquid at rest, in kg m^2; 0 < A
        Delta: C - A: a flattened body, in kg m^2; 0 < Delta
        E_1: moment of inertia that the mode carries, in kg m^2; 0 < E_1 < A
        b_1: natural frequency of the mode, divided by the spin, a number; 0 < b_1 < 1
        omega_0: spin, in rad/s; 0 < omega_0

    Returns a tuple:
        eta_1: frequency against the spin, in rad/s
        eta_2: frequency with the spin, in rad/s

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 2 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. The frequencies are differences of a root and a linear term; the error is in
    units of the last place of a bound of both, omega_0 / (A - E_1) times the sum of Delta, E_1 (1 - b_1) and b_1
    (A - E_1); eight operations follow one another.

    Rests on esenkov2006:1.33 (sha256 5dfcf91b92f9), esenkov2006:1.34.3 (sha256 d8869e67ad9a), esenkov2006:B.2
    (sha256 1846771b4c5a), esenkov2006:B.18 (sha256 6199de6695fd). The forms computed are proved equal to those
    shown (sha256 26816138ab42).
    """
    if out is None:
        try:
            if float is type(A) is type(Delta) is type(E_1) is type(b_1) is type(omega_0):
                return _frequencies(A, Delta, E_1, b_1, omega_0)
            if ndarray is type(A) is type(Delta) is type(E_1) is type(b_1) is type(omega_0) and DOUBLE is A.dtype is Delta.dtype is E_1.dtype is b_1.dtype is omega_0.dtype and () != A.shape == Delta.shape == E_1.shape == b_1.shape == omega_0.shape:
                size = A.size
                if 0 < size <= 6:
                    return evaluate_handful(_frequencies, (A, Delta, E_1, b_1, omega_0,))
                if size <= SMALL:
                    return _frequencies_block(A, Delta, E_1, b_1, omega_0)
                return evaluate_alike(_frequencies_block, 4, (0, 1,), (A, Delta, E_1, b_1, omega_0,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_frequencies_block, 4, (0, 1,), (A, Delta, E_1, b_1, omega_0,), out)


def _frequencies(A, Delta, E_1, b_1, omega_0):
    t1 = A - E_1
    t2 = b_1 * t1
    t6 = (Delta + (E_1 * (1.0 - b_1))) - t2
    t11 = math.sqrt((4.0 * (Delta * t2)) + (t6 * t6))
    t13 = ((1.0 / 2.0) * omega_0) / t1
    return -(t13 * (t11 + t6)), t13 * (t11 - t6)


def _frequencies_block(A, Delta, E_1, b_1, omega_0, out_eta_1=None, out_eta_2=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0), n4=array(4.0), n1_2=array(1.0 / 2.0)):
    r0 = subtract(A, E_1, r0)  # t1
    r1 = multiply(b_1, r0, r1)  # t2
    r2 = subtract(n1, b_1, r2)  # t3
    r2 = multiply(E_1, r2, r2)  # t4
    r2 = add(Delta, r2, r2)  # t5
    r2 = subtract(r2, r1, r2)  # t6
    r1 = multiply(Delta, r1, r1)  # t7
    r1 = multiply(n4, r1, r1)  # t8
    r3 = multiply(r2, r2, r3)  # t9
    r3 = add(r1, r3, r3)  # t10
    r3 = sqrt(r3, r3)  # t11
    r1 = multiply(n1_2, omega_0, r1)  # t12
    r0 = divide(r1, r0, r0)  # t13
    r1 = add(r3, r2, r1)  # t14
    r1 = multiply(r0, r1, r1)  # t15
    out_eta_1 = negative(r1, out_eta_1)  # t16
    r2 = subtract(r3, r2, r2)  # t17
    out_eta_2 = multiply(r0, r2, out_eta_2)  # t18
    return out_eta_1, out_eta_2
