"""Mirer 2009, section 1: model damping of the angular velocity and its optimal parameters."""

from functools import partial

from symcheck.core.claims import Damage, Erratum, Hypothesis
from symcheck.core.verdicts import Origin
from symcheck.papers.declare import body, by_cases, claim, definition, exclusion, ours, premise
from symcheck.papers.mirer2009 import derivation
from symcheck.papers.mirer2009.forms import ALIGNED, PARALLEL, excess_of_product, excess_of_sum
from symcheck.papers.mirer2009.hypotheses import (
    distinct_moments,
    orthogonal,
    positive_axial_moments,
    positive_moments,
    positive_ratio,
    right_handed,
    symmetric_damping,
)
from symcheck.papers.mirer2009.notation import damping_letters, torque_letters
from symcheck.papers.mirer2009.scopes import free_moments, from_lemmas_in_moments, in_moments, proportional
from symcheck.proof import cases, identity, nonnegative

angular_momentum_law = premise("1.0.1", 45, r"\frac{d\mathbf{K}}{dt} = \mathbf{M}")

angular_momentum_and_torque = definition(
    "1.0.2",
    49,
    r"\mathbf{K} = \mathbf{I}\boldsymbol{\omega}, \quad \mathbf{M} = M_1\mathbf{e}_1 + M_2\mathbf{e}_2 + M_3\mathbf{e}_3.",
)

device_index = exclusion(
    "1.0.3", 51, "i=1, 2, 3", reason="range of the index of the three devices, used in the notation"
)

control_law = definition("1.0.4", 53, r"M_i = -k_i(\boldsymbol{\omega}, \mathbf{e}_i)")

equation_of_motion = claim(
    "1.1",
    57,
    r"\mathbf{I}\dot{\boldsymbol{\omega}} + \boldsymbol{\omega} \times \mathbf{I}\boldsymbol{\omega} = "
    r"-\sum_{i=1}^3 k_i(\boldsymbol{\omega}, \mathbf{e}_i)\mathbf{e}_i",
    equation=derivation.equations_of_motion,
    uses=["1.0.1", "1.0.2", "1.0.4"],
)

equations_in_principal_axes = claim(
    "1.2",
    61,
    r"\begin{aligned} I_1\dot{\omega}_1 + (I_3 - I_2)\omega_2\omega_3 + "
    r"\sum_{i=1}^3 k_i(\boldsymbol{\omega}, \mathbf{e}_i)(\mathbf{e}_i, \mathbf{E}_1) &= 0, \\ "
    r"I_2\dot{\omega}_2 + (I_1 - I_3)\omega_3\omega_1 + "
    r"\sum_{i=1}^3 k_i(\boldsymbol{\omega}, \mathbf{e}_i)(\mathbf{e}_i, \mathbf{E}_2) &= 0, \\ "
    r"I_3\dot{\omega}_3 + (I_2 - I_1)\omega_1\omega_2 + "
    r"\sum_{i=1}^3 k_i(\boldsymbol{\omega}, \mathbf{e}_i)(\mathbf{e}_i, \mathbf{E}_3) &= 0. \end{aligned}",
    equation=derivation.equations_of_motion,
    uses=["1.1"],
)

tensor_is_diagonal = premise("1.2.1", 63, r"\mathbf{I} = \text{diag}(I_1, I_2, I_3)")

principal_unit_vectors = definition(
    "1.2.1.1",
    63,
    words="E_1, E_2, E_3 are the unit vectors of the principal axes.",
    states=", ".join(rf"\delta_{{{i}{j}}} = {int(i == j)}" for i in (1, 2, 3) for j in (1, 2, 3)),
)

direction_cosines_of_devices = definition("1.2.2", 65, r"(\mathbf{e}_i, \mathbf{E}_j) = a_{ij}", opaque=True)

