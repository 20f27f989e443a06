"""A whole proof: its steps, what it rests on, and points where all of that holds."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from symcheck.core.problems import Problem
from symcheck.core.terms import Term
from symcheck.proof.algebra.facts import Grounds
from symcheck.proof.rules.compute import Point
from symcheck.proof.rules.step import Whole


@dataclass(frozen=True)
class Proof:
    """The steps, the hypotheses they rest on, and denominators of the statement about which no hypothesis speaks."""

    step: Whole
    given: Grounds = frozenset()
    nonzero: tuple[Term, ...] = ()
    witnesses: tuple[Point, ...] = ()


Prover = Callable[[Problem], Proof | None]
