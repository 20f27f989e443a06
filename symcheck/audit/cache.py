"""Decided records by content: fingerprint -> records, in one SQLite file that may be lost at any time.

The cache never decides anything and never stops anybody: whatever is wrong with it is said in one line through `say`,
and the work goes on without the part that was lost. It is not believed either: each entry is signed with a key that is
kept elsewhere, so that nothing in it can be changed, and entries of somebody else's cache count for nothing. (Whoever
has the key could change the program as well.) What the entries say is checked again, see `symcheck.audit.checked`.
"""

from __future__ import annotations

import hmac
import json
import os
import secrets
import sqlite3
from collections.abc import Callable, Iterable, Mapping
from contextlib import closing
from pathlib import Path

from symcheck.core.ids import Id
from symcheck.core.verdicts import SymcheckError
from symcheck.ledger import Record

WAIT = 2.0  # seconds for another process to finish writing
SCHEMA = 2  # of the cache file; one of another format is set aside
FILE = "records.sqlite"
KEY, KEY_BYTES = "cache.key", 32
_TABLE = "CREATE TABLE records (id TEXT PRIMARY KEY, fingerprint TEXT, signature TEXT, records TEXT) WITHOUT ROWID"
_FIND = "SELECT id, fingerprint, signature, records FROM records WHERE id IN (SELECT value FROM json_each(?))"
Say = Callable[[str], None]


def location() -> Path:
    """The folder of the cache: $SYMCHECK_CACHE, or the user's cache folder of the platform."""
    if chosen := os.environ.get("SYMCHECK_CACHE"):
        return Path(chosen)
    from platformdirs import user_cache_path

    return user_cache_path("symcheck")


def key() -> bytes:
    """The key with which entries are signed, of this user; it is made at the first use. OSError if it cannot be."""
    from platformdirs import user_config_path

    file = user_config_path("symcheck") / KEY
    if not file.exists():
        file.parent.mkdir(parents=True, exist_ok=True)
        new = file.with_name(f".{KEY}.{os.getpid()}")
        with open(os.open(new, os.O_CREAT | os.O_WRONLY | os.O_TRUNC, 0o600), "wb") as opened:
            opened.write(secrets.token_bytes(KEY_BYTES))
        new.replace(file)  # if another process is making it, too, one of the two decides a few things again
    if len(found := file.read_bytes()) != KEY_BYTES:
        raise OSError(f"{file} is not the key of a cache; remove it")
    return found


class Cache:
    """Records of declarations, one entry per id, valid only for the fingerprint they were stored under.

    A new entry replaces the one of the same id, so stale entries do not pile up. `folder=None` is a cache that keeps
    nothing.
    """

    def __init__(self, folder: Path | None, say: Say) -> None:
        self.say = say
        self._file = folder / FILE if folder else None
        self._connection = None
        try:
            self._key = key() if folder else b""
        except OSError as error:
            say(f"no cache, as there is no key to sign it with ({error})")
        else:
            self._connection = _opened(self._file, say) if self._file else None

    def find(self, fingerprints: Mapping[str, str]) -> dict[str, tuple[Record, ...]]:
        """The records of those ids that are stored under the given fingerprint; stale entries are counted and said."""
        found, stale, broken = {}, 0, 0
        for id, fingerprint, signature, text in self._rows(fingerprints):
            if fingerprint != fingerprints[id]:
                stale += 1
            elif (records := self._unpacked(id, fingerprint, signature, text)) is None:
                broken += 1
            else:
                found[id] = records
        if stale:
            self.say(f"{_results(stale)} in the cache came from other sources or libraries; deciding again")
        if broken:
            self.say(f"{_results(broken)} in the cache {self._file} could not be read back; deciding again")
        return found

    def put(self, id: str, fingerprint: str, records: Iterable[Record]) -> None:
        """Store the records of one declaration, in one transaction."""
        if self._connection is None:
            return
        text = json.dumps([record.to_json() for record in records], ensure_ascii=False, separators=(",", ":"))
        row = (id, fingerprint, self._signature(id, fingerprint, text), text)
        try:
            with self._connection:
                self._connection.execute("INSERT OR REPLACE INTO records VALUES (?, ?, ?, ?)", row)
        except sqlite3.Error as error:
            self._give_up(error)

    def prune(self, paper: str, ids: Iterable[str]) -> None:
        """Drop the entries of `paper` that belong to none of the declared `ids`."""
        if self._connection is None:
            return
        try:
            stored = {row[0] for row in self._connection.execute("SELECT id FROM records")}
            gone = {id for id in stored if Id.parse(id).paper == paper} - set(ids)
            with self._connection:
                self._connection.executemany("DELETE FROM records WHERE id = ?", [(id,) for id in sorted(gone)])
        except sqlite3.Error as error:
            self._give_up(error)

    def close(self) -> None:
        """Close the file."""
        if self._connection is not None:
            self._connection.close()
            self._connection = None

    def _signature(self, id: str, fingerprint: str, text: str) -> str:
        return hmac.digest(self._key, "\n".join((id, fingerprint, text)).encode(), "sha256").hex()

    def _unpacked(self, id: str, fingerprint: str, signature: str, text: str) -> tuple[Record, ...] | None:
        """The records of one entry, or None if the entry is not what was stored here."""
        texts = isinstance(text, str) and isinstance(signature, str) and signature.isascii()
        if not texts or not hmac.compare_digest(self._signature(id, fingerprint, text), signature):
            return None
        try:
            return tuple(Record.from_json(data) for data in json.loads(text))
        except (ValueError, TypeError, SymcheckError):
            return None

    def _rows(self, ids: Iterable[str]) -> list[tuple[str, str, str, str]]:
        if self._connection is None:
            return []
        try:
            return self._connection.execute(_FIND, (json.dumps(list(ids)),)).fetchall()
        except sqlite3.Error as error:
            self._give_up(error)
            return []

    def _give_up(self, error: sqlite3.Error) -> None:
        self.say(f"the cache {self._file} cannot be used any more ({error}); going on without it")
        self.close()


