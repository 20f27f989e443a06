r"""Beyond Ignatov 2005: size, roundness and optimal angles of the envelopes in closed form, and what a failure costs.

p = \sin a \sin b, q = \sin a \cos b, r = \cos a stand for the components of the axes of the four-sided pyramid: any three
positive numbers with p^2 + q^2 + r^2 = 1.
"""

from __future__ import annotations

from itertools import combinations

from symcheck.core.claims import Hypothesis
from symcheck.papers.declare import Scope
from symcheck.papers.ignatov2005 import derivation, envelopes
from symcheck.papers.ignatov2005.hypotheses import real_base, real_pyramid
from symcheck.papers.ignatov2005.notation import four_wheels_beyond, six_wheels_beyond, six_wheels_beyond_in_numbers
from symcheck.proof import cases, combined, identity, nonnegative

four = Scope(four_wheels_beyond, by=cases())
four_faces = Scope(four_wheels_beyond, derivation.faces_of_four)
six = Scope(six_wheels_beyond, derivation.six_axes, cases())
six_in_numbers = Scope(six_wheels_beyond_in_numbers, derivation.six_axes, cases())
six_faces = Scope(six_wheels_beyond, derivation.faces_of_six)
OPEN_RANGE = [real_pyramid, real_base]
PQR = r"\sin^2 a \cos a \sin b \cos b"
SQUARE_OF_NORMAL = "n_{{{0}1}}^2 + n_{{{0}2}}^2 + n_{{{0}3}}^2"

# --- four wheels

signs_of_four = four.ours(
    "B.1",
    81,
    words="Each triple product of the axes has one sign over the open range of a and b, so that vertices, edges and faces are the "
    "same for all of them.",
    states=tuple(f"{name} = {value} {PQR}" for name, value in envelopes.triples(envelopes.FOUR)),
    by=identity,
    uses=["2.0.4"],
)

degenerate_four = four.ours(
    "B.2",
    81,
    words="They vanish, all at once, only where a or b is a multiple of 90 degrees: there P is a rhombus (b = 0, b = 90 or a = 90 "
    "degrees) or a segment (a = 0, or two of these).",
    states=tuple(
        rf"{name} = 0 \Leftrightarrow (\sin a = 0 \lor \cos a = 0 \lor \sin b = 0 \lor \cos b = 0)"
        for name, _ in envelopes.triples(envelopes.FOUR)
    ),
    uses=["2.0.4"],
)

volume_of_four = four.ours(
    "B.3",
    81,
    words="The volume of P.",
    states=rf"{envelopes.volume(envelopes.FOUR)} = 128 {PQR}",
    by=identity,
    uses=["B.1"],
)

ABOUT_XY, ABOUT_XZ, ABOUT_YZ = (
    r"(2 \sin a \cos a)^2",
    r"(2 \sin a \cos b)^2 (1 - \sin^2 a \cos^2 b)",
    r"(2 \sin a \sin b)^2 (1 - \sin^2 a \sin^2 b)",
)

surface_of_four = four.ours(
    "B.4",
    81,
    words="Each pair of axes spans two opposite faces, of the area 4 |e_i x e_j|; by these squares of |e_i x e_j| the surface of P is "
    "32 (sin a cos a + sin a cos b sqrt(1 - sin^2 a cos^2 b) + sin a sin b sqrt(1 - sin^2 a sin^2 b)).",
    states=tuple(
        rf"(\mathbf{{e}}_{i} \times \mathbf{{e}}_{j}, \mathbf{{e}}_{i} \times \mathbf{{e}}_{j}) = {value}"
        for i, j, value in (
            (1, 3, ABOUT_XY), (2, 4, ABOUT_XY), (1, 2, ABOUT_XZ), (3, 4, ABOUT_XZ), (1, 4, ABOUT_YZ), (2, 3, ABOUT_YZ),
        )
    ),
    by=identity,
    uses=["2.0.4"],
    
)  # fmt: skip

axes = Hypothesis(
    "axes",
    "p, q, r are the components of unit axes in the open range",
    "p > 0, q > 0, r > 0, p^2 + q^2 + r^2 = 1",
)
moments = Hypothesis("moments", "moments of inertia are positive", "J_x > 0, J_y > 0, J_z > 0", printed=False)
EQUAL_COMPONENTS = "p = q, q = r"

largest_volume_of_four = four.ours(
    "B.5",
    81,
    words="The volume 128 pqr is greatest, 128/(3 sqrt 3), for p = q = r: tg a = sqrt 2 and b = 45 degrees.",
    states="(pqr)^2 \\leq \\frac{1}{27}",
    given=[axes],
    by=nonnegative(
        r"\frac{1}{54} (p^2 - q^2)^2 + \frac{1}{54} (q^2 - r^2)^2 + \frac{1}{54} (r^2 - p^2)^2"
        r" + \frac{1}{9} p^2 (q^2 - r^2)^2 + \frac{1}{9} q^2 (r^2 - p^2)^2 + \frac{1}{9} r^2 (p^2 - q^2)^2"
    ),
    equality=EQUAL_COMPONENTS,
    uses=["B.3"],
)

