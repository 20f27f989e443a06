"""The scheme does what it says; and the rotating body's paths are distributed as the stationary densities say.

No density, no average and no change of variables goes into the integration of Poloskov's system (1.1): it is an
experiment. Each result of the averaging is held against it, and each is replaced by a wrong one, which must be noticed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import exp, log, sqrt

import numpy as np
import pytest
from sample_paths import Array, heun_step, stratonovich_paths, wiener_increments

Distribution = Callable[[Array], Array]

# --- the body ---------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Body:
    """System (1.1); the elements of D beside the diagonal, and unequal noises, are what the averaging has to remove."""

    epsilon: float = 0.01
    k: float = 0.6
    d: tuple[tuple[float, ...], ...] = ((1.0, 0.3, 0.25), (0.2, 0.5, 0.15), (0.2, 0.1, 0.9))
    g1: tuple[float, ...] = (0.9, 0.3, 0.7)
    g2: tuple[float, ...] = (0.4, 0.9, 0.6)

    @property
    def alpha2(self) -> float:
        return self.g1[0] ** 2 + self.g1[1] ** 2

    @property
    def beta2(self) -> float:
        return self.g2[0] ** 2 + self.g2[1] ** 2

    @property
    def gamma2(self) -> float:
        return self.d[0][0] + self.d[1][1]

    def drift(self, x: Array) -> Array:
        """The dissipative moment -eps D x."""
        return -self.epsilon * (np.array(self.d) @ x)

    def diffusion(self, x: Array, dw: Array) -> Array:
        """The random moments sqrt(eps) (G_1 xi + G_2 eta)."""
        g1, g2 = np.array(self.g1)[:, None], np.array(self.g2)[:, None]
        return sqrt(self.epsilon) * (g1 * x * dw[:3] + g2 * dw[3:])

    def gyroscopic(self, x: Array) -> Array:
        """The fast part -f(x)."""
        x1, x2, x3 = x
        return np.stack([self.k * x2 * x3, -self.k * x3 * x1, 0 * x3])

    def rotation(self, x: Array, time: float) -> Array:
        """What x' = -f(x) does in the given time: x_3 is constant, (x_1, x_2) turns by the angle k x_3 t."""
        x1, x2, x3 = x
        cos, sin = np.cos(self.k * x3 * time), np.sin(self.k * x3 * time)
        return np.stack([cos * x1 + sin * x2, cos * x2 - sin * x1, x3])

    def whole_drift(self, x: Array) -> Array:
        return self.drift(x) + self.gyroscopic(x)


BODY = Body()
SAMPLES = 40_000
LEVEL = 0.01  # of wrongly rejecting a right distribution
CRITICAL = sqrt(log(2 / LEVEL) / 2 / SAMPLES)  # Dvoretzky-Kiefer-Wolfowitz-Massart: for every number of samples


def stationary_sample(body: Body, seed: int = 2004) -> tuple[Array, Array]:
    """The amplitude a and the frequency Omega at the end of independent paths.

    The slowest mean that has to be forgotten, that of x_3, decays as exp((g_13^2/2 - d_33) eps t), here to 0.15 %.
    The step is 1/50 of the relaxation time, and short against a turn: k x_3 step is 0.8 on the average.
    """
    rng = np.random.default_rng(seed)
    start = rng.uniform(0.5, 1.5, (3, SAMPLES))  # nowhere near stationary: x_3 > 0
    step, steps = 0.02 / body.epsilon, 500
    increments = wiener_increments(rng, step, steps, (6, SAMPLES))
    x1, x2, x3 = stratonovich_paths(
        body.drift, body.diffusion, start, step, increments, flow=body.rotation, every=steps
    )[-1]
    return np.hypot(x1, x2), body.k * x3


@pytest.fixture(scope="module")
def sample() -> tuple[Array, Array]:
    return stationary_sample(BODY)


def distance(sample: Array, distribution: Distribution) -> float:
    """Kolmogorov-Smirnov distance of a sample from a distribution function."""
    values = distribution(np.sort(sample))
    below = np.arange(len(sample)) / len(sample)
    return float(max((values - below).max(), (below + 1 / len(sample) - values).max()))