def _opened(file: Path, say: Say) -> sqlite3.Connection | None:
    """The database, put aside and made anew if it is damaged; None if there can be none. Both are said."""
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        if not file.exists() or file.stat().st_size == 0:
            return _created(file)
        if (fault := _fault(file)) is None:
            return _connected(file)
        say(f"the cache {file} {fault}; put aside as {_aside(file).name} and rebuilt")
        return _rebuilt(file)
    except (OSError, sqlite3.Error) as error:
        say(f"the cache {file} cannot be used ({error}); going on without it")
        return None


def _connected(file: Path) -> sqlite3.Connection:
    connection = sqlite3.connect(file, timeout=WAIT)
    # A power failure may cost the file: it is only a cache, its damage is noticed, and waiting for the disk is slow.
    connection.execute("PRAGMA synchronous = OFF")
    return connection


def _created(file: Path) -> sqlite3.Connection:
    connection = _connected(file)
    with connection:
        connection.execute("BEGIN IMMEDIATE")  # another process may be creating the same file
        connection.execute(_TABLE.replace("TABLE", "TABLE IF NOT EXISTS"))
        connection.execute(f"PRAGMA user_version = {SCHEMA}")
    return connection


def _rebuilt(file: Path) -> sqlite3.Connection:
    file.replace(_aside(file))
    for suffix in ("-journal", "-wal", "-shm"):
        file.with_name(file.name + suffix).unlink(missing_ok=True)
    return _created(file)


def _fault(file: Path) -> str | None:
    """What is wrong with an existing database; a locked or unreadable one raises sqlite3.OperationalError instead."""
    try:
        with closing(sqlite3.connect(file, timeout=WAIT)) as connection:
            [(version,)] = connection.execute("PRAGMA user_version")
            [(state,), *_] = connection.execute("PRAGMA quick_check(1)")
            tables = [row[0] for row in connection.execute("SELECT sql FROM sqlite_schema WHERE name = 'records'")]
    except sqlite3.OperationalError:
        raise
    except sqlite3.DatabaseError as error:
        return f"is damaged ({error})"
    if version != SCHEMA:
        return f"has format {version}, not {SCHEMA}"
    if state != "ok":
        return f"is damaged ({' '.join(str(state).split())})"
    return None if tables == [_TABLE] else "is damaged (its table is missing or changed)"


def _aside(file: Path) -> Path:
    return file.with_name(file.name + ".damaged")


def _results(count: int) -> str:
    return "1 result" if count == 1 else f"{count} results"
