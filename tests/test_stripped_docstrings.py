"""No program reads docstrings: Python 3.13 strips their indentation, and -OO leaves none."""

from __future__ import annotations

import inspect
import os
import subprocess
import sys
from pathlib import Path

import pytest

from symcheck import kernels
from symcheck.audit.kernels import declared
from symcheck.checker.theorems import NAMES, stated
from symcheck.numeric.chunked.kernels import declaration
from symcheck.numeric.wheels import listed_vertices
from symcheck.papers import load

EVERY = [(paper, name) for paper in load() for name in kernels.load(paper).__all__]


def run(root: Path, folder: Path, *arguments: str) -> str:
    env = {**os.environ, "PYTHONPATH": str(root), "SYMCHECK_CACHE": str(folder / "cache")}
    found = subprocess.run(
        [sys.executable, *arguments], cwd=folder, env=env, capture_output=True, text=True, timeout=120, check=False
    )
    assert found.returncode == 0, found.stderr
    return found.stdout


@pytest.mark.parametrize(("paper", "name"), EVERY)
def test_the_module_of_a_kernel_declares_what_the_kernel_does(
    paper: str, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    function = getattr(kernels.load(paper), name)
    monkeypatch.setattr(function, "__doc__", None)
    found, kernel = declaration(function), declared(paper)[name]
    for attributes, listed in ((found.arguments, kernel.arguments), (found.results, kernel.outputs)):
        assert list(attributes) == [each.name for each in listed]
        assert [each["long_name"] for each in attributes.values()] == [each.meaning for each in listed]
        assert [each["units"] for each in attributes.values()] == [
            each.unit.removeprefix("units of ") for each in listed
        ]


def test_every_kernel_is_declared_once() -> None:
    for paper in load():
        module = kernels.load(paper)
        assert sorted(module.DECLARED) == sorted(module.__all__)


@pytest.mark.parametrize("doc", [None, "stripped"])
def test_the_listed_vertices_keep_their_names(doc: str | None, monkeypatch: pytest.MonkeyPatch) -> None:
    function = kernels.load("ignatov2005").vertices_of_four_wheels
    expected = listed_vertices(4, 1.0, 0.5)
    assert list(expected)[:2] == ["V_1", "V_2"]
    monkeypatch.setattr(function, "__doc__", doc and inspect.cleandoc(function.__doc__))
    assert {name: place.tolist() for name, place in listed_vertices(4, 1.0, 0.5).items()} == {
        name: place.tolist() for name, place in expected.items()
    }


def test_what_theorems_say_is_the_same_without_docstrings(root: Path, tmp_path: Path) -> None:
    told = "from symcheck.checker.theorems import NAMES, stated; print(*map(stated, NAMES), sep='\\n')"
    assert run(root, tmp_path, "-OO", "-c", told).splitlines() == [*map(stated, NAMES)]


WHEELS = (
    "import symcheck.numeric.wheels as w; print(w.four_wheels(1.0, 0.5).tolist(), list(w.listed_vertices(3, 1, 1)))"
)


def test_wheels_are_the_same_without_docstrings(root: Path, tmp_path: Path) -> None:
    assert run(root, tmp_path, "-OO", "-c", WHEELS) == run(root, tmp_path, "-c", WHEELS)


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
