"""The stationary laws and the ensembles of the randomly driven rotation, each held against something independent.

Closed forms against quadrature and against SymPy's values of the derivation; the scheme against plain expressions,
exact moments and Heun's scheme with all six noises; samples and simulated paths against the closed forms, and against
wrong ones.
"""

from __future__ import annotations

import inspect
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from math import exp, log, pi, sqrt
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from sample_paths import heun_step
from scipy.integrate import quad
from scipy.linalg import expm

from symcheck.numeric import random_rotation as rr
from symcheck.numeric.random_rotation import numpy_engine
from symcheck.numeric.random_rotation.ensemble import LANES
from symcheck.numeric.random_rotation.scheme import COARSEST, scheme
from symcheck.papers.poloskov2004 import derivation

Array = NDArray[np.float64]
D = np.array([[1.0, 0.3, 0.25], [0.2, 0.5, 0.15], [0.2, 0.1, 0.9]])
TORQUES = rr.RandomTorques(0.01, 0.6, D, g_1=[0.9, 0.3, 0.7], g_2=[0.4, 0.9, 0.6])
FIGURE_1, FIGURE_2 = (1.0, sqrt(0.75), 1.0), (0.6, 1.0, 1.0, 1.5)  # 4.0.21 to 4.0.25, and k for which C_2 is as printed

AMPLITUDE = (FIGURE_1, (0.3, 0.2, 2.0), (1.5, 5.0, 1.3))
FREQUENCY = (FIGURE_2, (0.1, 0.2, 3.0, 0.5), (0.9, 3.0, 0.01, 7.0))
LAWS = {  # name: (least value, density, distribution, quantile, moment, mode, parameters)
    "amplitude": (
        0.0,
        rr.density_of_amplitude,
        rr.distribution_of_amplitude,
        rr.quantile_of_amplitude,
        rr.moment_of_amplitude,
        rr.mode_of_amplitude,
        AMPLITUDE,
    ),
    "frequency": (
        -np.inf,
        rr.density_of_frequency,
        rr.distribution_of_frequency,
        rr.quantile_of_frequency,
        rr.moment_of_frequency,
        rr.mode_of_frequency,
        FREQUENCY,
    ),
}
CASES = [(name, parameters) for name, law in LAWS.items() for parameters in law[-1]]

# --- what is documented -----------------------------------------------------------------------------------------------


def test_importing_brings_neither_sympy_nor_matplotlib_nor_numba() -> None:
    heavy = "('sympy', 'matplotlib', 'numba')"
    program = f"import sys, symcheck.numeric.random_rotation; print([m for m in {heavy} if m in sys.modules])"
    assert subprocess.run([sys.executable, "-c", program], capture_output=True, check=True, text=True).stdout == "[]\n"


# --- the laws ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "parameters"), CASES)
def test_quantiles_divide_the_area_below_the_density(name: str, parameters: tuple[float, ...]) -> None:
    least, density, distribution, quantile, *_ = LAWS[name]
    chosen = np.array([1e-6, 0.2, 0.5, 0.9, 0.999, 1 - 1e-6])
    ends = quantile(chosen, *parameters)
    np.testing.assert_allclose(distribution(ends, *parameters), chosen, rtol=1e-12)
    for area, begin, end in zip(np.diff(chosen, prepend=0), [least, *ends[:-1]], ends, strict=True):
        value, _ = quad(lambda x: float(density(x, *parameters)), begin, end, epsabs=0, epsrel=1e-9, limit=500)
        assert value == pytest.approx(area, rel=1e-8)


@pytest.mark.parametrize(("name", "parameters"), CASES)
@pytest.mark.parametrize("m", [0, 0.5, 1, 2])
def test_moments_are_integrals_or_refused(name: str, parameters: tuple[float, ...], m: float) -> None:
    _, density, _, _, moment, *_ = LAWS[name]
    finite = {
        "amplitude": lambda alpha, beta, gamma: 8 * gamma**2 > alpha**2 * (2 + 3 * m),
        "frequency": lambda k, g_13, g_23, d_33: 2 * d_33 > m * g_13**2,
    }[name](*parameters)
    if not finite:
        with pytest.raises(ValueError, match=r"must satisfy .* for m = .* \(4\.0\.(9|11)\)"):
            moment(m, *parameters)
        return
    sides = 1 if name == "amplitude" else 2
    value, _ = quad(lambda u: exp(u * (m + 1)) * float(density(exp(u), *parameters)), -60, 60, limit=500, epsabs=1e-13)
    assert float(moment(m, *parameters)) == pytest.approx(sides * value, rel=1e-7)


