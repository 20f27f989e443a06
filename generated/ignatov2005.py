"""Kernels of ignatov2005. Written by `symcheck generate`: what is changed here is lost."""

import math

from symcheck.generated import _ignatov2005 as paths
from symcheck.kernels.runtime import kernel
from symcheck.kernels.specification import Argument, Output, Specification

__all__ = [
    "axes_of_four_wheels",
    "axes_of_six_wheels",
    "best_angle_of_six_wheels",
    "best_angles_of_four_wheels",
    "equal_rates_of_four_wheels",
    "equal_rates_of_six_wheels",
    "face_distances_of_five_wheels",
    "face_distances_of_four_wheels",
    "face_distances_of_six_wheels",
    "face_distances_of_three_wheels",
    "largest_rates_of_four_wheels",
    "largest_rates_of_six_wheels",
    "momentum_of_five_wheels",
    "momentum_of_four_wheels",
    "momentum_of_six_wheels",
    "momentum_of_three_wheels",
    "rates_of_five_wheels",
    "rates_of_four_wheels",
    "rates_of_six_wheels",
    "rates_of_three_wheels",
    "vertex_distances_of_five_wheels",
    "vertex_distances_of_four_wheels",
    "vertex_distances_of_six_wheels",
    "vertex_distances_of_three_wheels",
    "vertices_of_five_wheels",
    "vertices_of_four_wheels",
    "vertices_of_six_wheels",
    "vertices_of_three_wheels",
    "volume_of_five_wheels",
    "volume_of_four_wheels",
    "volume_of_six_wheels",
    "volume_of_three_wheels",
]


@kernel(
    paths.axes_of_four_wheels,
    Specification(
        paper='ignatov2005',
        name='axes_of_four_wheels',
        says='Unit vectors e_1, e_2, ... along the axes of four wheels, without components that are zero.',
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('b', 'angle of the side edges in the plane OXY', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('e_1x', 'x of e_1'),
            Output('e_1y', 'y of e_1'),
            Output('e_1z', 'z of e_1'),
            Output('e_2x', 'x of e_2'),
            Output('e_2y', 'y of e_2'),
            Output('e_2z', 'z of e_2'),
            Output('e_3x', 'x of e_3'),
            Output('e_3y', 'y of e_3'),
            Output('e_3z', 'z of e_3'),
            Output('e_4x', 'x of e_4'),
            Output('e_4y', 'y of e_4'),
            Output('e_4z', 'z of e_4'),
        ),
        ulp=6,
        condition='Tangents of two angles, a root and a quotient are rounded one after the other.',
        claims={
            'ignatov2005:2.0.1': '4aa675013ce7',
            'ignatov2005:2.0.3': '1c82bd5484cb',
            'ignatov2005:2.0.5': '22085680dfdc',
        },
    ),
)
def axes_of_four_wheels(a, b):
    """Unit vectors e_1, e_2, ... along the axes of four wheels, without components that are zero.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    b : float or ndarray
        Angle of the side edges in the plane OXY, in rad; 0 < b < pi/2.
    out : sequence of ndarray, optional
        12 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    e_1x : float or ndarray
        X of e_1, a number.
    e_1y : float or ndarray
        Y of e_1, a number.
    e_1z : float or ndarray
        Z of e_1, a number.
    e_2x : float or ndarray
        X of e_2, a number.
    e_2y : float or ndarray
        Y of e_2, a number.
    e_2z : float or ndarray
        Z of e_2, a number.
    e_3x : float or ndarray
        X of e_3, a number.
    e_3y : float or ndarray
        Y of e_3, a number.
    e_3z : float or ndarray
        Z of e_3, a number.
    e_4x : float or ndarray
        X of e_4, a number.
    e_4y : float or ndarray
        Y of e_4, a number.
    e_4z : float or ndarray
        Z of e_4, a number.

    Notes
    -----
    The function computes ::

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

    Accuracy: 6 ulp over the domain. Tangents of two angles, a root and a quotient are rounded one after the
    other.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit. Outputs that are
    equal by formula are one array, unless `out` is given.

    Rests on ignatov2005:2.0.1 (sha256 4aa675013ce7), ignatov2005:2.0.3 (sha256 1c82bd5484cb), ignatov2005:2.0.5
    (sha256 22085680dfdc).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import axes_of_four_wheels
    >>> [f"{x:.6g}" for x in axes_of_four_wheels(0.52, 1.05)]
    ['0.431005', '-0.247233', '-0.867819', '0.431005', '0.247233', '-0.867819', '0.431005', '-0.247233', '0.867819', '0.431005', '0.247233', '0.867819']
    """
    sin_a = math.sin(a)
    t1 = sin_a * math.sin(b)
    t2 = math.cos(b) * sin_a
    t3 = -t2
    cos_a = math.cos(a)
    t4 = -cos_a
    return t1, t3, t4, t1, t2, t4, t1, t3, cos_a, t1, t2, cos_a


@kernel(
    paths.axes_of_six_wheels,
    Specification(
        paper='ignatov2005',
        name='axes_of_six_wheels',
        says='Unit vectors e_1, e_2, ... along the axes of six wheels, without components that are zero.',
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('e_1y', 'y of e_1'),
            Output('e_1z', 'z of e_1'),
            Output('e_2x', 'x of e_2'),
            Output('e_2y', 'y of e_2'),
            Output('e_2z', 'z of e_2'),
            Output('e_3x', 'x of e_3'),
            Output('e_3y', 'y of e_3'),
            Output('e_3z', 'z of e_3'),
            Output('e_4y', 'y of e_4'),
            Output('e_4z', 'z of e_4'),
            Output('e_5x', 'x of e_5'),
            Output('e_5y', 'y of e_5'),
            Output('e_5z', 'z of e_5'),
            Output('e_6x', 'x of e_6'),
            Output('e_6y', 'y of e_6'),
            Output('e_6z', 'z of e_6'),
        ),
        ulp=4,
        claims={
            'ignatov2005:3.0.3': '90b688855734',
            'ignatov2005:3.0.5': '881325f58b02',
            'ignatov2005:3.0.6': '55b7b4360f8d',
        },
    ),
)
def axes_of_six_wheels(a):
    """Unit vectors e_1, e_2, ... along the axes of six wheels, without components that are zero.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    out : sequence of ndarray, optional
        16 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    e_1y : float or ndarray
        Y of e_1, a number.
    e_1z : float or ndarray
        Z of e_1, a number.
    e_2x : float or ndarray
        X of e_2, a number.
    e_2y : float or ndarray
        Y of e_2, a number.
    e_2z : float or ndarray
        Z of e_2, a number.
    e_3x : float or ndarray
        X of e_3, a number.
    e_3y : float or ndarray
        Y of e_3, a number.
    e_3z : float or ndarray
        Z of e_3, a number.
    e_4y : float or ndarray
        Y of e_4, a number.
    e_4z : float or ndarray
        Z of e_4, a number.
    e_5x : float or ndarray
        X of e_5, a number.
    e_5y : float or ndarray
        Y of e_5, a number.
    e_5z : float or ndarray
        Z of e_5, a number.
    e_6x : float or ndarray
        X of e_6, a number.
    e_6y : float or ndarray
        Y of e_6, a number.
    e_6z : float or ndarray
        Z of e_6, a number.

    Notes
    -----
    The function computes ::

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

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit. Outputs that are
    equal by formula are one array, unless `out` is given.

    Rests on ignatov2005:3.0.3 (sha256 90b688855734), ignatov2005:3.0.5 (sha256 881325f58b02), ignatov2005:3.0.6
    (sha256 55b7b4360f8d).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import axes_of_six_wheels
    >>> [f"{x:.6g}" for x in axes_of_six_wheels(0.79)]
    ['-0.710353', '0.703845', '0.615184', '-0.355177', '0.703845', '0.615184', '0.355177', '0.703845', '-0.710353', '-0.703845', '0.615184', '-0.355177', '-0.703845', '0.615184', '0.355177', '-0.703845']
    """
    sin_a = math.sin(a)
    t1 = -sin_a
    cos_a = math.cos(a)
    t2 = (1.0 / 2.0) * sin_a
    t3 = math.sqrt(3.0) * t2
    t4 = -t2
    t5 = -cos_a
    return t1, cos_a, t3, t4, cos_a, t3, t2, cos_a, t1, t5, t3, t4, t5, t3, t2, t5


