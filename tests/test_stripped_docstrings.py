"""No program reads docstrings: Python 3.13 strips their indentation, and -OO leaves none."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from warm_cache import warm_cache

from symcheck.checker.theorems import NAMES, stated


def run(root: Path, folder: Path, *arguments: str) -> str:
    env = {**os.environ, "PYTHONPATH": str(root), "SYMCHECK_CACHE": warm_cache(folder / "cache")}
    found = subprocess.run(
        [sys.executable, *arguments], cwd=folder, env=env, capture_output=True, text=True, timeout=120, check=False
    )
    assert found.returncode == 0, found.stderr
    return found.stdout


def test_what_theorems_say_is_the_same_without_docstrings(root: Path, tmp_path: Path) -> None:
    told = "from symcheck.checker.theorems import NAMES, stated; print(*map(stated, NAMES), sep='\\n')"
    assert run(root, tmp_path, "-OO", "-c", told).splitlines() == [*map(stated, NAMES)]


WHEELS = (
    "import symcheck.numeric.wheels as w; print(w.four_wheels(1.0, 0.5).tolist(), list(w.listed_vertices(3, 1, 1)))"
)


def test_wheels_are_the_same_without_docstrings(root: Path, tmp_path: Path) -> None:
    assert run(root, tmp_path, "-OO", "-c", WHEELS) == run(root, tmp_path, "-c", WHEELS)


@pytest.mark.slow
def test_figures_are_the_same_without_docstrings(root: Path, tmp_path: Path) -> None:
    drawn = []
    for level in ("-O", "-OO"):
        run(root, tmp_path, level, "-m", "symcheck", "plot", "liquid-frequencies", "--output", f"{level}.svg")
        drawn.append((tmp_path / f"{level}.svg").read_bytes())
    assert drawn[0] == drawn[1]
    listed = run(root, tmp_path, "-OO", "-m", "symcheck", "plot").splitlines()
    assert [line.split()[0] for line in listed] == [
        line.split()[0] for line in run(root, tmp_path, "-m", "symcheck", "plot").splitlines()
    ]


def test_the_report_is_the_same_without_docstrings(root: Path, tmp_path: Path) -> None:
    toy = str(root / "tests" / "stand_in.py")
    written = []
    for level in ("-O", "-OO"):
        run(root, tmp_path, level, toy, "report", "toy", "--output", f"{level}.html")
        written.append((tmp_path / f"{level}.html").read_bytes())
    assert written[0] == written[1]
