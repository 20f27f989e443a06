"""Kernels of ignatov2005. Written by `symcheck generate`: what is changed here is lost."""

from math import atan, cos, pow, sin, sqrt, tan

from symcheck.kernels.runtime import Argument, Output, for_arrays, kernel

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
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("b", "angle of the side edges in the plane OXY", "rad", low="0", high="pi/2"),
    Output("e_1x", "x of e_1"),
    Output("e_1y", "y of e_1"),
    Output("e_1z", "z of e_1"),
    Output("e_2x", "x of e_2"),
    Output("e_2y", "y of e_2"),
    Output("e_2z", "z of e_2"),
    Output("e_3x", "x of e_3"),
    Output("e_3y", "y of e_3"),
    Output("e_3z", "z of e_3"),
    Output("e_4x", "x of e_4"),
    Output("e_4y", "y of e_4"),
    Output("e_4z", "z of e_4"),
    ulp=6,
    condition="Tangents of two angles, a root and a quotient are rounded one after the other.",
    claims={"2.0.1": "4aa675013ce7", "2.0.3": "1c82bd5484cb", "2.0.5": "22085680dfdc"},
)
def axes_of_four_wheels(a, b):
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

    >>> [f"{x:.6g}" for x in axes_of_four_wheels(0.52, 1.05)]  # doctest: +NORMALIZE_WHITESPACE
    ['0.431005', '-0.247233', '-0.867819', '0.431005', '0.247233', '-0.867819', '0.431005', '-0.247233', '0.867819',
     '0.431005', '0.247233', '0.867819']
    """
    sin_a = sin(a)
    t1 = sin_a * sin(b)
    t2 = cos(b) * sin_a
    t3 = -t2
    cos_a = cos(a)
    t4 = -cos_a
    return t1, t3, t4, t1, t2, t4, t1, t3, cos_a, t1, t2, cos_a


@for_arrays(axes_of_four_wheels)
def _axes_of_four_wheels(a, b):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    tan_a = tan(a)
    t1 = 1.0 + tan_a * tan_a
    tan_b = tan(b)
    t6 = sqrt(t1 * (1.0 + tan_b * tan_b))
    t8 = tan_a * tan_b / t6
    t9 = tan_a / t6
    t10 = -t9
    t11 = 1.0 / sqrt(t1)
    t12 = -t11
    return t8, t10, t12, t8, t9, t12, t8, t10, t11, t8, t9, t11


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Output("e_1y", "y of e_1"),
    Output("e_1z", "z of e_1"),
    Output("e_2x", "x of e_2"),
    Output("e_2y", "y of e_2"),
    Output("e_2z", "z of e_2"),
    Output("e_3x", "x of e_3"),
    Output("e_3y", "y of e_3"),
    Output("e_3z", "z of e_3"),
    Output("e_4y", "y of e_4"),
    Output("e_4z", "z of e_4"),
    Output("e_5x", "x of e_5"),
    Output("e_5y", "y of e_5"),
    Output("e_5z", "z of e_5"),
    Output("e_6x", "x of e_6"),
    Output("e_6y", "y of e_6"),
    Output("e_6z", "z of e_6"),
    ulp=4,
    claims={"3.0.3": "90b688855734", "3.0.5": "881325f58b02", "3.0.6": "55b7b4360f8d"},
)
def axes_of_six_wheels(a):
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

    >>> [f"{x:.6g}" for x in axes_of_six_wheels(0.79)]  # doctest: +NORMALIZE_WHITESPACE
    ['-0.710353', '0.703845', '0.615184', '-0.355177', '0.703845', '0.615184', '0.355177', '0.703845', '-0.710353',
     '-0.703845', '0.615184', '-0.355177', '-0.703845', '0.615184', '0.355177', '-0.703845']
    """
    sin_a = sin(a)
    t1 = -sin_a
    cos_a = cos(a)
    t2 = (1.0 / 2.0) * sin_a
    t3 = sqrt(3.0) * t2
    t4 = -t2
    t5 = -cos_a
    return t1, cos_a, t3, t4, cos_a, t3, t2, cos_a, t1, t5, t3, t4, t5, t3, t2, t5


@for_arrays(axes_of_six_wheels)
def _axes_of_six_wheels(a):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    tan_a = tan(a)
    t2 = sqrt(1.0 + tan_a * tan_a)
    t4 = -(tan_a / t2)
    t5 = 1.0 / t2
    t7 = (1.0 / 2.0) * tan_a / t2
    t8 = sqrt(3.0) * t7
    t9 = -t7
    t10 = -t5
    return t4, t5, t8, t9, t5, t8, t7, t5, t4, t10, t8, t9, t10, t8, t7, t10


@kernel(
    Argument("h_1", "momentum of wheel 1", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_2", "momentum of wheel 2", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_3", "momentum of wheel 3", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_4", "momentum of wheel 4", "units of h_max", low="-1", high="1", closed=True),
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("b", "angle of the side edges in the plane OXY", "rad", low="0", high="pi/2"),
    Output("H_x", "momentum along OX", "units of h_max"),
    Output("H_y", "momentum along OY", "units of h_max"),
    Output("H_z", "momentum along OZ", "units of h_max"),
    ulp=8,
    condition="Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i.",
    claims={"2.1.2": "6aba2017cbeb"},
)
def momentum_of_four_wheels(h_1, h_2, h_3, h_4, a, b):
    """Total momentum of four wheels.

    H_x = (h_1 + h_2 + h_3 + h_4)*sin(a)*sin(b)
    H_y = (-h_1 + h_2 - h_3 + h_4)*sin(a)*cos(b)
    H_z = (-h_1 - h_2 + h_3 + h_4)*cos(a)

    >>> [f"{x:.6g}" for x in momentum_of_four_wheels(-0.71, -0.43, -0.14, 0.14, 1.12, 1.35)]
    ['-1.0012', '0.110392', '0.496678']
    """
    sin_a = sin(a)
    t1 = h_1 + h_3
    t2 = -h_4
    H_x = sin(b) * (sin_a * (t1 + (h_2 + h_4)))
    H_y = cos(b) * (sin_a * (h_2 - t1 - t2))
    H_z = cos(a) * (h_3 - h_1 - h_2 - t2)
    return H_x, H_y, H_z


@for_arrays(momentum_of_four_wheels)
def _momentum_of_four_wheels(h_1, h_2, h_3, h_4, a, b):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    tan_a = tan(a)
    t1 = 1.0 + tan_a * tan_a
    t4 = h_1 + h_3
    t5 = -h_4
    tan_b = tan(b)
    t10 = sqrt(t1 * (1.0 + tan_b * tan_b))
    H_x = (t4 + (h_2 + h_4)) * tan_a * tan_b / t10
    H_y = (h_2 - t4 - t5) * tan_a / t10
    H_z = (h_3 - h_1 - h_2 - t5) / sqrt(t1)
    return H_x, H_y, H_z


@kernel(
    Argument("h_1", "momentum of wheel 1", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_2", "momentum of wheel 2", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_3", "momentum of wheel 3", "units of h_max", low="-1", high="1", closed=True),
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("b", "angle of the side edges in the plane OXY", "rad", low="0", high="pi/2"),
    Output("H_x", "momentum along OX", "units of h_max"),
    Output("H_y", "momentum along OY", "units of h_max"),
    Output("H_z", "momentum along OZ", "units of h_max"),
    ulp=8,
    condition="Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i.",
    claims={"2.2.1": "a4e05c48da78"},
)
def momentum_of_three_wheels(h_1, h_2, h_3, a, b):
    """Total momentum of four wheels of which the last has failed.

    H_x = (h_1 + h_2 + h_3)*sin(a)*sin(b)
    H_y = (-h_1 + h_2 - h_3)*sin(a)*cos(b)
    H_z = (-h_1 - h_2 + h_3)*cos(a)

    >>> [f"{x:.6g}" for x in momentum_of_three_wheels(-0.67, -0.33, 0.0, 1.05, 1.31)]
    ['-0.838091', '0.0760461', '0.497571']
    """
    sin_a = sin(a)
    t1 = h_1 + h_3
    H_x = sin(b) * (sin_a * (h_2 + t1))
    H_y = cos(b) * (sin_a * (h_2 - t1))
    H_z = cos(a) * (h_3 - h_1 - h_2)
    return H_x, H_y, H_z


@for_arrays(momentum_of_three_wheels)
def _momentum_of_three_wheels(h_1, h_2, h_3, a, b):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    tan_a = tan(a)
    t1 = 1.0 + tan_a * tan_a
    t4 = h_1 + h_3
    tan_b = tan(b)
    t8 = sqrt(t1 * (1.0 + tan_b * tan_b))
    H_x = (h_2 + t4) * tan_a * tan_b / t8
    H_y = (h_2 - t4) * tan_a / t8
    H_z = (h_3 - h_1 - h_2) / sqrt(t1)
    return H_x, H_y, H_z


@kernel(
    Argument("h_1", "momentum of wheel 1", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_2", "momentum of wheel 2", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_3", "momentum of wheel 3", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_4", "momentum of wheel 4", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_5", "momentum of wheel 5", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_6", "momentum of wheel 6", "units of h_max", low="-1", high="1", closed=True),
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Output("H_x", "momentum along OX", "units of h_max"),
    Output("H_y", "momentum along OY", "units of h_max"),
    Output("H_z", "momentum along OZ", "units of h_max"),
    ulp=8,
    condition="Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i.",
    claims={"3.1.2": "8758872a0c67"},
)
def momentum_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a):
    """Total momentum of six wheels.

    H_x = sqrt(3)*(h_2 + h_3 + h_5 + h_6)*sin(a)/2
    H_y = (-2*h_1 - h_2 + h_3 - 2*h_4 - h_5 + h_6)*sin(a)/2
    H_z = (h_1 + h_2 + h_3 - h_4 - h_5 - h_6)*cos(a)

    >>> [f"{x:.6g}" for x in momentum_of_six_wheels(-0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 1.37)]
    ['0', '0.979908', '-0.448762']
    """
    t1 = h_2 + h_5
    t2 = (1.0 / 2.0) * sin(a)
    t3 = -h_6
    H_x = (t1 + (h_3 + h_6)) * (sqrt(3.0) * t2)
    H_y = (h_3 - 2.0 * h_1 - 2.0 * h_4 - t1 - t3) * t2
    H_z = cos(a) * (h_3 + (h_1 + h_2) + t3 - h_4 - h_5)
    return H_x, H_y, H_z


@for_arrays(momentum_of_six_wheels)
def _momentum_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    t1 = h_2 + h_5
    tan_a = tan(a)
    t3 = sqrt(1.0 + tan_a * tan_a)
    t5 = (1.0 / 2.0) * tan_a / t3
    t6 = -h_6
    H_x = (t1 + (h_3 + h_6)) * (sqrt(3.0) * t5)
    H_y = (h_3 - 2.0 * h_1 - 2.0 * h_4 - t1 - t6) * t5
    H_z = (h_3 + (h_1 + h_2) + t6 - h_4 - h_5) / t3
    return H_x, H_y, H_z


@kernel(
    Argument("h_1", "momentum of wheel 1", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_2", "momentum of wheel 2", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_3", "momentum of wheel 3", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_4", "momentum of wheel 4", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_5", "momentum of wheel 5", "units of h_max", low="-1", high="1", closed=True),
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Output("H_x", "momentum along OX", "units of h_max"),
    Output("H_y", "momentum along OY", "units of h_max"),
    Output("H_z", "momentum along OZ", "units of h_max"),
    ulp=8,
    condition="Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i.",
    claims={"3.2.1": "d524ffea3256"},
)
def momentum_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a):
    """Total momentum of six wheels of which the last has failed.

    H_x = sqrt(3)*(h_2 + h_3 + h_5)*sin(a)/2
    H_y = (-2*h_1 - h_2 + h_3 - 2*h_4 - h_5)*sin(a)/2
    H_z = (h_1 + h_2 + h_3 - h_4 - h_5)*cos(a)

    >>> [f"{x:.6g}" for x in momentum_of_five_wheels(-0.71, -0.43, -0.14, 0.14, 0.43, 1.35)]
    ['-0.1183', '0.487862', '-0.405162']
    """
    t1 = h_2 + h_5
    t2 = (1.0 / 2.0) * sin(a)
    H_x = (h_3 + t1) * (sqrt(3.0) * t2)
    H_y = (h_3 - 2.0 * h_1 - 2.0 * h_4 - t1) * t2
    H_z = cos(a) * (h_3 + (h_1 + h_2) - h_4 - h_5)
    return H_x, H_y, H_z


