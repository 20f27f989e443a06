"""Reads the parameters of a sweep: what each of them is, and the axes that they bring with them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from symcheck.numeric.sweep.checks import FORMS, check_parameters, depth, number, numbers, require_known, whole
from symcheck.numeric.sweep.functions import REALIZATION, SweepError, Swept, find
from symcheck.numeric.sweep.nodes import Along, Axis, Call, Drawn, Failing, Fixed, Node, Stacked, failed_wheels

SCALES: dict[str, Any] = {"linear": np.linspace, "log": np.geomspace}
DISTRIBUTIONS = {"normal": ("mean", "deviation"), "uniform": ("low", "high")}


class Reader:
    """Collects the axes while the parameters are read."""

    def __init__(self, spec: Mapping[str, Any]) -> None:
        self.axes: dict[str, Axis] = {}
        self.random_numbers = 0
        self.is_random = False
        self.count = whole(spec["realizations"], "realizations", 1) if "realizations" in spec else 0
        self.seed = whole(spec["seed"], "seed", 0) if "seed" in spec else 0
        if ("seed" in spec) != ("realizations" in spec):
            raise SweepError("an ensemble has both a seed and a number of realizations")

    def realizations(self) -> dict[str, Axis]:
        if not self.is_random and self.count:
            raise SweepError(
                "realizations are asked for, but nothing is random: no function with a seed, no distribution"
            )
        return {REALIZATION: index(self.count)} if self.count else {}

    def call(self, table: Mapping[str, Any], path: str) -> Call:
        """A function and its parameters."""
        if not isinstance(table["function"], str):
            raise SweepError(f"{path}function = {table['function']!r} must be a name")
        swept = find(table["function"])
        given = {name: value for name, value in table.items() if name not in ("function", "failures")}
        check_parameters(swept, given, table["function"], path)
        number = self._random() if swept.is_ensemble else -1
        nodes = {name: self.argument(swept, name, value, path) for name, value in given.items()}
        if "failures" in table:
            nodes |= self.failing(swept, nodes, table["failures"], path)
        return Call(swept, nodes, number)

    def argument(self, swept: Swept, name: str, value: Any, path: str) -> Node:
        where = f"{path}{name}"
        if name in swept.others:
            return Fixed(value)
        if isinstance(value, dict) and "function" in value:
            return self.call(value, f"{where}.")
        core = swept.arguments[name]
        if core is None or REALIZATION in core:
            raise SweepError(f'{where} must be the result of a function: {{ function = "...", ... }}')
        return self.value(value, len(core), where, name, swept.attributes.get(name, {}))

    def value(self, value: Any, core: int, where: str, name: str, attributes: Mapping[str, str]) -> Node:
        if isinstance(value, list):
            if not value:
                raise SweepError(f"{where} is an empty list")
            if core == 0 or depth(value) > core:
                return self.along(numbers(value, core + 1, where), where, name, attributes)
            parts = [
                self.value(each, core - 1, f"{where}[{k}]", f"{name}_{k}", attributes)
                for k, each in enumerate(value, 1)
            ]
            constants = [part.constant for part in parts if isinstance(part, Fixed)]
            return Fixed(np.array(constants)) if len(constants) == len(parts) else Stacked(parts, core - 1)
        if isinstance(value, dict):
            return self.described(value, core, where, name, attributes)
        return Fixed(number(value, where))

    def described(
        self, value: Mapping[str, Any], core: int, where: str, name: str, attributes: Mapping[str, str]
    ) -> Node:
        """A range or a distribution."""
        if core:
            raise SweepError(f"{where} has components: give a list of them, each of which may be {FORMS}")
        for distribution, arguments in DISTRIBUTIONS.items():
            if set(value) == {distribution}:
                return self.drawn(distribution, value[distribution], arguments, where)
        require_known(value, {"start", "stop", "count", "scale"}, where)
        if not {"start", "stop", "count"} <= set(value):
            raise SweepError(f"{where} = {value} must be {FORMS}")
        start, stop = (number(value[end], f"{where}.{end}") for end in ("start", "stop"))
        count, scale = whole(value["count"], f"{where}.count", 1), value.get("scale", "linear")
        if scale not in SCALES:
            raise SweepError(f'{where}.scale = {scale!r} must be "linear" or "log"')
        if scale == "log" and start * stop <= 0:
            raise SweepError(f"{where} has a logarithmic scale: start and stop must have the same sign and not be 0")
        return self.along(SCALES[scale](start, stop, count), where, name, attributes)

    def drawn(self, distribution: str, given: Any, names: tuple[str, str], where: str) -> Node:
        if not isinstance(given, list) or len(given) != 2:
            raise SweepError(f"{where}.{distribution} must be [{', '.join(names)}]")
        first, second = (number(each, f"{where}.{name}") for each, name in zip(given, names, strict=True))
        if second < (0 if distribution == "normal" else first):
            raise SweepError(f"{where}.{distribution} = {given} is no distribution: {names[1]} is too small")
        return Drawn(distribution, (first, second), self._random())

    def along(self, values: Any, where: str, name: str, attributes: Mapping[str, str]) -> Node:
        axis = name if name not in self.axes and name != REALIZATION else where
        if axis in self.axes:
            raise SweepError(f"{where} is named twice")
        if values.ndim == 1:
            self.axes[axis] = Axis(len(values), values, attributes, {})
        else:
            own = tuple(f"{axis}_axis_{k}" for k in range(1, values.ndim))
            self.axes[axis] = index(len(values), {f"{axis}_values": ((axis, *own), values)})
        return Along(axis, values)

    def failing(self, swept: Swept, nodes: Mapping[str, Node], cases: Any, path: str) -> dict[str, Node]:
        """Limits and biases with the axis of failures."""
        if not {"axes", "limits"} <= set(swept.arguments):
            raise SweepError(f"{path}failures needs a function with axes and limits of wheels")
        if not isinstance(cases, list) or not cases or not all(isinstance(case, list) for case in cases):
            raise SweepError(f"{path}failures must be a list of lists of wheels, as [[], [0], [0, 2]]")
        failed = [[whole(wheel, f"{path}failures", 0) for wheel in case] for case in cases]
        count = 1 + max((wheel for case in failed for wheel in case), default=0)
        axis = "failure" if "failure" not in self.axes else f"{path}failure"
        self.axes[axis] = index(len(failed), {f"{axis}_wheels": ((axis, "failed_wheel"), failed_wheels(failed, count))})
        intact = {"limits": nodes.get("limits", Fixed(1.0))} | {n: nodes[n] for n in ("bias",) if n in nodes}
        return {name: Failing(node, axis, failed, nodes["axes"]) for name, node in intact.items()}

    def _random(self) -> int:
        if not self.count:
            raise SweepError("what is random needs a seed and a number of realizations")
        self.is_random = True
        self.random_numbers += 1
        return self.random_numbers


def index(size: int, further: Mapping[str, tuple[tuple[str, ...], Any]] | None = None) -> Axis:
    """An axis whose places are numbered from 0."""
    return Axis(size, np.arange(size), {}, further or {})
