"""When the stationary laws of the randomly driven rotation exist: each condition once, with its equation."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from symcheck.numeric.domain import Array, real, require


def positive(name: str, value: ArrayLike, source: str) -> Array:
    """The value as an array; ValueError where it is not positive."""
    array = real(name, value)
    require(array > 0, name, array, "be positive", source)
    return array


def somewhere(holds: Any, name: str, value: Array, condition: str, source: str) -> None:
    """`require` for a condition on several arguments, whose shape is the broadcast one."""
    require(holds, name, np.broadcast_to(value, np.shape(holds)), condition, source)


def equatorial(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> tuple[Array, Array, Array]:
    """alpha, beta, gamma, for which the amplitude has a stationary density."""
    noise = positive("alpha", alpha, "(3.5); without multiplicative noise the density is Rayleigh's, B.10")
    additive = positive("beta", beta, "4.0.3; without additive noise nothing is stationary, B.11")
    dissipation = positive("gamma", gamma, "1.1.7")
    somewhere(2 * dissipation > noise, "gamma", dissipation, "satisfy 4 gamma^2 > alpha^2", "4.0.3")
    return noise, additive, dissipation


def axial(k: ArrayLike, g_13: ArrayLike, g_23: ArrayLike, d_33: ArrayLike) -> tuple[Array, Array, Array, Array]:
    """k, g_13, g_23, d_33, for which the frequency has a stationary density."""
    return (
        positive("k", k, "(1.1)"),
        positive("g_13", g_13, "(3.5); without multiplicative noise the density is normal"),
        positive("g_23", g_23, "4.0.5; without additive noise nothing is stationary"),
        positive("d_33", d_33, "4.0.5"),
    )


def order(m: ArrayLike) -> Array:
    """The order of a moment."""
    array = real("m", m)
    require(array >= 0, "m", array, "not be negative", "4.0.9, 4.0.11")
    return array


def probability(q: ArrayLike) -> Array:
    """A probability between 0 and 1, both excluded."""
    array = real("q", q)
    require((array > 0) & (array < 1), "q", array, "lie between 0 and 1, both excluded", "B.4")
    return array


def evaluated(what: str, function: Callable[..., Any], *values: Array) -> Array:
    """What the function gives; ValueError where this is no finite double."""
    with np.errstate(all="ignore"):
        result: Array = function(*values)
    require(np.isfinite(result), what, result, "be a finite double; take parameters farther from where it diverges")
    return result
