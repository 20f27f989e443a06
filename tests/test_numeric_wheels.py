"""Envelopes of reaction wheels against Qhull, linear programs, exact lattices, the kernels and the paper's numbers."""

from __future__ import annotations

import subprocess
import sys
from collections import Counter
from collections.abc import Callable
from itertools import combinations, product
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog
from scipy.spatial import ConvexHull

from symcheck import kernels
from symcheck.mechanics.zonotope import chirotope, combinatorics
from symcheck.numeric import wheels
from symcheck.numeric.domain import Array
from symcheck.numeric.wheels import figures
from symcheck.papers.ignatov2005 import derivation

KERNELS = kernels.load("ignatov2005")
quick = settings(max_examples=40, deadline=None)

Whole = list[tuple[int, int, int]]
whole_axis = st.tuples(*[st.integers(-2, 2)] * 3).filter(any)
whole_axes = st.lists(whole_axis, min_size=1, max_size=8)  # often coplanar or parallel
DEGENERATE: dict[str, Whole] = {
    "coplanar triples": [(1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, 1), (1, 0, 1)],
    "parallel axes": [(1, 0, 0), (-2, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, 3)],
    "all coplanar": [(1, 0, 1), (0, 1, 1), (1, 1, 2), (1, -1, 0)],
    "all collinear": [(1, 2, 2), (-1, -2, -2)],
    "one wheel": [(0, 3, 4)],
    "a whole plane and one across": [(1, 0, 0), (0, 1, 0), (1, 1, 0), (1, -1, 0), (1, 2, 0), (1, 2, 5)],
}
tenths = st.integers(1, 20).map(lambda k: k / 10)
small = st.integers(-30, 30).map(lambda k: k / 10)
vectors = st.tuples(small, small, small).map(np.array)
moments = st.tuples(*[st.integers(1, 40)] * 3).filter(lambda j: 2 * max(j) <= sum(j)).map(np.array)
acute = st.integers(5, 85).map(np.radians)


def unit(whole: Any) -> Array:
    axes = np.array(whole, float)
    return np.asarray(axes / np.linalg.norm(axes, axis=-1, keepdims=True))


def random_axes(count: int, seed: int = 5, sets: tuple[int, ...] = ()) -> Array:
    return unit(np.random.default_rng(seed).normal(size=(*sets, count, 3)))


def corners(axes: Array, limits: Array) -> Array:
    """The momenta at all combinations of limits."""
    return np.array(list(product((-1, 1), repeat=len(axes)))) * limits @ axes


@st.composite
def sets_of_wheels(draw: Any, spanning: bool = False) -> tuple[Array, Array]:
    axes = unit(draw(whole_axes))
    limits = np.array(draw(st.lists(tenths, min_size=len(axes), max_size=len(axes))))
    assume(not spanning or np.linalg.matrix_rank(axes) == 3)
    return axes, limits


# --- the envelope as a polytope


def directed_edges(found: wheels.Envelope) -> Counter[tuple[int, int]]:
    """How often the faces have each edge, in each direction."""
    cycles = [found.faces[0][begin:end] for begin, end in zip(found.faces[1], found.faces[1][1:], strict=False)]
    return Counter((int(a), int(b)) for cycle in cycles for a, b in zip(cycle, np.roll(cycle, -1), strict=True))


def assert_lattice(whole: Whole) -> None:
    """Vertices, edges, faces and their sides are those that exact arithmetic finds."""
    exact, found = combinatorics(chirotope(whole)), wheels.envelope(unit(whole))
    assert found.counts == exact.counts
    assert found.dimension == 1 + min(len(exact.faces), 2)
    assert Counter(np.diff(found.faces[1]).tolist()) == Counter(map(len, exact.faces.values()))


@pytest.mark.parametrize("whole", DEGENERATE.values(), ids=DEGENERATE)
def test_degenerate_sets_have_the_exact_lattice(whole: Whole) -> None:
    assert_lattice(whole)


@quick
@given(whole_axes)
def test_any_set_has_the_exact_lattice(whole: Whole) -> None:
    assert_lattice(whole)


