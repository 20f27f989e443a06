"""Hints for proofs about integrals: an antiderivative that SymPy finds, which the proof then has to differentiate."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import Binder, End, Node, Term
from symcheck.core.verdicts import SymcheckError
from symcheck.question.limit import OutOfTime, limited
from symcheck.reading import from_sympy, to_sympy

SECONDS = 2.0  # for one integral: those that SymPy finds at all it finds in one


def hinted(problem: Problem) -> Problem:
    """The problem with hints for the integrals between numbers or letters that stand under no other binder."""
    trees = [problem.claim, *(f for _, fs in problem.hypotheses for f in fs), *(t for _, t in problem.definitions)]
    found = dict.fromkeys(each for tree in trees for each in _integrals(tree))
    hints = [hint for each in found for hint in _hints(each)]
    return replace(problem, hints=(*problem.hints, *hints)) if hints else problem


def _integrals(tree: Term) -> Iterator[Binder]:
    if not isinstance(tree, Node):
        return
    if isinstance(tree, Binder) and tree.tag == "integral" and not any(isinstance(end, End) for end in tree.outside):
        yield tree
    for part in tree.outside:
        yield from _integrals(part)


def _hints(integral: Binder) -> list[Applied[Term]]:
    """The theorems that say what the integral is, if an antiderivative is found."""
    import sympy

    x = sympy.Symbol(integral.letter, real=True)
    try:
        with limited(SECONDS):
            found = sympy.integrate(to_sympy(integral.body), x)
            if found.has(sympy.Integral, sympy.Piecewise):
                return []
            primitive = from_sympy(found)
    except (
        SymcheckError,
        OutOfTime,
        ArithmeticError,
        ValueError,
        TypeError,
        AttributeError,
        NotImplementedError,
        RecursionError,
    ):
        return []
    own = (integral.letter,)
    ends, functions = tuple(integral.outside), ((own, integral.body), (own, primitive))
    return [Applied(name, ends, functions) for name in ("antiderivative", "antiderivative_everywhere")]
