"""How the kernels of ignatov2005 run on numbers and on arrays. Written by `symcheck generate`: what is changed here is lost."""

# mypy: ignore-errors
import math

from numpy import array, ndarray, add, arctan, cos, divide, multiply, negative, power, sin, sqrt, subtract, tan

from symcheck.kernels.runtime import DOUBLE, FEW, SMALL, UNDEFINED, on_arrays


def axes_of_four_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _axes_of_four_wheels, 5, (0, 1, 2, 0, 3, 2, 0, 1, 4, 0, 3, 4,), 0)

    def call(a, b, out=None):
        if out is None:
            if float is type(a) is type(b):
                try:
                    return formula(a, b)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                if 0 < a.size <= FEW:
                    return _axes_of_four_wheels_few(a, b)
                return alike(a, b)
        return others((a, b,), out)

    return call


def _axes_of_four_wheels_few(a, b, out_e_1x=None, out_e_1y=None, out_e_1z=None, out_e_2y=None, out_e_3z=None, r0=None, r1=None):
    r0 = sin(a, r0)  # sin_a
    r1 = sin(b, r1)  # sin_b
    out_e_1x = multiply(r0, r1, out_e_1x)  # t1
    r1 = cos(b, r1)  # cos_b
    out_e_2y = multiply(r1, r0, out_e_2y)  # t2
    out_e_1y = negative(out_e_2y, out_e_1y)  # t3
    out_e_3z = cos(a, out_e_3z)  # cos_a
    out_e_1z = negative(out_e_3z, out_e_1z)  # t4
    return out_e_1x, out_e_1y, out_e_1z, out_e_1x, out_e_2y, out_e_1z, out_e_1x, out_e_1y, out_e_3z, out_e_1x, out_e_2y, out_e_3z


def _axes_of_four_wheels(a, b, out_e_1x=None, out_e_1y=None, out_e_1z=None, out_e_2y=None, out_e_3z=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r1 = add(n1, r1, r1)  # t1
    r2 = sqrt(r1, r2)  # t2
    r3 = tan(b, r3)  # tan_b
    r4 = multiply(r3, r3, r4)  # tan_b_squared
    r4 = add(n1, r4, r4)  # t4
    r4 = multiply(r1, r4, r4)  # t5
    r4 = sqrt(r4, r4)  # t6
    r3 = multiply(r0, r3, r3)  # t7
    out_e_1x = divide(r3, r4, out_e_1x)  # t8
    out_e_2y = divide(r0, r4, out_e_2y)  # t9
    out_e_1y = negative(out_e_2y, out_e_1y)  # t10
    out_e_3z = divide(n1, r2, out_e_3z)  # t11
    out_e_1z = negative(out_e_3z, out_e_1z)  # t12
    return out_e_1x, out_e_1y, out_e_1z, out_e_1x, out_e_2y, out_e_1z, out_e_1x, out_e_1y, out_e_3z, out_e_1x, out_e_2y, out_e_3z


def axes_of_six_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _axes_of_six_wheels, 3, (0, 1, 2, 3, 1, 2, 4, 1, 0, 5, 2, 3, 5, 2, 4, 5,), 0)

    def call(a, out=None):
        if out is None:
            if float is type(a):
                try:
                    return formula(a)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                if 0 < a.size <= FEW:
                    return _axes_of_six_wheels_few(a)
                return alike(a)
        return others((a,), out)

    return call


def _axes_of_six_wheels_few(a, out_e_1y=None, out_e_1z=None, out_e_2x=None, out_e_2y=None, out_e_3y=None, out_e_4z=None, r0=None, n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0))):
    r0 = sin(a, r0)  # sin_a
    out_e_1y = negative(r0, out_e_1y)  # t1
    out_e_1z = cos(a, out_e_1z)  # cos_a
    out_e_3y = multiply(n1_2, r0, out_e_3y)  # t2
    out_e_2x = multiply(sqrt_3, out_e_3y, out_e_2x)  # t3
    out_e_2y = negative(out_e_3y, out_e_2y)  # t4
    out_e_4z = negative(out_e_1z, out_e_4z)  # t5
    return out_e_1y, out_e_1z, out_e_2x, out_e_2y, out_e_1z, out_e_2x, out_e_3y, out_e_1z, out_e_1y, out_e_4z, out_e_2x, out_e_2y, out_e_4z, out_e_2x, out_e_3y, out_e_4z


def _axes_of_six_wheels(a, out_e_1y=None, out_e_1z=None, out_e_2x=None, out_e_2y=None, out_e_3y=None, out_e_4z=None, r0=None, r1=None, r2=None, n1=array(1.0), n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0))):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r1 = add(n1, r1, r1)  # t1
    r1 = sqrt(r1, r1)  # t2
    r2 = divide(r0, r1, r2)  # t3
    out_e_1y = negative(r2, out_e_1y)  # t4
    out_e_1z = divide(n1, r1, out_e_1z)  # t5
    r0 = multiply(n1_2, r0, r0)  # t6
    out_e_3y = divide(r0, r1, out_e_3y)  # t7
    out_e_2x = multiply(sqrt_3, out_e_3y, out_e_2x)  # t8
    out_e_2y = negative(out_e_3y, out_e_2y)  # t9
    out_e_4z = negative(out_e_1z, out_e_4z)  # t10
    return out_e_1y, out_e_1z, out_e_2x, out_e_2y, out_e_1z, out_e_2x, out_e_3y, out_e_1z, out_e_1y, out_e_4z, out_e_2x, out_e_2y, out_e_4z, out_e_2x, out_e_3y, out_e_4z


def momentum_of_four_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _momentum_of_four_wheels, 8, (0, 1, 2,), 4)

    def call(h_1, h_2, h_3, h_4, a, b, out=None):
        if out is None:
            if float is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(a) is type(b):
                try:
                    return formula(h_1, h_2, h_3, h_4, a, b)
                except UNDEFINED:
                    pass
            elif ndarray is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(a) is type(b) and DOUBLE is h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is a.dtype is b.dtype and () != h_1.shape == h_2.shape == h_3.shape == h_4.shape == a.shape == b.shape:
                if 4 < h_1.size <= FEW:
                    return _momentum_of_four_wheels_few(h_1, h_2, h_3, h_4, a, b)
                return alike(h_1, h_2, h_3, h_4, a, b)
        return others((h_1, h_2, h_3, h_4, a, b,), out)

    return call


def _momentum_of_four_wheels_few(h_1, h_2, h_3, h_4, a, b, out_H_x=None, out_H_y=None, out_H_z=None, r0=None, r1=None, r2=None, r3=None, r4=None):
    r0 = sin(a, r0)  # sin_a
    r1 = add(h_1, h_3, r1)  # t1
    r2 = negative(h_4, r2)  # t2
    r3 = add(h_2, h_4, r3)  # t3
    r3 = add(r1, r3, r3)  # t4
    r4 = sin(b, r4)  # sin_b
    r3 = multiply(r0, r3, r3)  # t5
    out_H_x = multiply(r4, r3, out_H_x)  # t6
    r1 = subtract(h_2, r1, r1)  # t7
    r1 = subtract(r1, r2, r1)  # t8
    r3 = cos(b, r3)  # cos_b
    r1 = multiply(r0, r1, r1)  # t9
    out_H_y = multiply(r3, r1, out_H_y)  # t10
    r1 = subtract(h_3, h_1, r1)  # t11
    r1 = subtract(r1, h_2, r1)  # t12
    r2 = subtract(r1, r2, r2)  # t13
    r1 = cos(a, r1)  # cos_a
    out_H_z = multiply(r1, r2, out_H_z)  # t14
    return out_H_x, out_H_y, out_H_z


