"""The optimal angles of Ignatov 2005, beyond the paper, by plain search."""

from __future__ import annotations

import math

import pytest

from symcheck.mechanics import zonotope
from symcheck.papers.ignatov2005 import envelopes

J = (1000.0, 1600.0, 800.0)


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
