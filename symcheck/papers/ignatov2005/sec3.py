r"""Ignatov 2005, section 3: six wheels along the side edges of a regular six-sided pyramid, and five of them.

Lists and tables of coordinates are in `lists`. The axes are those of the pyramid (`derivation.six_axes`), not those
printed, of which one is wrong. In formal statements -V_i stands for V'_i, and W_i for the vertex V_i of section 3.2
where both polyhedra are spoken of.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

from symcheck.core.claims import Claim, Damage, Erratum, Hypothesis, Ours, Premise
from symcheck.core.problems import Applied
from symcheck.core.verdicts import Origin
from symcheck.papers import listing
from symcheck.papers.declare import Scope, Text, by_cases, exclusion, ours, premise
from symcheck.papers.ignatov2005 import derivation, envelopes, named, wheels
from symcheck.papers.ignatov2005.hypotheses import (
    MASS,
    RATES,
    SPACECRAFT_MOMENTS,
    acute_a,
    real_base,
    real_pyramid,
)
from symcheck.papers.ignatov2005.lists import of_five, of_six
from symcheck.papers.ignatov2005.named import Named
from symcheck.papers.ignatov2005.notation import (
    LIMIT,
    five_of_six,
    four_wheels,
    four_wheels_and_ellipsoid,
    six_and_five,
    six_wheels,
    six_wheels_in_numbers,
    six_wheels_in_spacecraft,
    six_wheels_with_units,
)
from symcheck.papers.ignatov2005.wheels import AND, CORNERS, five, points, six
from symcheck.proof import cases, combined, existence, identity, nonnegative, theorems
from symcheck.reading import Notation

both = Scope(six_and_five, derivation.six_axes, cases())
craft = Scope(six_wheels_in_spacecraft)
numbers = Scope(six_wheels_in_numbers)


def right_side(printed: str) -> str:
    """What stands behind the sign of equality."""
    return printed.partition(" = ")[2]


# --- 3.1: the axes, the momentum, its region

pyramid = premise(
    "3.0.1", 268, words="The axes of the wheels are parallel to the side edges of a regular six-sided pyramid."
)

numbers_of_wheels = six.numbers_of_wheels("3.0.2", 273)

axes_are_unit_vectors = six.unit_vectors("3.0.3", 273)

axes_of_wheels = six.claim(
    "3.0.4",
    275,
    r"\begin{aligned} e_1 &= (0, -\sin a, \cos a), & "
    r"e_2 &= \left( \frac{\sqrt{3}}{2} \sin a, -\frac{1}{2} \sin a, \cos a \right), \\ "
    r"e_3 &= \left( \frac{\sqrt{3}}{2} \sin a, \frac{1}{2} \sin a, \cos a \right), & e_4 &= (0, \sin a, -\cos a), \\ "
    r"e_5 &= \left( \frac{\sqrt{3}}{2} \sin a, -\frac{1}{2} \sin a, -\cos a \right), & "
    r"e_6 &= \left( \frac{\sqrt{3}}{2} \sin a, \frac{1}{2} \sin a, -\cos a \right). \end{aligned}",
    words="Edges 60 degrees apart, the first in the plane OYZ; wheels 1 to 3 point up their edges, 4 to 6 down.",
    uses=["3.0.1"],
    errata={
        "d": Erratum(
            r"e_4 = (0, -\sin a, -\cos a)",
            "sign",
            Origin.UNCERTAIN,
            "As printed e_4 is -e_1, and the wheels 1 and 4 lie on one edge; the pyramid has e_4 opposite to e_1. The scalar form of "
            "H (-h_4 sin a in H_y), both zero combinations and every vertex of the list have the right sign. A minus may be lost "
            "by the author or by the OCR.",
        )
    },
)

opposite_edges = six.by_cases.ours(
    "3.0.5",
    275,
    words="With this e_4 neighbouring edges enclose one angle all round, as in a regular pyramid: e_1, e_2, e_3, -e_4, -e_5, -e_6.",
    states=r"(\mathbf{e}_1, \mathbf{e}_2) = (\mathbf{e}_2, \mathbf{e}_3) = -(\mathbf{e}_3, \mathbf{e}_4) = "
    r"(\mathbf{e}_4, \mathbf{e}_5) = (\mathbf{e}_5, \mathbf{e}_6) = -(\mathbf{e}_6, \mathbf{e}_1)",
    uses=["3.0.4"],
)

angle_to_oz = six.angle_to_oz("3.0.6", 277, "e_4 to e_6", "3.0.4")

parameter = premise("3.0.7", 277, words="The angle a is the parameter of the system.")

total_momentum = six.total_momentum("3.1", 279)

equal_wheels = six.equal_wheels(
    "3.1.1",
    281,
    (r"-h_{\max} \leq h_i \leq h_{\max}", r"i = 1, \dots, 6", r"h_{\max}"),
    six_wheels_in_spacecraft,
)

components_of_momentum = six.claim(
    "3.1.2",
    283,
    (
        r"H_x = (h_2 + h_3 + h_5 + h_6) \frac{\sqrt{3}}{2} \sin a, \quad "
        r"H_y = \left( -h_1 - \frac{h_2}{2} + \frac{h_3}{2} - h_4 - \frac{h_5}{2} + \frac{h_6}{2} \right) \sin a,",
        r"H_z = (h_1 + h_2 + h_3 - h_4 - h_5 - h_6) \cos a.",
    ),
    lines={"c": 285},
    uses=["3.0.4", "3.1"],
)

shorthand = six.shorthand("3.1.3", 287, "3.1", "Square brackets list the momenta of the wheels: ")

round_brackets = six.round_brackets("3.1.4", 287)

unit_of_momentum = six.unit_of_momentum("3.1.5", 287, "3.1.3", six_wheels_in_spacecraft)

region = six.region_of_momenta("3.1.6", 289)

region_is_convex = six.claim(
    "3.1.7",
    289,
    words="P is convex: between two of its points lies the H of the momenta between, which are no larger (2.1.7b).",
    states=rf"u{six.momenta()} + (1 - u){six.momenta('l')} = " + six.bracket(lambda i: f"uh_{i} + (1 - u)l_{i}"),
    uses=["2.1.7", "3.1.3"],
)

region_is_symmetric = six.symmetric_region("3.1.8", 289, "3.1.3")

vertices_take_full_momenta = six.full_momenta_at_vertices("3.1.9", 289, "3.1.3")

ZERO = (r"\mathbf{H} = [1, -1, 1, 1, -1, 1]", r"\mathbf{H} = [-1, 1, -1, -1, 1, -1]")

zero_combinations = six.claim(
    "3.1.10",
    289,
    ZERO,
    words="In these two combinations the momenta cancel.",
    states=tuple(f"{right_side(printed)} = 0" for printed in ZERO),
    uses=["3.0.4", "3.1.3"],
)

only_two_combinations_vanish = six.by_cases.claim(
    "3.1.11",
    289,
    words="No other combination of full momenta vanishes: there are two.",
    states=rf"{six.momenta()} = 0 \Leftrightarrow (h_2 = -h_1 \land h_3 = h_1 \land h_4 = h_1 \land h_5 = -h_1 \land h_6 = h_1)",
    given=[
        real_pyramid,
        Hypothesis("full momenta", "every wheel has full momentum", ", ".join(f"h_{i}^2 = 1" for i in six.numbers)),
    ],
    uses=["3.1.10"],
)

# half of the combinations that are not vertices (the others are opposite), and smaller momenta with the same sum
INSIDE = (
    ("1, 1, 1, 1, -1, 1", "6/7, 6/7, 6/7, 2/7, 0, 2/7"),
    ("1, 1, -1, 1, -1, 1", "2/3, 2/3, -2/3, 2/3, 0, 0"),
    ("1, 1, -1, -1, 1, 1", "2/3, 2/3, 0, 0, 2/3, 2/3"),
    ("1, 1, -1, -1, 1, -1", "6/7, 6/7, -2/7, 0, 2/7, -6/7"),
    ("1, 1, -1, -1, -1, 1", "1/2, 1/2, 0, -1/2, -1/2, 0"),
    ("1, -1, 1, 1, 1, 1", "2/7, 0, 2/7, 6/7, 6/7, 6/7"),
    ("1, -1, 1, 1, 1, -1", "2/3, 0, 0, 2/3, 2/3, -2/3"),
    ("1, -1, 1, 1, -1, -1", "6/7, -2/7, 0, 2/7, -6/7, -6/7"),
    ("1, -1, 1, -1, 1, 1", "0, 0, 2/3, -2/3, 2/3, 2/3"),
    ("1, -1, 1, -1, 1, -1", "1/2, 0, 1/2, -1/2, 0, -1/2"),
    ("1, -1, 1, -1, -1, 1", "0, -2/7, 6/7, -6/7, -6/7, 2/7"),
    ("1, -1, -1, 1, -1, 1", "2/7, -6/7, -6/7, 6/7, -2/7, 0"),
    ("1, -1, -1, -1, 1, 1", "0, -1/2, -1/2, 0, 1/2, 1/2"),
    ("1, -1, -1, -1, 1, -1", "2/3, -2/3, -2/3, 0, 0, -2/3"),
    ("1, -1, -1, -1, -1, 1", "0, -2/3, -2/3, -2/3, -2/3, 0"),
)


def inside(full: str) -> str:
    """Wheels that are all below their limit have the same sum."""
    return rf"\exists h_i : (-1 < h_i \land h_i < 1 \land {six.momenta()} = [{full}])"


combinations_inside = six.claim(
    "3.1.12",
    289,
    words="30 combinations, these 15 and their opposites, lie inside P: wheels that are all below their limits have the same sum, and "
    "as no direction is perpendicular to all axes (3.1.13), P goes on around it.",
    states=tuple(inside(full) for full, _ in INSIDE),
    by={
        letter: existence(**{f"h_{i}": value for i, value in enumerate(smaller.split(", "), 1)})
        for letter, (_, smaller) in zip("abcdefghijklmno", INSIDE, strict=True)
    },
    uses=["3.0.4", "3.1.3"],
)

no_three_axes_in_a_plane = six.no_three_in_a_plane(
    "3.1.13", 289, ": P is simple (2.1.14).", given=[real_pyramid], uses=["2.1.14", "3.0.4"]
)

number_of_vertices = six.number_of_vertices(
    "3.1.14",
    289,
    f": of the 64 combinations 2 vanish and 30 lie inside, the others are (list of vertices). {CORNERS}.",
    *("3.1.9", "3.1.11", "3.1.12", "3.1.13", "3.1V"),
)

pairs_of_vertices = six.pairs_of_vertices("3.1.15", 289, r"i = 1, \dots, 16")

number_of_edges = six.number_of_edges("3.1.16", 326, "3.1.13", "3.1E")

parameter_of_edges = six.parameter_of_edges("3.1.17", 365)

number_of_faces = six.number_of_faces("3.1.18", 365, "", "3.1.13", "3.1F")

pairs_of_faces = six.pairs_of_faces("3.1.19", 365, r"i = 1, \dots, 15")

sense_of_edges = six.sense_of_edges("3.1.20", 402)

euler_characteristic = six.counted(
    "3.1.21",
    402,
    "So there are 32 vertices, 30 faces and 60 edges, as Euler's formula wants it (3.1.14, 3.1.16, 3.1.18).",
    rf"{six.on_no_side}2^6 - 32 = 32 \land 6 (6 - 1) = 30 \land 2 \cdot 6 (6 - 1) = 60 \land 32 + 30 - 60 = 2",
    *("3.1.14", "3.1.16", "3.1.18"),
)


def angle_of_a_table(number: str, line: int, table: int) -> Premise:
    """The angle is a, and alpha here."""
    return six.premise(
        number,
        line,
        r"\alpha = 72^\circ",
        words=f"The angle of table {table}, chosen in section 3.3 (3.2.32).",
        damage=Damage(
            r"a = 72^\circ",
            "The angle is defined as a (line 277), and is a wherever else it is printed; alpha is no letter of this paper. The original has "
            "Greek letters where the digital text has a, b, p and w, and the digital text kept this one: either letter is meant for the other.",
            kind="one letter for another",
        ),
    )


angle_of_table_6 = angle_of_a_table("3.1.22", 404, 6)

# --- 3.1: symmetries


SIXTH_TURN = (
    r"\begin{pmatrix} \frac{1}{2} & -\frac{\sqrt{3}}{2} & 0 \\ "
    r"\frac{\sqrt{3}}{2} & \frac{1}{2} & 0 \\ 0 & 0 & 1 \end{pmatrix}"
)

half_turns = six.half_turns(
    "3.1.23", 441, "3.0.4", "-1, 6, 5, -4, 3, 2", "4, -3, -2, 1, -6, -5", "-4, -5, -6, -1, -2, -3"
)

planes_of_symmetry = six.planes_of_symmetry(
    "3.1.24", 441, "3.0.4", "1, -6, -5, 4, -3, -2", "-4, 3, 2, -1, 6, 5", "4, 5, 6, 1, 2, 3"
)

sixth_turns = six.by_cases.ours(
    "3.1.25",
    441,
    words="The paper leaves out most symmetries: P goes over into itself when turned about OZ by any multiple of pi/3. With the half "
    "turns and reflections these make 24, the symmetries of a regular six-sided prism.",
    states=six.turned(SIXTH_TURN, "2, 3, -4, 5, 6, -1"),
    uses=["3.0.4", "3.1.23", "3.1.24"],
)

# --- 3.1: distances

edges_of_length_two = six.edges_of_length_two("3.1.26", 443, uses=["3.0.3", "3.1.17"])

faces_are_rhombi = six.faces_are_rhombi("3.1.27", 443, [real_pyramid], "3.1.26")

DISTANCES = {"d_1": r"6\cos a", "d_2": r"4\sin a", "d_3": r"2\sqrt{3\cos^2 a + 1}", "d_4": r"2\sqrt{2\sin^2 a + 1}"}


NAMED_OF_SIX = named.in_sentence(named.VERTICES_OF_SIX)


def all_equally_far(scope: Scope, number: str, far: Named, printed: Text, **further: Any) -> Claim:
    """All these vertices have the distance that is printed for them."""
    return scope.claim(
        number,
        far.line,
        printed,
        words=f"Distance of {far.words} from the centre.",
        states=AND.join(rf"\sqrt{{({point}, {point})}} = {right_side(far.distance)}" for point in named.points(far)),
        **further,
    )


distances_of_vertices = tuple(
    all_equally_far(six, number, far, far.distance, given=[real_pyramid])
    for number, far in zip(("3.1.28", "3.1.29", "3.1.30", "3.1.31"), NAMED_OF_SIX, strict=True)
)

vertices_with_a_distance = named.every_one_once(
    "3.1.33", of_six, NAMED_OF_SIX, "Each vertex is named with one of these distances, once.", six_wheels
)

# --- table 7: the order of the distances

QUADRANT = Hypothesis("0 to 90 degrees", "a lies between 0 and pi/2, as in the table", r"0 \leq a \leq \pi/2")


def order_of_distances(number: str, line: int, order: str, angles: str) -> Claim:
    """A row: an order of the distances, and the angles at which it holds, with their value in degrees."""
    written_out = re.sub("d_.", lambda distance: DISTANCES[distance[0]], order)
    exact, *degrees = re.split(r" (?:=|\\approx) (?=[\d.]+\^\\circ)", angles)
    value = [
        rf"{right_side(exact)} \approx {angle}" if "." in angle else rf"{exact} \Leftrightarrow a = {angle}"
        for angle in degrees
    ]
    return six.by_cases.claim(
        number,
        line,
        (order, angles),
        words="The order holds for these a, and for no others.",
        states=(rf"{written_out} \Leftrightarrow {exact}", *value),
        given=[QUADRANT],
        uses=["3.1.28", "3.1.29", "3.1.30", "3.1.31"],
    )


FIRST, SECOND = r"\arcsin \frac{\sqrt{2}}{2}", r"\arcsin \frac{2}{\sqrt{7}}"
THIRD, FOURTH = r"\operatorname{arctg} \sqrt{\frac{3}{2}}", r"\operatorname{arctg} \frac{3}{2}"
FIFTH, SIXTH = r"\arccos \sqrt{\frac{3}{11}}", r"\arccos \frac{1}{\sqrt{6}}"

table_7 = (
    order_of_distances("T7.1", 448, "d_2 < d_4 < d_3 < d_1", rf"0^\circ \leq a < {FIRST}"),
    order_of_distances("T7.2", 449, "d_2 = d_4 < d_3 < d_1", rf"a = {FIRST} = 45^\circ"),
    order_of_distances("T7.3", 450, "d_4 < d_2 < d_3 < d_1", rf"{FIRST} < a < {SECOND}"),
    order_of_distances("T7.4", 451, "d_4 < d_2 = d_3 < d_1", rf"a = {SECOND} \approx 49.1^\circ"),
    order_of_distances("T7.5", 452, "d_4 < d_3 < d_2 < d_1", rf"{SECOND} < a < {THIRD}"),
    order_of_distances("T7.6", 453, "d_4 = d_3 < d_2 < d_1", rf"a = {THIRD} \approx 50.8^\circ"),
    order_of_distances("T7.7", 454, "d_3 < d_4 < d_2 < d_1", rf"{THIRD} < a < {FOURTH}"),
    order_of_distances("T7.8", 455, "d_3 < d_4 < d_2 = d_1", rf"a = {FOURTH} \approx 56.3^\circ"),
    order_of_distances("T7.9", 456, "d_3 < d_4 < d_1 < d_2", rf"{FOURTH} < a < {FIFTH}"),
    order_of_distances("T7.10", 457, "d_3 < d_4 = d_1 < d_2", rf"a = {FIFTH} \approx 58.5^\circ"),
    order_of_distances("T7.11", 458, "d_3 < d_1 < d_4 < d_2", rf"{FIFTH} < a < {SIXTH}"),
    order_of_distances("T7.12", 459, "d_3 = d_1 < d_4 < d_2", rf"a = {SIXTH} \approx 65.9^\circ"),
    order_of_distances("T7.13", 460, "d_1 < d_3 < d_4 < d_2", rf"{SIXTH} < a \leq 90^\circ"),
)

# --- table 8: the distances of the faces

FACES_OF_P = named.faces(of_six)
NAMED_IN_TABLE_8 = named.in_rows(named.TABLE_8)


def distance_of_faces(
    scope: Scope,
    number: str,
    far: Named,
    *,
    words: str = "",
    right: str = "",
    errata: Mapping[str, Erratum] | None = None,
    damage: Damage | None = None,
) -> Claim:
    """A cell of a table of faces: the distance r_i of the planes of these F_i, and so of F'_i, from the centre."""
    return scope.claim(
        number,
        far.line,
        (*far.printed, far.distance),
        words=f"Distance of the planes of {far.words}{words}.",
        damage=damage,
        states=all_far(far.distance, *far.indices),
        given=[real_pyramid],
        by=theorems(*(Applied("equal_squares", (f"r_{{{i}}}", right or far.distance)) for i in far.indices)),
        errata=errata,
    )


