"""The errata and the ledger as a LaTeX document that stands alone and needs AMS's packages only."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby

from symcheck.core.verdicts import Verdict
from symcheck.ledger.record import Record
from symcheck.views.exports import Format
from symcheck.views.faults import Fault, errata, fails_at, statement
from symcheck.views.latex import is_formula, standing_alone

HEAD = r"""\documentclass[10pt,a4paper]{article}
\usepackage[utf8]{inputenc}
\usepackage[margin=22mm]{geometry}
\usepackage{amsmath,amssymb}
\DeclareMathOperator{\arctg}{arctg}
\setlength{\parindent}{0pt}\setlength{\parskip}{4pt}\raggedright
\newcommand{\entry}[2]{\par\medskip\textbf{#1}\quad\textsf{\small #2}\par}
\newcommand{\said}[2]{\par\hangindent=6em\makebox[6em][l]{\textsf{\small #1}}#2}
"""
LATIN = {"к": "k", "г": "g", "м": "m", "с": "s", "Н": "N", "−": "-", "≠": r"\ensuremath{\ne}"}  # units, signs
_SPECIAL = re.compile(r"[\\{}$&#^_~%<>|]")
_ESCAPED = {"\\": r"\textbackslash{}", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}"} | {
    sign: rf"\ensuremath{{{sign}}}" for sign in "<>|"
}


def text(records: Sequence[Record]) -> str:
    """The document."""
    body = "\n".join((*_errata(records), *_ledger(records)))
    found = Counter(record.verdict for record in records if record.verdict)
    counts = ", ".join(f"{found[each]} {each}" for each in Verdict)
    letters = "\n".join(
        rf"\DeclareUnicodeCharacter{{{ord(c):04X}}}{{{LATIN.get(c, '?')}}}"
        for c in sorted(set(body))
        if not c.isascii()
    )
    title = rf"\section*{{Audit of printed equations}}{found.total()} relations: {counts}."
    return f"{HEAD}{letters}\n\\begin{{document}}\n{title}\n{body}\n\\end{{document}}\n"


def _errata(records: Sequence[Record]) -> Iterator[str]:
    for group, members in errata(records):
        yield rf"\section*{{{str(group).capitalize()}}}"
        for alike in members:
            yield from map(_wrong, alike.faults)


def _wrong(fault: Fault) -> str:
    record = fault.first
    lines = {
        "words": _plain(record.words) if fault.printed != record.words else "",
        "printed": _formula(fault.printed, record.line),
        "correct": _formula(fault.correct, record.line),
        "given": _plain("; ".join(fault.added)),
        "fails at": _plain(fails_at(record.counterexample)) if not record.is_row else "",
        "why": _plain(record.reason),
    }
    said = "\n".join(rf"\said{{{label}}}{{{line}}}" for label, line in lines.items() if line)
    title, kind = _plain(f"{record.paper}:{fault.number}"), _plain(f"{record.kind}, line {record.line}")
    return f"\\entry{{{title}}}{{{kind}}}\n{said}"


def _ledger(records: Iterable[Record]) -> Iterator[str]:
    for paper, rows in groupby(records, lambda record: record.paper):
        yield rf"\section*{{{paper}}}"
        for record in rows:
            said = _formula(statement(record), record.line)
            number = _plain(record.id.partition(":")[2])
            yield rf"\said{{\textbf{{{number}}}}}{{\textit{{{record.verdict or record.role}}}\quad {said}}}"


def _formula(text: str, line: int) -> str:
    if is_formula(text):
        return f"${' '.join(standing_alone(text).split())}$"
    return _plain(text) if text.isascii() else rf"\textit{{damaged text, see line {line} of the source}}"


def _plain(text: str) -> str:
    return _SPECIAL.sub(lambda found: _ESCAPED.get(found[0], f"\\{found[0]}"), " ".join(text.split()))


FORMAT = Format("errata and ledger as a LaTeX document", text)
