"""Kernels of Esenkov 2006: stability of a spinning body with liquid, with one mode."""

from __future__ import annotations

from typing import Any

from symcheck.core.claims import Hypothesis
from symcheck.core.lazy import lazy
from symcheck.kernels.codegen.kernel import Argument, Kernel, Output, largest_addend
from symcheck.papers.esenkov2006 import derivation
from symcheck.papers.esenkov2006.hypotheses import liquid_is_part, liquid_moves

sp = lazy("sympy")
MOMENT, RATE = "kg m^2", "rad/s"
TRANSVERSE = Argument("A", "transverse moment of inertia, with the liquid at rest", MOMENT, "0")
AXIAL = Argument("C", "axial moment of inertia", MOMENT, "0")
FLATTENED = Argument("Delta", "C - A: a flattened body", MOMENT, "0")
CARRIED = Argument("E_1", "moment of inertia that the mode carries", MOMENT, "0", "A")
NATURAL = Argument("lambda_1", "natural frequency of the mode", RATE)
RATIO = Argument("b_1", "natural frequency of the mode, divided by the spin", "1", "0", "1")
SPIN = Argument("omega_0", "spin", RATE, "0")
LARGEST = "Where terms cancel, the error is in units of the last place of the largest of them."
IN_THE_BAND = (
    liquid_moves,
    liquid_is_part,
    Hypothesis("in the band", "the mode is slower than the spin and does not turn against it", "0 < b_n, b_n < 1"),
)


def _letters(names: str) -> Any:
    return sp.symbols(names, real=True)


def _squares() -> tuple[Any, Any]:
    """u^2 and v^2 of B.11."""
    whole, mode, ratio = _letters("A E_1 b_1")
    return mode * (1 - ratio), ratio * (whole - mode)


def _product() -> Any:
    """u v, with the roots of a small moment and of a small ratio apart: their products may underflow."""
    whole, mode, ratio = _letters("A E_1 b_1")
    return sp.sqrt(mode) * sp.sqrt(ratio) * sp.sqrt((1 - ratio) * (whole - mode))


mode_inertia = Kernel(
    says="The moment of inertia that a mode of the liquid carries.",
    arguments=(
        Argument("a_1", "angular momentum of the liquid for the amplitude 1 of a mode of dimensionless shape", "kg m"),
        Argument("chi_1", "coupling of the mode to the turning body", "m^4"),
        Argument("N_1", "norm of the mode", "m^(3/2)", "0"),
    ),
    outputs=(Output("E_1", "moment of inertia of the mode", MOMENT),),
    derived=lambda: derivation.mode_inertias(1),
    claims=("1.32", "B.1"),
)

residue_of_a_mode = Kernel(
    says="Minus the residue of the characteristic equation at a natural frequency; modes with positive ones are harmless.",
    arguments=(Argument("E_1", CARRIED.meaning, MOMENT, "0"), NATURAL, SPIN),
    outputs=(Output("R_1", "minus the residue", "kg m^2 rad^2/s^2"),),
    derived=lambda: derivation.minus_residues(1),
    accurate=lambda: {name: sp.factor(value) for name, value in derivation.minus_residues(1).items()},
    claims=("N.3", "N.5"),
)


def _linear_coefficient() -> Any:
    whole, axial, mode, natural, spin = _letters("A C E_1 lambda_1 omega_0")
    return (axial - whole) * spin + mode * spin - whole * natural


characteristic_coefficients = Kernel(
    says="Coefficients of the quadratic equation (1.33) for the frequencies.",
    arguments=(TRANSVERSE, AXIAL, CARRIED, NATURAL, SPIN),
    outputs=(
        Output("c_2", "coefficient of eta^2", MOMENT),
        Output("c_1", "coefficient of eta", "kg m^2 rad/s"),
        Output("c_0", "constant term", "kg m^2 rad^2/s^2"),
    ),
    derived=derivation.characteristic_coefficients,
    accurate=lambda: {"c_1": _linear_coefficient(), "c_0": sp.factor(derivation.characteristic_coefficients()["c_0"])},
    claims=("1.32", "1.33"),
    scale=lambda: {"c_1": largest_addend(_linear_coefficient())},
    condition=LARGEST,
)


def _discriminant() -> Any:
    """Expanded about the natural frequency: both terms are as small as the mode's inertia where the body is unstable."""
    whole, axial, mode, natural, spin = _letters("A C E_1 lambda_1 omega_0")
    slope = (axial - whole) * spin + mode * (spin - natural) + (whole - mode) * natural
    return slope**2 + 4 * (whole - mode) * mode * natural * (natural - spin)