torque_by_damping_matrix = claim(
    "1.2.3",
    67,
    (
        r"M_i = (\mathbf{M}, \mathbf{E}_i) = -\sum_{j=1}^3 k_j (\boldsymbol{\omega}, \mathbf{e}_j) (\mathbf{e}_j, \mathbf{E}_i) "
        r"= -\sum_{j=1}^3 k_j \left(\sum_{s=1}^3 \omega_s a_{js} \right) a_{ji} =",
        r"= -\sum_{s=1}^3 \omega_s \sum_{j=1}^3 \omega_s k_j a_{js} a_{ji} = -\sum_{s=1}^3 m_{is} \omega_s,",
    ),
    uses=["1.0.2", "1.0.4", "1.2.2", "1.2.4"],
    errata={
        "a": Erratum(
            r"\mu_i = (\mathbf{M}, \mathbf{E}_i)",
            "one letter for two quantities",
            Origin.PAPER,
            "M_i was introduced (1.0.2, 1.0.4) as the torque of device i along e_i; here the same letter stands for the "
            "component of M along the principal axis E_i. The two differ unless the axes e_i are the principal axes; "
            "the component needs a letter of its own (written mu_i here).",
            summary=r"$M_i$ is the torque of device $i$ along $\mathbf{e}_i$ in lines 51 and 53, and here the component of "
            r"$\mathbf{M}$ along $\mathbf{E}_i$, which needs another letter.",
        ),
        "d": Erratum(
            r"-\sum_{j=1}^3 k_j \left(\sum_{s=1}^3 \omega_s a_{js} \right) a_{ji} = "
            r"-\sum_{s=1}^3 \omega_s \sum_{j=1}^3 k_j a_{js} a_{ji}",
            "extra factor",
            Origin.UNCERTAIN,
            "omega_s stands twice, before and inside the inner sum; m_is, defined by that inner sum two lines below, "
            "has it without omega_s. Nothing in the text tells whether the author or the OCR repeated it.",
            summary=r"The factor $\omega_s$ stands twice, before the inner sum and in it; the one in the inner sum must go.",
        ),
        "e": Erratum(
            r"-\sum_{s=1}^3 \omega_s \sum_{j=1}^3 k_j a_{js} a_{ji} = -\sum_{s=1}^3 m_{is} \omega_s",
            "extra factor",
            Origin.UNCERTAIN,
            "The same repeated omega_s, seen from the other side of the chain.",
            summary=r"The same repeated $\omega_s$, on the left of the next equality sign.",
        ),
    },
    lines={"e": 69},
)

damping_matrix = definition("1.2.4", 73, r"m_{is} = \sum_{j=1}^3 k_j a_{js} a_{ji}.")

torque_is_linear = claim(
    "1.2.5", 75, r"\mathbf{M} = -\mathbf{m}\boldsymbol{\omega}", uses=["1.0.2", "1.0.4", "1.2.3", "1.2.4"]
)

damping_matrix_is_symmetric = claim(
    "1.2.6", 75, words="The matrix m is symmetric.", states=r"m_{ij} = m_{ji}", uses=["1.2.4"]
)

spectral_theorem = premise(
    "1.2.7",
    77,
    r"\mathbf{m} = \mathbf{S}^T \mathbf{B} \mathbf{S}",
    words="Every symmetric matrix is S^T B S with an orthogonal S and a diagonal B.",
    reason="the spectral theorem, cited by the paper as known",
    notation=damping_letters,
)

diagonal_form = premise(
    "1.2.8",
    79,
    r"\mathbf{B} = \begin{pmatrix} b_{11} & 0 & 0 \\ 0 & b_{22} & 0 \\ 0 & 0 & b_{33} \end{pmatrix}.",
    words="B is diagonal.",
    notation=damping_letters,
)

orthogonal_devices_suffice = claim(
    "1.2.9",
    81,
    words="Three devices along arbitrary axes act like three devices along orthogonal axes: S^T B S is the damping matrix "
    "of devices along the rows of S with gains b_11, b_22, b_33.",
    states=r"n_{ij} = b_{11}s_{1j}s_{1i} + b_{22}s_{2j}s_{2i} + b_{33}s_{3j}s_{3i}",
    where=derivation.spectral_damping_entries,
    uses=["1.2.4", "1.2.7"],
    notation=damping_letters,
)

right_handed_choice = ours(
    "1.2.10",
    81,
    words="The orthogonal axes may be taken right-handed: -S gives the same damping matrix as S.",
    states=r"q_{ij} = n_{ij}",
    where=derivation.mirrored_damping_entries,
    notation=damping_letters,
)

orthogonal_devices = premise("1.2.11", 81, words="From here on e_1, e_2, e_3 are a right-handed orthonormal triple.")

damping_matrix_product = claim(
    "1.2.12",
    83,
    r"\mathbf{m} = \mathbf{A}^T \begin{pmatrix} k_1 & 0 & 0 \\ 0 & k_2 & 0 \\ 0 & 0 & k_3 \end{pmatrix} \mathbf{A},",
    where=derivation.damping_entries,
    uses=["1.2.4"],
)

