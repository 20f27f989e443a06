"""The step of the ensemble's scheme: which parts the system is split into, and what they need beforehand.

For a step h, with two noises of each axis put together as one (the law of the paths is the same: the squares of the
noises' fields, and so their generator, agree in Stratonovich's calculus):

    R(h/2) L(h/2) N(h) L(h/2) R(h/2),   each part solved exactly
    R  x' = -f(x): x_3 is constant, (x_1, x_2) turns by the angle k x_3 t
    L  x' = -epsilon D x: a constant matrix
    N  dx_j = sqrt(epsilon) sqrt(g_1j^2 x_j^2 + g_2j^2) o dw_j: with v = sqrt(epsilon) g_1j w_j
       x_j -> x_j cosh v + sqrt(x_j^2 + (g_2j/g_1j)^2) sinh v

Weak order 2: the parts are put together symmetrically, and the three noises of N commute. Without torques energy is
conserved, whatever the step. Decision: this instead of Heun's scheme of `stochastic`, which serves any equation and
given noises xi, eta: half as many normal numbers, no bias from the noise, one order more. It is not for given xi, eta.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.linalg import expm

from symcheck.numeric.domain import Array, positive, require
from symcheck.numeric.random_rotation.torques import RandomTorques

COARSEST = 0.04  # g_1j^2 epsilon h: up to here v/2 stays below 1 for ten standard deviations
NO_NOISE = 1e-100  # s^(-1/2): an intensity below this is as none, and may be divided by


class Scheme(NamedTuple):
    """What a step needs.

    half_angle  k h/2, s: R of a whole step turns by twice this times x_3
    relaxation  exp(-epsilon D h/2), shape (3, 3)
    noise       sqrt(epsilon h) g_1j, shape (3,): v is this times a normal number
    offset      (g_2j/g_1j)^2, rad^2/s^2, shape (3,)
    """

    half_angle: float
    relaxation: Array
    noise: Array
    offset: Array


def scheme(torques: RandomTorques, step: float) -> Scheme:
    """The scheme for steps of this length, in s.

    ValueError where the step is not positive, or the noise of a step is too strong: g_1j^2 epsilon step > 0.04.
    """
    step = float(positive("step", step, "(1.1)"))
    multiplicative, additive = np.maximum(torques.intensities[0], NO_NOISE), torques.intensities[1]
    small = torques.varepsilon * step
    require(
        small * multiplicative.max() ** 2 <= COARSEST, "step", step, f"keep g_1j^2 epsilon step <= {COARSEST}", "1.1.2"
    )
    return Scheme(
        torques.k * step / 2,
        expm(-small / 2 * torques.dissipation),
        np.sqrt(small) * multiplicative,
        (additive / multiplicative) ** 2,
    )
