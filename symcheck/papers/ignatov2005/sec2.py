r"""Ignatov 2005, section 2: four wheels along the side edges of a four-sided pyramid, and three of them.

Lists and tables of coordinates are in `lists`. In the prose the text at hand prints p for pi: the original sets Greek
letters in a font of symbols, where p is the place of pi, and the text lost that font.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import partial
from itertools import combinations
from typing import Any

from symcheck.core.claims import Claim, Damage, Erratum, Hypothesis
from symcheck.core.problems import Applied
from symcheck.core.verdicts import Origin
from symcheck.papers.declare import Scope, claim, ours, premise
from symcheck.papers.ignatov2005 import derivation, named, wheels
from symcheck.papers.ignatov2005.hypotheses import (
    MASS,
    RATES,
    SPACECRAFT_MOMENTS,
    WITHIN_LIMITS,
    acute_a,
    acute_b,
    lost_pi,
    real_base,
    real_pyramid,
)
from symcheck.papers.ignatov2005.lists import of_four, of_three
from symcheck.papers.ignatov2005.named import Named
from symcheck.papers.ignatov2005.notation import (
    LIMIT,
    four_and_three,
    four_wheels,
    four_wheels_in_numbers,
    four_wheels_in_spacecraft,
    four_wheels_with_units,
    three_of_four,
)
from symcheck.papers.ignatov2005.wheels import AND, CORNERS, four, points, three
from symcheck.proof import cases, identity, theorems
from symcheck.reading import Notation

OPEN_RANGE = [real_pyramid, real_base]
craft = Scope(four_wheels_in_spacecraft)
numbers = Scope(four_wheels_in_numbers)
FULL_MOMENTUM = Hypothesis("limits", "no wheel exceeds h_max = 1 (line 81)", WITHIN_LIMITS)


# --- 2.1: the axes, the momentum, its region

axes_along_side_edges = four.claim(
    "2.0.1",
    62,
    words="The axes are parallel to the side edges of a four-sided pyramid: -e_1, -e_2, e_3, e_4 lead from the corners of a rectangle "
    "with sides along OX and OY to one apex.",
    states=(
        r"\mathbf{e}_4 + \mathbf{e}_1 = (2\sin a \sin b, 0, 0)",
        r"\mathbf{e}_3 + \mathbf{e}_2 = (2\sin a \sin b, 0, 0)",
        r"\mathbf{e}_4 - \mathbf{e}_3 = (0, 2\sin a \cos b, 0)",
        r"\mathbf{e}_2 - \mathbf{e}_1 = (0, 2\sin a \cos b, 0)",
    ),
    uses=["2.0.4"],
)

numbers_of_wheels = four.numbers_of_wheels("2.0.2", 67)

axes_are_unit_vectors = four.unit_vectors("2.0.3", 67, uses=["2.0.4"])

axes_of_wheels = four.definition(
    "2.0.4",
    69,
    r"\begin{aligned}\mathbf{e}_1 &= (\sin a \sin b, -\sin a \cos b, -\cos a), & "
    r"\mathbf{e}_2 &= (\sin a \sin b, \sin a \cos b, -\cos a), \\ "
    r"\mathbf{e}_3 &= (\sin a \sin b, -\sin a \cos b, \cos a), & "
    r"\mathbf{e}_4 &= (\sin a \sin b, \sin a \cos b, \cos a).\end{aligned}",
)

angle_to_oz = four.angle_to_oz("2.0.5", 71, "e_1 and e_2", "2.0.4")

ALONG_OX, ALONG_OY = r"2\sin a \sin b", r"2\sin a \cos b"  # the sides of the base (2.0.1)
ACUTE = [acute_a, acute_b]

square_base = four.by_cases.claim(
    "2.0.6",
    71,
    r"b = 45^\circ",
    words="For b = 45 degrees, and no other b, the base is a square.",
    states=rf"{ALONG_OX} = {ALONG_OY} \Leftrightarrow b = 45^\circ",
    given=ACUTE,
    uses=["2.0.1"],
)

base_along_oy = four.by_cases.claim(
    "2.0.7",
    71,
    r"0^\circ < b < 45^\circ",
    words="For these b, and no others, the longer side of the base is parallel to OY.",
    states=rf"{ALONG_OX} < {ALONG_OY} \Leftrightarrow 0^\circ < b < 45^\circ",
    given=ACUTE,
    uses=["2.0.1"],
)

base_along_ox = four.by_cases.claim(
    "2.0.8",
    71,
    r"45^\circ < b < 90^\circ",
    words="For these b, and no others, the longer side of the base is parallel to OX.",
    states=rf"{ALONG_OX} > {ALONG_OY} \Leftrightarrow 45^\circ < b < 90^\circ",
    given=ACUTE,
    uses=["2.0.1"],
)

parameters = premise("2.0.9", 71, words="The angles a and b are the parameters of the system.")

total_momentum = four.total_momentum("2.1", 73)

equal_wheels = four.equal_wheels(
    "2.1.1", 75, (r"-h_{\max} \leq h_i \leq h_{\max}", r"h_{\max}"), four_wheels_in_spacecraft
)

components_of_momentum = four.claim(
    "2.1.2",
    77,
    r"\begin{aligned}H_x &= (h_1 + h_2 + h_3 + h_4) \sin a \sin b, & H_y &= (-h_1 + h_2 - h_3 + h_4) \sin a \cos b, \\ "
    r"H_z &= (-h_1 - h_2 + h_3 + h_4) \cos a.\end{aligned}",
    uses=["2.0.4", "2.1"],
)

shorthand = four.shorthand("2.1.3", 79, "2.1", "Square brackets list the momenta of the wheels: ")

round_brackets = four.round_brackets("2.1.4", 79)

unit_of_momentum = four.unit_of_momentum("2.1.5", 79, "2.1.3", four_wheels_in_spacecraft)

region = four.region_of_momenta("2.1.6", 81)

region_is_convex = four.claim(
    "2.1.7",
    81,
    words="P is convex: between two of its points lies the H of the momenta between.",
    states=(
        r"u[h_1, h_2, h_3, h_4] + (1 - u)[l_1, l_2, l_3, l_4] = "
        r"[uh_1 + (1 - u)l_1, uh_2 + (1 - u)l_2, uh_3 + (1 - u)l_3, uh_4 + (1 - u)l_4]",
        r"(0 \leq u \leq 1 \land -1 \leq h_1 \leq 1 \land -1 \leq l_1 \leq 1) \Rightarrow -1 \leq uh_1 + (1 - u)l_1 \leq 1",
    ),
    by={"a": identity, "b": cases("u(1 + h_1) + (1 - u)(1 + l_1)", "u(1 - h_1) + (1 - u)(1 - l_1)")},
    uses=["2.1.3"],
)

region_is_symmetric = four.symmetric_region("2.1.8", 81, "2.1.3")

vertices_take_full_momenta = four.full_momenta_at_vertices("2.1.9", 81, "2.1.3")

zero_is_inside = four.by_cases.claim(
    "2.1.10",
    81,
    words="The combinations 2.1.11 and 2.1.12 lie inside P: no direction c is perpendicular to all axes, so P goes on beyond 0 along each c.",
    states=r"(\mathbf{c}, \mathbf{e}_i) = 0 \Rightarrow (c_1 = 0 \land c_2 = 0 \land c_3 = 0)",
    given=OPEN_RANGE,
    uses=["2.0.4", "2.1.11", "2.1.12"],
)

first_zero_combination = four.claim(
    "2.1.11",
    83,
    r"\mathbf{H} = [1, -1, -1, 1] = (0, 0, 0)",
    imposed="a",
    uses=["2.0.4", "2.1.3"],
)

second_zero_combination = four.claim(
    "2.1.12",
    83,
    r"\mathbf{H} = [-1, 1, 1, -1] = (0, 0, 0)",
    imposed="a",
    uses=["2.0.4", "2.1.3"],
)

pairs_of_vertices = four.pairs_of_vertices("2.1.13", 83, r"i = 1, \dots, 7")

no_three_axes_in_a_plane = four.no_three_in_a_plane(
    "2.1.14",
    83,
    ". So each two of the n wheels make a pair of opposite faces, rhombi: there are n(n - 1) faces, 2n(n - 1) edges and, by "
    "Euler's formula, n(n - 1) + 2 vertices.",
    given=OPEN_RANGE,
    uses=["2.0.4"],
)

number_of_vertices = four.number_of_vertices(
    "2.1.15",
    83,
    f": of the 16 combinations the two zero ones are none, and the others are (list of vertices). {CORNERS}.",
    *("2.1.9", "2.1.10", "2.1.11", "2.1.12", "2.1.14", "2.1V"),
)

number_of_edges = four.number_of_edges("2.1.16", 100, "2.1.14", "2.1E")

parameter_of_edges = four.parameter_of_edges("2.1.17", 111)

number_of_faces = four.number_of_faces("2.1.18", 111, "", "2.1.14", "2.1F")

pairs_of_faces = four.pairs_of_faces("2.1.19", 111, r"i = 1, \dots, 6")

sense_of_edges = four.sense_of_edges("2.1.20", 128)

euler_characteristic = four.claim(
    "2.1.21",
    128,
    "14 + 12 - 24 = 2",
    words="Vertices and faces less edges, as for every convex polyhedron.",
    uses=["2.1.15", "2.1.16", "2.1.18"],
)

ANGLES = (r"a = 67^\circ", r"b = 32^\circ")

angles_of_table_1 = four.premise(
    "2.1.22",
    128,
    ANGLES,
    words="The angles of table 1, chosen in section 2.3 (2.3.6, 2.3.9).",
    states=", ".join(ANGLES),
)

# --- 2.1: symmetries


QUARTER_TURN = r"\begin{pmatrix} 0 & -1 & 0 \\ 1 & 0 & 0 \\ 0 & 0 & 1 \end{pmatrix}"  # about OZ

half_turns = four.half_turns("2.1.23", 162, "2.0.4", "4, 3, 2, 1", "-2, -1, -4, -3", "-3, -4, -1, -2")

quarter_turns = four.by_cases.claim(
    "2.1.24",
    162,
    r"b = p/4 = 45^\circ",
    words="For b = pi/4 also when turned about OZ by any multiple of pi/2.",
    states=(
        rf"b = \pi/4 \Rightarrow ({four.turned(QUARTER_TURN, '2, -3, 4, -1')})",
        r"\pi/4 = 45^\circ",
    ),
    uses=["2.0.4"],
    damage=lost_pi(r"b = \pi/4 = 45^\circ, n\pi/2"),
)

planes_of_symmetry = four.planes_of_symmetry("2.1.25", 162, "2.0.4", "-4, -3, -2, -1", "2, 1, 4, 3", "3, 4, 1, 2")

# --- 2.1: distances

edges_of_length_two = four.edges_of_length_two("2.1.26", 164, uses=["2.0.3", "2.1.17"])

faces_are_rhombi = four.faces_are_rhombi("2.1.27", 164, OPEN_RANGE, "2.1.26")

DISTANCES = {"d_1": r"4 \sin a \sin b", "d_2": r"4 \sin a \cos b", "d_3": r"4 \cos a"}
NAMED_OF_FOUR = named.in_sentence(named.VERTICES_OF_FOUR)


def vertices_named(notation: Notation, stem: str, far: Sequence[Named]) -> Scope:
    """With d_1, d_2, ... for the distances of the vertices that are named first with them."""
    each = ", ".join(f"{stem}_{group.labels[0].index}" for group in far)
    return Scope(notation, partial(derivation.vertex_distances, each))


vertices = vertices_named(four_wheels, "V", NAMED_OF_FOUR)


def distance_of_vertices(scope: Scope, number: str, far: Named, **further: Any) -> Claim:
    """A printed distance d_k = ... of the first of the vertices named with it."""
    return scope.claim(number, far.line, far.distance, words=f"Distance of {far.words} from the centre.", **further)


def equally_far(scope: Scope, number: str, letter: str, named: Sequence[Named]) -> tuple[Claim, ...]:
    """That the others of the vertices named with d_k have this distance too, if there are any."""
    states = tuple(
        rf"\sqrt{{(\mathbf{{{letter}}}_{i}, \mathbf{{{letter}}}_{i})}} = d_{k}"
        for k, far in enumerate(named, 1)
        for i in far.indices[1:]
    )
    words = "The others of the vertices named with a distance, and their opposites, have it too."
    return (scope.claim(number, named[0].line, words=words, states=states, uses=["2.1.31"]),) if states else ()


distance_of_v1 = distance_of_vertices(vertices, "2.1.28", NAMED_OF_FOUR[0], given=OPEN_RANGE)

distance_of_v6 = distance_of_vertices(
    vertices,
    "2.1.29",
    NAMED_OF_FOUR[1],
    given=OPEN_RANGE,
    by=theorems(Applied("equal_squares", ("d_2", r"4 \sin a \cos b"))),
)

distance_of_v7 = distance_of_vertices(vertices, "2.1.30", NAMED_OF_FOUR[2], given=OPEN_RANGE)

distance_of_v2 = distance_of_vertices(vertices, "2.1.31", NAMED_OF_FOUR[3])

distance_of_v3_to_v5 = equally_far(vertices, "2.1.32", "V", NAMED_OF_FOUR)

vertices_with_a_distance = named.every_one_once(
    "2.1.37", of_four, NAMED_OF_FOUR, "Each vertex is named with one of these distances, once.", four_wheels
)

two_equal_distances = four.by_cases.claim(
    "2.1.33",
    164,
    ("d_1 = d_2", r"b = p/4 = 45^\circ"),
    words="V_1 and V_6 are equally far for b = pi/4, and only then.",
    states=(rf"{DISTANCES['d_1']} = {DISTANCES['d_2']} \Leftrightarrow b = \pi/4", r"\pi/4 = 45^\circ"),
    given=ACUTE,
    uses=["2.1.28", "2.1.29"],
    damage=lost_pi(r"b = \pi/4 = 45^\circ", "b"),
)


def three_equal_distances_of(
    scope: Scope, number: str, line: int, vertices: str, equal: str, uses: Sequence[str]
) -> Claim:
    """That three pairs of vertices are equally far for these angles only, with the distances written out."""
    return scope.by_cases.claim(
        number,
        line,
        ("d_1 = d_2 = d_3", r"a = \arctg \sqrt{2} = 54.7^\circ", r"b = p/4 = 45^\circ"),
        words=f"{vertices} are equally far for a = arctg sqrt 2 and b = pi/4, and only then.",
        states=(
            rf"({equal}) \Leftrightarrow (a = \arctg \sqrt{{2}} \land b = \pi/4)",
            r"\arctg \sqrt{2} \approx 54.7^\circ",
            r"\pi/4 = 45^\circ",
        ),
        given=ACUTE,
        uses=uses,
        damage=lost_pi(r"b = \pi/4 = 45^\circ", "c"),
    )


three_equal_distances = three_equal_distances_of(
    four,
    "2.1.34",
    164,
    "V_1, V_6 and V_7",
    f"{DISTANCES['d_1']} = {DISTANCES['d_2']} = {DISTANCES['d_3']}",
    uses=["2.1.28", "2.1.29", "2.1.30"],
)

# --- table 2: the order of the distances

QUADRANT = r"0 \leq a \leq \pi/2"
LEFT_COLUMN = Hypothesis("left column", "0 <= b <= pi/4, and a from 0 to pi/2", rf"0 \leq b \leq \pi/4, {QUADRANT}")
RIGHT_COLUMN = Hypothesis(
    "right column", "pi/4 <= b <= pi/2, and a from 0 to pi/2", rf"\pi/4 \leq b \leq \pi/2, {QUADRANT}"
)
# angles by their tangent, and the right angle as it is printed
SECANT, COSECANT, RIGHT_ANGLE = (
    r"\arctg\left(\frac{1}{\cos b}\right)",
    r"\arctg\left(\frac{1}{\sin b}\right)",
    r"\frac{p}{2}",
)

columns_of_table_2 = four.premise(
    "T2.0",
    170,
    (r"0 \leq b \leq \frac{p}{4}", r"\frac{p}{4} \leq b \leq \frac{p}{2}"),
    words="The two columns of table 2.",
    damage=lost_pi(r"0 \leq b \leq \frac{\pi}{4}, \frac{\pi}{4} \leq b \leq \frac{\pi}{2}"),
)


def order_of_distances(number: str, line: int, order: str, low: str, high: str, column: Hypothesis) -> Claim:
    """A pair of cells: an order of the distances, as printed, and the interval of a in which it holds."""
    interval = rf"{low} \leq a \leq {high}"
    written_out = re.sub("d_.", lambda distance: DISTANCES[distance[0]], order)
    return four.by_cases.claim(
        number,
        line,
        (order, interval),
        words="The order holds for these a, and for no others, wherever the denominator is not zero (T2.7, T2.8).",
        states=rf"{written_out} \Leftrightarrow {interval.replace('p}', chr(92) + 'pi}')}",
        given=[column],
        uses=["2.1.28", "2.1.29", "2.1.30"],
        damage=lost_pi(interval.replace("p}", r"\pi}")) if high == RIGHT_ANGLE else None,
    )


table_2 = (
    order_of_distances("T2.1", 171, r"d_1 \leq d_2 \leq d_3", "0", SECANT, LEFT_COLUMN),
    order_of_distances("T2.2", 171, r"d_2 \leq d_1 \leq d_3", "0", COSECANT, RIGHT_COLUMN),
    order_of_distances("T2.3", 172, r"d_1 \leq d_3 \leq d_2", SECANT, COSECANT, LEFT_COLUMN),
    order_of_distances("T2.4", 172, r"d_2 \leq d_3 \leq d_1", COSECANT, SECANT, RIGHT_COLUMN),
    order_of_distances("T2.5", 173, r"d_3 \leq d_1 \leq d_2", COSECANT, RIGHT_ANGLE, LEFT_COLUMN),
    order_of_distances("T2.6", 173, r"d_3 \leq d_2 \leq d_1", SECANT, RIGHT_ANGLE, RIGHT_COLUMN),
)

order_at_b_zero = four.by_cases.ours(
    "T2.7",
    173,
    words="At the end b = 0 of the left column 1/sin b has no value; with pi/2 for its arctangent, the limit, the table is right: "
    "d_1 <= d_3 <= d_2 holds from a = pi/4 on; d_1 = 0 is reached by d_3 at a = pi/2 only.",
    states=(
        r"4 \sin a \sin b \leq 4 \cos a \leq 4 \sin a \cos b \Leftrightarrow \pi/4 \leq a \leq \pi/2",
        r"4 \cos a = 4 \sin a \sin b \Leftrightarrow a = \pi/2",
    ),
    given=[Hypothesis("b zero", "b = 0, and a from 0 to pi/2", rf"b = 0, {QUADRANT}")],
    uses=["T2.3", "T2.5"],
)

order_at_b_right = four.by_cases.ours(
    "T2.8",
    173,
    words="So it is at the end b = pi/2 of the right column, where 1/cos b has no value.",
    states=(
        r"4 \sin a \cos b \leq 4 \cos a \leq 4 \sin a \sin b \Leftrightarrow \pi/4 \leq a \leq \pi/2",
        r"4 \cos a = 4 \sin a \cos b \Leftrightarrow a = \pi/2",
    ),
    given=[Hypothesis("b right", "b = pi/2, and a from 0 to pi/2", rf"b = \pi/2, {QUADRANT}")],
    uses=["T2.4", "T2.6"],
)

# --- table 3: the distances of the faces

FACES_OF_P = named.faces(of_four)


def row_of_distances(scope: Scope, number: str, row: Sequence[Named]) -> Claim:
    """A row of a table of faces: what is printed is the distance r_i of the plane of F_i and F'_i from the centre."""
    return scope.claim(
        number,
        row[0].line,
        tuple(each.distance for each in row),
        words=f"Distances of {'; of '.join(each.words for each in row)}.",
        states=tuple(AND.join(f"r_{i} = {each.distance}" for i in each.indices) for each in row),
        given=OPEN_RANGE,
        uses=["2.0.4"],
    )


