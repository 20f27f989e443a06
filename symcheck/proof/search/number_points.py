"""Counterexamples among numbers, told by their digits: at the numbers that letters are, or at a few values of them."""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from itertools import chain, islice
from math import isqrt
from typing import Any

from symcheck.checker.enclosures import between
from symcheck.core.calculus import Unknown, domain, letters, nodes
from symcheck.core.problems import Problem
from symcheck.core.terms import Connective, Formula, Node, Term, mapped, node
from symcheck.proof.algebra.forms import number_term
from symcheck.proof.algebra.knowledge import ORDERS, formulas_of, larger_first, ring_of, stated
from symcheck.proof.algebra.polynomial import Unsupported, constant, subterms, unfold
from symcheck.proof.rules.compute import Point
from symcheck.proof.rules.enclosure import IRRATIONAL, Numbers, compared, relations
from symcheck.proof.rules.identity import prove_identity

# numbers on both sides of those that are compared in most statements
TRIED: tuple[Term, ...] = (1, node("/", 1, 2), node("/", 3, 2), node("/", 1, 4), node("/", 5, 4), 2, 0, node("-", 1), 3)
# where vectors are units and matrices quarter turns most products vanish, so that equations between them are few
_UNITS = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, 0, 1))
_TURNS = (  # by none, and about two axes; the half turn tells a matrix from its inverse's negative
    ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    ((0, -1, 0), (1, 0, 0), (0, 0, 1)),
    ((1, 0, 0), (0, 0, -1), (0, 1, 0)),
    ((-1, 0, 0), (0, -1, 0), (0, 0, 1)),
)
PARTS = tuple(Fraction(k, 16) for k in (8, 1, 15, 4, 12, 2, 14, 6, 10))  # of an interval: near its ends, and between
END_DIGITS = 6  # of the ends of intervals, inside of which points are sought
MAX_BITS = 20  # of denominators of points: beyond, the interval is shorter than its ends are known
FEW = 3  # letters of which all combinations of values can be tried
TRIES_OF_MANY = (
    20  # a false statement about many letters fails nearly everywhere, or in a corner that is not met at random
)
CORNERS = 8  # points: where vectors are units and matrices turns, what is given mostly holds at one of the first few
RATIONAL = ("+", "*", "-", "/", "^")
ENTIRE = ("+", "*", "-", "^", "sin", "cos", "exp", "pi")  # what has a value for all numbers
TRIES = 80  # points, each with a proof by digits, some seconds in all: the papers need 36


def refute_numbers(problem: Problem) -> Point | None:
    """The point of the numbers, where every hypothesis is true and the claim is not, or None."""
    return refute_at(problem, {})


def refute_at_some(problem: Problem) -> Point | None:
    """The same where letters are free: a few values of them are tried, of many letters at random."""
    if chosen := _free(problem):
        points = (dict(zip(chosen, values, strict=True)) for values in _values(len(chosen)))
        return refute_at_first(problem, chain(points, inside(problem, chosen)))
    return None


def inside(problem: Problem, names: Sequence[str]) -> Iterator[dict[str, Term]]:
    """Points within the numbers between which letters are said to be; none where nothing is between two numbers."""
    ends: dict[str, tuple[list[Fraction], list[Fraction]]] = {x: ([], []) for x in names}
    for small, large in (larger_first(f).terms[::-1] for _, f in stated(problem) if f.tag in ORDERS):
        for x, other, side in ((large, small, 0), (small, large, 1)):
            if isinstance(x, str) and x in ends and not letters(other):
                with suppress(Unknown, Unsupported):
                    ends[x][side].append(constant(between(other, END_DIGITS)[1 - side]))
    if not any(low and high for low, high in ends.values()):
        return
    for k in range(len(PARTS)):
        point = dict[str, Term]()
        for j, (x, (lows, highs)) in enumerate(ends.items()):
            low = max(lows) if lows else min(highs) - 1 if highs else Fraction(1, 2)
            high = min(highs) if highs else low + 1
            point[x] = number_term(_simple(low + (high - low) * PARTS[(k + j) % len(PARTS)], (high - low) / 64))
        yield point


def _simple(number: Fraction, near: Fraction) -> Fraction:
    """The number with the smallest denominator that is as near."""
    found = (number.limit_denominator(2**k) for k in range(MAX_BITS))
    return next((each for each in found if abs(each - number) <= abs(near)), number)


def refute_at_corners(problem: Problem) -> Point | None:
    """The same where vectors are units, matrices quarter turns, and numbers are simple; without vectors no point."""
    return refute_at_first(problem, _corners(_free(problem)))


def _free(problem: Problem) -> list[str]:
    """The letters that no equation says, if digits can tell anything of the problem that algebra does not."""
    definitions = dict(problem.definitions)
    formulas = formulas_of(problem)
    whole = [unfold(formula, definitions) for formula in formulas]
    if not any(part.tag in IRRATIONAL for part in subterms(*whole) if isinstance(part, Node)):
        return []
    free = sorted(set().union(*map(letters, whole)))
    fixed = {side for formula in formulas[1:] if formula.tag == "=" for side in formula.terms if isinstance(side, str)}
    return [x for x in free if x not in fixed]


def _corners(names: Iterable[str]) -> Iterator[dict[str, Term]]:
    families: dict[tuple[str, int], list[str]] = {}
    for name in names:
        stem, _, tail = name.rpartition("_")
        indices = len(tail) if stem and len(tail) in (1, 2) and set(tail) <= {*"123"} else 0
        families.setdefault((stem if indices else name, indices), []).append(name)
    if not any(indices for _, indices in families):
        return
    kinds = (TRIED, _UNITS, _TURNS)
    for ks in islice(_places(len(families), len(_UNITS)), CORNERS):
        point = dict[str, Term]()
        for k, ((_, indices), members) in zip(ks, families.items(), strict=True):
            for name in members:
                value: Any = kinds[indices][k]
                for index in name[len(name) - indices :]:
                    value = value[int(index) - 1]
                point[name] = value
        yield point


