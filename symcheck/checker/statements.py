"""Whether certificates state what the ledger states: the index of statements is read anew from the printed text."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from symcheck.checker.rules import DICT, LIST, fit
from symcheck.core.terms import JSON

LEDGER = ("as printed", "where it is an equality", "as corrected")  # what is read from the print, or put in its place


class Entry(NamedTuple):
    """One statement: what it is, the claim, the hypotheses in force and the letters that are defined, by name."""

    what: str
    claim: JSON
    hypotheses: list[JSON]
    defined: list[JSON]


class Index:
    """The statements of a paper by id; every definition and every list of formulas of a hypothesis, by name."""

    def __init__(self, data: dict[str, JSON]) -> None:
        self.definitions, self.hypotheses = fit(DICT, data["definitions"]), fit(DICT, data["hypotheses"])
        self.entries: dict[str, list[Entry]] = {}
        for each in fit(LIST, data["statements"]):
            id, what, claim, hypotheses, defined = fit(LIST, each)
            entry = Entry(fit(str, what), claim, fit(LIST, hypotheses), fit(LIST, defined))
            self.entries.setdefault(fit(str, id), []).append(entry)

    def differences(self, certificates: list[JSON]) -> Iterator[str]:
        """What certificates state that the ledger does not, and what it states without one."""
        open_ = {id: list(entries) for id, entries in self.entries.items()}
        for each in certificates:
            stated = fit(DICT, each)
            id, claim = fit(str, stated["id"]), stated["claim"]
            found = [self.faults(stated, entry) for entry in self.entries.get(id, ()) if entry.claim == claim]
            if [] not in found:
                yield f"{id}: {(found or [['the ledger does not state what this certificate claims']])[0][0]}"
            open_[id] = [entry for entry in open_.get(id, ()) if entry.claim != claim]
        yield from (f"{id}: no certificate of what is stated {e.what}" for id, left in open_.items() for e in left)

    def faults(self, certificate: dict[str, JSON], entry: Entry) -> list[str]:
        """What a certificate assumes that is not in force, or leaves out: a refutation has to keep to all of it."""
        definitions = [fit(LIST, each) for each in fit(LIST, certificate.get("definitions", []))]
        given = fit(DICT, certificate.get("hypotheses", {}))
        lacking = [name for name in entry.hypotheses if name not in given]
        lacking += [name for name in entry.defined if name not in [each[0] for each in definitions]]
        faults = [f"{name} is left out of a refutation" for name in lacking if certificate["verdict"] == "refuted"]
        faults += [f"the hypothesis {name} is not in force" for name in given if name not in entry.hypotheses]
        if entry.what not in LEDGER:
            return faults
        for name, term in definitions:
            if term not in fit(LIST, self.definitions.get(fit(str, name), [])):
                faults.append(f"{name} is not so defined in the ledger")
        for name, formulas in given.items():
            said = [fit(LIST, each) for each in fit(LIST, self.hypotheses.get(name, []))]
            whole = certificate["verdict"] == "refuted"
            if not any(formulas == each if whole else all(f in each for f in fit(LIST, formulas)) for each in said):
                faults.append(f"the hypothesis {name} does not say this in the ledger")
        return faults
