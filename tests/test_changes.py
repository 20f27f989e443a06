"""What changed since an older ledger, as `check --against` and `report --against` tell it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from symcheck.cli import cli
from symcheck.core.verdicts import Role, SymcheckError, Verdict
from symcheck.ledger import Record
from symcheck.ledger.changes import Change, changes, older

CLAIM = "mirer2009:2.12"


def record(number: str, **fields: Any) -> Record:
    given: dict[str, Any] = {"role": Role.CLAIM, "verdict": Verdict.PROVED, "printed": "a = b", **fields}
    return Record(id=f"toy:{number}", paper="toy", section="1", line=1, **given)


NOW = (
    record("1"),
    record("2", verdict=Verdict.REFUTED, kind="sign"),
    record("3", verdict=None, role=Role.PREMISE),
    record("4", printed="a = c"),
    record("5"),
)
BEFORE = [
    record("1"),
    record("2"),
    record("3", verdict=None, role=Role.PREMISE),
    record("4"),
    record("6"),
]


def written(items: object, file: Path) -> Path:
    file.write_text(json.dumps({"schema": 1, "items": items}), encoding="utf-8")
    return file


def test_changes_are_those_of_verdict_kind_and_text_and_what_came_and_went(tmp_path: Path) -> None:
    old = older(written([each.to_json() for each in BEFORE], tmp_path / "old.json"))
    assert changes(NOW, old) == [
        Change("toy:2", "proved, now refuted", verdict=True),
        Change("toy:2", "kind: none, now sign"),
        Change("toy:4", "printed otherwise; before: a = b"),
        Change("toy:5", "new"),
        Change("toy:6", "gone"),
    ]
    assert "gone" not in [each.what for each in changes(NOW, old, lambda paper: False)]
    assert changes(BEFORE, old) == []


def test_what_is_recorded_of_a_paper_is_an_older_ledger_too(tmp_path: Path) -> None:
    items = {"toy:1": ["proved", "as printed"], "toy:2": ["proved", "as printed"], "toy:3": [None, "as printed"]}
    old = older(written(items, tmp_path / "expected.json"))
    assert [(each.id, each.what) for each in changes(NOW[:3], old)] == [("toy:2", "proved, now refuted")]


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"items": 3}', '{"items": [1]}', '{"items": {"a": 1}}', "\udcff"])
def test_what_is_no_ledger_is_named(text: str, tmp_path: Path) -> None:
    file = tmp_path / "old.json"
    file.write_bytes(text.encode(errors="surrogateescape"))
    with pytest.raises(SymcheckError, match=r"old\.json is no ledger; give one that `symcheck check --json`"):
        older(file)


def run(*arguments: str) -> Result:
    return CliRunner().invoke(cli, [*arguments, "--jobs", "0"])


def test_check_tells_the_claims_whose_verdict_changed(tmp_path: Path) -> None:
    now = json.loads(run("check", CLAIM, "--json").stdout)["items"]
    same = str(written(now, tmp_path / "same.json"))
    assert "Since same.json: nothing has changed" in run("check", CLAIM, "--against", same).stdout.replace(
        f"{tmp_path}/", ""
    )
    other = str(written([{**now[0], "verdict": "undecided"}], tmp_path / "old.json"))
    told = run("check", CLAIM, "--against", other)
    assert told.exit_code == 0
    assert "old.json: 1 undecided, now proved" in " ".join(told.stdout.split())
    assert f"Other verdicts: 1\n {CLAIM}  undecided, now proved" in told.stdout
    data = json.loads(run("check", CLAIM, "--json", "--against", other).stdout)
    assert data["changes"] == [{"id": CLAIM, "what": "undecided, now proved", "verdict": True}]


@pytest.mark.parametrize("command", ["check", "report"])
def test_an_older_ledger_that_is_none_is_one_line_and_nothing_is_written(command: str, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    more = ["--output", str(page)] if command == "report" else []
    for name in ("missing.json", "bad.json"):
        (tmp_path / "bad.json").write_text("{", encoding="utf-8")
        told = run(command, CLAIM, "--against", str(tmp_path / name), *more)
        assert (told.exit_code, told.stdout, told.stderr.count("\n")) == (2, "", 1)
        assert name in told.stderr
    assert not page.exists()


def test_the_page_shows_what_changed(tmp_path: Path) -> None:
    now = json.loads(run("check", CLAIM, "--json").stdout)["items"]
    old = str(written([{**now[0], "verdict": "undecided"}], tmp_path / "<old>.json"))
    page = tmp_path / "page.html"
    assert run("report", CLAIM, "--output", str(page), "--against", old).exit_code == 0
    text = page.read_text(encoding="utf-8")
    assert "<h2>Against &lt;old&gt;.json</h2><p>1 change.</p>" in text
    assert f'<li><a href="#{CLAIM}">{CLAIM}</a>: undecided, now proved</li>' in text
    assert 'Against &lt;old&gt;.json: <a href="#review">1 change</a>.' in text
    assert run("report", CLAIM, "--output", str(page)).exit_code == 0
    assert "Against &lt;old" not in page.read_text(encoding="utf-8")