def _places(count: int, size: int) -> Iterator[tuple[int, ...]]:
    """So many numbers from zero up to a size, by their sum and then in order; there are too many to sort them."""

    def of_sum(count: int, total: int) -> Iterator[tuple[int, ...]]:
        if not count:
            yield ()
            return
        for k in range(max(0, total - (count - 1) * (size - 1)), min(size - 1, total) + 1):
            yield from ((k, *rest) for rest in of_sum(count - 1, total - k))

    for total in range(count * (size - 1) + 1):
        yield from of_sum(count, total)


def _values(count: int) -> Iterator[tuple[Term, ...]]:
    """Values for so many letters: of few letters the simplest ones first, of more at random, without zero."""
    if count <= FEW:
        return (tuple(TRIED[k] for k in ks) for ks in islice(_places(count, len(TRIED)), TRIES))
    rng = random.Random(count)
    return (tuple(rng.choices([value for value in TRIED if value != 0], k=count)) for _ in range(TRIES_OF_MANY))


def refute_at_first(problem: Problem, points: Iterable[Mapping[str, Term]]) -> Point | None:
    """The same at the first of many points that refutes the problem; definitions are unfolded once for all of them."""
    definitions = dict(problem.definitions)
    hypotheses = tuple((name, tuple(unfold(f, definitions) for f in formulas)) for name, formulas in problem.hypotheses)
    plain = replace(problem, claim=unfold(problem.claim, definitions), definitions=(), hypotheses=hypotheses)
    for point in points:
        if (found := refute_at(plain, point)) is not None:
            return refute_at(problem, point) if definitions else found
    return None


def refute_at(problem: Problem, chosen: Mapping[str, Term]) -> Point | None:
    """The same at one point."""
    try:
        numbers = Numbers.of(problem, chosen)
        if numbers is None:
            return None
        at = _There(numbers)
        if any(at.truth(f) is False for _, f in stated(problem) if not _is_long(f)):
            return None
        if at.truth(problem.claim) is not False:
            return None
        sources = [source for source, _ in numbers.sources.values()]
        given = [(ref, f) for ref, f in stated(problem) if ref not in sources]
        conditions = domain(*(unfold(f, dict(problem.definitions)) for f in formulas_of(problem)))
        if not all(numbers.closed(f) and _holds(at.formula(f), numbers) for f in [*conditions, *(f for _, f in given)]):
            return None
        values = {name: unfold(number, dict(problem.definitions)) for name, number in numbers.letters.items()}
        return Point(values, enclosed=tuple(_shown(problem.claim, numbers)))
    except (Unknown, Unsupported, RecursionError):
        return None


class _There:
    """Formulas at a point, with what is rational there worked out: of long ones little is left."""

    def __init__(self, numbers: Numbers) -> None:
        self.numbers, self.known = numbers, dict[Term, Term]()

    def truth(self, formula: Formula) -> bool | None:
        """Whether a formula is true there, by digits."""
        return self.numbers.truth(self.formula(formula))

    def formula(self, formula: Formula) -> Formula:
        """A formula with numbers for its letters; one with bound letters as it is."""
        if any(isinstance(part, Node) and part.bound for part in subterms(formula)):
            return formula
        if isinstance(formula, Connective):
            return node(formula.tag, *map(self.formula, formula.formulas))
        return node(formula.tag, *map(self.number, formula.outside))

    def number(self, term: Term) -> Term:
        """A term with numbers for its letters, those that are rational worked out, and products with zero.

        What may have no value is left as it is.
        """
        if isinstance(term, int):
            return term
        if term not in self.known:
            whole = mapped(term, self.number) if isinstance(term, Node) else self.numbers.number(term)
            self.known[term] = _worked_out(whole) if isinstance(whole, Node) else whole
        return self.known[term]


def _worked_out(term: Node) -> Term:
    new: Term = term
    match term:
        case Node(tag="*", outside=parts) if 0 in parts and all(part.tag in ENTIRE for part in nodes(term)):
            return 0
        case Node(tag="+" | "*" as tag, outside=parts) if (unit := int(tag == "*")) in parts:
            rest = [part for part in parts if part != unit]
            new = node(tag, *rest) if len(rest) > 1 else rest[0] if rest else unit
        case Node(tag="/", outside=(top, 1)):
            return top
        case Node(tag="sqrt", outside=(int(square),)) if square >= 0 and isqrt(square) ** 2 == square:
            return isqrt(square)
    if isinstance(new, Node) and new.tag in RATIONAL:
        with suppress(Unsupported):
            return number_term(constant(new))
    return new


def _is_long(formula: Formula) -> bool:
    """Whether integrals and sums stand in it, whose digits take long."""
    return any(isinstance(part, Node) and part.bound for part in subterms(formula))


def _holds(formula: Formula, numbers: Numbers) -> bool:
    """Whether digits tell that a formula is true, or algebra that an equation is."""
    if (true := numbers.truth(formula)) is not None or formula.tag != "=":
        return bool(true)
    closed = Problem("", node("=", *map(numbers.number, formula.terms)))
    return prove_identity(closed, ring_of(closed)) is not None


def _shown(claim: Formula, numbers: Numbers) -> Iterator[tuple[Term, Term, Term]]:
    """The numbers that make the claim false, with decimals below and above."""
    false = [compared(relation) for relation in relations(claim) if numbers.truth(relation) is False]
    digits = {pair.term: numbers.ends(pair).digits for pair in false}
    for term, places in digits.items():
        yield term, *between(numbers.number(term), places)
