"""Markdown, also of Quarto and MyST, and notebooks: the formulas that markdown-it finds."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence

from markdown_it import MarkdownIt
from markdown_it.token import Token
from mdit_py_plugins.amsmath import amsmath_plugin
from mdit_py_plugins.dollarmath import dollarmath_plugin
from mdit_py_plugins.front_matter import front_matter_plugin
from mdit_py_plugins.myst_role import myst_role_plugin
from mdit_py_plugins.texmath import texmath_plugin
from mdit_py_plugins.texmath.index import make_block_func, rules

from symcheck.core.verdicts import SymcheckError
from symcheck.document.latex import Scanner
from symcheck.document.macros import tokens

MAX_NESTING = 50  # lists and quotations in one another; deeper ones are left out
_FENCED = re.compile(r"\{math\}|math")  # the language of a fence that is a formula
_OPTION = re.compile(r"\s*:(\w+):[^\S\n]*(.*)\n?")  # `:label: name`, at the top of a fence
_LABEL = re.compile(r"\s*(?:\(([\w:.-]+)\)|\{#([\w:.-]+)[^}]*\})")  # behind a formula: `(name)` or `{#name}`
# a directive of MyST that is a formula, between colons, or up to the end
_COLONS = re.compile(r"^([ \t]*)(:::+)[ \t]*\{math\}(.*?\n)(?:[ \t]*\2[ \t]*$|\Z)", re.DOTALL | re.MULTILINE)
_DIRECTIVES = re.compile(r"^:::.*$", re.MULTILINE)  # the lines of Quarto and MyST around a part, which itself is read
# a macro is defined, in what the code of a notebook prints
_DEFINES = re.compile(r"\\(?:def|let|(?:re)?newcommand|providecommand|DeclareMathOperator)(?![A-Za-z])")
# `\_` before a subscript; in words, which come first, it is the sign itself
_ESCAPED = re.compile(r"(\\(?:text\w*|mathrm|operatorname|mbox)\s*\{[^{}]*\})|\\_(?=[{\\A-Za-z0-9])")
_UNQUOTED = re.compile(r"^[^\S\n]*(?:>[^\S\n]?)+", re.MULTILINE)  # the signs of a quotation before its lines
_QUOTED = re.compile(r"\s*`([^`]+)`\s*")  # the dollars of GitHub and GitLab stand around such quotes

HEADINGS = {"h1": "chapter", "h2": "section"}  # all others are subsections
_HIDDEN = re.compile(r"\s*<(?:!|\?|script|style|pre)", re.I)  # HTML of which a reader sees no formula
_HEADING = re.compile(r"<(h[1-6])\b", re.I)  # of HTML
_TAG = re.compile(r"</?[A-Za-z][^<>$]*>")  # and no sign of order between formulas

# an environment of displays between double dollars, as MathJax wants it: the dollars say nothing more
_ENVIRONMENT = re.compile(
    r"^([^\S\n]*)\$\$(\s*\\begin\{((?:equation|align|gather|multline|eqnarray)\*?)\}.*?\\end\{\3\}\s*)\$\$",
    re.DOTALL | re.MULTILINE,
)


def markdown(text: str, scanner: Scanner) -> None:
    """The formulas of Markdown."""
    lines = text.split("\n")
    at = quoted = 0
    text = _DIRECTIVES.sub("", _COLONS.sub(r"\1```{math}\3\1```", text))
    for token in _parser().parse(_ENVIRONMENT.sub(r"\1  \2  ", text)):
        at = token.map[0] if token.map else at
        if token.type in ("blockquote_open", "blockquote_close"):
            quoted += token.nesting
        if token.type == "heading_open":
            scanner.heading(HEADINGS.get(token.tag, "subsection"))
        elif token.type == "inline":
            _inline(token.children or [], lines, at, scanner)
        elif token.type in ("math_block", "math_block_label", "amsmath"):
            label = token.info if token.type == "math_block_label" else ""
            body = _UNQUOTED.sub("", token.content) if quoted and token.markup == r"\[" else token.content
            scanner.put(_unescaped(body), _line(lines, at, body), label=label)
        elif token.type == "html_block" and not _HIDDEN.match(token.content):
            _within_html(token.content, at, scanner)
        elif token.type == "fence" and _FENCED.fullmatch(token.info.strip()):
            body, label = _options(token.content)
            scanner.put(body, _line(lines, at, body), label=label)


def _within_html(content: str, at: int, scanner: Scanner) -> None:
    """The formulas between the tags of HTML, where MathJax finds them as it does elsewhere."""
    for heading in _HEADING.findall(content):
        scanner.heading(HEADINGS.get(heading.lower(), "subsection"))
    lines = _TAG.sub(" ", content).split("\n")
    markdown("\n" * at + "\n".join(line.strip() for line in lines), scanner)


def _parser() -> MarkdownIt:
    parser = MarkdownIt("commonmark", {"maxNesting": MAX_NESTING}).enable("table")
    parser.use(front_matter_plugin).use(texmath_plugin, delimiters="brackets")
    for rule in rules["brackets"]["block"]:  # displays part paragraphs, as they do where MathJax finds them
        parser.block.ruler.at(rule["name"], make_block_func(rule), {"alt": ["paragraph", "reference", "blockquote"]})
    parser.use(dollarmath_plugin, double_inline=True, allow_labels=True)
    return parser.use(amsmath_plugin).use(myst_role_plugin)


def _inline(parts: Sequence[Token], lines: Sequence[str], at: int, scanner: Scanner) -> None:
    for k, part in enumerate(parts):
        if part.type == "text":
            scanner.words(part.content)
        elif part.type == "softbreak":
            scanner.words(" ")
        elif part.type == "math_inline_double":
            behind = parts[k + 1].content if k + 1 < len(parts) else ""
            found = _LABEL.match(behind)
            label = (found[1] or found[2]) if found else ""
            scanner.put(_unescaped(part.content), _line(lines, at, part.content), label)
        elif part.type == "math_inline" or (part.type == "myst_role" and part.meta.get("name") == "math"):
            dollar = "$" if part.type == "math_inline" else ""  # without it a letter is found in words, too
            line = _line(lines, at, f"{dollar}{part.content}{dollar}")
            scanner.put(_unescaped(part.content), line, display=False)
        elif part.type == "myst_role" and part.meta.get("name") in ("eq", "math:eq", "math:numref"):
            scanner.words(rf"\eqref{{{part.content}}}")
    scanner.end()


def _unescaped(content: str) -> str:
    """A formula whose subscripts have a backslash, so that other readers of Markdown take them for no emphasis.

    Or that stands between backquotes, for the same reason.
    """
    if found := _QUOTED.fullmatch(content):
        return found[1]
    return _ESCAPED.sub(lambda found: found[1] or "_", content)


def _line(lines: Sequence[str], start: int, content: str) -> int:
    """The line, counted from 1, on which a formula begins that stands at a line or below."""
    first = next((line.strip() for line in content.split("\n") if line.strip()), "")
    return next((k + 1 for k in range(start, len(lines)) if first in lines[k]), start + 1)


def _options(content: str) -> tuple[str, str]:
    """A formula without the options at its top, and its label."""
    label = ""
    while found := _OPTION.match(content):
        label = found[2].strip() if found[1] in ("label", "name") else label
        content = content[found.end() :]
    return content, label


def notebook(text: str, scanner: Scanner) -> None:
    """The formulas in the Markdown cells of a notebook, with the macros that its code prints."""
    try:
        data = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise SymcheckError(f"it is no notebook ({error}); give one that Jupyter has written") from None
    cells = data.get("cells") if isinstance(data, dict) else None
    if not isinstance(cells, list):
        raise SymcheckError("it is no notebook of version 4; open it in Jupyter and save it anew")
    for number, cell in enumerate(cells, 1):
        if not isinstance(cell, dict):
            continue
        if cell.get("cell_type") == "markdown":
            scanner.cell = number
            markdown(_joined(cell.get("source", "")), scanner)
        outputs = cell.get("outputs")
        for output in outputs if isinstance(outputs, list) else ():
            data = output.get("data") if isinstance(output, dict) else None
            for kind in ("text/markdown", "text/latex"):
                printed = _joined(data.get(kind, "")) if isinstance(data, dict) else ""
                if _DEFINES.search(printed):
                    for _token in scanner.expander.run(tokens(printed)):
                        pass  # what a code cell prints is no formula of the document, but its macros hold there


def _joined(source: object) -> str:
    return "".join(map(str, source)) if isinstance(source, list) else str(source)
