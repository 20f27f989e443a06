"""What the letters of a declaration measure, and whether its relations fit."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from symcheck.core.claims import Paper
from symcheck.core.ids import Id
from symcheck.core.terms import Formula
from symcheck.core.verdicts import SymcheckError
from symcheck.dimensions import UNDETERMINED, Dimensions, dimensions, shown_form
from symcheck.reading import Notation, lower, read, relations
from symcheck.reading.measures import ANY, measures, of_letter, scales
from symcheck.reading.notation import Letter


def of_formulas(formulas: Sequence[Formula], notation: Notation) -> Dimensions:
    """The verdict on the dimensions of a relation, whose letters have their units in the notation."""
    try:
        known, ones = measures(notation), scales(notation)
    except SymcheckError as error:  # nothing else is held up by what somebody calls a unit
        return Dimensions(verdict=UNDETERMINED, reason=str(error))
    return dimensions(formulas, known, ones)


def of_text(text: str | tuple[str, ...], notation: Notation) -> Dimensions | None:
    """The same of what is printed; None if it states no relation."""
    try:
        tree = read(text, notation)
        if not relations(tree):
            return None
        formulas = lower(tree, notation)
    except SymcheckError as error:
        return Dimensions(verdict=UNDETERMINED, reason=str(error))
    return of_formulas(formulas, notation)


@dataclass(frozen=True)
class Unit:
    """What a letter of a paper measures.

    letter   as printed, with places for its indices
    meaning  in words
    measures in base units, of each variable that differs, "?" if nothing says so
    source   "declared as N m", or the relations from which it follows
    """

    letter: str
    meaning: str
    measures: str
    source: str


def table(paper: Paper) -> list[Unit]:
    """All letters of a paper, in the order of its notation, with those of its sections behind those of all."""
    declared = {letter: None for notation in _notations(paper) for letter in notation.letters if letter.instances}
    inferred: dict[Letter, dict[str, tuple[str, str]]] = {}
    for _, _, item in paper.items():
        notation = item.notation or paper.notation
        of = of_text(item.text, notation) if item.text else None
        for name, unit in (of.letters if of else {}).items():
            if (letter := notation.owner(name)) is not None:
                inferred.setdefault(letter, {}).setdefault(name, (unit, str(Id.of(paper.key, item.number))))
    return [_row(letter, inferred.get(letter, {})) for letter in declared]


def _notations(paper: Paper) -> Iterator[Notation]:
    yield paper.notation
    yield from dict.fromkeys(item.notation for _, _, item in paper.items() if item.notation)


def _row(letter: Letter, inferred: Mapping[str, tuple[str, str]]) -> Unit:
    spelled = f"{letter.latex}_{{{'ijkl'[: letter.indices]}}}" if letter.indices else letter.latex
    if known := of_letter(letter):
        units = dict.fromkeys(ANY if form is None else shown_form(form) for form in known.values())
        return Unit(spelled, letter.meaning, ", ".join(units), "declared")
    units = dict.fromkeys(unit for unit, _ in inferred.values())
    sources = dict.fromkeys(source for _, source in inferred.values())
    return Unit(spelled, letter.meaning, ", ".join(units) or "?", f"from {', '.join(sources)}" if sources else "")