trivial_solution = by_cases.claim(
    "1.2.13",
    89,
    r"\omega_1 = \omega_2 = \omega_3 = 0,",
    words="Rest is a solution of (1.2).",
    states=r"(\omega_1 = \omega_2 = \omega_3 = 0 \land \dot{\omega}_1 = \dot{\omega}_2 = \dot{\omega}_3 = 0) \Rightarrow \rho_i = 0",
    where=derivation.residual,
    uses=["1.2"],
    notation=damping_letters,
)

stability_degree = definition(
    "1.2.14",
    91,
    words="The stability degree xi is minus the real part of the characteristic root nearest to the imaginary axis.",
    opaque=True,
)

linearisation_point = exclusion(
    "1.2.15", 93, r"\omega_1 = \omega_2 = \omega_3 = 0", reason="names the solution of 1.2.13 once more"
)

linearised_equations = claim(
    "1.2.16",
    95,
    r"\begin{aligned} I_1 \dot{\omega}_1 + m_{11}\omega_1 + m_{12}\omega_2 + m_{13}\omega_3 &= 0, \\ "
    r"I_2 \dot{\omega}_2 + m_{21}\omega_1 + m_{22}\omega_2 + m_{23}\omega_3 &= 0, \\ "
    r"I_3 \dot{\omega}_3 + m_{31}\omega_1 + m_{32}\omega_2 + m_{33}\omega_3 &= 0, \end{aligned}",
    equation=derivation.linearised_equations,
    uses=["1.2", "1.2.4"],
)

characteristic_equation = claim(
    "1.2.17",
    99,
    r"\begin{aligned} I_1 I_2 I_3 p^3 + (I_1 I_2 m_{33} + I_2 I_3 m_{11} + I_3 I_1 m_{22}) p^2 + \\ "
    r"+ \left[I_1 (m_{22} m_{33} - m_{23}^2) + I_2 (m_{33} m_{11} - m_{31}^2) + I_3 (m_{11} m_{22} - m_{12}^2) \right] p + \\ "
    r"+ (m_{11} m_{22} m_{33} + 2m_{12} m_{13} m_{23} - m_{11} m_{23}^2 - m_{22} m_{31}^2 - m_{33} m_{12}^2) = 0. \end{aligned}",
    given=[symmetric_damping],
    equation=derivation.characteristic_polynomial_of_damping_matrix,
    keeping=("m",),
    uses=["1.2.6", "1.2.16"],
)

characteristic_equation_in_gains = claim(
    "1.3",
    103,
    r"\begin{aligned} I_1 I_2 I_3 p^3 + \left[k_1 (I_2 I_3 a_{11}^2 + I_3 I_1 a_{12}^2 + I_1 I_2 a_{13}^2) + \right. \\ "
    r"+ k_2 (I_2 I_3 a_{21}^2 + I_3 I_1 a_{22}^2 + I_1 I_2 a_{23}^2) + \\ "
    r"\left. + k_3 (I_2 I_3 a_{31}^2 + I_3 I_1 a_{32}^2 + I_1 I_2 a_{33}^2) \right] p^2 + \\ "
    r"+ \left[k_1 k_2 (I_1 a_{31}^2 + I_2 a_{32}^2 + I_3 a_{33}^2) + k_2 k_3 (I_1 a_{11}^2 + I_2 a_{12}^2 + I_3 a_{13}^2) + \right. \\ "
    r"\left. + k_3 k_1 (I_1 a_{21}^2 + I_2 a_{22}^2 + I_3 a_{23}^2) \right] p + k_1 k_2 k_3 = 0. \end{aligned}",
    given=[orthogonal, right_handed],
    equation=derivation.characteristic_polynomial,
    uses=["1.2.12", "1.2.17"],
)

moments_and_scaled_gains = definition(
    "1.3.1",
    107,
    r"\begin{aligned} J_i &= I_1 a_{i1}^2 + I_2 a_{i2}^2 + I_3 a_{i3}^2, \\ "
    r"L_i &= I_2 I_3 a_{i1}^2 + I_3 I_1 a_{i2}^2 + I_1 I_2 a_{i3}^2, \quad (i = 1, 2, 3) \\ "
    r"\bar{k}_i &= k_i / J_i. \end{aligned}",
)


