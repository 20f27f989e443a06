"""Kernels of esenkov2006. Written by `symcheck generate`: what is changed here is lost."""

import math

from symcheck.generated import _esenkov2006 as paths
from symcheck.kernels.runtime import kernel
from symcheck.kernels.specification import Argument, Output, Specification

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
    paths.mode_inertia,
    Specification(
        paper='esenkov2006',
        name='mode_inertia',
        says='The moment of inertia that a mode of the liquid carries.',
        arguments=(
            Argument('a_1', 'angular momentum of the liquid for the amplitude 1 of a mode of dimensionless shape', unit='kg m'),
            Argument('chi_1', 'coupling of the mode to the turning body', unit='m^4'),
            Argument('N_1', 'norm of the mode', unit='m^(3/2)', low='0'),
        ),
        outputs=(
            Output('E_1', 'moment of inertia of the mode', unit='kg m^2'),
        ),
        ulp=4,
        claims={
            'esenkov2006:1.32': '91c691dc84d1',
            'esenkov2006:B.1': 'd62232d82a4e',
        },
    ),
)
def mode_inertia(a_1, chi_1, N_1):
    """The moment of inertia that a mode of the liquid carries.

    Parameters
    ----------
    a_1 : float or ndarray
        Angular momentum of the liquid for the amplitude 1 of a mode of dimensionless shape, in kg m; any
        number.
    chi_1 : float or ndarray
        Coupling of the mode to the turning body, in m^4; any number.
    N_1 : float or ndarray
        Norm of the mode, in m^(3/2); 0 < N_1.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    E_1 : float or ndarray
        Moment of inertia of the mode, in kg m^2.

    Notes
    -----
    The function computes ::

        E_1 = a_1*chi_1/N_1**2

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on esenkov2006:1.32 (sha256 91c691dc84d1), esenkov2006:B.1 (sha256 d62232d82a4e).

    Examples
    --------
    >>> from symcheck.generated.esenkov2006 import mode_inertia
    >>> f"{mode_inertia(1.25, 1.5, 0.75):.6g}"
    '3.33333'
    """
    return a_1 * chi_1 / (N_1 * N_1)


@kernel(
    paths.residue_of_a_mode,
    Specification(
        paper='esenkov2006',
        name='residue_of_a_mode',
        says='Minus the residue of the characteristic equation at a natural frequency; modes with positive ones are harmless.',
        arguments=(
            Argument('E_1', 'moment of inertia that the mode carries', unit='kg m^2', low='0'),
            Argument('lambda_1', 'natural frequency of the mode', unit='rad/s'),
            Argument('omega_0', 'spin', unit='rad/s', low='0'),
        ),
        outputs=(
            Output('R_1', 'minus the residue', unit='kg m^2 rad^2/s^2'),
        ),
        ulp=4,
        claims={
            'esenkov2006:N.3': '10f423309148',
            'esenkov2006:N.5': 'b88788105c9d',
        },
        forms='1273b10d4eb2',
    ),
)
def residue_of_a_mode(E_1, lambda_1, omega_0):
    """Minus the residue of the characteristic equation at a natural frequency; modes with positive ones are harmless.

    Parameters
    ----------
    E_1 : float or ndarray
        Moment of inertia that the mode carries, in kg m^2; 0 < E_1.
    lambda_1 : float or ndarray
        Natural frequency of the mode, in rad/s; any number.
    omega_0 : float or ndarray
        Spin, in rad/s; 0 < omega_0.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    R_1 : float or ndarray
        Minus the residue, in kg m^2 rad^2/s^2.

    Notes
    -----
    The function computes ::

        R_1 = E_1*lambda_1**2 - E_1*lambda_1*omega_0

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on esenkov2006:N.3 (sha256 10f423309148), esenkov2006:N.5 (sha256 b88788105c9d). The forms computed are
    proved equal to those shown (sha256 1273b10d4eb2).

    Examples
    --------
    >>> from symcheck.generated.esenkov2006 import residue_of_a_mode
    >>> f"{residue_of_a_mode(0.25, 1.5, 0.75):.6g}"
    '0.28125'
    """
    return (lambda_1 - omega_0) * (E_1 * lambda_1)