def accepted(sample: Array, distribution: Distribution) -> bool:
    return distance(sample, distribution) < CRITICAL


def cumulative(values: Array, grid: Array) -> Array:
    """The integral from the beginning of the grid, by trapezia."""
    return np.concatenate([[0.0], np.cumsum((values[1:] + values[:-1]) / 2 * np.diff(grid))])


# --- the printed densities --------------------------------------------------------------------------------------------

FREQUENCIES = np.sinh(np.linspace(-10, 10, 20_001))
AMPLITUDES = np.geomspace(1e-5, 1e4, 20_001)


def amplitude_distribution(kappa: float, body: Body = BODY) -> Distribution:
    """The distribution function of density (3.4), a (3 alpha^2 a^2 + 4 beta^2)^kappa."""
    return lambda a: 1 - (1 + 3 * body.alpha2 * a**2 / (4 * body.beta2)) ** (kappa + 1)


def frequency_distribution(kappa: float, body: Body = BODY) -> Distribution:
    """The distribution function of density (3.5), (g_13^2 Omega^2 + g_23^2 k^2)^kappa."""
    density = (body.g1[2] ** 2 * FREQUENCIES**2 + body.g2[2] ** 2 * body.k**2) ** kappa
    return _on(FREQUENCIES, density)


def _on(grid: Array, density: Array) -> Distribution:
    mass = cumulative(density, grid)
    return lambda values: np.interp(values, grid, mass / mass[-1])


KAPPA_1 = -4 * BODY.gamma2 / (3 * BODY.alpha2) - 2 / 3
KAPPA_2 = -BODY.d[2][2] / BODY.g1[2] ** 2 - 1 / 2

WRONG_EXPONENTS_OF_THE_AMPLITUDE = {
    "Ito instead of Stratonovich": KAPPA_1 - 2 / 3,
    "without - 2/3": KAPPA_1 + 2 / 3,
    "4/3 as 2/3": -2 * BODY.gamma2 / (3 * BODY.alpha2) - 2 / 3,
    "gamma^2 = d_11": -4 * BODY.d[0][0] / (3 * BODY.alpha2) - 2 / 3,
}
WRONG_EXPONENTS_OF_THE_FREQUENCY = {
    # The printed condition for the moments, 3 d_33 > m g_13^2, belongs to this tail; that of (3.5) has 2 d_33.
    "3 d_33": -3 * BODY.d[2][2] / (2 * BODY.g1[2] ** 2) - 1 / 2,
    "Ito instead of Stratonovich": KAPPA_2 - 1 / 2,
    "without - 1/2": KAPPA_2 + 1 / 2,
}


def test_the_amplitude_has_its_stationary_density(sample: tuple[Array, Array]) -> None:
    assert accepted(sample[0], amplitude_distribution(KAPPA_1))


def test_the_frequency_has_its_stationary_density(sample: tuple[Array, Array]) -> None:
    assert accepted(sample[1], frequency_distribution(KAPPA_2))


@pytest.mark.parametrize("name", WRONG_EXPONENTS_OF_THE_AMPLITUDE)
def test_a_wrong_density_of_the_amplitude_is_noticed(sample: tuple[Array, Array], name: str) -> None:
    assert not accepted(sample[0], amplitude_distribution(WRONG_EXPONENTS_OF_THE_AMPLITUDE[name]))


@pytest.mark.parametrize("name", WRONG_EXPONENTS_OF_THE_FREQUENCY)
def test_a_wrong_density_of_the_frequency_is_noticed(sample: tuple[Array, Array], name: str) -> None:
    assert not accepted(sample[1], frequency_distribution(WRONG_EXPONENTS_OF_THE_FREQUENCY[name]))


def test_the_densities_are_those_of_a_small_parameter() -> None:
    """With epsilon = 1 nothing is slow, nothing averages, and the densities are wrong."""
    amplitude, frequency = stationary_sample(Body(epsilon=1.0))
    assert not accepted(amplitude, amplitude_distribution(KAPPA_1))
    assert not accepted(frequency, frequency_distribution(KAPPA_2))


