"""What is proved once may be used often."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar, NamedTuple

from symcheck.core.formulas import sides
from symcheck.core.terms import Formula, Term
from symcheck.proof.rules.step import Step
from symcheck.proof.rules.theorem import Said


@dataclass(frozen=True)
class Have(Step):
    """A formula with its proof, and what follows from it."""

    rule: ClassVar[str] = "have"
    formula: Formula
    proof: Step
    then: Step

    def speaks_of(self, definitions: Mapping[str, Term]) -> Iterable[Term]:
        return sides(self.formula)


class Lemma(NamedTuple):
    """A formula to be proved and then used, as theorems are."""

    formula: Formula

    def said(self, definitions: Mapping[str, Term]) -> Said:
        return Said([self.formula], self.formula)

    def step(self, premises: Sequence[Step], then: Step) -> Have:
        (proof,) = premises
        return Have(self.formula, proof, then)
