"""Kernels of relations. Written by `symcheck generate`: what is changed here is lost."""

from math import sin

from symcheck.kernels.runtime import Argument, Output, kernel

__all__ = [
    "mode_inertia_of_a_cylinder",
    "mode_inertia_of_an_ellipsoid",
    "momentum_of_a_disturbance",
    "momentum_with_dumping",
    "natural_frequency_of_an_ellipsoid",
    "time_of_a_turn",
]


@kernel(
    Argument("theta", "angle of the turn", "rad", low="0"),
    Argument("w", "largest angular rate on the way", "rad/s", low="0"),
    Argument("alpha", "angular acceleration", "rad/s^2", low="0"),
    Output("s", "time of the turn", "s"),
    ulp=4,
    claims={"2": "a7f37ad3a2dd"},
)
def time_of_a_turn(theta, w, alpha):
    """The time of a turn from rest to rest about one axis.

    s = theta/w + w/alpha

    >>> format(time_of_a_turn(0.25, 0.5, 0.75), ".6g")
    '1.16667'
    """
    return theta / w + w / alpha


@kernel(
    Argument("G", "momentum at the time 0", "N m s"),
    Argument("T", "constant torque", "N m"),
    Argument("t", "time", "s"),
    Argument("P", "amplitude of the torque that goes with the cosine", "N m"),
    Argument("omega", "angular frequency of the periodic torque", "rad/s", low="0"),
    Argument("Q", "amplitude of the torque that goes with the sine", "N m"),
    Output("H", "momentum", "N m s"),
    ulp=4,
    condition="Terms may cancel: counted in units of the last place of the greatest.",
    claims={"6": "fa24c8984142"},
)
def momentum_of_a_disturbance(G, T, t, P, omega, Q):
    """The momentum that a constant and a periodic torque leave in the wheels.

    H = G + P*sin(omega*t)/omega + 2*Q*sin(omega*t/2)**2/omega + T*t

    >>> format(momentum_of_a_disturbance(1.14, 1.29, 1.43, 1.57, 0.71, 1.86), ".6g")
    '6.10165'
    """
    t1 = 1.0 / omega
    t2 = omega * t
    t7 = sin((1.0 / 2.0) * t2)
    return T * t + (2.0 * (t7 * t7 * (Q * t1)) + (G + sin(t2) * (P * t1)))


@kernel(
    Argument("G", "momentum at the time 0", "N m s"),
    Argument("q", "part of the momentum that is dumped until t"),
    Argument("T", "constant torque", "N m"),
    Argument("k", "rate of dumping, 1/s; of the cylinder, the wave number along the spin, 1/m", "1/s, 1/m", low="0"),
    Argument("P", "amplitude of the torque that goes with the cosine", "N m"),
    Argument("omega", "angular frequency of the periodic torque", "rad/s", low="0"),
    Argument("Q", "amplitude of the torque that goes with the sine", "N m"),
    Argument("t", "time", "s"),
    Output("D", "momentum with dumping", "N m s"),
    ulp=4,
    condition="Terms may cancel: counted in units of the last place of the greatest.",
    claims={"10": "cf59d725b855"},
)
def momentum_with_dumping(G, q, T, k, P, omega, Q, t):
    """The momentum that a constant and a periodic torque leave in wheels that are dumped in proportion to it.

    D = -G*q + G + T*q/k + (q - 2*sin(omega*t/2)**2)*(P*k - Q*omega)/(k**2 + omega**2) + (P*omega +
        Q*k)*sin(omega*t)/(k**2 + omega**2)

    >>> format(momentum_with_dumping(1.11, 1.22, 1.33, 0.44, 1.56, 0.67, 1.78, 1.89), ".6g")
    '5.74884'
    """
    t1 = omega * t
    t3 = 1.0 / (k * k + omega * omega)
    t8 = sin((1.0 / 2.0) * t1)
    t25 = sin(t1) * ((P * omega + Q * k) * t3) + ((P * k - Q * omega) * ((q - 2.0 * (t8 * t8)) * t3) + (G + T * q / k))
    return t25 - G * q


@kernel(
    Argument("a", "semi-axis or radius across the spin", "m", low="0"),
    Argument("Omega", "spin", "rad/s", low="0"),
    Argument("c", "semi-axis or half height along the spin", "m", low="0"),
    Output("lambda", "natural frequency of the mode", "rad/s"),
    ulp=4,
    claims={"22": "a4e1d6e8a963"},
)
def natural_frequency_of_an_ellipsoid(a, Omega, c):
    """The natural frequency of the mode of a liquid that fills an ellipsoid of revolution.

    lambda = 2*Omega*a**2/(a**2 + c**2)

    >>> format(natural_frequency_of_an_ellipsoid(0.25, 0.5, 0.75), ".6g")
    '0.1'
    """
    a_squared = a * a
    return 2.0 * (Omega * a_squared) / (a_squared + c * c)


@kernel(
    Argument("m", "mass of the liquid", "kg", low="0"),
    Argument("a", "semi-axis or radius across the spin", "m", low="0"),
    Argument("c", "semi-axis or half height along the spin", "m", low="0"),
    Output("E", "moment of inertia that the mode carries", "kg m^2"),
    ulp=4,
    claims={"26": "8ac8641a076a"},
)
def mode_inertia_of_an_ellipsoid(m, a, c):
    """The moment of inertia that the mode of a liquid carries which fills an ellipsoid of revolution.

    E = 4*a**2*c**2*m/(5*a**2 + 5*c**2)

    >>> format(mode_inertia_of_an_ellipsoid(0.25, 0.5, 0.75), ".6g")
    '0.0346154'
    """
    a_squared = a * a
    c_squared = c * c
    return 4.0 * (m * (a_squared * c_squared)) / (5.0 * a_squared + 5.0 * c_squared)


@kernel(
    Argument("m", "mass of the liquid", "kg", low="0"),
    Argument("tau", "natural frequency over spin", low="-2", high="2"),
    Argument("c", "semi-axis or half height along the spin", "m", low="0"),
    Argument("k", "rate of dumping, 1/s; of the cylinder, the wave number along the spin, 1/m", "1/s, 1/m", low="0"),
    Argument("a", "semi-axis or radius across the spin", "m", low="0"),
    Output("E_1", "moment of inertia that a mode of a cylinder carries", "kg m^2"),
    ulp=12,
    condition="A product of seven factors, two of them sums.",
    claims={"38": "7d64d91cf388"},
)
def mode_inertia_of_a_cylinder(m, tau, c, k, a):
    """The moment of inertia that a mode of a liquid carries which fills a cylinder.

    E_1 = 4*m*tau**2*(tau + 2)/(c**2*k**4*(2 - tau)*(2*a**2*k**2 - tau + 2))

    >>> format(mode_inertia_of_a_cylinder(0.17, -0.67, 0.5, 0.67, 0.83), ".6g")
    '0.917831'
    """
    k_squared = k * k
    t13 = (
        4.0 * ((2.0 + tau) * (m * (tau * tau))) / ((2.0 - tau) * (c * c * (k_squared * k_squared)) * (2.0 + 2.0 * (a * a
        * k_squared) - tau))
    )
    return t13


KERNELS = {
    "time_of_a_turn": time_of_a_turn,
    "momentum_of_a_disturbance": momentum_of_a_disturbance,
    "momentum_with_dumping": momentum_with_dumping,
    "natural_frequency_of_an_ellipsoid": natural_frequency_of_an_ellipsoid,
    "mode_inertia_of_an_ellipsoid": mode_inertia_of_an_ellipsoid,
    "mode_inertia_of_a_cylinder": mode_inertia_of_a_cylinder,
}
