"""Poloskov 2004, section 3: the Fokker-Planck-Kolmogorov (FPK) equation, its average, the stationary densities."""

from symcheck.core.claims import Damage, Erratum, Hypothesis
from symcheck.core.verdicts import Origin
from symcheck.papers.declare import Scope, by_cases, claim, definition, exclusion, ours, premise
from symcheck.papers.poloskov2004 import derivation
from symcheck.papers.poloskov2004.hypotheses import (
    abbreviations,
    amplitude,
    axial_noise,
    equatorial_noise,
    positive_k,
    positive_parameter,
)
from symcheck.papers.poloskov2004.notation import density_by_y, primitive_letters, ratio_letters
from symcheck.proof import cases, identity

averaged = Scope(where=derivation.averaged_coefficients, by=cases())
density = Scope(where=derivation.densities)

markov_process = premise(
    "3.0.1", 49, words="(a, theta, Omega) is a Markov process with the density p(a, theta, Omega, t)."
)

fpk_equation = premise(
    "3.1",
    51,
    r"\frac{\partial p}{\partial t} = \frac{1}{2} \sum_{i,j=1}^3 \frac{\partial^2}{\partial y_i \partial y_j} (K_{ij}p) "
    r"- \sum_{i=1}^3 \frac{\partial}{\partial y_i} (K_i p), \quad p(\mathbf{y}, 0) = p_0(\mathbf{y})",
    words="The FPK equation of a diffusion with drift K_i and diffusion K_ij.",
    reason="the textbook form, cited as known",
    notation=density_by_y,
)

slow_variables = premise(
    "3.1.1", 53, r"\mathbf{y} = [y_1, y_2, y_3]^T \equiv [a, \theta, \Omega]^T", words="y stands for a, theta, Omega."
)

fpk_coefficients = claim(
    "3.1.2",
    53,
    r"K_i = v_i + \frac{1}{2} \sum_{j=1}^3 \sum_{k=1}^6 \frac{\partial h_{ik}}{\partial y_j} h_{jk}, \quad "
    r"K_{ij} = \sum_{k=1}^6 h_{ik} h_{jk}",
    words="Drift and diffusion of a system in Stratonovich's sense. Time is counted from the instant considered, so that psi = y_2; "
    "a derivative by Omega through psi would add nothing (2.4.6).",
    given=[
        Hypothesis("amplitude positive", "y_1 = a > 0", "y_1 > 0", printed=False),
        positive_k,
        positive_parameter,
    ],
    where=derivation.coefficients_by_y,
    uses=["1.1.10", "2.4", "2.4.6", "3.1.1"],
)

names_of_coefficients = definition(
    "3.1.3", 55, words="K_i are the coefficients of drift, K_ij those of diffusion.", opaque=True
)

form_with_epsilon = premise(
    "3.2",
    59,
    r"\partial p / \partial t = \varepsilon \mathbf{L} p",
    words="(3.1) once more, with L = (FPK operator)/epsilon.",
)

every_coefficient_has_epsilon = by_cases.claim(
    "3.2.1",
    57,
    words="(3.1) has that form: all its coefficients are epsilon times something without epsilon.",
    states=r"\frac{\partial}{\partial \varepsilon} \left(\frac{K_i}{\varepsilon}\right) = 0 \land "
    r"\frac{\partial}{\partial \varepsilon} \left(\frac{K_{ij}}{\varepsilon}\right) = 0",
    given=[positive_parameter, amplitude, positive_k],
    where=derivation.coefficients,
    uses=["3.1.2", "3.2"],
)

