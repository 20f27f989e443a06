"""A sweep as it is read: its axes, and its results in any part of it.

A parameter is read as a function of the part. It gives a number or an array that is the same everywhere, or a DataArray
whose dimensions are axes of the sweep, and then its own; xarray broadcasts these by name. Random numbers depend on the
seed and on places in the whole sweep, never on the part in which they are asked for.
"""

from __future__ import annotations

import json
import tomllib
from collections.abc import Callable, Collection, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
import xarray
from numpy.typing import ArrayLike, NDArray

from symcheck.numeric.domain import Array, number, whole
from symcheck.numeric.sweep.functions import OF_ENSEMBLE, REALIZATION, SweepError, Swept, find, nearest

Part = Mapping[str, slice]
Node = Callable[[Part], object]
Axes = tuple[str, ...]
Attributes = Mapping[str, str]
Coordinate = tuple[Axes, NDArray[np.generic], Attributes]

TOP = {"function", "parameters", "failures", "seed", "realizations"}
FORMS = "a number, a list, {start, stop, count}, {normal = [mean, deviation]} or {uniform = [low, high]}"
SCALES: dict[str, Callable[[float, float, int], Array]] = {"linear": np.linspace, "log": np.geomspace}
DISTRIBUTIONS = {"normal": ("mean", "deviation"), "uniform": ("low", "high")}
LONGEST = 10**8  # points of an axis: its coordinates are in memory, and written, as a whole
DRAWS = 4096  # random numbers that share a generator


class Plan(NamedTuple):
    """A sweep: the function, the lengths of its axes in order, their coordinates, and what comes out of it."""

    function: str
    sizes: dict[str, int]
    coordinates: dict[str, Coordinate]
    swept: Swept
    root: Node

    def compute(self, part: Part) -> dict[str, xarray.DataArray]:
        """All results in a part of the sweep, each with all its axes and then its own."""
        with np.errstate(all="ignore"):  # values that are not finite are counted in the summary
            values = self.root(part)
        arrays = values if isinstance(values, tuple) else (values,)
        described = zip(self.swept.names or (), self.swept.outputs, arrays, strict=True)
        return {self._free(name): self._laid_out(array, core, part) for name, core, array in described}

    def first(self) -> dict[str, xarray.DataArray]:
        """The results at the first point, which have the names, types and own axes of all."""
        return self.compute({axis: slice(0, 1) for axis in self.sizes})

    def _laid_out(self, array: xarray.DataArray, core: Axes, part: Part) -> xarray.DataArray:
        own = zip(array.dims[array.ndim - len(core) :], core, strict=True)
        array = array.rename({old: new if new == REALIZATION else self._free(new) for old, new in own})
        missing = {axis: where.stop - where.start for axis, where in part.items() if axis not in array.dims}
        return array.expand_dims(missing).transpose(*part, ...)

    def _free(self, name: str) -> str:
        """The name, with an underscore if an axis of the sweep has it."""
        return name if name not in self.sizes else f"{name}_"


def read(path: Path) -> str:
    """The sweep in a TOML file as canonical JSON; SweepError if it is not one."""
    try:
        return json.dumps(tomllib.loads(path.read_text(encoding="utf-8")), ensure_ascii=False)
    except OSError as error:
        raise SweepError(f"{path} cannot be read: {error.strerror}") from None
    except (ValueError, TypeError) as error:
        raise SweepError(f"{path} is not a sweep in TOML: {error}") from None


def plan(text: str) -> Plan:
    """The sweep that this JSON describes; SweepError names what does not fit."""
    spec = json.loads(text)
    _require_known(spec, TOP, "the sweep")
    if not isinstance(spec.get("function"), str) or not isinstance(spec.get("parameters"), dict):
        raise SweepError('a sweep has function = "..." and a table [parameters]')
    table = {"function": spec["function"], **spec["parameters"]}
    try:
        return _Reader(spec).plan(table | {"failures": spec["failures"]} if "failures" in spec else table)
    except SweepError:
        raise
    except ValueError as error:  # a number that does not fit
        raise SweepError(str(error)) from None