def all_far(distance: str, *faces: int) -> str:
    """All these faces have the distance."""
    return r" \land ".join(f"r_{{{i}}} = {distance}" for i in faces)


ALL_WHEELS = Scope(six_wheels, partial(derivation.distances_of_faces_of_six, *FACES_OF_P))
AT_TWO_STEPS = r"4 \sin 2a \sqrt{\frac{1}{1 + 3 \cos^2 a}}"

faces_of_table_8 = named.every_one_once(
    "T8.0", of_six, NAMED_IN_TABLE_8, "Each face is in the table, once.", six_wheels
)

NEIGHBOURS, TWO_APART, ACROSS = NAMED_IN_TABLE_8

table_8 = (
    distance_of_faces(ALL_WHEELS, "T8.1", NEIGHBOURS, words=": between neighbouring edges of the pyramid"),
    distance_of_faces(
        ALL_WHEELS,
        "T8.2",
        TWO_APART,
        words=": between edges with one in between",
        right=AT_TWO_STEPS,
        errata={
            "": Erratum(
                all_far(AT_TWO_STEPS, *TWO_APART.indices),
                "coefficient",
                Origin.UNCERTAIN,
                "The normal of the plane of two edges 120 degrees apart has the square 3/4 sin^2 a (1 + 3 cos^2 a). The same root in "
                "table 11, one wheel failed, has 4 - 3 sin^2 a, which is 1 + 3 cos^2 a. With 15 the distance is too small, at "
                "72 degrees by 27 percent. A 15 for a 3 is hardly the OCR's, but nothing excludes it.",
                instead=f"${AT_TWO_STEPS}$",
            )
        },
    ),
    distance_of_faces(ALL_WHEELS, "T8.3", ACROSS, words=": between opposite edges, across OX and at 60 degrees to it"),
)


