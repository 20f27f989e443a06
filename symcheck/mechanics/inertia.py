"""Inertia tensors of rigid bodies in rotated axes, and the moments a mass distribution can have."""

from __future__ import annotations

from typing import TYPE_CHECKING

from symcheck.core.lazy import lazy

if TYPE_CHECKING:
    from sympy import Expr, Matrix

sp = lazy("sympy")


def principal_moments(letter: str = "I") -> tuple[Expr, Expr, Expr]:
    """Make symbols for the principal moments of inertia.

    Parameters
    ----------
    letter
        The stem of the symbols.

    Returns
    -------
    tuple of sympy.Expr
        The real symbols letter_1, letter_2, letter_3.
    """
    first, second, third = (sp.Symbol(f"{letter}_{i}", real=True) for i in (1, 2, 3))
    return first, second, third


def axial_moments(tensor: Matrix, axes: Matrix) -> list[Expr]:
    """Derive the moments of inertia about three axes.

    Parameters
    ----------
    tensor
        The inertia tensor T, 3 x 3.
    axes
        The axes n as rows, 3 x 3.

    Returns
    -------
    list of sympy.Expr
        The values n^T T n, one for each axis.
    """
    return [sp.expand((axes[i, :] * tensor * axes[i, :].T)[0, 0]) for i in range(3)]


def from_second_moments(second: tuple[Expr, Expr, Expr]) -> tuple[Expr, Expr, Expr]:
    """Derive the principal moments of inertia from the second moments of the mass.

    Parameters
    ----------
    second
        P_i, the integral of x_i^2 over the mass, for the three principal axes.

    Returns
    -------
    tuple of sympy.Expr
        I_1 = P_2 + P_3, and cyclically I_2 and I_3.
    """
    p1, p2, p3 = second
    return p2 + p3, p3 + p1, p1 + p2


def euler_residual(tensor: Matrix, rate: Matrix, acceleration: Matrix, torque: Matrix) -> Matrix:
    """Derive what Euler's equations of a rigid body say vanishes.

    Parameters
    ----------
    tensor
        The inertia tensor I, 3 x 3.
    rate
        The angular velocity w in body axes, 3 x 1.
    acceleration
        Its rate of change w' in body axes, 3 x 1.
    torque
        The torque M, 3 x 1.

    Returns
    -------
    sympy.Matrix
        I w' + w x I w - M: the rate of change of the angular momentum, less the torque.
    """
    momentum = tensor * rate
    return (tensor * acceleration + rate.cross(momentum) - torque).applyfunc(sp.expand)
