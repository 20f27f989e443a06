"""Vectors as lists of terms and matrices as lists of rows: the arithmetic that lowering needs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any

from symcheck.core.terms import Term, node

Value = Any  # Term | list[Term] | list[list[Term]]


def shape(value: Value) -> tuple[int, ...]:
    """() of a scalar, (n,) of a vector, (n, m) of a matrix."""
    if not isinstance(value, list):
        return ()
    return (len(value), *shape(value[0]))


def says(value: Value) -> str:
    """The shape in a word."""
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
    return [zipped(build, list(parts)) for parts in zip(*values, strict=True)]


def times(a: Term, b: Term) -> Term:
    """A product of components; the zeros and ones that matrices are made of vanish."""
    if a == 0 or b == 0:
        return 0
    return b if a == 1 else a if b == 1 else node("*", a, b)


def minus(a: Term, b: Term) -> Term:
    """The difference of two components."""
    if b == 0:
        return a
    return node("-", b) if a == 0 else node("+", a, node("-", b))


def plus(terms: Iterable[Term]) -> Term:
    """The sum of components."""
    kept = tuple(term for term in terms if term != 0)
    return node("+", *kept) if len(kept) > 1 else kept[0] if kept else 0


def dot(u: list[Term], v: list[Term]) -> Term:
    """The scalar product."""
    return plus(times(a, b) for a, b in zip(u, v, strict=True))


def matmul(a: Value, b: Value) -> Value:
    """Matrix times matrix or vector; the shapes must fit."""
    right = shape(b)
    if len(right) == 1:
        return [dot(row, b) for row in a]
    columns = [list(column) for column in zip(*b, strict=True)]
    return [[dot(row, column) for column in columns] for row in a]


def det(rows: list[list[Term]]) -> Term:
    """Expansion along the first row."""
    if len(rows) == 1:
        return rows[0][0]
    total: Term = 0
    for k, entry in enumerate(rows[0]):
        minor = times(entry, det([row[:k] + row[k + 1 :] for row in rows[1:]]))
        total = plus([total, minor]) if k % 2 == 0 else minus(total, minor)
    return total