@kernel(
    paths.momentum_of_four_wheels,
    Specification(
        paper='ignatov2005',
        name='momentum_of_four_wheels',
        says='Total momentum of four wheels.',
        arguments=(
            Argument('h_1', 'momentum of wheel 1', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_2', 'momentum of wheel 2', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_3', 'momentum of wheel 3', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_4', 'momentum of wheel 4', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('b', 'angle of the side edges in the plane OXY', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('H_x', 'momentum along OX', unit='units of h_max'),
            Output('H_y', 'momentum along OY', unit='units of h_max'),
            Output('H_z', 'momentum along OZ', unit='units of h_max'),
        ),
        ulp=8,
        condition='Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i.',
        claims={
            'ignatov2005:2.1.2': '6aba2017cbeb',
        },
    ),
)
def momentum_of_four_wheels(h_1, h_2, h_3, h_4, a, b):
    """Total momentum of four wheels.

    Parameters
    ----------
    h_1 : float or ndarray
        Momentum of wheel 1, in units of h_max; -1 <= h_1 <= 1.
    h_2 : float or ndarray
        Momentum of wheel 2, in units of h_max; -1 <= h_2 <= 1.
    h_3 : float or ndarray
        Momentum of wheel 3, in units of h_max; -1 <= h_3 <= 1.
    h_4 : float or ndarray
        Momentum of wheel 4, in units of h_max; -1 <= h_4 <= 1.
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    b : float or ndarray
        Angle of the side edges in the plane OXY, in rad; 0 < b < pi/2.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    H_x : float or ndarray
        Momentum along OX, in units of h_max.
    H_y : float or ndarray
        Momentum along OY, in units of h_max.
    H_z : float or ndarray
        Momentum along OZ, in units of h_max.

    Notes
    -----
    The function computes ::

        H_x = (h_1 + h_2 + h_3 + h_4)*sin(a)*sin(b)
        H_y = (-h_1 + h_2 - h_3 + h_4)*sin(a)*cos(b)
        H_z = (-h_1 - h_2 + h_3 + h_4)*cos(a)

    Accuracy: 8 ulp over the domain. Momenta of wheels may cancel: counted in units of the last place of the
    largest h_i e_i.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:2.1.2 (sha256 6aba2017cbeb).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import momentum_of_four_wheels
    >>> [f"{x:.6g}" for x in momentum_of_four_wheels(-0.71, -0.43, -0.14, 0.14, 1.12, 1.35)]
    ['-1.0012', '0.110392', '0.496678']
    """
    sin_a = math.sin(a)
    t1 = h_1 + h_3
    t2 = -h_4
    return math.sin(b) * (sin_a * (t1 + (h_2 + h_4))), math.cos(b) * (sin_a * (h_2 - t1 - t2)), math.cos(a) * (h_3 - h_1 - h_2 - t2)


@kernel(
    paths.momentum_of_three_wheels,
    Specification(
        paper='ignatov2005',
        name='momentum_of_three_wheels',
        says='Total momentum of four wheels of which the last has failed.',
        arguments=(
            Argument('h_1', 'momentum of wheel 1', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_2', 'momentum of wheel 2', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_3', 'momentum of wheel 3', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('b', 'angle of the side edges in the plane OXY', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('H_x', 'momentum along OX', unit='units of h_max'),
            Output('H_y', 'momentum along OY', unit='units of h_max'),
            Output('H_z', 'momentum along OZ', unit='units of h_max'),
        ),
        ulp=8,
        condition='Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i.',
        claims={
            'ignatov2005:2.2.1': 'a4e05c48da78',
        },
    ),
)
def momentum_of_three_wheels(h_1, h_2, h_3, a, b):
    """Total momentum of four wheels of which the last has failed.

    Parameters
    ----------
    h_1 : float or ndarray
        Momentum of wheel 1, in units of h_max; -1 <= h_1 <= 1.
    h_2 : float or ndarray
        Momentum of wheel 2, in units of h_max; -1 <= h_2 <= 1.
    h_3 : float or ndarray
        Momentum of wheel 3, in units of h_max; -1 <= h_3 <= 1.
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    b : float or ndarray
        Angle of the side edges in the plane OXY, in rad; 0 < b < pi/2.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    H_x : float or ndarray
        Momentum along OX, in units of h_max.
    H_y : float or ndarray
        Momentum along OY, in units of h_max.
    H_z : float or ndarray
        Momentum along OZ, in units of h_max.

    Notes
    -----
    The function computes ::

        H_x = (h_1 + h_2 + h_3)*sin(a)*sin(b)
        H_y = (-h_1 + h_2 - h_3)*sin(a)*cos(b)
        H_z = (-h_1 - h_2 + h_3)*cos(a)

    Accuracy: 8 ulp over the domain. Momenta of wheels may cancel: counted in units of the last place of the
    largest h_i e_i.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:2.2.1 (sha256 a4e05c48da78).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import momentum_of_three_wheels
    >>> [f"{x:.6g}" for x in momentum_of_three_wheels(-0.67, -0.33, 0.0, 1.05, 1.31)]
    ['-0.838091', '0.0760461', '0.497571']
    """
    sin_a = math.sin(a)
    t1 = h_1 + h_3
    return math.sin(b) * (sin_a * (h_2 + t1)), math.cos(b) * (sin_a * (h_2 - t1)), math.cos(a) * (h_3 - h_1 - h_2)


@kernel(
    paths.momentum_of_six_wheels,
    Specification(
        paper='ignatov2005',
        name='momentum_of_six_wheels',
        says='Total momentum of six wheels.',
        arguments=(
            Argument('h_1', 'momentum of wheel 1', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_2', 'momentum of wheel 2', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_3', 'momentum of wheel 3', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_4', 'momentum of wheel 4', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_5', 'momentum of wheel 5', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_6', 'momentum of wheel 6', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('H_x', 'momentum along OX', unit='units of h_max'),
            Output('H_y', 'momentum along OY', unit='units of h_max'),
            Output('H_z', 'momentum along OZ', unit='units of h_max'),
        ),
        ulp=8,
        condition='Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i.',
        claims={
            'ignatov2005:3.1.2': '8758872a0c67',
        },
    ),
)
def momentum_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a):
    """Total momentum of six wheels.

    Parameters
    ----------
    h_1 : float or ndarray
        Momentum of wheel 1, in units of h_max; -1 <= h_1 <= 1.
    h_2 : float or ndarray
        Momentum of wheel 2, in units of h_max; -1 <= h_2 <= 1.
    h_3 : float or ndarray
        Momentum of wheel 3, in units of h_max; -1 <= h_3 <= 1.
    h_4 : float or ndarray
        Momentum of wheel 4, in units of h_max; -1 <= h_4 <= 1.
    h_5 : float or ndarray
        Momentum of wheel 5, in units of h_max; -1 <= h_5 <= 1.
    h_6 : float or ndarray
        Momentum of wheel 6, in units of h_max; -1 <= h_6 <= 1.
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    H_x : float or ndarray
        Momentum along OX, in units of h_max.
    H_y : float or ndarray
        Momentum along OY, in units of h_max.
    H_z : float or ndarray
        Momentum along OZ, in units of h_max.

    Notes
    -----
    The function computes ::

        H_x = sqrt(3)*(h_2 + h_3 + h_5 + h_6)*sin(a)/2
        H_y = (-2*h_1 - h_2 + h_3 - 2*h_4 - h_5 + h_6)*sin(a)/2
        H_z = (h_1 + h_2 + h_3 - h_4 - h_5 - h_6)*cos(a)

    Accuracy: 8 ulp over the domain. Momenta of wheels may cancel: counted in units of the last place of the
    largest h_i e_i.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:3.1.2 (sha256 8758872a0c67).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import momentum_of_six_wheels
    >>> [f"{x:.6g}" for x in momentum_of_six_wheels(-0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 1.37)]
    ['0', '0.979908', '-0.448762']
    """
    t1 = h_2 + h_5
    t2 = (1.0 / 2.0) * math.sin(a)
    t3 = -h_6
    return (t1 + (h_3 + h_6)) * (math.sqrt(3.0) * t2), (h_3 - 2.0 * h_1 - 2.0 * h_4 - t1 - t3) * t2, math.cos(a) * (h_3 + (h_1 + h_2) + t3 - h_4 - h_5)


@kernel(
    paths.momentum_of_five_wheels,
    Specification(
        paper='ignatov2005',
        name='momentum_of_five_wheels',
        says='Total momentum of six wheels of which the last has failed.',
        arguments=(
            Argument('h_1', 'momentum of wheel 1', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_2', 'momentum of wheel 2', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_3', 'momentum of wheel 3', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_4', 'momentum of wheel 4', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_5', 'momentum of wheel 5', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('H_x', 'momentum along OX', unit='units of h_max'),
            Output('H_y', 'momentum along OY', unit='units of h_max'),
            Output('H_z', 'momentum along OZ', unit='units of h_max'),
        ),
        ulp=8,
        condition='Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i.',
        claims={
            'ignatov2005:3.2.1': 'd524ffea3256',
        },
    ),
)
def momentum_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a):
    """Total momentum of six wheels of which the last has failed.

    Parameters
    ----------
    h_1 : float or ndarray
        Momentum of wheel 1, in units of h_max; -1 <= h_1 <= 1.
    h_2 : float or ndarray
        Momentum of wheel 2, in units of h_max; -1 <= h_2 <= 1.
    h_3 : float or ndarray
        Momentum of wheel 3, in units of h_max; -1 <= h_3 <= 1.
    h_4 : float or ndarray
        Momentum of wheel 4, in units of h_max; -1 <= h_4 <= 1.
    h_5 : float or ndarray
        Momentum of wheel 5, in units of h_max; -1 <= h_5 <= 1.
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    H_x : float or ndarray
        Momentum along OX, in units of h_max.
    H_y : float or ndarray
        Momentum along OY, in units of h_max.
    H_z : float or ndarray
        Momentum along OZ, in units of h_max.

    Notes
    -----
    The function computes ::

        H_x = sqrt(3)*(h_2 + h_3 + h_5)*sin(a)/2
        H_y = (-2*h_1 - h_2 + h_3 - 2*h_4 - h_5)*sin(a)/2
        H_z = (h_1 + h_2 + h_3 - h_4 - h_5)*cos(a)

    Accuracy: 8 ulp over the domain. Momenta of wheels may cancel: counted in units of the last place of the
    largest h_i e_i.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:3.2.1 (sha256 d524ffea3256).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import momentum_of_five_wheels
    >>> [f"{x:.6g}" for x in momentum_of_five_wheels(-0.71, -0.43, -0.14, 0.14, 0.43, 1.35)]
    ['-0.1183', '0.487862', '-0.405162']
    """
    t1 = h_2 + h_5
    t2 = (1.0 / 2.0) * math.sin(a)
    return (h_3 + t1) * (math.sqrt(3.0) * t2), (h_3 - 2.0 * h_1 - 2.0 * h_4 - t1) * t2, math.cos(a) * (h_3 + (h_1 + h_2) - h_4 - h_5)


@kernel(
    paths.rates_of_four_wheels,
    Specification(
        paper='ignatov2005',
        name='rates_of_four_wheels',
        says='Angular rates of a body, at rest with its wheels at rest, that four wheels give it.',
        arguments=(
            Argument('h_1', 'momentum of wheel 1', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_2', 'momentum of wheel 2', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_3', 'momentum of wheel 3', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_4', 'momentum of wheel 4', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('b', 'angle of the side edges in the plane OXY', unit='rad', low='0', high='pi/2'),
            Argument('J_x', 'moment of inertia about OX', unit='kg m^2', low='0'),
            Argument('J_y', 'moment of inertia about OY', unit='kg m^2', low='0'),
            Argument('J_z', 'moment of inertia about OZ', unit='kg m^2', low='0'),
        ),
        outputs=(
            Output('w_x', 'angular rate about OX', unit='units of h_max/(kg m^2)'),
            Output('w_y', 'angular rate about OY', unit='units of h_max/(kg m^2)'),
            Output('w_z', 'angular rate about OZ', unit='units of h_max/(kg m^2)'),
        ),
        ulp=8,
        condition='Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i.',
        claims={
            'ignatov2005:2.1.2': '6aba2017cbeb',
            'ignatov2005:2.3': '57003d67dcfa',
        },
    ),
)
def rates_of_four_wheels(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z):
    """Angular rates of a body, at rest with its wheels at rest, that four wheels give it.

    Parameters
    ----------
    h_1 : float or ndarray
        Momentum of wheel 1, in units of h_max; -1 <= h_1 <= 1.
    h_2 : float or ndarray
        Momentum of wheel 2, in units of h_max; -1 <= h_2 <= 1.
    h_3 : float or ndarray
        Momentum of wheel 3, in units of h_max; -1 <= h_3 <= 1.
    h_4 : float or ndarray
        Momentum of wheel 4, in units of h_max; -1 <= h_4 <= 1.
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    b : float or ndarray
        Angle of the side edges in the plane OXY, in rad; 0 < b < pi/2.
    J_x : float or ndarray
        Moment of inertia about OX, in kg m^2; 0 < J_x.
    J_y : float or ndarray
        Moment of inertia about OY, in kg m^2; 0 < J_y.
    J_z : float or ndarray
        Moment of inertia about OZ, in kg m^2; 0 < J_z.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    w_x : float or ndarray
        Angular rate about OX, in units of h_max/(kg m^2).
    w_y : float or ndarray
        Angular rate about OY, in units of h_max/(kg m^2).
    w_z : float or ndarray
        Angular rate about OZ, in units of h_max/(kg m^2).

    Notes
    -----
    The function computes ::

        w_x = -(h_1 + h_2 + h_3 + h_4)*sin(a)*sin(b)/J_x
        w_y = -(-h_1 + h_2 - h_3 + h_4)*sin(a)*cos(b)/J_y
        w_z = -(-h_1 - h_2 + h_3 + h_4)*cos(a)/J_z

    Accuracy: 8 ulp over the domain. Momenta of wheels may cancel: counted in units of the last place of the
    largest h_i e_i.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:2.1.2 (sha256 6aba2017cbeb), ignatov2005:2.3 (sha256 57003d67dcfa).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import rates_of_four_wheels
    >>> [f"{x:.6g}" for x in rates_of_four_wheels(-0.8, -0.6, -0.4, -0.2, 0.79, 0.94, 0.7, 0.8, 0.9)]
    ['1.639', '-0.209479', '-0.62564']
    """
    sin_a = math.sin(a)
    t1 = h_1 + h_3
    t2 = -h_4
    return -(math.sin(b) * (sin_a * (t1 + (h_2 + h_4))) / J_x), -(math.cos(b) * (sin_a * (h_2 - t1 - t2)) / J_y), -(math.cos(a) * (h_3 - h_1 - h_2 - t2) / J_z)


@kernel(
    paths.rates_of_three_wheels,
    Specification(
        paper='ignatov2005',
        name='rates_of_three_wheels',
        says='Angular rates of a body, at rest with its wheels at rest, that four wheels of which the last has failed give it.',
        arguments=(
            Argument('h_1', 'momentum of wheel 1', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_2', 'momentum of wheel 2', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_3', 'momentum of wheel 3', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('b', 'angle of the side edges in the plane OXY', unit='rad', low='0', high='pi/2'),
            Argument('J_x', 'moment of inertia about OX', unit='kg m^2', low='0'),
            Argument('J_y', 'moment of inertia about OY', unit='kg m^2', low='0'),
            Argument('J_z', 'moment of inertia about OZ', unit='kg m^2', low='0'),
        ),
        outputs=(
            Output('w_x', 'angular rate about OX', unit='units of h_max/(kg m^2)'),
            Output('w_y', 'angular rate about OY', unit='units of h_max/(kg m^2)'),
            Output('w_z', 'angular rate about OZ', unit='units of h_max/(kg m^2)'),
        ),
        ulp=8,
        condition='Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i.',
        claims={
            'ignatov2005:2.2.1': 'a4e05c48da78',
            'ignatov2005:2.3': '57003d67dcfa',
        },
    ),
)
def rates_of_three_wheels(h_1, h_2, h_3, a, b, J_x, J_y, J_z):
    """Angular rates of a body, at rest with its wheels at rest, that four wheels of which the last has failed give it.

    Parameters
    ----------
    h_1 : float or ndarray
        Momentum of wheel 1, in units of h_max; -1 <= h_1 <= 1.
    h_2 : float or ndarray
        Momentum of wheel 2, in units of h_max; -1 <= h_2 <= 1.
    h_3 : float or ndarray
        Momentum of wheel 3, in units of h_max; -1 <= h_3 <= 1.
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    b : float or ndarray
        Angle of the side edges in the plane OXY, in rad; 0 < b < pi/2.
    J_x : float or ndarray
        Moment of inertia about OX, in kg m^2; 0 < J_x.
    J_y : float or ndarray
        Moment of inertia about OY, in kg m^2; 0 < J_y.
    J_z : float or ndarray
        Moment of inertia about OZ, in kg m^2; 0 < J_z.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    w_x : float or ndarray
        Angular rate about OX, in units of h_max/(kg m^2).
    w_y : float or ndarray
        Angular rate about OY, in units of h_max/(kg m^2).
    w_z : float or ndarray
        Angular rate about OZ, in units of h_max/(kg m^2).

    Notes
    -----
    The function computes ::

        w_x = -(h_1 + h_2 + h_3)*sin(a)*sin(b)/J_x
        w_y = -(-h_1 + h_2 - h_3)*sin(a)*cos(b)/J_y
        w_z = -(-h_1 - h_2 + h_3)*cos(a)/J_z

    Accuracy: 8 ulp over the domain. Momenta of wheels may cancel: counted in units of the last place of the
    largest h_i e_i.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:2.2.1 (sha256 a4e05c48da78), ignatov2005:2.3 (sha256 57003d67dcfa).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import rates_of_three_wheels
    >>> [f"{x:.6g}" for x in rates_of_three_wheels(-0.78, -0.56, -0.33, 0.7, 0.87, 0.67, 0.78, 0.89)]
    ['1.22731', '-0.292916', '-0.867967']
    """
    sin_a = math.sin(a)
    t1 = h_1 + h_3
    return -(math.sin(b) * (sin_a * (h_2 + t1)) / J_x), -(math.cos(b) * (sin_a * (h_2 - t1)) / J_y), -(math.cos(a) * (h_3 - h_1 - h_2) / J_z)


@kernel(
    paths.rates_of_six_wheels,
    Specification(
        paper='ignatov2005',
        name='rates_of_six_wheels',
        says='Angular rates of a body, at rest with its wheels at rest, that six wheels give it.',
        arguments=(
            Argument('h_1', 'momentum of wheel 1', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_2', 'momentum of wheel 2', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_3', 'momentum of wheel 3', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_4', 'momentum of wheel 4', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_5', 'momentum of wheel 5', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_6', 'momentum of wheel 6', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('J_x', 'moment of inertia about OX', unit='kg m^2', low='0'),
            Argument('J_y', 'moment of inertia about OY', unit='kg m^2', low='0'),
            Argument('J_z', 'moment of inertia about OZ', unit='kg m^2', low='0'),
        ),
        outputs=(
            Output('w_x', 'angular rate about OX', unit='units of h_max/(kg m^2)'),
            Output('w_y', 'angular rate about OY', unit='units of h_max/(kg m^2)'),
            Output('w_z', 'angular rate about OZ', unit='units of h_max/(kg m^2)'),
        ),
        ulp=8,
        condition='Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i.',
        claims={
            'ignatov2005:3.1.2': '8758872a0c67',
            'ignatov2005:2.3': '57003d67dcfa',
        },
    ),
)
def rates_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z):
    """Angular rates of a body, at rest with its wheels at rest, that six wheels give it.

    Parameters
    ----------
    h_1 : float or ndarray
        Momentum of wheel 1, in units of h_max; -1 <= h_1 <= 1.
    h_2 : float or ndarray
        Momentum of wheel 2, in units of h_max; -1 <= h_2 <= 1.
    h_3 : float or ndarray
        Momentum of wheel 3, in units of h_max; -1 <= h_3 <= 1.
    h_4 : float or ndarray
        Momentum of wheel 4, in units of h_max; -1 <= h_4 <= 1.
    h_5 : float or ndarray
        Momentum of wheel 5, in units of h_max; -1 <= h_5 <= 1.
    h_6 : float or ndarray
        Momentum of wheel 6, in units of h_max; -1 <= h_6 <= 1.
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    J_x : float or ndarray
        Moment of inertia about OX, in kg m^2; 0 < J_x.
    J_y : float or ndarray
        Moment of inertia about OY, in kg m^2; 0 < J_y.
    J_z : float or ndarray
        Moment of inertia about OZ, in kg m^2; 0 < J_z.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    w_x : float or ndarray
        Angular rate about OX, in units of h_max/(kg m^2).
    w_y : float or ndarray
        Angular rate about OY, in units of h_max/(kg m^2).
    w_z : float or ndarray
        Angular rate about OZ, in units of h_max/(kg m^2).

    Notes
    -----
    The function computes ::

        w_x = -sqrt(3)*(h_2 + h_3 + h_5 + h_6)*sin(a)/(2*J_x)
        w_y = -(-2*h_1 - h_2 + h_3 - 2*h_4 - h_5 + h_6)*sin(a)/(2*J_y)
        w_z = -(h_1 + h_2 + h_3 - h_4 - h_5 - h_6)*cos(a)/J_z

    Accuracy: 8 ulp over the domain. Momenta of wheels may cancel: counted in units of the last place of the
    largest h_i e_i.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:3.1.2 (sha256 8758872a0c67), ignatov2005:2.3 (sha256 57003d67dcfa).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import rates_of_six_wheels
    >>> [f"{x:.6g}" for x in rates_of_six_wheels(-0.82, -0.64, -0.45, -0.27, -0.09, 0.09, 1.0, 0.73, 0.82, 0.91)]
    ['1.08811', '-1.30838', '0.973732']
    """
    t1 = h_2 + h_5
    t2 = (1.0 / 2.0) * math.sin(a)
    t3 = -h_6
    return -((t1 + (h_3 + h_6)) * (math.sqrt(3.0) * t2) / J_x), -((h_3 - 2.0 * h_1 - 2.0 * h_4 - t1 - t3) * t2 / J_y), -(math.cos(a) * (h_3 + (h_1 + h_2) + t3 - h_4 - h_5) / J_z)


@kernel(
    paths.rates_of_five_wheels,
    Specification(
        paper='ignatov2005',
        name='rates_of_five_wheels',
        says='Angular rates of a body, at rest with its wheels at rest, that six wheels of which the last has failed give it.',
        arguments=(
            Argument('h_1', 'momentum of wheel 1', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_2', 'momentum of wheel 2', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_3', 'momentum of wheel 3', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_4', 'momentum of wheel 4', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('h_5', 'momentum of wheel 5', unit='units of h_max', low='-1', high='1', closed=True),
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('J_x', 'moment of inertia about OX', unit='kg m^2', low='0'),
            Argument('J_y', 'moment of inertia about OY', unit='kg m^2', low='0'),
            Argument('J_z', 'moment of inertia about OZ', unit='kg m^2', low='0'),
        ),
        outputs=(
            Output('w_x', 'angular rate about OX', unit='units of h_max/(kg m^2)'),
            Output('w_y', 'angular rate about OY', unit='units of h_max/(kg m^2)'),
            Output('w_z', 'angular rate about OZ', unit='units of h_max/(kg m^2)'),
        ),
        ulp=8,
        condition='Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i.',
        claims={
            'ignatov2005:3.2.1': 'd524ffea3256',
            'ignatov2005:2.3': '57003d67dcfa',
        },
    ),
)
def rates_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z):
    """Angular rates of a body, at rest with its wheels at rest, that six wheels of which the last has failed give it.

    Parameters
    ----------
    h_1 : float or ndarray
        Momentum of wheel 1, in units of h_max; -1 <= h_1 <= 1.
    h_2 : float or ndarray
        Momentum of wheel 2, in units of h_max; -1 <= h_2 <= 1.
    h_3 : float or ndarray
        Momentum of wheel 3, in units of h_max; -1 <= h_3 <= 1.
    h_4 : float or ndarray
        Momentum of wheel 4, in units of h_max; -1 <= h_4 <= 1.
    h_5 : float or ndarray
        Momentum of wheel 5, in units of h_max; -1 <= h_5 <= 1.
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    J_x : float or ndarray
        Moment of inertia about OX, in kg m^2; 0 < J_x.
    J_y : float or ndarray
        Moment of inertia about OY, in kg m^2; 0 < J_y.
    J_z : float or ndarray
        Moment of inertia about OZ, in kg m^2; 0 < J_z.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    w_x : float or ndarray
        Angular rate about OX, in units of h_max/(kg m^2).
    w_y : float or ndarray
        Angular rate about OY, in units of h_max/(kg m^2).
    w_z : float or ndarray
        Angular rate about OZ, in units of h_max/(kg m^2).

    Notes
    -----
    The function computes ::

        w_x = -sqrt(3)*(h_2 + h_3 + h_5)*sin(a)/(2*J_x)
        w_y = -(-2*h_1 - h_2 + h_3 - 2*h_4 - h_5)*sin(a)/(2*J_y)
        w_z = -(h_1 + h_2 + h_3 - h_4 - h_5)*cos(a)/J_z

    Accuracy: 8 ulp over the domain. Momenta of wheels may cancel: counted in units of the last place of the
    largest h_i e_i.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:3.2.1 (sha256 d524ffea3256), ignatov2005:2.3 (sha256 57003d67dcfa).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import rates_of_five_wheels
    >>> [f"{x:.6g}" for x in rates_of_five_wheels(-0.8, -0.6, -0.4, -0.2, 0.0, 0.94, 0.7, 0.8, 0.9)]
    ['0.999094', '-1.11039', '1.04851']
    """
    t1 = h_2 + h_5
    t2 = (1.0 / 2.0) * math.sin(a)
    return -((h_3 + t1) * (math.sqrt(3.0) * t2) / J_x), -((h_3 - 2.0 * h_1 - 2.0 * h_4 - t1) * t2 / J_y), -(math.cos(a) * (h_3 + (h_1 + h_2) - h_4 - h_5) / J_z)


@kernel(
    paths.vertices_of_four_wheels,
    Specification(
        paper='ignatov2005',
        name='vertices_of_four_wheels',
        says="Vertices V_i = -V'_i of the envelope of four wheels, without components that are zero.",
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('b', 'angle of the side edges in the plane OXY', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('V_1x', 'x of V_1', unit='units of h_max'),
            Output('V_2x', 'x of V_2', unit='units of h_max'),
            Output('V_2y', 'y of V_2', unit='units of h_max'),
            Output('V_2z', 'z of V_2', unit='units of h_max'),
            Output('V_3x', 'x of V_3', unit='units of h_max'),
            Output('V_3y', 'y of V_3', unit='units of h_max'),
            Output('V_3z', 'z of V_3', unit='units of h_max'),
            Output('V_4x', 'x of V_4', unit='units of h_max'),
            Output('V_4y', 'y of V_4', unit='units of h_max'),
            Output('V_4z', 'z of V_4', unit='units of h_max'),
            Output('V_5x', 'x of V_5', unit='units of h_max'),
            Output('V_5y', 'y of V_5', unit='units of h_max'),
            Output('V_5z', 'z of V_5', unit='units of h_max'),
            Output('V_6y', 'y of V_6', unit='units of h_max'),
            Output('V_7z', 'z of V_7', unit='units of h_max'),
        ),
        ulp=6,
        condition='Tangents of two angles, a root and a quotient are rounded one after the other.',
        claims={
            'ignatov2005:2.1V.1a': 'e5b9794d6eff',
            'ignatov2005:2.1V.2a': 'a0f1e3a325ab',
            'ignatov2005:2.1V.3a': 'f8ec71b5b1e5',
            'ignatov2005:2.1V.4a': '772691a3262a',
            'ignatov2005:2.1V.5a': '5e218eab1ed2',
            'ignatov2005:2.1V.6a': 'e3990d37b113',
            'ignatov2005:2.1V.7a': '6699fc74aac7',
        },
    ),
)
def vertices_of_four_wheels(a, b):
    """Vertices V_i = -V'_i of the envelope of four wheels, without components that are zero.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    b : float or ndarray
        Angle of the side edges in the plane OXY, in rad; 0 < b < pi/2.
    out : sequence of ndarray, optional
        15 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    V_1x : float or ndarray
        X of V_1, in units of h_max.
    V_2x : float or ndarray
        X of V_2, in units of h_max.
    V_2y : float or ndarray
        Y of V_2, in units of h_max.
    V_2z : float or ndarray
        Z of V_2, in units of h_max.
    V_3x : float or ndarray
        X of V_3, in units of h_max.
    V_3y : float or ndarray
        Y of V_3, in units of h_max.
    V_3z : float or ndarray
        Z of V_3, in units of h_max.
    V_4x : float or ndarray
        X of V_4, in units of h_max.
    V_4y : float or ndarray
        Y of V_4, in units of h_max.
    V_4z : float or ndarray
        Z of V_4, in units of h_max.
    V_5x : float or ndarray
        X of V_5, in units of h_max.
    V_5y : float or ndarray
        Y of V_5, in units of h_max.
    V_5z : float or ndarray
        Z of V_5, in units of h_max.
    V_6y : float or ndarray
        Y of V_6, in units of h_max.
    V_7z : float or ndarray
        Z of V_7, in units of h_max.

    Notes
    -----
    The function computes ::

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

    Accuracy: 6 ulp over the domain. Tangents of two angles, a root and a quotient are rounded one after the
    other.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit. Outputs that are
    equal by formula are one array, unless `out` is given.

    Rests on ignatov2005:2.1V.1a (sha256 e5b9794d6eff), ignatov2005:2.1V.2a (sha256 a0f1e3a325ab),
    ignatov2005:2.1V.3a (sha256 f8ec71b5b1e5), ignatov2005:2.1V.4a (sha256 772691a3262a), ignatov2005:2.1V.5a
    (sha256 5e218eab1ed2), ignatov2005:2.1V.6a (sha256 e3990d37b113), ignatov2005:2.1V.7a (sha256 6699fc74aac7).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import vertices_of_four_wheels
    >>> [f"{x:.6g}" for x in vertices_of_four_wheels(0.52, 1.05)]
    ['1.72402', '0.862011', '0.494466', '1.73564', '0.862011', '-0.494466', '1.73564', '0.862011', '0.494466', '-1.73564', '0.862011', '-0.494466', '-1.73564', '-0.988933', '-3.47128']
    """
    sin_a = math.sin(a)
    t1 = sin_a * math.sin(b)
    t2 = 2.0 * t1
    t3 = math.cos(b) * sin_a
    t4 = 2.0 * t3
    cos_a = math.cos(a)
    t5 = 2.0 * cos_a
    t6 = -t4
    t7 = -t5
    return 4.0 * t1, t2, t4, t5, t2, t6, t5, t2, t4, t7, t2, t6, t7, -(4.0 * t3), -(4.0 * cos_a)


@kernel(
    paths.vertices_of_three_wheels,
    Specification(
        paper='ignatov2005',
        name='vertices_of_three_wheels',
        says="Vertices V_i = -V'_i of the envelope of four wheels of which the last has failed, without components that are zero.",
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('b', 'angle of the side edges in the plane OXY', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('V_1x', 'x of V_1', unit='units of h_max'),
            Output('V_1y', 'y of V_1', unit='units of h_max'),
            Output('V_1z', 'z of V_1', unit='units of h_max'),
            Output('V_2x', 'x of V_2', unit='units of h_max'),
            Output('V_2y', 'y of V_2', unit='units of h_max'),
            Output('V_2z', 'z of V_2', unit='units of h_max'),
            Output('V_3x', 'x of V_3', unit='units of h_max'),
            Output('V_3y', 'y of V_3', unit='units of h_max'),
            Output('V_3z', 'z of V_3', unit='units of h_max'),
            Output('V_4x', 'x of V_4', unit='units of h_max'),
            Output('V_4y', 'y of V_4', unit='units of h_max'),
            Output('V_4z', 'z of V_4', unit='units of h_max'),
        ),
        ulp=6,
        condition='Tangents of two angles, a root and a quotient are rounded one after the other.',
        claims={
            'ignatov2005:2.2V.1a': '2454d33ff5bf',
            'ignatov2005:2.2V.2a': 'b7890bffda83',
            'ignatov2005:2.2V.3a': '45c0821bb0e1',
            'ignatov2005:2.2V.4a': '39b18cc074ae',
        },
    ),
)
def vertices_of_three_wheels(a, b):
    """Vertices V_i = -V'_i of the envelope of four wheels of which the last has failed, without components that are zero.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    b : float or ndarray
        Angle of the side edges in the plane OXY, in rad; 0 < b < pi/2.
    out : sequence of ndarray, optional
        12 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    V_1x : float or ndarray
        X of V_1, in units of h_max.
    V_1y : float or ndarray
        Y of V_1, in units of h_max.
    V_1z : float or ndarray
        Z of V_1, in units of h_max.
    V_2x : float or ndarray
        X of V_2, in units of h_max.
    V_2y : float or ndarray
        Y of V_2, in units of h_max.
    V_2z : float or ndarray
        Z of V_2, in units of h_max.
    V_3x : float or ndarray
        X of V_3, in units of h_max.
    V_3y : float or ndarray
        Y of V_3, in units of h_max.
    V_3z : float or ndarray
        Z of V_3, in units of h_max.
    V_4x : float or ndarray
        X of V_4, in units of h_max.
    V_4y : float or ndarray
        Y of V_4, in units of h_max.
    V_4z : float or ndarray
        Z of V_4, in units of h_max.

    Notes
    -----
    The function computes ::

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

    Accuracy: 6 ulp over the domain. Tangents of two angles, a root and a quotient are rounded one after the
    other.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit. Outputs that are
    equal by formula are one array, unless `out` is given.

    Rests on ignatov2005:2.2V.1a (sha256 2454d33ff5bf), ignatov2005:2.2V.2a (sha256 b7890bffda83),
    ignatov2005:2.2V.3a (sha256 45c0821bb0e1), ignatov2005:2.2V.4a (sha256 39b18cc074ae).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import vertices_of_three_wheels
    >>> [f"{x:.6g}" for x in vertices_of_three_wheels(0.52, 1.05)]
    ['1.29302', '-0.247233', '-0.867819', '0.431005', '0.247233', '0.867819', '0.431005', '-0.7417', '0.867819', '0.431005', '0.247233', '-2.60346']
    """
    sin_a = math.sin(a)
    t1 = sin_a * math.sin(b)
    t2 = math.cos(b) * sin_a
    cos_a = math.cos(a)
    return 3.0 * t1, -t2, -cos_a, t1, t2, cos_a, t1, -(3.0 * t2), cos_a, t1, t2, -(3.0 * cos_a)


@kernel(
    paths.vertices_of_six_wheels,
    Specification(
        paper='ignatov2005',
        name='vertices_of_six_wheels',
        says="Vertices V_i = -V'_i of the envelope of six wheels, without components that are zero.",
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('V_1z', 'z of V_1', unit='units of h_max'),
            Output('V_2y', 'y of V_2', unit='units of h_max'),
            Output('V_2z', 'z of V_2', unit='units of h_max'),
            Output('V_3x', 'x of V_3', unit='units of h_max'),
            Output('V_3y', 'y of V_3', unit='units of h_max'),
            Output('V_3z', 'z of V_3', unit='units of h_max'),
            Output('V_4x', 'x of V_4', unit='units of h_max'),
            Output('V_4y', 'y of V_4', unit='units of h_max'),
            Output('V_4z', 'z of V_4', unit='units of h_max'),
            Output('V_5y', 'y of V_5', unit='units of h_max'),
            Output('V_5z', 'z of V_5', unit='units of h_max'),
            Output('V_6x', 'x of V_6', unit='units of h_max'),
            Output('V_6y', 'y of V_6', unit='units of h_max'),
            Output('V_6z', 'z of V_6', unit='units of h_max'),
            Output('V_7x', 'x of V_7', unit='units of h_max'),
            Output('V_7y', 'y of V_7', unit='units of h_max'),
            Output('V_7z', 'z of V_7', unit='units of h_max'),
            Output('V_8x', 'x of V_8', unit='units of h_max'),
            Output('V_8y', 'y of V_8', unit='units of h_max'),
            Output('V_8z', 'z of V_8', unit='units of h_max'),
            Output('V_9x', 'x of V_9', unit='units of h_max'),
            Output('V_9y', 'y of V_9', unit='units of h_max'),
            Output('V_9z', 'z of V_9', unit='units of h_max'),
            Output('V_10x', 'x of V_10', unit='units of h_max'),
            Output('V_10z', 'z of V_10', unit='units of h_max'),
            Output('V_11x', 'x of V_11', unit='units of h_max'),
            Output('V_11y', 'y of V_11', unit='units of h_max'),
            Output('V_11z', 'z of V_11', unit='units of h_max'),
            Output('V_12x', 'x of V_12', unit='units of h_max'),
            Output('V_12y', 'y of V_12', unit='units of h_max'),
            Output('V_12z', 'z of V_12', unit='units of h_max'),
            Output('V_13x', 'x of V_13', unit='units of h_max'),
            Output('V_13z', 'z of V_13', unit='units of h_max'),
            Output('V_14x', 'x of V_14', unit='units of h_max'),
            Output('V_14y', 'y of V_14', unit='units of h_max'),
            Output('V_15y', 'y of V_15', unit='units of h_max'),
            Output('V_16x', 'x of V_16', unit='units of h_max'),
            Output('V_16y', 'y of V_16', unit='units of h_max'),
        ),
        ulp=5,
        condition='The square root of 3 and half a sine are rounded too.',
        claims={
            'ignatov2005:3.1V.1a': 'b51a3fcf346f',
            'ignatov2005:3.1V.2a': 'b0c634dcdde9',
            'ignatov2005:3.1V.3a': '7bb0b8f23c7a',
            'ignatov2005:3.1V.4a': 'eee98e1b565b',
            'ignatov2005:3.1V.5a': 'f08e36effac0',
            'ignatov2005:3.1V.6a': '5bef380883e6',
            'ignatov2005:3.1V.7a': '1e8ce505359f',
            'ignatov2005:3.1V.8a': 'cbda7b1ae859',
            'ignatov2005:3.1V.9a': '17e1fe062dac',
            'ignatov2005:3.1V.10a': '0248272de7aa',
            'ignatov2005:3.1V.11a': 'dc8419622b85',
            'ignatov2005:3.1V.12a': '064a71a8217e',
            'ignatov2005:3.1V.13a': '5afc508aa051',
            'ignatov2005:3.1V.14a': 'aad84d3eca9d',
            'ignatov2005:3.1V.15a': 'ccddd845f704',
            'ignatov2005:3.1V.16a': '1e908cfed76a',
        },
    ),
)
def vertices_of_six_wheels(a):
    """Vertices V_i = -V'_i of the envelope of six wheels, without components that are zero.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    out : sequence of ndarray, optional
        38 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    V_1z : float or ndarray
        Z of V_1, in units of h_max.
    V_2y : float or ndarray
        Y of V_2, in units of h_max.
    V_2z : float or ndarray
        Z of V_2, in units of h_max.
    V_3x : float or ndarray
        X of V_3, in units of h_max.
    V_3y : float or ndarray
        Y of V_3, in units of h_max.
    V_3z : float or ndarray
        Z of V_3, in units of h_max.
    V_4x : float or ndarray
        X of V_4, in units of h_max.
    V_4y : float or ndarray
        Y of V_4, in units of h_max.
    V_4z : float or ndarray
        Z of V_4, in units of h_max.
    V_5y : float or ndarray
        Y of V_5, in units of h_max.
    V_5z : float or ndarray
        Z of V_5, in units of h_max.
    V_6x : float or ndarray
        X of V_6, in units of h_max.
    V_6y : float or ndarray
        Y of V_6, in units of h_max.
    V_6z : float or ndarray
        Z of V_6, in units of h_max.
    V_7x : float or ndarray
        X of V_7, in units of h_max.
    V_7y : float or ndarray
        Y of V_7, in units of h_max.
    V_7z : float or ndarray
        Z of V_7, in units of h_max.
    V_8x : float or ndarray
        X of V_8, in units of h_max.
    V_8y : float or ndarray
        Y of V_8, in units of h_max.
    V_8z : float or ndarray
        Z of V_8, in units of h_max.
    V_9x : float or ndarray
        X of V_9, in units of h_max.
    V_9y : float or ndarray
        Y of V_9, in units of h_max.
    V_9z : float or ndarray
        Z of V_9, in units of h_max.
    V_10x : float or ndarray
        X of V_10, in units of h_max.
    V_10z : float or ndarray
        Z of V_10, in units of h_max.
    V_11x : float or ndarray
        X of V_11, in units of h_max.
    V_11y : float or ndarray
        Y of V_11, in units of h_max.
    V_11z : float or ndarray
        Z of V_11, in units of h_max.
    V_12x : float or ndarray
        X of V_12, in units of h_max.
    V_12y : float or ndarray
        Y of V_12, in units of h_max.
    V_12z : float or ndarray
        Z of V_12, in units of h_max.
    V_13x : float or ndarray
        X of V_13, in units of h_max.
    V_13z : float or ndarray
        Z of V_13, in units of h_max.
    V_14x : float or ndarray
        X of V_14, in units of h_max.
    V_14y : float or ndarray
        Y of V_14, in units of h_max.
    V_15y : float or ndarray
        Y of V_15, in units of h_max.
    V_16x : float or ndarray
        X of V_16, in units of h_max.
    V_16y : float or ndarray
        Y of V_16, in units of h_max.

    Notes
    -----
    The function computes ::

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

    Accuracy: 5 ulp over the domain. The square root of 3 and half a sine are rounded too.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit. Outputs that are
    equal by formula are one array, unless `out` is given.

    Rests on ignatov2005:3.1V.1a (sha256 b51a3fcf346f), ignatov2005:3.1V.2a (sha256 b0c634dcdde9),
    ignatov2005:3.1V.3a (sha256 7bb0b8f23c7a), ignatov2005:3.1V.4a (sha256 eee98e1b565b), ignatov2005:3.1V.5a
    (sha256 f08e36effac0), ignatov2005:3.1V.6a (sha256 5bef380883e6), ignatov2005:3.1V.7a (sha256 1e8ce505359f),
    ignatov2005:3.1V.8a (sha256 cbda7b1ae859), ignatov2005:3.1V.9a (sha256 17e1fe062dac), ignatov2005:3.1V.10a
    (sha256 0248272de7aa), ignatov2005:3.1V.11a (sha256 dc8419622b85), ignatov2005:3.1V.12a (sha256 064a71a8217e),
    ignatov2005:3.1V.13a (sha256 5afc508aa051), ignatov2005:3.1V.14a (sha256 aad84d3eca9d), ignatov2005:3.1V.15a
    (sha256 ccddd845f704), ignatov2005:3.1V.16a (sha256 1e908cfed76a).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import vertices_of_six_wheels
    >>> [f"{x:.6g}" for x in vertices_of_six_wheels(0.79)]
    ['4.22307', '1.42071', '2.81538', '-1.23037', '0.710353', '2.81538', '-1.23037', '-0.710353', '2.81538', '-1.42071', '2.81538', '1.23037', '-0.710353', '2.81538', '1.23037', '0.710353', '2.81538', '1.23037', '2.13106', '1.40769', '-1.23037', '2.13106', '1.40769', '-2.46074', '1.40769', '-1.23037', '-2.13106', '1.40769', '1.23037', '-2.13106', '1.40769', '2.46074', '1.40769', '2.46074', '1.42071', '2.84141', '-2.46074', '1.42071']
    """
    cos_a = math.cos(a)
    sin_a = math.sin(a)
    t1 = 2.0 * sin_a
    t2 = 4.0 * cos_a
    t3 = sin_a * math.sqrt(3.0)
    t4 = -t3
    t5 = -sin_a
    t6 = 3.0 * sin_a
    t7 = 2.0 * cos_a
    t8 = math.sqrt(3.0) * t1
    t9 = -t8
    t10 = -t6
    return 6.0 * cos_a, t1, t2, t4, sin_a, t2, t4, t5, t2, -t1, t2, t3, t5, t2, t3, sin_a, t2, t3, t6, t7, t4, t6, t7, t9, t7, t4, t10, t7, t3, t10, t7, t8, t7, t8, t1, 4.0 * sin_a, t9, t1


@kernel(
    paths.vertices_of_five_wheels,
    Specification(
        paper='ignatov2005',
        name='vertices_of_five_wheels',
        says="Vertices V_i = -V'_i of the envelope of six wheels of which the last has failed, without components that are zero.",
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('V_1x', 'x of V_1', unit='units of h_max'),
            Output('V_1y', 'y of V_1', unit='units of h_max'),
            Output('V_1z', 'z of V_1', unit='units of h_max'),
            Output('V_2x', 'x of V_2', unit='units of h_max'),
            Output('V_2y', 'y of V_2', unit='units of h_max'),
            Output('V_2z', 'z of V_2', unit='units of h_max'),
            Output('V_3x', 'x of V_3', unit='units of h_max'),
            Output('V_3y', 'y of V_3', unit='units of h_max'),
            Output('V_3z', 'z of V_3', unit='units of h_max'),
            Output('V_4x', 'x of V_4', unit='units of h_max'),
            Output('V_4y', 'y of V_4', unit='units of h_max'),
            Output('V_4z', 'z of V_4', unit='units of h_max'),
            Output('V_5x', 'x of V_5', unit='units of h_max'),
            Output('V_5y', 'y of V_5', unit='units of h_max'),
            Output('V_5z', 'z of V_5', unit='units of h_max'),
            Output('V_6x', 'x of V_6', unit='units of h_max'),
            Output('V_6y', 'y of V_6', unit='units of h_max'),
            Output('V_6z', 'z of V_6', unit='units of h_max'),
            Output('V_7x', 'x of V_7', unit='units of h_max'),
            Output('V_7y', 'y of V_7', unit='units of h_max'),
            Output('V_7z', 'z of V_7', unit='units of h_max'),
            Output('V_8x', 'x of V_8', unit='units of h_max'),
            Output('V_8y', 'y of V_8', unit='units of h_max'),
            Output('V_8z', 'z of V_8', unit='units of h_max'),
            Output('V_9x', 'x of V_9', unit='units of h_max'),
            Output('V_9y', 'y of V_9', unit='units of h_max'),
            Output('V_9z', 'z of V_9', unit='units of h_max'),
            Output('V_10x', 'x of V_10', unit='units of h_max'),
            Output('V_10y', 'y of V_10', unit='units of h_max'),
            Output('V_10z', 'z of V_10', unit='units of h_max'),
            Output('V_11x', 'x of V_11', unit='units of h_max'),
            Output('V_11y', 'y of V_11', unit='units of h_max'),
            Output('V_11z', 'z of V_11', unit='units of h_max'),
        ),
        ulp=5,
        condition='The square root of 3 and half a sine are rounded too.',
        claims={
            'ignatov2005:3.2V.1a': '12fa1ab02a5f',
            'ignatov2005:3.2V.2a': 'd8e0ae63d033',
            'ignatov2005:3.2V.3a': 'be4a9049023c',
            'ignatov2005:3.2V.4a': '8e45bf74b10b',
            'ignatov2005:3.2V.5a': 'ceb89ee8941d',
            'ignatov2005:3.2V.6a': '8c38650a0830',
            'ignatov2005:3.2V.7a': 'c2dfe2bca48d',
            'ignatov2005:3.2V.8a': 'cf0c32575974',
            'ignatov2005:3.2V.9a': 'f8aed7e8d192',
            'ignatov2005:3.2V.10a': '3c61def8ef19',
            'ignatov2005:3.2V.11a': 'a185009784ec',
        },
    ),
)
def vertices_of_five_wheels(a):
    """Vertices V_i = -V'_i of the envelope of six wheels of which the last has failed, without components that are zero.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    out : sequence of ndarray, optional
        33 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    V_1x : float or ndarray
        X of V_1, in units of h_max.
    V_1y : float or ndarray
        Y of V_1, in units of h_max.
    V_1z : float or ndarray
        Z of V_1, in units of h_max.
    V_2x : float or ndarray
        X of V_2, in units of h_max.
    V_2y : float or ndarray
        Y of V_2, in units of h_max.
    V_2z : float or ndarray
        Z of V_2, in units of h_max.
    V_3x : float or ndarray
        X of V_3, in units of h_max.
    V_3y : float or ndarray
        Y of V_3, in units of h_max.
    V_3z : float or ndarray
        Z of V_3, in units of h_max.
    V_4x : float or ndarray
        X of V_4, in units of h_max.
    V_4y : float or ndarray
        Y of V_4, in units of h_max.
    V_4z : float or ndarray
        Z of V_4, in units of h_max.
    V_5x : float or ndarray
        X of V_5, in units of h_max.
    V_5y : float or ndarray
        Y of V_5, in units of h_max.
    V_5z : float or ndarray
        Z of V_5, in units of h_max.
    V_6x : float or ndarray
        X of V_6, in units of h_max.
    V_6y : float or ndarray
        Y of V_6, in units of h_max.
    V_6z : float or ndarray
        Z of V_6, in units of h_max.
    V_7x : float or ndarray
        X of V_7, in units of h_max.
    V_7y : float or ndarray
        Y of V_7, in units of h_max.
    V_7z : float or ndarray
        Z of V_7, in units of h_max.
    V_8x : float or ndarray
        X of V_8, in units of h_max.
    V_8y : float or ndarray
        Y of V_8, in units of h_max.
    V_8z : float or ndarray
        Z of V_8, in units of h_max.
    V_9x : float or ndarray
        X of V_9, in units of h_max.
    V_9y : float or ndarray
        Y of V_9, in units of h_max.
    V_9z : float or ndarray
        Z of V_9, in units of h_max.
    V_10x : float or ndarray
        X of V_10, in units of h_max.
    V_10y : float or ndarray
        Y of V_10, in units of h_max.
    V_10z : float or ndarray
        Z of V_10, in units of h_max.
    V_11x : float or ndarray
        X of V_11, in units of h_max.
    V_11y : float or ndarray
        Y of V_11, in units of h_max.
    V_11z : float or ndarray
        Z of V_11, in units of h_max.

    Notes
    -----
    The function computes ::

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

    Accuracy: 5 ulp over the domain. The square root of 3 and half a sine are rounded too.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit. Outputs that are
    equal by formula are one array, unless `out` is given.

    Rests on ignatov2005:3.2V.1a (sha256 12fa1ab02a5f), ignatov2005:3.2V.2a (sha256 d8e0ae63d033),
    ignatov2005:3.2V.3a (sha256 be4a9049023c), ignatov2005:3.2V.4a (sha256 8e45bf74b10b), ignatov2005:3.2V.5a
    (sha256 ceb89ee8941d), ignatov2005:3.2V.6a (sha256 8c38650a0830), ignatov2005:3.2V.7a (sha256 c2dfe2bca48d),
    ignatov2005:3.2V.8a (sha256 cf0c32575974), ignatov2005:3.2V.9a (sha256 f8aed7e8d192), ignatov2005:3.2V.10a
    (sha256 3c61def8ef19), ignatov2005:3.2V.11a (sha256 a185009784ec).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import vertices_of_five_wheels
    >>> [f"{x:.6g}" for x in vertices_of_five_wheels(0.79)]
    ['0.615184', '0.355177', '3.51923', '0.615184', '1.77588', '2.11154', '-0.615184', '1.06553', '2.11154', '-0.615184', '-0.355177', '2.11154', '0.615184', '-1.06553', '2.11154', '1.84555', '-0.355177', '2.11154', '1.84555', '1.06553', '0.703845', '-0.615184', '2.48624', '0.703845', '-1.84555', '0.355177', '0.703845', '-0.615184', '-1.77588', '0.703845', '1.84555', '-1.77588', '0.703845']
    """
    sin_a = math.sin(a)
    t1 = (1.0 / 2.0) * sin_a
    t2 = math.sqrt(3.0) * t1
    cos_a = math.cos(a)
    t3 = (5.0 / 2.0) * sin_a
    t4 = 3.0 * cos_a
    t5 = -t2
    t6 = (3.0 / 2.0) * sin_a
    t7 = -t1
    t8 = math.sqrt(3.0) * t6
    t9 = -t3
    return t2, t1, 5.0 * cos_a, t2, t3, t4, t5, t6, t4, t5, t7, t4, t2, -t6, t4, t8, t7, t4, t8, t6, cos_a, t5, (7.0 / 2.0) * sin_a, cos_a, -t8, t1, cos_a, t5, t9, cos_a, t8, t9, cos_a


@kernel(
    paths.vertex_distances_of_four_wheels,
    Specification(
        paper='ignatov2005',
        name='vertex_distances_of_four_wheels',
        says='Distances from the centre to the vertices of the envelope of four wheels.',
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('b', 'angle of the side edges in the plane OXY', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('d_1', 'distance of V_1', unit='units of h_max'),
            Output('d_2', 'distance of V_6', unit='units of h_max'),
            Output('d_3', 'distance of V_7 (V_2 to V_5 are 2 away at all angles)', unit='units of h_max'),
        ),
        ulp=6,
        condition='Tangents of two angles, a root and a quotient are rounded one after the other.',
        claims={
            'ignatov2005:2.1.28': '0e3240f25813',
            'ignatov2005:2.1.29': 'b8a120513c5b',
            'ignatov2005:2.1.30': '321b732aa3c2',
        },
    ),
)
def vertex_distances_of_four_wheels(a, b):
    """Distances from the centre to the vertices of the envelope of four wheels.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    b : float or ndarray
        Angle of the side edges in the plane OXY, in rad; 0 < b < pi/2.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    d_1 : float or ndarray
        Distance of V_1, in units of h_max.
    d_2 : float or ndarray
        Distance of V_6, in units of h_max.
    d_3 : float or ndarray
        Distance of V_7 (V_2 to V_5 are 2 away at all angles), in units of h_max.

    Notes
    -----
    The function computes ::

        d_1 = 4*sin(a)*sin(b)
        d_2 = 4*sin(a)*cos(b)
        d_3 = 4*cos(a)

    Accuracy: 6 ulp over the domain. Tangents of two angles, a root and a quotient are rounded one after the
    other.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:2.1.28 (sha256 0e3240f25813), ignatov2005:2.1.29 (sha256 b8a120513c5b),
    ignatov2005:2.1.30 (sha256 321b732aa3c2).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import vertex_distances_of_four_wheels
    >>> [f"{x:.6g}" for x in vertex_distances_of_four_wheels(0.52, 1.05)]
    ['1.72402', '0.988933', '3.47128']
    """
    t1 = 4.0 * math.sin(a)
    return math.sin(b) * t1, math.cos(b) * t1, 4.0 * math.cos(a)


@kernel(
    paths.vertex_distances_of_three_wheels,
    Specification(
        paper='ignatov2005',
        name='vertex_distances_of_three_wheels',
        says='Distances from the centre to the vertices of the envelope of four wheels of which the last has failed.',
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('b', 'angle of the side edges in the plane OXY', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('d_1', 'distance of V_1', unit='units of h_max'),
            Output('d_2', 'distance of V_3', unit='units of h_max'),
            Output('d_3', 'distance of V_4 (V_2 is 1 away at all angles)', unit='units of h_max'),
        ),
        ulp=4,
        claims={
            'ignatov2005:2.2.18': '4d77f76651c9',
            'ignatov2005:2.2.19': 'ae7a0b96326a',
            'ignatov2005:2.2.20': '47427cf2a5e7',
        },
        forms='e8f94252f227',
    ),
)
def vertex_distances_of_three_wheels(a, b):
    """Distances from the centre to the vertices of the envelope of four wheels of which the last has failed.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    b : float or ndarray
        Angle of the side edges in the plane OXY, in rad; 0 < b < pi/2.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    d_1 : float or ndarray
        Distance of V_1, in units of h_max.
    d_2 : float or ndarray
        Distance of V_3, in units of h_max.
    d_3 : float or ndarray
        Distance of V_4 (V_2 is 1 away at all angles), in units of h_max.

    Notes
    -----
    The function computes ::

        d_1 = sqrt(9*sin(a)**2*sin(b)**2 + sin(a)**2*cos(b)**2 + cos(a)**2)
        d_2 = sqrt(sin(a)**2*sin(b)**2 + 9*sin(a)**2*cos(b)**2 + cos(a)**2)
        d_3 = sqrt(sin(a)**2*sin(b)**2 + sin(a)**2*cos(b)**2 + 9*cos(a)**2)

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:2.2.18 (sha256 4d77f76651c9), ignatov2005:2.2.19 (sha256 ae7a0b96326a),
    ignatov2005:2.2.20 (sha256 47427cf2a5e7). The forms computed are proved equal to those shown (sha256
    e8f94252f227).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import vertex_distances_of_three_wheels
    >>> [f"{x:.6g}" for x in vertex_distances_of_three_wheels(0.52, 1.05)]
    ['1.57675', '1.22024', '2.65045']
    """
    tan_b = math.tan(b)
    tan_b_squared = tan_b * tan_b
    tan_a = math.tan(a)
    tan_a_squared = tan_a * tan_a
    t2 = 8.0 / (1.0 + tan_a_squared)
    t5 = t2 * tan_a_squared / (1.0 + tan_b_squared)
    return math.sqrt(1.0 + t5 * tan_b_squared), math.sqrt(1.0 + t5), math.sqrt(1.0 + t2)


@kernel(
    paths.vertex_distances_of_six_wheels,
    Specification(
        paper='ignatov2005',
        name='vertex_distances_of_six_wheels',
        says='Distances from the centre to the vertices of the envelope of six wheels.',
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('d_1', 'distance of V_1', unit='units of h_max'),
            Output('d_2', 'distance of V_14 to V_16', unit='units of h_max'),
            Output('d_3', 'distance of V_2 to V_7', unit='units of h_max'),
            Output('d_4', 'distance of V_8 to V_13', unit='units of h_max'),
        ),
        ulp=4,
        claims={
            'ignatov2005:3.1.28': '12102fa02278',
            'ignatov2005:3.1.29': '05d47c77242f',
            'ignatov2005:3.1.30': 'dc0a623feb52',
            'ignatov2005:3.1.31': '196586fd34c2',
        },
        forms='6715f551bdad',
    ),
)
def vertex_distances_of_six_wheels(a):
    """Distances from the centre to the vertices of the envelope of six wheels.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    out : sequence of ndarray, optional
        4 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    d_1 : float or ndarray
        Distance of V_1, in units of h_max.
    d_2 : float or ndarray
        Distance of V_14 to V_16, in units of h_max.
    d_3 : float or ndarray
        Distance of V_2 to V_7, in units of h_max.
    d_4 : float or ndarray
        Distance of V_8 to V_13, in units of h_max.

    Notes
    -----
    The function computes ::

        d_1 = 6*cos(a)
        d_2 = 4*sin(a)
        d_3 = sqrt(4*sin(a)**2 + 16*cos(a)**2)
        d_4 = sqrt(12*sin(a)**2 + 4*cos(a)**2)

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:3.1.28 (sha256 12102fa02278), ignatov2005:3.1.29 (sha256 05d47c77242f),
    ignatov2005:3.1.30 (sha256 dc0a623feb52), ignatov2005:3.1.31 (sha256 196586fd34c2). The forms computed are
    proved equal to those shown (sha256 6715f551bdad).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import vertex_distances_of_six_wheels
    >>> [f"{x:.6g}" for x in vertex_distances_of_six_wheels(0.79)]
    ['4.22307', '2.84141', '3.15353', '2.83493']
    """
    tan_a = math.tan(a)
    tan_a_squared = tan_a * tan_a
    t2 = 1.0 / (1.0 + tan_a_squared)
    return 6.0 * math.cos(a), 4.0 * math.sin(a), 2.0 * math.sqrt(1.0 + 3.0 * t2), 2.0 * math.sqrt(1.0 + 2.0 * (t2 * tan_a_squared))


@kernel(
    paths.vertex_distances_of_five_wheels,
    Specification(
        paper='ignatov2005',
        name='vertex_distances_of_five_wheels',
        says='Distances from the centre to the vertices of the envelope of six wheels of which the last has failed.',
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('d_1', 'distance of V_1', unit='units of h_max'),
            Output('d_2', 'distance of V_2 and V_6', unit='units of h_max'),
            Output('d_3', 'distance of V_3 and V_5', unit='units of h_max'),
            Output('d_4', 'distance of V_4', unit='units of h_max'),
            Output('d_5', 'distance of V_7', unit='units of h_max'),
            Output('d_6', 'distance of V_8 and V_11', unit='units of h_max'),
            Output('d_7', 'distance of V_9 and V_10', unit='units of h_max'),
        ),
        ulp=4,
        claims={
            'ignatov2005:T10.1': 'a66d84adc0ff',
            'ignatov2005:T10.2': '77030a88722f',
            'ignatov2005:T10.3': '38b313e59b78',
            'ignatov2005:T10.4': '64c442074569',
            'ignatov2005:T10.5': 'aefc26a40abb',
            'ignatov2005:T10.6': 'd2b1bc5ab521',
            'ignatov2005:T10.7': '1ce2e65fcc46',
        },
        forms='7c6a4367933f',
    ),
)
def vertex_distances_of_five_wheels(a):
    """Distances from the centre to the vertices of the envelope of six wheels of which the last has failed.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    out : sequence of ndarray, optional
        7 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    d_1 : float or ndarray
        Distance of V_1, in units of h_max.
    d_2 : float or ndarray
        Distance of V_2 and V_6, in units of h_max.
    d_3 : float or ndarray
        Distance of V_3 and V_5, in units of h_max.
    d_4 : float or ndarray
        Distance of V_4, in units of h_max.
    d_5 : float or ndarray
        Distance of V_7, in units of h_max.
    d_6 : float or ndarray
        Distance of V_8 and V_11, in units of h_max.
    d_7 : float or ndarray
        Distance of V_9 and V_10, in units of h_max.

    Notes
    -----
    The function computes ::

        d_1 = sqrt(sin(a)**2 + 25*cos(a)**2)
        d_2 = sqrt(7*sin(a)**2 + 9*cos(a)**2)
        d_3 = sqrt(3*sin(a)**2 + 9*cos(a)**2)
        d_4 = sqrt(sin(a)**2 + 9*cos(a)**2)
        d_5 = sqrt(9*sin(a)**2 + cos(a)**2)
        d_6 = sqrt(13*sin(a)**2 + cos(a)**2)
        d_7 = sqrt(7*sin(a)**2 + cos(a)**2)

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:T10.1 (sha256 a66d84adc0ff), ignatov2005:T10.2 (sha256 77030a88722f), ignatov2005:T10.3
    (sha256 38b313e59b78), ignatov2005:T10.4 (sha256 64c442074569), ignatov2005:T10.5 (sha256 aefc26a40abb),
    ignatov2005:T10.6 (sha256 d2b1bc5ab521), ignatov2005:T10.7 (sha256 1ce2e65fcc46). The forms computed are
    proved equal to those shown (sha256 7c6a4367933f).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import vertex_distances_of_five_wheels
    >>> [f"{x:.6g}" for x in vertex_distances_of_five_wheels(0.79)]
    ['3.5902', '2.8268', '2.44385', '2.22782', '2.24428', '2.65617', '2.00689']
    """
    tan_a = math.tan(a)
    tan_a_squared = tan_a * tan_a
    t2 = 1.0 / (1.0 + tan_a_squared)
    t3 = 6.0 * t2
    t4 = 8.0 * t2
    return math.sqrt(1.0 + 24.0 * t2), math.sqrt(7.0 + 2.0 * t2), math.sqrt(3.0 + t3), math.sqrt(1.0 + t4), math.sqrt(1.0 + t4 * tan_a_squared), math.sqrt(1.0 + 12.0 * (t2 * tan_a_squared)), math.sqrt(1.0 + t3 * tan_a_squared)


@kernel(
    paths.face_distances_of_four_wheels,
    Specification(
        paper='ignatov2005',
        name='face_distances_of_four_wheels',
        says='Distances from the centre to the planes of the faces of the envelope of four wheels.',
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('b', 'angle of the side edges in the plane OXY', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('r_1', 'distance of F_1 and F_5', unit='units of h_max'),
            Output('r_2', 'distance of F_2 and F_4', unit='units of h_max'),
            Output('r_3', 'distance of F_3 and F_6', unit='units of h_max'),
        ),
        ulp=5,
        condition='Tangents of two angles, a root and a quotient are rounded one after the other.',
        claims={
            'ignatov2005:T3.1': '8efdfa34b18c',
            'ignatov2005:T3.2': 'd75a5ee5e821',
            'ignatov2005:T3.3': 'c07cc09dd077',
        },
        forms='c0e08f011f03',
    ),
)
def face_distances_of_four_wheels(a, b):
    """Distances from the centre to the planes of the faces of the envelope of four wheels.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    b : float or ndarray
        Angle of the side edges in the plane OXY, in rad; 0 < b < pi/2.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    r_1 : float or ndarray
        Distance of F_1 and F_5, in units of h_max.
    r_2 : float or ndarray
        Distance of F_2 and F_4, in units of h_max.
    r_3 : float or ndarray
        Distance of F_3 and F_6, in units of h_max.

    Notes
    -----
    The function computes ::

        r_1 = 4*sin(a)*sin(b)*cos(a)/sqrt(sin(a)**2*sin(b)**2 + cos(a)**2)
        r_2 = 4*sin(a)*cos(a)*cos(b)/sqrt(sin(a)**2*cos(b)**2 + cos(a)**2)
        r_3 = 4*sin(a)**2*sin(b)*cos(b)/sqrt(sin(a)**2*sin(b)**2 + sin(a)**2*cos(b)**2)

    Accuracy: 5 ulp over the domain. Tangents of two angles, a root and a quotient are rounded one after the
    other.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:T3.1 (sha256 8efdfa34b18c), ignatov2005:T3.2 (sha256 d75a5ee5e821), ignatov2005:T3.3
    (sha256 c07cc09dd077). The forms computed are proved equal to those shown (sha256 c0e08f011f03).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import face_distances_of_four_wheels
    >>> [f"{x:.6g}" for x in face_distances_of_four_wheels(0.52, 1.05)]
    ['1.54407', '0.951089', '0.857823']
    """
    tan_a = math.tan(a)
    tan_a_squared = tan_a * tan_a
    tan_b = math.tan(b)
    tan_b_squared = tan_b * tan_b
    t1 = 1.0 + tan_b_squared
    t2 = 4.0 * tan_a
    t3 = t2 * tan_b
    t4 = t1 * t1
    t11 = math.sqrt(t1 + (1.0 + (tan_a_squared * tan_b_squared + 2.0 * tan_b_squared)) * tan_a_squared)
    return t3 / t11, t2 / math.sqrt(t1 + (2.0 + (tan_a_squared + tan_b_squared)) * tan_a_squared), t3 / math.sqrt(t4 * tan_a_squared + t4)


@kernel(
    paths.face_distances_of_three_wheels,
    Specification(
        paper='ignatov2005',
        name='face_distances_of_three_wheels',
        says='Distances from the centre to the planes of the faces of the envelope of four wheels of which the last has failed.',
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('b', 'angle of the side edges in the plane OXY', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('r_1', 'distance of F_1', unit='units of h_max'),
            Output('r_2', 'distance of F_2', unit='units of h_max'),
            Output('r_3', 'distance of F_3', unit='units of h_max'),
        ),
        ulp=5,
        condition='Tangents of two angles, a root and a quotient are rounded one after the other.',
        claims={
            'ignatov2005:T5.1': '3ea4d48a967e',
        },
        forms='d8ee80165a63',
    ),
)
def face_distances_of_three_wheels(a, b):
    """Distances from the centre to the planes of the faces of the envelope of four wheels of which the last has failed.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    b : float or ndarray
        Angle of the side edges in the plane OXY, in rad; 0 < b < pi/2.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    r_1 : float or ndarray
        Distance of F_1, in units of h_max.
    r_2 : float or ndarray
        Distance of F_2, in units of h_max.
    r_3 : float or ndarray
        Distance of F_3, in units of h_max.

    Notes
    -----
    The function computes ::

        r_1 = 2*sin(a)*sin(b)*cos(a)/sqrt(sin(a)**2*sin(b)**2 + cos(a)**2)
        r_2 = 2*sin(a)*cos(a)*cos(b)/sqrt(sin(a)**2*cos(b)**2 + cos(a)**2)
        r_3 = 2*sin(a)**2*sin(b)*cos(b)/sqrt(sin(a)**2*sin(b)**2 + sin(a)**2*cos(b)**2)

    Accuracy: 5 ulp over the domain. Tangents of two angles, a root and a quotient are rounded one after the
    other.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:T5.1 (sha256 3ea4d48a967e). The forms computed are proved equal to those shown (sha256
    d8ee80165a63).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import face_distances_of_three_wheels
    >>> [f"{x:.6g}" for x in face_distances_of_three_wheels(0.52, 1.05)]
    ['0.772037', '0.475545', '0.428912']
    """
    tan_a = math.tan(a)
    tan_a_squared = tan_a * tan_a
    tan_b = math.tan(b)
    tan_b_squared = tan_b * tan_b
    t1 = 1.0 + tan_b_squared
    t2 = 2.0 * tan_a
    t3 = t2 * tan_b
    t4 = t1 * t1
    t11 = math.sqrt(t1 + (1.0 + (tan_a_squared * tan_b_squared + 2.0 * tan_b_squared)) * tan_a_squared)
    return t3 / t11, t2 / math.sqrt(t1 + (2.0 + (tan_a_squared + tan_b_squared)) * tan_a_squared), t3 / math.sqrt(t4 * tan_a_squared + t4)


@kernel(
    paths.face_distances_of_six_wheels,
    Specification(
        paper='ignatov2005',
        name='face_distances_of_six_wheels',
        says='Distances from the centre to the planes of the faces of the envelope of six wheels.',
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('r_1', 'distance of F_1 to F_6', unit='units of h_max'),
            Output('r_2', 'distance of F_7 to F_12', unit='units of h_max'),
            Output('r_3', 'distance of F_13 to F_15', unit='units of h_max'),
        ),
        ulp=4,
        claims={
            'ignatov2005:T8.1': 'b14e385314d0',
            'ignatov2005:T8.3': '4228125f38ea',
            'ignatov2005:B.28': '472d640787be',
        },
        forms='686717258b03',
    ),
)
def face_distances_of_six_wheels(a):
    """Distances from the centre to the planes of the faces of the envelope of six wheels.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    r_1 : float or ndarray
        Distance of F_1 to F_6, in units of h_max.
    r_2 : float or ndarray
        Distance of F_7 to F_12, in units of h_max.
    r_3 : float or ndarray
        Distance of F_13 to F_15, in units of h_max.

    Notes
    -----
    The function computes ::

        r_1 = 6*sqrt(3)*sin(a)*cos(a)/sqrt(3*sin(a)**2 + 4*cos(a)**2)
        r_2 = 8*sin(a)*cos(a)/sqrt(sin(a)**2 + 4*cos(a)**2)
        r_3 = 2*sqrt(3)*sin(a)

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:T8.1 (sha256 b14e385314d0), ignatov2005:T8.3 (sha256 4228125f38ea), ignatov2005:B.28
    (sha256 472d640787be). The forms computed are proved equal to those shown (sha256 686717258b03).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import face_distances_of_six_wheels
    >>> [f"{x:.6g}" for x in face_distances_of_six_wheels(0.79)]
    ['2.77917', '2.53673', '2.46074']
    """
    tan_a = math.tan(a)
    tan_a_squared = tan_a * tan_a
    return 6.0 * tan_a / math.sqrt((4.0 / 3.0) + ((7.0 / 3.0) + tan_a_squared) * tan_a_squared), 8.0 * tan_a / math.sqrt(4.0 + (5.0 + tan_a_squared) * tan_a_squared), 4.0 * tan_a / math.sqrt((4.0 / 3.0) + (4.0 / 3.0) * tan_a_squared)


