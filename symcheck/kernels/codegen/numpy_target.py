"""A program as a NumPy kernel: an expression of numbers, and a block of ufuncs in place for arrays."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator, Mapping
from fractions import Fraction

from symcheck.core.verdicts import SymcheckError
from symcheck.kernels.codegen.docstring import docstring
from symcheck.kernels.codegen.expression import bare, expression_lines, number
from symcheck.kernels.codegen.kernel import Kernel
from symcheck.kernels.codegen.program import Program, Ref, is_number, registers
from symcheck.kernels.codegen.special import RUNTIME
from symcheck.kernels.codegen.target import MARK, Made, Target

CALLS = """The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32
if all are. `out` takes {} of the broadcast shape and type; a ValueError names what does not fit. What is no number
gives no number."""
EQUAL = "Outputs that are equal by formula are one array, unless `out` is given."
HEAD = '''"""Kernels of {key}. {mark}"""

import math

from numpy import {ufuncs}, array, ndarray

{special}from symcheck.kernels.runtime import DOUBLE, FEW, SMALL, evaluate, evaluate_alike, evaluate_handful

__all__ = [{names}]

DECLARED = {{  # name, meaning and unit of the arguments and of the results; docstrings may be stripped
{declared}
}}
'''
# Nanoseconds, measured. NumPy: an operation on few points; what it takes longer to write one element over its operand.
UFUNC, AGAIN = 250, 550
# One by one with `math`: the whole, an argument, an output; what a single point takes less for.
CALL, TAKEN, PUT, SINGLE = 1100, 75, 330, 450
# Each point, its operations, arguments and outputs.
POINT, FLOAT, ARGUMENT, RESULT = 100, 7, 11, 55
MANY = {"gamma_ratio": (110, 250), "log1p_ratio": (9, 25), "expm1_ratio": (7, 20)}  # operations of NumPy, of `math`


def block_lines(program: Program, named: Mapping[Ref, str]) -> tuple[int, list[str]]:
    """The program as ufunc calls on registers, and how many registers it takes.

    Each call gives back the register it wrote, or a new array if there was none.
    """
    outputs = {value: f"out_{name}" for value, name in distinct(program).items()}
    lines, count = [], 0
    held: dict[Ref, str] = dict(named)
    for operation, place in registers(program):
        operands = [held.get(x, str(x)) for x in operation.operands]
        target = outputs[operation.result] if place is None else f"r{place}"
        count = max(count, 0 if place is None else place + 1)
        held[operation.result] = target
        call = f"{operation.function}({', '.join([*operands, target])})"
        lines.append(f"{target} = {call}  # {operation.result}")
    return count, [*lines, f"return {', '.join(outputs[value] for value in program.outputs.values())}"]


def numbers(program: Program) -> dict[Ref, str]:
    """The numbers of a program with their names in a block: `n2`, `n3_8`, `pi`, `sqrt_3`.

    NumPy gets them as arrays: it converts a Python number anew in every operation, which takes half as long as the
    operation itself on a small array.
    """
    used = (x for operation in program.operations for x in operation.operands)
    return {x: re.sub(r"\W+", "_", f"n{x}" if isinstance(x, Fraction) else x).strip("_") for x in used if is_number(x)}


def distinct(program: Program) -> dict[Ref, str]:
    """The values that the program puts out, each with the first output that has it."""
    return {value: name for name, value in reversed(program.outputs.items())}


def files(key: str, kernels: Mapping[str, Made]) -> dict[str, str]:
    """The module of a paper."""
    texts = [source(name, made) for name, made in kernels.items()]
    names = ", ".join(f'"{name}"' for name in sorted(kernels))
    special = ", ".join(name for name in RUNTIME if any(f"{name}(" in text for text in texts))
    special = f"from symcheck.kernels.ratios import {special}\n" if special else ""
    used = {x.function for made in kernels.values() for each in (made.program, made.pointwise) for x in each.operations}
    ufuncs = ", ".join(sorted(used - {*RUNTIME}))
    declared = "\n".join(declaration(name, made.kernel) for name, made in kernels.items())
    head = HEAD.format(key=key, mark=MARK, names=names, ufuncs=ufuncs, special=special, declared=declared)
    return {f"{key}.py": "\n\n".join([head, *texts])}


def declaration(name: str, kernel: Kernel) -> str:
    """What programs are told of a kernel, as an entry of DECLARED."""
    arguments, results = (
        textwrap.indent("\n".join(f"{(each.name, each.meaning, each.unit)!r}," for each in column), " " * 8)
        for column in (kernel.arguments, kernel.outputs)
    )
    return textwrap.indent(f"{name!r}: (\n    (\n{arguments}\n    ),\n    (\n{results}\n    ),\n),", "    ")


def calls(program: Program) -> str:
    """How a kernel is called."""
    count = len(program.outputs)
    equal = EQUAL if len(distinct(program)) < count else ""
    return f"{CALLS.format(f'{count} arrays' if count > 1 else 'an array')} {equal}"


TARGET = Target("NumPy, in generated/", files)


def handful(program: Program) -> int:
    """Up to how many points `math` takes less time for than NumPy."""
    inputs, outputs = len(program.inputs), len(distinct(program))
    weights = [MANY.get(operation.function, (1, 1)) for operation in program.operations]
    block = UFUNC * sum(ufuncs for ufuncs, _ in weights)
    begin = CALL + TAKEN * inputs + PUT * outputs
    each = POINT + FLOAT * sum(floats for _, floats in weights) + ARGUMENT * inputs + RESULT * len(program.outputs)
    return max((block - begin) // each, int(block + AGAIN * _in_place(program) > begin + each - SINGLE))


def _in_place(program: Program) -> int:
    """How many operations write over one of their operands."""
    held: dict[Ref, int | None] = {}
    count = 0
    for operation, place in registers(program):
        count += place is not None and place in [held.get(x) for x in operation.operands]
        held[operation.result] = place
    return count


def on_arrays(name: str, made: Made) -> Iterator[str]:
    """What is called for arrays of doubles of one shape, by their size."""
    program, inputs = made.program, ", ".join(made.program.inputs)
    equal = f", ({_order(program)},)" if len(distinct(program)) < len(program.outputs) else ""
    yield f"size = {program.inputs[0]}.size"
    if points := handful(made.pointwise):
        yield f"if 0 < size <= {points}:\n    return evaluate_handful(_{name}, ({inputs},){equal})"
    if made.pointwise.operations != program.operations:
        yield f"if size <= FEW:\n    return _{name}_few({inputs})"
    yield f"if size <= SMALL:\n    return _{name}_block({inputs})"
    yield f"return evaluate_alike({_block(name, program)})"


def _order(program: Program) -> str:
    """For each output, which of the distinct ones it is."""
    firsts = sorted(distinct(program).values(), key=list(program.outputs).index)
    return ", ".join(str(firsts.index(distinct(program)[value])) for value in program.outputs.values())


def _block(name: str, program: Program) -> str:
    count, _ = block_lines(program, numbers(program))
    return f"_{name}_block, {count}, ({_order(program)},), ({', '.join(program.inputs)},)"


def block(name: str, program: Program) -> str:
    """The text of a block; SymcheckError where a value would be no array, or an argument."""
    results = {operation.result for operation in program.operations}
    fixed = [name for name, value in program.outputs.items() if value not in results]
    fixed += [each.result for each in program.operations if all(map(is_number, each.operands))]
    if fixed:
        raise SymcheckError(f"the kernel {name}: {fixed[0]} is an argument or a number; leave it to the caller")
    used = numbers(program)
    count, lines = block_lines(program, used)
    outs = sorted(distinct(program).values(), key=list(program.outputs).index)
    rows = "".join(f", {row}=None" for row in [*(f"out_{x}" for x in outs), *(f"r{k}" for k in range(count))])
    taken = "".join(f", {text}=array({bare(number(x))})" for x, text in used.items())
    return f"def _{name}({', '.join(program.inputs)}{rows}{taken}):\n" + textwrap.indent("\n".join(lines), "    ")


def source(name: str, made: Made) -> str:
    """The text of one kernel."""
    program = made.program
    inputs = ", ".join(program.inputs)
    types = " is ".join(f"type({x})" for x in program.inputs)
    doubles = " is ".join(f"{x}.dtype" for x in program.inputs)
    shapes = " == ".join(f"{x}.shape" for x in program.inputs)
    shapes = f"() != {shapes}"  # arrays without dimensions give numbers
    blocks = [block(f"{name}_block", program)]
    if made.pointwise.operations != program.operations:
        blocks.insert(0, block(f"{name}_few", made.pointwise))
    return f"""def {name}({inputs}, out=None):
{textwrap.indent(docstring(made, calls(program)), "    ")}
    if out is None:
        try:
            if float is {types}:
                return _{name}({inputs})
            if ndarray is {types} and DOUBLE is {doubles} and {shapes}:
{textwrap.indent(chr(10).join(on_arrays(name, made)), " " * 16)}
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate({_block(name, program)}, out)


def _{name}({inputs}):
{textwrap.indent(chr(10).join(expression_lines(made.pointwise)), "    ")}


{(chr(10) * 3).join(blocks)}
"""
