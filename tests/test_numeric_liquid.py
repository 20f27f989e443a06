"""A spinning body with liquid: frequencies, stability and boundary agree with the derivation and with the motion."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from symcheck import kernels
from symcheck.numeric import liquid
from symcheck.numeric.liquid import boundary, plots, spectrum
from symcheck.papers.esenkov2006 import derivation

MODULES = (spectrum, boundary, plots)
KERNELS = kernels.load("esenkov2006")
quick = settings(deadline=None, max_examples=60)


class Body(NamedTuple):
    """What `stability` takes."""

    A: float
    C: float
    E_n: Any
    lambda_n: Any
    omega_0: float

    @property
    def ratios(self) -> Any:
        return np.asarray(self.lambda_n) / self.omega_0

    @property
    def scale(self) -> float:
        """A bound of the frequencies' size."""
        rest = self.A - np.sum(self.E_n)
        return float((abs(self.C - self.A) + self.A) / rest * self.omega_0 + 2 * np.abs(self.lambda_n).max())


IN_THE_BAND = st.floats(0.02, 0.98)
OFF_THE_BAND = st.one_of(st.floats(-3, -0.02), st.floats(1.02, 3))
ANYWHERE = st.one_of(IN_THE_BAND, OFF_THE_BAND)


@st.composite
def bodies(
    draw: st.DrawFn,
    ratios: st.SearchStrategy[float] = ANYWHERE,
    modes: tuple[int, int] = (1, 4),
    long: bool | None = None,
) -> Body:
    """A body of any size and spin; `long`: C < A, not so, or either."""
    A, omega_0 = draw(st.floats(0.1, 10)), draw(st.floats(0.1, 10))
    many = draw(st.integers(*modes))
    shares = np.array(draw(st.lists(st.floats(0.05, 1), min_size=many, max_size=many)))
    E_n = A * draw(st.floats(0.01, 0.9)) * shares / shares.sum()
    apart = st.lists(ratios, min_size=many, max_size=many, unique_by=lambda ratio: round(ratio * 50))
    low, high = {True: (0.01, 0.99), False: (1.0, 2.0), None: (0.01, 2.0)}[long]
    return Body(A, A * draw(st.floats(low, high)), E_n, omega_0 * np.array(draw(apart)), omega_0)


# --- the roots are those of the derivation


@cache
def polynomial(modes: int) -> Callable[..., Any]:
    """Coefficients of the characteristic polynomial, worked out by SymPy from the equations of motion."""
    eta = sp.Symbol("eta", real=True)
    letters = [sp.Symbol(f"{letter}_{n}", real=True) for letter in ("E", "lambda") for n in range(1, modes + 1)]
    single = [sp.Symbol(name, real=True) for name in ("A", "C", "omega_0")]
    return sp.lambdify([*single, *letters], sp.Poly(derivation.characteristic_polynomial(modes), eta).all_coeffs())


@quick
@given(bodies(modes=(1, 3)))
def test_the_frequencies_are_the_roots_of_the_derived_polynomial(body: Body) -> None:
    found = liquid.frequencies(*body)
    coefficients = np.array(polynomial(len(body.E_n))(body.A, body.C, body.omega_0, *body.E_n, *body.lambda_n))
    assert found.shape == (len(body.E_n) + 1,)
    sizes = np.polyval(np.abs(coefficients), body.scale)
    assert np.abs(np.polyval(coefficients, found)).max() <= 1e-12 * sizes
    sums = (
        np.sum(found) * coefficients[0] + coefficients[1],
        np.prod(found) * coefficients[0] - coefficients[-1] * (-1) ** len(found),
    )
    assert np.abs(sums[0]) <= 1e-12 * abs(coefficients[0]) * body.scale
    assert np.abs(sums[1]) <= 1e-11 * abs(coefficients[0]) * body.scale ** len(found)


@quick
@given(bodies())
def test_the_conjugate_of_a_frequency_is_one_too(body: Body) -> None:
    found = liquid.frequencies(*body)
    assert np.array_equal(np.sort(found.conj()), found)
    assert liquid.growth_rate(*body) == -found.imag.min()


