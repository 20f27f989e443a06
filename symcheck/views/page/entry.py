"""One record as the page shows it: values as text, formulas as numbers, certificates with the steps of their proofs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup

from symcheck.coq.confirmed import told
from symcheck.core.verdicts import Certificate
from symcheck.core.words import term
from symcheck.ledger.record import Record
from symcheck.views.faults import Fault, without
from symcheck.views.page.formulas import Formulas
from symcheck.views.page.sources import Excerpt, Publication
from symcheck.views.steps import compared, coordinates, shown, sides

_GIVEN = {"printed": "printed", "added": "not printed, added", "standing": "implied by the subject"}
_NEEDED = {True: "needed", False: "not needed", None: "need not known"}


@dataclass(frozen=True)
class Counterexample:
    """The point at which a relation fails: letters with their values, and what is compared there, each named."""

    values: tuple[tuple[str, str], ...]
    compared: tuple[tuple[str, str], ...]
    told: str


@dataclass(frozen=True)
class Condition:
    """A hypothesis as the page shows it; `without` is what is lost if it is left out."""

    words: str
    states: str
    given: str
    needed: str
    without: str


@dataclass(frozen=True)
class Proof:
    """A certificate with what it is of."""

    of: str
    certificate: Certificate

    @property
    def title(self) -> str:
        """What it is of, and its verdict."""
        return ", ".join(filter(None, (self.of, self.certificate.get("verdict", ""))))

    @property
    def lines(self) -> str:
        """What the proof starts from, and its steps."""
        return "\n".join(shown(self.certificate))


@dataclass(frozen=True)
class Entry:
    """A record with all that stands beside it."""

    record: Record
    paper: Publication
    kernels: tuple[Excerpt, ...]
    cells: tuple[Excerpt, ...]

    @property
    def name(self) -> str:
        """The name of the declaration in words."""
        return self.record.name.replace("_", " ")

    @property
    def coq(self) -> str:
        """What Coq says of the proofs."""
        return told(self.record)

    @property
    def section(self) -> str:
        """The section's number and title."""
        return " ".join((self.record.section, self.paper.sections.get(self.record.section, ""))).strip()

    @property
    def proofs(self) -> tuple[Proof, ...]:
        """The certificates of the relation, then those of what it should be."""
        return tuple(proofs(self.record))

    @property
    def conditions(self) -> tuple[Condition, ...]:
        """The hypotheses."""
        return tuple(map(_condition, self.record.hypotheses))

    @property
    def counterexample(self) -> Counterexample | None:
        """Where the relation fails as printed."""
        claims = (each.get("claim") for each in self.record.certificates)
        parts = any(claim and claim[0] in ("and", "or") for claim in claims)
        return _counterexample(self.record.counterexample, parts) if self.record.counterexample else None


def proofs(record: Record) -> Iterator[Proof]:
    """The certificates of a record, then those of what it should be."""
    yield from (Proof("as printed", each) for each in record.certificates)
    yield from (Proof("as corrected", each) for each in (record.erratum or {}).get("certificates") or ())


def texts(records: Iterable[Record]) -> Iterator[str]:
    """All that may be typeset."""
    for record in records:
        yield from (record.printed, record.read, Fault((record,)).correct)
        yield from (each.get("states", "") for each in record.hypotheses)
        yield from (each["relation"] for each in (record.erratum or {}).get("repairs") or ())


def difference(record: Record, formulas: Formulas, fallback: bool = False) -> tuple[Markup, Markup]:
    """What is printed and what is right, with the differences marked; of a chain the one link."""
    fault = Fault((record,))
    return formulas.pair(fault.printed, fault.correct, fallback)


def _counterexample(found: Mapping[str, Any], parts: bool) -> Counterexample | None:
    """What is known of a point; `parts` if truth values of several parts are compared there, not two sides."""
    found = found.get("point", found)
    at = coordinates(found.get("values", {}))
    values = tuple((f"{function} {name}".lstrip(), _value(value)) for function, name, value in at)
    both = tuple(map(_value, compared(found)))
    names = (f"part {number}" for number in range(1, len(both) + 1)) if parts else ("left side", "right side")
    told = "" if both else sides(found)
    return Counterexample(values, tuple(zip(names, both, strict=False)), told) if values or both or told else None


def _value(value: Any) -> str:
    return term(value).replace("-", "−")


def _condition(hypothesis: Mapping[str, Any]) -> Condition:
    given = str(hypothesis.get("given", ""))
    return Condition(
        hypothesis.get("words") or hypothesis.get("name", ""),
        hypothesis.get("states", ""),
        _GIVEN.get(given, given),
        _NEEDED[hypothesis.get("needed")],
        without(hypothesis),
    )
