"""The numeric layer and the kernels on dask arrays and DataArrays: lazy, named, and equal to the last bit."""

from __future__ import annotations

import doctest
import inspect
import subprocess
import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from chunked_samples import LEAD, arguments, functions, is_long
from optimized import about_docstrings

from symcheck import kernels
from symcheck.numeric import chunked, wheels
from symcheck.numeric.chunked import arrays as chunked_arrays
from symcheck.numeric.chunked import gufunc, signature_of
from symcheck.numeric.chunked import kernels as chunked_kernels

da = pytest.importorskip("dask.array")
xarray = pytest.importorskip("xarray")

FUNCTIONS = dict(functions())
PAPERS = ("esenkov2006", "ignatov2005", "mirer2009", "poloskov2004")
KERNELS = [(paper, name) for paper in PAPERS for name in kernels.load(paper).__all__]
CHUNKS = ((7, 9), (1, 20))


def leaves(value: Any) -> list[Any]:
    return list(value) if isinstance(value, tuple) else [value]


def converted(values: list[Any], convert: Callable[[Any, str], Any]) -> list[Any]:
    """Arguments with their leaves converted, where these have the leading axes; each leaf has a name."""

    def leaf(value: Any, name: str) -> Any:
        return convert(value, name) if is_long(value) else value

    return [
        type(value)(*(leaf(each, f"c{k}{j}") for j, each in enumerate(value)))
        if hasattr(value, "_fields")
        else leaf(value, f"c{k}")
        for k, value in enumerate(values)
    ]


def as_named(array: Any, name: str) -> Any:
    dims = ("p", "q", *(f"{name}_{k}" for k in range(np.ndim(array) - 2)))
    return xarray.DataArray(array, dims=dims, coords={"p": np.arange(LEAD[0])}, attrs={"units": "kg", "run": 1})


def assert_same_bits(found: Any, expected: Any) -> None:
    assert type(found) is type(expected) or not isinstance(expected, tuple)
    for lazy, array in zip(leaves(found), leaves(expected), strict=True):
        computed = lazy.compute(scheduler="sync")
        assert lazy.shape == computed.shape == array.shape
        assert lazy.dtype == computed.dtype == array.dtype
        np.testing.assert_array_equal(np.asarray(computed), array)


def test_every_part_of_the_numeric_layer_has_declared_functions() -> None:
    parts = {name.partition(".")[0] for name in FUNCTIONS}
    assert parts == {"attitude", "inertia", "liquid", "random_rotation", "wheels"}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_chunks_give_the_bits_of_the_whole(name: str) -> None:
    function, values = FUNCTIONS[name], arguments(FUNCTIONS[name])
    expected = function(*values)
    for chunks in CHUNKS:
        lazy = converted(values, lambda array, _, c=chunks: da.from_array(array, chunks=(*c, *array.shape[2:])))
        found = function(*lazy)
        assert all(isinstance(each, da.Array) for each in leaves(found))
        assert_same_bits(found, expected)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_data_arrays_keep_coordinates_and_names_and_no_foreign_units(name: str) -> None:
    function, values = FUNCTIONS[name], arguments(FUNCTIONS[name])
    found = function(*converted(values, lambda array, leaf: as_named(array, leaf).chunk(p=7)))
    names = getattr(found, "_fields", (name.partition(".")[2],))
    for array, expected in zip(leaves(found), names, strict=True):
        assert array.name == expected
        assert array.dims[:2] == ("p", "q")
        assert array.chunks is not None
        assert array.attrs == {"run": 1}
        np.testing.assert_array_equal(array.coords["p"], np.arange(LEAD[0]))
    assert_same_bits(found, function(*values))


@pytest.mark.parametrize(("paper", "name"), KERNELS)
def test_a_kernel_in_chunks_gives_the_bits_of_the_whole(paper: str, name: str) -> None:
    plain, kernel = getattr(kernels.load(paper), name), chunked_kernels.kernel(paper, name)
    declared = chunked_kernels.declaration(plain)
    assert [*declared.arguments, "out"] == [*inspect.signature(plain).parameters]
    rng = np.random.default_rng(2)
    values = [rng.uniform(0.1, 0.5, LEAD) for _ in declared.arguments]
    with np.errstate(all="ignore"):
        expected = plain(*values)
        assert len(leaves(expected)) == len(declared.results)
        assert_same_bits(kernel(*(da.from_array(value, chunks=(7, 9)) for value in values)), expected)


