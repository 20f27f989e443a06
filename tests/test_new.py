"""An audit that begins with a document: written, checked as it is, and brought up to date after edits."""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from documents import FAULTY, SOUND

from symcheck import papers
from symcheck.checker.__main__ import main as check_certificates
from symcheck.cli import cli
from symcheck.core.verdicts import SymcheckError
from symcheck.document.look import look
from symcheck.document.rewriting import Rule, rewritten
from symcheck.question import Status

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
    os.environ[papers.VARIABLE] = ""
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


def test_what_is_right_instead_is_proved_for_matrices_of_all_sizes(tmp_path: Path) -> None:
    audit = begun(tmp_path, r"$$(\mathbf{A} \mathbf{B})^T = \mathbf{A}^T \mathbf{B}^T$$ for all matrices.")
    code = (audit / "audit.py").read_text(encoding="utf-8")
    right = r"(\mathbf{A} \mathbf{B})^T = \mathbf{B}^T \mathbf{A}^T"
    erratum = f'Erratum(r"{right}", "order", Origin.PAPER, "the factors change places")'
    code = re.sub(r"claim\(([^)]*)\)", lambda found: f'claim({found[1]}, given=[], errata={{"": {erratum}}})', code)
    head = "from symcheck.core.claims import Erratum\nfrom symcheck.core.verdicts import Origin\n"
    (audit / "audit.py").write_text(head + code, encoding="utf-8")
    assert "then          proved for matrices and vectors of all sizes" in run("errata", audit, "--jobs", 0).stdout
    assert run("generate", audit, "--jobs", 0).exit_code == 0
    assert check_certificates([str(audit / "generated")]) == 0


def test_faults_are_planted_in_what_a_document_prints_and_all_are_noticed(tmp_path: Path) -> None:
    audit = begun(tmp_path, SHORT)
    done = run("selftest", audit, "--jobs", 0, "--json")
    assert done.exit_code == 0, done.output
    counts = json.loads(done.stdout)["classes"]
    assert [*counts] == ["documents"]
    assert counts["documents"]["rejected"] >= 20
    assert counts["documents"]["accepted"] == 0
    assert run("selftest", audit, "--record").exit_code == 2


def test_an_audit_that_proves_everything_of_a_document_is_noticed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    audit = begun(tmp_path, SHORT)
    run("check", audit, "--jobs", 0)
    monkeypatch.setattr("symcheck.document.asked.Inquiry.verdict", lambda self, link: Status.PROVED)
    done = run("selftest", audit, "--jobs", 0, "--json")
    assert done.exit_code == 1
    assert json.loads(done.stdout)["classes"]["documents"]["accepted"] >= 20


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
            r"\newcommand{\en}{E}\newcommand{\sq}[1]{#1^2}$$\en = \frac{m \sq{v}}{2}$$ $$2 \en = m \sq{v}$$"
            r"$$4 \en = 3 m \sq v$$",
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


# vectors in plain letters, quotes within dollars, and a skew matrix with its cross within the brackets
KINEMATICS = r"""# The motion of a point

The point stands at $r = [0, b, 0]^T$. Its acceleration is
$$\ddot r_{abs} = \dot\omega \times r + \omega \times (\omega \times r)$$
For a rotation $`\omega = [0, 0, w]^T`$ the tangential term becomes
$$\dot\omega \times r = \begin{bmatrix} 0 \\ 0 \\ \dot w \end{bmatrix} \times \begin{bmatrix} 0 \\ b \\ 0 \end{bmatrix}
= \begin{bmatrix} -\dot w b \\ 0 \\ 0 \end{bmatrix}$$
The rates of the parameters are
$$\dot{\boldsymbol\sigma} = \frac{1}{4} \left[\mathbf{I}_3 + 2 [\boldsymbol\sigma \times]\right] \boldsymbol\Omega$$
"""


def test_vectors_in_plain_letters_are_known_by_what_they_are_equal_to(tmp_path: Path) -> None:
    audit = begun(tmp_path / "right", KINEMATICS, "paper.md")
    assert verdicts(audit) == {"0.4a": "proved", "0.4b": "proved"}
    wrong = begun(tmp_path / "wrong", KINEMATICS.replace("[0, b, 0]", "[0, 2 b, 0]"), "paper.md")
    assert verdicts(wrong) == {"0.4a": "undecided", "0.4b": "proved"}
    assert not look(tmp_path / "right" / "paper.md").findings


