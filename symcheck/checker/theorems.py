"""What is taken for granted of functions: a table of theorems, each stated as one writes mathematics.

A line is "name(parameters): premises |- conclusion", with ";" between premises. Parameters are terms, but `n` and `k`,
which are whole numbers, and `f`, `g`, `h`, which are terms in a letter: `f(t)` is such a term with t in its place. No
other parameter depends on a letter that is bound in a premise or in the conclusion, as substitution does not capture.
An integral that has no finite value counts as 0; a mean is over one turn.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from functools import cache
from types import MappingProxyType
from typing import NamedTuple

from symcheck.checker.enclosures import between
from symcheck.core.calculus import Lambda, domain, letters, nodes, polynomial_in, regular, substituted
from symcheck.core.terms import RELATIONS, Binder, Call, Formula, Malformed, Node, Quantified, Term, Value, node

QUADRANTS = "-(pi/2) <= a; a <= pi/2"  # from -90 to 90 degrees
S = "(k + u + 1)"  # an integrand of the shape below is like x**(S - 1) near 0 and like x**(S - 1 - 2*r) far away
SHAPE = "forall(x, implies(x > 0, f(x) == c * x**k * pow(x, u) * pow(p * x**2 + q, -r)))"
EULER = f"2 * gamma(r) * integral(f(x), x, 0, oo) == c * pow(p, -({S}/2)) * pow(q, -(r - {S}/2)) * gamma({S}/2)"
LINE, HALF = "x, -oo, oo", "x, 0, oo"

STATEMENTS = f"""
dichotomy(t): |- t > 0 or t <= 0
root(t): t >= 0 |- sqrt(t) >= 0 and sqrt(t)**2 == t
root_of_product(s, t): s >= 0; t >= 0 |- sqrt(s * t) == sqrt(s) * sqrt(t)
equal_squares(s, t): s >= 0; t >= 0; s**2 == t**2 |- s == t
power(b, u): b > 0 |- pow(b, u) > 0
power_of_sum(b, s, t): b > 0 |- pow(b, s + t) == pow(b, s) * pow(b, t)
power_of_product(s, t, u): s > 0; t > 0 |- pow(s * t, u) == pow(s, u) * pow(t, u)
power_of_power(b, n, u): b > 0 |- pow(b**n, u) == pow(b, n * u) and pow(1, u) == 1
power_inverse(b, u, t): b > 0; u != 0; pow(b, u) == t |- b == pow(t, 1/u)
gamma(t): t > 0 |- gamma(t) > 0 and gamma(t + 1) == t * gamma(t)
gamma_reflected(t): 0 < t; t < 1 |- gamma(t) * gamma(1 - t) * sin(pi * t) == pi
gamma_doubled(t): t > 0 |- gamma(t) * gamma(t + 1/2) * pow(2, 2*t) == 2 * sqrt(pi) * gamma(2*t)
gamma_values(): |- gamma(1) == 1 and gamma(1/2)**2 == pi and gamma(1/2) > 0
circle_number(): |- pi > 0
right_half(a): {QUADRANTS} |- cos(a) >= 0
positive_cosine(a): -(pi/2) < a; a < pi/2 |- cos(a) > 0
positive_sine(a): 0 < a; a < pi |- sin(a) > 0
principal_value_arctan(t): |- -(pi/2) < arctan(t) and arctan(t) < pi/2
principal_value_arcsin(t): t**2 <= 1 |- -(pi/2) <= arcsin(t) and arcsin(t) <= pi/2
principal_value_arccos(t): t**2 <= 1 |- 0 <= arccos(t) and arccos(t) <= pi
first_quadrant_arctan(t): t >= 0 |- 0 <= arctan(t) and arctan(t) <= pi/2
first_quadrant_arcsin(t): t**2 <= 1; t >= 0 |- 0 <= arcsin(t) and arcsin(t) <= pi/2
first_quadrant_arccos(t): t**2 <= 1; t >= 0 |- 0 <= arccos(t) and arccos(t) <= pi/2
mean(f, c, g): forall(x, f(x) == c + diff(g(x), x)) |- mean(f(x), x) == c
quarter_turn(f): forall(x, f(x + pi/2) == -f(x)) |- exists(x, f(x) == 0)
intermediate_value(f, s, t): s < t; f(s) * f(t) < 0 |- exists(x, s < x and x < t and f(x) == 0)
constant(c, s, t): |- integral(c, x, s, t) == c * (t - s)
power_rule(f, s, t, c, g, u): s <= t; forall(x, implies(s <= x and x <= t, g(x) > 0 and f(x) == diff(c * pow(g(x), u), x))) |- integral(f(x), x, s, t) == c * pow(g(t), u) - c * pow(g(s), u)
antiderivative(f, g, s, t): s <= t; forall(x, implies(s < x and x < t, f(x) == diff(g(x), x))) |- integral(f(x), x, s, t) == g(t) - g(s)
antiderivative_everywhere(f, g, s, t): forall(x, f(x) == diff(g(x), x)) |- integral(f(x), x, s, t) == g(t) - g(s)
rising(g, s, t): t - s >= 0; forall(x, implies(s < x and x < t, diff(g(x), x) >= 0)) |- g(s) <= g(t)
rising_strictly(g, s, t): t - s > 0; forall(x, implies(s < x and x < t, diff(g(x), x) > 0)) |- g(s) < g(t)
antiderivative_converges(f, g, s, t): s <= t; forall(x, implies(s < x and x < t, f(x) == diff(g(x), x))) |- diverges(f(x), x, s, t) == 0
full_turn(f, a, b, c, u, r, s): a > 0; a**2 > b**2 + c**2; r >= 0; r**2 == a**2 - (b**2 + c**2); forall(x, implies(a + b * cos(x) + c * sin(x) > 0, f(x) == u/(a + b * cos(x) + c * sin(x)))) |- integral(f(x), x, s, s + 2*pi) == 2*pi*u/r
exp_of_log(t): t > 0 |- exp(log(t)) == t
log_of_one(): |- log(1) == 0
log_of_exp(t): |- log(exp(t)) == t
log_of_product(s, t): s > 0; t > 0 |- log(s * t) == log(s) + log(t)
log_of_power(t, u): t > 0 |- log(pow(t, u)) == u * log(t)
log_of_root(t): t > 0 |- 2 * log(sqrt(t)) == log(t)
circular_of_arctan(t): |- sin(arctan(t)) * sqrt(1 + t**2) == t and cos(arctan(t)) * sqrt(1 + t**2) == 1
circular_of_arcsin(t): t**2 <= 1 |- sin(arcsin(t)) == t and cos(arcsin(t)) == sqrt(1 - t**2)
circular_of_arccos(t): t**2 <= 1 |- cos(arccos(t)) == t and sin(arccos(t)) == sqrt(1 - t**2)
telescope(f, g, s, t): s - 1 <= t; g(s - 1) == 0; forall(x, implies(x >= s - 1, g(x + 1) == g(x) + f(x + 1))) |- sum(f(x), x, s, t) == g(t)
telescoping_product(f, g, s, t): s - 1 <= t; g(s - 1) == 1; forall(x, implies(x >= s - 1, g(x + 1) == g(x) * f(x + 1))) |- product(f(x), x, s, t) == g(t)
power_as_exp(b, u): b > 0 |- pow(b, u) == exp(u * log(b))
power_diverges(f, c, u): c != 0; forall(x, implies(x > 0, f(x) == c * pow(x, u))) |- diverges(f(x), {HALF}) == 1
beta(f, c, k, u, r, p, q): p > 0; q > 0; {S} > 0; 2*r - {S} > 0; {SHAPE} |- diverges(f(x), {HALF}) == 0 and {EULER} * gamma(r - {S}/2) and gamma(r) > 0 and gamma({S}/2) > 0 and gamma(r - {S}/2) > 0 and pow(p, -({S}/2)) > 0 and pow(q, -(r - {S}/2)) > 0
beta_diverges(f, c, k, u, r, p, q): p > 0; q > 0; c != 0; {S} <= 0 or 2*r - {S} <= 0; {SHAPE} |- diverges(f(x), {HALF}) == 1
decaying(f, g, a, s): a > 0; forall(x, implies(x > s, f(x) == diff(exp(-(a * x)) * g(x), x))) |- integral(f(x), x, s, oo) == -(exp(-(a * s)) * g(s)) and diverges(f(x), x, s, oo) == 0
gaussian(f, g, a, b, c): a > 0; forall(x, f(x) == diff(exp(b * x - a * x**2) * g(x), x) + c * exp(b * x - a * x**2)) |- integral(f(x), {LINE}) == c * exp(b**2/(4 * a)) * sqrt(pi/a) and diverges(f(x), {LINE}) == 0
gaussian_wave(f, g, a, b, c, u, v): a > 0; forall(x, f(x) == diff(exp(b * x - a * x**2) * g(x), x) + c * exp(b * x - a * x**2) * cos(u * x + v)) |- integral(f(x), {LINE}) == c * exp((b**2 - u**2)/(4 * a)) * cos(b * u/(2 * a) + v) * sqrt(pi/a) and diverges(f(x), {LINE}) == 0
half_gaussian(f, g, a, c): a > 0; forall(x, implies(x > 0, f(x) == diff(exp(-(a * x**2)) * g(x), x) + c * exp(-(a * x**2)))) |- integral(f(x), {HALF}) == c/2 * sqrt(pi/a) - g(0) and diverges(f(x), {HALF}) == 0
gamma_integral(f, c, u, a): a > 0; u > -1; forall(x, implies(x > 0, f(x) == c * pow(x, u) * exp(-(a * x)))) |- integral(f(x), {HALF}) == c * gamma(u + 1) * pow(a, -(u + 1)) and diverges(f(x), {HALF}) == 0
unit_beta(f, c, u, v): u > -1; v > -1; forall(x, implies(x > 0 and x < 1, f(x) == c * pow(x, u) * pow(1 - x, v))) |- integral(f(x), x, 0, 1) * gamma(u + v + 2) == c * gamma(u + 1) * gamma(v + 1) and diverges(f(x), x, 0, 1) == 0
inverted(f, g, s): forall(x, implies(x > 0 and x < 1, g(x) == f(s - 1 + 1/x)/x**2)) |- integral(f(x), x, s, oo) == integral(g(x), x, 0, 1) and diverges(f(x), x, s, oo) == diverges(g(x), x, 0, 1)
moved(f, g, a, b, s, t): a != 0; forall(x, f(x) == g(a * x + b)) |- a * integral(f(x), x, s, t) == integral(g(x), x, a * s + b, a * t + b) and integral(g(x), x, a * s + b, a * t + b) == -integral(g(x), x, a * t + b, a * s + b)
log_head(f, c, u, s): s > 0; u > -1; forall(x, implies(x > 0 and x < s, f(x) == c * pow(x, u) * log(x))) |- integral(f(x), x, 0, s) == c * pow(s, u + 1) * (log(s)/(u + 1) - 1/(u + 1)**2) and diverges(f(x), x, 0, s) == 0
power_tail(f, c, u, s): s > 0; u < -1; forall(x, implies(x > 0 and x > s, f(x) == c * pow(x, u))) |- integral(f(x), x, s, oo) == -(c * pow(s, u + 1)/(u + 1)) and diverges(f(x), x, s, oo) == 0
tail_converges(f, c, u, a, s): a > 0; s > 0; forall(x, implies(x > 0 and x > s, f(x) == c * pow(x, u) * exp(-(a * x)))) |- diverges(f(x), x, s, oo) == 0
power_head(f, c, u, s): s > 0; u > -1; forall(x, implies(x > 0 and x < s, f(x) == c * pow(x, u))) |- integral(f(x), x, 0, s) == c * pow(s, u + 1)/(u + 1) and diverges(f(x), x, 0, s) == 0
head_converges(f, g, u, s): s > 0; u > -1; forall(x, implies(x > 0 and x < s, f(x) == pow(x, u) * g(x))) |- diverges(f(x), x, 0, s) == 0
sum_of_integrals(f, g, h, s): diverges(g(x), x, s, oo) == 0; diverges(h(x), x, s, oo) == 0; forall(x, implies(x > s, f(x) == g(x) + h(x))) |- integral(f(x), x, s, oo) == integral(g(x), x, s, oo) + integral(h(x), x, s, oo) and diverges(f(x), x, s, oo) == 0
reflected(f, g, s): forall(x, implies(x < s, f(x) == g(-x))) |- integral(f(x), x, -oo, s) == integral(g(x), x, -s, oo) and diverges(f(x), x, -oo, s) == diverges(g(x), x, -s, oo)
shifted(f, g, a): forall(x, f(x) == g(x + a)) |- integral(f(x), {LINE}) == integral(g(x), {LINE}) and diverges(f(x), {LINE}) == diverges(g(x), {LINE})
halves(f, s): diverges(f(x), x, -oo, s) == 0; diverges(f(x), x, s, oo) == 0 |- integral(f(x), {LINE}) == integral(f(x), x, -oo, s) + integral(f(x), x, s, oo) and diverges(f(x), {LINE}) == 0
sum_of_sums(f, g, h, a, b, s, t): forall(x, implies(x >= s, f(x) == a * g(x) + b * h(x))) |- sum(f(x), x, s, t) == a * sum(g(x), x, s, t) + b * sum(h(x), x, s, t)
scaled(f, g, a, c, s): c > 0; forall(x, implies(x > s, f(x) == a * g(c * x))) |- c * integral(f(x), x, s, oo) == a * integral(g(x), x, c * s, oo)
pieces(f, r, s, t): |- integral(f(x), x, s, t) == integral(f(x), x, s, r) + integral(f(x), x, r, t)
even(f): forall(x, f(-x) == f(x)) |- integral(f(x), {LINE}) == 2 * integral(f(x), {HALF}) and diverges(f(x), {LINE}) == diverges(f(x), {HALF})
odd(f): forall(x, f(-x) == -f(x)); diverges(f(x), {HALF}) == 0 |- integral(f(x), {LINE}) == 0 and diverges(f(x), {LINE}) == 0
"""  # noqa: E501
ANGLES = ("0", "pi/6", "pi/4", "pi/3", "pi/2")
SINES = ("0", "1/2", "sqrt(2)/2", "sqrt(3)/2", "1")  # of these angles; of the last there is no tangent
KNOWN = {"arctan": ("0", "1/sqrt(3)", "1", "sqrt(3)"), "arcsin": SINES, "arccos": SINES[::-1]}
SMOOTH = {  # what else must be so: a polynomial in the sine and cosine of its letter, or in the letter itself
    "mean": ("g", "sin", "cos"), "quarter_turn": ("f", "sin", "cos"), "intermediate_value": ("f",),
    "power_rule": ("g",), "decaying": ("g",), "gaussian": ("g",), "gaussian_wave": ("g",), "half_gaussian": ("g",),
}  # fmt: skip
SMOOTHLY = ("antiderivative", "rising")  # theorems with more premises than are stated: that g is smooth all the way
CONTINUOUS = {"pieces": "f", "head_converges": "g"}  # what must have an integral between any two numbers
WAVES = ("decaying", "gaussian", "gaussian_wave", "half_gaussian")  # here also in sines and cosines, which do not grow
SHOWN = (  # by premises, or beside them, integrands and addends are defined between the ends: no divisor is zero there
    "antiderivative", "antiderivative_everywhere", "beta", "decaying", "gaussian", "gaussian_wave", "half_gaussian",
    "gamma_integral", "power_tail", "tail_converges", "power_head", "head_converges", "sum_of_integrals", "reflected",
    "even", "odd", "shifted", "scaled", "telescope", "telescoping_product", "sum_of_sums", "constant", "full_turn",
    "unit_beta", "inverted", "moved", "log_head", "antiderivative_converges",
)  # fmt: skip


class Theorem(NamedTuple):
    """Premises, conclusion and the parameters, by name."""

    parameters: tuple[str, ...]
    premises: tuple[Formula, ...]
    conclusion: Formula


def _table() -> dict[str, str]:
    """The statements by name, with those of angles: in these ranges a function keeps or reverses every order."""
    lines = STATEMENTS.strip().splitlines()
    for name, numbers in KNOWN.items():
        lines += [f"known_angle_{name}_{k}(): |- {name}({t}) == {ANGLES[k]}" for k, t in enumerate(numbers)]
    for sign in RELATIONS:
        written = "==" if sign == "=" else sign
        for name, where, angles, values in (
            ("arctangent", QUADRANTS, f"a {written} arctan(t)", f"sin(a) {written} t * cos(a)"),
            ("arcsine", f"t**2 <= 1; {QUADRANTS}", f"a {written} arcsin(t)", f"sin(a) {written} t"),
            ("arccosine", "t**2 <= 1; 0 <= a; a <= pi", f"a {written} arccos(t)", f"t {written} cos(a)"),
        ):
            lines.append(f"{name} {sign}(a, t): {where}; {angles} |- {values}")
            lines.append(f"{name} {sign} back(a, t): {where}; {values} |- {angles}")
    return {line.partition("(")[0]: line for line in lines}


TABLE = _table()
NAMES = tuple(TABLE)


@cache
def theorem(name: str) -> Theorem:
    """The theorem of that name; Malformed if there is none."""
    if name not in TABLE:
        raise Malformed(f"there is no theorem {name}")
    head, _, rest = TABLE[name].partition("): ")
    parameters = tuple(head.partition("(")[2].replace(",", "").split())
    before, _, after = rest.partition("|- ")
    premises = tuple(_read(text) for text in before.split(";") if text.strip())
    return Theorem(parameters, premises, _read(after))


COMPUTED = {  # those that are functions of what they are applied to
    "congruence": "s_1 == t_1; ... |- f(s_1, ...) == f(t_1, ...)",
    "enclosure": "x == number; ... |- low <= t and t <= high, decimals with so many digits",
}


def stated(name: str) -> str:
    """What a theorem says: its line in the table, without its name."""
    return COMPUTED.get(name) or TABLE[name].partition("): ")[2]


SIGNS: dict[type, str] = {
    ast.Add: "+", ast.Mult: "*", ast.Div: "/", ast.Pow: "^", ast.And: "and", ast.Or: "or", ast.Eq: "=",
    ast.NotEq: "!=", ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=",
}  # fmt: skip


def _read(text: str) -> Node:
    """A formula of a statement above."""
    found = _part(ast.parse(text.strip(), mode="eval").body)
    assert isinstance(found, Node)
    return found


def _part(tree: ast.expr) -> Term:
    match tree:
        case ast.Constant(value=int(number)):
            return number
        case ast.Name(id="pi"):
            return node("pi")
        case ast.Name(id="oo"):
            return node("infinity")
        case ast.Name(id=name):
            return name
        case ast.UnaryOp(operand=ast.Name(id="oo")):
            return node("-infinity")
        case ast.UnaryOp(operand=inner):
            return node("-", _part(inner))
        case ast.BinOp(op=ast.Sub(), left=left, right=right):
            return node("+", _part(left), node("-", _part(right)))
        case ast.BinOp(op=op, left=left, right=right) | ast.Compare(ops=[op], left=left, comparators=[right]):
            return node(SIGNS[type(op)], _part(left), _part(right))
        case ast.BoolOp(op=op, values=parts):
            return node(SIGNS[type(op)], *map(_part, parts))
        case ast.Call(func=ast.Name(id=name), args=arguments):
            first, *rest = map(_part, arguments)
            if name in ("forall", "exists"):
                return node(name, (str(first),), *rest)
            if name == "diff":
                return node(name, first, rest[0], 1, rest[0])
            if name in ("f", "g", "h"):
                return node("call", name, (0,), first)
            return node("=>" if name == "implies" else name, first, *rest)
    raise AssertionError(ast.dump(tree))


Argument = Term | Lambda


def instance(
    name: str, given: Mapping[str, Argument], numbers: Mapping[str, Term] = MappingProxyType({})
) -> tuple[list[Formula], Formula]:
    """Premises and conclusion of a theorem with its parameters replaced; Malformed where an argument does not fit."""
    if name == "congruence":
        return congruence(given)
    if name == "enclosure":
        return enclosure(given, numbers)
    terms, lambdas = _told_apart(name, given)
    stated = theorem(name)
    premises = [substituted(premise, terms, lambdas) for premise in stated.premises]
    if name.startswith(SMOOTHLY):
        premises[-1:] = smoothly(premises[-1], lambdas["g"])
    return premises, substituted(stated.conclusion, terms, lambdas)


def shown(name: str, given: Mapping[str, Argument]) -> list[Binder]:
    """The integrals whose integrands are defined between the ends, as the premises show."""
    if name not in SHOWN:
        return []
    terms, lambdas = _told_apart(name, given)
    integrals = (part for part in nodes(theorem(name).conclusion) if isinstance(part, Binder))
    return [substituted(part, terms, lambdas) for part in integrals]


def _told_apart(name: str, given: Mapping[str, Argument]) -> tuple[dict[str, Term], dict[str, Lambda]]:
    """The terms and the functions that a theorem is applied to; Malformed where one does not fit."""
    parameters = theorem(name).parameters
    if given.keys() != {*parameters}:
        raise Malformed(f"{name} is a theorem about {', '.join(parameters) or 'no parameters'}")
    terms: dict[str, Term] = {}
    lambdas: dict[str, Lambda] = {}
    for parameter, argument in given.items():
        if isinstance(argument, tuple) and not isinstance(argument, Node):
            lambdas[parameter] = argument
        else:
            terms[parameter] = argument
        whole = parameter not in ("n", "k") or isinstance(argument, int)
        if (parameter in lambdas) != (parameter in ("f", "g", "h")) or not whole:
            raise Malformed(f"{argument!r} for the parameter {parameter} of {name}")
    if name in ("telescope", "telescoping_product") and not _grows(lambdas["g"]):
        raise Malformed(f"{lambdas['g'][1]!r} may have a period, and what is so of all numbers is not told then")
    if name in CONTINUOUS and not _is_continuous(lambdas[CONTINUOUS[name]][1], lambdas[CONTINUOUS[name]][0][0]):
        raise Malformed(f"{lambdas[CONTINUOUS[name]][1]!r} may have no integral")
    if name in SMOOTH:
        parameter, *of = SMOOTH[name]
        (x,), body = lambdas[parameter]
        atoms: list[Term] = [node(each, x) for each in of] or [x]
        if name in WAVES:
            waves = (part for part in nodes(body) if part.tag in ("sin", "cos"))
            atoms += [wave for wave in waves if polynomial_in(wave.outside[0], x)]
        if not polynomial_in(body, *atoms):
            raise Malformed(f"{body!r} is no polynomial in {' and '.join(of)} {x}")
    return terms, lambdas


def _grows(g: Lambda) -> bool:
    """Whether two such terms never differ by a period: what exp, log and gamma say is o-minimal, by Speissegger."""
    (x,), body = g
    inner = [part for part in nodes(body) if x in letters(part)]
    known = all(part.tag in ("+", "*", "-", "/", "^", "pow", "exp", "log", "gamma", "sqrt") for part in inner)
    return known and not any(part.tag == "pow" and x in letters(part.outside[0]) for part in inner)


def _is_continuous(term: Term, x: str) -> bool:
    """Whether a term is continuous for all values of its letter: of what is smooth everywhere and absolute values."""
    match term:
        case Value(tag="sqrt", terms=(Value(tag="^", terms=(inner, 2)),)):
            return _is_continuous(inner, x)
        case Value(tag="/", terms=(top, bottom)):
            return x not in letters(bottom) and _is_continuous(top, x)
        case Value(tag="^", terms=(base, int(n))) if n >= 0:
            return _is_continuous(base, x)
        case Value(tag="+" | "*" | "-" | "sin" | "cos" | "exp", terms=parts):
            return all(_is_continuous(part, x) for part in parts)
    return term == x or x not in letters(term)


def smoothly(derived: Formula, g: Lambda) -> Iterator[Formula]:
    """That g is smooth and what is said of its derivative, all the way, and between two ends is continuous at them."""
    assert isinstance(derived, Quantified)
    (x,), body = derived.bound, derived.body
    inside, equal = (body.formulas[0].formulas, body.formulas[1]) if body.tag == "=>" else ((), body)
    primitive = substituted(g[1], {g[0][0]: x})
    ends_too = tuple(node(each.tag + "=", *each.outside) for each in inside)
    continuous = domain(primitive, divisors=True) if inside else []
    smooth = [each for each in regular(primitive) if each not in continuous]
    for way, each in ((ends_too, continuous), (inside, [*smooth, equal])):
        for formula in each:
            assumed = (*way, *([*continuous, *smooth] if formula is equal else ()))
            yield node("forall", (x,), node("=>", node("and", *assumed), formula) if assumed else formula)


def congruence(given: Mapping[str, Argument]) -> tuple[list[Formula], Formula]:
    """Equal arguments give equal values of a function."""
    s, t = given.get("s", 0), given.get("t", 0)
    if not (isinstance(s, (Value, Call)) and isinstance(t, (Value, Call))) or s.tag in ("+", "*", "-", "/", "^"):
        raise Malformed(f"{s} and {t} are not both functions of values")
    start = len(s) - len(s.terms)
    if len(s) != len(t) or s[:start] != t[:start]:
        raise Malformed(f"{s} and {t} are not the same function")
    if len(given) != 2:
        raise Malformed("congruence is about s and t alone")
    return [node("=", *pair) for pair in zip(s.terms, t.terms, strict=True)], node("=", s, t)


def enclosure(given: Mapping[str, Argument], numbers: Mapping[str, Term]) -> tuple[list[Formula], Formula]:
    """x = t; ... |- low <= term <= high, by interval arithmetic, with so many digits; letters stand for numbers."""
    t, digits, *others = given["t"], given["digits"], *(given.keys() - {"t", "digits"})
    if others:
        raise Malformed(f"{others} is nothing that has digits")
    if not isinstance(t, (int, str, Node)) or not isinstance(digits, int):
        raise Malformed("no term with digits")
    term = t
    for _ in numbers:  # what a letter stands for may contain others
        term = substituted(term, numbers)
    low, high = between(term, digits)
    return [node("=", *each) for each in numbers.items()], node("and", node("<=", low, t), node("<=", t, high))
