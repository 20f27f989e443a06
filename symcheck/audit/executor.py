"""Runs one function over many tasks: in this process, or in worker processes with a time limit that really kills."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Generator, Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager, suppress
from dataclasses import dataclass, replace
from itertools import chain, islice
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
        """Pairs (task, answer) in order of completion, one per task; no answer takes more than `timeout` seconds.

        Tasks are taken from the iterable shortly before they are begun.
        """
        ...

    def kept(self) -> AbstractContextManager[Executor]:
        """The same for several maps in turn, with workers that keep what they remember from one to the next."""
        ...


class Serial:
    """One task after the other in this process, without a time limit: for debuggers and tests."""

    def map(self, function: Callable[[K], T], tasks: Iterable[K], timeout: float) -> Generator[tuple[K, Answer[T]]]:
        for task in tasks:
            yield task, _attempt(function, task)

    @contextmanager
    def kept(self) -> Iterator[Executor]:
        yield self


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
        waiting = iter(tasks)
        first = [*islice(waiting, self.jobs)]  # no more workers than tasks
        with replace(self, jobs=max(1, len(first))).kept() as workers:
            yield from workers.map(function, chain(first, waiting), timeout)

    @contextmanager
    def kept(self) -> Iterator[Executor]:
        from pebble import ProcessPool

        context = self._context()
        workers = _Workers(lambda: ProcessPool(max_workers=self.jobs, context=context), self.jobs)
        try:
            yield workers
        finally:
            workers.stop()

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


ATTEMPTS = 3  # of a task in pools that broke for another one: a worker that dies between two tasks breaks its pool


class _Workers:
    """The workers of a pool that stays; what is not awaited any more is killed."""

    def __init__(self, made: Callable[[], Any], jobs: int) -> None:
        self.made, self.jobs = made, jobs
        self.pool = made()

    def stop(self) -> None:
        self.pool.stop()
        self.pool.join()

    def map(self, function: Callable[[K], T], tasks: Iterable[K], timeout: float) -> Generator[tuple[K, Answer[T]]]:
        from concurrent.futures import FIRST_COMPLETED, wait
        from concurrent.futures.process import BrokenProcessPool

        waiting, running = iter(tasks), dict[Any, tuple[K, int]]()

        def begin(task: K, attempt: int) -> None:
            with withheld():  # no worker is left half started
                running[self._scheduled(function, task, timeout)] = task, attempt

        try:
            for task in islice(waiting, 2 * self.jobs):
                begin(task, 1)
            while running:
                for future in wait(running, return_when=FIRST_COMPLETED).done:
                    task, attempt = running.pop(future)
                    if attempt < ATTEMPTS and isinstance(future.exception(), BrokenProcessPool):
                        begin(task, attempt + 1)
                        continue
                    for more in islice(waiting, 1):
                        begin(more, 1)
                    yield task, _answer(future, timeout)
        finally:
            for future in running:
                future.cancel()

    def _renew(self) -> None:
        """Other workers in the place of those of a pool that broke."""
        if not self.pool.active:
            self.stop()
            self.pool = self.made()

    def _scheduled(self, function: Callable[[K], T], task: K, timeout: float) -> Any:
        from concurrent.futures import Future

        self._renew()
        try:
            return self.pool.schedule(_attempt, args=(function, task), timeout=timeout)
        except RuntimeError as error:  # no worker could be started
            failed = Future[Any]()
            failed.set_exception(error)
            return failed

    @contextmanager
    def kept(self) -> Iterator[Executor]:
        yield self


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
