"""What the ledger states, read anew from the declarations: with this the checker compares what certificates claim.

Nothing of a proof is used here. What is said of hypotheses that are left out, and of kernels, is no reading of the
print: it is listed with what it is, from the certificates themselves.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from symcheck.evidence import translation
from symcheck.evidence.context import Context, for_letter
from symcheck.evidence.judge import equality_claims, units
from symcheck.evidence.obligation import DECIDED, expand
from symcheck.evidence.record import Record
from symcheck.reading import read
from symcheck.statement import Certificate, Formula, Paper

Entry = tuple[str, str, Formula]  # id, what it is, the claim


class Index:
    """The statements of a paper, with every definition and hypothesis that is in force in one of them."""

    def __init__(self, paper: Paper) -> None:
        self.definitions: dict[str, list[Any]] = {}
        self.hypotheses: dict[str, list[Any]] = {}
        self.statements: list[tuple[str, str, Any]] = []
        for obligation in expand(paper):
            if obligation.item.role in DECIDED:
                self._read(Context(obligation.paper, obligation.item))

    def _read(self, context: Context) -> None:
        item = context.item
        spoken: list[Formula] = []
        for hypothesis in (*item.given, *item.needs, *item.equality_given):
            name, formulas = context.hypothesis(hypothesis)
            spoken += formulas
            _add(self.hypotheses.setdefault(name, []), map(translation.stated, formulas))
        claims = [*_claims(context)]
        for id, what, claim in claims:
            self.statements.append((id, what, translation.stated(claim)))
        for name, term in context.used_definitions(*spoken, *(claim for *_, claim in claims)):
            _add(self.definitions.setdefault(name, []), [translation.stated(term)])

    def beside(self, records: Iterable[Record], kernels: Iterable[Certificate]) -> None:
        """What else there are certificates of."""
        for record in records:
            for hypothesis in record.hypotheses:
                for each in (hypothesis.get("counterexample"), *(hypothesis.get("proofs") or ())):
                    if isinstance(each, dict) and "claim" in each:
                        self._beside("a hypothesis left out", each)
        for each in kernels:
            self._beside("a kernel", each)

    def _beside(self, what: str, certificate: Certificate) -> None:
        _add(self.statements, [(certificate["id"], what, translation.stated(certificate["claim"]))])


def _add(known: list[Any], new: Iterable[Any]) -> None:
    known += [each for each in new if each not in known]


def _claims(context: Context) -> Iterator[Entry]:
    item = context.item
    for unit in units(context):
        if unit.letter and unit.letter in item.imposed:
            continue
        id = f"{context.id}{unit.letter}"
        yield from ((id, "as printed", formula) for formula in unit.formulas)
        if equality := for_letter(item.equality, unit.letter):
            yield from ((id, "where it is an equality", claim) for claim in equality_claims(context, unit, equality))
        erratum = item.errata.get(unit.letter)
        if erratum and erratum.corrected:
            right = unit.reworded(context, read(erratum.corrected, context.notation))
            yield from ((id, "as corrected", formula) for formula in right.formulas)
