"""Ignatov 2005: the errors that are found, and the derivations against plain numbers."""

from __future__ import annotations

import itertools
import math
import random
import re
from collections.abc import Iterable
from fractions import Fraction

import pytest
import sympy
from declarations import errata
from sympy.physics.units import convert_to, kilogram, meter, newton, second

from symcheck import papers
from symcheck.audit import context_of, obligation_of
from symcheck.audit.decide import decide
from symcheck.core.claims import Claim, Premise
from symcheck.core.verdicts import Origin, Reading
from symcheck.mechanics import zonotope
from symcheck.papers.ignatov2005 import derivation, sec2, sec3
from symcheck.reading import to_sympy

PAPER = papers.load()["ignatov2005"]
Vector = tuple[float, float, float]


def faults(section: str) -> dict[str, str]:
    """The kinds of the errata of a section, by number and letter."""
    items = [item for found, _, item in PAPER.items() if found.number == section]
    return {item.number + letter: erratum.kind for item in items for letter, erratum in errata(item).items()}


def damaged(section: str) -> dict[str, str]:
    """What is read as something else in a section, by number: the kind of the damage."""
    return {
        item.number: d.kind for found, _, item in PAPER.items() if found.number == section and (d := item.source.damage)
    }


# --- section 2: four wheels


def four_axes(a: float, b: float) -> list[Vector]:
    p, q, r = math.sin(a) * math.sin(b), math.sin(a) * math.cos(b), math.cos(a)
    return [(p, -q, -r), (p, q, -r), (p, -q, r), (p, q, r)]


def dot(u: Vector, v: Vector) -> float:
    return sum(x * y for x, y in zip(u, v, strict=True))


def cross(u: Vector, v: Vector) -> Vector:
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def combined(signs: tuple[float, ...], axes: list[Vector]) -> Vector:
    x, y, z = (sum(h * axis[k] for h, axis in zip(signs, axes, strict=True)) for k in range(3))
    return x, y, z


def test_the_errors_of_section_2_are_these() -> None:
    assert faults("2") == {
        **{f"2.2.{item}{letter}": "lost prime" for item in (14, 15) for letter in "abc"},
        "2.3.5a": "letter",
        "2.3.5b": "typography",
        "2.3.7a": "typography",
        "2.3.7b": "typography",
        "2.3.17": "wrong claim",
    }
    lost = ["2.1.23", "2.1.24", "2.1.33", "2.1.34", "T2.0", "T2.5", "T2.6", "2.2.22", "2.2.23"]
    assert damaged("2") == {**dict.fromkeys(lost, "lost letter"), "T3.3": "missing cell"}
    assert all(
        d.origin is Origin.OCR for found, _, item in PAPER.items() if found.number == "2" and (d := item.source.damage)
    )


def test_every_condition_that_is_not_printed_is_said_once_and_never_called_printed() -> None:
    standing = {item.states for found, _, item in PAPER.items() if found.number == "S" and isinstance(item, Premise)}
    given = [h for _, _, item in PAPER.items() if isinstance(item, Claim) for h in item.hypotheses]
    assert {h.states for h in given if not h.printed} == standing
    assert not [h.name for h in given if h.printed and h.states in standing]


def test_a_claim_that_needs_a_condition_of_ours_is_marked_by_it() -> None:
    readings = {
        record.id: record.reading
        for number in ("2.1.28", "2.1.31", "2.1.33")
        for record in decide(f"ignatov2005:{number}")
    }
    assert readings == {
        "ignatov2005:2.1.28": Reading.STANDING,
        "ignatov2005:2.1.31": Reading.AS_PRINTED,
        "ignatov2005:2.1.33a": Reading.STANDING,  # the lost letter is in the other link
        "ignatov2005:2.1.33b": Reading.DAMAGED,
    }


def test_no_repair_is_a_fraction_that_cancels() -> None:
    first = decide("ignatov2005:2.3.5")[0]
    assert first.erratum is not None
    assert first.erratum.repairs == ()


def test_the_order_of_both_regions_depends_on_the_ellipsoid() -> None:
    """3.2.21: with the ellipsoid that suits each best six wheels are nearer, with the one for equal rates four."""

    def nearness(axes: list[Vector], semi_axes: Vector) -> float:
        envelope = zonotope.envelope(axes, roughly)
        outside = max(
            sum((x / s) ** 2 for x, s in zip(envelope.point(v), semi_axes, strict=True))
            for v in envelope.combinatorics.vertices
        )
        inside = min(
            envelope.support(f) ** 2 / sum((n * s) ** 2 for n, s in zip(envelope.normal(f), semi_axes, strict=True))
            for f in envelope.combinatorics.faces
        )
        return math.sqrt(inside / outside)

    b = math.atan(5 / 8)
    four, six = four_axes(math.atan(2 / math.cos(b)), b), six_axes(math.atan(3))
    assert nearness(four, (1000, 1600, 800)) == pytest.approx(math.sqrt(1 / 2))
    assert nearness(six, (1000, 1600, 800)) == pytest.approx(math.sqrt(64 / 217))
    assert nearness(six, (4 * 3, 4 * 3, 6)) == pytest.approx(math.sqrt(27 / 43))


