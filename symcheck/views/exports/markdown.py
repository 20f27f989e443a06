"""The errata and the ledger as Markdown with formulas between dollars, as forges and notebooks show them."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby

from symcheck.coq.confirmed import told
from symcheck.core.verdicts import Group, Verdict
from symcheck.ledger.record import Record
from symcheck.views.exports import Format
from symcheck.views.faults import Alike, Fault, errata, fails_at, statement
from symcheck.views.latex import is_formula, standing_alone

_MARKUP = re.compile(r"([\\`*_{}\[\]<>#|$])")


def text(records: Sequence[Record]) -> str:
    """Counts, then errata, the weightiest first, then a table of all items for each paper."""
    return "\n".join((*_head(records), *_errata(records), *_ledger(records), ""))


def _head(records: Iterable[Record]) -> Iterator[str]:
    found = Counter(record.verdict for record in records if record.verdict)
    yield "# Audit of printed equations"
    yield f"\n{found.total()} relations: {', '.join(f'{found[each]} {each}' for each in Verdict)}."


def _errata(records: Sequence[Record]) -> Iterator[str]:
    for group, members in errata(records):
        yield f"\n## {str(group).capitalize()}"
        for alike in members:
            yield from (map(_wrong, alike.faults) if group is Group.STATEMENT else _table(alike))


def _wrong(fault: Fault) -> str:
    record = fault.first
    lines = {
        "": _plain(record.words),
        "printed": _formula(fault.printed),
        "correct": _formula(fault.correct),
        "given": _plain("; ".join(fault.added)),
        "fails at": _plain(fails_at(record.counterexample)),
        "why": _plain(record.reason),
    }
    said = "".join(f"\n- {label}{': ' if label else ''}{line}" for label, line in lines.items() if line)
    return f"\n### {record.id}: {_plain(record.kind)}\n{said}"


def _table(alike: Alike) -> Iterator[str]:
    yield f"\n### {alike.place}: {_plain(alike.first.kind)}, {alike.first.origin or 'cannot tell'}"
    yield "\n| number | line | printed | correct |\n|---|---|---|---|"
    for fault in alike.faults:
        record = fault.first
        yield f"| {fault.number} | {record.line} | {_formula(fault.printed)} | {_formula(fault.correct)} |"


def _ledger(records: Sequence[Record]) -> Iterator[str]:
    for paper, rows in groupby(records, lambda record: record.paper):
        yield f"\n## {paper}\n\n| number | statement | verdict | reading | confirmed by Coq |\n|---|---|---|---|---|"
        for record in rows:
            said = statement(record)
            number = record.id.partition(":")[2]
            cells = (_formula(said), record.verdict or record.role, record.reading, _plain(told(record)))
            yield f"| {number} | {' | '.join(cells)} |"


def _formula(text: str) -> str:
    """A formula between dollars on one line that no table takes for several cells; what is none as plain text."""
    if not is_formula(text):
        return _plain(text)
    written = standing_alone(text).replace(r"\|", r"\Vert ").replace("|", r"\vert ")
    return f"${' '.join(written.split())}$"


def _plain(text: str) -> str:
    return _MARKUP.sub(r"\\\1", " ".join(text.split()))


FORMAT = Format("errata and ledger as Markdown", text)
