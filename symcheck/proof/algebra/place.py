"""One place of a search, where facts are taken into account step by step."""

from __future__ import annotations

from collections.abc import Sequence

from symcheck.core.terms import Term, Value, node
from symcheck.proof.algebra.facts import Fact, by_construction, merged
from symcheck.proof.algebra.flint import Poly
from symcheck.proof.algebra.groebner import Monomial
from symcheck.proof.algebra.ideal import Ideal
from symcheck.proof.algebra.knowledge import Knowledge
from symcheck.proof.algebra.polynomial import power_of
from symcheck.proof.algebra.products import Product

# with longer facts, or facts of a higher degree, Groebner bases take minutes
MAX_TERMS = 14
MAX_DEGREE = 8  # of facts, for the same reason
PAIRS = 300  # S-polynomials when facts enter an ideal, at every place anew: so fewer than for one ideal of hypotheses


class Place:
    """Knowledge at a node of the search. Facts enter the ideal late: first those that are a variable alone, products
    never (they are split), the rest when nothing is left to split. Until then they are used in linear combinations."""

    def __init__(self, known: Knowledge, before: Place | None = None, forms: Sequence[Term] = ()) -> None:
        self.known = known
        self.forms: Sequence[Term] = before.forms if before else forms  # hints: sums that may be zero
        self.base: Ideal = before.base if before else self._short_hypotheses()
        self._normal: dict[str, Poly] = before._normal if before else {}
        self.contradiction: Product | None = None  # a fact that says that something non-zero is zero
        self._answers: dict[tuple[str, bool], list[Fact] | None] = {}
        self.light = False  # without the ideal, by linear combinations only
        self._ideal: tuple[Ideal, list[Fact]] = before._ideal if before else (self.base, [])  # to be extended by facts
        self.rows: list[tuple[Monomial, Poly, list[Fact]]] = []
        self.monomials = [fact for fact in known.facts if len(fact[1]) == 1]
        in_base = {ref for ref, _ in self.base.facts}
        for fact in known.facts:
            if len(fact[1]) > 1 and fact[0] not in in_base:
                self._add_row(fact)
        self.waiting: list[Fact] = list(before.waiting) if before else []
        self.products: list[Product] = list(before.products) if before else []
        self.shorter: list[Product] = []
        for fact in known.facts[len(before.known.facts) if before else len(known.facts) :]:
            product = Product.of(fact[1], known, fact[0])
            if product.times and not product.factors:
                self.contradiction = product
            elif product.shorter:
                self.shorter.append(product)
            elif len(product.factors) > 1 and not is_square_minus_number(fact[1]):
                self.products.append(product)
            elif len(fact[1]) == 1:
                self._ideal = (self._ideal[0], [*self._ideal[1], fact])
            else:
                self.waiting.append(fact)

    def _short_hypotheses(self) -> Ideal:
        """The ideal of what is short among the hypotheses; the long ones are used in linear combinations only."""
        short = [fact for fact in self.known.facts if _short(fact[1])]
        return Ideal(self.known.ring, [*by_construction(self.known.ring), *short])

    def _strip(self, poly: Poly) -> tuple[Poly, list[Fact]]:
        """(rest, quotients) of the division by the facts that are monomials."""
        quotients: list[Fact] = []
        for ref, monomial in self.monomials:
            quotient, poly = divmod(poly, monomial)
            if quotient != 0:
                quotients.append((ref, quotient))
        return poly, quotients

    def _thin(self, poly: Poly) -> Poly:
        """What monomials and hypotheses leave of a polynomial; linear in it."""
        return self._strip(self.normal(self._strip(poly)[0]))[0]

    def normal(self, poly: Poly) -> Poly:
        """The normal form modulo the hypotheses."""
        text = str(poly)
        if text not in self._normal:
            self._normal[text] = self.base.reduce(poly)
        return self._normal[text]

    @property
    def ideal(self) -> Ideal:
        """The hypotheses and the facts let in so far; worked out when first needed."""
        if self._ideal[1]:
            self._ideal = (self._ideal[0].extended(self._ideal[1], PAIRS), [])
        return self._ideal[0]

    def _add_row(self, fact: Fact) -> None:
        """One more row of the echelon form of the facts modulo the hypotheses."""
        row, combination = self._eliminate(self._thin(fact[1]))
        if row != 0:
            scale = row.leading_coefficient()
            combination = [(ref, -q) for ref, q in combination] + [(fact[0], self.known.ring.number(1))]
            self.rows.append((tuple(map(int, row.monomial(0))), row / scale, [(r, q / scale) for r, q in combination]))

    def _eliminate(self, poly: Poly) -> tuple[Poly, list[Fact]]:
        used: list[Fact] = []
        for lead, row, combination in self.rows:
            coefficient = poly[lead]
            if coefficient != 0:
                poly -= row * coefficient
                used += [(ref, q * coefficient) for ref, q in combination]
        return poly, merged(used)

    def relatives(self) -> list[Poly]:
        """The hypotheses with squares replaced by the numbers they are said to be here."""
        squares = [poly for _, poly in self.waiting if is_square_minus_number(poly)]
        shorter = []
        for _, poly in self.base.facts if squares else ():
            rest = poly
            for square in squares:
                rest = divmod(rest, square)[1]
            if len(rest) < len(poly):
                shorter.append(rest)
        return shorter

    def settle(self) -> bool:
        """Lets the waiting facts into the ideal; False if none was waiting."""
        facts = [f for f in self.waiting if _short(f[1])]
        self.waiting = []
        self._answers = {}
        self._ideal = (self._ideal[0], [*self._ideal[1], *facts])
        return bool(facts)

    def vanishes(self, poly: Poly) -> bool:
        """Whether the polynomial is zero by what is in the ideal so far."""
        return bool(self._eliminate(self._thin(poly))[0] == 0 or self.ideal.reduce(poly) == 0)

    def cofactors(self, poly: Poly) -> list[Fact] | None:
        """The polynomial as a combination of facts: of few, if that is enough."""
        if poly == 0:
            return []
        key = str(poly), self.light
        if key not in self._answers:
            self._answers[key] = self._worked_out(poly)
        return self._answers[key]

    def _worked_out(self, poly: Poly) -> list[Fact] | None:
        rest, used = self._eliminate(self._thin(poly))
        if rest == 0:
            known = dict(self.known.facts)
            for ref, q in used:
                poly -= q * known[ref]
            poly, before = self._strip(poly)
            normal = self.normal(poly)
            outer = self.base.cofactors(poly - normal) or []
            return merged([*before, *outer, *self._strip(normal)[1], *used])
        return None if self.light or self.ideal is self.base else self.ideal.cofactors(poly)

    def of_term(self, term: Term) -> list[Fact] | None:
        """Cofactors of a term by its structure: a product is zero as soon as one factor is."""
        match term:
            case Value(tag="+", terms=addends):
                parts = [self.of_term(addend) for addend in addends]
                if all(part is not None for part in parts):
                    return merged([cofactor for part in parts for cofactor in part or ()])
            case Value(tag="^"):
                base, exponent = power_of(term)
                if (multiple := self._multiple(base, node("^", base, exponent - 1))) is not None:
                    return multiple
            case Value(tag="*", terms=factors):
                for k, factor in enumerate(factors):
                    multiple = self._multiple(factor, node("*", 1, *factors[:k], *factors[k + 1 :]))
                    if multiple is not None:
                        return multiple
        ratio = self.known.ring.ratio(term)
        return None if ratio.den else self.cofactors(ratio.num)

    def _multiple(self, factor: Term, rest: Term) -> list[Fact] | None:
        cofactors = self.of_term(factor)
        if cofactors is None or (ratio := self.known.ring.ratio(rest)).den:
            return None
        return [(ref, q * ratio.num) for ref, q in cofactors]


def is_square_minus_number(poly: Poly) -> bool:
    """x^2 - r: it says more as it stands than split into x = s or x = -s."""
    return len(poly) == 2 and poly.total_degree() == 2 and sum(map(int, poly.monomial(1))) == 0


def _short(poly: Poly) -> bool:
    return len(poly) <= MAX_TERMS and poly.total_degree() <= MAX_DEGREE
