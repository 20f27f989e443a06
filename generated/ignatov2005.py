"""Kernels of ignatov2005. Written by `symcheck generate`: what is changed here is lost."""

import math

import numpy as np

from symcheck.runtime import DOUBLE, FEW, SMALL, evaluate, evaluate_alike

__all__ = ["axes_of_four_wheels", "axes_of_six_wheels", "best_angle_of_six_wheels", "best_angles_of_four_wheels", "equal_rates_of_four_wheels", "equal_rates_of_six_wheels", "face_distances_of_five_wheels", "face_distances_of_four_wheels", "face_distances_of_six_wheels", "face_distances_of_three_wheels", "largest_rates_of_four_wheels", "largest_rates_of_six_wheels", "momentum_of_five_wheels", "momentum_of_four_wheels", "momentum_of_six_wheels", "momentum_of_three_wheels", "rates_of_five_wheels", "rates_of_four_wheels", "rates_of_six_wheels", "rates_of_three_wheels", "vertex_distances_of_five_wheels", "vertex_distances_of_four_wheels", "vertex_distances_of_six_wheels", "vertex_distances_of_three_wheels", "vertices_of_five_wheels", "vertices_of_four_wheels", "vertices_of_six_wheels", "vertices_of_three_wheels", "volume_of_five_wheels", "volume_of_four_wheels", "volume_of_six_wheels", "volume_of_three_wheels"]


def axes_of_four_wheels(a, b, out=None):
    """Unit vectors e_1, e_2, ... along the axes of four wheels, without components that are zero.

        e_1x = sin(a)*sin(b)
        e_1y = -sin(a)*cos(b)
        e_1z = -cos(a)
        e_2x = sin(a)*sin(b)
        e_2y = sin(a)*cos(b)
        e_2z = -cos(a)
        e_3x = sin(a)*sin(b)
        e_3y = -sin(a)*cos(b)
        e_3z = cos(a)
        e_4x = sin(a)*sin(b)
        e_4y = sin(a)*cos(b)
        e_4z = cos(a)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        b: angle of the side edges in the plane OXY, in rad; 0 < b < pi/2

    Returns a tuple:
        e_1x: x of e_1, a number
        e_1y: y of e_1, a number
        e_1z: z of e_1, a number
        e_2x: x of e_2, a number
        e_2y: y of e_2, a number
        e_2z: z of e_2, a number
        e_3x: x of e_3, a number
        e_3y: y of e_3, a number
        e_3z: z of e_3, a number
        e_4x: x of e_4, a number
        e_4y: y of e_4, a number
        e_4z: z of e_4, a number

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 12 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number. Outputs that are equal by formula are one array, unless `out` is given.

    Accuracy: 6 ulp over the domain. Tangents of two angles, a root and a quotient are rounded one after the
    other.

    Rests on ignatov2005:2.0.1 (sha256 f834c7a2f8e1), ignatov2005:2.0.3 (sha256 d3205c84ab44), ignatov2005:2.0.5
    (sha256 f49cc6f4df91).
    """
    if out is None:
        if type(a) is type(b) is float:
            try:
                return _axes_of_four_wheels(a, b, math.cos, math.sin)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is type(b) is np.ndarray and a.dtype is b.dtype is DOUBLE and a.shape == b.shape:
            if a.size <= FEW:
                return _axes_of_four_wheels(a, b)
            return evaluate_alike(_axes_of_four_wheels_block, 5, (0, 1, 2, 0, 3, 2, 0, 1, 4, 0, 3, 4,), (a, b,))
    return evaluate(_axes_of_four_wheels_block, 5, (0, 1, 2, 0, 3, 2, 0, 1, 4, 0, 3, 4,), (a, b,), out)


def _axes_of_four_wheels(a, b, cos=np.cos, sin=np.sin):
    sin_a = sin(a)
    t1 = sin_a * sin(b)
    t2 = cos(b) * sin_a
    t3 = -t2
    cos_a = cos(a)
    t4 = -cos_a
    return t1, t3, t4, t1, t2, t4, t1, t3, cos_a, t1, t2, cos_a


def _axes_of_four_wheels_block(a, b, out_e_1x, out_e_1y, out_e_1z, out_e_2y, out_e_3z, r0, r1, r2, r3, r4):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.add(1.0, r1, r1)  # t1
    np.sqrt(r1, r2)  # t2
    np.tan(b, r3)  # tan_b
    np.multiply(r3, r3, r4)  # tan_b_squared
    np.add(1.0, r4, r4)  # t4
    np.multiply(r1, r4, r4)  # t5
    np.sqrt(r4, r4)  # t6
    np.multiply(r0, r3, r3)  # t7
    np.divide(r3, r4, out_e_1x)  # t8
    np.divide(r0, r4, out_e_2y)  # t9
    np.negative(out_e_2y, out_e_1y)  # t10
    np.divide(1.0, r2, out_e_3z)  # t11
    np.negative(out_e_3z, out_e_1z)  # t12


def axes_of_six_wheels(a, out=None):
    """Unit vectors e_1, e_2, ... along the axes of six wheels, without components that are zero.

        e_1y = -sin(a)
        e_1z = cos(a)
        e_2x = sqrt(3)*sin(a)/2
        e_2y = -sin(a)/2
        e_2z = cos(a)
        e_3x = sqrt(3)*sin(a)/2
        e_3y = sin(a)/2
        e_3z = cos(a)
        e_4y = -sin(a)
        e_4z = -cos(a)
        e_5x = sqrt(3)*sin(a)/2
        e_5y = -sin(a)/2
        e_5z = -cos(a)
        e_6x = sqrt(3)*sin(a)/2
        e_6y = sin(a)/2
        e_6z = -cos(a)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2

    Returns a tuple:
        e_1y: y of e_1, a number
        e_1z: z of e_1, a number
        e_2x: x of e_2, a number
        e_2y: y of e_2, a number
        e_2z: z of e_2, a number
        e_3x: x of e_3, a number
        e_3y: y of e_3, a number
        e_3z: z of e_3, a number
        e_4y: y of e_4, a number
        e_4z: z of e_4, a number
        e_5x: x of e_5, a number
        e_5y: y of e_5, a number
        e_5z: z of e_5, a number
        e_6x: x of e_6, a number
        e_6y: y of e_6, a number
        e_6z: z of e_6, a number

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 16 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number. Outputs that are equal by formula are one array, unless `out` is given.

    Accuracy: 4 ulp over the domain.

    Rests on ignatov2005:3.0.3 (sha256 7a67431dc6c5), ignatov2005:3.0.5 (sha256 d1789efdd175), ignatov2005:3.0.6
    (sha256 859001ee8022).
    """
    if out is None:
        if type(a) is float:
            try:
                return _axes_of_six_wheels(a, math.cos, math.sin, 1.0 / 2.0, math.sqrt(3.0))
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is np.ndarray and a.dtype is DOUBLE:
            if a.size <= FEW:
                return _axes_of_six_wheels(a)
            return evaluate_alike(_axes_of_six_wheels_block, 3, (0, 1, 2, 3, 1, 2, 4, 1, 0, 5, 2, 3, 5, 2, 4, 5,), (a,))
    return evaluate(_axes_of_six_wheels_block, 3, (0, 1, 2, 3, 1, 2, 4, 1, 0, 5, 2, 3, 5, 2, 4, 5,), (a,), out)


def _axes_of_six_wheels(a, cos=np.cos, sin=np.sin, n1_2=np.array(1.0 / 2.0), sqrt_3=np.array(math.sqrt(3.0))):
    sin_a = sin(a)
    t1 = -sin_a
    cos_a = cos(a)
    t2 = n1_2 * sin_a
    t3 = sqrt_3 * t2
    t4 = -t2
    t5 = -cos_a
    return t1, cos_a, t3, t4, cos_a, t3, t2, cos_a, t1, t5, t3, t4, t5, t3, t2, t5


def _axes_of_six_wheels_block(a, out_e_1y, out_e_1z, out_e_2x, out_e_2y, out_e_3y, out_e_4z, r0, r1, r2):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.add(1.0, r1, r1)  # t1
    np.sqrt(r1, r1)  # t2
    np.divide(r0, r1, r2)  # t3
    np.negative(r2, out_e_1y)  # t4
    np.divide(1.0, r1, out_e_1z)  # t5
    np.multiply(1.0 / 2.0, r0, r0)  # t6
    np.divide(r0, r1, out_e_3y)  # t7
    np.multiply(math.sqrt(3.0), out_e_3y, out_e_2x)  # t8
    np.negative(out_e_3y, out_e_2y)  # t9
    np.negative(out_e_1z, out_e_4z)  # t10


def momentum_of_four_wheels(h_1, h_2, h_3, h_4, a, b, out=None):
    """Total momentum of four wheels.

        H_x = (h_1 + h_2 + h_3 + h_4)*sin(a)*sin(b)
        H_y = (-h_1 + h_2 - h_3 + h_4)*sin(a)*cos(b)
        H_z = (-h_1 - h_2 + h_3 + h_4)*cos(a)

    Arguments:
        h_1: momentum of wheel 1, in units of h_max; -1 <= h_1 <= 1
        h_2: momentum of wheel 2, in units of h_max; -1 <= h_2 <= 1
        h_3: momentum of wheel 3, in units of h_max; -1 <= h_3 <= 1
        h_4: momentum of wheel 4, in units of h_max; -1 <= h_4 <= 1
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        b: angle of the side edges in the plane OXY, in rad; 0 < b < pi/2

    Returns a tuple:
        H_x: momentum along OX, in units of h_max
        H_y: momentum along OY, in units of h_max
        H_z: momentum along OZ, in units of h_max

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. Momenta of wheels may cancel: counted in units of the last place of the
    largest h_i e_i.

    Rests on ignatov2005:2.1.2 (sha256 657ebd719ec9).
    """
    if out is None:
        if type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(a) is type(b) is float:
            try:
                return _momentum_of_four_wheels(h_1, h_2, h_3, h_4, a, b, math.cos, math.sin)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(a) is type(b) is np.ndarray and h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is a.dtype is b.dtype is DOUBLE and h_1.shape == h_2.shape == h_3.shape == h_4.shape == a.shape == b.shape:
            if h_1.size <= FEW:
                return _momentum_of_four_wheels(h_1, h_2, h_3, h_4, a, b)
            return evaluate_alike(_momentum_of_four_wheels_block, 8, (0, 1, 2,), (h_1, h_2, h_3, h_4, a, b,))
    return evaluate(_momentum_of_four_wheels_block, 8, (0, 1, 2,), (h_1, h_2, h_3, h_4, a, b,), out)


def _momentum_of_four_wheels(h_1, h_2, h_3, h_4, a, b, cos=np.cos, sin=np.sin):
    sin_a = sin(a)
    t1 = h_1 + h_3
    t2 = -h_4
    return sin(b) * (sin_a * (t1 + (h_2 + h_4))), cos(b) * (sin_a * ((h_2 - t1) - t2)), cos(a) * (((h_3 - h_1) - h_2) - t2)


def _momentum_of_four_wheels_block(h_1, h_2, h_3, h_4, a, b, out_H_x, out_H_y, out_H_z, r0, r1, r2, r3, r4, r5, r6, r7):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.add(1.0, r1, r1)  # t1
    np.sqrt(r1, r2)  # t2
    np.add(h_1, h_3, r3)  # t4
    np.negative(h_4, r4)  # t5
    np.add(h_2, h_4, r5)  # t6
    np.add(r3, r5, r5)  # t7
    np.tan(b, r6)  # tan_b
    np.multiply(r6, r6, r7)  # tan_b_squared
    np.add(1.0, r7, r7)  # t8
    np.multiply(r1, r7, r7)  # t9
    np.sqrt(r7, r7)  # t10
    np.multiply(r5, r0, r5)  # t11
    np.multiply(r5, r6, r6)  # t12
    np.divide(r6, r7, out_H_x)  # t13
    np.subtract(h_2, r3, r3)  # t14
    np.subtract(r3, r4, r3)  # t15
    np.multiply(r3, r0, r0)  # t16
    np.divide(r0, r7, out_H_y)  # t17
    np.subtract(h_3, h_1, r7)  # t18
    np.subtract(r7, h_2, r7)  # t19
    np.subtract(r7, r4, r4)  # t20
    np.divide(r4, r2, out_H_z)  # t21


def momentum_of_three_wheels(h_1, h_2, h_3, a, b, out=None):
    """Total momentum of four wheels of which the last has failed.

        H_x = (h_1 + h_2 + h_3)*sin(a)*sin(b)
        H_y = (-h_1 + h_2 - h_3)*sin(a)*cos(b)
        H_z = (-h_1 - h_2 + h_3)*cos(a)

    Arguments:
        h_1: momentum of wheel 1, in units of h_max; -1 <= h_1 <= 1
        h_2: momentum of wheel 2, in units of h_max; -1 <= h_2 <= 1
        h_3: momentum of wheel 3, in units of h_max; -1 <= h_3 <= 1
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        b: angle of the side edges in the plane OXY, in rad; 0 < b < pi/2

    Returns a tuple:
        H_x: momentum along OX, in units of h_max
        H_y: momentum along OY, in units of h_max
        H_z: momentum along OZ, in units of h_max

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. Momenta of wheels may cancel: counted in units of the last place of the
    largest h_i e_i.

    Rests on ignatov2005:2.2.1 (sha256 236d541ef553).
    """
    if out is None:
        if type(h_1) is type(h_2) is type(h_3) is type(a) is type(b) is float:
            try:
                return _momentum_of_three_wheels(h_1, h_2, h_3, a, b, math.cos, math.sin)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(h_1) is type(h_2) is type(h_3) is type(a) is type(b) is np.ndarray and h_1.dtype is h_2.dtype is h_3.dtype is a.dtype is b.dtype is DOUBLE and h_1.shape == h_2.shape == h_3.shape == a.shape == b.shape:
            if h_1.size <= FEW:
                return _momentum_of_three_wheels(h_1, h_2, h_3, a, b)
            return evaluate_alike(_momentum_of_three_wheels_block, 7, (0, 1, 2,), (h_1, h_2, h_3, a, b,))
    return evaluate(_momentum_of_three_wheels_block, 7, (0, 1, 2,), (h_1, h_2, h_3, a, b,), out)


def _momentum_of_three_wheels(h_1, h_2, h_3, a, b, cos=np.cos, sin=np.sin):
    sin_a = sin(a)
    t1 = h_1 + h_3
    return sin(b) * (sin_a * (h_2 + t1)), cos(b) * (sin_a * (h_2 - t1)), cos(a) * ((h_3 - h_1) - h_2)


def _momentum_of_three_wheels_block(h_1, h_2, h_3, a, b, out_H_x, out_H_y, out_H_z, r0, r1, r2, r3, r4, r5, r6):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.add(1.0, r1, r1)  # t1
    np.sqrt(r1, r2)  # t2
    np.add(h_1, h_3, r3)  # t4
    np.add(h_2, r3, r4)  # t5
    np.tan(b, r5)  # tan_b
    np.multiply(r5, r5, r6)  # tan_b_squared
    np.add(1.0, r6, r6)  # t6
    np.multiply(r1, r6, r6)  # t7
    np.sqrt(r6, r6)  # t8
    np.multiply(r4, r0, r4)  # t9
    np.multiply(r4, r5, r5)  # t10
    np.divide(r5, r6, out_H_x)  # t11
    np.subtract(h_2, r3, r3)  # t12
    np.multiply(r3, r0, r0)  # t13
    np.divide(r0, r6, out_H_y)  # t14
    np.subtract(h_3, h_1, r6)  # t15
    np.subtract(r6, h_2, r6)  # t16
    np.divide(r6, r2, out_H_z)  # t17


