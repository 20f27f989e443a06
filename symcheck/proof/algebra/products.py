"""A polynomial that is zero as a product: one of its factors is, as those that are known not to be zero are not."""

from __future__ import annotations

from dataclasses import dataclass

from symcheck.proof.algebra.facts import Fact, Nonzero, Positive, Reference
from symcheck.proof.algebra.flint import Poly
from symcheck.proof.algebra.forms import positive_form
from symcheck.proof.algebra.knowledge import Knowledge, proportional


@dataclass(frozen=True)
class Product:
    """A polynomial that is zero, as (things known to be non-zero) times a radical to a power."""

    poly: Poly
    factors: tuple[Poly, ...]
    times: tuple[Nonzero, ...]
    outside: Poly  # the product of `times`
    power: int
    radical: Poly
    shorter: bool  # than the polynomial
    ref: Reference | None  # that says that it is zero

    @classmethod
    def of(cls, poly: Poly, known: Knowledge, ref: Reference | None = None) -> Product:
        """The product a polynomial is, given what is known not to be zero."""
        one = known.ring.number(1)
        times: list[Nonzero] = []
        outside, radical, power, factors = one, one, 1, []
        powers = [(factor, int(exponent)) for factor, exponent in poly.factor()[1]] if poly != 0 else []
        for factor, exponent in powers:
            ground, value = nonzero(factor, known)
            if ground is None:
                factors.append(factor)
                radical, power = radical * factor, max(power, exponent)
                continue
            times += [ground] * exponent
            outside *= value**exponent
        shorter = bool(factors) and (bool(times) or any(exponent > 1 for _, exponent in powers))
        return cls(poly, tuple(factors), tuple(times), outside, power, radical, shorter, ref)

    @property
    def size(self) -> tuple[int, int, int]:
        """What tells simple products from others."""
        return int(self.radical.total_degree()), len(self.radical), len(self.factors)

    def whole(self) -> Poly:
        """The multiple of the polynomial that a certificate shows to be zero."""
        return self.outside * self.radical**self.power

    def cofactors(self) -> list[Fact]:
        """That multiple as a multiple of the fact itself."""
        assert self.ref is not None
        return [(self.ref, divmod(self.whole(), self.poly)[0])]


def nonzero(poly: Poly, known: Knowledge) -> tuple[Nonzero | None, Poly]:
    """What says that the polynomial is not zero, and the multiple of it that this speaks of."""
    key = "nonzero", str(poly), tuple(map(id, known.conditions)), tuple(map(id, known.signs))
    return known.ring.remembered(key, lambda: _nonzero(poly, known), known)


def _nonzero(poly: Poly, known: Knowledge) -> tuple[Nonzero | None, Poly]:
    for ref, condition in known.conditions:
        if proportional(poly, condition) is not None:
            return ref, condition
    for candidate in (poly, -poly):
        form = positive_form(candidate, known)
        if form is not None and (sign := known.sign(form))[0] == 2:
            return Positive(form, sign[1]), known.ring.poly(form)
    return None, poly