@for_arrays(momentum_of_five_wheels)
def _momentum_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    t1 = h_2 + h_5
    tan_a = tan(a)
    t3 = sqrt(1.0 + tan_a * tan_a)
    t5 = (1.0 / 2.0) * tan_a / t3
    H_x = (h_3 + t1) * (sqrt(3.0) * t5)
    H_y = (h_3 - 2.0 * h_1 - 2.0 * h_4 - t1) * t5
    H_z = (h_3 + (h_1 + h_2) - h_4 - h_5) / t3
    return H_x, H_y, H_z


@kernel(
    Argument("h_1", "momentum of wheel 1", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_2", "momentum of wheel 2", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_3", "momentum of wheel 3", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_4", "momentum of wheel 4", "units of h_max", low="-1", high="1", closed=True),
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("b", "angle of the side edges in the plane OXY", "rad", low="0", high="pi/2"),
    Argument("J_x", "moment of inertia about OX", "kg m^2", low="0"),
    Argument("J_y", "moment of inertia about OY", "kg m^2", low="0"),
    Argument("J_z", "moment of inertia about OZ", "kg m^2", low="0"),
    Output("w_x", "angular rate about OX", "units of h_max/(kg m^2)"),
    Output("w_y", "angular rate about OY", "units of h_max/(kg m^2)"),
    Output("w_z", "angular rate about OZ", "units of h_max/(kg m^2)"),
    ulp=8,
    condition="Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i.",
    claims={"2.1.2": "6aba2017cbeb", "2.3": "57003d67dcfa"},
)
def rates_of_four_wheels(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z):
    """Angular rates of a body, at rest with its wheels at rest, that four wheels give it.

    w_x = -(h_1 + h_2 + h_3 + h_4)*sin(a)*sin(b)/J_x
    w_y = -(-h_1 + h_2 - h_3 + h_4)*sin(a)*cos(b)/J_y
    w_z = -(-h_1 - h_2 + h_3 + h_4)*cos(a)/J_z

    >>> [f"{x:.6g}" for x in rates_of_four_wheels(-0.8, -0.6, -0.4, -0.2, 0.79, 0.94, 0.7, 0.8, 0.9)]
    ['1.639', '-0.209479', '-0.62564']
    """
    sin_a = sin(a)
    t1 = h_1 + h_3
    t2 = -h_4
    w_x = -(sin(b) * (sin_a * (t1 + (h_2 + h_4))) / J_x)
    w_y = -(cos(b) * (sin_a * (h_2 - t1 - t2)) / J_y)
    w_z = -(cos(a) * (h_3 - h_1 - h_2 - t2) / J_z)
    return w_x, w_y, w_z


@for_arrays(rates_of_four_wheels)
def _rates_of_four_wheels(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    tan_a = tan(a)
    t1 = 1.0 + tan_a * tan_a
    t4 = h_1 + h_3
    t5 = -h_4
    tan_b = tan(b)
    t10 = sqrt(t1 * (1.0 + tan_b * tan_b))
    w_x = -((t4 + (h_2 + h_4)) * tan_a * tan_b / (J_x * t10))
    w_y = -((h_2 - t4 - t5) * tan_a / (J_y * t10))
    w_z = -((h_3 - h_1 - h_2 - t5) / (J_z * sqrt(t1)))
    return w_x, w_y, w_z


@kernel(
    Argument("h_1", "momentum of wheel 1", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_2", "momentum of wheel 2", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_3", "momentum of wheel 3", "units of h_max", low="-1", high="1", closed=True),
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("b", "angle of the side edges in the plane OXY", "rad", low="0", high="pi/2"),
    Argument("J_x", "moment of inertia about OX", "kg m^2", low="0"),
    Argument("J_y", "moment of inertia about OY", "kg m^2", low="0"),
    Argument("J_z", "moment of inertia about OZ", "kg m^2", low="0"),
    Output("w_x", "angular rate about OX", "units of h_max/(kg m^2)"),
    Output("w_y", "angular rate about OY", "units of h_max/(kg m^2)"),
    Output("w_z", "angular rate about OZ", "units of h_max/(kg m^2)"),
    ulp=8,
    condition="Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i.",
    claims={"2.2.1": "a4e05c48da78", "2.3": "57003d67dcfa"},
)
def rates_of_three_wheels(h_1, h_2, h_3, a, b, J_x, J_y, J_z):
    """Angular rates of a body, at rest with its wheels at rest, that four wheels of which the last has failed give it.

    w_x = -(h_1 + h_2 + h_3)*sin(a)*sin(b)/J_x
    w_y = -(-h_1 + h_2 - h_3)*sin(a)*cos(b)/J_y
    w_z = -(-h_1 - h_2 + h_3)*cos(a)/J_z

    >>> [f"{x:.6g}" for x in rates_of_three_wheels(-0.78, -0.56, -0.33, 0.7, 0.87, 0.67, 0.78, 0.89)]
    ['1.22731', '-0.292916', '-0.867967']
    """
    sin_a = sin(a)
    t1 = h_1 + h_3
    w_x = -(sin(b) * (sin_a * (h_2 + t1)) / J_x)
    w_y = -(cos(b) * (sin_a * (h_2 - t1)) / J_y)
    w_z = -(cos(a) * (h_3 - h_1 - h_2) / J_z)
    return w_x, w_y, w_z


@for_arrays(rates_of_three_wheels)
def _rates_of_three_wheels(h_1, h_2, h_3, a, b, J_x, J_y, J_z):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    tan_a = tan(a)
    t1 = 1.0 + tan_a * tan_a
    t4 = h_1 + h_3
    tan_b = tan(b)
    t8 = sqrt(t1 * (1.0 + tan_b * tan_b))
    w_x = -((h_2 + t4) * tan_a * tan_b / (J_x * t8))
    w_y = -((h_2 - t4) * tan_a / (J_y * t8))
    w_z = -((h_3 - h_1 - h_2) / (J_z * sqrt(t1)))
    return w_x, w_y, w_z


@kernel(
    Argument("h_1", "momentum of wheel 1", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_2", "momentum of wheel 2", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_3", "momentum of wheel 3", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_4", "momentum of wheel 4", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_5", "momentum of wheel 5", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_6", "momentum of wheel 6", "units of h_max", low="-1", high="1", closed=True),
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("J_x", "moment of inertia about OX", "kg m^2", low="0"),
    Argument("J_y", "moment of inertia about OY", "kg m^2", low="0"),
    Argument("J_z", "moment of inertia about OZ", "kg m^2", low="0"),
    Output("w_x", "angular rate about OX", "units of h_max/(kg m^2)"),
    Output("w_y", "angular rate about OY", "units of h_max/(kg m^2)"),
    Output("w_z", "angular rate about OZ", "units of h_max/(kg m^2)"),
    ulp=8,
    condition="Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i.",
    claims={"3.1.2": "8758872a0c67", "2.3": "57003d67dcfa"},
)
def rates_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z):
    """Angular rates of a body, at rest with its wheels at rest, that six wheels give it.

    w_x = -sqrt(3)*(h_2 + h_3 + h_5 + h_6)*sin(a)/(2*J_x)
    w_y = -(-2*h_1 - h_2 + h_3 - 2*h_4 - h_5 + h_6)*sin(a)/(2*J_y)
    w_z = -(h_1 + h_2 + h_3 - h_4 - h_5 - h_6)*cos(a)/J_z

    >>> [f"{x:.6g}" for x in rates_of_six_wheels(-0.82, -0.64, -0.45, -0.27, -0.09, 0.09, 1.0, 0.73, 0.82,
    ...     0.91)]
    ['1.08811', '-1.30838', '0.973732']
    """
    t1 = h_2 + h_5
    t2 = (1.0 / 2.0) * sin(a)
    t3 = -h_6
    w_x = -((t1 + (h_3 + h_6)) * (sqrt(3.0) * t2) / J_x)
    w_y = -((h_3 - 2.0 * h_1 - 2.0 * h_4 - t1 - t3) * t2 / J_y)
    w_z = -(cos(a) * (h_3 + (h_1 + h_2) + t3 - h_4 - h_5) / J_z)
    return w_x, w_y, w_z


@for_arrays(rates_of_six_wheels)
def _rates_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    t1 = h_2 + h_5
    tan_a = tan(a)
    t3 = sqrt(1.0 + tan_a * tan_a)
    t5 = (1.0 / 2.0) * tan_a / t3
    t6 = -h_6
    w_x = -((t1 + (h_3 + h_6)) * (sqrt(3.0) * t5) / J_x)
    w_y = -((h_3 - 2.0 * h_1 - 2.0 * h_4 - t1 - t6) * t5 / J_y)
    w_z = -((h_3 + (h_1 + h_2) + t6 - h_4 - h_5) / (J_z * t3))
    return w_x, w_y, w_z


@kernel(
    Argument("h_1", "momentum of wheel 1", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_2", "momentum of wheel 2", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_3", "momentum of wheel 3", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_4", "momentum of wheel 4", "units of h_max", low="-1", high="1", closed=True),
    Argument("h_5", "momentum of wheel 5", "units of h_max", low="-1", high="1", closed=True),
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("J_x", "moment of inertia about OX", "kg m^2", low="0"),
    Argument("J_y", "moment of inertia about OY", "kg m^2", low="0"),
    Argument("J_z", "moment of inertia about OZ", "kg m^2", low="0"),
    Output("w_x", "angular rate about OX", "units of h_max/(kg m^2)"),
    Output("w_y", "angular rate about OY", "units of h_max/(kg m^2)"),
    Output("w_z", "angular rate about OZ", "units of h_max/(kg m^2)"),
    ulp=8,
    condition="Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i.",
    claims={"3.2.1": "d524ffea3256", "2.3": "57003d67dcfa"},
)
def rates_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z):
    """Angular rates of a body, at rest with its wheels at rest, that six wheels of which the last has failed give it.

    w_x = -sqrt(3)*(h_2 + h_3 + h_5)*sin(a)/(2*J_x)
    w_y = -(-2*h_1 - h_2 + h_3 - 2*h_4 - h_5)*sin(a)/(2*J_y)
    w_z = -(h_1 + h_2 + h_3 - h_4 - h_5)*cos(a)/J_z

    >>> [f"{x:.6g}" for x in rates_of_five_wheels(-0.8, -0.6, -0.4, -0.2, 0.0, 0.94, 0.7, 0.8, 0.9)]
    ['0.999094', '-1.11039', '1.04851']
    """
    t1 = h_2 + h_5
    t2 = (1.0 / 2.0) * sin(a)
    w_x = -((h_3 + t1) * (sqrt(3.0) * t2) / J_x)
    w_y = -((h_3 - 2.0 * h_1 - 2.0 * h_4 - t1) * t2 / J_y)
    w_z = -(cos(a) * (h_3 + (h_1 + h_2) - h_4 - h_5) / J_z)
    return w_x, w_y, w_z


@for_arrays(rates_of_five_wheels)
def _rates_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    t1 = h_2 + h_5
    tan_a = tan(a)
    t3 = sqrt(1.0 + tan_a * tan_a)
    t5 = (1.0 / 2.0) * tan_a / t3
    w_x = -((h_3 + t1) * (sqrt(3.0) * t5) / J_x)
    w_y = -((h_3 - 2.0 * h_1 - 2.0 * h_4 - t1) * t5 / J_y)
    w_z = -((h_3 + (h_1 + h_2) - h_4 - h_5) / (J_z * t3))
    return w_x, w_y, w_z


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("b", "angle of the side edges in the plane OXY", "rad", low="0", high="pi/2"),
    Output("V_1x", "x of V_1", "units of h_max"),
    Output("V_2x", "x of V_2", "units of h_max"),
    Output("V_2y", "y of V_2", "units of h_max"),
    Output("V_2z", "z of V_2", "units of h_max"),
    Output("V_3x", "x of V_3", "units of h_max"),
    Output("V_3y", "y of V_3", "units of h_max"),
    Output("V_3z", "z of V_3", "units of h_max"),
    Output("V_4x", "x of V_4", "units of h_max"),
    Output("V_4y", "y of V_4", "units of h_max"),
    Output("V_4z", "z of V_4", "units of h_max"),
    Output("V_5x", "x of V_5", "units of h_max"),
    Output("V_5y", "y of V_5", "units of h_max"),
    Output("V_5z", "z of V_5", "units of h_max"),
    Output("V_6y", "y of V_6", "units of h_max"),
    Output("V_7z", "z of V_7", "units of h_max"),
    ulp=6,
    condition="Tangents of two angles, a root and a quotient are rounded one after the other.",
    claims={"2.1V.1a": "e5b9794d6eff", "2.1V.2a": "a0f1e3a325ab", "2.1V.3a": "f8ec71b5b1e5",
        "2.1V.4a": "772691a3262a", "2.1V.5a": "5e218eab1ed2", "2.1V.6a": "e3990d37b113", "2.1V.7a": "6699fc74aac7"},
)
def vertices_of_four_wheels(a, b):
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

    >>> [f"{x:.6g}" for x in vertices_of_four_wheels(0.52, 1.05)]  # doctest: +NORMALIZE_WHITESPACE
    ['1.72402', '0.862011', '0.494466', '1.73564', '0.862011', '-0.494466', '1.73564', '0.862011', '0.494466',
     '-1.73564', '0.862011', '-0.494466', '-1.73564', '-0.988933', '-3.47128']
    """
    sin_a = sin(a)
    t1 = sin_a * sin(b)
    t2 = 2.0 * t1
    t3 = cos(b) * sin_a
    t4 = 2.0 * t3
    cos_a = cos(a)
    t5 = 2.0 * cos_a
    t6 = -t4
    t7 = -t5
    V_1x = 4.0 * t1
    V_6y = -(4.0 * t3)
    V_7z = -(4.0 * cos_a)
    return V_1x, t2, t4, t5, t2, t6, t5, t2, t4, t7, t2, t6, t7, V_6y, V_7z


@for_arrays(vertices_of_four_wheels)
def _vertices_of_four_wheels(a, b):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    tan_a = tan(a)
    t1 = 1.0 + tan_a * tan_a
    t2 = sqrt(t1)
    tan_b = tan(b)
    t6 = sqrt(t1 * (1.0 + tan_b * tan_b))
    t8 = tan_a * tan_b / t6
    t9 = 2.0 * t8
    t10 = tan_a / t6
    t11 = 2.0 * t10
    t13 = 2.0 / t2
    t14 = -t11
    t15 = -t13
    V_1x = 4.0 * t8
    V_6y = -(4.0 * t10)
    V_7z = -(4.0 / t2)
    return V_1x, t9, t11, t13, t9, t14, t13, t9, t11, t15, t9, t14, t15, V_6y, V_7z


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("b", "angle of the side edges in the plane OXY", "rad", low="0", high="pi/2"),
    Output("V_1x", "x of V_1", "units of h_max"),
    Output("V_1y", "y of V_1", "units of h_max"),
    Output("V_1z", "z of V_1", "units of h_max"),
    Output("V_2x", "x of V_2", "units of h_max"),
    Output("V_2y", "y of V_2", "units of h_max"),
    Output("V_2z", "z of V_2", "units of h_max"),
    Output("V_3x", "x of V_3", "units of h_max"),
    Output("V_3y", "y of V_3", "units of h_max"),
    Output("V_3z", "z of V_3", "units of h_max"),
    Output("V_4x", "x of V_4", "units of h_max"),
    Output("V_4y", "y of V_4", "units of h_max"),
    Output("V_4z", "z of V_4", "units of h_max"),
    ulp=6,
    condition="Tangents of two angles, a root and a quotient are rounded one after the other.",
    claims={"2.2V.1a": "2454d33ff5bf", "2.2V.2a": "b7890bffda83", "2.2V.3a": "45c0821bb0e1",
        "2.2V.4a": "39b18cc074ae"},
)
def vertices_of_three_wheels(a, b):
    """Vertices V_i = -V'_i of the envelope of four wheels of which the last has failed, without components that are
        zero.

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

    >>> [f"{x:.6g}" for x in vertices_of_three_wheels(0.52, 1.05)]  # doctest: +NORMALIZE_WHITESPACE
    ['1.29302', '-0.247233', '-0.867819', '0.431005', '0.247233', '0.867819', '0.431005', '-0.7417', '0.867819',
     '0.431005', '0.247233', '-2.60346']
    """
    sin_a = sin(a)
    t1 = sin_a * sin(b)
    t2 = cos(b) * sin_a
    cos_a = cos(a)
    V_1x = 3.0 * t1
    V_1y = -t2
    V_1z = -cos_a
    V_3y = -(3.0 * t2)
    V_4z = -(3.0 * cos_a)
    return V_1x, V_1y, V_1z, t1, t2, cos_a, t1, V_3y, cos_a, t1, t2, V_4z


@for_arrays(vertices_of_three_wheels)
def _vertices_of_three_wheels(a, b):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    tan_a = tan(a)
    t1 = 1.0 + tan_a * tan_a
    t2 = sqrt(t1)
    tan_b = tan(b)
    t6 = sqrt(t1 * (1.0 + tan_b * tan_b))
    t8 = tan_a * tan_b / t6
    t9 = tan_a / t6
    t10 = 1.0 / t2
    V_1x = 3.0 * t8
    V_1y = -t9
    V_1z = -t10
    V_3y = -(3.0 * t9)
    V_4z = -(3.0 / t2)
    return V_1x, V_1y, V_1z, t8, t9, t10, t8, V_3y, t10, t8, t9, V_4z


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Output("V_1z", "z of V_1", "units of h_max"),
    Output("V_2y", "y of V_2", "units of h_max"),
    Output("V_2z", "z of V_2", "units of h_max"),
    Output("V_3x", "x of V_3", "units of h_max"),
    Output("V_3y", "y of V_3", "units of h_max"),
    Output("V_3z", "z of V_3", "units of h_max"),
    Output("V_4x", "x of V_4", "units of h_max"),
    Output("V_4y", "y of V_4", "units of h_max"),
    Output("V_4z", "z of V_4", "units of h_max"),
    Output("V_5y", "y of V_5", "units of h_max"),
    Output("V_5z", "z of V_5", "units of h_max"),
    Output("V_6x", "x of V_6", "units of h_max"),
    Output("V_6y", "y of V_6", "units of h_max"),
    Output("V_6z", "z of V_6", "units of h_max"),
    Output("V_7x", "x of V_7", "units of h_max"),
    Output("V_7y", "y of V_7", "units of h_max"),
    Output("V_7z", "z of V_7", "units of h_max"),
    Output("V_8x", "x of V_8", "units of h_max"),
    Output("V_8y", "y of V_8", "units of h_max"),
    Output("V_8z", "z of V_8", "units of h_max"),
    Output("V_9x", "x of V_9", "units of h_max"),
    Output("V_9y", "y of V_9", "units of h_max"),
    Output("V_9z", "z of V_9", "units of h_max"),
    Output("V_10x", "x of V_10", "units of h_max"),
    Output("V_10z", "z of V_10", "units of h_max"),
    Output("V_11x", "x of V_11", "units of h_max"),
    Output("V_11y", "y of V_11", "units of h_max"),
    Output("V_11z", "z of V_11", "units of h_max"),
    Output("V_12x", "x of V_12", "units of h_max"),
    Output("V_12y", "y of V_12", "units of h_max"),
    Output("V_12z", "z of V_12", "units of h_max"),
    Output("V_13x", "x of V_13", "units of h_max"),
    Output("V_13z", "z of V_13", "units of h_max"),
    Output("V_14x", "x of V_14", "units of h_max"),
    Output("V_14y", "y of V_14", "units of h_max"),
    Output("V_15y", "y of V_15", "units of h_max"),
    Output("V_16x", "x of V_16", "units of h_max"),
    Output("V_16y", "y of V_16", "units of h_max"),
    ulp=5,
    condition="The square root of 3 and half a sine are rounded too.",
    claims={"3.1V.1a": "b51a3fcf346f", "3.1V.2a": "b0c634dcdde9", "3.1V.3a": "7bb0b8f23c7a",
        "3.1V.4a": "eee98e1b565b", "3.1V.5a": "f08e36effac0", "3.1V.6a": "5bef380883e6", "3.1V.7a": "1e8ce505359f",
        "3.1V.8a": "cbda7b1ae859", "3.1V.9a": "17e1fe062dac", "3.1V.10a": "0248272de7aa", "3.1V.11a": "dc8419622b85",
        "3.1V.12a": "064a71a8217e", "3.1V.13a": "5afc508aa051", "3.1V.14a": "aad84d3eca9d",
        "3.1V.15a": "ccddd845f704", "3.1V.16a": "1e908cfed76a"},
)
def vertices_of_six_wheels(a):
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

    >>> [f"{x:.6g}" for x in vertices_of_six_wheels(0.79)]  # doctest: +NORMALIZE_WHITESPACE
    ['4.22307', '1.42071', '2.81538', '-1.23037', '0.710353', '2.81538', '-1.23037', '-0.710353', '2.81538',
     '-1.42071', '2.81538', '1.23037', '-0.710353', '2.81538', '1.23037', '0.710353', '2.81538', '1.23037',
     '2.13106', '1.40769', '-1.23037', '2.13106', '1.40769', '-2.46074', '1.40769', '-1.23037', '-2.13106',
     '1.40769', '1.23037', '-2.13106', '1.40769', '2.46074', '1.40769', '2.46074', '1.42071', '2.84141', '-2.46074',
     '1.42071']
    """
    cos_a = cos(a)
    sin_a = sin(a)
    t1 = 2.0 * sin_a
    t2 = 4.0 * cos_a
    t3 = sin_a * sqrt(3.0)
    t4 = -t3
    t5 = -sin_a
    t6 = 3.0 * sin_a
    t7 = 2.0 * cos_a
    t8 = sqrt(3.0) * t1
    t9 = -t8
    t10 = -t6
    V_1z = 6.0 * cos_a
    V_5y = -t1
    V_15y = 4.0 * sin_a
    return (
        V_1z, t1, t2, t4, sin_a, t2, t4, t5, t2, V_5y, t2, t3, t5, t2, t3, sin_a, t2, t3, t6, t7, t4, t6, t7, t9, t7,
        t4, t10, t7, t3, t10, t7, t8, t7, t8, t1, V_15y, t9, t1,
    )


@for_arrays(vertices_of_six_wheels)
def _vertices_of_six_wheels(a):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    tan_a = tan(a)
    t2 = sqrt(1.0 + tan_a * tan_a)
    t4 = tan_a / t2
    t6 = 2.0 * tan_a / t2
    t7 = 4.0 / t2
    t9 = sqrt(3.0) * tan_a / t2
    t10 = -t9
    t11 = -t4
    t13 = 3.0 * tan_a / t2
    t14 = 2.0 / t2
    t15 = sqrt(3.0) * t6
    t16 = -t15
    t17 = -t13
    V_1z = 6.0 / t2
    V_5y = -t6
    V_15y = 4.0 * tan_a / t2
    return (
        V_1z, t6, t7, t10, t4, t7, t10, t11, t7, V_5y, t7, t9, t11, t7, t9, t4, t7, t9, t13, t14, t10, t13, t14, t16,
        t14, t10, t17, t14, t9, t17, t14, t15, t14, t15, t6, V_15y, t16, t6,
    )


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Output("V_1x", "x of V_1", "units of h_max"),
    Output("V_1y", "y of V_1", "units of h_max"),
    Output("V_1z", "z of V_1", "units of h_max"),
    Output("V_2x", "x of V_2", "units of h_max"),
    Output("V_2y", "y of V_2", "units of h_max"),
    Output("V_2z", "z of V_2", "units of h_max"),
    Output("V_3x", "x of V_3", "units of h_max"),
    Output("V_3y", "y of V_3", "units of h_max"),
    Output("V_3z", "z of V_3", "units of h_max"),
    Output("V_4x", "x of V_4", "units of h_max"),
    Output("V_4y", "y of V_4", "units of h_max"),
    Output("V_4z", "z of V_4", "units of h_max"),
    Output("V_5x", "x of V_5", "units of h_max"),
    Output("V_5y", "y of V_5", "units of h_max"),
    Output("V_5z", "z of V_5", "units of h_max"),
    Output("V_6x", "x of V_6", "units of h_max"),
    Output("V_6y", "y of V_6", "units of h_max"),
    Output("V_6z", "z of V_6", "units of h_max"),
    Output("V_7x", "x of V_7", "units of h_max"),
    Output("V_7y", "y of V_7", "units of h_max"),
    Output("V_7z", "z of V_7", "units of h_max"),
    Output("V_8x", "x of V_8", "units of h_max"),
    Output("V_8y", "y of V_8", "units of h_max"),
    Output("V_8z", "z of V_8", "units of h_max"),
    Output("V_9x", "x of V_9", "units of h_max"),
    Output("V_9y", "y of V_9", "units of h_max"),
    Output("V_9z", "z of V_9", "units of h_max"),
    Output("V_10x", "x of V_10", "units of h_max"),
    Output("V_10y", "y of V_10", "units of h_max"),
    Output("V_10z", "z of V_10", "units of h_max"),
    Output("V_11x", "x of V_11", "units of h_max"),
    Output("V_11y", "y of V_11", "units of h_max"),
    Output("V_11z", "z of V_11", "units of h_max"),
    ulp=5,
    condition="The square root of 3 and half a sine are rounded too.",
    claims={"3.2V.1a": "12fa1ab02a5f", "3.2V.2a": "d8e0ae63d033", "3.2V.3a": "be4a9049023c",
        "3.2V.4a": "8e45bf74b10b", "3.2V.5a": "ceb89ee8941d", "3.2V.6a": "8c38650a0830", "3.2V.7a": "c2dfe2bca48d",
        "3.2V.8a": "cf0c32575974", "3.2V.9a": "f8aed7e8d192", "3.2V.10a": "3c61def8ef19", "3.2V.11a": "a185009784ec"},
)
def vertices_of_five_wheels(a):
    """Vertices V_i = -V'_i of the envelope of six wheels of which the last has failed, without components that are
        zero.

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

    >>> [f"{x:.6g}" for x in vertices_of_five_wheels(0.79)]  # doctest: +NORMALIZE_WHITESPACE
    ['0.615184', '0.355177', '3.51923', '0.615184', '1.77588', '2.11154', '-0.615184', '1.06553', '2.11154',
     '-0.615184', '-0.355177', '2.11154', '0.615184', '-1.06553', '2.11154', '1.84555', '-0.355177', '2.11154',
     '1.84555', '1.06553', '0.703845', '-0.615184', '2.48624', '0.703845', '-1.84555', '0.355177', '0.703845',
     '-0.615184', '-1.77588', '0.703845', '1.84555', '-1.77588', '0.703845']
    """
    sin_a = sin(a)
    t1 = (1.0 / 2.0) * sin_a
    t2 = sqrt(3.0) * t1
    cos_a = cos(a)
    t3 = (5.0 / 2.0) * sin_a
    t4 = 3.0 * cos_a
    t5 = -t2
    t6 = (3.0 / 2.0) * sin_a
    t7 = -t1
    t8 = sqrt(3.0) * t6
    t9 = -t3
    V_1z = 5.0 * cos_a
    V_5y = -t6
    V_8y = (7.0 / 2.0) * sin_a
    V_9x = -t8
    return (
        t2, t1, V_1z, t2, t3, t4, t5, t6, t4, t5, t7, t4, t2, V_5y, t4, t8, t7, t4, t8, t6, cos_a, t5, V_8y, cos_a,
        V_9x, t1, cos_a, t5, t9, cos_a, t8, t9, cos_a,
    )


