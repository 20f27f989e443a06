"""What the self-test found is kept whole, read with care, and shown with the evidence it is of."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import stand_in
from click.testing import Result as Outcome

from symcheck import kernels
from symcheck.core.verdicts import Role, SymcheckError, Verdict
from symcheck.kernels.codegen.target import MARK
from symcheck.ledger import Record, selftested, store
from symcheck.selftest.run import Result
from symcheck.selftest.trial import Count, Status
from symcheck.views import figures

RESULT = Result(
    7,
    {"signs": {"plus": Count(Counter({Status.REJECTED: 9, Status.ACCEPTED: 1}), ["accepted plus: x"])}},
    {"signs": {"toy": Count(Counter({Status.REJECTED: 9, Status.ACCEPTED: 1}), misfits=3)}},
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
    assert found["evidence"] == selftested.evidence([a_record("d1")], tmp_path)
    assert found["evidence"] != selftested.evidence([a_record("d2")], tmp_path)
    assert found["classes"] == RESULT["classes"]
    assert "findings" not in found
    assert selftested.files(tmp_path) == {store.SELFTEST: file.read_bytes()}


def _edited(folder: Path, edit: Callable[[dict[str, Any]], object]) -> None:
    file = folder / store.SELFTEST
    data = json.loads(file.read_text("utf-8"))
    edit(data)
    file.write_text(json.dumps(data), encoding="utf-8")


EDITS: dict[str, Callable[[dict[str, Any]], object]] = {
    "a count of all": lambda data: data.update(accepted=0),
    "a count of a class": lambda data: data["classes"]["signs"].update(accepted=0),
    "a class left out": lambda data: data["classes"].update(signs={}),
    "the findings left out": lambda data: data.update(errors=[]),
    "other evidence": lambda data: data["evidence"].update(ledger="another"),
    "no digest": lambda data: data.pop("digest"),
    "an entry more": lambda data: data.update(more=1),
}


@pytest.mark.parametrize("edit", EDITS.values(), ids=EDITS.keys())
def test_what_was_changed_by_hand_is_refused(edit: Callable[[dict[str, Any]], object], tmp_path: Path) -> None:
    selftested.record(tmp_path, RESULT, [a_record("d1")])
    _edited(tmp_path, lambda data: None)
    assert selftested.recorded(tmp_path)
    _edited(tmp_path, edit)
    with pytest.raises(SymcheckError, match=r"selftest\.json cannot be read.*selftest --record"):
        selftested.recorded(tmp_path)


def test_generate_names_what_the_self_test_was_not_done_with(symcheck: Callable[..., Outcome], toy: Path) -> None:
    folder = toy / "generated"
    assert symcheck("generate").exit_code == 0
    known = [record for number in stand_in.NUMBERS for record in stand_in.decide(f"toy:{number}")]
    known += stand_in.decide("other:1")
    selftested.record(folder, RESULT, known)
    figures.write(folder)
    assert symcheck("generate", "--check").exit_code == 0
    selftested.record(folder, RESULT, known[:-1])
    found = symcheck("generate", "--check")
    assert found.exit_code == 1
    assert "selftest.json: of other certificates, ledger; run `symcheck selftest --record`" in found.stderr
    selftested.record(folder, RESULT, known)
    (folder / "toy.py").write_text(f"# {MARK}\n", encoding="utf-8")
    assert selftested.outdated(folder, known) == ["selftest.json: of other kernels; run `symcheck selftest --record`"]
    _edited(folder, EDITS["a count of all"])
    refused = symcheck("generate", "--check")
    assert refused.exit_code == 2
    assert refused.stderr.count("\n") == 1
    assert "selftest.json cannot be read" in refused.stderr


def test_a_class_comes_before_its_kinds_and_all_come_last() -> None:
    rows = selftested.rows(RESULT)
    assert [(row.name, row.of) for row in rows] == [
        ("signs", "class"),
        ("plus", "kind"),
        ("in toy", "paper"),
        ("all", "class"),
    ]
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
