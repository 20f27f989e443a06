"""Kernels: where the generated ones are and how they run; `codegen` writes them."""

from symcheck.kernels.loading import GENERATED, find, folder, load, of_paper

__all__ = [
    "GENERATED",
    "calling",
    "codegen",
    "find",
    "folder",
    "load",
    "of_paper",
    "planning",
    "quantities",
    "ratios",
    "runtime",
    "specification",
    "tracing",
]
