"""The one place where the self-test asks what the ledger would report, and goes from certificates back to problems.

Nothing here judges by itself: certificates are accepted by `symcheck.audit.checked.reasons`, and a verdict is what
`symcheck.audit.checked.accepted` leaves of it, as for every row of the ledger.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

from symcheck.audit import Context, Finding, Unit, accepted, reasons
from symcheck.audit.judge import lemma
from symcheck.core.calculus import letters
from symcheck.core.certificates import Certificate
from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Form, Hint, Outcome, Problem, Witness
from symcheck.core.terms import JSON, Formula, Node, Reader, Term, node
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.ledger import Record, lemmas_of, reached
from symcheck.proof import certificate

MALFORMED = (AssertionError, LookupError, TypeError, ValueError, AttributeError, SymcheckError)


def holds(evidence: Certificate, lemmas: Sequence[Certificate] = ()) -> bool:
    """Whether the checker accepts a certificate; those of its lemmas are among the others."""
    return reasons([evidence, *lemmas])[0] is None


def ledger_verdict(context: Context, unit: Unit, finding: Finding) -> Verdict:
    """What the ledger reports of a finding: its verdict, if the checker accepts its certificates."""
    if finding.verdict is Verdict.UNDECIDED:
        return finding.verdict
    id, declared = f"{context.id}{unit.letter}", context.id
    row = _row(id, context, finding.verdict, finding.certificates)
    lemmas = {name: (_lemma(name, context),) for name in _lemmas(finding.certificates)}
    ((record,),) = accepted({declared: (row,)}, lemmas).values()
    return record.verdict or Verdict.UNDECIDED


def _row(id: str, context: Context, verdict: Verdict, certificates: Iterable[Certificate]) -> Record:
    item = context.item
    return Record(
        id=id,
        paper=context.paper.key,
        section="",
        line=item.source.line,
        role=item.role,
        verdict=verdict,
        certificates=tuple(certificates),
    )


def _lemma(name: str, context: Context) -> Record:
    return _row(name, context, Verdict.PROVED, lemma(name)[1])


def _lemmas(certificates: Iterable[Certificate]) -> list[str]:
    """The ids of all relations that certificates rest on."""
    return sorted(reached(lemmas_of(certificates), lambda name: lemmas_of(lemma(name)[1])))


def states(finding: Finding, formulas: Iterable[Formula]) -> bool:
    """Whether the certificates claim just these formulas, and in addition only sets of equality."""
    claims = [certificate["claim"] for certificate in finding.certificates]
    stated: list[JSON] = json.loads(json.dumps([*formulas]))
    return claims[: len(stated)] == stated and len(claims) == len(finding.problems)


def answered(problem: Problem, outcome: object) -> Verdict:
    """What an answer is worth: its verdict if its certificate holds, else undecided."""
    if not isinstance(outcome, Outcome) or outcome.verdict is Verdict.UNDECIDED:
        return Verdict.UNDECIDED
    try:
        good = holds(json.loads(json.dumps(certificate(problem, outcome))))
    except MALFORMED:
        return Verdict.UNDECIDED
    return outcome.verdict if good else Verdict.UNDECIDED


def is_proved(problem: Problem, outcome: Outcome | None) -> bool:
    """Whether there is a proof, and the checker accepts it."""
    return answered(problem, outcome) is Verdict.PROVED


def problem_of(evidence: Certificate) -> Problem:
    """What a certificate states, lemmas not counted, with the definitions it reaches; parts of its proof are hints."""
    read = Reader()
    claim = read.formula(evidence["claim"])
    hypotheses = tuple(
        (name, tuple(part for formula in formulas for part in conjuncts(read.formula(formula))))
        for name, formulas in evidence["hypotheses"].items()
    )
    terms = {name: read.term(term) for name, term in evidence["definitions"]}
    stated = node("and", claim, *(formula for _, formulas in hypotheses for formula in formulas))
    used = reached(letters(stated) & terms.keys(), lambda name: letters(terms[name]) & terms.keys())
    definitions = tuple((name, term) for name, term in terms.items() if name in used)
    return Problem(evidence["id"], claim, definitions, hypotheses, tuple(dict.fromkeys(_hints(evidence.get("proof")))))


def _hints(proof: JSON) -> Iterator[Hint[Term]]:
    """The forms and the points that a proof is made of, for a search that looks for a proof of something like it."""
    if isinstance(proof, dict):
        if "form" in proof:
            yield Form(Reader().term(proof["form"]))
        point = proof.get("point")
        if isinstance(point, dict):
            yield Witness(tuple((letter, Reader().term(value)) for letter, value in point.items()))
    if isinstance(proof, (dict, list)):
        for child in proof.values() if isinstance(proof, dict) else proof:
            yield from _hints(child)


def relettered(value: Any, new: Callable[[str], str]) -> Any:
    """A term or formula with other names for its letters and unknown functions."""
    if isinstance(value, str):
        return new(value)
    if isinstance(value, Node):
        return node(value.tag, *(relettered(part, new) for part in value[1:]))
    return tuple(relettered(part, new) for part in value) if isinstance(value, tuple) else value