def _momentum_of_four_wheels(h_1, h_2, h_3, h_4, a, b, out_H_x=None, out_H_y=None, out_H_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, n1=array(1.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r1 = add(n1, r1, r1)  # t1
    r2 = sqrt(r1, r2)  # t2
    r3 = add(h_1, h_3, r3)  # t4
    r4 = negative(h_4, r4)  # t5
    r5 = add(h_2, h_4, r5)  # t6
    r5 = add(r3, r5, r5)  # t7
    r6 = tan(b, r6)  # tan_b
    r7 = multiply(r6, r6, r7)  # tan_b_squared
    r7 = add(n1, r7, r7)  # t8
    r7 = multiply(r1, r7, r7)  # t9
    r7 = sqrt(r7, r7)  # t10
    r5 = multiply(r5, r0, r5)  # t11
    r6 = multiply(r5, r6, r6)  # t12
    out_H_x = divide(r6, r7, out_H_x)  # t13
    r3 = subtract(h_2, r3, r3)  # t14
    r3 = subtract(r3, r4, r3)  # t15
    r0 = multiply(r3, r0, r0)  # t16
    out_H_y = divide(r0, r7, out_H_y)  # t17
    r7 = subtract(h_3, h_1, r7)  # t18
    r7 = subtract(r7, h_2, r7)  # t19
    r4 = subtract(r7, r4, r4)  # t20
    out_H_z = divide(r4, r2, out_H_z)  # t21
    return out_H_x, out_H_y, out_H_z


def momentum_of_three_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _momentum_of_three_wheels, 7, (0, 1, 2,), 2)

    def call(h_1, h_2, h_3, a, b, out=None):
        if out is None:
            if float is type(h_1) is type(h_2) is type(h_3) is type(a) is type(b):
                try:
                    return formula(h_1, h_2, h_3, a, b)
                except UNDEFINED:
                    pass
            elif ndarray is type(h_1) is type(h_2) is type(h_3) is type(a) is type(b) and DOUBLE is h_1.dtype is h_2.dtype is h_3.dtype is a.dtype is b.dtype and () != h_1.shape == h_2.shape == h_3.shape == a.shape == b.shape:
                if 2 < h_1.size <= FEW:
                    return _momentum_of_three_wheels_few(h_1, h_2, h_3, a, b)
                return alike(h_1, h_2, h_3, a, b)
        return others((h_1, h_2, h_3, a, b,), out)

    return call


def _momentum_of_three_wheels_few(h_1, h_2, h_3, a, b, out_H_x=None, out_H_y=None, out_H_z=None, r0=None, r1=None, r2=None, r3=None):
    r0 = sin(a, r0)  # sin_a
    r1 = add(h_1, h_3, r1)  # t1
    r2 = add(h_2, r1, r2)  # t2
    r3 = sin(b, r3)  # sin_b
    r2 = multiply(r0, r2, r2)  # t3
    out_H_x = multiply(r3, r2, out_H_x)  # t4
    r1 = subtract(h_2, r1, r1)  # t5
    r2 = cos(b, r2)  # cos_b
    r1 = multiply(r0, r1, r1)  # t6
    out_H_y = multiply(r2, r1, out_H_y)  # t7
    r1 = subtract(h_3, h_1, r1)  # t8
    r1 = subtract(r1, h_2, r1)  # t9
    r2 = cos(a, r2)  # cos_a
    out_H_z = multiply(r2, r1, out_H_z)  # t10
    return out_H_x, out_H_y, out_H_z


def _momentum_of_three_wheels(h_1, h_2, h_3, a, b, out_H_x=None, out_H_y=None, out_H_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, n1=array(1.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r1 = add(n1, r1, r1)  # t1
    r2 = sqrt(r1, r2)  # t2
    r3 = add(h_1, h_3, r3)  # t4
    r4 = add(h_2, r3, r4)  # t5
    r5 = tan(b, r5)  # tan_b
    r6 = multiply(r5, r5, r6)  # tan_b_squared
    r6 = add(n1, r6, r6)  # t6
    r6 = multiply(r1, r6, r6)  # t7
    r6 = sqrt(r6, r6)  # t8
    r4 = multiply(r4, r0, r4)  # t9
    r5 = multiply(r4, r5, r5)  # t10
    out_H_x = divide(r5, r6, out_H_x)  # t11
    r3 = subtract(h_2, r3, r3)  # t12
    r0 = multiply(r3, r0, r0)  # t13
    out_H_y = divide(r0, r6, out_H_y)  # t14
    r6 = subtract(h_3, h_1, r6)  # t15
    r6 = subtract(r6, h_2, r6)  # t16
    out_H_z = divide(r6, r2, out_H_z)  # t17
    return out_H_x, out_H_y, out_H_z


def momentum_of_six_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _momentum_of_six_wheels, 6, (0, 1, 2,), 5)

    def call(h_1, h_2, h_3, h_4, h_5, h_6, a, out=None):
        if out is None:
            if float is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(h_6) is type(a):
                try:
                    return formula(h_1, h_2, h_3, h_4, h_5, h_6, a)
                except UNDEFINED:
                    pass
            elif ndarray is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(h_6) is type(a) and DOUBLE is h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is h_5.dtype is h_6.dtype is a.dtype and () != h_1.shape == h_2.shape == h_3.shape == h_4.shape == h_5.shape == h_6.shape == a.shape:
                if 5 < h_1.size <= FEW:
                    return _momentum_of_six_wheels_few(h_1, h_2, h_3, h_4, h_5, h_6, a)
                return alike(h_1, h_2, h_3, h_4, h_5, h_6, a)
        return others((h_1, h_2, h_3, h_4, h_5, h_6, a,), out)

    return call


def _momentum_of_six_wheels_few(h_1, h_2, h_3, h_4, h_5, h_6, a, out_H_x=None, out_H_y=None, out_H_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n2=array(2.0)):
    r0 = add(h_2, h_5, r0)  # t1
    r1 = sin(a, r1)  # sin_a
    r1 = multiply(n1_2, r1, r1)  # t2
    r2 = negative(h_6, r2)  # t3
    r3 = add(h_3, h_6, r3)  # t4
    r3 = add(r0, r3, r3)  # t5
    r4 = multiply(sqrt_3, r1, r4)  # t6
    out_H_x = multiply(r3, r4, out_H_x)  # t7
    r4 = multiply(n2, h_1, r4)  # t8
    r3 = multiply(n2, h_4, r3)  # t9
    r4 = subtract(h_3, r4, r4)  # t10
    r3 = subtract(r4, r3, r3)  # t11
    r0 = subtract(r3, r0, r0)  # t12
    r0 = subtract(r0, r2, r0)  # t13
    out_H_y = multiply(r0, r1, out_H_y)  # t14
    r1 = add(h_1, h_2, r1)  # t15
    r1 = add(h_3, r1, r1)  # t16
    r2 = add(r1, r2, r2)  # t17
    r2 = subtract(r2, h_4, r2)  # t18
    r2 = subtract(r2, h_5, r2)  # t19
    r1 = cos(a, r1)  # cos_a
    out_H_z = multiply(r1, r2, out_H_z)  # t20
    return out_H_x, out_H_y, out_H_z


def _momentum_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a, out_H_x=None, out_H_y=None, out_H_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, n1=array(1.0), n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n2=array(2.0)):
    r0 = add(h_2, h_5, r0)  # t1
    r1 = tan(a, r1)  # tan_a
    r2 = multiply(r1, r1, r2)  # tan_a_squared
    r2 = add(n1, r2, r2)  # t2
    r2 = sqrt(r2, r2)  # t3
    r1 = multiply(n1_2, r1, r1)  # t4
    r1 = divide(r1, r2, r1)  # t5
    r3 = negative(h_6, r3)  # t6
    r4 = add(h_3, h_6, r4)  # t7
    r4 = add(r0, r4, r4)  # t8
    r5 = multiply(sqrt_3, r1, r5)  # t9
    out_H_x = multiply(r4, r5, out_H_x)  # t10
    r5 = multiply(n2, h_1, r5)  # t11
    r4 = multiply(n2, h_4, r4)  # t12
    r5 = subtract(h_3, r5, r5)  # t13
    r4 = subtract(r5, r4, r4)  # t14
    r0 = subtract(r4, r0, r0)  # t15
    r0 = subtract(r0, r3, r0)  # t16
    out_H_y = multiply(r0, r1, out_H_y)  # t17
    r1 = add(h_1, h_2, r1)  # t18
    r1 = add(h_3, r1, r1)  # t19
    r3 = add(r1, r3, r3)  # t20
    r3 = subtract(r3, h_4, r3)  # t21
    r3 = subtract(r3, h_5, r3)  # t22
    out_H_z = divide(r3, r2, out_H_z)  # t23
    return out_H_x, out_H_y, out_H_z


def momentum_of_five_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _momentum_of_five_wheels, 5, (0, 1, 2,), 4)

    def call(h_1, h_2, h_3, h_4, h_5, a, out=None):
        if out is None:
            if float is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(a):
                try:
                    return formula(h_1, h_2, h_3, h_4, h_5, a)
                except UNDEFINED:
                    pass
            elif ndarray is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(a) and DOUBLE is h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is h_5.dtype is a.dtype and () != h_1.shape == h_2.shape == h_3.shape == h_4.shape == h_5.shape == a.shape:
                if 4 < h_1.size <= FEW:
                    return _momentum_of_five_wheels_few(h_1, h_2, h_3, h_4, h_5, a)
                return alike(h_1, h_2, h_3, h_4, h_5, a)
        return others((h_1, h_2, h_3, h_4, h_5, a,), out)

    return call


def _momentum_of_five_wheels_few(h_1, h_2, h_3, h_4, h_5, a, out_H_x=None, out_H_y=None, out_H_z=None, r0=None, r1=None, r2=None, r3=None, n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n2=array(2.0)):
    r0 = add(h_2, h_5, r0)  # t1
    r1 = sin(a, r1)  # sin_a
    r1 = multiply(n1_2, r1, r1)  # t2
    r2 = add(h_3, r0, r2)  # t3
    r3 = multiply(sqrt_3, r1, r3)  # t4
    out_H_x = multiply(r2, r3, out_H_x)  # t5
    r3 = multiply(n2, h_1, r3)  # t6
    r2 = multiply(n2, h_4, r2)  # t7
    r3 = subtract(h_3, r3, r3)  # t8
    r2 = subtract(r3, r2, r2)  # t9
    r0 = subtract(r2, r0, r0)  # t10
    out_H_y = multiply(r0, r1, out_H_y)  # t11
    r1 = add(h_1, h_2, r1)  # t12
    r1 = add(h_3, r1, r1)  # t13
    r1 = subtract(r1, h_4, r1)  # t14
    r1 = subtract(r1, h_5, r1)  # t15
    r0 = cos(a, r0)  # cos_a
    out_H_z = multiply(r0, r1, out_H_z)  # t16
    return out_H_x, out_H_y, out_H_z


def _momentum_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a, out_H_x=None, out_H_y=None, out_H_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0), n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n2=array(2.0)):
    r0 = add(h_2, h_5, r0)  # t1
    r1 = tan(a, r1)  # tan_a
    r2 = multiply(r1, r1, r2)  # tan_a_squared
    r2 = add(n1, r2, r2)  # t2
    r2 = sqrt(r2, r2)  # t3
    r1 = multiply(n1_2, r1, r1)  # t4
    r1 = divide(r1, r2, r1)  # t5
    r3 = add(h_3, r0, r3)  # t6
    r4 = multiply(sqrt_3, r1, r4)  # t7
    out_H_x = multiply(r3, r4, out_H_x)  # t8
    r4 = multiply(n2, h_1, r4)  # t9
    r3 = multiply(n2, h_4, r3)  # t10
    r4 = subtract(h_3, r4, r4)  # t11
    r3 = subtract(r4, r3, r3)  # t12
    r0 = subtract(r3, r0, r0)  # t13
    out_H_y = multiply(r0, r1, out_H_y)  # t14
    r1 = add(h_1, h_2, r1)  # t15
    r1 = add(h_3, r1, r1)  # t16
    r1 = subtract(r1, h_4, r1)  # t17
    r1 = subtract(r1, h_5, r1)  # t18
    out_H_z = divide(r1, r2, out_H_z)  # t19
    return out_H_x, out_H_y, out_H_z


def rates_of_four_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _rates_of_four_wheels, 8, (0, 1, 2,), 6)

    def call(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z, out=None):
        if out is None:
            if float is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(a) is type(b) is type(J_x) is type(J_y) is type(J_z):
                try:
                    return formula(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z)
                except UNDEFINED:
                    pass
            elif ndarray is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(a) is type(b) is type(J_x) is type(J_y) is type(J_z) and DOUBLE is h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is a.dtype is b.dtype is J_x.dtype is J_y.dtype is J_z.dtype and () != h_1.shape == h_2.shape == h_3.shape == h_4.shape == a.shape == b.shape == J_x.shape == J_y.shape == J_z.shape:
                if 6 < h_1.size <= FEW:
                    return _rates_of_four_wheels_few(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z)
                return alike(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z)
        return others((h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z,), out)

    return call


def _rates_of_four_wheels_few(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, r2=None, r3=None, r4=None):
    r0 = sin(a, r0)  # sin_a
    r1 = add(h_1, h_3, r1)  # t1
    r2 = negative(h_4, r2)  # t2
    r3 = add(h_2, h_4, r3)  # t3
    r3 = add(r1, r3, r3)  # t4
    r4 = sin(b, r4)  # sin_b
    r3 = multiply(r0, r3, r3)  # t5
    r3 = multiply(r4, r3, r3)  # t6
    r3 = divide(r3, J_x, r3)  # t7
    out_w_x = negative(r3, out_w_x)  # t8
    r1 = subtract(h_2, r1, r1)  # t9
    r1 = subtract(r1, r2, r1)  # t10
    r3 = cos(b, r3)  # cos_b
    r1 = multiply(r0, r1, r1)  # t11
    r1 = multiply(r3, r1, r1)  # t12
    r1 = divide(r1, J_y, r1)  # t13
    out_w_y = negative(r1, out_w_y)  # t14
    r1 = subtract(h_3, h_1, r1)  # t15
    r1 = subtract(r1, h_2, r1)  # t16
    r2 = subtract(r1, r2, r2)  # t17
    r1 = cos(a, r1)  # cos_a
    r2 = multiply(r1, r2, r2)  # t18
    r2 = divide(r2, J_z, r2)  # t19
    out_w_z = negative(r2, out_w_z)  # t20
    return out_w_x, out_w_y, out_w_z


