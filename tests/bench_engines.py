"""Compiled kernels against what limits them: C against memory, its divisions and functions, and C by hand; Numba
against C. Run by `make bench`.

Prints a table of the kernels that `by_hand.c` has, in one thread: the medians of the times of the thread in many
interleaved runs; least times are those of moments when the processor was faster, which one of the kernels had alone.
All write to arrays that exist. The limit is the longer of two times: to copy as many bytes as a kernel reads and
writes, and to compute its divisions, roots and functions, each in a loop of its own. Beside it, memory is a loop that
reads and writes the same arrays, which are more than two, and only adds up what it reads. What is a call is as
`kernels.load` gives it; $BENCH_LONG is the seconds for each row.
"""

from __future__ import annotations

import ctypes
import gc
import os
import shutil
import statistics
import time
import warnings
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from bench_c import BY_HAND, arithmetic, costs, streams
from bench_kernels import values
from compiled_c import COMPILERS, addresses, everything, folder, library
from kernel_reference import Case, cases

from symcheck import kernels
from symcheck.views.figures import cells, table

SIZES = (10_000, 1_000_000)
LONG, LEAST, MOST = float(os.environ.get("BENCH_LONG", 2)), 5, 500  # seconds, and runs at least and at most
HEAD = (
    *("kernel", "points", "C, ns a point", "C / limit", "C / limit of the same arrays", "C / by hand"),
    *("call of C, `out=` / C", "call of Numba, `out=` / C", "call of Numba / call of C"),
)


def seconds(function: Callable[[], Any]) -> float:
    """Those of the thread for one run."""
    start = time.thread_time()
    function()
    return time.thread_time() - start


def medians(*functions: Callable[[], Any]) -> list[float]:
    """The median seconds of each; in every round each runs once, in turn."""
    for function in functions:
        function()
    found, begin = [], time.perf_counter()
    while len(found) < LEAST or (len(found) < MOST and time.perf_counter() - begin < LONG):
        found.append([seconds(function) for function in functions])
    return [statistics.median(column) for column in zip(*found, strict=True)]


def row(
    case: Case, size: int, loaded: ctypes.CDLL, hand: ctypes.CDLL, moving: ctypes.CDLL, each: dict[str, float]
) -> str:
    """One kernel at one size."""
    points = [np.ascontiguousarray(x) for x in values(case, size)]
    out = tuple(np.zeros(size) for _ in case.kernel.outputs)
    places, half = addresses([*points, *out]), size * (len(points) + len(out)) // 2
    both = np.ones(half), np.ones(half)
    given = out if len(out) > 1 else out[0]
    calls = [getattr(kernels.load(case.paper, engine=engine), case.name) for engine in ("c", "numba")]
    own, theirs, copying, moved, by_c, by_numba = medians(
        partial(getattr(loaded, f"{case.paper}_{case.name}"), ctypes.c_size_t(size), *places),
        partial(getattr(hand, case.name), ctypes.c_size_t(size), *places),
        partial(hand.copy, ctypes.c_size_t(half), *addresses(both)),
        partial(getattr(moving, f"streams_{case.name}"), ctypes.c_size_t(size), *places),
        *(partial(call, *points, out=given) for call in calls),
    )
    computing = size * arithmetic(case, each)
    limits = (max(copying, computing), max(moved, computing))
    ratios = (*(own / limit for limit in limits), own / theirs, by_c / own, by_numba / own, by_numba / by_c)
    return cells([case.name, f"{size:,}", f"{own / size * 1e9:.2f}", *(f"{x:.2f}" for x in ratios)])


def rows() -> Iterator[str]:
    """The table, as it is measured."""
    shutil.copy(Path(__file__).with_name("by_hand.c"), folder())
    loaded, hand = everything("gcc", "-fopenmp"), library(("by_hand.c",), "gcc", "-fopenmp")
    moving, each = streams(BY_HAND), costs()
    for one in (loaded, hand):
        one.omp_set_num_threads(1)
    yield from table(HEAD)
    for name in BY_HAND:
        case = next(case for case in cases().values() if case.name == name)
        for size in SIZES:
            yield row(case, size, loaded, hand, moving, each)


def main() -> None:
    """Measure and print."""
    if "gcc" not in COMPILERS:
        print("the engines are not measured: there is no gcc; install it (Debian: apt install gcc)")
        return
    warnings.simplefilter("ignore", RuntimeWarning)
    gc.disable()
    for line in rows():
        print(line, flush=True)


if __name__ == "__main__":
    main()
