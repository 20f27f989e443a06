"""Mirer 2009, section 2: extremal relations between the moments of inertia about three orthogonal axes."""

from symcheck.core.claims import Erratum, Hypothesis
from symcheck.core.verdicts import Origin
from symcheck.papers.declare import Scope, body, by_cases, claim, definition, exclusion, ours, premise
from symcheck.papers.mirer2009 import derivation
from symcheck.papers.mirer2009.forms import ALIGNED, PARALLEL, deficit_of_product, excess_of_product, excess_of_sum
from symcheck.papers.mirer2009.hypotheses import (
    distinct_moments,
    first_axis,
    length,
    mass_distribution,
    non_negative_moments,
    orthogonal,
    positive_mean,
    positive_moments,
    semi_axes,
)
from symcheck.papers.mirer2009.notation import ellipsoid_letters, turned_letters
from symcheck.papers.mirer2009.scopes import equal_moments, from_lemmas_in_moments
from symcheck.proof import cases, existence, identity, nonnegative

cosines = Scope(where=derivation.direction_cosines)
axial = Scope(where=derivation.axial_moments)
of_mass = Scope(where=derivation.moments_of_a_mass_distribution)

EQUAL_MOMENTS = r"(J_1 = J_2 = J_3)"
EQUAL_PRODUCTS = r"(J_1 J_2 J_3 = I_1 I_2 I_3)"
EQUAL_SUMS = r"(J_1 L_1 + J_2 L_2 + J_3 L_3 = 3 I_1 I_2 I_3)"
CUBE_OF_MEAN = r"\left(\frac{I_1 + I_2 + I_3}{3} \right)^3"

conditions_on_second_row = premise(
    "2.14",
    344,
    r"a_{21} a_{22} = 0, \quad a_{22} a_{23} = 0, \quad a_{23} a_{21} = 0;",
    words="Conditions of equality.",
)

condition_on_product_of_inertia = premise(
    "2.15", 346, r"I_1 a_{11} a_{31} + I_2 a_{12} a_{32} + I_3 a_{13} a_{33} = 0.", words="Condition of equality."
)

LOWER_EQUALITY = body(conditions_on_second_row, condition_on_product_of_inertia)

two_frames = definition(
    "2.0.1",
    149,
    words="O x_1 x_2 x_3 has its axes along the principal central axes; O y_1 y_2 y_3 is turned against it by A; both are "
    "right-handed.",
    opaque=True,
)

matrix_of_direction_cosines = definition("2.0.2", 153, r"\mathbf{A} = \|a_{ij}\|", opaque=True)

direction_cosine = definition("2.0.3", 155, r"a_{ij} = \cos(Oy_i, Ox_j).", opaque=True)

axial_moment = axial.claim("2.0.4", 159, r"J_i = \sum_{k=1}^3 I_k a_{ik}^2.")

moments_are_not_negative = by_cases.ours(
    "2.0.5",
    159,
    words="No J_i is negative.",
    states=r"(J_1 \geq 0) \land (J_2 \geq 0) \land (J_3 \geq 0)",
    given=[non_negative_moments],
    uses=["2.0.4"],
)

moments_are_positive = ours(
    "2.0.6",
    159,
    words="Every J_i is positive if the principal moments are.",
    states=r"(J_1 \geq 0) \land (J_2 \geq 0) \land (J_3 \geq 0) \land (J_1 \neq 0) \land (J_2 \neq 0) \land (J_3 \neq 0)",
    given=[orthogonal, positive_moments],
    by=cases(
        "I_1 a_{11}^2 + I_2 a_{12}^2 + I_3 a_{13}^2",
        "I_1 a_{21}^2 + I_2 a_{22}^2 + I_3 a_{23}^2",
        "I_1 a_{31}^2 + I_2 a_{32}^2 + I_3 a_{33}^2",
    ),
    uses=["2.0.4"],
)

bounds_of_product = from_lemmas_in_moments.claim(
    "2.1",
    165,
    r"I_1 I_2 I_3 \leq J_1 J_2 J_3 \leq \left(\frac{I_1 + I_2 + I_3}{3} \right)^3,",
    given=[orthogonal, non_negative_moments],
    by={"a": nonnegative(excess_of_product), "b": nonnegative(deficit_of_product)},
    equality={"a": LOWER_EQUALITY, "b": EQUAL_MOMENTS},
    equality_given=[positive_moments, distinct_moments],
    uses=["1.3.1"],
    lemmas=["2.1.7a", "2.13.4", "2.0.5", "2.0.6"],
)

equality_on_the_right = from_lemmas_in_moments.claim(
    "2.1.1",
    167,
    words="The right equality of (2.1) is attained only if each axis x_i is collinear with an axis y_j.",
    states=rf"J_1 J_2 J_3 = {CUBE_OF_MEAN} \Rightarrow {PARALLEL}",
    given=[orthogonal, positive_moments],
    by=cases(excess_of_product),
    uses=["2.1"],
    errata={
        "": Erratum(
            rf"{EQUAL_PRODUCTS} \Rightarrow {PARALLEL}",
            "left and right exchanged",
            Origin.PAPER,
            "The sentence exchanges the two sides: collinear axes give the left equality, the minimum (2.10), (2.17); the "
            "right one, the maximum, belongs to equal moments (line 209). Moreover 'only' needs pairwise distinct moments.",
            summary="Left and right are exchanged: collinear axes give the left equality, the minimum, and they alone do so if "
            "the moments are pairwise distinct.",
            instead=r"the left equality is attained only for collinear axes $Ox_i$ and $Oy_j$, if $I_1, I_2, I_3$ are pairwise "
            "distinct",
            needs=(distinct_moments,),
        )
    },
    lemmas=["2.13.4", "2.0.6"],
)

