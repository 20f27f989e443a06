"""Envelopes over whole ranges of angles: types, degenerate angles, closed forms, failures of each wheel."""

from __future__ import annotations

import math
import random
from fractions import Fraction

import pytest
import sympy as sp
from families import Family

from symcheck.core.verdicts import SymcheckError
from symcheck.mechanics import zonotope
from symcheck.papers.ignatov2005 import envelopes

a, b = sp.symbols("a b", real=True)
p, q, r = sp.sin(a) * sp.sin(b), sp.sin(a) * sp.cos(b), sp.cos(a)
s, c, root = sp.sin(a), sp.cos(a), sp.sqrt(3) / 2
HALF = sp.Rational(1, 2)
FOUR = Family(((p, -q, -r), (p, q, -r), (p, -q, r), (p, q, r)), (a, b))
SIX = Family(
    tuple((x * s, y * s, z * c) for z in (1, -1) for x, y in ((0, -1), (root, -HALF), (root, HALF))),
    (a,),
)
SEGMENT, RHOMBUS, HEXAGON = (1, (2, 1, 0), ()), (2, (4, 4, 1), ((4, 1),)), (2, (6, 6, 1), ((6, 1),))
RIGHT = sp.pi / 2


def types(family: Family) -> dict[tuple[tuple[object, object], ...], object]:
    """The type on every piece, by the angles that have a value there."""
    return {tuple(piece.fixed.items()): piece.type for piece in family.pieces()}


def failures(wheels: int) -> list[object]:
    """No wheel fails, or one does; all of them are tried in the slow run."""
    between = [pytest.param((k,), marks=pytest.mark.slow) for k in range(2, wheels)]
    return [(), (1,), *between, (wheels,)]


@pytest.mark.parametrize("failed", failures(4))
def test_the_four_sided_pyramid_degenerates_at_the_ends_alone(failed: tuple[int, ...]) -> None:
    family = FOUR.without(*failed)
    whole = (3, (8, 12, 6), ((4, 6),)) if failed else (3, (14, 24, 12), ((4, 12),))
    assert family.degenerate_angles() == {a: (0, RIGHT), b: (0, RIGHT)}
    assert types(family) == {
        (): whole,
        ((b, 0),): RHOMBUS,
        ((b, RIGHT),): RHOMBUS,
        ((a, RIGHT),): RHOMBUS,
        **{((a, x), *rest): SEGMENT for x in (0, RIGHT) for rest in ([(b, 0)], [(b, RIGHT)])},
        ((a, 0),): SEGMENT,
    }


@pytest.mark.parametrize("failed", failures(6))
def test_the_six_sided_pyramid_degenerates_at_the_ends_alone(failed: tuple[int, ...]) -> None:
    family = SIX.without(*failed)
    whole = (3, (22, 40, 20), ((4, 20),)) if failed else (3, (32, 60, 30), ((4, 30),))
    assert types(family) == {(): whole, ((a, 0),): SEGMENT, ((a, RIGHT),): HEXAGON}


@pytest.mark.parametrize(
    ("family", "count", "order", "orders_left"), [(FOUR, 4, 8, 2), (SIX, 6, 24, 4)], ids=["four", "six"]
)
def test_every_failure_is_the_same_by_symmetry_and_by_computation(
    family: Family, count: int, order: int, orders_left: int
) -> None:
    group = family.isometries()
    assert len(group) == order
    assert {abs(images[0]) for images in group} == set(range(1, count + 1))
    left = [family.without(k) for k in range(1, count + 1)]
    assert {each.envelope.combinatorics.counts for each in left} == {left[0].envelope.combinatorics.counts}
    assert {sp.factor(each.reduced(each.envelope.volume())) for each in left} == {
        sp.factor(left[0].reduced(left[0].envelope.volume()))
    }
    assert {len(each.isometries()) for each in left} == {orders_left}


def test_more_than_one_wheel_may_fail() -> None:
    two = SIX.without(1, 4)
    assert two.envelope.combinatorics.counts == (14, 24, 12)
    assert two.axes == (SIX.axes[1], SIX.axes[2], SIX.axes[4], SIX.axes[5])


