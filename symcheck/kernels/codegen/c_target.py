"""A program as a C function of arrays: one loop without branches, which compilers turn into vector instructions.

An argument that is the same at all points is an array too: a stride for each argument would take the loop its vector
loads. The caller fills a short array once and goes by pieces of its length, which stay in the cache.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Collection, Iterable, Mapping
from fractions import Fraction

from symcheck.core.verdicts import SymcheckError
from symcheck.kernels.codegen.c_functions import CIRCULAR, REACH, written
from symcheck.kernels.codegen.c_text import HEADER, LOOP, LOOP_AND_REST, PARALLEL, SOURCE, VECTORS
from symcheck.kernels.codegen.docstring import numpydoc
from symcheck.kernels.codegen.program import (
    INFIX,
    OF_HALF,
    UNARY,
    Operation,
    Program,
    Ref,
    is_number,
    of_half,
    under_root,
)
from symcheck.kernels.codegen.special import RUNTIME
from symcheck.kernels.codegen.target import MARK, CompiledKernel, Target

WORDS_OF_C = re.compile(  # and of the text around a kernel: far, i, libm, n
    "auto|break|case|char|const|continue|default|do|double|else|enum|extern|far|float|for|goto|i|if|inline|int|libm|long"
    "|n|register|restrict|return|short|signed|sizeof|static|struct|switch|typedef|union|unsigned|void|volatile|while"
)
C_NAMES = {"arctan": "atan", "power": "pow"}  # what C calls otherwise
VECTOR = ("atan", "exp", "expm1", "log", "log1p", "pow")  # functions of libm that glibc has for vectors too
WIDTH = 116  # of a line of a comment: 120 columns less its indentation
CALLS = "n is the number of points; the results go to the arrays that come last. NaN inputs give NaN outputs."


def files(key: str, kernels: Mapping[str, CompiledKernel]) -> dict[str, str]:
    """The header and the source of a paper."""
    bodies = [source(key, name, compiled.pointwise) for name, compiled in kernels.items()]
    functions = list(written("".join(bodies)))
    text = "\n".join([*functions, *bodies])
    vectors = [vector(name) for name in VECTOR if re.search(rf"\b{name}\(", text)]
    declared = "\n".join(
        f"{comment(compiled)}\n{signature(key, name, compiled.pointwise)};\n" for name, compiled in kernels.items()
    )
    head = [SOURCE.format(key=key, mark=MARK)]
    if vectors:
        head.append(VECTORS.format(declarations="\n".join(vectors)))
    return {
        f"{key}.h": HEADER.format(key=key, guard=key.upper(), mark=MARK, declarations=declared),
        f"{key}.c": "\n".join([*head, text]),
    }


TARGET = Target("C99, a header and a source for each paper", files)


def vector(name: str) -> str:
    """The declaration that a function of libm has vector forms."""
    operands = "double, double" if name == "pow" else "double"
    return f'__attribute__((simd("notinbranch"))) double {name}({operands});'


def alone(key: str, name: str, program: Program, uniform: Collection[str]) -> str:
    """The source of one kernel, of which some arguments are numbers instead of arrays."""
    body = source(key, name, program, uniform)
    text = "\n".join([*written(body), body])
    vectors = [vector(function) for function in VECTOR if re.search(rf"\b{function}\(", text)]
    head = [SOURCE.format(key=key, mark=MARK).replace(f'#include "{key}.h"', "#include <stddef.h>")]
    head += [VECTORS.format(declarations="\n".join(vectors))] if vectors else []
    return "\n".join([*head, text])


def signature(
    key: str, name: str, program: Program, restrict: str = "SYMCHECK_RESTRICT", uniform: Collection[str] = ()
) -> str:
    """The declaration of a kernel. C has no modules: the key of the paper sets kernels of the same name apart."""
    return _wrapped(f"void {key}_{name}(", ["size_t n", *_parameters(program, restrict, uniform)])


def source(key: str, name: str, program: Program, uniform: Collection[str] = ()) -> str:
    """The definition: what is computed at one point, in a loop; with angles apart from it, as the rest needs it too.

    What depends on `uniform` arguments alone, which are numbers, is computed before the loop.
    """
    _refuse_words_of_c(name, program)
    places = {x: f"{x}[i]" for x in program.inputs if x not in uniform}
    used = {x for operation in program.operations for x in operation.operands} | {*program.outputs.values()}
    fixed = {*uniform}
    before, lines = [], [f"(void){x};" for x in program.inputs if x not in used]
    varying = []
    for operation in program.operations:
        if all(is_number(x) or x in fixed for x in operation.operands):
            fixed.add(operation.result)
            before.append(statement(operation, places, CIRCULAR))
        else:
            varying.append(operation)
            lines.append(statement(operation, places))
    lines += [f"out_{x}[i] = {number(y, places)};" for x, y in program.outputs.items()]
    head = f"{signature(key, name, program, 'restrict', uniform)}\n{{\n"
    head += _indented([*before, ""], 4) if before else ""
    angles = dict.fromkeys(number(o.operands[0], places) for o in varying if o.function in CIRCULAR)
    if not angles:
        return f"{head}{LOOP.format(parallel=PARALLEL, body=_indented(lines, 8))}}}\n"
    lines.append(f"return {' | '.join(f'(fabs({x}) > {REACH})' for x in angles)};")
    needed = {x for o in varying for x in o.operands} | {*program.outputs.values()}
    more = [x for x in (o.result for o in program.operations) if x in fixed and x in needed]
    parameters = [*_parameters(program, "restrict", uniform), *(f"double {x}" for x in more)]
    point = _wrapped(f"static INLINE int64_t {name}_at(", ["size_t i", "int libm", *parameters])
    near, far = (_call(name, libm, program, more) for libm in (0, 1))
    loop = LOOP_AND_REST.format(parallel=PARALLEL, near=near, far=far)
    return f"{point}\n{{\n{_indented(lines, 4)}\n}}\n\n{head}{loop}}}\n"


def _call(name: str, libm: int, program: Program, more: Iterable[str]) -> str:
    arrays = [*program.inputs, *(f"out_{x}" for x in program.outputs), *more]
    return textwrap.indent(_wrapped(f"{name}_at(", ["i", str(libm), *arrays]), " " * 12).lstrip()


def _parameters(program: Program, restrict: str, uniform: Collection[str] = ()) -> list[str]:
    inputs = [f"double {x}" if x in uniform else f"const double *{restrict} {x}" for x in program.inputs]
    return inputs + [f"double *{restrict} out_{x}" for x in program.outputs]


def statement(operation: Operation, places: Mapping[str, str], of_libm: Collection[str] = ()) -> str:
    """One operation as a constant with its name; some functions are those of libm only."""
    operation = of_half(operation)
    operands = [number(x, places) for x in operation.operands]
    return f"const double {operation.result} = {_expression(operation.function, operands, of_libm)};"


def _expression(function: str, operands: list[str], of_libm: Collection[str] = ()) -> str:
    if function in INFIX:
        return f" {INFIX[function]} ".join(operands)
    if function == "negative":
        return f"-{operands[0]}"
    inside = ", ".join(operands)
    if function in CIRCULAR and function not in of_libm:
        return f"libm ? {function}({inside}) : vector_{function}({inside})"
    if function not in (*UNARY, *RUNTIME, OF_HALF, "power"):
        raise SymcheckError(f"{function} has no form in C; add it to symcheck/kernels/codegen/c_target.py")
    return f"{C_NAMES.get(function, function)}({inside})"


def number(x: Ref, places: Mapping[str, str]) -> str:
    """A number as C: `2.0`, `(3.0 / 8.0)`, `sqrt(3.0)`; an argument at its place `a[i]`; another name as it is."""
    if isinstance(x, Fraction):
        return f"{x.numerator}.0" if x.denominator == 1 else f"({x.numerator}.0 / {x.denominator}.0)"
    if (inside := under_root(x)) is not None:
        return f"sqrt({number(inside, places)})"
    return "3.141592653589793" if x == "pi" else places.get(x, x)


def comment(compiled: CompiledKernel) -> str:
    """What the function is, as a comment."""
    text = numpydoc(compiled, "array of n doubles", CALLS)
    return f"/** {textwrap.indent(text, '    ').lstrip()} */"


def _refuse_words_of_c(name: str, program: Program) -> None:
    """Names of arguments and results become names in C."""
    for each in (*program.inputs, *(operation.result for operation in program.operations)):
        if WORDS_OF_C.fullmatch(each) or each in (*UNARY, *RUNTIME, OF_HALF, *C_NAMES.values()):
            raise SymcheckError(f"kernel {name}: {each} means something else in its C text; give it another name")


def _indented(lines: Iterable[str], columns: int) -> str:
    return textwrap.indent("\n".join(lines), " " * columns)


def _wrapped(head: str, items: Iterable[str]) -> str:
    """A list in parentheses; lines end between its items."""
    text = f"{head}{', '.join(item.replace(' ', chr(0)) for item in items)})"
    return textwrap.fill(text, WIDTH, subsequent_indent="    ", break_long_words=False).replace(chr(0), " ")
