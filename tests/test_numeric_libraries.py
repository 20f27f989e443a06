"""Smooth functions of the numeric layer, and kernels, of arrays of other libraries: values, traces and derivatives."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest

from symcheck.generated import esenkov2006, mirer2009
from symcheck.kernels.calling import is_foreign
from symcheck.numeric import inertia, liquid, random_rotation
from symcheck.numeric.inertia import damping

MOMENTS = np.array([[1.0, 2.0, 2.5], [3.0, 4.0, 5.0]])
AXES = inertia.direction_cosines(np.array([0.3, 0.7]), 0.4, 0.5)
GAINS = np.array([[0.3, 0.2, 0.1], [0.1, 0.4, 0.2]])
PAIR = np.array([0.3, 0.6])
STEP, SLOPE = 1e-6, 1e-7  # of an argument, for differences, and of a derivative


class Smooth(NamedTuple):
    """A function, arguments of two points, and which of them may be varied one by one."""

    function: Callable[..., Any]
    arguments: tuple[Any, ...]
    free: tuple[int, ...]


SMOOTH = {
    "direction_cosines": Smooth(inertia.direction_cosines, (PAIR, PAIR + 0.1, PAIR + 0.2), (0, 1, 2)),
    "axial_moments": Smooth(inertia.axial_moments, (MOMENTS, AXES), (0,)),
    "second_order_moments": Smooth(inertia.second_order_moments, (MOMENTS, AXES), (0,)),
    "product_of_axial_moments": Smooth(inertia.product_of_axial_moments, (MOMENTS, AXES), (0,)),
    "sum_of_products": Smooth(inertia.sum_of_products, (MOMENTS, AXES), (0,)),
    "gains_in_proportion": Smooth(damping.gains_in_proportion, (PAIR, MOMENTS, AXES), (0, 1)),
    "damping_matrix": Smooth(damping.damping_matrix, (GAINS, AXES), (0,)),
    "characteristic_coefficients": Smooth(damping.characteristic_coefficients, (MOMENTS, GAINS, AXES), (0, 1)),
    "stability_degree_in_pitch": Smooth(damping.stability_degree_in_pitch, (PAIR, MOMENTS, PAIR), (0, 1, 2)),
    "mode_inertia": Smooth(liquid.mode_inertia, (PAIR, PAIR + 0.5, PAIR + 1), (0, 1, 2)),
    "boundary_of_stability": Smooth(liquid.boundary_of_stability, (PAIR + 1, PAIR, PAIR + 0.1), (0, 1, 2)),
    **{
        name: Smooth(getattr(random_rotation, name), (*first, *rest), tuple(range(len(first) + len(rest))))
        for kind, rest in (
            ("amplitude", (PAIR + 0.2, PAIR + 1, PAIR + 1)),
            ("frequency", (PAIR, PAIR, PAIR + 1, PAIR + 1)),
        )
        for what, first in (("density_of", (PAIR,)), ("moment_of", (PAIR,)), ("mean_square_of", ()))
        for name in (f"{what}_{kind}",)
    },
    "distribution_of_amplitude": Smooth(
        random_rotation.distribution_of_amplitude, (PAIR, PAIR + 0.2, PAIR + 1, PAIR + 1), (0, 1, 2, 3)
    ),
    "quantile_of_amplitude": Smooth(
        random_rotation.quantile_of_amplitude, (PAIR, PAIR + 0.2, PAIR + 1, PAIR + 1), (0, 1, 2, 3)
    ),
    "mode_of_amplitude": Smooth(random_rotation.mode_of_amplitude, (PAIR, PAIR + 1, PAIR + 1), (0, 1, 2)),
}
named = pytest.mark.parametrize("name", SMOOTH)


def leaves(results: Any) -> list[Any]:
    return [*results] if isinstance(results, tuple) else [results]


def torch() -> Any:
    return pytest.importorskip("torch")


def jax() -> Any:
    found = pytest.importorskip("jax")
    found.config.update("jax_enable_x64", True)
    return found


def jax_array(x: Any) -> Any:
    return jax().numpy.asarray(x)


def torch_tensor(x: Any) -> Any:
    return torch().asarray(np.array(x))


def strict_array(x: Any) -> Any:
    return pytest.importorskip("array_api_strict").asarray(x)


LIBRARIES = {"jax": jax_array, "torch": torch_tensor, "array-api-strict": strict_array}


@named
@pytest.mark.parametrize("library", LIBRARIES)
def test_a_smooth_function_gives_arrays_of_the_library_with_the_values_of_numpy(library: str, name: str) -> None:
    case, put = SMOOTH[name], LIBRARIES[library]
    found = leaves(case.function(*map(put, case.arguments)))
    for own, expected in zip(found, leaves(case.function(*case.arguments)), strict=True):
        assert type(own) is type(put(1.0))
        np.testing.assert_allclose(np.asarray(own), expected, rtol=1e-12, atol=1e-14)


@named
def test_numbers_beside_arrays_of_a_library_are_numbers(name: str) -> None:
    case = SMOOTH[name]
    place = case.free[0]
    mixed = [torch_tensor(x) if k == place else x[0].tolist() for k, x in enumerate(case.arguments)]
    whole = [x if k == place else x[0] for k, x in enumerate(case.arguments)]
    for own, expected in zip(leaves(case.function(*mixed)), leaves(case.function(*whole)), strict=True):
        np.testing.assert_allclose(np.broadcast_to(np.asarray(own), expected.shape), expected, rtol=1e-12, atol=1e-14)


def slope_by_differences(case: Smooth, k: int) -> Any:
    """Of the sum of everything that comes out; a moment or gain has three components, which are moved together."""

    def total(step: float) -> Any:
        arguments = [x + step if k == n else x for n, x in enumerate(case.arguments)]
        return sum(np.asarray(x).reshape(2, -1).sum(axis=-1) for x in leaves(case.function(*arguments)))

    return (8 * (total(STEP) - total(-STEP)) - (total(2 * STEP) - total(-2 * STEP))) / (12 * STEP)


def assert_slope(found: Any, case: Smooth, k: int) -> None:
    own = np.asarray(found).reshape(2, -1).sum(axis=-1)
    np.testing.assert_allclose(own, slope_by_differences(case, k), rtol=SLOPE, atol=SLOPE)


@named
def test_torch_differentiates_a_smooth_function(name: str) -> None:
    case = SMOOTH[name]
    for k in case.free:
        arguments = [torch_tensor(x).requires_grad_(k == n) for n, x in enumerate(case.arguments)]
        sum(x.sum() for x in leaves(case.function(*arguments))).backward()
        assert_slope(arguments[k].grad, case, k)


@named
@pytest.mark.slow
def test_jax_traces_maps_and_differentiates_a_smooth_function(name: str) -> None:
    case, arrays = SMOOTH[name], [*map(jax_array, SMOOTH[name].arguments)]
    expected = leaves(case.function(*case.arguments))
    for way in (jax().jit(case.function), jax().vmap(case.function), jax().jit(jax().vmap(case.function))):
        for own, other in zip(leaves(way(*arrays)), expected, strict=True):
            np.testing.assert_allclose(own, other, rtol=1e-12, atol=1e-14)

    def total(*x: Any) -> Any:
        return sum(each.sum() for each in leaves(case.function(*x)))

    for k in case.free:
        assert_slope(jax().jit(jax().grad(total, argnums=k))(*arrays), case, k)


def derivatives(function: Callable[..., Any], *point: float) -> list[float]:
    inputs = [torch().tensor(x, dtype=torch().float64, requires_grad=True) for x in point]
    return [x.item() for x in torch().autograd.grad(function(*inputs), inputs, materialize_grads=True)]


def degree_in_pitch(ratio: Any, first: Any, third: Any, pitch: Any) -> Any:
    return damping.stability_degree_in_pitch(ratio, torch().stack([first, 0.7 * (first + third), third]), pitch)


@pytest.mark.parametrize("pitch", [0.0, -0.0])
def test_derivatives_without_pitch_are_finite_and_right(pitch: float) -> None:
    for first, third in ((1.0, 3.0), (3.0, 1.0)):
        assert derivatives(degree_in_pitch, 2.0, first, third, pitch)[:3] == [
            1.0,
            0.0,
            0.0,
        ]  # always k
    cosines = [derivatives(lambda *x, k=k: mirer2009.direction_cosines(*x)[k], pitch, 0.0, 0.0) for k in range(9)]
    generators = np.array(cosines).T.reshape(3, 3, 3)
    np.testing.assert_array_equal(generators, -generators.swapaxes(-1, -2))
    assert [np.abs(each).sum() for each in generators] == [2, 2, 2]


def test_derivatives_where_moments_are_equal_are_finite_and_right() -> None:
    found = derivatives(degree_in_pitch, 2.0, 1.5, 1.5, 0.4)
    assert (found[0], found[3]) == (1.0, 0.0)  # it is k at every pitch


def test_derivatives_where_the_interval_of_instability_closes_are_finite_and_right() -> None:
    for end in (0, 1):
        slope = derivatives(lambda A, E, b, end=end: esenkov2006.boundary_of_stability(A, E, b)[end], 2.0, 0.5, 1.0)
        np.testing.assert_allclose(slope[:2], [-1, 1], rtol=1e-15)  # both ends are E_1 - A there
        width = derivatives(esenkov2006.width_of_the_unstable_interval, 2.0, 0.5, float(end))
        assert width[:2] == [0.0, 0.0]


def test_what_is_outside_of_the_domain_is_refused_where_values_are_known() -> None:
    with pytest.raises(ValueError, match=r"moments\[0, 1\] = -2.0 must be positive"):
        inertia.axial_moments(torch_tensor([[1.0, -2.0, 2.0]]), AXES[0])
    with pytest.raises(ValueError, match=r"axes = .* must have orthonormal rows"):
        inertia.axial_moments(torch_tensor([1.0, 2.0, 2.0]).requires_grad_(), torch_tensor(2 * np.eye(3)))
    with pytest.raises(ValueError, match=r"moments has shape \(2,\); its last axes must be \(3\)"):
        inertia.axial_moments(torch_tensor([1.0, 2.0]), AXES[0])


def test_out_is_for_arrays_of_numpy() -> None:
    with pytest.raises(ValueError, match="stability_degree_in_pitch: out= is for NumPy's arrays; leave it out"):
        mirer2009.stability_degree_in_pitch(1.0, 1.0, 3.0, strict_array([0.3]), out=np.empty(1))


def test_arrays_of_other_libraries_need_array_api_compat_and_say_so(monkeypatch: pytest.MonkeyPatch) -> None:
    array = strict_array([0.3])
    monkeypatch.setattr("symcheck.kernels.libraries.find_spec", lambda name: None)
    vars(mirer2009.equal_moment_pitch.ways).pop("_in_libraries", None)
    with pytest.raises(ImportError, match=r"need array-api-compat: .* -m pip install 'symcheck\[arrays\]'"):
        mirer2009.equal_moment_pitch(array, 2.0, 3.0)


def test_numbers_and_arrays_of_numpy_are_not_of_another_library() -> None:
    for x in (1.0, 1, np.float64(1), np.ones(1), np.ma.masked_less([1.0], 0), [1.0], None):
        assert not is_foreign(type(x))
    assert "torch" not in sys.modules or is_foreign(torch().Tensor)
