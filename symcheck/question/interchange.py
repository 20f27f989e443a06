"""Sums of sequences of which nothing is said, by the coefficients of their members, double sums in the other order.

With all members of a sequence u on both sides, one sum over j of c(j) u(j) is another one if c(j) is the same for each
j, with an end or without. A finite sum over i of one over j, of what has u(j) for a factor, is the sum over j of u(j)
times one over i: with j from a to b, or from i to b, or from a to i. What is left to trust is that finite sums may be
taken in any order, and that a binomial coefficient is 0 where its lower number is above the upper one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import NamedTuple

from symcheck.core.calculus import domain, functions, letters, nodes, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import INFINITY, Binder, Call, End, Node, T, Term, mapped, node
from symcheck.question.hypergeometric import worked_out
from symcheck.question.prepare import DEFINED
from symcheck.question.series import FAULTS
from symcheck.reading import to_sympy

LETTER = "place"  # of a member in its sequence
MEMBERS = 4  # the first ones of a sequence, each tried alone: most false series have another addend at one of them


@dataclass(frozen=True)
class Coefficients:
    """The claims that members of sequences have the same coefficients on both sides, at each place.

    Parameters
    ----------
    of
        For each sequence the claim where the place is between the ends, and that for all places from the first one on.
    letter
        The letter of the place, a whole number.
    """

    of: tuple[tuple[Problem, Problem], ...]
    letter: str


class _Part(NamedTuple):
    """A sum of the members of a sequence at `k`, from `low` to `high`, each times a coefficient."""

    sequence: str
    k: str
    low: Term
    high: Term
    coefficient: Term


class _OtherForm(Exception):
    pass


def coefficients(problem: Problem) -> Coefficients | None:
    """The claims about coefficients; None if the claim is none about sums of sequences, or something is said of one."""
    claim = problem.claim
    said = [*(f for _, fs in problem.hypotheses for f in fs), *(t for _, t in problem.definitions)]
    unknown = functions(claim)
    if claim.tag != "=" or not unknown or any(functions(tree) for tree in said):
        return None
    try:
        sides = [list(_parts(side, 1)) for side in claim.terms]
    except _OtherForm:
        return None
    place = LETTER
    while place in letters(claim).union(*map(letters, said)):
        place += "_"
    found = list[tuple[Problem, Problem]]()
    for sequence in sorted(unknown):
        own = [[part for part in side if part.sequence == sequence] for side in sides]
        ranges = {(part.low, part.high) for side in own for part in side}
        if len(ranges) != 1:
            return None
        ((low, high),) = ranges
        left, right = ([substituted(part.coefficient, {part.k: place}) for part in side] for side in own)
        same = node("=", *(node("+", *side) if len(side) > 1 else side[0] if side else 0 for side in (left, right)))
        kept = [each for each in problem.hypotheses if each[0] != DEFINED]
        first = ("place", (node(">=", place, low),))
        valued = (DEFINED, tuple(each for each in domain(same, divisors=True) if letters(each)))
        beside = ("end", () if isinstance(high, End) else (node("<=", place, high),))
        found.append(
            tuple(  # type: ignore[arg-type]
                replace(problem, claim=same, hypotheses=tuple((name, fs) for name, fs in given if fs))
                for given in ((*kept, first, beside, valued), (*kept, first, valued))
            )
        )
    return Coefficients(tuple(found), place)


def _parts(term: Term, factor: Term) -> Iterator[_Part]:
    """The sums of members of sequences of which a term is made."""
    for outside, inner in _addends(term, factor):
        match inner:
            case 0:
                continue
            case Binder(tag="sum"):
                yield from (part._replace(coefficient=_times(outside, part.coefficient)) for part in _of_sum(inner))
            case _:
                raise _OtherForm


def _of_sum(total: Binder) -> Iterator[_Part]:
    """The same of a finite sum of members, or of sums of them."""
    i, (low, high) = total.letter, total.outside
    if isinstance(low, End):
        raise _OtherForm
    for factor, inner in _addends(total.body, 1):
        match inner:
            case Call(function=name, orders=(0,), terms=(at,)) if at == i:
                yield _Part(name, i, low, high, factor)
            case Binder(tag="sum") if not isinstance(high, End):
                for part in _of_sum(inner):
                    yield _turned(part, factor, i, low, high)
            case _:
                raise _OtherForm


def _addends(term: Term, factor: Term) -> Iterator[tuple[Term, Term]]:
    match term:
        case Node(tag="+", outside=addends):
            for addend in addends:
                yield from _addends(addend, factor)
        case Node(tag="-", outside=(inner,)):
            yield from _addends(inner, _times(-1, factor))
        case Node(tag="*", outside=factors):
            inner, rest = _apart(factors)
            yield from _addends(inner, _times(rest, factor))
        case Node(tag="/", outside=(top, bottom)) if not functions(bottom):
            yield from _addends(top, node("/", factor, bottom))
        case _:
            yield factor, term


def _apart(factors: tuple[Term, ...]) -> tuple[Term, Term]:
    """The factor with a sequence, and the product of the others."""
    own = [each for each in factors if functions(each)]
    if len(own) != 1:
        raise _OtherForm
    return own[0], _times(*(each for each in factors if each is not own[0]))


def _times(*factors: Term) -> Term:
    several = [each for each in factors if each != 1]
    return node("*", *several) if len(several) > 1 else several[0] if several else 1


def _turned(part: _Part, factor: Term, i: str, low: Term, high: Term) -> _Part:
    """A sum over i, from one end to the other, of sums over another letter, as one over that letter of sums over i."""
    k, body = part.k, _times(factor, part.coefficient)
    if isinstance(part.high, End) or i == k or k in letters(low) | letters(high):
        raise _OtherForm
    ends = letters(part.low) | letters(part.high)
    if i not in ends:
        last = k if part.high == high and _is_binomial(body, k, i) else high
        return part._replace(coefficient=node("sum", body, i, low, last))
    if part.low == i and part.high == high:
        return part._replace(low=low, coefficient=node("sum", body, i, low, k))
    if part.high == i and part.low == low:
        return part._replace(high=high, coefficient=node("sum", body, i, k, high))
    raise _OtherForm


def _is_binomial(body: Term, n: str, k: str) -> bool:
    """Does a binomial coefficient of n over k stand in it as a factor, which is 0 where k is above n?"""
    match body:
        case Node(tag="*", outside=factors):
            return any(_is_binomial(each, n, k) for each in factors)
        case Node(tag="/", outside=(Node(tag="gamma", outside=(top,)), Node(tag="*", outside=(one, other)))):
            expected = [node("+", n, 1), node("+", k, 1), node("+", n, node("-", k), 1)]
            printed = [each.outside[0] for each in (one, other) if isinstance(each, Node) and each.tag == "gamma"]
            with suppress(*FAULTS):
                return [to_sympy(each) for each in (top, *printed)] == [to_sympy(each) for each in expected]
    return False


def with_one_member(problem: Problem) -> Iterator[tuple[Mapping[str, str], Problem]]:
    """The problem with sequences of which one member is 1 and all others are 0, in sums without an end, and these."""
    claim = problem.claim
    said = [*(f for _, fs in problem.hypotheses for f in fs), *(t for _, t in problem.definitions)]
    unknown = functions(claim)
    if len(unknown) != 1 or any(functions(tree) for tree in said):
        return
    (name,) = unknown
    for m in range(MEMBERS):
        with suppress(_OtherForm):
            there = worked_out(_with_member(claim, name, m))
            yield {f"{name}_n": f"1 for n = {m}, 0 for others"}, replace(problem, claim=there)


def _with_member(tree: T, name: str, m: int) -> T:
    """The same where a sequence has the member m alone, which is 1: of each sum one addend is left."""
    if not isinstance(tree, Node) or name not in functions(tree):
        return tree
    match tree:
        case Binder(tag="sum", outside=(int(low), high)) if high == INFINITY:
            ((factor, inner),) = list(_addends(tree.body, 1))[:2]
            match inner:
                case Call(function=own, orders=(0,), terms=(at,)) if own == name and at == tree.letter:
                    return substituted(factor, {tree.letter: m}) if m >= low else 0  # type: ignore[return-value]
            raise _OtherForm
        case Call() | Binder():
            raise _OtherForm
    return mapped(tree, lambda part: _with_member(part, name, m))  # type: ignore[return-value]


def has_sum(problem: Problem) -> bool:
    """Does a sum stand in the claim?"""
    return any(part.tag == "sum" for part in nodes(problem.claim))
