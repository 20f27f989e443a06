"""Puts what the self-test found, as generated/selftest.json has it, into the README. Run by `make selftest`."""

from __future__ import annotations

from collections.abc import Iterator

from bench_kernels import README, head, row, with_block

from symcheck import kernels
from symcheck.evidence.selftested import recorded, rows
from symcheck.selftest.table import STATUSES

NAME = "self-test"
COLUMNS = ("planted in", *STATUSES, "rejected of the faults", "right", "rejected")


def table() -> Iterator[str]:
    """A row for each class of faults and for all, and what three engines made of the refutations."""
    result = recorded(kernels.folder())
    assert result, "run `symcheck selftest --record`"
    yield from head(COLUMNS)
    for each in rows(result):
        if each.is_class:
            counts = [each.counts.get(name, 0) for name in STATUSES]
            right = (each.counts["right"], each.counts["false_rejections"])
            yield row([each.name, *map(_number, counts), each.rate, *map(_number, right)])
    engines = result["engines"]
    told = ", ".join(f"{name} {count:,}" for name, count in engines["evaluated"].items())
    yield ""
    yield (
        f"{engines['points']:,} refutations were evaluated again at their exact points: {told}, all three "
        f"{engines['all_three']:,}; {len(engines['disagreements'])} disagreements."
    )


def _number(value: int) -> str:
    return f"{value:,}" if value else "-"


def main() -> None:
    """Write the README anew."""
    README.write_text(with_block(README.read_text(encoding="utf-8"), NAME, list(table())), encoding="utf-8")


if __name__ == "__main__":
    main()