equality_on_the_left = from_lemmas_in_moments.claim(
    "2.1.2",
    167,
    "J_1 = J_2 = J_3",
    words="The left equality of (2.1) holds at J_1 = J_2 = J_3.",
    states=rf"{EQUAL_MOMENTS} \Rightarrow {EQUAL_PRODUCTS}",
    given=[orthogonal, positive_moments],
    by=cases(deficit_of_product),
    uses=["2.1"],
    errata={
        "": Erratum(
            rf"{EQUAL_MOMENTS} \Rightarrow J_1 J_2 J_3 = {CUBE_OF_MEAN}",
            "left and right exchanged",
            Origin.PAPER,
            "The other half of the exchange: J_1 = J_2 = J_3 is where the right equality holds, as the proof says itself.",
            summary="The other half of the exchange: equal moments give the right equality, the maximum, as the proof says "
            "(line 209).",
            instead="the right equality holds for $J_1 = J_2 = J_3$",
        )
    },
    lemmas=["2.1.7a"],
)

order_of_axes_is_irrelevant = from_lemmas_in_moments.claim(
    "2.1.3",
    167,
    words="For collinear axes the order in which axes y_j fall on axes x_i does not matter: the product is I_1 I_2 I_3.",
    states=rf"{ALIGNED} \Rightarrow {EQUAL_PRODUCTS}",
    given=[orthogonal],
    by=cases(excess_of_product),
    uses=["2.1"],
    lemmas=["2.13.4"],
)

upper_bound = from_lemmas_in_moments.claim(
    "2.1.4",
    173,
    r"J_1 J_2 J_3 \leq \left(\frac{I_1 + I_2 + I_3}{3} \right)^3.",
    given=[orthogonal, non_negative_moments],
    by=nonnegative(deficit_of_product),
    equality=EQUAL_MOMENTS,
    equality_given=[positive_moments],
    uses=["2.2", "2.3.5"],
    lemmas=["2.1.7a", "2.0.5", "2.0.6"],
)

product_of_moments = definition("2.1.5", 175, "f = J_1 J_2 J_3")

mean_moment = definition("2.1.6", 175, "c = (I_1 + I_2 + I_3)/3")

trace_is_invariant = claim(
    "2.1.7",
    177,
    r"J_1 + J_2 + J_3 = I_1 + I_2 + I_3 = 3c",
    given=[orthogonal],
    uses=["2.1.6"],
)

product_at_given_moment = from_lemmas_in_moments.claim(
    "2.2",
    181,
    r"f = J_2 \cdot \frac{1}{4} \left[(J_1 + J_3)^2 - (J_1 - J_3)^2 \right] \leq \frac{1}{4} J_2 (3c - J_2)^2,",
    given=[orthogonal, non_negative_moments],
    by={"a": identity, "b": nonnegative(r"\frac{1}{4} J_2 (J_1 - J_3)^2")},
    equality={"b": "J_1 = J_3"},
    equality_given=[positive_moments],
    uses=["2.1.5", "2.1.7"],
    lemmas=["2.1.7a", "2.0.5", "2.0.6"],
)

equality_at_given_moment = from_lemmas_in_moments.by_cases.claim(
    "2.2.1",
    183,
    "J_1 = J_3",
    words="(2.2) is an equality at J_1 = J_3.",
    states=r"J_1 = J_3 \Rightarrow f = \frac{1}{4} J_2 (3c - J_2)^2",
    given=[orthogonal],
    uses=["2.2"],
    lemmas=["2.1.7a"],
)

bound_at_given_moment = definition("2.2.2", 187, r"f_1(J_2) = \frac{1}{4} J_2 (3c - J_2)^2.")

interval_of_moments = of_mass.claim(
    "2.2.3",
    189,
    "[0, 3c/2]",
    words="J_2, the argument of f_1, lies between 0 and 3c/2.",
    states=r"(0 \leq J_2) \land (J_2 \leq 3c/2)",
    given=[orthogonal, mass_distribution],
    by=cases(r"P_1 a_{21}^2 + P_2 a_{22}^2 + P_3 a_{23}^2"),
    uses=["2.2.2", "2.3.3"],
)

triangle_inequalities = of_mass.claim(
    "2.2.4",
    191,
    r"I_2 + I_3 \geq I_1, \quad I_3 + I_1 \geq I_2, \quad I_1 + I_2 \geq I_3",
    given=[mass_distribution],
    by={"a": nonnegative("2P_1"), "b": nonnegative("2P_2"), "c": nonnegative("2P_3")},
    equality={"a": "P_1 = 0", "b": "P_2 = 0", "c": "P_3 = 0"},
)

triangle_inequalities_by_trace = of_mass.claim(
    "2.3",
    195,
    r"I_1 + I_2 + I_3 \geq 2I_i, \quad i = 1, 2, 3.",
    given=[mass_distribution],
    by=nonnegative("2P_i"),
    equality="P_i = 0",
    uses=["2.2.4"],
)

triangle_forms_are_equivalent = by_cases.claim(
    "2.3.1",
    193,
    words="The inequalities (2.3) are equivalent to the triangle inequalities 2.2.4.",
    states=r"I_1 + I_2 + I_3 - 2 I_1 = I_2 + I_3 - I_1, I_1 + I_2 + I_3 - 2 I_2 = I_3 + I_1 - I_2, "
    r"I_1 + I_2 + I_3 - 2 I_3 = I_1 + I_2 - I_3",
    uses=["2.2.4", "2.3"],
)