# --- the averaged coefficients ----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Averaged:
    """The numbers in the averaged coefficients, as printed after (3.2)."""

    k11_alpha: float = 3 / 8
    k11_beta: float = 1 / 2
    k1_gamma: float = 1 / 2
    k1_alpha: float = 5 / 16
    k1_beta: float = 1 / 4
    k3_d33: float = 1
    k3_g13: float = 1 / 2

    def amplitude(self) -> Distribution:
        a, body = AMPLITUDES, BODY
        k11 = self.k11_alpha * a**2 * body.alpha2 + self.k11_beta * body.beta2
        k1 = -self.k1_gamma * a * body.gamma2 + self.k1_alpha * a * body.alpha2 + self.k1_beta * body.beta2 / a
        return zero_flux(k1, k11, a)

    def frequency(self) -> Distribution:
        omega, body = FREQUENCIES, BODY
        k33 = body.g1[2] ** 2 * omega**2 + body.g2[2] ** 2 * body.k**2
        k3 = (-self.k3_d33 * body.d[2][2] + self.k3_g13 * body.g1[2] ** 2) * omega
        return zero_flux(k3, k33, omega)


def zero_flux(drift: Array, diffusion: Array, grid: Array) -> Distribution:
    """The distribution function of the density with (diffusion p)' = 2 drift p."""
    exponent = cumulative(2 * drift / diffusion, grid)
    return _on(grid, np.exp(exponent - exponent.max()) / diffusion)


WRONG_AVERAGES_OF_THE_AMPLITUDE = {
    "3/8 as 1/8": Averaged(k11_alpha=1 / 8),
    "3/8 as 1/2": Averaged(k11_alpha=1 / 2),
    "beta^2/2 as beta^2": Averaged(k11_beta=1),
    "gamma^2/2 as gamma^2": Averaged(k1_gamma=1),
    "5/16 as 3/16": Averaged(k1_alpha=3 / 16),
    "5/16 as 1/16, as Ito has it": Averaged(k1_alpha=1 / 16),
    "1/4 as 1/2": Averaged(k1_beta=1 / 2),
}
WRONG_AVERAGES_OF_THE_FREQUENCY = {
    "1/2 as 0, as Ito has it": Averaged(k3_g13=0),
    "1/2 as 1": Averaged(k3_g13=1),
    "3/2 d_33": Averaged(k3_d33=3 / 2),
}


def test_the_closed_densities_follow_from_the_averaged_coefficients(sample: tuple[Array, Array]) -> None:
    amplitude, frequency = (np.sort(values) for values in sample)
    closed, averaged = amplitude_distribution(KAPPA_1)(amplitude), Averaged().amplitude()(amplitude)
    np.testing.assert_allclose(averaged, closed, atol=1e-5)
    closed, averaged = frequency_distribution(KAPPA_2)(frequency), Averaged().frequency()(frequency)
    np.testing.assert_allclose(averaged, closed, atol=1e-5)


@pytest.mark.parametrize("name", WRONG_AVERAGES_OF_THE_AMPLITUDE)
def test_a_wrong_average_shows_in_the_amplitude(sample: tuple[Array, Array], name: str) -> None:
    assert not accepted(sample[0], WRONG_AVERAGES_OF_THE_AMPLITUDE[name].amplitude())


@pytest.mark.parametrize("name", WRONG_AVERAGES_OF_THE_FREQUENCY)
def test_a_wrong_average_shows_in_the_frequency(sample: tuple[Array, Array], name: str) -> None:
    assert not accepted(sample[1], WRONG_AVERAGES_OF_THE_FREQUENCY[name].frequency())


# --- the change of variables ------------------------------------------------------------------------------------------
# The misprints in v_2 and v_3 of (2.4) average out of both densities; path by path they show.


