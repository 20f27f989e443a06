"""Reads a sweep: which function, and what each of its parameters is."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from symcheck.numeric.sweep.checks import require_known
from symcheck.numeric.sweep.functions import REALIZATION, SweepError
from symcheck.numeric.sweep.nodes import Axis, Call, Chunk, own_axes
from symcheck.numeric.sweep.reader import Reader

TOP = {"function", "parameters", "failures", "seed", "realizations"}


class Result(NamedTuple):
    """One result: its own axes with their lengths, its type, and what is known of it."""

    axes: Mapping[str, int]
    dtype: Any
    attributes: Mapping[str, str]


class Plan(NamedTuple):
    """A sweep: its axes in order, the function, and what comes out of it."""

    function: str
    axes: Mapping[str, Axis]
    root: Call
    seed: int

    def compute(self, slices: Mapping[str, slice]) -> dict[str, Any]:
        """All results in a part of the sweep, each with all its axes and then its own."""
        chunk = Chunk(slices, self.seed)
        with np.errstate(all="ignore"):  # what is not finite is counted and told
            found = self.root.value(chunk)
        swept, arrays = self.root.swept, {}
        for name, core, each in zip(swept.names or (), swept.outputs, _several(found), strict=True):
            led = chunk.led(each, len(own_axes(core)))
            shape = (*chunk.shape, *led.shape[len(chunk.shape) :])
            arrays[_free(name, self.axes)] = np.ascontiguousarray(np.broadcast_to(led, shape))
        return arrays

    def results(self) -> dict[str, Result]:
        """What comes out, found out at the first point."""
        first = self.compute({name: slice(0, 1) for name in self.axes})
        described = {}
        for (name, array), plain, core in zip(
            first.items(), self.root.swept.names or (), self.root.swept.outputs, strict=True
        ):
            own = (_free(axis, self.axes) for axis in own_axes(core))
            lengths = dict(zip(own, array.shape[len(self.axes) :], strict=True))
            described[name] = Result(lengths, array.dtype, self.root.swept.attributes.get(plain, {}))
        return described


def read(path: Path) -> str:
    """The sweep in a TOML file as canonical JSON; SweepError if it is none."""
    try:
        spec = tomllib.loads(path.read_text(encoding="utf-8"))
        text = json.dumps(spec, ensure_ascii=False)
    except OSError as error:
        raise SweepError(f"{path} cannot be read: {error.strerror}") from None
    except (ValueError, TypeError) as error:
        raise SweepError(f"{path} is no sweep in TOML: {error}") from None
    return text


def plan(text: str) -> Plan:
    """The sweep that is told by this JSON; SweepError names what does not fit."""
    spec = json.loads(text)
    require_known(spec, TOP, "the sweep")
    if not isinstance(spec.get("function"), str) or not isinstance(spec.get("parameters"), dict):
        raise SweepError('a sweep has function = "..." and a table [parameters]')
    reader = Reader(spec)
    table = {"function": spec["function"], **spec["parameters"]}
    root = reader.call(table | {"failures": spec["failures"]} if "failures" in spec else table, "")
    if root.swept.names is None:
        raise SweepError(
            f"function = {spec['function']!r} gives no numbers; use it for a parameter of another function"
        )
    axes = {**{n: a for n, a in reader.axes.items() if n != REALIZATION}, **reader.realizations()}
    if not axes:
        raise SweepError("nothing varies: give a parameter a list or {start, stop, count}")
    return Plan(spec["function"], axes, root, reader.seed)


def _free(name: str, taken: Mapping[str, Any]) -> str:
    """The name, or one beside it that is no axis of the sweep."""
    return name if name not in taken else f"{name}_"


def _several(found: Any) -> tuple[Any, ...]:
    return tuple(found) if isinstance(found, tuple) else (found,)
