"""An audit answers in printed order, from the cache where it can, and keeps what is done when it is stopped."""

from __future__ import annotations

import sys
from collections.abc import Callable, Generator, Iterable
from pathlib import Path
from typing import Any

import pytest
import stand_in

from symcheck.audit import Cache, Done, Executor, Serial, checked, run
from symcheck.audit.executor import Pool
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.ledger import Record

STAND_IN: Any = sys.modules["stand_in"]
ALL = ["toy:1.1", "toy:1.2a", "toy:1.2b", "toy:1.3", "toy:1.4", "toy:1.5", "toy:1.12"]


@pytest.fixture(autouse=True)
def _checked(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(checked, "reasons", stand_in.reasons)


class Backwards:
    """Answers in the reverse order, as a pool might."""

    def map(self, function: Callable[[str], Any], ids: Iterable[str], timeout: float) -> Generator[Any]:
        yield from reversed(list(Serial().map(function, ids, timeout)))


class Stopped:
    """Is interrupted after two answers."""

    def map(self, function: Callable[[str], Any], ids: Iterable[str], timeout: float) -> Generator[Any]:
        for id in list(ids)[:2]:
            yield id, Done(function(id))
        raise KeyboardInterrupt


def audit(*selection: str, folder: Path | None = None, executor: Executor | None = None, **more: Any) -> list[Record]:
    cache = Cache(folder, pytest.fail)
    try:
        return run.audit(
            selection,
            papers=stand_in.papers(),
            decide=STAND_IN,
            cache=cache,
            executor=executor or Serial(),
            timeout=more.pop("timeout", 60.0),
            **more,
        )
    finally:
        cache.close()


def ids(records: Iterable[Record]) -> list[str]:
    return [record.id for record in records]


@pytest.mark.parametrize(
    ("selection", "expected"),
    [
        ((), [*ALL, "other:1"]),
        (("toy",), ALL),
        (("other", "toy"), [*ALL, "other:1"]),
        (("toy:1.12", "toy:1.1"), ["toy:1.1", "toy:1.12"]),
        (("toy:1.1", "toy:1.1"), ["toy:1.1"]),
        (("toy:1.2",), ["toy:1.2a", "toy:1.2b"]),
        (("toy:1.2b",), ["toy:1.2b"]),
        (("toy:1.2b", "toy:1.2a"), ["toy:1.2a", "toy:1.2b"]),
        (("toy:1.2b", "toy:1.2"), ["toy:1.2a", "toy:1.2b"]),
        (("toy:1.2", "toy:1.2b"), ["toy:1.2a", "toy:1.2b"]),
        (("toy", "toy:1.2b"), ALL),
        (("toy:1",), ALL),
    ],
)
def test_a_selection_means_these_records_in_printed_order(selection: tuple[str, ...], expected: list[str]) -> None:
    assert ids(audit(*selection)) == expected
    assert ids(audit(*selection, executor=Backwards())) == expected


@pytest.mark.parametrize(
    ("selection", "hint"),
    [
        ("toi", "did you mean toy?"),
        ("nothing", "known papers: toy, other"),
        ("", "known papers: toy, other"),
        ("toy:", "lists what there is"),
        ("toy:1.13", "toy:1.1"),
        ("toy:1.2c", "toy:1.2a, toy:1.2b"),
        ("toy:1.1a", "toy:1.1"),
        ("toy:zzzzzz", "`symcheck check toy`"),
        (":1.1", "known papers"),
    ],
)
def test_an_unknown_selection_is_an_error_with_a_way_out(selection: str, hint: str) -> None:
    with pytest.raises(SymcheckError) as error:
        audit(selection)
    assert hint in str(error.value)
    assert "\n" not in str(error.value)


def test_nothing_is_decided_twice(toy: Path, decided: Callable[[], list[str]]) -> None:
    cold = audit("toy", folder=toy / "cache")
    assert decided() == [f"toy:{number}" for number in stand_in.NUMBERS]
    assert audit("toy", folder=toy / "cache") == cold
    assert decided() == []


def test_only_what_changed_is_decided_again(
    toy: Path, decided: Callable[[], list[str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    audit("toy", folder=toy / "cache")
    decided()
    monkeypatch.setenv("STAND_IN_MORE", "new")
    audit("toy", folder=toy / "cache")
    assert decided() == ["toy:new"]


def test_progress_counts_cached_ones_first(toy: Path) -> None:
    audit("toy:1.1", folder=toy / "cache")
    seen: list[tuple[int, int]] = []
    audit("toy:1.1", "toy:1.3", folder=toy / "cache", progress=lambda *counts: seen.append(counts))
    assert seen == [(1, 2), (2, 2)]


def test_an_interrupted_audit_keeps_what_is_done(toy: Path, decided: Callable[[], list[str]]) -> None:
    with pytest.raises(KeyboardInterrupt):
        audit("toy", folder=toy / "cache", executor=Stopped())
    assert decided() == ["toy:1.1", "toy:1.2"]
    audit("toy", folder=toy / "cache")
    assert decided() == ["toy:1.3", "toy:1.4", "toy:1.5", "toy:1.12"]


def test_killed_crashed_and_failing_declarations_are_undecided_with_a_reason(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("STAND_IN_MORE", "hang die raise")
    records = {record.id: record for record in audit("toy", executor=Pool(2), timeout=1.0)}
    reasons = {"toy:hang": "within 1 s", "toy:die": "died", "toy:raise": "ValueError"}
    for id, reason in reasons.items():
        assert records[id].verdict == Verdict.UNDECIDED
        assert reason in records[id].reason
    assert [id for id in records if id not in reasons] == ALL


def test_a_crash_is_not_cached(toy: Path, decided: Callable[[], list[str]], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("STAND_IN_MORE", "raise")
    for _ in range(2):
        audit("toy:raise", folder=toy / "cache")
        assert decided() == ["toy:raise"]


def test_pool_and_serial_agree(toy: Path) -> None:
    assert audit(executor=Pool(2)) == audit(executor=Serial())
