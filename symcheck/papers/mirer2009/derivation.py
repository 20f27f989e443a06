"""Mirer 2009 from first principles: the damped body, its characteristic equation, moments about turned axes.

Nothing printed as a result is known here: only the law of angular momentum, the control law, the mass distribution and
the order of the elementary rotations of figure 1. Names of symbols are those of the lowered statements.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from symcheck.core.lazy import lazy
from symcheck.mechanics import inertia, rotation

if TYPE_CHECKING:
    from sympy import Expr, Matrix

sp = lazy("sympy")


def _triple(letter: str) -> tuple[Expr, Expr, Expr]:
    return inertia.principal_moments(letter)


def _vector(letter: str) -> Matrix:
    return sp.Matrix(_triple(letter))


def _tensor() -> Matrix:
    return sp.diag(*_triple("I"))


def control_torque() -> Matrix:
    """M = -sum k_i (w, e_i) e_i in principal axes; e_i is row i of the matrix a, not assumed orthogonal."""
    rate, axes = _vector("omega"), rotation.matrix()
    torque = sp.zeros(3, 1)
    for gain, i in zip(_triple("k"), range(3), strict=True):
        axis = axes[i, :].T
        torque -= gain * rate.dot(axis) * axis
    return torque


@cache
def equations_of_motion() -> tuple[Expr, ...]:
    """Components of I w' + w x I w - M, the left side of the equations of motion, all zero."""
    return tuple(inertia.euler_residual(_tensor(), _vector("omega"), _vector("domega"), control_torque()))


def residual() -> dict[str, Expr]:
    """The same components by name, rho_1 to rho_3."""
    return {f"rho_{i}": value for i, value in enumerate(equations_of_motion(), 1)}


@cache
def linearised_equations() -> tuple[Expr, ...]:
    """First-order part of the equations of motion at w = 0, w' = 0."""
    motion = sp.Matrix(equations_of_motion())
    variables = list(_triple("omega")) + list(_triple("domega"))
    origin = dict.fromkeys(variables, 0)
    return tuple(motion.jacobian(variables).subs(origin) * sp.Matrix(variables))


@cache
def damping_matrix() -> Matrix:
    """The matrix m of M = -m w, from the torque itself: m = -dM/dw."""
    return -control_torque().jacobian(_vector("omega"))


def damping_entries() -> dict[str, Expr]:
    """Entries m_11 to m_33 of the damping matrix."""
    return rotation.entries(damping_matrix().applyfunc(sp.expand), "m")


def spectral_damping_entries() -> dict[str, Expr]:
    """Entries n_11 to n_33 of S^T B S with a diagonal B."""
    axes, gains = rotation.matrix("s"), sp.diag(*(sp.Symbol(f"b_{i}{i}", real=True) for i in (1, 2, 3)))
    return rotation.entries(axes.T * gains * axes, "n")


def mirrored_damping_entries() -> dict[str, Expr]:
    """The same entries, and those for -S in place of S as q_11 to q_33."""
    axes, gains = -rotation.matrix("s"), sp.diag(*(sp.Symbol(f"b_{i}{i}", real=True) for i in (1, 2, 3)))
    return {**spectral_damping_entries(), **rotation.entries(axes.T * gains * axes, "q")}


def _characteristic(damping: Matrix) -> Expr:
    return sp.expand((sp.Symbol("p", real=True) * _tensor() + damping).det())


@cache
def characteristic_polynomial_of_damping_matrix() -> tuple[Expr, ...]:
    """det(I p + m) for the symbols m_11 to m_33."""
    return (_characteristic(rotation.matrix("m")),)


@cache
def characteristic_polynomial() -> tuple[Expr, ...]:
    """det(I p + m) for the damping matrix of three devices with gains k_i along the rows of a."""
    return (_characteristic(damping_matrix()),)


def characteristic_polynomial_by_axes() -> tuple[Expr, ...]:
    """det(I p + m) for orthonormal axes e_i: the gains of some axes times the minors of I p left to the others.

    By Cauchy-Binet these minors are (e_i, I e_i) = J_i for one axis and (e_i, adj(I) e_i) = L_i for two.
    """
    p = sp.Symbol("p", real=True)
    gains, one, two = _triple("k"), _triple("J"), _triple("L")
    square = sum((gain * minor for gain, minor in zip(gains, two, strict=True)), sp.Integer(0))
    linear = sum((sp.prod(gains) / gain * minor for gain, minor in zip(gains, one, strict=True)), sp.Integer(0))
    return (sp.prod(_triple("I")) * p**3 + square * p**2 + linear * p + sp.prod(gains),)