@quick
@given(bodies(modes=(1, 1)))
def test_a_mode_split_in_two_adds_only_its_own_frequency(body: Body) -> None:
    """One mode goes through the kernels, its halves through LAPACK."""
    halves = body._replace(E_n=np.repeat(body.E_n / 2, 2), lambda_n=np.repeat(body.lambda_n, 2))
    expected = np.poly([*liquid.frequencies(*body), *body.lambda_n])
    sizes = body.scale ** np.arange(4)
    assert np.abs(np.poly(liquid.frequencies(*halves)) - expected) / sizes == pytest.approx(0, abs=1e-12)
    discriminant = KERNELS.discriminant(body.A, body.C, *body.E_n, *body.lambda_n, body.omega_0)
    assume(abs(discriminant) > 1e-9 * (body.A * body.scale) ** 2)
    assert liquid.is_stable(*halves) == liquid.is_stable(*body)


@quick
@given(bodies(modes=(2, 4)), st.randoms(use_true_random=False), st.sampled_from([1e-9, 0.01, 7.0, 1e9]))
def test_neither_the_order_of_the_modes_nor_the_units_matter(body: Body, random: Any, unit: float) -> None:
    order = random.sample(range(len(body.E_n)), len(body.E_n))
    moments = unit * body.A, unit * body.C, unit * body.E_n[order]
    found = liquid.frequencies(*moments, unit * body.lambda_n[order], unit * body.omega_0)
    expected = np.poly(liquid.frequencies(*body))
    sizes = body.scale ** np.arange(len(expected))
    assert np.abs(np.poly(found / unit) - expected) / sizes == pytest.approx(0, abs=1e-11)


@quick
@given(bodies(IN_THE_BAND, modes=(1, 1), long=False))
def test_the_frequencies_of_a_flattened_body_are_those_of_the_kernel(body: Body) -> None:
    assume(body.C > body.A * (1 + 1e-6))
    expected = KERNELS.frequencies(body.A, body.C - body.A, *body.E_n, *body.ratios, body.omega_0)
    assert liquid.frequencies(*body) == pytest.approx(np.array(expected), abs=1e-12 * body.scale)


@pytest.mark.parametrize("ratio", [0.0, 1.0])
@quick
@given(bodies(modes=(1, 3)))
def test_a_mode_at_an_end_of_the_band_keeps_its_frequency(ratio: float, body: Body) -> None:
    natural = body.lambda_n.copy()
    natural[0] = ratio * body.omega_0
    found = liquid.frequencies(*body._replace(lambda_n=natural))
    assert np.abs(found - natural[0]).min() <= 1e-7 * body.scale  # it may be double


# --- stability


@quick
@given(bodies(OFF_THE_BAND))
def test_off_the_band_the_frequencies_are_real_and_separated_by_the_modes(body: Body) -> None:
    found, modes = liquid.frequencies(*body), np.sort(body.lambda_n)
    rounding = 1e-13 * body.scale
    assert (found.imag == 0).all()
    assert liquid.is_stable(*body)
    assert (found.real[:-1] <= modes + rounding).all()
    assert (found.real[1:] >= modes - rounding).all()


@quick
@given(bodies(long=False))
def test_a_body_that_is_not_long_has_real_frequencies(body: Body) -> None:
    assert liquid.growth_rate(*body) == 0


@pytest.mark.parametrize("parts", [1, 2, 3])
def test_rounding_makes_no_body_unstable_that_is_not_long(parts: int) -> None:
    """Where A b_1 = E_1 the boundary touches C = A: the frequencies are double there, and the discriminant is zero."""
    E_1 = np.linspace(0.011, 0.97, 500)
    E_n, lambda_n = (np.repeat(each[:, None], parts, axis=1) for each in (E_1 / parts, E_1 / 0.99 * 1.7))
    found = liquid.stability(0.99, 0.99, E_n, lambda_n, 1.7)
    assert np.array_equal(found.growth_rate, np.zeros(500))
    assert np.diff(found.frequencies.real).min(-1) == pytest.approx(0, abs=1e-6)


