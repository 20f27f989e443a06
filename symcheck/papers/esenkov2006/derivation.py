"""Esenkov 2006 from first principles: a spinning symmetric body whose liquid moves in modes.

Premises: the law of angular momentum of the body with its liquid, in axes that turn with the body, and one linear
oscillator equation for each mode, driven by the angular acceleration. Nothing printed as a result is known here.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from symcheck.core.lazy import lazy
from symcheck.mechanics import inertia

if TYPE_CHECKING:
    from sympy import Expr

sp = lazy("sympy")

CLOCKWISE, ANTICLOCKWISE = -1, 1  # Omega = Omega_x - i Omega_y, Omega = Omega_x + i Omega_y


def _real(name: str) -> Expr:
    return sp.Symbol(name, real=True)


def _mode(letter: str, n: int) -> Expr:
    return _real(f"{letter}_{n}")


@cache
def momentum_law(sense: int) -> tuple[Expr, Expr, Expr, Expr]:
    """Coefficients (of Omega', i Omega, k', i k) in the linearised law of angular momentum without torque.

    The transverse components are joined as Omega = Omega_x + sense i Omega_y; k is the angular momentum of the liquid
    relative to the body, joined likewise. Conjugates of Omega and k drop out.
    """
    x, y, dx, dy, kx, ky, dkx, dky = sp.symbols("Omega_x Omega_y dOmega_x dOmega_y k_x k_y dk_x dk_y", real=True)
    tensor, rate = sp.diag(_real("A"), _real("A"), _real("C")), sp.Matrix([x, y, _real("omega_0")])
    liquid, change = sp.Matrix([kx, ky, 0]), sp.Matrix([dkx, dky, 0])
    law = inertia.euler_residual(tensor, rate, sp.Matrix([dx, dy, 0]), sp.zeros(3, 1)) + change + rate.cross(liquid)
    turn = sense * sp.I
    joined = sp.expand(law[0] + turn * law[1])
    whole = sp.symbols("dOmega Omega dk k")
    for letter, first, second in zip(whole, (dx, x, dkx, kx), (dy, y, dky, ky), strict=True):
        joined = joined.subs(first, letter - turn * second)
    joined = sp.expand(joined)
    found = tuple(
        sp.expand(joined.coeff(letter) / unit) for letter, unit in zip(whole, (1, sp.I, 1, sp.I), strict=True)
    )
    rest = sp.expand(joined - sum(c * u * v for c, u, v in zip(found, (1, sp.I, 1, sp.I), whole, strict=True)))
    if rest != 0:
        raise ArithmeticError(f"the law of angular momentum does not join into one complex equation: {rest} is left")
    return found[0], found[1], found[2], found[3]


def signs_of_the_momentum_law(sense: int) -> dict[str, Expr]:
    """The coefficients of i Omega and of i k as g and h."""
    _, spin, _, liquid = momentum_law(sense)
    return {"g": spin, "h": liquid}


@cache
def _amplitude_equation(modes: int, sense: int, direction: int) -> Expr:
    """What the law becomes for e^{pt}, p = direction i eta, with the amplitudes of the modes eliminated, divided by
    direction i. Mode n: N_n^2 (S_n' - p_n S_n) + chi_n Omega' = 0 with p_n = direction i lambda_n, k = sum a_n S_n."""
    acceleration, spin, change, liquid = momentum_law(sense)
    unit, eta = direction * sp.I, _real("eta")
    p = unit * eta
    total = acceleration * p + sp.I * spin
    for n in range(1, modes + 1):
        amplitude = sp.Symbol("amplitude")
        equation = _mode("N", n) ** 2 * (p - unit * _mode("lambda", n)) * amplitude + _mode("chi", n) * p
        [value] = sp.solve(equation, amplitude)
        total += (change * p + sp.I * liquid) * _mode("a", n) * value
    return sum((sp.factor(sp.simplify(addend / unit)) for addend in sp.Add.make_args(total)), sp.Integer(0))


def characteristic_equation(modes: int) -> tuple[Expr, ...]:
    """Left side of the characteristic equation for p = i eta, Omega = Omega_x - i Omega_y."""
    return (_amplitude_equation(modes, CLOCKWISE, 1),)


def mode_inertias(modes: int = 3) -> dict[str, Expr]:
    """E_n = a_n chi_n / N_n^2."""
    return {f"E_{n}": _mode("a", n) * _mode("chi", n) / _mode("N", n) ** 2 for n in range(1, modes + 1)}


def characteristic_equations_by_signs() -> dict[str, Expr]:
    """One mode: F, G for Omega_x + i Omega_y, whose law has i(A - C), and H, K for Omega_x - i Omega_y, whose law has
    i(C - A); F, H with p = i eta, G, K with p = -i eta."""
    signs = [(sense, direction) for sense in (ANTICLOCKWISE, CLOCKWISE) for direction in (1, -1)]
    equations = {letter: _amplitude_equation(1, *pair) for letter, pair in zip("FGHK", signs, strict=True)}
    return {**mode_inertias(1), **equations}


# --- in terms of E_n


@cache
def characteristic_function(modes: int) -> Expr:
    """The same left side in E_n."""
    [equation] = characteristic_equation(modes)
    inverse = {_mode("a", n): _mode("E", n) * _mode("N", n) ** 2 / _mode("chi", n) for n in range(1, modes + 1)}
    return sum((sp.factor(addend.subs(inverse)) for addend in sp.Add.make_args(equation)), sp.Integer(0))


@cache
def characteristic_polynomial(modes: int) -> Expr:
    """The left side times all eta - lambda_n."""
    product = sp.prod([_real("eta") - _mode("lambda", n) for n in range(1, modes + 1)])
    return sp.expand(sp.cancel(characteristic_function(modes) * product))


def quadratic() -> tuple[Expr, ...]:
    """One mode: the polynomial of degree two."""
    return (characteristic_polynomial(1),)


@cache
def discriminant() -> Expr:
    """Its discriminant in eta."""
    return sp.expand(sp.discriminant(characteristic_polynomial(1), _real("eta")))


def stability_boundary() -> tuple[Expr, ...]:
    """The discriminant, zero at the boundary of stability."""
    return (discriminant(),)


def stability_boundary_by_spin() -> tuple[Expr, ...]:
    """The discriminant divided by the square of the spin."""
    return (sp.expand(discriminant() / _real("omega_0") ** 2),)


@cache
def boundary_in_delta() -> tuple[Expr, ...]:
    """The same in Delta = C - A and b_1 = lambda_1 / omega_0."""
    [boundary] = stability_boundary_by_spin()
    values = {_real("C"): _real("A") + _real("Delta"), _real("lambda_1"): _real("b_1") * _real("omega_0")}
    return (sp.expand(boundary.subs(values)),)


def discriminant_in_eta() -> dict[str, Expr]:
    """D, the discriminant of the quadratic in eta."""
    return {"D": discriminant()}


def discriminant_in_delta() -> dict[str, Expr]:
    """D, the discriminant of the boundary as a quadratic in Delta."""
    return {"D": sp.expand(sp.discriminant(boundary_in_delta()[0], _real("Delta")))}


# --- roots that are not real


def _at_complex_frequency(function: Expr) -> Expr:
    x, y = _real("x"), _real("y")
    return function.subs(_real("eta"), x + sp.I * y)


def quadratic_at_complex_frequency() -> dict[str, Expr]:
    """Real part u and imaginary part v of the quadratic at x + i y."""
    u, v = sp.expand(_at_complex_frequency(characteristic_polynomial(1))).as_real_imag()
    return {"u": u, "v": v}


def _imaginary_part(function: Expr) -> Expr:
    """Imaginary part at x + i y, fraction by fraction."""
    parts = [sp.factor(_at_complex_frequency(addend)) for addend in sp.Add.make_args(function)]
    return sum((sp.factor(sp.im(sp.expand_complex(part))) for part in parts), sp.Integer(0))


def imaginary_part(modes: int) -> dict[str, Expr]:
    """The imaginary part u of the characteristic function at x + i y."""
    return {"u": _imaginary_part(characteristic_function(modes))}


def imaginary_part_of_the_poles(modes: int) -> dict[str, Expr]:
    """The imaginary part v of the characteristic function divided by eta (eta - omega_0)."""
    eta = _real("eta")
    divided = [
        sp.apart(sp.cancel(addend / (eta * (eta - _real("omega_0")))), eta)
        for addend in sp.Add.make_args(characteristic_function(modes))
    ]
    return {"v": _imaginary_part(sum(divided, sp.Integer(0)))}


# --- several modes


def left_side(modes: int) -> dict[str, Expr]:
    """The characteristic function as F."""
    return {"F": characteristic_function(modes)}


def values_at_natural_frequencies(modes: int) -> dict[str, Expr]:
    """P_k, the characteristic polynomial at eta = lambda_k, and its leading coefficient L."""
    polynomial, eta = characteristic_polynomial(modes), _real("eta")
    values = {f"P_{k}": sp.factor(polynomial.subs(eta, _mode("lambda", k))) for k in range(1, modes + 1)}
    return {**values, "L": sp.LC(polynomial, eta)}


def minus_residues(modes: int) -> dict[str, Expr]:
    """R_n, minus the residue of the characteristic function at eta = lambda_n."""
    values = values_at_natural_frequencies(modes)
    return {
        f"R_{n}": sp.cancel(
            -values[f"P_{n}"]
            / sp.prod([_mode("lambda", n) - _mode("lambda", k) for k in range(1, modes + 1) if k != n])
        )
        for n in range(1, modes + 1)
    }


def two_neighbouring_poles() -> dict[str, Expr]:
    """V_k: R_1/(lambda_1 - eta) + R_2/(lambda_2 - eta) + h times (eta - lambda_1)(eta - lambda_2) at eta = lambda_k."""
    eta, first, second = _real("eta"), _mode("lambda", 1), _mode("lambda", 2)
    function = _real("R_1") / (first - eta) + _real("R_2") / (second - eta) + _real("h")
    cleared = sp.cancel(function * (eta - first) * (eta - second))
    return {f"V_{k}": sp.factor(cleared.subs(eta, at)) for k, at in ((1, first), (2, second))}


# --- one mode, for kernels


def characteristic_coefficients() -> dict[str, Expr]:
    """Coefficients c_2, c_1, c_0 of the quadratic in eta."""
    values = sp.Poly(characteristic_polynomial(1), _real("eta")).all_coeffs()
    return {f"c_{power}": value for power, value in zip((2, 1, 0), values, strict=True)}


def _root(square: Expr, *factors: Expr) -> Expr:
    """The root of something non-negative, with the roots of some of its non-negative factors apart."""
    return sp.prod(map(sp.sqrt, factors)) * sp.sqrt(sp.factor(square / sp.prod(factors)))


@cache
def _boundary_roots() -> tuple[Expr, Expr]:
    """The mean of the roots of the boundary as a quadratic in Delta, and the square of half their difference."""
    one, linear, _ = sp.Poly(boundary_in_delta()[0], _real("Delta")).all_coeffs()
    return -linear / (2 * one), discriminant_in_delta()["D"] / (2 * one) ** 2


def boundary_roots() -> dict[str, Expr]:
    """These roots, Delta_1 the greater and Delta_2, and their distance."""
    mean, square = _boundary_roots()
    half = _root(square, _real("E_1"), _real("b_1"), 1 - _real("b_1"))
    return {"Delta_1": mean + half, "Delta_2": mean - half, "width": 2 * half}


@cache
def _frequencies() -> tuple[Expr, Expr, Expr]:
    """In units of the spin: the mean of the two frequencies, and e and b where half their difference is sqrt(b) / e."""
    values = {_real("C"): _real("A") + _real("Delta"), _real("lambda_1"): _real("b_1") * _real("omega_0")}
    two, one, _ = (sp.factor(value.subs(values)) for value in characteristic_coefficients().values())
    [boundary] = boundary_in_delta()
    return sp.cancel(-one / (2 * two * _real("omega_0"))), 2 * two, boundary


def frequencies() -> dict[str, Expr]:
    """eta_1 and eta_2, the roots of the quadratic in eta."""
    mean, divisor, boundary = _frequencies()
    half = sp.sqrt(boundary) / divisor
    return {"eta_1": _real("omega_0") * (mean - half), "eta_2": _real("omega_0") * (mean + half)}


@cache
def critical_frequencies() -> dict[str, Expr]:
    """The double frequencies eta_1 at Delta_1 and eta_2 at Delta_2; the greater Delta has the lesser one."""
    delta, spin, (mean, square) = _real("Delta"), _real("omega_0"), _boundary_roots()
    frequency = _frequencies()[0]
    middle, half = sp.cancel(frequency.subs(delta, mean)), _root(square * frequency.diff(delta) ** 2, _real("E_1"))
    return {"eta_1": spin * (middle - half), "eta_2": spin * (middle + half)}


@cache
def greatest_growth_rate() -> dict[str, Expr]:
    """y, the imaginary part of the frequencies midway between Delta_1 and Delta_2, where the boundary is least."""
    _, divisor, boundary = _frequencies()
    least = boundary.subs(_real("Delta"), _boundary_roots()[0])
    return {"y": _real("omega_0") * _root(-least / divisor**2, _real("E_1"))}
