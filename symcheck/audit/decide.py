"""From a declaration to its ledger rows: what the command line calls, and a worker process runs."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence

from msgspec.structs import replace

from symcheck.audit.checked import proofs
from symcheck.audit.context import Context
from symcheck.audit.dimensions import of_formulas, of_text
from symcheck.audit.judge import Unit, judge, problems, units
from symcheck.audit.needs import Proved, listed, need
from symcheck.audit.obligation import Obligation, expand, fingerprint, obligation_of, placed, users
from symcheck.audit.repair import corrected
from symcheck.core.claims import Assertion, Declaration, Erratum, Hypothesis
from symcheck.core.ids import Id
from symcheck.core.verdicts import Origin, Reading, Role
from symcheck.ledger import Correction, Record
from symcheck.papers.places import places
from symcheck.reading import read, to_latex

__all__ = ["decide", "decide_declared", "expand", "fingerprint", "placed", "weigh"]


def decide(id: str) -> tuple[Record, ...]:
    """The records of one declaration: one for each relation it prints."""
    return decide_declared(obligation_of(id))


def decide_declared(obligation: Obligation) -> tuple[Record, ...]:
    """The same for a declaration that need not be that of the paper: one that somebody has changed."""
    paper, item, base = obligation.paper, obligation.item, _base(obligation)
    notation = item.notation or paper.notation
    if item.question:
        return item.question.records(item, base)
    if isinstance(item, Assertion):
        return tuple(_claimed(Context(paper, item), base))
    if not item.text:
        return (base,)
    dimension = of_text(item.text, notation)
    return (replace(base, read=to_latex(read(item.text, notation)), dimension=dimension),)


def weigh(declared: tuple[str, Sequence[Record]]) -> tuple[Record, ...]:
    """The id of a declaration with its records: these, with which hypotheses are needed, and what shows it."""
    id, records = declared
    obligation = obligation_of(id)
    if not isinstance(obligation.item, Assertion) or obligation.item.question:
        return tuple(records)
    context = Context(obligation.paper, obligation.item)
    by_id = {id + unit.letter: unit for unit in units(context)} if any(map(proofs, records)) else {}
    return tuple(_weighed(context, by_id.get(record.id), record) for record in records)


def _weighed(context: Context, unit: Unit | None, record: Record) -> Record:
    item, proved = context.item, list[Proved]()
    if unit and (evidence := proofs(record)):
        given = (*item.statement.given, *_added(item.erratum(unit.letter)))
        proved = [*zip(problems(context, unit, given), evidence, strict=True)]
    return replace(record, hypotheses=tuple(replace(row, need=need(row, proved, item)) for row in record.hypotheses))


def _base(obligation: Obligation) -> Record:
    item, paper = obligation.item, obligation.paper
    record = Record(
        id=obligation.id,
        paper=paper.key,
        section=obligation.section.number,
        line=item.source.line,
        role=item.role,
        reading=_of_sound_text(item),
        name=item.name,
        printed="\n".join(item.source.printed),
        words=item.source.words,
        place=_place(paper.key, item.number),
        reason=item.reason,
        uses=tuple(str(Id.of(paper.key, place)) for place in item.uses),
        used_by=users(paper.key).get(item.number, ()),
    )
    if (damage := item.source.damage) is None:
        return record
    reading = Reading.MISPRINT if damage.origin is Origin.PAPER else Reading.DAMAGED
    return replace(record, reading=reading, kind=damage.kind, origin=damage.origin, corrected=damage.read_as)


def _of_sound_text(item: Declaration) -> Reading:
    if item.source.printed:
        return Reading.AS_PRINTED
    return Reading.ADDED if item.role is Role.OURS else Reading.WORDS


def _place(key: str, number: str) -> str:
    found = places(key).get(number)
    return f"line {found.line}: {found}" if found else ""


def _claimed(context: Context, base: Record) -> Iterator[Record]:
    source, links = context.item.source, units(context)
    for place, unit in enumerate(links):
        started = time.perf_counter()
        line = source.lines.get(unit.letter, source.line)
        row = replace(base, id=base.id + unit.letter, read=to_latex(unit.tree), line=line)
        row = replace(row, dimension=of_formulas(unit.formulas, context.notation))
        if len(source.printed) == len(links) > 1:
            row = replace(row, printed=source.printed[place])
        if source.damage and source.damage.spares(unit.letter):
            row = _undamaged(context, row)
        if context.item.statement.imposes(unit.letter):
            yield replace(_undamaged(context, row), role=Role.PREMISE, reason="a condition imposed here, not a claim")
            continue
        row = replace(_judged(context, unit, row), method=context.method(unit.letter).name)
        yield replace(row, seconds=round(time.perf_counter() - started, 4))


def _undamaged(context: Context, row: Record) -> Record:
    """A link of which nothing is to be read otherwise."""
    return replace(row, reading=_of_sound_text(context.item), kind="", origin=None, corrected="", reason="")


def _measured(correction: Correction, erratum: Erratum, context: Context) -> Correction:
    """The correction with what the right form measures, if it is another one than that printed."""
    of = of_text(erratum.corrected, context.notation) if erratum.corrected else None
    return replace(correction, dimension=of)


def _added(erratum: Erratum | None) -> tuple[Hypothesis, ...]:
    """The hypotheses under which a relation is proved, though the paper forgot them."""
    return erratum.needs if erratum and not erratum.corrected else ()


def _judged(context: Context, unit: Unit, row: Record) -> Record:
    item = context.item
    erratum = item.erratum(unit.letter)
    finding = judge(context.having(doubted=erratum is not None), unit, item.statement.given)
    row = replace(
        row,
        verdict=finding.verdict,
        reason=finding.reason or row.reason,
        certificates=finding.certificates,
    )
    if erratum:
        misprint = bool(erratum.corrected)
        row = replace(
            row,
            reading=Reading.MISPRINT if misprint else Reading.NEEDS_HYPOTHESIS,
            kind=erratum.kind,
            origin=erratum.origin,
            reason=erratum.reason,
            corrected=erratum.shown
            or erratum.corrected
            or f"{to_latex(unit.tree)} (given: {'; '.join(h.words for h in erratum.needs)})",
            erratum=_measured(corrected(context, unit, erratum, finding), erratum, context),
        )
    row = replace(row, hypotheses=tuple(listed(item, _added(erratum))))
    row.refuse_wider()
    if row.reading is Reading.AS_PRINTED and _is_standing(row):
        row = replace(row, reading=Reading.STANDING)
    return row


def _is_standing(row: Record) -> bool:
    """Whether the proof uses a condition that the paper does not print."""
    standing = {hypothesis.name for hypothesis in row.hypotheses if hypothesis.given == "standing"}
    return not standing.isdisjoint((row.domain or {}).get("hypotheses", ()))
