"""Every id gets one answer: a value, a time limit that really killed, or the reason of a crash."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path

import pytest

from symcheck.audit import Crash, Done, Executor, Serial, Timeout
from symcheck.audit.executor import Pool

EXECUTORS = {"serial": Serial(), "pool of one": Pool(1), "pool of two": Pool(2)}


def square(id: str) -> int:
    return int(id) ** 2


def report_and_hang(folder: str) -> int:
    Path(folder, str(os.getpid())).touch()
    time.sleep(3600)
    return 0


def die_on_three(id: str) -> int:
    if id == "3":
        os._exit(9)
    return square(id)


def hang_on_three(id: str) -> int:
    if id == "3":
        time.sleep(3600)
    return square(id)


class Unpicklable(Exception):
    def __init__(self, first: str, second: str) -> None:
        super().__init__(f"{first} {second}")


def raise_unpicklable(id: str) -> int:
    raise Unpicklable("cannot be", "sent")


@pytest.mark.parametrize("executor", EXECUTORS.values(), ids=EXECUTORS.keys())
def test_every_id_is_answered_once(executor: Executor) -> None:
    ids = [str(n) for n in range(20)]
    answers = list(executor.map(square, ids, 60.0))
    assert sorted(answers) == sorted((id, Done(int(id) ** 2)) for id in ids)


@pytest.mark.parametrize("executor", EXECUTORS.values(), ids=EXECUTORS.keys())
def test_nothing_to_do_is_nothing_done(executor: Executor) -> None:
    assert list(executor.map(square, [], 60.0)) == []


@pytest.mark.parametrize("executor", EXECUTORS.values(), ids=EXECUTORS.keys())
def test_an_exception_is_put_in_words(executor: Executor) -> None:
    assert list(executor.map(raise_unpicklable, ["1"], 60.0)) == [("1", Crash("Unpicklable: cannot be sent"))]


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_hanging_worker_is_killed_and_the_others_go_on(jobs: int) -> None:
    answers = dict(Pool(jobs).map(hang_on_three, list("12345"), 1.0))
    assert answers.pop("3") == Timeout(1.0)
    assert answers == {id: Done(int(id) ** 2) for id in "1245"}


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_dying_worker_takes_only_its_own_id_with_it(jobs: int) -> None:
    answers = dict(Pool(jobs).map(die_on_three, list("12345"), 60.0))
    crash = answers.pop("3")
    assert isinstance(crash, Crash)
    assert "died" in crash.reason
    assert answers == {id: Done(int(id) ** 2) for id in "1245"}


def own_process(id: str) -> int:
    return os.getpid()


@pytest.mark.parametrize("jobs", [1, 2])
def test_workers_that_die_between_two_tasks_take_none_with_them(jobs: int) -> None:
    with Pool(jobs).kept() as workers:
        for pid in {answer.value for _, answer in workers.map(own_process, list("1234"), 60.0)}:
            os.kill(pid, signal.SIGKILL)
        answers = dict(workers.map(square, list("12345678"), 60.0))
    assert answers == {id: Done(int(id) ** 2) for id in "12345678"}


def test_after_the_time_limit_no_process_is_left(tmp_path: Path) -> None:
    assert list(Pool(1).map(report_and_hang, [str(tmp_path)], 1.0)) == [(str(tmp_path), Timeout(1.0))]
    [pid] = [int(file.name) for file in tmp_path.iterdir()]
    _wait_until_gone(pid)


def test_an_abandoned_map_leaves_no_process(tmp_path: Path) -> None:
    hanging = Pool(2).map(_either, [str(tmp_path), "5"], 3600.0)
    assert next(hanging) == ("5", Done(25))
    while not (pids := [int(file.name) for file in tmp_path.iterdir()]):
        time.sleep(0.02)
    hanging.close()
    _wait_until_gone(pids[0])


def _either(id: str) -> int:
    return square(id) if id.isdigit() else report_and_hang(id)


def _wait_until_gone(pid: int) -> None:
    """Returns when there is no such process; a killed one may stay a moment until it is reaped."""
    for _ in range(500):
        try:
            os.kill(pid, 0)
        except ProcessLookupError:
            return
        time.sleep(0.02)
    pytest.fail(f"process {pid} is still alive")
