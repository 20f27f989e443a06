"""Beyond Mirer 2009: the optimality the paper supposes, and the family of equal-moment axes it leaves out."""

from symcheck.core.claims import Hypothesis
from symcheck.papers.declare import by_cases, ours
from symcheck.papers.mirer2009 import derivation
from symcheck.papers.mirer2009.hypotheses import (
    first_axis,
    length,
    orthogonal,
    positive_moments,
    positive_ratio,
    symmetric_damping,
)
from symcheck.papers.mirer2009.notation import family_letters, optimum_letters
from symcheck.papers.mirer2009.scopes import equal_moments, in_moments, second_axis
from symcheck.proof import cases, nonnegative

roots_are_real = ours(
    "B.1",
    125,
    words="If (I p + m) z = 0 with p = sigma + i tau and z = x + i y, then tau (x^T I x + y^T I y) = 0.",
    states=r"\sum_{i=1}^3 x_i v_i - \sum_{i=1}^3 y_i u_i = \tau \sum_{i=1}^3 I_i (x_i^2 + y_i^2)",
    given=[symmetric_damping],
    where=derivation.eigenvector_residual,
    keeping=("m",),
    notation=optimum_letters,
)

imaginary_part_vanishes = ours(
    "B.2",
    125,
    words="Hence every root of (1.5) is real.",
    states=r"(\tau \sum_{i=1}^3 I_i (x_i^2 + y_i^2) = 0 \land \sum_{i=1}^3 (x_i^2 + y_i^2) = 1) \Rightarrow \tau = 0",
    given=[positive_moments],
    by=cases(r"\sum_{i=1}^3 I_i (x_i^2 + y_i^2)"),
    uses=["B.1"],
    notation=optimum_letters,
)

harmonic_mean_of_rates = in_moments.by_cases.ours(
    "B.3",
    125,
    words="The harmonic mean of the three damping rates lambda_i (roots -lambda_i of (1.5)) is k, whatever the axes.",
    states=r"\frac{1}{\lambda_1} + \frac{1}{\lambda_2} + \frac{1}{\lambda_3} = \frac{3}{k}",
    given=[
        Hypothesis(
            "rates",
            "-lambda_1, -lambda_2, -lambda_3 are the roots of (1.5)",
            r"I_1 I_2 I_3 \lambda_1 \lambda_2 \lambda_3 = k^3 J_1 J_2 J_3, "
            r"I_1 I_2 I_3 (\lambda_1 \lambda_2 + \lambda_2 \lambda_3 + \lambda_3 \lambda_1) = 3 k^2 J_1 J_2 J_3",
        ),
        Hypothesis("rates non-zero", "no root is zero", r"\lambda_1 \ne 0, \lambda_2 \ne 0, \lambda_3 \ne 0"),
        positive_ratio,
        positive_moments,
    ],
    uses=["1.5"],
    notation=optimum_letters,
)

stability_degree_at_most_gain = ours(
    "B.4",
    125,
    words="So for gains k_i = k J_i the stability degree xi, the least rate, is at most k; it is k only at the triple root.",
    states=r"\xi \le k",
    given=[
        Hypothesis(
            "least rate",
            "the rates are xi, the least, and xi + s_i",
            r"\xi > 0, s_1 \ge 0, s_2 \ge 0, s_3 \ge 0",
        )
    ],
    where=derivation.gain_from_rates,
    by=nonnegative(
        r"\frac{(\xi + s_1)(\xi + s_2) s_3 + (\xi + s_2)(\xi + s_3) s_1 + (\xi + s_3)(\xi + s_1) s_2}"
        r"{(\xi + s_1)(\xi + s_2) + (\xi + s_2)(\xi + s_3) + (\xi + s_3)(\xi + s_1)}"
    ),
    equality=r"s_1 = 0, s_2 = 0, s_3 = 0",
    uses=["B.2", "B.3"],
    notation=optimum_letters,
)

DISCRIMINANT = r"((u^2 - v^2) d_1 d_2 d_3 + 2 u v W)"
EQUAL_MOMENTS = "(J_1 = c, J_2 = c, J_3 = c)"
deviations = Hypothesis("deviations", "the moments are c + d_i with mean c", "d_1 + d_2 + d_3 = 0")
two_axes = Hypothesis(
    "two axes",
    "e_1 and e_2 are orthonormal",
    r"(\mathbf{e}_1, \mathbf{e}_1) = 1, (\mathbf{e}_1, \mathbf{e}_2) = 0, (\mathbf{e}_2, \mathbf{e}_2) = 1",
)
first_axis_on_the_cone = Hypothesis("first moment is the mean", "the first axis is on the cone J_1 = c", "J_1 = c")

unit_axes = Hypothesis("unit axes", "e_1, e_2, e_3 are unit vectors", r"(\mathbf{e}_i, \mathbf{e}_i) = 1")

