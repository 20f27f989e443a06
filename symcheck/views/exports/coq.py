"""Statements and proofs for Coq, a folder for each paper; see `symcheck.coq`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from symcheck.ledger import Record
from symcheck.views.exports import Format


def _files(records: Sequence[Record]) -> Mapping[str, str]:
    from symcheck.coq.files import files  # with the whole exporter, which the help does not need

    return files(records)


FORMAT = Format("statements and proofs for Coq, a folder per paper; `make coq` compiles them", files=_files)
