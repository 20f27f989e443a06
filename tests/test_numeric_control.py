"""Torque envelopes, null motion, trades of arrays of wheels, exports to simulators, and pictures that can be turned."""

from __future__ import annotations

import ast
import sys
from collections.abc import Callable
from itertools import combinations
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.spatial.transform import Rotation

from symcheck.numeric import attitude, wheels
from symcheck.numeric.domain import Array

PYRAMID, SIX = wheels.four_wheels(1.0, 0.7), wheels.six_wheels(0.9)
BODY = [0.036, 0.036, 0.007]
TYPES = [
    wheels.WheelType("small", 0.010, 0.001, 0.12, 0.8),
    wheels.WheelType("large", 0.030, 0.004, 0.20, 1.5),
]

# --- torques


def test_at_rest_the_torque_envelope_is_the_zonotope_of_the_torques() -> None:
    found, expected = wheels.torque_envelope(PYRAMID, [1, 2, 3, 4]), wheels.envelope(PYRAMID, [1, 2, 3, 4])
    np.testing.assert_array_equal(found.vertices, expected.vertices)
    bounds = wheels.torque_half_spaces(PYRAMID, np.zeros(4), [1, 2, 3, 4])
    plain = wheels.half_spaces(PYRAMID, [1, 2, 3, 4])
    directions = np.random.default_rng(1).normal(size=(50, 3))
    np.testing.assert_allclose(
        wheels.largest_momentum(bounds, directions), wheels.largest_momentum(plain, directions), rtol=1e-13
    )


def test_every_torque_in_the_range_keeps_speed_and_power_within_limits() -> None:
    momenta = np.linspace(-1, 1, 21)
    power, inertia = 0.2, 0.05
    found = wheels.torque_range(momenta, 0.1, limits=1.0, power=power, rotor_inertia=inertia)
    for torque in found:
        assert (torque * momenta / inertia <= power * (1 + 1e-15)).all()
        assert (np.abs(torque) <= 0.1).all()
    assert (found.greatest[momenta < 0] == 0.1).all()  # braking
    assert found.greatest[-1] == found.least[0] == 0  # no way beyond the limit
    free = (momenta > 0) & (momenta < 1) & (found.greatest < 0.1)
    np.testing.assert_allclose((found.greatest * momenta / inertia)[free], power)  # and no less than there is
    assert free.any()


def test_the_envelope_at_speed_has_the_sums_of_all_ends_inside() -> None:
    momenta = np.array([0.9, -1.0, 0.3, 0.0])
    least, greatest = wheels.torque_range(momenta, 0.1, limits=1.0, power=1.0, rotor_inertia=0.05)
    ends = np.array(np.meshgrid(*zip(least, greatest, strict=True))).reshape(4, -1).T @ PYRAMID
    bounds = wheels.torque_half_spaces(PYRAMID, momenta, 0.1, 1.0, 1.0, 0.05)
    assert wheels.margin(bounds, ends).min() == pytest.approx(0, abs=1e-15)
    polytope = wheels.torque_envelope(PYRAMID, 0.1, momenta, 1.0, 1.0, 0.05)
    for direction in np.random.default_rng(2).normal(size=(30, 3)):
        assert (ends @ direction).max() == pytest.approx((polytope.vertices @ direction).max(), abs=1e-15)


def test_torques_in_another_unit_are_the_same() -> None:
    for unit in 2.0 ** np.arange(-325, 326, 65):
        found = wheels.torque_range([0.5 * unit, -unit], unit, 2 * unit, 0.2 * unit, unit)
        np.testing.assert_allclose(np.divide(found, unit), [[-1, -0.2], [0.4, 1]], rtol=1e-14)


# --- null motion


@pytest.mark.parametrize("axes", [PYRAMID, SIX, wheels.cone(0.8, 8), np.vstack([np.eye(3)[:2]] * 2)], ids=len)
def test_null_motions_cancel_and_are_all_there_are(axes: Array) -> None:
    found = wheels.null_motions(axes)
    assert len(found) == len(axes) - np.linalg.matrix_rank(axes)
    np.testing.assert_allclose(found @ axes, 0, atol=1e-15)
    np.testing.assert_allclose(found @ found.T, np.eye(len(found)), atol=1e-15)


