"""Calls as people make them: numbers, arrays beside numbers, shapes that broadcast, `out=`, against SymPy's `lambdify`.

Prints, for each mix and size, how many times as fast as `lambdify(cse=True)` the kernels are: the geometric mean over
all of them, the median, and the worst with its name. In every round each runs once, in turn; the medians of the times
of the thread are compared, which other programs on the machine change least. Where outputs do not depend on the arrays
`lambdify` returns numbers; the kernels fill arrays. What NumPy is called for alone is the operations of a kernel one
after another, each a call of NumPy, with nothing around them: no way to call them takes less. $BENCH_ONLY is part of
the name of the kernels wanted, $BENCH_PART the beginning of the rows wanted.
"""

from __future__ import annotations

import gc
import os
import statistics
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np
import sympy as sp
from bench_kernels import lambdified, values
from kernel_reference import Case, cases

from symcheck.kernels.runtime import DOUBLE, FEW, SMALL
from symcheck.views.figures import cells, table

SIZES = (1, 100, 1_000, 10_000, 1_000_000, 10_000_000)
MOST = int(os.environ.get("BENCH_MOST", 1_000_000))
ROUNDS, SHORT = 5, 0.001
ALONE = "arrays of one shape, what NumPy is called for alone"
HEAD = ("arguments", "points", "geometric mean", "median", "worst", "of")
Columns = Sequence[Any]


def number(x: Any) -> float:
    """The first of some numbers."""
    return float(x[0])


def beside(columns: Columns, places: Callable[[int], bool]) -> list[Any]:
    """Arrays at some places, numbers at the others."""
    return [x if places(k) else number(x) for k, x in enumerate(columns)]


def strided(x: Any) -> Any:
    """The same numbers in every second place."""
    return np.repeat(x, 2)[::2]


def grid(columns: Columns) -> list[Any]:
    """The first as a column, the others as rows, of about as many points together."""
    side = max(1, round(columns[0].size ** 0.5))
    return [columns[0][:side, None], *(x[:side] for x in columns[1:])]


MIXES: Mapping[str, Callable[[Columns], list[Any]]] = {
    "arrays of one shape": list,
    ALONE: list,
    "the first an array, the rest numbers": lambda columns: beside(columns, lambda k: not k),
    "the last an array, the rest numbers": lambda columns: beside(columns, lambda k: k == len(columns) - 1),
    "one number, the rest arrays": lambda columns: beside(columns, lambda k: k < len(columns) - 1 or not k),
    "a column against rows": grid,
    "arrays of one shape, `out=`": list,
    "float32": lambda columns: [x.astype(np.float32) for x in columns],
    "every second element": lambda columns: [strided(x) for x in columns],
}
NUMBERS: Mapping[str, Callable[[Columns], list[Any]]] = {
    "numbers": lambda point: [*point],
    "numbers, against `lambdify(modules='math')`": lambda point: [*point],
    "np.float64": lambda point: [np.float64(x) for x in point],
    "one int, the rest floats": lambda point: [max(1, round(point[0])), *point[1:]],
}


def with_math(case: Case) -> Callable[..., Any]:
    """The derived expressions as SymPy prints them for `math`."""
    letters = {symbol.name: symbol for expression in case.derived for symbol in expression.free_symbols}
    arguments = [letters.get(each.name, sp.Symbol(each.name)) for each in case.kernel.arguments]
    function: Callable[..., Any] = sp.lambdify(arguments, case.derived, modules="math", cse=True, dummify=True)
    return function


def ratio(ours: Callable[[], Any], theirs: Callable[[], Any]) -> float | None:
    """Times as fast; None where theirs raises, as `math` does where a power of 0 beside a factor of 0 means 1."""
    try:
        theirs()
    except (ArithmeticError, ValueError):
        return None
    for _ in range(2):
        ours()  # which prepares for such a mix
    timed = [(function, max(1, int(SHORT / min(per_call(function, 2), SHORT)))) for function in (ours, theirs)]
    runs = [[per_call(function, count) for function, count in timed] for _ in range(ROUNDS)]
    own, other = map(statistics.median, zip(*runs, strict=True))
    found: float = other / own
    return found


def per_call(function: Callable[[], Any], count: int) -> float:
    """Seconds of the thread for each of some calls; the clock takes as long as a call does, and is read twice."""
    start = time.thread_time()
    for _ in range(count):
        function()
    return (time.thread_time() - start) / count


def into(theirs: Callable[..., Any], out: Sequence[Any], *arguments: Any) -> None:
    """What `out=` does, for a function that has none."""
    for each, result in zip(out, theirs(*arguments), strict=True):
        each[...] = result


def of_mix(case: Case, name: str, theirs: Callable[..., Any], size: int) -> float | None:
    """Times as fast on one mix of so many points."""
    arguments = MIXES[name](values(case, size))
    if name == ALONE:
        plan = case.function.ways.plan(size > FEW, (1,) * len(arguments), 1, DOUBLE)
        return ratio(partial(plan.whole, *arguments), partial(theirs, *arguments))
    if "out=" not in name:
        return ratio(partial(case.function, *arguments), partial(theirs, *arguments))
    out = tuple(np.empty(size) for _ in case.kernel.outputs)
    return ratio(partial(case.function, *arguments, out=out), partial(into, theirs, out, *arguments))


def of_numbers(case: Case, name: str, theirs: Callable[..., Any]) -> float | None:
    """Times as fast at one point."""
    arguments = NUMBERS[name](values(case, 0))
    return ratio(partial(case.function, *arguments), partial(theirs, *arguments))


def row(name: str, points: str, measured: Mapping[str, float | None]) -> str:
    """What the kernels come to."""
    found = {id: x for id, x in measured.items() if x is not None}
    worst = min(found, key=lambda id: found[id])
    mean, median = statistics.geometric_mean(found.values()), statistics.median(found.values())
    return cells([name, points, f"{mean:.2f}", f"{median:.2f}", f"{found[worst]:.2f}", worst])


def rows() -> Iterator[str]:
    """The table, as it is measured."""
    every = [case for case in cases().values() if os.environ.get("BENCH_ONLY", "") in case.id]
    theirs = {case.id: lambdified(case) for case in every}
    plain = {case.id: with_math(case) for case in every}
    gc.collect()
    gc.disable()  # nothing here makes cycles
    yield from table(HEAD)
    part = os.environ.get("BENCH_PART", "")
    for name in filter(lambda name: name.startswith(part), NUMBERS):
        other = plain if "'math'" in name else theirs
        yield row(name, "1", {case.id: of_numbers(case, name, other[case.id]) for case in every})
    for name in filter(lambda name: name.startswith(part), MIXES):
        for size in [size for size in SIZES if size <= (SMALL if name == ALONE else MOST)]:
            chosen = [case for case in every if len(case.kernel.arguments) > 1 or name.startswith("arrays")]
            yield row(name, f"{size:,}", {case.id: of_mix(case, name, theirs[case.id], size) for case in chosen})


def main() -> None:
    """Measure and print."""
    for line in rows():
        print(line, flush=True)


if __name__ == "__main__":
    with np.errstate(all="ignore"):
        main()
