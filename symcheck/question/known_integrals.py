"""Integrals that everybody knows, for what no proof by an antiderivative reaches: of the Cauchy and Weibull densities.

An integrand is, for all t between the ends, C/((t - m)^2 + s^2), or a sum of c t^u exp(-a t^v - b t^-v), or one of
multiples of whole powers of a + b cos(m t) + c sin(m t), with what does not depend on t. That it is that is proved,
and that s, a, v, u + 1 and a^2 - b^2 - c^2 are positive, or b in the place of u + 1. What is left to trust is the
arctangent as an antiderivative with its limits, the substitution that makes Euler's integral of t^v, and Laplace's
integrals: with r^2 = a^2 - b^2 - c^2 the means of the powers k and -k - 1 over a turn are r^k P_k(a/r) and
r^(-k - 1) P_k(a/r), where P_k are Legendre polynomials. Where c is 0 they are those over half a turn from a multiple of
it on, too. From 0 on, t^(w - 1) exp(-a t - b/t) has the integral 2 (b/a)^(w/2) K_w(2 sqrt(a b)) (DLMF 10.32.10), where
the modified Bessel function K_w is an elementary one for each half of an odd number w (DLMF 10.49.12). Those of
t^(z - 1) cos t and t^(z - 1) sin t are Gamma(z) cos(pi z/2) for 0 < z < 1 and Gamma(z) sin(pi z/2) for -1 < z < 1,
where it is pi/2 at z = 0 (DLMF 5.9.6, 5.9.7); they converge, though not absolutely.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING

from symcheck.core.calculus import domain, fresh, functions, letters, nodes, substituted
from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import INFINITY, MINUS_INFINITY, PI, Binder, Formula, Node, T, Term, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.question.prepare import rooted
from symcheck.question.series import FAULTS, Series, put
from symcheck.reading import from_sympy, to_sympy

if TYPE_CHECKING:
    from sympy import Expr, Symbol

MOST = 6  # addends of an integrand
Known = tuple[Term, Term, list[Formula]]  # the value, the integrand in the form of the table, and what has to hold


def with_values(problem: Problem) -> Series | None:
    """The problem with values for its integrals; None if there are none, or one has none that is known here."""
    found = {part: None for part in nodes(problem.claim) if isinstance(part, Binder) and part.tag == "integral"}
    if not found or functions(problem.claim) or problem.definitions:
        return None
    taken = letters(problem.claim).union(*(letters(f) for _, fs in problem.hypotheses for f in fs))
    sides, values = list[Problem](), dict[Term, Term]()
    for integral in found:
        t, (low, high) = fresh(integral.letter, taken), integral.outside
        body = substituted(integral.body, {integral.letter: t})
        known = next(_known(body, t, low, high), None)
        if known is None:
            return None
        values[integral], form, needed = known
        between = [node("<", low, t)] if low != MINUS_INFINITY else []
        between += [node("<", t, high)] if high != INFINITY else []
        given = (*problem.hypotheses, ("between", tuple(between))) if between else problem.hypotheses
        sides += [replace(problem, claim=each) for each in needed]
        valued = [each for each in domain(body, divisors=True) if t in letters(each) and not _is_turned(form, t)]
        same = node("=", body, rooted(form))
        sides += [replace(problem, claim=each, hypotheses=given) for each in valued]
        sides.append(replace(problem, claim=same, hypotheses=given, hints=(*problem.hints, *_of_roots(same))))
    claim = put(problem.claim, values)
    return Series(replace(problem, claim=claim, hints=(*problem.hints, *_of_roots(claim))), tuple(sides))


def is_beyond_primitives(problem: Problem) -> bool:
    """Is there an integrand to infinity that no other proof allows?

    With the letter below the line in an exponent, or with its sine or cosine and nothing that decays exponentially.
    """
    for integral in nodes(problem.claim):
        if isinstance(integral, Binder) and integral.tag == "integral" and integral.outside[1] == INFINITY:
            x = integral.letter
            own = [part for part in nodes(integral.body) if x in letters(part)]
            tags = {part.tag for part in own}
            inside = (each for part in own if part.tag == "exp" for each in nodes(part) if each.tag == "/")
            if ({"sin", "cos"} & tags and "exp" not in tags) or any(x in letters(each.outside[1]) for each in inside):
                return True
    return False


def _of_roots(claim: Formula) -> Iterator[Applied[Term]]:
    """That roots of products and quotients are those of their factors, which are positive in what is integrated."""
    for root in dict.fromkeys(part for part in nodes(claim) if part.tag == "sqrt"):
        if (apart := _root_of(root.outside[0])) != root:
            yield Applied("equal_squares", (root, apart), ())
    for part in dict.fromkeys(part for part in nodes(claim) if part.tag == "exp"):
        if (other := _with_roots_apart(part)) != part:
            yield Applied("congruence", (part, other), ())


def _with_roots_apart(tree: T) -> T:
    if not isinstance(tree, Node):
        return tree
    return _root_of(tree.outside[0]) if tree.tag == "sqrt" else mapped(tree, _with_roots_apart)  # type: ignore[return-value]


def _root_of(term: Term) -> Term:
    match term:
        case Node(tag="*" | "/" as tag, outside=parts):
            return node(tag, *map(_root_of, parts))
        case Node(tag="^", outside=(base, int(n))) if n > 1:
            return node("*", node("^", base, n // 2), node("sqrt", base)) if n % 2 else node("^", base, n // 2)
        case 1:
            return 1
    return node("sqrt", term)


def _is_turned(form: Term, t: str) -> bool:
    """Is it one in a sine or cosine, which has a value everywhere, as by what has to hold its base is positive?"""
    return any(part.tag in ("sin", "cos") and t in letters(part) for part in nodes(form))


def _known(body: Term, t: str, low: Term, high: Term) -> Iterator[Known]:
    """The value of an integral, if it is in the table."""
    from sympy import PolynomialError

    for way in (_arctangent, _exponential, _turned, _waving):
        with suppress(*FAULTS, PolynomialError):
            yield way(body, t, low, high)


def _waving(body: Term, t: str, low: Term, high: Term) -> Known:
    """The integral of a power times the sine or cosine of a multiple of a power, from 0 or over the whole line."""
    import sympy

    expr, x, back = _positive(body, t)
    c, rest = sympy.powsimp(expr).as_independent(x, as_Add=False)
    factors = sympy.Mul.make_args(rest)
    waves = [factor for factor in factors if isinstance(factor, sympy.sin | sympy.cos)]
    if high != INFINITY or low not in (0, MINUS_INFINITY) or len(waves) != 1:
        raise SymcheckError("no integral of one wave to infinity")
    base, u = sympy.powsimp(sympy.Mul(*(factor for factor in factors if factor not in waves))).as_base_exp()
    a, power = waves[0].args[0].as_independent(x, as_Add=False)
    place, v = power.as_base_exp()
    u = sympy.Integer(0) if base == 1 else u
    if base not in (1, x) or place != x or u.has(x) or v.has(x):
        raise SymcheckError("no powers")
    whole = low == MINUS_INFINITY
    if whole and not (u.is_Integer and v.is_Integer and u >= 0 and v > 0 and u % 2 == v % 2 == 0):
        raise SymcheckError("no even integrand")
    sine, z = isinstance(waves[0], sympy.sin), sympy.cancel((u + 1) / v)
    mean = sympy.pi / 2 if z == 0 and sine else sympy.gamma(z) * waves[0].func(sympy.pi * z / 2)
    value = from_sympy(((2 if whole else 1) * c / v * a**-z * mean).subs(back))
    c_, u_, a_, v_, z_ = (from_sympy(each.subs(back)) for each in (c, u, a, v, z))
    inside = node("sin" if sine else "cos", node("*", a_, _raised(t, v_)))
    needed = [node(">", a_, 0), node(">", v_, 0), node("<", -1 if sine else 0, z_), node("<", z_, 1)]
    return value, node("*", c_, _raised(t, u_), inside), needed


def _raised(t: str, power: Term) -> Term:
    """A power, with a whole exponent as one of any number."""
    if not isinstance(power, int):
        return node("pow", t, power)
    whole = node("^", t, abs(power)) if power else 1
    return whole if power >= 0 else node("/", 1, whole)


def _turned(body: Term, t: str, low: Term, high: Term) -> Known:
    """The integral over whole turns, or over half turns, of a rational function of a sine and cosine."""
    import sympy

    x, c, s = sympy.Symbol(t, real=True), sympy.Symbol("cosine_there"), sympy.Symbol("sine_there")
    own = sympy.Symbol("base_there")
    if {low, high} & {INFINITY, MINUS_INFINITY}:
        raise SymcheckError("no turn")
    expr, times, cosine = _in_cosines(to_sympy(body), x, c, s)
    above, below = sympy.fraction(sympy.together(expr))
    constant, factors = sympy.factor_list(below, c, s)
    if len(factors) != 1 or sympy.Poly(factors[0][0], c, s).total_degree() != 1 or above.has(x):
        raise SymcheckError("no power of one sum below the line")
    ((base, power),) = factors
    if (start := base.subs({c: 0, s: 0})).is_negative or start.could_extract_minus_sign():
        base, constant = -base, constant * (-1) ** power
    a, b, e = base.subs({c: 0, s: 0}), sympy.diff(base, c), sympy.diff(base, s)
    above = sympy.rem(sympy.expand(above), s**2 + c**2 - 1, s)
    if e == 0 and b != 0 and not above.has(s):
        sums = sympy.Poly(sympy.expand(above.subs(c, (own - a) / b)), own)
    elif not above.has(c, s):
        sums = sympy.Poly(above, own)
    else:
        raise SymcheckError("a sine above the line")
    first, last = (sympy.expand(to_sympy(end) * times / sympy.pi) for end in (low, high))
    halves = last - first
    even = e == 0 and first.is_Integer
    if not halves.is_Integer or not (even or halves.is_even):
        raise SymcheckError("no whole turn")
    square = sympy.factor(a**2 - b**2 - e**2)
    size = sympy.Symbol("size_there") if square.free_symbols else sympy.sqrt(square)
    mean, form = sympy.Integer(0), sympy.Integer(0)
    for (j,), n in sums.terms():
        k = j - power
        order = k if k >= 0 else -k - 1
        mean += n / constant * size**k * sympy.legendre(order, a / size)
        form += n / constant * own**k
    angle = cosine * b + sympy.sin(times * x) * e + a
    value = from_sympy(sympy.simplify(mean) * (to_sympy(high) - to_sympy(low)))
    value = substituted(value, {str(size): node("sqrt", from_sympy(square))})
    both = [a, square] if b != 0 and e != 0 else [sympy.factor(a - b - e), sympy.factor(a + b + e)]
    needed = [node(">", from_sympy(each), 0) for each in both]
    needed += [node("!=", from_sympy(b), 0)] if sums.degree() > 0 and b.free_symbols else []
    return value, substituted(from_sympy(form), {str(own): from_sympy(angle)}), needed


def _in_cosines(expr: Expr, x: Symbol, c: Symbol, s: Symbol) -> tuple[Expr, Expr, Expr]:
    """The same with cosine and sine of a multiple of the letter, which multiple, and that cosine as it is printed."""
    import sympy

    waves = [each for each in sympy.preorder_traversal(expr) if isinstance(each, sympy.sin | sympy.cos) and each.has(x)]
    counts = [sympy.cancel(each.args[0] / x) for each in waves]
    if not counts or not all(n.is_Rational and n for n in counts):
        raise SymcheckError("no functions of multiples of the letter")
    times = sympy.gcd(list(map(abs, counts)))
    by = {}
    for each, n in zip(waves, counts, strict=True):
        whole = sympy.expand_trig(each.func(n / times * x))
        by[each] = whole.subs({sympy.cos(x): c, sympy.sin(x): s})
    above, below = (
        sympy.rem(sympy.expand(each), s**2 + c**2 - 1, s)
        for each in sympy.fraction(sympy.together(sympy.expand_power_base(expr).subs(by, simultaneous=True)))
    )
    polys = [sympy.Poly(each, c, s) for each in (above, below)]
    if all(j % 2 == 0 and k == 0 for poly in polys for j, k in poly.monoms()):
        half, doubled = sympy.sqrt((1 + c) / 2), 2 * sympy.cos(times * x) ** 2 - 1
        return sympy.expand(above.subs(c, half)) / sympy.expand(below.subs(c, half)), 2 * times, doubled
    return above / below, times, sympy.cos(times * x)


def _positive(body: Term, t: str) -> tuple[Expr, Symbol, dict[Symbol, Symbol]]:
    """A term for SymPy with positive letters, by which it simplifies roots and powers, and what these stand for."""
    import sympy

    expr = to_sympy(body)
    if (x := sympy.Symbol(t, real=True)) not in expr.free_symbols:
        raise SymcheckError("a constant")
    by = {x: sympy.Symbol(f"{x}_positive", positive=True) for x in expr.free_symbols}
    return expr.subs(by, simultaneous=True), by[x], {new: old for old, new in by.items()}


def _arctangent(body: Term, t: str, low: Term, high: Term) -> Known:
    import sympy

    expr, x, back = _positive(body, t)
    above, below = sympy.fraction(sympy.together(expr))
    q = sympy.Poly(below, x)
    if q.degree() != 2 or sympy.expand(above).has(x):
        raise SymcheckError("no quadratic alone below the line")
    middle = sympy.cancel(-q.nth(1) / (2 * q.nth(2)))
    size = sympy.sqrt(sympy.factor(q.nth(0) / q.nth(2) - middle**2))
    m, s, c = (from_sympy(sympy.cancel(each).subs(back)) for each in (middle, size, above / q.nth(2)))

    def angle(end: Term) -> Term:
        if end in (INFINITY, MINUS_INFINITY):
            return node("/", PI, 2 if end == INFINITY else -2)
        return node("arctan", node("/", node("+", end, node("-", m)), s))

    form = node("/", c, node("+", node("^", node("+", t, node("-", m)), 2), node("^", s, 2)))
    value = node("*", node("/", c, s), node("+", angle(high), node("-", angle(low))))
    return value, form, [node(">", s, 0)]


def _exponential(body: Term, t: str, low: Term, high: Term) -> Known:
    if low != 0:
        raise SymcheckError("not from 0 on")
    bases = {part.outside[0] for part in nodes(body) if part.tag == "pow" and t in letters(part.outside[0])} - {t}
    if len(bases) == 1 and (scaled := _scaled(body, t, high, *bases)) is not None:
        return scaled
    return _of_powers(body, t, high)


def _of_powers(body: Term, t: str, high: Term) -> Known:
    import sympy

    expr, x, back = _positive(body, t)
    values, forms, positive = list[Term](), list[Term](), list[Formula]()
    for addend in sympy.Add.make_args(sympy.expand(expr)):
        parts = _parts(addend, x)
        if parts[-1] != 0:
            if high != INFINITY:
                raise SymcheckError("no antiderivative in exponentials")
            whole, form, needed = _of_both_powers(*parts, t, back)
            values.append(whole)
            forms.append(form)
            positive += needed
            continue
        c, u, a, v = (from_sympy(sympy.simplify(each).subs(back)) for each in parts[:-1])
        rate, power = node("*", a, node("pow", t, v)), node("+", u, 1)
        forms.append(node("*", c, node("pow", t, u), node("exp", node("-", rate))))
        positive += [node(">", each, 0) for each in (a, v, power)]
        if high == INFINITY:
            z = node("/", power, v)
            whole = node("*", node("/", c, v), node("gamma", z), node("pow", a, node("-", z)))
        elif sympy.expand(to_sympy(node("+", power, node("-", v)))) == 0:
            left = node("exp", node("-", node("*", a, node("pow", high, v))))
            whole = node("*", node("/", c, node("*", a, v)), node("+", 1, node("-", left)))
            positive.append(node(">", high, 0))
        else:
            raise SymcheckError("no antiderivative in exponentials")
        values.append(whole)
    if len(forms) > MOST:
        raise SymcheckError("many addends")
    value, form = (each[0] if len(each) == 1 else node("+", *each) for each in (values, forms))
    return value, form, list(dict.fromkeys(positive))


def _of_both_powers(
    c: Expr, u: Expr, a: Expr, v: Expr, b: Expr, t: str, back: Mapping[Symbol, Symbol]
) -> tuple[Term, Term, list[Formula]]:
    """The same for c t^u exp(-a t^v - b t^-v) from 0 to infinity, where (u + 1)/v is half of an odd number."""
    import sympy

    w = sympy.cancel((u + 1) / v)
    n = abs(w) - sympy.Rational(1, 2)
    if not (n.is_Integer and n <= MOST):
        raise SymcheckError("no elementary Bessel function")
    z = 2 * sympy.sqrt(a * b)
    terms = (
        sympy.factorial(n + k) / (sympy.factorial(k) * sympy.factorial(n - k) * (2 * z) ** k) for k in range(int(n) + 1)
    )
    bessel = sympy.sqrt(sympy.pi / (2 * z)) * sympy.exp(-z) * sympy.Add(*terms)
    value = sympy.powsimp(sympy.expand(sympy.powdenest(2 * c / v * (b / a) ** (w / 2) * bessel)))
    whole, c_, u_, a_, v_, b_ = (from_sympy(each.subs(back)) for each in (value, c, u, a, v, b))
    power = node("pow", t, v_)
    rate = node("+", node("*", a_, power), node("/", b_, power))
    form = node("*", c_, node("pow", t, u_), node("exp", node("-", rate)))
    return whole, form, [node(">", each, 0) for each in (a_, v_, b_)]


def _scaled(body: Term, t: str, high: Term, base: Term) -> Known | None:
    """The same for an integrand with powers of a multiple w of t, by the integral over w."""
    import sympy

    scale = sympy.cancel(sympy.Symbol(t, real=True) / to_sympy(base))
    if scale.has(sympy.Symbol(t, real=True)):
        return None
    size, w = from_sympy(scale), fresh(t, letters(body))

    def put(tree: T) -> T:
        if tree == base:
            return w  # type: ignore[return-value]
        return mapped(tree, put) if isinstance(tree, Node) else tree  # type: ignore[return-value]

    inside = substituted(put(body), {t: node("*", size, w)})
    whole, form, positive = _of_powers(inside, w, high if high == INFINITY else node("/", high, size))
    same = node("=", node("*", size, base), t)
    return node("*", size, whole), substituted(form, {w: base}), [node(">", size, 0), same, *positive]


def _parts(addend: Expr, x: Symbol) -> tuple[Expr, Expr, Expr, Expr, Expr]:
    """(c, u, a, v, b) with c x^u exp(-a x^v - b x^-v); a alone is not 0 where there is one exponential."""
    import sympy

    number, rest = addend.as_coeff_Mul()
    logarithm = sympy.expand(sympy.expand_log(sympy.log(rest), force=True))
    c, u = sympy.Integer(0), sympy.Integer(0)
    rates: dict[Expr, Expr] = {}
    for part in sympy.Add.make_args(logarithm):
        if not part.has(x):
            c += part
        elif not (rate := part / sympy.log(x)).has(x):
            u += rate
        else:
            a, power = sympy.powsimp(sympy.expand_power_base(part, force=True)).as_independent(x, as_Add=False)
            base, v = power.as_base_exp()
            if base != x or v.has(x):
                raise SymcheckError("no exponential of a power")
            rates[v] = rates.get(v, 0) - a
    if len(rates) == 1:
        ((v, a),) = rates.items()
        return number * sympy.exp(c), u, a, v, sympy.Integer(0)
    if len(rates) == 2 and sympy.expand(sum(rates)) == 0:
        v = next(v for v in rates if not v.could_extract_minus_sign())
        return number * sympy.exp(c), u, sympy.factor(rates[v]), v, sympy.factor(rates[sympy.expand(-v)])
    raise SymcheckError("no exponential of a power")
