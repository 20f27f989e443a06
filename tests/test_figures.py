"""generated/figures.md has a row for every kernel, and the self-test's table is that of the recorded result."""

from __future__ import annotations

from collections.abc import Sequence

import pytest
from bench_kernels import ACCURACY, SPEED
from kernel_reference import cases

from symcheck import kernels
from symcheck.selftest.figures import FIGURES, block, files, head, with_block

TEXT = (kernels.folder() / FIGURES).read_text(encoding="utf-8")
TABLES = {"speed of kernels": SPEED, "accuracy of kernels": ACCURACY}


def rows(name: str) -> list[list[str]]:
    """The cells of the table that stands between two markers."""
    lines = [line for line in block(TEXT, name).splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split(" | ")] for line in lines]


@pytest.mark.parametrize(("name", "columns"), TABLES.items())
def test_a_table_has_the_columns_of_the_benchmark_and_a_row_for_each_kernel(name: str, columns: Sequence[str]) -> None:
    first, second, *others = rows(name)
    assert [f"| {' | '.join(line)} |" for line in (first, second)] == head(columns)
    assert [cells[0] for cells in others] == list(cases())
    assert all(len(cells) == len(columns) for cells in others)


def test_errors_are_below_what_each_kernel_states() -> None:
    for case, (_, error, stated, _) in zip(cases().values(), rows("accuracy of kernels")[2:], strict=True):
        assert float(error) <= float(stated) == case.kernel.ulp


def test_a_new_table_changes_nothing_beside_it() -> None:
    text = "y <!-- t -->\ny\n<!-- end of t --> y"
    assert with_block(text, "t", ["a", r"\1"]) == "y <!-- t -->\na\n\\1\n<!-- end of t --> y"


def test_speeds_are_positive_numbers() -> None:
    assert all(float(cell) > 0 for cells in rows("speed of kernels")[2:] for cell in cells[2:])


def test_the_table_of_the_self_test_is_that_of_the_recorded_result() -> None:
    assert files(kernels.folder()) == {FIGURES: TEXT.encode()}
