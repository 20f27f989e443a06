"""Kernels of relations. Written by `symcheck generate`: what is changed here is lost."""

import math

from symcheck.generated import _relations as paths
from symcheck.kernels.runtime import kernel
from symcheck.kernels.specification import Argument, Output, Specification

__all__ = [
    "mode_inertia_of_a_cylinder",
    "mode_inertia_of_an_ellipsoid",
    "momentum_of_a_disturbance",
    "momentum_with_dumping",
    "natural_frequency_of_an_ellipsoid",
    "time_of_a_turn",
]


@kernel(
    paths.time_of_a_turn,
    Specification(
        paper='relations',
        name='time_of_a_turn',
        says='The time of a turn from rest to rest about one axis.',
        arguments=(
            Argument('theta', 'angle of the turn', unit='rad', low='0'),
            Argument('w', 'largest angular rate on the way', unit='rad/s', low='0'),
            Argument('alpha', 'angular acceleration', unit='rad/s^2', low='0'),
        ),
        outputs=(
            Output('s', 'time of the turn', unit='s'),
        ),
        ulp=4,
        claims={
            'relations:2': 'a7f37ad3a2dd',
        },
    ),
)
def time_of_a_turn(theta, w, alpha):
    """The time of a turn from rest to rest about one axis.

    Parameters
    ----------
    theta : float or ndarray
        Angle of the turn, in rad; 0 < theta.
    w : float or ndarray
        Largest angular rate on the way, in rad/s; 0 < w.
    alpha : float or ndarray
        Angular acceleration, in rad/s^2; 0 < alpha.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    s : float or ndarray
        Time of the turn, in s.

    Notes
    -----
    The function computes ::

        s = theta/w + w/alpha

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on relations:2 (sha256 a7f37ad3a2dd).

    Examples
    --------
    >>> from symcheck.generated.relations import time_of_a_turn
    >>> f"{time_of_a_turn(0.25, 0.5, 0.75):.6g}"
    '1.16667'
    """
    return theta / w + w / alpha


@kernel(
    paths.momentum_of_a_disturbance,
    Specification(
        paper='relations',
        name='momentum_of_a_disturbance',
        says='The momentum that a constant and a periodic torque leave in the wheels.',
        arguments=(
            Argument('G', 'momentum at the time 0', unit='N m s'),
            Argument('T', 'constant torque', unit='N m'),
            Argument('t', 'time', unit='s'),
            Argument('P', 'amplitude of the torque that goes with the cosine', unit='N m'),
            Argument('omega', 'angular frequency of the periodic torque', unit='rad/s', low='0'),
            Argument('Q', 'amplitude of the torque that goes with the sine', unit='N m'),
        ),
        outputs=(
            Output('H', 'momentum', unit='N m s'),
        ),
        ulp=4,
        condition='Terms may cancel: counted in units of the last place of the greatest.',
        claims={
            'relations:6': 'fa24c8984142',
        },
    ),
)
def momentum_of_a_disturbance(G, T, t, P, omega, Q):
    """The momentum that a constant and a periodic torque leave in the wheels.

    Parameters
    ----------
    G : float or ndarray
        Momentum at the time 0, in N m s; any number.
    T : float or ndarray
        Constant torque, in N m; any number.
    t : float or ndarray
        Time, in s; any number.
    P : float or ndarray
        Amplitude of the torque that goes with the cosine, in N m; any number.
    omega : float or ndarray
        Angular frequency of the periodic torque, in rad/s; 0 < omega.
    Q : float or ndarray
        Amplitude of the torque that goes with the sine, in N m; any number.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    H : float or ndarray
        Momentum, in N m s.

    Notes
    -----
    The function computes ::

        H = G + P*sin(omega*t)/omega + 2*Q*sin(omega*t/2)**2/omega + T*t

    Accuracy: 4 ulp over the domain. Terms may cancel: counted in units of the last place of the greatest.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on relations:6 (sha256 fa24c8984142).

    Examples
    --------
    >>> from symcheck.generated.relations import momentum_of_a_disturbance
    >>> f"{momentum_of_a_disturbance(1.14, 1.29, 1.43, 1.57, 0.71, 1.86):.6g}"
    '6.10165'
    """
    t1 = 1.0 / omega
    t2 = omega * t
    t7 = math.sin((1.0 / 2.0) * t2)
    return T * t + (2.0 * (t7 * t7 * (Q * t1)) + (G + math.sin(t2) * (P * t1)))


