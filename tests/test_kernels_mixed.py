"""Kernels of numbers together with arrays, and of arrays that broadcast: the values of arrays of one shape."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import pytest
from kernel_reference import Case, cases, random_points
from mpmath import mp

from symcheck.generated import ignatov2005, poloskov2004
from symcheck.kernels.loading import load
from symcheck.kernels.ratios import gamma_ratio
from symcheck.kernels.runtime import BLOCK, DOUBLE, KEPT, SMALL, Array

CASES = cases()
SHAPES = ((7,), (5, 3), (SMALL + 5,), (2, BLOCK + 3), (0,), (3, 0))


def leaves(results: Any) -> list[Array]:
    return list(results) if isinstance(results, tuple) else [results]


def points(case: Case, shape: tuple[int, ...]) -> list[Array]:
    size = max(1, int(np.prod(shape)))
    columns = random_points(case.kernel, size, np.random.default_rng(5), decades=0.3)
    return [column[: int(np.prod(shape))].reshape(shape) for column in columns]


def mixes(values: list[Array]) -> list[list[Any]]:
    """Some arguments made numbers, some arrays with axes of length 1; those that remain keep their shape."""
    shape = values[0].shape
    first = tuple([0] * len(shape))

    def number(x: Array) -> float:
        return float(x[first]) if x.size else 0.5

    found: list[list[Any]] = [
        [x if k == place else number(x) for k, x in enumerate(values)] for place in {0, len(values) - 1}
    ]
    found.append([x if k % 2 else number(x) for k, x in enumerate(values)])
    found.append([np.float64(number(x)) if k % 2 else x for k, x in enumerate(values)])
    if len(shape) > 1:
        found.append([x[:, :1] if k % 2 else x[:1] for k, x in enumerate(values)])
    if len(shape) > 1 and shape[0]:
        found.append([x[0] if k % 2 else x[:, :1] for k, x in enumerate(values)])
    return found


def assert_close(found: Any, expected: Any) -> None:
    for one, other in zip(leaves(found), leaves(expected), strict=True):
        assert one.shape == other.shape
        assert one.dtype == other.dtype
        size = np.abs(other[np.isfinite(other)]).max(initial=0)
        np.testing.assert_allclose(one, other, rtol=1e-9, atol=1e-11 * size)


@pytest.mark.parametrize("name", CASES)
def test_mixed_arguments_have_the_values_of_whole_arrays(name: str) -> None:
    case = CASES[name]
    for shape in SHAPES:
        for mixed in mixes(points(case, shape)):
            whole = [np.array(x) for x in np.broadcast_arrays(*mixed)]
            if not whole[0].ndim:
                continue
            with np.errstate(all="ignore"):
                expected, found = case.function(*whole), case.function(*mixed)
                assert_close(found, expected)
                out = tuple(np.empty_like(x) for x in leaves(expected))
                given = case.function(*mixed, out=out)
            assert all(one is other for one, other in zip(leaves(given), out, strict=True))
            assert_close(given, expected)


@pytest.mark.parametrize("name", CASES)
def test_numbers_of_any_type_are_numbers(name: str) -> None:
    case = CASES[name]
    floats = [float(x[0]) for x in points(case, (1,))]
    expected = case.function(*floats)
    for kinds in ((np.float64,), (np.float64, float), (float, np.float64)):
        found = case.function(*(kinds[k % len(kinds)](x) for k, x in enumerate(floats)))
        for one, other in zip(leaves(found), leaves(expected), strict=True):
            assert one == other
            assert isinstance(one, np.float64 if len(floats) > 1 or kinds[0] is np.float64 else float)


def test_whole_numbers_are_numbers() -> None:
    found = poloskov2004.density_of_frequency(1, 0.5, 1, np.int64(2), 2)
    assert found == poloskov2004.density_of_frequency(1.0, 0.5, 1.0, 2.0, 2.0)


def test_out_may_lie_in_an_argument() -> None:
    a, b = np.linspace(0.1, 1.4, SMALL + 9), 0.5
    expected = ignatov2005.volume_of_four_wheels(a, b)
    for out in (a, a[::-1]):
        values = a.copy()
        memory = values if out is a else values[::-1]
        np.testing.assert_allclose(ignatov2005.volume_of_four_wheels(values, b, out=memory), expected, rtol=1e-13)


def test_single_precision_stays_single_beside_numbers() -> None:
    a = np.linspace(0.1, 1.4, 50, dtype=np.float32)
    found = ignatov2005.volume_of_four_wheels(a, 0.5)
    assert found.dtype == np.float32
    np.testing.assert_allclose(found, ignatov2005.volume_of_four_wheels(a.astype(float), 0.5), rtol=1e-5)
    assert ignatov2005.volume_of_four_wheels(a, np.float64(0.5)).dtype == np.float64


def test_what_numbers_alone_make_undefined_is_what_numpy_gives() -> None:
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("always")
        found = poloskov2004.density_of_frequency(np.linspace(0, 1, 5), 0.5, 1.0, 1.0, -1.0)
    assert np.isnan(found).all()
    assert seen


def test_a_unit_or_a_mask_that_would_be_lost_is_refused() -> None:
    volume = ignatov2005.volume_of_four_wheels
    for units in ("deg", "degrees", "arcmin"):
        degrees = Labelled([30.0, 40.0], units)
        with pytest.raises(ValueError, match=f"volume_of_four_wheels: b has units '{units}'; angles are in radians"):
            volume(0.5, degrees)
    assert np.array_equal(volume(0.5, Labelled([0.3, 0.4], "rad")), volume(0.5, np.array([0.3, 0.4])))
    with pytest.raises(ValueError, match="a is a masked array, whose mask would be lost"):
        volume(np.ma.masked_less([0.3, 0.4], 0.35), 0.5)


class Labelled:
    """An array with a unit, as xarray's are."""

    def __init__(self, values: list[float], units: str) -> None:
        self.values, self.attrs = np.array(values), {"units": units}
        self.dtype = self.values.dtype

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Array:
        return self.values


