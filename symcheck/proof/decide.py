"""What every method does: look for a proof; failing that, for an exact counterexample; failing that, say why."""

from __future__ import annotations

from collections.abc import Callable

from symcheck.proof.certificate import references, terms_in
from symcheck.proof.counterexample import refute
from symcheck.proof.knowledge import Knowledge, given_of, ring_of, starting
from symcheck.proof.polynomial import Poly, Ring, Unsupported, flatten, sides, unfold, variables
from symcheck.statement import Certificate, Outcome, Problem, Verdict

Search = Callable[[Problem, Ring], Certificate | None]


def decide(problem: Problem, search: Search) -> Outcome:
    """Proved with a rule tree, refuted with a point, or undecided with the reason; no statement raises."""
    try:
        outcome = prove(problem, search)
        if outcome is not None:
            return outcome
        point = refute(problem)
    except Unsupported as error:
        return Outcome(Verdict.UNDECIDED, reason=str(error))
    if point is not None:
        return Outcome(Verdict.REFUTED, point=point, used=tuple(name for name, _ in problem.hypotheses))
    return Outcome(
        Verdict.UNDECIDED, reason="neither a proof nor a counterexample was found within the limits of the search"
    )


def prove(problem: Problem, search: Search) -> Outcome | None:
    """Proved, or None; no counterexample is looked for. Unsupported for terms that have no place in a ring."""
    ring = ring_of(problem)
    proof = search(problem, ring)
    return None if proof is None else _proved(problem, ring, proof)


def _proved(problem: Problem, ring: Ring, proof: Certificate) -> Outcome:
    """Completes a proof: the denominators' side conditions and the list of what it rests on."""
    given = references(proof)
    extra, nonzero = side_conditions(starting(problem, ring), ring, problem, proof, given)
    given |= extra
    if nonzero:
        proof["nonzero"] = nonzero
    proof["given"] = sorted([name, k] for name, k in given)
    names = {name for name, _ in given}
    return Outcome(Verdict.PROVED, proof=proof, used=tuple(name for name, _ in problem.hypotheses if name in names))


def side_conditions(
    known: Knowledge, ring: Ring, problem: Problem, proof: Certificate, given: set[tuple[str, int]]
) -> tuple[set[tuple[str, int]], list[str]]:
    """(hypotheses that say that denominators are not zero, denominators about which none does)."""
    if not ring.divisors and problem.claim[0] != "exists":  # a witness is tried in a ring of its own
        return set(), []
    used: set[tuple[str, int]] = set()
    while True:
        listed: list[str] = []
        before = len(used)
        for text, divisor in _divisors(problem, ring, proof, given | used).items():
            refs = known.nonzero(divisor)
            used |= given_of(refs or ())
            listed += [text] if refs is None else []
        if len(used) == before:
            return used, sorted(listed)


def _divisors(problem: Problem, ring: Ring, proof: Certificate, given: set[tuple[str, int]]) -> dict[str, Poly]:
    """The denominators of the claim, of the hypotheses used and of the terms in the proof."""
    formulas = [problem.claim]
    for name, stated in problem.hypotheses:
        parts = [part for f in stated for part in flatten(f)]
        formulas += [part for k, part in enumerate(parts) if (name, k) in given]
    terms = [side for formula in formulas for side in sides(formula)] + terms_in(proof)
    own = [variables(unfold(term, ring.definitions)) for term in terms]
    fresh = Ring(set(ring.names).union(*own), ring.definitions)
    for term in terms:
        fresh.ratio(term)
    return fresh.divisors