def _rates_of_four_wheels(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, n1=array(1.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r1 = add(n1, r1, r1)  # t1
    r2 = sqrt(r1, r2)  # t2
    r3 = add(h_1, h_3, r3)  # t4
    r4 = negative(h_4, r4)  # t5
    r5 = add(h_2, h_4, r5)  # t6
    r5 = add(r3, r5, r5)  # t7
    r6 = tan(b, r6)  # tan_b
    r7 = multiply(r6, r6, r7)  # tan_b_squared
    r7 = add(n1, r7, r7)  # t8
    r7 = multiply(r1, r7, r7)  # t9
    r7 = sqrt(r7, r7)  # t10
    r5 = multiply(r5, r0, r5)  # t11
    r6 = multiply(r5, r6, r6)  # t12
    r5 = multiply(J_x, r7, r5)  # t13
    r5 = divide(r6, r5, r5)  # t14
    out_w_x = negative(r5, out_w_x)  # t15
    r3 = subtract(h_2, r3, r3)  # t16
    r3 = subtract(r3, r4, r3)  # t17
    r0 = multiply(r3, r0, r0)  # t18
    r7 = multiply(J_y, r7, r7)  # t19
    r7 = divide(r0, r7, r7)  # t20
    out_w_y = negative(r7, out_w_y)  # t21
    r7 = subtract(h_3, h_1, r7)  # t22
    r7 = subtract(r7, h_2, r7)  # t23
    r4 = subtract(r7, r4, r4)  # t24
    r2 = multiply(J_z, r2, r2)  # t25
    r2 = divide(r4, r2, r2)  # t26
    out_w_z = negative(r2, out_w_z)  # t27
    return out_w_x, out_w_y, out_w_z


def rates_of_three_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _rates_of_three_wheels, 7, (0, 1, 2,), 4)

    def call(h_1, h_2, h_3, a, b, J_x, J_y, J_z, out=None):
        if out is None:
            if float is type(h_1) is type(h_2) is type(h_3) is type(a) is type(b) is type(J_x) is type(J_y) is type(J_z):
                try:
                    return formula(h_1, h_2, h_3, a, b, J_x, J_y, J_z)
                except UNDEFINED:
                    pass
            elif ndarray is type(h_1) is type(h_2) is type(h_3) is type(a) is type(b) is type(J_x) is type(J_y) is type(J_z) and DOUBLE is h_1.dtype is h_2.dtype is h_3.dtype is a.dtype is b.dtype is J_x.dtype is J_y.dtype is J_z.dtype and () != h_1.shape == h_2.shape == h_3.shape == a.shape == b.shape == J_x.shape == J_y.shape == J_z.shape:
                if 4 < h_1.size <= FEW:
                    return _rates_of_three_wheels_few(h_1, h_2, h_3, a, b, J_x, J_y, J_z)
                return alike(h_1, h_2, h_3, a, b, J_x, J_y, J_z)
        return others((h_1, h_2, h_3, a, b, J_x, J_y, J_z,), out)

    return call


def _rates_of_three_wheels_few(h_1, h_2, h_3, a, b, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, r2=None, r3=None):
    r0 = sin(a, r0)  # sin_a
    r1 = add(h_1, h_3, r1)  # t1
    r2 = add(h_2, r1, r2)  # t2
    r3 = sin(b, r3)  # sin_b
    r2 = multiply(r0, r2, r2)  # t3
    r2 = multiply(r3, r2, r2)  # t4
    r2 = divide(r2, J_x, r2)  # t5
    out_w_x = negative(r2, out_w_x)  # t6
    r1 = subtract(h_2, r1, r1)  # t7
    r2 = cos(b, r2)  # cos_b
    r1 = multiply(r0, r1, r1)  # t8
    r1 = multiply(r2, r1, r1)  # t9
    r1 = divide(r1, J_y, r1)  # t10
    out_w_y = negative(r1, out_w_y)  # t11
    r1 = subtract(h_3, h_1, r1)  # t12
    r1 = subtract(r1, h_2, r1)  # t13
    r2 = cos(a, r2)  # cos_a
    r1 = multiply(r2, r1, r1)  # t14
    r1 = divide(r1, J_z, r1)  # t15
    out_w_z = negative(r1, out_w_z)  # t16
    return out_w_x, out_w_y, out_w_z


def _rates_of_three_wheels(h_1, h_2, h_3, a, b, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, n1=array(1.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r1 = add(n1, r1, r1)  # t1
    r2 = sqrt(r1, r2)  # t2
    r3 = add(h_1, h_3, r3)  # t4
    r4 = add(h_2, r3, r4)  # t5
    r5 = tan(b, r5)  # tan_b
    r6 = multiply(r5, r5, r6)  # tan_b_squared
    r6 = add(n1, r6, r6)  # t6
    r6 = multiply(r1, r6, r6)  # t7
    r6 = sqrt(r6, r6)  # t8
    r4 = multiply(r4, r0, r4)  # t9
    r5 = multiply(r4, r5, r5)  # t10
    r4 = multiply(J_x, r6, r4)  # t11
    r4 = divide(r5, r4, r4)  # t12
    out_w_x = negative(r4, out_w_x)  # t13
    r3 = subtract(h_2, r3, r3)  # t14
    r0 = multiply(r3, r0, r0)  # t15
    r6 = multiply(J_y, r6, r6)  # t16
    r6 = divide(r0, r6, r6)  # t17
    out_w_y = negative(r6, out_w_y)  # t18
    r6 = subtract(h_3, h_1, r6)  # t19
    r6 = subtract(r6, h_2, r6)  # t20
    r2 = multiply(J_z, r2, r2)  # t21
    r2 = divide(r6, r2, r2)  # t22
    out_w_z = negative(r2, out_w_z)  # t23
    return out_w_x, out_w_y, out_w_z


def rates_of_six_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _rates_of_six_wheels, 6, (0, 1, 2,), 7)

    def call(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z, out=None):
        if out is None:
            if float is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(h_6) is type(a) is type(J_x) is type(J_y) is type(J_z):
                try:
                    return formula(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z)
                except UNDEFINED:
                    pass
            elif ndarray is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(h_6) is type(a) is type(J_x) is type(J_y) is type(J_z) and DOUBLE is h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is h_5.dtype is h_6.dtype is a.dtype is J_x.dtype is J_y.dtype is J_z.dtype and () != h_1.shape == h_2.shape == h_3.shape == h_4.shape == h_5.shape == h_6.shape == a.shape == J_x.shape == J_y.shape == J_z.shape:
                if 7 < h_1.size <= FEW:
                    return _rates_of_six_wheels_few(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z)
                return alike(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z)
        return others((h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z,), out)

    return call


def _rates_of_six_wheels_few(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n2=array(2.0)):
    r0 = add(h_2, h_5, r0)  # t1
    r1 = sin(a, r1)  # sin_a
    r1 = multiply(n1_2, r1, r1)  # t2
    r2 = negative(h_6, r2)  # t3
    r3 = add(h_3, h_6, r3)  # t4
    r3 = add(r0, r3, r3)  # t5
    r4 = multiply(sqrt_3, r1, r4)  # t6
    r4 = multiply(r3, r4, r4)  # t7
    r4 = divide(r4, J_x, r4)  # t8
    out_w_x = negative(r4, out_w_x)  # t9
    r4 = multiply(n2, h_1, r4)  # t10
    r3 = multiply(n2, h_4, r3)  # t11
    r4 = subtract(h_3, r4, r4)  # t12
    r3 = subtract(r4, r3, r3)  # t13
    r0 = subtract(r3, r0, r0)  # t14
    r0 = subtract(r0, r2, r0)  # t15
    r1 = multiply(r0, r1, r1)  # t16
    r1 = divide(r1, J_y, r1)  # t17
    out_w_y = negative(r1, out_w_y)  # t18
    r1 = add(h_1, h_2, r1)  # t19
    r1 = add(h_3, r1, r1)  # t20
    r2 = add(r1, r2, r2)  # t21
    r2 = subtract(r2, h_4, r2)  # t22
    r2 = subtract(r2, h_5, r2)  # t23
    r1 = cos(a, r1)  # cos_a
    r2 = multiply(r1, r2, r2)  # t24
    r2 = divide(r2, J_z, r2)  # t25
    out_w_z = negative(r2, out_w_z)  # t26
    return out_w_x, out_w_y, out_w_z


def _rates_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, n1=array(1.0), n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n2=array(2.0)):
    r0 = add(h_2, h_5, r0)  # t1
    r1 = tan(a, r1)  # tan_a
    r2 = multiply(r1, r1, r2)  # tan_a_squared
    r2 = add(n1, r2, r2)  # t2
    r2 = sqrt(r2, r2)  # t3
    r1 = multiply(n1_2, r1, r1)  # t4
    r1 = divide(r1, r2, r1)  # t5
    r3 = negative(h_6, r3)  # t6
    r4 = add(h_3, h_6, r4)  # t7
    r4 = add(r0, r4, r4)  # t8
    r5 = multiply(sqrt_3, r1, r5)  # t9
    r5 = multiply(r4, r5, r5)  # t10
    r5 = divide(r5, J_x, r5)  # t11
    out_w_x = negative(r5, out_w_x)  # t12
    r5 = multiply(n2, h_1, r5)  # t13
    r4 = multiply(n2, h_4, r4)  # t14
    r5 = subtract(h_3, r5, r5)  # t15
    r4 = subtract(r5, r4, r4)  # t16
    r0 = subtract(r4, r0, r0)  # t17
    r0 = subtract(r0, r3, r0)  # t18
    r1 = multiply(r0, r1, r1)  # t19
    r1 = divide(r1, J_y, r1)  # t20
    out_w_y = negative(r1, out_w_y)  # t21
    r1 = add(h_1, h_2, r1)  # t22
    r1 = add(h_3, r1, r1)  # t23
    r3 = add(r1, r3, r3)  # t24
    r3 = subtract(r3, h_4, r3)  # t25
    r3 = subtract(r3, h_5, r3)  # t26
    r2 = multiply(J_z, r2, r2)  # t27
    r2 = divide(r3, r2, r2)  # t28
    out_w_z = negative(r2, out_w_z)  # t29
    return out_w_x, out_w_y, out_w_z


def rates_of_five_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _rates_of_five_wheels, 5, (0, 1, 2,), 6)

    def call(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z, out=None):
        if out is None:
            if float is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(a) is type(J_x) is type(J_y) is type(J_z):
                try:
                    return formula(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z)
                except UNDEFINED:
                    pass
            elif ndarray is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(a) is type(J_x) is type(J_y) is type(J_z) and DOUBLE is h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is h_5.dtype is a.dtype is J_x.dtype is J_y.dtype is J_z.dtype and () != h_1.shape == h_2.shape == h_3.shape == h_4.shape == h_5.shape == a.shape == J_x.shape == J_y.shape == J_z.shape:
                if 6 < h_1.size <= FEW:
                    return _rates_of_five_wheels_few(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z)
                return alike(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z)
        return others((h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z,), out)

    return call