def momentum_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a, out=None):
    """Total momentum of six wheels.

        H_x = sqrt(3)*(h_2 + h_3 + h_5 + h_6)*sin(a)/2
        H_y = (-2*h_1 - h_2 + h_3 - 2*h_4 - h_5 + h_6)*sin(a)/2
        H_z = (h_1 + h_2 + h_3 - h_4 - h_5 - h_6)*cos(a)

    Arguments:
        h_1: momentum of wheel 1, in units of h_max; -1 <= h_1 <= 1
        h_2: momentum of wheel 2, in units of h_max; -1 <= h_2 <= 1
        h_3: momentum of wheel 3, in units of h_max; -1 <= h_3 <= 1
        h_4: momentum of wheel 4, in units of h_max; -1 <= h_4 <= 1
        h_5: momentum of wheel 5, in units of h_max; -1 <= h_5 <= 1
        h_6: momentum of wheel 6, in units of h_max; -1 <= h_6 <= 1
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2

    Returns a tuple:
        H_x: momentum along OX, in units of h_max
        H_y: momentum along OY, in units of h_max
        H_z: momentum along OZ, in units of h_max

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. Momenta of wheels may cancel: counted in units of the last place of the
    largest h_i e_i.

    Rests on ignatov2005:3.1.2 (sha256 c4e14026f27d).
    """
    if out is None:
        if type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(h_6) is type(a) is float:
            try:
                return _momentum_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a, math.cos, math.sin, 1.0 / 2.0, math.sqrt(3.0), 2.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(h_6) is type(a) is np.ndarray and h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is h_5.dtype is h_6.dtype is a.dtype is DOUBLE and h_1.shape == h_2.shape == h_3.shape == h_4.shape == h_5.shape == h_6.shape == a.shape:
            if h_1.size <= FEW:
                return _momentum_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a)
            return evaluate_alike(_momentum_of_six_wheels_block, 6, (0, 1, 2,), (h_1, h_2, h_3, h_4, h_5, h_6, a,))
    return evaluate(_momentum_of_six_wheels_block, 6, (0, 1, 2,), (h_1, h_2, h_3, h_4, h_5, h_6, a,), out)


def _momentum_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a, cos=np.cos, sin=np.sin, n1_2=np.array(1.0 / 2.0), sqrt_3=np.array(math.sqrt(3.0)), n2=np.array(2.0)):
    t1 = h_2 + h_5
    t2 = n1_2 * sin(a)
    t3 = -h_6
    return (t1 + (h_3 + h_6)) * (sqrt_3 * t2), ((((h_3 - (n2 * h_1)) - (n2 * h_4)) - t1) - t3) * t2, cos(a) * ((((h_3 + (h_1 + h_2)) + t3) - h_4) - h_5)


def _momentum_of_six_wheels_block(h_1, h_2, h_3, h_4, h_5, h_6, a, out_H_x, out_H_y, out_H_z, r0, r1, r2, r3, r4, r5):
    np.add(h_2, h_5, r0)  # t1
    np.tan(a, r1)  # tan_a
    np.multiply(r1, r1, r2)  # tan_a_squared
    np.add(1.0, r2, r2)  # t2
    np.sqrt(r2, r2)  # t3
    np.multiply(1.0 / 2.0, r1, r1)  # t4
    np.divide(r1, r2, r1)  # t5
    np.negative(h_6, r3)  # t6
    np.add(h_3, h_6, r4)  # t7
    np.add(r0, r4, r4)  # t8
    np.multiply(math.sqrt(3.0), r1, r5)  # t9
    np.multiply(r4, r5, out_H_x)  # t10
    np.multiply(2.0, h_1, r5)  # t11
    np.multiply(2.0, h_4, r4)  # t12
    np.subtract(h_3, r5, r5)  # t13
    np.subtract(r5, r4, r4)  # t14
    np.subtract(r4, r0, r0)  # t15
    np.subtract(r0, r3, r0)  # t16
    np.multiply(r0, r1, out_H_y)  # t17
    np.add(h_1, h_2, r1)  # t18
    np.add(h_3, r1, r1)  # t19
    np.add(r1, r3, r3)  # t20
    np.subtract(r3, h_4, r3)  # t21
    np.subtract(r3, h_5, r3)  # t22
    np.divide(r3, r2, out_H_z)  # t23


def momentum_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a, out=None):
    """Total momentum of six wheels of which the last has failed.

        H_x = sqrt(3)*(h_2 + h_3 + h_5)*sin(a)/2
        H_y = (-2*h_1 - h_2 + h_3 - 2*h_4 - h_5)*sin(a)/2
        H_z = (h_1 + h_2 + h_3 - h_4 - h_5)*cos(a)

    Arguments:
        h_1: momentum of wheel 1, in units of h_max; -1 <= h_1 <= 1
        h_2: momentum of wheel 2, in units of h_max; -1 <= h_2 <= 1
        h_3: momentum of wheel 3, in units of h_max; -1 <= h_3 <= 1
        h_4: momentum of wheel 4, in units of h_max; -1 <= h_4 <= 1
        h_5: momentum of wheel 5, in units of h_max; -1 <= h_5 <= 1
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2

    Returns a tuple:
        H_x: momentum along OX, in units of h_max
        H_y: momentum along OY, in units of h_max
        H_z: momentum along OZ, in units of h_max

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. Momenta of wheels may cancel: counted in units of the last place of the
    largest h_i e_i.

    Rests on ignatov2005:3.2.1 (sha256 627cc0ca9e03).
    """
    if out is None:
        if type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(a) is float:
            try:
                return _momentum_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a, math.cos, math.sin, 1.0 / 2.0, math.sqrt(3.0), 2.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(a) is np.ndarray and h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is h_5.dtype is a.dtype is DOUBLE and h_1.shape == h_2.shape == h_3.shape == h_4.shape == h_5.shape == a.shape:
            if h_1.size <= FEW:
                return _momentum_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a)
            return evaluate_alike(_momentum_of_five_wheels_block, 5, (0, 1, 2,), (h_1, h_2, h_3, h_4, h_5, a,))
    return evaluate(_momentum_of_five_wheels_block, 5, (0, 1, 2,), (h_1, h_2, h_3, h_4, h_5, a,), out)


def _momentum_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a, cos=np.cos, sin=np.sin, n1_2=np.array(1.0 / 2.0), sqrt_3=np.array(math.sqrt(3.0)), n2=np.array(2.0)):
    t1 = h_2 + h_5
    t2 = n1_2 * sin(a)
    return (h_3 + t1) * (sqrt_3 * t2), (((h_3 - (n2 * h_1)) - (n2 * h_4)) - t1) * t2, cos(a) * (((h_3 + (h_1 + h_2)) - h_4) - h_5)


def _momentum_of_five_wheels_block(h_1, h_2, h_3, h_4, h_5, a, out_H_x, out_H_y, out_H_z, r0, r1, r2, r3, r4):
    np.add(h_2, h_5, r0)  # t1
    np.tan(a, r1)  # tan_a
    np.multiply(r1, r1, r2)  # tan_a_squared
    np.add(1.0, r2, r2)  # t2
    np.sqrt(r2, r2)  # t3
    np.multiply(1.0 / 2.0, r1, r1)  # t4
    np.divide(r1, r2, r1)  # t5
    np.add(h_3, r0, r3)  # t6
    np.multiply(math.sqrt(3.0), r1, r4)  # t7
    np.multiply(r3, r4, out_H_x)  # t8
    np.multiply(2.0, h_1, r4)  # t9
    np.multiply(2.0, h_4, r3)  # t10
    np.subtract(h_3, r4, r4)  # t11
    np.subtract(r4, r3, r3)  # t12
    np.subtract(r3, r0, r0)  # t13
    np.multiply(r0, r1, out_H_y)  # t14
    np.add(h_1, h_2, r1)  # t15
    np.add(h_3, r1, r1)  # t16
    np.subtract(r1, h_4, r1)  # t17
    np.subtract(r1, h_5, r1)  # t18
    np.divide(r1, r2, out_H_z)  # t19


def rates_of_four_wheels(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z, out=None):
    """Angular rates of a body, at rest with its wheels at rest, that four wheels give it.

        w_x = -(h_1 + h_2 + h_3 + h_4)*sin(a)*sin(b)/J_x
        w_y = -(-h_1 + h_2 - h_3 + h_4)*sin(a)*cos(b)/J_y
        w_z = -(-h_1 - h_2 + h_3 + h_4)*cos(a)/J_z

    Arguments:
        h_1: momentum of wheel 1, in units of h_max; -1 <= h_1 <= 1
        h_2: momentum of wheel 2, in units of h_max; -1 <= h_2 <= 1
        h_3: momentum of wheel 3, in units of h_max; -1 <= h_3 <= 1
        h_4: momentum of wheel 4, in units of h_max; -1 <= h_4 <= 1
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        b: angle of the side edges in the plane OXY, in rad; 0 < b < pi/2
        J_x: moment of inertia about OX, in kg m^2; 0 < J_x
        J_y: moment of inertia about OY, in kg m^2; 0 < J_y
        J_z: moment of inertia about OZ, in kg m^2; 0 < J_z

    Returns a tuple:
        w_x: angular rate about OX, in units of h_max/(kg m^2)
        w_y: angular rate about OY, in units of h_max/(kg m^2)
        w_z: angular rate about OZ, in units of h_max/(kg m^2)

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. Momenta of wheels may cancel: counted in units of the last place of the
    largest h_i e_i.

    Rests on ignatov2005:2.1.2 (sha256 657ebd719ec9), ignatov2005:2.3 (sha256 233596362da2).
    """
    if out is None:
        if type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(a) is type(b) is type(J_x) is type(J_y) is type(J_z) is float:
            try:
                return _rates_of_four_wheels(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z, math.cos, math.sin)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(a) is type(b) is type(J_x) is type(J_y) is type(J_z) is np.ndarray and h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is a.dtype is b.dtype is J_x.dtype is J_y.dtype is J_z.dtype is DOUBLE and h_1.shape == h_2.shape == h_3.shape == h_4.shape == a.shape == b.shape == J_x.shape == J_y.shape == J_z.shape:
            if h_1.size <= FEW:
                return _rates_of_four_wheels(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z)
            return evaluate_alike(_rates_of_four_wheels_block, 8, (0, 1, 2,), (h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z,))
    return evaluate(_rates_of_four_wheels_block, 8, (0, 1, 2,), (h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z,), out)


def _rates_of_four_wheels(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z, cos=np.cos, sin=np.sin):
    sin_a = sin(a)
    t1 = h_1 + h_3
    t2 = -h_4
    return -((sin(b) * (sin_a * (t1 + (h_2 + h_4)))) / J_x), -((cos(b) * (sin_a * ((h_2 - t1) - t2))) / J_y), -((cos(a) * (((h_3 - h_1) - h_2) - t2)) / J_z)


def _rates_of_four_wheels_block(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z, out_w_x, out_w_y, out_w_z, r0, r1, r2, r3, r4, r5, r6, r7):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.add(1.0, r1, r1)  # t1
    np.sqrt(r1, r2)  # t2
    np.add(h_1, h_3, r3)  # t4
    np.negative(h_4, r4)  # t5
    np.add(h_2, h_4, r5)  # t6
    np.add(r3, r5, r5)  # t7
    np.tan(b, r6)  # tan_b
    np.multiply(r6, r6, r7)  # tan_b_squared
    np.add(1.0, r7, r7)  # t8
    np.multiply(r1, r7, r7)  # t9
    np.sqrt(r7, r7)  # t10
    np.multiply(r5, r0, r5)  # t11
    np.multiply(r5, r6, r6)  # t12
    np.multiply(J_x, r7, r5)  # t13
    np.divide(r6, r5, r5)  # t14
    np.negative(r5, out_w_x)  # t15
    np.subtract(h_2, r3, r3)  # t16
    np.subtract(r3, r4, r3)  # t17
    np.multiply(r3, r0, r0)  # t18
    np.multiply(J_y, r7, r7)  # t19
    np.divide(r0, r7, r7)  # t20
    np.negative(r7, out_w_y)  # t21
    np.subtract(h_3, h_1, r7)  # t22
    np.subtract(r7, h_2, r7)  # t23
    np.subtract(r7, r4, r4)  # t24
    np.multiply(J_z, r2, r2)  # t25
    np.divide(r4, r2, r2)  # t26
    np.negative(r2, out_w_z)  # t27


def rates_of_three_wheels(h_1, h_2, h_3, a, b, J_x, J_y, J_z, out=None):
    """Angular rates of a body, at rest with its wheels at rest, that four wheels of which the last has failed give it.

        w_x = -(h_1 + h_2 + h_3)*sin(a)*sin(b)/J_x
        w_y = -(-h_1 + h_2 - h_3)*sin(a)*cos(b)/J_y
        w_z = -(-h_1 - h_2 + h_3)*cos(a)/J_z

    Arguments:
        h_1: momentum of wheel 1, in units of h_max; -1 <= h_1 <= 1
        h_2: momentum of wheel 2, in units of h_max; -1 <= h_2 <= 1
        h_3: momentum of wheel 3, in units of h_max; -1 <= h_3 <= 1
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        b: angle of the side edges in the plane OXY, in rad; 0 < b < pi/2
        J_x: moment of inertia about OX, in kg m^2; 0 < J_x
        J_y: moment of inertia about OY, in kg m^2; 0 < J_y
        J_z: moment of inertia about OZ, in kg m^2; 0 < J_z

    Returns a tuple:
        w_x: angular rate about OX, in units of h_max/(kg m^2)
        w_y: angular rate about OY, in units of h_max/(kg m^2)
        w_z: angular rate about OZ, in units of h_max/(kg m^2)

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. Momenta of wheels may cancel: counted in units of the last place of the
    largest h_i e_i.

    Rests on ignatov2005:2.2.1 (sha256 236d541ef553), ignatov2005:2.3 (sha256 233596362da2).
    """
    if out is None:
        if type(h_1) is type(h_2) is type(h_3) is type(a) is type(b) is type(J_x) is type(J_y) is type(J_z) is float:
            try:
                return _rates_of_three_wheels(h_1, h_2, h_3, a, b, J_x, J_y, J_z, math.cos, math.sin)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(h_1) is type(h_2) is type(h_3) is type(a) is type(b) is type(J_x) is type(J_y) is type(J_z) is np.ndarray and h_1.dtype is h_2.dtype is h_3.dtype is a.dtype is b.dtype is J_x.dtype is J_y.dtype is J_z.dtype is DOUBLE and h_1.shape == h_2.shape == h_3.shape == a.shape == b.shape == J_x.shape == J_y.shape == J_z.shape:
            if h_1.size <= FEW:
                return _rates_of_three_wheels(h_1, h_2, h_3, a, b, J_x, J_y, J_z)
            return evaluate_alike(_rates_of_three_wheels_block, 7, (0, 1, 2,), (h_1, h_2, h_3, a, b, J_x, J_y, J_z,))
    return evaluate(_rates_of_three_wheels_block, 7, (0, 1, 2,), (h_1, h_2, h_3, a, b, J_x, J_y, J_z,), out)


def _rates_of_three_wheels(h_1, h_2, h_3, a, b, J_x, J_y, J_z, cos=np.cos, sin=np.sin):
    sin_a = sin(a)
    t1 = h_1 + h_3
    return -((sin(b) * (sin_a * (h_2 + t1))) / J_x), -((cos(b) * (sin_a * (h_2 - t1))) / J_y), -((cos(a) * ((h_3 - h_1) - h_2)) / J_z)