@kernel(
    paths.characteristic_coefficients,
    Specification(
        paper='esenkov2006',
        name='characteristic_coefficients',
        says='Coefficients of the quadratic equation (1.33) for the frequencies.',
        arguments=(
            Argument('A', 'transverse moment of inertia, with the liquid at rest', unit='kg m^2', low='0'),
            Argument('C', 'axial moment of inertia', unit='kg m^2', low='0'),
            Argument('E_1', 'moment of inertia that the mode carries', unit='kg m^2', low='0', high='A'),
            Argument('lambda_1', 'natural frequency of the mode', unit='rad/s'),
            Argument('omega_0', 'spin', unit='rad/s', low='0'),
        ),
        outputs=(
            Output('c_2', 'coefficient of eta^2', unit='kg m^2'),
            Output('c_1', 'coefficient of eta', unit='kg m^2 rad/s'),
            Output('c_0', 'constant term', unit='kg m^2 rad^2/s^2'),
        ),
        ulp=4,
        condition='Where terms cancel, the error is in units of the last place of the largest of them.',
        claims={
            'esenkov2006:1.32': '91c691dc84d1',
            'esenkov2006:1.33': '5dfcf91b92f9',
        },
        forms='8d1a6c39f1e8',
    ),
)
def characteristic_coefficients(A, C, E_1, lambda_1, omega_0):
    """Coefficients of the quadratic equation (1.33) for the frequencies.

    Parameters
    ----------
    A : float or ndarray
        Transverse moment of inertia, with the liquid at rest, in kg m^2; 0 < A.
    C : float or ndarray
        Axial moment of inertia, in kg m^2; 0 < C.
    E_1 : float or ndarray
        Moment of inertia that the mode carries, in kg m^2; 0 < E_1 < A.
    lambda_1 : float or ndarray
        Natural frequency of the mode, in rad/s; any number.
    omega_0 : float or ndarray
        Spin, in rad/s; 0 < omega_0.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    c_2 : float or ndarray
        Coefficient of eta^2, in kg m^2.
    c_1 : float or ndarray
        Coefficient of eta, in kg m^2 rad/s.
    c_0 : float or ndarray
        Constant term, in kg m^2 rad^2/s^2.

    Notes
    -----
    The function computes ::

        c_2 = A - E_1
        c_1 = -A*lambda_1 - A*omega_0 + C*omega_0 + E_1*omega_0
        c_0 = A*lambda_1*omega_0 - C*lambda_1*omega_0

    Accuracy: 4 ulp over the domain. Where terms cancel, the error is in units of the last place of the largest of
    them.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on esenkov2006:1.32 (sha256 91c691dc84d1), esenkov2006:1.33 (sha256 5dfcf91b92f9). The forms computed
    are proved equal to those shown (sha256 8d1a6c39f1e8).

    Examples
    --------
    >>> from symcheck.generated.esenkov2006 import characteristic_coefficients
    >>> [f"{x:.6g}" for x in characteristic_coefficients(0.17, 0.33, 0.08, 1.67, 0.83)]
    ['0.09', '-0.0847', '-0.221776']
    """
    t1 = A - C
    return A - E_1, E_1 * omega_0 - A * lambda_1 - omega_0 * t1, omega_0 * (lambda_1 * t1)


