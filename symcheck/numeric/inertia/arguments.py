"""What the functions on inertia and damping accept, and how arrays pass through kernels of single letters."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from symcheck.numeric.domain import Array, real, require

TOLERANCE = 1e-9  # relative: a matrix that was written with ten digits still passes
LARGEST = 1e100  # a moment: the product of three is a double


def principal_moments(moments: ArrayLike) -> Array:
    """The principal moments of inertia as an array, shape (..., 3), kg m^2.

    ValueError if one of them is not positive, as all formulas with them assume, or so far from 1 that a product of
    three is no double.

    >>> principal_moments([2, 3, 4]).tolist()
    [2.0, 3.0, 4.0]
    """
    array = real("moments", moments, (3,))
    require(array > 0, "moments", array, "be positive", "mirer2009:2.0.6")
    within = (array > 1 / LARGEST) & (array < LARGEST)
    require(
        within, "moments", array, f"lie between {1 / LARGEST:g} and {LARGEST:g}; take another unit", "mirer2009:2.1"
    )
    return array


def orthonormal_axes(axes: ArrayLike) -> Array:
    """Three axes as an array, shape (..., 3, 3): row i is axis i in principal axes.

    ValueError if the rows are not orthonormal.

    >>> orthonormal_axes([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]).shape
    (3, 3)
    """
    array = real("axes", axes, (3, 3))
    products = array @ array.swapaxes(-1, -2)
    holds = (np.abs(products - np.eye(3)) <= TOLERANCE).all(axis=(-1, -2))
    require(holds, "axes", array, "have orthonormal rows", "mirer2009:2.7")
    return array


def unit_axes(axes: ArrayLike) -> Array:
    """Three axes of devices as an array, shape (..., 3, 3): row i is axis i in principal axes, not all orthogonal.

    ValueError if a row is not a unit vector.

    >>> unit_axes([[1, 0, 0], [0.6, 0.8, 0], [0, 0, 1]]).shape
    (3, 3)
    """
    array = real("axes", axes, (3, 3))
    holds = np.abs((array**2).sum(axis=-1) - 1) <= TOLERANCE
    require(holds, "axes", array, "be a unit vector", "mirer2009:1.0.2")
    return array


def symmetric_matrix(name: str, matrix: ArrayLike, source: str = "") -> Array:
    """A symmetric matrix as an array, shape (..., 3, 3), with the roundings of its two halves averaged.

    ValueError if it is not symmetric.

    >>> symmetric_matrix("tensor", [[2, 1, 0], [1, 3, 0], [0, 0, 4]]).shape
    (3, 3)
    """
    array = real(name, matrix, (3, 3))
    mirrored = array.swapaxes(-1, -2)
    largest = np.abs(array).max(axis=(-1, -2), keepdims=True)
    holds = (np.abs(array - mirrored) <= TOLERANCE * largest).all(axis=(-1, -2))
    require(holds, name, array, "be symmetric", source)
    mean: Array = (array + mirrored) / 2
    return mean


def letters(array: Array, axes: int = 1) -> list[Array]:
    """The components along the last axes, first: a kernel takes each as an argument of its own.

    >>> [letter.shape for letter in letters(np.ones((5, 3, 3)), axes=2)]
    [(5,), (5,), (5,), (5,), (5,), (5,), (5,), (5,), (5,)]
    """
    flat = np.moveaxis(array.reshape(*array.shape[: array.ndim - axes], -1), -1, 0)
    return [flat[k] for k in range(len(flat))]


def side_by_side(outputs: Sequence[Array]) -> Array:
    """The outputs of a kernel along a new last axis.

    >>> side_by_side([np.zeros(5), np.ones(5)]).shape
    (5, 2)
    """
    return np.stack(outputs, axis=-1)


def of_one_shape(*arrays: Array) -> list[Array]:
    """The arrays broadcast against each other, not copied: numbers where all are numbers.

    >>> [array.shape for array in of_one_shape(np.zeros((2, 1)), np.ones(3))]
    [(2, 3), (2, 3)]
    """
    shape = np.broadcast_shapes(*(array.shape for array in arrays))
    return [np.broadcast_to(array, shape)[()] for array in arrays]


def eigensystem(matrix: Array) -> tuple[Array, Array]:
    """Eigenvalues of a symmetric matrix in ascending order, and right-handed orthonormal eigenvectors as rows.

    >>> values, rows = eigensystem(np.diag([3.0, 1.0, 2.0]))
    >>> values.tolist(), round(float(np.linalg.det(rows)), 12)
    ([1.0, 2.0, 3.0], 1.0)
    """
    values, columns = np.linalg.eigh(matrix)
    rows = columns.swapaxes(-1, -2).copy()
    rows[..., 2, :] = np.cross(rows[..., 0, :], rows[..., 1, :])
    return values, rows
