"""A notebook from its source: Markdown, with the cells of code fenced as python.

Prose begins a new cell at each heading. The id of a cell is its heading in lower case and its number below that
heading: a cell that is added elsewhere changes no other id.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from symcheck.core.verdicts import SymcheckError
from symcheck.views.notebook.rules import faults_of_code, faults_of_prose

_FENCE = re.compile(r"^```python\n(.*?)^```$\n?", re.MULTILINE | re.DOTALL)
_HEADING = re.compile(r"^(?=#{1,6} )", re.MULTILINE)
GUIDE = "guide"  # pages about the program, whose cells may show any code
METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}


def notebook(source: Path) -> Any:
    """The notebook of a source, without outputs; SymcheckError for a cell that breaks the rules."""
    from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

    cells, counts, section = [], Counter[str](), "top"
    rules = {} if source.parent.name == GUIDE else {"code": faults_of_code, "markdown": faults_of_prose}
    for kind, text in pieces(source.read_text(encoding="utf-8")):
        for fault in rules[kind](text) if rules else ():
            raise SymcheckError(f"{source.name}: {fault}: {text.splitlines()[0]}")
        if text.startswith("#"):
            section = slug(text.splitlines()[0])
        counts[section] += 1
        new = new_code_cell if kind == "code" else new_markdown_cell
        cells.append(new(text, id=f"{section}-{counts[section]}"))
    return new_notebook(cells=cells, metadata=METADATA)


def pieces(text: str) -> Iterator[tuple[str, str]]:
    """The cells as ("code" or "markdown", text)."""
    for n, part in enumerate(_FENCE.split(text)):
        if n % 2:
            yield "code", part.strip()
        else:
            yield from (("markdown", each.strip()) for each in _HEADING.split(part) if each.strip())


def slug(heading: str) -> str:
    """A heading as the beginning of an id: "## The damping matrix" is "the-damping-matrix"."""
    return re.sub(r"[^a-z0-9]+", "-", heading.lower()).strip("-")[:50].strip("-") or "top"
