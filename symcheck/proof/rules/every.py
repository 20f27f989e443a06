"""What is so of all, as it is of new letters."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import ClassVar, Self

from symcheck.core.terms import Term
from symcheck.proof.rules.step import Step


@dataclass(frozen=True)
class Every(Step):
    """Something is so of all, as it is of new letters."""

    rule: ClassVar[str] = "every"
    letters: tuple[str, ...]
    then: Step

    def at(self, mean: Mapping[str, Term]) -> Self:
        return replace(self, then=self.then.at({x: term for x, term in mean.items() if x not in self.letters}))
