"""Results of the numeric layer as cells show them: numbers with six digits, arrays in one line."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from symcheck.views.notebook.output import Output, Table

DIGITS = 6  # the papers print at most four
ROUNDING = 1e-12  # below it a number is rounding


def numbers(unit: str = "", **values: object) -> Output:
    """Results by name, all in one unit; underscores of names are shown as spaces."""
    head = ("", unit or "value")
    return Output((Table(head, tuple((name.replace("_", " "), _text(value)) for name, value in values.items())),))


def fields(result: NamedTuple, **units: str) -> Output:
    """The fields of a named tuple with these units, or all fields."""
    chosen = units or dict.fromkeys(result._fields, "")
    rows = tuple((name.replace("_", " "), _text(getattr(result, name)), unit) for name, unit in chosen.items())
    return Output((Table(("", "value", "unit"), rows),))


def _text(value: object) -> str:
    if isinstance(value, str):
        return value
    array = np.asarray(value)
    return f"[{', '.join(map(_text, array))}]" if array.ndim else _number(array.item())


def _number(value: complex) -> str:
    if isinstance(value, bool | int):
        return str(value)
    if isinstance(value, complex):
        return f"{_number(value.real)} {'+' if value.imag >= 0 else '-'} {_number(abs(value.imag))}i"
    return "0" if abs(value) < ROUNDING else f"{value:.{DIGITS}g}"
