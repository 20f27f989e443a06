"""The letter to the authors: every erratum that is theirs, in three forms, and nothing of ours in it."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Callable
from functools import cache
from html.parser import HTMLParser
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from declarations import errata
from msgspec.structs import replace
from stand_in import correction

from symcheck import papers
from symcheck.audit.decide import decide
from symcheck.cli import cli
from symcheck.core.ids import Id
from symcheck.core.verdicts import Origin, Reading, Role, SymcheckError, Verdict
from symcheck.ledger import Record
from symcheck.views.latex import is_formula
from symcheck.views.letter import Form, Letter, letter, plain, written

KEYS = ("mirer2009", "poloskov2004", "esenkov2006")
INTERNAL = re.compile(
    r"symcheck|certificate|hypothes|ledger|refuted|proved|\bOCR\b|(?<![\d.,])\d+\.\d+\.\d+(?![\d.])|\b[BCNS]\.\d",
    re.IGNORECASE,
)


@cache
def wrong(key: str) -> tuple[Record, ...]:
    """The errata of a paper."""
    items = [item for _, _, item in papers.load()[key].items() if errata(item) or item.source.damage]
    return tuple(record for item in items for record in decide(str(Id(key, item.number))) if record.corrected)


@cache
def about(key: str) -> Letter:
    return letter(wrong(key))


def row(number: str, kind: str) -> Record:
    """An erratum of a list row."""
    return Record(
        id=f"ignatov2005:{number}",
        paper="ignatov2005",
        section="2.1",
        line=87,
        role=Role.CLAIM,
        printed="V_3 : [1, -1]",
        corrected="V_3 : [1, 1]",
        verdict=Verdict.REFUTED,
        reading=Reading.MISPRINT,
        kind=kind,
        origin=Origin.PAPER,
        reason="As row 12 (2.1V.12) has it. It is so.",
        erratum=correction(row=True),
    )


ROWS = (row("2.1V.3a", "sign"), row("T6.1", "wrong number"), row("2.1V.4", "lost prime"), row("2.1V", "sign"))


@pytest.mark.parametrize("key", KEYS)
def test_every_erratum_that_is_the_authors_is_in_the_letter_once(key: str) -> None:
    theirs = {(record.line, record.corrected) for record in wrong(key) if record.origin is not Origin.OCR}
    assert len(about(key).corrections) == len(theirs) > 0
    lines = [int(found[1]) for each in about(key).corrections if (found := re.search(r"line (\d+)", each.where))]
    assert lines == sorted(line for line, _ in theirs)


@pytest.mark.parametrize("form", Form)
@pytest.mark.parametrize("key", KEYS)
def test_nothing_of_ours_is_in_it(key: str, form: Form) -> None:
    text = written(about(key), form)
    assert INTERNAL.findall(re.sub(r"<style>.*?</style>|<math.*?</math>", "", text, flags=re.DOTALL)) == []


@pytest.mark.parametrize("key", KEYS)
def test_every_correction_has_one_sentence_of_reason(key: str) -> None:
    for each in about(key).corrections:
        assert each.printed
        assert each.correct
        assert each.reason.rstrip().endswith((".", ".)")), each.reason
    told = [each.erratum for each in wrong(key) if each.erratum and each.verdict]
    assert told
    assert all(each.summary for each in told)


@pytest.mark.parametrize("key", KEYS)
def test_formulas_stand_between_dollar_signs(key: str) -> None:
    for each in about(key).corrections:
        for text in (each.printed, each.correct, each.reason, each.evidence):
            assert text.count("$") % 2 == 0, text
            assert all(is_formula(formula) for formula in re.findall(r"\$([^$]+)\$", text)), text


def test_rows_and_slips_are_two_tables_and_a_list_as_a_whole_is_in_none() -> None:
    found = letter(ROWS)
    assert [title for title, _ in found.tables] == ["Rows of lists and cells of tables", "Slips that mislead nobody"]
    assert [each.where for each in found.rows] == ["section 2.1, list of vertices, row 3, line 87", "table 6, line 87"]
    assert [each.reason for each in found.rows] == ["Sign. As row 12 has it.", "Wrong number. As row 12 has it."]
    assert len(found.slips) == 1
    assert written(found, Form.MARKDOWN).count("\n| --- |") == 2
    assert written(found, Form.LATEX).count(r"\begin{longtable}") == 2
    assert written(found, Form.HTML).count("<table>") == 2


def test_a_letter_is_about_one_paper() -> None:
    with pytest.raises(SymcheckError, match="a letter is about one paper, not about mirer2009 and ignatov2005"):
        letter([replace(ROWS[0], id="mirer2009:2.1", paper="mirer2009"), ROWS[0]])


def test_damage_by_the_digitisation_does_not_concern_the_authors() -> None:
    with pytest.raises(SymcheckError, match="no erratum concerns the authors"):
        letter([replace(ROWS[0], origin=Origin.OCR)])


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("So it is (B.7).", "So it is."),
        ("See 2.13.2 and (2.10).", "See line 342 and (2.10)."),
        ("One (2.13.2, C.11) two.", "One two."),
        ("The OCR lost 0.25 of it.", "The digitisation lost 0.25 of it."),
    ],
)
def test_numbers_of_declarations_become_lines(text: str, told: str) -> None:
    assert plain(text, {"2.13.2": 342, "C.11": 26, "B.7": 1}) == told


def test_markdown_takes_no_letter_for_its_own() -> None:
    text = written(about("mirer2009"), Form.MARKDOWN)
    words = re.sub(r"\$\$?[^$]+\$\$?", "", text)
    assert re.findall(r"(?<!\\)_", words) == []
    assert text.count("<details>") == text.count("</details>") > 0


class Tags(HTMLParser):
    """Whether every tag is closed."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.seen: set[str] = set()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.seen.add(tag)
        assert not any(name in ("src", "href") for name, _ in attrs)
        if tag != "meta":
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@pytest.mark.parametrize("key", KEYS)
def test_the_page_is_whole_and_needs_nothing_else(key: str) -> None:
    tags = Tags()
    tags.feed(written(about(key), Form.HTML))
    assert tags.open == []
    assert {"math", "ol", "li", "details"} <= tags.seen