def test_the_null_motion_of_four_wheels_is_that_of_the_triple_products() -> None:
    triples = [np.linalg.det(np.delete(PYRAMID, k, axis=0)) * (-1) ** k for k in range(4)]  # relations:11
    [found] = wheels.null_motions(PYRAMID)
    np.testing.assert_allclose(np.abs(found @ triples), np.linalg.norm(triples), rtol=1e-14)


def test_a_failed_wheel_takes_no_part_in_null_motion() -> None:
    assert wheels.null_motions(PYRAMID, [1, 1, 0, 1]).shape == (0, 4)
    assert (wheels.null_motions(SIX, [1, 1, 0, 1, 1, 1])[:, 2] == 0).all()


def clearance(momenta: Array, limits: float, best: float = 0.5) -> float:
    part = np.abs(momenta) / limits
    return float(np.minimum(part / best, (1 - part) / (1 - best)).min())


@pytest.mark.parametrize("axes", [PYRAMID, SIX], ids=len)
def test_no_null_motion_leads_to_clearer_momenta(axes: Array) -> None:
    rng = np.random.default_rng(3)
    motions = wheels.null_motions(axes)
    for best in (0.5, 0.3):
        momenta = rng.uniform(-0.5, 0.5, len(axes))
        found = wheels.clear_momenta(axes, momenta, 2.0, best)
        np.testing.assert_allclose(found.momenta @ axes, momenta @ axes, atol=1e-12)
        assert found.clearance == pytest.approx(clearance(found.momenta, 2.0, best))
        tried = momenta + rng.uniform(-2, 2, (20000, len(motions))) @ motions
        assert max(clearance(each, 2.0, best) for each in tried) <= found.clearance + 1e-9
        polished = minimize(
            lambda x, start=found.momenta, f=best: -clearance(start + x @ motions, 2.0, f),
            np.zeros(len(motions)),
            method="Nelder-Mead",
        )
        assert -polished.fun <= found.clearance + 1e-9


def test_clear_momenta_in_another_unit_are_the_same() -> None:
    expected = wheels.clear_momenta(PYRAMID, [0.1, 0.2, 0.3, 0.4], 2.0)
    for unit in 2.0 ** np.arange(-325, 326, 130):
        found = wheels.clear_momenta(PYRAMID, np.array([0.1, 0.2, 0.3, 0.4]) * unit, 2.0 * unit)
        np.testing.assert_allclose(found.momenta / unit, expected.momenta, atol=1e-9)


def test_steering_ends_at_the_clear_momenta_and_never_turns_the_body() -> None:
    momenta = np.array([0.0, 0.9, -0.2, 0.1])
    target = wheels.clear_momenta(PYRAMID, momenta, 1.0)
    total, step = momenta @ PYRAMID, 1.0
    for _ in range(400):
        torque = wheels.null_torque(PYRAMID, momenta, target.momenta, 0.01, gain=0.05)
        assert np.abs(torque).max() <= 0.01 * (1 + 1e-15)
        np.testing.assert_allclose(torque @ PYRAMID, 0, atol=1e-16)
        momenta = momenta + step * torque
    np.testing.assert_allclose(momenta, target.momenta, atol=1e-6)
    np.testing.assert_allclose(momenta @ PYRAMID, total, atol=1e-13)
    assert clearance(momenta, 1.0) > 0.2 > clearance(np.array([0.0, 0.9, -0.2, 0.1]), 1.0)


def test_many_momenta_are_steered_at_once() -> None:
    momenta = np.random.default_rng(4).uniform(-1, 1, (5, 7, 6))
    found = wheels.null_torque(SIX, momenta, np.ones(6), 0.1)
    np.testing.assert_allclose(found[2, 3], wheels.null_torque(SIX, momenta[2, 3], np.ones(6), 0.1), atol=1e-16)


# --- trades


