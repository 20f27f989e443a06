"""The half-spaces of momentum envelopes, of any number of sets of wheels at once.

Decision: a half-space is written for every pair of axes, whether its face is an ordinary rhombus or shared by several
pairs. Reason: the shape of the result then depends on the number of wheels alone, so that a million sets are one array
operation, and no tolerance decides anything. What merges faces is `envelope`, for one set at a time.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from itertools import combinations
from math import comb
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import (
    TOLERANCE,
    Array,
    doubles,
    engine_module,
    one_of,
    require,
    rows_of,
    unit_axes,
    whole,
)
from symcheck.numeric.wheels.sets import SOURCE, Wheels, wheels_along, wheels_of

PARALLEL = 1e-12  # sine of an angle below which two axes are one
ENGINES = ("numpy", "numba")
SPANS = "span space, or have complete=True"
BLOCK = 8192  # numbers in a register: 64 kB stay in the cache


class HalfSpaces(NamedTuple):
    """The polytope |n_j . (H - c)| <= d_j, symmetric about c.

    Parameters
    ----------
    normals
        Unit vectors n_j; shape (..., p, 3).
    distances
        Distances d_j from the centre; shape (..., p). Where two axes are parallel the distance is infinite and the
        normal 0.
    centre
        Centre c; shape (..., 3).
    """

    normals: Array
    distances: Array
    centre: Array


class Failures(NamedTuple):
    """What is left when some wheels have failed.

    Parameters
    ----------
    wheels
        The k wheels that have failed, counted from 0, in each of the f cases; shape (f, k).
    half_spaces
        Half-spaces of every case: normals (..., f, p, 3), distances (..., f, p), centre (..., f, 3).
    """

    wheels: NDArray[np.intp]
    half_spaces: HalfSpaces


def _number_of_pairs(size: Mapping[str, int]) -> int:
    return comb(size["n"] + 3 * bool(size.get("complete")), 2)


def pairs_when_complete(size: Mapping[str, int]) -> int:
    """How many pairs n axes make with the three coordinate axes that complete them."""
    return comb(size["n"] + 3, 2)


@gufunc("(n,axis),(n),(n)->(pair,axis),(pair),(axis)", pair=_number_of_pairs)
def half_spaces(
    axes: ArrayLike,
    limits: ArrayLike = 1.0,
    bias: ArrayLike = 0.0,
    *,
    complete: bool = False,
    engine: str = "numpy",
) -> HalfSpaces:
    """The half-spaces of the momentum envelope: n = e_i x e_j/|e_i x e_j| and d = sum_k h_k |n . e_k|, i < j.

    Parameters
    ----------
    axes
        Unit vectors e_i that span space; shape (..., n, 3).
    limits
        Largest momenta h_i, N m s; a number or shape (..., n). A wheel that has failed has 0.
    bias
        Momenta b_i about which the wheels work, N m s; a number or shape (..., n).
    complete
        True adds the three coordinate axes with the limit 0, so that axes that do not span space (one wheel, or all in
        a plane) are described too: as a polygon or a segment, with the distance 0 across it.
    engine
        "numpy", or "numba" (needs Numba), which gives the same to rounding, faster, and compiles at its first use.

    Returns
    -------
    HalfSpaces
        Normals (..., p, 3), distances (..., p) with p = n(n - 1)/2, centre (..., 3).

    Raises
    ------
    ValueError
        If axes do not span space and are not completed.

    Notes
    -----
    Each half-space is exact to rounding whatever the axes are, as d is computed with the normal that is returned; axes
    at an angle below 1e-12 count as parallel. The time grows with n^3: for more than some hundred wheels in one set use
    `envelope`. Source: tables 3, 5, 8, 11.

    Examples
    --------
    >>> half_spaces(np.eye(3), [1, 2, 3]).distances
    array([3., 2., 1.])
    """
    wheels = _wheels(engine, axes, limits, bias)
    wheels = _completed(wheels) if complete else wheels
    normals, distances = _half_planes(wheels, True, engine)
    shape = (*wheels.limits.shape[:-1], distances.shape[1])
    return HalfSpaces(normals.transpose(0, 2, 1).reshape(*shape, 3), distances.reshape(shape), wheels.centre)


@gufunc("(n,axis),(n)->(pair)", pair=_number_of_pairs)
def face_distances(axes: ArrayLike, limits: ArrayLike = 1.0, *, engine: str = "numpy") -> Array:
    """The distances of `half_spaces` alone, d = sum_k h_k |(e_i, e_j, e_k)|/|e_i x e_j|, in less memory.

    Parameters
    ----------
    axes, limits, engine
        As for `half_spaces`.

    Returns
    -------
    ndarray
        Distances from the centre, N m s, of the pairs (1, 2), (1, 3), ..., (2, 3), ...; shape (..., p), p = n(n - 1)/2.
        The least is the radius of the largest ball in the envelope.

    Raises
    ------
    ValueError
        If the axes do not span space.

    Notes
    -----
    Source: tables 3, 5, 8, 11; the paper's configurations have the kernels `face_distances_of_four_wheels` and others.

    Examples
    --------
    >>> from symcheck.numeric.wheels import six_wheels
    >>> face_distances(six_wheels(np.arctan(3))).min().round(6)
    np.float64(1.77073)
    """
    wheels = _wheels(engine, axes, limits)
    _, distances = _half_planes(wheels, False, engine)
    return distances.reshape(*wheels.limits.shape[:-1], distances.shape[1])


def _wheels(engine: str, axes: ArrayLike, limits: ArrayLike, bias: ArrayLike = 0.0) -> Wheels:
    """As `wheels_of`; what is compiled looks at the lengths of the axes as it reads them."""
    if engine == "numba":
        return wheels_along(doubles("axes", rows_of(axes), (None, 3)), limits, bias)
    return wheels_of(axes, limits, bias)


def _completed(wheels: Wheels) -> Wheels:
    lead = wheels.limits.shape[:-1]
    zero = np.zeros((*lead, 3))
    return Wheels(
        np.concatenate([wheels.axes, np.broadcast_to(np.eye(3), (*lead, 3, 3))], axis=-2),
        np.concatenate([wheels.limits, zero], axis=-1),
        np.concatenate([wheels.bias, zero], axis=-1),
    )


@lru_cache
def _operands(count: int) -> NDArray[np.intp]:
    """Which numbers of a set's axes, in a row, give e_i x e_j = u v - w z: u and w, v and z, (2, 2, 3, p)."""
    first, second = (3 * index for index in np.triu_indices(count, 1))
    after, before = np.array([[[1], [2], [0]], [[2], [0], [1]]])
    return np.array([[first + after, first + before], [second + before, second + after]])


