"""Kernels for Numba against SymPy's `lambdify(cse=True)`, and against C by hand: minima of interleaved runs, as ratios.

    python tests/bench_numba.py [KERNEL ...]

Both allocate their results. A call moves each argument and each result, written twice as the cache reads it first; the
share of what the machine copies in the same time says how far memory is the limit.
"""

from __future__ import annotations

import ctypes
import os
import shutil
import statistics
import subprocess
import sys
from collections.abc import Callable, Iterator
from functools import cache, partial
from pathlib import Path
from tempfile import TemporaryDirectory
from types import ModuleType
from typing import Any

import numpy as np
from bench import timed
from bench_kernels import lambdified, values
from kernel_reference import Case, cases
from rich.console import Console
from test_numba_target import module, texts

from symcheck.kernels.codegen.program import UNARY

SMALL, LARGE = 10_000, 1_000_000
ROUNDS, SHORT = 5, 0.001
THREADS = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
BY_HAND = Path(__file__).with_name("by_hand.c")
COMPILE = (
    "-std=c99",
    "-O3",
    "-march=native",
    "-fopenmp-simd",
    "-fno-math-errno",
    "-fno-trapping-math",
    "-shared",
    "-fPIC",
)
ASKED, ASKED_OF_C = 20.0, 1.5
HEAD = "{:<44} {:>9} {:>8} {:>9} {:>8} {:>10} {:>10}"
_folder = TemporaryDirectory(prefix="symcheck-numba-")


def fastest(*functions: Callable[[], Any]) -> list[float]:
    """Seconds of each; in every round each runs once, in turn."""
    for function in functions:
        function()
    runs = [[timed(function, SHORT)[0] for function in functions] for _ in range(ROUNDS)]
    return [min(column) for column in zip(*runs, strict=True)]


@cache
def compiled(key: str) -> ModuleType:
    """The module of a paper."""
    return module(Path(_folder.name) / f"{key}.py", texts()[f"{key}.py"])


def transcendental(case: Case) -> int:
    """How many roots and functions a point takes."""
    return sum(each.function in (*UNARY, "power") for each in case.compiled.program.operations)


def copying(size: int) -> float:
    """Bytes per second of a copy, each written one counted twice."""
    source, target = np.ones(size), np.ones(size)
    return 24 * size / fastest(partial(np.copyto, target, source))[0]


def ratios(case: Case) -> tuple[list[float], float]:
    """Times as fast as lambdify: few points, many, many in threads; seconds for each of many points."""
    ours, theirs = getattr(compiled(case.paper), case.name), lambdified(case)
    few, many = values(case, SMALL), values(case, LARGE)
    small, slow = fastest(partial(ours, *few), partial(theirs, *few))
    large, apart, slower = fastest(partial(ours, *many), partial(ours, *many, threads=THREADS), partial(theirs, *many))
    return [slow / small, slower / large, slower / apart], large / LARGE


@cache
def by_hand() -> ctypes.CDLL | None:
    """C by hand, if there is a compiler."""
    if not shutil.which("gcc") or not BY_HAND.exists():
        return None
    library = Path(_folder.name) / "by_hand.so"
    subprocess.run(["gcc", *COMPILE, str(BY_HAND), "-lm", "-o", str(library)], check=True)
    return ctypes.CDLL(str(library))


def to_c(case: Case) -> Iterator[str]:
    """Times as long as C by hand, with the results in arrays that are there already: the loop, and the whole call."""
    theirs = getattr(by_hand(), case.name, None)
    for size in (SMALL, LARGE) if theirs else ():
        columns, out = values(case, size), [np.empty(size) for _ in case.kernel.outputs]
        places = [ctypes.c_void_p(x.ctypes.data) for x in (*columns, *out)]
        loop = getattr(compiled(case.paper), f"_{case.name}_points")
        call = partial(getattr(compiled(case.paper), case.name), *columns, out=out if len(out) > 1 else out[0])
        bare, whole, c = fastest(partial(loop, *columns, *out), call, partial(theirs, ctypes.c_size_t(size), *places))
        yield f"{size:>9,} points: loop {bare / c:.2f}, whole call {whole / c:.2f} of {c / size * 1e9:.2f} ns"


def main() -> None:
    """Measure and print."""
    out = Console(width=140, highlight=False)
    chosen = [case for case in cases().values() if not sys.argv[1:] or case.name in sys.argv[1:]]
    bandwidth = copying(10_000_000)
    out.print(f"copy {bandwidth / 1e9:.1f} GB/s, {THREADS} threads, minima of {ROUNDS} runs")
    out.print(HEAD.format("kernel", "functions", f"{SMALL:,}", f"{LARGE:,}", "threads", "ns a point", "of copying"))
    found: list[list[float]] = []
    with np.errstate(all="ignore"):
        for case in chosen:
            calls, (times, each) = transcendental(case), ratios(case)
            moved = 8 * (len(case.kernel.arguments) + 2 * len(set(case.compiled.pointwise.outputs.values())))
            cells = (*(f"{x:.2f}" for x in times), f"{each * 1e9:.1f}", f"{moved / each / bandwidth:.0%}")
            out.print(HEAD.format(case.name, calls, *cells))
            found += [times] if calls >= 2 else []
    if found:
        means = ", ".join(f"{statistics.geometric_mean(column):.2f}" for column in zip(*found, strict=True))
        out.print(f"geometric means of kernels with two functions or more: {means} (asked: {ASKED:g})")
    for case in chosen:
        for line in to_c(case):
            out.print(f"{case.name}, times as long as C by hand (asked: {ASKED_OF_C:g}), {line}")


if __name__ == "__main__":
    main()
