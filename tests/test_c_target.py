"""Generated C, compiled as its header says, gives what the NumPy kernels give, and one changed operator is noticed."""

from __future__ import annotations

import ctypes
import random
import re
import shutil
import subprocess
from functools import cache
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bench_c import BY_HAND
from compiled_c import COMPILERS, SAYING, addresses, built, called, everything, folder, library, sources, texts
from flint import arb, ctx
from kernel_reference import Case, Truth, cases, crowded_points, in_range, inside, random_points, worst
from test_kernels import EXTREMES, generator, within_or_at_infinity

from symcheck.core.verdicts import SymcheckError
from symcheck.kernels.codegen import c_target
from symcheck.kernels.codegen.c_functions import CIRCULAR, REACH, written
from symcheck.kernels.codegen.c_text import COMPILE, PARALLEL, SOURCE
from symcheck.kernels.codegen.kernel import Argument, Kernel, Output
from symcheck.kernels.codegen.program import Operation, Program
from symcheck.kernels.codegen.target import MARK, CompiledKernel

CASES = cases()
FEW, MANY, EXTREME = 40, 1000, 200
MUTANTS = 50
ANGLES = "mirer2009"  # a short file that has loops with angles and loops without
SIZES = (0, 1, 2, 7, 8, 9, 31, 33, 97)
FUNCTION_ULP = {"vector_sin": 0.8, "vector_cos": 0.8, "vector_tan": 1.3}

pytestmark = [
    pytest.mark.skipif(not COMPILERS, reason="neither gcc nor clang is installed"),
    pytest.mark.filterwarnings("ignore::RuntimeWarning"),  # of the NumPy kernels that are compared with
]
every_kernel = pytest.mark.parametrize("case", CASES.values(), ids=CASES.keys())
every_compiler = pytest.mark.parametrize("compiler", COMPILERS)
gcc = pytest.mark.skipif("gcc" not in COMPILERS, reason="gcc is not installed")


@cache
def sample(case: Case, count: int = FEW) -> Truth:
    """The values at some random points and as many crowded ones."""
    kinds = (points(case.kernel, count, generator(case)) for points in (random_points, crowded_points))
    return case.truth(tuple(np.concatenate(part) for part in zip(*kinds, strict=True)))


def bits(results: Any) -> Any:
    """Results as whole numbers: equal are only the same doubles; all that are no number are one."""
    values = np.array(results)
    return np.where(np.isnan(values), 0, values.view(np.int64))


# --- values


@every_compiler
@every_kernel
def test_errors_stay_below_what_the_header_says(case: Case, compiler: str) -> None:
    truth = sample(case)
    found = worst(case, truth, called(everything(compiler), case, truth.points))
    assert found.ulp <= case.kernel.ulp, found


@pytest.mark.slow
@every_kernel
@pytest.mark.parametrize("changes", [(), ("-march=x86-64",), ("-O0",)], ids=["as recommended", "any x86-64", "-O0"])
def test_errors_stay_below_what_the_header_says_at_many_points(case: Case, changes: tuple[str, ...]) -> None:
    truth = sample(case, MANY)
    found = worst(case, truth, called(everything(COMPILERS[0], *changes), case, truth.points))
    assert found.ulp <= case.kernel.ulp, found


@every_kernel
def test_values_are_those_of_the_numpy_kernel(case: Case) -> None:
    truth = sample(case)
    theirs = case.function(*truth.points)
    ours = called(everything(COMPILERS[0]), case, truth.points)
    for x, y, size in zip(ours, theirs if isinstance(theirs, tuple) else (theirs,), truth.size, strict=True):
        close = np.abs(x - y) <= 2 * case.kernel.ulp * np.spacing(size)
        assert (close | (x == y) | np.isnan(x) & np.isnan(y) | ~np.isfinite(size)).all()


