"""The confusion matrix for people."""

from __future__ import annotations

from typing import Any

from rich.table import Table

from symcheck.selftest.run import Result
from symcheck.selftest.trial import Count, Fate, limits, total

COLUMNS = ("planted", "rejected", "accepted", "equivalent", "rejected of those that are faults", "right", "rejected")
MOST_TOLD = 20


def show(out: Any, result: Result) -> None:
    """A line for each kind, class and for all; then what went wrong."""
    table = Table(box=None, pad_edge=False)
    table.add_column("fault")
    for name in COLUMNS:
        table.add_column(name, justify="right")
    for name, kinds in result.counts.items():
        table.add_row(name, *_cells(total(kinds.values())), style="bold")
        for kind, count in kinds.items():
            table.add_row(f"  {kind}", *_cells(count))
    table.add_row("all", *_cells(result.whole), style="bold")
    out.print(table)
    engines = result.engines
    told = ", ".join(f"{name} {count:,}" for name, count in engines.evaluated.items())
    out.print(f"{engines.points:,} refutations, all re-evaluated by the checker; evaluated at their points by: {told}.")
    out.print(f"{len(engines.disagreements)} disagreements; {engines.all_three:,} by all three.")
    out.print(
        f"{len(result.findings):,} findings (hypotheses not needed, bounds without a set of equality): see --json."
    )
    wrong = [*result.whole.errors, *result.unfinished, *engines.disagreements]
    for line in wrong[:MOST_TOLD]:
        out.print(line, markup=False)
    if len(wrong) > MOST_TOLD:
        out.print(f"and {len(wrong) - MOST_TOLD} more; --json lists all")


def _cells(count: Count) -> list[str]:
    fates = count.fates
    faults = fates[Fate.REJECTED] + fates[Fate.ACCEPTED]
    first = [count.planted, fates[Fate.REJECTED], fates[Fate.ACCEPTED], fates[Fate.EQUIVALENT]]
    shown = [*map(_number, first), _rate(limits(fates[Fate.REJECTED], faults))]
    return [*shown, _number(count.right), _number(fates[Fate.FALSELY_REJECTED]) if count.right else ""]


def _number(value: int) -> str:
    return f"{value:,}" if value else "-"


def _rate(rate: list[float] | None) -> str:
    return f"{100 * rate[1]:.2f} % ({100 * rate[0]:.2f} to {100 * rate[2]:.2f})" if rate else ""