def _rates_of_five_wheels_few(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, r2=None, r3=None, n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n2=array(2.0)):
    r0 = add(h_2, h_5, r0)  # t1
    r1 = sin(a, r1)  # sin_a
    r1 = multiply(n1_2, r1, r1)  # t2
    r2 = add(h_3, r0, r2)  # t3
    r3 = multiply(sqrt_3, r1, r3)  # t4
    r3 = multiply(r2, r3, r3)  # t5
    r3 = divide(r3, J_x, r3)  # t6
    out_w_x = negative(r3, out_w_x)  # t7
    r3 = multiply(n2, h_1, r3)  # t8
    r2 = multiply(n2, h_4, r2)  # t9
    r3 = subtract(h_3, r3, r3)  # t10
    r2 = subtract(r3, r2, r2)  # t11
    r0 = subtract(r2, r0, r0)  # t12
    r1 = multiply(r0, r1, r1)  # t13
    r1 = divide(r1, J_y, r1)  # t14
    out_w_y = negative(r1, out_w_y)  # t15
    r1 = add(h_1, h_2, r1)  # t16
    r1 = add(h_3, r1, r1)  # t17
    r1 = subtract(r1, h_4, r1)  # t18
    r1 = subtract(r1, h_5, r1)  # t19
    r0 = cos(a, r0)  # cos_a
    r1 = multiply(r0, r1, r1)  # t20
    r1 = divide(r1, J_z, r1)  # t21
    out_w_z = negative(r1, out_w_z)  # t22
    return out_w_x, out_w_y, out_w_z


def _rates_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0), n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n2=array(2.0)):
    r0 = add(h_2, h_5, r0)  # t1
    r1 = tan(a, r1)  # tan_a
    r2 = multiply(r1, r1, r2)  # tan_a_squared
    r2 = add(n1, r2, r2)  # t2
    r2 = sqrt(r2, r2)  # t3
    r1 = multiply(n1_2, r1, r1)  # t4
    r1 = divide(r1, r2, r1)  # t5
    r3 = add(h_3, r0, r3)  # t6
    r4 = multiply(sqrt_3, r1, r4)  # t7
    r4 = multiply(r3, r4, r4)  # t8
    r4 = divide(r4, J_x, r4)  # t9
    out_w_x = negative(r4, out_w_x)  # t10
    r4 = multiply(n2, h_1, r4)  # t11
    r3 = multiply(n2, h_4, r3)  # t12
    r4 = subtract(h_3, r4, r4)  # t13
    r3 = subtract(r4, r3, r3)  # t14
    r0 = subtract(r3, r0, r0)  # t15
    r1 = multiply(r0, r1, r1)  # t16
    r1 = divide(r1, J_y, r1)  # t17
    out_w_y = negative(r1, out_w_y)  # t18
    r1 = add(h_1, h_2, r1)  # t19
    r1 = add(h_3, r1, r1)  # t20
    r1 = subtract(r1, h_4, r1)  # t21
    r1 = subtract(r1, h_5, r1)  # t22
    r2 = multiply(J_z, r2, r2)  # t23
    r2 = divide(r1, r2, r2)  # t24
    out_w_z = negative(r2, out_w_z)  # t25
    return out_w_x, out_w_y, out_w_z


def vertices_of_four_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _vertices_of_four_wheels, 5, (0, 1, 2, 3, 1, 4, 3, 1, 2, 5, 1, 4, 5, 6, 7,), 1)

    def call(a, b, out=None):
        if out is None:
            if float is type(a) is type(b):
                try:
                    return formula(a, b)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                if 1 < a.size <= FEW:
                    return _vertices_of_four_wheels_few(a, b)
                return alike(a, b)
        return others((a, b,), out)

    return call


def _vertices_of_four_wheels_few(a, b, out_V_1x=None, out_V_2x=None, out_V_2y=None, out_V_2z=None, out_V_3y=None, out_V_4z=None, out_V_6y=None, out_V_7z=None, r0=None, r1=None, r2=None, n2=array(2.0), n4=array(4.0)):
    r0 = sin(a, r0)  # sin_a
    r1 = sin(b, r1)  # sin_b
    r1 = multiply(r0, r1, r1)  # t1
    out_V_2x = multiply(n2, r1, out_V_2x)  # t2
    r2 = cos(b, r2)  # cos_b
    r0 = multiply(r2, r0, r0)  # t3
    out_V_2y = multiply(n2, r0, out_V_2y)  # t4
    r2 = cos(a, r2)  # cos_a
    out_V_2z = multiply(n2, r2, out_V_2z)  # t5
    out_V_3y = negative(out_V_2y, out_V_3y)  # t6
    out_V_4z = negative(out_V_2z, out_V_4z)  # t7
    out_V_1x = multiply(n4, r1, out_V_1x)  # t8
    r0 = multiply(n4, r0, r0)  # t9
    out_V_6y = negative(r0, out_V_6y)  # t10
    r2 = multiply(n4, r2, r2)  # t11
    out_V_7z = negative(r2, out_V_7z)  # t12
    return out_V_1x, out_V_2x, out_V_2y, out_V_2z, out_V_2x, out_V_3y, out_V_2z, out_V_2x, out_V_2y, out_V_4z, out_V_2x, out_V_3y, out_V_4z, out_V_6y, out_V_7z


def _vertices_of_four_wheels(a, b, out_V_1x=None, out_V_2x=None, out_V_2y=None, out_V_2z=None, out_V_3y=None, out_V_4z=None, out_V_6y=None, out_V_7z=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0), n2=array(2.0), n4=array(4.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r1 = add(n1, r1, r1)  # t1
    r2 = sqrt(r1, r2)  # t2
    r3 = tan(b, r3)  # tan_b
    r4 = multiply(r3, r3, r4)  # tan_b_squared
    r4 = add(n1, r4, r4)  # t4
    r4 = multiply(r1, r4, r4)  # t5
    r4 = sqrt(r4, r4)  # t6
    r3 = multiply(r0, r3, r3)  # t7
    r3 = divide(r3, r4, r3)  # t8
    out_V_2x = multiply(n2, r3, out_V_2x)  # t9
    r4 = divide(r0, r4, r4)  # t10
    out_V_2y = multiply(n2, r4, out_V_2y)  # t11
    out_V_2z = divide(n2, r2, out_V_2z)  # t13
    out_V_3y = negative(out_V_2y, out_V_3y)  # t14
    out_V_4z = negative(out_V_2z, out_V_4z)  # t15
    out_V_1x = multiply(n4, r3, out_V_1x)  # t16
    r4 = multiply(n4, r4, r4)  # t17
    out_V_6y = negative(r4, out_V_6y)  # t18
    r2 = divide(n4, r2, r2)  # t19
    out_V_7z = negative(r2, out_V_7z)  # t20
    return out_V_1x, out_V_2x, out_V_2y, out_V_2z, out_V_2x, out_V_3y, out_V_2z, out_V_2x, out_V_2y, out_V_4z, out_V_2x, out_V_3y, out_V_4z, out_V_6y, out_V_7z


def vertices_of_three_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _vertices_of_three_wheels, 5, (0, 1, 2, 3, 4, 5, 3, 6, 5, 3, 4, 7,), 0)

    def call(a, b, out=None):
        if out is None:
            if float is type(a) is type(b):
                try:
                    return formula(a, b)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                if 0 < a.size <= FEW:
                    return _vertices_of_three_wheels_few(a, b)
                return alike(a, b)
        return others((a, b,), out)

    return call


def _vertices_of_three_wheels_few(a, b, out_V_1x=None, out_V_1y=None, out_V_1z=None, out_V_2x=None, out_V_2y=None, out_V_2z=None, out_V_3y=None, out_V_4z=None, r0=None, r1=None, n3=array(3.0)):
    r0 = sin(a, r0)  # sin_a
    r1 = sin(b, r1)  # sin_b
    out_V_2x = multiply(r0, r1, out_V_2x)  # t1
    r1 = cos(b, r1)  # cos_b
    out_V_2y = multiply(r1, r0, out_V_2y)  # t2
    out_V_2z = cos(a, out_V_2z)  # cos_a
    out_V_1x = multiply(n3, out_V_2x, out_V_1x)  # t3
    out_V_1y = negative(out_V_2y, out_V_1y)  # t4
    out_V_1z = negative(out_V_2z, out_V_1z)  # t5
    r0 = multiply(n3, out_V_2y, r0)  # t6
    out_V_3y = negative(r0, out_V_3y)  # t7
    r0 = multiply(n3, out_V_2z, r0)  # t8
    out_V_4z = negative(r0, out_V_4z)  # t9
    return out_V_1x, out_V_1y, out_V_1z, out_V_2x, out_V_2y, out_V_2z, out_V_2x, out_V_3y, out_V_2z, out_V_2x, out_V_2y, out_V_4z


def _vertices_of_three_wheels(a, b, out_V_1x=None, out_V_1y=None, out_V_1z=None, out_V_2x=None, out_V_2y=None, out_V_2z=None, out_V_3y=None, out_V_4z=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0), n3=array(3.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r1 = add(n1, r1, r1)  # t1
    r2 = sqrt(r1, r2)  # t2
    r3 = tan(b, r3)  # tan_b
    r4 = multiply(r3, r3, r4)  # tan_b_squared
    r4 = add(n1, r4, r4)  # t4
    r4 = multiply(r1, r4, r4)  # t5
    r4 = sqrt(r4, r4)  # t6
    r3 = multiply(r0, r3, r3)  # t7
    out_V_2x = divide(r3, r4, out_V_2x)  # t8
    out_V_2y = divide(r0, r4, out_V_2y)  # t9
    out_V_2z = divide(n1, r2, out_V_2z)  # t10
    out_V_1x = multiply(n3, out_V_2x, out_V_1x)  # t11
    out_V_1y = negative(out_V_2y, out_V_1y)  # t12
    out_V_1z = negative(out_V_2z, out_V_1z)  # t13
    r4 = multiply(n3, out_V_2y, r4)  # t14
    out_V_3y = negative(r4, out_V_3y)  # t15
    r2 = divide(n3, r2, r2)  # t16
    out_V_4z = negative(r2, out_V_4z)  # t17
    return out_V_1x, out_V_1y, out_V_1z, out_V_2x, out_V_2y, out_V_2z, out_V_2x, out_V_3y, out_V_2z, out_V_2x, out_V_2y, out_V_4z


def vertices_of_six_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _vertices_of_six_wheels, 3, (0, 1, 2, 3, 4, 2, 3, 5, 2, 6, 2, 7, 5, 2, 7, 4, 2, 7, 8, 9, 3, 8, 9, 10, 9, 3, 11, 9, 7, 11, 9, 12, 9, 12, 1, 13, 10, 1,), 0)

    def call(a, out=None):
        if out is None:
            if float is type(a):
                try:
                    return formula(a)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                if 0 < a.size <= FEW:
                    return _vertices_of_six_wheels_few(a)
                return alike(a)
        return others((a,), out)

    return call


