"""Damping of a rigid body's rotation by three devices: gains, characteristic roots, stability degree, the optimum.

Device i gives the torque -k_i (w, e_i) along its axis e_i; together they give -m w with the damping matrix m. All
vectors and matrices are in principal axes; leading axes of all arguments broadcast.
"""

from __future__ import annotations

from itertools import chain
from typing import Any, NamedTuple, cast

import numpy as np
from numpy.typing import ArrayLike

from symcheck.generated import mirer2009
from symcheck.numeric.arrays import eigensystem, letters, of_one_shape, stacked
from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import (
    Array,
    Orientation,
    evaluated,
    finite,
    in_one_library,
    is_numpy,
    not_negative,
    orthonormal_axes,
    positive,
    principal_moments,
    real,
    symmetric_matrix,
    unit_axes,
)

ROWS = ((0, 1, 2), (1, 3, 4), (2, 4, 5))  # of a symmetric matrix in its entries on the diagonal and above


class Devices(NamedTuple):
    """Three damping devices.

    Parameters
    ----------
    gains
        Gains, N m s/rad; shape (..., 3).
    axes
        Axes of the devices as rows, in principal axes; shape (..., 3, 3).

    Examples
    --------
    >>> damping_matrix(*Devices(np.array([1.0, 2.0, 3.0]), np.eye(3))).diagonal().tolist()
    [1.0, 2.0, 3.0]
    """

    gains: Array
    axes: Array


class HarmonicMean(NamedTuple):
    """The harmonic mean of three damping rates and how far it is above the least, each of shape (...), 1/s.

    Parameters
    ----------
    mean
        The harmonic mean. For gains k J_i it is k, whatever the axes: the greatest stability degree (mirer2009:B.3).
    excess
        The mean less the least rate, without cancellation: what the axes lose (mirer2009:B.4).

    Examples
    --------
    >>> float(harmonic_mean_of_rates([1, 1, 1]).excess)
    0.0
    """

    mean: Array
    excess: Array


@gufunc("(),(k),(i,k)->(i)")
def gains_in_proportion(ratio: ArrayLike, moments: ArrayLike, axes: Orientation) -> Array:
    """Gains in proportion to the moments of inertia about the devices' axes: k_i = k J_i.

    Parameters
    ----------
    ratio
        Ratio k of gain to moment, 1/s; shape (...).
    moments
        Principal moments of inertia, kg m^2; shape (..., 3).
    axes
        Orthonormal axes as rows; shape (..., 3, 3).

    Returns
    -------
    ndarray
        Gains k_i, N m s/rad; shape (..., 3).

    Raises
    ------
    ValueError
        If the ratio or a moment is not positive or the axes are not orthonormal.

    Notes
    -----
    Source: mirer2009:1.4.3.

    Examples
    --------
    >>> gains_in_proportion(0.1, [2, 3, 4], np.eye(3)).round(12).tolist()
    [0.2, 0.3, 0.4]
    """
    values = _ratio(ratio), *letters(principal_moments(moments)), *letters(orthonormal_axes(axes), axes=2)
    return evaluated("a gain", lambda *x: stacked(mirer2009.gains_in_proportion(*x)), *values)


@gufunc("(i),(i,k)->(k,column)", column=3)
def damping_matrix(gains: ArrayLike, axes: Orientation) -> Array:
    """The damping matrix of three devices, m_is = sum of k_j a_js a_ji over j.

    Parameters
    ----------
    gains
        Gains k_i, N m s/rad; shape (..., 3). A device that is switched off has 0.
    axes
        Axes of the devices as rows, unit vectors that need not be orthogonal; shape (..., 3, 3).

    Returns
    -------
    ndarray
        Shape (..., 3, 3), N m s/rad.

    Raises
    ------
    ValueError
        If a gain is negative or a row is not a unit vector.

    Notes
    -----
    Source: mirer2009:1.2.4.

    Examples
    --------
    >>> damping_matrix([5, 0, 0], [[0.6, 0.8, 0], [0, 1, 0], [0, 0, 1]]).round(12).tolist()
    [[1.8, 2.4, 0.0], [2.4, 3.2, 0.0], [0.0, 0.0, 0.0]]
    """
    values = letters(_gains(gains)), letters(unit_axes(axes, "mirer2009:1.0.2", 3), axes=2)
    return evaluated("the matrix", _symmetric, *chain(*values))


