r"""The errata of one paper as a letter to its authors or its editor, in Markdown, LaTeX or HTML.

Numbered corrections first, then one table of list rows and table cells and one of slips. Whatever came with the
digitisation is left out, and so is everything of ours: numbers of declarations become lines of the text.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from itertools import count

from markupsafe import escape

from symcheck import papers
from symcheck.core.claims import Paper
from symcheck.core.ids import Id
from symcheck.core.verdicts import Group, Origin, SymcheckError
from symcheck.ledger import Record
from symcheck.views.latex import formulas_of, is_formula, only_formula, split_at_formulas, standing_alone
from symcheck.views.model import Fault, errata

_EQUATION = re.compile(r"\d+\.\d+")  # the number of a declaration that is printed as a tag: 2.18
_LISTS = {"V": "vertices", "E": "edges", "F": "faces"}  # by the last letter of their numbers: 2.1V
# what our declarations are called: 2.13.1, 2.1V.3b, T8.0, B.7, S.7.1
_OURS = r"(?:\d+\.\d+(?:\.\d+)+[a-z]?|\d+\.\d+[VEF](?:\.\d+[a-z]?)?|T\d+\.\d+[a-z]?|[A-Z]\.\d+(?:\.\d+)?[a-z]?)"
_NUMBER = re.compile(rf"(?<![\w.]){_OURS}(?![\w])")  # such a number as a whole
# brackets with nothing but such numbers: "(2.13.1, B.7)", "(see C.11)", "(B.9 to B.12)"
_ASIDE = re.compile(rf"\s*\((?:see )?{_OURS}(?:(?:, | and | to |; ){_OURS})*\)")
_FIRST = re.compile(r".+?[.](?=\s+[A-Z(\"']|$)", re.DOTALL)  # the first sentence of a text
_MARKUP = re.compile(r"[\\${}]")  # the first or last word is a piece of a formula, and no word to quote
_MARKS = re.compile(r"[\\*_<>`|\[\]]")  # what Markdown takes for its own


UNKNOWN = "(what is right is left to the authors)"


class Form(StrEnum):
    """How a letter is written."""

    MARKDOWN = "markdown"
    LATEX = "latex"
    HTML = "html"


SUFFIXES = {".md": Form.MARKDOWN, ".tex": Form.LATEX, ".html": Form.HTML, ".htm": Form.HTML}


@dataclass(frozen=True)
class Correction:
    """One correction: where, what is printed, what is right, one sentence why, and the evidence.

    Texts hold formulas between dollar signs; a text that is one formula is displayed.
    """

    where: str
    printed: str
    correct: str
    reason: str
    evidence: str


@dataclass(frozen=True)
class Letter:
    """All corrections of one paper."""

    title: str
    corrections: tuple[Correction, ...]
    rows: tuple[Correction, ...]
    slips: tuple[Correction, ...]

    @property
    def tables(self) -> Iterator[tuple[str, tuple[Correction, ...]]]:
        """The two tables, each with its title, if it has rows."""
        for title, rows in (
            ("Rows of lists and cells of tables", self.rows),
            ("Slips that mislead nobody", self.slips),
        ):
            if rows:
                yield title, rows


def letter(records: Iterable[Record]) -> Letter:
    """The letter about the errata among the records.

    Raises
    ------
    SymcheckError
        If they are not of one paper, or nothing of them is the authors' concern.
    """
    wrong = [
        record
        for record in records
        if record.is_erratum and record.origin is not Origin.OCR and not _is_whole_list(record)
    ]
    keys = list(dict.fromkeys(record.paper for record in wrong))
    if not keys:
        raise SymcheckError("no erratum concerns the authors; `symcheck errata` lists damage by the digitisation")
    if len(keys) > 1:
        raise SymcheckError(f"a letter is about one paper, not about {' and '.join(keys)}; select one of them")
    paper = papers.load()[keys[0]]
    faults_of: dict[Group, list[Fault]] = {group: [] for group in Group}
    for group, lists in errata(wrong):
        faults_of[group] += [fault for faults in lists for fault in faults.faults]
    faults_of[Group.STATEMENT] += faults_of[Group.DAMAGED]
    numbered, rows, slips = (
        tuple(_correction(paper, fault) for fault in sorted(faults_of[group], key=lambda each: each.first.record.line))
        for group in (Group.STATEMENT, Group.ROW, Group.SLIP)
    )
    return Letter(paper.title, numbered, rows, slips)


def _is_whole_list(record: Record) -> bool:
    """Whether something is said of a list as a whole, which follows from its rows."""
    return Id.parse(record.id).number.endswith(tuple(_LISTS))


def _correction(paper: Paper, fault: Fault) -> Correction:
    record, erratum = fault.first.record, fault.first.record.erratum
    lines = {item.number: item.source.line for _, _, item in paper.items()}
    summary, instead = (erratum.summary, erratum.instead) if erratum else ("", "")
    reason = plain(record.reason, lines)
    first = _FIRST.match(reason)
    short = first[0] if first else reason
    rest = reason if summary else reason.removeprefix(short).strip()
    evidence = ["" if record.is_row else _refutation(fault), rest]
    if record.group in (Group.ROW, Group.SLIP):
        short = f"{_capital(record.kind)}. {short}"
    return Correction(
        _where(record),
        _printed(record, fault, lines),
        instead or _correct(fault) or UNKNOWN,
        (summary or short) + (" (It may have come with the digitisation.)" if _may_be_ocr(record) else ""),
        " ".join(filter(None, evidence)),
    )


def _refutation(fault: Fault) -> str:
    """Where what is printed fails, in one sentence; the empty text where no point is known."""
    found = fault.first.counterexample
    if not found:
        return ""
    return f"As printed it fails, for example, at {found.line}." if found.values else f"As printed, {found.sides}."


def _may_be_ocr(record: Record) -> bool:
    return record.origin is Origin.UNCERTAIN and record.group in (Group.STATEMENT, Group.DAMAGED)


def _printed(record: Record, fault: Fault, lines: Mapping[str, int]) -> str:
    """The printed formula, or of a chain the one link; a sentence by its first and last word, with what it says."""
    sentence = record.place.partition(": ")[2]
    if sentence and (record.group is not Group.DAMAGED or not record.printed):
        words = plain(_first_sentence(record.words), lines)
        return words if _MARKUP.search(sentence) else f"“{sentence}” ({words})"
    is_one_link = record.link and record.erratum
    return _as_text(record.read if is_one_link else record.printed or record.read or record.words)


def _first_sentence(words: str) -> str:
    """The first sentence of what our words say, without its stop."""
    first = _FIRST.match(words)
    return (first[0] if first else words).rstrip(".:")


def _correct(fault: Fault) -> str:
    given = "; ".join(fault.first.added)
    if not given:
        return _as_text(fault.correct)
    record = fault.first.record
    return f"the same, given that {given}" if record.place else f"{_as_text(fault.correct)}, given that {given}"


def _as_text(text: str) -> str:
    """A formula between dollar signs, or words as they are."""
    return f"${standing_alone(text)}$" if is_formula(text) else text


def _where(record: Record) -> str:
    """The printed number or the row, and the line."""
    id, line = Id.parse(record.id), f"line {record.line}"
    listing = id.listing.number
    if listing.endswith(tuple(_LISTS)):
        return f"section {listing[:-1]}, list of {_LISTS[listing[-1]]}, row {id.row}, {line}"
    if listing.startswith("T"):
        return f"table {listing[1:]}, {line}"
    if _EQUATION.fullmatch(id.number):
        return f"({id.number}), {line}"
    return line


def plain(text: str, lines: Mapping[str, int]) -> str:
    """A reason in which the numbers of our declarations are lines of the text, or left out where they are ours alone.

    >>> plain("It is so (B.7), as 2.13.1 says, but not (2.10).", {"2.13.1": 336, "B.7": 1})
    'It is so, as line 336 says, but not (2.10).'
    """

    def placed(match: re.Match[str]) -> str:
        number = match[0].rstrip("abcdefgh") if match[0] not in lines else match[0]
        return "a check of ours" if number[0] in "BCNS" or number not in lines else f"line {lines[number]}"

    prose = _NUMBER.sub(placed, _ASIDE.sub("", text))
    return " ".join(prose.replace("OCR", "digitisation").split())


# --- the three forms


def written(content: Letter, form: Form) -> str:
    """The letter in one of its forms."""
    return {Form.MARKDOWN: _markdown, Form.LATEX: _latex, Form.HTML: _html}[form](content)


GREETING = (
    "The following was found in reading the paper. Each relation was worked out anew; lines are those of the text at "
    "hand, numbers in brackets those of the paper."
)
# the widths of the columns where, printed, correct, why: 220 mm in all, beside the number
LONGTABLE = (
    "".join(rf">{{\raggedright}}p{{{width}mm}}" for width in (26, 72, 72)) + r">{\raggedright\arraybackslash}p{50mm}"
)
COLUMNS = ("", "where", "printed", "correct", "why")


def _parts(text: str, formula: Callable[[str], str], words: Callable[[str], str]) -> str:
    """A text with its formulas and its words each written in their way."""
    pieces = split_at_formulas(text)
    return "".join(formula(piece) if n % 2 else words(piece) for n, piece in enumerate(pieces))


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def _markdown(content: Letter) -> str:
    return "\n".join(_markdown_lines(content)).rstrip() + "\n"


def _marked(text: str) -> str:
    """A text in Markdown: its words with no sign that Markdown takes for its own."""
    return _parts(text, lambda latex: f"${latex}$", lambda words: _MARKS.sub(r"\\\g<0>", words))


def _markdown_lines(content: Letter) -> Iterator[str]:
    yield from (f"# Corrections to {_marked(content.title)}", "", _marked(GREETING), "")
    for number, each in enumerate(content.corrections, 1):
        yield from (f"**{number}.** {_capital(each.where)}.", "")
        for label, text in (("Printed", each.printed), ("Correct", each.correct)):
            shown = only_formula(text)
            yield from (f"{label}:", "", f"$${shown}$$", "") if shown else (f"{label}: {_marked(text)}", "")
        yield from (_marked(each.reason), "")
        if each.evidence:
            yield from (f"<details><summary>Evidence</summary>\n\n{_marked(each.evidence)}\n\n</details>", "")
    for title, rows in content.tables:
        yield from (f"## {title}", "", f"| {' | '.join(COLUMNS)} |", f"|{' --- |' * len(COLUMNS)}")
        for number, row in enumerate(rows, 1):
            cells = (str(number), row.where, *map(_marked, (row.printed, row.correct, row.reason)))
            yield f"| {' | '.join(' '.join(cell.split()) for cell in cells)} |"
        yield ""


_SPECIAL = {
    **{sign: rf"\{sign}" for sign in "&%$#_{}"},
    "\\": r"\textbackslash{}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "“": "``",
    "”": "''",
    "…": r"\dots{}",
    "≠": r"$\neq$",
}
PREAMBLE = r"""\documentclass[11pt]{article}
\usepackage[utf8]{inputenc}
\usepackage[T2A,T1]{fontenc}
\usepackage{amsmath,amssymb,longtable,array,graphicx,pdflscape}
\usepackage[a4paper,margin=25mm]{geometry}
\DeclareMathOperator{\tg}{tg}
\DeclareMathOperator{\arctg}{arctg}
\newcommand{\cyrillicwords}[1]{{\fontencoding{T2A}\selectfont #1}}
% a displayed formula, smaller where it is wider than the line
\newcommand{\displayed}[1]{\sbox0{$\displaystyle #1$}%
\[\ifdim\wd0>\linewidth\resizebox{\linewidth}{!}{\usebox0}\else\usebox0\fi\]}
\sloppy
"""
_CYRILLIC = re.compile(r"[\u0400-\u04ff]+")  # words that need a Cyrillic font
_ENVIRONMENT = re.compile(r"\\(?:begin|end)\{(?:aligned|split)\}|(?<!\\)&")  # what keeps a line from breaking
_BREAKS = re.compile(r"\\left|\\right|[(\[{]|[)\]}]|,|\\quad")  # brackets, and where a line may end outside of them


def _words(text: str) -> str:
    r"""Words in LaTeX.

    >>> _words("I_1 & 5 %")
    'I\\_1 \\& 5 \\%'
    """
    escaped = "".join(_SPECIAL.get(sign, sign) for sign in text)
    return _CYRILLIC.sub(lambda m: rf"\cyrillicwords{{{m[0]}}}", escaped)


def _sentence(text: str) -> str:
    return _parts(text, lambda latex: f"${latex}$", _words)


def _cell(text: str) -> str:
    """A text for a column of a table: its formulas may be broken at commas outside of brackets."""
    return _parts(text, lambda latex: f"${_breakable(latex)}$", _words)


def _breakable(latex: str) -> str:
    r"""A formula with places at which TeX may break it.

    >>> _breakable(r"(a, b), c \quad d")
    '(a, b),\\allowbreak{} c \\quad\\allowbreak{} d'
    """
    if r"\\" in latex:
        return latex
    depth = 0

    def ended(match: re.Match[str]) -> str:
        nonlocal depth
        depth += (match[0] in "([{") - (match[0] in ")]}")
        return rf"{match[0]}\allowbreak{{}}" if depth == 0 and match[0] in (",", r"\quad") else match[0]

    return _BREAKS.sub(ended, _ENVIRONMENT.sub("", latex))


def _latex(content: Letter) -> str:
    return PREAMBLE + "\n".join(("\\begin{document}", *_latex_lines(content), "\\end{document}", ""))


def _latex_lines(content: Letter) -> Iterator[str]:
    yield rf"\section*{{Corrections to {_words(content.title)}}}"
    yield from (_words(GREETING), "", r"\begin{enumerate}" if content.corrections else "")
    for correction in content.corrections:
        yield rf"\item {_words(_capital(correction.where))}."
        for label, text in (("Printed", correction.printed), ("Correct", correction.correct)):
            shown = only_formula(text)
            yield rf"\par {label}: \displayed{{{shown}}}" if shown else rf"\par {label}: {_sentence(text)}"
        yield rf"\par {_sentence(correction.reason)}"
        if correction.evidence:
            yield rf"\par{{\small {_sentence(correction.evidence)}}}"
    yield r"\end{enumerate}" if content.corrections else ""
    for title, rows in content.tables:
        yield from (r"\begin{landscape}", rf"\subsection*{{{_words(title)}}}", r"{\footnotesize")
        yield rf"\begin{{longtable}}{{r{LONGTABLE}}}"
        yield f"{' & '.join(COLUMNS)} \\\\ \\hline \\endhead"
        for number, row in enumerate(rows, 1):
            cells = (_words(row.where), _cell(row.printed), _cell(row.correct), _sentence(row.reason))
            yield f"{number} & {' & '.join(cells)} \\\\"
        yield from (r"\end{longtable}}", r"\end{landscape}")


STYLE = """@page{size:A4;margin:22mm}
body{font:11pt/1.45 Georgia,'Times New Roman',serif;max-width:46em;margin:2em auto;padding:0 1em;color:#111}
h1{font-size:1.35em}h2{font-size:1.1em;margin-top:2em}li{margin:0 0 1.2em;break-inside:avoid}
p{margin:.3em 0}.display{display:block;overflow-x:auto;overflow-y:hidden;padding:.3em 0}
details{font-size:.88em;color:#333}summary{cursor:pointer}
table{border-collapse:collapse;font-size:.85em}
th,td{border-top:1px solid #999;padding:.3em .5em;text-align:left;vertical-align:top}
thead{display:table-header-group}tr{break-inside:avoid}
@media print{body{margin:0;max-width:none}.display{overflow:visible;font-size:.85em}
details::details-content{content-visibility:visible;display:block}summary{list-style:none}}"""


def _html(content: Letter) -> str:
    every = (*content.corrections, *content.rows, *content.slips)
    texts = [text for each in every for text in (each.printed, each.correct, each.reason, each.evidence)]
    return "\n".join(_html_lines(content, _math(texts))) + "\n"


def _math(texts: Iterable[str]) -> Mapping[str, str | None]:
    """The MathML of all formulas in the texts."""
    from symcheck.views.page.typeset import typeset  # starts an engine

    return typeset(formula for text in texts for formula in formulas_of(text))


def _html_lines(content: Letter, math: Mapping[str, str | None]) -> Iterator[str]:
    def markup(text: str) -> str:
        shown = only_formula(text)
        whole = _parts(
            text, lambda latex: math[latex] or f"<code>{escape(latex)}</code>", lambda words: str(escape(words))
        )
        return f'<span class="display">{whole}</span>' if shown else whole

    title = escape(f"Corrections to {content.title}")
    yield f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title>'
    yield f"<style>{STYLE}</style></head><body>"
    yield f"<h1>{title}</h1>\n<p>{escape(GREETING)}</p>\n<ol>"
    for correction in content.corrections:
        yield f"<li><p><b>{escape(_capital(correction.where))}.</b></p>"
        printed, correct, reason = map(markup, (correction.printed, correction.correct, correction.reason))
        yield f"<p>Printed: {printed}</p><p>Correct: {correct}</p><p>{reason}</p>"
        if correction.evidence:
            yield f"<details><summary>Evidence</summary><p>{markup(correction.evidence)}</p></details>"
        yield "</li>"
    yield "</ol>"
    for heading, rows in content.tables:
        yield f"<h2>{escape(heading)}</h2>\n<table><thead><tr>{_cells('th', COLUMNS)}</tr></thead><tbody>"
        for number, row in zip(count(1), rows, strict=False):
            cells = (str(number), str(escape(row.where)), *map(markup, (row.printed, row.correct, row.reason)))
            yield f"<tr>{_cells('td', cells)}</tr>"
        yield "</tbody></table>"
    yield "</body></html>"


def _cells(tag: str, texts: Sequence[str]) -> str:
    return "".join(f"<{tag}>{text}</{tag}>" for text in texts)
