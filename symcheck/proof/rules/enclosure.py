"""Statements about numbers alone, such as 1.9505 <= 4 sin a sin b where a is 67 degrees: proved by their digits.

A letter is a number if a definition or a hypothesis `letter = number` says so. Numbers that differ by more than 10^-30
are told apart with the theorem `enclosure`. Rational numbers, and those that may be equal, are left to algebra.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from symcheck.checker.enclosures import FUNCTIONS, between
from symcheck.core.calculus import Unknown, letters, nodes, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import PI, RELATIONS, Connective, Formula, Node, Term, Value, node
from symcheck.proof.algebra.facts import NOTHING, Assumed, Hypothesis, Positive, Signed
from symcheck.proof.algebra.forms import number_term
from symcheck.proof.algebra.knowledge import ORDERS, stated
from symcheck.proof.algebra.polynomial import Unsupported, constant, subterms, unfold
from symcheck.proof.rules.absurd import Absurd
from symcheck.proof.rules.each import Each
from symcheck.proof.rules.identity import Identity
from symcheck.proof.rules.implies import Implies
from symcheck.proof.rules.nonnegative import Nonnegative
from symcheck.proof.rules.proof import Proof
from symcheck.proof.rules.step import Cofactor, Step, Whole
from symcheck.proof.rules.theorem import enclosure

DIGITS = (6, 12, 20, 30)  # as few as tell two numbers apart
SIGNS = {"=": {0}, "!=": {-1, 1}, "<": {-1}, "<=": {-1, 0}, ">": {1}, ">=": {0, 1}}  # of left - right
_EXACT = ("+", "*", "-", "/", "^", "sqrt")
IRRATIONAL = FUNCTIONS.keys() - {"-"} | {"pow", "integral", "sum", "product", "diff"}


class Compared(NamedTuple):
    """left - right of a relation as sign * (term - bound), the bound a rational number."""

    term: Term
    bound: Fraction
    sign: int


class Ends(NamedTuple):
    """Decimals not above and not below a number, with so many digits."""

    digits: int
    low: Fraction
    high: Fraction

    def side(self, bound: Fraction) -> int | None:
        """1 if the number is above the bound, -1 if below, 0 if it is the bound, None if that cannot be told."""
        if self.low == self.high == bound:
            return 0
        return 1 if self.low > bound else -1 if self.high < bound else None


@dataclass(frozen=True)
class Numbers:
    """The letters of a problem that are numbers: what they stand for, and the hypotheses that say so."""

    definitions: dict[str, Term]
    letters: dict[str, Term]
    sources: dict[str, tuple[Hypothesis, int]]  # a reference, and 1 or -1 for `number = letter`

    @classmethod
    def of(cls, problem: Problem, chosen: Mapping[str, Term] | None = None) -> Numbers | None:
        """The letters chosen and those that the problem fixes; None if the claim is about others too."""
        found = cls(dict(problem.definitions), dict(chosen or {}), {})
        equations = [(ref, formula.terms) for ref, formula in stated(problem) if formula.tag == "="]
        fixable = {side for _, sides in equations for side in sides if isinstance(side, str)}
        met = letters(problem.claim)
        if not met <= {*found.letters, *found.definitions, *fixable}:
            return None
        for _ in equations:  # one may be said in terms of another
            for ref, (left, right) in equations:
                found.learn(left, right, (ref, 1))
                found.learn(right, left, (ref, -1))
        return found if found.closed(problem.claim) and (chosen or not found.rational(problem.claim)) else None

    def learn(self, letter: Term, number: Term, source: tuple[Hypothesis, int]) -> None:
        """One equation, if it says of a letter what number it is."""
        free = isinstance(letter, str) and letter not in {*self.letters, *self.definitions}
        if free and self.names(number) <= self.letters.keys():
            self.letters[str(letter)], self.sources[str(letter)] = number, source

    def rational(self, tree: Term) -> bool:
        """Whether no function and no pi occurs."""
        parts = [*subterms(tree)]
        if any(part == PI or (isinstance(part, Node) and part.tag in IRRATIONAL) for part in parts):
            return False
        return all(self.rational(self.meaning(name)) for name in letters(tree))

    def closed(self, formula: Formula) -> bool:
        """Whether a formula speaks of numbers only."""
        return formula.tag != "exists" and self.names(formula) <= self.letters.keys()

    def names(self, tree: Term) -> set[str]:
        """The letters that a term or formula depends on, definitions unfolded."""
        return letters(unfold(tree, self.definitions))

    def number(self, term: Term) -> Term:
        """The number that a term is, as a term without letters."""
        plain = unfold(term, self.definitions)
        while used := letters(plain) & self.letters.keys():
            plain = substituted(plain, {x: unfold(self.letters[x], self.definitions) for x in used})
        return plain

    def meaning(self, name: str) -> Term:
        """What a letter stands for."""
        return self.letters[name] if name in self.letters else self.definitions[name]

    def ends(self, pair: Compared) -> Ends:
        """Decimals of the term, as few digits as tell it from the bound, or the most there are."""
        number = self.number(pair.term)
        if any(
            part.tag == "integral" for whole in nodes(number) if whole.tag == "integral" for part in nodes(*whole[1:])
        ):
            raise Unknown("the digits of an integral in an integral, which take seconds")
        for digits in DIGITS:
            low, high = map(constant, between(number, digits))
            found = Ends(digits, low, high)
            if found.side(pair.bound) is not None:
                break
        return found

    def used(self, term: Term) -> list[str]:
        """The letters that a term depends on, also through those."""
        open_, found = [*self.names(term)], set[str]()
        while open_:
            if (name := open_.pop()) in self.letters and name not in found:
                found.add(name)
                open_ += self.names(self.letters[name])
        return sorted(found)

    def truth(self, formula: Formula) -> bool | None:
        """Whether a formula is true, by digits; None if they do not tell."""
        kind = formula.tag
        if kind in RELATIONS:
            pair = compared(formula)
            side = self.ends(pair).side(pair.bound)
            return None if side is None else pair.sign * side in SIGNS[kind]
        if not isinstance(formula, Connective):
            return None
        known = [self.truth(part) for part in formula.formulas]
        if kind == "=>":
            known, kind = [None if known[0] is None else not known[0], known[1]], "or"
        if kind == "<=>":
            return None if None in known else known[0] == known[1]
        decisive = kind == "or"
        return decisive if decisive in known else None if None in known else not decisive


def compared(relation: Formula) -> Compared:
    """What is compared with what: a number with a rational one where there is one, else the difference with 0."""
    left, right = relation.terms
    if (bound := _rational(left)) is not None:
        return Compared(right, bound, -1)
    if (bound := _rational(right)) is not None:
        return Compared(left, bound, 1)
    return Compared(node("+", left, node("-", right)), Fraction(0), 1)


def _rational(term: Term) -> Fraction | None:
    try:
        return constant(term)
    except Unsupported:
        return None


def relations(formula: Formula) -> Iterator[Formula]:
    """The relations in a formula without quantifiers."""
    if formula.tag in RELATIONS:
        yield formula
    for part in formula.formulas:
        yield from relations(part)


def prove_numbers(problem: Problem) -> Proof | None:
    """All numbers are enclosed first, then every relation follows; None where digits do not tell."""
    try:
        numbers = Numbers.of(problem)
        return _proved(problem.claim, numbers) if numbers is not None and numbers.truth(problem.claim) else None
    except (Unknown, Unsupported, RecursionError):
        return None


def order_of_numbers(goal: Formula, definitions: Mapping[str, Term]) -> Step | None:
    """The proof of an order of numbers inside a larger proof, or None."""
    if goal.tag not in ORDERS:
        return None
    proof = prove_numbers(Problem("", goal, tuple(definitions.items())))
    return None if proof is None else proof.step.step


def _proved(claim: Formula, numbers: Numbers) -> Proof | None:
    ends: dict[Term, Ends] = {}
    for term, bound, sign in map(compared, relations(claim)):
        found = numbers.ends(Compared(term, bound, sign))
        ends[term] = max(found, ends.get(term, found))
    proof = _closing(claim, ends, 2 * len(ends))
    if proof is None:
        return None
    for term, end in reversed(ends.items()):
        values = {x: numbers.letters[x] for x in numbers.used(term)}
        proof = enclosure(term, end.digits, values).step([_premise(*numbers.sources[x]) for x in values], proof)
    used = sorted({x for term in ends for x in numbers.used(term)})
    terms = (*ends, *(numbers.letters[x] for x in used))
    divisors = dict.fromkeys(divisor for term in terms for divisor in _divisors(term, numbers.definitions))
    return Proof(
        Whole(proof),
        frozenset(numbers.sources[x][0] for x in used),
        tuple(_nonzero(divisors, numbers.definitions)),
    )


def _premise(source: Hypothesis, sign: int) -> Identity:
    return Identity((), (Cofactor(source, (str(sign),)),))


def _closing(goal: Formula, ends: Mapping[Term, Ends], assumed: int) -> Step | None:
    """The proof where all numbers are enclosed; so many assumptions are in force."""
    if goal.tag == "and":
        parts = [_closing(part, ends, assumed) for part in goal.formulas]
        proofs = tuple(part for part in parts if part is not None)
        return Each(proofs) if len(proofs) == len(parts) else None
    if goal.tag not in RELATIONS:
        return None
    term, bound, sign = compared(goal)
    digits, low, high = ends[term]
    side = ends[term].side(bound)
    if not side:
        return None
    above = side > 0
    unit = 10**digits
    end: Term = node("/", int((low if above else high) * unit), unit)
    inner: Term = node("+", term, node("-", end)) if above else node("+", end, node("-", term))
    form = node("+", inner, number_term(low - bound if above else bound - high))
    if goal.tag != "!=":
        return Nonnegative(Signed(form, NOTHING))
    equal = Cofactor(Assumed(assumed), (str(sign if above else -sign),))  # that both sides are
    return Implies(Absurd((Positive(form, NOTHING),), (equal,)))


def _nonzero(divisors: Iterable[Term], definitions: Mapping[str, Term]) -> Iterator[Term]:
    """What the statement divides by as far as algebra does not tell that it is not zero: letters come last."""
    named: dict[str, Term] = {}
    for k, divisor in enumerate(d for d in divisors if not _is_exact(unfold(d, definitions))):
        plain = isinstance(divisor, str) and divisor not in definitions
        named[str(divisor) if plain else f"Divisor_{k + 1}"] = divisor
    for name in sorted(named):
        yield named[name]


def _is_exact(number: Term) -> bool:
    """Whether a term is made of whole numbers and roots, so that algebra tells whether it is zero."""
    return all(isinstance(part, int) or (isinstance(part, Node) and part.tag in _EXACT) for part in subterms(number))


def _divisors(term: Term, definitions: Mapping[str, Term]) -> Iterator[Term]:
    """What a term divides by, factor by factor, as the checker meets it."""
    if isinstance(term, str) and term in definitions:
        yield from _divisors(definitions[term], definitions)
    if not isinstance(term, Node):
        return
    match term:
        case Value(tag="/", terms=(_, bottom)):
            yield from _factors(bottom)
        case Value(tag="^", terms=(base, int(n))) if n < 0:
            yield from _factors(base)
        case Value(tag="tan", terms=(inner,)):
            yield node("cos", inner)
    for part in term.outside:
        yield from _divisors(part, definitions)


def _factors(term: Term) -> Iterator[Term]:
    match term:
        case Value(tag="*", terms=parts):
            for part in parts:
                yield from _factors(part)
        case Value(tag="^", terms=(base, int(n))) if n > 0:
            yield from _factors(base)
        case _:
            yield term
