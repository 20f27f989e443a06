"""What a relation says in general that is printed for a quantity that is 1: powers of it in the terms that lack them.

Terms that measure powers of one quantity say of these the same as what is printed says of their ratios to such powers.
So for a quantity c that is not 0 the general form holds for all x if and only if the printed one holds for all x / c^k.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from symcheck.core.terms import Connective, Formula, Quantified, Term, mapped, node
from symcheck.dimensions.rules import Kind, Linear, Rational, Rules, Scale, added, addends, is_base, ratio

# a letter with or without an index, such as "c" or "h_{\\max}"; not a unit, such as "kg m^2"
LETTER = re.compile(r"\\?[A-Za-z]\w*(?:_\{\\?\w+\})?")


class NoGeneralForm(Exception):
    """The quantity is missing inside of a term, or it is no letter."""


def plain(letter: str) -> str:
    """The name of a letter in formulas."""
    return re.sub(r"[\\{}]", "", letter)


def general(formulas: Sequence[Formula], rules: Rules, scale: Scale) -> tuple[Formula, ...]:
    """The formulas for any value of a quantity that is 1; none if they are not known."""
    own = {number for number, *_ in rules.sides}
    inner = any(each.form and each.kind is Kind.RULE and each.group not in own for each in rules.equations)
    if inner or not LETTER.fullmatch(scale.letter):
        return ()
    groups = iter(rules.sides)
    name = plain(scale.letter)

    def written(formula: Formula) -> Formula:
        if isinstance(formula, Connective | Quantified):
            return mapped(formula, written)  # type: ignore[arg-type]
        members = rules.members[next(groups)[0]]
        powers = _powers([form for _, form in members], scale.form)
        found = iter(zip(members, powers, strict=True))
        return node(formula.tag, *(_with(side, found, name) for side in formula.terms))

    try:
        return tuple(map(written, formulas))
    except NoGeneralForm:
        return ()


def _powers(forms: Sequence[Linear], one: Linear) -> list[int]:
    """How often a quantity is missing in each of several terms."""
    missing = [_times(added(forms[0], form, -1), one) for form in forms]
    return [n - min(missing) for n in missing]


def _times(form: Linear, one: Linear) -> int:
    pivot = next(iter(one))
    n: Rational = ratio(form.get(pivot, 0), one[pivot])
    if not isinstance(n, int) or added(form, one, -n) or not all(map(is_base, form)):
        raise NoGeneralForm
    return n


def _with(side: Term, found: Iterator[tuple[tuple[Term, Linear], int]], name: str) -> Term:
    """A side, each addend times its power of the quantity; those that are 0 are left as they are."""
    parts: list[Term] = []
    for sign, term in addends(side):
        if term != 0:
            (of, _), power = next(found, ((0, {}), 0))
            if of != term:
                raise NoGeneralForm
            term = term if not power else node("*", name if power == 1 else node("^", name, power), term)
        parts.append(term if sign > 0 else node("-", term))
    return parts[0] if len(parts) == 1 else node("+", *parts)
