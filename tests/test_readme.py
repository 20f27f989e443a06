"""The README's tables name every kernel; their figures are those of the machine that measured them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

import pytest
from bench_kernels import ACCURACY, README, SPEED, block, head, with_block
from kernel_reference import cases
from selftest_table import NAME, table

TABLES = {"speed of kernels": SPEED, "accuracy of kernels": ACCURACY}


def rows(name: str) -> list[list[str]]:
    """The cells of the table that stands between two markers."""
    lines = [line for line in block(README.read_text(encoding="utf-8"), name).splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split(" | ")] for line in lines]


@pytest.mark.parametrize(("name", "columns"), TABLES.items())
def test_the_table_in_the_readme_has_the_columns_of_the_benchmark_and_a_row_for_each_kernel(
    name: str, columns: Sequence[str]
) -> None:
    first, second, *others = rows(name)
    assert [f"| {' | '.join(line)} |" for line in (first, second)] == head(columns)
    assert [cells[0] for cells in others] == list(cases())
    assert all(len(cells) == len(columns) for cells in others)


def test_errors_in_the_readme_are_below_what_each_kernel_states() -> None:
    for case, (_, error, stated, _) in zip(cases().values(), rows("accuracy of kernels")[2:], strict=True):
        assert float(error) <= float(stated) == case.kernel.ulp


def test_a_new_table_changes_nothing_beside_it() -> None:
    text = "y <!-- t -->\ny\n<!-- end of t --> y"
    assert with_block(text, "t", ["a", r"\1"]) == "y <!-- t -->\na\n\\1\n<!-- end of t --> y"


def test_speeds_in_the_readme_are_positive_numbers() -> None:
    assert all(float(cell) > 0 for cells in rows("speed of kernels")[2:] for cell in cells[2:])


def test_the_readme_says_what_the_self_test_found() -> None:
    assert block(README.read_text(encoding="utf-8"), NAME).splitlines() == list(table())


def example(word: str) -> str:
    """The one block of Python in the README that has this word."""
    blocks = re.findall(r"^```python\n(.*?)^```", README.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
    (found,) = (block for block in blocks if word in block)
    return str(found)


def test_the_engineers_example_runs_as_it_is_printed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    exec(example("principal_inertia"), {})
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 4
    assert not re.search("nan|inf", " ".join(lines))
    loss = [float(x) for x in re.findall(r"[\d.]+", lines[1])]
    assert {n for n, rate in enumerate(loss, 1) if rate == min(loss)} == {1, 4}
    assert (tmp_path / "envelope.png").read_bytes().startswith(b"\x89PNG")
