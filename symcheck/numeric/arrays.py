"""Arrays as kernels take and give them: a component for each argument, and several arrays of one shape."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from math import prod
from typing import Any, cast

import numpy as np

from symcheck.numeric.domain import Array, is_numpy


def letters(array: Array, axes: int = 1) -> list[Array]:
    """The components along the last axes, first: a kernel takes a letter for each."""
    if not is_numpy(array):
        whole: Any = array
        return [whole[(..., *place)] for place in product(*map(range, array.shape[array.ndim - axes :]))]
    lead, last = array.shape[: array.ndim - axes], array.shape[array.ndim - axes :]
    flat = np.moveaxis(array.reshape(*lead, prod(last)), -1, 0)  # -1 for the product: not of an empty array
    return [flat[k] for k in range(len(flat))]


def stacked(components: Sequence[Array], *last: int) -> Array:
    """The components along a last axis, or along last axes of these lengths."""
    if all(map(is_numpy, components)):
        whole = np.stack(components, axis=-1)
        return whole.reshape(*whole.shape[:-1], *last) if last else whole
    from array_api_compat import array_namespace

    library: Any = array_namespace(*components)
    found = library.stack(library.broadcast_arrays(*components), axis=-1)
    return cast("Array", library.reshape(found, (*found.shape[:-1], *last)) if last else found)


def of_one_shape(*arrays: Array) -> list[Array]:
    """The arrays broadcast against each other, not copied: numbers where all are numbers.

    With arrays of another library they stay as they are, NumPy's numbers as numbers: that library broadcasts.
    """
    if not all(map(is_numpy, arrays)):
        return [cast("Array", x.item()) if is_numpy(x) and not x.ndim else x for x in arrays]
    shape = np.broadcast_shapes(*(array.shape for array in arrays))
    return [np.broadcast_to(array, shape)[()] for array in arrays]


def results(*arrays: Array) -> list[Array]:
    """As `of_one_shape`, each with memory of its own: what is written to one is in no other."""
    if not all(map(is_numpy, arrays)):
        return [*arrays]
    shape = np.broadcast_shapes(*(array.shape for array in arrays))
    kept: list[Array] = []
    for array in arrays:
        own = array.shape == shape and not any(array is other for other in kept)
        kept.append(array if own else np.broadcast_to(array, shape).copy())
    return kept


def eigensystem(matrix: Array) -> tuple[Array, Array]:
    """Eigenvalues of a symmetric matrix in ascending order, and right-handed orthonormal eigenvectors as rows."""
    values, columns = np.linalg.eigh(matrix)
    rows = columns.swapaxes(-1, -2).copy()
    rows[..., 2, :] = np.cross(rows[..., 0, :], rows[..., 1, :])
    return values, rows
