"""Inertia tensors: principal axes, moments about turned axes, and how far their products are from their bounds.

A matrix of axes has axis i in row i, as direction cosines to the principal axes. Leading axes of all arguments
broadcast.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from symcheck.generated import mirer2009
from symcheck.numeric.arrays import eigensystem, letters, results, stacked
from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import (
    ROUNDING,
    Array,
    Orientation,
    moments_of_a_mass,
    orthonormal_axes,
    principal_moments,
    real,
    require,
    slack_of,
    symmetric_matrix,
)


class PrincipalInertia(NamedTuple):
    """Principal moments of inertia and principal axes.

    Parameters
    ----------
    moments
        Principal moments, ascending, kg m^2; shape (..., 3).
    axes
        Right-handed principal axes as rows, in the axes of the tensor; shape (..., 3, 3).

    Examples
    --------
    >>> moments, axes = PrincipalInertia(np.array([2.0, 3.0, 4.0]), np.eye(3))
    """

    moments: Array
    axes: Array


class BoundedProduct(NamedTuple):
    """A product f = J_1 J_2 J_3 of axial moments between its bounds (2.1), each of shape (...), kg^3 m^6.

    Parameters
    ----------
    value
        The product f.
    least
        The bound I_1 I_2 I_3, attained by principal axes.
    greatest
        The bound ((I_1 + I_2 + I_3)/3)^3, attained by axes of equal moments.
    excess
        Difference f - least, without cancellation (mirer2009:2.13.4).
    deficit
        Difference greatest - f, without cancellation (the proof of mirer2009:2.1b).

    Examples
    --------
    >>> float(product_of_axial_moments([2, 3, 4], np.eye(3)).greatest)
    27.0
    """

    value: Array
    least: Array
    greatest: Array
    excess: Array
    deficit: Array


class BoundedSum(NamedTuple):
    """A sum S = J_1 L_1 + J_2 L_2 + J_3 L_3 above its bound (2.18), each of shape (...), kg^3 m^6.

    Parameters
    ----------
    value
        The sum S.
    least
        The bound 3 I_1 I_2 I_3, attained by principal axes.
    excess
        Difference S - least, without cancellation (mirer2009:2.19.4).

    Examples
    --------
    >>> float(sum_of_products([2, 3, 4], np.eye(3)).excess)
    0.0
    """

    value: Array
    least: Array
    excess: Array


@gufunc("(i,j)->(i),(i,j)")
def principal_inertia(tensor: ArrayLike) -> PrincipalInertia:
    """Principal moments and principal axes of an inertia tensor: T = A^T diag(I_1, I_2, I_3) A.

    Parameters
    ----------
    tensor
        Inertia tensor, kg m^2; shape (..., 3, 3).

    Returns
    -------
    PrincipalInertia
        Moments in ascending order, and right-handed axes.

    Raises
    ------
    ValueError
        If the tensor is not symmetric.

    Notes
    -----
    The axes are those of LAPACK, the third turned so that they are right-handed; where moments coincide every
    orthonormal choice is right, and one is returned.

    Examples
    --------
    >>> moments, axes = principal_inertia([[3, 1, 0], [1, 3, 0], [0, 0, 5]])
    >>> moments.round(12).tolist()
    [2.0, 4.0, 5.0]
    """
    return PrincipalInertia(*eigensystem(symmetric_matrix("tensor", tensor, "mirer2009:1.2.1")))


@gufunc("(k),(k,i)->(i,column)", column=3)
def inertia_tensor(moments: ArrayLike, axes: Orientation) -> Array:
    """The inertia tensor A^T diag(I_1, I_2, I_3) A: the inverse of `principal_inertia`.

    Parameters
    ----------
    moments
        Principal moments of inertia, kg m^2; shape (..., 3).
    axes
        Principal axes as rows; shape (..., 3, 3).

    Returns
    -------
    ndarray
        Shape (..., 3, 3), kg m^2.

    Raises
    ------
    ValueError
        If a moment is not positive or the axes are not orthonormal.

    Examples
    --------
    >>> inertia_tensor([2, 3, 4], [[0, 1, 0], [-1, 0, 0], [0, 0, 1]]).diagonal().tolist()
    [3.0, 2.0, 4.0]
    """
    axes = orthonormal_axes(axes)
    return symmetric_matrix("tensor", axes.swapaxes(-1, -2) @ (principal_moments(moments)[..., None] * axes))


@gufunc("(i)->(i)")
def triangle_slack(moments: ArrayLike) -> Array:
    """By how much the triangle inequalities (2.3) hold: I_1 + I_2 + I_3 - 2 I_i.

    Parameters
    ----------
    moments
        Principal moments of inertia, kg m^2; shape (..., 3).

    Returns
    -------
    ndarray
        Shape (..., 3), kg m^2: negative where no distribution of mass has these moments, zero for i where all mass lies
        in the plane across axis i.

    Notes
    -----
    Source: mirer2009:2.3.

    Examples
    --------
    >>> triangle_slack([1, 2, 4]).tolist()
    [5.0, 3.0, -1.0]
    """
    return slack_of(real("moments", moments, (3,)))


@gufunc("(i)->(i)")
def second_moments_of_mass(moments: ArrayLike) -> Array:
    """The integrals P_i of x_i^2 over the mass from I_1 = P_2 + P_3 and cyclic.

    Parameters
    ----------
    moments
        Principal moments of inertia, kg m^2; shape (..., 3). One may be 0, as for a rod.

    Returns
    -------
    ndarray
        Shape (..., 3), kg m^2.

    Raises
    ------
    ValueError
        If the triangle inequalities (2.3) fail by more than the rounding of the moments.

    Examples
    --------
    >>> second_moments_of_mass([3, 4, 5]).tolist()
    [3.0, 2.0, 1.0]
    """
    return np.maximum(moments_of_a_mass(moments)[1], 0) / 2


@gufunc("(k),(i,k)->(i)")
def axial_moments(moments: ArrayLike, axes: Orientation) -> Array:
    """Moments of inertia about three axes: J_i = I_1 a_i1^2 + I_2 a_i2^2 + I_3 a_i3^2.

    Parameters
    ----------
    moments
        Principal moments of inertia, kg m^2; shape (..., 3).
    axes
        Orthonormal axes as rows; shape (..., 3, 3).

    Returns
    -------
    ndarray
        Moments J_i, kg m^2; shape (..., 3).

    Raises
    ------
    ValueError
        If a moment is not positive or the axes are not orthonormal.

    Notes
    -----
    Source: mirer2009:2.0.4.

    Examples
    --------
    >>> axial_moments([2, 3, 4], [[0.6, 0.8, 0], [-0.8, 0.6, 0], [0, 0, 1]]).round(12).tolist()
    [2.64, 2.36, 4.0]
    """
    return stacked(mirer2009.axial_moments(*_arguments(moments, axes)))


@gufunc("(k),(i,k)->(i)")
def second_order_moments(moments: ArrayLike, axes: Orientation) -> Array:
    """The forms L_i = I_2 I_3 a_i1^2 + I_3 I_1 a_i2^2 + I_1 I_2 a_i3^2.

    Parameters
    ----------
    moments, axes
        As for `axial_moments`.

    Returns
    -------
    ndarray
        Forms L_i, kg^2 m^4; shape (..., 3).

    Raises
    ------
    ValueError
        If a moment is not positive or the axes are not orthonormal.

    Notes
    -----
    Source: mirer2009:2.19.

    Examples
    --------
    >>> second_order_moments([2, 3, 4], np.eye(3)).tolist()
    [12.0, 8.0, 6.0]
    """
    return stacked(mirer2009.second_order_moments(*_arguments(moments, axes)))


@gufunc("(k),(i,k)->(),(),(),(),()")
def product_of_axial_moments(moments: ArrayLike, axes: Orientation) -> BoundedProduct:
    """The product f = J_1 J_2 J_3 with I_1 I_2 I_3 <= f <= ((I_1 + I_2 + I_3)/3)^3 and both distances.

    Parameters
    ----------
    moments, axes
        As for `axial_moments`.

    Returns
    -------
    BoundedProduct
        The product, its bounds, and its distances from them.

    Raises
    ------
    ValueError
        If a moment is not positive or the axes are not orthonormal.

    Notes
    -----
    Excess and deficit are sums of squares with positive factors: never negative, and exact to rounding even where f
    comes close to a bound. Source: mirer2009:2.1.

    Examples
    --------
    >>> f = product_of_axial_moments([2, 3, 4], [[0.6, 0.8, 0], [-0.8, 0.6, 0], [0, 0, 1]])
    >>> np.round(f, 10).tolist()
    [24.9216, 24.0, 27.0, 0.9216, 2.0784]
    """
    arguments = _arguments(moments, axes)
    excess, deficit, _ = mirer2009.distances_from_bounds(*arguments)
    least, greatest, _ = mirer2009.bounds_of_products(*arguments[:3])
    return BoundedProduct(*results(mirer2009.product_of_axial_moments(*arguments), least, greatest, excess, deficit))


@gufunc("(k),(i,k)->(),(),()")
def sum_of_products(moments: ArrayLike, axes: Orientation) -> BoundedSum:
    """The sum S = J_1 L_1 + J_2 L_2 + J_3 L_3 with S >= 3 I_1 I_2 I_3 and the distance from this bound.

    Parameters
    ----------
    moments, axes
        As for `axial_moments`.

    Returns
    -------
    BoundedSum
        The sum, its bound, and its distance from it.

    Raises
    ------
    ValueError
        If a moment is not positive or the axes are not orthonormal.

    Notes
    -----
    Source: mirer2009:2.18.

    Examples
    --------
    >>> s = sum_of_products([2, 3, 4], [[0.6, 0.8, 0], [-0.8, 0.6, 0], [0, 0, 1]])
    >>> np.round(s, 10).tolist()
    [73.8432, 72.0, 1.8432]
    """
    arguments = _arguments(moments, axes)
    *_, excess = mirer2009.distances_from_bounds(*arguments)
    *_, least = mirer2009.bounds_of_products(*arguments[:3])
    return BoundedSum(*results(mirer2009.sum_of_products(*arguments), least, excess))


@gufunc("(k),()->()")
def bound_at_given_moment(moments: ArrayLike, moment: ArrayLike) -> Array:
    """The greatest product J_1 J_2 J_3 for a given J_2: f_1 = J_2 (3c - J_2)^2/4.

    Parameters
    ----------
    moments
        Principal moments of inertia, kg m^2; shape (..., 3). Their mean is c.
    moment
        Moment J_2, kg m^2; shape (...).

    Returns
    -------
    ndarray
        Shape (...), kg^3 m^6.

    Raises
    ------
    ValueError
        If a moment is not positive, the triangle inequalities (2.3) fail, or J_2 is outside [0, 3c/2].

    Notes
    -----
    Source: mirer2009:2.2.2.

    Examples
    --------
    >>> bound_at_given_moment([2, 3, 4], [0, 3, 4.5]).tolist()
    [0.0, 27.0, 22.78125]
    """
    moments, moment = principal_moments(moments), real("moment", moment)
    moments_of_a_mass(moments)
    trace = moments.sum(axis=-1)
    holds = (moment >= 0) & (2 * moment <= trace * (1 + ROUNDING))
    require(holds, "moment", moment, "lie on [0, 3c/2] with c the mean principal moment", "mirer2009:2.3.4")
    first, second, third = letters(moments)
    return np.asarray(mirer2009.bound_at_given_moment(first, second, third, moment))


def _arguments(moments: ArrayLike, axes: Orientation) -> list[Array]:
    """I_1, I_2, I_3, a_11, ..., a_33."""
    return [*letters(principal_moments(moments)), *letters(orthonormal_axes(axes), axes=2)]
