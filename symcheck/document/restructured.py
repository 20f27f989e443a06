"""reStructuredText: the formulas that docutils finds; what Sphinx adds to it is read for what it holds."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, ClassVar

from docutils import nodes
from docutils.core import publish_doctree
from docutils.parsers.rst import Directive, directives, roles

from symcheck.document.latex import Scanner

QUIET = {
    "report_level": 5,
    "halt_level": 5,
    "file_insertion_enabled": False,
    "raw_enabled": False,
    "_disable_config": True,
    "warning_stream": False,
}
_PARTS = re.compile(r"\n\s*\n")  # blank lines part the formulas of one directive


class Math(Directive):  # type: ignore[misc]
    """`.. math::`, with the options of Sphinx."""

    has_content = True
    optional_arguments = 1
    final_argument_whitespace = True
    option_spec: ClassVar[Any] = {
        "label": str,
        "name": str,
        "class": str,
        "nowrap": directives.flag,
        "no-wrap": directives.flag,
    }

    def run(self) -> list[nodes.Node]:
        text = "\n".join([*self.arguments, "", *self.content]).strip()
        node = nodes.math_block(text, text, label=self.options.get("label", self.options.get("name", "")))
        node.line = self.content_offset + 1 if self.content and not self.arguments else self.lineno
        return [node]


class Unknown(Directive):  # type: ignore[misc]
    """A directive of which nothing is known but that it holds text."""

    has_content = True
    optional_arguments = 1
    final_argument_whitespace = True

    def run(self) -> list[nodes.Node]:
        node = nodes.container()
        self.state.nested_parse(self.content, self.content_offset, node)
        return [node]


def _text(name: str, raw: str, text: str, *_: Any, **__: Any) -> tuple[list[nodes.Node], list[nodes.system_message]]:
    return [nodes.inline(raw, text)], []


@contextmanager
def _lenient() -> Iterator[None]:
    """Within it docutils knows every directive and role."""
    directive, role = directives.directive, roles.role

    def any_directive(name: str, *where: Any) -> Any:
        known, messages = (Math, []) if name == "math" else directive(name, *where)
        return known or Unknown, [] if known is None else messages

    def any_role(name: str, *where: Any) -> Any:
        known, messages = role(name, *where)
        return known or _text, [] if known is None else messages

    directives.directive, roles.role = any_directive, any_role
    try:
        yield
    finally:
        directives.directive, roles.role = directive, role


def restructured(text: str, scanner: Scanner) -> None:
    """The formulas of reStructuredText."""
    with _lenient():
        tree = publish_doctree(text, settings_overrides=QUIET)
    lines, at = text.split("\n"), 1
    for node in tree.findall():
        at = getattr(node, "line", None) or at
        if isinstance(node, nodes.TextElement) and not isinstance(node, nodes.Inline):
            scanner.end()
        if isinstance(node, nodes.title):
            scanner.heading("section")
        elif isinstance(node, nodes.math_block):
            for part in _PARTS.split(node.astext()):
                first = part.strip().split("\n")[0].strip()
                line = next((k + 1 for k in range(at - 1, len(lines)) if first in lines[k]), at)
                scanner.put(part, line, str(node.get("label", "")))
        elif isinstance(node, nodes.math):
            first = node.astext().split("\n")[0]
            line = next((k + 1 for k in range(at - 1, len(lines)) if first in lines[k]), at)
            scanner.put(node.astext(), line, display=False)
        elif isinstance(node, nodes.Text) and not isinstance(node.parent, nodes.math | nodes.math_block):
            scanner.words(node.astext())
    scanner.end()
