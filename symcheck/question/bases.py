"""Letters that stand in exponents of e alone, as t in a moment generating function: then e^t is a positive letter."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, replace

from symcheck.core.calculus import fresh, functions, letters, nodes
from symcheck.core.problems import Problem
from symcheck.core.terms import Binder, Formula, Node, Relation, T, Term, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.proof.algebra.polynomial import number_of
from symcheck.question.series import FAULTS
from symcheck.reading import from_sympy, to_sympy

BASE = "base"  # the name of the condition that it is positive


@dataclass(frozen=True)
class Based:
    """A problem with a letter for e^t, and what it stands for.

    Parameters
    ----------
    problem
        The problem.
    name, letter
        The letter, and t.
    whole
        Whether all conditions are those of the letter, so that what is false of it is false.
    """

    problem: Problem
    name: str
    letter: str
    whole: bool


def with_base(problem: Problem) -> Based | None:
    """The problem about a sum with a letter for e^t; None if no letter stands in exponents alone."""
    sums = [part for part in nodes(problem.claim) if isinstance(part, Binder) and part.tag == "sum"]
    if not sums or problem.definitions or functions(problem.claim):
        return None
    inside = {x for each in sums for part in nodes(each.body) if part.tag == "exp" for x in letters(part)}
    for t in sorted(inside - {each.letter for each in sums}):
        with suppress(*FAULTS):
            taken = letters(problem.claim).union(*(letters(f) for _, fs in problem.hypotheses for f in fs))
            name = fresh(f"e_{t}", taken)
            claim = _put(problem.claim, t, name)
            given = [(label, [_ordered(_put(f, t, name), t, name) for f in fs]) for label, fs in problem.hypotheses]
            kept = tuple((label, tuple(f for f in fs if t not in letters(f))) for label, fs in given)
            whole = all(t not in letters(f) for _, fs in given for f in fs)
            hypotheses = (*((label, fs) for label, fs in kept if fs), (BASE, (node(">", name, 0),)))
            if t not in letters(claim):
                return Based(replace(problem, claim=claim, hypotheses=hypotheses), name, t, whole)
    return None


def _put(tree: T, t: str, name: str) -> T:
    """The same with powers of a letter for exponentials of multiples of t."""
    import sympy

    if not isinstance(tree, Node):
        return tree
    new = mapped(tree, lambda part: _put(part, t, name))
    if new.tag != "exp" or t not in letters(new):
        return new  # type: ignore[return-value]
    own, angle = sympy.Symbol(t, real=True), sympy.expand(to_sympy(new.outside[0]))
    times, rest = sympy.diff(angle, own), angle.subs(own, 0)
    if times.has(own):
        raise SymcheckError("no multiple of the letter")
    power: Term = node("pow", name, from_sympy(times)) if times != 1 else name
    power = node("^", name, int(times)) if times.is_Integer and times > 1 else power
    return power if rest == 0 else node("*", power, node("exp", from_sympy(rest)))  # type: ignore[return-value]


def _ordered(formula: Formula, t: str, name: str) -> Formula:
    """A condition that compares t with 0 as one of e^t."""
    if isinstance(formula, Relation) and t in formula.terms and any(number_of(x) == 0 for x in formula.terms):
        return node(formula.tag, *(name if x == t else 1 for x in formula.terms))
    return formula
