"""Kernels of ignatov2005. Written by `symcheck generate`: what is changed here is lost."""

import math

from numpy import add, arctan, cos, divide, multiply, negative, power, sin, sqrt, subtract, tan, array, ndarray

from symcheck.kernels.runtime import DOUBLE, FEW, SMALL, evaluate, evaluate_alike, evaluate_handful

__all__ = ["axes_of_four_wheels", "axes_of_six_wheels", "best_angle_of_six_wheels", "best_angles_of_four_wheels", "equal_rates_of_four_wheels", "equal_rates_of_six_wheels", "face_distances_of_five_wheels", "face_distances_of_four_wheels", "face_distances_of_six_wheels", "face_distances_of_three_wheels", "largest_rates_of_four_wheels", "largest_rates_of_six_wheels", "momentum_of_five_wheels", "momentum_of_four_wheels", "momentum_of_six_wheels", "momentum_of_three_wheels", "rates_of_five_wheels", "rates_of_four_wheels", "rates_of_six_wheels", "rates_of_three_wheels", "vertex_distances_of_five_wheels", "vertex_distances_of_four_wheels", "vertex_distances_of_six_wheels", "vertex_distances_of_three_wheels", "vertices_of_five_wheels", "vertices_of_four_wheels", "vertices_of_six_wheels", "vertices_of_three_wheels", "volume_of_five_wheels", "volume_of_four_wheels", "volume_of_six_wheels", "volume_of_three_wheels"]

