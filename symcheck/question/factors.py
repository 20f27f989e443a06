"""Factors that an integrand shares for all values of its letter, before the integral.

That an integral is linear is no part of the certificates: beneath the integral it would have to be shown, at each point
too, that gamma functions in a denominator are not zero.
"""

from __future__ import annotations

from dataclasses import replace

from symcheck.core.calculus import letters, nodes
from symcheck.core.problems import Problem
from symcheck.core.terms import Binder, Node, T, Term, Value, mapped, node
from symcheck.proof.algebra.polynomial import unfold
from symcheck.question.prepare import rooted


def with_factors_outside(problem: Problem) -> Problem:
    """The same with gamma functions and powers before the integrals under which they stand as factors."""
    meant = dict(problem.definitions)

    def put(tree: T) -> T:
        if not isinstance(tree, Node):
            return tree
        new = mapped(tree, put)
        if isinstance(new, Binder) and new.tag == "integral":
            whole = unfold(new.body, meant)
            outside, inside = _apart(body := _multiplied_out(whole), new.letter)
            if any(part.tag in ("gamma", "pow") for part in nodes(outside)):
                rest = node("integral", inside, new.letter, *new.outside)
                return node("*", rooted(outside), rest)  # type: ignore[return-value]
            if body != whole:
                return node("integral", body, new.letter, *new.outside)  # type: ignore[return-value]
        return new  # type: ignore[return-value]

    hypotheses = tuple((name, tuple(map(put, formulas))) for name, formulas in problem.hypotheses)
    return replace(problem, claim=put(problem.claim), hypotheses=hypotheses)


def _apart(body: Term, x: str) -> tuple[Term, Term]:
    """Two factors of a term: one that is free of a letter, and the rest."""
    if x not in letters(body):
        return body, 1
    match body:
        case Value(tag="-", terms=(inner,)):
            outside, rest = _apart(inner, x)
            return outside, node("-", rest)
        case Value(tag="*", terms=factors):
            pairs = [_apart(factor, x) for factor in factors]
            outsides, rests = ([each for each in side if each != 1] for side in zip(*pairs, strict=True))
            return _product(outsides), _product(rests)
        case Value(tag="/", terms=(top, bottom)):
            (above, first), (below, second) = _apart(top, x), _apart(bottom, x)
            return node("/", above, below) if below != 1 else above, node("/", first, second) if second != 1 else first
    return 1, body


def _multiplied_out(tree: T) -> T:
    """Whole powers of absolute values, exponentials, powers and products of such as exponentials and powers."""
    if not isinstance(tree, Value) or tree.tag not in ("*", "/", "^", "-"):
        return tree
    new = mapped(tree, _multiplied_out)
    match new:
        case Value(tag="^", terms=(Value(tag="sqrt", terms=(Value(tag="^", terms=(base, 2)),)), 2)):
            return _multiplied_out(node("^", base, 2))  # type: ignore[return-value]
        case Value(tag="^", terms=(Value(tag="exp", terms=(exponent,)), int(n))):
            return node("exp", node("*", n, exponent))  # type: ignore[return-value]
        case Value(tag="^", terms=(Value(tag="pow", terms=(base, exponent)), int(n))):
            return node("pow", base, node("*", n, exponent))  # type: ignore[return-value]
        case Value(tag="^", terms=(Value(tag="*", terms=factors), int(n))):
            powers = (_multiplied_out(node("^", factor, n)) for factor in factors)
            if any(isinstance(factor, Value) and factor.tag in ("exp", "pow") for factor in factors):
                return node("*", *powers)  # type: ignore[return-value]
    return new  # type: ignore[return-value]


def _product(factors: list[Term]) -> Term:
    return node("*", *factors) if factors[1:] else factors[0] if factors else 1