@gufunc("(i,j)->(i),(i,j)")
def orthogonal_devices(damping: ArrayLike) -> Devices:
    """Three devices along orthogonal axes with a given damping matrix: m = S^T B S, gains b_ii along the rows of S.

    Parameters
    ----------
    damping
        Damping matrix of devices along any axes, N m s/rad; shape (..., 3, 3).

    Returns
    -------
    Devices
        Gains in ascending order, along right-handed axes.

    Raises
    ------
    ValueError
        If the matrix is not symmetric.

    Notes
    -----
    Source: mirer2009:1.2.7 to 1.2.10.

    Examples
    --------
    >>> gains, axes = orthogonal_devices(damping_matrix([1, 1, 2], [[1, 0, 0], [0.6, 0.8, 0], [0, 0, 1]]))
    >>> gains.round(12).tolist()
    [0.4, 1.6, 2.0]
    """
    return Devices(*eigensystem(symmetric_matrix("damping", damping, "mirer2009:1.2.6")))


@gufunc("(k),(i),(i,k)->(coefficient)", coefficient=4)
def characteristic_coefficients(moments: ArrayLike, gains: ArrayLike, axes: Orientation) -> Array:
    """Coefficients of the characteristic equation (1.3).

    Parameters
    ----------
    moments
        Principal moments of inertia, kg m^2; shape (..., 3).
    gains
        Gains k_i, N m s/rad; shape (..., 3), not negative.
    axes
        Orthonormal axes as rows; shape (..., 3, 3).

    Returns
    -------
    ndarray
        Coefficients, of p^3 first, kg^3 m^6/s^0 to kg^3 m^6/s^3; shape (..., 4).

    Raises
    ------
    ValueError
        If a moment is not positive, a gain is negative or the axes are not orthonormal.

    Notes
    -----
    For the roots call `characteristic_roots`: the optimum is a triple root, which coefficients give to a third of the
    digits. Source: mirer2009:1.3.

    Examples
    --------
    >>> characteristic_coefficients([1, 2, 3], [1, 2, 3], np.eye(3)).tolist()
    [6.0, 18.0, 18.0, 6.0]
    """
    arguments = letters(principal_moments(moments)), letters(_gains(gains)), letters(orthonormal_axes(axes), axes=2)
    coefficients = mirer2009.characteristic_coefficients
    return evaluated("a coefficient", lambda *x: stacked(coefficients(*x)), *chain(*arguments))


@gufunc("(i),(i,j)->(i)")
def characteristic_roots(moments: ArrayLike, damping: ArrayLike) -> Array:
    """The roots p of det(I p + m) = 0, all real (mirer2009:B.2).

    Parameters
    ----------
    moments
        Principal moments of inertia, kg m^2; shape (..., 3).
    damping
        Damping matrix in principal axes, N m s/rad; shape (..., 3, 3).

    Returns
    -------
    ndarray
        Roots in ascending order, 1/s; shape (..., 3).

    Raises
    ------
    ValueError
        If a moment is not positive or the matrix is not symmetric.

    Notes
    -----
    They are the eigenvalues of -m_ij/sqrt(I_i I_j), right to rounding of the largest, at a triple root as elsewhere.
    Source: mirer2009:1.2.17.

    Examples
    --------
    >>> characteristic_roots([2, 3, 4], np.diag([1.0, 3.0, 2.0])).round(12).tolist()
    [-1.0, -0.5, -0.5]
    """
    scale = np.sqrt(principal_moments(moments))
    matrix = symmetric_matrix("damping", damping, "mirer2009:1.2.6") / (scale[..., :, None] * scale[..., None, :])
    return np.linalg.eigvalsh(-matrix)


@gufunc("(i),(i,j)->()")
def stability_degree(moments: ArrayLike, damping: ArrayLike) -> Array:
    """The stability degree xi: minus the characteristic root nearest to zero.

    Parameters
    ----------
    moments, damping
        As for `characteristic_roots`.

    Returns
    -------
    ndarray
        Shape (...), 1/s; negative if the rotation is not damped.

    Raises
    ------
    ValueError
        If a moment is not positive or the matrix is not symmetric.

    Notes
    -----
    It is the least damping rate. Source: mirer2009:1.2.14.

    Examples
    --------
    >>> float(stability_degree([2, 3, 4], np.diag([1.0, 3.0, 2.0])).round(12))
    0.5
    """
    return -characteristic_roots(moments, damping)[..., -1]


