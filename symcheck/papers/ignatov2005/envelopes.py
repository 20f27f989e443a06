"""The envelopes of both arrays of Ignatov 2005, with wheels failed or not, as LaTeX for what is stated of them.

All components of the axes are whole numbers times positive units that the angles give. So triple products have the
signs of whole numbers (B.1 and B.23 prove them of the axes themselves), and the envelope is one polyhedron, stretched.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import combinations

from symcheck.mechanics.zonotope import triple_product
from symcheck.papers.ignatov2005 import derivation

Axis = tuple[int, int, int]
FOUR, SIX = derivation.FOUR, derivation.SIX


def without(axes: Sequence[Axis], failed: int) -> list[int]:
    """The numbers of the wheels that are left when one has failed; 0: none has."""
    return [k for k in range(1, len(axes) + 1) if k != failed]


def triple(i: int, j: int, k: int) -> str:
    """(e_i, e_j, e_k) as LaTeX."""
    return rf"(\mathbf{{e}}_{i} \times \mathbf{{e}}_{j}, \mathbf{{e}}_{k})"


def triples(axes: Sequence[Axis], failed: int = 0) -> list[tuple[str, int]]:
    """The triple products of the axes that are left, with their values in units."""
    return [
        (triple(i, j, k), triple_product(axes[i - 1], axes[j - 1], axes[k - 1]))
        for i, j, k in combinations(without(axes, failed), 3)
    ]


def volume(axes: Sequence[Axis], failed: int = 0) -> str:
    """The volume of an envelope: 8 times the sum of the magnitudes of the triple products."""
    return f"8({_sum(triples(axes, failed))})"


def _sum(signed: Iterable[tuple[str, int]]) -> str:
    """The sum of the magnitudes of named things of these signs."""
    return " ".join(f"{'+' if sign > 0 else '-'} {name}" for name, sign in signed).removeprefix("+ ")


def ratios(axes: Sequence[Axis], failed: int) -> Iterator[tuple[str, str, Fraction]]:
    """For each two wheels that are left: (n, H) on their faces after and before the failure, and the ratio.

    With the normal n = e_i x e_j, (n, H) is the sum of the magnitudes of the triple products with i and j.
    """
    for i, j in combinations(without(axes, failed), 2):
        values = {k: triple_product(axes[i - 1], axes[j - 1], axes[k - 1]) for k in range(1, len(axes) + 1)}
        whole, left = ({k: v for k, v in values.items() if v and k != gone} for gone in (0, failed))
        ratio = Fraction(sum(map(abs, left.values())), sum(map(abs, whole.values())))
        before, after = (_sum((triple(i, j, k), v) for k, v in each.items()) for each in (whole, left))
        yield after, before, ratio
