"""What fits into a momentum envelope: points, ellipsoids, and how far one comes in a direction or about an axis.

All of it is asked of half-spaces, so that it holds for envelopes of momenta, for what failures leave of them and for
the polytope of angular rates alike. Leading axes broadcast: half-spaces of many sets, or many points, or both.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from math import prod

import numpy as np
from numpy.typing import ArrayLike

from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import (
    Array,
    Orientation,
    doubles,
    finite,
    moderate,
    momentum,
    not_negative,
    orthonormal_axes,
    power_of_two,
    principal_moments,
    real,
    require,
)
from symcheck.numeric.wheels.faces import HalfSpaces

NONE = 1e-12  # of a length of 1: a vector that lies in a plane to rounding does not leave it
BLOCK = 1 << 18  # numbers at once: 2 MB
Value = Callable[[Array, Array, Array], Array]  # of some half-spaces, from their n, d and |n . c|


@gufunc("(p,axis),(p),(axis),(axis)->()")
def margin(half_spaces: HalfSpaces, point: ArrayLike) -> Array:
    """How far a point is from the nearest plane, min_j (d_j - |n_j . (H - c)|): positive inside, negative outside.

    Parameters
    ----------
    half_spaces
        Half-spaces of one envelope, or of many.
    point
        Momentum H, N m s; shape (..., 3).

    Returns
    -------
    ndarray
        Margin, N m s; shape (...). Inside it is the distance from the boundary; outside, a lower bound of that with the
        sign changed.

    Raises
    ------
    ValueError
        If the point is not three finite numbers.

    Notes
    -----
    Source: condition (1.1) for one momentum.

    Examples
    --------
    >>> from symcheck.numeric.wheels import half_spaces
    >>> margin(half_spaces(np.eye(3)), [[0.75, 0, 0], [2, 0, 0]])
    array([ 0.25, -1.  ])
    """
    return _margin(checked_half_spaces(half_spaces), momentum("point", point, (3,)))


@gufunc("(p,axis),(p),(axis),(axis),(row,axis)->()")
def ellipsoid_margin(half_spaces: HalfSpaces, semi_axes: ArrayLike, axes: Orientation | None = None) -> Array:
    """How far an ellipsoid about the origin stays from the nearest plane, min_j (d_j - |n_j . c| - |S n_j|).

    Parameters
    ----------
    half_spaces
        Half-spaces of one envelope, or of many.
    semi_axes
        Lengths s_k of the semi-axes, S = diag(s_1, s_2, s_3), N m s; shape (..., 3), not negative. For the ellipsoid
        (1.2) s_k = J_k w_k.
    axes
        Directions of the semi-axes as rows; shape (..., 3, 3). By default OX, OY, OZ.

    Returns
    -------
    ndarray
        Margin, N m s; shape (...). Condition (1.1) holds exactly if it is not negative.

    Raises
    ------
    ValueError
        If a semi-axis is negative or the axes are not orthonormal.

    Notes
    -----
    Source: (1.1), (1.2).

    Examples
    --------
    >>> from symcheck.numeric.wheels import half_spaces
    >>> ellipsoid_margin(half_spaces(np.eye(3)), [0.5, 0.75, 0.25])
    array(0.25)
    """
    half_spaces, reach = checked_half_spaces(half_spaces), _reach(semi_axes, axes)
    return _least(half_spaces, reach.shape[:-2], lambda n, d, c: d - c - _norm(n, reach))


@gufunc("(p,axis),(p),(axis),(axis),(row,axis)->()")
def ellipsoid_scale(half_spaces: HalfSpaces, semi_axes: ArrayLike, axes: Orientation | None = None) -> Array:
    """By what factor an ellipsoid about the origin can grow inside the envelope, min_j (d_j - |n_j . c|)/|S n_j|.

    Parameters
    ----------
    half_spaces
        Half-spaces of envelopes that contain the origin.
    semi_axes, axes
        As for `ellipsoid_margin`.

    Returns
    -------
    ndarray
        Factor; shape (...). Condition (1.1) holds exactly if it is 1 or more; it is infinite if the ellipsoid is a
        point.

    Raises
    ------
    ValueError
        As `ellipsoid_margin` does, and if the origin lies outside.

    Notes
    -----
    Source: (1.1), (1.2).

    Examples
    --------
    >>> from symcheck.numeric.wheels import half_spaces
    >>> ellipsoid_scale(half_spaces(np.eye(3)), [0.5, 0.8, 0.25])
    array(1.25)
    """
    half_spaces, reach = checked_half_spaces(half_spaces), _reach(semi_axes, axes)
    _holds_origin(half_spaces)
    with np.errstate(over="ignore"):
        scale = _least_quotient(half_spaces, reach.shape[:-2], lambda n, d, c: d - c, lambda n, d, c: _norm(n, reach))
    is_point = ~reach.any(axis=(-1, -2))
    require(np.isfinite(scale) | is_point, "the factor", scale, "be a finite double; take semi_axes in another unit")
    return scale


@gufunc("(p,axis),(p),(axis),(axis)->()")
def largest_momentum(half_spaces: HalfSpaces, direction: ArrayLike) -> Array:
    """The largest momentum that the wheels reach in a direction u: the greatest t with t u in the envelope.

        t = min_j (d_j +- n_j . c)/|n_j . u|, the sign that of n_j . u

    Parameters
    ----------
    half_spaces
        Half-spaces of envelopes that contain the origin.
    direction
        Direction u, of any length but 0; shape (..., 3).

    Returns
    -------
    ndarray
        Momentum, N m s; shape (...). It is 0 in a direction that leaves the plane or line of a flat envelope.

    Raises
    ------
    ValueError
        If the direction is 0 or the origin lies outside.

    Notes
    -----
    For half-spaces of `rates` it is the largest angular rate about u. Source: (2.1), (3.1).

    Examples
    --------
    >>> from symcheck.numeric.wheels import half_spaces
    >>> largest_momentum(half_spaces(np.eye(3)), [[1, 0, 0], [1, 1, 0]]).round(6)
    array([1.      , 1.414214])
    """
    vector = real("direction", direction, (3,))
    largest = np.abs(vector).max(axis=-1, keepdims=True)
    require(largest[..., 0] > 0, "direction", vector, "not be zero")
    unit = vector / power_of_two(largest)  # first, as squares of it may leave the range of doubles
    unit /= np.linalg.norm(unit, axis=-1, keepdims=True)
    half_spaces = checked_half_spaces(half_spaces)
    _holds_origin(half_spaces)

    def along(n: Array) -> Array:
        return np.asarray(np.einsum("...jk,...k->...j", n, unit))

    def room(n: Array, d: Array, c: Array) -> Array:
        return np.asarray(d + np.sign(along(n)) * np.einsum("...jk,...k->...j", n, half_spaces.centre))

    with np.errstate(over="ignore"):
        largest = _least_quotient(half_spaces, unit.shape[:-1], room, lambda n, d, c: np.abs(along(n)))
    return finite("the largest momentum", largest)


@gufunc("(p,axis),(p),(axis),(axis)->(p,axis),(p),(axis)")
def rates(half_spaces: HalfSpaces, moments: ArrayLike) -> HalfSpaces:
    """The half-spaces of the angular rates w = -H/J that the momenta H give a body whose total momentum is zero.

    Parameters
    ----------
    half_spaces
        Half-spaces of one envelope, or of many.
    moments
        Principal moments of inertia J_x, J_y, J_z, kg m^2; shape (..., 3).

    Returns
    -------
    HalfSpaces
        Normals along J n_j, distances d_j/|J n_j|, rad/s, and the centre -c/J.

    Raises
    ------
    ValueError
        If a moment is not positive.

    Notes
    -----
    Source: (2.3).

    Examples
    --------
    >>> from symcheck.numeric.wheels import half_spaces
    >>> rates(half_spaces(np.eye(3)), [1, 2, 4]).distances
    array([0.25, 0.5 , 1.  ])
    """
    return _rates(checked_half_spaces(half_spaces), principal_moments(moments))


@gufunc("(p,axis),(p),(axis),(axis)->()")
def guaranteed_rate(half_spaces: HalfSpaces, moments: ArrayLike) -> Array:
    """The largest angular rate that is reached about every axis: the radius of the largest ball in `rates`.

    Parameters
    ----------
    half_spaces, moments
        As for `rates`.

    Returns
    -------
    ndarray
        Angular rate, rad/s; shape (...). It is negative if not even the rate 0 is reached.

    Raises
    ------
    ValueError
        If a moment is not positive.

    Notes
    -----
    Source: (1.1) for w_x = w_y = w_z and (2.3).

    Examples
    --------
    >>> from symcheck.numeric.wheels import half_spaces
    >>> guaranteed_rate(half_spaces(np.eye(3)), [1, 2, 4])
    array(0.25)
    """
    return _margin(_rates(checked_half_spaces(half_spaces), principal_moments(moments)), np.zeros(3))


def checked_half_spaces(half_spaces: HalfSpaces) -> HalfSpaces:
    """Half-spaces as arrays of doubles, none of them NaN."""
    normals = real("normals of half_spaces", half_spaces.normals, (None, 3))
    distances = doubles("distances of half_spaces", half_spaces.distances, (normals.shape[-2],))
    require(distances >= 0, "distances of half_spaces", distances, "be numbers that are not negative", "(2.1)")
    return HalfSpaces(normals, distances, momentum("centre of half_spaces", half_spaces.centre, (3,)))


def _margin(half_spaces: HalfSpaces, point: Array) -> Array:
    offset = point - half_spaces.centre
    return _least(half_spaces, offset.shape[:-1], lambda n, d, c: d - np.abs(np.einsum("...jk,...k->...j", n, offset)))


def _rates(half_spaces: HalfSpaces, moments: Array) -> HalfSpaces:
    normals = half_spaces.normals * moments[..., None, :]
    lengths = np.linalg.norm(normals, axis=-1)
    parallel = lengths == 0
    lengths = np.where(parallel, 1, lengths)  # no plane: 0 and infinity stay what they are
    with np.errstate(over="ignore"):
        distances, centre = half_spaces.distances / lengths, -half_spaces.centre / moments
    moderate("a rate", np.where(half_spaces.distances == np.inf, 0, distances))
    return HalfSpaces(normals / lengths[..., None], distances, moderate("the centre of the rates", centre))


def _least(half_spaces: HalfSpaces, lead: tuple[int, ...], value: Value) -> Array:
    """The least value over all half-spaces, some at a time."""
    values = (_of(half_spaces, block, value) for block in _blocks(half_spaces, lead))
    return np.asarray(reduce(np.minimum, (part.min(axis=-1, initial=np.inf) for part in values)))


def _least_quotient(half_spaces: HalfSpaces, lead: tuple[int, ...], room: Value, reach: Value) -> Array:
    """The least room/reach over all half-spaces, some at a time; what lies in a plane to rounding does not reach it.

    The scale of rounding is the greatest reach towards all planes: towards one block alone it may be rounding too.
    """
    blocks = _blocks(half_spaces, lead)
    reaches = (_of(half_spaces, block, reach) for block in blocks)
    greatest = reduce(np.maximum, (part.max(axis=-1, initial=0) for part in reaches))[..., None]

    def quotient(n: Array, d: Array, c: Array) -> Array:
        towards = reach(n, d, c)
        above, below, reached = np.broadcast_arrays(room(n, d, c), towards, towards > NONE * greatest)
        return np.asarray(np.divide(above, below, where=reached, out=np.full(above.shape, np.inf)))

    return _least(half_spaces, lead, quotient)


def _of(half_spaces: HalfSpaces, block: slice, value: Value) -> Array:
    """The value for some of the half-spaces, which gets their n, d and |n . c|."""
    n, d = half_spaces.normals[..., block, :], half_spaces.distances[..., block]
    return value(n, d, np.abs(np.einsum("...jk,...k->...j", n, half_spaces.centre)))


def _blocks(half_spaces: HalfSpaces, lead: tuple[int, ...]) -> list[slice]:
    """All half-spaces, some at a time; one block at least."""
    _, distances, centre = half_spaces
    points = prod(np.broadcast_shapes(lead, distances.shape[:-1], centre.shape[:-1]))
    step = max(1, BLOCK // max(1, points))
    return [slice(start, start + step) for start in range(0, max(1, distances.shape[-1]), step)]


def _reach(semi_axes: ArrayLike, axes: Orientation | None) -> Array:
    """The rows s_i u_i, shape (..., 3, 3)."""
    lengths = moderate("semi_axes", not_negative("semi_axes", semi_axes, "(1.2)", (3,)))
    directions = np.eye(3) if axes is None else orthonormal_axes(axes)
    return lengths[..., None] * directions


def _norm(normals: Array, reach: Array) -> Array:
    """|S n|: how far the ellipsoid reaches along each normal."""
    scale = power_of_two(np.abs(reach).max(axis=(-1, -2), initial=0))[..., None]  # its squares remain doubles
    return np.asarray(np.linalg.norm(normals @ (reach / scale[..., None]).swapaxes(-1, -2), axis=-1) * scale)


def _holds_origin(half_spaces: HalfSpaces) -> None:
    inside = _margin(half_spaces, np.zeros(3))
    condition = "not be negative: the biases take the origin out of the envelope; make them smaller"
    distances = half_spaces.distances
    size = distances.max(
        axis=-1, where=np.isfinite(distances), initial=0
    )  # each envelope's own, however many there are
    rounding = NONE * (size + np.abs(half_spaces.centre).max(axis=-1))
    require(inside >= -rounding, "the margin of the origin", inside, condition)