@for_arrays(vertices_of_five_wheels)
def _vertices_of_five_wheels(a):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    tan_a = tan(a)
    t2 = sqrt(1.0 + tan_a * tan_a)
    t5 = (1.0 / 2.0) * tan_a / t2
    t6 = sqrt(3.0) * t5
    t7 = 1.0 / t2
    t9 = (5.0 / 2.0) * tan_a / t2
    t10 = 3.0 / t2
    t11 = -t6
    t13 = (3.0 / 2.0) * tan_a / t2
    t14 = -t5
    t15 = sqrt(3.0) * t13
    t16 = -t9
    V_1z = 5.0 / t2
    V_5y = -t13
    V_8y = (7.0 / 2.0) * tan_a / t2
    V_9x = -t15
    return (
        t6, t5, V_1z, t6, t9, t10, t11, t13, t10, t11, t14, t10, t6, V_5y, t10, t15, t14, t10, t15, t13, t7, t11, V_8y,
        t7, V_9x, t5, t7, t11, t16, t7, t15, t16, t7,
    )


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("b", "angle of the side edges in the plane OXY", "rad", low="0", high="pi/2"),
    Output("d_1", "distance of V_1", "units of h_max"),
    Output("d_2", "distance of V_6", "units of h_max"),
    Output("d_3", "distance of V_7 (V_2 to V_5 are 2 away at all angles)", "units of h_max"),
    ulp=6,
    condition="Tangents of two angles, a root and a quotient are rounded one after the other.",
    claims={"2.1.28": "0e3240f25813", "2.1.29": "b8a120513c5b", "2.1.30": "321b732aa3c2"},
)
def vertex_distances_of_four_wheels(a, b):
    """Distances from the centre to the vertices of the envelope of four wheels.

    d_1 = 4*sin(a)*sin(b)
    d_2 = 4*sin(a)*cos(b)
    d_3 = 4*cos(a)

    >>> [f"{x:.6g}" for x in vertex_distances_of_four_wheels(0.52, 1.05)]
    ['1.72402', '0.988933', '3.47128']
    """
    t1 = 4.0 * sin(a)
    d_1 = sin(b) * t1
    d_2 = cos(b) * t1
    d_3 = 4.0 * cos(a)
    return d_1, d_2, d_3


