r"""Letters that are complex: said to be, equal to something with the imaginary unit, or beside their conjugates.

Such a letter has a real and an imaginary part; `\bar{z}`, `\overline{z}`, `z^*` and `z^\dagger` are its conjugate.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

from symcheck.reading import tex
from symcheck.reading.lexer import SPACES
from symcheck.reading.notation import SAID
from symcheck.reading.occurrences import first, occurrences

# a conjugate: "\bar{z}", or by its tokens "z ^ *"
_CONJUGATE = re.compile(r"\\(?:bar|overline)\{(.+)\}|(.+?) \^ (?:\{ )?(?:\*|\\ast|\\star|\\dagger)(?: \})?")
# parts of complex numbers
_PARTS = re.compile(
    r"\\(?:Re|Im|arg|Arg)(?![A-Za-z])|\\(?:operatorname|mathrm|text)\s*\{\s*(?:R\s*e|I\s*m|a\s*r\s*g)\s*\}"
)
_LENGTH = re.compile(r"\||\\[lr]?vert(?![A-Za-z])")  # bars of an absolute value
# the part of one letter
_ALONE = re.compile(r"\s*[({]?\s*(\\?[A-Za-z]+(?:\s*_\s*(?:\w+|\{[\w\s]+\}))?)\s*[)}]?\s*(?=$|[-+=<>,.]|\\[lg])")
_ORDER = re.compile(r"<|>|\\(?:leq?|geq?|leqslant|geqslant|lt|gt)(?![A-Za-z])")  # what compares real numbers only
OPEN, CLOSE = frozenset("([{"), frozenset(")]}")


@dataclass(frozen=True, slots=True)
class Complexes:
    """Which letters are complex.

    Parameters
    ----------
    certain
        Those that are, with the reason.
    possible
        Those that may be: their conjugates are printed, or another letter with a bar.
    conjugates
        What is the conjugate of which letter, if that is complex.
    """

    certain: Mapping[str, str]
    possible: Collection[str]
    conjugates: Mapping[str, str]


def complexes(
    formulas: Sequence[str], letters: Collection[str], said: Collection[str], units: Collection[str]
) -> Complexes:
    """The complex letters among some.

    Parameters
    ----------
    formulas
        Printed LaTeX.
    letters
        The numbers that may be complex, by their spellings.
    said
        Those that are said to be.
    units
        The spellings of the imaginary unit.
    """
    conjugates = {
        key: own for key in letters for m in [_CONJUGATE.fullmatch(key)] if m and (own := m[1] or m[2]) in letters
    }
    plain = [_without_real(formula) for formula in formulas if _ORDER.search(formula)]
    ordered = {place.word for formula in plain for place in occurrences(formula)}
    free = {x for x in letters if x not in ordered and x not in conjugates}
    certain = dict.fromkeys(said, SAID)
    parts = [m[1] for f in formulas for part in _PARTS.finditer(f) if (m := _ALONE.match(f, part.end()))]
    certain |= {x: "its real or imaginary part is printed" for x in map(_letter, parts) if x in free}
    parted = any(map(_PARTS.search, formulas))
    if parted or units:
        shown = "its conjugate stands beside it" if parted else "its conjugate and the imaginary unit stand beside it"
        certain |= {x: shown for x in conjugates.values() if x in free and x not in certain}
    if any(map(_LENGTH.search, formulas)):
        certain |= {x: "its conjugate and a length stand beside it" for x in conjugates.values() if x in free}
    found = bool(units or certain)
    while found:
        found = False
        for x, other in equated(formulas):
            if x not in free or x in certain:
                continue
            if {place.word for place in occurrences(_without_real(other))} & {*units, *certain}:
                certain[x] = "it is equal to something complex"
                found = True
    possible = [*dict.fromkeys(x for x in conjugates.values() if x in free and x not in certain)]
    return Complexes(certain, possible, conjugates)


def _without_real(formula: str) -> str:
    """The formula without parts and absolute values, which are real though complex letters stand in them."""
    kept, depth, until = list[str](), 0, 0
    inside = ""  # the sign with which it ends: a bracket, or a bar
    for tok in tex.tokenize(formula):
        if inside:
            depth += (tok.text in OPEN) - (tok.text in CLOSE)
            if tok.at >= until and depth == 0 and (inside == "atom" or _LENGTH.fullmatch(tok.text)):
                inside = "" if tok.text not in (r"\left", r"\,") else inside
        elif part := _PARTS.match(formula, tok.at):
            inside, until = "atom", part.end()
        elif _LENGTH.fullmatch(tok.text):
            inside = "bars"
        else:
            kept.append(tok.text)
    return " ".join(kept)


def equated(formulas: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Letters with what they are equal to."""
    for formula in formulas:
        yield from _equated(formula)


@lru_cache(maxsize=512)  # each reading of a formula asks for them
def _equated(formula: str) -> tuple[tuple[str, str], ...]:
    sides = (both for members in _relations(formula) for both in itertools.pairwise(members))
    pairs = [(x.strip("& "), y.strip("& ")) for a, b in sides for x, y in ((a, b), (b, a))]
    return tuple((letter, other) for x, other in pairs if (letter := _letter(x)) and _plain(letter) == _plain(x))


# what stands in no letter: most sides of equations need not be looked at closely
_MORE = re.compile(r"[(\[&]|\\(?:d?frac|begin|sum|int|left|sqrt|cdot|times)(?![A-Za-z])")


def _letter(latex: str) -> str:
    """The spelling of the first letter, unless there is more than one for certain."""
    place = None if _MORE.search(latex) else first(latex)
    if place is None:
        return ""
    return place.word + (tex.subscript(place.subscript) if place.subscript else "")


def _plain(latex: str) -> list[str]:
    return [text for text in tex.texts(latex) if text not in _LAYOUT]


_LAYOUT = SPACES | {"{", "}"}


PARTING = frozenset({r"\\", ",", ";", r"\quad", r"\qquad", r"\text"})  # relations
# what aligns them
_ALIGNED = re.compile(r"\\(?:begin|end)\s*\{\s*(?:a\s*l\s*i\s*g\s*n|s\s*p\s*l\s*i\s*t|g\s*a\s*t\s*h\s*e\s*r)[^}]*\}")


def _relations(formula: str) -> Iterator[list[str]]:
    """For each relation what stands between its equality signs, outside of all brackets and matrices."""
    depth, start, found = 0, 0, list[str]()
    formula = _ALIGNED.sub(" ", formula) if r"\begin" in formula else formula
    for tok in tex.tokenize(formula) if "=" in formula else ():
        depth += (tok.text in OPEN or tok.text == r"\begin") - (tok.text in CLOSE or tok.text == r"\end")
        parts = tok.text in PARTING
        if depth == 0 and (parts or tok.text == "="):
            found.append(formula[start : tok.at])
            start = formula.find("}", tok.at) + 1 if tok.text == r"\text" else tok.at + len(tok.text)
            if parts:
                yield found
                found = []
    yield [*found, formula[start:]]
