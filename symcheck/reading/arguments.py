"""What stands in brackets behind a letter: arguments of a function, or factors."""

from __future__ import annotations

import re
from collections.abc import Sequence

from symcheck.reading.faces import STYLED
from symcheck.reading.lexer import CLOSE, OPEN
from symcheck.reading.names import is_letter
from symcheck.reading.occurrences import Occurrence

_ARGUMENTS = frozenset({"t", r"\tau", "s", "n", "k", "x", "z"})  # what functions of one letter are mostly applied to
_DOTS = frozenset({r"\dots", r"\cdots", r"\ldots"})
_SIGNED = re.compile(r"(?:[-+]|\\pm|\\mp) (?:\d |\. )*\d")  # `-1` and `\pm 1`
_NUMBER = re.compile(r"\s*[-+]?\s*[\d.\s]+")  # a decimal number, with spaces between its tokens


def is_sum(args: Sequence[str]) -> bool:
    """Is this one sum, or a cross, that does not begin with a usual argument: hardly what a function is applied to?"""
    toks = args[0].split() if len(args) == 1 else []
    return bool({"+", "-", r"\times"} & {*toks[1:]}) and toks[0] not in _ARGUMENTS


_TIME_BELOW = re.compile(r"^(t|\\tau) _ (?:\w|\{ \w [-+] \d \}|\{ \w \})")  # one of several times
# signs around which brackets are needed where a factor stands before them
_SIGNS = frozenset({"+", "-", "/", "*", r"\pm", r"\mp", r"\times", r"\cdot", r"\sum", r"\int", r"\frac"})


def is_shift_of_time(args: Sequence[str]) -> bool:
    """Is this the time with something added to it: an argument of a function, or how long something moves?"""
    args = [_TIME_BELOW.sub(r"\1", args[0], count=1)]
    return args[0].split()[:1] in (["t"], [r"\tau"]) and is_shift(args)


def is_shift(args: Sequence[str]) -> bool:
    """Is this a usual argument alone, or with something added to it?"""
    toks = args[0].split()
    return toks[:1] != [] and toks[0] in _ARGUMENTS and toks[1:2] in ([], ["+"], ["-"])


def is_lone(place: Occurrence) -> bool:
    """Does one letter or number stand in brackets behind it, around which nobody writes them for a product?"""
    if place.powered or place.arguments is None or len(place.arguments) != 1:
        return False
    (inside,) = place.arguments
    number = all(tok.isdigit() or tok in (".", "{", "}", r"\frac") for tok in inside.split())
    return bool(inside) and (is_letter(inside) or number)


def is_listed(args: Sequence[str]) -> bool:
    """Are these several arguments, and no components of a vector or factors of a scalar product?"""
    letters = [bool(arg) and is_letter(arg.removesuffix(" ( t )")) for arg in args]
    others = (arg in _DOTS or _NUMBER.fullmatch(arg) for arg in args)
    plain = all(letter or other for letter, other in zip(letters, others, strict=True))
    return len(args) > 1 and plain and any(letters) and not all(STYLED.match(arg.replace(" ", "")) for arg in args)


def is_product(args: Sequence[str]) -> bool:
    """Is this one product of several letters and numbers, around which brackets would be idle?"""
    return len(args) == 1 and is_idle(args[0]) and not is_letter(args[0]) and not _NUMBER.fullmatch(args[0])


def is_doubled(blank: Sequence[bool]) -> bool:
    """Is every second column of a matrix blank, as `&&` between all columns makes it?"""
    return len(blank) > 2 and all(blank[1::2]) and not any(blank[::2])


def is_signed(text: str) -> bool:
    """Is this one number with a sign, which a product has before it?"""
    return _SIGNED.fullmatch(text) is not None


def is_idle(text: str) -> bool:
    """Do no signs stand in it but within other brackets, so that none are needed around it?"""
    depth, bars = 0, False
    for tok in text.split():
        depth += (tok in OPEN or tok == "{") - (tok in CLOSE or tok == "}")
        bars ^= depth == 0 and tok in ("|", r"\|")  # and not below a letter, as in v_{||}
        if depth == 0 and not bars and tok in _SIGNS:
            return False
    return bool(text)
