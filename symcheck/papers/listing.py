r"""Printed lists of vertices, edges and faces, and tables of coordinates, read row by row as they stand.

A list row is `9) $V_3 V_7 : \mathbf{H} = [u, 1, -1, -1]$`, however it is laid out: several rows on a line, between tabs
or pipes, as rows of an array. Nothing is mended: a lost prime is lost, a label that is printed twice is read twice.
What cannot be read is reported with its line and column, as an `Unreadable` row among the others.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import NoReturn, TypeVar

from symcheck.core.verdicts import SymcheckError

Head = tuple[int, int, tuple[str, ...]]  # what a row begins with: see Row
Pattern = tuple[str, ...]  # "1", "-1", "u" or "v" for each wheel
Direction = tuple[int, int]  # sign and number of a wheel

_GAP = re.compile(r"(?:[\s&|$]|\\quad|\\left|\\right|\\\\)*")  # layout, which may stand between any two signs of a row
# the number of a row, "12)", before a vertex V or a face F
_START = re.compile(r"(?<![\w}^_'])(\d+)\)(?=[\s$|&]*[VF]\b|[\s$|&]*[VF][_'^])")
_LABEL = re.compile(r"(')?_(?:\{(\d+)\}|(\d+))(')?")  # the index of V or F, with a prime on either side of it
# layout and punctuation at the end of a row
_TAIL = re.compile(r"(?:[\s&|.,;-]|\$\$|\\quad|\\\\|\\(?:begin|end)\{\w+\}(?:\{[lcr]+\})?)+$")
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?")  # a cell of a table of coordinates


@dataclass(frozen=True, slots=True)
class Label:
    """`V'_3`: a vertex, or with the letter F a face."""

    letter: str
    index: int
    primed: bool

    @property
    def printed(self) -> str:
        """As the paper prints it."""
        index = f"{{{self.index}}}" if self.index > 9 else f"{self.index}"
        return f"{self.letter}{chr(39) * self.primed}_{index}"

    @property
    def opposite(self) -> Label:
        """The label of what lies opposite, with or without the prime."""
        return Label(self.letter, self.index, not self.primed)


@dataclass(frozen=True, slots=True)
class Row:
    """What all rows have: the number in front (in a table, in reading order), the line, the mathematics verbatim."""

    number: int
    line: int
    printed: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class VertexRow(Row):
    """A vertex with the momenta of the wheels there, its coordinates as LaTeX, and the edges that leave it."""

    label: Label
    pattern: Pattern
    coordinates: tuple[str, ...]
    directions: tuple[Direction, ...]


@dataclass(frozen=True, slots=True)
class EdgeRow(Row):
    """An edge from its first vertex (u = -1) to its last (u = 1)."""

    first: Label
    last: Label
    pattern: Pattern


@dataclass(frozen=True, slots=True)
class FaceRow(Row):
    """A face with the edges around it, each from vertex to vertex."""

    label: Label
    edges: tuple[tuple[Label, Label], ...]
    pattern: Pattern


@dataclass(frozen=True, slots=True)
class TableRow(Row):
    """A vertex with one cell for each heading."""

    label: Label
    cells: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class Unreadable(Row):
    """A row that cannot be read, and why."""

    fault: str


def vertices(block: str, line: int) -> tuple[VertexRow | Unreadable, ...]:
    """The rows of a list of vertices; the block begins on this line of the source."""
    return tuple(_rows(block, line, _vertex))


def edges(block: str, line: int) -> tuple[EdgeRow | Unreadable, ...]:
    """The rows of a list of edges."""
    return tuple(_rows(block, line, _edge))


def faces(block: str, line: int) -> tuple[FaceRow | Unreadable, ...]:
    """The rows of a list of faces."""
    return tuple(_rows(block, line, _face))


def table(block: str, line: int) -> tuple[TableRow | Unreadable, ...]:
    """The rows of a table whose first line has the headings; a line may hold several rows, each with its own label."""
    heading, *lines = block.split("\n")
    names = heading.replace("$", "").split("\t")
    starts = [k for k, name in enumerate(names) if name == names[0]]
    groups = list(zip(starts, [*starts[1:], len(names)], strict=True))
    found: list[TableRow | Unreadable] = []
    for below, text in enumerate(lines, 1):
        cells, place = text.split("\t"), line + below
        if len(cells) != len(names):
            fault = f"line {place}: {len(cells)} cells under {len(names)} headings; see whether a tab is lost"
            found += [Unreadable(len(found) + k, place, (text,), fault) for k in range(1, len(groups) + 1)]
            continue
        for start, end in groups:
            found.append(_table_row(len(found) + 1, place, names[start + 1 : end], cells[start:end]))
    return tuple(found)


def labels(text: str, line: int) -> tuple[Label, ...]:
    """Labels with commas between them, `F_1, F'_1`; SymcheckError with the place of what is none."""
    reader, found = _Reader(text, 0, len(text), line), list[Label]()
    while reader.at < reader.end:
        found.append(reader.label("[VF]"))
        reader.take(",|$", "a comma between labels")
        reader.skip()
    return tuple(found)


R = TypeVar("R", bound=Row)


class _Reader:
    """Takes one piece after the other off a row; what stands between them is layout."""

    def __init__(self, block: str, start: int, end: int, line: int) -> None:
        self.block, self.at, self.end, self.line = block, start, end, line

    def take(self, pattern: str | re.Pattern[str], what: str) -> re.Match[str]:
        """The next piece, or SymcheckError with the place where it is not."""
        self.skip()
        match = re.compile(pattern).match(self.block, self.at, self.end)
        if match is None:
            self.fail(what)
        self.at = match.end()
        return match

    def skip(self) -> None:
        """Passes over layout."""
        match = _GAP.match(self.block, self.at, self.end)
        self.at = match.end() if match else self.at

    def fail(self, what: str) -> NoReturn:
        """Says what should stand here."""
        before = self.block[: self.at]
        line, column = self.line + before.count("\n"), self.at - (before.rfind("\n") + 1) + 1
        found = self.block[self.at : min(self.at + 12, self.end)].split("\n")[0]
        raise SymcheckError(f"line {line}, column {column}: {what} is expected, not {found!r}; compare the source")

    def label(self, letter: str) -> Label:
        """`V'_3`, `V_3'` or `V_{16}`; `letter` is V, F, or either."""
        what = f"a label {letter}_i"
        letter = self.take(letter, what)[0]
        match = self.take(_LABEL, what)
        if match[1] and match[4]:
            self.fail("one prime")
        return Label(letter, int(match[2] or match[3]), bool(match[1] or match[4]))

    def pattern(self, parameters: str) -> Pattern:
        r"""`\mathbf{H} = [u, 1, -1]`"""
        self.take(r"\\mathbf\{H\}", r"\mathbf{H}")
        self.take("=", "=")
        self.take(r"\[", "[")
        entry, found = "|".join([r"-?1(?!\d)", *parameters]), list[str]()
        while not found or self.take(r"[,\]]", "a comma or ]")[0] == ",":
            found.append(self.take(entry, " or ".join(["1, -1", *parameters]))[0])
        if any(found.count(name) != 1 for name in parameters):
            self.fail(f"each of {', '.join(parameters)} once before this")
        return tuple(found)

    def listed(self, opening: str, closing: str, item: str, what: str) -> list[re.Match[str]]:
        """Items with commas between them, in brackets."""
        self.take(opening, what)
        found: list[re.Match[str]] = []
        while not found or self.take(f",|{closing}", "a comma or the end of the list")[0] == ",":
            found.append(self.take(item, what))
        return found


def _rows(block: str, line: int, read: Callable[[_Reader, Head], R]) -> Iterator[R | Unreadable]:
    """Each row from its number to the next one's."""
    starts = list(_START.finditer(block))
    for match, after in zip(starts, [*(m.start() for m in starts[1:]), len(block)], strict=True):
        text = _TAIL.sub("", block[match.start() : after])
        where = line + block[: match.start()].count("\n")
        reader = _Reader(block, match.end(), match.start() + len(text), line)
        inline = tuple(piece.rstrip(",.; ") for piece in re.findall(r"(?<!\$)\$([^$]+)\$(?!\$)", text))
        row = (int(match[1]), where, inline or (text,))
        try:
            found = read(reader, row)
            reader.take("[,.;]?", "")
            reader.skip()
            if reader.at < reader.end:
                reader.fail("the end of the row")
        except SymcheckError as error:
            yield Unreadable(*row, str(error))
        else:
            yield found


