"""The stationary law of the amplitude a = sqrt(x_1^2 + x_2^2), (3.4): density, distribution, quantiles, moments, mode.

With the body's dissipation d_ij and noise intensities g_ij of (1.1):

    alpha  multiplicative noise, alpha^2 = g_11^2 + g_12^2, s^(-1/2); positive
    beta   additive noise, beta^2 = g_21^2 + g_22^2, rad s^(-3/2); positive
    gamma  dissipation, gamma^2 = d_11 + d_22, s^(-1/2); 4 gamma^2 > alpha^2, else there is no stationary law (4.0.3)

All arguments broadcast; a ValueError names what does not fit.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from symcheck.generated import poloskov2004
from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import (
    Array,
    equatorial,
    evaluated,
    in_one_library,
    not_negative,
    power_of_two,
    probability,
    require,
    shortened,
    times_power,
    within,
)


@gufunc("(),(),(),()->()")
def density_of_amplitude(a: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Array:
    """The stationary density of the amplitude, p(a) = 8 C_1 a (3 alpha^2 a^2 + 4 beta^2)^kappa_1.

    Parameters
    ----------
    a
        Amplitude, rad/s; not negative.
    alpha, beta, gamma
        Multiplicative noise, s^(-1/2), additive noise, rad s^(-3/2), dissipation, s^(-1/2); positive, 2 gamma > alpha.

    Returns
    -------
    ndarray
        Density, s/rad.

    Raises
    ------
    ValueError
        If a < 0 or no stationary density exists.

    Notes
    -----
    Source: (3.4), (3.5), B.2.

    Examples
    --------
    >>> density_of_amplitude([0.0, 0.5, 1.0], 1.0, 3**0.5 / 2, 1.0).round(4).tolist()
    [0.0, 0.64, 0.5]
    """
    unit, values = _scaled(not_negative("a", a, "(3.4)"), *equatorial(alpha, beta, gamma))
    return evaluated("density of a", lambda *x: poloskov2004.density_of_amplitude(*x) / unit, *values)


@gufunc("(),(),(),()->()")
def distribution_of_amplitude(a: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Array:
    """The probability that the amplitude is at most a, F = 1 - (1 + 3 alpha^2 a^2/(4 beta^2))^(kappa_1 + 1).

    Parameters
    ----------
    a
        Amplitude, rad/s; not negative.
    alpha, beta, gamma
        Multiplicative noise, s^(-1/2), additive noise, rad s^(-3/2), dissipation, s^(-1/2); positive, 2 gamma > alpha.

    Returns
    -------
    ndarray
        Probability.

    Raises
    ------
    ValueError
        If a < 0 or no stationary density exists.

    Notes
    -----
    Source: B.3.

    Examples
    --------
    >>> float(distribution_of_amplitude(1.0, 1.0, 3**0.5 / 2, 1.0).round(4))
    0.5
    """
    _, values = _scaled(not_negative("a", a, "(3.4)"), *equatorial(alpha, beta, gamma))
    return evaluated("distribution of a", poloskov2004.distribution_of_amplitude, *values)


@gufunc("(),(),(),()->()")
def quantile_of_amplitude(q: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Array:
    """The amplitude that is exceeded with the probability 1 - q.

    Parameters
    ----------
    q
        Probability, 0 < q < 1.
    alpha, beta, gamma
        Multiplicative noise, s^(-1/2), additive noise, rad s^(-3/2), dissipation, s^(-1/2); positive, 2 gamma > alpha.

    Returns
    -------
    ndarray
        Amplitude, rad/s.

    Raises
    ------
    ValueError
        If q is not such a probability, no stationary density exists, or the quantile exceeds all doubles (near 4
        gamma^2 = alpha^2).

    Notes
    -----
    Source: B.4.

    Examples
    --------
    >>> float(quantile_of_amplitude(0.5, 1.0, 3**0.5 / 2, 1.0).round(4))
    1.0
    """
    values = probability("q", q), *equatorial(alpha, beta, gamma)
    return evaluated("quantile of a", poloskov2004.quantile_of_amplitude, *values)


@gufunc("(),(),(),()->()")
def moment_of_amplitude(m: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Array:
    """The mean of a^m.

    Parameters
    ----------
    m
        Order, any real number that is not negative; accuracy is shown up to 8.
    alpha, beta, gamma
        Multiplicative noise, s^(-1/2), additive noise, rad s^(-3/2), dissipation, s^(-1/2); positive, 2 gamma > alpha.

    Returns
    -------
    ndarray
        Moment, (rad/s)^m.

    Raises
    ------
    ValueError
        If the moment is infinite: 8 gamma^2 > alpha^2 (2 + 3 m) has to hold.

    Notes
    -----
    Source: 4.0.9, B.6.

    Examples
    --------
    >>> moment_of_amplitude([0, 1], 1.0, 3**0.5 / 2, 1.5).round(4).tolist()
    [1.0, 0.6375]
    """
    given = not_negative("m", m, "4.0.9, 4.0.11"), *equatorial(alpha, beta, gamma)
    power, noise, additive, dissipation = in_one_library(*given)
    with np.errstate(over="ignore"):
        finite = 8 * dissipation**2 > noise**2 * (2 + 3 * power)
    require(finite, "gamma", dissipation, f"satisfy 8 gamma^2 > alpha^2 (2 + 3 m) for m = {shortened(power)}", "4.0.9")
    unit, (_, *parameters) = _scaled(np.zeros(()), noise, additive, dissipation)
    moment = poloskov2004.moment_of_amplitude
    return evaluated("moment of a", lambda m, *x: times_power(moment(m, *x), unit, m), power, *parameters)


@gufunc("(),(),()->()")
def mean_square_of_amplitude(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Array:
    """The mean of a^2, beta^2/(gamma^2 - alpha^2).

    Parameters
    ----------
    alpha, beta, gamma
        Multiplicative noise, s^(-1/2), additive noise, rad s^(-3/2), dissipation, s^(-1/2); positive, 2 gamma > alpha.

    Returns
    -------
    ndarray
        Mean square, rad^2/s^2.

    Raises
    ------
    ValueError
        If it is infinite: gamma > alpha has to hold.

    Notes
    -----
    Source: 4.0.9, B.8.

    Examples
    --------
    >>> float(mean_square_of_amplitude(1.0, 2.0, 3.0))
    0.5
    """
    noise, additive, dissipation = equatorial(alpha, beta, gamma)
    require(dissipation > noise, "gamma", dissipation, "satisfy gamma^2 > alpha^2", "4.0.9 for m = 2")
    return evaluated("mean square of a", poloskov2004.mean_square_of_amplitude, noise, additive, dissipation)


@gufunc("(),(),()->()")
def mode_of_amplitude(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Array:
    """The most probable amplitude, 2 beta/sqrt(8 gamma^2 + alpha^2).

    Parameters
    ----------
    alpha, beta, gamma
        Multiplicative noise, s^(-1/2), additive noise, rad s^(-3/2), dissipation, s^(-1/2); positive, 2 gamma > alpha.

    Returns
    -------
    ndarray
        Amplitude, rad/s.

    Raises
    ------
    ValueError
        If a stationary density does not exist.

    Notes
    -----
    Source: 4.0.13.

    Examples
    --------
    >>> float(mode_of_amplitude(1.0, 0.75, 1.0))
    0.5
    """
    return evaluated("mode of a", poloskov2004.mode_of_amplitude, *equatorial(alpha, beta, gamma))


@gufunc("(),(),()->()")
def logarithm_of_constant_of_amplitude(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Array:
    """The logarithm of C_1 in p(a) = 8 C_1 a (3 alpha^2 a^2 + 4 beta^2)^kappa_1; the constant itself may overflow.

    Parameters
    ----------
    alpha, beta, gamma
        Multiplicative noise, s^(-1/2), additive noise, rad s^(-3/2), dissipation, s^(-1/2); positive, 2 gamma > alpha.

    Returns
    -------
    ndarray
        Logarithm of C_1.

    Raises
    ------
    ValueError
        If a stationary density does not exist.

    Notes
    -----
    Source: (3.4), B.2.

    Examples
    --------
    >>> from math import exp
    >>> round(exp(logarithm_of_constant_of_amplitude(1.0, 3**0.5 / 2, 1.0)), 4)
    2.25
    """
    return evaluated("log C_1", poloskov2004.logarithm_of_constant_of_amplitude, *equatorial(alpha, beta, gamma))


def _scaled(a: Array, alpha: Array, beta: Array, gamma: Array) -> tuple[Array, tuple[Array, ...]]:
    """A unit of amplitudes, and the arguments in it and in a unit of time in which beta and gamma are nearly 1.

    The law is the same, squares of all arguments are doubles, and powers of two round nothing.
    """
    size = power_of_two(gamma)
    unit = power_of_two(beta / size)
    return unit, (within("a", a, unit, "beta/gamma"), alpha / size, beta / size / unit, gamma / size)
