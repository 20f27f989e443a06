"""How the kernels of poloskov2004 run on numbers and on arrays. Written by `symcheck generate`: what is changed here is lost."""

# mypy: ignore-errors
import math

from numpy import array, ndarray, add, cos, divide, exp, expm1, log, log1p, multiply, negative, power, sin, sqrt, subtract

from symcheck.kernels.ratios import expm1_ratio, gamma_ratio, log1p_ratio
from symcheck.kernels.runtime import DOUBLE, FEW, SMALL, UNDEFINED, on_arrays


def stratonovich_drift(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _stratonovich_drift, 10, (0, 1, 2,), 10)

    def call(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, out=None):
        if out is None:
            if float is type(a) is type(psi) is type(Omega) is type(k) is type(varepsilon) is type(d_11) is type(d_12) is type(d_13) is type(d_21) is type(d_22) is type(d_23) is type(d_31) is type(d_32) is type(d_33):
                try:
                    return formula(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(psi) is type(Omega) is type(k) is type(varepsilon) is type(d_11) is type(d_12) is type(d_13) is type(d_21) is type(d_22) is type(d_23) is type(d_31) is type(d_32) is type(d_33) and DOUBLE is a.dtype is psi.dtype is Omega.dtype is k.dtype is varepsilon.dtype is d_11.dtype is d_12.dtype is d_13.dtype is d_21.dtype is d_22.dtype is d_23.dtype is d_31.dtype is d_32.dtype is d_33.dtype and () != a.shape == psi.shape == Omega.shape == k.shape == varepsilon.shape == d_11.shape == d_12.shape == d_13.shape == d_21.shape == d_22.shape == d_23.shape == d_31.shape == d_32.shape == d_33.shape:
                if 10 < a.size <= SMALL:
                    return _stratonovich_drift(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33)
                return alike(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33)
        return others((a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33,), out)

    return call


def _stratonovich_drift(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, out_v_1=None, out_v_2=None, out_v_3=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None, r9=None):
    r0 = sin(psi, r0)  # sin_psi
    r1 = divide(Omega, k, r1)  # t1
    r2 = cos(psi, r2)  # cos_psi
    r3 = multiply(r2, r2, r3)  # cos_psi_squared
    r4 = multiply(r0, r0, r4)  # sin_psi_squared
    r5 = multiply(r2, r0, r5)  # t2
    r6 = multiply(r3, d_11, r6)  # t3
    r7 = multiply(d_12, r5, r7)  # t4
    r8 = multiply(d_21, r5, r8)  # t5
    r9 = multiply(d_22, r4, r9)  # t6
    r8 = add(r7, r8, r8)  # t7
    r6 = subtract(r8, r6, r6)  # t8
    r9 = subtract(r6, r9, r9)  # t9
    r9 = multiply(a, r9, r9)  # t10
    r6 = multiply(r2, r1, r6)  # t11
    r6 = multiply(d_13, r6, r6)  # t12
    r8 = multiply(r0, r1, r8)  # t13
    r8 = multiply(d_23, r8, r8)  # t14
    r8 = add(r9, r8, r8)  # t15
    r6 = subtract(r8, r6, r6)  # t16
    out_v_1 = multiply(r6, varepsilon, out_v_1)  # t17
    r6 = multiply(d_11, r5, r6)  # t18
    r4 = multiply(d_12, r4, r4)  # t19
    r3 = multiply(r3, d_21, r3)  # t20
    r5 = multiply(d_22, r5, r5)  # t21
    r8 = multiply(d_13, r0, r8)  # t22
    r9 = multiply(r2, d_23, r9)  # t23
    r9 = add(r8, r9, r9)  # t24
    r9 = multiply(r1, r9, r9)  # t25
    r9 = divide(r9, a, r9)  # t26
    r3 = add(r6, r3, r3)  # t27
    r3 = add(r9, r3, r3)  # t28
    r4 = subtract(r3, r4, r4)  # t29
    r5 = subtract(r4, r5, r5)  # t30
    out_v_2 = multiply(r5, varepsilon, out_v_2)  # t31
    r5 = multiply(Omega, d_33, r5)  # t32
    r2 = multiply(r2, d_31, r2)  # t33
    r0 = multiply(d_32, r0, r0)  # t34
    r2 = subtract(r0, r2, r2)  # t35
    r0 = multiply(a, k, r0)  # t36
    r0 = multiply(r2, r0, r0)  # t37
    r5 = subtract(r0, r5, r5)  # t38
    out_v_3 = multiply(r5, varepsilon, out_v_3)  # t39
    return out_v_1, out_v_2, out_v_3


def noise_intensities(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _noise_intensities, 9, (0, 1, 2, 3, 4, 5, 6, 7, 8, 9,), 2)

    def call(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23, out=None):
        if out is None:
            if float is type(a) is type(psi) is type(Omega) is type(k) is type(varepsilon) is type(g_11) is type(g_12) is type(g_21) is type(g_22) is type(g_13) is type(g_23):
                try:
                    return formula(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(psi) is type(Omega) is type(k) is type(varepsilon) is type(g_11) is type(g_12) is type(g_21) is type(g_22) is type(g_13) is type(g_23) and DOUBLE is a.dtype is psi.dtype is Omega.dtype is k.dtype is varepsilon.dtype is g_11.dtype is g_12.dtype is g_21.dtype is g_22.dtype is g_13.dtype is g_23.dtype and () != a.shape == psi.shape == Omega.shape == k.shape == varepsilon.shape == g_11.shape == g_12.shape == g_21.shape == g_22.shape == g_13.shape == g_23.shape:
                if 2 < a.size <= SMALL:
                    return _noise_intensities(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23)
                return alike(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23)
        return others((a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23,), out)

    return call


def _noise_intensities(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23, out_h_11=None, out_h_12=None, out_h_14=None, out_h_15=None, out_h_21=None, out_h_22=None, out_h_24=None, out_h_25=None, out_h_33=None, out_h_36=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None, n1=array(1.0)):
    r0 = cos(psi, r0)  # cos_psi
    r1 = sqrt(varepsilon, r1)  # sqrt_varepsilon
    r2 = multiply(a, r1, r2)  # t1
    r3 = sin(psi, r3)  # sin_psi
    r4 = multiply(r0, r1, r4)  # t2
    r5 = multiply(r3, r1, r5)  # t3
    r6 = multiply(r3, r4, r6)  # t4
    r7 = divide(n1, a, r7)  # t5
    r0 = multiply(r0, r0, r0)  # cos_psi_squared
    r8 = multiply(g_11, r2, r8)  # t6
    out_h_11 = multiply(r0, r8, out_h_11)  # t7
    r3 = multiply(r3, r3, r3)  # sin_psi_squared
    r2 = multiply(g_12, r2, r2)  # t8
    out_h_12 = multiply(r3, r2, out_h_12)  # t9
    out_h_14 = multiply(g_21, r4, out_h_14)  # t10
    r2 = multiply(g_22, r5, r2)  # t11
    out_h_15 = negative(r2, out_h_15)  # t12
    r2 = multiply(g_11, r6, r2)  # t13
    out_h_21 = negative(r2, out_h_21)  # t14
    out_h_22 = multiply(g_12, r6, out_h_22)  # t15
    r5 = multiply(r5, r7, r5)  # t16
    r5 = multiply(g_21, r5, r5)  # t17
    out_h_24 = negative(r5, out_h_24)  # t18
    r7 = multiply(r4, r7, r7)  # t19
    r7 = multiply(g_22, r7, r7)  # t20
    out_h_25 = negative(r7, out_h_25)  # t21
    r7 = multiply(Omega, r1, r7)  # t22
    out_h_33 = multiply(g_13, r7, out_h_33)  # t23
    r1 = multiply(g_23, r1, r1)  # t24
    out_h_36 = multiply(k, r1, out_h_36)  # t25
    return out_h_11, out_h_12, out_h_14, out_h_15, out_h_21, out_h_22, out_h_24, out_h_25, out_h_33, out_h_36


def drift_coefficients(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _drift_coefficients, 23, (0, 1, 2,), 17)

    def call(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, g_11, g_12, g_21, g_22, g_13, out=None):
        if out is None:
            if float is type(a) is type(psi) is type(Omega) is type(k) is type(varepsilon) is type(d_11) is type(d_12) is type(d_13) is type(d_21) is type(d_22) is type(d_23) is type(d_31) is type(d_32) is type(d_33) is type(g_11) is type(g_12) is type(g_21) is type(g_22) is type(g_13):
                try:
                    return formula(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, g_11, g_12, g_21, g_22, g_13)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(psi) is type(Omega) is type(k) is type(varepsilon) is type(d_11) is type(d_12) is type(d_13) is type(d_21) is type(d_22) is type(d_23) is type(d_31) is type(d_32) is type(d_33) is type(g_11) is type(g_12) is type(g_21) is type(g_22) is type(g_13) and DOUBLE is a.dtype is psi.dtype is Omega.dtype is k.dtype is varepsilon.dtype is d_11.dtype is d_12.dtype is d_13.dtype is d_21.dtype is d_22.dtype is d_23.dtype is d_31.dtype is d_32.dtype is d_33.dtype is g_11.dtype is g_12.dtype is g_21.dtype is g_22.dtype is g_13.dtype and () != a.shape == psi.shape == Omega.shape == k.shape == varepsilon.shape == d_11.shape == d_12.shape == d_13.shape == d_21.shape == d_22.shape == d_23.shape == d_31.shape == d_32.shape == d_33.shape == g_11.shape == g_12.shape == g_21.shape == g_22.shape == g_13.shape:
                if 17 < a.size <= SMALL:
                    return _drift_coefficients(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, g_11, g_12, g_21, g_22, g_13)
                return alike(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, g_11, g_12, g_21, g_22, g_13)
        return others((a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, g_11, g_12, g_21, g_22, g_13,), out)

    return call


def _drift_coefficients(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, g_11, g_12, g_21, g_22, g_13, out_K_1=None, out_K_2=None, out_K_3=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None, r9=None, r10=None, r11=None, r12=None, r13=None, r14=None, r15=None, r16=None, r17=None, r18=None, r19=None, r20=None, r21=None, r22=None, n1=array(1.0), n2=array(2.0), n1_2=array(1.0 / 2.0)):
    r0 = sin(psi, r0)  # sin_psi
    r1 = divide(Omega, k, r1)  # t1
    r2 = cos(psi, r2)  # cos_psi
    r3 = divide(n1, a, r3)  # t2
    r4 = multiply(g_21, g_21, r4)  # g_21_squared
    r5 = multiply(r0, r0, r5)  # sin_psi_squared
    r6 = multiply(g_22, g_22, r6)  # g_22_squared
    r7 = multiply(r2, r2, r7)  # cos_psi_squared
    r8 = multiply(n2, r7, r8)  # t3
    r9 = multiply(r2, r0, r9)  # t4
    r10 = multiply(n2, r9, r10)  # t5
    r11 = multiply(g_11, g_11, r11)  # g_11_squared
    r12 = multiply(g_12, g_12, r12)  # g_12_squared
    r13 = multiply(r5, r8, r13)  # t6
    r14 = multiply(n1_2, r11, r14)  # t7
    r15 = multiply(r2, r7, r15)  # t8
    r15 = multiply(r0, r15, r15)  # t9
    r16 = multiply(r0, r5, r16)  # t10
    r16 = multiply(r2, r16, r16)  # t11
    r17 = multiply(n1_2, r12, r17)  # t12
    r8 = multiply(d_11, r8, r8)  # t13
    r18 = multiply(d_12, r10, r18)  # t14
    r10 = multiply(d_21, r10, r10)  # t15
    r19 = multiply(d_22, r5, r19)  # t16
    r19 = multiply(n2, r19, r19)  # t17
    r20 = multiply(r5, r5, r20)  # sin_psi_squared_squared
    r20 = multiply(r12, r20, r20)  # t18
    r21 = multiply(r11, r13, r21)  # t19
    r22 = multiply(r7, r7, r22)  # cos_psi_squared_squared
    r11 = multiply(r22, r11, r11)  # t20
    r13 = multiply(r12, r13, r13)  # t21
    r10 = add(r18, r10, r10)  # t22
    r10 = add(r20, r10, r10)  # t23
    r10 = add(r21, r10, r10)  # t24
    r10 = add(r11, r10, r10)  # t25
    r10 = add(r13, r10, r10)  # t26
    r8 = subtract(r10, r8, r8)  # t27
    r19 = subtract(r8, r19, r19)  # t28
    r19 = multiply(a, r19, r19)  # t29
    r19 = multiply(n1_2, r19, r19)  # t30
    r8 = multiply(r2, r1, r8)  # t31
    r8 = multiply(d_13, r8, r8)  # t32
    r10 = multiply(r0, r1, r10)  # t33
    r10 = multiply(d_23, r10, r10)  # t34
    r13 = multiply(r4, r5, r13)  # t35
    r11 = multiply(r7, r6, r11)  # t36
    r11 = add(r13, r11, r11)  # t37
    r11 = multiply(r3, r11, r11)  # t38
    r11 = multiply(n1_2, r11, r11)  # t39
    r10 = add(r19, r10, r10)  # t40
    r10 = add(r11, r10, r10)  # t41
    r8 = subtract(r10, r8, r8)  # t42
    out_K_1 = multiply(r8, varepsilon, out_K_1)  # t43
    r8 = multiply(d_11, r9, r8)  # t44
    r5 = multiply(d_12, r5, r5)  # t45
    r7 = multiply(r7, d_21, r7)  # t46
    r10 = multiply(d_22, r9, r10)  # t47
    r11 = multiply(d_13, r0, r11)  # t48
    r19 = multiply(r2, d_23, r19)  # t49
    r19 = add(r11, r19, r19)  # t50
    r3 = multiply(r1, r3, r3)  # t51
    r3 = multiply(r19, r3, r3)  # t52
    r19 = multiply(r14, r15, r19)  # t53
    r14 = multiply(r16, r14, r14)  # t54
    r15 = multiply(r17, r15, r15)  # t55
    r17 = multiply(r16, r17, r17)  # t56
    r16 = multiply(a, a, r16)  # a_squared
    r6 = subtract(r4, r6, r6)  # t57
    r6 = multiply(r9, r6, r6)  # t58
    r16 = divide(r6, r16, r16)  # t59
    r7 = add(r8, r7, r7)  # t60
    r7 = add(r3, r7, r7)  # t61
    r7 = add(r19, r7, r7)  # t62
    r7 = add(r15, r7, r7)  # t63
    r7 = add(r16, r7, r7)  # t64
    r5 = subtract(r7, r5, r5)  # t65
    r10 = subtract(r5, r10, r10)  # t66
    r14 = subtract(r10, r14, r14)  # t67
    r17 = subtract(r14, r17, r17)  # t68
    out_K_2 = multiply(r17, varepsilon, out_K_2)  # t69
    r17 = multiply(Omega, d_33, r17)  # t70
    r14 = multiply(g_13, g_13, r14)  # g_13_squared
    r14 = multiply(Omega, r14, r14)  # t71
    r14 = multiply(n1_2, r14, r14)  # t72
    r2 = multiply(r2, d_31, r2)  # t73
    r0 = multiply(d_32, r0, r0)  # t74
    r2 = subtract(r0, r2, r2)  # t75
    r0 = multiply(a, k, r0)  # t76
    r0 = multiply(r2, r0, r0)  # t77
    r0 = add(r14, r0, r0)  # t78
    r17 = subtract(r0, r17, r17)  # t79
    out_K_3 = multiply(r17, varepsilon, out_K_3)  # t80
    return out_K_1, out_K_2, out_K_3


def diffusion_coefficients(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _diffusion_coefficients, 13, (0, 1, 2, 3,), 11)

    def call(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23, out=None):
        if out is None:
            if float is type(a) is type(psi) is type(Omega) is type(k) is type(varepsilon) is type(g_11) is type(g_12) is type(g_21) is type(g_22) is type(g_13) is type(g_23):
                try:
                    return formula(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(psi) is type(Omega) is type(k) is type(varepsilon) is type(g_11) is type(g_12) is type(g_21) is type(g_22) is type(g_13) is type(g_23) and DOUBLE is a.dtype is psi.dtype is Omega.dtype is k.dtype is varepsilon.dtype is g_11.dtype is g_12.dtype is g_21.dtype is g_22.dtype is g_13.dtype is g_23.dtype and () != a.shape == psi.shape == Omega.shape == k.shape == varepsilon.shape == g_11.shape == g_12.shape == g_21.shape == g_22.shape == g_13.shape == g_23.shape:
                if 11 < a.size <= SMALL:
                    return _diffusion_coefficients(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23)
                return alike(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23)
        return others((a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23,), out)

    return call


def _diffusion_coefficients(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23, out_K_11=None, out_K_12=None, out_K_22=None, out_K_33=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None, r9=None, r10=None, r11=None, r12=None):
    r0 = multiply(g_21, g_21, r0)  # g_21_squared
    r1 = cos(psi, r1)  # cos_psi
    r2 = multiply(r1, r1, r2)  # cos_psi_squared
    r3 = multiply(g_22, g_22, r3)  # g_22_squared
    r4 = sin(psi, r4)  # sin_psi
    r5 = multiply(r4, r4, r5)  # sin_psi_squared
    r6 = multiply(a, a, r6)  # a_squared
    r7 = multiply(g_11, g_11, r7)  # g_11_squared
    r8 = multiply(g_12, g_12, r8)  # g_12_squared
    r9 = multiply(r2, r7, r9)  # t1
    r10 = multiply(r2, r0, r10)  # t2
    r11 = multiply(r3, r5, r11)  # t3
    r12 = multiply(r2, r2, r12)  # cos_psi_squared_squared
    r7 = multiply(r12, r7, r7)  # t4
    r12 = multiply(r5, r5, r12)  # sin_psi_squared_squared
    r12 = multiply(r8, r12, r12)  # t5
    r12 = add(r7, r12, r12)  # t6
    r12 = multiply(r6, r12, r12)  # t7
    r11 = add(r10, r11, r11)  # t8
    r11 = add(r12, r11, r11)  # t9
    out_K_11 = multiply(r11, varepsilon, out_K_11)  # t10
    r11 = multiply(r8, r5, r11)  # t11
    r11 = subtract(r11, r9, r11)  # t12
    r11 = multiply(a, r11, r11)  # t13
    r12 = subtract(r3, r0, r12)  # t14
    r12 = divide(r12, a, r12)  # t15
    r12 = add(r11, r12, r12)  # t16
    r4 = multiply(r1, r4, r4)  # t17
    r4 = multiply(r4, varepsilon, r4)  # t18
    out_K_12 = multiply(r12, r4, out_K_12)  # t19
    r4 = multiply(r2, r5, r4)  # t20
    r4 = multiply(r8, r4, r4)  # t21
    r9 = multiply(r5, r9, r9)  # t22
    r5 = multiply(r0, r5, r5)  # t23
    r3 = multiply(r2, r3, r3)  # t24
    r3 = add(r5, r3, r3)  # t25
    r6 = divide(r3, r6, r6)  # t26
    r9 = add(r4, r9, r9)  # t27
    r9 = add(r6, r9, r9)  # t28
    out_K_22 = multiply(r9, varepsilon, out_K_22)  # t29
    r9 = multiply(Omega, Omega, r9)  # Omega_squared
    r6 = multiply(g_13, g_13, r6)  # g_13_squared
    r6 = multiply(r9, r6, r6)  # t30
    r9 = multiply(g_23, g_23, r9)  # g_23_squared
    r4 = multiply(k, k, r4)  # k_squared
    r4 = multiply(r9, r4, r4)  # t31
    r4 = add(r6, r4, r4)  # t32
    out_K_33 = multiply(r4, varepsilon, out_K_33)  # t33
    return out_K_11, out_K_12, out_K_22, out_K_33


def averaged_drift(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _averaged_drift, 4, (0, 1, 2,), 5)

    def call(a, Omega, alpha, beta, gamma, d_12, d_21, d_33, g_13, out=None):
        if out is None:
            if float is type(a) is type(Omega) is type(alpha) is type(beta) is type(gamma) is type(d_12) is type(d_21) is type(d_33) is type(g_13):
                try:
                    return formula(a, Omega, alpha, beta, gamma, d_12, d_21, d_33, g_13)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(Omega) is type(alpha) is type(beta) is type(gamma) is type(d_12) is type(d_21) is type(d_33) is type(g_13) and DOUBLE is a.dtype is Omega.dtype is alpha.dtype is beta.dtype is gamma.dtype is d_12.dtype is d_21.dtype is d_33.dtype is g_13.dtype and () != a.shape == Omega.shape == alpha.shape == beta.shape == gamma.shape == d_12.shape == d_21.shape == d_33.shape == g_13.shape:
                if 5 < a.size <= SMALL:
                    return _averaged_drift(a, Omega, alpha, beta, gamma, d_12, d_21, d_33, g_13)
                return alike(a, Omega, alpha, beta, gamma, d_12, d_21, d_33, g_13)
        return others((a, Omega, alpha, beta, gamma, d_12, d_21, d_33, g_13,), out)

    return call


def _averaged_drift(a, Omega, alpha, beta, gamma, d_12, d_21, d_33, g_13, out_Kbar_1=None, out_Kbar_2=None, out_Kbar_3=None, r0=None, r1=None, r2=None, r3=None, n5=array(5.0), n4=array(4.0), n8=array(8.0), n1_16=array(1.0 / 16.0), n1_2=array(1.0 / 2.0), n2=array(2.0)):
    r0 = multiply(a, a, r0)  # a_squared
    r1 = multiply(alpha, alpha, r1)  # alpha_squared
    r1 = multiply(r0, r1, r1)  # t1
    r1 = multiply(n5, r1, r1)  # t2
    r2 = multiply(beta, beta, r2)  # beta_squared
    r2 = multiply(n4, r2, r2)  # t3
    r3 = multiply(gamma, gamma, r3)  # gamma_squared
    r3 = multiply(r0, r3, r3)  # t4
    r3 = multiply(n8, r3, r3)  # t5
    r2 = add(r1, r2, r2)  # t6
    r3 = subtract(r2, r3, r3)  # t7
    r3 = multiply(n1_16, r3, r3)  # t8
    out_Kbar_1 = divide(r3, a, out_Kbar_1)  # t9
    r3 = multiply(n1_2, d_12, r3)  # t10
    r2 = multiply(n1_2, d_21, r2)  # t11
    out_Kbar_2 = subtract(r2, r3, out_Kbar_2)  # t12
    r3 = multiply(n2, d_33, r3)  # t13
    r2 = multiply(g_13, g_13, r2)  # g_13_squared
    r2 = subtract(r3, r2, r2)  # t14
    r2 = multiply(Omega, r2, r2)  # t15
    r2 = multiply(n1_2, r2, r2)  # t16
    out_Kbar_3 = negative(r2, out_Kbar_3)  # t17
    return out_Kbar_1, out_Kbar_2, out_Kbar_3


def averaged_diffusion(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _averaged_diffusion, 5, (0, 1, 2,), 4)

    def call(a, Omega, k, alpha, beta, g_13, g_23, out=None):
        if out is None:
            if float is type(a) is type(Omega) is type(k) is type(alpha) is type(beta) is type(g_13) is type(g_23):
                try:
                    return formula(a, Omega, k, alpha, beta, g_13, g_23)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(Omega) is type(k) is type(alpha) is type(beta) is type(g_13) is type(g_23) and DOUBLE is a.dtype is Omega.dtype is k.dtype is alpha.dtype is beta.dtype is g_13.dtype is g_23.dtype and () != a.shape == Omega.shape == k.shape == alpha.shape == beta.shape == g_13.shape == g_23.shape:
                if 4 < a.size <= SMALL:
                    return _averaged_diffusion(a, Omega, k, alpha, beta, g_13, g_23)
                return alike(a, Omega, k, alpha, beta, g_13, g_23)
        return others((a, Omega, k, alpha, beta, g_13, g_23,), out)

    return call


def _averaged_diffusion(a, Omega, k, alpha, beta, g_13, g_23, out_Kbar_11=None, out_Kbar_22=None, out_Kbar_33=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1_2=array(1.0 / 2.0), n3_8=array(3.0 / 8.0), n4=array(4.0), n1_8=array(1.0 / 8.0)):
    r0 = multiply(beta, beta, r0)  # beta_squared
    r1 = multiply(a, a, r1)  # a_squared
    r2 = multiply(alpha, alpha, r2)  # alpha_squared
    r2 = multiply(r1, r2, r2)  # t1
    r3 = multiply(n1_2, r0, r3)  # t2
    r4 = multiply(n3_8, r2, r4)  # t3
    out_Kbar_11 = add(r3, r4, out_Kbar_11)  # t4
    r0 = multiply(n4, r0, r0)  # t5
    r0 = add(r2, r0, r0)  # t6
    r0 = multiply(n1_8, r0, r0)  # t7
    out_Kbar_22 = divide(r0, r1, out_Kbar_22)  # t8
    r1 = multiply(Omega, Omega, r1)  # Omega_squared
    r0 = multiply(g_13, g_13, r0)  # g_13_squared
    r0 = multiply(r1, r0, r0)  # t9
    r1 = multiply(g_23, g_23, r1)  # g_23_squared
    r2 = multiply(k, k, r2)  # k_squared
    r2 = multiply(r1, r2, r2)  # t10
    out_Kbar_33 = add(r2, r0, out_Kbar_33)  # t11
    return out_Kbar_11, out_Kbar_22, out_Kbar_33


def density_of_amplitude(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _density_of_amplitude, 7, (0,), 12)

    def call(a, alpha, beta, gamma, out=None):
        if out is None:
            if float is type(a) is type(alpha) is type(beta) is type(gamma):
                try:
                    return formula(a, alpha, beta, gamma)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(alpha) is type(beta) is type(gamma) and DOUBLE is a.dtype is alpha.dtype is beta.dtype is gamma.dtype and () != a.shape == alpha.shape == beta.shape == gamma.shape:
                if 12 < a.size <= SMALL:
                    return _density_of_amplitude(a, alpha, beta, gamma)
                return alike(a, alpha, beta, gamma)
        return others((a, alpha, beta, gamma,), out)

    return call


def _density_of_amplitude(a, alpha, beta, gamma, out_p_s1=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, n2=array(2.0), n1=array(1.0), n4=array(4.0), n3=array(3.0), n3_4=array(3.0 / 4.0), n1_4=array(1.0 / 4.0)):
    r0 = multiply(n2, gamma, r0)  # t1
    r1 = add(alpha, r0, r1)  # t2
    r0 = subtract(alpha, r0, r0)  # t3
    r2 = multiply(beta, beta, r2)  # beta_squared
    r3 = multiply(a, a, r3)  # a_squared
    r4 = multiply(alpha, alpha, r4)  # alpha_squared
    r4 = multiply(r3, r4, r4)  # t4
    r5 = divide(n1, r2, r5)  # t5
    r2 = multiply(n4, r2, r2)  # t6
    r6 = multiply(n3, r4, r6)  # t7
    r6 = add(r2, r6, r6)  # t8
    r4 = multiply(r4, r5, r4)  # t9
    r4 = multiply(n3_4, r4, r4)  # t10
    r4 = log1p_ratio(r4, r4)  # t11
    r0 = multiply(r1, r0, r0)  # t12
    r3 = multiply(r3, r0, r3)  # t13
    r5 = multiply(r3, r5, r5)  # t14
    r5 = multiply(r4, r5, r5)  # t15
    r5 = multiply(n1_4, r5, r5)  # t16
    r5 = exp(r5, r5)  # t17
    r0 = multiply(a, r0, r0)  # t18
    r0 = multiply(r5, r0, r0)  # t19
    r0 = multiply(n2, r0, r0)  # t20
    r6 = divide(r0, r6, r6)  # t21
    out_p_s1 = negative(r6, out_p_s1)  # t22
    return out_p_s1


def density_of_frequency(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _density_of_frequency, 6, (0,), 14)

    def call(Omega, k, g_13, g_23, d_33, out=None):
        if out is None:
            if float is type(Omega) is type(k) is type(g_13) is type(g_23) is type(d_33):
                try:
                    return formula(Omega, k, g_13, g_23, d_33)
                except UNDEFINED:
                    pass
            elif ndarray is type(Omega) is type(k) is type(g_13) is type(g_23) is type(d_33) and DOUBLE is Omega.dtype is k.dtype is g_13.dtype is g_23.dtype is d_33.dtype and () != Omega.shape == k.shape == g_13.shape == g_23.shape == d_33.shape:
                if 14 < Omega.size <= SMALL:
                    return _density_of_frequency(Omega, k, g_13, g_23, d_33)
                return alike(Omega, k, g_13, g_23, d_33)
        return others((Omega, k, g_13, g_23, d_33,), out)

    return call


def _density_of_frequency(Omega, k, g_13, g_23, d_33, out_p_s3=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, n1=array(1.0), n1_2=array(1.0 / 2.0), sqrt_pi=array(math.sqrt(math.pi))):
    r0 = multiply(g_13, g_13, r0)  # g_13_squared
    r1 = multiply(Omega, Omega, r1)  # Omega_squared
    r2 = multiply(r1, r0, r2)  # t1
    r3 = multiply(g_23, g_23, r3)  # g_23_squared
    r4 = multiply(k, k, r4)  # k_squared
    r4 = multiply(r3, r4, r4)  # t2
    r3 = divide(n1, r4, r3)  # t3
    r5 = sqrt(d_33, r5)  # sqrt_d_33
    r4 = add(r2, r4, r4)  # t4
    r4 = sqrt(r4, r4)  # t5
    r2 = multiply(r2, r3, r2)  # t6
    r2 = log1p_ratio(r2, r2)  # t7
    r3 = multiply(r1, r3, r3)  # t8
    r3 = multiply(d_33, r3, r3)  # t9
    r3 = multiply(r2, r3, r3)  # t10
    r3 = negative(r3, r3)  # t11
    r3 = exp(r3, r3)  # t12
    r0 = divide(d_33, r0, r0)  # t13
    r0 = gamma_ratio(r0, n1_2, r0)  # t14
    r3 = multiply(r5, r3, r3)  # t15
    r3 = multiply(r0, r3, r3)  # t16
    r4 = multiply(sqrt_pi, r4, r4)  # t17
    out_p_s3 = divide(r3, r4, out_p_s3)  # t18
    return out_p_s3


def logarithm_of_constant_of_amplitude(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _logarithm_of_constant_of_amplitude, 4, (0,), 5)

    def call(alpha, beta, gamma, out=None):
        if out is None:
            if float is type(alpha) is type(beta) is type(gamma):
                try:
                    return formula(alpha, beta, gamma)
                except UNDEFINED:
                    pass
            elif ndarray is type(alpha) is type(beta) is type(gamma) and DOUBLE is alpha.dtype is beta.dtype is gamma.dtype and () != alpha.shape == beta.shape == gamma.shape:
                if 5 < alpha.size <= SMALL:
                    return _logarithm_of_constant_of_amplitude(alpha, beta, gamma)
                return alike(alpha, beta, gamma)
        return others((alpha, beta, gamma,), out)

    return call


def _logarithm_of_constant_of_amplitude(alpha, beta, gamma, out_log_C_1=None, r0=None, r1=None, r2=None, r3=None, n2=array(2.0), n1_4=array(1.0 / 4.0), n2_3=array(2.0 / 3.0)):
    r0 = multiply(n2, gamma, r0)  # t1
    r1 = add(alpha, r0, r1)  # t2
    r0 = subtract(r0, alpha, r0)  # t3
    r0 = multiply(r1, r0, r0)  # t4
    r1 = multiply(n1_4, r0, r1)  # t5
    r1 = log(r1, r1)  # t6
    r2 = multiply(alpha, alpha, r2)  # alpha_squared
    r3 = multiply(n2, beta, r3)  # t7
    r3 = log(r3, r3)  # t8
    r3 = multiply(r0, r3, r3)  # t9
    r3 = multiply(n2_3, r3, r3)  # t10
    r2 = divide(r3, r2, r2)  # t11
    out_log_C_1 = add(r2, r1, out_log_C_1)  # t12
    return out_log_C_1


def logarithm_of_constant_of_frequency(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _logarithm_of_constant_of_frequency, 3, (0,), 14)

    def call(k, g_13, g_23, d_33, out=None):
        if out is None:
            if float is type(k) is type(g_13) is type(g_23) is type(d_33):
                try:
                    return formula(k, g_13, g_23, d_33)
                except UNDEFINED:
                    pass
            elif ndarray is type(k) is type(g_13) is type(g_23) is type(d_33) and DOUBLE is k.dtype is g_13.dtype is g_23.dtype is d_33.dtype and () != k.shape == g_13.shape == g_23.shape == d_33.shape:
                if 14 < k.size <= SMALL:
                    return _logarithm_of_constant_of_frequency(k, g_13, g_23, d_33)
                return alike(k, g_13, g_23, d_33)
        return others((k, g_13, g_23, d_33,), out)

    return call


def _logarithm_of_constant_of_frequency(k, g_13, g_23, d_33, out_log_C_2=None, r0=None, r1=None, r2=None, n2=array(2.0), n1_2=array(1.0 / 2.0), sqrt_pi=array(math.sqrt(math.pi))):
    r0 = multiply(g_13, g_13, r0)  # g_13_squared
    r0 = divide(d_33, r0, r0)  # t1
    r1 = multiply(g_23, k, r1)  # t2
    r1 = log(r1, r1)  # t3
    r1 = multiply(r0, r1, r1)  # t4
    r1 = multiply(n2, r1, r1)  # t5
    r2 = sqrt(d_33, r2)  # sqrt_d_33
    r0 = gamma_ratio(r0, n1_2, r0)  # t6
    r0 = multiply(r2, r0, r0)  # t7
    r0 = divide(r0, sqrt_pi, r0)  # t8
    r0 = log(r0, r0)  # t9
    out_log_C_2 = add(r1, r0, out_log_C_2)  # t10
    return out_log_C_2


def distribution_of_amplitude(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _distribution_of_amplitude, 4, (0,), 8)

    def call(a, alpha, beta, gamma, out=None):
        if out is None:
            if float is type(a) is type(alpha) is type(beta) is type(gamma):
                try:
                    return formula(a, alpha, beta, gamma)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(alpha) is type(beta) is type(gamma) and DOUBLE is a.dtype is alpha.dtype is beta.dtype is gamma.dtype and () != a.shape == alpha.shape == beta.shape == gamma.shape:
                if 8 < a.size <= SMALL:
                    return _distribution_of_amplitude(a, alpha, beta, gamma)
                return alike(a, alpha, beta, gamma)
        return others((a, alpha, beta, gamma,), out)

    return call


def _distribution_of_amplitude(a, alpha, beta, gamma, out_F=None, r0=None, r1=None, r2=None, r3=None, n2=array(2.0), n3_4=array(3.0 / 4.0), n1_4=array(1.0 / 4.0)):
    r0 = multiply(n2, gamma, r0)  # t1
    r1 = multiply(a, a, r1)  # a_squared
    r2 = multiply(beta, beta, r2)  # beta_squared
    r2 = divide(r1, r2, r2)  # t2
    r1 = add(alpha, r0, r1)  # t3
    r0 = subtract(alpha, r0, r0)  # t4
    r3 = multiply(alpha, alpha, r3)  # alpha_squared
    r3 = multiply(r3, r2, r3)  # t5
    r3 = multiply(n3_4, r3, r3)  # t6
    r3 = log1p_ratio(r3, r3)  # t7
    r1 = multiply(r2, r1, r1)  # t8
    r1 = multiply(r0, r1, r1)  # t9
    r1 = multiply(r3, r1, r1)  # t10
    r1 = multiply(n1_4, r1, r1)  # t11
    r1 = expm1(r1, r1)  # t12
    out_F = negative(r1, out_F)  # t13
    return out_F


def quantile_of_amplitude(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _quantile_of_amplitude, 7, (0,), 11)

    def call(q, alpha, beta, gamma, out=None):
        if out is None:
            if float is type(q) is type(alpha) is type(beta) is type(gamma):
                try:
                    return formula(q, alpha, beta, gamma)
                except UNDEFINED:
                    pass
            elif ndarray is type(q) is type(alpha) is type(beta) is type(gamma) and DOUBLE is q.dtype is alpha.dtype is beta.dtype is gamma.dtype and () != q.shape == alpha.shape == beta.shape == gamma.shape:
                if 11 < q.size <= SMALL:
                    return _quantile_of_amplitude(q, alpha, beta, gamma)
                return alike(q, alpha, beta, gamma)
        return others((q, alpha, beta, gamma,), out)

    return call


def _quantile_of_amplitude(q, alpha, beta, gamma, out_a_q=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, n2=array(2.0), n1=array(1.0), n3=array(3.0)):
    r0 = multiply(n2, gamma, r0)  # t1
    r1 = add(alpha, r0, r1)  # t2
    r2 = negative(q, r2)  # t3
    r2 = log1p(r2, r2)  # t4
    r0 = subtract(r0, alpha, r0)  # t5
    r0 = divide(n1, r0, r0)  # t6
    r3 = sqrt(r1, r3)  # t7
    r4 = sqrt(r0, r4)  # t8
    r5 = negative(r2, r5)  # t9
    r5 = sqrt(r5, r5)  # t10
    r6 = multiply(alpha, alpha, r6)  # alpha_squared
    r0 = multiply(r2, r0, r0)  # t11
    r0 = multiply(r6, r0, r0)  # t12
    r0 = multiply(n3, r0, r0)  # t13
    r1 = divide(r0, r1, r1)  # t14
    r1 = negative(r1, r1)  # t15
    r1 = expm1_ratio(r1, r1)  # t16
    r1 = sqrt(r1, r1)  # t17
    r4 = multiply(beta, r4, r4)  # t18
    r4 = multiply(r5, r4, r4)  # t19
    r4 = multiply(r1, r4, r4)  # t20
    r4 = multiply(n2, r4, r4)  # t21
    out_a_q = divide(r4, r3, out_a_q)  # t22
    return out_a_q


def moment_of_amplitude(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _moment_of_amplitude, 6, (0,), 15)

    def call(m, alpha, beta, gamma, out=None):
        if out is None:
            if float is type(m) is type(alpha) is type(beta) is type(gamma):
                try:
                    return formula(m, alpha, beta, gamma)
                except UNDEFINED:
                    pass
            elif ndarray is type(m) is type(alpha) is type(beta) is type(gamma) and DOUBLE is m.dtype is alpha.dtype is beta.dtype is gamma.dtype and () != m.shape == alpha.shape == beta.shape == gamma.shape:
                if 15 < m.size <= SMALL:
                    return _moment_of_amplitude(m, alpha, beta, gamma)
                return alike(m, alpha, beta, gamma)
        return others((m, alpha, beta, gamma,), out)

    return call


def _moment_of_amplitude(m, alpha, beta, gamma, out_M_a=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, n1_2=array(1.0 / 2.0), n2=array(2.0), n1=array(1.0), n1_3=array(1.0 / 3.0)):
    r0 = multiply(n1_2, m, r0)  # t1
    r1 = multiply(n2, gamma, r1)  # t2
    r2 = add(alpha, r1, r2)  # t3
    r1 = subtract(r1, alpha, r1)  # t4
    r3 = sqrt(r2, r3)  # t5
    r4 = sqrt(r1, r4)  # t6
    r5 = multiply(n2, beta, r5)  # t7
    r4 = multiply(r3, r4, r4)  # t8
    r4 = divide(r5, r4, r4)  # t9
    r4 = power(r4, m, r4)  # t10
    r5 = gamma_ratio(n1, r0, r5)  # t11
    r3 = multiply(alpha, alpha, r3)  # alpha_squared
    r1 = multiply(r2, r1, r1)  # t12
    r1 = multiply(n1_3, r1, r1)  # t13
    r3 = divide(r1, r3, r3)  # t14
    r0 = negative(r0, r0)  # t15
    r0 = gamma_ratio(r3, r0, r0)  # t16
    r5 = multiply(r4, r5, r5)  # t17
    out_M_a = multiply(r0, r5, out_M_a)  # t18
    return out_M_a


def moment_of_frequency(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _moment_of_frequency, 4, (0,), 14)

    def call(m, k, g_13, g_23, d_33, out=None):
        if out is None:
            if float is type(m) is type(k) is type(g_13) is type(g_23) is type(d_33):
                try:
                    return formula(m, k, g_13, g_23, d_33)
                except UNDEFINED:
                    pass
            elif ndarray is type(m) is type(k) is type(g_13) is type(g_23) is type(d_33) and DOUBLE is m.dtype is k.dtype is g_13.dtype is g_23.dtype is d_33.dtype and () != m.shape == k.shape == g_13.shape == g_23.shape == d_33.shape:
                if 14 < m.size <= SMALL:
                    return _moment_of_frequency(m, k, g_13, g_23, d_33)
                return alike(m, k, g_13, g_23, d_33)
        return others((m, k, g_13, g_23, d_33,), out)

    return call


def _moment_of_frequency(m, k, g_13, g_23, d_33, out_M_Omega=None, r0=None, r1=None, r2=None, r3=None, n1_2=array(1.0 / 2.0), n1=array(1.0), sqrt_pi=array(math.sqrt(math.pi))):
    r0 = multiply(n1_2, m, r0)  # t1
    r1 = sqrt(d_33, r1)  # sqrt_d_33
    r2 = multiply(g_23, k, r2)  # t2
    r1 = divide(r2, r1, r1)  # t3
    r1 = power(r1, m, r1)  # t4
    r2 = subtract(r0, n1_2, r2)  # t5
    r2 = gamma_ratio(n1, r2, r2)  # t6
    r3 = multiply(g_13, g_13, r3)  # g_13_squared
    r3 = divide(d_33, r3, r3)  # t7
    r0 = negative(r0, r0)  # t8
    r0 = gamma_ratio(r3, r0, r0)  # t9
    r2 = multiply(r1, r2, r2)  # t10
    r0 = multiply(r2, r0, r0)  # t11
    out_M_Omega = divide(r0, sqrt_pi, out_M_Omega)  # t12
    return out_M_Omega


def mean_square_of_amplitude(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _mean_square_of_amplitude, 3, (0,), 1)

    def call(alpha, beta, gamma, out=None):
        if out is None:
            if float is type(alpha) is type(beta) is type(gamma):
                try:
                    return formula(alpha, beta, gamma)
                except UNDEFINED:
                    pass
            elif ndarray is type(alpha) is type(beta) is type(gamma) and DOUBLE is alpha.dtype is beta.dtype is gamma.dtype and () != alpha.shape == beta.shape == gamma.shape:
                if 1 < alpha.size <= SMALL:
                    return _mean_square_of_amplitude(alpha, beta, gamma)
                return alike(alpha, beta, gamma)
        return others((alpha, beta, gamma,), out)

    return call


def _mean_square_of_amplitude(alpha, beta, gamma, out_S_a=None, r0=None, r1=None, r2=None):
    r0 = multiply(beta, beta, r0)  # beta_squared
    r1 = add(alpha, gamma, r1)  # t1
    r2 = subtract(alpha, gamma, r2)  # t2
    r2 = multiply(r1, r2, r2)  # t3
    r2 = divide(r0, r2, r2)  # t4
    out_S_a = negative(r2, out_S_a)  # t5
    return out_S_a


def mean_square_of_frequency(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _mean_square_of_frequency, 3, (0,), 1)

    def call(k, g_13, g_23, d_33, out=None):
        if out is None:
            if float is type(k) is type(g_13) is type(g_23) is type(d_33):
                try:
                    return formula(k, g_13, g_23, d_33)
                except UNDEFINED:
                    pass
            elif ndarray is type(k) is type(g_13) is type(g_23) is type(d_33) and DOUBLE is k.dtype is g_13.dtype is g_23.dtype is d_33.dtype and () != k.shape == g_13.shape == g_23.shape == d_33.shape:
                if 1 < k.size <= SMALL:
                    return _mean_square_of_frequency(k, g_13, g_23, d_33)
                return alike(k, g_13, g_23, d_33)
        return others((k, g_13, g_23, d_33,), out)

    return call


def _mean_square_of_frequency(k, g_13, g_23, d_33, out_S_Omega=None, r0=None, r1=None, r2=None, n1_2=array(1.0 / 2.0)):
    r0 = multiply(g_23, g_23, r0)  # g_23_squared
    r1 = multiply(k, k, r1)  # k_squared
    r2 = multiply(g_13, g_13, r2)  # g_13_squared
    r2 = subtract(d_33, r2, r2)  # t1
    r1 = multiply(r0, r1, r1)  # t2
    r1 = multiply(n1_2, r1, r1)  # t3
    out_S_Omega = divide(r1, r2, out_S_Omega)  # t4
    return out_S_Omega


def mode_of_amplitude(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _mode_of_amplitude, 2, (0,), 1)

    def call(alpha, beta, gamma, out=None):
        if out is None:
            if float is type(alpha) is type(beta) is type(gamma):
                try:
                    return formula(alpha, beta, gamma)
                except UNDEFINED:
                    pass
            elif ndarray is type(alpha) is type(beta) is type(gamma) and DOUBLE is alpha.dtype is beta.dtype is gamma.dtype and () != alpha.shape == beta.shape == gamma.shape:
                if 1 < alpha.size <= SMALL:
                    return _mode_of_amplitude(alpha, beta, gamma)
                return alike(alpha, beta, gamma)
        return others((alpha, beta, gamma,), out)

    return call


def _mode_of_amplitude(alpha, beta, gamma, out_a_star=None, r0=None, r1=None, n8=array(8.0), n2=array(2.0)):
    r0 = multiply(alpha, alpha, r0)  # alpha_squared
    r1 = multiply(gamma, gamma, r1)  # gamma_squared
    r1 = multiply(n8, r1, r1)  # t1
    r1 = add(r0, r1, r1)  # t2
    r1 = sqrt(r1, r1)  # t3
    r0 = multiply(n2, beta, r0)  # t4
    out_a_star = divide(r0, r1, out_a_star)  # t5
    return out_a_star