table_3 = Scope(four_wheels, partial(derivation.distances_of_faces, *FACES_OF_P))
NAMED_IN_TABLE_3 = named.in_columns(named.TABLE_3)
ABOVE_THE_EMPTY_CELL, EMPTY_CELL = NAMED_IN_TABLE_3[2], NAMED_IN_TABLE_3[5]

faces_of_table_3 = named.every_one_once(
    "T3.0", of_four, NAMED_IN_TABLE_3, "Each face is in the table, once.", four_wheels
)

first_row_of_table_3 = row_of_distances(table_3, "T3.1", NAMED_IN_TABLE_3[:3])

second_row_of_table_3 = row_of_distances(table_3, "T3.2", NAMED_IN_TABLE_3[3:5])

missing_cell_of_table_3 = table_3.claim(
    "T3.3",
    181,
    EMPTY_CELL.printed,
    words=f"Distance of {EMPTY_CELL.words}: the cell is empty.",
    states=AND.join(f"r_{i} = {ABOVE_THE_EMPTY_CELL.distance}" for i in EMPTY_CELL.indices),
    damage=Damage(
        ABOVE_THE_EMPTY_CELL.distance,
        reason="Its row names the faces and gives no distance. F_6 has the distance of F_3 above it, as F_5 has that of F_1 and F_4 that "
        "of F_2; one cell for both rows, as in table 8 and twice in table 11, is what the digital text splits and leaves empty.",
        kind="missing cell",
    ),
    given=OPEN_RANGE,
    uses=["2.0.4"],
)


