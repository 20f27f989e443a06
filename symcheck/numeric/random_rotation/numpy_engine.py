"""A step of the scheme in NumPy: in place, for so many paths at once that they stay in the cache.

A turn goes through the tangent of half the angle, one function of the angle instead of two:

    sin phi = s,   cos phi = 1 - t s,   with t = tan(phi/2), s = 2 t/(1 + t^2)
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from symcheck.numeric.domain import Array
from symcheck.numeric.random_rotation.scheme import Scheme

AHEAD = 8  # steps whose normal numbers are drawn at once


def advance(scheme: Scheme, state: Array, generators: Sequence[np.random.Generator], steps: int) -> None:
    """Advance the state, shape (3, streams, paths of each), in place; stream j takes its numbers from generator j."""
    x, numbers = state.reshape(3, -1), _numbers(state, steps)
    wide, narrow = [np.empty_like(state) for _ in range(3)], [np.empty(x.shape[1]) for _ in range(3)]
    with np.errstate(over="ignore", invalid="ignore"):  # paths that are not finite are reported at the end
        _rotate(x, scheme.half_angle / 2, *narrow)
        for done in range(steps):
            if done % AHEAD == 0:
                _draw(generators, numbers[:, : steps - done])
            _relax_and_kick(scheme, state, numbers[:, done % AHEAD].swapaxes(0, 1), *wide)
            _rotate(x, scheme.half_angle if done < steps - 1 else scheme.half_angle / 2, *narrow)


def _numbers(state: Array, steps: int) -> Array:
    axes, streams, lanes = state.shape
    return np.empty((streams, min(steps, AHEAD), axes, lanes))


def _draw(generators: Sequence[np.random.Generator], numbers: Array) -> None:
    for generator, row in zip(generators, numbers, strict=True):
        generator.standard_normal(out=row)


def _rotate(x: Array, half: float, t: Array, s: Array, u: Array) -> None:
    """R: (x_1, x_2) turns by the angle 2 half x_3."""
    x1, x2, x3 = x
    np.multiply(x3, half, t)
    np.tan(t, t)
    np.multiply(t, t, s)
    np.add(s, 1.0, s)
    np.divide(t, s, s)
    np.add(s, s, s)
    np.multiply(t, x1, u)
    np.subtract(x2, u, u)
    np.multiply(t, x2, t)
    np.add(x1, t, t)
    np.multiply(s, u, u)
    np.multiply(s, t, t)
    np.add(x1, u, x1)
    np.subtract(x2, t, x2)


def _relax_and_kick(scheme: Scheme, x: Array, numbers: Array, y: Array, v: Array, r: Array) -> None:
    """L, N, L."""
    noise, offset = scheme.noise[:, None, None], scheme.offset[:, None, None]
    _relax(scheme.relaxation, x, y)
    np.multiply(noise, numbers, v)
    np.multiply(y, y, r)
    np.add(r, offset, r)
    np.sqrt(r, r)
    np.cosh(v, x)
    np.sinh(v, v)
    np.multiply(y, x, y)
    np.multiply(r, v, r)
    np.add(y, r, y)
    _relax(scheme.relaxation, y, x)


def _relax(matrix: Array, x: Array, y: Array) -> None:
    """L, from x to y: a product for each stream, so that rounding does not depend on how many are together."""
    np.matmul(matrix, x.swapaxes(0, 1), out=y.swapaxes(0, 1))
