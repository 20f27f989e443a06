"""Runs one function over many tasks: in this process, or in worker processes with a time limit that really kills."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Generator, Iterable
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, Generic, Protocol, TypeVar

from symcheck.core.interrupts import withheld

K = TypeVar("K")
T = TypeVar("T")


@dataclass(frozen=True)
class Done(Generic[T]):
    """The function returned."""

    value: T


@dataclass(frozen=True)
class Timeout:
    """The worker was killed after the time limit."""

    seconds: float


@dataclass(frozen=True)
class Crash:
    """The function raised, or its worker died."""

    reason: str


Answer = Done[T] | Timeout | Crash


class Executor(Protocol):
    """What the audit needs of a way to run things."""

    def map(self, function: Callable[[K], T], tasks: Iterable[K], timeout: float) -> Generator[tuple[K, Answer[T]]]:
        """Pairs (task, answer) in order of completion, one per task; no answer takes more than `timeout` seconds."""
        ...


class Serial:
    """One task after the other in this process, without a time limit: for debuggers and tests."""

    def map(self, function: Callable[[K], T], tasks: Iterable[K], timeout: float) -> Generator[tuple[K, Answer[T]]]:
        for task in tasks:
            yield task, _attempt(function, task)


@dataclass(frozen=True)
class Pool:
    """`jobs` worker processes; `preload` names the modules each of them starts with.

    Workers come from a fork server, where the platform has one: it imports the preloaded modules once, so that a
    worker that takes the place of a killed one costs milliseconds, and nothing forks a process that has threads. An
    interrupt is for this process alone, which stops them: the server is started with interrupts withheld, and what
    it forks inherits that.
    """

    jobs: int
    preload: tuple[str, ...] = ()

    def map(self, function: Callable[[K], T], tasks: Iterable[K], timeout: float) -> Generator[tuple[K, Answer[T]]]:
        from concurrent.futures import as_completed

        from pebble import ProcessPool

        waiting = list(tasks)
        pool: Any = ProcessPool(max_workers=max(1, min(self.jobs, len(waiting))), context=self._context())
        try:
            with withheld():  # no worker is left half started
                futures = {pool.schedule(_attempt, args=(function, task), timeout=timeout): task for task in waiting}
            for future in as_completed(futures):
                yield futures[future], _answer(future, timeout)
        finally:
            pool.stop()
            pool.join()

    def _context(self) -> Any:
        from multiprocessing import get_all_start_methods, get_context

        if "forkserver" not in get_all_start_methods():
            return get_context("spawn")
        from multiprocessing import forkserver, resource_tracker

        context = get_context("forkserver")
        context.set_forkserver_preload(["symcheck.audit.worker", *self.preload])
        resource_tracker.ensure_running()  # before the server: to start it lets interrupts through
        with withheld():
            forkserver.ensure_running()
        try:
            first = context.Process(target=_nothing)
            first.start()  # returns when all is imported
            first.join()
        except KeyboardInterrupt:
            _kill_server()
            raise
        return context


def _nothing() -> None:
    """The task of a process whose end is all that matters."""


def _kill_server() -> None:
    """Kill the fork server, which would still fork what was asked of it, when nobody is there any more."""
    from multiprocessing import forkserver

    pid = getattr(getattr(forkserver, "_forkserver", None), "_forkserver_pid", None)  # known nowhere else
    if pid is not None:
        with suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)


def _attempt(function: Callable[[K], T], task: K) -> Done[T] | Crash:
    """The answer of `function`; an exception as words, because not every exception survives pickling."""
    try:
        return Done(function(task))
    except Exception as error:
        return Crash(f"{type(error).__name__}: {error}".rstrip(": "))


def _answer(future: Any, timeout: float) -> Answer[Any]:
    try:
        return future.result()  # type: ignore[no-any-return]
    except TimeoutError:
        return Timeout(timeout)
    except Exception as error:  # the worker died: pebble raises a different exception for each cause
        return Crash(f"the worker process died ({error})")
