"""A sum of addends that are not negative is zero: so each of them is."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

from symcheck.core.terms import Formula, Term, Value, node
from symcheck.proof.algebra.facts import NOTHING, Signed
from symcheck.proof.algebra.flint import Poly, fraction
from symcheck.proof.algebra.forms import term_of
from symcheck.proof.algebra.place import MAX_TERMS, Place
from symcheck.proof.algebra.products import Product
from symcheck.proof.rules.step import Attempt, Cofactor, Search, Step, combination


@dataclass(frozen=True)
class Vanish(Step):
    """A sum of addends that are manifestly not negative is zero: so each of them is."""

    rule: ClassVar[str] = "vanish"
    form: Signed
    cofactors: tuple[Cofactor, ...]
    then: Step


def vanishing_sum(goal: Formula, place: Place, search: Search) -> Attempt:
    """By the first sum, hinted or among the facts, of which it is not known yet that its addends are zero."""
    known = place.known
    for form in (*place.forms, *_sums(place)):
        if not (isinstance(form, Value) and form.tag == "+"):
            continue
        signs = [known.sign(addend) for addend in form.terms]
        ratios = [known.ring.ratio(addend) for addend in form.terms] if all(level for level, _ in signs) else []
        if not ratios or any(ratio.den for ratio in ratios):
            continue
        radicals = [Product.of(ratio.num, known).radical for ratio in ratios]
        if all(place.cofactors(radical) is not None for radical in radicals):
            continue
        if (cofactors := place.cofactors(known.ring.ratio(form).num)) is None:
            continue
        below = known.assume(node("and", *(node("=", addend, 0) for addend in form.terms)))
        then = search(goal, below, place)
        if then is None:
            return None, True
        grounds = NOTHING.union(*(grounds for _, grounds in signs))
        shorter = then.without(range(known.count, below.count))
        return shorter or Vanish(Signed(form, grounds), combination(cofactors), then), True
    return None, False


def _sums(place: Place) -> Iterator[Term]:
    """Short facts that may be sums of squares; the first addend is positive."""
    for poly in (*(fact for _, fact in place.known.facts), *place.relatives()):
        if 1 < len(poly) <= MAX_TERMS and _may_be_sum_of_squares(poly):
            yield term_of(poly if fraction(poly.leading_coefficient()) > 0 else -poly)


def _may_be_sum_of_squares(poly: Poly) -> bool:
    """Whether all coefficients have one sign and no addend is a number."""
    signs = {coefficient > 0 for coefficient in poly.coeffs()}
    return len(signs) == 1 and sum(map(int, poly.monomial(len(poly) - 1))) > 0
