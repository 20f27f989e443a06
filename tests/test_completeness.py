"""Nothing printed is left out: every displayed block and every inline relation of a source belongs to a declaration."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from symcheck import papers
from symcheck.core.claims import Declaration, Exclusion, Paper
from symcheck.reading import split_tag

PAPERS = list(papers.load().values())
LAYOUT = re.compile(r"\\begin\{aligned\}|\\end\{aligned\}|\\begin\{array\}\{l+\}|\\end\{array\}|\\quad|[\s&.,;]|\\\\")
RELATION_SIGN = re.compile(r"=|\\neq?\b|\\leq?\b|\\geq?\b|<|>|\\in\b|\\subset\b|\\max|\[0")


def squeezed(text: str) -> str:
    return re.sub(r"\s+", "", text).rstrip(".,;")


def blocks(text: str) -> list[tuple[int, str]]:
    """Line and content of every displayed block."""
    return [(text[: m.start()].count("\n") + 1, m[1]) for m in re.finditer(r"\$\$(.*?)\$\$", text, re.S)]


def inline(text: str) -> list[tuple[int, str]]:
    without = re.sub(r"\$\$.*?\$\$", lambda m: "\n" * m[0].count("\n"), text, flags=re.S)
    return [(without[: m.start()].count("\n") + 1, m[1]) for m in re.finditer(r"\$([^$]+)\$", without)]


def printed_items(paper: Paper) -> list[Declaration]:
    return [item for _, _, item in paper.items() if item.source.printed]


@pytest.fixture(params=PAPERS, ids=lambda paper: paper.key)
def paper(request: pytest.FixtureRequest) -> Paper:
    return request.param


@pytest.fixture
def source(paper: Paper, sources: Path) -> str:
    return (sources / paper.source).read_text(encoding="utf-8")


def test_every_displayed_block_is_covered_to_the_last_character(paper: Paper, source: str) -> None:
    pieces = [squeezed(piece) for item in printed_items(paper) for piece in item.source.printed]
    for line, block in blocks(source):
        rest = squeezed(split_tag(block)[0])
        for piece in sorted(set(pieces), key=len, reverse=True):
            rest = rest.replace(piece, "")
        assert not LAYOUT.sub("", rest), f"line {line} is not covered: {rest}"


def test_every_inline_relation_is_declared(paper: Paper, source: str) -> None:
    pieces = {squeezed(piece) for item in printed_items(paper) for piece in item.source.printed}
    missing = [
        (line, text) for line, text in inline(source) if RELATION_SIGN.search(text) and squeezed(text) not in pieces
    ]
    assert not missing


def test_every_printed_string_stands_in_the_source_on_its_line(paper: Paper, source: str) -> None:
    lines = source.split("\n")
    for item in printed_items(paper):
        rest = squeezed("\n".join(lines[item.source.line - 1 :]))
        for piece in item.source.printed:
            assert squeezed(piece) in rest, f"{item.number}: {piece}"
        first = squeezed(item.source.printed[0])
        assert first not in squeezed("\n".join(lines[item.source.line :])) or first in squeezed(
            lines[item.source.line - 1]
        ), item.number
        head = squeezed(lines[item.source.line - 1])
        assert first in head or (head.lstrip("$") and first.startswith(head.lstrip("$"))), (
            f"{item.number}: line {item.source.line}"
        )


def test_a_printed_tag_is_the_number_of_its_declaration(paper: Paper, source: str) -> None:
    tags = {tag for _, block in blocks(source) if (tag := split_tag(block)[1])}
    numbers = {item.number: item for item in printed_items(paper)}
    for _, block in blocks(source):
        body, tag = split_tag(block)
        if tag:
            owners = [
                n for n, item in numbers.items() if any(squeezed(p) in squeezed(body) for p in item.source.printed)
            ]
            assert tag in owners, f"({tag}) is declared as {owners}"
    assert tags or not blocks(source)


def test_the_printed_numbering_has_no_gap(paper: Paper) -> None:
    numbered = [tuple(map(int, n.split("."))) for _, _, i in paper.items() if re.fullmatch(r"\d+\.\d+", n := i.number)]
    for section in sorted({first for first, _ in numbered} - {0}):
        found = sorted(second for first, second in numbered if first == section)
        first = found[0] if paper.excerpt else 1
        assert found == list(range(first, first + len(found))), f"section {section}"


def test_every_exclusion_and_premise_in_words_says_why(paper: Paper) -> None:
    for _, _, item in paper.items():
        if isinstance(item, Exclusion):
            assert item.reason, item.number
        assert item.source.printed or item.source.words, item.number
