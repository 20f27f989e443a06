"""A disjunction by one of its parts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from symcheck.core.terms import Formula
from symcheck.proof.algebra.knowledge import Knowledge
from symcheck.proof.rules.step import Prove, Step


@dataclass(frozen=True)
class Choose(Step):
    """One part of an "or"."""

    rule: ClassVar[str] = "choose"
    index: int
    then: Step


def first_of(goal: Formula, known: Knowledge, prove: Prove) -> Choose | None:
    """The proof of an "or" by the first part that has one."""
    for index, part in enumerate(goal.formulas):
        if (then := prove(part, known)) is not None:
            return Choose(index, then)
    return None
