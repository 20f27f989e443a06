"""What is shipped is what is tracked, every package is listed, and every pinned version is needed."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tomllib
import zipfile
from importlib.metadata import requires
from pathlib import Path, PurePosixPath
from typing import Any

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

import symcheck
from symcheck.evidence.obligation import SOURCES

PACKAGE = "symcheck/"


@pytest.fixture(scope="module")
def project(request: pytest.FixtureRequest) -> dict[str, Any]:
    return tomllib.loads((request.config.rootpath / "pyproject.toml").read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def tracked(request: pytest.FixtureRequest) -> list[str]:
    """The files of the checkout that git does not ignore; in a clean checkout these are the tracked ones."""
    root = request.config.rootpath
    if not (root / ".git").exists():
        pytest.skip("not a git checkout")
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard"]
    listed = subprocess.run(command, cwd=root, capture_output=True, text=True, check=True).stdout.splitlines()
    return [name for name in listed if (root / name).is_file()]


@pytest.fixture(scope="module")
def wheel(
    request: pytest.FixtureRequest, tracked: list[str], tmp_path_factory: pytest.TempPathFactory
) -> zipfile.ZipFile:
    """A wheel built from a copy of the checkout, so that nothing ignored can get into it."""
    copy, out = tmp_path_factory.mktemp("copy"), tmp_path_factory.mktemp("wheel")
    for name in tracked:
        (copy / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(request.config.rootpath / name, copy / name)
    command = [sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", str(out), str(copy)]
    built = subprocess.run(command, capture_output=True, text=True)
    assert built.returncode == 0, built.stdout + built.stderr
    [file] = out.iterdir()
    return zipfile.ZipFile(file)


def test_the_wheel_contains_exactly_the_tracked_files(wheel: zipfile.ZipFile, tracked: list[str]) -> None:
    shipped = {name for name in wheel.namelist() if ".dist-info/" not in name}
    package = {name for name in tracked if name.startswith(PACKAGE)}
    assert shipped == package


def test_the_wheel_finds_what_was_generated(wheel: zipfile.ZipFile, tmp_path: Path, root: Path) -> None:
    wheel.extractall(tmp_path)
    code = (
        "import sys, pathlib\n"
        f"sys.path.insert(0, {str(tmp_path)!r})\n"
        "from symcheck import kernels\n"
        "from symcheck.evidence import store\n"
        "print(kernels.folder())\n"
        "print(sorted(str(file.relative_to(kernels.folder())) for file in kernels.folder().rglob('*.json')))\n"
    )
    result = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True)
    folder, files = result.stdout.splitlines()
    assert folder == str((tmp_path / "symcheck" / "generated").resolve())
    generated = root / "symcheck" / "generated"
    assert files == str(sorted(str(file.relative_to(generated)) for file in generated.rglob("*.json")))


def test_every_package_folder_is_listed(project: dict[str, Any], tracked: list[str]) -> None:
    places = {str(PurePosixPath(name).parent) for name in tracked if name.endswith(".py")}
    inside = {place.replace("/", ".") for place in places if f"{place}/".startswith(PACKAGE)}
    assert set(project["tool"]["setuptools"]["packages"]) == inside


def test_every_package_folder_has_an_init(tracked: list[str]) -> None:
    sources = [PurePosixPath(name) for name in tracked if name.endswith(".py") and name.startswith(PACKAGE)]
    assert {file.parent for file in sources} == {file.parent for file in sources if file.name == "__init__.py"}


def _pins(root: Path) -> dict[str, str]:
    lines = (root / "constraints.txt").read_text(encoding="utf-8").splitlines()
    pins = [re.fullmatch(r"([A-Za-z0-9._-]+)==([0-9][0-9A-Za-z.]*)", line) for line in lines]
    return {canonicalize_name(pin[1]): pin[2] for pin in pins if pin}


def test_constraints_are_exact_pins_and_nothing_else(root: Path) -> None:
    assert len(_pins(root)) == len((root / "constraints.txt").read_text(encoding="utf-8").splitlines())


def _needed(names: list[str]) -> set[str]:
    """The transitive requirements of installed distributions on this platform."""
    found: set[tuple[str, frozenset[str]]] = set()  # with their extras, which need more
    waiting = [Requirement(name) for name in names]
    while waiting:
        requirement = waiting.pop()
        name, extras = canonicalize_name(requirement.name), frozenset(requirement.extras)
        if (name, extras) in found:
            continue
        found.add((name, extras))
        for text in requires(name) or ():
            further = Requirement(text)
            if not further.marker or any(further.marker.evaluate({"extra": extra}) for extra in ("", *extras)):
                waiting.append(further)
    return {name for name, _ in found}


def _direct(project: dict[str, Any]) -> list[str]:
    """What is asked for, also by the development environment; an extra of ours stands for its own requirements."""
    extras, found = project["project"]["optional-dependencies"], list(project["project"]["dependencies"])
    for requirement in map(Requirement, extras["dev"]):
        ours = requirement.name == project["project"]["name"]
        found += [text for extra in requirement.extras for text in extras[extra]] if ours else [str(requirement)]
    return found


def test_every_requirement_is_pinned_down_to_the_last(project: dict[str, Any], root: Path) -> None:
    assert _needed(_direct(project)) - set(_pins(root)) == set()


@pytest.mark.skipif(sys.version_info >= (3, 12), reason="the oldest Python requires the most")
def test_nothing_is_pinned_that_is_not_required(project: dict[str, Any], root: Path) -> None:
    # Required by interpreters that are older still, so not found on each.
    assert set(_pins(root)) - _needed(_direct(project)) <= {"typing-extensions"}


def test_the_build_uses_the_pinned_setuptools(project: dict[str, Any], root: Path) -> None:
    assert project["build-system"]["requires"] == [f"setuptools=={_pins(root)['setuptools']}"]


def test_pins_satisfy_the_declared_ranges(project: dict[str, Any], root: Path) -> None:
    pins = _pins(root)
    for text in _direct(project):
        requirement = Requirement(text)
        assert requirement.specifier.contains(pins[canonicalize_name(requirement.name)]), text


def test_a_cached_result_depends_on_every_module_that_makes_it() -> None:
    program = "import sys, symcheck.evidence.decide; print(*(n for n in sys.modules if n.startswith('symcheck.')))"
    loaded = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout.split()
    hashed = {source.removesuffix(".py") for source in SOURCES}
    by_content = {"papers", "lazy"}  # declarations are hashed one by one; lazy only puts imports off
    assert {name.split(".")[1] for name in loaded} <= hashed | by_content
    assert all((Path(symcheck.__file__).parent / source).exists() for source in SOURCES)
