"""Orientations: the attitude angles of Mirer's figure 1, and all axes about which the moments of inertia are equal."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from symcheck.generated import mirer2009
from symcheck.numeric.arrays import letters, results, stacked
from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import Array, Orientation, orthonormal_axes, principal_moments, real, require

TINY = 1e-100  # near an axis about which the moment is the mean, g is small and has a direction; on it, none


class AttitudeAngles(NamedTuple):
    """Pitch, yaw and roll: the turns that take given axes y to the principal axes x, each of shape (...), rad.

    Parameters
    ----------
    pitch
        Angle alpha of the first turn, about axis 2.
    yaw
        Angle beta of the second turn, about axis 3 as the first has left it.
    roll
        Angle gamma of the third turn, about axis 1 as the second has left it.

    Examples
    --------
    >>> direction_cosines(*AttitudeAngles(pitch=0.1, yaw=0.2, roll=0.3)).shape
    (3, 3)
    """

    pitch: Array
    yaw: Array
    roll: Array


@gufunc("(),(),()->(row,axis)", row=3, axis=3)
def direction_cosines(pitch: ArrayLike, yaw: ArrayLike, roll: ArrayLike) -> Array:
    """The axes y from which attitude angles turn to the principal axes x: a_ij is the cosine between y_i and x_j.

    Parameters
    ----------
    pitch, yaw, roll
        Angles alpha, beta and gamma, rad; each of shape (...).

    Returns
    -------
    ndarray
        Right-handed orthonormal axes as rows; shape (..., 3, 3).

    Raises
    ------
    ValueError
        If an angle is not a finite number.

    Notes
    -----
    Source: mirer2009:2.7.5 to 2.7.13.

    Examples
    --------
    >>> direction_cosines(np.pi / 2, 0, 0).round(12).tolist()
    [[0.0, 0.0, 1.0], [0.0, 1.0, -0.0], [-1.0, 0.0, 0.0]]
    """
    angles = real("pitch", pitch), real("yaw", yaw), real("roll", roll)
    return stacked(mirer2009.direction_cosines(*angles), 3, 3)


@gufunc("(i,k)->(),(),()")
def attitude_angles(axes: Orientation) -> AttitudeAngles:
    """Pitch, yaw and roll of given axes, the inverse of `direction_cosines`.

    Parameters
    ----------
    axes
        Right-handed orthonormal axes as rows; shape (..., 3, 3).

    Returns
    -------
    AttitudeAngles
        Yaw from -pi/2 to pi/2, pitch and roll from -pi to pi.

    Raises
    ------
    ValueError
        If the axes are not orthonormal and right-handed.

    Notes
    -----
    At a yaw of 90 degrees either way pitch and roll turn about one line: the roll is then what rounding makes of it,
    and the pitch fits it, so that the angles always give the axes back. Source: mirer2009:2.7.

    Examples
    --------
    >>> np.round(attitude_angles(direction_cosines(0.1, 0.2, 0.3)), 12).tolist()
    [0.1, 0.2, 0.3]
    """
    axes = orthonormal_axes(axes)
    require(np.linalg.det(axes) > 0, "axes", axes, "be right-handed", "mirer2009:2.17.2")
    a = np.moveaxis(axes, (-2, -1), (0, 1))
    yaw = np.arctan2(a[1, 0], np.hypot(a[1, 1], a[1, 2]))
    roll = np.arctan2(-a[1, 2], a[1, 1])
    sine, cosine = (a[i, 1] * np.sin(roll) + a[i, 2] * np.cos(roll) for i in (0, 2))
    return AttitudeAngles(np.arctan2(sine, cosine), yaw, roll)


@gufunc("(k)->(),(),()")
def equal_moment_angles(moments: ArrayLike) -> AttitudeAngles:
    """The attitude angles of the paper at which all three axial moments are equal to the mean moment.

    Parameters
    ----------
    moments
        Principal moments of inertia, kg m^2; shape (..., 3).

    Returns
    -------
    AttitudeAngles
        Angles, rad; each of shape (...).

    Raises
    ------
    ValueError
        If a moment is not positive.

    Notes
    -----
    The yaw is arcsin(1/sqrt 3), the roll pi/4, and tan 2 alpha = sqrt 3 (I_1 - c)/(I_2 - I_3), with the pitch pi/4 or
    -pi/4 where I_2 = I_3, and 0 where all moments are equal and every pitch serves. Source: mirer2009:2.9, 2.9.2.

    Examples
    --------
    >>> np.round(equal_moment_angles([2, 3, 4]), 6).tolist()
    [0.523599, 0.61548, 0.785398]
    """
    moments = principal_moments(moments)
    spherical = np.ptp(moments, axis=-1) == 0
    with np.errstate(divide="ignore", invalid="ignore"):  # I_2 = I_3: the infinite tangent is meant
        pitch = mirer2009.equal_moment_pitch(*letters(moments))
    yaw, roll = np.array(np.arcsin(1 / np.sqrt(3))), np.array(np.pi / 4)
    return AttitudeAngles(*results(np.where(spherical, 0.0, pitch), yaw, roll))


@gufunc("(k),(),(),()->(row,k)", row=3)
def equal_moment_axes(
    moments: ArrayLike, phase: ArrayLike, quarter_turns: ArrayLike = 0, nappe: ArrayLike = 1
) -> Array:
    """The one-parameter family of axes about which all three moments of inertia are equal.

    Parameters
    ----------
    moments
        Principal moments of inertia, kg m^2; shape (..., 3).
    phase
        Angle about the axis of the cone J_1 = c that gives the place of the first axis on it, rad; shape (...).
    quarter_turns
        Number of right angles by which the other two axes are turned about the first; shape (...).
    nappe
        Nappe of the cone that has the first axis, 1 or -1; shape (...).

    Returns
    -------
    ndarray
        Right-handed axes as rows; shape (..., 3, 3).

    Raises
    ------
    ValueError
        If a moment is not positive, a number of quarter turns is not an integer, or the nappe is not 1 or -1.

    Notes
    -----
    The cone is that about the principal axis n whose moment is farthest from the mean c; with l, m the next two and d_i
    = I_i - c the first axis has the components

        a_1l = sqrt(d_n/(d_n - d_l)) cos(phase),  a_1m = sqrt(d_n/(d_n - d_m)) sin(phase),  a_1n = nappe sqrt(...),

    whose squares are the 1/3 + t (I_2 - I_3), ... of mirer2009:B.6. The second is at the angle theta with tan 2 theta =
    -d_1 d_2 d_3/W from g = (d_1 a_11, d_2 a_12, d_3 a_13) (B.12); up to the quarter turns nothing else serves (B.10),
    and phase, nappe and four quarter turns give every right-handed triple once. Only if a principal moment is the mean
    are there more (B.13): the same triples with their rows moved on cyclically. If all three are equal every triple
    serves; those of the body with the deviations (1, 1, -2) are returned.

    Examples
    --------
    >>> from symcheck.numeric.inertia.tensors import axial_moments
    >>> axial_moments([2, 3, 4.5], equal_moment_axes([2, 3, 4.5], [0.0, 0.7])).round(12).tolist()
    [[3.166666666667, 3.166666666667, 3.166666666667], [3.166666666667, 3.166666666667, 3.166666666667]]
    """
    arguments = real("phase", phase), real("quarter_turns", quarter_turns), real("nappe", nappe)
    require(arguments[1] == np.round(arguments[1]), "quarter_turns", arguments[1], "be an integer", "mirer2009:B.10")
    require(np.abs(arguments[2]) == 1, "nappe", arguments[2], "be 1 or -1", "mirer2009:B.6")
    moments = principal_moments(moments)
    shape = np.broadcast_shapes(moments.shape[:-1], *(argument.shape for argument in arguments))
    angle, turns, side = (np.broadcast_to(argument, shape)[..., None] for argument in arguments)
    deviations = np.broadcast_to(_deviations(moments), (*shape, 3))
    from_apex = np.argmax(np.abs(deviations), axis=-1)[..., None]
    d = np.take_along_axis(deviations, (from_apex + np.arange(3)) % 3, axis=-1)
    triple = _axes_across(d, _on_the_cone(d, angle, side), turns)
    return np.take_along_axis(triple, ((np.arange(3) - from_apex) % 3)[..., None, :], axis=-1)


def _deviations(moments: Array) -> Array:
    """I_i - c by differences of moments, in units of the largest; those of a disc where all are zero."""
    d = (moments - np.roll(moments, -1, axis=-1)) + (moments - np.roll(moments, -2, axis=-1))
    d = np.where((d == 0).all(axis=-1, keepdims=True), [1.0, 1.0, -2.0], d)
    scaled: Array = d / np.abs(d).max(axis=-1, keepdims=True)
    return scaled


def _on_the_cone(d: Array, phase: Array, nappe: Array) -> Array:
    """The unit vector x with sum d_i x_i^2 = 0 at a phase, for deviations the first of which has its sign alone."""
    others = np.abs(d[..., 1:])
    total = others.sum(axis=-1, keepdims=True)
    circle = np.concatenate([np.cos(phase), np.sin(phase)], axis=-1)
    circle = np.copysign(np.maximum(np.abs(circle), TINY), circle)
    apex = nappe * np.sqrt((others / (total + others) * circle**2).sum(axis=-1, keepdims=True))
    return np.concatenate([apex, np.sqrt(total / (total + others)) * circle], axis=-1)


def _axes_across(d: Array, first: Array, quarter_turns: Array) -> Array:
    """The triple with this first axis whose moments are equal.

    In the plane across it d is traceless, so the second axis halves the angle between the directions where d is
    extreme. Worked out from the basis at hand, not from d_1 d_2 d_3 and W, it is right to rounding whatever the basis.
    """
    g = d * first
    g = g - _dot(g, first) * first
    g = g / np.sqrt(_dot(g, g))
    h = np.cross(first, g)
    theta = np.arctan2(_dot(d * h, h) - _dot(d * g, g), 2 * _dot(d * g, h)) / 2 + quarter_turns % 4 * (np.pi / 2)
    second = np.cos(theta) * g + np.sin(theta) * h
    return np.stack([first, second, np.cross(first, second)], axis=-2)


def _dot(x: Array, y: Array) -> Array:
    product: Array = (x * y).sum(axis=-1, keepdims=True)
    return product