def test_the_axes_are_those_of_the_definition() -> None:
    context = context_of(obligation_of("ignatov2005:2.0.3"))
    at = {sympy.Symbol("a", real=True): 0.7, sympy.Symbol("b", real=True): 0.4}
    for number, axis in enumerate(four_axes(0.7, 0.4), 1):
        printed = [float(to_sympy(context.table[f"e_{number}{k}"]).subs(at)) for k in (1, 2, 3)]
        assert printed == pytest.approx(list(axis), rel=1e-12)


@pytest.mark.parametrize(("wheels", "faces"), [(4, sec2.FACES_OF_P), (3, sec2.FACES_OF_THREE)])
def test_a_face_is_as_far_as_the_farthest_momentum_across_it(wheels: int, faces: tuple[str, ...]) -> None:
    rng = random.Random(2005)
    a, b = sympy.symbols("a b", real=True)
    distances = derivation.distances_of_faces(*faces)
    for _ in range(20):
        at = {a: rng.uniform(0.05, 1.5), b: rng.uniform(0.05, 1.5)}
        axes = four_axes(at[a], at[b])[:wheels]
        for number, face in enumerate(faces, 1):
            one, other = (axis for axis, sign in zip(axes, face.split(", "), strict=True) if sign in "uv")
            across = cross(one, other)
            farthest = max(dot(combined(signs, axes), across) for signs in itertools.product((-1, 1), repeat=wheels))
            expected = farthest / math.sqrt(dot(across, across))
            assert float(distances[f"r_{number}"].subs(at)) == pytest.approx(expected, rel=1e-12)


def test_the_edges_along_wheel_4_are_those_of_the_corrected_sentence() -> None:
    zero = {(1, -1, -1, 1), (-1, 1, 1, -1)}  # no vertices
    signs = {
        1: (1, 1, 1, 1),
        3: (1, -1, 1, 1),
        4: (1, 1, -1, 1),
        5: (1, 1, 1, -1),
        6: (1, -1, 1, -1),
        7: (1, 1, -1, -1),
    }

    def place(name: str) -> tuple[int, ...]:
        number, factor = int(name.strip("V_'")), -1 if name.endswith("'") else 1
        return tuple(factor * h for h in signs[number])

    found = {
        ((*fixed, -1), (*fixed, 1))
        for fixed in itertools.product((-1, 1), repeat=3)
        if not {(*fixed, -1), (*fixed, 1)} & zero
    }
    named = [*sec2.PRIMED_EDGES, *sec2.EDGES_ALONG_WHEEL_4[3:]]
    assert {tuple(place("V_" + part) for part in edge.split("V_")[1:]) for edge in named} == found


def test_the_largest_rates_and_their_unit() -> None:
    moments = (1000, 1600, 800)
    b = math.atan(5 / 8)
    a = math.atan(2 / math.cos(b))
    axes = four_axes(a, b)
    largest = [sum(abs(axis[k]) for axis in axes) / moments[k] for k in range(3)]
    assert largest == pytest.approx([1 / (50 * math.sqrt(105))] * 3, rel=1e-12)
    unit = newton * meter * second / (kilogram * meter**2)  # h_max times kg^-1 m^-2
    assert convert_to(unit, [kilogram, meter, second]) == 1 / second
    corners = [combined(signs, axes) for signs in itertools.product((-1, 1), repeat=4)]
    rates = sorted(math.hypot(*(x / moment for x, moment in zip(h, moments, strict=True))) for h in corners)
    assert rates[-6:] == pytest.approx(largest * 2, rel=1e-12)
    assert rates[:-6] == pytest.approx([0, 0] + [largest[0] * math.sqrt(3) / 2] * 8, abs=1e-15)


# --- section 3: six wheels


def six_axes(a: float) -> list[Vector]:
    """Up the first three edges of a regular six-sided pyramid, down the others; the first is at -90 degrees."""
    s, c = math.sin(a), math.cos(a)
    azimuths = [math.radians(60 * k - 90) for k in range(6)]
    edges = [(s * math.cos(turn), s * math.sin(turn), c) for turn in azimuths]
    return edges[:3] + [(-x, -y, -z) for x, y, z in edges[3:]]