ASSIGNED = r"""# An angle

The angle is $\phi = |\vec e|$. If it is the long way round, then
$$\phi = -\phi$$
and the next one follows by
$$n = n + 1$$
so that altogether
$$\phi^2 = \vec e \cdot \vec e$$
"""


def test_what_becomes_something_of_itself_is_neither_claimed_nor_taken_for_granted(tmp_path: Path) -> None:
    audit = begun(tmp_path, ASSIGNED, "paper.md")
    assert [*verdicts(audit).values()] == ["proved"]
    assert (audit / "audit.py").read_text(encoding="utf-8").count("a letter becomes something of itself") == 2
    assert not look(tmp_path / "paper.md").findings


TWO_WAYS = r"""# A function in two ways

The function is
$$V_{\bm\omega} = \alpha (\beta + \gamma)^2$$
and for equal angles
$$\gamma = \beta$$
so that altogether
$$V_{\omega} = 4 \alpha \beta^2$$
"""


def test_what_is_printed_in_two_ways_is_made_one_letter_by_a_rule_that_is_told(tmp_path: Path) -> None:
    audit = begun(tmp_path, TWO_WAYS, "paper.md")
    assert r'rules=[r"_{\bm\omega} -> _{\omega}"]' in (audit / "audit.py").read_text(encoding="utf-8")
    assert [*verdicts(audit).values()] == ["proved"]


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


