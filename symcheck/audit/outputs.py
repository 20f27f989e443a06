"""What an audit leaves below generated/: certificates, what they are to state, and the verdicts expected."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from types import MappingProxyType

from symcheck import kernels, papers
from symcheck.audit.index import Index
from symcheck.core.certificates import Certificate
from symcheck.kernels import GENERATED
from symcheck.ledger import Record, by_paper, line
from symcheck.ledger.store import CERTIFICATES, EXPECTED, PROOFS, STATEMENTS, document

Kernels = tuple[Mapping[str, str], Iterable[Certificate]]  # texts by the names of their files, proofs


def folder(key: str) -> Path:
    """Where what is written of a paper lies."""
    own = papers.load().folders.get(key)
    return own / GENERATED if own else kernels.folder()


def files(records: Iterable[Record], compiled: Mapping[str, Kernels] = MappingProxyType({})) -> dict[str, bytes]:
    """Path inside generated/ -> contents, for every paper that has a record; `compiled` kernels by paper."""
    out: dict[str, bytes] = {}
    for key, rows in sorted(by_paper(records).items()):
        texts, equalities = compiled.get(key, ({}, ()))
        equalities = [*equalities]
        proofs = [*(certificate for row in rows for certificate in row.all_certificates()), *equalities]
        written = dict.fromkeys(line(proof) for proof in proofs)
        out |= {name: text.encode() for name, text in texts.items()}
        verdicts = (f"{line(row.id)}: {line(_expectation(row))}" for row in rows)
        out[f"{CERTIFICATES}/{key}.json"] = document(key, "certificates", "[]", written, schema=PROOFS)
        out[f"{STATEMENTS}/{key}.json"] = _stated(key, rows, equalities)
        out[f"{EXPECTED}/{key}.json"] = document(key, "items", "{}", verdicts)
    return out


def _stated(key: str, rows: Iterable[Record], equalities: Iterable[Certificate]) -> bytes:
    """The statements of a paper, read anew."""
    index = Index(papers.load()[key])
    index.add_further(rows, equalities)
    known = {"definitions": index.definitions, "hypotheses": index.hypotheses}
    return document(key, "statements", "[]", map(line, index.statements), schema=PROOFS, others=known)


def _expectation(record: Record) -> list[str | None]:
    return [record.verdict, record.reading]
