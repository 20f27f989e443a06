"""Whatever JSON the checker gets, it answers in words: no traceback, no hang, little memory."""

from __future__ import annotations

import json
import random
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from limits import Hung, little_memory, within_a_second
from statements import FALSE, TRUE

from symcheck.checker import check
from symcheck.checker.__main__ import main
from symcheck.proof import certificate, identity

FEW, MANY = 1_500, 40_000
DEEP: Any = json.loads("[" * 500 + "1" + "]" * 500)
TALL: Any = ["x"]
for _ in range(300):
    TALL = ["+", TALL, 1] if TALL != ["x"] else "x"
RUBBISH: tuple[Any, ...] = (
    *(None, True, False, 0, -1, 1.5, 1e308, float("nan"), float("inf"), 10**4000, -(10**4000), 2**64),
    *("", "x", "sin_x", "sqrt_4", "sqrt_-1", "pi", "infinity", "1/0", "x" * 1_000, "\x00", "x^999", "9" * 4000),
    *([], {}, [[]], [{}], {"rule": "identity"}, ["hyp", "h", 0], ["here", 0], ["positive", "x"], DEEP, TALL),
    *(["^", "x", 10**9], ["^", ["^", ["^", "x", 999], 999], 999], ["/", 1, 0], ["sin", ["*", 10**9, "x"]]),
    *(["pow", 2, 10**9], ["diff", "x", "x", 10**6], ["integral", "x", "x", 0, 1], ["exists", ["x"], ["=", "x", 0]]),
)


@cache
def originals() -> list[dict[str, Any]]:
    return [certificate(problem, identity.decide(problem)) for problem in (*TRUE[:25], *FALSE[:12])]


def _copied(value: Any) -> Any:
    return json.loads(json.dumps(value))  # copy.deepcopy is not up to what is nested so deep


def places(node: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    children = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    if len(path) > 60:
        return [path]
    return [path, *(place for key, child in children for place in places(child, (*path, key)))]


def mutated(rng: random.Random) -> Any:
    """A certificate with one to three places replaced by rubbish, by one another, or dropped."""
    made = _copied(rng.choice(originals()))
    for _ in range(rng.randint(1, 3)):
        path = rng.choice(places(made)[1:] or [()])
        if not path:
            continue
        node: Any = made
        for key in path[:-1]:
            node = node[key]
        if rng.random() < 0.2:
            del node[path[-1]]
        else:
            node[path[-1]] = _copied(rng.choice([*RUBBISH, node[path[-1]], made.get("claim", 0)]))
    return made


def outcome(made: Any) -> str | None:
    try:
        with within_a_second():
            answer = check(made)
    except Hung:
        return "a hang"
    except BaseException as error:
        return f"{type(error).__name__}: {error}"[:200]
    return None if answer is None or (isinstance(answer, str) and answer) else f"the answer {answer!r}"


def fed(count: int, seed: int) -> list[tuple[str, str]]:
    rng = random.Random(seed)
    mutants = (mutated(rng) for _ in range(count))
    return [(wrong, json.dumps(made)[:600]) for made in mutants if (wrong := outcome(made))]


def test_a_damaged_certificate_is_answered_in_words() -> None:
    with little_memory():
        assert fed(FEW, seed=1) == []


@pytest.mark.slow
def test_tens_of_thousands_of_damaged_certificates_are_answered_in_words() -> None:
    with little_memory():
        assert fed(MANY, seed=2) == []


FILES = {
    "deep": "[" * 100_000,
    "a huge number": '{"schema": ' + "9" * 100_000 + "}",
    "deep inside": '{"schema": 3, "certificates": ' + "[" * 100_000 + "]" * 100_000 + "}",
    "a lone surrogate": '{"schema": 3, "certificates": ["\\ud800"]}',
    "twice the same key": '{"schema": 1, "schema": 3, "certificates": []}',
    "nothing": "",
    "zeros": "\x00" * 1000,
    "a certificate that is a list": '{"schema": 3, "certificates": [[]]}',
    "an id that is none": '{"schema": 3, "certificates": [{"id": {}, "claim": []}]}',
}


@pytest.mark.parametrize("content", FILES.values(), ids=FILES)
def test_a_file_of_rubbish_is_told_in_one_line(
    content: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "x.json").write_text(content, encoding="utf-8")
    with within_a_second():
        assert main([str(tmp_path)]) in (1, 2)
    captured = capsys.readouterr()
    assert (captured.err + captured.out).strip()