def foot(middle: str, along: str, across: str) -> str:
    """The foot of the perpendicular from the centre is on one diagonal of the face, between its ends: s along, t across."""
    return rf"({middle}, {across}) = 0 \land ({middle}, {along})^2 \leq ({along}, {along})^2"


feet_of_perpendiculars = four.ours(
    "2.1.35",
    180,
    words="The foot of the perpendicular from the centre lies within each face, on a diagonal: so the distance of its plane is that of "
    "the face (F_1, F_2, F_3; the other faces are these, turned).",
    states=(
        foot(r"\mathbf{e}_1 + \mathbf{e}_2", r"\mathbf{e}_3 + \mathbf{e}_4", r"\mathbf{e}_3 - \mathbf{e}_4"),
        foot(r"\mathbf{e}_2 - \mathbf{e}_3", r"\mathbf{e}_4 - \mathbf{e}_1", r"\mathbf{e}_4 + \mathbf{e}_1"),
        foot(r"\mathbf{e}_1 + \mathbf{e}_3", r"\mathbf{e}_2 + \mathbf{e}_4", r"\mathbf{e}_2 - \mathbf{e}_4"),
    ),
    by=cases(
        r"(8\cos a \sin a \sin b)^2",
        r"(8\cos a \sin a \cos b)^2",
        r"(8\sin^2 a \sin b \cos b)^2",
    ),
    uses=["2.1.23", "T3.1", "T3.2", "T3.3"],
)