@every_kernel
def test_extreme_arguments_give_the_limit_or_nan(case: Case) -> None:
    rng = generator(case)
    points = tuple(
        np.where(rng.random(EXTREME) < 0.5, rng.choice(EXTREMES, EXTREME), x)
        for x in random_points(case.kernel, EXTREME, rng)
    )
    results = np.array(called(everything(COMPILERS[0]), case, points))
    meant = np.flatnonzero(within_or_at_infinity(case.kernel, points))
    truth = case.truth(tuple(x[meant] for x in points))
    wrong = (truth.error(results[:, meant]) > case.kernel.ulp) & np.isfinite(results[:, meant])
    for n in np.flatnonzero(wrong.any(axis=0)):
        point = [x[n] for x in truth.points]
        assert not in_range(case, point), (point, results[:, meant[n]], truth.high[:, n])


@every_kernel
def test_nan_inputs_give_nan_outputs(case: Case) -> None:
    computed = case.kernel.accurate() if case.kernel.accurate else {}
    for n, argument in enumerate(case.kernel.arguments):
        columns = [x.copy() for x in sample(case).points]
        columns[n][3::7] = np.nan
        results = called(everything(COMPILERS[0]), case, columns)
        for output, form, result in zip(case.kernel.outputs, case.derived, results, strict=True):
            forms = (form, computed.get(output.name, form))
            if all(argument.name in {symbol.name for symbol in each.free_symbols} for each in forms):
                assert np.isnan(result[3::7]).all(), (argument.name, output.name)


# --- ways of calling


@every_kernel
def test_any_number_of_points(case: Case) -> None:
    truth = sample(case)
    function = getattr(everything(COMPILERS[0]), f"{case.paper}_{case.name}")
    for size in SIZES:
        some = truth.take(np.resize(np.arange(2 * FEW), size))
        memory = [np.full(size + 9, 7e77) for _ in case.kernel.outputs]
        function(ctypes.c_size_t(size), *addresses([*some.points, *memory]))
        assert all((x[size:] == 7e77).all() for x in memory)
        if size:
            assert worst(case, some, [x[:size] for x in memory]).ulp <= case.kernel.ulp


@every_kernel
def test_arguments_are_left_as_they_are(case: Case) -> None:
    points = [x.copy() for x in sample(case).points]
    called(everything(COMPILERS[0]), case, points)
    assert np.array_equal(points, sample(case).points)


@gcc
@pytest.mark.parametrize("case", [case for case in CASES.values() if case.paper == ANGLES], ids=lambda case: case.id)
def test_threads_share_large_arrays(case: Case) -> None:
    truth = sample(case).take(np.resize(np.arange(2 * FEW), PARALLEL + 3))
    loaded = library((f"{ANGLES}.c",), "gcc", "-fopenmp")
    for threads in (1, 3):
        loaded.omp_set_num_threads(threads)
        assert worst(case, truth, called(loaded, case, truth.points)).ulp <= case.kernel.ulp


def turned(case: Case) -> bool:
    """Whether an argument is an angle whose sine, cosine or tangent is taken."""
    return any(operation.function in CIRCULAR for operation in case.compiled.pointwise.operations)


@pytest.mark.parametrize("case", [case for case in CASES.values() if turned(case)], ids=lambda case: case.id)
def test_a_huge_angle_is_libms_and_changes_no_other_point(case: Case) -> None:
    loaded, points = everything(COMPILERS[0]), sample(case).points
    angles = [n for n, each in enumerate(case.kernel.arguments) if each.unit == "rad"]
    before = bits(called(loaded, case, points))
    for n, far in product(angles, (1.1 * REACH, 1e22, -1e300, np.inf)):
        columns = [x.copy() for x in points]
        columns[n][5] = far
        after = called(loaded, case, columns)
        assert np.array_equal(np.delete(bits(after), 5, 1), np.delete(before, 5, 1))
        there = tuple(x[5:6] for x in columns)
        theirs = case.function(*there)  # an acute angle leaves its domain, but NumPy computes something all the same
        assert np.allclose([x[5:6] for x in after], np.reshape(theirs, (-1, 1)), rtol=1e-6, equal_nan=True)
        if inside(case.kernel, there).all():
            assert worst(case, case.truth(there), [x[5:6] for x in after]).ulp <= case.kernel.ulp