DECLARED = {  # name, meaning and unit of the arguments and of the results; docstrings may be stripped
    'axes_of_four_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('b', 'angle of the side edges in the plane OXY', 'rad'),
        ),
        (
            ('e_1x', 'x of e_1', '1'),
            ('e_1y', 'y of e_1', '1'),
            ('e_1z', 'z of e_1', '1'),
            ('e_2x', 'x of e_2', '1'),
            ('e_2y', 'y of e_2', '1'),
            ('e_2z', 'z of e_2', '1'),
            ('e_3x', 'x of e_3', '1'),
            ('e_3y', 'y of e_3', '1'),
            ('e_3z', 'z of e_3', '1'),
            ('e_4x', 'x of e_4', '1'),
            ('e_4y', 'y of e_4', '1'),
            ('e_4z', 'z of e_4', '1'),
        ),
    ),
    'axes_of_six_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
        ),
        (
            ('e_1y', 'y of e_1', '1'),
            ('e_1z', 'z of e_1', '1'),
            ('e_2x', 'x of e_2', '1'),
            ('e_2y', 'y of e_2', '1'),
            ('e_2z', 'z of e_2', '1'),
            ('e_3x', 'x of e_3', '1'),
            ('e_3y', 'y of e_3', '1'),
            ('e_3z', 'z of e_3', '1'),
            ('e_4y', 'y of e_4', '1'),
            ('e_4z', 'z of e_4', '1'),
            ('e_5x', 'x of e_5', '1'),
            ('e_5y', 'y of e_5', '1'),
            ('e_5z', 'z of e_5', '1'),
            ('e_6x', 'x of e_6', '1'),
            ('e_6y', 'y of e_6', '1'),
            ('e_6z', 'z of e_6', '1'),
        ),
    ),
    'momentum_of_four_wheels': (
        (
            ('h_1', 'momentum of wheel 1', 'units of h_max'),
            ('h_2', 'momentum of wheel 2', 'units of h_max'),
            ('h_3', 'momentum of wheel 3', 'units of h_max'),
            ('h_4', 'momentum of wheel 4', 'units of h_max'),
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('b', 'angle of the side edges in the plane OXY', 'rad'),
        ),
        (
            ('H_x', 'momentum along OX', 'units of h_max'),
            ('H_y', 'momentum along OY', 'units of h_max'),
            ('H_z', 'momentum along OZ', 'units of h_max'),
        ),
    ),
    'momentum_of_three_wheels': (
        (
            ('h_1', 'momentum of wheel 1', 'units of h_max'),
            ('h_2', 'momentum of wheel 2', 'units of h_max'),
            ('h_3', 'momentum of wheel 3', 'units of h_max'),
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('b', 'angle of the side edges in the plane OXY', 'rad'),
        ),
        (
            ('H_x', 'momentum along OX', 'units of h_max'),
            ('H_y', 'momentum along OY', 'units of h_max'),
            ('H_z', 'momentum along OZ', 'units of h_max'),
        ),
    ),
    'momentum_of_six_wheels': (
        (
            ('h_1', 'momentum of wheel 1', 'units of h_max'),
            ('h_2', 'momentum of wheel 2', 'units of h_max'),
            ('h_3', 'momentum of wheel 3', 'units of h_max'),
            ('h_4', 'momentum of wheel 4', 'units of h_max'),
            ('h_5', 'momentum of wheel 5', 'units of h_max'),
            ('h_6', 'momentum of wheel 6', 'units of h_max'),
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
        ),
        (
            ('H_x', 'momentum along OX', 'units of h_max'),
            ('H_y', 'momentum along OY', 'units of h_max'),
            ('H_z', 'momentum along OZ', 'units of h_max'),
        ),
    ),
    'momentum_of_five_wheels': (
        (
            ('h_1', 'momentum of wheel 1', 'units of h_max'),
            ('h_2', 'momentum of wheel 2', 'units of h_max'),
            ('h_3', 'momentum of wheel 3', 'units of h_max'),
            ('h_4', 'momentum of wheel 4', 'units of h_max'),
            ('h_5', 'momentum of wheel 5', 'units of h_max'),
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
        ),
        (
            ('H_x', 'momentum along OX', 'units of h_max'),
            ('H_y', 'momentum along OY', 'units of h_max'),
            ('H_z', 'momentum along OZ', 'units of h_max'),
        ),
    ),
    'rates_of_four_wheels': (
        (
            ('h_1', 'momentum of wheel 1', 'units of h_max'),
            ('h_2', 'momentum of wheel 2', 'units of h_max'),
            ('h_3', 'momentum of wheel 3', 'units of h_max'),
            ('h_4', 'momentum of wheel 4', 'units of h_max'),
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('b', 'angle of the side edges in the plane OXY', 'rad'),
            ('J_x', 'moment of inertia about OX', 'kg m^2'),
            ('J_y', 'moment of inertia about OY', 'kg m^2'),
            ('J_z', 'moment of inertia about OZ', 'kg m^2'),
        ),
        (
            ('w_x', 'angular rate about OX', 'units of h_max/(kg m^2)'),
            ('w_y', 'angular rate about OY', 'units of h_max/(kg m^2)'),
            ('w_z', 'angular rate about OZ', 'units of h_max/(kg m^2)'),
        ),
    ),
    'rates_of_three_wheels': (
        (
            ('h_1', 'momentum of wheel 1', 'units of h_max'),
            ('h_2', 'momentum of wheel 2', 'units of h_max'),
            ('h_3', 'momentum of wheel 3', 'units of h_max'),
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('b', 'angle of the side edges in the plane OXY', 'rad'),
            ('J_x', 'moment of inertia about OX', 'kg m^2'),
            ('J_y', 'moment of inertia about OY', 'kg m^2'),
            ('J_z', 'moment of inertia about OZ', 'kg m^2'),
        ),
        (
            ('w_x', 'angular rate about OX', 'units of h_max/(kg m^2)'),
            ('w_y', 'angular rate about OY', 'units of h_max/(kg m^2)'),
            ('w_z', 'angular rate about OZ', 'units of h_max/(kg m^2)'),
        ),
    ),
    'rates_of_six_wheels': (
        (
            ('h_1', 'momentum of wheel 1', 'units of h_max'),
            ('h_2', 'momentum of wheel 2', 'units of h_max'),
            ('h_3', 'momentum of wheel 3', 'units of h_max'),
            ('h_4', 'momentum of wheel 4', 'units of h_max'),
            ('h_5', 'momentum of wheel 5', 'units of h_max'),
            ('h_6', 'momentum of wheel 6', 'units of h_max'),
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('J_x', 'moment of inertia about OX', 'kg m^2'),
            ('J_y', 'moment of inertia about OY', 'kg m^2'),
            ('J_z', 'moment of inertia about OZ', 'kg m^2'),
        ),
        (
            ('w_x', 'angular rate about OX', 'units of h_max/(kg m^2)'),
            ('w_y', 'angular rate about OY', 'units of h_max/(kg m^2)'),
            ('w_z', 'angular rate about OZ', 'units of h_max/(kg m^2)'),
        ),
    ),
    'rates_of_five_wheels': (
        (
            ('h_1', 'momentum of wheel 1', 'units of h_max'),
            ('h_2', 'momentum of wheel 2', 'units of h_max'),
            ('h_3', 'momentum of wheel 3', 'units of h_max'),
            ('h_4', 'momentum of wheel 4', 'units of h_max'),
            ('h_5', 'momentum of wheel 5', 'units of h_max'),
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('J_x', 'moment of inertia about OX', 'kg m^2'),
            ('J_y', 'moment of inertia about OY', 'kg m^2'),
            ('J_z', 'moment of inertia about OZ', 'kg m^2'),
        ),
        (
            ('w_x', 'angular rate about OX', 'units of h_max/(kg m^2)'),
            ('w_y', 'angular rate about OY', 'units of h_max/(kg m^2)'),
            ('w_z', 'angular rate about OZ', 'units of h_max/(kg m^2)'),
        ),
    ),
    'vertices_of_four_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('b', 'angle of the side edges in the plane OXY', 'rad'),
        ),
        (
            ('V_1x', 'x of V_1', 'units of h_max'),
            ('V_2x', 'x of V_2', 'units of h_max'),
            ('V_2y', 'y of V_2', 'units of h_max'),
            ('V_2z', 'z of V_2', 'units of h_max'),
            ('V_3x', 'x of V_3', 'units of h_max'),
            ('V_3y', 'y of V_3', 'units of h_max'),
            ('V_3z', 'z of V_3', 'units of h_max'),
            ('V_4x', 'x of V_4', 'units of h_max'),
            ('V_4y', 'y of V_4', 'units of h_max'),
            ('V_4z', 'z of V_4', 'units of h_max'),
            ('V_5x', 'x of V_5', 'units of h_max'),
            ('V_5y', 'y of V_5', 'units of h_max'),
            ('V_5z', 'z of V_5', 'units of h_max'),
            ('V_6y', 'y of V_6', 'units of h_max'),
            ('V_7z', 'z of V_7', 'units of h_max'),
        ),
    ),
    'vertices_of_three_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('b', 'angle of the side edges in the plane OXY', 'rad'),
        ),
        (
            ('V_1x', 'x of V_1', 'units of h_max'),
            ('V_1y', 'y of V_1', 'units of h_max'),
            ('V_1z', 'z of V_1', 'units of h_max'),
            ('V_2x', 'x of V_2', 'units of h_max'),
            ('V_2y', 'y of V_2', 'units of h_max'),
            ('V_2z', 'z of V_2', 'units of h_max'),
            ('V_3x', 'x of V_3', 'units of h_max'),
            ('V_3y', 'y of V_3', 'units of h_max'),
            ('V_3z', 'z of V_3', 'units of h_max'),
            ('V_4x', 'x of V_4', 'units of h_max'),
            ('V_4y', 'y of V_4', 'units of h_max'),
            ('V_4z', 'z of V_4', 'units of h_max'),
        ),
    ),
    'vertices_of_six_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
        ),
        (
            ('V_1z', 'z of V_1', 'units of h_max'),
            ('V_2y', 'y of V_2', 'units of h_max'),
            ('V_2z', 'z of V_2', 'units of h_max'),
            ('V_3x', 'x of V_3', 'units of h_max'),
            ('V_3y', 'y of V_3', 'units of h_max'),
            ('V_3z', 'z of V_3', 'units of h_max'),
            ('V_4x', 'x of V_4', 'units of h_max'),
            ('V_4y', 'y of V_4', 'units of h_max'),
            ('V_4z', 'z of V_4', 'units of h_max'),
            ('V_5y', 'y of V_5', 'units of h_max'),
            ('V_5z', 'z of V_5', 'units of h_max'),
            ('V_6x', 'x of V_6', 'units of h_max'),
            ('V_6y', 'y of V_6', 'units of h_max'),
            ('V_6z', 'z of V_6', 'units of h_max'),
            ('V_7x', 'x of V_7', 'units of h_max'),
            ('V_7y', 'y of V_7', 'units of h_max'),
            ('V_7z', 'z of V_7', 'units of h_max'),
            ('V_8x', 'x of V_8', 'units of h_max'),
            ('V_8y', 'y of V_8', 'units of h_max'),
            ('V_8z', 'z of V_8', 'units of h_max'),
            ('V_9x', 'x of V_9', 'units of h_max'),
            ('V_9y', 'y of V_9', 'units of h_max'),
            ('V_9z', 'z of V_9', 'units of h_max'),
            ('V_10x', 'x of V_10', 'units of h_max'),
            ('V_10z', 'z of V_10', 'units of h_max'),
            ('V_11x', 'x of V_11', 'units of h_max'),
            ('V_11y', 'y of V_11', 'units of h_max'),
            ('V_11z', 'z of V_11', 'units of h_max'),
            ('V_12x', 'x of V_12', 'units of h_max'),
            ('V_12y', 'y of V_12', 'units of h_max'),
            ('V_12z', 'z of V_12', 'units of h_max'),
            ('V_13x', 'x of V_13', 'units of h_max'),
            ('V_13z', 'z of V_13', 'units of h_max'),
            ('V_14x', 'x of V_14', 'units of h_max'),
            ('V_14y', 'y of V_14', 'units of h_max'),
            ('V_15y', 'y of V_15', 'units of h_max'),
            ('V_16x', 'x of V_16', 'units of h_max'),
            ('V_16y', 'y of V_16', 'units of h_max'),
        ),
    ),
    'vertices_of_five_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
        ),
        (
            ('V_1x', 'x of V_1', 'units of h_max'),
            ('V_1y', 'y of V_1', 'units of h_max'),
            ('V_1z', 'z of V_1', 'units of h_max'),
            ('V_2x', 'x of V_2', 'units of h_max'),
            ('V_2y', 'y of V_2', 'units of h_max'),
            ('V_2z', 'z of V_2', 'units of h_max'),
            ('V_3x', 'x of V_3', 'units of h_max'),
            ('V_3y', 'y of V_3', 'units of h_max'),
            ('V_3z', 'z of V_3', 'units of h_max'),
            ('V_4x', 'x of V_4', 'units of h_max'),
            ('V_4y', 'y of V_4', 'units of h_max'),
            ('V_4z', 'z of V_4', 'units of h_max'),
            ('V_5x', 'x of V_5', 'units of h_max'),
            ('V_5y', 'y of V_5', 'units of h_max'),
            ('V_5z', 'z of V_5', 'units of h_max'),
            ('V_6x', 'x of V_6', 'units of h_max'),
            ('V_6y', 'y of V_6', 'units of h_max'),
            ('V_6z', 'z of V_6', 'units of h_max'),
            ('V_7x', 'x of V_7', 'units of h_max'),
            ('V_7y', 'y of V_7', 'units of h_max'),
            ('V_7z', 'z of V_7', 'units of h_max'),
            ('V_8x', 'x of V_8', 'units of h_max'),
            ('V_8y', 'y of V_8', 'units of h_max'),
            ('V_8z', 'z of V_8', 'units of h_max'),
            ('V_9x', 'x of V_9', 'units of h_max'),
            ('V_9y', 'y of V_9', 'units of h_max'),
            ('V_9z', 'z of V_9', 'units of h_max'),
            ('V_10x', 'x of V_10', 'units of h_max'),
            ('V_10y', 'y of V_10', 'units of h_max'),
            ('V_10z', 'z of V_10', 'units of h_max'),
            ('V_11x', 'x of V_11', 'units of h_max'),
            ('V_11y', 'y of V_11', 'units of h_max'),
            ('V_11z', 'z of V_11', 'units of h_max'),
        ),
    ),
    'vertex_distances_of_four_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('b', 'angle of the side edges in the plane OXY', 'rad'),
        ),
        (
            ('d_1', 'distance of V_1', 'units of h_max'),
            ('d_2', 'distance of V_6', 'units of h_max'),
            ('d_3', 'distance of V_7 (V_2 to V_5 are 2 away at all angles)', 'units of h_max'),
        ),
    ),
    'vertex_distances_of_three_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('b', 'angle of the side edges in the plane OXY', 'rad'),
        ),
        (
            ('d_1', 'distance of V_1', 'units of h_max'),
            ('d_2', 'distance of V_3', 'units of h_max'),
            ('d_3', 'distance of V_4 (V_2 is 1 away at all angles)', 'units of h_max'),
        ),
    ),
    'vertex_distances_of_six_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
        ),
        (
            ('d_1', 'distance of V_1', 'units of h_max'),
            ('d_2', 'distance of V_14 to V_16', 'units of h_max'),
            ('d_3', 'distance of V_2 to V_7', 'units of h_max'),
            ('d_4', 'distance of V_8 to V_13', 'units of h_max'),
        ),
    ),
    'vertex_distances_of_five_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
        ),
        (
            ('d_1', 'distance of V_1', 'units of h_max'),
            ('d_2', 'distance of V_2 and V_6', 'units of h_max'),
            ('d_3', 'distance of V_3 and V_5', 'units of h_max'),
            ('d_4', 'distance of V_4', 'units of h_max'),
            ('d_5', 'distance of V_7', 'units of h_max'),
            ('d_6', 'distance of V_8 and V_11', 'units of h_max'),
            ('d_7', 'distance of V_9 and V_10', 'units of h_max'),
        ),
    ),
    'face_distances_of_four_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('b', 'angle of the side edges in the plane OXY', 'rad'),
        ),
        (
            ('r_1', 'distance of F_1 and F_5', 'units of h_max'),
            ('r_2', 'distance of F_2 and F_4', 'units of h_max'),
            ('r_3', 'distance of F_3 and F_6', 'units of h_max'),
        ),
    ),
    'face_distances_of_three_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('b', 'angle of the side edges in the plane OXY', 'rad'),
        ),
        (
            ('r_1', 'distance of F_1', 'units of h_max'),
            ('r_2', 'distance of F_2', 'units of h_max'),
            ('r_3', 'distance of F_3', 'units of h_max'),
        ),
    ),
    'face_distances_of_six_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
        ),
        (
            ('r_1', 'distance of F_1 to F_6', 'units of h_max'),
            ('r_2', 'distance of F_7 to F_12', 'units of h_max'),
            ('r_3', 'distance of F_13 to F_15', 'units of h_max'),
        ),
    ),
    'face_distances_of_five_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
        ),
        (
            ('r_1', 'distance of F_1', 'units of h_max'),
            ('r_2', 'distance of F_2 and F_5', 'units of h_max'),
            ('r_3', 'distance of F_3 and F_4', 'units of h_max'),
            ('r_4', 'distance of F_6 and F_8', 'units of h_max'),
            ('r_5', 'distance of F_7', 'units of h_max'),
            ('r_6', 'distance of F_9 and F_10', 'units of h_max'),
        ),
    ),
    'volume_of_four_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('b', 'angle of the side edges in the plane OXY', 'rad'),
        ),
        (
            ('volume', 'volume', 'units of h_max^3'),
        ),
    ),
    'volume_of_three_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('b', 'angle of the side edges in the plane OXY', 'rad'),
        ),
        (
            ('volume', 'volume', 'units of h_max^3'),
        ),
    ),
    'volume_of_six_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
        ),
        (
            ('volume', 'volume', 'units of h_max^3'),
        ),
    ),
    'volume_of_five_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
        ),
        (
            ('volume', 'volume', 'units of h_max^3'),
        ),
    ),
    'largest_rates_of_four_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('b', 'angle of the side edges in the plane OXY', 'rad'),
            ('J_x', 'moment of inertia about OX', 'kg m^2'),
            ('J_y', 'moment of inertia about OY', 'kg m^2'),
            ('J_z', 'moment of inertia about OZ', 'kg m^2'),
        ),
        (
            ('w_x', 'largest angular rate about OX', 'units of h_max/(kg m^2)'),
            ('w_y', 'largest angular rate about OY', 'units of h_max/(kg m^2)'),
            ('w_z', 'largest angular rate about OZ', 'units of h_max/(kg m^2)'),
        ),
    ),
    'largest_rates_of_six_wheels': (
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('J_x', 'moment of inertia about OX', 'kg m^2'),
            ('J_y', 'moment of inertia about OY', 'kg m^2'),
            ('J_z', 'moment of inertia about OZ', 'kg m^2'),
        ),
        (
            ('w_x', 'largest angular rate about OX', 'units of h_max/(kg m^2)'),
            ('w_y', 'largest angular rate about OY', 'units of h_max/(kg m^2)'),
            ('w_z', 'largest angular rate about OZ', 'units of h_max/(kg m^2)'),
        ),
    ),
    'equal_rates_of_four_wheels': (
        (
            ('J_x', 'moment of inertia about OX', 'kg m^2'),
            ('J_y', 'moment of inertia about OY', 'kg m^2'),
            ('J_z', 'moment of inertia about OZ', 'kg m^2'),
        ),
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('b', 'angle of the side edges in the plane OXY', 'rad'),
            ('w', 'largest angular rate about each of the three axes', 'units of h_max/(kg m^2)'),
            ('w_any', 'largest angular rate that is had about every axis, whatever its direction', 'units of h_max/(kg m^2)'),
        ),
    ),
    'equal_rates_of_six_wheels': (
        (
            ('J_x', 'moment of inertia about OX', 'kg m^2'),
            ('J_y', 'moment of inertia about OY', 'kg m^2'),
            ('J_z', 'moment of inertia about OZ', 'kg m^2'),
        ),
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('w_x', 'largest angular rate about OX', 'units of h_max/(kg m^2)'),
            ('w_y', 'largest angular rate about OY, and about OZ', 'units of h_max/(kg m^2)'),
        ),
    ),
    'best_angles_of_four_wheels': (
        (
            ('J_x', 'moment of inertia about OX', 'kg m^2'),
            ('J_y', 'moment of inertia about OY', 'kg m^2'),
            ('J_z', 'moment of inertia about OZ', 'kg m^2'),
        ),
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('b', 'angle of the side edges in the plane OXY', 'rad'),
            ('w', 'largest angular rate that is had about every axis, whatever its direction', 'units of h_max/(kg m^2)'),
        ),
    ),
    'best_angle_of_six_wheels': (
        (
            ('J_y', 'moment of inertia about OY', 'kg m^2'),
            ('J_z', 'moment of inertia about OZ', 'kg m^2'),
        ),
        (
            ('a', 'angle between the axis of a wheel and OZ', 'rad'),
            ('w', 'largest angular rate that this face allows about every axis, whatever its direction', 'units of h_max/(kg m^2)'),
        ),
    ),
}


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

    Rests on ignatov2005:2.0.1 (sha256 4aa675013ce7), ignatov2005:2.0.3 (sha256 1c82bd5484cb), ignatov2005:2.0.5
    (sha256 22085680dfdc).
    """
    if out is None:
        try:
            if float is type(a) is type(b):
                return _axes_of_four_wheels(a, b)
            if ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                size = a.size
                if size <= FEW:
                    return _axes_of_four_wheels_few(a, b)
                if size <= SMALL:
                    return _axes_of_four_wheels_block(a, b)
                return evaluate_alike(_axes_of_four_wheels_block, 5, (0, 1, 2, 0, 3, 2, 0, 1, 4, 0, 3, 4,), (a, b,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_axes_of_four_wheels_block, 5, (0, 1, 2, 0, 3, 2, 0, 1, 4, 0, 3, 4,), (a, b,), out)


def _axes_of_four_wheels(a, b):
    sin_a = math.sin(a)
    t1 = sin_a * math.sin(b)
    t2 = math.cos(b) * sin_a
    t3 = -t2
    cos_a = math.cos(a)
    t4 = -cos_a
    return t1, t3, t4, t1, t2, t4, t1, t3, cos_a, t1, t2, cos_a


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


def _axes_of_four_wheels_block(a, b, out_e_1x=None, out_e_1y=None, out_e_1z=None, out_e_2y=None, out_e_3z=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0)):
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

    Rests on ignatov2005:3.0.3 (sha256 90b688855734), ignatov2005:3.0.5 (sha256 881325f58b02), ignatov2005:3.0.6
    (sha256 55b7b4360f8d).
    """
    if out is None:
        try:
            if float is type(a):
                return _axes_of_six_wheels(a)
            if ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                size = a.size
                if size <= FEW:
                    return _axes_of_six_wheels_few(a)
                if size <= SMALL:
                    return _axes_of_six_wheels_block(a)
                return evaluate_alike(_axes_of_six_wheels_block, 3, (0, 1, 2, 3, 1, 2, 4, 1, 0, 5, 2, 3, 5, 2, 4, 5,), (a,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_axes_of_six_wheels_block, 3, (0, 1, 2, 3, 1, 2, 4, 1, 0, 5, 2, 3, 5, 2, 4, 5,), (a,), out)


def _axes_of_six_wheels(a):
    sin_a = math.sin(a)
    t1 = -sin_a
    cos_a = math.cos(a)
    t2 = (1.0 / 2.0) * sin_a
    t3 = math.sqrt(3.0) * t2
    t4 = -t2
    t5 = -cos_a
    return t1, cos_a, t3, t4, cos_a, t3, t2, cos_a, t1, t5, t3, t4, t5, t3, t2, t5


def _axes_of_six_wheels_few(a, out_e_1y=None, out_e_1z=None, out_e_2x=None, out_e_2y=None, out_e_3y=None, out_e_4z=None, r0=None, n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0))):
    r0 = sin(a, r0)  # sin_a
    out_e_1y = negative(r0, out_e_1y)  # t1
    out_e_1z = cos(a, out_e_1z)  # cos_a
    out_e_3y = multiply(n1_2, r0, out_e_3y)  # t2
    out_e_2x = multiply(sqrt_3, out_e_3y, out_e_2x)  # t3
    out_e_2y = negative(out_e_3y, out_e_2y)  # t4
    out_e_4z = negative(out_e_1z, out_e_4z)  # t5
    return out_e_1y, out_e_1z, out_e_2x, out_e_2y, out_e_1z, out_e_2x, out_e_3y, out_e_1z, out_e_1y, out_e_4z, out_e_2x, out_e_2y, out_e_4z, out_e_2x, out_e_3y, out_e_4z