@gufunc("(i),()->(i),(i,axis)", axis=3)
def optimal_devices(moments: ArrayLike, degree: ArrayLike) -> Devices:
    """Devices with a given stability degree xi and the least gain ratio: k_i = xi I_i along the principal axes.

    Parameters
    ----------
    moments
        Principal moments of inertia, kg m^2; shape (..., 3).
    degree
        Stability degree xi, 1/s; shape (...).

    Returns
    -------
    Devices
        The gains, and the principal axes.

    Raises
    ------
    ValueError
        If a moment or the degree is not positive.

    Notes
    -----
    For gains k J_i the degree is at most k (mirer2009:B.4), and here it is k. Source: mirer2009:1.8, 1.8.1.

    Examples
    --------
    >>> gains, axes = optimal_devices([2, 3, 4], 0.1)
    >>> float(stability_degree([2, 3, 4], damping_matrix(gains, axes)).round(12))
    0.1
    """
    gains = gains_in_proportion(_ratio(degree, "degree"), moments, np.eye(3))
    return Devices(gains, np.tile(np.eye(3), (*gains.shape[:-1], 1, 1)))


@gufunc("(i)->(),()")
def harmonic_mean_of_rates(rates: ArrayLike) -> HarmonicMean:
    """The harmonic mean of three damping rates, which for gains k J_i is k, and its excess over the least rate.

    Parameters
    ----------
    rates
        Damping rates (the characteristic roots with the opposite sign), 1/s, in any order; shape (..., 3).

    Returns
    -------
    HarmonicMean
        The mean and its excess over the least rate.

    Raises
    ------
    ValueError
        If a rate is not positive.

    Notes
    -----
    Source: mirer2009:B.3, B.4.

    Examples
    --------
    >>> np.round(harmonic_mean_of_rates([1, 2, 2]), 12).tolist()
    [1.5, 0.5]
    """
    rates = positive("rates", rates, "mirer2009:B.4", (3,))
    least = rates.min(axis=-1)
    excess = letters(rates - least[..., None])
    with np.errstate(all="ignore"):
        mean, loss = mirer2009.gain_of_rates(least, *excess)
    return HarmonicMean(finite("the mean", mean), finite("the excess", loss))


@gufunc("(),(i),()->()")
def stability_degree_in_pitch(ratio: ArrayLike, moments: ArrayLike, pitch: ArrayLike) -> Array:
    """The stability degree of gains k J_i along axes turned by the pitch alone, in closed form.

    Parameters
    ----------
    ratio
        Ratio k of gain to moment, 1/s; shape (...).
    moments
        Principal moments of inertia, kg m^2; shape (..., 3). The second does not matter.
    pitch
        Angle alpha, rad; shape (...).

    Returns
    -------
    ndarray
        Shape (...), 1/s.

    Raises
    ------
    ValueError
        If the ratio or a moment is not positive.

    Notes
    -----
    It is k where the axes are principal or I_1 = I_3, and least at 45 degrees. Source: mirer2009:1.5, B.2 to B.4.

    Examples
    --------
    >>> stability_degree_in_pitch(1.0, [1, 2, 3], [0.0, np.pi / 4, np.pi / 2]).round(12).tolist()
    [1.0, 0.666666666667, 1.0]
    """
    first, _, third = letters(principal_moments(moments))
    arguments = of_one_shape(*in_one_library(_ratio(ratio), first, third, real("pitch", pitch)))
    if not all(map(is_numpy, arguments)):
        return _degree_in_library(*arguments)
    with np.errstate(divide="ignore", over="ignore"):  # principal axes: the infinite quotient is meant, and gives k
        degree: Array = mirer2009.stability_degree_in_pitch(*arguments)
    return degree


def _degree_in_library(ratio: Array, first: Array, third: Array, pitch: Array) -> Array:
    """The stability degree in pitch, with derivatives also where it is the ratio: no quotient is formed there."""
    from array_api_compat import array_namespace

    library: Any = array_namespace(ratio, first, third, pitch)
    principal = (pitch == 0) | (first == third)
    apart = [library.where(principal, y, x) for x, y in ((first, 1.0), (third, 2.0), (pitch, 0.5))]
    return cast("Array", library.where(principal, ratio, mirer2009.stability_degree_in_pitch(ratio, *apart)))


def _symmetric(*values: Array) -> Array:
    entries = mirer2009.damping_matrix(*values)
    return stacked([entries[k] for k in chain(*ROWS)], 3, 3)


def _ratio(value: ArrayLike, name: str = "ratio") -> Array:
    return positive(name, value, "mirer2009:1.8")


def _gains(value: ArrayLike) -> Array:
    return not_negative("gains", value, "mirer2009:1.0.4: a device damps", (3,))
