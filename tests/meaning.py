"""What terms and formulas mean, at 50 digits, read from raw JSON. It shares nothing with the checker or its terms.

True, False, or None where a term has no value (or nobody can say, as of "something exists").
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import pairwise
from typing import Any

from mpmath import mp, mpf

mp.dps = 50
JSON = Any
Values = Mapping[str, mpf]
CLOSE = mpf(10) ** -22  # two sides that are nearer to each other, in proportion, are equal
MORE = 450  # digits
NIL = mpf(10) ** -40
FAR = 300  # exp(FAR): where an integrand over a half-line is looked at
BINDERS = {"mean", "integral", "diverges", "sum", "product", "diff"}


class NoValue(Exception):
    """A term that has no value here, or none that can be found."""


class Smooth:
    """Random smooth functions, with all derivatives; at some places they have values of their own."""

    def __init__(self, rng: Any) -> None:
        self.rng, self.waves, self.own = rng, {}, {}  # type: ignore[var-annotated]

    def state(self, name: str, orders: list[int], places: list[mpf], value: mpf) -> None:
        self.own[name, tuple(orders), tuple(mp.nstr(+p, 25) for p in places)] = value

    def __call__(self, name: str, orders: list[int], places: list[mpf]) -> mpf:
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
            total += size * mp.sin(phase)
        return total


def unfold(node: JSON, names: Mapping[str, JSON]) -> JSON:
    """Names that are defined replaced by their text, but where a binder gives them another meaning."""
    if isinstance(node, str):
        return names.get(node, node)
    if not isinstance(node, list):
        return node
    tag = node[0]
    if tag in BINDERS:
        inner = {x: text for x, text in names.items() if x != node[2]}
        return [tag, unfold(node[1], inner), node[2], *(unfold(each, names) for each in node[3:])]
    if tag in ("exists", "forall"):
        return [tag, node[1], unfold(node[2], {x: text for x, text in names.items() if x not in node[1]})]
    if tag == "call":
        return [*node[:3], *(unfold(each, names) for each in node[3:])]
    return [tag, *(unfold(each, names) for each in node[1:])]


def unfolded(definitions: list[Any]) -> dict[str, JSON]:
    """The text of every definition, those before it unfolded."""
    names: dict[str, JSON] = {}
    for name, text in definitions:
        names[name] = unfold(text, names)
    return names


class Meaning:
    """Values of terms with the letters and functions given."""

    def __init__(self, functions: Smooth) -> None:
        self.functions = functions

    def term(self, node: JSON, at: Values) -> mpf:
        if isinstance(node, int):
            return mpf(node)
        if isinstance(node, str):
            if node not in at:
                raise NoValue(node)
            return at[node]
        tag = node[0]
        if tag in BINDERS:
            return self.binder(node, at)
        if tag == "call":
            return self.functions(node[1], node[2], [self.term(each, at) for each in node[3:]])
        if tag == "^":
            return power(self.term(node[1], at), node[2])
        parts = [self.term(each, at) for each in node[1:]]
        if tag == "/":
            return parts[0] / nonzero(parts[1])
        if tag == "tan":
            nonzero(mp.cos(parts[0]))
        if tag not in OPERATIONS:
            raise NoValue(tag)
        return OPERATIONS[tag](*parts)

    def binder(self, node: JSON, at: Values) -> mpf:
        tag, body, x, *ends = node

        def inside(place: mpf) -> mpf:
            return self.term(body, {**at, x: place})

        if tag == "diff":
            place = self.term(ends[1], at)
            self.term(body, {**at, x: place})
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
        low, high = (
            (mp.inf if end == ["infinity"] else -mp.inf) if end in (["infinity"], ["-infinity"]) else self.term(end, at)
            for end in ends
        )
        if low == high:
            return mpf(0)
        return quadrature(inside, [low, 0, high] if mp.isinf(low) and mp.isinf(high) else [low, high])

    def formula(self, node: JSON, at: Values) -> bool | None:
        """What is false at 50 digits is looked at with 400 more."""
        try:
            found = self.truth(node, at)
            if found is False and mp.dps < MORE:
                with mp.workdps(MORE):
                    found = self.truth(node, at)
            return found
        except (NoValue, ZeroDivisionError, ValueError, OverflowError, mp.NoConvergence):
            return None

    def truth(self, node: JSON, at: Values) -> bool | None:
        tag = node[0]
        if tag in RELATIONS:
            left, right = (self.term(side, at) for side in node[1:])
            if mp.im(left) or mp.im(right) or mp.isnan(left) or mp.isnan(right):
                raise NoValue("a number that is not real")
            near = left == right or (same(left, right) and not self.apart(node, at, left - right))
            return RELATIONS[tag](0 if near else 1 if left > right else -1)
        if tag == "exists":
            return self.existence(node, at)
        if tag == "forall":
            places = [*PLACES[::3], *self.between(node[2], {x: t for x, t in at.items() if x not in node[1]})]
            found = [self.formula(node[2], {**at, **dict.fromkeys(node[1], place)}) for place in places]
            return False if False in found else None if None in found else True
        parts = [self.truth(each, at) for each in node[1:]]
        if any(each is None for each in parts):
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

    def between(self, body: JSON, at: Values) -> list[mpf]:
        """Where the premise of an implication may hold: between the numbers that it mentions."""
        ends = []
        for part in body[1][1:] if body[0] == "=>" and body[1][0] == "and" else ():
            for side in part[1:]:
                try:
                    ends.append(self.term(side, at))
                except NoValue:
                    continue
        return [ends[0] + (ends[1] - ends[0]) * k / 5 for k in range(6)] if len(ends) == 2 else []

    def apart(self, node: JSON, at: Values, gap: mpf) -> bool:
        """Whether two sides near to each other differ: with more digits, noise gets smaller and a number stays."""
        if mp.dps < MORE:
            return False
        with mp.workdps(2 * MORE):
            return abs(self.term(node[1], at) - self.term(node[2], at) - gap) < abs(gap) / 1000

    def existence(self, node: JSON, at: Values) -> bool | None:
        """By trial; for one letter also by change of sign. An equation of at most second degree is decided."""
        _, (x, *more), body = node
        places = [*PLACES, *(-t for t in PLACES), mpf(0), *at.values()]
        if any(self.formula(body, {**at, **dict.fromkeys(node[1], t)}) for t in places):
            return True
        equations = [each for each in (body[1:] if body[0] == "and" else [body]) if each[0] == "="]
        if more or not equations:
            return None

        def gap(t: mpf) -> mpf:
            return self.term(equations[0][1], {**at, x: t}) - self.term(equations[0][2], {**at, x: t})

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
            found = [self.formula(body, {**at, x: t}) for t in roots]
            return any(found) if None not in found else None
        grid = [mpf(t) / 10 for t in range(-80, 81)]
        for one, other in pairwise(grid):
            if gap(one) * gap(other) <= 0:
                root = mp.findroot(gap, (one, other), solver="anderson", verify=False)
                if self.formula(body, {**at, x: root}):
                    return True
        return None


def same(left: mpf, right: mpf) -> bool:
    return abs(left - right) <= CLOSE * max(1, abs(left), abs(right))


def nonzero(value: mpf) -> mpf:
    if abs(value) < NIL:
        raise NoValue("a division by zero")
    return value


def power(base: mpf, exponent: int) -> mpf:
    if abs(exponent) > 1000:
        raise NoValue("an exponent")
    return base**exponent if exponent >= 0 else 1 / nonzero(base) ** -exponent


def real_power(base: mpf, exponent: mpf) -> mpf:
    """Of a base that is positive; whole powers are said of all bases."""
    whole = mp.nint(exponent)
    if base > 0:
        return base**exponent
    if abs(exponent - whole) > NIL:
        raise NoValue("a power")
    return power(base, int(whole))


def defined(function: Callable[[mpf], mpf], where: Callable[[mpf], bool]) -> Callable[[mpf], mpf]:
    def value(t: mpf) -> mpf:
        if not where(t):
            raise NoValue(function)
        return function(t)

    return value


def unit(t: mpf) -> bool:
    return abs(t) <= 1


OPERATIONS: dict[str, Callable[..., mpf]] = {
    "+": lambda *parts: mp.fsum(parts), "*": lambda *parts: mp.fprod(parts), "-": lambda t: -t,
    "pi": lambda: +mp.pi, "sin": mp.sin, "cos": mp.cos, "tan": mp.tan, "arctan": mp.atan, "exp": mp.exp,
    "sqrt": defined(lambda t: mp.sqrt(max(t, 0)), lambda t: t >= -NIL), "log": defined(mp.log, lambda t: t > 0),
    "arcsin": defined(mp.asin, unit), "arccos": defined(mp.acos, unit),
    "gamma": defined(mp.gamma, lambda t: t > 0 or not mp.isint(t)), "pow": real_power,
}  # fmt: skip
RELATIONS: dict[str, Callable[[int], bool]] = {
    "=": lambda sign: sign == 0, "!=": lambda sign: sign != 0, "<": lambda sign: sign < 0,
    "<=": lambda sign: sign <= 0, ">": lambda sign: sign > 0, ">=": lambda sign: sign >= 0,
}  # fmt: skip
PLACES = [mpf(n) / d for n, d in ((1, 1), (1, 3), (-2, 1), (5, 7), (3, 1), (-1, 2), (9, 4), (1, 50), (-31, 9))]


def quadrature(inside: Callable[[mpf], mpf], places: list[mpf]) -> mpf:
    """The integral, if its digits can be had."""
    value, error = mp.quad(inside, places, error=True, maxdegree=7)
    if not mp.isfinite(value) or error > mpf(10) ** -24 * max(1, abs(value)):
        raise NoValue("an integral of which too few digits are known")
    return value


def converges(inside: Callable[[mpf], mpf], low: JSON, high: JSON) -> bool:
    """Whether an integral to infinity is finite, by the decay of a power; between numbers nothing is said."""
    endless = [end in (["infinity"], ["-infinity"]) for end in (low, high)]
    if not any(endless):
        return True
    if not all(endless) and low != 0:
        raise NoValue("a half-line from elsewhere")
    sides = (1, -1) if all(endless) else (1,) if endless[1] else (-1,)
    logarithmic = [abs(inside(side * mp.exp(s)) * mp.exp(s)) for side in sides for s in (-2 * FAR, -FAR, FAR, 2 * FAR)]
    for near, far in zip(
        [*logarithmic[1::4], *logarithmic[2::4]], [*logarithmic[::4], *logarithmic[3::4]], strict=True
    ):
        if far != 0 and far >= near * mpf(10) ** -12:
            return False
    return True