@pytest.mark.parametrize(
    ("family", "volume"),
    [
        (FOUR, 128 * p * q * r),
        (FOUR.without(4), 32 * p * q * r),
        (SIX, 144 * sp.sqrt(3) * s**2 * c),
        (SIX.without(6), 72 * sp.sqrt(3) * s**2 * c),
    ],
)
def test_volume(family: Family, volume: object) -> None:
    assert family.reduced(family.envelope.volume() - volume) == 0


def distances(family: Family) -> dict[object, int]:
    """The squared distances of the faces, with how many faces have each."""
    found = family.envelope
    squares = [
        sp.factor(family.reduced(found.support(face)) ** 2 / family.reduced(zonotope.dot(n, n)))
        for face in found.combinatorics.faces
        if (n := found.normal(face))
    ]
    return {square: squares.count(square) for square in squares}


def test_distances_of_faces() -> None:
    free = {
        sp.factor(sp.cancel(square.subs({c: sp.sqrt(1 - s**2)}))): count for square, count in distances(SIX).items()
    }
    assert free == {
        sp.factor(64 * s**2 * (1 - s**2) / (4 - 3 * s**2)): 12,
        sp.factor(108 * s**2 * (1 - s**2) / (4 - s**2)): 12,
        12 * s**2: 6,
    }
    assert sorted(distances(FOUR).values()) == [4, 4, 4]


@pytest.mark.parametrize(("family", "seed"), [(FOUR, 1), (FOUR.without(4), 2), (SIX, 3), (SIX.without(6), 4)])
def test_the_range_agrees_with_its_points(family: Family, seed: int) -> None:
    chance = random.Random(seed)
    for _ in range(3):
        values = {}
        for x in family.angles:
            t = sp.Rational(chance.randint(1, 30), 31)
            values |= {sp.sin(x): 2 * t / (1 + t**2), sp.cos(x): (1 - t**2) / (1 + t**2)}
        point = zonotope.envelope([[sp.sympify(x).subs(values) for x in axis] for axis in family.axes])
        whole = family.envelope
        assert point.combinatorics == whole.combinatorics
        assert sp.simplify(sp.sympify(whole.volume()).subs(values) - point.volume()) == 0


def tilted(angle: object) -> Family:
    """Three wheels along the edges of a corner and one in the plane of two of them, at an angle to the first."""
    return Family(((1, 0, 0), (0, 1, 0), (0, 0, 1), (sp.cos(angle), sp.sin(angle), 0)), (a,))


def test_an_envelope_may_change_inside_the_range() -> None:
    moving = Family(((1, 0, 0), (0, 1, 0), (0, 0, 1), (sp.cos(a) - sp.sin(a), sp.sin(a), sp.cos(a))), (a,))
    assert moving.degenerate_angles() == {a: (0, sp.pi / 4, RIGHT)}
    counts = [piece.type[1] for piece in moving.pieces()]
    assert counts == [(12, 18, 8), (14, 24, 12), (12, 18, 8), (14, 24, 12), (12, 18, 8)]
    with pytest.raises(SymcheckError, match="the envelope changes at a = 0, pi/4, pi/2; ask for its pieces"):
        moving.envelope  # noqa: B018


def test_coplanar_and_parallel_wheels_in_a_family() -> None:
    assert [piece.type for piece in tilted(a).pieces()] == [
        (3, (8, 12, 6), ((4, 6),)),
        (3, (12, 18, 8), ((4, 6), (6, 2))),
        (3, (8, 12, 6), ((4, 6),)),
    ]


def test_a_family_that_never_spans_space() -> None:
    flat = Family(((1, 0, 0), (sp.cos(a), sp.sin(a), 0)), (a,))
    assert [piece.type for piece in flat.pieces()] == [SEGMENT, RHOMBUS, RHOMBUS]


def test_what_cannot_be_decided_is_said() -> None:
    joined = Family(((sp.sin(a), sp.sin(b), 0), (sp.cos(b), sp.cos(a), 0), (0, 0, 1)), (a, b))
    with pytest.raises(SymcheckError, match="joins angles; fix one of them"):
        list(joined.pieces())
    irrational = Family(((1, 0, 0), (0, 1, 0), (0, 0, sp.sin(a) - sp.sqrt(3) * sp.cos(a) ** 2)), (a,))
    with pytest.raises(SymcheckError, match="irrational coefficients"):
        list(irrational.pieces())


