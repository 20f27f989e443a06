r"""What the relations of Ignatov 2005 are read under without its being printed, and what holds at the ends and outside.

The paper calls a the angle between a wheel's axis and OZ, and prints a range for it in tables 2 and 7 only: from 0 to 90
degrees, with both ends. A relation whose proof needs one of these conditions is marked by it.
"""

from __future__ import annotations

from symcheck.papers.declare import standing
from symcheck.papers.ignatov2005.hypotheses import MASS, acute_a, real_pyramid
from symcheck.papers.ignatov2005.notation import four_wheels_in_spacecraft
from symcheck.papers.ignatov2005.wheels import AND, four, six

angle = standing("S.1", 71, real_pyramid, "Where a relation needs it: {}.", without="S.4 to S.9, B.2, B.24")

acute_angle = standing(
    "S.2",
    71,
    acute_a,
    "The same of the angle itself, where its value matters: a is acute.",
    without="S.4 to S.9",
)

mass = standing(
    "S.3",
    254,
    MASS,
    "In (2.3), and where it is used: {}.",
    without="(2.3) has a zero below a fraction",
    notation=four_wheels_in_spacecraft,
)

# --- at the ends

ends_of_four = four.by_cases.ours(
    "S.4",
    71,
    words="Four wheels at the ends: for a = 0 all axes are one line, for a = 90 degrees they are two lines, as for b = 0 and for b = 90 "
    "degrees: P is a segment or a rhombus, and two pairs of its vertices and edges are one.",
    states=(
        r"\sin a = 0 \Rightarrow (\mathbf{e}_1 = \mathbf{e}_2 = -\mathbf{e}_3 = -\mathbf{e}_4)",
        r"\cos a = 0 \Rightarrow (\mathbf{e}_1 = \mathbf{e}_3 \land \mathbf{e}_2 = \mathbf{e}_4)",
        r"\sin b = 0 \Rightarrow (\mathbf{e}_1 = -\mathbf{e}_4 \land \mathbf{e}_2 = -\mathbf{e}_3)",
        r"\cos b = 0 \Rightarrow (\mathbf{e}_1 = \mathbf{e}_2 \land \mathbf{e}_3 = \mathbf{e}_4)",
    ),
    uses=["2.0.4", "B.2"],
)

ends_of_six = six.by_cases.ours(
    "S.5",
    277,
    words="Six wheels at the ends: for a = 0 all axes are one line, for a = 90 degrees they are three.",
    states=(
        r"\sin a = 0 \Rightarrow (\mathbf{e}_1 = \mathbf{e}_2 = \mathbf{e}_3 = -\mathbf{e}_4 = -\mathbf{e}_5 = -\mathbf{e}_6)",
        r"\cos a = 0 \Rightarrow (\mathbf{e}_1 = \mathbf{e}_4 \land \mathbf{e}_2 = \mathbf{e}_5 \land \mathbf{e}_3 = \mathbf{e}_6)",
    ),
    uses=["3.0.4", "B.24"],
)

# --- outside


def _four_axes(a: str, b: str = "b") -> list[str]:
    """The axes as line 69 prints them, with other angles."""
    x, y, z = rf"\sin({a}) \sin({b})", rf"\sin({a}) \cos({b})", rf"\cos({a})"
    return [f"({x}, -{y}, -{z})", f"({x}, {y}, -{z})", f"({x}, -{y}, {z})", f"({x}, {y}, {z})"]


def _six_axes(a: str) -> list[str]:
    """The axes of line 275, with the fourth put right, with another angle."""
    far, near = rf"\frac{{\sqrt{{3}}}}{{2}} \sin({a})", rf"\frac{{1}}{{2}} \sin({a})"
    up = [f"(0, -\\sin({a}), ", f"({far}, -{near}, ", f"({far}, {near}, "]
    return [f"{horizontal}{sign}\\cos({a}))" for sign in ("", "-") for horizontal in up]


def _are(axes: list[str], images: str) -> str:
    """These vectors are, one by one, plus or minus the axes of these numbers."""
    pairs = zip(axes, images.split(", "), strict=True)
    return AND.join(rf"{axis} = {image[:-1]}\mathbf{{e}}_{image[-1]}" for axis, image in pairs)


outside_of_four = four.by_cases.ours(
    "S.6",
    71,
    words="Outside: the angles -a, pi - a, -b and pi - b have the same axes, but for their order and sense, so that P is the same. So "
    "every P is one with a and b from 0 to 90 degrees, and relations between squares hold for all angles.",
    states=(
        _are(_four_axes("-a"), "-3, -4, -1, -2"),
        _are(_four_axes(r"\pi - a"), "3, 4, 1, 2"),
        _are(_four_axes("a", "-b"), "-4, -3, -2, -1"),
        _are(_four_axes("a", r"\pi - b"), "2, 1, 4, 3"),
    ),
    uses=["2.0.4"],
)

outside_of_six = six.by_cases.ours(
    "S.7",
    277,
    words="So it is with six wheels and the angles -a and pi - a.",
    states=(_are(_six_axes("-a"), "-4, -5, -6, -1, -2, -3"), _are(_six_axes(r"\pi - a"), "4, 5, 6, 1, 2, 3")),
    uses=["3.0.4"],
)


def _far(face: tuple[str, str, str], square: str, below: str) -> str:
    """The square of (n, H) at a face, with the axes of its plane and H, over (n, n): `square` over `below`."""
    one, other, middle = face
    normal = rf"\mathbf{{e}}_{one} \times \mathbf{{e}}_{other}"
    return rf"({normal}, {middle})^2 ({below}) = {square} ({normal}, {normal})"


distances_of_four = four.by_cases.ours(
    "S.8",
    177,
    words="The distances of section 2.1 for all angles, squared: where the sines or cosines are negative what is printed is the distance "
    "with the other sign (V_1, V_6, V_7; F_1, F_2, F_3).",
    states=(
        r"(\mathbf{V}_1, \mathbf{V}_1) = (4 \sin a \sin b)^2",
        r"(\mathbf{V}_6, \mathbf{V}_6) = (4 \sin a \cos b)^2",
        r"(\mathbf{V}_7, \mathbf{V}_7) = (4 \cos a)^2",
        _far(("3", "4", r"\mathbf{F}_1"), r"(2 \sin 2a \sin b)^2", r"1 - \sin^2 a \cos^2 b"),
        _far(("1", "4", r"\mathbf{F}_2"), r"(2 \sin 2a \cos b)^2", r"1 - \sin^2 a \sin^2 b"),
        _far(("2", "4", r"\mathbf{F}_3"), r"(2 \sin a \sin 2b)^2", "1"),
    ),
    uses=["2.1.28", "2.1.29", "2.1.30", "T3.1"],
)

distances_of_six = six.ours(
    "S.9",
    464,
    words="Those of section 3.1 likewise (V_1, V_14; F_1, F_7 with the right coefficient, F_13).",
    states=(
        r"(\mathbf{V}_1, \mathbf{V}_1) = (6 \cos a)^2",
        r"(\mathbf{V}_{14}, \mathbf{V}_{14}) = (4 \sin a)^2",
        _far(("1", "6", r"\mathbf{F}_1"), r"27 \sin^2 2a", r"3 + \cos^2 a"),
        _far(("1", "5", r"\mathbf{F}_7"), r"16 \sin^2 2a", r"1 + 3 \cos^2 a"),
        _far(("1", "4", r"\mathbf{F}_{13}"), r"12 \sin^2 a", "1"),
    ),
    uses=["3.1.28", "3.1.29", "T8.1", "T8.2", "T8.3"],
)