class _Reader:
    """Collects the axes while the parameters are read."""

    def __init__(self, spec: Mapping[str, object]) -> None:
        self.sizes: dict[str, int] = {}
        self.coordinates: dict[str, Coordinate] = {}
        self.random_numbers = 0
        self.count = whole("realizations", spec["realizations"], 1, LONGEST) if "realizations" in spec else 0
        self.seed = whole("seed", spec["seed"], 0) if "seed" in spec else 0
        if ("seed" in spec) != ("realizations" in spec):
            raise SweepError("an ensemble has both a seed and a number of realizations")

    def plan(self, table: Mapping[str, object]) -> Plan:
        swept, root = self.call(table, "")
        if swept.names is None:
            name = table["function"]
            raise SweepError(f"function = {name!r} gives no numbers; use it for a parameter of another function")
        if self.count and not self.random_numbers:
            raise SweepError("realizations are asked for, but nothing is random: no seeded function, no distribution")
        if self.count:
            self._index(REALIZATION, self.count)
        if not self.sizes:
            raise SweepError("nothing varies: give a parameter a list or {start, stop, count}")
        return Plan(str(table["function"]), self.sizes, self.coordinates, swept, root)

    def call(self, table: Mapping[str, object], path: str) -> tuple[Swept, Node]:
        """A function of its parameters."""
        function = table["function"]
        if not isinstance(function, str):
            raise SweepError(f"{path}function = {function!r} must be a name")
        swept = find(function)
        given = {name: value for name, value in table.items() if name not in ("function", "failures")}
        _check_parameters(swept, given, function, path)
        source = self._random() if swept.is_ensemble else 0
        nodes = {name: self.argument(swept, name, value, path) for name, value in given.items()}
        if "failures" in table:
            nodes |= self.failing(swept, nodes, table["failures"], path)

        def value(part: Part) -> object:
            values = {name: node(part) for name, node in nodes.items()}
            if swept.elementwise:
                return swept.call(**values)
            return _point_by_point(swept, values, part, (self.seed, source))

        return swept, value

    def argument(self, swept: Swept, name: str, value: object, path: str) -> Node:
        if name in swept.others:
            return lambda part: value
        if isinstance(value, dict) and "function" in value:
            return self.call(value, f"{path}{name}.")[1]
        core = swept.arguments[name]
        if core is None or REALIZATION in core:
            raise SweepError(f'{path}{name} must be the result of a function: {{ function = "...", ... }}')
        own = tuple(f"{path}{name}_axis_{k}" for k in range(1, len(core) + 1))
        return self.value(value, own, f"{path}{name}", name, swept.attributes.get(name, {}))

    def value(self, value: object, own: Axes, where: str, name: str, attributes: Attributes) -> Node:
        """A number, list, range or distribution, with its own axes."""
        if isinstance(value, dict):
            return self.described(value, own, where, name, attributes)
        if not isinstance(value, list):
            number(where, value, f", or {FORMS}")
            return lambda part: value
        if not value:
            raise SweepError(f"{where} is an empty list")
        if not own or _depth(value) > len(own):
            return self.along(_numbers(value, len(own) + 1, where), own, where, name, attributes)
        parts = [
            self.value(item, own[1:], f"{where}[{k}]", f"{name}_{k}", attributes) for k, item in enumerate(value, 1)
        ]
        return lambda part: xarray.apply_ufunc(
            lambda *arrays: np.stack(np.broadcast_arrays(*arrays), axis=-len(own)),
            *(node(part) for node in parts),
            input_core_dims=[own[1:]] * len(parts),
            output_core_dims=[own],
        )

    def described(self, value: Mapping[str, object], own: Axes, where: str, name: str, attributes: Attributes) -> Node:
        """A range or a distribution."""
        if own:
            raise SweepError(f"{where} has components: give a list of them, each of which may be {FORMS}")
        for distribution, names in DISTRIBUTIONS.items():
            if set(value) == {distribution}:
                return self.drawn(distribution, value[distribution], names, where)
        _require_known(value, {"start", "stop", "count", "scale"}, where)
        if not {"start", "stop", "count"} <= set(value):
            raise SweepError(f"{where} = {value} must be {FORMS}")
        start, stop = (number(f"{where}.{end}", value[end], f", or {FORMS}") for end in ("start", "stop"))
        count, scale = whole(f"{where}.count", value["count"], 1, LONGEST), value.get("scale", "linear")
        if scale not in SCALES:
            raise SweepError(f'{where}.scale = {scale!r} must be "linear" or "log"')
        if scale == "log" and start * stop <= 0:
            raise SweepError(f"{where} has a logarithmic scale: start and stop must have the same sign and not be 0")
        return self.along(SCALES[str(scale)](start, stop, count), (), where, name, attributes)

    def drawn(self, distribution: str, given: object, names: tuple[str, str], where: str) -> Node:
        """Independent random numbers, one for each realization."""
        if not isinstance(given, list) or len(given) != 2:
            raise SweepError(f"{where}.{distribution} must be [{', '.join(names)}]")
        first, second = (number(f"{where}.{name}", item) for item, name in zip(given, names, strict=True))
        if second < (0 if distribution == "normal" else first):
            raise SweepError(f"{where}.{distribution} = {given} is not a distribution: {names[1]} is too small")
        source = self._random()

        def block(number: int) -> Array:
            sequence = np.random.SeedSequence(self.seed, spawn_key=(source, number))
            draw = getattr(np.random.Generator(np.random.PCG64(sequence)), distribution)
            return np.asarray(draw(first, second, size=DRAWS))

        def value(part: Part) -> xarray.DataArray:
            start, stop = part[REALIZATION].start, part[REALIZATION].stop
            blocks = range(start // DRAWS, -(-stop // DRAWS))
            draws = np.concatenate([block(number) for number in blocks])
            return xarray.DataArray(draws[start - blocks[0] * DRAWS :][: stop - start], dims=REALIZATION)

        return value

    def along(self, values: NDArray[np.generic], own: Axes, where: str, name: str, attributes: Attributes) -> Node:
        """Values along an axis of the sweep that they bring with them."""
        axis = name if name not in self.sizes and name != REALIZATION else where
        if axis in self.sizes:
            raise SweepError(f"{where} is named twice")
        if own:
            self._index(axis, len(values))
            self.coordinates[f"{axis}_values"] = (
                (axis, *(f"{axis}_axis_{k}" for k in range(1, values.ndim))),
                values,
                {},
            )
        else:
            self.sizes[axis], self.coordinates[axis] = len(values), ((axis,), values, attributes)
        array = xarray.DataArray(values, dims=(axis, *own))
        return lambda part: array.isel({axis: part[axis]})

    def failing(self, swept: Swept, nodes: Mapping[str, Node], cases: object, path: str) -> dict[str, Node]:
        """Limits and biases of wheels, 0 for those that have failed, along the axis of failures."""
        if not {"axes", "limits"} <= set(swept.arguments):
            raise SweepError(f"{path}failures needs a function with axes and limits of wheels")
        if not isinstance(cases, list) or not cases or not all(isinstance(case, list) for case in cases):
            raise SweepError(f"{path}failures must be a list of lists of wheels, as [[], [0], [0, 2]]")
        failed = [[whole(f"{path}failures", wheel, 0) for wheel in case] for case in cases]
        last = max((wheel for case in failed for wheel in case), default=0)
        axis = "failure" if "failure" not in self.sizes else f"{path}failure"
        self._index(axis, len(failed))
        self.coordinates[f"{axis}_wheels"] = (axis, "failed_wheel"), _failed(failed, last + 1), {}

        def left(intact: Node) -> Node:
            def value(part: Part) -> xarray.DataArray:
                count, whole_set = getattr(nodes["axes"](part), "shape")[-2], intact(part)  # noqa: B009
                if last >= count:
                    raise SweepError(f"failures names wheel {last}; the wheels are counted from 0 to {count - 1}")
                wheel = whole_set.dims[-1] if isinstance(whole_set, xarray.DataArray) else f"{axis}_axis_1"
                works = xarray.DataArray(~_failed(failed, count)[part[axis]], dims=(axis, wheel))
                return (works * whole_set).transpose(..., wheel)

            return value

        intact = {"limits": nodes.get("limits", lambda part: 1.0)} | {n: nodes[n] for n in ("bias",) if n in nodes}
        return {name: left(node) for name, node in intact.items()}

    def _index(self, axis: str, size: int) -> None:
        """An axis whose places are numbered from 0."""
        self.sizes[axis], self.coordinates[axis] = size, ((axis,), np.arange(size), {})

    def _random(self) -> int:
        if not self.count:
            raise SweepError("what is random needs a seed and a number of realizations")
        self.random_numbers += 1
        return self.random_numbers


def _point_by_point(swept: Swept, values: Mapping[str, object], part: Part, random: tuple[int, int]) -> object:
    """A function called separately for each set of arguments, and for all realizations of an ensemble together."""
    cores = {name: core or () for name, core in swept.arguments.items() if name in values}
    fixed = {name: value for name, value in values.items() if name not in cores}
    places: list[xarray.DataArray] = []
    if swept.is_ensemble:  # each point has its own noises
        for name, core in cores.items():
            if REALIZATION in getattr(values[name], "dims", ()) and REALIZATION not in core:
                raise SweepError(f"{name} must not differ between realizations: all of them have it in common")
        others = {axis: where for axis, where in part.items() if axis != REALIZATION}
        places = [xarray.DataArray(np.arange(where.start, where.stop), dims=axis) for axis, where in others.items()]
        first, stop = part[REALIZATION].start, part[REALIZATION].stop
        fixed |= {name: value for name, value in (("first", first), ("paths", stop - first)) if name in swept.others}

    def at_a_point(*arguments: ArrayLike) -> object:
        given = {**fixed, **dict(zip(cores, arguments, strict=False))}
        if swept.is_ensemble:
            place = np.asarray(arguments[len(cores) :], int).tolist()
            words = np.random.SeedSequence(random[0], spawn_key=(random[1], *place)).generate_state(4)
            given["seed"] = int.from_bytes(words.tobytes(), "little")
        return swept.call(**given)

    dims = [getattr(values[name], "dims", core)[-len(core) :] if core else () for name, core in cores.items()]
    return xarray.apply_ufunc(
        at_a_point,
        *(values[name] for name in cores),
        *places,
        input_core_dims=[*dims, *(() for _ in places)],
        output_core_dims=swept.outputs,
        vectorize=True,
        output_dtypes=None if swept.names else [object],
    )


def _check_parameters(swept: Swept, given: Collection[str], function: str, path: str) -> None:
    """The parameters are those of the function."""
    allowed = {*swept.arguments, *swept.others} - OF_ENSEMBLE
    for name in given:
        if name in OF_ENSEMBLE & swept.others:
            raise SweepError(f"{path}{name} is given by the sweep: write seed and realizations above [parameters]")
        if name not in allowed:
            hint = nearest(name, allowed, f"it has {', '.join(sorted(allowed))}")
            raise SweepError(f"{function} has no parameter {path}{name}; {hint}")
    if missing := sorted(swept.required - OF_ENSEMBLE - set(given)):
        raise SweepError(f"{function} needs {', '.join(path + name for name in missing)}")


def _require_known(table: Collection[str], allowed: Collection[str], where: str) -> None:
    for name in table:
        if name not in allowed:
            hint = nearest(name, allowed, f"known are {', '.join(sorted(allowed))}")
            raise SweepError(f"{where} has no {name!r}; {hint}")


def _numbers(value: Sequence[object], depth: int, where: str) -> NDArray[np.generic]:
    """A nested list of just this depth as an array."""
    flat = value
    for _ in range(depth - 1):
        lengths = {len(item) if isinstance(item, list) else 0 for item in flat}
        if len(lengths) > 1 or 0 in lengths:
            raise SweepError(f"{where} must be a list of arrays of one shape")
        flat = [item for row in flat if isinstance(row, list) for item in row]
    for item in flat:
        number(where, item, f", or {FORMS}")
    return np.array(value)


def _depth(value: object) -> int:
    """How deep lists are nested, where they are least deep."""
    return 1 + min(map(_depth, value), default=0) if isinstance(value, list) else 0


def _failed(cases: Sequence[Sequence[int]], count: int) -> NDArray[np.bool_]:
    """Which of so many wheels have failed, shape (cases, wheels)."""
    return np.array([[wheel in case for wheel in range(count)] for case in cases])
