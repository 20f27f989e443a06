"""What stands in the file of a sweep is what it has to be: each says by a SweepError, in words, if it is not."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from math import isfinite
from typing import Any

import numpy as np

from symcheck.numeric.sweep.functions import OF_ENSEMBLE, SweepError, Swept

FORMS = "a number, a list, {start, stop, count}, {normal = [mean, deviation]} or {uniform = [low, high]}"


def check_parameters(swept: Swept, given: Mapping[str, Any], function: str, path: str) -> None:
    """The parameters are those of the function."""
    allowed = set(swept.arguments) | swept.others
    for name in given:
        if name in OF_ENSEMBLE:
            raise SweepError(f"{path}{name} is given by the sweep: write seed and realizations above [parameters]")
        if name not in allowed:
            near = get_close_matches(name, allowed, n=1)
            hint = f"did you mean {near[0]!r}?" if near else f"it has {', '.join(sorted(allowed))}"
            raise SweepError(f"{function} has no parameter {path}{name}; {hint}")
    missing = sorted(swept.required - set(given))
    if missing:
        raise SweepError(f"{function} needs {', '.join(path + name for name in missing)}")


def require_known(table: Mapping[str, Any], allowed: set[str], where: str) -> None:
    """SweepError that names the first entry which is not allowed, and the nearest one that is."""
    unknown = [name for name in table if name not in allowed]
    if unknown:
        near = get_close_matches(unknown[0], allowed, n=1)
        hint = f"did you mean {near[0]!r}?" if near else f"known are {', '.join(sorted(allowed))}"
        raise SweepError(f"{where} has no {unknown[0]!r}; {hint}")


def number(value: Any, where: str) -> float:
    """The value; SweepError if it is no finite number."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not isfinite(value):
        raise SweepError(f"{where} = {value!r} must be a finite number, or {FORMS}")
    return value


def whole(value: Any, where: str, least: int) -> int:
    """The value; SweepError if it is no whole number from `least` on."""
    if isinstance(value, bool) or not isinstance(value, int) or value < least:
        raise SweepError(f"{where} = {value!r} must be a whole number from {least} on")
    return value


def numbers(value: list[Any], depth: int, where: str) -> Any:
    """A nested list of just this depth as an array."""
    flat: Sequence[Any] = value
    for _ in range(depth - 1):
        lengths = {len(each) if isinstance(each, list) else 0 for each in flat}
        if len(lengths) > 1 or 0 in lengths:
            raise SweepError(f"{where} must be a list of arrays of one shape")
        flat = [each for row in flat for each in row]
    for each in flat:
        number(each, where)
    return np.array(value)


def depth(value: Any) -> int:
    """How deep lists are nested, where they are least deep."""
    return 1 + min(map(depth, value), default=0) if isinstance(value, list) else 0
