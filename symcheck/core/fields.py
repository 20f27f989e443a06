"""Strict readers of JSON: what is read has the form that is asked for, or the message names it."""

from __future__ import annotations

from collections.abc import Callable

from symcheck.core.terms import JSON, Malformed, T


def text(data: JSON) -> str:
    """A text."""
    if type(data) is not str:
        raise Malformed(f"{str(data)[:200]} is no text")
    return data


def listed(read: Callable[[JSON], T], count: int | None = None) -> Callable[[JSON], list[T]]:
    """What reads a list, of so many entries if that is said, each of which is read so."""

    def reads(data: JSON) -> list[T]:
        if type(data) is not list or (count is not None and len(data) != count):
            raise Malformed(f"{str(data)[:200]} is no {'list' if count is None else 'pair'}")
        return [*map(read, data)]

    return reads


def by_key(read: Callable[[JSON], T]) -> Callable[[object], dict[str, T]]:
    """What reads an object, each value of which is read so."""

    def reads(data: object) -> dict[str, T]:
        if type(data) is not dict:
            raise Malformed(f"{str(data)[:200]} is no object")
        return {text(key): read(value) for key, value in data.items()}

    return reads


def raw(data: JSON) -> JSON:
    """Anything; whoever uses it reads it."""
    return data


class Fields:
    """The fields of an object, such as a step of a proof; what is taken out of it must be all there is."""

    def __init__(self, data: object) -> None:
        if type(data) is not dict:
            raise Malformed(f"{str(data)[:200]} is no step of a proof")
        self.data: dict[str, JSON] = {**data}

    def take(self, key: str, read: Callable[[JSON], T], *absent: JSON) -> T:
        """A field as it is to be read; if it is not there, what is said for that case."""
        if key in self.data:
            return read(self.data.pop(key))
        if not absent:
            raise Malformed(f"a step without {key}")
        return read(*absent)

    def end(self) -> None:
        if self.data:
            raise Malformed(f"a step of a proof has the superfluous {[*self.data]}")
