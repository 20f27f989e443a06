"""A tree as a fully bracketed expression: every node by its name, with all that it is made of."""

from __future__ import annotations

from dataclasses import fields

from symcheck.reading import Tree, to_latex
from symcheck.reading.tree import Name, Number


def bracketed(value: object) -> str:
    """The expression; names and numbers are printed as they are."""
    if isinstance(value, Number):
        return value.text
    if isinstance(value, Name):
        return to_latex(value)
    if isinstance(value, Tree):
        parts = [getattr(value, field.name) for field in fields(value)]  # type: ignore[arg-type]
        shown = "; ".join(bracketed(part) for part in parts if part not in ((), None, False))
        return f"{type(value).__name__}({shown})"
    return ", ".join(map(bracketed, value)) if isinstance(value, tuple) else str(value)
