"""Which statements there are: one for each certificate of a proved claim and of the corrected form of a refuted one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from symcheck.checker.residues import Reject
from symcheck.coq.composed import composition
from symcheck.coq.confirmed import asked
from symcheck.coq.script import Script
from symcheck.coq.stated import resting_on, statement
from symcheck.coq.statements import Statement
from symcheck.coq.terms import Certificate, NotExported
from symcheck.core.calculus import Unknown
from symcheck.core.terms import Malformed
from symcheck.ledger.digests import digest_of
from symcheck.ledger.record import Record


@dataclass
class Exported:
    """A statement of Coq with its proof, or the reason why there is none."""

    name: str  # of the claim, an identifier
    record: Record
    certificate: Certificate
    digest: str
    corrected: bool
    statement: Statement | None = None
    text: str = ""
    step: str = ""  # for a proof from lemmas: "the lemmas imply the claim", with its proof
    script: str = ""
    reason: str = ""
    after: list[str] = field(default_factory=list)  # the lemmas


def exported(records: Iterable[Record]) -> list[Exported]:
    """All of them in printed order."""
    found = [each for record in records for each in _of_record(record)]
    by_id: dict[str, list[Exported]] = {}
    for each in found:
        by_id.setdefault(str(each.certificate["id"]), []).append(each)
    for each in sorted(found, key=lambda each: "lemmas" in each.certificate):
        try:
            _write(each, by_id)
        except (NotExported, Reject, Unknown, Malformed, RecursionError) as error:
            each.reason, each.statement = str(error), None
    return found


def _of_record(record: Record) -> Iterator[Exported]:
    stem = re.sub(r"\W", "_", record.id.partition(":")[2])
    for corrected, proofs in asked(record):
        for k, found in enumerate(proofs, 1):
            name = f"{stem}{'_corrected' if corrected else ''}{f'_part{k}' if len(proofs) > 1 else ''}"
            yield Exported(name, record, {**found}, digest_of(found), corrected)


def _write(each: Exported, by_id: Mapping[str, list[Exported]]) -> None:
    certificate, own = each.certificate, statement(each.certificate)
    script = Script(own)
    each.script = script.write(certificate)
    if lemmas := certificate.get("lemmas"):
        step = resting_on(own, script.rests_on())
        name = f"step_{each.name}"
        each.step = f"Lemma {name} :\n{step.text()}.\nProof.\n{Script(step).write(certificate)}\nQed."
        earlier = [lemma for id in dict.fromkeys(id for id, _ in lemmas) for lemma in by_id.get(id, ())]
        own, each.script, each.after = composition(certificate, step, earlier, name)
    each.statement, each.text = own, own.text()