def _axes_of_six_wheels_block(a, out_e_1y=None, out_e_1z=None, out_e_2x=None, out_e_2y=None, out_e_3y=None, out_e_4z=None, r0=None, r1=None, r2=None, n1=array(1.0), n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0))):
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

    Rests on ignatov2005:2.1.2 (sha256 6aba2017cbeb).
    """
    if out is None:
        try:
            if float is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(a) is type(b):
                return _momentum_of_four_wheels(h_1, h_2, h_3, h_4, a, b)
            if ndarray is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(a) is type(b) and DOUBLE is h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is a.dtype is b.dtype and () != h_1.shape == h_2.shape == h_3.shape == h_4.shape == a.shape == b.shape:
                size = h_1.size
                if 0 < size <= 4:
                    return evaluate_handful(_momentum_of_four_wheels, (h_1, h_2, h_3, h_4, a, b,))
                if size <= FEW:
                    return _momentum_of_four_wheels_few(h_1, h_2, h_3, h_4, a, b)
                if size <= SMALL:
                    return _momentum_of_four_wheels_block(h_1, h_2, h_3, h_4, a, b)
                return evaluate_alike(_momentum_of_four_wheels_block, 8, (0, 1, 2,), (h_1, h_2, h_3, h_4, a, b,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_momentum_of_four_wheels_block, 8, (0, 1, 2,), (h_1, h_2, h_3, h_4, a, b,), out)


def _momentum_of_four_wheels(h_1, h_2, h_3, h_4, a, b):
    sin_a = math.sin(a)
    t1 = h_1 + h_3
    t2 = -h_4
    return math.sin(b) * (sin_a * (t1 + (h_2 + h_4))), math.cos(b) * (sin_a * ((h_2 - t1) - t2)), math.cos(a) * (((h_3 - h_1) - h_2) - t2)


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


def _momentum_of_four_wheels_block(h_1, h_2, h_3, h_4, a, b, out_H_x=None, out_H_y=None, out_H_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, n1=array(1.0)):
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

    Rests on ignatov2005:2.2.1 (sha256 a4e05c48da78).
    """
    if out is None:
        try:
            if float is type(h_1) is type(h_2) is type(h_3) is type(a) is type(b):
                return _momentum_of_three_wheels(h_1, h_2, h_3, a, b)
            if ndarray is type(h_1) is type(h_2) is type(h_3) is type(a) is type(b) and DOUBLE is h_1.dtype is h_2.dtype is h_3.dtype is a.dtype is b.dtype and () != h_1.shape == h_2.shape == h_3.shape == a.shape == b.shape:
                size = h_1.size
                if 0 < size <= 2:
                    return evaluate_handful(_momentum_of_three_wheels, (h_1, h_2, h_3, a, b,))
                if size <= FEW:
                    return _momentum_of_three_wheels_few(h_1, h_2, h_3, a, b)
                if size <= SMALL:
                    return _momentum_of_three_wheels_block(h_1, h_2, h_3, a, b)
                return evaluate_alike(_momentum_of_three_wheels_block, 7, (0, 1, 2,), (h_1, h_2, h_3, a, b,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_momentum_of_three_wheels_block, 7, (0, 1, 2,), (h_1, h_2, h_3, a, b,), out)


def _momentum_of_three_wheels(h_1, h_2, h_3, a, b):
    sin_a = math.sin(a)
    t1 = h_1 + h_3
    return math.sin(b) * (sin_a * (h_2 + t1)), math.cos(b) * (sin_a * (h_2 - t1)), math.cos(a) * ((h_3 - h_1) - h_2)


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


def _momentum_of_three_wheels_block(h_1, h_2, h_3, a, b, out_H_x=None, out_H_y=None, out_H_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, n1=array(1.0)):
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

    Rests on ignatov2005:3.1.2 (sha256 8758872a0c67).
    """
    if out is None:
        try:
            if float is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(h_6) is type(a):
                return _momentum_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a)
            if ndarray is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(h_6) is type(a) and DOUBLE is h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is h_5.dtype is h_6.dtype is a.dtype and () != h_1.shape == h_2.shape == h_3.shape == h_4.shape == h_5.shape == h_6.shape == a.shape:
                size = h_1.size
                if 0 < size <= 5:
                    return evaluate_handful(_momentum_of_six_wheels, (h_1, h_2, h_3, h_4, h_5, h_6, a,))
                if size <= FEW:
                    return _momentum_of_six_wheels_few(h_1, h_2, h_3, h_4, h_5, h_6, a)
                if size <= SMALL:
                    return _momentum_of_six_wheels_block(h_1, h_2, h_3, h_4, h_5, h_6, a)
                return evaluate_alike(_momentum_of_six_wheels_block, 6, (0, 1, 2,), (h_1, h_2, h_3, h_4, h_5, h_6, a,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_momentum_of_six_wheels_block, 6, (0, 1, 2,), (h_1, h_2, h_3, h_4, h_5, h_6, a,), out)


def _momentum_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a):
    t1 = h_2 + h_5
    t2 = (1.0 / 2.0) * math.sin(a)
    t3 = -h_6
    return (t1 + (h_3 + h_6)) * (math.sqrt(3.0) * t2), ((((h_3 - (2.0 * h_1)) - (2.0 * h_4)) - t1) - t3) * t2, math.cos(a) * ((((h_3 + (h_1 + h_2)) + t3) - h_4) - h_5)


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


def _momentum_of_six_wheels_block(h_1, h_2, h_3, h_4, h_5, h_6, a, out_H_x=None, out_H_y=None, out_H_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, n1=array(1.0), n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n2=array(2.0)):
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

    Rests on ignatov2005:3.2.1 (sha256 d524ffea3256).
    """
    if out is None:
        try:
            if float is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(a):
                return _momentum_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a)
            if ndarray is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(a) and DOUBLE is h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is h_5.dtype is a.dtype and () != h_1.shape == h_2.shape == h_3.shape == h_4.shape == h_5.shape == a.shape:
                size = h_1.size
                if 0 < size <= 4:
                    return evaluate_handful(_momentum_of_five_wheels, (h_1, h_2, h_3, h_4, h_5, a,))
                if size <= FEW:
                    return _momentum_of_five_wheels_few(h_1, h_2, h_3, h_4, h_5, a)
                if size <= SMALL:
                    return _momentum_of_five_wheels_block(h_1, h_2, h_3, h_4, h_5, a)
                return evaluate_alike(_momentum_of_five_wheels_block, 5, (0, 1, 2,), (h_1, h_2, h_3, h_4, h_5, a,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_momentum_of_five_wheels_block, 5, (0, 1, 2,), (h_1, h_2, h_3, h_4, h_5, a,), out)


def _momentum_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a):
    t1 = h_2 + h_5
    t2 = (1.0 / 2.0) * math.sin(a)
    return (h_3 + t1) * (math.sqrt(3.0) * t2), (((h_3 - (2.0 * h_1)) - (2.0 * h_4)) - t1) * t2, math.cos(a) * (((h_3 + (h_1 + h_2)) - h_4) - h_5)


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


