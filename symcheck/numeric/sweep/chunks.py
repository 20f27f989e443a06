"""A sweep in chunks: how large they are, and which part of the sweep each of them is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import prod

import numpy as np

from symcheck.numeric.sweep.functions import SweepError
from symcheck.numeric.sweep.nodes import Axis
from symcheck.numeric.sweep.spec import Plan, Result


@dataclass(frozen=True)
class Chunks:
    """The lengths of the axes and of a chunk along each of them."""

    sizes: Mapping[str, int]
    lengths: Mapping[str, int]

    @property
    def grid(self) -> tuple[int, ...]:
        """The number of chunks along each axis."""
        return tuple(-(-size // self.lengths[name]) for name, size in self.sizes.items())

    @property
    def count(self) -> int:
        """The number of all chunks."""
        return prod(self.grid)

    def slices(self, number: int) -> dict[str, slice]:
        """The part of the sweep that a chunk is; they are counted with the last axis first."""
        places = zip(self.sizes, np.unravel_index(number, self.grid), strict=True)
        starts = {name: int(place) * self.lengths[name] for name, place in places}
        return {name: slice(at, min(at + self.lengths[name], self.sizes[name])) for name, at in starts.items()}


def chunks_of(plan: Plan, results: Mapping[str, Result], asked: Mapping[str, int], memory: float) -> Chunks:
    """Chunks of the lengths asked for, else as long as their results fit in this many bytes, the last axes first."""
    for name, length in asked.items():
        if name not in plan.axes:
            raise SweepError(f"--chunk {name}={length}: the axes of the sweep are {', '.join(plan.axes)}")
    room = memory // sum(each.dtype.itemsize * prod(each.axes.values()) for each in results.values())
    lengths: dict[str, int] = {}
    for name, axis in reversed([*plan.axes.items()]):
        lengths[name] = asked.get(name, max(1, min(axis.size, int(room))))
        room //= lengths[name]
    return Chunks(_sizes(plan.axes), {name: lengths[name] for name in plan.axes})


def _sizes(axes: Mapping[str, Axis]) -> dict[str, int]:
    return {name: axis.size for name, axis in axes.items()}