@kernel(
    paths.face_distances_of_five_wheels,
    Specification(
        paper='ignatov2005',
        name='face_distances_of_five_wheels',
        says='Distances from the centre to the planes of the faces of the envelope of six wheels of which the last has failed.',
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('r_1', 'distance of F_1', unit='units of h_max'),
            Output('r_2', 'distance of F_2 and F_5', unit='units of h_max'),
            Output('r_3', 'distance of F_3 and F_4', unit='units of h_max'),
            Output('r_4', 'distance of F_6 and F_8', unit='units of h_max'),
            Output('r_5', 'distance of F_7', unit='units of h_max'),
            Output('r_6', 'distance of F_9 and F_10', unit='units of h_max'),
        ),
        ulp=4,
        claims={
            'ignatov2005:T11.1': '4304d5fe37f8',
            'ignatov2005:T11.2': '158e62cdf51f',
            'ignatov2005:T11.3': 'ede2be42c5ac',
            'ignatov2005:T11.4': '1518d3d3abcf',
            'ignatov2005:T11.5': '01ed74be6d3d',
            'ignatov2005:T11.6': '1c799063763f',
        },
        forms='dfc56dd0e0d8',
    ),
)
def face_distances_of_five_wheels(a):
    """Distances from the centre to the planes of the faces of the envelope of six wheels of which the last has failed.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    out : sequence of ndarray, optional
        6 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    r_1 : float or ndarray
        Distance of F_1, in units of h_max.
    r_2 : float or ndarray
        Distance of F_2 and F_5, in units of h_max.
    r_3 : float or ndarray
        Distance of F_3 and F_4, in units of h_max.
    r_4 : float or ndarray
        Distance of F_6 and F_8, in units of h_max.
    r_5 : float or ndarray
        Distance of F_7, in units of h_max.
    r_6 : float or ndarray
        Distance of F_9 and F_10, in units of h_max.

    Notes
    -----
    The function computes ::

        r_1 = 7*sin(a)*cos(a)/sqrt(sin(a)**2 + 4*cos(a)**2)
        r_2 = 5*sqrt(3)*sin(a)*cos(a)/sqrt(3*sin(a)**2 + 4*cos(a)**2)
        r_3 = 4*sqrt(3)*sin(a)*cos(a)/sqrt(3*sin(a)**2 + 4*cos(a)**2)
        r_4 = 6*sin(a)*cos(a)/sqrt(sin(a)**2 + 4*cos(a)**2)
        r_5 = 5*sin(a)*cos(a)/sqrt(sin(a)**2 + 4*cos(a)**2)
        r_6 = 3*sqrt(3)*sin(a)/2

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:T11.1 (sha256 4304d5fe37f8), ignatov2005:T11.2 (sha256 158e62cdf51f), ignatov2005:T11.3
    (sha256 ede2be42c5ac), ignatov2005:T11.4 (sha256 1518d3d3abcf), ignatov2005:T11.5 (sha256 01ed74be6d3d),
    ignatov2005:T11.6 (sha256 1c799063763f). The forms computed are proved equal to those shown (sha256
    dfc56dd0e0d8).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import face_distances_of_five_wheels
    >>> [f"{x:.6g}" for x in face_distances_of_five_wheels(0.79)]
    ['2.21964', '2.31598', '1.85278', '1.90255', '1.58546', '1.84555']
    """
    tan_a = math.tan(a)
    tan_a_squared = tan_a * tan_a
    t5 = tan_a / math.sqrt(4.0 + (5.0 + tan_a_squared) * tan_a_squared)
    t10 = tan_a / math.sqrt((4.0 / 3.0) + ((7.0 / 3.0) + tan_a_squared) * tan_a_squared)
    return 7.0 * t5, 5.0 * t10, 4.0 * t10, 6.0 * t5, 5.0 * t5, 3.0 * tan_a / math.sqrt((4.0 / 3.0) + (4.0 / 3.0) * tan_a_squared)


