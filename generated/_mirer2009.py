"""How the kernels of mirer2009 run on numbers and on arrays. Written by `symcheck generate`: what is changed here is lost."""

# mypy: ignore-errors
import math

from numpy import array, ndarray, add, arctan, cos, divide, multiply, negative, sin, sqrt, subtract, tan

from symcheck.kernels.runtime import DOUBLE, FEW, SMALL, UNDEFINED, on_arrays


def direction_cosines(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _direction_cosines, 9, (0, 1, 2, 3, 4, 5, 6, 7, 8,), 2)

    def call(alpha, beta, gamma, out=None):
        if out is None:
            if float is type(alpha) is type(beta) is type(gamma):
                try:
                    return formula(alpha, beta, gamma)
                except UNDEFINED:
                    pass
            elif ndarray is type(alpha) is type(beta) is type(gamma) and DOUBLE is alpha.dtype is beta.dtype is gamma.dtype and () != alpha.shape == beta.shape == gamma.shape:
                if 2 < alpha.size <= SMALL:
                    return _direction_cosines(alpha, beta, gamma)
                return alike(alpha, beta, gamma)
        return others((alpha, beta, gamma,), out)

    return call


def _direction_cosines(alpha, beta, gamma, out_a_11=None, out_a_12=None, out_a_13=None, out_a_21=None, out_a_22=None, out_a_23=None, out_a_31=None, out_a_32=None, out_a_33=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None):
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