# --- C by hand, which the kernels are compared with in speed


@pytest.mark.parametrize("case", [case for case in CASES.values() if case.name in BY_HAND], ids=lambda case: case.id)
def test_c_by_hand_has_the_values_of_the_kernels(case: Case) -> None:
    (folder() / "by_hand.c").write_bytes(Path(__file__).with_name("by_hand.c").read_bytes())
    truth = sample(case)
    results = [np.full(truth.points[0].size, 7e77) for _ in case.kernel.outputs]
    columns = [np.ascontiguousarray(x, np.float64) for x in truth.points]
    loaded = library(("by_hand.c",), COMPILERS[0], "-Wno-unknown-pragmas")
    getattr(loaded, case.name)(ctypes.c_size_t(columns[0].size), *addresses([*columns, *results]))
    assert worst(case, truth, results).ulp <= case.kernel.ulp + 4  # by which glibc's vector functions err


# --- the functions that are written out


WRAPPED = """
void many_{name}(size_t n, const double *x, double *y)
{{
#pragma omp simd
    for (size_t i = 0; i < n; ++i)
        y[i] = {name}(x[i]);
}}
"""


def functions_alone(changed: str = "") -> str:
    """A file with the functions of sine, cosine and tangent, each callable for an array."""
    head = SOURCE.format(key="", mark="").replace('#include ".h"', "#include <stddef.h>")
    body = changed or "\n".join(written(" ".join(FUNCTION_ULP)))
    return f"{head}{body}{''.join(WRAPPED.format(name=name) for name in FUNCTION_ULP)}"


@cache
def angles() -> dict[str, tuple[Any, Any, Any]]:
    """Angles, and their sines, cosines and tangents: the nearest doubles, and the rest."""
    rng, count = np.random.default_rng(5), 1500
    quarters = rng.integers(-600_000, 600_001, count) * (np.pi / 2)
    spread = 10.0 ** rng.uniform(-18, 6, 2 * count) * rng.choice([-1, 1], 2 * count)
    x = np.concatenate([spread, quarters, quarters + spread[:count] % 1, rng.uniform(-4, 4, count), [0.0, -0.0]])
    found = {}
    with ctx.workprec(300):
        for name in FUNCTION_ULP:
            values = [getattr(arb(each), name.removeprefix("vector_"))() for each in x.tolist()]
            high = np.array([float(value.mid()) for value in values])
            low = np.array([float((value - arb(y)).mid()) for value, y in zip(values, high.tolist(), strict=True)])
            found[name] = x, high, low
    return found


def function_error(loaded: ctypes.CDLL, name: str, symbol: str = "") -> float:
    """The largest error of a function, in units of the last place."""
    x, high, low = angles()[name]
    y = np.full(x.size, np.nan)
    getattr(loaded, symbol or f"many_{name}")(ctypes.c_size_t(x.size), *addresses([x, y]))
    error = np.abs((y - high) - low) / np.spacing(np.abs(high))
    return float(np.where(np.isnan(error), np.inf, error).max())


@every_compiler
@pytest.mark.parametrize("changes", [(), ("-march=x86-64",)], ids=["this processor", "any x86-64"])
def test_sine_cosine_and_tangent_err_by_little(compiler: str, changes: tuple[str, ...]) -> None:
    (folder() / "functions.c").write_text(functions_alone())
    loaded = library(("functions.c",), compiler, "-Wno-unused-macros", *changes)
    for name, allowed in FUNCTION_ULP.items():
        assert function_error(loaded, name) <= allowed, name


