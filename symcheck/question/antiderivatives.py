"""Hints about integrals and sums that SymPy works out: the proof then has to differentiate, or to take the step."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import Binder, End, Node, Term
from symcheck.core.verdicts import SymcheckError
from symcheck.question.limit import OutOfTime, limited
from symcheck.reading import from_sympy, to_sympy

THEOREMS = {"integral": ("antiderivative", "antiderivative_everywhere"), "sum": ("telescope",)}
# what SymPy raises for what it cannot do
FAULTS = (ArithmeticError, ValueError, TypeError, AttributeError, NotImplementedError, RecursionError)
SECONDS = 2.0  # for one integral: those that SymPy finds at all it finds in one


def hinted(problem: Problem) -> Problem:
    """The problem with hints for the integrals and sums to numbers or letters that stand under no other binder."""
    trees = [problem.claim, *(f for _, fs in problem.hypotheses for f in fs), *(t for _, t in problem.definitions)]
    found = dict.fromkeys(each for tree in trees for each in _binders(tree))
    hints = [hint for each in found for hint in _hints(each)]
    return replace(problem, hints=(*problem.hints, *hints)) if hints else problem


def _binders(tree: Term) -> Iterator[Binder]:
    if not isinstance(tree, Node):
        return
    finite = isinstance(tree, Binder) and not any(isinstance(end, End) for end in tree.outside)
    if isinstance(tree, Binder) and finite and tree.tag in THEOREMS:
        yield tree
    for part in tree.outside:
        yield from _binders(part)


def _hints(binder: Binder) -> list[Applied[Term]]:
    """The theorems that say what the integral or sum is, if that is found."""
    import sympy

    x = sympy.Symbol(binder.letter, real=True)
    try:
        with limited(SECONDS):
            body = to_sympy(binder.body)
            if binder.tag == "integral":
                found = sympy.integrate(body, x)
            else:
                found = sympy.summation(body, (x, to_sympy(binder.outside[0]), x))
            if isinstance(found, sympy.Piecewise):
                found = found.args[0].expr  # where letters have no special values; the proof shows whether it is so
            if found.has(sympy.Integral, sympy.Sum, sympy.Piecewise):
                return []
            closed = from_sympy(found)
    except (SymcheckError, OutOfTime, *FAULTS):
        return []
    own = (binder.letter,)
    return [Applied(name, tuple(binder.outside), ((own, binder.body), (own, closed))) for name in THEOREMS[binder.tag]]