def _momentum_of_five_wheels_block(h_1, h_2, h_3, h_4, h_5, a, out_H_x=None, out_H_y=None, out_H_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0), n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n2=array(2.0)):
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

    Rests on ignatov2005:2.1.2 (sha256 6aba2017cbeb), ignatov2005:2.3 (sha256 57003d67dcfa).
    """
    if out is None:
        try:
            if float is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(a) is type(b) is type(J_x) is type(J_y) is type(J_z):
                return _rates_of_four_wheels(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z)
            if ndarray is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(a) is type(b) is type(J_x) is type(J_y) is type(J_z) and DOUBLE is h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is a.dtype is b.dtype is J_x.dtype is J_y.dtype is J_z.dtype and () != h_1.shape == h_2.shape == h_3.shape == h_4.shape == a.shape == b.shape == J_x.shape == J_y.shape == J_z.shape:
                size = h_1.size
                if 0 < size <= 6:
                    return evaluate_handful(_rates_of_four_wheels, (h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z,))
                if size <= FEW:
                    return _rates_of_four_wheels_few(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z)
                if size <= SMALL:
                    return _rates_of_four_wheels_block(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z)
                return evaluate_alike(_rates_of_four_wheels_block, 8, (0, 1, 2,), (h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_rates_of_four_wheels_block, 8, (0, 1, 2,), (h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z,), out)


def _rates_of_four_wheels(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z):
    sin_a = math.sin(a)
    t1 = h_1 + h_3
    t2 = -h_4
    return -((math.sin(b) * (sin_a * (t1 + (h_2 + h_4)))) / J_x), -((math.cos(b) * (sin_a * ((h_2 - t1) - t2))) / J_y), -((math.cos(a) * (((h_3 - h_1) - h_2) - t2)) / J_z)


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


def _rates_of_four_wheels_block(h_1, h_2, h_3, h_4, a, b, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, n1=array(1.0)):
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

    Rests on ignatov2005:2.2.1 (sha256 a4e05c48da78), ignatov2005:2.3 (sha256 57003d67dcfa).
    """
    if out is None:
        try:
            if float is type(h_1) is type(h_2) is type(h_3) is type(a) is type(b) is type(J_x) is type(J_y) is type(J_z):
                return _rates_of_three_wheels(h_1, h_2, h_3, a, b, J_x, J_y, J_z)
            if ndarray is type(h_1) is type(h_2) is type(h_3) is type(a) is type(b) is type(J_x) is type(J_y) is type(J_z) and DOUBLE is h_1.dtype is h_2.dtype is h_3.dtype is a.dtype is b.dtype is J_x.dtype is J_y.dtype is J_z.dtype and () != h_1.shape == h_2.shape == h_3.shape == a.shape == b.shape == J_x.shape == J_y.shape == J_z.shape:
                size = h_1.size
                if 0 < size <= 4:
                    return evaluate_handful(_rates_of_three_wheels, (h_1, h_2, h_3, a, b, J_x, J_y, J_z,))
                if size <= FEW:
                    return _rates_of_three_wheels_few(h_1, h_2, h_3, a, b, J_x, J_y, J_z)
                if size <= SMALL:
                    return _rates_of_three_wheels_block(h_1, h_2, h_3, a, b, J_x, J_y, J_z)
                return evaluate_alike(_rates_of_three_wheels_block, 7, (0, 1, 2,), (h_1, h_2, h_3, a, b, J_x, J_y, J_z,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_rates_of_three_wheels_block, 7, (0, 1, 2,), (h_1, h_2, h_3, a, b, J_x, J_y, J_z,), out)


def _rates_of_three_wheels(h_1, h_2, h_3, a, b, J_x, J_y, J_z):
    sin_a = math.sin(a)
    t1 = h_1 + h_3
    return -((math.sin(b) * (sin_a * (h_2 + t1))) / J_x), -((math.cos(b) * (sin_a * (h_2 - t1))) / J_y), -((math.cos(a) * ((h_3 - h_1) - h_2)) / J_z)


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


def _rates_of_three_wheels_block(h_1, h_2, h_3, a, b, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, n1=array(1.0)):
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

    Rests on ignatov2005:3.1.2 (sha256 8758872a0c67), ignatov2005:2.3 (sha256 57003d67dcfa).
    """
    if out is None:
        try:
            if float is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(h_6) is type(a) is type(J_x) is type(J_y) is type(J_z):
                return _rates_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z)
            if ndarray is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(h_6) is type(a) is type(J_x) is type(J_y) is type(J_z) and DOUBLE is h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is h_5.dtype is h_6.dtype is a.dtype is J_x.dtype is J_y.dtype is J_z.dtype and () != h_1.shape == h_2.shape == h_3.shape == h_4.shape == h_5.shape == h_6.shape == a.shape == J_x.shape == J_y.shape == J_z.shape:
                size = h_1.size
                if 0 < size <= 7:
                    return evaluate_handful(_rates_of_six_wheels, (h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z,))
                if size <= FEW:
                    return _rates_of_six_wheels_few(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z)
                if size <= SMALL:
                    return _rates_of_six_wheels_block(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z)
                return evaluate_alike(_rates_of_six_wheels_block, 6, (0, 1, 2,), (h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_rates_of_six_wheels_block, 6, (0, 1, 2,), (h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z,), out)


def _rates_of_six_wheels(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z):
    t1 = h_2 + h_5
    t2 = (1.0 / 2.0) * math.sin(a)
    t3 = -h_6
    return -(((t1 + (h_3 + h_6)) * (math.sqrt(3.0) * t2)) / J_x), -((((((h_3 - (2.0 * h_1)) - (2.0 * h_4)) - t1) - t3) * t2) / J_y), -((math.cos(a) * ((((h_3 + (h_1 + h_2)) + t3) - h_4) - h_5)) / J_z)


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


def _rates_of_six_wheels_block(h_1, h_2, h_3, h_4, h_5, h_6, a, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, n1=array(1.0), n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n2=array(2.0)):
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

    Rests on ignatov2005:3.2.1 (sha256 d524ffea3256), ignatov2005:2.3 (sha256 57003d67dcfa).
    """
    if out is None:
        try:
            if float is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(a) is type(J_x) is type(J_y) is type(J_z):
                return _rates_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z)
            if ndarray is type(h_1) is type(h_2) is type(h_3) is type(h_4) is type(h_5) is type(a) is type(J_x) is type(J_y) is type(J_z) and DOUBLE is h_1.dtype is h_2.dtype is h_3.dtype is h_4.dtype is h_5.dtype is a.dtype is J_x.dtype is J_y.dtype is J_z.dtype and () != h_1.shape == h_2.shape == h_3.shape == h_4.shape == h_5.shape == a.shape == J_x.shape == J_y.shape == J_z.shape:
                size = h_1.size
                if 0 < size <= 6:
                    return evaluate_handful(_rates_of_five_wheels, (h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z,))
                if size <= FEW:
                    return _rates_of_five_wheels_few(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z)
                if size <= SMALL:
                    return _rates_of_five_wheels_block(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z)
                return evaluate_alike(_rates_of_five_wheels_block, 5, (0, 1, 2,), (h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_rates_of_five_wheels_block, 5, (0, 1, 2,), (h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z,), out)


def _rates_of_five_wheels(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z):
    t1 = h_2 + h_5
    t2 = (1.0 / 2.0) * math.sin(a)
    return -(((h_3 + t1) * (math.sqrt(3.0) * t2)) / J_x), -(((((h_3 - (2.0 * h_1)) - (2.0 * h_4)) - t1) * t2) / J_y), -((math.cos(a) * (((h_3 + (h_1 + h_2)) - h_4) - h_5)) / J_z)


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


def _rates_of_five_wheels_block(h_1, h_2, h_3, h_4, h_5, a, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0), n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n2=array(2.0)):
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

    Rests on ignatov2005:2.1V.1a (sha256 e5b9794d6eff), ignatov2005:2.1V.2a (sha256 a0f1e3a325ab),
    ignatov2005:2.1V.3a (sha256 f8ec71b5b1e5), ignatov2005:2.1V.4a (sha256 772691a3262a), ignatov2005:2.1V.5a
    (sha256 5e218eab1ed2), ignatov2005:2.1V.6a (sha256 e3990d37b113), ignatov2005:2.1V.7a (sha256 6699fc74aac7).
    """
    if out is None:
        try:
            if float is type(a) is type(b):
                return _vertices_of_four_wheels(a, b)
            if ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                size = a.size
                if 0 < size <= 1:
                    return evaluate_handful(_vertices_of_four_wheels, (a, b,), (0, 1, 2, 3, 1, 4, 3, 1, 2, 5, 1, 4, 5, 6, 7,))
                if size <= FEW:
                    return _vertices_of_four_wheels_few(a, b)
                if size <= SMALL:
                    return _vertices_of_four_wheels_block(a, b)
                return evaluate_alike(_vertices_of_four_wheels_block, 5, (0, 1, 2, 3, 1, 4, 3, 1, 2, 5, 1, 4, 5, 6, 7,), (a, b,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_vertices_of_four_wheels_block, 5, (0, 1, 2, 3, 1, 4, 3, 1, 2, 5, 1, 4, 5, 6, 7,), (a, b,), out)


def _vertices_of_four_wheels(a, b):
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


def _vertices_of_four_wheels_block(a, b, out_V_1x=None, out_V_2x=None, out_V_2y=None, out_V_2z=None, out_V_3y=None, out_V_4z=None, out_V_6y=None, out_V_7z=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0), n2=array(2.0), n4=array(4.0)):
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

    Rests on ignatov2005:2.2V.1a (sha256 2454d33ff5bf), ignatov2005:2.2V.2a (sha256 b7890bffda83),
    ignatov2005:2.2V.3a (sha256 45c0821bb0e1), ignatov2005:2.2V.4a (sha256 39b18cc074ae).
    """
    if out is None:
        try:
            if float is type(a) is type(b):
                return _vertices_of_three_wheels(a, b)
            if ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                size = a.size
                if size <= FEW:
                    return _vertices_of_three_wheels_few(a, b)
                if size <= SMALL:
                    return _vertices_of_three_wheels_block(a, b)
                return evaluate_alike(_vertices_of_three_wheels_block, 5, (0, 1, 2, 3, 4, 5, 3, 6, 5, 3, 4, 7,), (a, b,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_vertices_of_three_wheels_block, 5, (0, 1, 2, 3, 4, 5, 3, 6, 5, 3, 4, 7,), (a, b,), out)


def _vertices_of_three_wheels(a, b):
    sin_a = math.sin(a)
    t1 = sin_a * math.sin(b)
    t2 = math.cos(b) * sin_a
    cos_a = math.cos(a)
    return 3.0 * t1, -t2, -cos_a, t1, t2, cos_a, t1, -(3.0 * t2), cos_a, t1, t2, -(3.0 * cos_a)


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


def _vertices_of_three_wheels_block(a, b, out_V_1x=None, out_V_1y=None, out_V_1z=None, out_V_2x=None, out_V_2y=None, out_V_2z=None, out_V_3y=None, out_V_4z=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0), n3=array(3.0)):
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

    Rests on ignatov2005:3.1V.1a (sha256 b51a3fcf346f), ignatov2005:3.1V.2a (sha256 b0c634dcdde9),
    ignatov2005:3.1V.3a (sha256 7bb0b8f23c7a), ignatov2005:3.1V.4a (sha256 eee98e1b565b), ignatov2005:3.1V.5a
    (sha256 f08e36effac0), ignatov2005:3.1V.6a (sha256 5bef380883e6), ignatov2005:3.1V.7a (sha256 1e8ce505359f),
    ignatov2005:3.1V.8a (sha256 cbda7b1ae859), ignatov2005:3.1V.9a (sha256 17e1fe062dac), ignatov2005:3.1V.10a
    (sha256 0248272de7aa), ignatov2005:3.1V.11a (sha256 dc8419622b85), ignatov2005:3.1V.12a (sha256 064a71a8217e),
    ignatov2005:3.1V.13a (sha256 5afc508aa051), ignatov2005:3.1V.14a (sha256 aad84d3eca9d), ignatov2005:3.1V.15a
    (sha256 ccddd845f704), ignatov2005:3.1V.16a (sha256 1e908cfed76a).
    """
    if out is None:
        try:
            if float is type(a):
                return _vertices_of_six_wheels(a)
            if ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                size = a.size
                if size <= FEW:
                    return _vertices_of_six_wheels_few(a)
                if size <= SMALL:
                    return _vertices_of_six_wheels_block(a)
                return evaluate_alike(_vertices_of_six_wheels_block, 3, (0, 1, 2, 3, 4, 2, 3, 5, 2, 6, 2, 7, 5, 2, 7, 4, 2, 7, 8, 9, 3, 8, 9, 10, 9, 3, 11, 9, 7, 11, 9, 12, 9, 12, 1, 13, 10, 1,), (a,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_vertices_of_six_wheels_block, 3, (0, 1, 2, 3, 4, 2, 3, 5, 2, 6, 2, 7, 5, 2, 7, 4, 2, 7, 8, 9, 3, 8, 9, 10, 9, 3, 11, 9, 7, 11, 9, 12, 9, 12, 1, 13, 10, 1,), (a,), out)


def _vertices_of_six_wheels(a):
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


def _vertices_of_six_wheels_block(a, out_V_1z=None, out_V_2y=None, out_V_2z=None, out_V_3x=None, out_V_3y=None, out_V_4y=None, out_V_5y=None, out_V_6x=None, out_V_8y=None, out_V_8z=None, out_V_10x=None, out_V_11y=None, out_V_13x=None, out_V_15y=None, r0=None, r1=None, r2=None, n1=array(1.0), n2=array(2.0), n4=array(4.0), sqrt_3=array(math.sqrt(3.0)), n3=array(3.0), n6=array(6.0)):
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

    Rests on ignatov2005:3.2V.1a (sha256 12fa1ab02a5f), ignatov2005:3.2V.2a (sha256 d8e0ae63d033),
    ignatov2005:3.2V.3a (sha256 be4a9049023c), ignatov2005:3.2V.4a (sha256 8e45bf74b10b), ignatov2005:3.2V.5a
    (sha256 ceb89ee8941d), ignatov2005:3.2V.6a (sha256 8c38650a0830), ignatov2005:3.2V.7a (sha256 c2dfe2bca48d),
    ignatov2005:3.2V.8a (sha256 cf0c32575974), ignatov2005:3.2V.9a (sha256 f8aed7e8d192), ignatov2005:3.2V.10a
    (sha256 3c61def8ef19), ignatov2005:3.2V.11a (sha256 a185009784ec).
    """
    if out is None:
        try:
            if float is type(a):
                return _vertices_of_five_wheels(a)
            if ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                size = a.size
                if size <= FEW:
                    return _vertices_of_five_wheels_few(a)
                if size <= SMALL:
                    return _vertices_of_five_wheels_block(a)
                return evaluate_alike(_vertices_of_five_wheels_block, 3, (0, 1, 2, 0, 3, 4, 5, 6, 4, 5, 7, 4, 0, 8, 4, 9, 7, 4, 9, 6, 10, 5, 11, 10, 12, 1, 10, 5, 13, 10, 9, 13, 10,), (a,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_vertices_of_five_wheels_block, 3, (0, 1, 2, 0, 3, 4, 5, 6, 4, 5, 7, 4, 0, 8, 4, 9, 7, 4, 9, 6, 10, 5, 11, 10, 12, 1, 10, 5, 13, 10, 9, 13, 10,), (a,), out)


def _vertices_of_five_wheels(a):
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


def _vertices_of_five_wheels_block(a, out_V_1x=None, out_V_1y=None, out_V_1z=None, out_V_2y=None, out_V_2z=None, out_V_3x=None, out_V_3y=None, out_V_4y=None, out_V_5y=None, out_V_6x=None, out_V_7z=None, out_V_8y=None, out_V_9x=None, out_V_10y=None, r0=None, r1=None, r2=None, n1=array(1.0), n1_2=array(1.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n5_2=array(5.0 / 2.0), n3=array(3.0), n3_2=array(3.0 / 2.0), n5=array(5.0), n7_2=array(7.0 / 2.0)):
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

    Rests on ignatov2005:2.1.28 (sha256 0e3240f25813), ignatov2005:2.1.29 (sha256 b8a120513c5b),
    ignatov2005:2.1.30 (sha256 321b732aa3c2).
    """
    if out is None:
        try:
            if float is type(a) is type(b):
                return _vertex_distances_of_four_wheels(a, b)
            if ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                size = a.size
                if 0 < size <= 1:
                    return evaluate_handful(_vertex_distances_of_four_wheels, (a, b,))
                if size <= FEW:
                    return _vertex_distances_of_four_wheels_few(a, b)
                if size <= SMALL:
                    return _vertex_distances_of_four_wheels_block(a, b)
                return evaluate_alike(_vertex_distances_of_four_wheels_block, 4, (0, 1, 2,), (a, b,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_vertex_distances_of_four_wheels_block, 4, (0, 1, 2,), (a, b,), out)


def _vertex_distances_of_four_wheels(a, b):
    t1 = 4.0 * math.sin(a)
    return math.sin(b) * t1, math.cos(b) * t1, 4.0 * math.cos(a)


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


def _vertex_distances_of_four_wheels_block(a, b, out_d_1=None, out_d_2=None, out_d_3=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0), n4=array(4.0)):
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

    Rests on ignatov2005:2.2.18 (sha256 4d77f76651c9), ignatov2005:2.2.19 (sha256 ae7a0b96326a),
    ignatov2005:2.2.20 (sha256 47427cf2a5e7). The forms computed are proved equal to those shown (sha256
    e8f94252f227).
    """
    if out is None:
        try:
            if float is type(a) is type(b):
                return _vertex_distances_of_three_wheels(a, b)
            if ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                size = a.size
                if 0 < size <= 4:
                    return evaluate_handful(_vertex_distances_of_three_wheels, (a, b,))
                if size <= SMALL:
                    return _vertex_distances_of_three_wheels_block(a, b)
                return evaluate_alike(_vertex_distances_of_three_wheels_block, 4, (0, 1, 2,), (a, b,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_vertex_distances_of_three_wheels_block, 4, (0, 1, 2,), (a, b,), out)


def _vertex_distances_of_three_wheels(a, b):
    tan_b = math.tan(b)
    tan_b_squared = tan_b * tan_b
    tan_a = math.tan(a)
    tan_a_squared = tan_a * tan_a
    t2 = 8.0 / (1.0 + tan_a_squared)
    t5 = (t2 * tan_a_squared) / (1.0 + tan_b_squared)
    return math.sqrt(1.0 + (t5 * tan_b_squared)), math.sqrt(1.0 + t5), math.sqrt(1.0 + t2)


def _vertex_distances_of_three_wheels_block(a, b, out_d_1=None, out_d_2=None, out_d_3=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0), n8=array(8.0)):
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

    Rests on ignatov2005:3.1.28 (sha256 e71ba0437140), ignatov2005:3.1.29 (sha256 4ac033d3c789),
    ignatov2005:3.1.30 (sha256 fe3592006e51), ignatov2005:3.1.31 (sha256 7c03028b454b). The forms computed are
    proved equal to those shown (sha256 28df6e492d9b).
    """
    if out is None:
        try:
            if float is type(a):
                return _vertex_distances_of_six_wheels(a)
            if ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                size = a.size
                if 0 < size <= 3:
                    return evaluate_handful(_vertex_distances_of_six_wheels, (a,))
                if size <= FEW:
                    return _vertex_distances_of_six_wheels_few(a)
                if size <= SMALL:
                    return _vertex_distances_of_six_wheels_block(a)
                return evaluate_alike(_vertex_distances_of_six_wheels_block, 4, (0, 1, 2, 3,), (a,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_vertex_distances_of_six_wheels_block, 4, (0, 1, 2, 3,), (a,), out)


def _vertex_distances_of_six_wheels(a):
    tan_a = math.tan(a)
    tan_a_squared = tan_a * tan_a
    t2 = 1.0 / (1.0 + tan_a_squared)
    return 6.0 * math.cos(a), 4.0 * math.sin(a), 2.0 * math.sqrt(1.0 + (3.0 * t2)), 2.0 * math.sqrt(1.0 + (2.0 * (t2 * tan_a_squared)))


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


def _vertex_distances_of_six_wheels_block(a, out_d_1=None, out_d_2=None, out_d_3=None, out_d_4=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0), n6=array(6.0), n4=array(4.0), n3=array(3.0), n2=array(2.0)):
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

    Rests on ignatov2005:T10.1 (sha256 f45e8ab16ef4), ignatov2005:T10.2 (sha256 9e4d6842df20), ignatov2005:T10.3
    (sha256 2e5029d9e5c6), ignatov2005:T10.4 (sha256 f206aa25b0fb), ignatov2005:T10.5 (sha256 f27ebbf77876),
    ignatov2005:T10.6 (sha256 34d539ede60a), ignatov2005:T10.7 (sha256 e6db3e604cb0). The forms computed are
    proved equal to those shown (sha256 7c6a4367933f).
    """
    if out is None:
        try:
            if float is type(a):
                return _vertex_distances_of_five_wheels(a)
            if ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                size = a.size
                if 0 < size <= 4:
                    return evaluate_handful(_vertex_distances_of_five_wheels, (a,))
                if size <= SMALL:
                    return _vertex_distances_of_five_wheels_block(a)
                return evaluate_alike(_vertex_distances_of_five_wheels_block, 5, (0, 1, 2, 3, 4, 5, 6,), (a,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_vertex_distances_of_five_wheels_block, 5, (0, 1, 2, 3, 4, 5, 6,), (a,), out)


def _vertex_distances_of_five_wheels(a):
    tan_a = math.tan(a)
    tan_a_squared = tan_a * tan_a
    t2 = 1.0 / (1.0 + tan_a_squared)
    t3 = 6.0 * t2
    t4 = 8.0 * t2
    return math.sqrt(1.0 + (24.0 * t2)), math.sqrt(7.0 + (2.0 * t2)), math.sqrt(3.0 + t3), math.sqrt(1.0 + t4), math.sqrt(1.0 + (t4 * tan_a_squared)), math.sqrt(1.0 + (12.0 * (t2 * tan_a_squared))), math.sqrt(1.0 + (t3 * tan_a_squared))


def _vertex_distances_of_five_wheels_block(a, out_d_1=None, out_d_2=None, out_d_3=None, out_d_4=None, out_d_5=None, out_d_6=None, out_d_7=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0), n6=array(6.0), n8=array(8.0), n24=array(24.0), n2=array(2.0), n7=array(7.0), n3=array(3.0), n12=array(12.0)):
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

    Rests on ignatov2005:T3.1 (sha256 8efdfa34b18c), ignatov2005:T3.2 (sha256 d75a5ee5e821), ignatov2005:T3.3
    (sha256 c07cc09dd077). The forms computed are proved equal to those shown (sha256 c0e08f011f03).
    """
    if out is None:
        try:
            if float is type(a) is type(b):
                return _face_distances_of_four_wheels(a, b)
            if ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                size = a.size
                if 0 < size <= 9:
                    return evaluate_handful(_face_distances_of_four_wheels, (a, b,))
                if size <= SMALL:
                    return _face_distances_of_four_wheels_block(a, b)
                return evaluate_alike(_face_distances_of_four_wheels_block, 8, (0, 1, 2,), (a, b,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_face_distances_of_four_wheels_block, 8, (0, 1, 2,), (a, b,), out)


def _face_distances_of_four_wheels(a, b):
    tan_a = math.tan(a)
    tan_a_squared = tan_a * tan_a
    tan_b = math.tan(b)
    tan_b_squared = tan_b * tan_b
    t1 = 1.0 + tan_b_squared
    t2 = 4.0 * tan_a
    t3 = t2 * tan_b
    t4 = t1 * t1
    t11 = math.sqrt(t1 + ((1.0 + ((tan_a_squared * tan_b_squared) + (2.0 * tan_b_squared))) * tan_a_squared))
    return t3 / t11, t2 / math.sqrt(t1 + ((2.0 + (tan_a_squared + tan_b_squared)) * tan_a_squared)), t3 / math.sqrt((t4 * tan_a_squared) + t4)


def _face_distances_of_four_wheels_block(a, b, out_r_1=None, out_r_2=None, out_r_3=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, n1=array(1.0), n4=array(4.0), n2=array(2.0)):
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

    Rests on ignatov2005:T5.1 (sha256 3ea4d48a967e). The forms computed are proved equal to those shown (sha256
    d8ee80165a63).
    """
    if out is None:
        try:
            if float is type(a) is type(b):
                return _face_distances_of_three_wheels(a, b)
            if ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                size = a.size
                if 0 < size <= 9:
                    return evaluate_handful(_face_distances_of_three_wheels, (a, b,))
                if size <= SMALL:
                    return _face_distances_of_three_wheels_block(a, b)
                return evaluate_alike(_face_distances_of_three_wheels_block, 8, (0, 1, 2,), (a, b,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_face_distances_of_three_wheels_block, 8, (0, 1, 2,), (a, b,), out)


def _face_distances_of_three_wheels(a, b):
    tan_a = math.tan(a)
    tan_a_squared = tan_a * tan_a
    tan_b = math.tan(b)
    tan_b_squared = tan_b * tan_b
    t1 = 1.0 + tan_b_squared
    t2 = 2.0 * tan_a
    t3 = t2 * tan_b
    t4 = t1 * t1
    t11 = math.sqrt(t1 + ((1.0 + ((tan_a_squared * tan_b_squared) + (2.0 * tan_b_squared))) * tan_a_squared))
    return t3 / t11, t2 / math.sqrt(t1 + ((2.0 + (tan_a_squared + tan_b_squared)) * tan_a_squared)), t3 / math.sqrt((t4 * tan_a_squared) + t4)


def _face_distances_of_three_wheels_block(a, b, out_r_1=None, out_r_2=None, out_r_3=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, n1=array(1.0), n2=array(2.0)):
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

    Rests on ignatov2005:T8.1 (sha256 b14e385314d0), ignatov2005:T8.3 (sha256 4228125f38ea), ignatov2005:B.28
    (sha256 472d640787be). The forms computed are proved equal to those shown (sha256 686717258b03).
    """
    if out is None:
        try:
            if float is type(a):
                return _face_distances_of_six_wheels(a)
            if ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                size = a.size
                if 0 < size <= 6:
                    return evaluate_handful(_face_distances_of_six_wheels, (a,))
                if size <= SMALL:
                    return _face_distances_of_six_wheels_block(a)
                return evaluate_alike(_face_distances_of_six_wheels_block, 4, (0, 1, 2,), (a,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_face_distances_of_six_wheels_block, 4, (0, 1, 2,), (a,), out)


def _face_distances_of_six_wheels(a):
    tan_a = math.tan(a)
    tan_a_squared = tan_a * tan_a
    return (6.0 * tan_a) / math.sqrt((4.0 / 3.0) + (((7.0 / 3.0) + tan_a_squared) * tan_a_squared)), (8.0 * tan_a) / math.sqrt(4.0 + ((5.0 + tan_a_squared) * tan_a_squared)), (4.0 * tan_a) / math.sqrt((4.0 / 3.0) + ((4.0 / 3.0) * tan_a_squared))


def _face_distances_of_six_wheels_block(a, out_r_1=None, out_r_2=None, out_r_3=None, r0=None, r1=None, r2=None, r3=None, n7_3=array(7.0 / 3.0), n4_3=array(4.0 / 3.0), n6=array(6.0), n5=array(5.0), n4=array(4.0), n8=array(8.0)):
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

    Rests on ignatov2005:T11.1 (sha256 4304d5fe37f8), ignatov2005:T11.2 (sha256 158e62cdf51f), ignatov2005:T11.3
    (sha256 ede2be42c5ac), ignatov2005:T11.4 (sha256 1518d3d3abcf), ignatov2005:T11.5 (sha256 01ed74be6d3d),
    ignatov2005:T11.6 (sha256 1c799063763f). The forms computed are proved equal to those shown (sha256
    dfc56dd0e0d8).
    """
    if out is None:
        try:
            if float is type(a):
                return _face_distances_of_five_wheels(a)
            if ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                size = a.size
                if 0 < size <= 3:
                    return evaluate_handful(_face_distances_of_five_wheels, (a,))
                if size <= SMALL:
                    return _face_distances_of_five_wheels_block(a)
                return evaluate_alike(_face_distances_of_five_wheels_block, 4, (0, 1, 2, 3, 4, 5,), (a,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_face_distances_of_five_wheels_block, 4, (0, 1, 2, 3, 4, 5,), (a,), out)


def _face_distances_of_five_wheels(a):
    tan_a = math.tan(a)
    tan_a_squared = tan_a * tan_a
    t5 = tan_a / math.sqrt(4.0 + ((5.0 + tan_a_squared) * tan_a_squared))
    t10 = tan_a / math.sqrt((4.0 / 3.0) + (((7.0 / 3.0) + tan_a_squared) * tan_a_squared))
    return 7.0 * t5, 5.0 * t10, 4.0 * t10, 6.0 * t5, 5.0 * t5, (3.0 * tan_a) / math.sqrt((4.0 / 3.0) + ((4.0 / 3.0) * tan_a_squared))


def _face_distances_of_five_wheels_block(a, out_r_1=None, out_r_2=None, out_r_3=None, out_r_4=None, out_r_5=None, out_r_6=None, r0=None, r1=None, r2=None, r3=None, n5=array(5.0), n4=array(4.0), n7_3=array(7.0 / 3.0), n4_3=array(4.0 / 3.0), n7=array(7.0), n6=array(6.0), n3=array(3.0)):
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

    Rests on ignatov2005:B.3 (sha256 54617108b327). The forms computed are proved equal to those shown (sha256
    36bc28a1963b).
    """
    if out is None:
        try:
            if float is type(a) is type(b):
                return _volume_of_four_wheels(a, b)
            if ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                size = a.size
                if 0 < size <= 6:
                    return evaluate_handful(_volume_of_four_wheels, (a, b,))
                if size <= SMALL:
                    return _volume_of_four_wheels_block(a, b)
                return evaluate_alike(_volume_of_four_wheels_block, 5, (0,), (a, b,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_volume_of_four_wheels_block, 5, (0,), (a, b,), out)


def _volume_of_four_wheels(a, b):
    tan_a = math.tan(a)
    tan_b = math.tan(b)
    t10 = (128.0 * (tan_a * tan_b)) / (((1.0 / tan_a) + tan_a) * (math.sqrt(1.0 + (tan_a * tan_a)) * (1.0 + (tan_b * tan_b))))
    return t10


def _volume_of_four_wheels_block(a, b, out_volume=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0), n128=array(128.0)):
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

    Rests on ignatov2005:B.13 (sha256 aedd01b78464). The forms computed are proved equal to those shown (sha256
    a7b89f376227).
    """
    if out is None:
        try:
            if float is type(a) is type(b):
                return _volume_of_three_wheels(a, b)
            if ndarray is type(a) is type(b) and DOUBLE is a.dtype is b.dtype and () != a.shape == b.shape:
                size = a.size
                if 0 < size <= 6:
                    return evaluate_handful(_volume_of_three_wheels, (a, b,))
                if size <= SMALL:
                    return _volume_of_three_wheels_block(a, b)
                return evaluate_alike(_volume_of_three_wheels_block, 5, (0,), (a, b,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_volume_of_three_wheels_block, 5, (0,), (a, b,), out)


def _volume_of_three_wheels(a, b):
    tan_a = math.tan(a)
    tan_b = math.tan(b)
    t10 = (32.0 * (tan_a * tan_b)) / (((1.0 / tan_a) + tan_a) * (math.sqrt(1.0 + (tan_a * tan_a)) * (1.0 + (tan_b * tan_b))))
    return t10


def _volume_of_three_wheels_block(a, b, out_volume=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0), n32=array(32.0)):
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

    Rests on ignatov2005:B.25 (sha256 afc28669e24e). The forms computed are proved equal to those shown (sha256
    17e4cf272330).
    """
    if out is None:
        try:
            if float is type(a):
                return _volume_of_six_wheels(a)
            if ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                size = a.size
                if 0 < size <= 4:
                    return evaluate_handful(_volume_of_six_wheels, (a,))
                if size <= SMALL:
                    return _volume_of_six_wheels_block(a)
                return evaluate_alike(_volume_of_six_wheels_block, 3, (0,), (a,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_volume_of_six_wheels_block, 3, (0,), (a,), out)


def _volume_of_six_wheels(a):
    tan_a = math.tan(a)
    t8 = (144.0 * tan_a) / (math.sqrt((1.0 / 3.0) + ((1.0 / 3.0) * (tan_a * tan_a))) * ((1.0 / tan_a) + tan_a))
    return t8


def _volume_of_six_wheels_block(a, out_volume=None, r0=None, r1=None, r2=None, n1_3=array(1.0 / 3.0), n1=array(1.0), n144=array(144.0)):
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

    Rests on ignatov2005:B.35 (sha256 87fe4711f136). The forms computed are proved equal to those shown (sha256
    41c1d7de6bff).
    """
    if out is None:
        try:
            if float is type(a):
                return _volume_of_five_wheels(a)
            if ndarray is type(a) and DOUBLE is a.dtype and () != a.shape:
                size = a.size
                if 0 < size <= 4:
                    return evaluate_handful(_volume_of_five_wheels, (a,))
                if size <= SMALL:
                    return _volume_of_five_wheels_block(a)
                return evaluate_alike(_volume_of_five_wheels_block, 3, (0,), (a,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_volume_of_five_wheels_block, 3, (0,), (a,), out)


def _volume_of_five_wheels(a):
    tan_a = math.tan(a)
    t8 = (72.0 * tan_a) / (math.sqrt((1.0 / 3.0) + ((1.0 / 3.0) * (tan_a * tan_a))) * ((1.0 / tan_a) + tan_a))
    return t8


def _volume_of_five_wheels_block(a, out_volume=None, r0=None, r1=None, r2=None, n1_3=array(1.0 / 3.0), n1=array(1.0), n72=array(72.0)):
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

    Rests on ignatov2005:2.3.2 (sha256 5e8b7ff65c34), ignatov2005:2.3.3 (sha256 fbeef966f1d7), ignatov2005:2.3.4
    (sha256 1914201561bb), ignatov2005:2.3 (sha256 57003d67dcfa).
    """
    if out is None:
        try:
            if float is type(a) is type(b) is type(J_x) is type(J_y) is type(J_z):
                return _largest_rates_of_four_wheels(a, b, J_x, J_y, J_z)
            if ndarray is type(a) is type(b) is type(J_x) is type(J_y) is type(J_z) and DOUBLE is a.dtype is b.dtype is J_x.dtype is J_y.dtype is J_z.dtype and () != a.shape == b.shape == J_x.shape == J_y.shape == J_z.shape:
                size = a.size
                if 0 < size <= 1:
                    return evaluate_handful(_largest_rates_of_four_wheels, (a, b, J_x, J_y, J_z,))
                if size <= FEW:
                    return _largest_rates_of_four_wheels_few(a, b, J_x, J_y, J_z)
                if size <= SMALL:
                    return _largest_rates_of_four_wheels_block(a, b, J_x, J_y, J_z)
                return evaluate_alike(_largest_rates_of_four_wheels_block, 5, (0, 1, 2,), (a, b, J_x, J_y, J_z,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_largest_rates_of_four_wheels_block, 5, (0, 1, 2,), (a, b, J_x, J_y, J_z,), out)


def _largest_rates_of_four_wheels(a, b, J_x, J_y, J_z):
    t1 = 4.0 * math.sin(a)
    return (math.sin(b) * t1) / J_x, (math.cos(b) * t1) / J_y, (4.0 * math.cos(a)) / J_z


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


def _largest_rates_of_four_wheels_block(a, b, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1=array(1.0), n4=array(4.0)):
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

    Rests on ignatov2005:3.2.26 (sha256 32f7d6819c02), ignatov2005:3.2.27 (sha256 2037c978fcea),
    ignatov2005:3.2.28 (sha256 910d9ae68049), ignatov2005:2.3 (sha256 57003d67dcfa).
    """
    if out is None:
        try:
            if float is type(a) is type(J_x) is type(J_y) is type(J_z):
                return _largest_rates_of_six_wheels(a, J_x, J_y, J_z)
            if ndarray is type(a) is type(J_x) is type(J_y) is type(J_z) and DOUBLE is a.dtype is J_x.dtype is J_y.dtype is J_z.dtype and () != a.shape == J_x.shape == J_y.shape == J_z.shape:
                size = a.size
                if 0 < size <= 1:
                    return evaluate_handful(_largest_rates_of_six_wheels, (a, J_x, J_y, J_z,))
                if size <= FEW:
                    return _largest_rates_of_six_wheels_few(a, J_x, J_y, J_z)
                if size <= SMALL:
                    return _largest_rates_of_six_wheels_block(a, J_x, J_y, J_z)
                return evaluate_alike(_largest_rates_of_six_wheels_block, 4, (0, 1, 2,), (a, J_x, J_y, J_z,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_largest_rates_of_six_wheels_block, 4, (0, 1, 2,), (a, J_x, J_y, J_z,), out)


def _largest_rates_of_six_wheels(a, J_x, J_y, J_z):
    sin_a = math.sin(a)
    return (2.0 * (sin_a * math.sqrt(3.0))) / J_x, (4.0 * sin_a) / J_y, (6.0 * math.cos(a)) / J_z


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


def _largest_rates_of_six_wheels_block(a, J_x, J_y, J_z, out_w_x=None, out_w_y=None, out_w_z=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0), sqrt_3=array(math.sqrt(3.0)), n2=array(2.0), n4=array(4.0), n6=array(6.0)):
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

    Rests on ignatov2005:B.16 (sha256 d7a5333dadbc), ignatov2005:B.17 (sha256 0705625cabf5), ignatov2005:B.18
    (sha256 69a8052e39dc), ignatov2005:B.19 (sha256 b13534e6844f).
    """
    if out is None:
        try:
            if float is type(J_x) is type(J_y) is type(J_z):
                return _equal_rates_of_four_wheels(J_x, J_y, J_z)
            if ndarray is type(J_x) is type(J_y) is type(J_z) and DOUBLE is J_x.dtype is J_y.dtype is J_z.dtype and () != J_x.shape == J_y.shape == J_z.shape:
                size = J_x.size
                if 0 < size <= 2:
                    return evaluate_handful(_equal_rates_of_four_wheels, (J_x, J_y, J_z,))
                if size <= SMALL:
                    return _equal_rates_of_four_wheels_block(J_x, J_y, J_z)
                return evaluate_alike(_equal_rates_of_four_wheels_block, 2, (0, 1, 2, 3,), (J_x, J_y, J_z,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_equal_rates_of_four_wheels_block, 2, (0, 1, 2, 3,), (J_x, J_y, J_z,), out)


def _equal_rates_of_four_wheels(J_x, J_y, J_z):
    t1 = (J_x * J_x) + (J_y * J_y)
    t4 = 1.0 / math.sqrt((J_z * J_z) + t1)
    return math.atan(math.sqrt(t1) / J_z), math.atan(J_x / J_y), 4.0 * t4, 2.0 * (math.sqrt(2.0) * t4)


def _equal_rates_of_four_wheels_block(J_x, J_y, J_z, out_a=None, out_b=None, out_w=None, out_w_any=None, r0=None, r1=None, n1=array(1.0), n4=array(4.0), sqrt_2=array(math.sqrt(2.0)), n2=array(2.0)):
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

    Rests on ignatov2005:3.2.26 (sha256 32f7d6819c02), ignatov2005:3.2.27 (sha256 2037c978fcea),
    ignatov2005:3.2.28 (sha256 910d9ae68049), ignatov2005:3.2.30 (sha256 70178405b3c5).
    """
    if out is None:
        try:
            if float is type(J_x) is type(J_y) is type(J_z):
                return _equal_rates_of_six_wheels(J_x, J_y, J_z)
            if ndarray is type(J_x) is type(J_y) is type(J_z) and DOUBLE is J_x.dtype is J_y.dtype is J_z.dtype and () != J_x.shape == J_y.shape == J_z.shape:
                size = J_x.size
                if 0 < size <= 3:
                    return evaluate_handful(_equal_rates_of_six_wheels, (J_x, J_y, J_z,))
                if size <= SMALL:
                    return _equal_rates_of_six_wheels_block(J_x, J_y, J_z)
                return evaluate_alike(_equal_rates_of_six_wheels_block, 2, (0, 1, 2,), (J_x, J_y, J_z,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_equal_rates_of_six_wheels_block, 2, (0, 1, 2,), (J_x, J_y, J_z,), out)


def _equal_rates_of_six_wheels(J_x, J_y, J_z):
    t5 = 1.0 / math.sqrt((9.0 * (J_y * J_y)) + (4.0 * (J_z * J_z)))
    return math.atan(((3.0 / 2.0) * J_y) / J_z), (6.0 * (math.sqrt(3.0) * (J_y * t5))) / J_x, 12.0 * t5


def _equal_rates_of_six_wheels_block(J_x, J_y, J_z, out_a=None, out_w_x=None, out_w_y=None, r0=None, r1=None, n9=array(9.0), n4=array(4.0), n1=array(1.0), n3_2=array(3.0 / 2.0), sqrt_3=array(math.sqrt(3.0)), n6=array(6.0), n12=array(12.0)):
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

    Rests on ignatov2005:B.20 (sha256 b8bd7747ff31), ignatov2005:B.21 (sha256 4c0bc2be9001).
    """
    if out is None:
        try:
            if float is type(J_x) is type(J_y) is type(J_z):
                return _best_angles_of_four_wheels(J_x, J_y, J_z)
            if ndarray is type(J_x) is type(J_y) is type(J_z) and DOUBLE is J_x.dtype is J_y.dtype is J_z.dtype and () != J_x.shape == J_y.shape == J_z.shape:
                size = J_x.size
                if 0 < size <= 4:
                    return evaluate_handful(_best_angles_of_four_wheels, (J_x, J_y, J_z,))
                if size <= SMALL:
                    return _best_angles_of_four_wheels_block(J_x, J_y, J_z)
                return evaluate_alike(_best_angles_of_four_wheels_block, 4, (0, 1, 2,), (J_x, J_y, J_z,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_best_angles_of_four_wheels_block, 4, (0, 1, 2,), (J_x, J_y, J_z,), out)


def _best_angles_of_four_wheels(J_x, J_y, J_z):
    J_x_squared = J_x * J_x
    t1 = J_x_squared + (J_z * J_z)
    t2 = math.sqrt(t1)
    return math.atan(math.sqrt(J_x_squared + (J_y * t2)) / J_z), math.atan(J_x / (math.sqrt(J_y) * math.pow(t1, 1.0 / 4.0))), 4.0 / (J_y + t2)


def _best_angles_of_four_wheels_block(J_x, J_y, J_z, out_a=None, out_b=None, out_w=None, r0=None, r1=None, r2=None, r3=None, n1_4=array(1.0 / 4.0), n4=array(4.0)):
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

    Rests on ignatov2005:B.38 (sha256 a94786f889f4), ignatov2005:B.39 (sha256 7f57aa82a899), ignatov2005:B.40
    (sha256 f4e5814fc21d).
    """
    if out is None:
        try:
            if float is type(J_y) is type(J_z):
                return _best_angle_of_six_wheels(J_y, J_z)
            if ndarray is type(J_y) is type(J_z) and DOUBLE is J_y.dtype is J_z.dtype and () != J_y.shape == J_z.shape:
                size = J_y.size
                if 0 < size <= 1:
                    return evaluate_handful(_best_angle_of_six_wheels, (J_y, J_z,))
                if size <= SMALL:
                    return _best_angle_of_six_wheels_block(J_y, J_z)
                return evaluate_alike(_best_angle_of_six_wheels_block, 1, (0, 1,), (J_y, J_z,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_best_angle_of_six_wheels_block, 1, (0, 1,), (J_y, J_z,), out)


def _best_angle_of_six_wheels(J_y, J_z):
    return math.atan(math.sqrt(2.0) * math.sqrt(J_y / J_z)), 8.0 / (J_z + (2.0 * J_y))


def _best_angle_of_six_wheels_block(J_y, J_z, out_a=None, out_w=None, r0=None, sqrt_2=array(math.sqrt(2.0)), n2=array(2.0), n8=array(8.0)):
    r0 = divide(J_y, J_z, r0)  # t1
    r0 = sqrt(r0, r0)  # t2
    r0 = multiply(sqrt_2, r0, r0)  # t3
    out_a = arctan(r0, out_a)  # t4
    r0 = multiply(n2, J_y, r0)  # t5
    r0 = add(J_z, r0, r0)  # t6
    out_w = divide(n8, r0, out_w)  # t7
    return out_a, out_w
