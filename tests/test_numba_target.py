"""Kernels for Numba give what they were derived from, as the NumPy kernels do, however they are called.

Each is within the `ulp` that its kernel declares: the functions for loops err by one unit of the last place at most
where NumPy's err by half of one, and no kernel needs more room for that. Compiling a loop takes half a second: without
the slow tests loops are those of a few kernels, which call every function between them, and numbers are those of all.
"""

from __future__ import annotations

import math
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from functools import cache
from importlib.util import module_from_spec, spec_from_file_location
from inspect import signature
from itertools import combinations
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from flint import arb, ctx
from kernel_reference import Case, Truth, cases, crowded_points, in_range, inside, random_points, worst

from symcheck.core.verdicts import SymcheckError
from symcheck.kernels.codegen import numba_functions, numba_target
from symcheck.kernels.codegen.program import UNARY, Operation, Program
from symcheck.kernels.codegen.target import MARK, CompiledKernel

numba = pytest.importorskip("numba")

CASES = cases()
FEW, MANY = 60, 20_000
EXTREMES = (0.0, -0.0, 1.0, 1e-300, -1e-300, 1e300, -1e300, math.inf, -math.inf, math.nan)
FAR = (1e3, 1234.5, -1e6, 1e15, 1e300)  # angles beyond those that the functions for loops take
FUNCTIONS: dict[str, tuple[Callable[[arb], arb], float, float, float]] = {  # ends of the range, errors in ulp
    "sin": (arb.sin, -1000.0, 1000.0, 1.0),
    "cos": (arb.cos, -1000.0, 1000.0, 1.0),
    "tan": (arb.tan, -1000.0, 1000.0, 2.0),
    "arctan": (arb.atan, -1e300, 1e300, 1.0),
    "exp": (arb.exp, -707.0, 707.0, 1.0),
    "expm1": (arb.expm1, -707.0, 707.0, 1.6),
    "log": (arb.log, 1e-300, 1e300, 1.0),
    "log1p": (arb.log1p, -1.0 + 1e-15, 1e300, 1.0),
}


def functions(case: Case) -> set[str]:
    """The functions that the program of a kernel calls."""
    return {operation.function for operation in case.compiled.pointwise.operations}


def features(case: Case) -> set[str]:
    """The same, and whether some outputs are equal."""
    values = list(case.compiled.pointwise.outputs.values())
    return functions(case) | ({"equal outputs"} if len(set(values)) < len(values) else set())


@cache
def sample() -> frozenset[str]:
    """A few kernels that have all features between them."""
    wanted, found = set().union(*map(features, CASES.values())), set()
    while wanted:
        best = max(CASES.values(), key=lambda case: len(features(case) & wanted) - len(case.kernel.outputs) / 100)
        found.add(best.id)
        wanted -= features(best)
    return frozenset(found)


every_number = pytest.mark.parametrize("case", CASES.values(), ids=CASES.keys())
few = pytest.mark.parametrize("case", [CASES[id] for id in sorted(sample())], ids=sorted(sample()))
every_loop = pytest.mark.parametrize(
    "case",
    [pytest.param(case, id=id, marks=[] if id in sample() else pytest.mark.slow) for id, case in CASES.items()],
)


@cache
def texts() -> dict[str, str]:
    """The files of all papers."""
    made: dict[str, dict[str, CompiledKernel]] = {}
    for case in CASES.values():
        made.setdefault(case.paper, {})[case.name] = case.compiled
    return {
        name: text for key, kernels in made.items() for name, text in numba_target.TARGET.files(key, kernels).items()
    }


@pytest.fixture(scope="session")
def modules(tmp_path_factory: pytest.TempPathFactory) -> dict[str, ModuleType]:
    """The modules of all papers."""
    folder = tmp_path_factory.mktemp("numba")
    return {Path(name).stem: module(folder / name, text) for name, text in texts().items()}


def module(file: Path, text: str) -> ModuleType:
    """A text as a module of that file."""
    file.write_text(text, encoding="utf-8")
    spec = spec_from_file_location(f"{file.parent.name}_{file.stem}", file)
    assert spec is not None
    assert spec.loader is not None
    made = sys.modules[spec.name] = module_from_spec(spec)  # Numba looks for it there
    spec.loader.exec_module(made)
    return made