def test_a_density_below_the_range_of_doubles_is_zero() -> None:
    density = poloskov2004.density_of_amplitude(np.array([1.0, 60.0]), 1e-12, 1.0, 1.0)
    assert density[0] > 0
    assert density[1] == 0


def test_what_depends_on_numbers_alone_is_computed_by_math() -> None:
    density = CASES["poloskov2004:density_of_frequency"].function.ways
    whole, mixed = (
        density.plan(False, patterns, 1, DOUBLE).whole.__code__.co_names
        for patterns in ((1,) * 5, (1, None, None, None, None))
    )
    assert "gamma_ratio" in whole
    assert {"of_gamma_ratio", "number"} <= {*mixed}
    assert "gamma_ratio" not in mixed


def test_a_value_has_the_shape_of_what_it_depends_on() -> None:
    case = CASES["mirer2009:direction_cosines"]
    rows, columns = np.linspace(0, 1, 3)[:, None], np.linspace(0, 1, 4)
    found = case.function.ways.plan(False, (1, 2, 2), 3, DOUBLE)
    assert found.prelude is not None
    assert {x.shape for x in found.prelude(rows, columns, columns)} == {(3, 1), (4,)}
    np.testing.assert_allclose(case.function(rows, columns, columns)[3], np.broadcast_to(np.sin(columns), (3, 4)))


def test_out_that_shares_memory_with_an_argument_in_any_way_is_written_last() -> None:
    a, b = np.linspace(0.1, 1.4, 300), np.linspace(0.3, 1.2, 300)
    expected = ignatov2005.face_distances_of_four_wheels(a, b)
    whole = np.empty(300)
    for shared in (whole, whole[:], np.frombuffer(memoryview(whole)), whole.reshape(3, 100).reshape(-1)):
        shared[:] = a
        results = whole, np.empty(300), np.empty(300)
        found = ignatov2005.face_distances_of_four_wheels(shared, b, out=results)
        for one, other, given in zip(found, expected, results, strict=True):
            assert one is given
            np.testing.assert_array_equal(one, other)
    backwards = a[::-1].copy()
    results = backwards, np.empty(300), np.empty(300)
    found = ignatov2005.face_distances_of_four_wheels(backwards[::-1], b, out=results)
    np.testing.assert_array_equal(found, expected)


