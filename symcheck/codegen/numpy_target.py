"""A program as a NumPy kernel: an expression that `math` and NumPy share, and a block of ufuncs in place."""

from __future__ import annotations

import re
import textwrap
from collections import Counter
from collections.abc import Iterator, Mapping
from fractions import Fraction

from symcheck.codegen.docstring import docstring
from symcheck.codegen.program import INFIX, UNARY, Operation, Program, Ref, registers
from symcheck.codegen.special import RUNTIME
from symcheck.codegen.target import MARK, Made, Target

MATH = {"arctan": "atan", "power": "pow"}  # what `math` calls otherwise
CALLS = """The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32
if all are. `out` takes {} of the broadcast shape and type; a ValueError names what does not fit. What is no number
gives no number."""
EQUAL = "Outputs that are equal by formula are one array, unless `out` is given."
LONGEST = 90  # characters of an expression that is not given a name
HEAD = '''"""Kernels of {key}. {mark}"""

import math

import numpy as np

from symcheck.runtime import DOUBLE, FEW, SMALL, evaluate, evaluate_alike{special}

__all__ = [{names}]
'''


def number(x: Ref) -> str:
    """A number as Python: `2.0`, `3.0 / 8.0`, `math.pi`, `math.sqrt(3.0)`; a name as it is."""
    if isinstance(x, Fraction):
        return f"{x.numerator}.0" if x.denominator == 1 else f"{x.numerator}.0 / {x.denominator}.0"
    if x.startswith("sqrt("):
        return f"math.sqrt({number(Fraction(x[5:-1]))})"
    return "math.pi" if x == "pi" else x


def named(x: Ref) -> str:
    """The name of a number in an expression: `n2`, `n3_8`, `pi`, `sqrt_3`."""
    return (
        f"n{x}".replace("/", "_").replace("-", "minus_")
        if isinstance(x, Fraction)
        else re.sub(r"\W+", "_", x).strip("_")
    )


def numbers(program: Program) -> tuple[Ref, ...]:
    """The numbers in the operations of a program.

    An expression takes them as arguments, for NumPy as arrays: it converts a Python number anew in every operation,
    which takes half as long as the operation itself on a small array.
    """
    used = (x for operation in program.operations for x in operation.operands)
    return tuple(dict.fromkeys(x for x in used if number(x) != x))


def functions(program: Program) -> tuple[str, ...]:
    """The functions that the program calls."""
    return tuple(sorted({operation.function for operation in program.operations} & {*UNARY, "power"}))


def expression_lines(program: Program) -> Iterator[str]:
    """The program as assignments, and what it returns; what is used once stands where it is used.

    NumPy gives the memory of such a value back at once, while it is still in the cache.
    """
    uses = Counter(x for operation in program.operations for x in operation.operands) + Counter(
        program.outputs.values()
    )
    texts: dict[Ref, str] = {x: named(x) for x in numbers(program)}
    for operation in program.operations:
        text = _expression(operation, [texts.get(x, number(x)) for x in operation.operands])
        if uses[operation.result] > 1 or len(text) > LONGEST:
            yield f"{operation.result} = {text}"
        else:
            texts[operation.result] = text if operation.function in (*UNARY, *RUNTIME, "power") else f"({text})"
    values = (texts.get(value, number(value)) for value in program.outputs.values())
    yield f"return {', '.join(value[1:-1] if value[0] == '(' else value for value in values)}"


def _expression(operation: Operation, operands: list[str]) -> str:
    if operation.function in INFIX:
        return f" {INFIX[operation.function]} ".join(operands)
    if operation.function == "negative":
        return f"-{operands[0]}"
    inside = ", ".join(x[1:-1] if x[0] == "(" else x for x in operands)
    return f"{operation.function}({inside})"


