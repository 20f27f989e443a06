"""generated/figures.md: what the benchmarks and the self-test measured, from the records in the same folder.

The benchmarks record what they print in generated/bench.json (`tests/bench_record.py`), the self-test its counts in
generated/selftest.json. The page follows from these two files alone.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Literal

import msgspec
from msgspec import Struct
from msgspec.structs import replace

from symcheck.core.counts import number_of
from symcheck.core.files import put
from symcheck.core.verdicts import SymcheckError
from symcheck.ledger import selftested
from symcheck.ledger.selftested import MISFITS, STATUSES
from symcheck.ledger.store import stored

ALONE = "found by dimensions alone"
BENCH, PAGE = "bench.json", "figures.md"
HEAD = """# Figures

Written by `make bench` and `make selftest` from `bench.json` and `selftest.json`; not to be edited. `symcheck generate
--check` compares it with these files.
"""
SELF_TEST = """\
`symcheck selftest` plants faults and counts those that go unnoticed: in printed statements (signs, factors, indices,
exponents, terms, letters, relations, bounds, equality cases, ends of intervals), hypotheses, certificates, kernels and
notation tables, and by proof methods that always say yes, compare a side with itself, or ignore the domain. A planted
fault is *equivalent* if it is shown exactly to change nothing; *weaker* and *stronger* statements are true and counted
apart; *open* means that no evaluation settles it. True statements written otherwise must not be rejected. The terms of
faults found by dimensions alone do not measure the same. Brackets hold the limits of 95 %.
"""


class Output(Struct, frozen=True, forbid_unknown_fields=True):
    """What one benchmark printed, when, and on which machine; Markdown as it is, other text in a block."""

    script: str
    title: str
    measured: str
    machine: str
    markdown: bool
    lines: tuple[str, ...]


class Bench(Struct, frozen=True, forbid_unknown_fields=True):
    """The recorded benchmarks: a summary of (what, figure, when it was recorded), and what each script printed."""

    schema: Literal[1]
    machine: str
    summary: tuple[tuple[str, str, str], ...]
    outputs: tuple[Output, ...]

    def output(self, script: str) -> Output:
        """What this script printed; SymcheckError if that was not recorded."""
        for output in self.outputs:
            if output.script == script:
                return output
        raise SymcheckError(f"{BENCH} has nothing of {script}; run `make bench`")


def bench(folder: Path) -> Bench | None:
    """The benchmarks recorded in a folder, None if there are none; SymcheckError if they cannot be read."""
    return stored(folder / BENCH, partial(msgspec.json.decode, type=Bench), "restore it, or run `make bench`")


def record(folder: Path, output: Output) -> None:
    """Keep what a benchmark printed, in place of what it printed before, and write the page anew."""
    before = bench(folder) or Bench(1, output.machine, (), ())
    outputs = {each.script: each for each in before.outputs} | {output.script: output}
    data = msgspec.to_builtins(replace(before, outputs=tuple(outputs.values())))
    put(folder / BENCH, f"{json.dumps(data, ensure_ascii=False, indent=1)}\n".encode())
    write(folder)


def write(folder: Path) -> None:
    """Write the page anew from what is recorded in the folder."""
    put(folder / PAGE, "".join(f"{line}\n" for line in page(folder)).encode())


def files(folder: Path) -> dict[str, bytes]:
    """What is to stay in the folder: the recorded benchmarks, and the page if anything is recorded."""
    kept = {BENCH: (folder / BENCH).read_bytes()} if bench(folder) else {}
    text = "".join(f"{line}\n" for line in page(folder)).encode()
    return {**kept, PAGE: text} if kept or selftested.recorded(folder) else {}


def page(folder: Path) -> Iterator[str]:
    """The lines of the page."""
    yield from HEAD.splitlines()
    yield from _self_test(folder)
    if measured := bench(folder):
        yield from _summary(measured)
        for output in measured.outputs:
            yield from _output(output)


def _self_test(folder: Path) -> Iterator[str]:
    result = selftested.recorded(folder)
    if not result:
        return
    yield from ("", "## How often the audit is wrong", "")
    yield from SELF_TEST.splitlines()
    yield ""
    yield from table(("planted in", *STATUSES, "rejected of the faults", ALONE, "right", "wrongly rejected"))
    rows = selftested.rows(result)
    for row in rows:
        if row.is_class:
            others = map(row.number, (MISFITS, "right", "false_rejections"))
            yield cells([row.name, *map(row.number, STATUSES), row.rate or "-", *others])
    found = {of: [row for row in rows if row.of == of and row.counts.get(MISFITS)] for of in ("kind", "paper")}
    for of, those in found.items():
        if those:
            yield ""
            yield f"{ALONE.capitalize()}, by {of}: {', '.join(map(_share, those))}."
    engines = result["engines"]
    evaluated = ", ".join(f"{name} {count:,}" for name, count in engines["evaluated"].items())
    yield ""
    were = number_of(engines["points"], "refutation was", "refutations were")
    yield f"{were} evaluated again at their exact points: {evaluated}, all three"
    yield f"{engines['all_three']:,}; {number_of(len(engines['disagreements']), 'disagreement')}."


def _share(row: selftested.Row) -> str:
    return f"{row.name} {row.number(MISFITS)} of {row.number('planted')}"


def _summary(measured: Bench) -> Iterator[str]:
    if measured.summary:
        yield from ("", "## In short", "", f"Measured on {measured.machine}, and recorded on the day named.", "")
        yield from table(("what", "figure", "recorded"))
        yield from map(cells, measured.summary)


def _output(output: Output) -> Iterator[str]:
    yield from ("", f"## {output.title}", "", f"`{output.script}`, {output.measured}, on {output.machine}.", "")
    yield from output.lines if output.markdown else ("```text", *output.lines, "```")


def table(names: Sequence[str]) -> Iterator[str]:
    """The first two lines of a table in Markdown."""
    yield from (cells(names), cells(["---"] * len(names)))


def cells(texts: Sequence[str]) -> str:
    """A line of a table in Markdown."""
    return f"| {' | '.join(texts)} |"
