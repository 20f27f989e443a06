"""What was accepted of a source: every relation with the key by which an audit names it, and where each is now."""

from __future__ import annotations

import hashlib
import json
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from difflib import SequenceMatcher
from pathlib import Path

from symcheck.core.verdicts import SymcheckError
from symcheck.document.printed import Printed

LOCK = "audit.lock"
SCHEMA = "symcheck lock 1"
DIGITS = 12  # of a digest
ALIKE = 0.5  # of the tokens of a relation that has changed are as they were; below that it is another one
# a command, a number, or any other sign
_TOKENS = re.compile(r"\\[A-Za-z]+|\\.|\d+|\S")
UPDATE = "`symcheck new --update {}`"


@dataclass(frozen=True)
class Accepted:
    """One relation: its key, its place in words, and what was printed."""

    key: str
    place: str
    latex: str
    digest: str


def digest(latex: str) -> str:
    """A digest of what is printed, whatever its spaces are."""
    return hashlib.sha256("".join(latex.split()).encode()).hexdigest()[:DIGITS]


def keys(formulas: Sequence[Printed]) -> list[str]:
    """How an audit names each of them: by the label, else the number, else the place; with a counter if that is one
    of several."""
    count = Counter[str]()
    found = []
    for formula in formulas:
        label, number = formula.label.partition(", ")[0], formula.number.partition(", ")[0]
        key = label or (f"({number})" if number else formula.position)
        count[key] += 1
        found.append(key if count[key] == 1 else f"{key} #{count[key]}")
    return found


def accepted(formulas: Sequence[Printed]) -> list[Accepted]:
    """All of them as they are."""
    pairs = zip(keys(formulas), formulas, strict=True)
    return [Accepted(key, each.place, each.latex, digest(each.latex)) for key, each in pairs]


def written(relations: Sequence[Accepted]) -> bytes:
    """The contents of the file: one relation a line."""
    lines = ",\n".join(json.dumps(asdict(each), ensure_ascii=False) for each in relations)
    return f'{{"format": {json.dumps(SCHEMA)}, "relations": [\n{lines}\n]}}\n'.encode()


def load(file: Path) -> list[Accepted]:
    """What was accepted; SymcheckError if the file is missing, or is no such file."""
    update = UPDATE.format(file.parent)
    try:
        data = json.loads(file.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise SymcheckError(f"{file} is missing; {update} accepts the source as it is") from None
    except OSError as error:
        raise SymcheckError(f"{file} cannot be read ({error.strerror})") from error
    except (ValueError, RecursionError):
        raise SymcheckError(f"{file} is no lock of symcheck; remove it, and {update} writes another") from None
    try:
        if data["format"] != SCHEMA:
            raise KeyError
        found = [Accepted(**each) for each in data["relations"]]
        if wrong := next((each for each in found if digest(each.latex) != each.digest), None):
            raise SymcheckError(f"{file} was edited: {wrong.key} is not what was accepted; {update} after removing it")
    except (KeyError, TypeError, AttributeError):
        raise SymcheckError(f"{file} is no {SCHEMA}; remove it, and {update} writes another") from None
    return found


def located(old: Sequence[Accepted], new: Sequence[Printed]) -> dict[str, int]:
    """Where each relation is now, by its key: that of its label, else the same one, else one that is much like it."""
    names, digests = keys(new), [digest(each.latex) for each in new]
    where: dict[str, int] = {}
    free = dict.fromkeys(range(len(new)))

    def take(each: Accepted, k: int) -> None:
        where[each.key] = k
        del free[k]

    at = {name: k for k, name in enumerate(names)}
    labelled = {name for name, each in zip(names, new, strict=True) if each.label}
    for each in old:  # the same at its place
        if (k := at.get(each.key)) is not None and digests[k] == each.digest:
            take(each, k)
    for each in old:  # a label stays with its relation
        if each.key not in where and each.key in labelled and at[each.key] in free:
            take(each, at[each.key])
    for n, each in enumerate(old):
        if each.key not in where:
            same = [k for k in free if digests[k] == each.digest]
            if same:
                take(each, min(same, key=lambda k: abs(k - n)))
    for n, each in enumerate(old):
        if each.key not in where and (k := _alike(each, [*_between(n, old, where, free)], new)) is not None:
            take(each, k)
    return where


def _between(n: int, old: Sequence[Accepted], where: Mapping[str, int], free: Mapping[int, None]) -> list[int]:
    """The free places between the neighbours of a relation."""
    before = [where[each.key] for each in old[:n] if each.key in where]
    behind = [where[each.key] for each in old[n + 1 :] if each.key in where]
    low, high = (before[-1] if before else -1), (behind[0] if behind else max(free, default=-1) + 1)
    return [k for k in free if low < k < high]


def _alike(each: Accepted, places: Sequence[int], new: Sequence[Printed]) -> int | None:
    own = _TOKENS.findall(each.latex)
    ratio = {k: SequenceMatcher(None, own, _TOKENS.findall(new[k].latex), autojunk=False).ratio() for k in places}
    best = max(ratio, key=lambda k: ratio[k], default=None)
    return best if best is not None and ratio[best] >= ALIKE else None
