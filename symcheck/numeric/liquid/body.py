"""A body with the modes of its liquid, with what is proved of it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symcheck.generated import esenkov2006
from symcheck.numeric.domain import Array, common_shape, evaluated, positive, power_of_two, real, require, total


class Body(NamedTuple):
    """Checked parameters, broadcast; on the last axis the inertias and frequencies of the modes, minus the residues.

    They are in units in which A and the spin are nearly 1, so that products of them are doubles: `moment` and `rate`,
    powers of two, by which to multiply rounds nothing.
    """

    A: Array
    C: Array
    E_n: Array
    lambda_n: Array
    omega_0: Array
    R_n: Array
    moment: Array
    rate: Array

    @property
    def rest(self) -> Array:
        """A less the inertias of all modes, which may nearly cancel it."""
        return total(self.A, *np.moveaxis(-self.E_n, -1, 0))

    @property
    def off_the_band(self) -> NDArray[np.bool_]:
        """Where no natural frequency lies between zero and the spin, so that the frequencies are real by N.13."""
        return np.asarray((self.R_n >= 0).all(-1))

    @property
    def not_long(self) -> NDArray[np.bool_]:
        """Where the frequencies are real by N.17, which rounding must not hide: there D >= 0 may be a difference."""
        return np.asarray(self.C >= self.A)


def checked_body(A: ArrayLike, C: ArrayLike, E_n: ArrayLike, lambda_n: ArrayLike, omega_0: ArrayLike) -> Body:
    """The parameters of `stability`, broadcast: (...), and (..., N) for the modes; with -R_n of (1.31)."""
    source = "1.31, N.17"
    whole, axial, spin = positive("A", A, source), positive("C", C, source), positive("omega_0", omega_0, source)
    carried = positive("E_n", E_n, source, (None,))
    require(carried.shape[-1] > 0, "E_n", carried, "have at least one mode", "1.31")
    natural = real("lambda_n", lambda_n, carried.shape[-1:])
    shape = common_shape(A=whole, C=axial, E_n=carried[..., 0], lambda_n=natural[..., 0], omega_0=spin)
    rest = total(*np.broadcast_arrays(whole, *np.moveaxis(-carried, -1, 0)))
    together = carried.sum(-1)
    require(
        (rest > 0) & (together < whole),
        "sum of E_n",
        together,
        "be less than A, as the liquid is a part of the body",
        "N.13",
    )
    whole, axial, spin = (np.broadcast_to(value, shape) for value in (whole, axial, spin))
    carried, natural = (np.broadcast_to(value, shape + value.shape[-1:]) for value in (carried, natural))
    moment, rate = power_of_two(whole), power_of_two(spin)
    with np.errstate(over="ignore"):
        whole, axial, carried = whole / moment, axial / moment, carried / moment[..., None]
        spin, natural = spin / rate, natural / rate[..., None]
    residue = evaluated("a residue of a mode", esenkov2006.residue_of_a_mode, carried, natural, spin[..., None])
    return Body(whole, axial, carried, natural, spin, np.asarray(residue), moment, rate)