def axial_moments(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _axial_moments, 3, (0, 1, 2,), 5)

    def call(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
        if out is None:
            if float is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                try:
                    return formula(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                except UNDEFINED:
                    pass
            elif ndarray is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != I_1.shape == I_2.shape == I_3.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                if 5 < I_1.size <= SMALL:
                    return _axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return alike(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
        return others((I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)

    return call


def _axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_J_1=None, out_J_2=None, out_J_3=None, r0=None, r1=None, r2=None):
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


def second_order_moments(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _second_order_moments, 6, (0, 1, 2,), 6)

    def call(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
        if out is None:
            if float is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                try:
                    return formula(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                except UNDEFINED:
                    pass
            elif ndarray is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != I_1.shape == I_2.shape == I_3.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                if 6 < I_1.size <= SMALL:
                    return _second_order_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return alike(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
        return others((I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)

    return call


def _second_order_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_L_1=None, out_L_2=None, out_L_3=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None):
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


def product_of_axial_moments(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _product_of_axial_moments, 5, (0,), 8)

    def call(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
        if out is None:
            if float is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                try:
                    return formula(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                except UNDEFINED:
                    pass
            elif ndarray is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != I_1.shape == I_2.shape == I_3.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                if 8 < I_1.size <= SMALL:
                    return _product_of_axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return alike(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
        return others((I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)

    return call


def _product_of_axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_f=None, r0=None, r1=None, r2=None, r3=None, r4=None):
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


def sum_of_products(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _sum_of_products, 15, (0,), 15)

    def call(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
        if out is None:
            if float is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                try:
                    return formula(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                except UNDEFINED:
                    pass
            elif ndarray is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != I_1.shape == I_2.shape == I_3.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                if 15 < I_1.size <= SMALL:
                    return _sum_of_products(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return alike(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
        return others((I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)

    return call


def _sum_of_products(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_S=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None, r9=None, r10=None, r11=None, r12=None, r13=None, r14=None):
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


def bounds_of_products(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _bounds_of_products, 2, (0, 1, 2,), 1)

    def call(I_1, I_2, I_3, out=None):
        if out is None:
            if float is type(I_1) is type(I_2) is type(I_3):
                try:
                    return formula(I_1, I_2, I_3)
                except UNDEFINED:
                    pass
            elif ndarray is type(I_1) is type(I_2) is type(I_3) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype and () != I_1.shape == I_2.shape == I_3.shape:
                if 1 < I_1.size <= SMALL:
                    return _bounds_of_products(I_1, I_2, I_3)
                return alike(I_1, I_2, I_3)
        return others((I_1, I_2, I_3,), out)

    return call


def _bounds_of_products(I_1, I_2, I_3, out_f_least=None, out_f_greatest=None, out_S_least=None, r0=None, r1=None, n1_27=array(1.0 / 27.0), n3=array(3.0)):
    r0 = multiply(I_1, I_2, r0)  # t1
    out_f_least = multiply(I_3, r0, out_f_least)  # t2
    r0 = add(I_1, I_2, r0)  # t3
    r0 = add(I_3, r0, r0)  # t4
    r1 = multiply(r0, r0, r1)  # t5
    r1 = multiply(r0, r1, r1)  # t6
    out_f_greatest = multiply(n1_27, r1, out_f_greatest)  # t7
    out_S_least = multiply(n3, out_f_least, out_S_least)  # t8
    return out_f_least, out_f_greatest, out_S_least


def distances_from_bounds(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _distances_from_bounds, 19, (0, 1, 2,), 18)

    def call(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
        if out is None:
            if float is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                try:
                    return formula(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                except UNDEFINED:
                    pass
            elif ndarray is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != I_1.shape == I_2.shape == I_3.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                if 18 < I_1.size <= SMALL:
                    return _distances_from_bounds(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return alike(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
        return others((I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)

    return call


def _distances_from_bounds(I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_f_excess=None, out_f_deficit=None, out_S_excess=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None, r9=None, r10=None, r11=None, r12=None, r13=None, r14=None, r15=None, r16=None, r17=None, r18=None, n1_4=array(1.0 / 4.0), n1_3=array(1.0 / 3.0)):
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


def bound_at_given_moment(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _bound_at_given_moment, 4, (0,), 1)

    def call(I_1, I_2, I_3, J_2, out=None):
        if out is None:
            if float is type(I_1) is type(I_2) is type(I_3) is type(J_2):
                try:
                    return formula(I_1, I_2, I_3, J_2)
                except UNDEFINED:
                    pass
            elif ndarray is type(I_1) is type(I_2) is type(I_3) is type(J_2) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is J_2.dtype and () != I_1.shape == I_2.shape == I_3.shape == J_2.shape:
                if 1 < I_1.size <= SMALL:
                    return _bound_at_given_moment(I_1, I_2, I_3, J_2)
                return alike(I_1, I_2, I_3, J_2)
        return others((I_1, I_2, I_3, J_2,), out)

    return call


def _bound_at_given_moment(I_1, I_2, I_3, J_2, out_f_1=None, r0=None, r1=None, r2=None, r3=None, n1_2=array(1.0 / 2.0)):
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


def product_of_two_axial_moments(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _product_of_two_axial_moments, 4, (0,), 5)

    def call(I_1, I_2, I_3, a_11, a_12, a_13, a_31, a_32, a_33, out=None):
        if out is None:
            if float is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_31) is type(a_32) is type(a_33):
                try:
                    return formula(I_1, I_2, I_3, a_11, a_12, a_13, a_31, a_32, a_33)
                except UNDEFINED:
                    pass
            elif ndarray is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != I_1.shape == I_2.shape == I_3.shape == a_11.shape == a_12.shape == a_13.shape == a_31.shape == a_32.shape == a_33.shape:
                if 5 < I_1.size <= SMALL:
                    return _product_of_two_axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_31, a_32, a_33)
                return alike(I_1, I_2, I_3, a_11, a_12, a_13, a_31, a_32, a_33)
        return others((I_1, I_2, I_3, a_11, a_12, a_13, a_31, a_32, a_33,), out)

    return call


def _product_of_two_axial_moments(I_1, I_2, I_3, a_11, a_12, a_13, a_31, a_32, a_33, out_J_1_J_3=None, r0=None, r1=None, r2=None, r3=None):
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


def product_with_second_moment(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _product_with_second_moment, 6, (0,), 6)

    def call(I_1, I_2, I_3, a_21, a_22, a_23, out=None):
        if out is None:
            if float is type(I_1) is type(I_2) is type(I_3) is type(a_21) is type(a_22) is type(a_23):
                try:
                    return formula(I_1, I_2, I_3, a_21, a_22, a_23)
                except UNDEFINED:
                    pass
            elif ndarray is type(I_1) is type(I_2) is type(I_3) is type(a_21) is type(a_22) is type(a_23) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is a_21.dtype is a_22.dtype is a_23.dtype and () != I_1.shape == I_2.shape == I_3.shape == a_21.shape == a_22.shape == a_23.shape:
                if 6 < I_1.size <= SMALL:
                    return _product_with_second_moment(I_1, I_2, I_3, a_21, a_22, a_23)
                return alike(I_1, I_2, I_3, a_21, a_22, a_23)
        return others((I_1, I_2, I_3, a_21, a_22, a_23,), out)

    return call


def _product_with_second_moment(I_1, I_2, I_3, a_21, a_22, a_23, out_J_2_L_2=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None):
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


def damping_matrix(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _damping_matrix, 6, (0, 1, 2, 3, 4, 5,), 8)

    def call(k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
        if out is None:
            if float is type(k_1) is type(k_2) is type(k_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                try:
                    return formula(k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                except UNDEFINED:
                    pass
            elif ndarray is type(k_1) is type(k_2) is type(k_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is k_1.dtype is k_2.dtype is k_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != k_1.shape == k_2.shape == k_3.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                if 8 < k_1.size <= SMALL:
                    return _damping_matrix(k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return alike(k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
        return others((k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)

    return call


def _damping_matrix(k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_m_11=None, out_m_12=None, out_m_13=None, out_m_22=None, out_m_23=None, out_m_33=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None):
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


def characteristic_coefficients(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _characteristic_coefficients, 17, (0, 1, 2, 3,), 12)

    def call(I_1, I_2, I_3, k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
        if out is None:
            if float is type(I_1) is type(I_2) is type(I_3) is type(k_1) is type(k_2) is type(k_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                try:
                    return formula(I_1, I_2, I_3, k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                except UNDEFINED:
                    pass
            elif ndarray is type(I_1) is type(I_2) is type(I_3) is type(k_1) is type(k_2) is type(k_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is k_1.dtype is k_2.dtype is k_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != I_1.shape == I_2.shape == I_3.shape == k_1.shape == k_2.shape == k_3.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                if 12 < I_1.size <= SMALL:
                    return _characteristic_coefficients(I_1, I_2, I_3, k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return alike(I_1, I_2, I_3, k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
        return others((I_1, I_2, I_3, k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)

    return call


def _characteristic_coefficients(I_1, I_2, I_3, k_1, k_2, k_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_c_3=None, out_c_2=None, out_c_1=None, out_c_0=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None, r9=None, r10=None, r11=None, r12=None, r13=None, r14=None, r15=None, r16=None):
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


def characteristic_coefficients_at_common_ratio(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _characteristic_coefficients_at_common_ratio, 17, (0, 1, 2, 3,), 12)

    def call(I_1, I_2, I_3, k, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
        if out is None:
            if float is type(I_1) is type(I_2) is type(I_3) is type(k) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                try:
                    return formula(I_1, I_2, I_3, k, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                except UNDEFINED:
                    pass
            elif ndarray is type(I_1) is type(I_2) is type(I_3) is type(k) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype is k.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != I_1.shape == I_2.shape == I_3.shape == k.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                if 12 < I_1.size <= SMALL:
                    return _characteristic_coefficients_at_common_ratio(I_1, I_2, I_3, k, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return alike(I_1, I_2, I_3, k, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
        return others((I_1, I_2, I_3, k, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)

    return call


def _characteristic_coefficients_at_common_ratio(I_1, I_2, I_3, k, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_c_3=None, out_c_2=None, out_c_1=None, out_c_0=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None, r9=None, r10=None, r11=None, r12=None, r13=None, r14=None, r15=None, r16=None, n3=array(3.0)):
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


def gains_in_proportion(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _gains_in_proportion, 3, (0, 1, 2,), 6)

    def call(k, I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out=None):
        if out is None:
            if float is type(k) is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33):
                try:
                    return formula(k, I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                except UNDEFINED:
                    pass
            elif ndarray is type(k) is type(I_1) is type(I_2) is type(I_3) is type(a_11) is type(a_12) is type(a_13) is type(a_21) is type(a_22) is type(a_23) is type(a_31) is type(a_32) is type(a_33) and DOUBLE is k.dtype is I_1.dtype is I_2.dtype is I_3.dtype is a_11.dtype is a_12.dtype is a_13.dtype is a_21.dtype is a_22.dtype is a_23.dtype is a_31.dtype is a_32.dtype is a_33.dtype and () != k.shape == I_1.shape == I_2.shape == I_3.shape == a_11.shape == a_12.shape == a_13.shape == a_21.shape == a_22.shape == a_23.shape == a_31.shape == a_32.shape == a_33.shape:
                if 6 < k.size <= SMALL:
                    return _gains_in_proportion(k, I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
                return alike(k, I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33)
        return others((k, I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33,), out)

    return call


def _gains_in_proportion(k, I_1, I_2, I_3, a_11, a_12, a_13, a_21, a_22, a_23, a_31, a_32, a_33, out_k_1=None, out_k_2=None, out_k_3=None, r0=None, r1=None, r2=None):
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


def gain_of_rates(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _gain_of_rates, 4, (0, 1,), 5)

    def call(xi, s_1, s_2, s_3, out=None):
        if out is None:
            if float is type(xi) is type(s_1) is type(s_2) is type(s_3):
                try:
                    return formula(xi, s_1, s_2, s_3)
                except UNDEFINED:
                    pass
            elif ndarray is type(xi) is type(s_1) is type(s_2) is type(s_3) and DOUBLE is xi.dtype is s_1.dtype is s_2.dtype is s_3.dtype and () != xi.shape == s_1.shape == s_2.shape == s_3.shape:
                if 5 < xi.size <= SMALL:
                    return _gain_of_rates(xi, s_1, s_2, s_3)
                return alike(xi, s_1, s_2, s_3)
        return others((xi, s_1, s_2, s_3,), out)

    return call


def _gain_of_rates(xi, s_1, s_2, s_3, out_k=None, out_k_excess=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0), n3=array(3.0)):
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


def stability_degree_in_pitch(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _stability_degree_in_pitch, 4, (0,), 6)

    def call(k, I_1, I_3, alpha, out=None):
        if out is None:
            if float is type(k) is type(I_1) is type(I_3) is type(alpha):
                try:
                    return formula(k, I_1, I_3, alpha)
                except UNDEFINED:
                    pass
            elif ndarray is type(k) is type(I_1) is type(I_3) is type(alpha) and DOUBLE is k.dtype is I_1.dtype is I_3.dtype is alpha.dtype and () != k.shape == I_1.shape == I_3.shape == alpha.shape:
                if 6 < k.size <= SMALL:
                    return _stability_degree_in_pitch(k, I_1, I_3, alpha)
                return alike(k, I_1, I_3, alpha)
        return others((k, I_1, I_3, alpha,), out)

    return call


def _stability_degree_in_pitch(k, I_1, I_3, alpha, out_xi=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0)):
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


def equal_moment_pitch(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _equal_moment_pitch, 2, (0,), 2)

    def call(I_1, I_2, I_3, out=None):
        if out is None:
            if float is type(I_1) is type(I_2) is type(I_3):
                try:
                    return formula(I_1, I_2, I_3)
                except UNDEFINED:
                    pass
            elif ndarray is type(I_1) is type(I_2) is type(I_3) and DOUBLE is I_1.dtype is I_2.dtype is I_3.dtype and () != I_1.shape == I_2.shape == I_3.shape:
                if 2 < I_1.size <= SMALL:
                    return _equal_moment_pitch(I_1, I_2, I_3)
                return alike(I_1, I_2, I_3)
        return others((I_1, I_2, I_3,), out)

    return call


def _equal_moment_pitch(I_1, I_2, I_3, out_alpha=None, r0=None, r1=None, n2=array(2.0), n1=array(1.0), sqrt_3=array(math.sqrt(3.0)), n1_3=array(1.0 / 3.0), n1_2=array(1.0 / 2.0)):
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
