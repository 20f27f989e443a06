"""Poloskov 2004, section 4: existence, moments and modes of the stationary densities, and a numerical example."""

from symcheck.core.claims import Damage, Erratum, Hypothesis
from symcheck.core.problems import Applied
from symcheck.core.verdicts import Origin
from symcheck.papers.declare import Scope, body, by_cases, claim, exclusion, ours, premise
from symcheck.papers.poloskov2004 import derivation
from symcheck.papers.poloskov2004.hypotheses import (
    amplitude,
    axial_noise,
    constants,
    dissipation,
    equatorial_noise,
    order,
    positive_k,
)
from symcheck.papers.poloskov2004.notation import in_numbers, moment_letters
from symcheck.proof import cases, identity, theorems

density = Scope(where=derivation.densities, by=cases())

TOTAL_1 = r"\int_0^\infty a \Delta_1^{\kappa_1} \, da < \infty"
TOTAL_2 = r"\int_{-\infty}^\infty \Delta_2^{\kappa_2} \, d\Omega < \infty"
MOMENT_1 = r"\int_0^\infty a^m a \Delta_1^{\kappa_1} \, da < \infty"
MOMENT_2 = r"\int_0^\infty \Omega^m \Delta_2^{\kappa_2} \, d\Omega < \infty"

OFF_DIAGONAL = ("12", "13", "21", "23", "31", "32")

only_diagonal_elements_matter = by_cases.claim(
    "4.0.1",
    95,
    words="In the first approximation of D only the diagonal elements influence the densities of a and Omega.",
    states=r" \land ".join(
        rf"\frac{{\partial \bar{{K}}_{i}}}{{\partial d_{{{entry}}}}} = 0" for i in (1, 3) for entry in OFF_DIAGONAL
    ),
    given=[amplitude],
    where=derivation.averaged_coefficients,
    uses=["3.2.5", "3.3.9"],
)

density_of_amplitude_exists = density.claim(
    "4.0.2",
    95,
    r"4\gamma^2 > \alpha^2",
    words="The density of a exists only under this condition.",
    states=rf"{TOTAL_1} \Rightarrow 4\gamma^2 > \alpha^2",
    given=[equatorial_noise],
    uses=["3.4", "3.5"],
)

density_of_amplitude_exists_exactly = density.ours(
    "4.0.3",
    95,
    words="And whenever it holds, as long as there is additive noise (beta > 0).",
    states=rf"{TOTAL_1} \Leftrightarrow 4\gamma^2 > \alpha^2",
    given=[equatorial_noise],
    uses=["4.0.2"],
)

density_of_frequency_exists = density.claim(
    "4.0.4",
    95,
    r"d_{33} > 0",
    words="The density of Omega exists only under this condition.",
    states=rf"{TOTAL_2} \Rightarrow d_{{33}} > 0",
    given=[axial_noise, positive_k],
    uses=["3.4.2", "3.5.1"],
)

density_of_frequency_exists_exactly = density.ours(
    "4.0.5",
    95,
    words="And whenever it holds.",
    states=rf"{TOTAL_2} \Leftrightarrow d_{{33}} > 0",
    given=[axial_noise, positive_k],
    uses=["4.0.4"],
)

dissipation_was_assumed = by_cases.claim(
    "4.0.6",
    95,
    words="The latter was assumed when the problem was posed: D has positive elements.",
    states=r"d_{33} > 0",
    given=[dissipation],
    uses=["1.1.7"],
)

orders_of_moments = premise("4.0.7", 95, r"m = 1, 2, \dots", words="Orders of the moments.")

moments_of_amplitude_are_finite = density.claim(
    "4.0.8",
    95,
    r"8\gamma^2 > \alpha^2(2 + 3m)",
    words="Then the moment of a of order m is finite.",
    states=rf"8\gamma^2 > \alpha^2(2 + 3m) \Rightarrow {MOMENT_1}",
    given=[equatorial_noise, order],
    uses=["3.4", "3.5"],
)

moments_of_amplitude_are_finite_only_then = density.ours(
    "4.0.9",
    95,
    words="And only then; for m = 0 the condition is that of existence.",
    states=rf"{MOMENT_1} \Leftrightarrow 8\gamma^2 > \alpha^2(2 + 3m)",
    given=[equatorial_noise, Hypothesis("order", "the order of the moment is not negative", r"m \geq 0")],
    uses=["4.0.8"],
)

