"""Direction cosine matrices, built from symbols or from elementary rotations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from symcheck.core.lazy import lazy

if TYPE_CHECKING:
    from sympy import Expr, Matrix

sp = lazy("sympy")


def matrix(letter: str = "a") -> Matrix:
    """Build a matrix of symbols, such as direction cosines.

    Parameters
    ----------
    letter
        The stem of the symbols.

    Returns
    -------
    sympy.Matrix
        The real symbols letter_11 to letter_33, 3 x 3, rows first.
    """
    return sp.Matrix(3, 3, lambda i, j: sp.Symbol(f"{letter}_{i + 1}{j + 1}", real=True))


def entries(values: Expr, letter: str = "a") -> dict[str, Expr]:
    """Name the entries of a matrix.

    Parameters
    ----------
    values
        A 3 x 3 matrix.
    letter
        The stem of the names.

    Returns
    -------
    dict of str to sympy.Expr
        The entries by their names letter_11 to letter_33.
    """
    return {f"{letter}_{i + 1}{j + 1}": values[i, j] for i in range(3) for j in range(3)}


def elementary(axis: int, angle: Expr) -> Matrix:
    """Build the direction cosines of axes turned about one of them.

    Parameters
    ----------
    axis
        1, 2 or 3.
    angle
        The angle in radians, by the right-hand rule.

    Returns
    -------
    sympy.Matrix
        Row i holds the turned axis i in the old axes, 3 x 3.

    Examples
    --------
    >>> from sympy import Symbol
    >>> elementary(3, Symbol("t")).tolist()
    [[cos(t), sin(t), 0], [-sin(t), cos(t), 0], [0, 0, 1]]
    """
    c, s = sp.cos(angle), sp.sin(angle)
    j, k = axis % 3, (axis + 1) % 3
    turned = sp.eye(3)
    turned[j, j], turned[j, k], turned[k, j], turned[k, k] = c, s, -s, c
    return turned
