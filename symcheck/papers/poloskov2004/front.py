"""Poloskov 2004, title page, abstract and references."""

from symcheck.papers.declare import exclusion

abstract = exclusion(
    "0.1",
    9,
    words="A dynamically symmetric body turns about a fixed point under a small dissipative torque and random ones, additive "
    "and multiplicative; the stationary density is found by averaging.",
    reason="says what the paper does; the statements follow",
)

references = exclusion("0.2", 113, words="References.", reason="six titles")
