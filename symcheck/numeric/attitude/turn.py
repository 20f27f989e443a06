"""A turn from rest to rest in time: what its wheels do, and where the body ends if it is flown with these torques.

Decision: all wheels keep one proportion through the turn, that of the least greatest load of their momenta. Reason: the
torques are then constant in each phase and what they add up to is the momenta, so that both keep within their limits at
every time. Where the torque limits are in proportion to the momentum limits no other torques are faster.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from symcheck.numeric.attitude.agility import turn_time
from symcheck.numeric.domain import Array, exact, not_negative, positive, principal_moments, real, require, whole
from symcheck.numeric.drawing import Figures, Panels, new_figure
from symcheck.numeric.wheels.allocation import allocate
from symcheck.numeric.wheels.sets import four_wheels, wheels_of

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation

TOLERANCE = 1e-10  # of the integration: far below what any sensor sees
PARALLEL = 1e-12  # of a torque: what allocation leaves of it across the wheels


class Turn(NamedTuple):
    """A turn of a body by its wheels at p times.

    Parameters
    ----------
    times
        Times from 0 to the end, s; shape (p,).
    angle
        Angle turned, rad; shape (p,).
    rate
        Angular rate, rad/s; shape (p,).
    momenta
        Momenta of the wheels, N m s; shape (p, n).
    torques
        Torques of the motors from each time to the next, N m; shape (p - 1, n).
    momentum_load
        Greatest part of a momentum limit that is used.
    torque_load
        Greatest part of a torque limit that is used.
    """

    times: Array
    angle: Array
    rate: Array
    momenta: Array
    torques: Array
    momentum_load: float
    torque_load: float


class Flight(NamedTuple):
    """A turn as the equations of motion have it.

    Parameters
    ----------
    rates
        Angular velocity in the body's principal axes, rad/s; shape (p, 3).
    quaternions
        Orientation relative to that at the beginning, scalar last; shape (p, 4).
    error
        Angle between the orientation at the end and the one that was to be reached, rad.
    residual_rate
        Angular rate at the end, rad/s.
    """

    rates: Array
    quaternions: Array
    error: float
    residual_rate: float


def turn(
    axes: ArrayLike,
    moments: ArrayLike,
    direction: ArrayLike,
    angle: float,
    *,
    momentum: ArrayLike = 1.0,
    torque: ArrayLike = 1.0,
    points: int = 101,
) -> Turn:
    """The fastest turn about an axis with wheels that keep one proportion: it speeds up, coasts, and slows down.

    Parameters
    ----------
    axes
        Unit vectors e_i along the axes of the wheels; shape (n, 3).
    moments
        Principal moments of inertia of the body, kg m^2; shape (3,).
    direction
        Axis of the turn, of any length but 0; shape (3,).
    angle
        Angle of the turn, rad, positive.
    momentum
        Largest momenta of the wheels, N m s; a number or shape (n,). A wheel that has failed has 0.
    torque
        Largest torques of the wheels, N m; a number or shape (n,).
    points
        Least number of times, 3 or more; those at which the torque changes are added.

    Returns
    -------
    Turn
        Times, angle, rate, and what the wheels do. They are at rest before and after.

    Raises
    ------
    ValueError
        If an argument does not fit, or the wheels that are left cannot turn the body about this axis.

    Notes
    -----
    Source: ignatov2005:2.3, relations:2; the momenta are those of `wheels.allocate`.

    Examples
    --------
    >>> found = turn(np.eye(3), [8, 9, 10], [1, 0, 0], 1.0, momentum=4.0, torque=0.2)
    >>> found.times[-1].round(6), found.angle[-1].round(12), found.torques[0].round(12).tolist()
    (np.float64(12.649111), np.float64(1.0), [-0.2, 0.0, 0.0])
    """
    limits, gains = wheels_of(axes, momentum).limits, wheels_of(axes, torque).limits
    inertia, vector = exact("moments", principal_moments(moments), (3,)), exact("direction", direction, (3,))
    require(bool(np.any(vector)), "direction", vector, "not be zero")
    whole_angle = float(exact("angle", positive("angle", angle), ()))
    unit = vector / np.abs(vector).max()
    unit = unit / np.linalg.norm(unit)
    share = allocate(axes, -inertia * unit, np.where(gains > 0, limits, 0)).momenta  # for the rate 1
    works = np.abs(share) > PARALLEL * np.abs(share).max()
    fastest = float((limits[works] / np.abs(share[works])).min())
    faster = float((gains[works] / np.abs(share[works])).min())
    end = float(turn_time(whole_angle, fastest, faster))
    top = min(fastest, np.sqrt(whole_angle * faster))
    ramp = top / faster
    times = np.unique(np.concatenate([np.linspace(0, end, whole("points", points, 3)), [ramp, end - ramp]]))
    left = np.minimum(times, end - times)
    rate = np.minimum(top, faster * left)
    half = np.where(left < ramp, faster * left**2 / 2, top * (left - ramp / 2))
    turned = np.where(times <= end / 2, half, whole_angle - half)
    momenta = rate[:, None] * share
    torques = np.diff(momenta, axis=0) / np.diff(times)[:, None]
    loads = [np.abs(each[:, works] / most[works]).max() for each, most in ((momenta, limits), (torques, gains))]
    return Turn(times, turned, rate, momenta, torques, float(loads[0]), float(loads[1]))


def fly(found: Turn, axes: ArrayLike, moments: ArrayLike, direction: ArrayLike, rate: ArrayLike = (0, 0, 0)) -> Flight:
    """What a body really does under the torques of a turn: Euler's equations with wheels, integrated.

    Parameters
    ----------
    found
        The turn, whose torques are applied.
    axes, moments, direction
        As they were given to `turn`.
    rate
        Angular velocity at the beginning, rad/s; shape (3,). By default the body is at rest.

    Returns
    -------
    Flight
        Rates, orientations, and the error at the end.

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.

    Notes
    -----
    J dw/dt = -w x (J w + h_1 e_1 + ... + h_n e_n) - u_1 e_1 - ... - u_n e_n, and the kinematics of the quaternion, by
    SciPy's DOP853 to 1e-10 from each time to the next. Nothing is fed back: an error of the plan would be seen. Source:
    mirer2009:1.1 with the momenta of the wheels.

    Examples
    --------
    >>> made = turn(np.eye(3), [8, 9, 10], [1, 2, 3], 1.0, momentum=4.0, torque=0.2)
    >>> fly(made, np.eye(3), [8, 9, 10], [1, 2, 3]).error < 1e-8
    True
    """
    from scipy.integrate import solve_ivp
    from scipy.spatial.transform import Rotation

    units, inertia = wheels_of(axes).axes, exact("moments", principal_moments(moments), (3,))
    start, vector = exact("rate", rate, (3,)), exact("direction", direction, (3,))
    require(np.shape(found.momenta)[1:] == units.shape[:1], "found", np.shape(found.momenta), "be of these wheels")
    state = np.concatenate([start, [0.0, 0.0, 0.0, 1.0]])
    states = [state]
    for begin, end, momenta, torques in zip(
        found.times[:-1], found.times[1:], found.momenta[:-1], found.torques, strict=True
    ):
        stored, given = momenta @ units, torques @ units

        def change(t: float, y: Array, t0: float = begin, h0: Array = stored, u: Array = given) -> Array:
            w, vector_part, scalar = y[:3], y[3:6], y[6]
            gained = -np.cross(w, inertia * w + h0 + (t - t0) * u) - u
            turned = (scalar * w + np.cross(vector_part, w)) / 2
            return np.concatenate([gained / inertia, turned, [-(vector_part @ w) / 2]])

        scale = np.abs(state[:3]).max() + np.abs(given / inertia).max() * (end - begin)
        bounds = np.concatenate([np.full(3, TOLERANCE * scale + np.finfo(float).tiny), np.full(4, TOLERANCE)])
        state = solve_ivp(change, (begin, end), state, "DOP853", rtol=TOLERANCE, atol=bounds).y[:, -1]
        states.append(state)
    rates, quaternions = np.array(states)[:, :3], np.array(states)[:, 3:]
    quaternions = quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)
    wanted: Rotation = Rotation.from_rotvec(found.angle[-1] * vector / np.linalg.norm(vector))
    error = float((Rotation.from_quat(quaternions[-1]) * wanted.inv()).magnitude())
    return Flight(rates, quaternions, error, float(np.linalg.norm(rates[-1])))


def plot_turn(found: Turn, axes: Panels | None = None) -> Panels:
    """Draw a turn: the angle and the rate, the momenta of the wheels, and their torques.

    Parameters
    ----------
    found
        The turn.
    axes
        Three Axes to draw in; by default those of a new figure.

    Returns
    -------
    ndarray
        Three Axes.

    Raises
    ------
    ValueError
        If the times are not increasing numbers.

    Examples
    --------
    >>> made = turn(np.eye(3), [8, 9, 10], [1, 2, 3], 1.0, momentum=4.0, torque=0.2)
    >>> [ax.get_ylabel() for ax in plot_turn(made)]
    ['angle, deg', 'momenta, N m s', 'torques, N m']
    """
    times = not_negative("times", real("times", found.times, (None,)))
    require(bool((np.diff(times) > 0).all()), "times", times, "increase")
    panels: Panels = new_figure((7, 7)).subplots(3, sharex=True) if axes is None else np.asarray(axes)
    upper, middle, lower = panels
    upper.plot(times, np.degrees(found.angle), color="black", label="angle")
    other = upper.twinx()
    other.plot(times, np.degrees(found.rate), color="tab:red", label="rate")
    other.set_ylabel("rate, deg/s", color="tab:red")
    for number, momenta in enumerate(found.momenta.T, 1):
        middle.plot(times, momenta, label=f"wheel {number}")
    for torques in found.torques.T:
        lower.step(times, np.append(torques, torques[-1]), where="post")
    middle.legend(loc="best", fontsize=8)
    upper.set_ylabel("angle, deg")
    middle.set_ylabel("momenta, N m s")
    lower.set(xlabel="time, s", ylabel="torques, N m")
    return panels


def _of_a_small_satellite() -> Panels:
    """A turn by a right angle of a small satellite one of whose four wheels has failed."""
    wheels, working = four_wheels(1.0, np.pi / 4), np.array([1.0, 0.0, 1.0, 1.0])
    body, momentum, torque = [0.036, 0.036, 0.007], 0.02 * working, 0.002 * working
    return plot_turn(turn(wheels, body, [1, 0, 1], np.pi / 2, momentum=momentum, torque=torque))


FIGURES: Figures = {"attitude-turn-after-a-failure": _of_a_small_satellite}
