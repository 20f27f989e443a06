"""The faces of letters: bold type, arrows and accents."""

from __future__ import annotations

import re
from functools import lru_cache

# a style, or an accent over it; a line below it is one
STYLED = re.compile(r"(?:\\\w+\{)?\\(mathbf|boldsymbol|bm|pmb|vec|overrightarrow|underline)\{")
TENSOR = re.compile(r"\\underline\{\\underline\{")  # two lines below a letter
# what a vector begins with, behind a factor
FACES = frozenset(
    {
        r"\mathbf",
        r"\boldsymbol",
        r"\bm",
        r"\pmb",
        r"\vec",
        r"\underline",
        r"\hat",
        r"\bar",
        r"\dot",
        r"\ddot",
        r"\prescript",
    }
)
HAT = re.compile(r"\\(hat|widehat|vec)\{")  # accents of unit vectors and of vectors
ACCENT = re.compile(r"\\(hat|widehat|vec|bar|overline|tilde|breve)\{")  # accents that make a letter of their own


@lru_cache(maxsize=4096)  # the same letters are met in every formula
def face(latex: str) -> str:
    """What is printed in bold type or below an arrow, where a letter, or a name of several tokens, is; else nothing."""
    printed = re.sub(r"^\\(?:Delta|delta)(?=\\)", "", latex.replace(" ", ""))
    found = None if printed.startswith(r"\prescript") else STYLED.match(printed)
    return printed[found.end() :] if found else ""


def is_styled(latex: str, *, capital: bool) -> bool:
    """Is a letter bold or with an arrow, and capital or not?"""
    inner = face(latex).lstrip("\\")
    return bool(inner) and inner[:1].isupper() == capital


def is_accented(latex: str) -> bool:
    """Does an accent make the letter one of its own?"""
    return ACCENT.match(latex.replace(" ", "")) is not None
