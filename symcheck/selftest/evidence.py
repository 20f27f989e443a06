"""The one place where the self-test asks what the ledger would tell, and goes from certificates back to problems.

Nothing here judges by itself: certificates are accepted by `symcheck.evidence.checked.reasons`, and a verdict is what
`symcheck.evidence.checked.told` leaves of it, as for every row of the ledger.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

from symcheck.evidence.checked import reasons, told
from symcheck.evidence.context import Context
from symcheck.evidence.judge import Finding, Unit, lemma
from symcheck.evidence.record import Record
from symcheck.proof import certificate
from symcheck.proof.theorems import conjuncts
from symcheck.statement import Certificate, Formula, Outcome, Problem, SymcheckError, Verdict

MALFORMED = (AssertionError, LookupError, TypeError, ValueError, AttributeError, SymcheckError)


def holds(evidence: Certificate, beside: Sequence[Certificate] = ()) -> bool:
    """Whether the checker accepts a certificate, with lemmas among those beside it."""
    return reasons([evidence, *beside])[0] is None


def all_hold(evidence: Iterable[Certificate], beside: Sequence[Certificate] = ()) -> bool:
    """Whether there are certificates, and the checker accepts them all."""
    found = list(evidence)
    return bool(found) and not any(reasons([*found, *beside])[: len(found)])


def told_of(context: Context, unit: Unit, finding: Finding) -> Verdict:
    """What the ledger tells of a finding: its verdict, if the checker accepts the certificates of it."""
    if finding.verdict is Verdict.UNDECIDED:
        return finding.verdict
    id, declared = f"{context.id}{unit.letter}", context.id
    point = next((outcome.point for outcome in finding.outcomes if outcome.verdict is Verdict.REFUTED), None)
    row = _row(id, context, finding.verdict, finding.certificates, point)
    lemmas = {name: (_lemma(name, context),) for name in _lemmas(finding.certificates)}
    ((record,),) = told({declared: (row,)}, lemmas).values()
    return record.verdict or Verdict.UNDECIDED


def _row(
    id: str, context: Context, verdict: Verdict, certificates: Iterable[Certificate], point: Certificate | None = None
) -> Record:
    item = context.item
    return Record(
        id=id,
        paper=context.paper.key,
        section="",
        line=item.line,
        role=item.role,
        verdict=verdict,
        certificates=tuple(certificates),
        counterexample=point,
    )


def _lemma(name: str, context: Context) -> Record:
    return _row(name, context, Verdict.PROVED, lemma(*name.split(":", 1))[1])


def _lemmas(certificates: Iterable[Certificate]) -> list[str]:
    """The ids of all relations that certificates rest on."""
    found: dict[str, None] = {}
    todo = [name for each in certificates for name in each.get("lemmas", ())]
    while todo:
        if (name := todo.pop()) not in found:
            found[name] = None
            todo += [more for each in lemma(*name.split(":", 1))[1] for more in each.get("lemmas", ())]
    return sorted(found)


def states(finding: Finding, formulas: Iterable[Formula]) -> bool:
    """Whether the certificates claim just these formulas, and what is claimed beside them: sets of equality."""
    claims = [_claim(each) for each in finding.certificates]
    stated: list[Any] = json.loads(json.dumps([*formulas]))
    return claims[: len(stated)] == stated and len(claims) == len(finding.problems)


def _claim(evidence: Certificate) -> Any:
    """What a certificate says; one that rests on lemmas says that they imply it."""
    return evidence["claim"][2] if evidence.get("facts") else evidence["claim"]


def answered(problem: Problem, outcome: Any) -> Verdict:
    """What an answer is worth: its verdict if its certificate holds, else undecided."""
    if not isinstance(outcome, Outcome) or outcome.verdict is Verdict.UNDECIDED:
        return Verdict.UNDECIDED
    try:
        good = holds(json.loads(json.dumps(certificate(problem, outcome))))
    except MALFORMED:
        return Verdict.UNDECIDED
    return outcome.verdict if good else Verdict.UNDECIDED


def is_shown(problem: Problem, outcome: Outcome | None) -> bool:
    """Whether there is a proof, and the checker accepts it."""
    return answered(problem, outcome) is Verdict.PROVED


def problem_of(evidence: Certificate) -> Problem:
    """The statement of a certificate as a problem, lemmas not counted; what its proof is made of are hints."""
    resting = bool(evidence.get("facts"))
    definitions = tuple((name, frozen(term)) for name, term in evidence["defined" if resting else "definitions"])
    assumed = {name: [*formulas] for name, formulas in evidence["hypotheses"].items()}
    for name, formulas in evidence["under"].items() if resting else ():
        own = assumed.setdefault(name, [])
        own += [part for part in formulas if part not in own]
    hypotheses = tuple(
        (name, tuple(part for f in formulas for part in conjuncts(frozen(f)))) for name, formulas in assumed.items()
    )
    hints = tuple(dict.fromkeys(hints_of(evidence.get("proof", {}))))
    return Problem(evidence["id"], frozen(_claim(evidence)), definitions, hypotheses, hints)


def frozen(value: Any) -> Any:
    """JSON lists as tuples."""
    return tuple(map(frozen, value)) if isinstance(value, list) else value


def hints_of(node: Any, read: Callable[[Any], Any] = frozen) -> Iterator[tuple[str, Any]]:
    """The forms and the points that a proof is made of, for a search that looks for a proof of something like it."""
    if isinstance(node, dict):
        if "form" in node:
            yield "form", read(node["form"])
        for name, value in node.get("point", {}).items():
            yield f"point_{name}", read(value)
    for child in node.values() if isinstance(node, dict) else node if isinstance(node, list) else ():
        yield from hints_of(child, read)