def test_the_sine_and_tangent_of_minus_zero_are_minus_zero() -> None:
    (folder() / "functions.c").write_text(functions_alone())
    loaded = library(("functions.c",), COMPILERS[0], "-Wno-unused-macros")
    for name in ("vector_sin", "vector_tan"):
        x, y = np.array([-0.0, 0.0]), np.ones(2)
        getattr(loaded, f"many_{name}")(ctypes.c_size_t(2), *addresses([x, y]))
        assert np.array_equal(np.signbit(y), [True, False])
        assert not y.any()


# --- the text


def test_the_text_is_the_same_every_time() -> None:
    again = dict(texts())
    texts.cache_clear()
    assert dict(texts()) == again
    assert sorted(again) == sorted(
        f"{key}.{suffix}" for key in {case.paper for case in CASES.values()} for suffix in "ch"
    )


def test_every_file_bears_the_mark_and_says_how_to_compile() -> None:
    assert all(MARK in text for text in texts().values())
    assert all(" ".join(COMPILE[1:]) in text for name, text in texts().items() if name.endswith(".h"))


@every_kernel
def test_the_header_says_what_goes_in_and_comes_out(case: Case) -> None:
    text = texts()[f"{case.paper}.h"]
    comment, declaration = re.search(
        rf"/\*\* ((?:(?!\*/).)*) \*/\n(void {case.paper}_{case.name}\([^;]*;)", text, re.S
    ).groups()  # type: ignore[union-attr]
    assert comment.startswith(case.kernel.says)
    assert f"Accuracy: {case.kernel.ulp} ulp" in comment
    assert "broadcast" not in comment
    for each in (*case.kernel.arguments, *case.kernel.outputs):
        assert f"\n    {each.name} : array of n doubles\n" in comment
    names = [*(each.name for each in case.kernel.arguments), *(f"out_{each.name}" for each in case.kernel.outputs)]
    assert re.findall(r"(\w+)[,)]", declaration) == ["n", *names]


@gcc
def test_every_loop_becomes_vector_instructions() -> None:
    said = built(sources(), "gcc", SAYING)[1]
    for name in sources():
        lines = texts()[name].split("\n")
        done = {int(line) for line in re.findall(rf"{name}:(\d+):\d+: optimized: loop vectorized", said)}
        loops = [n for n, line in enumerate(lines, 1) if line.startswith("#pragma omp")]
        for loop in loops:
            end = next(n for n in range(loop, len(lines)) if lines[n] == "}")
            assert done & set(range(loop, end + 1)), (name, loop)


@pytest.mark.skipif(not shutil.which("g++"), reason="g++ is not installed")
def test_the_headers_are_cpp_too() -> None:
    lines = [f'#include "{name}"' for name in texts() if name.endswith(".h")]
    (folder() / "all.cpp").write_text("\n".join(lines) + "\n")
    command = ["g++", "-Wall", "-Wextra", "-Werror", "-pedantic", "-fsyntax-only", "all.cpp"]
    subprocess.run(command, cwd=folder(), check=True)


@every_compiler
def test_all_papers_fit_into_one_program(compiler: str) -> None:
    loaded = everything(compiler)
    assert all(hasattr(loaded, f"{case.paper}_{case.name}") for case in CASES.values())


def toy(*operations: Operation, argument: str = "x") -> dict[str, str]:
    """The files of a kernel of one argument with these operations, of which the last gives the result."""
    kernel = Kernel(
        says="A toy.",
        arguments=(Argument(argument, "a number"),),
        outputs=(Output("y", "another"),),
        derived=lambda: {"y": argument},
        claims=("1.1",),
    )
    program = Program((argument,), operations=list(operations), outputs={"y": operations[-1].result})
    return dict(c_target.TARGET.files("toy", {"square": CompiledKernel(kernel, program, program)}))


def test_an_unknown_function_is_reported() -> None:
    with pytest.raises(SymcheckError, match="erf has no form in C"):
        toy(Operation("t1", "erf", ("x",)))


