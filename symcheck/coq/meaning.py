"""What terms and formulas mean as numbers. It shares nothing with the checker, not even the nodes of its terms.

A term or formula is a number, a letter, or a sequence of a tag and fields, as in JSON. An `Evaluator` walks through it;
`Meaning` has 50 digits, unknown functions, binders and quantifiers.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from random import Random
from typing import Any

from mpmath import mp, mpf

mp.dps = 50  # so far beyond the sixteen of a double that rounding decides no comparison
Tree = Any  # a term or formula, raw or as nodes
Number = Any  # of mpmath, flint or fractions
Values = dict[str, Number]
CLOSE = mpf(10) ** -22  # two sides that are nearer to each other, in proportion, are equal
MORE = 450  # digits with which a second look is taken at what seems false
NIL = mpf(10) ** -40  # what is smaller is zero
FAR = 300  # exp(FAR): where an integrand over a half-line is looked at
MOST = 1000  # exponents above take too long
ENOUGH = mpf(10) ** -24  # of an integral, as a part of it or of that of its absolute value
BINDERS = frozenset(("mean", "integral", "diverges", "sum", "product", "diff"))
ENDS = {"infinity": mp.inf, "-infinity": -mp.inf}
RELATIONS = {"=": {0}, "!=": {-1, 1}, "<": {-1}, "<=": {-1, 0}, ">": {1}, ">=": {0, 1}}  # by the sign of left - right


class NoValue(ValueError):
    """A term that has no value here, or none that can be found."""


class Evaluator:
    """Values of terms and truth of formulas; a class for each library says what numbers and functions are.

    Letters have values, or stand for terms: those are evaluated when first met, and anew under a binder.
    """

    name = ""
    operations: Mapping[str, Callable[..., Number]] = {}

    def __init__(self, definitions: Mapping[str, Tree] | None = None) -> None:
        self.definitions = definitions or {}

    def number(self, n: int) -> Number:
        raise NotImplementedError

    def sign(self, relation: Tree, at: Values) -> int:
        """The sign of left - right; NoValue if it cannot be determined."""
        raise NotImplementedError

    def term(self, node: Tree, at: Values) -> Number:
        """The value of a term; NoValue, or an error of arithmetic, if it has none."""
        if isinstance(node, int):
            return self.number(node)
        if isinstance(node, str):
            return self.letter(node, at)
        tag = node[0]
        if tag == "^":
            return self.power(self.term(node[1], at), node[2])
        if tag not in self.operations:
            return self.other(node, at)
        return self.operations[tag](*(self.term(part, at) for part in node[1:]))

    def letter(self, x: str, at: Values) -> Number:
        if x not in at:
            if x not in self.definitions:
                return self.unknown(x)
            at[x] = self.term(self.definitions[x], at)
        return at[x]

    def unknown(self, x: str) -> Number:
        """The value of a letter of which nothing is said."""
        raise NoValue(x)

    def power(self, base: Number, exponent: int) -> Number:
        return base**exponent

    def other(self, node: Tree, at: Values) -> Number:
        """The value of a binder or an unknown function."""
        raise NoValue(node[0])

    def quantified(self, node: Tree, at: Values) -> bool | None:
        """Whether something is so of some or of all."""
        raise NoValue(node[0])

    def inside(self, at: Values, bound: Values) -> Values:
        """Values under a binder; definitions may contain its letter."""
        return {x: value for x, value in at.items() if x not in self.definitions} | bound

    def formula(self, node: Tree, at: Values) -> bool | None:
        """Whether a formula holds; None where a term has no value, or nobody can say."""
        try:
            return self.truth(node, at)
        except (NoValue, ZeroDivisionError, ValueError, OverflowError, mp.NoConvergence):
            return None

    def truth(self, node: Tree, at: Values) -> bool | None:
        tag = node[0]
        if tag in RELATIONS:
            return self.sign(node, at) in RELATIONS[tag]
        if tag in ("exists", "forall"):
            return self.quantified(node, at)
        parts = [self.truth(part, at) for part in node[1:]]
        if None in parts:
            return None
        match tag:
            case "and":
                return all(parts)
            case "or":
                return any(parts)
            case "=>":
                return parts[1] or not parts[0]
            case "<=>":
                return parts[0] == parts[1]
        raise AssertionError(tag)


def same(left: Number, right: Number) -> bool:
    """Whether two numbers are equal up to what rounding leaves."""
    return bool(abs(left - right) <= CLOSE * max(1, abs(left), abs(right)))


def near(place: Number) -> Number:
    """A place of which enough digits stand behind the point for a sine, or for the points of a difference."""
    if abs(place) > mpf(10) ** (mp.dps / 2):
        raise NoValue("a number too far away")
    return place


def nonzero(value: Number) -> Number:
    """The number; NoValue if it is zero."""
    if abs(value) < NIL:
        raise NoValue("a division by zero")
    return value


def power(base: Number, exponent: int) -> Number:
    """A whole power."""
    if abs(exponent) > MOST:
        raise NoValue("an exponent")
    return base**exponent if exponent >= 0 else 1 / nonzero(base) ** -exponent


def real_power(base: Number, exponent: Number) -> Number:
    """Of a base that is positive; whole powers are said of all bases."""
    whole = mp.nint(exponent)
    if base > 0:
        return base**exponent
    if abs(exponent - whole) > NIL:
        raise NoValue("a power")
    return power(base, int(whole))


def defined(function: Callable[[Number], Number], where: Callable[[Number], bool]) -> Callable[[Number], Number]:
    """A function that has values only where that is so."""

    def value(t: Number) -> Number:
        if not where(t):
            raise NoValue(function)
        return function(t)

    return value


def unit(t: Number) -> bool:
    """Whether a number is the sine of an angle."""
    return bool(abs(t) <= 1)


OPERATIONS: dict[str, Callable[..., Number]] = {
    "+": lambda *parts: mp.fsum(parts), "*": lambda *parts: mp.fprod(parts), "-": lambda t: -t,
    "/": lambda top, bottom: top / nonzero(bottom), "pi": lambda: +mp.pi,
    "sin": lambda t: mp.sin(near(t)), "cos": lambda t: mp.cos(near(t)),
    "tan": lambda t: mp.sin(near(t)) / nonzero(mp.cos(t)), "arctan": mp.atan, "exp": mp.exp,
    "sqrt": defined(lambda t: mp.sqrt(max(t, 0)), lambda t: t >= -NIL), "log": defined(mp.log, lambda t: t > 0),
    "arcsin": defined(mp.asin, unit), "arccos": defined(mp.acos, unit),
    "gamma": defined(mp.gamma, lambda t: t > 0 or not mp.isint(t)), "pow": real_power,
}  # fmt: skip


class Smooth:
    """Random smooth functions, with all derivatives; at some places they have prescribed values."""

    def __init__(self, rng: Random) -> None:
        self.rng = rng
        self.waves: dict[tuple[str, int, int], tuple[Number, Number, list[Number]]] = {}
        self.own: dict[tuple[str, tuple[int, ...], tuple[str, ...]], Number] = {}

    def state(self, name: str, orders: Sequence[int], places: list[Number], value: Number) -> None:
        self.own[name, tuple(orders), tuple(mp.nstr(+p, 25) for p in places)] = value

    def __call__(self, name: str, orders: Sequence[int], places: list[Number]) -> Number:
        if self.own:
            known = self.own.get((name, tuple(orders), tuple(mp.nstr(+p, 25) for p in places)))
            if known is not None:
                return known
        total, number = mpf(0), len(places)
        for k in range(2):
            key = name, number, k
            if key not in self.waves:
                draw = self.rng.randint
                self.waves[key] = mpf(draw(1, 9)) / 4, mpf(draw(0, 9)) / 3, [mpf(draw(-9, 9)) / 7 for _ in places]
            size, phase, slopes = self.waves[key]
            for slope, order, place in zip(slopes, orders, places, strict=True):
                phase, size = phase + slope * place + order * mp.pi / 2, size * slope**order
            total += size * mp.sin(near(phase))
        return total


class Meaning(Evaluator):
    """Values of 50 digits, with the unknown functions given."""

    name = "mpmath"
    operations = OPERATIONS
    binders = BINDERS  # those that have a value

    def __init__(self, functions: Smooth | None = None, definitions: Mapping[str, Tree] | None = None) -> None:
        super().__init__(definitions)
        self.functions = functions

    def number(self, n: int) -> Number:
        return mpf(n)

    def power(self, base: Number, exponent: int) -> Number:
        return power(base, exponent)

    def other(self, node: Tree, at: Values) -> Number:
        if node[0] in self.binders:
            return self.binder(node, at)
        if node[0] != "call" or self.functions is None:
            raise NoValue(node[0])
        return self.functions(node[1], node[2], [self.term(part, at) for part in node[3:]])

    def binder(self, node: Tree, at: Values) -> Number:
        tag, body, x, *ends = node

        def inside(place: Number) -> Number:
            return self.term(body, self.inside(at, {x: place}))

        if tag == "diff":
            place = near(self.term(ends[1], at))
            inside(place)
            return mp.diff(inside, place, ends[0])
        if tag in ("sum", "product"):
            low, high = (self.term(end, at) for end in ends)
            if not (mp.isint(low) and mp.isint(high) and high - low < 30):
                raise NoValue(tag)
            values = [inside(mpf(k)) for k in range(int(low), int(high) + 1)]
            return mp.fsum(values) if tag == "sum" else mp.fprod(values)
        if tag == "mean":
            rough, fine = (mp.fsum(inside(2 * mp.pi * k / n) for k in range(n)) / n for n in (18, 25))
            if same(rough, fine):
                return fine
            return quadrature(inside, [mp.pi * k / 2 for k in range(5)]) / (2 * mp.pi)
        finite = converges(inside, *ends)
        if tag == "diverges":
            return mpf(not finite)
        if not finite:
            return mpf(0)
        low, high = (ENDS[end[0]] if is_endless(end) else self.term(end, at) for end in ends)
        if low == high:
            return mpf(0)
        return quadrature(inside, [low, 0, high] if mp.isinf(low) and mp.isinf(high) else [low, high])

    def formula(self, node: Tree, at: Values) -> bool | None:
        """What is false at 50 digits is looked at with 400 more."""
        found = super().formula(node, at)
        if found is False and mp.dps < MORE:
            with mp.workdps(MORE):
                return super().formula(node, self.inside(at, {}))
        return found

    def sign(self, relation: Tree, at: Values) -> int:
        left, right = (self.term(side, at) for side in relation[1:])
        if mp.im(left) or mp.im(right) or mp.isnan(left) or mp.isnan(right):
            raise NoValue("a number that is not real")
        if left == right or (same(left, right) and not self.apart(relation, at, left - right)):
            return 0
        return 1 if left > right else -1

    def apart(self, relation: Tree, at: Values, gap: Number) -> bool:
        """Whether two sides near to each other differ: with more digits, noise gets smaller and a number stays."""
        if mp.dps < MORE:
            return False
        with mp.workdps(2 * MORE):
            at = self.inside(at, {})
            left, right = (self.term(side, at) for side in relation[1:])
            return bool(abs(left - right - gap) < abs(gap) / 1000)

    def quantified(self, node: Tree, at: Values) -> bool | None:
        if node[0] == "exists":
            return self.existence(node, at)
        places = [*PLACES[::3], *self.between(node[2], node[1], {x: t for x, t in at.items() if x not in node[1]})]
        found = [self.formula(node[2], self.inside(at, dict.fromkeys(node[1], place))) for place in places]
        return False if False in found else None if None in found else True

    def between(self, body: Tree, bound: Tree, at: Values) -> list[Number]:
        """Where the premise of an implication may hold: between the numbers with which it compares a bound letter."""
        ends = []
        premise = body[1] if body[0] == "=>" else ["and"]
        for part in premise[1:] if premise[0] == "and" else [premise]:
            for side in part[1:] if any(side in bound for side in part[1:] if isinstance(side, str)) else ():
                try:
                    ends.append(self.term(side, at))
                except NoValue:
                    continue
        places = [ends[0] + (ends[1] - ends[0]) * mpf(k) / 5 for k in range(-3, 9)] if len(ends) > 1 else []
        places += [end + mpf(k) / 4 for end in ends[:1] for k in (-9, -2, 1, 3, 14)]
        return [place for place in places if self.formula(premise, self.inside(at, dict.fromkeys(bound, place)))]

    def existence(self, node: Tree, at: Values) -> bool | None:
        """By trial; for one letter also by change of sign. An equation of at most second degree is decided."""
        _, (x, *more), body = node
        places = [*PLACES, *(-t for t in PLACES), mpf(0), *at.values()]
        if any(self.formula(body, self.inside(at, dict.fromkeys(node[1], t))) for t in places):
            return True
        equations = [each for each in (body[1:] if body[0] == "and" else [body]) if each[0] == "="]
        if more or not equations:
            return None

        def gap(t: Number) -> Number:
            return self.term(equations[0][1], self.inside(at, {x: t})) - self.term(
                equations[0][2], self.inside(at, {x: t})
            )

        values = [gap(mpf(t)) for t in (-1, 0, 1, 2, 3)]
        a, b, c = (values[0] + values[2]) / 2 - values[1], (values[2] - values[0]) / 2, values[1]
        if all(same(a * t * t + b * t + c, v) for t, v in ((2, values[3]), (3, values[4]))):
            if abs(a) < NIL:
                if abs(b) < NIL:
                    return None if abs(c) < CLOSE else False
                roots = [-c / b]
            else:
                inner = b * b - 4 * a * c
                roots = [(-b + s * mp.sqrt(max(inner, 0))) / (2 * a) for s in (1, -1)] if inner > -CLOSE else []
            found = [self.formula(body, self.inside(at, {x: t})) for t in roots]
            return any(found) if None not in found else None
        grid = [mpf(t) / 10 for t in range(-80, 81)]
        for one, other in pairwise(grid):
            if gap(one) * gap(other) <= 0:
                root = mp.findroot(gap, (one, other), solver="anderson", verify=False)
                if self.formula(body, self.inside(at, {x: root})):
                    return True
        return None


PLACES = [mpf(n) / d for n, d in ((1, 1), (1, 3), (-2, 1), (5, 7), (3, 1), (-1, 2), (9, 4), (1, 50), (-31, 9))]


def is_endless(end: Tree) -> bool:
    """Whether an end of an integral is infinite."""
    return not isinstance(end, (int, str)) and end[0] in ENDS


def quadrature(inside: Callable[[Number], Number], places: list[Number]) -> Number:
    """The integral, if its digits can be had."""
    value, error = mp.quad(inside, places, error=True, maxdegree=7)
    if mp.isfinite(value) and error > ENOUGH * abs(value):  # what cancels, or is tiny
        error = max(error - ENOUGH * mp.quad(lambda t: abs(inside(t)), places, maxdegree=4), 0)
    if not mp.isfinite(value) or error > ENOUGH * abs(value):
        raise NoValue("an integral of which too few digits are known")
    return value


def converges(inside: Callable[[Number], Number], low: Tree, high: Tree) -> bool:
    """Whether an integral has a finite value, by the decay of a power far away and near 0; others are left out."""
    endless = [is_endless(end) for end in (low, high)]
    sides = [(1, FAR)] * endless[1] + [(-1, FAR)] * endless[0]
    sides += [(1, -FAR)] * (all(endless) or low == 0) + [(-1, -FAR)] * (all(endless) or high == 0)
    for side, s in sides:
        near, far = (abs(inside(side * mp.exp(k * s)) * mp.exp(k * s)) for k in (1, 2))
        if far != 0 and far >= near * mpf(10) ** -12:
            return False
    return True