@kernel(
    paths.volume_of_four_wheels,
    Specification(
        paper='ignatov2005',
        name='volume_of_four_wheels',
        says='Volume of the envelope of four wheels.',
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('b', 'angle of the side edges in the plane OXY', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('volume', 'volume', unit='units of h_max^3'),
        ),
        ulp=8,
        condition='A product of three or five sines and cosines: rounding a tangent counts twice in sin^2 a.',
        claims={
            'ignatov2005:B.3': '54617108b327',
        },
        forms='75080f897402',
    ),
)
def volume_of_four_wheels(a, b):
    """Volume of the envelope of four wheels.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    b : float or ndarray
        Angle of the side edges in the plane OXY, in rad; 0 < b < pi/2.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    volume : float or ndarray
        Volume, in units of h_max^3.

    Notes
    -----
    The function computes ::

        volume = 128*sin(a)**2*sin(b)*cos(a)*cos(b)

    Accuracy: 8 ulp over the domain. A product of three or five sines and cosines: rounding a tangent counts twice
    in sin^2 a.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:B.3 (sha256 54617108b327). The forms computed are proved equal to those shown (sha256
    75080f897402).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import volume_of_four_wheels
    >>> f"{volume_of_four_wheels(0.52, 1.05):.6g}"
    '11.8366'
    """
    tan_a = math.tan(a)
    tan_b = math.tan(b)
    t10 = 128.0 * (tan_a * tan_b) / ((1.0 / tan_a + tan_a) * (math.sqrt(1.0 + tan_a * tan_a) * (1.0 + tan_b * tan_b)))
    return t10


