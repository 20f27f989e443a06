"""The confusion matrix for people."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rich.table import Table

from symcheck.core.counts import number_of
from symcheck.ledger.selftested import MISFITS, STATUSES, Row, rows

COLUMNS = (*STATUSES, "rejected of those that are faults", MISFITS, "right", "rejected")
MAX_LISTED = 20  # faults that were judged wrongly, named one by one: about a screen


def show(out: Any, result: Mapping[str, Any]) -> None:
    """A line for each kind, class and for all; then what went wrong."""
    table = Table(box=None, pad_edge=False)
    table.add_column("fault")
    for name in COLUMNS:
        table.add_column(name, justify="right")
    for row in rows(result):
        table.add_row(row.name if row.is_class else f"  {row.name}", *cells(row), style="bold" if row.is_class else "")
    out.print(table)
    engines = result["engines"]
    counts = ", ".join(f"{name} {count:,}" for name, count in engines["evaluated"].items())
    out.print(
        f"{number_of(engines['points'], 'refutation')}, all re-evaluated by the checker; "
        f"evaluated at their points by: {counts}."
    )
    out.print(f"{number_of(len(engines['disagreements']), 'disagreement')}; {engines['all_three']:,} by all three.")
    out.print(
        f"{number_of(len(result['findings']), 'finding')} (hypotheses not needed, bounds without a set of equality, "
        "statements that could say more): see --json."
    )
    wrong = [*result["errors"], *result["unfinished"], *engines["disagreements"]]
    for line in wrong[:MAX_LISTED]:
        out.print(line, markup=False)
    if len(wrong) > MAX_LISTED:
        out.print(f"and {len(wrong) - MAX_LISTED} more; --json lists all")


def cells(row: Row) -> list[str]:
    """The cells behind the name."""
    wrongly = row.number("false_rejections") if row.counts["right"] else ""
    return [*map(row.number, STATUSES), row.rate, row.number(MISFITS), row.number("right"), wrongly]
