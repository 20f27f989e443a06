"""Integrals that everybody knows, for what no proof by an antiderivative reaches: of the Cauchy and Weibull densities.

An integrand is, for all t between the ends, C/((t - m)^2 + s^2), or a sum of c t^u exp(-a t^v), with what does not
depend on t. That it is that is proved, and that s, a, v and u + 1 are positive. What is left to trust is the arctangent
as an antiderivative with its limits, and the substitution that makes Euler's integral of t^v.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING

from symcheck.core.calculus import domain, fresh, functions, letters, nodes, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import INFINITY, MINUS_INFINITY, PI, Binder, Formula, Node, T, Term, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.question.series import FAULTS, Series
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
        valued = [each for each in domain(body, divisors=True) if t in letters(each)]
        sides += [replace(problem, claim=each, hypotheses=given) for each in (*valued, node("=", body, form))]

    def put(tree: T) -> T:
        if tree in values:
            return values[tree]  # type: ignore[return-value]
        return mapped(tree, put) if isinstance(tree, Node) else tree  # type: ignore[return-value]

    return Series(replace(problem, claim=put(problem.claim)), tuple(sides))


def _known(body: Term, t: str, low: Term, high: Term) -> Iterator[Known]:
    """The value of an integral, if it is in the table."""
    from sympy import PolynomialError

    for way in (_arctangent, _exponential):
        with suppress(*FAULTS, PolynomialError):
            yield way(body, t, low, high)


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
        c, u, a, v = (from_sympy(sympy.simplify(each).subs(back)) for each in _parts(addend, x))
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


def _parts(addend: Expr, x: Symbol) -> tuple[Expr, Expr, Expr, Expr]:
    """(c, u, a, v) with c x^u exp(-a x^v)."""
    import sympy

    number, rest = addend.as_coeff_Mul()
    logarithm = sympy.expand(sympy.expand_log(sympy.log(rest), force=True))
    c, u, exponent = sympy.Integer(0), sympy.Integer(0), sympy.Integer(0)
    for part in sympy.Add.make_args(logarithm):
        if not part.has(x):
            c += part
        elif not (rate := part / sympy.log(x)).has(x):
            u += rate
        else:
            exponent += part
    a, power = sympy.powsimp(sympy.expand_power_base(exponent, force=True)).as_independent(x, as_Add=False)
    base, v = power.as_base_exp()
    if base != x or v.has(x):
        raise SymcheckError("no exponential of a power")
    return number * sympy.exp(c), u, -a, v
