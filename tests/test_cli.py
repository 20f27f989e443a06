"""The commands, run in this process on a toy paper: what they print, what they return."""

from __future__ import annotations

import io
import json
from collections.abc import Callable
from pathlib import Path

import pytest
import stand_in
from click.testing import Result
from rich.cells import cell_len
from rich.console import Console
from rich.text import Text

from symcheck.cli import cli
from symcheck.ledger import Record, digest_of
from symcheck.views import terminal

Run = Callable[..., Result]

ROWS = {
    "1.1": ["proved", "as printed", "ideal"],
    "1.2a": ["a link [a] of a chain", "proved"],
    "1.2b": ["a link [b] of a chain", "proved"],
    "1.3": ["x = -x", "refuted", "misprint"],
    "1.4": ["order does not matter", "undecided"],
    "1.5": ["J = 1", "definition"],
    "1.12": ["filler", "proved"],
}


@pytest.fixture
def recorded(symcheck: Run) -> Run:
    """The same command line after the verdicts were recorded."""
    assert symcheck("generate").exit_code == 0
    return symcheck


def test_the_ledger_has_a_row_per_relation_and_a_summary(recorded: Run) -> None:
    result = recorded("check", "toy")
    assert result.exit_code == 0, result.stderr
    rows = {line.split()[0]: line for line in result.stdout.splitlines() if line.strip().startswith("1.")}
    assert list(rows) == list(ROWS)
    for number, words in ROWS.items():
        assert all(word in rows[number] for word in words)
    assert "6 relations: 4 proved, 1 refuted, 1 undecided; 1 definition\n" in result.stdout
    assert "All verdicts are those recorded." in result.stdout


def test_the_findings_come_last_and_then_the_next_commands(recorded: Run) -> None:
    lines = recorded("check", "toy").stdout.splitlines()
    end = lines[lines.index("Not decided: 1") :]
    assert end[:5] == [
        "Not decided: 1",
        " toy:1.4  out of reach",
        "Wrong as printed: 1",
        " toy:1.3  sign, the paper's own",
        "",
    ]
    assert end[-2] == "Next: `symcheck show toy:1.3`, `symcheck errata toy`, `symcheck report toy --open`"


@pytest.mark.parametrize("width", [40, 60, 80, 120, 200])
def test_no_line_of_a_ledger_is_wider_than_the_terminal(
    width: int, recorded: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", str(width))
    lines = recorded("check", "toy").stdout.splitlines()
    assert max(map(cell_len, lines)) <= width
    assert sum(line.strip().startswith("1.") for line in lines) == len(ROWS)  # a row is a line


def test_words_are_whole_on_a_narrow_terminal(recorded: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = recorded("show", "toy:1.1").stdout
    monkeypatch.setenv("COLUMNS", "60")
    wrapped = recorded("show", "toy:1.1").stdout
    assert max(map(len, whole.splitlines())) > 60
    assert wrapped.split() == whole.split()
    assert max(map(len, wrapped.splitlines())) <= 60


def test_without_a_selection_all_papers_are_checked(recorded: Run) -> None:
    lines = recorded("check").stdout.splitlines()
    assert "toy" in lines
    assert "other" in lines


def test_verdict_shows_only_its_rows_and_counts_all(recorded: Run) -> None:
    result = recorded("check", "toy", "--verdict", "refuted")
    assert "x = -x" in result.stdout
    assert "filler" not in result.stdout
    assert "4 proved, 1 refuted" in result.stdout


def test_json_is_one_object_with_the_records(recorded: Run) -> None:
    result = recorded("check", "toy", "--json")
    data = json.loads(result.stdout)
    assert list(data) == ["schema", "items"]
    assert data["schema"] == 1
    expected = [record for number in stand_in.NUMBERS for record in stand_in.decide(f"toy:{number}")]
    for item in data["items"]:
        (item["erratum"] or {}).pop("later", None)  # added by the audit, which sees all relations
    assert [Record.from_json(item) for item in data["items"]] == [Record.from_json(r.to_json()) for r in expected]


def test_an_erratum_tells_what_becomes_of_it_later(recorded: Run) -> None:
    items = json.loads(recorded("check", "toy", "--json").stdout)["items"]
    wrong = [item for item in items if item["erratum"]]
    assert wrong
    assert all(each["fate"] for item in wrong for each in item["erratum"]["later"])


def test_json_of_nothing_is_an_empty_list(recorded: Run) -> None:
    result = recorded("check", "toy:1.1", "--json", "--verdict", "undecided")
    assert json.loads(result.stdout) == {"schema": 1, "items": []}


def test_unrecorded_verdicts_are_not_accepted(symcheck: Run) -> None:
    result = symcheck("check", "toy")
    assert result.exit_code == 1
    assert "toy has no recorded verdicts" in result.stderr


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('"toy:1.1": ["proved"', '"toy:1.1": ["refuted"', "toy:1.1 newly passes: proved, recorded as refuted"),
        ('"toy:1.3": ["refuted"', '"toy:1.3": ["proved"', "toy:1.3 newly fails: refuted, recorded as proved"),
        ('"toy:1.4": ["undecided"', '"toy:1.4": ["proved"', "toy:1.4 newly fails: undecided (out of reach)"),
        ('"toy:1.12":', '"toy:1.13":', "toy:1.12 is new (proved)"),
    ],
)
def test_a_changed_verdict_is_named_and_exits_1(old: str, new: str, message: str, recorded: Run, toy: Path) -> None:
    file = toy / "generated" / "expected" / "toy.json"
    text = file.read_text(encoding="utf-8")
    assert old in text
    file.write_text(text.replace(old, new), encoding="utf-8")
    for more in ((), ("--json",)):
        result = recorded("check", "toy", *more)
        assert result.exit_code == 1
        assert message in result.stderr
    assert recorded("check", "toy:1.2").exit_code == 0


