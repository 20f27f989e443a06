"""References to facts, named as in the checker, and facts as polynomials that are zero."""

from __future__ import annotations

from dataclasses import dataclass, field

from symcheck.core.terms import Term
from symcheck.proof.algebra.flint import Poly
from symcheck.proof.algebra.polynomial import Ring


@dataclass(frozen=True)
class Reference:
    """A fact. An equation with denominators stands for a polynomial that is multiplied with those: `cleared`."""

    cleared: tuple[str, ...] = field(default=(), compare=False, kw_only=True)


@dataclass(frozen=True)
class Hypothesis(Reference):
    """A conjunct of a named hypothesis."""

    name: str
    number: int

    def json(self) -> list[str | int]:
        return ["hyp", self.name, self.number]


@dataclass(frozen=True)
class Assumed(Reference):
    """What steps above assume, numbered in order."""

    number: int

    def json(self) -> list[str | int]:
        return ["here", self.number]


@dataclass(frozen=True)
class Coordinate(Reference):
    """The value of a letter at a point, letters in alphabetical order."""

    number: int

    def json(self) -> list[str | int]:
        return ["point", self.number]


@dataclass(frozen=True)
class Axiom(Reference):
    """What holds of a variable by construction, such as sin^2 + cos^2 = 1: certificates do not write it."""

    variable: str


Grounds = frozenset[Hypothesis]  # the hypotheses on which a sign rests
NOTHING: Grounds = frozenset()


@dataclass(frozen=True)
class Signed:
    """A term that is manifestly not negative, or positive, with the hypotheses that say so."""

    term: Term
    grounds: Grounds

    def json(self) -> object:
        return self.term


@dataclass(frozen=True)
class Positive(Signed):
    """A term that is manifestly positive, as something that is not zero."""

    def json(self) -> object:
        return ["positive", self.term]


Nonzero = Reference | Positive
Fact = tuple[Reference, Poly]  # also a cofactor: of the fact, the polynomial to multiply it with


def by_construction(ring: Ring) -> list[Fact]:
    """The axioms of a ring as facts."""
    return [(Axiom(variable), poly) for variable, poly in ring.axioms().items()]


def merged(cofactors: list[Fact]) -> list[Fact]:
    """Cofactors of the same fact added up."""
    total: dict[Reference, Fact] = {}
    for ref, cofactor in cofactors:
        known = total.get(ref)
        total[ref] = (ref, cofactor if known is None else known[1] + cofactor)
    return [fact for fact in total.values() if fact[1] != 0]
