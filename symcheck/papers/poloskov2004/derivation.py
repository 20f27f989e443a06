"""Poloskov 2004 from first principles: Euler's equations with noise, amplitude and phase, averaging, zero flux.

Nothing printed as a result is known here: only the equations of motion (1.1) in Stratonovich's sense, the change of
variables, the meaning of drift and diffusion, and that a stationary marginal density has no flux. Names of symbols are
those of the lowered statements.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from symcheck.core.lazy import lazy
from symcheck.mechanics import inertia, rotation

if TYPE_CHECKING:
    from sympy import Expr, Matrix

sp = lazy("sympy")

AXES = (1, 2, 3)  # of the body
NOISES = (1, 2, 3, 4, 5, 6)  # three multiplicative ones, three additive ones


def _symbol(name: str) -> Expr:
    return sp.Symbol(name, real=True)


def _symbols(names: str) -> tuple[Expr, ...]:
    return tuple(_symbol(name) for name in names.split())


def _numbered(letter: str, values: Expr) -> dict[str, Expr]:
    """The values by name, `letter`_1, `letter`_2, ..."""
    return {f"{letter}_{i}": value for i, value in enumerate(values, 1)}


def _vector(letter: str) -> Matrix:
    return sp.Matrix([_symbol(f"{letter}_{i}") for i in AXES])


# --- equations of motion


def gyroscopic_terms() -> dict[str, Expr]:
    """f_1 to f_3 of x' + f = 0, the free motion of a body with moments A, A, C, and k = (A - C)/A."""
    equatorial, polar = _symbols("A C")
    tensor = sp.diag(equatorial, equatorial, polar)
    residual = inertia.euler_residual(tensor, _vector("x"), sp.zeros(3, 1), sp.zeros(3, 1))
    return {**_numbered("f", tensor.inv() * residual), "k": (equatorial - polar) / equatorial, "B": equatorial}


def _gyroscopic() -> Matrix:
    k, x = _symbol("k"), _vector("x")
    return sp.Matrix([-k * x[1] * x[2], k * x[2] * x[0], 0])


def _torques() -> tuple[Matrix, ...]:
    """What multiplies 1, xi_1 to xi_3, eta_1 to eta_3 on the right of x' + f = ..."""
    small, x = _symbol("varepsilon"), _vector("x")
    unit = sp.eye(3)
    multiplicative = [sp.sqrt(small) * _symbol(f"g_1{i}") * x[i - 1] * unit[:, i - 1] for i in AXES]
    additive = [sp.sqrt(small) * _symbol(f"g_2{i}") * unit[:, i - 1] for i in AXES]
    return (-small * rotation.matrix("d") * x, *multiplicative, *additive)


def free_motion() -> dict[str, Expr]:
    """f_1 to f_3 with k for (A - C)/A."""
    return _numbered("f", _gyroscopic())


def noises() -> tuple[Expr, ...]:
    """xi_1 to xi_3, eta_1 to eta_3."""
    return tuple(_symbol(f"{letter}_{i}") for letter in ("xi", "eta") for i in AXES)


def equations_of_motion() -> tuple[Expr, ...]:
    """Components of x' + f - (torques and noises), all zero."""
    drift, *columns = _torques()
    torque = sum((noise * column for noise, column in zip(noises(), columns, strict=True)), drift)
    return tuple(_vector("dx") + _gyroscopic() - torque)


# --- amplitude, phase and frequency


def generating_solution() -> dict[str, Expr]:
    """Free motion: x_3 = Omega/k, and z = x_1 + i x_2 obeys z' = -i Omega z, so that |z| = a and z = a exp(-i psi)."""
    a, k, frequency, phase = _symbols("a k Omega psi")
    z = a * sp.exp(-sp.I * phase)
    real, imaginary = (part(z).rewrite(sp.cos) for part in (sp.re, sp.im))
    values = _numbered("xtilde", (real, imaginary, frequency / k))
    return {name: sp.expand_trig(value) for name, value in values.items()}


def generating_equations() -> dict[str, Expr]:
    """f_1 to f_3 along the generating solution."""
    solution = generating_solution()
    x = sp.Matrix([_symbol(f"xtilde_{i}") for i in AXES])
    along = dict(zip(_vector("x"), x, strict=True))
    return {**solution, **_numbered("f", _gyroscopic().subs(along))}


