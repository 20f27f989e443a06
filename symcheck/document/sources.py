"""From a file to the formulas that it prints, whatever its markup is."""

from __future__ import annotations

import re
from pathlib import Path

from symcheck.core.verdicts import SymcheckError
from symcheck.document.files import text_of
from symcheck.document.latex import Scanner
from symcheck.document.macros import Expander, tokens
from symcheck.document.printed import Source
from symcheck.document.units import SCALED

MARKUPS = {
    **dict.fromkeys((".tex", ".ltx", ".latex", ".sty"), "latex"),
    **dict.fromkeys((".md", ".markdown", ".qmd", ".rmd", ".myst"), "markdown"),
    **dict.fromkeys((".rst", ".rest"), "restructured"),
    ".ipynb": "notebook",
}
# what only LaTeX has, where the name of a file does not say it
_LATEX = re.compile(r"\\(?:documentclass|begin\{document\}|(?:sub)*section\*?\{|input\{)")
# only reStructuredText has these
_RESTRUCTURED = re.compile(r"^\s*\.\. math::|:math:`", re.MULTILINE)


def source(file: Path) -> Source:
    """The formulas of a file; SymcheckError if it cannot be read, or has none."""
    text = text_of(file)
    expander = Expander(file.parent)
    scanner = Scanner(expander)
    try:
        _scan(text, _markup(file, text), scanner)
    except SymcheckError as error:
        raise SymcheckError(f"{file}: {error}") from error
    except RecursionError:
        raise SymcheckError(f"{file}: it is nested too deeply to be read") from None
    if not scanner.found and not scanner.faults:
        more = f" ({'; '.join(expander.notes[:3])})" if expander.notes else ""
        raise SymcheckError(f"{file} has no formula{more}; displays, and relations between $ and $, are looked for")
    told = () if SCALED.search(text) else tuple(scanner.told)
    return Source(
        tuple(scanner.found),
        tuple(scanner.faults),
        tuple(expander.notes),
        tuple(scanner.mentions),
        told,
        frozenset(scanner.units),
    )


def _markup(file: Path, text: str) -> str:
    known = MARKUPS.get(file.suffix.lower())
    if known:
        return known
    return "latex" if _LATEX.search(text) else "restructured" if _RESTRUCTURED.search(text) else "markdown"


def _scan(text: str, markup: str, scanner: Scanner) -> None:
    if markup == "latex":
        scanner.run([*scanner.expander.run(tokens(text))])
    elif markup == "restructured":
        from symcheck.document.restructured import restructured

        restructured(text, scanner)
    else:
        from symcheck.document.markdown import markdown, notebook

        (notebook if markup == "notebook" else markdown)(text, scanner)
