"""Limits for what is fed with rubbish: a second for each piece, and 500 MB more than before; processes to interrupt."""

from __future__ import annotations

import resource
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

SECOND, MEMORY = 1.0, 500 * 1024  # seconds, KiB


class Hung(BaseException):
    """It did not come back within a second; no handler of exceptions may swallow this."""


@contextmanager
def within_a_second() -> Iterator[None]:
    """Raises Hung in the middle of what takes longer than a second of computing."""

    def stop(*_: Any) -> None:
        raise Hung

    before = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, SECOND)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


@contextmanager
def little_memory() -> Iterator[None]:
    """Fails if the process has grown by more than 500 MB afterwards."""
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    yield
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < MEMORY


def interruptible() -> None:
    """For a new process: a job in the background of a shell ignores interrupts, and so would its children."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
