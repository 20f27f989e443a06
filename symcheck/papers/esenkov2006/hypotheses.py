"""Conditions the relations are read under, each stated once. None is printed in what is left of the two texts."""

from symcheck.core.claims import Hypothesis

body_has_mass = Hypothesis("body has mass", "A is positive", "A > 0", printed=False)
spinning = Hypothesis("spinning", "the body spins", r"\omega_0 \ne 0", printed=False)
liquid_moves = Hypothesis("liquid moves", "the mode carries some inertia", "E_n > 0", printed=False)
liquid_is_part = Hypothesis(
    "liquid is a part",
    "A is the moment of the body with the liquid at rest in it, so that a mode carries less than A",
    "E_n < A",
    printed=False,
)
roots_are_real_numbers = Hypothesis(
    "real square roots",
    "the square roots of (1.35) are of numbers that are not negative",
    r"0 \le b_n \le 1",
    printed=False,
)