characteristic_polynomial_by_axes = ours(
    "1.3.2",
    107,
    words="In J_i and L_i the left side of (1.3) is I_1 I_2 I_3 p^3 + sum k_i L_i p^2 + (k_1 k_2 J_3 + ...) p + k_1 k_2 k_3.",
    states=r"I_1 I_2 I_3 p^3 + (k_1 L_1 + k_2 L_2 + k_3 L_3) p^2 + (k_1 k_2 J_3 + k_2 k_3 J_1 + k_3 k_1 J_2) p + k_1 k_2 k_3 = 0",
    given=[orthogonal],
    equation=derivation.characteristic_polynomial,
    uses=["1.3", "1.3.1"],
)

characteristic_polynomial_by_minors = in_moments.ours(
    "1.3.3",
    107,
    words="It is what Cauchy-Binet gives: gains of some axes times minors of I p left to the others.",
    states=characteristic_polynomial_by_axes.statement.states,
    equation=derivation.characteristic_polynomial_by_axes,
    uses=["1.3.2"],
)

characteristic_equation_in_scaled_gains = claim(
    "1.4",
    111,
    r"\begin{aligned} I_1 I_2 I_3 p^3 + (\bar{k}_1 J_1 L_1 + \bar{k}_2 J_2 L_2 + \bar{k}_3 J_3 L_3) p^2 + \\ "
    r"+ (\bar{k}_1 \bar{k}_2 + \bar{k}_2 \bar{k}_3 + \bar{k}_3 \bar{k}_1) J_1 J_2 J_3 p "
    r"+ \bar{k}_1 \bar{k}_2 \bar{k}_3 J_1 J_2 J_3 = 0. \end{aligned}",
    where=derivation.scaled_gains,
    keeping=("kbar", *free_moments),
    equation=derivation.characteristic_polynomial_by_axes,
    uses=["1.3.2", "1.3.3"],
)

moment_about_device_axis = claim(
    "1.4.1",
    113,
    words="J_i is the moment of inertia of the body about the axis e_i.",
    states=r"J_i = (\mathbf{e}_i, \mathbf{I}\mathbf{e}_i)",
    uses=["1.3.1"],
)

larger_moment_larger_torque = claim(
    "1.4.2",
    113,
    r"\mathbf{M}_i",
    words="The larger J_i, the larger the torque along that axis must be: an angular acceleration w about e_i takes the torque J_i w "
    "along e_i (a), so that of two axes the one of the larger moment takes the larger torque (b).",
    states=(r"(\mathbf{e}_i, w\mathbf{I}\mathbf{e}_i) = J_i w", "J_1 w > J_2 w"),
    damage=Damage(
        "M_i",
        "M_i is set in bold, as a vector; it is the scalar torque of device i (lines 51 and 53), and the index is that of J_i. "
        "The author or the OCR may have done it.",
        kind="typography",
        origin=Origin.UNCERTAIN,
    ),
    given=[Hypothesis("larger moment", "J_1 is larger than J_2, and w is positive", r"J_1 > J_2 \land w > 0")],
    by={"a": identity, "b": nonnegative("(J_1 - J_2)w")},
    uses=["1.4.1"],
    notation=torque_letters,
)

gains_in_proportion = premise(
    "1.4.3",
    117,
    r"\frac{k_1}{J_1} = \frac{k_2}{J_2} = \frac{k_3}{J_3},",
    words="Gains are chosen in proportion to J_i.",
)

common_gain = premise(
    "1.4.4", 119, r"\bar{k}_1 = \bar{k}_2 = \bar{k}_3 = k", words="The same choice; k is the common ratio."
)

characteristic_equation_in_common_gain = proportional.claim(
    "1.5",
    121,
    r"I_1 I_2 I_3 p^3 + k(J_1 L_1 + J_2 L_2 + J_3 L_3) p^2 + (3p + k) k^2 J_1 J_2 J_3 = 0.",
    equation=derivation.characteristic_polynomial_by_axes,
    uses=["1.3.3", "1.4", "1.4.4"],
)

tendency_to_equal_real_parts = exclusion(
    "1.5.1",
    123,
    words="In many attitude control systems the real parts of the roots become equal near the optimum.",
    reason="an observation about other systems; cited experience, not a statement about this one",
)

triple_root_assumed = premise(
    "1.5.2",
    125,
    words="The stability degree of (1.5) is supposed to be largest when all roots are real and equal.",
    reason="only supposed in the paper; proved here as B.1 to B.4",
)

