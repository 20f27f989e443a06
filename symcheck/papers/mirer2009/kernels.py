"""Kernels of Mirer 2009: moments of inertia about turned axes, and the damping of a rotation about them."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from symcheck.core.claims import Hypothesis
from symcheck.core.lazy import lazy
from symcheck.kernels.codegen.kernel import Argument, Kernel, Output, largest_addend
from symcheck.papers.mirer2009 import derivation
from symcheck.papers.mirer2009.hypotheses import positive_moments

sp = lazy("sympy")
MOMENT, SQUARE, CUBE, RATE = "kg m^2", "kg^2 m^4", "kg^3 m^6", "1/s"
GAIN = "N m s/rad"
ANGLES = tuple(
    Argument(name, meaning, "rad") for name, meaning in (("alpha", "pitch"), ("beta", "yaw"), ("gamma", "roll"))
)
PRINCIPAL = tuple(Argument(f"I_{i}", "principal moment of inertia", MOMENT, "0") for i in (1, 2, 3))
ROWS = tuple(
    tuple(
        Argument(f"a_{i}{j}", f"cosine between axis {i} and principal axis {j}", low="-1", high="1", closed=True)
        for j in (1, 2, 3)
    )
    for i in (1, 2, 3)
)
COSINES = tuple(cosine for row in ROWS for cosine in row)
GAINS = tuple(Argument(f"k_{i}", f"gain of the damping device along axis {i}", GAIN, "0") for i in (1, 2, 3))
RATIO = Argument("k", "gains divided by the moments of inertia about their axes", RATE, "0")
LARGEST = "Where terms cancel, the error is in units of the last place of the largest of them."


def _product(condition: int) -> str:
    """Why a product of sums of positive terms errs by more; its condition number is its degree."""
    return (
        "A product of sums keeps the roundings of all its factors, as many operations follow one another; its condition "
        f"number is {condition}, so that arguments rounded to the nearest double change it by as many half units."
    )


def _scales(derived: Callable[[], dict[str, Any]]) -> dict[str, Any]:
    """The largest addend of each output."""
    return {name: largest_addend(expression) for name, expression in derived().items()}


def _coefficients(gains: str) -> tuple[Output, ...]:
    return tuple(
        Output(f"c_{power}", f"coefficient of p^{power}, for {gains}", unit)
        for power, unit in ((3, CUBE), (2, f"{CUBE}/s"), (1, f"{CUBE}/s^2"), (0, f"{CUBE}/s^3"))
    )


direction_cosines = Kernel(
    says="Cosines between the turned axes and the principal ones, by pitch, yaw and roll.",
    arguments=ANGLES,
    outputs=tuple(Output(argument.name, argument.meaning) for argument in COSINES),
    derived=derivation.direction_cosines,
    claims=tuple(f"2.7.{n}" for n in range(5, 14)),
    scale=partial(_scales, derivation.direction_cosines),
    ulp=6,
    condition=LARGEST,
)

axial_moments = Kernel(
    says="Moments of inertia about three turned axes.",
    arguments=(*PRINCIPAL, *COSINES),
    outputs=tuple(Output(f"J_{i}", f"moment of inertia about axis {i}", MOMENT) for i in (1, 2, 3)),
    derived=derivation.axial_moments,
    claims=("2.0.4", "1.4.1"),
)

second_order_moments = Kernel(
    says="The quadratic forms L_i of the adjugate of the inertia tensor, for three turned axes.",
    arguments=(*PRINCIPAL, *COSINES),
    outputs=tuple(Output(f"L_{i}", f"product of two moments, of axis {i}", SQUARE) for i in (1, 2, 3)),
    derived=derivation.second_order_moments,
    claims=("1.3.2", "1.3.3"),
)

product_of_axial_moments = Kernel(
    says="The product f of the moments of inertia about three turned axes.",
    arguments=(*PRINCIPAL, *COSINES),
    outputs=(Output("f", "J_1 J_2 J_3", CUBE),),
    derived=derivation.products_of_moments,
    claims=("2.1", "2.13.4"),
    ulp=14,
    condition=_product(9),
)

sum_of_products = Kernel(
    says="The sum of the products J_i L_i, the coefficient that decides how far the damping is from its optimum.",
    arguments=(*PRINCIPAL, *COSINES),
    outputs=(Output("S", "J_1 L_1 + J_2 L_2 + J_3 L_3", CUBE),),
    derived=derivation.products_of_moments,
    claims=("2.18", "2.19.4"),
    ulp=12,
    condition=_product(7),
)

bounds_of_products = Kernel(
    says="The least and greatest product of moments about orthogonal axes, and the least sum of the products J_i L_i.",
    arguments=PRINCIPAL,
    outputs=(
        Output("f_least", "least J_1 J_2 J_3, about principal axes", CUBE),
        Output("f_greatest", "greatest J_1 J_2 J_3, about axes of equal moments", CUBE),
        Output("S_least", "least J_1 L_1 + J_2 L_2 + J_3 L_3, about principal axes", CUBE),
    ),
    derived=derivation.bounds_of_products,
    accurate=lambda: {"f_greatest": sum(map(_letter, ("I_1", "I_2", "I_3"))) ** 3 / 27},
    claims=("2.1", "2.3.7", "2.18"),
    ulp=9,
    condition="A cube triples the error of the mean moment: its condition number is 3.",
)


def _scales_of_distances() -> dict[str, Any]:
    """What the distances were if nothing cancelled in a sum."""
    moments, (first, second, third) = sp.symbols("I_1:4", real=True), derivation.axial_moments().values()
    mean, exact = sp.Add(*moments) / 3, derivation.distances_from_bounds()
    crossed = sp.Add(
        *(
            moments[k] * sp.Abs(sp.Symbol(f"a_1{k + 1}", real=True)) * sp.Abs(sp.Symbol(f"a_3{k + 1}", real=True))
            for k in range(3)
        )
    )
    return {
        "f_excess": exact["f_excess"] + second * crossed**2,
        "f_deficit": ((mean + second) ** 2 * (first + third + mean) + second * (first + third) ** 2) / 4,
    }


distances_from_bounds = Kernel(
    says="How far J_1 J_2 J_3 and the sum of J_i L_i of orthogonal axes are from their bounds; never negative.",
    arguments=(*PRINCIPAL, *COSINES),
    outputs=(
        Output("f_excess", "J_1 J_2 J_3 - I_1 I_2 I_3", CUBE),
        Output("f_deficit", "((I_1 + I_2 + I_3)/3)^3 - J_1 J_2 J_3", CUBE),
        Output("S_excess", "J_1 L_1 + J_2 L_2 + J_3 L_3 - 3 I_1 I_2 I_3", CUBE),
    ),
    derived=derivation.distances_from_bounds,
    claims=("2.13.4", "2.19.4", "2.2", "2.1"),
    ulp=12,
    scale=_scales_of_distances,
    condition="Sums of squares: near a bound they keep the digits that a difference loses. Within a square J_1 - J_3, the mean "
    "moment less J_2, and a product of inertia may cancel; the error is in units of the last place of what it were if they did not.",
)

bound_at_given_moment = Kernel(
    says="The greatest product J_1 J_2 J_3 of moments about orthogonal axes for a given J_2.",
    arguments=(
        *PRINCIPAL,
        Argument("J_2", "moment of inertia about axis 2", MOMENT, "0", "(I_1 + I_2 + I_3)/2", closed=True),
    ),
    outputs=(Output("f_1", "greatest J_1 J_2 J_3", CUBE),),
    derived=derivation.bound_at_given_moment,
    claims=("2.2",),
    ulp=8,
    condition="A square doubles the error of the two other moments, which are at least half of all three.",
)

product_of_two_axial_moments = Kernel(
    says="The product of the moments of inertia about two axes.",
    arguments=(*PRINCIPAL, *ROWS[0], *ROWS[2]),
    outputs=(Output("J_1_J_3", "J_1 J_3", SQUARE),),
    derived=derivation.products_of_moments,
    claims=("2.11.3", "2.12"),
    ulp=9,
    condition=_product(6),
)

product_with_second_moment = Kernel(
    says="The product of the moment of inertia J_2 and the form L_2 of the same axis.",
    arguments=(*PRINCIPAL, *ROWS[1]),
    outputs=(Output("J_2_L_2", "J_2 (I_1 I_2 a_23^2 + I_2 I_3 a_21^2 + I_3 I_1 a_22^2)", CUBE),),
    derived=derivation.products_of_moments,
    claims=("2.12.1", "2.13"),
    ulp=10,
    condition=_product(7),
)

damping_matrix = Kernel(
    says="The damping matrix of three devices in principal axes, on its diagonal and above; it is symmetric.",
    arguments=(*GAINS, *COSINES),
    outputs=tuple(Output(f"m_{i}{j}", f"entry {i}, {j}", GAIN) for i in (1, 2, 3) for j in range(i, 4)),
    derived=derivation.symmetric_damping_entries,
    claims=("1.2.6", "1.2.12"),
    scale=partial(_scales, derivation.symmetric_damping_entries),
    condition=LARGEST,
)

characteristic_coefficients = Kernel(
    says="Coefficients of the characteristic equation (1.3) of the damped rotation.",
    arguments=(*PRINCIPAL, *GAINS, *COSINES),
    outputs=_coefficients("orthogonal axes"),
    derived=derivation.characteristic_coefficients,
    claims=("1.3", "1.3.2", "1.3.3"),
    ulp=8,
    condition=_product(5),
)

characteristic_coefficients_at_common_ratio = Kernel(
    says="Coefficients of the characteristic equation (1.5): gains in proportion to the moments about their axes.",
    arguments=(*PRINCIPAL, RATIO, *COSINES),
    outputs=_coefficients("gains k J_i"),
    derived=derivation.characteristic_coefficients_at_common_ratio,
    claims=("1.5", "1.3.3"),
    ulp=16,
    condition=_product(12),
)

gains_in_proportion = Kernel(
    says="Gains in proportion to the moments of inertia about their axes; along principal axes k is the stability degree.",
    arguments=(RATIO, *PRINCIPAL, *COSINES),
    outputs=tuple(Output(f"k_{i}", f"gain of the damping device along axis {i}", GAIN) for i in (1, 2, 3)),
    derived=derivation.gains_in_proportion,
    claims=("1.5", "1.8", "1.8.1"),
)


def _letter(name: str) -> Any:
    return sp.Symbol(name, real=True)


def _excess_as_sum() -> dict[str, Any]:
    """k - xi without a difference."""
    xi, *excess = map(_letter, ("xi", "s_1", "s_2", "s_3"))
    times = [1 / (xi + s) for s in excess]
    return {"k_excess": sp.Add(*(s * time for s, time in zip(excess, times, strict=True))) / sp.Add(*times)}


gain_of_rates = Kernel(
    says="The gain ratio k that three damping rates need, and how far it is above the least of them, the stability degree.",
    arguments=(
        Argument("xi", "least damping rate", RATE, "0"),
        *(Argument(f"s_{i}", f"rate {i} less the least one", RATE, "0", closed=True) for i in (1, 2, 3)),
    ),
    outputs=(
        Output("k", "harmonic mean of the rates: the greatest stability degree for these gains", RATE),
        Output("k_excess", "k - xi", RATE),
    ),
    derived=derivation.excess_of_gain,
    accurate=_excess_as_sum,
    claims=("B.3", "B.4"),
    ulp=10,
    condition="Ten operations follow one another in k_excess, none of which cancels.",
    degenerate="With s_1 = s_2 = s_3 = 0, the triple root, k is xi.",
)


def _degree_in_tangent() -> dict[str, Any]:
    """1 - x = 1/(1 + x/(1 - x)) with x/(1 - x) in t = tan alpha: only the two moments are still subtracted, once."""
    k, first, third = map(_letter, ("k", "I_1", "I_3"))
    t = sp.tan(_letter("alpha"))
    ratio = first * third * (1 + t**2) ** 2 / (t * (first - third)) ** 2
    return {"xi": k / (1 + sp.sqrt(1 / (1 + ratio)))}


stability_degree_in_pitch = Kernel(
    says="The stability degree, the least damping rate, of gains k J_i along axes that are turned by the pitch alone.",
    arguments=(
        RATIO,
        PRINCIPAL[0],
        PRINCIPAL[2],
        Argument("alpha", "pitch", "rad", "0", "pi/2"),
    ),
    outputs=(Output("xi", "stability degree", RATE),),
    derived=derivation.stability_degree_in_pitch,
    accurate=_degree_in_tangent,
    given=(
        positive_moments,
        Hypothesis("pitch", "the pitch lies between 0 and 90 degrees", r"\sin \alpha > 0, \cos \alpha > 0"),
        Hypothesis("moments distinct", "I_1 and I_3 differ", r"I_1 \ne I_3"),
    ),
    claims=("1.5", "B.2", "B.3", "B.4"),
    degenerate="For I_1 = I_3 and for the pitch 0 the stability degree is k, the greatest there is.",
)


def _pitch_from_ratio() -> dict[str, Any]:
    """Differences of two moments only: exact where the moments nearly coincide."""
    first, second, third = map(_letter, ("I_1", "I_2", "I_3"))
    return {"alpha": sp.atan((1 + (first - second) / (second - third) * 2) / sp.sqrt(3)) / 2}


equal_moment_pitch = Kernel(
    says="The pitch at which the moments about all three axes are equal, with the yaw arcsin(1/sqrt 3) and the roll pi/4.",
    arguments=PRINCIPAL,
    outputs=(Output("alpha", "pitch", "rad"),),
    derived=derivation.equal_moment_pitch,
    accurate=_pitch_from_ratio,
    given=(Hypothesis("I_2, I_3 distinct", "I_2 and I_3 differ (line 278)", r"I_2 \ne I_3"),),
    claims=("2.8.1", "2.9", "2.9.2"),
    scale=lambda: {"alpha": sp.pi / 4},
    condition="The pitch is zero where I_1 is the mean moment; the error is in units of the last place of the greatest, pi/4.",
    degenerate="For I_2 = I_3 it is pi/4 or -pi/4; if all three moments are equal, every pitch serves, and there is no number.",
)
