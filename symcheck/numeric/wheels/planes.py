"""The faces of one momentum envelope, found by sorting the axes by their angle about each of them.

Seen along an axis u_i the envelope is a polygon, and its sides are the faces that have edges along u_i. They come in
the order of the angles of the other axes; those at one angle lie in one plane with u_i and share a face. Running sums
over that order give every face its distance, so that n axes take O(n^2 log n) operations and n^2 numbers.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from symcheck.numeric.domain import Array

BLOCK = 1 << 15  # numbers in an array of work: 256 kB stay in the cache
Index = NDArray[np.intp]
Turned = NDArray[np.bool_]
Number = TypeVar("Number", np.float64, np.uint64)


class Directions(NamedTuple):
    """Wheels with parallel axes added up; what is missing to three dimensions has the length 0 and comes last.

    units    (m, 3), no two parallel
    lengths  (m,), the sums of the limits
    rank     the dimension of the envelope: the axes with a length span so much
    """

    units: Array
    lengths: Array
    rank: int


class Planes(NamedTuple):
    """One of every two opposite faces, p of them, by the number of their sides.

    normals    (p, 3), outward
    distances  (p,), from the centre of the envelope
    owners     (p,), the first axis i in the face
    begins     (p,), the others are order[i, begin:end]
    ends       (p,)
    order      (m, m - 1), row k has the other axes by their angle about axis k
    turned     (m, m - 1), whether axis order[i, k] is turned to have its angle in the half turn from 0 on
    """

    normals: Array
    distances: Array
    owners: Index
    begins: Index
    ends: Index
    order: Index
    turned: Turned


def merged(axes: Array, limits: Array, tolerance: float) -> Directions:
    """The directions of wheels with axes (n, 3) and limits (n,); axes within `tolerance`, in rad, are parallel."""
    works = limits > 0
    axes, limits = axes[works], limits[works]
    first = _first_parallel(axes, tolerance)
    kept = np.flatnonzero(first == np.arange(len(axes)))
    units, lengths = axes[kept], np.bincount(first, limits, len(axes))[kept]
    rank, across = missing(units, tolerance)
    return Directions(np.vstack([units, across]), np.append(lengths, np.zeros(len(across))), rank)


def _first_parallel(axes: Array, tolerance: float) -> Index:
    """For each axis the first one that is parallel to it."""
    first = np.arange(len(axes))
    near = np.abs(axes @ axes.T) > 1 - max(tolerance, 1e-8)
    if np.count_nonzero(near) > len(axes):
        for i, j in np.argwhere(np.triu(near, 1)):
            if first[i] == i and first[j] == j and np.linalg.norm(np.cross(axes[i], axes[j])) <= tolerance:
                first[j] = i
    return first


def missing(units: Array, tolerance: float) -> tuple[int, Array]:
    """The dimension of the span, and unit vectors across it."""
    if not len(units):
        return 0, np.eye(3)
    _, values, rows = np.linalg.svd(np.linalg.qr(units, mode="r"))
    rank = int(np.count_nonzero(values > tolerance))
    return rank, rows[rank:]


def planes(directions: Directions, tolerance: float) -> Planes:
    """All faces; axes whose angles about a third differ by `tolerance` at most, in rad, lie in one plane with it."""
    faces = Planes(*(np.concatenate(column) for column in zip(*_belts(directions, tolerance), strict=True)))
    sizes = faces.ends - faces.begins
    if sizes.min() == sizes.max():
        return faces
    by_size = np.argsort(sizes, kind="stable")
    first = {name: getattr(faces, name)[by_size] for name in ("normals", "distances", "owners", "begins", "ends")}
    return faces._replace(**first)


def _belts(directions: Directions, tolerance: float) -> Iterator[tuple[NDArray[np.generic], ...]]:
    """The planes owned by some axes at a time, as the columns of `Planes`."""
    units, lengths, _ = directions
    count = len(units)
    step = max(1, BLOCK // count)
    for start in range(0, count, step):
        owners = np.arange(start, min(start + step, count))
        across, up = _frames(units[owners])
        x, y = across @ units.T, up @ units.T
        order, turned, angle = _sorted(x, y, owners, tolerance)
        x, y = (np.where(turned, -v, v) for v in (np.take_along_axis(c, order, axis=1) for c in (x, y)))
        row, begin, end, starts = _groups(angle, tolerance)
        mine = np.minimum.reduceat(order.ravel(), starts) > owners[row]
        towards = _sides(x, y, starts)[:, mine]
        row, begin, end = row[mine], begin[mine], end[mine]
        normals = towards[0][:, None] * up[row] - towards[1][:, None] * across[row]
        length = lengths[order]
        beyond_x, beyond_y = (beyond(running(length * c), row, begin, end) for c in (x, y))
        distances = towards[0] * beyond_y - towards[1] * beyond_x
        yield normals, distances, owners[row], begin, end, order, turned


def _frames(units: Array) -> tuple[Array, Array]:
    """Two unit vectors across each unit vector u, right-handed with it."""
    least = np.abs(units).argmin(axis=1)
    across = np.cross(np.eye(3)[least], units)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    return across, np.cross(units, across)


def _sorted(x: Array, y: Array, owners: Index, tolerance: float) -> tuple[Index, Turned, Array]:
    """The other axes by their angle from 0 to pi, and whether they are turned by pi to have such an angle."""
    angle = np.arctan2(y, x)
    turned = (angle > np.pi - tolerance) | (angle < -tolerance)
    angle -= np.copysign(np.pi, angle) * turned
    angle[np.arange(len(owners)), owners] = np.inf  # the owner comes last
    order = np.argsort(angle, axis=1)[:, :-1]
    return order, np.take_along_axis(turned, order, axis=1), np.take_along_axis(angle, order, axis=1)


def _groups(angle: Array, tolerance: float) -> tuple[Index, Index, Index, Index]:
    """Runs of equal angles: their rows, begins and ends, and their begins in the flat array."""
    new = np.ones(angle.shape, bool)
    np.greater(np.diff(angle, axis=1), tolerance, out=new[:, 1:])
    starts = np.flatnonzero(new)
    row, begin = np.divmod(starts, angle.shape[1])
    end = np.append(begin[1:], 0)
    end[end == 0] = angle.shape[1]
    return row, begin, end, starts


def _sides(x: Array, y: Array, starts: Index) -> Array:
    """Unit vectors (2, groups) towards each group: along the sum of its axes; those near the owner count least."""
    sums = np.stack([np.add.reduceat(c.ravel(), starts) for c in (x, y)])
    return np.asarray(sums / np.hypot(*sums))


def beyond(sums: NDArray[Number], row: Index, begin: Index, end: Index) -> NDArray[Number]:
    """The sum over the axes that come after the group, less that over those before it, from `running` sums."""
    return np.asarray(sums[row, -1] - sums[row, begin] - sums[row, end])


def running(values: NDArray[Number]) -> NDArray[Number]:
    """Sums of the first 0, 1, 2, ... values of each row."""
    sums = np.zeros((values.shape[0], values.shape[1] + 1, *values.shape[2:]), values.dtype)
    np.cumsum(values, axis=1, out=sums[:, 1:])
    return sums