other_system = exclusion(
    "1.5.3",
    125,
    words="The same happens in the problem of [3, 4].",
    reason="refers to other papers, nothing stated here",
)

triple_root_square_coefficient = proportional.claim(
    "1.5.4",
    127,
    r"3\xi I_1 I_2 I_3 = k(J_1 L_1 + J_2 L_2 + J_3 L_3),",
    equation=partial(derivation.triple_root_condition, 2),
    uses=["1.3.3", "1.5"],
)

triple_root_linear_coefficient = proportional.claim(
    "1.5.5",
    129,
    r"3\xi^2 I_1 I_2 I_3 = 3k^2 J_1 J_2 J_3,",
    equation=partial(derivation.triple_root_condition, 1),
    uses=["1.3.3", "1.5"],
)

triple_root_constant_coefficient = proportional.claim(
    "1.5.6",
    131,
    r"\xi^3 I_1 I_2 I_3 = k^3 J_1 J_2 J_3,",
    equation=partial(derivation.triple_root_condition, 0),
    uses=["1.3.3", "1.5"],
)

triple_root = Hypothesis(
    "triple root",
    "(1.5) has the triple root p = -xi: relations 1.5.4 to 1.5.6",
    body(triple_root_square_coefficient, triple_root_linear_coefficient, triple_root_constant_coefficient),
)
product_at_triple_root = in_moments.by_cases.claim(
    "1.6",
    135,
    r"J_1 J_2 J_3 = I_1 I_2 I_3,",
    given=[triple_root, positive_ratio, positive_moments, positive_axial_moments],
    uses=["1.5.4", "1.5.5", "1.5.6"],
)

sum_at_triple_root = in_moments.by_cases.claim(
    "1.7",
    137,
    r"J_1 L_1 + J_2 L_2 + J_3 L_3 = 3I_1 I_2 I_3,",
    given=[triple_root, positive_ratio, positive_moments, positive_axial_moments],
    uses=["1.5.4", "1.5.5", "1.5.6"],
)

gain_at_triple_root = in_moments.by_cases.claim(
    "1.8",
    139,
    r"k = \xi.",
    given=[triple_root, positive_ratio, positive_moments, positive_axial_moments],
    uses=["1.5.4", "1.5.5", "1.5.6"],
)

triple_root_conditions_are_equivalent = in_moments.by_cases.ours(
    "1.8.1",
    139,
    words="Conversely, (1.6) to (1.8) make p = -k a triple root of (1.5).",
    states=rf"{body(product_at_triple_root, sum_at_triple_root, gain_at_triple_root)} \Rightarrow ({triple_root.states})",
    uses=["1.6", "1.7", "1.8"],
)

gain_as_large_as_possible = exclusion(
    "1.8.2",
    141,
    words="By (1.8) the gain k should be as large as possible.",
    reason="design advice; what it rests on is (1.8): the stability degree is k",
)

equalities_only_for_parallel_axes = from_lemmas_in_moments.claim(
    "1.8.3",
    141,
    words="(1.6) and (1.7) hold only if the damping axes are parallel to the principal axes.",
    states=rf"{body(product_at_triple_root, sum_at_triple_root)} \Rightarrow {PARALLEL}",
    given=[orthogonal, positive_moments],
    by=cases(excess_of_sum),
    uses=["1.6", "1.7", "2.17", "2.20"],
    errata={
        "": Erratum(
            "",
            "missing hypothesis",
            Origin.PAPER,
            "With two equal moments every axis in their plane serves, so parallelism to the chosen principal axes does not "
            "follow; it follows when the moments are pairwise distinct.",
            summary="With two equal moments every axis in their plane serves; it is true for pairwise distinct moments.",
            instead="the same, if the three principal moments of inertia are pairwise distinct",
            needs=(distinct_moments,),
        )
    },
    lemmas=["2.19.4"],
)

order_of_axes_does_not_matter = from_lemmas_in_moments.claim(
    "1.8.4",
    141,
    words="Which damping axis is parallel to which principal axis does not matter: (1.6), (1.7) hold for each order.",
    states=rf"{ALIGNED} \Rightarrow ({body(product_at_triple_root, sum_at_triple_root)})",
    given=[orthogonal],
    by=cases(excess_of_product),
    uses=["1.6", "1.7"],
    lemmas=["2.13.4", "2.19.4"],
)
