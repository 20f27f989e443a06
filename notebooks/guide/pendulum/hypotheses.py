"""Conditions, each stated once."""

from symcheck.core.claims import Hypothesis

body = Hypothesis(
    "body", "the body has mass and extent, and hangs off its centre", r"m > 0, a > 0, I_c > 0", printed=False
)
gyration = Hypothesis("gyration", "r is the radius of gyration", r"I_c = m r^2")
positive_radius = Hypothesis("radius positive", "a radius of gyration is positive", r"r > 0", printed=False)
pulled = Hypothesis(
    "pulled", "mass and gravity are positive, the force is not negative", r"m > 0, g > 0, F \ge 0", printed=False
)