def far_scope(face: str, notation: Notation) -> Scope:
    """With u and v at the foot of the perpendicular to a face."""
    return Scope(notation, partial(derivation.foot_of_perpendicular, face), cases())


def foot_within(number: str, line: int, face: str, words: str, notation: Notation, **angles: str) -> Ours:
    """The foot of the perpendicular from the centre, and for which a its u and its v are those of a point of the face.

    Without a condition on a it is one that no edge contains.
    """
    places = face.split(", ")
    across = [rf"(\mathbf{{e}}_{places.index(free) + 1}, [{face}]) = 0" for free in "uv"]
    within = [
        rf"-1 \leq {free} \leq 1 \Leftrightarrow {angles[free]}" if free in angles else f"-1 < {free} < 1"
        for free in "uv"
    ]
    return far_scope(face, notation).ours(
        number, line, words=words, states=(*across, *within), given=[real_pyramid], uses=["3.0.4"]
    )


feet_of_perpendiculars = (
    foot_within(
        "T8.4",
        467,
        FACES_OF_P[0],
        "For F_1 to F_6 the foot of the perpendicular lies within the face, and the face is as "
        "far as its plane, from tg^2 a = 2/3 on.",
        six_wheels,
        u=r"2 \cos^2 a \leq 3 \sin^2 a",
        v=r"2 \cos^2 a \leq 3 \sin^2 a",
    ),
    foot_within(
        "T8.5",
        467,
        FACES_OF_P[6],
        "For F_7 to F_12 up to tg a = 2: at the 72 degrees of section 3.3 these faces are farther than their planes.",
        six_wheels,
        u=r"\sin^2 a \leq 4 \cos^2 a",
        v=r"\sin^2 a \leq 4 \cos^2 a",
    ),
    foot_within("T8.6", 467, FACES_OF_P[12], "For F_13 to F_15 always: it is the middle of the face.", six_wheels),
)


