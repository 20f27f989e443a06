"""The ledger as a table that a spreadsheet opens: one row for each item, what is folded in records as text."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence

from symcheck.core.verdicts import Role
from symcheck.ledger import Record
from symcheck.views.dimensions import conflict
from symcheck.views.exports import Format
from symcheck.views.model import Relation

MARK = "\ufeff"  # by which a spreadsheet knows the encoding
FORMULAS = ("=", "+", "-", "@")  # a spreadsheet would compute what begins so; a space before it changes no LaTeX
EMPTY = Record(id="", paper="", section="", line=0, role=Role.CLAIM)


def text(records: Sequence[Record]) -> str:
    """The table, with the names of its columns in the first line."""
    out = io.StringIO()
    writer = csv.writer(out)
    writer.writerow(_row(EMPTY))
    writer.writerows(map(_cell, _row(record).values()) for record in records)
    return MARK + out.getvalue()


def _row(record: Record) -> dict[str, str]:
    relation = Relation(record)
    return {
        "id": record.id,
        "paper": record.paper,
        "section": record.section,
        "line": str(record.line),
        "role": record.role,
        "name": relation.name,
        "verdict": record.verdict or "",
        "reading": record.reading,
        "group": record.group or "",
        "kind": record.kind,
        "origin": record.origin or "",
        "printed": record.printed,
        "words": record.words,
        "read": record.read,
        "corrected": record.corrected,
        "reason": record.reason,
        "fails at": relation.fails_at,
        "hypotheses": "; ".join(condition.words for condition in relation.conditions),
        "needed": "; ".join(condition.words for condition in relation.conditions if condition.need),
        "method": record.method,
        "dimension": record.dimension.verdict if record.dimension else "",
        "dimensions that do not fit": conflict(record.dimension),
        "confirmed by Coq": relation.coq,
        "uses": " ".join(record.uses),
        "used by": " ".join(record.used_by),
    }


def _cell(value: str) -> str:
    return f" {value}" if value.startswith(FORMULAS) else value


FORMAT = Format("a table for a spreadsheet", text)
