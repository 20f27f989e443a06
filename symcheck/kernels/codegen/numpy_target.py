"""A program as a NumPy kernel: a formula of floats to read and to copy, under a decorator that takes arrays.

`<key>.py` has the formulas and what is known of them, `<key>.pyi` their types. Where acute angles go through their
tangent, which takes less time for many points, a second formula says so.
"""

from __future__ import annotations

import json
import re
import textwrap
from collections.abc import Iterator, Mapping
from dataclasses import fields

from symcheck.core.verdicts import SymcheckError
from symcheck.kernels.codegen.docstring import example, filled, formulas
from symcheck.kernels.codegen.expression import assignments
from symcheck.kernels.codegen.program import Program, is_number
from symcheck.kernels.codegen.special import RUNTIME
from symcheck.kernels.codegen.target import MARK, CompiledKernel, Target
from symcheck.kernels.specification import Argument, Output

WIDTH = 120  # columns of a line
MODULE = '''"""Kernels of {key}. {mark}"""

{imports}

__all__ = [
{names}
]


{functions}


KERNELS = {{
{table}
}}
'''
MANY = '''@for_arrays({name})
def _{name}({inputs}):
    """The same for many points: an acute angle goes through its tangent, which takes less time there."""
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


def files(key: str, kernels: Mapping[str, CompiledKernel]) -> dict[str, str]:
    """The module of a paper, and the types of its kernels."""
    functions = "\n\n\n".join(text for name, compiled in kernels.items() for text in texts(name, compiled))
    names = "\n".join(f'    "{name}",' for name in sorted(kernels))
    table = "\n".join(f'    "{name}": {name},' for name in kernels)
    head = {"key": key, "mark": MARK}
    return {
        f"{key}.py": MODULE.format(
            **head, imports="\n".join(_imports(functions)), names=names, functions=_plain(functions), table=table
        ),
        f"{key}.pyi": STUB.format(
            **head, functions="\n".join(stub(name, compiled) for name, compiled in kernels.items())
        ),
    }


TARGET = Target("NumPy, in generated/", files)


def _imports(functions: str) -> Iterator[str]:
    """What a module takes from elsewhere."""
    used = sorted(set(re.findall(r"\bmath\.(\w+)", functions)))
    yield from [f"from math import {', '.join(used)}", ""] if used else []
    ratios = [name for name in RUNTIME if re.search(rf"\b{name}\(", functions)]
    yield from [f"from symcheck.kernels.ratios import {', '.join(ratios)}"] if ratios else []
    more = "for_arrays, " if "@for_arrays" in functions else ""
    yield f"from symcheck.kernels.runtime import Argument, Output, {more}kernel"


def _plain(functions: str) -> str:
    """The text with the functions of `math` by their names."""
    return functions.replace("math.", "")


def texts(name: str, compiled: CompiledKernel) -> Iterator[str]:
    """The formula of a kernel, and the one for many points where it is another."""
    _refuse_fixed(name, compiled.program)
    inputs = ", ".join(compiled.program.inputs)
    lines = [_docstring(name, compiled), *body(compiled.pointwise)]
    head = _long(f"def {name}(", [*compiled.program.inputs], "):")
    yield "\n".join([_decorator(compiled), head, textwrap.indent("\n".join(lines), "    ")])
    if compiled.pointwise.operations != compiled.program.operations:
        text = MANY.format(name=name, inputs=inputs)
        yield text + textwrap.indent("\n".join(body(compiled.program)), "    ")


def body(program: Program) -> Iterator[str]:
    """The lines of a formula, with a name for each output that has none."""
    lines, results = assignments(program)
    lines = [*map(_broken, lines)]
    named = {*program.inputs, *(operation.result for operation in program.operations)}
    shown = []
    for output, text in zip(program.outputs, results, strict=True):
        if len(results) > 1 and not text.isidentifier() and output not in named:
            lines.append(_broken(f"{output} = {text}"))
            text = output
        shown.append(text)
    yield from lines
    yield _broken(f"return {shown[0]}") if len(shown) == 1 else _long("return ", shown, "")


def _broken(line: str) -> str:
    """A statement, in several lines where it is long."""
    if len(_plain(line)) <= WIDTH - 4:
        return line
    first, _, expression = line.partition(" = ") if " = " in line else line.partition(" ")
    sign = " = (" if " = " in line else " ("
    broken = textwrap.fill(expression, WIDTH - 8, break_long_words=False, break_on_hyphens=False)
    return f"{first}{sign}\n{textwrap.indent(broken, '    ')}\n)"


def _long(first: str, items: list[str], last: str) -> str:
    """A list between two texts, in several lines where it is long."""
    line = f"{first}{', '.join(items)}{last}"
    if len(line) <= WIDTH - 4:
        return line
    opened, closed = ("(", ")") if first == "return " else ("", "")
    inside = filled("    ", items, ",", WIDTH - 4, "    ")
    return f"{first}{opened}\n{inside}\n{closed}{last}"


def _docstring(name: str, compiled: CompiledKernel) -> str:
    """The sentence, the formulas and an example; the decorator adds what its data say."""
    lines = [_wrapped(line) for line in formulas(compiled.kernel)]
    shown = example(compiled.kernel, name)
    return f'"""{_wrapped(compiled.kernel.says)}\n\n{chr(10).join(lines)}\n\n{shown}\n"""'


def _wrapped(line: str) -> str:
    return textwrap.fill(line, WIDTH - 8, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False)


def _decorator(compiled: CompiledKernel) -> str:
    kernel = compiled.kernel
    lines = [*map(_declared, kernel.arguments), *map(_declared, kernel.outputs)]
    lines.append(f"ulp={kernel.ulp}")
    for field in ("condition", "degenerate"):
        if text := " ".join(str(getattr(kernel, field)).split()):
            lines.append(_text(f"{field}=", text))
    claims = [f"{_quoted(id.partition(':')[2])}: {_quoted(digest)}" for id, digest in compiled.claims.items()]
    lines.append(filled("claims={", claims, "}", WIDTH - 6, "    "))
    lines += [f"forms={_quoted(compiled.forms)}"] if compiled.forms else []
    return f"@kernel(\n{textwrap.indent(''.join(f'{line},{chr(10)}' for line in lines), '    ')})"


def _text(first: str, text: str) -> str:
    """A string, in several lines where it is long."""
    if len(line := f"{first}{_quoted(text)}") <= WIDTH - 6:
        return line
    parts = textwrap.wrap(text, WIDTH - 14, drop_whitespace=False, break_on_hyphens=False)
    return f"{first}(\n{textwrap.indent(chr(10).join(map(_quoted, parts)), '    ')}\n)"


def _declared(each: Argument | Output) -> str:
    """An argument or an output, with what differs from the defaults."""
    texts = [_quoted(each.name), _quoted(each.meaning)]
    for field in fields(each)[2:]:
        value = vars(each)[field.name]
        if value != field.default:
            text = _quoted(value) if isinstance(value, str) else repr(value)
            texts.append(text if field.name == "unit" else f"{field.name}={text}")
    return filled(f"{type(each).__name__}(", texts, ")", WIDTH - 6, "    ")


def _quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False)


def _refuse_fixed(name: str, program: Program) -> None:
    """SymcheckError where a value would be no array, or an argument."""
    results = {operation.result for operation in program.operations}
    fixed = [name for name, value in program.outputs.items() if value not in results]
    fixed += [each.result for each in program.operations if all(map(is_number, each.operands))]
    if fixed:
        raise SymcheckError(f"the kernel {name}: {fixed[0]} is an argument or a number; leave it to the caller")


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
