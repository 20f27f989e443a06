"""What is said of dimensions, in lines of text."""

from __future__ import annotations

import re
from collections.abc import Iterator

from symcheck.core.words import term
from symcheck.dimensions import CONSISTENT, INCONSISTENT, Dimensions

LONGEST = 60  # characters of a term
ANY = "any"
_MARKUP = re.compile(r"[\\{}]")  # of a letter in LaTeX: "h_{\\max}" is "h_max"


def fits(of: Dimensions) -> Iterator[str]:
    """The verdict with what both sides measure, then what does not fit, what is 1, what would settle it."""
    both = list(of.sides)
    if of.verdict == CONSISTENT:  # what fits anything, as zero does, is no news beside what it fits
        both = [each for each in both if each != ANY] or both
        both = both if of.scales else list(dict.fromkeys(both))
    both = ["numbers without a unit" if each == "1" else each for each in both]
    where = f" if {_plain(' and '.join(of.scales))}" if of.scales else ""
    yield f"{of.verdict}{where}: {' against '.join(both)}" if both else f"{of.verdict}{where}"
    if of.verdict == INCONSISTENT:
        yield conflict(of)
    if of.undetermined:
        yield f"to settle it, say what {', '.join(of.undetermined)} measure{'s' * (len(of.undetermined) == 1)}"
    if of.reason:
        yield of.reason
    if of.letters:
        yield "hence " + ", ".join(f"{letter} measures {unit}" for letter, unit in of.letters.items())


def restored(of: Dimensions) -> str:
    """What the general form is: the relation with the quantity put in that was set to 1; "" if there is none."""
    return f"with {_plain(of.scales[0].partition(' = ')[0])} restored" if of.general else ""


def in_general(of: Dimensions) -> Iterator[str]:
    """The general form in words."""
    if of.general:
        yield f"{restored(of)}: {'; '.join(map(term, of.general))}"


def conflict(of: Dimensions | None) -> str:
    """The terms that do not fit together, with what each measures; in short."""
    terms = of.conflict if of else ()
    return ", ".join(f"{_cut(each.term)} measures {each.measures}" for each in terms)


def unlike(of: Dimensions | None) -> str:
    """What is said of dimensions in one line, where it is something else than that they fit."""
    if of is None or of.verdict == CONSISTENT:
        return ""
    if of.verdict == INCONSISTENT:
        return f"do not fit: {conflict(of)}"
    return f"undetermined: {of.reason}" if of.reason else f"undetermined without {', '.join(of.undetermined)}"


def _plain(latex: str) -> str:
    return _MARKUP.sub("", latex)


def _cut(text: str) -> str:
    return text if len(text) <= LONGEST else text[: LONGEST - 1] + "…"
