"""A paper in a folder of the user's own: named by its path or in SYMCHECK_PAPERS, with its results beside it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from symcheck import papers
from symcheck.checker.__main__ import main as check_certificates
from symcheck.cli import cli

AUDIT = """
import sys

from symcheck.core.claims import Hypothesis, Paper, Section
from symcheck.papers.declare import claim, definition
from symcheck.proof import nonnegative
from symcheck.reading import Letter, Notation

mass = Hypothesis("mass", "a body has mass", "m > 0", printed=False)
energy = definition("1", 3, r"E = \\frac{m v^2}{2}")
positive = claim("2", 5, r"E \\ge 0", given=[mass], by=nonnegative())
wrong = claim("3", 7, r"2 E = m v")

paper = Paper(
    key="my_notes",
    title="Notes",
    source="notes.tex",
    notation=Notation((Letter("E", meaning="energy"), Letter("m", meaning="mass"), Letter("v", meaning="speed"))),
    sections=(Section("1", "Energy", sys.modules[__name__]),),
)
"""
BROKEN = {
    "paper = 3 +": "audit.py:1: invalid syntax",
    "\npaper = unknown": "audit.py:2: NameError: name 'unknown' is not defined",
    "paper = 1": "is to bind `paper`, a Paper with the key 'my_notes', as its folder is called; it binds none",
    AUDIT.replace("my_notes", "other"): "its key is 'other'",
    AUDIT.replace('"2"', '"1"'): "is declared twice, as energy and positive",
}


@pytest.fixture(autouse=True)
def _apart(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[None]:
    """No paper of one test is one of the papers of the next."""
    monkeypatch.setenv(papers.VARIABLE, "")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    papers.load.cache_clear()
    yield
    for name in [name for name in sys.modules if name.startswith("symcheck.papers.my_notes")]:
        del sys.modules[name]
    papers.load.cache_clear()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    made = tmp_path / "with spaces" / "My Notes"
    made.mkdir(parents=True)
    (made / "audit.py").write_text(AUDIT, encoding="utf-8")
    return made


def run(*arguments: object) -> Result:
    return CliRunner().invoke(cli, [*map(str, arguments)])


def test_it_is_audited_by_its_path_and_its_results_lie_beside_it(folder: Path) -> None:
    first = run("check", folder, "--jobs", 0)
    assert first.exit_code == 1
    assert "2 relations: 1 proved, 1 refuted" in first.stdout
    assert "my_notes has no recorded verdicts" in first.stderr
    assert run("generate", folder, "--jobs", 0).exit_code == 0
    written = [file.relative_to(folder).as_posix() for file in folder.rglob("*.json")]
    assert sorted(written) == [f"generated/{name}/my_notes.json" for name in ("certificates", "expected", "statements")]
    assert run("check", folder, "--jobs", 0).exit_code == 0
    assert run("generate", folder, "--check", "--jobs", 0).exit_code == 0
    assert check_certificates([str(folder / "generated")]) == 0


@pytest.mark.parametrize("name", ["audit.py", ""])
def test_a_relation_is_named_behind_its_path(folder: Path, name: str) -> None:
    shown = run("show", f"{folder / name}:3", "--jobs", 0)
    assert shown.exit_code == 0, shown.output
    assert "refuted" in shown.stdout
    assert "my_notes:3" in shown.stdout


def test_other_commands_take_it_alike(folder: Path, tmp_path: Path) -> None:
    exported = run("export", folder, "--format", "json", "--output", tmp_path / "ledger.json", "--jobs", 0)
    assert exported.exit_code == 0, exported.output
    assert len(json.loads((tmp_path / "ledger.json").read_text(encoding="utf-8"))["items"]) == 3
    assert run("report", folder, "--output", tmp_path / "page.html", "--jobs", 0).exit_code == 0
    listed = run("errata", folder, "--jobs", 0)
    assert "my_notes:3  wrong" in listed.stdout
    assert "1 erratum, refuted" in listed.stdout


def test_workers_know_it(folder: Path) -> None:
    environment = {**os.environ, papers.VARIABLE: str(folder)}
    command = [sys.executable, "-m", "symcheck", "check", "my_notes", "--jobs", "1", "--json"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    verdicts = [item["verdict"] for item in json.loads(done.stdout)["items"]]
    assert verdicts == [None, "proved", "refuted"], done.stderr


@pytest.mark.parametrize("text", BROKEN)
def test_an_error_in_the_file_is_one_line_with_its_place(folder: Path, text: str) -> None:
    (folder / "audit.py").write_text(text, encoding="utf-8")
    result = run("check", folder, "--jobs", 0)
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    assert BROKEN[text] in result.stderr


def test_a_broken_file_does_not_stop_other_papers(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (folder.parent / "broken").mkdir()
    (folder.parent / "broken" / "audit.py").write_text("paper = 3 +", encoding="utf-8")
    monkeypatch.setenv(papers.VARIABLE, os.pathsep.join([str(folder), str(folder.parent / "broken")]))
    monkeypatch.setattr(papers, "__path__", [])
    papers.load.cache_clear()
    result = run("check", "--jobs", 0)
    assert result.exit_code == 2
    assert "2 relations: 1 proved, 1 refuted" in result.stdout
    assert "audit.py:1: invalid syntax" in result.stderr


def test_a_folder_with_the_name_of_a_paper_of_ours_is_refused(tmp_path: Path) -> None:
    (tmp_path / "mirer2009").mkdir()
    result = run("check", f"{tmp_path}/mirer2009")
    assert result.exit_code == 2
    assert f"two papers have the key 'mirer2009': {tmp_path}/mirer2009 and symcheck.papers.mirer2009" in result.stderr


def test_two_folders_of_one_name_are_refused(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    other = folder.parent / "elsewhere" / "my notes"
    other.mkdir(parents=True)
    monkeypatch.setenv(papers.VARIABLE, str(other))
    result = run("check", folder, "--jobs", 0)
    assert result.exit_code == 2
    assert result.stderr.startswith("symcheck: two papers have the key 'my_notes': ")
    assert result.stderr.count("\n") == 1


@pytest.mark.parametrize("value", ["no_such_package.audit", "symcheck.core"])
def test_an_entry_point_that_offers_no_paper_is_named(value: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(papers, "entry_points", lambda group: [EntryPoint("theirs", value, group)])
    result = run("check", "theirs", "--jobs", 0)
    assert result.exit_code == 2
    assert result.stderr.startswith(f"symcheck: {value}, named as the paper 'theirs', cannot be used: ")