optimal_angles_of_four = four.ours(
    "B.6",
    81,
    words="In the angles p^2 = q^2 = r^2 is tg^2 b = 1, tg^2 a = 2.",
    states=r"(\sin^2 a \sin^2 b = \sin^2 a \cos^2 b \land \sin^2 a \cos^2 b = \cos^2 a) \Leftrightarrow "
    r"(\sin^2 b = \cos^2 b \land \sin^2 a = 2 \cos^2 a)",
)
HALF_SPACES = {  # of a face: a normal, its product with H at the face, the wheels at the limit 1 and at the limit -1
    r"(\cos b, \sin b, 0)": (r"4 \sin a \sin b \cos b", (2, 4), ()),
    r"(\cos b, -\sin b, 0)": (r"4 \sin a \sin b \cos b", (1, 3), ()),
    r"(\cos a, 0, \sin a \sin b)": (r"4 \sin a \cos a \sin b", (3, 4), ()),
    r"(\cos a, 0, -\sin a \sin b)": (r"4 \sin a \cos a \sin b", (1, 2), ()),
    r"(0, \cos a, \sin a \cos b)": (r"4 \sin a \cos a \cos b", (4,), (1,)),
    r"(0, \cos a, -\sin a \cos b)": (r"4 \sin a \cos a \cos b", (2,), (3,)),
}


def _excess(value: str, upper: tuple[int, ...], lower: tuple[int, ...]) -> str:
    """What a point of P is short of a face."""
    terms = [f"(1 - h_{i})" for i in upper] + [f"(1 + h_{i})" for i in lower]
    return " + ".join(rf"\frac{{1}}{{2}} \cdot {value} {term}" for term in terms)


half_spaces_of_four = four.ours(
    "B.7",
    111,
    words="P lies between the planes |H_x|/p + |H_y|/q = 4, |H_x|/p + |H_z|/r = 4 and |H_y|/q + |H_z|/r = 4, one for each face; it "
    "reaches them where two wheels are at their limits (the opposite faces by symmetry).",
    states=tuple(rf"({normal}, [h_1, h_2, h_3, h_4]) \leq {value}" for normal, (value, _, _) in HALF_SPACES.items()),
    given=[
        *OPEN_RANGE,
        Hypothesis("limits", "no wheel exceeds its limit", r"-1 \leq h_i, h_i \leq 1"),
    ],
    by={letter: nonnegative(_excess(*face)) for letter, face in zip("abcdef", HALF_SPACES.values(), strict=True)},
    equality={
        letter: ", ".join([*(f"h_{i} = 1" for i in upper), *(f"h_{i} = -1" for i in lower)])
        for letter, (_, upper, lower) in zip("abcdef", HALF_SPACES.values(), strict=True)
    },
    uses=["2.0.4", "2.1.3"],
)

half_spaces_are_enough = four.ours(
    "B.8",
    111,
    words="These planes bound P and nothing else does: h + t (1, -1, -1, 1) gives the same H for every t, some t keeps two wheels "
    "within their limits exactly if |h_2 + h_4| <= 2 and so on, that is between two of the planes, and intervals for t of which "
    "every two meet all meet.",
    states=(
        "[h_1 + t, h_2 - t, h_3 - t, h_4 + t] = [h_1, h_2, h_3, h_4]",
        *(
            rf"({normal}, [h_1, h_2, h_3, h_4]) = \frac{{1}}{{2}} \cdot {value} "
            f"({' + '.join([*(f'h_{i}' for i in upper), *(f'(-h_{i})' for i in lower)])})"
            for normal, (value, upper, lower) in HALF_SPACES.items()
        ),
    ),
    by=identity,
    uses=["B.7"],
)

NORMAL_FACES = (("p", "q", "r"), ("p", "r", "q"), ("q", "r", "p"))
ball = Hypothesis(
    "ball",
    "R is no greater than the distances 4pq/sqrt(p^2 + q^2), 4pr/sqrt(p^2 + r^2), 4qr/sqrt(q^2 + r^2) of the faces",
    "R > 0, " + ", ".join(f"R^2 ({x}^2 + {y}^2) \\leq 16 {x}^2 {y}^2" for x, y, _ in NORMAL_FACES),
)
ROOM = " + ".join(rf"\frac{{1}}{{2}} {z}^2 (16 {x}^2 {y}^2 - R^2 ({x}^2 + {y}^2))" for x, y, z in NORMAL_FACES)
SPREAD = " + ".join(rf"\frac{{8}}{{3}} {z}^2 ({x}^2 - {y}^2)^2" for x, y, z in NORMAL_FACES)

largest_ball_in_four = four.ours(
    "B.9",
    177,
    words="A ball inside P has the radius sqrt(8/3) = 1.633 at most, at the angles of B.6 only.",
    states=r"R^2 \leq \frac{8}{3}",
    given=[axes, ball],
    by=combined(
        nonnegative(rf"\frac{{{ROOM} + {SPREAD}}}{{p^2 q^2 + q^2 r^2 + r^2 p^2}}"), forms=[f"{ROOM} + {SPREAD}"]
    ),
    equality=f"{EQUAL_COMPONENTS}, R^2 (p^2 + q^2) = 16 p^2 q^2",
    uses=["B.7"],
)

distances_of_four = four_faces.ours(
    "B.10",
    177,
    words="The distances (n, H)/|n| of the three kinds of faces, F_3, F_5 and F_4: 16 p^2 q^2/(p^2 + q^2) and so on, squared.",
    states=(
        rf"s_1^2 \sin^2 a = 16 (\sin a \sin b)^2 (\sin a \cos b)^2 ({SQUARE_OF_NORMAL.format(1)})",
        rf"s_2^2 (\sin^2 a \sin^2 b + \cos^2 a) = 16 (\sin a \sin b)^2 \cos^2 a ({SQUARE_OF_NORMAL.format(2)})",
        rf"s_3^2 (\sin^2 a \cos^2 b + \cos^2 a) = 16 (\sin a \cos b)^2 \cos^2 a ({SQUARE_OF_NORMAL.format(3)})",
    ),
    uses=["2.0.4"],
)