def _rates_of_three_wheels_block(h_1, h_2, h_3, a, b, J_x, J_y, J_z, out_w_x, out_w_y, out_w_z, r0, r1, r2, r3, r4, r5, r6):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.add(1.0, r1, r1)  # t1
    np.sqrt(r1, r2)  # t2
    np.add(h_1, h_3, r3)  # t4
    np.add(h_2, r3, r4)  # t5
    np.tan(b, r5)  # tan_b
    np.multiply(r5, r5, r6)  # tan_b_squared
    np.add(1.0, r6, r6)  # t6
    np.multiply(r1, r6, r6)  # t7
    np.sqrt(r6, r6)  # t8
    np.multiply(r4, r0, r4)  # t9
    np.multiply(r4, r5, r5)  # t10
    np.multiply(J_x, r6, r4)  # t11
    np.divide(r5, r4, r4)  # t12
    np.negative(r4, out_w_x)  # t13
    np.subtract(h_2, r3, r3)  # t14
    np.multiply(r3, r0, r0)  # t15
    np.multiply(J_y, r6, r6)  # t16
    np.divide(r0, r6, r6)  # t17
    np.negative(r6, out_w_y)  # t18
    np.subtract(h_3, h_1, r6)  # t19
    np.subtract(r6, h_2, r6)  # t20
    np.multiply(J_z, r2, r2)  # t21
    np.divide(r6, r2, r2)  # t22
    np.negative(r2, out_w_z)  # t23


def rates_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z, out=None):
    """Angular rates of a body, at rest with its wheels at rest, that six wheels give it.

        w_x = -sqrt(3)*(h_2 + h_3 + h_5 + h_6)*sin(a)/(2*J_x)
        w_y = -(-2*h_1 - h_2 + h_3 - 2*h_4 - h_5 + h_6)*sin(a)/(2*J_y)
        w_z = -(h_1 + h_2 + h_3 - h_4 - h_5 - h_6)*cos(a)/J_z

    Arguments:
        h_1: momentum of wheel 1, in units of h_max; -1 <= h_1 <= 1
        h_2: momentum of wheel 2, in units of h_max; -1 <= h_2 <= 1
        h_3: momentum of wheel 3, in units of h_max; -1 <= h_3 <= 1
        h_4: momentum of wheel 4, in units of h_max; -1 <= h_4 <= 1
        h_5: momentum of wheel 5, in units of h_max; -1 <= h_5 <= 1
        h_6: momentum of wheel 6, in units of h_max; -1 <= h_6 <= 1
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        J_x: moment of inertia about OX, in kg m^2; 0 < J_x
        J_y: moment of inertia about OY, in kg m^2; 0 < J_y
        J_z: moment of inertia about OZ, in kg m^2; 0 < J_z

    Returns a tuple:
        w_x: angular rate about OX, in units of h_max/(kg m^2)
        w_y: angular rate about OY, in units of h_max/(kg m^2)
        w_z: angular rate about OZ, in units of h_max/(kg m^2)

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. Momenta of wheels may cancel: counted in units of the last place of the
    largest h_i e_i.

    Rests on ignatov2005:3.1.2 (sha256 c4e14026f27d), ignatov2005:2.3 (sha256 233596362da2).
    """
    if out is None:
        if type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(h_6) is type(a) is type(J_x) is type(J_y) is type(J_z) is float:
            try:
                return _rates_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z, math.cos, math.sin, 1.0 / 2.0, math.sqrt(3.0), 2.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(h_6) is type(a) is type(J_x) is type(J_y) is type(J_z) is np.ndarray and h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is h_5.dtype is h_6.dtype is a.dtype is J_x.dtype is J_y.dtype is J_z.dtype is DOUBLE and h_1.shape == h_2.shape == h_3.shape == h_4.shape == h_5.shape == h_6.shape == a.shape == J_x.shape == J_y.shape == J_z.shape:
            if h_1.size <= FEW:
                return _rates_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z)
            return evaluate_alike(_rates_of_six_wheels_block, 6, (0, 1, 2,), (h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z,))
    return evaluate(_rates_of_six_wheels_block, 6, (0, 1, 2,), (h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z,), out)


def _rates_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z, cos=np.cos, sin=np.sin, n1_2=np.array(1.0 / 2.0), sqrt_3=np.array(math.sqrt(3.0)), n2=np.array(2.0)):
    t1 = h_2 + h_5
    t2 = n1_2 * sin(a)
    t3 = -h_6
    return -(((t1 + (h_3 + h_6)) * (sqrt_3 * t2)) / J_x), -((((((h_3 - (n2 * h_1)) - (n2 * h_4)) - t1) - t3) * t2) / J_y), -((cos(a) * ((((h_3 + (h_1 + h_2)) + t3) - h_4) - h_5)) / J_z)


def _rates_of_six_wheels_block(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z, out_w_x, out_w_y, out_w_z, r0, r1, r2, r3, r4, r5):
    np.add(h_2, h_5, r0)  # t1
    np.tan(a, r1)  # tan_a
    np.multiply(r1, r1, r2)  # tan_a_squared
    np.add(1.0, r2, r2)  # t2
    np.sqrt(r2, r2)  # t3
    np.multiply(1.0 / 2.0, r1, r1)  # t4
    np.divide(r1, r2, r1)  # t5
    np.negative(h_6, r3)  # t6
    np.add(h_3, h_6, r4)  # t7
    np.add(r0, r4, r4)  # t8
    np.multiply(math.sqrt(3.0), r1, r5)  # t9
    np.multiply(r4, r5, r5)  # t10
    np.divide(r5, J_x, r5)  # t11
    np.negative(r5, out_w_x)  # t12
    np.multiply(2.0, h_1, r5)  # t13
    np.multiply(2.0, h_4, r4)  # t14
    np.subtract(h_3, r5, r5)  # t15
    np.subtract(r5, r4, r4)  # t16
    np.subtract(r4, r0, r0)  # t17
    np.subtract(r0, r3, r0)  # t18
    np.multiply(r0, r1, r1)  # t19
    np.divide(r1, J_y, r1)  # t20
    np.negative(r1, out_w_y)  # t21
    np.add(h_1, h_2, r1)  # t22
    np.add(h_3, r1, r1)  # t23
    np.add(r1, r3, r3)  # t24
    np.subtract(r3, h_4, r3)  # t25
    np.subtract(r3, h_5, r3)  # t26
    np.multiply(J_z, r2, r2)  # t27
    np.divide(r3, r2, r2)  # t28
    np.negative(r2, out_w_z)  # t29


def rates_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z, out=None):
    """Angular rates of a body, at rest with its wheels at rest, that six wheels of which the last has failed give it.

        w_x = -sqrt(3)*(h_2 + h_3 + h_5)*sin(a)/(2*J_x)
        w_y = -(-2*h_1 - h_2 + h_3 - 2*h_4 - h_5)*sin(a)/(2*J_y)
        w_z = -(h_1 + h_2 + h_3 - h_4 - h_5)*cos(a)/J_z

    Arguments:
        h_1: momentum of wheel 1, in units of h_max; -1 <= h_1 <= 1
        h_2: momentum of wheel 2, in units of h_max; -1 <= h_2 <= 1
        h_3: momentum of wheel 3, in units of h_max; -1 <= h_3 <= 1
        h_4: momentum of wheel 4, in units of h_max; -1 <= h_4 <= 1
        h_5: momentum of wheel 5, in units of h_max; -1 <= h_5 <= 1
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        J_x: moment of inertia about OX, in kg m^2; 0 < J_x
        J_y: moment of inertia about OY, in kg m^2; 0 < J_y
        J_z: moment of inertia about OZ, in kg m^2; 0 < J_z

    Returns a tuple:
        w_x: angular rate about OX, in units of h_max/(kg m^2)
        w_y: angular rate about OY, in units of h_max/(kg m^2)
        w_z: angular rate about OZ, in units of h_max/(kg m^2)

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. Momenta of wheels may cancel: counted in units of the last place of the
    largest h_i e_i.

    Rests on ignatov2005:3.2.1 (sha256 627cc0ca9e03), ignatov2005:2.3 (sha256 233596362da2).
    """
    if out is None:
        if type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(a) is type(J_x) is type(J_y) is type(J_z) is float:
            try:
                return _rates_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z, math.cos, math.sin, 1.0 / 2.0, math.sqrt(3.0), 2.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(a) is type(J_x) is type(J_y) is type(J_z) is np.ndarray and h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is h_5.dtype is a.dtype is J_x.dtype is J_y.dtype is J_z.dtype is DOUBLE and h_1.shape == h_2.shape == h_3.shape == h_4.shape == h_5.shape == a.shape == J_x.shape == J_y.shape == J_z.shape:
            if h_1.size <= FEW:
                return _rates_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z)
            return evaluate_alike(_rates_of_five_wheels_block, 5, (0, 1, 2,), (h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z,))
    return evaluate(_rates_of_five_wheels_block, 5, (0, 1, 2,), (h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z,), out)


def _rates_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z, cos=np.cos, sin=np.sin, n1_2=np.array(1.0 / 2.0), sqrt_3=np.array(math.sqrt(3.0)), n2=np.array(2.0)):
    t1 = h_2 + h_5
    t2 = n1_2 * sin(a)
    return -(((h_3 + t1) * (sqrt_3 * t2)) / J_x), -(((((h_3 - (n2 * h_1)) - (n2 * h_4)) - t1) * t2) / J_y), -((cos(a) * (((h_3 + (h_1 + h_2)) - h_4) - h_5)) / J_z)


def _rates_of_five_wheels_block(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z, out_w_x, out_w_y, out_w_z, r0, r1, r2, r3, r4):
    np.add(h_2, h_5, r0)  # t1
    np.tan(a, r1)  # tan_a
    np.multiply(r1, r1, r2)  # tan_a_squared
    np.add(1.0, r2, r2)  # t2
    np.sqrt(r2, r2)  # t3
    np.multiply(1.0 / 2.0, r1, r1)  # t4
    np.divide(r1, r2, r1)  # t5
    np.add(h_3, r0, r3)  # t6
    np.multiply(math.sqrt(3.0), r1, r4)  # t7
    np.multiply(r3, r4, r4)  # t8
    np.divide(r4, J_x, r4)  # t9
    np.negative(r4, out_w_x)  # t10
    np.multiply(2.0, h_1, r4)  # t11
    np.multiply(2.0, h_4, r3)  # t12
    np.subtract(h_3, r4, r4)  # t13
    np.subtract(r4, r3, r3)  # t14
    np.subtract(r3, r0, r0)  # t15
    np.multiply(r0, r1, r1)  # t16
    np.divide(r1, J_y, r1)  # t17
    np.negative(r1, out_w_y)  # t18
    np.add(h_1, h_2, r1)  # t19
    np.add(h_3, r1, r1)  # t20
    np.subtract(r1, h_4, r1)  # t21
    np.subtract(r1, h_5, r1)  # t22
    np.multiply(J_z, r2, r2)  # t23
    np.divide(r1, r2, r2)  # t24
    np.negative(r2, out_w_z)  # t25