@for_arrays(vertex_distances_of_four_wheels)
def _vertex_distances_of_four_wheels(a, b):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    tan_a = tan(a)
    t2 = sqrt(1.0 + tan_a * tan_a)
    t4 = 4.0 * tan_a / t2
    tan_b = tan(b)
    t6 = sqrt(1.0 + tan_b * tan_b)
    d_1 = t4 * tan_b / t6
    d_2 = t4 / t6
    d_3 = 4.0 / t2
    return d_1, d_2, d_3


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("b", "angle of the side edges in the plane OXY", "rad", low="0", high="pi/2"),
    Output("d_1", "distance of V_1", "units of h_max"),
    Output("d_2", "distance of V_3", "units of h_max"),
    Output("d_3", "distance of V_4 (V_2 is 1 away at all angles)", "units of h_max"),
    ulp=4,
    claims={"2.2.18": "4d77f76651c9", "2.2.19": "ae7a0b96326a", "2.2.20": "47427cf2a5e7"},
    forms="e8f94252f227",
)
def vertex_distances_of_three_wheels(a, b):
    """Distances from the centre to the vertices of the envelope of four wheels of which the last has failed.

    d_1 = sqrt(9*sin(a)**2*sin(b)**2 + sin(a)**2*cos(b)**2 + cos(a)**2)
    d_2 = sqrt(sin(a)**2*sin(b)**2 + 9*sin(a)**2*cos(b)**2 + cos(a)**2)
    d_3 = sqrt(sin(a)**2*sin(b)**2 + sin(a)**2*cos(b)**2 + 9*cos(a)**2)

    >>> [f"{x:.6g}" for x in vertex_distances_of_three_wheels(0.52, 1.05)]
    ['1.57675', '1.22024', '2.65045']
    """
    tan_b = tan(b)
    tan_b_squared = tan_b * tan_b
    tan_a = tan(a)
    tan_a_squared = tan_a * tan_a
    t2 = 8.0 / (1.0 + tan_a_squared)
    t5 = t2 * tan_a_squared / (1.0 + tan_b_squared)
    d_1 = sqrt(1.0 + t5 * tan_b_squared)
    d_2 = sqrt(1.0 + t5)
    d_3 = sqrt(1.0 + t2)
    return d_1, d_2, d_3


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Output("d_1", "distance of V_1", "units of h_max"),
    Output("d_2", "distance of V_14 to V_16", "units of h_max"),
    Output("d_3", "distance of V_2 to V_7", "units of h_max"),
    Output("d_4", "distance of V_8 to V_13", "units of h_max"),
    ulp=4,
    claims={"3.1.28": "12102fa02278", "3.1.29": "05d47c77242f", "3.1.30": "dc0a623feb52", "3.1.31": "196586fd34c2"},
    forms="6715f551bdad",
)
def vertex_distances_of_six_wheels(a):
    """Distances from the centre to the vertices of the envelope of six wheels.

    d_1 = 6*cos(a)
    d_2 = 4*sin(a)
    d_3 = sqrt(4*sin(a)**2 + 16*cos(a)**2)
    d_4 = sqrt(12*sin(a)**2 + 4*cos(a)**2)

    >>> [f"{x:.6g}" for x in vertex_distances_of_six_wheels(0.79)]
    ['4.22307', '2.84141', '3.15353', '2.83493']
    """
    tan_a = tan(a)
    tan_a_squared = tan_a * tan_a
    t2 = 1.0 / (1.0 + tan_a_squared)
    d_1 = 6.0 * cos(a)
    d_2 = 4.0 * sin(a)
    d_3 = 2.0 * sqrt(1.0 + 3.0 * t2)
    d_4 = 2.0 * sqrt(1.0 + 2.0 * (t2 * tan_a_squared))
    return d_1, d_2, d_3, d_4


