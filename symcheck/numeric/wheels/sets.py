"""Sets of reaction wheels: their axes, limits and biases, any number of sets at once, and the paper's two arrays."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from symcheck.generated import ignatov2005
from symcheck.kernels.specification import specification
from symcheck.numeric.chunked import gufunc
from symcheck.numeric.chunked.kernels import by_blocks
from symcheck.numeric.domain import (
    Array,
    acute,
    common_shape,
    evaluated,
    moderate,
    momentum,
    not_negative,
    one_of,
    require,
    unit_axes,
)

SOURCE = "(2.1)"
LEAST = -10_000  # a power of two below those of all products of three doubles
VERTICES: dict[int, Callable[..., tuple[float, ...]]] = {
    3: ignatov2005.vertices_of_three_wheels,
    4: ignatov2005.vertices_of_four_wheels,
    5: ignatov2005.vertices_of_five_wheels,
    6: ignatov2005.vertices_of_six_wheels,
}


class Wheels(NamedTuple):
    """Wheels with momenta b_i - h_i <= h <= b_i + h_i along unit axes e_i; n of them in each set.

    Parameters
    ----------
    axes
        Unit vectors e_i in the body's principal axes; shape (..., n, 3).
    limits
        Largest absolute values h_i of the momenta, N m s; shape (..., n). A wheel that has failed has 0.
    bias
        Momenta b_i about which they lie, N m s; shape (..., n).
    """

    axes: Array
    limits: Array
    bias: Array

    @property
    def centre(self) -> Array:
        """The centre of the envelope, the sum of b_i e_i, shape (..., 3)."""
        if not self.bias.any():
            return np.zeros((*self.bias.shape[:-1], 3))
        return np.asarray(np.matmul(self.bias[..., None, :], self.axes)[..., 0, :])


def wheels_of(axes: ArrayLike, limits: ArrayLike = 1.0, bias: ArrayLike = 0.0) -> Wheels:
    """The wheels with these axes, limits and biases, checked and broadcast against each other.

    Parameters
    ----------
    axes
        Unit vectors e_i; shape (..., n, 3).
    limits
        Largest momenta h_i >= 0, N m s; a number or shape (..., n).
    bias
        Momenta b_i about which the wheels work, N m s; a number or shape (..., n).

    Returns
    -------
    Wheels
        The wheels, with arrays of one leading shape.

    Raises
    ------
    ValueError
        If an axis is not of unit length, a limit is negative or the shapes do not fit.

    Notes
    -----
    Source: (2.1), there with equal limits and without bias.

    Examples
    --------
    >>> wheels_of([[1, 0, 0], [0, 1, 0]], 2.0).limits
    array([2., 2.])
    """
    return wheels_along(unit_axes(axes, SOURCE), limits, bias)


def wheels_along(axes: Array, limits: ArrayLike = 1.0, bias: ArrayLike = 0.0) -> Wheels:
    """As `wheels_of`, of axes (..., n, 3) whose lengths the caller looks at."""
    count = axes.shape[-2]
    require(count > 0, "axes", axes.shape, "have one wheel at least")
    limits, bias = _of_wheels(_limits, limits, count), _of_wheels(_bias, bias, count)
    if not axes.shape[:-1] == limits.shape == bias.shape:  # most calls need no broadcasting, which takes longer
        shared = limits.ndim < 2 and bias.ndim < 2
        shape = axes.shape[:-1] if shared else common_shape(axes=axes[..., 0], limits=limits, bias=bias)
        axes, limits, bias = (_spread(axes, (*shape, 3)), _spread(limits, shape), _spread(bias, shape))
    return Wheels(axes, limits, bias)


def _spread(array: Array, shape: tuple[int, ...]) -> Array:
    return array if array.shape == shape else np.broadcast_to(array, shape)


def _of_wheels(checked: Callable[[ArrayLike, int], Array], value: ArrayLike, count: int) -> Array:
    return _of_all(checked, value, count) if isinstance(value, int | float) else checked(value, count)


@lru_cache(typed=True)
def _of_all(checked: Callable[[ArrayLike, int], Array], value: float, count: int) -> Array:
    """A number that all wheels share, checked once for many calls."""
    array = np.full(count, checked(value, count))
    array.flags.writeable = False
    return array


def _limits(value: ArrayLike, count: int) -> Array:
    limits = not_negative("limits", value, "(2.1); a limit of 0 stands for a failed wheel")
    return _per_wheel("limits", moderate("limits", limits), count)


def _bias(value: ArrayLike, count: int) -> Array:
    return _per_wheel("bias", momentum("bias", value), count)


def _per_wheel(name: str, array: Array, count: int) -> Array:
    if array.ndim and array.shape[-1] != count:
        raise ValueError(f"{name} has shape {array.shape}; its last axis must have the {count} wheels of axes")
    return array


@gufunc("(),()->(wheel,axis)", wheel=4, axis=3)
def four_wheels(a: ArrayLike, b: ArrayLike) -> Array:
    """The axes of wheels along the side edges of a four-sided pyramid, from the kernel `axes_of_four_wheels`.

    Parameters
    ----------
    a
        Angle between the axis of a wheel and OZ, rad; shape (...), 0 < a < pi/2.
    b
        Angle of the side edges in the plane OXY, rad; shape (...), 0 < b < pi/2.

    Returns
    -------
    ndarray
        Axes of the wheels; shape (..., 4, 3).

    Raises
    ------
    ValueError
        If an angle is outside its range.

    Notes
    -----
    Source: the unit vectors before (2.1).

    Examples
    --------
    >>> four_wheels(np.arctan(np.sqrt(2)), np.pi / 4)[3].round(6)
    array([0.57735, 0.57735, 0.57735])
    """
    return _rows(by_blocks("ignatov2005", "axes_of_four_wheels", a=acute("a", a), b=acute("b", b)))


@gufunc("()->(wheel,axis)", wheel=6, axis=3)
def six_wheels(a: ArrayLike) -> Array:
    """The axes of wheels along the side edges of a regular six-sided pyramid, from the kernel `axes_of_six_wheels`.

    Parameters
    ----------
    a
        Angle between the axis of a wheel and OZ, rad; shape (...), 0 < a < pi/2.

    Returns
    -------
    ndarray
        Axes of the wheels; shape (..., 6, 3).

    Raises
    ------
    ValueError
        If the angle is outside its range.

    Notes
    -----
    Source: the unit vectors before (3.1).

    Examples
    --------
    >>> six_wheels(np.pi / 6)[1].round(6)
    array([ 0.433013, -0.25    ,  0.866025])
    """
    parts = by_blocks("ignatov2005", "axes_of_six_wheels", a=acute("a", a))
    zero = np.zeros_like(parts[0])  # e_1x and e_4x, which the kernel leaves out
    return _rows((zero, *parts[:8], zero, *parts[8:]))


def _rows(components: tuple[Array, ...]) -> Array:
    columns = np.stack(components, axis=-1)
    return columns.reshape(*columns.shape[:-1], len(components) // 3, 3)


@gufunc("(n,axis),(n)->(axis)")
def total_momentum(axes: ArrayLike, momenta: ArrayLike) -> Array:
    """The momentum of all wheels together, H = h_1 e_1 + ... + h_n e_n.

    Parameters
    ----------
    axes
        Unit vectors e_i; shape (..., n, 3).
    momenta
        Momenta h_i, N m s; shape (..., n).

    Returns
    -------
    ndarray
        Momentum H, N m s; shape (..., 3).

    Raises
    ------
    ValueError
        If an axis is not of unit length or the shapes do not fit.

    Notes
    -----
    Source: (2.1).

    Examples
    --------
    >>> total_momentum([[1, 0, 0], [0, 0.6, 0.8]], [2, 5])
    array([2., 3., 4.])
    """
    return wheels_of(axes, bias=momentum("momenta", momenta)).centre


@gufunc("(n,axis),(n)->()")
def volume(axes: ArrayLike, limits: ArrayLike = 1.0) -> Array:
    """The volume of the momentum envelope, 8 times the sum of h_i h_j h_k |(e_i, e_j, e_k)| over i < j < k.

    Parameters
    ----------
    axes, limits
        As for `wheels_of`.

    Returns
    -------
    ndarray
        Volume, (N m s)^3; shape (...). It is 0 for axes in a plane.

    Raises
    ------
    ValueError
        As `wheels_of` does.

    Notes
    -----
    Source: the lists of section 2.1; the paper's configurations have the kernels `volume_of_four_wheels` and others.

    Examples
    --------
    >>> float(volume(np.eye(3), 2.0))
    64.0
    """
    wheels = wheels_of(axes, limits)
    axes, limits = np.moveaxis(wheels.axes, -2, 0), np.moveaxis(wheels.limits, -1, 0)
    sizes, powers = np.frexp(limits)  # products of three leave the doubles, whatever the unit of them all is
    total, unit = np.zeros(limits.shape[1:]), np.full(limits.shape[1:], LEAST)
    for second in range(1, len(axes) - 1):
        for first in range(second):
            normal = np.cross(axes[first], axes[second]) * (sizes[first] * sizes[second])[..., None]
            parts = np.abs(np.einsum("...k,i...k->i...", normal, axes[second + 1 :])) * sizes[second + 1 :]
            whole = powers[first] + powers[second] + powers[second + 1 :]
            greatest = np.maximum(unit, np.where(parts > 0, whole, LEAST).max(axis=0))
            total = np.ldexp(total, unit - greatest) + np.ldexp(parts, whole - greatest).sum(axis=0)
            unit = greatest
    result = evaluated("volume", lambda x: np.ldexp(8 * x, unit), total)
    require((result > 0) | (total == 0), "volume", result, "be a positive double; take limits in another unit")
    return result


def listed_vertices(number: int, *angles: float) -> dict[str, Array]:
    """The vertices that the paper lists, by their names "V_1", "V_1'", ..., from the kernels `vertices_of_..._wheels`.

    Parameters
    ----------
    number
        How many wheels work: 4 of the four-sided pyramid, 3 of it without wheel 4; 6 of the six-sided one, 5 of it
        without wheel 6.
    *angles
        The angles a and b of the four-sided pyramid, a of the six-sided one, in rad.

    Returns
    -------
    dict
        The vertices, shape (3,), for limits of 1 N m s, by the names that the kernel declares.

    Raises
    ------
    ValueError
        For another number, or angles that do not fit.

    Notes
    -----
    Source: the lists of sections 2.1, 2.2, 3.1, 3.2.

    Examples
    --------
    >>> listed_vertices(4, 1.0, 0.5)["V_1"].round(6)
    array([1.613691, 0.      , 0.      ])
    """
    one_of("number", number, VERTICES)
    count = 2 if number < 5 else 1
    require(len(angles) == count, "angles", angles, f"be {count} for {number} wheels")
    kernel = VERTICES[number]
    values = kernel(*(float(acute("ab"[k], angle)) for k, angle in enumerate(angles)))
    vertices: dict[str, Array] = {}
    for component, value in zip([output.name for output in specification(kernel).outputs], values, strict=True):
        vertices.setdefault(component[:-1], np.zeros(3))["xyz".index(component[-1])] = value
    return vertices | {f"{name}'": -place for name, place in vertices.items()}
