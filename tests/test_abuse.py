"""The program survives abuse: a full or read-only disk, two processes, a kill in the middle, silly arguments."""

from __future__ import annotations

import json
import os
import random
import signal
import sqlite3
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
import stand_in
from click.testing import CliRunner, Result

from symcheck.audit import Cache
from symcheck.audit.cache import FILE
from symcheck.ledger import Record

RECORDS = stand_in.decide("toy:1.1")
WRITER = """
import sys, stand_in
from pathlib import Path
from symcheck.audit.cache import Cache
said = []
cache = Cache(Path(sys.argv[1]), said.append)
records = stand_in.decide("toy:1.1")
print("ready", flush=True)
for n in range(int(sys.argv[2])):
    cache.put(f"toy:{sys.argv[3]}.{n}", "f", records)
cache.close()
print(said)
"""


def writer(folder: Path, count: int, name: str, root: Path) -> subprocess.Popen[str]:
    env = {**os.environ, "PYTHONPATH": os.pathsep.join((str(root), str(root / "tests")))}
    command = [sys.executable, "-c", WRITER, str(folder), str(count), name]
    return subprocess.Popen(command, env=env, stdout=subprocess.PIPE, text=True)


def found(folder: Path, ids: list[str], say: Callable[[str], None] = pytest.fail) -> dict[str, tuple[Record, ...]]:
    cache = Cache(folder, say)
    try:
        return cache.find(dict.fromkeys(ids, "f"))
    finally:
        cache.close()


def test_two_processes_write_one_cache_at_once(tmp_path: Path, root: Path) -> None:
    processes = [writer(tmp_path, 60, name, root) for name in "ab"]
    said = [process.communicate(timeout=120)[0] for process in processes]
    assert [text.splitlines()[-1] for text in said] == ["[]", "[]"]
    ids = [f"toy:{name}.{n}" for name in "ab" for n in range(60)]
    assert found(tmp_path, ids) == dict.fromkeys(ids, RECORDS)


@pytest.mark.parametrize("moment", [0.0, 0.02, 0.1])
def test_a_writer_killed_in_the_middle_leaves_a_cache_that_works(moment: float, tmp_path: Path, root: Path) -> None:
    process = writer(tmp_path, 100_000, "a", root)
    assert process.stdout is not None
    process.stdout.readline()
    time.sleep(moment)
    process.send_signal(signal.SIGKILL)
    process.communicate(timeout=60)
    said: list[str] = []
    cache = Cache(tmp_path, said.append)
    cache.put("toy:1.1", "f", RECORDS)
    assert cache.find({"toy:1.1": "f"}) == {"toy:1.1": RECORDS}
    kept = cache.find({f"toy:a.{n}": "f" for n in range(200)})
    assert all(records == RECORDS for records in kept.values())
    cache.close()


def test_a_cache_cut_off_anywhere_is_noticed_or_whole(tmp_path: Path) -> None:
    cache = Cache(tmp_path, pytest.fail)
    for n in range(30):
        cache.put(f"toy:{n}", "f", RECORDS)
    cache.close()
    whole, rng = (tmp_path / FILE).read_bytes(), random.Random(0)
    for trial in range(60):
        data = bytearray(whole[: rng.randrange(len(whole))] if trial % 2 else whole)
        for _ in range(0 if trial % 2 else 20):
            data[rng.randrange(len(data))] = rng.randrange(256)
        (tmp_path / FILE).write_bytes(bytes(data))
        said: list[str] = []
        kept = found(tmp_path, [f"toy:{n}" for n in range(30)], said.append)
        assert all(records == RECORDS for records in kept.values())
        assert len(kept) == 30 or said or trial % 2  # an empty beginning is an empty cache
        assert all("\n" not in line for line in said)


