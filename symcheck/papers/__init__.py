"""The audited papers: subpackages here that bind `paper`, and folders of users, all found without registration."""

from __future__ import annotations

import os
import pkgutil
import sys
import traceback
from collections.abc import Iterator, Mapping
from functools import cache
from importlib import import_module
from importlib.metadata import entry_points
from importlib.util import module_from_spec, spec_from_file_location
from itertools import pairwise
from pathlib import Path

from symcheck.core.claims import Paper
from symcheck.core.ids import key_of
from symcheck.core.verdicts import SymcheckError

__all__ = ["FILES", "Papers", "add", "declare", "key_of", "load", "places"]

VARIABLE = "SYMCHECK_PAPERS"  # folders of users, separated as in PATH; worker processes read it too
FILES = ("audit.py", "__init__.py")  # one of them binds `paper`


class Papers(Mapping[str, Paper]):
    """All papers by key, in alphabetical order; each is imported when it is asked for."""

    def __init__(self) -> None:
        self.built_in = sorted(info.name for info in pkgutil.iter_modules(__path__) if info.ispkg)
        named = dict.fromkeys(filter(None, os.environ.get(VARIABLE, "").split(os.pathsep)))
        modules = [(key, f"{__name__}.{key}") for key in self.built_in]
        modules += [(point.name, point.value) for point in entry_points(group=__name__)]
        folders = [(key_of(Path(folder)), folder) for folder in named]
        for (key, home), (other, second) in pairwise(sorted([*modules, *folders])):
            if key == other:
                raise SymcheckError(f"two papers have the key {key!r}: {home} and {second}; rename one of them")
        self._modules, self.folders = dict(modules), {key: Path(folder) for key, folder in folders}

    def __getitem__(self, key: str) -> Paper:
        if key in self.folders:
            return _of_folder(self.folders[key], key)
        try:
            paper: Paper = import_module(self._modules[key]).paper
        except (ImportError, AttributeError) as error:
            raise SymcheckError(f"{self._modules[key]}, named as the paper {key!r}, cannot be used: {error}") from error
        return paper

    def __contains__(self, key: object) -> bool:
        return key in self._modules or key in self.folders

    def __iter__(self) -> Iterator[str]:
        return iter(sorted([*self._modules, *self.folders]))

    def __len__(self) -> int:
        return len(self._modules) + len(self.folders)


@cache
def load() -> Papers:
    """The papers."""
    return Papers()


def add(folder: Path) -> str:
    """The key of the paper in a folder, which is one of the papers from now on, in worker processes too."""
    folder = folder.resolve()
    known = [each for each in os.environ.get(VARIABLE, "").split(os.pathsep) if each]
    if str(folder) not in known:
        os.environ[VARIABLE] = os.pathsep.join([*known, str(folder)])
        load.cache_clear()
    return key_of(folder)


def _of_folder(folder: Path, key: str) -> Paper:
    """The paper that a user's file declares; SymcheckError with file and line where it fails."""
    name, file = f"{__name__}.{key}", next((folder / each for each in FILES if (folder / each).is_file()), None)
    if file is None:
        if folder.is_file():
            raise SymcheckError(f"{folder} is no audit; `symcheck new {folder.name}` begins one of a document")
        raise SymcheckError(f"{folder} has no {FILES[0]}; name the folder of an audit")
    if name not in sys.modules:
        spec = spec_from_file_location(name, file, submodule_search_locations=[str(folder)])
        assert spec is not None
        assert spec.loader is not None
        module = sys.modules[name] = module_from_spec(spec)
        try:
            spec.loader.exec_module(module)
        except SyntaxError as error:
            del sys.modules[name]
            raise SymcheckError(f"{error.filename}:{error.lineno}: {error.msg}") from error
        except Exception as error:
            del sys.modules[name]
            kind = "" if isinstance(error, SymcheckError) else f"{type(error).__name__}: "
            raise SymcheckError(f"{_line(error, folder) or file}: {kind}{error}") from error
    paper = getattr(sys.modules[name], "paper", None)
    if not isinstance(paper, Paper) or paper.key != key:
        found = f"its key is {paper.key!r}" if isinstance(paper, Paper) else "it binds none"
        raise SymcheckError(
            f"{file} is to bind `paper`, a Paper with the key {key!r}, as its folder is called; {found}"
        )
    return paper


def _line(error: Exception, folder: Path) -> str:
    """File and line of the user's code where an error comes from."""
    frames = traceback.extract_tb(error.__traceback__)
    own = [frame for frame in frames if Path(frame.filename).is_relative_to(folder)]
    return f"{own[-1].filename}:{own[-1].lineno}" if own else ""
