"""The largest error of each kernel, and where it is.

python -m tests.kernel_reference [PAPER]
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from symcheck.kernels.codegen.kernel import Kernel
from symcheck.selftest.kernel_points import Columns, crowded_points, inside, random_points
from symcheck.selftest.kernel_truth import Case, Truth, cases

__all__ = [
    "Case", "Truth", "Worst", "arrays", "cases", "crowded_points", "in_range", "inside", "measured", "random_points",
    "table", "unbounded", "worst",
]  # fmt: skip


def arrays(case: Case, points: Columns) -> Sequence[Any]:
    """The results at some points, computed as those of many points are."""
    with np.errstate(all="ignore"):
        found = case.function.ways.of_anything(points, many=True)
    return found if isinstance(found, tuple) else (found,)


def in_range(case: Case, point: Sequence[float]) -> bool:
    """Whether no intermediate value at a point leaves the range of doubles."""
    with np.errstate(all="raise"):
        try:
            case.of_many(*np.array(point).reshape(-1, 1))
        except (FloatingPointError, ZeroDivisionError):
            return False
    return True


def unbounded(kernel: Kernel) -> bool:
    """Whether the domain of an argument is unbounded, so that products and powers of it may overflow."""
    return any(not (argument.low and argument.high) for argument in kernel.arguments)


class Worst(NamedTuple):
    """The largest error of one output, in units of the last place, and the point where it is."""

    ulp: float
    output: str
    point: dict[str, float]


def worst(case: Case, truth: Truth, results: Sequence[Any]) -> Worst:
    """The largest error; points where an unbounded argument takes intermediate values out of range do not count."""
    error = truth.error(results)
    for n in np.flatnonzero((error > case.kernel.ulp).any(axis=0) & unbounded(case.kernel)):
        if not in_range(case, [x[n] for x in truth.points]):
            error[:, n] = 0
    row, column = np.unravel_index(np.argmax(error), error.shape)
    names = [argument.name for argument in case.kernel.arguments]
    point = {name: float(x[column]) for name, x in zip(names, truth.points, strict=True)}
    return Worst(float(error[row, column]), case.kernel.outputs[row].name, point)


def measured(case: Case, count: int, seed: int = 0) -> Worst:
    """The largest error at `count` random points and as many crowded ones."""
    found = []
    for points in (random_points, crowded_points):
        truth = case.truth(points(case.kernel, count, np.random.default_rng(seed)))
        found.append(worst(case, truth, arrays(case, truth.points)))
    return max(found)


def table(papers: Sequence[str] = (), count: int = 2000) -> Iterator[str]:
    """A line for each kernel: its largest error, how much is allowed, and where it is."""
    for case in cases().values():
        if not papers or case.paper in papers:
            found = measured(case, count)
            place = ", ".join(f"{name} = {value:.17g}" for name, value in found.point.items())
            yield f"{case.id:<52} {found.ulp:>8.2f} of {case.kernel.ulp:<3} ulp   {found.output} at {place}"


if __name__ == "__main__":
    for line in table(sys.argv[1:]):
        print(line, flush=True)