@quick
@given(bodies(modes=(1, 1)))
def test_one_mode_is_stable_where_the_discriminant_is_positive(body: Body) -> None:
    discriminant = KERNELS.discriminant(body.A, body.C, *body.E_n, *body.lambda_n, body.omega_0)
    assume(abs(discriminant) > 1e-13 * (body.A * body.scale) ** 2)
    assert liquid.is_stable(*body) == (discriminant > 0)
    rate = np.sqrt(max(-discriminant, 0)) / (2 * (body.A - body.E_n[0]))
    assert liquid.growth_rate(*body) == pytest.approx(rate, rel=1e-3)


@pytest.mark.parametrize("modes", [1, 2])
def test_the_growth_rate_keeps_its_digits_where_a_mode_carries_little(modes: int) -> None:
    """The discriminant of 1.33.3 has lost them all long before. The second mode carries less still, off the band."""
    carried = np.array([1e-4, 1e-8, 1e-12, 1e-16, 1e-20])
    boundary = liquid.boundary_of_stability(1.0, carried, 0.25)
    E_n, lambda_n = carried[:, None] * [1, 1e-20][:modes], [0.25, -1.0][:modes]
    found = liquid.growth_rate(1.0, 1 + (boundary.lower + boundary.upper) / 2, E_n, lambda_n, 1.0)
    assert found == pytest.approx(boundary.greatest_growth_rate, rel=1e-5)


def test_modes_that_nearly_coincide_make_no_stable_body_unstable() -> None:
    """LAPACK gives some of their frequencies an imaginary part in the last place."""
    rng = np.random.default_rng(0)
    gaps = rng.choice([0, 1e-16, 1e-15, 1e-13, 1e-10], (4000, 1)) * rng.integers(-3, 4, (4000, 4))
    ratio, C, E_n = (
        rng.uniform(0.1, 0.9, (4000, 1)),
        rng.uniform(0.01, 0.99, 4000),
        10 ** rng.uniform(-12, -2, (4000, 4)),
    )
    as_one = liquid.stability(1.0, C, E_n.sum(-1, keepdims=True), ratio, 1.0)
    clearly = as_one.stable & (np.abs(np.diff(as_one.frequencies.real)[:, 0]) > 1e-3)
    assert clearly.sum() > 1000
    assert liquid.is_stable(1.0, C, E_n, ratio + gaps, 1.0)[clearly].all()


# --- its boundary


@st.composite
def modes_in_the_band(draw: st.DrawFn) -> tuple[float, float, float, float]:
    A = draw(st.floats(0.1, 10))
    return A, A * draw(st.floats(0.01, 0.95)), draw(IN_THE_BAND), draw(st.floats(0.1, 10))


@quick
@given(modes_in_the_band())
def test_the_frequencies_are_double_at_the_boundary_and_only_there(mode: tuple[float, float, float, float]) -> None:
    A, E_1, b_1, omega_0 = mode
    found = liquid.boundary_of_stability(*mode)
    for Delta, frequency, inwards in (
        (found.lower, found.lower_frequency, 1),
        (found.upper, found.upper_frequency, -1),
    ):
        body = Body(A, A + Delta, [E_1], [b_1 * omega_0], omega_0)
        assume(body.C > 1e-3 * A)
        assert liquid.frequencies(*body) == pytest.approx(np.full(2, frequency), abs=3e-7 * body.scale)
        step = inwards * 1e-6 * found.width
        inside, outside = body._replace(C=body.C + step), body._replace(C=body.C - step)
        assert liquid.growth_rate(*inside) > 1e-4 * found.greatest_growth_rate
        assert not liquid.is_stable(*inside)
        assert liquid.is_stable(*outside)
        apart = np.diff(liquid.frequencies(*outside).real)
        assert apart > 1e-4 * found.greatest_growth_rate


@quick
@given(modes_in_the_band())
def test_the_growth_rate_is_greatest_midway_between_the_ends(mode: tuple[float, float, float, float]) -> None:
    A, E_1, b_1, omega_0 = mode
    found = liquid.boundary_of_stability(*mode)
    Delta = found.lower + found.width * np.array([0.3, 0.5, 0.7])
    rates = liquid.growth_rate(A, A + Delta, [E_1], [b_1 * omega_0], omega_0)
    assert rates[1] == pytest.approx(found.greatest_growth_rate, rel=1e-9)
    assert rates[1] > max(rates[0], rates[2])
    assert found.upper - found.lower == pytest.approx(found.width)