def as_far_as_its_plane(
    number: str, far: Named, face: str, notation: Notation, needs: Hypothesis | None = None, at_72_degrees: str = ""
) -> Claim:
    """That a face is as far as its plane: the foot of the perpendicular lies within it."""
    reason = (
        "The table promises the distance of each face and gives that of its plane. They are one where the foot of the perpendicular from the "
        f"centre lies within the face, and for no other angles; elsewhere the face is farther{at_72_degrees}."
    )
    return far_scope(face, notation).claim(
        number,
        far.line,
        words=f"This is the distance of the faces {far.words} themselves, not of their planes only: the foot of the "
        "perpendicular, at these u and v of the face, lies within it.",
        states=r"-1 \leq u \leq 1 \land -1 \leq v \leq 1",
        given=[real_pyramid],
        errata={"": Erratum("", "missing hypothesis", Origin.PAPER, reason, needs=(needs,))} if needs else {},
        uses=["3.0.4"],
    )


def angles(words: str, states: str) -> Hypothesis:
    """The angles for which faces are as far as their planes."""
    return Hypothesis("foot in the face", words, states)


faces_of_table_8_as_far_as_their_planes = (
    as_far_as_its_plane(
        "T8.7",
        NEIGHBOURS,
        FACES_OF_P[0],
        six_wheels,
        angles("tg^2 a is 2/3 at least: a is 39.2 degrees or more", r"2 \cos^2 a \leq 3 \sin^2 a"),
    ),
    as_far_as_its_plane(
        "T8.8",
        TWO_APART,
        FACES_OF_P[6],
        six_wheels,
        angles("tg a is 2 at most: a is 63.4 degrees or less", r"\sin^2 a \leq 4 \cos^2 a"),
        ", at the 72 degrees of section 3.3 2.268 and not 2.073 (with the right coefficient, T8.2)",
    ),
    as_far_as_its_plane("T8.9", ACROSS, FACES_OF_P[12], six_wheels),
)

# --- 3.2: one wheel failed

any_wheel_may_fail = six.by_cases.claim(
    "3.1.32",
    471,
    words="No generality is lost with the failure of wheel 6: a sixth of a turn about OZ takes each axis to the next, but for a sign, "
    "so the region left by another wheel is P' turned.",
    states=six.turned(SIXTH_TURN, "2, 3, -4, 5, 6, -1"),
    uses=["3.1.25"],
)

momentum_of_five = five.total_momentum("3.2", 473, "wheels that work")

components_of_five = five.claim(
    "3.2.1",
    477,
    (
        r"H_x = (h_2 + h_3 + h_5) \frac{\sqrt{3}}{2} \sin a, \quad "
        r"H_y = \left( -h_1 - \frac{h_2}{2} + \frac{h_3}{2} - h_4 - \frac{h_5}{2} \right) \sin a,",
        r"H_z = (h_1 + h_2 + h_3 - h_4 - h_5) \cos a.",
    ),
    lines={"c": 479},
    uses=["3.0.4", "3.2"],
)

shorthand_of_five = five.shorthand("3.2.2", 481, "3.2")

equal_wheels_again = craft.premise(
    "3.2.3",
    481,
    (r"-h_{\max} \leq h_i \leq h_{\max}", r"i=1, \dots, 5", r"|h_i| \leq 1"),
    words="The limits of the wheels that work; P' is the region of all H with |h_i| <= 1.",
    states=r"-h_{\max} \leq h_i \leq h_{\max}",
)

unit_of_momentum_of_five = five.unit_of_momentum(
    "3.2.47", 481, "3.2.2", five_of_six.extended(LIMIT), "Again no generality is lost with h_max = 1."
)

number_of_vertices_of_five = five.number_of_vertices("3.2.4", 481, f" (list of vertices). {CORNERS}.", "3.1.13", "3.2V")

pairs_of_vertices_of_five = five.pairs_of_vertices("3.2.5", 481, r"i=1, \dots, 11")

region_of_five_is_symmetric = five.symmetric_region("3.2.6", 481, "3.2.2")

number_of_edges_of_five = five.claim(
    "3.2.7",
    507,
    words="The parallelepiped has 40 edges.",
    states=r"2 \cdot 3 (3 - 1) = 40",
    uses=["3.1.13", "3.2.42"],
    errata={
        "": Erratum(
            r"2 \cdot 5 (5 - 1) = 40",
            "wrong claim",
            Origin.PAPER,
            "A parallelepiped has 12 edges, and P' is none: five wheels span it. The word was left over from the same sentence in "
            "section 2.2, where P' is one; the number is right for P' (3.2.42).",
        )
    },
)

edges_of_five_counted = five.edges_counted("3.2.42", 507, "3.1.13", "3.2E")

parameter_of_edges_of_five = five.parameter_of_edges("3.2.8", 526)

number_of_faces_of_five = five.number_of_faces(
    "3.2.9", 526, "; with 22 vertices and 40 edges this agrees with Euler's formula", "3.2.4", "3.2.42", "3.2F"
)

pairs_of_faces_of_five = five.pairs_of_faces("3.2.10", 526, r"i = 1, \dots, 10")

sense_of_edges_of_five = five.sense_of_edges("3.2.11", 554)

angle_of_table_9 = angle_of_a_table("3.2.12", 554, 9)

# --- 3.2: from P to P'

EDGES = r"V_1V_7', V_2V_8', V_6V_{13}', V_9V_{15}', V_{12}V_{16}', V_1V_7, V_2V_8, V_6V_{13}, V_9V_{15}, V_{12}V_{16}'"
RIGHT_EDGES = (
    r"V_1'V_7', V_2'V_8', V_6'V_{13}', V_9'V_{15}', V_{12}'V_{16}, V_1V_7, V_2V_8, V_6V_{13}, V_9V_{15}, V_{12}V_{16}'"
)
MIDPOINTS = r"V_1', V_2', V_6', V_8', V_{11}', V_1, V_2, V_6, V_8, V_{11}"


