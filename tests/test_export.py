"""What other tools get: every format holds the whole ledger and all errata, in its own rules of writing."""

from __future__ import annotations

import csv
import io
import json
import re
import shutil
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from click.testing import Result
from stand_in import correction

from symcheck import papers
from symcheck.audit import expand
from symcheck.core.verdicts import Origin, Reading, Role, Verdict
from symcheck.dimensions import CONSISTENT, INCONSISTENT, UNDETERMINED, Dimensions
from symcheck.dimensions.verdict import Conflicting
from symcheck.ledger import Record
from symcheck.views import exports as export
from symcheck.views.exports import Format, format_names, format_of
from symcheck.views.latex import is_formula

TEXTS = [name for name in format_names() if format_of(name).text]


def record(number: str, **fields: Any) -> Record:
    given: dict[str, Any] = {"section": "1", "line": 1, "role": Role.CLAIM, "verdict": Verdict.PROVED, **fields}
    return Record(id=f"toy:{number}", paper="toy", **given)


def wrong(number: str, printed: str, corrected: str, **fields: Any) -> Record:
    given = {"verdict": Verdict.REFUTED, "reading": Reading.MISPRINT, "kind": "sign", "origin": Origin.PAPER, **fields}
    return record(number, printed=printed, corrected=corrected, **given)


LEDGER = (
    record("1", printed=r"a_{11} \le |b|", words="a_11 is less than b | c"),
    wrong("2", "= x^2", "= -x^2", erratum=correction(added=("x is < 1 & odd",)), reason="100 % #1 {sure} ~ ^"),
    wrong("3V.1a", "u & v", "v & u", erratum=correction(row=True)),
    wrong("3V.1b", "u & v", "v & u", erratum=correction(row=True)),
    record("4", printed="(р = IT}", role=Role.PREMISE, verdict=None),
    record("5", words="-1 + @ = 0"),
)
TERMS = (Conflicting(term="m*v", measures="kg m/s"), Conflicting(term="E", measures="kg m^2/s^2"))
MEASURED = (
    wrong("6", "E = m v", "E = m v^2", dimension=Dimensions(verdict=INCONSISTENT, conflict=TERMS)),
    record("7", printed="a = b", dimension=Dimensions(verdict=UNDETERMINED, undetermined=("b",))),
    record("8", printed="c = d", dimension=Dimensions(verdict=CONSISTENT, sides=("kg",))),
)


def written(name: str, records: tuple[Record, ...] = LEDGER) -> str:
    text = format_of(name).text
    assert text
    return text(records)


def declared() -> Iterator[Record]:
    """Every declaration of the papers, undecided."""
    for paper in papers.load().values():
        for each in expand(paper):
            fields: dict[str, Any] = {
                "section": each.section.number,
                "line": each.item.source.line,
                "role": each.item.role,
            }
            yield Record(
                id=each.id,
                paper=paper.key,
                printed="\n".join(each.item.source.printed),
                words=each.item.source.words,
                read=next(iter(each.item.stated), ""),
                **fields,
            )


@pytest.mark.parametrize("name", format_names())
def test_every_format_says_what_it_is(name: str) -> None:
    chosen = format_of(name)
    assert chosen.says
    assert (chosen.text is None) != (chosen.files is None)


@pytest.mark.parametrize("name", TEXTS)
def test_every_item_and_the_same_text_each_time(name: str) -> None:
    text = written(name)
    assert text == written(name)
    assert all(re.search(rf"(?<![\w.]){each.id.partition(':')[2]}(?![\w.])", text) for each in LEDGER)


@pytest.mark.parametrize("name", TEXTS)
def test_an_empty_ledger_can_be_written(name: str) -> None:
    assert written(name, ())


def test_json_gives_the_records_back() -> None:
    data = json.loads(written("json"))
    assert [Record.from_json(item) for item in data["items"]] == list(LEDGER)
    assert data["errata"] == {
        "formulas and statements": ["toy:2"],
        "list rows and table cells": ["toy:3V.1a", "toy:3V.1b"],
    }


