"""What the self-test found is kept whole, read with care, and shown with the evidence it is of."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from symcheck import kernels
from symcheck.evidence import selftested, store
from symcheck.evidence.record import Record
from symcheck.selftest.run import Result
from symcheck.selftest.trial import Count, Fate
from symcheck.statement import Role, SymcheckError, Verdict

RESULT = Result(
    7, {"signs": {"plus": Count(Counter({Fate.REJECTED: 9, Fate.ACCEPTED: 1}), ["accepted plus: x"])}}
).to_json()


def a_record(digest: str) -> Record:
    certificate = {"digest": digest, "verdict": "proved", "hypotheses": {}, "proof": {}}
    common = {"paper": "toy", "section": "1", "line": 1}
    return Record(id="toy:1", role=Role.CLAIM, verdict=Verdict.PROVED, certificates=(certificate,), **common)


def test_what_is_recorded_is_read_again_with_its_evidence(tmp_path: Path) -> None:
    assert selftested.recorded(tmp_path) is None
    assert selftested.files(tmp_path) == {}
    file = selftested.record(tmp_path, RESULT, [a_record("d1")])
    found = selftested.recorded(tmp_path)
    assert found
    assert found["evidence"] == selftested.evidence([a_record("d1")]) != selftested.evidence([a_record("d2")])
    assert found["classes"] == RESULT["classes"]
    assert "findings" not in found
    assert selftested.files(tmp_path) == {store.SELFTEST: file.read_bytes()}


def test_a_class_comes_before_its_kinds_and_all_come_last() -> None:
    rows = selftested.rows(RESULT)
    assert [(row.name, row.is_class) for row in rows] == [("signs", True), ("plus", False), ("all", True)]
    assert {row.rate for row in rows} == {"90.00 % (55.50 to 99.75)"}
    assert selftested.Row("none", True, Count().to_json()).rate == ""


@pytest.mark.parametrize("text", ["", "[]", '{"schema": 2}', '{"schema": 1, "classes": {}}', "\0"])
def test_a_damaged_result_is_refused_in_words(text: str, tmp_path: Path) -> None:
    (tmp_path / store.SELFTEST).write_text(text)
    with pytest.raises(SymcheckError, match="delete it, or run `symcheck selftest --record`"):
        selftested.recorded(tmp_path)


def test_what_is_checked_in_planted_enough_and_missed_little() -> None:
    found = selftested.recorded(kernels.folder())
    assert found
    assert found["planted"] >= 20_000
    assert found["rejected"] >= 0.999 * (found["rejected"] + found["accepted"])
    assert found["classes"]["rewritings"]["right"] >= 500
    assert found["false_rejections"] == 0
    assert found["unfinished"] == []
    assert found["engines"]["disagreements"] == []