@quick
@given(sets_of_wheels(spanning=True))
def test_the_envelope_is_qhulls(case: tuple[Array, Array]) -> None:
    axes, limits = case
    points = corners(axes, limits)
    hull, found = ConvexHull(points), wheels.envelope(axes, limits)
    normals, distances, _ = found.half_spaces
    ours = np.column_stack([np.vstack([normals, -normals]), np.tile(distances, 2)])
    theirs = hull.equations * [1, 1, 1, -1]
    apart = np.abs(theirs[:, None] - ours).max(axis=2) < 1e-8
    assert apart.any(axis=1).all()
    assert apart.any(axis=0).all()
    assert wheels.volume(axes, limits) == pytest.approx(hull.volume, rel=1e-9)
    assert np.abs(found.vertices[:, None] - points).max(axis=2).min(axis=1).max() < 1e-9
    assert ConvexHull(found.vertices).volume == pytest.approx(hull.volume, rel=1e-9)


@quick
@given(sets_of_wheels())
def test_euler_symmetry_and_two_faces_at_each_edge(case: tuple[Array, Array]) -> None:
    found = wheels.envelope(*case)
    vertices, edges, faces = found.counts
    assert vertices - edges + faces == (1, 1, 1, 2)[found.dimension]
    half = vertices // 2
    assert np.array_equal(found.vertices[half:], -found.vertices[:half])
    if found.dimension < 3:
        return
    directed = directed_edges(found)
    assert set(directed.values()) == {1}
    assert {tuple(sorted(pair)) for pair in directed} == {tuple(sorted(edge)) for edge in found.edges.tolist()}
    corners_of, begins = found.faces
    for number in range(faces):
        outward = found.half_spaces.normals[number % (faces // 2)] * (1 if number < faces // 2 else -1)
        face = found.face(number)
        assert face @ outward == pytest.approx(found.half_spaces.distances[number % (faces // 2)])
        assert np.cross(face[1] - face[0], face[2] - face[1]) @ outward > 0
        other = (number + faces // 2) % faces
        opposite = (corners_of[begins[other] : begins[other + 1]] + half) % vertices
        assert set(opposite) == set(corners_of[begins[number] : begins[number + 1]])


def test_many_wheels_have_the_faces_of_all_pairs() -> None:
    axes, limits = random_axes(70), np.random.default_rng(6).uniform(0.5, 2, 70)
    found = wheels.envelope(axes, limits)
    assert found.counts == (70 * 69 + 2, 2 * 70 * 69, 70 * 69)
    assert np.sort(found.half_spaces.distances) == pytest.approx(np.sort(wheels.face_distances(axes, limits)))


def test_axes_that_are_neither_in_a_plane_nor_out_of_it_are_not_passed_over() -> None:
    rng, refused, done = np.random.default_rng(3), 0, 0
    for _ in range(150):
        axes = unit(rng.integers(-2, 3, (6, 3)) + rng.normal(size=(6, 3)) * 1e-5 + [0, 0, 1e-3])
        found = wheels.envelope(axes, tolerance=10.0 ** rng.uniform(-6, -4))
        try:
            found.counts  # noqa: B018
        except ArithmeticError:
            refused += 1
        else:
            done += 1
            assert set(directed_edges(found).values()) == {1}
            assert {(b, a) for a, b in directed_edges(found)} == set(directed_edges(found))
    assert refused > 0
    assert done > refused


def test_a_bias_shifts_the_envelope() -> None:
    axes, bias = random_axes(5), np.array([0.1, -0.2, 0.3, 0, 0.5])
    plain, shifted = wheels.envelope(axes), wheels.envelope(axes, bias=bias)
    centre = wheels.total_momentum(axes, bias)
    assert shifted.vertices == pytest.approx(plain.vertices + centre)
    assert wheels.margin(shifted.half_spaces, centre) == pytest.approx(wheels.margin(plain.half_spaces, np.zeros(3)))


# --- the paper's configurations


@quick
@given(acute, acute)
def test_four_wheels_are_those_of_the_kernels(a: float, b: float) -> None:
    axes = wheels.four_wheels(a, b)
    assert set(np.round(wheels.face_distances(axes), 9)) == set(
        np.round(KERNELS.face_distances_of_four_wheels(a, b), 9)
    )
    assert wheels.volume(axes) == pytest.approx(KERNELS.volume_of_four_wheels(a, b))
    after = KERNELS.face_distances_of_three_wheels(a, b)
    assert np.sort(wheels.face_distances(axes[:3])) == pytest.approx(np.sort(after))
    assert wheels.failures(axes).half_spaces.distances.min(axis=1) == pytest.approx(np.full(4, min(after)))
    assert wheels.volume(axes, [1, 1, 1, 0]) == pytest.approx(KERNELS.volume_of_three_wheels(a, b))


@quick
@given(acute)
def test_six_wheels_are_those_of_the_kernels(a: float) -> None:
    axes = wheels.six_wheels(a)
    for number, words in ((6, "six"), (5, "five")):
        distances = getattr(KERNELS, f"face_distances_of_{words}_wheels")(a)
        assert set(np.round(wheels.face_distances(axes[:number]), 9)) == set(np.round(distances, 9))
        assert wheels.volume(axes[:number]) == pytest.approx(getattr(KERNELS, f"volume_of_{words}_wheels")(a))


@pytest.mark.parametrize("number", [3, 4, 5, 6])
def test_the_listed_vertices_are_all_vertices(number: int) -> None:
    angles = (1.1, 0.6) if number < 5 else (1.2,)
    axes = (wheels.four_wheels(*angles) if number < 5 else wheels.six_wheels(*angles))[:number]
    listed, found = np.array(list(wheels.listed_vertices(number, *angles).values())), wheels.envelope(axes).vertices
    assert len(listed) == len(found)
    assert np.abs(listed[:, None] - found).max(axis=2).min(axis=1).max() < 1e-12


def test_numbers_agree_with_the_derivation() -> None:
    for pyramid, angles in ((4, {"a": 1.1, "b": 0.6}), (6, {"a": 1.2})):
        [exact] = derivation.volume(pyramid, pyramid).values()
        value = float(exact.subs({symbol: angles[symbol.name] for symbol in exact.free_symbols}))
        axes = (wheels.four_wheels if pyramid == 4 else wheels.six_wheels)(*angles.values())
        assert wheels.volume(axes) == pytest.approx(value, rel=1e-13)


def test_the_paper_chooses_these_angles() -> None:
    body = [1000, 1600, 800]
    assert np.degrees(wheels.equal_rates_of_four_wheels(body)).round().tolist() == [67, 32]
    assert np.degrees(wheels.equal_rates_of_six_wheels(body)).round().tolist() == [72]
    found = wheels.design(body, [0, 0, 0], rates_about="principal axes")
    assert found.four.largest_rates.round(3).tolist() == [0.002] * 3
    assert found.six.largest_rates.round(4).tolist() == [0.0033, 0.0024, 0.0024]  # the paper cuts off: 0.0023


# --- many sets at once


def test_many_sets_are_each_set() -> None:
    axes, limits = random_axes(6, sets=(7, 300)), np.random.default_rng(1).uniform(0.1, 2, (300, 6))
    found = wheels.half_spaces(axes, limits)
    assert found.normals.shape == (7, 300, 15, 3)
    for place in ((0, 0), (3, 299), (6, 150)):
        one = wheels.half_spaces(axes[place], limits[place[1]])
        assert found.normals[place] == pytest.approx(one.normals, abs=1e-15)
        assert found.distances[place] == pytest.approx(one.distances, rel=1e-14)
    assert wheels.face_distances(axes, limits) == pytest.approx(found.distances, rel=1e-15)
    assert wheels.volume(axes, limits)[3, 299] == pytest.approx(float(wheels.volume(axes[3, 299], limits[299])))


@pytest.mark.parametrize("engine", ["numpy", "numba"])
def test_a_set_with_parallel_axes_changes_no_other_set(engine: str) -> None:
    if engine != "numpy":
        pytest.importorskip(engine)
    axes = random_axes(6, sets=(1200,))  # more than a block, and the last block is not full
    parallel = {0: (0, 1), 545: (2, 4), 546: (0, 1), 1199: (4, 5)}
    for place, (first, second) in parallel.items():
        axes[place, second] = -axes[place, first]
    found = wheels.half_spaces(axes, engine=engine)
    pairs = list(combinations(range(6), 2))
    infinite = {(int(place), pairs[pair]) for place, pair in np.argwhere(np.isinf(found.distances))}
    assert infinite == set(parallel.items())
    for place in (*parallel, 1, 544, 1000, 1198):
        one = wheels.half_spaces(axes[place], engine=engine)
        assert found.normals[place] == pytest.approx(one.normals, abs=1e-15)
        assert found.distances[place] == pytest.approx(one.distances, rel=1e-14)
        assert wheels.face_distances(axes, engine=engine)[place] == pytest.approx(one.distances, rel=1e-14)


@pytest.mark.parametrize("engine", ["numpy", "numba"])
def test_no_sets_have_no_half_spaces(engine: str) -> None:
    if engine != "numpy":
        pytest.importorskip(engine)
    axes = np.empty((2, 0, 4, 3))
    assert [each.shape for each in wheels.half_spaces(axes, engine=engine)] == [(2, 0, 6, 3), (2, 0, 6), (2, 0, 3)]
    assert wheels.face_distances(axes, engine=engine).shape == (2, 0, 6)


def test_a_number_for_all_wheels_is_checked_in_every_call_and_cannot_be_changed() -> None:
    given = wheels.wheels_of(np.eye(3), 1.0, 1)
    for shared in (given.limits, given.bias):
        with pytest.raises(ValueError, match="read-only"):
            shared[0] = 2
    for number in (True, np.nan, "1"):
        with pytest.raises(ValueError, match="limits = "):
            wheels.wheels_of(np.eye(3), number)  # type: ignore[arg-type]
    for _ in range(2):
        with pytest.raises(ValueError, match=r"limits = -1.* not be negative"):
            wheels.wheels_of(np.eye(3), -1.0)


@pytest.mark.parametrize("whole", DEGENERATE.values(), ids=DEGENERATE)
def test_engines_agree(whole: Whole) -> None:
    pytest.importorskip("numba")
    limits = np.random.default_rng(8).uniform(0.1, 2, (40, len(whole)))
    ours, theirs = (wheels.half_spaces(unit(whole), limits, complete=True, engine=each) for each in ("numpy", "numba"))
    assert ours.normals == pytest.approx(theirs.normals, abs=1e-15)
    assert ours.distances == pytest.approx(theirs.distances, abs=1e-14)
    with pytest.raises(ValueError, match="span space"):
        wheels.half_spaces(unit(whole[:2]), engine="numba")


@pytest.mark.parametrize("off", [0.6, np.nan, np.inf, 1e200, 1 + 1e-8])
def test_what_is_compiled_looks_at_the_length_of_every_axis(off: float) -> None:
    pytest.importorskip("numba")
    fine = np.tile(np.vstack([np.eye(3), [[0.6, 0.8, 0]]]), (50, 1, 1))
    for place in ((0, 0, 0), (49, 3, 1)):
        axes = fine.copy()
        axes[place] = off
        for function in (wheels.half_spaces, wheels.face_distances):
            said = []
            for engine in ("numpy", "numba"):
                with pytest.raises(ValueError, match="must be finite and have the length 1") as error:
                    function(axes, engine=engine)
                said.append(str(error.value))
            assert said[0] == said[1]
    with pytest.raises(ValueError, match="have the length 1"):
        wheels.half_spaces([[2, 0, 0], [0, 1, 0]], engine="numba")


def test_limits_that_sets_share_give_what_limits_of_each_set_give_in_compiled_engines() -> None:
    pytest.importorskip("numba")
    axes = np.tile(np.vstack([np.eye(3), [[0.6, 0.8, 0]]]), (5, 4, 1, 1))
    shared, each = np.array([1.0, 2, 3, 4]), np.random.default_rng(3).uniform(1, 2, (4, 4))
    for limits in (2.0, shared, shared[None, None], each, each[:, None].swapaxes(0, 1), np.tile(each, (5, 1, 1))):
        found, expected = (wheels.face_distances(axes, limits, engine=engine) for engine in ("numba", "numpy"))
        np.testing.assert_allclose(found, expected, rtol=1e-14)


@quick
@given(sets_of_wheels(), vectors)
def test_completed_half_spaces_hold_the_corners_and_nothing_else(case: tuple[Array, Array], point: Array) -> None:
    axes, limits = case
    bounds = wheels.half_spaces(axes, limits, complete=True)
    assert wheels.margin(bounds, corners(axes, limits)).min() >= -1e-12
    inside = float(wheels.margin(bounds, point))
    load = least_load(axes, limits, point)
    assume(abs(inside) > 1e-9)
    assert (inside > 0) == (load < 1)


@quick
@given(sets_of_wheels(spanning=True), st.data())
def test_a_failed_wheel_is_a_wheel_left_out(case: tuple[Array, Array], data: Any) -> None:
    axes, limits = case
    count = data.draw(st.integers(0, min(3, len(axes))))
    left = wheels.failures(axes, limits, count=count)
    assert left.wheels.tolist() == [list(c) for c in combinations(range(len(axes)), count)]
    case_number = data.draw(st.integers(0, len(left.wheels) - 1))
    works = np.setdiff1d(np.arange(len(axes)), left.wheels[case_number])
    points = np.vstack([corners(axes[works], limits[works]), 3 * np.eye(3), data.draw(vectors)])
    bounds = wheels.HalfSpaces(
        left.half_spaces.normals[case_number], left.half_spaces.distances[case_number], np.zeros(3)
    )
    margins = wheels.margin(bounds, points)
    assert margins[:-4].min() >= -1e-12
    for point, room in zip(points[-4:], margins[-4:], strict=True):
        assert abs(room) < 1e-9 or (room > 0) == (least_load(axes[works], limits[works], point) < 1)


def test_a_failed_wheel_halves_what_four_wheels_guarantee() -> None:
    found = wheels.design([1000, 1600, 800], [0.001, 0.001, 0.001]).four
    assert found.rate_after_failure == pytest.approx(np.full(4, found.guaranteed_rate / 2))


# --- margins


def least_load(axes: Array, limits: Array, demand: Array) -> float:
    """The least greatest load by linear programming; infinite if no momenta do."""
    count = len(axes)
    if not count:
        return 0.0 if not demand.any() else np.inf
    bounds = np.vstack([np.column_stack([sign * np.eye(count), -limits]) for sign in (1, -1)])
    found = linprog(
        np.append(np.zeros(count), 1),
        A_ub=bounds,
        b_ub=np.zeros(2 * count),
        A_eq=np.column_stack([axes.T, np.zeros(3)]),
        b_eq=demand,
        bounds=[(None, None)] * count + [(0, None)],
    )
    return float(found.fun) if found.success else np.inf


@pytest.mark.parametrize("decades", [3, 6, 12])
def test_the_load_of_a_point_of_the_boundary_is_its_part_whatever_the_limits(decades: int) -> None:
    rng = np.random.default_rng(decades)
    for count in range(3, 8):
        axes, limits = random_axes(count, count), rng.uniform(0.5, 1, count)
        limits[:2] *= 10.0**decades  # these lie in the face, and are at rest
        signs = np.sign(axes @ np.cross(*axes[:2]))
        signs[:2] = 0
        found = wheels.allocate(axes, 0.296 * (signs * limits) @ axes, limits)
        assert found.load == pytest.approx(0.296, rel=1e-6)


SCALES = 10.0 ** np.arange(-300, 301, 50)
CUBES = SCALES[np.abs(np.log10(SCALES)) <= 100]  # of which the third power is a double


def test_a_direction_of_any_length_gives_the_same_momentum() -> None:
    bounds = wheels.half_spaces(random_axes(5))
    expected = wheels.largest_momentum(bounds, [1, 2, 3])
    found = wheels.largest_momentum(bounds, np.multiply.outer(SCALES, [1, 2, 3]))
    np.testing.assert_allclose(found, expected, rtol=1e-14)


@pytest.mark.parametrize("scale", SCALES)
def test_the_envelope_of_limits_of_any_size_has_the_same_shape(scale: float) -> None:
    one, scaled = (wheels.half_spaces(random_axes(5), 5.0 * size) for size in (1.0, scale))
    semi_axes = np.array([1.0, 2.0, 3.0])
    expected = wheels.ellipsoid_scale(one, semi_axes)
    assert wheels.ellipsoid_scale(scaled, semi_axes * scale) == pytest.approx(expected, rel=1e-12)
    assert wheels.largest_momentum(scaled, semi_axes) / scale == pytest.approx(wheels.largest_momentum(one, semi_axes))


@pytest.mark.parametrize("scale", CUBES)
def test_the_volume_goes_with_the_third_power_of_the_limits(scale: float) -> None:
    assert wheels.volume(random_axes(5), scale) / scale**3 == pytest.approx(wheels.volume(random_axes(5)), rel=1e-12)


def test_a_volume_beyond_the_doubles_is_an_error() -> None:
    with pytest.raises(ValueError, match="volume = inf must be a finite double"):
        wheels.volume(random_axes(5), 1e110)


def test_a_mask_is_not_lost_but_refused() -> None:
    with pytest.raises(ValueError, match="limits is a masked array"):
        wheels.volume(np.eye(3), np.ma.masked_less([1.0, 2.0, 3.0], 2))


@quick
@given(sets_of_wheels(spanning=True), vectors.filter(np.any))
def test_the_largest_momentum_is_the_linear_programs(case: tuple[Array, Array], direction: Array) -> None:
    bounds = wheels.half_spaces(*case)
    farthest = wheels.largest_momentum(bounds, direction)
    end = farthest * direction / np.linalg.norm(direction)
    assert least_load(*case, end) == pytest.approx(1)
    assert wheels.margin(bounds, end) == pytest.approx(0, abs=1e-12)


def test_with_a_bias_the_largest_momenta_of_opposite_directions_differ() -> None:
    bounds = wheels.half_spaces(np.eye(3), bias=[0.25, 0, 0])
    assert wheels.largest_momentum(bounds, [[1, 0, 0], [-1, 0, 0]]).tolist() == [1.25, 0.75]


def test_a_flat_envelope_is_left_in_its_plane_only() -> None:
    axes = unit([(1, 2, 2), (2, 1, -2)])
    bounds = wheels.half_spaces(axes, complete=True)
    assert wheels.largest_momentum(bounds, axes[0] + axes[1]) == pytest.approx(np.sqrt(2))
    assert wheels.largest_momentum(bounds, [2, -2, 1]) == pytest.approx(0, abs=1e-12)


@quick
@given(sets_of_wheels(spanning=True), st.tuples(tenths, tenths, tenths), vectors.filter(np.any))
def test_an_ellipsoid_fits_exactly_to_its_scale(case: tuple[Array, Array], semi: Any, turned: Array) -> None:
    bounds = wheels.half_spaces(*case)
    directions = np.linalg.qr(np.column_stack([turned, np.eye(3)]))[0].T
    scale = wheels.ellipsoid_scale(bounds, semi, directions)
    assert wheels.ellipsoid_margin(bounds, scale * np.array(semi), directions) == pytest.approx(0, abs=1e-12)
    sphere = random_axes(2000, 3)
    points = scale * (sphere * semi) @ directions
    assert wheels.margin(bounds, points).min() >= -1e-12
    normals = bounds.normals[np.isfinite(bounds.distances)]
    towards = normals @ directions.T * semi  # to the point of the ellipsoid furthest along each normal
    touching = scale * (towards / np.linalg.norm(towards, axis=1, keepdims=True) * semi) @ directions
    assert wheels.margin(bounds, touching).min() == pytest.approx(0, abs=1e-12)


@quick
@given(sets_of_wheels(spanning=True), moments)
def test_the_rates_are_those_that_the_momenta_give(case: tuple[Array, Array], body: Array) -> None:
    bounds = wheels.half_spaces(*case)
    found = wheels.rates(bounds, body)
    given_rates = -corners(*case) / body  # (2.3)
    assert wheels.margin(found, given_rates).min() == pytest.approx(0, abs=1e-12)
    guaranteed = wheels.guaranteed_rate(bounds, body)
    about = np.vstack([found.normals[np.linalg.norm(found.normals, axis=1) > 0], random_axes(500)])
    assert wheels.largest_momentum(found, about).min() == pytest.approx(guaranteed)
    assert guaranteed == pytest.approx(wheels.ellipsoid_scale(bounds, body))


# --- allocation


@quick
@given(sets_of_wheels(spanning=True), vectors)
def test_the_greatest_load_is_least(case: tuple[Array, Array], demand: Array) -> None:
    axes, limits = case
    found = wheels.allocate(axes, demand, limits)
    assert found.momenta @ axes == pytest.approx(demand, abs=1e-12)
    assert found.load == pytest.approx(least_load(axes, limits, demand), abs=1e-9)
    assert (np.abs(found.momenta) / limits).max() == pytest.approx(found.load)


def test_wheels_that_do_not_bind_are_loaded_as_little_as_can_be() -> None:
    axes = unit([(1, 0, 0), (0, 1, 0), (0, 1, 0), (0, 1, 1), (0, 1, -1)])
    found = wheels.allocate(axes, [1, 0.1, 0])
    assert found.load == pytest.approx(1)
    assert np.abs(found.momenta[1:]).max() == pytest.approx(least_load(axes[1:], np.ones(4), np.array([0, 0.1, 0])))


def test_many_demands_are_each_demand() -> None:
    axes, demands = wheels.six_wheels(1.2), np.random.default_rng(2).normal(size=(20, 30, 3))
    found = wheels.allocate(axes, demands, limits=2, bias=0.1)
    assert found.momenta @ axes == pytest.approx(demands)
    one = wheels.allocate(axes, demands[4, 5], limits=2, bias=0.1)
    assert found.momenta[4, 5] == pytest.approx(one.momenta)
    assert found.load[4, 5] == pytest.approx(one.load)


def test_a_failed_wheel_takes_no_part() -> None:
    for share in (wheels.allocate, wheels.allocate_least_squares):
        found = share(wheels.six_wheels(1.2), [0.5, 0.2, 0.1], [1, 1, 0, 1, 1, 1])
        assert found.momenta[2] == 0
        assert found.momenta @ wheels.six_wheels(1.2) == pytest.approx([0.5, 0.2, 0.1], abs=1e-9)


@quick
@given(sets_of_wheels(spanning=True), vectors)
def test_least_squares_comes_nearest(case: tuple[Array, Array], demand: Array) -> None:
    axes, limits = case
    found = wheels.allocate_least_squares(axes, demand, limits)
    assert found.load <= 1 + 1e-12
    gap = demand - found.momenta @ axes
    assert ((corners(axes, limits) - found.momenta @ axes) @ gap).max() <= 1e-8  # a projection onto a convex body
    if least_load(axes, limits, demand) < 1:
        assert np.abs(gap).max() < 1e-9
        gentlest = np.linalg.lstsq(axes.T * limits, demand, rcond=None)[0]
        slack = 2e-9 * np.abs(gentlest).sum()  # of squares whose roots are to 1e-9
        assert np.square(found.momenta / limits).sum() >= np.square(gentlest).sum() - slack
        if np.abs(gentlest).max() < 1:
            assert found.momenta == pytest.approx(gentlest * limits, abs=1e-8)


# --- design


@settings(max_examples=12, deadline=None)
@given(moments)
def test_no_search_finds_better_angles(body: Array) -> None:
    for best, configuration in (
        (wheels.best_angles_of_four_wheels(body), wheels.four_wheels),
        (wheels.best_angle_of_six_wheels(body), wheels.six_wheels),
    ):
        ours = wheels.guaranteed_rate(wheels.half_spaces(configuration(*best)), body)
        found = wheels.best_parameters(configuration, [(0.02, 1.55)] * len(best), body)
        assert found.rate <= ours * (1 + 1e-12)
        assert found.rate == pytest.approx(ours, rel=1e-4)  # for (1, 8, 8) the search ends 5.5e-5 below the best


@quick
@given(moments)
def test_the_kernel_has_the_best_angle_of_six_where_its_face_binds(body: Array) -> None:
    angle, rate = KERNELS.best_angle_of_six_wheels(*map(float, body[1:]))
    reached = wheels.guaranteed_rate(wheels.half_spaces(wheels.six_wheels(angle)), body)
    best = wheels.best_angle_of_six_wheels(body)
    ours = wheels.guaranteed_rate(wheels.half_spaces(wheels.six_wheels(best[0])), body)
    assert ours <= rate * (1 + 1e-12)
    if reached > rate * (1 - 1e-12):
        assert best[0] == pytest.approx(angle, rel=1e-7)
        assert ours == pytest.approx(rate)


def test_a_design_broadcasts_and_its_margins_are_those_of_its_axes() -> None:
    bodies = np.array([[1000, 1600, 800], [900, 1000, 1100], [500, 2000, 1900]])
    found = wheels.design(bodies, [0.004, 0.003, 0.005], limit=[4, 5, 6])
    for arrangement, count in ((found.four, 4), (found.six, 6)):
        assert arrangement.axes.shape == (3, count, 3)
        for k, limit in enumerate((4, 5, 6)):
            bounds = wheels.half_spaces(arrangement.axes[k], limit)
            rate, semi = wheels.guaranteed_rate(bounds, bodies[k]), bodies[k] * [0.004, 0.003, 0.005]
            assert arrangement.guaranteed_rate[k] == pytest.approx(float(rate))
            assert arrangement.margin[k] == pytest.approx(float(wheels.ellipsoid_margin(bounds, semi)))
            for axis, largest in zip(np.eye(3), arrangement.largest_rates[k], strict=True):
                assert wheels.largest_momentum(wheels.rates(bounds, bodies[k]), axis) == pytest.approx(largest)
            left = wheels.half_spaces(arrangement.axes[k], np.where(np.arange(count) == 1, 0, limit))
            assert arrangement.margin_after_failure[k, 1] == pytest.approx(float(wheels.ellipsoid_margin(left, semi)))


# --- arguments, documentation, figures

BODY, SLOW = [1000, 1600, 800], [0, 0, 0]
UNFIT: dict[str, tuple[Callable[[], Any], str]] = {
    "no unit vector": (lambda: wheels.half_spaces([[1, 0, 0], [0, 2, 0]]), r"axes\[1\] = .*length 1.*\(2\.1\)"),
    "axis not finite": (lambda: wheels.half_spaces([[1, 0, 0], [0, np.nan, 0]]), r"axes\[1\] = .*nan.*be finite"),
    "axis without end": (lambda: wheels.envelope([[1, 0, 0], [np.inf, 0, 0]]), r"axes\[1\] = .*inf.*be finite"),
    "axis out of range": (lambda: wheels.half_spaces([[1e200, 0, 0], [0, 1, 0]]), r"axes\[0\] = .*1.e.200.*length 1"),
    "negative limit": (lambda: wheels.envelope(np.eye(3), [1, -1, 1]), r"limits\[1\] = .*-1.*not be negative"),
    "wrong number of limits": (lambda: wheels.half_spaces(np.eye(3), [1, 1]), "limits has shape .*3 wheels"),
    "shapes": (lambda: wheels.half_spaces(random_axes(4, sets=(2,)), np.ones((3, 4))), "must broadcast"),
    "not spanning": (lambda: wheels.half_spaces(unit([(1, 0, 0), (0, 1, 0), (1, 1, 0)])), "axes.*span space.*complete"),
    "two wheels": (lambda: wheels.half_spaces([[1, 0, 0], [0, 1, 0]]), "axes.*span space"),
    "no wheels": (lambda: wheels.half_spaces(np.empty((0, 3))), "one wheel"),
    "a of 90 degrees": (lambda: wheels.four_wheels(np.pi / 2, 1), "a = .*1.57.*between 0 and pi/2"),
    "several sets": (lambda: wheels.envelope(random_axes(4, sets=(2,))), "one set of wheels"),
    "tolerance": (lambda: wheels.envelope(np.eye(3), tolerance=0), "tolerance = .*0.*between"),
    "too many failures": (lambda: wheels.failures(np.eye(3), count=4), "count = .*4.* from 0 to 3"),
    "zero direction": (lambda: wheels.largest_momentum(wheels.half_spaces(np.eye(3)), SLOW), "direction.*zero"),
    "biased": (lambda: wheels.ellipsoid_scale(wheels.half_spaces(np.eye(3), bias=2), [1, 1, 1]), "biases"),
    "semi-axes": (lambda: wheels.ellipsoid_margin(wheels.half_spaces(np.eye(3)), [1, -1, 1]), r"semi_axes.*\(1\.2\)"),
    "moments": (lambda: wheels.rates(wheels.half_spaces(np.eye(3)), [1, 0, 1]), "moments.*positive"),
    "no body": (lambda: wheels.design([1, 1, 3], SLOW), "moments.*triangle"),
    "negative rate": (lambda: wheels.design(BODY, [0, -1, 0]), r"required_rates.*-1.*\(1\.2\)"),
    "choice": (lambda: wheels.design(BODY, SLOW, rates_about="all"), "rates_about = .*'all'.*every axis"),
    "out of the plane": (lambda: wheels.allocate([[1, 0, 0], [0, 1, 0]], [0, 0, 1]), "demand.*plane or line"),
    "not a number": (lambda: wheels.allocate(np.eye(3), [0, np.nan, 1]), r"demand\[1\] = .*nan.*finite"),
    "number": (lambda: wheels.listed_vertices(7, 1.0), "number = 7 must be one of 3, 4, 5, 6"),
    "angles": (lambda: wheels.listed_vertices(6, 1.0, 1.0), "angles.*1 for 6 wheels"),
    "bounds": (lambda: wheels.best_parameters(wheels.six_wheels, [(1.0, 0.5)], BODY), "bounds.*below their end"),
    "engine": (lambda: wheels.half_spaces(np.eye(3), engine="c"), "engine = .*'c'.* numpy, numba"),
    "plane": (lambda: wheels.plot_projection(wheels.envelope(np.eye(3)), "ZX"), "plane = .*'ZX'.* must be one of XY"),
    "name": (lambda: wheels.plot_envelope(wheels.envelope(np.eye(3)), {"A": [0, 0, 0]}), "'A'.*vertex"),
}


@pytest.mark.parametrize(("call", "words"), UNFIT.values(), ids=UNFIT)
def test_what_does_not_fit_is_named(call: Callable[[], Any], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        call()


def test_numbers_need_no_algebra() -> None:
    code = "import sys, symcheck.numeric.wheels as w; w.four_wheels(1, 1); print('sympy' in sys.modules)"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "False"


@pytest.mark.parametrize("name", figures.FIGURES)
def test_a_figure_has_units_and_lines(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    panels = np.ravel(np.array(figures.FIGURES[name](), dtype=object))
    for ax in panels:
        assert ax.has_data()
        assert ax.get_xlabel() == "X" or "N m s" in ax.get_xlabel()
    panels[0].get_figure().canvas.draw()


def test_a_projection_names_what_is_seen_only() -> None:
    found = wheels.envelope(wheels.six_wheels(1.2))
    drawn = wheels.plot_projection(found, "XY", wheels.listed_vertices(6, 1.2))
    words = {text.get_text() for text in drawn.texts}
    assert "$V_{1}$" in words
    assert "$V_{1}'$" not in words
