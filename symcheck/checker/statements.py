"""Whether certificates state what the ledger states: the index of statements is read anew from the printed text."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from symcheck.core.fields import by_key, listed, raw, text
from symcheck.core.terms import JSON

LEDGER = ("as printed", "where it is an equality", "as corrected")  # what is read from the print, or put in its place
FORMULAS = by_key(listed(raw))


def claimed(certificate: Mapping[str, Any]) -> JSON:
    """What a certificate claims; of matrices of all sizes with the shapes of letters, and which are inverses."""
    of = [certificate[name] for name in ("matrices", "inverses") if name in certificate]
    return [certificate["claim"], *of] if of else certificate["claim"]


class Entry:
    """One statement: what it is, the claim, the hypotheses in force and the letters that are defined, by name."""

    def __init__(self, what: JSON, claim: JSON, hypotheses: JSON, defined: JSON) -> None:
        self.what, self.claim = text(what), claim
        self.hypotheses, self.defined = listed(text)(hypotheses), listed(text)(defined)


class Index:
    """The statements of a paper by id; all that a definition, and all that a hypothesis may say, by name."""

    def __init__(self, data: dict[str, JSON]) -> None:
        definitions = FORMULAS(data["definitions"])
        self.definitions = {name: [[term] for term in terms] for name, terms in definitions.items()}
        self.hypotheses = by_key(listed(listed(raw)))(data["hypotheses"])
        self.entries: dict[str, list[Entry]] = {}
        for id, *stated in listed(listed(raw, 5))(data["statements"]):
            self.entries.setdefault(text(id), []).append(Entry(*stated))

    def differences(self, certificates: Iterable[object]) -> Iterator[str]:
        """What certificates state that the ledger does not, and what it states without one."""
        open_ = {id: list(entries) for id, entries in self.entries.items()}
        for stated in map(by_key(raw), certificates):
            id, claim = text(stated["id"]), claimed(stated)
            found = [self.faults(stated, entry) for entry in self.entries.get(id, ()) if entry.claim == claim]
            if [] not in found:
                yield f"{id}: {(found or [['the ledger does not state what this certificate claims']])[0][0]}"
            open_[id] = [entry for entry in open_.get(id, ()) if entry.claim != claim]
        yield from (f"{id}: no certificate of what is stated {e.what}" for id, left in open_.items() for e in left)

    def faults(self, certificate: dict[str, JSON], entry: Entry) -> list[str]:
        """What a certificate assumes that is not in force, or leaves out: a refutation has to keep to all of it."""
        refuted = certificate["verdict"] == "refuted"
        defined = {text(name): [term] for name, term in listed(listed(raw, 2))(certificate.get("definitions", []))}
        given = FORMULAS(certificate.get("hypotheses", {}))
        lacking = [*({*entry.hypotheses} - given.keys()), *({*entry.defined} - defined.keys())] if refuted else []
        faults = [f"{name} is left out of a refutation" for name in sorted(lacking)]
        faults += [f"the hypothesis {name} is not in force" for name in given if name not in entry.hypotheses]
        if entry.what in LEDGER:
            for said, own, fault in (
                (self.definitions, defined, "{} is not so defined in the ledger"),
                (self.hypotheses, given, "the hypothesis {} does not say this in the ledger"),
            ):
                for name, formulas in own.items():  # a proof may do with some of the formulas of a hypothesis
                    ways = said.get(name, [])
                    if formulas not in ways and (refuted or not any(all(f in way for f in formulas) for way in ways)):
                        faults.append(fault.format(name))
        return faults
