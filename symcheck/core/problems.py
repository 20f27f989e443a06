"""What a proof method is asked, which hints it is given, and what it answers: plain records, no algebra.

A hint holds LaTeX where it is declared, and terms in a lowered problem. Hints are never trusted.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Generic, TypeAlias, TypeVar

from symcheck.core.calculus import Lambda
from symcheck.core.terms import Formula, Term
from symcheck.core.verdicts import Verdict

if TYPE_CHECKING:
    from symcheck.proof.rules.compute import Point
    from symcheck.proof.rules.proof import Proof

L = TypeVar("L")
M = TypeVar("M")


@dataclass(frozen=True)
class Form(Generic[L]):
    """A sum that is zero, or whose addends show that a difference is not negative."""

    sum: L

    @property
    def terms(self) -> tuple[L, ...]:
        return (self.sum,)

    def mapped(self, change: Callable[[L], M]) -> Form[M]:
        return Form(change(self.sum))


@dataclass(frozen=True)
class Witness(Generic[L]):
    """Values of letters bound by "exists", for which what is claimed holds."""

    values: tuple[tuple[str, L], ...]

    @property
    def terms(self) -> tuple[L, ...]:
        return tuple(value for _, value in self.values)

    def mapped(self, change: Callable[[L], M]) -> Witness[M]:
        return Witness(tuple((letter, change(value)) for letter, value in self.values))


@dataclass(frozen=True)
class Candidate(Generic[L]):
    """Values of letters to try first when a counterexample is looked for."""

    values: tuple[tuple[str, L], ...]

    @property
    def terms(self) -> tuple[L, ...]:
        return tuple(value for _, value in self.values)

    def mapped(self, change: Callable[[L], M]) -> Candidate[M]:
        return Candidate(tuple((letter, change(value)) for letter, value in self.values))


@dataclass(frozen=True)
class Applied(Generic[L]):
    """A theorem of the checker's table, with what it is applied to in the order of its parameters.

    Its first parameters may be functions: terms in a letter.
    """

    theorem: str
    terms: tuple[L, ...]
    functions: tuple[Lambda, ...] = ()

    def mapped(self, change: Callable[[L], M]) -> Applied[M]:
        return Applied(self.theorem, tuple(map(change, self.terms)), self.functions)


Hint: TypeAlias = Form[L] | Witness[L] | Candidate[L] | Applied[L]


@dataclass(frozen=True)
class Problem:
    """One lowered formula to decide: everything a proof method may know.

    `definitions` are (name, term) pairs in dependency order, to be unfolded; `hypotheses` maps a name to the
    formulas it states.
    """

    id: str
    claim: Formula
    definitions: tuple[tuple[str, Term], ...] = ()
    hypotheses: tuple[tuple[str, tuple[Formula, ...]], ...] = ()
    hints: tuple[Hint[Term], ...] = ()


@dataclass(frozen=True)
class Outcome:
    """What a method answers: with a proof, a point of a refutation, or a reason."""

    verdict: Verdict
    proof: Proof | None = None
    point: Point | None = None
    used: tuple[str, ...] = ()
    reason: str = ""


@dataclass(frozen=True)
class Method:
    """A proof method with the hints of one claim; `decide` never raises on a statement it cannot decide."""

    name: str
    decide: Callable[[Problem], Outcome]
    hints: tuple[Hint[str], ...] = ()
