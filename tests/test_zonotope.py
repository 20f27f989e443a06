"""Momentum envelopes against two strangers: all sign vectors tried by Gordan's alternative, and Qhull's convex hull.

The brute force knows nothing of triple products. A sign vector is a face of the envelope iff no linear dependence of
the axes contradicts it (Gordan, Stiemke); the minimal dependences come from exact elimination.
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, pairwise, product

import numpy as np
import pytest
from scipy.spatial import ConvexHull

from symcheck.core.verdicts import SymcheckError
from symcheck.mechanics.zonotope import Envelope, Signs, Vector, cross, dot, envelope

Axes = list[Vector]


# --- sets of wheels


def number(chance: random.Random) -> Fraction:
    return Fraction(chance.randint(-5, 5), chance.randint(1, 3))


def axis(chance: random.Random) -> Vector:
    while True:
        found = (number(chance), number(chance), number(chance))
        if any(found):
            return found


def combined(chance: random.Random, *axes: Vector) -> Vector:
    """A random combination of axes, not zero."""
    while True:
        factors = [number(chance) for _ in axes]
        x, y, z = (sum((f * each[c] for f, each in zip(factors, axes, strict=True)), Fraction(0)) for c in range(3))
        if any((x, y, z)):
            return x, y, z


def wheels(seed: int) -> Axes:
    """Three to seven rational axes; of four sets one is degenerate: parallel or coplanar axes, some or all."""
    chance = random.Random(seed)
    count = chance.randint(3, 7)
    if seed % 4:
        return [axis(chance) for _ in range(count)]
    free = chance.randint(1, count - 1) if seed % 8 else 2  # the others lie on the line, or in the plane, of these
    spanned = chance.randint(1, min(free, 2))
    axes = [axis(chance) for _ in range(free)]
    axes += [combined(chance, *axes[:spanned]) for _ in range(count - free)]
    chance.shuffle(axes)
    return axes


# --- brute force


def kernel(columns: list[Vector]) -> tuple[int, list[Fraction]]:
    """The rank of the columns, and a linear dependence of them if there is only one."""
    rows = [[Fraction(column[c]) for column in columns] for c in range(3)]
    pivots: list[int] = []
    for place in range(len(columns)):
        row = next((r for r in range(len(pivots), 3) if rows[r][place]), None)
        if row is None:
            continue
        rows[len(pivots)], rows[row] = rows[row], rows[len(pivots)]
        lead = [x / rows[len(pivots)][place] for x in rows[len(pivots)]]
        rows = [[x - each[place] * y for x, y in zip(each, lead, strict=True)] for each in rows]
        rows[len(pivots)] = lead
        pivots.append(place)
    free = [place for place in range(len(columns)) if place not in pivots]
    if len(free) != 1:
        return len(pivots), []
    values = {free[0]: Fraction(1)} | {p: -rows[r][free[0]] for r, p in enumerate(pivots)}
    return len(pivots), [values[place] for place in range(len(columns))]


def circuits(axes: Axes) -> Iterator[dict[int, int]]:
    """The signs of every minimal linear dependence of the axes."""
    for size in (2, 3, 4):
        for places in combinations(range(len(axes)), size):
            _, values = kernel([axes[p] for p in places])
            if values and all(values):
                yield {p: 1 if v > 0 else -1 for p, v in zip(places, values, strict=True)}


def faces_by_brute_force(axes: Axes) -> dict[int, set[Signs]]:
    """All sign vectors of the normals of supporting planes, by the dimension of what is touched."""
    dependences = list(circuits(axes))
    found: dict[int, set[Signs]] = {0: set(), 1: set(), 2: set(), 3: set()}
    for signs in product((1, 0, -1), repeat=len(axes)):
        if all({signs[p] * s for p, s in each.items()} not in ({1}, {-1}, {0, 1}, {0, -1}) for each in dependences):
            found[kernel([a for a, s in zip(axes, signs, strict=True) if s == 0])[0]].add(signs)
    return found


def check_by_brute_force(axes: Axes) -> None:
    found = envelope(axes).combinatorics
    brute = faces_by_brute_force(axes)
    rank = kernel(axes)[0]
    assert set(found.vertices) == brute[0]
    assert set(found.edges) == brute[1]
    assert set(found.faces) == brute[2]
    assert 1 + min(len(found.faces), 2) == rank
    assert sum(found.counts) - 2 * len(found.edges) == (2 if rank == 3 else 1)
    check_edges_and_cycles(envelope(axes), rank)
    check_metric(envelope(axes), rank)


def fits(vertex: Signs, face: Signs) -> bool:
    return all(s in (0, v) for v, s in zip(vertex, face, strict=True))


def check_edges_and_cycles(found: Envelope, rank: int) -> None:
    lattice = found.combinatorics
    for vertex, directions in lattice.vertices.items():
        leaving = {edge.index(0) + 1 for edge in lattice.edges if fits(vertex, edge)}
        assert {abs(d) for d in directions} == leaving
        assert len(directions) == len(leaving)
        assert all(d * vertex[abs(d) - 1] < 0 for d in directions)
    for edge, (first, last) in lattice.edges.items():
        assert {v for v in lattice.vertices if fits(v, edge)} == {first, last}
        assert (first[edge.index(0)], last[edge.index(0)]) == (-1, 1)
    for face, cycle in lattice.faces.items():
        assert {v for v in lattice.vertices if fits(v, face)} == set(cycle)
        assert len(set(cycle)) == len(cycle)
        points = [found.point(v) for v in (*cycle, *cycle[:2])]
        sides = [tuple(y - x for x, y in zip(one, two, strict=True)) for one, two in pairwise(points)]
        turns = [cross(one, two) for one, two in pairwise(sides)]
        outward = found.point(face) if rank == 3 else turns[0]
        assert all(dot(turn, outward) > 0 for turn in turns)
        assert all(not any(cross(turn, turns[0])) for turn in turns)


def check_metric(found: Envelope, rank: int) -> None:
    corners = [found.point(v) for v in product((1, -1), repeat=len(found.axes))]
    volume = Fraction(0)
    for face, cycle in found.combinatorics.faces.items():
        points = [found.point(v) for v in cycle]
        area = [0, 0, 0]  # twice the area, as a vector
        for one, two in pairwise([*points, points[0]]):
            area = [s + t for s, t in zip(area, cross(one, two), strict=True)]
        if rank == 3:
            normal = found.normal(face)
            assert found.support(face) == max(dot(normal, corner) for corner in corners)
            assert not any(cross(normal, (area[0], area[1], area[2])))
        volume += Fraction(dot((area[0], area[1], area[2]), points[0]), 6)
    assert found.volume() == volume


SETS = 520


@pytest.mark.parametrize("part", range(4))
def test_a_sample_of_wheel_sets_against_brute_force(part: int) -> None:
    for seed in range(part, SETS, 17):
        check_by_brute_force(wheels(seed))


@pytest.mark.slow
def test_all_wheel_sets_against_brute_force() -> None:
    for seed in range(SETS):
        check_by_brute_force(wheels(seed))


def test_a_quarter_of_the_sets_is_degenerate_in_every_way() -> None:
    degenerate = [axes for seed in range(SETS) if not seed % 4 and (axes := wheels(seed))]
    ranks = [kernel(axes)[0] for axes in degenerate]
    parallel = [axes for axes in degenerate if any(len(each) == 2 for each in circuits(axes))]
    assert len(degenerate) * 4 == SETS
    assert {1, 2, 3} <= set(ranks)
    assert len(parallel) > 20
    assert sum(rank == 2 for rank in ranks) > 20
    assert all(any(len(each) < 4 for each in circuits(axes)) for axes in degenerate)


def test_brute_force_knows_the_cube_and_the_rhombic_dodecahedron() -> None:
    cube: Axes = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
    assert [len(faces) for faces in faces_by_brute_force(cube).values()] == [8, 12, 6, 1]
    diagonals: Axes = [(1, -1, -1), (1, 1, -1), (1, -1, 1), (1, 1, 1)]
    assert [len(faces) for faces in faces_by_brute_force(diagonals).values()] == [14, 24, 12, 1]


# --- hull


def exact_hull(points: list[Vector]) -> tuple[set[Vector], set[frozenset[Vector]]]:
    """Vertices and faces of Qhull's convex hull, every face confirmed in rational arithmetic."""
    hull = ConvexHull(np.array(points, dtype=float))
    vertices = {points[k] for k in hull.vertices}
    faces = set()
    for simplex in hull.simplices:
        p, q, r = (points[k] for k in simplex)
        normal = cross(
            (q[0] - p[0], q[1] - p[1], q[2] - p[2]),
            (r[0] - p[0], r[1] - p[1], r[2] - p[2]),
        )
        heights = {point: dot(normal, point) - dot(normal, p) for point in points}
        assert any(normal)
        assert min(heights.values()) == 0 or max(heights.values()) == 0
        faces.add(frozenset(point for point in vertices if heights[point] == 0))
    return vertices, faces


