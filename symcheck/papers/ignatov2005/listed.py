"""Declarations from printed lists and tables: one for each row, and one for each list as a whole."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import Any

from symcheck.core.claims import Claim, Declaration, Definition, Erratum
from symcheck.core.verdicts import Origin
from symcheck.mechanics.zonotope import Signs
from symcheck.papers import listing
from symcheck.papers.declare import claim, definition, exclusion
from symcheck.papers.ignatov2005.origins import Damage, origin_of
from symcheck.papers.ignatov2005.rows import (
    AND,
    PRIMES,
    Array,
    Names,
    Part,
    bracket,
    faults,
    labels_of,
    parts,
    pattern_of,
    right_row,
    settled,
    to_latex,
    vector,
)
from symcheck.papers.listing import EdgeRow, FaceRow, Label, Row, Unreadable, VertexRow

GRAVEST = ("missing cell", "label", "letter", "function", "coefficient", "number", "sign", "rounding")
EXPONENTS = {"1": 2, "-1": 0, "u": 1, "v": 1}
FIRST_LETTER = ord("a")
SAYS = {
    "V": "(a) These momenta have these coordinates. (b) They are those of the vertex of this name. (c) It is a vertex. "
    "(d) Along the directions the other ends of its edges are reached, 2 away, and there are no more edges.",
    "E": "(a) u = -1 gives the first vertex, (b) u = 1 the last. (c) It is an edge.",
    "F": "(a) Each edge is 2 long, along one of the two free axes. (b) They begin at the corners of the face that is "
    "parametrised, one after the other. (c) It is a face. (d) It is the one of this name; F' is opposite to F.",
    "T": "The coordinates of this vertex at the angles of the table, rounded.",
}
WHOLE = {
    "V": "(a) The rows are numbered without a gap. (b) Each label is there once. (c) The momenta of the rows and those of no "
    "vertex are all combinations of +-1, each once. (d) Of no vertex: a combination of the axes with their signs vanishes.",
    "E": "(a) The rows are numbered without a gap. (b) The momenta of the rows and those of no edge are all momenta with one "
    "wheel free, each once. Then: those are of no edge, as a combination of the axes with their signs vanishes; there are as "
    "many edges as Euler's formula asks for, all faces having four sides.",
    "F": "(a) The rows are numbered without a gap. (b) Each label is there once. (c) The momenta of the rows and those of no "
    "face are all momenta with two wheels free, each once. Then: those are of no face, as a combination of the axes with "
    "their signs vanishes; there are as many faces as Euler's formula asks for, all having four sides.",
}


@dataclass(frozen=True)
class Block:
    """A list or table as it stands in the source, with its first line."""

    line: int
    text: str


@dataclass(frozen=True)
class Printed:
    """The lists and the table of coordinates of one array of wheels."""

    array: Array
    vertices: Block
    edges: Block
    faces: Block
    table: Block
    number_of_table: int

    def read(self) -> dict[str, tuple[Any, ...]]:
        """The rows of every list, by its letter."""
        found = {
            "V": listing.vertices(self.vertices.text, self.vertices.line),
            "E": listing.edges(self.edges.text, self.edges.line),
            "F": listing.faces(self.faces.text, self.faces.line),
            "T": listing.table(self.table.text, self.table.line),
        }
        wheels = len(self.array.axes)
        return {letter: tuple(_of_size(row, wheels) for row in each) for letter, each in found.items()}


def _of_size(row: Row, wheels: int) -> Row:
    """A row, unreadable if it does not speak of all the wheels, or of others."""
    spoken = len(getattr(row, "pattern", range(wheels)))
    if spoken != wheels:
        return _unreadable(row, f"momenta of {spoken} wheels, but there are {wheels}")
    others = [k for _, k in getattr(row, "directions", ()) if not 0 < k <= wheels]
    return _unreadable(row, f"an axis e_{others[0]}, but there are {wheels} wheels") if others else row


def _unreadable(row: Row, fault: str) -> Unreadable:
    return Unreadable(row.number, row.line, row.printed, f"line {row.line}: {fault}; compare the source")


@dataclass(frozen=True)
class Declared:
    """The declarations of one array of wheels, list by list.

    section  the section that the lists stand in
    names    what the labels mean
    defined  the same as definitions, of the vertices and of the middles of the faces
    """

    section: str
    names: Names
    defined: tuple[Definition, ...]
    vertices: tuple[Declaration, ...]
    edges: tuple[Declaration, ...]
    faces: tuple[Declaration, ...]
    table: tuple[Declaration, ...]


@dataclass(frozen=True)
class Listed:
    """One list or table with the rows as printed and as they should be."""

    array: Array
    names: Names
    number: str
    letter: str
    pairs: tuple[tuple[Row, Row | None], ...]

    @cached_property
    def pattern(self) -> Damage:
        """What is damaged in the same way all over the list."""
        return Damage(tuple((row, right) for row, right in self.pairs if right is not None))


def declared(printed: Printed) -> Declared:
    """All declarations of an array of wheels."""
    array, read = printed.array, printed.read()
    names = settled(array, *([r for r in read[x] if not isinstance(r, Unreadable)] for x in "VEFT"))
    defined = (
        _definition(array, "V", names.vertices, printed.vertices.line, "the vertices"),
        _definition(
            array, "F", names.faces, printed.faces.line, "the faces (in a statement F_i is the middle of the face)"
        ),
    )
    found = {}
    for letter, each in read.items():
        known = [_with_known_labels(row, names) for row in each]
        rights = [None if isinstance(row, Unreadable) else right_row(array, names, row) for row in known]
        number = f"{array.section}{letter}" if letter != "T" else f"T{printed.number_of_table}"
        listed = Listed(array, names, number, letter, tuple(zip(known, rights, strict=True)))
        whole = [_whole(listed)] if letter != "T" else []
        found[letter] = (*whole, *(_row(listed, row, right) for row, right in listed.pairs))
    return Declared(array.section, names, defined, found["V"], found["E"], found["F"], found["T"])


def _with_known_labels(row: Row, names: Names) -> Row:
    """A row, unreadable if a name in it is not that of a vertex or face."""
    for label in labels_of(row):
        if not names.signs(label):
            return _unreadable(row, f"{label.printed} is none of the labels of this list")
    return row


def _definition(array: Array, letter: str, known: Mapping[int, Signs], line: int, words: str) -> Definition:
    """What the labels of one kind mean."""
    each = (rf"{vector(Label(letter, index, False))} = {bracket(signs)}" for index, signs in sorted(known.items()))
    return definition(
        f"{array.section}{letter}.0",
        line,
        words=f"What the labels of {words} mean, by most of the rows that use them; {letter}'_i is opposite to {letter}_i.",
        states=r", \quad ".join(each),
        notation=array.notation,
    )


# --- one row


def _row(listed: Listed, row: Row, right: Row | None) -> Declaration:
    """The declaration of one row; where it is wrong, with the row that is right."""
    array, names, number = listed.array, listed.names, f"{listed.number}.{row.number}"
    if isinstance(row, Unreadable) or right is None:
        return exclusion(number, row.line, row.printed, reason=f"it cannot be read: {getattr(row, 'fault', '')}")
    stated = parts(array, names, row, right)
    wrong = [k for k, part in enumerate(stated) if not part.holds]
    errata = {}
    if wrong:
        origin, reason = origin_of(listed.pattern, row, right)
        kind = kind_of(faults(row, right), origin)
        wanted, instead = parts(array, names, right, right), to_latex(right)
        errata = {chr(FIRST_LETTER + k): Erratum(wanted[k].states, kind, origin, reason, shown=instead) for k in wrong}
    return claim(
        number,
        row.line,
        row.printed,
        words=SAYS[listed.letter],
        states=tuple(part.states for part in stated),
        by={chr(FIRST_LETTER + k): part.by for k, part in enumerate(stated)},
        given=array.given if listed.letter != "T" else (array.table,),
        errata=errata,
        uses=[f"{array.section}V.0", *([f"{array.section}F.0"] if listed.letter == "F" else [])],
        notation=array.notation,
        where=array.where,
    )


def kind_of(kinds: Sequence[str], origin: Origin) -> str:
    """The gravest kind of fault in a row; an author who primes a wrong vertex takes one for the other."""
    if set(kinds) <= PRIMES:
        return "lost prime" if "lost prime" in kinds and origin is not Origin.PAPER else "label"
    return next(kind for kind in GRAVEST if kind in kinds)


# --- a list as a whole


def _whole(listed: Listed) -> Claim:
    """That a list is complete: sums with one monomial for each row."""
    read = [(row, right) for row, right in listed.pairs if right is not None]
    stated, wanted = ([*_sums(listed, [pair[k] for pair in read])] for k in (0, 1))
    wrong = [k for k, part in enumerate(stated) if not part.holds]
    errata = {}
    if wrong:
        kind, origin, reason = _missing(listed, read)
        errata = {
            chr(FIRST_LETTER + k): Erratum(
                wanted[k].states, kind, origin, reason, shown="The list with that put right."
            )
            for k in wrong
            if wanted[k].holds
        }
    return claim(
        listed.number,
        min(row.line for row, _ in listed.pairs),
        words=WHOLE[listed.letter],
        states=tuple(part.states for part in stated),
        errata=errata,
        notation=listed.array.notation,
        where=listed.array.where,
    )


def _missing(listed: Listed, read: Sequence[tuple[Row, Row]]) -> tuple[str, Origin, str]:
    """The kind of fault of a list that is not complete, whose it is, and why."""
    at_fault = [(row, right) for row, right in read if _counted(row) != _counted(right)]
    if not at_fault:
        return "missing cell", Origin.UNCERTAIN, "A row is missing, cannot be read, or is there twice."
    origin, _ = origin_of(listed.pattern, *at_fault[0])
    numbers = ", ".join(str(row.number) for row, _ in at_fault)
    reason = f"The fault of row {numbers} makes one too many of something, and one too few; else the list is complete."
    return kind_of(faults(*at_fault[0]), origin), origin, reason


def _counted(row: Row) -> tuple[object, object]:
    """What the sums of a list see of a row."""
    return getattr(row, "pattern", ()), getattr(row, "label", None)


def _sums(listed: Listed, read: Sequence[Row]) -> Iterable[Part]:
    """The row numbers as powers, the labels as powers of two letters, the momenta as monomials."""
    rows = [row for row in read if isinstance(row, VertexRow | EdgeRow | FaceRow)]
    letter, names, lattice = listed.letter, listed.names, listed.array.envelope.combinatorics
    cells: Mapping[Signs, object] = {"V": lattice.vertices, "E": lattice.edges, "F": lattice.faces}[letter]
    yield permutation("l_1", [row.number for row in rows], len(cells))
    if letter != "E":
        labels = [row.label for row in rows if not isinstance(row, EdgeRow)]
        known = len(names.vertices if letter == "V" else names.faces)
        plain, primed = (
            permutation(f"l_{1 + prime}", [label.index for label in labels if label.primed == prime], known)
            for prime in (False, True)
        )
        yield Part(plain.states + AND + primed.states, plain.holds and primed.holds)
    free = next(iter(cells)).count(0)
    others = (signs for signs in listed.array.combinations(free) if signs not in cells)
    stated = [*(row.pattern for row in rows), *map(pattern_of, others)]
    yield Part(
        f"{' + '.join(map(_monomial, stated))} = {_all_monomials(len(listed.array.axes), free)}",
        Counter(row.pattern for row in rows) == Counter(map(pattern_of, cells)),
    )
    yield from listed.array.no_others(cells)
    if letter != "V":
        count = f"2 \\cdot {len(lattice.vertices)} - 4" if letter == "E" else f"{len(lattice.vertices)} - 2"
        yield Part(f"{len(rows)} = {count}", len(rows) == len(cells))


def permutation(letter: str, numbers: Sequence[int], count: int) -> Part:
    """That the numbers are 1 to `count`, each there once: a geometric series, (l - 1)(l + l^2 + ...) = l^(n + 1) - l."""
    powers = " + ".join(f"{letter}^{{{number}}}" for number in numbers)
    series = f"({letter} - 1)({powers or 0}) = {letter}^{{{count + 1}}} - {letter}"
    return Part(series, sorted(numbers) == [*range(1, count + 1)])


def _monomial(pattern: Sequence[str]) -> str:
    """l_k squared for a wheel at 1, l_k for one that is free."""
    exponents = [EXPONENTS[entry] for entry in pattern]
    return " ".join(f"l_{k}^{{{n}}}" for k, n in enumerate(exponents, 1) if n) or "1"


def _all_monomials(wheels: int, free: int) -> str:
    """The sum of the monomials of all momenta with so many wheels free, each other one at -1 or 1."""
    every = range(1, wheels + 1)
    return " + ".join(
        " ".join(f"l_{k}" if k in chosen else f"(1 + l_{k}^2)" for k in every) for chosen in combinations(every, free)
    )
