"""Torque envelopes: what wheels can give now, at the momenta that they have.

The torque u_i of a motor changes the momentum of its wheel, so that u_1 e_1 + ... + u_n e_n is the rate of change of
their total momentum, and its opposite acts on the body. At rest the envelope is the zonotope of the torque limits, that
of `half_spaces(axes, torque)`. At speed a motor accelerates its wheel with less: with what its power allows, and with
nothing once the wheel is at its limit. It brakes with all of its torque.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from symcheck.numeric.arrays import results
from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import Array, moderate, momentum, not_negative, positive, require
from symcheck.numeric.wheels import polytope
from symcheck.numeric.wheels.faces import HalfSpaces, half_spaces, pairs_when_complete
from symcheck.numeric.wheels.polytope import Envelope


class TorqueRange(NamedTuple):
    """The torques between which motors are free, each of shape (..., n), N m.

    Parameters
    ----------
    least
        Least torques, not positive.
    greatest
        Greatest torques, not negative.
    """

    least: Array
    greatest: Array


@gufunc("(n),(n),(n),(n),(n)->(n),(n)")
def torque_range(
    momenta: ArrayLike,
    torque: ArrayLike,
    limits: ArrayLike | None = None,
    power: ArrayLike | None = None,
    rotor_inertia: ArrayLike | None = None,
) -> TorqueRange:
    """The torques that motors give at the momenta of their wheels.

    Parameters
    ----------
    momenta
        Momenta h_i of the wheels, N m s; shape (..., n). Their speeds are h_i/J_i.
    torque
        Largest torques of the motors, N m; a number or shape (..., n). A wheel that has failed has 0.
    limits
        Largest momenta, N m s; a number or shape (..., n), by default none. A wheel at its limit is braked only.
    power
        Largest mechanical powers P_i with which motors accelerate, W; a number or shape (..., n). By default there are
        none.
    rotor_inertia
        Moments of inertia J_i of the rotors about their axes, kg m^2; a number or shape (..., n). It is needed with a
        power only.

    Returns
    -------
    TorqueRange
        Least and greatest torques. The one that accelerates is at most P_i J_i/|h_i|.

    Raises
    ------
    ValueError
        If an argument is negative or does not fit, or a power is given without the rotors.

    Notes
    -----
    Losses count as power: friction and the resistance of the windings are not in it. Source: mechanical power is torque
    times speed.

    Examples
    --------
    >>> found = torque_range([0.0, 2.0, -4.0], 0.1, limits=4.0, power=5.0, rotor_inertia=0.02)
    >>> found.least.tolist(), found.greatest.tolist()
    ([-0.1, -0.1, -0.0], [0.1, 0.05, 0.1])
    """
    require(power is None or rotor_inertia is not None, "rotor_inertia", rotor_inertia, "be given with a power")
    stored = momentum("momenta", momenta, (None,))
    most = moderate("torque", not_negative("torque", torque))
    speeding = most
    with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
        if power is not None and rotor_inertia is not None:
            rotor = positive("rotor_inertia", rotor_inertia)
            strongest = _product_over(not_negative("power", power), rotor, np.abs(stored))
            speeding = np.where(stored == 0, most, np.minimum(most, strongest))
    if limits is not None:
        speeding = np.where(np.abs(stored) >= not_negative("limits", limits), 0.0, speeding)
    braking = most + 0 * stored
    least, greatest = np.where(stored < 0, speeding, braking), np.where(stored > 0, speeding, braking)
    if limits is not None:  # a wheel without room is at both of its limits
        none = not_negative("limits", limits) == 0
        least, greatest = np.where(none, 0.0, least), np.where(none, 0.0, greatest)
    return TorqueRange(*results(-least, greatest))


def _product_over(x: Array, y: Array, z: Array) -> Array:
    """x y/z, which is a double where x y or y/z is none."""
    (x, p), (y, q), (z, r) = map(np.frexp, (x, y, z))
    return np.asarray(np.ldexp(x * y / z, p + q - r))


@gufunc("(n,axis),(n),(n),(n),(n),(n)->(pair,axis),(pair),(axis)", pair=pairs_when_complete)
def torque_half_spaces(
    axes: ArrayLike,
    momenta: ArrayLike,
    torque: ArrayLike,
    limits: ArrayLike | None = None,
    power: ArrayLike | None = None,
    rotor_inertia: ArrayLike | None = None,
) -> HalfSpaces:
    """The half-spaces of the torque envelope at the momenta of the wheels, for `margin`, `largest_momentum` and others.

    Parameters
    ----------
    axes
        Unit vectors e_i; shape (..., n, 3).
    momenta, torque, limits, power, rotor_inertia
        As for `torque_range`.

    Returns
    -------
    HalfSpaces
        Normals (..., p, 3), distances (..., p) in N m, centre (..., 3) in N m, with p = (n + 3)(n + 2)/2: they are
        complete, as wheels at their limits may leave a flat envelope.

    Raises
    ------
    ValueError
        As `torque_range` and `wheels_of` do.

    Notes
    -----
    Where motors accelerate with less than they brake with, the envelope is not symmetric about 0 but about its centre.
    `largest_momentum` of it is the largest torque in a direction. Source: (2.1) for torques.

    Examples
    --------
    >>> from symcheck.numeric.wheels import largest_momentum
    >>> found = torque_half_spaces(np.eye(3), [4.0, 0.0, -4.0], 0.1, limits=4.0)
    >>> largest_momentum(found, [[1, 0, 0], [-1, 0, 0], [0, 1, 0]]).round(12).tolist()
    [0.0, 0.1, 0.1]
    """
    least, greatest = torque_range(momenta, torque, limits, power, rotor_inertia)
    return half_spaces(axes, greatest / 2 - least / 2, greatest / 2 + least / 2, complete=True)


def torque_envelope(
    axes: ArrayLike,
    torque: ArrayLike,
    momenta: ArrayLike = 0.0,
    limits: ArrayLike | None = None,
    power: ArrayLike | None = None,
    rotor_inertia: ArrayLike | None = None,
) -> Envelope:
    """The torque envelope of one set of wheels as a polytope: its vertices, edges and faces.

    Parameters
    ----------
    axes
        Unit vectors e_i; shape (n, 3).
    torque
        Largest torques of the motors, N m; a number or shape (n,).
    momenta
        Momenta h_i of the wheels, N m s; a number or shape (n,). By default they are at rest.
    limits, power, rotor_inertia
        As for `torque_range`.

    Returns
    -------
    Envelope
        Vertices in N m; `plot_envelope` draws it.

    Raises
    ------
    ValueError
        As `torque_range` and `envelope` do.

    Notes
    -----
    Source: (2.1) for torques.

    Examples
    --------
    >>> torque_envelope(np.eye(3), 0.1).vertices.max(axis=0).tolist()
    [0.1, 0.1, 0.1]
    >>> torque_envelope(np.eye(3), 0.1, [4.0, 0.0, 0.0], limits=4.0).vertices[:, 0].max().round(12)
    np.float64(0.0)
    """
    count = np.shape(axes)[0] if np.ndim(axes) else 0
    least, greatest = torque_range(np.broadcast_to(momenta, (count,)), torque, limits, power, rotor_inertia)
    return polytope.envelope(axes, greatest / 2 - least / 2, greatest / 2 + least / 2)
