"""Errata as cells show them: as printed, evaluated anew at the exact counterexample, and what is right."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import Any

from symcheck.core.claims import Claim
from symcheck.core.ids import Id
from symcheck.core.verdicts import Group, SymcheckError, Verdict
from symcheck.ledger.record import Record
from symcheck.views.notebook.counterexample import Evaluation, number, point
from symcheck.views.notebook.records import declared, group_of, notation, recorded, records, serious
from symcheck.views.notebook.relations import checked, digests, formula, statement
from symcheck.views.notebook.shown import Heading, Math, Part, Prose, Shown, Table


def errata(key: str) -> Shown:
    """The serious errata of a paper, wrong formulas and statements: number, line, kind, whose."""
    table = (
        (Id.parse(record.id).place, str(record.line), record.name.replace("_", " "), record.kind, str(record.origin))
        for record in serious(key)
    )
    return Shown((Table(("number", "line", "name", "kind", "whose"), tuple(table)),))


def slips(key: str) -> Shown:
    """How many other relations of a paper have an erratum: rows, cells, slips; by kind, whose, recorded verdict."""
    verdicts = recorded(key)
    counts = Counter(
        (group, each.kind, str(each.origin), str(verdicts[str(Id(key, item.number, letter))]))
        for _, item in declared(key)
        if isinstance(item, Claim)
        for letter, each in item.errata.items()
        if (group := group_of(each)) is not Group.STATEMENT
    )
    table = tuple((*told, str(count)) for told, count in sorted(counts.items()))
    return Shown((Table(("group", "kind", "whose", "verdict", "relations"), table),))


def erratum(id: str) -> Shown:
    """A wrong relation: as printed, both sides at an exact point, the right form with its proof, whose the fault is."""
    [record] = records(id)
    if not record.corrected:
        raise SymcheckError(f"{id} is no erratum; `symcheck errata` lists them")
    return Shown(tuple(_erratum(record)))


def _erratum(record: Record) -> Iterator[Part]:
    id, name = Id.parse(record.id), record.name.replace("_", " ")
    yield Heading(f"**{id.paper} ({id.place})** {name}, line {record.line} — **{record.verdict}**: {record.kind}")
    if record.words:
        yield Prose("", record.words)
    yield from statement([record])
    refuting = [each for each in record.certificates if each["verdict"] == Verdict.REFUTED]
    yield from _evaluated(record, refuting[0]) if refuting else _empty(record)
    yield formula("right", record.corrected.partition(" (given: ")[0])
    yield from _repair(record.erratum) if record.erratum else _reread(record)
    yield Prose("whose fault", f"{record.origin}. {record.reason}")


def _evaluated(record: Record, certificate: Any) -> Iterator[Part]:
    letters = notation(record.id)
    evaluation = Evaluation(certificate, letters)
    if evaluation.holds():
        raise SymcheckError(f"{record.id} holds at its counterexample, evaluated anew; run `symcheck check --no-cache`")
    if evaluation.values:
        yield formula("at the point", point(evaluation.values, letters))
    for each in evaluation.compared():
        yield formula("holds there" if each.holds else "fails there", each.statement)
        yield Math("that is", rf"{number(each.left)} \quad {each.sign} \quad {number(each.right)}")
    yield Prose("checker", f"{checked([certificate])}, so that the printed relation is refuted")


def _empty(record: Record) -> Iterator[Part]:
    if (record.erratum or {}).get("empty"):
        yield Prose("proved, but empty", "as printed both sides are the same, so that it says nothing")


def _reread(record: Record) -> Iterator[Part]:
    """What says nothing as printed is decided as it must be meant."""
    yield Prose(
        "as it must be meant",
        f"{record.verdict}, {digests(record.certificates)}; checker: {checked(record.certificates)}",
    )


def _repair(repair: dict[str, Any]) -> Iterator[Part]:
    if repair.get("added"):
        yield Prose("given besides", "; ".join(repair["added"]))
    proofs = list(repair["certificates"])
    yield Prose("the right form", f"{repair['verdict']}, {digests(proofs)}; checker: {checked(proofs)}")
    if repair.get("repairs") is not None:
        yield Prose("single edits of what is printed that make it true", str(len(repair["repairs"])))
