"""What generated modules say of their kernels: data that needs neither NumPy nor what proves."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Protocol


@dataclass(frozen=True)
class Argument:
    """One argument of a kernel: its symbol in the derivation, its meaning, its unit, and the domain the kernel is for.

    low, high   ends of the domain: numbers, names of arguments, or formulas of them ("0", "pi/2"), "" where there is
                none; `closed` if they belong to it
    """

    name: str
    meaning: str
    unit: str = "1"
    low: str = ""
    high: str = ""
    closed: bool = False

    @property
    def domain(self) -> str:
        """The domain in words: "0 < a < pi/2"."""
        sign = "<=" if self.closed else "<"
        below = f"{self.low} {sign} " if self.low else ""
        return (
            f"{below}{self.name}{f' {sign} {self.high}' if self.high else ''}" if below or self.high else "any number"
        )

    @property
    def acute(self) -> bool:
        """An angle whose sine and cosine are not negative."""
        return (self.low, self.high) == ("0", "pi/2")


@dataclass(frozen=True)
class Output:
    """One output of a kernel: its name in the derivation, its meaning, its unit."""

    name: str
    meaning: str
    unit: str = "1"


@dataclass(frozen=True, kw_only=True)
class Specification:
    """What a generated module says of a kernel.

    paper      the key of the paper it comes from
    says       one sentence
    ulp        the largest error in units of the last place, over the domain; `condition` says why it exceeds 4
    degenerate what happens at the ends of the domain
    claims     the proved relations that it rests on, each with the beginning of the SHA-256 of its certificates
    forms      the same of the proofs that what is computed equals what was derived, "" where it is the derived form
    """

    paper: str
    name: str
    says: str
    arguments: tuple[Argument, ...]
    outputs: tuple[Output, ...]
    ulp: int
    condition: str = ""
    degenerate: str = ""
    claims: Mapping[str, str]
    forms: str = ""


class KernelFunction(Protocol):
    """A generated kernel where its name is known only when the program runs; stubs say more of each."""

    __name__: str
    __doc__: str | None
    specification: Specification
    ways: Any  # how it runs: `runtime.Ways`

    def __call__(self, *arguments: Any, **named: Any) -> Any:
        """The results at some points."""


def specification(kernel: Callable[..., object]) -> Specification:
    """What a generated module says of a kernel.

    >>> from symcheck.generated.ignatov2005 import volume_of_three_wheels
    >>> specification(volume_of_three_wheels).outputs[0].unit
    'units of h_max^3'
    """
    found: Specification = vars(kernel)["specification"]
    return found
