"""The momentum envelope {h_1 e_1 + ... + h_n e_n, |h_i| <= 1} of reaction wheels with axes e_i: a zonotope, exactly.

A plane with the normal c touches it where every wheel is at the limit h_k = sign (c, e_k); wheels with (c, e_k) = 0
are free. Which sign vectors occur depends on the signs of the triple products (e_i, e_j, e_k) alone, the chirotope. So
the combinatorics holds wherever those signs do: at one point, or over a whole range of angles.

Wheels are numbered from 1. A sign vector has one entry for each wheel: 1, -1, or 0 where the wheel is free. Standard
library only; components may be of any kind of exact number.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cmp_to_key
from itertools import combinations, permutations
from typing import Any

from symcheck.core.verdicts import SymcheckError

__all__ = ["Chirotope", "Combinatorics", "Envelope", "chirotope", "combinatorics", "envelope"]

Signs = tuple[int, ...]
Number = Any  # a float, a fraction or an expression of SymPy: what can be added, multiplied and, by `sign`, compared
Vector = tuple[Number, Number, Number]
# one or two of these complete axes that lie in a plane
UNIT_VECTORS: tuple[Vector, ...] = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
EVEN = ((0, 1, 2), (1, 2, 0), (2, 0, 1))  # permutations of three: a triple product keeps its sign


def sign(number: Number) -> int:
    """-1, 0 or 1."""
    return int(bool(number > 0)) - int(bool(number < 0))


def dot(x: Vector, y: Vector) -> Number:
    """(x, y)."""
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]


def cross(x: Vector, y: Vector) -> Vector:
    """x times y."""
    return x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]


def scaled(factor: Number, x: Vector) -> Vector:
    """factor x."""
    return factor * x[0], factor * x[1], factor * x[2]


def added(*vectors: Vector) -> Vector:
    """The sum of vectors."""
    x, y, z = (sum(components) for components in zip(*vectors, strict=True))
    return x, y, z


def triple_product(x: Vector, y: Vector, z: Vector) -> Number:
    """(x, y, z) = (x times y, z)."""
    return dot(cross(x, y), z)


def opposite(signs: Signs) -> Signs:
    """The sign vector of the point reflected in the centre."""
    return tuple(-s for s in signs)


@dataclass(frozen=True)
class Chirotope:
    """The signs of the triple products (e_i, e_j, e_k) of axes that span space.

    Parameters
    ----------
    wheels
        How many axes, the first ones, are those of wheels. If these do not span space, others complete them, whose
        momentum is at its limit.
    size
        How many axes there are.
    signs
        The sign -1, 0 or 1 for every three different axes, in any order.
    """

    wheels: int
    size: int
    signs: Mapping[tuple[int, int, int], int]

    def __call__(self, i: int, j: int, k: int) -> int:
        return self.signs.get((i, j, k), 0)


def chirotope(axes: Sequence[Vector], sign: Callable[[Number], int] = sign) -> Chirotope:
    """Find the signs of all triple products of wheel axes, which need not span space.

    Parameters
    ----------
    axes
        Three exact components for each wheel.
    sign
        How the sign -1, 0 or 1 of a number is decided.

    Returns
    -------
    Chirotope
        The signs.

    Raises
    ------
    SymcheckError
        If no axis differs from zero.
    """
    for count in range(3):
        for added in combinations(UNIT_VECTORS, count):
            complete = (*axes, *added)
            signs = {
                (i + 1, j + 1, k + 1): sign(triple_product(complete[i], complete[j], complete[k]))
                for i, j, k in combinations(range(len(complete)), 3)
            }
            if any(signs.values()):
                return Chirotope(len(axes), len(complete), _antisymmetric(signs))
    raise SymcheckError("no wheel has an axis; give at least one axis that is not zero")


def _antisymmetric(signs: Mapping[tuple[int, int, int], int]) -> dict[tuple[int, int, int], int]:
    """The signs of increasing triples, for triples in any order."""
    return {
        (triple[p], triple[q], triple[r]): s if (p, q, r) in EVEN else -s
        for triple, s in signs.items()
        for p, q, r in permutations(range(3))
    }


@dataclass(frozen=True)
class Combinatorics:
    """Vertices, edges and faces of an envelope by their sign vectors.

    Axes in one plane give a polygon, which is one face; axes on one line a segment, without a face.

    Parameters
    ----------
    wheels
        The number of wheels.
    vertices
        For each vertex the directions of the outgoing edges: k for e_k, -k for -e_k (of parallel wheels the first).
    edges
        For each edge its two ends: the first has the free wheel (of parallel ones the first) at -1, the last at 1.
    faces
        For each face its vertices in a cycle, counterclockwise from outside.
    """

    wheels: int
    vertices: Mapping[Signs, tuple[int, ...]]
    edges: Mapping[Signs, tuple[Signs, Signs]]
    faces: Mapping[Signs, tuple[Signs, ...]]

    @property
    def counts(self) -> tuple[int, int, int]:
        """How many vertices, edges and faces there are."""
        return len(self.vertices), len(self.edges), len(self.faces)


def combinatorics(chi: Chirotope) -> Combinatorics:
    """Build the face lattice of an envelope.

    Parameters
    ----------
    chi
        The signs of the triple products of the axes.

    Returns
    -------
    Combinatorics
        Vertices, edges and faces.
    """
    found = {signs: _cycle(chi, plane, signs) for plane, signs in _planes(chi)}
    sides = {
        tuple(s if s == t else 0 for s, t in zip(one, other, strict=True)): sorted((one, other))
        for cycle in found.values()
        for one, other in zip(cycle, (*cycle[1:], cycle[0]), strict=True)
    }
    faces, edges = ({signs: tuple(each[signs]) for signs in sorted(each, reverse=True)} for each in (found, sides))
    if chi.size > chi.wheels:
        faces, edges = (_held(chi.wheels, each) for each in (faces, edges))
    directions: dict[Signs, list[int]] = {vertex: [] for ends in edges.values() for vertex in ends}
    for signs, (first, last) in edges.items():
        wheel = signs.index(0) + 1
        directions[first].append(wheel)
        directions[last].append(-wheel)
    vertices = {vertex: tuple(sorted(directions[vertex], key=abs)) for vertex in sorted(directions, reverse=True)}
    return Combinatorics(chi.wheels, vertices, {signs: (first, last) for signs, (first, last) in edges.items()}, faces)


def _held(wheels: int, faces: Mapping[Signs, tuple[Signs, ...]]) -> dict[Signs, tuple[Signs, ...]]:
    """What has the completing axes at 1."""
    return {
        signs[:wheels]: tuple(vertex[:wheels] for vertex in vertices)
        for signs, vertices in faces.items()
        if all(s == 1 for s in signs[wheels:])
    }


def _planes(chi: Chirotope) -> Iterator[tuple[tuple[int, ...], Signs]]:
    """Every plane of axes, twice: with the sign vector of each of its normals."""
    every = range(1, chi.size + 1)
    for i in every:
        if not any(chi(i, j, k) for j, k in combinations(every, 2)):
            raise SymcheckError(f"the axis of wheel {i} is zero; leave this wheel out")
    seen = set()
    for i, j in combinations(every, 2):
        signs = tuple(chi(i, j, k) for k in every)
        plane = tuple(k for k in every if signs[k - 1] == 0)
        if plane not in seen and any(signs):  # no sign at all: i and j are parallel
            seen.add(plane)
            yield plane, signs
            yield plane, opposite(signs)


def _cycle(chi: Chirotope, plane: Sequence[int], face: Signs) -> tuple[Signs, ...]:
    """The vertices of a face, counterclockwise from outside.

    The wheels of its plane are turned into the half turn from the first one on and sorted by angle; from the vertex
    with all of them at their lower limit each turned axis is an edge, then each once more backwards.
    """
    outside = next(k for k, s in enumerate(face, 1) if s)
    first = plane[0]

    def about(x: int, y: int) -> int:
        """The sign of (x, y, c) for the outward normal c."""
        return chi(x, y, outside) * face[outside - 1]

    def order(x: int, y: int) -> int:
        return -turned[x] * turned[y] * about(x, y)

    across = next(k for k in plane if about(first, k))
    turned = {k: about(first, k) or about(first, across) * about(k, across) for k in plane}
    steps: list[list[int]] = []
    for k in sorted(plane, key=cmp_to_key(order)):
        if steps and not about(steps[-1][0], k):
            steps[-1].append(k)  # parallel wheels make one edge
        else:
            steps.append([k])
    vertex = [-turned.get(k, -s) for k, s in enumerate(face, 1)]
    cycle = []
    for step in steps * 2:
        cycle.append(tuple(vertex))
        for k in step:
            vertex[k - 1] *= -1
    return tuple(cycle)


@dataclass(frozen=True)
class Envelope:
    """An envelope with its metric. Nothing here decides a sign: the chirotope has them all.

    Parameters
    ----------
    axes
        The axes of the wheels, three exact components each.
    chirotope
        The signs of their triple products.
    combinatorics
        Vertices, edges and faces.
    """

    axes: tuple[Vector, ...]
    chirotope: Chirotope
    combinatorics: Combinatorics

    def point(self, signs: Signs) -> Vector:
        """h_1 e_1 + ... + h_n e_n: a vertex, or the centre of an edge or face."""
        return added(*(scaled(h, axis) for h, axis in zip(signs, self.axes, strict=True)))

    def normal(self, face: Signs) -> Vector:
        """The outward normal of a face of a polyhedron: e_i times e_j or its opposite, not of unit length."""
        i, *others = (k for k, s in enumerate(face, 1) if s == 0)
        outside = next(k for k, s in enumerate(face, 1) if s)
        j = next(k for k in others if self.chirotope(i, k, outside))
        turn = self.chirotope(i, j, outside) * face[outside - 1]
        return scaled(turn, cross(self.axes[i - 1], self.axes[j - 1]))

    def support(self, face: Signs) -> Number:
        """(n, H) on a face with that normal n: the sum of |(e_i, e_j, e_k)| over k."""
        return dot(self.normal(face), self.point(face))

    def volume(self) -> Number:
        """8 times the sum of |(e_i, e_j, e_k)|: the envelope is a sum of parallelepipeds."""
        triples = combinations(range(1, len(self.axes) + 1), 3)
        return 8 * sum(
            self.chirotope(*t) * triple_product(*(self.axes[k - 1] for k in t))
            for t in triples  # zero in a plane
            if self.chirotope(*t)
        )


def envelope(axes: Iterable[Sequence[Number]], sign: Callable[[Number], int] = sign) -> Envelope:
    """Build the momentum envelope of wheels, exactly.

    Parameters
    ----------
    axes
        Three exact components for each wheel: int, Fraction, exact numbers of SymPy.
    sign
        How the sign -1, 0 or 1 of a number is decided.

    Returns
    -------
    Envelope
        The envelope for wheels with the limit 1.

    Raises
    ------
    SymcheckError
        If an axis does not have three components, or no axis differs from zero.

    See Also
    --------
    symcheck.numeric.wheels.envelope : The same for floating-point numbers and any limits.

    Examples
    --------
    >>> envelope([(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]).combinatorics.counts
    (14, 24, 12)
    """
    vectors = []
    for number, axis in enumerate(axes, 1):
        if len(axis) != 3:
            raise SymcheckError(f"the axis of wheel {number} has {len(axis)} components; give three")
        x, y, z = axis
        vectors.append((x, y, z))
    chi = chirotope(vectors, sign)
    return Envelope(tuple(vectors), chi, combinatorics(chi))