averaging_needs_a_fast_phase = by_cases.claim(
    "3.2.8",
    61,
    words="The coefficients may be averaged over the time that they contain explicitly, at fixed a, theta, Omega [5]. They contain it in "
    "the phase Omega t + theta, which is to be another one at another time.",
    states=r"t \ne 0 \Rightarrow \Omega t + \theta \ne \theta",
    uses=["3.2", "3.2.9", "3.2.10"],
    errata={
        "": Erratum(
            "",
            "missing hypothesis",
            Origin.PAPER,
            "The average over time is the one over a turn of the phase, Kbar, for Omega != 0 only (3.2.9). At Omega = 0 no time is "
            "left in the coefficients, and they are their own averages, not Kbar (3.2.10); for |Omega| of the order of epsilon the phase is "
            "as slow as a, theta, Omega. The density (3.5) is largest there. That this strip may be left out in the first "
            "approximation is not said.",
            needs=(Hypothesis("phase turns", "Omega is not zero", r"\Omega \ne 0"),),
            summary=r"The average over the time is the one over a turn of the phase only for $\Omega \neq 0$; near $\Omega = 0$, "
            "where the density of the frequency is largest, the step needs a reason.",
            instead=r"the same for $\Omega \neq 0$, and a word on why $|\Omega| \sim \varepsilon$ may be left out",
        )
    },
)

average_over_time = ours(
    "3.2.9",
    61,
    words="For Omega != 0 what K_11/epsilon has besides its average over the phase is the rate of U/Omega along the time, U periodic: its "
    "average over the time is zero. (The other coefficients have such a U too, as all are polynomials in cos psi, sin psi.)",
    states=r"\Omega\frac{\partial}{\partial\psi}\left(\frac{U}{\Omega}\right) = \frac{K_{11}}{\varepsilon} - \bar{K}_{11}",
    given=[amplitude, positive_k, positive_parameter],
    where=derivation.primitive_of_diffusion,
    uses=["3.1.2", "3.2.4"],
    notation=primitive_letters,
)

no_average_at_rest = by_cases.ours(
    "3.2.10",
    61,
    words="Where the phase rests the average over the time is K_11 at that phase: for additive noise about the first axis only, and "
    "psi = 0, it is twice Kbar_11.",
    states=r"(g_{11} = 0 \land g_{12} = 0 \land g_{22} = 0 \land \sin\psi = 0) \Rightarrow K_{11} = 2\varepsilon\bar{K}_{11}",
    given=[amplitude, positive_k, positive_parameter],
    where=derivation.coefficients_and_averages,
    uses=["3.1.2", "3.2.4"],
)

averaged_equation = premise(
    "3.2.2",
    63,
    r"\frac{\partial p}{\partial t} = \varepsilon \left[ \frac{1}{2} \frac{\partial^2}{\partial a^2} (\bar{K}_{11} p) "
    r"+ \frac{1}{2} \frac{\partial^2}{\partial \theta^2} (\bar{K}_{22} p) + \frac{1}{2} \frac{\partial^2}{\partial \Omega^2} "
    r"(\bar{K}_{33} p) - \frac{\partial}{\partial a} (\bar{K}_{1p}) - \frac{\partial}{\partial \theta} (\bar{K}_{2p}) "
    r"- \frac{\partial}{\partial \Omega} (\bar{K}_{3p}) \right] \equiv \varepsilon \bar{L} p",
    words="(3.2) averaged over the time it contains explicitly.",
    damage=Damage(
        r"\frac{\partial p}{\partial t} = \varepsilon \left[ \frac{1}{2} \frac{\partial^2}{\partial a^2} (\bar{K}_{11} p) "
        r"+ \frac{1}{2} \frac{\partial^2}{\partial \theta^2} (\bar{K}_{22} p) + \frac{1}{2} \frac{\partial^2}{\partial \Omega^2} "
        r"(\bar{K}_{33} p) - \frac{\partial}{\partial a} (\bar{K}_1 p) - \frac{\partial}{\partial \theta} (\bar{K}_2 p) "
        r"- \frac{\partial}{\partial \Omega} (\bar{K}_3 p) \right] \equiv \varepsilon \bar{L} p",
        reason="Three times the factor p has slipped into the subscript. No letter with the subscript 1p exists, (3.1) and the "
        "stationary equations have the product, and so have the second derivatives of the same display; a thin space lost "
        "three times alike is what the OCR does to subscripts. That averaging is admissible is cited [5].",
        kind="letter in the index",
    ),
)

