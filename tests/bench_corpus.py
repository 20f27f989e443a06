"""The reader on displays of public repositories, beside SymPy's parsers and latex2sympy2_extended.

`python tests/bench_corpus.py [formulas.jsonl]`; without a file that of the folder `corpus` beside the papers. The other
parsers are asked in the Python that SYMCHECK_PEERS names, if it has them, otherwise in this one.

A tree of ours is a reading with inferred letters, a statement one that lowers to formulas, or to a form that keeps what
is printed where letters are of unknown kinds or nothing can be calculated; of another parser it is a result without an
error. Nothing is said here of how many are right. The formulas are those of the file, one JSON object a line with
`repo`, `group` and `tex`.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections import defaultdict
from importlib import import_module
from pathlib import Path

from peers import PARSERS

from symcheck.core.verdicts import Doubt, SymcheckError
from symcheck.reading import lower, read
from symcheck.reading.inference import inferred
from symcheck.reading.surface import plain, with_plain_differentials

MOST_READINGS = 4  # of one display; the first of them is right where any is


def ours(latex: str) -> tuple[bool, bool]:
    """Whether a display gives a tree, and whether it gives a statement."""
    tree = False
    try:
        text = with_plain_differentials(plain(latex))
        inferences = [each for each in inferred([text], {}, {}) if not each.remote][:MOST_READINGS]
    except SymcheckError:
        return False, False
    for inference in inferences:
        try:
            found = read(text, inference.notation)
            tree = True
            lower(found, inference.notation)
        except Doubt:
            break
        except SymcheckError:
            continue
        return True, True
    return tree, False


def theirs(name: str, rows: list[dict[str, str]]) -> list[bool] | None:
    """Whether another parser gives a result for each display; None if it is not there."""
    python = os.environ.get("SYMCHECK_PEERS", sys.executable)
    lines = "".join(json.dumps({"tex": row["tex"]}) + "\n" for row in rows)
    command = [python, str(Path(__file__).with_name("peers.py")), name]
    done = subprocess.run(command, input=lines, capture_output=True, text=True, check=False)
    return [line == "read" for line in done.stdout.splitlines()] if done.returncode == 0 else None


def main(path: Path) -> None:
    """Measure, and print a Markdown table: one row for each group and each repository."""
    rows = [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]
    found = {name: theirs(name, rows) for name in PARSERS}
    others = {name: read for name, read in found.items() if read is not None}
    counts: dict[str, list[int]] = defaultdict(lambda: [0] * (3 + len(others)))
    import_module("sympy")  # with which limits are read: loaded once, and not for one display
    longest, start = 0.0, time.perf_counter()
    results = []
    for row in rows:
        begin = time.perf_counter()
        results.append(ours(row["tex"]))
        longest = max(longest, time.perf_counter() - begin)
    spent = time.perf_counter() - start
    for k, (row, (tree, statement)) in enumerate(zip(rows, results, strict=True)):
        values = [1, tree, statement, *(read[k] for read in others.values())]
        for key in ("all", row["group"], f"{row['group']}: {row['repo']}"):
            counts[key] = [a + b for a, b in zip(counts[key], values, strict=True)]
    print(
        f"{len(rows) / spent:.0f} displays a second, the longest {1000 * longest:.0f} ms; not installed: "
        f"{', '.join(found.keys() - others.keys()) or 'none'}"
    )
    print()
    print("| " + " | ".join(("displays of", "number", "trees", "statements", *others)) + " |")
    print("|---" * (4 + len(others)) + "|")
    for key in sorted(counts, key=lambda each: (each != "all", each)):
        total, *parts = counts[key]
        print("| " + " | ".join((key, str(total), *(f"{100 * part / total:.1f} %" for part in parts))) + " |")


if __name__ == "__main__":
    sources = os.environ.get("SYMCHECK_SOURCES", "")
    file = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(sources).parent / "corpus" / "formulas.jsonl"
    if file.is_file():
        main(file)
    else:
        print(f"There are no displays at {file}; SYMCHECK_SOURCES names the folder beside them.")