def _vertex(reader: _Reader, row: Head) -> VertexRow:
    label = reader.label("V")
    reader.take(":", ":")
    pattern = reader.pattern("")
    reader.take("=", "=")
    entries = reader.listed(r"\(", r"\)", r"[^(),]+", "coordinates in brackets")
    coordinates = tuple(re.sub(r"\\right$|[&\s]+$", "", entry[0]).strip() for entry in entries)
    if len(coordinates) != 3:
        reader.fail("three coordinates before this")
    reader.take(",?", "")
    signed = reader.listed(r"\\\{", r"\\\}", r"(-?)\\mathbf\{e\}_(\d)", r"a direction \mathbf{e}_i")
    return VertexRow(*row, label, pattern, coordinates, tuple((-1 if m[1] else 1, int(m[2])) for m in signed))


def _edge(reader: _Reader, row: Head) -> EdgeRow:
    first, last = reader.label("V"), reader.label("V")
    reader.take(":", ":")
    return EdgeRow(*row, first, last, reader.pattern("u"))


def _face(reader: _Reader, row: Head) -> FaceRow:
    label = reader.label("F")
    reader.take("=", "=")
    reader.take(r"\\\{", "a set of edges")
    sides = [(reader.label("V"), reader.label("V"))]
    while reader.take(r",|\\\}", "a comma or the end of the set")[0] == ",":
        sides.append((reader.label("V"), reader.label("V")))
    reader.take(",?", "")
    return FaceRow(*row, label, tuple(sides), reader.pattern("uv"))


def _table_row(number: int, line: int, names: list[str], cells: list[str]) -> TableRow | Unreadable:
    """One vertex of a table."""
    printed = "\t".join(cells)
    try:
        reader = _Reader(cells[0], 0, len(cells[0]), line)
        label = reader.label("V")
        for name, cell in zip(names, cells[1:], strict=True):
            if not _NUMBER.fullmatch(cell):
                raise SymcheckError(
                    f"line {line}, {cells[0]}, column {name}: {cell!r} is not a number; compare the source"
                )
        return TableRow(number, line, (printed,), label, tuple(zip(names, cells[1:], strict=True)))
    except SymcheckError as error:
        return Unreadable(number, line, (printed,), str(error))
