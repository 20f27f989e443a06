"""Orientations as SciPy's rotations, as quaternions in either order, and as modified Rodrigues parameters (MRPs).

A matrix of axes has axis i in row i, in components along the reference axes; in this layer these are the principal
axes. It is the direction cosine matrix that takes components along the reference axes to those along the given ones,
[BN] of many texts. The rotation that belongs to it turns the reference axes into the given ones: `Rotation.apply` takes
components along the given axes to those along the reference axes. Quaternion and MRP are those of this rotation, the
scalar part is not negative, and the MRP is at most 1 long.

Decision: the conversions are SciPy's. Reason: they are well kept, and accurate at every angle.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import Array, Orientation, one_of, orthonormal_axes, power_of_two, real, require

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation

ORDERS = {"scalar first": True, "scalar last": False}
LONGEST = 1e100  # of an MRP: its square is a double


def rotation(axes: Orientation) -> Rotation:
    """The rotation that turns the reference axes into the given ones.

    Parameters
    ----------
    axes
        Right-handed orthonormal axes as rows; shape (3, 3) or (n, 3, 3).

    Returns
    -------
    Rotation
        One rotation, or n.

    Raises
    ------
    ValueError
        If the axes are not orthonormal and right-handed, or have more than one leading axis.

    Notes
    -----
    Source: mirer2009:2.7 for the rows.

    Examples
    --------
    >>> turn = rotation([[0, 1, 0], [-1, 0, 0], [0, 0, 1]])  # by a right angle about the third axis
    >>> turn.as_rotvec(degrees=True).round(6).tolist()
    [0.0, 0.0, 90.0]
    >>> turn.apply([1, 0, 0]).round(6).tolist()  # the first of the given axes
    [0.0, 1.0, 0.0]
    """
    array = _right_handed(axes)
    require(array.ndim <= 3, "axes", array.shape, "have one leading axis at most; reshape them to (n, 3, 3)")
    return _turned(array)


@gufunc("(i,k)->(i,k)")
def axes_of_rotation(rotation: Orientation) -> Array:
    """The axes into which a rotation turns the reference axes, the inverse of `rotation`.

    Parameters
    ----------
    rotation
        One rotation, or many; or right-handed orthonormal axes as rows, which are returned.

    Returns
    -------
    ndarray
        Axes as rows; shape (..., 3, 3).

    Raises
    ------
    ValueError
        If axes are not orthonormal and right-handed.

    Notes
    -----
    Source: mirer2009:2.7 for the rows.

    Examples
    --------
    >>> from scipy.spatial.transform import Rotation
    >>> axes_of_rotation(Rotation.from_euler("z", 90, degrees=True)).round(6)[0].tolist()
    [0.0, 1.0, 0.0]
    """
    return _right_handed(rotation).copy()


@gufunc("(i,k)->(component)", component=4)
def quaternion(axes: Orientation, order: str) -> Array:
    """The unit quaternion of the rotation that turns the reference axes into the given ones.

    Parameters
    ----------
    axes
        Right-handed orthonormal axes as rows, shape (..., 3, 3), or rotations.
    order
        "scalar first" for (w, x, y, z), or "scalar last" for (x, y, z, w). There is no default: half of all programs
        have the one, half the other.

    Returns
    -------
    ndarray
        Quaternion, shape (..., 4), with w >= 0.

    Raises
    ------
    ValueError
        If the axes are not orthonormal and right-handed, or the order is another.

    Notes
    -----
    It is (cos(phi/2), e sin(phi/2)) of the angle phi about e. Basilisk writes the scalar first, 42 and SciPy write it
    last. Source: `scipy.spatial.transform.Rotation.as_quat`.

    Examples
    --------
    >>> quaternion([[0, 1, 0], [-1, 0, 0], [0, 0, 1]], order="scalar first").round(6).tolist()
    [0.707107, 0.0, 0.0, 0.707107]
    """
    one_of("order", order, ORDERS)
    array = _right_handed(axes)
    return _each(array, 2, lambda turns: _turned(turns).as_quat(canonical=True, scalar_first=ORDERS[order]), 4)


@gufunc("(component)->(i,k)", i=3, k=3)
def axes_of_quaternion(quaternion: ArrayLike, order: str) -> Array:
    """The axes of a quaternion, the inverse of `quaternion`.

    Parameters
    ----------
    quaternion
        Quaternion of any length but 0; shape (..., 4). It and its opposite are the same orientation.
    order
        "scalar first" for (w, x, y, z), or "scalar last" for (x, y, z, w).

    Returns
    -------
    ndarray
        Axes as rows; shape (..., 3, 3).

    Raises
    ------
    ValueError
        If a quaternion is 0 or has other than four finite numbers, or the order is another.

    Notes
    -----
    Source: `scipy.spatial.transform.Rotation.from_quat`.

    Examples
    --------
    >>> axes_of_quaternion([1, 0, 0, 1], order="scalar first").round(6)[0].tolist()
    [0.0, 1.0, 0.0]
    """
    one_of("order", order, ORDERS)
    array = real("quaternion", quaternion, (4,))
    largest = np.abs(array).max(axis=-1, keepdims=True)
    require(largest[..., 0] > 0, "quaternion", array, "not be zero")
    unit = array / power_of_two(largest)  # first, as its square may leave the range of doubles

    def axes(values: Array) -> Array:
        from scipy.spatial.transform import Rotation

        return _rows(Rotation.from_quat(values, scalar_first=ORDERS[order]))

    return _each(unit, 1, axes, 3, 3)


@gufunc("(i,k)->(component)", component=3)
def mrp(axes: Orientation) -> Array:
    """The modified Rodrigues parameters, e tan(phi/4) of the angle phi about e, not longer than 1.

    Parameters
    ----------
    axes
        Right-handed orthonormal axes as rows, shape (..., 3, 3), or rotations.

    Returns
    -------
    ndarray
        MRP; shape (..., 3).

    Raises
    ------
    ValueError
        If the axes are not orthonormal and right-handed.

    Notes
    -----
    For axes of a body in an inertial frame it is sigma_BN of Basilisk. Source:
    `scipy.spatial.transform.Rotation.as_mrp`.

    Examples
    --------
    >>> mrp([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]).round(6).tolist()  # tan(90 deg/4)
    [0.0, 0.0, 0.414214]
    """
    return _each(_right_handed(axes), 2, lambda turns: _turned(turns).as_mrp(), 3)


@gufunc("(component)->(i,k)", i=3, k=3)
def axes_of_mrp(mrp: ArrayLike) -> Array:
    """The axes of modified Rodrigues parameters, the inverse of `mrp`.

    Parameters
    ----------
    mrp
        MRP; shape (..., 3). It and its shadow, -mrp/|mrp|^2, are the same orientation.

    Returns
    -------
    ndarray
        Axes as rows; shape (..., 3, 3).

    Raises
    ------
    ValueError
        If an MRP has other than three finite numbers, or is longer than 1e100.

    Notes
    -----
    Source: `scipy.spatial.transform.Rotation.from_mrp`.

    Examples
    --------
    >>> axes_of_mrp([0, 0, 1]).round(6)[0].tolist()  # half a turn
    [-1.0, 0.0, 0.0]
    """
    array = real("mrp", mrp, (3,))
    require(np.abs(array) <= LONGEST, "mrp", array, f"have components of at most {LONGEST:g}")

    def axes(values: Array) -> Array:
        from scipy.spatial.transform import Rotation

        return _rows(Rotation.from_mrp(values))

    return _each(array, 1, axes, 3, 3)


def _right_handed(axes: Orientation) -> Array:
    array = orthonormal_axes(axes)
    require(np.linalg.det(array) > 0, "axes", array, "be right-handed", "mirer2009:2.17.2")
    return array


def _turned(axes: Array) -> Rotation:
    from scipy.spatial.transform import Rotation

    return Rotation.from_matrix(axes.swapaxes(-1, -2))


def _rows(turns: Rotation) -> Array:
    return np.asarray(turns.as_matrix()).swapaxes(-1, -2)


def _each(values: Array, core: int, function: Callable[[Array], Array], *shape: int) -> Array:
    """The function on all values in a row: SciPy before 1.17 takes one leading axis, and none read-only values."""
    lead = values.shape[: values.ndim - core]
    if not values.size:
        return np.empty((*lead, *shape))
    flat = values.reshape(-1, *values.shape[values.ndim - core :]).copy()
    return np.array(function(flat)).reshape(*lead, *shape)
