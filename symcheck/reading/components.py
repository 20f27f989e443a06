"""Vectors as lists of terms and matrices as lists of rows: the arithmetic that lowering needs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any

from symcheck.core.terms import Term
from symcheck.reading.complexes import Complex, added, multiplied, negative

Value = Any  # Term | Complex, or a list of them, or a list of rows


class Row(list[Any]):
    """The components of a transposed vector."""


def shape(value: Value) -> tuple[int, ...]:
    """() of a scalar, (n,) of a vector, (n, m) of a matrix."""
    if not isinstance(value, list):
        return ()
    return (len(value), *shape(value[0]))


def says(value: Value) -> str:
    """The shape in a word."""
    if isinstance(value, Complex):
        return "complex number"
    return ("scalar", "vector", "matrix")[len(shape(value))]


def zero(like: Value) -> Value:
    """The zero of the same shape."""
    return [zero(item) for item in like] if isinstance(like, list) else 0


def flat(value: Value) -> Iterator[Term]:
    """All components, by rows."""
    if isinstance(value, list):
        for item in value:
            yield from flat(item)
    else:
        yield value


def zipped(build: Callable[..., Term], values: list[Value]) -> Value:
    """Component by component."""
    if not isinstance(values[0], list):
        return build(*values)
    return type(values[0])(zipped(build, list(parts)) for parts in zip(*values, strict=True))


def times(a: Value, b: Value) -> Value:
    """A product of components; the zeros and ones that matrices are made of vanish."""
    if a == 0 or b == 0:
        return 0
    return b if a == 1 else a if b == 1 else multiplied(a, b)


def minus(a: Value, b: Value) -> Value:
    """The difference of two components."""
    if b == 0:
        return a
    return negative(b) if a == 0 else added(a, negative(b))


def plus(terms: Iterable[Value]) -> Value:
    """The sum of components."""
    kept = tuple(term for term in terms if term != 0)
    return added(*kept) if len(kept) > 1 else kept[0] if kept else 0


def dot(u: list[Term], v: list[Term]) -> Term:
    """The scalar product."""
    return plus(times(a, b) for a, b in zip(u, v, strict=True))


def matmul(a: Value, b: Value) -> Value:
    """Matrix times matrix or vector, a transposed vector times either, or a vector times one; the shapes must fit."""
    right = shape(b)
    if isinstance(a, Row):
        return dot(a, b) if len(right) == 1 else Row(dot(a, list(column)) for column in zip(*b, strict=True))
    if isinstance(b, Row):
        return [[times(x, y) for y in b] for x in a]
    if len(right) == 1:
        return [dot(row, b) for row in a]
    columns = [list(column) for column in zip(*b, strict=True)]
    return [[dot(row, column) for column in columns] for row in a]


def skew(v: list[Term]) -> list[list[Term]]:
    """The matrix whose product with a vector is the cross product of v with it."""
    x, y, z = v
    return [[0, minus(0, z), y], [z, 0, minus(0, x)], [minus(0, y), x, 0]]


def det(rows: list[list[Term]]) -> Term:
    """Expansion along the first row."""
    if len(rows) == 1:
        return rows[0][0]
    total: Term = 0
    for k, entry in enumerate(rows[0]):
        minor = times(entry, det([row[:k] + row[k + 1 :] for row in rows[1:]]))
        total = plus([total, minor]) if k % 2 == 0 else minus(total, minor)
    return total