# --- 2.2: one wheel fails

wheels_are_alike = four.claim(
    "2.1.36",
    185,
    words="Without loss of generality the wheel along e_4 fails: the half turns, which leave P as it is, take e_4 to each other axis, "
    "but for its sense.",
    states=(
        r"\operatorname{diag}(1, -1, -1) \mathbf{e}_4 = \mathbf{e}_1",
        r"\operatorname{diag}(-1, 1, -1) \mathbf{e}_4 = -\mathbf{e}_3",
        r"\operatorname{diag}(-1, -1, 1) \mathbf{e}_4 = -\mathbf{e}_2",
    ),
    uses=["2.1.23"],
)

momentum_without_wheel_4 = three.total_momentum("2.2", 187, "three wheels that work", uses=["2.1"])

components_without_wheel_4 = three.claim(
    "2.2.1",
    191,
    (
        r"H_x = (h_1 + h_2 + h_3) \sin a \sin b, \quad H_y = (-h_1 + h_2 - h_3) \sin a \cos b;",
        r"H_z = (-h_1 - h_2 + h_3) \cos a.",
    ),
    uses=["2.0.4", "2.2"],
    lines={"c": 193},
)

shorthand_of_three = three.shorthand("2.2.2", 195, "2.2")

limits_of_three = three.premise(
    "2.2.3",
    195,
    (r"-h_{\max} \leq h_i \leq h_{\max}", r"i = 1, \dots, 3", r"|h_i| \leq 1"),
    words="The limits of the wheels that work; P' is the region of all H with |h_i| <= 1.",
    states=WITHIN_LIMITS,
)

