"""A formula of floats as operations on arrays: it runs once on values that record what is done with them.

`planning` writes of it what runs for one mix of arguments.
"""

from __future__ import annotations

from collections.abc import Callable
from types import CodeType, FunctionType
from typing import Any, NamedTuple

INFIX = {"add": "+", "subtract": "-", "multiply": "*", "divide": "/"}
METHODS = {"add": "add", "subtract": "sub", "multiply": "mul", "divide": "truediv"}
UFUNCS = {"pow": "power", "atan": "arctan"}  # names of NumPy that differ from those of `math`
MATH = {function: name for name, function in UFUNCS.items()}
RATIOS = ("expm1_ratio", "gamma_ratio", "log1p_ratio")

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
