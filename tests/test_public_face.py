"""What users import from `symcheck` itself: there, declared once, and imported only when it is used."""

from __future__ import annotations

import ast
import doctest
import subprocess
import sys
from collections.abc import Iterator
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from pkgutil import iter_modules

import pytest
from optimized import about_docstrings

import symcheck

FOLDER = Path(symcheck.__file__).parent
LAZY = ("symcheck", "symcheck.audit")  # whose names are imported at their first use
OF_FUNCTIONS = {"checker", "document", "generated", "proof", "question", "reading"}  # these list no modules
PACKAGES = ["symcheck", *(f"symcheck.{each.name}" for each in iter_modules(symcheck.__path__) if each.ispkg)]
FACES = {name: getattr(import_module(name), "__all__", []) for name in PACKAGES if name != "symcheck.generated"}


def homes(package: str) -> dict[str, str]:
    return {name: f"{package}.{module}" for module, names in import_module(package)._HOMES.items() for name in names}


@about_docstrings
@pytest.mark.parametrize("package", PACKAGES)
def test_a_package_says_in_one_line_what_it_is_for(package: str) -> None:
    first = (import_module(package).__doc__ or "").partition("\n")[0]
    assert first.endswith(".")
    assert len(first.split()) > 3


@pytest.mark.parametrize("package", FACES)
def test_what_a_package_lists_can_be_imported(package: str) -> None:
    for name in FACES[package]:
        exec(f"from {package} import {name}", {})
        assert name in dir(import_module(package))


@pytest.mark.parametrize("package", LAZY)
def test_a_public_name_is_what_its_module_has(package: str) -> None:
    face = import_module(package)
    for name, home in homes(package).items():
        assert getattr(face, name) is getattr(import_module(home), name)
        assert name in face.__all__


@pytest.mark.parametrize("package", LAZY)
def test_type_checkers_see_the_same_names(package: str) -> None:
    tree = ast.parse(Path(import_module(package).__file__ or "").read_text(encoding="utf-8"))
    [block] = [node for node in tree.body if isinstance(node, ast.If)]
    imports = [node for node in block.body if isinstance(node, ast.ImportFrom)]
    seen = {alias.asname or alias.name: node.module for node in imports for alias in node.names}
    modules = {name for name in FACES[package] if find_spec(f"{package}.{name}")}
    assert {name: home for name, home in seen.items() if name not in modules} == homes(package)
    assert {*seen} | modules == {*FACES[package]}


def imported(file: Path) -> Iterator[tuple[str, str, str]]:
    """Package, module inside it and name of each import from another package."""
    own = file.relative_to(FOLDER).parts[0]
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("symcheck."):
            _, package, *inside = (node.module or "").split(".")
            yield from ((package, *[*inside, ""][:1], alias.name) for alias in node.names if package != own)


def test_packages_use_of_each_other_what_is_listed() -> None:
    files = [file for file in FOLDER.rglob("*.py") if file.parent != FOLDER and "generated" not in file.parts]
    uses = {(file.name, *use) for file in files for use in imported(file) if use[0] not in OF_FUNCTIONS}
    assert [use for use in uses if not {*use[2:]} & {*FACES[f"symcheck.{use[1]}"]}] == []
    assert len(uses) > 100


def test_the_package_imports_nothing_until_a_name_is_used() -> None:
    code = (
        "import sys, symcheck; loaded = set(sys.modules); symcheck.Verdict;"
        "print(*sorted(name for name in loaded if name.partition('.')[0] in ('symcheck', 'sympy', 'numpy')));"
        "print(*sorted(name for name in sys.modules if name.startswith('symcheck.')))"
    )
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert done.stdout.splitlines() == ["symcheck", "symcheck.core symcheck.core.lazy symcheck.core.verdicts"]


def test_an_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="no attribute 'chekc'"):
        symcheck.chekc  # noqa: B018


@about_docstrings
def test_the_examples_of_the_audit_run(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("SYMCHECK_CACHE", str(tmp_path / "cache"))
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    library = import_module("symcheck.audit.library")
    assert doctest.testmod(library) == doctest.TestResults(failed=0, attempted=2)
