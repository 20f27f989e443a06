"""Seeded damage: every edit of a row or cell is reported, and what the untouched rows state stays as it is."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from dataclasses import replace
from functools import cache

import pytest
from declarations import errata

from symcheck import papers
from symcheck.audit import Context, units
from symcheck.audit.judge import judge
from symcheck.core.claims import Assertion, Declaration
from symcheck.core.verdicts import Verdict
from symcheck.papers.ignatov2005 import lists
from symcheck.papers.ignatov2005.listed import Block, Declared, Printed, declared

PAPER = papers.load()["ignatov2005"]
PRINTED = (lists.printed_four, lists.printed_three, lists.printed_six, lists.printed_five)
LISTS = ("vertices", "edges", "faces", "table")
LABEL = re.compile(r"V(?:'?_(?:\{\d+\}|\d+)'?)")
FACE = re.compile(r"F'?_\{?(\d+)\}?'?")
SIGNED = re.compile(
    r"(?<=[\[,])\s*-?1(?=\s*[,\]])"  # momenta
    r"|-?\\mathbf\{e\}_\d"  # directions
    r"|(?<=[(,])\s*-?[^,()\[\]=]*\\(?:sin|cos)[^,()]*"  # coordinates
    r"|(?<=\t)-?\d+\.\d+"  # cells
)
EDITS = 200
SEED = 2005

Edit = Callable[[str, random.Random], str | None]


def drop_a_prime(text: str, rng: random.Random) -> str | None:
    places = [m.start() for m in re.finditer("'", text)]
    if not places:
        return None
    k = rng.choice(places)
    return text[:k] + text[k + 1 :]


def flip_a_sign(text: str, rng: random.Random) -> str | None:
    places = list(SIGNED.finditer(text))
    if not places:
        return None
    match = rng.choice(places)
    bare = match[0].lstrip()
    turned = bare[1:] if bare.startswith("-") else f"-{bare}"
    return text[: match.start()] + match[0][: len(match[0]) - len(bare)] + turned + text[match.end() :]


def swap_two_labels(text: str, rng: random.Random) -> str | None:
    """Of different vertices; not those of one edge of a face: it is the same edge begun at the other end."""
    found = list(LABEL.finditer(text))
    pairs = [
        (a, b)
        for k, a in enumerate(found)
        for m, b in enumerate(found[k + 1 :], k + 1)
        if meaning(a[0]) != meaning(b[0]) and (len(found) == 2 or k // 2 != m // 2)
    ]
    if not pairs:
        return None
    a, b = rng.choice(pairs)
    return text[: a.start()] + b[0] + text[a.end() : b.start()] + a[0] + text[b.end() :]


def change_a_digit(text: str, rng: random.Random) -> str | None:
    """Of a cell, beyond rounding; of a coordinate, any."""
    cells = list(re.finditer(r"(?<=\t)-?\d+(?:\.\d+)?", text))
    if not cells:
        coordinates = text[text.rindex("=") :]
        digits = [
            len(text) - len(coordinates) + m.start()
            for m in re.finditer(r"(?<![_{])\d(?=[^}\]]*\\(?:sin|cos))", coordinates)
        ]
        if r"\{" not in text or not digits:
            return None
        k = rng.choice(digits)
        return text[:k] + rng.choice([d for d in "123456789" if d != text[k]]) + text[k + 1 :]
    cell = rng.choice(cells)
    value = f"{float(cell[0]) + rng.choice([1, -1]) * rng.choice([0.002, 0.01, 0.3, 2]):.3f}"
    return text[: cell.start()] + value + text[cell.end() :]


def rename_the_face(text: str, rng: random.Random) -> str | None:
    """The label of a face, another one that is there in every list."""
    match = FACE.search(text)
    if match is None:
        return None
    return text[: match.start()] + f"F_{rng.choice([n for n in '123' if n != match[1]])}" + text[match.end() :]


def meaning(label: str) -> tuple[bool, str]:
    return "'" in label, re.sub(r"\D", "", label)


KINDS: tuple[Edit, ...] = (drop_a_prime, flip_a_sign, swap_two_labels, change_a_digit, rename_the_face)


@cache
def before(place: int) -> Declared:
    return declared(PRINTED[place])


def rows_of(found: Declared) -> dict[str, Declaration]:
    every = (item for name in LISTS for item in getattr(found, name))
    return {item.number: item for item in every if "." in item.number[2:] or item.number.startswith("T")}


def span(block: Block, item: Declaration) -> tuple[int, int]:
    """Where a row stands in its block."""
    start = end = block.text.index(item.source.printed[0])
    for piece in item.source.printed:
        end = block.text.index(piece, end) + len(piece)
    return start, end


def damaged(rng: random.Random) -> tuple[int, Printed, str, str]:
    """A place, what is printed there after one edit, the row's number and how it reads now."""
    while True:
        place, name = rng.randrange(len(PRINTED)), rng.choice(LISTS)
        right = [item for item in getattr(before(place), name) if item.source.printed and not errata(item)]
        if not right:  # section 2.2 prints no face right
            continue
        item = rng.choice(right)
        block = getattr(PRINTED[place], name)
        start, end = span(block, item)
        row = rng.choice(KINDS)(block.text[start:end], rng)
        if row is not None:
            text = block.text[:start] + row + block.text[end:]
            return place, replace(PRINTED[place], **{name: replace(block, text=text)}), item.number, row


