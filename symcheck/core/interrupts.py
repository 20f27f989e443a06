"""Ctrl-C: one line and the exit code 130 from the first moment on, and nothing of it in worker processes.

The standard library alone, and little of it: this is imported before anything else.
"""

from __future__ import annotations

import atexit
import os
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import partial
from typing import NoReturn

INTERRUPTED = 130  # as shells report a process that SIGINT ended
AGAIN = 0.02  # seconds until an interrupt that was dropped comes again


def leave_at_once() -> None:
    """From now on an interrupt ends the process: for imports, where an exception may be dropped or told at length.

    What ignores interrupts, as a job in the background of a shell, goes on to do so.
    """
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, _leave)


def raise_from_now_on() -> None:
    """From now on an interrupt is a KeyboardInterrupt, which comes again if it strikes where exceptions are dropped."""
    if signal.getsignal(signal.SIGINT) is _leave:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    if sys.unraisablehook is sys.__unraisablehook__:
        sys.unraisablehook = _unraisable


def leave() -> NoReturn:
    """End an interrupted process, after all that is registered for its end.

    Not by an exception: the interpreter drops what was being done and tells of each error in that, and Python 3.13 ends
    by a signal instead of the exit code where the interrupt struck in a text that was executed, as dataclasses do.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    atexit._run_exitfuncs()
    for stream in (sys.stdout, sys.stderr):
        with suppress(OSError, ValueError):
            stream.flush()
    os._exit(INTERRUPTED)


@contextmanager
def withheld() -> Iterator[None]:
    """Processes that are started here never get an interrupt, from their very first moment; this one gets it after.

    A mask, which they inherit, and not a handler: the interpreter of a new process would put its own in the place.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _leave(*_: object) -> None:
    os.write(2, b"symcheck: interrupted\n")
    os._exit(INTERRUPTED)


def _unraisable(dropped: sys.UnraisableHookArgs) -> None:
    if not isinstance(dropped.exc_value, KeyboardInterrupt):
        sys.__unraisablehook__(dropped)
        return
    from threading import Timer, main_thread

    # to the main thread itself: a signal that another one gets does not wake it where it waits
    main = main_thread().ident
    send = partial(signal.pthread_kill, main) if main and hasattr(signal, "pthread_kill") else signal.raise_signal
    Timer(AGAIN, send, (signal.SIGINT,)).start()
