"""Vertices, edges and faces of one momentum envelope, with what meets what.

A vertex is known by the sum of random 64-bit labels of its wheels, each with the sign of the wheel's momentum: equal
sums, equal vertices. Of two different ones the sums are equal with a probability of 2^-64. Every edge is checked to be
in two faces, and Euler's formula to hold.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from symcheck.numeric.domain import Array
from symcheck.numeric.wheels.planes import Directions, Index, Number, Planes, beyond, running

Keys = NDArray[np.uint64]
EULER = (1, 1, 1, 2)  # vertices - edges + faces of a point, a segment, a polygon, a polyhedron


class Lattice(NamedTuple):
    """Vertices, edges and faces of an envelope about 0; v vertices, e edges, f faces.

    vertices  (v, 3); k and k + v/2 are opposite
    edges     (e, 2), numbers of vertices
    corners   numbers of the vertices of all faces, one face after the other, counterclockwise from outside
    begins    (f + 1,), face k has corners[begins[k]:begins[k + 1]]; k and k + f/2 are opposite
    """

    vertices: Array
    edges: Index
    corners: Index
    begins: Index


def lattice(directions: Directions, planes: Planes) -> Lattice:
    """The lattice of the faces in `planes`, these first and in their order, which is by the number of their sides.

    ArithmeticError if they do not fit together.
    """
    whole = _flat(directions) if directions.rank < 2 else _solid(directions, planes)
    _fit(len(whole.vertices) - len(whole.edges) + len(whole.begins) - 1 == EULER[directions.rank])
    return whole


def _fit(together: bool) -> None:
    if not together:
        reason = "some axes are neither in one plane nor out of it; give another tolerance"
        raise ArithmeticError(f"the faces of the envelope do not fit together: {reason}")


def _flat(directions: Directions) -> Lattice:
    """A point or a segment."""
    ends = np.array([[1], [-1]]) * directions.units[0] * directions.lengths[0] if directions.rank else np.zeros((1, 3))
    edges = np.arange(2)[None] if directions.rank else np.empty((0, 2), np.intp)
    return Lattice(ends, edges, np.empty(0, np.intp), np.zeros(1, np.intp))


def _solid(directions: Directions, planes: Planes) -> Lattice:
    """A polyhedron, or a polygon: the one face without the axis that was added across it."""
    units, lengths, rank = directions
    first = planes.order[planes.owners, planes.begins]
    faces = np.flatnonzero((first < len(units) - 1) | (rank == 3))
    owners, begins, ends = planes.owners[faces], planes.begins[faces], planes.ends[faces]
    edges, label = units * lengths[:, None], np.where(lengths > 0, _labels(len(units)), np.uint64(0))
    sums = running(np.where(planes.turned[..., None], -1.0, 1.0) * edges[planes.order])
    marks = running(_signed(planes.turned, label[planes.order]))
    centres, keys = beyond(sums, owners, begins, ends), beyond(marks, owners, begins, ends)
    sizes = ends - begins
    places, names, sides = [], [], []
    for size in np.unique(sizes):
        chosen = np.flatnonzero(sizes == size)
        owner = owners[chosen]
        other = begins[chosen, None] + np.arange(size)
        axes, turned = _in_the_plane(
            units, planes.order[owner[:, None], other], planes.turned[owner[:, None], other], owner
        )
        places.append(_around(centres[chosen], np.where(turned, -1.0, 1.0)[..., None] * edges[axes]).reshape(-1, 3))
        names.append(_around(keys[chosen], _signed(turned, label[axes])).ravel())
        sides.append((len(chosen), 2 * (int(size) + 1)))
    vertices, corners = _distinct_vertices(np.concatenate(places), np.concatenate(names))
    return _assembled(vertices, corners, sides, rank)


@lru_cache
def _labels(count: int) -> Keys:
    return np.random.default_rng(2005).integers(2**64, size=count, dtype=np.uint64)


def _signed(turned: NDArray[np.bool_], label: Keys) -> Keys:
    return np.where(turned, np.negative(label), label)


def _in_the_plane(
    units: Array, axes: Index, turned: NDArray[np.bool_], owner: Index
) -> tuple[Index, NDArray[np.bool_]]:
    """The axes of each face by their angle about its normal, the owner first."""
    if axes.shape[1] > 1:
        signed = np.where(turned, -1.0, 1.0)[..., None] * units[axes]
        along = np.einsum("mgk,mk->mg", signed, units[owner])
        across = np.linalg.norm(np.cross(signed, units[owner][:, None]), axis=2)
        order = np.argsort(np.arctan2(across, along), axis=1)
        axes, turned = np.take_along_axis(axes, order, axis=1), np.take_along_axis(turned, order, axis=1)
    return np.column_stack([owner, axes]), np.column_stack([np.zeros(len(owner), bool), turned])


def _around(middle: NDArray[Number], steps: NDArray[Number]) -> NDArray[Number]:
    """The corners of faces: along every step once, in turn, and back along every step."""
    path = np.concatenate([steps, np.negative(steps)], axis=1)
    before = np.cumsum(path, axis=1, dtype=path.dtype) - path
    return np.asarray((middle - steps.sum(axis=1, dtype=steps.dtype))[:, None] + before + before)


def _distinct_vertices(places: Array, names: Keys) -> tuple[Array, Index]:
    """The vertices, the opposite ones of the first half in the second, and their number at each corner."""
    signed = names.view(np.int64)
    opposite = signed < 0
    _, first, which = np.unique(np.abs(signed), return_index=True, return_inverse=True)
    half = np.where(opposite[first, None], -1, 1) * places[first]
    return np.concatenate([half, -half]), which.reshape(-1) + len(half) * opposite


def _assembled(vertices: Array, corners: Index, sides: list[tuple[int, int]], rank: int) -> Lattice:
    """Add the opposite faces of a polyhedron, and the edges; `sides` are numbers of faces and of their sides."""
    count = len(vertices)
    blocks = np.split(corners, np.cumsum([m * s for m, s in sides])[:-1])
    cycles = [block.reshape(shape) for block, shape in zip(blocks, sides, strict=True)]
    if rank == 3:
        cycles += [(cycle[:, ::-1] + count // 2) % count for cycle in cycles]
    numbers = np.concatenate([np.full(len(c), c.shape[1]) for c in cycles])
    begins = np.append(0, np.cumsum(numbers))
    return Lattice(vertices, _edges(cycles, count, rank), np.concatenate([c.ravel() for c in cycles]), begins)


def _edges(cycles: list[Index], count: int, rank: int) -> Index:
    """The edges; of a polyhedron each is passed once there and once back, by the two faces that meet in it."""
    pairs = np.concatenate([np.stack([c, np.roll(c, -1, axis=1)], axis=-1).reshape(-1, 2) for c in cycles])
    if rank < 3:
        return np.sort(pairs, axis=1)
    rising = pairs[:, 0] < pairs[:, 1]
    there, back = np.sort(pairs[rising] @ [count, 1]), np.sort(pairs[~rising] @ [1, count])
    _fit(np.array_equal(there, back) and bool((np.diff(there) > 0).all()))
    return np.column_stack(np.divmod(there, count))
