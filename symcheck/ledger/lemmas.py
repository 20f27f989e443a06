"""The earlier relations that certificates rest on."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TypeVar

from symcheck.core.certificates import Certificate

T = TypeVar("T")


def lemmas_of(certificates: Iterable[Certificate]) -> list[str]:
    """The ids of the relations that these certificates name as lemmas."""
    return list(dict.fromkeys(name for certificate in certificates for name, _ in certificate.get("lemmas", ())))


def reached(start: Iterable[T], further: Callable[[T], Iterable[T]]) -> list[T]:
    """Everything that a chain of steps leads to, the start included, each once."""
    met = dict.fromkeys(start)
    todo = [*met]
    while todo:
        new = [each for each in further(todo.pop()) if each not in met]
        met |= dict.fromkeys(new)
        todo += new
    return [*met]
