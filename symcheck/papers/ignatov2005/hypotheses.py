"""What both sections share: the conditions their relations are read under, and how they are read."""

from __future__ import annotations

from symcheck.core.claims import Damage, Hypothesis

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

# the same of the angles themselves, where their values matter
acute_a = Hypothesis("a acute", "a is an acute angle", r"0 < a < \pi/2", printed=False)
acute_b = Hypothesis("b acute", "b is an acute angle (line 71)", r"0 < b < \pi/2")

WITHIN_LIMITS = r"-1 \leq h_i \leq 1"  # the wheels in units of h_max
SPACECRAFT_MOMENTS = Hypothesis("spacecraft", "the moments of inertia of line 248", "J_x = 1000, J_y = 1600, J_z = 800")
MASS = Hypothesis("moments positive", "the body has mass", "J_x > 0, J_y > 0, J_z > 0", printed=False)
RATES = Hypothesis("rates", "(2.3)", r"w_x = -\frac{H_x}{J_x}, w_y = -\frac{H_y}{J_y}, w_z = -\frac{H_z}{J_z}")


def lost_pi(read_as: str, links: str = "") -> Damage:
    """How a printed p is read, and why; in which links it stands, if not in all."""
    return Damage(
        read_as,
        "p stands for pi throughout the prose and table 2, as 45 degrees beside p/4 shows: the Greek letter was set in a "
        "font of symbols, where p is its place, and the digital text lost the font.",
        kind="lost letter",
        links=links,
    )


def rhombi(pairs: tuple[tuple[int, int], ...]) -> tuple[str, ...]:
    """Two axes of equal length that are not parallel, for each pair: a face is a rhombus."""
    return tuple(
        rf"(\mathbf{{e}}_{i}, \mathbf{{e}}_{i}) = (\mathbf{{e}}_{j}, \mathbf{{e}}_{j}) \land "
        rf"(\mathbf{{e}}_{i} \times \mathbf{{e}}_{j}, \mathbf{{e}}_{i} \times \mathbf{{e}}_{j}) \ne 0"
        for i, j in pairs
    )
