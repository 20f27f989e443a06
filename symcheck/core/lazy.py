"""Modules and names that are imported at their first use: SymPy takes half a second, and most runs never need it."""

from __future__ import annotations

import sys
from collections.abc import Collection, Mapping
from importlib import import_module
from importlib.util import LazyLoader, find_spec, module_from_spec
from types import ModuleType


def lazy(name: str) -> ModuleType:
    """The module `name`, loaded when an attribute is first read."""
    if name in sys.modules:
        return sys.modules[name]
    spec = find_spec(name)
    if spec is None or spec.loader is None:
        raise ModuleNotFoundError(f"No module named {name!r}", name=name)
    spec.loader = LazyLoader(spec.loader)
    module = module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


def public(package: str, homes: Mapping[str, Collection[str]], name: str) -> object:
    """What `__getattr__` of a package gives: a public name of one of its modules, or a public module."""
    home = next((module for module, names in homes.items() if name in names), None)
    if home:
        value: object = getattr(import_module(f"{package}.{home}"), name)
        return value
    if name in sys.modules[package].__all__:
        return import_module(f"{package}.{name}")
    raise AttributeError(f"module {package!r} has no attribute {name!r}")
