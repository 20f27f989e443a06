"""A program as assignments in Python, and what is returned: a value that is used once stands where it is used."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from fractions import Fraction

from symcheck.kernels.codegen.program import INFIX, Operation, Program, Ref, is_number, under_root
from symcheck.kernels.codegen.special import RUNTIME

MATH = {"arctan": "atan", "power": "pow"}  # names in `math` that differ from NumPy's
LONGEST = 90  # characters of an expression without a name, so that a line with two of them stays readable
SUM, PRODUCT, ATOM = range(1, 4)  # how tightly the last operator of an expression binds
BINDING = {"add": SUM, "subtract": SUM, "multiply": PRODUCT, "divide": PRODUCT, "negative": SUM}


def number(x: Ref) -> str:
    """A number as Python: `2.0`, `(3.0 / 8.0)`, `math.pi`, `math.sqrt(3.0)`; a name as it is."""
    if isinstance(x, Fraction):
        return f"{x.numerator}.0" if x.denominator == 1 else f"({x.numerator}.0 / {x.denominator}.0)"
    if (inside := under_root(x)) is not None:
        return f"math.sqrt({bare(number(inside))})"
    return "math.pi" if x == "pi" else x


def bare(text: str) -> str:
    """An expression without the brackets around it."""
    return text[1:-1] if text[0] == "(" else text


def call_of_math(operation: Operation, operands: list[str]) -> str:
    """The call of a function of floats."""
    function = operation.function
    name = function if function in RUNTIME else f"math.{MATH.get(function, function)}"
    return f"{name}({', '.join(operands)})"


def assignments(
    program: Program,
    call: Callable[[Operation, list[str]], str] = call_of_math,
    alone: Callable[[Ref], str] = number,
) -> tuple[list[str], list[str]]:
    """The assignments of a program, and the expressions of its outputs.

    call   writes the call of a function
    alone  writes a number that has no value beside it
    """
    used = [x for operation in program.operations for x in operation.operands]
    uses = Counter([*used, *program.outputs.values()])
    texts: dict[Ref, tuple[str, int]] = {}
    lines = []

    def whole(x: Ref) -> str:
        return texts[x][0] if x in texts else bare(alone(x))

    for operation in program.operations:
        if binding := BINDING.get(operation.function):
            text = _joined(operation, binding, texts, alone if all(map(is_number, operation.operands)) else number)
        else:
            text, binding = call(operation, [whole(x) for x in operation.operands]), ATOM
        if uses[operation.result] > 1 or len(text) > LONGEST:
            lines.append(f"{operation.result} = {text}")
        else:
            texts[operation.result] = text, binding
    return lines, [whole(x) for x in program.outputs.values()]


def _joined(
    operation: Operation, binding: int, texts: Mapping[Ref, tuple[str, int]], write: Callable[[Ref], str]
) -> str:
    """An operator between its operands, with the brackets that keep the order of operations."""

    def side(x: Ref, least: int) -> str:
        text, own = texts.get(x, (write(x), ATOM))
        return text if own >= least else f"({text})"

    if operation.function == "negative":
        return f"-{side(operation.operands[0], ATOM)}"
    left, right = operation.operands
    return f"{side(left, binding)} {INFIX[operation.function]} {side(right, binding + 1)}"
