"""Inertia tensors of rigid bodies in rotated axes, and the moments a mass distribution can have."""

from __future__ import annotations

from typing import TYPE_CHECKING

from symcheck.core.lazy import lazy

if TYPE_CHECKING:
    from sympy import Expr, Matrix

sp = lazy("sympy")


def principal_moments(letter: str = "I") -> tuple[Expr, Expr, Expr]:
    """The symbols letter_1, letter_2, letter_3."""
    first, second, third = (sp.Symbol(f"{letter}_{i}", real=True) for i in (1, 2, 3))
    return first, second, third


def axial_moments(tensor: Matrix, axes: Matrix) -> list[Expr]:
    """Moments of inertia about the rows of `axes`: n^T T n with T the inertia tensor."""
    return [sp.expand((axes[i, :] * tensor * axes[i, :].T)[0, 0]) for i in range(3)]


def from_second_moments(second: tuple[Expr, Expr, Expr]) -> tuple[Expr, Expr, Expr]:
    """Principal moments of inertia from P_i = integral of x_i^2 dm: I_1 = P_2 + P_3 and cyclic."""
    p1, p2, p3 = second
    return p2 + p3, p3 + p1, p1 + p2


def euler_residual(tensor: Matrix, rate: Matrix, acceleration: Matrix, torque: Matrix) -> Matrix:
    """I w' + w x I w - M in body axes: the inertial rate of change of the angular momentum, less the torque."""
    momentum = tensor * rate
    return (tensor * acceleration + rate.cross(momentum) - torque).applyfunc(sp.expand)