PRODUCT_BOUND = " + ".join(
    (
        r"32 (16 - A_x^2 - A_y^2)",
        r"2 (A_x^2 + A_y^2) (16 - A_x^2 - A_z^2)",
        r"\frac{1}{8} (A_x^2 + A_y^2) (A_x^2 + A_z^2) (16 - A_y^2 - A_z^2)",
        r"\frac{1}{8} A_x^2 (A_y^2 - A_z^2)^2",
        r"\frac{1}{8} A_y^2 (A_z^2 - A_x^2)^2",
        r"\frac{1}{8} A_z^2 (A_x^2 - A_y^2)^2",
    )
)

largest_ellipsoid_in_four = four.ours(
    "B.11",
    177,
    words="Of the ellipsoids in P with the semi-axes p A_x, q A_y, r A_z along OX, OY, OZ (B.15) the largest has A_x = A_y = A_z = sqrt 8.",
    states=r"(A_x A_y A_z)^2 \leq 512",
    given=[
        Hypothesis(
            "inside",
            "the ellipsoid is inside P",
            r"A_x^2 + A_y^2 \leq 16, A_x^2 + A_z^2 \leq 16, A_y^2 + A_z^2 \leq 16",
        ),
    ],
    by=nonnegative(PRODUCT_BOUND),
    equality="A_x^2 = 8, A_y^2 = 8, A_z^2 = 8",
    uses=["B.15"],
)

roundness_of_four = four.ours(
    "B.12",
    177,
    words="It fills the part pi sqrt 2/6 = 0.740 of P, whatever the angles are.",
    states=(
        r"\frac{4\pi}{3} \cdot \sqrt{512} pqr = \frac{\pi \sqrt{2}}{6} \cdot 128 pqr",
        r"\frac{\pi \sqrt{2}}{6} \approx 0.740",
    ),
    uses=["B.3", "B.11"],
)


def rest(axes: tuple[tuple[int, int, int], ...], failed: int) -> str:
    """How much of its distance from the centre each face keeps when a wheel has failed."""
    return r" \land ".join(
        rf"{after} = \frac{{{ratio.numerator}}}{{{ratio.denominator}}} ({before})"
        for after, before, ratio in envelopes.ratios(axes, failed)
    )


failures_of_four = four.ours(
    "B.13",
    195,
    words="Whichever wheel fails, the volume falls to a quarter (to 32 sin^2 a cos a sin b cos b), and every face that is left comes to "
    "half its distance: what is left of P holds P/2, the inscribed ball is half as large, no angles make it better.",
    states=tuple(
        rf"{envelopes.volume(envelopes.FOUR, k)} = \frac{{1}}{{4}} \cdot {envelopes.volume(envelopes.FOUR)} "
        rf"\land {rest(envelopes.FOUR, k)}"
        for k in (1, 2, 3, 4)
    ),
    uses=["B.1", "B.3"],
)

ELLIPSOID = Hypothesis(
    "ellipsoid",
    "(1.2): the region required is the ellipsoid with semi-axes J_x w_x, J_y w_y, J_z w_z",
    "J_x > 0, J_y > 0, J_z > 0, w_x > 0, w_y > 0, w_z > 0",
)
EXTENT = "(J_x w_x n_1)^2 + (J_y w_y n_2)^2 + (J_z w_z n_3)^2"

ellipsoid_in_half_space = four.ours(
    "B.14",
    250,
    words="For H on the ellipsoid (1.2), with components J_x w_x u_x and so on, (n, H)^2 is (J_x w_x n_1)^2 + (J_y w_y n_2)^2 + "
    "(J_z w_z n_3)^2 at most, and it is that at one point and the opposite one.",
    states=(
        rf"(J_x w_x n_1 u_x + J_y w_y n_2 u_y + J_z w_z n_3 u_z)^2 \leq {EXTENT}",
        rf"(t^2 = {EXTENT} \land t > 0 \land t u_x = J_x w_x n_1 \land t u_y = J_y w_y n_2 \land t u_z = J_z w_z n_3) "
        r"\Rightarrow J_x w_x n_1 u_x + J_y w_y n_2 u_y + J_z w_z n_3 u_z = t",
    ),
    given=[Hypothesis("sphere", "u is a unit vector", "u_x^2 + u_y^2 + u_z^2 = 1")],
    by={
        "a": nonnegative(
            "(J_x w_x n_1 u_y - J_y w_y n_2 u_x)^2 + (J_y w_y n_2 u_z - J_z w_z n_3 u_y)^2 "
            "+ (J_z w_z n_3 u_x - J_x w_x n_1 u_z)^2"
        ),
        "b": cases(),
    },
    equality={
        "a": "J_x w_x n_1 u_y = J_y w_y n_2 u_x, J_y w_y n_2 u_z = J_z w_z n_3 u_y, J_z w_z n_3 u_x = J_x w_x n_1 u_z"
    },
    uses=["1.2"],
)


def room(face: int) -> str:
    """What a face is further from the centre than the ellipsoid reaches, squared and times the square of its normal."""
    terms = (f"(J_{x} w_{x} n_{{{face}{k}}})^2" for k, x in enumerate("xyz", 1))
    return f"s_{face}^2 - {' - '.join(terms)}"


