"""The cache keeps records by content, and nothing that is wrong with it stops an audit."""

from __future__ import annotations

import sqlite3
from collections.abc import Callable
from pathlib import Path

import pytest
import stand_in

from symcheck.audit import Cache
from symcheck.audit.cache import FILE, SCHEMA, location
from symcheck.ledger import Record

ID = "toy:1.1"
RECORDS = stand_in.decide(ID)


class Said(list[str]):
    """Collects what the cache says."""

    __call__ = list.append


@pytest.fixture
def said() -> Said:
    return Said()


def filled(folder: Path) -> Path:
    """The file of a cache that holds RECORDS under the fingerprint "f"."""
    cache = Cache(folder, pytest.fail)
    cache.put(ID, "f", RECORDS)
    cache.close()
    return folder / FILE


def found(folder: Path, said: Said, fingerprint: str = "f") -> dict[str, tuple[Record, ...]]:
    cache = Cache(folder, said)
    try:
        return cache.find({ID: fingerprint})
    finally:
        cache.close()


def test_what_was_put_is_found_by_the_next_process(tmp_path: Path, said: Said) -> None:
    filled(tmp_path)
    assert found(tmp_path, said) == {ID: RECORDS}
    assert said == []


def test_another_fingerprint_is_not_found_and_said_to_be_stale(tmp_path: Path, said: Said) -> None:
    filled(tmp_path)
    assert found(tmp_path, said, "g") == {}
    assert len(said) == 1
    assert "1 result in the cache came from other sources" in said[0]


def test_a_new_entry_replaces_the_stale_one(tmp_path: Path, said: Said) -> None:
    file = filled(tmp_path)
    cache = Cache(tmp_path, said)
    cache.put(ID, "g", RECORDS)
    cache.close()
    with sqlite3.connect(file) as connection:
        assert connection.execute("SELECT id, fingerprint FROM records").fetchall() == [(ID, "g")]
    connection.close()


def test_entries_of_vanished_declarations_are_pruned(tmp_path: Path, said: Said) -> None:
    cache = Cache(tmp_path, said)
    for id in ("toy:1", "toy:2", "other:1"):
        cache.put(id, "f", RECORDS)
    cache.prune("toy", ["toy:1"])
    assert set(cache.find(dict.fromkeys(("toy:1", "toy:2", "other:1"), "f"))) == {"toy:1", "other:1"}
    cache.close()


def _nonsense(file: Path) -> None:
    file.write_bytes(b"this is no database, it is a sentence that is long enough to be read as a header of one" * 9)


def _truncated(file: Path) -> None:
    file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])


def _short(file: Path) -> None:
    file.write_bytes(file.read_bytes()[:50])


def _zeroed(file: Path) -> None:
    data = bytearray(file.read_bytes())
    data[4096:] = bytes(len(data) - 4096)
    file.write_bytes(bytes(data))


def _statement(text: str) -> Callable[[Path], None]:
    def damage(file: Path) -> None:
        connection = sqlite3.connect(file)
        with connection:
            connection.execute(text)
        connection.close()

    return damage


WHOLE_FILE = {
    "not a database": _nonsense,
    "truncated": _truncated,
    "only the header": _short,
    "pages of zeros": _zeroed,
    "of another format": _statement(f"PRAGMA user_version = {SCHEMA + 1}"),
    "without its table": _statement("DROP TABLE records"),
    "with another table": _statement("ALTER TABLE records ADD COLUMN more"),
}


@pytest.mark.parametrize("damage", WHOLE_FILE.values(), ids=WHOLE_FILE.keys())
def test_a_damaged_file_is_put_aside_rebuilt_and_said(
    damage: Callable[[Path], None], tmp_path: Path, said: Said
) -> None:
    file = filled(tmp_path)
    damage(file)
    damaged = file.read_bytes()
    cache = Cache(tmp_path, said)
    assert cache.find({ID: "f"}) == {}
    cache.put(ID, "f", RECORDS)
    assert cache.find({ID: "f"}) == {ID: RECORDS}
    cache.close()
    assert len(said) == 1
    assert "rebuilt" in said[0]
    assert "\n" not in said[0]
    assert (tmp_path / (FILE + ".damaged")).read_bytes() == damaged


ONE_ROW = {
    "no JSON": _statement("UPDATE records SET records = 'oops'"),
    "a changed verdict": _statement("UPDATE records SET records = replace(records, 'proved', 'refuted')"),
    "the fingerprint of another entry": _statement("UPDATE records SET fingerprint = 'f', signature = 'x'"),
    "nothing": _statement("UPDATE records SET records = NULL"),
}


@pytest.mark.parametrize("damage", ONE_ROW.values(), ids=ONE_ROW.keys())
def test_a_damaged_entry_is_not_believed_and_said(damage: Callable[[Path], None], tmp_path: Path, said: Said) -> None:
    damage(filled(tmp_path))
    assert found(tmp_path, said) == {}
    assert len(said) == 1
    assert "could not be read back" in said[0]


def test_an_empty_file_is_an_empty_cache(tmp_path: Path, said: Said) -> None:
    (tmp_path / FILE).touch()
    assert found(tmp_path, said) == {}
    assert said == []


def test_a_locked_file_is_left_alone(tmp_path: Path, said: Said) -> None:
    file = filled(tmp_path)
    other = sqlite3.connect(file)
    other.execute("BEGIN EXCLUSIVE")
    assert found(tmp_path, said) == {}
    other.close()
    assert len(said) == 1
    assert "locked" in said[0]
    assert found(tmp_path, said) == {ID: RECORDS}


def test_a_folder_that_cannot_be_made_is_said_and_gone_without(tmp_path: Path, said: Said) -> None:
    (tmp_path / "file").touch()
    cache = Cache(tmp_path / "file" / "cache", said)
    cache.put(ID, "f", RECORDS)
    assert cache.find({ID: "f"}) == {}
    assert len(said) == 1
    assert "going on without it" in said[0]


def test_a_cache_that_fails_midway_is_said_once_and_given_up(tmp_path: Path, said: Said) -> None:
    cache = Cache(tmp_path, said)
    _statement("DROP TABLE records")(tmp_path / FILE)
    for _ in range(2):
        cache.put(ID, "f", RECORDS)
    assert cache.find({ID: "f"}) == {}
    assert len(said) == 1


def test_no_folder_keeps_nothing(said: Said) -> None:
    cache = Cache(None, said)
    cache.put(ID, "f", RECORDS)
    cache.prune("toy", [])
    assert cache.find({ID: "f"}) == {}
    assert said == []


def test_the_place_can_be_chosen(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("SYMCHECK_CACHE", str(tmp_path))
    assert location() == tmp_path
    monkeypatch.delenv("SYMCHECK_CACHE")
    assert location().name == "symcheck"