def test_a_damaged_expectation_is_reported_and_exits_2(recorded: Run, toy: Path) -> None:
    (toy / "generated" / "expected" / "toy.json").write_text("{")
    result = recorded("check", "toy")
    assert result.exit_code == 2
    assert "damaged" in result.stderr


def test_show_tells_everything_of_a_proved_relation(recorded: Run) -> None:
    text = recorded("show", "toy:1.1").stdout
    for words in (
        "toy:1.1  square of a",
        r"a_{11}^2 - b = \frac{1}{c + 1}",
        "line 10 of the source",
        "A is orthogonal (printed, needed)",
        "x is positive (not printed, added, not needed)",
        "without it the relation fails at x = 2/7, y = sqrt(3), where the sides are 1 against -1",
        "a_11^2 - b = 1/(c + 1)",
        "(2*a_11 - 1) · [orthogonal [1]]",
        f"sha256 {digest_of(stand_in.CERTIFICATE)}",
        "toy:1.3",
    ):
        assert words in text, words
    assert '"rule"' not in text


def test_show_can_print_the_whole_certificate(recorded: Run) -> None:
    text = recorded("show", "toy:1.1", "--certificate").stdout
    assert json.loads(text[text.index("\n{") :]) == stand_in.CERTIFICATE


def test_show_of_a_chain_shows_each_link_or_the_one_asked_for(recorded: Run) -> None:
    assert "\n\ntoy:1.2b" in recorded("show", "toy:1.2").stdout
    assert recorded("show", "toy:1.2").stdout.startswith("toy:1.2a")
    assert "toy:1.2a" not in recorded("show", "toy:1.2b").stdout


def test_errata_are_bundles(recorded: Run) -> None:
    result = recorded("errata", "toy")
    assert result.exit_code == 0
    for words in (
        "x = -x",
        "x = x",
        "sides are 1 against -1",
        "- x  →  x",
        "one single edit repairs it",
        "drop the minus: x = x",
        "the next line has the right sign",
        digest_of(stand_in.CORRECTED),
    ):
        assert words in result.stdout, words
    assert "toy:1.1" not in result.stdout
    assert "1 erratum, refuted\n" in result.stdout
    assert [item["id"] for item in json.loads(recorded("errata", "--json").stdout)["items"]] == ["toy:1.3"]


def test_papers_are_listed_with_counts(symcheck: Run) -> None:
    text = symcheck("papers").stdout
    for words in ("toy", "The toy paper", "toy.txt", "5 claims, 1 definition", "other"):
        assert words in text


def test_generate_writes_what_its_check_accepts(symcheck: Run, toy: Path) -> None:
    missing = symcheck("generate", "--check")
    assert missing.exit_code == 1
    assert "generated/certificates/toy.json: missing" in missing.stderr
    assert not (toy / "generated").exists()
    assert symcheck("generate").exit_code == 0
    assert symcheck("generate", "--check").exit_code == 0


