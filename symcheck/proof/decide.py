"""What every method does: look for a proof; failing that, for an exact counterexample; failing that, say why."""

from __future__ import annotations

from collections.abc import Callable

from symcheck.proof.certificate import references
from symcheck.proof.knowledge import Knowledge, ring_of, starting
from symcheck.proof.polynomial import Ring, Unsupported
from symcheck.proof.refute import refute
from symcheck.statement import Certificate, Outcome, Problem, Verdict

Search = Callable[[Problem, Ring], Certificate | None]


def decide(problem: Problem, search: Search) -> Outcome:
    """Proved with a rule tree, refuted with a point, or undecided with the reason; never an exception for a statement."""
    try:
        ring = ring_of(problem)
        proof = search(problem, ring)
        if proof is not None:
            return _proved(problem, ring, proof)
        point = refute(problem)
    except Unsupported as error:
        return Outcome(Verdict.UNDECIDED, reason=str(error))
    if point is not None:
        return Outcome(Verdict.REFUTED, point=point, used=tuple(name for name, _ in problem.hypotheses))
    return Outcome(Verdict.UNDECIDED, reason="neither a proof nor a counterexample was found within the limits of the search")


def _proved(problem: Problem, ring: Ring, proof: Certificate) -> Outcome:
    """Completes a proof: the denominators' side conditions and the list of what it rests on."""
    given = references(proof) | {tuple(item) for item in proof.pop("given", ())}
    extra, nonzero = side_conditions(starting(problem, ring), ring, given, problem)
    given |= extra
    if nonzero:
        proof["nonzero"] = nonzero
    proof["given"] = sorted([name, k] for name, k in given)
    names = {name for name, _ in given}
    return Outcome(Verdict.PROVED, proof=proof, used=tuple(name for name, _ in problem.hypotheses if name in names))


def side_conditions(
    known: Knowledge, ring: Ring, given: set[tuple[str, int]], problem: Problem
) -> tuple[set[tuple[str, int]], list[str]]:
    """(hypotheses that say that denominators are not zero, denominators about which none does)."""
    used: set[tuple[str, int]] = set()
    listed: list[str] = []
    for text, divisor in _divisors(problem, ring, given).items():
        refs = known.nonzero(divisor)
        if refs is None:
            listed.append(text)
        else:
            used |= {(ref[1], ref[2]) for ref in refs}
    return used, sorted(listed)


def _divisors(problem: Problem, ring: Ring, given: set[tuple[str, int]]) -> dict[str, object]:
    """The denominators of everything the ring has met in this proof."""
    return dict(ring.divisors)
