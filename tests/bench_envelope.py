"""Momentum envelopes against Qhull on all sign combinations and a loop by hand, allocation against a linear program.

Run by `python tests/bench_envelope.py`. Times are those of one processor, the least of interleaved runs; Qhull on a
million sets is measured on a sample and scaled. `BENCH_SETS` makes the million smaller.
"""

from __future__ import annotations

import gc
import math
import os
import time
from collections.abc import Callable
from typing import Any

import numba
import numpy as np
from scipy.optimize import linprog
from scipy.spatial import ConvexHull

from symcheck.numeric import wheels
from symcheck.numeric.domain import TOLERANCE, Array
from symcheck.numeric.wheels import faces, numba_engine
from symcheck.numeric.wheels.faces import PARALLEL

ROUNDS, SHORT = 5, 0.02  # seconds that short runs are repeated for
SAMPLE = 300
SETS = int(os.environ.get("BENCH_SETS", 1_000_000))
SIZES = (10, 20, 50, 100, 200, 500, 1000, 2000)
Run = Callable[[], Any]


def seconds(function: Run) -> float:
    """One run; short ones are repeated."""
    start, runs = time.process_time(), 0
    while not runs or time.process_time() - start < SHORT:
        function()
        runs += 1
    return (time.process_time() - start) / runs


def least(*functions: Run, rounds: int = ROUNDS) -> list[float]:
    """The least time of each function; in every round each runs once, in turn."""
    gc.disable()
    times = [[seconds(function) for function in functions] for _ in range(rounds)]
    gc.enable()
    return [min(column) for column in zip(*times, strict=True)]


def random_axes(*shape: int) -> Array:
    """Unit vectors with every direction equally likely."""
    axes = np.random.default_rng(2005).normal(size=(*shape, 3))
    return np.asarray(axes / np.linalg.norm(axes, axis=-1, keepdims=True))


def corners(axes: Array) -> Array:
    """All 2^n momenta of wheels at their limits."""
    points = np.zeros((1, 3))
    for axis in axes:
        points = np.concatenate([points - axis, points + axis])
    return points


def row(what: str, spent: float, *notes: str) -> None:
    """One line of the report."""
    print(f"{what:<58} {spent * 1e6:>14,.1f} us   {'; '.join(notes)}")


def ratio(ours: float, theirs: float) -> str:
    """How many times as long the others take."""
    return f"{theirs / ours:,.0f} times as fast"


@numba.njit(error_model="numpy", fastmath={"contract"})  # type: ignore[untyped-decorator]
def loop(axes: Array, normals: Array, distances: Array) -> None:
    """By hand: equal limits of 1, no two axes parallel, nothing checked."""
    for s in range(len(axes)):
        pair = 0
        for i in range(axes.shape[1]):
            for j in range(i + 1, axes.shape[1]):
                u, v = axes[s, i], axes[s, j]
                x, y, z = u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]
                scale, total = 1 / math.sqrt(x * x + y * y + z * z), 0.0
                for k in range(axes.shape[1]):
                    total += abs(x * axes[s, k, 0] + y * axes[s, k, 1] + z * axes[s, k, 2])
                distances[s, pair] = total * scale
                if len(normals):
                    normals[s, pair, 0], normals[s, pair, 1], normals[s, pair, 2] = x * scale, y * scale, z * scale
                pair += 1


def by_hand(axes: Array, keep: bool) -> None:
    """The half-spaces of a loop, or the distances alone."""
    sets, pairs = len(axes), math.comb(axes.shape[1], 2)
    loop(axes, np.empty((sets if keep else 0, pairs, 3)), np.empty((sets, pairs)))


def beside_a_loop() -> None:
    """The engine of Numba as it is called, against a loop by hand; six wheels."""
    for sets in (1, 1000, SETS):
        axes = random_axes(sets, 6)
        given = axes[0] if sets == 1 else axes
        distances, half_spaces, numpy, bare_distances, bare = least(
            lambda: wheels.face_distances(given, engine="numba"),  # noqa: B023
            lambda: wheels.half_spaces(given, engine="numba"),  # noqa: B023
            lambda: wheels.half_spaces(given),  # noqa: B023
            lambda: by_hand(axes, False),  # noqa: B023
            lambda: by_hand(axes, True),  # noqa: B023
        )
        for what, ours, theirs in (
            ("face distances, Numba", distances, bare_distances),
            ("half-spaces, Numba", half_spaces, bare),
            ("half-spaces, NumPy", numpy, bare),
        ):
            row(f"{sets:,} sets of six: {what}", ours, f"{ours / theirs:.2f} times a loop of Numba by hand")