weighted_triangle_inequality = of_mass.claim(
    "2.3.2",
    199,
    r"3c(a_{21}^2 + a_{22}^2 + a_{23}^2) \geq 2J_2",
    given=[mass_distribution],
    by=nonnegative(r"2 P_1 a_{21}^2 + 2 P_2 a_{22}^2 + 2 P_3 a_{23}^2"),
    equality=r"P_1 a_{21} = 0, P_2 a_{22} = 0, P_3 a_{23} = 0",
    uses=["2.3", "2.1.6"],
)

second_row_is_a_unit_vector = claim("2.3.3", 201, r"a_{21}^2 + a_{22}^2 + a_{23}^2 = 1", given=[orthogonal])

moment_at_most_three_halves_mean = of_mass.claim(
    "2.3.4",
    203,
    r"J_2 \leq \frac{3}{2}c.",
    given=[orthogonal, mass_distribution],
    by=nonnegative(r"P_1 a_{21}^2 + P_2 a_{22}^2 + P_3 a_{23}^2"),
    equality=r"P_1 a_{21} = 0, P_2 a_{22} = 0, P_3 a_{23} = 0",
    uses=["2.3.2", "2.3.3"],
)

derivatives_of_bound = claim(
    "2.3.5",
    207,
    r"\frac{df_1}{dJ_2} = \frac{3}{4}(3c - J_2)(c - J_2), \quad \frac{d^2 f_1}{dJ_2^2} = \frac{3}{2}(J_2 - 2c),",
    keeping=("J", "c"),
    uses=["2.2.2"],
)

on_the_interval = Hypothesis("interval", "J_2 lies on [0, 3c/2]", r"J_2 \geq 0, J_2 \leq 3c/2")

maximum_of_bound = claim(
    "2.3.6",
    209,
    (r"\max f_1", "J_2 = c"),
    words="f_1 is largest at J_2 = c, and only there, with the value c^3.",
    states=r"(f_1 \leq c^3) \land (f_1 = c^3 \Leftrightarrow J_2 = c)",
    given=[on_the_interval, positive_mean],
    keeping=("J", "c"),
    by=cases(r"\frac{1}{4} (c - J_2)^2 ((3c/2 - J_2) + 5c/2)"),
    uses=["2.2.2", "2.3.5"],
)

maximum_of_product = from_lemmas_in_moments.claim(
    "2.3.7",
    209,
    r"\max f = c^3",
    words="The largest value of f is c^3; that it is attained is 2.9.4.",
    states=r"f \leq c^3",
    given=[orthogonal, non_negative_moments],
    by=nonnegative(deficit_of_product),
    equality=EQUAL_MOMENTS,
    equality_given=[positive_moments],
    uses=["2.2", "2.3.6", "2.9.4"],
    lemmas=["2.1.7a", "2.0.5", "2.0.6"],
)

maximum_at_equal_moments = by_cases.claim(
    "2.3.8",
    209,
    "J_1 = J_2 = J_3 = c",
    words="The value c^3 is reached when all three moments are c.",
    states=r"J_1 = J_2 = J_3 = c \Rightarrow f = c^3",
    keeping=("J", "c"),
    uses=["2.3.7"],
)

equal_moment_conditions = axial.claim(
    "2.4",
    213,
    r"J_i = \sum_{k=1}^3 I_k a_{ik}^2 = c, \quad i = 1, 2, 3,",
    imposed="b",
    uses=["2.0.4"],
)

two_conditions_suffice = from_lemmas_in_moments.by_cases.claim(
    "2.4.1",
    215,
    words="Of the three conditions (2.4) any two imply the third.",
    states=r"(J_1 = c \land J_2 = c \Rightarrow J_3 = c) \land (J_2 = c \land J_3 = c \Rightarrow J_1 = c) \land "
    r"(J_3 = c \land J_1 = c \Rightarrow J_2 = c)",
    given=[orthogonal],
    uses=["2.4", "2.1.7"],
    lemmas=["2.1.7a"],
)

first_condition = axial.claim(
    "2.5",
    217,
    r"J_1 = I_1 a_{11}^2 + I_2 a_{12}^2 + I_3 a_{13}^2 = c,",
    imposed="b",
    uses=["2.4"],
)

second_condition = axial.claim(
    "2.6",
    219,
    r"J_2 = I_1 a_{21}^2 + I_2 a_{22}^2 + I_3 a_{23}^2 = c.",
    imposed="b",
    uses=["2.4"],
)

orthonormal_rows = claim(
    "2.7",
    223,
    r"\begin{aligned} a_{11}^2 + a_{12}^2 + a_{13}^2 &= 1, \\ a_{21}^2 + a_{22}^2 + a_{23}^2 &= 1, \\ "
    r"a_{11}a_{21} + a_{12}a_{22} + a_{13}a_{23} &= 0. \end{aligned}",
    given=[orthogonal],
)

one_parameter_family = equal_moments.claim(
    "2.7.1",
    225,
    words="In general (2.5) to (2.7) have a one-parameter family of solutions: for every first axis with J_1 = c (its squares depend "
    "on one parameter, B.6) there are second and third axes with the same moment, (u g + v h)/r and across it. They are four turns of one "
    "(B.10), and no further ones unless a principal moment is the mean (B.13).",
    states=r"\exists u, v: (u^2 + v^2 = 1 \land J_1 = c \land J_2 = c \land J_3 = c)",
    given=[first_axis, length],
    by=existence(),
    uses=["2.5", "2.6", "2.7", "B.6", "B.10", "B.11", "B.12"],
)

aircraft_angles = definition(
    "2.7.2", 227, words="Pitch alpha, yaw beta and roll gamma of figure 1 determine the matrix A.", opaque=True
)

