r"""Relations with Kronecker's delta of letters that stand elsewhere, too, for equal letters and for different ones."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace

from symcheck.question.prepare import Asked, sides
from symcheck.reading import tex

# Kronecker's delta of two indices
_DELTA = re.compile(r"\\delta_\{([i-np-s]),?([i-np-s])\}(?!\d)")
# what a definition says of a letter with an index
_HEAD = re.compile(r"(\\?[A-Za-z]+)_\{?([i-np-s])\}?(?![A-Za-z])")
# an index of an entry, over which there may be a sum, and of no function
_ENTRY = re.compile(r"_\{[i-np-s]+\}(?!\()|_[i-np-s](?!\()")


@dataclass(frozen=True)
class Cases:
    """The relation for equal and for different letters."""

    letters: tuple[str, str]
    equal: Asked
    different: Asked


def in_cases(asked: Asked) -> Cases | None:
    """The cases of a relation with one such symbol, in the notation without spaces; None if there is none."""
    found = {match[0]: match for match in _DELTA.finditer(asked.relation)}
    if len(found) != 1 or any(_DELTA.search(text) for text in (*asked.where, *asked.given)):
        return None
    (match,) = found.values()
    m, n = match.groups()
    rest = _DELTA.sub("1", asked.relation)
    told = _ENTRY.sub("", rest)
    if m == n or not (_has(rest, m) and _has(rest, n)) or not (_has(told, m) or _has(told, n)):
        return None
    asked = with_instances(asked)
    given = dict.fromkeys(_renamed(text, n, m) for text in asked.given if not _has(text, m) or not _has(text, n))
    equal = replace(asked, relation=_renamed(_with_number(asked.relation, "1"), n, m), given=tuple(given))
    different = replace(asked, relation=_with_number(asked.relation, "0"), given=(*asked.given, rf"{m} \ne {n}"))
    return Cases((m, n), equal, different)


def _with_number(relation: str, number: str) -> str:
    """The relation with a number for the symbol."""
    return re.sub(r"(^|[-+=(])?" + _DELTA.pattern, lambda m: (r"\cdot " if m[1] is None else m[1]) + number, relation)


def with_instances(asked: Asked) -> Asked:
    """The question with what is said of a letter with an index, as psi_n, said of it with others, as psi_m."""
    return replace(asked, where=(*asked.where, *_instances(asked)))


def _instances(asked: Asked) -> Iterator[str]:
    used = {match.groups() for text in (asked.relation, *asked.given) for match in _HEAD.finditer(text)}
    said = {match.groups(): text for text in asked.where if sides(text) and (match := _HEAD.match(text))}
    for letter, index in sorted(used - said.keys()):
        own = [(k, text) for (x, k), text in said.items() if x == letter]
        if len(own) == 1 and not _has(own[0][1], index):
            yield _renamed(own[0][1], own[0][0], index)


def _has(text: str, letter: str) -> bool:
    return letter in tex.spaced(text).split(" ")


def _renamed(text: str, old: str, new: str) -> str:
    return tex.compact(" ".join(new if token == old else token for token in tex.spaced(text).split(" ")))
