"""What a declaration puts in our words has its sentence in the source, by line, first and last word, and digest."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from symcheck import papers
from symcheck.audit.decide import decide
from symcheck.core.claims import Ours, Paper
from symcheck.core.ids import Id
from symcheck.papers.places import Place, digest, places

PAPERS = list(papers.load().values())
STANDING = "S"  # the section of conditions that are not printed
TEXT = "One line.\nThe first word, and then\nthe last word. The last word."
SENTENCE = Place(2, "The", "word.", digest("The first word, and then the last word."))


@pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.key)
def test_what_has_no_verbatim_piece_has_a_place(paper: Paper) -> None:
    in_words = [
        item.number
        for section, _, item in paper.items()
        if not item.source.printed and not isinstance(item, Ours) and section.number != STANDING
    ]
    assert in_words
    assert [number for number in in_words if number not in places(paper.key)] == []


@pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.key)
def test_every_place_is_in_the_source_with_its_digest(paper: Paper, sources: Path) -> None:
    text = (sources / paper.source).read_text(encoding="utf-8")
    assert [number for number, place in places(paper.key).items() if place.sentence(text) is None] == []


@pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.key)
def test_a_place_is_near_the_line_of_its_declaration(paper: Paper) -> None:
    lines = {item.number: item.source.line for _, _, item in paper.items()}
    near = {number: lines[number] - place.line for number, place in places(paper.key).items() if number in lines}
    assert near
    # a sentence may stand above its formula, with an empty line between, and the title of a table above its values
    assert {number: off for number, off in near.items() if off not in (0, 1, 2)} == {}


def test_a_sentence_may_run_over_lines() -> None:
    assert SENTENCE.sentence(TEXT) == "The first word, and then the last word."
    assert str(SENTENCE) == "The … word."


@pytest.mark.parametrize(
    "other",
    [replace(SENTENCE, line=1), replace(SENTENCE, first="One"), replace(SENTENCE, digest=digest("The first word."))],
)
def test_another_sentence_is_not_found(other: Place) -> None:
    assert other.sentence(TEXT) is None


def test_a_changed_word_is_noticed() -> None:
    assert SENTENCE.sentence(TEXT.replace("first", "second")) is None


def test_a_paper_without_a_table_has_no_places() -> None:
    assert places("toy") == {}


@pytest.mark.parametrize("id", ["mirer2009:2.1.1", "poloskov2004:3.2.8"])
def test_a_record_shows_where_to_look(id: str) -> None:
    place = places(Id.parse(id).paper)[Id.parse(id).number]
    assert {record.place for record in decide(id)} == {f"line {place.line}: {place}"}