def scaled_gains() -> dict[str, Expr]:
    """k_i = kbar_i J_i: gains in units of the moment of inertia about their own axis."""
    return {f"k_{i}": sp.Symbol(f"kbar_{i}") * sp.Symbol(f"J_{i}") for i in (1, 2, 3)}


def proportional_gains() -> dict[str, Expr]:
    """k_i = k J_i: gains proportional to the moment of inertia about their own axis."""
    ratio = sp.Symbol("k", real=True)
    return {f"k_{i}": ratio * moment for i, moment in enumerate(_triple("J"), 1)}


@cache
def triple_root_conditions() -> tuple[Expr, ...]:
    """Coefficients of p^2, p, 1 in I1 I2 I3 (p + xi)^3 less the characteristic polynomial."""
    p, xi = sp.Symbol("p", real=True), sp.Symbol("xi", real=True)
    i1, i2, i3 = _triple("I")
    difference = sp.Poly(i1 * i2 * i3 * (p + xi) ** 3 - characteristic_polynomial_by_axes()[0], p)
    return tuple(difference.coeff_monomial(p**n) for n in (2, 1, 0))


def triple_root_condition(power: int) -> tuple[Expr, ...]:
    """The coefficient of one power of p among them."""
    return (triple_root_conditions()[2 - power],)


def axial_moments() -> dict[str, Expr]:
    """J_i = e_i^T I e_i for the axes e_i, rows of a."""
    moments = inertia.axial_moments(_tensor(), rotation.matrix())
    return {f"J_{i}": moment for i, moment in enumerate(moments, 1)}


def moments_of_a_mass_distribution() -> dict[str, Expr]:
    """I_1 = P_2 + P_3 and cyclic, with P_i the integral of x_i^2 over the mass."""
    moments = inertia.from_second_moments(_triple("P"))
    return {f"I_{i}": moment for i, moment in enumerate(moments, 1)}


def direction_cosines() -> dict[str, Expr]:
    """a_ij of figure 1: axes x are axes y turned by alpha about axis 2, then beta about axis 3, then gamma about axis 1."""
    alpha, beta, gamma = sp.symbols("alpha beta gamma", real=True)
    from_y_to_x = rotation.elementary(1, gamma) * rotation.elementary(3, beta) * rotation.elementary(2, alpha)
    return rotation.entries(from_y_to_x.T)


def equal_moment_equation() -> tuple[Expr, ...]:
    """J_1 - (I_1 + I_2 + I_3)/3 in the direction cosines."""
    mean = sum(_triple("I"), sp.Integer(0)) / 3
    return (axial_moments()["J_1"] - mean,)


def turned_about_the_diagonal() -> dict[str, Expr]:
    """Axes with row 2 along (1, 1, -1) and rows 3, 1 turned about it by the angle of cosine u and sine v."""
    u, v = sp.symbols("u v", real=True)
    one, three = sp.Integer(1), sp.Integer(3)
    diagonal = sp.Matrix([[one, one, -one]]) / sp.sqrt(three)
    first = sp.Matrix([[2, -1, 1]]) / (sp.sqrt(2) * sp.sqrt(three))
    third = sp.Matrix([[0, 1, 1]]) / sp.sqrt(2)
    return rotation.entries(sp.Matrix.vstack(u * first + v * third, diagonal, u * third - v * first))


def eigenvector_residual() -> dict[str, Expr]:
    """Real parts u_i and imaginary parts v_i of (I p + m) z for p = sigma + i tau, z = x + i y."""
    sigma, tau = sp.symbols("sigma tau", real=True)
    x, y, damping = _vector("x"), _vector("y"), rotation.matrix("m")
    real = _tensor() * (sigma * x - tau * y) + damping * x
    imaginary = _tensor() * (tau * x + sigma * y) + damping * y
    return {
        f"{letter}_{i}": value for letter, part in (("u", real), ("v", imaginary)) for i, value in enumerate(part, 1)
    }


def gain_from_rates() -> dict[str, Expr]:
    """k as the harmonic mean of the rates xi + s_1, xi + s_2, xi + s_3."""
    rates = [sp.Symbol("xi", real=True) + excess for excess in _triple("s")]
    return {"k": 3 / sum((1 / rate for rate in rates), sp.Integer(0))}


def reciprocal_squares() -> dict[str, Expr]:
    """1/a^2, 1/b^2, 1/c^2 in the place of the principal moments."""
    return {f"I_{i}": 1 / sp.Symbol(axis, real=True) ** 2 for i, axis in enumerate("abc", 1)}


def ellipsoid_moments() -> dict[str, Expr]:
    """The same, with the turned axes."""
    return {**turned_about_the_diagonal(), **reciprocal_squares()}


