"""Inertia, orientation, damping and decay in numbers: against exact rationals, the derivation, and simulation."""

from __future__ import annotations

import inspect
import io
import subprocess
import sys
from collections.abc import Callable
from fractions import Fraction
from functools import cache, partial
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from numpy.testing import assert_allclose
from scipy.linalg import expm
from scipy.optimize import brentq
from scipy.spatial.transform import Rotation

from symcheck.numeric.inertia import (
    axial_moments,
    bound_at_given_moment,
    damping,
    decay,
    inertia_tensor,
    orientation,
    plots,
    principal_inertia,
    product_of_axial_moments,
    second_moments_of_mass,
    second_order_moments,
    sum_of_products,
    tensors,
    triangle_slack,
)
from symcheck.numeric.inertia.damping import (
    characteristic_coefficients,
    characteristic_roots,
    damping_matrix,
    gains_in_proportion,
    harmonic_mean_of_rates,
    optimal_devices,
    orthogonal_devices,
    stability_degree,
    stability_degree_in_pitch,
)
from symcheck.numeric.inertia.decay import angular_acceleration, decay_rate, free_decay, kinetic_energy
from symcheck.numeric.inertia.orientation import (
    attitude_angles,
    direction_cosines,
    equal_moment_angles,
    equal_moment_axes,
)
from symcheck.papers.mirer2009 import derivation

Array = np.ndarray[Any, np.dtype[np.float64]]
Exact = list[list[Fraction]]
MODULES = (tensors, orientation, damping, decay, plots)
quick = settings(deadline=None, max_examples=60)
slower = settings(deadline=None, max_examples=12)

# --- bodies and axes --------------------------------------------------------------------------------------------------

integers = st.integers(-9, 9)
angles = st.floats(-10, 10)
second_moments = st.tuples(*[st.integers(1, 50)] * 3)
physical_moments = second_moments.map(lambda p: (p[1] + p[2], p[2] + p[0], p[0] + p[1]))
any_moments = st.tuples(*[st.one_of(st.sampled_from([1.0, 2.0, 1.0 + 2**-52, 3.0]), st.floats(0.01, 100))] * 3)
positive = st.floats(0.01, 100)
triples = st.tuples(positive, positive, positive)