figure_of_the_angles = exclusion(
    "2.7.16",
    230,
    words="Figure 1: the angles alpha, beta, gamma between the two frames.",
    reason="not in the text at hand; what it must show, pitch first, then yaw, then roll, is what the nine cosines 2.7.5 to 2.7.13 "
    "are derived from",
)

angles_make_rows_orthonormal = cosines.by_cases.claim(
    "2.7.3",
    232,
    words="With the three angles the conditions (2.7) hold of themselves.",
    states=body(orthonormal_rows),
    uses=["2.7", "2.7.2"],
)

second_row_along_a_diagonal = by_cases.claim(
    "2.7.4",
    234,
    r"a_{21}^2 = a_{22}^2 = a_{23}^2 = 1/3",
    words="(2.6) holds when the squares of the second row are 1/3 each.",
    states=r"a_{21}^2 = a_{22}^2 = a_{23}^2 = 1/3 \Rightarrow J_2 = c",
    uses=["2.6"],
)

cosine_11 = cosines.claim("2.7.5", 238, r"a_{11} = \cos \alpha \cos \beta,")

cosine_12 = cosines.claim("2.7.6", 240, r"a_{12} = \sin \alpha \sin \gamma - \cos \alpha \sin \beta \cos \gamma,")

cosine_13 = cosines.claim("2.7.7", 242, r"a_{13} = \sin \alpha \cos \gamma + \cos \alpha \sin \beta \sin \gamma,")

cosine_21 = cosines.claim("2.7.8", 244, r"a_{21} = \sin \beta,")

cosine_22 = cosines.claim("2.7.9", 246, r"a_{22} = \cos \beta \cos \gamma,")

cosine_23 = cosines.claim("2.7.10", 248, r"a_{23} = -\cos \beta \sin \gamma,")

cosine_31 = cosines.claim("2.7.11", 250, r"a_{31} = -\sin \alpha \cos \beta,")

cosine_32 = cosines.claim("2.7.12", 252, r"a_{32} = \cos \alpha \sin \gamma + \sin \alpha \sin \beta \cos \gamma,")

cosine_33 = cosines.claim("2.7.13", 254, r"a_{33} = \cos \alpha \cos \gamma - \sin \alpha \sin \beta \sin \gamma,")

angles_of_the_diagonal = cosines.by_cases.claim(
    "2.7.14",
    256,
    (r"\sin^2 \beta = 1/3", r"\sin^2 \gamma = 1/2"),
    words="In the angles, the second row has squares 1/3 exactly when sin^2 beta = 1/3 and sin^2 gamma = 1/2.",
    states=r"(\sin^2 \beta = 1/3 \land \sin^2 \gamma = 1/2) \Leftrightarrow (a_{21}^2 = a_{22}^2 = a_{23}^2 = 1/3)",
    uses=["2.7.4", "2.7.8", "2.7.9", "2.7.10"],
)

chosen_values = premise(
    "2.7.15",
    260,
    r"\sin \beta = 1/\sqrt{3}, \quad \sin \gamma = 1/\sqrt{2}, \quad \cos \gamma = 1/\sqrt{2}.",
    words="One of the solutions of 2.7.14 is chosen.",
)

chosen_angles = Hypothesis("chosen angles", "the angles beta and gamma of 2.7.15", body(chosen_values))

squares_of_first_row = cosines.claim(
    "2.8",
    264,
    (
        r"a_{11}^2 = \frac{1}{3}(1 + \cos 2\alpha),",
        r"a_{12}^2 = \frac{1}{3} \left(1 - \frac{1}{2} \cos 2\alpha - \frac{\sqrt{3}}{2} \sin 2\alpha \right),",
        r"a_{13}^2 = \frac{1}{3} \left(1 - \frac{1}{2} \cos 2\alpha + \frac{\sqrt{3}}{2} \sin 2\alpha \right).",
    ),
    given=[chosen_angles],
    uses=["2.7.5", "2.7.6", "2.7.7", "2.7.15"],
    lines={"b": 266, "c": 268},
)

equal_moment_equation = cosines.claim(
    "2.8.1",
    272,
    r"c + \frac{1}{3} \left(I_1 - \frac{I_2 + I_3}{2} \right) \cos 2\alpha "
    r"- \frac{1}{3} \frac{\sqrt{3}}{2} (I_2 - I_3) \sin 2\alpha = c,",
    given=[chosen_angles],
    equation=derivation.equal_moment_equation,
    uses=["2.5", "2.8"],
)

first_moment_is_the_mean = Hypothesis(
    "first moment is the mean", "relation 2.8.1: J_1 = c in terms of alpha", body(equal_moment_equation)
)

pitch_of_equal_moments = by_cases.claim(
    "2.9",
    276,
    r"\operatorname{tg} 2\alpha = \sqrt{3} \frac{I_1 - c}{I_2 - I_3}.",
    given=[
        first_moment_is_the_mean,
        Hypothesis("I_2, I_3 distinct", "I_2 and I_3 differ (line 278)", r"I_2 \neq I_3"),
    ],
    uses=["2.8.1"],
)

two_equal_moments = by_cases.claim(
    "2.9.1",
    278,
    ("I_2 = I_3", r"\cos 2\alpha = 0"),
    words="When I_2 = I_3, relation 2.8.1 says cos 2 alpha = 0.",
    states=r"I_2 = I_3 \Rightarrow \cos 2\alpha = 0",
    given=[first_moment_is_the_mean, positive_moments],
    uses=["2.8.1", "2.9"],
    errata={
        "": Erratum(
            "",
            "missing hypothesis",
            Origin.PAPER,
            "When all three moments are equal, 2.8.1 holds for every alpha and cos 2 alpha need not vanish. The choice "
            "alpha = pi/4 remains right (2.9.2), so the existence proof is not harmed.",
            summary=r"If all three moments are equal every $\alpha$ serves, and $\cos 2\alpha$ need not vanish; the choice "
            r"$\alpha = \pi/4$ is right in any case.",
            instead=r"if $I_2 = I_3 \neq I_1$, then $\cos 2\alpha = 0$",
            needs=(Hypothesis("I_1, I_2 distinct", "I_1 differs from I_2 = I_3", r"I_1 \neq I_2"),),
        )
    },
)

