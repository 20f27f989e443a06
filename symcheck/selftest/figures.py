"""generated/figures.md: what was measured, a table between two markers for each command that measures."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from symcheck.core.files import put
from symcheck.ledger.selftested import recorded, rows
from symcheck.selftest.table import STATUSES

FIGURES = "figures.md"
SELFTEST = "self-test"
MARKERS = "<!-- {0} -->\n(.*?)\n<!-- end of {0} -->"
COLUMNS = ("planted in", *STATUSES, "rejected of the faults", "right", "rejected")


def files(folder: Path) -> dict[str, bytes]:
    """The file as it has to be: the self-test's table is that of the recorded result, all else stays."""
    file, result = folder / FIGURES, recorded(folder)
    if result is None or not file.is_file():
        return {}
    text = file.read_text(encoding="utf-8")
    return {FIGURES: with_block(text, SELFTEST, list(selftest_table(result))).encode()}


def renew(folder: Path) -> None:
    """Write the table of the self-test anew."""
    for name, data in files(folder).items():
        put(folder / name, data)


def write(folder: Path, name: str, lines: Sequence[str]) -> None:
    """Put new lines between the markers of that name."""
    file = folder / FIGURES
    put(file, with_block(file.read_text(encoding="utf-8"), name, lines).encode())


def selftest_table(result: Mapping[str, Any]) -> Iterator[str]:
    """A row for each class of faults and for all, and what three engines made of the refutations."""
    yield from head(COLUMNS)
    for each in rows(result):
        if each.is_class:
            counts = [each.counts.get(name, 0) for name in STATUSES]
            right = (each.counts["right"], each.counts["false_rejections"])
            yield row([each.name, *map(_number, counts), each.rate, *map(_number, right)])
    engines = result["engines"]
    evaluated = ", ".join(f"{name} {count:,}" for name, count in engines["evaluated"].items())
    yield ""
    yield (
        f"{engines['points']:,} refutations were evaluated again at their exact points: {evaluated}, all three "
        f"{engines['all_three']:,}; {len(engines['disagreements'])} disagreements."
    )


def _number(value: int) -> str:
    return f"{value:,}" if value else "-"


def head(names: Sequence[str]) -> list[str]:
    """The first two lines of a table."""
    return [row(names), row(["---"] * len(names))]


def row(cells: Sequence[str]) -> str:
    """A line of a table."""
    return f"| {' | '.join(cells)} |"


def block(text: str, name: str) -> str:
    """What stands between the two markers of that name."""
    (found,) = re.findall(MARKERS.format(name), text, re.DOTALL)
    return str(found)


def with_block(text: str, name: str, lines: Sequence[str]) -> str:
    """The text with these lines between the two markers of that name."""
    first, last = MARKERS.format(name).split("(.*?)")
    return re.sub(MARKERS.format(name), lambda _: first + "\n".join(lines) + last, text, flags=re.DOTALL)
