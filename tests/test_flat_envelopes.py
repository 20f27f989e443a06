"""Margins of envelopes in a plane or a line are those of each alone, however many are asked for at once."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from symcheck.numeric import wheels
from symcheck.numeric.domain import Array
from symcheck.numeric.wheels.margins import BLOCK

MANY = BLOCK + 1  # so many points leave room for one half-space at a time
PLANE = np.array([[1, 0, 0], [0.6, 0.8, 0]])


def two_of_four_failed() -> wheels.HalfSpaces:
    return wheels.half_spaces(wheels.four_wheels(1.0, 0.6), [1, 1, 0, 0])


def coplanar() -> wheels.HalfSpaces:
    return wheels.half_spaces(PLANE, [1, 2], complete=True)


def one_wheel() -> wheels.HalfSpaces:
    return wheels.half_spaces(PLANE[1:], 3.0, complete=True)


def turned(bounds: Callable[[], wheels.HalfSpaces]) -> tuple[wheels.HalfSpaces, Array]:
    """The envelope in some orientation, where nothing is exactly zero, and an orthonormal frame that turns with it."""
    frame = np.linalg.qr(np.random.default_rng(17).normal(size=(3, 3)))[0]
    normals, distances, centre = bounds()
    return wheels.HalfSpaces(normals @ frame.T, distances, centre), frame


def in_the_plane(bounds: wheels.HalfSpaces) -> Array:
    """Directions in the plane or line of a flat envelope, and one out of it."""
    across = bounds.normals[np.isfinite(bounds.distances) & (bounds.distances < 1e-12)]
    _, values, rows = np.linalg.svd(across)
    flat = rows[np.count_nonzero(values > 1e-9) :]
    angle = np.linspace(0, 6, 7)[:, None]
    return np.vstack([np.cos(angle) * flat[0] + np.sin(angle) * flat[-1], rows[:1]])


flat = pytest.mark.parametrize("envelope", [two_of_four_failed, coplanar, one_wheel])


@flat
def test_the_largest_momenta_of_many_directions_are_those_of_each_alone(envelope: Any) -> None:
    bounds, _ = turned(envelope)
    directions = in_the_plane(bounds)
    alone = np.array([wheels.largest_momentum(bounds, each) for each in directions])
    assert alone[:-1].min() > 0.4
    assert alone[-1] == pytest.approx(0, abs=1e-12)
    many = wheels.largest_momentum(bounds, np.resize(directions, (MANY, 3)))
    np.testing.assert_allclose(many, np.resize(alone, MANY), rtol=1e-12, atol=1e-15)


@flat
def test_the_largest_momenta_of_many_envelopes_are_those_of_each_alone(envelope: Any) -> None:
    bounds, _ = turned(envelope)
    direction = in_the_plane(bounds)[1]
    shape = (MANY, *bounds.normals.shape)
    many = wheels.HalfSpaces(
        np.broadcast_to(bounds.normals, shape), np.broadcast_to(bounds.distances, shape[:-1]), np.zeros(3)
    )
    alone = wheels.largest_momentum(bounds, direction)
    np.testing.assert_allclose(wheels.largest_momentum(many, direction), alone, rtol=1e-12)


@flat
def test_the_scales_of_many_flat_ellipsoids_are_those_of_each_alone(envelope: Any) -> None:
    bounds, _ = turned(envelope)
    along = in_the_plane(bounds)
    first = along[1] / np.linalg.norm(along[1])
    frame = np.linalg.qr(np.column_stack([first, np.eye(3)]))[0].T
    semi_axes = np.array([[1.0, 0, 0], [0.25, 0, 0]])
    alone = np.array([wheels.ellipsoid_scale(bounds, each, frame) for each in semi_axes])
    assert alone[1] == pytest.approx(4 * alone[0])
    assert alone[0] == pytest.approx(float(wheels.largest_momentum(bounds, first)))
    many = wheels.ellipsoid_scale(bounds, np.resize(semi_axes, (MANY, 3)), frame)
    np.testing.assert_allclose(many, np.resize(alone, MANY), rtol=1e-12)
    solid = wheels.ellipsoid_scale(bounds, np.ones((MANY, 3)), frame)
    np.testing.assert_allclose(solid, 0, atol=1e-12)


def test_an_ellipsoid_that_is_a_point_grows_without_end_also_among_many() -> None:
    bounds, frame = turned(coplanar)
    assert np.isinf(wheels.ellipsoid_scale(bounds, np.zeros((MANY, 3)), frame)).all()


def test_an_envelope_far_away_does_not_loosen_what_is_asked_of_another() -> None:
    eye = wheels.half_spaces(np.eye(3), [1, 1, 1], bias=[[1e12, 0, 0], [1.01, 0, 0]])
    near = wheels.HalfSpaces(eye.normals, np.array([[2e12] * 3, [1.0] * 3]), eye.centre)
    with pytest.raises(ValueError, match="margin of the origin"):
        wheels.largest_momentum(near, [1, 0, 0])