def test_a_kernel_gives_data_arrays_the_units_that_it_declares() -> None:
    distances = chunked_kernels.kernel("ignatov2005", "face_distances_of_four_wheels")
    a = xarray.DataArray([0.3, 0.5, 0.7], dims="a", attrs={"units": "rad"})
    b = xarray.DataArray([0.2, 0.4], dims="b", attrs={"units": "rad"})
    found = distances(a, b=b)
    assert [each.name for each in found] == ["r_1", "r_2", "r_3"]
    assert [each.attrs["units"] for each in found] == ["h_max"] * 3
    assert found[0].sizes == {"a": 3, "b": 2}


def test_a_kernel_of_single_precision_stays_so() -> None:
    volume = chunked_kernels.kernel("ignatov2005", "volume_of_four_wheels")
    a = np.linspace(0.1, 1.4, 600, dtype=np.float32)
    assert_same_bits(volume(da.from_array(a, chunks=100), a), volume(a, a))


def test_plain_arrays_and_data_arrays_do_not_mix() -> None:
    moments, axes = (arguments(FUNCTIONS["inertia.axial_moments"]))[:2]
    with pytest.raises(ValueError, match=r"shape \(30, 20, 3, 3\) together with DataArrays must be one too"):
        FUNCTIONS["inertia.axial_moments"](as_named(moments, "i"), axes)


def test_coordinates_that_differ_are_refused() -> None:
    function = FUNCTIONS["random_rotation.mode_of_amplitude"]
    first, second, third = (as_named(value, "c") for value in arguments(function))
    with pytest.raises(ValueError, match="join='exact'"):
        function(first, second.assign_coords(p=np.arange(30) + 1), third)


def test_bad_values_in_a_chunk_are_named_when_it_is_computed() -> None:
    lazy = FUNCTIONS["inertia.second_moments_of_mass"](da.from_array([[1.0, 2, 3], [1, 2, 4]], chunks=(1, 3)))
    with pytest.raises(ValueError, match="triangle inequalities"):
        lazy.compute(scheduler="sync")


@pytest.mark.parametrize("units", ["deg", "degrees", "Degree", "deg/s", "arcmin", "rpm"])
def test_angles_in_degrees_are_not_taken_for_radians(units: str) -> None:
    angles = xarray.DataArray([0.5, 0.6], dims="a", name="tilt", attrs={"units": units})
    with pytest.raises(ValueError, match=f"tilt has units '{units}'; angles are in radians"):
        FUNCTIONS["wheels.six_wheels"](angles)
    with pytest.raises(ValueError, match=f"has units '{units}'; angles are in radians, rates in rad/s"):
        wheels.listed_vertices(4, angles[0], 0.5)


@pytest.mark.parametrize("text", ["(i)->", "i->()", "(i),->(i)", "(i)(j)->()"])
def test_a_signature_that_is_none_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="must be of the form"):
        signature_of(text)


def test_a_result_axis_needs_a_length() -> None:
    with pytest.raises(ValueError, match=r"lengths of \['j'\]"):
        gufunc("(i)->(i,j)")


def test_neither_dask_nor_xarray_is_loaded_for_ordinary_arrays() -> None:
    code = (
        "import sys; from symcheck.numeric import inertia, liquid, wheels, random_rotation\n"
        "import symcheck.numeric.chunked.kernels as k\n"
        "inertia.triangle_slack([1, 2, 3]); k.kernel('ignatov2005', 'volume_of_four_wheels')(0.5, 0.5)\n"
        "print([m for m in ('dask', 'xarray', 'zarr', 'distributed', 'sympy') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"


@about_docstrings
@pytest.mark.parametrize("module", [chunked, chunked_arrays, chunked_kernels])
def test_examples_hold(module: Any) -> None:
    assert doctest.testmod(module).failed == 0
    examples = {test.name for test in doctest.DocTestFinder().find(module) if test.examples}
    public = {n for n, v in vars(module).items() if inspect.isfunction(v) and v.__module__ == module.__name__}
    assert {n for n in public if not n.startswith("_") and f"{module.__name__}.{n}" not in examples} == set()