def _vertices_of_six_wheels_few(a, out_V_1z=None, out_V_2y=None, out_V_2z=None, out_V_3x=None, out_V_3y=None, out_V_4y=None, out_V_5y=None, out_V_6x=None, out_V_8y=None, out_V_8z=None, out_V_10x=None, out_V_11y=None, out_V_13x=None, out_V_15y=None, r0=None, n2=array(2.0), n4=array(4.0), sqrt_3=array(math.sqrt(3.0)), n3=array(3.0), n6=array(6.0)):
    r0 = cos(a, r0)  # cos_a
    out_V_3y = sin(a, out_V_3y)  # sin_a
    out_V_2y = multiply(n2, out_V_3y, out_V_2y)  # t1
    out_V_2z = multiply(n4, r0, out_V_2z)  # t2
    out_V_6x = multiply(out_V_3y, sqrt_3, out_V_6x)  # t3
    out_V_3x = negative(out_V_6x, out_V_3x)  # t4
    out_V_4y = negative(out_V_3y, out_V_4y)  # t5
    out_V_8y = multiply(n3, out_V_3y, out_V_8y)  # t6
    out_V_8z = multiply(n2, r0, out_V_8z)  # t7
    out_V_13x = multiply(sqrt_3, out_V_2y, out_V_13x)  # t8
    out_V_10x = negative(out_V_13x, out_V_10x)  # t9
    out_V_11y = negative(out_V_8y, out_V_11y)  # t10
    out_V_1z = multiply(n6, r0, out_V_1z)  # t11
    out_V_5y = negative(out_V_2y, out_V_5y)  # t12
    out_V_15y = multiply(n4, out_V_3y, out_V_15y)  # t13
    return out_V_1z, out_V_2y, out_V_2z, out_V_3x, out_V_3y, out_V_2z, out_V_3x, out_V_4y, out_V_2z, out_V_5y, out_V_2z, out_V_6x, out_V_4y, out_V_2z, out_V_6x, out_V_3y, out_V_2z, out_V_6x, out_V_8y, out_V_8z, out_V_3x, out_V_8y, out_V_8z, out_V_10x, out_V_8z, out_V_3x, out_V_11y, out_V_8z, out_V_6x, out_V_11y, out_V_8z, out_V_13x, out_V_8z, out_V_13x, out_V_2y, out_V_15y, out_V_10x, out_V_2y


def _vertices_of_six_wheels(a, out_V_1z=None, out_V_2y=None, out_V_2z=None, out_V_3x=None, out_V_3y=None, out_V_4y=None, out_V_5y=None, out_V_6x=None, out_V_8y=None, out_V_8z=None, out_V_10x=None, out_V_11y=None, out_V_13x=None, out_V_15y=None, r0=None, r1=None, r2=None, n1=array(1.0), n2=array(2.0), n4=array(4.0), sqrt_3=array(math.sqrt(3.0)), n3=array(3.0), n6=array(6.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r1 = add(n1, r1, r1)  # t1
    r1 = sqrt(r1, r1)  # t2
    out_V_3y = divide(r0, r1, out_V_3y)  # t4
    r2 = multiply(n2, r0, r2)  # t5
    out_V_2y = divide(r2, r1, out_V_2y)  # t6
    out_V_2z = divide(n4, r1, out_V_2z)  # t7
    r2 = multiply(sqrt_3, r0, r2)  # t8
    out_V_6x = divide(r2, r1, out_V_6x)  # t9
    out_V_3x = negative(out_V_6x, out_V_3x)  # t10
    out_V_4y = negative(out_V_3y, out_V_4y)  # t11
    r2 = multiply(n3, r0, r2)  # t12
    out_V_8y = divide(r2, r1, out_V_8y)  # t13
    out_V_8z = divide(n2, r1, out_V_8z)  # t14
    out_V_13x = multiply(sqrt_3, out_V_2y, out_V_13x)  # t15
    out_V_10x = negative(out_V_13x, out_V_10x)  # t16
    out_V_11y = negative(out_V_8y, out_V_11y)  # t17
    out_V_1z = divide(n6, r1, out_V_1z)  # t18
    out_V_5y = negative(out_V_2y, out_V_5y)  # t19
    r0 = multiply(n4, r0, r0)  # t20
    out_V_15y = divide(r0, r1, out_V_15y)  # t21
    return out_V_1z, out_V_2y, out_V_2z, out_V_3x, out_V_3y, out_V_2z, out_V_3x, out_V_4y, out_V_2z, out_V_5y, out_V_2z, out_V_6x, out_V_4y, out_V_2z, out_V_6x, out_V_3y, out_V_2z, out_V_6x, out_V_8y, out_V_8z, out_V_3x, out_V_8y, out_V_8z, out_V_10x, out_V_8z, out_V_3x, out_V_11y, out_V_8z, out_V_6x, out_V_11y, out_V_8z, out_V_13x, out_V_8z, out_V_13x, out_V_2y, out_V_15y, out_V_10x, out_V_2y


def vertices_of_five_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _vertices_of_five_wheels, 3, (0, 1, 2, 0, 3, 4, 5, 6, 4, 5, 7, 4, 0, 8, 4, 9, 7, 4, 9, 6, 10, 5, 11, 10, 12, 1, 10, 5, 13, 10, 9, 13, 10,), 0)

    def call(a, out=None):
        if out is None:
            if float is type(a):
                try:
                    return formula(a)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                if 0 < a.size <= FEW:
                    return _vertices_of_five_wheels_few(a)
                return alike(a)
        return others((a,), out)

    return call


def _vertices_of_five_wheels_few(a, out_V_1x=None, out_V_1y=None, out_V_1z=None, out_V_2y=None, out_V_2z=None, out_V_3x=None, out_V_3y=None, out_V_4y=None, out_V_5y=None, out_V_6x=None, out_V_7z=None, out_V_8y=None, out_V_9x=None, out_V_10y=None, r0=None, n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n5_2=array(5.0 / 2.0), n3=array(3.0), n3_2=array(3.0 / 2.0), n5=array(5.0), n7_2=array(7.0 / 2.0)):
    r0 = sin(a, r0)  # sin_a
    out_V_1y = multiply(n1_2, r0, out_V_1y)  # t1
    out_V_1x = multiply(sqrt_3, out_V_1y, out_V_1x)  # t2
    out_V_7z = cos(a, out_V_7z)  # cos_a
    out_V_2y = multiply(n5_2, r0, out_V_2y)  # t3
    out_V_2z = multiply(n3, out_V_7z, out_V_2z)  # t4
    out_V_3x = negative(out_V_1x, out_V_3x)  # t5
    out_V_3y = multiply(n3_2, r0, out_V_3y)  # t6
    out_V_4y = negative(out_V_1y, out_V_4y)  # t7
    out_V_6x = multiply(sqrt_3, out_V_3y, out_V_6x)  # t8
    out_V_10y = negative(out_V_2y, out_V_10y)  # t9
    out_V_1z = multiply(n5, out_V_7z, out_V_1z)  # t10
    out_V_5y = negative(out_V_3y, out_V_5y)  # t11
    out_V_8y = multiply(n7_2, r0, out_V_8y)  # t12
    out_V_9x = negative(out_V_6x, out_V_9x)  # t13
    return out_V_1x, out_V_1y, out_V_1z, out_V_1x, out_V_2y, out_V_2z, out_V_3x, out_V_3y, out_V_2z, out_V_3x, out_V_4y, out_V_2z, out_V_1x, out_V_5y, out_V_2z, out_V_6x, out_V_4y, out_V_2z, out_V_6x, out_V_3y, out_V_7z, out_V_3x, out_V_8y, out_V_7z, out_V_9x, out_V_1y, out_V_7z, out_V_3x, out_V_10y, out_V_7z, out_V_6x, out_V_10y, out_V_7z


def _vertices_of_five_wheels(a, out_V_1x=None, out_V_1y=None, out_V_1z=None, out_V_2y=None, out_V_2z=None, out_V_3x=None, out_V_3y=None, out_V_4y=None, out_V_5y=None, out_V_6x=None, out_V_7z=None, out_V_8y=None, out_V_9x=None, out_V_10y=None, r0=None, r1=None, r2=None, n1=array(1.0), n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n5_2=array(5.0 / 2.0), n3=array(3.0), n3_2=array(3.0 / 2.0), n5=array(5.0), n7_2=array(7.0 / 2.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r1 = add(n1, r1, r1)  # t1
    r1 = sqrt(r1, r1)  # t2
    r2 = multiply(n1_2, r0, r2)  # t4
    out_V_1y = divide(r2, r1, out_V_1y)  # t5
    out_V_1x = multiply(sqrt_3, out_V_1y, out_V_1x)  # t6
    out_V_7z = divide(n1, r1, out_V_7z)  # t7
    r2 = multiply(n5_2, r0, r2)  # t8
    out_V_2y = divide(r2, r1, out_V_2y)  # t9
    out_V_2z = divide(n3, r1, out_V_2z)  # t10
    out_V_3x = negative(out_V_1x, out_V_3x)  # t11
    r2 = multiply(n3_2, r0, r2)  # t12
    out_V_3y = divide(r2, r1, out_V_3y)  # t13
    out_V_4y = negative(out_V_1y, out_V_4y)  # t14
    out_V_6x = multiply(sqrt_3, out_V_3y, out_V_6x)  # t15
    out_V_10y = negative(out_V_2y, out_V_10y)  # t16
    out_V_1z = divide(n5, r1, out_V_1z)  # t17
    out_V_5y = negative(out_V_3y, out_V_5y)  # t18
    r0 = multiply(n7_2, r0, r0)  # t19
    out_V_8y = divide(r0, r1, out_V_8y)  # t20
    out_V_9x = negative(out_V_6x, out_V_9x)  # t21
    return out_V_1x, out_V_1y, out_V_1z, out_V_1x, out_V_2y, out_V_2z, out_V_3x, out_V_3y, out_V_2z, out_V_3x, out_V_4y, out_V_2z, out_V_1x, out_V_5y, out_V_2z, out_V_6x, out_V_4y, out_V_2z, out_V_6x, out_V_3y, out_V_7z, out_V_3x, out_V_8y, out_V_7z, out_V_9x, out_V_1y, out_V_7z, out_V_3x, out_V_10y, out_V_7z, out_V_6x, out_V_10y, out_V_7z


def vertex_distances_of_four_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _vertex_distances_of_four_wheels, 4, (0, 1, 2,), 1)

    def call(a, b, out=None):
        if out is None:
            if float is type(a) is type(b):
                try:
                    return formula(a, b)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                if 1 < a.size <= FEW:
                    return _vertex_distances_of_four_wheels_few(a, b)
                return alike(a, b)
        return others((a, b,), out)

    return call


def _vertex_distances_of_four_wheels_few(a, b, out_d_1=None, out_d_2=None, out_d_3=None, r0=None, r1=None, n4=array(4.0)):
    r0 = sin(a, r0)  # sin_a
    r0 = multiply(n4, r0, r0)  # t1
    r1 = sin(b, r1)  # sin_b
    out_d_1 = multiply(r1, r0, out_d_1)  # t2
    r1 = cos(b, r1)  # cos_b
    out_d_2 = multiply(r1, r0, out_d_2)  # t3
    r0 = cos(a, r0)  # cos_a
    out_d_3 = multiply(n4, r0, out_d_3)  # t4
    return out_d_1, out_d_2, out_d_3


def _vertex_distances_of_four_wheels(a, b, out_d_1=None, out_d_2=None, out_d_3=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0), n4=array(4.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r1 = add(n1, r1, r1)  # t1
    r1 = sqrt(r1, r1)  # t2
    r0 = multiply(n4, r0, r0)  # t3
    r0 = divide(r0, r1, r0)  # t4
    r2 = tan(b, r2)  # tan_b
    r3 = multiply(r2, r2, r3)  # tan_b_squared
    r3 = add(n1, r3, r3)  # t5
    r3 = sqrt(r3, r3)  # t6
    r2 = multiply(r0, r2, r2)  # t7
    out_d_1 = divide(r2, r3, out_d_1)  # t8
    out_d_2 = divide(r0, r3, out_d_2)  # t9
    out_d_3 = divide(n4, r1, out_d_3)  # t10
    return out_d_1, out_d_2, out_d_3


def vertex_distances_of_three_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _vertex_distances_of_three_wheels, 4, (0, 1, 2,), 4)

    def call(a, b, out=None):
        if out is None:
            if float is type(a) is type(b):
                try:
                    return formula(a, b)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                if 4 < a.size <= SMALL:
                    return _vertex_distances_of_three_wheels(a, b)
                return alike(a, b)
        return others((a, b,), out)

    return call


def _vertex_distances_of_three_wheels(a, b, out_d_1=None, out_d_2=None, out_d_3=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0), n8=array(8.0)):
    r0 = tan(b, r0)  # tan_b
    r0 = multiply(r0, r0, r0)  # tan_b_squared
    r1 = tan(a, r1)  # tan_a
    r1 = multiply(r1, r1, r1)  # tan_a_squared
    r2 = add(n1, r1, r2)  # t1
    r2 = divide(n8, r2, r2)  # t2
    r3 = add(n1, r0, r3)  # t3
    r1 = multiply(r2, r1, r1)  # t4
    r3 = divide(r1, r3, r3)  # t5
    r0 = multiply(r3, r0, r0)  # t6
    r0 = add(n1, r0, r0)  # t7
    out_d_1 = sqrt(r0, out_d_1)  # t8
    r3 = add(n1, r3, r3)  # t9
    out_d_2 = sqrt(r3, out_d_2)  # t10
    r2 = add(n1, r2, r2)  # t11
    out_d_3 = sqrt(r2, out_d_3)  # t12
    return out_d_1, out_d_2, out_d_3


def vertex_distances_of_six_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _vertex_distances_of_six_wheels, 4, (0, 1, 2, 3,), 3)

    def call(a, out=None):
        if out is None:
            if float is type(a):
                try:
                    return formula(a)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                if 3 < a.size <= FEW:
                    return _vertex_distances_of_six_wheels_few(a)
                return alike(a)
        return others((a,), out)

    return call


