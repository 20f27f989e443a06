"""Kernels of esenkov2006. Written by `symcheck generate`: what is changed here is lost."""

from math import sqrt

from symcheck.kernels.runtime import Argument, Output, kernel

__all__ = [
    "boundary_of_stability",
    "characteristic_coefficients",
    "critical_frequencies",
    "discriminant",
    "frequencies",
    "greatest_growth_rate",
    "mode_inertia",
    "residue_of_a_mode",
    "width_of_the_unstable_interval",
]


@kernel(
    Argument("a_1", "angular momentum of the liquid for the amplitude 1 of a mode of dimensionless shape", "kg m"),
    Argument("chi_1", "coupling of the mode to the turning body", "m^4"),
    Argument("N_1", "norm of the mode", "m^(3/2)", low="0"),
    Output("E_1", "moment of inertia of the mode", "kg m^2"),
    ulp=4,
    claims={"1.32": "91c691dc84d1", "B.1": "d62232d82a4e"},
)
def mode_inertia(a_1, chi_1, N_1):
    """The moment of inertia that a mode of the liquid carries.

    E_1 = a_1*chi_1/N_1**2

    >>> format(mode_inertia(1.25, 1.5, 0.75), ".6g")
    '3.33333'
    """
    return a_1 * chi_1 / (N_1 * N_1)


@kernel(
    Argument("E_1", "moment of inertia that the mode carries", "kg m^2", low="0"),
    Argument("lambda_1", "natural frequency of the mode", "rad/s"),
    Argument("omega_0", "spin", "rad/s", low="0"),
    Output("R_1", "minus the residue", "kg m^2 rad^2/s^2"),
    ulp=4,
    claims={"N.3": "10f423309148", "N.5": "b88788105c9d"},
    forms="1273b10d4eb2",
)
def residue_of_a_mode(E_1, lambda_1, omega_0):
    """Minus the residue of the characteristic equation at a natural frequency; modes with positive ones are harmless.

    R_1 = E_1*lambda_1**2 - E_1*lambda_1*omega_0

    >>> format(residue_of_a_mode(0.25, 1.5, 0.75), ".6g")
    '0.28125'
    """
    return (lambda_1 - omega_0) * (E_1 * lambda_1)


@kernel(
    Argument("A", "transverse moment of inertia, with the liquid at rest", "kg m^2", low="0"),
    Argument("C", "axial moment of inertia", "kg m^2", low="0"),
    Argument("E_1", "moment of inertia that the mode carries", "kg m^2", low="0", high="A"),
    Argument("lambda_1", "natural frequency of the mode", "rad/s"),
    Argument("omega_0", "spin", "rad/s", low="0"),
    Output("c_2", "coefficient of eta^2", "kg m^2"),
    Output("c_1", "coefficient of eta", "kg m^2 rad/s"),
    Output("c_0", "constant term", "kg m^2 rad^2/s^2"),
    ulp=4,
    condition="Where terms cancel, the error is in units of the last place of the largest of them.",
    claims={"1.32": "91c691dc84d1", "1.33": "5dfcf91b92f9"},
    forms="8d1a6c39f1e8",
)
def characteristic_coefficients(A, C, E_1, lambda_1, omega_0):
    """Coefficients of the quadratic equation (1.33) for the frequencies.

    c_2 = A - E_1
    c_1 = -A*lambda_1 - A*omega_0 + C*omega_0 + E_1*omega_0
    c_0 = A*lambda_1*omega_0 - C*lambda_1*omega_0

    >>> [f"{x:.6g}" for x in characteristic_coefficients(0.17, 0.33, 0.08, 1.67, 0.83)]
    ['0.09', '-0.0847', '-0.221776']
    """
    t1 = A - C
    c_2 = A - E_1
    c_1 = E_1 * omega_0 - A * lambda_1 - omega_0 * t1
    c_0 = omega_0 * (lambda_1 * t1)
    return c_2, c_1, c_0


@kernel(
    Argument("A", "transverse moment of inertia, with the liquid at rest", "kg m^2", low="0"),
    Argument("C", "axial moment of inertia", "kg m^2", low="0"),
    Argument("E_1", "moment of inertia that the mode carries", "kg m^2", low="0", high="A"),
    Argument("lambda_1", "natural frequency of the mode", "rad/s"),
    Argument("omega_0", "spin", "rad/s", low="0"),
    Output("D", "discriminant in eta", "kg^2 m^4 rad^2/s^2"),
    ulp=10,
    condition=(
        "It is zero at the boundary of stability; the error is in units of the last place of what it were if "
        "nothing cancelled, the square of |C - A| omega_0 + E_1 omega_0 + A |lambda_1|; ten operations follow one "
        "another."
    ),
    claims={"1.33.3a": "85a55af1a21e", "1.33.4": "eef05166bf2c", "B.2": "1846771b4c5a", "B.6": "3465e26c0810"},
    forms="69b0e962ebfb",
)
def discriminant(A, C, E_1, lambda_1, omega_0):
    """The discriminant of the quadratic equation (1.33): the body is stable where it is positive.

    D = A**2*lambda_1**2 - 2*A**2*lambda_1*omega_0 + A**2*omega_0**2 + 2*A*C*lambda_1*omega_0 - 2*A*C*omega_0**2 +
        2*A*E_1*lambda_1*omega_0 - 2*A*E_1*omega_0**2 + C**2*omega_0**2 - 4*C*E_1*lambda_1*omega_0 +
        2*C*E_1*omega_0**2 + E_1**2*omega_0**2

    >>> format(discriminant(0.17, 0.33, 0.08, 1.67, 0.83), ".6g")
    '0.0870135'
    """
    t5 = E_1 * (lambda_1 - omega_0)
    t13 = omega_0 * (C - A) + lambda_1 * (A - E_1) - t5
    return t13 * t13 + (4.0 * A - 4.0 * E_1) * (lambda_1 * t5)