averaged_mixed_coefficients_vanish = by_cases.claim(
    "3.2.3",
    63,
    words="No mixed derivative is left: the averages of K_12, K_13, K_23 vanish.",
    states=r"\bar{K}_{12} = 0 \land \bar{K}_{13} = 0 \land \bar{K}_{23} = 0 \land \bar{K}_{21} = 0 \land \bar{K}_{31} = 0 "
    r"\land \bar{K}_{32} = 0",
    given=[amplitude],
    where=derivation.averages,
    uses=["3.1.2", "3.2.2"],
)

averaged_diffusion = claim(
    "3.2.4",
    65,
    r"\bar{K}_{11} = \frac{3}{8} a^2 \alpha^2 + \frac{1}{2} \beta^2, \quad \bar{K}_{22} = \frac{1}{8} \alpha^2 "
    r"+ \frac{1}{2a^2} \beta^2, \quad \bar{K}_{33} = g_{13}^2 \Omega^2 + g_{23}^2 k^2",
    words="Diffusion averaged over the phase, without the factor epsilon that stands before the bracket.",
    given=[abbreviations, amplitude],
    where=derivation.averages,
    uses=["3.1.2", "3.2.2", "3.2.6"],
)

averaged_drift = claim(
    "3.2.5",
    67,
    r"\bar{K}_1 = -\frac{a}{2} \gamma^2 + \frac{5}{16} a \alpha^2 + \frac{1}{4a} \beta^2, \quad \bar{K}_2 = \frac{1}{2} "
    r"(-d_{12} + d_{21}), \quad \bar{K}_3 = \left( -d_{33} + \frac{1}{2} g_{13}^2 \right) \Omega",
    words="Drift averaged over the phase.",
    given=[abbreviations, amplitude, positive_k],
    where=derivation.averages,
    uses=["3.1.2", "3.2.2", "3.2.6"],
)

abbreviated_sums = premise(
    "3.2.6",
    69,
    r"\alpha^2 = g_{11}^2 + g_{12}^2, \quad \beta^2 = g_{21}^2 + g_{22}^2, \quad \gamma^2 = d_{11} + d_{22}",
    words="Abbreviations; they make sense because D has positive elements.",
)

carried_out_averages = by_cases.ours(
    "3.2.7",
    67,
    words="The averages as the following items use them, carried out.",
    states=r"\langle K_1 \rangle_{\psi} = \varepsilon \bar{K}_1 \land \langle K_2 \rangle_{\psi} = \varepsilon \bar{K}_2 \land "
    r"\langle K_3 \rangle_{\psi} = \varepsilon \bar{K}_3 \land \langle K_{11} \rangle_{\psi} = \varepsilon \bar{K}_{11} \land "
    r"\langle K_{22} \rangle_{\psi} = \varepsilon \bar{K}_{22} \land \langle K_{33} \rangle_{\psi} = \varepsilon \bar{K}_{33}",
    given=[amplitude, positive_k],
    where=derivation.coefficients_and_averages,
    uses=["3.2.4", "3.2.5"],
)

stationary_equation = premise(
    "3.3", 73, r"\bar{L} p_s = 0", words="Equation of the stationary density, looked for in the first approximation."
)

coefficients_do_not_depend_on_phase = averaged.claim(
    "3.3.1",
    75,
    words="The coefficients of (3.3) do not depend on theta.",
    states=r"\frac{\partial \bar{K}_1}{\partial \theta} = 0 \land \frac{\partial \bar{K}_2}{\partial \theta} = 0 \land "
    r"\frac{\partial \bar{K}_3}{\partial \theta} = 0 \land \frac{\partial \bar{K}_{11}}{\partial \theta} = 0 \land "
    r"\frac{\partial \bar{K}_{22}}{\partial \theta} = 0 \land \frac{\partial \bar{K}_{33}}{\partial \theta} = 0",
    given=[amplitude],
    uses=["3.2.4", "3.2.5"],
)

