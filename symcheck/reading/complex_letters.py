r"""Letters that are complex: said to be, equal to something with the imaginary unit, or beside their conjugates.

Such a letter has a real and an imaginary part; `\bar{z}`, `\overline{z}`, `z^*` and `z^\dagger` are its conjugate.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from symcheck.reading import tex
from symcheck.reading.notation import SAID
from symcheck.reading.occurrences import Occurrence, occurrences
from symcheck.reading.sides import CLOSE, OPEN, alone, equated

# a conjugate: "\bar{z}", or by its tokens "z ^ *"
_CONJUGATE = re.compile(r"\\(?:bar|overline)\{(.+)\}|(.+?) \^ (?:\{ )?(?:\*|\\ast|\\star|\\dagger)(?: \})?")
# parts of complex numbers
_PARTS = re.compile(
    r"\\(?:Re|Im|arg|Arg)(?![A-Za-z])|\\(?:operatorname|mathrm|text)\s*\{\s*(?:R\s*e|I\s*m|a\s*r\s*g)\s*\}"
)
# a line above something
_LINE = re.compile(r"\\overline\{((?:[^{}]|\{\w+\})*)\}")
# one letter with its subscript
_LETTER = re.compile(r"(?:[A-Za-z]|\\[A-Za-z]+)(?:_(?:\{\w+\}|\w))?")
_INDICES = frozenset("ijklmnpqrs")
_LENGTH = re.compile(r"\||\\[lr]?vert(?![A-Za-z])")  # bars of an absolute value
# the part of one letter
_ALONE = re.compile(r"\s*[({]?\s*(\\?[A-Za-z]+(?:\s*_\s*(?:\w+|\{[\w\s]+\}))?)\s*[)}]?\s*(?=$|[-+=<>,.]|\\[lg])")
_ORDER = re.compile(r"<|>|\\(?:leq?|geq?|leqslant|geqslant|lt|gt)(?![A-Za-z])")  # what compares real numbers only


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
    ordered = {x for formula in plain for place in occurrences(formula) for x in _letters_at(place)}
    free = {x for x in letters if x not in ordered and x not in conjugates}
    certain = dict.fromkeys(said, SAID)
    parts = [m[1] for f in formulas for part in _PARTS.finditer(f) if (m := _ALONE.match(f, part.end()))]
    certain |= {x: "its real or imaginary part is printed" for x in map(alone, parts) if x in free}
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
            beside = {each for place in occurrences(_without_real(other)) for each in _letters_at(place)}
            if beside & {*units, *certain}:
                certain[x] = "it is equal to something complex"
                found = True
    possible = [*dict.fromkeys(x for x in conjugates.values() if x in free and x not in certain)]
    return Complexes(certain, possible, conjugates)


def _letters_at(place: Occurrence) -> Collection[str]:
    """The spellings of the letters that a place speaks of: E_0 is another one than E, and E_k is not."""
    below = place.subscript or ()
    labelled = below and not any(text in _INDICES for text in below)
    return (place.word + tex.subscript(below),) if labelled else (place.word, place.word + tex.subscript(below))


def with_products_under_lines(formulas: Sequence[str], said: Collection[str]) -> list[str]:
    """Formulas with signs between letters below one line that are said to be complex: it is above their product."""

    def parted(found: re.Match[str]) -> str:
        inside = _LETTER.findall(found[1])
        is_product = len(inside) > 1 and "".join(inside) == found[1] and all(x in said for x in inside)
        return r"\overline{" + r" \cdot ".join(inside) + "}" if is_product else found[0]

    return [_LINE.sub(parted, formula) for formula in formulas]


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
