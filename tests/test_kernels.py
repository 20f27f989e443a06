"""Generated kernels give what they were derived from, however they are called; one changed token is noticed.

Values are compared with 50 digits of the derived expressions (`kernel_reference`). Each is within the `ulp` that its
kernel declares, so that two ways of calling one differ by twice that at most; in single precision, whose functions
NumPy computes less accurately, within twice that of its own last place.
"""

from __future__ import annotations

import ast
import doctest
import inspect
import math
import os
import random
import re
import subprocess
import sys
import threading
import tracemalloc
from collections.abc import Callable, Iterator
from functools import cache
from itertools import combinations, product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from click.testing import Result
from kernel_reference import (
    Case,
    Truth,
    arrays,
    cases,
    crowded_points,
    in_range,
    inside,
    random_points,
    worst,
)
from optimized import about_docstrings

from symcheck import kernels
from symcheck.audit import kernels as evidence
from symcheck.core.verdicts import SymcheckError
from symcheck.kernels import runtime
from symcheck.kernels.codegen.kernel import Argument, Kernel, Output, largest_addend
from symcheck.kernels.codegen.special import RUNTIME
from symcheck.kernels.codegen.target import MARK
from symcheck.kernels.runtime import BLOCK, SMALL
from symcheck.kernels.specification import specification
from symcheck.papers import load
from symcheck.proof import certificate
from symcheck.selftest.kernel_mutants import Forms, Mutant

CASES = cases()
FEW, MANY = 150, 100_000
MUTANTS = 200
SEEDS = 20
CONDITION = r"condition number is (\d+)"
OTHER = os.environ.get("SYMCHECK_OTHER_PYTHON", "")
SIZES = sorted(
    {
        1,
        2,
        3,
        7,
        97,
        runtime.FEW,
        runtime.FEW + 1,
        SMALL - 1,
        SMALL,
        SMALL + 1,
        BLOCK - 1,
        BLOCK,
        BLOCK + 1,
        2 * BLOCK + 1,
    }
)
EXTREMES = (0.0, -0.0, 1.0, 1e-300, -1e-300, 1e300, -1e300, math.inf, -math.inf, math.nan)
LITTLE = 10_000  # bytes of small objects


@pytest.fixture(autouse=True)
def quiet() -> Iterator[None]:
    """NumPy's warnings are the caller's: here nobody wants them."""
    with np.errstate(all="ignore"):
        yield


every_kernel = pytest.mark.parametrize("case", CASES.values(), ids=CASES.keys())


def generator(case: Case) -> np.random.Generator:
    """Random numbers of its own for each kernel, the same in every run."""
    return np.random.default_rng(list(case.id.encode()))


@cache
def sample(case: Case) -> Truth:
    """The values at some random points."""
    return case.truth(random_points(case.kernel, 97, generator(case)))


def tuple_of(results: Any) -> tuple[Any, ...]:
    return results if isinstance(results, tuple) else (results,)


def outs(case: Case, shape: Any, dtype: Any = np.float64) -> Any:
    """Arrays for `out=`, full of what no kernel gives."""
    made = tuple(np.full(shape, 7e77 if dtype == np.float64 else 7e33, dtype) for _ in case.kernel.outputs)
    return made if len(made) > 1 else made[0]


def agrees(case: Case, truth: Truth, results: Any, dtype: Any = np.float64) -> None:
    """The results have the right number, type and values."""
    results = tuple_of(results)
    assert len(results) == truth.high.shape[0]
    assert {np.asarray(x).dtype for x in results} == {np.dtype(dtype)}
    error, allowed = truth.error(results, dtype).max(initial=0), case.kernel.ulp * (1 if dtype == np.float64 else 2)
    assert error <= allowed


# --- accuracy


@every_kernel
@pytest.mark.parametrize("points", [random_points, crowded_points])
def test_errors_stay_below_what_the_docstring_says(case: Case, points: Any) -> None:
    truth = case.truth(points(case.kernel, FEW, generator(case)))
    found, allowed = worst(case, truth, arrays(case, truth.points)), case.kernel.ulp
    assert found.ulp <= allowed, found
    assert np.isnan(truth.high).mean() < 0.5  # what has no value is not compared


@every_kernel
@pytest.mark.parametrize("points", [random_points, crowded_points])
@pytest.mark.parametrize("size", [1, 3, 50])
def test_errors_stay_below_what_the_docstring_says_however_few_points_there_are(
    case: Case, points: Any, size: int
) -> None:
    truth = case.truth(points(case.kernel, FEW, generator(case)))
    parts = [tuple_of(case.function(*(x[n : n + size] for x in truth.points))) for n in range(0, FEW, size)]
    results = [np.concatenate(column) for column in zip(*parts, strict=True)]
    assert worst(case, truth, results).ulp <= case.kernel.ulp