pitch_of_two_equal_moments = by_cases.claim(
    "2.9.2",
    278,
    r"\alpha = \pi/4",
    words="When I_2 = I_3, alpha = pi/4 (sin alpha = cos alpha) satisfies 2.8.1.",
    states=rf"(I_2 = I_3 \land \sin \alpha = \cos \alpha) \Rightarrow {body(equal_moment_equation)}",
    uses=["2.8.1"],
)

expression_is_undefined = exclusion(
    "2.9.3", 278, words="(2.9) has no meaning at I_2 = I_3.", reason="its denominator; the side condition of (2.9)"
)

equal_moments_are_possible = claim(
    "2.9.4",
    282,
    r"J_1 = J_2 = J_3 = \frac{1}{3}(I_1 + I_2 + I_3).",
    words="For every body there are axes about which all three moments are equal (turned about the diagonal (1, 1, -1) by "
    "an angle of cosine u and sine v).",
    states=r"\exists u, v : (u^2 + v^2 = 1 \land J_1 = J_2 = J_3 = \frac{1}{3}(I_1 + I_2 + I_3))",
    where=derivation.turned_about_the_diagonal,
    by=existence(),
    uses=["2.4", "2.7.4", "2.9"],
    notation=turned_letters,
)

turned_axes_are_orthonormal = by_cases.ours(
    "2.9.5",
    282,
    words="The axes of 2.9.4 are orthonormal and right-handed.",
    states=r"\mathbf{A}\mathbf{A}^T = \mathbf{U} \land |\mathbf{A}| = 1",
    given=[Hypothesis("circle", "u and v are a cosine and a sine", "u^2 + v^2 = 1")],
    where=derivation.turned_about_the_diagonal,
    notation=turned_letters,
)

semi_axes_of_an_ellipsoid = premise(
    "2.9.9",
    284,
    words="An ellipsoid has the semi-axes a, b, c; a is also the letter of the direction cosines a_ij, and c that of the mean moment.",
    reason="both letters are introduced anew where they stand, and no relation has one of them in two meanings: c is the "
    "mean moment from line 175 to line 272, and a semi-axis in line 286 only",
)

form_of_the_ellipsoid = ours(
    "2.9.6",
    284,
    words="At the distance d along the axis y_i the form x_1^2/a^2 + x_2^2/b^2 + x_3^2/c^2 of the ellipsoid is J_i d^2, with "
    "1/a^2, 1/b^2, 1/c^2 for the principal moments.",
    states=r"\left(\frac{a_{i1} d}{a}\right)^2 + \left(\frac{a_{i2} d}{b}\right)^2 + \left(\frac{a_{i3} d}{c}\right)^2 = J_i d^2",
    given=[semi_axes],
    where=derivation.reciprocal_squares,
    uses=["1.3.1"],
    notation=ellipsoid_letters,
)

ellipsoid_interpretation = from_lemmas_in_moments.by_cases.claim(
    "2.9.7",
    286,
    r"\frac{1}{d^2} = \frac{1}{3} \left(\frac{1}{a^2} + \frac{1}{b^2} + \frac{1}{c^2} \right).",
    given=[
        orthogonal,
        Hypothesis(
            "points on the ellipsoid", "the axes y_i meet the ellipsoid at the distance d (2.9.6)", "J_i d^2 = 1"
        ),
        semi_axes,
        Hypothesis("distance", "the distance is positive", "d > 0", printed=False),
    ],
    where=derivation.reciprocal_squares,
    uses=["2.9.4", "2.9.6"],
    notation=ellipsoid_letters,
    lemmas=["2.1.7a"],
)

ellipsoid_axes_exist = claim(
    "2.9.8",
    284,
    words="Every ellipsoid with semi-axes a, b, c has orthogonal axes through its centre that meet it at equal distances: "
    "2.9.4 for I_1 = 1/a^2, I_2 = 1/b^2, I_3 = 1/c^2, without triangle inequalities.",
    states=r"\exists u, v : (u^2 + v^2 = 1 \land J_1 = J_2 = J_3)",
    given=[semi_axes],
    where=derivation.ellipsoid_moments,
    by=existence(),
    uses=["2.9.4", "2.9.7"],
    notation=ellipsoid_letters,
)

lower_bound = from_lemmas_in_moments.claim(
    "2.10",
    290,
    r"I_1 I_2 I_3 \leq J_1 J_2 J_3 = f.",
    given=[orthogonal, non_negative_moments],
    by={"a": nonnegative(excess_of_product), "b": identity},
    equality={"a": LOWER_EQUALITY},
    equality_given=[positive_moments, distinct_moments],
    uses=["2.1.5", "2.13.1"],
    lemmas=["2.13.4", "2.0.5", "2.0.6"],
)

squares_are_squared_cofactors = claim(
    "2.11",
    296,
    r"\begin{aligned} a_{21}^2 &= (a_{12}a_{33} - a_{13}a_{32})^2, \\ a_{22}^2 &= (a_{13}a_{31} - a_{11}a_{33})^2, \\ "
    r"a_{23}^2 &= (a_{11}a_{32} - a_{12}a_{31})^2. \end{aligned}",
    given=[orthogonal],
)