def twenty_wheels() -> None:
    """One set of 20 wheels, 2^20 points for Qhull."""
    axes, many = random_axes(20), random_axes(1000, 20)
    points = corners(axes)
    alone = axes[None], np.ones((1, 20)), True, PARALLEL
    building, hull, single, compiled, formula, formula_compiled, whole, batch = least(
        lambda: corners(axes),
        lambda: ConvexHull(points),
        lambda: wheels.half_spaces(axes),
        lambda: wheels.half_spaces(axes, engine="numba"),
        lambda: faces.of_pairs(*alone),
        lambda: numba_engine.of_pairs(*alone, TOLERANCE),
        lambda: wheels.envelope(axes).counts,
        lambda: wheels.half_spaces(many),
    )
    row("n = 20: Qhull on the 2^20 points", hull, f"{building * 1e6:,.0f} us more to make them")
    for what, ours in (
        ("half-spaces of one set, one call", single),
        ("half-spaces of one set, one call, Numba", compiled),
        ("the same, no arguments checked", formula),
        ("the same, no arguments checked, Numba", formula_compiled),
        ("vertices, edges, faces and half-spaces", whole),
        ("half-spaces of one set among 1,000", batch / len(many)),
    ):
        row(f"n = 20: {what}", ours, ratio(ours, hull), f"{ratio(ours, hull + building)} with the points")


def million_sets() -> None:
    """Many sets of six wheels."""
    axes = random_axes(SETS, 6)
    points = [corners(each) for each in axes[:SAMPLE]]
    hulls, *ours = least(
        lambda: [ConvexHull(each) for each in points],
        lambda: wheels.face_distances(axes),
        lambda: wheels.half_spaces(axes),
        lambda: wheels.face_distances(axes, engine="numba"),
        lambda: wheels.half_spaces(axes, engine="numba"),
    )
    theirs = hulls / SAMPLE * SETS
    row(f"{SETS:,} sets of six: Qhull, scaled from {SAMPLE}", theirs)
    for what, spent in zip(
        ("face distances", "half-spaces", "face distances, Numba", "half-spaces, Numba"), ours, strict=True
    ):
        row(f"{SETS:,} sets of six: {what}", spent, ratio(spent, theirs))


def growth() -> None:
    """How the time grows with the number of wheels."""
    print(f"\n{'n':>5} {'faces':>10} {'half-spaces':>13} {'per n^2 log n':>14} {'with vertices, edges, faces':>28}")
    for count in SIZES:
        axes = random_axes(count)
        rounds = 3 if count < 1000 else 2
        [bounds] = least(lambda: wheels.envelope(axes).half_spaces, rounds=rounds)  # noqa: B023
        [whole] = least(lambda: wheels.envelope(axes).counts, rounds=rounds)  # noqa: B023
        unit = bounds / (count**2 * math.log2(count)) * 1e9
        faces = 2 * len(wheels.envelope(axes).half_spaces.distances)
        print(f"{count:>5} {faces:>10,} {bounds * 1e3:>10.2f} ms {unit:>11.2f} ns {whole * 1e3:>25.2f} ms")


def allocation() -> None:
    """The least greatest load of six wheels."""
    axes, demands = wheels.six_wheels(1.2), np.random.default_rng(1).normal(size=(100_000, 3))
    bounds = np.vstack([np.column_stack([sign * np.eye(6), -np.ones(6)]) for sign in (1, -1)])
    equations = np.column_stack([axes.T, np.zeros(3)])
    free = [(None, None)] * 6 + [(0, None)]
    programs, ours = least(
        lambda: [linprog(np.eye(7)[6], bounds, np.zeros(12), equations, each, free) for each in demands[:20]],
        lambda: wheels.allocate(axes, demands),
        rounds=3,
    )
    row("\none demand of six wheels: linear program (HiGHS)", programs / 20)
    row("one demand of six wheels among 100,000: allocate", ours / 1e5, ratio(ours / 1e5, programs / 20))


def main() -> None:
    """Measure and print."""
    twenty_wheels()
    million_sets()
    beside_a_loop()
    growth()
    allocation()


if __name__ == "__main__":
    main()
