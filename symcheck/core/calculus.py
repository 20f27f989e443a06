"""Derivatives of terms, and what is a polynomial in what: shared by the checker and by those who look for proofs."""

from __future__ import annotations

from symcheck.core.terms import (
    Binder,
    Call,
    Minus,
    Node,
    Power,
    Product,
    Quotient,
    Sum,
    Term,
    Value,
    letters,
    node,
    substituted,
)


class Unknown(Exception):
    """A term about which nothing is known here; the message names it."""


def differentiated(term: Binder) -> Term:
    """What a node "diff" stands for: the derivative of its body, at its place."""
    rate, order, place = term.body, term[3], term.ends[1]
    assert isinstance(order, int)
    for _ in range(order):
        rate = derivative(rate, term.letter)
    return rate if place == term.letter else substituted(rate, {term.letter: place})


def derivative(term: Term, x: str) -> Term:
    """The derivative by a letter, all others constant; Unknown for integrals and functions without a rule."""
    if x not in letters(term):
        return 0
    match term:
        case str():
            return 1
        case Sum() | Minus():
            return node(term.tag, *(derivative(part, x) for part in term[1:]))  # type: ignore[arg-type]
        case Product(terms=factors):
            rates = [(k, derivative(part, x)) for k, part in enumerate(factors) if x in letters(part)]
            return node("+", *(node("*", *factors[:k], rate, *factors[k + 1 :]) for k, rate in rates))
        case Quotient(top=top, bottom=bottom):
            if x not in letters(bottom):
                return node("/", derivative(top, x), bottom)
            gain, loss = node("*", derivative(top, x), bottom), node("*", top, derivative(bottom, x))
            return node("/", node("+", gain, node("-", loss)), node("^", bottom, 2))
        case Power(base=base, exponent=n):
            return node("*", n, node("^", base, n - 1), derivative(base, x))
        case Value(tag="pow", arguments=(base, exponent)):
            first, second = node("/", node("*", exponent, derivative(base, x)), base), derivative(exponent, x)
            return node("*", term, first if second == 0 else node("+", first, node("*", node("log", base), second)))
        case Value(arguments=(inner,)):
            return node("*", _outer(term, inner), derivative(inner, x))
        case Call(function=f, orders=orders, arguments=arguments):
            steps = [tuple(n + (i == k) for i, n in enumerate(orders)) for k in range(len(orders))]
            chain = zip(steps, [derivative(t, x) for t in arguments], strict=True)
            return node("+", *(node("*", node("call", f, step, *arguments), rate) for step, rate in chain if rate != 0))
        case Binder(tag="diff"):
            return derivative(differentiated(term), x)
    raise Unknown(f"the derivative of {term!r}")


def _outer(term: Node, inner: Term) -> Term:
    """The derivative of a known function at its argument."""
    square = node("^", inner, 2)
    match term.tag:
        case "sin":
            return node("cos", inner)
        case "cos":
            return node("-", node("sin", inner))
        case "tan":
            return node("^", node("cos", inner), -2)
        case "sqrt":
            return node("/", 1, node("*", 2, term))
        case "log":
            return node("/", 1, inner)
        case "exp":
            return term
        case "arctan":
            return node("/", 1, node("+", 1, square))
    raise Unknown(f"the derivative of {term!r}")


def polynomial_in(term: Term, *atoms: Term) -> bool:
    """Whether the term is a polynomial in the atoms (x, or sin x and cos x) over what is free of their letters."""
    taken = set().union(*map(letters, atoms))
    if term in atoms or not letters(term) & taken:
        return True
    match term:
        case Sum() | Product() | Minus():
            return all(polynomial_in(part, *atoms) for part in term[1:])  # type: ignore[arg-type]
        case Quotient(top=top, bottom=bottom):
            return polynomial_in(top, *atoms) and not letters(bottom) & taken
        case Power(base=base, exponent=n):
            return n >= 0 and polynomial_in(base, *atoms)
    return False
