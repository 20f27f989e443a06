"""Statements about numbers alone, such as 1.9505 <= 4 sin a sin b where a is 67 degrees: decided by their digits.

A letter is a number if a definition or a hypothesis `letter = number` says so. Numbers that differ by more than 10^-30
are told apart with the theorem `enclosure`, or at the point of those numbers. Rational numbers, and those that may be
equal, are left to algebra.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product
from typing import Any, NamedTuple

from symcheck.checker.enclosures import FUNCTIONS, between
from symcheck.core.calculus import Unknown, letters
from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Outcome, Problem
from symcheck.core.terms import PI, RELATIONS, Connective, Formula, Node, Term, node
from symcheck.core.verdicts import Certificate, Verdict
from symcheck.proof.applied import enclosure, step
from symcheck.proof.orders import number_term
from symcheck.proof.polynomial import Unsupported, constant, subterms, unfold

DIGITS = (6, 12, 20, 30)  # as few as tell two numbers apart
SIGNS = {"=": {0}, "!=": {-1, 1}, "<": {-1}, "<=": {-1, 0}, ">": {1}, ">=": {0, 1}}  # of left - right
TRIED: tuple[Term, ...] = (1, node("/", 1, 2), node("/", 3, 2), node("/", 1, 4), node("/", 5, 4), 2, 0, node("-", 1), 3)
TRIES = 80
_EXACT = ("+", "*", "-", "/", "^", "sqrt")
_IRRATIONAL = FUNCTIONS.keys() - {"-"} | {"pow", "integral", "sum", "product", "diff"}


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
    sources: dict[str, tuple[list[Any], int]]  # a reference, and 1 or -1 for `number = letter`

    @classmethod
    def of(cls, problem: Problem, chosen: Mapping[str, Term] | None = None) -> Numbers | None:
        """Beside the letters chosen, those that the problem fixes; None if the claim is about others too."""
        found = cls(dict(problem.definitions), dict(chosen or {}), {})
        stated = [(ref, formula) for ref, formula in _stated(problem) if formula[0] == "="]
        fixable = {side for _, formula in stated for side in formula[1:] if isinstance(side, str)}
        met = {part for part in subterms(problem.claim) if isinstance(part, str)}
        if not met <= {*found.letters, *found.definitions, *fixable}:
            return None
        for _ in stated:  # one may be said in terms of another
            for ref, (_, left, right) in stated:
                found.learn(left, right, (ref, 1))
                found.learn(right, left, (ref, -1))
        return found if found.closed(problem.claim) and (chosen or not found.rational(problem.claim)) else None

    def learn(self, letter: Term, number: Term, source: tuple[list[Any], int]) -> None:
        """One equation, if it says of a letter what number it is."""
        free = isinstance(letter, str) and letter not in {*self.letters, *self.definitions}
        if free and self.names(number) <= self.letters.keys():
            self.letters[str(letter)], self.sources[str(letter)] = number, source

    def rational(self, tree: Any) -> bool:
        """Whether no function and no pi occurs."""
        parts = [*subterms(tree)]
        if any(part == PI or (isinstance(part, Node) and part.tag in _IRRATIONAL) for part in parts):
            return False
        return all(self.rational(self.meaning(part)) for part in parts if isinstance(part, str))

    def closed(self, formula: Formula) -> bool:
        """Whether a formula speaks of numbers only."""
        return formula.tag != "exists" and self.names(formula) <= self.letters.keys()

    def names(self, tree: Term) -> set[str]:
        """The letters that a term or formula depends on, definitions unfolded."""
        return letters(unfold(tree, self.definitions))

    def number(self, term: Term) -> Term:
        """The number that a term is, as a term without letters."""
        return unfold(term, {**self.definitions, **self.letters})

    def meaning(self, name: str) -> Term:
        """What a letter stands for."""
        return self.letters[name] if name in self.letters else self.definitions[name]

    def ends(self, compared: Compared) -> Ends:
        """Decimals of the term, as few digits as tell it from the bound, or the most there are."""
        for digits in DIGITS:
            low, high = map(constant, between(self.number(compared.term), digits))
            found = Ends(digits, low, high)
            if found.side(compared.bound) is not None:
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
            compared = _compared(formula)
            side = self.ends(compared).side(compared.bound)
            return None if side is None else compared.sign * side in SIGNS[kind]
        if not isinstance(formula, Connective):
            return None
        known = [self.truth(part) for part in formula.formulas]
        if kind == "=>":
            known, kind = [None if known[0] is None else not known[0], known[1]], "or"
        if kind == "<=>":
            return None if None in known else known[0] == known[1]
        decisive = kind == "or"
        return decisive if decisive in known else None if None in known else not decisive


def decide_numbers(problem: Problem) -> Outcome | None:
    """Proved or refuted by digits, or None."""
    if (point := refute_numbers(problem)) is not None:
        return Outcome(Verdict.REFUTED, point=point, used=tuple(name for name, _ in problem.hypotheses))
    try:
        numbers = Numbers.of(problem)
        return None if numbers is None else _proved(problem, numbers)
    except (Unknown, Unsupported, RecursionError):
        return None


def refute_numbers(problem: Problem) -> Certificate | None:
    """The point of the numbers, where every hypothesis is true and the claim is not, or None."""
    return refute_at(problem, {})


def refute_at_some(problem: Problem) -> Certificate | None:
    """The same where one to three letters are free: a few values of them are tried."""
    definitions = dict(problem.definitions)
    formulas = [problem.claim, *(formula for _, formula in _stated(problem))]
    if not any(part.tag in _IRRATIONAL for part in subterms(*formulas) if isinstance(part, Node)):
        return None
    free = sorted(set().union(*(letters(unfold(formula, definitions)) for formula in formulas)))
    fixed = {side for f in formulas[1:] if f[0] == "=" for side in f[1:] if isinstance(side, str)}
    chosen = [x for x in free if x not in fixed]
    values = sorted(product(range(len(TRIED)), repeat=len(chosen)), key=sum) if 0 < len(chosen) < 4 else []
    return refute_at_first(problem, ({x: TRIED[k] for x, k in zip(chosen, ks, strict=True)} for ks in values[:TRIES]))


def refute_at_first(problem: Problem, points: Iterable[Mapping[str, Term]]) -> Certificate | None:
    """The same at the first of many points that refutes the problem; definitions are unfolded once for all of them."""
    definitions = dict(problem.definitions)
    hypotheses = tuple((name, tuple(unfold(f, definitions) for f in formulas)) for name, formulas in problem.hypotheses)
    plain = replace(problem, claim=unfold(problem.claim, definitions), definitions=(), hypotheses=hypotheses)
    found = next((point for point in points if refute_at(plain, point) is not None), None)
    return None if found is None else refute_at(problem, found)


def refute_at(problem: Problem, chosen: Mapping[str, Term]) -> Certificate | None:
    """The same at one point."""
    try:
        numbers = Numbers.of(problem, chosen)
        if numbers is None or numbers.truth(problem.claim) is not False:
            return None
        sources = [source for source, _ in numbers.sources.values()]
        if not all(ref in sources or (numbers.closed(f) and numbers.truth(f)) for ref, f in _stated(problem)):
            return None
        values = {name: unfold(number, dict(problem.definitions)) for name, number in numbers.letters.items()}
        return {"values": values, "enclosed": [*_shown(problem.claim, numbers)]}
    except (Unknown, Unsupported, RecursionError):
        return None


def _stated(problem: Problem) -> list[tuple[list[Any], Formula]]:
    """Every hypothesis with its reference."""
    parts = ((name, [part for f in formulas for part in conjuncts(f)]) for name, formulas in problem.hypotheses)
    return [(["hyp", name, k], formula) for name, formulas in parts for k, formula in enumerate(formulas)]


def _compared(goal: Formula) -> Compared:
    """What is compared with what: a number with a rational one where there is one, else the difference with 0."""
    left, right = (_rational(side) for side in goal[1:])
    if left is not None:
        return Compared(goal[2], left, -1)
    return (
        Compared(node("+", goal[1], node("-", goal[2])), Fraction(0), 1)
        if right is None
        else Compared(goal[1], right, 1)
    )


def _rational(term: Term) -> Fraction | None:
    try:
        return constant(term)
    except Unsupported:
        return None


def _relations(formula: Formula) -> Iterator[Formula]:
    if formula[0] in RELATIONS:
        yield formula
    else:
        for part in formula.formulas:
            yield from _relations(part)


def _shown(claim: Formula, numbers: Numbers) -> Iterator[list[Any]]:
    """The numbers that make the claim false, with their digits."""
    false = [_compared(relation) for relation in _relations(claim) if numbers.truth(relation) is False]
    digits = {compared.term: numbers.ends(compared).digits for compared in false}
    for term, places in digits.items():
        yield [term, places, *between(numbers.number(term), places)]


# --- proofs


def order_of_numbers(goal: Formula, definitions: Mapping[str, Term]) -> Certificate | None:
    """The proof of an order of numbers inside a larger proof, or None."""
    found = decide_numbers(Problem("", goal, tuple(definitions.items()))) if goal[0] in RELATIONS else None
    proof = found.proof if found and found.proof and goal[0] not in ("=", "!=") else None
    return proof and {key: part for key, part in proof.items() if key in ("rule", "of", "premises", "then")}


def _proved(problem: Problem, numbers: Numbers) -> Outcome | None:
    """All numbers are enclosed first, then every relation follows."""
    if not numbers.truth(problem.claim):
        return None
    ends: dict[Term, Ends] = {}
    for compared in map(_compared, _relations(problem.claim)):
        found = numbers.ends(compared)
        ends[compared.term] = max(found, ends.get(compared.term, found))
    proof = _closing(problem.claim, ends, 2 * len(ends))
    if proof is None:
        return None
    for term, end in reversed(ends.items()):
        of = enclosure(term, end.digits, {x: numbers.letters[x] for x in numbers.used(term)})
        premises = [_premise(*numbers.sources[x]) for x in numbers.used(term)]
        proof = step(of, premises, proof)
    used = sorted({x for term in ends for x in numbers.used(term)})
    given = sorted(numbers.sources[x][0][1:] for x in used)
    divisors = dict.fromkeys(
        d for t in (*ends, *(numbers.letters[x] for x in used)) for d in _divisors(t, numbers.definitions)
    )
    proof = {**proof, "given": given, **_nonzero(divisors, numbers.definitions)}
    names = {name for name, _ in given}
    return Outcome(Verdict.PROVED, proof=proof, used=tuple(name for name, _ in problem.hypotheses if name in names))


def _premise(source: list[Any], sign: int) -> Certificate:
    return {"rule": "identity", "cofactors": [[source, str(sign)]]}


def _closing(goal: Formula, ends: Mapping[Term, Ends], assumed: int) -> Certificate | None:
    """The proof where all numbers are enclosed; so many assumptions are in force."""
    kind = goal[0]
    if kind == "and":
        parts = [_closing(part, ends, assumed) for part in goal.formulas]
        return None if None in parts else {"rule": "each", "parts": parts}
    if kind not in RELATIONS:
        return None
    term, bound, sign = _compared(goal)
    _, low, high = ends[term]
    side = ends[term].side(bound)
    if not side:
        return None
    above = side > 0
    unit = 10 ** ends[term].digits
    end: Term = node("/", int((low if above else high) * unit), unit)
    inner: Term = node("+", term, node("-", end)) if above else node("+", end, node("-", term))
    form = node("+", inner, number_term(low - bound if above else bound - high))
    if kind != "!=":
        return {"rule": "nonnegative", "form": form, "cofactors": []}
    cofactor = [["here", assumed], str(sign if above else -sign)]  # that both sides are equal
    absurd = {"rule": "absurd", "times": [["positive", form]], "cofactors": [cofactor]}
    return {"rule": "implies", "then": absurd}


def _nonzero(divisors: Iterable[Term], definitions: Mapping[str, Term]) -> Certificate:
    """What the statement divides by is listed with its proof, each as a letter that stands for it."""
    texts: dict[str, Term] = {}
    for k, divisor in enumerate(d for d in divisors if not _is_exact(unfold(d, definitions))):
        plain = isinstance(divisor, str) and divisor not in definitions
        texts[str(divisor) if plain else f"Divisor_{k + 1}"] = divisor
    atoms = {text: divisor for text, divisor in texts.items() if text != divisor}
    return {"nonzero": [[text] for text in sorted(texts)], **({"atoms": atoms} if atoms else {})} if texts else {}


def _is_exact(number: Term) -> bool:
    """Whether a term is made of whole numbers and roots, so that algebra tells whether it is zero."""
    return all(isinstance(part, int) or (isinstance(part, Node) and part.tag in _EXACT) for part in subterms(number))


def _divisors(term: Any, definitions: Mapping[str, Term]) -> Iterator[Term]:
    """What a term divides by, factor by factor, as the checker meets it."""
    if isinstance(term, str) and term in definitions:
        yield from _divisors(definitions[term], definitions)
    if not isinstance(term, Node):
        return
    match term:
        case ("/", _, bottom):
            yield from _factors(bottom)
        case ("^", base, int(n)) if n < 0:
            yield from _factors(base)
        case ("tan", inner):
            yield node("cos", inner)
    for part in term.outside:
        yield from _divisors(part, definitions)


def _factors(term: Any) -> Iterator[Term]:
    match term:
        case ("*", *parts):
            for part in parts:
                yield from _factors(part)
        case ("^", base, int(n)) if n > 0:
            yield from _factors(base)
        case _:
            yield term
