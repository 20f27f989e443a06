"""What is answered to a question: the verdict with its evidence."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from enum import StrEnum
from functools import cached_property
from typing import Any

from msgspec import to_builtins

from symcheck.core.certificates import Certificate, MatrixProof
from symcheck.dimensions import Dimensions

SEEKING = ("slips", "measuring", "generalizing")  # the fields that look for what is asked for later
Slips = tuple[dict[str, str], ...]


class Status(StrEnum):
    """What can be said of a formula."""

    PROVED = "proved"
    REFUTED = "refuted"
    UNDECIDED = "undecided"
    VACUOUS = "vacuous"
    AMBIGUOUS = "ambiguous"
    UNREADABLE = "unreadable"


def _nothing() -> None:
    """What a formula measures that is not read, and the general form of one that is general."""


@dataclass(frozen=True)
class General:
    """The form of a relation for any value of a quantity that is printed as 1, and its certificates."""

    relation: str
    certificate: tuple[Certificate, ...]


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
    reason
        Why nothing was decided, in one sentence.
    seconds
        How long it took, but for the search for repairs.
    slips
        What looks for repairs.
    measuring
        What finds the dimensions of its terms.
    generalizing
        What looks for the general form.
    """

    verdict: Status
    reading: str = ""
    letters: dict[str, str] = field(default_factory=dict)
    used: tuple[str, ...] = ()
    counterexample: dict[str, str] = field(default_factory=dict)
    values: tuple[str, ...] = ()
    certificate: tuple[Certificate | MatrixProof, ...] = ()
    reason: str = ""
    seconds: float = 0.0
    slips: Callable[[], Slips] = field(default=tuple, repr=False, compare=False)
    measuring: Callable[[], Dimensions | None] = field(default=_nothing, repr=False, compare=False)
    generalizing: Callable[[], General | None] = field(default=_nothing, repr=False, compare=False)

    @cached_property
    def repairs(self) -> Slips:
        """Relations that are one slip of the pen away and are proved: they are looked for when first asked for."""
        return self.slips()

    @cached_property
    def dimension(self) -> Dimensions | None:
        """Whether its terms measure the same, beside whether it is true; None for what is not read."""
        return self.measuring()

    @cached_property
    def general(self) -> General | None:
        """What is proved for any value of a quantity that is printed as 1; None if there is none, or no proof."""
        return self.generalizing()

    def __getstate__(self) -> dict[str, Any]:
        """What another process is sent: repairs, dimensions and the general form in the place of what finds them."""
        found = {"repairs": self.repairs, "dimension": self.dimension, "general": self.general}
        return {**self.__dict__, **found, "slips": tuple, "measuring": _nothing, "generalizing": _nothing}

    def as_json(self) -> dict[str, Any]:
        """The answer as JSON data, with repairs, dimensions and the general form."""
        told = (*(key for key in self.__dataclass_fields__ if key not in SEEKING), "repairs")
        more = {"dimension": to_builtins(self.dimension), "general": self.general and asdict(self.general)}
        return {key: getattr(self, key) for key in told} | more
