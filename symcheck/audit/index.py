"""What the ledger states, read anew from the declarations: with this the checker compares what certificates claim.

Nothing of a proof is used here. What is said of hypotheses that are left out, and of kernels, is not a reading of the
print: it is listed with what it is, from the certificates themselves.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cache
from typing import Any

from symcheck.audit.context import Context
from symcheck.audit.judge import equality_claims, units
from symcheck.audit.obligation import expand
from symcheck.checker.statements import claimed
from symcheck.core.certificates import Certificate
from symcheck.core.claims import Assertion, Declaration, Hypothesis, Paper, Stated, for_letter
from symcheck.core.terms import Formula
from symcheck.ledger import Record
from symcheck.reading import read

Entry = tuple[str, str, Formula, tuple[Hypothesis, ...]]  # id, what it is, the claim, what is in force


class Index:
    """The statements of a paper: id, what each is, claim, names of the hypotheses in force, defined letters.

    Of each name every definition, and every list of formulas of a hypothesis, that is in force somewhere.
    """

    def __init__(self, paper: Paper) -> None:
        self.definitions: dict[str, list[Any]] = {}
        self.hypotheses: dict[str, list[Any]] = {}
        self.statements: list[list[Any]] = []
        self.items: dict[str, Declaration] = {}
        for obligation in expand(paper):
            self.items[obligation.id] = obligation.item
            if isinstance(obligation.item, Assertion) and not obligation.item.question:
                self._read(Context(obligation.paper, obligation.item))

    def _read(self, context: Context) -> None:
        hypothesis = cache(context.hypothesis)
        for id, what, claim, given in _claims(context):
            hypotheses = dict(map(hypothesis, given))
            defined = context.used_definitions(claim, *(f for formulas in hypotheses.values() for f in formulas))
            for name, formulas in hypotheses.items():
                _add(self.hypotheses.setdefault(name, []), [[*formulas]])
            for name, term in defined:
                _add(self.definitions.setdefault(name, []), [term])
            letters = [name for name, _ in defined]
            self.statements.append([id, what, claim, [*hypotheses], letters])

    def add_further(self, records: Iterable[Record], kernels: Iterable[Certificate]) -> None:
        """What else there are certificates of."""
        for record in records:
            item = self.items.get(record.declaration)
            if item and item.question:
                for each in record.all_certificates():
                    self._add_asked(each, item.question.stated(item, each))
            for hypothesis in record.hypotheses:
                for each in hypothesis.need.certificates if hypothesis.need else ():
                    self._add_further("a hypothesis left out", each)
        for each in kernels:
            self._add_further("a kernel", each)

    def _add_asked(self, certificate: Certificate, stated: Stated | None) -> None:
        """What a relation states of which a certificate is one, or the case of it that the certificate states."""
        if stated is None:
            self._add_further("a case of what is printed", certificate)
            return
        for name, formulas in stated.hypotheses.items():
            _add(self.hypotheses.setdefault(name, []), [formulas])
        for name, term in stated.definitions.items():
            _add(self.definitions.setdefault(name, []), [term])
        letters = [name for name in stated.definitions if name in dict(certificate["definitions"])]
        _add(self.statements, [[certificate["id"], stated.what, claimed(certificate), [*stated.hypotheses], letters]])

    def _add_further(self, what: str, certificate: Certificate) -> None:
        letters = [name for name, _ in certificate.get("definitions", ())]
        _add(self.statements, [[certificate["id"], what, claimed(certificate), [*certificate["hypotheses"]], letters]])


def _add(known: list[Any], new: Iterable[Any]) -> None:
    known += [each for each in new if each not in known]


def _claims(context: Context) -> Iterator[Entry]:
    statement = context.item.statement
    for unit in units(context):
        if statement.imposes(unit.letter):
            continue
        id, given = f"{context.id}{unit.letter}", statement.given
        yield from ((id, "as printed", formula, given) for formula in unit.formulas)
        if equality := for_letter(statement.equality, unit.letter):
            claims, attained = equality_claims(context, unit, equality), (*given, *statement.equality_given)
            yield from ((id, "where it is an equality", claim, attained) for claim in claims)
        if erratum := context.item.erratum(unit.letter):
            right = unit.reworded(context, read(erratum.corrected, context.notation)) if erratum.corrected else unit
            yield from ((id, "as corrected", formula, (*given, *erratum.needs)) for formula in right.formulas)