@kernel(
    paths.discriminant,
    Specification(
        paper='esenkov2006',
        name='discriminant',
        says='The discriminant of the quadratic equation (1.33): the body is stable where it is positive.',
        arguments=(
            Argument('A', 'transverse moment of inertia, with the liquid at rest', unit='kg m^2', low='0'),
            Argument('C', 'axial moment of inertia', unit='kg m^2', low='0'),
            Argument('E_1', 'moment of inertia that the mode carries', unit='kg m^2', low='0', high='A'),
            Argument('lambda_1', 'natural frequency of the mode', unit='rad/s'),
            Argument('omega_0', 'spin', unit='rad/s', low='0'),
        ),
        outputs=(
            Output('D', 'discriminant in eta', unit='kg^2 m^4 rad^2/s^2'),
        ),
        ulp=10,
        condition='It is zero at the boundary of stability; the error is in units of the last place of what it were if nothing cancelled, the square of |C - A| omega_0 + E_1 omega_0 + A |lambda_1|; ten operations follow one another.',
        claims={
            'esenkov2006:1.33.3a': '85a55af1a21e',
            'esenkov2006:1.33.4': 'eef05166bf2c',
            'esenkov2006:B.2': '1846771b4c5a',
            'esenkov2006:B.6': '3465e26c0810',
        },
        forms='69b0e962ebfb',
    ),
)
def discriminant(A, C, E_1, lambda_1, omega_0):
    """The discriminant of the quadratic equation (1.33): the body is stable where it is positive.

    Parameters
    ----------
    A : float or ndarray
        Transverse moment of inertia, with the liquid at rest, in kg m^2; 0 < A.
    C : float or ndarray
        Axial moment of inertia, in kg m^2; 0 < C.
    E_1 : float or ndarray
        Moment of inertia that the mode carries, in kg m^2; 0 < E_1 < A.
    lambda_1 : float or ndarray
        Natural frequency of the mode, in rad/s; any number.
    omega_0 : float or ndarray
        Spin, in rad/s; 0 < omega_0.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    D : float or ndarray
        Discriminant in eta, in kg^2 m^4 rad^2/s^2.

    Notes
    -----
    The function computes ::

        D = A**2*lambda_1**2 - 2*A**2*lambda_1*omega_0 + A**2*omega_0**2 + 2*A*C*lambda_1*omega_0 - 2*A*C*omega_0**2 + 2*A*E_1*lambda_1*omega_0 - 2*A*E_1*omega_0**2 + C**2*omega_0**2 - 4*C*E_1*lambda_1*omega_0 + 2*C*E_1*omega_0**2 + E_1**2*omega_0**2

    Accuracy: 10 ulp over the domain. It is zero at the boundary of stability; the error is in units of the last
    place of what it were if nothing cancelled, the square of |C - A| omega_0 + E_1 omega_0 + A |lambda_1|; ten
    operations follow one another.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on esenkov2006:1.33.3a (sha256 85a55af1a21e), esenkov2006:1.33.4 (sha256 eef05166bf2c), esenkov2006:B.2
    (sha256 1846771b4c5a), esenkov2006:B.6 (sha256 3465e26c0810). The forms computed are proved equal to those
    shown (sha256 69b0e962ebfb).

    Examples
    --------
    >>> from symcheck.generated.esenkov2006 import discriminant
    >>> f"{discriminant(0.17, 0.33, 0.08, 1.67, 0.83):.6g}"
    '0.0870135'
    """
    t5 = E_1 * (lambda_1 - omega_0)
    t13 = omega_0 * (C - A) + lambda_1 * (A - E_1) - t5
    return t13 * t13 + (4.0 * A - 4.0 * E_1) * (lambda_1 * t5)


@kernel(
    paths.boundary_of_stability,
    Specification(
        paper='esenkov2006',
        name='boundary_of_stability',
        says='The two values of C - A between which the body is unstable.',
        arguments=(
            Argument('A', 'transverse moment of inertia, with the liquid at rest', unit='kg m^2', low='0'),
            Argument('E_1', 'moment of inertia that the mode carries', unit='kg m^2', low='0', high='A'),
            Argument('b_1', 'natural frequency of the mode, divided by the spin', low='0', high='1'),
        ),
        outputs=(
            Output('Delta_1', 'upper end', unit='kg m^2'),
            Output('Delta_2', 'lower end', unit='kg m^2'),
        ),
        ulp=4,
        condition='The upper end is zero where A b_1 = E_1; its error is in units of the last place of the larger of E_1 (1 - b_1) and b_1 (A - E_1).',
        claims={
            'esenkov2006:1.34.3': 'd8869e67ad9a',
            'esenkov2006:1.34.5': '5bd5d83cdfe1',
            'esenkov2006:1.35a': 'b5ffc014e2a4',
            'esenkov2006:1.35c': 'aa7f3e52c939',
            'esenkov2006:B.11': '742d7c68ca61',
        },
        forms='c587d73ba2b4',
    ),
)
def boundary_of_stability(A, E_1, b_1):
    """The two values of C - A between which the body is unstable.

    Parameters
    ----------
    A : float or ndarray
        Transverse moment of inertia, with the liquid at rest, in kg m^2; 0 < A.
    E_1 : float or ndarray
        Moment of inertia that the mode carries, in kg m^2; 0 < E_1 < A.
    b_1 : float or ndarray
        Natural frequency of the mode, divided by the spin, a number; 0 < b_1 < 1.
    out : sequence of ndarray, optional
        2 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    Delta_1 : float or ndarray
        Upper end, in kg m^2.
    Delta_2 : float or ndarray
        Lower end, in kg m^2.

    Notes
    -----
    The function computes ::

        Delta_1 = -A*b_1 + 2*sqrt(E_1)*sqrt(b_1)*sqrt(1 - b_1)*sqrt(A - E_1) + 2*E_1*b_1 - E_1
        Delta_2 = -A*b_1 - 2*sqrt(E_1)*sqrt(b_1)*sqrt(1 - b_1)*sqrt(A - E_1) + 2*E_1*b_1 - E_1

    Accuracy: 4 ulp over the domain. The upper end is zero where A b_1 = E_1; its error is in units of the last
    place of the larger of E_1 (1 - b_1) and b_1 (A - E_1).

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on esenkov2006:1.34.3 (sha256 d8869e67ad9a), esenkov2006:1.34.5 (sha256 5bd5d83cdfe1), esenkov2006:1.35a
    (sha256 b5ffc014e2a4), esenkov2006:1.35c (sha256 aa7f3e52c939), esenkov2006:B.11 (sha256 742d7c68ca61). The
    forms computed are proved equal to those shown (sha256 c587d73ba2b4).

    Examples
    --------
    >>> from symcheck.generated.esenkov2006 import boundary_of_stability
    >>> [f"{x:.6g}" for x in boundary_of_stability(0.25, 0.12, 0.75)]
    ['-0.0193335', '-0.235667']
    """
    t1 = 1.0 - b_1
    t2 = E_1 * t1
    t3 = A - E_1
    t4 = b_1 * t3
    t11 = t2 + 2.0 * (math.sqrt(t1 * t3) * (math.sqrt(E_1) * math.sqrt(b_1))) + t4
    t12 = 1.0 / t11
    return (t2 - t4) * (b_1 * (t12 * t3) - t12 * t2), -t11


