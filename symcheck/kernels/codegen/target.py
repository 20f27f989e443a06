"""A target: the language that kernels are written in. Each module `<name>_target` of this package declares TARGET."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib import import_module

from symcheck.kernels.codegen import SUFFIX
from symcheck.kernels.codegen.kernel import Kernel
from symcheck.kernels.codegen.program import Program

MARK = "Written by `symcheck generate`: what is changed here is lost."


@dataclass(frozen=True)
class CompiledKernel:
    """A kernel that may be written, and on which claims and proofs it rests.

    program     for many points at once: sines and cosines of acute angles through one tangent
    pointwise   for few points: each function by its name
    claims      relations, each with the beginning of the SHA-256 of its certificates
    forms       the same of the proofs that accurate forms equal the derived ones
    """

    kernel: Kernel
    program: Program
    pointwise: Program
    claims: Mapping[str, str] = field(default_factory=dict)
    forms: str = ""


@dataclass(frozen=True)
class Target:
    """files: of the key of a paper and its kernels by name, the text of each file by its name; each bears MARK."""

    says: str
    files: Callable[[str, Mapping[str, CompiledKernel]], Mapping[str, str]]


def target(name: str) -> Target:
    """The target of that name."""
    found = import_module(f"symcheck.kernels.codegen.{name}{SUFFIX}").TARGET
    assert isinstance(found, Target)
    return found