unit_of_momentum_of_three = three.unit_of_momentum(
    "2.2.4", 195, "2.2.2", three_of_four.extended(LIMIT), "Again no generality is lost with h_max = 1."
)

region_is_a_parallelepiped = three.by_cases.claim(
    "2.2.5",
    195,
    words="P' is a parallelepiped: the three axes do not lie in one plane, so each H has one h_1, h_2, h_3.",
    states=r"(\mathbf{e}_1, \mathbf{e}_2 \times \mathbf{e}_3) \ne 0",
    given=OPEN_RANGE,
    uses=["2.1.14"],
)

eight_vertices = three.number_of_vertices(
    "2.2.6",
    195,
    ", as every parallelepiped: the three axes are not in a plane, and all combinations are.",
    "2.2.5",
    "2.2V",
)

pairs_of_vertices_of_three = three.pairs_of_vertices("2.2.7", 195, r"i = 1, \dots, 4", ".")

twelve_edges = three.number_of_edges("2.2.8", 199, "2.2.5", "2.2E")

parameter_of_edges_of_three = three.parameter_of_edges("2.2.9", 203)

six_faces = three.number_of_faces("2.2.10", 203, ", as every parallelepiped", "2.2.5", "2.2F")

pairs_of_faces_of_three = three.pairs_of_faces("2.2.11", 203, "i = 1, 2, 3")

sense_of_edges_of_three = three.sense_of_edges("2.2.12", 211)

angles_of_table_4 = four.premise(
    "2.2.13", 211, ANGLES, words="The angles of table 4, those of table 1.", states=", ".join(ANGLES)
)

LOST_PRIME = (
    "The sentence names the edges along e_4 in both halves of P, and all three pairs of the primed half lack the prime of their first "
    "vertex; as printed they are no edges. The edge list of section 2.1 loses primes at the same place, and the sentence itself keeps "
    "the prime of each of these vertices where it stands alone: a pattern of the reading of the text, not of its author."
)


def shrinks(first: str, last: str) -> str:
    """The edge from the first vertex to the last is 2 e_4."""
    return rf"{last} - {_subtracted(first)} = 2\mathbf{{e}}_4"


def _subtracted(vertex: str) -> str:
    return f"({vertex})" if vertex.startswith("-") else vertex


def lost_prime(edge: str, corrected: str) -> Erratum:
    """The erratum of an edge that should read so."""
    return Erratum(corrected, "lost prime", Origin.OCR, LOST_PRIME, shown=edge)


# as printed, and what the first three should be
EDGES_ALONG_WHEEL_4 = ("V_4V_7'", "V_1V_5'", "V_3V_6'", "V_7V_4", "V_5V_1", "V_6V_3")
PRIMED_EDGES = ("V_4'V_7'", "V_1'V_5'", "V_3'V_6'")
MIDDLES = ("V_4'", "V_1'", "V_3'", "V_4", "V_1", "V_3")


edges_that_shrink = four.claim(
    "2.2.14",
    235,
    EDGES_ALONG_WHEEL_4,
    words="P' is P with these edges shrunk to length zero: they are the edges parallel to e_4.",
    states=tuple(shrinks(*points(edge)) for edge in EDGES_ALONG_WHEEL_4),
    errata={letter: lost_prime(edge, shrinks(*points(edge))) for letter, edge in zip("abc", PRIMED_EDGES, strict=True)},
    uses=["2.1.17"],
)


def halves(edge: str, middle: str) -> str:
    """The vertex of P' is the middle of the edge of P."""
    (first, last), (place,) = points(edge), points(middle, "W")
    sign = "" if last.startswith("-") else "+"
    return rf"{place} = \frac{{1}}{{2}} ({first} {sign} {last})"


vertices_at_middles = claim(
    "2.2.15",
    235,
    EDGES_ALONG_WHEEL_4,
    words=f"The vertices {', '.join(MIDDLES)} of P' (W in the formal statement) are the middles of these edges of P, in this order.",
    states=tuple(halves(edge, middle) for edge, middle in zip(EDGES_ALONG_WHEEL_4, MIDDLES, strict=True)),
    errata={
        letter: lost_prime(edge, halves(edge, middle))
        for letter, edge, middle in zip("abc", PRIMED_EDGES, MIDDLES[:3], strict=True)
    },
    uses=["2.2.14"],
    notation=four_and_three,
)

edges_of_three_of_length_two = three.edges_of_length_two("2.2.16", 235, uses=["2.0.3", "2.2.9"])

faces_of_three_are_rhombi = three.faces_are_rhombi("2.2.17", 235, OPEN_RANGE, "2.2.16")

NAMED_OF_THREE = named.in_sentence(named.VERTICES_OF_THREE)
vertices_of_three = vertices_named(three_of_four, "W", NAMED_OF_THREE)

