"""Terms and formulas taken apart and put together for Coq: read from certificates, unfolded, searched."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import partial
from math import lcm
from typing import Any, TypeVar

from symcheck.core import calculus
from symcheck.core.calculus import letters
from symcheck.core.terms import FORMULAS, JSON, Binder, Formula, Node, Reader, Term, Value, mapped, node

Certificate = dict[str, Any]  # a part of one, as JSON data

Tree = TypeVar("Tree", bound="int | str | Node")  # a term or formula, which stays one after a change
# a factor of a printed monomial: 3/4, or x^2
FACTOR = re.compile(r"(\d+)(?:/(\d+))?|([A-Za-z]\w*)(?:\^(\d+))?", re.ASCII)


class NotExported(Exception):
    """The statement or its proof has no form in Coq here; the message says why."""


def in_order(*trees: Term) -> list[str]:
    """The free letters in order of appearance."""
    found: dict[str, None] = {}
    for tree in trees:
        if isinstance(tree, str):
            found[tree] = None
        elif isinstance(tree, Node):
            bound = {*tree.bound}.difference(tree.outside)  # a derivative is mostly taken at the letter itself
            found |= dict.fromkeys(x for x in in_order(*tree.inside) if x not in bound)
            found |= dict.fromkeys(in_order(*tree.outside))
    return [*found]


def nodes(*trees: Term) -> Iterator[Node]:
    """All nodes, each before its parts, also those under binders."""
    for tree in trees:
        if isinstance(tree, Node):
            yield tree
            yield from nodes(*tree.inside, *tree.outside)


def subterms(*trees: Term) -> Iterator[Term]:
    """All terms, inner ones first; not those under a binder of terms, where letters mean something else."""
    for tree in trees:
        if isinstance(tree, Node) and not isinstance(tree, Binder):
            yield from subterms(*tree.inside, *tree.outside)
        if not (isinstance(tree, Node) and tree.tag in FORMULAS):
            yield tree


class Definitions:
    """What defined letters stand for; terms of a certificate in which they stand, and in which they are unfolded."""

    def __init__(self, pairs: list[tuple[str, JSON]]) -> None:
        self.terms: dict[str, Term] = {}  # as they are printed
        self.full: dict[str, Term] = {}  # over free letters alone
        for name, data in pairs:
            self.terms[name] = self.read(data)
            self.full[name] = self.unfolded(self.terms[name])

    def read(self, data: JSON) -> Term:
        """A term as it is printed: definitions are unfolded only where they depend on a letter bound around them."""
        return self._unfolded(Reader().term(data))

    def formula(self, data: JSON) -> Formula:
        """A formula as it is printed."""
        return self._unfolded(Reader().formula(data))

    def unfolded(self, tree: Tree) -> Tree:
        """A term or formula over free letters alone."""
        return self._unfolded(tree, everywhere=True)

    def _unfolded(self, tree: Tree, around: frozenset[str] = frozenset(), everywhere: bool = False) -> Tree:
        meant = self.full.get(tree) if isinstance(tree, str) and tree not in around else None
        if meant is not None and everywhere:
            return meant  # type: ignore[return-value]
        if meant is not None and around.intersection(letters(meant)):
            return self._unfolded(self.terms[tree], around)  # type: ignore[return-value, index]
        if not isinstance(tree, Node):
            return tree
        scopes = around, around.union(tree.bound)
        outside, inside = (partial(self._unfolded, around=scope, everywhere=everywhere) for scope in scopes)
        return mapped(tree, outside, inside)  # type: ignore[return-value]


def is_number(term: Term) -> bool:
    """Whether there is no letter in a term, and no pi."""
    return not letters(term) and all(part.tag != "pi" for part in nodes(term))


def polynomial(text: str, atoms: Mapping[str, Term]) -> tuple[Term, int]:
    """A polynomial printed in a certificate, times its common denominator, as a term; and that denominator."""
    read = [_monomial(part, atoms) for part in text.replace(" - ", " + -").split(" + ")]
    scale = lcm(*(coefficient.denominator for coefficient, _ in read))
    terms = [_product(int(coefficient * scale), factors) for coefficient, factors in read]
    return (terms[0] if len(terms) == 1 else node("+", *terms)), scale


def _monomial(text: str, atoms: Mapping[str, Term]) -> tuple[Fraction, list[Term]]:
    coefficient, factors = Fraction(-1 if text.startswith("-") else 1), list[Term]()
    for factor in text.removeprefix("-").split("*"):
        found = FACTOR.fullmatch(factor)
        if not found:
            raise NotExported(f"the factor {factor!r}")
        number, below, name, exponent = found.groups()
        if number:
            coefficient *= Fraction(int(number), int(below or 1))
        else:
            base = atoms.get(name, name)
            factors.append(node("^", base, int(exponent)) if exponent else base)
    return coefficient, factors


def _product(coefficient: int, factors: list[Term]) -> Term:
    if not factors:
        return coefficient
    body = product([abs(coefficient), *factors])
    return body if coefficient > 0 else node("-", body)


def product(terms: list[Term]) -> Term:
    """The product of terms, without ones."""
    kept = [t for t in terms if t != 1]
    return 1 if not kept else kept[0] if len(kept) == 1 else node("*", *kept)


def factors(term: Term) -> Iterator[Term]:
    """The factors of a denominator."""
    match term:
        case Value(tag="*" | "/" | "-", terms=parts):
            for part in parts:
                yield from factors(part)
        case Value(tag="^", terms=(base, int(n))) if n > 0:
            yield from factors(base)
        case _:
            yield term


def denominators(*trees: Term) -> Iterator[Term]:
    """The factors of all denominators in terms and formulas, inner ones first."""
    for term in subterms(*trees):
        match term:
            case Binder(tag="diff", body=body):  # mostly taken at the letter itself
                yield from denominators(body)
            case Node() if (divisor := calculus.divisor(term)) != 1:
                yield from factors(divisor)


def fraction(term: Term) -> tuple[Term, list[Term]]:
    """A term as a numerator over factors of a common denominator, put together like `field` does."""
    match term:
        case Value(tag="+", terms=parts):
            read = [fraction(part) for part in parts]
            common: list[Term] = []
            for _, below in read:
                common += [b for b in dict.fromkeys(below) for _ in range(below.count(b) - common.count(b))]
            return node("+", *(product([top, *without(common, below)]) for top, below in read)), common
        case Value(tag="-", terms=(inner,)):
            top, below = fraction(inner)
            return node("-", top), below
        case Value(tag="*", terms=parts):
            read = [fraction(part) for part in parts]
            return product([top for top, _ in read]), [b for _, below in read for b in below]
        case Value(tag="/", terms=(above, bottom)):
            (top, below), (divisor, lifted) = fraction(above), fraction(bottom)
            return (term, []) if isinstance(divisor, int) else (product([top, *lifted]), [*below, divisor])
        case Value(tag="^", terms=(base, int(n))) if n > 0:
            top, below = fraction(base)
            return node("^", top, n), below * n
    return term, []


def without(terms: list[Term], taken: list[Term]) -> list[Term]:
    """The terms less some of them, each once."""
    left = list(terms)
    for t in taken:
        left.remove(t)
    return left


def without_tangents(tree: Tree) -> Tree:
    """tan x = sin x / cos x, as Coq defines it."""
    if not isinstance(tree, Node):
        return tree
    whole = mapped(tree, without_tangents)
    if whole.tag == "tan":
        return node("/", node("sin", *whole.terms), node("cos", *whole.terms))  # type: ignore[return-value]
    return whole  # type: ignore[return-value]
