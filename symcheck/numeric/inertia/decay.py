"""Free decay of a damped rotation: equation (1.1) in time, and how fast the energy really goes.

Decision: SciPy's DOP853, all bodies as one system, and its LSODA where the fastest mode decays within a small part of
the time. Reason: one call takes all bodies; DOP853 needs the fewest steps unless the problem is stiff.

Decision: the unknowns are the amplitudes of the modes of I dw/dt = -m w, in units in which the moments, the rates and
the time are nearly 1. Reason: a fast mode that has decayed then stays small, whatever rounding does to the others; in
the components of w it comes and goes with every rounding, which at rates 1e9 apart took a minute.
"""

from __future__ import annotations

from math import sqrt

import numpy as np
from numpy.typing import ArrayLike
from scipy.integrate import solve_ivp

from symcheck.numeric.arrays import eigensystem
from symcheck.numeric.chunked import gufunc, pointwise
from symcheck.numeric.domain import (
    Array,
    evaluated,
    increasing,
    moderate,
    positive,
    power_of_two,
    principal_moments,
    real,
    require,
    symmetric_matrix,
)

FINEST = 100 * np.finfo(np.float64).eps  # the least relative tolerance that SciPy takes
STIFF = 1e3  # time constants of the fastest mode in the whole time, from which LSODA is the faster one
FINER = 1e-2  # of the tolerance, for LSODA: its errors of steps add up to some hundred times that of one
SMALLEST = np.finfo(np.float64).tiny  # of an absolute tolerance: SciPy divides by it, also for a body at rest


@gufunc("(i),(i,j),(i)->(i)")
def angular_acceleration(moments: ArrayLike, damping: ArrayLike, rate: ArrayLike) -> Array:
    """Acceleration of the rotation: I dw/dt = -m w - w x I w.

    Parameters
    ----------
    moments
        Principal moments of inertia, kg m^2; shape (..., 3).
    damping
        Damping matrix in principal axes, N m s/rad; shape (..., 3, 3).
    rate
        Angular rate w in principal axes, rad/s; shape (..., 3).

    Returns
    -------
    ndarray
        Shape (..., 3), rad/s^2.

    Raises
    ------
    ValueError
        If a moment is not positive or the matrix is not symmetric.

    Notes
    -----
    Source: mirer2009:1.1.

    Examples
    --------
    >>> angular_acceleration([2, 3, 4], np.zeros((3, 3)), [1, 2, 3]).tolist()
    [-3.0, 2.0, -0.5]
    """
    matrix = symmetric_matrix("damping", damping, "mirer2009:1.2.6")
    return evaluated("an acceleration", _acceleration, principal_moments(moments), matrix, real("rate", rate, (3,)))