def along_wheel_6(edge: str) -> str:
    """The two vertices differ by 2 e_6: they are the ends of an edge along that axis."""
    first, last = points(edge)
    return rf"{last} - ({first}) = 2\mathbf{{e}}_6 \lor {first} - ({last}) = 2\mathbf{{e}}_6"


def is_midpoint(vertex: str, edge: str) -> str:
    """The vertex of P' is the middle of the edge of P."""
    (middle,), (first, last) = points(vertex, "W"), points(edge)
    return f"{middle} = ({first} + ({last}))/2"


PRIMES_LOST = (
    "A prime is missing at the first letter: V_i and V'_k are not joined by an edge. Five edges and their five opposites are along e_6. "
    "The list of edges of section 3.1 lost the first prime too, wherever the number of that vertex has one digit: a damage of the "
    "digital text."
)
PRIME_MOVED = (
    "The edge of V_12 and V'_16 stands twice in the list; its opposite V'_12 V_16 is missing. The prime is at the wrong letter; the "
    "digital text, which dropped it at numbers of one digit, would have left it at V_12."
)


def is_there(edge: str, edges: str) -> str:
    """One of the edges of a list has the ends of this one, whichever comes first."""

    def ends(named: str) -> str:
        return " + ".join(f"({end})" for end in points(named))

    return r" \lor ".join(f"{ends(listed)} = {ends(edge)}" for listed in edges.split(", "))


def repaired(statements: list[str], **others: Erratum) -> dict[str, Erratum]:
    """The errata of the first four statements, with lost primes, and others."""
    edges = RIGHT_EDGES.split(", ")
    lost = {
        letter: Erratum(statement, "lost prime", Origin.OCR, PRIMES_LOST, shown=edge)
        for letter, statement, edge in zip("abcd", statements, edges, strict=False)
    }
    return {**lost, **others}


LEFT_OUT = RIGHT_EDGES.split(", ")[4]

edges_that_shrink = both.claim(
    "3.2.13",
    586,
    (*EDGES.split(", "), EDGES),
    words="P' is P with these edges shrunk to nothing: just these are along e_6, the axis of the wheel that failed. (k) Just these: the "
    "edge along e_6 that ends in V_16 is one of them.",
    states=(*map(along_wheel_6, EDGES.split(", ")), is_there(LEFT_OUT, EDGES)),
    given=[real_pyramid],
    errata=repaired(
        [along_wheel_6(edge) for edge in RIGHT_EDGES.split(", ")],
        k=Erratum(is_there(LEFT_OUT, RIGHT_EDGES), "label", Origin.UNCERTAIN, PRIME_MOVED, shown=RIGHT_EDGES),
    ),
    uses=["3.0.4", "3.1.3"],
)

number_of_edges_that_shrink = both.ours(
    "3.2.14",
    586,
    words="There are ten: each wheel has 2 (6 - 1) edges of P, and their ends coincide in pairs, 32 - 10 = 22.",
    states=r"2 (6 - 1) = 10 \land 32 - 10 = 22",
    uses=["3.1.14", "3.2.4", "3.2.13"],
)

RIGHT_MIDDLES = list(map(is_midpoint, MIDPOINTS.split(", "), RIGHT_EDGES.split(", ")))

midpoints_of_edges = both.claim(
    "3.2.15",
    586,
    EDGES.split(", "),
    words=f"The vertices {MIDPOINTS} of P' are the middles of these edges of P, in this order.",
    states=tuple(map(is_midpoint, MIDPOINTS.split(", "), EDGES.split(", "))),
    given=[real_pyramid],
    errata=repaired(RIGHT_MIDDLES, e=Erratum(RIGHT_MIDDLES[4], "label", Origin.UNCERTAIN, PRIME_MOVED, shown=LEFT_OUT)),
    uses=["3.2.13"],
)

edges_of_five_have_length_two = five.edges_of_length_two("3.2.16", 586, uses=["3.0.3", "3.2.8"])

faces_of_five_are_rhombi = five.faces_are_rhombi("3.2.17", 586, [real_pyramid], "3.2.16")

# --- tables 10 and 11: distances, one wheel failed


NAMED_IN_TABLE_10 = named.in_columns(named.TABLE_10)

table_10 = tuple(
    all_equally_far(five, f"T10.{row}", far, (*far.printed, far.distance), uses=["3.0.4"])
    for row, far in enumerate(NAMED_IN_TABLE_10, 1)
)

vertices_of_table_10 = named.every_one_once(
    "T10.0", of_five, NAMED_IN_TABLE_10, "Each vertex of P' is in the table, once.", five_of_six
)

FACES_OF_FIVE = named.faces(of_five)
FIVE_WHEELS = Scope(five_of_six, partial(derivation.distances_of_faces_of_six, *FACES_OF_FIVE))

_cells = named.in_columns(named.TABLE_11)
MISSING_IN_TABLE_11 = "F_2, F_2', F_5, F_5'"  # what the cell should name that names F_2 and its opposite
IN_TABLE_11 = (
    _cells[0],
    replace(_cells[1], labels=listing.labels(MISSING_IN_TABLE_11, _cells[1].line)),
    named.together(_cells[2], _cells[4]),
    named.together(_cells[3], _cells[5]),
    _cells[6],
    named.together(_cells[7], _cells[8]),
)

faces_of_table_11 = named.every_one_once(
    "T11.0",
    of_five,
    IN_TABLE_11,
    "Each face of P' is in the table, once, with F_5 and its opposite as T11.2 reads it.",
    five_of_six,
)

table_11 = (
    distance_of_faces(FIVE_WHEELS, "T11.1", IN_TABLE_11[0]),
    distance_of_faces(
        FIVE_WHEELS,
        "T11.2",
        IN_TABLE_11[1],
        words="; F_5 is nowhere in the table",
        damage=Damage(
            MISSING_IN_TABLE_11,
            reason="The table is to give the distance of each face, but has none for F_5 and F'_5, which are as far as F_2. The other faces "
            "across neighbouring edges, F_3 and F_4, and F_9 and F_10 share a cell of this column too; of cells that span two rows the "
            "digital text leaves one empty, and it may as well have dropped a row.",
            kind="missing cell",
            origin=Origin.UNCERTAIN,
        ),
    ),
    distance_of_faces(FIVE_WHEELS, "T11.3", IN_TABLE_11[2], words="; the cell spans both rows"),
    distance_of_faces(FIVE_WHEELS, "T11.4", IN_TABLE_11[3], words="; the cell spans both rows"),
    distance_of_faces(FIVE_WHEELS, "T11.5", IN_TABLE_11[4]),
    distance_of_faces(FIVE_WHEELS, "T11.6", IN_TABLE_11[5], words="; the cell spans both rows"),
)

