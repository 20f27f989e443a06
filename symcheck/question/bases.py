"""Letters that stand in exponents of e alone, as t in a moment generating function: then e^t is a positive letter."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from math import lcm
from typing import TYPE_CHECKING

from symcheck.core.calculus import fresh, functions, letters, nodes, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import Binder, Formula, Node, Relation, T, Term, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.proof.algebra.polynomial import number_of
from symcheck.question.series import FAULTS
from symcheck.reading import from_sympy, to_sympy

if TYPE_CHECKING:
    from sympy import Expr

BASE = "base"  # the name of the condition that it is positive


@dataclass(frozen=True)
class Based:
    """A problem with a letter for e^t, and what it stands for.

    Parameters
    ----------
    problem
        The problem.
    name, letter
        The letter, and the exponent of e for which it stands.
    whole
        Whether all conditions are those of the letter, so that what is false of it is false.
    """

    problem: Problem
    name: str
    letter: str
    whole: bool


def with_base(problem: Problem) -> Based | None:
    """The problem about a sum with a letter for e^t; None if no letter stands in exponents alone.

    Where t stands there in one product alone, as in n t u with the index n, the letter is for e^(tu).
    """
    sums = [part for part in nodes(problem.claim) if isinstance(part, Binder) and part.tag == "sum"]
    if not sums or problem.definitions or functions(problem.claim):
        return None
    running = {each.letter for each in sums}
    inside = {x for each in sums for part in nodes(each.body) if part.tag == "exp" for x in letters(part)}
    taken = letters(problem.claim).union(*(letters(f) for _, fs in problem.hypotheses for f in fs))
    positive = {x for _, fs in problem.hypotheses for f in fs for x in _positive(f)}
    for t in sorted(inside - running):
        with suppress(*FAULTS):
            base = _Base(t, fresh(f"e_{t}", taken), _common(problem.claim, t, running))
            base = replace(base, parts=lcm(*base.denominators(problem.claim)))
            claim, known = base.put(problem.claim), base.times <= positive
            given = [(label, [base.ordered(base.put(f), known=known) for f in fs]) for label, fs in problem.hypotheses]
            kept = tuple((label, tuple(f for f in fs if t not in letters(f))) for label, fs in given)
            whole = known and all(t not in letters(f) for _, fs in given for f in fs)  # e^0 alone may be all it is
            hypotheses = (*((label, fs) for label, fs in kept if fs), (BASE, (node(">", base.name, 0),)))
            if t not in letters(claim):
                return Based(replace(problem, claim=claim, hypotheses=hypotheses), base.name, base.exponent, whole)
    return None


def _positive(formula: Formula) -> Iterator[str]:
    """The letter that a condition says to be positive, as it says of x or of 2 x."""
    match formula:
        case Relation(tag=">", terms=(side, 0)) | Relation(tag="<", terms=(0, side)):
            match side:
                case str():
                    yield side
                case Node(tag="*", outside=(int(number), str(x))) if number > 0:
                    yield x


def _common(tree: Term, t: str, running: set[str]) -> frozenset[str]:
    """The letters by which t is multiplied in all exponents, but for the indices of sums."""
    found = list[set[str]]()
    for exponent in _exponents(tree, t):
        found.append({x for x in letters(exponent) - running - {t} if _is_factor(exponent, x)})
    return frozenset(set.intersection(*found)) if found else frozenset()


def _exponents(tree: Term, t: str) -> Iterator[Term]:
    """The exponents of e with a letter, but for those with others in them."""
    if not isinstance(tree, Node) or t not in letters(tree):
        return
    inner = [exponent for part in (*tree.inside, *tree.outside) for exponent in _exponents(part, t)]
    yield from inner or (tree.outside if tree.tag == "exp" else ())


def _is_factor(term: Term, x: str) -> bool:
    """Is a term a letter times something in which it does not occur?"""
    match term:
        case str():
            return term == x
        case Node(tag="*", outside=factors):
            return sum(x in letters(each) for each in factors) == 1 and any(_is_factor(each, x) for each in factors)
        case Node(tag="/", outside=(top, bottom)):
            return x not in letters(bottom) and _is_factor(top, x)
        case Node(tag="-", outside=(inner,)):
            return _is_factor(inner, x)
        case Node(tag="+", outside=addends):
            return all(_is_factor(each, x) for each in addends)
    return False


@dataclass(frozen=True)
class _Base:
    """A letter for e to the power of t, times others, over a number."""

    t: str
    name: str
    times: frozenset[str]
    parts: int = 1

    @property
    def exponent(self) -> str:
        """The exponent, as it is shown."""
        product = " ".join((self.t, *sorted(self.times)))
        product = f"{product}/{self.parts}" if self.parts > 1 else product
        return product if product == self.t else f"({product})"

    def angle(self, exponent: Term) -> tuple[Expr, Expr]:
        """By what the exponent of the letter is multiplied in another one, and what is added to it there."""
        import sympy

        own = sympy.Symbol(self.t, real=True)
        angle = sympy.expand(to_sympy(substituted(exponent, dict.fromkeys(self.times, 1))))
        times, rest = self.parts * sympy.diff(angle, own), angle.subs(own, 0)
        if times.has(own) or (rest != 0 and self.times):
            raise SymcheckError("no multiple of the letter")
        return times, rest

    def denominators(self, tree: Term) -> Iterator[int]:
        """The numbers by which exponents are divided."""
        import sympy

        for exponent in _exponents(tree, self.t):
            yield from (int(number.q) for number in self.angle(exponent)[0].atoms(sympy.Rational))

    def put(self, tree: T) -> T:
        """The same with powers of the letter for exponentials of multiples of t."""
        if not isinstance(tree, Node):
            return tree
        new = mapped(tree, self.put)
        if new.tag != "exp" or self.t not in letters(new):
            return new  # type: ignore[return-value]
        times, rest = self.angle(new.outside[0])
        power: Term = node("pow", self.name, from_sympy(times)) if times != 1 else self.name
        power = node("^", self.name, int(times)) if times.is_Integer and times > 1 else power
        return power if rest == 0 else node("*", power, node("exp", from_sympy(rest)))  # type: ignore[return-value]

    def ordered(self, formula: Formula, *, known: bool) -> Formula:
        """A condition that compares t with 0 as one of the exponential, where the other factors are known positive."""
        if isinstance(formula, Relation) and self.t in formula.terms and any(number_of(x) == 0 for x in formula.terms):
            return node(formula.tag, *(self.name if x == self.t else 1 for x in formula.terms)) if known else formula
        return formula