moments_of_frequency_are_finite = density.claim(
    "4.0.10",
    95,
    "3d_{33} > mg_{13}^2",
    words="Then the (absolute) moment of Omega of order m is finite.",
    states=rf"3d_{{33}} > mg_{{13}}^2 \Rightarrow {MOMENT_2}",
    given=[axial_noise, positive_k, order],
    uses=["3.4.2", "3.5.1"],
    errata={
        "": Erratum(
            rf"2d_{{33}} > mg_{{13}}^2 \Rightarrow {MOMENT_2}",
            "wrong number",
            Origin.UNCERTAIN,
            "The tail of the density is Omega^(-2 d_33/g_13^2 - 1); its moment of order m is finite for 2 d_33 > m g_13^2 and "
            "only then (4.0.11). For m = 2, d_33 = g_13^2 the printed condition holds and the variance is infinite. 3 for 2 may "
            "be the author's slip (the condition before it has a 3 before m) or a misread digit.",
            summary=r"The moment of order $m$ is finite for $2d_{33} > mg_{13}^2$ and only then; for $m = 2$, $d_{33} = g_{13}^2$ "
            "the printed condition holds, and the variance is infinite.",
            instead="$2d_{33} > mg_{13}^2$",
        )
    },
)

moments_of_frequency_are_finite_only_then = density.ours(
    "4.0.11",
    95,
    words="The moment of order m of Omega is finite exactly for 2 d_33 > m g_13^2.",
    states=rf"{MOMENT_2} \Leftrightarrow 2d_{{33}} > mg_{{13}}^2",
    given=[axial_noise, positive_k, Hypothesis("order", "the order of the moment is not negative", r"m \geq 0")],
    uses=["4.0.10"],
)

odd_moments_vanish = by_cases.claim(
    "4.0.12",
    95,
    words="All odd moments of the density (3.5) are zero (order m = 2n + 1, where finite).",
    states=r"2d_{33} > (2n + 1) g_{13}^2 \Rightarrow "
    r"\int_{-\infty}^\infty \Omega (\Omega^2)^n \Delta_2^{\kappa_2} \, d\Omega = 0",
    given=[axial_noise, positive_k, Hypothesis("n", "n is not negative", r"n \geq 0")],
    where=derivation.densities,
    uses=["4.0.11"],
    notation=moment_letters,
)

mode_of_amplitude = claim(
    "4.0.13",
    99,
    r"\alpha_* = 2 \sqrt{\frac{\beta^2}{8\gamma^2 + \alpha^2}}",
    words="The mode of a.",
    damage=Damage(
        r"a_* = 2 \sqrt{\frac{\beta^2}{8\gamma^2 + \alpha^2}}",
        reason="The point is a value of the amplitude a, as Omega_* is one of Omega, and the parameter alpha stands on the right; "
        "the OCR takes an italic a for alpha, or the author did.",
        kind="one letter for another",
        origin=Origin.UNCERTAIN,
    ),
    given=[equatorial_noise],
    where=derivation.mode,
    by=theorems(
        Applied("equal_squares", (r"\sqrt{\alpha^2 + 8\gamma^2} \sqrt{\frac{\beta^2}{8\gamma^2 + \alpha^2}}", r"\beta"))
    ),
    uses=["3.4"],
)

SLOPE_1 = r"\frac{\partial p_{s1}}{\partial a}"
SLOPE_2 = r"\frac{\partial p_{s3}}{\partial \Omega}"
RISING = r"(8\gamma^2 + \alpha^2) a^2 < 4\beta^2"
STATIONARY = r"(8\gamma^2 + \alpha^2) a^2 = 4\beta^2"
FALLING = r"(8\gamma^2 + \alpha^2) a^2 > 4\beta^2"

mode_is_the_stationary_point = ours(
    "4.0.14",
    99,
    words="The mode without a root.",
    states=r"(8\gamma^2 + \alpha^2) a_*^2 = 4\beta^2",
    given=[equatorial_noise],
    where=derivation.mode,
    uses=["4.0.13"],
)

amplitude_is_unimodal = density.claim(
    "4.0.15",
    97,
    words="The density of a rises up to a_* and falls beyond it.",
    states=rf"({SLOPE_1} > 0 \Leftrightarrow {RISING}) \land ({SLOPE_1} = 0 \Leftrightarrow {STATIONARY}) \land "
    rf"({SLOPE_1} < 0 \Leftrightarrow {FALLING})",
    given=[amplitude, equatorial_noise, constants],
    uses=["3.4", "4.0.14"],
)

