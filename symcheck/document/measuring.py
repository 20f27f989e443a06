"""Which formulas of a document have letters whose units are said, and whether their terms fit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from symcheck.dimensions import INCONSISTENT, UNDETERMINED, Dimensions
from symcheck.document.checks import Checks
from symcheck.document.survey import Said
from symcheck.document.units import Told, of_letters
from symcheck.question.measured import measured, spelled
from symcheck.question.prepare import Asked

UNKNOWN = Dimensions(verdict=UNDETERMINED)


@dataclass(frozen=True)
class Measuring:
    """A relation with units of its letters, the definitions of those without one, and what else is said of letters."""

    relation: str
    units: Said
    where: tuple[str, ...] = ()
    letters: Said = ()


@dataclass(frozen=True)
class Place:
    """The number of a formula, what is said of its letters, and the numbers of the definitions."""

    number: int
    told: tuple[Told, ...]
    definitions: tuple[int, ...]


def measurings(checks: Checks, told: Sequence[Told]) -> Iterator[tuple[Place, Measuring]]:
    """The formulas of which a letter has a unit, and that say something of it."""
    for k, (formula, seen) in enumerate(zip(checks.formulas, checks.seen, strict=True)):
        units = of_letters(told, formula.scope) if told and seen.is_known else {}
        if not {*units} & {*map(spelled, seen.names)}:
            continue
        used: dict[int, str] = {}
        known, names = checks.definitions(k), {*seen.names}
        for _ in known:
            more = {x: known[x] for x in names & known.keys() if spelled(x) not in units}
            used |= {each.number: each.link.latex for each in more.values()}
            names |= {x for each in more.values() for x in each.names}
        own = tuple(told_ for x in sorted(names) if (told_ := units.get(spelled(x))))
        said = tuple((each.letter, each.unit) for each in own)
        letters = checks.said(seen, *(checks.seen[m] for m in used))
        yield Place(k, own, (*used,)), Measuring(formula.latex, said, (*used.values(),), letters)


def measured_by(question: Measuring) -> Dimensions:
    """The verdict on the dimensions of a relation; with the definitions if it takes them for a conflict."""
    units, asked = dict(question.units), Asked(question.relation, letters=question.letters)
    found = measured(asked, units, cautious=True)
    if found.verdict == INCONSISTENT or not (question.where and units):
        return found
    return measured(Asked(question.relation, question.where, (), question.letters), units, cautious=True)
