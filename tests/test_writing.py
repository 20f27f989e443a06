"""A file that was asked for is written where it really is: through links, into devices and pipes, else whole."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from symcheck.cli import cli
from symcheck.core.files import put

Command = Callable[..., Result]
FULL = Path("/dev/full")
full = pytest.mark.skipif(not FULL.is_char_device(), reason="no device that is always full")
FIGURE = "liquid-frequencies"
COMMANDS = {
    ".html": ("report", "toy", "--output"),
    ".json": ("export", "toy", "--format", "json", "--output"),
    ".svg": ("plot", FIGURE, "--output"),
}
every_command = pytest.mark.parametrize("ending", COMMANDS)


def read_from(fifo: Path) -> tuple[threading.Thread, list[bytes]]:
    found: list[bytes] = []
    reader = threading.Thread(target=lambda: found.append(fifo.read_bytes()), daemon=True)
    reader.start()
    return reader, found


@every_command
def test_a_link_stays_and_what_it_points_to_is_written(ending: str, symcheck: Command, tmp_path: Path) -> None:
    plain, behind, link = (tmp_path / f"{name}{ending}" for name in ("plain", "behind", "link"))
    link.symlink_to(behind.name)
    assert symcheck(*COMMANDS[ending], str(plain)).exit_code == 0
    for _ in ("there is nothing yet", "it is replaced"):
        assert symcheck(*COMMANDS[ending], str(link)).exit_code == 0
        assert link.is_symlink()
        assert behind.read_bytes() == plain.read_bytes()
        behind.write_bytes(b"old")


@every_command
def test_a_pipe_gets_the_bytes_and_stays_a_pipe(ending: str, symcheck: Command, tmp_path: Path) -> None:
    plain, fifo = tmp_path / f"plain{ending}", tmp_path / f"fifo{ending}"
    os.mkfifo(fifo)
    assert symcheck(*COMMANDS[ending], str(plain)).exit_code == 0
    reader, found = read_from(fifo)
    assert symcheck(*COMMANDS[ending], str(fifo)).exit_code == 0
    reader.join(30)
    assert found == [plain.read_bytes()]
    assert fifo.is_fifo()


@full
@every_command
def test_a_full_device_is_one_line_and_stays_a_device(ending: str, symcheck: Command, tmp_path: Path) -> None:
    link = tmp_path / f"full{ending}"
    link.symlink_to(FULL)
    result = symcheck(*COMMANDS[ending], str(link))
    assert result.exit_code == 2
    assert result.stderr.splitlines() == [
        f"symcheck: {link} cannot be written (No space left on device); choose another with --output"
    ]
    assert FULL.is_char_device()
    assert link.is_symlink()
    assert not list(tmp_path.glob(".*"))


STAND_IN = [sys.executable, str(Path(__file__).with_name("stand_in.py"))]
PRINTING = ("check toy", "check toy --json", "show toy:1.1", "errata toy", "papers", "--help")


def at(output: str, *arguments: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """A command of the toy paper with its standard output redirected by a shell."""
    env = {**os.environ, "SYMCHECK_CACHE": str(folder / "cache"), "STAND_IN_LOG": str(folder / "decided")}
    command = ["sh", "-c", f'exec "$@" {output}', "sh", *STAND_IN, *arguments]
    return subprocess.run(command, env=env, stderr=subprocess.PIPE, text=True, timeout=60, check=False)


@full
@pytest.mark.parametrize("arguments", PRINTING)
def test_a_full_standard_output_is_one_line(arguments: str, tmp_path: Path) -> None:
    found = at(">/dev/full", *arguments.split(), *["--jobs", "0"] * ("toy" in arguments), folder=tmp_path)
    said = "the standard output cannot be written (No space left on device); what was printed is not whole"
    assert (found.stderr.splitlines()[-1], found.stderr.count("Traceback")) == (f"symcheck: {said}", 0)
    assert found.returncode == 2


def test_what_nobody_wants_to_read_is_not_printed(tmp_path: Path) -> None:
    assert (found := at(">&-", "papers", folder=tmp_path)).returncode == 0, found.stderr


@full
def test_a_batch_goes_on_with_a_file_only(tmp_path: Path) -> None:
    batch = tmp_path / "batch.jsonl"
    batch.write_text('{"id": 1, "relation": "x = x"}\n', encoding="utf-8")
    for _ in range(2):
        arguments = ["decide", "--batch", str(batch), "--output", os.devnull, "--resume", "--jobs", "1"]
        result = CliRunner().invoke(cli, arguments, prog_name="symcheck")
        assert (result.exit_code, result.stderr) == (0, "symcheck: 1 record: 1 proved\n")


def test_a_circle_of_links_is_one_line(symcheck: Command, tmp_path: Path) -> None:
    link = tmp_path / "circle.html"
    link.symlink_to(link.name)
    result = symcheck(*COMMANDS[".html"], str(link))
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    assert link.is_symlink()


def test_a_file_is_replaced_and_not_written_over(tmp_path: Path) -> None:
    file, other = tmp_path / "file", tmp_path / "other"
    file.write_bytes(b"old")
    other.hardlink_to(file)
    with file.open("rb") as before:
        put(file, b"new")
        assert before.read() == b"old"
    assert file.read_bytes() == b"new"
    assert other.read_bytes() == b"old"
    assert sorted(os.listdir(tmp_path)) == ["file", "other"]


def test_who_may_read_a_file_stays_as_it_was(tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.write_bytes(b"old")
    file.chmod(0o640)
    put(file, b"new")
    assert file.stat().st_mode & 0o777 == 0o640


def test_a_new_file_may_be_read_as_any_other(tmp_path: Path) -> None:
    put(tmp_path / "folder" / "file", b"new")
    (tmp_path / "plain").write_bytes(b"")
    assert (tmp_path / "folder" / "file").stat().st_mode == (tmp_path / "plain").stat().st_mode


def test_a_name_may_be_as_long_as_the_file_system_allows(tmp_path: Path) -> None:
    put(tmp_path / ("n" * 255), b"new")
    assert (tmp_path / ("n" * 255)).read_bytes() == b"new"


def test_what_cannot_be_replaced_leaves_nothing_behind(tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    with pytest.raises(OSError, match="directory"):
        put(tmp_path / "folder", b"new")
    assert os.listdir(tmp_path) == ["folder"]
    assert os.listdir(tmp_path / "folder") == []


@pytest.mark.parametrize("mode", ["wb", "ab"])
def test_the_standard_output_takes_its_turn_in_a_file(mode: str, tmp_path: Path) -> None:
    code = (
        "from pathlib import Path\nfrom symcheck.core.files import put\n"
        "print('before')\nput(Path('/dev/stdout'), b'written\\n')\nprint('after')"
    )
    file = tmp_path / "out"
    file.write_bytes(b"old\n")
    with file.open(mode) as out:
        subprocess.run([sys.executable, "-c", code], stdout=out, check=True)
    assert file.read_text() == "old\n" * (mode == "ab") + "before\nwritten\nafter\n"


def test_a_sweep_follows_a_link_and_refuses_a_pipe(tmp_path: Path) -> None:
    pytest.importorskip("xarray")

    def symcheck(*arguments: str) -> Result:
        return CliRunner().invoke(cli, arguments, prog_name="symcheck")

    spec, behind, link, fifo = (tmp_path / name for name in ("s.toml", "behind.nc", "link.nc", "fifo.nc"))
    spec.write_text('function = "ignatov2005.volume_of_four_wheels"\n[parameters]\na = [0.5, 0.9]\nb = 1.0\n')
    link.symlink_to(behind.name)
    os.mkfifo(fifo)
    assert symcheck("sweep", str(spec), "--out", str(link)).exit_code == 0
    assert link.is_symlink()
    assert behind.read_bytes()[:4] == b"\x89HDF"
    result = symcheck("sweep", str(spec), "--out", str(fifo))
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    assert "pipe" in result.stderr
    assert fifo.is_fifo()