@pytest.mark.slow
@every_kernel
@pytest.mark.parametrize("points", [random_points, crowded_points])
def test_errors_stay_below_what_the_docstring_says_at_many_points(case: Case, points: Any) -> None:
    truth = case.truth(points(case.kernel, MANY if points is random_points else MANY // 10, generator(case)))
    found, allowed = worst(case, truth, arrays(case, truth.points)), case.kernel.ulp
    assert found.ulp <= allowed, found


@every_kernel
def test_the_accuracy_that_is_allowed_is_not_more_than_is_agreed(case: Case) -> None:
    assert case.kernel.ulp <= 16


STATED = {id: int(found[1]) for id, case in CASES.items() if (found := re.search(CONDITION, case.kernel.condition))}


@pytest.mark.parametrize("id", STATED)
def test_the_condition_number_that_a_docstring_states_is_reached_and_not_exceeded(id: str) -> None:
    case = CASES[id]
    letters = [sp.Symbol(argument.name, real=True) for argument in case.kernel.arguments]
    numbers = []
    for point in zip(*random_points(case.kernel, 3, generator(case)), strict=True):
        values = dict(zip(letters, map(sp.Rational, point), strict=True))
        for e in case.derived:
            changes = (abs(x * e.diff(letter).subs(values)) for letter, x in values.items())
            numbers.append(float(sum(changes) / abs(e.subs(values))))
    assert max(numbers) == pytest.approx(STATED[id])


# --- ways of calling


@every_kernel
def test_numbers_give_numbers(case: Case) -> None:
    truth = sample(case)
    for kind in (float, np.float64):
        rows = [tuple_of(case.function(*map(kind, point))) for point in zip(*truth.points, strict=True)]
        assert all(isinstance(x, float) for row in rows for x in row)
        agrees(case, truth, tuple(np.array(column) for column in zip(*rows, strict=True)))


@every_kernel
def test_integers_are_numbers(case: Case) -> None:
    points = whole(case)
    truth = case.truth(tuple(column.astype(float) for column in points))
    agrees(case, truth, case.function(*points))
    rows = [tuple_of(case.function(*(x.item() for x in point))) for point in zip(*points, strict=True)]
    agrees(case, truth, tuple(np.array(column, float) for column in zip(*rows, strict=True)))


def whole(case: Case) -> list[Any]:
    """Some points with whole numbers where the domain has some."""
    found = list(random_points(case.kernel, 20, generator(case)))
    for n, column in enumerate(found):
        for rounded in (np.round(column), np.ceil(column)):
            tried = (*found[:n], rounded, *found[n + 1 :])
            if inside(case.kernel, tried).all() and np.abs(rounded).max() < 2**31:
                found[n] = rounded.astype(np.int64)
                break
    return found


@every_kernel
def test_arrays_of_any_size(case: Case) -> None:
    for size in SIZES:
        truth = sample(case).take(np.resize(np.arange(97), size))
        agrees(case, truth, case.function(*truth.points))
        out = outs(case, size)
        case.function(*truth.points, out=out)
        agrees(case, truth, out)


def _every_second(x: Any) -> Any:
    twice = np.full((x.shape[0], 2 * x.shape[1]), np.nan)
    twice[:, ::2] = x
    return twice[:, ::2]


LAYOUTS: dict[str, Callable[[Any], Any]] = {
    "C order": np.ascontiguousarray,
    "Fortran order": np.asfortranarray,
    "every second": _every_second,
    "backwards": lambda x: np.ascontiguousarray(x[::-1, ::-1])[::-1, ::-1],
    "other byte order": lambda x: x.astype(x.dtype.newbyteorder()),
    "read-only": lambda x: np.broadcast_to(x, x.shape),
}


@every_kernel
@pytest.mark.parametrize("shape", [(7, 13), (3, SMALL // 2)], ids=["small", "large"])
def test_arrays_of_any_layout(case: Case, shape: tuple[int, int]) -> None:
    truth = sample(case).take(np.resize(np.arange(97), shape[0] * shape[1]))
    for laid in LAYOUTS.values():
        columns = [laid(x.reshape(shape)) for x in truth.points]
        results = case.function(*columns)
        assert {x.shape for x in tuple_of(results)} == {shape}
        agrees(case, truth, results)


@every_kernel
def test_out_of_any_layout(case: Case) -> None:
    shape = (3, SMALL // 2)
    truth = sample(case).take(np.resize(np.arange(97), shape[0] * shape[1]))
    columns = [x.reshape(shape) for x in truth.points]
    for layout in ("Fortran order", "every second", "backwards"):
        out = [LAYOUTS[layout](x) for x in tuple_of(outs(case, shape))]
        case.function(*columns, out=out)
        agrees(case, truth, tuple(out))


@every_kernel
def test_results_share_memory_with_no_argument_and_with_one_another_only_where_the_formulas_are_equal(
    case: Case,
) -> None:
    derived = case.derived
    for size in (97, SMALL + 97):
        columns = sample(case).take(np.resize(np.arange(97), size)).points
        results = tuple_of(case.function(*columns))
        assert not any(np.shares_memory(x, y) for x, y in product(columns, results))
        for x, y in combinations(range(len(results)), 2):
            assert np.shares_memory(results[x], results[y]) == (derived[x] == derived[y])


@every_kernel
def test_arguments_broadcast(case: Case) -> None:
    count = len(case.kernel.arguments)
    columns = sample(case).points
    for n in range(count):
        single = [x[:5].reshape(5, 1) if i == n else x[6:7] for i, x in enumerate(columns)]
        numbers = [x if x.size == 5 or i % 2 else float(x[0]) for i, x in enumerate(single)]
        full = tuple(np.broadcast_to(x, (5, 1)).ravel() for x in single)
        if not inside(case.kernel, full).all():
            continue  # the domain is no box
        truth = case.truth(full)
        for mixed in (single, numbers):
            results = case.function(*mixed)
            assert {x.shape for x in tuple_of(results)} == {(5, 1)}
            agrees(case, truth, results)


@every_kernel
def test_a_row_against_a_column(case: Case) -> None:
    columns = [x[:12] for x in sample(case).points]
    grid = [x.reshape(12, 1) if n == 0 else x[:4] for n, x in enumerate(columns)]
    full = tuple(x.ravel() for x in np.broadcast_arrays(*grid))
    if not inside(case.kernel, full).all():
        pytest.skip("the domain is no box")
    out = outs(case, np.broadcast_shapes(*(x.shape for x in grid)))
    case.function(*grid, out=out)
    agrees(case, case.truth(full), out)


@every_kernel
def test_arrays_without_dimensions(case: Case) -> None:
    truth = sample(case).take([0])
    point = [np.array(x[0]) for x in truth.points]
    agrees(case, truth, case.function(*point))
    out = outs(case, ())
    case.function(*point, out=out)
    agrees(case, truth, out)


@every_kernel
def test_empty_arrays_give_empty_arrays(case: Case) -> None:
    for shape in ((0,), (3, 0), (0, 3, 2)):
        empty = [np.empty(shape) for _ in case.kernel.arguments]
        for results in (case.function(*empty), case.function(*empty, out=outs(case, shape))):
            assert [(x.shape, x.dtype) for x in tuple_of(results)] == [(shape, np.float64)] * len(case.kernel.outputs)


def short(case: Case) -> tuple[Any, ...]:
    """Points of single precision, whose range ends at 10^38: close to 1."""
    points = random_points(case.kernel, 97, generator(case), decades=0.5)
    return tuple(x.astype(np.float32) for x in points)


@every_kernel
def test_single_precision_stays_single(case: Case) -> None:
    points = short(case)
    truth = case.truth(tuple(x.astype(float) for x in points))
    agrees(case, truth, case.function(*points), np.float32)
    out = outs(case, 97, np.float32)
    case.function(*points, out=out)
    agrees(case, truth, out, np.float32)
    if len(points) > 1:
        agrees(case, truth, case.function(points[0].astype(float), *points[1:]))


@every_kernel
def test_numbers_do_not_widen_single_precision(case: Case) -> None:
    points = [x[:1] for x in short(case)]
    truth = case.truth(tuple(x.astype(float) for x in points))
    agrees(case, truth, case.function(points[0], *(float(x[0]) for x in points[1:])), np.float32)


@every_kernel
def test_out_may_be_an_input(case: Case) -> None:
    truth = sample(case).take(np.resize(np.arange(97), BLOCK + 97))
    last = len(case.kernel.outputs) - 1
    for n, place in product(range(len(truth.points)), {0, last}):
        columns = [x.copy() for x in truth.points]
        out = list(tuple_of(outs(case, BLOCK + 97)))
        out[place] = columns[n]
        case.function(*columns, out=out)
        agrees(case, truth, tuple(out))


@every_kernel
def test_out_may_overlap_an_input(case: Case) -> None:
    truth = sample(case)
    for n, column in enumerate(truth.points):
        memory = np.append(column, 0.0)
        columns = [memory[:-1] if i == n else x for i, x in enumerate(truth.points)]
        out = (memory[1:], *tuple_of(outs(case, 97))[1:])
        case.function(*columns, out=out)
        agrees(case, truth, out)


@every_kernel
def test_inputs_are_left_as_they_are(case: Case) -> None:
    truth = sample(case).take(np.resize(np.arange(97), BLOCK + 1))
    columns = [x.copy() for x in truth.points]
    case.function(*columns, out=outs(case, BLOCK + 1))
    assert all(np.array_equal(x, y) for x, y in zip(columns, truth.points, strict=True))


@every_kernel
def test_threads_do_not_disturb_one_another(case: Case) -> None:
    truth = sample(case).take(np.resize(np.arange(97), 4 * BLOCK))
    parts = np.array_split(np.arange(4 * BLOCK), 4)
    found: dict[int, Any] = {}

    def run(n: int) -> None:
        with np.errstate(all="ignore"):  # each thread has its own
            found[n] = tuple_of(case.function(*(x[parts[n]] for x in truth.points)))

    threads = [threading.Thread(target=run, args=(n,)) for n in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    results = [np.concatenate([found[n][k] for n in range(4)]) for k in range(len(case.kernel.outputs))]
    agrees(case, truth, tuple(results))


# --- what cannot be computed


def wrong_outs(case: Case) -> dict[str, tuple[Any, str]]:
    """Wrong `out` for arrays of 5, with what the message says."""
    right = tuple_of(outs(case, 5))
    many = "s" if len(right) > 1 else ""
    return {
        "too many": ((*right, np.empty(5)), f"out has {len(right) + 1} arrays"),
        "none at all": ((), "out has 0 arrays"),
        "of another shape": ((np.empty(6), *right[1:]), r"\(6,\).*\(5,\)"),
        "of more dimensions": ((np.empty((1, 5)), *right[1:]), r"\(1, 5\).*\(5,\)"),
        "of another type": ((np.empty(5, np.float32), *right[1:]), "float32.*float64"),
        "of integers": ((np.empty(5, int), *right[1:]), "int64.*float64"),
        "a list": (([0.0] * 5, *right[1:]), f"out is list|out has 5 array{many}"),
        "read-only": ((np.broadcast_to(0.0, 5), *right[1:]), "read-only"),
    }


@every_kernel
def test_a_wrong_out_is_reported(case: Case) -> None:
    columns = [x[:5] for x in sample(case).points]
    for out, words in wrong_outs(case).values():
        with pytest.raises(ValueError, match=words):
            case.function(*columns, out=out)


@every_kernel
def test_one_array_for_two_outputs_is_refused(case: Case) -> None:
    if len(case.kernel.outputs) == 1:
        pytest.skip("it has one output")
    one = np.empty(97)
    with pytest.raises(ValueError, match=r"twice|share memory"):
        case.function(*sample(case).points, out=[one] * len(case.kernel.outputs))


@every_kernel
def test_arguments_that_do_not_broadcast_are_refused(case: Case) -> None:
    if len(case.kernel.arguments) == 1:
        pytest.skip("it has one argument")
    columns = [x[:5] for x in sample(case).points]
    with pytest.raises(ValueError, match="broadcast"):
        case.function(*columns[:-1], columns[-1][:3])


@every_kernel
def test_complex_numbers_are_refused(case: Case) -> None:
    columns = [x[:5] for x in sample(case).points]
    for first in (columns[0] + 0j, complex(columns[0][0])):
        with pytest.raises(TypeError):
            case.function(first, *columns[1:])


@every_kernel
@pytest.mark.parametrize("size", sorted({5, SMALL + 5, BLOCK + 5}))
def test_nan_inputs_give_nan_outputs(case: Case, size: int) -> None:
    truth = sample(case).take(np.resize(np.arange(97), size))
    computed = case.kernel.accurate() if case.kernel.accurate else {}
    for n, argument in enumerate(case.kernel.arguments):
        columns = [x.copy() for x in truth.points]
        columns[n][3] = np.nan
        results = tuple_of(case.function(*columns))
        numbers = tuple_of(case.function(*(float(x[3]) for x in columns)))
        for output, form, result, number in zip(case.kernel.outputs, case.derived, results, numbers, strict=True):
            forms = (form, computed.get(output.name, form))
            if all(argument.name in {symbol.name for symbol in each.free_symbols} for each in forms):
                assert np.isnan(result[3]), (argument.name, output.name)
                assert math.isnan(number), (argument.name, output.name)
        others = np.delete(np.arange(size), 3)
        agrees(case, truth.take(others), tuple(result[others] for result in results))


@every_kernel
def test_extreme_arguments_do_not_raise_and_give_the_limit_or_nan(case: Case) -> None:
    rng = generator(case)
    count = 300
    ordinary = random_points(case.kernel, count, rng)
    points = tuple(np.where(rng.random(count) < 0.5, rng.choice(EXTREMES, count), x) for x in ordinary)
    results = tuple_of(case.function(*points))
    out = outs(case, count)
    case.function(*points, out=out)
    rows = [tuple_of(case.function(*map(float, point))) for point in zip(*points, strict=True)]
    kinds = {type(x): point for row, point in zip(rows, zip(*points, strict=True), strict=True) for x in row}
    assert kinds.keys() <= {float, np.float64}, kinds
    meant = np.flatnonzero(within_or_at_infinity(case.kernel, points))
    truth = case.truth(tuple(x[meant] for x in points))
    for found in (results, tuple_of(out), tuple(map(np.array, zip(*rows, strict=True)))):
        values = np.array([x[meant] for x in found])
        wrong = (truth.error(values) > case.kernel.ulp) & np.isfinite(values)
        for n in np.flatnonzero(wrong.any(axis=0)):
            point = [x[n] for x in truth.points]
            assert not in_range(case, point), (point, values[:, n], truth.high[:, n])


def within_or_at_infinity(kernel: Kernel, points: tuple[Any, ...]) -> Any:
    """Points of the domain, and those at which an argument is infinite where its domain has no end."""
    ends = [
        (column == np.inf) & (argument.high == "") | (column == -np.inf) & (argument.low == "")
        for argument, column in zip(kernel.arguments, points, strict=True)
    ]
    middle = random_points(kernel, points[0].size, np.random.default_rng(1))
    moved = [np.where(end, other, column) for end, other, column in zip(ends, middle, points, strict=True)]
    return inside(kernel, tuple(moved))


@pytest.mark.parametrize("size", [1, 3, 97, SMALL + 1])
def test_a_division_by_zero_warns_and_gives_infinity_however_few_points_there_are(size: int) -> None:
    inertia = CASES["esenkov2006:mode_inertia"].function
    columns = [np.full(size, 2.0), np.full(size, 3.0), np.zeros(size)]
    assert np.isposinf(inertia(*columns)).all()
    with np.errstate(divide="raise"), pytest.raises(FloatingPointError, match="divide by zero"):
        inertia(*columns)


@pytest.mark.parametrize("size", [1, 2, 3])
def test_an_overflow_warns_however_few_points_there_are(size: int) -> None:
    square = CASES["poloskov2004:mean_square_of_amplitude"].function
    columns = [np.full(size, 1.0), np.full(size, 1e300), np.full(size, 2.0)]
    assert np.isposinf(square(*columns)).all()
    with np.errstate(over="raise"), pytest.raises(FloatingPointError, match="overflow"):
        square(*columns)


# --- memory


@every_kernel
def test_with_out_given_nothing_is_allocated_that_grows(case: Case) -> None:
    for way in ("contiguous", "broadcast", "integers"):
        if way == "broadcast" and len(case.kernel.arguments) == 1:
            continue
        assert any(grows_little(case, way) for _ in range(3)), way  # other threads allocate now and then


def grows_little(case: Case, way: str) -> bool:
    _, once, twice = (peak(case, way, size) for size in (2 * BLOCK, 2 * BLOCK, 4 * BLOCK))
    return twice < once + LITTLE


def peak(case: Case, way: str, size: int) -> int:
    """Bytes allocated at most by one call."""
    columns = [np.resize(x, size) for x in sample(case).points]
    if way == "broadcast":
        columns[-1] = columns[-1][:1]
    if way == "integers":
        columns[0] = np.ones(size, np.int32)
    out = outs(case, size)
    tracemalloc.start()
    try:
        case.function(*columns, out=out)
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


# --- what is generated


def test_the_same_text_for_two_hash_seeds() -> None:
    some = [id for key in load() for id in [id for id in CASES if id.startswith(f"{key}:")][:2]]
    assert set(texts(range(1), some)) == {"".join(CASES[id].text for id in some)}


@pytest.mark.slow
def test_the_same_text_for_many_hash_seeds() -> None:
    assert len(set(texts(range(SEEDS), list(CASES)))) == 1


@pytest.mark.slow
@pytest.mark.skipif(not OTHER, reason="SYMCHECK_OTHER_PYTHON names no interpreter that has symcheck's dependencies")
def test_the_same_text_from_another_version_of_python() -> None:
    version = subprocess.run([OTHER, "--version"], capture_output=True, text=True, check=True).stdout
    assert version.split()[1] != sys.version.split()[0]
    assert texts(range(1), list(CASES), OTHER) == ["".join(case.text for case in CASES.values())]


def texts(seeds: range, ids: list[str], python: str = sys.executable) -> list[str]:
    """The text of some kernels, from an interpreter for each seed, two at a time."""
    program = "import sys; from kernel_reference import cases; " + (
        "sys.stdout.write(''.join(cases()[id].text for id in sys.argv[1:]))"
    )
    found = []
    for first in seeds[::2]:
        pair = [
            subprocess.Popen(
                [python, "-c", program, *ids],
                cwd=Path(__file__).parent,
                env={**os.environ, "PYTHONHASHSEED": str(seed), "PYTHONPATH": str(Path(__file__).parent.parent)},
                stdout=subprocess.PIPE,
                text=True,
            )
            for seed in seeds
            if seed in (first, first + 1)
        ]
        found += [process.communicate()[0] for process in pair]
        assert not any(process.returncode for process in pair)
    return found


@every_kernel
def test_the_text_names_no_version_and_no_place(case: Case) -> None:
    places = {np.__version__, sp.__version__, str(Path.home()), str(Path(__file__).parent)}
    assert not places & set(case.text.split())


@about_docstrings
@every_kernel
def test_the_docstring_says_what_goes_in_and_comes_out(case: Case) -> None:
    text = inspect.cleandoc(case.function.__doc__ or "")
    assert " ".join(text.split()).startswith(case.kernel.says)
    sections = dict(re.findall(r"^(\w+)\n-+\n(.*?)(?=^\w+\n-+\n|\Z)", text, re.DOTALL | re.MULTILINE))
    assert [*sections] == ["Parameters", "Returns", "Notes", "Examples"]
    entries = {name: re.findall(r"^(\w+) : (.*)\n    ", sections[name], re.MULTILINE) for name in [*sections][:2]}
    kind = "float or ndarray"
    assert entries["Parameters"][:-1] == [(each.name, kind) for each in case.kernel.arguments]
    assert entries["Returns"] == [(each.name, kind) for each in case.kernel.outputs]
    for each in (*case.kernel.arguments, *case.kernel.outputs):
        assert each.unit == "1" or f"in {each.unit}" in " ".join(text.split())
    assert f"Accuracy: {case.kernel.ulp} ulp" in text


@about_docstrings
@every_kernel
def test_the_example_of_a_docstring_is_right(case: Case) -> None:
    [example] = doctest.DocTestFinder(recurse=False).find(case.function, case.name, globs={})
    assert doctest.DocTestRunner().run(example) == (0, 2)


@every_kernel
def test_a_generated_module_says_what_the_kernel_declares(case: Case) -> None:
    said, kernel = specification(case.function), case.kernel
    assert (said.paper, said.name, said.ulp) == (case.paper, case.name, kernel.ulp)
    assert said.says == (kernel.says if sys.flags.optimize < 2 else "")  # it is the first line of the docstring
    assert (said.arguments, said.outputs) == (kernel.arguments, kernel.outputs)
    assert [*said.claims] == [f"{case.paper}:{number}" for number in kernel.claims]
    assert bool(said.forms) == bool(kernel.accurate)


@every_kernel
def test_a_formula_needs_no_more_than_math(case: Case) -> None:
    """Without the decorator a formula has no other name than those of its arguments, of `math` and of `ratios`."""
    module = ast.parse(case.text)
    for formula in [node for node in module.body if isinstance(node, ast.FunctionDef)]:
        formula.decorator_list = []
        names = [node for node in ast.walk(formula) if isinstance(node, ast.Name)]
        assigned = {node.id for node in names if isinstance(node.ctx, ast.Store)}
        taken = {each.arg for each in formula.args.args}
        assert taken == {each.name for each in case.kernel.arguments}
        assert {node.id for node in names} - assigned - taken <= {*RUNTIME, *vars(math)}


def test_no_line_of_a_module_is_long() -> None:
    for paper in load():
        lines = (kernels.folder() / f"{paper}.py").read_text(encoding="utf-8").splitlines()
        assert [line for line in lines if len(line) > 120] == []


def test_stubs_list_the_kernels_with_their_arguments() -> None:
    for paper in load():
        stub = ast.parse((kernels.folder() / f"{paper}.pyi").read_text(encoding="utf-8"))
        listed = [(node.name, node.args) for node in stub.body if isinstance(node, ast.FunctionDef)]
        assert [name for name, _ in listed[::2]] == [name for name, _ in listed[1::2]] == [*kernels.of_paper(paper)]
        for name, arguments in listed:
            said = specification(kernels.find(paper, name))
            assert [each.arg for each in arguments.args] == [each.name for each in said.arguments]


@pytest.mark.slow
def test_a_renamed_kernel_is_a_type_error(tmp_path: Path) -> None:
    pytest.importorskip("mypy", reason="mypy is not installed")
    program = tmp_path / "program.py"
    program.write_text(
        "from symcheck.generated import mirer2009\n"
        "x: float = mirer2009.product_of_axial_moment(1.0)\n"
        "y: float = mirer2009.bound_at_given_moment(3.0, 2.0, 1.0)\n"
        "z: float = mirer2009.bound_at_given_moment(3.0, 2.0, 1.0, 2.0)\n",
        encoding="utf-8",
    )
    command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path / "cache"), str(program)]
    root = Path(__file__).parent.parent
    found = subprocess.run(command, cwd=root, capture_output=True, text=True, timeout=300, check=False)
    told = [line for line in found.stdout.splitlines() if "error:" in line]
    assert [line.partition("error: ")[2].split("  [")[1] for line in told] == ["attr-defined]", "call-overload]"]
    assert 'did you mean "product_of_axial_moments"' in told[0].replace("maybe ", "did you mean ")


X = sp.Symbol("x", real=True)
TOY = Kernel(
    says="A square less a number.",
    arguments=(Argument("x", "a number"),),
    outputs=(Output("y", "another"),),
    derived=lambda: {"y": X**2 - 1},
    claims=("1.1",),
)
FALSE = {
    "a wrong sign": X**2 + 1,
    "a wrong number": (X - 1) * (X + 2),
    "right at some points": sp.sqrt(X**4 - 2 * X**2 + 1),
    "right where it is defined": (X**2 - 1) * X / X**2,
}


@pytest.fixture
def declares(monkeypatch: pytest.MonkeyPatch, symcheck: Callable[..., Result]) -> Callable[..., Callable[..., Result]]:
    """Let the toy paper declare a kernel; then its command line."""

    def declare(**changes: Any) -> Callable[..., Result]:
        from dataclasses import replace

        kernel = replace(TOY, **changes)
        monkeypatch.setattr(evidence, "declared", lambda key: {"square": kernel} if key == "toy" else {})
        return symcheck

    return declare


def test_a_kernel_whose_claim_is_proved_is_written(declares: Any, toy: Path) -> None:
    assert declares(accurate=lambda: {"y": (X - 1) * (X + 1)})("generate").exit_code == 0
    text = (toy / "generated" / "toy.py").read_text(encoding="utf-8")
    assert 'claims={"1.1": "' in text
    assert 'forms="' in text  # the digest of their proofs
    assert '"toy:square.y"' in (toy / "generated" / "certificates" / "toy.json").read_text(encoding="utf-8")


def test_a_form_whose_proof_the_checker_refuses_is_not_written(
    declares: Any, toy: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(evidence, "certificate", lambda *_: {**certificate(*_), "claim": ["=", "x", 1]})
    result = declares(accurate=lambda: {"y": (X - 1) * (X + 1)})("generate")
    assert result.exit_code == 2
    assert "toy:square.y: the certificate was not accepted (" in result.stderr
    assert not (toy / "generated").exists()


@pytest.mark.parametrize("form", FALSE.values(), ids=FALSE.keys())
def test_a_form_that_is_not_proved_equal_is_not_written(form: Any, declares: Any, toy: Path) -> None:
    result = declares(accurate=lambda: {"y": form})("generate")
    assert result.exit_code == 2
    assert "toy:square.y: the accurate form is not proved equal to the derived one" in result.stderr
    assert result.stderr.count("\n") == 1
    assert not (toy / "generated").exists()


@pytest.mark.parametrize(
    ("claims", "words"),
    [
        (("1.3",), "kernel square rests on toy:1.3, which is refuted"),
        (("1.1", "1.4"), "kernel square rests on toy:1.4, which is undecided"),
        (("1.7",), "kernel square rests on toy:1.7, which is not declared"),
        (("1.5",), "kernel square rests on toy:1.5"),
    ],
)
def test_a_kernel_that_rests_on_what_is_not_proved_is_not_written(
    claims: tuple[str, ...], words: str, declares: Any, toy: Path
) -> None:
    result = declares(claims=claims)("generate")
    assert result.exit_code == 2
    assert words in result.stderr
    assert "only what is proved is generated" in result.stderr
    assert result.stderr.count("\n") == 1
    assert not (toy / "generated").exists()


def test_an_output_that_is_an_argument_is_not_written(declares: Any) -> None:
    result = declares(outputs=(Output("y", "another"), Output("z", "itself")), derived=lambda: {"y": X**2, "z": X})(
        "generate"
    )
    assert result.exit_code == 2
    assert "z is an argument or a number; leave it to the caller" in result.stderr


def test_a_claim_of_several_links_is_proved_if_all_links_are(declares: Any) -> None:
    assert declares(claims=("1.2",))("generate").exit_code == 0


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"outputs": (Output("x", "another"),)}, "declares x twice"),
        ({"claims": ()}, "names no claims"),
        ({"ulp": 9}, "allows 9 ulp; say why"),
        ({"scale": lambda: {"y": X}}, "counts ulp of a scale; say of which"),
    ],
)
def test_a_declaration_that_cannot_be_is_refused(changes: dict[str, Any], words: str, declares: Any) -> None:
    with pytest.raises(SymcheckError, match=words):
        declares(**changes)


def test_the_scale_of_a_sum_is_its_largest_term() -> None:
    y = sp.Symbol("y", real=True)
    assert largest_addend(X**2 - 3 * y) == sp.Max(X**2, 3 * sp.Abs(y))
    assert largest_addend(X * y) == sp.Abs(X * y)


# --- symcheck generate --check


@pytest.fixture
def written(declares: Any, toy: Path) -> tuple[Callable[..., Result], Path]:
    """The command line after everything was written, and the folder."""
    run = declares()
    assert run("generate").exit_code == 0
    return run, toy / "generated"


def test_a_changed_kernel_is_shown_as_a_patch_that_mends_it(written: Any) -> None:
    run, folder = written
    file = folder / "toy.py"
    right = file.read_bytes()
    file.write_bytes(right.replace(b"1.0", b"3.0", 1))
    result = run("generate", "--check")
    assert result.exit_code == 1
    assert "generated/toy.py: differs from line " in result.stderr
    assert "run `symcheck generate`" in result.stderr
    assert "--- a/generated/toy.py\n+++ b/generated/toy.py\n" in result.stdout
    old, new = [line for line in result.stdout.splitlines()[2:] if line[:1] in "+-"]
    assert (old[0], new[0], old[1:].replace("3.0", "1.0", 1)) == ("-", "+", new[1:])
    subprocess.run(["git", "apply", "-"], cwd=folder.parent, input=result.stdout, text=True, check=True)
    assert file.read_bytes() == right


def test_a_lost_last_line_end_is_mended_by_the_patch(written: Any) -> None:
    run, folder = written
    right = (folder / "toy.py").read_bytes()
    (folder / "toy.py").write_bytes(right[:-1])
    patch = run("generate", "--check").stdout
    subprocess.run(["git", "apply", "-"], cwd=folder.parent, input=patch, text=True, check=True)
    assert (folder / "toy.py").read_bytes() == right


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("gone.py", "superfluous"),
        ("certificates/gone.json", "superfluous"),
        ("coq/gone.json", "superfluous"),
        ("mine.py", "unknown; no command writes it, so remove it"),
        ("notes.txt", "unknown; no command writes it, so remove it"),
        ("certificates/notes.md", "unknown; no command writes it, so remove it"),
        ("deeper/toy.py", "unknown; no command writes it, so remove it"),
        (".toy.py.123", "unknown; no command writes it, so remove it"),
    ],
)
def test_a_stale_or_unknown_file_is_reported(name: str, told: str, written: Any) -> None:
    run, folder = written
    (folder / name).parent.mkdir(exist_ok=True)
    (folder / name).write_text(f'"""{MARK}"""\n' if name == "gone.py" else "text")
    result = run("generate", "--check")
    assert result.exit_code == 1
    assert f"generated/{name}: {told}" in result.stderr
    assert result.stdout == ""
    assert ("run `symcheck generate`" in result.stderr) == (told == "superfluous")
    assert run("generate").exit_code == (0 if told == "superfluous" else 1)
    assert (folder / name).exists() == (told != "superfluous")


