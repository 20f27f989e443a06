"""How a formula runs on one mix of arguments: its operations as text.

What depends on numbers alone is computed by `math`, what depends on some of the arrays has their shape, and where it
meets what has the shape of the results it is written out in that shape first: NumPy takes twice as long for arrays of
two shapes.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property, partial
from typing import Any

import numpy as np
from numpy import array, dtype, empty

from symcheck.kernels import ratios
from symcheck.kernels.grouping import patterns_of
from symcheck.kernels.tracing import INFIX, MATH, RATIOS, Operand, Pattern, Step, Trace

# Nanoseconds, measured: an operation of NumPy on few points; one by one with `math` the whole, an argument, an output.
UFUNC, CALL, TAKEN, PUT = 250, 1100, 75, 330
# Each point, its operations, arguments and outputs.
POINT, FLOAT, ARGUMENT, RESULT = 100, 7, 11, 55
MANY = {"gamma_ratio": (75, 130), "log1p_ratio": (9, 25), "expm1_ratio": (7, 20)}  # operations of NumPy, of `math`


class Plan:
    """A trace for one mix of arguments, as functions that are written when they are first asked for.

    traced    the formula
    patterns  which axes each argument has
    full      all axes
    kind      the type of the results
    name      what it is called in a traceback
    """

    def __init__(self, traced: Trace, patterns: Sequence[Pattern], full: int, kind: dtype[Any], name: str) -> None:
        self.traced, self.full, self.kind, self.name = traced, full, kind, name
        self.patterns = patterns_of(self.traced, patterns)
        self.inputs = [f"x{k}" for k in range(traced.arity)]

    @cached_property
    def values(self) -> list[int]:
        """The places of the distinct outputs."""
        return [*dict.fromkeys(self.traced.outputs)]

    @cached_property
    def even(self) -> tuple[int, ...]:
        """Which of the distinct outputs have the shape of the results by themselves."""
        return tuple(k for k, place in enumerate(self.values) if self.patterns[place] == self.full)

    @cached_property
    def whole(self) -> Callable[..., Any]:
        """Of all arguments, numbers as floats: the results in new arrays."""
        text = self._text
        return self._made("whole", self.inputs, [*text.before, *text.after], text.results())

    @cached_property
    def into(self) -> Callable[..., None]:
        """Of all arguments and an array for each distinct output, none of which shares memory with another."""
        text = _Text(self, given=True, kept=False)
        outputs = [f"o{place}" for place in self.values]
        return self._made("into", [*self.inputs, *outputs], [*text.before, *text.after], [])

    @cached_property
    def _text(self) -> _Text:
        return _Text(self, given=False, kept=False)

    @cached_property
    def _pieces(self) -> _Text:
        return _Text(self, given=True, kept=True)

    @cached_property
    def prelude(self) -> Callable[..., Sequence[Any]]:
        """Of all arguments: what `block` takes, and the outputs that do not have all axes."""
        text = self._pieces
        others = [text.held[place] for place in self.values if self.patterns[place] != self.full]
        return self._made("prelude", self.inputs, text.before, [*text.taken.values(), *others], bracketed=True)

    @cached_property
    def block(self) -> Callable[..., None]:
        """Of the values of a piece, numbers as arrays without dimensions, then arrays for outputs and registers."""
        text = self._pieces
        outputs = [f"o{self.values[k]}" for k in self.even]
        rows = [f"r{k}" for k in range(text.registers)]
        return self._made("block", [*text.taken, *outputs, *rows], text.after, [])

    @property
    def taken(self) -> int:
        """How many values `block` takes."""
        return len(self._pieces.taken)

    @property
    def registers(self) -> int:
        """How many registers it takes."""
        return self._pieces.registers

    @cached_property
    def handful(self) -> int:
        """Up to how many points `math` takes less time for than NumPy."""
        steps = [*enumerate(self.traced.steps, self.traced.arity)]
        weights = [MANY.get(step.function, (1, 1)) for _, step in steps]
        block = sum(
            FLOAT * floats if self.patterns[place] is None else UFUNC * ufuncs
            for (place, _), (ufuncs, floats) in zip(steps, weights, strict=True)
        )
        outputs = len(self.values)
        begin = CALL + TAKEN * self.traced.arity + PUT * outputs
        each = POINT + FLOAT * sum(floats for _, floats in weights)
        each += ARGUMENT * self.traced.arity + RESULT * len(self.traced.outputs)
        return max((block - begin) // each, 1)

    def shape(self) -> str:
        """The shape of the results, as text."""
        whole = [x for x, pattern in zip(self.inputs, self.patterns, strict=False) if pattern == self.full]
        if whole:
            return f"{whole[0]}.shape"
        count, lengths = self.full.bit_length(), []
        for axis in range(count):
            having = next(
                k for k, pattern in enumerate(self.patterns[: self.traced.arity]) if (pattern or 0) >> axis & 1
            )
            lengths.append(f"x{having}.shape[{axis - count}]")
        return f"({', '.join(lengths)},)"

    def _made(
        self, name: str, inputs: Sequence[str], lines: Sequence[str], results: Sequence[str], *, bracketed: bool = False
    ) -> Callable[..., Any]:
        """The function of some lines."""
        back = f"({', '.join(results)},)" if bracketed and results else ", ".join(results) or "()"
        text = "\n    ".join([f"def {name}({', '.join(inputs)}):", *lines, f"return {back}"])
        space = self._names
        exec(compile(text, f"<{self.name} on arrays>", "exec"), space)  # our own text, of names chosen here
        made: Callable[..., Any] = space[name]
        return made

    @cached_property
    def _names(self) -> dict[str, Any]:
        """What the texts call: functions of arrays by their names, those of floats with `of_` before them."""
        double = self.kind == np.float64
        found: dict[str, Any] = {"empty": empty if double else partial(empty, dtype=self.kind)}
        found["number"] = array if double else partial(array, dtype=self.kind)
        for function in {step.function for step in self.traced.steps}:
            found[function] = getattr(ratios if function in RATIOS else np, function)
            of_float = found[function] if function in RATIOS else getattr(math, MATH.get(function, function), None)
            found[f"of_{function}"] = of_float
        return found | {text: array(x, self.kind) for x, text in self.constants.items()}

    @cached_property
    def constants(self) -> Mapping[float, str]:
        """The numbers of the formula that meet arrays: as arrays, since NumPy converts others in each operation."""
        found: dict[float, str] = {}
        for place, step in enumerate(self.traced.steps, self.traced.arity):
            if self.patterns[place] is not None:
                for x in step.operands:
                    if type(x) is float:
                        found.setdefault(x, f"n{len(found)}")
        return found


class _Text:
    """The lines of a plan.

    given  outputs are arrays that are given
    kept   so are registers, and what has not all axes is written out by who calls; else new arrays are registers
    """

    def __init__(self, plan: Plan, *, given: bool, kept: bool) -> None:
        self.plan, self.given, self.kept = plan, given, kept
        self.before: list[str] = []  # what numbers alone, and arrays with some of the axes, come to
        self.after: list[str] = []
        self.held = {place: f"x{place}" for place in range(plan.traced.arity)}
        self.taken: dict[str, str] = {}  # what `block` takes, by the names it has there
        self.registers = 0
        self._arrays: dict[int, str] = {}  # numbers as arrays without dimensions
        self._owned: dict[int, str] = {}  # registers, by the places of what they hold
        self._free: list[str] = []
        self._last: dict[Operand, int] = {}  # where a value is used last
        self._write()

    def results(self) -> list[str]:
        """The arrays of the outputs, where none are given."""
        return [self._owned[place] for place in self.plan.traced.outputs]

    def _write(self) -> None:
        plan = self.plan
        steps = [*enumerate(plan.traced.steps, plan.traced.arity)]
        for place, step in steps:
            if plan.patterns[place] == plan.full:
                self._last |= dict.fromkeys(step.operands, place)
        if not self.given:
            self._last |= dict.fromkeys(plan.values, len(plan.patterns))
        for place, step in steps:
            if plan.patterns[place] == plan.full:
                self._on_arrays(place, step)
                continue
            self.held[place] = f"v{place}"
            number = plan.patterns[place] is None
            text = (
                self._of_floats(step) if number else f"{step.function}({', '.join(map(self._operand, step.operands))})"
            )
            self.before.append(f"v{place} = {text}")
        for place in plan.values:
            if plan.patterns[place] != plan.full and not self.kept:
                if self.given:
                    self.after.append(f"o{place}[...] = {self.held[place]}")
                else:
                    self._written_out(place)

    def _on_arrays(self, place: int, step: Step) -> None:
        """An operation whose value has the shape of the results."""
        operands = [*map(self._operand_of_all_axes, step.operands)]
        done = [
            x for x in dict.fromkeys(step.operands) if type(x) is int and x in self._owned and self._last[x] == place
        ]
        self._free += [self._owned.pop(x) for x in done]
        target, new = f"o{place}", False
        if not (self.given and place in self.plan.values):
            target, new = self._register(place)
        self.held[place] = target
        call = f"{step.function}({', '.join(operands)}"
        self.after.append(f"{target} = {call})" if new else f"{call}, {target})")

    def _register(self, place: int) -> tuple[str, bool]:
        """The register of a value, and whether it is still to be made."""
        new = not self._free
        if new:
            self._free.append(f"r{self.registers}")
            self.registers += 1
        self._owned[place] = found = self._free.pop()
        return found, new and not self.kept

    def _operand_of_all_axes(self, x: Operand) -> str:
        """An operand of an operation on arrays that have the shape of the results."""
        if type(x) is float or self.plan.patterns[int(x)] in (None, self.plan.full):
            found = self._operand(x)
            if found[0] in "xw":
                self.taken[found] = found
            return found
        if self.kept:
            self.taken[f"e{x}"] = self.held[int(x)]
            return f"e{x}"
        return self._written_out(int(x))

    def _written_out(self, x: int) -> str:
        """A number, or an array that has not all axes, in the shape of the results."""
        if x not in self._owned:
            if "shape" not in self._arrays.values():
                self.after.append(f"shape = {self.plan.shape()}")
                self._arrays[-1] = "shape"
            target, new = self._register(x)
            self.after += [f"{target} = empty(shape)"] * new + [f"{target}[...] = {self.held[x]}"]
        return self._owned[x]

    def _operand(self, x: Operand) -> str:
        """An operand of an operation on arrays: numbers are arrays, since NumPy converts others in each operation."""
        if type(x) is float:
            return self.plan.constants[x]
        place = int(x)
        if self.plan.patterns[place] is not None:
            return self.held[place]
        if place not in self._arrays:
            self._arrays[place] = f"w{place}"
            self.before.append(f"w{place} = number({self.held[place]})")
        return self._arrays[place]

    def _of_floats(self, step: Step) -> str:
        operands = [self.held[x] if type(x) is int else repr(x) for x in step.operands]
        if sign := INFIX.get(step.function):
            return f" {sign} ".join(operands)
        return f"-{operands[0]}" if step.function == "negative" else f"of_{step.function}({', '.join(operands)})"
