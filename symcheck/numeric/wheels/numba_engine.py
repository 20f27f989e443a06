"""The half-spaces of many sets of wheels, compiled by Numba: the formulas of `faces`, set by set."""

from __future__ import annotations

from math import comb, inf, sqrt

import numpy as np
from numpy.typing import NDArray

from symcheck.numeric.compiled import compiled
from symcheck.numeric.domain import Array

LANES = 8  # the pairs of a set are filled up to a multiple of these, so that loops are all vector instructions


def of_pairs(
    axes: Array, limits: Array, keep: bool, parallel: float, tolerance: float
) -> tuple[Array, Array, NDArray[np.bool_], bool]:
    """What the function of this name in `faces` returns, and whether all axes have the length 1, to a tolerance."""
    sets, count, _ = axes.shape
    pairs = comb(count, 2)
    normals, distances = np.empty((sets if keep else 0, 3, pairs)), np.empty((sets, pairs))
    spans = np.empty(sets, np.bool_)
    if sets and not limits.strides[0]:  # limits that all sets share are not copied for each
        limits = limits[:1]
    axes, limits = np.ascontiguousarray(axes), np.ascontiguousarray(limits)
    return normals, distances, spans, _fill(axes, limits, parallel, tolerance, normals, distances, spans)


@compiled
def _fill(
    axes: Array,
    limits: Array,
    parallel: float,
    tolerance: float,
    normals: Array,
    distances: Array,
    spans: NDArray[np.bool_],
) -> bool:
    shared, keep, unit = len(limits) == 1, len(normals) == len(axes), True
    pairs = distances.shape[1]
    filled = -(-pairs // LANES) * LANES
    x, y, z, d = np.zeros(filled), np.zeros(filled), np.zeros(filled), np.zeros(filled)
    for s in range(len(axes)):
        _cross(axes, s, x, y, z)
        _normalise(x, y, z, d, parallel)
        highest, of_unit_length = _add(axes, limits[0 if shared else s], s, x, y, z, d, tolerance)
        spans[s], unit = highest > parallel, unit & of_unit_length
        for p in range(pairs):
            distances[s, p] = d[p]
        if keep:
            for p in range(pairs):
                normals[s, 0, p], normals[s, 1, p], normals[s, 2, p] = x[p], y[p], z[p]
    return unit


@compiled
def _cross(axes: Array, s: int, x: Array, y: Array, z: Array) -> None:
    pair = 0
    for i in range(axes.shape[1]):
        u, v, w = axes[s, i, 0], axes[s, i, 1], axes[s, i, 2]  # read once, as what is written may be it
        for j in range(i + 1, axes.shape[1]):
            x[pair] = v * axes[s, j, 2] - w * axes[s, j, 1]
            y[pair] = w * axes[s, j, 0] - u * axes[s, j, 2]
            z[pair] = u * axes[s, j, 1] - v * axes[s, j, 0]
            pair += 1


@compiled
def _normalise(x: Array, y: Array, z: Array, d: Array, parallel: float) -> None:
    """Normals of unit length and the distance 0; the normal 0 and the distance infinity for a parallel pair."""
    for p in range(len(x)):
        length = sqrt(x[p] * x[p] + y[p] * y[p] + z[p] * z[p])
        apart = length > parallel
        scale = 1 / length if apart else 0.0
        x[p], y[p], z[p], d[p] = x[p] * scale, y[p] * scale, z[p] * scale, 0.0 if apart else inf


@compiled
def _add(
    axes: Array, limits: Array, s: int, x: Array, y: Array, z: Array, d: Array, tolerance: float
) -> tuple[float, bool]:
    """Add every wheel's part to the distances d.

    How high the highest axis stands over the plane of pair (1, 2), and whether all axes have the length 1.
    """
    highest, unit = 0.0, True
    for k in range(axes.shape[1]):
        u, v, w, limit = axes[s, k, 0], axes[s, k, 1], axes[s, k, 2], limits[k]
        highest = max(highest, abs(x[0] * u + y[0] * v + z[0] * w))
        unit &= abs(u * u + v * v + w * w - 1) <= tolerance
        for p in range(len(x)):
            d[p] += limit * abs(x[p] * u + y[p] * v + z[p] * w)
    return highest, unit
