"""The momentum envelope of one set of wheels as a polytope: its vertices, edges, faces and half-spaces.

Faces of several pairs of axes are merged, parallel axes are added up, and what is flat is a polygon, a segment or a
point. That needs a tolerance; `half_spaces`, for many sets at once, does without.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from symcheck.numeric.domain import Array, require
from symcheck.numeric.wheels.faces import HalfSpaces
from symcheck.numeric.wheels.lattice import Lattice, lattice
from symcheck.numeric.wheels.planes import Directions, Index, Planes, merged, planes
from symcheck.numeric.wheels.sets import Wheels, wheels_of

TOLERANCE = 1e-11  # rad


@dataclass(frozen=True, eq=False)
class Envelope:
    """The momentum envelope of one set of n wheels: v vertices, e edges, f faces, p pairs of opposite half-spaces.

    Parameters
    ----------
    wheels
        One set of wheels: axes (n, 3), limits (n,), bias (n,).
    tolerance
        Angle, rad, below which axes are parallel, or a third lies in the plane of two as seen along one of them.

    Notes
    -----
    Vertices, edges and faces are found when they are first asked for.
    """

    wheels: Wheels
    tolerance: float

    @cached_property
    def _directions(self) -> Directions:
        return merged(self.wheels.axes, self.wheels.limits, self.tolerance)

    @cached_property
    def _planes(self) -> Planes:
        return planes(self._directions, self.tolerance)

    @property
    def dimension(self) -> int:
        """3 for a polyhedron, 2 for a polygon, 1 for a segment, 0 for a point."""
        return self._directions.rank

    @cached_property
    def half_spaces(self) -> HalfSpaces:
        """What bounds the envelope, normals (p, 3), distances (p,), centre (3,), for `margin` and the like.

        Those of a polyhedron are in the order of its faces; those across something flat have the distance 0.
        """
        return HalfSpaces(self._planes.normals, self._planes.distances, self.wheels.centre)

    @cached_property
    def _lattice(self) -> Lattice:
        return lattice(self._directions, self._planes)

    @cached_property
    def vertices(self) -> Array:
        """The vertices, shape (v, 3), in N m s; k and k + v/2 are opposite."""
        return np.asarray(self._lattice.vertices + self.wheels.centre)

    @property
    def edges(self) -> Index:
        """The edges as pairs of numbers of vertices, shape (e, 2)."""
        return self._lattice.edges

    @property
    def faces(self) -> tuple[Index, Index]:
        """(corners, begins): face k has the vertices corners[begins[k]:begins[k + 1]], counterclockwise from outside.

        begins has the shape (f + 1,); k and k + f/2 are opposite faces of a polyhedron. A polygon has one face.
        """
        return self._lattice.corners, self._lattice.begins

    @property
    def counts(self) -> tuple[int, int, int]:
        """How many vertices, edges and faces there are."""
        return len(self.vertices), len(self.edges), len(self.faces[1]) - 1

    def face(self, number: int) -> Array:
        """The vertices of a face, shape (sides, 3), counterclockwise from outside."""
        corners, begins = self.faces
        return np.asarray(self.vertices[corners[begins[number] : begins[number + 1]]])


def envelope(
    axes: ArrayLike, limits: ArrayLike = 1.0, bias: ArrayLike = 0.0, *, tolerance: float = TOLERANCE
) -> Envelope:
    """The envelope of the momenta h_1 e_1 + ... + h_n e_n, b_i - h_i,max <= h_i <= b_i + h_i,max.

    Parameters
    ----------
    axes
        Unit vectors e_i, any number of them in any position; shape (n, 3).
    limits
        Largest momenta h_i,max, N m s; a number or shape (n,). A wheel with 0 does not count.
    bias
        Momenta b_i about which the wheels work, N m s; a number or shape (n,).
    tolerance
        The angle in rad below which axes are parallel, or a third lies in the plane of two as seen along one of them;
        greater for axes that are given with few digits.

    Returns
    -------
    Envelope
        Its vertices, edges and faces are computed when first asked for, in O(n^2 log n) operations and n^2 numbers.

    Raises
    ------
    ValueError
        For anything but one set of wheels.
    ArithmeticError
        From vertices, edges and faces, if axes near the tolerance make faces that do not fit together.

    Notes
    -----
    Source: (2.1), (3.1).

    Examples
    --------
    >>> envelope(np.eye(3)).counts
    (8, 12, 6)
    >>> envelope([[1, 0, 0], [0, 1, 0], [0.6, 0.8, 0]]).dimension
    2
    """
    wheels = wheels_of(axes, limits, bias)
    require(wheels.limits.ndim == 1, "axes", wheels.axes.shape, "be one set of wheels; half_spaces takes many", "(2.1)")
    require(0 < tolerance < 1, "tolerance", tolerance, "lie between 0 and 1 rad")
    return Envelope(
        Wheels(*map(np.array, wheels)), tolerance
    )  # vertices are found later: what then is in the arguments
