"""Direction cosine matrices, built from symbols or from elementary rotations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from symcheck.core.lazy import lazy

if TYPE_CHECKING:
    from sympy import Expr, Matrix

sp = lazy("sympy")


def matrix(letter: str = "a") -> Matrix:
    """A 3 x 3 matrix of the real symbols letter_11 .. letter_33, rows first."""
    return sp.Matrix(3, 3, lambda i, j: sp.Symbol(f"{letter}_{i + 1}{j + 1}", real=True))


def entries(values: Expr, letter: str = "a") -> dict[str, Expr]:
    """The entries of a 3 x 3 matrix by name, `letter`_11 to `letter`_33."""
    return {f"{letter}_{i + 1}{j + 1}": values[i, j] for i in range(3) for j in range(3)}


def elementary(axis: int, angle: Expr) -> Matrix:
    """Direction cosines of axes turned by `angle` (radians, right-hand rule) about axis 1, 2 or 3.

    Row i holds the turned axis i in the old axes; elementary(3, t) is
    [[cos t, sin t, 0], [-sin t, cos t, 0], [0, 0, 1]].
    """
    c, s = sp.cos(angle), sp.sin(angle)
    j, k = axis % 3, (axis + 1) % 3
    turned = sp.eye(3)
    turned[j, j], turned[j, k], turned[k, j], turned[k, k] = c, s, -s, c
    return turned