@for_arrays(vertex_distances_of_six_wheels)
def _vertex_distances_of_six_wheels(a):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    tan_a = tan(a)
    tan_a_squared = tan_a * tan_a
    t1 = 1.0 + tan_a_squared
    t2 = 1.0 / t1
    t3 = sqrt(t1)
    d_1 = 6.0 / t3
    d_2 = 4.0 * tan_a / t3
    d_3 = 2.0 * sqrt(1.0 + 3.0 * t2)
    d_4 = 2.0 * sqrt(1.0 + 2.0 * (t2 * tan_a_squared))
    return d_1, d_2, d_3, d_4


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Output("d_1", "distance of V_1", "units of h_max"),
    Output("d_2", "distance of V_2 and V_6", "units of h_max"),
    Output("d_3", "distance of V_3 and V_5", "units of h_max"),
    Output("d_4", "distance of V_4", "units of h_max"),
    Output("d_5", "distance of V_7", "units of h_max"),
    Output("d_6", "distance of V_8 and V_11", "units of h_max"),
    Output("d_7", "distance of V_9 and V_10", "units of h_max"),
    ulp=4,
    claims={"T10.1": "a66d84adc0ff", "T10.2": "77030a88722f", "T10.3": "38b313e59b78", "T10.4": "64c442074569",
        "T10.5": "aefc26a40abb", "T10.6": "d2b1bc5ab521", "T10.7": "1ce2e65fcc46"},
    forms="7c6a4367933f",
)
def vertex_distances_of_five_wheels(a):
    """Distances from the centre to the vertices of the envelope of six wheels of which the last has failed.

    d_1 = sqrt(sin(a)**2 + 25*cos(a)**2)
    d_2 = sqrt(7*sin(a)**2 + 9*cos(a)**2)
    d_3 = sqrt(3*sin(a)**2 + 9*cos(a)**2)
    d_4 = sqrt(sin(a)**2 + 9*cos(a)**2)
    d_5 = sqrt(9*sin(a)**2 + cos(a)**2)
    d_6 = sqrt(13*sin(a)**2 + cos(a)**2)
    d_7 = sqrt(7*sin(a)**2 + cos(a)**2)

    >>> [f"{x:.6g}" for x in vertex_distances_of_five_wheels(0.79)]
    ['3.5902', '2.8268', '2.44385', '2.22782', '2.24428', '2.65617', '2.00689']
    """
    tan_a = tan(a)
    tan_a_squared = tan_a * tan_a
    t2 = 1.0 / (1.0 + tan_a_squared)
    t3 = 6.0 * t2
    t4 = 8.0 * t2
    d_1 = sqrt(1.0 + 24.0 * t2)
    d_2 = sqrt(7.0 + 2.0 * t2)
    d_3 = sqrt(3.0 + t3)
    d_4 = sqrt(1.0 + t4)
    d_5 = sqrt(1.0 + t4 * tan_a_squared)
    d_6 = sqrt(1.0 + 12.0 * (t2 * tan_a_squared))
    d_7 = sqrt(1.0 + t3 * tan_a_squared)
    return d_1, d_2, d_3, d_4, d_5, d_6, d_7


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("b", "angle of the side edges in the plane OXY", "rad", low="0", high="pi/2"),
    Output("r_1", "distance of F_1 and F_5", "units of h_max"),
    Output("r_2", "distance of F_2 and F_4", "units of h_max"),
    Output("r_3", "distance of F_3 and F_6", "units of h_max"),
    ulp=5,
    condition="Tangents of two angles, a root and a quotient are rounded one after the other.",
    claims={"T3.1": "8efdfa34b18c", "T3.2": "d75a5ee5e821", "T3.3": "c07cc09dd077"},
    forms="c0e08f011f03",
)
def face_distances_of_four_wheels(a, b):
    """Distances from the centre to the planes of the faces of the envelope of four wheels.

    r_1 = 4*sin(a)*sin(b)*cos(a)/sqrt(sin(a)**2*sin(b)**2 + cos(a)**2)
    r_2 = 4*sin(a)*cos(a)*cos(b)/sqrt(sin(a)**2*cos(b)**2 + cos(a)**2)
    r_3 = 4*sin(a)**2*sin(b)*cos(b)/sqrt(sin(a)**2*sin(b)**2 + sin(a)**2*cos(b)**2)

    >>> [f"{x:.6g}" for x in face_distances_of_four_wheels(0.52, 1.05)]
    ['1.54407', '0.951089', '0.857823']
    """
    tan_a = tan(a)
    tan_a_squared = tan_a * tan_a
    tan_b = tan(b)
    tan_b_squared = tan_b * tan_b
    t1 = 1.0 + tan_b_squared
    t2 = 4.0 * tan_a
    t3 = t2 * tan_b
    t4 = t1 * t1
    t11 = sqrt(t1 + (1.0 + (tan_a_squared * tan_b_squared + 2.0 * tan_b_squared)) * tan_a_squared)
    r_1 = t3 / t11
    r_2 = t2 / sqrt(t1 + (2.0 + (tan_a_squared + tan_b_squared)) * tan_a_squared)
    r_3 = t3 / sqrt(t4 * tan_a_squared + t4)
    return r_1, r_2, r_3


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("b", "angle of the side edges in the plane OXY", "rad", low="0", high="pi/2"),
    Output("r_1", "distance of F_1", "units of h_max"),
    Output("r_2", "distance of F_2", "units of h_max"),
    Output("r_3", "distance of F_3", "units of h_max"),
    ulp=5,
    condition="Tangents of two angles, a root and a quotient are rounded one after the other.",
    claims={"T5.1": "3ea4d48a967e"},
    forms="d8ee80165a63",
)
def face_distances_of_three_wheels(a, b):
    """Distances from the centre to the planes of the faces of the envelope of four wheels of which the last has
        failed.

    r_1 = 2*sin(a)*sin(b)*cos(a)/sqrt(sin(a)**2*sin(b)**2 + cos(a)**2)
    r_2 = 2*sin(a)*cos(a)*cos(b)/sqrt(sin(a)**2*cos(b)**2 + cos(a)**2)
    r_3 = 2*sin(a)**2*sin(b)*cos(b)/sqrt(sin(a)**2*sin(b)**2 + sin(a)**2*cos(b)**2)

    >>> [f"{x:.6g}" for x in face_distances_of_three_wheels(0.52, 1.05)]
    ['0.772037', '0.475545', '0.428912']
    """
    tan_a = tan(a)
    tan_a_squared = tan_a * tan_a
    tan_b = tan(b)
    tan_b_squared = tan_b * tan_b
    t1 = 1.0 + tan_b_squared
    t2 = 2.0 * tan_a
    t3 = t2 * tan_b
    t4 = t1 * t1
    t11 = sqrt(t1 + (1.0 + (tan_a_squared * tan_b_squared + 2.0 * tan_b_squared)) * tan_a_squared)
    r_1 = t3 / t11
    r_2 = t2 / sqrt(t1 + (2.0 + (tan_a_squared + tan_b_squared)) * tan_a_squared)
    r_3 = t3 / sqrt(t4 * tan_a_squared + t4)
    return r_1, r_2, r_3


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Output("r_1", "distance of F_1 to F_6", "units of h_max"),
    Output("r_2", "distance of F_7 to F_12", "units of h_max"),
    Output("r_3", "distance of F_13 to F_15", "units of h_max"),
    ulp=4,
    claims={"T8.1": "b14e385314d0", "T8.3": "4228125f38ea", "B.28": "472d640787be"},
    forms="686717258b03",
)
def face_distances_of_six_wheels(a):
    """Distances from the centre to the planes of the faces of the envelope of six wheels.

    r_1 = 6*sqrt(3)*sin(a)*cos(a)/sqrt(3*sin(a)**2 + 4*cos(a)**2)
    r_2 = 8*sin(a)*cos(a)/sqrt(sin(a)**2 + 4*cos(a)**2)
    r_3 = 2*sqrt(3)*sin(a)

    >>> [f"{x:.6g}" for x in face_distances_of_six_wheels(0.79)]
    ['2.77917', '2.53673', '2.46074']
    """
    tan_a = tan(a)
    tan_a_squared = tan_a * tan_a
    r_1 = 6.0 * tan_a / sqrt((4.0 / 3.0) + ((7.0 / 3.0) + tan_a_squared) * tan_a_squared)
    r_2 = 8.0 * tan_a / sqrt(4.0 + (5.0 + tan_a_squared) * tan_a_squared)
    r_3 = 4.0 * tan_a / sqrt((4.0 / 3.0) + (4.0 / 3.0) * tan_a_squared)
    return r_1, r_2, r_3


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Output("r_1", "distance of F_1", "units of h_max"),
    Output("r_2", "distance of F_2 and F_5", "units of h_max"),
    Output("r_3", "distance of F_3 and F_4", "units of h_max"),
    Output("r_4", "distance of F_6 and F_8", "units of h_max"),
    Output("r_5", "distance of F_7", "units of h_max"),
    Output("r_6", "distance of F_9 and F_10", "units of h_max"),
    ulp=4,
    claims={"T11.1": "4304d5fe37f8", "T11.2": "158e62cdf51f", "T11.3": "ede2be42c5ac", "T11.4": "1518d3d3abcf",
        "T11.5": "01ed74be6d3d", "T11.6": "1c799063763f"},
    forms="dfc56dd0e0d8",
)
def face_distances_of_five_wheels(a):
    """Distances from the centre to the planes of the faces of the envelope of six wheels of which the last has failed.

    r_1 = 7*sin(a)*cos(a)/sqrt(sin(a)**2 + 4*cos(a)**2)
    r_2 = 5*sqrt(3)*sin(a)*cos(a)/sqrt(3*sin(a)**2 + 4*cos(a)**2)
    r_3 = 4*sqrt(3)*sin(a)*cos(a)/sqrt(3*sin(a)**2 + 4*cos(a)**2)
    r_4 = 6*sin(a)*cos(a)/sqrt(sin(a)**2 + 4*cos(a)**2)
    r_5 = 5*sin(a)*cos(a)/sqrt(sin(a)**2 + 4*cos(a)**2)
    r_6 = 3*sqrt(3)*sin(a)/2

    >>> [f"{x:.6g}" for x in face_distances_of_five_wheels(0.79)]
    ['2.21964', '2.31598', '1.85278', '1.90255', '1.58546', '1.84555']
    """
    tan_a = tan(a)
    tan_a_squared = tan_a * tan_a
    t5 = tan_a / sqrt(4.0 + (5.0 + tan_a_squared) * tan_a_squared)
    t10 = tan_a / sqrt((4.0 / 3.0) + ((7.0 / 3.0) + tan_a_squared) * tan_a_squared)
    r_1 = 7.0 * t5
    r_2 = 5.0 * t10
    r_3 = 4.0 * t10
    r_4 = 6.0 * t5
    r_5 = 5.0 * t5
    r_6 = 3.0 * tan_a / sqrt((4.0 / 3.0) + (4.0 / 3.0) * tan_a_squared)
    return r_1, r_2, r_3, r_4, r_5, r_6


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("b", "angle of the side edges in the plane OXY", "rad", low="0", high="pi/2"),
    Output("volume", "volume", "units of h_max^3"),
    ulp=8,
    condition="A product of three or five sines and cosines: rounding a tangent counts twice in sin^2 a.",
    claims={"B.3": "54617108b327"},
    forms="75080f897402",
)
def volume_of_four_wheels(a, b):
    """Volume of the envelope of four wheels.

    volume = 128*sin(a)**2*sin(b)*cos(a)*cos(b)

    >>> format(volume_of_four_wheels(0.52, 1.05), ".6g")
    '11.8366'
    """
    tan_a = tan(a)
    tan_b = tan(b)
    t10 = 128.0 * (tan_a * tan_b) / ((1.0 / tan_a + tan_a) * (sqrt(1.0 + tan_a * tan_a) * (1.0 + tan_b * tan_b)))
    return t10


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("b", "angle of the side edges in the plane OXY", "rad", low="0", high="pi/2"),
    Output("volume", "volume", "units of h_max^3"),
    ulp=8,
    condition="A product of three or five sines and cosines: rounding a tangent counts twice in sin^2 a.",
    claims={"B.13": "aedd01b78464"},
    forms="08c0ec53b77c",
)
def volume_of_three_wheels(a, b):
    """Volume of the envelope of four wheels of which the last has failed.

    volume = 32*sin(a)**2*sin(b)*cos(a)*cos(b)

    >>> format(volume_of_three_wheels(0.52, 1.05), ".6g")
    '2.95916'
    """
    tan_a = tan(a)
    tan_b = tan(b)
    t10 = 32.0 * (tan_a * tan_b) / ((1.0 / tan_a + tan_a) * (sqrt(1.0 + tan_a * tan_a) * (1.0 + tan_b * tan_b)))
    return t10


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Output("volume", "volume", "units of h_max^3"),
    ulp=8,
    condition="A product of three or five sines and cosines: rounding a tangent counts twice in sin^2 a.",
    claims={"B.25": "afc28669e24e"},
    forms="80a5ee158594",
)
def volume_of_six_wheels(a):
    """Volume of the envelope of six wheels.

    volume = 144*sqrt(3)*sin(a)**2*cos(a)

    >>> format(volume_of_six_wheels(0.79), ".6g")
    '88.5827'
    """
    tan_a = tan(a)
    t8 = 144.0 * tan_a / (sqrt((1.0 / 3.0) + (1.0 / 3.0) * (tan_a * tan_a)) * (1.0 / tan_a + tan_a))
    return t8


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Output("volume", "volume", "units of h_max^3"),
    ulp=8,
    condition="A product of three or five sines and cosines: rounding a tangent counts twice in sin^2 a.",
    claims={"B.35": "87fe4711f136"},
    forms="e58d699f0587",
)
def volume_of_five_wheels(a):
    """Volume of the envelope of six wheels of which the last has failed.

    volume = 72*sqrt(3)*sin(a)**2*cos(a)

    >>> format(volume_of_five_wheels(0.79), ".6g")
    '44.2914'
    """
    tan_a = tan(a)
    t8 = 72.0 * tan_a / (sqrt((1.0 / 3.0) + (1.0 / 3.0) * (tan_a * tan_a)) * (1.0 / tan_a + tan_a))
    return t8


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("b", "angle of the side edges in the plane OXY", "rad", low="0", high="pi/2"),
    Argument("J_x", "moment of inertia about OX", "kg m^2", low="0"),
    Argument("J_y", "moment of inertia about OY", "kg m^2", low="0"),
    Argument("J_z", "moment of inertia about OZ", "kg m^2", low="0"),
    Output("w_x", "largest angular rate about OX", "units of h_max/(kg m^2)"),
    Output("w_y", "largest angular rate about OY", "units of h_max/(kg m^2)"),
    Output("w_z", "largest angular rate about OZ", "units of h_max/(kg m^2)"),
    ulp=6,
    condition="Tangents of two angles, a root and a quotient are rounded one after the other.",
    claims={"2.3.2": "5e8b7ff65c34", "2.3.3": "fbeef966f1d7", "2.3.4": "1914201561bb", "2.3": "57003d67dcfa"},
)
def largest_rates_of_four_wheels(a, b, J_x, J_y, J_z):
    """Largest angular rates about each axis alone that four wheels can give a body, in absolute value.

    w_x = 4*sin(a)*sin(b)/J_x
    w_y = 4*sin(a)*cos(b)/J_y
    w_z = 4*cos(a)/J_z

    >>> [f"{x:.6g}" for x in largest_rates_of_four_wheels(0.26, 0.52, 0.5, 0.67, 0.83)]
    ['1.02191', '1.33194', '4.6573']
    """
    t1 = 4.0 * sin(a)
    w_x = sin(b) * t1 / J_x
    w_y = cos(b) * t1 / J_y
    w_z = 4.0 * cos(a) / J_z
    return w_x, w_y, w_z