discriminant = Kernel(
    says="The discriminant of the quadratic equation (1.33): the body is stable where it is positive.",
    arguments=(TRANSVERSE, AXIAL, CARRIED, NATURAL, SPIN),
    outputs=(Output("D", "discriminant in eta", "kg^2 m^4 rad^2/s^2"),),
    derived=derivation.discriminant_in_eta,
    accurate=lambda: {"D": _discriminant()},
    claims=("1.33.3a", "1.33.4", "B.2", "B.6"),
    ulp=10,
    scale=lambda: {"D": sp.Add(*map(sp.Abs, _linear_coefficient().as_ordered_terms())) ** 2},
    condition="It is zero at the boundary of stability; the error is in units of the last place of what it were if nothing "
    "cancelled, the square of |C - A| omega_0 + E_1 omega_0 + A |lambda_1|; ten operations follow one another.",
)


def _roots_of_boundary() -> dict[str, Any]:
    """The greater root, which has a double zero, by the product of both, (u^2 - v^2)^2, but without its underflow."""
    first, second = _squares()
    total = first + second + 2 * _product()
    return {"Delta_1": (first - second) * (second / total - first / total), "Delta_2": -total}


boundary_of_stability = Kernel(
    says="The two values of C - A between which the body is unstable.",
    arguments=(TRANSVERSE, CARRIED, RATIO),
    outputs=(
        Output("Delta_1", "upper end", MOMENT),
        Output("Delta_2", "lower end", MOMENT),
    ),
    derived=derivation.boundary_roots,
    accurate=_roots_of_boundary,
    given=IN_THE_BAND,
    claims=("1.34.3", "1.34.5", "1.35a", "1.35c", "B.11"),
    scale=lambda: {"Delta_1": sp.Max(*_squares())},
    condition="The upper end is zero where A b_1 = E_1; its error is in units of the last place of the larger of "
    "E_1 (1 - b_1) and b_1 (A - E_1).",
)

width_of_the_unstable_interval = Kernel(
    says="The length of the interval of C - A in which the body is unstable.",
    arguments=(TRANSVERSE, CARRIED, RATIO),
    outputs=(Output("width", "length of the interval", MOMENT),),
    derived=derivation.boundary_roots,
    accurate=lambda: {"width": 4 * _product()},
    given=IN_THE_BAND,
    claims=("1.34.4", "B.16", "B.28"),
)


critical_frequencies = Kernel(
    says="The double frequencies at the two ends of the interval in which the body is unstable.",
    arguments=(TRANSVERSE, CARRIED, RATIO, SPIN),
    outputs=(
        Output("eta_1", "frequency at the upper end", RATE),
        Output("eta_2", "frequency at the lower end", RATE),
    ),
    derived=derivation.critical_frequencies,
    claims=("B.4", "B.26", "B.27"),
    scale=lambda: {"eta_1": largest_addend(sp.expand(derivation.critical_frequencies()["eta_1"]))},
    condition="The frequency at the upper end is zero where A b_1 = E_1. " + LARGEST,
)

greatest_growth_rate = Kernel(
    says="The rate at which the motion grows in the middle of the interval in which the body is unstable; nowhere is it greater.",
    arguments=(TRANSVERSE, CARRIED, RATIO, SPIN),
    outputs=(Output("y", "growth rate", "1/s"),),
    derived=derivation.greatest_growth_rate,
    claims=("B.6", "B.7", "B.8"),
)


def _stable_frequencies() -> dict[str, Any]:
    """The square root of a sum of two terms that are not negative."""
    whole, delta, mode, spin = _letters("A Delta E_1 omega_0")
    first, second = _squares()
    linear = delta + first - second
    root = sp.sqrt(linear**2 + 4 * delta * second)
    scale = spin / (whole - mode) / 2
    return {"eta_1": -scale * (linear + root), "eta_2": scale * (root - linear)}


def _scale_of_frequencies() -> dict[str, Any]:
    whole, delta, mode, spin = _letters("A Delta E_1 omega_0")
    return dict.fromkeys(("eta_1", "eta_2"), (delta + sp.Add(*_squares())) * spin / (whole - mode))


frequencies = Kernel(
    says="The two frequencies of a flattened body with one mode, which is stable.",
    arguments=(TRANSVERSE, FLATTENED, CARRIED, RATIO, SPIN),
    outputs=(
        Output("eta_1", "frequency against the spin", RATE),
        Output("eta_2", "frequency with the spin", RATE),
    ),
    derived=derivation.frequencies,
    accurate=_stable_frequencies,
    given=IN_THE_BAND,
    claims=("1.33", "1.34.3", "B.2", "B.18"),
    ulp=8,
    scale=_scale_of_frequencies,
    condition="The frequencies are differences of a root and a linear term; the error is in units of the last place of a bound "
    "of both, omega_0 / (A - E_1) times the sum of Delta, E_1 (1 - b_1) and b_1 (A - E_1); eight operations follow one another.",
)