@kernel(
    Argument("A", "transverse moment of inertia, with the liquid at rest", "kg m^2", low="0"),
    Argument("E_1", "moment of inertia that the mode carries", "kg m^2", low="0", high="A"),
    Argument("b_1", "natural frequency of the mode, divided by the spin", low="0", high="1"),
    Output("Delta_1", "upper end", "kg m^2"),
    Output("Delta_2", "lower end", "kg m^2"),
    ulp=4,
    condition=(
        "The upper end is zero where A b_1 = E_1; its error is in units of the last place of the larger of E_1 (1 -"
        " b_1) and b_1 (A - E_1)."
    ),
    claims={"1.34.3": "d8869e67ad9a", "1.34.5": "5bd5d83cdfe1", "1.35a": "b5ffc014e2a4", "1.35c": "aa7f3e52c939",
        "B.11": "742d7c68ca61"},
    forms="c587d73ba2b4",
)
def boundary_of_stability(A, E_1, b_1):
    """The two values of C - A between which the body is unstable.

    Delta_1 = -A*b_1 + 2*sqrt(E_1)*sqrt(b_1)*sqrt(1 - b_1)*sqrt(A - E_1) + 2*E_1*b_1 - E_1
    Delta_2 = -A*b_1 - 2*sqrt(E_1)*sqrt(b_1)*sqrt(1 - b_1)*sqrt(A - E_1) + 2*E_1*b_1 - E_1

    >>> [f"{x:.6g}" for x in boundary_of_stability(0.25, 0.12, 0.75)]
    ['-0.0193335', '-0.235667']
    """
    t1 = 1.0 - b_1
    t2 = E_1 * t1
    t3 = A - E_1
    t4 = b_1 * t3
    t11 = t2 + 2.0 * (sqrt(t1 * t3) * (sqrt(E_1) * sqrt(b_1))) + t4
    t12 = 1.0 / t11
    Delta_1 = (t2 - t4) * (b_1 * (t12 * t3) - t12 * t2)
    Delta_2 = -t11
    return Delta_1, Delta_2


@kernel(
    Argument("A", "transverse moment of inertia, with the liquid at rest", "kg m^2", low="0"),
    Argument("E_1", "moment of inertia that the mode carries", "kg m^2", low="0", high="A"),
    Argument("b_1", "natural frequency of the mode, divided by the spin", low="0", high="1"),
    Output("width", "length of the interval", "kg m^2"),
    ulp=4,
    claims={"1.34.4": "d7e201757da1", "B.16": "4515d9596d9c", "B.28": "d39dfa450602"},
    forms="69c2846fab1b",
)
def width_of_the_unstable_interval(A, E_1, b_1):
    """The length of the interval of C - A in which the body is unstable.

    width = 4*sqrt(E_1)*sqrt(b_1)*sqrt(1 - b_1)*sqrt(A - E_1)

    >>> format(width_of_the_unstable_interval(0.25, 0.12, 0.75), ".6g")
    '0.216333'
    """
    return 4.0 * (sqrt((1.0 - b_1) * (A - E_1)) * (sqrt(E_1) * sqrt(b_1)))


@kernel(
    Argument("A", "transverse moment of inertia, with the liquid at rest", "kg m^2", low="0"),
    Argument("E_1", "moment of inertia that the mode carries", "kg m^2", low="0", high="A"),
    Argument("b_1", "natural frequency of the mode, divided by the spin", low="0", high="1"),
    Argument("omega_0", "spin", "rad/s", low="0"),
    Output("eta_1", "frequency at the upper end", "rad/s"),
    Output("eta_2", "frequency at the lower end", "rad/s"),
    ulp=4,
    condition=(
        "The frequency at the upper end is zero where A b_1 = E_1. Where terms cancel, the error is in units of the"
        " last place of the largest of them."
    ),
    claims={"B.4": "0e6afd49f325", "B.26": "520e09812ec5", "B.27": "416470da3f23"},
)
def critical_frequencies(A, E_1, b_1, omega_0):
    """The double frequencies at the two ends of the interval in which the body is unstable.

    eta_1 = omega_0*(-sqrt(E_1)*sqrt(-b_1*(b_1 - 1)/(A - E_1)) + b_1)
    eta_2 = omega_0*(sqrt(E_1)*sqrt(-b_1*(b_1 - 1)/(A - E_1)) + b_1)

    >>> [f"{x:.6g}" for x in critical_frequencies(0.2, 0.08, 0.6, 0.8)]
    ['0.16', '0.8']
    """
    t7 = sqrt(E_1) * sqrt(-(b_1 * (b_1 - 1.0) / (A - E_1)))
    eta_1 = omega_0 * (b_1 - t7)
    eta_2 = omega_0 * (b_1 + t7)
    return eta_1, eta_2


