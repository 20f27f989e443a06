"""The ideal of a set of equalities: membership, with cofactors back to the equalities themselves.

Equalities that share no variable are treated apart, and the Groebner basis of each such group is computed once per
process: the basis of the orthogonal 3 x 3 matrices (27 elements) serves all statements about them. An ideal grows by
`extended`, which starts from the basis there is.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache, partial

from symcheck.proof.algebra import flint
from symcheck.proof.algebra.facts import Fact, by_construction
from symcheck.proof.algebra.flint import Poly
from symcheck.proof.algebra.groebner import PAIRS, Basis, components
from symcheck.proof.algebra.polynomial import MAX_DEGREE, Ring, Unsupported

Cofactors = dict[int, Poly]  # by the number of the fact
Text = tuple[tuple[tuple[int, ...], tuple[int, int]], ...]


def _text(poly: Poly, support: list[int]) -> Text:
    return tuple((tuple(int(e[k]) for k in support), (int(c.p), int(c.q))) for e, c in poly.terms())


@lru_cache(maxsize=256)  # statements that follow one another share hypotheses
def _basis(names: tuple[str, ...], polys: tuple[Text, ...], pairs: int) -> Basis:
    context = flint.context(names)
    return Basis([context.from_dict({e: flint.rational(Fraction(*c)) for e, c in poly}) for poly in polys], pairs)


def add_product(total: Cofactors, where: int, product: Poly) -> None:
    """total[where] += product."""
    total[where] = total[where] + product if where in total else product


@dataclass
class _Element:
    """A basis element; its cofactors are worked out when first asked for."""

    poly: Poly
    expand: Callable[[], Cofactors]
    known: Cofactors | None = None

    def cofactors(self) -> Cofactors:
        if self.known is None:
            self.known = self.expand()
        return self.known


class Ideal:
    """All combinations of the given facts. `complete` is False if a basis was cut off at the limit of S-pairs."""

    def __init__(self, ring: Ring, facts: Sequence[Fact], pairs: int = PAIRS) -> None:
        self.ring = ring
        self.facts = [fact for fact in facts if fact[1] != 0]
        self.complete = True
        self._elements: list[_Element] = []
        for members in components([poly for _, poly in self.facts]):
            self._add_component(members, pairs)

    def _add_component(self, members: list[int], pairs: int) -> None:
        polys = [self.facts[m][1] for m in members]
        support = sorted({k for poly in polys for k, degree in enumerate(poly.degrees()) if degree})
        names = tuple(self.ring.names[k] for k in support)
        basis = _basis(names, tuple(_text(poly, support) for poly in polys), pairs)
        self.complete = self.complete and basis.complete
        for index in basis.active:
            poly = self.ring.move(basis.nodes[index].poly)
            self._elements.append(_Element(poly, partial(self._moved, basis, index, members)))

    def _moved(self, basis: Basis, index: int, members: list[int]) -> Cofactors:
        one = basis.nodes[index].poly * 0 + 1
        return {members[place]: self.ring.move(q) for place, q in basis.express([(one, index)]).items()}

    def extended(self, facts: Sequence[Fact], pairs: int = PAIRS) -> Ideal:
        """The ideal with more facts, from this one's basis."""
        fresh = [fact for fact in facts if fact[1] != 0]
        if not fresh:
            return self
        larger = Ideal(self.ring, ())
        larger.facts = [*self.facts, *fresh]
        old = self._elements
        basis = Basis([*(e.poly for e in old), *(poly for _, poly in fresh)], pairs, settled=len(old))
        larger.complete = self.complete and basis.complete
        shift = len(self.facts) - len(old)
        larger._elements = [
            _Element(basis.nodes[i].poly, partial(_through, basis, i, old, shift)) for i in basis.active
        ]
        return larger

    def polys(self) -> list[Poly]:
        """The reduced Groebner basis."""
        return [element.poly for element in self._elements]

    def reduce(self, poly: Poly) -> Poly:
        """The normal form: zero only for members of the ideal."""
        return self._divide(poly)[0]

    def _divide(self, poly: Poly) -> tuple[Poly, Cofactors]:
        quotients: Cofactors = {}
        changed = len(poly) > 0 and len(self._elements) > 0
        if changed and poly.total_degree() > MAX_DEGREE:
            raise Unsupported(f"a polynomial of degree {poly.total_degree()}, to be reduced by equations")
        while changed:
            changed = False
            for k, element in enumerate(self._elements):
                quotient, rest = divmod(poly, element.poly)
                if len(quotient):
                    add_product(quotients, k, quotient)
                    poly, changed = rest, True
                    if not len(poly):
                        return poly, quotients
        return poly, quotients

    def cofactors(self, poly: Poly) -> list[Fact] | None:
        """[(reference, q), ...] with poly = sum q * fact, or None if poly is not in the ideal."""
        rest, quotients = self._divide(poly)
        if rest != 0:
            return None
        total: Cofactors = {}
        for k, quotient in quotients.items():
            for where, cofactor in self._elements[k].cofactors().items():
                add_product(total, where, cofactor * quotient)
        return [(self.facts[where][0], q) for where, q in sorted(total.items()) if q != 0 and self._counts(q)]

    def _counts(self, cofactor: Poly) -> bool:
        """Whether a cofactor is not zero by what holds of roots, sines and cosines by construction."""
        axioms = by_construction(self.ring)
        if not axioms or len(cofactor) == 1:
            return True
        ideal = self.ring.remembered("axioms", lambda: Ideal(self.ring, axioms))
        return bool(ideal.reduce(cofactor) != 0)


def _through(basis: Basis, index: int, old: Sequence[_Element], shift: int) -> Cofactors:
    """Cofactors of an element of an extended basis: through the old elements back to the facts."""
    if index < len(old):
        return old[index].cofactors()
    total: Cofactors = {}
    for place, q in basis.express([(basis.nodes[index].poly * 0 + 1, index)]).items():
        if place >= len(old):
            add_product(total, place + shift, q)
        else:
            for where, cofactor in old[place].cofactors().items():
                add_product(total, where, cofactor * q)
    return total
