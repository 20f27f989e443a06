"""What is computed at a point where letters have values, and what is proved there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from symcheck.core.calculus import substituted
from symcheck.core.formulas import FALSE, conjuncts
from symcheck.core.terms import Formula, Node, Term, node
from symcheck.proof.algebra.facts import Assumed, Coordinate, Hypothesis, Reference
from symcheck.proof.rules.have import Have
from symcheck.proof.rules.step import Step

AT_POINT = "point"  # the name of the hypotheses that say which values letters have


@dataclass(frozen=True)
class Compute(Step):
    """A formula about letters that have values here; values of functions are facts."""

    rule: ClassVar[str] = "compute"
    values: tuple[Reference, ...]


@dataclass(frozen=True)
class Point:
    """Values of letters, and what is known there: by computing, by digits or by proofs.

    A proof may refer to the values as hypotheses of the name AT_POINT, followed by the facts, each with its proof.
    """

    values: Mapping[str, Term]
    sides: tuple[Term | bool, ...] = ()  # what the sides of a claim are, or whether its parts are true
    calls: tuple[tuple[Term, Term], ...] = ()  # values of unknown functions
    functions: tuple[tuple[Term, Term, Step], ...] = ()  # values of other functions, with their proofs
    enclosed: tuple[tuple[Term, Term, Term], ...] = ()  # numbers, with decimals below and above
    facts: tuple[tuple[Formula, Step], ...] = ()
    proof: Step | None = None

    def where(self) -> Point:
        """The point alone, without what is shown at it."""
        return Point(self.values, calls=self.calls, functions=self.functions)

    def certificate(self, claim: Formula | None = None) -> dict[str, object]:
        """The point with the proofs that go with it, and what is shown of the claim there."""
        values = dict(self.values)
        for _ in values:  # coordinates may be given by others
            values = {x: substituted(value, values) for x, value in values.items()}
        shown = [_valued(*pair) for pair in zip(claim.outside, self.sides, strict=False)] if claim else []
        shown += [node("and", node("<=", low, t), node("<=", t, high)) for t, low, high in self.enclosed]
        known = [(node("=", substituted(t, values), value), why) for t, value, why in self.functions]
        known += self.facts
        named = {"shown": shown, "calls": self.calls, "proof": self._last([*known], len(values))}
        return {"values": dict(sorted(values.items()))} | {name: part for name, part in named.items() if part}

    def _last(self, known: list[tuple[Formula, Step]], own: int) -> Step | None:
        """The proof at the point: what is known there is proved first."""
        if not known and self.proof is None:
            return None
        counts = [len(conjuncts(formula)) for formula, _ in known]
        told = (
            Assumed(sum(counts[:k])) for k, (formula, _) in enumerate(known) if formula.tag in ("=", "forall", "or")
        )
        then: Step = Compute(tuple(told))
        if self.proof is not None:
            then = _numbered(self.proof, own, sum(counts))
        for k, (formula, why) in reversed([*enumerate(known)]):
            then = Have(formula, _numbered(why, own, sum(counts[:k])), then)
        return then


def _numbered(proof: Step, own: int, facts: int) -> Step:
    """The proof after so many facts; what it takes for a hypothesis is one of the point's own values, or a fact."""

    def change(ref: Reference) -> Reference:
        match ref:
            case Hypothesis(name, k) if name == AT_POINT:
                return Coordinate(k) if k < own else Assumed(k - own)
            case Assumed(k):
                return Assumed(k + facts)
        return ref

    return proof.mapped(change)


def _valued(side: Term, value: Term | bool) -> Formula:
    """That a side of a claim has a value there; one that is a formula is true or false."""
    if not isinstance(value, bool):
        return node("=", side, value)
    assert isinstance(side, Node)
    return side if value else node("=>", side, FALSE)
