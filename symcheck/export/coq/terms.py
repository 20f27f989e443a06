"""Terms and formulas of certificates, taken apart and put together for Coq: unfolded, substituted, searched."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from math import lcm
from typing import Any

from symcheck.proof.theorems import BINDING, CONSTANTS, RELATIONS

FACTOR = re.compile(r"(\d+)(?:/(\d+))?|([A-Za-z]\w*)(?:\^(\d+))?", re.ASCII)
FUNCTIONS = ("sin", "cos", "tan", "sqrt", "exp", "log", "pow", "gamma", "arctan", "arcsin", "arccos")


class NotExported(Exception):
    """The statement or its proof has no form in Coq here; the message says why."""


def rebuilt(node: Any, change: Any) -> Any:
    """The node with its children changed; names of bound letters and orders are children that stay as they are."""
    if not isinstance(node, list) or not node:
        return node
    match node:
        case ["diff", body, x, order]:
            return ["diff", change(body), x, order]
        case ["mean" | "integral" | "diverges" as kind, body, x, *ends]:
            return [kind, change(body), x, *map(change, ends)]
        case ["exists", bound, body]:
            return ["exists", bound, change(body)]
        case ["call", function, orders, *arguments]:
            return ["call", function, orders, *map(change, arguments)]
        case ["^", base, n]:
            return ["^", change(base), n]
    return [node[0], *map(change, node[1:])]


def substituted(node: Any, values: Mapping[str, Any]) -> Any:
    """The node with letters replaced by terms, where they are not bound."""
    if isinstance(node, str):
        return values.get(node, node)
    bound = bound_letters(node)
    inner = {x: v for x, v in values.items() if x not in bound} if bound else values
    return rebuilt(node, lambda child: substituted(child, inner))


def bound_letters(node: Any) -> tuple[str, ...]:
    """The letters a node binds; a derivative is taken at the letter itself, which so stays free as well."""
    match node:
        case ["exists", bound, _]:
            return tuple(bound)
        case [kind, _, x, *_] if kind in (*BINDING, "diff"):
            return (x,)
    return ()


def letters(node: Any) -> list[str]:
    """The free letters in order of appearance."""
    return list(dict.fromkeys(_letters(node)))


def _letters(node: Any) -> Iterator[str]:
    match node:
        case str():
            if node not in CONSTANTS:
                yield node
        case ["exists", bound, body]:
            yield from (x for x in _letters(body) if x not in bound)
        case ["diff", body, x, _]:
            yield from _letters(body)
            yield x
        case [kind, body, x, *ends] if kind in BINDING:
            yield from (y for y in _letters(body) if y != x)
            for end in ends:
                yield from _letters(end)
        case ["^", base, _]:
            yield from _letters(base)
        case ["call", _, _, *parts] | [str(), *parts]:
            for part in parts:
                yield from _letters(part)


def functions(node: Any) -> Iterator[tuple[str, int]]:
    """The unknown functions with the numbers of their arguments, again and again."""
    if isinstance(node, list):
        if node[:1] == ["call"]:
            yield node[1], len(node) - 3
        for part in node:
            yield from functions(part)


class Definitions:
    """What defined letters stand for, and terms in which they are unfolded."""

    def __init__(self, pairs: list[Any]) -> None:
        self.terms: dict[str, Any] = {}
        for name, term in pairs:
            self.terms[name] = term
        self.full: dict[str, Any] = {}

    def unfolded(self, node: Any) -> Any:
        """The node over free letters alone."""
        if isinstance(node, str):
            if node not in self.terms:
                return node
            if node not in self.full:
                self.full[node] = self.unfolded(self.terms[node])
            return self.full[node]
        return rebuilt(node, self.unfolded)

    def readable(self, node: Any) -> Any:
        """The node as it is printed: definitions are unfolded only where they depend on a letter bound around them."""
        bound = bound_letters(node)
        if bound:
            node = rebuilt(node, lambda child: self._over(child, set(bound)))
        return rebuilt(node, self.readable)

    def _over(self, node: Any, bound: set[str]) -> Any:
        if isinstance(node, str):
            depends = node in self.terms and bound & set(letters(self.unfolded(node)))
            return self._over(self.terms[node], bound) if depends else node
        return rebuilt(node, lambda child: self._over(child, bound))


def polynomial(text: str, atoms: Mapping[str, Any]) -> tuple[Any, int]:
    """A polynomial printed in a certificate, times its common denominator, as a term; and that denominator."""
    read = [_monomial(part, atoms) for part in text.replace(" - ", " + -").split(" + ")]
    scale = lcm(*(coefficient.denominator for coefficient, _ in read))
    terms = [_product(int(coefficient * scale), factors) for coefficient, factors in read]
    return (terms[0] if len(terms) == 1 else ["+", *terms]), scale


def _monomial(text: str, atoms: Mapping[str, Any]) -> tuple[Fraction, list[Any]]:
    coefficient, factors = Fraction(-1 if text.startswith("-") else 1), []
    for factor in text.removeprefix("-").split("*"):
        found = FACTOR.fullmatch(factor)
        if not found:
            raise NotExported(f"the factor {factor!r}")
        number, below, name, exponent = found.groups()
        if number:
            coefficient *= Fraction(int(number), int(below or 1))
        else:
            base = atoms.get(name, name)
            factors.append(["^", base, int(exponent)] if exponent else base)
    return coefficient, factors


def _product(coefficient: int, factors: list[Any]) -> Any:
    if not factors:
        return coefficient
    body = factors[0] if len(factors) == 1 else ["*", *factors]
    if coefficient in (1, -1):
        return body if coefficient == 1 else ["-", body]
    product = ["*", abs(coefficient), *factors]
    return product if coefficient > 0 else ["-", product]


def subterms(node: Any) -> Iterator[Any]:
    """All terms in a term or formula, inner ones first; not those under a binder, where letters mean something else."""
    if isinstance(node, list):
        if node[0] in (*BINDING, "diff"):
            yield node
            return
        start = 2 if node[0] == "exists" else 3 if node[0] == "call" else 1
        children = node[1:2] if node[0] == "^" else node[start:]
        for child in children:
            yield from subterms(child)
    if not (isinstance(node, list) and node[0] in (*RELATIONS, "and", "or", "=>", "<=>", "exists")):
        yield node


def factors(term: Any) -> Iterator[Any]:
    """The factors of a denominator."""
    match term:
        case ["*", *parts]:
            for part in parts:
                yield from factors(part)
        case ["^", base, int(n)] if n > 0:
            yield from factors(base)
        case ["-", inner]:
            yield from factors(inner)
        case ["/", top, bottom]:
            yield from factors(top)
            yield from factors(bottom)
        case _:
            yield term


def denominators(node: Any) -> Iterator[Any]:
    """The factors of all denominators in a term or formula, inner ones first."""
    for term in subterms(node):
        match term:
            case ["/", _, bottom]:
                yield from factors(bottom)
            case ["^", base, int(n)] if n < 0:
                yield from factors(base)
            case ["tan", angle]:
                yield ["cos", angle]
            case ["diff", body, *_]:  # taken at the letter itself
                yield from denominators(body)


def is_number(term: Any) -> bool:
    """Whether it is made of whole numbers and their roots."""
    return not letters(term) and "'pi'" not in str([term])
