"""Null motion: momenta and torques of wheels that cancel, so that the body does not feel them.

With more than three wheels the momenta can be shared in many ways. Wheels that cross zero shake the body by friction,
and wheels near their limit leave no room; null motion takes them away from both.

Decision: the best momenta come from a linear program for each pattern of senses of rotation. Reason: with the senses
given the problem is linear, so that the best of all patterns is the best there is; n wheels have 2^n, and eight take a
second. It is not for: more than ten wheels, or a control loop.
"""

from __future__ import annotations

from itertools import product
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from symcheck.numeric.domain import Array, momentum, not_negative, number, positive, power_of_two, require
from symcheck.numeric.wheels.sets import Wheels, wheels_of

MOST = 10  # wheels: a thousand linear programs
DEPENDENT = 1e-12  # of the largest singular value: axes that depend on each other to rounding


class ClearMomenta(NamedTuple):
    """Momenta of wheels that are far from zero and from their limits.

    Parameters
    ----------
    momenta
        Momenta, N m s; shape (n,).
    clearance
        1 if all wheels are at their best place, 0 if one is at rest or at its limit, negative if it is beyond that.
    """

    momenta: Array
    clearance: float


def null_motions(axes: ArrayLike, limits: ArrayLike = 1.0) -> Array:
    """The momenta that cancel: orthonormal vectors z with z_1 e_1 + ... + z_n e_n = 0.

    Parameters
    ----------
    axes
        Unit vectors e_i; shape (n, 3).
    limits
        Largest momenta, N m s; a number or shape (n,). A wheel with 0 has failed and takes no part.

    Returns
    -------
    ndarray
        Vectors as rows; shape (d, n). For m wheels that work and span space d = m - 3.

    Raises
    ------
    ValueError
        For anything but one set of wheels.

    Notes
    -----
    For four wheels z is along ((e_2, e_3, e_4), -(e_1, e_3, e_4), (e_1, e_2, e_4), -(e_1, e_2, e_3)). Source: for four
    wheels relations:11.

    Examples
    --------
    >>> from symcheck.numeric.wheels import four_wheels
    >>> np.abs(null_motions(four_wheels(1.0, 0.7))).round(6).tolist()
    [[0.5, 0.5, 0.5, 0.5]]
    >>> null_motions(np.eye(3)).shape
    (0, 3)
    """
    wheels = _one_set(axes, limits)
    works = np.flatnonzero(wheels.limits > 0)
    _, values, rows = np.linalg.svd(wheels.axes[works].T)
    rank = int(np.count_nonzero(values > DEPENDENT * values.max(initial=0)))
    motions = np.zeros((len(works) - rank, len(wheels.limits)))
    motions[:, works] = rows[rank:]
    return motions


def null_torque(
    axes: ArrayLike, momenta: ArrayLike, target: ArrayLike, torque: ArrayLike, gain: ArrayLike = 0.1
) -> Array:
    """Torques that take wheels towards their target without a torque on the body: the null part of gain (target - h).

    Parameters
    ----------
    axes
        Unit vectors e_i; shape (n, 3).
    momenta
        Momenta h_i of the wheels, N m s; shape (..., n).
    target
        Momenta to go to, N m s; shape (..., n). What of them would act on the body is left out.
    torque
        Largest torques, N m; a number or shape (n,). If one of them were exceeded all are made smaller together, and
        still cancel. A wheel with 0 has failed and takes no part.
    gain
        The rate at which the distance from the target decays, 1/s; shape (...), positive.

    Returns
    -------
    ndarray
        Torques of the motors, N m; shape (..., n).

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.

    Notes
    -----
    Source: for four wheels relations:11.

    Examples
    --------
    >>> from symcheck.numeric.wheels import four_wheels
    >>> axes = four_wheels(1.0, 0.7)
    >>> found = null_torque(axes, [0.0, 0.0, 0.0, 0.0], [2.0, -2.0, -2.0, 2.0], torque=0.01)
    >>> found.round(6).tolist(), bool(np.abs(found @ axes).max() < 1e-15)
    ([0.01, -0.01, -0.01, 0.01], True)
    """
    largest = not_negative("torque", torque)
    motions = null_motions(axes, largest)
    count = motions.shape[1]
    stored, wanted = momentum("momenta", momenta, (count,)), momentum("target", target, (count,))
    rate = positive("gain", gain)[..., None]
    change = (wanted - stored) @ motions.T @ motions
    unit = power_of_two(np.abs(change).max(axis=-1, keepdims=True, initial=0))
    change = change / unit
    with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
        allowed = np.where(change == 0, np.inf, largest / np.abs(change)).min(axis=-1, keepdims=True, initial=np.inf)
        return np.asarray(change * np.minimum(rate * unit, allowed))