def change_of_variables() -> dict[str, Expr]:
    """x_1, x_2, x_3 by amplitude, phase and frequency."""
    a, k, frequency, phase = _symbols("a k Omega psi")
    return _numbered("x", (a * sp.cos(phase), -a * sp.sin(phase), frequency / k))


def rates() -> dict[str, Expr]:
    """Rates of x_1, x_2, x_3 by those of amplitude, phase and frequency; the phase has the rate Omega + theta'."""
    names = {"a": "da", "psi": "dpsi", "Omega": "dOmega"}
    moving = change_of_variables().values()
    found = [sum(sp.diff(x, _symbol(y)) * _symbol(rate) for y, rate in names.items()) for x in moving]
    return {**_numbered("dx", found), "dpsi": _symbol("Omega") + _symbol("dtheta")}


def exact_phase() -> dict[str, Expr]:
    """psi = Omega t + theta, and its rate when Omega is not constant."""
    frequency, t, theta, dfrequency, dtheta = _symbols("Omega t theta dOmega dtheta")
    return {"psi": frequency * t + theta, "dpsi": frequency + dfrequency * t + dtheta}


@cache
def _in_new_variables() -> Matrix:
    """Rates of a, theta, Omega: a column for the drift and one for each noise; the free motion has none.

    From x = x(a, psi, Omega) and psi' = Omega + theta' by inverting the Jacobian matrix.
    """
    a, phase, frequency = _symbols("a psi Omega")
    moving = sp.Matrix(list(change_of_variables().values()))
    inverse = moving.jacobian([a, phase, frequency]).inv().applyfunc(sp.trigsimp)
    there = dict(zip(_vector("x"), moving, strict=True))
    drift, *columns = (column.subs(there) for column in _torques())
    free = (inverse * -_gyroscopic().subs(there) - sp.Matrix([0, frequency, 0])).applyfunc(sp.simplify)
    return sp.Matrix.hstack(free + inverse * drift, *(inverse * column for column in columns)).applyfunc(sp.expand)


def distance_of_free_motions() -> dict[str, Expr]:
    """The rate r of half the square of the distance (u, v, 0) of two free motions with the same x_3, and x_3' as w."""
    u, v = _symbols("u v")
    rate = -_gyroscopic()
    other = rate.subs({_symbol("x_1"): _symbol("x_1") + u, _symbol("x_2"): _symbol("x_2") + v}, simultaneous=True)
    apart = other - rate
    return {"r": sp.expand(u * apart[0] + v * apart[1]), "w": rate[2]}


def stratonovich_system() -> dict[str, Expr]:
    """v_1 to v_3 and h_11 to h_36."""
    system = _in_new_variables()
    entries = {f"h_{i}{j}": system[i - 1, j] for i in AXES for j in NOISES}
    return {**_numbered("v", system[:, 0]), **entries}


@cache
def slow_rates() -> dict[str, Expr]:
    """The rates of a, theta, Omega with all noises, by inserting (1.1) into the rates of x; and what v, h, zeta are."""
    a, phase, frequency, k = _symbols("a psi Omega k")
    there = dict(zip(_vector("x"), change_of_variables().values(), strict=True))
    residual = [equation.subs(there) for equation in equations_of_motion()]
    first, second, third = (_symbol(f"dx_{i}") - part for i, part in enumerate(residual, 1))
    found = {
        "da": first * sp.cos(phase) - second * sp.sin(phase),
        "dtheta": -frequency - (first * sp.sin(phase) + second * sp.cos(phase)) / a,
        "dOmega": k * third,
    }
    return {
        **{n: sp.expand(value) for n, value in found.items()},
        **stratonovich_system(),
        **_numbered("zeta", noises()),
    }


# --- the Fokker-Planck-Kolmogorov equation


def _generator(function: Expr, variables: tuple[Expr, ...], drift: Matrix, noise: Matrix) -> Expr:
    """v . grad f + (1/2) sum_k (h_k . grad)^2 f: the generator of a system in Stratonovich's sense."""

    def along(vector: Matrix, value: Expr) -> Expr:
        return sum(vector[i] * sp.diff(value, y) for i, y in enumerate(variables))

    squares = (along(noise[:, k], along(noise[:, k], function)) for k in range(noise.cols))
    return along(drift, function) + sum(squares) / 2


