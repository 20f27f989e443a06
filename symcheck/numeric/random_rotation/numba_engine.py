"""A step of the scheme compiled by Numba: the same numbers, the same formulas, path by path within a stream.

Loops over paths become vector instructions where they hold arithmetic and roots alone. So the tangents of angles,
circular and hyperbolic ones alike, are Lambert's continued fraction tan z = z/(1 - z^2/(3 - z^2/(5 - ...))), right to
rounding within |z| <= 1, and the normal numbers have a separate loop. Decision: this instead of the functions of
the C library, which take longer than all the rest of a step but the normal numbers; not for larger z.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt

import numpy as np

from symcheck.numeric.compiled import compiled
from symcheck.numeric.domain import Array
from symcheck.numeric.random_rotation.scheme import Scheme

TURN = float.fromhex("0x1.921fb544p+2")  # 2 pi to 33 bits: times a number of turns it is exact
REST_OF_TURN = 2.430840202602477e-10  # 2 pi less TURN


def advance(scheme: Scheme, state: Array, generators: Sequence[np.random.Generator], steps: int) -> None:
    """Advance the state, shape (3, streams, paths of each), in place; stream j takes its numbers from generator j."""
    for j, generator in enumerate(generators):
        stream = np.ascontiguousarray(state[:, j])
        _advance(stream, generator, steps, *scheme)
        state[:, j] = stream


@compiled
def _advance(
    x: Array, generator: np.random.Generator, steps: int, half: float, matrix: Array, noise: Array, offset: Array
) -> None:
    numbers = np.empty_like(x)
    rotate(x, half)
    for done in range(steps):
        for i in range(3):
            for p in range(x.shape[1]):
                numbers[i, p] = generator.standard_normal()
        _relax_and_kick(x, numbers, matrix, noise, offset)
        rotate(x, 2 * half if done < steps - 1 else half)


@compiled
def rotate(x: Array, rate: float) -> None:
    """R: (x_1, x_2) turns by the angle rate x_3; a fourth of it, less whole turns, is at most pi/4."""
    for p in range(x.shape[1]):
        angle = rate * x[2, p]
        turns = np.floor(angle / TURN + 0.5)
        quarter = ((angle - turns * TURN) - turns * REST_OF_TURN) / 4
        a, b = fraction(quarter, -quarter * quarter)
        scale = 1 / (b * b + a * a)
        sin_half, cos_half = 2 * a * b * scale, (b - a) * (b + a) * scale
        x1, x2 = x[0, p], x[1, p]
        x[0, p] = x1 + 2 * sin_half * (cos_half * x2 - sin_half * x1)
        x[1, p] = x2 - 2 * sin_half * (cos_half * x1 + sin_half * x2)


@compiled
def _relax_and_kick(x: Array, numbers: Array, matrix: Array, noise: Array, offset: Array) -> None:
    """L, N, L; of N, the three quotients a/d have one division, which takes as long as a dozen products."""
    for p in range(x.shape[1]):
        y1, y2, y3 = _product(matrix, x[0, p], x[1, p], x[2, p])
        a1, d1 = _kick(y1, noise[0] / 2 * numbers[0, p], offset[0])
        a2, d2 = _kick(y2, noise[1] / 2 * numbers[1, p], offset[1])
        a3, d3 = _kick(y3, noise[2] / 2 * numbers[2, p], offset[2])
        d12 = d1 * d2
        scale = 1 / (d12 * d3)
        scale3 = scale * d3
        y1, y2, y3 = y1 + a1 * d2 * scale3, y2 + a2 * d1 * scale3, y3 + a3 * d12 * scale
        x[0, p], x[1, p], x[2, p] = _product(matrix, y1, y2, y3)


@compiled
def _product(matrix: Array, x1: float, x2: float, x3: float) -> tuple[float, float, float]:
    return (
        matrix[0, 0] * x1 + matrix[0, 1] * x2 + matrix[0, 2] * x3,
        matrix[1, 0] * x1 + matrix[1, 1] * x2 + matrix[1, 2] * x3,
        matrix[2, 0] * x1 + matrix[2, 1] * x2 + matrix[2, 2] * x3,
    )


@compiled
def _kick(y: float, z: float, offset: float) -> tuple[float, float]:
    """N of one axis, for half the hyperbolic angle z: a, d with y -> y + a/d; d is some 1e15 for |z| <= 1."""
    a, b = fraction(z, z * z)
    return 2 * a * (b * sqrt(y * y + offset) + a * y), (b - a) * (b + a)


@compiled
def fraction(z: float, q: float) -> tuple[float, float]:
    """a, b with a/b = tan z for q = -z^2, and tanh z for q = z^2; |z| <= 1."""
    above = 34459425 + q * (4729725 + q * (135135 + q * (990 + q)))
    below = 34459425 + q * (16216200 + q * (945945 + q * (13860 + q * 45)))
    return z * above, below
