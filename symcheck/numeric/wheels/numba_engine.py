"""The half-spaces of many sets of wheels, compiled by Numba: the formulas of `faces`, set by set."""

from __future__ import annotations

from collections.abc import Callable
from math import inf, sqrt
from typing import ParamSpec, TypeVar, cast

import numba
import numpy as np
from numpy.typing import NDArray

from symcheck.numeric.domain import Array

P = ParamSpec("P")
T = TypeVar("T")


def compiled(function: Callable[P, T]) -> Callable[P, T]:
    """Compiled without the interpreter's lock; kept for the next process."""
    return cast(Callable[P, T], numba.njit(nogil=True, cache=True, error_model="numpy")(function))


def of_pairs(axes: Array, limits: Array, keep: bool, parallel: float) -> tuple[Array, Array, NDArray[np.bool_]]:
    """What the function of this name in `faces` returns."""
    sets, count, _ = axes.shape
    pairs = count * (count - 1) // 2
    normals, distances = np.empty((sets if keep else 1, 3, pairs)), np.empty((sets, pairs))
    spans = np.zeros(sets, np.bool_)
    _fill(np.ascontiguousarray(axes), np.ascontiguousarray(limits), parallel, normals, distances, spans)
    return normals, distances, spans


@compiled
def _fill(
    axes: Array, limits: Array, parallel: float, normals: Array, distances: Array, spans: NDArray[np.bool_]
) -> None:
    count = axes.shape[1]
    for s in range(len(axes)):
        normal, pair = normals[s % len(normals)], 0
        for i in range(count):
            for j in range(i + 1, count):
                x = axes[s, i, 1] * axes[s, j, 2] - axes[s, i, 2] * axes[s, j, 1]
                y = axes[s, i, 2] * axes[s, j, 0] - axes[s, i, 0] * axes[s, j, 2]
                z = axes[s, i, 0] * axes[s, j, 1] - axes[s, i, 1] * axes[s, j, 0]
                length = sqrt(x * x + y * y + z * z)
                apart = length > parallel
                scale = 1 / length if apart else 0.0
                x, y, z = x * scale, y * scale, z * scale
                distance = 0.0 if apart else inf
                for k in range(count):
                    height = abs(x * axes[s, k, 0] + y * axes[s, k, 1] + z * axes[s, k, 2])
                    spans[s] |= height > parallel
                    distance += limits[s, k] * height
                normal[0, pair], normal[1, pair], normal[2, pair], distances[s, pair] = x, y, z, distance
                pair += 1
