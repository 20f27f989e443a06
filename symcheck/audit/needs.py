"""Which hypotheses a proved relation needs: decided apart from the verdict, as it takes half as long again."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from symcheck.audit.checked import FOR_EQUALITY
from symcheck.audit.judge import proofs
from symcheck.core.claims import Assertion, Hypothesis, Ours
from symcheck.core.problems import Problem
from symcheck.core.verdicts import Certificate
from symcheck.proof import Without, fails_without

Proved = tuple[Problem, Certificate]


class Need(NamedTuple):
    """Whether a hypothesis is needed, and what shows it: what is lost without it, or proofs that do without it."""

    needed: bool | None
    lost: Without | None = None
    proofs: Sequence[Certificate] = ()


def listed(item: Assertion, added: Sequence[Hypothesis]) -> Iterator[dict[str, Any]]:
    """Each hypothesis and where it comes from, without a word on whether it is needed.

    Those that are in force only where an inequality is shown to be an equality come last.
    """
    known = set()
    for hypothesis in (*item.statement.given, *added):
        known.add(hypothesis.name)
        yield _row(hypothesis, _source(hypothesis, item, added))
    for hypothesis in item.statement.equality_given if item.statement.equality else ():
        if hypothesis.name not in known:
            yield _row(hypothesis, FOR_EQUALITY)


def _row(hypothesis: Hypothesis, given: str) -> dict[str, Any]:
    return {"name": hypothesis.name, "words": hypothesis.words, "states": hypothesis.states, "given": given}


def _source(hypothesis: Hypothesis, item: Assertion, added: Sequence[Hypothesis]) -> str:
    """Where a hypothesis comes from: printed, implied by the subject, added by us, or part of a statement of ours."""
    if isinstance(item, Ours):
        return "stated"
    if hypothesis in added:
        return "added"
    return "printed" if hypothesis.printed else "standing"


def weighed(row: Mapping[str, Any], proved: Sequence[Proved], item: Assertion) -> dict[str, Any]:
    """A row of `listed` with whether the hypothesis is needed, what is lost without it, and the certificates of that.

    `proved` are the lowered formulas of the relation and of its set of equality, each with its proof; none if the
    relation is not proved.
    """
    apart = [bool(item.statement.equality) and problem.claim[0] == "<=>" for problem, _ in proved]
    of_equality = row["given"] == FOR_EQUALITY
    claims = [pair for pair, of in zip(proved, apart, strict=True) if of is of_equality]
    need = _need(proved, claims, item, row["name"])
    return {
        **row,
        "needed": need.needed,
        "lost": need.lost.loss if need.lost else "",
        "counterexample": need.lost.certificate if need.lost else None,
        "proofs": [*need.proofs],
    }


def _need(proved: Sequence[Proved], claims: Sequence[Proved], item: Assertion, name: str) -> Need:
    """Left out, does a claim fail (True), or are all proved all the same (False)? A lemma may rest on it (None)."""
    if not claims:
        return Need(None)
    if not any(name in proof["hypotheses"] for _, proof in proved):
        return Need(False)  # the proof does without it
    using = [problem for problem, proof in claims if item.plan.lemmas or name in proof["hypotheses"]]
    without = [replace(problem, hypotheses=tuple(h for h in problem.hypotheses if h[0] != name)) for problem in using]
    if not item.plan.lemmas and all(p.claim[0] == "=" for p in without) and (found := proofs(without)) is not None:
        return Need(False, proofs=found)
    if (lost := next(filter(None, map(fails_without, without)), None)) is not None:
        return Need(True, lost)
    if item.plan.lemmas or (found := proofs(without)) is None:
        return Need(None)
    return Need(False, proofs=found)
