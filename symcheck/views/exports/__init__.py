"""The ledger for other tools. A format is a module of this package that declares FORMAT; its name has no underscore."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from pkgutil import iter_modules
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from symcheck.ledger import Record


@dataclass(frozen=True)
class Format:
    """What a format is, and how it is written: `text` is one file, `files` a folder of files by name."""

    says: str
    text: Callable[[Sequence[Record]], str] | None = None
    files: Callable[[Sequence[Record]], Mapping[str, str]] | None = None


def format_names() -> list[str]:
    """The names of all formats."""
    return sorted(module.name for module in iter_modules(__path__) if "_" not in module.name)


def format_of(name: str) -> Format:
    """The format of that name."""
    found = import_module(f"{__name__}.{name}").FORMAT
    assert isinstance(found, Format)
    return found