def _coefficients(variables: tuple[Expr, ...], system: Matrix) -> dict[str, Expr]:
    """Drift L y_i and diffusion L(y_i y_j) - y_i L y_j - y_j L y_i of the generator L."""
    drift, noise = system[:, 0], system[:, 1:]
    first = [_generator(y, variables, drift, noise) for y in variables]
    found = _numbered("K", first)
    for i, y in enumerate(variables):
        for j, z in enumerate(variables):
            second = _generator(y * z, variables, drift, noise)
            found[f"K_{i + 1}{j + 1}"] = sp.expand(second - y * first[j] - z * first[i])
    return {name: sp.expand(value) for name, value in found.items()}


@cache
def coefficients() -> dict[str, Expr]:
    """K_1 to K_3 and K_11 to K_33 by a, psi, Omega, where psi = Omega t + theta."""
    a, phase, frequency, t, theta = _symbols("a psi Omega t theta")
    full = {phase: frequency * t + theta}
    found = _coefficients((a, theta, frequency), _in_new_variables().subs(full))
    return {name: sp.expand(value.subs(theta, phase - frequency * t)) for name, value in found.items()}


@cache
def coefficients_by_y() -> dict[str, Expr]:
    """The same, and v and h, with y_1, y_2, y_3 for a, theta, Omega at t = 0, where psi = theta."""
    renamed = dict(zip(_symbols("a psi Omega"), _vector("y"), strict=True))
    both = {**coefficients(), **stratonovich_system()}
    return {name: value.subs(renamed, simultaneous=True) for name, value in both.items()}


def _rate(name: str) -> Expr:
    return sp.expand(coefficients()[name] / _symbol("varepsilon"))


def _mean(value: Expr) -> Expr:
    """The constant Fourier term of a polynomial in the sine and cosine of the phase."""
    phase = _symbol("psi")
    terms = sp.Poly(sp.expand(value), sp.cos(phase), sp.sin(phase)).terms()
    half = sp.Rational(1, 2)
    return sp.factor(
        sum(
            coefficient * sp.gamma(i * half + half) * sp.gamma(j * half + half) / (sp.pi * sp.gamma((i + j) * half + 1))
            for (i, j), coefficient in terms
            if i % 2 == j % 2 == 0
        )
    )


def averages() -> dict[str, Expr]:
    """Kbar: the coefficients / epsilon averaged over the phase, the averages not carried out."""
    average = sp.Function("mean")
    names = [*(f"K_{i}" for i in AXES), *(f"K_{i}{j}" for i in AXES for j in AXES)]
    return {name.replace("K", "Kbar"): average(_rate(name), _symbol("psi")) for name in names}


@cache
def averaged_coefficients() -> dict[str, Expr]:
    """Kbar: the coefficients / epsilon averaged over the phase."""
    names = [*(f"K_{i}" for i in AXES), *(f"K_{i}{j}" for i in AXES for j in AXES)]
    return {name.replace("K", "Kbar"): _mean(_rate(name)) for name in names}


def coefficients_and_averages() -> dict[str, Expr]:
    """K and Kbar side by side."""
    return {**coefficients(), **averaged_coefficients()}


def mixed_average_of_full_noise() -> dict[str, Expr]:
    """Kbar_12 when the multiplicative noises xi_j act on all axes: sum_j q_ij x_j xi_j in equation i."""
    a, phase = _symbols("a psi")
    x = tuple(change_of_variables().values())
    rows = {
        i: [x[j - 1] * _symbol(f"q_{i}{j}") for j in AXES] + [_symbol(f"g_2{i}") if j == i else 0 for j in AXES]
        for i in (1, 2)
    }
    first = [u * sp.cos(phase) - v * sp.sin(phase) for u, v in zip(rows[1], rows[2], strict=True)]
    second = [-(u * sp.sin(phase) + v * sp.cos(phase)) / a for u, v in zip(rows[1], rows[2], strict=True)]
    product = sum((u * v for u, v in zip(first, second, strict=True)), sp.Integer(0))
    return {"Kbar_12": sp.Function("mean")(sp.expand(product), phase)}


@cache
def primitive_of_diffusion() -> dict[str, Expr]:
    """U, periodic in the phase, whose derivative is K_11 / epsilon without its average; and K, Kbar."""
    phase = _symbol("psi")
    wave = sp.expand((_rate("K_11") - _mean(_rate("K_11"))).rewrite(sp.exp))
    primitive = sp.expand(sp.simplify(sp.integrate(wave, phase).rewrite(sp.cos)), trig=True)
    return {**coefficients_and_averages(), "U": primitive}


