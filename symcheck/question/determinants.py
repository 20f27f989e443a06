"""Determinants in statements about matrices of all sizes, by their laws: each becomes an expression of numbers.

That of a product is the product of those of its factors, that of a transpose is the same, and that of an inverse is the
inverse number. That of A + W is that of A times that of the unit plus A^{-1} W; and the unit plus a product has the
same determinant whichever of its factors comes first, so that of the unit plus u v^T is the number 1 + v^T u.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from fractions import Fraction

from symcheck.core.matrices import NUMBER, Factor, Monomial, Shape, Shapes, Word, flipped
from symcheck.core.terms import JSON, Malformed
from symcheck.core.verdicts import NoForm

DET = "det"  # the tag of a determinant, which no certificate knows
ONE: JSON = ["number", 1, 1]


@dataclass
class Determinants:
    """What is known of the letters of a statement, to which those for determinants are added."""

    shapes: dict[str, Shape]
    inverses: dict[str, JSON]
    powers: Mapping[tuple[str, str], str]  # names of numbers raised to the number of rows, by both
    names: dict[str, str] = field(default_factory=dict)

    def without(self, term: JSON) -> JSON:
        """A term with numbers for the determinants in it."""
        match term:
            case [tag, x] if tag == DET:
                return self.of(self.without(x))
            case [*parts]:
                return [self.without(part) for part in parts]
        return term

    def square(self, term: JSON) -> bool:
        """Whether it is a square matrix of more than one row, without determinants in it."""
        if has(term):
            return False
        n, m = Shapes(self.shapes).value(term).shape
        return n == m and n != 1

    def both(self, sides: tuple[JSON, JSON]) -> tuple[JSON, JSON] | None:
        """Both sides of an equation without determinants; None where they have one of which nothing is known."""
        with suppress(NoForm, Malformed):
            return self.without(sides[0]), self.without(sides[1])
        return None

    def of(self, term: JSON) -> JSON:
        """The determinant of a term without any."""
        known = Shapes(self.shapes)
        value = known.value(term)
        if value.shape == NUMBER:
            return term
        parts = [*value.parts.items()]
        if len(parts) == 1:
            return self._of_product(*parts[0], value.shape)
        base = next((k for k, ((numbers, word), c) in enumerate(parts) if not numbers and not word and c == 1), None)
        if base is not None and len(parts) == 2:
            return self._near_unit(*parts[1 - base])
        if base is None:
            for k, ((numbers, word), c) in enumerate(parts):
                inverse = next((x for x, of in self.inverses.items() if len(word) == 1 and of == word[0][0]), None)
                if not numbers and c == 1 and inverse is not None and not word[0][1]:
                    rest: list[JSON] = [_term(part, d) for j, (part, d) in enumerate(parts) if j != k]
                    relative: JSON = ["+", ["unit", value.shape[0]], ["*", inverse, ["+", *rest]]]
                    return ["*", self._letter(word[0][0]), self.of(relative)]
        turned = {(numbers, flipped(word)): c for (numbers, word), c in value.parts.items()}
        return self._named(str(min(sorted(value.parts.items()), sorted(turned.items()))))

    def _of_product(self, part: Monomial, c: Fraction, shape: Shape) -> JSON:
        numbers, word = part
        if any(self.shapes[x] != shape for x, _ in word):
            return self._named(str((part, c)))
        found = [self._letter(x) for x, _ in word]
        if c == 1 and len(numbers) == 1 and numbers[0][0] == "word" and len(numbers[0][1]) == 1:
            name = self.powers.get((numbers[0][1][0][0], str(shape[0])))
            if name is None:
                raise NoForm("the determinant of a multiple")
            found.append(name)
        elif c != 1 or numbers:
            raise NoForm("the determinant of a multiple")
        return ["*", *found] if len(found) > 1 else found[0] if found else ONE

    def _near_unit(self, part: Monomial, c: Fraction) -> JSON:
        """That of the unit plus a product."""
        numbers, word = part
        for k in range(len(word)):
            turned = (*word[k:], *word[:k])
            first, last = turned[0], turned[-1]
            if self.shapes[first[0]][first[1]] == 1 == self.shapes[last[0]][not last[1]]:
                return ["+", ONE, _term((numbers, turned), c)]
        turns = [(*word[k:], *word[:k]) for k in range(len(word))]
        return self._named(f"unit and {c} {numbers} {min(min(turn, flipped(turn)) for turn in turns)}")

    def _letter(self, name: str) -> JSON:
        """That of a letter: of an inverse the inverse number."""
        if name not in self.inverses:
            return self._named(name)
        of = self.of(self.inverses[name])
        known = ONE if of == ONE else next((x for x, other in self.inverses.items() if other == of), None)
        if known is not None:
            return known
        new = self._named(f"inverse {name}")
        self.inverses[str(new)] = of
        return new

    def _named(self, what: str) -> JSON:
        """A letter for a determinant of which nothing more is known."""
        if what not in self.names:
            name = f"determinant_{len(self.names) + 1}"
            self.names[what], self.shapes[name] = name, NUMBER
        return self.names[what]


def _term(part: Monomial, c: Fraction) -> JSON:
    numbers, word = part
    factors = [*map(_factor, numbers), *_letters(word)]
    return ["*", ["number", c.numerator, c.denominator], *factors]


def _letters(word: Word) -> list[JSON]:
    return [["transpose", x] if turned else x for x, turned in word]


def _factor(factor: Factor) -> JSON:
    kind, word = factor
    if kind == "size":
        return ["trace", ["unit", word[0][0]]]
    product: JSON = ["*", *_letters(word)] if len(word) > 1 else _letters(word)[0]
    return ["trace", product] if kind == "trace" else product


def has(term: JSON) -> bool:
    """Whether a determinant stands in a term."""
    return isinstance(term, list) and (term[:1] == [DET] or any(map(has, term)))