@pytest.mark.parametrize(("name", "parameters"), CASES)
def test_density_is_largest_at_the_mode(name: str, parameters: tuple[float, ...]) -> None:
    _, density, _, quantile, _, mode, _ = LAWS[name]
    at, spread = float(mode(*parameters)), float(quantile(0.75, *parameters) - quantile(0.25, *parameters))
    beside = density(at + spread * np.array([-1e-3, 1e-3]), *parameters)
    assert (beside < density(at, *parameters)).all()


def test_mean_squares_are_moments_of_order_two() -> None:
    assert rr.mean_square_of_amplitude(0.3, 0.2, 2.0) == pytest.approx(float(rr.moment_of_amplitude(2, 0.3, 0.2, 2.0)))
    assert rr.mean_square_of_frequency(*FIGURE_2) == pytest.approx(float(rr.moment_of_frequency(2, *FIGURE_2)))


def test_constants_of_the_figures_are_those_printed() -> None:
    assert exp(rr.logarithm_of_constant_of_amplitude(*FIGURE_1)) == pytest.approx(2.25)
    assert exp(rr.logarithm_of_constant_of_frequency(*FIGURE_2)) == pytest.approx(54 / 125 / pi)


def test_values_are_those_of_the_derivation() -> None:
    derived = {**derivation.normalised_densities(), **derivation.distribution_of_amplitude(), **derivation.moments()}
    letters = {
        "alpha": sp.Rational(7, 10), "beta": sp.Rational(3, 5), "gamma": sp.Rational(9, 8), "a": sp.Rational(4, 5),
        "q": sp.Rational(1, 7), "m": sp.Rational(3, 2), "k": sp.Rational(2, 5), "g_13": sp.Rational(1, 2),
        "g_23": sp.Rational(6, 5), "d_33": sp.Rational(8, 9), "Omega": sp.Rational(-2, 3),
    }  # fmt: skip
    numbers = {name: float(value) for name, value in letters.items()}
    ours = {
        "p_s1": rr.density_of_amplitude, "F": rr.distribution_of_amplitude, "a_q": rr.quantile_of_amplitude,
        "M_a": rr.moment_of_amplitude, "p_s3": rr.density_of_frequency, "M_Omega": rr.moment_of_frequency,
    }  # fmt: skip
    for name, function in ours.items():
        exact = derived[name].subs({symbol: letters[symbol.name] for symbol in derived[name].free_symbols}).evalf(30)
        assert float(function(*(numbers[each] for each in inspect.signature(function).parameters))) == pytest.approx(
            float(exact), rel=1e-13
        ), name


@pytest.mark.parametrize("name", LAWS)
def test_functions_work_element_by_element(name: str) -> None:
    _, density, distribution, quantile, moment, mode, parameters = LAWS[name]
    columns = [np.array(column)[:, None] for column in zip(*parameters, strict=True)]
    values = np.array([0.2, 0.5, 0.7])
    for function in (density, distribution, quantile):
        table = function(values, *columns)
        assert table.shape == (3, 3)
        expected = [[float(function(value, *row)) for value in values] for row in parameters]
        np.testing.assert_allclose(table, expected, rtol=1e-13)
    np.testing.assert_allclose(
        moment(0.1, *columns)[:, 0], [float(moment(0.1, *row)) for row in parameters], rtol=1e-13
    )
    np.testing.assert_allclose(mode(*columns)[:, 0], [float(mode(*row)) for row in parameters], rtol=1e-15)


positive = st.floats(0.05, 20)


@given(q=st.floats(1e-12, 1 - 1e-12), alpha=positive, beta=positive, ratio=st.floats(0.8, 10))
@settings(deadline=None)
def test_quantile_of_amplitude_inverts_the_distribution(q: float, alpha: float, beta: float, ratio: float) -> None:
    a = rr.quantile_of_amplitude(q, alpha, beta, ratio * alpha)
    assert float(rr.distribution_of_amplitude(a, alpha, beta, ratio * alpha)) == pytest.approx(q, rel=1e-11)