slope_of_amplitude = by_cases.ours(
    "4.0.16",
    97,
    words="Its logarithmic derivative lambda has the sign of 4 beta^2 - (8 gamma^2 + alpha^2) a^2.",
    states=r"\lambda a \Delta_1 = 4\beta^2 - (8\gamma^2 + \alpha^2) a^2 \land \Delta_1 > 0",
    given=[amplitude, equatorial_noise],
    where=derivation.slope_of_amplitude,
    uses=["4.0.15"],
    notation=moment_letters,
)

mode_of_frequency = density.claim(
    "4.0.17",
    109,
    r"\Omega_* = 0",
    words="The density of Omega rises up to Omega = 0 and falls beyond it.",
    states=rf"({SLOPE_2} > 0 \Leftrightarrow \Omega < 0) \land ({SLOPE_2} = 0 \Leftrightarrow \Omega = 0) \land "
    rf"({SLOPE_2} < 0 \Leftrightarrow \Omega > 0)",
    given=[axial_noise, positive_k, dissipation, constants],
    uses=["3.4.2"],
)

slope_of_frequency = by_cases.ours(
    "4.0.18",
    109,
    words="Its logarithmic derivative lambda has the sign of -Omega.",
    states=r"\lambda \Delta_2 = -(2d_{33} + g_{13}^2) \Omega \land \Delta_2 > 0",
    given=[axial_noise, positive_k],
    where=derivation.slope_of_frequency,
    uses=["4.0.17"],
    notation=moment_letters,
)

most_probable_values = exclusion(
    "4.0.19", 109, words="The modes are the most probable values.", reason="says what a mode is"
)

plots = exclusion("4.0.20", 103, words="Figures 1 and 2.", reason="plots of the two densities; not in the text at hand")

equatorial_dissipation = premise(
    "4.0.21", 111, "d_{11} = d_{22} = 0.5", words="Values of the example.", notation=in_numbers
)
axial_dissipation = premise("4.0.22", 111, "d_{33} = 1.5", words="Values of the example.", notation=in_numbers)
multiplicative_intensity = premise("4.0.23", 111, r"\alpha^2 = 1", words="Values of the example.", notation=in_numbers)
additive_intensity = premise("4.0.24", 111, r"\beta^2 = 0.75", words="Values of the example.", notation=in_numbers)
axial_intensities = premise(
    "4.0.25", 111, "g_{13}^2 = g_{23}^2 = 1", words="Values of the example.", notation=in_numbers
)

equatorial_values = Hypothesis(
    "equatorial values",
    "the printed values, gamma^2 = d_11 + d_22",
    rf"{body(equatorial_dissipation, multiplicative_intensity, additive_intensity)} \land \gamma^2 = d_{{11}} + d_{{22}}",
)
axial_values = Hypothesis("axial values", "the printed values", body(axial_dissipation, axial_intensities))

constant_of_amplitude = density.claim(
    "4.0.26",
    111,
    "C_1 = 2.25",
    words="At these values the density of a has this constant.",
    given=[
        equatorial_values,
        equatorial_noise,
        Hypothesis("normalised", "the integral of the density of a is 1", r"\int_0^\infty p_{s1}(a) \, da = 1"),
    ],
    by=identity,
    uses=["3.4", "3.5", "3.5.2"],
)

constant_of_frequency_depends_on_k = density.ours(
    "4.0.29",
    111,
    words="At these values the constant depends on k, which the paper does not print.",
    states=r"\int_{-\infty}^\infty p_{s3}(\Omega) \, d\Omega = 1 \Leftrightarrow C_2 = \frac{2k^3}{\pi}",
    given=[axial_values, axial_noise, positive_k],
    uses=["3.4.2", "3.5.1", "3.5.2"],
)

constant_of_frequency = claim(
    "4.0.27",
    111,
    r"C_2 = 54/125\pi",
    words="At these values the density of Omega has this constant.",
    given=[positive_k],
    where=derivation.constant_of_the_example,
    uses=["4.0.29"],
    errata={
        "": Erratum(
            "",
            "missing hypothesis",
            Origin.PAPER,
            "The constant is 2 k^3/pi: it depends on k, which the paper does not print. 54/(125 pi) belongs to k = 3/5 and to no "
            "other k. No other printed quantity of the example needs k.",
            needs=(Hypothesis("k", "k = 3/5", "k = 3/5"),),
            summary="The constant depends on $k$, which is not printed; the printed value is that for $k = 3/5$.",
            instead=r"$C_2 = 2k^3/\pi$, which is $54/(125\pi)$ for $k = 3/5$",
        )
    },
)

computed_with_mathematica = exclusion(
    "4.0.28", 111, words="Plots and calculations were made with Mathematica [6].", reason="names a tool"
)