distances_of_three = tuple(
    distance_of_vertices(vertices_of_three, number, each)
    for number, each in zip(("2.2.18", "2.2.19", "2.2.20", "2.2.21"), NAMED_OF_THREE, strict=True)
)

vertices_of_three_with_a_distance = named.every_one_once(
    "2.2.31", of_three, NAMED_OF_THREE, "Each vertex of P' is named with one of these distances, once.", three_of_four
)

two_equal_distances_of_three = vertices_of_three.claim(
    "2.2.22",
    235,
    ("d_1 = d_2", r"b = p/4 = 45^\circ"),
    words="V_1 and V_3 are equally far for b = pi/4, and only then.",
    states=(
        r"d_1^2 - d_2^2 = 8 \sin^2 a (\sin b + \cos b)(\sin b - \cos b)",
        r"\sin b - \cos b = 0 \Leftrightarrow b = \pi/4",
        r"\pi/4 = 45^\circ",
    ),
    given=ACUTE,
    by={"a": identity, "b": cases(), "c": identity},
    uses=["2.2.18", "2.2.19"],
    damage=lost_pi(r"b = \pi/4 = 45^\circ", "bc"),
)

three_equal_distances_of_three = three_equal_distances_of(
    vertices_of_three,
    "2.2.23",
    235,
    "V_1, V_3 and V_4",
    r"d_1 = d_2 \land d_2 = d_3",
    uses=["2.2.18", "2.2.19", "2.2.20"],
)


def _square(distance: str) -> str:
    """The square of a distance of a vertex of P."""
    return rf"({DISTANCES[distance]})^2"


order_of_three = vertices_of_three.claim(
    "2.2.24",
    237,
    words="The distances d_1, d_2, d_3 are ordered as table 2 says, which is of P: their squares differ by half as much.",
    states=tuple(
        rf"{one}^2 - {other}^2 = \frac{{1}}{{2}} ({_square(one)} - {_square(other)})"
        for one, other in (("d_1", "d_2"), ("d_2", "d_3"), ("d_3", "d_1"))
    ),
    uses=["T2.1", "T2.2", "T2.3", "T2.4", "T2.5", "T2.6"],
)

FACES_OF_THREE = named.faces(of_three)
NAMED_IN_TABLE_5 = named.in_columns(named.TABLE_5)

faces_of_table_5 = named.every_one_once(
    "T5.0", of_three, NAMED_IN_TABLE_5, "Each face of P' is in the table, once.", three_of_four
)

table_5 = row_of_distances(
    Scope(three_of_four, partial(derivation.distances_of_faces, *FACES_OF_THREE)), "T5.1", NAMED_IN_TABLE_5
)


def foot_of_three(middle: str, along: str, across: str) -> str:
    """The same in a face of P': half way to a corner across it, at most half way along it."""
    return rf"2 ({middle}, {across}) = ({across}, {across}) \land (2 ({middle}, {along}))^2 \leq ({along}, {along})^2"


feet_of_perpendiculars_of_three = three.by_cases.ours(
    "2.2.25",
    244,
    words="Here too the foot of the perpendicular lies within each face.",
    states=(
        foot_of_three(r"\mathbf{e}_3", r"\mathbf{e}_1 + \mathbf{e}_2", r"\mathbf{e}_1 - \mathbf{e}_2"),
        foot_of_three(r"\mathbf{e}_1", r"\mathbf{e}_2 - \mathbf{e}_3", r"\mathbf{e}_2 + \mathbf{e}_3"),
        foot_of_three(r"\mathbf{e}_2", r"\mathbf{e}_1 + \mathbf{e}_3", r"\mathbf{e}_1 - \mathbf{e}_3"),
    ),
    uses=["T5.1"],
)

# --- 2.3: the spacecraft

equal_rates_wanted = craft.premise(
    "2.2.26",
    246,
    words="The largest rates about OX, OY and OZ are to be equal (lines 246 and 248).",
)

moments_of_inertia = wheels.moments_of_inertia(numbers, "2.2.27", 248, "")

such_a_body_exists = craft.by_cases.ours(
    "2.2.28",
    248,
    words="Such a body exists: no moment exceeds the sum of the other two.",
    states=r"J_y + J_z \geq J_x \land J_z + J_x \geq J_y \land J_x + J_y \geq J_z",
    given=[SPACECRAFT_MOMENTS],
    uses=["2.2.27"],
)

body_at_rest = craft.premise(
    "2.2.29",
    248,
    words="The total angular momentum of body and wheels is zero; w is the absolute rate of the body, H the momentum of the wheels.",
)

no_angular_momentum = craft.claim(
    "2.2.30",
    250,
    r"J_x w_x + H_x = 0, \quad J_y w_y + H_y = 0, \quad J_z w_z + H_z = 0.",
    words="Its components in the principal axes.",
    equation=derivation.angular_momentum,
    uses=["2.2.29"],
)

AT_REST = Hypothesis("no angular momentum", "2.2.30", r"J_x w_x + H_x = 0, J_y w_y + H_y = 0, J_z w_z + H_z = 0")

rates = craft.claim(
    "2.3",
    254,
    r"w_x = -\frac{H_x}{J_x}, \quad w_y = -\frac{H_y}{J_y}, \quad w_z = -\frac{H_z}{J_z}.",
    given=[AT_REST, MASS],
    uses=["2.2.30"],
)

EQUAL_RATES = Hypothesis(
    "equal rates",
    "the largest rates about the three axes are equal (line 256)",
    r"4 J_y \sin a \sin b = 4 J_x \sin a \cos b, 4 J_z \sin a \cos b = 4 J_y \cos a, 4 J_x \cos a = 4 J_z \sin a \sin b",
)

equal_rates = craft.premise(
    "2.3.1",
    256,
    "w_x = w_y = w_z",
    words="The condition: the largest rates are equal.",
)