coefficients_of_amplitude = averaged.claim(
    "3.3.2",
    75,
    (r"\bar{K}_{11} = \bar{K}_{11}(a)", r"\bar{K}_1 = \bar{K}_1(a)"),
    words="Kbar_11 and Kbar_1 depend on a only.",
    states=r"\frac{\partial \bar{K}_{11}}{\partial \theta} = 0 \land \frac{\partial \bar{K}_{11}}{\partial \Omega} = 0 \land "
    r"\frac{\partial \bar{K}_1}{\partial \theta} = 0 \land \frac{\partial \bar{K}_1}{\partial \Omega} = 0",
    given=[amplitude],
    uses=["3.2.4", "3.2.5"],
)

coefficients_of_frequency = averaged.claim(
    "3.3.3",
    75,
    (r"\bar{K}_{33} = \bar{K}_{33}(\Omega)", r"\bar{K}_3 = \bar{K}_3(\Omega)"),
    words="Kbar_33 and Kbar_3 depend on Omega only.",
    states=r"\frac{\partial \bar{K}_{33}}{\partial \theta} = 0 \land \frac{\partial \bar{K}_{33}}{\partial a} = 0 \land "
    r"\frac{\partial \bar{K}_3}{\partial \theta} = 0 \land \frac{\partial \bar{K}_3}{\partial a} = 0",
    uses=["3.2.4", "3.2.5"],
)

product_of_densities = density.claim(
    "3.3.4",
    77,
    r"p_s(a, \theta, \Omega) = p_{s1}(a) p_{s2}(\theta) p_{s3}(\Omega)",
    words="The product of the densities (3.4), uniform, (3.5) solves (3.3).",
    states=r"\frac{1}{2} \frac{\partial^2}{\partial a^2} (\bar{K}_{11} p_s) + \frac{1}{2} \frac{\partial^2}{\partial \theta^2} "
    r"(\bar{K}_{22} p_s) + \frac{1}{2} \frac{\partial^2}{\partial \Omega^2} (\bar{K}_{33} p_s) - \frac{\partial}{\partial a} "
    r"(\bar{K}_1 p_s) - \frac{\partial}{\partial \theta} (\bar{K}_2 p_s) - \frac{\partial}{\partial \Omega} (\bar{K}_3 p_s) = 0",
    given=[amplitude, equatorial_noise, axial_noise, positive_k],
    uses=["3.2.2", "3.3", "3.3.9", "3.4", "3.5"],
)


def _averaged_operator(density: str) -> str:
    """(3.3) without epsilon, applied to a density."""
    diffusion = ((r"a", "11"), (r"\theta", "22"), (r"\Omega", "33"))
    second = (
        rf"\frac{{1}}{{2}} \frac{{\partial^2}}{{\partial {y}^2}} (\bar{{K}}_{{{i}}} {density})" for y, i in diffusion
    )
    first = (rf"\frac{{\partial}}{{\partial {y}}} (\bar{{K}}_{i[0]} {density})" for y, i in diffusion)
    return f"{' + '.join(second)} - {' - '.join(first)}"


product_is_the_only_solution = density.claim(
    "3.3.5",
    75,
    words="If a stationary density exists it must be this product. For a density q p_s the equation (3.3) gives (a): L(q^2 p_s) - 2 q L(q p_s) is "
    "p_s times a sum of squares of the derivatives of q, with coefficients (b) that are positive. Where q p_s solves (3.3), L(q^2 p_s) is "
    "left, a divergence: its integral over all a, theta, Omega is zero if q^2 p_s carries nothing through the ends, so that q is "
    "constant. (Kbar_22, which depends on a too, and of which the paper says nothing, does no harm: p_s does not depend on theta.)",
    states=(
        rf"{_averaged_operator('q^2 p_s')} - 2\left[{_averaged_operator('q p_s')}\right] \cdot q = "
        r"\left(\left(\frac{\partial q}{\partial a}\right)^2 \bar{K}_{11} + "
        r"\left(\frac{\partial q}{\partial \theta}\right)^2 \bar{K}_{22} + "
        r"\left(\frac{\partial q}{\partial \Omega}\right)^2 \bar{K}_{33}\right) \cdot p_s",
        r"\bar{K}_{11} > 0 \land \bar{K}_{22} > 0 \land \bar{K}_{33} > 0",
    ),
    given=[amplitude, equatorial_noise, axial_noise, positive_k],
    by={"a": identity, "b": cases()},
    uses=["3.3.4", "3.3.10"],
    notation=ratio_letters,
)

