"""A program as a kernel for Numba: a function of numbers, a loop over points that becomes vector code, and the call.

The loop takes its functions from `numba_functions`. A point where one of them returns NaN, as for a huge angle, is
computed again with those of the C library; single numbers are always computed with these.

Decision: the pointwise program, where other targets take that of many points: a sine and a cosine of one angle share
everything but the last step here, and take less time than a tangent and the roots and quotients that it needs.
"""

from __future__ import annotations

import inspect
import textwrap
from collections.abc import Iterator, Mapping
from fractions import Fraction
from types import FunctionType, ModuleType

import numpy as np

from symcheck.core.verdicts import SymcheckError
from symcheck.kernels import calling
from symcheck.kernels.calling import fitting
from symcheck.kernels.codegen import numba_calls, numba_functions
from symcheck.kernels.codegen.docstring import docstring, numpydoc
from symcheck.kernels.codegen.expression import number
from symcheck.kernels.codegen.program import INFIX, OF_HALF, Operation, Program, distinct, of_half, order_of
from symcheck.kernels.codegen.target import MARK, CompiledKernel, Target
from symcheck.kernels.documentation import KIND, calls, out_of

SINGLE = {"sqrt": "math.sqrt", "power": "math.pow", "gamma_ratio": "gamma_ratio", OF_HALF: OF_HALF}  # for loops, too
LIBRARY = {"arctan": "atan"}  # what `math` calls otherwise
BUILT_ON = {"log1p_ratio": "log1p", "expm1_ratio": "expm1"}
DOUBLE = ("sin", "cos", "tan", "arctan", "exp", "expm1", "log", "log1p")  # from the C library, and for loops
BLOCK = 1024  # points after which it is checked whether one of them is NaN
NOTE = "Numba compiles it when it is first called with a type; functions that Numba compiles may call it on numbers."
THREADS = ("int, optional", "Number of threads that share large arrays.")
HEAD = '''"""Kernels of {key} for Numba. {mark}"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import combinations
from typing import Any

import numpy as np
from numba import njit, types
from numba.core.cgutils import get_item_pointer
from numba.extending import intrinsic, overload

__all__ = [{names}]

{constants}


def exact(function):
    """Compiled into what calls it, every operation as it stands."""
    return njit(error_model="numpy", forceinline=True)(function)


def fused(function):
    """The same, where a product and a sum may become one operation, rounded once."""
    return njit(error_model="numpy", forceinline=True, fastmath={{"contract"}})(function)


def kept(function):
    """Compiled when it is first called, and kept in a file where Numba finds a folder for it."""
    try:
        return njit(error_model="numpy", nogil=True, cache=True)(function)
    except RuntimeError:  # there is no folder that can be written
        return njit(error_model="numpy", nogil=True)(function)


def callable_by_name(kernel, point):
    """Functions that Numba compiles may call a kernel, on numbers."""
    overload(kernel, jit_options={{"error_model": "numpy"}}, strict=False)(lambda *arguments: point)


def apart(builder, instruction, n):
    """Tell the compiler that array n of the arguments shares no memory with the others: then it makes vector code."""
    node = builder.module.add_metadata
    domain = node(["arguments of a kernel"])
    arrays = [node([f"argument {{k}}", domain]) for k in range(ARRAYS)]
    instruction.set_metadata("alias.scope", node([arrays[n]]))
    instruction.set_metadata("noalias", node([array for k, array in enumerate(arrays) if k != n]))


@intrinsic(prefer_literal=True)
def take(context, array, place, n):
    """array[place] as a double, where array is argument n."""

    def code(context, builder, signature, values):
        whole = context.make_array(array)(context, builder, values[0])
        value = builder.load(get_item_pointer(context, builder, array, whole, [values[1]]))
        apart(builder, value, n.literal_value)
        return context.cast(builder, value, array.dtype, types.float64)

    return types.float64(array, types.intp, n), code


@intrinsic(prefer_literal=True)
def put(context, array, place, n, value):
    """array[place] = value, where array is argument n."""

    def code(context, builder, signature, values):
        whole = context.make_array(array)(context, builder, values[0])
        rounded = context.cast(builder, values[3], types.float64, array.dtype)
        stored = builder.store(rounded, get_item_pointer(context, builder, array, whole, [values[1]]))
        apart(builder, stored, n.literal_value)
        return context.get_dummy_value()

    return types.void(array, types.intp, n, types.float64), code
'''


def files(key: str, kernels: Mapping[str, CompiledKernel]) -> dict[str, str]:
    """The module of a paper, which needs Numba and nothing else."""
    texts = [source(name, compiled) for name, compiled in kernels.items()]
    called = {
        operation.function for compiled in kernels.values() for operation in map(of_half, compiled.pointwise.operations)
    }
    mathematics = _functions(called | {BUILT_ON[name] for name in called & {*BUILT_ON}})
    functions = [_defined(calling)[fitting.__name__], *_defined(numba_calls).values()]
    names = ", ".join(f'"{name}"' for name in sorted(kernels))
    arrays = max(len(compiled.kernel.arguments) + len(compiled.kernel.outputs) for compiled in kernels.values())
    constants = "\n".join([f"ARRAYS = {arrays}", f"BLOCK = {BLOCK}", *_constants([*mathematics, *functions])])
    parts = [
        HEAD.format(key=key, mark=MARK, names=names, constants=constants),
        *(f"@fused\n{inspect.getsource(function)}" for function in mathematics),
        *map(inspect.getsource, functions),
        *texts,
    ]
    return {f"{key}.py": "\n\n".join(parts)}


