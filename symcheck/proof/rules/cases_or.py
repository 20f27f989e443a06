"""A goal in every case of a disjunction that is known."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

from symcheck.core.terms import Formula
from symcheck.proof.algebra.facts import Reference
from symcheck.proof.algebra.knowledge import Knowledge
from symcheck.proof.algebra.place import Place
from symcheck.proof.rules.step import Attempt, Prove, Search, Step


@dataclass(frozen=True)
class CasesOr(Step):
    """The goal in every case of a fact that is a disjunction."""

    rule: ClassVar[str] = "cases_or"
    or_: Reference
    cases: tuple[Step, ...]


def in_cases(goal: Formula, ref: Reference, parts: Sequence[Formula], known: Knowledge, prove: Prove) -> CasesOr | None:
    """The proof of a goal if it has one under each part of a disjunction."""
    cases: list[Step] = []
    for part in parts:
        if (proof := prove(goal, known.assume(part))) is None:
            return None
        cases.append(proof)
    return CasesOr(ref, tuple(cases))


def split_disjunction(goal: Formula, place: Place, search: Search) -> Attempt:
    """By the first disjunction that is open."""
    known = place.known
    if not known.pending:
        return None, False
    ref, disjunction = known.pending[0]
    rest = replace(known, pending=known.pending[1:])
    return in_cases(goal, ref, disjunction.formulas, rest, lambda goal, below: search(goal, below, place)), True