@kernel(
    paths.width_of_the_unstable_interval,
    Specification(
        paper='esenkov2006',
        name='width_of_the_unstable_interval',
        says='The length of the interval of C - A in which the body is unstable.',
        arguments=(
            Argument('A', 'transverse moment of inertia, with the liquid at rest', unit='kg m^2', low='0'),
            Argument('E_1', 'moment of inertia that the mode carries', unit='kg m^2', low='0', high='A'),
            Argument('b_1', 'natural frequency of the mode, divided by the spin', low='0', high='1'),
        ),
        outputs=(
            Output('width', 'length of the interval', unit='kg m^2'),
        ),
        ulp=4,
        claims={
            'esenkov2006:1.34.4': 'd7e201757da1',
            'esenkov2006:B.16': '4515d9596d9c',
            'esenkov2006:B.28': 'd39dfa450602',
        },
        forms='69c2846fab1b',
    ),
)
def width_of_the_unstable_interval(A, E_1, b_1):
    """The length of the interval of C - A in which the body is unstable.

    Parameters
    ----------
    A : float or ndarray
        Transverse moment of inertia, with the liquid at rest, in kg m^2; 0 < A.
    E_1 : float or ndarray
        Moment of inertia that the mode carries, in kg m^2; 0 < E_1 < A.
    b_1 : float or ndarray
        Natural frequency of the mode, divided by the spin, a number; 0 < b_1 < 1.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    width : float or ndarray
        Length of the interval, in kg m^2.

    Notes
    -----
    The function computes ::

        width = 4*sqrt(E_1)*sqrt(b_1)*sqrt(1 - b_1)*sqrt(A - E_1)

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on esenkov2006:1.34.4 (sha256 d7e201757da1), esenkov2006:B.16 (sha256 4515d9596d9c), esenkov2006:B.28
    (sha256 d39dfa450602). The forms computed are proved equal to those shown (sha256 69c2846fab1b).

    Examples
    --------
    >>> from symcheck.generated.esenkov2006 import width_of_the_unstable_interval
    >>> f"{width_of_the_unstable_interval(0.25, 0.12, 0.75):.6g}"
    '0.216333'
    """
    return 4.0 * (math.sqrt((1.0 - b_1) * (A - E_1)) * (math.sqrt(E_1) * math.sqrt(b_1)))