@pytest.mark.parametrize("key", KEYS)
def test_latex_is_balanced(key: str) -> None:
    text = written(about(key), Form.LATEX)
    body = re.sub(r"\\[\\{}]", "", text)
    assert body.count("{") == body.count("}")
    for name in set(re.findall(r"\\begin\{(\w+)\}", text)):
        assert text.count(rf"\begin{{{name}}}") == text.count(rf"\end{{{name}}}")
    assert text.count(r"\item") == len(about(key).corrections)


@pytest.mark.skipif(not shutil.which("pdflatex"), reason="pdflatex is not installed")
@pytest.mark.parametrize("key", KEYS)
def test_latex_compiles(key: str, tmp_path: Path) -> None:
    (tmp_path / "letter.tex").write_text(written(about(key), Form.LATEX), encoding="utf-8")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "letter.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False, errors="replace")
    assert done.returncode == 0, done.stdout[-2000:]
    assert (tmp_path / "letter.pdf").stat().st_size > 1000


@pytest.fixture
def asked() -> Callable[..., Result]:
    """`symcheck errata` of one erratum, in this process."""
    return lambda *args: CliRunner().invoke(cli, ["errata", "mirer2009:2.1.1", "--jobs", "0", *args])


@pytest.mark.parametrize(
    ("name", "begins"), [("a.md", "# Corr"), ("a.tex", r"\documentclass"), ("a.HTML", "<!doctype")]
)
def test_the_name_of_the_file_says_the_form(
    asked: Callable[..., Result], tmp_path: Path, name: str, begins: str
) -> None:
    done = asked("--format", "letter", "--output", str(tmp_path / name))
    assert done.exit_code == 0, done.output
    assert (tmp_path / name).read_text(encoding="utf-8").startswith(begins)


def test_without_a_file_the_letter_is_printed(asked: Callable[..., Result]) -> None:
    assert asked("--format", "letter").stdout.startswith("# Corrections to S. A. Mirer")
    assert asked("--format", "letter", "--as", "latex").stdout.startswith(r"\documentclass")


@pytest.mark.parametrize(
    ("args", "said"),
    [
        (("--format", "letter", "--json"), "leave one of them out"),
        (("--as", "html"), "add --format letter"),
        (("--format", "letter", "--output", "letter.pdf"), "add --as markdown, latex or html"),
    ],
)
def test_what_does_not_fit_together_is_said(asked: Callable[..., Result], args: tuple[str, ...], said: str) -> None:
    done = asked(*args)
    assert done.exit_code == 2
    assert said in done.output
