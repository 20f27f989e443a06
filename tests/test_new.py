"""An audit that begins with a document: written, checked as it is, and brought up to date after edits."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from documents import FAULTY

from symcheck import papers
from symcheck.checker.__main__ import main as check_certificates
from symcheck.cli import cli

SHORT = r"""\documentclass{article}
\begin{document}
\begin{equation} E = \frac{m v^2}{2}. \label{eq:energy} \end{equation}
Then
\begin{equation} 2 E = m v^2. \label{eq:twice} \end{equation}
Moreover
\[ 4 E = 2 m v^2. \]
\end{document}
"""
VERDICTS = {"1.2": "refuted", "1.3b": "proved", "1.3c": "refuted", "1.5": "refuted"}


@pytest.fixture(autouse=True)
def _apart(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[None]:
    """No audit of one test is one of the papers of the next."""
    monkeypatch.setenv(papers.VARIABLE, "")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    yield
    forget()


def forget() -> None:
    """As a new process knows nothing of the audits that are loaded."""
    from symcheck.audit import obligation

    for name in [name for name in sys.modules if name.startswith("symcheck.papers.audit")]:
        del sys.modules[name]
    papers.load.cache_clear()
    for cached in (obligation._declared, obligation._paper_context, obligation.users, obligation._digest_of_sources):
        cached.cache_clear()


def run(*arguments: object) -> Result:
    forget()
    return CliRunner().invoke(cli, [*map(str, arguments)])


def begun(folder: Path, text: str, name: str = "paper.tex") -> Path:
    """A fresh audit of a document, beside it."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text(text, encoding="utf-8")
    done = run("new", folder / name, "--out", folder / "audit", "--jobs", 0)
    assert done.exit_code == 0, done.output
    return folder / "audit"


def verdicts(audit: Path) -> dict[str, str]:
    checked = run("check", audit, "--jobs", 0, "--json")
    assert checked.exit_code < 2, checked.output
    items = json.loads(checked.stdout)["items"]
    return {item["id"].partition(":")[2]: item["verdict"] for item in items if item["verdict"]}


def test_a_fresh_audit_decides_without_an_edit(tmp_path: Path) -> None:
    audit = begun(tmp_path / "with spaces", FAULTY)
    assert verdicts(audit) == VERDICTS
    code = (audit / "audit.py").read_text(encoding="utf-8")
    assert 'circle = source.claim("eq:circle", follows=[line_19])' in code
    assert '# source.exclusion("(2.3)", reason=)  # not read: unbalanced bracket' in code
    assert "frac" not in code.partition(")\n\n")[2]  # nothing printed is typed again
    assert run("generate", audit, "--jobs", 0).exit_code == 0
    assert check_certificates([str(audit / "generated")]) == 0
    assert run("check", audit, "--jobs", 0).exit_code == 0


@pytest.mark.parametrize(
    ("name", "text"),
    [
        (
            "paper.md",
            "We have $$E = \\frac{m v^2}{2}$$ and\n\n$$2 E = m v^2.$$\n\nNow $E > 0$ and $$4 E = 3 m v^2.$$\n",
        ),
        ("paper.rst", ".. math:: E = m v^2 / 2\n\nThen\n\n.. math:: 2 E = m v^2\n\nand\n\n.. math:: 4 E = 3 m v^2\n"),
        (
            "paper.tex",
            "\\newcommand{\\en}{E}\\newcommand{\\sq}[1]{#1^2}$$\\en = \\frac{m \\sq{v}}{2}$$ $$2 \\en = m \\sq{v}$$ $$4 \\en = 3 m \\sq v$$",
        ),
        (
            "twice.tex",
            r"\begin{equation}\label{a} E = \frac{m v^2}{2}\end{equation}\begin{equation}\label{a} 2 E = m v^2"
            r"\end{equation}\begin{equation}\label{a} 4 E = 3 m v^2\end{equation}",
        ),
    ],
)
def test_other_documents(name: str, text: str, tmp_path: Path) -> None:
    """Markdown, reStructuredText, macros without sections or labels, and one label three times."""
    assert sorted(verdicts(begun(tmp_path, text, name)).values()) == ["proved", "refuted"]