TARGET = Target("Numba, a module for each paper that needs nothing else", files)


def _defined(module: ModuleType) -> dict[str, FunctionType]:
    """The functions of a module, in the order of the text."""
    found = {name: value for name, value in vars(module).items() if isinstance(value, FunctionType)}
    return {name: value for name, value in found.items() if value.__module__ == module.__name__}


def _functions(called: set[str]) -> list[FunctionType]:
    """Those of `numba_functions` that are called, with all that they call themselves."""
    defined, needed = _defined(numba_functions), set(called)
    for name in reversed(defined):  # each calls only what stands before it
        needed |= set(defined[name].__code__.co_names) if name in needed else set()
    return [function for name, function in defined.items() if name in needed]


def _constants(functions: list[FunctionType]) -> Iterator[str]:
    """The numbers that some functions use by name."""
    used = {
        name: function.__globals__[name]
        for function in functions
        for name in function.__code__.co_names
        if name.isupper()
    }
    for name, value in sorted(used.items()):
        yield f"{name} = {'np.' if isinstance(value, np.dtype) else ''}{value!r}"


def source(name: str, compiled: CompiledKernel) -> str:
    """The text of one kernel."""
    program = compiled.pointwise
    inputs, results = ", ".join(program.inputs), distinct(program)
    order = order_of(program)
    taken = sorted({_passed(operation.function) for operation in program.operations} - {""})
    library = [f"math.{LIBRARY.get(function, function)}" for function in taken]
    types = " is ".join(f"type({x})" for x in program.inputs)
    found = ", ".join(f"result_{k}" for k in range(len(results)))
    count = len(program.outputs)
    text = numpydoc(compiled, KIND, f"{calls(count)} {NOTE}", {"out": out_of(count), "threads": THREADS})
    return f"""def {name}({inputs}, out=None, *, threads=1):
{textwrap.indent(docstring(text), "    ")}
    if out is None and {types} is float:
        return _{name}_number({inputs})
    return evaluate(_{name}_points, {(*order,)}, ({inputs},), out, threads)


@exact
def _{name}({", ".join([*program.inputs, *taken])}):
{textwrap.indent(chr(10).join(map(_assignment, program.operations)), "    ")}
    return {", ".join(map(number, results))}


def _{name}_point({inputs}):
    {found} = _{name}({", ".join([*program.inputs, *library])})
    return {", ".join(f"result_{k}" for k in order)}


@kept
def _{name}_points({", ".join(f"in_{x}" for x in program.inputs)}, {", ".join(f"out_{x}" for x in results.values())}):
{textwrap.indent(chr(10).join(_loop(name, program, taken, library)), "    ")}


_{name}_number = kept(_{name}_point)
callable_by_name({name}, _{name}_point)
"""


def _passed(function: str) -> str:
    """The function that a loop and a number take from different places, "" where there is none."""
    return BUILT_ON.get(function, function if function in DOUBLE else "")


def _assignment(operation: Operation) -> str:
    operation = of_half(operation)
    function, operands = operation.function, [number(x) for x in operation.operands]
    if function in INFIX:
        return f"{operation.result} = {operands[0]} {INFIX[function]} {operands[1]}"
    if function == "negative":
        return f"{operation.result} = -{operands[0]}"
    if function == "power" and operation.operands[1] == Fraction(1, 4):  # two roots are instructions
        return f"{operation.result} = math.sqrt(math.sqrt({operands[0]}))"
    if function not in (*SINGLE, *BUILT_ON, *DOUBLE):
        raise SymcheckError(f"no function {function} for Numba; add it to symcheck/kernels/codegen/numba_functions.py")
    arguments = [*operands, *([BUILT_ON[function]] if function in BUILT_ON else [])]
    return f"{operation.result} = {SINGLE.get(function, function)}({', '.join(arguments)})"


def _loop(name: str, program: Program, taken: list[str], library: list[str]) -> Iterator[str]:
    """The lines of the loop over points."""
    results, count = distinct(program), len(program.inputs)
    numbers = [f"take(in_{x}, point, {n})" for n, x in enumerate(program.inputs)]
    new = [f"new_{x}" for x in results.values()]
    puts = [f"put(out_{x}, point, {n}, new_{x})" for n, x in enumerate(results.values(), count)]
    size = f"in_{program.inputs[0]}.size"
    if not taken:
        yield f"for point in range({size}):"
        yield f"    {', '.join(new)} = _{name}({', '.join(numbers)})"
        yield from (f"    {written}" for written in puts)
        return
    yield f"for begin in range(0, {size}, BLOCK):"
    yield f"    end = min(begin + BLOCK, {size})"
    yield "    missing = False"
    yield "    for point in range(begin, end):"
    yield f"        {', '.join(new)} = _{name}({', '.join([*numbers, *taken])})"
    yield from (f"        {written}" for written in puts)
    yield f"        missing |= {' or '.join(f'math.isnan({x})' for x in new)}"
    yield "    if missing:"
    yield "        for point in range(begin, end):"
    yield f"            if {' or '.join(f'math.isnan(out_{x}[point])' for x in results.values())}:"
    yield f"                {', '.join(new)} = _{name}({', '.join([*numbers, *library])})"
    yield from (f"                {written}" for written in puts)
