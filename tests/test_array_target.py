"""Kernels of the array API give the values of the NumPy kernels in every library, and can be traced and differentiated.

Values are compared with 50 digits of the derived expressions (`kernel_reference`) and are within the `ulp` that a
kernel declares, in all libraries, with two exceptions, both of XLA, which is what JAX computes with:

- log1p errs by 129 units in the last place beside -0.41 on a CPU, in float64 (openxla/xla#46765). Kernels whose
  program has a logarithm of 1 + x are allowed `XLA_LOG1P` times the declared ulp there.
- Subnormal numbers are 0 on a CPU, and a fused product and sum overflows where the two do not, or the reverse. Points
  where NumPy leaves the range of normal numbers on the way are left out.
"""

from __future__ import annotations

import ast
import math
import os
import random
import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache, partial
from inspect import signature
from itertools import islice, product
from pathlib import Path
from typing import Any

import bench_gpu
import numpy as np
import pytest
from kernel_reference import Case, Truth, cases, crowded_points, in_range, inside, random_points, worst
from mpmath import mp
from optimized import about_docstrings
from test_kernels import EXTREMES, generator, short, tuple_of, within_or_at_infinity

from symcheck.core.verdicts import SymcheckError
from symcheck.kernels.codegen import array_target
from symcheck.kernels.codegen.program import Operation, Program
from symcheck.kernels.codegen.target import MARK, CompiledKernel

CASES = cases()
FEW = 75
MUTANTS = 6  # of each kernel
SWAPPED = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult}
STEP = 2.0**-35  # of an argument, to either side, for differences
SLOPE = 1e-13  # of a derivative, or of the value divided by the argument
XLA_LOG1P = 16
TINY = np.finfo(float).tiny  # the smallest normal number
LOGARITHMS = {"log1p", "log1p_ratio", "gamma_ratio"}


@pytest.fixture(autouse=True)
def quiet() -> Iterator[None]:
    """NumPy's warnings are the caller's: here nobody wants them."""
    with np.errstate(all="ignore"):
        yield


@cache
def made(case: Case) -> CompiledKernel:
    return case.compiled


@cache
def text(paper: str) -> str:
    """The file of a paper."""
    kernels = {case.name: made(case) for case in CASES.values() if case.paper == paper}
    return array_target.files(paper, kernels)[f"{paper}.py"]


@cache
def module(paper: str) -> dict[str, Any]:
    pytest.importorskip("array_api_compat")
    space: dict[str, Any] = {"__name__": f"array_{paper}"}
    exec(compile(text(paper), f"{paper}.py", "exec"), space)
    return space


def function(case: Case) -> Callable[..., Any]:
    found: Callable[..., Any] = module(case.paper)[case.name]
    return found


@dataclass(frozen=True)
class Library:
    """put, get: from NumPy and back; call: how a function is called there; xla: whether XLA computes.

    fused: whether a product and a sum may be one operation, so that what cancels may be of either sign under a root.
    """

    put: Callable[[Any], Any]
    get: Callable[[Any], Any] = np.asarray
    call: Callable[[Any], Any] = lambda function: function
    xla: bool = False
    fused: bool = False

    def results(self, case: Case, *arguments: Any) -> tuple[Any, ...]:
        """What a kernel gives, as NumPy arrays; an argument that is an array is put into the library."""
        put = [self.put(x) if isinstance(x, np.ndarray) else x for x in arguments]
        return tuple(self.get(x) for x in tuple_of(self.call(function(case))(*put)))


def strict() -> Library:
    return Library(pytest.importorskip("array_api_strict").asarray)


def torch_on(device: str) -> Library:
    torch = pytest.importorskip("torch")
    if device == "cuda" and not torch.cuda.is_available():
        pytest.skip("torch has no CUDA GPU here")
    return Library(lambda x: torch.asarray(np.array(x), device=device), lambda x: x.numpy(force=True))


def jax_with(call: str) -> Library:
    jax = pytest.importorskip("jax")
    jax.config.update("jax_enable_x64", True)
    if call == "jit":
        return Library(jax.numpy.asarray, call=jax.jit, xla=True, fused=True)
    return Library(jax.numpy.asarray, xla=True)


def cupy() -> Library:
    module = pytest.importorskip("cupy")
    try:
        module.cuda.runtime.getDeviceCount()
    except module.cuda.runtime.CUDARuntimeError as error:
        pytest.skip(f"cupy has no CUDA GPU here: {error}")
    return Library(module.asarray, module.asnumpy)


