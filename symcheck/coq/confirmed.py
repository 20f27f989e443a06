"""What Coq says of a record: what `make coq` left in generated/coq, believed of these certificates alone.

Certificates are identified by digests of their whole text. A file also has a digest of its outcomes: one that was
changed by hand is refused.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from pathlib import Path

from symcheck import kernels
from symcheck.core.certificates import Certificate
from symcheck.core.files import put
from symcheck.core.ids import Id
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.ledger import Record, digest, digest_of, line
from symcheck.ledger.store import COQ, SCHEMA, document, require, stored

CONFIRMED, NOT_TRIED, NO = "yes", "not tried", "no: "
Outcome = tuple[str, str]  # the digest of the certificates, and why Coq does not confirm them, or ""


def asked(record: Record) -> Iterator[tuple[bool, list[Certificate]]]:
    """What Coq is asked to confirm: (False, its certificates) of a proved relation, (True, those) of a correction."""
    own = record.certificates if record.verdict is Verdict.PROVED else ()
    for corrected, certificates in ((False, own), (True, record.erratum.certificates if record.erratum else ())):
        proofs = [each for each in certificates if each.get("verdict") == Verdict.PROVED and "matrices" not in each]
        if proofs:  # those about matrices of all sizes are not written in Coq
            yield corrected, proofs


def key(record: Record, corrected: bool) -> str:
    """By which an outcome is found: "paper:number", or "paper:number, corrected"."""
    return f"{record.id}, corrected" if corrected else record.id


def confirmed(record: Record, folder: Path | None = None) -> dict[str, str]:
    """By `key` what Coq says of a record, "yes", "no: " with the reason, or "not tried"; empty if it is not asked."""
    recorded = _recorded(folder or kernels.folder(), record.paper)
    return {name: _summary(recorded.get(name), current) for name, current in _current(record)}


def summary(record: Record) -> str:
    """The same in a line: "yes", or "correction: yes" of what a wrong relation should be; empty if Coq is not asked."""
    return "; ".join(said if name == record.id else f"correction: {said}" for name, said in confirmed(record).items())


def sentence(record: Record) -> str:
    """The same in words: "Coq confirms the proof and the correction"; empty if Coq is not asked."""
    named = [("the proof" if name == record.id else "the correction", said) for name, said in confirmed(record).items()]
    both = " and ".join(what for what, said in named if said == CONFIRMED)
    parts = [f"Coq confirms {both}"] if both else []
    for what, said in named:
        if said == NOT_TRIED:
            parts.append(f"Coq was not asked about {what}")
        elif said != CONFIRMED:
            parts.append(f"Coq does not confirm {what}: {said.removeprefix(NO)}")
    return "; ".join(parts)


def _summary(outcome: Outcome | None, current: str) -> str:
    if outcome is None or outcome[0] != current:
        return NOT_TRIED
    return f"{NO}{outcome[1]}" if outcome[1] else CONFIRMED


def _current(record: Record) -> Iterator[tuple[str, str]]:
    for corrected, certificates in asked(record):
        yield key(record, corrected), digest(map(digest_of, certificates))


def files(folder: Path, records: Iterable[Record]) -> dict[str, bytes]:
    """What is to stay in `folder` of the recorded outcomes: those of the certificates that there are now."""
    current = [(record.paper, *pair) for record in records for pair in _current(record)]
    out: dict[str, bytes] = {}
    for paper in dict.fromkeys(paper for paper, _, _ in current):
        known = recorded(folder, paper)
        valid = {name for own, name, now in current if own == paper and name in known and known[name][0] == now}
        if valid:
            out[_name(paper)] = _text(paper, {name: known[name] for name in valid})
    return out


def record_all(folder: Path, outcomes: Mapping[str, Outcome]) -> list[Path]:
    """Write the outcomes by `key`, each file whole; what is recorded of other relations stays."""
    written = []
    for paper in dict.fromkeys(Id.parse(name).paper for name in outcomes):
        own = {name: outcome for name, outcome in outcomes.items() if Id.parse(name).paper == paper}
        written.append(folder / _name(paper))
        put(written[-1], _text(paper, _kept(folder, paper) | own))
    return written


def _kept(folder: Path, paper: str) -> dict[str, Outcome]:
    """What is recorded and can be read."""
    try:
        return recorded(folder, paper)
    except SymcheckError:
        return {}


def lost(folder: Path, outcomes: Mapping[str, Outcome], papers: Iterable[str] = ()) -> Iterator[str]:
    """A line for each relation (of these papers) that is recorded as confirmed, and is not by these outcomes."""
    for paper in papers or sorted(file.stem for file in (folder / COQ).glob("*.json")):
        for name, (_, reason) in recorded(folder, paper).items():
            now = outcomes[name][1] if name in outcomes else "Coq was not asked"
            if now and not reason:
                yield f"{name} is recorded as confirmed by Coq, and is not: {now}"


def unrecorded(folder: Path, outcomes: Mapping[str, Outcome]) -> int:
    """How many of these outcomes are recorded otherwise, of other certificates, or not at all."""
    papers = {Id.parse(name).paper for name in outcomes}
    known = {name: outcome for paper in papers for name, outcome in recorded(folder, paper).items()}
    return sum(known.get(name) != outcome for name, outcome in outcomes.items())


def recorded(folder: Path, paper: str) -> dict[str, Outcome]:
    """The outcomes of a paper by `key`; empty if there are none, SymcheckError if they cannot be read."""

    def read(text: bytes) -> dict[str, Outcome]:
        data = json.loads(text)
        require((data["schema"], data["paper"]) == (SCHEMA, paper), f"it is not of schema {SCHEMA} and paper {paper}")
        found = {name: (str(current), str(reason)) for name, (current, reason) in data["items"].items()}
        require(text == _text(paper, found), "its outcomes are not those that its digest is of")
        return found

    return stored(folder / _name(paper), read, "delete it, or run `make coq`") or {}


_recorded = cache(recorded)


def _name(paper: str) -> str:
    return f"{COQ}/{paper}.json"


def _text(paper: str, outcomes: Mapping[str, Outcome]) -> bytes:
    return document(paper, "items", "{}", (f"{line(name)}: {line(outcomes[name])}" for name in sorted(outcomes)), True)