@for_arrays(largest_rates_of_four_wheels)
def _largest_rates_of_four_wheels(a, b, J_x, J_y, J_z):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    tan_a = tan(a)
    t2 = sqrt(1.0 + tan_a * tan_a)
    t4 = 4.0 * tan_a / t2
    tan_b = tan(b)
    t6 = sqrt(1.0 + tan_b * tan_b)
    w_x = t4 * tan_b / (J_x * t6)
    w_y = t4 / (J_y * t6)
    w_z = 4.0 / (J_z * t2)
    return w_x, w_y, w_z


@kernel(
    Argument("a", "angle between the axis of a wheel and OZ", "rad", low="0", high="pi/2"),
    Argument("J_x", "moment of inertia about OX", "kg m^2", low="0"),
    Argument("J_y", "moment of inertia about OY", "kg m^2", low="0"),
    Argument("J_z", "moment of inertia about OZ", "kg m^2", low="0"),
    Output("w_x", "largest angular rate about OX", "units of h_max/(kg m^2)"),
    Output("w_y", "largest angular rate about OY", "units of h_max/(kg m^2)"),
    Output("w_z", "largest angular rate about OZ", "units of h_max/(kg m^2)"),
    ulp=4,
    claims={"3.2.26": "32f7d6819c02", "3.2.27": "2037c978fcea", "3.2.28": "910d9ae68049", "2.3": "57003d67dcfa"},
)
def largest_rates_of_six_wheels(a, J_x, J_y, J_z):
    """Largest angular rates about each axis alone that six wheels can give a body, in absolute value.

    w_x = 2*sqrt(3)*sin(a)/J_x
    w_y = 4*sin(a)/J_y
    w_z = 6*cos(a)/J_z

    >>> [f"{x:.6g}" for x in largest_rates_of_six_wheels(0.31, 0.4, 0.6, 0.8)]
    ['2.64189', '2.03372', '7.1425']
    """
    sin_a = sin(a)
    w_x = 2.0 * (sin_a * sqrt(3.0)) / J_x
    w_y = 4.0 * sin_a / J_y
    w_z = 6.0 * cos(a) / J_z
    return w_x, w_y, w_z


