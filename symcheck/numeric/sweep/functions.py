"""The functions that can be swept: kernels by paper, and what is declared with a signature in the numeric layer."""

from __future__ import annotations

import inspect
import pkgutil
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from difflib import get_close_matches
from functools import cache
from hashlib import blake2b
from importlib import import_module
from pathlib import Path
from typing import NamedTuple, get_type_hints

import numpy as np

import symcheck.numeric
from symcheck import kernels
from symcheck.numeric.chunked import results_of
from symcheck.numeric.chunked.arrays import Axes, Function, Signature
from symcheck.numeric.chunked.kernels import declaration, kernel

OF_ENSEMBLE = {"seed", "first", "paths"}  # arguments that the sweep supplies
REALIZATION = "realization"
SIMILARITY = 0.4  # of a function's name: "liquid.growth" still suggests "liquid.growth_rate"


class SweepError(ValueError):
    """What keeps a sweep from going on, in words for whoever wrote it."""


class Swept(NamedTuple):
    """A function that can be swept.

    call         the function, of arguments by name
    arguments    last axes of its array arguments; None where it takes the result of another function
    others       names of further arguments, including those that the sweep supplies
    required     names of arguments without a default
    outputs      last axes of its results
    names        those of its results, None where it gives an object
    attributes   units and meaning of arguments
    elementwise  whether it broadcasts; otherwise it is called once for each set of arguments
    """

    call: Function
    arguments: Mapping[str, Axes | None]
    others: frozenset[str]
    required: frozenset[str]
    outputs: Sequence[Axes]
    names: Sequence[str] | None
    attributes: Mapping[str, Mapping[str, str]]
    elementwise: bool

    @property
    def is_ensemble(self) -> bool:
        """Whether it gives realizations."""
        return any(REALIZATION in axes for axes in self.outputs)


@cache
def find(name: str) -> Swept:
    """The function of this name, "PART.FUNCTION" or "PAPER.KERNEL"; SweepError that names the nearest one."""
    if name not in known():
        hint = nearest(name, sorted(known(), key=len), 'name one like "liquid.growth_rate"', SIMILARITY)
        raise SweepError(f"function = {name!r} cannot be swept; {hint}")
    part, _, function = name.partition(".")
    if part in _papers():
        return _kernel(part, function)
    return _declared(getattr(import_module(f"symcheck.numeric.{part}"), function))


@cache
def known() -> frozenset[str]:
    """All names under which `find` has a function."""
    of_papers = {f"{paper}.{name}" for paper in _papers() for name in kernels.of_paper(paper)}
    parts = [part.name for part in pkgutil.iter_modules(symcheck.numeric.__path__) if part.ispkg]
    modules = {part: vars(import_module(f"symcheck.numeric.{part}")) for part in parts}
    declared = (f"{part}.{name}" for part, names in modules.items() for name in names if _is_declared(names[name]))
    return frozenset({*of_papers, *declared})


@cache
def code() -> str:
    """What results depend on: the sources of the numeric layer and the kernels, and the version of NumPy."""
    digest = blake2b(np.__version__.encode(), digest_size=16)
    here = Path(symcheck.numeric.__file__).parent
    names = ("runtime", "planning", "grouping", "tracing", "ratios", "specification")
    own = (here.parent / "kernels" / f"{name}.py" for name in names)
    for path in (*sorted(here.rglob("*.py")), *own, *sorted(kernels.folder().glob("*.py"))):
        digest.update(path.name.encode() + path.read_bytes())
    return digest.hexdigest()


def nearest(name: str, choices: Collection[str], otherwise: str, cutoff: float = 0.6) -> str:
    """A question after the nearest of the choices, or something else where none is near."""
    near = get_close_matches(name, choices, n=1, cutoff=cutoff)
    return f"did you mean {near[0]!r}?" if near else otherwise


def _is_declared(value: object) -> bool:
    return isinstance(getattr(value, "signature", None), Signature)


def _papers() -> set[str]:
    return {path.stem for path in kernels.folder().glob("[a-z]*.py")}


def _kernel(paper: str, name: str) -> Swept:
    declared = declaration(kernels.find(paper, name))
    names = frozenset(declared.arguments)
    cores: dict[str, Axes | None] = dict.fromkeys(declared.arguments, ())
    outputs = ((),) * len(declared.results)
    call = kernel(paper, name)
    return Swept(call, cores, frozenset(), names, outputs, [*declared.results], declared.arguments, elementwise=True)


def _declared(function: Callable[..., object]) -> Swept:
    plain: Function = inspect.unwrap(function)
    signature: Signature = getattr(function, "signature")  # noqa: B009
    parameters = inspect.signature(plain).parameters
    hints = get_type_hints(getattr(plain, "__init__") if inspect.isclass(plain) else plain)  # noqa: B009
    arrays = dict(_array_arguments(iter(signature.inputs), parameters, hints))
    required = frozenset(name for name, parameter in parameters.items() if parameter.default is parameter.empty)
    names = None if inspect.isclass(plain) else results_of(plain).names
    others = frozenset(parameters) - frozenset(arrays)
    return Swept(function, arrays, others, required, signature.outputs, names, {}, elementwise=plain is not function)


def _array_arguments(
    axes: Iterator[Axes], parameters: Collection[str], hints: Mapping[str, object]
) -> Iterator[tuple[str, Axes | None]]:
    """The signature's axes, dealt out to the first parameters; a NamedTuple takes those of its fields."""
    for name, core in zip(parameters, axes, strict=False):
        fields = getattr(hints[name], "_fields", ())
        for _ in fields[1:]:
            next(axes)
        yield name, None if fields or _is_declared(hints[name]) else core
