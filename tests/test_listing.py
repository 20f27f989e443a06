"""The reader of printed lists and tables: all layouts and spellings, nothing mended, every fault at its place."""

from __future__ import annotations

from pathlib import Path

import pytest

from symcheck.core.verdicts import Origin
from symcheck.papers import listing
from symcheck.papers.ignatov2005 import derivation, lists, named
from symcheck.papers.ignatov2005.listed import Block, Printed
from symcheck.papers.listing import Label, Unreadable

PRINTED = [lists.printed_four, lists.printed_three, lists.printed_six, lists.printed_five]
SECTIONS = [printed.array.section for printed in PRINTED]


def blocks(printed: Printed) -> list[Block]:
    return [printed.vertices, printed.edges, printed.faces, printed.table]


def test_every_block_stands_in_the_source_word_for_word(sources: Path) -> None:
    source = (sources / "004_745ca85746c95545.txt").read_text(encoding="utf-8").split("\n")
    others = [block for block in vars(named).values() if isinstance(block, Block)]
    assert len(others) == 8
    for block in [*(block for printed in PRINTED for block in blocks(printed)), *others]:
        lines = block.text.split("\n")
        assert lines == [line.rstrip() for line in source[block.line - 1 : block.line - 1 + len(lines)]]


@pytest.mark.parametrize("printed", PRINTED, ids=SECTIONS)
def test_every_row_of_the_paper_is_read_on_its_line(printed: Printed) -> None:
    for block, rows in zip(blocks(printed), printed.read().values(), strict=True):
        lines = block.text.split("\n")
        for row in rows:
            assert not isinstance(row, Unreadable), row.fault
            assert row.printed[0].split("\n")[0] in lines[row.line - block.line]


def test_as_many_rows_are_read_as_the_paper_counts() -> None:
    counts = {printed.array.section: [len(rows) for rows in printed.read().values()] for printed in PRINTED}
    assert counts == {"2.1": [14, 24, 12, 14], "2.2": [8, 12, 6, 8], "3.1": [32, 60, 30, 32], "3.2": [22, 40, 20, 22]}


@pytest.mark.parametrize("printed", PRINTED, ids=SECTIONS)
def test_the_axes_in_whole_numbers_are_those_of_the_paper(printed: Printed) -> None:
    import sympy as sp

    a, b = sp.symbols("a b", real=True)
    if printed.array.section.startswith("2"):
        p, q, r = sp.sin(a) * sp.sin(b), sp.sin(a) * sp.cos(b), sp.cos(a)
        units, axes = (p, q, r), [(p, -q, -r), (p, q, -r), (p, -q, r), (p, q, r)]  # line 69
    else:
        units = (sp.sqrt(3) / 2 * sp.sin(a), sp.sin(a) / 2, sp.cos(a))
        found = derivation.six_axes()
        axes = [tuple(found[f"g_{i}{k}"] for k in (1, 2, 3)) for i in range(1, 7)]
    for whole, axis in zip(printed.array.axes, axes, strict=False):
        for n, unit, component in zip(whole, units, axis, strict=True):
            assert sp.simplify(n * unit - component) == 0


@pytest.mark.parametrize("printed", PRINTED, ids=SECTIONS)
def test_coordinates_are_written_as_the_paper_prints_them(printed: Printed) -> None:
    for row in printed.read()["V"]:
        signs = tuple(map(int, row.pattern))
        assert [c.replace(" ", "") for c in printed.array.coordinates(signs)] == [
            c.replace(" ", "") for c in row.coordinates
        ]


@pytest.mark.parametrize(
    ("printed", "label"),
    [
        ("V_3", Label("V", 3, False)),
        ("V'_3", Label("V", 3, True)),
        ("V_3'", Label("V", 3, True)),
        ("V_{16}'", Label("V", 16, True)),
        ("V'_{16}", Label("V", 16, True)),
        ("V_16'", Label("V", 16, True)),
    ],
)
def test_a_label_is_read_in_every_spelling(printed: str, label: Label) -> None:
    [row] = listing.edges(rf"1) ${printed}V_1 : \mathbf{{H}} = [u, 1, -1]$ ,", 7)
    assert not isinstance(row, Unreadable)
    assert (row.number, row.line, row.first, row.last) == (1, 7, label, Label("V", 1, False))


def test_rows_are_found_in_every_layout() -> None:
    rows = [r"1) V_2V_1 : \mathbf{H} = [u, 1]", r"2) V_3V_1 : \mathbf{H} = [1, u]"]
    inline = [f"{row[:3]}${row[3:]}$" for row in rows]
    layouts = [
        " ,\t".join(inline),
        " .\n".join(inline),
        "| " + " , | ".join(inline) + " |",
        "- " + ",\n- ".join(inline),
        r"$$\begin{aligned} " + r", & \quad ".join(rows) + r". \end{aligned}$$",
        "$$" + ", \\\\\n".join(rows) + r"\end{array}$$",
    ]
    for layout in layouts:
        found = listing.edges(layout, 1)
        assert [(row.number, getattr(row, "pattern", None)) for row in found] == [(1, ("u", "1")), (2, ("1", "u"))]


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        (r"1) $V_2V_1 : \mathbf{H} = [u, 2, 1]$", "line 7, column 31: 1, -1 or u is expected, not '2, 1]$'"),
        (r"1) $V_2V_1 : \mathbf{H} = [1, 1, 1]$", "each of u once"),
        (r"1) $V_2V_1 : \mathbf{H} = [u, u, 1]$", "each of u once"),
        (r"1) $V_2 : \mathbf{H} = [u, 1, 1]$", "line 7, column 9: a label V_i is expected, not ': "),
        (r"1) $V'_2'V_1 : \mathbf{H} = [u, 1, 1]$", "one prime is expected"),
        ("1) $V_2V_1 :\n\\mathbf{G} = [u, 1, 1]$", r"line 8, column 1: \mathbf{H} is expected"),
        (r"1) $V_2V_1 : \mathbf{H} = [u, 1, 1] = 0$", "the end of the row is expected, not '= 0$'"),
    ],
)
def test_what_cannot_be_read_is_reported_with_its_place(text: str, fault: str) -> None:
    [row] = listing.edges(text, 7)
    assert isinstance(row, Unreadable)
    assert fault in row.fault


