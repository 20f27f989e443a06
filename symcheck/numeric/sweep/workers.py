"""Who computes the chunks: threads of this process, or the workers of a dask.distributed scheduler."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, CancelledError, Executor, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from functools import lru_cache
from itertools import islice
from types import MappingProxyType
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from symcheck.numeric.sweep.functions import SweepError, code
from symcheck.numeric.sweep.plan import Plan, plan

T = TypeVar("T")
AHEAD = 2  # chunks that wait for each thread: few, for a worker that dies makes all that it was given suspect
PLANS = 4  # sweeps whose plans a worker keeps: several commands may share a cluster


class Workers(NamedTuple):
    """An executor of chunks.

    window    how many chunks it has at a time
    patience  seconds without a result after which `check` is called; it raises SweepError if nobody works any more
    fatal     what an executor's own exceptions mean
    """

    executor: Executor
    window: int
    patience: float | None = None
    check: Callable[[], None] = lambda: None
    fatal: Mapping[type[BaseException], str] = MappingProxyType({})

    def completed(
        self, function: Callable[..., T], calls: Iterable[tuple[int, tuple[object, ...]]]
    ) -> Iterator[tuple[int, T]]:
        """What the function gives for each call, in the order in which they are ready."""
        waiting, pending = iter(calls), dict[Future[T], int]()
        try:
            while True:
                for number, arguments in islice(waiting, self.window - len(pending)):
                    pending[self.executor.submit(function, *arguments)] = number
                if not pending:
                    return
                done, _ = wait(pending, self.patience, FIRST_COMPLETED)
                if not done:
                    self.check()
                for future in done:
                    yield pending.pop(future), future.result()
        except tuple(self.fatal) as error:
            raise SweepError(next(words for kind, words in self.fatal.items() if isinstance(error, kind))) from None
        finally:
            for future in pending:
                future.cancel()


def compute(text: str, version: str, part: Mapping[str, slice]) -> dict[str, NDArray[np.generic]]:
    """One chunk of the sweep that the JSON describes, wherever this runs."""
    if version != code():
        raise SweepError(
            "a worker has another version of symcheck or NumPy than this process; install the same on both"
        )
    return {name: np.ascontiguousarray(array) for name, array in _plan(text).compute(part).items()}


@lru_cache(maxsize=PLANS)
def _plan(text: str) -> Plan:
    return plan(text)


@contextmanager
def threads(count: int) -> Iterator[Workers]:
    """Threads of this process."""
    with ThreadPoolExecutor(count) as pool:
        yield Workers(pool, AHEAD * count)


@contextmanager
def cluster(address: str, patience: float) -> Iterator[Workers]:
    """The workers of a scheduler; SweepError if there are none, now or later, for so many seconds."""
    from distributed import Client
    from distributed.comm import resolve_address
    from distributed.scheduler import KilledWorker

    for library in ("distributed", "tornado"):  # the error says what goes wrong
        logging.getLogger(library).setLevel(logging.CRITICAL)
    try:
        resolve_address(address)  # a client that cannot read its address tells of that again when it is closed
        client = Client(address, timeout=patience, set_as_default=False)
    except (OSError, ValueError) as error:
        reason = "" if isinstance(error, TimeoutError) else f" ({error})"
        raise SweepError(f"no scheduler answers at {address} within {patience:g} s{reason}") from None

    def check() -> None:
        if not client.nthreads():
            raise SweepError(f"the scheduler at {address} has no workers; start one with `dask worker {address}`")

    fatal = {
        KilledWorker: "one chunk has ended several workers, perhaps for want of memory; take --chunk-memory smaller",
        CancelledError: f"the scheduler at {address} is gone",
    }
    with client:
        try:
            client.wait_for_workers(1, timeout=patience)
        except TimeoutError:
            check()
        count = sum(client.nthreads().values())
        yield Workers(client.get_executor(pure=False), AHEAD * count, patience, check, fatal)