@quick
@given(modes_in_the_band())
def test_the_unstable_interval_of_one_mode_is_that_of_the_formula(mode: tuple[float, float, float, float]) -> None:
    A, E_1, b_1, omega_0 = mode
    found = liquid.unstable_intervals(A, [E_1], [b_1 * omega_0], omega_0)
    boundary = liquid.boundary_of_stability(*mode)
    assert found == pytest.approx(np.array([[boundary.lower, boundary.upper]]), abs=1e-9 * A)


def assert_unstable_there_and_nowhere_else(body: Body) -> None:
    A, _, *modes = body
    found = liquid.unstable_intervals(A, *modes)
    assert found.shape[1:] == (2,)
    assert len(found) <= len(body.E_n)
    assert (found >= -A).all()
    assert (found <= 0).all()
    assert (np.diff(found.ravel()) > 0).all()
    assert bool(len(found)) == bool(((body.ratios > 0) & (body.ratios < 1)).any())
    Delta = np.linspace(-0.999, 0.5, 301) * A
    near = np.abs(Delta[:, None] - found.ravel()).min(-1, initial=np.inf) < 1e-7 * A
    inside = ((found[:, 0] < Delta[:, None]) & (Delta[:, None] < found[:, 1])).any(-1)
    assert np.array_equal(liquid.is_stable(A, A + Delta, *modes)[~near], ~inside[~near])


@quick
@given(bodies())
def test_the_body_is_unstable_in_its_intervals_and_nowhere_else(body: Body) -> None:
    assert_unstable_there_and_nowhere_else(body)


@pytest.mark.parametrize("ratio", [0.0, 1.0])
@quick
@given(bodies(modes=(1, 3)))
def test_a_mode_at_an_end_of_the_band_makes_no_interval(ratio: float, body: Body) -> None:
    body.lambda_n[0] = ratio * body.omega_0
    assert_unstable_there_and_nowhere_else(body)


@pytest.mark.parametrize("gap", [0.0, 1e-16, 1e-12, 1e-8, 1e-4])
def test_modes_that_nearly_coincide_act_as_one(gap: float) -> None:
    found = liquid.unstable_intervals(1.0, [0.2, 0.02], [0.7 + gap, 0.7], 1.0)
    as_one = liquid.unstable_intervals(1.0, [0.22], [0.7], 1.0)
    assert found == pytest.approx(as_one, abs=1e-7 + 2 * gap)


# --- the motion


class Liquid(NamedTuple):
    """A body by the letters of its equations of motion, with a time over which to follow it."""

    A: float
    C: float
    omega_0: float
    a_n: tuple[float, ...]
    chi_n: tuple[float, ...]
    N_n: tuple[float, ...]
    lambda_n: tuple[float, ...]

    @property
    def body(self) -> Body:
        return Body(self.A, self.C, liquid.mode_inertia(self.a_n, self.chi_n, self.N_n), self.lambda_n, self.omega_0)


MOTIONS = {
    "long, one mode": Liquid(1.0, 0.5, 1.0, (0.4,), (0.5,), (1.0,), (0.5,)),
    "long, weakly coupled": Liquid(1.0, 0.72, 1.0, (0.1,), (0.2,), (1.5,), (0.3,)),
    "flattened": Liquid(1.0, 1.4, 1.0, (0.4,), (0.5,), (1.0,), (0.5,)),
    "long, mode against the spin": Liquid(2.0, 0.7, 1.5, (-0.4,), (-0.5,), (0.9,), (-0.8,)),
    "two modes, one in the band": Liquid(1.0, 0.5, 1.0, (0.4, 0.1), (0.5, 1.0), (1.0, 1.0), (0.5, -1.0)),
    "two modes in the band": Liquid(3.0, 0.7, 2.0, (0.4, 0.3), (0.5, 0.8), (0.8, 1.1), (0.6, 1.4)),
    "three modes": Liquid(1.0, 0.45, 1.0, (0.2, 0.1, 0.3), (0.5, 1.0, 0.2), (1.0, 2.0, 1.0), (0.6, 1.7, -0.4)),
}