@given(q=st.floats(1e-100, 0.5), k=positive, g_13=positive, g_23=positive, delta=st.floats(0.5, 1e6))
@settings(deadline=None)
def test_quantile_of_frequency_inverts_the_distribution_in_the_far_tail(
    q: float, k: float, g_13: float, g_23: float, delta: float
) -> None:
    parameters = k, g_13, g_23, delta * g_13**2
    value = rr.quantile_of_frequency(q, *parameters)
    assert float(rr.distribution_of_frequency(value, *parameters)) == pytest.approx(q, rel=1e-10)
    assert value <= 0


def test_quantiles_of_the_frequency_are_symmetric() -> None:
    lower, upper = rr.quantile_of_frequency([[0.25, 0.5, 0.125], [0.75, 0.5, 0.875]], *FIGURE_2)
    np.testing.assert_array_equal(lower, -upper)
    assert lower[1] == 0


def test_frequency_becomes_normal_as_its_multiplicative_noise_vanishes() -> None:
    parameters = 0.6, 1e-9, 1.0, 1.5
    deviation = 0.6 / sqrt(3)
    assert float(rr.distribution_of_frequency(deviation, *parameters)) == pytest.approx(0.8413447460685429)
    assert float(rr.quantile_of_frequency(0.1, *parameters)) == pytest.approx(-1.2815515655446004 * deviation)


BAD: list[tuple[Callable[[], object], str]] = [
    (
        lambda: rr.density_of_amplitude(1, 2.0, 1.0, 1.0),
        r"^gamma = .*1\.0.* must satisfy 4 gamma\^2 > alpha\^2 \(4\.0\.3",
    ),
    (lambda: rr.density_of_amplitude(1, 1.0, 1.0, [1.0, 0.4]), r"^gamma\[1\] = .*0\.4"),
    (lambda: rr.density_of_amplitude(-1, 1.0, 1.0, 1.0), r"^a = .*-1.* must not be negative \(\(3\.4\)\)"),
    (lambda: rr.density_of_amplitude(1, 0.0, 1.0, 1.0), r"^alpha = .* must be positive .*Rayleigh"),
    (lambda: rr.mode_of_amplitude(1.0, 0.0, 1.0), r"^beta = .* must be positive .*B\.11"),
    (lambda: rr.mean_square_of_amplitude(1.0, 1.0, 0.9), r"^gamma = .*0\.9.* gamma\^2 > alpha\^2"),
    (lambda: rr.quantile_of_amplitude(1.0, 1.0, 1.0, 1.0), r"^q = .* between 0 and 1"),
    (lambda: rr.quantile_of_amplitude(0.999999, 1.0, 1.0, 0.5000001), r"^quantile of a = .*inf.* finite double"),
    (lambda: rr.moment_of_amplitude(-1, 1.0, 1.0, 1.0), r"^m = .* must not be negative"),
    (lambda: rr.density_of_frequency(0.0, 0.6, 1.0, 1.0, 0.0), r"^d_33 = .* must be positive \(4\.0\.5\)"),
    (lambda: rr.moment_of_frequency(3, 0.6, 1.0, 1.0, 1.2), r"^d_33 = .*1\.2.* 2 d_33 > m g_13\^2 for m = .*3"),
    (lambda: rr.mean_square_of_frequency(0.6, 1.0, 1.0, 0.9), r"^d_33 = .*0\.9.* d_33 > g_13\^2"),
    (lambda: rr.quantile_of_frequency(1e-100, 0.6, 1.0, 1.0, 0.05), r"^quantile of Omega = .*inf"),
    (lambda: rr.density_of_frequency(np.nan, *FIGURE_2), r"^Omega = .*nan.* must be finite"),
    (lambda: rr.RandomTorques(0.0, 0.6, D, [1, 1, 1], [1, 1, 1]), r"^varepsilon = .* must be positive"),
    (lambda: rr.RandomTorques(0.1, 1.2, D, [1, 1, 1], [1, 1, 1]), r"^k = .*1\.2.* less than 1"),
    (lambda: rr.RandomTorques(0.1, 0.6, D[:2], [1, 1, 1], [1, 1, 1]), r"^d has shape \(2, 3\)"),
    (lambda: rr.RandomTorques(0.1, 0.6, D, [1, -1, 1], [1, 1, 1]), r"^g_1\[1\] = .*-1.* not be negative"),
    (lambda: rr.RandomTorques(0.1, 0.6, -D, [1, 1, 1], [1, 1, 1]).amplitude, r"d_11 \+ d_22 > 0"),
    (lambda: simulated(step=0.0), r"^step = .* must be positive"),
    (lambda: simulated(step=5.0), r"^step = .*5\.0.* epsilon step <= 0\.04"),
    (lambda: simulated(steps=10, every=4), r"^steps = .*10.* must be a multiple of every = 4"),
    (lambda: simulated(start=[1.0, 2.0, 3.0]), r"^start has shape \(3,\)"),
    (lambda: simulated(start=np.ones((2, 2, 3))), r"^start\.shape = .* \(n, 3\)"),
    (lambda: simulated(seed=-1), r"^seed = .*-1.* must be a whole number from 0 on"),
    (lambda: simulated(workers=0), r"^workers = .*0"),
    (lambda: simulated(first=0.5), r"^first = .*0\.5"),
    (lambda: simulated(engine="fortran"), r"^engine = .*'fortran'.* must be one of numpy, numba"),
    (lambda: rr.stationary_sample(TORQUES, 0, seed=1), r"^paths = .*0"),
    (lambda: rr.plot_amplitude([1.0, 1.0], 1.0, 1.0), r"^alpha = .* must be a finite number"),  # type: ignore[arg-type]
    (lambda: rr.plot_amplitude(*FIGURE_1, sample=[]), r"^sample = .* at least one value"),
]