LIBRARIES: dict[str, Callable[[], Library]] = {
    "numpy": lambda: Library(np.asarray),
    "array-api-strict": strict,
    "torch": lambda: torch_on("cpu"),
    "torch-cuda": lambda: torch_on("cuda"),
    "jax": lambda: jax_with("eager"),
    "jax.jit": lambda: jax_with("jit"),
    "cupy": cupy,
}


@pytest.fixture
def library(request: pytest.FixtureRequest) -> Library:
    return LIBRARIES[request.param]()


def in_libraries(*left_out: str, slow: tuple[str, ...] = ("jax", "jax.jit")) -> pytest.MarkDecorator:
    """A test for each library; XLA compiles each operation for each shape, which takes its time."""
    names = [name for name in LIBRARIES if name not in left_out]
    marked = [pytest.param(name, marks=pytest.mark.slow) if name in slow else name for name in names]
    return pytest.mark.parametrize("library", marked, indirect=True)


# --- values


@cache
def sample(case: Case, points: Any = random_points) -> Truth:
    """The values at some points."""
    return case.truth(points(case.kernel, FEW, generator(case)))


class Watched(np.ndarray):
    """Arrays that note the places at which an operation left the range of normal numbers."""

    met: Any = None

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        plain = [np.asarray(x) for x in inputs]
        result = getattr(ufunc, method)(*plain, **options)
        if result.dtype == np.float64:
            over = np.isinf(result) & np.logical_and.reduce(np.broadcast_arrays(*map(np.isfinite, plain)))
            Watched.met = Watched.met | over | (result != 0) & (abs(result) < TINY)
        return result.view(Watched)


def computable(case: Case, library: Library, columns: tuple[Any, ...]) -> Any:
    """The places at which a library can compute, repeated to as many as there are points: others are compiled anew."""
    Watched.met = np.zeros(columns[0].shape, bool)
    if library.xla:
        function(case)(*(x.view(Watched) for x in columns))
    return np.resize(np.flatnonzero(~Watched.met), columns[0].shape)


def allowed(case: Case, library: Library) -> float:
    """The ulp of a kernel in a library."""
    logarithm = LOGARITHMS & {operation.function for operation in made(case).program.operations}
    return case.kernel.ulp * (XLA_LOG1P if library.xla and logarithm else 1)


@in_libraries(slow=("jax.jit",))
def test_errors_stay_below_what_the_docstring_says(library: Library) -> None:
    for case, points in product(CASES.values(), (random_points, crowded_points)):
        truth = sample(case, points)
        truth = truth.take(computable(case, library, truth.points))
        results = library.results(case, *truth.points)
        assert {x.dtype for x in results} == {np.dtype(np.float64)}
        found = worst(case, truth, results)
        assert found.ulp <= allowed(case, library), (case.id, found)


@in_libraries()
def test_single_precision_stays_single(library: Library) -> None:
    for case in CASES.values():
        points = tuple(x[:20] for x in short(case))
        truth = case.truth(tuple(x.astype(float) for x in points))
        for mixed in (points, (points[0][:1], *(float(x[0]) for x in points[1:]))):
            results = library.results(case, *mixed)
            assert {x.dtype for x in results} == {np.dtype(np.float32)}, case.id
            assert truth.take(np.arange(results[0].size)).error(results, np.float32).max() <= 2 * case.kernel.ulp


@in_libraries("jax.jit")
def test_both_precisions_together_give_the_double_one(library: Library) -> None:
    for case in CASES.values():
        if len(case.kernel.arguments) > 1:
            first, *others = short(case)
            results = library.results(case, first.astype(float)[:1], *others)
            assert {x.dtype for x in results} == {np.dtype(np.float64)}, case.id


@in_libraries()
def test_extreme_arguments_give_what_the_numpy_kernel_gives(library: Library) -> None:
    for case in CASES.values():
        rng, ordinary = generator(case), random_points(case.kernel, FEW, generator(case))
        drawn = tuple(np.where(rng.random(FEW) < 0.5, rng.choice(EXTREMES, FEW), x) for x in ordinary)
        points = tuple(x[computable(case, library, drawn)] for x in drawn)
        results = np.array(library.results(case, *points))
        same = np.isnan(results) == np.isnan(np.array(tuple_of(case.function(*points))))
        assert same.all() or library.fused, (case.id, [x[~same.all(axis=0)] for x in points])
        meant = np.flatnonzero(within_or_at_infinity(case.kernel, points))
        truth, values = case.truth(tuple(x[meant] for x in points)), results[:, meant]
        wrong = (truth.error(values) > allowed(case, library)) & np.isfinite(values)
        for n in np.flatnonzero(wrong.any(axis=0)):
            assert not in_range(case, [x[n] for x in truth.points]), (case.id, truth.take([n]), values[:, n])


