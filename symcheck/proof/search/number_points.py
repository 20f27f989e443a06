"""Counterexamples among numbers, told by their digits: at the numbers that letters are, or at a few values of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import product

from symcheck.checker.enclosures import between
from symcheck.core.calculus import Unknown, letters
from symcheck.core.problems import Problem
from symcheck.core.terms import Formula, Node, Term, node
from symcheck.proof.algebra.knowledge import formulas_of, stated
from symcheck.proof.algebra.polynomial import Unsupported, subterms, unfold
from symcheck.proof.rules.compute import Point
from symcheck.proof.rules.enclosure import IRRATIONAL, Numbers, compared, relations

# numbers on both sides of those that are compared in most statements
TRIED: tuple[Term, ...] = (1, node("/", 1, 2), node("/", 3, 2), node("/", 1, 4), node("/", 5, 4), 2, 0, node("-", 1), 3)
TRIES = 80  # points, each with a proof by digits, some seconds in all: the papers need 36


def refute_numbers(problem: Problem) -> Point | None:
    """The point of the numbers, where every hypothesis is true and the claim is not, or None."""
    return refute_at(problem, {})


def refute_at_some(problem: Problem) -> Point | None:
    """The same where one to three letters are free: a few values of them are tried."""
    definitions = dict(problem.definitions)
    formulas = formulas_of(problem)
    if not any(part.tag in IRRATIONAL for part in subterms(*formulas) if isinstance(part, Node)):
        return None
    free = sorted(set().union(*(letters(unfold(formula, definitions)) for formula in formulas)))
    fixed = {side for formula in formulas[1:] if formula.tag == "=" for side in formula.terms if isinstance(side, str)}
    chosen = [x for x in free if x not in fixed]
    values = sorted(product(range(len(TRIED)), repeat=len(chosen)), key=sum) if 0 < len(chosen) < 4 else []
    return refute_at_first(problem, ({x: TRIED[k] for x, k in zip(chosen, ks, strict=True)} for ks in values[:TRIES]))


def refute_at_first(problem: Problem, points: Iterable[Mapping[str, Term]]) -> Point | None:
    """The same at the first of many points that refutes the problem; definitions are unfolded once for all of them."""
    definitions = dict(problem.definitions)
    hypotheses = tuple((name, tuple(unfold(f, definitions) for f in formulas)) for name, formulas in problem.hypotheses)
    plain = replace(problem, claim=unfold(problem.claim, definitions), definitions=(), hypotheses=hypotheses)
    first = next((point for point in points if refute_at(plain, point) is not None), None)
    return None if first is None else refute_at(problem, first)


def refute_at(problem: Problem, chosen: Mapping[str, Term]) -> Point | None:
    """The same at one point."""
    try:
        numbers = Numbers.of(problem, chosen)
        if numbers is None or numbers.truth(problem.claim) is not False:
            return None
        sources = [source for source, _ in numbers.sources.values()]
        if not all(ref in sources or (numbers.closed(f) and numbers.truth(f)) for ref, f in stated(problem)):
            return None
        values = {name: unfold(number, dict(problem.definitions)) for name, number in numbers.letters.items()}
        return Point(values, enclosed=tuple(_shown(problem.claim, numbers)))
    except (Unknown, Unsupported, RecursionError):
        return None


def _shown(claim: Formula, numbers: Numbers) -> Iterator[tuple[Term, Term, Term]]:
    """The numbers that make the claim false, with decimals below and above."""
    false = [compared(relation) for relation in relations(claim) if numbers.truth(relation) is False]
    digits = {pair.term: numbers.ends(pair).digits for pair in false}
    for term, places in digits.items():
        yield term, *between(numbers.number(term), places)
