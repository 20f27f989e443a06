"""Evidence beside the verdict: which hypotheses are needed, and what a wrong relation should be."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from symcheck.audit.checked import FOR_EQUALITY, reasons
from symcheck.audit.context import Context
from symcheck.audit.judge import Finding, Unit, judge, lemma
from symcheck.core.claims import Erratum, Hypothesis, Item, Method, Outcome, Problem
from symcheck.core.terms import node
from symcheck.core.verdicts import Certificate, Role, SymcheckError, Verdict
from symcheck.proof import Without, certificate, combined, fails_at, fails_without, proof_of
from symcheck.reading import edits, read, to_latex

Shown = tuple[Problem, Outcome]


class Need(NamedTuple):
    """Whether a hypothesis is needed, and what shows it: what is lost without it, or proofs that do without it."""

    needed: bool | None
    lost: Without | None = None
    proofs: tuple[Certificate, ...] = ()


def needs(finding: Finding, item: Item, added: tuple[Hypothesis, ...]) -> tuple[dict[str, Any], ...]:
    """Each hypothesis with whether the proof needs it, what is lost without it, and the certificates of that.

    Those that are in force only where an inequality is shown to be an equality come last.
    """
    order, equality = _parts(finding, item)
    rows = [_row(h, _source(h, item, added), _need(finding, order, item, h.name)) for h in (*item.given, *added)]
    known = {row["name"] for row in rows}
    others = [h for h in item.equality_given if h.name not in known and item.equality]
    return (*rows, *(_row(h, FOR_EQUALITY, _need(finding, equality, item, h.name)) for h in others))


def _parts(finding: Finding, item: Item) -> tuple[list[Shown], list[Shown]]:
    """What is claimed, and where it is said to be an equality."""
    pairs = list(zip(finding.concrete, finding.outcomes, strict=True))
    apart = [bool(item.equality) and problem.claim[0] == "<=>" for problem, _ in pairs]
    return [pair for pair, of in zip(pairs, apart, strict=True) if not of], [
        pair for pair, of in zip(pairs, apart, strict=True) if of
    ]


def _row(hypothesis: Hypothesis, given: str, need: Need) -> dict[str, Any]:
    return {
        "name": hypothesis.name,
        "words": hypothesis.words,
        "states": hypothesis.states,
        "given": given,
        "needed": need.needed,
        "lost": need.lost.loss if need.lost else "",
        "counterexample": need.lost.certificate if need.lost else None,
        "proofs": list(need.proofs),
    }


def _source(hypothesis: Hypothesis, item: Item, added: tuple[Hypothesis, ...]) -> str:
    """Where a hypothesis comes from: printed, implied by the subject, added by us, or part of a statement of ours."""
    if item.role is Role.OURS:
        return "stated"
    if hypothesis in added:
        return "added"
    return "printed" if hypothesis.printed else "standing"


def _need(finding: Finding, claims: Sequence[Shown], item: Item, name: str) -> Need:
    """Left out, does a claim fail (True), or are all proved all the same (False)? A lemma may rest on it (None)."""
    if finding.verdict is not Verdict.PROVED or not claims:
        return Need(None)
    if not any(name in outcome.used for outcome in finding.outcomes) and name not in _under_lemmas(finding):
        return Need(False)  # the proof does without it
    using = [problem for problem, outcome in claims if item.lemmas or name in outcome.used]
    without = [replace(problem, hypotheses=tuple(h for h in problem.hypotheses if h[0] != name)) for problem in using]
    if not item.lemmas and all(p.claim[0] == "=" for p in without) and (proofs := _proofs(without)) is not None:
        return Need(False, proofs=proofs)
    if (lost := next(filter(None, map(fails_without, without)), None)) is not None:
        return Need(True, lost)
    if item.lemmas or (proofs := _proofs(without)) is None:
        return Need(None)
    return Need(False, proofs=proofs)


def _proofs(problems: Iterable[Problem]) -> tuple[Certificate, ...] | None:
    """A certificate for each problem, or None if one has no proof."""
    found = []
    for problem in problems:
        if (outcome := proof_of(problem)) is None:
            return None
        found.append(certificate(problem, outcome))
    return tuple(found)


def _under_lemmas(finding: Finding) -> set[str]:
    """The hypotheses that the lemmas rest on."""
    proofs = (proof for id in finding.lemmas for proof in lemma(*id.split(":", 1))[1])
    return {name for proof in proofs for name in proof["hypotheses"]}


def corrected(context: Context, unit: Unit, erratum: Erratum, printed: Finding) -> tuple[Finding, dict[str, Any]]:
    """The proof of the corrected form, the edit from the printed one, and every single edit that repairs it.

    A sentence is not searched for edits (its words are ours), nor a relation that is true but empty.
    """
    item, edit = context.item, []
    if erratum.corrected:
        right = unit.reworded(context, read(erratum.corrected, context.notation))
        repaired = replace(item, equality="", by=combined(*_methods(item), forms=erratum.forms))
        finding = judge(context.having(item=repaired), right, item.given, item.needs)
        edit = _edit(to_latex(unit.tree), to_latex(right.tree))
    else:
        finding = judge(context, unit, item.given, item.needs)
    searched = bool(erratum.corrected) and not (item.formal or item.parts) and printed.verdict is Verdict.REFUTED
    repairs = _repairs(context, unit, printed) if searched else []
    return finding, {
        "verdict": finding.verdict,
        "reason": finding.reason,
        "certificates": list(finding.certificates),
        "edit": edit,
        "added": [hypothesis.words for hypothesis in item.needs],
        "repairs": repairs if searched else None,
        "unique": len(repairs) == 1 if searched else None,
        "empty": _is_empty(printed),
        "row": bool(erratum.shown),
    }


def _methods(item: Item) -> list[Method]:
    return [method for method in (item.by.values() if isinstance(item.by, Mapping) else [item.by]) if method]


def _edit(before: str, after: str) -> list[dict[str, str]]:
    """The places where two LaTeX forms differ, token by token."""
    tokens = re.compile(r"\\[A-Za-z]+|\\.|\d+|\S")
    left, right = tokens.findall(before), tokens.findall(after)
    matcher = difflib.SequenceMatcher(None, left, right, autojunk=False)
    return [
        {"printed": " ".join(left[i:j]), "corrected": " ".join(right[k:m])}
        for kind, i, j, k, m in matcher.get_opcodes()
        if kind != "equal"
    ]


def _repairs(context: Context, unit: Unit, printed: Finding) -> list[dict[str, str]]:
    """All single edits of the printed relation that are proved and are not empty.

    An edit that is wrong at the printed relation's own counterexample needs no further thought.
    """
    points = [outcome.point["values"] for outcome in printed.outcomes if outcome.point]
    found = []
    for edit in edits(unit.tree, context.notation):
        try:
            changed = unit.reworded(context, edit.tree)
            if _is_proved(context, changed, points):
                found.append({"kind": edit.kind, "edit": edit.description, "relation": to_latex(edit.tree)})
        except SymcheckError:
            continue  # an edit that makes no statement repairs nothing
    return found


def _is_proved(context: Context, unit: Unit, points: list[Any]) -> bool:
    """Whether an edited relation has a proof and is not empty; counterexamples are not looked for."""
    method, given = context.method(unit.letter), (*context.item.given, *context.item.needs)
    problems = [context.problem(formula, given, method, n) for n, formula in enumerate(unit.formulas)]
    if any(fails_at(problem, point) for problem in problems for point in points):
        return False
    if any(problem.claim[1] == problem.claim[2] for problem in problems):
        return False
    return (proofs := _proofs(problems)) is not None and not any(reasons(proofs))


def _is_empty(finding: Finding) -> bool:
    """Whether an inequality is true only because its sides are equal, always."""
    if finding.verdict is not Verdict.PROVED or any(p.claim[0] not in ("<=", ">=") for p in finding.concrete):
        return False
    proofs = _proofs(replace(problem, claim=node("=", *problem.claim[1:])) for problem in finding.concrete)
    return proofs is not None and not any(reasons(proofs))