@in_libraries("jax.jit")
def test_nan_inputs_give_nan_outputs(library: Library) -> None:
    for case in CASES.values():
        outputs, reached = made(case).program.outputs.values(), array_target.dependencies(made(case).program)
        truth = sample(case).take(np.arange(7))
        right = library.results(case, *truth.points)
        for n, argument in enumerate(case.kernel.arguments):
            columns = [np.where(np.arange(7) == 3, np.nan, x) if i == n else x for i, x in enumerate(truth.points)]
            for result, before, value in zip(library.results(case, *columns), right, outputs, strict=True):
                assert np.isnan(result[3]) == (argument.name in reached[value]), (case.id, argument.name)
                assert np.array_equal(np.delete(result, 3), np.delete(before, 3))


# --- shapes and devices


@in_libraries("jax.jit")
def test_results_have_the_shape_to_which_arguments_broadcast(library: Library) -> None:
    for case in CASES.values():
        columns = sample(case).points
        for n in {0, len(columns) - 1}:
            single = [x[:5].reshape(5, 1) if i == n else x[6:7] for i, x in enumerate(columns)]
            mixed = [x if x.size == 5 else float(x[0]) for x in single]
            full = tuple(np.broadcast_to(x, (5, 1)).ravel() for x in single)
            right = np.array(tuple_of(case.function(*full)))
            for results in (library.results(case, *single), library.results(case, *mixed)):
                assert {x.shape for x in results} == {(5, 1)}, case.id
                if inside(case.kernel, full).all():  # the domain may be no box
                    assert case.truth(full).error(results).max() <= allowed(case, library), case.id
                assert np.array_equal(np.isnan(np.array(results)[:, :, 0]), np.isnan(right))


@in_libraries("jax.jit")
def test_empty_arrays_and_arrays_without_dimensions_keep_their_shape(library: Library) -> None:
    for case, shape in product(CASES.values(), ((0,), (3, 0), ())):
        results = library.results(case, *(np.full(shape, 0.5) for _ in case.kernel.arguments))
        assert [(np.shape(x), x.dtype) for x in results] == [(shape, np.float64)] * len(case.kernel.outputs), case.id


def test_results_stay_on_the_device_of_the_arrays() -> None:
    strict = pytest.importorskip("array_api_strict")
    device = strict.Device("device1")  # array-api-strict refuses to compute with what is elsewhere
    for case in CASES.values():
        columns = sample(case).points
        for n in range(len(columns)):
            one = [strict.asarray(x[:2], device=device) if i == n else float(x[0]) for i, x in enumerate(columns)]
            assert {x.device for x in tuple_of(function(case)(*one))} == {device}, case.id


# --- what cannot be computed


def test_an_argument_that_is_not_a_real_array_is_named() -> None:
    strict = pytest.importorskip("array_api_strict")
    f, right = function(CASES["mirer2009:direction_cosines"]), np.ones(2)
    for wrong, words in [
        ((1.0, 2, 3.0), "alpha, beta, gamma are numbers; make one an array"),
        ((right, right.astype(int), 1.0), "beta is an array of int64; convert it to float32 or float64"),
        ((right, right, right + 0j), "gamma is an array of complex128"),
        ((right.astype(np.float16), right, right), "alpha is an array of float16"),
        ((right, 1j, right), "beta is 1j; an array of float32 or float64, or a real number, is needed"),
        ((right, None, right), "beta is None; an array"),
        ((right, [1.0], right), "beta is [1.0]; an array"),
        ((right, strict.ones(2), right), "Multiple namespaces"),
    ]:
        with pytest.raises(TypeError, match=re.escape(words)):
            f(*wrong)


# --- tracing and derivatives


