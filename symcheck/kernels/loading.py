"""Finds generated/ and loads kernels from it: in a wheel, in an editable install and in a bare checkout alike."""

from __future__ import annotations

import sys
from importlib import import_module
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType

from symcheck.core.verdicts import SymcheckError

PACKAGE = "symcheck.generated"


def folder() -> Path:
    """The folder generated/: inside the package in a wheel, beside it in a checkout."""
    here = Path(__file__).resolve().parents[1]
    for place in (here / "generated", here.parent / "generated"):
        if (place / "__init__.py").is_file():
            return place
    raise SymcheckError(f"no folder generated/ in or beside {here}; install symcheck again or restore the checkout")


def load(name: str) -> ModuleType:
    """The kernel module symcheck.generated.<name>; SymcheckError if nothing was generated under that name."""
    _package()
    try:
        return import_module(f"{PACKAGE}.{name}")
    except ModuleNotFoundError as error:
        if error.name != f"{PACKAGE}.{name}":
            raise
        raise SymcheckError(f"no kernels named {name!r} in {folder()}; run `symcheck generate`") from error


def _package() -> None:
    """Bind symcheck.generated to the folder found, however the package was installed."""
    if PACKAGE in sys.modules:
        return
    root = folder()
    spec = spec_from_file_location(PACKAGE, root / "__init__.py", submodule_search_locations=[str(root)])
    if spec is None or spec.loader is None:
        raise SymcheckError(f"{root} cannot be imported; restore its __init__.py")
    module = module_from_spec(spec)
    sys.modules[PACKAGE] = module
    spec.loader.exec_module(module)