def _moments_by_deviation() -> dict[str, Expr]:
    c = sp.Symbol("c", real=True)
    return {f"I_{i}": c + deviation for i, deviation in enumerate(_triple("d"), 1)}


def _deviations(first_axis: Expr) -> dict[str, Expr]:
    """g = D e_1, h = e_1 x g, G = (g, g), W = (g, D h) for D = diag(d_i), the deviations of the moments from their mean."""
    d = sp.diag(*_triple("d"))
    g = d * first_axis
    h = first_axis.cross(g)
    vectors = {f"{letter}_{i}": value for letter, vector in (("g", g), ("h", h)) for i, value in enumerate(vector, 1)}
    return {**vectors, "G": g.dot(g), "W": sp.expand(g.dot(d * h))}


def second_axis_components() -> dict[str, Expr]:
    """The moments c + d_i, the vectors g and h of the first axis, and u = (e_2, g), v = (e_2, h)."""
    axes = rotation.matrix()
    deviations = _moments_by_deviation()
    first, second = axes[0, :].T, axes[1, :].T
    plane = _deviations(first)
    u = second.dot(sp.Matrix(_triple("g")))
    v = second.dot(sp.Matrix(_triple("h")))
    return {**deviations, **plane, "u": u, "v": v}


def equal_moment_family() -> dict[str, Expr]:
    """Rows 2 and 3 of the closed form: (u g + v h)/r and its cross product with row 1; I_i = c + d_i."""
    u, v, r = sp.symbols("u v r", real=True)
    axes = rotation.matrix()
    first, second = axes[0, :].T, axes[1, :].T
    plane = _deviations(first)
    rows = {f"a_2{i}": value for i, value in enumerate((u * _vector("g") + v * _vector("h")) / r, 1)}
    rows |= {f"a_3{i}": value for i, value in enumerate(first.cross(second), 1)}
    return {**plane, **rows, **_moments_by_deviation()}


def exceptional_family() -> dict[str, Expr]:
    """Moments 3, 1, 2 (mean 2), first axis (1, 1, 0)/sqrt 2, second turned about it by the angle of cosine u and sine v."""
    u, v = sp.symbols("u v", real=True)
    first = sp.Matrix([1, 1, 0]) / sp.sqrt(2)
    second = u * sp.Matrix([1, -1, 0]) / sp.sqrt(2) + v * sp.Matrix([0, 0, 1])
    axes = sp.Matrix.hstack(first, second, first.cross(second)).T
    return {**rotation.entries(axes), "I_1": sp.Integer(3), "I_2": sp.Integer(1), "I_3": sp.Integer(2)}


# --- in moments, direction cosines and gains, for kernels


def _put(expression: Expr, values: dict[str, Expr]) -> Expr:
    """The expression with these values of its letters."""
    return expression.subs({sp.Symbol(name, real=True): value for name, value in values.items()})


def second_order_moments() -> dict[str, Expr]:
    """L_i = e_i^T adj(I) e_i for the axes e_i, rows of a."""
    forms = inertia.axial_moments(_tensor().adjugate(), rotation.matrix())
    return {f"L_{i}": form for i, form in enumerate(forms, 1)}


def products_of_moments() -> dict[str, Expr]:
    """f = J_1 J_2 J_3, S = J_1 L_1 + J_2 L_2 + J_3 L_3, and the two products that the proof of the lower bound joins."""
    first, second, third = axial_moments().values()
    adjugate = second_order_moments().values()
    pairs = [moment * form for moment, form in zip((first, second, third), adjugate, strict=True)]
    return {"f": first * second * third, "S": sp.Add(*pairs), "J_1_J_3": first * third, "J_2_L_2": pairs[1]}


def bounds_of_products() -> dict[str, Expr]:
    """f and S for axes that are principal, and f for three moments that are equal."""
    principal, mean = sp.prod(_triple("I")), sum(_triple("I"), sp.Integer(0)) / 3
    return {"f_least": principal, "f_greatest": mean**3, "S_least": 3 * principal}


def distances_from_bounds() -> dict[str, Expr]:
    """How far f and S are from their bounds, as sums of squares with positive factors: 2.13.4, 2.19.4, and for 2.1b
    f = J_2 ((J_1 + J_3)^2 - (J_1 - J_3)^2)/4 with J_1 + J_2 + J_3 = 3c.
    """
    moments, (first, second, third) = _triple("I"), axial_moments().values()
    mean, axes = sum(moments, sp.Integer(0)) / 3, rotation.matrix()
    rows = [_deviation_of_row(moments, axes.row(i)) for i in range(3)]
    inertia_product = sum((moments[k] * axes[0, k] * axes[2, k] for k in range(3)), sp.Integer(0))
    return {
        "f_excess": rows[1] + second * inertia_product**2,
        "f_deficit": ((mean - second) ** 2 * (first + third + mean) + second * (first - third) ** 2) / 4,
        "S_excess": sp.Add(*rows),
    }


