"""A generated kernel as other targets write it: from its formula as it stands, without what it was derived from."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from symcheck.kernels.codegen.kernel import Kernel
from symcheck.kernels.codegen.program import Operation, Program, Ref
from symcheck.kernels.codegen.target import CompiledKernel
from symcheck.kernels.specification import KernelFunction
from symcheck.kernels.tracing import Trace


def compiled(function: KernelFunction) -> CompiledKernel:
    """The kernel with its program, and with what its module says of it.

    >>> from symcheck.kernels import find
    >>> compiled(find("ignatov2005", "volume_of_three_wheels")).pointwise.inputs
    ('a', 'b')
    """
    said = function.specification
    whole = program(
        function.ways.traced(), [each.name for each in said.arguments], [each.name for each in said.outputs]
    )
    kernel = Kernel(
        says=said.says,
        arguments=said.arguments,
        outputs=said.outputs,
        derived=lambda: {each.name: "see its module" for each in said.outputs},
        claims=tuple(said.claims),
        ulp=said.ulp,
        condition=said.condition,
        degenerate=said.degenerate,
    )
    return CompiledKernel(kernel, whole, whole, said.claims, said.forms)


def program(traced: Trace, inputs: Iterable[str], outputs: Iterable[str]) -> Program:
    """The operations with names; numbers are fractions, as exact as they are."""
    names = [*inputs]
    first = next(each for each in ("t", "step", "value_") if not any(x.startswith(each) for x in names))
    names += [f"{first}{k}" for k in range(len(traced.steps))]

    def ref(x: int | float) -> Ref:
        return Fraction(x) if type(x) is float else names[int(x)]

    found = Program(tuple(names[: traced.arity]))
    for place, step in enumerate(traced.steps, traced.arity):
        found.operations.append(Operation(names[place], step.function, tuple(map(ref, step.operands))))
    found.outputs.update(zip(outputs, map(ref, traced.outputs), strict=True))
    return found
