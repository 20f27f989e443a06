"""Whether certificates state what the ledger states: the index of statements is read anew from the printed text."""

from __future__ import annotations

from collections.abc import Iterator

from symcheck.checker.residues import require
from symcheck.checker.rules import fit
from symcheck.core.terms import JSON

LEDGER = ("as printed", "where it is an equality", "as corrected")  # what is read from the print, or put in its place


class Index:
    """The statements of a paper by id, and every definition and hypothesis in force in one of them."""

    def __init__(self, data: dict[str, JSON]) -> None:
        self.definitions, self.hypotheses = data["definitions"], data["hypotheses"]
        listed = data["statements"]
        self.claims: dict[str, list[tuple[str, JSON]]] = {}
        for entry in listed if isinstance(listed, list) else []:
            require(isinstance(entry, list) and len(entry) == 3, "{} is no statement", entry)
            id, what, claim = entry if isinstance(entry, list) else []
            self.claims.setdefault(fit(str, id), []).append((fit(str, what), claim))
        require(self.claims, "it states nothing")

    def differences(self, certificates: list[JSON]) -> Iterator[str]:
        """What certificates state that the ledger does not, and what it states without one."""
        open_ = {id: list(claims) for id, claims in self.claims.items()}
        for each in certificates:
            assert isinstance(each, dict)
            id, claim = fit(str, each.get("id")), each.get("claim")
            found = [entry for entry in self.claims.get(id, ()) if entry[1] == claim]
            if not found:
                yield f"{id}: the ledger does not state what this certificate claims"
            elif found[0][0] in LEDGER:
                yield from (f"{id}: {fault}" for fault in self.foreign(each))
            open_[id] = [entry for entry in open_.get(id, ()) if entry[1] != claim]
        yield from (f"{id}: no certificate of what is stated {what}" for id, left in open_.items() for what, _ in left)

    def foreign(self, certificate: dict[str, JSON]) -> Iterator[str]:
        """Definitions and hypotheses of a certificate that are not those of the paper."""
        definitions, hypotheses = certificate.get("definitions"), certificate.get("hypotheses")
        for entry in definitions if isinstance(definitions, list) else []:
            name, term = entry if isinstance(entry, list) else []
            if not known(self.definitions, name, term):
                yield f"{name} is not so defined in the ledger"
        for name, formulas in hypotheses.items() if isinstance(hypotheses, dict) else ():
            for formula in formulas if isinstance(formulas, list) else []:
                if not known(self.hypotheses, name, formula):
                    yield f"the hypothesis {name} does not say this in the ledger"


def known(table: JSON, name: JSON, value: JSON) -> bool:
    """Whether the value is listed under the name, or is a part of what is."""
    listed = table.get(name) if isinstance(table, dict) and isinstance(name, str) else None
    stated = listed if isinstance(listed, list) else []
    return value in stated or any(value in parts(each) for each in stated)


def parts(formula: JSON) -> list[JSON]:
    """A formula in JSON taken apart at "and"."""
    if isinstance(formula, list) and formula[:1] == ["and"]:
        return [part for each in formula[1:] for part in parts(each)]
    return [formula]