@pytest.fixture
def call(case: Case, modules: dict[str, ModuleType]) -> Callable[..., tuple[Any, ...]]:
    """The kernel; its results always as a tuple."""
    function = getattr(modules[case.paper], case.name)
    return lambda *arguments, **options: tuple_of(function(*arguments, **options))


@pytest.fixture(autouse=True)
def quiet() -> Iterator[None]:
    """NumPy's warnings are no matter here."""
    with np.errstate(all="ignore"):
        yield


def generator(case: Case) -> np.random.Generator:
    return np.random.default_rng(list(case.id.encode()))


@cache
def truth_of(case: Case) -> Truth:
    """The values at some random points."""
    return case.truth(random_points(case.kernel, 97, generator(case)))


def tuple_of(results: Any) -> tuple[Any, ...]:
    return results if isinstance(results, tuple) else (results,)


def by_numbers(call: Callable[..., Any], points: Any) -> tuple[Any, ...]:
    """The results at each point, as arrays."""
    return tuple(map(np.array, zip(*(call(*map(float, point)) for point in zip(*points, strict=True)), strict=True)))


def agrees(case: Case, truth: Truth, results: Any, dtype: Any = np.float64) -> None:
    """The results have the right number, type and values."""
    assert len(results) == len(case.kernel.outputs)
    assert {np.asarray(x).dtype for x in results} == {np.dtype(dtype)}
    assert truth.error(results, dtype).max(initial=0) <= case.kernel.ulp


def outs(case: Case, shape: Any, dtype: Any = np.float64) -> Any:
    """Arrays for `out=`, full of what no kernel gives."""
    made = tuple(np.full(shape, 7e33, dtype) for _ in case.kernel.outputs)
    return made if len(made) > 1 else made[0]


# --- values


@every_number
def test_the_text_of_every_kernel_is_right_as_plain_python(case: Case, modules: dict[str, ModuleType]) -> None:
    if functions(case) & {*numba_target.BUILT_ON}:
        pytest.skip("compiled functions that it calls take no function of Python's")
    core = getattr(modules[case.paper], f"_{case.name}").py_func
    names = list(signature(core).parameters)[len(case.kernel.arguments) :]
    library = [getattr(math, numba_target.LIBRARY.get(name, name)) for name in names]
    truth = case.truth(random_points(case.kernel, 10, generator(case)))
    rows = [tuple_of(core(*map(float, point), *library)) for point in zip(*truth.points, strict=True)]
    values = list(case.compiled.pointwise.outputs.values())
    places = [list(dict.fromkeys(values)).index(value) for value in values]
    found = worst(case, truth, [np.array([row[place] for row in rows]) for place in places])
    assert found.ulp <= case.kernel.ulp, found


@every_loop
def test_numbers_give_numbers_that_are_right(case: Case, call: Any) -> None:
    truth = case.truth(random_points(case.kernel, 10, generator(case)))
    assert {type(x) for x in call(*(float(x[0]) for x in truth.points))} == {float}
    found = worst(case, truth, by_numbers(call, truth.points))
    assert found.ulp <= case.kernel.ulp, found


@every_loop
@pytest.mark.parametrize("points", [random_points, crowded_points])
def test_errors_stay_below_what_the_docstring_says(case: Case, call: Any, points: Any) -> None:
    truth = case.truth(points(case.kernel, FEW, generator(case)))
    found = worst(case, truth, call(*truth.points))
    assert found.ulp <= case.kernel.ulp, found


