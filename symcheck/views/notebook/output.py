"""What a cell shows: headings, mathematics with labels, prose, tables, pictures; as Markdown, LaTeX and plain text."""

from __future__ import annotations

import base64
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from symcheck.views.latex import is_formula, only_formula, standing_alone

MARKDOWN, LATEX, PLAIN, PNG = "text/markdown", "text/latex", "text/plain", "image/png"


@dataclass(frozen=True)
class Heading:
    """What is shown, in one line of Markdown."""

    text: str


@dataclass(frozen=True)
class _Labelled:
    label: str
    text: str


class Math(_Labelled):
    """Formulas in LaTeX with their labels; consecutive ones stand side by side in one display."""


class Prose(_Labelled):
    """A labelled sentence, as plain text."""


class Verbatim(_Labelled):
    """Lines that are shown as they are."""


class Code(Verbatim):
    """Lines of Python."""


@dataclass(frozen=True)
class Table:
    """Rows of short texts below their headings; what stands between dollars is mathematics."""

    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


@dataclass(frozen=True)
class Picture:
    """A PNG file with what it shows."""

    png: bytes
    caption: str


@dataclass(frozen=True)
class Hidden:
    """Parts that are seen when somebody unfolds them."""

    label: str
    parts: tuple[Part, ...]


Part = Heading | Math | Prose | Verbatim | Table | Picture | Hidden


@dataclass(frozen=True)
class Output:
    """The parts of one output, in order. Jupyter asks for its `_repr_mimebundle_`."""

    parts: tuple[Part, ...]

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        pictures = [part for part in self.parts if isinstance(part, Picture)]
        if pictures:
            return {
                PNG: base64.b64encode(pictures[0].png).decode(),
                PLAIN: "\n".join(map(_plain, self.parts)),
            }
        latex = [part.text for part in self.parts if isinstance(part, Math)]
        texts = {MARKDOWN: "\n\n".join(_markdown(self.parts)), PLAIN: "\n".join(map(_plain, self.parts))}
        return {**texts, LATEX: "\n".join(rf"\[{each}\]" for each in latex)} if latex else texts

    def __repr__(self) -> str:
        return "\n".join(map(_plain, self.parts))


def _plain(part: Part) -> str:
    match part:
        case Heading(text) | Picture(_, text):
            return text
        case _Labelled(label, text):
            return f"{label}: {text}" if label else text
        case Table(head, rows):
            return "\n".join(" | ".join(row) for row in (head, *rows))
        case Hidden(label, parts):
            return "\n".join((f"{label}:", *map(_plain, parts)))


def _markdown(parts: Sequence[Part]) -> Iterator[str]:
    display: list[Math] = []
    for part in (*parts, None):
        if isinstance(part, Math) and is_formula(part.text):
            display.append(part)
            continue
        if display:
            yield _display(display)
            display = []
        if isinstance(part, Hidden):
            yield from (f"<details><summary>{part.label}</summary>", *_markdown(part.parts), "</details>")
        elif part is not None:
            yield _block(part)


def _display(formulas: Sequence[Math]) -> str:
    """One array, as a formula of the line: a displayed one would stand in the middle of the page."""
    rows = (rf"\textsf{{{formula.label}}} & \displaystyle {formula.text}" for formula in formulas)
    return r"$\begin{array}{ll}" + r" \\[6pt] ".join(rows) + r"\end{array}$"


def _block(part: Part) -> str:
    match part:
        case Heading(text):
            return text
        case Prose(label, text):
            return f"*{label}:* {_escaped(text)}" if label else _escaped(text)
        case Code(label, text):
            return (f"*{label}:*\n\n" if label else "") + f"```python\n{text}\n```"
        case Verbatim(label, text) | Math(label, text):  # a damaged formula, which cannot be set
            return (f"*{label}:*\n\n" if label else "") + f"```text\n{text}\n```"
        case Table(head, rows):
            lines = (head, ("---",) * len(head), *(tuple(map(_cell, row)) for row in rows))
            return "\n".join(f"| {' | '.join(line)} |" for line in lines)
    raise TypeError(f"{type(part).__name__} is shown otherwise")


def _cell(text: str) -> str:
    """Lines stay lines; a bar would end the cell, also inside mathematics."""
    return "<br>".join(_formula_or_text(" ".join(line.split())) for line in text.split("\n"))


def _formula_or_text(line: str) -> str:
    if formula := only_formula(line):  # which may be a row of an array
        line = f"${standing_alone(formula)}$"
    return line.replace("|", r"\vert ") if line.startswith("$") else _escaped(line).replace("|", r"\|")


def _escaped(text: str) -> str:
    return re.sub(r"([\\`*_<$])", r"\\\1", text)
