"""Hypotheses dropped, added, or contradicted: the audit must miss the first, and report the others."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from itertools import islice
from random import Random

from symcheck import papers
from symcheck.audit import expand
from symcheck.audit.judge import judge
from symcheck.audit.needs import listed, need
from symcheck.core.claims import Assertion, Hypothesis
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.reading import System, Tree, read, to_latex
from symcheck.reading.tree import Chain
from symcheck.selftest.evidence import ledger_verdict, states
from symcheck.selftest.statements import Proved, places, proved
from symcheck.selftest.trial import FaultClass, Status, Trial, mixed

CONTRARY = {"=": r"\ne", r"\ne": "=", "<": r"\ge", r"\ge": "<", ">": r"\le", r"\le": ">"}
DROPPED, ADDED, CONTRADICTORY = "dropped", "added", "contradictory"
OTHERS = 3  # foreign hypotheses that may be added to a relation


def without(original: Proved, dropped: Hypothesis) -> Status:
    """Whether the proof fails without a hypothesis; it is not needed if there is another, accepted and without it."""
    finding = judge(original.context, original.unit, tuple(h for h in original.given if h != dropped))
    if ledger_verdict(original.context, original.unit, finding) is not Verdict.PROVED:
        return Status.REJECTED
    shown = states(finding, original.unit.formulas)
    free = all(dropped.name not in certificate["hypotheses"] for certificate in finding.certificates)
    return Status.EQUIVALENT if shown and free else Status.ACCEPTED


def having(original: Proved, added: Hypothesis) -> Status:
    """Whether a hypothesis that has nothing to do with a relation is reported as not needed; open if as unknown."""
    context, unit, given, _ = original
    statement = replace(context.item.statement, given=(*context.item.statement.given, added))
    item = replace(context.item, statement=statement)
    try:
        finding = judge(context.having(item=item), unit, (*given, added))
    except SymcheckError:
        return Status.REJECTED  # it speaks of letters that are unknown here
    if ledger_verdict(context, unit, finding) is not Verdict.PROVED:
        return Status.REJECTED
    proved = [*zip(finding.concrete, finding.certificates, strict=True)]
    row = next(row for row in listed(item, ()) if row.name == added.name)
    return {False: Status.REJECTED, None: Status.OPEN, True: Status.ACCEPTED}[need(row, proved, item).needed]


def contradicted(original: Proved, contrary: Hypothesis) -> Status:
    """Whether a relation is no longer proved when its hypotheses contradict one another, and anything would follow."""
    finding = judge(original.context, original.unit, (*original.given, contrary))
    verdict = ledger_verdict(original.context, original.unit, finding)
    return Status.ACCEPTED if verdict is Verdict.PROVED else Status.REJECTED


def contrary(original: Proved, hypothesis: Hypothesis) -> Hypothesis | None:
    """A hypothesis that says the opposite of every relation in another one, where it is made of relations."""
    tree = read(hypothesis.states, original.context.notation)
    opposite = _opposite(tree)
    return Hypothesis(f"not {hypothesis.name}", "the contrary", to_latex(opposite)) if opposite else None


def _opposite(tree: Tree) -> Tree | None:
    if isinstance(tree, System) and tree.parts:
        first = _opposite(tree.parts[0])
        return replace(tree, parts=(first,)) if first else None
    if isinstance(tree, Chain) and len(tree.signs) == 1 and tree.signs[0] in CONTRARY:
        return replace(tree, signs=(CONTRARY[tree.signs[0]],))
    return None


@cache
def _of_paper(key: str) -> tuple[Hypothesis, ...]:
    """All hypotheses of the claims of a paper."""
    claims = (each.item for each in expand(papers.load()[key]))
    given = (h for item in claims if isinstance(item, Assertion) for h in item.statement.given)
    return tuple(dict.fromkeys(given))


def trials(place: str, count: int, rng: Random) -> Iterator[Trial]:
    """So many faults in the hypotheses of one declaration, and the hypotheses as they are."""
    by_kind: dict[str, list[tuple[Proved, Hypothesis]]] = {DROPPED: [], ADDED: [], CONTRADICTORY: []}
    for original in proved(place):
        names = {hypothesis.name for hypothesis in original.given}
        foreign = [h for h in _of_paper(original.context.paper.key) if h.name not in names]
        by_kind[DROPPED] += [(original, h) for h in original.given]
        by_kind[ADDED] += [(original, h) for h in rng.sample(foreign, min(OTHERS, len(foreign)))]
        opposites = (contrary(original, h) for h in original.given)
        by_kind[CONTRADICTORY] += [(original, h) for h in opposites if h]
    for kind, (original, hypothesis) in islice(mixed(by_kind, rng), count):
        yield Trial(kind, f"{original.id} {hypothesis.name}", CHECKS[kind](original, hypothesis))


CHECKS = {DROPPED: without, ADDED: having, CONTRADICTORY: contradicted}

CLASS = FaultClass(
    "hypotheses",
    "hypotheses dropped, added, or contradicting one another, before the audit",
    (DROPPED, ADDED, CONTRADICTORY),
    share=120,
    places=places,
    trials=trials,
)
