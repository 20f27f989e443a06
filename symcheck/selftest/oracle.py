"""A judge independent of the provers: evaluates formulas with 50 digits at points where the hypotheses hold."""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Mapping
from itertools import chain

import mpmath
from mpmath import mpf
from scipy.optimize import linprog

from symcheck.coq.meaning import Meaning, NoValue, Number, Smooth, Tree, Values
from symcheck.core.calculus import letters
from symcheck.core.certificates import Certificate
from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Problem
from symcheck.core.terms import (
    Connective,
    Formula,
    Relation,
    Term,
    node,
)

SEED = 20090055  # any number: with a fixed one every run tries the same points
DRAWS, ENOUGH = 10, 3  # points that are tried, and points where the hypotheses hold
TOLERANCE = mpf(10) ** -25  # of a difference, in proportion to what is compared
SOLVED, STEPS, LARGE = mpf(10) ** -60, 10, 10**9  # of Newton's method: what is left squared, steps, values
FAR, DOUBT, INFEASIBLE = 1e4, (1e-9, 1e-6), 2  # of linear programming: bounds, what is too near to zero, a status
Row = list[Number]  # of what is linear: the constant, and the coefficients of the letters
NO_VALUE = (ZeroDivisionError, TypeError, ValueError, OverflowError)


class Place(Meaning):
    """A point whose letters are drawn when asked for. No integral, sum or product is known to enough digits."""

    binders = frozenset(("mean", "diff"))

    def __init__(self, definitions: Mapping[str, Term], rng: random.Random, at: Values) -> None:
        super().__init__(Smooth(random.Random(SEED)), definitions)
        self.rng, self.at = rng, dict(at)

    def value(self, term: object) -> Number:
        """The number a term stands for; one of NO_VALUE is raised if it has none."""
        return self.term(term, self.at)

    def holds(self, formula: Formula) -> bool:
        """Whether a formula holds here."""
        return bool(self.truth(formula, self.at))

    def unknown(self, x: str) -> Number:
        """Small numbers as often as large ones, mostly positive, as moments and lengths are."""
        if x not in self.at:
            number = mpf(self.rng.randint(1, 10**6)) / self.rng.choice((10**4, 10**6, 3 * 10**6))
            self.at[x] = -number if self.rng.random() < 0.15 else number
        return self.at[x]

    def sign(self, relation: Tree, at: Values) -> int:
        left, right = (self.term(side, at) for side in relation[1:])
        gap = left - right
        if abs(gap) < TOLERANCE * max(1, abs(left), abs(right)):
            if gap and relation[0] not in ("=", "!="):
                raise NoValue("a sign that cannot be determined")
            return 0
        return 1 if gap > 0 else -1

    def quantified(self, node: Tree, at: Values) -> bool:
        """Whether linear orders and equations have a common solution; NoValue if they are not linear.

        The most by which all orders can be met is zero, or far from it: with what is so near to zero that the few
        digits of linear programming leave it in doubt, nothing is decided.
        """
        kind, names, body = node
        if kind != "exists":
            raise NoValue(kind)
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
            raise NoValue("nothing certain about a linear program")
        return bool(-found.fun >= DOUBT[1])

    def _rows(self, names: tuple[str, ...], body: Formula) -> tuple[list[tuple[Row, bool]], list[Row]]:
        """What is not negative (or positive: True), and what is zero."""
        rows, equal = [], []
        for part in conjuncts(body):
            if not isinstance(part, Relation):
                raise NoValue(part.tag)
            head, (left, right) = part.tag, part.terms
            larger, smaller = (right, left) if head in ("<", "<=") else (left, right)
            row = self._affine(names, node("+", larger, node("-", smaller)))
            if head == "=":
                equal.append(row)
            elif head != "!=":
                rows.append((row, len(head) == 1))
            else:
                raise NoValue(head)
        return rows, equal

    def _affine(self, names: tuple[str, ...], term: Term) -> Row:
        def at(values: Iterable[int]) -> Number:
            return self.term(term, self.inside(self.at, {x: mpf(n) for x, n in zip(names, values, strict=True)}))

        zero, trial = at([0] * len(names)), range(2, len(names) + 2)
        slopes = [at(int(k == n) for n in range(len(names))) - zero for k in range(len(names))]
        gap = at(trial) - zero - mpmath.fsum(k * slope for k, slope in zip(trial, slopes, strict=True))
        if abs(gap) > TOLERANCE * max(1, abs(zero)):
            raise NoValue("not linear")
        return [zero, *slopes]


