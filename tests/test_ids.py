"""Ids are taken apart in one place, and every declared one comes back as it was."""

from __future__ import annotations

from types import ModuleType

import pytest

from symcheck import papers
from symcheck.core.claims import Paper, Section
from symcheck.core.ids import Id
from symcheck.core.verdicts import SymcheckError
from symcheck.papers.declare import premise

PARTS = {
    "mirer2009": Id("mirer2009"),
    "mirer2009:2.13.1": Id("mirer2009", "2.13.1"),
    "mirer2009:2.13.1b": Id("mirer2009", "2.13.1", "b"),
    "ignatov2005:2.1V": Id("ignatov2005", "2.1V"),
    "ignatov2005:2.1V.9a": Id("ignatov2005", "2.1V.9", "a"),
}


@pytest.mark.parametrize(("text", "parts"), PARTS.items())
def test_an_id_has_a_paper_a_number_and_a_link(text: str, parts: Id) -> None:
    assert Id.parse(text) == parts
    assert str(parts) == text
    assert parts.declaration == parts._replace(link="")


def test_a_relation_has_its_links() -> None:
    whole, link = Id.parse("mirer2009:2.13.1"), Id.parse("mirer2009:2.13.1b")
    assert whole.has("mirer2009:2.13.1")
    assert whole.has("mirer2009:2.13.1b")
    assert link.has("mirer2009:2.13.1b")
    assert not link.has("mirer2009:2.13.1a")


def test_a_row_belongs_to_a_list() -> None:
    assert Id.parse("ignatov2005:2.1V.9a").listing == Id("ignatov2005", "2.1V")
    assert Id.parse("ignatov2005:2.1V.9a").row == "9"


@pytest.mark.parametrize("key", papers.load())
def test_every_declared_number_is_an_id_without_a_link(key: str) -> None:
    for _, _, item in papers.load()[key].items():
        id = Id(key, item.number)
        assert Id.parse(str(id)) == id
        assert Id.parse(f"{id}b") == id._replace(link="b")


def test_a_number_that_looks_like_a_link_is_refused() -> None:
    module = ModuleType("section")
    module.first = premise("1.1a", 3, words="A premise.")  # type: ignore[attr-defined]
    paper = Paper("toy", "A toy", "toy.txt", papers.load()["mirer2009"].notation, (Section("1", "One", module),))
    with pytest.raises(SymcheckError, match=r"toy:1\.1a ends in a small letter.*another number"):
        list(paper.items())
