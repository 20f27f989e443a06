r"""Limits by derivatives: `\lim_{x \to a} N/D`, and equations that say what such a limit is.

If D vanishes at a to the order k, N/D tends to L exactly if the derivatives of N - L D up to the k-th vanish there.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, TypeGuard

from symcheck.core.calculus import letters, substituted
from symcheck.core.terms import Formula, Node, Term, node
from symcheck.core.verdicts import NoForm, SymcheckError
from symcheck.reading.sympy_bridge import from_sympy, to_sympy

if TYPE_CHECKING:
    from sympy import Expr, Symbol

# x \to a, from one side perhaps
_TENDS = re.compile(r"^_\{\s*(.+?)\s*\\(?:to|rightarrow|longrightarrow)(?![A-Za-z])\s*(.+?)\s*\}$")
_SIDE = re.compile(r"\s*\^\s*\{?\s*[+-]\s*\}?$")  # from above or from below
# the place of a limit for large values
_INFINITE = re.compile(r"\+?\s*\\infty$")
MOST = 6  # derivatives: each is longer than the one before
FAULTS = (ArithmeticError, ValueError, TypeError, AttributeError, NotImplementedError, RecursionError)  # of SymPy


def tends(scripts: str) -> tuple[str, str] | None:
    r"""What goes where, from the scripts of a limit as printed; "" for infinity."""
    match = _TENDS.match(scripts)
    if match is None:
        return None
    place = _SIDE.sub("", match[2])
    return match[1], "" if _INFINITE.match(place) else place


def equated(body: Term, x: str, place: Term | None, value: Term) -> list[Formula]:
    """That a term tends to a value as a letter goes to a place, or to infinity."""
    if x in letters(value):
        raise NoForm(f"a limit that depends on {x}, of which it is taken")
    if _is_power(body, x):
        limit_, there = limit(body, x, place)
        return [*there, node("=", limit_, value)]
    top, bottom = quotient(body) if place is not None else _inverted(body, x)
    at: Term = 0 if place is None else place
    order = _order(bottom, x, at)
    gap = node("+", top, node("-", node("*", value, bottom)))
    lowest = node("diff", bottom, x, order, at)
    found: list[Formula] = [node("=", node("diff", bottom, x, n, at), 0) for n in range(order)]
    found += [node("=", node("diff", gap, x, n, at), 0) for n in range(order)]
    return [*found, node("=", node("/", node("diff", gap, x, order, at), lowest), 0)]


def limit(body: Term, x: str, place: Term | None) -> tuple[Term, list[Formula]]:
    """To what a term tends as a letter goes to a place, or to infinity, and that there is this limit."""
    if _is_power(body, x):
        plain = _without_roots(body, x) if place is None else body
        if x not in letters(plain):
            return plain, []
        if plain != body:
            return limit(plain, x, place)
        base, exponent = body.outside
        inner, there = limit(node("*", exponent, node("log", base)), x, place)
        return node("exp", inner), there
    top, bottom = quotient(body) if place is not None else _inverted(body, x)
    at: Term = 0 if place is None else place
    order = _order(bottom, x, at)
    if order and _order(top, x, at, order) < order:
        raise NoForm("a limit that may be infinite has no algebraic form")
    lower = [node("=", _slope(part, x, n, at), 0) for part in (bottom, top) for n in range(order)]
    return node("/", _slope(top, x, order, at), _slope(bottom, x, order, at)), lower


def _is_power(term: Term, x: str) -> TypeGuard[Node]:
    """Whether it is a power whose exponent moves: e to the exponent times the logarithm of its base."""
    return isinstance(term, Node) and term.tag == "pow" and x in letters(term.outside[1])


def _without_roots(body: Term, x: str) -> Term:
    """A root of growing order without what has a limit: of a power it is constant, of a polynomial it is 1."""
    if not _is_power(body, x):
        return body
    import sympy

    letter = sympy.Symbol(x, real=True)
    base, exponent = body.outside
    try:
        order = sympy.cancel(to_sympy(exponent) * letter)
        if not order.is_Rational or order == 0:
            return body
        kept, rest = list[Term](), list[Term]()
        for inner, power, sized in _powers(base, 1, sized=False):
            rate = sympy.cancel(to_sympy(power) / letter)
            if not rate.is_Rational or rate == 0:
                if sized and not (to_sympy(power).is_Rational and _grows(to_sympy(inner) ** 2, letter)):
                    inner, sized = node("sqrt", node("^", inner, 2)), False
                if not sized:
                    rest.append(inner if power == 1 else node("pow", inner, power))
                continue
            number = to_sympy(inner)
            if not (number.is_Rational and number.is_positive):
                if not (sized or (rate.is_Integer and rate % 2 == 0)):
                    return body
                inner = node("sqrt", node("^", inner, 2))
            steps = rate * order
            kept.append(inner if steps == 1 else node("pow", inner, from_sympy(steps)))
        left = _product(*rest)
        if left != 1 and not _grows(to_sympy(left), letter):
            kept.append(node("pow", left, exponent))
    except (SymcheckError, *FAULTS):
        return body
    return _product(*kept)


def _powers(term: Term, power: Term, *, sized: bool) -> Iterator[tuple[Term, Term, bool]]:
    """The factors of a term as bases with exponents, and whether their absolute values are meant."""
    match term:
        case Node(tag="sqrt", outside=(Node(tag="^", outside=(inner, 2)),)):
            yield from _powers(inner, power, sized=True)
        case Node(tag="*", outside=factors):
            for factor in factors:
                yield from _powers(factor, power, sized=sized)
        case Node(tag="/", outside=(top, bottom)):
            yield from _powers(top, power, sized=sized)
            yield from _powers(bottom, node("*", -1, power), sized=sized)
        case Node(tag="pow", outside=(base, exponent)):
            raised = exponent if power == 1 else node("*", power, exponent)
            match base:
                case Node(tag="sqrt", outside=(Node(tag="^", outside=(inner, 2)),)):
                    yield inner, raised, True
                case _:
                    yield base, raised, sized
        case _:
            yield term, power, sized


def _grows(expr: Expr, letter: Symbol) -> bool:
    """Is it a rational function that is positive from some number on, as the quotient of its first coefficients is?"""
    import sympy

    if not (expr.has(letter) and expr.is_rational_function(letter)):
        return False
    top, bottom = (sympy.Poly(part, letter) for part in sympy.fraction(sympy.cancel(expr)))
    return bool((top.LC() / bottom.LC()).is_positive)


def turns(body: Term, x: str, at: Term) -> bool:
    """Whether a term changes its sign at a place where it vanishes, so that its reciprocal has no limit there."""
    top, bottom = quotient(body)
    return bool((_order(top, x, at) - _order(bottom, x, at)) % 2)


def _slope(term: Term, x: str, order: int, at: Term) -> Term:
    return node("diff", term, x, order, at) if order else substituted(term, {x: at})


def quotient(term: Term) -> tuple[Term, Term]:
    """Top and bottom of a term made of fractions."""
    if isinstance(term, Node) and term.tag == "tan":
        return node("sin", *term.terms), node("cos", *term.terms)
    if not isinstance(term, Node) or term.tag not in ("+", "*", "-", "/", "^"):
        return term, 1
    if term.tag == "^":
        base, exponent = term.terms
        top, bottom = quotient(base)
        if not isinstance(exponent, int) or (exponent > 0 and bottom == 1):
            return term, 1
        powers = [part if part == 1 else node("^", part, abs(exponent)) for part in (top, bottom)]
        return (powers[0], powers[1]) if exponent > 0 else (powers[1], powers[0])
    parts = [quotient(part) for part in term.terms]
    if term.tag == "-":
        return node("-", parts[0][0]), parts[0][1]
    if term.tag == "/":
        (a, b), (c, d) = parts
        return _product(a, d), _product(b, c)
    if term.tag == "*":
        return _product(*(top for top, _ in parts)), _product(*(bottom for _, bottom in parts))
    bottoms = [bottom for _, bottom in parts]
    tops = [_product(top, *bottoms[:k], *bottoms[k + 1 :]) for k, (top, _) in enumerate(parts)]
    return node("+", *tops), _product(*bottoms)


def _product(*terms: Term) -> Term:
    kept = [term for term in terms if term != 1]
    return node("*", *kept) if len(kept) > 1 else kept[0] if kept else 1


def _inverted(body: Term, x: str) -> tuple[Term, Term]:
    """Top and bottom in the inverse of a letter that goes to infinity."""
    import sympy

    letter, small = sympy.Symbol(x, real=True), sympy.Symbol(x, positive=True)
    try:
        expr = sympy.cancel(sympy.together(to_sympy(body).subs(letter, 1 / small)))
        top, bottom = (from_sympy(part.subs(small, letter)) for part in sympy.fraction(expr))
    except (SymcheckError, *FAULTS):
        raise NoForm(f"a limit for large {x} that is no quotient of sums has no algebraic form") from None
    return top, bottom


def _order(term: Term, x: str, at: Term, most: int = MOST) -> int:
    """How often a term vanishes at a place, up to `most`; that it does is part of what is stated."""
    if isinstance(term, int) and term:
        return 0
    import sympy

    try:
        expr, letter, place = to_sympy(term), to_sympy(x), to_sympy(at)
        for order in range(most):
            if sympy.simplify(sympy.diff(expr, letter, order).subs(letter, place)) != 0:
                return order
        if most < MOST:
            return most
    except (SymcheckError, *FAULTS):
        pass
    raise NoForm("a limit whose denominator vanishes to a high order, or has no derivatives, has no algebraic form")