def rational_circle(chance: random.Random) -> tuple[Fraction, Fraction]:
    """A rational sine and cosine of an angle between 0 and 90 degrees."""
    t = Fraction(chance.randint(1, 40), 41)
    return 2 * t / (1 + t * t), (1 - t * t) / (1 + t * t)


def four_wheels(chance: random.Random) -> Axes:
    (sa, ca), (sb, cb) = rational_circle(chance), rational_circle(chance)
    p, q, r = sa * sb, sa * cb, ca
    return [(p, -q, -r), (p, q, -r), (p, -q, r), (p, q, r)]


def six_wheels(chance: random.Random) -> Axes:
    """The six-sided pyramid, x in units of sqrt 3."""
    s, c = rational_circle(chance)
    half = s / 2
    return [(0, -s, c), (half, -half, c), (half, half, c), (0, -s, -c), (half, -half, -c), (half, half, -c)]


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize(("array", "failed"), [(four_wheels, 0), (four_wheels, 4), (six_wheels, 0), (six_wheels, 6)])
def test_vertices_and_faces_are_those_of_the_convex_hull(array, failed: int, seed: int) -> None:  # type: ignore[no-untyped-def]
    axes = [each for k, each in enumerate(array(random.Random(seed)), 1) if k != failed]
    found = envelope(axes)
    corners = [found.point(signs) for signs in product((1, -1), repeat=len(axes))]
    vertices, faces = exact_hull(corners)
    assert {found.point(v) for v in found.combinatorics.vertices} == vertices
    assert {frozenset(map(found.point, cycle)) for cycle in found.combinatorics.faces.values()} == faces


