"""The ids of relations. They are put together and taken apart here only."""

from __future__ import annotations

import re
from pathlib import Path
from string import ascii_lowercase
from typing import NamedTuple

from symcheck.core.verdicts import SymcheckError


def key_of(folder: Path) -> str:
    """The first part of the ids of a paper in a folder: the folder's name in small letters and digits."""
    key = re.sub(r"\W+", "_", folder.resolve().name.lower(), flags=re.ASCII).strip("_")
    if not key:
        raise SymcheckError(f"{folder}: the name of the folder becomes the key of the paper; use letters and digits")
    return key


class Id(NamedTuple):
    """A relation of a paper, written "mirer2009:2.13.1b": the number of its declaration, and the letter of its link.

    A declaration as a whole, and what stands alone, has no letter; a paper as a whole has no number either.
    """

    paper: str
    number: str = ""
    link: str = ""

    @classmethod
    def parse(cls, text: str) -> Id:
        """The inverse of `str`."""
        paper, _, place = text.partition(":")
        return cls.of(paper, place)

    @classmethod
    def of(cls, paper: str, place: str) -> Id:
        """A relation of a paper by its place there, "2.13.1b"; numbers do not end in small letters."""
        number = place.rstrip(ascii_lowercase)
        return cls(paper, number, place[len(number) :])

    def __str__(self) -> str:
        return f"{self.paper}:{self.place}" if self.place else self.paper

    @property
    def place(self) -> str:
        """The number with the letter of the link, "2.13.1b"."""
        return self.number + self.link

    @property
    def declaration(self) -> Id:
        """The declaration it belongs to."""
        return self._replace(link="")

    def has(self, text: str) -> bool:
        """Whether a relation, by its id, is this one or a link of it."""
        other = Id.parse(text)
        return self in (other, other.declaration)

    @property
    def listing(self) -> Id:
        """The list of a row: "ignatov2005:2.1V" of "ignatov2005:2.1V.9a"."""
        return Id(self.paper, self.number.rpartition(".")[0])

    @property
    def row(self) -> str:
        """The number of a row in its list: "9" of "ignatov2005:2.1V.9a"."""
        return self.number.rpartition(".")[2]
