"""What the relations of Poloskov 2004 are read under without its being printed, and what holds at the ends and outside.

A relation whose proof needs one of these conditions is marked by it.
"""

from __future__ import annotations

from symcheck.core.claims import Hypothesis
from symcheck.papers.declare import by_cases, ours, standing
from symcheck.papers.poloskov2004 import derivation
from symcheck.papers.poloskov2004.hypotheses import (
    amplitude,
    axial_noise,
    body_has_mass,
    constants,
    equatorial_noise,
    positive_k,
)
from symcheck.papers.poloskov2004.notation import constant_letters

mass = standing("S.1", 15, body_has_mass, "In (1.1): {}.", reason="not printed; k has a zero below it")

amplitude_is_positive = standing(
    "S.2", 31, amplitude, "Where a relation needs it: {}. Line 85 prints a >= 0.", without="S.6, S.7, S.8"
)

noise_about_the_equatorial_axes = standing(
    "S.3",
    69,
    equatorial_noise,
    "In section 3 from (3.3) on, and in section 4: {}.",
    without="S.9, S.10, B.10, B.11; their signs do not matter, as only squares are used",
)

noise_about_the_polar_axis = standing(
    "S.4",
    69,
    axial_noise,
    "There too: {}.",
    without="S.11 to S.13; their signs do not matter, as only squares are used",
)

positive_constants = standing(
    "S.5",
    93,
    constants,
    "Where a density rises and falls: {}.",
    reason="not printed; the constants make the integrals 1 (3.5.2), of functions that are not negative",
)

# --- the amplitude

no_amplitude = by_cases.ours(
    "S.6",
    33,
    words="At a = 0 the body turns about its polar axis, whatever psi: there is no phase, and relations for theta have no value.",
    states=r"a = 0 \Rightarrow (x_1 = 0 \land x_2 = 0)",
    given=[positive_k],
    where=derivation.change_of_variables,
    uses=["2.2"],
)

density_at_no_amplitude = by_cases.ours(
    "S.7",
    85,
    words="(3.4) holds at the end a = 0, where the density is zero.",
    states=r"a = 0 \Rightarrow p_{s1} = 0",
    given=[equatorial_noise],
    where=derivation.densities,
    uses=["3.4"],
)

negative_amplitude = by_cases.ours(
    "S.8",
    33,
    words="A negative a with the phase psi is the motion with -a and psi + pi: every motion has an a that is not negative.",
    states=r"(-a) \cos(\psi + \pi) = a\cos\psi \land -(-a)\sin(\psi + \pi) = -a\sin\psi",
    uses=["2.2"],
)

# --- the noises

no_equatorial_noise = by_cases.ours(
    "S.9",
    65,
    words="Without both noises about the equatorial axes a only decays: there is no stationary density. With one of them see B.10 (a has "
    "Rayleigh's density) and B.11 (no density).",
    states=r"(\alpha = 0 \land \beta = 0) \Rightarrow (\bar{K}_{11} = 0 \land \bar{K}_1 = -\frac{a}{2}\gamma^2)",
    given=[amplitude],
    where=derivation.shortened_averages,
    uses=["3.2.4", "3.2.5"],
)

no_additive_noise = by_cases.ours(
    "S.10",
    65,
    words="Without the additive one Kbar_11 vanishes with a, and Kbar_22 no longer grows without bound there.",
    states=r"\beta = 0 \Rightarrow (\bar{K}_{11} = \frac{3}{8} a^2 \alpha^2 \land \bar{K}_{22} = \frac{1}{8} \alpha^2)",
    given=[amplitude],
    where=derivation.shortened_averages,
    uses=["3.2.4"],
)

no_axial_noise = by_cases.ours(
    "S.11",
    65,
    words="Without both noises about the polar axis Omega only decays: there is no stationary density.",
    states=r"(g_{13} = 0 \land g_{23} = 0) \Rightarrow (\bar{K}_{33} = 0 \land \bar{K}_3 = -d_{33}\Omega)",
    where=derivation.shortened_averages,
    uses=["3.2.4", "3.2.5"],
)

additive_axial_noise_only = ours(
    "S.12",
    91,
    words="The exponent kappa_2 has no value at g_13 = 0; without multiplicative noise about the polar axis Omega has a normal density, "
    "without flux.",
    states=r"\frac{1}{2} \frac{\partial}{\partial \Omega} \left(\bar{K}_{33} \exp(-d_{33} \Omega^2/(g_{23}^2 k^2))\right) = "
    r"\bar{K}_3 \exp(-d_{33} \Omega^2/(g_{23}^2 k^2))",
    given=[positive_k, Hypothesis("additive noise", "there is additive noise about the polar axis", "g_{23} > 0")],
    where=derivation.additive_axial_noise_only,
    uses=["3.2.4", "3.2.5"],
    notation=constant_letters,
)

multiplicative_axial_noise_only = by_cases.ours(
    "S.13",
    91,
    words="Without additive noise about the polar axis Delta_2 is a square of Omega, and no power of it is integrable from 0 to "
    "infinity (B.11): no stationary density.",
    states=r"g_{23} = 0 \Rightarrow \Delta_2 = g_{13}^2 \Omega^2",
    where=derivation.exponents,
    uses=["3.5.1", "B.11"],
)
