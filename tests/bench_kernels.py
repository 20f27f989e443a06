"""Kernels against SymPy's `lambdify(cse=True)`, and against 50 digits. Run by `make bench`.

Prints two tables in Markdown: times as fast (medians of interleaved runs), and largest errors. `make bench` records
them in generated/figures.md, where a test keeps them complete.
"""

from __future__ import annotations

import gc
import os
import statistics
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sp
from bench import interleaved
from kernel_reference import Case, cases, measured, random_points

from symcheck.kernels.codegen.program import UNARY
from symcheck.views.figures import cells, table

SIZES = (0, 1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000)  # 0: Python floats
MILLION = SIZES.index(1_000_000)
MOST = int(os.environ.get("BENCH_MOST", SIZES[-1]))
ROUNDS, SHORT = 5, 0.01
POINTS = 1_000  # different ones, repeated; as many are compared with 50 digits
SPEED = ("kernel", "functions", "ns a point", "numbers", *(f"{size:,}" for size in SIZES[1:]))
ACCURACY = ("kernel", "largest error, ulp", "stated", "where")


def lambdified(case: Case) -> Callable[..., Any]:
    """The derived expressions as SymPy prints them for NumPy."""
    letters = {symbol.name: symbol for expression in case.derived for symbol in expression.free_symbols}
    arguments = [letters.get(each.name, sp.Symbol(each.name)) for each in case.kernel.arguments]
    function: Callable[..., Any] = sp.lambdify(
        arguments, case.derived, modules=["numpy", "scipy"], cse=True, dummify=True
    )
    return function


def values(case: Case, size: int) -> list[Any]:
    """Ordinary points where the kernel has values; Python floats for size 0."""
    points = random_points(case.kernel, POINTS, np.random.default_rng(2005), decades=0.3)
    results = case.function(*points)
    fine = np.isfinite(results if isinstance(results, tuple) else (results,)).all(axis=0)
    columns = [np.resize(column[fine], size or 1) for column in points]
    return columns if size else [float(column[0]) for column in columns]


def ratios(case: Case) -> tuple[int, float, list[float]]:
    """How many roots and functions it has, seconds per point of a million, times as fast as lambdify by size."""
    ours, theirs = case.function, lambdified(case)
    calls = sum(operation.function in UNARY for operation in case.compiled.program.operations)
    gc.freeze()  # what SymPy made need not be looked through before every run
    found, per_point = [], 0.0
    for size in (size for size in SIZES if size <= MOST):
        arguments = values(case, size)
        rounds = ROUNDS if size <= 1_000_000 else ROUNDS // 2
        (own, _), (other, _) = interleaved(rounds, partial(ours, *arguments), partial(theirs, *arguments), short=SHORT)
        found.append(other / own)
        per_point = own / size if size == 1_000_000 else per_point
    return calls, per_point, found


def limits() -> str:
    """What the machine gives: copying, a sine, a tangent, for each of ten million doubles."""
    source = np.random.default_rng(1).uniform(0.1, 1.2, 10_000_000)
    target = np.empty_like(source)
    (copy, _), (sine, _), (tangent, _) = interleaved(
        ROUNDS, lambda: np.copyto(target, source), lambda: np.sin(source, target), lambda: np.tan(source, target)
    )
    per = 1e9 / source.size
    copied, slow = f"copy {16 / (copy * per):.1f} GB/s", "; no AVX-512: half the factor is asked"
    processor = Path("/proc/cpuinfo")
    known = processor.read_text(encoding="utf-8") if processor.exists() else ""
    functions = f"a sine {sine * per:.1f} ns, a tangent {tangent * per:.1f} ns for each double"
    return f"The machine: {copied}, {functions}{'' if 'avx512' in known else slow}."


def speed(every: Iterable[Case]) -> Iterator[str]:
    """A table row for each kernel; last what the large sizes come to."""
    yield from table(SPEED)
    large: list[float] = []
    small: list[float] = []
    for case in every:
        calls, per_point, found = ratios(case)
        large += found[MILLION:] if calls >= 2 else []
        small += found[1:MILLION]
        yield cells([case.id, str(calls), f"{per_point * 1e9:.1f}", *(f"{ratio:.2f}" for ratio in found)])
    yield ""
    mean = statistics.geometric_mean
    if large:
        yield f"Geometric mean from a million points on, of kernels with two functions or more: {mean(large):.2f}."
    yield f"Geometric mean of all kernels on 1 to 100,000 points: {mean(small):.2f}."


def accuracy(every: Iterable[Case]) -> Iterator[str]:
    """A table row for each kernel."""
    yield from table(ACCURACY)
    for case in every:
        found = measured(case, POINTS)
        place = ", ".join(f"{name} = {value:.3g}" for name, value in found.point.items())
        yield cells([case.id, f"{found.ulp:.2f}", str(case.kernel.ulp), f"{found.output} at {place}"])


TABLES = {
    "Speed: times as fast as SymPy's `lambdify(cse=True)` on so many points": speed,
    "Accuracy: the largest error found at random points and near degenerate ones": accuracy,
}


def main() -> None:
    """Measure and print; $BENCH_ONLY is the beginning of the title of the only table wanted."""
    every, only = list(cases().values()), os.environ.get("BENCH_ONLY", "")
    for title, measure in TABLES.items():
        if not title.lower().startswith(only.lower()):
            continue
        print(f"### {title}\n")
        if measure is speed:
            print(f"{limits()}\n")
        for line in measure(every):
            print(line, flush=True)
        print()


if __name__ == "__main__":
    with np.errstate(all="ignore"):
        main()