def test_a_misprint_in_the_source_changes_the_verdict_and_is_told(tmp_path: Path) -> None:
    audit = begun(tmp_path, SHORT)
    assert verdicts(audit) == {"2": "proved", "2.1": "proved"}
    run("generate", audit, "--jobs", 0)
    (tmp_path / "paper.tex").write_text("\n" + SHORT.replace("2 E = m v^2", "2 E = m v^3"), encoding="utf-8")
    checked = run("check", audit, "--jobs", 0)
    assert checked.exit_code == 1
    said = f"{tmp_path}/paper.tex:6: line 6 (2) has changed since it was accepted: was 2 E = m v^2, is 2 E = m v^3;"
    assert said in checked.stderr
    assert "2 relations: 1 proved, 1 refuted" in checked.stdout
    assert checked.stderr.count(" has changed ") == 1  # what has moved has not changed


FAULTS = {
    "a lock of another format": (
        '{"format": "lock 7"}',
        "is no symcheck lock 1; remove it, and `symcheck new --update",
    ),
    "no lock at all": ("\0\1", "is no lock of symcheck; remove it, and `symcheck new --update"),
    "an edited lock": (None, "was edited: eq:twice is not what was accepted"),
}


@pytest.mark.parametrize("case", FAULTS)
def test_a_lock_that_is_none_is_one_line(case: str, tmp_path: Path) -> None:
    audit = begun(tmp_path, SHORT)
    lock, (text, said) = audit / "audit.lock", FAULTS[case]
    lock.write_text(text or lock.read_text(encoding="utf-8").replace("2 E = m v", "2 E = n v"), encoding="utf-8")
    for command in (["check", audit], ["new", "--update", audit]):
        failed = run(*command, "--jobs", 0)
        assert failed.exit_code == 2
        assert said in failed.stderr
        assert failed.stderr.count("\n") == 1


def test_what_is_gone_is_one_line(tmp_path: Path) -> None:
    audit, paper = begun(tmp_path, SHORT), tmp_path / "paper.tex"
    paper.write_text(re.sub(r"Then.*?Moreover", "", SHORT, flags=re.DOTALL), encoding="utf-8")
    failed = run("check", audit, "--jobs", 0)
    assert failed.exit_code == 2
    assert f"{audit}/audit.py:16: {paper} has no eq:twice any more; it was 2 E = m v^2: take this line" in failed.stderr
    paper.unlink()
    failed = run("check", audit, "--jobs", 0)
    assert failed.exit_code == 2
    assert f"{paper} cannot be read (No such file or directory)" in failed.stderr
    assert failed.stderr.count("\n") == 1


def test_a_file_of_the_user_is_never_overwritten(tmp_path: Path) -> None:
    audit = begun(tmp_path, SHORT)
    (audit / "audit.lock").unlink()
    (audit / "audit.py").write_text("mine = 1\n", encoding="utf-8")
    failed = run("new", tmp_path / "paper.tex", "--out", audit, "--jobs", 0)
    assert failed.exit_code == 2
    assert "audit.py exists" in failed.stderr
    assert (audit / "audit.py").read_text(encoding="utf-8") == "mine = 1\n"
    assert not (audit / "audit.lock").exists()


@pytest.mark.parametrize(("data", "said"), [(b"", "is empty"), (b"\0\1\2", "is no text"), (b"words", "has no formula")])
def test_what_is_no_document_begins_no_audit(data: bytes, said: str, tmp_path: Path) -> None:
    (tmp_path / "paper.tex").write_bytes(data)
    failed = run("new", tmp_path / "paper.tex", "--out", tmp_path / "audit", "--jobs", 0)
    assert failed.exit_code == 2
    assert said in failed.stderr
    assert failed.stderr.count("\n") == 1
    assert not (tmp_path / "audit").exists()