LARGEST = {  # the largest component, its value, who is zero beside it, the momenta of the wheels, what is missing to it
    "x": (r"H_x = 4 \sin a \sin b", ("H_y", "H_z"), (1, 1, 1, 1), r"\sin a \sin b"),
    "y": (r"H_y = 4 \sin a \cos b", ("H_x", "H_z"), (-1, 1, -1, 1), r"\sin a \cos b"),
    "z": (r"H_z = 4 \cos a", ("H_x", "H_y"), (-1, -1, 1, 1), r"\cos a"),
}


def _shortage(axis: str) -> str:
    """What is missing to the largest component, as a sum of terms that are not negative."""
    _, _, signs, share = LARGEST[axis]
    return " + ".join(f"{share} (1 {'-' if sign > 0 else '+'} h_{i})" for i, sign in enumerate(signs, 1))


def largest_component(number: str, axis: str) -> Claim:
    """The largest component along an axis."""
    largest, _, signs, _ = LARGEST[axis]
    return four.largest_component(
        number, 256, largest, ", ".join(map(str, signs)), _shortage(axis), OPEN_RANGE, "2.1.2"
    )


largest_components = (
    largest_component("2.3.2", "x"),
    largest_component("2.3.3", "y"),
    largest_component("2.3.4", "z"),
)

AT_THE_ANGLES = Hypothesis(
    "at the angles found",
    "the spacecraft of line 248 with b and a of 2.3.6 and 2.3.8, and the largest momenta, 2.3.2 to 2.3.4",
    r"J_x = 1000, J_y = 1600, J_z = 800, b = \arctg \frac{5}{8}, a = \arctg\left(\frac{2}{\cos b}\right), "
    + ", ".join(value for value, *_ in LARGEST.values()),
)
COMMA = (
    "The sentence is that of line 616, where a comma stands between the ratio of the moments of inertia and that of the momenta; the "
    "dot that stands here in both ratios multiplies what should be equal. A comma at the foot of a fraction was read as a dot."
)

ratio_of_x_and_y = craft.claim(
    "2.3.5",
    256,
    r"\frac{H_x}{J_x} = \frac{J_y}{J_x} \cdot \frac{4 \sin a \sin b}{4 \sin a \cos b} = \frac{5}{8}",
    given=[AT_THE_ANGLES],
    uses=["2.2.27", "2.3.1", "2.3.2", "2.3.3"],
    errata={
        "a": Erratum(
            r"\frac{H_x}{H_y} = \frac{J_x}{J_y}",
            "letter",
            Origin.UNCERTAIN,
            "A ratio of momentum and inertia cannot equal one of two inertias: equal rates mean H_x/H_y = J_x/J_y, as the next ratio "
            "has it for y and z. Three of the four letters are wrong; nothing tells the author's slip from the reading of small "
            f"letters. {COMMA}",
        ),
        "b": Erratum(
            r"\frac{4 \sin a \sin b}{4 \sin a \cos b} = \frac{5}{8}",
            "typography",
            Origin.OCR,
            COMMA,
        ),
    },
)

angle_b = craft.by_cases.claim(
    "2.3.6",
    256,
    r"b = \arctg \frac{5}{8} = 32^\circ",
    words="The angle b from it, rounded to whole degrees.",
    states=(
        r"\frac{4 \sin a \sin b}{J_x} = \frac{4 \sin a \cos b}{J_y} \Leftrightarrow b = \arctg \frac{5}{8}",
        r"\arctg \frac{5}{8} \approx 32^\circ",
    ),
    given=[SPACECRAFT_MOMENTS, *ACUTE],
    uses=["2.3.1", "2.3.5"],
)

ratio_of_y_and_z = craft.claim(
    "2.3.7",
    258,
    r"\frac{H_y}{H_z} = \frac{J_y}{J_z} \cdot \frac{4 \sin a \cos b}{4 \cos a} = 2",
    given=[AT_THE_ANGLES],
    uses=["2.2.27", "2.3.1", "2.3.3", "2.3.4"],
    errata={
        "a": Erratum(r"\frac{H_y}{H_z} = \frac{J_y}{J_z}", "typography", Origin.OCR, COMMA),
        "b": Erratum(r"\frac{4 \sin a \cos b}{4 \cos a} = 2", "typography", Origin.OCR, COMMA),
    },
)

EQUAL_RATES_OF_Y_AND_Z = Hypothesis(
    "equal rates of y and z", "the largest rates about OY and OZ are equal", r"4 J_z \sin a \cos b = 4 J_y \cos a"
)

tangent_of_a = craft.claim(
    "2.3.8",
    260,
    r"\operatorname{tg} a = \frac{2}{\cos b}",
    given=[*OPEN_RANGE, SPACECRAFT_MOMENTS, EQUAL_RATES_OF_Y_AND_Z],
    uses=["2.3.1", "2.3.7"],
)

angle_a = craft.claim(
    "2.3.9",
    260,
    r"a = 67^\circ.",
    words="The angle a from it, rounded to whole degrees, with b exact or rounded.",
    states=(
        r"\arctg\left(\frac{2}{\cos\left(\arctg \frac{5}{8}\right)}\right) \approx 67^\circ",
        r"\arctg\left(\frac{2}{\cos 32^\circ}\right) \approx 67^\circ",
    ),
    uses=["2.3.6", "2.3.8"],
)

largest_rates = numbers.claim(
    "2.3.10",
    262,
    r"w_x = w_y = w_z = 0.002 h_{\max} \text{ кг}^{-1} \text{ м}^{-2}",
    words="The largest rates, in absolute value and for h_max = 1; N m s / (kg m^2) is 1/s, so kg^-1 m^-2 before h_max is right.",
    states=tuple(rf"-w_{x} \approx 0.002" for x in "xyz"),
    given=[AT_THE_ANGLES, RATES],
    uses=["2.3", "2.3.2", "2.3.3", "2.3.4", "2.3.6", "2.3.8"],
)

largest_rates_exactly = numbers.ours(
    "2.3.11",
    262,
    words="They are equal, exactly: 1/(50 sqrt 105), or 0.00195 h_max.",
    states=(*(rf"-w_{x} = \frac{{1}}{{50 \sqrt{{105}}}}" for x in "xyz"), r"-w_x \approx 0.00195"),
    given=[AT_THE_ANGLES, RATES],
    uses=["2.3.10"],
)