@for_arrays(largest_rates_of_six_wheels)
def _largest_rates_of_six_wheels(a, J_x, J_y, J_z):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
    tan_a = tan(a)
    t2 = sqrt(1.0 + tan_a * tan_a)
    w_x = 2.0 * (sqrt(3.0) * tan_a) / (J_x * t2)
    w_y = 4.0 * tan_a / (J_y * t2)
    w_z = 6.0 / (J_z * t2)
    return w_x, w_y, w_z


@kernel(
    Argument("J_x", "moment of inertia about OX", "kg m^2", low="0"),
    Argument("J_y", "moment of inertia about OY", "kg m^2", low="0"),
    Argument("J_z", "moment of inertia about OZ", "kg m^2", low="0"),
    Output("a", "angle between the axis of a wheel and OZ", "rad"),
    Output("b", "angle of the side edges in the plane OXY", "rad"),
    Output("w", "largest angular rate about each of the three axes", "units of h_max/(kg m^2)"),
    Output("w_any", "largest angular rate that is had about every axis, whatever its direction",
        "units of h_max/(kg m^2)"),
    ulp=4,
    degenerate="If the squares of the moments satisfy the triangle inequalities, no angles give a greater rate w_any.",
    claims={"B.16": "d7a5333dadbc", "B.17": "4955b8956930", "B.18": "0d3daf682064", "B.19": "b13534e6844f"},
)
def equal_rates_of_four_wheels(J_x, J_y, J_z):
    """Angles of four wheels with which the largest angular rates about OX, OY and OZ are equal.

    a = atan(sqrt(J_x**2 + J_y**2)/J_z)
    b = atan(J_x/J_y)
    w = 4/sqrt(J_x**2 + J_y**2 + J_z**2)
    w_any = 2*sqrt(2)/sqrt(J_x**2 + J_y**2 + J_z**2)

    >>> [f"{x:.6g}" for x in equal_rates_of_four_wheels(0.25, 0.5, 0.75)]
    ['0.640522', '0.463648', '4.27618', '3.02372']
    """
    t1 = J_x * J_x + J_y * J_y
    t4 = 1.0 / sqrt(J_z * J_z + t1)
    a = atan(sqrt(t1) / J_z)
    b = atan(J_x / J_y)
    w = 4.0 * t4
    w_any = 2.0 * (sqrt(2.0) * t4)
    return a, b, w, w_any


