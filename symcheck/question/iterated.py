"""Integrals in integrals, between numbers and letters, by their values: each is a claim of its own.

A claim about several of them is proved or refuted faster with the values in their places.
"""

from __future__ import annotations

from dataclasses import replace

from symcheck.core.calculus import functions, nodes
from symcheck.core.problems import Problem
from symcheck.core.terms import Binder, End, Term, node
from symcheck.question.antiderivatives import outermost, value_of
from symcheck.question.series import Series, put
from symcheck.question.whole_powers import inlined


def with_values(problem: Problem) -> Series | None:
    """The problem with values for integrals of integrals; None if there are none, or one has no value that is found."""
    if not any(
        _is_iterated(part) for tree in (problem.claim, *(t for _, t in problem.definitions)) for part in nodes(tree)
    ):
        return None
    plain = inlined(problem)
    found = [part for part in dict.fromkeys(outermost(plain.claim)) if _is_iterated(part)]
    if not found or functions(plain.claim):
        return None
    values: dict[Term, Term] = {part: value_of(part) for part in found}
    if any(part.tag in ("integral", "sum") for part in nodes(*values.values())):
        return None
    sides = tuple(replace(plain, claim=node("=", part, value)) for part, value in values.items())
    return Series(replace(plain, claim=put(plain.claim, values)), sides)


def _is_iterated(part: Term) -> bool:
    """Is it an integral between two ends of what has such an integral in it?"""
    if not isinstance(part, Binder) or part.tag != "integral" or any(isinstance(end, End) for end in part.outside):
        return False
    return any(inner.tag == "integral" for inner in nodes(part.body))