def test_a_full_disk_is_said_once_and_gone_without(tmp_path: Path) -> None:
    said: list[str] = []
    cache = Cache(tmp_path, said.append)
    connection = cache._connection
    assert connection is not None
    connection.execute("PRAGMA max_page_count = 4")  # SQLite's own way to run out of space
    for n in range(50):
        cache.put(f"toy:{n}", "f", RECORDS)
    cache.close()
    assert len(said) == 1
    assert "full" in said[0]
    assert "going on without it" in said[0]


def test_a_read_only_cache_is_read_and_its_refusal_said_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cache = Cache(tmp_path, pytest.fail)
    cache.put("toy:1.1", "f", RECORDS)
    cache.close()
    real = sqlite3.connect

    def read_only(file: Path, timeout: float) -> sqlite3.Connection:
        return real(f"file:{file}?mode=ro", timeout=timeout, uri=True)

    monkeypatch.setattr(sqlite3, "connect", read_only)  # permissions mean nothing to root
    said: list[str] = []
    cache = Cache(tmp_path, said.append)
    assert cache.find({"toy:1.1": "f"}) == {"toy:1.1": RECORDS}
    for n in range(3):
        cache.put(f"toy:{n}", "f", RECORDS)
    cache.close()
    assert len(said) == 1
    assert "readonly" in said[0]


def test_what_is_compiled_works_where_no_folder_may_be_written(monkeypatch: pytest.MonkeyPatch) -> None:
    caching = pytest.importorskip("numba.core.caching")
    monkeypatch.setattr(caching.CompileResultCacheImpl, "_locator_classes", [])
    from symcheck.numeric.compiled import compiled

    def successor(number: int) -> int:
        return number + 1

    assert compiled(successor)(1) == 2


WORDS = [
    *("check", "show", "errata", "papers", "generate", "selftest", "plot", "toy", "toy:1.1", "toy:", ":", "other:1"),
    *(
        "--json",
        "--jobs",
        "--timeout",
        "--no-cache",
        "--verdict",
        "--check",
        "--target",
        "--output",
        "--seed",
        "--help",
    ),
    *("0", "-1", "1e999", "nan", "", " ", "-", "--", "---", "\x00", "é", "𝕏", "\udcff", "x" * 5000, "../../etc", "*"),
    *("--faults", "refuted", "proved", "numpy", "c", "--version", "--certificate", "--jobs=99999999999999999999"),
]


def test_silly_arguments_get_one_line_and_an_exit_code(toy: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from symcheck.cli import cli

    monkeypatch.chdir(toy)
    rng = random.Random(5)
    for _ in range(600):
        words = [rng.choice(WORDS) for _ in range(rng.randint(0, 5))]
        if "generate" in words or "selftest" in words or "plot" in words:
            words = ["check", *words]  # those write, or run for minutes
        if "--jobs" not in words:
            words += ["--jobs", "0"]
        result: Result = CliRunner().invoke(cli, words, prog_name="symcheck")
        assert result.exception is None or isinstance(result.exception, SystemExit), (words, result.exception)
        assert result.exit_code in (0, 1, 2), words
        assert "Traceback" not in result.output
        if result.exit_code == 2 and result.stderr:
            assert result.stderr.count("\n") < 3 or "Usage" in result.stderr, (words, result.stderr)


def test_a_partial_ledger_says_that_it_is_partial(toy: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from symcheck.cli import cli

    real = stand_in.decide

    def stopped(id: str) -> tuple[Record, ...]:
        if id == "toy:1.3":
            raise KeyboardInterrupt
        return real(id)

    monkeypatch.setattr(stand_in, "decide", stopped)
    plain = CliRunner().invoke(cli, ["check", "toy", "--jobs", "0"], prog_name="symcheck")
    assert plain.exit_code == 130
    assert "PARTIAL" in plain.output
    assert "1.2a" in plain.output
    told = CliRunner().invoke(cli, ["check", "toy", "--jobs", "0", "--json"], prog_name="symcheck")
    data = json.loads(told.stdout)
    assert data["partial"] is True
    assert [item["id"] for item in data["items"]] == ["toy:1.1", "toy:1.2a", "toy:1.2b"]
