"""A limit of processor time for what runs in this process, on the main thread of systems with timers.

Elsewhere there is none. What other processes do at the same time changes no verdict.
"""

from __future__ import annotations

import signal
import threading
import time
import weakref
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

AGAIN = 0.5  # seconds until the limit is told again, where what it struck, as many a `try` in SymPy, went on


class OutOfTime(BaseException):
    """The limit was reached; no error, which libraries drop where one way of theirs fails and go on to the next."""


def _is_finalizing(frame: FrameType | None) -> bool:
    """Does the interpreter clean up, where it prints what is raised and drops it? The limit is told again."""
    while frame is not None:
        if frame.f_code.co_name == "__del__" or frame.f_code.co_filename == weakref.__file__:
            return True
        frame = frame.f_back
    return False


@contextmanager
def limited(seconds: float) -> Iterator[None]:
    """Raise OutOfTime in what is inside once it has used so many seconds; an outer limit stays in force."""
    if not seconds or not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return

    def stop(number: int, frame: FrameType | None) -> None:
        if not _is_finalizing(frame):
            raise OutOfTime

    before, started = signal.signal(signal.SIGPROF, stop), time.process_time()
    left, _ = signal.setitimer(signal.ITIMER_PROF, seconds, AGAIN)
    if left and left < seconds:
        signal.setitimer(signal.ITIMER_PROF, left, AGAIN)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)
        rest = left - (time.process_time() - started)
        signal.setitimer(signal.ITIMER_PROF, *((max(rest, 0.001), AGAIN) if left else (0, 0)))
