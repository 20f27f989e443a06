"""The half-spaces of many sets of wheels, compiled by Numba: the formulas of `faces`, set by set."""

from __future__ import annotations

from math import comb, inf, sqrt

import numpy as np
from numpy.typing import NDArray

from symcheck.numeric.compiled import compiled
from symcheck.numeric.domain import Array

LANES = 8  # the pairs of a set are filled up to a multiple of these, so that loops are all vector instructions


def of_pairs(axes: Array, limits: Array, keep: bool, parallel: float) -> tuple[Array, Array, NDArray[np.bool_]]:
    """What the function of this name in `faces` returns."""
    sets, count, _ = axes.shape
    pairs = comb(count, 2)
    normals, distances = np.empty((sets if keep else 1, 3, pairs)), np.empty((sets, pairs))
    spans = np.empty(sets, np.bool_)
    _fill(np.ascontiguousarray(axes), np.ascontiguousarray(limits), parallel, normals, distances, spans)
    return normals, distances, spans


@compiled
def _fill(
    axes: Array, limits: Array, parallel: float, normals: Array, distances: Array, spans: NDArray[np.bool_]
) -> None:
    pairs = distances.shape[1]
    filled = -(-pairs // LANES) * LANES
    x, y, z, d = np.zeros(filled), np.zeros(filled), np.zeros(filled), np.zeros(filled)
    for s in range(len(axes)):
        _cross(axes, s, x, y, z)
        _normalise(x, y, z, d, parallel)
        spans[s] = _add(axes, limits, s, x, y, z, d) > parallel
        row = s % len(normals)
        for p in range(pairs):
            normals[row, 0, p], normals[row, 1, p], normals[row, 2, p], distances[s, p] = x[p], y[p], z[p], d[p]


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
def _add(axes: Array, limits: Array, s: int, x: Array, y: Array, z: Array, d: Array) -> float:
    """Add every wheel's part to the distances d; how high the highest axis stands over the plane of pair (1, 2)."""
    highest = 0.0
    for k in range(axes.shape[1]):
        u, v, w, limit = axes[s, k, 0], axes[s, k, 1], axes[s, k, 2], limits[s, k]
        highest = max(highest, abs(x[0] * u + y[0] * v + z[0] * w))
        for p in range(len(x)):
            d[p] += limit * abs(x[p] * u + y[p] * v + z[p] * w)
    return highest