square_of_cofactor_step_by_step = claim(
    "2.11.1",
    300,
    r"\begin{aligned} a_{21}^2 &= 1 - a_{11}^2 - a_{31}^2 = a_{12}^2 + a_{13}^2 - a_{31}^2 (a_{11}^2 + a_{12}^2 + a_{13}^2) = \\ "
    r"&= (a_{12}^2 + a_{13}^2)(a_{32}^2 + a_{33}^2) - (a_{12}a_{32} + a_{13}a_{33})^2 = \\ "
    r"&= a_{12}^2 a_{33}^2 + a_{13}^2 a_{32}^2 - 2a_{12}a_{33}a_{13}a_{32} = (a_{12}a_{33} - a_{13}a_{32})^2. \end{aligned}",
    given=[orthogonal],
    uses=["2.7"],
)

other_cofactors = exclusion(
    "2.11.2",
    302,
    words="The other two identities (2.11) are shown likewise.",
    reason="they are decided as 2.11b, 2.11c",
)

product_of_two_moments_step_by_step = claim(
    "2.11.3",
    306,
    r"""\begin{aligned}
 J_1 J_3 &= (I_1 a_{11}^2 + I_2 a_{12}^2 + I_3 a_{13}^2)(I_1 a_{31}^2 + I_2 a_{32}^2 + I_3 a_{33}^2) = \\
 &= I_1^2 a_{11}^2 a_{31}^2 + I_2^2 a_{12}^2 a_{32}^2 + I_3^2 a_{13}^2 a_{33}^2 + I_1 I_2 (a_{11}^2 a_{32}^2 + a_{12}^2 a_{31}^2) + \\
 &+ I_2 I_3 (a_{12}^2 a_{33}^2 + a_{13}^2 a_{32}^2) + I_3 I_1 (a_{13}^2 a_{31}^2 + a_{11}^2 a_{33}^2) = \\
 &= (I_1 a_{11} a_{31} + I_2 a_{12} a_{32} + I_3 a_{13} a_{33})^2 + I_1 I_2 (a_{11} a_{32} - a_{12} a_{31})^2 + \\
 &+ I_2 I_3 (a_{12} a_{33} - a_{13} a_{32})^2 + I_3 I_1 (a_{13} a_{31} - a_{11} a_{33})^2,
 \end{aligned}""",
    uses=["1.3.1"],
)

product_of_axial_moments = claim(
    "2.12",
    316,
    r"J_1 J_3 = (I_1 a_{11} a_{31} + I_2 a_{12} a_{32} + I_3 a_{13} a_{33})^2 "
    r"+ I_1 I_2 a_{23}^2 + I_2 I_3 a_{21}^2 + I_3 I_1 a_{22}^2.",
    given=[orthogonal],
    uses=["2.11", "2.11.3"],
)

product_with_second_moment_step_by_step = claim(
    "2.12.1",
    320,
    r"""\begin{aligned}
 J_2 (I_1 I_2 a_{23}^2 + I_2 I_3 a_{21}^2 + I_3 I_1 a_{22}^2) &= \\
 &= (I_1 a_{21}^2 + I_2 a_{22}^2 + I_3 a_{23}^2)(I_1 I_2 a_{23}^2 + I_2 I_3 a_{21}^2 + I_3 I_1 a_{22}^2) = \\
 &= I_1 I_2 I_3 (a_{21}^4 + a_{22}^4 + a_{23}^4) + \\
 &+ I_1 (I_2^2 + I_3^2) a_{22}^2 a_{23}^2 + I_2 (I_3^2 + I_1^2) a_{23}^2 a_{21}^2 + I_3 (I_1^2 + I_2^2) a_{21}^2 a_{22}^2
 \end{aligned}""",
    uses=["1.3.1"],
)

product_with_second_moment = claim(
    "2.13",
    329,
    r"""\begin{aligned}
 J_2 (I_1 I_2 a_{23}^2 + I_2 I_3 a_{21}^2 + I_3 I_1 a_{22}^2) &= I_1 I_2 I_3 + \\
 &+ I_1 (I_2 - I_3)^2 a_{22}^2 a_{23}^2 + I_2 (I_3 - I_1)^2 a_{23}^2 a_{21}^2 + I_3 (I_1 - I_2)^2 a_{21}^2 a_{22}^2.
 \end{aligned}""",
    given=[orthogonal],
    uses=["2.12.1"],
)

expansion_of_product = claim(
    "2.13.1",
    336,
    r"""\begin{aligned}
 f = J_1 J_2 J_3 &= I_1 I_2 I_3 + \\
 &+ I_1 (I_2 - I_3)^2 a_{22}^2 a_{23}^2 + I_2 (I_3 - I_1)^2 a_{23}^2 a_{21}^2 + I_3 (I_1 - I_2)^2 a_{21}^2 a_{22}^2 + \\
 &+ (I_1 a_{21}^2 + I_2 a_{22}^2 + I_3 a_{23}^2)(I_1 a_{11} a_{31} + I_2 a_{12} a_{32} + I_3 a_{13} a_{33})^2 \geq J_1 J_2 J_3,
 \end{aligned}""",
    given=[orthogonal, non_negative_moments],
    by={"a": identity, "b": identity, "c": nonnegative("0")},
    uses=["2.1.5", "2.12", "2.13"],
    errata={
        "c": Erratum(
            r"I_1 I_2 I_3 + I_1 (I_2 - I_3)^2 a_{22}^2 a_{23}^2 + I_2 (I_3 - I_1)^2 a_{23}^2 a_{21}^2 "
            r"+ I_3 (I_1 - I_2)^2 a_{21}^2 a_{22}^2 + (I_1 a_{21}^2 + I_2 a_{22}^2 + I_3 a_{23}^2)"
            r"(I_1 a_{11} a_{31} + I_2 a_{12} a_{32} + I_3 a_{13} a_{33})^2 \geq I_1 I_2 I_3",
            "wrong letter",
            Origin.UNCERTAIN,
            "As printed the chain says J_1 J_2 J_3 >= J_1 J_2 J_3: true, but empty, an equality for every A. The sentence after "
            "it (2.13.2) and (2.10), which it is to prove, need I_1 I_2 I_3 on the right; J for I may be the author's or the "
            "OCR's.",
            forms=(excess_of_product,),
            summary=r"At the end of the chain stands $I_1 I_2 I_3$: with $J_1 J_2 J_3$ both sides are the same.",
            instead=r"$f = J_1 J_2 J_3 = \dots \geq I_1 I_2 I_3$",
        )
    },
)