def test_generate_check_names_a_file_that_was_edited(recorded: Run, toy: Path) -> None:
    file = toy / "generated" / "certificates" / "toy.json"
    file.write_bytes(file.read_bytes().replace(b"2*a_11", b"3*a_11"))
    result = recorded("generate", "--check")
    assert result.exit_code == 1
    assert "generated/certificates/toy.json: differs from line 2 on" in result.stderr
    assert b"3*a_11" in file.read_bytes()


BAD_INPUT = {
    "an unknown paper": (["check", "toi"], "did you mean toy?"),
    "an unknown number": (["check", "toy:1.13"], "did you mean toy:1."),
    "an unknown link": (["check", "toy:1.2z"], "toy:1.2a, toy:1.2b"),
    "one unknown among known": (["check", "toy", "toy:7"], "toy has no relation '7'"),
    "show of a paper": (["show", "toy"], "neither of the form PAPER:NUMBER"),
    "show of a number alone": (["show", "1.1"], "did you mean toy:1.1?"),
    "show of what is like nothing": (["show", "zzz"], "`symcheck check PAPER` lists the numbers of a paper"),
    "show of nothing": (["show"], "PAPER:NUMBER"),
    "errata of an unknown paper": (["errata", "toi"], "did you mean toy?"),
    "an unknown verdict": (["check", "--verdict", "true"], "'proved', 'refuted', 'undecided'"),
    "an unknown option": (["check", "--jason"], "--jason"),
    "an unknown global option": (["--jason"], "--jason"),
    "an unknown command": (["chek"], "chek"),
    "a negative number of jobs": (["check", "--jobs=-1"], "--jobs"),
    "no number of jobs": (["check", "--jobs=two"], "two"),
    "a time that is no number": (["check", "--timeout=nan"], "nan is not a finite number"),
    "endless time": (["decide", "x = x", "--timeout=inf"], "inf is not a finite number"),
    "no time at all": (["check", "--timeout=0"], "--timeout"),
    "too many arguments": (["papers", "toy"], "toy"),
}


@pytest.mark.parametrize(("arguments", "hint"), BAD_INPUT.values(), ids=BAD_INPUT.keys())
def test_bad_input_is_one_line_and_exit_code_2(arguments: list[str], hint: str, symcheck: Run) -> None:
    result = symcheck(*arguments)
    assert result.exit_code == 2
    assert hint in result.stderr
    assert result.stderr.startswith("symcheck: ")
    assert result.stderr.count("\n") == 1
    assert result.stdout == ""


@pytest.mark.parametrize("arguments", [["-h"], ["--help"], *([name, "-h"] for name in cli.commands)])
def test_every_command_has_help(arguments: list[str], symcheck: Run) -> None:
    result = symcheck(*[a for a in arguments if a])
    assert result.exit_code == 0
    assert "Usage: symcheck" in result.stdout


def test_what_a_command_is_for_is_said_in_whole_words_on_80_columns(
    symcheck: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    listed = symcheck("--help").stdout.partition("Commands:")[2].splitlines()
    assert len([line for line in listed if line]) == len(cli.commands)
    assert [line for line in listed if line.endswith("...")] == []


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("step:\n    one two three", ["step:", "    one two", "    three"]),
        ("one two three", ["one two", "three"]),
        ("", [""]),
        ("          too far", ["too far"]),
    ],
)
def test_what_is_indented_stays_so_on_the_next_line(text: str, lines: list[str]) -> None:
    out = Console(width=12, file=io.StringIO())
    assert [each.plain.rstrip() for each in terminal._on_screen(out, Text(text), 12)] == lines


def test_a_damaged_cache_is_said_in_one_line_and_rebuilt(recorded: Run, toy: Path) -> None:
    file = toy / "cache" / "records.sqlite"
    file.write_bytes(b"nonsense" * 100)
    result = recorded("check", "toy")
    assert result.exit_code == 0
    assert result.stderr.count("\n") == 1
    assert "damaged" in result.stderr
    assert recorded("check", "toy").stderr == ""


def test_no_cache_neither_reads_nor_writes(symcheck: Run, toy: Path, decided: Callable[[], list[str]]) -> None:
    for _ in range(2):
        symcheck("check", "toy:1.1", "--no-cache")
        assert decided() == ["toy:1.1"]
    assert not (toy / "cache").exists()


def test_changed_sources_are_decided_again_and_said(
    recorded: Run, decided: Callable[[], list[str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    decided()
    monkeypatch.setenv("STAND_IN_SOURCES", "changed")
    assert "1 result in the cache came from other sources" in recorded("check", "toy:1.1").stderr
    assert decided() == ["toy:1.1"]
