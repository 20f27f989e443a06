"""A formula of floats as operations on arrays: it runs once on values that record what is done with them.

What is recorded becomes text for one mix of arguments: what depends on numbers alone is computed by `math`, what
depends on some of the arrays has their shape, and only what has the shape of the results goes through registers.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from types import CodeType, FunctionType
from typing import Any, NamedTuple

import numpy as np
from numpy import array, dtype, empty

from symcheck.kernels import ratios

INFIX = {"add": "+", "subtract": "-", "multiply": "*", "divide": "/"}
METHODS = {"add": "add", "subtract": "sub", "multiply": "mul", "divide": "truediv"}
UFUNCS = {"pow": "power", "atan": "arctan"}  # names of NumPy that differ from those of `math`
MATH = {function: name for name, function in UFUNCS.items()}
RATIOS = ("expm1_ratio", "gamma_ratio", "log1p_ratio")

# Nanoseconds, measured. NumPy: an operation on few points; what it takes longer to write one element over its operand.
UFUNC, AGAIN = 250, 550
# One by one with `math`: the whole, an argument, an output; what a single point takes less for.
CALL, TAKEN, PUT, SINGLE = 1100, 75, 330, 450
# Each point, its operations, arguments and outputs.
POINT, FLOAT, ARGUMENT, RESULT = 100, 7, 11, 55
MANY = {"gamma_ratio": (75, 130), "log1p_ratio": (9, 25), "expm1_ratio": (7, 20)}  # operations of NumPy, of `math`

Operand = int | float  # the place of a value, or a number
Pattern = int | None  # which axes of the results a value has, as bits; None for a number


class Step(NamedTuple):
    """One operation: the name of a ufunc or of a function of `ratios`, and its operands."""

    function: str
    operands: tuple[Operand, ...]


class Trace(NamedTuple):
    """A formula as operations: its `arity` arguments have the first places, each step the next; so have outputs."""

    arity: int
    steps: tuple[Step, ...]
    outputs: tuple[int, ...]

    @property
    def order(self) -> list[int]:
        """For each output, which of the distinct values it is."""
        values = [*dict.fromkeys(self.outputs)]
        return [values.index(place) for place in self.outputs]


class Plan(NamedTuple):
    """A trace for one mix of arguments, as functions.

    whole      of all arguments, numbers as floats: the results in new arrays, or in those that follow
    prelude    of all arguments: what `block` takes, then the outputs that not all axes have; None if block takes all
    block      of arrays of a piece, numbers as arrays without dimensions, then arrays for results and registers
    taken      how many values `block` takes
    full       which of the distinct outputs are block's
    uneven     outputs for which `whole` gives arrays of other shapes, or numbers: the places of each that are the same
    registers  how many it takes
    handful    up to so many points are computed in less time one by one
    """

    whole: Callable[..., Any]
    prelude: Callable[..., Any] | None
    block: Callable[..., Any]
    taken: int
    full: tuple[int, ...]
    uneven: tuple[tuple[int, ...], ...]
    registers: int
    handful: int


class _Value:
    """What stands for a float while a formula is recorded."""

    __slots__ = ("place", "steps")

    def __init__(self, place: int, steps: list[Step]) -> None:
        self.place, self.steps = place, steps

    def __neg__(self) -> _Value:
        return _apply("negative", self)


def _apply(function: str, *operands: Any) -> _Value:
    steps = next(x.steps for x in operands if isinstance(x, _Value))
    steps.append(Step(function, tuple(x.place if isinstance(x, _Value) else float(x) for x in operands)))
    return _Value(-len(steps), steps)


for _name, _method in METHODS.items():
    setattr(_Value, f"__{_method}__", lambda x, y, name=_name: _apply(name, x, y))
    setattr(_Value, f"__r{_method}__", lambda x, y, name=_name: _apply(name, y, x))


def _recorded(name: str, function: Any) -> Any:
    """A function of floats that records a value; a number as it is."""
    if not callable(function):
        return function

    def record(*operands: Any) -> Any:
        known = any(isinstance(x, _Value) for x in operands)
        return _apply(UFUNCS.get(name, name), *operands) if known else function(*operands)

    return record


def trace(formula: Callable[..., Any]) -> Trace:
    """The operations of a formula, whose functions are those of `math` and of `ratios`."""
    code: CodeType = formula.__code__
    names = {name: _recorded(name, formula.__globals__[name]) for name in code.co_names}
    steps: list[Step] = []
    count = code.co_argcount
    found = FunctionType(code, names)(*(_Value(k, steps) for k in range(count)))

    def place(x: int) -> int:
        return x if x >= 0 else count - 1 - x

    ordered = [Step(f, tuple(place(x) if type(x) is int else x for x in operands)) for f, operands in steps]
    results = found if isinstance(found, tuple) else (found,)
    return Trace(count, tuple(ordered), tuple(place(x.place) for x in results))


def plan(traced: Trace, patterns: Sequence[Pattern], full: int, kind: dtype[Any], name: str) -> Plan:
    """The plan for arguments of these patterns, with results in arrays of one type."""
    writing = _Writing(traced, [*patterns], full)
    before, after, taken, registers = writing.lines()
    inputs = [f"x{k}" for k in range(traced.arity)]
    values, held = [*dict.fromkeys(traced.outputs)], writing.held
    whole_shape = next((text for text, each in zip(inputs, patterns, strict=False) if each == full), "")
    numbers = [place for place in values if writing.patterns[place] is None and whole_shape]
    even = [place for place in values if writing.patterns[place] == full]
    own = [f"o{place}=None" for place in even] + [f"r{k}=None" for k in range(registers)]
    shape = [f"shape = {whole_shape}.shape"] if numbers else []
    uneven = [held[place] for place in values if place not in even]
    filling = shape + [
        line
        for place in numbers
        for line in (f"if o{place} is None: o{place} = empty(shape, KIND)", f"o{place}.fill({held[place]})")
    ]
    into = [place for place in values if place in (*even, *numbers)]
    rows = [f"o{place}=None" for place in into] + own[len(even) :]
    results = [f"o{place}" if place in into else held[place] for place in traced.outputs]
    texts = [_function("whole", [*inputs, *rows], [*before, *filling, *after], results)]
    split = bool(before or uneven)
    if split:
        texts.append(_function("prelude", inputs, before, [*taken, *uneven], bracketed=True))
        texts.append(_function("block", [*taken, *own], after, [held[place] for place in even], bracketed=True))
    space = _names(traced, kind) | {text: array(x, kind) for x, text in writing.numbers.items()}
    exec(compile("\n".join(texts), f"<{name} on arrays>", "exec"), space)  # our own text, of names chosen above
    return Plan(
        space["whole"],
        space["prelude"] if split else None,
        space["block"] if split else space["whole"],
        len(taken) if split else traced.arity,
        tuple(values.index(place) for place in even),
        tuple(
            tuple(n for n, each in enumerate(traced.outputs) if each == place) for place in values if place not in into
        ),
        registers,
        _handful(traced, writing),
    )


def _names(traced: Trace, kind: dtype[Any]) -> dict[str, Any]:
    """What the texts of a plan call: functions of arrays by their names, those of floats with `of_` before them."""
    found: dict[str, Any] = {"empty": empty, "KIND": kind}
    found["number"] = array if kind == np.float64 else partial(array, dtype=kind)
    for function in {step.function for step in traced.steps}:
        found[function] = getattr(ratios if function in RATIOS else np, function)
        of_float = found[function] if function in RATIOS else getattr(math, MATH.get(function, function), None)
        found[f"of_{function}"] = of_float
    return found


def _function(
    name: str, inputs: Sequence[str], lines: Sequence[str], results: Sequence[str], *, bracketed: bool = False
) -> str:
    given = f"({', '.join(results)}{',' * (len(results) == 1)})" if bracketed else ", ".join(results)
    return "\n    ".join([f"def {name}({', '.join(inputs)}):", *lines, f"return {given}"])


class _Writing:
    """The lines of a plan."""

    def __init__(self, traced: Trace, patterns: list[Pattern], full: int) -> None:
        self.traced, self.full = traced, full
        self.patterns = patterns
        for step in traced.steps:
            bits = [each for x in step.operands if type(x) is int and (each := patterns[x]) is not None]
            union = 0
            for each in bits:
                union |= each
            patterns.append(union if bits else None)
        self.held = {place: f"x{place}" for place in range(traced.arity)}
        self.numbers: dict[float, str] = {}
        self._arrays: dict[int, str] = {}  # numbers as arrays without dimensions

    def lines(self) -> tuple[list[str], list[str], list[str], int]:
        """What comes before the block, the block, the names it takes, and how many registers."""
        before: list[str] = []
        after: list[str] = []
        taken: dict[str, None] = {}
        count = 0
        for place, step, register in self._placed():
            pattern = self.patterns[place]
            if pattern is None:
                self.held[place] = f"v{place}"
                before.append(f"v{place} = {self._of_floats(step)}")
                continue
            operands = [self._operand(x, before) for x in step.operands]
            if pattern != self.full:
                self.held[place] = f"v{place}"
                before.append(f"v{place} = {step.function}({', '.join(operands)})")
                continue
            given = [text for text in operands if text[0] in "xvw"]
            taken |= dict.fromkeys(given)
            target = f"o{place}" if register is None else f"r{register}"
            count = max(count, 0 if register is None else register + 1)
            after.append(f"{target} = {step.function}({', '.join([*operands, target])})")
            self.held[place] = target
        return before, after, [*taken], count

    def _operand(self, x: Operand, before: list[str]) -> str:
        """An operand of an operation on arrays: numbers are arrays, since NumPy converts others in each operation."""
        if type(x) is float:
            return self.numbers.setdefault(x, f"n{len(self.numbers)}")
        assert type(x) is int
        if self.patterns[x] is not None:
            return self.held[x]
        if x not in self._arrays:
            self._arrays[x] = f"w{x}"
            before.append(f"w{x} = number({self.held[x]})")
        return self._arrays[x]

    def _of_floats(self, step: Step) -> str:
        operands = [self.held[x] if type(x) is int else repr(x) for x in step.operands]
        if sign := INFIX.get(step.function):
            return f" {sign} ".join(operands)
        return f"-{operands[0]}" if step.function == "negative" else f"of_{step.function}({', '.join(operands)})"

    def _placed(self) -> Iterator[tuple[int, Step, int | None]]:
        """Each step with its place and register, None for an output; a register is free after its last use."""
        last: dict[Operand, int] = {}
        for place, step in enumerate(self.traced.steps, self.traced.arity):
            last.update(dict.fromkeys(step.operands, place))
        final, held, free = {*self.traced.outputs}, dict[Operand, int](), list[int]()
        for place, step in enumerate(self.traced.steps, self.traced.arity):
            if self.patterns[place] != self.full:
                yield place, step, None
                continue
            free += [held[x] for x in dict.fromkeys(step.operands) if type(x) is int and x in held and last[x] == place]
            if place in final:
                yield place, step, None
                continue
            held[place] = free.pop() if free else len({*held.values()})
            yield place, step, held[place]

    def in_place(self) -> int:
        """How many operations write over one of their operands."""
        found: Mapping[int, int | None] = {place: register for place, _, register in self._placed()}
        return sum(
            register is not None and register in [found.get(x) for x in step.operands if type(x) is int]
            for place, step, register in self._placed()
        )


def _handful(traced: Trace, writing: _Writing) -> int:
    """Up to how many points `math` takes less time for than NumPy."""
    steps = [*enumerate(traced.steps, traced.arity)]
    weights = [MANY.get(step.function, (1, 1)) for _, step in steps]
    block = sum(
        FLOAT * floats if writing.patterns[place] is None else UFUNC * ufuncs
        for (place, _), (ufuncs, floats) in zip(steps, weights, strict=True)
    )
    outputs = len({*traced.outputs})
    begin = CALL + TAKEN * traced.arity + PUT * outputs
    each = POINT + FLOAT * sum(floats for _, floats in weights)
    each += ARGUMENT * traced.arity + RESULT * len(traced.outputs)
    return max((block - begin) // each, int(block + AGAIN * writing.in_place() > begin + each - SINGLE))
