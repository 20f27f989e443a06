"""Products that are zero: one of their factors is. With one factor that is a derivation, not a case."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from symcheck.core.terms import Formula, Term, node
from symcheck.proof.algebra.facts import Fact, Nonzero
from symcheck.proof.algebra.flint import Poly
from symcheck.proof.algebra.place import Place
from symcheck.proof.algebra.printed import term_of_text
from symcheck.proof.algebra.products import Product
from symcheck.proof.rules.absurd import vanishing
from symcheck.proof.rules.step import Attempt, Cofactor, Search, Step, combination


@dataclass(frozen=True)
class Split(Step):
    """A product of powers is zero: so one of their bases is."""

    rule: ClassVar[str] = "split"
    form: Term  # of letters and functions without denominators
    times: tuple[Nonzero, ...]
    cofactors: tuple[Cofactor, ...]
    cases: tuple[Step, ...]


def split(product: Product, bases: Sequence[Poly], cofactors: list[Fact], cases: Sequence[Step], number: int) -> Step:
    """The step for the cases that one of the bases is zero, which is assumed under a number.

    A case that does without what is assumed there is a proof by itself.
    """
    for case in cases:
        if (shorter := case.without([number])) is not None:
            return shorter
    form = node("*", *(node("^", term_of_text(str(base)), product.power) for base in bases))
    return Split(form, product.times, combination(cofactors), tuple(cases))


def split_product(goal: Formula, place: Place, search: Search) -> Attempt:
    """One of the factors of a fact is zero: the shortest fact first."""
    for product in sorted(place.products, key=lambda product: product.size):
        place.products.remove(product)
        if not any(map(place.vanishes, product.factors)):
            return _in_cases(goal, place, product, product.cofactors(), search), True
    return None, False


def _in_cases(goal: Formula, place: Place, product: Product, cofactors: list[Fact], search: Search) -> Step | None:
    cases: list[Step] = []
    for factor in product.factors:
        if (proof := search(goal, place.known.with_fact(factor), place)) is None:
            return None
        cases.append(proof)
        if proof.without([place.known.count]) is not None:  # the other cases are like this one
            break
    return split(product, product.factors, cofactors, cases, place.known.count)


def shorten(goal: Formula, place: Place, search: Search) -> Step | None:
    """Divides out of the new facts what is not zero, and takes roots."""
    steps: list[Product] = []
    known, seen = place.known, {str(poly) for _, poly in place.known.facts}
    for product in place.shorter:
        if str(product.radical) not in seen:
            steps.append(product)
            known = known.with_fact(product.radical)
            seen.add(str(product.radical))
    place.shorter = []
    proof = search(goal, known, place)
    for number, product in reversed([*enumerate(steps, place.known.count)]):
        proof = proof and split(product, [product.radical], product.cofactors(), [proof], number)
    return proof


def split_basis(goal: Formula, place: Place, search: Search) -> Step | None:
    """What the elements of the Groebner basis say when something non-zero is divided out, or split."""
    products = [Product.of(poly, place.known) for poly in place.ideal.polys()]
    for product in products:
        if not product.factors and product.times and (cofactors := place.cofactors(product.whole())) is not None:
            return vanishing(product, cofactors)
    products = [p for p in products if p.factors and (p.shorter or len(p.factors) > 1)]
    for product in sorted(products, key=lambda p: (len(p.factors), p.size)):
        if any(map(place.vanishes, product.factors)):
            continue
        if (cofactors := place.cofactors(product.whole())) is None:
            continue
        if len(product.factors) > 1:
            return _in_cases(goal, place, product, cofactors, search)
        then = search(goal, place.known.with_fact(product.radical), place)
        return then and split(product, [product.radical], cofactors, [then], place.known.count)
    return None
