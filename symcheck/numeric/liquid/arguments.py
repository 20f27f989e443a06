"""What the functions on a body with liquid take: a body with its modes, checked once, with what is proved of it."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symcheck.generated import esenkov2006
from symcheck.numeric.domain import Array, real, require


class Body(NamedTuple):
    """Checked parameters, broadcast; on the last axis the inertias and frequencies of the modes, minus the residues."""

    A: Array
    C: Array
    E_n: Array
    lambda_n: Array
    omega_0: Array
    R_n: Array

    @property
    def off_the_band(self) -> NDArray[np.bool_]:
        """Where no natural frequency lies between zero and the spin, so that the frequencies are real by N.13."""
        return np.asarray((self.R_n >= 0).all(-1))

    @property
    def not_long(self) -> NDArray[np.bool_]:
        """Where the frequencies are real by N.17, which rounding must not hide: there D >= 0 may be a difference."""
        return np.asarray(self.C >= self.A)


def checked_body(A: ArrayLike, C: ArrayLike, E_n: ArrayLike, lambda_n: ArrayLike, omega_0: ArrayLike) -> Body:
    """The parameters, with minus the residues R_n of (1.31), broadcast: (...), and (..., N) for the modes.

    ValueError where a number is not finite or not positive, the modes carry A or more, or shapes do not fit. Parameters
    as for `liquid.stability`.

    >>> checked_body(1.0, [0.5, 1.5], [0.2], [0.5], 1.0).R_n.tolist()
    [[-0.05], [-0.05]]
    """
    carried = real("E_n", E_n, (None,))
    require(carried.shape[-1] > 0, "E_n", carried, "have at least one mode", "1.31")
    natural = real("lambda_n", lambda_n, carried.shape[-1:])
    whole, axial, spin = real("A", A), real("C", C), real("omega_0", omega_0)
    for name, value in (("A", whole), ("C", axial), ("omega_0", spin), ("E_n", carried)):
        require(value > 0, name, value, "be positive", "1.31, N.17")
    shape = broadcast(A=whole, C=axial, E_n=carried[..., 0], lambda_n=natural[..., 0], omega_0=spin)
    total = carried.sum(-1)
    require(
        total < whole, "sum of E_n", total + 0 * whole, "be less than A, as the liquid is a part of the body", "N.13"
    )
    whole, axial, spin = (np.broadcast_to(value, shape) for value in (whole, axial, spin))
    carried, natural = (np.broadcast_to(value, shape + value.shape[-1:]) for value in (carried, natural))
    with np.errstate(all="ignore"):
        residue = np.asarray(esenkov2006.residue_of_a_mode(carried, natural, spin[..., None]))
    require_finite(residue)
    return Body(whole, axial, carried, natural, spin, residue)


def broadcast(**arrays: Array) -> tuple[int, ...]:
    """The shape to which arrays broadcast that have no axis of modes; ValueError names them and their shapes.

    >>> broadcast(A=np.ones((2, 1)), C=np.ones(3))
    (2, 3)
    """
    try:
        return np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise ValueError(f"the shapes {shapes}, without the axis of the modes, must broadcast to one") from None


def require_finite(values: Any) -> None:
    """ValueError where a result has left the range of doubles.

    >>> require_finite([1.0, 2.0])
    """
    require(
        np.isfinite(values), "a result", values, "be finite; choose units in which the arguments are of moderate size"
    )


def number(name: str, value: ArrayLike) -> float:
    """One finite number; ValueError for anything else.

    >>> number("A", 1)
    1.0
    """
    found = real(name, value)
    require(found.ndim == 0, name, found, "be one number; call once for each set of parameters")
    return float(found)


def row(name: str, value: ArrayLike) -> Array:
    """Finite numbers along one axis; ValueError for anything else.

    >>> row("E_n", [1, 2]).tolist()
    [1.0, 2.0]
    """
    values = real(name, value, (None,))
    require(values.ndim == 1, name, values, "have one axis; call once for each set of parameters")
    return values
