"""The angles at which wheels do most for a body with given moments of inertia.

The paper asks for equal largest rates about the principal axes (`equal_rates_...`). The greatest rate that is reached
about every axis, whatever its direction, is here in closed form or to rounding for the paper's two configurations
(`best_...`), and by a search for any other (`best_parameters`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import pi, sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from symcheck.generated import ignatov2005
from symcheck.numeric.arrays import letters
from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import Array, exact, principal_moments, require
from symcheck.numeric.wheels.faces import half_spaces
from symcheck.numeric.wheels.margins import guaranteed_rate
from symcheck.numeric.wheels.sets import four_wheels, six_wheels

WITH_Y = np.array([(1, 0, 2), (0, 1, 2), (0, 2, 1)])  # swaps OX, OY or OZ with OY
HALVINGS, AROUND = 64, 20.0  # of the interval for log tg^2 a, which goes so far beyond the faces' own optima


class Optimum(NamedTuple):
    """The best parameters of a configuration of wheels.

    Parameters
    ----------
    parameters
        Parameters of the configuration; shape (k,).
    rate
        Angular rate that it guarantees with them, rad/s.
    """

    parameters: Array
    rate: float


@gufunc("(k)->(angle)", angle=2)
def best_angles_of_four_wheels(moments: ArrayLike) -> Array:
    """The angles a, b of four wheels with the greatest rate that is reached about every axis.

    Parameters
    ----------
    moments
        Principal moments of inertia J_x, J_y, J_z, kg m^2; shape (..., 3).

    Returns
    -------
    ndarray
        Angles a and b, rad; shape (..., 2).

    Raises
    ------
    ValueError
        If a moment is not positive.

    Notes
    -----
    Where the squares of the moments satisfy the triangle inequalities the kernel `equal_rates_of_four_wheels` gives
    them, elsewhere `best_angles_of_four_wheels`, with the axis of the greatest moment in the place of OY. Source: B.16
    to B.21.

    Examples
    --------
    >>> np.degrees(best_angles_of_four_wheels([1000, 1600, 800])).round(2)
    array([65.38, 34.94])
    """
    inertia = principal_moments(moments)
    swap = WITH_Y[inertia.argmax(axis=-1)]
    x, y, z = (inertia[..., k] for k in range(3))
    swapped = np.take_along_axis(inertia, swap, axis=-1)
    best_a, best_b, *_ = ignatov2005.best_angles_of_four_wheels(*letters(swapped))
    ratios = np.take_along_axis(_components(best_a, best_b), swap, axis=-1)
    a, b = (
        np.arctan2(np.hypot(ratios[..., 0], ratios[..., 1]), ratios[..., 2]),
        np.arctan2(*np.moveaxis(ratios, -1, 0)[:2]),
    )
    equal_a, equal_b, *_ = ignatov2005.equal_rates_of_four_wheels(*letters(inertia))
    one_is_great = 2 * np.maximum(np.maximum(x, y), z) ** 2 >= x * x + y * y + z * z
    return np.stack([np.where(one_is_great, a, equal_a), np.where(one_is_great, b, equal_b)], axis=-1)


@gufunc("(k)->(angle)", angle=2)
def equal_rates_of_four_wheels(moments: ArrayLike) -> Array:
    """The angles a, b of four wheels with which the largest rates about OX, OY and OZ are equal: the paper's choice.

    Parameters
    ----------
    moments
        Principal moments of inertia J_x, J_y, J_z, kg m^2; shape (..., 3).

    Returns
    -------
    ndarray
        Angles a and b, rad; shape (..., 2).

    Raises
    ------
    ValueError
        If a moment is not positive.

    Notes
    -----
    From the kernel of this name. Source: section 2.3.

    Examples
    --------
    >>> np.degrees(equal_rates_of_four_wheels([1000, 1600, 800])).round(2)
    array([67.02, 32.01])
    """
    return np.stack(ignatov2005.equal_rates_of_four_wheels(*letters(principal_moments(moments)))[:2], axis=-1)


@gufunc("(k)->(angle)", angle=1)
def best_angle_of_six_wheels(moments: ArrayLike) -> Array:
    """The angle a of six wheels with the greatest rate that is reached about every axis.

    Parameters
    ----------
    moments
        Principal moments of inertia J_x, J_y, J_z, kg m^2; shape (..., 3).

    Returns
    -------
    ndarray
        Angle a to rounding, rad; shape (..., 1).

    Raises
    ------
    ValueError
        If a moment is not positive.

    Notes
    -----
    Each face allows the rate w with 1/w^2 = A (1 + 1/t) + B (1 + t), t = tg^2 a, where A and B come from its half-space
    at one angle; the greatest of these is convex in t, and its least value is found by halving an interval for log t.
    Where the face F_8 alone binds, the kernel `best_angle_of_six_wheels` has it in closed form. Source: B.38 to B.40.

    Examples
    --------
    >>> np.degrees(best_angle_of_six_wheels([1000, 1600, 800])).round(2)
    array([63.43])
    """
    inertia = principal_moments(moments)
    faces = half_spaces(six_wheels(pi / 4))  # there the components of all axes have the factor sqrt(1/2)
    weights = (faces.normals / (sqrt(2) * faces.distances[:, None])) ** 2
    across, along = inertia[..., :2] ** 2 @ weights[:, :2].T, inertia[..., 2:] ** 2 * weights[:, 2]
    own = np.log(np.sqrt(np.divide(across, along, where=along > 0, out=np.ones_like(across))))
    low, high = own.min(axis=-1) - AROUND, own.max(axis=-1) + AROUND
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        t = np.exp(middle)[..., None]
        binding = (across * (1 + 1 / t) + along * (1 + t)).argmax(axis=-1)[..., None]
        rises = (np.take_along_axis(along - across / t**2, binding, axis=-1) > 0)[..., 0]
        low, high = np.where(rises, low, middle), np.where(rises, middle, high)
    return np.asarray(np.arctan(np.exp((low + high) / 4))[..., None])


@gufunc("(k)->(angle)", angle=1)
def equal_rates_of_six_wheels(moments: ArrayLike) -> Array:
    """The angle a of six wheels with which the largest rates about OY and OZ are equal: the paper's choice.

    Parameters
    ----------
    moments
        Principal moments of inertia J_x, J_y, J_z, kg m^2; shape (..., 3).

    Returns
    -------
    ndarray
        Angle a, rad; shape (..., 1).

    Raises
    ------
    ValueError
        If a moment is not positive.

    Notes
    -----
    From the kernel of this name. Source: section 3.3.

    Examples
    --------
    >>> np.degrees(equal_rates_of_six_wheels([1000, 1600, 800])).round(2)
    array([71.57])
    """
    angle, *_ = ignatov2005.equal_rates_of_six_wheels(*letters(principal_moments(moments)))
    return np.asarray(angle)[..., None]


def best_parameters(
    configuration: Callable[..., Array],
    bounds: Sequence[tuple[float, float]],
    moments: ArrayLike,
    limits: ArrayLike = 1.0,
    *,
    seed: int = 2005,
) -> Optimum:
    """The parameters of any configuration of wheels with the greatest rate that is reached about every axis.

    Parameters
    ----------
    configuration
        Function of k arrays (...) that returns axes (..., n, 3), such as `four_wheels`.
    bounds
        Least and greatest value of each of the k parameters.
    moments
        Principal moments of inertia J_x, J_y, J_z, kg m^2; shape (3,).
    limits
        Largest momenta of the wheels, N m s; a number or shape (n,).
    seed
        Seed of the random search.

    Returns
    -------
    Optimum
        The parameters, and the rate that they guarantee.

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.

    Notes
    -----
    A global search (`scipy.optimize.differential_evolution`, whole generations at once), refined without derivatives:
    the rate has edges where the binding face changes. No proof that the maximum is global. Source: (1.1), (2.3).

    Examples
    --------
    >>> best_parameters(six_wheels, [(0.1, 1.5)], [1000, 1600, 800]).parameters.round(4)
    array([1.1071])
    """
    from scipy.optimize import differential_evolution, minimize

    ends, inertia = exact("bounds", bounds, (None, 2)), exact("moments", moments, (3,))
    require(ends[:, 0] < ends[:, 1], "bounds", ends, "begin below their end")

    def loss(parameters: Array) -> Array:
        return -guaranteed_rate(half_spaces(configuration(*parameters), limits, complete=True), inertia)

    scale = -float(loss(ends.mean(axis=1))) or 1.0
    searched = differential_evolution(
        lambda parameters: loss(parameters) / scale, ends, rng=seed, vectorized=True, updating="deferred", polish=False
    )
    options = {"xatol": 1e-10, "fatol": 1e-14}
    refined = minimize(lambda x: float(loss(x)) / scale, searched.x, method="Nelder-Mead", bounds=ends, options=options)
    return Optimum(refined.x, -float(loss(refined.x)))


def _components(a: Array, b: Array) -> Array:
    """sin a sin b, sin a cos b, cos a: those of the axes of four wheels but for signs."""
    return four_wheels(a, b)[..., 3, :]