def test_no_choice_on_the_front_is_beaten_and_every_other_one_is() -> None:
    costs = np.random.default_rng(5).integers(0, 6, (60, 3))
    front = wheels.pareto_front(costs)
    for k, mine in enumerate(costs):
        beaten = any((other <= mine).all() and (other < mine).any() for other in costs)
        assert front[k] == (not beaten)


def test_the_angles_of_a_trade_are_the_best_after_the_worst_failure() -> None:
    found = wheels.trade(BODY, TYPES, [4, 6], failed=1)
    for row in range(len(found.counts)):
        count, kind = int(found.counts[row]), TYPES[found.types[row]]
        grid = np.linspace(0.05, 1.5, 400)

        def worst(angle: float, count: int = count, momentum: float = kind.momentum) -> float:
            left = wheels.failures(wheels.cone(angle, count), momentum).half_spaces
            return float(wheels.guaranteed_rate(left, BODY).min())

        assert worst(found.angles[row]) == pytest.approx(found.rates[row, 1], rel=1e-12)
        assert max(map(worst, grid)) <= found.rates[row, 1] * (1 + 1e-6)
        assert found.mass[row] == pytest.approx(count * kind.mass)
        assert found.accelerations[row] == pytest.approx(found.rates[row] / kind.momentum * kind.torque)


def test_three_wheels_bear_no_failure_and_six_bear_three_at_most() -> None:
    assert wheels.trade(BODY, TYPES[:1], [3]).rates.tolist()[0][1] == 0
    rates = wheels.trade(BODY, TYPES[:1], [6], failed=4).rates[0]
    assert (rates[:4] > 0).tolist() == [True] * 4
    assert rates[4] == 0


def test_a_cone_of_six_is_the_pyramid_turned_by_a_right_angle() -> None:
    found, expected = wheels.cone(0.8, 6), wheels.six_wheels(0.8)
    turned = Rotation.from_euler("z", -90, degrees=True).apply(found)
    pairs = np.abs(np.abs(turned @ expected.T) - 1) < 1e-14  # three of them the other way round
    assert pairs.sum() == 6


# --- exports

GIVEN: dict[str, Any] = {"limits": [0.02, 0.02, 0.03, 0.03], "torque": 0.002, "rotor_inertia": 3e-5}
STORED = np.array([0.001, -0.002, 0.003, 0.0])
TURN = Rotation.from_euler("zyx", [30, 20, 10], degrees=True)


def test_basilisk_gets_every_wheel_in_its_units(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[tuple[Any, ...]] = []

    class Factory:
        def create(self, kind: str, axis: list[float], **options: float) -> None:
            assert all(type(value) is float for value in (*axis, *options.values()))  # as Basilisk asks for
            made.append((kind, axis, options))

        def addToSpacecraft(self, tag: str, effector: object, sc: object) -> None:
            made.append((tag,))

    rw = SimpleNamespace(ReactionWheelStateEffector=lambda: "effector")
    simulation = SimpleNamespace(reactionWheelStateEffector=rw)
    utilities = SimpleNamespace(simIncludeRW=SimpleNamespace(rwFactory=Factory))
    for name, module in (("Basilisk", None), ("Basilisk.simulation", simulation), ("Basilisk.utilities", utilities)):
        monkeypatch.setitem(sys.modules, name, module or SimpleNamespace())  # type: ignore[arg-type]
    text = attitude.to_basilisk(PYRAMID, **GIVEN, momenta=STORED, orientation=TURN)
    assert ast.parse(text)
    scope: dict[str, Any] = {}
    exec(text, scope)
    spacecraft = SimpleNamespace(hub=SimpleNamespace())
    scope["add_wheels"](spacecraft, "rw")
    *created, (tag,) = made
    assert tag == "rw"
    for (kind, axis, options), e, limit, h in zip(created, PYRAMID, GIVEN["limits"], STORED, strict=True):
        assert kind == "custom"
        np.testing.assert_array_equal(axis, e)
        radians = 2 * np.pi / 60
        assert options["Js"] * options["Omega"] * radians == pytest.approx(h)
        assert options["Js"] * options["Omega_max"] * radians == pytest.approx(limit)
        assert options["u_max"] == 0.002
    np.testing.assert_allclose(np.ravel(spacecraft.hub.sigma_BNInit), TURN.as_mrp(), atol=1e-15)


def test_42_gets_a_block_for_each_wheel_and_the_scalar_last() -> None:
    lines = attitude.to_42(PYRAMID, **GIVEN, momenta=STORED, orientation=TURN).splitlines()
    values = [line.partition("!")[0].split() for line in lines if "!" in line]
    assert values[0] == ["4"]
    for k in range(4):
        block = [[float(word) for word in line] for line in values[1 + 8 * k : 9 + 8 * k]]
        assert block[0] == [STORED[k]]
        assert block[1] == PYRAMID[k].tolist()
        assert block[2:4] == [[0.002, GIVEN["limits"][k]], [3e-5]]
        assert block[4:] == [[0], [0], [0], [0]]
    np.testing.assert_allclose([float(word) for word in values[-1]], TURN.as_quat(canonical=True), atol=1e-15)


# --- pictures


def test_a_picture_that_can_be_turned_needs_plotly_and_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "plotly", None)
    with pytest.raises(ModuleNotFoundError, match=r"symcheck\[interactive\]"):
        wheels.interactive_envelope(wheels.envelope(np.eye(3)))


