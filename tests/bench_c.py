"""Generated C against `lambdify(cse=True)`, against C by hand, and against what limits it. Run by `make bench`.

The limit is the longer of two times: to copy as many bytes as a kernel reads and writes, and to compute its divisions,
roots and functions, each in a loop of its own. Copying has two arrays, a kernel many; a loop that only reads and writes
the same arrays says what they take.

Times are the least of many interleaved runs. The results of C are arrays that exist; lambdify makes its own.
"""

from __future__ import annotations

import ctypes
import gc
import os
import shutil
import statistics
import time
import warnings
from collections.abc import Callable, Collection, Iterator, Mapping
from fractions import Fraction
from functools import partial, reduce
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from bench_kernels import lambdified, values
from compiled_c import COMPILERS, FLAGS, addresses, everything, folder, library
from kernel_reference import Case, cases
from rich import box
from rich.console import Console
from rich.table import Table

from symcheck.kernels.codegen import c_target
from symcheck.kernels.codegen.kernel import Argument, Kernel, Output
from symcheck.kernels.codegen.program import OF_HALF, UNARY, Operation, Program, Ref, of_half
from symcheck.kernels.codegen.special import RUNTIME
from symcheck.kernels.codegen.target import CompiledKernel

CORES = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
COLUMNS = ((10_000, 1), (1_000_000, 1), (1_000_000, CORES))  # points and threads
SLOW = ("divide", *UNARY, *RUNTIME, OF_HALF, "power")
ROUNDS, MOST, LONG = 3, 300, 0.4  # runs of each, at least and at most, and seconds from which no more are made
BY_HAND = (
    "direction_cosines",
    "product_of_axial_moments",
    "face_distances_of_four_wheels",
    "drift_coefficients",
    "density_of_frequency",
)


class Row(NamedTuple):
    """A kernel at one size with some threads: seconds of generated C, lambdify, its limit, C by hand."""

    own: float
    theirs: float
    limit: float
    hand: float


def least(*functions: Callable[[], Any]) -> list[float]:
    """The least seconds of each; in every round each runs once, in turn."""
    found, begin = [], time.perf_counter()
    while len(found) < ROUNDS or (len(found) < MOST and time.perf_counter() - begin < LONG):
        found.append([seconds(function) for function in functions])
    return [min(column) for column in zip(*found, strict=True)]


def seconds(function: Callable[[], Any]) -> float:
    """Those of one run."""
    start = time.perf_counter()
    function()
    return time.perf_counter() - start


def rows(case: Case, loaded: ctypes.CDLL, hand: ctypes.CDLL, costs: Mapping[str, float]) -> Iterator[Row]:
    """The figures of each column."""
    own, theirs = getattr(loaded, f"{case.paper}_{case.name}"), lambdified(case)
    other = getattr(hand, case.name) if case.name in BY_HAND else own
    computing = arithmetic(case, costs)
    for size, threads in COLUMNS:
        points = [np.ascontiguousarray(x) for x in values(case, size)]
        arrays = [*points, *(np.zeros(size) for _ in case.kernel.outputs)]
        places, half = addresses(arrays), size * len(arrays) // 2
        both = np.ones(half), np.ones(half)
        loaded.omp_set_num_threads(threads)
        mine, lambdify, copying, by_hand = least(
            partial(own, ctypes.c_size_t(size), *places),
            partial(theirs, *points),
            partial(hand.copy, ctypes.c_size_t(half), *addresses(both)),
            partial(other, ctypes.c_size_t(size), *places),
        )
        yield Row(mine, lambdify, max(copying, computing * size / threads), by_hand)


def costs() -> dict[str, float]:
    """Seconds of each division, root and function for a point, in kernels that have nothing else."""
    compiled = {name: _alone(name) for name in SLOW}
    for name, text in c_target.TARGET.files("costs", compiled).items():
        (folder() / name).write_text(text)
    loaded, size = library(("costs.c",), "gcc"), 4096
    x, y, z = (np.random.default_rng(1).uniform(0.1, 1.2, size) for _ in range(3))
    calls = [partial(getattr(loaded, f"costs_{name}"), ctypes.c_size_t(size), *addresses((x, y, z))) for name in SLOW]
    return {name: found / size for name, found in zip(SLOW, least(*calls), strict=True)}


def arithmetic(case: Case, costs: Mapping[str, float]) -> float:
    """Seconds of all divisions, roots and functions of a point."""
    return sum(costs.get(of_half(operation).function, 0) for operation in case.compiled.pointwise.operations)


