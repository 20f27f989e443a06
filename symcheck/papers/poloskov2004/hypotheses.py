"""Conditions the paper's relations are read under, each stated once."""

from symcheck.core.claims import Hypothesis

positive_parameter = Hypothesis("epsilon positive", "epsilon is positive (line 21)", r"\varepsilon > 0")
positive_k = Hypothesis("k positive", "A > C: k is positive (line 15)", "k > 0")
body_has_mass = Hypothesis("moments positive", "moments of inertia are positive", "A > 0, B > 0, C > 0", printed=False)
amplitude = Hypothesis("amplitude positive", "a > 0: where a = 0 there is no phase", "a > 0", printed=False)
abbreviations = Hypothesis(
    "abbreviations",
    "alpha^2, beta^2, gamma^2 of line 69",
    r"\alpha^2 = g_{11}^2 + g_{12}^2, \beta^2 = g_{21}^2 + g_{22}^2, \gamma^2 = d_{11} + d_{22}",
)
equatorial_noise = Hypothesis(
    "equatorial noise",
    "both noises act on the equatorial axes: alpha and beta are positive",
    r"\alpha > 0, \beta > 0",
    printed=False,
)
axial_noise = Hypothesis(
    "axial noise",
    "both noises act on the polar axis: g_13 and g_23 are positive",
    "g_{13} > 0, g_{23} > 0",
    printed=False,
)
dissipation = Hypothesis("dissipation", "D has positive elements (line 21)", r"\gamma > 0, d_{33} > 0")
order = Hypothesis("order", "the order of the moment is at least 1", r"m \geq 1")
constants = Hypothesis("constants positive", "a density is not negative", "C_1 > 0, C_2 > 0", printed=False)
amplitude_density_exists = Hypothesis(
    "density of a exists", "the condition of existence (line 95)", r"4\gamma^2 > \alpha^2"
)
