"""Generated C, compiled as its header says, and called through ctypes."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from kernel_reference import Case, cases

from symcheck.kernels.codegen import c_target
from symcheck.kernels.codegen.c_text import COMPILE

COMPILERS = tuple(name for name in ("gcc", "clang") if shutil.which(name))
FLAGS = " ".join(COMPILE).split()[1:]  # what the header recommends, less the name of the compiler
STRICT = ("-Wall", "-Wextra", "-Werror", "-pedantic")
SAYING = "-fopt-info-vec"  # GCC says which loops it made of vector instructions; nothing else changes
CLANG = ("-Wno-pass-failed",)  # it has no vector form of exp and the like, and would fail for saying so
_folder = TemporaryDirectory(prefix="symcheck-c-")


@cache
def texts() -> Mapping[str, str]:
    """All files that `symcheck generate --target c` writes, without the evidence."""
    by_paper: dict[str, dict[str, Any]] = {}
    for case in cases().values():
        by_paper.setdefault(case.paper, {})[case.name] = case.compiled
    return {
        name: text for key, kernels in by_paper.items() for name, text in c_target.TARGET.files(key, kernels).items()
    }


@cache
def folder() -> Path:
    """A folder with these files, which lives as long as this process."""
    for name, text in texts().items():
        (Path(_folder.name) / name).write_text(text, encoding="utf-8")
    return Path(_folder.name)


def compiled(compiler: str, *arguments: str) -> str:
    """What a compiler says; RuntimeError with it, if it fails."""
    command = [compiler, *FLAGS, *STRICT, *(CLANG if compiler == "clang" else ()), *arguments]
    done = subprocess.run(command, cwd=folder(), capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(f"{' '.join(command)}\n{done.stderr[:4000]}")
    return done.stderr


@cache
def built(files: tuple[str, ...], compiler: str, *changes: str) -> tuple[Path, str]:
    """A shared library of some files, and what the compiler said.

    `changes` are flags besides those of the header; the last counts.
    """
    target = folder() / f"{len(list(folder().glob('*.so')))}.so"
    return target, compiled(compiler, "-shared", "-fPIC", *changes, *files, "-lm", "-o", target.name)


def library(files: tuple[str, ...], compiler: str, *changes: str) -> ctypes.CDLL:
    """The same, loaded."""
    return ctypes.CDLL(str(built(files, compiler, *changes)[0]))


def sources() -> tuple[str, ...]:
    """The names of the files that are compiled."""
    return tuple(name for name in texts() if name.endswith(".c"))


def everything(compiler: str, *changes: str) -> ctypes.CDLL:
    """The library of all kernels."""
    return library(sources(), compiler, *([SAYING] if compiler == "gcc" else []), *changes)


def addresses(arrays: Sequence[Any]) -> list[ctypes.c_void_p]:
    """Where arrays of doubles lie."""
    assert all(x.dtype == np.float64 and x.flags.c_contiguous for x in arrays)
    return [ctypes.c_void_p(x.ctypes.data) for x in arrays]


def called(loaded: ctypes.CDLL, case: Case, points: Sequence[Any]) -> list[Any]:
    """The results of a kernel at some points."""
    columns = [np.ascontiguousarray(x, np.float64) for x in points]
    results = [np.full(columns[0].size, 7e77) for _ in case.kernel.outputs]
    getattr(loaded, f"{case.paper}_{case.name}")(ctypes.c_size_t(columns[0].size), *addresses([*columns, *results]))
    return results
