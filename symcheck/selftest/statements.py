"""Printed statements with one slip: each must lose its proof, or be shown to say something true all the same."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cache
from itertools import islice
from random import Random
from typing import NamedTuple

from symcheck.evidence.context import Context, for_letter
from symcheck.evidence.judge import Finding, Unit, judge, units
from symcheck.evidence.obligation import obligation_of
from symcheck.evidence.record import Record
from symcheck.proof import equivalent
from symcheck.reading import Edit, Iff, edits, lower, read, to_latex
from symcheck.selftest.ends import ends
from symcheck.selftest.evidence import all_hold
from symcheck.selftest.oracle import contradicts
from symcheck.selftest.trial import Fate, FaultClass, Trial, mixed
from symcheck.statement import Hypothesis, Role, SymcheckError, Verdict

ORDERS = ("<", "<=", ">", ">=")
EQUALITY = "equality case"
RARE = (EQUALITY, "strictness", "bound", "interval end")


class Proved(NamedTuple):
    """A proved relation with the hypotheses under which it is proved."""

    context: Context
    unit: Unit
    given: tuple[Hypothesis, ...]

    @property
    def id(self) -> str:
        return self.context.id + self.unit.letter

    @property
    def equality(self) -> str:
        """Where the inequality is an equality, as declared."""
        return str(for_letter(self.context.item.equality, self.unit.letter) or "")

    @property
    def is_guarded(self) -> bool:
        """Whether a statement is one whose every slip should show.

        A sentence stays true when its condition is narrowed, and an order when its bound is loosened, unless it is
        proved together with its set of equality.
        """
        item, sign = self.context.item, self.unit.formulas[0][0]
        in_words = bool(item.formal or item.parts)
        return (
            isinstance(self.unit.tree, Iff) or not in_words or sign == "=" or (sign in ORDERS and self.equality != "")
        )


def proved(id: str) -> list[Proved]:
    """The proved relations of one declaration, corrected ones left out."""
    obligation = obligation_of(id)
    item, found = obligation.item, []
    context = Context(obligation.paper, item)
    for unit in units(context):
        imposed = bool(unit.letter) and unit.letter in item.imposed
        wrong = unit.letter in item.errata and bool(item.errata[unit.letter].corrected)
        given = item.given + (item.needs if unit.letter in item.errata else ())
        if not imposed and not wrong and judge(context, unit, given).verdict is Verdict.PROVED:
            found.append(Proved(context, unit, given))
    return found


@cache
def _guarded(id: str) -> list[Proved]:
    return [each for each in proved(id) if each.is_guarded]


def slips(original: Proved) -> Iterator[Edit]:
    """Every single edit of a statement, those of its strictness and its ends, and of its equality case."""
    tree = original.unit.tree
    yield from edits(tree, original.context.notation)
    yield from ends(tree)
    if original.equality:
        for edit in edits(read(original.equality, original.context.notation), original.context.notation):
            yield Edit(EQUALITY, edit.description, edit.tree)


def fate(original: Proved, edit: Edit) -> Fate:
    """Whether the audit rejects the statement with a slip; one that says the same, or is true too, is no fault.

    A true equation or equivalence in the place of another says as much under the hypotheses: both hold. That it is
    true rests on certificates that the checker accepts, and no point of the oracle may contradict it. An order that
    is proved says as much only with the same sides: a looser bound is a fault. One that may be an equality, nobody says
    where, is among the findings of the self-test, and so noticed.
    """
    try:
        changed = _changed(original, edit)
    except SymcheckError:
        return Fate.REJECTED  # it makes no statement
    if len(changed.unit.formulas) != len(original.unit.formulas):
        return Fate.REJECTED
    if edit.kind != EQUALITY and says_the_same(original, changed):
        return Fate.EQUIVALENT
    finding = judge(changed.context.having(doubted=True), changed.unit, changed.given)
    if finding.verdict is not Verdict.PROVED or _is_unguarded(changed):
        return Fate.REJECTED
    return Fate.EQUIVALENT if _is_as_good(original, changed, edit, finding) else Fate.ACCEPTED


def _is_unguarded(changed: Proved) -> bool:
    """Whether it may be an equality and nobody says where: that is a finding, whatever is proved."""
    return changed.unit.formulas[0][0] in ("<=", ">=") and not changed.equality


def _is_as_good(original: Proved, changed: Proved, edit: Edit, finding: Finding) -> bool:
    if not all_hold(finding.certificates) or _is_contradicted(original, changed):
        return False
    if edit.kind == EQUALITY:  # both sets are proved to be the set of equality
        return True
    sign = changed.unit.formulas[0][0]
    return sign not in ORDERS or (changed.equality != "" and _same_sides(original, changed))


def says_the_same(original: Proved, changed: Proved) -> bool:
    """Whether a slip leaves the meaning alone, instance by instance, under the hypotheses."""
    context, unit, given = original
    method = context.method(unit.letter)
    return all(
        equivalent(before, after, context.problem(("and", before, after), given, method, n))
        for n, (before, after) in enumerate(zip(unit.formulas, changed.unit.formulas, strict=True))
    )


def _is_contradicted(original: Proved, changed: Proved) -> bool:
    context, unit, given = original
    method = context.method(unit.letter)
    pairs = zip(unit.formulas, changed.unit.formulas, strict=True)
    return any(contradicts(*(context.problem(f, given, method) for f in (after, before))) for before, after in pairs)


def _same_sides(original: Proved, changed: Proved) -> bool:
    pairs = zip(original.unit.formulas, changed.unit.formulas, strict=True)
    return all(set(before[1:]) == set(after[1:]) for before, after in pairs)


def _changed(original: Proved, edit: Edit) -> Proved:
    context, unit, given = original
    if edit.kind != EQUALITY:
        return Proved(context, unit.reworded(context, edit.tree), given)
    latex = to_latex(edit.tree)
    lower(read(latex, context.notation), context.notation)
    return Proved(context.having(item=replace(context.item, equality={unit.letter: latex})), unit, given)


def places(records: Sequence[Record]) -> list[str]:
    """The ids of all declarations with a proved relation."""
    proved = (r for r in records if r.verdict is Verdict.PROVED and r.role in (Role.CLAIM, Role.OURS))
    return list(dict.fromkeys(declared(record) for record in proved))


def unguarded(records: Sequence[Record]) -> list[str]:
    """The proved inequalities that may be equalities, without a set where they are; those that are errata left out."""
    found = []
    for record in records:
        claims = [each["claim"] for each in record.certificates]
        obligation = obligation_of(declared(record))
        item, letter = obligation.item, record.id.removeprefix(obligation.id)
        if record.verdict is Verdict.PROVED and not record.corrected and claims and claims[0][0] in ("<=", ">="):
            found += [record.id] * (not for_letter(item.equality, letter))
    return found


def declared(record: Record) -> str:
    """The id of the declaration that a record is a link of."""
    try:
        return obligation_of(record.id).id
    except SymcheckError:
        return obligation_of(record.id[:-1]).id


def trials(place: str, count: int, rng: Random) -> Iterator[Trial]:
    """So many slips of the relations of one declaration."""
    by_kind: dict[str, list[tuple[Proved, Edit]]] = defaultdict(list)
    for original in _guarded(place):
        for edit in slips(original):
            by_kind[edit.kind].append((original, edit))
    for original, edit in islice(mixed(by_kind, rng, RARE), count):
        yield Trial(edit.kind, f"{original.id} {edit.description}", fate(original, edit))


CLASS = FaultClass(
    "statements",
    "printed statements with one slip, before the audit",
    (
        *("sign", "factor", "number", "index", "exponent", "term", "letter", "relation"),
        *("strictness", "bound", "interval end", EQUALITY),
    ),
    share=1000,
    places=places,
    trials=trials,
)
