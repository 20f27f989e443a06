"""Many questions: a file of records, answered on all processors, in order, each within a time limit."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import islice

from symcheck.audit.executor import Done, Executor, Timeout
from symcheck.core.terms import JSON
from symcheck.core.verdicts import SymcheckError
from symcheck.question.answer import Answer, Status
from symcheck.question.ask import decide
from symcheck.question.limit import OutOfTime, limited

AT_ONCE = 400  # records that are given to workers, which are replaced after that: it bounds their memory
KEPT, SHORTEST = 0.9, 0.01  # of the limit for repairs too, that a verdict is not lost with them; and seconds at least
HARD = 3  # times the limit after which a worker is killed that does not heed it, or that others keep from working
KEYS = frozenset({"id", "relation", "where", "given", "letters", "units"})
BY_LETTER = ("letters", "units")


@dataclass(frozen=True)
class Asked:
    """One record of a file: its line, its id, and what is asked, or why that cannot be read."""

    line: int
    id: str | int
    question: dict[str, object]
    fault: str = ""


def asked(lines: Iterable[str]) -> Iterator[Asked]:
    """The records of a JSON Lines file; empty lines are left out."""
    for number, text in enumerate(lines, 1):
        if text.strip():
            yield _asked(number, text)


def _asked(number: int, text: str) -> Asked:
    try:
        data = json.loads(text)
    except (ValueError, RecursionError) as error:
        return Asked(number, number, {}, f"line {number} is no JSON ({error})")
    if not isinstance(data, dict):
        return Asked(number, number, {}, f'line {number} is no JSON object; write {{"relation": ...}}')
    id = data.get("id", number)
    if not isinstance(id, str | int):
        return Asked(number, number, {}, f"line {number}: id is no text and no whole number")
    if isinstance(missing := data.get("relation"), str) is False:
        return Asked(
            number,
            id,
            {},
            f"line {number} has no relation" if missing is None else f"line {number}: relation is no text",
        )
    if unknown := sorted(data.keys() - KEYS):
        return Asked(number, id, {}, f"line {number}: unknown key {unknown[0]}; the keys are {', '.join(sorted(KEYS))}")
    question = {key: data[key] for key in KEYS - {"id"} if key in data}
    for key in ("where", "given"):
        value = question.setdefault(key, [])
        if not (isinstance(value, str) or (isinstance(value, list) and all(isinstance(v, str) for v in value))):
            return Asked(number, id, {}, f"line {number}: {key} is no list of texts")
    for key in BY_LETTER:
        said = question.setdefault(key, {})
        if not isinstance(said, dict) or not all(isinstance(v, str) for v in said.values()):
            return Asked(number, id, {}, f"line {number}: {key} is no object of texts")
    return Asked(number, id, question)


def answers(
    records: Sequence[Asked],
    executor: Executor,
    timeout: float,
    progress: Callable[[int], None] = lambda done: None,
) -> Iterator[dict[str, JSON]]:
    """The answers as JSON objects, in the order of the records."""
    todo, done = iter(records), 0
    while part := [*islice(todo, AT_ONCE)]:
        found: dict[int, dict[str, JSON]] = {}
        start = 0
        for task, answer in executor.map(partial(answered, seconds=timeout), part, HARD * timeout):
            if isinstance(answer, Done):
                found[task.line] = answer.value
            else:
                limit = isinstance(answer, Timeout)
                reason = f"the limit of {timeout:g} s was reached" if limit else f"an internal error: {answer.reason}"  # type: ignore[union-attr]
                found[task.line] = {"id": task.id, **Answer(Status.UNDECIDED, reason=reason).as_json()}
            done += 1
            progress(done)
            while start < len(part) and part[start].line in found:
                yield found.pop(part[start].line)
                start += 1


def answered(record: Asked, seconds: float) -> dict[str, JSON]:
    """The answer to one record, with the repairs that are found in what is left of the seconds."""
    if record.fault:
        return {"id": record.id, **Answer(Status.UNREADABLE, reason=record.fault).as_json()}
    started = time.process_time()
    try:
        with limited(seconds):
            answer = decide(**record.question)  # type: ignore[arg-type]
    except OutOfTime:
        reason = f"the limit of {seconds:g} s was reached"
        return {"id": record.id, **Answer(Status.UNDECIDED, reason=reason).as_json()}
    except SymcheckError as error:
        return {"id": record.id, **Answer(Status.UNREADABLE, reason=str(error)).as_json()}
    left = KEPT * seconds - (time.process_time() - started)
    try:
        with limited(max(left, SHORTEST)):
            return {"id": record.id, **answer.as_json()}
    except OutOfTime:
        return {"id": record.id, **replace(answer, slips=tuple).as_json()}


def resumed(records: Sequence[Asked], written: Iterable[str]) -> int:
    """How many of the records are answered in a file that was begun; SymcheckError if it is of other records."""
    count = 0
    for number, text in enumerate(written):
        if not text.endswith("\n"):
            break
        try:
            id = json.loads(text)["id"]
        except (ValueError, TypeError, KeyError) as error:
            raise SymcheckError(
                f"line {number + 1} of the file to resume is no answer; choose another with --output"
            ) from error
        if number >= len(records) or records[number].id != id:
            raise SymcheckError("the file to resume holds answers to other records; choose another with --output")
        count += 1
    return count
