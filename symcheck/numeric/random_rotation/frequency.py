"""The stationary law of the frequency Omega = k x_3, (3.5): density, distribution, quantiles, moments, mode.

Everywhere, with the coefficients of (1.1):

    k     (A - C)/A of the moments of inertia A, A, C; a positive number
    g_13  multiplicative noise of the polar axis, s^(-1/2); positive
    g_23  additive noise of the polar axis, rad s^(-3/2); positive
    d_33  dissipation about the polar axis, 1/s; positive, else there is no stationary law (4.0.5)

All arguments broadcast; a ValueError names what does not fit. Omega sqrt(2 d_33)/(g_23 k) has Student's distribution
with 2 d_33/g_13^2 degrees of freedom: its distribution function and quantiles are SciPy's.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from scipy import special

from symcheck.generated import poloskov2004
from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import (
    Array,
    axial,
    evaluated,
    in_one_library,
    not_negative,
    power_of_two,
    probability,
    real,
    require,
    shortened,
    times_power,
    within,
)


@gufunc("(),(),(),(),()->()")
def density_of_frequency(Omega: ArrayLike, k: ArrayLike, g_13: ArrayLike, g_23: ArrayLike, d_33: ArrayLike) -> Array:
    """The stationary density of the frequency, p(Omega) = C_2 (g_13^2 Omega^2 + g_23^2 k^2)^kappa_2.

    Parameters
    ----------
    Omega
        Frequency, rad/s.
    k, g_13, g_23, d_33
        Ratio (A - C)/A of the moments of inertia; multiplicative noise, s^(-1/2), additive noise, rad s^(-3/2), and
        dissipation, 1/s, of the polar axis; positive.

    Returns
    -------
    ndarray
        Density, s/rad.

    Raises
    ------
    ValueError
        If a stationary density does not exist.

    Notes
    -----
    Source: (3.5), B.5.

    Examples
    --------
    >>> density_of_frequency([0.0, 0.6], 0.6, 1.0, 1.0, 1.5).round(4).tolist()
    [1.061, 0.2653]
    """
    frequency, (unit, parameters) = real("Omega", Omega), _scaled(*axial(k, g_13, g_23, d_33))
    in_unit = within("Omega", frequency, unit, "g_23 k/sqrt(d_33)")
    return evaluated("density of Omega", lambda *x: poloskov2004.density_of_frequency(*x) / unit, in_unit, *parameters)


@gufunc("(),(),(),(),()->()")
def distribution_of_frequency(
    Omega: ArrayLike, k: ArrayLike, g_13: ArrayLike, g_23: ArrayLike, d_33: ArrayLike
) -> Array:
    """The probability that the frequency is at most Omega: that of Student's t = Omega sqrt(2 d_33)/(g_23 k).

    Parameters
    ----------
    Omega
        Frequency, rad/s.
    k, g_13, g_23, d_33
        Ratio (A - C)/A of the moments of inertia; multiplicative noise, s^(-1/2), additive noise, rad s^(-3/2), and
        dissipation, 1/s, of the polar axis; positive.

    Returns
    -------
    ndarray
        Probability; small values keep their relative accuracy.

    Raises
    ------
    ValueError
        If a stationary density does not exist.

    Notes
    -----
    Source: (3.5).

    Examples
    --------
    >>> float(distribution_of_frequency(0.6 / 3**0.5, 0.6, 1.0, 1.0, 1.5).round(4))
    0.8045
    """
    return evaluated("distribution of Omega", _distribution, real("Omega", Omega), *axial(k, g_13, g_23, d_33))


@gufunc("(),(),(),(),()->()")
def quantile_of_frequency(q: ArrayLike, k: ArrayLike, g_13: ArrayLike, g_23: ArrayLike, d_33: ArrayLike) -> Array:
    """The frequency that is exceeded with the probability 1 - q.

    Parameters
    ----------
    q
        Probability, 0 < q < 1.
    k, g_13, g_23, d_33
        Ratio (A - C)/A of the moments of inertia; multiplicative noise, s^(-1/2), additive noise, rad s^(-3/2), and
        dissipation, 1/s, of the polar axis; positive.

    Returns
    -------
    ndarray
        Frequency, rad/s.

    Raises
    ------
    ValueError
        If q is not such a probability, no stationary density exists, or |Omega| exceeds 1e153 g_23 k/g_13 (small
        d_33/g_13^2).

    Notes
    -----
    Source: (3.5).

    Examples
    --------
    >>> quantile_of_frequency([0.1, 0.5], 0.6, 1.0, 1.0, 1.5).round(4).tolist()
    [-0.5673, 0.0]
    """
    return evaluated("quantile of Omega", _quantile, probability("q", q), *axial(k, g_13, g_23, d_33))


@gufunc("(),(),(),(),()->()")
def moment_of_frequency(m: ArrayLike, k: ArrayLike, g_13: ArrayLike, g_23: ArrayLike, d_33: ArrayLike) -> Array:
    """The mean of |Omega|^m; those of Omega^m are the same for even m, and 0 for odd m.

    Parameters
    ----------
    m
        Order, any real number that is not negative; accuracy is shown up to 8.
    k, g_13, g_23, d_33
        Ratio (A - C)/A of the moments of inertia; multiplicative noise, s^(-1/2), additive noise, rad s^(-3/2), and
        dissipation, 1/s, of the polar axis; positive.

    Returns
    -------
    ndarray
        Absolute moment, (rad/s)^m.

    Raises
    ------
    ValueError
        If the moment is infinite: 2 d_33 > m g_13^2 has to hold, and the printed 3 d_33 > m g_13^2 is not enough.

    Notes
    -----
    Source: 4.0.11, B.7.

    Examples
    --------
    >>> moment_of_frequency([0, 1, 2], 0.6, 1.0, 1.0, 1.5).round(4).tolist()
    [1.0, 0.382, 0.36]
    """
    given = not_negative("m", m, "4.0.9, 4.0.11"), *axial(k, g_13, g_23, d_33)
    power, ratio, noise, additive, dissipation = in_one_library(*given)
    finite = 2 * dissipation > power * noise**2
    require(finite, "d_33", dissipation, f"satisfy 2 d_33 > m g_13^2 for m = {shortened(power)}", "4.0.11")
    unit, parameters = _scaled(ratio, noise, additive, dissipation)
    moment = poloskov2004.moment_of_frequency
    return evaluated("moment of Omega", lambda m, *x: times_power(moment(m, *x), unit, m), power, *parameters)


@gufunc("(),(),(),()->()")
def mean_square_of_frequency(k: ArrayLike, g_13: ArrayLike, g_23: ArrayLike, d_33: ArrayLike) -> Array:
    """The mean of Omega^2, g_23^2 k^2/(2 d_33 - 2 g_13^2).

    Parameters
    ----------
    k, g_13, g_23, d_33
        Ratio (A - C)/A of the moments of inertia; multiplicative noise, s^(-1/2), additive noise, rad s^(-3/2), and
        dissipation, 1/s, of the polar axis; positive.

    Returns
    -------
    ndarray
        Mean square, rad^2/s^2.

    Raises
    ------
    ValueError
        If it is infinite: d_33 > g_13^2 has to hold.

    Notes
    -----
    Source: 4.0.11, B.8.

    Examples
    --------
    >>> float(mean_square_of_frequency(0.5, 1.0, 2.0, 1.5))
    1.0
    """
    ratio, noise, additive, dissipation = axial(k, g_13, g_23, d_33)
    require(dissipation > noise**2, "d_33", dissipation, "satisfy d_33 > g_13^2", "4.0.11 for m = 2")
    unit, parameters = _scaled(ratio, noise, additive, dissipation)
    mean = poloskov2004.mean_square_of_frequency
    return evaluated("mean square of Omega", lambda *x: mean(*x) * unit * unit, *parameters)


@gufunc("(),(),(),()->()")
def mode_of_frequency(k: ArrayLike, g_13: ArrayLike, g_23: ArrayLike, d_33: ArrayLike) -> Array:
    """The most probable frequency, 0 for all parameters.

    Parameters
    ----------
    k, g_13, g_23, d_33
        Ratio (A - C)/A of the moments of inertia; multiplicative noise, s^(-1/2), additive noise, rad s^(-3/2), and
        dissipation, 1/s, of the polar axis; positive.

    Returns
    -------
    ndarray
        Zeros, rad/s, of the broadcast shape.

    Raises
    ------
    ValueError
        If a stationary density does not exist.

    Notes
    -----
    Source: 4.0.17.

    Examples
    --------
    >>> mode_of_frequency([0.5, 0.6], 1.0, 1.0, 1.5).tolist()
    [0.0, 0.0]
    """
    return np.zeros(np.broadcast_shapes(*(value.shape for value in axial(k, g_13, g_23, d_33))))


@gufunc("(),(),(),()->()")
def logarithm_of_constant_of_frequency(k: ArrayLike, g_13: ArrayLike, g_23: ArrayLike, d_33: ArrayLike) -> Array:
    """The logarithm of C_2 in p(Omega) = C_2 (g_13^2 Omega^2 + g_23^2 k^2)^kappa_2; the constant may overflow.

    Parameters
    ----------
    k, g_13, g_23, d_33
        Ratio (A - C)/A of the moments of inertia; multiplicative noise, s^(-1/2), additive noise, rad s^(-3/2), and
        dissipation, 1/s, of the polar axis; positive.

    Returns
    -------
    ndarray
        Logarithm of C_2.

    Raises
    ------
    ValueError
        If a stationary density does not exist.

    Notes
    -----
    Source: (3.5), B.5.

    Examples
    --------
    >>> from math import exp, pi
    >>> round(exp(logarithm_of_constant_of_frequency(0.6, 1.0, 1.0, 1.5)) * pi, 4)
    0.432
    """
    return evaluated("log C_2", poloskov2004.logarithm_of_constant_of_frequency, *axial(k, g_13, g_23, d_33))


def _distribution(Omega: Array, k: Array, g_13: Array, g_23: Array, d_33: Array) -> Array:
    value: Array = special.stdtr(2 * d_33 / g_13**2, Omega / (g_23 * k) * np.sqrt(2 * d_33))
    return value


def _quantile(q: Array, k: Array, g_13: Array, g_23: Array, d_33: Array) -> Array:
    """From y = 1/(1 + c Omega^2), c = (g_13/(g_23 k))^2: |Omega| is exceeded with the probability I_y(delta, 1/2).

    Decision: y and 1 - y each by their own inverse of the incomplete beta function, so that neither the tails nor the
    middle lose digits. `special.stdtrit` (SciPy 1.17) is infinite at q = 1e-300, whatever the degrees of freedom.
    """
    delta, outside = d_33 / g_13**2, 2 * np.minimum(q, 1 - q)
    y = special.betaincinv(delta, 0.5, outside)
    y = np.where(y > np.finfo(np.float64).tiny, y, 0)  # SciPy gives the least normal double for whatever is less
    rest = special.betainccinv(0.5, delta, outside)
    value: Array = np.copysign(np.sqrt(rest / y), q - 0.5) * (g_23 * k / g_13)
    return value


def _scaled(k: Array, g_13: Array, g_23: Array, d_33: Array) -> tuple[Array, tuple[Array, Array, Array, Array]]:
    """A unit of frequencies, and the parameters in it and in a unit of time in which k, g_23 and d_33 are nearly 1.

    The law is the same, squares of all parameters are doubles, and powers of two round nothing.
    """
    size, own = power_of_two(d_33**0.5), power_of_two(k)
    noise = power_of_two(g_23 / size)
    return own * noise, (k / own, g_13 / size, g_23 / size / noise, d_33 / size / size)