def _vertex_distances_of_six_wheels_few(a, out_d_1=None, out_d_2=None, out_d_3=None, out_d_4=None, r0=None, r1=None, r2=None, n1=array(1.0), n6=array(6.0), n4=array(4.0), n3=array(3.0), n2=array(2.0)):
    r0 = tan(a, r0)  # tan_a
    r0 = multiply(r0, r0, r0)  # tan_a_squared
    r1 = add(n1, r0, r1)  # t1
    r1 = divide(n1, r1, r1)  # t2
    r2 = cos(a, r2)  # cos_a
    out_d_1 = multiply(n6, r2, out_d_1)  # t3
    r2 = sin(a, r2)  # sin_a
    out_d_2 = multiply(n4, r2, out_d_2)  # t4
    r2 = multiply(n3, r1, r2)  # t5
    r2 = add(n1, r2, r2)  # t6
    r2 = sqrt(r2, r2)  # t7
    out_d_3 = multiply(n2, r2, out_d_3)  # t8
    r0 = multiply(r1, r0, r0)  # t9
    r0 = multiply(n2, r0, r0)  # t10
    r0 = add(n1, r0, r0)  # t11
    r0 = sqrt(r0, r0)  # t12
    out_d_4 = multiply(n2, r0, out_d_4)  # t13
    return out_d_1, out_d_2, out_d_3, out_d_4


def _vertex_distances_of_six_wheels(a, out_d_1=None, out_d_2=None, out_d_3=None, out_d_4=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0), n6=array(6.0), n4=array(4.0), n3=array(3.0), n2=array(2.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r2 = add(n1, r1, r2)  # t1
    r3 = divide(n1, r2, r3)  # t2
    r2 = sqrt(r2, r2)  # t3
    out_d_1 = divide(n6, r2, out_d_1)  # t4
    r0 = multiply(n4, r0, r0)  # t5
    out_d_2 = divide(r0, r2, out_d_2)  # t6
    r2 = multiply(n3, r3, r2)  # t7
    r2 = add(n1, r2, r2)  # t8
    r2 = sqrt(r2, r2)  # t9
    out_d_3 = multiply(n2, r2, out_d_3)  # t10
    r1 = multiply(r3, r1, r1)  # t11
    r1 = multiply(n2, r1, r1)  # t12
    r1 = add(n1, r1, r1)  # t13
    r1 = sqrt(r1, r1)  # t14
    out_d_4 = multiply(n2, r1, out_d_4)  # t15
    return out_d_1, out_d_2, out_d_3, out_d_4


def vertex_distances_of_five_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _vertex_distances_of_five_wheels, 5, (0, 1, 2, 3, 4, 5, 6,), 4)

    def call(a, out=None):
        if out is None:
            if float is type(a):
                try:
                    return formula(a)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                if 4 < a.size <= SMALL:
                    return _vertex_distances_of_five_wheels(a)
                return alike(a)
        return others((a,), out)

    return call


def _vertex_distances_of_five_wheels(a, out_d_1=None, out_d_2=None, out_d_3=None, out_d_4=None, out_d_5=None, out_d_6=None, out_d_7=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0), n6=array(6.0), n8=array(8.0), n24=array(24.0), n2=array(2.0), n7=array(7.0), n3=array(3.0), n12=array(12.0)):
    r0 = tan(a, r0)  # tan_a
    r0 = multiply(r0, r0, r0)  # tan_a_squared
    r1 = add(n1, r0, r1)  # t1
    r1 = divide(n1, r1, r1)  # t2
    r2 = multiply(n6, r1, r2)  # t3
    r3 = multiply(n8, r1, r3)  # t4
    r4 = multiply(n24, r1, r4)  # t5
    r4 = add(n1, r4, r4)  # t6
    out_d_1 = sqrt(r4, out_d_1)  # t7
    r4 = multiply(n2, r1, r4)  # t8
    r4 = add(n7, r4, r4)  # t9
    out_d_2 = sqrt(r4, out_d_2)  # t10
    r4 = add(n3, r2, r4)  # t11
    out_d_3 = sqrt(r4, out_d_3)  # t12
    r4 = add(n1, r3, r4)  # t13
    out_d_4 = sqrt(r4, out_d_4)  # t14
    r3 = multiply(r3, r0, r3)  # t15
    r3 = add(n1, r3, r3)  # t16
    out_d_5 = sqrt(r3, out_d_5)  # t17
    r1 = multiply(r1, r0, r1)  # t18
    r1 = multiply(n12, r1, r1)  # t19
    r1 = add(n1, r1, r1)  # t20
    out_d_6 = sqrt(r1, out_d_6)  # t21
    r0 = multiply(r2, r0, r0)  # t22
    r0 = add(n1, r0, r0)  # t23
    out_d_7 = sqrt(r0, out_d_7)  # t24
    return out_d_1, out_d_2, out_d_3, out_d_4, out_d_5, out_d_6, out_d_7


def face_distances_of_four_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _face_distances_of_four_wheels, 8, (0, 1, 2,), 9)

    def call(a, b, out=None):
        if out is None:
            if float is type(a) is type(b):
                try:
                    return formula(a, b)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                if 9 < a.size <= SMALL:
                    return _face_distances_of_four_wheels(a, b)
                return alike(a, b)
        return others((a, b,), out)

    return call


