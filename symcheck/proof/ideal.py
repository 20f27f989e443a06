"""The ideal of a set of equalities: membership, with cofactors back to the equalities themselves.

Equalities that share no variable are treated apart, and the Groebner basis of each such group is computed once per
process: the basis of the orthogonal 3 x 3 matrices (27 elements) serves all statements about them.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import flint

from symcheck.proof.groebner import Basis, components
from symcheck.proof.polynomial import Poly, Ring

Ref = list[Any]
Fact = tuple[Ref, Poly]
Text = tuple[tuple[tuple[int, ...], tuple[int, int]], ...]


def _text(poly: Poly, support: list[int]) -> Text:
    return tuple((tuple(e[k] for k in support), (int(c.p), int(c.q))) for e, c in poly.terms())


@lru_cache(maxsize=256)
def _basis(names: tuple[str, ...], polys: tuple[Text, ...], pairs: int) -> Basis:
    context = flint.fmpq_mpoly_ctx.get(list(names), flint.Ordering.degrevlex)
    return Basis([context.from_dict({e: flint.fmpq(*c) for e, c in poly}) for poly in polys], pairs)


class Ideal:
    """All combinations of the given facts. `complete` is False if a basis was cut off at the limit of S-pairs."""

    def __init__(self, ring: Ring, facts: Sequence[Fact], pairs: int = 2000) -> None:
        self.ring = ring
        self.facts = [fact for fact in facts if fact[1] != 0]
        self.complete = True
        self._elements: list[tuple[Poly, Basis, int, list[int]]] = []
        for members in components([poly for _, poly in self.facts]):
            self._add_component(members, pairs)

    def _add_component(self, members: list[int], pairs: int) -> None:
        polys = [self.facts[m][1] for m in members]
        support = sorted({k for poly in polys for k, degree in enumerate(poly.degrees()) if degree})
        names = tuple(self.ring.names[k] for k in support)
        basis = _basis(names, tuple(_text(poly, support) for poly in polys), pairs)
        self.complete = self.complete and basis.complete
        for index in basis.active:
            self._elements.append((self.ring.move(basis.nodes[index].poly), basis, index, members))

    def polys(self) -> list[Poly]:
        """The reduced Groebner basis."""
        return [element[0] for element in self._elements]

    def reduce(self, poly: Poly) -> Poly:
        """The normal form: zero only for members of the ideal."""
        return self._divide(poly)[0]

    def _divide(self, poly: Poly) -> tuple[Poly, dict[int, Poly]]:
        quotients: dict[int, Poly] = {}
        changed = True
        while changed and poly != 0:
            changed = False
            for k, element in enumerate(self._elements):
                quotient, rest = divmod(poly, element[0])
                if quotient != 0:
                    quotients[k] = quotients[k] + quotient if k in quotients else quotient
                    poly, changed = rest, True
        return poly, quotients

    def cofactors(self, poly: Poly) -> list[Fact] | None:
        """[(reference, q), ...] with poly = sum q * fact, or None if poly is not in the ideal."""
        rest, quotients = self._divide(poly)
        if rest != 0:
            return None
        total: dict[int, Poly] = {}
        for k, quotient in quotients.items():
            _, basis, index, members = self._elements[k]
            one = basis.nodes[index].poly * 0 + 1
            for place, cofactor in basis.express([(one, index)]).items():
                product = self.ring.move(cofactor) * quotient
                where = members[place]
                total[where] = total[where] + product if where in total else product
        return [(self.facts[where][0], q) for where, q in sorted(total.items()) if q != 0]
