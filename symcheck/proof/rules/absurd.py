"""Contradictions: something that is not zero is a combination of facts.

Among signs, a sum of positive multiples of things that are not negative, one of them positive, is zero.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

from symcheck.core.formulas import contrary
from symcheck.core.terms import Formula, Node, Term, mapped, node
from symcheck.proof.algebra.facts import Assumed, Fact, Nonzero, Positive, by_construction
from symcheck.proof.algebra.flint import Poly, fraction, occurring
from symcheck.proof.algebra.forms import fraction_form, number_term, term_of
from symcheck.proof.algebra.knowledge import Knowledge
from symcheck.proof.algebra.place import Place
from symcheck.proof.algebra.products import Product
from symcheck.proof.algebra.simplex import Column, positive_relation
from symcheck.proof.rules.implies import Implies
from symcheck.proof.rules.step import Cofactor, Step, combination

MAX_COLUMNS = 160  # of an exact simplex tableau: with more of them its fractions grow long
MAX_DEGREE = 2  # of what is multiplied with letters: products of more are many, and seldom cancel


@dataclass(frozen=True)
class Absurd(Step):
    """Something that is not zero is a combination of facts: so anything follows."""

    rule: ClassVar[str] = "absurd"
    times: tuple[Nonzero, ...]
    cofactors: tuple[Cofactor, ...]


def vanishing(product: Product, cofactors: Iterable[Fact]) -> Absurd:
    """A product of things that are not zero is zero."""
    return Absurd(product.times, combination(cofactors))


def absurd_at(place: Place) -> Absurd | None:
    """One, or something that is not zero by a condition, vanishes at a place of a search."""
    if (proof := opposite_signs(place.known)) is not None:
        return proof
    if (cofactors := place.cofactors(place.known.ring.number(1))) is not None:
        return Absurd((), combination(cofactors))
    for ref, poly in place.known.conditions:
        if (cofactors := place.cofactors(poly)) is not None:
            return Absurd((ref,), combination(cofactors))
    return None


def opposite_signs(known: Knowledge) -> Absurd | None:
    """Something positive that is zero: the sum of what was assumed last and of its negative."""
    for sign in (*known.fractions[::-1], *known.signs[::-1])[:2]:
        if not isinstance(sign.ref, Assumed):
            continue
        others = replace(
            known,
            signs=tuple(s for s in known.signs if s is not sign),
            fractions=tuple(s for s in known.fractions if s is not sign),
        )
        form = fraction_form(node("-", sign.term), others)
        if form is not None and (found := known.sign(form))[0] and sign.level + found[0] > 2:
            return Absurd((Positive(node("+", sign.term, form), found[1]),), ())
    return None


def of_one_sign(goal: Formula, known: Knowledge) -> Absurd | None:
    """That what a relation says not to be zero is manifestly positive, or negative, where it is known to be zero."""
    left, right = goal.terms
    for small, large in ((right, left), (left, right)):
        form = fraction_form(large if small == 0 else node("+", large, node("-", small)), known)
        level, grounds = (0, frozenset()) if form is None else known.sign(form)
        if form is not None and level == 2:
            cofactors = known.ideal().cofactors(known.ring.ratio(form).num)
            return None if cofactors is None else Absurd((Positive(form, grounds),), combination(cofactors))
    return None


def by_conjugates(goal: Formula, known: Knowledge) -> Implies | None:
    """An order between a root and something else, as that between their squares has a manifest sign."""
    small, large = goal.terms if goal.tag[0] == "<" else goal.terms[::-1]
    below = known.assume(contrary(goal))
    gap: Term = node("+", small, node("-", large))
    wanted = 1 if goal.tag.endswith("=") else 2
    for root in dict.fromkeys(_roots(gap)):
        without: Term = node("*", 2, _with_zero(gap, root))
        for other in (node("+", without, node("-", gap)), node("+", gap, node("-", without))):
            conjugate = fraction_form(other, below)
            if conjugate is None or below.sign(conjugate)[0] < 3 - wanted:
                continue
            product = node("*", gap, conjugate)
            for poly in (below.ring.ratio(product).num, below.ideal().reduce(below.ring.ratio(product).num)):
                form = fraction_form(node("-", product), below, -poly)
                if form is None or below.sign(form)[0] < wanted:
                    continue
                total = node("+", product, form)
                (level, grounds), ratio = below.sign(total), below.ring.ratio(total)
                cofactors = None if ratio.den else below.ideal().cofactors(ratio.num)
                if level == 2 and cofactors is not None:
                    return Implies(Absurd((Positive(total, grounds),), combination(cofactors)))
    return None


def _roots(tree: Term) -> Iterator[Node]:
    """The square roots that are added or multiplied, and stand below no line and in no function."""
    if isinstance(tree, Node) and tree.tag == "sqrt":
        yield tree
    elif isinstance(tree, Node) and tree.tag in ("+", "-", "*", "/"):
        for part in tree.outside[: 1 if tree.tag == "/" else None]:
            yield from _roots(part)


def _with_zero(tree: Term, root: Node) -> Term:
    """The term with 0 for such a root."""
    if tree == root:
        return 0
    if isinstance(tree, Node) and tree.tag == "/":
        return node("/", _with_zero(tree.outside[0], root), tree.outside[1])
    if isinstance(tree, Node) and tree.tag in ("+", "-", "*"):
        return mapped(tree, lambda part: _with_zero(part, root))
    return tree


def contrary_signs(goal: Formula, known: Knowledge, products: bool = True) -> Implies | None:
    """An order follows if the signs that are known and its contrary do not go together."""
    then = contradiction(known.assume(contrary(goal)), goal, products)
    return None if then is None else Implies(then)


@dataclass(frozen=True)
class _Addend:
    """A term that is manifestly >= 0 (level 1) or > 0 (level 2), as a polynomial and in normal form."""

    term: Term
    level: int
    poly: Poly
    normal: Poly


def contradiction(known: Knowledge, about: Formula, products: bool = True) -> Absurd | None:
    """A positive form that is zero: linear in what is known, then with products.

    Only what has to do with the variables of a relation, in one step or several, is looked at.
    """
    addends = _about(list(_known(known)), known.ring.difference(about), known)
    for more in (_squares, _products) if products else ():
        if (proof := _combined(addends, known)) is not None:
            return proof
        addends += more(addends, known)
        if len(addends) > MAX_COLUMNS:
            return None
    return _combined(addends, known)


def _known(known: Knowledge) -> Iterator[_Addend]:
    """1, what is assumed, and what is assumed of fractions times their denominators."""
    yield _addend(1, 2, known.ring.number(1), known)
    for sign in known.signs:
        yield _addend(sign.term, sign.level, sign.poly, known)
    for sign in known.fractions:
        below = [term_of(poly) for poly, e in known.ring.ratio(sign.term).den.values() for _ in range(e)]
        level = min([sign.level, *(known.sign(term)[0] for term in below)])
        if level:
            yield _addend(node("*", *below, sign.term), level, sign.poly, known)


def _about(addends: list[_Addend], poly: Poly, known: Knowledge) -> list[_Addend]:
    """Those connected with a polynomial by their variables; of equal ones the strictest."""
    links = [occurring(fact) for _, fact in (*known.facts, *by_construction(known.ring))]
    links += [occurring(addend.poly) for addend in addends]
    reached, before = occurring(poly), -1
    while len(reached) > before:
        before = len(reached)
        reached = reached.union(*(link for link in links if link & reached))
    chosen: dict[str, _Addend] = {}
    for addend in addends:
        text = str(addend.normal)
        if occurring(addend.poly) <= reached and (text not in chosen or chosen[text].level < addend.level):
            chosen[text] = addend
    return list(chosen.values())


def _addend(term: Term, level: int, poly: Poly, known: Knowledge) -> _Addend:
    return _Addend(term, level, poly, known.ideal().reduce(poly))


def _squares(addends: Sequence[_Addend], known: Knowledge) -> list[_Addend]:
    """For y - x known to be positive, x not negative: (y - x)^2 and x (y - x), whose sum is y (y - x)."""
    squares = []
    for addend in addends:
        if len(addend.poly) < 2:
            continue
        squares.append(_addend(node("^", addend.term, 2), addend.level, addend.poly**2, known))
        for exponents, coefficient in addend.poly.terms():
            monomial = known.ring.context.from_dict({exponents: -coefficient})
            if coefficient > 0 or monomial.is_constant():
                continue
            factor = term_of(monomial)
            if level := min(known.sign(factor)[0], addend.level):
                squares.append(_addend(node("*", factor, addend.term), level, monomial * addend.poly, known))
    return squares


def _products(addends: Sequence[_Addend], known: Knowledge) -> list[_Addend]:
    """What is known times the letters that are not negative."""
    letters = [(term_of(g), g, known.sign(term_of(g))[0]) for g in known.ring.generator.values()]
    first = [addend for addend in addends if len(addend.poly) > 1 and addend.poly.total_degree() <= MAX_DEGREE]
    return [
        _addend(node("*", term, addend.term), min(level, addend.level), g * addend.poly, known)
        for term, g, level in letters
        if level
        for addend in first
    ]


def _combined(addends: Sequence[_Addend], known: Knowledge) -> Absurd | None:
    """The contradiction, if one of the positive combinations of the addends is zero."""
    multiples = positive_relation([(_coefficients(addend.normal), addend.level == 2) for addend in addends])
    if multiples is None:
        return None
    used = [(addends[k].term, multiple) for k, multiple in multiples.items()]
    parts = [term if multiple == 1 else node("*", number_term(multiple), term) for term, multiple in used]
    form: Term = parts[0] if len(parts) == 1 else node("+", *parts)
    cofactors = known.ideal().cofactors(known.ring.ratio(form).num)
    level, grounds = known.sign(form)
    if cofactors is None or level < 2:
        return None
    return Absurd((Positive(form, grounds),), combination(cofactors))


def _coefficients(poly: Poly) -> Column:
    return {tuple(map(int, exponents)): fraction(coefficient) for exponents, coefficient in poly.terms()}
