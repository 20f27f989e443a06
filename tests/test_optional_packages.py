"""With no more than `make audit` installs, what needs more says in one line what to install."""

from __future__ import annotations

import os
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from symcheck.core.extras import installing

# As if these were not installed: neither imported nor found.
HIDING = """
import sys

hidden = {hidden!r}

class Without:
    def __init__(self, finder):
        self.finder = finder

    def __getattr__(self, name):
        return getattr(self.finder, name)

    def find_spec(self, name, path=None, target=None):
        return None if name.partition(".")[0] in hidden else self.finder.find_spec(name, path, target)

sys.meta_path[:] = [Without(each) for each in sys.meta_path]
sys.argv = ["symcheck", *sys.argv[1:]]
"""
SPEC = """
function = "random_rotation.simulate"
seed = 1
realizations = 2
"""


def optional(root: Path) -> set[str]:
    """The modules of the extras that users have, and what these bring with them."""
    extras = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    required = {line.partition(">")[0] for name in extras if name != "dev" for line in extras[name]}
    modules = {name.replace("-", "_") for name in required}
    return modules | {"mpl_toolkits", "llvmlite", "IPython", "ipykernel", "jupyter_client", "traitlets"}


def run(root: Path, folder: Path, *arguments: str, main: str = "") -> subprocess.CompletedProcess[str]:
    main = main or "from symcheck.cli import main; main()"
    return subprocess.run(
        [sys.executable, "-c", HIDING.format(hidden=optional(root)) + main, *arguments],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(root), "SYMCHECK_CACHE": str(folder / "cache")},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


PIP = f"{sys.executable} -m pip install"
NEEDS = {
    ("plot", "liquid-frequencies"): f"matplotlib is not installed; run `{PIP} 'symcheck[plots]'`",
    ("sweep", "spec.toml", "--out", "out.nc"): "a sweep needs xarray, zarr, filelock, dask, h5netcdf, h5py; "
    f"run `{PIP} 'symcheck[sweep]'`",
    ("notebooks", "--only", "1"): f"jupytext is not installed; run `{PIP} 'symcheck[notebooks]'`",
}


@pytest.mark.parametrize("arguments", NEEDS, ids=" ".join)
def test_what_is_missing_is_one_line(arguments: tuple[str, ...], root: Path, tmp_path: Path) -> None:
    (tmp_path / "spec.toml").write_text(SPEC, encoding="utf-8")
    found = run(root, tmp_path, *arguments)
    assert found.stderr == f"symcheck: {NEEDS[arguments]}\n"
    assert found.returncode == 2
    assert found.stdout == ""


def test_figures_are_listed_all_the_same(root: Path, tmp_path: Path) -> None:
    found = run(root, tmp_path, "plot")
    assert found.returncode == 0
    assert "liquid-frequencies" in found.stdout


def test_a_figure_drawn_in_python_says_what_to_install(root: Path, tmp_path: Path) -> None:
    code = """
from symcheck.numeric import wheels
try:
    wheels.plot_envelope(wheels.envelope(wheels.four_wheels(1.0, 0.5), 1.0))
except ModuleNotFoundError as error:
    print(error)
"""
    found = run(root, tmp_path, main=code)
    assert found.stdout == f"figures need matplotlib; run `{PIP} 'symcheck[plots]'`\n", found.stderr


def test_the_python_of_a_checkout_is_named_as_it_is_called_from_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "executable", str(tmp_path / ".venv" / "bin" / "python"))
    assert installing("plots") == ".venv/bin/python -m pip install 'symcheck[plots]'"


@pytest.mark.parametrize(
    "call",
    [
        "from symcheck.numeric import wheels; wheels.half_spaces([[1, 0, 0], [0, 1, 0], [0, 0, 1]], engine='numba')",
        "from symcheck.numeric import wheels; wheels.face_distances([[1, 0, 0], [0, 1, 0], [0, 0, 1]], engine='numba')",
        "from symcheck.numeric.random_rotation.ensemble import _advance; _advance('numba')",
    ],
)
def test_an_engine_that_is_missing_says_what_to_install(call: str, root: Path, tmp_path: Path) -> None:
    code = f"""
try:
    {call}
except ImportError as error:
    print(error)
"""
    found = run(root, tmp_path, main=code)
    assert found.stdout == f"engine='numba' needs numba; run `{PIP} 'symcheck[numba]'`, or leave engine='numpy'\n", (
        found.stderr
    )


def test_a_sweep_with_an_engine_that_is_missing_is_one_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("zarr")
    from click.testing import CliRunner

    from symcheck.cli import cli

    monkeypatch.setitem(sys.modules, "numba", None)
    for module in ("compiled", "wheels.numba_engine"):
        monkeypatch.delitem(sys.modules, f"symcheck.numeric.{module}", raising=False)
    spec = tmp_path / "spec.toml"
    spec.write_text(
        'function = "wheels.face_distances"\n[parameters]\nengine = "numba"\nlimits = 1.0\n'
        'axes = { function = "wheels.four_wheels", a = [0.8, 0.9], b = 0.6 }\n',
        encoding="utf-8",
    )
    result = CliRunner().invoke(cli, ["sweep", str(spec), "--out", str(tmp_path / "out.zarr")], prog_name="symcheck")
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    assert "engine='numba' needs numba; run " in result.stderr
