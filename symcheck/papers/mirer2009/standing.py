"""What the relations of Mirer 2009 are read under without its being printed, and what holds at the ends and outside.

A relation whose proof needs one of these conditions is marked by it.
"""

from __future__ import annotations

from symcheck.core.claims import Hypothesis
from symcheck.papers.declare import by_cases, ours, premise, standing
from symcheck.papers.mirer2009 import derivation
from symcheck.papers.mirer2009.hypotheses import (
    mass_distribution,
    non_negative_moments,
    positive_axial_moments,
    positive_mean,
    positive_moments,
    positive_ratio,
    semi_axes,
)
from symcheck.papers.mirer2009.notation import ellipsoid_letters
from symcheck.papers.mirer2009.scopes import in_moments
from symcheck.papers.mirer2009.sec1 import triple_root
from symcheck.papers.mirer2009.sec2 import on_the_interval
from symcheck.proof import cases, nonnegative

non_negative = standing(
    "S.1",
    149,
    non_negative_moments,
    "In the inequalities (2.1), (2.2), (2.10), (2.18): {}.",
    without="it follows from the triangle inequalities 2.2.4 (S.7), which every body satisfies",
)

positive = standing(
    "S.2", 149, positive_moments, "Where it is said when equality holds, and in (1.6) to (1.8): {}.", without="S.8, S.9"
)

damping = standing("S.3", 119, positive_ratio, "In (1.6) to (1.8): {}.", without="S.10, S.11")

axial = standing(
    "S.4", 113, positive_axial_moments, "There too: {}.", reason="not printed, but it follows from S.2 (2.0.6)"
)

mean = standing("S.5", 189, positive_mean, "Where f_1 is maximised: {}.", without="S.12")

ellipsoid = premise(
    "S.6",
    284,
    words=f"{semi_axes.words.capitalize()}, and so is the distance d.",
    states=semi_axes.states,
    reason="not printed; they are lengths, and the relations divide by their squares",
    notation=ellipsoid_letters,
)

triangle = Hypothesis(
    "triangle inequalities",
    "the triangle inequalities 2.2.4",
    r"I_2 + I_3 \ge I_1, I_3 + I_1 \ge I_2, I_1 + I_2 \ge I_3",
)

moments_of_a_body_are_not_negative = tuple(
    ours(
        f"S.7.{i}",
        149,
        words=f"I_{i} is not negative: the triangle inequalities for the other two moments, added.",
        states=rf"I_{i} \ge 0",
        given=[triangle],
        by=nonnegative(rf"\frac{{1}}{{2}}(I_{i} + I_{j} - I_{k}) + \frac{{1}}{{2}}(I_{k} + I_{i} - I_{j})"),
        equality=rf"I_{i} + I_{j} = I_{k}, I_{k} + I_{i} = I_{j}",
        uses=["2.2.4"],
    )
    for i, j, k in ((1, 2, 3), (2, 3, 1), (3, 1, 2))
)

mass_on_a_line = by_cases.ours(
    "S.8",
    149,
    words="At the end I_1 = 0 all mass is on a line, so that I_2 = I_3 (a): pairwise distinct moments of a body are positive. And (2.10) is "
    "an equality, 0 = 0, as soon as an axis y_i lies along the line (b), so that the six cases (2.17) are not all there.",
    states=(
        r"I_1 = 0 \Rightarrow I_2 = I_3",
        r"(I_1 = 0 \land a_{21} = 1 \land a_{22} = 0 \land a_{23} = 0) \Rightarrow J_1 J_2 J_3 = I_1 I_2 I_3",
    ),
    given=[mass_distribution],
    where=derivation.moments_of_a_mass_distribution,
    uses=["2.10", "2.17"],
)

no_third_root = in_moments.by_cases.ours(
    "S.9",
    125,
    words="There (1.5) is of second degree; the relations 1.5.4 to 1.5.6 still give (1.6) and (1.7), all zero, but not (1.8).",
    states=r"I_1 = 0 \Rightarrow (J_1 J_2 J_3 = I_1 I_2 I_3 \land J_1 L_1 + J_2 L_2 + J_3 L_3 = 3I_1 I_2 I_3)",
    given=[triple_root, Hypothesis("gain", "k is not zero", r"k \ne 0")],
    uses=["1.6", "1.7"],
)

negative_gain = in_moments.by_cases.ours(
    "S.10",
    119,
    words="With a negative gain ratio (1.6) to (1.8) hold too, though nothing is damped: the proof needs k != 0 only.",
    states=r"J_1 J_2 J_3 = I_1 I_2 I_3 \land J_1 L_1 + J_2 L_2 + J_3 L_3 = 3I_1 I_2 I_3 \land k = \xi",
    given=[
        triple_root,
        Hypothesis("gain", "k is not zero", r"k \ne 0"),
        positive_moments,
        positive_axial_moments,
    ],
    uses=["1.6", "1.7", "1.8"],
)

no_gain = in_moments.by_cases.ours(
    "S.11",
    119,
    words="Without gain, k = 0, the three relations say xi = 0, whatever the axes: (1.8) holds, (1.6) and (1.7) need not.",
    states=rf"k = 0 \Rightarrow (\xi = 0 \Leftrightarrow ({triple_root.states}))",
    given=[positive_moments],
    uses=["1.5.4", "1.5.5", "1.5.6"],
)

no_mass = ours(
    "S.12",
    189,
    words="At c = 0 the interval of f_1 is the one point 0 = c, with the value 0 = c^3; below that it is empty.",
    states=(r"c = 0 \land J_2 = 0 \Rightarrow (J_2 = c \land f_1 = c^3)", r"c \ge 0"),
    given=[on_the_interval],
    keeping=("J", "c"),
    by={"a": cases(), "b": nonnegative(r"\frac{2}{3}((3c/2 - J_2) + J_2)")},
    equality={"b": r"c = 0"},
    uses=["2.3.6"],
)