@kernel(
    paths.volume_of_three_wheels,
    Specification(
        paper='ignatov2005',
        name='volume_of_three_wheels',
        says='Volume of the envelope of four wheels of which the last has failed.',
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('b', 'angle of the side edges in the plane OXY', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('volume', 'volume', unit='units of h_max^3'),
        ),
        ulp=8,
        condition='A product of three or five sines and cosines: rounding a tangent counts twice in sin^2 a.',
        claims={
            'ignatov2005:B.13': 'aedd01b78464',
        },
        forms='08c0ec53b77c',
    ),
)
def volume_of_three_wheels(a, b):
    """Volume of the envelope of four wheels of which the last has failed.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    b : float or ndarray
        Angle of the side edges in the plane OXY, in rad; 0 < b < pi/2.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    volume : float or ndarray
        Volume, in units of h_max^3.

    Notes
    -----
    The function computes ::

        volume = 32*sin(a)**2*sin(b)*cos(a)*cos(b)

    Accuracy: 8 ulp over the domain. A product of three or five sines and cosines: rounding a tangent counts twice
    in sin^2 a.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:B.13 (sha256 aedd01b78464). The forms computed are proved equal to those shown (sha256
    08c0ec53b77c).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import volume_of_three_wheels
    >>> f"{volume_of_three_wheels(0.52, 1.05):.6g}"
    '2.95916'
    """
    tan_a = math.tan(a)
    tan_b = math.tan(b)
    t10 = 32.0 * (tan_a * tan_b) / ((1.0 / tan_a + tan_a) * (math.sqrt(1.0 + tan_a * tan_a) * (1.0 + tan_b * tan_b)))
    return t10


