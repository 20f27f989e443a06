"""What changed since an older ledger: `symcheck check --json`, or generated/expected/PAPER.json."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from symcheck.core.ids import Id
from symcheck.core.verdicts import SymcheckError
from symcheck.ledger.record import Record

TEXTS = ("printed", "words", "read", "corrected")
NEW, GONE = "new", "gone"
Older = Mapping[str, Mapping[str, Any]]  # by id; what a field of an older version said nothing of is missing


@dataclass(frozen=True)
class Change:
    """What is otherwise with one relation, in words, and whether it is its verdict."""

    id: str
    what: str
    verdict: bool = False


def older(file: Path) -> Older:
    """An older ledger, also of another version; SymcheckError if it is none."""
    try:
        items = json.loads(file.read_text(encoding="utf-8"))["items"]
        if isinstance(items, dict):
            return {str(Id.parse(id)): {"verdict": verdict} for id, (verdict, *_) in items.items()}
        return {str(Id.parse(each["id"])): {**each} for each in items}
    except OSError as error:
        raise SymcheckError(f"{file} cannot be read: {error.strerror}") from error
    except (ValueError, KeyError, TypeError, SymcheckError) as error:
        raise SymcheckError(f"{file} is no ledger; give one that `symcheck check --json` has written") from error


def changes(
    records: Iterable[Record], old: Older, is_whole: Callable[[str], bool] = lambda paper: True
) -> list[Change]:
    """All changes in the papers that the older ledger has, in the order of the records.

    Parameters
    ----------
    records
        As they are now.
    old
        The older ledger.
    is_whole
        Whether the records of a paper are all that it has: of others nothing is called gone.
    """
    papers, now = {Id.parse(id).paper for id in old}, [*records]
    found = [change for each in now if each.paper in papers for change in _changes(each, old.get(each.id))]
    left = old.keys() - {each.id for each in now}
    return [*found, *(Change(id, GONE) for id in old if id in left and is_whole(Id.parse(id).paper))]


def _changes(record: Record, before: Mapping[str, Any] | None) -> Iterator[Change]:
    if before is None:
        yield Change(record.id, NEW)
        return
    now = str(record.verdict or record.role)
    was = before.get("verdict") or before.get("role") or ("no verdict" if record.verdict else now)
    if was != now:
        yield Change(record.id, f"{was}, now {now}", verdict=True)
    if (kind := before.get("kind", record.kind)) != record.kind:
        yield Change(record.id, f"kind: {kind or 'none'}, now {record.kind or 'none'}")
    for name in TEXTS:
        if (text := before.get(name)) and text != getattr(record, name):
            yield Change(record.id, f"{name} otherwise; before: {text}")
