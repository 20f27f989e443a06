"""Which statements there are: one for each certificate of a proved claim and of the corrected form of a refuted one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from symcheck.checker.residues import Reject
from symcheck.coq.composed import composition
from symcheck.coq.confirmed import asked
from symcheck.coq.script import script
from symcheck.coq.statements import Statement, statement
from symcheck.coq.terms import Certificate, NotExported
from symcheck.core.calculus import Unknown
from symcheck.core.terms import Malformed
from symcheck.ledger import Record, digest_of


@dataclass
class Claim:
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


def claims_of(records: Iterable[Record]) -> list[Claim]:
    """All of them in printed order."""
    claims = [claim for record in records for claim in _of_record(record)]
    by_id: dict[str, list[Claim]] = {}
    for claim in claims:
        by_id.setdefault(str(claim.certificate["id"]), []).append(claim)
    for claim in sorted(claims, key=lambda claim: "lemmas" in claim.certificate):
        try:
            _write(claim, by_id)
        except (NotExported, Reject, Unknown, Malformed, RecursionError) as error:
            claim.reason, claim.statement = str(error), None
    return claims


def _of_record(record: Record) -> Iterator[Claim]:
    stem = re.sub(r"\W", "_", record.number)
    for corrected, proofs in asked(record):
        for k, certificate in enumerate(proofs, 1):
            name = f"{stem}{'_corrected' if corrected else ''}{f'_part{k}' if len(proofs) > 1 else ''}"
            yield Claim(name, record, {**certificate}, digest_of(certificate), corrected)


def _write(claim: Claim, by_id: Mapping[str, list[Claim]]) -> None:
    certificate, stated = claim.certificate, statement(claim.certificate)
    proof = script(stated, certificate)
    claim.script = proof.text
    if lemmas := certificate.get("lemmas"):
        step = stated.resting_on(proof.rests_on)
        name = f"step_{claim.name}"
        claim.step = f"Lemma {name} :\n{step.text()}.\nProof.\n{script(step, certificate).text}\nQed."
        earlier = [lemma for id in dict.fromkeys(id for id, _ in lemmas) for lemma in by_id.get(id, ())]
        stated, claim.script, claim.after = composition(certificate, step, earlier, name)
    claim.statement, claim.text = stated, stated.text()
