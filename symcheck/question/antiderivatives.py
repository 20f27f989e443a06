"""Hints about integrals and sums that SymPy works out: the proof then has to differentiate, or to take the step."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from symcheck.core.calculus import is_entire, nodes, substituted
from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import Binder, End, Node, Term, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.question.improper import improper
from symcheck.question.limit import OutOfTime, limited
from symcheck.reading import from_sympy, to_sympy

if TYPE_CHECKING:
    from sympy import Expr, Piecewise

THEOREMS = {"integral": ("antiderivative", "antiderivative_everywhere"), "sum": ("telescope",)}
# what SymPy raises for what it cannot do
FAULTS = (ArithmeticError, ValueError, TypeError, AttributeError, NotImplementedError, RecursionError)
SECONDS = 2.0  # for one integral: those that SymPy finds at all it finds in one


def hinted(problem: Problem) -> Problem:
    """The problem with hints for the integrals and sums to numbers or letters, the outer ones before those in them."""
    trees = [problem.claim, *(f for _, fs in problem.hypotheses for f in fs), *(t for _, t in problem.definitions)]
    found = dict.fromkeys(each for tree in trees for each in _binders(tree))
    hints = [hint for each in found for hint in _hints(each)[1]]
    return replace(problem, hints=(*problem.hints, *hints)) if hints else problem


def _binders(tree: Term) -> Iterator[Binder]:
    """Those that stand under no other."""
    if not isinstance(tree, Node):
        return
    if isinstance(tree, Binder) and tree.tag in THEOREMS:
        yield tree
    for part in tree.outside:
        yield from _binders(part)


def _is_finite(binder: Binder) -> bool:
    return not any(isinstance(end, End) for end in binder.outside)


def _hints(binder: Binder) -> tuple[Term, list[Applied[Term]]]:
    """What an integral or sum is, with the theorems that say so; itself and none if that is not found."""
    inner: list[Applied[Term]] = []

    def known(tree: Term) -> Term:
        """The same without the integrals and sums that stand in it."""
        if isinstance(tree, Binder):
            value, more = _hints(tree) if tree.tag in THEOREMS and _is_finite(tree) else (tree, [])
            inner.extend(more)
            return value
        return mapped(tree, known) if isinstance(tree, Node) else tree

    body = known(binder.body)
    own = (binder.letter,)
    if not _is_finite(binder):
        return binder, [*_improper(binder), *inner]
    if (closed := _closed(binder, body)) is None:
        return binder, [*_improper(binder), *inner]
    names = THEOREMS[binder.tag]
    if binder.tag == "integral" and is_entire(body, binder.letter) and is_entire(closed, binder.letter):
        names = names[1:]  # then the order of the ends does not matter
    outer = [Applied(name, tuple(binder.outside), ((own, binder.body), (own, closed))) for name in names]
    low, high = binder.outside
    at = [substituted(closed, {binder.letter: end}) for end in (high, low)]
    value = node("+", at[0], node("-", at[1])) if binder.tag == "integral" else at[0]
    powers = any(part.tag == "pow" for part in nodes(binder.body))
    return value, [*outer, *(_improper(binder) if powers else ()), *inner]


def _improper(binder: Binder) -> list[Applied[Term]]:
    import sympy  # noqa: F401 (an import that is interrupted by the limit would leave it broken)

    try:
        with limited(SECONDS):
            return improper(binder.body, binder.letter, *binder.outside) if binder.tag == "integral" else []
    except (SymcheckError, OutOfTime, *FAULTS):
        return []


def _closed(binder: Binder, body: Term) -> Term | None:
    """The antiderivative of a body, or its sum up to a letter, if SymPy finds it."""
    import sympy

    x = sympy.Symbol(binder.letter, real=True)
    try:
        with limited(SECONDS):
            if binder.tag == "integral":
                found = sympy.integrate(to_sympy(body), x)
            else:
                found = sympy.summation(to_sympy(body), (x, to_sympy(binder.outside[0]), x))
            if isinstance(found, sympy.Piecewise):
                found = _generic(found)  # the proof shows whether it is so
            if found.has(sympy.Integral, sympy.Sum, sympy.Piecewise):
                return None
            return from_sympy(found)
    except (SymcheckError, OutOfTime, *FAULTS):
        return None


def _generic(found: Piecewise) -> Expr:
    """The piece for letters without special values."""
    import sympy

    primes = map(sympy.prime, range(5, 5 + len(found.free_symbols)))
    somewhere = dict(zip(sorted(found.free_symbols, key=str), map(sympy.sqrt, primes), strict=True))
    pieces = (piece.expr for piece in found.args if piece.cond.subs(somewhere) == sympy.true)
    return next(pieces, found.args[0].expr)
