"""Conjunctions and equivalences, part by part."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

from symcheck.core.terms import Formula, node
from symcheck.proof.algebra.knowledge import Knowledge
from symcheck.proof.rules.step import Prove, Step


@dataclass(frozen=True)
class Each(Step):
    """All parts of an "and", both directions of an equivalence."""

    rule: ClassVar[str] = "each"
    parts: tuple[Step, ...]


def all_of(goal: Formula, known: Knowledge, prove: Prove) -> Each | None:
    """The proof of an "and" or an equivalence if each part has one."""
    parts = goal.formulas
    if goal.tag == "<=>":
        parts = node("=>", *parts), node("=>", *parts[::-1])
    proofs = prove_all(parts, known, prove)
    return None if proofs is None else Each(proofs)


def prove_all(formulas: Iterable[Formula], known: Knowledge, prove: Prove) -> tuple[Step, ...] | None:
    """The proofs of all formulas; none is looked for after one that is missing."""
    proofs: list[Step] = []
    for formula in formulas:
        if (proof := prove(formula, known)) is None:
            return None
        proofs.append(proof)
    return tuple(proofs)