condition_for_four = four_faces.ours(
    "B.15",
    250,
    words="So (1.1) holds for the ellipsoid (1.2) exactly if J_x^2 w_x^2/p^2 + J_y^2 w_y^2/q^2 <= 16 and the same for x, z and for y, z: "
    "one condition for each kind of face, F_3, F_5, F_4.",
    states=(
        rf"{room(1)} = (2 \sin a \cos a)^2 "
        r"(16 \sin^2 a \sin^2 b \cos^2 b - (J_x w_x)^2 \cos^2 b - (J_y w_y)^2 \sin^2 b)",
        rf"{room(2)} = (2 \sin a \cos b)^2 "
        r"(16 \sin^2 a \cos^2 a \sin^2 b - (J_x w_x)^2 \cos^2 a - (J_z w_z)^2 \sin^2 a \sin^2 b)",
        rf"{room(3)} = (2 \sin a \sin b)^2 "
        r"(16 \sin^2 a \cos^2 a \cos^2 b - (J_y w_y)^2 \cos^2 a - (J_z w_z)^2 \sin^2 a \cos^2 b)",
    ),
    uses=["B.14", "1.1"],
)

equal_rates = four.ours(
    "B.16",
    256,
    words="At the vertices on the axes the rates about OX, OY, OZ are equal (p : q : r = J_x : J_y : J_z) for tg b = J_x/J_y and "
    "tg a = sqrt(J_x^2 + J_y^2)/J_z, and only there.",
    states=r"(J_y \sin a \sin b = J_x \sin a \cos b \land J_z^2 \sin^2 a \cos^2 b = J_y^2 \cos^2 a) \Leftrightarrow "
    r"(J_y \sin b = J_x \cos b \land J_z^2 \sin^2 a = (J_x^2 + J_y^2) \cos^2 a)",
    given=[real_pyramid, moments],
    uses=["2.3"],
)

rate_about_the_axes = four.ours(
    "B.17",
    256,
    words="There the rate about each of the three axes is 4 h_max/sqrt(J_x^2 + J_y^2 + J_z^2): 0.00195 for the moments of the paper, at "
    "b = 32.0 and a = 67.0 degrees.",
    states=(
        r"(w J_x = 4p \land w J_y = 4q \land w J_z = 4r) \Rightarrow w^2 (J_x^2 + J_y^2 + J_z^2) = 16",
        r"\frac{4}{\sqrt{1000^2 + 1600^2 + 800^2}} \approx 0.00195",
        r"\arctg \frac{1000}{1600} \approx 32.0^\circ",
        r"\tan^2 66.95^\circ < \frac{1000^2 + 1600^2}{800^2} < \tan^2 67.05^\circ",
    ),
    given=[axes],
    uses=["B.16"],
)

PLANES = (("x", "y", "p", "q"), ("x", "z", "p", "r"), ("y", "z", "q", "r"))
rate_about_any_axis = Hypothesis(
    "rate about any axis",
    "the body can turn with the rate w about every axis: the ellipsoid with semi-axes J_x w, J_y w, J_z w is inside P (B.15)",
    "w > 0, " + ", ".join(f"w^2 (J_{i}^2 {y}^2 + J_{j}^2 {x}^2) \\leq 16 {x}^2 {y}^2" for i, j, x, y in PLANES),
)


# What the faces leave, each times p^2 q^2 r^2 and twice the sum of the squares of the moments.
BALANCED = " + ".join(
    rf"(J_{i}^2 + J_{j}^2 - J_{k}^2)(16 {x}^2 {y}^2 - w^2 (J_{i}^2 {y}^2 + J_{j}^2 {x}^2)) {z}^2 "
    rf"+ 2 w^2 (J_{i}^2 {y}^2 - J_{j}^2 {x}^2)^2 {z}^2"
    for (i, j, x, y), k, z in zip(PLANES, "zyx", "rqp", strict=True)
)

fastest_of_balanced_bodies = four.ours(
    "B.18",
    264,
    words="A rate about every axis, whatever its direction: at the angles of B.16 w = sqrt 8/sqrt(J_x^2 + J_y^2 + J_z^2), and no angles "
    "give more if J_x^2, J_y^2, J_z^2 satisfy the triangle inequalities.",
    states=r"w^2 (J_x^2 + J_y^2 + J_z^2) \leq 8",
    given=[
        axes,
        moments,
        rate_about_any_axis,
        Hypothesis(
            "balanced",
            "the squares of the moments satisfy the triangle inequalities",
            r"J_x^2 + J_y^2 \geq J_z^2, J_y^2 + J_z^2 \geq J_x^2, J_z^2 + J_x^2 \geq J_y^2",
        ),
    ],
    by=combined(nonnegative(rf"\frac{{{BALANCED}}}{{2 p^2 q^2 r^2 (J_x^2 + J_y^2 + J_z^2)}}"), forms=(BALANCED,)),
    equality="w^2 (J_x^2 + J_y^2 + J_z^2) = 8, J_x^2 q^2 = J_y^2 p^2, J_x^2 r^2 = J_z^2 p^2",
    uses=["B.15"],
)

