"""Kernels that C or Numba computes have the values of NumPy's, stay in the cache, and say what is missing."""

from __future__ import annotations

import subprocess
import sys
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from kernel_reference import Case, cases, random_points

from symcheck import kernels
from symcheck.core.verdicts import SymcheckError
from symcheck.kernels import engines

CASES = cases()
FEW = (
    "poloskov2004:density_of_frequency",
    "ignatov2005:axes_of_six_wheels",  # of one argument, with outputs that are equal
    "mirer2009:direction_cosines",
    "esenkov2006:characteristic_coefficients",
)
SIZE = 3 * engines.PIECE + 5


@pytest.fixture(autouse=True)
def own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A cache of its own, and no library that was loaded before."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(engines, "_loops", {})
    with np.errstate(all="ignore"):
        yield engines._folder()


needs_a_compiler = pytest.mark.skipif(engines._compiler() is None, reason="there is no C compiler")


def mixes(case: Case) -> Iterator[list[Any]]:
    """Arrays of one shape, one array beside numbers, numbers beside one, strided ones, and shapes that broadcast."""
    columns = random_points(case.kernel, SIZE, np.random.default_rng(3), decades=0.3)
    numbers = [float(x[0]) for x in columns]
    yield list(columns)
    yield [columns[0], *numbers[1:]]
    yield [np.float64(numbers[0]), *columns[1:]]
    yield [np.repeat(x, 2)[::2] for x in columns]
    if columns[1:]:
        yield [columns[0][:300, None], *(x[:40] for x in columns[1:-1]), numbers[-1]]
    yield [np.float32(x) for x in columns]


def each(results: Any) -> tuple[Any, ...]:
    return results if isinstance(results, tuple) else (results,)


def by_numpy(case: Case, mixed: list[Any]) -> list[Any]:
    """What NumPy gives; in single precision its doubles, rounded once: compiled code loses nothing to differences."""
    types = [x.dtype for x in each(case.function(*mixed))]
    doubles = [np.float64(x) if getattr(x, "dtype", None) == np.float32 else x for x in mixed]
    return [x.astype(dtype) for x, dtype in zip(each(case.function(*doubles)), types, strict=True)]


def assert_agrees(found: Any, expected: list[Any]) -> None:
    for one, other in zip(each(found), expected, strict=True):
        assert (one.shape, one.dtype) == (other.shape, other.dtype)
        size = np.abs(other[np.isfinite(other)]).max(initial=0)
        rtol = np.finfo(np.float32).eps if other.dtype == np.float32 else 1e-12
        np.testing.assert_allclose(one, other, rtol=rtol, atol=1e-14 * size)


def computes_as_numpy(case: Case, engine: str) -> None:
    function = vars(kernels.load(case.paper, engine=engine))[case.name]
    assert function.specification is case.function.specification
    for mixed in mixes(case):
        expected = by_numpy(case, mixed)
        assert_agrees(function(*mixed), expected)
        out = tuple(map(np.empty_like, expected))
        given = function(*mixed, out=out)
        assert all(one is other for one, other in zip(each(given), out, strict=True))
        assert_agrees(given, expected)


@needs_a_compiler
@pytest.mark.parametrize("name", FEW[:2])
def test_c_computes_what_numpy_does(name: str) -> None:
    computes_as_numpy(CASES[name], "c")


@needs_a_compiler
@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_each_kernel_in_c_computes_what_numpy_does(name: str) -> None:
    computes_as_numpy(CASES[name], "c")


@pytest.mark.slow
@pytest.mark.parametrize("name", FEW)
def test_numba_computes_what_numpy_does(name: str) -> None:
    pytest.importorskip("numba", reason="Numba is not installed")
    computes_as_numpy(CASES[name], "numba")


def test_what_numba_compiled_runs_in_the_next_process(own_cache: Path) -> None:
    pytest.importorskip("numba", reason="Numba is not installed")
    text = (
        "import numpy as np; from symcheck import kernels; x = np.linspace(0.1, 1, 5); "
        "print(kernels.load('ignatov2005', engine='numba').volume_of_three_wheels(x, x).tolist())"
    )
    first, second = (
        subprocess.run([sys.executable, "-c", text], check=True, capture_output=True, text=True).stdout
        for _ in range(2)
    )
    assert first == second
    assert list((own_cache / "__pycache__").glob("*volume_of_three_wheels*.nbc"))


@needs_a_compiler
def test_a_library_is_compiled_once_and_anew_if_it_was_changed(
    own_cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    a = np.linspace(0.1, 1.0, SIZE)
    volume = kernels.load("ignatov2005", engine="c").volume_of_three_wheels
    expected = volume(a, a)
    (library,) = own_cache.glob("*.so")
    made = library.stat().st_mtime_ns
    monkeypatch.setattr(engines, "_loops", {})
    assert np.array_equal(volume(a, a), expected)
    assert library.stat().st_mtime_ns == made
    other = library.with_name("changed")
    other.write_bytes(b"no library")
    other.replace(library)  # a new file: the one that is loaded stays as it is
    monkeypatch.setattr(engines, "_loops", {})
    assert np.array_equal(volume(a, a), expected)
    assert library.read_bytes() != b"no library"


@needs_a_compiler
def test_numbers_and_what_is_missing_are_the_kernel_s_own(own_cache: Path) -> None:
    volume = kernels.load("ignatov2005", engine="c").volume_of_three_wheels
    assert volume(0.5, 1.0) == kernels.load("ignatov2005").volume_of_three_wheels(0.5, 1.0)
    assert volume(b=1.0, a=0.5) == volume(0.5, 1.0)
    assert not own_cache.exists()
    with pytest.raises(TypeError, match="missing 1 required positional argument: 'b'"):
        volume(0.5)


@needs_a_compiler
def test_kernels_in_c_can_be_checked() -> None:
    with pytest.raises(ValueError, match=r"b = 2\.0 must satisfy"):
        kernels.load("ignatov2005", check=True, engine="c").volume_of_three_wheels(0.5, 2.0)


@pytest.mark.parametrize(("engine", "words"), [("c", "there is no C compiler"), ("numba", "Numba is not installed")])
def test_an_engine_that_is_missing_is_named_and_numpy_computes(
    engine: str, words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(engines, "_compiler", lambda: None)
    monkeypatch.setattr(engines, "find_spec", lambda _: None)
    with pytest.warns(RuntimeWarning, match=f"{words}.*the kernels run in NumPy"):
        found = kernels.load("ignatov2005", engine=engine)
    assert found is kernels.load("ignatov2005")


@needs_a_compiler
def test_what_does_not_compile_runs_in_numpy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(engines, "FLAGS", ("--no-such-flag",))
    a = np.linspace(0.1, 1.0, SIZE)
    volume = kernels.load("ignatov2005", engine="c").volume_of_three_wheels
    with pytest.warns(RuntimeWarning, match="volume_of_three_wheels does not compile .*; it runs in NumPy"):
        found = volume(a, a)
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # it is said once
        assert np.array_equal(volume(a, a), found)


def test_an_unknown_engine_is_refused() -> None:
    with pytest.raises(SymcheckError, match="engine = 'fortran' must be one of 'numpy', 'numba', 'c'"):
        kernels.load("ignatov2005", engine="fortran")
