"""Proofs about matrices of all sizes: what is assumed becomes rules that rewrite products, completed as needed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from itertools import count, islice, product

from symcheck.core.certificates import MatrixProof
from symcheck.core.matrices import FACT, NUMBER, Factor, Matrix, Monomial, Shape, Shapes, Word, flipped, words
from symcheck.core.terms import JSON

LONGEST = 10  # letters of a product of which two leading parts overlap
MOST = 120  # rules: the identities that are printed need a dozen
VALUES = (1, 0, 2, -1, 3)  # of the witness
TRIED = 1000  # choices of them
Step = tuple[Fraction, JSON, JSON]  # a multiple of a term in which `fact` stands for the named fact


@dataclass(frozen=True)
class Statement:
    """What is claimed of matrices of all sizes: terms as in `symcheck.core.matrices`.

    Parameters
    ----------
    shapes
        The numbers of rows and columns of each letter.
    claim
        Both sides of an equation.
    hypotheses
        Equations that are assumed, by name.
    inverses
        The terms of which letters are the inverses.
    """

    shapes: Mapping[str, Shape]
    claim: tuple[JSON, JSON]
    hypotheses: Mapping[str, tuple[JSON, JSON]]
    inverses: Mapping[str, JSON]


@dataclass(frozen=True)
class Rule:
    """A difference that vanishes, its leading product with the coefficient 1, and how it follows from facts."""

    lead: Monomial
    value: Matrix
    steps: tuple[Step, ...]


def proved(statement: Statement) -> MatrixProof | None:
    """The certificate that a claim about matrices of all sizes follows, if a proof is found."""
    search = Search(statement)
    claim = search.of.difference(*statement.claim)
    for _ in search.completed():
        if (steps := search.vanishing(claim)) is not None:
            return search.certificate(steps)
    return None


class Search:
    """The rules of a statement."""

    def __init__(self, statement: Statement) -> None:
        self.statement, self.of = statement, Shapes(statement.shapes)
        self.ranks = {x: k for k, x in enumerate(_definitions(statement.hypotheses))}
        self.rules: list[Rule] = []
        for reference, fact in self.facts():
            self.add(fact, ((Fraction(1), reference, FACT),))
            self.add(self.at(["transpose", FACT], fact), ((Fraction(1), reference, ["transpose", FACT]),))

    def facts(self) -> Iterator[tuple[JSON, Matrix]]:
        """All that is known, with how it is named in a proof."""
        for name, (left, right) in self.statement.hypotheses.items():
            yield ["hypothesis", name], self.of.difference(left, right)
            match left, right:
                case ["*", x, y], ["unit", n] if self.of.value(x).shape == self.of.value(y).shape == (n, n):
                    yield ["turned", name], self.of.difference(["*", y, x], right)
        for name, x in self.statement.inverses.items():
            unit: JSON = ["unit", self.of.value(x).shape[0]]
            yield ["left", name], self.of.difference(["*", name, x], unit)
            yield ["right", name], self.of.difference(["*", x, name], unit)

    def at(self, term: JSON, fact: Matrix) -> Matrix:
        """The value of a term in which a fact stands."""
        return Shapes({**self.of.shapes, FACT: fact.shape}, {FACT: fact}).value(term)

    def add(self, value: Matrix, steps: tuple[Step, ...]) -> None:
        """One more rule, reduced by those that are there."""
        value, more = self.reduced(value)
        if not value.parts:
            return
        lead = max(value.parts, key=self.order)
        c = value.parts[lead]
        steps = tuple((d / c, reference, term) for d, reference, term in (*steps, *more))
        self.rules.append(Rule(lead, Matrix(value.shape, {part: d / c for part, d in value.parts.items()}), steps))

    def order(self, part: Monomial) -> tuple[object, ...]:
        """What is rewritten first: letters that are defined, by letters before them; then what is longer."""
        numbers, word = part
        letters = [letter for _, each in numbers for letter, _ in each] + [letter for letter, _ in word]
        heads = tuple(sorted((self.ranks[x] for x in letters if x in self.ranks), reverse=True))
        return heads, len(letters), word, numbers

    def reduced(self, value: Matrix) -> tuple[Matrix, list[Step]]:
        """What is left when all rules are applied, and what was taken away."""
        steps, done = list[Step](), dict[Monomial, Fraction]()
        value = Matrix(value.shape, {**value.parts})
        while value.parts:
            part = max(value.parts, key=self.order)
            found = next(self.uses(part), None)
            if found is None:
                done[part] = done.get(part, 0) + value.parts.pop(part)
                continue
            rule, term, d = found
            c = -value.parts[part] / d
            taken = self.at(["*", _number(c), term], rule.value)
            value = self.of.plus(value, taken)
            steps += [(c * e, reference, _within(term, inner)) for e, reference, inner in rule.steps]
        return Matrix(value.shape, done), steps

    def uses(self, part: Monomial) -> Iterator[tuple[Rule, JSON, Fraction]]:
        """The rules that make a product less, each with where it stands in it, and how often it is taken away then."""
        for rule in self.rules:
            for term in _places(rule.lead, part):
                taken = self.at(term, rule.value).parts
                if part in taken and max(taken, key=self.order) == part:
                    yield rule, term, taken[part]

    def vanishing(self, claim: Matrix) -> list[Step] | None:
        """How a difference follows from the facts, if the rules show that it does."""
        left, steps = self.reduced(claim)
        return [(-c, reference, term) for c, reference, term in steps] if not left.parts else None

    def completed(self) -> Iterator[int]:
        """Rules are added as two of them apply to one product in different ways; each time it is told."""
        yield len(self.rules)
        for k in count():
            if k >= min(len(self.rules), MOST):
                return
            before = len(self.rules)
            for j in range(k + 1):
                for one, other in ((k, j), (j, k)):
                    self.overlap(self.rules[one], self.rules[other])
            if len(self.rules) > before:
                yield len(self.rules)

    def overlap(self, one: Rule, other: Rule) -> None:
        """The rules that follow where the end of one leading product is the beginning of another or of its numbers."""
        (numbers, word), (others, rest) = one.lead, other.lead
        if numbers or (others and rest):
            return
        for k, (kind, own) in enumerate(others or [("word", rest)]):
            factors = [_factor(each) for j, each in enumerate(others) if j != k]
            for start in dict.fromkeys((own, flipped(own)) if others and kind == "word" else (rest,)):
                for n in range(1, min(len(word), len(start) + bool(others))):
                    if word[-n:] == start[:n] and len(word) + len(start) - n <= LONGEST:
                        self.follow(one, _product(*factors, FACT, *_terms(start[n:])), other, _terms(word[:-n]))

    def follow(self, one: Rule, right: JSON, other: Rule, before: list[JSON]) -> None:
        """One more rule: the difference of what two rules make of one product."""
        left = _product(*before, FACT)
        value = self.of.plus(self.at(right, one.value), self.at(["-", left], other.value))
        steps = [(c, reference, _within(right, term)) for c, reference, term in one.steps]
        steps += [(-c, reference, _within(left, term)) for c, reference, term in other.steps]
        self.add(value, tuple(steps))

    def certificate(self, steps: list[Step]) -> MatrixProof | None:
        """The statement, without what is not used, and its proof; None if there is no witness of what is assumed."""
        used = {str(reference[1]) for _, reference, _ in steps if isinstance(reference, list)}
        statement, total = self.statement, dict[str, tuple[JSON, JSON, Fraction]]()
        hypotheses = {name: both for name, both in statement.hypotheses.items() if name in used}
        printed = words([*statement.claim, *(side for both in hypotheses.values() for side in both)])
        while more := {x for x in statement.inverses if x in printed and not words(statement.inverses[x]) <= printed}:
            printed |= words([statement.inverses[x] for x in more])
        inverses = {x: term for x, term in statement.inverses.items() if x in printed}
        for c, reference, term in steps:
            key = f"{reference} {term}"
            total[key] = reference, term, c + (total[key][2] if key in total else 0)
        shapes = {x: shape for x, shape in statement.shapes.items() if x in printed}
        if (found := _witness(statement)) is None:
            return None
        return {
            "id": "question",
            "verdict": "proved",
            "matrices": {x: [*shape] for x, shape in shapes.items()},
            "hypotheses": {name: [*both] for name, both in hypotheses.items()},
            "inverses": inverses,
            "claim": [*statement.claim],
            "proof": [[reference, ["*", _number(c), term]] for reference, term, c in total.values() if c],
            "witness": {x: [found[x].numerator, found[x].denominator] for x in shapes},
        }


def _definitions(hypotheses: Mapping[str, tuple[JSON, JSON]]) -> dict[str, JSON]:
    """What equations say that letters are, each by letters before it or by others."""
    needs = dict[str, JSON]()
    for left, right in hypotheses.values():
        for head, rest in ((left, right), (right, left)):
            match head:
                case ["-", str(x)]:
                    head, rest = x, ["-", rest]
            if isinstance(head, str) and head not in needs and head not in words(rest):
                needs[head] = rest
                break
    found: dict[str, JSON] = {}
    while ready := [x for x, rest in needs.items() if x not in found and not words(rest) & needs.keys() - found.keys()]:
        found |= {x: needs[x] for x in ready}
    return found


def _places(lead: Monomial, part: Monomial) -> Iterator[JSON]:
    """The terms that put a fact where its leading product stands in another."""
    (inner, small), (numbers, word) = lead, part
    if inner:
        rest = Counter(numbers)
        rest.subtract(inner)
        if min(rest.values()) < 0:
            return
        numbers = tuple(rest.elements())
    for k in _at(small, word) if small or inner else ():
        yield _product(*map(_factor, numbers), *_terms(word[:k]), FACT, *_terms(word[k + len(small) :]))
    if inner:
        return
    for k, (kind, own) in enumerate(numbers):
        others = [_factor(each) for j, each in enumerate(numbers) if j != k]
        ways = [own, flipped(own)] if kind != "size" else []  # a number is its own transpose
        if kind == "trace":
            ways = [(*way[n:], *way[:n]) for way in ways for n in range(len(way))]
        for turned in ways:
            for n in _at(small, turned):
                found = _product(*_terms(turned[:n]), FACT, *_terms(turned[n + len(small) :]))
                yield _product(*others, ["trace", found] if kind == "trace" else found, *_terms(word))


def _at(small: Word, word: Word) -> Iterator[int]:
    n = len(small)
    yield from (k for k in range(len(word) - n + 1) if word[k : k + n] == small) if n else [0]


def _terms(word: Word) -> list[JSON]:
    return [["transpose", letter] if transposed else letter for letter, transposed in word]


def _factor(factor: Factor) -> JSON:
    kind, word = factor
    if kind == "size":
        return ["trace", ["unit", word[0][0]]]
    return ["trace", _product(*_terms(word))] if kind == "trace" else _product(*_terms(word))


def _product(*terms: JSON) -> JSON:
    return ["*", *terms] if len(terms) > 1 else terms[0]


def _number(c: Fraction) -> JSON:
    return ["number", c.numerator, c.denominator]


def _within(term: JSON, inner: JSON) -> JSON:
    """A term with another in the place of its fact."""
    if isinstance(term, list):
        return [_within(each, inner) for each in term]
    return inner if term == FACT else term


def _witness(statement: Statement) -> dict[str, Fraction] | None:
    """Numbers for which all that is assumed is so where all sizes are 1, whether it is used or not."""
    hypotheses, inverses = statement.hypotheses, statement.inverses
    defined, known = {**_definitions(hypotheses), **inverses}, statement.shapes.keys()
    free = [x for x in known if x not in defined]
    for numbers in islice(product(VALUES, repeat=len(free)), TRIED):
        values = {x: Fraction(n) for x, n in zip(free, numbers, strict=True)}
        with suppress(ZeroDivisionError):
            while ready := [x for x in defined if x not in values and words(defined[x]) & known <= values.keys()]:
                found = {x: _number_of(defined[x], values) for x in ready}
                values |= {x: 1 / value if x in inverses else value for x, value in found.items()}
            sides = (["+", left, ["-", right]] for left, right in hypotheses.values())
            if values.keys() == known and not any(_number_of(gap, values) for gap in sides):
                return values
    return None


def _number_of(term: JSON, values: Mapping[str, Fraction]) -> Fraction:
    """The value of a term of numbers where all sizes are 1."""
    numbers = {x: Matrix(NUMBER, {((), ()): value} if value else {}) for x, value in values.items()}
    return Shapes(dict.fromkeys(values, NUMBER), numbers, single=True).value(term).parts.get(((), ()), Fraction())
