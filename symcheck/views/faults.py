"""Errata in the order in which a reviewer wants them, those of one kind together, the parts of one row as one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from string import ascii_lowercase
from typing import Any

from symcheck.core.verdicts import Group, Loss
from symcheck.core.words import term
from symcheck.ledger.record import Record
from symcheck.views.steps import point, sides

_GIVEN = re.compile(r" \(given: .*\)$", re.DOTALL)  # how a record tells conditions behind a corrected formula


@dataclass(frozen=True)
class Fault:
    """What is wrong at one place: one record, or those of several parts of a row that are corrected together."""

    records: tuple[Record, ...]

    @property
    def first(self) -> Record:
        """The record that stands for all."""
        return self.records[0]

    @property
    def number(self) -> str:
        """The number of the first record, with the letters of the others: "2.1V.8a, b"."""
        return ", ".join([self.first.id.partition(":")[2], *(each.id[-1] for each in self.records[1:])])

    @property
    def printed(self) -> str:
        """The row as printed; of a statement in several links the one link."""
        record = self.first
        link = "" if record.is_row or record.group is Group.DAMAGED else record.read
        return link or record.printed or record.words

    @property
    def correct(self) -> str:
        """What is right instead; conditions in words that it needs are those `added`."""
        return _GIVEN.sub("", self.first.corrected)

    @property
    def added(self) -> tuple[str, ...]:
        """The hypotheses, in words, under which it is right."""
        return tuple((self.first.erratum or {}).get("added") or ())


@dataclass(frozen=True)
class Alike:
    """Faults of one place, kind and origin."""

    place: str
    faults: tuple[Fault, ...]

    @property
    def first(self) -> Record:
        """The record whose kind and origin all have."""
        return self.faults[0].first


def errata(records: Iterable[Record]) -> Iterator[tuple[Group, tuple[Alike, ...]]]:
    """The groups that have errata, the weightiest first."""
    wrong = [record for record in records if record.corrected]
    for group in Group:
        members = [record for record in wrong if record.group is group]
        if members:
            yield group, tuple(_alike(members))


def _alike(records: Sequence[Record]) -> Iterator[Alike]:
    found: dict[tuple[object, ...], list[Record]] = {}
    for record in records:
        found.setdefault((place(record), record.kind, record.origin), []).append(record)
    for (where, *_), members in found.items():
        yield Alike(str(where), tuple(_faults(members)))


def fails_at(counterexample: Mapping[str, Any] | None) -> str:
    """The values of a counterexample, which may be a point or the certificate that holds the point; "" without one."""
    found = (counterexample or {}).get("point", counterexample) or {}
    return ", where ".join(filter(None, (point(found.get("values", {})), sides(found))))


def without(hypothesis: Mapping[str, Any]) -> str:
    """What is lost without a hypothesis, and where: "the relation fails at x = 2"; "" if that is not known."""
    lost, shown = hypothesis.get("lost", ""), hypothesis.get("counterexample")
    if not lost or not shown:
        return ""
    if lost == Loss.EXISTENCE:  # at an angle whose sine and cosine are defined as numbers
        return f"{lost} where {point({name: value for name, value in shown['definitions'] if type(value) is int})}"
    if lost == Loss.VALUE:
        return f"{lost} at {point(shown['point'].get('values', {}))}: {term(shown['claim'])} is wrong"
    return f"{lost} at {fails_at(shown)}"


def statement(record: Record) -> str:
    """What a record states: the link of a chain as read, else what is printed, or the words."""
    link = record.read if record.id[-1].isalpha() else ""
    return link or record.printed or record.words or record.name.replace("_", " ")


def place(record: Record) -> str:
    """The list or table of a row, "ignatov2005:2.1V", or else the paper."""
    return re.sub(r"(\.\d+)?[a-z]?$", "", record.id) if record.is_row else record.paper


def _faults(records: Iterable[Record]) -> Iterator[Fault]:
    rows: dict[tuple[object, ...], list[Record]] = {}
    for record in records:
        number = record.id.rstrip(ascii_lowercase) if record.verdict else record.id
        key = (number, record.line, Fault((record,)).printed, record.corrected, record.reason)
        rows.setdefault(key, []).append(record)
    yield from (Fault(tuple(members)) for members in rows.values())
