"""What the letters of a question measure, and whether its terms fit together."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace

from symcheck.core.terms import Formula
from symcheck.core.verdicts import SymcheckError
from symcheck.dimensions import UNDETERMINED, Dimensions, Known, Scale, dimension, form_of, inferred, of_printed
from symcheck.question.limit import OutOfTime, limited
from symcheck.question.prepare import Asked, plainly, readings, with_scopes
from symcheck.reading import Notation, lower, read
from symcheck.reading.measures import of_letter
from symcheck.reading.notation import canonical

ONE = "= 1"  # behind a unit: the relation is printed as if the letter were 1
LIMIT = 5.0  # seconds
KINDLESS = ("index", "differential")  # letters that measure nothing of their own
UNITS = "units are given as 'LETTER: UNIT', such as 'F: N' or 'm_1: kg'; as 'c: m/s = 1' where c is not printed"


def unit(text: str) -> tuple[str, str]:
    """A letter and its unit, as they are given."""
    letter, colon, said = text.rpartition(":")
    if not colon or not letter.strip() or not said.strip():
        raise SymcheckError(f"{text!r} is no unit of a letter; {UNITS}")
    return letter.strip(), said.strip()


def checked(units: Mapping[str, str], letters: Mapping[str, str]) -> None:
    """SymcheckError for what is no unit, and for a unit of a letter that does not occur."""
    every = {spelled(letter) for letter in letters} if units else set()
    for letter, said in units.items():
        dimension(said.removesuffix(ONE).strip())
        if letters and canonical(letter) not in every and not said.endswith(ONE):
            raise SymcheckError(
                f"the unit of {letter} is given, which does not occur; there are {', '.join(letters)}. Say "
                f"'{letter}: {said} {ONE}' for a quantity that is not printed because it is 1"
            )


def spelled(letter: str) -> str:
    """How a letter is looked up; a name such as `[a]_\\times` is kept as it is."""
    try:
        return canonical(letter)
    except SymcheckError:
        return letter


def measured(printed: Asked, units: Mapping[str, str], cautious: bool = False) -> Dimensions:
    """The verdict on the dimensions of a relation; that of all its readings, if they agree.

    It is cautious where a text says the units: then numbers may measure something, and a letter with an index, which
    runs, may be another one than the letter alone.
    """
    try:
        with limited(LIMIT):
            several = readings(with_scopes(plainly(printed)))
            found = [
                of_printed(
                    printed.relation,
                    lower(each.tree, each.inference.notation),
                    *known_of(printed, units, each.inference.notation, cautious),
                    cautious=cautious,
                )
                for each in several
            ]
    except SymcheckError as error:
        return Dimensions(verdict=UNDETERMINED, reason=str(error))
    except OutOfTime:
        return Dimensions(verdict=UNDETERMINED, reason=f"it was not decided within {LIMIT:g} s")
    if {each.verdict for each in found} == {found[0].verdict}:
        return found[0]
    return Dimensions(
        verdict=UNDETERMINED,
        reason="it depends on what the letters are: "
        + "; ".join(
            f"{', '.join(reading.inference.choices)}: {each.verdict}"
            for reading, each in zip(several, found, strict=True)
        ),
    )


def known_of(
    printed: Asked, units: Mapping[str, str], notation: Notation, cautious: bool = False
) -> tuple[Known, tuple[Scale, ...]]:
    """What is said of letters, and what the definitions and conditions tell of others; the quantities that are 1."""
    known: Known = {}
    scales = []
    for letter, said in units.items():
        spelling, unit_ = canonical(letter), said.removesuffix(ONE).strip()
        if said.endswith(ONE):
            scales.append(Scale(letter, form_of(dimension(unit_))))
        for each in notation.letters:
            if each.spelling == spelling and each.kind not in KINDLESS and not (cautious and each.indices):
                known |= of_letter(replace(each, unit=unit_))
    return {**known, **inferred([*_stated(printed, notation)], known)}, tuple(scales)


def _stated(printed: Asked, notation: Notation) -> Iterator[Formula]:
    for text in (*printed.where, *printed.given):
        with suppress(SymcheckError):
            yield from lower(read(text, notation), notation)
