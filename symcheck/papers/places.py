"""Where in the source a sentence stands that a declaration puts in our words: line, first and last word, digest.

The sentence itself is not kept here: it is found again in the source text, and the digest says that it is the same.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib import import_module

DIGITS = 12  # of the digest: enough to tell the sentences of a paper apart
LONGEST = 20_000  # characters from the first to the last word: no list of a paper is longer


@dataclass(frozen=True)
class Place:
    """A sentence, or a list, in a source text.

    Parameters
    ----------
    line
        1-based line on which its first word stands.
    first, last
        Its first and last word, as printed, with the punctuation that belongs to them.
    digest
        Of all of it, with single spaces between its words.
    """

    line: int
    first: str
    last: str
    digest: str

    def __str__(self) -> str:
        return self.first if self.first == self.last else f"{self.first} … {self.last}"

    def sentence(self, source: str) -> str | None:
        """The whole sentence in the source text, or None if it does not stand there."""
        lines = source.split("\n")
        text = "\n".join(lines[self.line - 1 :])
        for start in re.finditer(re.escape(self.first), lines[self.line - 1]):
            for end in re.finditer(re.escape(self.last), text[start.start() : start.start() + LONGEST]):
                words = " ".join(text[start.start() : start.start() + end.end()].split())
                if digest(words) == self.digest:
                    return words
        return None


def digest(words: str) -> str:
    """The digest of a sentence with single spaces between its words."""
    return hashlib.sha256(words.encode()).hexdigest()[:DIGITS]


@cache
def places(key: str) -> Mapping[str, Place]:
    """The places of a paper by number; none for a paper without such a table."""
    name = f"symcheck.papers.{key}.places"
    try:
        found: Mapping[str, Place] = import_module(name).PLACES
    except ModuleNotFoundError as error:
        if error.name is None or not name.startswith(error.name):
            raise
        return {}
    return found
