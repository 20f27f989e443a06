"""Fractions, roots, angle sums: small computations with terms and numbers behind the proof scripts."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from symcheck.proof.theorems import Terms


def fraction(term: Any) -> tuple[Any, list[Any]]:
    """A term as a numerator over factors of a common denominator, put together like `field` does."""
    match term:
        case ["+", *parts]:
            read = [fraction(part) for part in parts]
            common: list[Any] = []
            for _, below in read:
                common += [
                    b
                    for b in dict_of(below).values()
                    if below.count(b) > common.count(b)
                    for _ in range(below.count(b) - common.count(b))
                ]
            return ["+", *(product([top, *without(common, below)]) for top, below in read)], common
        case ["-", inner]:
            top, below = fraction(inner)
            return ["-", top], below
        case ["*", *parts]:
            read = [fraction(part) for part in parts]
            return product([top for top, _ in read]), [b for _, below in read for b in below]
        case ["/", above, bottom]:
            (top, below), (divisor, lifted) = fraction(above), fraction(bottom)
            return (term, []) if isinstance(divisor, int) else (product([top, *lifted]), [*below, divisor])
        case ["^", base, int(n)] if n > 0:
            top, below = fraction(base)
            return ["^", top, n], below * n
    return term, []


def dict_of(terms: list[Any]) -> dict[str, Any]:
    """The different ones of some terms."""
    return {str(t): t for t in terms}


def without(terms: list[Any], taken: list[Any]) -> list[Any]:
    """The terms less some of them, each once."""
    left = list(terms)
    for t in taken:
        left.remove(t)
    return left


def product(terms: list[Any]) -> Any:
    """The product of terms, without ones."""
    kept = [t for t in terms if t != 1]
    return 1 if not kept else kept[0] if len(kept) == 1 else ["*", *kept]


def ratio_text(k: Fraction) -> str:
    """A fraction as Coq reads it, in brackets."""
    sign, k = ("-" if k < 0 else ""), abs(k)
    return f"({sign}{k.numerator})" if k.denominator == 1 else f"({sign}{k.numerator} / {k.denominator})"


def square_part(value: Fraction) -> tuple[Fraction, list[int]]:
    """The root of a positive number: a rational number, and the primes under the roots."""
    primes: list[int] = []
    whole, outer, p = value.numerator * value.denominator, 1, 2
    while whole > 1:
        while whole % (p * p) == 0:
            whole, outer = whole // (p * p), outer * p
        if whole % p == 0:
            whole, primes = whole // p, [*primes, p]
        p += 1
    return Fraction(outer, value.denominator), primes


def addition(parts: list[tuple[str, str]]) -> tuple[str, str]:
    """Cosine and sine of a sum of angles, as texts."""
    if not parts:
        return "1", "0"
    cosine, sine = parts[0]
    for c, s in parts[1:]:
        cosine, sine = f"(({cosine}) * {c} - ({sine}) * ({s}))", f"(({sine}) * {c} + ({cosine}) * ({s}))"
    return cosine, sine


def derivative(slope: Any) -> Any:
    """What the table of the checker says it is."""
    _, body, x, order = slope
    return Terms({}).derived(body, x, order)


def is_slope(term: Any) -> bool:
    """Whether a term is a derivative."""
    return isinstance(term, list) and term[0] == "diff"


def without_tangents(node: Any) -> Any:
    """tan x = sin x / cos x, as Coq defines it."""
    match node:
        case ["tan", angle]:
            angle = without_tangents(angle)
            return ["/", ["sin", angle], ["cos", angle]]
        case list():
            return [without_tangents(child) for child in node]
    return node
