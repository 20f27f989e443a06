"""Terms and formulas in one line of plain text."""

from __future__ import annotations

import json
from collections.abc import Sequence

_INFIX = {"*": "*", "/": "/", "^": "^", "and": " and ", "or": " or ", "=>": " ⟹ ", "<=>": " ⟺ "}
_RELATIONS = {"=": "=", "!=": "≠", "<": "<", "<=": "≤", ">": ">", ">=": "≥"}
_PRECEDENCE = {"<=>": 0, "=>": 1, "or": 2, "and": 3, "exists": 4, "+": 6, "*": 7, "/": 8, "^": 9}
_ALONE = {"+": 0, "*": 1, "and": "true", "or": "false"}


def term(value: object) -> str:
    """A term or formula (`symcheck.core.terms`), or a truth value, in one line; JSON lists are as good as nodes."""
    return _written(value, 0)


def _written(value: object, outer: int) -> str:
    if isinstance(value, str) or type(value) is int:
        return str(value)
    if not isinstance(value, list | tuple) or not value:
        return json.dumps(value)
    head, *parts = value
    if not parts:
        return str(_ALONE.get(head, head))
    if head == "/" and (decimal := _decimal(*parts)):
        return _wrapped(decimal, 6 if decimal[0] == "-" else 9, outer)
    if head in _RELATIONS:
        return f"{_written(parts[0], 5)} {_RELATIONS[head]} {_written(parts[1], 5)}"
    if head == "exists":
        return f"there are {', '.join(parts[0])} with {_written(parts[1], 4)}"
    if head == "forall":
        return _wrapped(f"for all {', '.join(parts[0])}: {_written(parts[1], 0)}", 0, outer)
    if head == "call":
        return _called(*parts)
    if head == "diff" and parts[3] == parts[1]:
        parts = parts[:3]
    if head == "-":
        return _wrapped("-" + _written(parts[0], 7), 6, outer)
    if head not in _PRECEDENCE:
        return f"{head}({', '.join(_written(part, 0) for part in parts)})"
    level = _PRECEDENCE[head]
    if head == "+":
        return _wrapped(_written(parts[0], level) + "".join(_addend(part) for part in parts[1:]), level, outer)
    text = _INFIX[head].join(_written(part, level + (head in ("/", "^") or n > 0)) for n, part in enumerate(parts))
    return _wrapped(text, level, outer)


def _called(name: str, orders: Sequence[int], *arguments: object) -> str:
    """An unknown function; a derivative of it with the order of each argument."""
    return f"{name}{list(orders) if any(orders) else ''}({', '.join(map(term, arguments))})"


def _decimal(top: object, bottom: object) -> str:
    """A fraction with a high power of ten below as a decimal, or the empty text."""
    digits = len(str(bottom)) - 1
    if not isinstance(top, int) or bottom != 10**digits or digits < 6:
        return ""
    whole = str(abs(top)).zfill(digits + 1)
    return f"{'-' * (top < 0)}{whole[:-digits]}.{whole[-digits:]}"


def _addend(value: object) -> str:
    if isinstance(value, list | tuple) and value[0] == "-":
        return f" - {_written(value[1], 7)}"
    return f" + {_written(value, 7)}"


def _wrapped(text: str, level: int, outer: int) -> str:
    return f"({text})" if level < outer else text