def test_a_picture_that_can_be_turned_has_all_edges_and_closed_faces() -> None:
    pytest.importorskip("plotly")
    whole, left = wheels.envelope(SIX), wheels.envelope(SIX, [0, 1, 1, 1, 1, 1])
    figure = wheels.interactive_envelope(whole, left, names={"V": whole.vertices[0]})
    assert [trace.type for trace in figure.data] == ["mesh3d", "scatter3d"] * 2 + ["scatter3d"]
    mesh, lines = figure.data[:2]
    assert len(lines.x) == 3 * whole.counts[1]
    sides = [tuple(sorted(pair)) for face in zip(mesh.i, mesh.j, mesh.k, strict=True) for pair in combinations(face, 2)]
    assert all(sides.count(side) == 2 for side in set(sides))
    assert len(wheels.interactive_axes(SIX).data) == 6


UNFIT: dict[str, tuple[Callable[[], Any], str]] = {
    "power without rotor": (lambda: wheels.torque_range([1.0], 1.0, power=1.0), "rotor_inertia.*given with a power"),
    "negative torque": (lambda: wheels.torque_range([1.0], -1.0), "torque = -1.*not be negative"),
    "best": (lambda: wheels.clear_momenta(PYRAMID, np.zeros(4), best=1.0), "best = 1.0.*between 0 and 1"),
    "many wheels": (lambda: wheels.clear_momenta(wheels.cone(0.7, 11), np.zeros(11)), "axes.*at most 10 wheels"),
    "several sets": (lambda: wheels.null_motions(wheels.cone([0.7, 0.8], 4)), "axes.*one set of wheels"),
    "target": (lambda: wheels.null_torque(PYRAMID, np.zeros(4), np.zeros(3), 1.0), r"target.*must be \(4\)"),
    "no type": (lambda: wheels.trade(BODY, []), "types.*one type"),
    "two wheels": (lambda: wheels.trade(BODY, TYPES, [2]), "counts = 2.*from 3"),
    "massless": (lambda: wheels.trade(BODY, [TYPES[0]._replace(mass=0.0)]), "mass of small = 0.*positive"),
    "flat cone": (lambda: wheels.cone(np.pi / 2, 4), "angle = .*between 0 and pi/2"),
    "momenta": (lambda: attitude.to_42(np.eye(3), 1.0, 1.0, 1.0, 2.0), r"momenta\[0\] = 2.*within the limits"),
    "orientations": (
        lambda: attitude.to_42(np.eye(3), 1.0, 1.0, 1.0, orientation=Rotation.identity(2)),
        "orientation.*one orientation",
    ),
    "rotors": (lambda: attitude.to_basilisk(np.eye(3), 1.0, 1.0, [1.0, 1.0]), "rotor_inertia.*one for each wheel"),
}


@pytest.mark.parametrize(("call", "words"), UNFIT.values(), ids=UNFIT)
def test_what_does_not_fit_is_named(call: Callable[[], Any], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        call()
