"""Sample paths of Stratonovich equations, all at once, by Heun's scheme on NumPy arrays.

The engine of ensembles is held against them. They know no system: drift, diffusion and the fast motion are given.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from math import sqrt

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Drift = Callable[[Array], Array]
Diffusion = Callable[[Array, Array], Array]
Flow = Callable[[Array, float], Array]


def wiener_increments(rng: np.random.Generator, step: float, steps: int, shape: tuple[int, ...]) -> Iterator[Array]:
    """Increments of Wiener processes over successive steps, each of the shape (noises, paths)."""
    return (sqrt(step) * rng.standard_normal(shape) for _ in range(steps))


def heun_step(drift: Drift, diffusion: Diffusion, state: Array, step: float, increment: Array) -> Array:
    """One step of Heun's scheme for dx = b(x) dt + G(x) o dW.

    The Euler step x* = x + b(x) h + G(x) dW predicts; then x + (b(x) + b(x*)) h/2 + (G(x) + G(x*)) dW/2.
    """
    slope, kick = drift(state), diffusion(state, increment)
    predicted = state + step * slope + kick
    return state + (step * (slope + drift(predicted)) + kick + diffusion(predicted, increment)) / 2


def stratonovich_paths(
    drift: Drift,
    diffusion: Diffusion,
    start: Array,
    step: float,
    increments: Iterable[Array],
    *,
    flow: Flow = lambda state, time: state,
    every: int = 1,
) -> Array:
    """States of dx = f(x) dt + b(x) dt + G(x) o dW after every so many steps; the flow solves x' = f(x).

    Each step is half a step of the flow, Heun's scheme for b and G, half a step of the flow. Stratonovich's calculus
    has the ordinary chain rule, so this splitting adds no correction to the drift. Weak order 1; strong order 1 for
    noises that commute, otherwise 1/2; order 2 without noise.
    """
    state, records = start, list[Array]()
    for done, increment in enumerate(increments, 1):
        state = flow(heun_step(drift, diffusion, flow(state, step / 2), step, increment), step / 2)
        if done % every == 0:
            records.append(state)
    return np.stack(records)