product_and_its_excess = ours(
    "2.13.4",
    336,
    words="The same expansion with J_2 for the sum it stands for.",
    states=rf"J_1 J_2 J_3 = I_1 I_2 I_3 + {excess_of_product}",
    given=[orthogonal],
    uses=["2.13.1"],
)

equality_conditions_suffice = from_lemmas_in_moments.claim(
    "2.13.2",
    342,
    words="The inequality f >= I_1 I_2 I_3 is an equality when (2.14) and (2.15) hold together.",
    states=rf"{LOWER_EQUALITY} \Rightarrow (f = I_1 I_2 I_3)",
    given=[orthogonal],
    by=cases(excess_of_product),
    uses=["2.13.1", "2.14", "2.15"],
    lemmas=["2.13.4"],
)

equality_conditions_are_necessary = from_lemmas_in_moments.ours(
    "2.13.3",
    342,
    words="For pairwise distinct positive moments it is an equality only then.",
    states=rf"(f = I_1 I_2 I_3) \Leftrightarrow ({LOWER_EQUALITY})",
    given=[orthogonal, positive_moments, distinct_moments],
    by=cases(excess_of_product),
    uses=["2.13.1", "2.14", "2.15"],
    lemmas=["2.13.4", "2.0.6"],
)

rows_one_and_three_are_orthogonal = claim(
    "2.16", 350, r"a_{11} a_{31} + a_{12} a_{32} + a_{13} a_{33} = 0.", given=[orthogonal]
)

chain_of_inequations = premise(
    "2.16.1",
    352,
    r"I_1 \neq I_2 \neq I_3",
    words="The moments are taken as different; as printed I_1 = I_3 is still allowed (see 2.17).",
)

chain_as_printed = Hypothesis(
    "I_1 != I_2 != I_3 as printed", "I_1 differs from I_2 and I_2 from I_3", body(chain_of_inequations)
)

PRINTED_CASES = r"""\begin{aligned}
 1). \quad a_{11}^2 = a_{22}^2 = a_{33}^2 = 1; & \quad 2). \quad a_{11}^2 = a_{23}^2 = a_{32}^2 = 1; \\
 3). \quad a_{12}^2 = a_{21}^2 = a_{33}^2 = 1; & \quad 4). \quad a_{12}^2 = a_{23}^2 = a_{31}^2 = 1; \\
 5). \quad a_{13}^2 = a_{21}^2 = a_{32}^2 = 1; & \quad 6). \quad a_{13}^2 = a_{22}^2 = a_{31}^2 = 1.
 \end{aligned}"""
SIX_CASES = body(PRINTED_CASES)

six_cases = from_lemmas_in_moments.claim(
    "2.17",
    354,
    PRINTED_CASES,
    words="With (2.14) to (2.16) and I_1 != I_2 != I_3, equality in (2.10) holds exactly in six cases.",
    states=rf"(f = I_1 I_2 I_3) \Leftrightarrow ({SIX_CASES})",
    given=[orthogonal, positive_moments, chain_as_printed],
    by=cases(excess_of_product),
    uses=["2.10", "2.14", "2.15", "2.16", "2.16.1"],
    errata={
        "": Erratum(
            "",
            "missing hypothesis",
            Origin.PAPER,
            "The chain I_1 != I_2 != I_3 does not exclude I_1 = I_3, and then any turn about axis 2 gives equality too. "
            "What is meant, and enough, is that the three moments are pairwise distinct.",
            summary=r"$I_1 \neq I_2 \neq I_3$ does not exclude $I_1 = I_3$, and then every turn about axis 2 gives equality.",
            instead=r"the same, if $I_1, I_2, I_3$ are pairwise distinct",
            needs=(Hypothesis("I_1, I_3 distinct", "I_3 differs from I_1", r"I_3 \neq I_1"),),
        )
    },
    lemmas=["2.13.4", "2.0.6"],
)

six_cases_are_collinear_axes = by_cases.claim(
    "2.17.1",
    360,
    words="In all cases (2.17) each axis y_i is collinear with an axis x_k.",
    states=rf"({SIX_CASES}) \Rightarrow {PARALLEL}",
    given=[orthogonal],
    uses=["2.17"],
)

right_handed_cases = by_cases.claim(
    "2.17.2",
    360,
    r"|\mathbf{A}| = 1",
    words="Of the matrices (2.17) those of right-handed axes must be kept, that is those with |A| = 1.",
    states=r"|\mathbf{A}| = 1 \Leftrightarrow "
    r"(\mathbf{e}_1 = \mathbf{e}_2 \times \mathbf{e}_3 \land \mathbf{e}_2 = \mathbf{e}_3 \times \mathbf{e}_1 \land "
    r"\mathbf{e}_3 = \mathbf{e}_1 \times \mathbf{e}_2)",
    given=[orthogonal],
    uses=["2.17"],
)

