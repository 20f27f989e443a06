"""Kernels of Ignatov 2005: momentum envelopes of two arrays of reaction wheels, with all wheels or without one of them.

The radius of the largest ball inside an envelope is the smallest of its face distances; no one formula gives it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

from symcheck.core.lazy import lazy
from symcheck.kernels.codegen.kernel import Argument, Kernel, Output, largest_addend
from symcheck.papers.ignatov2005 import derivation, lists, sec2, sec3
from symcheck.papers.ignatov2005.hypotheses import real_base, real_pyramid
from symcheck.papers.ignatov2005.listed import Printed
from symcheck.papers.ignatov2005.rows import Array, signs_of
from symcheck.papers.listing import VertexRow

sp = lazy("sympy")
Forms = Callable[[], Mapping[str, Any]]
A = Argument("a", "angle between the axis of a wheel and OZ", "rad", "0", "pi/2")
B = Argument("b", "angle of the side edges in the plane OXY", "rad", "0", "pi/2")
MOMENTS = tuple(Argument(f"J_{x}", f"moment of inertia about O{x.upper()}", "kg m^2", "0") for x in "xyz")
MOMENTUM = "units of h_max"
RATE = "units of h_max/(kg m^2)"
CANCELLING = "Momenta of wheels may cancel: counted in units of the last place of the largest h_i e_i."
GIVEN = (real_pyramid, real_base)


@dataclass(frozen=True)
class Wheels:
    """The wheels of a pyramid that work, as the paper lists the vertices of their envelope."""

    words: str
    pyramid: int
    array: Array
    listed: tuple[VertexRow, ...]

    @property
    def working(self) -> int:
        return len(self.array.axes)

    @property
    def angles(self) -> tuple[Argument, ...]:
        return (A, B) if self.pyramid == 4 else (A,)

    @property
    def momenta(self) -> tuple[Argument, ...]:
        """The arguments h_1, h_2, ..."""
        numbers = range(1, self.working + 1)
        return tuple(Argument(f"h_{i}", f"momentum of wheel {i}", MOMENTUM, "-1", "1", closed=True) for i in numbers)

    @property
    def vertices(self) -> dict[int, tuple[int, ...]]:
        """The momenta of the wheels at V_1, V_2, ...; V'_1, ... are opposite."""
        return {row.label.index: signs_of(row.pattern) for row in self.listed}


def _wheels(words: str, pyramid: int, printed: Printed) -> Wheels:
    rows = (row for row in printed.read()["V"] if not row.label.primed)
    return Wheels(words, pyramid, printed.array, tuple(rows))


FOUR = _wheels("four wheels", 4, lists.printed_four)
THREE = _wheels("four wheels of which the last has failed", 4, lists.printed_three)
SIX = _wheels("six wheels", 6, lists.printed_six)
FIVE = _wheels("six wheels of which the last has failed", 6, lists.printed_five)


def _tangents() -> tuple[Any, Any]:
    """t = tan a, u = tan b: with them no difference is left that could lose digits."""
    a, b = sp.symbols("a b", real=True)
    return sp.tan(a), sp.tan(b)


# --- axes, momentum, rates


def _roundings(wheels: Wheels, ulp: int = 6) -> dict[str, Any]:
    """How accurate products of sines and cosines of two angles are."""
    condition = "Tangents of two angles, a root and a quotient are rounded one after the other."
    return {"ulp": ulp, "condition": condition} if B in wheels.angles else {}


def _along(letter: str, meaning: str, unit: str) -> tuple[Output, ...]:
    return tuple(Output(f"{letter}_{x}", f"{meaning} O{x.upper()}", unit) for x in "xyz")


def _components(stem: str, vectors: Mapping[int, tuple[int, ...]], unit: str) -> tuple[Output, ...]:
    """Outputs V_1x, V_1y, ...: components of vectors in whole units, without those that are zero for all angles."""
    named = ((i, x, n) for i, vector in vectors.items() for x, n in zip("xyz", vector, strict=True))
    return tuple(Output(f"{stem}_{i}{x}", f"{x} of {stem}_{i}", unit) for i, x, n in named if n)


