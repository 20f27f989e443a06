"""Amplitude, phase and frequency of the rotation, and samples of their joint stationary law."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from symcheck.numeric.arrays import results
from symcheck.numeric.chunked import gufunc, pointwise
from symcheck.numeric.domain import Array, finite, not_negative, positive, real, whole
from symcheck.numeric.random_rotation.amplitude import quantile_of_amplitude
from symcheck.numeric.random_rotation.frequency import quantile_of_frequency
from symcheck.numeric.random_rotation.torques import RandomTorques


class Rotation(NamedTuple):
    """Amplitude, phase and frequency of rotations, of one shape.

    Parameters
    ----------
    a
        Amplitude, rad/s.
    psi
        Phase, rad, from -pi to pi.
    Omega
        Frequency, rad/s.

    Examples
    --------
    >>> float(amplitude_phase_frequency([3.0, 4.0, 5.0], 0.6).a)
    5.0
    """

    a: Array
    psi: Array
    Omega: Array


@gufunc("(i),()->(),(),()")
def amplitude_phase_frequency(x: ArrayLike, k: ArrayLike) -> Rotation:
    """Amplitude a = sqrt(x_1^2 + x_2^2), phase psi with tan psi = -x_2/x_1, frequency Omega = k x_3.

    Parameters
    ----------
    x
        Angular velocity in principal axes, rad/s; shape (..., 3).
    k
        Ratio (A - C)/A of the moments of inertia; positive.

    Returns
    -------
    Rotation
        Amplitude, phase and frequency of the broadcast shape; the phase of a = 0 is 0.

    Raises
    ------
    ValueError
        If an argument is not a number of its range; the message names it.

    Notes
    -----
    Source: (2.3).

    Examples
    --------
    >>> [float(value) for value in amplitude_phase_frequency([0.0, -2.0, 5.0], 0.6)]
    [2.0, 1.5707963267948966, 3.0]
    """
    velocity, ratio = real("x", x, (3,)), positive("k", k, "(1.1)")
    x_1, x_2, x_3 = np.moveaxis(velocity, -1, 0)
    with np.errstate(over="ignore"):
        parts = np.hypot(x_1, x_2), np.arctan2(0.0 - x_2, x_1 + 0.0), ratio * x_3
    return Rotation(*(finite("an amplitude or a frequency", part) for part in results(*parts)))


@gufunc("(),(),(),()->(axis)", axis=3)
def angular_velocity(a: ArrayLike, psi: ArrayLike, Omega: ArrayLike, k: ArrayLike) -> Array:
    """Angular velocity x = (a cos psi, -a sin psi, Omega/k).

    Parameters
    ----------
    a, psi, Omega
        Amplitude in rad/s, not negative; phase in rad; frequency in rad/s.
    k
        Ratio (A - C)/A of the moments of inertia; positive.

    Returns
    -------
    ndarray
        Angular velocity x, rad/s; shape (..., 3).

    Raises
    ------
    ValueError
        If an argument is not a number of its range; the message names it.

    Notes
    -----
    Source: (2.2).

    Examples
    --------
    >>> angular_velocity(2.0, 0.0, 3.0, 0.6).tolist()
    [2.0, -0.0, 5.0]
    """
    amplitude, phase = not_negative("a", a, "(2.3)"), real("psi", psi)
    frequency, ratio = real("Omega", Omega), positive("k", k, "(1.1)")
    with np.errstate(over="ignore"):
        parts = amplitude * np.cos(phase), -amplitude * np.sin(phase), frequency / ratio
    return finite("an angular velocity", np.stack(np.broadcast_arrays(*parts), axis=-1))


@pointwise("()->(realization,axis)")
def stationary_sample(torques: RandomTorques, paths: int, *, seed: int, first: int = 0) -> Array:
    """Independent angular velocities with the stationary law of the averaged system.

    Parameters
    ----------
    torques
        Coefficients of the system.
    paths
        Number of angular velocities.
    seed
        Seed, an integer from 0 on, different from that of the noises.
    first
        Number of the first: a sample in pieces is the same sample.

    Returns
    -------
    ndarray
        Angular velocities x, rad/s; shape (paths, 3).

    Raises
    ------
    ValueError
        If no stationary law exists, or a number does not fit.

    Notes
    -----
    Amplitude and frequency by their quantiles, the phase uniform on a turn. Source: (2.2), (3.4), (3.5), B.4.

    Examples
    --------
    >>> D = [[1, 0.3, 0.2], [0.2, 0.5, 0.1], [0.2, 0.1, 0.9]]
    >>> torques = RandomTorques(0.01, 0.6, D, g_1=[0.6, 0.8, 0.7], g_2=[1, 0, 1])
    >>> sample = stationary_sample(torques, 5, seed=1)
    >>> bool((stationary_sample(torques, 2, seed=1, first=3) == sample[3:]).all())
    True
    """
    source = np.random.PCG64(whole("seed", seed, 0))
    source.advance(3 * whole("first", first, 0))  # one number of the generator makes one uniform number
    uniform = np.maximum(np.random.Generator(source).random((whole("paths", paths, 1), 3)), 2.0**-54)
    a = quantile_of_amplitude(uniform[:, 0], *torques.amplitude)
    Omega = quantile_of_frequency(uniform[:, 1], *torques.frequency)
    return angular_velocity(a, 2 * np.pi * uniform[:, 2], Omega, torques.k)
