"""Only what the checker accepts is reported: every certificate of every row, cached or new, goes through it.

Nothing is trusted beforehand, neither the provers nor the cache. A verdict whose certificates are not accepted becomes
undecided, and the same holds for what a correction is said to be, and for whether a hypothesis is needed.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING

from msgspec.structs import replace

from symcheck.checker import check_all
from symcheck.core.certificates import Certificate
from symcheck.core.verdicts import Loss, Reading, Verdict
from symcheck.ledger import Correction, HypothesisRow, Need, Record, lemmas_of, reached

if TYPE_CHECKING:
    from multiprocessing.connection import Connection

FOR_EQUALITY = "for the set of equality"  # of a hypothesis that is in force nowhere else
MANY = 500  # certificates that take longer than it takes to start another process
NOT_ACCEPTED = "the certificate was not accepted"


def reasons(certificates: Sequence[Certificate]) -> list[str | None]:
    """For each certificate None if the checker accepts it, else why not; lemmas are looked for among all of them."""
    return [*check_all(certificates)]


def _reasons(certificates: Sequence[Certificate]) -> list[str | None]:
    """The same; if there are many, half of them in another process."""
    if len(certificates) < MANY or not _may_fork():
        return reasons(certificates)
    from multiprocessing import get_context

    context = get_context("fork")
    receiver, sender = context.Pipe(duplex=False)
    half = len(certificates) // 2  # neighbours have the same definitions and hypotheses, which are read once
    own, other = (_with_lemmas(part, certificates) for part in (certificates[:half], certificates[half:]))
    helper = context.Process(target=_send, args=(sender, other), daemon=True)
    helper.start()
    sender.close()
    found = reasons(own)[:half]
    try:
        answers: list[str | None] = receiver.recv()
    except (EOFError, OSError):  # it was killed
        answers = reasons(other)
    helper.join()
    return found + answers[: len(certificates) - half]


def _may_fork() -> bool:
    """Whether there are two processors, and no other thread that a fork would stop halfway."""
    return sys.platform == "linux" and len(os.sched_getaffinity(0)) > 1 and len(os.listdir("/proc/self/task")) == 1


def _with_lemmas(part: Sequence[Certificate], certificates: Sequence[Certificate]) -> list[Certificate]:
    """Some certificates, and behind them those of their lemmas, and of the lemmas of these."""
    by_id: dict[str, list[Certificate]] = {}
    for each in certificates:
        by_id.setdefault(each.get("id", ""), []).append(each)
    names = reached(lemmas_of(part), lambda name: lemmas_of(by_id.get(name, ())))
    return [*part, *(each for name in names for each in by_id.get(name, ()))]


def _send(sender: Connection, certificates: Sequence[Certificate]) -> None:
    with suppress(KeyboardInterrupt, BrokenPipeError):
        sender.send(reasons(certificates))


Rows = Mapping[str, tuple[Record, ...]]  # by declaration


def accepted(rows: Rows, further: Rows = MappingProxyType({})) -> dict[str, tuple[Record, ...]]:
    """The records as the checker accepts them; lemmas may also be among the certificates of `further` records."""
    records = [record for each in rows.values() for record in each]
    others = (record for each in further.values() for record in each)
    every = [
        certificate for record in (*records, *_lemmas(records, others)) for certificate in record.all_certificates()
    ]
    answers = Answers({id(each): reason for each, reason in zip(every, _reasons(every), strict=True)})
    return {name: tuple(_accepted(record, answers) for record in each) for name, each in rows.items()}


def _lemmas(records: Iterable[Record], others: Iterable[Record]) -> list[Record]:
    """Those of the others on which the records rest, and those on which these rest."""
    known = {record.id: record for record in others}
    own = [certificate for record in records for certificate in record.all_certificates()]
    names = reached(lemmas_of(own), lambda name: lemmas_of(known[name].all_certificates()) if name in known else ())
    return [known[name] for name in names if name in known]


@dataclass(frozen=True)
class Answers:
    """What the checker said of certificates: None where it accepts one, else the reason; by their identity."""

    refusals: Mapping[int, str | None]

    def fault(self, of: str, verdict: Verdict | None, own: Sequence[Certificate]) -> str | None:
        """Why certificates do not show this verdict of the relation `of`; None if they do, or if it needs none."""
        if verdict not in (Verdict.PROVED, Verdict.REFUTED):
            return None
        if verdict not in (verdicts := {each.get("verdict") for each in own}):
            return "there is none"
        if verdict == Verdict.PROVED and verdicts != {verdict}:
            return "one of them says otherwise"
        if other := [each for each in own if each.get("id") != of]:
            return f"it is of {other[0].get('id')}"
        return next((reason for each in own if (reason := self.refusals[id(each)]) is not None), None)


def _accepted(record: Record, answers: Answers) -> Record:
    """A record without what its certificates do not show."""
    fault = answers.fault(record.id, record.verdict, record.certificates)
    result = replace(record, erratum=_correction(record, answers))
    if fault is not None:
        result = replace(result, verdict=Verdict.UNDECIDED, reason=_reason(fault), certificates=())
    return replace(result, hypotheses=tuple(_need(result, hypothesis, answers) for hypothesis in record.hypotheses))


def _reason(fault: str) -> str:
    return f"{NOT_ACCEPTED} ({fault})"


def _correction(record: Record, answers: Answers) -> Correction | None:
    """What is said of the right form; undecided if its certificates do not show it."""
    erratum = record.erratum
    if erratum is None or (fault := answers.fault(record.id, erratum.verdict, erratum.certificates)) is None:
        return erratum
    return replace(erratum, verdict=Verdict.UNDECIDED, reason=_reason(fault), certificates=())


def _need(record: Record, row: HypothesisRow, answers: Answers) -> HypothesisRow:
    """Whether a hypothesis is needed; unknown if what is said of it is not shown."""
    need = row.need
    if need is None:
        return row
    if need.needed is None:
        holds = not need.lost and not need.certificates
    else:
        try:
            holds = bool(proofs(record)) and (_is_lost if need.needed else _is_needless)(record, row, need, answers)
        except (LookupError, TypeError, AttributeError):  # of a malformed certificate
            holds = False
    return row if holds else replace(row, need=Need(needed=None))


def _is_lost(record: Record, row: HypothesisRow, need: Need, answers: Answers) -> bool:
    """Something fails without the hypothesis, or nothing of the kind exists."""
    if need.lost not in tuple(Loss):
        return False
    verdict = Verdict.PROVED if need.lost == Loss.EXISTENCE else Verdict.REFUTED
    free = all(row.name not in certificate["hypotheses"] for certificate in need.certificates)
    return bool(need.certificates) and free and answers.fault(record.id, verdict, need.certificates) is None


def _is_needless(record: Record, row: HypothesisRow, need: Need, answers: Answers) -> bool:
    """What is proved does not use the hypothesis, or is proved without it, too."""
    if any(row.name in certificate["hypotheses"] for certificate in need.certificates):
        return False
    using = [each["claim"] for each in _proofs_that_need(record, row) if row.name in each["hypotheses"]]
    without = [certificate["claim"] for certificate in need.certificates]
    if not all(claim in without for claim in using):
        return False
    return not without or answers.fault(record.id, Verdict.PROVED, need.certificates) is None


def unweighed(rows: Rows) -> dict[str, tuple[Record, ...]]:
    """The records without what is known of the need for hypotheses, and without the certificates of that."""
    return {
        name: tuple(replace(r, hypotheses=tuple(replace(row, need=None) for row in r.hypotheses)) for r in each)
        for name, each in rows.items()
    }


def is_weighed(record: Record) -> bool:
    """Whether it is known which of the hypotheses are needed, as far as it can be."""
    return all(row.need for row in record.hypotheses)


def proofs(record: Record) -> Sequence[Certificate]:
    """The proofs for which a hypothesis is said to be needed or not: with the hypotheses that the paper forgot."""
    of = record.erratum if record.reading is Reading.NEEDS_HYPOTHESIS else record
    return of.certificates if of and of.verdict is Verdict.PROVED else ()


def _proofs_that_need(record: Record, row: HypothesisRow) -> list[Certificate]:
    """Of these, the ones of a relation, or of where it is an equality."""
    own = proofs(record)
    apart = [each["claim"][0] == "<=>" for each in own]
    if all(apart) or not any(apart):
        return [*own]
    equality = row.given == FOR_EQUALITY
    return [each for each, of in zip(own, apart, strict=True) if of is equality]


def reason(certificate: Certificate) -> str | None:
    """None if the checker accepts a certificate without lemmas, else why not."""
    return reasons([certificate])[0]