squares_of_equal_moment_axes = by_cases.ours(
    "B.5",
    225,
    words="About each axis of an equal-moment triple a_ij^2 - 1/3 is proportional to (I_2 - I_3, I_3 - I_1, I_1 - I_2).",
    states=r"(a_{i1}^2 - 1/3)(I_3 - I_1) = (a_{i2}^2 - 1/3)(I_2 - I_3), "
    r"(a_{i2}^2 - 1/3)(I_1 - I_2) = (a_{i3}^2 - 1/3)(I_3 - I_1), "
    r"(a_{i3}^2 - 1/3)(I_2 - I_3) = (a_{i1}^2 - 1/3)(I_1 - I_2)",
    given=[unit_axes, Hypothesis("equal moments", "J_1 = J_2 = J_3 = c", EQUAL_MOMENTS)],
    uses=["2.4"],
)

parameter_of_the_first_axis = by_cases.ours(
    "B.6",
    225,
    words="Conversely an axis with squares 1/3 + t (I_2 - I_3), 1/3 + t (I_3 - I_1), 1/3 + t (I_1 - I_2) is a unit vector and has "
    "the moment c, for every t that makes them non-negative.",
    states=r"(a_{11}^2 = 1/3 + t(I_2 - I_3), a_{12}^2 = 1/3 + t(I_3 - I_1), a_{13}^2 = 1/3 + t(I_1 - I_2)) \Rightarrow "
    r"(a_{11}^2 + a_{12}^2 + a_{13}^2 = 1, J_1 = c)",
    uses=["B.5"],
    notation=family_letters,
)

plane_across_the_first_axis = second_axis.ours(
    "B.7",
    225,
    words="With g_i = d_i a_1i and h = e_1 x g, both across e_1, the second axis is G e_2 = u g + v h.",
    states=r"G a_{2i} = u g_i + v h_i",
    given=[two_axes, first_axis_on_the_cone, deviations],
)

second_moment_in_the_plane = second_axis.ours(
    "B.8",
    225,
    words="Its moment is G^2 (J_2 - c) = (u^2 - v^2) d_1 d_2 d_3 + 2 u v W.",
    states=rf"G^2 (J_2 - c) = {DISCRIMINANT}",
    given=[two_axes, first_axis_on_the_cone, deviations],
    uses=["B.7"],
)

no_moment_is_the_mean = Hypothesis(
    "no moment is the mean", "no principal moment equals the mean c", r"d_1 \neq 0, d_2 \neq 0, d_3 \neq 0"
)

plane_never_degenerates = second_axis.ours(
    "B.9",
    225,
    words="If no principal moment is the mean, g never vanishes, so that u and v are components along true directions.",
    states=r"G \neq 0",
    given=[orthogonal, no_moment_is_the_mean],
    by=cases(r"d_1^2 a_{11}^2 + d_2^2 a_{12}^2 + d_3^2 a_{13}^2"),
    uses=["B.7"],
)

family_is_complete = by_cases.ours(
    "B.10",
    225,
    words="If no principal moment is the mean, the triples with equal moments are exactly those with e_1 on the cone and "
    "tan 2 theta = -d_1 d_2 d_3 / W for the angle theta of e_2 in the plane of g and h: for each e_1 four turns of one triple.",
    states=rf"(J_2 = c \land J_3 = c) \Leftrightarrow {DISCRIMINANT} = 0",
    given=[
        first_axis_on_the_cone,
        Hypothesis("trace", "relation 2.1.7", r"J_1 + J_2 + J_3 = 3c"),
        Hypothesis("second moment", "relation B.8", second_moment_in_the_plane.statement.states[0]),
        Hypothesis("plane", "relation B.9", plane_never_degenerates.statement.states[0]),
    ],
    keeping=("J", "c"),
    uses=["2.1.7", "B.8", "B.9"],
    notation=family_letters,
)

circle = Hypothesis("circle", "u and v are a cosine and a sine", "u^2 + v^2 = 1")

closed_form_is_orthonormal = equal_moments.by_cases.ours(
    "B.11",
    225,
    words="The closed form: e_1 as in B.6, e_2 = (u g + v h)/r with u^2 + v^2 = 1 and r^2 = G, e_3 = e_1 x e_2, are orthonormal and "
    "right-handed.",
    states=r"\mathbf{A}\mathbf{A}^T = \mathbf{U} \land |\mathbf{A}| = 1",
    given=[first_axis, circle, length],
    uses=["B.6"],
)

closed_form_of_the_family = equal_moments.by_cases.ours(
    "B.12",
    225,
    words="Its moments are c, c + F/G and c - F/G with F = (u^2 - v^2) d_1 d_2 d_3 + 2 u v W: all equal exactly when F = 0, that is for "
    "tan 2 theta = -d_1 d_2 d_3 / W.",
    states=rf"J_1 = c \land J_2 = c + \frac{{{DISCRIMINANT}}}{{r^2}} \land J_3 = c - \frac{{{DISCRIMINANT}}}{{r^2}}",
    given=[first_axis, circle, length],
    uses=["B.10", "B.11"],
)

exceptional_branch = ours(
    "B.13",
    225,
    words="Left out by B.10 only if a principal moment is the mean. Then there is more: for d = (1, -1, 0) and e_1 = (1, 1, 0)/sqrt 2 "
    "every right angle turn of e_2, e_3 about e_1 gives equal moments.",
    states=r"J_1 = J_2 = J_3",
    given=[circle],
    where=derivation.exceptional_family,
    notation=family_letters,
)
