"""What several test files need: the printed sources, and a toy world for the shell."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest
import stand_in
from click.testing import CliRunner, Result

ROOT = Path(__file__).resolve().parent.parent


def pytest_addoption(parser: pytest.Parser) -> None:
    """`--cases N`, for the quick tests: a fault is seldom one of a single case among many."""
    parser.addoption("--cases", type=int, default=0, help="of each test run no more than so many cases, evenly spread")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out cases beyond those wanted, of what is not slow."""
    wanted = config.getoption("--cases")
    by_test: dict[str, list[pytest.Item]] = {}
    for item in items:
        if not any(map(item.get_closest_marker, ("slow", "whole"))):
            by_test.setdefault(item.nodeid.partition("[")[0], []).append(item)
    spread = ((cases, -(-len(cases) // wanted)) for cases in by_test.values() if wanted and len(cases) > wanted)
    left_out = {id(case) for cases, step in spread for k, case in enumerate(cases) if k % step}
    config.hook.pytest_deselected(items=[item for item in items if id(item) in left_out])
    items[:] = [item for item in items if id(item) not in left_out]


@pytest.fixture(autouse=True)
def no_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whoever runs the tests may have a terminal of some width."""
    monkeypatch.delenv("COLUMNS", raising=False)


@pytest.fixture
def root() -> Path:
    """The root of the checkout."""
    return ROOT


@pytest.fixture(scope="session")
def sources() -> Path:
    """The folder with the papers' source texts; tests that need it are skipped where it is not at hand."""
    folder = os.environ.get("SYMCHECK_SOURCES")
    if not folder:
        pytest.skip("SYMCHECK_SOURCES is not set")
    return Path(folder)


@pytest.fixture
def toy(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """The toy paper instead of the real ones, with a cache and a folder generated/ of its own below the result."""
    import symcheck.kernels

    symcheck.kernels.load("mirer2009")  # the package of kernels is bound once, and not to the toy's folder
    stand_in.install(partial(monkeypatch.setattr, raising=False))  # the decider may not be imported yet
    monkeypatch.setenv("SYMCHECK_CACHE", str(tmp_path / "cache"))
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.setenv("STAND_IN_LOG", str(tmp_path / "decided"))
    monkeypatch.setattr(symcheck.kernels, "folder", lambda: tmp_path / "generated")
    return tmp_path


@pytest.fixture
def symcheck(toy: Path) -> Callable[..., Result]:
    """Run a command line on the toy paper, in this process."""
    from symcheck.cli import cli

    def run(*args: str) -> Result:
        name, *rest = args
        here = ["--jobs", "0"] if name in ("check", "show", "errata", "generate") else []
        return CliRunner().invoke(cli, [name, *here, *rest], prog_name="symcheck")

    return run


@pytest.fixture
def decided(toy: Path) -> Callable[[], list[str]]:
    """The ids decided since the last call, in order."""
    log = toy / "decided"

    def read() -> list[str]:
        ids = log.read_text(encoding="utf-8").split() if log.exists() else []
        log.unlink(missing_ok=True)
        return ids

    return read
