"""Ctrl-C is one line and the exit code 130, whichever process is importing, starting or working at that moment."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from limits import interruptible

from symcheck.core import interrupts

# Interrupts the whole group of processes, once, when a process of that kind imports a module of that name.
CUSTOMIZE = """
import os, signal, sys

begun = os.getpid()

def kind():
    if os.getpid() != begun:
        return "worker"
    return "server" if "-c" in sys.orig_argv else "command"

class Watch:
    def find_spec(self, name, path=None, target=None):
        if f"{kind()} {name}" == os.environ["INTERRUPT_AT"]:
            try:
                os.close(os.open(os.environ["INTERRUPTED"], os.O_CREAT | os.O_EXCL))
            except FileExistsError:
                return
            os.killpg(0, signal.SIGINT)

sys.meta_path.insert(0, Watch())
"""
MOMENTS = (
    "command click",
    "command symcheck.audit.run",
    "command symcheck.papers.poloskov2004",
    "command pebble",
    "server multiprocessing.forkserver",
    "server sympy.core",
    "server symcheck.papers.ignatov2005",
    "worker pebble",
)


@pytest.mark.parametrize("moment", MOMENTS)
def test_an_early_interrupt_is_one_line(moment: str, tmp_path: Path, root: Path) -> None:
    (tmp_path / "sitecustomize.py").write_text(CUSTOMIZE, encoding="utf-8")
    env = {
        **os.environ,
        "PYTHONPATH": os.pathsep.join((str(tmp_path), str(root))),
        "INTERRUPT_AT": moment,
        "INTERRUPTED": str(tmp_path / "interrupted"),
    }
    command = [sys.executable, "-m", "symcheck", "check", "--no-cache", "--jobs", "2"]
    own = {"start_new_session": True, "preexec_fn": interruptible}
    with subprocess.Popen(
        command, env=env, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True, **own
    ) as process:
        try:
            _, errors = process.communicate(timeout=60)
        finally:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)
    assert (tmp_path / "interrupted").exists()
    assert errors.splitlines() in (["symcheck: interrupted"], ["symcheck: interrupted; nothing is kept"])
    assert process.returncode == 130


def run(code: str) -> subprocess.CompletedProcess[str]:
    head = "import os, signal, sys, time\nfrom symcheck.core import interrupts\n"
    return subprocess.run(
        [sys.executable, "-c", head + code],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
        preexec_fn=interruptible,
    )


def test_an_interrupt_that_a_destructor_drops_comes_again() -> None:
    found = run(
        "class Dropping:\n"
        "    def __del__(self):\n"
        "        signal.raise_signal(signal.SIGINT)\n"
        "interrupts.raise_from_now_on()\n"
        "try:\n"
        "    Dropping()\n"
        "    print('dropped', flush=True)\n"
        "    time.sleep(30)\n"
        "except KeyboardInterrupt:\n"
        "    print('came again')\n"
    )
    assert (found.stdout, found.stderr) == ("dropped\ncame again\n", "")


def test_other_exceptions_in_destructors_are_reported_as_usual() -> None:
    found = run(
        "class Failing:\n"
        "    def __del__(self):\n"
        "        raise ValueError('told')\n"
        "interrupts.raise_from_now_on()\n"
        "Failing()\n"
    )
    assert "ValueError: told" in found.stderr


def test_a_job_that_ignores_interrupts_goes_on_to_do_so() -> None:
    found = run(
        "signal.signal(signal.SIGINT, signal.SIG_IGN)\n"
        "interrupts.leave_at_once()\n"
        "signal.raise_signal(signal.SIGINT)\n"
        "interrupts.raise_from_now_on()\n"
        "signal.raise_signal(signal.SIGINT)\n"
        "print('still here')\n"
    )
    assert (found.stdout, found.stderr, found.returncode) == ("still here\n", "", 0)


def test_an_interrupt_that_was_withheld_comes_afterwards() -> None:
    reached = []

    def interrupted() -> None:
        with interrupts.withheld():
            signal.raise_signal(signal.SIGINT)
            reached.append("inside")
        reached.append("after")

    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # jobs in the background ignore interrupts
    try:
        with pytest.raises(KeyboardInterrupt):
            interrupted()
    finally:
        signal.signal(signal.SIGINT, before)
    assert reached == ["inside"]


def test_the_exit_code_is_the_same_where_the_interrupt_strikes_in_a_text_that_is_executed() -> None:
    found = run(
        "import symcheck.cli\n"
        "symcheck.cli.check.audited = lambda *_, **__: exec('signal.raise_signal(signal.SIGINT)')\n"
        "sys.argv[1:] = ['check']\n"
        "symcheck.cli.main()\n"
    )
    assert (found.stderr, found.returncode) == ("symcheck: interrupted\n", 130)
