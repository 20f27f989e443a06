"""Orientations in all their forms, turns of a body by its wheels, and the momentum that disturbances leave."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from chunked_samples import _rotations
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar
from scipy.spatial.transform import Rotation

from symcheck.numeric import attitude, inertia, wheels
from symcheck.numeric.domain import Array

TURNS = Rotation.random(20, rng=np.random.default_rng(5))
AXES = np.swapaxes(TURNS.as_matrix(), -1, -2)
ORDERS = ("scalar first", "scalar last")
MOMENTS = [2.0, 3.0, 4.0]

# --- orientations


def test_rows_are_the_turned_reference_axes() -> None:
    found = attitude.axes_of_rotation(TURNS)
    for number, unit in enumerate(np.eye(3)):
        np.testing.assert_allclose(found[:, number], TURNS.apply(unit), atol=1e-15)


def test_axes_come_back_through_every_form() -> None:
    for axes in (AXES, AXES[3], AXES.reshape(4, 5, 3, 3), AXES[:0]):
        for order in ORDERS:
            np.testing.assert_allclose(
                attitude.axes_of_quaternion(attitude.quaternion(axes, order), order), axes, atol=1e-14
            )
        np.testing.assert_allclose(attitude.axes_of_mrp(attitude.mrp(axes)), axes, atol=1e-14)
    np.testing.assert_allclose(attitude.axes_of_rotation(attitude.rotation(AXES)), AXES, atol=1e-15)


def test_the_orders_of_a_quaternion_differ_by_the_place_of_the_scalar() -> None:
    first, last = (attitude.quaternion(AXES, order) for order in ORDERS)
    assert (first[:, 0] >= 0).all()
    assert (first == np.roll(last, 1, axis=-1)).all()


def test_a_quaternion_gives_the_direction_cosines_of_the_textbooks() -> None:
    w, x, y, z = np.moveaxis(attitude.quaternion(AXES, "scalar first"), -1, 0)
    first_row = [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)]  # of [BN], Shuster's convention
    np.testing.assert_allclose(AXES[:, 0], np.stack(first_row, axis=-1), atol=1e-15)


@pytest.mark.parametrize("angle", [0.0, 1e-200, 1e-9, np.pi / 2, np.pi - 1e-9, np.pi])
def test_quaternion_and_mrp_are_those_of_the_angle(angle: float) -> None:
    turn = Rotation.from_rotvec([0, 0, angle])
    expected = [np.cos(angle / 2), 0, 0, np.sin(angle / 2)]
    np.testing.assert_allclose(attitude.quaternion(turn, "scalar first"), expected, atol=1e-15)
    np.testing.assert_allclose(np.abs(attitude.mrp(turn)), [0, 0, np.tan(angle / 4)], atol=1e-15)


def test_a_quaternion_of_any_length_is_one_orientation() -> None:
    given = attitude.quaternion(AXES, "scalar last")
    for scale in 2.0 ** np.arange(-1000, 1001, 250):
        np.testing.assert_allclose(attitude.axes_of_quaternion(-scale * given, "scalar last"), AXES, atol=1e-14)


def test_an_mrp_and_its_shadow_are_one_orientation() -> None:
    given = attitude.mrp(AXES)
    assert (np.linalg.norm(given, axis=-1) <= 1 + 1e-15).all()
    shadow = -given / np.square(given).sum(axis=-1, keepdims=True)
    np.testing.assert_allclose(attitude.axes_of_mrp(shadow), AXES, atol=1e-12)


TAKE_AXES: dict[str, Callable[[Any], Any]] = {
    "axial_moments": lambda axes: inertia.axial_moments(MOMENTS, axes),
    "inertia_tensor": lambda axes: inertia.inertia_tensor(MOMENTS, axes),
    "second_order_moments": lambda axes: inertia.second_order_moments(MOMENTS, axes),
    "product_of_axial_moments": lambda axes: inertia.product_of_axial_moments(MOMENTS, axes),
    "sum_of_products": lambda axes: inertia.sum_of_products(MOMENTS, axes),
    "gains_in_proportion": lambda axes: inertia.gains_in_proportion(0.1, MOMENTS, axes),
    "damping_matrix": lambda axes: inertia.damping_matrix([1, 2, 3], axes),
    "characteristic_coefficients": lambda axes: inertia.characteristic_coefficients(MOMENTS, [1, 2, 3], axes),
    "attitude_angles": inertia.attitude_angles,
    "ellipsoid_margin": lambda axes: wheels.ellipsoid_margin(wheels.half_spaces(np.eye(3)), [0.1, 0.2, 0.3], axes),
    "ellipsoid_scale": lambda axes: wheels.ellipsoid_scale(wheels.half_spaces(np.eye(3)), [0.1, 0.2, 0.3], axes),
    "quaternion": lambda axes: attitude.quaternion(axes, "scalar last"),
    "mrp": attitude.mrp,
}


@pytest.mark.parametrize("name", TAKE_AXES)
def test_a_rotation_is_taken_where_axes_are(name: str) -> None:
    for turn, axes in ((TURNS, AXES), (TURNS[3], AXES[3])):
        found, expected = TAKE_AXES[name](turn), TAKE_AXES[name](axes)
        assert np.shape(found) == np.shape(expected)
        np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-13)


def test_a_rotation_goes_together_with_chunks() -> None:
    chunked = pytest.importorskip("dask.array")
    moments = np.tile(MOMENTS, (20, 1))
    lazy = inertia.axial_moments(chunked.from_array(moments, chunks=(5, 3)), TURNS)
    np.testing.assert_allclose(lazy.compute(), inertia.axial_moments(moments, AXES), rtol=1e-14)


# --- turns


def test_the_time_of_a_turn_is_what_a_turn_takes() -> None:
    for angle, rate, acceleration in ((1.0, 0.5, 1.0), (1.0, 2.0, 1.0), (3.0, 0.1, 7.0)):
        time = float(attitude.turn_time(angle, rate, acceleration))
        t = np.linspace(0, time, 200001)
        speed = np.minimum(rate, acceleration * np.minimum(t, time - t))  # the fastest that both limits allow
        assert np.trapezoid(speed, t) == pytest.approx(angle, rel=1e-8)


def test_a_turn_without_rate_takes_for_ever_and_no_turn_no_time() -> None:
    assert attitude.turn_time([0, 1, 1, 0], [0, 0, 1, 1], [1, 1, 0, 1]).tolist() == [0, np.inf, np.inf, 0]


def test_a_turn_in_another_unit_of_time_takes_as_long() -> None:
    for unit in 2.0 ** np.arange(-325, 326, 65):
        found = attitude.turn_time(1.3, 0.5 / unit, 0.25 / unit**2) / unit
        assert found == pytest.approx(float(attitude.turn_time(1.3, 0.5, 0.25)), rel=1e-14)


PYRAMID = wheels.four_wheels(1.0, 0.7)


def test_the_wheels_of_a_turn_keep_within_their_limits_and_could_not_do_more() -> None:
    stored, driven = wheels.half_spaces(PYRAMID, 0.05), wheels.half_spaces(PYRAMID, 0.002)
    for u in _rotations(np.random.default_rng(2))[0, :5, 0]:
        found = attitude.agility(stored, driven, MOMENTS, u, 1.5)
        for most, limit in ((found.rate, 0.05), (found.acceleration, 0.002)):
            load = wheels.allocate(PYRAMID, -np.array(MOMENTS) * u * most, limit).load
            assert load == pytest.approx(1, rel=1e-12)
        assert found.time == attitude.turn_time(1.5, found.rate, found.acceleration)


def test_a_turn_after_a_failure_is_that_of_the_wheels_that_are_left() -> None:
    directions = _rotations(np.random.default_rng(3))[0, :6, 0]
    found = attitude.agility_after_failures(PYRAMID, MOMENTS, directions, 1.5, momentum=0.05, torque=0.002, count=1)
    assert found.wheels.tolist() == [[0], [1], [2], [3]]
    for case, (lost,) in enumerate(found.wheels):
        left = np.delete(PYRAMID, lost, axis=0)
        expected = attitude.agility(
            wheels.half_spaces(left, 0.05), wheels.half_spaces(left, 0.002), MOMENTS, directions, 1.5
        )
        for one, other in zip(found.agility, expected, strict=True):
            np.testing.assert_allclose(one[case], other, rtol=1e-12)


def test_two_failures_leave_turns_in_a_plane_only() -> None:
    found = attitude.agility_after_failures(np.eye(3), MOMENTS, np.eye(3), 1.0, count=2)
    assert (found.agility.rate > 0).tolist() == np.eye(3)[::-1].astype(bool).tolist()
    assert np.isinf(found.agility.time[found.agility.rate == 0]).all()


@pytest.mark.parametrize("failed", [None, 0, 2])
def test_a_turn_flown_by_the_equations_of_motion_ends_where_it_should(failed: int | None) -> None:
    limits = np.where(np.arange(4) == failed, 0, 0.02)
    for u, angle in (([1, 2, -3], 2.5), ([0, 1, 0], 0.1), ([1, 1, 1], 3.0)):
        found = attitude.turn(PYRAMID, MOMENTS, u, angle, momentum=limits, torque=limits / 10, points=5)
        assert max(found.momentum_load, found.torque_load) == pytest.approx(1, abs=1e-12)
        assert found.momentum_load <= 1 + 1e-12 >= found.torque_load
        working = np.delete(PYRAMID, failed, axis=0) if failed is not None else PYRAMID
        stored, driven = wheels.half_spaces(working, 0.02), wheels.half_spaces(working, 0.002)
        assert found.times[-1] == pytest.approx(float(attitude.agility(stored, driven, MOMENTS, u, angle).time))
        flown = attitude.fly(found, PYRAMID, MOMENTS, u)
        assert flown.error < 1e-7
        assert flown.residual_rate < 1e-10


def test_a_turn_that_starts_with_a_rate_misses() -> None:
    found = attitude.turn(PYRAMID, MOMENTS, [1, 2, 3], 1.0, momentum=0.02, torque=0.002, points=5)
    assert attitude.fly(found, PYRAMID, MOMENTS, [1, 2, 3], rate=[1e-4, 0, 0]).error > 1e-3


def test_wheels_that_cannot_turn_the_body_say_so() -> None:
    with pytest.raises(ValueError, match=r"demand.*plane or line"):
        attitude.turn(PYRAMID, MOMENTS, np.cross(*PYRAMID[:2]), 1.0, momentum=[1, 1, 0, 0])


# --- disturbances

TORQUES = np.array([3e-7, -2e-7, 1e-7]), np.array([2e-6, 1e-6, -3e-6]), np.array([-1e-6, 2e-6, 2e-6])
FREQUENCY, INITIAL = 1.1e-3, np.array([1e-3, -2e-3, 0.5e-3])


@pytest.mark.parametrize("dumping", [0.0, 1e-12, 1e-5, 3e-3, 1.0])
def test_the_momentum_is_the_integral_of_the_torque(dumping: float) -> None:
    constant, cosine, sine = TORQUES

    def change(t: float, state: Array) -> Array:
        phase = FREQUENCY * t
        return np.asarray(constant + cosine * np.cos(phase) + sine * np.sin(phase) - dumping * state)

    times = np.linspace(0, 2e4, 9)
    solved = solve_ivp(change, (0, 2e4), INITIAL, "LSODA", times, rtol=1e-11, atol=1e-15)
    found = attitude.momentum_in_time(times, *TORQUES, FREQUENCY, INITIAL, dumping)
    np.testing.assert_allclose(found, solved.y.T, atol=1e-9 * np.abs(solved.y).max())


def test_weak_dumping_is_none_in_the_limit() -> None:
    times = np.linspace(0, 1e6, 7)
    none = attitude.momentum_in_time(times, *TORQUES, FREQUENCY, INITIAL)
    for dumping in (1e-16, 1e-30, 1e-200):
        found = attitude.momentum_in_time(times, *TORQUES, FREQUENCY, INITIAL, dumping)
        np.testing.assert_allclose(found, none, rtol=1e-9)


def test_a_period_leaves_what_the_momentum_shows() -> None:
    period = 2 * np.pi / FREQUENCY
    found = attitude.momentum_of_a_period(*TORQUES, FREQUENCY)
    times = np.linspace(0, period, 200001)
    course = attitude.momentum_in_time(times, *TORQUES, FREQUENCY)
    np.testing.assert_allclose(course[-1], found.secular, rtol=1e-9)
    swing = course - TORQUES[0] * times[:, None]
    np.testing.assert_allclose(np.ptp(swing, axis=0) / 2, found.cyclic, rtol=1e-8)


def searched(bounds: wheels.HalfSpaces, arguments: list[Any], horizon: float) -> float:
    """The first time by looking at every step, refined; infinity if there is none before the horizon."""
    times = np.linspace(0, horizon, 60001)
    outside = np.flatnonzero(wheels.margin(bounds, attitude.momentum_in_time(times, *arguments)) < 0)
    if not len(outside):
        return np.inf
    low, high = times[max(outside[0] - 1, 0)], times[outside[0]]
    for _ in range(60):
        middle = (low + high) / 2
        inside = wheels.margin(bounds, attitude.momentum_in_time([middle], *arguments))[0] >= 0
        low, high = (middle, high) if inside else (low, middle)
    return float(high)


@pytest.mark.parametrize("case", range(16))
def test_the_time_to_saturation_is_the_first_one(case: int) -> None:
    rng = np.random.default_rng(case)
    bounds = wheels.half_spaces(PYRAMID, rng.uniform(2e-3, 2e-2), rng.uniform(-1e-4, 1e-4, 4))
    constant, cosine, sine = rng.normal(size=(3, 3)) * np.array([[10 ** rng.uniform(-8, -5.5)], [5e-6], [5e-6]])
    dumping = [0.0, 10 ** rng.uniform(-6, -3)][case % 2]
    arguments = [constant, cosine, sine, FREQUENCY, rng.normal(size=3) * 5e-4, dumping]
    found = float(attitude.time_to_saturation(bounds, *arguments))
    horizon = min(3e5, 1.2 * found)
    expected = searched(bounds, arguments, horizon)
    if np.isfinite(expected) or found < horizon:
        assert found == pytest.approx(expected, rel=1e-6, abs=1e-3)


def test_saturation_after_ten_million_orbits_is_found_at_once() -> None:
    bounds, swing = wheels.half_spaces(np.eye(3), 1.0), [1e-5, 0, 0]
    found = attitude.time_to_saturation(bounds, [1e-11, 0, 0], swing, [0, 0, 0], FREQUENCY)
    reached = attitude.momentum_in_time([found], [1e-11, 0, 0], swing, [0, 0, 0], FREQUENCY)[0]
    assert reached[0] == pytest.approx(1, rel=1e-9)
    peak = minimize_scalar(
        lambda t: -attitude.momentum_in_time([t], [1e-11, 0, 0], swing, [0, 0, 0], FREQUENCY)[0, 0],
        bounds=(float(found) - 2e3 - 2 * np.pi / FREQUENCY, float(found) - 2 * np.pi / FREQUENCY + 1e3),
        method="bounded",
    )
    assert -peak.fun < 1


def test_what_begins_outside_is_saturated_and_what_moves_in_a_flat_envelope_is_not() -> None:
    bounds = wheels.half_spaces(np.eye(3), 1e-2)
    assert attitude.time_to_saturation(bounds, *TORQUES, FREQUENCY, [0.02, 0, 0]) == 0
    flat = wheels.half_spaces(PYRAMID[:2], 1e-2, complete=True)
    along, across = PYRAMID[0], np.cross(*PYRAMID[:2])
    times = [attitude.time_to_saturation(flat, 1e-6 * u, 0 * u, 0 * u, FREQUENCY) for u in (along, across)]
    assert times == [pytest.approx(1e4), pytest.approx(0, abs=1e-9)]
    assert attitude.time_to_saturation(bounds, 0 * along, 0 * along, 0 * along, FREQUENCY) == np.inf


def test_saturation_in_another_unit_takes_as_long() -> None:
    limits, expected = 5e-3, None
    for unit in 2.0 ** np.arange(-325, 326, 65):
        bounds = wheels.half_spaces(PYRAMID, limits * unit)
        torques = [part * unit for part in TORQUES]
        found = attitude.time_to_saturation(bounds, *torques, FREQUENCY, INITIAL * unit, 1e-5)
        expected = found if expected is None else expected
        assert found == pytest.approx(float(expected), rel=1e-12)


UNFIT: dict[str, tuple[Callable[[], Any], str]] = {
    "left-handed": (lambda: attitude.rotation(-np.eye(3)), "axes.*right-handed"),
    "many": (lambda: attitude.rotation(AXES.reshape(4, 5, 3, 3)), r"axes.*reshape"),
    "order": (lambda: attitude.quaternion(np.eye(3), "xyzw"), "order = 'xyzw'.*scalar first, scalar last"),
    "zero": (lambda: attitude.axes_of_quaternion([0, 0, 0, 0], "scalar last"), "quaternion.*not be zero"),
    "five": (lambda: attitude.axes_of_quaternion(np.ones(5), "scalar last"), r"quaternion.*must be \(4\)"),
    "negative": (lambda: attitude.turn_time(1.0, -1.0, 1.0), "rate = -1.*not be negative"),
    "no axis": (
        lambda: attitude.agility(wheels.half_spaces(np.eye(3)), wheels.half_spaces(np.eye(3)), MOMENTS, [0, 0, 0]),
        "direction.*not be zero",
    ),
    "frequency": (lambda: attitude.momentum_of_a_period(*TORQUES, 0.0), "frequency = 0.*positive"),
    "past": (lambda: attitude.momentum_in_time([-1.0], *TORQUES, FREQUENCY), "times.*not be negative"),
    "dumping": (lambda: attitude.momentum_in_time([1.0], *TORQUES, FREQUENCY, dumping=-1), "dumping.*not be negative"),
}


@pytest.mark.parametrize(("call", "words"), UNFIT.values(), ids=UNFIT)
def test_what_does_not_fit_is_named(call: Callable[[], Any], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        call()