@pytest.mark.parametrize("size", [1, 2, 100, 300, SMALL + 1])
def test_out_has_what_is_computed_without_it(size: int) -> None:
    for case in CASES.values():
        columns = points(case, (size,))
        out = [np.empty(size) for _ in case.kernel.outputs]
        with np.errstate(all="ignore"):
            given, expected = case.function(*columns, out=out), case.function(*columns)
        for one, other, own in zip(leaves(given), leaves(expected), out, strict=True):
            assert one is own
            np.testing.assert_array_equal(one, other, err_msg=case.id)


def test_what_is_prepared_for_shapes_has_a_limit_and_values_all_the_same() -> None:
    volume = ignatov2005.volume_of_four_wheels
    for rows in range(1, KEPT + 20):
        column = np.linspace(0.2, 1.2, rows)[:, None]
        found = volume(column, np.array([0.4, 0.5]))
        np.testing.assert_allclose(found[:, 1], volume(column[:, 0], 0.5), rtol=1e-13)
    kept = volume.ways.call.__globals__["of_arrays"].__globals__["known"]
    assert len(kept) <= KEPT


def test_ratios_of_gamma_functions_have_their_digits_where_they_are_quotients() -> None:
    rng = np.random.default_rng(3)
    x, share = rng.uniform(0.1, 63, 300), rng.uniform(0, 1, 300)
    h = 0.1 + 62 * share - x
    with mp.workdps(40):
        exact = [mp.gammaprod([mp.mpf(a) + mp.mpf(b)], [a]) / mp.mpf(a) ** b for a, b in zip(x, h, strict=True)]
        for found in (gamma_ratio(x, h), [gamma_ratio(float(a), float(b)) for a, b in zip(x, h, strict=True)]):
            assert max(abs(mp.mpf(float(y)) / right - 1) for y, right in zip(found, exact, strict=True)) < 16 * 2**-52


def test_the_bits_of_a_ratio_of_gamma_functions_do_not_depend_on_its_neighbours() -> None:
    x = np.geomspace(1e-8, 1e8, 200)
    for h in (np.array(0.5), np.array(2.25), np.linspace(0.1, 3, 200)):
        whole = gamma_ratio(x, h)
        halves = [
            gamma_ratio(x[part], h[part] if h.ndim else h) for part in (slice(0, 90), slice(90, 110), slice(110, 200))
        ]
        np.testing.assert_array_equal(np.concatenate(halves), whole)


@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_a_ratio_of_gamma_functions_of_what_is_not_positive_is_nan(kind: Any) -> None:
    x = np.array([-1.0, 1.0, 100.0, -3.0, 2.0, -1.5, 2.0, 0.3, 1e4], kind)
    h = np.array([2.5, -1.5, -101.0, 2.0, -2.5, 2.0, 0.5, 0.1, -2.0], kind)  # Gamma(1/2)/Gamma(-3/2) is a number
    with np.errstate(all="ignore"):
        found = gamma_ratio(x, h)
        np.testing.assert_array_equal(np.isnan(found), [True] * 6 + [False] * 3)
        np.testing.assert_array_equal(np.isnan(gamma_ratio(x[5:8], h[5:8])), [True, False, False])
        np.testing.assert_array_equal(np.isnan(gamma_ratio(x, kind(-1.5)[...])), np.minimum(x, x - 1.5) <= 0)
    numbers = [gamma_ratio(float(a), float(b)) for a, b in zip(x, h, strict=True)]
    np.testing.assert_allclose(numbers, found, rtol=1e-5)


@pytest.mark.parametrize("engine", ["numpy", "c", "numba"])
def test_where_a_ratio_of_gamma_functions_leaves_the_doubles_a_kernel_is_nan(engine: str) -> None:
    noise = np.full(2000, 1e154)  # squared, 1e308: what it is of is 1/1e308, and 10 times that
    dissipation = np.where(np.arange(2000) % 2, 1.0, 10.0)
    with np.errstate(all="ignore"), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        density = load("poloskov2004", engine=engine).density_of_frequency
        found = density(0.0, 1.0, noise, 1.0, dissipation)
        assert np.isnan(found[1::2]).all()
        np.testing.assert_allclose(found[::2], 1e154 * 1e-307, rtol=1e-9)
        assert np.isnan(density(0.0, 1.0, 1e154, 1.0, 1.0))
