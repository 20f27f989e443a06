"""The errata and the ledger as Markdown with formulas between dollars, as forges and notebooks show them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from symcheck.core.verdicts import Group
from symcheck.ledger import Record, by_paper
from symcheck.views.dimensions import unlike
from symcheck.views.exports import Format
from symcheck.views.latex import is_formula, sentence, standing_alone
from symcheck.views.model import Fact, Fault, FaultList, Relation, errata, headline

_MARKUP = re.compile(r"([\\`*_{}\[\]<>#|$])")  # signs that mean something in Markdown


def text(records: Sequence[Record]) -> str:
    """Counts, then errata, the weightiest first, then a table of all items for each paper."""
    return "\n".join(_lines(records)) + "\n"


def _lines(records: Sequence[Record]) -> Iterator[str]:
    said = " ".join(f"{_plain(line)}." for line in headline(records))
    yield f"# Audit of printed equations\n\n{said}"
    for group, lists in errata(records):
        yield f"\n## {str(group).capitalize()}"
        for each in lists:
            yield from (map(_fault, each.faults) if group is Group.STATEMENT else _table(each))
    for paper, rows in by_paper(records).items():
        names = ["number", "statement", "verdict", "reading", "confirmed by Coq"]
        told = any(unlike(record.dimension) for record in rows)
        names += ["dimensions"] if told else []
        yield f"\n## {paper}\n\n| {' | '.join(names)} |\n|{'---|' * len(names)}"
        for relation in map(Relation, rows):
            record = relation.record
            cells = [_formula(relation.statement), relation.state, record.reading, _plain(relation.coq)]
            cells += [_plain(unlike(record.dimension))] if told else []
            yield f"| {record.number} | {' | '.join(cells)} |"


def _fault(fault: Fault) -> str:
    record = fault.first.record
    facts = (f"\n- {each.label}: {_said(each)}" for each in fault.facts if each.text)
    return f"\n### {record.id}: {_plain(record.kind)}\n{''.join(facts)}"


def _said(fact: Fact) -> str:
    return (
        _formula(fact.text) if fact.is_formula else sentence(fact.text, _escaped) if fact.is_ours else _plain(fact.text)
    )


def _table(faults: FaultList) -> Iterator[str]:
    yield f"\n### {_plain(faults.title)}\n\n| number | line | printed | correct |\n|---|---|---|---|"
    for fault in faults.faults:
        line = fault.first.record.line
        yield f"| {fault.number} | {line} | {' | '.join(map(_formula, fault.compared[1:]))} |"


def _formula(text: str) -> str:
    """A formula between dollars on one line, without bars that would split a table cell; other text as plain text."""
    if not is_formula(text):
        return _plain(text)
    written = standing_alone(text).replace(r"\|", r"\Vert ").replace("|", r"\vert ")
    return f"${' '.join(written.split())}$"


def _plain(text: str) -> str:
    return _escaped(" ".join(text.split()))


def _escaped(text: str) -> str:
    return _MARKUP.sub(r"\\\1", text)


FORMAT = Format("errata and ledger as Markdown", text)
