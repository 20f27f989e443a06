"""Where generated kernels lie, and those whose name is known only when the program runs.

Others are imported: `from symcheck.generated import mirer2009`.
"""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches
from importlib import import_module
from pathlib import Path
from types import ModuleType

from symcheck import generated
from symcheck.specification import KernelFunction
from symcheck.statement import SymcheckError


def folder() -> Path:
    """The folder with all that `symcheck generate` writes."""
    return Path(generated.__path__[0])


def load(name: str) -> ModuleType:
    """The kernel module symcheck.generated.<name>; SymcheckError if nothing was generated under that name."""
    module = f"{generated.__name__}.{name}"
    try:
        return import_module(module)
    except ModuleNotFoundError as error:
        if error.name != module:
            raise
        raise SymcheckError(f"no kernels named {name!r} in {folder()}; run `symcheck generate`") from error


def of_paper(key: str) -> Mapping[str, KernelFunction]:
    """The kernels of a paper by name."""
    kernels: Mapping[str, KernelFunction] = vars(load(key))["KERNELS"]
    return kernels


def find(key: str, name: str) -> KernelFunction:
    """The kernel of that name; SymcheckError names the nearest one.

    >>> round(find("ignatov2005", "volume_of_three_wheels")(0.5, 1.0), 6)
    2.93465
    """
    known = of_paper(key)
    if name not in known:
        near = get_close_matches(name, known, n=1, cutoff=0)
        raise SymcheckError(f"{key} has no kernel {name!r}; did you mean {near[0]!r}?")
    return known[name]