def neglected_terms() -> dict[str, Expr]:
    """K_1, K_2, K_3 / epsilon without their averages."""
    found = {f"K_{i}": sp.expand(_rate(f"K_{i}") - _mean(_rate(f"K_{i}"))) for i in AXES}
    return {**found, "varepsilon": sp.Integer(1)}


# --- stationary densities


@cache
def shortened_averages() -> dict[str, Expr]:
    """Kbar with alpha^2 = g_11^2 + g_12^2, beta^2 = g_21^2 + g_22^2, gamma^2 = d_11 + d_22."""
    alpha, beta, gamma = _symbols("alpha beta gamma")
    short = {
        _symbol("g_12"): sp.sqrt(alpha**2 - _symbol("g_11") ** 2),
        _symbol("g_22"): sp.sqrt(beta**2 - _symbol("g_21") ** 2),
        _symbol("d_22"): gamma**2 - _symbol("d_11"),
    }
    return {name: sp.factor(sp.expand(value.subs(short))) for name, value in averaged_coefficients().items()}


def _logarithmic_derivative(drift: Expr, diffusion: Expr, variable: Expr) -> Expr:
    """p'/p of a density without flux: (K p)'/2 = M p for the diffusion K and the drift M."""
    return sp.together((2 * drift - sp.diff(diffusion, variable)) / diffusion)


@cache
def logarithmic_derivatives() -> tuple[Expr, Expr]:
    """p'/p of the densities of a and Omega."""
    bar, a, frequency = shortened_averages(), _symbol("a"), _symbol("Omega")
    first = _logarithmic_derivative(bar["Kbar_1"], bar["Kbar_11"], a)
    return first, _logarithmic_derivative(bar["Kbar_3"], bar["Kbar_33"], frequency)


@cache
def exponents() -> dict[str, Expr]:
    """Delta_1 = 8 Kbar_11, Delta_2 = Kbar_33, and the powers they have in the densities.

    The density of a is a^r Delta_1^kappa_1 with r the residue of p'/p at a = 0, that of Omega is Delta_2^kappa_2.
    """
    bar, a, frequency = shortened_averages(), _symbol("a"), _symbol("Omega")
    first, second = logarithmic_derivatives()
    amplitude, spin = sp.expand(8 * bar["Kbar_11"]), sp.expand(bar["Kbar_33"])
    residue = sp.limit(a * first, a, 0)
    return {
        "Delta_1": amplitude,
        "kappa_1": sp.simplify((first - residue / a) * amplitude / sp.diff(amplitude, a)),
        "Delta_2": spin,
        "kappa_2": sp.simplify(second * spin / sp.diff(spin, frequency)),
    }


@cache
def densities() -> dict[str, Expr]:
    """The averaged coefficients and the densities; C_1, C_2 are named such that 8 C_1 and C_2 are their constants."""
    a = _symbol("a")
    amplitude = 8 * _symbol("C_1") * a * _symbol("Delta_1") ** _symbol("kappa_1")
    spin = _symbol("C_2") * _symbol("Delta_2") ** _symbol("kappa_2")
    marginal = {"p_s1": amplitude, "p_s2": 1 / (2 * sp.pi), "p_s3": spin}
    joint = _symbol("p_s1") * _symbol("p_s2") * _symbol("p_s3")
    return {**shortened_averages(), **exponents(), **marginal, "p_s": joint}


@cache
def mode() -> dict[str, Expr]:
    """Where the density of a is largest: the positive zero of p'/p."""
    numerator = sp.Poly(sp.numer(sp.together(logarithmic_derivatives()[0])), _symbol("a"))
    square = sp.factor(-numerator.coeff_monomial(1) / numerator.coeff_monomial(_symbol("a") ** 2))
    return {"a_star": sp.sqrt(square.subs(_symbol("beta"), sp.Symbol("beta", positive=True)))}


def slope_of_amplitude() -> dict[str, Expr]:
    """Delta_1, and lambda: p'/p of the density of a."""
    return {**exponents(), "lambda": logarithmic_derivatives()[0]}


