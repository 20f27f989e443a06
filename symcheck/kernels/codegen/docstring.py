"""What a kernel says of itself, in whatever language it is written: the sections of a numpydoc docstring."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from symcheck.core.lazy import lazy
from symcheck.kernels.codegen.target import CompiledKernel
from symcheck.kernels.specification import Argument, Output

if TYPE_CHECKING:
    from symcheck.kernels.codegen.kernel import Kernel

sp = lazy("sympy")
WIDTH = 110  # columns of a text, which stands four columns in


def numpydoc(
    compiled: CompiledKernel,
    kind: str,
    notes: str,
    further: Mapping[str, tuple[str, str]] | None = None,
    examples: str = "",
) -> str:
    """What the function is, takes and returns, how accurate it is, on what it rests, and an example.

    kind     the type of arguments and results
    notes    how the function is called
    further  type and meaning of arguments that are not the kernel's
    """
    kernel = compiled.kernel
    takes = [_entry(argument.name, kind, f"{_meaning(argument)}; {argument.domain}.") for argument in kernel.arguments]
    takes += [_entry(name, *each) for name, each in (further or {}).items()]
    gives = [_entry(each.name, kind, f"{_meaning(each)}.") for each in kernel.outputs]
    derived = kernel.derived()
    formulas = [f"    {output.name} = {derived[output.name]}" for output in kernel.outputs]
    accuracy = f"Accuracy: {kernel.ulp} ulp over the domain. {kernel.condition} {kernel.degenerate}"
    parts = [
        kernel.says,
        _section("Parameters", "\n".join(takes)),
        _section("Returns", "\n".join(gives)),
        _section("Notes", "The function computes ::"),
        "\n".join(formulas),
        wrapped(accuracy),
        wrapped(notes),
        wrapped(compiled.evidence),
        _section("Examples", examples) if examples else "",
    ]
    return "\n\n".join(filter(None, parts))


def docstring(text: str) -> str:
    """A text as the docstring of a Python function."""
    return f'"""{text}\n"""'


def wrapped(text: str) -> str:
    """A text in lines."""
    return textwrap.fill(" ".join(text.split()), WIDTH)


def example(kernel: Kernel, module: str, name: str) -> str:
    """A call of the kernel on numbers, with the results to six digits."""
    point = _ordinary(kernel.arguments)
    derived = kernel.derived()
    texts = [f"{float(_value(derived[output.name], point)):.6g}" for output in kernel.outputs]
    call = f"{name}({', '.join(str(float(x)) for x in point.values())})"
    shown = f'f"{{{call}:.6g}}"' if len(texts) == 1 else f'[f"{{x:.6g}}" for x in {call}]'
    return f">>> from {module} import {name}\n>>> {shown}\n{(texts[0] if len(texts) == 1 else texts)!r}"


def _value(expression: Any, point: Mapping[str, Fraction]) -> Any:
    """The value of an expression at a point, whatever its letters are assumed to be."""
    letters = {x: sp.Rational(point[x.name]) for x in expression.free_symbols if x.name in point}
    return sp.N(expression.subs(letters), 30)


def _ordinary(arguments: tuple[Argument, ...]) -> dict[str, Fraction]:
    """A point of the domain, of numbers with two digits; ends that are other arguments come after these."""
    found: dict[str, Fraction] = {}
    waiting = list(arguments)
    while waiting:
        argument = waiting.pop(0)
        low, high = (_value(sp.sympify(end), found) if end else None for end in (argument.low, argument.high))
        if any(end is not None and not end.is_number for end in (low, high)):
            waiting.append(argument)
            continue
        part = Fraction(len(found) + 1, len(arguments) + 1)
        first = float(low) if low is not None else float(high) - 1 if high is not None else 1.0
        last = float(high) if high is not None else first + 1
        found[argument.name] = Fraction(round(100 * (first + (last - first) * part)), 100)
    return {argument.name: found[argument.name] for argument in arguments}


def _section(name: str, text: str) -> str:
    return f"{name}\n{'-' * len(name)}\n{text}"


def _entry(name: str, kind: str, text: str) -> str:
    lines = textwrap.wrap(text, WIDTH - 4, initial_indent="    ", subsequent_indent="    ")
    return "\n".join([f"{name} : {kind}", *lines])


def _meaning(value: Argument | Output) -> str:
    text = f"{value.meaning[0].upper()}{value.meaning[1:]}" if value.meaning.split()[0].isalpha() else value.meaning
    return f"{text}, {'a number' if value.unit == '1' else f'in {value.unit}'}"