@kernel(
    Argument("J_x", "moment of inertia about OX", "kg m^2", low="0"),
    Argument("J_y", "moment of inertia about OY", "kg m^2", low="0"),
    Argument("J_z", "moment of inertia about OZ", "kg m^2", low="0"),
    Output("a", "angle between the axis of a wheel and OZ", "rad"),
    Output("w_x", "largest angular rate about OX", "units of h_max/(kg m^2)"),
    Output("w_y", "largest angular rate about OY, and about OZ", "units of h_max/(kg m^2)"),
    ulp=5,
    condition="The square root of 3 is rounded too.",
    claims={"3.2.26": "32f7d6819c02", "3.2.27": "2037c978fcea", "3.2.28": "910d9ae68049", "3.2.30": "70178405b3c5"},
)
def equal_rates_of_six_wheels(J_x, J_y, J_z):
    """Angle of six wheels with which the largest angular rates about OY and OZ are equal, and the largest rates.

    a = atan(3*J_y/(2*J_z))
    w_x = 6*sqrt(3)*J_y/(J_x*sqrt(9*J_y**2 + 4*J_z**2))
    w_y = 12/sqrt(9*J_y**2 + 4*J_z**2)

    >>> [f"{x:.6g}" for x in equal_rates_of_six_wheels(0.25, 0.5, 0.75)]
    ['0.785398', '9.79796', '5.65685']
    """
    t5 = 1.0 / sqrt(9.0 * (J_y * J_y) + 4.0 * (J_z * J_z))
    a = atan((3.0 / 2.0) * J_y / J_z)
    w_x = 6.0 * (sqrt(3.0) * (J_y * t5)) / J_x
    w_y = 12.0 * t5
    return a, w_x, w_y


@kernel(
    Argument("J_x", "moment of inertia about OX", "kg m^2", low="0"),
    Argument("J_y", "moment of inertia about OY", "kg m^2", low="0"),
    Argument("J_z", "moment of inertia about OZ", "kg m^2", low="0"),
    Output("a", "angle between the axis of a wheel and OZ", "rad"),
    Output("b", "angle of the side edges in the plane OXY", "rad"),
    Output("w", "largest angular rate that is had about every axis, whatever its direction",
        "units of h_max/(kg m^2)"),
    ulp=4,
    claims={"B.20": "ea69c53a240d", "B.21": "4c0bc2be9001"},
)
def best_angles_of_four_wheels(J_x, J_y, J_z):
    """Angles of four wheels with the greatest angular rate about every axis, for J_y^2 >= J_x^2 + J_z^2.

    a = atan(sqrt(J_x**2 + J_y*sqrt(J_x**2 + J_z**2))/J_z)
    b = atan(J_x/(sqrt(J_y)*(J_x**2 + J_z**2)**(1/4)))
    w = 4/(J_y + sqrt(J_x**2 + J_z**2))

    >>> [f"{x:.6g}" for x in best_angles_of_four_wheels(0.25, 0.5, 0.75)]
    ['0.733991', '0.378466', '3.09941']
    """
    J_x_squared = J_x * J_x
    t1 = J_x_squared + J_z * J_z
    t2 = sqrt(t1)
    a = atan(sqrt(J_x_squared + J_y * t2) / J_z)
    b = atan(J_x / (sqrt(J_y) * pow(t1, 1.0 / 4.0)))
    w = 4.0 / (J_y + t2)
    return a, b, w


@kernel(
    Argument("J_y", "moment of inertia about OY", "kg m^2", low="0"),
    Argument("J_z", "moment of inertia about OZ", "kg m^2", low="0"),
    Output("a", "angle between the axis of a wheel and OZ", "rad"),
    Output("w", "largest angular rate that this face allows about every axis, whatever its direction",
        "units of h_max/(kg m^2)"),
    ulp=4,
    degenerate="The other faces have to allow this rate too; for moments of 1000, 1600 and 800 kg m^2 they do.",
    claims={"B.38": "a94786f889f4", "B.39": "7f57aa82a899", "B.40": "cc848f2c1c52"},
)
def best_angle_of_six_wheels(J_y, J_z):
    """Angle of six wheels at which the face F_8 of the envelope allows the greatest angular rate about every axis.

    a = atan(sqrt(2)*sqrt(J_y/J_z))
    w = 8/(2*J_y + J_z)

    >>> [f"{x:.6g}" for x in best_angle_of_six_wheels(0.33, 0.67)]
    ['0.781639', '6.01504']
    """
    a = atan(sqrt(2.0) * sqrt(J_y / J_z))
    w = 8.0 / (J_z + 2.0 * J_y)
    return a, w


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
