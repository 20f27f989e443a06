"""Vectors as lists of terms and matrices as lists of rows: the arithmetic that lowering needs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import reduce
from math import factorial
from typing import Any

from symcheck.core import terms
from symcheck.core.terms import Term, node
from symcheck.core.verdicts import SymcheckError
from symcheck.reading.complexes import Complex, Number, added, divided, multiplied, negative, parts

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


def zipped(build: Callable[..., Number], values: list[Value]) -> Value:
    """Component by component."""
    if not isinstance(values[0], list):
        return build(*values)
    return type(values[0])(zipped(build, list(parts)) for parts in zip(*values, strict=True))


def each_part(build: Callable[[Term], Term], value: Value) -> Value:
    """Component by component, real and imaginary parts by themselves."""

    def built(number: Number) -> Number:
        return Complex(*map(build, parts(number))) if isinstance(number, Complex) else build(number)

    return zipped(built, [value])


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


def worked_out(t: Value) -> Value:
    """A term without the zeros and ones in its sums and products."""
    match t:
        case terms.Value(tag="+", terms=addends):
            return plus(map(worked_out, addends))
        case terms.Value(tag="*", terms=factors):
            return reduce(times, map(worked_out, factors), 1)
        case terms.Value(tag="-", terms=(inner,)):
            return minus(0, worked_out(inner))
    return t


def dot(u: Sequence[Number], v: Sequence[Number]) -> Value:
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


def identity(size: int) -> list[list[Term]]:
    """The identity matrix."""
    return [[int(k == m) for m in range(size)] for k in range(size)]


def inverse(rows: list[list[Term]]) -> Value:
    """The inverse of a square matrix: its adjugate divided by its determinant."""
    size, whole = len(rows), det(rows)
    if size == 1:
        return [[divided(1, whole)]]

    def minor(k: int, m: int) -> Value:
        found = det([[x for n, x in enumerate(row) if n != m] for j, row in enumerate(rows) if j != k])
        return minus(0, found) if (k + m) % 2 else found

    return [[divided(minor(m, k), whole) for m in range(size)] for k in range(size)]


def power(rows: Value, exponent: int) -> Value:
    """A whole power of a square matrix."""
    base = rows if exponent >= 0 else inverse(rows)
    result: Value = identity(len(rows))
    for n in range(abs(exponent)):
        result = matmul(result, base) if n else base
    return result


def exponential(rows: list[list[Term]]) -> Value | None:
    """The exponential of a square matrix whose form shows it; None for another one.

    Skew-symmetric matrices of two or three rows, diagonal ones, those of which a power is zero, and those of two rows
    without a diagonal whose square is the identity times a square or its negative.
    """
    size = len(rows)
    if any(isinstance(entry, Complex) for row in rows for entry in row):
        return None
    off = [(k, m) for k in range(size) for m in range(size) if k != m]
    if not any(rows[k][m] != 0 for k, m in off):
        return [[node("exp", rows[k][k]) if k == m else 0 for m in range(size)] for k in range(size)]
    powers = [identity(size), rows]
    while len(powers) < size:
        powers.append(matmul(powers[-1], rows))
    if not any(entry != 0 for row in matmul(powers[-1], rows) for entry in row):
        return _sum([(node("/", 1, factorial(n)) if n > 1 else 1, each) for n, each in enumerate(powers)])
    if any(_signed(rows[k][k])[1] != 0 for k in range(size)) or size not in (2, 3):
        return None
    if all(_signed(rows[k][m]) == _signed(minus(0, rows[m][k])) for k, m in off):
        return _rotation(rows)
    return _oscillation(rows) if size == 2 else None


def _rotation(rows: list[list[Term]]) -> Value:
    """That of a skew-symmetric matrix, by Rodrigues' formula."""
    if len(rows) == 2:
        angle = rows[1][0]
        c, s = node("cos", angle), node("sin", angle)
        return [[c, node("-", s)], [s, c]]
    x, y, z = rows[2][1], rows[0][2], rows[1][0]
    square = plus(node("^", t, 2) for t in (x, y, z))
    angle = node("sqrt", square)
    first, second = node("/", node("sin", angle), angle), node("/", plus([1, node("-", node("cos", angle))]), square)
    return _sum([(1, identity(3)), (first, rows), (second, matmul(rows, rows))])


def _oscillation(rows: list[list[Term]]) -> Value | None:
    """That of a matrix of two rows whose square is w^2 or -w^2 times the identity."""
    if (square := _root(times(rows[0][1], rows[1][0]))) is None:
        return None
    sign, w = square
    if sign < 0:
        even, odd = node("cos", w), node("sin", w)
    else:
        up, down = node("exp", w), node("exp", node("-", w))
        even, odd = node("/", node("+", up, down), 2), node("/", node("+", up, node("-", down)), 2)
    return _sum([(even, identity(2)), (node("/", odd, w), rows)])


def _sum(addends: Sequence[tuple[Term, list[list[Term]]]]) -> Value:
    """A sum of multiples of square matrices."""
    places = range(len(addends[0][1]))
    return [[plus([times(c, rows[k][m]) for c, rows in addends]) for m in places] for k in places]


def _root(t: Term) -> tuple[int, Term] | None:
    """(s, w) with s w^2 the term, where that is seen: the term is a product of even powers, with a sign s."""
    exponents, sign = dict[Term, int](), 1

    def collect(part: Term, power_: int) -> None:
        nonlocal sign
        match part:
            case terms.Value(tag="*", terms=factors):
                for factor in factors:
                    collect(factor, power_)
            case terms.Value(tag="^", terms=(base, int(n))):
                collect(base, power_ * n)
            case terms.Value(tag="-", terms=(inner,)):
                sign *= -1 if power_ % 2 else 1
                collect(inner, power_)
            case _ if part != 1:
                exponents[part] = exponents.get(part, 0) + power_

    collect(t, 1)
    if any(n % 2 or n < 0 for n in exponents.values()):
        return None
    return sign, reduce(times, (node("^", base, n // 2) if n > 2 else base for base, n in exponents.items()), 1)


def _signed(t: Term) -> tuple[int, Term]:
    """A sign, and what stands behind all its signs."""
    sign = 1
    while isinstance(t, tuple) and t.tag == "-":
        sign, t = -sign, t.terms[0]
    return sign, t


def skew(v: list[Term]) -> list[list[Term]]:
    """The matrix whose product with a vector is the cross product of v with it."""
    if len(v) != 3:
        raise SymcheckError(
            f"a vector of {len(v)} components has no skew matrix of that size; cross products need three"
        )
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