def rotation(rng: random.Random, handed: int) -> Values:
    """A random rotation (handed = 1) or reflection (-1), entries a_11 to a_33."""
    w, x, y, z = (mpf(rng.randint(-999, 999)) for _ in range(4))
    n = (w * w + x * x + y * y + z * z) * handed
    rows = (
        (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    )
    return {f"a_{i + 1}{j + 1}": rows[i][j] / n for i in range(3) for j in range(3)}


def drawn(problem: Problem, rng: random.Random) -> Values:
    """Values of the letters of hypotheses that no point chosen at random satisfies."""
    names = {name for name, _ in problem.hypotheses}
    at: Values = {}
    if names & {"orthogonal", "right-handed"}:
        at |= rotation(rng, 1 if "right-handed" in names else rng.choice((1, -1)))
    if "chosen angles" in names:
        at |= {"beta": mpmath.asin(1 / mpmath.sqrt(3)), "gamma": mpmath.pi / 4}
    if "damping matrix symmetric" in names:
        m = {(i, j): mpf(rng.randint(1, 999)) / 7 for i in (1, 2, 3) for j in range(i, 4)}
        at |= {f"m_{i}{j}": m[min(i, j), max(i, j)] for i in (1, 2, 3) for j in (1, 2, 3)}
    if "triple root" in names:
        letters = [f"{x}_{i}" for x in "IJL" for i in (1, 2, 3)] + ["k"]
        at |= {letter: mpf(rng.randint(1, 99)) / 7 for letter in letters}
        product = at["I_1"] * at["I_2"] * at["I_3"]
        at["xi"] = at["k"]
        at["J_3"] = product / at["J_1"] / at["J_2"]
        at["L_3"] = (3 * product - at["J_1"] * at["L_1"] - at["J_2"] * at["L_2"]) / at["J_3"]
    return at


def witnessed(evidence: Iterable[Certificate], rng: random.Random) -> Iterator[Values]:
    """The points of certificates at which all that is assumed holds, as numbers."""
    for certificate in evidence:
        for point in certificate.get("witnesses", ()):
            known = Place({}, rng, {})
            try:
                yield {name: known.value(value) for name, value in point["values"].items()}
            except NO_VALUE:
                continue


def fails(problem: Problem, evidence: Iterable[Certificate] = ()) -> bool | None:
    """Whether the claim fails at some point where the hypotheses hold; None if no point says anything.

    Points are taken from the witnesses of certificates, or drawn and moved to where the equations hold.
    """
    rng, evidence = random.Random(SEED), [*evidence]
    given = [formula for _, formulas in problem.hypotheses for formula in formulas]
    failing = [_fails(problem, assumed, claim, evidence, rng) for assumed, claim in goals(problem.claim, given)]
    return True if True in failing else None if None in failing else False


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
    definitions, points = dict(problem.definitions), 0
    for at in chain(witnessed(evidence, rng), (drawn(problem, rng) for _ in range(DRAWS))):
        place = Place(definitions, rng, at)
        try:
            _solve(place, [_chosen(formula, rng) for formula in given])
            if not all(place.holds(formula) for formula in given):
                continue
            if not place.holds(claim):
                return True
        except NO_VALUE:
            continue
        points += 1
        if points == ENOUGH:
            break
    return False if points else None


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
    spoken = set().union(*(_letters(side, place.definitions) for pair in open_ for side in pair))
    names = sorted(spoken & place.at.keys())
    if len(names) < len(open_):
        raise NoValue("more equations than letters")
    ordered = [*_letters_of_orders(given, place.definitions)]
    names = place.rng.sample(names, len(names))
    if place.rng.random() < 0.7:
        names.sort(key=ordered.count)  # others may leave the range where they have to lie
    moved = names[: len(open_)]

    def gaps(*values: Number) -> list[Number]:
        if any(abs(value) > LARGE for value in values):
            raise ValueError("it goes astray")
        there = _free(place) | dict(zip(moved, values, strict=True))
        return [place.term(left, there) - place.term(right, there) for left, right in open_]

    start = [place.at[name] for name in moved]
    solution = mpmath.findroot(gaps, start if len(moved) > 1 else start[0], tol=SOLVED, maxsteps=STEPS)
    place.at = _free(place) | dict(zip(moved, solution if len(moved) > 1 else [solution], strict=True))


def _letters_of_orders(given: Iterable[Formula], unfold: Mapping[str, Term]) -> Iterator[str]:
    """The letters of everything given but equations, as often as there is such."""
    for part in conjuncts(node("and", *given)):
        if part.tag != "=":
            yield from _letters(part, unfold)


def _free(place: Place) -> Values:
    return place.inside(place.at, {})


def _letters(tree: Term, unfold: Mapping[str, Term]) -> set[str]:
    """The letters of a term or formula, definitions unfolded."""
    return set().union(*(_letters(unfold[x], unfold) if x in unfold else {x} for x in letters(tree)))
