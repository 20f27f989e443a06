"""A program as an expression of Python floats: assignments, and what is returned."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from fractions import Fraction

from symcheck.kernels.codegen.program import INFIX, UNARY, Operation, Program, Ref, under_root
from symcheck.kernels.codegen.special import RUNTIME

MATH = {"arctan": "atan", "power": "pow"}  # what `math` calls otherwise
CALLED = (*UNARY, *RUNTIME, "power")
LONGEST = 90  # characters of an expression that is not given a name


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


def expression_lines(program: Program) -> Iterator[str]:
    """The program as assignments, and what it returns; what is used once stands where it is used."""
    used = [x for operation in program.operations for x in operation.operands]
    uses = Counter([*used, *program.outputs.values()])
    texts: dict[Ref, str] = {}
    for operation in program.operations:
        text = _expression(operation, [texts.get(x, number(x)) for x in operation.operands])
        if uses[operation.result] > 1 or len(text) > LONGEST:
            yield f"{operation.result} = {text}"
        else:
            texts[operation.result] = text if operation.function in CALLED else f"({text})"
    yield f"return {', '.join(bare(texts.get(value, number(value))) for value in program.outputs.values())}"


def _expression(operation: Operation, operands: list[str]) -> str:
    if operation.function in INFIX:
        return f" {INFIX[operation.function]} ".join(operands)
    if operation.function == "negative":
        return f"-{operands[0]}"
    name = (
        operation.function
        if operation.function in RUNTIME
        else f"math.{MATH.get(operation.function, operation.function)}"
    )
    return f"{name}({', '.join(map(bare, operands))})"