def test_a_row_that_cannot_be_read_leaves_the_others_alone() -> None:
    rows = [
        r"1) $V_2V_1 : \mathbf{H} = [u, 1]$",
        r"2) $V_3V_1 : \mathbf{H} = [1]$",
        r"3) $V_3V_1 : \mathbf{H} = [1, u]$",
    ]
    assert [isinstance(row, Unreadable) for row in listing.edges("\n".join(rows), 1)] == [False, True, False]


def test_a_table_with_a_lost_cell_or_a_word_in_it_is_not_read() -> None:
    rows = listing.table("Vertex\t$X$\t$Y$\n$V_1$\t1.5\t0\n$V_2$\t1.5\n$V_3$\t1.5\tl.0\n$W_4$\t1\t2", 30)
    assert [getattr(row, "cells", None) for row in rows] == [(("X", "1.5"), ("Y", "0")), None, None, None]
    faults = [row.fault for row in rows if isinstance(row, Unreadable)]
    assert faults[0].startswith("line 32: 2 cells under 3 headings")
    assert faults[1].startswith("line 33, $V_3$, column Y: 'l.0' is not a number")
    assert faults[2].startswith("line 34, column 2: a label V_i is expected")


@pytest.mark.parametrize("printed", PRINTED, ids=SECTIONS)
def test_every_printed_vertex_has_one_meaning(printed: Printed) -> None:
    from symcheck.mechanics.zonotope import opposite
    from symcheck.papers.ignatov2005.rows import settled

    names = settled(printed.array, *(printed.read()[letter] for letter in "VEFT"))
    every = [signs for own in names.vertices.values() for signs in (own, opposite(own))]
    assert sorted(every) == sorted(printed.array.envelope.combinatorics.vertices)
    sides = [signs for own in names.faces.values() for signs in (own, opposite(own))]
    assert sorted(sides) == sorted(printed.array.envelope.combinatorics.faces)


def faults_of(number: str) -> dict[str, tuple[str, Origin, str]]:
    [item] = [
        item
        for bound in vars(lists).values()
        if isinstance(bound, tuple)
        for item in bound
        if getattr(item, "number", "") == number
    ]
    return {letter: (e.kind, e.origin, e.shown) for letter, e in item.errata.items()}


@pytest.mark.parametrize(
    ("number", "letters", "kind", "origin", "right"),
    [
        ("2.1V.2", "d", "letter", Origin.PAPER, r"\{\mathbf{e}_1, -\mathbf{e}_2, -\mathbf{e}_3\}"),
        ("2.1V.8", "b", "label", Origin.UNCERTAIN, "V'_7 :"),
        ("2.1E.9", "a", "lost prime", Origin.OCR, "V'_3 V_7 :"),
        ("2.1E.23", "ab", "label", Origin.UNCERTAIN, "V'_1 V'_2 :"),
        ("2.1F.2", "ab", "lost prime", Origin.OCR, "V'_1 V'_4, V'_4 V'_7, V'_7 V'_5, V'_5 V'_1"),
        ("2.1F.11", "ab", "label", Origin.PAPER, "V_2 V'_6, V'_6 V_4, V_4 V_1, V_1 V_2"),
        ("2.2V.1", "d", "sign", Origin.PAPER, r"\{-\mathbf{e}_1, -\mathbf{e}_2, -\mathbf{e}_3\}"),
        ("2.2E.10", "ab", "label", Origin.PAPER, "V'_2 V_4 :"),
        ("3.1E.52", "ab", "sign", Origin.UNCERTAIN, "[-1, -1, -1, 1, u, -1]"),
        ("3.1F.28", "ab", "label", Origin.PAPER, "V'_{15} V_{11}, V_{11} V'_{14}"),
        ("3.1F.29", "ab", "label", Origin.PAPER, "V_9 V_{16}, V_{16} V'_{12}, V'_{12} V_{15}, V_{15} V_9"),
        ("3.2F.11", "ab", "label", Origin.PAPER, "V_3 V_9, V_9 V'_{11}, V'_{11} V_8, V_8 V_3"),
        ("T6.19", "a", "rounding", Origin.PAPER, "X = -3.295, Y = 0, Z = 0.618"),
        ("T9.18", "ab", "number", Origin.UNCERTAIN, "X = 2.471, Y = -0.476, Z = -0.309"),
    ],
)
def test_a_wrong_row_is_put_right(number: str, letters: str, kind: str, origin: Origin, right: str) -> None:
    found = faults_of(number)
    assert "".join(found) == letters
    for said in found.values():
        assert said[:2] == (kind, origin)
        assert right in said[2]


@pytest.mark.parametrize("number", ["2.1V.1", "2.1E.1", "2.1F.1", "T1.5", "3.1V.17", "3.2F.15"])
def test_a_right_row_is_not_accused(number: str) -> None:
    assert faults_of(number) == {}