def motion(system: Liquid, times: Any) -> Any:
    """Omega and S_n at these times, by integration of the equations of motion as they stand:

    A Omega' + i (C - A) omega_0 Omega + sum_n a_n (S_n' - i omega_0 S_n) = 0,
    N_n^2 (S_n' - i lambda_n S_n) + chi_n Omega' = 0.
    """
    a, chi, norm = (np.array(each) for each in (system.a_n, system.chi_n, np.square(system.N_n)))
    rates = np.block([[np.array([[system.A]]), a[None]], [chi[:, None], np.diag(norm)]])
    values = np.diag([-1j * (system.C - system.A) * system.omega_0, *1j * norm * system.lambda_n])
    values[0, 1:] = 1j * system.omega_0 * a
    step = np.linalg.solve(rates, values)
    start = np.exp(1j * np.arange(len(a) + 1.0)) / np.arange(1, len(a) + 2)
    found = solve_ivp(lambda _, z: step @ z, times[[0, -1]], start, "DOP853", t_eval=times, rtol=1e-11, atol=1e-13)
    assert found.success
    return found.y


def linear_prediction_error(series: Any, frequencies: Any, step: float) -> float:
    """How much a series of equally spaced values misses being a sum of e^(i eta t), each miss against its terms."""
    weights = np.poly(np.exp(1j * frequencies * step))
    rows = np.lib.stride_tricks.sliding_window_view(series, len(weights))[:, ::-1]
    return float(np.max(np.abs(rows @ weights) / (np.abs(rows) @ np.abs(weights))))


@pytest.mark.parametrize("name", MOTIONS)
def test_the_motion_has_these_frequencies(name: str) -> None:
    system, step = MOTIONS[name], 0.7
    turning = motion(system, step * np.arange(40) / system.omega_0)[0]
    found = liquid.frequencies(*system.body) / system.omega_0
    assert linear_prediction_error(turning, found, step) < 1e-9
    for k in range(len(found)):
        wrong = found + 0.01 * (np.arange(len(found)) == k)
        assert linear_prediction_error(turning, wrong, step) > 1e-5


@pytest.mark.parametrize("name", MOTIONS)
def test_the_motion_grows_at_this_rate(name: str) -> None:
    system = MOTIONS[name]
    rate = liquid.growth_rate(*system.body)
    sizes = np.linalg.norm(motion(system, np.linspace(0, 120, 241)), axis=0)
    if liquid.is_stable(*system.body):
        assert sizes[120:].max() < 1.5 * sizes[:120].max()
    else:
        early, late = sizes[160:180].max(), sizes[220:240].max()
        assert np.log(late / early) / 30 == pytest.approx(rate, abs=0.01)


def test_among_the_motions_are_stable_and_unstable_ones() -> None:
    stable = [bool(liquid.is_stable(*system.body)) for system in MOTIONS.values()]
    assert stable.count(True) >= 2
    assert stable.count(False) >= 3


@pytest.mark.parametrize("natural", [0.0, 0.5, 0.9])
def test_on_the_boundary_the_motion_grows_like_the_time(natural: float) -> None:
    upper = liquid.boundary_of_stability(1.0, 0.25, natural).upper
    system = Liquid(1.0, float(1 + upper), 1.0, (0.5,), (0.5,), (1.0,), (natural,))
    sizes = np.linalg.norm(motion(system, np.linspace(0, 400, 3)), axis=0)
    assert sizes[2] / sizes[1] == pytest.approx(2, rel=0.02)


def test_real_frequencies_that_are_double_are_not_stable() -> None:
    """A mode at rest in the body, at C - A = -E_1: both frequencies are zero, exactly."""
    found = liquid.stability(1.0, 0.75, [0.25], [0.0], 1.0)
    assert found.frequencies.tolist() == [0, 0]
    assert found.growth_rate == 0
    assert not found.stable


# --- arrays


def test_arrays_of_parameters_give_what_each_gives_alone() -> None:
    A, C = np.array([[1.0], [2.0]]), np.array([0.5, 0.9, 1.3])
    E_n, lambda_n = np.array([[0.1, 0.2], [0.3, 0.01], [0.2, 0.2]]), np.array([0.4, -0.3])
    found = liquid.stability(A, C, E_n, lambda_n, 1.0)
    assert found.frequencies.shape == (2, 3, 3)
    for i, j in np.ndindex(2, 3):
        alone = liquid.stability(A[i, 0], C[j], E_n[j], lambda_n, 1.0)
        assert all(np.array_equal(whole[i, j], one) for whole, one in zip(found, alone, strict=True))


