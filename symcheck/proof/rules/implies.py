"""Implications under their premise, and relations by way of their contrary."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from symcheck.core.formulas import FALSE, contrary
from symcheck.core.terms import Formula
from symcheck.proof.algebra.knowledge import Knowledge
from symcheck.proof.rules.step import Prove, Step


@dataclass(frozen=True)
class Implies(Step):
    """A => B under A. A relation, as its contrary leads to a contradiction."""

    rule: ClassVar[str] = "implies"
    then: Step


def implication(goal: Formula, known: Knowledge, prove: Prove) -> Implies | None:
    """The proof of an implication."""
    premise, conclusion = goal.formulas
    then = prove(conclusion, known.assume(premise))
    return None if then is None else Implies(then)


def by_contrary(goal: Formula, known: Knowledge, refute: Prove) -> Implies | None:
    """The proof of a relation, if its contrary leads to a contradiction."""
    then = refute(FALSE, known.assume(contrary(goal)))
    return None if then is None else Implies(then)