def _deviation_of_row(moments: tuple[Expr, Expr, Expr], axis: Expr) -> Expr:
    """J L - I_1 I_2 I_3 of one axis: zero if it is principal."""
    cyclic = ((k, (k + 1) % 3, (k + 2) % 3) for k in range(3))
    return sp.Add(*(moments[k] * (moments[m] - moments[n]) ** 2 * (axis[m] * axis[n]) ** 2 for k, m, n in cyclic))


def bound_at_given_moment() -> dict[str, Expr]:
    """f for a given J_2 and two other moments that are equal: they share what is left of 3c."""
    second = sp.Symbol("J_2", real=True)
    other = (sum(_triple("I"), sp.Integer(0)) - second) / 2
    return {"f_1": second * other**2}


def _coefficients(gains: dict[str, Expr]) -> dict[str, Expr]:
    [polynomial] = characteristic_polynomial_by_axes()
    values = sp.Poly(_put(polynomial, gains), sp.Symbol("p", real=True)).all_coeffs()
    moments = axial_moments() | second_order_moments()
    return {
        f"c_{power}": _put(sp.factor_terms(value), moments) for power, value in zip((3, 2, 1, 0), values, strict=True)
    }


def characteristic_coefficients() -> dict[str, Expr]:
    """Coefficients c_3 to c_0 of the characteristic polynomial for the gains k_1, k_2, k_3."""
    return _coefficients({})


def characteristic_coefficients_at_common_ratio() -> dict[str, Expr]:
    """The same for gains that are k times the moments about their axes."""
    return _coefficients(proportional_gains())


def gains_in_proportion() -> dict[str, Expr]:
    """These gains in the direction cosines."""
    return {name: _put(gain, axial_moments()) for name, gain in proportional_gains().items()}


def symmetric_damping_entries() -> dict[str, Expr]:
    """The entries of the damping matrix on its diagonal and above."""
    return {name: entry for name, entry in damping_entries().items() if name[2] <= name[3]}


def excess_of_gain() -> dict[str, Expr]:
    """The gain k of damping rates xi, the least, and xi + s_i; and k - xi."""
    [k] = gain_from_rates().values()
    return {"k": k, "k_excess": k - sp.Symbol("xi", real=True)}


@cache
def stability_degree_in_pitch() -> dict[str, Expr]:
    """The least damping rate xi for axes turned by the pitch alone, with gains k J_i.

    The axis that stays principal damps with the rate k; the other two rates are the roots of a quadratic a p^2 - b p + c,
    the lesser of which is 2 c / (b + sqrt(b^2 - 4 a c)).
    """
    p, k, alpha = sp.symbols("p k alpha", real=True)
    pitch = {name: _put(cosine, {"beta": 0, "gamma": 0}) for name, cosine in direction_cosines().items()}
    moments = {name: _put(moment, pitch) for name, moment in (axial_moments() | second_order_moments()).items()}
    [polynomial] = characteristic_polynomial_by_axes()
    polynomial = _put(_put(polynomial, proportional_gains()), moments)
    polynomial = sp.expand(sp.expand(polynomial).subs(sp.cos(alpha), sp.sqrt(1 - sp.sin(alpha) ** 2)))
    a, b, c = (sp.factor(value) for value in sp.Poly(sp.quo(polynomial, p + k, p), p).all_coeffs())
    return {"xi": sp.cancel(2 * c / b) / (1 + sp.sqrt(1 - sp.factor(4 * a * c / b**2)))}


@cache
def equal_moment_pitch() -> dict[str, Expr]:
    """The pitch alpha that makes J_1 the mean moment where the second axis has the angles of 2.7.15.

    J_1 - c is P cos 2 alpha + Q sin 2 alpha: P is its value at 0, Q that at 45 degrees.
    """
    yaw, roll = sp.asin(1 / sp.sqrt(3)), sp.pi / 4
    [equation] = equal_moment_equation()

    def at(pitch: Expr) -> Expr:
        angles = {"alpha": pitch, "beta": yaw, "gamma": roll}
        return sp.expand(_put(equation, {name: _put(x, angles) for name, x in direction_cosines().items()}))

    return {"alpha": sp.atan(sp.factor(-at(0) / at(sp.pi / 4))) / 2}