@kernel(
    paths.momentum_with_dumping,
    Specification(
        paper='relations',
        name='momentum_with_dumping',
        says='The momentum that a constant and a periodic torque leave in wheels that are dumped in proportion to it.',
        arguments=(
            Argument('G', 'momentum at the time 0', unit='N m s'),
            Argument('q', 'part of the momentum that is dumped until t'),
            Argument('T', 'constant torque', unit='N m'),
            Argument('k', 'rate of dumping, 1/s; of the cylinder, the wave number along the spin, 1/m', unit='1/s, 1/m', low='0'),
            Argument('P', 'amplitude of the torque that goes with the cosine', unit='N m'),
            Argument('omega', 'angular frequency of the periodic torque', unit='rad/s', low='0'),
            Argument('Q', 'amplitude of the torque that goes with the sine', unit='N m'),
            Argument('t', 'time', unit='s'),
        ),
        outputs=(
            Output('D', 'momentum with dumping', unit='N m s'),
        ),
        ulp=4,
        condition='Terms may cancel: counted in units of the last place of the greatest.',
        claims={
            'relations:10': 'cf59d725b855',
        },
    ),
)
def momentum_with_dumping(G, q, T, k, P, omega, Q, t):
    """The momentum that a constant and a periodic torque leave in wheels that are dumped in proportion to it.

    Parameters
    ----------
    G : float or ndarray
        Momentum at the time 0, in N m s; any number.
    q : float or ndarray
        Part of the momentum that is dumped until t, a number; any number.
    T : float or ndarray
        Constant torque, in N m; any number.
    k : float or ndarray
        Rate of dumping, 1/s; of the cylinder, the wave number along the spin, 1/m, in 1/s, 1/m; 0 < k.
    P : float or ndarray
        Amplitude of the torque that goes with the cosine, in N m; any number.
    omega : float or ndarray
        Angular frequency of the periodic torque, in rad/s; 0 < omega.
    Q : float or ndarray
        Amplitude of the torque that goes with the sine, in N m; any number.
    t : float or ndarray
        Time, in s; any number.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    D : float or ndarray
        Momentum with dumping, in N m s.

    Notes
    -----
    The function computes ::

        D = -G*q + G + T*q/k + (q - 2*sin(omega*t/2)**2)*(P*k - Q*omega)/(k**2 + omega**2) + (P*omega + Q*k)*sin(omega*t)/(k**2 + omega**2)

    Accuracy: 4 ulp over the domain. Terms may cancel: counted in units of the last place of the greatest.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on relations:10 (sha256 cf59d725b855).

    Examples
    --------
    >>> from symcheck.generated.relations import momentum_with_dumping
    >>> f"{momentum_with_dumping(1.11, 1.22, 1.33, 0.44, 1.56, 0.67, 1.78, 1.89):.6g}"
    '5.74884'
    """
    t1 = omega * t
    t3 = 1.0 / (k * k + omega * omega)
    t8 = math.sin((1.0 / 2.0) * t1)
    t25 = math.sin(t1) * ((P * omega + Q * k) * t3) + ((P * k - Q * omega) * ((q - 2.0 * (t8 * t8)) * t3) + (G + T * q / k))
    return t25 - G * q


@kernel(
    paths.natural_frequency_of_an_ellipsoid,
    Specification(
        paper='relations',
        name='natural_frequency_of_an_ellipsoid',
        says='The natural frequency of the mode of a liquid that fills an ellipsoid of revolution.',
        arguments=(
            Argument('a', 'semi-axis or radius across the spin', unit='m', low='0'),
            Argument('Omega', 'spin', unit='rad/s', low='0'),
            Argument('c', 'semi-axis or half height along the spin', unit='m', low='0'),
        ),
        outputs=(
            Output('lambda', 'natural frequency of the mode', unit='rad/s'),
        ),
        ulp=4,
        claims={
            'relations:22': 'a4e1d6e8a963',
        },
    ),
)
def natural_frequency_of_an_ellipsoid(a, Omega, c):
    """The natural frequency of the mode of a liquid that fills an ellipsoid of revolution.

    Parameters
    ----------
    a : float or ndarray
        semi-axis or radius across the spin, in m; 0 < a.
    Omega : float or ndarray
        Spin, in rad/s; 0 < Omega.
    c : float or ndarray
        semi-axis or half height along the spin, in m; 0 < c.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    lambda : float or ndarray
        Natural frequency of the mode, in rad/s.

    Notes
    -----
    The function computes ::

        lambda = 2*Omega*a**2/(a**2 + c**2)

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on relations:22 (sha256 a4e1d6e8a963).

    Examples
    --------
    >>> from symcheck.generated.relations import natural_frequency_of_an_ellipsoid
    >>> f"{natural_frequency_of_an_ellipsoid(0.25, 0.5, 0.75):.6g}"
    '0.1'
    """
    a_squared = a * a
    return 2.0 * (Omega * a_squared) / (a_squared + c * c)


