"""generated/figures.md follows from what was recorded, and its tables name every kernel."""

from __future__ import annotations

import json
from collections.abc import Sequence
from itertools import takewhile
from pathlib import Path

import bench_record
import pytest
from bench_kernels import ACCURACY, SPEED
from kernel_reference import cases

from symcheck import kernels
from symcheck.core.verdicts import SymcheckError
from symcheck.ledger import selftested
from symcheck.views import figures
from symcheck.views.figures import Output

TABLES = {"Speed": SPEED, "Accuracy": ACCURACY}
OUTPUT = Output("bench.py", "Proofs", "2026-11-23", "2 cores", False, ("a line",))


def rows(title: str) -> list[list[str]]:
    """The cells of the table below a heading of what the benchmark of the kernels printed."""
    recorded = figures.bench(kernels.folder())
    assert recorded
    lines = iter(recorded.output("bench_kernels.py").lines)
    next(line for line in lines if line.startswith(f"### {title}"))
    below = takewhile(lambda line: not line.startswith("###"), lines)
    return [[cell.strip() for cell in line.strip("|").split(" | ")] for line in below if line.startswith("|")]


@pytest.mark.parametrize(("title", "columns"), TABLES.items())
def test_a_table_has_the_columns_of_the_benchmark_and_a_row_for_each_kernel(title: str, columns: Sequence[str]) -> None:
    first, second, *others = rows(title)
    assert [figures.cells(line) for line in (first, second)] == [*figures.table(columns)]
    assert [cells[0] for cells in others] == list(cases())
    assert all(len(cells) == len(columns) for cells in others)


def test_recorded_errors_are_below_what_each_kernel_states() -> None:
    for case, (_, error, stated, _) in zip(cases().values(), rows("Accuracy")[2:], strict=True):
        assert float(error) <= float(stated) == case.kernel.ulp


def test_recorded_speeds_are_positive_numbers() -> None:
    assert all(float(cell) > 0 for cells in rows("Speed")[2:] for cell in cells[2:])


def test_the_page_is_what_follows_from_the_records() -> None:
    folder = kernels.folder()
    assert (folder / figures.PAGE).read_bytes() == figures.files(folder)[figures.PAGE]


def test_the_page_has_every_class_of_faults_and_every_figure() -> None:
    text = (kernels.folder() / figures.PAGE).read_text(encoding="utf-8")
    result, recorded = selftested.recorded(kernels.folder()), figures.bench(kernels.folder())
    assert result
    assert recorded
    assert [name for name in result["classes"] if f"\n| {name} |" not in text] == []
    assert [what for what, figure, _ in recorded.summary if f"| {what} | {figure} |" not in text] == []


def test_the_page_says_how_many_faults_dimensions_alone_find() -> None:
    text, result = "\n".join(figures.page(kernels.folder())), selftested.recorded(kernels.folder())
    assert result
    lines = [line.strip("|").split(" | ") for line in text.splitlines() if line.startswith("| ")]
    table = {cells[0].strip(): cells for cells in takewhile(lambda cells: cells[0] != " what", lines)}
    column = table["planted in"].index(figures.ALONE)
    for name, counts in {**result["classes"], "all": result}.items():
        assert table[name][column] == (f"{counts['by dimension']:,}" if counts["by dimension"] else "-")
    kinds = result["classes"]["statements"]["kinds"]
    assert f"exponent {kinds['exponent']['by dimension']} of {kinds['exponent']['planted']}" in text


def test_nothing_is_written_where_nothing_was_recorded(tmp_path: Path) -> None:
    assert figures.files(tmp_path) == {}


def test_a_recorded_output_replaces_the_one_before(tmp_path: Path) -> None:
    figures.record(tmp_path, OUTPUT)
    figures.record(tmp_path, Output("bench.py", "Proofs", "2026-11-24", "2 cores", False, ("another line",)))
    recorded = figures.bench(tmp_path)
    assert recorded
    assert [each.lines for each in recorded.outputs] == [("another line",)]
    assert "```text\nanother line\n```" in (tmp_path / figures.PAGE).read_text(encoding="utf-8")
    assert figures.files(tmp_path) == {name: (tmp_path / name).read_bytes() for name in (figures.BENCH, figures.PAGE)}


EMPTY = '"machine": "", "summary": [], "outputs": []'


@pytest.mark.parametrize(
    "text", ["{", "[]", '{"schema": 1}', f'{{"schema": 2, {EMPTY}}}', f'{{"schema": 1, "more": 1, {EMPTY}}}']
)
def test_a_damaged_record_is_named(text: str, tmp_path: Path) -> None:
    (tmp_path / figures.BENCH).write_text(text, encoding="utf-8")
    with pytest.raises(SymcheckError, match=r"bench\.json cannot be read .* run `make bench`"):
        figures.files(tmp_path)


def test_what_was_not_recorded_is_named() -> None:
    recorded = figures.bench(kernels.folder())
    assert recorded
    with pytest.raises(SymcheckError, match=r"nothing of bench_moon\.py; run `make bench`"):
        recorded.output("bench_moon.py")


def test_a_benchmark_is_shown_and_recorded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "bench.py").write_text("print('12 ms')\nprint()\n", encoding="utf-8")
    monkeypatch.setattr(bench_record, "__file__", str(tmp_path / "bench_record.py"))
    monkeypatch.setattr(kernels, "folder", lambda: tmp_path)
    bench_record.main(["bench.py"])
    assert capsys.readouterr().out == "12 ms\n\n"
    [output] = json.loads((tmp_path / figures.BENCH).read_text(encoding="utf-8"))["outputs"]
    assert (output["script"], output["lines"]) == ("bench.py", ["12 ms"])


def test_every_benchmark_of_make_bench_has_a_title(root: Path) -> None:
    lines = (root / "Makefile").read_text(encoding="utf-8").splitlines()
    named = [word for line in lines if "bench_record.py" in line for word in line.split() if word.startswith("bench")]
    assert sorted(named) == sorted(bench_record.TITLES)
    assert [name for name in named if not (root / "tests" / name).is_file()] == []
