"""How the kernels of esenkov2006 run on numbers and on arrays. Written by `symcheck generate`: what is changed here is lost."""

# mypy: ignore-errors
import math

from numpy import array, ndarray, add, divide, multiply, negative, sqrt, subtract

from symcheck.kernels.runtime import DOUBLE, FEW, SMALL, UNDEFINED, on_arrays


def mode_inertia(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _mode_inertia, 2, (0,), 0)

    def call(a_1, chi_1, N_1, out=None):
        if out is None:
            if float is type(a_1) is type(chi_1) is type(N_1):
                try:
                    return formula(a_1, chi_1, N_1)
                except UNDEFINED:
                    pass
            elif ndarray is type(a_1) is type(chi_1) is type(N_1) and DOUBLE is a_1.dtype is chi_1.dtype is N_1.dtype and () != a_1.shape == chi_1.shape == N_1.shape:
                if 0 < a_1.size <= SMALL:
                    return _mode_inertia(a_1, chi_1, N_1)
                return alike(a_1, chi_1, N_1)
        return others((a_1, chi_1, N_1,), out)

    return call


def _mode_inertia(a_1, chi_1, N_1, out_E_1=None, r0=None, r1=None):
    r0 = multiply(N_1, N_1, r0)  # N_1_squared
    r1 = multiply(a_1, chi_1, r1)  # t1
    out_E_1 = divide(r1, r0, out_E_1)  # t2
    return out_E_1


def residue_of_a_mode(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _residue_of_a_mode, 2, (0,), 0)

    def call(E_1, lambda_1, omega_0, out=None):
        if out is None:
            if float is type(E_1) is type(lambda_1) is type(omega_0):
                try:
                    return formula(E_1, lambda_1, omega_0)
                except UNDEFINED:
                    pass
            elif ndarray is type(E_1) is type(lambda_1) is type(omega_0) and DOUBLE is E_1.dtype is lambda_1.dtype is omega_0.dtype and () != E_1.shape == lambda_1.shape == omega_0.shape:
                if 0 < E_1.size <= SMALL:
                    return _residue_of_a_mode(E_1, lambda_1, omega_0)
                return alike(E_1, lambda_1, omega_0)
        return others((E_1, lambda_1, omega_0,), out)

    return call


def _residue_of_a_mode(E_1, lambda_1, omega_0, out_R_1=None, r0=None, r1=None):
    r0 = subtract(lambda_1, omega_0, r0)  # t1
    r1 = multiply(E_1, lambda_1, r1)  # t2
    out_R_1 = multiply(r0, r1, out_R_1)  # t3
    return out_R_1


def characteristic_coefficients(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _characteristic_coefficients, 4, (0, 1, 2,), 1)

    def call(A, C, E_1, lambda_1, omega_0, out=None):
        if out is None:
            if float is type(A) is type(C) is type(E_1) is type(lambda_1) is type(omega_0):
                try:
                    return formula(A, C, E_1, lambda_1, omega_0)
                except UNDEFINED:
                    pass
            elif ndarray is type(A) is type(C) is type(E_1) is type(lambda_1) is type(omega_0) and DOUBLE is A.dtype is C.dtype is E_1.dtype is lambda_1.dtype is omega_0.dtype and () != A.shape == C.shape == E_1.shape == lambda_1.shape == omega_0.shape:
                if 1 < A.size <= SMALL:
                    return _characteristic_coefficients(A, C, E_1, lambda_1, omega_0)
                return alike(A, C, E_1, lambda_1, omega_0)
        return others((A, C, E_1, lambda_1, omega_0,), out)

    return call


def _characteristic_coefficients(A, C, E_1, lambda_1, omega_0, out_c_2=None, out_c_1=None, out_c_0=None, r0=None, r1=None, r2=None, r3=None):
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


def discriminant(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _discriminant, 4, (0,), 6)

    def call(A, C, E_1, lambda_1, omega_0, out=None):
        if out is None:
            if float is type(A) is type(C) is type(E_1) is type(lambda_1) is type(omega_0):
                try:
                    return formula(A, C, E_1, lambda_1, omega_0)
                except UNDEFINED:
                    pass
            elif ndarray is type(A) is type(C) is type(E_1) is type(lambda_1) is type(omega_0) and DOUBLE is A.dtype is C.dtype is E_1.dtype is lambda_1.dtype is omega_0.dtype and () != A.shape == C.shape == E_1.shape == lambda_1.shape == omega_0.shape:
                if 6 < A.size <= SMALL:
                    return _discriminant(A, C, E_1, lambda_1, omega_0)
                return alike(A, C, E_1, lambda_1, omega_0)
        return others((A, C, E_1, lambda_1, omega_0,), out)

    return call


def _discriminant(A, C, E_1, lambda_1, omega_0, out_D=None, r0=None, r1=None, r2=None, r3=None, n4=array(4.0)):
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


