"""Beyond Poloskov 2004: constants, moments and quantiles in closed form; what averaging needs and neglects."""

from symcheck.core.claims import Hypothesis
from symcheck.core.problems import Applied
from symcheck.papers.declare import Scope, by_cases, ours
from symcheck.papers.poloskov2004 import derivation
from symcheck.papers.poloskov2004.hypotheses import (
    amplitude,
    amplitude_density_exists,
    axial_noise,
    equatorial_noise,
    positive_k,
)
from symcheck.papers.poloskov2004.notation import amplitude_letters, full_noise, moment_letters
from symcheck.proof import theorems

moments = Scope(moment_letters, derivation.moment_parameters)

frequency_density_exists = Hypothesis("density of Omega exists", "the condition of existence", r"d_{33} > 0")
finite_amplitude = Hypothesis(
    "moment finite", "the moment of a is finite (4.0.9)", r"8\gamma^2 > \alpha^2 (2 + 3m), m \geq 0"
)
finite_frequency = Hypothesis(
    "moment finite", "the moment of Omega is finite (4.0.11)", r"2 d_{33} > m g_{13}^2, m \geq 0"
)

partial_integral_of_amplitude = Scope(amplitude_letters, derivation.moment_parameters).ours(
    "B.1",
    85,
    words="The density of a has an elementary integral.",
    states=r"\int_0^q a \Delta_1^{\kappa_1} \, da = \frac{(4\beta^2)^{-\nu} - (3\alpha^2 q^2 + 4\beta^2)^{-\nu}}{6 \alpha^2 \nu}",
    given=[equatorial_noise, amplitude_density_exists, Hypothesis("end", "q is positive", "q > 0")],
    uses=["3.4", "3.5"],
)

constant_of_amplitude = moments.by_cases.ours(
    "B.2",
    93,
    words="So the constant is elementary for all parameters: C_1 = (4 gamma^2 - alpha^2)/4 (4 beta^2)^nu.",
    states=r"\int_0^\infty p_{s1} \, da = 1 \Leftrightarrow C_1 = \frac{4\gamma^2 - \alpha^2}{4} (4\beta^2)^{\nu}",
    given=[equatorial_noise, amplitude_density_exists],
    uses=["3.5.2", "B.1"],
)

STRETCHED = r"1 + \frac{3\alpha^2 a^2}{4\beta^2}"

distribution_of_amplitude = moments.ours(
    "B.3",
    85,
    words="The distribution function of a is 1 - (1 + 3 alpha^2 a^2 / 4 beta^2)^(-nu).",
    states=r"\frac{\partial}{\partial a} \left(1 - \left(1 + \frac{3\alpha^2 a^2}{4\beta^2}\right)^{-\nu}\right) = p_{s1}",
    given=[
        amplitude,
        equatorial_noise,
        amplitude_density_exists,
        Hypothesis("constant", "C_1 is that of B.2", r"C_1 = \frac{4\gamma^2 - \alpha^2}{4} (4\beta^2)^{\nu}"),
    ],
    by=theorems(
        Applied("power_of_product", (r"4\beta^2", STRETCHED, r"\kappa_1")),
        Applied("power_of_sum", (STRETCHED, r"-\nu", "-1")),
        Applied("power_of_sum", (r"4\beta^2", r"\nu", r"\kappa_1")),
    ),
    uses=["B.2"],
)

quantiles_of_amplitude = moments.ours(
    "B.4",
    85,
    words="The quantile a of the probability q in closed form.",
    states=r"1 - \left(1 + \frac{3\alpha^2 a^2}{4\beta^2}\right)^{-\nu} = q \Leftrightarrow "
    r"a^2 = \frac{4\beta^2}{3\alpha^2} \left((1 - q)^{-1/\nu} - 1\right)",
    given=[
        amplitude,
        equatorial_noise,
        amplitude_density_exists,
        Hypothesis("probability", "q is a probability", "q > 0, q < 1"),
    ],
    by=theorems(
        Applied("power_inverse", (STRETCHED, r"-\nu", "1 - q")),
        Applied("power_inverse", ("1 - q", r"-1/\nu", STRETCHED)),
    ),
    uses=["B.3"],
)

constant_of_frequency = moments.by_cases.ours(
    "B.5",
    93,
    words="The other constant: C_2 = g_13 Gamma(delta + 1/2)/(sqrt(pi) Gamma(delta)) (g_23 k)^(2 delta).",
    states=r"\int_{-\infty}^\infty p_{s3} \, d\Omega = 1 \Leftrightarrow "
    r"C_2 = \frac{g_{13} \Gamma(\delta + 1/2)}{\sqrt{\pi} \Gamma(\delta)} (g_{23} k)^{2\delta}",
    given=[axial_noise, positive_k, frequency_density_exists],
    uses=["3.5.2"],
)

moments_of_amplitude = moments.ours(
    "B.6",
    95,
    words="Every finite moment of a (not yet divided by the integral, B.2).",
    states=r"\int_0^\infty a^m a \Delta_1^{\kappa_1} \, da = \frac{1}{2} (3\alpha^2)^{-1-m/2} (4\beta^2)^{m/2-\nu} "
    r"\frac{\Gamma(1 + m/2) \Gamma(\nu - m/2)}{\Gamma(1 + \nu)}",
    given=[equatorial_noise, finite_amplitude],
    uses=["4.0.9", "B.2"],
)

