"""What the cells of the guide call: a checkout with the guide's example as its only paper, and commands run in it."""

from __future__ import annotations

import ast
import os
import re
import shlex
import subprocess
import sys
from itertools import groupby, pairwise
from pathlib import Path
from shutil import copytree, ignore_patterns, rmtree
from tempfile import mkdtemp
from weakref import finalize

import symcheck
from symcheck import kernels, papers
from symcheck.core.verdicts import SymcheckError
from symcheck.views.notebook.committed import folder
from symcheck.views.notebook.output import Output, Verbatim

EXAMPLE = "pendulum"
WIDTH = "110"  # columns of what commands print
COLOURED = ("FORCE_COLOR", "CLICOLOR_FORCE", "TTY_COMPATIBLE")  # which a Jupyter kernel sets
SECONDS = 120  # that a command may take
_TIMES = re.compile(r"[ ,]+(?:\d+\.\d+ s|time)$", re.MULTILINE)  # differ from run to run, at the end of a line
_SPACES = re.compile(r" +$", re.MULTILINE)  # that fill the lines of tables


def excerpt(file: str, *names: str) -> Output:
    """A file of the example, or the declarations in it that are bound to these names."""
    text = _example(file).read_text(encoding="utf-8")
    return Output((Verbatim(file, _bound(text, file, names) if names else text.strip()),))


def _example(file: str = "") -> Path:
    return folder() / "guide" / EXAMPLE / file


def _bound(text: str, file: str, names: tuple[str, ...]) -> str:
    found = {
        target.id: ast.get_source_segment(text, statement) or ""
        for statement in ast.parse(text).body
        if isinstance(statement, ast.Assign)
        for target in statement.targets
        if isinstance(target, ast.Name)
    }
    if missing := [name for name in names if name not in found]:
        raise SymcheckError(f"{file} declares no {missing[0]}; it declares {', '.join(found)}")
    return "\n\n".join(found[name] for name in names)


class _Place:
    """A temporary folder in which commands run; `_package` is where they find the package."""

    def __init__(self) -> None:
        self._root = Path(mkdtemp(prefix="symcheck-guide-")).resolve()
        finalize(self, rmtree, self._root, ignore_errors=True)
        self._package = self._root

    def run(self, command: str) -> Output:
        """What a command of symcheck or Python prints there; times are left out, as they differ from run to run."""
        program, *arguments = shlex.split(command)
        started = [sys.executable, *(["-m", "symcheck"] if program == "symcheck" else []), *arguments]
        places = {"SYMCHECK_CACHE": "cache", "XDG_CONFIG_HOME": "config"}
        environment = {name: value for name, value in os.environ.items() if name not in COLOURED}
        environment |= {name: str(self._root / place) for name, place in places.items()}
        environment |= {"PYTHONPATH": str(self._package), "COLUMNS": WIDTH, "PYTHONDONTWRITEBYTECODE": "1"}
        done = subprocess.run(
            started, cwd=self._root, env=environment, capture_output=True, text=True, check=False, timeout=SECONDS
        )
        said = f"{done.stdout}\n{done.stderr}".replace(f"{self._root}{os.sep}", "")
        return Output((Verbatim(f"$ {command}", _SPACES.sub("", _TIMES.sub("", said)).strip()),))


class Checkout(_Place):
    """A copy of the package in a temporary folder. Its only paper is the example; nothing is generated there yet."""

    def __init__(self) -> None:
        super().__init__()
        others = ignore_patterns("__pycache__", "generated", *papers.load())
        copytree(Path(symcheck.__file__).parent, self._root / "symcheck", ignore=others)
        copytree(_example(), self._root / "symcheck" / "papers" / EXAMPLE, ignore=ignore_patterns("__pycache__"))
        (self._root / "generated").mkdir()
        (self._root / "generated" / "__init__.py").write_bytes((kernels.folder() / "__init__.py").read_bytes())
        (self._root / "symcheck" / "generated").symlink_to(Path("..", "generated"))

    def add_theorem(self, file: str) -> Output:
        """Put the line of a file of the example into the checker's table of theorems."""
        line, table = _example(file).read_text(encoding="utf-8"), self._root / "symcheck" / "checker" / "theorems.py"
        before, start, after = table.read_text(encoding="utf-8").partition('STATEMENTS = f"""\n')
        if not start:
            raise SymcheckError(f"{table.name} has no table of statements; mend Checkout.add_theorem")
        table.write_text(f"{before}{start}{line}{after}", encoding="utf-8")
        return Output((Verbatim("one line of STATEMENTS in symcheck/checker/theorems.py", line.strip()),))


class Desk(_Place):
    """A temporary folder with a document of the guide, and nothing else."""

    def __init__(self, example: str) -> None:
        super().__init__()
        self._package = Path(symcheck.__file__).parents[1]
        copytree(folder() / "guide" / example, self._root, dirs_exist_ok=True)

    def show(self, file: str, first: str = "", last: str = "") -> Output:
        """A file, or its lines from the first that has one text to the last that has another."""
        lines = self._text(file).splitlines()
        start, end = (next(iter(_having(lines, first)), -1), next(iter(_having(lines, last)[::-1]), -1))
        if min(start, end) < 0:
            raise SymcheckError(f"{file} has no lines from {first!r} to {last!r}")
        return Output((Verbatim(file, "\n".join(lines[start : end + 1])),))

    def edit(self, name: str) -> Output:
        """Edit a file as `edits/NAME.diff` says: lines with a minus become those with a plus behind them."""
        file, *changes = self._text(f"edits/{name}.diff").splitlines()
        text = f"\n{self._text(file)}"
        for removed, added in pairwise([[*part] for _, part in groupby(changes, lambda line: line[:1])]):
            if removed[0][0] == "-":
                before, after = ("".join(f"\n{line[1:]}" for line in part) for part in (removed, added))
                if text.count(f"{before}\n") != 1:
                    raise SymcheckError(f"{file} does not have the lines of edits/{name}.diff once")
                text = text.replace(f"{before}\n", f"{after}\n")
        (self._root / file).write_text(text[1:], encoding="utf-8")
        return Output((Verbatim(f"{file}, edited", "\n".join(changes)),))

    def _text(self, file: str) -> str:
        return (self._root / file).read_text(encoding="utf-8")


def _having(lines: list[str], text: str) -> list[int]:
    return [k for k, line in enumerate(lines) if text in line]
