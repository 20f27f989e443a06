r"""Figures 1 to 12 of Ignatov 2005, of which the text has only the captions, and letters that change their meaning.

What the figures are to show is known as far as the text tells: views of the polytopes, their projections onto the
coordinate planes, and in figures 9 and 12 the labels of the vertices there. So it is stated here which vertices are
corners of those outlines, and which fall on one point, where a drawing has two labels.
"""

from __future__ import annotations

from symcheck.papers.declare import exclusion
from symcheck.papers.ignatov2005.wheels import AND, five, four, points, six, three

NO_DRAWING = "the drawing is not in the text at hand; "
AXES, VIEW = "the wheels stand as {} states them", "the polytope is that of the lists, {}"
OUTLINES, LABELS = "the outlines and what falls on one point: {}", "the labels, of which most points have two: {}"
FIGURES = (  # number, line where it is spoken of, what it is, what the text tells of it
    (1, 62, "The axes of four wheels", AXES.format("2.0.1")),
    (2, 148, "P, four wheels", VIEW.format("2.1V to 2.1F")),
    (3, 154, "Projections of P onto the coordinate planes", OUTLINES.format("D.13")),
    (4, 225, "P', one of four wheels failed", VIEW.format("2.2V to 2.2F")),
    (5, 230, "Projections of P' onto the coordinate planes", OUTLINES.format("D.14")),
    (6, 268, "The axes of six wheels", AXES.format("3.0.4")),
    (7, 426, "P, six wheels", VIEW.format("3.1V to 3.1F")),
    (8, 431, "Projections of P onto the coordinate planes", OUTLINES.format("D.15, D.16")),
    (9, 436, "Projection of P onto OXY with the labels of the vertices", LABELS.format("D.15")),
    (10, 571, "P', one of six wheels failed", VIEW.format("3.2V to 3.2F")),
    (11, 576, "Projections of P' onto the coordinate planes", OUTLINES.format("D.17")),
    (12, 581, "Projection of P' onto OXY with the labels of the vertices", LABELS.format("D.17")),
)

figures = tuple(
    exclusion(f"D.{number}", line, words=f"Figure {number}. {shows}.", reason=NO_DRAWING + facts)
    for number, line, shows, facts in FIGURES
)

ONTO = {
    "OXY": r"\operatorname{diag}(1, 1, 0)",
    "OXZ": r"\operatorname{diag}(1, 0, 1)",
    "OYZ": r"\operatorname{diag}(0, 1, 1)",
}


def falls_together(plane: str, pairs: str) -> str:
    """The vertices of each pair, "V_2V_4", fall on one point."""
    found = (points(pair) for pair in pairs.split(", "))
    return AND.join(f"{ONTO[plane]}({one}) = {ONTO[plane]}({other})" for one, other in found)


def halves(plane: str, sides: str) -> str:
    """A vertex falls on the middle of a side of the outline: "V_2: V_1V_6'"."""
    found = ([*points(middle), *points(side)] for middle, side in (each.split(": ") for each in sides.split(", ")))
    return AND.join(
        rf"{ONTO[plane]}({middle}) = \frac{{1}}{{2}} {ONTO[plane]}({one} + ({other}))" for middle, one, other in found
    )


projections_of_four = four.ours(
    "D.13",
    154,
    words="Four wheels: each projection onto a coordinate plane is a rhombus, with the corners V_1, V'_6, V'_1, V_6 on OXY, V_1, V'_7, "
    "V'_1, V_7 on OXZ and V_6, V'_7, V'_6, V_7 on OYZ; V_2 to V_5 and their opposites fall on the middles of its sides in pairs, "
    "the other two vertices on its centre.",
    states=(
        halves("OXY", "V_2: V_1V_6', V_4: V_1V_6', V_3: V_1V_6, V_5: V_1V_6")
        + rf"{AND}{ONTO['OXY']}\mathbf{{V}}_7 = 0",
        halves("OXZ", "V_2: V_1V_7', V_3: V_1V_7', V_4: V_1V_7, V_5: V_1V_7")
        + rf"{AND}{ONTO['OXZ']}\mathbf{{V}}_6 = 0",
        halves("OYZ", "V_2: V_6'V_7', V_3: V_6V_7', V_4: V_6'V_7, V_5: V_6V_7")
        + rf"{AND}{ONTO['OYZ']}\mathbf{{V}}_1 = 0",
    ),
    uses=["2.1V"],
)