units_of_the_rates = ours(
    "2.3.12",
    262,
    words="With units: a momentum of so many h_max, over a moment of inertia in kg m^2, leaves kg^-1 m^-2 before h_max.",
    states=tuple(
        rf"\frac{{{most} \cdot h_{{\max}}}}{{J_{x}}} = \frac{{{most}}}{{{moment}}} h_{{\max}} \text{{ кг}}^{{-1}} \text{{ м}}^{{-2}}"
        for x, most, moment in zip("xyz", DISTANCES.values(), (1000, 1600, 800), strict=True)
    ),
    given=[
        Hypothesis(
            "units",
            "the moments of inertia of line 248 with their unit",
            ", ".join(
                rf"J_{x} = {moment} \text{{ кг}} \text{{ м}}^2"
                for x, moment in zip("xyz", (1000, 1600, 800), strict=True)
            ),
        )
    ],
    uses=["2.2.27", "2.3.10"],
    notation=four_wheels_with_units,
)


def where_largest(axis: str, then: list[str]) -> str:
    """What holds where a component has its largest value."""
    value, *_ = LARGEST[axis]
    return rf"({WITHIN_LIMITS} \land {value}) \Rightarrow ({AND.join(then)})"


largest_rate_comes_alone = four.claim(
    "2.3.13",
    262,
    words="Where one component has its largest value the other two are zero.",
    states=tuple(
        where_largest(axis, [f"{other} = 0" for other in others]) for axis, (_, others, _, _) in LARGEST.items()
    ),
    given=OPEN_RANGE,
    by={letter: cases(_shortage(axis)) for letter, axis in zip("abc", LARGEST, strict=True)},
    uses=["2.3.2", "2.3.3", "2.3.4"],
)

SUM_OF_SHORTAGES = r"4 (1 - h_1)(1 + h_1) + 4 (1 - h_2)(1 + h_2) + 4 (1 - h_3)(1 + h_3) + 4 (1 - h_4)(1 + h_4)"

IN_QUARTERS = ("(h_1 + h_2 + h_3 + h_4)", "(-h_1 + h_2 - h_3 + h_4)", "(-h_1 - h_2 + h_3 + h_4)")
SUM_OF_SQUARES = " + ".join(f"{component}^2" for component in IN_QUARTERS)
ON_AN_AXIS = AND.join(f"{one} {other} = 0" for one, other in combinations(IN_QUARTERS, 2))

other_directions = craft.claim(
    "2.3.14",
    264,
    words="In any other direction the largest rate is smaller. Counted in quarters of the largest rate about an axis the components are "
    "these sums (2.3.15): no rate is greater, and one as great is about an axis, two of its components being zero.",
    states=rf"{SUM_OF_SQUARES} \leq 4^2 \land ({SUM_OF_SQUARES} = 4^2 \Rightarrow ({ON_AN_AXIS}))",
    given=[FULL_MOMENTUM],
    by=cases(rf"{SUM_OF_SHORTAGES} + (h_1 - h_2 - h_3 + h_4)^2"),
    uses=["2.3.15", "2.3.16"],
)

rates_in_quarters = ours(
    "2.3.15",
    264,
    words="At equal largest rates each component, here without its sign, is a quarter of the largest one times the sum in 2.3.14.",
    states=(
        r"\frac{H_x}{J_x} = \frac{\sin a \sin b}{J_x} (h_1 + h_2 + h_3 + h_4)",
        r"\frac{H_y}{J_y} = \frac{\sin a \sin b}{J_x} (-h_1 + h_2 - h_3 + h_4)",
        r"\frac{H_z}{J_z} = \frac{\sin a \sin b}{J_x} (-h_1 - h_2 + h_3 + h_4)",
    ),
    given=[EQUAL_RATES],
    where=four.where,
    uses=["2.3", "2.3.1", "2.3.2", "2.3.3", "2.3.4"],
    notation=four_wheels_in_spacecraft,
)

bound_is_reached_on_the_axes = four.by_cases.ours(
    "2.3.16",
    264,
    words="Where all wheels have full momentum and h_1 - h_2 - h_3 + h_4 = 0, H lies on an axis.",
    states=r"(h_i^2 = 1 \land h_1 - h_2 - h_3 + h_4 = 0) \Rightarrow (H_x H_y = 0 \land H_y H_z = 0 \land H_z H_x = 0)",
    uses=["2.1.2"],
)

image_of_the_region = craft.claim(
    "2.3.17",
    264,
    words="The region of the rates is P after a similarity, given by (2.3): lengths along OX and OY change in one ratio.",
    states=r"\frac{w_x^2}{H_x^2} = \frac{w_y^2}{H_y^2}",
    given=[SPACECRAFT_MOMENTS, RATES],
    uses=["2.3"],
    errata={
        "": Erratum(
            r"J_x^2 w_x^2 = H_x^2 \land J_y^2 w_y^2 = H_y^2 \land J_z^2 w_z^2 = H_z^2",
            "wrong claim",
            Origin.PAPER,
            "(2.3) divides each component by a moment of inertia of its own: an affine map, which keeps edges parallel but neither "
            "angles nor ratios of lengths in different directions. It is a similarity only for equal moments; here they are 1000, "
            "1600 and 800. What follows needs only that it is affine: vertices go over into vertices.",
        )
    },
)

largest_rates_at_vertices = four.claim(
    "2.3.18",
    264,
    words="The largest rates are attained only at vertices, where all wheels have full momentum.",
    states=tuple(
        where_largest(axis, [f"h_{i} = {sign}" for i, sign in enumerate(signs, 1)])
        for axis, (_, _, signs, _) in LARGEST.items()
    ),
    given=OPEN_RANGE,
    by={letter: cases(_shortage(axis)) for letter, axis in zip("abc", LARGEST, strict=True)},
    uses=["2.3.13"],
)
