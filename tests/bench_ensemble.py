"""The ensemble of `random_rotation` against the same scheme in plain NumPy: interleaved runs. Run by `make bench`.

Plain: the formulas as one writes them down, on arrays of all paths, with temporaries. The normal numbers cost the same
in both and are counted. Heun's scheme of `stochastic`, with all six noises, stands beside it. To be run with
OPENBLAS_NUM_THREADS=1, else the idle threads of a matrix product are counted against whoever comes next.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import partial
from importlib.util import find_spec
from time import perf_counter, process_time
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sample_paths import stratonovich_paths, wiener_increments
from scipy.linalg import expm

from symcheck.numeric.random_rotation import RandomTorques, simulate

Array = NDArray[np.float64]
TORQUES = RandomTorques(
    0.01, 0.6, [[1.0, 0.3, 0.25], [0.2, 0.5, 0.15], [0.2, 0.1, 0.9]], g_1=[0.9, 0.3, 0.7], g_2=[0.4, 0.9, 0.6]
)
STEP, ROUNDS = 2.0, 9
SIZES = {1_000: 1_000, 10_000: 200, 100_000: 40, 1_000_000: 20}  # paths: steps


def plain(start: Array, steps: int, seed: int = 1) -> Array:
    """The scheme in plain expressions; start has the shape (3, paths)."""
    rng = np.random.Generator(np.random.SFC64(seed))
    small, (g_1, g_2) = TORQUES.varepsilon, TORQUES.intensities[:, :, None]
    relaxation = expm(-small * STEP / 2 * TORQUES.dissipation)
    x = start
    for _ in range(steps):
        v = g_1 * np.sqrt(small * STEP) * rng.standard_normal(x.shape)
        x = relaxation @ rotated(x, STEP / 2)
        x = x * np.cosh(v) + np.sqrt(x**2 + (g_2 / g_1) ** 2) * np.sinh(v)
        x = rotated(relaxation @ x, STEP / 2)
    return x


def rotated(x: Array, time: float) -> Array:
    """The turn by the angle k x_3 t."""
    x1, x2, x3 = x
    cos, sin = np.cos(TORQUES.k * x3 * time), np.sin(TORQUES.k * x3 * time)
    return np.stack([cos * x1 + sin * x2, cos * x2 - sin * x1, x3])


def heun(start: Array, steps: int, seed: int = 1) -> Array:
    """Heun's scheme with all six noises."""
    small, (g_1, g_2) = TORQUES.varepsilon, TORQUES.intensities[:, :, None]
    increments = wiener_increments(np.random.Generator(np.random.SFC64(seed)), STEP, steps, (6, start.shape[1]))
    return stratonovich_paths(
        lambda x: -small * (TORQUES.dissipation @ x),
        lambda x, dw: np.sqrt(small) * (g_1 * x * dw[:3] + g_2 * dw[3:]),
        start,
        STEP,
        increments,
        flow=rotated,
        every=steps,
    )[-1]


def contenders() -> dict[str, Callable[[Array, int], Any]]:
    """What is compared; the first is the measure."""

    def ours(engine: str, workers: int, start: Array, steps: int) -> Any:
        return simulate(TORQUES, start.T, STEP, steps, seed=1, engine=engine, workers=workers)

    engines = ("numpy", "numba") if find_spec("numba") else ("numpy",)
    found = {f"{engine}, {n} thread{'s' * (n > 1)}": partial(ours, engine, n) for engine in engines for n in (1, 2)}
    return {"plain NumPy": plain, "Heun, six noises": heun, **found}


def seconds(function: Callable[[Array, int], Any], start: Array, steps: int) -> tuple[float, float]:
    """Of one run, by the clock and of the processor."""
    begin = perf_counter(), process_time()
    function(start, steps)
    return perf_counter() - begin[0], process_time() - begin[1]


def main() -> None:
    """Measure and print."""
    most = int(os.environ.get("BENCH_MOST", max(SIZES)))
    print(
        "ns for a step of a path, and times as fast as plain NumPy: least, median; by the clock, then of the processor"
    )
    for paths, steps in ((paths, steps) for paths, steps in SIZES.items() if paths <= most):
        start, chosen = np.random.default_rng(0).uniform(0.5, 1.5, (3, paths)), contenders()
        for function in chosen.values():
            function(start, 1)  # compiles
        runs = np.array([[seconds(function, start, steps) for function in chosen.values()] for _ in range(ROUNDS)])
        found = np.array([runs.min(axis=0), np.median(runs, axis=0)]) * 1e9 / paths / steps
        for name, row in zip(chosen, np.moveaxis(found, 1, 0), strict=True):
            ratios = found[:, 0] / row
            clocks = (f"{row[0, c]:7.1f} {row[1, c]:7.1f} {ratios[0, c]:6.2f} {ratios[1, c]:6.2f}" for c in range(2))
            print(f"{paths:>9,} paths  {name:<18} {'   '.join(clocks)}")


if __name__ == "__main__":
    main()