@pytest.mark.slow
@every_number
@pytest.mark.parametrize("points", [random_points, crowded_points])
def test_errors_stay_below_what_the_docstring_says_at_many_points(case: Case, call: Any, points: Any) -> None:
    truth = case.truth(points(case.kernel, MANY // (1 if points is random_points else 10), generator(case)))
    found = worst(case, truth, call(*truth.points))
    assert found.ulp <= case.kernel.ulp, found


@every_loop
def test_large_arrays_are_those_of_the_numpy_kernel(case: Case, call: Any) -> None:
    points = random_points(case.kernel, 5000, generator(case))
    scales = [np.abs(x) for x in tuple_of(case.function(*points))]
    exact = case.kernel.scale is None
    for ours, theirs, size in zip(call(*points), tuple_of(case.function(*points)), scales, strict=True):
        np.testing.assert_array_equal(np.isnan(ours), np.isnan(theirs))
        if exact:
            near = np.abs(ours - theirs) <= 2 * case.kernel.ulp * np.spacing(size)
            assert (near | (ours == theirs) | np.isnan(theirs)).all()


def extreme(case: Case) -> tuple[Any, ...]:
    """Points some of whose numbers are extreme."""
    rng, count = generator(case), 300
    ordinary = random_points(case.kernel, count, rng)
    return tuple(np.where(rng.random(count) < 0.4, rng.choice(EXTREMES, count), x) for x in ordinary)


def right_at_extremes(case: Case, points: Any, results: tuple[Any, ...]) -> None:
    """In the domain what is finite is right, unless a value on the way is out of range; no number gives none."""
    meant = np.flatnonzero(inside(case.kernel, points))
    truth, values = case.truth(tuple(x[meant] for x in points)), np.array([x[meant] for x in results])
    wrong = (truth.error(values) > case.kernel.ulp) & np.isfinite(values)
    for n in np.flatnonzero(wrong.any(axis=0)):
        assert not in_range(case, [x[n] for x in truth.points]), ([x[n] for x in truth.points], values[:, n])
    for ours, theirs in zip(results, tuple_of(case.function(*points)), strict=True):
        absent = np.isnan(np.array(points)).any(axis=0)
        np.testing.assert_array_equal(np.isnan(ours)[absent], np.isnan(theirs)[absent])


@every_loop
def test_extreme_numbers_give_the_limit_or_nan(case: Case, call: Any) -> None:
    points = tuple(x[:20] for x in extreme(case))
    right_at_extremes(case, points, by_numbers(call, points))


@every_loop
def test_extreme_arrays_give_the_limit_or_nan(case: Case, call: Any) -> None:
    points = extreme(case)
    right_at_extremes(case, points, call(*points))


@every_loop
def test_a_point_that_the_functions_for_loops_cannot_do_is_left_to_the_library(case: Case, call: Any) -> None:
    if not functions(case) & {"sin", "cos", "tan"}:
        pytest.skip("it has no angles")
    points = [np.resize(x, 3000) for x in truth_of(case).points]
    for n, argument in enumerate(case.kernel.arguments):
        if argument.unit == "rad":
            points[n][7 :: 300 + n] = np.resize(FAR, points[n][7 :: 300 + n].size)
    for ours, theirs in zip(call(*points), by_numbers(call, points), strict=True):
        far = np.any([np.abs(x) > numba_functions.FAR for x in points], axis=0)
        np.testing.assert_array_equal(ours[far], theirs[far])
        assert np.isfinite(ours[~far]).all()


# --- ways of calling


LAYOUTS: dict[str, Callable[[Any], Any]] = {
    "Fortran order": np.asfortranarray,
    "every second": lambda x: np.repeat(x, 2, axis=1)[:, ::2],
    "backwards": lambda x: np.ascontiguousarray(x[::-1, ::-1])[::-1, ::-1],
    "other byte order": lambda x: x.astype(x.dtype.newbyteorder()),
    "read-only": lambda x: np.broadcast_to(x, x.shape),
    "not aligned": lambda x: np.frombuffer(b"." + x.tobytes(), np.float64, offset=1).reshape(x.shape),
}


@few
@pytest.mark.parametrize("layout", LAYOUTS)
def test_arrays_of_any_layout(case: Case, call: Any, layout: str) -> None:
    truth = truth_of(case).take(np.resize(np.arange(97), 3 * 2000))
    agrees(case, truth, call(*(LAYOUTS[layout](x.reshape(3, 2000)) for x in truth.points)))
    if layout in ("Fortran order", "every second", "backwards"):
        out = tuple(LAYOUTS[layout](x) for x in tuple_of(outs(case, (3, 2000))))
        call(*(x.reshape(3, 2000) for x in truth.points), out=out)
        agrees(case, truth, out)


@few
def test_arguments_broadcast(case: Case, call: Any) -> None:
    columns = truth_of(case).points
    for n in range(len(columns)):
        single = [x[:5].reshape(5, 1) if i == n else float(x[6]) if i % 2 else x[6:7] for i, x in enumerate(columns)]
        full = tuple(np.broadcast_to(x, (5, 1)).ravel() for x in single)
        if inside(case.kernel, full).all():  # else the domain is no box
            results = call(*single)
            assert {x.shape for x in results} == {(5, 1)}
            agrees(case, case.truth(full), results)


@few
def test_empty_arrays_and_arrays_without_dimensions(case: Case, call: Any) -> None:
    for shape in ((0,), (3, 0)):
        results = call(*(np.empty(shape) for _ in case.kernel.arguments))
        assert [(x.shape, x.dtype) for x in results] == [(shape, np.float64)] * len(case.kernel.outputs)
    truth = truth_of(case).take([0])
    for kind in (np.float64, np.array):
        agrees(case, truth, call(*(kind(x[0]) for x in truth.points)))


@few
def test_single_precision_stays_single(case: Case, call: Any) -> None:
    points = [x.astype(np.float32) for x in random_points(case.kernel, 97, generator(case), decades=0.5)]
    truth = case.truth(tuple(x.astype(float) for x in points))
    results = call(*points)
    agrees(case, truth, results, np.float32)
    assert truth.error(results, np.float32).max() <= 1  # doubles are rounded once
    out = outs(case, 97, np.float32)
    call(*points, out=out)
    agrees(case, truth, tuple_of(out), np.float32)


@few
def test_out_may_be_an_input_or_overlap_it(case: Case, call: Any) -> None:
    truth = truth_of(case)
    for n, column in enumerate(truth.points):
        memory = np.append(column, 0.0)
        for place in (memory[:-1], memory[1:]):
            memory[:-1] = column
            arguments = [memory[:-1] if i == n else x for i, x in enumerate(truth.points)]
            out = (place, *tuple_of(outs(case, 97))[1:])
            call(*arguments, out=out)
            agrees(case, truth, out)


@few
def test_results_share_memory_only_where_the_formulas_are_equal(case: Case, call: Any) -> None:
    results, values = call(*truth_of(case).points), list(case.compiled.pointwise.outputs.values())
    for x, y in combinations(range(len(results)), 2):
        assert np.shares_memory(results[x], results[y]) == (values[x] == values[y])
    assert not any(np.shares_memory(x, y) for x in truth_of(case).points for y in results)


@few
def test_threads_give_what_one_gives(case: Case, call: Any) -> None:
    columns = [np.resize(x, (2, 50_000)) for x in truth_of(case).points]
    mixed = [columns[0], *(x[0] for x in columns[1:])]
    for arguments in (columns, [x.T for x in columns], mixed):
        for one, two in zip(call(*arguments), call(*arguments, threads=3), strict=True):
            np.testing.assert_array_equal(one, two)


@few
def test_arguments_that_do_not_fit_are_reported(case: Case, call: Any) -> None:
    columns = [x[:5] for x in truth_of(case).points]
    right = tuple_of(outs(case, 5))
    for out in ((*right, np.empty(5)), (np.empty(6), *right[1:]), (np.empty(5, np.float32), *right[1:])):
        with pytest.raises(ValueError, match="out"):
            call(*columns, out=out)
    for threads in (0, -1, 1.5):
        with pytest.raises(ValueError, match=r"threads = .* positive whole number"):
            call(*columns, threads=threads)
    with pytest.raises(TypeError):
        call(columns[0] + 0j, *columns[1:])


@few
def test_compiled_functions_may_call_a_kernel_by_its_name(case: Case, modules: dict[str, ModuleType]) -> None:
    point = [float(x[0]) for x in truth_of(case).points]
    names = ", ".join(f"x{n}" for n in range(len(point)))
    space: dict[str, Any] = {"kernel": getattr(modules[case.paper], case.name)}
    exec(f"def twice({names}):\n    return kernel({names}), kernel({names})", space)
    assert numba.njit(space["twice"])(*point) == (space["kernel"](*point),) * 2


# --- the functions for loops


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_for_loops_are_near_one_unit_of_the_last_place(name: str) -> None:
    exact, low, high, allowed = FUNCTIONS[name]
    rng = np.random.default_rng(0)
    near = np.concatenate(
        [rng.uniform(-2, 2, 1500), 10 ** rng.uniform(-300, 0, 300), -(10 ** rng.uniform(-300, 0, 300))]
    )
    turns = np.nextafter(rng.integers(1, 600, 300) * (math.pi / 2), rng.choice([-9e9, 9e9], 300))
    points = np.concatenate([near, turns, rng.uniform(max(low, -1e3), min(high, 1e3), 1500)])
    points = points[(points > low) & (points < high)]
    with ctx.workprec(300):
        errors = [error(exact(arb(x)), float(getattr(numba_functions, name)(np.float64(x)))) for x in points.tolist()]
    assert max(errors) <= allowed, points[int(np.argmax(errors))]


def error(value: arb, found: float) -> float:
    """The error of a result in units of the last place."""
    return abs(float((value - arb(found)).mid())) / math.ulp(float(value.mid()))


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_for_loops_give_no_number_where_they_have_no_digits(name: str) -> None:
    function, (exact, low, high, _) = getattr(numba_functions, name), FUNCTIONS[name]
    assert math.isnan(function(np.float64(math.nan)))
    for x in (2 * low, 2 * high, 1e300, math.inf, -math.inf):
        value = float(function(np.float64(x)))
        assert math.isnan(value) or value == float(exact(arb(x)).mid()) or error(exact(arb(x)), value) <= 1


def test_every_function_of_a_program_is_known() -> None:
    assert {*UNARY} <= {*FUNCTIONS, *numba_target.SINGLE}
    program = Program(("x",), operations=[Operation("t1", "bessel", ("x",))], outputs={"y": "t1"})
    case = next(iter(CASES.values()))
    with pytest.raises(SymcheckError, match=r"no function bessel for Numba; add it to"):
        numba_target.source("some", CompiledKernel(case.kernel, program, program))


# --- the text


def test_the_text_says_who_wrote_it_and_what_goes_in_and_comes_out() -> None:
    assert all(MARK in text and "symcheck." not in text.replace("`symcheck", "") for text in texts().values())
    for case in CASES.values():
        for each in (*case.kernel.arguments, *case.kernel.outputs):
            assert f"\n    {each.name} : float or ndarray\n" in texts()[f"{case.paper}.py"]


@pytest.mark.slow
def test_the_same_text_for_two_hash_seeds() -> None:
    program = "import test_numba_target as t; print(''.join(t.texts().values()), end='')"
    found = {python(program, Path(__file__).parent, PYTHONHASHSEED=seed) for seed in ("0", "1")}
    assert found == {"".join(texts().values())}


def python(program: str, folder: Path, **environment: str) -> str:
    """What a program prints in an interpreter of its own."""
    command = [sys.executable, "-W", "error", "-c", program]
    return subprocess.run(
        command, cwd=folder, env={**os.environ, **environment}, check=True, capture_output=True, text=True
    ).stdout


COUNT = """
import mirer2009 as m
kernels = [value for name, value in vars(m).items() if hasattr(value, "signatures")]
print(sum(len(each.signatures) for each in kernels), m.equal_moment_pitch(1.0, 2.0, 0.5))
"""


def test_nothing_is_compiled_when_it_is_imported_and_a_folder_that_cannot_be_written_does_not_matter(
    tmp_path: Path,
) -> None:
    (tmp_path / "mirer2009.py").write_text(texts()["mirer2009.py"], encoding="utf-8")
    (tmp_path / "__pycache__").touch()  # no folder, even for those who may write everywhere
    blocked = str(tmp_path / "__pycache__" / "no")
    environment = {"HOME": blocked, "XDG_CACHE_HOME": blocked, "PYTHONDONTWRITEBYTECODE": "1"}
    compiled, value = python(COUNT, tmp_path, **environment).split()
    assert int(compiled) == 0
    assert float(value) == pytest.approx(
        float(CASES["mirer2009:equal_moment_pitch"].function(1.0, 2.0, 0.5)), rel=1e-15
    )
