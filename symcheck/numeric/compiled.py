"""What the engines of Numba have in common."""

from __future__ import annotations

from collections.abc import Callable
from typing import ParamSpec, TypeVar

import numba

P = ParamSpec("P")
T = TypeVar("T")


def compiled(function: Callable[P, T]) -> Callable[P, T]:
    """Compiled without the interpreter's lock and checks of division, with fused products and sums.

    Kept on disk; where no folder for that may be written, as for a user without a home, compiled in each process.
    """
    options = {"nogil": True, "error_model": "numpy", "fastmath": {"contract"}}
    try:
        fast: Callable[P, T] = numba.njit(cache=True, **options)(function)
    except RuntimeError:  # Numba finds no folder
        fast = numba.njit(**options)(function)
    return fast
