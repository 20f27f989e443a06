"""Where a spinning body with liquid becomes unstable: intervals of C - A, and maps over C - A and a mode's frequency.

The characteristic equation (1.31) is linear in C - A. So a double frequency, which every boundary of stability has, is
a zero of its slope N.10, in which C - A does not occur,

    A - sum_n E_n + sum_n R_n/(eta - lambda_n)^2 = 0,    R_n = E_n lambda_n (lambda_n - omega_0),

and (1.31) itself then tells the C - A. For one mode this is (1.35), which has a kernel.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symcheck.generated import esenkov2006
from symcheck.numeric.arrays import results
from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import Array, common_shape, exact, finite, in_one_library, number, positive, real, require
from symcheck.numeric.liquid.body import Body, checked_body
from symcheck.numeric.liquid.spectrum import EPSILON, growth_rate, stability


class BoundaryOfStability(NamedTuple):
    """The interval of C - A in which a body with one mode is unstable; all arrays have one shape (...).

    Parameters
    ----------
    lower
        Lower end Delta_2, kg m^2.
    upper
        Upper end Delta_1, kg m^2.
    width
        Upper less lower end, without cancellation, kg m^2.
    lower_frequency
        Double frequency at the lower end, rad/s.
    upper_frequency
        Double frequency at the upper end, rad/s.
    greatest_growth_rate
        Growth rate midway between the ends, 1/s.
    """

    lower: Array
    upper: Array
    width: Array
    lower_frequency: Array
    upper_frequency: Array
    greatest_growth_rate: Array


@dataclass(frozen=True, eq=False)
class StabilityMap:
    """Growth rate and stability over C - A and the frequency of one mode.

    Parameters
    ----------
    A
        Transverse moment of inertia, kg m^2.
    E_n
        Moments of inertia of the modes, kg m^2; shape (N,).
    Delta
        Values of C - A, kg m^2; shape (p,).
    b_1
        Natural frequency of the first mode, divided by the spin; shape (q,).
    further_b
        Natural frequencies of the other modes, divided by the spin; shape (N - 1,).
    omega_0
        Spin, rad/s.
    growth_rate
        Growth rate, 1/s; shape (q, p).
    stable
        Whether no motion grows; shape (q, p).
    """

    A: float
    E_n: Array
    Delta: Array
    b_1: Array
    further_b: Array
    omega_0: float
    growth_rate: Array
    stable: NDArray[np.bool_]


@gufunc("(),(),(),()->(),(),(),(),(),()")
def boundary_of_stability(
    A: ArrayLike, E_1: ArrayLike, b_1: ArrayLike, omega_0: ArrayLike = 1.0
) -> BoundaryOfStability:
    """The two values of C - A between which a body with one mode is unstable, with what happens there.

        Delta_(1,2) = -(sqrt(E_1 (1 - b_1)) -+ sqrt(b_1 (A - E_1)))^2.

    Parameters
    ----------
    A
        Transverse moment of inertia with the liquid at rest, kg m^2; shape (...), positive.
    E_1
        Moment of inertia that the mode carries, kg m^2; shape (...), 0 < E_1 < A.
    b_1
        Natural frequency of the mode, divided by the spin; shape (...), 0 <= b_1 <= 1.
    omega_0
        Spin, rad/s; shape (...), positive.

    Returns
    -------
    BoundaryOfStability
        The ends of the interval, and what happens there.

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it. Outside 0 <= b_1 <= 1 every body is stable and there is no
        boundary (B.9, B.10).

    Notes
    -----
    Accuracy: that of the kernels, 4 ulp of the greater of E_1 (1 - b_1) and b_1 (A - E_1). Source: (1.35) with its sign
    corrected, B.11, B.16, B.26, B.27.

    Examples
    --------
    >>> found = boundary_of_stability(A=1.0, E_1=0.2, b_1=[0.5, 1.0])
    >>> found.lower.round(6).tolist(), found.upper.round(6).tolist()
    ([-0.9, -0.8], [-0.1, -0.8])
    >>> found.greatest_growth_rate.round(6).tolist()
    [0.25, 0.0]
    """
    whole, carried, spin = positive("A", A, "1.35"), positive("E_1", E_1, "1.35"), positive("omega_0", omega_0, "1.35")
    whole, carried, spin, ratio = in_one_library(whole, carried, spin, real("b_1", b_1))
    common_shape(A=whole, E_1=carried, b_1=ratio, omega_0=spin)
    require(carried < whole, "E_1", carried, "be less than A, as the liquid is a part of the body", "B.25")
    require(
        (ratio >= 0) & (ratio <= 1), "b_1", ratio, "lie in 0 <= b_1 <= 1: elsewhere every body is stable", "B.9, B.10"
    )
    with np.errstate(all="ignore"):
        upper, lower = esenkov2006.boundary_of_stability(whole, carried, ratio)
        width = esenkov2006.width_of_the_unstable_interval(whole, carried, ratio)
        at_upper, at_lower = esenkov2006.critical_frequencies(whole, carried, ratio, spin)
        rate = abs(esenkov2006.greatest_growth_rate(whole, carried, ratio, spin))
    parts = results(lower, upper, width, at_lower, at_upper, rate)
    return BoundaryOfStability(*(finite("a result", part) for part in parts))


def unstable_intervals(A: float, E_n: ArrayLike, lambda_n: ArrayLike, omega_0: float) -> Array:
    """All intervals of C - A in which a body with N modes is unstable, in rising order, those that overlap as one.

    Parameters
    ----------
    A
        Transverse moment of inertia with the liquid at rest, kg m^2; positive.
    E_n
        Moments of inertia that the modes carry, kg m^2; shape (N,), positive, together less than A.
    lambda_n
        Natural frequencies of the modes, rad/s; shape (N,).
    omega_0
        Spin, rad/s; positive.

    Returns
    -------
    ndarray
        Ends of the intervals, kg m^2; shape (m, 2), 0 <= m <= N. There are none where no natural frequency lies between
        zero and the spin (N.13).

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.

    Notes
    -----
    One set of parameters at a time, as m depends on it. Accuracy: that of eigenvalues of a matrix of 2 N rows. Missing
    are intervals that are points (a mode at zero or at the spin, N.18) or in which the growth rate is lost in rounding.
    Source: (1.31), N.4, N.10; N.17 for their place below zero.

    Examples
    --------
    >>> unstable_intervals(A=1.0, E_n=[0.2], lambda_n=[0.5], omega_0=1.0).round(6).tolist()
    [[-0.9, -0.1]]
    >>> unstable_intervals(A=1.0, E_n=[0.01, 0.002], lambda_n=[0.2, 0.8], omega_0=1.0).round(6).tolist()
    [[-0.836951, -0.765987], [-0.284947, -0.125982]]
    """
    whole, spin = number("A", A), number("omega_0", omega_0)
    body = checked_body(whole, whole, exact("E_n", E_n, (None,)), exact("lambda_n", lambda_n, (None,)), spin)
    least = -body.A * (1 - EPSILON)  # C is positive, and where C >= A the body is stable (N.17)
    critical = np.unique(np.clip(_critical_moments(body), least, 0))
    middles = body.A + (critical[1:] + critical[:-1]) / 2
    unstable = growth_rate(body.A, middles, body.E_n, body.lambda_n, body.omega_0) > 0
    change = np.diff(np.concatenate([[0], unstable, [0]]).astype(int))[: critical.size]
    return np.stack([critical[change > 0], critical[change < 0]], -1) * body.moment


def stability_map(
    A: float,
    E_n: ArrayLike,
    Delta: ArrayLike,
    b_1: ArrayLike,
    omega_0: float = 1.0,
    further_b: ArrayLike = (),
) -> StabilityMap:
    """Growth rate and stability of a body with N modes over C - A and the frequency of its first mode.

    Parameters
    ----------
    A, E_n
        As for `unstable_intervals`.
    Delta
        Values of C - A, kg m^2; shape (p,), greater than -A.
    b_1
        Natural frequency of the first mode, divided by the spin; shape (q,).
    omega_0
        Spin, rad/s; positive.
    further_b
        Natural frequencies of the other modes, divided by the spin; shape (N - 1,).

    Returns
    -------
    StabilityMap
        Growth rate and stability, of shape (q, p).

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.

    Notes
    -----
    Accuracy and sources are those of `growth_rate` and `is_stable`.

    Examples
    --------
    >>> found = stability_map(1.0, [0.2], Delta=[-0.95, -0.5, 0.5], b_1=[0.5, 1.5])
    >>> found.growth_rate.round(6).tolist()
    [[0.0, 0.25, 0.0], [0.0, 0.0, 0.0]]
    >>> found.stable.tolist()
    [[True, False, True], [True, True, True]]
    """
    whole, spin, carried = number("A", A), number("omega_0", omega_0), exact("E_n", E_n, (None,))
    columns, rows, others = (
        exact("Delta", Delta, (None,)),
        exact("b_1", b_1, (None,)),
        real("further_b", further_b, (carried.size - 1,)),
    )
    require(columns > -whole, "Delta", columns, f"be greater than -A = {-whole}, as C = A + Delta is positive", "N.17")
    ratios = np.column_stack([rows, np.tile(others, (rows.size, 1))])
    _, rates, stable = stability(whole, whole + columns, carried, spin * ratios[:, None], spin)
    return StabilityMap(whole, carried, columns, rows, others, spin, rates, stable)


def _critical_moments(body: Body) -> Array:
    """The C - A at which (1.31) has a double root, and others: it is solved for C - A, with N.4, at those roots."""
    poles, rest = body.R_n != 0, body.rest
    residues, natural = body.R_n[poles], body.lambda_n[poles]
    double = _zeros_of_the_slope(residues / rest, natural)
    with np.errstate(divide="ignore"):  # a zero that rounding puts on a pole is not one; it goes far away
        fractions = residues / (double[:, None] - natural)
    moment = (body.E_n * (body.lambda_n - body.omega_0)).sum()
    return np.asarray((moment + fractions.sum(-1) - rest * double) / body.omega_0)


def _zeros_of_the_slope(residues: Array, natural: Array) -> Array:
    """Real parts of the zeros of 1 + sum R_n/(eta - lambda_n)^2, whether they are real or not.

    Those that are not only divide an interval; but rounding may split a double one, which bounds it, into such a pair.
    s/(eta - lambda)^2 is an entry of the resolvent of the Jordan block ((lambda, s), (0, lambda)), so they are the
    eigenvalues of a change of rank one of N such blocks; with s = sqrt|R_n| what is added has the size of s too.
    """
    size, roots = 2 * natural.size, np.sqrt(np.abs(residues))
    matrix = np.diag(np.repeat(natural, 2))
    matrix[range(0, size, 2), range(1, size, 2)] = roots
    matrix[1::2, ::2] -= np.sqrt(roots)[:, None] * np.copysign(np.sqrt(roots), residues)
    return np.asarray(np.linalg.eigvals(matrix).real)
