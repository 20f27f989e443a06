"""The vocabulary of a ledger: claim, definition, premise, exclusion, ours."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

from symcheck.core.claims import Item
from symcheck.core.verdicts import Role


def _item(role: Role, number: str, line: int, printed: str | Sequence[str], fields: dict[str, Any]) -> Item:
    pieces = (printed,) if isinstance(printed, str) else tuple(printed)
    for name in ("given", "needs", "equality_given", "uses", "lemmas", "free"):
        if name in fields:
            fields[name] = tuple(fields[name])
    return Item(number=number, role=role, line=line, printed=tuple(p for p in pieces if p), **fields)


def claim(number: str, line: int, printed: str | Sequence[str] = (), **fields: Any) -> Item:
    """A relation the paper asserts."""
    return _item(Role.CLAIM, number, line, printed, fields)


def definition(number: str, line: int, printed: str | Sequence[str] = (), **fields: Any) -> Item:
    """What a letter means; unfolded in every claim that contains the letter."""
    return _item(Role.DEFINITION, number, line, printed, fields)


def premise(number: str, line: int, printed: str | Sequence[str] = (), **fields: Any) -> Item:
    """What the paper assumes, chooses or cites."""
    return _item(Role.PREMISE, number, line, printed, fields)


def exclusion(number: str, line: int, printed: str | Sequence[str] = (), *, reason: str, **fields: Any) -> Item:
    """Something printed that asserts nothing decidable, with the reason."""
    return _item(Role.EXCLUSION, number, line, printed, {**fields, "reason": reason})


def ours(number: str, line: int, **fields: Any) -> Item:
    """A statement the paper does not print; `line` is the place it belongs to."""
    return _item(Role.OURS, number, line, (), fields)


def body(*items: Item | str) -> str:
    """The printed relations of several items as one conjunction, for a statement that refers to them.

    Numbered cases, printed `1). ...; 2). ...`, become a disjunction.
    """
    return r" \land ".join(_body(item if isinstance(item, str) else " ".join(item.printed)) for item in items)


def _body(latex: str) -> str:
    text = re.sub(r"\\(begin|end)\{(aligned|array|split)\}", "", latex)
    cases = re.split(r"\b\d+\)\.", text)
    parts = cases[1:] if len(cases) > 1 else cases
    layout = re.compile(r"^(\s|&|\\quad|\\\\)+|(\s|[.,;&]|\\quad|\\\\)+$")
    return "(" + r") \lor (".join(layout.sub("", part) for part in parts) + ")"