def _scales(derived: Forms) -> dict[str, Any]:
    """The largest addend of each component."""
    return {name: largest_addend(sp.expand(value)) for name, value in derived().items()}


def _axes(wheels: Wheels, *claims: str) -> Kernel:
    return Kernel(
        says=f"Unit vectors e_1, e_2, ... along the axes of {wheels.words}, without components that are zero.",
        arguments=wheels.angles,
        outputs=_components("e", dict(enumerate(wheels.array.axes, 1)), "1"),
        derived=partial(derivation.axes, wheels.pyramid),
        claims=claims,
        **_roundings(wheels),
    )


def _momentum(wheels: Wheels, *claims: str) -> Kernel:
    derived = partial(derivation.momentum, wheels.pyramid, wheels.working)
    return Kernel(
        says=f"Total momentum of {wheels.words}.",
        arguments=(*wheels.momenta, *wheels.angles),
        outputs=_along("H", "momentum along", MOMENTUM),
        derived=derived,
        scale=partial(_scales, derived),
        ulp=8,
        condition=CANCELLING,
        claims=claims,
    )


def _rates(wheels: Wheels, *claims: str) -> Kernel:
    derived = partial(derivation.rates, wheels.pyramid, wheels.working)
    return Kernel(
        says=f"Angular rates of a body, at rest with its wheels at rest, that {wheels.words} give it.",
        arguments=(*wheels.momenta, *wheels.angles, *MOMENTS),
        outputs=_along("w", "angular rate about", RATE),
        derived=derived,
        scale=partial(_scales, derived),
        ulp=8,
        condition=CANCELLING,
        claims=(*claims, "2.3"),
    )


axes_of_four_wheels = _axes(FOUR, "2.0.1", "2.0.3", "2.0.5")
axes_of_six_wheels = _axes(SIX, "3.0.3", "3.0.5", "3.0.6")
momentum_of_four_wheels = _momentum(FOUR, "2.1.2")
momentum_of_three_wheels = _momentum(THREE, "2.2.1")
momentum_of_six_wheels = _momentum(SIX, "3.1.2")
momentum_of_five_wheels = _momentum(FIVE, "3.2.1")
rates_of_four_wheels = _rates(FOUR, "2.1.2")
rates_of_three_wheels = _rates(THREE, "2.2.1")
rates_of_six_wheels = _rates(SIX, "3.1.2")
rates_of_five_wheels = _rates(FIVE, "3.2.1")


# --- vertices


def _vertices(wheels: Wheels) -> Kernel:
    points = {i: wheels.array.envelope.point(signs) for i, signs in wheels.vertices.items()}
    return Kernel(
        says=f"Vertices V_i = -V'_i of the envelope of {wheels.words}, without components that are zero.",
        arguments=wheels.angles,
        outputs=_components("V", points, MOMENTUM),
        derived=partial(derivation.vertices, wheels.pyramid, wheels.vertices),
        claims=tuple(f"{wheels.array.section}V.{row.number}a" for row in wheels.listed),
        **(_roundings(wheels) or {"ulp": 5, "condition": "The square root of 3 and half a sine are rounded too."}),
    )


def _vertex_distances(wheels: Wheels, kinds: Mapping[str, int], accurate: Forms | None, *claims: str) -> Kernel:
    """Distances d_1, d_2, ... of these vertices, with one vertex for each distance."""
    momenta = {k: wheels.vertices[vertex] for k, vertex in enumerate(kinds.values(), 1)}
    derived = partial(derivation.distances_of_vertices, wheels.pyramid, momenta)
    return Kernel(
        says=f"Distances from the centre to the vertices of the envelope of {wheels.words}.",
        arguments=wheels.angles,
        outputs=tuple(Output(f"d_{k}", f"distance of {which}", MOMENTUM) for k, which in enumerate(kinds, 1)),
        derived=derived,
        accurate=accurate,
        given=GIVEN[: len(wheels.angles)],
        claims=claims,
        **(_roundings(wheels) if accurate is None else {}),
    )