def slope_of_frequency() -> dict[str, Expr]:
    """Delta_2, and lambda: p'/p of the density of Omega."""
    return {**exponents(), "lambda": logarithmic_derivatives()[1]}


def constant_of_the_example() -> dict[str, Expr]:
    """C_2 for d_33 = 3/2, g_13 = g_23 = 1: the reciprocal of the integral of Delta_2^kappa_2."""
    values = {_symbol("d_33"): sp.Rational(3, 2), _symbol("g_13"): 1, _symbol("g_23"): 1}
    found = exponents()
    k, frequency = sp.Symbol("k", positive=True), _symbol("Omega")
    density = (found["Delta_2"] ** found["kappa_2"]).subs(values).subs(_symbol("k"), k)
    integral = sp.integrate(density, (frequency, -sp.oo, sp.oo))
    return {"C_2": sp.simplify(1 / integral).subs(k, _symbol("k"))}


def moment_parameters() -> dict[str, Expr]:
    """The densities, and nu = -kappa_1 - 1, delta = -kappa_2 - 1/2: how fast they fall."""
    found = densities()
    nu, delta = sp.expand(-found["kappa_1"] - 1), sp.expand(-found["kappa_2"] - sp.Rational(1, 2))
    return {**found, "nu": nu, "delta": delta}


def additive_noise_only() -> dict[str, Expr]:
    """The averaged coefficients of a for alpha = 0."""
    bar = shortened_averages()
    return {name: sp.expand(bar[name].subs(_symbol("alpha"), 0)) for name in ("Kbar_11", "Kbar_1")}


def additive_axial_noise_only() -> dict[str, Expr]:
    """The averaged coefficients of Omega for g_13 = 0."""
    bar = shortened_averages()
    return {name: sp.expand(bar[name].subs(_symbol("g_13"), 0)) for name in ("Kbar_33", "Kbar_3")}


# --- for positive parameters: densities with their constants, distributions, moments


def _positive(*names: str) -> dict[Expr, Expr]:
    return {_symbol(name): sp.Symbol(name, positive=True) for name in names}


def _over_small_parameter(values: dict[str, Expr]) -> dict[str, Expr]:
    """Values with epsilon taken out, and the rest by powers of a."""
    small, a = sp.Symbol("varepsilon", positive=True), _symbol("a")
    known = {name: value.subs(_symbol("varepsilon"), small) for name, value in values.items() if value != 0}
    factors = {name: sp.sqrt(small) if name[0] == "h" else small for name in known}
    rest = {name: sp.collect(sp.expand(value / factors[name]), a) for name, value in known.items()}
    return {name: factors[name] * sp.factor_terms(value) for name, value in rest.items()}


@cache
def drift_and_diffusion() -> dict[str, Expr]:
    """v, h, K_i and K_ij that do not vanish, epsilon taken out."""
    return _over_small_parameter({**stratonovich_system(), **coefficients()})


@cache
def _shapes() -> dict[str, Expr]:
    """c_1, c_2 of Delta = Delta(0) (1 + c x^2) for x = a, Omega; nu, delta: the powers but for 1 and 1/2; Delta(0)."""
    found = moment_parameters()
    values: dict[str, Expr] = {}
    for i, (x, power) in enumerate((("a", "nu"), ("Omega", "delta")), 1):
        start = found[f"Delta_{i}"].subs(_symbol(x), 0)
        ratio = sp.cancel((found[f"Delta_{i}"] / start - 1) / _symbol(x) ** 2)
        values |= {f"start_{i}": start, f"c_{i}": ratio, power: found[power]}
    positive = _positive("alpha", "beta", "gamma", "k", "d_33", "g_13", "g_23")
    return {name: _differences_of_squares(value.subs(positive)) for name, value in values.items()}


def _differences_of_squares(value: Expr) -> Expr:
    """Factored, with the sign in the difference: (2 gamma - alpha)(2 gamma + alpha), not -(alpha - 2 gamma)(...)."""
    value = sp.factor(value)
    number, rest = value.as_coeff_Mul()
    difference = next((factor for factor in rest.as_ordered_factors() if factor.is_Add), None)
    return -number * ((-difference) * (rest / difference)) if number < 0 and difference else value


def _integral(s: Expr, c: Expr, r: Expr) -> Expr:
    """The integral of x^(s-1) (1 + c x^2)^(-r) over x > 0: Euler's integral of the first kind."""
    return sp.gamma(s / 2) * sp.gamma(r - s / 2) / (2 * c ** (s / 2) * sp.gamma(r))