def test_exact_numbers_of_other_kinds_do() -> None:
    third = zonotope.envelope([(Fraction(1, 3), 0, 0), (0, sp.sqrt(2), 0), (0, 0, 1)])
    assert third.volume() == 8 * sp.sqrt(2) / 3
    assert third.surface(sp.sqrt) == 8 * (sp.sqrt(2) / 3 + sp.sqrt(2) + sp.Rational(1, 3))


# --- the optimal angles of Ignatov 2005, beyond the paper, by plain search

J = (1000.0, 1600.0, 800.0)


@pytest.mark.parametrize(("family", "whole"), [(FOUR, envelopes.FOUR), (SIX, envelopes.SIX)], ids=["four", "six"])
def test_whole_numbers_have_the_signs_of_the_axes(family: Family, whole: tuple[zonotope.Vector, ...]) -> None:
    assert zonotope.chirotope(whole) == family.envelope.chirotope


def four_at(a: float, b: float) -> zonotope.Envelope:
    units = (math.sin(a) * math.sin(b), math.sin(a) * math.cos(b), math.cos(a))
    return stretched(envelopes.FOUR, units)


def six_at(a: float) -> zonotope.Envelope:
    return stretched(envelopes.SIX, (math.sqrt(0.75) * math.sin(a), 0.5 * math.sin(a), math.cos(a)))


def stretched(whole: tuple[zonotope.Vector, ...], units: tuple[float, ...]) -> zonotope.Envelope:
    found = zonotope.envelope(whole)
    axes = tuple((x * units[0], y * units[1], z * units[2]) for x, y, z in whole)
    return zonotope.Envelope(axes, found.chirotope, found.combinatorics)


def size(found: zonotope.Envelope, semi_axes: tuple[float, ...]) -> float:
    """How many times as large as with these semi-axes an ellipsoid inside may be: every face is a limit."""
    return min(
        found.support(face) / math.hypot(*(s * n for s, n in zip(semi_axes, found.normal(face), strict=True)))
        for face in found.combinatorics.faces
    )


GRID = [math.radians(k) for k in range(1, 90)]
BALL = (1.0, 1.0, 1.0)
S = math.hypot(J[0], J[2])


@pytest.mark.parametrize(
    ("semi_axes", "best", "at"),
    [
        (BALL, math.sqrt(8 / 3), (math.atan(math.sqrt(2)), math.pi / 4)),
        (J, 4 / (J[1] + S), (math.atan(math.sqrt(J[0] ** 2 + S * J[1]) / J[2]), math.atan(J[0] / math.sqrt(S * J[1])))),
        (
            (3.0, 3.5, 4.0),
            math.sqrt(8) / math.hypot(3, 3.5, 4),
            (math.atan(math.hypot(3, 3.5) / 4), math.atan(3 / 3.5)),
        ),
    ],
    ids=["ball", "unbalanced", "balanced"],
)
def test_no_angles_are_better_for_four_wheels(
    semi_axes: tuple[float, ...], best: float, at: tuple[float, float]
) -> None:
    found = max(size(four_at(a, b), semi_axes) for a in GRID[::2] for b in GRID[::2])
    assert 0.99 * best < found < best * (1 + 1e-12)
    assert size(four_at(*at), semi_axes) == pytest.approx(best)


@pytest.mark.parametrize(
    ("semi_axes", "best", "at"),
    [(BALL, 8 / 3, math.sqrt(2)), (J, 8 / (2 * J[1] + J[2]), math.sqrt(2 * J[1] / J[2]))],
    ids=["ball", "unbalanced"],
)
def test_no_angle_is_better_for_six_wheels(semi_axes: tuple[float, ...], best: float, at: float) -> None:
    found = max(size(six_at(a), semi_axes) for a in GRID)
    assert 0.99 * best < found < best * (1 + 1e-12)
    assert size(six_at(math.atan(at)), semi_axes) == pytest.approx(best)
