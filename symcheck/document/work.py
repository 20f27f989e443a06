"""What is asked of a document, spread over worker processes, with one progress for all of it."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import takewhile
from typing import TypeVar

from symcheck.audit.executor import Done, Executor, Timeout
from symcheck.document.checks import Question
from symcheck.question import Answer, Status

K = TypeVar("K")
T = TypeVar("T")
HARD = 3  # times a limit after which a worker that does not heed it is killed
STARTING = 5.0  # seconds more: on a busy machine a worker needs that for its modules
Progress = Callable[[int, int], None]


@dataclass
class Work:
    """Tasks for workers, with one progress for all of them."""

    executor: Executor
    progress: Progress
    done: int = 0
    total: int = 0
    broken: list[str] = field(default_factory=list)  # why tasks ended in errors that should not occur

    def all(
        self,
        function: Callable[[K], T],
        tasks: Sequence[K],
        seconds: float,
        lost: Callable[[str], T],
        until: float = math.inf,
    ) -> dict[K, T]:
        """The answer to each task that is begun in time; what takes too long, or breaks, has the answer of `lost`.

        In time is before `until`, by `time.perf_counter`.
        """
        self.total += len(tasks)
        found: dict[K, T] = {}
        begun = takewhile(lambda _: time.perf_counter() < until, tasks)
        limit = HARD * seconds + STARTING
        for task, answer in self.executor.map(function, begun, limit) if tasks else ():
            if isinstance(answer, Done):
                found[task] = answer.value
            elif isinstance(answer, Timeout):
                found[task] = lost(f"it took more than {limit:g} s")
            else:
                self.broken.append(answer.reason)
                found[task] = lost(f"an internal error: {answer.reason}")
            self.done += 1
            self.progress(self.done, self.total)
        self.total -= len(tasks) - len(found)
        return found


def proved_of(answers: Mapping[Question, Answer]) -> set[Question]:
    """The questions whose answer is a proof."""
    return {question for question, answer in answers.items() if answer.verdict is Status.PROVED}


def undecided(reason: str) -> Answer:
    """The answer where a search did not end."""
    return Answer(Status.UNDECIDED, reason=reason)
