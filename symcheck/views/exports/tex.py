"""The errata and the ledger as a LaTeX document that stands alone and needs AMS's packages only."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from symcheck.ledger import Record, by_paper
from symcheck.views.dimensions import unlike
from symcheck.views.exports import Format
from symcheck.views.latex import is_formula, sentence, standing_alone
from symcheck.views.model import Fact, Fault, Relation, errata, headline

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
_SPECIAL = re.compile(r"[\\{}$&#^_~%<>|]")  # signs that mean something in TeX, or are missing from its text fonts
_ESCAPED = {"\\": r"\textbackslash{}", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}"} | {
    sign: rf"\ensuremath{{{sign}}}" for sign in "<>|"
}


def text(records: Sequence[Record]) -> str:
    """The document."""
    said = " ".join(f"{_plain(line)}." for line in headline(records))
    title = rf"\section*{{Audit of printed equations}}{said}"
    body = "\n".join((title, *_lines(records)))
    letters = "\n".join(
        rf"\DeclareUnicodeCharacter{{{ord(c):04X}}}{{{LATIN.get(c, '?')}}}"
        for c in sorted(set(body))
        if not c.isascii()
    )
    return f"{HEAD}{letters}\n\\begin{{document}}\n{body}\n\\end{{document}}\n"


def _lines(records: Sequence[Record]) -> Iterator[str]:
    for group, lists in errata(records):
        yield rf"\section*{{{str(group).capitalize()}}}"
        yield from (_fault(fault) for each in lists for fault in each.faults)
    for paper, rows in by_paper(records).items():
        yield rf"\section*{{{paper}}}"
        for relation in map(Relation, rows):
            said = _formula(relation.statement, relation.record.line)
            number, told = _plain(relation.record.number), unlike(relation.record.dimension)
            yield rf"\said{{\textbf{{{number}}}}}{{\textit{{{relation.state}}}\quad {said}}}"
            if told:
                yield rf"\said{{}}{{\textit{{dimensions}}\quad {_plain(told)}}}"


def _fault(fault: Fault) -> str:
    record = fault.first.record
    title, kind = _plain(f"{record.paper}:{fault.number}"), _plain(f"{record.kind}, line {record.line}")
    facts = (rf"\said{{{each.label}}}{{{_said(each, record.line)}}}" for each in fault.facts if each.text)
    return "\n".join((rf"\entry{{{title}}}{{{kind}}}", *facts))


def _said(fact: Fact, line: int) -> str:
    if fact.is_formula:
        return _formula(fact.text, line)
    return sentence(fact.text, _escaped) if fact.is_ours else _plain(fact.text)


def _formula(text: str, line: int) -> str:
    if is_formula(text):
        return f"${' '.join(standing_alone(text).split())}$"
    return _plain(text) if text.isascii() else rf"\textit{{damaged text, see line {line} of the source}}"


def _plain(text: str) -> str:
    return _escaped(" ".join(text.split()))


def _escaped(text: str) -> str:
    return _SPECIAL.sub(lambda found: _ESCAPED.get(found[0], f"\\{found[0]}"), text)


FORMAT = Format("errata and ledger as a LaTeX document", text)
