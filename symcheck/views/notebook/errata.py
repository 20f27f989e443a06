"""Errata as cells show them: as printed, evaluated anew at the exact counterexample, and what is right."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from symcheck.core.certificates import Certificate
from symcheck.core.claims import Claim
from symcheck.core.ids import Id
from symcheck.core.verdicts import Group, SymcheckError
from symcheck.ledger import Record
from symcheck.views.model import Fault, Relation
from symcheck.views.notebook.counterexample import Evaluation, number, point
from symcheck.views.notebook.output import Heading, Math, Output, Part, Prose, Table
from symcheck.views.notebook.records import declared, group_of, notation, recorded, records, serious
from symcheck.views.notebook.relations import checked, digests, formula, statement


def errata(key: str) -> Output:
    """The serious errata of a paper, wrong formulas and statements: number, line, kind, whose."""
    table = (
        (each.record.number, str(each.record.line), each.name, each.record.kind, each.whose)
        for each in map(Relation, serious(key))
    )
    return Output((Table(("number", "line", "name", "kind", "whose"), tuple(table)),))


def slips(key: str) -> Output:
    """How many other relations of a paper have an erratum: rows, cells, slips; by kind, whose, recorded verdict."""
    verdicts = recorded(key)
    counts = Counter(
        (group, each.kind, str(each.origin), str(verdicts[str(Id(key, item.number, letter))]))
        for _, item in declared(key)
        if isinstance(item, Claim)
        for letter, each in item.errata.items()
        if (group := group_of(each)) is not Group.STATEMENT
    )
    table = tuple((*kinds, str(count)) for kinds, count in sorted(counts.items()))
    return Output((Table(("group", "kind", "whose", "verdict", "relations"), table),))


def erratum(id: str) -> Output:
    """A wrong relation: as printed, both sides at an exact point, the right form with its proof, whose the fault is."""
    [record] = records(id)
    if not record.is_erratum:
        raise SymcheckError(f"{id} is not an erratum; `symcheck errata` lists them")
    return Output(tuple(_erratum(record)))


def _erratum(record: Record) -> Iterator[Part]:
    relation, erratum = Relation(record), record.erratum
    number = f"**{record.paper} ({record.number})** {relation.name}"
    yield Heading(f"{number}, line {record.line} — **{record.verdict}**: {record.kind}")
    if record.words:
        yield Prose("", record.words)
    yield from statement([record])
    if record.refutation:
        yield from evaluated(record, record.refutation)
    elif erratum and erratum.empty:
        yield Prose("proved, but empty", "as printed both sides are the same, so that it says nothing")
    yield formula("right", Fault((relation,)).correct)
    if relation.added:
        yield Prose("given besides", "; ".join(relation.added))
    # What says nothing as printed is decided as it must be meant.
    label, of = ("the right form", erratum) if erratum else ("as it must be meant", record)
    yield Prose(label, f"{of.verdict}, {digests(of.certificates)}; checker: {checked(of.certificates)}")
    if relation.repairs:
        yield Prose("edits of what is printed", relation.repairs)
    yield Prose("origin", f"{relation.whose}: {record.reason}")


def evaluated(record: Record, certificate: Certificate, what: str = "the printed relation") -> Iterator[Part]:
    """A relation at the point of its refutation, computed anew, and what the checker says of it."""
    letters = notation(record.id)
    evaluation = Evaluation(certificate, letters)
    if evaluation.holds():
        raise SymcheckError(f"{record.id} holds at its counterexample, evaluated anew; run `symcheck check --no-cache`")
    if evaluation.values:
        yield formula("at the point", point(evaluation.values, letters))
    for each in evaluation.compared():
        yield formula("holds there" if each.holds else "fails there", each.statement)
        yield Math("that is", rf"{number(each.left)} \quad {each.sign} \quad {number(each.right)}")
    yield Prose("checker", f"{checked([certificate])}, so that {what} is refuted")