def vertices_of_four_wheels(a, b, out=None):
    """Vertices V_i = -V'_i of the envelope of four wheels, without components that are zero.

        V_1x = 4*sin(a)*sin(b)
        V_2x = 2*sin(a)*sin(b)
        V_2y = 2*sin(a)*cos(b)
        V_2z = 2*cos(a)
        V_3x = 2*sin(a)*sin(b)
        V_3y = -2*sin(a)*cos(b)
        V_3z = 2*cos(a)
        V_4x = 2*sin(a)*sin(b)
        V_4y = 2*sin(a)*cos(b)
        V_4z = -2*cos(a)
        V_5x = 2*sin(a)*sin(b)
        V_5y = -2*sin(a)*cos(b)
        V_5z = -2*cos(a)
        V_6y = -4*sin(a)*cos(b)
        V_7z = -4*cos(a)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        b: angle of the side edges in the plane OXY, in rad; 0 < b < pi/2

    Returns a tuple:
        V_1x: x of V_1, in units of h_max
        V_2x: x of V_2, in units of h_max
        V_2y: y of V_2, in units of h_max
        V_2z: z of V_2, in units of h_max
        V_3x: x of V_3, in units of h_max
        V_3y: y of V_3, in units of h_max
        V_3z: z of V_3, in units of h_max
        V_4x: x of V_4, in units of h_max
        V_4y: y of V_4, in units of h_max
        V_4z: z of V_4, in units of h_max
        V_5x: x of V_5, in units of h_max
        V_5y: y of V_5, in units of h_max
        V_5z: z of V_5, in units of h_max
        V_6y: y of V_6, in units of h_max
        V_7z: z of V_7, in units of h_max

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 15 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number. Outputs that are equal by formula are one array, unless `out` is given.

    Accuracy: 6 ulp over the domain. Tangents of two angles, a root and a quotient are rounded one after the
    other.

    Rests on ignatov2005:2.1V.1a (sha256 94b8e26f0769), ignatov2005:2.1V.2a (sha256 80579f087ea4),
    ignatov2005:2.1V.3a (sha256 2257d1e84ce7), ignatov2005:2.1V.4a (sha256 e0b417442b9e), ignatov2005:2.1V.5a
    (sha256 a62897744444), ignatov2005:2.1V.6a (sha256 9f473c0762c6), ignatov2005:2.1V.7a (sha256 b9c4435a36b9).
    """
    if out is None:
        if type(a) is type(b) is float:
            try:
                return _vertices_of_four_wheels(a, b, math.cos, math.sin, 2.0, 4.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is type(b) is np.ndarray and a.dtype is b.dtype is DOUBLE and a.shape == b.shape:
            if a.size <= FEW:
                return _vertices_of_four_wheels(a, b)
            return evaluate_alike(_vertices_of_four_wheels_block, 5, (0, 1, 2, 3, 1, 4, 3, 1, 2, 5, 1, 4, 5, 6, 7,), (a, b,))
    return evaluate(_vertices_of_four_wheels_block, 5, (0, 1, 2, 3, 1, 4, 3, 1, 2, 5, 1, 4, 5, 6, 7,), (a, b,), out)


def _vertices_of_four_wheels(a, b, cos=np.cos, sin=np.sin, n2=np.array(2.0), n4=np.array(4.0)):
    sin_a = sin(a)
    t1 = sin_a * sin(b)
    t2 = n2 * t1
    t3 = cos(b) * sin_a
    t4 = n2 * t3
    cos_a = cos(a)
    t5 = n2 * cos_a
    t6 = -t4
    t7 = -t5
    return n4 * t1, t2, t4, t5, t2, t6, t5, t2, t4, t7, t2, t6, t7, -(n4 * t3), -(n4 * cos_a)


def _vertices_of_four_wheels_block(a, b, out_V_1x, out_V_2x, out_V_2y, out_V_2z, out_V_3y, out_V_4z, out_V_6y, out_V_7z, r0, r1, r2, r3, r4):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.add(1.0, r1, r1)  # t1
    np.sqrt(r1, r2)  # t2
    np.tan(b, r3)  # tan_b
    np.multiply(r3, r3, r4)  # tan_b_squared
    np.add(1.0, r4, r4)  # t4
    np.multiply(r1, r4, r4)  # t5
    np.sqrt(r4, r4)  # t6
    np.multiply(r0, r3, r3)  # t7
    np.divide(r3, r4, r3)  # t8
    np.multiply(2.0, r3, out_V_2x)  # t9
    np.divide(r0, r4, r4)  # t10
    np.multiply(2.0, r4, out_V_2y)  # t11
    np.divide(2.0, r2, out_V_2z)  # t13
    np.negative(out_V_2y, out_V_3y)  # t14
    np.negative(out_V_2z, out_V_4z)  # t15
    np.multiply(4.0, r3, out_V_1x)  # t16
    np.multiply(4.0, r4, r4)  # t17
    np.negative(r4, out_V_6y)  # t18
    np.divide(4.0, r2, r2)  # t19
    np.negative(r2, out_V_7z)  # t20


def vertices_of_three_wheels(a, b, out=None):
    """Vertices V_i = -V'_i of the envelope of four wheels of which the last has failed, without components that are zero.

        V_1x = 3*sin(a)*sin(b)
        V_1y = -sin(a)*cos(b)
        V_1z = -cos(a)
        V_2x = sin(a)*sin(b)
        V_2y = sin(a)*cos(b)
        V_2z = cos(a)
        V_3x = sin(a)*sin(b)
        V_3y = -3*sin(a)*cos(b)
        V_3z = cos(a)
        V_4x = sin(a)*sin(b)
        V_4y = sin(a)*cos(b)
        V_4z = -3*cos(a)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        b: angle of the side edges in the plane OXY, in rad; 0 < b < pi/2

    Returns a tuple:
        V_1x: x of V_1, in units of h_max
        V_1y: y of V_1, in units of h_max
        V_1z: z of V_1, in units of h_max
        V_2x: x of V_2, in units of h_max
        V_2y: y of V_2, in units of h_max
        V_2z: z of V_2, in units of h_max
        V_3x: x of V_3, in units of h_max
        V_3y: y of V_3, in units of h_max
        V_3z: z of V_3, in units of h_max
        V_4x: x of V_4, in units of h_max
        V_4y: y of V_4, in units of h_max
        V_4z: z of V_4, in units of h_max

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 12 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number. Outputs that are equal by formula are one array, unless `out` is given.

    Accuracy: 6 ulp over the domain. Tangents of two angles, a root and a quotient are rounded one after the
    other.

    Rests on ignatov2005:2.2V.1a (sha256 1328905443f8), ignatov2005:2.2V.2a (sha256 4707241dda37),
    ignatov2005:2.2V.3a (sha256 ff1dc70e4e37), ignatov2005:2.2V.4a (sha256 7594a5d54588).
    """
    if out is None:
        if type(a) is type(b) is float:
            try:
                return _vertices_of_three_wheels(a, b, math.cos, math.sin, 3.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is type(b) is np.ndarray and a.dtype is b.dtype is DOUBLE and a.shape == b.shape:
            if a.size <= FEW:
                return _vertices_of_three_wheels(a, b)
            return evaluate_alike(_vertices_of_three_wheels_block, 5, (0, 1, 2, 3, 4, 5, 3, 6, 5, 3, 4, 7,), (a, b,))
    return evaluate(_vertices_of_three_wheels_block, 5, (0, 1, 2, 3, 4, 5, 3, 6, 5, 3, 4, 7,), (a, b,), out)


def _vertices_of_three_wheels(a, b, cos=np.cos, sin=np.sin, n3=np.array(3.0)):
    sin_a = sin(a)
    t1 = sin_a * sin(b)
    t2 = cos(b) * sin_a
    cos_a = cos(a)
    return n3 * t1, -t2, -cos_a, t1, t2, cos_a, t1, -(n3 * t2), cos_a, t1, t2, -(n3 * cos_a)


def _vertices_of_three_wheels_block(a, b, out_V_1x, out_V_1y, out_V_1z, out_V_2x, out_V_2y, out_V_2z, out_V_3y, out_V_4z, r0, r1, r2, r3, r4):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.add(1.0, r1, r1)  # t1
    np.sqrt(r1, r2)  # t2
    np.tan(b, r3)  # tan_b
    np.multiply(r3, r3, r4)  # tan_b_squared
    np.add(1.0, r4, r4)  # t4
    np.multiply(r1, r4, r4)  # t5
    np.sqrt(r4, r4)  # t6
    np.multiply(r0, r3, r3)  # t7
    np.divide(r3, r4, out_V_2x)  # t8
    np.divide(r0, r4, out_V_2y)  # t9
    np.divide(1.0, r2, out_V_2z)  # t10
    np.multiply(3.0, out_V_2x, out_V_1x)  # t11
    np.negative(out_V_2y, out_V_1y)  # t12
    np.negative(out_V_2z, out_V_1z)  # t13
    np.multiply(3.0, out_V_2y, r4)  # t14
    np.negative(r4, out_V_3y)  # t15
    np.divide(3.0, r2, r2)  # t16
    np.negative(r2, out_V_4z)  # t17


def vertices_of_six_wheels(a, out=None):
    """Vertices V_i = -V'_i of the envelope of six wheels, without components that are zero.

        V_1z = 6*cos(a)
        V_2y = 2*sin(a)
        V_2z = 4*cos(a)
        V_3x = -sqrt(3)*sin(a)
        V_3y = sin(a)
        V_3z = 4*cos(a)
        V_4x = -sqrt(3)*sin(a)
        V_4y = -sin(a)
        V_4z = 4*cos(a)
        V_5y = -2*sin(a)
        V_5z = 4*cos(a)
        V_6x = sqrt(3)*sin(a)
        V_6y = -sin(a)
        V_6z = 4*cos(a)
        V_7x = sqrt(3)*sin(a)
        V_7y = sin(a)
        V_7z = 4*cos(a)
        V_8x = sqrt(3)*sin(a)
        V_8y = 3*sin(a)
        V_8z = 2*cos(a)
        V_9x = -sqrt(3)*sin(a)
        V_9y = 3*sin(a)
        V_9z = 2*cos(a)
        V_10x = -2*sqrt(3)*sin(a)
        V_10z = 2*cos(a)
        V_11x = -sqrt(3)*sin(a)
        V_11y = -3*sin(a)
        V_11z = 2*cos(a)
        V_12x = sqrt(3)*sin(a)
        V_12y = -3*sin(a)
        V_12z = 2*cos(a)
        V_13x = 2*sqrt(3)*sin(a)
        V_13z = 2*cos(a)
        V_14x = 2*sqrt(3)*sin(a)
        V_14y = 2*sin(a)
        V_15y = 4*sin(a)
        V_16x = -2*sqrt(3)*sin(a)
        V_16y = 2*sin(a)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2

    Returns a tuple:
        V_1z: z of V_1, in units of h_max
        V_2y: y of V_2, in units of h_max
        V_2z: z of V_2, in units of h_max
        V_3x: x of V_3, in units of h_max
        V_3y: y of V_3, in units of h_max
        V_3z: z of V_3, in units of h_max
        V_4x: x of V_4, in units of h_max
        V_4y: y of V_4, in units of h_max
        V_4z: z of V_4, in units of h_max
        V_5y: y of V_5, in units of h_max
        V_5z: z of V_5, in units of h_max
        V_6x: x of V_6, in units of h_max
        V_6y: y of V_6, in units of h_max
        V_6z: z of V_6, in units of h_max
        V_7x: x of V_7, in units of h_max
        V_7y: y of V_7, in units of h_max
        V_7z: z of V_7, in units of h_max
        V_8x: x of V_8, in units of h_max
        V_8y: y of V_8, in units of h_max
        V_8z: z of V_8, in units of h_max
        V_9x: x of V_9, in units of h_max
        V_9y: y of V_9, in units of h_max
        V_9z: z of V_9, in units of h_max
        V_10x: x of V_10, in units of h_max
        V_10z: z of V_10, in units of h_max
        V_11x: x of V_11, in units of h_max
        V_11y: y of V_11, in units of h_max
        V_11z: z of V_11, in units of h_max
        V_12x: x of V_12, in units of h_max
        V_12y: y of V_12, in units of h_max
        V_12z: z of V_12, in units of h_max
        V_13x: x of V_13, in units of h_max
        V_13z: z of V_13, in units of h_max
        V_14x: x of V_14, in units of h_max
        V_14y: y of V_14, in units of h_max
        V_15y: y of V_15, in units of h_max
        V_16x: x of V_16, in units of h_max
        V_16y: y of V_16, in units of h_max

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 38 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number. Outputs that are equal by formula are one array, unless `out` is given.

    Accuracy: 5 ulp over the domain. The square root of 3 and half a sine are rounded too.

    Rests on ignatov2005:3.1V.1a (sha256 8c2b00545e7d), ignatov2005:3.1V.2a (sha256 067fb2bec942),
    ignatov2005:3.1V.3a (sha256 41535d701c6f), ignatov2005:3.1V.4a (sha256 9476d5b0b3b6), ignatov2005:3.1V.5a
    (sha256 6cb9a19aaef2), ignatov2005:3.1V.6a (sha256 7e69a3b1a347), ignatov2005:3.1V.7a (sha256 0ee825fe79a4),
    ignatov2005:3.1V.8a (sha256 aceed7401197), ignatov2005:3.1V.9a (sha256 ec42ed94c49f), ignatov2005:3.1V.10a
    (sha256 e344545aa6de), ignatov2005:3.1V.11a (sha256 dde03da8c5da), ignatov2005:3.1V.12a (sha256 2d50279ca6bf),
    ignatov2005:3.1V.13a (sha256 fb3302f065b5), ignatov2005:3.1V.14a (sha256 7bfd21c503a4), ignatov2005:3.1V.15a
    (sha256 794169dc5b05), ignatov2005:3.1V.16a (sha256 8492d5ba141e).
    """
    if out is None:
        if type(a) is float:
            try:
                return _vertices_of_six_wheels(a, math.cos, math.sin, 2.0, 4.0, math.sqrt(3.0), 3.0, 6.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is np.ndarray and a.dtype is DOUBLE:
            if a.size <= FEW:
                return _vertices_of_six_wheels(a)
            return evaluate_alike(_vertices_of_six_wheels_block, 3, (0, 1, 2, 3, 4, 2, 3, 5, 2, 6, 2, 7, 5, 2, 7, 4, 2, 7, 8, 9, 3, 8, 9, 10, 9, 3, 11, 9, 7, 11, 9, 12, 9, 12, 1, 13, 10, 1,), (a,))
    return evaluate(_vertices_of_six_wheels_block, 3, (0, 1, 2, 3, 4, 2, 3, 5, 2, 6, 2, 7, 5, 2, 7, 4, 2, 7, 8, 9, 3, 8, 9, 10, 9, 3, 11, 9, 7, 11, 9, 12, 9, 12, 1, 13, 10, 1,), (a,), out)


def _vertices_of_six_wheels(a, cos=np.cos, sin=np.sin, n2=np.array(2.0), n4=np.array(4.0), sqrt_3=np.array(math.sqrt(3.0)), n3=np.array(3.0), n6=np.array(6.0)):
    cos_a = cos(a)
    sin_a = sin(a)
    t1 = n2 * sin_a
    t2 = n4 * cos_a
    t3 = sin_a * sqrt_3
    t4 = -t3
    t5 = -sin_a
    t6 = n3 * sin_a
    t7 = n2 * cos_a
    t8 = sqrt_3 * t1
    t9 = -t8
    t10 = -t6
    return n6 * cos_a, t1, t2, t4, sin_a, t2, t4, t5, t2, -t1, t2, t3, t5, t2, t3, sin_a, t2, t3, t6, t7, t4, t6, t7, t9, t7, t4, t10, t7, t3, t10, t7, t8, t7, t8, t1, n4 * sin_a, t9, t1


def _vertices_of_six_wheels_block(a, out_V_1z, out_V_2y, out_V_2z, out_V_3x, out_V_3y, out_V_4y, out_V_5y, out_V_6x, out_V_8y, out_V_8z, out_V_10x, out_V_11y, out_V_13x, out_V_15y, r0, r1, r2):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.add(1.0, r1, r1)  # t1
    np.sqrt(r1, r1)  # t2
    np.divide(r0, r1, out_V_3y)  # t4
    np.multiply(2.0, r0, r2)  # t5
    np.divide(r2, r1, out_V_2y)  # t6
    np.divide(4.0, r1, out_V_2z)  # t7
    np.multiply(math.sqrt(3.0), r0, r2)  # t8
    np.divide(r2, r1, out_V_6x)  # t9
    np.negative(out_V_6x, out_V_3x)  # t10
    np.negative(out_V_3y, out_V_4y)  # t11
    np.multiply(3.0, r0, r2)  # t12
    np.divide(r2, r1, out_V_8y)  # t13
    np.divide(2.0, r1, out_V_8z)  # t14
    np.multiply(math.sqrt(3.0), out_V_2y, out_V_13x)  # t15
    np.negative(out_V_13x, out_V_10x)  # t16
    np.negative(out_V_8y, out_V_11y)  # t17
    np.divide(6.0, r1, out_V_1z)  # t18
    np.negative(out_V_2y, out_V_5y)  # t19
    np.multiply(4.0, r0, r0)  # t20
    np.divide(r0, r1, out_V_15y)  # t21


def vertices_of_five_wheels(a, out=None):
    """Vertices V_i = -V'_i of the envelope of six wheels of which the last has failed, without components that are zero.

        V_1x = sqrt(3)*sin(a)/2
        V_1y = sin(a)/2
        V_1z = 5*cos(a)
        V_2x = sqrt(3)*sin(a)/2
        V_2y = 5*sin(a)/2
        V_2z = 3*cos(a)
        V_3x = -sqrt(3)*sin(a)/2
        V_3y = 3*sin(a)/2
        V_3z = 3*cos(a)
        V_4x = -sqrt(3)*sin(a)/2
        V_4y = -sin(a)/2
        V_4z = 3*cos(a)
        V_5x = sqrt(3)*sin(a)/2
        V_5y = -3*sin(a)/2
        V_5z = 3*cos(a)
        V_6x = 3*sqrt(3)*sin(a)/2
        V_6y = -sin(a)/2
        V_6z = 3*cos(a)
        V_7x = 3*sqrt(3)*sin(a)/2
        V_7y = 3*sin(a)/2
        V_7z = cos(a)
        V_8x = -sqrt(3)*sin(a)/2
        V_8y = 7*sin(a)/2
        V_8z = cos(a)
        V_9x = -3*sqrt(3)*sin(a)/2
        V_9y = sin(a)/2
        V_9z = cos(a)
        V_10x = -sqrt(3)*sin(a)/2
        V_10y = -5*sin(a)/2
        V_10z = cos(a)
        V_11x = 3*sqrt(3)*sin(a)/2
        V_11y = -5*sin(a)/2
        V_11z = cos(a)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2

    Returns a tuple:
        V_1x: x of V_1, in units of h_max
        V_1y: y of V_1, in units of h_max
        V_1z: z of V_1, in units of h_max
        V_2x: x of V_2, in units of h_max
        V_2y: y of V_2, in units of h_max
        V_2z: z of V_2, in units of h_max
        V_3x: x of V_3, in units of h_max
        V_3y: y of V_3, in units of h_max
        V_3z: z of V_3, in units of h_max
        V_4x: x of V_4, in units of h_max
        V_4y: y of V_4, in units of h_max
        V_4z: z of V_4, in units of h_max
        V_5x: x of V_5, in units of h_max
        V_5y: y of V_5, in units of h_max
        V_5z: z of V_5, in units of h_max
        V_6x: x of V_6, in units of h_max
        V_6y: y of V_6, in units of h_max
        V_6z: z of V_6, in units of h_max
        V_7x: x of V_7, in units of h_max
        V_7y: y of V_7, in units of h_max
        V_7z: z of V_7, in units of h_max
        V_8x: x of V_8, in units of h_max
        V_8y: y of V_8, in units of h_max
        V_8z: z of V_8, in units of h_max
        V_9x: x of V_9, in units of h_max
        V_9y: y of V_9, in units of h_max
        V_9z: z of V_9, in units of h_max
        V_10x: x of V_10, in units of h_max
        V_10y: y of V_10, in units of h_max
        V_10z: z of V_10, in units of h_max
        V_11x: x of V_11, in units of h_max
        V_11y: y of V_11, in units of h_max
        V_11z: z of V_11, in units of h_max

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 33 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number. Outputs that are equal by formula are one array, unless `out` is given.

    Accuracy: 5 ulp over the domain. The square root of 3 and half a sine are rounded too.

    Rests on ignatov2005:3.2V.1a (sha256 d0db951b702d), ignatov2005:3.2V.2a (sha256 fe89686584b6),
    ignatov2005:3.2V.3a (sha256 39d280840367), ignatov2005:3.2V.4a (sha256 64d3045d53d3), ignatov2005:3.2V.5a
    (sha256 f9756e9d50ef), ignatov2005:3.2V.6a (sha256 d979e17e90aa), ignatov2005:3.2V.7a (sha256 9459dedf6e68),
    ignatov2005:3.2V.8a (sha256 fd32014c951f), ignatov2005:3.2V.9a (sha256 b9f9209f8293), ignatov2005:3.2V.10a
    (sha256 e6f228859ccb), ignatov2005:3.2V.11a (sha256 969fdc746efd).
    """
    if out is None:
        if type(a) is float:
            try:
                return _vertices_of_five_wheels(a, math.cos, math.sin, 1.0 / 2.0, math.sqrt(3.0), 5.0 / 2.0, 3.0, 3.0 / 2.0, 5.0, 7.0 / 2.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is np.ndarray and a.dtype is DOUBLE:
            if a.size <= FEW:
                return _vertices_of_five_wheels(a)
            return evaluate_alike(_vertices_of_five_wheels_block, 3, (0, 1, 2, 0, 3, 4, 5, 6, 4, 5, 7, 4, 0, 8, 4, 9, 7, 4, 9, 6, 10, 5, 11, 10, 12, 1, 10, 5, 13, 10, 9, 13, 10,), (a,))
    return evaluate(_vertices_of_five_wheels_block, 3, (0, 1, 2, 0, 3, 4, 5, 6, 4, 5, 7, 4, 0, 8, 4, 9, 7, 4, 9, 6, 10, 5, 11, 10, 12, 1, 10, 5, 13, 10, 9, 13, 10,), (a,), out)


def _vertices_of_five_wheels(a, cos=np.cos, sin=np.sin, n1_2=np.array(1.0 / 2.0), sqrt_3=np.array(math.sqrt(3.0)), n5_2=np.array(5.0 / 2.0), n3=np.array(3.0), n3_2=np.array(3.0 / 2.0), n5=np.array(5.0), n7_2=np.array(7.0 / 2.0)):
    sin_a = sin(a)
    t1 = n1_2 * sin_a
    t2 = sqrt_3 * t1
    cos_a = cos(a)
    t3 = n5_2 * sin_a
    t4 = n3 * cos_a
    t5 = -t2
    t6 = n3_2 * sin_a
    t7 = -t1
    t8 = sqrt_3 * t6
    t9 = -t3
    return t2, t1, n5 * cos_a, t2, t3, t4, t5, t6, t4, t5, t7, t4, t2, -t6, t4, t8, t7, t4, t8, t6, cos_a, t5, n7_2 * sin_a, cos_a, -t8, t1, cos_a, t5, t9, cos_a, t8, t9, cos_a


def _vertices_of_five_wheels_block(a, out_V_1x, out_V_1y, out_V_1z, out_V_2y, out_V_2z, out_V_3x, out_V_3y, out_V_4y, out_V_5y, out_V_6x, out_V_7z, out_V_8y, out_V_9x, out_V_10y, r0, r1, r2):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.add(1.0, r1, r1)  # t1
    np.sqrt(r1, r1)  # t2
    np.multiply(1.0 / 2.0, r0, r2)  # t4
    np.divide(r2, r1, out_V_1y)  # t5
    np.multiply(math.sqrt(3.0), out_V_1y, out_V_1x)  # t6
    np.divide(1.0, r1, out_V_7z)  # t7
    np.multiply(5.0 / 2.0, r0, r2)  # t8
    np.divide(r2, r1, out_V_2y)  # t9
    np.divide(3.0, r1, out_V_2z)  # t10
    np.negative(out_V_1x, out_V_3x)  # t11
    np.multiply(3.0 / 2.0, r0, r2)  # t12
    np.divide(r2, r1, out_V_3y)  # t13
    np.negative(out_V_1y, out_V_4y)  # t14
    np.multiply(math.sqrt(3.0), out_V_3y, out_V_6x)  # t15
    np.negative(out_V_2y, out_V_10y)  # t16
    np.divide(5.0, r1, out_V_1z)  # t17
    np.negative(out_V_3y, out_V_5y)  # t18
    np.multiply(7.0 / 2.0, r0, r0)  # t19
    np.divide(r0, r1, out_V_8y)  # t20
    np.negative(out_V_6x, out_V_9x)  # t21


def vertex_distances_of_four_wheels(a, b, out=None):
    """Distances from the centre to the vertices of the envelope of four wheels.

        d_1 = 4*sin(a)*sin(b)
        d_2 = 4*sin(a)*cos(b)
        d_3 = 4*cos(a)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        b: angle of the side edges in the plane OXY, in rad; 0 < b < pi/2

    Returns a tuple:
        d_1: distance of V_1, in units of h_max
        d_2: distance of V_6, in units of h_max
        d_3: distance of V_7 (V_2 to V_5 are 2 away at all angles), in units of h_max

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 6 ulp over the domain. Tangents of two angles, a root and a quotient are rounded one after the
    other.

    Rests on ignatov2005:2.1.28 (sha256 bd2cd189e2df), ignatov2005:2.1.29 (sha256 3e1f87650cb1),
    ignatov2005:2.1.30 (sha256 26da3182c8fc).
    """
    if out is None:
        if type(a) is type(b) is float:
            try:
                return _vertex_distances_of_four_wheels(a, b, math.cos, math.sin, 4.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is type(b) is np.ndarray and a.dtype is b.dtype is DOUBLE and a.shape == b.shape:
            if a.size <= FEW:
                return _vertex_distances_of_four_wheels(a, b)
            return evaluate_alike(_vertex_distances_of_four_wheels_block, 4, (0, 1, 2,), (a, b,))
    return evaluate(_vertex_distances_of_four_wheels_block, 4, (0, 1, 2,), (a, b,), out)


def _vertex_distances_of_four_wheels(a, b, cos=np.cos, sin=np.sin, n4=np.array(4.0)):
    t1 = n4 * sin(a)
    return sin(b) * t1, cos(b) * t1, n4 * cos(a)


def _vertex_distances_of_four_wheels_block(a, b, out_d_1, out_d_2, out_d_3, r0, r1, r2, r3):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.add(1.0, r1, r1)  # t1
    np.sqrt(r1, r1)  # t2
    np.multiply(4.0, r0, r0)  # t3
    np.divide(r0, r1, r0)  # t4
    np.tan(b, r2)  # tan_b
    np.multiply(r2, r2, r3)  # tan_b_squared
    np.add(1.0, r3, r3)  # t5
    np.sqrt(r3, r3)  # t6
    np.multiply(r0, r2, r2)  # t7
    np.divide(r2, r3, out_d_1)  # t8
    np.divide(r0, r3, out_d_2)  # t9
    np.divide(4.0, r1, out_d_3)  # t10


def vertex_distances_of_three_wheels(a, b, out=None):
    """Distances from the centre to the vertices of the envelope of four wheels of which the last has failed.

        d_1 = sqrt(9*sin(a)**2*sin(b)**2 + sin(a)**2*cos(b)**2 + cos(a)**2)
        d_2 = sqrt(sin(a)**2*sin(b)**2 + 9*sin(a)**2*cos(b)**2 + cos(a)**2)
        d_3 = sqrt(sin(a)**2*sin(b)**2 + sin(a)**2*cos(b)**2 + 9*cos(a)**2)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        b: angle of the side edges in the plane OXY, in rad; 0 < b < pi/2

    Returns a tuple:
        d_1: distance of V_1, in units of h_max
        d_2: distance of V_3, in units of h_max
        d_3: distance of V_4 (V_2 is 1 away at all angles), in units of h_max

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain.

    Rests on ignatov2005:2.2.18 (sha256 5737c60fba94), ignatov2005:2.2.19 (sha256 cffa1447a15d),
    ignatov2005:2.2.20 (sha256 f4a028f547e1). The forms computed are proved equal to those shown (sha256
    f520c9c82bc3).
    """
    if out is None:
        if type(a) is type(b) is float:
            try:
                return _vertex_distances_of_three_wheels(a, b, math.sqrt, math.tan, 1.0, 8.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is type(b) is np.ndarray and a.dtype is b.dtype is DOUBLE and a.shape == b.shape:
            if a.size <= SMALL:
                return _vertex_distances_of_three_wheels(a, b)
            return evaluate_alike(_vertex_distances_of_three_wheels_block, 4, (0, 1, 2,), (a, b,))
    return evaluate(_vertex_distances_of_three_wheels_block, 4, (0, 1, 2,), (a, b,), out)


def _vertex_distances_of_three_wheels(a, b, sqrt=np.sqrt, tan=np.tan, n1=np.array(1.0), n8=np.array(8.0)):
    tan_b = tan(b)
    tan_b_squared = tan_b * tan_b
    tan_a = tan(a)
    tan_a_squared = tan_a * tan_a
    t2 = n8 / (n1 + tan_a_squared)
    t5 = (t2 * tan_a_squared) / (n1 + tan_b_squared)
    return sqrt(n1 + (t5 * tan_b_squared)), sqrt(n1 + t5), sqrt(n1 + t2)


def _vertex_distances_of_three_wheels_block(a, b, out_d_1, out_d_2, out_d_3, r0, r1, r2, r3):
    np.tan(b, r0)  # tan_b
    np.multiply(r0, r0, r0)  # tan_b_squared
    np.tan(a, r1)  # tan_a
    np.multiply(r1, r1, r1)  # tan_a_squared
    np.add(1.0, r1, r2)  # t1
    np.divide(8.0, r2, r2)  # t2
    np.add(1.0, r0, r3)  # t3
    np.multiply(r2, r1, r1)  # t4
    np.divide(r1, r3, r3)  # t5
    np.multiply(r3, r0, r0)  # t6
    np.add(1.0, r0, r0)  # t7
    np.sqrt(r0, out_d_1)  # t8
    np.add(1.0, r3, r3)  # t9
    np.sqrt(r3, out_d_2)  # t10
    np.add(1.0, r2, r2)  # t11
    np.sqrt(r2, out_d_3)  # t12


def vertex_distances_of_six_wheels(a, out=None):
    """Distances from the centre to the vertices of the envelope of six wheels.

        d_1 = 6*cos(a)
        d_2 = 4*sin(a)
        d_3 = sqrt(4*sin(a)**2 + 16*cos(a)**2)
        d_4 = sqrt(12*sin(a)**2 + 4*cos(a)**2)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2

    Returns a tuple:
        d_1: distance of V_1, in units of h_max
        d_2: distance of V_14 to V_16, in units of h_max
        d_3: distance of V_2 to V_7, in units of h_max
        d_4: distance of V_8 to V_13, in units of h_max

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 4 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain.

    Rests on ignatov2005:3.1.28 (sha256 7ca73f2407a7), ignatov2005:3.1.29 (sha256 cd61e3fa453a),
    ignatov2005:3.1.30 (sha256 3ff14fbe7354), ignatov2005:3.1.31 (sha256 45466741b047). The forms computed are
    proved equal to those shown (sha256 0bd0d880e232).
    """
    if out is None:
        if type(a) is float:
            try:
                return _vertex_distances_of_six_wheels(a, math.cos, math.sin, math.sqrt, math.tan, 1.0, 6.0, 4.0, 3.0, 2.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is np.ndarray and a.dtype is DOUBLE:
            if a.size <= FEW:
                return _vertex_distances_of_six_wheels(a)
            return evaluate_alike(_vertex_distances_of_six_wheels_block, 4, (0, 1, 2, 3,), (a,))
    return evaluate(_vertex_distances_of_six_wheels_block, 4, (0, 1, 2, 3,), (a,), out)


def _vertex_distances_of_six_wheels(a, cos=np.cos, sin=np.sin, sqrt=np.sqrt, tan=np.tan, n1=np.array(1.0), n6=np.array(6.0), n4=np.array(4.0), n3=np.array(3.0), n2=np.array(2.0)):
    tan_a = tan(a)
    tan_a_squared = tan_a * tan_a
    t2 = n1 / (n1 + tan_a_squared)
    return n6 * cos(a), n4 * sin(a), n2 * sqrt(n1 + (n3 * t2)), n2 * sqrt(n1 + (n2 * (t2 * tan_a_squared)))


def _vertex_distances_of_six_wheels_block(a, out_d_1, out_d_2, out_d_3, out_d_4, r0, r1, r2, r3):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.add(1.0, r1, r2)  # t1
    np.divide(1.0, r2, r3)  # t2
    np.sqrt(r2, r2)  # t3
    np.divide(6.0, r2, out_d_1)  # t4
    np.multiply(4.0, r0, r0)  # t5
    np.divide(r0, r2, out_d_2)  # t6
    np.multiply(3.0, r3, r2)  # t7
    np.add(1.0, r2, r2)  # t8
    np.sqrt(r2, r2)  # t9
    np.multiply(2.0, r2, out_d_3)  # t10
    np.multiply(r3, r1, r1)  # t11
    np.multiply(2.0, r1, r1)  # t12
    np.add(1.0, r1, r1)  # t13
    np.sqrt(r1, r1)  # t14
    np.multiply(2.0, r1, out_d_4)  # t15


def vertex_distances_of_five_wheels(a, out=None):
    """Distances from the centre to the vertices of the envelope of six wheels of which the last has failed.

        d_1 = sqrt(sin(a)**2 + 25*cos(a)**2)
        d_2 = sqrt(7*sin(a)**2 + 9*cos(a)**2)
        d_3 = sqrt(3*sin(a)**2 + 9*cos(a)**2)
        d_4 = sqrt(sin(a)**2 + 9*cos(a)**2)
        d_5 = sqrt(9*sin(a)**2 + cos(a)**2)
        d_6 = sqrt(13*sin(a)**2 + cos(a)**2)
        d_7 = sqrt(7*sin(a)**2 + cos(a)**2)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2

    Returns a tuple:
        d_1: distance of V_1, in units of h_max
        d_2: distance of V_2 and V_6, in units of h_max
        d_3: distance of V_3 and V_5, in units of h_max
        d_4: distance of V_4, in units of h_max
        d_5: distance of V_7, in units of h_max
        d_6: distance of V_8 and V_11, in units of h_max
        d_7: distance of V_9 and V_10, in units of h_max

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 7 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain.

    Rests on ignatov2005:T10.1 (sha256 0693cf7250ea), ignatov2005:T10.2 (sha256 8dff67d641be), ignatov2005:T10.3
    (sha256 c671f4440e57), ignatov2005:T10.4 (sha256 7acc94a9ae88), ignatov2005:T10.5 (sha256 4748f790d715),
    ignatov2005:T10.6 (sha256 fa8b227fd146), ignatov2005:T10.7 (sha256 6a2cd4a3d8fb). The forms computed are
    proved equal to those shown (sha256 6b611b3313a6).
    """
    if out is None:
        if type(a) is float:
            try:
                return _vertex_distances_of_five_wheels(a, math.sqrt, math.tan, 1.0, 6.0, 8.0, 24.0, 2.0, 7.0, 3.0, 12.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is np.ndarray and a.dtype is DOUBLE:
            if a.size <= SMALL:
                return _vertex_distances_of_five_wheels(a)
            return evaluate_alike(_vertex_distances_of_five_wheels_block, 5, (0, 1, 2, 3, 4, 5, 6,), (a,))
    return evaluate(_vertex_distances_of_five_wheels_block, 5, (0, 1, 2, 3, 4, 5, 6,), (a,), out)


def _vertex_distances_of_five_wheels(a, sqrt=np.sqrt, tan=np.tan, n1=np.array(1.0), n6=np.array(6.0), n8=np.array(8.0), n24=np.array(24.0), n2=np.array(2.0), n7=np.array(7.0), n3=np.array(3.0), n12=np.array(12.0)):
    tan_a = tan(a)
    tan_a_squared = tan_a * tan_a
    t2 = n1 / (n1 + tan_a_squared)
    t3 = n6 * t2
    t4 = n8 * t2
    return sqrt(n1 + (n24 * t2)), sqrt(n7 + (n2 * t2)), sqrt(n3 + t3), sqrt(n1 + t4), sqrt(n1 + (t4 * tan_a_squared)), sqrt(n1 + (n12 * (t2 * tan_a_squared))), sqrt(n1 + (t3 * tan_a_squared))


def _vertex_distances_of_five_wheels_block(a, out_d_1, out_d_2, out_d_3, out_d_4, out_d_5, out_d_6, out_d_7, r0, r1, r2, r3, r4):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r0)  # tan_a_squared
    np.add(1.0, r0, r1)  # t1
    np.divide(1.0, r1, r1)  # t2
    np.multiply(6.0, r1, r2)  # t3
    np.multiply(8.0, r1, r3)  # t4
    np.multiply(24.0, r1, r4)  # t5
    np.add(1.0, r4, r4)  # t6
    np.sqrt(r4, out_d_1)  # t7
    np.multiply(2.0, r1, r4)  # t8
    np.add(7.0, r4, r4)  # t9
    np.sqrt(r4, out_d_2)  # t10
    np.add(3.0, r2, r4)  # t11
    np.sqrt(r4, out_d_3)  # t12
    np.add(1.0, r3, r4)  # t13
    np.sqrt(r4, out_d_4)  # t14
    np.multiply(r3, r0, r3)  # t15
    np.add(1.0, r3, r3)  # t16
    np.sqrt(r3, out_d_5)  # t17
    np.multiply(r1, r0, r1)  # t18
    np.multiply(12.0, r1, r1)  # t19
    np.add(1.0, r1, r1)  # t20
    np.sqrt(r1, out_d_6)  # t21
    np.multiply(r2, r0, r0)  # t22
    np.add(1.0, r0, r0)  # t23
    np.sqrt(r0, out_d_7)  # t24


def face_distances_of_four_wheels(a, b, out=None):
    """Distances from the centre to the planes of the faces of the envelope of four wheels.

        r_1 = 4*sin(a)*sin(b)*cos(a)/sqrt(sin(a)**2*sin(b)**2 + cos(a)**2)
        r_2 = 4*sin(a)*cos(a)*cos(b)/sqrt(sin(a)**2*cos(b)**2 + cos(a)**2)
        r_3 = 4*sin(a)**2*sin(b)*cos(b)/sqrt(sin(a)**2*sin(b)**2 + sin(a)**2*cos(b)**2)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        b: angle of the side edges in the plane OXY, in rad; 0 < b < pi/2

    Returns a tuple:
        r_1: distance of F_1 and F_5, in units of h_max
        r_2: distance of F_2 and F_4, in units of h_max
        r_3: distance of F_3 and F_6, in units of h_max

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 5 ulp over the domain. Tangents of two angles, a root and a quotient are rounded one after the
    other.

    Rests on ignatov2005:T3.1 (sha256 28363ff36a4d), ignatov2005:T3.2 (sha256 a0de382444c2), ignatov2005:T3.3
    (sha256 1ada6fc8bf90). The forms computed are proved equal to those shown (sha256 ec293f1923fb).
    """
    if out is None:
        if type(a) is type(b) is float:
            try:
                return _face_distances_of_four_wheels(a, b, math.sqrt, math.tan, 1.0, 4.0, 2.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is type(b) is np.ndarray and a.dtype is b.dtype is DOUBLE and a.shape == b.shape:
            if a.size <= SMALL:
                return _face_distances_of_four_wheels(a, b)
            return evaluate_alike(_face_distances_of_four_wheels_block, 8, (0, 1, 2,), (a, b,))
    return evaluate(_face_distances_of_four_wheels_block, 8, (0, 1, 2,), (a, b,), out)


def _face_distances_of_four_wheels(a, b, sqrt=np.sqrt, tan=np.tan, n1=np.array(1.0), n4=np.array(4.0), n2=np.array(2.0)):
    tan_a = tan(a)
    tan_a_squared = tan_a * tan_a
    tan_b = tan(b)
    tan_b_squared = tan_b * tan_b
    t1 = n1 + tan_b_squared
    t2 = n4 * tan_a
    t3 = t2 * tan_b
    t4 = t1 * t1
    t11 = sqrt(t1 + ((n1 + ((tan_a_squared * tan_b_squared) + (n2 * tan_b_squared))) * tan_a_squared))
    return t3 / t11, t2 / sqrt(t1 + ((n2 + (tan_a_squared + tan_b_squared)) * tan_a_squared)), t3 / sqrt((t4 * tan_a_squared) + t4)


def _face_distances_of_four_wheels_block(a, b, out_r_1, out_r_2, out_r_3, r0, r1, r2, r3, r4, r5, r6, r7):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.tan(b, r2)  # tan_b
    np.multiply(r2, r2, r3)  # tan_b_squared
    np.add(1.0, r3, r4)  # t1
    np.multiply(4.0, r0, r0)  # t2
    np.multiply(r0, r2, r2)  # t3
    np.multiply(r4, r4, r5)  # t4
    np.multiply(r1, r3, r6)  # t5
    np.multiply(2.0, r3, r7)  # t6
    np.add(r6, r7, r7)  # t7
    np.add(1.0, r7, r7)  # t8
    np.multiply(r7, r1, r7)  # t9
    np.add(r4, r7, r7)  # t10
    np.sqrt(r7, r7)  # t11
    np.divide(r2, r7, out_r_1)  # t12
    np.add(r1, r3, r3)  # t13
    np.add(2.0, r3, r3)  # t14
    np.multiply(r3, r1, r3)  # t15
    np.add(r4, r3, r3)  # t16
    np.sqrt(r3, r3)  # t17
    np.divide(r0, r3, out_r_2)  # t18
    np.multiply(r5, r1, r1)  # t19
    np.add(r1, r5, r5)  # t20
    np.sqrt(r5, r5)  # t21
    np.divide(r2, r5, out_r_3)  # t22


def face_distances_of_three_wheels(a, b, out=None):
    """Distances from the centre to the planes of the faces of the envelope of four wheels of which the last has failed.

        r_1 = 2*sin(a)*sin(b)*cos(a)/sqrt(sin(a)**2*sin(b)**2 + cos(a)**2)
        r_2 = 2*sin(a)*cos(a)*cos(b)/sqrt(sin(a)**2*cos(b)**2 + cos(a)**2)
        r_3 = 2*sin(a)**2*sin(b)*cos(b)/sqrt(sin(a)**2*sin(b)**2 + sin(a)**2*cos(b)**2)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        b: angle of the side edges in the plane OXY, in rad; 0 < b < pi/2

    Returns a tuple:
        r_1: distance of F_1, in units of h_max
        r_2: distance of F_2, in units of h_max
        r_3: distance of F_3, in units of h_max

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 5 ulp over the domain. Tangents of two angles, a root and a quotient are rounded one after the
    other.

    Rests on ignatov2005:T5.1 (sha256 341b8d7fddde). The forms computed are proved equal to those shown (sha256
    6353fe2cdb3b).
    """
    if out is None:
        if type(a) is type(b) is float:
            try:
                return _face_distances_of_three_wheels(a, b, math.sqrt, math.tan, 1.0, 2.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is type(b) is np.ndarray and a.dtype is b.dtype is DOUBLE and a.shape == b.shape:
            if a.size <= SMALL:
                return _face_distances_of_three_wheels(a, b)
            return evaluate_alike(_face_distances_of_three_wheels_block, 8, (0, 1, 2,), (a, b,))
    return evaluate(_face_distances_of_three_wheels_block, 8, (0, 1, 2,), (a, b,), out)


def _face_distances_of_three_wheels(a, b, sqrt=np.sqrt, tan=np.tan, n1=np.array(1.0), n2=np.array(2.0)):
    tan_a = tan(a)
    tan_a_squared = tan_a * tan_a
    tan_b = tan(b)
    tan_b_squared = tan_b * tan_b
    t1 = n1 + tan_b_squared
    t2 = n2 * tan_a
    t3 = t2 * tan_b
    t4 = t1 * t1
    t11 = sqrt(t1 + ((n1 + ((tan_a_squared * tan_b_squared) + (n2 * tan_b_squared))) * tan_a_squared))
    return t3 / t11, t2 / sqrt(t1 + ((n2 + (tan_a_squared + tan_b_squared)) * tan_a_squared)), t3 / sqrt((t4 * tan_a_squared) + t4)


def _face_distances_of_three_wheels_block(a, b, out_r_1, out_r_2, out_r_3, r0, r1, r2, r3, r4, r5, r6, r7):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.tan(b, r2)  # tan_b
    np.multiply(r2, r2, r3)  # tan_b_squared
    np.add(1.0, r3, r4)  # t1
    np.multiply(2.0, r0, r0)  # t2
    np.multiply(r0, r2, r2)  # t3
    np.multiply(r4, r4, r5)  # t4
    np.multiply(r1, r3, r6)  # t5
    np.multiply(2.0, r3, r7)  # t6
    np.add(r6, r7, r7)  # t7
    np.add(1.0, r7, r7)  # t8
    np.multiply(r7, r1, r7)  # t9
    np.add(r4, r7, r7)  # t10
    np.sqrt(r7, r7)  # t11
    np.divide(r2, r7, out_r_1)  # t12
    np.add(r1, r3, r3)  # t13
    np.add(2.0, r3, r3)  # t14
    np.multiply(r3, r1, r3)  # t15
    np.add(r4, r3, r3)  # t16
    np.sqrt(r3, r3)  # t17
    np.divide(r0, r3, out_r_2)  # t18
    np.multiply(r5, r1, r1)  # t19
    np.add(r1, r5, r5)  # t20
    np.sqrt(r5, r5)  # t21
    np.divide(r2, r5, out_r_3)  # t22


def face_distances_of_six_wheels(a, out=None):
    """Distances from the centre to the planes of the faces of the envelope of six wheels.

        r_1 = 6*sqrt(3)*sin(a)*cos(a)/sqrt(3*sin(a)**2 + 4*cos(a)**2)
        r_2 = 8*sin(a)*cos(a)/sqrt(sin(a)**2 + 4*cos(a)**2)
        r_3 = 2*sqrt(3)*sin(a)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2

    Returns a tuple:
        r_1: distance of F_1 to F_6, in units of h_max
        r_2: distance of F_7 to F_12, in units of h_max
        r_3: distance of F_13 to F_15, in units of h_max

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain.

    Rests on ignatov2005:T8.1 (sha256 def2e78861dd), ignatov2005:T8.3 (sha256 d37aa24719f2), ignatov2005:B.28
    (sha256 2c1e1a48f9f3). The forms computed are proved equal to those shown (sha256 a5187b06298a).
    """
    if out is None:
        if type(a) is float:
            try:
                return _face_distances_of_six_wheels(a, math.sqrt, math.tan, 7.0 / 3.0, 4.0 / 3.0, 6.0, 5.0, 4.0, 8.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is np.ndarray and a.dtype is DOUBLE:
            if a.size <= SMALL:
                return _face_distances_of_six_wheels(a)
            return evaluate_alike(_face_distances_of_six_wheels_block, 4, (0, 1, 2,), (a,))
    return evaluate(_face_distances_of_six_wheels_block, 4, (0, 1, 2,), (a,), out)


def _face_distances_of_six_wheels(a, sqrt=np.sqrt, tan=np.tan, n7_3=np.array(7.0 / 3.0), n4_3=np.array(4.0 / 3.0), n6=np.array(6.0), n5=np.array(5.0), n4=np.array(4.0), n8=np.array(8.0)):
    tan_a = tan(a)
    tan_a_squared = tan_a * tan_a
    return (n6 * tan_a) / sqrt(n4_3 + ((n7_3 + tan_a_squared) * tan_a_squared)), (n8 * tan_a) / sqrt(n4 + ((n5 + tan_a_squared) * tan_a_squared)), (n4 * tan_a) / sqrt(n4_3 + (n4_3 * tan_a_squared))


def _face_distances_of_six_wheels_block(a, out_r_1, out_r_2, out_r_3, r0, r1, r2, r3):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.add(7.0 / 3.0, r1, r2)  # t1
    np.multiply(r2, r1, r2)  # t2
    np.add(4.0 / 3.0, r2, r2)  # t3
    np.sqrt(r2, r2)  # t4
    np.multiply(6.0, r0, r3)  # t5
    np.divide(r3, r2, out_r_1)  # t6
    np.add(5.0, r1, r2)  # t7
    np.multiply(r2, r1, r2)  # t8
    np.add(4.0, r2, r2)  # t9
    np.sqrt(r2, r2)  # t10
    np.multiply(8.0, r0, r3)  # t11
    np.divide(r3, r2, out_r_2)  # t12
    np.multiply(4.0 / 3.0, r1, r1)  # t13
    np.add(4.0 / 3.0, r1, r1)  # t14
    np.sqrt(r1, r1)  # t15
    np.multiply(4.0, r0, r0)  # t16
    np.divide(r0, r1, out_r_3)  # t17


def face_distances_of_five_wheels(a, out=None):
    """Distances from the centre to the planes of the faces of the envelope of six wheels of which the last has failed.

        r_1 = 7*sin(a)*cos(a)/sqrt(sin(a)**2 + 4*cos(a)**2)
        r_2 = 5*sqrt(3)*sin(a)*cos(a)/sqrt(3*sin(a)**2 + 4*cos(a)**2)
        r_3 = 4*sqrt(3)*sin(a)*cos(a)/sqrt(3*sin(a)**2 + 4*cos(a)**2)
        r_4 = 6*sin(a)*cos(a)/sqrt(sin(a)**2 + 4*cos(a)**2)
        r_5 = 5*sin(a)*cos(a)/sqrt(sin(a)**2 + 4*cos(a)**2)
        r_6 = 3*sqrt(3)*sin(a)/2

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2

    Returns a tuple:
        r_1: distance of F_1, in units of h_max
        r_2: distance of F_2 and F_5, in units of h_max
        r_3: distance of F_3 and F_4, in units of h_max
        r_4: distance of F_6 and F_8, in units of h_max
        r_5: distance of F_7, in units of h_max
        r_6: distance of F_9 and F_10, in units of h_max

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 6 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain.

    Rests on ignatov2005:T11.1 (sha256 af1c6220d104), ignatov2005:T11.2 (sha256 70822fc7f52b), ignatov2005:T11.3
    (sha256 70df6e595ea0), ignatov2005:T11.4 (sha256 2b574146a964), ignatov2005:T11.5 (sha256 c62d7ee494cb),
    ignatov2005:T11.6 (sha256 78458a0b0ae0). The forms computed are proved equal to those shown (sha256
    ac2c69c4b170).
    """
    if out is None:
        if type(a) is float:
            try:
                return _face_distances_of_five_wheels(a, math.sqrt, math.tan, 5.0, 4.0, 7.0 / 3.0, 4.0 / 3.0, 7.0, 6.0, 3.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is np.ndarray and a.dtype is DOUBLE:
            if a.size <= SMALL:
                return _face_distances_of_five_wheels(a)
            return evaluate_alike(_face_distances_of_five_wheels_block, 4, (0, 1, 2, 3, 4, 5,), (a,))
    return evaluate(_face_distances_of_five_wheels_block, 4, (0, 1, 2, 3, 4, 5,), (a,), out)


def _face_distances_of_five_wheels(a, sqrt=np.sqrt, tan=np.tan, n5=np.array(5.0), n4=np.array(4.0), n7_3=np.array(7.0 / 3.0), n4_3=np.array(4.0 / 3.0), n7=np.array(7.0), n6=np.array(6.0), n3=np.array(3.0)):
    tan_a = tan(a)
    tan_a_squared = tan_a * tan_a
    t5 = tan_a / sqrt(n4 + ((n5 + tan_a_squared) * tan_a_squared))
    t10 = tan_a / sqrt(n4_3 + ((n7_3 + tan_a_squared) * tan_a_squared))
    return n7 * t5, n5 * t10, n4 * t10, n6 * t5, n5 * t5, (n3 * tan_a) / sqrt(n4_3 + (n4_3 * tan_a_squared))


def _face_distances_of_five_wheels_block(a, out_r_1, out_r_2, out_r_3, out_r_4, out_r_5, out_r_6, r0, r1, r2, r3):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.add(5.0, r1, r2)  # t1
    np.multiply(r2, r1, r2)  # t2
    np.add(4.0, r2, r2)  # t3
    np.sqrt(r2, r2)  # t4
    np.divide(r0, r2, r2)  # t5
    np.add(7.0 / 3.0, r1, r3)  # t6
    np.multiply(r3, r1, r3)  # t7
    np.add(4.0 / 3.0, r3, r3)  # t8
    np.sqrt(r3, r3)  # t9
    np.divide(r0, r3, r3)  # t10
    np.multiply(7.0, r2, out_r_1)  # t11
    np.multiply(5.0, r3, out_r_2)  # t12
    np.multiply(4.0, r3, out_r_3)  # t13
    np.multiply(6.0, r2, out_r_4)  # t14
    np.multiply(5.0, r2, out_r_5)  # t15
    np.multiply(4.0 / 3.0, r1, r1)  # t16
    np.add(4.0 / 3.0, r1, r1)  # t17
    np.sqrt(r1, r1)  # t18
    np.multiply(3.0, r0, r0)  # t19
    np.divide(r0, r1, out_r_6)  # t20


def volume_of_four_wheels(a, b, out=None):
    """Volume of the envelope of four wheels.

        volume = 128*sin(a)**2*sin(b)*cos(a)*cos(b)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        b: angle of the side edges in the plane OXY, in rad; 0 < b < pi/2

    Returns:
        volume: volume, in units of h_max^3

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. A product of three or five sines and cosines: rounding a tangent counts twice
    in sin^2 a.

    Rests on ignatov2005:B.3 (sha256 c1425766cefa). The forms computed are proved equal to those shown (sha256
    dedbcbc99d0a).
    """
    if out is None:
        if type(a) is type(b) is float:
            try:
                return _volume_of_four_wheels(a, b, math.sqrt, math.tan, 1.0, 128.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is type(b) is np.ndarray and a.dtype is b.dtype is DOUBLE and a.shape == b.shape:
            if a.size <= SMALL:
                return _volume_of_four_wheels(a, b)
            return evaluate_alike(_volume_of_four_wheels_block, 5, (0,), (a, b,))
    return evaluate(_volume_of_four_wheels_block, 5, (0,), (a, b,), out)


def _volume_of_four_wheels(a, b, sqrt=np.sqrt, tan=np.tan, n1=np.array(1.0), n128=np.array(128.0)):
    tan_a = tan(a)
    tan_b = tan(b)
    t10 = (n128 * (tan_a * tan_b)) / (((n1 / tan_a) + tan_a) * (sqrt(n1 + (tan_a * tan_a)) * (n1 + (tan_b * tan_b))))
    return t10


def _volume_of_four_wheels_block(a, b, out_volume, r0, r1, r2, r3, r4):
    np.tan(a, r0)  # tan_a
    np.tan(b, r1)  # tan_b
    np.multiply(r0, r0, r2)  # tan_a_squared
    np.add(1.0, r2, r2)  # t1
    np.sqrt(r2, r2)  # t2
    np.multiply(r1, r1, r3)  # tan_b_squared
    np.add(1.0, r3, r3)  # t3
    np.divide(1.0, r0, r4)  # t4
    np.add(r4, r0, r4)  # t5
    np.multiply(r0, r1, r1)  # t6
    np.multiply(128.0, r1, r1)  # t7
    np.multiply(r2, r3, r3)  # t8
    np.multiply(r4, r3, r3)  # t9
    np.divide(r1, r3, out_volume)  # t10


def volume_of_three_wheels(a, b, out=None):
    """Volume of the envelope of four wheels of which the last has failed.

        volume = 32*sin(a)**2*sin(b)*cos(a)*cos(b)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        b: angle of the side edges in the plane OXY, in rad; 0 < b < pi/2

    Returns:
        volume: volume, in units of h_max^3

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. A product of three or five sines and cosines: rounding a tangent counts twice
    in sin^2 a.

    Rests on ignatov2005:B.13 (sha256 4db0ac03dd0b). The forms computed are proved equal to those shown (sha256
    682d9b861fe9).
    """
    if out is None:
        if type(a) is type(b) is float:
            try:
                return _volume_of_three_wheels(a, b, math.sqrt, math.tan, 1.0, 32.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is type(b) is np.ndarray and a.dtype is b.dtype is DOUBLE and a.shape == b.shape:
            if a.size <= SMALL:
                return _volume_of_three_wheels(a, b)
            return evaluate_alike(_volume_of_three_wheels_block, 5, (0,), (a, b,))
    return evaluate(_volume_of_three_wheels_block, 5, (0,), (a, b,), out)


def _volume_of_three_wheels(a, b, sqrt=np.sqrt, tan=np.tan, n1=np.array(1.0), n32=np.array(32.0)):
    tan_a = tan(a)
    tan_b = tan(b)
    t10 = (n32 * (tan_a * tan_b)) / (((n1 / tan_a) + tan_a) * (sqrt(n1 + (tan_a * tan_a)) * (n1 + (tan_b * tan_b))))
    return t10


def _volume_of_three_wheels_block(a, b, out_volume, r0, r1, r2, r3, r4):
    np.tan(a, r0)  # tan_a
    np.tan(b, r1)  # tan_b
    np.multiply(r0, r0, r2)  # tan_a_squared
    np.add(1.0, r2, r2)  # t1
    np.sqrt(r2, r2)  # t2
    np.multiply(r1, r1, r3)  # tan_b_squared
    np.add(1.0, r3, r3)  # t3
    np.divide(1.0, r0, r4)  # t4
    np.add(r4, r0, r4)  # t5
    np.multiply(r0, r1, r1)  # t6
    np.multiply(32.0, r1, r1)  # t7
    np.multiply(r2, r3, r3)  # t8
    np.multiply(r4, r3, r3)  # t9
    np.divide(r1, r3, out_volume)  # t10


def volume_of_six_wheels(a, out=None):
    """Volume of the envelope of six wheels.

        volume = 144*sqrt(3)*sin(a)**2*cos(a)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2

    Returns:
        volume: volume, in units of h_max^3

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. A product of three or five sines and cosines: rounding a tangent counts twice
    in sin^2 a.

    Rests on ignatov2005:B.25 (sha256 449ce28fca16). The forms computed are proved equal to those shown (sha256
    1bfd836c36dc).
    """
    if out is None:
        if type(a) is float:
            try:
                return _volume_of_six_wheels(a, math.sqrt, math.tan, 1.0 / 3.0, 1.0, 144.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is np.ndarray and a.dtype is DOUBLE:
            if a.size <= SMALL:
                return _volume_of_six_wheels(a)
            return evaluate_alike(_volume_of_six_wheels_block, 3, (0,), (a,))
    return evaluate(_volume_of_six_wheels_block, 3, (0,), (a,), out)


def _volume_of_six_wheels(a, sqrt=np.sqrt, tan=np.tan, n1_3=np.array(1.0 / 3.0), n1=np.array(1.0), n144=np.array(144.0)):
    tan_a = tan(a)
    return (n144 * tan_a) / (sqrt(n1_3 + (n1_3 * (tan_a * tan_a))) * ((n1 / tan_a) + tan_a))


def _volume_of_six_wheels_block(a, out_volume, r0, r1, r2):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.multiply(1.0 / 3.0, r1, r1)  # t1
    np.add(1.0 / 3.0, r1, r1)  # t2
    np.sqrt(r1, r1)  # t3
    np.divide(1.0, r0, r2)  # t4
    np.add(r2, r0, r2)  # t5
    np.multiply(144.0, r0, r0)  # t6
    np.multiply(r1, r2, r2)  # t7
    np.divide(r0, r2, out_volume)  # t8


def volume_of_five_wheels(a, out=None):
    """Volume of the envelope of six wheels of which the last has failed.

        volume = 72*sqrt(3)*sin(a)**2*cos(a)

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2

    Returns:
        volume: volume, in units of h_max^3

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. A product of three or five sines and cosines: rounding a tangent counts twice
    in sin^2 a.

    Rests on ignatov2005:B.35 (sha256 6fdc33d89a33). The forms computed are proved equal to those shown (sha256
    7aaba26622d6).
    """
    if out is None:
        if type(a) is float:
            try:
                return _volume_of_five_wheels(a, math.sqrt, math.tan, 1.0 / 3.0, 1.0, 72.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is np.ndarray and a.dtype is DOUBLE:
            if a.size <= SMALL:
                return _volume_of_five_wheels(a)
            return evaluate_alike(_volume_of_five_wheels_block, 3, (0,), (a,))
    return evaluate(_volume_of_five_wheels_block, 3, (0,), (a,), out)


def _volume_of_five_wheels(a, sqrt=np.sqrt, tan=np.tan, n1_3=np.array(1.0 / 3.0), n1=np.array(1.0), n72=np.array(72.0)):
    tan_a = tan(a)
    return (n72 * tan_a) / (sqrt(n1_3 + (n1_3 * (tan_a * tan_a))) * ((n1 / tan_a) + tan_a))


def _volume_of_five_wheels_block(a, out_volume, r0, r1, r2):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.multiply(1.0 / 3.0, r1, r1)  # t1
    np.add(1.0 / 3.0, r1, r1)  # t2
    np.sqrt(r1, r1)  # t3
    np.divide(1.0, r0, r2)  # t4
    np.add(r2, r0, r2)  # t5
    np.multiply(72.0, r0, r0)  # t6
    np.multiply(r1, r2, r2)  # t7
    np.divide(r0, r2, out_volume)  # t8


def largest_rates_of_four_wheels(a, b, J_x, J_y, J_z, out=None):
    """Largest angular rates about each axis alone that four wheels can give a body, in absolute value.

        w_x = 4*sin(a)*sin(b)/J_x
        w_y = 4*sin(a)*cos(b)/J_y
        w_z = 4*cos(a)/J_z

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        b: angle of the side edges in the plane OXY, in rad; 0 < b < pi/2
        J_x: moment of inertia about OX, in kg m^2; 0 < J_x
        J_y: moment of inertia about OY, in kg m^2; 0 < J_y
        J_z: moment of inertia about OZ, in kg m^2; 0 < J_z

    Returns a tuple:
        w_x: largest angular rate about OX, in units of h_max/(kg m^2)
        w_y: largest angular rate about OY, in units of h_max/(kg m^2)
        w_z: largest angular rate about OZ, in units of h_max/(kg m^2)

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 6 ulp over the domain. Tangents of two angles, a root and a quotient are rounded one after the
    other.

    Rests on ignatov2005:2.3.2 (sha256 e9ac6a1824d6), ignatov2005:2.3.3 (sha256 076720942c61), ignatov2005:2.3.4
    (sha256 ae2c229f2fc3), ignatov2005:2.3 (sha256 233596362da2).
    """
    if out is None:
        if type(a) is type(b) is type(J_x) is type(J_y) is type(J_z) is float:
            try:
                return _largest_rates_of_four_wheels(a, b, J_x, J_y, J_z, math.cos, math.sin, 4.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is type(b) is type(J_x) is type(J_y) is type(J_z) is np.ndarray and a.dtype is b.dtype is J_x.dtype is J_y.dtype is J_z.dtype is DOUBLE and a.shape == b.shape == J_x.shape == J_y.shape == J_z.shape:
            if a.size <= FEW:
                return _largest_rates_of_four_wheels(a, b, J_x, J_y, J_z)
            return evaluate_alike(_largest_rates_of_four_wheels_block, 5, (0, 1, 2,), (a, b, J_x, J_y, J_z,))
    return evaluate(_largest_rates_of_four_wheels_block, 5, (0, 1, 2,), (a, b, J_x, J_y, J_z,), out)


def _largest_rates_of_four_wheels(a, b, J_x, J_y, J_z, cos=np.cos, sin=np.sin, n4=np.array(4.0)):
    t1 = n4 * sin(a)
    return (sin(b) * t1) / J_x, (cos(b) * t1) / J_y, (n4 * cos(a)) / J_z


def _largest_rates_of_four_wheels_block(a, b, J_x, J_y, J_z, out_w_x, out_w_y, out_w_z, r0, r1, r2, r3, r4):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.add(1.0, r1, r1)  # t1
    np.sqrt(r1, r1)  # t2
    np.multiply(4.0, r0, r0)  # t3
    np.divide(r0, r1, r0)  # t4
    np.tan(b, r2)  # tan_b
    np.multiply(r2, r2, r3)  # tan_b_squared
    np.add(1.0, r3, r3)  # t5
    np.sqrt(r3, r3)  # t6
    np.multiply(r0, r2, r2)  # t7
    np.multiply(J_x, r3, r4)  # t8
    np.divide(r2, r4, out_w_x)  # t9
    np.multiply(J_y, r3, r3)  # t10
    np.divide(r0, r3, out_w_y)  # t11
    np.multiply(J_z, r1, r1)  # t12
    np.divide(4.0, r1, out_w_z)  # t13


def largest_rates_of_six_wheels(a, J_x, J_y, J_z, out=None):
    """Largest angular rates about each axis alone that six wheels can give a body, in absolute value.

        w_x = 2*sqrt(3)*sin(a)/J_x
        w_y = 4*sin(a)/J_y
        w_z = 6*cos(a)/J_z

    Arguments:
        a: angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2
        J_x: moment of inertia about OX, in kg m^2; 0 < J_x
        J_y: moment of inertia about OY, in kg m^2; 0 < J_y
        J_z: moment of inertia about OZ, in kg m^2; 0 < J_z

    Returns a tuple:
        w_x: largest angular rate about OX, in units of h_max/(kg m^2)
        w_y: largest angular rate about OY, in units of h_max/(kg m^2)
        w_z: largest angular rate about OZ, in units of h_max/(kg m^2)

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain.

    Rests on ignatov2005:3.2.26 (sha256 51f1c300400a), ignatov2005:3.2.27 (sha256 1658267d9a6a),
    ignatov2005:3.2.28 (sha256 87f642530ce1), ignatov2005:2.3 (sha256 233596362da2).
    """
    if out is None:
        if type(a) is type(J_x) is type(J_y) is type(J_z) is float:
            try:
                return _largest_rates_of_six_wheels(a, J_x, J_y, J_z, math.cos, math.sin, math.sqrt(3.0), 2.0, 4.0, 6.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(a) is type(J_x) is type(J_y) is type(J_z) is np.ndarray and a.dtype is J_x.dtype is J_y.dtype is J_z.dtype is DOUBLE and a.shape == J_x.shape == J_y.shape == J_z.shape:
            if a.size <= FEW:
                return _largest_rates_of_six_wheels(a, J_x, J_y, J_z)
            return evaluate_alike(_largest_rates_of_six_wheels_block, 4, (0, 1, 2,), (a, J_x, J_y, J_z,))
    return evaluate(_largest_rates_of_six_wheels_block, 4, (0, 1, 2,), (a, J_x, J_y, J_z,), out)


def _largest_rates_of_six_wheels(a, J_x, J_y, J_z, cos=np.cos, sin=np.sin, sqrt_3=np.array(math.sqrt(3.0)), n2=np.array(2.0), n4=np.array(4.0), n6=np.array(6.0)):
    sin_a = sin(a)
    return (n2 * (sin_a * sqrt_3)) / J_x, (n4 * sin_a) / J_y, (n6 * cos(a)) / J_z


def _largest_rates_of_six_wheels_block(a, J_x, J_y, J_z, out_w_x, out_w_y, out_w_z, r0, r1, r2, r3):
    np.tan(a, r0)  # tan_a
    np.multiply(r0, r0, r1)  # tan_a_squared
    np.add(1.0, r1, r1)  # t1
    np.sqrt(r1, r1)  # t2
    np.multiply(math.sqrt(3.0), r0, r2)  # t4
    np.multiply(2.0, r2, r2)  # t5
    np.multiply(J_x, r1, r3)  # t6
    np.divide(r2, r3, out_w_x)  # t7
    np.multiply(4.0, r0, r0)  # t8
    np.multiply(J_y, r1, r3)  # t9
    np.divide(r0, r3, out_w_y)  # t10
    np.multiply(J_z, r1, r1)  # t11
    np.divide(6.0, r1, out_w_z)  # t12


def equal_rates_of_four_wheels(J_x, J_y, J_z, out=None):
    """Angles of four wheels with which the largest angular rates about OX, OY and OZ are equal.

        a = atan(sqrt(J_x**2 + J_y**2)/J_z)
        b = atan(J_x/J_y)
        w = 4/sqrt(J_x**2 + J_y**2 + J_z**2)
        w_any = 2*sqrt(2)/sqrt(J_x**2 + J_y**2 + J_z**2)

    Arguments:
        J_x: moment of inertia about OX, in kg m^2; 0 < J_x
        J_y: moment of inertia about OY, in kg m^2; 0 < J_y
        J_z: moment of inertia about OZ, in kg m^2; 0 < J_z

    Returns a tuple:
        a: angle between the axis of a wheel and OZ, in rad
        b: angle of the side edges in the plane OXY, in rad
        w: largest angular rate about each of the three axes, in units of h_max/(kg m^2)
        w_any: largest angular rate that is had about every axis, whatever its direction, in units of h_max/(kg m^2)

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 4 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain. If the squares of the moments satisfy the triangle inequalities, no angles
    give a greater rate w_any.

    Rests on ignatov2005:B.16 (sha256 390c1dc3e919), ignatov2005:B.17 (sha256 9063349b485c), ignatov2005:B.18
    (sha256 738f33499d8f), ignatov2005:B.19 (sha256 76977367497d).
    """
    if out is None:
        if type(J_x) is type(J_y) is type(J_z) is float:
            try:
                return _equal_rates_of_four_wheels(J_x, J_y, J_z, math.atan, math.sqrt, 1.0, 4.0, math.sqrt(2.0), 2.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(J_x) is type(J_y) is type(J_z) is np.ndarray and J_x.dtype is J_y.dtype is J_z.dtype is DOUBLE and J_x.shape == J_y.shape == J_z.shape:
            if J_x.size <= SMALL:
                return _equal_rates_of_four_wheels(J_x, J_y, J_z)
            return evaluate_alike(_equal_rates_of_four_wheels_block, 2, (0, 1, 2, 3,), (J_x, J_y, J_z,))
    return evaluate(_equal_rates_of_four_wheels_block, 2, (0, 1, 2, 3,), (J_x, J_y, J_z,), out)


def _equal_rates_of_four_wheels(J_x, J_y, J_z, arctan=np.arctan, sqrt=np.sqrt, n1=np.array(1.0), n4=np.array(4.0), sqrt_2=np.array(math.sqrt(2.0)), n2=np.array(2.0)):
    t1 = (J_x * J_x) + (J_y * J_y)
    t4 = n1 / sqrt((J_z * J_z) + t1)
    return arctan(sqrt(t1) / J_z), arctan(J_x / J_y), n4 * t4, n2 * (sqrt_2 * t4)


def _equal_rates_of_four_wheels_block(J_x, J_y, J_z, out_a, out_b, out_w, out_w_any, r0, r1):
    np.multiply(J_x, J_x, r0)  # J_x_squared
    np.multiply(J_y, J_y, r1)  # J_y_squared
    np.add(r0, r1, r1)  # t1
    np.multiply(J_z, J_z, r0)  # J_z_squared
    np.add(r0, r1, r0)  # t2
    np.sqrt(r0, r0)  # t3
    np.divide(1.0, r0, r0)  # t4
    np.sqrt(r1, r1)  # t5
    np.divide(r1, J_z, r1)  # t6
    np.arctan(r1, out_a)  # t7
    np.divide(J_x, J_y, r1)  # t8
    np.arctan(r1, out_b)  # t9
    np.multiply(4.0, r0, out_w)  # t10
    np.multiply(math.sqrt(2.0), r0, r0)  # t11
    np.multiply(2.0, r0, out_w_any)  # t12


def equal_rates_of_six_wheels(J_x, J_y, J_z, out=None):
    """Angle of six wheels with which the largest angular rates about OY and OZ are equal, and the largest rates.

        a = atan(3*J_y/(2*J_z))
        w_x = 6*sqrt(3)*J_y/(J_x*sqrt(9*J_y**2 + 4*J_z**2))
        w_y = 12/sqrt(9*J_y**2 + 4*J_z**2)

    Arguments:
        J_x: moment of inertia about OX, in kg m^2; 0 < J_x
        J_y: moment of inertia about OY, in kg m^2; 0 < J_y
        J_z: moment of inertia about OZ, in kg m^2; 0 < J_z

    Returns a tuple:
        a: angle between the axis of a wheel and OZ, in rad
        w_x: largest angular rate about OX, in units of h_max/(kg m^2)
        w_y: largest angular rate about OY, and about OZ, in units of h_max/(kg m^2)

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 5 ulp over the domain. The square root of 3 is rounded too.

    Rests on ignatov2005:3.2.26 (sha256 51f1c300400a), ignatov2005:3.2.27 (sha256 1658267d9a6a),
    ignatov2005:3.2.28 (sha256 87f642530ce1), ignatov2005:3.2.30 (sha256 254422d7305a).
    """
    if out is None:
        if type(J_x) is type(J_y) is type(J_z) is float:
            try:
                return _equal_rates_of_six_wheels(J_x, J_y, J_z, math.atan, math.sqrt, 9.0, 4.0, 1.0, 3.0 / 2.0, math.sqrt(3.0), 6.0, 12.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(J_x) is type(J_y) is type(J_z) is np.ndarray and J_x.dtype is J_y.dtype is J_z.dtype is DOUBLE and J_x.shape == J_y.shape == J_z.shape:
            if J_x.size <= SMALL:
                return _equal_rates_of_six_wheels(J_x, J_y, J_z)
            return evaluate_alike(_equal_rates_of_six_wheels_block, 2, (0, 1, 2,), (J_x, J_y, J_z,))
    return evaluate(_equal_rates_of_six_wheels_block, 2, (0, 1, 2,), (J_x, J_y, J_z,), out)


def _equal_rates_of_six_wheels(J_x, J_y, J_z, arctan=np.arctan, sqrt=np.sqrt, n9=np.array(9.0), n4=np.array(4.0), n1=np.array(1.0), n3_2=np.array(3.0 / 2.0), sqrt_3=np.array(math.sqrt(3.0)), n6=np.array(6.0), n12=np.array(12.0)):
    t5 = n1 / sqrt((n9 * (J_y * J_y)) + (n4 * (J_z * J_z)))
    return arctan((n3_2 * J_y) / J_z), (n6 * (sqrt_3 * (J_y * t5))) / J_x, n12 * t5


def _equal_rates_of_six_wheels_block(J_x, J_y, J_z, out_a, out_w_x, out_w_y, r0, r1):
    np.multiply(J_y, J_y, r0)  # J_y_squared
    np.multiply(9.0, r0, r0)  # t1
    np.multiply(J_z, J_z, r1)  # J_z_squared
    np.multiply(4.0, r1, r1)  # t2
    np.add(r0, r1, r1)  # t3
    np.sqrt(r1, r1)  # t4
    np.divide(1.0, r1, r1)  # t5
    np.multiply(3.0 / 2.0, J_y, r0)  # t6
    np.divide(r0, J_z, r0)  # t7
    np.arctan(r0, out_a)  # t8
    np.multiply(J_y, r1, r0)  # t9
    np.multiply(math.sqrt(3.0), r0, r0)  # t10
    np.multiply(6.0, r0, r0)  # t11
    np.divide(r0, J_x, out_w_x)  # t12
    np.multiply(12.0, r1, out_w_y)  # t13


def best_angles_of_four_wheels(J_x, J_y, J_z, out=None):
    """Angles of four wheels with the greatest angular rate about every axis, for J_y^2 >= J_x^2 + J_z^2.

        a = atan(sqrt(J_x**2 + J_y*sqrt(J_x**2 + J_z**2))/J_z)
        b = atan(J_x/(sqrt(J_y)*(J_x**2 + J_z**2)**(1/4)))
        w = 4/(J_y + sqrt(J_x**2 + J_z**2))

    Arguments:
        J_x: moment of inertia about OX, in kg m^2; 0 < J_x
        J_y: moment of inertia about OY, in kg m^2; 0 < J_y
        J_z: moment of inertia about OZ, in kg m^2; 0 < J_z

    Returns a tuple:
        a: angle between the axis of a wheel and OZ, in rad
        b: angle of the side edges in the plane OXY, in rad
        w: largest angular rate that is had about every axis, whatever its direction, in units of h_max/(kg m^2)

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain.

    Rests on ignatov2005:B.20 (sha256 1522635daa40), ignatov2005:B.21 (sha256 147f60cbcbe6).
    """
    if out is None:
        if type(J_x) is type(J_y) is type(J_z) is float:
            try:
                return _best_angles_of_four_wheels(J_x, J_y, J_z, math.atan, math.pow, math.sqrt, 1.0 / 4.0, 4.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(J_x) is type(J_y) is type(J_z) is np.ndarray and J_x.dtype is J_y.dtype is J_z.dtype is DOUBLE and J_x.shape == J_y.shape == J_z.shape:
            if J_x.size <= SMALL:
                return _best_angles_of_four_wheels(J_x, J_y, J_z)
            return evaluate_alike(_best_angles_of_four_wheels_block, 4, (0, 1, 2,), (J_x, J_y, J_z,))
    return evaluate(_best_angles_of_four_wheels_block, 4, (0, 1, 2,), (J_x, J_y, J_z,), out)


def _best_angles_of_four_wheels(J_x, J_y, J_z, arctan=np.arctan, power=np.power, sqrt=np.sqrt, n1_4=np.array(1.0 / 4.0), n4=np.array(4.0)):
    J_x_squared = J_x * J_x
    t1 = J_x_squared + (J_z * J_z)
    t2 = sqrt(t1)
    return arctan(sqrt(J_x_squared + (J_y * t2)) / J_z), arctan(J_x / (sqrt(J_y) * power(t1, n1_4))), n4 / (J_y + t2)


def _best_angles_of_four_wheels_block(J_x, J_y, J_z, out_a, out_b, out_w, r0, r1, r2, r3):
    np.multiply(J_x, J_x, r0)  # J_x_squared
    np.multiply(J_z, J_z, r1)  # J_z_squared
    np.add(r0, r1, r1)  # t1
    np.sqrt(r1, r2)  # t2
    np.multiply(J_y, r2, r3)  # t3
    np.add(r0, r3, r3)  # t4
    np.sqrt(r3, r3)  # t5
    np.divide(r3, J_z, r3)  # t6
    np.arctan(r3, out_a)  # t7
    np.power(r1, 1.0 / 4.0, r1)  # t8
    np.sqrt(J_y, r3)  # sqrt_J_y
    np.multiply(r3, r1, r1)  # t9
    np.divide(J_x, r1, r1)  # t10
    np.arctan(r1, out_b)  # t11
    np.add(J_y, r2, r2)  # t12
    np.divide(4.0, r2, out_w)  # t13


def best_angle_of_six_wheels(J_y, J_z, out=None):
    """Angle of six wheels at which the face F_8 of the envelope allows the greatest angular rate about every axis.

        a = atan(sqrt(2)*sqrt(J_y/J_z))
        w = 8/(2*J_y + J_z)

    Arguments:
        J_y: moment of inertia about OY, in kg m^2; 0 < J_y
        J_z: moment of inertia about OZ, in kg m^2; 0 < J_z

    Returns a tuple:
        a: angle between the axis of a wheel and OZ, in rad
        w: largest angular rate that this face allows about every axis, whatever its direction, in units of h_max/(kg m^2)

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 2 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain. The other faces have to allow this rate too; for moments of 1000, 1600 and
    800 kg m^2 they do.

    Rests on ignatov2005:B.38 (sha256 5de80110a130), ignatov2005:B.39 (sha256 1ae8f8ef3d5c), ignatov2005:B.40
    (sha256 369d33522dc2).
    """
    if out is None:
        if type(J_y) is type(J_z) is float:
            try:
                return _best_angle_of_six_wheels(J_y, J_z, math.atan, math.sqrt, math.sqrt(2.0), 2.0, 8.0)
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif type(J_y) is type(J_z) is np.ndarray and J_y.dtype is J_z.dtype is DOUBLE and J_y.shape == J_z.shape:
            if J_y.size <= SMALL:
                return _best_angle_of_six_wheels(J_y, J_z)
            return evaluate_alike(_best_angle_of_six_wheels_block, 1, (0, 1,), (J_y, J_z,))
    return evaluate(_best_angle_of_six_wheels_block, 1, (0, 1,), (J_y, J_z,), out)


def _best_angle_of_six_wheels(J_y, J_z, arctan=np.arctan, sqrt=np.sqrt, sqrt_2=np.array(math.sqrt(2.0)), n2=np.array(2.0), n8=np.array(8.0)):
    return arctan(sqrt_2 * sqrt(J_y / J_z)), n8 / (J_z + (n2 * J_y))


def _best_angle_of_six_wheels_block(J_y, J_z, out_a, out_w, r0):
    np.divide(J_y, J_z, r0)  # t1
    np.sqrt(r0, r0)  # t2
    np.multiply(math.sqrt(2.0), r0, r0)  # t3
    np.arctan(r0, out_a)  # t4
    np.multiply(2.0, J_y, r0)  # t5
    np.add(J_z, r0, r0)  # t6
    np.divide(8.0, r0, out_w)  # t7