feet_of_perpendiculars_of_five = (
    foot_within(
        "T11.7",
        604,
        FACES_OF_FIVE[0],
        "The foot of the perpendicular lies within F_1 for tg^2 a from 2/3 to 10.",
        five_of_six,
        u=r"(2 \cos^2 a \leq 3 \sin^2 a \land \sin^2 a \leq 10 \cos^2 a)",
        v=r"(2 \cos^2 a \leq 3 \sin^2 a \land \sin^2 a \leq 10 \cos^2 a)",
    ),
    foot_within(
        "T11.8",
        604,
        FACES_OF_FIVE[1],
        "Within F_2, and so F_5, at tg^2 a = 2 only, where it is a corner.",
        five_of_six,
        u=r"\sin^2 a \leq 2 \cos^2 a",
        v=r"\sin^2 a \geq 2 \cos^2 a",
    ),
    foot_within(
        "T11.9",
        605,
        FACES_OF_FIVE[2],
        "Within F_3, and so F_4, from tg^2 a = 4/3 on.",
        five_of_six,
        v=r"4 \cos^2 a \leq 3 \sin^2 a",
    ),
    foot_within(
        "T11.10",
        605,
        FACES_OF_FIVE[5],
        "Within F_6, and so F_8, up to tg^2 a = 2.",
        five_of_six,
        u=r"\sin^2 a \leq 2 \cos^2 a",
        v=r"\sin^2 a \leq 8 \cos^2 a",
    ),
    foot_within(
        "T11.11",
        607,
        FACES_OF_FIVE[6],
        "Within F_7 up to tg^2 a = 6.",
        five_of_six,
        u=r"\sin^2 a \leq 6 \cos^2 a",
        v=r"\sin^2 a \leq 6 \cos^2 a",
    ),
    foot_within("T11.12", 607, FACES_OF_FIVE[8], "Within F_9, and so F_10, always.", five_of_six),
)

faces_of_table_11_as_far_as_their_planes = tuple(
    as_far_as_its_plane(f"T11.{number}", far, FACES_OF_FIVE[far.indices[0] - 1], five_of_six, needs, at_72_degrees)
    for number, far, (needs, at_72_degrees) in zip(
        range(13, 19),
        IN_TABLE_11,
        (
            (
                angles(
                    "tg^2 a lies between 2/3 and 10: a between 39.2 and 72.5 degrees",
                    r"2 \cos^2 a \leq 3 \sin^2 a, \sin^2 a \leq 10 \cos^2 a",
                ),
                "",
            ),
            (
                angles("tg^2 a = 2, where it is a corner: a is 54.7 degrees", r"\sin^2 a = 2 \cos^2 a"),
                ", at 72 degrees 1.558 and not 1.447",
            ),
            (
                angles("tg^2 a is 2 at most: a is 54.7 degrees or less", r"\sin^2 a \leq 2 \cos^2 a"),
                ", at 72 degrees 1.868 and not 1.555",
            ),
            (angles("tg^2 a is 4/3 at least: a is 49.1 degrees or more", r"4 \cos^2 a \leq 3 \sin^2 a"), ""),
            (
                angles("tg^2 a is 6 at most: a is 67.8 degrees or less", r"\sin^2 a \leq 6 \cos^2 a"),
                ", at 72 degrees 1.328 and not 1.296",
            ),
            (None, ""),
        ),
        strict=True,
    )
)

# --- the closing comparison

volume_left_by_one_of_four = ours(
    "3.2.18",
    610,
    words="Of four wheels, one that fails leaves a quarter of the volume.",
    states=rf"{envelopes.volume(envelopes.FOUR, 4)} = \frac{{1}}{{4}} \cdot {envelopes.volume(envelopes.FOUR)}",
    uses=["2.0.4"],
    notation=four_wheels,
)

volume_left_by_one_of_six = six.by_cases.ours(
    "3.2.43",
    610,
    words="Of six wheels, one that fails leaves half of it.",
    states=rf"{envelopes.volume(envelopes.SIX, 6)} = \frac{{1}}{{2}} \cdot {envelopes.volume(envelopes.SIX)}",
    uses=["3.0.4"],
)

less_sensitive_to_failure = exclusion(
    "3.2.19",
    610,
    words="More wheels are less sensitive to a failure.",
    reason="the paper prints no measure of sensitivity. All that we know of are in its favour: the volume left is a half, not a quarter "
    "(3.2.18, 3.2.43), and a region similar to the whole that is left is 5/8, not a half, of its size (B.13, B.35)",
)

AROUND_FOUR = Hypothesis(
    "around P", "V_1 and V_7 lie in the ellipsoid", r"A_x^2 \geq (4 \sin a \sin b)^2, A_z^2 \geq (4 \cos a)^2"
)
IN_FOUR = Hypothesis(
    "inside P",
    "the ellipsoid, lambda times as large, does not reach beyond the face F_5",
    r"\lambda^2 (A_x^2 \cos^2 a + A_z^2 \sin^2 a \sin^2 b) \leq (4 \sin a \cos a \sin b)^2",
)

ROOM = (
    r"1 ((4 \sin a \cos a \sin b)^2 - \lambda^2 (A_x^2 \cos^2 a + A_z^2 \sin^2 a \sin^2 b)) "
    r"+ \lambda^2 \cos^2 a (A_x^2 - (4 \sin a \sin b)^2) + \lambda^2 (\sin a \sin b)^2 (A_z^2 - (4 \cos a)^2)"
)

four_wheels_and_ellipsoids = ours(
    "3.2.20",
    610,
    words="How near P is to an ellipsoid: let P lie in an ellipsoid with axes along OX, OY, OZ, and the ellipsoid lambda times as large "
    "in P. For four wheels lambda^2 is 1/2 at most, at all angles.",
    states=r"\lambda^2 \leq \frac{1}{2}",
    given=[real_pyramid, real_base, AROUND_FOUR, IN_FOUR],
    by=combined(nonnegative(rf"\frac{{{ROOM}}}{{32 (\sin a \cos a \sin b)^2}}"), forms=[ROOM]),
    equality=r"\lambda^2 (A_x^2 \cos^2 a + A_z^2 \sin^2 a \sin^2 b) = (4 \sin a \cos a \sin b)^2, "
    r"A_x^2 = (4 \sin a \sin b)^2, A_z^2 = (4 \cos a)^2",
    uses=["2.0.4"],
    notation=four_wheels_and_ellipsoid,
)


def against_ellipsoid(vertex: int, axes: Sequence[str], order: str) -> str:
    """The vertex lies on the ellipsoid with these semi-axes, squared ("="), or within it ("<")."""
    entries = ", ".join(rf"\frac{{1}}{{{axis}}}" for axis in axes)
    reciprocals = rf"\operatorname{{diag}}({entries})"
    return rf"(\mathbf{{V}}_{{{vertex}}}, {reciprocals} \mathbf{{V}}_{{{vertex}}}) {order} 1"


def around_ellipsoid(face: str, axes: Sequence[str], ratio: str, order: str) -> str:
    """The plane of the face touches that ellipsoid, made smaller by this ratio, squared ("="), or misses it ("<")."""
    places = face.split(", ")
    normal = " \\times ".join(rf"\mathbf{{e}}_{places.index(free) + 1}" for free in "uv")
    middle = f"[{face}]".replace("u", "0").replace("v", "0")
    squares = rf"\operatorname{{diag}}({', '.join(axes)})"
    return rf"{ratio} ({normal}, {squares} ({normal})) {order} ({normal}, {middle})^2"


