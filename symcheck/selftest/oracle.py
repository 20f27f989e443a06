"""A judge independent of the provers: evaluates formulas with 40 digits at points where the hypotheses hold."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import chain
from math import prod
from typing import Any

import mpmath
from scipy.optimize import linprog

from symcheck.proof.theorems import conjuncts
from symcheck.selftest.evidence import frozen
from symcheck.statement import Certificate, Formula, Problem, Term

mpmath.mp.dps = 40
SEED = 20090055
DRAWS, ENOUGH = 10, 3  # points that are tried, and points where the hypotheses hold
TOLERANCE = mpmath.mpf(10) ** -25  # of a difference, in proportion to what is compared
SOLVED, STEPS, LARGE = mpmath.mpf(10) ** -60, 10, 10**9  # of Newton's method: what is left squared, steps, values
CONSTANTS = {"pi": mpmath.pi, "infinity": mpmath.inf}
SIGNS: dict[str, Callable[[Any, Any], bool]] = {
    "=": lambda d, small: abs(d) < small,
    "!=": lambda d, small: abs(d) > small,
    "<=": lambda d, small: d < small,
    ">=": lambda d, small: d > -small,
    "<": lambda d, small: d < -small,
    ">": lambda d, small: d > small,
}
CONNECTIVES: dict[str, Callable[[list[bool]], bool]] = {
    "and": all,
    "or": any,
    "=>": lambda truths: not truths[0] or truths[1],
    "<=>": lambda truths: truths[0] == truths[1],
}
NAMES = {"arctan": "atan", "arcsin": "asin", "arccos": "acos"}
FAR, DOUBT, INFEASIBLE = 1e4, (1e-9, 1e-6), 2  # of linear programming: bounds, what is too near to zero, a status
WAVES = 2  # an unknown function is a sum of so many sines
NO_VALUE = (ZeroDivisionError, KeyError, AttributeError, TypeError, ValueError, OverflowError)


class Place:
    """Values of letters, drawn when asked for, and of unknown functions."""

    def __init__(self, unfold: Mapping[str, Term], rng: random.Random, at: Mapping[str, Any]) -> None:
        self.unfold, self.rng, self.at = unfold, rng, dict(at)
        self.waves: dict[tuple[str, int], tuple[Any, list[Any]]] = {}

    def inside(self, letter: str, value: Any) -> Place:
        """The same place but for one letter; definitions, which may contain it, are evaluated anew."""
        kept = {name: each for name, each in self.at.items() if name not in self.unfold}
        other = Place(self.unfold, self.rng, kept | {letter: value})
        other.waves = self.waves
        return other

    def value(self, term: Term) -> Any:
        """The number a term stands for; KeyError or ZeroDivisionError if it has none, or none to 40 digits."""
        if isinstance(term, int):
            return mpmath.mpf(term)
        if isinstance(term, str):
            return CONSTANTS[term] if term in CONSTANTS else self._letter(term)
        head, *rest = term
        if head == "diff":
            return self._derivative(*rest)
        if head in ("mean", "integral", "diverges"):
            return self._over(head, *rest)
        if head == "call":
            return self._call(rest[0], rest[1], [self.value(part) for part in rest[2:]])
        return _applied(head, [self.value(part) for part in rest])

    def _letter(self, name: str) -> Any:
        if name not in self.at:
            self.at[name] = self.value(self.unfold[name]) if name in self.unfold else self._drawn()
        return self.at[name]

    def _drawn(self) -> Any:
        """Small numbers as often as large ones, mostly positive, as moments and lengths are."""
        number = mpmath.mpf(self.rng.randint(1, 10**6)) / self.rng.choice((10**4, 10**6, 3 * 10**6))
        return -number if self.rng.random() < 0.15 else number

    def _call(self, name: str, orders: Iterable[int], arguments: list[Any]) -> Any:
        """A smooth function: a sum of sines of its arguments, with all derivatives."""
        total = mpmath.mpf(0)
        for k in range(WAVES):
            if (name, k) not in self.waves:
                draw = random.Random(f"{name} {k} {len(arguments)}").randint
                self.waves[name, k] = mpmath.mpf(draw(1, 99)) / 17, [mpmath.mpf(draw(1, 99)) / 31 for _ in arguments]
            phase, slopes = self.waves[name, k]
            size = mpmath.mpf(1)
            for slope, order, argument in zip(slopes, orders, arguments, strict=True):
                phase, size = phase + slope * argument + order * mpmath.pi / 2, size * slope**order
            total += size * mpmath.sin(phase)
        return total

    def _over(self, head: str, body: Term, name: str, *_: Term) -> Any:
        """A mean over one turn of a trigonometric polynomial, for which 64 points are exact; no integral."""
        if head != "mean":
            raise KeyError("an integral is not known to 40 digits")
        self._settle(body, name)
        return mpmath.fsum(self.inside(name, 2 * mpmath.pi * k / 64).value(body) for k in range(64)) / 64

    def _derivative(self, body: Term, name: str, order: int) -> Any:
        place = self._letter(name)
        self._settle(body, name)

        def along(x: Any) -> Any:
            return self.inside(name, x).value(body)

        return mpmath.diff(along, place, order, h=mpmath.mpf(10) ** -28) if order else along(place)

    def _settle(self, body: Term, name: str) -> None:
        """Values for the free letters of a body, that are the same wherever the bound one is."""
        inner = self.inside(name, mpmath.mpf(1))
        inner.value(body)
        self.at |= {x: v for x, v in inner.at.items() if x != name and x not in self.unfold}

    def holds(self, formula: Formula) -> bool:
        """Whether a formula without quantifiers holds here."""
        head, *parts = formula
        if head == "exists":
            return self._exists(*parts)
        if head in SIGNS:
            left, right = (self.value(part) for part in parts)
            gap, small = left - right, TOLERANCE * max(1, abs(left), abs(right))
            if head not in ("=", "!=") and 0 < abs(gap) < small:
                raise ValueError("a sign that cannot be told")
            return bool(SIGNS[head](gap, small))
        return CONNECTIVES[head]([self.holds(part) for part in parts if head in CONNECTIVES])

    def _exists(self, names: tuple[str, ...], body: Formula) -> bool:
        """Whether linear orders and equations have a common solution; KeyError if they are not linear.

        The most by which all orders can be met is zero, or far from it: with what is so near to zero that the few
        digits of linear programming leave it in doubt, nothing is decided.
        """
        rows, equal = self._rows(names, body)
        n = len(names)
        bounds = [(-FAR, FAR)] * n + [(None, 1)]
        above = [[-float(c) for c in row[1:]] + [float(strict)] for row, strict in rows]
        found = linprog(
            [0] * n + [-1],
            A_ub=above or None,
            b_ub=[float(row[0]) for row, _ in rows] or None,
            A_eq=[[*map(float, row[1:]), 0] for row in equal] or None,
            b_eq=[-float(row[0]) for row in equal] or None,
            bounds=bounds,
        )
        if found.status == INFEASIBLE:
            return False
        if found.status or DOUBT[0] < -found.fun < DOUBT[1]:
            raise KeyError("nothing certain about a linear program")
        return bool(-found.fun >= DOUBT[1])

    def _rows(self, names: tuple[str, ...], body: Formula) -> tuple[list[tuple[list[Any], bool]], list[list[Any]]]:
        """[constant, coefficients] of what is not negative (or positive: True), and of what is zero."""
        rows, equal = [], []
        for head, left, right in conjuncts(body):
            larger, smaller = (right, left) if head in ("<", "<=") else (left, right)
            row = self._affine(names, ("+", larger, ("-", smaller)))
            if head == "=":
                equal.append(row)
            elif head in SIGNS and head != "!=":
                rows.append((row, len(head) == 1))
            else:
                raise KeyError(head)
        return rows, equal

    def _affine(self, names: tuple[str, ...], term: Term) -> list[Any]:
        def at(values: Iterable[int]) -> Any:
            place = self
            for name, value in zip(names, values, strict=True):
                place = place.inside(name, mpmath.mpf(value))
            return place.value(term)

        zero, trial = at([0] * len(names)), range(2, len(names) + 2)
        slopes = [at(int(k == n) for n in range(len(names))) - zero for k in range(len(names))]
        gap = at(trial) - zero - mpmath.fsum(k * slope for k, slope in zip(trial, slopes, strict=True))
        if abs(gap) > TOLERANCE * max(1, abs(zero)):
            raise KeyError("not linear")
        return [zero, *slopes]


def _applied(head: str, args: list[Any]) -> Any:
    if head == "+":
        return sum(args, mpmath.mpf(0))
    if head == "*":
        return prod(args, start=mpmath.mpf(1))
    if head == "-":
        return -args[0]
    if head == "/":
        return args[0] / args[1]
    if head == "^":
        return args[0] ** int(args[1])
    if head in ("pow", "sqrt", "log") and args[0] < 0:
        raise ZeroDivisionError(f"{head} of a negative number")
    if head in ("arcsin", "arccos") and abs(args[0]) > 1:
        raise ZeroDivisionError(f"{head} of a number above 1")
    if head == "pow":
        return args[0] ** args[1]
    return getattr(mpmath, NAMES.get(head, head))(args[0])


def rotation(rng: random.Random, handed: int) -> dict[str, Any]:
    """A random rotation (handed = 1) or reflection (-1), entries a_11 to a_33."""
    w, x, y, z = (mpmath.mpf(rng.randint(-999, 999)) for _ in range(4))
    n = (w * w + x * x + y * y + z * z) * handed
    rows = (
        (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    )
    return {f"a_{i + 1}{j + 1}": rows[i][j] / n for i in range(3) for j in range(3)}


def drawn(problem: Problem, rng: random.Random) -> dict[str, Any]:
    """Values of the letters of hypotheses that no point chosen at random satisfies."""
    names = {name for name, _ in problem.hypotheses}
    at: dict[str, Any] = {}
    if names & {"orthogonal", "right-handed"}:
        at |= rotation(rng, 1 if "right-handed" in names else rng.choice((1, -1)))
    if "chosen angles" in names:
        at |= {"beta": mpmath.asin(1 / mpmath.sqrt(3)), "gamma": mpmath.pi / 4}
    if "damping matrix symmetric" in names:
        m = {(i, j): mpmath.mpf(rng.randint(1, 999)) / 7 for i in (1, 2, 3) for j in range(i, 4)}
        at |= {f"m_{i}{j}": m[min(i, j), max(i, j)] for i in (1, 2, 3) for j in (1, 2, 3)}
    if "triple root" in names:
        letters = [f"{x}_{i}" for x in "IJL" for i in (1, 2, 3)] + ["k"]
        at |= {letter: mpmath.mpf(rng.randint(1, 99)) / 7 for letter in letters}
        product = at["I_1"] * at["I_2"] * at["I_3"]
        at["xi"] = at["k"]
        at["J_3"] = product / at["J_1"] / at["J_2"]
        at["L_3"] = (3 * product - at["J_1"] * at["L_1"] - at["J_2"] * at["L_2"]) / at["J_3"]
    return at


def witnessed(evidence: Iterable[Certificate], rng: random.Random) -> Iterator[dict[str, Any]]:
    """The points of certificates at which all that is assumed holds, as numbers."""
    for each in evidence:
        for point in each.get("witnesses", ()):
            values = {name: _coordinate(value) for name, value in point["values"].items()}
            try:
                known = Place(values, rng, {})
                at = {name: known.value(name) for name in values}
            except NO_VALUE:
                continue
            angles = {name[4:] for name in at if name[:4] in ("sin_", "cos_")}
            yield at | {x: mpmath.atan2(at[f"sin_{x}"], at[f"cos_{x}"]) for x in angles if f"sin_{x}" in at}


def _coordinate(value: Any) -> Term:
    if isinstance(value, str):
        top, _, bottom = value.partition("/")
        return ("/", int(top), int(bottom or 1))
    term: Term = frozen(value)
    return term


def fails(problem: Problem, evidence: Iterable[Certificate] = ()) -> bool | None:
    """Whether the claim fails at some point where the hypotheses hold; None if no point says anything.

    Points are taken from the witnesses of certificates, or drawn and moved to where the equations hold.
    """
    rng, evidence = random.Random(SEED), [*evidence]
    given = [formula for _, formulas in problem.hypotheses for formula in formulas]
    found = [_fails(problem, assumed, claim, evidence, rng) for assumed, claim in goals(problem.claim, given)]
    return True if True in found else None if None in found else False


def goals(claim: Formula, given: list[Formula]) -> Iterator[tuple[list[Formula], Formula]]:
    """A claim taken apart: what is assumed, and what has to follow, for each part and each direction."""
    match claim:
        case ("and", *parts):
            for part in parts:
                yield from goals(part, given)
        case ("=>", premise, conclusion):
            yield from goals(conclusion, [*given, premise])
        case ("<=>", left, right):
            yield from goals(right, [*given, left])
            yield from goals(left, [*given, right])
        case _:
            yield given, claim


def _fails(
    problem: Problem, given: list[Formula], claim: Formula, evidence: list[Certificate], rng: random.Random
) -> bool | None:
    unfold, found = dict(problem.definitions), 0
    for at in chain(witnessed(evidence, rng), (drawn(problem, rng) for _ in range(DRAWS))):
        place = Place(unfold, rng, at)
        try:
            _solve(place, [_chosen(formula, rng) for formula in given])
            if not all(place.holds(formula) for formula in given):
                continue
            if not place.holds(claim):
                return True
        except NO_VALUE:
            continue
        found += 1
        if found == ENOUGH:
            break
    return False if found else None


def _chosen(formula: Formula, rng: random.Random) -> Formula:
    """A formula with one alternative of each `or`."""
    if formula[0] == "or":
        return _chosen(rng.choice(formula[1:]), rng)
    return ("and", *(_chosen(part, rng) for part in formula[1:])) if formula[0] == "and" else formula


def _equations(formula: Formula) -> Iterator[tuple[Term, Term]]:
    if formula[0] == "=":
        yield formula[1], formula[2]
    elif formula[0] == "and":
        for part in formula[1:]:
            yield from _equations(part)


def _solve(place: Place, given: list[Formula]) -> None:
    """Moves as many letters as there are equations, by Newton's method, to where these hold."""
    open_ = [pair for formula in given for pair in _equations(formula) if not place.holds(("=", *pair))]
    if not open_:
        return
    letters = sorted(name for name in _letters(open_, place.unfold) if name in place.at)
    if len(letters) < len(open_):
        raise KeyError("more equations than letters")
    ordered = [*_letters_of_orders(given, place.unfold)]
    letters = place.rng.sample(letters, len(letters))
    if place.rng.random() < 0.7:
        letters.sort(key=ordered.count)  # others may leave the range where they have to lie
    moved = letters[: len(open_)]

    def gaps(*values: Any) -> list[Any]:
        if any(abs(value) > LARGE for value in values):
            raise ValueError("it goes astray")
        other = Place(place.unfold, place.rng, _free(place) | dict(zip(moved, values, strict=True)))
        return [other.value(left) - other.value(right) for left, right in open_]

    start = [place.at[name] for name in moved]
    solution = mpmath.findroot(gaps, start if len(moved) > 1 else start[0], tol=SOLVED, maxsteps=STEPS)
    place.at = _free(place) | dict(zip(moved, solution if len(moved) > 1 else [solution], strict=True))


def _letters_of_orders(given: Iterable[Formula], unfold: Mapping[str, Term]) -> Iterator[str]:
    """The letters of everything given but equations, as often as there is such."""
    for formula in given:
        if formula[0] == "and":
            yield from _letters_of_orders(formula[1:], unfold)
        elif formula[0] != "=":
            yield from _letters([*formula[1:]], unfold)


def _free(place: Place) -> dict[str, Any]:
    return {name: value for name, value in place.at.items() if name not in place.unfold}


def _letters(value: Any, unfold: Mapping[str, Term]) -> set[str]:
    """The letters in terms, definitions unfolded."""
    if isinstance(value, str):
        return _letters(unfold[value], unfold) if value in unfold else {value}
    return set().union(*(_letters(part, unfold) for part in value)) if isinstance(value, list | tuple) else set()
