"""What is answered to a question: the verdict with its evidence."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from symcheck.core.certificates import Certificate, MatrixProof


class Status(StrEnum):
    """What can be said of a formula."""

    PROVED = "proved"
    REFUTED = "refuted"
    UNDECIDED = "undecided"
    VACUOUS = "vacuous"
    AMBIGUOUS = "ambiguous"
    UNREADABLE = "unreadable"


@dataclass(frozen=True)
class Answer:
    """The answer to one question.

    Parameters
    ----------
    verdict
        What was found.
    reading
        LaTeX of what was understood, with all brackets; one for each reading of an ambiguous relation.
    letters
        What each letter was taken for, and why.
    used
        The definitions and conditions on which the verdict rests.
    counterexample
        Values of the letters at which the relation fails.
    values
        What is shown of both sides there.
    certificate
        What the checker accepts as evidence: one for each component.
    repairs
        Relations that are one slip of the pen away and are proved.
    reason
        Why nothing was decided, in one sentence.
    seconds
        How long it took.
    """

    verdict: Status
    reading: str = ""
    letters: dict[str, str] = field(default_factory=dict)
    used: tuple[str, ...] = ()
    counterexample: dict[str, str] = field(default_factory=dict)
    values: tuple[str, ...] = ()
    certificate: tuple[Certificate | MatrixProof, ...] = ()
    repairs: tuple[dict[str, str], ...] = ()
    reason: str = ""
    seconds: float = 0.0

    def as_json(self) -> dict[str, Any]:
        """The answer as JSON data."""
        return {key: getattr(self, key) for key in self.__dataclass_fields__}
