"""All formulas of the page, each typeset once; where one is to be seen stands its number in the part it belongs to."""

from __future__ import annotations

from collections.abc import Iterable
from copy import copy

from markupsafe import Markup, escape

from symcheck.views.latex import split_at_formulas
from symcheck.views.page.difference import marked
from symcheck.views.page.typeset import typeset


class Formulas:
    """Formulas by number. `texts` are typeset at once, in parallel; a pair with its differences marked when asked for.

    Text without mathematics is shown as it is: words as words, the characters of a damaged source as code.
    """

    def __init__(self, texts: Iterable[str]) -> None:
        self._math = typeset(texts)
        self._numbers: dict[str, int] = {}

    def apart(self) -> Formulas:
        """The same formulas with numbers of their own, for a part of the page that is unfolded by itself."""
        other = copy(self)
        other._numbers = {}
        return other

    @property
    def numbered(self) -> list[str]:
        """The MathML by number."""
        return list(self._numbers)

    def number(self, text: str) -> int:
        """The number of a formula, or -1 for other text."""
        math = self._math.get(text)
        return -1 if math is None else self._number(math)

    def markup(self, text: str, fallback: bool = False) -> Markup:
        """Where a formula is to be seen; `fallback`: with its LaTeX, for a page without its program."""
        math = self._math.get(text)
        return self._plain(text) if math is None else self._place(math, text if fallback else "")

    def sentence(self, text: str) -> Markup:
        """Words with formulas between dollar signs; each with its LaTeX, for a page without its program."""
        pieces = enumerate(split_at_formulas(text))
        return Markup("").join(self.markup(piece, fallback=True) if n % 2 else escape(piece) for n, piece in pieces)

    def pair(self, before: str, after: str, fallback: bool = False) -> tuple[Markup, Markup]:
        """Both formulas with their differences marked."""
        one, other = self._math.get(before), self._math.get(after)
        if one is None or other is None:
            return self.markup(before, fallback), self.markup(after, fallback)
        one, other = marked(one, other)
        return self._place(one, before if fallback else ""), self._place(other, after if fallback else "")

    def _number(self, math: str) -> int:
        return self._numbers.setdefault(math, len(self._numbers))

    def _place(self, math: str, text: str) -> Markup:
        return Markup('<span class="m" data-m="{}">{}</span>').format(self._number(math), text)

    def _plain(self, text: str) -> Markup:
        damaged = not text.isascii() or any(mark in text for mark in "\\{^_")
        return Markup('<code class="damaged">{}</code>').format(text) if damaged else Markup(escape(text))