@kernel(
    paths.critical_frequencies,
    Specification(
        paper='esenkov2006',
        name='critical_frequencies',
        says='The double frequencies at the two ends of the interval in which the body is unstable.',
        arguments=(
            Argument('A', 'transverse moment of inertia, with the liquid at rest', unit='kg m^2', low='0'),
            Argument('E_1', 'moment of inertia that the mode carries', unit='kg m^2', low='0', high='A'),
            Argument('b_1', 'natural frequency of the mode, divided by the spin', low='0', high='1'),
            Argument('omega_0', 'spin', unit='rad/s', low='0'),
        ),
        outputs=(
            Output('eta_1', 'frequency at the upper end', unit='rad/s'),
            Output('eta_2', 'frequency at the lower end', unit='rad/s'),
        ),
        ulp=4,
        condition='The frequency at the upper end is zero where A b_1 = E_1. Where terms cancel, the error is in units of the last place of the largest of them.',
        claims={
            'esenkov2006:B.4': '0e6afd49f325',
            'esenkov2006:B.26': '520e09812ec5',
            'esenkov2006:B.27': '416470da3f23',
        },
    ),
)
def critical_frequencies(A, E_1, b_1, omega_0):
    """The double frequencies at the two ends of the interval in which the body is unstable.

    Parameters
    ----------
    A : float or ndarray
        Transverse moment of inertia, with the liquid at rest, in kg m^2; 0 < A.
    E_1 : float or ndarray
        Moment of inertia that the mode carries, in kg m^2; 0 < E_1 < A.
    b_1 : float or ndarray
        Natural frequency of the mode, divided by the spin, a number; 0 < b_1 < 1.
    omega_0 : float or ndarray
        Spin, in rad/s; 0 < omega_0.
    out : sequence of ndarray, optional
        2 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    eta_1 : float or ndarray
        Frequency at the upper end, in rad/s.
    eta_2 : float or ndarray
        Frequency at the lower end, in rad/s.

    Notes
    -----
    The function computes ::

        eta_1 = omega_0*(-sqrt(E_1)*sqrt(-b_1*(b_1 - 1)/(A - E_1)) + b_1)
        eta_2 = omega_0*(sqrt(E_1)*sqrt(-b_1*(b_1 - 1)/(A - E_1)) + b_1)

    Accuracy: 4 ulp over the domain. The frequency at the upper end is zero where A b_1 = E_1. Where terms cancel,
    the error is in units of the last place of the largest of them.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on esenkov2006:B.4 (sha256 0e6afd49f325), esenkov2006:B.26 (sha256 520e09812ec5), esenkov2006:B.27
    (sha256 416470da3f23).

    Examples
    --------
    >>> from symcheck.generated.esenkov2006 import critical_frequencies
    >>> [f"{x:.6g}" for x in critical_frequencies(0.2, 0.08, 0.6, 0.8)]
    ['0.16', '0.8']
    """
    t7 = math.sqrt(E_1) * math.sqrt(-(b_1 * (b_1 - 1.0) / (A - E_1)))
    return omega_0 * (b_1 - t7), omega_0 * (b_1 + t7)


@kernel(
    paths.greatest_growth_rate,
    Specification(
        paper='esenkov2006',
        name='greatest_growth_rate',
        says='The rate at which the motion grows in the middle of the interval in which the body is unstable; nowhere is it greater.',
        arguments=(
            Argument('A', 'transverse moment of inertia, with the liquid at rest', unit='kg m^2', low='0'),
            Argument('E_1', 'moment of inertia that the mode carries', unit='kg m^2', low='0', high='A'),
            Argument('b_1', 'natural frequency of the mode, divided by the spin', low='0', high='1'),
            Argument('omega_0', 'spin', unit='rad/s', low='0'),
        ),
        outputs=(
            Output('y', 'growth rate', unit='1/s'),
        ),
        ulp=4,
        claims={
            'esenkov2006:B.6': '3465e26c0810',
            'esenkov2006:B.7': 'e0d23e2e841f',
            'esenkov2006:B.8': '274537c8998c',
        },
    ),
)
def greatest_growth_rate(A, E_1, b_1, omega_0):
    """The rate at which the motion grows in the middle of the interval in which the body is unstable; nowhere is it greater.

    Parameters
    ----------
    A : float or ndarray
        Transverse moment of inertia, with the liquid at rest, in kg m^2; 0 < A.
    E_1 : float or ndarray
        Moment of inertia that the mode carries, in kg m^2; 0 < E_1 < A.
    b_1 : float or ndarray
        Natural frequency of the mode, divided by the spin, a number; 0 < b_1 < 1.
    omega_0 : float or ndarray
        Spin, in rad/s; 0 < omega_0.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    y : float or ndarray
        Growth rate, in 1/s.

    Notes
    -----
    The function computes ::

        y = sqrt(E_1)*omega_0*sqrt(-b_1*(b_1 - 1)/(A - E_1))

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on esenkov2006:B.6 (sha256 3465e26c0810), esenkov2006:B.7 (sha256 e0d23e2e841f), esenkov2006:B.8 (sha256
    274537c8998c).

    Examples
    --------
    >>> from symcheck.generated.esenkov2006 import greatest_growth_rate
    >>> f"{greatest_growth_rate(0.2, 0.08, 0.6, 0.8):.6g}"
    '0.32'
    """
    return math.sqrt(-(b_1 * (b_1 - 1.0) / (A - E_1))) * (omega_0 * math.sqrt(E_1))