@pytest.mark.parametrize("further", [(), (0.7,)])
def test_a_map_has_the_values_of_its_points(further: tuple[float, ...]) -> None:
    E_n, Delta, b_1 = [0.2, 0.1][: 1 + len(further)], np.array([-0.9, -0.4, 0.1]), np.array([-0.2, 0.3, 0.6, 1.1])
    found = liquid.stability_map(1.0, E_n, Delta, b_1, 3.0, further)
    for j, i in np.ndindex(found.stable.shape):
        point = 1.0, 1 + Delta[i], E_n, 3.0 * np.array([b_1[j], *further]), 3.0
        assert found.growth_rate[j, i] == liquid.growth_rate(*point)
        assert found.stable[j, i] == liquid.is_stable(*point)


def test_no_parameters_give_no_results() -> None:
    found = liquid.stability(1.0, np.empty(0), [0.2, 0.1], [0.5, 0.7], 1.0)
    assert [each.shape for each in found] == [(0, 3), (0,), (0,)]


# --- bad input

GOOD = {"A": 1.0, "C": 0.5, "E_n": [0.2, 0.1], "lambda_n": [0.5, 0.7], "omega_0": 1.0}
MODE = {"A": 1.0, "E_1": 0.2, "b_1": 0.5}
MODES = {"A": 1.0, "E_n": [0.2], "lambda_n": [0.5], "omega_0": 1.0}
MAP = {"A": 1.0, "E_n": [0.2], "Delta": [-0.5, 0.1], "b_1": [0.5, 0.6]}
SINGLE = {"a_n": 1.0, "chi_n": 1.0, "N_n": 1.0}
BAD: list[tuple[Callable[..., Any], dict[str, Any], dict[str, Any], tuple[str, ...]]] = [
    (liquid.stability, GOOD, {"A": 0.0}, ("A = ", "positive")),
    (liquid.stability, GOOD, {"C": [1.0, -2.0]}, ("C[1] = ", "-2.0", "positive", "N.17")),
    (liquid.stability, GOOD, {"omega_0": -1.0}, ("omega_0 = ", "positive")),
    (liquid.stability, GOOD, {"E_n": [0.2, 0.0]}, ("E_n[1] = ", "positive")),
    (liquid.stability, GOOD, {"E_n": [0.7, 0.3]}, ("sum of E_n = ", "less than A", "N.13")),
    (liquid.stability, GOOD, {"E_n": 0.2}, ("E_n has shape ()",)),
    (liquid.stability, GOOD, {"E_n": [], "lambda_n": []}, ("E_n", "at least one mode", "1.31")),
    (liquid.stability, GOOD, {"lambda_n": [0.5]}, ("lambda_n has shape (1,)", "(2)")),
    (liquid.stability, GOOD, {"lambda_n": [0.5, np.nan]}, ("lambda_n[1] = ", "finite")),
    (liquid.stability, GOOD, {"A": [1.0, 1.0], "C": [1.0, 1.0, 1.0]}, ("A (2,), C (3,)", "broadcast")),
    (liquid.stability, GOOD, {"C": "round"}, ("C = 'round'", "not an array of real numbers")),
    (liquid.stability, GOOD, {"lambda_n": [1e200, 1e300]}, ("finite", "units")),
    (liquid.boundary_of_stability, MODE, {"b_1": 1.5}, ("b_1 = ", "1.5", "0 <= b_1 <= 1", "B.9")),
    (liquid.boundary_of_stability, MODE, {"E_1": 1.0}, ("E_1 = ", "less than A", "B.25")),
    (liquid.boundary_of_stability, MODE, {"omega_0": 0.0}, ("omega_0 = ", "positive")),
    (liquid.boundary_of_stability, MODE, {"A": [1.0, 1.0], "b_1": [0.1, 0.2, 0.3]}, ("A (2,)", "b_1 (3,)")),
    (liquid.boundary_of_stability, MODE, {"omega_0": 1e308, "A": 1e308, "E_1": 0.9e308}, ("finite", "units")),
    (liquid.unstable_intervals, MODES, {"A": [1.0, 2.0]}, ("A = ", "finite number")),
    (liquid.unstable_intervals, MODES, {"E_n": [[0.2]]}, ("E_n.shape", "call once")),
    (liquid.unstable_intervals, MODES, {"lambda_n": [0.5, 0.6]}, ("lambda_n has shape (2,)",)),
    (liquid.stability_map, MAP, {"Delta": [-1.0, 0.0]}, ("Delta[0] = ", "greater than -A", "N.17")),
    (liquid.stability_map, MAP, {"further_b": [0.3]}, ("further_b has shape (1,)", "(0)")),
    (liquid.mode_inertia, SINGLE, {"N_n": 0.0}, ("N_n = ", "positive", "B.1")),
    (liquid.mode_inertia, SINGLE, {"a_n": -1.0}, ("E_n = a_n chi_n / N_n^2 = ", "-1.0", "positive", "B.1")),
    (liquid.mode_inertia, SINGLE, {"a_n": [1.0, 2.0], "chi_n": [1.0, 2.0, 3.0]}, ("a_n (2,), chi_n (3,)",)),
]


