"""The certificates that a record rests on."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from symcheck.core.verdicts import Certificate
from symcheck.ledger.record import Record


def certificates(record: Record) -> Iterator[Certificate]:
    """Every certificate a record rests on: its own, those of what it should be, those of hypotheses left out."""
    yield from record.certificates
    yield from (record.erratum or {}).get("certificates") or ()
    for hypothesis in record.hypotheses:
        yield from of_need(hypothesis)


def of_need(hypothesis: Mapping[str, Any]) -> Iterator[Certificate]:
    """What shows that a hypothesis is needed, or the proofs that do without it."""
    counterexample = hypothesis.get("counterexample")
    if isinstance(counterexample, dict) and "claim" in counterexample:
        yield counterexample
    yield from hypothesis.get("proofs") or ()