@kernel(
    paths.mode_inertia_of_an_ellipsoid,
    Specification(
        paper='relations',
        name='mode_inertia_of_an_ellipsoid',
        says='The moment of inertia that the mode of a liquid carries which fills an ellipsoid of revolution.',
        arguments=(
            Argument('m', 'mass of the liquid', unit='kg', low='0'),
            Argument('a', 'semi-axis or radius across the spin', unit='m', low='0'),
            Argument('c', 'semi-axis or half height along the spin', unit='m', low='0'),
        ),
        outputs=(
            Output('E', 'moment of inertia that the mode carries', unit='kg m^2'),
        ),
        ulp=4,
        claims={
            'relations:26': '8ac8641a076a',
        },
    ),
)
def mode_inertia_of_an_ellipsoid(m, a, c):
    """The moment of inertia that the mode of a liquid carries which fills an ellipsoid of revolution.

    Parameters
    ----------
    m : float or ndarray
        Mass of the liquid, in kg; 0 < m.
    a : float or ndarray
        semi-axis or radius across the spin, in m; 0 < a.
    c : float or ndarray
        semi-axis or half height along the spin, in m; 0 < c.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    E : float or ndarray
        Moment of inertia that the mode carries, in kg m^2.

    Notes
    -----
    The function computes ::

        E = 4*a**2*c**2*m/(5*a**2 + 5*c**2)

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on relations:26 (sha256 8ac8641a076a).

    Examples
    --------
    >>> from symcheck.generated.relations import mode_inertia_of_an_ellipsoid
    >>> f"{mode_inertia_of_an_ellipsoid(0.25, 0.5, 0.75):.6g}"
    '0.0346154'
    """
    a_squared = a * a
    c_squared = c * c
    return 4.0 * (m * (a_squared * c_squared)) / (5.0 * a_squared + 5.0 * c_squared)


@kernel(
    paths.mode_inertia_of_a_cylinder,
    Specification(
        paper='relations',
        name='mode_inertia_of_a_cylinder',
        says='The moment of inertia that a mode of a liquid carries which fills a cylinder.',
        arguments=(
            Argument('m', 'mass of the liquid', unit='kg', low='0'),
            Argument('tau', 'natural frequency over spin', low='-2', high='2'),
            Argument('c', 'semi-axis or half height along the spin', unit='m', low='0'),
            Argument('k', 'rate of dumping, 1/s; of the cylinder, the wave number along the spin, 1/m', unit='1/s, 1/m', low='0'),
            Argument('a', 'semi-axis or radius across the spin', unit='m', low='0'),
        ),
        outputs=(
            Output('E_1', 'moment of inertia that a mode of a cylinder carries', unit='kg m^2'),
        ),
        ulp=12,
        condition='A product of seven factors, two of them sums.',
        claims={
            'relations:38': '7d64d91cf388',
        },
    ),
)
def mode_inertia_of_a_cylinder(m, tau, c, k, a):
    """The moment of inertia that a mode of a liquid carries which fills a cylinder.

    Parameters
    ----------
    m : float or ndarray
        Mass of the liquid, in kg; 0 < m.
    tau : float or ndarray
        Natural frequency over spin, a number; -2 < tau < 2.
    c : float or ndarray
        semi-axis or half height along the spin, in m; 0 < c.
    k : float or ndarray
        Rate of dumping, 1/s; of the cylinder, the wave number along the spin, 1/m, in 1/s, 1/m; 0 < k.
    a : float or ndarray
        semi-axis or radius across the spin, in m; 0 < a.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    E_1 : float or ndarray
        Moment of inertia that a mode of a cylinder carries, in kg m^2.

    Notes
    -----
    The function computes ::

        E_1 = 4*m*tau**2*(tau + 2)/(c**2*k**4*(2 - tau)*(2*a**2*k**2 - tau + 2))

    Accuracy: 12 ulp over the domain. A product of seven factors, two of them sums.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on relations:38 (sha256 7d64d91cf388).

    Examples
    --------
    >>> from symcheck.generated.relations import mode_inertia_of_a_cylinder
    >>> f"{mode_inertia_of_a_cylinder(0.17, -0.67, 0.5, 0.67, 0.83):.6g}"
    '0.917831'
    """
    k_squared = k * k
    t13 = 4.0 * ((2.0 + tau) * (m * (tau * tau))) / ((2.0 - tau) * (c * c * (k_squared * k_squared)) * (2.0 + 2.0 * (a * a * k_squared) - tau))
    return t13


KERNELS = {
    "time_of_a_turn": time_of_a_turn,
    "momentum_of_a_disturbance": momentum_of_a_disturbance,
    "momentum_with_dumping": momentum_with_dumping,
    "natural_frequency_of_an_ellipsoid": natural_frequency_of_an_ellipsoid,
    "mode_inertia_of_an_ellipsoid": mode_inertia_of_an_ellipsoid,
    "mode_inertia_of_a_cylinder": mode_inertia_of_a_cylinder,
}