balanced_bodies_reach_it = four.ours(
    "B.19",
    264,
    words="At the angles of B.16, whatever the moments are, this w reaches all faces at once.",
    states=r"(J_y p = J_x q \land J_z q = J_y r \land w^2 (J_x^2 + J_y^2 + J_z^2) = 8) \Rightarrow ("
    + r" \land ".join(f"w^2 (J_{i}^2 {y}^2 + J_{j}^2 {x}^2) = 16 {x}^2 {y}^2" for i, j, x, y in PLANES)
    + ")",
    given=[axes],
    uses=["B.15"],
)

root_of_moments = Hypothesis("S", "S is the square root of J_x^2 + J_z^2", "S > 0, S^2 = J_x^2 + J_z^2")

UNBALANCED = (
    "J_x^2 (16 p^2 q^2 - w^2 (J_x^2 q^2 + J_y^2 p^2)) r^2 + J_z^2 (16 q^2 r^2 - w^2 (J_y^2 r^2 + J_z^2 q^2)) p^2 "
    "+ w^2 (J_x^2 r^2 - J_z^2 p^2)^2 q^2 + w^2 (J_x^2 q^2 - S J_y p^2)^2 r^2 + w^2 (J_z^2 q^2 - S J_y r^2)^2 p^2"
)

fastest_of_unbalanced_bodies = four.ours(
    "B.20",
    264,
    words="With S = sqrt(J_x^2 + J_z^2) also w <= 4/(J_y + S) always.",
    states=r"w^2 (J_y + S)^2 \leq 16",
    given=[axes, rate_about_any_axis, root_of_moments],
    by=combined(nonnegative(rf"\frac{{{UNBALANCED}}}{{S^2 p^2 q^2 r^2}}"), forms=(UNBALANCED,)),
    equality="w^2 (J_y + S)^2 = 16, J_x^2 r^2 = J_z^2 p^2, J_x^2 q^2 = S J_y p^2, J_z^2 q^2 = S J_y r^2",
    uses=["B.15"],
)

P2, Q2, R2 = r"\frac{J_x^2}{S (J_y + S)}", r"\frac{J_y}{J_y + S}", r"\frac{J_z^2}{S (J_y + S)}"
RATE2 = r"\frac{16}{(J_y + S)^2}"

best_angles_of_unbalanced_bodies = four.ours(
    "B.21",
    264,
    words="If J_y >= S, as the moments of the paper have it, this bound is reached, at p^2 = J_x^2/(S (J_y + S)), q^2 = J_y/(J_y + S), "
    "r^2 = J_z^2/(S (J_y + S)): tg b = J_x/sqrt(S J_y), tg a = sqrt(J_x^2 + S J_y)/J_z, not at the angles of the paper.",
    states=(
        f"{P2} + {Q2} + {R2} = 1",
        f"{RATE2} (J_x^2 {Q2} + J_y^2 {P2}) = 16 {P2} {Q2}",
        f"{RATE2} (J_z^2 {Q2} + J_y^2 {R2}) = 16 {R2} {Q2}",
        rf"{RATE2} (J_x^2 {R2} + J_z^2 {P2}) \leq 16 {P2} {R2}",
        rf"{P2} J_y S = J_x^2 {Q2}",
        rf"({P2} + {Q2}) J_z^2 = {R2} (J_x^2 + S J_y)",
    ),
    given=[moments, root_of_moments, Hypothesis("unbalanced", "J_y is the greatest by far", r"J_y \geq S")],
    by={
        **dict.fromkeys("abcef", identity),
        "d": nonnegative(r"\frac{16 J_x^2 J_z^2 (J_y - S)}{S^2 (J_y + S)^3}"),
    },
    equality={"d": "J_y = S"},
    uses=["B.15", "B.20"],
)

best_angles_in_numbers = four.ours(
    "B.22",
    264,
    words="For the moments of the paper: w = 0.0013886 at b = 34.9 and a = 65.4 degrees, against sqrt 8/sqrt(J_x^2 + J_y^2 + J_z^2) = "
    "0.0013801 at the angles of the paper.",
    states=(
        r"1600 > \sqrt{1000^2 + 800^2}",
        r"\frac{4}{1600 + \sqrt{1000^2 + 800^2}} \approx 0.0013886",
        r"\frac{\sqrt{8}}{\sqrt{1000^2 + 1600^2 + 800^2}} \approx 0.0013801",
        r"\tan^2 34.85^\circ < \frac{1000^2}{1600 \sqrt{1000^2 + 800^2}} < \tan^2 34.95^\circ",
        r"\tan^2 65.35^\circ < \frac{1000^2 + 1600 \sqrt{1000^2 + 800^2}}{800^2} < \tan^2 65.45^\circ",
    ),
    uses=["B.18", "B.21"],
)

# --- six wheels

SIX = envelopes.SIX

signs_of_six = six.ours(
    "B.23",
    289,
    words="Each triple product of the axes has one sign over the open range of a, so that vertices, edges and faces are the same for "
    "all of them.",
    states=tuple(
        rf"{name} = \frac{{{value} \sqrt{{3}}}}{{4}} \sin^2 a \cos a" for name, value in envelopes.triples(SIX)
    ),
    by=identity,
)

degenerate_six = six.ours(
    "B.24",
    289,
    words="They vanish, all at once, only where a is a multiple of 90 degrees: there P is a segment (a = 0) or a regular hexagon.",
    states=r" \land ".join(
        rf"({name} = 0 \Leftrightarrow (\sin a = 0 \lor \cos a = 0))" for name, _ in envelopes.triples(SIX)
    ),
)