def roughly(number: float) -> int:
    return 0 if abs(number) < 1e-9 else int(math.copysign(1, number))


def test_the_errors_of_section_3_are_these() -> None:
    assert faults("3") == {
        "3.0.4d": "sign",
        "T8.2": "coefficient",
        **dict.fromkeys(("T8.7", "T8.8", *(f"T11.{n}" for n in range(13, 18))), "missing hypothesis"),
        "3.2.7": "wrong claim",
        **{f"3.2.{item}{letter}": "lost prime" for item in (13, 15) for letter in "abcd"},
        "3.2.13k": "label",
        "3.2.15e": "label",
        "3.2.37b": "rounding",
    }
    assert damaged("3") == {
        "3.1.22": "one letter for another",
        "3.1.23": "lost letter",
        "3.2.12": "one letter for another",
        "T11.2": "missing cell",
        "3.2.34": "letter",
    }


def test_the_derived_axes_are_those_of_the_pyramid() -> None:
    found = derivation.six_axes()
    for i, axis in enumerate(six_axes(1.1), 1):
        place = [float(found[f"g_{i}{k}"].subs(sympy.Symbol("a", real=True), 1.1)) for k in (1, 2, 3)]
        assert place == pytest.approx(axis, abs=1e-12)


def test_every_combination_is_zero_or_inside_or_a_vertex() -> None:
    def both(signs: Iterable[str]) -> set[tuple[int, ...]]:
        named = {tuple(map(int, each.split(", "))) for each in signs}
        return named | set(map(zonotope.opposite, named))

    inside = both(full for full, _ in sec3.INSIDE)
    zero = both(printed.split("[")[1].strip("]") for printed in sec3.ZERO)
    axes = six_axes(0.7)
    vertices = set(zonotope.envelope(axes, roughly).combinatorics.vertices)
    assert (len(inside), len(zero), len(vertices)) == (30, 2, 32)
    assert inside | zero | vertices == set(itertools.product((-1, 1), repeat=6))
    for full, smaller in sec3.INSIDE:
        momenta = [tuple(float(Fraction(h)) for h in each.split(", ")) for each in (full, smaller)]
        assert max(map(abs, momenta[1])) < 1
        assert combined(momenta[0], axes) == pytest.approx(combined(momenta[1], axes), abs=1e-12)


@pytest.mark.parametrize(("wheels", "counts"), [(6, (32, 60, 30)), (5, (22, 40, 20))])
def test_the_counts_are_those_of_the_envelope(wheels: int, counts: tuple[int, int, int]) -> None:
    for a in (0.1, 0.7, 1.2, 1.5):
        assert zonotope.envelope(six_axes(a)[:wheels], roughly).combinatorics.counts == counts


def test_the_symmetries_are_those_of_a_regular_prism() -> None:
    turns = ("-1, 6, 5, -4, 3, 2", "2, 3, -4, 5, 6, -1", "4, 5, 6, 1, 2, 3")  # a half turn, a sixth one, a reflection
    images = [tuple(map(int, turn.split(", "))) for turn in turns]
    group = {tuple(range(1, 7))}
    while more := {tuple(math.copysign(1, k) * g[abs(k) - 1] for k in turn) for g in group for turn in images} - group:
        group |= more
    assert len(group) == 24


@pytest.mark.parametrize(("wheels", "faces"), [(6, sec3.FACES_OF_P), (5, sec3.FACES_OF_FIVE)])
def test_a_face_of_section_3_is_as_far_as_the_farthest_momentum_across_it(wheels: int, faces: tuple[str, ...]) -> None:
    a = sympy.Symbol("a", real=True)
    distances = derivation.distances_of_faces_of_six(*faces)
    for at in (0.1, 0.6, 1.0, 1.3, 1.5):
        envelope = zonotope.envelope(six_axes(at)[:wheels], roughly)
        for number, face in enumerate(faces, 1):
            signs = tuple(0 if sign in "uv" else int(sign) for sign in face.split(", "))
            expected = envelope.support(signs) / math.hypot(*envelope.normal(signs))
            assert float(distances[f"r_{number}"].subs(a, at)) == pytest.approx(expected, rel=1e-12)


def test_the_faces_named_are_all_faces_but_opposites() -> None:
    for wheels, faces in ((6, sec3.FACES_OF_P), (5, sec3.FACES_OF_FIVE)):
        named = {tuple(0 if sign in "uv" else int(sign) for sign in face.split(", ")) for face in faces}
        found = zonotope.envelope(six_axes(1.0)[:wheels], roughly).combinatorics.faces
        assert named | set(map(zonotope.opposite, named)) == set(found)
        assert len(named) * 2 == len(found)