@kernel(
    paths.volume_of_six_wheels,
    Specification(
        paper='ignatov2005',
        name='volume_of_six_wheels',
        says='Volume of the envelope of six wheels.',
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('volume', 'volume', unit='units of h_max^3'),
        ),
        ulp=8,
        condition='A product of three or five sines and cosines: rounding a tangent counts twice in sin^2 a.',
        claims={
            'ignatov2005:B.25': 'afc28669e24e',
        },
        forms='80a5ee158594',
    ),
)
def volume_of_six_wheels(a):
    """Volume of the envelope of six wheels.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    volume : float or ndarray
        Volume, in units of h_max^3.

    Notes
    -----
    The function computes ::

        volume = 144*sqrt(3)*sin(a)**2*cos(a)

    Accuracy: 8 ulp over the domain. A product of three or five sines and cosines: rounding a tangent counts twice
    in sin^2 a.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:B.25 (sha256 afc28669e24e). The forms computed are proved equal to those shown (sha256
    80a5ee158594).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import volume_of_six_wheels
    >>> f"{volume_of_six_wheels(0.79):.6g}"
    '88.5827'
    """
    tan_a = math.tan(a)
    t8 = 144.0 * tan_a / (math.sqrt((1.0 / 3.0) + (1.0 / 3.0) * (tan_a * tan_a)) * (1.0 / tan_a + tan_a))
    return t8