def _vertex_distances_of_three() -> dict[str, Any]:
    t, u = _tangents()
    part = 8 / ((1 + t**2) * (1 + u**2))  # 8 sin^2 a cos^2 b/tan^2 a
    return {
        "d_1": sp.sqrt(1 + part * t**2 * u**2),
        "d_2": sp.sqrt(1 + part * t**2),
        "d_3": sp.sqrt(1 + part * (1 + u**2)),
    }


def _vertex_distances_of_six() -> dict[str, Any]:
    cosine, sine = _squares()
    return {"d_3": 2 * sp.sqrt(1 + 3 * cosine), "d_4": 2 * sp.sqrt(1 + 2 * sine)}


def _vertex_distances_of_five() -> dict[str, Any]:
    cosine, sine = _squares()
    parts = 24 * cosine, 2 * cosine, 6 * cosine, 8 * cosine, 8 * sine, 12 * sine, 6 * sine
    numbers = 1, 7, 3, 1, 1, 1, 1
    return {f"d_{k}": sp.sqrt(number + part) for k, (number, part) in enumerate(zip(numbers, parts, strict=True), 1)}


def _squares() -> tuple[Any, Any]:
    """cos^2 a and sin^2 a."""
    t, _ = _tangents()
    return 1 / (1 + t**2), t**2 / (1 + t**2)


vertices_of_four_wheels = _vertices(FOUR)
vertices_of_three_wheels = _vertices(THREE)
vertices_of_six_wheels = _vertices(SIX)
vertices_of_five_wheels = _vertices(FIVE)

vertex_distances_of_four_wheels = _vertex_distances(
    FOUR,
    {"V_1": 1, "V_6": 6, "V_7 (V_2 to V_5 are 2 away at all angles)": 7},
    None,
    *("2.1.28", "2.1.29", "2.1.30"),
)
vertex_distances_of_three_wheels = _vertex_distances(
    THREE,
    {"V_1": 1, "V_3": 3, "V_4 (V_2 is 1 away at all angles)": 4},
    _vertex_distances_of_three,
    *("2.2.18", "2.2.19", "2.2.20"),
)
vertex_distances_of_six_wheels = _vertex_distances(
    SIX,
    {"V_1": 1, "V_14 to V_16": 14, "V_2 to V_7": 2, "V_8 to V_13": 8},
    _vertex_distances_of_six,
    *(f"3.1.{number}" for number in (28, 29, 30, 31)),
)
vertex_distances_of_five_wheels = _vertex_distances(
    FIVE,
    {"V_1": 1, "V_2 and V_6": 2, "V_3 and V_5": 3, "V_4": 4, "V_7": 7, "V_8 and V_11": 8, "V_9 and V_10": 9},
    _vertex_distances_of_five,
    *(f"T10.{row}" for row in range(1, 8)),
)


# --- faces


def _face_distances(wheels: Wheels, kinds: Mapping[str, str], accurate: Forms, *claims: str) -> Kernel:
    """Distances r_1, r_2, ... of the planes of these faces, with the momenta [u, 1, v, -1] on one for each distance."""
    derived = derivation.distances_of_faces if wheels.pyramid == 4 else derivation.distances_of_faces_of_six
    return Kernel(
        says=f"Distances from the centre to the planes of the faces of the envelope of {wheels.words}.",
        arguments=wheels.angles,
        outputs=tuple(Output(f"r_{k}", f"distance of {which}", MOMENTUM) for k, which in enumerate(kinds, 1)),
        derived=partial(derived, *kinds.values()),
        accurate=accurate,
        given=GIVEN[: len(wheels.angles)],
        claims=claims,
        **_roundings(wheels, 5),
    )


