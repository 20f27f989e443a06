"""The reader on displays of public repositories, beside SymPy's parsers and latex2sympy2_extended where they import.

python tests/bench_corpus.py formulas.jsonl

A tree of ours is a reading with inferred letters, a statement one that lowers to formulas; of another parser it is a
result without an error. Nothing is said here of how many are right. The formulas are those of the file, one JSON object
a line with `repo`, `group` and `tex`.
"""

from __future__ import annotations

import json
import sys
import time
from collections import defaultdict
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

from symcheck.core.verdicts import SymcheckError
from symcheck.reading import lower, read
from symcheck.reading.inference import inferred
from symcheck.reading.surface import plain, with_plain_differentials

MOST_READINGS = 4  # of one display; the first of them is right where any is
Parser = Callable[[str], object]


def ours(latex: str) -> tuple[bool, bool]:
    """Whether a display gives a tree, and whether it gives a statement."""
    text, tree = with_plain_differentials(plain(latex)), False
    try:
        inferences = inferred([text], {}, {})[:MOST_READINGS]
    except SymcheckError:
        return False, False
    for inference in inferences:
        try:
            found = read(text, inference.notation)
            tree = True
            lower(found, inference.notation)
        except SymcheckError:
            continue
        return True, True
    return tree, False


def parsers() -> Iterator[tuple[str, Parser]]:
    """The other parsers that can be imported and read `x`."""
    found: list[tuple[str, Parser]] = []
    try:
        from sympy.parsing.latex import parse_latex

        found += [(f"SymPy {backend}", partial(parse_latex, backend=backend)) for backend in ("lark", "antlr")]
    except ImportError:
        pass
    try:
        from latex2sympy2_extended import latex2sympy

        found.append(("latex2sympy2_extended", latex2sympy))
    except ImportError:
        pass
    for name, parser in found:
        if reads(parser, "x"):
            yield name, parser


def reads(parser: Parser, latex: str) -> bool:
    """Whether another parser gives a result; what it raises is of many kinds."""
    try:
        return parser(latex) is not None
    except Exception:
        return False


def main(path: str) -> None:
    """Measure, and print a Markdown table: one row for each group and each repository."""
    rows = [json.loads(line) for line in Path(path).read_text(encoding="utf-8").splitlines()]
    others = dict(parsers())
    counts: dict[str, list[int]] = defaultdict(lambda: [0] * (3 + len(others)))
    longest, start = 0.0, time.perf_counter()
    results = []
    for row in rows:
        begin = time.perf_counter()
        results.append(ours(row["tex"]))
        longest = max(longest, time.perf_counter() - begin)
    spent = time.perf_counter() - start
    for row, (tree, statement) in zip(rows, results, strict=True):
        found = [1, tree, statement, *(reads(parser, row["tex"]) for parser in others.values())]
        for key in ("all", row["group"], f"{row['group']}: {row['repo']}"):
            counts[key] = [a + b for a, b in zip(counts[key], found, strict=True)]
    print(f"{len(rows) / spent:.0f} displays a second, the longest {1000 * longest:.0f} ms")
    print()
    print("| " + " | ".join(("displays of", "number", "trees", "statements", *others)) + " |")
    print("|---" * (4 + len(others)) + "|")
    for key in sorted(counts, key=lambda each: (each != "all", each)):
        total, *parts = counts[key]
        print("| " + " | ".join((key, str(total), *(f"{100 * part / total:.1f} %" for part in parts))) + " |")


if __name__ == "__main__":
    main(sys.argv[1])