def _half_planes(wheels: Wheels, keep: bool, engine: str) -> tuple[Array, Array]:
    """Normals (m, 3, p), or less if they are not kept, and distances (m, p) of all m sets."""
    if engine not in ENGINES:
        one_of("engine", engine, ENGINES)
    count = wheels.limits.shape[-1]
    if count < 3:
        unit_axes(wheels.axes, SOURCE)
        require(False, "axes", wheels.axes, SPANS, SOURCE)
    axes, limits = wheels.axes.reshape(-1, count, 3), wheels.limits.reshape(-1, count)
    if engine == "numba":
        run = engine_module(engine, "symcheck.numeric.wheels.numba_engine").of_pairs
        normals, distances, spans, of_unit_length = run(axes, limits, keep, PARALLEL, TOLERANCE)
        if not of_unit_length:
            unit_axes(wheels.axes, SOURCE)
    else:
        normals, distances, spans = of_pairs(axes, limits, keep, PARALLEL)
    if np.count_nonzero(spans) < len(spans):
        spans[~spans] = _span(axes[~spans])
        require(spans.reshape(wheels.limits.shape[:-1]), "axes", wheels.axes, SPANS, SOURCE)
    return normals, distances


def of_pairs(axes: Array, limits: Array, keep: bool, parallel: float) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Normals (m, 3, p), of one block if they are not kept, distances (m, p), and whether pair (1, 2) spans space."""
    sets, count, _ = axes.shape
    pairs = comb(count, 2)
    step = max(1, BLOCK // pairs)
    if sets <= step:
        return _of_block(axes, limits, parallel)
    normals, distances = np.empty((sets if keep else step, 3, pairs)), np.empty((sets, pairs))
    spans = np.empty(sets, bool)
    operands, heights = np.empty((2, 2, 3, pairs, step)), np.empty((step, count, pairs))
    for start in range(0, sets, step):
        part = slice(start, start + step)
        size = min(step, sets - start)
        registers = operands[..., :size], normals[part] if keep else normals[:size], heights[:size]
        _, distances[part], spans[part] = _of_block(axes[part], limits[part], parallel, *registers)
    return normals, distances, spans


def _of_block(
    axes: Array,
    limits: Array,
    parallel: float,
    operands: Array | None = None,
    normals: Array | None = None,
    heights: Array | None = None,
) -> tuple[Array, Array, NDArray[np.bool_]]:
    """What `of_pairs` returns, of sets whose numbers stay in the cache; registers for the larger arrays may be given.

    In the cross products the sets come last, so that every operation runs along memory.
    """
    sets, count, _ = axes.shape
    rows = axes.reshape(sets, 3 * count).T
    left, right = rows.take(_operands(count), axis=0, out=operands, mode="clip")  # clip: else through a copy
    cross, less = np.multiply(left, right, left)
    np.subtract(cross, less, cross)
    length, second, third = np.multiply(cross, cross, less)
    np.add(length, second, length)
    np.add(length, third, length)
    np.sqrt(length, length)
    some = length.min(initial=np.inf) <= parallel
    if some:
        same = length <= parallel
        length[same] = np.inf
    np.divide(cross, length, cross)
    if normals is None:
        normals = np.ascontiguousarray(cross.transpose(2, 0, 1))
    else:
        np.copyto(normals, cross.transpose(2, 0, 1))
    heights = np.matmul(axes, normals, heights)
    np.abs(heights, heights)
    distances = np.matmul(limits[:, None], heights)[:, 0]
    if some:
        distances[same.T] = np.inf
    highest = np.ascontiguousarray(heights[..., 0].T).max(axis=0)  # T: rows as short as these would take longer
    return normals, distances, highest > parallel


def _span(axes: Array) -> NDArray[np.bool_]:
    """Whether the axes (m, n, 3) of each set span space."""
    if axes.shape[1] < 3:
        return np.zeros(len(axes), bool)
    return np.asarray(np.linalg.svd(axes, compute_uv=False)[:, 2] > PARALLEL)


def failures(axes: ArrayLike, limits: ArrayLike = 1.0, bias: ArrayLike = 0.0, *, count: int = 1) -> Failures:
    """The envelopes that are left after every failure of `count` wheels at once.

    A wheel that has failed has the momentum 0; its limit and bias become 0. What is left is described exactly, also
    where it is flat.

    Parameters
    ----------
    axes, limits, bias
        As for `half_spaces`.
    count
        Number of wheels that fail at once, from 0 to n.

    Returns
    -------
    Failures
        The C(n, count) cases in lexicographic order, as the axis before the last.

    Raises
    ------
    ValueError
        If the count is not an integer from 0 to n.

    Notes
    -----
    Source: sections 2.2 and 3.2.

    Examples
    --------
    >>> failures(np.eye(3), count=2).half_spaces.distances
    array([[1., 0., 0.],
           [0., 1., 0.],
           [0., 0., 1.]])
    """
    wheels = wheels_of(axes, limits, bias)
    number = wheels.limits.shape[-1]
    cases = np.array(list(combinations(range(number), whole("count", count, 0, number))), np.intp)
    works = np.ones((len(cases), number))
    np.put_along_axis(works, cases, 0, axis=1)
    left = (wheels.axes[..., None, :, :], works * wheels.limits[..., None, :], works * wheels.bias[..., None, :])
    return Failures(cases, half_spaces(*left))