@pointwise("(i),(i,j),(i),(time)->(time,i)")
def free_decay(
    moments: ArrayLike, damping: ArrayLike, rate: ArrayLike, times: ArrayLike, tolerance: float = 1e-11
) -> Array:
    """The angular rate of a damped body in time: equation (1.1) integrated.

    Parameters
    ----------
    moments
        Principal moments of inertia, kg m^2; shape (..., 3).
    damping
        Damping matrix in principal axes, N m s/rad; shape (..., 3, 3).
    rate
        Angular rate at the first time, in principal axes, rad/s; shape (..., 3).
    times
        Increasing times, s, the same for all bodies; shape (n,).
    tolerance
        Tolerance of each step, relative to the rate, or to what the slowest mode leaves of it at the end if that is
        more.

    Returns
    -------
    ndarray
        Angular rates, rad/s; shape (..., n, 3).

    Raises
    ------
    ValueError
        If a moment or the tolerance is not positive, the matrix is not symmetric or amplifies a rotation, or the times
        do not increase.
    FloatingPointError
        If the integration does not reach the last time.

    Notes
    -----
    Source: mirer2009:1.1.

    Examples
    --------
    >>> times = np.linspace(0, 10, 5)
    >>> rates = free_decay([2, 3, 4], np.diag([0.2, 0.3, 0.4]), [0.1, 0.2, 0.3], times)
    >>> energy = kinetic_energy([2, 3, 4], rates)
    >>> (energy / energy[0] * np.exp(2 * 0.1 * times)).round(8).tolist()
    [1.0, 1.0, 1.0, 1.0, 1.0]
    """
    moments, damping = principal_moments(moments), symmetric_matrix("damping", damping, "mirer2009:1.2.6")
    rate, times = real("rate", rate, (3,)), moderate("times", increasing("times", times))
    positive("tolerance", tolerance)
    span, turn = power_of_two(np.asarray(np.ptp(times))), power_of_two(np.abs(rate).max(axis=-1, keepdims=True))
    size = power_of_two(moments.max(axis=-1, keepdims=True))
    inertia, whole = moments / size, float(np.ptp(times) / span)
    roots = np.sqrt(inertia)
    matrix = symmetric_matrix("damping", damping * (span / size[..., None])) / (roots[..., None] * roots[..., None, :])
    decays, modes = eigensystem(matrix)
    undamped = decays[..., 0] >= -np.abs(decays).max(axis=-1) * FINEST
    require(undamped, "damping", damping, "amplify no rotation", "mirer2009:1.1")
    into, back = modes * roots[..., None, :], modes / roots[..., None, :]
    shape = np.broadcast_shapes(decays.shape[:-1], rate.shape[:-1])
    start = np.broadcast_to(_product(into, rate / turn), (*shape, 3))

    def change(_: float, state: Array) -> Array:
        amplitude = state.reshape(start.shape)
        turned = _product(back.swapaxes(-1, -2), amplitude)
        return (-decays * amplitude - turn * span * _product(back, _gyroscopic(inertia, turned))).ravel()

    # SciPy bounds the error of all bodies together, by its mean square: each has to keep within it.
    tolerance = max(tolerance / sqrt(max(start.size // 3, 1)), FINEST)
    left = np.exp(-decays[..., 0] * whole) * np.linalg.norm(rate / turn, axis=-1) * roots.min(axis=-1)
    stiff = bool(np.abs(decays).max(initial=0) * whole > STIFF)
    tolerance = max(tolerance * FINER, FINEST) if stiff else tolerance
    allowed = np.broadcast_to(np.maximum(tolerance * left, SMALLEST), shape)
    solver = {"method": "LSODA", "lband": 2, "uband": 2} if stiff else {"method": "DOP853"}  # three equations of each
    rates = np.empty((*shape, times.size, 3))
    if rates.size:
        ends, absolute = (times[0] / span, times[-1] / span), np.repeat(allowed.ravel(), 3)
        solution = solve_ivp(change, ends, start.ravel(), t_eval=times / span, rtol=tolerance, atol=absolute, **solver)
        if not solution.success:
            raise FloatingPointError(f"no free decay up to {times[-1]} s: {solution.message}")
        amplitudes = np.moveaxis(solution.y.reshape(*start.shape, times.size), -1, -2)
        rates[...] = amplitudes @ back * turn[..., None, :]
        rates[..., 0, :] = rate
    return rates


@gufunc("(i),(time,i)->(time)")
def kinetic_energy(moments: ArrayLike, rates: ArrayLike) -> Array:
    """The kinetic energy of rotation (I_1 w_1^2 + I_2 w_2^2 + I_3 w_3^2)/2 at each time.

    Parameters
    ----------
    moments
        Principal moments of inertia, kg m^2; shape (..., 3).
    rates
        Angular rates in principal axes, rad/s; shape (..., n, 3).

    Returns
    -------
    ndarray
        Kinetic energy, J; shape (..., n).

    Raises
    ------
    ValueError
        If a moment is not positive.

    Examples
    --------
    >>> kinetic_energy([2, 3, 4], [[1, 0, 0], [0, 2, 1]]).tolist()
    [1.0, 8.0]
    """
    inertia, rate = principal_moments(moments)[..., None, :], real("rates", rates, (None, 3))
    return evaluated("an energy", lambda *x: (x[0] * x[1] * x[1]).sum(axis=-1) / 2, inertia, rate)


@gufunc("(time),(time)->()")
def decay_rate(times: ArrayLike, energy: ArrayLike) -> Array:
    """The measured decay rate of the angular rate, log(T_first/T_last)/2 over the time between.

    Parameters
    ----------
    times
        Increasing times, s; shape (n,).
    energy
        Kinetic energy at these times, J; shape (..., n).

    Returns
    -------
    ndarray
        Shape (...), 1/s.

    Raises
    ------
    ValueError
        If the times do not increase or an energy is not positive.

    Notes
    -----
    From (1.1) dT/dt = -w^T m w, so that every decay rate lies between the least and the greatest damping rate, not only
    for small w; over late times it tends to the stability degree unless the slowest mode is missing.

    Examples
    --------
    >>> round(float(decay_rate([0, 1, 2], [1.0, np.exp(-0.6), np.exp(-1.2)])), 12)
    0.3
    """
    times = increasing("times", times)
    energy = positive("energy", energy, "else there is nothing to measure", (times.size,))
    first, last = energy[..., 0], energy[..., -1]
    return evaluated("a decay rate", lambda *x: _logarithm_of_ratio(*x[:2]) / (2 * np.ptp(x[2])), first, last, times)


def _logarithm_of_ratio(above: Array, below: Array) -> Array:
    """log(above/below), also where the ratio is nearly 1 and where it is no double."""
    change = (above - below) / below
    (high, more), (low, less) = np.frexp(above), np.frexp(below)
    apart = np.log(high / low) + (more - less) * np.log(2)
    return np.asarray(np.where(np.abs(change) < 0.5, np.log1p(np.maximum(change, -0.5)), apart))


def _acceleration(moments: Array, damping: Array, rate: Array) -> Array:
    torque = _product(damping, rate) + _gyroscopic(moments, rate)
    acceleration: Array = -torque / moments
    return acceleration


def _gyroscopic(moments: Array, rate: Array) -> Array:
    """w x I w, of differences of moments: those that are equal, or nearly, leave nothing of rounding."""
    after, before = [1, 2, 0], [2, 0, 1]
    return np.asarray((moments[..., before] - moments[..., after]) * rate[..., after] * rate[..., before])


def _product(matrix: Array, vector: Array) -> Array:
    return np.asarray(np.einsum("...ij,...j->...i", matrix, vector))
