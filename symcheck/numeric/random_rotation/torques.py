"""The coefficients of system (1.1): a symmetric body under dissipative and random torques."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from symcheck.numeric.chunked import pointwise
from symcheck.numeric.domain import Array, exact, positive, require


@pointwise("(),(),(i,j),(i),(i)->()")
@dataclass(frozen=True, eq=False)
class RandomTorques:
    """System (1.1), x' + f(x) = -epsilon D x + sqrt(epsilon) (G_1 xi + G_2 eta), in Stratonovich's sense.

    Parameters
    ----------
    varepsilon
        Size of the torques; one positive number.
    k
        Ratio (A - C)/A of the moments of inertia A, A, C; one number, 0 < k < 1.
    d
        Coefficients of dissipation D, 1/s; shape (3, 3).
    g_1
        Intensities of the multiplicative noises, G_1 = diag(g_1j x_j), s^(-1/2); shape (3,), not negative.
    g_2
        Intensities of the additive noises, G_2 = diag(g_2j), rad s^(-3/2); shape (3,), not negative.

    Raises
    ------
    ValueError
        If a number, a shape or a sign is wrong. Whether a stationary law exists is a question of `amplitude` and
        `frequency`.

    Notes
    -----
    Here f(x) = (-k x_2 x_3, k x_3 x_1, 0), and x is the angular velocity in principal axes, the third the axis of
    symmetry. Source: (1.1).

    Examples
    --------
    >>> D = [[1, 0.3, 0.2], [0.2, 0.5, 0.1], [0.2, 0.1, 0.9]]
    >>> torques = RandomTorques(0.01, 0.6, D, g_1=[0.6, 0.8, 0.7], g_2=[1, 0, 1])
    >>> [float(value) for value in torques.amplitude]
    [1.0, 1.0, 1.224744871391589]
    """

    varepsilon: float
    k: float
    d: ArrayLike
    g_1: ArrayLike
    g_2: ArrayLike

    def __post_init__(self) -> None:
        positive("varepsilon", self.varepsilon, "1.1.6")
        k = positive("k", self.k, "1.1.1")
        require(k < 1, "k", k, "be less than 1, as k = 1 - C/A", "1.1.1")
        object.__setattr__(self, "d", _fixed("d", self.d, (3, 3)))
        for name in ("g_1", "g_2"):
            intensities = _fixed(name, getattr(self, name), (3,))
            require(intensities >= 0, name, intensities, "not be negative: it is an intensity", "1.1.2")
            object.__setattr__(self, name, intensities)

    @property
    def dissipation(self) -> Array:
        """D, shape (3, 3)."""
        return np.asarray(self.d)

    @property
    def intensities(self) -> Array:
        """g_1j and g_2j, shape (2, 3)."""
        return np.array([self.g_1, self.g_2])

    @property
    def amplitude(self) -> tuple[float, float, float]:
        """alpha, beta, gamma of (3.2), the parameters of the amplitude's stationary law."""
        alpha, beta = np.hypot(self.intensities[:, 0], self.intensities[:, 1])
        trace = float(self.dissipation[0, 0] + self.dissipation[1, 1])
        require(trace > 0, "d", trace, "have d_11 + d_22 > 0 for an amplitude that is stationary", "4.0.3")
        return float(alpha), float(beta), trace**0.5

    @property
    def frequency(self) -> tuple[float, float, float, float]:
        """k, g_13, g_23, d_33, the parameters of the frequency's stationary law."""
        multiplicative, additive = self.intensities[:, 2]
        return self.k, float(multiplicative), float(additive), float(self.dissipation[2, 2])


def _fixed(name: str, value: ArrayLike, shape: tuple[int, ...]) -> Array:
    """The value as an array of just this shape that nobody can change."""
    array = exact(name, value, shape).copy()
    array.flags.writeable = False
    return array
