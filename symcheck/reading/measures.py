"""What the letters of a notation measure, by the names under which they are lowered."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

from symcheck.core.verdicts import SymcheckError
from symcheck.dimensions import Known, Scale, dimension, form_of
from symcheck.reading.notation import Letter, Notation

ANY = "any"


@lru_cache(maxsize=128)
def measures(notation: Notation) -> Known:
    """The forms of all variables and functions whose letters have units; SymcheckError for what is no unit.

    None for a letter whose unit is "any", such as one that stands for all constants.
    """
    return {name: form for letter in notation.letters for name, form in of_letter(letter).items()}


def of_letter(letter: Letter) -> Known:
    """The forms of the variables of one letter; none if it has no unit."""
    try:
        return {name: None if unit == ANY else form_of(dimension(unit)) for name, unit in _units(letter)}
    except SymcheckError as error:
        raise letter.fault(str(error)) from error


def scales(notation: Notation) -> tuple[Scale, ...]:
    """What relations may suppose to be 1."""
    return tuple(Scale(name, form_of(dimension(unit))) for name, unit in notation.scales)


def _units(letter: Letter) -> Iterator[tuple[str, str]]:
    """The unit of each variable of a letter: one for all, one for each first index, or one for each variable."""
    names = [name for name, _ in letter.instances]
    units = [cell.strip() for row in letter.unit.split(";") for cell in row.split(",")]
    if not letter.unit:
        units = ["1"] * len(names) if letter.integer else []
    elif names and len(names) % len(units):
        raise SymcheckError(f"{len(units)} units for {len(names)} variables; give one for all, or one for each")
    for k, name in enumerate(names if units else ()):
        yield name, units[k * len(units) // len(names)]