def _face_distances_of_four_wheels(a, b, out_r_1=None, out_r_2=None, out_r_3=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, n1=array(1.0), n4=array(4.0), n2=array(2.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r2 = tan(b, r2)  # tan_b
    r3 = multiply(r2, r2, r3)  # tan_b_squared
    r4 = add(n1, r3, r4)  # t1
    r0 = multiply(n4, r0, r0)  # t2
    r2 = multiply(r0, r2, r2)  # t3
    r5 = multiply(r4, r4, r5)  # t4
    r6 = multiply(r1, r3, r6)  # t5
    r7 = multiply(n2, r3, r7)  # t6
    r7 = add(r6, r7, r7)  # t7
    r7 = add(n1, r7, r7)  # t8
    r7 = multiply(r7, r1, r7)  # t9
    r7 = add(r4, r7, r7)  # t10
    r7 = sqrt(r7, r7)  # t11
    out_r_1 = divide(r2, r7, out_r_1)  # t12
    r3 = add(r1, r3, r3)  # t13
    r3 = add(n2, r3, r3)  # t14
    r3 = multiply(r3, r1, r3)  # t15
    r3 = add(r4, r3, r3)  # t16
    r3 = sqrt(r3, r3)  # t17
    out_r_2 = divide(r0, r3, out_r_2)  # t18
    r1 = multiply(r5, r1, r1)  # t19
    r5 = add(r1, r5, r5)  # t20
    r5 = sqrt(r5, r5)  # t21
    out_r_3 = divide(r2, r5, out_r_3)  # t22
    return out_r_1, out_r_2, out_r_3


def face_distances_of_three_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _face_distances_of_three_wheels, 8, (0, 1, 2,), 9)

    def call(a, b, out=None):
        if out is None:
            if float is type(a) is type(b):
                try:
                    return formula(a, b)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                if 9 < a.size <= SMALL:
                    return _face_distances_of_three_wheels(a, b)
                return alike(a, b)
        return others((a, b,), out)

    return call


def _face_distances_of_three_wheels(a, b, out_r_1=None, out_r_2=None, out_r_3=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, n1=array(1.0), n2=array(2.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r2 = tan(b, r2)  # tan_b
    r3 = multiply(r2, r2, r3)  # tan_b_squared
    r4 = add(n1, r3, r4)  # t1
    r0 = multiply(n2, r0, r0)  # t2
    r2 = multiply(r0, r2, r2)  # t3
    r5 = multiply(r4, r4, r5)  # t4
    r6 = multiply(r1, r3, r6)  # t5
    r7 = multiply(n2, r3, r7)  # t6
    r7 = add(r6, r7, r7)  # t7
    r7 = add(n1, r7, r7)  # t8
    r7 = multiply(r7, r1, r7)  # t9
    r7 = add(r4, r7, r7)  # t10
    r7 = sqrt(r7, r7)  # t11
    out_r_1 = divide(r2, r7, out_r_1)  # t12
    r3 = add(r1, r3, r3)  # t13
    r3 = add(n2, r3, r3)  # t14
    r3 = multiply(r3, r1, r3)  # t15
    r3 = add(r4, r3, r3)  # t16
    r3 = sqrt(r3, r3)  # t17
    out_r_2 = divide(r0, r3, out_r_2)  # t18
    r1 = multiply(r5, r1, r1)  # t19
    r5 = add(r1, r5, r5)  # t20
    r5 = sqrt(r5, r5)  # t21
    out_r_3 = divide(r2, r5, out_r_3)  # t22
    return out_r_1, out_r_2, out_r_3


def face_distances_of_six_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _face_distances_of_six_wheels, 4, (0, 1, 2,), 6)

    def call(a, out=None):
        if out is None:
            if float is type(a):
                try:
                    return formula(a)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                if 6 < a.size <= SMALL:
                    return _face_distances_of_six_wheels(a)
                return alike(a)
        return others((a,), out)

    return call


def _face_distances_of_six_wheels(a, out_r_1=None, out_r_2=None, out_r_3=None, r0=None, r1=None, r2=None, r3=None, n7_3=array(7.0 / 3.0), n4_3=array(4.0 / 3.0), n6=array(6.0), n5=array(5.0), n4=array(4.0), n8=array(8.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r2 = add(n7_3, r1, r2)  # t1
    r2 = multiply(r2, r1, r2)  # t2
    r2 = add(n4_3, r2, r2)  # t3
    r2 = sqrt(r2, r2)  # t4
    r3 = multiply(n6, r0, r3)  # t5
    out_r_1 = divide(r3, r2, out_r_1)  # t6
    r2 = add(n5, r1, r2)  # t7
    r2 = multiply(r2, r1, r2)  # t8
    r2 = add(n4, r2, r2)  # t9
    r2 = sqrt(r2, r2)  # t10
    r3 = multiply(n8, r0, r3)  # t11
    out_r_2 = divide(r3, r2, out_r_2)  # t12
    r1 = multiply(n4_3, r1, r1)  # t13
    r1 = add(n4_3, r1, r1)  # t14
    r1 = sqrt(r1, r1)  # t15
    r0 = multiply(n4, r0, r0)  # t16
    out_r_3 = divide(r0, r1, out_r_3)  # t17
    return out_r_1, out_r_2, out_r_3


def face_distances_of_five_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _face_distances_of_five_wheels, 4, (0, 1, 2, 3, 4, 5,), 3)

    def call(a, out=None):
        if out is None:
            if float is type(a):
                try:
                    return formula(a)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                if 3 < a.size <= SMALL:
                    return _face_distances_of_five_wheels(a)
                return alike(a)
        return others((a,), out)

    return call


def _face_distances_of_five_wheels(a, out_r_1=None, out_r_2=None, out_r_3=None, out_r_4=None, out_r_5=None, out_r_6=None, r0=None, r1=None, r2=None, r3=None, n5=array(5.0), n4=array(4.0), n7_3=array(7.0 / 3.0), n4_3=array(4.0 / 3.0), n7=array(7.0), n6=array(6.0), n3=array(3.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r2 = add(n5, r1, r2)  # t1
    r2 = multiply(r2, r1, r2)  # t2
    r2 = add(n4, r2, r2)  # t3
    r2 = sqrt(r2, r2)  # t4
    r2 = divide(r0, r2, r2)  # t5
    r3 = add(n7_3, r1, r3)  # t6
    r3 = multiply(r3, r1, r3)  # t7
    r3 = add(n4_3, r3, r3)  # t8
    r3 = sqrt(r3, r3)  # t9
    r3 = divide(r0, r3, r3)  # t10
    out_r_1 = multiply(n7, r2, out_r_1)  # t11
    out_r_2 = multiply(n5, r3, out_r_2)  # t12
    out_r_3 = multiply(n4, r3, out_r_3)  # t13
    out_r_4 = multiply(n6, r2, out_r_4)  # t14
    out_r_5 = multiply(n5, r2, out_r_5)  # t15
    r1 = multiply(n4_3, r1, r1)  # t16
    r1 = add(n4_3, r1, r1)  # t17
    r1 = sqrt(r1, r1)  # t18
    r0 = multiply(n3, r0, r0)  # t19
    out_r_6 = divide(r0, r1, out_r_6)  # t20
    return out_r_1, out_r_2, out_r_3, out_r_4, out_r_5, out_r_6


def volume_of_four_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _volume_of_four_wheels, 5, (0,), 6)

    def call(a, b, out=None):
        if out is None:
            if float is type(a) is type(b):
                try:
                    return formula(a, b)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                if 6 < a.size <= SMALL:
                    return _volume_of_four_wheels(a, b)
                return alike(a, b)
        return others((a, b,), out)

    return call


def _volume_of_four_wheels(a, b, out_volume=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0), n128=array(128.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = tan(b, r1)  # tan_b
    r2 = multiply(r0, r0, r2)  # tan_a_squared
    r2 = add(n1, r2, r2)  # t1
    r2 = sqrt(r2, r2)  # t2
    r3 = multiply(r1, r1, r3)  # tan_b_squared
    r3 = add(n1, r3, r3)  # t3
    r4 = divide(n1, r0, r4)  # t4
    r4 = add(r4, r0, r4)  # t5
    r1 = multiply(r0, r1, r1)  # t6
    r1 = multiply(n128, r1, r1)  # t7
    r3 = multiply(r2, r3, r3)  # t8
    r3 = multiply(r4, r3, r3)  # t9
    out_volume = divide(r1, r3, out_volume)  # t10
    return out_volume


def volume_of_three_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _volume_of_three_wheels, 5, (0,), 6)

    def call(a, b, out=None):
        if out is None:
            if float is type(a) is type(b):
                try:
                    return formula(a, b)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                if 6 < a.size <= SMALL:
                    return _volume_of_three_wheels(a, b)
                return alike(a, b)
        return others((a, b,), out)

    return call


def _volume_of_three_wheels(a, b, out_volume=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0), n32=array(32.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = tan(b, r1)  # tan_b
    r2 = multiply(r0, r0, r2)  # tan_a_squared
    r2 = add(n1, r2, r2)  # t1
    r2 = sqrt(r2, r2)  # t2
    r3 = multiply(r1, r1, r3)  # tan_b_squared
    r3 = add(n1, r3, r3)  # t3
    r4 = divide(n1, r0, r4)  # t4
    r4 = add(r4, r0, r4)  # t5
    r1 = multiply(r0, r1, r1)  # t6
    r1 = multiply(n32, r1, r1)  # t7
    r3 = multiply(r2, r3, r3)  # t8
    r3 = multiply(r4, r3, r3)  # t9
    out_volume = divide(r1, r3, out_volume)  # t10
    return out_volume


def volume_of_six_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _volume_of_six_wheels, 3, (0,), 4)

    def call(a, out=None):
        if out is None:
            if float is type(a):
                try:
                    return formula(a)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                if 4 < a.size <= SMALL:
                    return _volume_of_six_wheels(a)
                return alike(a)
        return others((a,), out)

    return call


def _volume_of_six_wheels(a, out_volume=None, r0=None, r1=None, r2=None, n1_3=array(1.0 / 3.0), n1=array(1.0), n144=array(144.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r1 = multiply(n1_3, r1, r1)  # t1
    r1 = add(n1_3, r1, r1)  # t2
    r1 = sqrt(r1, r1)  # t3
    r2 = divide(n1, r0, r2)  # t4
    r2 = add(r2, r0, r2)  # t5
    r0 = multiply(n144, r0, r0)  # t6
    r2 = multiply(r1, r2, r2)  # t7
    out_volume = divide(r0, r2, out_volume)  # t8
    return out_volume


def volume_of_five_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _volume_of_five_wheels, 3, (0,), 4)

    def call(a, out=None):
        if out is None:
            if float is type(a):
                try:
                    return formula(a)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                if 4 < a.size <= SMALL:
                    return _volume_of_five_wheels(a)
                return alike(a)
        return others((a,), out)

    return call


def _volume_of_five_wheels(a, out_volume=None, r0=None, r1=None, r2=None, n1_3=array(1.0 / 3.0), n1=array(1.0), n72=array(72.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r1 = multiply(n1_3, r1, r1)  # t1
    r1 = add(n1_3, r1, r1)  # t2
    r1 = sqrt(r1, r1)  # t3
    r2 = divide(n1, r0, r2)  # t4
    r2 = add(r2, r0, r2)  # t5
    r0 = multiply(n72, r0, r0)  # t6
    r2 = multiply(r1, r2, r2)  # t7
    out_volume = divide(r0, r2, out_volume)  # t8
    return out_volume


def largest_rates_of_four_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _largest_rates_of_four_wheels, 5, (0, 1, 2,), 1)

    def call(a, b, J_x, J_y, J_z, out=None):
        if out is None:
            if float is type(a) is type(b) is type(J_x) is type(J_y) is type(J_z):
                try:
                    return formula(a, b, J_x, J_y, J_z)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(b) is type(J_x) is type(J_y) is type(J_z) and DOUBLE is a.dtype is b.dtype is J_x.dtype is J_y.dtype is J_z.dtype and () != a.shape == b.shape == J_x.shape == J_y.shape == J_z.shape:
                if 1 < a.size <= FEW:
                    return _largest_rates_of_four_wheels_few(a, b, J_x, J_y, J_z)
                return alike(a, b, J_x, J_y, J_z)
        return others((a, b, J_x, J_y, J_z,), out)

    return call


def _largest_rates_of_four_wheels_few(a, b, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, n4=array(4.0)):
    r0 = sin(a, r0)  # sin_a
    r0 = multiply(n4, r0, r0)  # t1
    r1 = sin(b, r1)  # sin_b
    r1 = multiply(r1, r0, r1)  # t2
    out_w_x = divide(r1, J_x, out_w_x)  # t3
    r1 = cos(b, r1)  # cos_b
    r0 = multiply(r1, r0, r0)  # t4
    out_w_y = divide(r0, J_y, out_w_y)  # t5
    r0 = cos(a, r0)  # cos_a
    r0 = multiply(n4, r0, r0)  # t6
    out_w_z = divide(r0, J_z, out_w_z)  # t7
    return out_w_x, out_w_y, out_w_z


def _largest_rates_of_four_wheels(a, b, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0), n4=array(4.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r1 = add(n1, r1, r1)  # t1
    r1 = sqrt(r1, r1)  # t2
    r0 = multiply(n4, r0, r0)  # t3
    r0 = divide(r0, r1, r0)  # t4
    r2 = tan(b, r2)  # tan_b
    r3 = multiply(r2, r2, r3)  # tan_b_squared
    r3 = add(n1, r3, r3)  # t5
    r3 = sqrt(r3, r3)  # t6
    r2 = multiply(r0, r2, r2)  # t7
    r4 = multiply(J_x, r3, r4)  # t8
    out_w_x = divide(r2, r4, out_w_x)  # t9
    r3 = multiply(J_y, r3, r3)  # t10
    out_w_y = divide(r0, r3, out_w_y)  # t11
    r1 = multiply(J_z, r1, r1)  # t12
    out_w_z = divide(n4, r1, out_w_z)  # t13
    return out_w_x, out_w_y, out_w_z


def largest_rates_of_six_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _largest_rates_of_six_wheels, 4, (0, 1, 2,), 1)

    def call(a, J_x, J_y, J_z, out=None):
        if out is None:
            if float is type(a) is type(J_x) is type(J_y) is type(J_z):
                try:
                    return formula(a, J_x, J_y, J_z)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(J_x) is type(J_y) is type(J_z) and DOUBLE is a.dtype is J_x.dtype is J_y.dtype is J_z.dtype and () != a.shape == J_x.shape == J_y.shape == J_z.shape:
                if 1 < a.size <= FEW:
                    return _largest_rates_of_six_wheels_few(a, J_x, J_y, J_z)
                return alike(a, J_x, J_y, J_z)
        return others((a, J_x, J_y, J_z,), out)

    return call


def _largest_rates_of_six_wheels_few(a, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, sqrt_3=array(math.sqrt(3.0)), n2=array(2.0), n4=array(4.0), n6=array(6.0)):
    r0 = sin(a, r0)  # sin_a
    r1 = multiply(r0, sqrt_3, r1)  # t1
    r1 = multiply(n2, r1, r1)  # t2
    out_w_x = divide(r1, J_x, out_w_x)  # t3
    r0 = multiply(n4, r0, r0)  # t4
    out_w_y = divide(r0, J_y, out_w_y)  # t5
    r0 = cos(a, r0)  # cos_a
    r0 = multiply(n6, r0, r0)  # t6
    out_w_z = divide(r0, J_z, out_w_z)  # t7
    return out_w_x, out_w_y, out_w_z


def _largest_rates_of_six_wheels(a, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0), sqrt_3=array(math.sqrt(3.0)), n2=array(2.0), n4=array(4.0), n6=array(6.0)):
    r0 = tan(a, r0)  # tan_a
    r1 = multiply(r0, r0, r1)  # tan_a_squared
    r1 = add(n1, r1, r1)  # t1
    r1 = sqrt(r1, r1)  # t2
    r2 = multiply(sqrt_3, r0, r2)  # t4
    r2 = multiply(n2, r2, r2)  # t5
    r3 = multiply(J_x, r1, r3)  # t6
    out_w_x = divide(r2, r3, out_w_x)  # t7
    r0 = multiply(n4, r0, r0)  # t8
    r3 = multiply(J_y, r1, r3)  # t9
    out_w_y = divide(r0, r3, out_w_y)  # t10
    r1 = multiply(J_z, r1, r1)  # t11
    out_w_z = divide(n6, r1, out_w_z)  # t12
    return out_w_x, out_w_y, out_w_z


def equal_rates_of_four_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _equal_rates_of_four_wheels, 2, (0, 1, 2, 3,), 2)

    def call(J_x, J_y, J_z, out=None):
        if out is None:
            if float is type(J_x) is type(J_y) is type(J_z):
                try:
                    return formula(J_x, J_y, J_z)
                except UNDEFINED:
                    pass
            elif ndarray is type(J_x) is type(J_y) is type(J_z) and DOUBLE is J_x.dtype is J_y.dtype is J_z.dtype and () != J_x.shape == J_y.shape == J_z.shape:
                if 2 < J_x.size <= SMALL:
                    return _equal_rates_of_four_wheels(J_x, J_y, J_z)
                return alike(J_x, J_y, J_z)
        return others((J_x, J_y, J_z,), out)

    return call


def _equal_rates_of_four_wheels(J_x, J_y, J_z, out_a=None, out_b=None, out_w=None, out_w_any=None, r0=None, r1=None, n1=array(1.0), n4=array(4.0), sqrt_2=array(math.sqrt(2.0)), n2=array(2.0)):
    r0 = multiply(J_x, J_x, r0)  # J_x_squared
    r1 = multiply(J_y, J_y, r1)  # J_y_squared
    r1 = add(r0, r1, r1)  # t1
    r0 = multiply(J_z, J_z, r0)  # J_z_squared
    r0 = add(r0, r1, r0)  # t2
    r0 = sqrt(r0, r0)  # t3
    r0 = divide(n1, r0, r0)  # t4
    r1 = sqrt(r1, r1)  # t5
    r1 = divide(r1, J_z, r1)  # t6
    out_a = arctan(r1, out_a)  # t7
    r1 = divide(J_x, J_y, r1)  # t8
    out_b = arctan(r1, out_b)  # t9
    out_w = multiply(n4, r0, out_w)  # t10
    r0 = multiply(sqrt_2, r0, r0)  # t11
    out_w_any = multiply(n2, r0, out_w_any)  # t12
    return out_a, out_b, out_w, out_w_any


def equal_rates_of_six_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _equal_rates_of_six_wheels, 2, (0, 1, 2,), 3)

    def call(J_x, J_y, J_z, out=None):
        if out is None:
            if float is type(J_x) is type(J_y) is type(J_z):
                try:
                    return formula(J_x, J_y, J_z)
                except UNDEFINED:
                    pass
            elif ndarray is type(J_x) is type(J_y) is type(J_z) and DOUBLE is J_x.dtype is J_y.dtype is J_z.dtype and () != J_x.shape == J_y.shape == J_z.shape:
                if 3 < J_x.size <= SMALL:
                    return _equal_rates_of_six_wheels(J_x, J_y, J_z)
                return alike(J_x, J_y, J_z)
        return others((J_x, J_y, J_z,), out)

    return call


def _equal_rates_of_six_wheels(J_x, J_y, J_z, out_a=None, out_w_x=None, out_w_y=None, r0=None, r1=None, n9=array(9.0), n4=array(4.0), n1=array(1.0), n3_2=array(3.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n6=array(6.0), n12=array(12.0)):
    r0 = multiply(J_y, J_y, r0)  # J_y_squared
    r0 = multiply(n9, r0, r0)  # t1
    r1 = multiply(J_z, J_z, r1)  # J_z_squared
    r1 = multiply(n4, r1, r1)  # t2
    r1 = add(r0, r1, r1)  # t3
    r1 = sqrt(r1, r1)  # t4
    r1 = divide(n1, r1, r1)  # t5
    r0 = multiply(n3_2, J_y, r0)  # t6
    r0 = divide(r0, J_z, r0)  # t7
    out_a = arctan(r0, out_a)  # t8
    r0 = multiply(J_y, r1, r0)  # t9
    r0 = multiply(sqrt_3, r0, r0)  # t10
    r0 = multiply(n6, r0, r0)  # t11
    out_w_x = divide(r0, J_x, out_w_x)  # t12
    out_w_y = multiply(n12, r1, out_w_y)  # t13
    return out_a, out_w_x, out_w_y


def best_angles_of_four_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _best_angles_of_four_wheels, 4, (0, 1, 2,), 4)

    def call(J_x, J_y, J_z, out=None):
        if out is None:
            if float is type(J_x) is type(J_y) is type(J_z):
                try:
                    return formula(J_x, J_y, J_z)
                except UNDEFINED:
                    pass
            elif ndarray is type(J_x) is type(J_y) is type(J_z) and DOUBLE is J_x.dtype is J_y.dtype is J_z.dtype and () != J_x.shape == J_y.shape == J_z.shape:
                if 4 < J_x.size <= SMALL:
                    return _best_angles_of_four_wheels(J_x, J_y, J_z)
                return alike(J_x, J_y, J_z)
        return others((J_x, J_y, J_z,), out)

    return call


def _best_angles_of_four_wheels(J_x, J_y, J_z, out_a=None, out_b=None, out_w=None, r0=None, r1=None, r2=None, r3=None, n1_4=array(1.0 / 4.0), n4=array(4.0)):
    r0 = multiply(J_x, J_x, r0)  # J_x_squared
    r1 = multiply(J_z, J_z, r1)  # J_z_squared
    r1 = add(r0, r1, r1)  # t1
    r2 = sqrt(r1, r2)  # t2
    r3 = multiply(J_y, r2, r3)  # t3
    r3 = add(r0, r3, r3)  # t4
    r3 = sqrt(r3, r3)  # t5
    r3 = divide(r3, J_z, r3)  # t6
    out_a = arctan(r3, out_a)  # t7
    r1 = power(r1, n1_4, r1)  # t8
    r3 = sqrt(J_y, r3)  # sqrt_J_y
    r1 = multiply(r3, r1, r1)  # t9
    r1 = divide(J_x, r1, r1)  # t10
    out_b = arctan(r1, out_b)  # t11
    r2 = add(J_y, r2, r2)  # t12
    out_w = divide(n4, r2, out_w)  # t13
    return out_a, out_b, out_w


def best_angle_of_six_wheels(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _best_angle_of_six_wheels, 1, (0, 1,), 1)

    def call(J_y, J_z, out=None):
        if out is None:
            if float is type(J_y) is type(J_z):
                try:
                    return formula(J_y, J_z)
                except UNDEFINED:
                    pass
            elif ndarray is type(J_y) is type(J_z) and DOUBLE is J_y.dtype is J_z.dtype and () != J_y.shape == J_z.shape:
                if 1 < J_y.size <= SMALL:
                    return _best_angle_of_six_wheels(J_y, J_z)
                return alike(J_y, J_z)
        return others((J_y, J_z,), out)

    return call


def _best_angle_of_six_wheels(J_y, J_z, out_a=None, out_w=None, r0=None, sqrt_2=array(math.sqrt(2.0)), n2=array(2.0), n8=array(8.0)):
    r0 = divide(J_y, J_z, r0)  # t1
    r0 = sqrt(r0, r0)  # t2
    r0 = multiply(sqrt_2, r0, r0)  # t3
    out_a = arctan(r0, out_a)  # t4
    r0 = multiply(n2, J_y, r0)  # t5
    r0 = add(J_z, r0, r0)  # t6
    out_w = divide(n8, r0, out_w)  # t7
    return out_a, out_w