@dataclass(frozen=True)
class Polar:
    """System (2.4) for a, psi, Omega with psi' = Omega + theta', and with H diag(g_*).

    It is right, or has v_2 with the bracket as printed, or v_3 with the sign as printed.
    """

    body: Body
    printed_v2: bool = False
    printed_v3: bool = False

    def drift(self, y: Array) -> Array:
        a, psi, omega = y
        (d11, d12, d13), (d21, d22, d23), (d31, d32, d33) = self.body.d
        k, cos, sin = self.body.k, np.cos(psi), np.sin(psi)
        v1 = omega / k * (-d13 * cos + d23 * sin)
        v1 += -a * (d11 * cos**2 + d22 * sin**2) + a * cos * sin * (d12 + d21)
        axial, plane = d23 * cos + d13 * sin, cos * sin * (d11 - d22) + d21 * cos**2 - d12 * sin**2
        factor = omega / (a * k)
        v2 = factor * (axial + plane) if self.printed_v2 else factor * axial + plane
        transverse = a * k * (-d31 * cos + d32 * sin)
        v3 = -d33 * omega + (-transverse if self.printed_v3 else transverse)
        return np.stack([self.body.epsilon * v1, omega + self.body.epsilon * v2, self.body.epsilon * v3])

    def diffusion(self, y: Array, dw: Array) -> Array:
        a, psi, omega = y
        cos, sin, zero = np.cos(psi), np.sin(psi), 0 * psi
        rows = [
            [a * cos**2, a * sin**2, zero, cos, -sin, zero],
            [-cos * sin, cos * sin, zero, -sin / a, -cos / a, zero],
            [zero, zero, omega, zero, zero, zero + self.body.k],
        ]
        noise = np.array([*self.body.g1, *self.body.g2])[:, None] * dw
        product: Array = np.einsum("ijn,jn->in", np.array(rows), noise)
        return sqrt(self.body.epsilon) * product


def discrepancy(polar: Polar, step: float) -> Array:
    """By component, the median over the paths of what lies between (2.4) and (1.1), driven by the same noise."""
    body, paths, time = polar.body, 1_000, 2.0
    a, psi, omega = start = np.random.default_rng(1).uniform(1.5, 2.5, (3, paths))
    steps = round(time / step)
    increments = list(wiener_increments(np.random.default_rng(2), step, steps, (6, paths)))
    cartesian = np.stack([a * np.cos(psi), -a * np.sin(psi), omega / body.k])
    x1, x2, x3 = stratonovich_paths(
        body.drift, body.diffusion, cartesian, step, increments, flow=body.rotation, every=steps
    )[-1]
    a, psi, omega = stratonovich_paths(polar.drift, polar.diffusion, start, step, increments, every=steps)[-1]
    turned = (psi - np.arctan2(-x2, x1) + np.pi) % (2 * np.pi) - np.pi
    median: Array = np.median(np.abs([a - np.hypot(x1, x2), turned, omega - body.k * x3]), axis=1)
    return median


POLAR = Polar(Body(epsilon=0.5))


def test_the_system_in_polar_variables_has_the_same_paths() -> None:
    coarse, fine = (discrepancy(POLAR, step) for step in (0.02, 0.005))
    assert (fine < 0.003).all()
    assert (fine < 0.35 * coarse).all()


@pytest.mark.parametrize(
    ("misprinted", "component"), [(replace(POLAR, printed_v2=True), 1), (replace(POLAR, printed_v3=True), 2)]
)
def test_a_misprint_in_the_polar_system_leaves_the_paths(misprinted: Polar, component: int) -> None:
    right, wrong = (discrepancy(polar, 0.005) for polar in (POLAR, misprinted))
    assert wrong[component] > 10 * right[component]


# --- the scheme -------------------------------------------------------------------------------------------------------


def orders(errors: list[float]) -> Array:
    """The observed orders, where each error belongs to half the step of the one before."""
    return -np.diff(np.log2(errors))


def test_paths_of_a_linear_equation_converge_with_strong_order_one() -> None:
    """dx = l x dt + m x o dW has the solution x_0 exp(l t + m W)."""
    growth, noise, steps, paths = -0.5, 0.8, 512, 2_000
    fine = np.array(list(wiener_increments(np.random.default_rng(3), 1 / steps, steps, (1, paths))))
    exact = np.exp(growth + noise * fine.sum(axis=0))
    errors = []
    for coarser in (16, 8, 4, 2, 1):
        increments = fine.reshape(-1, coarser, 1, paths).sum(axis=1)
        path = stratonovich_paths(
            lambda x: growth * x, lambda x, dw: noise * x * dw, np.ones((1, paths)), coarser / steps, increments
        )
        errors.append(float(np.abs(path[-1] - exact).mean()))
    np.testing.assert_allclose(orders(errors), 1, atol=0.1)


