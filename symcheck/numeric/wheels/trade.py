"""Trade of mass, power and failures: arrays of 3 to 8 wheels, of the wheels that can be bought, for one body."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import Array, acute, exact, positive, principal_moments, real, require, whole
from symcheck.numeric.drawing import Figures, new_figure
from symcheck.numeric.wheels.faces import failures
from symcheck.numeric.wheels.margins import guaranteed_rate

if TYPE_CHECKING:
    from matplotlib.axes import Axes

NONE = 1e-12  # of a momentum of 1: what rounding gives to a flat envelope
STEPS = 90  # of the angle: one degree each
REFINEMENTS = 6  # of the step around the best angle, ten times finer each


class WheelType(NamedTuple):
    """A wheel as its data sheet describes it.

    Parameters
    ----------
    name
        Name, for the legend.
    momentum
        Largest momentum, N m s.
    torque
        Largest torque, N m.
    mass
        Mass, kg.
    power
        Power at the speed at which it is planned to run, W.
    """

    name: str
    momentum: float
    torque: float
    mass: float
    power: float


class Trade(NamedTuple):
    """Arrays of wheels for one body, one for each type and number of wheels; m of them.

    Parameters
    ----------
    types
        Number of the type of wheel in the list; shape (m,).
    counts
        Number of wheels; shape (m,).
    angles
        Angle between the axes of the wheels and OZ that is best for `failed` failures, rad; shape (m,).
    mass
        Mass of all wheels, kg; shape (m,).
    power
        Power of all wheels, W; shape (m,).
    rates
        Rate that is reached about every axis after 0, 1, ... failures, whichever wheels fail, rad/s; shape (m, k).
    accelerations
        The same of accelerations, rad/s^2; shape (m, k).
    front
        Whether no other array has no more mass and power, and no lesser rate after the failures; shape (m,).
    """

    types: NDArray[np.intp]
    counts: NDArray[np.intp]
    angles: Array
    mass: Array
    power: Array
    rates: Array
    accelerations: Array
    front: NDArray[np.bool_]


@gufunc("()->(n,axis)", n=lambda size: size["count"], axis=3)
def cone(angle: ArrayLike, count: int) -> Array:
    """The axes of wheels that stand evenly around OZ, the first in the plane OXZ.

    Parameters
    ----------
    angle
        Angle between the axes and OZ, rad; shape (...), 0 < angle < pi/2.
    count
        Number n of wheels.

    Returns
    -------
    ndarray
        Unit vectors e_i = (sin a cos(2 pi i/n), sin a sin(2 pi i/n), cos a), i = 0, ..., n - 1; shape (..., n, 3).

    Raises
    ------
    ValueError
        If the angle is outside its range, or the number of wheels is less than 1.

    Notes
    -----
    Three wheels with tg a = sqrt 2 are orthogonal. Six are those of `six_wheels` turned
    about OZ, three of them reversed. Source: the unit vectors before (3.1).

    Examples
    --------
    >>> axes = cone(np.arctan(np.sqrt(2)), 3)
    >>> np.abs(axes @ axes.T).round(12).tolist()
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    """
    number, tilt = whole("count", count, 1), acute("angle", angle)[..., None]
    around = 2 * np.pi * np.arange(number) / number
    parts = np.sin(tilt) * np.cos(around), np.sin(tilt) * np.sin(around), np.cos(tilt) + 0 * around
    return np.stack(parts, axis=-1)


def pareto_front(costs: ArrayLike) -> NDArray[np.bool_]:
    """Which of many choices no other one beats: none costs less in one respect and no more in all others.

    Parameters
    ----------
    costs
        Costs of m choices in k respects; shape (m, k). Of a gain take the opposite.

    Returns
    -------
    ndarray
        Whether a choice is on the front; shape (m,). Choices with the same costs are on it together.

    Raises
    ------
    ValueError
        If the costs are not finite numbers of this shape.

    Notes
    -----
    Every pair is compared, m^2 k operations.

    Examples
    --------
    >>> pareto_front([[1, 5], [2, 2], [3, 3], [5, 1]]).tolist()
    [True, True, False, True]
    """
    array = exact("costs", costs, (None, None))
    no_more = (array[:, None] <= array[None]).all(axis=-1)
    return np.asarray(~(no_more & ~no_more.T).any(axis=0))


def trade(
    moments: ArrayLike, types: Sequence[WheelType], counts: Sequence[int] = (3, 4, 5, 6, 7, 8), *, failed: int = 1
) -> Trade:
    """Mass, power, rates and accelerations of cones of wheels, each at its best angle, and which are worth a look.

    Parameters
    ----------
    moments
        Principal moments of inertia J_x, J_y, J_z, kg m^2; shape (3,).
    types
        The wheels that can be had.
    counts
        Numbers of wheels, 3 or more.
    failed
        The number of failures that the design has to bear: the angles are best after the worst such failure, and the
        front is that of mass, power and the rate then.

    Returns
    -------
    Trade
        The arrays, those of the first type first.

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.

    Notes
    -----
    The angle is the best of a grid of one degree, refined to 1e-8 rad; the worst failure changes along it, so that this
    is a search and no proof. Arrays that are left without a rate about some axis are on the front only if nothing
    lighter exists. Source: (1.1), (2.3), sections 2.2 and 3.2.

    Examples
    --------
    >>> small = WheelType("small", momentum=0.015, torque=0.002, mass=0.13, power=1.0)
    >>> found = trade([0.03, 0.03, 0.01], [small], [3, 4, 5])
    >>> found.mass.round(2).tolist(), (found.rates[:, 1] > 0).tolist()
    ([0.39, 0.52, 0.65], [False, True, True])
    """
    inertia = exact("moments", principal_moments(moments), (3,))
    listed = [_checked(wheel) for wheel in types]
    require(len(listed) > 0, "types", types, "name one type of wheel at least")
    numbers = [whole("counts", count, 3) for count in counts]
    require(len(numbers) > 0, "counts", counts, "have one number at least")
    number = whole("failed", failed, 0, min(numbers))
    angles = {count: _best_angle(count, inertia, number) for count in set(numbers)}
    unit = {count: [float(_worst(angles[count], count, inertia, k)) for k in range(number + 1)] for count in angles}
    rows = [(kind, count) for kind in range(len(listed)) for count in numbers]
    kinds, many = (np.array(column, np.intp) for column in zip(*rows, strict=True))
    momentum, torque, mass, power = (np.array([wheel[k] for wheel in listed])[kinds] for k in range(1, 5))
    of_one = np.array([unit[count] for _, count in rows])
    rates = momentum[:, None] * of_one
    total = [np.asarray(each * many, np.float64) for each in (mass, power)]
    front = pareto_front(np.column_stack([*total, -rates[:, -1]]))
    best = np.array([angles[count] for _, count in rows])
    return Trade(kinds, many, best, total[0], total[1], rates, torque[:, None] * of_one, front)


def plot_trade(found: Trade, types: Sequence[WheelType], required: float = 0.0, ax: Axes | None = None) -> Axes:
    """Draw the rate after the failures over the mass, a line for each type of wheel, with the Pareto front.

    Parameters
    ----------
    found
        What `trade` gives.
    types
        The types of wheels, as they were given to it.
    required
        The rate that is required, rad/s; drawn as a line if it is positive.
    ax
        Axes to draw in; by default those of a new figure.

    Returns
    -------
    Axes
        The Axes.

    Raises
    ------
    ValueError
        If the required rate is not a finite number.

    Notes
    -----
    Each point is marked with its number of wheels; those on the front are filled.

    Examples
    --------
    >>> small = WheelType("small", momentum=0.015, torque=0.002, mass=0.13, power=1.0)
    >>> plot_trade(trade([0.03, 0.03, 0.01], [small]), [small]).get_xlabel()
    'mass of the wheels, kg'
    """
    least = real("required", required)
    drawn: Axes = new_figure((7, 4.5)).subplots() if ax is None else ax
    after = found.rates.shape[1] - 1
    for kind, wheel in enumerate(types):
        own = found.types == kind
        mass, rate, front = found.mass[own], np.degrees(found.rates[own, -1]), found.front[own]
        [line] = drawn.plot(mass, rate, linewidth=0.8, linestyle=":", label=wheel.name)
        for filled in (True, False):
            shown = front == filled
            drawn.plot(mass[shown], rate[shown], "o", color=line.get_color(), fillstyle="full" if filled else "none")
        for place, count in zip(zip(mass, rate, strict=True), found.counts[own], strict=True):
            drawn.annotate(str(count), place, xytext=(4, 4), textcoords="offset points", fontsize=8)
    if least > 0:
        drawn.axhline(float(np.degrees(least)), color="0.4", linewidth=0.8, label="required")
    failures_ = "one failure" if after == 1 else f"{after} failures"
    drawn.set(xlabel="mass of the wheels, kg", ylabel=f"rate about every axis after {failures_}, deg/s")
    drawn.legend()
    return drawn


def _checked(wheel: WheelType) -> WheelType:
    name, *numbers = wheel
    fields = zip(WheelType._fields[1:], numbers, strict=True)
    return WheelType(name, *(float(positive(f"{field} of {name}", value)) for field, value in fields))


def _worst(angles: ArrayLike, count: int, inertia: Array, failed: int) -> Array:
    """The rate per unit of momentum about every axis after the worst failures, at angles of any shape."""
    left = failures(cone(angles, count), count=failed).half_spaces
    rates = guaranteed_rate(left, inertia).min(axis=-1)
    return np.where(rates > NONE / inertia.max(), rates, 0.0)


def _best_angle(count: int, inertia: Array, failed: int) -> float:
    step = np.pi / 2 / STEPS
    middle, reach = np.pi / 4, np.pi / 4 - step / 10
    for _ in range(REFINEMENTS):
        grid = np.clip(np.linspace(middle - reach, middle + reach, 2 * STEPS + 1), step / 10, np.pi / 2 - step / 10)
        middle = float(grid[int(_worst(grid, count, inertia, failed).argmax())])
        reach /= STEPS / 2
    return middle


def _small_satellite() -> Axes:
    """Rate after a failure over the mass of three to eight wheels of three sizes, for a small satellite."""
    types = [
        WheelType("10 mN m s", 0.010, 0.001, 0.12, 0.8),
        WheelType("20 mN m s", 0.020, 0.002, 0.15, 1.1),
        WheelType("50 mN m s", 0.050, 0.007, 0.24, 2.0),
    ]
    return plot_trade(trade([0.036, 0.036, 0.007], types), types, required=np.radians(20))


FIGURES: Figures = {"wheels-trade": _small_satellite}
