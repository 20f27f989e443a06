r"""Where the argument of a function without brackets ends, by other formulas: `\cosh m(L - x)` beside `\tanh m L`."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence, Set
from dataclasses import replace
from typing import NamedTuple

from symcheck.document.macros import tokens
from symcheck.document.rewriting import CLOSING, closed
from symcheck.document.survey import Link, Seen
from symcheck.question.prepare import VARIABLES
from symcheck.reading.parser import ANGLES, OFTEN_ANGLES

OPEN_ARGUMENT = "belong to the argument of"  # in the reason why something is not read
# a function of angles or of real numbers
_FUNCTION = re.compile(r"\\(?:(?:arc)?(?:sin|cos|tan)|(?:cot|sec|csc)|(?:sin|cos|tan|cot)h)")
# one letter
_LETTER = re.compile(
    r"[A-Za-z]|\\(?:ell|alpha|beta|gamma|delta|(?:var)?(?:epsilon|theta|rho|sigma|phi)|zeta|eta|kappa|lambda|mu|nu|xi|"
    r"tau|chi|psi|omega|Omega|Theta|Phi|Psi)"
)
# behind a letter that is all of an argument
_ENDING = frozenset(
    {"", "+", "-", "=", "&", r"\\", "}", ")", "]", r"\right", ",", ".", ";", "|", r"\,", r"\pm", r"\mp", r"\cdot"}
)


class _Place(NamedTuple):
    """A function, the letter behind it, and where the bracket behind that opens and ends; 0 if there is none."""

    before: Sequence[str]  # the function with its power
    letter: str
    alone: bool  # whether the letter is all of the argument
    factor: bool  # whether it is a factor of something else there
    opened: Sequence[str] = ()  # as it is printed
    bracket: Sequence[str] = ()  # all of it


def argument_rules(every: Iterable[str], unread: Iterable[str]) -> list[str]:
    r"""Rules of rewriting with brackets around arguments in formulas that are not read for want of these.

    A letter that is elsewhere all of an argument is so here, and what follows is a factor; one that is nowhere all of
    an argument, but a factor in some, is a factor here.
    """
    alone, factor = _kinds(every)
    found = dict[str, None]()
    for place in (place for latex in unread for place in _places(latex) if place.bracket):
        if (place.letter in alone) == (place.letter in factor):
            continue
        whole = place.opened if place.letter in alone else place.bracket
        inside = (place.letter, ")", *whole) if place.letter in alone else (place.letter, *whole, ")")
        found[" ".join((*place.before, place.letter, *whole, "->", *place.before, "(", *inside))] = None
    return [*found]


def in_brackets(every: Iterable[str], seen: Sequence[Seen]) -> list[Seen]:
    r"""The same with brackets around arguments of several letters, as of `\cosh m L`, that begin with such a factor.

    They are read so without brackets, but where more is at stake than a reading these are asked for.
    """
    alone, factor = _kinds(every)

    def named(link: Link) -> Link:
        left, right = (_bracketed(side, factor - alone) for side in (link.left, link.right))
        return replace(link, left=left, right=right)

    return [replace(each, links=tuple(map(named, each.links))) if factor else each for each in seen]


def _bracketed(latex: str, factors: Set[str]) -> str:
    if not _FUNCTION.search(latex):
        return latex
    toks, new, k = [tok.text for tok in tokens(latex) if not tok.is_space], list[str](), 0
    while k < len(toks):
        new.append(toks[k])
        k += 1
        if not _FUNCTION.fullmatch(new[-1]):
            continue
        begin = _scripted(toks, k, "^")
        end, ends = begin, list[int]()
        while end < len(toks) and _LETTER.fullmatch(toks[end]):
            ends.append(end := _scripted(toks, end + 1, "_"))
        behind = toks[end] if end < len(toks) else ""
        last = toks[ends[-2]] if len(ends) > 1 else ""
        if last and last not in VARIABLES and "".join(toks[begin : ends[0]]) in factors and behind in _ENDING:
            new += [*toks[k:begin], "(", *toks[begin:end], ")"]
            k = end
    return " ".join(new) if len(new) > len(toks) else latex


def _kinds(every: Iterable[str]) -> tuple[set[str], set[str]]:
    """The letters that are all of an argument somewhere, and those that are factors in one."""
    places = [place for latex in every for place in _places(latex)]
    return {place.letter for place in places if place.alone}, {place.letter for place in places if place.factor}


def _places(latex: str) -> Iterator[_Place]:
    toks = [tok.text for tok in tokens(latex) if not tok.is_space]
    for k, text in enumerate(toks):
        if not _FUNCTION.fullmatch(text):
            continue
        begin = _scripted(toks, k + 1, "^")
        bracketed = begin < len(toks) and toks[begin] == "("
        start = begin + bracketed
        if start == len(toks) or not _LETTER.fullmatch(toks[start]):
            continue
        end = _scripted(toks, start + 1, "_")
        letter, behind = "".join(toks[start:end]), toks[end] if end < len(toks) else ""
        sized = end + (behind == r"\left")
        if not bracketed and sized < len(toks) and toks[sized] in CLOSING:
            if (close := closed(toks, sized)) > sized:
                yield _Place(toks[k:begin], letter, False, False, toks[end : sized + 1], toks[end:close])
        else:
            ends = behind in _ENDING or (not bracketed and _FUNCTION.fullmatch(behind) is not None)
            angle = letter.partition("_")[0] in ANGLES | OFTEN_ANGLES
            factor = _LETTER.fullmatch(behind) is not None and (bracketed or not angle)
            yield _Place(toks[k:begin], letter, (behind == ")" if bracketed else ends), factor)


def _scripted(toks: Sequence[str], k: int, sign: str) -> int:
    """The place behind a script that may begin here."""
    if k + 1 >= len(toks) or toks[k] != sign:
        return k
    if toks[k + 1] != "{":
        return k + 2
    end = closed(toks, k + 1)
    return end if end > k + 1 else len(toks)