interval_of_phase = exclusion("3.3.6", 79, r"[0, 2\pi]", reason="names the range of theta, see 3.3.8")

uniform_phase = density.by_cases.claim(
    "3.3.7",
    79,
    r"p_{s2}(\theta) = 1/2\pi",
    words="The phase is uniform: the constant density on a turn has integral 1.",
    states=r"\int_0^{2\pi} p_{s2} \, d\theta = 1 \land p_{s2}(\theta) = 1/2\pi",
    uses=["3.3.1"],
)

range_of_phase = premise("3.3.8", 79, r"\theta \in [0, 2\pi]", words="The phase is taken on one turn.")

stationary_marginal_equations = density.claim(
    "3.3.9",
    81,
    r"\frac{1}{2} (\bar{K}_{11} p_{s1})''_{aa} - (\bar{K}_1 p_{s1})'_a = 0, \quad "
    r"\frac{1}{2} (\bar{K}_{33} p_{s3})''_{\Omega\Omega} - (\bar{K}_3 p_{s3})'_\Omega = 0",
    words="The densities (3.4), (3.5) satisfy the equations of the marginal densities.",
    given=[amplitude, equatorial_noise, axial_noise, positive_k],
    uses=["3.3", "3.3.2", "3.3.3", "3.4", "3.5"],
)

no_flux = density.by_cases.ours(
    "3.3.10",
    81,
    words="They carry no flux: the first integral of either equation vanishes.",
    states=r"\frac{1}{2} (\bar{K}_{11} p_{s1})'_a = \bar{K}_1 p_{s1} \land "
    r"\frac{1}{2} (\bar{K}_{33} p_{s3})'_\Omega = \bar{K}_3 p_{s3}",
    given=[amplitude, equatorial_noise, axial_noise, positive_k],
    uses=["3.3.9"],
)

flux_is_excluded = premise(
    "3.3.11",
    83,
    words="Of the solutions of the two equations those with a flux are left out.",
    reason="the paper passes from the equations to the formulas without a word; a density with a flux would not be "
    "non-negative and integrable on the whole half-axis (axis)",
)

density_of_amplitude = density.claim(
    "3.4",
    85,
    r"p_{s1}(a) = 8C_1 a \Delta_1^{\kappa_1}",
    words="The derived density without flux; C_1 is named such that 8 C_1 is its constant.",
    given=[amplitude, equatorial_noise],
    uses=["3.2.4", "3.2.5", "3.5"],
)

range_of_amplitude = premise("3.4.1", 85, r"a \geq 0", words="Range of the amplitude.")

density_of_frequency = density.claim(
    "3.4.2",
    87,
    r"p_{s3}(\Omega) = C_2 \Delta_2^{\kappa_2}",
    words="The derived density without flux.",
    given=[axial_noise, positive_k],
    uses=["3.2.4", "3.2.5", "3.5.1"],
)

exponent_of_amplitude = claim(
    "3.5",
    89,
    r"\Delta_1 = 3\alpha^2 a^2 + 4\beta^2, \quad \kappa_1 = -4\gamma^2/3\alpha^2 - 2/3",
    given=[equatorial_noise],
    where=derivation.exponents,
    uses=["3.2.4", "3.2.5"],
)

exponent_of_frequency = claim(
    "3.5.1",
    91,
    r"\Delta_2 = g_{13}^2 \Omega^2 + g_{23}^2 k^2, \quad \kappa_2 = -d_{33}/g_{13}^2 - 1/2",
    given=[axial_noise],
    where=derivation.exponents,
    uses=["3.2.4", "3.2.5"],
)

constants_of_normalisation = definition(
    "3.5.2", 93, words="C_1, C_2 make the integrals of the densities 1.", opaque=True
)
