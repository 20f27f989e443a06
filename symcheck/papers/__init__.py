"""The audited papers, one subpackage each; a subpackage that binds `paper` is found without registration."""

from __future__ import annotations

import pkgutil
from collections.abc import Iterator, Mapping
from functools import cache
from importlib import import_module

from symcheck.core.claims import Paper


class Papers(Mapping[str, Paper]):
    """All papers by key, in alphabetical order; each is imported when it is asked for."""

    def __init__(self) -> None:
        self._keys = tuple(sorted(info.name for info in pkgutil.iter_modules(__path__) if info.ispkg))

    def __getitem__(self, key: str) -> Paper:
        if key not in self._keys:
            raise KeyError(key)
        paper: Paper = import_module(f"{__name__}.{key}").paper
        return paper

    def __iter__(self) -> Iterator[str]:
        return iter(self._keys)

    def __len__(self) -> int:
        return len(self._keys)


@cache
def load() -> Papers:
    """The papers."""
    return Papers()
