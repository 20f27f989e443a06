"""Arrays as kernels take and give them: a component for each argument, and several arrays of one shape."""

from __future__ import annotations

import numpy as np

from symcheck.numeric.domain import Array


def letters(array: Array, axes: int = 1) -> list[Array]:
    """The components along the last axes, first: a kernel takes a letter for each."""
    flat = np.moveaxis(array.reshape(*array.shape[: array.ndim - axes], -1), -1, 0)
    return [flat[k] for k in range(len(flat))]


def of_one_shape(*arrays: Array) -> list[Array]:
    """The arrays broadcast against each other, not copied: numbers where all are numbers."""
    shape = np.broadcast_shapes(*(array.shape for array in arrays))
    return [np.broadcast_to(array, shape)[()] for array in arrays]


def eigensystem(matrix: Array) -> tuple[Array, Array]:
    """Eigenvalues of a symmetric matrix in ascending order, and right-handed orthonormal eigenvectors as rows."""
    values, columns = np.linalg.eigh(matrix)
    rows = columns.swapaxes(-1, -2).copy()
    rows[..., 2, :] = np.cross(rows[..., 0, :], rows[..., 1, :])
    return values, rows
