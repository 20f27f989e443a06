"""Points that satisfy hypotheses, by trial: letters drawn at random, those that an equation leaves alone solved for."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import isqrt, prod
from operator import ge, gt, le, lt
from typing import Any

from symcheck.export.coq.terms import letters, rebuilt

TRIES = 20_000
SMALL = [Fraction(n) for n in (0, 1, 2, 3, 4, 5, -1, -2)] + [
    Fraction(n, d) for n, d in ((1, 2), (1, 3), (2, 3), (1, 4), (3, 4), (3, 5), (4, 5), (2, 7), (3, 7), (6, 7))
]
NEAR = 1e-9  # roots are compared by digits: Coq has the last word
ROUGHLY = {"sin": math.sin, "cos": math.cos, "arctan": math.atan, "sqrt": math.sqrt}
ORDERS = {"<": lt, "<=": le, ">": gt, ">=": ge}
Number = Fraction | float
Values = dict[str, tuple[Number, Any]]  # a number, and the term it is in Coq


def tried(conditions: Sequence[Any]) -> dict[str, Any] | None:
    """Terms for the letters ("sin_a", "cos_a" for an angle a) such that the conditions hold; the same in every run."""
    free = letters(["and", *conditions])
    angles = {x for x in free if not any(_plain(x, condition) for condition in conditions)}
    flat = [_angled(condition, angles) for condition in conditions]
    equations = [["-", left, right] for _, left, right in _equations(flat)]
    for seed in range(TRIES):
        values = _drawn(random.Random(seed), free, angles, equations)
        if values is not None and all(_holds(condition, values) for condition in flat):
            return {x: term for x, (_, term) in values.items()}
    return None


def _plain(x: str, node: Any) -> bool:
    """Whether a letter stands anywhere but alone in a sine or cosine."""
    match node:
        case ["sin" | "cos", str()]:
            return False
        case list():
            return any(_plain(x, part) for part in node[1:])
    return bool(node == x)


def _angled(node: Any, angles: set[str]) -> Any:
    match node:
        case ["sin" | "cos" as function, str(x)] if x in angles:
            return f"{function}_{x}"
    return rebuilt(node, lambda child: _angled(child, angles))


def _equations(conditions: Sequence[Any]) -> Iterator[Any]:
    for condition in conditions:
        match condition:
            case ["and", *parts]:
                yield from _equations(parts)
            case ["=", left, right] if left != right:
                yield condition


def _drawn(rng: random.Random, free: Sequence[str], angles: set[str], equations: Sequence[Any]) -> Values | None:
    """Values for all letters, in random order; None if an equation has no root."""
    values: Values = {}
    for x in rng.sample(free, len(free)):
        if x in angles:
            values |= _angle(x, rng.choice(SMALL))
        elif x not in values:
            values[x] = _number(rng.choice(SMALL))
        while (found := next(_solved(equations, values, angles, rng.choice((1, -1))), None)) is not None:
            letter, root = found
            if root is None:
                return None
            values[letter] = root
    return values


def _solved(
    equations: Sequence[Any], values: Values, angles: set[str], sign: int
) -> Iterator[tuple[str, tuple[Number, Any] | None]]:
    """Each letter that alone has no value in an equation, with the root; None if there is no real one."""
    for equation in equations:
        left = [x for x in letters(equation) if x not in values and f"sin_{x}" not in values]
        if len(left) == 1 and left[0] not in angles:
            below, constant, above, twice = (
                _at(equation, {**values, left[0]: _number(Fraction(n))}) for n in (-1, 0, 1, 2)
            )
            for root in _roots(below, constant, above, twice, sign):
                yield left[0], root


def _roots(below: Any, constant: Any, above: Any, twice: Any, sign: int) -> Iterator[tuple[Number, Any] | None]:
    """The root of b x + c or of a x^2 + c by the values at -1, 0, 1, 2; nothing for what is of another form."""
    if not all(isinstance(value, Fraction) for value in (below, constant, above, twice)):
        return
    square, linear = (above + below) / 2 - constant, (above - below) / 2
    if 4 * square + 2 * linear + constant != twice:
        return
    if linear and not square:
        yield _number(-constant / linear)
    elif square and not linear:
        yield _square_root(-constant / square, sign) if constant * square <= 0 else None


def _angle(x: str, tangent: Fraction) -> Values:
    """Sine and cosine of an angle of that tangent."""
    sides = tangent.as_integer_ratio()
    n = sides[0] ** 2 + sides[1] ** 2
    root = isqrt(n)
    if root * root == n:
        both = [_number(Fraction(side, root)) for side in sides]
    else:
        both = [(side / math.sqrt(n), ["/", ["*", _whole(side), ["sqrt", n]], n]) for side in sides]
    return {f"sin_{x}": both[0], f"cos_{x}": both[1]}


def _square_root(square: Fraction, sign: int) -> tuple[Number, Any]:
    p, q = square.as_integer_ratio()
    root = isqrt(p * q)
    if root * root == p * q:
        return _number(Fraction(sign * root, q))
    term = ["/", ["sqrt", p * q], q]
    return sign * math.sqrt(square), term if sign > 0 else ["-", term]


def _number(value: Fraction) -> tuple[Number, Any]:
    p, q = value.as_integer_ratio()
    return value, ["/", _whole(p), q] if q > 1 else _whole(p)


def _whole(n: int) -> Any:
    return n if n >= 0 else ["-", -n]


def _holds(formula: Any, values: Values) -> bool:
    """Whether a formula holds; what is not a fraction is rough."""
    kind, *parts = formula
    if kind in ("and", "or"):
        return (all if kind == "and" else any)(_holds(part, values) for part in parts)
    if kind == "=" and parts[0] == parts[1]:  # what a letter is said to be
        return True
    difference = _at(["-", *parts], values) if kind in ("=", "!=", *ORDERS) else None
    if difference is None:
        return False
    if isinstance(difference, float) and abs(difference) < NEAR:
        difference = Fraction(0)
    return (difference == 0) is (kind == "=") if kind in ("=", "!=") else bool(ORDERS[kind](difference, 0))


def _at(term: Any, values: Values) -> Number | None:
    """The value of a term; None where it has none that is known here."""
    try:
        return _value(term, values)
    except (KeyError, ZeroDivisionError, ValueError, OverflowError):
        return None


def _value(term: Any, values: Values) -> Number:
    match term:
        case int():
            return Fraction(term)
        case "pi":
            return math.pi
        case str():
            return values[term][0]
        case ["-", inner]:
            return -_value(inner, values)
        case ["-", left, right]:
            return _value(left, values) - _value(right, values)
        case ["^", base, int(n)]:
            return _value(base, values) ** n
        case ["+", *parts]:
            return sum((_value(part, values) for part in parts), Fraction(0))
        case ["*", *parts]:
            return prod((_value(part, values) for part in parts), start=Fraction(1))
        case ["/", top, bottom]:
            return _value(top, values) / _value(bottom, values)
        case [function, inner] if function in ROUGHLY:
            return ROUGHLY[function](_value(inner, values))
    raise KeyError(str(term))