def test_csv_has_a_row_for_each_item_and_no_cell_that_a_spreadsheet_computes() -> None:
    text = written("csv")
    assert text.startswith("\ufeff")
    rows = list(csv.DictReader(io.StringIO(text.removeprefix("\ufeff"))))
    assert [row["id"] for row in rows] == [each.id for each in LEDGER]
    assert [row["printed"].strip() for row in rows] == [each.printed for each in LEDGER]
    assert [cell for row in rows for cell in row.values() if cell.startswith(("=", "+", "-", "@"))] == []
    assert {len(row) for row in rows} == {25}


def test_tables_of_markdown_keep_their_columns() -> None:
    lines = [line for line in written("markdown").splitlines() if line.startswith("|")]
    assert len(lines) > len(LEDGER)
    errata, ledger = 5, 6
    assert {len(re.findall(r"(?<!\\)\|", line)) for line in lines} == {errata, ledger}


@pytest.mark.parametrize("name", ["markdown", "tex"])
def test_texts_say_what_does_not_measure_the_same_and_nothing_where_all_is_well(name: str) -> None:
    text = written(name, MEASURED).replace("\\", "").replace("textasciicircum{}", "^")
    assert text.count("do not fit: m*v measures kg m/s, E measures kg m^2/s^2") == 2  # as an erratum, and in the ledger
    assert text.count("undetermined without b") == 1
    assert text.count("consistent") == 0
    assert "dimensions" not in written(name, LEDGER)


def test_markdown_tells_the_errata_before_the_ledger() -> None:
    text = written("markdown")
    assert text.index("\n## Formulas and statements") < text.index("\n## List rows") < text.index("\n## toy")
    assert "| 3V.1a, b |" in text


@pytest.mark.parametrize("records", [LEDGER, tuple(declared())], ids=["special characters", "all declarations"])
def test_the_document_compiles(records: tuple[Record, ...], tmp_path: Path) -> None:
    program = shutil.which("pdflatex")
    if not program:
        pytest.skip("pdflatex is not installed")
    (tmp_path / "ledger.tex").write_text(written("tex", records), encoding="utf-8")
    command = [program, "-interaction=nonstopmode", "-halt-on-error", "ledger.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, errors="replace", check=False)
    assert done.returncode == 0, done.stdout[-2000:]
    assert (tmp_path / "ledger.pdf").stat().st_size > 10_000


def test_every_formula_of_the_document_is_closed() -> None:
    text = written("tex", tuple(declared()))
    body = text[text.index(r"\begin{document}") :]
    assert len(re.findall(r"(?<!\\)\$", body)) % 2 == 0
    assert len(re.findall(r"(?<!\\)\{", body)) == len(re.findall(r"(?<!\\)\}", body))
    assert sum(is_formula(each.printed) for each in declared()) > 500


def test_standard_output_gets_what_the_file_gets(symcheck: Callable[..., Result], toy: Path) -> None:
    shown = symcheck("export", "--jobs", "0", "--format", "markdown", "toy:1.3")
    told = symcheck("export", "--jobs", "0", "--format", "markdown", "toy:1.3", "--output", str(toy / "a" / "b.md"))
    assert (shown.exit_code, told.exit_code) == (0, 0)
    assert (toy / "a" / "b.md").read_text(encoding="utf-8") == shown.stdout
    assert "1 item," in told.stdout


def test_an_unknown_format_names_those_there_are(symcheck: Callable[..., Result]) -> None:
    result = symcheck("export", "--format", "xml")
    assert result.exit_code == 2
    assert all(name in result.stderr for name in TEXTS)


def test_a_format_of_many_files_writes_a_folder(
    symcheck: Callable[..., Result], toy: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    many = Format("two files", files=lambda records: {"a.v": records[0].id, "b/c.v": "c"})
    monkeypatch.setattr(export, "format_of", lambda _: many)
    monkeypatch.setattr("symcheck.cli.export.format_of", lambda _: many)
    result = symcheck("export", "--jobs", "0", "--format", "tex", "toy:1.3", "--output", str(toy / "out"))
    assert result.exit_code == 0, result.output
    assert (toy / "out" / "a.v").read_text() == "toy:1.3"
    assert (toy / "out" / "b" / "c.v").read_text() == "c"