def _face_distances_on_four(number: int) -> dict[str, Any]:
    """Those of four and of three wheels; the cross product of the axes is under one root with 1/(cos a cos b)."""
    t, u = _tangents()
    return {
        "r_1": number * t * u / sp.sqrt(1 + u**2 + t**2 * (1 + 2 * u**2 + t**2 * u**2)),
        "r_2": number * t / sp.sqrt(1 + u**2 + t**2 * (2 + u**2 + t**2)),
        "r_3": number * t * u / sp.sqrt((1 + u**2) ** 2 + t**2 * (1 + u**2) ** 2),
    }


def _face_distances_on_six(faces: Mapping[str, tuple[str, int]]) -> dict[str, Any]:
    """Multiples of the distance of a face between edges of the pyramid that are neighbours, two apart, or opposite."""
    t, _ = _tangents()
    third = sp.Rational(1, 3)
    units = {
        "neighbours": t / sp.sqrt(4 * third + t**2 * (7 * third + t**2)),  # sin a cos a/sqrt(1 + cos^2 a/3)
        "two apart": t / sp.sqrt(4 + t**2 * (5 + t**2)),  # sin a cos a/sqrt(1 + 3 cos^2 a)
        "opposite": t / sp.sqrt(4 * third + 4 * third * t**2),  # sqrt(3)/2 sin a
    }
    return {name: number * units[unit] for name, (unit, number) in faces.items()}


face_distances_of_four_wheels = _face_distances(
    FOUR,
    {"F_1 and F_5": "1, 1, u, v", "F_2 and F_4": "u, 1, -1, v", "F_3 and F_6": "1, u, 1, v"},
    partial(_face_distances_on_four, 4),
    *("T3.1", "T3.2", "T3.3"),
)
face_distances_of_three_wheels = _face_distances(
    THREE,
    dict(zip(("F_1", "F_2", "F_3"), sec2.FACES_OF_THREE, strict=True)),
    partial(_face_distances_on_four, 2),
    "T5.1",
)
face_distances_of_six_wheels = _face_distances(
    SIX,
    {"F_1 to F_6": sec3.FACES_OF_P[0], "F_7 to F_12": sec3.FACES_OF_P[6], "F_13 to F_15": sec3.FACES_OF_P[12]},
    partial(_face_distances_on_six, {"r_1": ("neighbours", 6), "r_2": ("two apart", 8), "r_3": ("opposite", 4)}),
    *("T8.1", "T8.3", "B.28"),
)
face_distances_of_five_wheels = _face_distances(
    FIVE,
    {
        "F_1": sec3.FACES_OF_FIVE[0],
        "F_2 and F_5": sec3.FACES_OF_FIVE[1],
        "F_3 and F_4": sec3.FACES_OF_FIVE[2],
        "F_6 and F_8": sec3.FACES_OF_FIVE[5],
        "F_7": sec3.FACES_OF_FIVE[6],
        "F_9 and F_10": sec3.FACES_OF_FIVE[8],
    },
    partial(
        _face_distances_on_six,
        {
            "r_1": ("two apart", 7),
            "r_2": ("neighbours", 5),
            "r_3": ("neighbours", 4),
            "r_4": ("two apart", 6),
            "r_5": ("two apart", 5),
            "r_6": ("opposite", 3),
        },
    ),
    *(f"T11.{row}" for row in range(1, 7)),
)


# --- volume


def _volume(wheels: Wheels, accurate: Forms, *claims: str) -> Kernel:
    return Kernel(
        says=f"Volume of the envelope of {wheels.words}.",
        arguments=wheels.angles,
        outputs=(Output("volume", "volume", "units of h_max^3"),),
        derived=partial(derivation.volume, wheels.pyramid, wheels.working),
        accurate=accurate,
        given=GIVEN[: len(wheels.angles)],
        ulp=8,
        condition="A product of three or five sines and cosines: rounding a tangent counts twice in sin^2 a.",
        claims=claims,
    )