def representatives() -> list[Case]:
    """A kernel for each function that kernels call, and for each way in which outputs depend on arguments."""
    found: dict[str, Case] = {}
    for case in CASES.values():
        for operation in made(case).program.operations:
            found.setdefault(operation.function, case)
        if "full(xp, " in array_target.source(case.name, made(case)):
            found.setdefault("full", case)
    return list(dict.fromkeys(found.values()))


def test_no_branch_depends_on_values() -> None:
    jax_with("jit")
    jax = pytest.importorskip("jax")
    for case in CASES.values():
        columns = [jax.ShapeDtypeStruct((3,), np.float64) for _ in case.kernel.arguments]
        traced = tuple_of(jax.eval_shape(function(case), *columns))  # there are no values to branch upon
        assert [(x.shape, x.dtype) for x in traced] == [((3,), np.float64)] * len(case.kernel.outputs), case.id


@pytest.mark.filterwarnings("ignore:Dynamo detected a call to a `functools.lru_cache`")  # in array-api-compat
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
@pytest.mark.parametrize("backend", ["eager", pytest.param("inductor", marks=pytest.mark.slow)])
def test_pytorch_compiles_kernels_as_one_graph(backend: str) -> None:
    torch = pytest.importorskip("torch")
    if backend == "inductor" and not shutil.which(os.environ.get("CXX", "g++")):
        pytest.skip("there is no C++ compiler; set CXX to one")
    compile = partial(torch.compile, fullgraph=True, backend=backend)
    library = replace(torch_on("cpu"), call=compile)
    for case in representatives()[-1 if backend == "eager" else 0 :]:
        found = worst(case, sample(case), library.results(case, *sample(case).points))
        assert found.ulp <= case.kernel.ulp, (case.id, found)


def slopes(case: Case, columns: tuple[Any, ...], n: int) -> tuple[Any, Any]:
    """The derivatives of all outputs by an argument, and the sizes that their errors are counted in.

    They are central differences of values that have 30 digits, and err by the square of the step.
    """
    above, below = (columns[n] * (1 + sign * STEP) for sign in (1, -1))
    up, down = (case.truth((*columns[:n], x, *columns[n + 1 :])) for x in (above, below))
    slope = ((up.high - down.high) + (up.low - down.low)) / (above - below)
    return slope, np.abs(slope) + np.maximum(up.size, down.size) / np.abs(columns[n])


def of_torch(case: Case, columns: tuple[Any, ...]) -> list[list[Any]]:
    """The derivatives of each output by each argument, backwards."""
    torch = pytest.importorskip("torch")
    inputs = [torch.tensor(x, requires_grad=True) for x in columns]
    results = tuple_of(function(case)(*inputs))
    found = [torch.autograd.grad(x.sum(), inputs, retain_graph=True, materialize_grads=True) for x in results]
    return [[x.numpy() for x in row] for row in found]


def of_jax(case: Case, columns: tuple[Any, ...]) -> list[list[Any]]:
    """The derivatives of each output by each argument, backwards."""
    jax_with("jit")
    jax = pytest.importorskip("jax")
    numbers = range(len(case.kernel.outputs))
    one = jax.jit(
        jax.grad(
            lambda k, *x: jax.numpy.stack(tuple_of(function(case)(*x)))[k].sum(), tuple(range(1, 1 + len(columns)))
        ),
        static_argnums=0,
    )
    return [[np.asarray(x) for x in one(k, *columns)] for k in numbers]


@pytest.mark.parametrize(
    ("derivatives", "chosen"),
    [
        pytest.param(of_torch, CASES.values, id="torch"),
        pytest.param(of_jax, representatives, id="jax", marks=pytest.mark.slow),
    ],
)
def test_derivatives_are_those_of_the_derived_expressions(derivatives: Any, chosen: Any) -> None:
    for case in chosen():
        columns = tuple(x[:2] for x in random_points(case.kernel, FEW, generator(case), decades=0.5))
        found = derivatives(case, columns)
        for n, argument in enumerate(case.kernel.arguments):
            slope, size = slopes(case, columns, n)
            error = np.abs(np.array([row[n] for row in found]) - slope) / size
            assert error.max() <= SLOPE, (case.id, argument.name, error)