def _with_shapes(value: Expr) -> Expr:
    """A formula in c_1, nu, ... by the parameters; it has to be simplified before."""
    return value.subs({sp.Symbol(name, positive=True): shape for name, shape in _shapes().items()}, simultaneous=True)


def _shape_letters() -> tuple[Expr, ...]:
    return tuple(sp.symbols("c_1 c_2 nu delta start_1 start_2", positive=True))


def _weights() -> tuple[Expr, Expr]:
    """The integral of a (1 + c_1 a^2)^(-nu-1) over a > 0, and that of (1 + c_2 Omega^2)^(-delta-1/2) over all Omega."""
    first, second, nu, delta, *_ = _shape_letters()
    half = sp.Rational(1, 2)
    return sp.gammasimp(_integral(sp.Integer(2), first, nu + 1)), 2 * _integral(sp.Integer(1), second, delta + half)


@cache
def normalised_densities() -> dict[str, Expr]:
    """p_s1, p_s3 with integral 1, the exponents less 1 and 1/2 standing apart: the other factor is a simple fraction."""
    first, second, nu, delta, *_ = _shape_letters()
    a, frequency = sp.Symbol("a", positive=True), _symbol("Omega")
    amplitude, spin = _weights()
    simple = _differences_of_squares(sp.cancel(_with_shapes(a / amplitude / (1 + first * a**2))))
    root = sp.sqrt(sp.cancel(_with_shapes(second / (1 + second * frequency**2))))
    return {
        "p_s1": simple * _with_shapes((1 + first * a**2) ** -nu),
        "p_s3": root * _with_shapes((1 + second * frequency**2) ** -delta / (spin * sp.sqrt(second))),
    }


@cache
def logarithms_of_constants() -> dict[str, Expr]:
    """log C_1, log C_2 of the constants that make the integrals of 8 C_1 a Delta_1^kappa_1 and C_2 Delta_2^kappa_2 be 1."""
    _, _, nu, delta, start, middle = _shape_letters()
    amplitude, spin = _weights()
    factor = _differences_of_squares(_with_shapes(start / (8 * amplitude)))
    return {
        "log_C_1": sp.log(factor) + 2 * _with_shapes(nu) * sp.log(_with_shapes(sp.sqrt(start))),
        "log_C_2": sp.log(_with_shapes(sp.sqrt(middle) / spin))
        + 2 * _with_shapes(delta) * sp.log(_with_shapes(sp.sqrt(middle))),
    }


@cache
def distribution_of_amplitude() -> dict[str, Expr]:
    """The distribution function of a, F, and the amplitude a_q at which it is q."""
    c, _, nu, *_ = _shape_letters()
    a, q = sp.symbols("a q", positive=True)
    return {
        "F": _with_shapes(1 - (1 + c * a**2) ** -nu),
        "a_q": sp.sqrt(((1 - q) ** (-1 / _shapes()["nu"]) - 1) / _shapes()["c_1"]),
    }


@cache
def moments() -> dict[str, Expr]:
    """The means of a^m and of |Omega|^m."""
    first, second, nu, delta, *_ = _shape_letters()
    m, half = sp.Symbol("m", real=True), sp.Rational(1, 2)
    amplitude = _integral(2 + m, first, nu + 1) / _integral(sp.Integer(2), first, nu + 1)
    spin = _integral(1 + m, second, delta + half) / _integral(sp.Integer(1), second, delta + half)
    return {"M_a": _with_shapes(sp.powsimp(amplitude)), "M_Omega": _with_shapes(sp.powsimp(spin))}


@cache
def mean_squares() -> dict[str, Expr]:
    """The means of a^2 and Omega^2, as those of 2 x Kbar + Kbar_xx vanish (B.8)."""
    bar, found = shortened_averages(), {}
    for name, x, i in (("S_a", "a", 1), ("S_Omega", "Omega", 3)):
        balance = sp.Poly(sp.expand(2 * _symbol(x) * bar[f"Kbar_{i}"] + bar[f"Kbar_{i}{i}"]), _symbol(x))
        found[name] = _differences_of_squares(-balance.coeff_monomial(1) / balance.coeff_monomial(_symbol(x) ** 2))
    return found