@st.composite
def rational_rotations(draw: Any) -> Exact:
    """Rotation matrices of rational numbers, from quaternions of integers."""
    w, x, y, z = draw(st.tuples(*[integers] * 4).filter(any))
    n = w * w + x * x + y * y + z * z
    rows = (
        (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    )
    return [[Fraction(entry, n) for entry in row] for row in rows]


rotations = rational_rotations().map(lambda exact: np.array(exact, dtype=float))


def exact_moments(moments: Any, axes: Exact) -> list[Fraction]:
    return [sum((i * a * a for i, a in zip(moments, row, strict=True)), Fraction(0)) for row in axes]


def exact_forms(moments: Any, axes: Exact) -> list[Fraction]:
    i1, i2, i3 = moments
    return exact_moments((i2 * i3, i3 * i1, i1 * i2), axes)


def letters(name: str, values: Any) -> dict[str, Any]:
    """Exact values by the name of the letter: name_1 .. for a vector, name_11 .. for a matrix."""
    table = np.array(values, dtype=object)
    return {f"{name}_{''.join(str(k + 1) for k in place)}": table[place] for place in np.ndindex(table.shape)}


@cache
def compiled(derived: Callable[[], Any]) -> tuple[list[str], Callable[..., list[Any]]]:
    """The expressions of a derivation as one function of plain numbers, and the names of its arguments."""
    result = derived()
    expressions = list(result.values() if isinstance(result, dict) else result)
    symbols = sorted(set().union(*(expression.free_symbols for expression in expressions)), key=str)
    return [str(symbol) for symbol in symbols], sp.lambdify(symbols, expressions, modules="math")


def numbers(derived: Callable[[], Any], values: dict[str, Any]) -> list[float]:
    """The values of a derivation: worked out in fractions where the letters have fractions."""
    names, function = compiled(derived)
    return [float(value) for value in function(*(values[name] for name in names))]


def characteristic_coefficients_of_the_derivation() -> list[Any]:
    [polynomial] = derivation.characteristic_polynomial()
    coefficients: list[Any] = sp.Poly(polynomial, sp.Symbol("p", real=True)).all_coeffs()
    return coefficients


# --- the modules ------------------------------------------------------------------------------------------------------


def test_nothing_is_loaded_that_only_proofs_and_figures_need() -> None:
    names = ", ".join(module.__name__ for module in MODULES)
    program = f"import sys, {names}; print(*({{'sympy', 'matplotlib'}} & set(sys.modules)))"
    loaded = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout
    assert loaded.split() == []


EXAMPLES: dict[Callable[..., Any], tuple[Any, ...]] = {
    principal_inertia: ([[3, 1, 0], [1, 3, 0.5], [0, 0.5, 5]],),
    inertia_tensor: ([2, 3, 4], direction_cosines(0.1, 0.2, 0.3)),
    triangle_slack: ([2, 3, 4],),
    second_moments_of_mass: ([2, 3, 4],),
    axial_moments: ([2, 3, 4], direction_cosines(0.1, 0.2, 0.3)),
    second_order_moments: ([2, 3, 4], direction_cosines(0.1, 0.2, 0.3)),
    product_of_axial_moments: ([2, 3, 4], direction_cosines(0.1, 0.2, 0.3)),
    sum_of_products: ([2, 3, 4], direction_cosines(0.1, 0.2, 0.3)),
    bound_at_given_moment: ([2, 3, 4], 3.5),
    direction_cosines: (0.1, 0.2, 0.3),
    attitude_angles: (direction_cosines(0.1, 0.2, 0.3),),
    equal_moment_angles: ([2, 3, 4],),
    equal_moment_axes: ([2, 3, 4.5], 0.7, 3, -1),
    gains_in_proportion: (0.1, [2, 3, 4], direction_cosines(0.1, 0.2, 0.3)),
    damping_matrix: ([1, 2, 3], direction_cosines(0.1, 0.2, 0.3)),
    orthogonal_devices: ([[3, 1, 0], [1, 3, 0.5], [0, 0.5, 5]],),
    characteristic_coefficients: ([2, 3, 4], [1, 2, 3], direction_cosines(0.1, 0.2, 0.3)),
    characteristic_roots: ([2, 3, 4], [[3, 1, 0], [1, 3, 0.5], [0, 0.5, 5]]),
    stability_degree: ([2, 3, 4], [[3, 1, 0], [1, 3, 0.5], [0, 0.5, 5]]),
    optimal_devices: ([2, 3, 4], 0.1),
    harmonic_mean_of_rates: ([1, 2, 3],),
    stability_degree_in_pitch: (0.1, [2, 3, 4], 0.7),
    angular_acceleration: ([2, 3, 4], np.eye(3), [1, 2, 3]),
    partial(free_decay, times=[0.0, 1.0]): ([2, 3, 4], np.eye(3), [0.1, 0.2, 0.3]),
    kinetic_energy: ([2, 3, 4], [[1, 2, 3], [4, 5, 6]]),
    partial(decay_rate, [0, 1, 2]): ([3, 2, 1.5],),
}


def named(function: Any) -> str:
    return str(getattr(function, "func", function).__name__)


def fields(result: Any) -> list[Any]:
    return list(result) if isinstance(result, tuple) else [result]


@pytest.mark.parametrize("function", EXAMPLES, ids=named)
def test_leading_axes_of_all_arguments_broadcast(function: Callable[..., Any]) -> None:
    arguments = [np.asarray(argument, dtype=float) for argument in EXAMPLES[function]]
    single = fields(function(*arguments))
    for position, argument in enumerate(arguments):
        tiled = [np.broadcast_to(a, (2, 1, *a.shape)) if k == position else a for k, a in enumerate(arguments)]
        for one, many in zip(single, fields(function(*tiled)), strict=True):
            assert many.shape == (2, 1, *np.shape(one)), position
            assert_allclose(many[1, 0], one, rtol=1e-13, atol=1e-13)
        if argument.ndim:
            continue
        across = [np.full(4, a) if k == position else a for k, a in enumerate(arguments)]
        assert [np.shape(x)[0] for x in fields(function(*across))] == [4] * len(single)


def test_every_public_function_on_bodies_is_among_the_examples() -> None:
    on_arrays = {
        name
        for module in (tensors, orientation, damping, decay)
        for name, value in vars(module).items()
        if inspect.isfunction(value) and value.__module__ == module.__name__ and not name.startswith("_")
    }
    assert on_arrays == {named(function) for function in EXAMPLES}


# --- tensors and moments ----------------------------------------------------------------------------------------------


@quick
@given(any_moments, rotations)
def test_a_tensor_comes_back_from_its_principal_moments_and_axes(moments: Any, axes: Array) -> None:
    tensor = inertia_tensor(moments, axes)
    found, principal = principal_inertia(tensor)
    assert_allclose(found, np.sort(moments), rtol=0, atol=1e-13 * max(moments))
    assert (np.diff(found) >= 0).all()
    assert_allclose(np.linalg.det(principal), 1, rtol=1e-13)
    assert_allclose(inertia_tensor(found, principal), tensor, rtol=0, atol=1e-13 * max(moments))


def test_both_halves_of_a_tensor_count() -> None:
    tensor = np.array([[3, 1 + 1e-10, 0], [1, 3, 0], [0, 0, 5]])
    assert_allclose(principal_inertia(tensor).moments, [2 - 5e-11, 4 + 5e-11, 5], rtol=0, atol=1e-14)


@quick
@given(physical_moments, rational_rotations(), st.tuples(*[st.integers(1, 9)] * 3))
def test_moments_coefficients_and_damping_are_those_of_the_derivation(moments: Any, exact: Exact, gains: Any) -> None:
    axes = np.array(exact, dtype=float)
    values = {**letters("I", moments), **letters("a", exact), **letters("k", gains)}
    assert_allclose(axial_moments(moments, axes), numbers(derivation.axial_moments, values), rtol=1e-14)
    assert_allclose(second_order_moments(moments, axes), numbers(derivation.second_order_moments, values), rtol=1e-14)
    matrix = np.reshape(numbers(derivation.damping_entries, values), (3, 3))
    assert_allclose(damping_matrix(gains, axes), matrix, rtol=0, atol=1e-14 * max(gains))
    coefficients = numbers(characteristic_coefficients_of_the_derivation, values)
    assert_allclose(characteristic_coefficients(moments, gains, axes), coefficients, rtol=1e-13)


@quick
@given(physical_moments, rational_rotations())
def test_products_and_their_distances_from_the_bounds_are_exact(moments: Any, exact: Exact) -> None:
    axes = np.array(exact, dtype=float)
    axial, forms = exact_moments(moments, exact), exact_forms(moments, exact)
    f, least = axial[0] * axial[1] * axial[2], Fraction(moments[0] * moments[1] * moments[2])
    greatest, s = Fraction(sum(moments), 3) ** 3, sum((x * y for x, y in zip(axial, forms, strict=True)), Fraction(0))
    product, total = product_of_axial_moments(moments, axes), sum_of_products(moments, axes)
    expected = [f, least, greatest, f - least, greatest - f]
    assert_allclose(product, [float(x) for x in expected], rtol=1e-13, atol=1e-14 * float(greatest))
    assert_allclose(total, [float(s), float(3 * least), float(s - 3 * least)], rtol=1e-13, atol=1e-14 * float(s))


@quick
@given(any_moments, rotations)
def test_no_product_leaves_its_bounds(moments: Any, axes: Array) -> None:
    product, total = product_of_axial_moments(moments, axes), sum_of_products(moments, axes)
    assert min(product.excess, product.deficit, total.excess) >= 0
    rounding = 1e-14 * product.greatest
    assert product.least - rounding <= product.value <= product.greatest + rounding
    assert total.value >= total.least * (1 - 1e-14)


@pytest.mark.parametrize("angle", [1e-3, 1e-6, 1e-9])
def test_distances_keep_their_digits_near_the_bounds(angle: float) -> None:
    i1, i2, i3 = moments = (2.0, 3.0, 4.5)
    turned = direction_cosines(angle, 0, 0)
    s = np.sin(angle) * np.cos(angle)
    product = product_of_axial_moments(moments, turned)
    assert_allclose(product.excess, i2 * (i1 - i3) ** 2 * s**2, rtol=1e-12)
    # S = J_1 L_1 + I_2 I_3 I_1 + J_3 L_3
    assert_allclose(sum_of_products(moments, turned).excess, 2 * i2 * (i1 - i3) ** 2 * s**2, rtol=1e-12)
    equal = equal_moment_axes(moments, 0.3)
    beside = direction_cosines(0, angle, 0) @ equal
    j = (beside * np.array(moments) @ beside.T).astype(np.longdouble)
    mean = np.longdouble(sum(moments)) / 3
    shift = np.diag(j) - mean  # their product's distance from the cube of the mean, to second order
    deficit = -mean * (shift[0] * shift[1] + shift[1] * shift[2] + shift[2] * shift[0])
    assert_allclose(float(product_of_axial_moments(moments, beside).deficit), float(deficit), rtol=3e-2, atol=1e-29)


@pytest.mark.parametrize("order", [(0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)])
def test_the_six_cases_attain_both_lower_bounds(order: tuple[int, ...]) -> None:
    axes = np.eye(3)[list(order)]
    for moments in ((2, 3, 4), (1, 1, 1), (2, 2, 3)):
        assert product_of_axial_moments(moments, axes).excess == 0
        assert sum_of_products(moments, axes).excess == 0


@quick
@given(physical_moments, rotations)
def test_the_product_is_at_most_its_bound_at_the_second_moment(moments: Any, axes: Array) -> None:
    second = axial_moments(moments, axes)[1]
    bound = bound_at_given_moment(moments, second)
    assert product_of_axial_moments(moments, axes).value <= bound * (1 + 1e-14)
    assert bound <= product_of_axial_moments(moments, axes).greatest * (1 + 1e-14)


@quick
@given(second_moments)
def test_second_moments_of_the_mass_come_back_from_the_principal_moments(second: Any) -> None:
    values = letters("P", second)
    moments = numbers(derivation.moments_of_a_mass_distribution, values)
    assert second_moments_of_mass(moments).tolist() == list(second)
    assert (triangle_slack(moments) > 0).all()


def test_a_plate_and_a_rod_are_distributions_of_mass() -> None:
    assert second_moments_of_mass([0.1, 0.2, 0.1 + 0.2])[2] == 0
    assert second_moments_of_mass([0.1, 0.2, 0.3])[2] == pytest.approx(0, abs=1e-16)
    assert second_moments_of_mass([0, 1, 1]).tolist() == [1, 0, 0]
    rounded_up = np.nextafter(0.1 + 0.2, 1)
    assert triangle_slack([0.1, 0.2, rounded_up])[2] < 0
    assert second_moments_of_mass([0.1, 0.2, rounded_up])[2] == 0


# --- orientations -----------------------------------------------------------------------------------------------------


@quick
@given(angles, angles, angles)
def test_the_angles_are_the_turns_y_z_x_of_figure_1(pitch: float, yaw: float, roll: float) -> None:
    expected = Rotation.from_euler("YZX", [pitch, yaw, roll]).as_matrix()
    assert_allclose(direction_cosines(pitch, yaw, roll), expected, atol=1e-14)


@quick
@given(angles, st.one_of(angles, st.sampled_from([np.pi / 2, -np.pi / 2, np.pi / 2 - 1e-9, 0.0])), angles)
def test_axes_come_back_from_their_angles_at_every_yaw(pitch: float, yaw: float, roll: float) -> None:
    axes = direction_cosines(pitch, yaw, roll)
    found = attitude_angles(axes)
    assert_allclose(direction_cosines(*found), axes, atol=1e-14)
    assert abs(found.yaw) <= np.pi / 2


@quick
@given(rotations)
def test_rational_axes_come_back_from_their_angles(axes: Array) -> None:
    assert_allclose(direction_cosines(*attitude_angles(axes)), axes, atol=1e-14)


def assert_equal_moments(moments: Any, axes: Array) -> None:
    assert_allclose(axial_moments(moments, axes), np.full(3, np.mean(moments)), rtol=0, atol=1e-14 * max(moments))
    assert_allclose(axes @ axes.T, np.eye(3), atol=1e-14)
    assert_allclose(np.linalg.det(axes), 1, rtol=1e-14)


@quick
@given(any_moments)
def test_the_axes_of_the_paper_have_equal_moments(moments: Any) -> None:
    axes = direction_cosines(*equal_moment_angles(moments))
    assert_equal_moments(moments, axes)
    assert product_of_axial_moments(moments, axes).deficit <= 1e-28 * max(moments) ** 3


phases = st.one_of(st.floats(-10, 10), st.sampled_from([0.0, np.pi / 2, np.pi, -np.pi / 2, 1e-200, 1e-9]))


@settings(deadline=None, max_examples=200)
@given(any_moments, phases, st.integers(-5, 5), st.sampled_from([1, -1]))
def test_the_whole_family_has_equal_moments(moments: Any, phase: float, turns: int, nappe: int) -> None:
    axes = equal_moment_axes(moments, phase, turns, nappe)
    assert_equal_moments(moments, axes)
    i1, i2, i3 = moments
    t = np.array([i2 - i3, i3 - i1, i1 - i2])
    for row in axes:  # B.5
        assert_allclose(np.cross(row**2 - 1 / 3, t), 0, atol=1e-13 * max(moments))
    assert_allclose(equal_moment_axes(moments, phase, turns + 4, nappe), axes, atol=1e-14)
    following = equal_moment_axes(moments, phase, turns + 1, nappe)
    assert_allclose(following, np.stack([axes[0], axes[2], -axes[1]]), atol=1e-14)


def turned_until(condition: Callable[[Array], float], axes: Array, i: int, j: int) -> Array:
    """The axes with i and j turned about the third until a condition that changes sign over 90 degrees is zero."""

    def turned(angle: float) -> Array:
        result = axes.copy()
        result[i] = np.cos(angle) * axes[i] + np.sin(angle) * axes[j]
        result[j] = np.cos(angle) * axes[j] - np.sin(angle) * axes[i]
        return result

    return turned(brentq(lambda angle: condition(turned(angle)), 0, np.pi / 2, xtol=1e-15, rtol=1e-15))


def equal_by_search(moments: Any, axes: Array) -> Array:
    """Axes of equal moments found by two turns from any axes, with no formula of the family."""
    mean = np.mean(moments)
    order = np.argsort(axial_moments(moments, axes))[::-1]
    axes = axes[order] * np.array([1, 1, np.linalg.det(np.eye(3)[order])])[:, None]
    first = turned_until(lambda a: float(axial_moments(moments, a)[0] - mean), axes, 0, 2)
    return turned_until(lambda a: float(np.subtract(*axial_moments(moments, a)[1:])), first, 1, 2)


def member_nearest(moments: Any, axes: Array) -> Array:
    """The member of the family with the same first axis that is nearest to the given axes."""
    apex = int(np.argmax(np.abs(np.subtract(moments, np.mean(moments)))))
    across, up = (apex + 1) % 3, (apex + 2) % 3
    [cosine, sine] = equal_moment_axes(moments, [0, np.pi / 2])[:, 0][[0, 1], [across, up]]
    phase = np.arctan2(axes[0, up] / sine, axes[0, across] / cosine)
    members = equal_moment_axes(moments, phase, np.arange(4), 1 if axes[0, apex] > 0 else -1)
    return members[np.argmin(np.abs(members - axes).max(axis=(-1, -2)))]


generic = st.tuples(*[st.integers(1, 40)] * 3).filter(lambda i: len(set(i)) > 1 and all(3 * x != sum(i) for x in i))


@quick
@given(generic, rotations)
def test_whatever_has_equal_moments_is_a_member_of_the_family(moments: Any, start: Array) -> None:
    axial = axial_moments(moments, start)
    assume(np.ptp(axial) > 1e-3)
    axes = equal_by_search(moments, start)
    assert_allclose(axial_moments(moments, axes), np.mean(moments), rtol=1e-12)
    for turned in (axes, np.roll(axes, 1, axis=0), direction_cosines(*equal_moment_angles(moments))):
        assert_allclose(member_nearest(moments, turned), turned, atol=1e-9)


def circle(angle: float) -> dict[str, float]:
    return {"u": np.cos(angle), "v": np.sin(angle)}


@pytest.mark.parametrize("angle", np.linspace(0.1, 6, 7))
def test_where_a_moment_is_the_mean_the_rest_is_the_family_with_its_rows_moved_on(angle: float) -> None:
    values = dict(
        zip(derivation.exceptional_family(), numbers(derivation.exceptional_family, circle(angle)), strict=True)
    )
    moments = [values[f"I_{i}"] for i in (1, 2, 3)]
    axes = np.array([[values[f"a_{i}{j}"] for j in (1, 2, 3)] for i in (1, 2, 3)])
    assert_equal_moments(moments, axes)
    fine = np.linspace(0, 2 * np.pi, 721)[:, None, None]
    members = equal_moment_axes(moments, fine, np.arange(4), np.array([[1], [-1]]))
    closest = [np.abs(members - np.roll(axes, k, axis=0)).max(axis=(-1, -2)).min() for k in (0, 1, 2)]
    assert closest[0] > 0.05  # B.13: not a member itself
    assert min(closest[1:]) < 0.01


# --- damping ----------------------------------------------------------------------------------------------------------


@quick
@given(triples, rotations, rotations)
def test_devices_along_any_axes_act_like_devices_along_orthogonal_ones(gains: Any, one: Array, other: Array) -> None:
    axes = np.stack([one[0], other[1], one[2]])
    matrix = damping_matrix(gains, axes)
    assert_allclose(matrix, axes.T @ np.diag(gains) @ axes, rtol=0, atol=1e-13 * max(gains))
    equivalent = orthogonal_devices(matrix)
    assert_allclose(np.linalg.det(equivalent.axes), 1, rtol=1e-13)
    assert_allclose(equivalent.axes.T @ np.diag(equivalent.gains) @ equivalent.axes, matrix, atol=1e-13 * max(gains))


@quick
@given(triples, triples, rotations)
def test_the_roots_are_those_of_the_characteristic_equation(moments: Any, gains: Any, axes: Array) -> None:
    roots = characteristic_roots(moments, damping_matrix(gains, axes))
    coefficients = characteristic_coefficients(moments, gains, axes)
    spread = roots.min() / roots.max()  # each root is right to rounding of the largest
    assert_allclose(np.poly(roots), coefficients / coefficients[0], rtol=1e-13 + 1e-14 * spread)
    assert stability_degree(moments, damping_matrix(gains, axes)) == -roots.max() > 0


@quick
@given(positive, triples, rotations)
def test_the_harmonic_mean_of_the_rates_is_the_ratio_and_bounds_the_degree(
    ratio: float, moments: Any, axes: Array
) -> None:
    rates = -characteristic_roots(moments, damping_matrix(gains_in_proportion(ratio, moments, axes), axes))
    mean, excess = harmonic_mean_of_rates(rates)
    assert_allclose(mean, ratio, rtol=1e-10)
    assert_allclose(rates.min() + excess, mean, rtol=1e-12)
    assert rates.min() <= ratio * (1 + 1e-13)


@quick
@given(positive, triples)
def test_the_optimum_is_a_triple_root_at_the_ratio(degree: float, moments: Any) -> None:
    gains, axes = optimal_devices(moments, degree)
    assert_allclose(characteristic_roots(moments, damping_matrix(gains, axes)), -degree, rtol=1e-14)
    assert_allclose(gains, degree * np.array(moments), rtol=1e-15)


def test_from_coefficients_the_triple_root_is_known_to_a_third_of_the_digits() -> None:
    moments, axes = (2.1, 3.3, 4.7), direction_cosines(0.0, 0.0, 0.0)
    gains = gains_in_proportion(0.7, moments, axes)
    from_coefficients = np.roots(characteristic_coefficients(moments, gains, axes))
    assert np.abs(from_coefficients + 0.7).max() > 1e-8
    assert np.abs(characteristic_roots(moments, damping_matrix(gains, axes)) + 0.7).max() < 1e-15


@quick
@given(
    positive,
    any_moments,
    st.one_of(angles, st.sampled_from([0.0, np.pi / 2, -np.pi / 4, np.pi, 3 * np.pi / 4, 4e-159, 1e-200])),
)
def test_the_degree_in_pitch_is_that_of_the_roots(ratio: float, moments: Any, pitch: float) -> None:
    axes = direction_cosines(pitch, 0, 0)
    roots = characteristic_roots(moments, damping_matrix(gains_in_proportion(ratio, moments, axes), axes))
    degree = stability_degree_in_pitch(ratio, moments, pitch)
    assert_allclose(degree, -roots.max(), rtol=0, atol=1e-13 * -roots.min())
    assert ratio / 2 <= degree <= ratio * (1 + 1e-15)
    assert stability_degree_in_pitch(ratio, moments, np.pi / 4) <= degree * (1 + 1e-14)


# --- decay ------------------------------------------------------------------------------------------------------------


@quick
@given(physical_moments, rational_rotations(), st.tuples(*[st.integers(0, 9)] * 3), st.tuples(*[integers] * 3))
def test_the_acceleration_solves_the_equations_of_motion(moments: Any, exact: Exact, gains: Any, rate: Any) -> None:
    matrix = damping_matrix(gains, np.array(exact, dtype=float))
    acceleration = angular_acceleration(moments, matrix, rate)
    values = {**letters("I", moments), **letters("a", exact), **letters("k", gains), **letters("omega", rate)}
    residual = numbers(derivation.equations_of_motion, {**values, **letters("domega", acceleration)})
    assert_allclose(residual, 0, atol=1e-11)


rates_of_turn = st.tuples(*[st.floats(-2, 2)] * 3).filter(lambda w: np.linalg.norm(w) > 1e-3)
TIMES = np.linspace(0, 4, 9)


@slower
@given(triples, triples, rotations, rates_of_turn)
def test_every_rotation_decays_between_the_least_and_the_greatest_rate(
    moments: Any, shares: Any, axes: Array, rate: Any
) -> None:
    moments = np.array(moments) / max(moments) + 0.2
    matrix = damping_matrix(np.array(shares) / max(shares), axes)
    energy = kinetic_energy(moments, free_decay(moments, matrix, rate, TIMES))
    roots = characteristic_roots(moments, matrix)
    left = np.sqrt(energy[0] / energy[1:]) * np.exp(roots[2] * TIMES[-1])  # the tolerance is relative to this
    for k, allowed in enumerate(1e-9 * (1 + left)):
        measured = decay_rate(TIMES[k : k + 2], energy[k : k + 2])
        assert -roots[2] - allowed <= measured <= -roots[0] + allowed


@slower
@given(physical_moments, rates_of_turn, st.floats(0.05, 1))
def test_at_the_optimum_the_energy_decays_exactly_at_the_stability_degree(
    moments: Any, rate: Any, degree: float
) -> None:
    matrix = damping_matrix(*optimal_devices(moments, degree))
    energy = kinetic_energy(moments, free_decay(moments, matrix, rate, TIMES))
    assert_allclose(decay_rate(TIMES, energy), degree, rtol=1e-9)
    assert_allclose(energy / energy[0], np.exp(-2 * degree * TIMES), rtol=1e-8)


@pytest.mark.parametrize("ratio", [0.05, 0.2])
def test_the_measured_decay_tends_to_the_stability_degree(ratio: float) -> None:
    moments, axes = np.array([2.0, 3.0, 4.5]), direction_cosines(0.7, 0.6, 0.5)
    matrix = damping_matrix(gains_in_proportion(ratio, moments, axes), axes)
    rates = -characteristic_roots(moments, matrix)[::-1]
    span = 14 / (rates[1] - rates[0])
    times = np.linspace(0, span, 101)
    energy = kinetic_energy(moments, free_decay(moments, matrix, [0.02, 0.03, 0.01], times))
    assert_allclose(decay_rate(times[90:], energy[90:]), stability_degree(moments, matrix), rtol=1e-8)
    assert abs(decay_rate(times[:11], energy[:11]) / rates[0] - 1) > 0.1


def test_a_small_rate_decays_as_the_linear_equations_say() -> None:
    moments = np.array([2.0, 3.0, 4.5])
    matrix = damping_matrix([0.5, 1.0, 2.0], direction_cosines(0.7, 0.6, 0.5))
    start = 1e-9 * np.array([1.0, -2.0, 3.0])
    expected = np.stack([expm(-matrix / moments[:, None] * time) @ start for time in TIMES])
    assert_allclose(free_decay(moments, matrix, start, TIMES), expected, rtol=0, atol=1e-8 * np.abs(expected).min())


def test_without_damping_energy_and_angular_momentum_stay() -> None:
    moments = np.array([2.0, 3.0, 4.5])
    rates = free_decay(moments, np.zeros((3, 3)), [0.5, 1.0, 0.01], np.linspace(0, 50, 11))
    assert_allclose(kinetic_energy(moments, rates), kinetic_energy(moments, rates)[0], rtol=1e-9)
    assert_allclose(np.linalg.norm(moments * rates, axis=-1), np.linalg.norm(moments * rates[0]), rtol=1e-9)
    assert np.ptp(rates, axis=0).min() > 0.1


def test_many_bodies_decay_as_each_alone() -> None:
    rng = np.random.default_rng(7)
    moments, start = rng.uniform(1, 2, (5, 1, 3)), rng.uniform(-1, 1, (2, 3))
    matrix = damping_matrix(rng.uniform(0.1, 1, (5, 1, 3)), direction_cosines(*rng.uniform(-3, 3, (3, 5, 1))))
    together = free_decay(moments, matrix, start, TIMES)
    assert together.shape == (5, 2, TIMES.size, 3)
    for i, j in np.ndindex(5, 2):
        alone = free_decay(moments[i, 0], matrix[i, 0], start[j], TIMES)
        assert_allclose(together[i, j], alone, rtol=0, atol=1e-9 * np.linalg.norm(alone, axis=-1).min())


@pytest.mark.parametrize("fast", [1e4, 1e6, 1e8])
def test_rates_of_decay_may_be_any_factor_apart(fast: float) -> None:
    moments, matrix = np.array([2.0, 3.0, 4.5]), np.diag([2 * fast, 3.0, 0.9])
    start = np.array([[1e-9, -2e-9, 3e-9], [0.0, 2e-9, 1e-9]])
    expected = start[:, None] * np.exp(-np.diag(matrix) / moments * TIMES[:, None])
    assert_allclose(free_decay(moments, matrix, start, TIMES), expected, rtol=0, atol=1e-8 * 1e-9 * np.exp(-TIMES[-1]))


def test_a_tensor_too_large_for_its_moments_is_an_error() -> None:
    with pytest.raises(ValueError, match=r"tensor = .* must have entries of at most 4\.5e\+307; take another unit"):
        principal_inertia(np.diag([1.5e308] * 3))


def test_a_body_at_rest_stays_at_rest() -> None:
    assert not free_decay([2, 3, 4], np.eye(3), [0, 0, 0], TIMES).any()


# --- errors -----------------------------------------------------------------------------------------------------------

EYE = np.eye(3)
LEFT = np.diag([1.0, 1.0, -1.0])
SKEW = [[1.0, 0.5, 0], [0, 1, 0], [0, 0, 1]]


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: axial_moments([2, 0, 4], EYE), r"moments\[1\] = .*0\.0.* must be positive \(mirer2009:2\.0\.6\)"),
        (lambda: axial_moments([2, 3, 1e150], EYE), r"moments\[2\] = .*1e\+150.* must lie between 1e-100 and 1e\+100"),
        (lambda: axial_moments([2, 3], EYE), r"moments has shape \(2,\); its last axes must be \(3\)"),
        (lambda: axial_moments([2, 3, np.nan], EYE), r"moments\[2\] = .*nan.* must be finite"),
        (lambda: axial_moments([2, 3, 4], SKEW), r"axes = .* must have orthonormal rows, to 1e-09 \(mirer2009:2\.7\)"),
        (lambda: axial_moments([2, 3, 4], [EYE, SKEW]), r"axes\[1\] = .* must have orthonormal rows"),
        (lambda: attitude_angles(LEFT), r"axes = .* must be right-handed \(mirer2009:2\.17\.2\)"),
        (lambda: principal_inertia(SKEW), r"tensor = .* must be symmetric \(mirer2009:1\.2\.1\)"),
        (lambda: second_moments_of_mass([1, 2, 4]), r"moments = .*1.* 2.* 4.* must satisfy the triangle .*2\.3\)"),
        (lambda: bound_at_given_moment([1, 2, 4], 1), r"moments = .* must satisfy the triangle"),
        (lambda: bound_at_given_moment([2, 3, 4], 4.6), r"moment = .*4\.6.* must lie on \[0, 3c/2\] .*2\.3\.4\)"),
        (lambda: direction_cosines(0, "x", 0), "yaw = 'x' is not an array of real numbers"),
        (lambda: equal_moment_angles([-1, 2, 3]), r"moments\[0\] = .*-1\.0.* must be positive"),
        (
            lambda: equal_moment_axes([2, 3, 4], 0, 0.5),
            r"quarter_turns = .*0\.5.* must be an integer \(mirer2009:B\.10",
        ),
        (lambda: equal_moment_axes([2, 3, 4], 0, 0, 2), r"nappe = .*2\.0.* must be 1 or -1 \(mirer2009:B\.6\)"),
        (lambda: gains_in_proportion(0, [2, 3, 4], EYE), r"ratio = .*0\.0.* must be positive \(mirer2009:1\.8\)"),
        (lambda: damping_matrix([1, -1, 1], EYE), r"gains\[1\] = .*-1\.0.* must not be negative .*1\.0\.4"),
        (
            lambda: damping_matrix([1, 1, 1], SKEW),
            r"axes\[0\] = .* have the length 1, to 1e-09; .*:1\.0\.2\)",
        ),
        (lambda: orthogonal_devices(SKEW), r"damping = .* must be symmetric \(mirer2009:1\.2\.6\)"),
        (lambda: characteristic_coefficients([2, 3, 4], [1, 2, -3], EYE), r"gains\[2\] = .*-3\.0.* must not be neg"),
        (lambda: optimal_devices([2, 3, 4], -1), r"degree = .*-1\.0.* must be positive"),
        (lambda: harmonic_mean_of_rates([1, 0, 2]), r"rates\[1\] = .*0\.0.* must be positive \(mirer2009:B\.4\)"),
        (lambda: stability_degree_in_pitch(1, [2, 3, 4], np.inf), "pitch = .*inf.* must be finite"),
        (
            lambda: free_decay([2, 3, 4], -EYE, [1, 0, 0], TIMES),
            r"damping = .* must amplify no rotation \(mirer2009:1\.1",
        ),
        (lambda: free_decay([2, 3, 4], EYE, [1, 0, 0], [0, 1, 1]), "times = .* must be two or more, increasing"),
        (lambda: free_decay([2, 3, 4], EYE, [1, 0, 0], TIMES, 0), "tolerance = .*0.* must be positive"),
        (lambda: decay_rate([0, 1], [1, 0]), r"energy\[1\] = .*0\.0.* must be positive .*nothing to measure"),
        (lambda: plots.plot_damping_over_pitch(ratios=[0, 1]), r"ratios\[0\] = .*0\.0.* must be positive"),
    ],
)
def test_bad_input_is_reported(call: Callable[[], Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call()


# --- figures ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", plots.FIGURES)
def test_a_figure_is_drawn_with_labelled_axes_and_leaves_nothing_behind(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delitem(sys.modules, "matplotlib.pyplot", raising=False)  # other tests may have loaded it
    axes = plots.FIGURES[name]()
    image = io.BytesIO()
    FigureCanvasAgg(axes.figure).print_png(image)
    assert image.getbuffer().nbytes > 5_000
    assert axes.get_xlabel()
    assert axes.get_ylabel()
    assert "matplotlib.pyplot" not in sys.modules
    options = {"projection": "3d"} if hasattr(axes, "get_zlabel") else {}
    given_axes: Axes = Figure().add_subplot(**options)
    assert plots.FIGURES[name](ax=given_axes) is given_axes


def curves(axes: Axes) -> dict[str, Array]:
    return {str(line.get_label()): np.asarray(line.get_xydata()) for line in axes.get_lines()}


def test_the_bound_is_drawn_over_all_products() -> None:
    moments = (2.0, 3.0, 4.5)
    drawn = curves(plots.plot_bound_of_product(moments))
    points, mean = drawn["$J_1 J_2 J_3$ of some axes"], np.mean(moments)
    assert (points[:, 1] <= bound_at_given_moment(moments, points[:, 0]) * (1 + 1e-14)).all()
    assert (points[:, 1] >= np.prod(moments) * (1 - 1e-14)).all()
    assert drawn["$f_1(J_2)$"][-1, 0] == 1.5 * mean
    assert_allclose(drawn["$c^3$ at $J_2 = c$"], [[mean, mean**3]])


def test_the_drawn_decay_lies_between_the_predicted_ones() -> None:
    lines = list(curves(plots.plot_free_decay()).values())
    integrated, slowest, fastest = (line[:, 1] for line in lines)
    assert (integrated <= slowest * (1 + 1e-9)).all()
    assert (integrated >= fastest * (1 - 1e-9)).all()


def test_the_arcs_of_figure_1_lead_from_the_axes_y_to_the_principal_axes() -> None:
    pitch, yaw, roll = 0.7, 0.6, 0.5
    lines = [np.array(line.get_data_3d()) for line in plots.plot_attitude_angles(pitch, yaw, roll).get_lines()]
    alpha, beta, gamma = lines[6:]
    cosines = direction_cosines(pitch, yaw, roll)
    assert_allclose(alpha[:, 0], [1, 0, 0], atol=1e-15)
    assert_allclose(alpha[:, -1], beta[:, 0], atol=1e-15)
    assert_allclose(beta[:, -1], cosines[:, 0], atol=1e-15)
    assert_allclose(gamma[:, -1], cosines[:, 1], atol=1e-15)
    for arc, angle in ((alpha, pitch), (beta, yaw), (gamma, roll)):
        assert_allclose(np.arccos(arc[:, 0] @ arc[:, -1]), angle, rtol=1e-12)