def test_an_edit_of_a_letter_decides_anew_only_where_it_stands(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from symcheck.audit import decide

    audit = begun(
        tmp_path, SHORT.replace(r"\end{document}", r"\[ a + \frac{a}{b} = \frac{a b + a}{b}. \] \end{document}")
    )
    before, decided = verdicts(audit), list[str]()
    assert list(before) == ["2", "2.1", "2.2"]
    function = decide.decide
    monkeypatch.setattr(decide, "decide", lambda id: (decided.append(id), function(id))[1])
    assert verdicts(audit) == before
    assert decided == []
    file = audit / "audit.py"
    code, energies = file.read_text(encoding="utf-8"), ["audit:1", "audit:2", "audit:2.1"]
    for unit, changed in (("kg", energies), ("", energies)):
        edited = re.sub(r'letter\("m"[^)]*\)', f'letter("m", unit="{unit}")', code)
        assert edited != code
        file.write_text(edited, encoding="utf-8")
        assert verdicts(audit) == before
        assert decided == changed
        decided.clear()
    paper = tmp_path / "paper.tex"
    paper.write_text("\n" + paper.read_text(encoding="utf-8").replace("a b + a", "a + a b"), encoding="utf-8")
    moved = json.loads(run("check", audit, "--jobs", 0, "--json").stdout)["items"]
    assert [(item["verdict"], item["line"]) for item in moved if item["id"] in ("audit:2", "audit:2.1")] == [
        ("proved", 6),
        ("proved", 8),
    ]
    assert decided == ["audit:2.2"]  # where something is printed otherwise


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


EDITS = {
    ('letter("v")', 'letter("v", "functon of t")'): "letter v: v is said to be 'functon of t', which is not understood",
    ('letter("v")', 'letter("v"), letter("v")'): "letter v is declared twice",
    ('"eq:twice"', '"eq:twise"'): "paper.tex has no relation 'eq:twise'; did you mean 'eq:twice'?",
    ("follows=[energy]", "folows=[energy]"): "unexpected keyword argument 'folows'",
    ("follows=[energy])\nline", "follows=[energie])\nline"): "name 'energie' is not defined",
    ("twice =", "again = source.premise('eq:twice')\ntwice ="): "is declared twice, as again and twice",
}


@pytest.mark.parametrize("edit", EDITS)
def test_a_slip_of_the_user_is_one_line(edit: tuple[str, str], tmp_path: Path) -> None:
    audit = begun(tmp_path, SHORT)
    code = (audit / "audit.py").read_text(encoding="utf-8")
    assert edit[0] in code
    (audit / "audit.py").write_text(code.replace(*edit), encoding="utf-8")
    failed = run("check", audit, "--jobs", 0)
    assert failed.exit_code == 2
    assert EDITS[edit] in failed.stderr
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


NOTES = """We have
$$E = \\frac{m v^2}{2}$$
and
$$2 E = m v^2.$$
Now $E > 0$ and
$$4 E = 3 m v^2.$$
$$4 E = 3 m v^2.$$
also $$a += 3$$
"""


def test_an_update_keeps_what_the_user_wrote(tmp_path: Path) -> None:
    """Relations that move are named anew, those that change are told, new ones are added behind their neighbours."""
    audit, paper = begun(tmp_path, NOTES, "paper.md"), tmp_path / "paper.md"
    code = (audit / "audit.py").read_text(encoding="utf-8")
    mine = code.replace('line_6 = source.claim("line 6",', 'ä = 1; line_6 = source.claim(r"line 6",')
    mine = mine.replace("paper =", "# mine: line 4\nunder = {'line 4': 4}\n\npaper =")
    assert mine.count("mine") == 1
    (audit / "audit.py").write_text(mine, encoding="utf-8")
    edited = NOTES.replace("We have", "We\n\nnow have $$p = m v$$\n").replace("2 E = m v^2", "2 E = m v^3")
    paper.write_text(edited.replace("also", "also $$2 E = p v$$"), encoding="utf-8")
    done = run("new", "--update", audit, "--jobs", 0)
    assert done.exit_code == 0, done.output
    for said in (
        f"{paper}:7: line 7 has changed: was 2 E = m v^2, is 2 E = m v^3",
        f"{paper}:3: new, and added: p = m v",
        'new, and to be added to its letters: letter("p"),',
    ):
        assert said in done.stdout
    line = re.compile(r"line (\d+)")
    moved = {"2": "5", "4": "7", "5": "8", "6": "9", "8": "11"}
    before, after = mine.split("\n"), (audit / "audit.py").read_text(encoding="utf-8").split("\n")
    assert [each for each in after if "line_3 = " in each or "line_11 = " in each] == [
        'line_3 = source.definition("line 3")',
        'line_11 = source.claim("line 11", follows=[line_3, line_2, line_5])',
    ]
    kept = [each for each in after if not each.startswith(("line_3", "line_11"))]
    named = [line.sub(lambda x: f"line {moved[x[1]]}", e) if "source." in e else e for e in before]
    assert [each.replace("line 11 #2", "line 11") for each in kept] == [e.replace('r"line', '"line') for e in named]
    assert run("new", "--update", audit, "--jobs", 0).stdout.endswith(f"{audit}/audit.lock: nothing has changed\n")
    assert verdicts(audit) == {"0.3": "refuted", "0.5": "refuted", "0.6": "refuted", "0.7": "proved"}


def test_a_label_that_is_another_one_is_found_by_content(tmp_path: Path) -> None:
    audit, paper = begun(tmp_path, SHORT), tmp_path / "paper.tex"
    paper.write_text(SHORT.replace("eq:twice", "eq:double"), encoding="utf-8")
    checked = run("check", audit, "--jobs", 0)
    assert "moved since it was accepted: eq:twice to eq:double" in checked.stderr
    assert run("new", "--update", audit, "--jobs", 0).exit_code == 0
    assert 'twice = source.claim("eq:double", follows=[energy])' in (audit / "audit.py").read_text(encoding="utf-8")
    assert "moved" not in run("check", audit, "--jobs", 0).stderr


def test_of_two_equal_relations_the_one_that_is_left_is_found(tmp_path: Path) -> None:
    audit, paper = begun(tmp_path, NOTES, "paper.md"), tmp_path / "paper.md"
    paper.write_text(NOTES.replace("$$4 E = 3 m v^2.$$\n", "", 1), encoding="utf-8")
    done = run("new", "--update", audit, "--jobs", 0)
    assert f"is gone: it was 4 E = 3 m v^2; take {audit}/audit.py:20 out" in done.stdout
    assert run("check", audit, "--jobs", 0).exit_code == 2


def test_what_cannot_be_written_leaves_both_files_as_they_are(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from symcheck.document import scaffold

    audit, paper = begun(tmp_path, NOTES, "paper.md"), tmp_path / "paper.md"
    before = [file.read_bytes() for file in sorted(audit.glob("audit.*"))]
    paper.write_text("\n" + NOTES, encoding="utf-8")
    put = scaffold.put

    def full(file: Path, data: bytes) -> None:
        if file.name == "audit.py":
            raise OSError(28, "No space left on device", str(file))
        put(file, data)

    monkeypatch.setattr(scaffold, "put", full)
    failed = run("new", "--update", audit, "--jobs", 0)
    assert (
        failed.stderr
        == f"symcheck: {audit}/audit.py cannot be written (No space left on device); name another folder\n"
    )
    assert [file.read_bytes() for file in sorted(audit.glob("audit.*"))] == before
    failed = run("new", paper, "--out", tmp_path / "other", "--jobs", 0)
    assert failed.exit_code == 2
    assert not list((tmp_path / "other").iterdir())
    failed = run("new", paper, "--out", paper / "audit", "--jobs", 0)
    assert failed.exit_code == 2
    assert "(Not a directory)" in failed.stderr


def test_every_refutation_is_an_erratum_and_nothing_else(tmp_path: Path) -> None:
    audit = begun(tmp_path, FAULTY)
    listed = run("errata", audit, "--jobs", 0)
    assert listed.exit_code == 0
    assert re.findall(r"^audit:(\S+)", listed.stdout, re.MULTILINE) == ["1.2", "1.3c", "1.5"]
    assert "3 errata" in listed.stdout
    for kind, formula in (("markdown", "$q^2 + p^2 = 1$"), ("tex", "$q^2 + p^2 = 1$"), ("json", '"audit:1.5"]')):
        assert formula in run("export", audit, "--format", kind, "--jobs", 0).stdout
    letter = run("errata", audit, "--format", "letter", "--jobs", 0).stdout
    assert "**3.** (1.5), line 21." in letter
    assert "**4.**" not in letter
    assert run("report", audit, "--output", tmp_path / "page.html", "--jobs", 0).exit_code == 0
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert page.count('<article class="fault"') == 3
    assert "<dt>correct</dt>" not in page


def test_a_correction_is_proved(tmp_path: Path) -> None:
    audit = begun(tmp_path, FAULTY)
    code = (audit / "audit.py").read_text(encoding="utf-8")
    for right, then in (("q^2 + p^2 = 1", "proved"), ("q^2 + p^2 = 3", "refuted")):
        errata = f'errata={{"": Erratum("{right}", "number", Origin.PAPER, "it is the unit circle")}}'
        head = "from symcheck.core.claims import Erratum\nfrom symcheck.core.verdicts import Origin\n"
        mended = head + code.replace("follows=[line_19]", f"follows=[line_19], {errata}")
        (audit / "audit.py").write_text(mended, encoding="utf-8")
        shown = run("show", f"{audit}:1.5", "--jobs", 0).stdout
        assert re.search(rf"^corrected +{re.escape(right)}$", shown, re.MULTILINE)
        assert re.search(rf"^then +{then}$", shown, re.MULTILINE)
        assert run("generate", audit, "--jobs", 0).exit_code == 0
        assert check_certificates([str(audit / "generated")]) == 0


def test_problems_are_told_at_their_lines(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    audit = begun(tmp_path / "a b", FAULTY)
    monkeypatch.chdir(tmp_path)
    plain = run("check", audit, "--format", "plain", "--jobs", 0).stdout.splitlines()
    assert [line.split(": ")[:3] for line in plain] == [
        ["a b/paper.tex:11", "refuted", "1.2"],
        ["a b/paper.tex:14", "proved", "1.3b"],
        ["a b/paper.tex:14", "refuted", "1.3c"],
        ["a b/paper.tex:21", "refuted", "1.5"],
    ]
    assert "fails at s = 3, where the sides are 1 against 2; one slip away holds: q^2 + p^2 = 1" in plain[3]
    [log] = json.loads(run("check", audit, "--format", "sarif", "--jobs", 0).stdout)["runs"]
    rules = {rule["id"] for rule in log["tool"]["driver"]["rules"]}
    assert [(each["kind"], each["level"]) for each in log["results"]] == [
        ("fail", "error"),
        ("pass", "none"),
        ("fail", "error"),
        ("fail", "error"),
    ]
    for each, line in zip(log["results"], (11, 14, 14, 21), strict=True):
        [where] = each["locations"]
        assert each["ruleId"] in rules
        assert where["physicalLocation"]["artifactLocation"]["uri"] == "a%20b/paper.tex"
        assert where["physicalLocation"]["region"]["startLine"] == line


def test_an_included_file_and_a_cell_are_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "part").mkdir()
    (tmp_path / "part" / "one.tex").write_text("\n$$2 (a + b) = 2 a + b$$\n", encoding="utf-8")
    audit = begun(tmp_path, "\\input{part/one}\n$$a + b = b + a$$\n")
    monkeypatch.chdir(tmp_path)
    plain = run("check", audit, "--format", "plain", "--jobs", 0).stdout.splitlines()
    assert [line.split(": ")[:2] for line in plain] == [["part/one.tex:2", "refuted"], ["paper.tex:2", "proved"]]
    cells = [{"cell_type": "markdown", "source": "$$a + b = b - a$$"}]
    audit = begun(tmp_path / "book", json.dumps({"cells": cells, "nbformat": 4, "metadata": {}}), "paper.ipynb")
    plain = run("check", audit, "--format", "plain", "--jobs", 0).stdout.splitlines()
    assert [line.split(": ")[:2] for line in plain] == [["book/paper.ipynb#1:1", "refuted"]]


def test_what_an_audit_leaves_open_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    audit = begun(tmp_path, SHORT.replace("Moreover", r"Moreover $E += 1$ and \[ 3 E = m v^2, \]"))
    said = run("lint", audit, "--jobs", 0)
    assert said.exit_code == 1
    assert said.stdout.splitlines() == [
        "paper.tex:6: line 6 has no role: E += 1",
        "paper.tex:6: 2.2 is refuted, and nothing is said of what is right",
        *(
            f"audit/audit.py:{n}: {x} has no unit; write '1' for a pure number"
            for n, x in ((9, "E"), (10, "m"), (11, "v"))
        ),
    ]
    code = (audit / "audit.py").read_text(encoding="utf-8")
    code = re.sub(r'letter\("(.)"\)', r'letter("\1", unit="1")', code)
    code = code.replace('# source.exclusion("line 6", reason=)', 'no = source.exclusion("line 6", reason="code")  #')
    right = 'errata={"": Erratum("2 E = m v^2", "number", Origin.PAPER, "it is twice")}'
    code = code.replace('source.claim("line 6 #2", ', f'source.claim("line 6 #2", {right}, ')
    head = "from symcheck.core.claims import Erratum\nfrom symcheck.core.verdicts import Origin\n"
    (audit / "audit.py").write_text(head + code, encoding="utf-8")
    said = run("lint", audit, "--jobs", 0)
    assert (said.exit_code, said.stdout) == (0, "")
    ruled = code.replace('"../paper.tex",', '"../paper.tex", rules=["m v -> p", "m w -> p"],')
    (audit / "audit.py").write_text(head + ruled, encoding="utf-8")
    assert run("lint", audit, "--jobs", 0).stdout == "audit/audit.py:1: nothing is rewritten by m w -> p\n"


def test_circles_are_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    audit = begun(tmp_path, SHORT)
    code = re.sub(r'letter\("(.)"\)', r'letter("\1", unit="1")', (audit / "audit.py").read_text(encoding="utf-8"))
    first, last = (
        'twice = source.claim("eq:twice", follows=[energy])',
        'line_7 = source.claim("line 7", follows=[energy])',
    )
    code = code.replace(first, last.replace("follows", 'given=["4 E = 2 m  v^2"], follows')).replace(
        "\n" + last, "\n" + first
    )
    (audit / "audit.py").write_text(
        code.replace(first, first.replace("[energy]", "[energy, line_7]")), encoding="utf-8"
    )
    said = run("lint", audit, "--jobs", 0)
    assert said.stdout.splitlines() == [
        "paper.tex:7: 2.1 is assumed for its own proof: 4 E = 2 m v^2",
        "paper.tex:5: 2 uses 2.1, which is claimed later",
    ]


REWRITTEN = [
    (r"\bm{a}_1^{T}\bm b = 3", r"X^{T} Y -> (X, Y)", r"( \bm {a} _ 1 , \bm b ) = 3"),
    (r"\leftexp{B}{\omega_1} + 2", r"\leftexp{B}{X} -> X", r"\omega _ 1 + 2"),
    (r"\frac{\delta\bm{\omega}}{2}", r"\delta\bm\omega -> \epsilon", r"\frac {\epsilon} {2}"),
    (r"c = (a + b)^T d", "X^TY -> (X, Y)", "c = ( ( a + b ) , d )"),
    (r"a^T b + b^T a", "X^T Y + Y^T X -> 2 (X, Y)", "2 ( a , b )"),
    # none of these is a match: what stands beside it would be torn from it
    (r"a^{T} b^2", "X^T Y -> (X, Y)", None),
    (r"a^{T} f(b)", "X^T Y -> (X, Y)", None),
    (r"f(a)^T b", "X^T Y -> (X, Y)", None),
    (r"\dot a'^T b", "X^T Y -> (X, Y)", None),
    (r"a^T c + b^T a", "X^T Y + Y^T X -> 2 (X, Y)", None),
    (r"a^S b", "X^T Y -> (X, Y)", None),
    (r"a^{T", "X^T Y -> (X, Y)", None),
]


@pytest.mark.parametrize(("latex", "rule", "right"), REWRITTEN)
def test_rules_rewrite_whole_operands_only(latex: str, rule: str, right: str | None) -> None:
    assert rewritten(latex, [Rule.of(rule)])[0] == (right or latex)


@pytest.mark.parametrize("rule", ["X", "-> a", "a -> b -> c", "a -> X"])
def test_what_is_no_rule_is_refused(rule: str) -> None:
    with pytest.raises(SymcheckError, match=re.escape(repr(rule))):
        Rule.of(rule)


ROTATED = r"""$$\fun{B}{E} = \frac{m v^2}{2}$$
$$2 \fun{B}{E} = m v^2$$
"""


def test_a_form_by_hand_is_never_told_as_printed(tmp_path: Path) -> None:
    audit = begun(tmp_path, SHORT.replace("2 E = m v^2", "2 E += m v^2"))
    code = (audit / "audit.py").read_text(encoding="utf-8")
    by_hand = 'twice = source.claim("eq:twice", stated="2 E = m v^2", follows=[energy])  # '
    (audit / "audit.py").write_text(code.replace("# source.exclusion", by_hand + "source.exclusion"), encoding="utf-8")
    items = json.loads(run("check", audit, "--jobs", 0, "--json").stdout)["items"]
    read = {item["id"]: (item["verdict"], item["reading"], item["printed"], item["read"]) for item in items}
    assert read["audit:2"] == ("proved", "stated by the auditor", "2 E += m v^2", "2 E = m v^2")
    assert read["audit:2.1"][:2] == ("proved", "as printed")


def test_a_misprint_passes_through_the_rules(tmp_path: Path) -> None:
    """The statement is made of what is printed: by rules it stays so, by hand it would not."""
    audit = begun(tmp_path, ROTATED)
    code = (audit / "audit.py").read_text(encoding="utf-8").partition("# source")[0]
    code = code.replace('"../paper.tex",', r'"../paper.tex", rules=[r"\fun{B}{X} -> X"],')
    code += 'e = source.definition("line 1")\nt = source.claim("line 2", follows=[e])\n'
    (audit / "audit.py").write_text(code + 'paper = source.paper(__name__, title="")\n', encoding="utf-8")
    assert verdicts(audit) == {"0.2": "proved"}
    (tmp_path / "paper.tex").write_text(ROTATED.replace("= m v^2", "= m v^3"), encoding="utf-8")
    [item] = [i for i in json.loads(run("check", audit, "--jobs", 0, "--json").stdout)["items"] if i["verdict"]]
    assert (item["verdict"], item["reading"]) == ("refuted", "rewritten")
    assert item["reason"].endswith(r"rewritten by \fun{B}{X} -> X")
    listed = run("errata", audit, "--jobs", 0).stdout
    assert "1 erratum, refuted" in listed
    assert re.search(r"^printed +2 \\fun\{B\}\{E\} = m v\^3$", listed, re.MULTILINE)


def test_some_constant_is_no_letter_and_an_implication_does_not_follow_from_itself(tmp_path: Path) -> None:
    text = (
        "The momentum is\n$$h = r^2 w = \\text{constant}$$\nand the area changes by\n"
        "$$s = \\frac{1}{2} r^2 w = \\frac{h}{2} = \\text{constant}$$\n"
        "so that\n$$m = 2 s \\implies s = \\frac{m}{2}$$\n"
        "With\n$$u = m + c \\implies c = u - m, \\qquad d = 3 v$$\nwe are done.\n"
    )
    audit = begun(tmp_path, text, "paper.md")
    assert "refuted" not in verdicts(audit).values()


def test_nothing_sound_is_refuted(tmp_path: Path) -> None:
    """Cases, equations to be solved and conditions printed elsewhere: what fails may still be meant."""
    audit = begun(tmp_path, SOUND)
    found = verdicts(audit)
    assert {number for number, verdict in found.items() if verdict == "proved"} == {"2", "7", "9"}
    assert "refuted" not in found.values()
    told = " ".join(run("show", f"{audit}:16b", "--jobs", 0).stdout.split())
    open_ = "it fails, but perhaps not where u = w (line 35); a condition may be printed elsewhere"
    assert open_ in told
    assert f"paper.tex:34: 16b: {open_}" in run("lint", audit, "--jobs", 0).stdout
    code = (audit / "audit.py").read_text(encoding="utf-8")
    head = "from symcheck.core.claims import Erratum\nfrom symcheck.core.verdicts import Origin\n"
    wrong = 'errata={"b": Erratum("u^2 + w^2 = G", "number", Origin.PAPER, "as it was defined")}'
    for said in ("given=[]", wrong):  # the auditor says that there is no condition, or that it is an error
        (audit / "audit.py").write_text(head + code.replace('("(16)"', f'("(16)", {said}'), encoding="utf-8")
        assert verdicts(audit) == {**found, "16b": "refuted"}


def test_what_is_wrong_with_the_source_itself_is_told(tmp_path: Path) -> None:
    (tmp_path / "paper.tex").write_text("\\input{gone} $$a = b$$ $$a = c", encoding="utf-8")
    said = run("new", tmp_path / "paper.tex", "--out", tmp_path / "audit", "--jobs", 0).stdout.splitlines()
    assert said[0] == f"{tmp_path}/paper.tex: line 1: $$ is never closed"
    assert said[1].startswith(f"{tmp_path}/paper.tex: left out: ")
    assert said[2] == f"{tmp_path}/audit/audit.py: written: 1 definition"


def test_letters_are_not_defined_in_a_circle(tmp_path: Path) -> None:
    audit = begun(tmp_path, "$$a = b + c$$\n$$b = a - c$$\n$$c = b - a$$\n", "paper.md")
    assert verdicts(audit) == {"0.2": "proved", "0.3": "refuted"}


def test_a_letter_of_another_section_is_another_one(tmp_path: Path) -> None:
    """E is an energy first, then an angle: what is said of the one is nothing of the other."""
    text = (
        "# A\n$$E = m v^2 - k/r$$\n# B\n$$r = a (1 - e \\cos E)$$\n$$\\frac{d}{dE} (E - e \\sin E) = \\frac{r}{a}$$\n"
    )
    audit = begun(tmp_path, text, "paper.md")
    assert 'line_5 = source.claim("line 5", follows=[line_4])' in (audit / "audit.py").read_text(encoding="utf-8")
    assert verdicts(audit) == {"0.3": "proved"}


def test_definitions_of_another_section_are_used_where_they_are_needed(tmp_path: Path) -> None:
    text = "# A\n$$p = u + w$$\n$$q = u - w$$\n# B\nThus\n$$p q = u^2 - w^2.$$\nand\n$$p + q = 3 u.$$\n"
    assert verdicts(begun(tmp_path, text, "paper.md")) == {"0.3": "proved", "0.4": "refuted"}


def test_what_is_read_after_an_edit_is_offered(tmp_path: Path) -> None:
    audit, paper = begun(tmp_path, NOTES, "paper.md"), tmp_path / "paper.md"
    paper.write_text(NOTES.replace("a += 3", "a = 3 v"), encoding="utf-8")
    done = run("new", "--update", audit, "--jobs", 0)
    assert f'{audit}/audit.py:21: it is read now; in its place: line_8 = source.definition("line 8")' in done.stdout
    assert "it is read now" not in run("new", "--update", audit, "--jobs", 0).stdout


def test_who_checks_a_document_is_told_how_to_begin(tmp_path: Path) -> None:
    (tmp_path / "paper.tex").write_text(SHORT, encoding="utf-8")
    failed = run("check", tmp_path / "paper.tex", "--jobs", 0)
    assert failed.exit_code == 2
    assert (
        failed.stderr
        == f"symcheck: {tmp_path}/paper.tex is no audit; `symcheck new paper.tex` begins one of a document\n"
    )
