"""What is read of a record is what was written, whole; anything else is an error that names the field."""

from __future__ import annotations

import json
from typing import Any

import pytest
import stand_in

from symcheck.core.verdicts import SymcheckError
from symcheck.ledger import Record

NUMBERS = ("1.1", "1.2", "1.3", "1.4", "1.5")
RECORDS = [record for number in NUMBERS for record in stand_in.decide(f"toy:{number}")]
FAULTS: dict[str, tuple[int, str, dict[str, Any], str]] = {
    "an unknown field": (0, "", {"colour": "red"}, "unknown field `colour`"),
    "an unknown field of a hypothesis": (0, "hypotheses", {"colour": "red"}, "unknown field `colour`"),
    "an unknown field of a correction": (3, "erratum", {"colour": "red"}, "unknown field `colour`"),
    "a number for a text": (0, "", {"printed": 7}, "Expected `str`, got `int`"),
    "an unknown verdict": (0, "", {"verdict": "certain"}, "Invalid enum value 'certain'"),
    "a need without an answer": (0, "hypotheses", {"needed": ...}, "missing required field `needed`"),
    "half an edit": (3, "erratum", {"edit": [{"printed": "x"}]}, "missing required field `corrected`"),
    "no role": (0, "", {"role": ...}, "missing required field `role`"),
    "no verdict of a correction": (3, "erratum", {"verdict": ...}, "missing required field `verdict`"),
    "a point that no certificate has": (3, "", {"counterexample": {"values": {"x": 1}}}, "another counterexample"),
    "a group that it does not belong to": (0, "", {"group": "list rows and table cells"}, "another group"),
    "a domain that its proofs do not have": (0, "", {"domain": {"hypotheses": [], "nonzero": []}}, "another domain"),
}


def changed(data: dict[str, Any], changes: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in (data | changes).items() if value is not ...}


@pytest.mark.parametrize("record", RECORDS, ids=lambda record: record.id)
def test_what_was_written_is_read_back(record: Record) -> None:
    assert Record.from_json(json.loads(json.dumps(record.to_json()))) == record


@pytest.mark.parametrize(("place", "part", "changes", "told"), FAULTS.values(), ids=FAULTS.keys())
def test_a_record_with_a_fault_is_refused_and_the_field_named(
    place: int, part: str, changes: dict[str, Any], told: str
) -> None:
    data = json.loads(json.dumps(RECORDS[place].to_json()))
    if isinstance(of := data.get(part, data), list):
        of[0] = changed(of[0], changes)
    else:
        data = {**data, part: changed(of, changes)} if part else changed(data, changes)
    with pytest.raises(SymcheckError, match=told) as refused:
        Record.from_json(data)
    assert str(refused.value).endswith("; delete the file and run again")
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("data", [None, [], 7, "toy:1.1"], ids=repr)
def test_a_record_must_be_an_object(data: object) -> None:
    with pytest.raises(SymcheckError, match="Expected `object`"):
        Record.from_json(data)


def test_a_hypothesis_that_was_not_weighed_has_no_word_on_its_need() -> None:
    [record] = stand_in.decide("toy:1.1")
    rows = record.to_json()["hypotheses"]
    assert isinstance(rows, tuple)
    assert all("needed" in row for row in rows)
    bare = {
        **record.to_json(),
        "hypotheses": [{key: row[key] for key in ("name", "words", "states", "given")} for row in rows],
    }
    assert [row.need for row in Record.from_json(bare).hypotheses] == [None, None, None]
    assert Record.from_json(bare).to_json()["hypotheses"] == tuple(bare["hypotheses"])  # type: ignore[arg-type]