projections_of_three = three.ours(
    "D.14",
    230,
    words="Three of them: each projection is a parallelogram, as two axes fall together, but for their sense: e_1 and e_3 on OXY, e_1 and "
    "e_2 on OXZ, e_2 and e_3 on OYZ. V_2 falls on V_4, on V_3 or on V'_1, as their opposites do; the other four are corners.",
    states=(
        falls_together("OXY", "V_2V_4"),
        falls_together("OXZ", "V_2V_3"),
        falls_together("OYZ", "V_1V_2'"),
    ),
    uses=["2.2V"],
)

labels_of_figure_9 = six.ours(
    "D.15",
    436,
    words="Figure 9: the outline on OXY is a hexagon with the corners V_14, V_15, V_16, V'_14, V'_15, V'_16; V_1 and V'_1 fall on its centre, "
    "and each other point has two labels.",
    states=(
        rf"{ONTO['OXY']}\mathbf{{V}}_1 = 0",
        falls_together("OXY", "V_2V_5', V_3V_6', V_4V_7'"),
        falls_together("OXY", "V_8V_{11}', V_9V_{12}', V_{10}V_{13}'"),
        halves("OXY", "V_8: V_{14}V_{15}, V_9: V_{15}V_{16}, V_{10}: V_{16}V_{14}'"),
    ),
    uses=["3.1V"],
)

other_projections_of_six = six.ours(
    "D.16",
    431,
    words="Six wheels on the other planes: reflections take P to itself, so that vertices fall together in pairs, but those in the plane.",
    states=(
        falls_together("OXZ", "V_2V_5, V_3V_4, V_6V_7, V_8V_{12}, V_9V_{11}, V_{14}V_{16}', V_{15}V_{15}'"),
        falls_together("OYZ", "V_3V_7, V_4V_6, V_8V_9, V_{10}V_{13}, V_{11}V_{12}, V_{14}V_{16}, V_{14}'V_{16}'"),
    ),
    uses=["3.1.24", "3.1V"],
)

labels_of_figure_12 = five.ours(
    "D.17",
    581,
    words="Figure 12: V_7, V_8, V_11 and their opposites are corners of the outline and stand alone; each other point has two labels.",
    states=falls_together("OXY", "V_1V_4', V_2V_{10}', V_3V_5', V_4V_1', V_5V_3', V_6V_9', V_9V_6', V_{10}V_2'"),
    uses=["3.2V"],
)

# --- letters that change their meaning

letters = (
    exclusion(
        "D.18",
        235,
        words="d_1, d_2, ... are distances of other vertices in each of the sections 2.1, 2.2, 3.1 and 3.2 (lines 164, 235, 443, 591).",
        reason="each is read as defined last before it; where table 2 of section 2.1 is referred to in section 2.2 its letters are those of "
        "section 2.2, which 2.2.24 decides",
    ),
    exclusion(
        "D.19",
        195,
        words="V_i, F_i and P' are named anew in each section: P' is a parallelepiped here and the region of five wheels from line 481 on.",
        reason="in statements about two regions at once the vertices of P' are written W_i",
    ),
    exclusion(
        "D.20",
        256,
        words="H_x, w_x and so on are components of momentum and rate (lines 79, 252), here and in section 3.3 their largest values.",
        reason="the largest values are claims about the components: 2.3.2 to 2.3.4, 3.2.26 to 3.2.28",
    ),
    exclusion(
        "D.21",
        264,
        words="P_omega is the region of the rates; the rates themselves are printed w, as pi is printed p.",
        reason="the Greek letter is kept here and lost elsewhere, with the font of symbols; nothing rests on it",
    ),
    exclusion(
        "D.22",
        273,
        words="The axes e_i are in bold type from (3.1) on and in a thin face before it.",
        reason="both are read as the vectors",
    ),
    exclusion(
        "D.23",
        50,
        words="J_X, w_X and so on in (1.2) are moments of inertia and largest rates required; J_x, w_x in sections 2.3 and 3.3 those of the "
        "example and its rates.",
        reason="section 1 has a notation of its own",
    ),
)