@kernel(
    paths.volume_of_five_wheels,
    Specification(
        paper='ignatov2005',
        name='volume_of_five_wheels',
        says='Volume of the envelope of six wheels of which the last has failed.',
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
        ),
        outputs=(
            Output('volume', 'volume', unit='units of h_max^3'),
        ),
        ulp=8,
        condition='A product of three or five sines and cosines: rounding a tangent counts twice in sin^2 a.',
        claims={
            'ignatov2005:B.35': '87fe4711f136',
        },
        forms='e58d699f0587',
    ),
)
def volume_of_five_wheels(a):
    """Volume of the envelope of six wheels of which the last has failed.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    volume : float or ndarray
        Volume, in units of h_max^3.

    Notes
    -----
    The function computes ::

        volume = 72*sqrt(3)*sin(a)**2*cos(a)

    Accuracy: 8 ulp over the domain. A product of three or five sines and cosines: rounding a tangent counts twice
    in sin^2 a.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:B.35 (sha256 87fe4711f136). The forms computed are proved equal to those shown (sha256
    e58d699f0587).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import volume_of_five_wheels
    >>> f"{volume_of_five_wheels(0.79):.6g}"
    '44.2914'
    """
    tan_a = math.tan(a)
    t8 = 72.0 * tan_a / (math.sqrt((1.0 / 3.0) + (1.0 / 3.0) * (tan_a * tan_a)) * (1.0 / tan_a + tan_a))
    return t8


@kernel(
    paths.largest_rates_of_four_wheels,
    Specification(
        paper='ignatov2005',
        name='largest_rates_of_four_wheels',
        says='Largest angular rates about each axis alone that four wheels can give a body, in absolute value.',
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('b', 'angle of the side edges in the plane OXY', unit='rad', low='0', high='pi/2'),
            Argument('J_x', 'moment of inertia about OX', unit='kg m^2', low='0'),
            Argument('J_y', 'moment of inertia about OY', unit='kg m^2', low='0'),
            Argument('J_z', 'moment of inertia about OZ', unit='kg m^2', low='0'),
        ),
        outputs=(
            Output('w_x', 'largest angular rate about OX', unit='units of h_max/(kg m^2)'),
            Output('w_y', 'largest angular rate about OY', unit='units of h_max/(kg m^2)'),
            Output('w_z', 'largest angular rate about OZ', unit='units of h_max/(kg m^2)'),
        ),
        ulp=6,
        condition='Tangents of two angles, a root and a quotient are rounded one after the other.',
        claims={
            'ignatov2005:2.3.2': '5e8b7ff65c34',
            'ignatov2005:2.3.3': 'fbeef966f1d7',
            'ignatov2005:2.3.4': '1914201561bb',
            'ignatov2005:2.3': '57003d67dcfa',
        },
    ),
)
def largest_rates_of_four_wheels(a, b, J_x, J_y, J_z):
    """Largest angular rates about each axis alone that four wheels can give a body, in absolute value.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    b : float or ndarray
        Angle of the side edges in the plane OXY, in rad; 0 < b < pi/2.
    J_x : float or ndarray
        Moment of inertia about OX, in kg m^2; 0 < J_x.
    J_y : float or ndarray
        Moment of inertia about OY, in kg m^2; 0 < J_y.
    J_z : float or ndarray
        Moment of inertia about OZ, in kg m^2; 0 < J_z.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    w_x : float or ndarray
        Largest angular rate about OX, in units of h_max/(kg m^2).
    w_y : float or ndarray
        Largest angular rate about OY, in units of h_max/(kg m^2).
    w_z : float or ndarray
        Largest angular rate about OZ, in units of h_max/(kg m^2).

    Notes
    -----
    The function computes ::

        w_x = 4*sin(a)*sin(b)/J_x
        w_y = 4*sin(a)*cos(b)/J_y
        w_z = 4*cos(a)/J_z

    Accuracy: 6 ulp over the domain. Tangents of two angles, a root and a quotient are rounded one after the
    other.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:2.3.2 (sha256 5e8b7ff65c34), ignatov2005:2.3.3 (sha256 fbeef966f1d7), ignatov2005:2.3.4
    (sha256 1914201561bb), ignatov2005:2.3 (sha256 57003d67dcfa).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import largest_rates_of_four_wheels
    >>> [f"{x:.6g}" for x in largest_rates_of_four_wheels(0.26, 0.52, 0.5, 0.67, 0.83)]
    ['1.02191', '1.33194', '4.6573']
    """
    t1 = 4.0 * math.sin(a)
    return math.sin(b) * t1 / J_x, math.cos(b) * t1 / J_y, 4.0 * math.cos(a) / J_z


@kernel(
    paths.largest_rates_of_six_wheels,
    Specification(
        paper='ignatov2005',
        name='largest_rates_of_six_wheels',
        says='Largest angular rates about each axis alone that six wheels can give a body, in absolute value.',
        arguments=(
            Argument('a', 'angle between the axis of a wheel and OZ', unit='rad', low='0', high='pi/2'),
            Argument('J_x', 'moment of inertia about OX', unit='kg m^2', low='0'),
            Argument('J_y', 'moment of inertia about OY', unit='kg m^2', low='0'),
            Argument('J_z', 'moment of inertia about OZ', unit='kg m^2', low='0'),
        ),
        outputs=(
            Output('w_x', 'largest angular rate about OX', unit='units of h_max/(kg m^2)'),
            Output('w_y', 'largest angular rate about OY', unit='units of h_max/(kg m^2)'),
            Output('w_z', 'largest angular rate about OZ', unit='units of h_max/(kg m^2)'),
        ),
        ulp=4,
        claims={
            'ignatov2005:3.2.26': '32f7d6819c02',
            'ignatov2005:3.2.27': '2037c978fcea',
            'ignatov2005:3.2.28': '910d9ae68049',
            'ignatov2005:2.3': '57003d67dcfa',
        },
    ),
)
def largest_rates_of_six_wheels(a, J_x, J_y, J_z):
    """Largest angular rates about each axis alone that six wheels can give a body, in absolute value.

    Parameters
    ----------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad; 0 < a < pi/2.
    J_x : float or ndarray
        Moment of inertia about OX, in kg m^2; 0 < J_x.
    J_y : float or ndarray
        Moment of inertia about OY, in kg m^2; 0 < J_y.
    J_z : float or ndarray
        Moment of inertia about OZ, in kg m^2; 0 < J_z.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    w_x : float or ndarray
        Largest angular rate about OX, in units of h_max/(kg m^2).
    w_y : float or ndarray
        Largest angular rate about OY, in units of h_max/(kg m^2).
    w_z : float or ndarray
        Largest angular rate about OZ, in units of h_max/(kg m^2).

    Notes
    -----
    The function computes ::

        w_x = 2*sqrt(3)*sin(a)/J_x
        w_y = 4*sin(a)/J_y
        w_z = 6*cos(a)/J_z

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:3.2.26 (sha256 32f7d6819c02), ignatov2005:3.2.27 (sha256 2037c978fcea),
    ignatov2005:3.2.28 (sha256 910d9ae68049), ignatov2005:2.3 (sha256 57003d67dcfa).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import largest_rates_of_six_wheels
    >>> [f"{x:.6g}" for x in largest_rates_of_six_wheels(0.31, 0.4, 0.6, 0.8)]
    ['2.64189', '2.03372', '7.1425']
    """
    sin_a = math.sin(a)
    return 2.0 * (sin_a * math.sqrt(3.0)) / J_x, 4.0 * sin_a / J_y, 6.0 * math.cos(a) / J_z


