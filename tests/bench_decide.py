"""Formulas of public texts before and after their authors corrected them, and a handbook: how many are decided.

The pairs of the first lie in the folder `corrections` beside that of the papers (SYMCHECK_SOURCES). Other tools decide
them, too: they are asked in the Python that SYMCHECK_PEERS names, if it has them, otherwise in this one.
"""

from __future__ import annotations

import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from handbook import Case, cases, pairs
from peers import PEERS

RIGHT = {True: "proved", False: "refuted"}
DRAWN = 1500  # identities of the handbook, and as many near misses
Records = list[dict[str, Any]]


def records(file: Path) -> Records:
    """Each formula with what is known of it and its truth."""
    found = []
    for line in file.read_text(encoding="utf-8").splitlines():
        pair = json.loads(line)
        shared = {key: pair[key] for key in ("where", "given", "letters")}
        for age in ("old", "new"):
            own = {"id": f"{pair['id']} {age}", "relation": pair[f"relation_{age}"], "truth": pair[f"truth_{age}"]}
            found.append({**own, **shared})
    return found


def ours(asked: Records) -> tuple[list[str], list[float]]:
    """The verdicts of `symcheck decide --batch` and the seconds that each took."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "asked.jsonl"
        lines = (json.dumps({key: each[key] for key in each if key != "truth"}) + "\n" for each in asked)
        file.write_text("".join(lines), encoding="utf-8")
        command = [sys.executable, "-m", "symcheck", "decide", "--batch", str(file), "--json"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    answers = {each["id"]: each for each in map(json.loads, done.stdout.splitlines())}
    verdicts = [answers.get(each["id"], {}).get("verdict", "unreadable") for each in asked]
    return verdicts, [each["seconds"] for each in answers.values() if "seconds" in each]


def theirs(name: str, asked: Records) -> list[str] | None:
    """The verdicts of another tool; None if it is not there."""
    python = os.environ.get("SYMCHECK_PEERS", sys.executable)
    lines = "".join(json.dumps(each) + "\n" for each in asked)
    command = [python, str(Path(__file__).with_name("peers.py")), name]
    done = subprocess.run(command, input=lines, capture_output=True, text=True, check=False)
    return done.stdout.splitlines() if done.returncode == 0 else None


def row(name: str, verdicts: list[str], asked: Records, seconds: float) -> str:
    """One line of the table."""
    right = [verdict == RIGHT[each["truth"]] for verdict, each in zip(verdicts, asked, strict=True)]
    decided = [verdict in ("proved", "refuted") for verdict in verdicts]
    wrong = sum(d and not r for d, r in zip(decided, right, strict=True))
    pairs = sum(a and b for a, b in zip(right[::2], right[1::2], strict=True))
    read = sum(verdict != "unreadable" for verdict in verdicts)
    return f"| {name} | {read} | {sum(right)} | {wrong} | {pairs} | {seconds:.0f} s |"


def timed(run: Callable[[], Any]) -> tuple[Any, float]:
    began = time.perf_counter()
    return run(), time.perf_counter() - began


def handbook(drawn: list[Case]) -> None:
    """Print what is decided of a handbook, by its parts."""
    asked = [
        {"id": str(n), "relation": each.relation, "where": each.where, "given": each.given,
         "letters": dict(each.letters), "truth": each.true}
        for n, each in enumerate(drawn)
    ]  # fmt: skip
    verdicts, seconds = ours(asked)
    table(f"{len(drawn)} relations of a handbook, half of them false", drawn, verdicts, seconds)


def table(title: str, drawn: list[Case], verdicts: list[str], seconds: list[float]) -> None:
    """Print how many relations of each part are decided, and how many of these wrongly."""
    print(f"\n{title}; the median is {statistics.median(seconds):.3f} s.\n")
    print("| part | true | proved | refuted | false | refuted | proved |")
    print("| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    for part in [*dict.fromkeys(each.family for each in drawn), "all"]:
        cells = []
        for truth in (True, False):
            found = [
                v
                for v, each in zip(verdicts, drawn, strict=True)
                if each.true is truth and part in (each.family, "all")
            ]
            cells += [len(found), found.count(RIGHT[truth]), found.count(RIGHT[not truth])]
        print(f"| {part} | {' | '.join(map(str, cells))} |")


def main() -> None:
    """Print the tables."""
    corrections()
    handbook([*cases(DRAWN)])
    handbook([each for pair in pairs() for each in pair])


def corrections() -> None:
    """Print what is decided of formulas before and after they were corrected, here and elsewhere."""
    sources = os.environ.get("SYMCHECK_SOURCES")
    file = Path(sources).parent / "corrections" / "dev.jsonl" if sources else None
    if file is None or not file.is_file():
        print("The corrections are not at hand: SYMCHECK_SOURCES does not name the folder beside them.")
        return
    asked = records(file)
    (verdicts, seconds), total = timed(lambda: ours(asked))
    print(
        f"{len(asked)} formulas in {len(asked) // 2} pairs; the median of ours is {statistics.median(seconds):.3f} s.\n"
    )
    print("| tool | read | right | wrong | pairs whole | time |")
    print("| --- | ---: | ---: | ---: | ---: | ---: |")
    print(row("symcheck", verdicts, asked, total))
    for name in PEERS:
        found, total = timed(lambda name=name: theirs(name, asked))
        print(row(name, found, asked, total) if found else f"| {name} | not installed | | | | |")


if __name__ == "__main__":
    main()
