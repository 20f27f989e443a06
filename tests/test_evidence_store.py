"""The files under generated/ depend on the records alone, are written whole, and damage in them is told."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
import stand_in
from msgspec.structs import replace

from symcheck import papers
from symcheck.audit import outputs
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.ledger import Record, store

RECORDS = [record for number in stand_in.NUMBERS for record in stand_in.decide(f"toy:{number}")]
EXPECTED = {record.id: record.verdict for record in RECORDS}


@pytest.fixture(autouse=True)
def _toy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(papers, "load", stand_in.papers)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    store.write(tmp_path, outputs.files(RECORDS))
    return tmp_path


def test_what_was_written_is_read_back(folder: Path) -> None:
    assert store.expected(folder, "toy") == EXPECTED


def test_the_certificate_file_is_one_object_with_all_certificates_one_per_line(folder: Path) -> None:
    text = (folder / "certificates" / "toy.json").read_text(encoding="utf-8")
    data = json.loads(text)
    assert (data["schema"], data["paper"]) == (3, "toy")
    links = [record.certificates[0] for record in RECORDS if record.words and record.certificates]
    whole = [stand_in.CERTIFICATE, stand_in.POINT_WITHOUT, *links[:2], stand_in.REFUTED, stand_in.CORRECTED, *links[2:]]
    assert data["certificates"] == whole
    assert text.count("\n") == len(data["certificates"]) + 2


def test_times_and_row_order_of_fields_do_not_matter() -> None:
    slower = [replace(record, seconds=record.seconds + 1) for record in RECORDS]
    assert outputs.files(slower) == outputs.files(RECORDS)


def test_generating_again_differs_in_nothing(folder: Path) -> None:
    assert store.differences(folder, outputs.files(RECORDS)) == []


def test_missing_superfluous_and_changed_files_are_named(folder: Path) -> None:
    (folder / "certificates" / "gone.json").write_text("{}")
    (folder / "expected" / "toy.json").unlink()
    file = folder / "certificates" / "toy.json"
    file.write_text(file.read_text(encoding="utf-8").replace("2*a_11", "3*a_11", 1), encoding="utf-8")
    assert store.differences(folder, outputs.files(RECORDS)) == [
        "certificates/gone.json: superfluous",
        "certificates/toy.json: differs from line 2 on",
        "expected/toy.json: missing",
    ]


def test_writing_removes_the_files_of_papers_that_are_gone_and_leaves_nothing_else(folder: Path) -> None:
    (folder / "expected" / "gone.json").write_text("{}")
    store.write(folder, outputs.files(RECORDS))
    assert sorted(str(f.relative_to(folder)) for f in folder.rglob("*") if f.is_file()) == [
        "certificates/toy.json",
        "expected/toy.json",
        "statements/toy.json",
    ]


def test_a_failed_write_leaves_the_old_file(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(self: Path, target: Path) -> None:
        raise OSError(28, "No space left on device")

    before = (folder / "expected" / "toy.json").read_bytes()
    monkeypatch.setattr(Path, "replace", fail)
    with pytest.raises(SymcheckError, match="No space left"):
        store.write(folder, outputs.files(RECORDS[:1]))
    assert (folder / "expected" / "toy.json").read_bytes() == before
    assert not list(folder.rglob(".*"))


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "{",
        "null",
        "\x00",
        '{"schema": 2, "paper": "toy", "items": {}}',
        '{"schema": 1, "paper": "other", "items": {}}',
        '{"schema": 1, "paper": "toy"}',
        '{"schema": 1, "paper": "toy", "items": []}',
        '{"schema": 1, "paper": "toy", "items": {"toy:1": "proved"}}',
        '{"schema": 1, "paper": "toy", "items": {"toy:1": ["sure", "as printed"]}}',
    ],
)
def test_a_damaged_expectation_is_one_clear_line(text: str, folder: Path) -> None:
    (folder / "expected" / "toy.json").write_text(text)
    with pytest.raises(SymcheckError) as error:
        store.expected(folder, "toy")
    assert "toy.json cannot be read" in str(error.value)
    assert "\n" not in str(error.value)


def test_a_paper_without_a_file_expects_nothing(tmp_path: Path) -> None:
    assert store.expected(tmp_path, "toy") == {}


def changed(id: str, verdict: Verdict | None) -> list[Record]:
    return [replace(record, verdict=verdict) if record.id == id else record for record in RECORDS]


@pytest.mark.parametrize(
    ("records", "complete", "words"),
    [
        (RECORDS, True, []),
        (RECORDS[:2], False, []),
        (changed("toy:1.1", Verdict.REFUTED), True, ["toy:1.1 newly fails: refuted, recorded as proved"]),
        (changed("toy:1.1", Verdict.UNDECIDED), True, ["toy:1.1 newly fails: undecided, recorded as proved"]),
        (changed("toy:1.3", Verdict.PROVED), True, ["toy:1.3 newly passes: proved, recorded as refuted"]),
        (changed("toy:1.5", Verdict.PROVED), True, ["toy:1.5 newly passes: proved, recorded as claiming nothing"]),
        (changed("toy:1.1", None), True, ["toy:1.1 newly fails: a claim, recorded as proved"]),
        ([replace(RECORDS[0], id="toy:9")], False, ["toy:9 is new (proved)"]),
        (RECORDS[1:], True, ["toy:1.1 is recorded and no longer declared"]),
    ],
)
def test_disagreements_are_named(records: list[Record], complete: bool, words: list[str]) -> None:
    lines = store.disagreements(records, EXPECTED, complete)
    assert len(lines) == len(words)
    assert all(line.startswith(word) for line, word in zip(lines, words, strict=True))


def test_a_paper_of_which_nothing_is_recorded_disagrees_in_one_line() -> None:
    assert store.disagreements(RECORDS, {}, True) == [
        "toy has no recorded verdicts; run `symcheck generate` to record these"
    ]