@pytest.mark.parametrize("name", ["double", "n", "i", "far", "exp", "atan"])
def test_a_name_that_c_reserves_is_reported(name: str) -> None:
    with pytest.raises(SymcheckError, match=rf"kernel square: {name} means something else"):
        toy(Operation("t1", "multiply", (name, name)), argument=name)


def test_an_unused_argument_is_allowed() -> None:
    program = Program(("x", "y"), operations=[Operation("t1", "sin", ("x",))], outputs={"z": "t1", "w": "x"})
    text = f"#include <stddef.h>\n{c_target.source('toy', 'half', program)}"
    functions = functions_alone().partition("\nvoid many_")[0]
    (folder() / "unused.c").write_text(f"{functions}\n{text}")
    assert library(("unused.c",), COMPILERS[0], "-Wno-unused-function").toy_half


def test_functions_are_written_out_only_where_they_are_needed() -> None:
    plain = toy(Operation("t1", "multiply", ("x", "x")))["toy.c"]
    assert not {"vector_sin", "MULTIPLY_ADD", "gamma_ratio", "simd(", "libm"} & set(re.findall(r"\w+\(?", plain))
    turned_file = toy(Operation("t1", "cos", ("x",)))["toy.c"]
    assert "vector_cos" in turned_file
    assert "vector_sin" not in turned_file


# --- one changed operator


OPERATOR = re.compile(r"(?<=[\w)\]]) ([-+*/]) (?=[\w(-])")
OTHERS = {"+": "-", "-": "+", "*": "/", "/": "*"}


def mutants(text: str, place: str) -> list[str]:
    """The text with one operator changed, for each in the computations behind a place."""
    found = []
    for match in OPERATOR.finditer(text, text.index(place)):
        line = text[text.rindex("\n", 0, match.start()) + 1 :].lstrip()
        if line.startswith(("const ", "double ", "return ")):
            found.append(f"{text[: match.start(1)]}{OTHERS[match[1]]}{text[match.end(1) :]}")
    return found


def together(files: list[str], *changes: str) -> ctypes.CDLL:
    """Mutants compiled into one library."""
    for n, text in enumerate(files):
        (folder() / f"mutant_{n}.c").write_text(text)
    return library(tuple(f"mutant_{n}.c" for n in range(len(files))), COMPILERS[0], "-O0", "-march=x86-64", *changes)


def test_one_changed_operator_of_a_kernel_is_noticed() -> None:
    found = []
    for case in CASES.values():
        text = c_target.TARGET.files(case.paper, {case.name: case.compiled})[f"{case.paper}.c"]
        text = text.replace(f'#include "{case.paper}.h"', "#include <stddef.h>")
        found += [(case, mutant) for mutant in mutants(text, f"{case.name}")]
    drawn = random.Random(0).sample(found, MUTANTS)
    loaded = together([text.replace(f"{case.paper}_{case.name}(", f"m{n}(") for n, (case, text) in enumerate(drawn)])
    for n, (case, text) in enumerate(drawn):
        truth, results = sample(case), [np.full(2 * FEW, 7e77) for _ in case.kernel.outputs]
        getattr(loaded, f"m{n}")(ctypes.c_size_t(2 * FEW), *addresses([*truth.points, *results]))
        assert worst(case, truth, results).ulp > case.kernel.ulp, (case.id, text)


def test_one_changed_operator_of_sine_cosine_and_tangent_is_noticed() -> None:
    found = mutants(functions_alone(), "INLINE turn turned(")
    renamed = [text.replace("many_", f"many_{n}_") for n, text in enumerate(found)]
    both = together(renamed), together(renamed, "-DFP_FAST_FMA")  # each has lines that the other leaves out
    for n, text in enumerate(found):
        errors = [(function_error(x, name, f"many_{n}_{name}"), name) for x in both for name in FUNCTION_ULP]
        assert any(error > FUNCTION_ULP[name] for error, name in errors), text