@kernel(
    paths.frequencies,
    Specification(
        paper='esenkov2006',
        name='frequencies',
        says='The two frequencies of a flattened body with one mode, which is stable.',
        arguments=(
            Argument('A', 'transverse moment of inertia, with the liquid at rest', unit='kg m^2', low='0'),
            Argument('Delta', 'C - A: a flattened body', unit='kg m^2', low='0'),
            Argument('E_1', 'moment of inertia that the mode carries', unit='kg m^2', low='0', high='A'),
            Argument('b_1', 'natural frequency of the mode, divided by the spin', low='0', high='1'),
            Argument('omega_0', 'spin', unit='rad/s', low='0'),
        ),
        outputs=(
            Output('eta_1', 'frequency against the spin', unit='rad/s'),
            Output('eta_2', 'frequency with the spin', unit='rad/s'),
        ),
        ulp=8,
        condition='The frequencies are differences of a root and a linear term; the error is in units of the last place of a bound of both, omega_0 / (A - E_1) times the sum of Delta, E_1 (1 - b_1) and b_1 (A - E_1); eight operations follow one another.',
        claims={
            'esenkov2006:1.33': '5dfcf91b92f9',
            'esenkov2006:1.34.3': 'd8869e67ad9a',
            'esenkov2006:B.2': '1846771b4c5a',
            'esenkov2006:B.18': '6199de6695fd',
        },
        forms='26816138ab42',
    ),
)
def frequencies(A, Delta, E_1, b_1, omega_0):
    """The two frequencies of a flattened body with one mode, which is stable.

    Parameters
    ----------
    A : float or ndarray
        Transverse moment of inertia, with the liquid at rest, in kg m^2; 0 < A.
    Delta : float or ndarray
        C - A: a flattened body, in kg m^2; 0 < Delta.
    E_1 : float or ndarray
        Moment of inertia that the mode carries, in kg m^2; 0 < E_1 < A.
    b_1 : float or ndarray
        Natural frequency of the mode, divided by the spin, a number; 0 < b_1 < 1.
    omega_0 : float or ndarray
        Spin, in rad/s; 0 < omega_0.
    out : sequence of ndarray, optional
        2 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    eta_1 : float or ndarray
        Frequency against the spin, in rad/s.
    eta_2 : float or ndarray
        Frequency with the spin, in rad/s.

    Notes
    -----
    The function computes ::

        eta_1 = omega_0*((A*b_1 - Delta - E_1)/(2*A - 2*E_1) - sqrt(A**2*b_1**2 + 2*A*Delta*b_1 - 2*A*E_1*b_1 + Delta**2 - 4*Delta*E_1*b_1 + 2*Delta*E_1 + E_1**2)/(2*A - 2*E_1))
        eta_2 = omega_0*((A*b_1 - Delta - E_1)/(2*A - 2*E_1) + sqrt(A**2*b_1**2 + 2*A*Delta*b_1 - 2*A*E_1*b_1 + Delta**2 - 4*Delta*E_1*b_1 + 2*Delta*E_1 + E_1**2)/(2*A - 2*E_1))

    Accuracy: 8 ulp over the domain. The frequencies are differences of a root and a linear term; the error is in
    units of the last place of a bound of both, omega_0 / (A - E_1) times the sum of Delta, E_1 (1 - b_1) and b_1
    (A - E_1); eight operations follow one another.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on esenkov2006:1.33 (sha256 5dfcf91b92f9), esenkov2006:1.34.3 (sha256 d8869e67ad9a), esenkov2006:B.2
    (sha256 1846771b4c5a), esenkov2006:B.18 (sha256 6199de6695fd). The forms computed are proved equal to those
    shown (sha256 26816138ab42).

    Examples
    --------
    >>> from symcheck.generated.esenkov2006 import frequencies
    >>> [f"{x:.6g}" for x in frequencies(0.17, 0.33, 0.08, 0.67, 0.83)]
    ['-3.25124', '0.520539']
    """
    t1 = A - E_1
    t2 = b_1 * t1
    t6 = Delta + E_1 * (1.0 - b_1) - t2
    t11 = math.sqrt(4.0 * (Delta * t2) + t6 * t6)
    t13 = (1.0 / 2.0) * omega_0 / t1
    return -(t13 * (t11 + t6)), t13 * (t11 - t6)


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
