"""A judge independent of the provers: evaluates formulas with 40 digits at points where the hypotheses hold."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import chain
from math import prod
from typing import Any

import mpmath
from scipy.optimize import linprog

from symcheck.core.calculus import letters
from symcheck.core.certificates import Certificate
from symcheck.core.claims import Problem
from symcheck.core.formulas import conjuncts
from symcheck.core.terms import (
    INFINITY,
    MINUS_INFINITY,
    PI,
    Binder,
    Call,
    Connective,
    Formula,
    Quantified,
    Reader,
    Relation,
    Term,
    node,
)

mpmath.mp.dps = 40
SEED = 20090055
DRAWS, ENOUGH = 10, 3  # points that are tried, and points where the hypotheses hold
TOLERANCE = mpmath.mpf(10) ** -25  # of a difference, in proportion to what is compared
SOLVED, STEPS, LARGE = mpmath.mpf(10) ** -60, 10, 10**9  # of Newton's method: what is left squared, steps, values
CONSTANTS = {PI: mpmath.pi, INFINITY: mpmath.inf, MINUS_INFINITY: -mpmath.inf}
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
            return self._letter(term)
        if term in CONSTANTS:
            return CONSTANTS[term]
        if isinstance(term, Call):
            return self._call(term.function, term.orders, [self.value(part) for part in term.terms])
        if isinstance(term, Binder):
            return self._derivative(term) if term.tag == "diff" else self._mean(term)
        return _applied(term.tag, [self.value(part) for part in term.outside])

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

    def _mean(self, term: Binder) -> Any:
        """A mean over one turn of a trigonometric polynomial, for which 64 points are exact; no integral."""
        if term.tag != "mean":
            raise KeyError(f"no {term.tag} is known to 40 digits")
        self._settle(term)
        return mpmath.fsum(self.inside(term.letter, 2 * mpmath.pi * k / 64).value(term.body) for k in range(64)) / 64

    def _derivative(self, term: Binder) -> Any:
        order, place = term.outside
        at = self.value(place)
        self._settle(term)

        def along(x: Any) -> Any:
            return self.inside(term.letter, x).value(term.body)

        return mpmath.diff(along, at, order, h=mpmath.mpf(10) ** -28)

    def _settle(self, term: Binder) -> None:
        """Values for the free letters of a body, that are the same wherever the bound one is."""
        inner = self.inside(term.letter, mpmath.mpf(1))
        inner.value(term.body)
        self.at |= {x: v for x, v in inner.at.items() if x != term.letter and x not in self.unfold}

    def holds(self, formula: Formula) -> bool:
        """Whether a formula without quantifiers holds here."""
        match formula:
            case Relation(terms=sides):
                left, right = map(self.value, sides)
                gap, small = left - right, TOLERANCE * max(1, abs(left), abs(right))
                if formula.tag not in ("=", "!=") and 0 < abs(gap) < small:
                    raise ValueError("a sign that cannot be told")
                return bool(SIGNS[formula.tag](gap, small))
            case Connective(formulas=parts):
                return CONNECTIVES[formula.tag]([self.holds(part) for part in parts])
            case Quantified(tag="exists"):
                return self._exists(formula.bound, formula.body)
        raise KeyError(formula.tag)

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
        for part in conjuncts(body):
            if not isinstance(part, Relation):
                raise KeyError(part.tag)
            head, (left, right) = part.tag, part.terms
            larger, smaller = (right, left) if head in ("<", "<=") else (left, right)
            row = self._affine(names, node("+", larger, node("-", smaller)))
            if head == "=":
                equal.append(row)
            elif head != "!=":
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
            known = Place({}, rng, {})
            try:
                yield {name: known.value(Reader().term(value)) for name, value in point["values"].items()}
            except NO_VALUE:
                continue


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
        case Connective(tag="and", formulas=parts):
            for part in parts:
                yield from goals(part, given)
        case Connective(tag="=>", formulas=(premise, conclusion)):
            yield from goals(conclusion, [*given, premise])
        case Connective(tag="<=>", formulas=(left, right)):
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
    if not isinstance(formula, Connective) or formula.tag not in ("and", "or"):
        return formula
    if formula.tag == "or":
        return _chosen(rng.choice(formula.formulas), rng)
    return node("and", *(_chosen(part, rng) for part in formula.formulas))


def _equations(formula: Formula) -> Iterator[tuple[Term, Term]]:
    for part in conjuncts(formula):
        if isinstance(part, Relation) and part.tag == "=":
            left, right = part.terms
            yield left, right


def _solve(place: Place, given: list[Formula]) -> None:
    """Moves as many letters as there are equations, by Newton's method, to where these hold."""
    open_ = [pair for formula in given for pair in _equations(formula) if not place.holds(node("=", *pair))]
    if not open_:
        return
    spoken = set().union(*(_letters(side, place.unfold) for pair in open_ for side in pair))
    names = sorted(spoken & place.at.keys())
    if len(names) < len(open_):
        raise KeyError("more equations than letters")
    ordered = [*_letters_of_orders(given, place.unfold)]
    names = place.rng.sample(names, len(names))
    if place.rng.random() < 0.7:
        names.sort(key=ordered.count)  # others may leave the range where they have to lie
    moved = names[: len(open_)]

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
    for formula in (part for each in given for part in conjuncts(each)):
        if formula.tag != "=":
            yield from _letters(formula, unfold)


def _free(place: Place) -> dict[str, Any]:
    return {name: value for name, value in place.at.items() if name not in place.unfold}


def _letters(tree: Term, unfold: Mapping[str, Term]) -> set[str]:
    """The letters of a term or formula, definitions unfolded."""
    return set().union(*(_letters(unfold[x], unfold) if x in unfold else {x} for x in letters(tree)))
