"""Ensembles of sample paths of the randomly driven rotation, system (1.1), by the scheme of `scheme`.

Streams: every 256 paths have their own generator, SFC64 of `SeedSequence(seed, spawn_key=(number,))`. So a path
depends on the seed and its number alone, not on how many are computed together, by how many threads or in which pieces.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from symcheck.numeric.chunked import pointwise
from symcheck.numeric.domain import Array, engine_module, exact, one_of, require, whole
from symcheck.numeric.random_rotation.scheme import Scheme, scheme
from symcheck.numeric.random_rotation.torques import RandomTorques

LANES = 256  # paths that share a generator
BATCH = 40  # streams at most that are advanced together: what a step needs of 10,240 paths stays in the cache
FEWEST = 16  # streams of a piece that is made for another worker: with fewer, NumPy's threads wait for one another
Advance = Callable[[Array, Sequence[np.random.Generator], int], None]
ENGINES = ("numpy", "numba")  # <engine>_engine.py, which needs the package of that name


class Ensemble(NamedTuple):
    """Recorded sample paths.

    Parameters
    ----------
    time
        Times, s; shape (records,).
    angular_velocity
        Angular velocities x in principal axes, rad/s; shape (records, paths, 3).

    Examples
    --------
    >>> Ensemble(np.array([2.0]), np.array([[[1.0, 0.0, 3.0]]])).angular_velocity.shape
    (1, 1, 3)
    """

    time: Array
    angular_velocity: Array


@pointwise("(),(realization,axis),(),()->(record),(record,realization,axis)")
def simulate(
    torques: RandomTorques,
    start: ArrayLike,
    step: float,
    steps: int,
    *,
    seed: int,
    every: int | None = None,
    first: int = 0,
    workers: int = 1,
    engine: str = "numpy",
) -> Ensemble:
    """Sample paths of system (1.1) with independent noises, from time 0 on.

    Parameters
    ----------
    torques
        Coefficients of the system.
    start
        Angular velocities at time 0, rad/s; shape (paths, 3).
    step
        Time step, s; g_1j^2 epsilon step must not exceed 0.04.
    steps
        Number of steps.
    seed
        Seed of the noises, an integer from 0 on.
    every
        Number of steps between records, a divisor of `steps`; by default only the end is recorded.
    first
        Number of the first path: an ensemble in pieces is the same ensemble.
    workers
        Number of threads.
    engine
        "numpy", or "numba" (needs Numba), which gives the same paths to rounding.

    Returns
    -------
    Ensemble
        Recorded times and angular velocities.

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.
    ImportError
        If Numba is missing.
    FloatingPointError
        If a path leaves the finite numbers.

    Notes
    -----
    Source: (1.1), 1.1.10.

    Examples
    --------
    >>> D = [[1, 0.3, 0.2], [0.2, 0.5, 0.1], [0.2, 0.1, 0.9]]
    >>> torques = RandomTorques(0.01, 0.6, D, g_1=[0.6, 0.8, 0.7], g_2=[1, 0, 1])
    >>> start = [[1.0, 0.0, 2.0]] * 1000
    >>> whole = simulate(torques, start, 2.0, 10, seed=2, every=5)
    >>> whole.angular_velocity.shape, whole.time.tolist()
    ((2, 1000, 3), [10.0, 20.0])
    >>> last = simulate(torques, start[300:], 2.0, 10, seed=2, every=5, first=300, workers=2)
    >>> bool((last.angular_velocity == whole.angular_velocity[:, 300:]).all())
    True
    """
    every = whole("every", whole("steps", steps, 1) if every is None else every, 1)
    require(steps % every == 0, "steps", steps, f"be a multiple of every = {every}")
    velocities = exact("start", start, (None, 3))
    state, before = _in_lanes(velocities, whole("first", first, 0))
    generators = _generators(whole("seed", seed, 0), first // LANES, state.shape[1])
    records = np.empty((steps // every, *state.shape))
    workers = whole("workers", workers, 1)
    record = partial(_record, partial(_advance(engine), scheme(torques, step)), every, records, state, generators)
    with ThreadPoolExecutor(workers) as pool:
        list(pool.map(record, _pieces(state.shape[1], workers)))
    paths = records.reshape(len(records), 3, -1)[:, :, before : before + len(velocities)]
    if not np.isfinite(paths).all():
        raise FloatingPointError(f"a path is no longer finite; take a shorter step than {step}, or see whether D damps")
    time = np.array([float(step) * every * (n + 1) for n in range(len(records))])
    return Ensemble(time, np.moveaxis(paths, 1, 2))


def _in_lanes(start: Array, first: int) -> tuple[Array, int]:
    """The state, shape (3, streams, LANES), and how many lanes lie before the first path."""
    before = first % LANES
    streams = -(-(before + len(start)) // LANES)
    state = np.zeros((3, streams * LANES))
    state[:, before : before + len(start)] = start.T
    return state.reshape(3, streams, LANES), before


def _pieces(streams: int, workers: int) -> list[slice]:
    """As few pieces as keep the workers busy, none too large and none too small, of one size as nearly as can be."""
    count = max(min(workers, streams // FEWEST), -(-streams // BATCH))
    return [slice(streams * k // count, streams * (k + 1) // count) for k in range(count)]


def _generators(seed: int, first: int, count: int) -> list[np.random.Generator]:
    """Those of the streams from number `first` on."""
    keys = range(first, first + count)
    return [np.random.Generator(np.random.SFC64(np.random.SeedSequence(seed, spawn_key=(key,)))) for key in keys]


def _record(
    advance: Advance, every: int, records: Array, state: Array, generators: list[np.random.Generator], mine: slice
) -> None:
    """Advance some of the streams to the end, and write their part of each record."""
    part = np.ascontiguousarray(state[:, mine])
    for record in records:
        advance(part, generators[mine], every)
        record[:, mine] = part


def _advance(engine: str) -> Callable[[Scheme, Array, Sequence[np.random.Generator], int], None]:
    """The function that advances a state; see `numpy_engine.advance`."""
    one_of("engine", engine, ENGINES)
    advance: Callable[[Scheme, Array, Sequence[np.random.Generator], int], None]
    advance = engine_module(engine, f"symcheck.numeric.random_rotation.{engine}_engine").advance
    return advance
