"""A limit of time for what runs in this process: on the main thread of systems with alarms; elsewhere there is none."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType


class OutOfTime(Exception):
    """The limit was reached."""


@contextmanager
def limited(seconds: float) -> Iterator[None]:
    """Raise OutOfTime in what is inside once so many seconds are over; an outer limit stays in force."""
    if not seconds or not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return

    def stop(number: int, frame: FrameType | None) -> None:
        raise OutOfTime

    before, started = signal.signal(signal.SIGALRM, stop), time.monotonic()
    left, _ = signal.setitimer(signal.ITIMER_REAL, seconds)
    if left and left < seconds:
        signal.setitimer(signal.ITIMER_REAL, left)
    try:
        yield
    finally:
        signal.signal(signal.SIGALRM, before)
        rest = left - (time.monotonic() - started)
        signal.setitimer(signal.ITIMER_REAL, max(rest, 0.001) if left else 0)
