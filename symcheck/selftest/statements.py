"""Printed statements with one slip: each must lose its proof, or be shown to say something true all the same.

Slips are planted in every proved relation, whatever its form, and in what the misprinted ones should be. A slip goes
the way of the printed text: it is printed, read again and lowered, so that what the reader drops is an accepted fault.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cache
from itertools import starmap
from random import Random
from typing import NamedTuple

from symcheck.audit import Context, Finding, Unit, context_of, obligation_of, units
from symcheck.audit.dimensions import of_formulas
from symcheck.audit.judge import judge
from symcheck.core.claims import Erratum, Hypothesis, for_letter
from symcheck.core.ids import Id
from symcheck.core.problems import Problem
from symcheck.core.terms import Formula, node
from symcheck.core.verdicts import Role, SymcheckError, Verdict
from symcheck.dimensions import INCONSISTENT
from symcheck.ledger import Record
from symcheck.proof import fails_without
from symcheck.reading import Edit, Tree, edits, lower, read, to_latex
from symcheck.selftest.evidence import holds, ledger_verdict, states
from symcheck.selftest.oracle import fails
from symcheck.selftest.slips import KINDS, RARE, every_slip, is_dropped, slips_of, stronger, trials_of
from symcheck.selftest.strength import compared, same
from symcheck.selftest.trial import FaultClass, Status, Trial

EQUALITY = "equality case"


class Proved(NamedTuple):
    """A proved relation with the hypotheses under which it is proved, and what the audit found."""

    context: Context
    unit: Unit
    given: tuple[Hypothesis, ...]
    finding: Finding | None = None

    @property
    def id(self) -> str:
        return self.context.id + self.unit.letter

    @property
    def equality(self) -> str:
        """Where the inequality is an equality, as declared."""
        return for_letter(self.context.item.statement.equality, self.unit.letter) or ""

    def both(self, changed: Proved) -> Iterator[Problem]:
        """Both claims, instance by instance, under the hypotheses."""
        method = self.context.method(self.unit.letter)
        for n, pair in enumerate(zip(self.unit.formulas, changed.unit.formulas, strict=True)):
            yield self.context.problem(node("and", *pair), self.given, method, n)


def proved(id: str) -> list[Proved]:
    """The proved relations of one declaration; of misprinted ones, what is right."""
    context, relations = context_of(obligation_of(id)), []
    for unit in units(context):
        if context.item.statement.imposes(unit.letter):
            continue
        erratum = context.item.erratum(unit.letter)
        relation = Proved(context, unit, context.item.statement.given + (erratum.needs if erratum else ()))
        if erratum and erratum.corrected:
            relation = _corrected(relation, erratum)
        finding = judge(relation.context, relation.unit, relation.given)
        if ledger_verdict(relation.context, relation.unit, finding) is Verdict.PROVED:
            relations.append(relation._replace(finding=finding))
    return relations


def _corrected(printed: Proved, erratum: Erratum) -> Proved:
    """The relation as it should be, proved with its own hints."""
    context = printed.context.as_corrected(erratum)
    return Proved(context, printed.unit.reworded(context, read(erratum.corrected, context.notation)), printed.given)


_proved = cache(proved)


def slips(original: Proved) -> Iterator[Edit]:
    """Every single edit of a statement, of its ends, arguments, connectives and equality case; none twice."""
    tree, notation = original.unit.tree, original.context.notation
    yield from every_slip(tree, notation)
    if original.equality:
        for edit in edits(read(original.equality, notation), notation):
            yield Edit(EQUALITY, edit.description, edit.tree)


def status_of(original: Proved, edit: Edit) -> Status:
    """What the ledger makes of a statement with a slip.

    If the ledger calls it proved, it is true if the certificates claim just this and no point of the oracle
    contradicts; then it is compared with the printed one. Otherwise it is a fault if it fails somewhere, else open.
    """
    try:
        changed = with_slip(original, edit)
        if _is_lost_in_reading(original, edit):
            return Status.ACCEPTED  # the reader drops the slip
        if edit.kind != EQUALITY and says_the_same(original, changed):
            return Status.EQUIVALENT
        finding = judge(changed.context.having(doubted=True), changed.unit, changed.given)
    except SymcheckError:
        return Status.REJECTED  # it makes no statement
    verdict = ledger_verdict(changed.context, changed.unit, finding)
    if verdict is Verdict.PROVED:
        true = states(finding, changed.unit.formulas) and not is_false(original, finding)
        return _strength(original, changed, edit) if true else Status.ACCEPTED
    return Status.REJECTED if verdict is Verdict.REFUTED or is_false(original, finding) else Status.OPEN


def is_misfit(original: Proved, edit: Edit) -> bool:
    """Whether the dimensions of a statement with a slip do not fit."""
    try:
        changed = with_slip(original, edit)
    except SymcheckError:
        return False
    return of_formulas(changed.unit.formulas, original.context.notation).verdict == INCONSISTENT


def with_slip(original: Proved, edit: Edit) -> Proved:
    """The relation with a slip, printed and read again."""
    context, unit, given, _ = original
    latex = to_latex(edit.tree)
    tree = read(latex, context.notation)
    if edit.kind != EQUALITY:
        return Proved(context, unit.reworded(context, tree), given)
    lower(tree, context.notation)
    statement = replace(context.item.statement, equality={unit.letter: latex})
    return Proved(context.having(item=replace(context.item, statement=statement)), unit, given)


def _is_lost_in_reading(original: Proved, edit: Edit) -> bool:
    """Whether the reader, or the way from what is read to formulas, forgets that there is a slip."""

    def stated(tree: Tree) -> tuple[Formula, ...]:
        if edit.kind == EQUALITY:
            return lower(tree, original.context.notation)
        return original.unit.reworded(original.context, tree).formulas

    before = read(original.equality, original.context.notation) if edit.kind == EQUALITY else original.unit.tree
    return is_dropped(before, edit.tree, stated)


def says_the_same(original: Proved, changed: Proved) -> bool:
    """Whether a slip leaves the meaning alone, instance by instance, under the hypotheses."""
    if len(original.unit.formulas) != len(changed.unit.formulas):
        return False
    return all(starmap(same, zip(original.unit.formulas, changed.unit.formulas, original.both(changed), strict=True)))


def is_false(original: Proved, finding: Finding) -> bool:
    """Whether what is claimed fails somewhere: at an exact point of a certificate, or at one of the oracle."""
    if any(evidence["verdict"] == Verdict.REFUTED and holds(evidence) for evidence in finding.certificates):
        return True
    witnesses = original.finding.certificates if original.finding else ()
    failing = [fails(problem, witnesses) for problem in finding.concrete]
    if finding.verdict is Verdict.PROVED or True in failing:
        return True in failing
    return any(_is_refuted(problem) for problem, f in zip(finding.concrete, failing, strict=True) if f is None)


def _is_refuted(problem: Problem) -> bool:
    """Whether a search beyond that of the audit finds where the claim fails, or that nothing of the kind exists."""
    lost = fails_without(problem)
    return lost is not None and holds(lost.certificate)


def _strength(original: Proved, changed: Proved, edit: Edit) -> Status:
    """How much a true statement says, in the place of another; both sets of equality are just where it is one."""
    if edit.kind == EQUALITY:
        return Status.EQUIVALENT
    before, after = original.unit.formulas, changed.unit.formulas
    if len(before) != len(after):  # instances dropped or added
        return Status.WEAKER if {*after} <= {*before} else Status.STRONGER if {*before} <= {*after} else Status.OPEN
    statuses = {compared(*pair) for pair in zip(before, after, original.both(changed), strict=True)}
    for whole in (Status.EQUIVALENT, Status.WEAKER, Status.STRONGER):
        if statuses <= {whole, Status.EQUIVALENT}:
            return whole
    return Status.OPEN


def says_more(id: str) -> list[str]:
    """A line for each statement that holds in the place of a printed one and says more, of those that are tried.

    Tried are the converse of an implication, `and` for `or`, and an equation for an order, unless a set of equality is
    declared.
    """
    found = []
    for original in _proved(id):
        for edit in () if original.equality else slips_of(stronger, original.unit.tree):
            if status_of(original, edit) is Status.STRONGER:
                found.append(f"{original.id}: more is true ({edit.description})")
    return found


def places(records: Sequence[Record]) -> list[str]:
    """The ids of all declarations with a proved relation, or a misprinted one."""
    decided = (r for r in records if r.verdict in (Verdict.PROVED, Verdict.REFUTED))
    claims = (r for r in decided if r.role in (Role.CLAIM, Role.OURS))
    return list(dict.fromkeys(declared(record) for record in claims))


def unguarded(records: Sequence[Record]) -> list[str]:
    """The proved inequalities that may be equalities, without a set where they are; those that are errata left out."""
    found = []
    for record in records:
        claims = [evidence["claim"] for evidence in record.certificates]
        if record.verdict is Verdict.PROVED and not record.corrected and claims and claims[0][0] in ("<=", ">="):
            statement = context_of(obligation_of(declared(record))).item.statement
            found += [record.id] * (not for_letter(statement.equality, Id.parse(record.id).link))
    return found


def declared(record: Record) -> str:
    """The id of the declaration that a record is a link of."""
    return str(Id.parse(record.id).declaration)


def trials(place: str, count: int, rng: Random) -> Iterator[Trial]:
    """So many slips of the relations of one declaration."""
    return trials_of(_proved(place), slips, status_of, count, rng, (EQUALITY, *RARE), is_misfit)


CLASS = FaultClass(
    "statements",
    "printed statements with one slip, before the audit",
    (*KINDS, EQUALITY),
    share=1000,
    places=places,
    trials=trials,
    by_paper=True,
)
