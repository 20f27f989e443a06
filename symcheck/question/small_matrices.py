"""Statements about matrices of all sizes written out for two rows and columns: what fails there is false."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from symcheck.core.matrices import Shape, Size
from symcheck.core.problems import Problem
from symcheck.core.terms import JSON, Formula, Malformed, Term, node
from symcheck.question.determinants import DET

Rows = list[list[Term]]
ROWS = 2  # what is false of matrices is mostly so of these


class Small:
    """The components of letters of these shapes, and of the inverses among them."""

    def __init__(self, shapes: Mapping[str, Shape], inverses: Mapping[str, JSON]) -> None:
        self.shapes, self.inverses = shapes, inverses
        self.divisors = dict[Term, None]()  # of inverses

    def problems(self, both: tuple[JSON, JSON], assumed: Mapping[str, tuple[JSON, JSON]]) -> Iterator[Problem]:
        """The claims about components, of which each has to hold."""
        hypotheses = tuple((name, tuple(self.equations(*sides))) for name, sides in assumed.items())
        claims = [*self.equations(*both)]
        regular = tuple(node("!=", each, 0) for each in self.divisors)
        for claim in claims:
            yield Problem("question", claim, (), (*hypotheses, *((("regular", regular),) * bool(regular))))

    def equations(self, left: JSON, right: JSON) -> Iterator[Formula]:
        for one, other in zip(self.value(left), self.value(right), strict=True):
            for a, b in zip(one, other, strict=True):
                yield node("=", a, b)

    def value(self, term: JSON) -> Rows:
        """A term by its components."""
        match term:
            case str() if term in self.inverses:
                return self.inverse(self.value(self.inverses[term]))
            case str():
                n, m = map(_number, self.shapes[term])
                return [[f"{term}_{i}{j}" for j in range(1, m + 1)] for i in range(1, n + 1)] if n * m > 1 else [[term]]
            case ["unit", n]:
                size = range(_number(n))
                return [[int(i == j) for j in size] for i in size]
            case ["zero", n, m]:
                return [[0] * _number(m) for _ in range(_number(n))]
            case ["number", int(p), int(q)]:
                return [[node("/", p, q) if q != 1 else p]]
            case ["+", first, *rest]:
                found = self.value(first)
                for each in rest:
                    found = [
                        [_plus(a, b) for a, b in zip(x, y, strict=True)]
                        for x, y in zip(found, self.value(each), strict=True)
                    ]
                return found
            case ["-", x]:
                return [[node("-", a) for a in row] for row in self.value(x)]
            case ["*", first, *rest]:
                found = self.value(first)
                for each in rest:
                    found = _times(found, self.value(each))
                return found
            case ["transpose", x]:
                return [list(column) for column in zip(*self.value(x), strict=True)]
            case ["trace", x]:
                rows = self.value(x)
                return [[_sum([rows[k][k] for k in range(len(rows))])]]
            case [tag, x] if tag == DET:
                return [[_determinant(self.value(x))]]
        raise Malformed(f"{str(term)[:80]} is no term of matrices")

    def inverse(self, rows: Rows) -> Rows:
        """By Cramer's rule."""
        below = _determinant(rows)
        self.divisors[below] = None
        if len(rows) == 1:
            return [[node("/", 1, below)]]
        (a, b), (c, d) = rows
        adjugate = [[d, node("-", b)], [node("-", c), a]]
        return [[node("/", each, below) for each in row] for row in adjugate]


def _number(size: Size) -> int:
    return 1 if size == 1 else ROWS


def _plus(a: Term, b: Term) -> Term:
    return b if a == 0 else a if b == 0 else node("+", a, b)


def _sum(terms: list[Term]) -> Term:
    found: Term = 0
    for each in terms:
        found = _plus(found, each)
    return found


def _product(a: Term, b: Term) -> Term:
    return 0 if 0 in (a, b) else b if a == 1 else a if b == 1 else node("*", a, b)


def _times(x: Rows, y: Rows) -> Rows:
    for number, other in ((x, y), (y, x)):
        if len(number) == len(number[0]) == 1 and len(y) != len(x[0]):
            return [[_product(number[0][0], each) for each in row] for row in other]
    if len(x[0]) != len(y):
        raise Malformed("matrices that do not fit together")
    columns = [list(column) for column in zip(*y, strict=True)]
    return [[_sum([_product(a, b) for a, b in zip(row, column, strict=True)]) for column in columns] for row in x]


def _determinant(rows: Rows) -> Term:
    if len(rows) == 1:
        return rows[0][0]
    (a, b), (c, d) = rows
    return _plus(_product(a, d), node("-", _product(b, c)))