nearer_to_an_ellipsoid = exclusion(
    "3.2.21",
    610,
    words="More wheels have a region nearer to an ellipsoid.",
    reason="the paper prints no measure of nearness, and the order depends on it. With the ellipsoid that suits each region best six "
    "wheels are nearer: lambda = 0.792 against 0.707 (3.2.20, 3.2.44). With the ellipsoid that the paper itself asks for, (1.2) with "
    "equal largest rates, and the moments of inertia and angles of sections 2.3 and 3.3, they are farther: 0.543 against 0.707 "
    "(3.2.45, 3.2.46)",
)

BEST_OF_SIX, RATIO_OF_SIX = (r"16\sin^2 a", r"16\sin^2 a", r"36\cos^2 a"), r"\frac{27}{43}"

six_wheels_and_the_best_ellipsoid = six.ours(
    "3.2.44",
    610,
    words="With the ellipsoid that suits them six wheels are nearer: lambda^2 = 27/43, more than 1/2, with the semi-axes 4 sin a, "
    "4 sin a, 6 cos a (the other vertices and faces by sixth turns and opposites).",
    states=(
        *(against_ellipsoid(vertex, BEST_OF_SIX, order) for vertex, order in ((1, "="), (2, "<"), (8, "<"), (14, "="))),
        *(
            around_ellipsoid(FACES_OF_P[face], BEST_OF_SIX, RATIO_OF_SIX, order)
            for face, order in ((0, "="), (6, "<"), (12, "<"))
        ),
        r"\frac{27}{43} > \frac{1}{2}",
    ),
    given=[real_pyramid],
    by={
        **dict.fromkeys("abdeh", identity),
        "c": nonnegative(r"\frac{5}{36}"),
        "f": nonnegative(r"\frac{39}{43} \cos^2 a \sin^4 a"),
        "g": nonnegative(r"\frac{336}{43} \cos^2 a \sin^4 a"),
    },
    uses=["3.1.25", "3.2.20"],
)

TANGENT_3 = Hypothesis("tg a = 3", "the angle of section 3.3", r"\sin^2 a = 9 \cos^2 a")
LEAST_AROUND_SIX = r"\frac{1953}{160000000}"  # (2 sqrt 3 sin a/1000)^2 + (2 sin a/1600)^2
AS_MOMENTS = tuple(rf"{LEAST_AROUND_SIX} \cdot {moment}^2" for moment in (1000, 1600, 800))

six_wheels_and_the_ellipsoid_asked_for = six.by_cases.ours(
    "3.2.45",
    610,
    words="With the ellipsoid (1.2) for equal largest rates w about all axes six wheels are farther from it than four: at tg a = 3 the "
    "least one around P has w^2 = 1953/160000000 (the other vertices by reflections), the largest in P 9/2500000 (B.41, B.42), so that "
    "lambda^2 is 64/217.",
    states=(
        *(against_ellipsoid(vertex, AS_MOMENTS, "=" if vertex == 14 else "<") for vertex in (1, 2, 3, 8, 10, 14, 15)),
        rf"\frac{{9}}{{2500000}} = \frac{{64}}{{217}} \cdot {LEAST_AROUND_SIX}",
        r"\frac{64}{217} < \frac{1}{2}",
        r"\sqrt{\frac{64}{217}} \approx 0.543",
    ),
    given=[TANGENT_3],
    uses=["1.2", "3.2.46", "B.41", "B.42"],
)

BOX = (r"(4 \sin a \sin b)^2", r"(4 \sin a \cos b)^2", r"(4 \cos a)^2")

four_wheels_and_the_ellipsoid_asked_for = by_cases.ours(
    "3.2.46",
    610,
    words="Four wheels reach the most that they can, lambda^2 = 1/2, with the semi-axes 4 sin a sin b, 4 sin a cos b, 4 cos a; at the "
    "angles of section 2.3 they are as the moments of inertia, and this is the ellipsoid for equal largest rates (2.3.11).",
    states=(
        *(against_ellipsoid(vertex, BOX, order) for vertex, order in ((1, "="), (6, "="), (7, "="), (2, "<"))),
        *(around_ellipsoid(face, BOX, r"\frac{1}{2}", "=") for face in ("1, 1, u, v", "u, 1, -1, v", "1, u, 1, v")),
        r"\sqrt{\frac{1}{2}} \approx 0.707",
        r"\sqrt{\frac{27}{43}} \approx 0.792",
    ),
    given=[real_pyramid, real_base],
    uses=["2.3.11", "3.2.20", "3.2.44"],
    notation=four_wheels,
)

wider_control = exclusion(
    "3.2.22",
    610,
    words="This gives wider possibilities of controlling the angular rate.",
    reason="what the two comparisons are good for; no relation of its own",
)

# --- 3.3: the spacecraft

question = exclusion(
    "3.2.23", 612, words="How to place the six wheels and choose the angle a.", reason="asks what 3.3 answers"
)

moments_of_inertia = wheels.moments_of_inertia(numbers, "3.2.24", 616, ", as in section 2.3")

two_equal_rates = craft.premise(
    "3.2.25",
    616,
    "w_y = w_z",
    words="The condition: the largest rates about OY and OZ are equal. One angle cannot make all three so.",
)

LARGEST = {  # the largest component, the momenta of the wheels, what is missing to it
    "x": (
        r"H_x = 2\sqrt{3} \sin a",
        "0, 1, 1, 0, 1, 1",
        r"\frac{\sqrt{3}}{2} \sin a (1 - h_2) + \frac{\sqrt{3}}{2} \sin a (1 - h_3) + \frac{\sqrt{3}}{2} \sin a (1 - h_5) "
        r"+ \frac{\sqrt{3}}{2} \sin a (1 - h_6)",
    ),
    "y": (
        r"H_y = 4 \sin a",
        "-1, -1, 1, -1, -1, 1",
        r"\sin a (1 + h_1) + \frac{1}{2} \sin a (1 + h_2) + \frac{1}{2} \sin a (1 - h_3) + \sin a (1 + h_4) "
        r"+ \frac{1}{2} \sin a (1 + h_5) + \frac{1}{2} \sin a (1 - h_6)",
    ),
    "z": (
        r"H_z = 6 \cos a",
        "1, 1, 1, -1, -1, -1",
        r"\cos a (1 - h_1) + \cos a (1 - h_2) + \cos a (1 - h_3) + \cos a (1 + h_4) + \cos a (1 + h_5) + \cos a (1 + h_6)",
    ),
}


largest_components = tuple(
    six.largest_component(number, 616, *LARGEST[axis], [real_pyramid], "3.1.2")
    for number, axis in (("3.2.26", "x"), ("3.2.27", "y"), ("3.2.28", "z"))
)

largest_x_at_a_face = six.ours(
    "3.2.29",
    616,
    words="The largest H_x alone is no vertex, other than with four wheels: it is the middle of the face F_13, where two wheels rest. "
    "All of this face has the largest H_x, so that the other components need not be zero with it.",
    states=(
        r"\frac{1}{4}(\mathbf{V}_{13} + \mathbf{V}_{14} + (-\mathbf{V}_{10}) + (-\mathbf{V}_{16})) = (2\sqrt{3} \sin a, 0, 0)",
        r"([u, 1, 1, v, 1, 1], (1, 0, 0)) = 2\sqrt{3} \sin a",
    ),
    uses=["3.2.26"],
)

