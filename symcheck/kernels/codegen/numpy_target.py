"""A program as a NumPy kernel: a formula of floats to read and to copy, and beside it a block of ufuncs in place.

`<key>.py` has the formulas and what is known of them, `_<key>.py` how they run on arrays, `<key>.pyi` their types.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import MISSING, fields
from fractions import Fraction

from symcheck.core.verdicts import SymcheckError
from symcheck.kernels.codegen.docstring import docstring, example, numpydoc
from symcheck.kernels.codegen.expression import bare, body, number
from symcheck.kernels.codegen.program import Program, Ref, distinct, is_number, order_of, registers
from symcheck.kernels.codegen.special import RUNTIME
from symcheck.kernels.codegen.target import MARK, CompiledKernel, Target
from symcheck.kernels.specification import Argument, Output, Specification

KIND = "float or ndarray"
CALLS = """Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit."""
EQUAL = "Outputs that are equal by formula are one array, unless `out` is given."
OUT = "{} for the results, of the broadcast shape and type."
FORMULAS = '''"""Kernels of {key}. {mark}"""

import math

{special}from symcheck.generated import _{key} as paths
from symcheck.kernels.runtime import kernel
from symcheck.kernels.specification import Argument, Output, Specification

__all__ = [
{names}
]


{functions}


KERNELS = {{
{table}
}}
'''
PATHS = '''"""How the kernels of {key} run on numbers and on arrays. {mark}"""

# mypy: ignore-errors
import math

from numpy import array, ndarray, {ufuncs}

{special}from symcheck.kernels.runtime import DOUBLE, FEW, SMALL, UNDEFINED, on_arrays


{functions}
'''
STUB = '''"""Types of the kernels of {key}. {mark}"""

# mypy: disable-error-code="overload-overlap"
from collections.abc import Mapping, Sequence
from typing import overload

from symcheck.kernels.runtime import Array, Values
from symcheck.kernels.specification import KernelFunction

KERNELS: Mapping[str, KernelFunction]

{functions}
'''
# Nanoseconds, measured. NumPy: an operation on few points; what it takes longer to write one element over its operand.
UFUNC, AGAIN = 250, 550
# One by one with `math`: the whole, an argument, an output; what a single point takes less for.
CALL, TAKEN, PUT, SINGLE = 1100, 75, 330, 450
# Each point, its operations, arguments and outputs.
POINT, FLOAT, ARGUMENT, RESULT = 100, 7, 11, 55
MANY = {"gamma_ratio": (110, 250), "log1p_ratio": (9, 25), "expm1_ratio": (7, 20)}  # operations of NumPy, of `math`


def files(key: str, kernels: Mapping[str, CompiledKernel]) -> dict[str, str]:
    """The modules of a paper, and the types of its kernels."""
    programs = [program for compiled in kernels.values() for program in (compiled.program, compiled.pointwise)]
    used = {operation.function for program in programs for operation in program.operations}
    ratios = ", ".join(sorted(used & {*RUNTIME}))
    common = {"key": key, "mark": MARK, "special": f"from symcheck.kernels.ratios import {ratios}\n" if ratios else ""}
    formulas = "\n\n\n".join(formula(key, name, compiled) for name, compiled in kernels.items())
    names = "\n".join(f'    "{name}",' for name in sorted(kernels))
    table = "\n".join(f'    "{name}": {name},' for name in kernels)
    return {
        f"{key}.py": FORMULAS.format(**common, names=names, functions=formulas, table=table),
        f"_{key}.py": PATHS.format(
            **common,
            ufuncs=", ".join(sorted(used - {*RUNTIME})),
            functions="\n\n\n".join(text for name, compiled in kernels.items() for text in paths(name, compiled)),
        ),
        f"{key}.pyi": STUB.format(
            **common, functions="\n".join(stub(name, compiled) for name, compiled in kernels.items())
        ),
    }


TARGET = Target("NumPy, in generated/", files)


def formula(key: str, name: str, compiled: CompiledKernel) -> str:
    """The text of one kernel: what is known of it, and the function of floats."""
    shown = example(compiled.kernel, f"symcheck.generated.{key}", name)
    text = numpydoc(compiled, KIND, calls(compiled.program), {"out": out_of(compiled.program)}, shown)
    lines = "\n".join([docstring(text), *body(compiled.pointwise)])
    inputs = ", ".join(compiled.program.inputs)
    return f"{_decorator(key, name, compiled)}\ndef {name}({inputs}):\n{textwrap.indent(lines, '    ')}"


def calls(program: Program) -> str:
    """How a kernel is called."""
    return f"{CALLS} {EQUAL if len(distinct(program)) < len(program.outputs) else ''}"


def out_of(program: Program) -> tuple[str, str]:
    """Type and meaning of the argument `out`."""
    count = len(program.outputs)
    kind, arrays = ("ndarray", "Array") if count == 1 else ("sequence of ndarray", f"{count} arrays")
    return f"{kind}, optional", OUT.format(arrays)


def _decorator(key: str, name: str, compiled: CompiledKernel) -> str:
    kernel = compiled.kernel
    said = Specification(
        paper=key,
        name=name,
        says=kernel.says,
        arguments=kernel.arguments,
        outputs=kernel.outputs,
        ulp=kernel.ulp,
        condition=" ".join(kernel.condition.split()),
        degenerate=" ".join(kernel.degenerate.split()),
        claims=compiled.claims,
        forms=compiled.forms,
    )
    return f"@kernel(\n    paths.{name},\n{textwrap.indent(literal(said), '    ')},\n)"


def literal(value: object) -> str:
    """A value as Python, with what differs from the defaults."""
    if isinstance(value, Specification | Argument | Output):
        stated = {field: vars(value)[field.name] for field in fields(value)}
        texts = [
            f"{f'{each.name}=' if each.kw_only or each.default is not MISSING else ''}{literal(given)}"
            for each, given in stated.items()
            if given != each.default
        ]
        name = type(value).__name__
        return _bracketed(f"{name}(", texts, ")") if isinstance(value, Specification) else f"{name}({', '.join(texts)})"
    if isinstance(value, tuple):
        return _bracketed("(", map(literal, value), ")")
    if isinstance(value, Mapping):
        return _bracketed("{", (f"{literal(key)}: {literal(each)}" for key, each in value.items()), "}")
    return repr(value)


def _bracketed(first: str, texts: Iterable[str], last: str) -> str:
    return f"{first}\n{textwrap.indent(''.join(f'{text},{chr(10)}' for text in texts), '    ')}{last}"


def stub(name: str, compiled: CompiledKernel) -> str:
    """The types of one kernel: floats give floats, arrays give arrays."""
    count = len(compiled.kernel.outputs)

    def result(kind: str) -> str:
        return kind if count == 1 else f"tuple[{', '.join([kind] * count)}]"

    def takes(kind: str) -> str:
        return ", ".join(f"{x}: {kind}" for x in compiled.program.inputs)

    out = "Array | None" if count == 1 else "Sequence[Array] | None"
    return (
        f"@overload\ndef {name}({takes('float')}) -> {result('float')}: ...\n"
        f"@overload\ndef {name}({takes('Values')}, *, out: {out} = None) -> {result('Array')}: ..."
    )


def paths(name: str, compiled: CompiledKernel) -> Iterator[str]:
    """The texts of one kernel's ways on numbers and arrays: its call, and its blocks."""
    program, few = compiled.program, compiled.pointwise.operations != compiled.program.operations
    inputs = ", ".join(program.inputs)
    first, fewest = program.inputs[0], handful(compiled.pointwise)
    types, dtypes, shapes = (
        form.join(text.format(x) for x in program.inputs)
        for form, text in ((" is ", "type({})"), (" is ", "{}.dtype"), (" == ", "{}.shape"))
    )
    count, _ = block_lines(program, numbers(program))
    small = f"_{name}_few" if few else f"_{name}"
    order = ", ".join(map(str, order_of(program)))
    further = f"{count}, ({order},), {fewest}"
    yield f"""def {name}(formula):
    \"\"\"The function of numbers and arrays that a formula becomes.\"\"\"
    alike, others = on_arrays(formula, _{name}, {further})

    def call({inputs}, out=None):
        if out is None:
            if float is {types}:
                try:
                    return formula({inputs})
                except UNDEFINED:
                    pass
            elif ndarray is {types} and DOUBLE is {dtypes} and () != {shapes}:
                if {fewest} < {first}.size <= {"FEW" if few else "SMALL"}:
                    return {small}({inputs})
                return alike({inputs})
        return others(({inputs},), out)

    return call"""
    if few:
        yield block(f"{name}_few", compiled.pointwise)
    yield block(name, program)


def block(name: str, program: Program) -> str:
    """The text of a block; SymcheckError where a value would be no array, or an argument."""
    results = {operation.result for operation in program.operations}
    fixed = [name for name, value in program.outputs.items() if value not in results]
    fixed += [each.result for each in program.operations if all(map(is_number, each.operands))]
    if fixed:
        raise SymcheckError(f"the kernel {name}: {fixed[0]} is an argument or a number; leave it to the caller")
    used = numbers(program)
    count, lines = block_lines(program, used)
    outs = (f"out_{x}" for x in distinct(program).values())
    rows = "".join(f", {row}=None" for row in [*outs, *(f"r{k}" for k in range(count))])
    taken = "".join(f", {text}=array({bare(number(x))})" for x, text in used.items())
    return f"def _{name}({', '.join(program.inputs)}{rows}{taken}):\n" + textwrap.indent("\n".join(lines), "    ")


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
