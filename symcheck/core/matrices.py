"""Matrices of all sizes: terms, and their normal form as sums of products of letters. The standard library alone.

    "A"    ["unit", n]    ["zero", n, m]    ["number", p, q], the fraction p/q
    ["+", X, ...]    ["*", X, ...]    ["-", X]    ["transpose", X]    ["trace", X]

Each letter has a shape: its numbers of rows and columns, letters or 1. What has one row and one column is a
number: it is its own transpose, and multiplies every matrix from either side. Terms that have the same normal form are
equal for all matrices of these shapes over a commutative ring, whatever whole numbers the letters of sizes stand for.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from functools import reduce
from typing import NamedTuple, TypeAlias

from symcheck.core.terms import JSON, Malformed, Reader

Size: TypeAlias = "int | str"
Shape: TypeAlias = "tuple[Size, Size]"
Word: TypeAlias = "tuple[tuple[str, bool], ...]"  # letters in the order of a product, and whether each is transposed
Factor: TypeAlias = "tuple[str, Word]"  # a number: a "word" of that shape, the "trace" of one, or a "size"
Monomial: TypeAlias = "tuple[tuple[Factor, ...], Word]"  # numbers in alphabetic order, and the rest of a product
NUMBER: Shape = (1, 1)
FACT = "fact"  # the letter that stands for a fact in a step of a proof
MOST = 10_000  # products in a normal form: a certificate with more would take minutes


class Matrix(NamedTuple):
    """The normal form of a term: its shape and the coefficients of its products."""

    shape: Shape
    parts: dict[Monomial, Fraction]


def size(data: JSON) -> Size:
    """A number of rows or columns, a letter or 1; Malformed if it is none."""
    if isinstance(data, str):
        return Reader.letter(data)
    if type(data) is int and data == 1:
        return 1
    raise Malformed(f"{data!r} is no number of rows or columns: a letter, or 1")


def words(term: JSON) -> set[str]:
    """All words of a term, its letters among them."""
    return set().union(*map(words, term)) if isinstance(term, list) else {term} if isinstance(term, str) else set()


def flipped(word: Word) -> Word:
    """The transpose of a product."""
    return tuple((letter, not transposed) for letter, transposed in reversed(word))


class Shapes:
    """What letters of these shapes make, or where all sizes are 1; a letter of `values` stands for its value."""

    def __init__(
        self, shapes: Mapping[str, Shape], values: Mapping[str, Matrix] | None = None, *, single: bool = False
    ) -> None:
        self.shapes = dict.fromkeys(shapes, NUMBER) if single else shapes
        self.values, self.single = values or {}, single

    def value(self, term: JSON) -> Matrix:
        """The normal form of a term; Malformed if it is none, or its parts do not fit together."""
        if isinstance(term, str):
            return self.values[term] if term in self.values else self._letter(term)
        match term:
            case ["unit", n]:
                return Matrix(NUMBER if self.single else (size(n), size(n)), {((), ()): Fraction(1)})
            case ["zero", n, m]:
                return Matrix(NUMBER if self.single else (size(n), size(m)), {})
            case ["number", int(p), int(q)] if q and type(p) is type(q) is int:
                return Matrix(NUMBER, _nonzero([(((), ()), Fraction(p, q))]))
            case ["+" | "*" as tag, first, *rest]:
                return reduce(self.plus if tag == "+" else self.times, map(self.value, rest), self.value(first))
            case ["-", x]:
                return self.value(["*", ["number", -1, 1], x])
            case ["transpose", x]:
                (n, m), parts = self.value(x)
                return Matrix((m, n), {(numbers, flipped(word)): c for (numbers, word), c in parts.items()})
            case ["trace", x]:
                return self._trace(self.value(x))
        raise Malformed(f"{str(term)[:80]} is no term of matrices")

    def difference(self, left: JSON, right: JSON) -> Matrix:
        """The normal form of the difference of both sides of an equation."""
        return self.value(["+", left, ["-", right]])

    def plus(self, x: Matrix, y: Matrix) -> Matrix:
        """The sum of two matrices of one shape."""
        if x.shape != y.shape:
            raise Malformed(f"a sum of matrices of the shapes {x.shape} and {y.shape}")
        return Matrix(x.shape, _nonzero([*x.parts.items(), *y.parts.items()]))

    def times(self, x: Matrix, y: Matrix) -> Matrix:
        """The product of two matrices that fit together, or of which one is a number."""
        if NUMBER in (x.shape, y.shape):
            shape = y.shape if x.shape == NUMBER else x.shape
        elif x.shape[1] == y.shape[0]:
            shape = x.shape[0], y.shape[1]
        else:
            raise Malformed(f"a product of matrices of the shapes {x.shape} and {y.shape}")
        if len(x.parts) * len(y.parts) > MOST:
            raise Malformed(f"a sum of more than {MOST} products")
        products = (
            (self._monomial((*numbers, *others), (*word, *rest)), c * d)
            for (numbers, word), c in x.parts.items()
            for (others, rest), d in y.parts.items()
        )
        return Matrix(shape, _nonzero(products))

    def _letter(self, name: str) -> Matrix:
        if name not in self.shapes:
            raise Malformed(f"nothing is said of the shape of {name}")
        return Matrix(self.shapes[name], {self._monomial((), ((name, False),)): Fraction(1)})

    def _rows(self, factor: tuple[str, bool]) -> Size:
        return self.shapes[factor[0]][factor[1]]

    def _columns(self, factor: tuple[str, bool]) -> Size:
        return self.shapes[factor[0]][not factor[1]]

    def _monomial(self, numbers: Iterable[Factor], word: Word) -> Monomial:
        """A product: it is cut where there is one column, and its parts that are numbers are told apart."""
        found, rest = [*numbers], list[tuple[str, bool]]()
        for part in self._cut(word):
            if self._rows(part[0]) == 1 == self._columns(part[-1]):
                found.append(("word", min(part, flipped(part))))
            else:
                rest += part
        return tuple(sorted(found)), tuple(rest)

    def _cut(self, word: Word) -> Iterator[Word]:
        start = 0
        for k, factor in enumerate(word, 1):
            if k == len(word) or self._columns(factor) == 1:
                yield word[start:k]
                start = k

    def _trace(self, x: Matrix) -> Matrix:
        n, m = x.shape
        if n != m:
            raise Malformed(f"the trace of a matrix of the shape {x.shape}")
        if x.shape == NUMBER:
            return x
        found = list[tuple[Monomial, Fraction]]()
        for (numbers, word), c in x.parts.items():
            cuts = [k for k, factor in enumerate(word, 1) if self._columns(factor) == 1]
            turned = [(*word[k:], *word[:k]) for k in cuts or range(len(word))]
            if cuts:
                found.append((self._monomial(numbers, turned[0]), c))
            else:
                factor = ("trace", min(min(w, flipped(w)) for w in turned)) if word else ("size", ((str(n), False),))
                found.append(((tuple(sorted([*numbers, factor])), ()), c))
        return Matrix(NUMBER, _nonzero(found))


def _nonzero(parts: Iterable[tuple[Monomial, Fraction]]) -> dict[Monomial, Fraction]:
    total: dict[Monomial, Fraction] = {}
    for part, c in parts:
        total[part] = total.get(part, Fraction()) + c
    return {part: c for part, c in total.items() if c}
