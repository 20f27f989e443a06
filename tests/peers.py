"""Other tools asked about formulas: `python tests/peers.py NAME < records.jsonl` prints an answer a line.

Of a record with `relation`, an equation of two sides, and `where` the answer is a verdict; a letter that stands on the
left of a definition is replaced by what is on its right. Of a record with `tex` it is whether it can be parsed. Needs
`sympy` with `lark`, or `latex2sympy2_extended`, or `math_verify`, and not this project.
"""

from __future__ import annotations

import json
import signal
import sys
from collections.abc import Callable
from typing import Any

LIMIT = 10  # seconds for one relation
Parse = Callable[[str], Any]


def sides(relation: str) -> tuple[str, str]:
    left, sign, right = relation.partition("=")
    if not sign or "=" in right:
        raise ValueError("not an equation of two sides")
    return left, right


def by_parsing(parse: Parse) -> Callable[[dict[str, Any]], bool | None]:
    """Both sides parsed, definitions put in, and the difference simplified; None where that decides nothing."""
    import sympy

    def decide(record: dict[str, Any]) -> bool | None:
        left, right = map(parse, sides(record["relation"]))
        for definition in reversed(record["where"]):
            name, meaning = map(parse, sides(definition))
            if isinstance(name, sympy.Symbol):
                left, right = left.subs(name, meaning), right.subs(name, meaning)
        difference = sympy.simplify(left - right)
        return True if difference == 0 else difference.equals(0)

    return decide


def sympy_lark() -> Parse:
    from sympy.parsing.latex import parse_latex

    return lambda text: parse_latex(text, backend="lark")


def sympy_antlr() -> Parse:
    from sympy.parsing.latex import parse_latex

    parse_latex("x")  # ImportError without its version of antlr
    return parse_latex


def latex2sympy() -> Parse:
    from latex2sympy2_extended import latex2sympy

    return latex2sympy


def math_verify() -> Callable[[dict[str, Any]], bool | None]:
    import math_verify

    def decide(record: dict[str, Any]) -> bool:
        left, right = (math_verify.parse(f"${side}$", parsing_timeout=None) for side in sides(record["relation"]))
        if not left or not right:
            raise ValueError("not parsed")
        return bool(math_verify.verify(left, right, timeout_seconds=None))

    return decide


PARSERS = {"SymPy (lark)": sympy_lark, "SymPy (antlr)": sympy_antlr, "latex2sympy2_extended": latex2sympy}
PEERS = (*PARSERS, "Math-Verify")


def limited(run: Callable[[], Any]) -> Any:
    """What it returns; "undecided" if it takes too long, "unreadable" if it fails."""

    def stop(*_: object) -> None:
        raise TimeoutError

    signal.signal(signal.SIGALRM, stop)
    signal.alarm(LIMIT)
    try:
        return run()
    except TimeoutError:
        return "undecided"
    except Exception:  # of any kind: what a parser does not take
        return "unreadable"
    finally:
        signal.alarm(0)


def main(name: str) -> None:
    """Answer each line."""
    parse = PARSERS[name]() if name in PARSERS else None
    decide = by_parsing(parse) if parse else math_verify()
    for record in map(json.loads, sys.stdin):
        if parse and "tex" in record:
            found = limited(lambda tex=record["tex"]: parse(tex) is not None)
            print("read" if found is True else "unreadable", flush=True)
        else:
            found = limited(lambda record=record: decide(record))
            print({True: "proved", False: "refuted", None: "undecided"}.get(found, found), flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
