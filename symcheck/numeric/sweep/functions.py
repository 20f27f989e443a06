"""The functions that can be swept: kernels by paper, and what is declared with a signature in the numeric layer."""

from __future__ import annotations

import inspect
import pkgutil
from collections.abc import Callable, Iterator, Mapping, Sequence
from difflib import get_close_matches
from functools import cache, partial
from hashlib import blake2b
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple, get_type_hints

import numpy as np

import symcheck.numeric
from symcheck import kernels
from symcheck.numeric.chunked import results_of
from symcheck.numeric.chunked.arrays import Axes, Signature
from symcheck.numeric.chunked.kernels import by_blocks, declaration

OF_ENSEMBLE = {"seed", "first", "paths"}  # arguments that a sweep gives by itself
REALIZATION = "realization"


class SweepError(ValueError):
    """What keeps a sweep from going on, in words for whoever wrote it."""


class Swept(NamedTuple):
    """A function that can be swept.

    call         the function, of arguments by name
    arguments    last axes of its array arguments; None where it takes the result of another function
    others       names of further arguments
    of_ensemble  names of those that a sweep gives by itself
    required     names of arguments without a default
    outputs      last axes of its results
    names        those of its results, None where it gives an object
    attributes   units and meaning of arguments and of results
    elementwise  whether it broadcasts; otherwise it is called once for each set of arguments
    """

    call: Callable[..., Any]
    arguments: Mapping[str, Axes | None]
    others: frozenset[str]
    of_ensemble: frozenset[str]
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
    part, _, function = name.partition(".")
    if part in _papers() and function in kernels.of_paper(part):
        return _kernel(part, function)
    if part in _parts():
        found = getattr(import_module(f"symcheck.numeric.{part}"), function, None)
        if _is_declared(found):
            return _declared(found)
    near = get_close_matches(name, sorted(known(), key=len), n=1, cutoff=0.4)
    hint = f"did you mean {near[0]!r}?" if near else 'name one like "liquid.growth_rate"'
    raise SweepError(f"function = {name!r} is none that can be swept; {hint}")


def known() -> set[str]:
    """All names under which `find` has a function."""
    of_papers = {f"{paper}.{name}" for paper in _papers() for name in kernels.of_paper(paper)}
    parts = {part: vars(import_module(f"symcheck.numeric.{part}")) for part in _parts()}
    return of_papers | {f"{part}.{n}" for part, names in parts.items() for n in names if _is_declared(names[n])}


@cache
def code() -> str:
    """What results depend on: the sources of the numeric layer and the kernels, and the version of NumPy."""
    digest = blake2b(np.__version__.encode(), digest_size=16)
    here = Path(symcheck.numeric.__file__).parent
    own = (here.parent / "kernels" / f"{name}.py" for name in ("runtime", "ratios", "specification"))
    for path in (*sorted(here.rglob("*.py")), *own, *sorted(kernels.folder().glob("*.py"))):
        digest.update(path.name.encode() + path.read_bytes())
    return digest.hexdigest()


def _is_declared(value: Any) -> bool:
    return isinstance(getattr(value, "signature", None), Signature)


def _papers() -> set[str]:
    return {path.stem for path in kernels.folder().glob("[a-z]*.py")}


def _parts() -> set[str]:
    return {module.name for module in pkgutil.iter_modules(symcheck.numeric.__path__) if module.ispkg}


def _kernel(paper: str, name: str) -> Swept:
    documented = declaration(kernels.find(paper, name))
    return Swept(
        partial(by_blocks, paper, name),
        dict.fromkeys(documented.arguments, ()),
        frozenset(),
        frozenset(),
        frozenset(documented.arguments),
        ((),) * len(documented.results),
        tuple(documented.results),
        {**documented.arguments, **documented.results},
        elementwise=True,
    )


def _declared(function: Any) -> Swept:
    plain = inspect.unwrap(function)
    parameters = inspect.signature(plain).parameters
    hints = get_type_hints(plain.__init__ if inspect.isclass(plain) else plain)
    arrays = dict(_array_arguments(iter(function.signature.inputs), parameters, hints))
    return Swept(
        function,
        arrays,
        frozenset(parameters) - frozenset(arrays) - OF_ENSEMBLE,
        frozenset(parameters) & OF_ENSEMBLE,
        frozenset(name for name, each in parameters.items() if each.default is each.empty) - OF_ENSEMBLE,
        function.signature.outputs,
        None if inspect.isclass(plain) else results_of(plain).names,
        {},
        elementwise=plain is not function,
    )


def _array_arguments(
    axes: Iterator[Axes], parameters: Mapping[str, Any], hints: Mapping[str, Any]
) -> Iterator[tuple[str, Axes | None]]:
    """The signature's axes, dealt out to the first parameters; a NamedTuple takes those of its fields."""
    for name, core in zip(parameters, axes, strict=False):
        fields = getattr(hints[name], "_fields", ())
        for _ in fields[1:]:
            next(axes)
        yield name, None if fields or _is_declared(hints[name]) else core