@pytest.mark.parametrize(("call", "message"), BAD)
def test_what_does_not_fit_is_named_with_its_condition(call: Callable[[], object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call()


# --- samples ----------------------------------------------------------------------------------------------------------

LEVEL = 0.001  # of wrongly rejecting a right distribution


def distance(sample: Array, distribution: Callable[[Array], Array]) -> float:
    """Kolmogorov-Smirnov distance, in units of the critical one (Dvoretzky-Kiefer-Wolfowitz-Massart)."""
    values, size = distribution(np.sort(sample)), len(sample)
    below = np.arange(size) / size
    return float(max((values - below).max(), (below + 1 / size - values).max())) / sqrt(log(2 / LEVEL) / 2 / size)


WRONG = {  # factors of alpha, beta, gamma and of g_13, g_23, d_33 that must be noticed
    "amplitude": [(1.1, 1, 1), (1, 1.05, 1), (1, 1, 1.05)],
    "frequency": [(1, 1.3, 1, 1), (1, 1, 1.05, 1), (1, 1, 1, 1.1)],
}


def held_against_the_laws(x: Array) -> None:
    """The right laws are accepted, wrong parameters are not; the phase is uniform, but not on a shorter turn."""
    a, psi, Omega = rr.amplitude_phase_frequency(x, TORQUES.k)
    for name, sample, parameters in (("amplitude", a, TORQUES.amplitude), ("frequency", Omega, TORQUES.frequency)):
        distribution = LAWS[name][2]
        assert distance(sample, lambda v, f=distribution, p=parameters: f(v, *p)) < 1
        for factors in WRONG[name]:
            wrong = np.array(parameters) * factors
            assert distance(sample, lambda v, f=distribution, p=wrong: f(v, *p)) > 1
    assert distance(psi, lambda v: (v + pi) / (2 * pi)) < 1
    assert distance(psi, lambda v: (v + 3.3) / (2 * 3.3)) > 1


def test_the_stationary_sample_has_the_stationary_laws() -> None:
    held_against_the_laws(rr.stationary_sample(TORQUES, 40_000, seed=3))


def test_simulated_paths_come_to_the_stationary_laws() -> None:
    start = np.random.default_rng(1).uniform(0.5, 1.5, (40_000, 3))  # nowhere near stationary
    slow = replace(TORQUES, varepsilon=0.002)  # with 0.01 it shows that the phase is not quite uniform
    x = rr.simulate(slow, start, 10.0, 500, seed=2004, workers=2).angular_velocity[0]
    held_against_the_laws(x)
    a, _, Omega = rr.amplitude_phase_frequency(x, TORQUES.k)
    assert (a**2).mean() == pytest.approx(float(rr.mean_square_of_amplitude(*TORQUES.amplitude)), rel=0.05)
    assert (Omega**2).mean() == pytest.approx(float(rr.mean_square_of_frequency(*TORQUES.frequency)), rel=0.1)
    assert rr.mean_square_of_frequency(*TORQUES.frequency) != pytest.approx(TORQUES.frequency[2] ** 2, rel=0.1)


@given(x=st.lists(st.floats(-10, 10), min_size=3, max_size=3), k=st.floats(0.01, 0.99))
def test_amplitude_phase_and_frequency_give_the_angular_velocity_back(x: list[float], k: float) -> None:
    rotation = rr.amplitude_phase_frequency(x, k)
    np.testing.assert_allclose(rr.angular_velocity(*rotation, k), x, atol=1e-14, rtol=1e-14)


# --- the ensemble -----------------------------------------------------------------------------------------------------


def simulated(start: Any = None, step: float = 2.0, steps: int = 20, seed: int = 7, **options: Any) -> Array:
    start = np.random.default_rng(0).uniform(-1.5, 1.5, (5_000, 3)) if start is None else start
    return rr.simulate(TORQUES, start, step, steps, seed=seed, **options).angular_velocity


def plain(start: Array, step: float, steps: int, seed: int) -> Array:
    """The scheme as one writes it down, for whole streams; start has the shape (paths, 3)."""
    small, (g_1, g_2) = TORQUES.varepsilon, TORQUES.intensities[:, :, None]
    keys = range(len(start) // LANES)
    streams = [np.random.Generator(np.random.SFC64(np.random.SeedSequence(seed, spawn_key=(key,)))) for key in keys]
    relaxation, x = expm(-small * step / 2 * TORQUES.dissipation), start.T
    for _ in range(steps):
        v = g_1 * sqrt(small * step) * np.hstack([stream.standard_normal((3, LANES)) for stream in streams])
        x = relaxation @ turned(x, step / 2)
        x = x * np.cosh(v) + np.sqrt(x**2 + (g_2 / g_1) ** 2) * np.sinh(v)
        x = turned(relaxation @ x, step / 2)
    return x.T


def turned(x: Array, time: float) -> Array:
    cos, sin = np.cos(TORQUES.k * x[2] * time), np.sin(TORQUES.k * x[2] * time)
    return np.stack([cos * x[0] + sin * x[1], cos * x[1] - sin * x[0], x[2]])


ENGINES = [
    "numpy",
    pytest.param("numba", marks=pytest.mark.skipif("not __import__('importlib').util.find_spec('numba')")),
]


@pytest.mark.parametrize("engine", ENGINES)
def test_paths_are_those_of_the_formulas(engine: str) -> None:
    start = np.random.default_rng(0).uniform(-1.5, 1.5, (10 * LANES, 3))
    found = simulated(start, 2.0, 50, seed=11, engine=engine)[0]
    np.testing.assert_allclose(found, plain(start, 2.0, 50, 11), atol=1e-11)
    assert np.abs(found - plain(start, 2.0, 50, 12)).max() > 0.1  # another seed


@pytest.mark.parametrize("engine", ENGINES)
def test_a_path_depends_on_its_number_alone(engine: str) -> None:
    start = np.random.default_rng(0).uniform(-1.5, 1.5, (18_000, 3))  # 71 streams, in two pieces for one worker
    whole = simulated(start, engine=engine, every=5)
    for workers in (2, 4, 100):
        np.testing.assert_array_equal(simulated(start, engine=engine, every=5, workers=workers), whole)
    for begin, end in ((0, 1), (0, 3_000), (255, 257), (2_048, 14_096), (17_999, 18_000)):
        piece = simulated(start[begin:end], engine=engine, every=5, first=begin)
        np.testing.assert_array_equal(piece, whole[:, begin:end])


@pytest.mark.parametrize("engine", ENGINES)
def test_an_ensemble_may_be_empty(engine: str) -> None:
    assert simulated(np.empty((0, 3)), engine=engine, every=5, workers=2).shape == (4, 0, 3)


@pytest.mark.parametrize("engine", ENGINES)
def test_records_in_between_change_the_paths_by_rounding_only(engine: str) -> None:
    seldom = simulated(engine=engine, steps=33)
    for every in (1, 3, 11):
        often = simulated(engine=engine, every=every, steps=33)
        assert often.shape == (33 // every, 5_000, 3)
        np.testing.assert_allclose(often[-1], seldom[-1], atol=1e-11)


def test_numbers_are_drawn_independently_for_every_stream_and_axis() -> None:
    x = simulated(np.zeros((4 * LANES, 3)), steps=1)[0]
    correlation = np.corrcoef(np.hstack(np.split(x, 4)).T)
    assert np.abs(correlation - np.eye(12)).max() < 0.3  # 5 standard deviations


def test_energy_is_conserved_without_torques() -> None:
    free = rr.RandomTorques(1.0, 0.6, np.zeros((3, 3)), [0, 0, 0], [0, 0, 0])
    start = np.random.default_rng(5).uniform(-1.5, 1.5, (50, 3))
    x = rr.simulate(free, start, 2.0, 1_000, seed=0, every=100).angular_velocity
    np.testing.assert_allclose(np.hypot(x[..., 0], x[..., 1]), np.hypot(*start.T[:2])[None].repeat(10, 0), rtol=1e-12)
    assert (x[..., 2] == start[:, 2]).all()
    angle = -0.6 * start[:, 2] * 2_000.0
    z = (start[:, 0] + 1j * start[:, 1]) * np.exp(1j * angle)
    np.testing.assert_allclose(x[-1, :, 0] + 1j * x[-1, :, 1], z, atol=1e-10)


def test_without_multiplicative_noise_a_step_adds_normal_numbers() -> None:
    additive = rr.RandomTorques(0.04, 0.6, np.zeros((3, 3)), [0, 0, 0], [0, 0, 0.5])
    x = rr.simulate(additive, np.full((LANES, 3), 0.3), 1.0, 1, seed=3).angular_velocity[0]
    numbers = np.random.Generator(np.random.SFC64(np.random.SeedSequence(3, spawn_key=(0,)))).standard_normal(
        (3, LANES)
    )
    np.testing.assert_allclose(x[:, 2], 0.3 + 0.2 * 0.5 * numbers[2], rtol=1e-13)


def test_a_path_that_leaves_the_finite_numbers_is_reported() -> None:
    exploding = rr.RandomTorques(1.0, 0.6, -1e3 * np.eye(3), [0.1, 0.1, 0.1], [1, 1, 1])
    with pytest.raises(FloatingPointError, match="no longer finite"):
        rr.simulate(exploding, np.ones((3, 3)), 1.0, 10, seed=1)


def test_the_compiled_tangents_are_right_as_far_as_they_are_used() -> None:
    pytest.importorskip("numba")
    from symcheck.numeric.random_rotation.numba_engine import fraction

    reach = 10 * sqrt(COARSEST) / 2  # ten standard deviations of the noise; more than a fourth of half a turn
    assert reach == 1
    for z in np.linspace(-reach, reach, 500):
        (a, b), (c, d) = fraction(z, z * z), fraction(z, -z * z)
        assert (a / b, c / d) == pytest.approx((np.tanh(z), np.tan(z)), rel=1e-15)


def test_the_compiled_rotation_is_right_after_many_turns() -> None:
    pytest.importorskip("numba")
    from symcheck.numeric.random_rotation.numba_engine import rotate

    angle = np.concatenate([np.pi * np.arange(-8, 9) / 4, np.random.default_rng(0).uniform(-6e6, 6e6, 1_000)])
    x = np.stack([np.ones_like(angle), np.zeros_like(angle), angle])
    rotate(x, 1.0)
    np.testing.assert_allclose(x[:2], [np.cos(angle), -np.sin(angle)], rtol=0, atol=2e-15)


def test_a_missing_numba_is_reported_with_the_way_out(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "numba", None)
    for module in ("compiled", "random_rotation.numba_engine"):
        monkeypatch.delitem(sys.modules, f"symcheck.numeric.{module}", raising=False)
    with pytest.raises(ImportError, match=r"engine='numba' needs numba; run .* or leave engine='numpy'"):
        simulated(engine="numba")


# --- the order of the scheme ------------------------------------------------------------------------------------------


class Nodes:
    """Instead of a generator: gives the nodes of a quadrature, so that means over the noise are exact."""

    def __init__(self, nodes: Array) -> None:
        self.nodes = nodes

    def standard_normal(self, out: Array) -> None:
        out[...] = self.nodes


def quadrature(noises: int, count: int) -> tuple[Array, Array]:
    """Nodes, shape (noises, count**noises), and weights of a mean over independent normal numbers."""
    nodes, weights = np.polynomial.hermite_e.hermegauss(count)
    grid = np.stack([axis.ravel() for axis in np.meshgrid(*[nodes] * noises, indexing="ij")])
    weight = np.array([1.0])
    for _ in range(noises):
        weight = np.outer(weight, weights / sqrt(2 * pi)).ravel()
    return grid, weight


def observed(x: Array, weight: Array) -> Array:
    """Means of x_j and x_i x_j."""
    return np.concatenate([x @ weight, np.einsum("in,jn,n->ij", x, x, weight)[np.triu_indices(3)]])


def mean_after(torques: rr.RandomTorques, start: Array, step: float, steps: int) -> Array:
    """Means after one or two steps from one state, exact over the noise."""
    grid, weight = quadrature(3, 8)
    x, weights = start[:, None], np.array([1.0])
    for _ in range(steps):
        x, weights = np.repeat(x, weight.size, 1), np.outer(weights, weight).ravel()
        state = np.ascontiguousarray(x.reshape(3, -1, LANES))
        streams = state.shape[1]
        numbers = np.tile(grid, streams * LANES // weight.size).reshape(3, streams, LANES)
        generators: Any = [Nodes(numbers[:, j]) for j in range(streams)]
        numpy_engine.advance(scheme(torques, step), state, generators, 1)
        x = state.reshape(3, -1)
    return observed(x, weights)


def orders(errors: list[Any]) -> Array:
    """Observed orders, where the steps are halved."""
    return np.log2(np.abs(np.array(errors[:-1]) / np.array(errors[1:])))


STRONG = rr.RandomTorques(0.5, 0.6, D, g_1=[0.9, 0.3, 0.7], g_2=[0.4, 0.9, 0.6])
STATE = np.array([1.1, -0.6, 0.8])


def test_one_step_errs_by_the_third_order() -> None:
    """So the weak order is 2: against two steps of half the length, in all means and mean products."""
    steps = (0.04, 0.02, 0.01)
    errors = [mean_after(STRONG, STATE, h, 1) - mean_after(STRONG, STATE, h / 2, 2) for h in steps]
    np.testing.assert_allclose(orders(errors), 3, atol=0.25)


def test_the_axial_mean_of_a_step_is_exact_and_the_mean_square_errs_by_the_third_order() -> None:
    """With d_31 = d_32 = 0 the third component is alone, and its first two moments are known."""
    alone = rr.RandomTorques(0.5, 0.6, D * [[1, 1, 1], [1, 1, 1], [0, 0, 1]], g_1=[0.9, 0.3, 0.7], g_2=[0.4, 0.9, 0.6])
    _, g, s, d = alone.frequency
    rate, errors = 2 * (g**2 - d), []
    for h in (0.08, 0.04, 0.02):
        found = mean_after(alone, STATE, h, 1)
        assert found[2] == pytest.approx(STATE[2] * exp((g**2 / 2 - d) * 0.5 * h), rel=1e-15)
        errors.append(found[-1] - (STATE[2] ** 2 + s**2 / rate) * exp(rate * 0.5 * h) + s**2 / rate)
    np.testing.assert_allclose(orders(errors), 3, atol=0.1)


def test_the_law_is_that_of_the_system_with_all_six_noises() -> None:
    """A step of Heun's scheme errs by the second order, so the difference is of the second if the equations agree."""
    grid, weight = quadrature(6, 4)
    small, (g_1, g_2) = STRONG.varepsilon, STRONG.intensities[:, :, None]

    def drift(x: Array) -> Array:
        return -small * (D @ x) + STRONG.k * np.stack([x[1] * x[2], -x[2] * x[0], 0 * x[2]])

    def difference(h: float) -> Array:
        start = np.repeat(STATE[:, None], weight.size, 1)
        kick = lambda x, dw: sqrt(small) * (g_1 * x * dw[:3] + g_2 * dw[3:])  # noqa: E731
        return observed(heun_step(drift, kick, start, h, sqrt(h) * grid), weight) - mean_after(STRONG, STATE, h, 1)

    errors = [difference(h) for h in (0.02, 0.01, 0.005)]
    assert (orders(errors) > 1.8).all()


# --- pictures ---------------------------------------------------------------------------------------------------------


def test_pictures_show_the_density_over_the_histogram() -> None:
    sample = rr.amplitude_phase_frequency(rr.stationary_sample(TORQUES, 20_000, seed=8), TORQUES.k)
    amplitude = rr.plot_amplitude(*TORQUES.amplitude, sample=sample.a)
    frequency = rr.plot_frequency(*TORQUES.frequency, sample=sample.Omega)
    for ax, law, parameters in (
        (amplitude, "amplitude", TORQUES.amplitude),
        (frequency, "frequency", TORQUES.frequency),
    ):
        x, y = ax.lines[0].get_data()
        np.testing.assert_array_equal(y, LAWS[law][1](x, *parameters))
        heights, edges, _ = ax.patches[0].get_data()
        shown = np.histogram(getattr(sample, "a" if law == "amplitude" else "Omega"), edges)[0].sum() / sample.a.size
        assert 0.99 < shown < 1
        assert heights @ np.diff(edges) == pytest.approx(shown)
        middle = np.interp((edges[1:] + edges[:-1]) / 2, x, y)
        assert np.abs(heights - middle).max() < 0.1 * y.max()
        assert "rad/s" in ax.get_xlabel()
        assert ax.get_ylabel() == "density, s/rad"


def test_pictures_go_where_they_are_told_and_leave_no_global_figure(monkeypatch: pytest.MonkeyPatch) -> None:
    from matplotlib.figure import Figure

    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)  # whoever imports it fails
    ax, *pair = Figure().subplots(3, 1)
    assert rr.plot_frequency(*FIGURE_2, ax=ax) is ax
    ensemble = rr.simulate(TORQUES, np.ones((6, 3)), 1.0, 30, seed=1, every=1)
    rr.plot_paths(ensemble, TORQUES.k, paths=4, axes=pair)
    assert [len(each.lines) for each in pair] == [4, 4]
    np.testing.assert_array_equal(pair[1].lines[2].get_ydata(), TORQUES.k * ensemble.angular_velocity[:, 2, 2])


@pytest.mark.parametrize("unit", [1e-60, 0.003, 1.0, 1e60])
def test_moments_of_high_order_are_no_silent_zeros(unit: float) -> None:
    with mpmath.workdps(40):
        for order in (0.0, 1.3, 7.0, 40.25, 152.67):
            m, nu = mpmath.mpf(order), mpmath.mpf(4 * 600**2 - 1) / 3
            base = mpmath.sqrt(4 * mpmath.mpf(unit) ** 2 / 3)
            right = base**m * mpmath.gammaprod([nu - m / 2, m / 2 + 1], [nu])
            assert told_or_right(lambda m=order: rr.moment_of_amplitude(m, 1.0, unit, 600.0), right)
            right = mpmath.mpf(unit) ** m * mpmath.gammaprod([(m + 1) / 2, 700 - m / 2], [700, mpmath.mpf(1) / 2])
            assert told_or_right(lambda m=order: rr.moment_of_frequency(m, 1.0, 1.0, unit, 700.0), right)


def told_or_right(call: Callable[[], Any], right: Any) -> bool:
    """Whether a value is right, or 0 where it is below all doubles; else it must be refused as too large."""
    try:
        found = mpmath.mpf(float(call()))
    except ValueError:
        return bool(right > 1e300)
    return bool(abs(found - right) <= 1e-11 * right + mpmath.mpf(2) ** -1060)
