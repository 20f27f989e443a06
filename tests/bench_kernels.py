"""Kernels against SymPy's `lambdify(cse=True)`: medians of interleaved runs, as ratios. Run by `make bench`."""

from __future__ import annotations

import gc
import os
import statistics
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sp
from bench import interleaved
from rich import box
from rich.console import Console
from rich.table import Table

from symcheck import kernels as generated
from symcheck import papers
from symcheck.codegen.kernel import Argument, Kernel
from symcheck.codegen.program import UNARY
from symcheck.evidence.kernels import declared, programs

SIZES = (0, 1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000)  # 0: Python floats
ROUNDS, SHORT = 5, 0.01
ANGLE = 1.2


def lambdified(kernel: Kernel) -> Callable[..., Any]:
    """The derived expressions as SymPy prints them for NumPy."""
    derived = kernel.derived()
    outputs = [derived[output.name] for output in kernel.outputs]
    letters = {symbol.name: symbol for expression in outputs for symbol in expression.free_symbols}
    arguments = [letters.get(argument.name, sp.Symbol(argument.name)) for argument in kernel.arguments]
    function: Callable[..., Any] = sp.lambdify(arguments, outputs, modules="numpy", cse=True)
    return function


def values(argument: Argument, size: int, rng: np.random.Generator) -> Any:
    """Points of the domain, away from its ends; one Python float for size 0."""
    low, high = 0.1, ANGLE if argument.unit == "rad" or argument.high else 2.0
    points = rng.uniform(low, high, size or 1)
    return points if size else float(points[0])


def rows() -> Iterator[tuple[str, int, float, list[float]]]:
    """Name, number of transcendental calls, seconds per point of a million, ratios by size."""
    rng = np.random.default_rng(2005)
    most = int(os.environ.get("BENCH_MOST", SIZES[-1]))
    for key in papers.load():
        for name, kernel in declared(key).items():
            ours, theirs = getattr(generated.load(key), name), lambdified(kernel)
            calls = sum(operation.function in UNARY for operation in programs(kernel)[0].operations)
            gc.freeze()  # what SymPy made need not be looked through before every run
            ratios, per_point = [], 0.0
            for size in (size for size in SIZES if size <= most):
                arguments = [values(argument, size, rng) for argument in kernel.arguments]
                with np.errstate(all="ignore"):
                    (own, _), (other, _) = interleaved(
                        ROUNDS, partial(ours, *arguments), partial(able(theirs, arguments), *arguments), short=SHORT
                    )
                ratios.append(other / own)
                per_point = own / size if size == 1_000_000 else per_point
            yield name, calls, per_point, ratios


def able(function: Callable[..., Any], arguments: Sequence[Any]) -> Callable[..., Any]:
    """The function, or one that takes no time if this one cannot do it: SymPy prints gamma for numbers only."""
    try:
        function(*arguments)
    except TypeError:
        return lambda *_: None
    return function


def limits() -> str:
    """What the machine gives: copying, a sine, a tangent, for each of ten million doubles."""
    source = np.random.default_rng(1).uniform(0.1, ANGLE, 10_000_000)
    target = np.empty_like(source)
    (copy, _), (sine, _), (tangent, _) = interleaved(
        ROUNDS, lambda: np.copyto(target, source), lambda: np.sin(source, target), lambda: np.tan(source, target)
    )
    per = 1e9 / source.size
    return (
        f"copy {16 / (copy * per):.1f} GB/s, sine {sine * per:.1f} ns, tangent {tangent * per:.1f} ns for each double"
        f"{'' if 'avx512' in Path('/proc/cpuinfo').read_text(encoding='utf-8') else '; no AVX-512'}"
    )


def main() -> None:
    """Measure and print."""
    out = Console(width=170, highlight=False)
    out.print(limits())
    table = Table(
        "kernel", "functions", "ns/point", *map(str, SIZES), box=box.SIMPLE_HEAD, title="times as fast as lambdify"
    )
    large: list[float] = []
    for name, calls, per_point, ratios in rows():
        table.add_row(
            name, str(calls), f"{per_point * 1e9:.1f}", *(f"{ratio:.2f}" if ratio > 0.01 else "-" for ratio in ratios)
        )
        large += [ratio for ratio in ratios[SIZES.index(1_000_000) :] if calls >= 2 and ratio > 0.01]
    out.print(table)
    if large:
        mean = statistics.geometric_mean(large)
        out.print(f"geometric mean from a million points on, kernels with two functions or more: {mean:.2f}")


if __name__ == "__main__":
    main()
