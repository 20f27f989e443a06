"""The command line as a process: signals, pipes, worker processes, and what it imports."""

from __future__ import annotations

import os
import signal
import sqlite3
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from limits import interruptible

START = [sys.executable, str(Path(__file__).with_name("stand_in.py"))]
DEADLINE = 60.0


@pytest.fixture
def environment(tmp_path: Path, root: Path) -> dict[str, str]:
    return {
        **os.environ,
        "PYTHONPATH": str(root),
        "SYMCHECK_CACHE": str(tmp_path / "cache"),
        "STAND_IN_LOG": str(tmp_path / "decided"),
    }


def run(*arguments: str, env: dict[str, str], **more: Any) -> subprocess.CompletedProcess[str]:
    return subprocess.run([*START, *arguments], env=env, capture_output=True, text=True, timeout=DEADLINE, **more)


def until(condition: Callable[[], bool]) -> None:
    end = time.monotonic() + DEADLINE
    while not condition():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.02)


def cached(folder: Path) -> int:
    file = folder / "records.sqlite"
    if not file.exists():
        return 0
    connection = sqlite3.connect(file)
    try:
        return int(connection.execute("SELECT count(*) FROM records").fetchone()[0])
    except sqlite3.OperationalError:
        return 0
    finally:
        connection.close()


def test_ctrl_c_keeps_what_is_done(environment: dict[str, str], tmp_path: Path) -> None:
    env = {**environment, "STAND_IN_MORE": "hang"}
    command = [*START, "check", "toy", "--jobs", "1", "--timeout", "3600"]
    own = {"start_new_session": True, "preexec_fn": interruptible}
    with subprocess.Popen(command, env=env, stderr=subprocess.PIPE, text=True, **own) as process:
        try:
            until(lambda: cached(tmp_path / "cache") == 6)
            until(lambda: "toy:hang" in (tmp_path / "decided").read_text())
            os.killpg(process.pid, signal.SIGINT)
            _, errors = process.communicate(timeout=DEADLINE)
        finally:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)
    assert process.returncode == 130
    assert errors == "symcheck: interrupted; 6 of 7 declarations are decided and kept\n"
    (tmp_path / "decided").unlink()
    run("check", "toy", env=environment)
    assert not (tmp_path / "decided").exists()


def test_time_limits_crashes_and_exceptions_leave_a_whole_ledger(environment: dict[str, str]) -> None:
    env = {**environment, "STAND_IN_MORE": "hang die raise"}
    result = run("check", "toy", "--timeout", "1", env=env)
    assert "10 relations" not in result.stderr
    assert "9 relations: 4 proved, 1 refuted, 4 undecided" in result.stdout
    assert "Traceback" not in result.stderr


def test_a_reader_may_leave_early(environment: dict[str, str]) -> None:
    env = {**environment, "STAND_IN_MORE": " ".join(f"2.{n}" for n in range(500))}
    with subprocess.Popen(
        [*START, "check", "toy", "--jobs", "0"], env=env, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdout
        assert process.stderr
        process.stdout.read(1)
        process.stdout.close()
        errors = process.stderr.read()
    assert process.wait(DEADLINE) == 141
    assert errors == b""


def test_the_terminal_may_lack_letters(environment: dict[str, str]) -> None:
    result = run("show", "toy:1.1", env={**environment, "PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0", "LC_ALL": "C"})
    assert result.returncode == 0, result.stderr


HEAVY = "[name for name in ('sympy.core', 'flint', 'lark', 'multiprocessing', 'pebble') if name in sys.modules]"


def test_help_and_version_import_nothing_heavy(environment: dict[str, str]) -> None:
    code = (
        "import sys, symcheck.cli\n"
        "for arguments in (['--help'], ['check', '--help'], ['--version']):\n"
        "    symcheck.cli.cli(arguments, standalone_mode=False)\n"
        f"print({HEAVY} + [name for name in ('rich', 'sqlite3') if name in sys.modules])"
    )
    result = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
    assert result.stdout.splitlines()[-1] == "[]"


def test_a_warm_check_imports_nothing_heavy(environment: dict[str, str], root: Path) -> None:
    code = (
        "import sys, stand_in, symcheck.cli\n"
        "stand_in.install()\n"
        "symcheck.cli.check._compare = lambda *arguments: None\n"
        "symcheck.cli.cli(['check', 'toy'], standalone_mode=False)\n"
        f"print({HEAVY})"
    )
    env = {**environment, "PYTHONPATH": os.pathsep.join((str(root), str(root / "tests")))}
    run("check", "toy", env=env)
    result = subprocess.run([sys.executable, "-c", code], env=env, capture_output=True, text=True, check=True)
    assert result.stdout.splitlines()[-1] == "[]"


def test_a_paper_is_imported_only_when_it_is_asked_for() -> None:
    code = (
        "import sys; from symcheck.papers import load; papers = load(); papers['mirer2009']; list(papers);"
        "print(*[name for name in sys.modules if name.startswith('symcheck.papers.') and name.count('.') == 2])"
    )
    imported = set(
        subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout.split()
    )
    assert imported == {"symcheck.papers.mirer2009", "symcheck.papers.declare"}


def test_python_m_symcheck_is_the_command(environment: dict[str, str]) -> None:
    command = [sys.executable, "-m", "symcheck", "--version"]
    result = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert result.stdout.startswith("symcheck, version ")
