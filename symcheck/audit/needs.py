"""Which hypotheses a proved relation needs: decided apart from the verdict, as it takes half as long again."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from symcheck.audit.checked import FOR_EQUALITY
from symcheck.audit.judge import proofs
from symcheck.core.certificates import Certificate
from symcheck.core.claims import Assertion, Hypothesis, Ours
from symcheck.core.problems import Problem
from symcheck.ledger import HypothesisRow, Need
from symcheck.proof import fails_without

Proved = tuple[Problem, Certificate]


def listed(item: Assertion, added: Sequence[Hypothesis]) -> Iterator[HypothesisRow]:
    """Each hypothesis and where it comes from, without whether it is needed.

    Those that are in force only where an inequality is shown to be an equality come last.
    """
    known = set()
    for hypothesis in (*item.statement.given, *added):
        known.add(hypothesis.name)
        yield _row(hypothesis, _source(hypothesis, item, added))
    for hypothesis in item.statement.equality_given if item.statement.equality else ():
        if hypothesis.name not in known:
            yield _row(hypothesis, FOR_EQUALITY)


def _row(hypothesis: Hypothesis, given: str) -> HypothesisRow:
    return HypothesisRow(name=hypothesis.name, words=hypothesis.words, states=hypothesis.states, given=given)


def _source(hypothesis: Hypothesis, item: Assertion, added: Sequence[Hypothesis]) -> str:
    """Where a hypothesis comes from: printed, implied by the subject, added by us, or part of a statement of ours."""
    if isinstance(item, Ours):
        return "stated"
    if hypothesis in added:
        return "added"
    return "printed" if hypothesis.printed else "standing"


def need(row: HypothesisRow, proved: Sequence[Proved], item: Assertion) -> Need:
    """Left out, does a claim fail (True), or are all proved all the same (False)? A lemma may rest on it (None).

    `proved` are the lowered formulas of the relation and of its set of equality, each with its proof; none if the
    relation is not proved.
    """
    lemmas = item.plan.lemmas
    apart = [bool(item.statement.equality) and problem.claim[0] == "<=>" for problem, _ in proved]
    of_equality = row.given == FOR_EQUALITY
    claims = [pair for pair, of in zip(proved, apart, strict=True) if of is of_equality]
    if not claims:
        return Need(needed=None)
    if not any(row.name in proof["hypotheses"] for _, proof in proved):
        return Need(needed=False)  # the proof does without it
    using = [problem for problem, proof in claims if lemmas or row.name in proof["hypotheses"]]
    without = [replace(p, hypotheses=tuple(h for h in p.hypotheses if h[0] != row.name)) for p in using]
    if not lemmas and all(p.claim[0] == "=" for p in without) and (found := proofs(without)) is not None:
        return Need(needed=False, proofs=found)
    if (lost := next(filter(None, map(fails_without, without)), None)) is not None:
        return Need(needed=True, lost=lost.loss, counterexample=lost.certificate)
    if lemmas or (found := proofs(without)) is None:
        return Need(needed=None)
    return Need(needed=False, proofs=found)
