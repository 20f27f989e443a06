"""Conditions the paper's relations are read under, each stated once."""

from symcheck.core.claims import Hypothesis

orthogonal = Hypothesis(
    "orthogonal",
    "A is orthogonal: its rows, and its columns, are orthonormal",
    r"\mathbf{A}\mathbf{A}^T = \mathbf{U}, \mathbf{A}^T\mathbf{A} = \mathbf{U}",
)
right_handed = Hypothesis(
    "right-handed",
    "the axes y_1, y_2, y_3 form a right-handed triple (det A = +1)",
    r"\mathbf{e}_1 = \mathbf{e}_2 \times \mathbf{e}_3, \mathbf{e}_2 = \mathbf{e}_3 \times \mathbf{e}_1, "
    r"\mathbf{e}_3 = \mathbf{e}_1 \times \mathbf{e}_2",
)
non_negative_moments = Hypothesis(
    "moments non-negative",
    "principal moments of inertia are not negative",
    r"I_1 \ge 0, I_2 \ge 0, I_3 \ge 0",
    printed=False,
)
positive_moments = Hypothesis(
    "moments positive",
    "no principal moment is zero: the mass is not on one line",
    r"I_1 > 0, I_2 > 0, I_3 > 0",
    printed=False,
)
positive_ratio = Hypothesis(
    "gain positive", "the common gain ratio k is positive: the devices damp", r"k > 0", printed=False
)
positive_axial_moments = Hypothesis(
    "moments about the axes positive",
    "no moment about an axis e_i is zero",
    r"J_1 > 0, J_2 > 0, J_3 > 0",
    printed=False,
)
positive_mean = Hypothesis("mean positive", "the mean moment c is positive", "c > 0", printed=False)
semi_axes = Hypothesis("semi-axes", "the semi-axes are positive", "a > 0, b > 0, c > 0", printed=False)
distinct_moments = Hypothesis(
    "moments distinct",
    "the three principal moments are pairwise distinct",
    r"I_1 \ne I_2, I_2 \ne I_3, I_3 \ne I_1",
)
mass_distribution = Hypothesis(
    "mass distribution",
    "the second moments P_i of the mass are not negative (equivalent to the triangle inequalities)",
    r"P_1 \ge 0, P_2 \ge 0, P_3 \ge 0",
)
symmetric_damping = Hypothesis(
    "damping matrix symmetric", "m is symmetric", r"m_{21} = m_{12}, m_{31} = m_{13}, m_{32} = m_{23}"
)

# of the family of axes with equal moments, by the deviations d_i = I_i - c
first_axis = Hypothesis(
    "first axis",
    "e_1 is a unit vector with moment c",
    r"a_{11}^2 + a_{12}^2 + a_{13}^2 = 1, d_1 a_{11}^2 + d_2 a_{12}^2 + d_3 a_{13}^2 = 0, d_1 + d_2 + d_3 = 0",
)
length = Hypothesis("length", "r is the length of g, not zero", r"r^2 = G, r \neq 0")