@pytest.mark.parametrize("name", ["log1p_ratio", "expm1_ratio"])
def test_quotients_keep_their_derivatives_at_and_near_zero(name: str) -> None:
    torch, xp = pytest.importorskip("torch"), pytest.importorskip("array_api_compat.torch")
    exact = {
        "log1p_ratio": lambda x: 1 / (1 + x) / x - mp.log1p(x) / x**2,
        "expm1_ratio": lambda x: mp.exp(x) / x - mp.expm1(x) / x**2,
    }[name]
    sizes = (1e-300, 1e-20, 1e-9, 1e-3, 0.0312, 0.0313, 0.9)
    x = torch.tensor([0.0, *sizes, *(-size for size in sizes)], dtype=torch.float64, requires_grad=True)
    (slope,) = torch.autograd.grad(module("poloskov2004")[name](xp, x).sum(), x)
    assert slope[0] == {"log1p_ratio": -0.5, "expm1_ratio": 0.5}[name]
    with mp.workdps(1000):
        right = [float(exact(mp.mpf(each))) for each in x.tolist()[1:]]
    assert np.allclose(slope[1:].numpy(), right, rtol=SLOPE, atol=0)


@pytest.mark.slow
def test_numbers_do_not_widen_single_precision_under_jit() -> None:
    jax_with("jit")
    jax = pytest.importorskip("jax")
    for case in representatives():
        first, *others = (x[:6] for x in short(case))
        results = tuple_of(jax.jit(function(case))(first, *(float(x[0]) for x in others)))
        assert {x.dtype for x in results} == {np.dtype(np.float32)}, case.id


@pytest.mark.slow
def test_a_mapped_kernel_gives_what_it_gives_of_whole_arrays() -> None:
    jax_with("jit")
    jax = pytest.importorskip("jax")
    for case in representatives():
        columns = [x[:6] for x in sample(case).points]
        whole, mapped = (np.array(tuple_of(f(*columns))) for f in (function(case), jax.vmap(function(case))))
        assert np.allclose(whole, mapped, rtol=1e-14, atol=TINY), case.id


# --- the text


def test_the_text_needs_nothing_but_array_api_compat() -> None:
    for paper in {case.paper for case in CASES.values()}:
        imports = [x for x in ast.walk(ast.parse(text(paper))) if isinstance(x, (ast.Import, ast.ImportFrom))]
        assert [ast.unparse(x).split()[1] for x in imports] == ["math", "array_api_compat"]


def test_the_text_has_the_helpers_that_it_calls_and_no_others() -> None:
    for paper in {case.paper for case in CASES.values()}:
        tree = ast.parse(text(paper))
        defined = {x.name for x in tree.body if isinstance(x, ast.FunctionDef)} - set(module(paper)["__all__"])
        called = {x.id for x in ast.walk(tree) if isinstance(x, ast.Name) and isinstance(x.ctx, ast.Load)}
        assert defined == called & {*array_target.HELPERS, "_arrays"}


@about_docstrings
def test_the_docstring_says_how_to_call_and_how_accurate_it_is() -> None:
    for case in CASES.values():
        said = function(case).__doc__ or ""
        assert said.startswith(case.kernel.says)
        assert " ".join(array_target.CALLS.split()) in " ".join(said.split())
        assert f"Accuracy: {case.kernel.ulp} ulp" in said
        assert "`out`" not in said
        assert list(signature(function(case)).parameters) == [each.name for each in case.kernel.arguments]
    assert all(MARK in text(case.paper) for case in CASES.values())


@pytest.mark.slow
def test_the_same_text_for_two_hash_seeds() -> None:
    program = "from test_array_target import CASES, text; print(text('poloskov2004'))"
    found = {
        subprocess.run(
            [sys.executable, "-c", program],
            cwd=Path(__file__).parent,
            env={**os.environ, "PYTHONHASHSEED": seed},
            stdout=subprocess.PIPE,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "2")
    }
    assert found == {text("poloskov2004") + "\n"}


def mutants(case: Case) -> Iterator[str]:
    """The file of a kernel with one operator changed, in the kernel or in a helper."""
    whole = array_target.files(case.paper, {case.name: made(case)})[f"{case.paper}.py"]
    for n, node in enumerate(ast.walk(ast.parse(whole))):
        if isinstance(node, ast.BinOp) and type(node.op) in SWAPPED:
            tree = ast.parse(whole)
            changed = next(islice(ast.walk(tree), n, None))
            changed.op = SWAPPED[type(changed.op)]()  # type: ignore[attr-defined]
            yield ast.unparse(tree)


