"""What users import from `symcheck` itself: there, declared once, and imported only when it is used."""

from __future__ import annotations

import ast
import doctest
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest

import symcheck

HOMES = {name: module for module, names in symcheck._HOMES.items() for name in names}


@pytest.mark.parametrize("name", symcheck.__all__)
def test_a_public_name_is_what_its_module_has(name: str) -> None:
    home = HOMES.get(name)
    expected = getattr(import_module(home), name) if home else import_module(f"symcheck.{name}")
    assert getattr(symcheck, name) is expected


def test_type_checkers_see_the_same_names() -> None:
    tree = ast.parse(Path(symcheck.__file__).read_text(encoding="utf-8"))
    [block] = [node for node in tree.body if isinstance(node, ast.If)]
    imports = [node for node in block.body if isinstance(node, ast.ImportFrom)]
    told = {alias.asname or alias.name: node.module for node in imports for alias in node.names}
    assert told == {**HOMES, **dict.fromkeys(set(symcheck.__all__) - set(HOMES), "symcheck")}


def test_the_package_imports_nothing_until_a_name_is_used() -> None:
    code = (
        "import sys, symcheck; loaded = set(sys.modules); symcheck.Verdict;"
        "print(*sorted(name for name in loaded if name.partition('.')[0] in ('symcheck', 'sympy', 'numpy')));"
        "print(*sorted(name for name in sys.modules if name.startswith('symcheck.')))"
    )
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert done.stdout.splitlines() == ["symcheck", "symcheck.core symcheck.core.verdicts"]


def test_an_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="no attribute 'chekc'"):
        symcheck.chekc  # noqa: B018


def test_the_examples_of_the_audit_run(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("SYMCHECK_CACHE", str(tmp_path / "cache"))
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    library = import_module("symcheck.audit.library")
    assert doctest.testmod(library) == doctest.TestResults(failed=0, attempted=2)
