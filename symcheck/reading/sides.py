"""What letters are equal to in formulas: the sides of equations that are one letter, each with the other side."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator, Sequence
from functools import lru_cache

from symcheck.reading import tex
from symcheck.reading.lexer import ENVIRONMENTS, SPACES
from symcheck.reading.occurrences import first

OPEN, CLOSE = frozenset("([{"), frozenset(")]}")
_DOTS = re.compile(r"\\d+ot(?![a-z])\s*(?:\{([^{}]*)\})?")  # of rates, before a letter or around it


def equated(formulas: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Letters with what they are equal to."""
    for formula in formulas:
        yield from _equated(formula)


def without_dots(formula: str) -> str:
    """The formula with letters in the place of their rates, as the rate of a vector, or of a matrix, is one."""
    return _DOTS.sub(r"\1", formula)


@lru_cache(maxsize=512)  # each reading of a formula asks for them
def _equated(formula: str) -> tuple[tuple[str, str], ...]:
    sides = (both for members in _relations(formula) for both in itertools.pairwise(members))
    pairs = [(x.strip("& "), y.strip("& ")) for a, b in sides for x, y in ((a, b), (b, a))]
    return tuple((letter, other) for x, other in pairs if (letter := alone(x)) and _plain(letter) == _plain(x))


# what stands in no letter: most sides of equations need not be looked at closely
_MORE = re.compile(r"[(\[&]|\\(?:d?frac|begin|sum|int|left|sqrt|cdot|times)(?![A-Za-z])")


def alone(latex: str) -> str:
    """The spelling of the first letter, unless there is more than one for certain."""
    place = None if _MORE.search(latex) else first(latex)
    if place is None:
        return ""
    return place.word + (tex.subscript(place.subscript) if place.subscript else "")


def _plain(latex: str) -> list[str]:
    return [text for text in tex.texts(latex) if text not in _LAYOUT]


_LAYOUT = SPACES | {"{", "}"}


_PARTING = frozenset({r"\\", ",", ";", r"\quad", r"\qquad", r"\text"})  # relations
# what aligns them, by its tokens or as it is printed
_ALIGNED = re.compile(
    r"\\(?:begin|end)\s*\{\s*(?:"
    + "|".join(r"\s*".join(map(re.escape, name)) for name in sorted(ENVIRONMENTS - {"array", "cases"}))
    + r")\s*\}"
)


def _relations(formula: str) -> Iterator[list[str]]:
    """For each relation what stands between its equality signs, outside of all brackets and matrices."""
    depth, start, found = 0, 0, list[str]()
    formula = _ALIGNED.sub(" ", formula) if r"\begin" in formula else formula
    for tok in tex.tokenize(formula) if "=" in formula else ():
        depth += (tok.text in OPEN or tok.text == r"\begin") - (tok.text in CLOSE or tok.text == r"\end")
        parts = tok.text in _PARTING
        if depth == 0 and (parts or tok.text == "="):
            found.append(formula[start : tok.at])
            start = (tok.text == r"\text" and formula.find("}", tok.at) + 1) or tok.at + len(tok.text)
            if parts:
                yield found
                found = []
    yield [*found, formula[start:]]