def _volume_on_four(number: int) -> dict[str, Any]:
    """sin a (sin a cos a) (sin b cos b), with sin a cos a = 1/(t + 1/t): the square of a small t would lose digits."""
    t, u = _tangents()
    return {"volume": number * t * u / ((t + 1 / t) * (1 + u**2) * sp.sqrt(1 + t**2))}


def _volume_on_six(number: int) -> dict[str, Any]:
    """The same, with sqrt 3 under the root."""
    t, _ = _tangents()
    third = sp.Rational(1, 3)
    return {"volume": number * t / ((t + 1 / t) * sp.sqrt(third + third * t**2))}


volume_of_four_wheels = _volume(FOUR, partial(_volume_on_four, 128), "B.3")
volume_of_three_wheels = _volume(THREE, partial(_volume_on_four, 32), "B.13")
volume_of_six_wheels = _volume(SIX, partial(_volume_on_six, 144), "B.25")
volume_of_five_wheels = _volume(FIVE, partial(_volume_on_six, 72), "B.35")


# --- the largest rates, and the best angles for given moments of inertia


def _largest_rates(wheels: Wheels, *claims: str) -> Kernel:
    return Kernel(
        says=f"Largest angular rates about each axis alone that {wheels.words} can give a body, in absolute value.",
        arguments=(*wheels.angles, *MOMENTS),
        outputs=_along("w", "largest angular rate about", RATE),
        derived=partial(derivation.largest_rates, wheels.pyramid),
        claims=(*claims, "2.3"),
        **_roundings(wheels),
    )


largest_rates_of_four_wheels = _largest_rates(FOUR, "2.3.2", "2.3.3", "2.3.4")
largest_rates_of_six_wheels = _largest_rates(SIX, "3.2.26", "3.2.27", "3.2.28")

ANGLES = tuple(Output(each.name, each.meaning, each.unit) for each in (A, B))

equal_rates_of_four_wheels = Kernel(
    says="Angles of four wheels with which the largest angular rates about OX, OY and OZ are equal.",
    arguments=MOMENTS,
    outputs=(
        *ANGLES,
        Output("w", "largest angular rate about each of the three axes", RATE),
        Output("w_any", "largest angular rate that is had about every axis, whatever its direction", RATE),
    ),
    derived=derivation.angles_for_equal_rates,
    degenerate="If the squares of the moments satisfy the triangle inequalities, no angles give a greater rate w_any.",
    claims=("B.16", "B.17", "B.18", "B.19"),
)

equal_rates_of_six_wheels = Kernel(
    says="Angle of six wheels with which the largest angular rates about OY and OZ are equal, and the largest rates.",
    arguments=MOMENTS,
    outputs=(
        ANGLES[0],
        Output("w_x", "largest angular rate about OX", RATE),
        Output("w_y", "largest angular rate about OY, and about OZ", RATE),
    ),
    derived=derivation.angle_of_six_for_equal_rates,
    ulp=5,
    condition="The square root of 3 is rounded too.",
    claims=("3.2.26", "3.2.27", "3.2.28", "3.2.30"),
)

best_angles_of_four_wheels = Kernel(
    says="Angles of four wheels with the greatest angular rate about every axis, for J_y^2 >= J_x^2 + J_z^2.",
    arguments=MOMENTS,
    outputs=(*ANGLES, Output("w", "largest angular rate that is had about every axis, whatever its direction", RATE)),
    derived=derivation.angles_for_rate_about_any_axis,
    claims=("B.20", "B.21"),
)

best_angle_of_six_wheels = Kernel(
    says="Angle of six wheels at which the face F_8 of the envelope allows the greatest angular rate about every axis.",
    arguments=MOMENTS[1:],
    outputs=(
        ANGLES[0],
        Output("w", "largest angular rate that this face allows about every axis, whatever its direction", RATE),
    ),
    derived=derivation.angle_of_six_for_rate_about_any_axis,
    degenerate="The other faces have to allow this rate too; for moments of 1000, 1600 and 800 kg m^2 they do.",
    claims=("B.38", "B.39", "B.40"),
)
