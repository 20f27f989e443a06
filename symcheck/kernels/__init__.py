"""Kernels: where the generated ones are and how they run; `codegen` writes them."""

from symcheck.kernels.loading import folder, load

__all__ = ["folder", "load"]
