"""Denominators written out: what is proved may rest on their factors, which a defined letter hides."""

from __future__ import annotations

from dataclasses import replace

from symcheck.core.calculus import letters
from symcheck.core.problems import Problem
from symcheck.core.terms import Node, T, Value, mapped, node
from symcheck.proof.algebra.polynomial import unfold


def with_plain_divisors(problem: Problem) -> Problem:
    """The same problem, defined letters in denominators unfolded."""
    meant = dict(problem.definitions)

    def plain(tree: T) -> T:
        if not isinstance(tree, Node):
            return tree
        new = mapped(tree, plain)
        match new:
            case Value(tag="/", terms=(top, bottom)) if letters(bottom) & meant.keys():
                return node("/", top, unfold(bottom, meant))  # type: ignore[return-value]
        return new  # type: ignore[return-value]

    return replace(
        problem,
        claim=plain(problem.claim),
        definitions=tuple((name, plain(term)) for name, term in problem.definitions),
        hypotheses=tuple((name, tuple(map(plain, formulas))) for name, formulas in problem.hypotheses),
    )
