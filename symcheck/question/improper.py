"""Hints about integrals without an upper or a lower end: exponentials, Gaussians, powers, and what they outweigh."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from symcheck.core.calculus import letters, nodes, substituted
from symcheck.core.problems import Applied
from symcheck.core.terms import INFINITY, MINUS_INFINITY, PI, Node, Term, Value, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.reading import from_sympy, to_sympy

if TYPE_CHECKING:
    from sympy import Expr, Symbol

Hints = list[Applied[Term]]
MAX_ADDENDS = 12  # of an integrand: each has theorems of its own, which are all tried


def improper(body: Term, x: str, low: Term, high: Term) -> Hints:
    """The theorems that say what the integral is; SymcheckError, or what SymPy raises, if there are none."""
    names: dict[str, Term] = {}

    def plain(tree: Term) -> Term:
        """The same with letters for functions that do not depend on x, which SymPy would write in another way."""
        if isinstance(tree, Node) and tree.tag in ("sqrt", "pow", "gamma", "log") and x not in letters(tree):
            names.setdefault(f"{x}_free_{len(names)}", tree)
            return next(name for name, known in names.items() if known == tree)
        return mapped(tree, plain) if isinstance(tree, Node) else tree

    return [
        Applied(
            hint.theorem,
            tuple(substituted(term, names) for term in hint.terms),
            tuple((own, substituted(term, names)) for own, term in hint.functions),
        )
        for hint in _hints(plain(body), x, low, high)
    ]


def _hints(body: Term, x: str, low: Term, high: Term) -> Hints:
    """The same where nothing is to be hidden from SymPy."""
    f = ((x,), body)
    if high == INFINITY and low in (0, MINUS_INFINITY) and (roots := _numbers(body, x)):
        return roots
    if low == 0 and high != INFINITY:
        return [_head(body, x, high)]
    if low == MINUS_INFINITY and high == INFINITY:
        if whole := _gaussian(body, x) or _shifted(body, x):
            return whole
        middle = _kink(body, x)
        sides = [*_hints(body, x, MINUS_INFINITY, middle), *_hints(body, x, middle, INFINITY)]
        return [Applied("halves", (middle,), (f,)), *sides]
    if low == MINUS_INFINITY:
        mirrored = substituted(body, {x: node("-", x)})
        turned = Applied("reflected", (high,), (f, ((x,), mirrored)))
        return [turned, *_hints(mirrored, x, node("-", high) if high != 0 else 0, INFINITY)]
    return list(_tail(body, x, low))


def _head(body: Term, x: str, high: Term) -> Applied[Term]:
    """What a power says of the integral from zero, alone, by a logarithm, or by one of 1 - x; or that it converges."""
    import sympy

    expr, symbol = _symbols(body, x)
    f = ((x,), body)
    factors = sympy.Mul.make_args(sympy.powsimp(expr))
    if sympy.log(symbol) in factors:
        c, u = _power(expr / sympy.log(symbol), symbol)
        return Applied("log_head", (from_sympy(c), from_sympy(u), high), (f,))
    if high == 1 and (beta := _beta(to_sympy(body), symbol)):
        return Applied("unit_beta", tuple(map(from_sympy, beta)), (f,))
    try:
        c, u = _power(expr, symbol)
        return Applied("power_head", (from_sympy(c), from_sympy(u), high), (f,))
    except SymcheckError:
        powers = [factor for factor in factors if factor.as_base_exp()[0] == symbol]
        rest = sympy.Mul(*(factor for factor in factors if factor not in powers))
        u = sympy.expand(sum(power.as_base_exp()[1] for power in powers))
        return Applied("head_converges", (from_sympy(u), high), (f, ((x,), from_sympy(rest))))


def _beta(expr: Expr, x: Symbol) -> tuple[Expr, Expr, Expr] | None:
    """(c, u, v) with c x^u (1 - x)^v, if it is that."""
    import sympy

    c, factors = sympy.powsimp(expr).as_independent(x, as_Add=False)
    exponents = {x: sympy.Integer(0), 1 - x: sympy.Integer(0)}
    for base, exponent in (factor.as_base_exp() for factor in sympy.Mul.make_args(factors)):
        if base not in exponents or exponent.has(x):
            return None
        exponents[base] += exponent
    return (c, *map(sympy.expand, exponents.values())) if exponents[1 - x] != 0 else None


def inverted(body: Term, x: str, low: Term) -> tuple[Hints, Term]:
    """The theorem that takes an integral to infinity to one from 0 to 1, and the integrand of that."""
    import sympy

    place = sympy.Symbol(x, positive=True)
    there = to_sympy(body).subs(sympy.Symbol(x, real=True), to_sympy(low) - 1 + 1 / place) / place**2
    inside = from_sympy(sympy.factor(sympy.together(there)))
    return [Applied("inverted", (low,), (((x,), body), ((x,), inside)))], inside


def _symbols(body: Term, x: str) -> tuple[Expr, Symbol]:
    """The integrand as a sum of products, and its letter."""
    import sympy

    return sympy.expand(to_sympy(body)), sympy.Symbol(x, real=True)


def _kink(body: Term, x: str) -> Term:
    """Where the absolute value of a linear function has its corner; else 0."""
    import sympy

    expr, symbol = _symbols(body, x)
    for part in sorted(expr.atoms(sympy.Abs), key=str):
        line = sympy.expand(part.args[0])
        if (slope := sympy.diff(line, symbol)) != 0 and not slope.has(symbol):
            return from_sympy(sympy.expand(symbol - line / slope))
    return 0


def _without_absolute_values(body: Term, x: str, low: Term) -> tuple[Term, Hints]:
    """The integrand where those of x + b and b - x have one sign, as they vanish at the lower end; why it is equal."""
    import sympy

    signs: dict[Term, Term] = {}
    for part in nodes(body):
        match part:
            case Value(tag="sqrt", terms=(Value(tag="^", terms=(inner, 2)),)):
                line = sympy.expand(to_sympy(inner))
                slope, end = sympy.diff(line, sympy.Symbol(x, real=True)), substituted(inner, {x: low})
                if slope in (1, -1) and sympy.expand(to_sympy(end)) == 0:
                    signs[part] = inner if slope == 1 else node("-", inner)

    def plain(tree: Term) -> Term:
        if isinstance(tree, Node) and tree in signs:
            return signs[tree]
        return mapped(tree, plain) if isinstance(tree, Node) else tree

    known = [Applied("equal_squares", (part, value), ()) for part, value in signs.items()]
    calls = [part for part in nodes(body) if part.tag in ("exp", "sin", "cos") and plain(part) != part]
    return plain(body), [*known, *(Applied("congruence", (part, plain(part)), ()) for part in calls)]


def _groups(expr: Expr, x: Symbol) -> dict[Expr, Expr]:
    """The coefficients of the exponentials of polynomials, by what in their exponents depends on x."""
    import sympy

    found: dict[Expr, Expr] = {}
    for addend in sympy.Add.make_args(expr):
        exponent, rest = sympy.Integer(0), sympy.Integer(1)
        for factor in sympy.Mul.make_args(addend):
            if isinstance(factor, sympy.exp):
                exponent += factor.args[0]
            else:
                rest *= factor
        exponent = sympy.expand(exponent)
        constant = exponent.as_independent(x, as_Add=True)[0]
        key = sympy.collect(exponent - constant, x)
        found[key] = found.get(key, 0) + rest * sympy.exp(constant)
    return found


def _tail(body: Term, x: str, low: Term) -> Iterator[Applied[Term]]:
    """What a sum of exponentials, Gaussians and powers says of the integral from an end to infinity."""
    import sympy

    plain, signs = _without_absolute_values(body, x, low)
    yield from signs
    groups = _groups(*_symbols(plain, x))
    parts = [(key, rest) for key, rest in groups.items() if key != 0]
    parts += [(sympy.Integer(0), addend) for addend in sympy.Add.make_args(groups.get(sympy.Integer(0), sympy.S.Zero))]
    parts = [(key, rest) for key, rest in parts if rest != 0]
    if not 0 < len(parts) <= MAX_ADDENDS:
        raise SymcheckError("no integrand with exponentials or powers")
    own = (x,)
    whole = body
    for k, (key, rest) in enumerate(parts):
        here = body if len(parts) == 1 else from_sympy(rest * sympy.exp(key))
        if k + 1 < len(parts):
            later = from_sympy(sympy.Add(*(r * sympy.exp(e) for e, r in parts[k + 1 :])))
            yield Applied("sum_of_integrals", (low,), ((own, whole), (own, here), (own, later)))
            whole = later
        else:
            here = whole
        yield from _one(here, x, low, key, sympy.expand(rest))


def _one(body: Term, x: str, low: Term, exponent: Expr, rest: Expr) -> Iterator[Applied[Term]]:
    """The theorems about one exponential of a polynomial times its coefficient."""
    import sympy

    symbol = sympy.Symbol(x, real=True)
    own = (x,)
    if exponent == 0:
        c, u = _power(rest, symbol)
        yield Applied("power_tail", (from_sympy(c), from_sympy(u), low), ((own, body),))
        return
    if not exponent.is_polynomial(symbol):
        raise SymcheckError("no exponential of a polynomial")
    degree = sympy.degree(exponent, symbol)
    a = -sympy.Poly(exponent, symbol).LC()
    if degree == 1 and _is_wavy(rest, symbol):
        primitive = _undone(rest, symbol, a)
        yield Applied("decaying", (from_sympy(a), low), ((own, body), (own, from_sympy(primitive))))
    elif degree == 1 and low == 0:
        c, u = _power(rest, symbol)
        yield Applied("gamma_integral", (from_sympy(c), from_sympy(u), from_sympy(a)), ((own, body),))
        yield Applied("power_of_power", (from_sympy(1 / a), -1, from_sympy(-u - 1)), ())
    elif degree == 1:
        c, u = _power(rest, symbol)
        yield Applied("tail_converges", (from_sympy(c), from_sympy(u), from_sympy(a), low), ((own, body),))
    elif degree == 2 and low == 0 and sympy.Poly(exponent, symbol).nth(1) == 0:
        g, c = _reduced(rest, symbol, a, sympy.Integer(0))
        yield Applied("half_gaussian", (from_sympy(a), from_sympy(c)), ((own, body), (own, from_sympy(g))))
        yield _root(a)
    else:
        raise SymcheckError("no theorem about this integrand")


def _gaussian(body: Term, x: str) -> Hints:
    """The theorems about one Gaussian times a polynomial, if the integrand is that."""
    import sympy

    expr, symbol = _symbols(body, x)
    groups = _groups(expr, symbol)
    if len(groups) != 1:
        return []
    ((exponent, rest),) = groups.items()
    if not exponent.is_polynomial(symbol) or sympy.degree(exponent, symbol) != 2:
        return []
    q = sympy.Poly(exponent, symbol)
    if (wave := _one_wave(rest, symbol)) is not None:
        terms = tuple(map(from_sympy, (-q.nth(2), q.nth(1), *wave)))
        return [Applied("gaussian_wave", terms, (((x,), body), ((x,), 0))), _root(-q.nth(2))]
    if not rest.is_polynomial(symbol):
        return []
    g, c = _reduced(rest, symbol, -q.nth(2), q.nth(1))
    terms = from_sympy(-q.nth(2)), from_sympy(q.nth(1)), from_sympy(c)
    return [Applied("gaussian", terms, (((x,), body), ((x,), from_sympy(g)))), _root(-q.nth(2))]


def _numbers(body: Term, x: str) -> Hints:
    """What the powers of numbers that are squares are, in an integral of a power of x by one of p x^2 + q."""
    import sympy

    expr, symbol = _symbols(body, x)
    if not expr.is_rational_function(symbol):
        return []
    above, below = sympy.fraction(sympy.factor(expr))
    bases = [each.as_base_exp() for each in sympy.Mul.make_args(below) if each.has(symbol)]
    if len(bases) != 1:
        return []
    ((base, r),) = bases
    q = sympy.Poly(base, symbol)
    if q.degree() != 2 or q.nth(1) != 0 or not all(c.is_Rational and c.is_positive for c in (q.nth(0), q.nth(2))):
        return []
    half = sympy.Rational(sympy.degree(above, symbol) + 1, 2)
    powers = [(q.nth(2), -half), (q.nth(0), half - r)]
    roots = [(sympy.sqrt(number), u) for number, u in powers if number != 1]
    return [
        Applied("power_of_power", (from_sympy(root), 2, from_sympy(u)), ()) for root, u in roots if root.is_Rational
    ]


def _one_wave(rest: Expr, x: Symbol) -> tuple[Expr, Expr, Expr] | None:
    """(c, u, v) with c cos(u x + v), if it is that."""
    import sympy

    c, wave = rest.as_independent(x, as_Add=False)
    if not isinstance(wave, sympy.sin | sympy.cos) or not wave.args[0].is_polynomial(x):
        return None
    u, v = (sympy.Poly(wave.args[0], x).nth(k) for k in (1, 0))
    known = sympy.degree(wave.args[0], x) == 1
    return (c, u, v - sympy.pi / 2 if isinstance(wave, sympy.sin) else v) if known else None


def _shifted(body: Term, x: str) -> Hints:
    """The theorem that moves the middle of a quadratic divisor to 0, if an integrand has one that is elsewhere."""
    import sympy

    expr, symbol = _symbols(body, x)
    if not expr.is_rational_function(symbol):
        return []
    _, below = sympy.fraction(sympy.together(expr))
    quadratic = [sympy.Poly(base, symbol) for base, _ in sympy.factor_list(below, symbol)[1]]
    middles = {sympy.cancel(q.nth(1) / (2 * q.nth(2))) for q in quadratic if q.degree() == 2}
    if len(middles) != 1 or 0 in middles:
        return []
    (a,) = middles
    centred = from_sympy(sympy.factor(expr.subs(symbol, symbol - a)))
    return [Applied("shifted", (from_sympy(a),), (((x,), body), ((x,), centred))), *_numbers(centred, x)]


def _root(a: Expr) -> Applied[Term]:
    """That the root of pi/a is what it is where letters are positive."""
    import sympy

    whole = node("sqrt", node("/", PI, from_sympy(a)))
    apart = sympy.sqrt(sympy.pi / sympy.factor(a)).replace(sympy.Abs, lambda inner: inner)
    return Applied("equal_squares", (from_sympy(apart), whole), ())


def _power(rest: Expr, x: Symbol) -> tuple[Expr, Expr]:
    """(c, u) with c x^u; SymcheckError for anything else."""
    import sympy

    c, factors = sympy.powsimp(rest).as_independent(x, as_Add=False)
    u = sympy.Integer(0)
    for factor in sympy.Mul.make_args(factors):
        base, exponent = factor.as_base_exp()
        if base != x or exponent.has(x):
            if factor == 1:
                continue
            raise SymcheckError(f"{factor} is no power of {x}")
        u += exponent
    return c, sympy.expand(u)


def _is_wavy(rest: Expr, x: Symbol) -> bool:
    """Whether it is a polynomial in the letter, sines and cosines of its multiples."""
    import sympy

    waves = rest.atoms(sympy.sin, sympy.cos)
    plain = rest.subs({wave: sympy.Dummy() for wave in waves})
    return bool(plain.is_polynomial(x)) and all(
        w.args[0].is_polynomial(x) and sympy.degree(w.args[0], x) <= 1 for w in waves
    )


def _undone(rest: Expr, x: Symbol, a: Expr) -> Expr:
    """g with (exp(-a x) g)' = exp(-a x) rest."""
    import sympy
    from sympy.simplify.fu import TR8

    total = sympy.Integer(0)
    for addend in sympy.Add.make_args(sympy.expand(TR8(rest))):
        waves = [
            factor
            for factor in sympy.Mul.make_args(addend)
            if isinstance(factor, sympy.sin | sympy.cos) and factor.has(x)
        ]
        if len(waves) > 1:
            raise SymcheckError("products of sines")
        slope = sympy.Poly(waves[0].args[0], x).nth(1) if waves else sympy.Integer(0)
        rate, p = addend / waves[0] if waves else addend, sympy.Integer(0)
        # divided by -a + i slope again and again, in real and imaginary parts
        real, imaginary = sympy.Integer(1), sympy.Integer(0)
        g_real, g_imaginary, sign = sympy.Integer(0), sympy.Integer(0), 1
        while rate != p:
            below = a**2 + slope**2 if waves else a
            if waves:
                real, imaginary = (-a * real + slope * imaginary) / below, (-a * imaginary - slope * real) / below
            else:
                real = -real / below
            g_real, g_imaginary = g_real + sign * rate * real, g_imaginary + sign * rate * imaginary
            rate, sign = sympy.expand(sympy.diff(rate, x)), -sign
        if not waves:
            total += g_real
        else:
            angle = waves[0].args[0]
            c, s = sympy.cos(angle), sympy.sin(angle)
            cosine = isinstance(waves[0], sympy.cos)
            total += g_real * c - g_imaginary * s if cosine else g_real * s + g_imaginary * c
    return total


def _reduced(rest: Expr, x: Symbol, a: Expr, b: Expr) -> tuple[Expr, Expr]:
    """(g, c) with rest = g' + (b - 2 a x) g + c."""
    import sympy

    if not rest.is_polynomial(x):
        raise SymcheckError(f"no polynomial in {x}")
    g, left = sympy.Integer(0), sympy.Poly(rest, x)
    while left.degree() > 0:
        step = -left.LC() / (2 * a) * x ** (left.degree() - 1)
        g += step
        left = sympy.Poly(sympy.expand(left.as_expr() - sympy.diff(step, x) - (b - 2 * a * x) * step), x)
        left = sympy.Poly({m: sympy.cancel(c) for m, c in left.terms()}, x) if left.as_expr() != 0 else left
    return g, left.as_expr()
