"""What the parameters of a sweep are made of, and the values that they and the functions of them have in a chunk.

A value has the axes of the sweep first, each of its length in the chunk or of the length 1, and then its own axes.
Random numbers depend on the seed and on places in the whole sweep, never on the chunk in which they are asked for.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol

import numpy as np

from symcheck.numeric.domain import Array
from symcheck.numeric.sweep.functions import REALIZATION, SweepError, Swept

DRAWS = 4096  # random numbers that share a generator


class Axis(NamedTuple):
    """An axis of a sweep: its coordinates along it, and further arrays that begin with it."""

    size: int
    coordinates: Any
    attributes: Mapping[str, str]
    further: Mapping[str, tuple[tuple[str, ...], Any]]


@dataclass(frozen=True)
class Chunk:
    """A part of the sweep: a slice of each axis, in order, and the seed of the whole."""

    slices: Mapping[str, slice]
    seed: int

    @property
    def shape(self) -> tuple[int, ...]:
        """The number of points along each axis."""
        return tuple(each.stop - each.start for each in self.slices.values())

    def along(self, axis: str, values: Any) -> Any:
        """Values along one axis of the sweep, with their own axes after it."""
        shape = [values.shape[0] if name == axis else 1 for name in self.slices]
        return values.reshape(*shape, *values.shape[1:])

    def led(self, value: Any, core: int) -> Any:
        """The value with all axes of the sweep, those that it lacks of the length 1."""
        array = np.asarray(value)
        return array.reshape((1,) * (len(self.slices) + core - array.ndim) + array.shape)


class Node(Protocol):
    """Something that has a value in each chunk."""

    def value(self, chunk: Chunk) -> Any:
        """The value there."""


@dataclass(frozen=True)
class Fixed:
    """The same value everywhere."""

    constant: Any

    def value(self, chunk: Chunk) -> Any:
        """The value there."""
        return self.constant


@dataclass(frozen=True)
class Along:
    """Values along an axis of the sweep."""

    axis: str
    values: Any

    def value(self, chunk: Chunk) -> Any:
        """The value there."""
        return chunk.along(self.axis, self.values[chunk.slices[self.axis]])


@dataclass(frozen=True)
class Stacked:
    """Components, each with axes of its own, as one array."""

    parts: Sequence[Node]
    core: int

    def value(self, chunk: Chunk) -> Any:
        """The value there."""
        parts = np.broadcast_arrays(*(chunk.led(part.value(chunk), self.core) for part in self.parts))
        return np.stack(parts, axis=-1 - self.core)


@dataclass(frozen=True)
class Drawn:
    """Independent random numbers, one for each realization."""

    distribution: str
    arguments: tuple[float, ...]
    number: int

    def value(self, chunk: Chunk) -> Any:
        """The value there."""
        where = chunk.slices[REALIZATION]
        first, last = where.start // DRAWS, -(-where.stop // DRAWS)
        draws = np.concatenate([self._block(chunk.seed, k) for k in range(first, last)])
        return chunk.along(REALIZATION, draws[where.start - first * DRAWS :][: where.stop - where.start])

    def _block(self, seed: int, block: int) -> Array:
        generator = np.random.Generator(np.random.PCG64(np.random.SeedSequence(seed, spawn_key=(self.number, block))))
        found: Array = getattr(generator, self.distribution)(*self.arguments, size=DRAWS)
        return found


@dataclass(frozen=True)
class Failing:
    """Limits or biases of wheels, 0 for those that have failed."""

    intact: Node
    axis: str
    failed: Sequence[Sequence[int]]
    axes: Node

    def value(self, chunk: Chunk) -> Any:
        """The value there."""
        count = np.shape(self.axes.value(chunk))[-2]
        wrong = [wheel for case in self.failed for wheel in case if wheel >= count]
        if wrong:
            raise SweepError(f"failures names wheel {wrong[0]}; the wheels are counted from 0 to {count - 1}")
        works = ~failed_wheels(self.failed, count)[chunk.slices[self.axis]]
        return chunk.along(self.axis, works) * self.intact.value(chunk)


def failed_wheels(failed: Sequence[Sequence[int]], count: int) -> Any:
    """Which of so many wheels have failed, shape (cases, wheels)."""
    return np.array([[wheel in case for wheel in range(count)] for case in failed])


@dataclass(frozen=True)
class Call:
    """A function of other nodes."""

    swept: Swept
    arguments: Mapping[str, Node]
    number: int

    def value(self, chunk: Chunk) -> Any:
        """The value there."""
        values = {name: node.value(chunk) for name, node in self.arguments.items()}
        return self.swept.call(**values) if self.swept.elementwise else self._point_by_point(chunk, values)

    def _point_by_point(self, chunk: Chunk, values: Mapping[str, Any]) -> Any:
        """Each set of arguments by itself; the realizations of an ensemble are asked for together."""
        cores = {name: own_axes(core) for name, core in self.swept.arguments.items() if name in values}
        arrays = {name: chunk.led(values[name], len(core)) for name, core in cores.items()}
        lead = np.broadcast_shapes(*(array.shape[: len(chunk.slices)] for array in arrays.values()))
        shape = (*chunk.shape[:-1], 1) if self.swept.is_ensemble else lead  # each point has noises of its own
        found = []
        for index in np.ndindex(shape):
            given = {name: self._at(name, array, index) for name, array in arrays.items()}
            found.append(self.swept.call(**{**values, **given, **self._of_ensemble(chunk, index)}))
        return self._joined(found, shape) if self.swept.names else _objects(found, shape)

    def _at(self, name: str, array: Any, index: tuple[int, ...]) -> Any:
        """The argument at one point: all realizations where it has some."""
        place: list[Any] = [k if size > 1 else 0 for k, size in zip(index, array.shape, strict=False)]
        if REALIZATION in (self.swept.arguments[name] or ()):
            place[-1] = slice(None)
        elif self.swept.is_ensemble and array.shape[len(index) - 1] > 1:
            raise SweepError(f"{name} must not differ between realizations: all of them have it in common")
        return array[tuple(place)]

    def _of_ensemble(self, chunk: Chunk, index: tuple[int, ...]) -> dict[str, int]:
        if not self.swept.is_ensemble:
            return {}
        *others, realizations = chunk.slices.values()
        place = (k + each.start for k, each in zip(index, others, strict=False))
        words = np.random.SeedSequence(chunk.seed, spawn_key=(self.number, *place)).generate_state(4)
        given = {
            "seed": int.from_bytes(words.tobytes(), "little"),
            "first": realizations.start,
            "paths": realizations.stop - realizations.start,
        }
        return {name: value for name, value in given.items() if name in self.swept.of_ensemble}

    def _joined(self, found: Sequence[Any], shape: tuple[int, ...]) -> Any:
        """The results of all points as arrays, with the axis of realizations among those of the sweep."""
        several = isinstance(found[0], tuple)
        columns = zip(*found, strict=True) if several else [found]
        stacks = [np.stack(column) for column in columns]
        arrays = [
            _led(stack.reshape(*shape, *stack.shape[1:]), core, len(shape))
            for stack, core in zip(stacks, self.swept.outputs, strict=True)
        ]
        return type(found[0])(*arrays) if several else arrays[0]


def _objects(found: Sequence[Any], shape: tuple[int, ...]) -> Any:
    array = np.empty(len(found), object)
    array[:] = found
    return array.reshape(shape)


def _led(array: Any, core: Sequence[str], lead: int) -> Any:
    """The axis of realizations in the place that is kept for it, the last of the sweep's axes."""
    if REALIZATION not in core:
        return array
    return np.moveaxis(array.squeeze(axis=lead - 1), lead - 1 + core.index(REALIZATION), lead - 1)


def own_axes(core: Sequence[str] | None) -> list[str]:
    """The last axes of a value in a sweep, where realizations are an axis of the sweep."""
    return [axis for axis in core or () if axis != REALIZATION]
