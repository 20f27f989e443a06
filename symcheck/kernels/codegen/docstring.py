"""What a kernel that was declared says of itself, in whatever language it is written."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from symcheck.core.lazy import lazy
from symcheck.kernels import documentation
from symcheck.kernels.codegen.target import CompiledKernel
from symcheck.kernels.specification import Argument, Specification

if TYPE_CHECKING:
    from symcheck.kernels.codegen.kernel import Kernel

sp = lazy("sympy")
LINE = 112  # columns of a line in a docstring


def numpydoc(
    compiled: CompiledKernel,
    kind: str,
    notes: str,
    further: Mapping[str, tuple[str, str]] | None = None,
    examples: str = "",
) -> str:
    """The docstring of a kernel; `kind` is the type of arguments and results, `notes` say how it is called."""
    said = specification("", "", compiled)
    return documentation.numpydoc(said, "\n".join(formulas(compiled.kernel)), kind, notes, further, examples)


def specification(key: str, name: str, compiled: CompiledKernel) -> Specification:
    """What a module says of a kernel."""
    kernel = compiled.kernel
    return Specification(
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


def formulas(kernel: Kernel) -> list[str]:
    """What each output is."""
    derived = kernel.derived()
    return [f"{output.name} = {derived[output.name]}" for output in kernel.outputs]


def docstring(text: str) -> str:
    """A text as the docstring of a Python function."""
    return f'"""{text}\n"""'


def example(kernel: Kernel, name: str) -> str:
    """A call of the kernel on numbers, with the results to six digits."""
    point = _ordinary(kernel.arguments)
    derived = kernel.derived()
    texts = [f"{float(_value(derived[output.name], point)):.6g}" for output in kernel.outputs]
    call = filled(f"{name}(", [str(float(x)) for x in point.values()], ")", LINE - 30, "...     ")
    if len(texts) == 1:
        return f'>>> format({call}, ".6g")\n{texts[0]!r}'
    shown = f'>>> [f"{{x:.6g}}" for x in {call}]'
    results = filled("[", map(repr, texts), "]", LINE, " ")
    if "\n" not in results:
        return f"{shown}\n{results}"
    directive = "# doctest: +NORMALIZE_WHITESPACE"
    return (
        f"{shown}{f'  {directive}' if len(shown) < LINE - len(directive) else f'{chr(10)}... {directive}'}\n{results}"
    )


def filled(first: str, items: Iterable[str], last: str, width: int, indent: str) -> str:
    """A list in brackets, in lines that end between its items."""
    lines, every = [first], [*items]
    if not every:
        return first + last
    for k, item in enumerate(every):
        text = f"{item}," if k + 1 < len(every) else f"{item}{last}"
        if len(lines[-1]) + len(text) + 1 > width:
            lines.append(f"{indent}{text}")
        else:
            lines[-1] += text if lines[-1] in (first, indent) else f" {text}"
    return "\n".join(lines)


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