def is_reported(item: Declaration) -> bool:
    """Whether a row is refuted, or cannot be read."""
    if not isinstance(item, Assertion):
        return bool(item.reason)
    context = Context(PAPER, item)
    doubted = sorted(units(context), key=lambda unit: unit.letter not in errata(item))
    return any(
        judge(context.having(doubted=unit.letter in errata(item)), unit, item.statement.given).verdict
        is Verdict.REFUTED
        for unit in doubted
    )


def _said(item: Declaration) -> tuple[tuple[str, ...], set[str]]:
    """What a row says, and which of it is wrong."""
    return item.stated, set(errata(item))


def test_every_damage_is_reported_and_changes_nothing_else() -> None:
    rng, kinds = random.Random(SEED), set()
    for _ in range(EDITS // 2):
        place, printed, number, row = damaged(rng)
        old, found = rows_of(before(place)), declared(printed)
        new = rows_of(found)
        assert found.names == before(place).names, f"{number}: {row}"
        assert new.keys() == old.keys(), f"{number}: {row}"
        changed = {n for n in old if _said(old[n]) != _said(new[n])}
        assert changed <= {number}, f"{number}: {row}"
        assert is_reported(new[number]), f"{number}: {row}"
        kinds.add(number[3] if number[0] != "T" else "T")
    assert kinds == set("VEFT")


def test_each_part_of_a_row_fails_with_some_damage() -> None:
    parts = {"V": "abcd", "E": "abc", "F": "abcd", "T": "abc"}
    rng, unseen = random.Random(SEED), {(kind, letter) for kind, letters in parts.items() for letter in letters}
    for _ in range(EDITS):
        _, printed, number, _ = damaged(rng)
        failed = {(number[3] if number[0] != "T" else "T", x) for x in errata(rows_of(declared(printed))[number])}
        assert all(letter in parts[kind] for kind, letter in failed)
        unseen -= failed
        if not unseen:
            return
    assert not unseen


@pytest.mark.parametrize("place", range(len(PRINTED)))
def test_rows_whose_labels_are_exchanged_are_both_reported(place: int) -> None:
    rng, block = random.Random(SEED), PRINTED[place].vertices
    right = [item for item in before(place).vertices if item.source.printed and not errata(item)]
    for _ in range(5):
        one, other = sorted(rng.sample(right, 2), key=lambda item: span(block, item))
        text, spans = block.text, [span(block, item) for item in (one, other)]
        labels = [LABEL.search(text, *each) for each in spans]
        assert all(labels)
        a, b = (match for match in labels if match)
        text = text[: a.start()] + b[0] + text[a.end() : b.start()] + a[0] + text[b.end() :]
        new = rows_of(declared(replace(PRINTED[place], vertices=replace(block, text=text))))
        assert all(is_reported(new[item.number]) for item in (one, other))
        old = rows_of(before(place))
        assert {n for n in old if old[n].stated != new[n].stated} <= {one.number, other.number}


@pytest.mark.parametrize("printed", PRINTED, ids=lambda printed: printed.array.section)
def test_a_list_that_lost_a_row_or_has_one_twice_is_reported(printed: Printed) -> None:
    for name in ("vertices", "edges", "faces"):
        whole, *rows = getattr(declared(printed), name)
        block = getattr(printed, name)
        item = rows[-1]
        start, end = span(block, item)
        text = block.text[:start] + re.sub(r"V|F", "W", block.text[start:end]) + block.text[end:]
        damaged_list = getattr(declared(replace(printed, **{name: replace(block, text=text)})), name)[0]
        assert damaged_list.stated != whole.stated
        assert is_reported(damaged_list)
