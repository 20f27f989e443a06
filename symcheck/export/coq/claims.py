"""Which statements there are: one for each certificate of a proved claim and of the corrected form of a refuted one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from symcheck.evidence.confirmed import asked
from symcheck.evidence.record import Record
from symcheck.export.coq.composed import composition
from symcheck.export.coq.script import Script
from symcheck.export.coq.statements import Statement, statement
from symcheck.export.coq.terms import NotExported
from symcheck.statement import Certificate


@dataclass
class Exported:
    """A statement of Coq with its proof, or the reason why there is none."""

    name: str  # of the claim, an identifier
    record: Record
    certificate: Certificate
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
        except (NotExported, RecursionError) as error:
            each.reason, each.statement = str(error), None
    return found


def _of_record(record: Record) -> Iterator[Exported]:
    stem = re.sub(r"\W", "_", record.id.partition(":")[2])
    for corrected, proofs in asked(record):
        for k, certificate in enumerate(proofs, 1):
            part = f"_part{k}" if len(proofs) > 1 else ""
            yield Exported(f"{stem}{'_corrected' if corrected else ''}{part}", record, certificate, corrected)


def _write(each: Exported, by_id: Mapping[str, list[Exported]]) -> None:
    certificate = each.certificate
    stated = statement(certificate)
    script = Script(stated).write(certificate["proof"])
    if "lemmas" not in certificate:
        each.statement, each.text, each.script = stated, stated.text(), script
        return
    lemmas = [lemma for id in certificate["lemmas"] for lemma in by_id.get(id, ()) if lemma.statement]
    whole, proof, used = composition(certificate, stated, lemmas, f"step_{each.name}")
    each.step = f"Lemma step_{each.name} :\n{stated.text()}.\nProof.\n{script}\nQed."
    each.statement, each.text, each.script, each.after = whole, whole.text(), proof, used


def key(certificate: Mapping[str, Any]) -> str:
    """What says which certificate it is."""
    return str(certificate["digest"])
