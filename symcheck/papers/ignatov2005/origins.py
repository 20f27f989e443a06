r"""Whose fault a wrong row is: the author's, or that of the digital text. A pattern in the damage is the evidence.

Two patterns tell. In most lists the first of two labels side by side has lost its prime, the second has not: `V'_3 V'_6`
became `V_3 V'_6`. And whoever made a mistake in writing made it again in the row of what lies opposite.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence, Set
from dataclasses import dataclass, replace
from functools import cached_property

from symcheck.core.verdicts import Origin
from symcheck.mechanics.zonotope import opposite
from symcheck.papers.ignatov2005.rows import labels_of, signs_of
from symcheck.papers.listing import EdgeRow, FaceRow, Label, Row, TableRow, VertexRow

LEAST = 3  # so many rows damaged in one way make a pattern


@dataclass(frozen=True)
class Damage:
    """The rows of a list, each with the right one, and what is damaged in the same way all over it."""

    pairs: tuple[tuple[Row, Row], ...]

    @cached_property
    def primes(self) -> str:
        """How many primes are lost, of the first and of the second label of an edge; nothing if only a few."""
        places: Counter[tuple[int, bool]] = Counter()
        for row, right in self.pairs:
            ahead = len(labels_of(right)) % 2
            for k, (label, other) in enumerate(zip(labels_of(row)[ahead:], labels_of(right)[ahead:], strict=False)):
                if other.primed:
                    places[k % 2, not label.primed] += 1
        if places[0, True] < LEAST:
            return ""
        first, second = (places[k, True] + places[k, False] for k in (0, 1))
        return (
            f"Of two labels side by side the first has lost its prime at {places[0, True]} of the {first} places of this list "
            f"that need it, the second at {places[1, True]} of {second}: the digital text drops a prime before another label."
        )

    @cached_property
    def primed_ends(self) -> list[int]:
        """The rows of edges whose last label has a prime too many."""
        edges = [(a, b) for a, b in self.pairs if isinstance(a, EdgeRow) and isinstance(b, EdgeRow)]
        return [row.number for row, right in edges if row.last.primed and row.last == right.last.opposite]

    def with_the_same_number(self, row: TableRow, right: TableRow) -> int:
        """How many rows of a table have a wrong number of the same size as this one."""
        rows = [(a, b) for a, b in self.pairs if isinstance(a, TableRow) and isinstance(b, TableRow)]
        return sum(bool(_wrong_numbers(*pair) & _wrong_numbers(row, right)) for pair in rows)

    def twin(self, row: Row, right: Row) -> int | None:
        """The number of the row of what lies opposite, if it has the same fault."""
        trace = _trace(row, right)
        for other, its_right in self.pairs if trace else ():
            patterns = [signs_of(getattr(each, "pattern", ())) for each in (its_right, right)]
            opposed = patterns[0] == opposite(patterns[1])
            if opposed and trace & _trace(other, its_right):
                return int(other.number)
        return None


def origin_of(damage: Damage, row: Row, right: Row) -> tuple[Origin, str]:
    """Whose fault a row is, with the reason."""
    if damage.primes and _has_lost_first_primes_only(row, right):
        return Origin.OCR, damage.primes
    if twin := damage.twin(row, right):
        return Origin.PAPER, (
            f"Row {twin}, of what lies opposite, has the same fault: the one was written down from the other."
        )
    match row, right:
        case FaceRow(), FaceRow() if _is_primed_too_often(row, right):
            return Origin.PAPER, (
                "With the primes given back that first labels have lost, the cycle closes, and the prime too many stands at both "
                "places of its label: it was put there in writing."
            )
        case FaceRow(), _:
            return Origin.UNCERTAIN, (
                "Also with the primes given back that first labels have lost, the row is wrong; nothing beside it tells whose "
                "fault that is."
            )
        case EdgeRow(), _ if row.number in damage.primed_ends and len(damage.primed_ends) >= LEAST:
            numbers = ", ".join(map(str, damage.primed_ends))
            return Origin.PAPER, (
                f"In rows {numbers} the last label has a prime too many. The digital text of this list loses primes, and only "
                "those of first labels; nowhere else does it add one."
            )
        case TableRow(), TableRow() if (count := damage.with_the_same_number(row, right)) >= LEAST:
            return Origin.PAPER, f"{count} rows have the same number: it was worked out from a rounded one."
    return Origin.UNCERTAIN, "It stands alone in its list: nothing about the rows beside it tells whose it is."


def _has_lost_first_primes_only(row: Row, right: Row) -> bool:
    """Whether a row of edges or faces is right but for primes of first labels; those of a face must close the cycle."""
    if getattr(row, "pattern", None) != getattr(right, "pattern", ()):
        return False
    match row, right:
        case EdgeRow(), EdgeRow():
            return (row.first, row.last) == (replace(right.first, primed=False), right.last)
        case FaceRow(), FaceRow():
            return _restored(row) == labels_of(right)
    return False


def _restored(row: Row) -> tuple[Label, ...]:
    """The labels of a face, first ones with the prime of the label that the edge before ends with."""
    labels = list(labels_of(row))
    if isinstance(row, FaceRow):
        for k, (begin, _) in enumerate(row.edges):
            end = row.edges[k - 1][1]
            if begin == replace(end, primed=False):
                labels[1 + 2 * k] = end
    return tuple(labels)


def _is_primed_too_often(row: FaceRow, right: FaceRow) -> bool:
    """Whether nothing is wrong, once first labels have their primes, but primes that are at both places of a label."""
    labels, wanted = _restored(row), labels_of(right)
    wrong = [k for k, (a, b) in enumerate(zip(labels, wanted, strict=False)) if a != b]
    added = all(labels[k] == wanted[k].opposite and labels[k].primed for k in wrong)
    return added and all(sum(labels[k] == labels[m] for m in wrong) == 2 for k in wrong)


def _trace(row: Row, right: Row) -> Set[object]:
    """What a fault has in common with that of the opposite row: places, wheels, numbers; first primes are restored."""
    match row, right:
        case VertexRow(), VertexRow():
            wheels = {("along", wheel) for _, wheel in set(row.directions) ^ set(right.directions)}
            return wheels | _differing(row.pattern, right.pattern) | _differing(row.coordinates, right.coordinates)
        case EdgeRow(), EdgeRow():  # the prime of the first label may be lost
            return _differing_labels([row.last], [right.last]) | _differing(row.pattern, right.pattern)
        case FaceRow(), FaceRow():
            return _differing_labels(_restored(row), labels_of(right)) | _differing(row.pattern, right.pattern)
    return set()


def _differing(read: Sequence[str], wanted: Sequence[str]) -> Set[object]:
    return {(len(wanted), k) for k, (a, b) in enumerate(zip(read, wanted, strict=False)) if a != b}


def _differing_labels(read: Sequence[Label], wanted: Sequence[Label]) -> Set[object]:
    pairs = enumerate(zip(read, wanted, strict=False))
    return {(k, a.index, b.index, a.primed == b.primed) for k, (a, b) in pairs if a != b}


def _wrong_numbers(row: TableRow, right: TableRow) -> set[str]:
    return {a.lstrip("-") for (_, a), (_, b) in zip(row.cells, right.cells, strict=True) if a != b}