def streams(names: Collection[str]) -> ctypes.CDLL:
    """Kernels of these names that read and write the same arrays, and only add up what they read."""
    compiled = {}
    for case in cases().values():
        if case.name in names:
            program = Program(case.compiled.pointwise.inputs)
            total = reduce(partial(program.apply, "add"), program.inputs)
            program.outputs.update(dict.fromkeys(case.compiled.pointwise.outputs, total))
            compiled[case.name] = CompiledKernel(case.kernel, program, program)
    for name, text in c_target.TARGET.files("streams", compiled).items():
        (folder() / name).write_text(text)
    return library(("streams.c",), "gcc")


def _alone(function: str) -> CompiledKernel:
    operands: tuple[Ref, ...] = ("x", "y") if function in ("divide", "power", "gamma_ratio") else ("x",)
    operation = Operation("t1", function, operands)
    if function == OF_HALF:
        operation = Operation("t1", "gamma_ratio", ("x", Fraction(1, 2)))
    program = Program(("x", "y"), operations=[operation], outputs={"z": "t1"})
    kernel = Kernel(
        says="One operation.",
        arguments=(Argument("x", "a number"), Argument("y", "a number")),
        outputs=(Output("z", "a number"),),
        derived=lambda: {"z": function},
        claims=("1",),
    )
    return CompiledKernel(kernel, program, program)


def functions(case: Case) -> int:
    """How many roots and functions the kernel computes."""
    return sum(operation.function in SLOW[1:] for operation in case.compiled.pointwise.operations)


def main() -> None:
    """Measure and print."""
    if "gcc" not in COMPILERS:
        print("the kernels in C are not measured: there is no gcc; install it (Debian: apt install gcc)")
        return
    warnings.simplefilter("ignore", RuntimeWarning)  # of lambdify's functions
    gc.disable()
    shutil.copy(Path(__file__).with_name("by_hand.c"), folder())
    loaded, hand, each = everything("gcc", "-fopenmp"), library(("by_hand.c",), "gcc", "-fopenmp"), costs()
    out = Console(width=150, highlight=False)
    out.print(f"gcc {' '.join(FLAGS)} -fopenmp; {CORES} cores; NumPy {np.__version__}")
    out.print(f"copy {copied(hand):.1f} GB/s; ns in a loop alone:", *(f"{x} {t * 1e9:.2f}" for x, t in each.items()))
    heads = [f"{size:,}, {threads} thread{'s' * (threads > 1)}" for size, threads in COLUMNS]
    table = Table("kernel", "functions", "bytes", *heads, box=box.SIMPLE_HEAD)
    table.title = "ns per point, times as fast as lambdify, share of the limit"
    gains: list[list[float]] = [[] for _ in COLUMNS]
    by_hand: dict[str, list[float]] = {}
    for case in cases().values():
        found, calls = list(rows(case, loaded, hand, each)), functions(case)
        cells = [
            f"{row.own / size * 1e9:6.2f} {row.theirs / row.own:5.1f}x {row.limit / row.own:5.0%}"
            for row, (size, _) in zip(found, COLUMNS, strict=True)
        ]
        count = 8 * (len(case.kernel.arguments) + len(case.kernel.outputs))
        table.add_row(case.name, str(calls), str(count), *cells)
        for gain, row in zip(gains, found, strict=True):
            gain += [row.theirs / row.own] if calls >= 2 else []
        if case.name in BY_HAND:
            by_hand[case.name] = [row.own / row.hand for row in found]
    out.print(table)
    means = Table("", *heads, box=box.SIMPLE_HEAD)
    means.add_row("lambdify / C, mean, two functions or more", *(f"{statistics.geometric_mean(x):.1f}" for x in gains))
    for name, ratios in by_hand.items():
        means.add_row(f"C / C by hand, {name}", *(f"{ratio:.2f}" for ratio in ratios))
    out.print(means)


def copied(hand: ctypes.CDLL, size: int = 10_000_000) -> float:
    """Gigabytes that one thread reads and writes in a second when it copies."""
    both = np.ones(size), np.ones(size)
    hand.omp_set_num_threads(1)
    (time_of_copy,) = least(partial(hand.copy, ctypes.c_size_t(size), *addresses(both)))
    return 16e-9 * size / time_of_copy


if __name__ == "__main__":
    main()
