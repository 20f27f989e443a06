"""Printed text as standalone LaTeX, and whether it is LaTeX at all: not words, nor characters of a damaged source."""

from __future__ import annotations

import re
from collections.abc import Callable

_ENVIRONMENT = re.compile(r"\\begin\{(\w+)\}.*?\\end\{\1\}", re.DOTALL)  # within which rows may break
_ROWS = re.compile(r"(?<!\\)&|\\\\")  # an alignment mark or the end of a row
_WORDS = re.compile(r"[A-Za-z]{3,} [a-z]{2,}")  # two words on end: a sentence rather than a formula
_TEXT = re.compile(r"\\text\{[^{}]*\}")  # words within a formula
_CUT_OFF = re.compile(r"(?<!\\)\\\s*$")  # a single backslash at the end: a command lost its name
_WITHIN = re.compile(r"\$([^$]+)\$")  # a formula within a sentence
_BRACES = re.compile(r"(?<!\\)[{}]")  # braces of groups, not those that are printed


def standing_alone(text: str) -> str:
    r"""A formula without `$` and tabs, a row cut out of an array within one, and `h_\max` with braces.

    >>> standing_alone("$V_1$\t1.951")
    'V_1 \\quad 1.951'
    """
    text = re.sub(r"[_^]\\(max|min)\b", lambda m: rf"{m[0][0]}{{\{m[1]}}}", text.replace("$", ""))
    text = text.replace("\t", r" \quad ")
    outside = _ENVIRONMENT.sub("", text)
    if outside == text:
        text = text.replace("\n", r" \quad ")
    return rf"\begin{{aligned}}{text}\end{{aligned}}" if _ROWS.search(outside) else text


def is_formula(text: str) -> bool:
    r"""Whether a text is LaTeX of a formula: no words, no letters but LaTeX's own outside `\text`, braces that match.

    >>> is_formula(r"J_1 = J_2"), is_formula("The list with that put right."), is_formula("(р = IT}")
    (True, False, False)
    """
    words = "\\" not in text and _WORDS.search(text)
    whole = bool(text) and not _CUT_OFF.search(text)
    return whole and not words and _TEXT.sub("", text).isascii() and _matched(text)


def _matched(text: str) -> bool:
    depth = 0
    for brace in _BRACES.findall(text):
        depth += 1 if brace == "{" else -1
        if depth < 0:
            return False
    return depth == 0


def split_at_formulas(sentence: str) -> list[str]:
    """The words and, at odd places, the formulas of a sentence that has them between dollar signs.

    >>> split_at_formulas("for $k = 1$ only")
    ['for ', 'k = 1', ' only']
    """
    return _WITHIN.split(sentence)


def only_formula(sentence: str) -> str:
    """The formula of a sentence that is nothing but one formula between dollar signs, else the empty text.

    >>> only_formula("$k = 1$"), only_formula("for $k = 1$ only")
    ('k = 1', '')
    """
    before, *rest = split_at_formulas(sentence)
    return rest[0] if len(rest) == 2 and before == rest[1] == "" else ""


def sentence(text: str, words: Callable[[str], str]) -> str:
    """A sentence on one line, its formulas between dollars as they are, its words as another markup writes them."""
    pieces = enumerate(split_at_formulas(" ".join(text.split())))
    return "".join(f"${each}$" if n % 2 else words(each) for n, each in pieces)


def formulas_of(sentence: str) -> list[str]:
    """The formulas of a sentence that has them between dollar signs."""
    return split_at_formulas(sentence)[1::2]
