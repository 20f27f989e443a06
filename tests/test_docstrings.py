"""Every public name has a docstring in numpydoc form, whose examples run."""

from __future__ import annotations

import doctest
import inspect
import sys
from collections.abc import Iterator
from enum import EnumType
from importlib import import_module
from pathlib import Path

import pytest
from build_docs import PACKAGES
from numpydoc.docscrape import get_doc_object
from numpydoc.validate import ERROR_MSGS, validate
from optimized import about_docstrings

pytestmark = about_docstrings
LEFT_OUT = {
    "ES01",  # an extended summary, where one line says all
    "EX01",  # examples, where a call says nothing that the summary does not
    "GL01",  # the text begins behind the quotes, as everywhere in this project
    "PR04",  # types, which stand in the signature
    "SA01",  # "See Also", where nothing is near
    "SA04",  # the descriptions there, which the reference shows anyway
    "SS05",  # a verb in the infinitive: it takes every first word that ends in s, as Moments, for a wrong one
}
CHECKS = set(ERROR_MSGS) - LEFT_OUT
PARAMETERS = {"PR01", "PR02", "PR03"}


def public(package: str) -> Iterator[tuple[str, object]]:
    """The functions and classes that a package offers: those it lists, else those it defines."""
    module = import_module(package)
    listed = getattr(module, "__all__", None)
    for name in listed or [name for name in vars(module) if not name.startswith("_")]:
        found = getattr(module, name, None)  # which a module is not before it is imported
        own = listed or getattr(found, "__module__", "") == package
        if own and (inspect.isclass(found) or inspect.isroutine(found)):
            yield f"{package}.{name}", found


OBJECTS = dict(pair for package in PACKAGES for pair in public(package))
MODULES = sorted({found.__module__ for found in OBJECTS.values()})


@pytest.mark.parametrize("name", OBJECTS)
def test_a_public_docstring_is_valid(name: str) -> None:
    found = OBJECTS[name]
    chosen = CHECKS - PARAMETERS if isinstance(found, EnumType) else CHECKS  # nobody constructs members
    errors = validate(get_doc_object(found))["errors"]
    assert [(code, told) for code, told in errors if code in chosen] == []


def test_every_public_function_of_numbers_has_an_example() -> None:
    packages = [package for package in PACKAGES if package.startswith("symcheck.numeric.") and "sweep" not in package]
    functions = {name: f for package in packages for name, f in public(package) if inspect.isroutine(f)}
    assert [name for name, function in functions.items() if ">>> " not in (inspect.getdoc(function) or "")] == []
    assert functions


@pytest.mark.parametrize("module", MODULES)
def test_the_examples_of_public_docstrings_run(module: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("SYMCHECK_CACHE", str(tmp_path / "cache"))
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    flags = doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS
    assert doctest.testmod(sys.modules[module], optionflags=flags).failed == 0


@pytest.mark.parametrize("package", PACKAGES)
def test_a_public_package_offers_something(package: str) -> None:
    assert [*public(package)]
