"""What is so of all, as it is of new letters."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from symcheck.proof.rules.step import Step


@dataclass(frozen=True)
class Every(Step):
    """Something is so of all, as it is of new letters."""

    rule: ClassVar[str] = "every"
    letters: tuple[str, ...]
    then: Step
