"""How the wheels share a demanded momentum.

Decision: the least greatest load is found in the geometry, not by linear programming. Reason: the load is how far the
demand is out towards its face, the wheels outside the face's plane are all at that load, and those in the plane share
what is left in the same way; this is exact, takes many demands at once, and loads the others as little as can be too,
where a linear program stops at any solution. It is not for: hundreds of wheels, whose pairs are all looked at.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import Array, momentum, require
from symcheck.numeric.wheels.faces import half_spaces
from symcheck.numeric.wheels.planes import Index, missing
from symcheck.numeric.wheels.sets import Wheels, wheels_of

IN_PLANE = 1e-9  # sine of an angle below which an axis lies in a plane
BLOCK = 1 << 20  # products of demands and normals at once
SLIGHT = 1e-6  # weight of the loads against the missing momentum: 1e-12 of its square


class Allocation(NamedTuple):
    """Momenta of the wheels.

    Parameters
    ----------
    momenta
        Momenta h_i, N m s; shape (..., n).
    load
        Greatest |h_i - b_i|/h_i,max; shape (...).
    """

    momenta: Array
    load: Array


@gufunc("(n,axis),(axis),(n),(n)->(n),()")
def allocate(axes: ArrayLike, demand: ArrayLike, limits: ArrayLike = 1.0, bias: ArrayLike = 0.0) -> Allocation:
    """The momenta with h_1 e_1 + ... + h_n e_n = H whose greatest load max_i |h_i - b_i|/h_i,max is least.

    Parameters
    ----------
    axes
        Unit vectors e_i; shape (n, 3).
    demand
        Demanded momentum H, N m s; shape (..., 3).
    limits
        Largest momenta h_i,max, N m s; a number or shape (n,). A wheel with 0 does not take part.
    bias
        Momenta b_i about which the wheels work, N m s; a number or shape (n,).

    Returns
    -------
    Allocation
        Momenta and load. The load is at most 1 exactly if H is in the envelope; the momenta of a greater load are the
        best ones too, but no wheel has them.

    Raises
    ------
    ValueError
        If no momenta give H: the axes lie in a plane and H does not.

    Notes
    -----
    Of all best momenta those are returned whose other loads are least in turn. Source: (2.1), condition (1.1).

    Examples
    --------
    >>> allocate(np.eye(3), [0.5, -2, 0])
    Allocation(momenta=array([ 0.5, -2. ,  0. ]), load=array(2.))
    """
    wheels, offset = _one_set(axes, demand, limits, bias)
    works = wheels.limits > 0
    momenta = np.zeros((*offset.shape[:-1], len(works)))
    shared = _shared(wheels.axes[works], wheels.limits[works], offset.reshape(-1, 3))
    momenta[..., works] = shared.reshape(*offset.shape[:-1], shared.shape[1])
    gap = np.abs(momenta @ wheels.axes - offset).max(axis=-1)
    reached = gap <= IN_PLANE * np.abs(offset).max(axis=-1)
    require(
        reached, "demand", offset + wheels.centre, "lie in the plane or line of the axes of wheels that work", "(2.1)"
    )
    return Allocation(momenta + wheels.bias, _load(momenta, wheels.limits))


@gufunc("(n,axis),(axis),(n),(n)->(n),()")
def allocate_least_squares(
    axes: ArrayLike, demand: ArrayLike, limits: ArrayLike = 1.0, bias: ArrayLike = 0.0
) -> Allocation:
    """The momenta within their limits that come nearest to H; of these the ones with the least sum of squared loads.

        |h_1 e_1 + ... + h_n e_n - H|^2 + 1e-12 h^2 sum_i ((h_i - b_i)/h_i,max)^2 is least, h the greatest limit

    H outside the envelope is replaced by the nearest momentum that the wheels have.

    Parameters
    ----------
    axes, demand, limits, bias
        As for `allocate`.

    Returns
    -------
    Allocation
        Momenta and load, at most 1 but for rounding.

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.

    Notes
    -----
    One demand at a time (`scipy.optimize.lsq_linear`), some 0.1 ms each, to 1e-9 of the limits. Source: (2.1),
    condition (1.1).

    Examples
    --------
    >>> allocate_least_squares(np.eye(3), [0.5, -2, 0]).momenta.round(6)
    array([ 0.5, -1. ,  0. ])
    """
    wheels, offset = _one_set(axes, demand, limits, bias)
    works = wheels.limits > 0
    momenta = np.zeros((*offset.shape[:-1], len(works)))
    if works.any():
        nearest = [_nearest(wheels.axes[works], wheels.limits[works], target) for target in offset.reshape(-1, 3)]
        momenta[..., works] = np.reshape(nearest, (*offset.shape[:-1], np.count_nonzero(works)))
    return Allocation(momenta + wheels.bias, _load(momenta, wheels.limits))


def _one_set(axes: ArrayLike, demand: ArrayLike, limits: ArrayLike, bias: ArrayLike) -> tuple[Wheels, Array]:
    """The wheels, and the demand less what their biases give."""
    wheels = wheels_of(axes, limits, bias)
    require(wheels.limits.ndim == 1, "axes", wheels.axes.shape, "be one set of wheels, of the shape (n, 3)", "(2.1)")
    return wheels, momentum("demand", demand, (3,)) - wheels.centre


def _load(momenta: Array, limits: Array) -> Array:
    loads = np.divide(np.abs(momenta), limits, where=limits > 0, out=np.zeros_like(momenta))
    return np.asarray(loads.max(axis=-1))


def _shared(axes: Array, limits: Array, demand: Array) -> Array:
    """The momenta (m, n) for demands (m, 3) in the span of the axes (n, 3), all with limits."""
    momenta = np.zeros((len(demand), len(axes)))
    if not len(axes):
        return momenta
    _, across = missing(axes, IN_PLANE)
    normals = half_spaces(np.vstack([axes, across]), np.append(limits, np.zeros(len(across)))).normals
    heights = np.abs(normals @ axes.T)
    heights[heights <= IN_PLANE] = 0  # of an axis in the plane; else a limit 1e10 times the others makes much of it
    distances = heights @ limits
    normals, distances = normals[distances > 0], distances[distances > 0]
    for rows, face, load in _towards(normals, distances, demand):
        height = axes @ normals[face]
        out = np.abs(height) > IN_PLANE
        most = np.abs(load)[:, None] * limits
        momenta[np.ix_(rows, out)] = np.copysign(most[:, out], load[:, None] * height[out])
        rest = demand[rows] - momenta[np.ix_(rows, out)] @ axes[out]
        others = _shared(
            axes[~out], limits[~out], rest
        )  # have what rounding leaves of the great ones in the plane, too
        momenta[np.ix_(rows, ~out)] = np.clip(others, -most[:, ~out], most[:, ~out])
    return momenta


def _towards(normals: Array, distances: Array, demand: Array) -> Iterator[tuple[Index, int, Array]]:
    """The demands (their numbers) towards each face, the face, and n . H/d with its sign."""
    step = max(1, BLOCK // len(distances))
    for start in range(0, len(demand), step):
        loads = demand[start : start + step] @ normals.T / distances
        nearest = np.abs(loads).argmax(axis=1)
        for face in np.unique(nearest):
            rows = np.flatnonzero(nearest == face)
            yield rows + start, int(face), loads[rows, face]


def _nearest(axes: Array, limits: Array, demand: Array) -> Array:
    from scipy.optimize import lsq_linear

    scale = limits.max()
    matrix = np.vstack([axes.T * limits / scale, SLIGHT * np.eye(len(limits))])
    target = np.append(demand / scale, np.zeros(len(limits)))
    return np.asarray(lsq_linear(matrix, target, (-1, 1), method="bvls", tol=1e-15).x * limits)