# --- degenerate sets, messages


def test_parallel_wheels_add_up() -> None:
    twice = envelope([(1, 0, 0), (0, 1, 0), (0, 0, 1), (-2, 0, 0)])
    once = envelope([(3, 0, 0), (0, 1, 0), (0, 0, 1)])
    assert {twice.point(v) for v in twice.combinatorics.vertices} == {
        once.point(v) for v in once.combinatorics.vertices
    }
    assert twice.volume() == once.volume() == 24
    assert (0, 1, 1, 0) in twice.combinatorics.edges


def test_coplanar_axes_make_faces_with_more_sides() -> None:
    prism = envelope([(1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, 1)]).combinatorics
    assert Counter(map(len, prism.faces.values())) == {4: 6, 6: 2}
    assert prism.counts == (12, 18, 8)


def test_axes_in_a_plane_make_a_polygon_and_on_a_line_a_segment() -> None:
    hexagon = envelope([(1, 0, 0), (0, 1, 0), (1, 1, 0)]).combinatorics
    assert hexagon.counts == (6, 6, 1)
    segment = envelope([(1, 2, 2), (-1, -2, -2)])
    assert (segment.combinatorics.counts, segment.volume()) == ((2, 1, 0), 0)
    assert [segment.point(v) for v in segment.combinatorics.vertices] == [(2, 4, 4), (-2, -4, -4)]


@pytest.mark.parametrize(
    ("axes", "message"),
    [
        ([(1, 0, 0), (0, 0, 0), (0, 1, 0)], "the axis of wheel 2 is zero"),
        ([(1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, 0)], "the axis of wheel 4 is zero"),
        ([(0, 0, 0)], "no wheel has an axis"),
        ([], "no wheel has an axis"),
        ([(1, 0, 0), (0, 1)], "wheel 2 has 2 components"),
    ],
)
def test_wrong_axes_are_refused(axes: list[tuple[int, ...]], message: str) -> None:
    with pytest.raises(SymcheckError, match=message):
        envelope(axes)
