"""What the engines of Numba have in common."""

from __future__ import annotations

from collections.abc import Callable
from typing import ParamSpec, TypeVar

import numba

P = ParamSpec("P")
T = TypeVar("T")


def compiled(function: Callable[P, T]) -> Callable[P, T]:
    """Compiled without the interpreter's lock and checks of division, with fused products and sums; kept on disk."""
    options = numba.njit(nogil=True, cache=True, error_model="numpy", fastmath={"contract"})
    fast: Callable[P, T] = options(function)
    return fast
