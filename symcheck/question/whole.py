"""What is known of whole numbers in sines and cosines: the sine of so many half turns is zero."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import combinations

from symcheck.core.calculus import letters
from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Problem
from symcheck.core.terms import PI, Formula, Node, Relation, T, Term, mapped, node
from symcheck.question.jets import parts

WHOLE = "whole"  # the name of the condition that letters are whole numbers
_TURNING = ("sin", "cos")


def with_half_turns(problem: Problem, names: Iterable[str]) -> Problem | None:
    """The problem with sin(pi n) = 0 for its whole numbers n and sums in angles written out; None if it has neither."""
    trees = [problem.claim, *(f for _, fs in problem.hypotheses for f in fs), *(t for _, t in problem.definitions)]
    free = set().union(*map(letters, trees)).difference(name for name, _ in problem.definitions)
    whole = sorted(free & {*names})
    if not whole or not any(part.tag in _TURNING for tree in trees for part in parts(tree)):
        return None
    said = (*(node("=", node("sin", node("*", PI, x)), 0) for x in whole), *_positive(problem))
    hypotheses = tuple((name, tuple(map(_parted, formulas))) for name, formulas in problem.hypotheses)
    definitions = tuple((name, _parted(term)) for name, term in problem.definitions)
    return replace(
        problem, claim=_parted(problem.claim), hypotheses=(*hypotheses, (WHOLE, said)), definitions=definitions
    )


def _positive(problem: Problem) -> Iterator[Formula]:
    """Of numbers that are not negative, those from 1 on are positive, and so is the sum of two different ones."""
    stated = {formula for _, formulas in problem.hypotheses for each in formulas for formula in conjuncts(each)}
    lowest = dict(sorted(pair for formula in stated for pair in _low(formula)))  # the greatest of several
    yield from (node(">", x, 0) for x, low in lowest.items() if low > 0)
    for x, y in combinations(lowest, 2):
        if {node("!=", x, y), node("!=", y, x)} & stated:
            yield node(">", node("+", x, y), 0)


def _low(formula: Formula) -> Iterator[tuple[str, int]]:
    match formula:
        case Relation(tag=">=" | ">", terms=(str(x), int(low))) | Relation(tag="<=" | "<", terms=(int(low), str(x))):
            if low >= 0:
                yield x, low


def _parted(tree: T) -> T:
    """The same with the angle pi (n + 1) as pi n + pi."""
    if not isinstance(tree, Node):
        return tree
    new = mapped(tree, _parted)
    if new.tag in _TURNING:
        return node(new.tag, _spread(new.outside[0]))  # type: ignore[return-value]
    return new  # type: ignore[return-value]


def _spread(angle: Term) -> Term:
    """A product with one sum among its factors as a sum of products."""
    if isinstance(angle, Node) and angle.tag == "*":
        sums = [k for k, factor in enumerate(angle.outside) if isinstance(factor, Node) and factor.tag == "+"]
        if len(sums) == 1:
            (k,) = sums
            before, after = angle.outside[:k], angle.outside[k + 1 :]
            return node("+", *(node("*", *before, addend, *after) for addend in angle.outside[k].outside))  # type: ignore[union-attr]
    return angle