@kernel(
    paths.equal_rates_of_four_wheels,
    Specification(
        paper='ignatov2005',
        name='equal_rates_of_four_wheels',
        says='Angles of four wheels with which the largest angular rates about OX, OY and OZ are equal.',
        arguments=(
            Argument('J_x', 'moment of inertia about OX', unit='kg m^2', low='0'),
            Argument('J_y', 'moment of inertia about OY', unit='kg m^2', low='0'),
            Argument('J_z', 'moment of inertia about OZ', unit='kg m^2', low='0'),
        ),
        outputs=(
            Output('a', 'angle between the axis of a wheel and OZ', unit='rad'),
            Output('b', 'angle of the side edges in the plane OXY', unit='rad'),
            Output('w', 'largest angular rate about each of the three axes', unit='units of h_max/(kg m^2)'),
            Output('w_any', 'largest angular rate that is had about every axis, whatever its direction', unit='units of h_max/(kg m^2)'),
        ),
        ulp=4,
        degenerate='If the squares of the moments satisfy the triangle inequalities, no angles give a greater rate w_any.',
        claims={
            'ignatov2005:B.16': 'd7a5333dadbc',
            'ignatov2005:B.17': '4955b8956930',
            'ignatov2005:B.18': '0d3daf682064',
            'ignatov2005:B.19': 'b13534e6844f',
        },
    ),
)
def equal_rates_of_four_wheels(J_x, J_y, J_z):
    """Angles of four wheels with which the largest angular rates about OX, OY and OZ are equal.

    Parameters
    ----------
    J_x : float or ndarray
        Moment of inertia about OX, in kg m^2; 0 < J_x.
    J_y : float or ndarray
        Moment of inertia about OY, in kg m^2; 0 < J_y.
    J_z : float or ndarray
        Moment of inertia about OZ, in kg m^2; 0 < J_z.
    out : sequence of ndarray, optional
        4 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad.
    b : float or ndarray
        Angle of the side edges in the plane OXY, in rad.
    w : float or ndarray
        Largest angular rate about each of the three axes, in units of h_max/(kg m^2).
    w_any : float or ndarray
        Largest angular rate that is had about every axis, whatever its direction, in units of h_max/(kg m^2).

    Notes
    -----
    The function computes ::

        a = atan(sqrt(J_x**2 + J_y**2)/J_z)
        b = atan(J_x/J_y)
        w = 4/sqrt(J_x**2 + J_y**2 + J_z**2)
        w_any = 2*sqrt(2)/sqrt(J_x**2 + J_y**2 + J_z**2)

    Accuracy: 4 ulp over the domain. If the squares of the moments satisfy the triangle inequalities, no angles
    give a greater rate w_any.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:B.16 (sha256 d7a5333dadbc), ignatov2005:B.17 (sha256 4955b8956930), ignatov2005:B.18
    (sha256 0d3daf682064), ignatov2005:B.19 (sha256 b13534e6844f).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import equal_rates_of_four_wheels
    >>> [f"{x:.6g}" for x in equal_rates_of_four_wheels(0.25, 0.5, 0.75)]
    ['0.640522', '0.463648', '4.27618', '3.02372']
    """
    t1 = J_x * J_x + J_y * J_y
    t4 = 1.0 / math.sqrt(J_z * J_z + t1)
    return math.atan(math.sqrt(t1) / J_z), math.atan(J_x / J_y), 4.0 * t4, 2.0 * (math.sqrt(2.0) * t4)


@kernel(
    paths.equal_rates_of_six_wheels,
    Specification(
        paper='ignatov2005',
        name='equal_rates_of_six_wheels',
        says='Angle of six wheels with which the largest angular rates about OY and OZ are equal, and the largest rates.',
        arguments=(
            Argument('J_x', 'moment of inertia about OX', unit='kg m^2', low='0'),
            Argument('J_y', 'moment of inertia about OY', unit='kg m^2', low='0'),
            Argument('J_z', 'moment of inertia about OZ', unit='kg m^2', low='0'),
        ),
        outputs=(
            Output('a', 'angle between the axis of a wheel and OZ', unit='rad'),
            Output('w_x', 'largest angular rate about OX', unit='units of h_max/(kg m^2)'),
            Output('w_y', 'largest angular rate about OY, and about OZ', unit='units of h_max/(kg m^2)'),
        ),
        ulp=5,
        condition='The square root of 3 is rounded too.',
        claims={
            'ignatov2005:3.2.26': '32f7d6819c02',
            'ignatov2005:3.2.27': '2037c978fcea',
            'ignatov2005:3.2.28': '910d9ae68049',
            'ignatov2005:3.2.30': '70178405b3c5',
        },
    ),
)
def equal_rates_of_six_wheels(J_x, J_y, J_z):
    """Angle of six wheels with which the largest angular rates about OY and OZ are equal, and the largest rates.

    Parameters
    ----------
    J_x : float or ndarray
        Moment of inertia about OX, in kg m^2; 0 < J_x.
    J_y : float or ndarray
        Moment of inertia about OY, in kg m^2; 0 < J_y.
    J_z : float or ndarray
        Moment of inertia about OZ, in kg m^2; 0 < J_z.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad.
    w_x : float or ndarray
        Largest angular rate about OX, in units of h_max/(kg m^2).
    w_y : float or ndarray
        Largest angular rate about OY, and about OZ, in units of h_max/(kg m^2).

    Notes
    -----
    The function computes ::

        a = atan(3*J_y/(2*J_z))
        w_x = 6*sqrt(3)*J_y/(J_x*sqrt(9*J_y**2 + 4*J_z**2))
        w_y = 12/sqrt(9*J_y**2 + 4*J_z**2)

    Accuracy: 5 ulp over the domain. The square root of 3 is rounded too.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:3.2.26 (sha256 32f7d6819c02), ignatov2005:3.2.27 (sha256 2037c978fcea),
    ignatov2005:3.2.28 (sha256 910d9ae68049), ignatov2005:3.2.30 (sha256 70178405b3c5).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import equal_rates_of_six_wheels
    >>> [f"{x:.6g}" for x in equal_rates_of_six_wheels(0.25, 0.5, 0.75)]
    ['0.785398', '9.79796', '5.65685']
    """
    t5 = 1.0 / math.sqrt(9.0 * (J_y * J_y) + 4.0 * (J_z * J_z))
    return math.atan((3.0 / 2.0) * J_y / J_z), 6.0 * (math.sqrt(3.0) * (J_y * t5)) / J_x, 12.0 * t5


@kernel(
    paths.best_angles_of_four_wheels,
    Specification(
        paper='ignatov2005',
        name='best_angles_of_four_wheels',
        says='Angles of four wheels with the greatest angular rate about every axis, for J_y^2 >= J_x^2 + J_z^2.',
        arguments=(
            Argument('J_x', 'moment of inertia about OX', unit='kg m^2', low='0'),
            Argument('J_y', 'moment of inertia about OY', unit='kg m^2', low='0'),
            Argument('J_z', 'moment of inertia about OZ', unit='kg m^2', low='0'),
        ),
        outputs=(
            Output('a', 'angle between the axis of a wheel and OZ', unit='rad'),
            Output('b', 'angle of the side edges in the plane OXY', unit='rad'),
            Output('w', 'largest angular rate that is had about every axis, whatever its direction', unit='units of h_max/(kg m^2)'),
        ),
        ulp=4,
        claims={
            'ignatov2005:B.20': 'ea69c53a240d',
            'ignatov2005:B.21': '4c0bc2be9001',
        },
    ),
)
def best_angles_of_four_wheels(J_x, J_y, J_z):
    """Angles of four wheels with the greatest angular rate about every axis, for J_y^2 >= J_x^2 + J_z^2.

    Parameters
    ----------
    J_x : float or ndarray
        Moment of inertia about OX, in kg m^2; 0 < J_x.
    J_y : float or ndarray
        Moment of inertia about OY, in kg m^2; 0 < J_y.
    J_z : float or ndarray
        Moment of inertia about OZ, in kg m^2; 0 < J_z.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad.
    b : float or ndarray
        Angle of the side edges in the plane OXY, in rad.
    w : float or ndarray
        Largest angular rate that is had about every axis, whatever its direction, in units of h_max/(kg m^2).

    Notes
    -----
    The function computes ::

        a = atan(sqrt(J_x**2 + J_y*sqrt(J_x**2 + J_z**2))/J_z)
        b = atan(J_x/(sqrt(J_y)*(J_x**2 + J_z**2)**(1/4)))
        w = 4/(J_y + sqrt(J_x**2 + J_z**2))

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:B.20 (sha256 ea69c53a240d), ignatov2005:B.21 (sha256 4c0bc2be9001).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import best_angles_of_four_wheels
    >>> [f"{x:.6g}" for x in best_angles_of_four_wheels(0.25, 0.5, 0.75)]
    ['0.733991', '0.378466', '3.09941']
    """
    J_x_squared = J_x * J_x
    t1 = J_x_squared + J_z * J_z
    t2 = math.sqrt(t1)
    return math.atan(math.sqrt(J_x_squared + J_y * t2) / J_z), math.atan(J_x / (math.sqrt(J_y) * math.pow(t1, 1.0 / 4.0))), 4.0 / (J_y + t2)


@kernel(
    paths.best_angle_of_six_wheels,
    Specification(
        paper='ignatov2005',
        name='best_angle_of_six_wheels',
        says='Angle of six wheels at which the face F_8 of the envelope allows the greatest angular rate about every axis.',
        arguments=(
            Argument('J_y', 'moment of inertia about OY', unit='kg m^2', low='0'),
            Argument('J_z', 'moment of inertia about OZ', unit='kg m^2', low='0'),
        ),
        outputs=(
            Output('a', 'angle between the axis of a wheel and OZ', unit='rad'),
            Output('w', 'largest angular rate that this face allows about every axis, whatever its direction', unit='units of h_max/(kg m^2)'),
        ),
        ulp=4,
        degenerate='The other faces have to allow this rate too; for moments of 1000, 1600 and 800 kg m^2 they do.',
        claims={
            'ignatov2005:B.38': 'a94786f889f4',
            'ignatov2005:B.39': '7f57aa82a899',
            'ignatov2005:B.40': 'cc848f2c1c52',
        },
    ),
)
def best_angle_of_six_wheels(J_y, J_z):
    """Angle of six wheels at which the face F_8 of the envelope allows the greatest angular rate about every axis.

    Parameters
    ----------
    J_y : float or ndarray
        Moment of inertia about OY, in kg m^2; 0 < J_y.
    J_z : float or ndarray
        Moment of inertia about OZ, in kg m^2; 0 < J_z.
    out : sequence of ndarray, optional
        2 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    a : float or ndarray
        Angle between the axis of a wheel and OZ, in rad.
    w : float or ndarray
        Largest angular rate that this face allows about every axis, whatever its direction, in units of
        h_max/(kg m^2).

    Notes
    -----
    The function computes ::

        a = atan(sqrt(2)*sqrt(J_y/J_z))
        w = 8/(2*J_y + J_z)

    Accuracy: 4 ulp over the domain. The other faces have to allow this rate too; for moments of 1000, 1600 and
    800 kg m^2 they do.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on ignatov2005:B.38 (sha256 a94786f889f4), ignatov2005:B.39 (sha256 7f57aa82a899), ignatov2005:B.40
    (sha256 cc848f2c1c52).

    Examples
    --------
    >>> from symcheck.generated.ignatov2005 import best_angle_of_six_wheels
    >>> [f"{x:.6g}" for x in best_angle_of_six_wheels(0.33, 0.67)]
    ['0.781639', '6.01504']
    """
    return math.atan(math.sqrt(2.0) * math.sqrt(J_y / J_z)), 8.0 / (J_z + 2.0 * J_y)


KERNELS = {
    "axes_of_four_wheels": axes_of_four_wheels,
    "axes_of_six_wheels": axes_of_six_wheels,
    "momentum_of_four_wheels": momentum_of_four_wheels,
    "momentum_of_three_wheels": momentum_of_three_wheels,
    "momentum_of_six_wheels": momentum_of_six_wheels,
    "momentum_of_five_wheels": momentum_of_five_wheels,
    "rates_of_four_wheels": rates_of_four_wheels,
    "rates_of_three_wheels": rates_of_three_wheels,
    "rates_of_six_wheels": rates_of_six_wheels,
    "rates_of_five_wheels": rates_of_five_wheels,
    "vertices_of_four_wheels": vertices_of_four_wheels,
    "vertices_of_three_wheels": vertices_of_three_wheels,
    "vertices_of_six_wheels": vertices_of_six_wheels,
    "vertices_of_five_wheels": vertices_of_five_wheels,
    "vertex_distances_of_four_wheels": vertex_distances_of_four_wheels,
    "vertex_distances_of_three_wheels": vertex_distances_of_three_wheels,
    "vertex_distances_of_six_wheels": vertex_distances_of_six_wheels,
    "vertex_distances_of_five_wheels": vertex_distances_of_five_wheels,
    "face_distances_of_four_wheels": face_distances_of_four_wheels,
    "face_distances_of_three_wheels": face_distances_of_three_wheels,
    "face_distances_of_six_wheels": face_distances_of_six_wheels,
    "face_distances_of_five_wheels": face_distances_of_five_wheels,
    "volume_of_four_wheels": volume_of_four_wheels,
    "volume_of_three_wheels": volume_of_three_wheels,
    "volume_of_six_wheels": volume_of_six_wheels,
    "volume_of_five_wheels": volume_of_five_wheels,
    "largest_rates_of_four_wheels": largest_rates_of_four_wheels,
    "largest_rates_of_six_wheels": largest_rates_of_six_wheels,
    "equal_rates_of_four_wheels": equal_rates_of_four_wheels,
    "equal_rates_of_six_wheels": equal_rates_of_six_wheels,
    "best_angles_of_four_wheels": best_angles_of_four_wheels,
    "best_angle_of_six_wheels": best_angle_of_six_wheels,
}
