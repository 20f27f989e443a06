"""A notebook from its source: Markdown, with the cells of code fenced as python, as Jupytext reads it.

Prose begins a new cell at each heading. The id of a cell is its heading in lower case and its number below that
heading: a cell that is added elsewhere changes no other id.
"""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING

from symcheck.core.verdicts import SymcheckError
from symcheck.views.notebook.rules import faults_of_code, faults_of_prose

if TYPE_CHECKING:
    from nbformat import NotebookNode

MARKDOWN = {"extension": ".md", "split_at_heading": True}
METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}


def notebook(source: Path) -> NotebookNode:
    """The notebook of a source, without outputs; SymcheckError for a cell that breaks the rules."""
    import jupytext
    from nbformat import from_dict

    built = jupytext.reads(source.read_text(encoding="utf-8"), fmt=MARKDOWN)
    built.metadata, counts, section = from_dict(METADATA), Counter[str](), "top"
    rules = {"code": faults_of_code, "markdown": faults_of_prose}
    for cell in built.cells:
        first = cell.source.partition("\n")[0]
        for fault in rules[cell.cell_type](cell.source):
            raise SymcheckError(f"{source.name}: {fault}: {first}")
        if first.startswith("#"):
            section = slug(first)
        counts[section] += 1
        cell.id = f"{section}-{counts[section]}"
    return built


def slug(heading: str) -> str:
    """A heading as the beginning of an id: "## The damping matrix" is "the-damping-matrix"."""
    return re.sub(r"[^a-z0-9]+", "-", heading.lower()).strip("-")[:50].strip("-") or "top"