def boundary_of_stability(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _boundary_of_stability, 6, (0, 1,), 8)

    def call(A, E_1, b_1, out=None):
        if out is None:
            if float is type(A) is type(E_1) is type(b_1):
                try:
                    return formula(A, E_1, b_1)
                except UNDEFINED:
                    pass
            elif ndarray is type(A) is type(E_1) is type(b_1) and DOUBLE is A.dtype is E_1.dtype is b_1.dtype and () != A.shape == E_1.shape == b_1.shape:
                if 8 < A.size <= SMALL:
                    return _boundary_of_stability(A, E_1, b_1)
                return alike(A, E_1, b_1)
        return others((A, E_1, b_1,), out)

    return call


def _boundary_of_stability(A, E_1, b_1, out_Delta_1=None, out_Delta_2=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, n1=array(1.0), n2=array(2.0)):
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


def width_of_the_unstable_interval(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _width_of_the_unstable_interval, 4, (0,), 2)

    def call(A, E_1, b_1, out=None):
        if out is None:
            if float is type(A) is type(E_1) is type(b_1):
                try:
                    return formula(A, E_1, b_1)
                except UNDEFINED:
                    pass
            elif ndarray is type(A) is type(E_1) is type(b_1) and DOUBLE is A.dtype is E_1.dtype is b_1.dtype and () != A.shape == E_1.shape == b_1.shape:
                if 2 < A.size <= SMALL:
                    return _width_of_the_unstable_interval(A, E_1, b_1)
                return alike(A, E_1, b_1)
        return others((A, E_1, b_1,), out)

    return call


def _width_of_the_unstable_interval(A, E_1, b_1, out_width=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0), n4=array(4.0)):
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


def critical_frequencies(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _critical_frequencies, 3, (0, 1,), 2)

    def call(A, E_1, b_1, omega_0, out=None):
        if out is None:
            if float is type(A) is type(E_1) is type(b_1) is type(omega_0):
                try:
                    return formula(A, E_1, b_1, omega_0)
                except UNDEFINED:
                    pass
            elif ndarray is type(A) is type(E_1) is type(b_1) is type(omega_0) and DOUBLE is A.dtype is E_1.dtype is b_1.dtype is omega_0.dtype and () != A.shape == E_1.shape == b_1.shape == omega_0.shape:
                if 2 < A.size <= SMALL:
                    return _critical_frequencies(A, E_1, b_1, omega_0)
                return alike(A, E_1, b_1, omega_0)
        return others((A, E_1, b_1, omega_0,), out)

    return call


def _critical_frequencies(A, E_1, b_1, omega_0, out_eta_1=None, out_eta_2=None, r0=None, r1=None, r2=None, n1=array(1.0)):
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


def greatest_growth_rate(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _greatest_growth_rate, 3, (0,), 1)

    def call(A, E_1, b_1, omega_0, out=None):
        if out is None:
            if float is type(A) is type(E_1) is type(b_1) is type(omega_0):
                try:
                    return formula(A, E_1, b_1, omega_0)
                except UNDEFINED:
                    pass
            elif ndarray is type(A) is type(E_1) is type(b_1) is type(omega_0) and DOUBLE is A.dtype is E_1.dtype is b_1.dtype is omega_0.dtype and () != A.shape == E_1.shape == b_1.shape == omega_0.shape:
                if 1 < A.size <= SMALL:
                    return _greatest_growth_rate(A, E_1, b_1, omega_0)
                return alike(A, E_1, b_1, omega_0)
        return others((A, E_1, b_1, omega_0,), out)

    return call


def _greatest_growth_rate(A, E_1, b_1, omega_0, out_y=None, r0=None, r1=None, r2=None, n1=array(1.0)):
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


def frequencies(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _frequencies, 4, (0, 1,), 6)

    def call(A, Delta, E_1, b_1, omega_0, out=None):
        if out is None:
            if float is type(A) is type(Delta) is type(E_1) is type(b_1) is type(omega_0):
                try:
                    return formula(A, Delta, E_1, b_1, omega_0)
                except UNDEFINED:
                    pass
            elif ndarray is type(A) is type(Delta) is type(E_1) is type(b_1) is type(omega_0) and DOUBLE is A.dtype is Delta.dtype is E_1.dtype is b_1.dtype is omega_0.dtype and () != A.shape == Delta.shape == E_1.shape == b_1.shape == omega_0.shape:
                if 6 < A.size <= SMALL:
                    return _frequencies(A, Delta, E_1, b_1, omega_0)
                return alike(A, Delta, E_1, b_1, omega_0)
        return others((A, Delta, E_1, b_1, omega_0,), out)

    return call


def _frequencies(A, Delta, E_1, b_1, omega_0, out_eta_1=None, out_eta_2=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0), n4=array(4.0), n1_2=array(1.0 / 2.0)):
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