volume_of_six = six.ours(
    "B.25",
    289,
    words="The volume of P.",
    states=rf"{envelopes.volume(SIX)} = 144 \sqrt{{3}} \sin^2 a \cos a",
    by=identity,
    uses=["B.23"],
)

surface_of_six = six.ours(
    "B.26",
    289,
    words="Each pair of axes spans two opposite faces, of the area 4 |e_i x e_j|; by these squares of |e_i x e_j| the surface of P is "
    "48 sin a (sqrt(1 - sin^2 a/4) + sqrt 3 sqrt(1 - 3 sin^2 a/4) + cos a).",
    states=tuple(
        r" \land ".join(
            rf"(\mathbf{{e}}_{i} \times \mathbf{{e}}_{j}, \mathbf{{e}}_{i} \times \mathbf{{e}}_{j}) = {value}"
            for i, j in combinations(range(1, 7), 2)
            if min(j - i, 6 - j + i) == steps
        )
        for steps, value in (
            (1, r"\sin^2 a (1 - \frac{1}{4} \sin^2 a)"),
            (2, r"3 \sin^2 a (1 - \frac{3}{4} \sin^2 a)"),
            (3, r"4 \sin^2 a \cos^2 a"),
        )
    ),
)

largest_volume_of_six = six.ours(
    "B.27",
    289,
    words="The volume is greatest, 96, for tg a = sqrt 2, as that of four wheels is (B.6).",
    states=r"(144 \sqrt{3} \sin^2 a \cos a)^2 \leq 96^2",
    by=nonnegative(r"2304 (1 - 3 \cos^2 a)^2 + 6912 \sin^2 a (1 - 3 \cos^2 a)^2"),
    equality=r"3 \cos^2 a = 1",
    uses=["B.25"],
)

DISTANCES_OF_SIX = (  # of the kinds of faces F_1, F_7, F_13: (top, bottom) of the square of the distance
    (r"108 \sin^2 a \cos^2 a", r"(3 + \cos^2 a)"),
    (r"64 \sin^2 a \cos^2 a", r"(1 + 3 \cos^2 a)"),
    (r"12 \sin^2 a", ""),
)

distances_of_six = six_faces.ours(
    "B.28",
    464,
    words="The squares of the distances (n, H)/|n| of the faces F_6, F_1, F_7, F_8, F_13, F_15: 108 sin^2 a cos^2 a/(3 + cos^2 a), "
    "64 sin^2 a cos^2 a/(1 + 3 cos^2 a) and 12 sin^2 a.",
    states=tuple(
        rf"s_{face}^2 {bottom} = {top} ({SQUARE_OF_NORMAL.format(face)})"
        for face, (top, bottom) in enumerate([each for each in DISTANCES_OF_SIX for _ in (1, 2)], 1)
    ),
)

nearest_faces_of_six = six.ours(
    "B.29",
    464,
    words="Nearest are faces of the kind F_1 for cos^2 a up to 21/65, of the kind F_7 from there to 3/7, and of the kind F_13 beyond.",
    states=(
        r"\frac{108 \sin^2 a \cos^2 a}{3 + \cos^2 a} \leq \frac{64 \sin^2 a \cos^2 a}{1 + 3 \cos^2 a} "
        r"\Leftrightarrow \cos^2 a \leq \frac{21}{65}",
        r"\frac{64 \sin^2 a \cos^2 a}{1 + 3 \cos^2 a} \leq 12 \sin^2 a \Leftrightarrow \cos^2 a \leq \frac{3}{7}",
    ),
    given=[real_pyramid],
    uses=["B.28"],
)

ball_in_six = Hypothesis(
    "ball",
    "R is no greater than the distances of the faces (B.28)",
    "R > 0, " + ", ".join(rf"R^2 {bottom} \leq {top}" for top, bottom in DISTANCES_OF_SIX),
)
ROOM_OF_SIX = r"9 (64 \sin^2 a \cos^2 a - R^2 (1 + 3 \cos^2 a)) + 64 (1 - 3 \cos^2 a)^2"

largest_ball_in_six = six.ours(
    "B.30",
    464,
    words="A ball inside P has the radius 8/3 at most, for tg a = sqrt 2 only: the angle that is best for four wheels too (B.9).",
    states=r"R^2 \leq \frac{64}{9}",
    given=[ball_in_six],
    by=combined(nonnegative(rf"\frac{{{ROOM_OF_SIX}}}{{9 (1 + 3 \cos^2 a)}}"), forms=[ROOM_OF_SIX]),
    equality=r"3 \cos^2 a = 1, R^2 (1 + 3 \cos^2 a) = 64 \sin^2 a \cos^2 a",
    uses=["B.28"],
)

largest_ball_fits = six.ours(
    "B.31",
    464,
    words="That ball is inside P.",
    states=r"3 \cos^2 a = 1 \Rightarrow ("
    + r" \land ".join(rf"\frac{{64}}{{9}} {bottom} \leq {top}" for top, bottom in DISTANCES_OF_SIX)
    + ")",
    uses=["B.30"],
)

