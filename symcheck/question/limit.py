"""A limit of time for what runs in this process: on the main thread of systems with alarms; elsewhere there is none."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

AGAIN = 0.5  # seconds until the limit is told again, where what it struck, as many a `try` in SymPy, went on


class OutOfTime(BaseException):
    """The limit was reached; no error, which libraries drop where one way of theirs fails and go on to the next."""


@contextmanager
def limited(seconds: float) -> Iterator[None]:
    """Raise OutOfTime in what is inside once so many seconds are over; an outer limit stays in force."""
    if not seconds or not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return

    def stop(number: int, frame: FrameType | None) -> None:
        raise OutOfTime

    before, started = signal.signal(signal.SIGALRM, stop), time.monotonic()
    left, _ = signal.setitimer(signal.ITIMER_REAL, seconds, AGAIN)
    if left and left < seconds:
        signal.setitimer(signal.ITIMER_REAL, left, AGAIN)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
        rest = left - (time.monotonic() - started)
        signal.setitimer(signal.ITIMER_REAL, *((max(rest, 0.001), AGAIN) if left else (0, 0)))
