"""A program as a function of arrays of any library of the array API standard: PyTorch, JAX, CuPy, NumPy and others.

The text is pure and has no branch that depends on values, so that libraries can trace, fuse and differentiate it.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Mapping

from symcheck.core.verdicts import SymcheckError
from symcheck.kernels.codegen.docstring import docstring, numpydoc
from symcheck.kernels.codegen.expression import assignments, bare, number
from symcheck.kernels.codegen.program import UNARY, Operation, Program, Ref, is_number
from symcheck.kernels.codegen.target import MARK, CompiledKernel, Target
from symcheck.kernels.ratios import SHIFT, STIRLING, TINY

STANDARD = {"arctan": "atan", "power": "pow"}  # what the standard calls otherwise
CALLS = """At least one argument is an array, of float32 or float64. Its library computes, on its device and in its
type, or in float64 if there are arrays of both types. Arrays broadcast; each result has the broadcast shape; outputs
that are equal by formula may be one array. A TypeError names what does not fit. NaN inputs give NaN outputs."""

HEAD = '''"""Kernels of {key} for PyTorch, JAX, CuPy, NumPy and other libraries of the array API standard. {mark}

Needs array-api-compat. The functions are pure and have no branch that depends on values: jax.jit, jax.grad, jax.vmap,
torch.compile and torch.autograd take them as they are. The accuracy that they state takes a library whose functions
err by one unit in the last place. XLA takes subnormal numbers for 0 on a CPU, and in some versions its log1p errs by
129 units near -0.41.
"""

import math

from array_api_compat import array_namespace, device, is_jax_array

__all__ = [{names}]


def _arrays(**arguments):
    """The library of the arguments, what makes an array of a number there, and the arguments as arrays of one type."""
    given = {{name: x for name, x in arguments.items() if not isinstance(x, (int, float))}}
    if not given:
        raise TypeError(f"{{', '.join(arguments)}} are numbers; make one an array, whose library shall compute")
    for name, x in given.items():
        if not hasattr(x, "dtype"):
            raise TypeError(f"{{name}} is {{x!r}}; an array of float32 or float64, or a real number, is needed")
    xp = array_namespace(*given.values())
    for name, x in given.items():
        if x.dtype not in (xp.float32, xp.float64):
            raise TypeError(f"{{name}} is an array of {{x.dtype}}; convert it to float32 or float64")
    first, dtype = next(iter(given.values())), xp.result_type(*given.values())
    place = None if is_jax_array(first) else device(first)  # JAX brings a number to its arrays, on several devices too

    def number(x):
        return xp.full((), float(x), dtype=dtype, device=place)

    arrays = (xp.astype(x, dtype, copy=False) if name in given else number(x) for name, x in arguments.items())
    return xp, number, *arrays
'''

HELPERS = {
    "full": '''def full(xp, x, *arguments):
    """x in the shape to which the arguments broadcast, in new memory."""
    shape = xp.broadcast_arrays(*arguments)[0].shape
    return x if x.shape == shape else 1.0 * xp.broadcast_to(x, shape)
''',
    "expm1_ratio": '''def expm1_ratio(xp, x):
    """(exp(x) - 1)/x, continued by 1 at 0."""
    return quotient(xp, xp.expm1, x, [1.0 / math.factorial(k + 1) for k in range(10)])
''',
    "log1p_ratio": '''def log1p_ratio(xp, x):
    """log(1 + x)/x for x > -1, continued by 1 at 0 and by a number that is not 0 at infinity."""
    largest = float(xp.finfo(x.dtype).max)
    x = xp.where(x > largest, largest, x)
    return quotient(xp, xp.log1p, x, [(-1.0) ** k / (k + 1) for k in range(13)])
''',
    "quotient": '''def quotient(xp, function, x, series):
    """function(x)/x, near 0 by its series: there the quotient is 0/0, and its derivatives lose digits.

    where() differentiates both forms, so each gets arguments at which it and its derivatives are finite.
    """
    near = abs(x) < 0.03125
    inside, total = xp.where(near, x, 0.0), series[-1]
    for coefficient in series[-2::-1]:
        total = total * inside + coefficient
    outside = xp.where(near, 1.0, x)
    return xp.where(near, total, function(outside) / outside)
''',
    "gamma_ratio": f'''def gamma_ratio(xp, x, h):
    """Gamma(x + h)/(Gamma(x) x^h) for positive x and x + h: 1 at infinity; NaN for others, and for subnormal x.

    Where x or x + h is small the functional equation moves both up by {SHIFT}, to where Stirling's series holds.
    """
    x = xp.where((x >= 4.0 * float(xp.finfo(x.dtype).smallest_normal)) & (x + h > 0.0), x, xp.nan)
    x = xp.where(x > {1 / TINY!r}, {1 / TINY!r}, x)  # beyond, the ratio is 1
    small = (x < {SHIFT}.0) | (x + h < {SHIFT}.0)
    near, step = xp.where(small, x, 1.0), xp.where(small, h, 0.0)
    above, under = near, near + step
    for k in range(1, {SHIFT}):
        above, under = above * (near + k), under * (near + step + k)
    moved = xp.where(small, x + {SHIFT}.0, x)
    logarithm = (moved + (h - 0.5)) * xp.log1p(h / moved) - h + (stirling(xp, moved + h) - stirling(xp, moved))
    return xp.exp(logarithm) * xp.where(small, ((near + {SHIFT}.0) / near) ** step * (above / under), 1.0)
''',
    "root": '''def root(xp, x):
    """The square root of x, with the derivative 0 at 0.

    A root of a product or quotient that is 0 by one argument stays 0 whatever the others are: so their derivatives are
    0, and not infinity times 0.
    """
    zero = x == 0.0
    return xp.where(zero, 0.0, xp.sqrt(xp.where(zero, 1.0, x)))
''',
    "stirling": f'''def stirling(xp, x):
    """log Gamma(x) less (x - 1/2) log x - x + log(2 pi)/2, for large x."""
    inverse = 1.0 / x
    square, total = inverse * inverse, {STIRLING[-1]!r}
    for coefficient in {STIRLING[-2::-1]!r}:
        total = total * square + coefficient
    return total * inverse
''',
}


def files(key: str, kernels: Mapping[str, CompiledKernel]) -> dict[str, str]:
    """The module of a paper."""
    texts = [source(name, compiled) for name, compiled in kernels.items()]
    names = ", ".join(f'"{name}"' for name in sorted(kernels))
    head = HEAD.format(key=key, mark=MARK, names=names)
    return {f"{key}.py": "\n\n".join([head, *helpers("".join(texts)), *texts])}


TARGET = Target("PyTorch, JAX, CuPy and any library of the array API standard", files)


def helpers(text: str) -> Iterator[str]:
    """The helpers that a text calls, and those that these call."""
    for name, helper in HELPERS.items():
        if f"{name}(xp" in text:
            text += helper
            yield helper


def source(name: str, compiled: CompiledKernel) -> str:
    """The text of one kernel."""
    inputs = compiled.program.inputs
    pairs = ", ".join(f"{x}={x}" for x in inputs)
    text = docstring(numpydoc(compiled, "array or float", CALLS))
    lines = [text, f"xp, number, {', '.join(inputs)} = _arrays({pairs})", *statements(compiled.program)]
    return f"def {name}({', '.join(inputs)}):\n{textwrap.indent(chr(10).join(lines), '    ')}\n"


def statements(program: Program) -> Iterator[str]:
    """The program as assignments, and what it returns.

    A library that computes at once can give the memory of a value without a name back at once.
    """
    lines, results = assignments(program, _call, array)
    yield from lines
    reached, every = dependencies(program), ", ".join(program.inputs)
    pairs = zip(results, program.outputs.values(), strict=True)
    wholes = [text if reached.get(x, set()) >= {*program.inputs} else f"full(xp, {text}, {every})" for text, x in pairs]
    yield f"return {', '.join(wholes)}"


def dependencies(program: Program) -> dict[Ref, set[Ref]]:
    """The arguments that each value depends on."""
    found: dict[Ref, set[Ref]] = {x: {x} for x in program.inputs}
    for operation in program.operations:
        found[operation.result] = set().union(*(found.get(x, set()) for x in operation.operands))
    return found


def _call(operation: Operation, operands: list[str]) -> str:
    function, inside = operation.function, ", ".join(operands)
    if function in HELPERS:
        return f"{function}(xp, {inside})"
    if function == "sqrt":
        return f"root(xp, {inside})"
    if function in (*UNARY, "power"):
        return f"xp.{STANDARD.get(function, function)}({inside})"
    raise SymcheckError(f"the array target knows no function {function}; add it to HELPERS, or to STANDARD")


def array(x: Ref) -> str:
    """A number as an array; a name as it is."""
    return f"number({bare(number(x))})" if is_number(x) else str(x)
