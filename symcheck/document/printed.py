"""What a document prints: its formulas with their places, before anything is known of them."""

from __future__ import annotations

from dataclasses import dataclass

from symcheck.document.units import Told


@dataclass(frozen=True)
class Printed:
    """One formula.

    Parameters
    ----------
    latex
        Its LaTeX, with all macros expanded, without label, number and punctuation.
    file
        The included file in which it stands, or "" for the document itself.
    line
        The line on which it begins.
    cell
        The cell of a notebook, counted from 1; 0 elsewhere.
    label, number
        As they are printed, or "" where there is none, or it cannot be known.
    display
        Whether it stands on its own lines.
    before
        The words before it, since the last display.
    scope
        The section and the example, exercise or theorem in which it stands, as numbers; 0 outside of any.
    part
        The number of the last heading before it, of whatever level.
    anew
        What the text behind that heading prints of letters that may be anything, as `x, y \\in \\mathbb{R}^3` or
        "for any x": they are others than those before.
    goes_on
        Whether it begins with a sign and goes on with the display above it, the last side of which it repeats here.
    chapter
        The number of the last heading of a chapter before it: in Markdown of the highest level.
    """

    latex: str
    file: str
    line: int
    cell: int
    label: str
    number: str
    display: bool
    before: str
    scope: tuple[int, int]
    part: int = 0
    anew: tuple[str, ...] = ()
    goes_on: bool = False
    chapter: int = 0

    @property
    def position(self) -> str:
        """Where it is, in words, without its number: `line 12`."""
        return place(self.file, self.line, self.cell)

    @property
    def place(self) -> str:
        """Where it is, in words: `line 12 (3.4)`."""
        return self.position + (f" ({self.number})" if self.number else "")


@dataclass(frozen=True)
class Fault:
    """Something that is wrong with the source itself, at a place before the formula of a number."""

    number: int
    place: str
    message: str


def place(file: str, line: int, cell: int) -> str:
    """A place in words."""
    return ", ".join(filter(None, (file, f"cell {cell}" if cell else "", f"line {line}")))


@dataclass(frozen=True)
class Source:
    """All that is taken from a file."""

    formulas: tuple[Printed, ...] = ()
    faults: tuple[Fault, ...] = ()
    notes: tuple[str, ...] = ()
    mentions: tuple[tuple[str, int], ...] = ()  # letters that stand alone in the text, with the next formula's number
    told: tuple[Told, ...] = ()  # what letters measure, by the words
    units: frozenset[str] = frozenset()  # the letters that words call identity matrices, bare
