"""The verdict on the dimensions of a relation, beside that on its truth, with its certificate."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import combinations
from math import lcm
from typing import Any, NamedTuple

from msgspec import Struct

from symcheck.core.terms import Formula, Term
from symcheck.core.words import term as words
from symcheck.dimensions.certificates import unlike, written
from symcheck.dimensions.general import general, plain
from symcheck.dimensions.numbers import numbers_may_measure
from symcheck.dimensions.rules import Atom, Equation, Kind, Linear, Rational, Rules, Scale, is_base, scaled_equations
from symcheck.dimensions.solve import Combination, System, is_letter, smallest, solved
from symcheck.dimensions.units import shown

CONSISTENT, INCONSISTENT, UNDETERMINED = "consistent", "inconsistent", "undetermined"
NUMBER = "what has to be a number"
DECIMAL = re.compile(r"\d(?:\.|\{?,\}?)\d")  # with a full stop or a comma, perhaps in braces
NUMBERS = "its numbers may measure something"
LONGEST = 200  # characters of a term in a message
ROUNDS = 3  # of putting what is found into powers with a letter in the exponent


class Conflicting(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A term and what it measures."""

    term: str
    measures: str


class Dimensions(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What can be said of the dimensions of a relation.

    Parameters
    ----------
    verdict
        "consistent", "inconsistent" or "undetermined".
    sides
        What both sides measure, in base units; "1" for a number, "?" for what is not known, "any" for 0.
    conflict
        The smallest set of terms found that do not fit together, and what each measures; those in the minority first.
    undetermined
        Letters whose units would settle it.
    letters
        What letters of which nothing was said measure, as the relation itself says.
    scales
        Quantities that the relation supposes to be 1, such as "h_max = 1".
    general
        The relation with the powers of these that were left out: its formulas.
    reason
        Why nothing is decided, or what is wrong, in one sentence.
    certificate
        What `symcheck.dimensions.certificates` checks.
    """

    verdict: str
    sides: tuple[str, ...] = ()
    conflict: tuple[Conflicting, ...] = ()
    undetermined: tuple[str, ...] = ()
    letters: dict[str, str] = {}
    scales: tuple[str, ...] = ()
    general: tuple[Any, ...] = ()
    reason: str = ""
    certificate: dict[str, Any] = {}


def dimensions(
    formulas: Sequence[Formula],
    known: Mapping[str, Linear | None],
    scales: Sequence[Scale] = (),
    cautious: bool = False,
) -> Dimensions:
    """The verdict on a relation.

    Parameters
    ----------
    formulas
        The relation, lowered: one formula for each component.
    known
        The forms of its letters, and of the values of its functions, as far as they are known.
    scales
        Quantities that may be set to 1; they are if the relation is consistent in no other way.
    cautious
        Whether a conflict that may come from numbers which measure something, as in x = 3 t^2, is none.

    Returns
    -------
    Dimensions
        The verdict. What is not understood is undetermined, never inconsistent.
    """
    try:
        found = _solved(formulas, known)
    except RecursionError:
        return Dimensions(verdict=UNDETERMINED, reason="its terms are nested too deeply")
    if found.conflict is None:
        return _told(formulas, found)
    for some in (some for count in range(1, len(scales) + 1) for some in combinations(scales, count)):
        scaled = _of_equations(found.rules, some)
        if scaled.conflict is None and (told := _told(formulas, scaled)).verdict == CONSISTENT:
            return told
    if cautious and numbers_may_measure(formulas, [found.equations[number] for number in found.smallest]):
        return Dimensions(verdict=UNDETERMINED, reason=NUMBERS)
    return _inconsistent(found)


def of_printed(
    text: str,
    formulas: Sequence[Formula],
    known: Mapping[str, Linear | None],
    scales: Sequence[Scale] = (),
    cautious: bool = False,
) -> Dimensions:
    """The verdict on a relation as it is printed: decimals, which are fractions in formulas, may measure something."""
    found = dimensions(formulas, known, scales, cautious)
    if cautious and found.verdict == INCONSISTENT and DECIMAL.search(text):
        return Dimensions(verdict=UNDETERMINED, reason=NUMBERS)
    return found


def inferred(formulas: Sequence[Formula], known: Mapping[str, Linear | None]) -> dict[str, Linear]:
    """The letters of which formulas tell what they measure, if they are consistent."""
    found = _solved(formulas, known)
    return {} if found.conflict is not None else found.letters()


class Solved(NamedTuple):
    """The equations of formulas where some quantities are 1, solved, or what contradicts the others."""

    rules: Rules
    scales: tuple[Scale, ...]
    equations: list[Equation]
    system: System
    conflict: Combination | None

    @property
    def binding(self) -> list[int]:
        """The numbers of the equations that must hold."""
        return [number for number, each in enumerate(self.equations) if each.kind is Kind.RULE]

    @property
    def smallest(self) -> Combination:
        """The conflict in as few equations as can be found."""
        assert self.conflict is not None
        return smallest(self.equations, self.conflict, self.binding)

    def letters(self) -> dict[str, Linear]:
        """The letters of which the equations tell what they measure."""
        values = {atom: self.system.value({atom: 1}) for atom in self.system.pivots if is_letter(atom)}
        return {str(atom): value for atom, value in values.items() if all(map(is_base, value))}


def _solved(formulas: Sequence[Formula], known: Mapping[str, Linear | None]) -> Solved:
    """The equations, solved; again where what is found stands in a power with a letter in the exponent."""
    for _ in range(ROUNDS):
        rules = Rules(known)
        for formula in formulas:
            rules.state(formula)
        found = _of_equations(rules, ())
        powers = {atom[1] for each in rules.equations for atom in each.form if isinstance(atom, tuple)}
        more = {x: f for x, f in found.letters().items() if x in powers} if powers else {}
        if found.conflict is not None or not more:
            break
        known = {**known, **more}
    return found


def _of_equations(rules: Rules, scales: tuple[Scale, ...]) -> Solved:
    equations = scaled_equations(rules.equations, scales)
    found = Solved(rules, scales, equations, System(), None)
    system, conflict = solved(equations, found.binding)
    return found._replace(system=system, conflict=conflict)


def _told(formulas: Sequence[Formula], found: Solved) -> Dimensions:
    """What follows from equations that do not contradict one another."""
    rules, system = found.rules, found.system
    told = tuple(f"{scale.letter} = 1" for scale in found.scales)
    doubted = list[str]()
    for kind in (Kind.ARGUMENT, Kind.DEFAULT):
        for number, each in enumerate(found.equations):
            if each.kind is kind and system.add(number, each.form) is not None and kind is Kind.ARGUMENT:
                doubted.append(f"{_short(each.first)} and what stands elsewhere in {_short(each.second)} differ")
    values = {pivot: system.value({pivot: 1}) for pivot in system.pivots}
    open_ = {atom for value in values.values() for atom in value if not _is_known(atom)}
    open_ |= {pivot for pivot in values if isinstance(pivot, tuple) or pivot in rules.opaque}
    letters = {x: shown(_of(form)) for x, form in found.letters().items()}
    sides = _sides(found, system)
    if not doubted and not open_:
        certificate = _certificate(found) | {"letters": written({str(atom): form for atom, form in values.items()})}
        if (why := unlike(certificate, found.equations)) is None:
            return Dimensions(
                verdict=CONSISTENT,
                sides=sides,
                letters=letters,
                scales=told,
                general=_general(formulas, found),
                certificate=certificate,
            )
        doubted.append(f"the certificate was not accepted ({why})")
    opaque = [rules.opaque[str(x)] for x in sorted(map(str, open_)) if x in rules.opaque]
    reasons = [*doubted, *(f"nothing is known of what this measures: {_cut(text)}" for text in opaque)]
    wanted = {x for atom in open_ for x in ((*atom[0], atom[1]) if isinstance(atom, tuple) else (atom,))}
    named = sorted({x for each in wanted if (x := _bare(each)).isidentifier()})
    return Dimensions(
        verdict=UNDETERMINED, sides=sides, undetermined=tuple(named), letters=letters, reason="; ".join(reasons)
    )


def _general(formulas: Sequence[Formula], found: Solved) -> tuple[Formula, ...]:
    """The relation for any value of what is 1, if it is consistent."""
    if len(found.scales) != 1:
        return ()
    (scale,) = found.scales
    formulas = general(formulas, found.rules, scale)
    holds = bool(formulas) and _solved(formulas, {**found.rules.used, plain(scale.letter): scale.form}).conflict is None
    return formulas if holds else ()


def _is_known(atom: Atom) -> bool:
    return is_base(atom[1] if isinstance(atom, tuple) else atom)


def _bare(atom: str) -> str:
    """The letter of an atom that is none itself: a bound one, the place of a function, or that of a logarithm."""
    return atom.removeprefix("log ").partition("@")[0].partition("#")[0]


def _certificate(found: Solved) -> dict[str, Any]:
    return {
        "units": written(found.rules.used),
        "scales": written({scale.letter: scale.form for scale in found.scales}),
    }


def _sides(found: Solved, system: System, group: int = 0) -> tuple[str, ...]:
    """What both sides measure, of the relation in question or of the first."""
    every = found.rules.sides
    own = [each for each in every if each[0] == group] or every[:1]
    return tuple("any" if form is None else shown_form(system.value(form)) for _, *both in own for form in both)


def shown_form(form: Linear) -> str:
    """The spelling of a dimension, "?" if it is not known."""
    return shown(_of(form)) if all(map(is_base, form)) else "?"


def _of(form: Linear) -> dict[str, Fraction]:
    return {str(atom)[1:-1]: Fraction(n) for atom, n in form.items()}


def _short(of: object) -> str:
    return _cut(words(of))


def _cut(text: str) -> str:
    return text if len(text) <= LONGEST else text[: LONGEST - 1] + "…"


def _inconsistent(found: Solved) -> Dimensions:
    """The conflict in as few equations as can be found, with the terms that do not fit."""
    equations, conflict = found.equations, found.smallest
    *others, last = sorted(conflict)
    below = lcm(*(Fraction(n).denominator for n in conflict.values()))
    combination = [[number, int(conflict[number] * below)] for number in (*others, last)]
    certificate = _certificate(found) | {"combination": combination}
    if (why := unlike(certificate, equations)) is not None:
        return Dimensions(verdict=UNDETERMINED, reason=f"the certificate was not accepted ({why})")
    system, _ = solved(equations, others)
    return Dimensions(
        verdict=INCONSISTENT,
        sides=_sides(found, system, equations[last].group),
        conflict=tuple(
            Conflicting(term=NUMBER if term is None else _short(term), measures=shown_form(form))
            for term, form in _members(found.rules, system, equations[last])
        ),
        reason="; ".join(_said(equations[number]) for number in others),
        certificate=certificate,
    )


def _said(each: Equation) -> str:
    if each.second is None:
        return f"{_short(each.first)} is a number"
    return f"{_short(each.first)} measures what {_short(each.second)} does"


def _members(rules: Rules, system: System, last: Equation) -> list[tuple[Term | None, Linear]]:
    """The terms of a sum or relation that are in the minority, and one of the others; or the two that differ."""
    two = [(last.first, system.value(last.forms[0])), (last.second, system.value(last.forms[1]))]
    classes = dict[frozenset[tuple[Atom, Rational]], list[tuple[Term | None, Linear]]]()
    for term, form in rules.members.get(last.group, ()) if last.second is not None else ():
        value = system.value(form)
        if not all(map(is_base, value)):
            return two
        classes.setdefault(frozenset(value.items()), []).append((term, value))
    *few, most = sorted(classes.values(), key=len) if classes else [[]]
    tied = any(len(some) == len(most) for some in few)
    return [*(each for some in few for each in (some[:1] if tied else some)), *most[:1]] if few else two
