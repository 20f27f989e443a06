"""Stability of a spinning symmetric body with ideal liquid that moves in modes: frequencies, growth rate, stability.

Motions are e^(i eta t) in axes that turn with the body. One mode goes through the kernels of the quadratic equation
(1.33). Several modes are an eigenvalue problem: with the partial fractions N.4 the characteristic equation (1.31) is

    eta - h - sum_n (R_n/m)/(eta - lambda_n) = 0,    R_n = E_n lambda_n (lambda_n - omega_0),
    m = A - sum_n E_n,    h = (sum_n E_n (lambda_n - omega_0) - (C - A) omega_0)/m,

which is that of the arrowhead matrix with h and lambda_n on its diagonal and sqrt|R_n/m| along its borders, with the
sign of R_n on one of them. Off the band between zero and the spin it is symmetric: the frequencies are real (N.13).
Decision: its eigenvalues by LAPACK, all parameters at once; not the roots of a polynomial of degree N + 1, which lose
digits with each mode.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symcheck.generated import esenkov2006
from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import Array, common_shape, evaluated, finite, positive, real, require
from symcheck.numeric.liquid.body import Body, checked_body

EPSILON = np.finfo(np.float64).eps  # what rounding may give to a real frequency is a multiple of it


class Stability(NamedTuple):
    """Frequencies of a body with liquid, and what they mean for it; see `stability`.

    Parameters
    ----------
    frequencies
        Frequencies, rad/s; shape (..., N + 1).
    growth_rate
        Growth rate, 1/s; shape (...).
    stable
        Whether no motion grows; shape (...).
    """

    frequencies: NDArray[np.complex128]
    growth_rate: Array
    stable: NDArray[np.bool_]


@gufunc("(),(),()->()")
def mode_inertia(a_n: ArrayLike, chi_n: ArrayLike, N_n: ArrayLike) -> Array:
    """The moment of inertia that a mode of the liquid carries, E_n = a_n chi_n / N_n^2.

    Parameters
    ----------
    a_n
        Angular momentum of the liquid for the amplitude 1 of the mode, kg m; any shape.
    chi_n
        Coupling of the mode to the turning body, m^4; its amplitude is counted so that a_n chi_n > 0.
    N_n
        Norm of the mode, m^(3/2); positive.

    Returns
    -------
    ndarray
        Moment of inertia E_n, kg m^2, of the broadcast shape.

    Raises
    ------
    ValueError
        If a number is not finite, N_n is not positive, or a mode carries nothing (B.1).

    Notes
    -----
    Source: (1.32), with the equation of the modes before it.

    Examples
    --------
    >>> mode_inertia([3.0, 1.0], 0.5, 2.0).tolist()
    [0.375, 0.125]
    """
    moment, coupling, norm = real("a_n", a_n), real("chi_n", chi_n), positive("N_n", N_n, "B.1")
    common_shape(a_n=moment, chi_n=coupling, N_n=norm)
    carried = evaluated("E_n", esenkov2006.mode_inertia, moment, coupling, norm)
    require(carried > 0, "E_n = a_n chi_n / N_n^2", carried, "be positive, as the mode carries inertia", "B.1")
    return carried


@gufunc("(),(),(n),(n),()->(frequency),(),()", frequency=lambda size: size["n"] + 1)
def stability(A: ArrayLike, C: ArrayLike, E_n: ArrayLike, lambda_n: ArrayLike, omega_0: ArrayLike) -> Stability:
    """The frequencies of the body with N modes, the rate at which its motion grows, and whether it is stable.

    The frequencies are the roots of

        A eta + (C - A) omega_0 - eta (eta - omega_0) sum_n E_n/(eta - lambda_n) = 0.

    Parameters
    ----------
    A
        Transverse moment of inertia with the liquid at rest, kg m^2; shape (...), positive.
    C
        Axial moment of inertia, kg m^2; shape (...), positive.
    E_n
        Moments of inertia that the modes carry, kg m^2; shape (..., N), positive, together less than A.
    lambda_n
        Natural frequencies of the modes, rad/s; shape (..., N).
    omega_0
        Spin, rad/s; shape (...), positive.

    Returns
    -------
    Stability
        ``frequencies``: eta in rad/s, complex, (..., N + 1), sorted by real, then imaginary part; in conjugate pairs.
        ``growth_rate``: max |Im eta| in 1/s, (...).
        ``stable``, (...): with one mode the discriminant of (1.33) is positive, with several all frequencies are real.
        On the boundary a frequency is double and the motion grows like t (B.5): one mode asks for more than real
        frequencies, as the paper does; with several modes rounding decides there.

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.

    Notes
    -----
    Accuracy: as if the entries of the matrix above, and for one mode the coefficients of (1.33), had errors of a few
    units in the last place of the greatest; that is as much for frequencies apart, and its square root, 1e-8, for
    double ones. Frequencies that are proved to be real are so exactly. With several modes an imaginary part that
    rounding alone can give to a real frequency, N + 1 units in the last place of the matrix's norm, is taken for 0.
    Source: (1.31), (1.33), 1.33.3; proved to be real off the band and for C >= A: N.13, N.17.

    Examples
    --------
    >>> found = stability(A=1.0, C=[0.5, 1.5], E_n=[0.2], lambda_n=[0.5], omega_0=1.0)
    >>> found.frequencies.round(6).tolist()
    [[(0.5-0.25j), (0.5+0.25j)], [(-0.697822+0j), (0.447822+0j)]]
    >>> found.growth_rate.round(6).tolist(), found.stable.tolist()
    ([0.25, 0.0], [False, True])
    """
    body = checked_body(A, C, E_n, lambda_n, omega_0)
    with np.errstate(all="ignore"):
        eta = _roots_of_the_quadratic(body) if _is_one_mode(body) else _eigenvalues(body)
        eta = np.sort(finite("a frequency", eta * body.rate[..., None]), axis=-1)
        rate = np.abs(eta.imag).max(-1)
        stable = _quadratic(body).discriminant > 0 if _is_one_mode(body) else rate == 0
    return Stability(eta, np.asarray(rate), np.asarray(stable))


@gufunc("(),(),(n),(n),()->(frequency)", frequency=lambda size: size["n"] + 1)
def frequencies(
    A: ArrayLike, C: ArrayLike, E_n: ArrayLike, lambda_n: ArrayLike, omega_0: ArrayLike
) -> NDArray[np.complex128]:
    """The frequencies eta alone.

    Parameters
    ----------
    A, C, E_n, lambda_n, omega_0
        As for `stability`.

    Returns
    -------
    ndarray
        Frequencies eta, rad/s; shape (..., N + 1).

    Raises
    ------
    ValueError
        As `stability` does.

    Notes
    -----
    Accuracy and sources are those of `stability`.

    Examples
    --------
    >>> frequencies(A=1.0, C=0.5, E_n=[0.2, 0.1], lambda_n=[0.5, -1.0], omega_0=1.0).round(6).tolist()
    [(-1.188412+0j), (0.487063-0.251576j), (0.487063+0.251576j)]
    """
    return stability(A, C, E_n, lambda_n, omega_0).frequencies


@gufunc("(),(),(n),(n),()->()")
def growth_rate(A: ArrayLike, C: ArrayLike, E_n: ArrayLike, lambda_n: ArrayLike, omega_0: ArrayLike) -> Array:
    """The rate max |Im eta| at which the fastest motion grows.

    Parameters
    ----------
    A, C, E_n, lambda_n, omega_0
        As for `stability`.

    Returns
    -------
    ndarray
        Shape (...), 1/s.

    Raises
    ------
    ValueError
        As `stability` does.

    Notes
    -----
    Accuracy and sources are those of `stability`.

    Examples
    --------
    >>> growth_rate(A=1.0, C=[0.4, 0.5, 1.5], E_n=[0.2], lambda_n=[0.5], omega_0=1.0).round(6).tolist()
    [0.242061, 0.25, 0.0]
    """
    return stability(A, C, E_n, lambda_n, omega_0).growth_rate


@gufunc("(),(),(n),(n),()->()")
def is_stable(A: ArrayLike, C: ArrayLike, E_n: ArrayLike, lambda_n: ArrayLike, omega_0: ArrayLike) -> NDArray[np.bool_]:
    """Whether no motion grows.

    Parameters
    ----------
    A, C, E_n, lambda_n, omega_0
        As for `stability`.

    Returns
    -------
    ndarray
        Shape (...).

    Raises
    ------
    ValueError
        As `stability` does.

    Notes
    -----
    Accuracy and sources are those of `stability`.

    Examples
    --------
    >>> is_stable(A=1.0, C=[0.5, 1.5], E_n=[0.2], lambda_n=[0.5], omega_0=1.0).tolist()
    [False, True]
    """
    return stability(A, C, E_n, lambda_n, omega_0).stable


# --- one mode


def _is_one_mode(body: Body) -> bool:
    return int(body.E_n.shape[-1]) == 1


class _Quadratic(NamedTuple):
    """The coefficients of (1.33), of eta^2 first, and its discriminant."""

    square: Array
    linear: Array
    constant: Array
    discriminant: Array


def _quadratic(body: Body) -> _Quadratic:
    arguments = body.A, body.C, body.E_n[..., 0], body.lambda_n[..., 0], body.omega_0
    square, linear, constant = map(np.asarray, esenkov2006.characteristic_coefficients(*arguments))
    return _Quadratic(square, linear, constant, np.asarray(esenkov2006.discriminant(*arguments)))


def _roots_of_the_quadratic(body: Body) -> NDArray[np.complex128]:
    """Two real roots by the greater one and their product, so that the lesser keeps its digits; or a conjugate pair."""
    square, linear, constant, discriminant = _quadratic(body)
    discriminant = np.where(body.not_long, np.maximum(discriminant, 0), discriminant)
    greater = -(linear + np.copysign(np.sqrt(np.maximum(discriminant, 0)), linear)) / 2
    lesser = np.divide(constant, greater, out=np.zeros_like(greater), where=greater != 0)
    pair = (1j * np.sqrt(np.maximum(-discriminant, 0)) - linear) / (2 * square)
    two_real, conjugates = (greater / square, lesser), (pair, pair.conj())
    return np.stack([np.where(discriminant < 0, *roots) for roots in zip(conjugates, two_real, strict=True)], -1)


# --- several modes


def _eigenvalues(body: Body) -> NDArray[np.complex128]:
    """Those of symmetric matrices apart: they are real, and take half the time."""
    matrix, symmetric = _arrowhead(body), body.off_the_band
    finite("the matrix of the modes", matrix)
    eta = np.empty(matrix.shape[:-1], np.complex128)
    eta[symmetric] = np.linalg.eigvalsh(matrix[symmetric])
    eta[~symmetric] = np.linalg.eigvals(matrix[~symmetric])
    rounding = matrix.shape[-1] * EPSILON * np.linalg.norm(matrix, axis=(-2, -1))
    eta.imag[(np.abs(eta.imag) <= rounding[..., None]) | body.not_long[..., None]] = 0
    return eta


def _arrowhead(body: Body) -> Array:
    rest, size = body.rest, body.E_n.shape[-1] + 1
    border = np.sqrt(np.abs(body.R_n) / rest[..., None])
    moment = (body.E_n * (body.lambda_n - body.omega_0[..., None])).sum(-1)
    matrix = np.zeros((*body.A.shape, size, size))
    matrix[..., 0, 0] = (moment - (body.C - body.A) * body.omega_0) / rest
    matrix[..., 0, 1:] = border
    matrix[..., 1:, 0] = np.copysign(border, body.R_n)
    matrix[..., range(1, size), range(1, size)] = body.lambda_n
    return matrix