def test_the_edges_along_wheel_6_are_those_of_the_corrected_sentence() -> None:
    signs = {
        1: (1, 1, 1, -1, -1, -1),
        2: (-1, 1, 1, -1, -1, -1),
        6: (1, 1, 1, -1, 1, -1),
        7: (1, 1, 1, -1, -1, 1),
        8: (-1, 1, 1, -1, -1, 1),
        9: (-1, -1, 1, -1, -1, -1),
        12: (1, 1, 1, 1, 1, -1),
        13: (1, 1, 1, -1, 1, 1),
        15: (-1, -1, 1, -1, -1, 1),
        16: (-1, -1, -1, -1, -1, -1),
    }

    def ends(edge: str) -> frozenset[tuple[int, ...]]:
        found = [(signs[int(number.strip("{}"))], prime) for number, prime in re.findall(r"V_(\d|{\d+})('?)", edge)]
        return frozenset(zonotope.opposite(h) if prime else h for h, prime in found)

    edges = zonotope.envelope(six_axes(1.0), roughly).combinatorics.edges
    along = {frozenset(both) for edge, both in edges.items() if edge[5] == 0}
    assert set(map(ends, sec3.RIGHT_EDGES.split(", "))) == along
    assert len(along & set(map(ends, sec3.EDGES.split(", ")))) == 5


def test_no_round_ellipsoid_is_nearer_to_six_wheels() -> None:
    """The best of all spheroids about OZ has lambda^2 = 27/43, as the one of 3.2.44."""

    def nearness(across: float, along: float, envelope: zonotope.Envelope) -> float:
        """lambda^2 for the spheroid with these semi-axes, made large enough to hold the envelope."""
        outside = max(
            (x * x + y * y) / across**2 + z * z / along**2
            for x, y, z in map(envelope.point, envelope.combinatorics.vertices)
        )
        normals = [(envelope.normal(face), envelope.support(face)) for face in envelope.combinatorics.faces]
        inside = min(d * d / ((x * x + y * y) * across**2 + z * z * along**2) for (x, y, z), d in normals)
        return float(inside / outside)

    for a in (0.4, 1.25):
        envelope = zonotope.envelope(six_axes(a), roughly)
        across, along = 4 * math.sin(a), 6 * math.cos(a)
        assert nearness(across, along, envelope) == pytest.approx(27 / 43)
        assert max(nearness(across, along * k / 100, envelope) for k in range(50, 200)) <= 27 / 43 + 1e-12


def to_the_face(face: str, axes: list[Vector], steps: int = 200) -> float:
    """From the centre to the nearest point of a face, on a grid."""

    def momenta(u: float, v: float) -> tuple[float, ...]:
        return tuple({"u": u, "v": v}.get(h) or (0.0 if h in "uv" else float(h)) for h in face.split(", "))

    grid = [2 * k / steps - 1 for k in range(steps + 1)]
    return min(math.hypot(*combined(momenta(u, v), axes)) for u in grid for v in grid)


@pytest.mark.parametrize(
    ("face", "plane", "nearest"),
    [
        (sec3.FACES_OF_P[0], 1.736, 1.736),
        (sec3.FACES_OF_P[6], 2.073, 2.268),
        (sec3.FACES_OF_FIVE[0], 1.814, 1.814),
        (sec3.FACES_OF_FIVE[1], 1.447, 1.558),
        (sec3.FACES_OF_FIVE[2], 1.157, 1.157),
        (sec3.FACES_OF_FIVE[5], 1.555, 1.868),
        (sec3.FACES_OF_FIVE[6], 1.296, 1.328),
    ],
)
def test_a_face_may_be_farther_than_its_plane_at_72_degrees(face: str, plane: float, nearest: float) -> None:
    axes = six_axes(math.radians(72))[: face.count(",") + 1]
    signs = tuple(0 if sign in "uv" else int(sign) for sign in face.split(", "))
    envelope = zonotope.envelope(axes, roughly)
    assert envelope.support(signs) / math.hypot(*envelope.normal(signs)) == pytest.approx(plane, abs=1e-3)
    assert to_the_face(face, axes) == pytest.approx(nearest, abs=1e-3)


def test_the_largest_rates_of_six_wheels() -> None:
    exact, rounded = math.atan(3), math.radians(72)
    rates = [
        [sum(abs(axis[k]) for axis in six_axes(a)) / moment for k, moment in enumerate((1000, 1600, 800))]
        for a in (exact, rounded)
    ]
    assert [round(rate, 4) for rate in rates[0]] == [0.0033, 0.0024, 0.0024]
    assert rates[0][1] == pytest.approx(rates[0][2], rel=1e-12)
    assert [round(rate, 4) for rate in rates[1]] == [0.0033, 0.0024, 0.0023]