def clear_momenta(axes: ArrayLike, momenta: ArrayLike, limits: ArrayLike = 1.0, best: float = 0.5) -> ClearMomenta:
    """The momenta with the same total that stay farthest from zero crossing and from saturation.

        min_i min(|h_i|/(f h_i,max), (h_i,max - |h_i|)/((1 - f) h_i,max)) is greatest

    Parameters
    ----------
    axes
        Unit vectors e_i; shape (n, 3), with ten wheels at most that work.
    momenta
        Momenta h_i of the wheels, N m s; shape (n,).
    limits
        Largest momenta h_i,max, N m s; a number or shape (n,). A wheel with 0 has failed and keeps its momentum.
    best
        The part f of the limit that is the best place for a wheel, between 0 and 1.

    Returns
    -------
    ClearMomenta
        The momenta and the clearance. Where only three wheels work they have no choice, and the momenta are the given
        ones.

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.

    Notes
    -----
    Source: condition (1.1) for the limits; relations:11.

    Examples
    --------
    >>> from symcheck.numeric.wheels import four_wheels, total_momentum
    >>> axes = four_wheels(1.0, 0.7)
    >>> found = clear_momenta(axes, [0.0, 0.0, 0.0, 0.0], 2.0)
    >>> np.abs(found.momenta).round(9).tolist(), round(found.clearance, 9)
    ([1.0, 1.0, 1.0, 1.0], 1.0)
    """
    wheels = _one_set(axes, limits)
    place = number("best", best)
    require(0 < place < 1, "best", best, "lie between 0 and 1, both excluded")
    stored = momentum("momenta", momenta, (len(wheels.limits),))
    require(stored.ndim == 1, "momenta", stored.shape, "be those of one set of wheels, of the shape (n,)")
    works = wheels.limits > 0
    require(np.count_nonzero(works) <= MOST, "axes", wheels.axes.shape, f"have at most {MOST} wheels that work")
    shares, motions = stored[works] / wheels.limits[works], null_motions(axes, limits)[:, works] / wheels.limits[works]
    found, clearance = shares, _clearance(shares, place)
    if len(motions):
        motions = motions / np.abs(motions).max()
        for senses in product((-1.0, 1.0), repeat=len(shares)):
            candidate = _best(shares, motions, np.array(senses), place)
            if _clearance(candidate, place) > clearance:
                found, clearance = candidate, _clearance(candidate, place)
    result = stored.copy()
    result[works] = found * wheels.limits[works]
    return ClearMomenta(result, clearance)


def _one_set(axes: ArrayLike, limits: ArrayLike) -> Wheels:
    wheels = wheels_of(axes, limits)
    require(wheels.limits.ndim == 1, "axes", wheels.axes.shape, "be one set of wheels, of the shape (n, 3)", "(2.1)")
    return wheels


def _clearance(shares: Array, best: float) -> float:
    size = np.abs(shares)
    return float(np.minimum(size / best, (1 - size) / (1 - best)).min(initial=1))


def _best(shares: Array, motions: Array, senses: Array, best: float) -> Array:
    """The best shares of the limits with these senses of rotation, or the given ones."""
    from scipy.optimize import linprog

    turned = senses[:, None] * motions.T
    above = np.column_stack([-turned, np.full(len(shares), best)])
    below = np.column_stack([turned, np.full(len(shares), 1 - best)])
    size = senses * shares
    solved = linprog(
        np.append(np.zeros(len(motions)), -1),
        A_ub=np.vstack([above, below]),
        b_ub=np.append(size, 1 - size),
        bounds=[(None, None)] * (len(motions) + 1),
    )
    return np.asarray(shares + solved.x[:-1] @ motions) if solved.success else shares