def test_moments_converge_with_weak_order_one() -> None:
    """dx = -d x dt + g x o dV + s dW, noises that do not commute: one step errs by order 2 in E x and E x^2.

    The mean over the noise is a quadrature with the Gaussian nodes as paths, so nothing is left to chance.
    """
    d, g, s, x = 0.7, 0.9, 0.5, 1.3
    nodes, weights = np.polynomial.hermite_e.hermegauss(12)
    noise = np.stack([values.ravel() for values in np.meshgrid(nodes, nodes)])
    weight = np.outer(weights, weights).ravel() / (2 * np.pi)
    start = np.full((1, noise.shape[1]), x)
    first, second = [], []
    for step in (0.02, 0.01, 0.005):
        [end] = heun_step(lambda x: -d * x, lambda x, dw: g * x * dw[:1] + s * dw[1:], start, step, sqrt(step) * noise)
        rate = 2 * (g**2 - d)
        first.append(abs(weight @ end - x * exp((g**2 / 2 - d) * step)))
        second.append(abs(weight @ end**2 - (x**2 + s**2 / rate) * exp(rate * step) + s**2 / rate))
    np.testing.assert_allclose(orders(first), 2, atol=0.05)
    np.testing.assert_allclose(orders(second), 2, atol=0.05)


def test_the_splitting_converges_to_the_unsplit_scheme() -> None:
    body, steps, paths = Body(epsilon=0.2), 1024, 1_000
    rng = np.random.default_rng(4)
    start = rng.uniform(0.5, 1.5, (3, paths))
    fine = np.array(list(wiener_increments(rng, 4 / steps, steps, (6, paths))))
    reference = stratonovich_paths(body.whole_drift, body.diffusion, start, 4 / steps, fine)[-1]
    errors = []
    for coarser in (64, 32, 16, 8):
        increments = fine.reshape(-1, coarser, 6, paths).sum(axis=1)
        split = stratonovich_paths(
            body.drift, body.diffusion, start, 4 * coarser / steps, increments, flow=body.rotation
        )[-1]
        errors.append(float(np.abs(split - reference).mean()))
    assert (orders(errors) > 0.45).all()
    assert errors[-1] < 0.02


def test_energy_is_conserved_without_moments() -> None:
    body = Body(epsilon=0.0)
    start = np.random.default_rng(5).uniform(0.5, 1.5, (3, 50))
    still = [np.zeros((6, 50))] * 1_000
    paths = stratonovich_paths(body.drift, body.diffusion, start, 2.0, still, flow=body.rotation)
    assert np.abs(np.hypot(paths[:, 0], paths[:, 1]) - np.hypot(start[0], start[1])).max() < 1e-12
    assert (paths[:, 2] == start[2]).all()
    np.testing.assert_allclose(paths[-1], body.rotation(start, 2_000.0), atol=1e-9)


def test_heun_alone_gains_energy_with_the_cube_of_the_step() -> None:
    body, start = Body(epsilon=0.0), np.array([[1.0], [0.5], [2.0]])
    gains = []
    for steps in (50, 100, 200):
        still = [np.zeros((6, 1))] * steps
        end = stratonovich_paths(body.whole_drift, body.diffusion, start, 5 / steps, still)[-1]
        gains.append(float((end**2).sum() - (start**2).sum()))
    np.testing.assert_allclose(orders(gains), 3, atol=0.1)


def test_increments_are_those_of_wiener_processes() -> None:
    increments = np.array(list(wiener_increments(np.random.default_rng(6), 0.25, 100, (2, 500))))
    assert increments.shape == (100, 2, 500)
    assert abs(increments.mean()) < 4 * 0.5 / sqrt(increments.size)
    assert abs(increments.var() / 0.25 - 1) < 4 * sqrt(2 / increments.size)
