"""What a step of a proof is, whatever its rule: the facts and terms it mentions, the steps in it, its JSON form.

A rule is a frozen dataclass whose fields are those of the checker, in their order. From these all else is worked out:
fields that are steps, references, signed terms or tuples of such count, and nothing else does.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import ClassVar, Self

from symcheck.core.calculus import substituted
from symcheck.core.terms import Formula, Node, Term
from symcheck.proof.algebra.facts import Assumed, Axiom, Fact, Nonzero, Reference, Signed
from symcheck.proof.algebra.knowledge import Knowledge
from symcheck.proof.algebra.place import Place
from symcheck.proof.algebra.polynomial import Ratio


@dataclass(frozen=True)
class Denominator:
    """A denominator of the goal, printed."""

    text: str

    def json(self) -> object:
        return self.text


Factor = Denominator | Nonzero  # what is not zero


@dataclass(frozen=True)
class Cofactor:
    """A fact and what it is multiplied with, printed."""

    __match_args__: ClassVar[tuple[str, ...]]
    fact: Reference
    factors: tuple[str, ...]

    def json(self) -> object:
        return [self.fact, *self.factors]


@dataclass(frozen=True)
class Step:
    """A step, with those above it."""

    rule: ClassVar[str]
    __match_args__: ClassVar[tuple[str, ...]]  # the names of the fields, as every dataclass has them
    optional: ClassVar[tuple[str, ...]] = ()  # fields that are not written where they are empty

    def json(self) -> object:
        """The step as the checker reads it; what is in it is written by `written`."""
        named = {name.rstrip("_"): getattr(self, name) for name in self.__match_args__}
        return {"rule": self.rule, **{name: part for name, part in named.items() if part or name not in self.optional}}

    def speaks_of(self, definitions: Mapping[str, Term]) -> Iterable[Term]:
        """Terms that the step mentions, in addition to signed ones."""
        return ()

    @cached_property
    def references(self) -> frozenset[Reference]:
        """The facts that the proof uses."""
        return frozenset[Reference]().union(*(_references(getattr(self, name)) for name in self.__match_args__))

    def mapped(self, change: Callable[[Reference], Reference]) -> Self:
        """The proof with every reference changed."""
        return replace(self, **{name: _changed(getattr(self, name), change) for name in self.__match_args__})

    def without(self, numbers: Sequence[int]) -> Self | None:
        """The proof without assumptions of consecutive numbers, later ones renumbered; None if it refers to them."""
        used = {ref.number for ref in self.references if isinstance(ref, Assumed)}
        if not used.isdisjoint(numbers):
            return None
        return self.shifted(-len(numbers), numbers[0]) if any(number > numbers[0] for number in used) else self

    def shifted(self, by: int, start: int = 0) -> Self:
        """The proof with the numbers of assumptions from one on shifted."""

        def change(ref: Reference) -> Reference:
            return replace(ref, number=ref.number + by) if isinstance(ref, Assumed) and ref.number >= start else ref

        return self.mapped(change)

    def at(self, mean: Mapping[str, Term]) -> Self:
        """The proof of the same about other terms: of x + 1 in the place of x, for instance. See `Whole.at`."""
        return replace(self, **{name: _at(getattr(self, name), mean) for name in self.__match_args__})


Prove = Callable[[Formula, Knowledge], Step | None]
Search = Callable[[Formula, Knowledge, Place], Step | None]  # from knowledge that grew at a place
Attempt = tuple[Step | None, bool]  # a proof, and whether the search at this place is over


@dataclass(frozen=True)
class Whole(Step):
    """A step with what the variables of its polynomials stand for, and the denominators it brings in, as positive."""

    step: Step
    atoms: Mapping[str, Term] = field(default_factory=dict)
    positive: tuple[Term, ...] = ()

    def json(self) -> object:
        own = self.step.json()
        assert isinstance(own, dict)
        named = {
            "atoms": {**self.atoms, **own.get("atoms", {})},
            "positive": (*self.positive, *own.get("positive", ())),
        }
        return own | {name: part for name, part in named.items() if part}

    def at(self, mean: Mapping[str, Term]) -> Whole:
        """The same about other terms: its polynomials stay as they are, and letters in them stand for these terms."""
        atoms = {x: substituted(term, mean) for x, term in self.atoms.items()}
        return Whole(self.step.at(mean), {**mean, **atoms}, tuple(substituted(t, mean) for t in self.positive))


def _parts(step: object) -> Iterator[object]:
    """The steps, cofactors, signed terms and printed denominators of a proof, from the top."""
    open_: list[object] = [step]
    while open_:
        part = open_.pop()
        yield part
        if isinstance(part, Step | Cofactor):
            open_ += [getattr(part, name) for name in reversed(part.__match_args__)]
        elif isinstance(part, tuple) and not isinstance(part, Node):
            open_ += part[::-1]


def _references(part: object) -> frozenset[Reference]:
    match part:
        case Step():
            return part.references
        case Reference():
            return frozenset((part,))
        case Cofactor():
            return frozenset((part.fact,))
        case Signed():
            return frozenset(part.grounds)
        case tuple() if not isinstance(part, Node):
            return frozenset[Reference]().union(*map(_references, part))
    return frozenset()


def _changed(part: object, change: Callable[[Reference], Reference]) -> object:
    match part:
        case Step():
            return part.mapped(change)
        case Reference():
            return change(part)
        case Cofactor():
            return Cofactor(change(part.fact), part.factors)
        case tuple() if type(part) is tuple:
            return tuple(_changed(inner, change) for inner in part)
    return part


def _at(part: object, mean: Mapping[str, Term]) -> object:
    """A part of a proof about other terms."""
    match part:
        case Step():
            return part.at(mean)
        case Signed():
            return replace(part, term=substituted(part.term, mean))
        case Node() | str():
            return substituted(part, mean)
        case Mapping():
            return {name: _at(each, mean) for name, each in part.items()}
        case tuple() if type(part) is tuple:
            return tuple(_at(each, mean) for each in part)
    return part


def mentioned(step: Step, definitions: Mapping[str, Term]) -> list[Term]:
    """The terms (forms, points, what theorems speak of) of a proof."""
    terms: list[Term] = []
    for part in _parts(step):
        if isinstance(part, Signed):
            terms.append(part.term)
        elif isinstance(part, Step):
            terms += part.speaks_of(definitions)
    return terms


def printed(step: object) -> Iterator[str]:
    """The polynomials of a proof: those that are not zero, and cofactors."""
    for part in _parts(step):
        match part:
            case Cofactor():
                yield from part.factors
            case Denominator():
                yield part.text


def written(proof: object) -> str:
    """JSON of anything with steps of proofs in it."""
    return json.dumps(proof, default=lambda part: part.json(), ensure_ascii=False)


def combination(cofactors: Iterable[Fact]) -> tuple[Cofactor, ...]:
    """Cofactors as they stand in a proof: those of what holds by construction are left out."""
    return tuple(Cofactor(ref, (str(poly), *ref.cleared)) for ref, poly in cofactors if not isinstance(ref, Axiom))


def cleared(value: Ratio) -> tuple[Factor, ...]:
    """The denominators that a value is multiplied with before it is written as a combination of facts."""
    return tuple(map(Denominator, value.divisors()))