def block_lines(program: Program) -> tuple[int, list[str]]:
    """The program as ufunc calls on registers, and how many registers it takes."""
    outputs = {value: f"out_{name}" for value, name in distinct(program).items()}
    lines, count = [], 0
    held: dict[Ref, str] = {}
    for operation, place in registers(program):
        operands = [held.get(x, number(x)) for x in operation.operands]
        target = outputs[operation.result] if place is None else f"r{place}"
        count = max(count, 0 if place is None else place + 1)
        held[operation.result] = target
        module = "" if operation.function in RUNTIME else "np."
        lines.append(f"{module}{operation.function}({', '.join(operands)}, {target})  # {operation.result}")
    lines += [f"{target}[...] = {number(value)}" for value, target in outputs.items() if value not in held]
    return count, lines


def distinct(program: Program) -> dict[Ref, str]:
    """The values that the program puts out, each with the first output that has it."""
    return {value: name for name, value in reversed(program.outputs.items())}


def files(key: str, kernels: Mapping[str, Made]) -> dict[str, str]:
    """The module of a paper."""
    texts = [source(name, made) for name, made in kernels.items()]
    names = ", ".join(f'"{name}"' for name in sorted(kernels))
    special = "".join(f", {name}" for name in RUNTIME if any(f"{name}(" in text for text in texts))
    return {f"{key}.py": "\n\n".join([HEAD.format(key=key, mark=MARK, names=names, special=special), *texts])}


def calls(program: Program) -> str:
    """How a kernel is called."""
    count = len(program.outputs)
    equal = EQUAL if len(distinct(program)) < count else ""
    return f"{CALLS.format(f'{count} arrays' if count > 1 else 'an array')} {equal}"


TARGET = Target("NumPy, in generated/", files)


def source(name: str, made: Made) -> str:
    """The text of one kernel."""
    program = made.program
    inputs = ", ".join(program.inputs)
    called, used = functions(made.pointwise), numbers(made.pointwise)
    count, lines = block_lines(program)
    firsts = sorted(distinct(program).values(), key=list(program.outputs).index)
    order = ", ".join(str(firsts.index(distinct(program)[value])) for value in program.outputs.values())
    outs = ", ".join(f"out_{output}" for output in firsts)
    rows = "".join(f", r{k}" for k in range(count))
    types = " is ".join(f"type({x})" for x in program.inputs)
    doubles = " is ".join(f"{x}.dtype" for x in program.inputs)
    shapes = "".join(f"{' and' if n == 0 else ''} {x}.shape ==" for n, x in enumerate(program.inputs))
    shapes = f"{shapes.removesuffix(' ==')}" if len(program.inputs) > 1 else ""
    block = f"_{name}_block, {count}, ({order},), ({inputs},)"
    most = "SMALL" if made.pointwise.operations == program.operations else "FEW"
    direct = f"""
            if {program.inputs[0]}.size <= {most}:
                return _{name}({inputs})"""
    if not {*program.outputs.values()} <= {operation.result for operation in program.operations}:
        direct = ""  # a result must be no argument, and no number
    taken = "".join(f", {function}=np.{function}" for function in called)
    taken += "".join(f", {named(x)}=np.array({number(x)})" for x in used)
    own = "".join(f", math.{MATH.get(function, function)}" for function in called)
    own += "".join(f", {number(x)}" for x in used)
    return f"""def {name}({inputs}, out=None):
{textwrap.indent(docstring(made, calls(program)), "    ")}
    if out is None:
        if {types} is float:
            try:
                return _{name}({inputs}{own})
            except (ValueError, ZeroDivisionError, OverflowError):
                pass  # NumPy says whether it is infinite or no number
        elif {types} is np.ndarray and {doubles} is DOUBLE{shapes}:{direct}
            return evaluate_alike({block})
    return evaluate({block}, out)


def _{name}({inputs}{taken}):
{textwrap.indent(chr(10).join(expression_lines(made.pointwise)), "    ")}


def _{name}_block({inputs}, {outs}{rows}):
{textwrap.indent(chr(10).join(lines), "    ")}
"""
