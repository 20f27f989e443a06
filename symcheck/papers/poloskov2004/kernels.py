"""Kernels of Poloskov 2004: drift and diffusion, raw and averaged; stationary densities, their moments and quantiles."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from symcheck.core.lazy import lazy
from symcheck.kernels.codegen.kernel import Argument, Kernel, Output, largest_addend
from symcheck.papers.poloskov2004 import derivation

sp = lazy("sympy")

RATE = "rad/s"
A = Argument("a", "amplitude of the equatorial angular velocity", RATE, "0")
PSI = Argument("psi", "phase", "rad")
OMEGA = Argument("Omega", "frequency k x_3", RATE)
K = Argument("k", "(A - C)/A, of the moments of inertia A, A, C", "1", "0")
SMALL = Argument("varepsilon", "small parameter of the torques", "1", "0")
ALPHA = Argument("alpha", "multiplicative noise, alpha^2 = g_11^2 + g_12^2", "s^(-1/2)", "0")
BETA = Argument("beta", "additive noise, beta^2 = g_21^2 + g_22^2", "rad s^(-3/2)", "0")
ORDER = Argument("m", "order of the moment", "1", "0", "8", closed=True)


def _gamma(low: str) -> Argument:
    return Argument("gamma", "dissipation, gamma^2 = d_11 + d_22", "s^(-1/2)", low)


def _axial(low: str) -> tuple[Argument, ...]:
    """The parameters of the density of Omega, the dissipation beyond `low`."""
    return K, *_noise("13", "23"), Argument("d_33", "coefficient of dissipation", "1/s", low)


def _dissipation(*entries: str) -> tuple[Argument, ...]:
    return tuple(Argument(f"d_{entry}", "coefficient of dissipation", "1/s", "0") for entry in entries)


def _noise(*entries: str) -> tuple[Argument, ...]:
    kinds = {"1": ("multiplicative", "s^(-1/2)"), "2": ("additive", "rad s^(-3/2)")}
    return tuple(
        Argument(f"g_{kind}{axis}", f"intensity of the {kinds[kind][0]} noise of axis {axis}", kinds[kind][1], "0")
        for kind, axis in map(tuple, entries)
    )


FULL = _dissipation(*(f"{i}{j}" for i in (1, 2, 3) for j in (1, 2, 3)))
EQUATORIAL_NOISE = _noise("11", "12", "21", "22")
AXIAL_NOISE = _noise("13", "23")
AMPLITUDE = (ALPHA, BETA, _gamma("alpha/2"))  # the density exists
FREQUENCY = _axial("0")

SUM = "These are sums with zeros inside the domain: the ulp are those of the largest addend."
LOGARITHM = (
    "An error is a relative error of the constant: the ulp are those of 2, of the larger addend or of the exponent, "
    "whichever is largest."
)
TAIL = "The ulp are those of the value times its condition number"


def _addends(derived: Callable[[], Mapping[str, Any]], *names: str) -> Callable[[], Mapping[str, Any]]:
    """The largest addends of some sums, multiplied out."""
    return lambda: {name: largest_addend(sp.expand(derived()[name])) for name in names}


def _conditioned(derived: Callable[[], Mapping[str, Any]], name: str, number: Callable[[], Any]) -> Any:
    """The absolute value of an output times a condition number, from where on doubles have all their digits."""
    return lambda: {name: sp.Max(sp.Integer(2) ** -960, sp.Abs(derived()[name]) * number())}


def _exponents() -> tuple[Any, Any]:
    """nu = |kappa_1| - 1, delta = |kappa_2| - 1/2."""
    found = derivation.exponents()
    return -found["kappa_1"] - 1, -found["kappa_2"] - sp.Rational(1, 2)


def _start(delta: str, x: str) -> Any:
    return derivation.exponents()[delta].subs(sp.Symbol(x, real=True), 0)


def _power_of_amplitude() -> Any:
    return 1 + (_exponents()[0] + 1) * sp.log(derivation.exponents()["Delta_1"] / _start("Delta_1", "a"))


def _power_of_frequency() -> Any:
    power = _exponents()[1] + sp.Rational(1, 2)
    return 1 + power * sp.log(derivation.exponents()["Delta_2"] / _start("Delta_2", "Omega"))


def _logarithmic(name: str, which: int) -> Callable[[], Mapping[str, Any]]:
    """The largest addend of a logarithm, its exponent, or 2."""
    return lambda: {
        name: sp.Max(2, 2 * _exponents()[which], largest_addend(derivation.logarithms_of_constants()[name]))
    }


def _growth() -> Any:
    return 1 - sp.log(1 - sp.Symbol("q", real=True)) / _exponents()[0]


def _order(which: int) -> Any:
    m, fall = sp.Symbol("m", real=True), _exponents()[which]
    return (2 + m) * (1 + sp.log(1 + m)) * fall / (fall - m / 2)


def _pole() -> Any:
    dissipation, noise = sp.Symbol("d_33", real=True), sp.Symbol("g_13", real=True) ** 2
    return (dissipation + noise) / (dissipation - noise)


stratonovich_drift = Kernel(
    says="Drift of amplitude, phase and frequency in Stratonovich's sense.",
    arguments=(A, PSI, OMEGA, K, SMALL, *FULL),
    outputs=(
        Output("v_1", "drift of a", "rad/s^2"),
        Output("v_2", "drift of theta", RATE),
        Output("v_3", "drift of Omega", "rad/s^2"),
    ),
    derived=derivation.drift_and_diffusion,
    claims=("2.4", "2.4.2"),
    ulp=6,
    scale=_addends(derivation.stratonovich_system, "v_1", "v_2", "v_3"),
    condition=SUM,
)

noise_intensities = Kernel(
    says="Intensities of the noises in amplitude, phase and frequency; h_13, h_16, h_23, h_26, h_31, h_32, h_34, h_35 are 0.",
    arguments=(A, PSI, OMEGA, K, SMALL, *EQUATORIAL_NOISE, *AXIAL_NOISE),
    outputs=tuple(
        Output(f"h_{i}{j}", f"intensity of noise {j} in {x}", unit)
        for i, x, unit, columns in (
            (1, "a", "rad/s^(3/2)", (1, 2, 4, 5)),
            (2, "theta", "rad/s^(1/2)", (1, 2, 4, 5)),
            (3, "Omega", "rad/s^(3/2)", (3, 6)),
        )
        for j in columns
    ),
    derived=derivation.drift_and_diffusion,
    claims=("2.4.5b", "2.4.6"),
    ulp=5,
    condition="In squares the last place of a sine or cosine counts twice.",
)


def _drift_by_factors() -> dict[str, Any]:
    """Fourth powers of a sine and cosine by their squares, as cos^2 + 2 sin^2 is 1 + sin^2: fewer operations."""
    letters = {x.name: x for each in derivation.drift_and_diffusion().values() for x in each.free_symbols}
    a, psi, frequency, k, small = (letters[each.name] for each in (A, PSI, OMEGA, K, SMALL))
    d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33 = (letters[each.name] for each in FULL)
    g_11, g_12, g_21, g_22, g_13 = (letters[each.name] for each in (*EQUATORIAL_NOISE, *_noise("13")))
    s, c, spin = sp.sin(psi), sp.cos(psi), frequency / k
    multiplicative = g_11**2 * c**2 * (1 + s**2) + g_12**2 * s**2 * (1 + c**2)
    along = 2 * s * c * (d_12 + d_21) - 2 * d_11 * c**2 - 2 * d_22 * s**2 + multiplicative
    turning = (g_11**2 + g_12**2) * (c**2 - s**2) / 2 + (g_21**2 - g_22**2) / a**2 + d_11 - d_22
    return {
        "K_1": small * (spin * (d_23 * s - d_13 * c) + (a * along + (g_21**2 * s**2 + g_22**2 * c**2) / a) / 2),
        "K_2": small * (spin * (d_13 * s + d_23 * c) / a + d_21 * c**2 - d_12 * s**2 + s * c * turning),
        "K_3": small * (frequency * (g_13**2 / 2 - d_33) + a * k * (d_32 * s - d_31 * c)),
    }


drift_coefficients = Kernel(
    says="Drift coefficients of the Fokker-Planck-Kolmogorov equation for amplitude, phase and frequency.",
    arguments=(A, PSI, OMEGA, K, SMALL, *FULL, *EQUATORIAL_NOISE, *_noise("13")),
    outputs=(
        Output("K_1", "drift of a", "rad/s^2"),
        Output("K_2", "drift of theta", RATE),
        Output("K_3", "drift of Omega", "rad/s^2"),
    ),
    derived=derivation.drift_and_diffusion,
    accurate=_drift_by_factors,
    claims=("3.1.2", "3.2.1"),
    ulp=8,
    scale=_addends(derivation.coefficients, "K_1", "K_2", "K_3"),
    condition=SUM,
)

diffusion_coefficients = Kernel(
    says="Diffusion coefficients of the Fokker-Planck-Kolmogorov equation: K_21 = K_12, the others are 0.",
    arguments=(A, PSI, OMEGA, K, SMALL, *EQUATORIAL_NOISE, *AXIAL_NOISE),
    outputs=(
        Output("K_11", "diffusion of a", "rad^2/s^3"),
        Output("K_12", "diffusion of a and theta", "rad^2/s^2"),
        Output("K_22", "diffusion of theta", "rad^2/s"),
        Output("K_33", "diffusion of Omega", "rad^2/s^3"),
    ),
    derived=derivation.drift_and_diffusion,
    claims=("3.1.2", "3.2.1"),
    ulp=8,
    scale=_addends(derivation.coefficients, "K_12"),
    condition="In fourth powers the last place of a sine or cosine counts four times. K_12 is a sum with zeros inside the "
    "domain: its ulp are those of the largest addend.",
)

averaged_drift = Kernel(
    says="Drift coefficients divided by epsilon, averaged over the phase.",
    arguments=(A, OMEGA, ALPHA, BETA, _gamma("0"), *_dissipation("12", "21", "33"), *_noise("13")),
    outputs=(
        Output("Kbar_1", "drift of a", "rad/s^2"),
        Output("Kbar_2", "drift of theta", RATE),
        Output("Kbar_3", "drift of Omega", "rad/s^2"),
    ),
    derived=derivation.densities,
    claims=("3.2.5", "3.2.7"),
    scale=_addends(derivation.densities, "Kbar_1", "Kbar_2", "Kbar_3"),
    condition=SUM,
)

averaged_diffusion = Kernel(
    says="Diffusion coefficients divided by epsilon, averaged over the phase; the mixed ones are 0.",
    arguments=(A, OMEGA, K, ALPHA, BETA, *AXIAL_NOISE),
    outputs=(
        Output("Kbar_11", "diffusion of a", "rad^2/s^3"),
        Output("Kbar_22", "diffusion of theta", "rad^2/s"),
        Output("Kbar_33", "diffusion of Omega", "rad^2/s^3"),
    ),
    derived=derivation.densities,
    claims=("3.2.3", "3.2.4", "3.2.7"),
)

density_of_amplitude = Kernel(
    says="Stationary density of the amplitude, normalised.",
    arguments=(A, *AMPLITUDE),
    outputs=(Output("p_s1", "density of a", "s/rad"),),
    derived=derivation.normalised_densities,
    claims=("3.4", "3.5", "4.0.3", "B.2", "B.3"),
    ulp=8,
    scale=_conditioned(derivation.normalised_densities, "p_s1", _power_of_amplitude),
    condition=f"{TAIL}, 1 + |kappa_1| log(1 + 3 alpha^2 a^2/(4 beta^2)), as the exponent is rounded.",
    degenerate="For alpha -> 0 it becomes Rayleigh's density. Where it is below 1e-308 it is 0.",
)

density_of_frequency = Kernel(
    says="Stationary density of the frequency, normalised; gamma() is Euler's function.",
    arguments=(OMEGA, *FREQUENCY),
    outputs=(Output("p_s3", "density of Omega", "s/rad"),),
    derived=derivation.normalised_densities,
    claims=("3.4.2", "3.5.1", "4.0.5", "B.5"),
    ulp=16,
    scale=_conditioned(derivation.normalised_densities, "p_s3", _power_of_frequency),
    condition=f"{TAIL}, 1 + |kappa_2| log(1 + g_13^2 Omega^2/(g_23 k)^2), as the exponent is rounded.",
    degenerate="For g_13 -> 0 it becomes normal. Where it is below 1e-308 it is 0.",
)

logarithm_of_constant_of_amplitude = Kernel(
    says="The logarithm of the constant in the density 8 C_1 a Delta_1^kappa_1 of the amplitude.",
    arguments=AMPLITUDE,
    outputs=(Output("log_C_1", "log C_1"),),
    derived=derivation.logarithms_of_constants,
    claims=("3.4", "3.5", "4.0.3", "B.2"),
    ulp=6,
    scale=_logarithmic("log_C_1", 0),
    condition=LOGARITHM,
)

logarithm_of_constant_of_frequency = Kernel(
    says="The logarithm of the constant in the density C_2 Delta_2^kappa_2 of the frequency; gamma() is Euler's function.",
    arguments=FREQUENCY,
    outputs=(Output("log_C_2", "log C_2"),),
    derived=derivation.logarithms_of_constants,
    claims=("3.4.2", "3.5.1", "4.0.5", "B.5"),
    ulp=16,
    scale=_logarithmic("log_C_2", 1),
    condition=LOGARITHM,
)

distribution_of_amplitude = Kernel(
    says="The probability that the amplitude is at most a.",
    arguments=(A, *AMPLITUDE),
    outputs=(Output("F", "probability"),),
    derived=derivation.distribution_of_amplitude,
    claims=("B.3",),
    ulp=8,
    condition="The exponent of the power is rounded.",
)

quantile_of_amplitude = Kernel(
    says="The amplitude that is exceeded with the probability 1 - q.",
    arguments=(Argument("q", "probability", "1", "0", "1"), ALPHA, BETA, _gamma("3*alpha/5")),
    outputs=(Output("a_q", "quantile of a", RATE),),
    derived=derivation.distribution_of_amplitude,
    claims=("B.3", "B.4"),
    ulp=8,
    scale=_conditioned(derivation.distribution_of_amplitude, "a_q", _growth),
    condition=f"{TAIL}, 1 + |log(1 - q)|/nu with nu = |kappa_1| - 1.",
    degenerate="Nearer to gamma = alpha/2, where the density ends to exist, quantiles may be infinite.",
)

moment_of_amplitude = Kernel(
    says="The mean of a^m; gamma() is Euler's function.",
    arguments=(ORDER, ALPHA, BETA, _gamma("alpha*sqrt((2 + 3*m)/8)*(1 + 1e-9)")),
    outputs=(Output("M_a", "moment", "(rad/s)^m"),),
    derived=derivation.moments,
    claims=("4.0.9", "B.2", "B.6"),
    ulp=16,
    scale=_conditioned(derivation.moments, "M_a", lambda: _order(0)),
    condition=f"{TAIL}, (2 + m) (1 + log(1 + m)) nu/(nu - m/2) with nu = |kappa_1| - 1.",
    degenerate="Beyond the domain the moment is infinite, and the formula means nothing.",
)

moment_of_frequency = Kernel(
    says="The mean of |Omega|^m; gamma() is Euler's function.",
    arguments=(ORDER, *_axial("m*g_13**2/2*(1 + 1e-9)")),
    outputs=(Output("M_Omega", "absolute moment", "(rad/s)^m"),),
    derived=derivation.moments,
    claims=("4.0.11", "B.5", "B.7"),
    ulp=16,
    scale=_conditioned(derivation.moments, "M_Omega", lambda: _order(1)),
    condition=f"{TAIL}, (2 + m) (1 + log(1 + m)) delta/(delta - m/2) with delta = d_33/g_13^2.",
    degenerate="Beyond the domain the moment is infinite, and the formula means nothing.",
)

mean_square_of_amplitude = Kernel(
    says="The mean of a^2.",
    arguments=(ALPHA, BETA, _gamma("alpha")),
    outputs=(Output("S_a", "mean square of a", "rad^2/s^2"),),
    derived=derivation.mean_squares,
    claims=("4.0.9", "B.8"),
    degenerate="Beyond the domain it is infinite, and the formula means nothing.",
)

mean_square_of_frequency = Kernel(
    says="The mean of Omega^2.",
    arguments=_axial("g_13**2"),
    outputs=(Output("S_Omega", "mean square of Omega", "rad^2/s^2"),),
    derived=derivation.mean_squares,
    claims=("4.0.11", "B.8"),
    scale=_conditioned(derivation.mean_squares, "S_Omega", _pole),
    condition=f"{TAIL}, (d_33 + g_13^2)/|d_33 - g_13^2|, as g_13^2 is rounded.",
    degenerate="Beyond the domain it is infinite, and the formula means nothing.",
)

mode_of_amplitude = Kernel(
    says="The most probable amplitude, where the density is largest; that of the frequency is 0.",
    arguments=(ALPHA, BETA, _gamma("0")),
    outputs=(Output("a_star", "mode of a", RATE),),
    derived=derivation.mode,
    claims=("4.0.13", "4.0.14", "4.0.15"),
)
