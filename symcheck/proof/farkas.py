"""Contradictions among signs: a sum of positive multiples of things that are not negative, one positive, is zero."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from symcheck.core.formulas import contrary
from symcheck.core.terms import Formula, Term, node
from symcheck.core.verdicts import Certificate
from symcheck.proof.equations import written
from symcheck.proof.knowledge import Knowledge
from symcheck.proof.orders import number_term, term_of
from symcheck.proof.polynomial import Poly, fraction

MAX_COLUMNS = 160


@dataclass(frozen=True)
class _Addend:
    """A term that is manifestly >= 0 (level 1) or > 0 (level 2), as a polynomial and in normal form."""

    term: Term
    level: int
    poly: Poly
    normal: Poly


def prove_by_contrary(goal: Formula, known: Knowledge, products: bool = True) -> Certificate | None:
    """An order follows if the signs that are known and its contrary do not go together."""
    then = contradiction(known.assume(contrary(goal)), goal, products)
    return None if then is None else {"rule": "implies", "then": then}


def contradiction(known: Knowledge, about: Formula, products: bool = True) -> Certificate | None:
    """The rule "absurd" from a positive form that is zero: linear in what is known, then with products.

    Only what has to do with the variables of a relation, in one step or several, is looked at.
    """
    addends = _about(list(_known(known)), known.ring.difference(about), known)
    for more in (_squares, _products) if products else ():
        if (found := _combined(addends, known)) is not None:
            return found
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
    links = [_places(each) for each in (*(fact for _, fact in known.facts), *(fact for _, fact in known.ring.axioms()))]
    links += [_places(each.poly) for each in addends]
    reached, before = _places(poly), -1
    while len(reached) > before:
        before = len(reached)
        reached = reached.union(*(link for link in links if link & reached))
    chosen: dict[str, _Addend] = {}
    for each in addends:
        text = str(each.normal)
        if _places(each.poly) <= reached and (text not in chosen or chosen[text].level < each.level):
            chosen[text] = each
    return list(chosen.values())


def _places(poly: Poly) -> set[int]:
    return {k for k, degree in enumerate(poly.degrees()) if degree} if poly != 0 else set()


def _addend(term: Term, level: int, poly: Poly, known: Knowledge) -> _Addend:
    return _Addend(term, level, poly, known.ideal().reduce(poly))


def _squares(addends: Sequence[_Addend], known: Knowledge) -> list[_Addend]:
    """For y - x known to be positive, x not negative: (y - x)^2 and x (y - x), whose sum is y (y - x)."""
    found = []
    for each in addends:
        if len(each.poly) < 2:
            continue
        found.append(_addend(node("^", each.term, 2), each.level, each.poly**2, known))
        for exponents, coefficient in each.poly.terms():
            monomial = known.ring.context.from_dict({exponents: -coefficient})
            if coefficient > 0 or monomial.is_constant():
                continue
            factor = term_of(monomial)
            if level := min(known.sign(factor)[0], each.level):
                found.append(_addend(node("*", factor, each.term), level, monomial * each.poly, known))
    return found


def _products(addends: Sequence[_Addend], known: Knowledge) -> list[_Addend]:
    """What is known times the letters that are not negative."""
    letters = [(term_of(g), g, known.sign(term_of(g))[0]) for g in known.ring.generator.values()]
    first = [each for each in addends if len(each.poly) > 1 and each.poly.total_degree() <= 2]
    return [
        _addend(node("*", term, each.term), min(level, each.level), g * each.poly, known)
        for term, g, level in letters
        if level
        for each in first
    ]


def _combined(addends: Sequence[_Addend], known: Knowledge) -> Certificate | None:
    """The contradiction, if one of the positive combinations of the addends is zero."""
    found = positive_relation([(_coefficients(each.normal), each.level == 2) for each in addends])
    if found is None:
        return None
    used = [(addends[k], multiple) for k, multiple in found.items()]
    parts = [each.term if m == 1 else node("*", number_term(m), each.term) for each, m in used]
    form: Term = parts[0] if len(parts) == 1 else node("+", *parts)
    cofactors = known.ideal().cofactors(known.ring.ratio(form).num)
    level, given = known.sign(form)
    if cofactors is None or level < 2:
        return None
    grounds = {"cofactors": written(cofactors), "given": sorted(map(list, given))}
    return {"rule": "absurd", "times": [["positive", form]], **grounds}


Column = dict[tuple[int, ...], Fraction]


def _coefficients(poly: Poly) -> Column:
    return {tuple(map(int, exponents)): fraction(coefficient) for exponents, coefficient in poly.terms()}


def positive_relation(columns: Sequence[tuple[Column, bool]]) -> dict[int, Fraction] | None:
    """Numbers >= 0, not all zero for the marked columns, with which the sum of the columns is zero; None if none are.

    Exact: the simplex method by Bland's rule, after columns that nothing can cancel are left out.
    """
    open_ = _cancelling({k: column for k, (column, _) in enumerate(columns) if column})
    marked = {k for k in open_ if columns[k][1]}
    free = next((k for k, (column, mark) in enumerate(columns) if mark and not column), None)
    if free is not None:
        return {free: Fraction(1)}
    if not marked:
        return None
    rows = sorted({monomial for k in open_ for monomial in columns[k][0]})
    table = [[columns[k][0].get(row, Fraction(0)) for k in open_] + [Fraction(0)] for row in rows]
    table.append([Fraction(int(k in marked)) for k in open_] + [Fraction(1)])
    solution = _feasible(table)
    return None if solution is None else {open_[j]: value for j, value in solution.items() if value}


def _cancelling(columns: dict[int, Column]) -> list[int]:
    """The columns left when none has a monomial that occurs with one sign only."""
    while True:
        signs: dict[tuple[int, ...], set[bool]] = {}
        for column in columns.values():
            for monomial, value in column.items():
                signs.setdefault(monomial, set()).add(value > 0)
        kept = {k: column for k, column in columns.items() if all(len(signs[m]) == 2 for m in column)}
        if len(kept) == len(columns):
            return list(kept)
        columns = kept


def _feasible(table: list[list[Fraction]]) -> dict[int, Fraction] | None:
    """x >= 0 with A x = b for rows (A | b), b >= 0, by minimising the sum of one slack for each row."""
    width = len(table[0]) - 1
    basis = [width + k for k in range(len(table))]  # the slacks, which never come back
    cost = [sum(column, Fraction(0)) for column in zip(*table, strict=True)]
    while cost[-1]:
        enters = next((j for j in range(width) if cost[j] > 0), None)
        if enters is None:
            return None
        ratios = [(row[-1] / row[enters], basis[i], i) for i, row in enumerate(table) if row[enters] > 0]
        _, _, leaves = min(ratios)
        pivot = table[leaves] = [value / table[leaves][enters] for value in table[leaves]]
        basis[leaves] = enters
        for row in (*(row for i, row in enumerate(table) if i != leaves), cost):
            if factor := row[enters]:
                row[:] = [value - factor * p if p else value for value, p in zip(row, pivot, strict=True)]
    return {j: table[i][-1] for i, j in enumerate(basis) if j < width}