TWO_EQUAL_RATES = Hypothesis("equal rates", "the rates about OY and OZ are equal (line 616)", "w_y = w_z")
LARGEST_MOMENTA = Hypothesis("largest momenta", "3.2.26 to 3.2.28", ", ".join(value for value, *_ in LARGEST.values()))

ratio_of_momenta = craft.claim(
    "3.2.30",
    616,
    r"\frac{H_y}{H_z} = \frac{J_y}{J_z}",
    given=[MASS, RATES, TWO_EQUAL_RATES],
    uses=["2.3", "3.2.25"],
)

ratio_of_sides = craft.claim(
    "3.2.31",
    618,
    r"\frac{4 \sin a}{6 \cos a} = 2",
    given=[SPACECRAFT_MOMENTS, LARGEST_MOMENTA, RATES, TWO_EQUAL_RATES],
    uses=["3.2.24", "3.2.27", "3.2.28", "3.2.30"],
)

angle_a = craft.by_cases.claim(
    "3.2.32",
    618,
    r"a = \arctg 3 = 72^\circ",
    words="The angle a from it, rounded to whole degrees.",
    states=(r"\frac{4 \sin a}{J_y} = \frac{6 \cos a}{J_z} \Leftrightarrow a = \arctg 3", r"\arctg 3 \approx 72^\circ"),
    given=[SPACECRAFT_MOMENTS, acute_a],
    uses=["3.2.24", "3.2.31"],
)

greater_moment = craft.claim(
    "3.2.33",
    618,
    "J_y > J_x",
    given=[SPACECRAFT_MOMENTS],
    uses=["3.2.24"],
)

axes_in_oyz = six.claim(
    "3.2.34",
    618,
    words="The axes of wheels 1 and 4 lie in the plane OYZ.",
    states=(r"(\mathbf{e}_1, (1, 0, 0)) = 0", r"(\mathbf{e}_4, (1, 0, 0)) = 0"),
    uses=["3.0.4"],
    damage=Damage(
        r"h_1 \mathbf{e}_1, h_4 \mathbf{e}_4",
        reason="The paper speaks of the vectors h_1 and h_4; h_i is a number (line 281), the vectors are h_i e_i. The author may have "
        "written h for e, or bold type was lost.",
        kind="letter",
        origin=Origin.UNCERTAIN,
    ),
)

better_turned_so = craft.by_cases.claim(
    "3.2.35",
    618,
    words="So the wheels are better placed with wheels 1 and 4 in the plane OYZ, as the largest H_y exceeds the largest H_x: with the "
    "pyramid turned by a quarter about OZ, and a chosen for w_y = w_z again, these two rates are smaller, and so is the smallest.",
    states=(
        r"4 \sin a > 2\sqrt{3} \sin a",
        r"\frac{2\sqrt{3} \sin a}{1600} = \frac{6 \cos a}{800} \Leftrightarrow a = \arctg(2\sqrt{3})",
        r"\frac{2\sqrt{3} \sin(\arctg(2\sqrt{3}))}{1600} < \frac{4 \sin(\arctg 3)}{1600} < \frac{2\sqrt{3} \sin(\arctg 3)}{1000}",
    ),
    given=[acute_a],
    uses=["3.2.26", "3.2.27", "3.2.33"],
)

ANGLE = Hypothesis("angle found", "a of 3.2.32", r"a = \arctg 3")
AT_THE_ANGLE = [SPACECRAFT_MOMENTS, LARGEST_MOMENTA, RATES, ANGLE]

largest_rate_about_ox = numbers.claim(
    "3.2.36",
    618,
    r"w_x = 0.0033h_{\max} \text{ кг}^{-1} \text{ м}^{-2}",
    words="The largest rate about OX, in absolute value and for h_max = 1 (units: 3.2.40).",
    states=r"-w_x \approx 0.0033",
    given=AT_THE_ANGLE,
    uses=["2.3", "3.2.26", "3.2.32"],
)

largest_rates_about_oy_and_oz = numbers.claim(
    "3.2.37",
    618,
    r"w_y = w_z = 0.0023h_{\max} \text{ кг}^{-1} \text{ м}^{-2}",
    words="The largest rates about OY and OZ, likewise.",
    states=("w_y = w_z", r"-w_z \approx 0.0023"),
    given=AT_THE_ANGLE,
    uses=["2.3", "3.2.27", "3.2.28", "3.2.32"],
    errata={
        "b": Erratum(
            r"-w_z \approx 0.0024",
            "rounding",
            Origin.PAPER,
            "At a = arctg 3 both rates are 0.00237. The 0.0023 is w_z for a rounded to 72 degrees, where w_y is 0.0024 and they are no "
            "longer equal.",
        )
    },
)

largest_rates_exactly = numbers.by_cases.ours(
    "3.2.38",
    618,
    words="Exactly: w_x = 3 sqrt 30/5000 and w_y = w_z = 3 sqrt 10/4000, or 0.00329 and 0.00237; with 72 degrees w_y and w_z "
    "come out as 0.00238 and 0.00232.",
    states=(
        r"\frac{2\sqrt{3} \sin a}{1000} = \frac{3 \sqrt{30}}{5000}",
        r"\frac{4 \sin a}{1600} = \frac{6 \cos a}{800} = \frac{3 \sqrt{10}}{4000}",
        r"-w_x \approx 0.00329",
        r"-w_y \approx 0.00237",
        r"\frac{4 \sin 72^\circ}{1600} \approx 0.00238",
        r"\frac{6 \cos 72^\circ}{800} \approx 0.00232",
    ),
    given=AT_THE_ANGLE,
    uses=["3.2.36", "3.2.37"],
)

largest_momentum_of_a_wheel = exclusion("3.2.39", 618, r"h_{\max}", reason="says once more what h_max is (line 281)")

WITH_UNITS = Hypothesis(
    "units",
    "the moments of inertia in kg m^2 (line 616)",
    r"J_x = 1000 \text{ кг} \text{ м}^2, J_y = 1600 \text{ кг} \text{ м}^2, J_z = 800 \text{ кг} \text{ м}^2, "
    r"\text{ кг} > 0, \text{ м} > 0",
)

units_of_the_rates = ours(
    "3.2.40",
    618,
    words="The factors before h_max with their units: H/J for a momentum of so many h_max has the unit kg^-1 m^-2.",
    states=(
        r"\frac{2\sqrt{3} \sin a \cdot h_{\max}}{J_x} = \frac{2\sqrt{3} \sin a}{1000} h_{\max} \text{ кг}^{-1} \text{ м}^{-2}",
        r"\frac{4 \sin a \cdot h_{\max}}{J_y} = \frac{4 \sin a}{1600} h_{\max} \text{ кг}^{-1} \text{ м}^{-2}",
        r"\frac{6 \cos a \cdot h_{\max}}{J_z} = \frac{6 \cos a}{800} h_{\max} \text{ кг}^{-1} \text{ м}^{-2}",
    ),
    given=[WITH_UNITS],
    uses=["3.2.24", "3.2.36", "3.2.37"],
    notation=six_wheels_with_units,
)

references = exclusion("3.2.41", 620, words="References.", reason="three titles")
