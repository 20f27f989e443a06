"""The one place where the self-test asks the checker, and goes from certificates back to problems."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from typing import Any

from symcheck.evidence.checked import reason
from symcheck.proof import certificate
from symcheck.statement import Certificate, Outcome, Problem, SymcheckError, Verdict


def holds(evidence: Certificate) -> bool:
    """Whether the checker accepts a certificate."""
    return reason(evidence) is None


def all_hold(evidence: Iterable[Certificate]) -> bool:
    """Whether there are certificates, and the checker accepts them all."""
    found = list(evidence)
    return bool(found) and all(map(holds, found))


def answered(problem: Problem, outcome: Any) -> Verdict:
    """What an answer is worth: its verdict if its certificate holds, else undecided."""
    if not isinstance(outcome, Outcome) or outcome.verdict is Verdict.UNDECIDED:
        return Verdict.UNDECIDED
    try:
        good = holds(json.loads(json.dumps(certificate(problem, outcome))))
    except (AssertionError, LookupError, TypeError, ValueError, AttributeError, SymcheckError):
        return Verdict.UNDECIDED
    return outcome.verdict if good else Verdict.UNDECIDED


def problem_of(evidence: Certificate) -> Problem:
    """The statement of a certificate as a problem; the forms and witnesses of its proof are hints."""
    definitions = tuple((name, frozen(term)) for name, term in evidence["definitions"])
    hypotheses = tuple((name, frozen(formulas)) for name, formulas in evidence["hypotheses"].items())
    hints = tuple(dict.fromkeys(_hints(evidence.get("proof", {}))))
    return Problem(evidence["id"], frozen(evidence["claim"]), definitions, hypotheses, hints)


def _hints(node: Any) -> Iterator[tuple[str, Any]]:
    if isinstance(node, dict):
        if "form" in node:
            yield "form", frozen(node["form"])
        for name, value in node.get("point", {}).items():
            yield f"point_{name}", frozen(value)
    for child in node.values() if isinstance(node, dict) else node if isinstance(node, list) else ():
        yield from _hints(child)


def frozen(value: Any) -> Any:
    """JSON lists as tuples."""
    return tuple(map(frozen, value)) if isinstance(value, list) else value
