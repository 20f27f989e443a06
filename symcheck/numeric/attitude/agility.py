"""How fast wheels turn a body about an axis, and how long a turn from rest to rest takes.

The total momentum is zero, so that the body turns with J w = -H about an axis that keeps its direction in the body and
in space: no gyroscopic torque acts, whatever the axis is. The rate about u is bounded by the momentum envelope along
J u, the acceleration by the torque envelope along it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import (
    Array,
    common_shape,
    evaluated,
    moderate,
    not_negative,
    power_of_two,
    principal_moments,
    real,
    require,
)
from symcheck.numeric.relations import kernels_of_relations
from symcheck.numeric.wheels.faces import HalfSpaces, failures
from symcheck.numeric.wheels.margins import largest_momentum

SLOW = 2.0**-900  # a rate, rad/s


class Agility(NamedTuple):
    """How a body turns about an axis; each of shape (...).

    Parameters
    ----------
    rate
        Largest angular rate, rad/s.
    acceleration
        Largest angular acceleration, rad/s^2.
    time
        Shortest time of a turn from rest to rest, s; infinite if the wheels cannot make it.
    """

    rate: Array
    acceleration: Array
    time: Array


class AgilityAfterFailures(NamedTuple):
    """How a body turns when some of its wheels have failed.

    Parameters
    ----------
    wheels
        The k wheels that have failed, counted from 0, in each of the f cases; shape (f, k).
    agility
        What is left, each of shape (f, ...).
    """

    wheels: NDArray[np.intp]
    agility: Agility


@gufunc("(),(),()->()")
def turn_time(angle: ArrayLike, rate: ArrayLike, acceleration: ArrayLike) -> Array:
    """The shortest time of a turn from rest to rest, angle/w + w/acceleration, w = min(rate, sqrt(angle acceleration)).

    Parameters
    ----------
    angle
        Angle of the turn, rad; shape (...), not negative.
    rate
        Largest angular rate, rad/s; shape (...), not negative.
    acceleration
        Largest angular acceleration, and deceleration, rad/s^2; shape (...), not negative.

    Returns
    -------
    ndarray
        Time, s; shape (...). It is 0 for no angle, and infinite for another angle without rate or acceleration.

    Raises
    ------
    ValueError
        If an argument is negative, or the time leaves the range of doubles.

    Notes
    -----
    The body coasts if it reaches the rate before half of the angle. Source: relations:2; that nothing is shorter,
    relations:3.

    Examples
    --------
    >>> turn_time(1.0, [0.5, 2.0], 1.0).tolist()  # with and without a time of coasting
    [2.5, 2.0]
    """
    values = [not_negative(*pair) for pair in (("angle", angle), ("rate", rate), ("acceleration", acceleration))]
    shape = common_shape(angle=values[0], rate=values[1], acceleration=values[2])
    turn, fastest, faster = (np.broadcast_to(value, shape) for value in values)
    moves = (turn > 0) & (fastest > 0) & (faster > 0)
    some, most, gain = (np.where(moves, value, 1.0) for value in (turn, fastest, faster))
    unit = np.where(np.sqrt(some) * np.sqrt(gain) < SLOW, 1 / SLOW, 1.0)  # of angles: no rate then is a denormal
    with np.errstate(over="ignore"):
        some, most, gain = some * unit, most * unit, gain * unit
    way = np.minimum(most, np.sqrt(some) * np.sqrt(gain))
    time = evaluated("the time of a turn", kernels_of_relations.time_of_a_turn, some, way, gain)
    return np.where(moves, time, np.where(turn > 0, np.inf, 0.0))


@gufunc("(p,axis),(p),(axis),(p,axis),(p),(axis),(axis),(axis),()->(),(),()")
def agility(
    momentum: HalfSpaces, torque: HalfSpaces, moments: ArrayLike, direction: ArrayLike, angle: ArrayLike = np.pi
) -> Agility:
    """The largest rate and acceleration about an axis, and the shortest time of a turn about it.

    Parameters
    ----------
    momentum
        Half-spaces of the momentum envelope, N m s, as `wheels.half_spaces(axes, momentum_limits)` gives them.
    torque
        Half-spaces of the torque envelope, N m, as `wheels.half_spaces(axes, torque_limits)` gives them.
    moments
        Principal moments of inertia, kg m^2; shape (..., 3).
    direction
        Axis of the turn, of any length but 0; shape (..., 3).
    angle
        Angle of the turn, rad; shape (...), not negative.

    Returns
    -------
    Agility
        Rate, acceleration and time.

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.

    Notes
    -----
    With biased envelopes it is what is reached from the bias, for the less favourable sense of the turn. Source:
    ignatov2005:2.3 for the rates, relations:2 for the time.

    Examples
    --------
    >>> from symcheck.numeric.wheels import half_spaces
    >>> agility(half_spaces(np.eye(3), 4.0), half_spaces(np.eye(3), 0.2), [8, 9, 10], [1, 0, 0], 1.0)
    Agility(rate=array(0.5), acceleration=array(0.025), time=array(12.64911064))
    """
    along = _along(moments, direction)
    length = np.linalg.norm(along, axis=-1)
    fastest, faster = (
        np.minimum(largest_momentum(bounds, along), largest_momentum(bounds, -along)) for bounds in (momentum, torque)
    )
    rate = moderate("the rate", np.asarray(fastest / length))
    acceleration = moderate("the acceleration", np.asarray(faster / length))
    return Agility(*map(np.array, np.broadcast_arrays(rate, acceleration, turn_time(angle, rate, acceleration))))


def agility_after_failures(
    axes: ArrayLike,
    moments: ArrayLike,
    direction: ArrayLike,
    angle: ArrayLike = np.pi,
    *,
    momentum: ArrayLike = 1.0,
    torque: ArrayLike = 1.0,
    count: int = 1,
) -> AgilityAfterFailures:
    """The agility that is left after every failure of `count` wheels at once.

    Parameters
    ----------
    axes
        Unit vectors e_i along the axes of the wheels; shape (n, 3).
    moments, direction, angle
        As for `agility`.
    momentum
        Largest momenta of the wheels, N m s; a number or shape (n,).
    torque
        Largest torques of the wheels, N m; a number or shape (n,).
    count
        Number of wheels that fail at once, from 0 to n.

    Returns
    -------
    AgilityAfterFailures
        The C(n, count) cases in lexicographic order.

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.

    Notes
    -----
    Where the wheels that are left lie in a plane, turns about other axes have the rate 0 and take infinitely long.
    Source: ignatov2005, sections 2.2 and 3.2; relations:2.

    Examples
    --------
    >>> found = agility_after_failures(np.eye(3), [8, 9, 10], [[1, 0, 0], [0, 1, 0]], 1.0, momentum=4, torque=0.2)
    >>> found.agility.rate.round(3).tolist()  # without wheel 0, 1, 2 in turn
    [[0.0, 0.444], [0.5, 0.0], [0.5, 0.444]]
    """
    stored = failures(axes, momentum, count=count)
    require(stored.half_spaces.distances.ndim == 2, "axes", np.shape(axes), "be one set of wheels, of the shape (n, 3)")
    driven = failures(axes, torque, count=count).half_spaces
    lead = np.broadcast_shapes(np.shape(moments)[:-1], np.shape(direction)[:-1], np.shape(angle))

    def apart(bounds: HalfSpaces) -> HalfSpaces:
        """With axes between the cases and the planes for those of the directions."""
        between = (slice(None), *(None,) * len(lead))
        return HalfSpaces(*(array[between] for array in bounds))

    return AgilityAfterFailures(
        stored.wheels, agility(apart(stored.half_spaces), apart(driven), moments, direction, angle)
    )


def _along(moments: ArrayLike, direction: ArrayLike) -> Array:
    """J u for the unit vector u."""
    vector = real("direction", direction, (3,))
    largest = np.abs(vector).max(axis=-1, keepdims=True, initial=0)
    require(largest[..., 0] > 0, "direction", vector, "not be zero")
    unit = vector / power_of_two(largest)  # first, as squares of it may leave the range of doubles
    return np.asarray(principal_moments(moments) * (unit / np.linalg.norm(unit, axis=-1, keepdims=True)))
