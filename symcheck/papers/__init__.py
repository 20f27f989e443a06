"""The audited papers, one subpackage each; a subpackage that binds `paper` is found without registration."""

from __future__ import annotations

import pkgutil
from importlib import import_module

from symcheck.statement import Paper


def load() -> dict[str, Paper]:
    """All papers by key, in alphabetical order."""
    names = sorted(info.name for info in pkgutil.iter_modules(__path__) if info.ispkg)
    return {name: import_module(f"{__name__}.{name}").paper for name in names}