@kernel(
    Argument("A", "transverse moment of inertia, with the liquid at rest", "kg m^2", low="0"),
    Argument("E_1", "moment of inertia that the mode carries", "kg m^2", low="0", high="A"),
    Argument("b_1", "natural frequency of the mode, divided by the spin", low="0", high="1"),
    Argument("omega_0", "spin", "rad/s", low="0"),
    Output("y", "growth rate", "1/s"),
    ulp=4,
    claims={"B.6": "3465e26c0810", "B.7": "e0d23e2e841f", "B.8": "274537c8998c"},
)
def greatest_growth_rate(A, E_1, b_1, omega_0):
    """The rate at which the motion grows in the middle of the interval in which the body is unstable; nowhere is it
        greater.

    y = sqrt(E_1)*omega_0*sqrt(-b_1*(b_1 - 1)/(A - E_1))

    >>> format(greatest_growth_rate(0.2, 0.08, 0.6, 0.8), ".6g")
    '0.32'
    """
    return sqrt(-(b_1 * (b_1 - 1.0) / (A - E_1))) * (omega_0 * sqrt(E_1))


@kernel(
    Argument("A", "transverse moment of inertia, with the liquid at rest", "kg m^2", low="0"),
    Argument("Delta", "C - A: a flattened body", "kg m^2", low="0"),
    Argument("E_1", "moment of inertia that the mode carries", "kg m^2", low="0", high="A"),
    Argument("b_1", "natural frequency of the mode, divided by the spin", low="0", high="1"),
    Argument("omega_0", "spin", "rad/s", low="0"),
    Output("eta_1", "frequency against the spin", "rad/s"),
    Output("eta_2", "frequency with the spin", "rad/s"),
    ulp=8,
    condition=(
        "The frequencies are differences of a root and a linear term; the error is in units of the last place of a "
        "bound of both, omega_0 / (A - E_1) times the sum of Delta, E_1 (1 - b_1) and b_1 (A - E_1); eight "
        "operations follow one another."
    ),
    claims={"1.33": "5dfcf91b92f9", "1.34.3": "d8869e67ad9a", "B.2": "1846771b4c5a", "B.18": "6199de6695fd"},
    forms="26816138ab42",
)
def frequencies(A, Delta, E_1, b_1, omega_0):
    """The two frequencies of a flattened body with one mode, which is stable.

    eta_1 = omega_0*((A*b_1 - Delta - E_1)/(2*A - 2*E_1) - sqrt(A**2*b_1**2 + 2*A*Delta*b_1 - 2*A*E_1*b_1 + Delta**2
        - 4*Delta*E_1*b_1 + 2*Delta*E_1 + E_1**2)/(2*A - 2*E_1))
    eta_2 = omega_0*((A*b_1 - Delta - E_1)/(2*A - 2*E_1) + sqrt(A**2*b_1**2 + 2*A*Delta*b_1 - 2*A*E_1*b_1 + Delta**2
        - 4*Delta*E_1*b_1 + 2*Delta*E_1 + E_1**2)/(2*A - 2*E_1))

    >>> [f"{x:.6g}" for x in frequencies(0.17, 0.33, 0.08, 0.67, 0.83)]
    ['-3.25124', '0.520539']
    """
    t1 = A - E_1
    t2 = b_1 * t1
    t6 = Delta + E_1 * (1.0 - b_1) - t2
    t11 = sqrt(4.0 * (Delta * t2) + t6 * t6)
    t13 = (1.0 / 2.0) * omega_0 / t1
    eta_1 = -(t13 * (t11 + t6))
    eta_2 = t13 * (t11 - t6)
    return eta_1, eta_2


KERNELS = {
    "mode_inertia": mode_inertia,
    "residue_of_a_mode": residue_of_a_mode,
    "characteristic_coefficients": characteristic_coefficients,
    "discriminant": discriminant,
    "boundary_of_stability": boundary_of_stability,
    "width_of_the_unstable_interval": width_of_the_unstable_interval,
    "critical_frequencies": critical_frequencies,
    "greatest_growth_rate": greatest_growth_rate,
    "frequencies": frequencies,
}