@pytest.mark.parametrize(
    ("function", "good", "changed", "fragments"), BAD, ids=lambda value: getattr(value, "__name__", None)
)
def test_what_does_not_fit_is_named(
    function: Callable[..., Any], good: dict[str, Any], changed: dict[str, Any], fragments: tuple[str, ...]
) -> None:
    function(**good)
    with pytest.raises(ValueError, match=r"must|broadcast|shape|array") as caught:
        function(**{**good, **changed})
    assert [fragment for fragment in fragments if fragment not in str(caught.value)] == []


# --- figures


@pytest.mark.parametrize("further", [(), (0.7,)])
def test_the_map_is_drawn_with_its_boundary(further: tuple[float, ...]) -> None:
    E_n = [0.2, 0.1][: 1 + len(further)]
    ratios = np.linspace(-0.1, 1.1, 25)
    found = liquid.stability_map(1.0, E_n, np.linspace(-0.99, 0.2, 30), ratios, 2.0, further)
    ax = liquid.plot_stability_map(found)
    [boundary] = [line for line in ax.lines if line.get_label() == "boundary of stability"]
    drawn = {tuple(point) for point in np.transpose(boundary.get_data())}
    for ratio in ratios:
        for end in liquid.unstable_intervals(1.0, E_n, 2.0 * np.array([ratio, *further]), 2.0).ravel():
            assert (end, ratio) in drawn
    [mesh] = ax.collections
    assert np.array_equal(np.ma.getmaskarray(mesh.get_array()), found.growth_rate == 0)


def test_frequencies_are_drawn_red_where_they_are_pairs() -> None:
    Delta = np.linspace(-0.99, 0.4, 50)
    upper, lower = liquid.plot_frequencies(1.0, [0.2], [0.5], 1.0, Delta)
    found = liquid.stability(1.0, 1 + Delta, [0.2], [0.5], 1.0)
    red = [line.get_ydata() for line in upper.lines if line.get_color() == "tab:red"]
    assert np.array_equal(np.isfinite(red), np.repeat([found.growth_rate > 0], 2, axis=0))
    assert np.array_equal(lower.lines[0].get_ydata(), found.growth_rate)


def test_axes_that_are_given_are_drawn_in() -> None:
    from matplotlib.figure import Figure

    one, *pair = Figure().subplots(3)
    found = liquid.stability_map(1.0, [0.2], [-0.5, 0.1], [0.5, 0.6])
    assert liquid.plot_stability_map(found, one) is one
    assert list(liquid.plot_frequencies(1.0, [0.2], [0.5], 1.0, [-0.5, 0.1], pair)) == pair


def test_a_map_with_falling_axes_is_not_drawn() -> None:
    found = liquid.stability_map(1.0, [0.2], [0.1, -0.5], [0.5, 0.6])
    with pytest.raises(ValueError, match=r"Delta = .* increasing"):
        liquid.plot_stability_map(found)


# --- the modules


def test_neither_sympy_nor_matplotlib_is_loaded_before_it_is_needed() -> None:
    names = ", ".join(module.__name__ for module in MODULES)
    code = f"import sys, {names}; print(sorted({{'sympy', 'matplotlib', 'scipy'}} & set(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