SLACK = (r"(64 - 3 A_x^2 - A_y^2 - A_z^2)", r"(64 - 4 A_y^2 - A_z^2)")  # of the faces F_7 and F_8
MEAN = r"(A_x^2 + A_y^2 + \frac{1}{2} A_z^2)"
TO_CUBE = rf"(1024 + 32 {MEAN} + {MEAN}^2)"
UNEQUAL = ("(A_x^2 - A_y^2)^2", r"(A_y^2 - \frac{1}{2} A_z^2)^2", r"(\frac{1}{2} A_z^2 - A_x^2)^2")
CONDITIONS_OF_SIX = (  # of an ellipsoid with semi-axes A_x sin a, A_y sin a, A_z cos a, by B.38
    r"A_x^2 + \frac{3}{4} A_z^2 \leq 27",
    r"\frac{1}{4} A_x^2 + \frac{3}{4} A_y^2 + \frac{3}{4} A_z^2 \leq 27",
    r"3 A_x^2 + A_y^2 + A_z^2 \leq 64",
    r"4 A_y^2 + A_z^2 \leq 64",
    r"A_x^2 \leq 12",
    r"\frac{1}{4} A_x^2 + \frac{3}{4} A_y^2 \leq 12",
)

largest_ellipsoid_in_six = six.ours(
    "B.32",
    464,
    words="Of the ellipsoids in P with the semi-axes A_x sin a, A_y sin a, A_z cos a along OX, OY, OZ (B.38) the largest has "
    "A_x^2 = A_y^2 = 32/3, A_z^2 = 64/3.",
    states=r"(A_x A_y A_z)^2 \leq \frac{65536}{27}",
    given=[Hypothesis("inside", "the ellipsoid is inside P", ", ".join(CONDITIONS_OF_SIX))],
    by=nonnegative(
        " + ".join(
            (
                rf"\frac{{2}}{{81}} {SLACK[0]} {TO_CUBE}",
                rf"\frac{{1}}{{81}} {SLACK[1]} {TO_CUBE}",
                *(rf"\frac{{1}}{{27}} {MEAN} {each}" for each in UNEQUAL),
                rf"\frac{{1}}{{9}} A_z^2 {UNEQUAL[0]}",
                rf"\frac{{2}}{{9}} A_x^2 {UNEQUAL[1]}",
                rf"\frac{{2}}{{9}} A_y^2 {UNEQUAL[2]}",
            )
        )
    ),
    equality=r"A_x^2 = \frac{32}{3}, A_y^2 = \frac{32}{3}, A_z^2 = \frac{64}{3}",
    uses=["B.38"],
)

largest_ellipsoid_fits = six.ours(
    "B.33",
    464,
    words="That ellipsoid is inside P.",
    states=r"(A_x^2 = \frac{32}{3} \land A_y^2 = \frac{32}{3} \land A_z^2 = \frac{64}{3}) \Rightarrow ("
    + r" \land ".join(CONDITIONS_OF_SIX)
    + ")",
    uses=["B.32"],
)

roundness_of_six = six.ours(
    "B.34",
    464,
    words="It fills the part 64 pi/243 = 0.827 of P, whatever the angle is.",
    states=(
        r"\frac{4\pi}{3} \cdot \sqrt{\frac{65536}{27}} \sin^2 a \cos a = \frac{64\pi}{243} \cdot 144 \sqrt{3} \sin^2 a \cos a",
        r"\frac{64\pi}{243} \approx 0.827",
    ),
    uses=["B.25", "B.32"],
)

failures_of_six = six.ours(
    "B.35",
    481,
    words="Whichever wheel fails, the volume falls to a half (to 72 sqrt 3 sin^2 a cos a), and the faces that are left come to 5/8, 2/3, "
    "3/4, 5/6 or 7/8 of their distances: what is left of P holds 5/8 of it. It is 5/8 for faces of the kind F_7, so that the inscribed "
    "ball keeps 5/8 of its radius exactly where those are nearest (B.29), as they are at tg a = sqrt 2.",
    states=tuple(
        rf"{envelopes.volume(SIX, k)} = \frac{{1}}{{2}} \cdot {envelopes.volume(SIX)} \land {rest(SIX, k)}"
        for k in range(1, 7)
    ),
    uses=["B.23", "B.25"],
)

less_sensitive_to_failures = six.ours(
    "B.36",
    610,
    words="So six wheels are less sensitive to a failure than four: a half of the volume is left, not a quarter, and a region similar to "
    "P of 5/8 its size, not of 1/2; five wheels at tg a = sqrt 2 still hold the ball of radius 5/3, three hold sqrt(2/3) at most.",
    states=(
        r"\frac{1}{2} > \frac{1}{4}",
        r"\frac{5}{8} > \frac{1}{2}",
        r"\frac{5}{8} \cdot \frac{8}{3} = \frac{5}{3}",
        r"\frac{1}{2} \sqrt{\frac{8}{3}} = \sqrt{\frac{2}{3}}",
    ),
    uses=["B.9", "B.13", "B.30", "B.35"],
)

nearer_to_an_ellipsoid = six.ours(
    "B.37",
    610,
    words="And nearer to an ellipsoid: the largest one along the axes fills 64 pi/243 of the region of six wheels, pi sqrt 2/6 of that of "
    "four; no angle changes either.",
    states=r"\frac{64\pi}{243} > \frac{\pi \sqrt{2}}{6}",
    uses=["B.12", "B.34"],
)


def semi_axes(x: str, y: str, z: str) -> str:
    """A combination of the squares of the semi-axes J_x w_x, J_y w_y, J_z w_z, without what is absent."""
    factors = zip((x, y, z), "xyz", strict=True)
    return " + ".join(f"{factor} (J_{k} w_{k})^2" for factor, k in factors if factor)