moments_of_frequency = moments.ours(
    "B.7",
    95,
    words="Every finite absolute moment of Omega (half of it, not yet divided by the integral, B.5).",
    states=r"\int_0^\infty \Omega^m \Delta_2^{\kappa_2} \, d\Omega = \frac{1}{2} g_{13}^{-1-m} (g_{23} k)^{m - 2\delta} "
    r"\frac{\Gamma(m/2 + 1/2) \Gamma(\delta - m/2)}{\Gamma(\delta + 1/2)}",
    given=[axial_noise, positive_k, finite_frequency],
    uses=["4.0.11", "B.5"],
)

balance_of_squares = by_cases.ours(
    "B.8",
    95,
    words="Without integrals: 2 a Kbar_1 + Kbar_11 = beta^2 - (gamma^2 - alpha^2) a^2 and the like for Omega have the mean 0, so "
    "the mean squares are beta^2/(gamma^2 - alpha^2) and g_23^2 k^2/(2 d_33 - 2 g_13^2): the order 2 of 4.0.9 and 4.0.11.",
    states=r"2a\bar{K}_1 + \bar{K}_{11} = \beta^2 - (\gamma^2 - \alpha^2) a^2 \land "
    r"2\Omega\bar{K}_3 + \bar{K}_{33} = g_{23}^2 k^2 - (2d_{33} - 2g_{13}^2) \Omega^2",
    given=[amplitude],
    where=derivation.densities,
    uses=["3.2.4", "3.2.5"],
)

only_solution_without_flux = by_cases.ours(
    "B.9",
    83,
    words="Without flux a density of a has one logarithmic derivative lambda, so it is (3.4) but for the constant.",
    states=r"\frac{1}{2} \bar{K}_{11} \lambda + \frac{1}{2} \frac{\partial \bar{K}_{11}}{\partial a} = \bar{K}_1 \Leftrightarrow "
    r"\lambda = \frac{1}{a} + \frac{6 \kappa_1 \alpha^2 a}{\Delta_1}",
    given=[amplitude, equatorial_noise],
    where=derivation.densities,
    uses=["3.4", "3.5"],
    notation=moment_letters,
)

additive_noise_only = ours(
    "B.10",
    89,
    words="The exponent kappa_1 has no value at alpha = 0; without multiplicative noise a has Rayleigh's density, without flux.",
    states=r"\frac{1}{2} \frac{\partial}{\partial a} \left(\bar{K}_{11} a \exp(-\gamma^2 a^2/\beta^2)\right) = "
    r"\bar{K}_1 a \exp(-\gamma^2 a^2/\beta^2)",
    given=[amplitude, Hypothesis("additive noise", "there is additive noise", r"\beta > 0")],
    where=derivation.additive_noise_only,
    uses=["3.2.4", "3.2.5"],
)

multiplicative_noise_only = by_cases.ours(
    "B.11",
    95,
    words="Without additive noise (beta = 0) the formula is a power of a, and no power is integrable: no stationary density, "
    "also where the condition 4 gamma^2 > alpha^2 holds.",
    states=r"\int_0^\infty a^n \, da < \infty \Rightarrow 0 = 1",
    uses=["4.0.2"],
    notation=moment_letters,
)

mixed_average_of_full_noise = ours(
    "B.12",
    63,
    words="If the multiplicative noise xi_j acts on equation i with q_ij x_j, the averaged Kbar_12 is a/4 (q_12 q_22 - q_11 q_21): it "
    "vanishes exactly for q_11 q_21 = q_12 q_22, which diagonal noise satisfies.",
    states=r"\bar{K}_{12} = \frac{a}{4} (q_{12} q_{22} - q_{11} q_{21})",
    given=[amplitude, positive_k],
    where=derivation.mixed_average_of_full_noise,
    uses=["3.2.3"],
    notation=full_noise,
)

neglected_drift_averages_to_zero = by_cases.ours(
    "B.13",
    61,
    words="What averaging neglects in the drift: terms of the order epsilon with mean zero over a turn, which displace a, theta, "
    "Omega by the order epsilon only.",
    states=r"\langle K_1 \rangle_{\psi} = 0 \land \langle K_2 \rangle_{\psi} = 0 \land \langle K_3 \rangle_{\psi} = 0",
    given=[amplitude, positive_k],
    where=derivation.neglected_terms,
    uses=["3.2.5"],
)

tail_of_frequency = by_cases.ours(
    "B.14",
    95,
    words="Between the two conditions of 4.0.10: 3 d_33 > m g_13^2 without 2 d_33 > m g_13^2 leaves the moment infinite.",
    states=r"3d_{33} > mg_{13}^2 \land 2d_{33} \leq mg_{13}^2 \land \int_0^\infty \Omega^m \Delta_2^{\kappa_2} \, d\Omega < \infty "
    r"\Rightarrow 0 = 1",
    given=[axial_noise, positive_k, Hypothesis("order", "the order of the moment is at least 1", r"m \geq 1")],
    where=derivation.densities,
    uses=["4.0.10", "4.0.11"],
)
