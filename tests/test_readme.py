"""The README is short, and what it shows is what comes out."""

from __future__ import annotations

import re
import struct
from pathlib import Path

import pytest
from click.testing import CliRunner
from page_picture import CHROMIUM, PICTURE, SIZE, take
from rich.console import Console

from symcheck import errata
from symcheck.cli import cli
from symcheck.views import terminal

README = Path(__file__).resolve().parent.parent / "README.md"
LONGEST = 10_000  # bytes
LARGEST = 150_000  # bytes of the picture


@pytest.fixture(autouse=True)
def cache_of_its_own(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """What the README shows is decided in this run."""
    monkeypatch.setenv("SYMCHECK_CACHE", str(tmp_path / "cache"))
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))


def example(word: str) -> str:
    """The one block of Python in the README that has this word."""
    blocks = re.findall(r"^```python\n(.*?)^```", README.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
    (found,) = (block for block in blocks if word in block)
    return str(found)


def test_the_engineers_example_runs_as_it_is_printed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    exec(example("principal_inertia"), {})
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 4
    assert not re.search("nan|inf", " ".join(lines))
    loss = [float(x) for x in re.findall(r"[\d.]+", lines[1])]
    assert {n for n, rate in enumerate(loss, 1) if rate == min(loss)} == {1, 4}
    assert (tmp_path / "envelope.png").read_bytes().startswith(b"\x89PNG")


def test_the_readers_own_formulas_are_decided_as_it_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    exec(example("import decide"), {})
    told = "proved the length of \\mathbf{u} (the same letter stands in bold type)"
    assert capsys.readouterr().out.splitlines() == [told, "refuted {'n': '3'}"]


def test_the_erratum_is_what_is_printed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SYMCHECK_CACHE", str(tmp_path / "cache"))
    printed = README.read_text(encoding="utf-8")
    (shown,) = re.findall(r"^```text\n(poloskov2004:.*?)^```", printed, flags=re.DOTALL | re.MULTILINE)
    with (tmp_path / "out").open("w") as file:
        terminal.errata(Console(file=file, width=400), errata(["poloskov2004:4.0.27"]))
    assert " ".join(shown.split()) in " ".join((tmp_path / "out").read_text().split())


def test_the_ledger_is_what_the_command_prints(monkeypatch: pytest.MonkeyPatch) -> None:
    printed = README.read_text(encoding="utf-8")
    ((command, shown),) = re.findall(r"^```text\n\$ symcheck (.*?)\n(.*?)^```", printed, flags=re.DOTALL | re.MULTILINE)
    monkeypatch.setenv("COLUMNS", "110")
    done = CliRunner().invoke(cli, [*command.split(), "--jobs", "0"], prog_name="symcheck")
    assert done.exit_code == 0, done.output
    assert without_times(done.stdout) == without_times(shown)


def without_times(text: str) -> list[str]:
    """The lines without the times, and with no account of the columns' widths, which a long time changes."""
    lines = [re.sub(r"\d+\.\d+ s$", "", line) for line in text.strip().splitlines()]
    return [re.sub(r" {2,}", "  ", re.sub(r"([─━═-])\1+", r"\1", line)).rstrip() for line in lines]


def test_it_is_short_and_links_to_what_is_there() -> None:
    text = README.read_text(encoding="utf-8")
    assert len(text.encode()) <= LONGEST
    assert all((README.parent / link).is_file() for link in re.findall(r"\]\(([^)]+)\)", text))


def size_of(picture: Path) -> tuple[int, ...]:
    """The width and height of a PNG file."""
    data = picture.read_bytes()
    assert data.startswith(b"\x89PNG")
    return struct.unpack(">II", data[16:24])


def test_the_picture_of_the_page_is_small() -> None:
    assert size_of(PICTURE) == (SIZE["width"], SIZE["height"])
    assert PICTURE.stat().st_size < LARGEST


@pytest.mark.slow
@pytest.mark.skipif(not CHROMIUM, reason="no Chromium is found; `make browser` installs it")
def test_the_picture_of_the_page_can_be_taken_again(tmp_path: Path) -> None:
    seen = take(tmp_path / "page.png")
    assert {"As printed", "As read", "Correction"} <= {*seen}  # as the words below the picture say
    assert size_of(tmp_path / "page.png") == size_of(PICTURE)
