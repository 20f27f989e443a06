"""From a body's moments of inertia to an arrangement of its wheels, and what that arrangement is worth."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from symcheck.generated import ignatov2005
from symcheck.numeric.arrays import letters
from symcheck.numeric.domain import Array, moments_of_a_mass, not_negative, one_of, principal_moments
from symcheck.numeric.wheels.angles import (
    best_angle_of_six_wheels,
    best_angles_of_four_wheels,
    equal_rates_of_four_wheels,
    equal_rates_of_six_wheels,
)
from symcheck.numeric.wheels.faces import failures, half_spaces
from symcheck.numeric.wheels.margins import ellipsoid_margin, guaranteed_rate
from symcheck.numeric.wheels.sets import four_wheels, six_wheels


class Arrangement(NamedTuple):
    """Wheels with their angles for a body, and what rates they give it; n wheels with k angles.

    Parameters
    ----------
    angles
        Angles a and b of four wheels, a of six, rad; shape (..., k).
    axes
        Axes of the wheels; shape (..., n, 3).
    largest_rates
        Largest rates about OX, OY and OZ alone, rad/s; shape (..., 3).
    guaranteed_rate
        Largest rate that is reached about every axis, rad/s; shape (...).
    margin
        Margin of the required ellipsoid (1.2), N m s; shape (...). Condition (1.1) holds if it is not negative.
    rate_after_failure
        Guaranteed rate after the failure of each wheel, rad/s; shape (..., n).
    margin_after_failure
        Margin after the failure of each wheel, N m s; shape (..., n).
    """

    angles: Array
    axes: Array
    largest_rates: Array
    guaranteed_rate: Array
    margin: Array
    rate_after_failure: Array
    margin_after_failure: Array


class Design(NamedTuple):
    """The paper's two configurations for one body.

    Parameters
    ----------
    four
        The four-sided pyramid.
    six
        The six-sided pyramid.
    """

    four: Arrangement
    six: Arrangement


Choice = tuple[Callable[[ArrayLike], Array], Callable[[ArrayLike], Array]]
CHOICES: dict[str, Choice] = {
    "every axis": (best_angles_of_four_wheels, best_angle_of_six_wheels),
    "principal axes": (equal_rates_of_four_wheels, equal_rates_of_six_wheels),
}


def design(
    moments: ArrayLike, required_rates: ArrayLike, limit: ArrayLike = 1.0, *, rates_about: str = "every axis"
) -> Design:
    """The paper's two configurations for a body, with their angles, rates and margins, with all wheels and without one.

    Parameters
    ----------
    moments
        Principal moments of inertia J_x, J_y, J_z, kg m^2; shape (..., 3).
    required_rates
        Rates w_x, w_y, w_z of the ellipsoid (1.2), rad/s; shape (..., 3).
    limit
        Largest momentum h_max of every wheel, N m s; shape (...).
    rates_about
        What the angles maximise: the rate about "every axis", or equal rates about the "principal axes".

    Returns
    -------
    Design
        The four and the six wheels.

    Raises
    ------
    ValueError
        If the moments are not those of a body, rates or the limit are negative, or the choice is another.

    Notes
    -----
    Source: (1.1), (1.2), sections 2.3 and 3.3.

    Examples
    --------
    >>> found = design([1000, 1600, 800], [0.005, 0.005, 0.005], limit=5)
    >>> found.four.margin.round(3), found.six.margin.round(3)
    (np.float64(2.035), np.float64(6.325))
    >>> found.six.rate_after_failure.round(5)
    array([0.00625, 0.0075 , 0.0075 , 0.00625, 0.0075 , 0.0075 ])
    """
    inertia, rate = principal_moments(moments), not_negative("required_rates", required_rates, "(1.2)", (3,))
    momentum = not_negative("limit", limit, "(2.1)")
    moments_of_a_mass(inertia)
    one_of("rates_about", rates_about, CHOICES)
    four, six = (choose(inertia) for choose in CHOICES[rates_about])
    return Design(
        _arrangement(
            four,
            four_wheels(four[..., 0], four[..., 1]),
            ignatov2005.largest_rates_of_four_wheels(*letters(four), *letters(inertia)),
            inertia,
            rate,
            momentum,
        ),
        _arrangement(
            six,
            six_wheels(six[..., 0]),
            ignatov2005.largest_rates_of_six_wheels(*letters(six), *letters(inertia)),
            inertia,
            rate,
            momentum,
        ),
    )


def _arrangement(
    angles: Array, axes: Array, rates: Sequence[Array], inertia: Array, rate: Array, limit: Array
) -> Arrangement:
    limits = np.broadcast_to(limit[..., None], (*limit.shape, axes.shape[-2]))
    whole, left = half_spaces(axes, limits), failures(axes, limits).half_spaces
    largest = np.stack(rates, axis=-1) * limit[..., None]
    of_each_case = inertia[..., None, :]
    return Arrangement(
        angles,
        axes,
        largest,
        guaranteed_rate(whole, inertia),
        ellipsoid_margin(whole, inertia * rate),
        guaranteed_rate(left, of_each_case),
        ellipsoid_margin(left, of_each_case * rate[..., None, :]),
    )