def unnoticed(case: Case, mutant: str) -> bool:
    """Whether the values are right at random and at crowded points, and where one argument is of another shape."""
    space: dict[str, Any] = {}
    exec(mutant, space)
    pair = sample(case).take([0, 0])
    calls = [(truth, truth.points) for truth in (sample(case), sample(case, crowded_points))]
    calls += [(pair, tuple(x if i == n else x[:1] for i, x in enumerate(pair.points))) for n in range(len(pair.points))]
    try:
        return all(worst(case, truth, tuple_of(space[case.name](*x))).ulp <= case.kernel.ulp for truth, x in calls)
    except (ValueError, ZeroDivisionError):
        return False


@pytest.mark.slow
def test_one_changed_operator_is_noticed() -> None:
    pytest.importorskip("array_api_compat")
    for case in CASES.values():
        for mutant in random.Random(case.id).sample(found := list(mutants(case)), min(MUTANTS, len(found))):
            assert not unnoticed(case, mutant), mutant


def program(*operations: Operation, **outputs: Any) -> CompiledKernel:
    """A program of x and y that no kernel has."""
    some = made(next(iter(CASES.values())))
    return replace(some, program=Program(("x", "y"), operations=list(operations), outputs=outputs))


def test_an_unknown_function_is_reported() -> None:
    with pytest.raises(SymcheckError, match="no function erf"):
        array_target.source("f", program(Operation("t1", "erf", ("x",)), z="t1"))


def test_numbers_without_arrays_become_arrays() -> None:
    """Outputs that are numbers or arguments, functions of numbers, and operators between two numbers."""
    pytest.importorskip("array_api_compat")
    third = Fraction(1, 3)
    written = program(
        Operation("t1", "sqrt", ("pi",)),
        Operation("t2", "divide", (third, "sqrt(2/3)")),
        Operation("t3", "negative", ("t2",)),
        Operation("t4", "subtract", ("t3", third)),
        Operation("t5", "power", (third, "t4")),
        a=third,
        b="x",
        c="t1",
        d="t5",
    )
    space: dict[str, Any] = {}
    text = array_target.source("f", written)
    exec("\n".join([array_target.HEAD.format(key="", mark="", names=""), *array_target.helpers(text), text]), space)
    x = np.array([1.0, 2.0])
    results = space["f"](x, x[:, None])
    assert {r.shape for r in results} == {(2, 2)}
    assert not np.shares_memory(results[1], x)
    right = 1 / 3, x, math.sqrt(math.pi), 3 ** (math.sqrt(1.5) / 3 + 1 / 3)
    assert all(np.allclose(found, value, rtol=1e-15) for found, value in zip(results, right, strict=True))


# --- the benchmark


@pytest.fixture
def bench(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Callable[..., str]:
    """What the benchmark prints about the kernels of a paper."""
    monkeypatch.setenv("XLA_PYTHON_CLIENT_PREALLOCATE", "false")
    (tmp_path / "mirer2009.py").write_text(text("mirer2009"), encoding="utf-8")

    def run(*options: str) -> str:
        monkeypatch.setattr(sys, "argv", ["bench_gpu.py", str(tmp_path), *options])
        bench_gpu.main()
        return capsys.readouterr().out

    return run


def test_the_benchmark_names_the_libraries_that_are_missing(bench: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in bench_gpu.LIBRARIES:
        monkeypatch.setitem(sys.modules, name, None)
    told = bench()
    assert all(f"{name}: {name} is not installed; pip install" in told for name in bench_gpu.LIBRARIES)
    assert "Nothing to measure on cuda" in told


def test_the_benchmark_names_the_library_that_finds_no_gpu(bench: Any) -> None:
    torch = pytest.importorskip("torch")
    if torch.cuda.is_available():
        pytest.skip("torch has a CUDA GPU here")
    assert re.search(r"PyTorch .* finds no CUDA GPU. A GPU needs NVIDIA's driver", bench("--libraries", "torch"))


def test_the_benchmark_runs_without_a_gpu(bench: Any) -> None:
    pytest.importorskip("jax")
    told = bench("--device", "cpu", "--libraries", "jax", "--points", "500", "--kernels", "product_of_axial_moments")
    lines = [line.split() for line in told.splitlines() if "product_of_axial_moments  " in line]
    bytes_of_argument_and_result = [(12 + 1) * 8, (12 + 1) * 4]
    assert [int(line[1]) for line in lines] == bytes_of_argument_and_result
    assert all(float(line[2]) > 0 for line in lines)