selection_is_needed = by_cases.ours(
    "2.17.3",
    360,
    words="The selection is needed: in each of the six cases, with the signs of a row changed, |A| changes its sign; so it is 1 or -1.",
    states=rf"({SIX_CASES}) \Rightarrow |\mathbf{{A}}|^2 = 1 \land |\operatorname{{diag}}(-1, 1, 1)\mathbf{{A}}| = -|\mathbf{{A}}|",
    given=[orthogonal],
    uses=["2.17", "2.17.2"],
)

sum_of_products = from_lemmas_in_moments.claim(
    "2.18",
    364,
    r"J_1L_1 + J_2L_2 + J_3L_3 \geq 3I_1I_2I_3,",
    given=[orthogonal, non_negative_moments],
    by=nonnegative(excess_of_sum),
    equality=PARALLEL,
    equality_given=[positive_moments, distinct_moments],
    uses=["2.19", "2.19.1"],
    lemmas=["2.19.4"],
)

second_order_moments = definition("2.19", 368, r"L_i = I_2I_3a_{i1}^2 + I_3I_1a_{i2}^2 + I_1I_2a_{i3}^2.")

sum_of_products_step_by_step = claim(
    "2.19.1",
    372,
    (
        r"""\begin{aligned}
 \sum_{i=1}^3 J_i L_i &= \sum_{i=1}^3 (I_1 a_{i1}^2 + I_2 a_{i2}^2 + I_3 a_{i3}^2) (I_2 I_3 a_{i1}^2 + I_3 I_1 a_{i2}^2 + I_1 I_2 a_{i3}^2) = \\
 &= I_1 I_2 I_3 \left[(a_{11}^2 + a_{12}^2 + a_{13}^2)^2 - 2(a_{11}^2 a_{12}^2 + a_{12}^2 a_{13}^2 + a_{13}^2 a_{11}^2) + \right. \\
 &\quad + (a_{21}^2 + a_{22}^2 + a_{23}^2)^2 - 2(a_{21}^2 a_{22}^2 + a_{22}^2 a_{23}^2 + a_{23}^2 a_{21}^2) + \\
 &\quad \left. + (a_{31}^2 + a_{32}^2 + a_{33}^2)^2 - 2(a_{31}^2 a_{32}^2 + a_{32}^2 a_{33}^2 + a_{33}^2 a_{31}^2) \right] + \\
 &\quad + I_3 (I_1^2 + I_2^2) (a_{11}^2 a_{12}^2 + a_{21}^2 a_{22}^2 + a_{31}^2 a_{32}^2) + \\
 &\quad + I_1 (I_2^2 + I_3^2) (a_{12}^2 a_{13}^2 + a_{22}^2 a_{23}^2 + a_{32}^2 a_{33}^2) + \\
 &\quad + I_2 (I_3^2 + I_1^2) (a_{13}^2 a_{11}^2 + a_{23}^2 a_{21}^2 + a_{33}^2 a_{31}^2) =
 \end{aligned}""",
        r"\begin{aligned} &= 3I_1I_2I_3 + I_1(I_2 - I_3)^2 (a_{12}^2 a_{13}^2 + a_{22}^2 a_{23}^2 + a_{32}^2 a_{33}^2) + \\ "
        r"&\quad + I_2(I_3 - I_1)^2 (a_{13}^2 a_{11}^2 + a_{23}^2 a_{21}^2 + a_{33}^2 a_{31}^2) + \\ "
        r"&\quad + I_3(I_1 - I_2)^2 (a_{11}^2 a_{12}^2 + a_{21}^2 a_{22}^2 + a_{31}^2 a_{32}^2), \end{aligned}",
    ),
    given=[orthogonal],
    uses=["1.3.1", "2.19"],
    lines={"c": 382},
)

sum_and_its_excess = ours(
    "2.19.4",
    382,
    words="The same expansion as one sum over the rows.",
    states=rf"J_1 L_1 + J_2 L_2 + J_3 L_3 = 3 I_1 I_2 I_3 + {excess_of_sum}",
    given=[orthogonal],
    uses=["2.19.1"],
)

conditions_on_all_rows = premise(
    "2.20",
    386,
    r"a_{i1}a_{i2} = 0, \quad a_{i2}a_{i3} = 0, \quad a_{i3}a_{i1} = 0, \quad i = 1, 2, 3.",
    words="Conditions of equality in (2.18).",
)

row_conditions_suffice = from_lemmas_in_moments.claim(
    "2.19.2",
    384,
    words="(2.18) is an equality when all conditions (2.20) hold.",
    states=rf"{body(conditions_on_all_rows)} \Rightarrow {EQUAL_SUMS}",
    given=[orthogonal],
    by=cases(excess_of_sum),
    uses=["2.18", "2.20"],
    lemmas=["2.19.4"],
)

row_conditions_are_necessary = from_lemmas_in_moments.ours(
    "2.19.3",
    384,
    words="For pairwise distinct positive moments it is an equality only then.",
    states=rf"{EQUAL_SUMS} \Leftrightarrow {body(conditions_on_all_rows)}",
    given=[orthogonal, positive_moments, distinct_moments],
    by=cases(excess_of_sum),
    uses=["2.18", "2.20"],
    lemmas=["2.19.4"],
)

row_conditions_are_the_six_cases = by_cases.claim(
    "2.20.1",
    388,
    words="(2.20) holds only in the cases (2.17).",
    states=rf"{body(conditions_on_all_rows)} \Rightarrow ({SIX_CASES})",
    given=[orthogonal],
    uses=["2.17", "2.20"],
)
