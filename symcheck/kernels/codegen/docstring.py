"""What a kernel says of itself, in whatever language it is written."""

from __future__ import annotations

import textwrap

from symcheck.kernels.codegen.kernel import Argument, Output
from symcheck.kernels.codegen.target import Made

WIDTH = 110


def paragraphs(made: Made, calls: str) -> list[str]:
    """What the function is, takes and returns, how it is called, how accurate it is, and on what it rests."""
    kernel, shown = made.kernel, made.kernel.derived()
    several = len(kernel.outputs) > 1
    formulas = [f"    {output.name} = {shown[output.name]}" for output in kernel.outputs]
    return [
        kernel.says,
        "\n".join(formulas),
        "\n".join(["Arguments:", *map(_argument, kernel.arguments)]),
        "\n".join([f"{'Returns a tuple' if several else 'Returns'}:", *map(_output, kernel.outputs)]),
        wrapped(calls),
        wrapped(f"Accuracy: {kernel.ulp} ulp over the domain. {kernel.condition} {kernel.degenerate}"),
        wrapped(made.evidence),
    ]


def docstring(made: Made, calls: str) -> str:
    """The same as the docstring of a Python function."""
    return '"""' + "\n\n".join(paragraphs(made, calls)) + '\n"""'


def wrapped(text: str) -> str:
    """A text in lines."""
    return textwrap.fill(" ".join(text.split()), WIDTH)


def _argument(each: Argument) -> str:
    return f"    {each.name}: {each.meaning}, {_unit(each.unit)}; {each.domain}"


def _output(each: Output) -> str:
    return f"    {each.name}: {each.meaning}, {_unit(each.unit)}"


def _unit(unit: str) -> str:
    return "a number" if unit == "1" else f"in {unit}"
