"""Claims by cases, such as those with a sign or an angle of two arguments, and which cases there can be."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from symcheck.core.calculus import letters
from symcheck.core.formulas import conjuncts
from symcheck.core.terms import Connective, Formula, Node, Relation, Term, node
from symcheck.proof.algebra.polynomial import number_of

CASE = "case"  # the name of the condition that says which
ALL = frozenset({-1, 0, 1})
# the signs of a term that is so compared with zero
SIGNS = {">": {1}, ">=": {0, 1}, "=": {0}, "<=": {-1, 0}, "<": {-1}, "!=": {-1, 1}}
Signs = frozenset[int]


def implied(claim: Formula, before: tuple[Formula, ...] = ()) -> Iterator[tuple[tuple[Formula, ...], Formula]]:
    """The conclusions of a claim that is made of implications, each with its premises."""
    match claim:
        case Connective(tag="and", formulas=parts):
            for part in parts:
                yield from implied(part, before)
        case Connective(tag="=>", formulas=(premise, rest)):
            yield from implied(rest, (*before, *conjuncts(premise)))
        case _:
            yield before, claim


def may_all_hold(conditions: Sequence[Formula]) -> bool:
    """Whether the signs that are said of terms agree, as far as products of letters and multiples show."""
    known = dict[Term, Signs]()
    for _ in range(2):  # what is said of a letter may follow what is said of a product
        for formula in conditions:
            if not isinstance(formula, Relation) or formula.tag not in SIGNS:
                continue
            left, right = formula.terms
            gap = left if right == 0 else node("-", right) if left == 0 else node("+", left, node("-", right))
            found = _sign(gap, known) & SIGNS[formula.tag]
            if not found:
                return False
            known[gap] = found
    return True


def _sign(term: Term, known: dict[Term, Signs]) -> Signs:
    """The signs that a term can have, by those of its factors and of multiples of it."""
    number = number_of(term)
    if number is not None:
        return frozenset({(number > 0) - (number < 0)})
    found = known.get(term, ALL)
    for other, signs in known.items():
        if letters(other) == letters(term):
            for factor in (1, -1):
                if number_of(node("+", term, node("*", -factor, other))) == 0:
                    found &= {factor * sign for sign in signs}
    match term:
        case Node(tag="-", outside=(inner,)):
            found &= {-sign for sign in _sign(inner, known)}
        case Node(tag="*", outside=factors):
            product = {1}
            for part in factors:
                product = {a * b for a in product for b in _sign(part, known)}
            found &= product
    return found
