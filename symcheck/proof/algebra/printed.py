"""Polynomials as they are printed, read as terms."""

from __future__ import annotations

from symcheck.core.terms import Term, node
from symcheck.proof.algebra.variables import table


def term_of_text(text: str) -> Term:
    """A polynomial as it is printed, as a term, with what its variables stand for."""
    addends = [_product(term) for term in text.replace(" - ", " + -").split(" + ")]
    return addends[0] if len(addends) == 1 else node("+", *addends)


def _product(text: str) -> Term:
    if text.startswith("-"):
        return node("-", _product(text[1:]))
    factors: list[Term] = []
    for factor in text.split("*"):
        name, _, exponent = factor.partition("^")
        top, _, bottom = name.partition("/")
        number: Term = node("/", int(top), int(bottom)) if bottom else int(top) if top.isdigit() else table().term(name)
        factors.append(node("^", number, int(exponent)) if exponent else number)
    return factors[0] if len(factors) == 1 else node("*", *factors)
