r"""Generating functions of families of polynomials, such as \sum_n P_n(x) t^n = 1/\sqrt{1 - 2 x t + t^2}.

The recurrence of the polynomials, with the ratio of what they are multiplied by, is a recurrence of the coefficients of
a power series in t, so that its sum has a linear differential equation in t. What is claimed is the sum if it has the
same equation and the same first two coefficients, as these determine all others. Where the equation is singular for
some t, something has to be given of t, and points that are given lie inside the circle of convergence. What is left to
trust is that there the sum is the analytic function with its coefficients: under roots and logarithms no factor is
square, so that those that are printed have no other branch there.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product
from typing import TYPE_CHECKING

from symcheck.core.calculus import derivative, domain, functions, letters, nodes, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import Malformed, Node, Term, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.proof.algebra.polynomial import number_of
from symcheck.question.hypergeometric import plainly, ratio, worked_out
from symcheck.question.prepare import DEFINED, Asked, Reading, readings, sides
from symcheck.question.series import FAULTS
from symcheck.question.special import ITS_USUAL, NAMED, SAID_SO, USUAL, step_of, written
from symcheck.reading import from_sympy, tex, to_sympy

if TYPE_CHECKING:
    from sympy import Expr, Poly, Symbol

# the sum over all orders, and a member of a family there
_SUM = re.compile(r"\\sum_\{(?P<n>[a-z])=0\}\^\{\\infty\}(?P<body>.*)")
# a member of a family with a letter for its order and one for its argument
_MEMBER = re.compile(
    r"(?:\\(?:mathrm|text)\{)?(?P<letter>[A-Z][a-z]?)\}?_\{?(?P<n>[a-z])\}?(?:\\left)?\((?P<x>[a-z])(?:\\right)?\)"
)
STANDS = "cbhuvwyz"  # letters that may stand for a member
TOLD = 4  # coefficients at which a claim is looked at
GRID = (Fraction(-7, 4), Fraction(-1, 3), Fraction(2, 7), Fraction(8, 9), Fraction(9, 5), Fraction(29, 10))
CIRCLE = 1e-9  # relative; how near the circle of convergence points may lie


@dataclass(frozen=True)
class Generated:
    """A claim about a generating function.

    Parameters
    ----------
    reading
        Its reading, with a letter for the member.
    name
        The name of the family.
    told
        What is told of the letter of the family.
    declared
        Whether somebody says so.
    first
        The claims about the first coefficients, of which two have to hold.
    equation
        The differential equation of what is claimed; None where points lie outside the circle of convergence.
    """

    reading: Reading
    name: str
    told: Mapping[str, str]
    declared: bool
    first: tuple[Problem, ...]
    equation: Problem | None


def generated(asked: Asked, declared: Mapping[str, str]) -> Generated | None:
    """What is asked about a generating function; None if it is something else."""
    both = sides(asked.relation)
    if both is None or r"\infty" not in asked.relation or asked.where:
        return None
    for left, right in (both, both[::-1]):
        match = _SUM.fullmatch(left)
        members = [*_MEMBER.finditer(match["body"])] if match else []
        if match is None or len(members) != 1 or members[0]["n"] != match["n"] or r"\sum" in right:
            continue
        (member,) = members
        letter, n, x = member["letter"], match["n"], member["x"]
        name = declared.get(letter) or (USUAL[letter].names[letter] if letter in USUAL else "")
        if name not in NAMED or NAMED[name][0] not in NAMED[name][1].step:
            return None
        taken = {token for text in (asked.relation, *asked.given) for token in tex.texts(text)}
        own = next(each for each in STANDS if each not in taken)
        body = match["body"][: member.start()] + f" {own} " + match["body"][member.end() :]
        one = replace(asked, relation=f"{body}={right}", letters=(*asked.letters, (n, "integer"), (own, "scalar")))
        with suppress(*FAULTS, Malformed):
            (reading, *others) = readings(one)
            (problem, *more) = reading.problems
            if others or more or problem.definitions:
                return None
            told = {f"{letter}_{n}": f"a {name} {SAID_SO if letter in declared else ITS_USUAL}"}
            return _understood(reading, problem, name, told, letter in declared, (n, x, own))
        return None
    return None


def _understood(
    reading: Reading, problem: Problem, name: str, told: Mapping[str, str], declared: bool, names: tuple[str, str, str]
) -> Generated:
    import sympy

    n, x, own = names
    index = sympy.Symbol(n, real=True)
    addend, value = problem.claim.terms
    weight = plainly(to_sympy(addend) / sympy.Symbol(own, real=True), index)
    quotient = ratio(weight, index)
    if weight.has(sympy.Symbol(own, real=True)) or own in letters(value) or n in letters(value):
        raise SymcheckError("no multiple of a member")
    variables = [s for s in quotient.free_symbols - {index} if not (quotient / s).has(s)]
    if len(variables) != 1:
        raise SymcheckError("no power series in one letter")
    (t,) = variables
    if str(t) == x or str(t) not in letters(value) or functions(value):
        raise SymcheckError("no power series in a letter of its own")
    given = (
        each for each in problem.hypotheses if each[0] != DEFINED and not any({n, own} & letters(f) for f in each[1])
    )
    problem = replace(problem, hypotheses=(*given, (DEFINED, tuple(domain(value, divisors=True)))))
    of_others = tuple(each for each in problem.hypotheses if not any(str(t) in letters(f) for f in each[1]))
    usual = NAMED[name][0]
    first = list[Problem]()
    for k in range(TOLD):
        member = written(usual, name, Fraction(k))
        if member is None:
            raise SymcheckError("a member is not known")
        factor = sympy.simplify((weight / t**index).subs(index, k)) * sympy.factorial(k)
        coefficient = node("*", from_sympy(factor), substituted(member, {"x": x}))
        slope = _folded(substituted(_slope(value, str(t), k), {str(t): 0}))
        first.append(replace(problem, claim=node("=", slope, worked_out(coefficient)), hypotheses=of_others))
    equation = _equation(problem, value, name, sympy.factor(quotient / t), (index, t, x), first[:2])
    return Generated(reading, name, told, declared, tuple(first), equation)


def _equation(
    problem: Problem, value: Term, name: str, quotient: Expr, at: tuple[Symbol, Symbol, str], first: list[Problem]
) -> Problem | None:
    """The differential equation that a function with the coefficients has, of what is claimed."""
    import sympy

    n, t, x = at
    now, before = (to_sympy(each) for each in step_of(name, str(n), x))
    parts = now * quotient, before * quotient * quotient.subs(n, n - 1)
    below = sympy.lcm([sympy.fraction(sympy.together(each))[1] for each in parts])
    ahead, same, back = (sympy.Poly(sympy.cancel(each * below), n) for each in (1, *parts))
    if any(root.is_integer and root >= 1 for root in sympy.roots(ahead)) or ahead.has(*(ahead.free_symbols - {n})):
        raise SymcheckError("coefficients that are not determined by those before")
    # sum of D(n) a(n + 1) t^(n + 1) from n = 1 on: with m = n + 1 and the operator m = t d/dt
    slope = _operator(ahead.compose(sympy.Poly(n - 1, n)), t, 0)
    slope = _less(slope, _operator(same, t, 1))
    slope = _less(slope, _operator(back.compose(sympy.Poly(n + 1, n)), t, 2))
    zeroth, linear = (each.claim.terms[1] for each in first)
    rest = (
        ahead.eval(-1) * to_sympy(zeroth) + ahead.eval(0) * to_sympy(linear) * t - same.eval(0) * to_sympy(zeroth) * t
    )
    leading = sympy.factor(slope[max(slope)] / t ** max(slope))
    if not _converges(problem, leading, t) or not _is_single(value, str(t)):
        return None
    addends = [
        node("*", from_sympy(c), node("diff", value, str(t), k, str(t)) if k else value) for k, c in slope.items()
    ]
    return replace(problem, claim=node("=", node("+", 0, *addends), from_sympy(sympy.expand(rest))))


def _folded(tree: Term) -> Term:
    """A term without products and powers of 0 and 1, and without what they are added to."""
    if not isinstance(tree, Node):
        return tree
    new = mapped(tree, _folded)
    parts = new.outside
    match new.tag:
        case "*":
            rest = [part for part in parts if part != 1]
            return 0 if 0 in parts else node("*", *rest) if len(rest) > 1 else rest[0] if rest else 1
        case "+":
            rest = [part for part in parts if part != 0]
            return node("+", *rest) if len(rest) > 1 else rest[0] if rest else 0
        case "-" | "sqrt" if parts[0] == 0:
            return 0
        case "sqrt" | "pow" | "^" if parts[0] == 1:
            return 1
        case "^" if parts[0] == 0 and parts[1] != 0:
            return 0
        case "/" if parts[1] == 1 or parts[0] == 0:
            return parts[0]
        case "exp" if parts[0] == 0:
            return 1
    return new


def _slope(value: Term, t: str, order: int) -> Term:
    for _ in range(order):
        value = derivative(value, t)
    return value


def _operator(poly: Poly, t: Symbol, power: int) -> dict[int, Expr]:
    """A polynomial in t d/dt, times a power of t, by the orders of derivatives."""
    import sympy
    from sympy.functions.combinatorial.numbers import stirling

    found: dict[int, Expr] = {}
    for (k,), c in poly.terms():
        for j in range(k + 1):
            found[j] = found.get(j, sympy.Integer(0)) + c * stirling(k, j) * t ** (j + power)
    return {j: sympy.expand(each) for j, each in found.items()}


def _less(one: Mapping[int, Expr], other: Mapping[int, Expr]) -> dict[int, Expr]:
    import sympy

    found = {j: sympy.expand(one.get(j, 0) - other.get(j, 0)) for j in {*one, *other}}
    return {j: each for j, each in sorted(found.items()) if each != 0}


def _converges(problem: Problem, leading: Expr, t: Symbol) -> bool:
    """Whether all points that are given, as far as is tried, lie inside the circle of convergence."""
    import sympy

    singular = sympy.Poly(leading, t)
    if singular.degree() == 0:
        return True
    given = [f for _, fs in problem.hypotheses for f in fs if letters(f)]
    names = sorted({str(s) for s in singular.free_symbols_in_domain} | {str(t)} | set().union(*map(letters, given)))
    bounded = [f for f in given if str(t) in letters(f)]
    if not bounded or len(names) > len(GRID) // 2:
        return False
    found = False
    for values in product(GRID, repeat=len(names)):
        at = dict(zip(names, values, strict=True))
        if all(_holds(f, at) for f in given):
            found = True
            by = {sympy.Symbol(x, real=True): sympy.Rational(v.numerator, v.denominator) for x, v in at.items()}
            size = abs(float(by[t]))
            there = sympy.Poly(singular.as_expr().subs({s: v for s, v in by.items() if s != t}), t)
            if there.degree() > 0 and any(abs(complex(r)) <= size * (1 + CIRCLE) for r in there.nroots()):
                return False
    return found


def _holds(formula: Node, at: Mapping[str, Fraction]) -> bool:
    """Is it so at a point, or not to be told?"""
    by: dict[str, Term] = {
        x: node("/", v.numerator, v.denominator) if v >= 0 else node("-", node("/", -v.numerator, v.denominator))
        for x, v in at.items()
    }
    with suppress(*FAULTS):
        if formula.tag in ("and", "or"):
            several = [_holds(part, at) for part in formula.outside if isinstance(part, Node)]
            return all(several) if formula.tag == "and" else any(several)
        left, right = (float(to_sympy(substituted(side, by))) for side in formula.outside)
        return {"<": left < right, "<=": left <= right, ">": left > right, ">=": left >= right}.get(formula.tag, True)
    return True


def _is_single(value: Term, t: str) -> bool:
    """Are roots and logarithms of what has no square factors in a letter?"""
    import sympy

    for part in nodes(value):
        if part.tag not in ("sqrt", "pow", "log") or t not in letters(part):
            continue
        inner, *exponent = part.outside
        if exponent and ((power := number_of(exponent[0])) is None or t in letters(exponent[0])):
            return False
        if exponent and power is not None and power.denominator == 1:
            continue
        for each in sympy.fraction(sympy.together(to_sympy(inner))):
            poly = sympy.Poly(each, sympy.Symbol(t, real=True))
            if sympy.gcd(poly, poly.diff()).degree() > 0:
                return False
    return all(part.tag not in ("call", "integral", "sum", "product") for part in nodes(value))