def test_a_lost_kernel_file_is_reported(written: Any) -> None:
    run, folder = written
    (folder / "toy.py").unlink()
    result = run("generate", "--check")
    assert (result.exit_code, result.stdout) == (1, "")
    assert "generated/toy.py: missing" in result.stderr


def test_what_python_compiled_is_not_unknown(written: Any) -> None:
    run, folder = written
    (folder / "__pycache__").mkdir()
    (folder / "__pycache__" / "toy.cpython-311.pyc").write_text("")
    (folder / "__init__.py").write_text("")
    assert run("generate", "--check").exit_code == 0


# --- one changed token


@cache
def forms(case: Case) -> tuple[Forms, list[Mutant]]:
    found = Forms(case)
    return found, list(found.mutants())


@cache
def handful(case: Case) -> Truth:
    return sample(case).take(np.arange(5))


def uncaught(case: Case, mutant: Mutant) -> bool:
    """Whether a mutant gives the right values at a handful of points, and is not proved to be the same."""
    found, _ = forms(case)
    return found.survives(mutant, handful(case)) and not found.equivalent(mutant)


@every_kernel
def test_all_forms_as_they_are_give_the_right_values(case: Case) -> None:
    found, mutants = forms(case)
    assert [form for form in found.forms if not found.right(form, handful(case))] == []
    assert {mutant.form for mutant in mutants} == {*found.forms}


def test_one_changed_token_is_noticed() -> None:
    everything = [(case, mutant) for case in CASES.values() for mutant in forms(case)[1]]
    drawn = random.Random(0).sample(everything, min(MUTANTS, len(everything)))
    assert [f"{case.id} {mutant}" for case, mutant in drawn if uncaught(case, mutant)] == []


@pytest.mark.slow
@every_kernel
def test_every_changed_token_is_noticed(case: Case) -> None:
    assert [str(mutant) for mutant in forms(case)[1] if uncaught(case, mutant)] == []