SIN2, COS2, HALF, QUARTER, MOST = r"\sin^2 a", r"\cos^2 a", r"\frac{1}{2}", r"\frac{1}{4}", r"\frac{3}{4}"
EXTENTS = (  # what has to be no greater than the number times sin^2 a cos^2 a, and times what that is the room of the face
    (27, semi_axes(COS2, "", f"{MOST} {SIN2}"), SIN2),
    (27, semi_axes(f"{QUARTER} {COS2}", f"{MOST} {COS2}", f"{MOST} {SIN2}"), SIN2),
    (16, semi_axes(f"{MOST} {COS2}", f"{QUARTER} {COS2}", f"{QUARTER} {SIN2}"), f"3 {SIN2}"),
    (16, semi_axes("", COS2, f"{QUARTER} {SIN2}"), f"3 {SIN2}"),
    (12, semi_axes(COS2, "", ""), f"4 {SIN2}"),
    (12, semi_axes(f"{QUARTER} {COS2}", f"{MOST} {COS2}", ""), f"4 {SIN2}"),
)
EXTENTS_FIT = r" \land ".join(rf"{extent} \leq {number} \sin^2 a \cos^2 a" for number, extent, _ in EXTENTS)

condition_for_six = six_faces.ours(
    "B.38",
    612,
    words="(1.1) holds for the ellipsoid (1.2) exactly if six conditions hold, of the faces F_6, F_1, F_7, F_8, F_13, F_15 (the others "
    "are their mirror images): what is in brackets is not negative.",
    states=tuple(
        rf"{room(face)} = {factor} ({number} \sin^2 a \cos^2 a - ({extent}))"
        for face, (number, extent, factor) in enumerate(EXTENTS, 1)
    ),
    uses=["B.14", "B.28", "1.1"],
)
BINDING = r"(16 \sin^2 a \cos^2 a - w^2 (J_y^2 \cos^2 a + \frac{1}{4} J_z^2 \sin^2 a))"
FASTEST = rf"4 {BINDING} + w^2 (2 J_y \cos^2 a - J_z \sin^2 a)^2"

fastest_with_six = six.ours(
    "B.39",
    618,
    words="A rate w about every axis, whatever its direction: by F_8 alone w (2 J_y + J_z) <= 8, reached for tg^2 a = 2 J_y/J_z at most.",
    states=r"w^2 (2 J_y + J_z)^2 \leq 64",
    given=[
        real_pyramid,
        Hypothesis(
            "rate about any axis",
            "the condition of the face F_8 for the semi-axes J_x w, J_y w, J_z w (B.38)",
            r"w > 0, w^2 (J_y^2 \cos^2 a + \frac{1}{4} J_z^2 \sin^2 a) \leq 16 \sin^2 a \cos^2 a",
        ),
    ],
    by=combined(nonnegative(rf"\frac{{{FASTEST}}}{{\sin^2 a \cos^2 a}}"), forms=[FASTEST]),
    equality=r"2 J_y \cos^2 a = J_z \sin^2 a, w^2 (2 J_y + J_z)^2 = 64",
    uses=["B.38"],
)

best_angle_of_six = six_in_numbers.ours(
    "B.40",
    618,
    words="For the moments of the paper all six conditions hold there: w = 0.002 at tg a = 2, a = 63.4 degrees, is the best.",
    states=(
        r"(J_x = 1000 \land J_y = 1600 \land J_z = 800 \land w_x = w \land w_y = w \land w_z = w \land w = \frac{1}{500} "
        rf"\land \sin^2 a = 4 \cos^2 a) \Rightarrow ({EXTENTS_FIT})",
        r"\arctg 2 \approx 63.4^\circ",
        r"\frac{8}{2 \cdot 1600 + 800} = \frac{1}{500}",
    ),
    uses=["B.39"],
)

AT_F8 = r"w^2 (1600^2 \cos^2 a + \frac{1}{4} \cdot 800^2 \sin^2 a)"

rate_at_the_printed_angle = six_in_numbers.ours(
    "B.41",
    618,
    words="At tg a = 3, the angle of the paper, w is 0.0018974 at most.",
    states=r"w^2 \leq \frac{9}{2500000}",
    given=[
        Hypothesis("tg a = 3", "the angle of the paper", r"\sin^2 a = 9 \cos^2 a"),
        Hypothesis("F_8", "the condition of the face F_8 (B.38)", rf"{AT_F8} \leq 16 \sin^2 a \cos^2 a"),
    ],
    by=nonnegative(rf"\frac{{1}}{{400000}} (16 \sin^2 a \cos^2 a - {AT_F8})"),
    equality=rf"{AT_F8} = 16 \sin^2 a \cos^2 a",
    uses=["B.38"],
)

six_against_four = six_in_numbers.ours(
    "B.42",
    618,
    words="It is reached, and still more than four wheels can have at any angles (B.20); at the best angle it is 0.002 (B.40) against "
    "0.0013886 (B.22).",
    states=(
        rf"(J_x = 1000 \land J_y = 1600 \land J_z = 800 \land w_x = w \land w_y = w \land w_z = w \land w^2 = \frac{{9}}{{2500000}} "
        rf"\land \sin^2 a = 9 \cos^2 a) \Rightarrow ({EXTENTS_FIT})",
        r"\sqrt{\frac{9}{2500000}} \approx 0.0018974",
        r"\sqrt{\frac{9}{2500000}} > \frac{4}{1600 + \sqrt{1000^2 + 800^2}}",
    ),
    uses=["B.20", "B.41"],
)
