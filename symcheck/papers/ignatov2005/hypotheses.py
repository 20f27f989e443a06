"""Conditions the paper's relations are read under, each stated once."""

from symcheck.statement import Hypothesis

real_pyramid = Hypothesis(
    "0 < a < 90 degrees",
    "the wheels are neither all along OZ nor all across it: 0 < a < 90 degrees",
    r"\sin a > 0, \cos a > 0",
    printed=False,
)
real_base = Hypothesis(
    "0 < b < 90 degrees",
    "the base of the pyramid is a rectangle, not a segment: 0 < b < 90 degrees (line 71)",
    r"\sin b > 0, \cos b > 0",
)
