"""Evidence beside the verdict: which hypotheses are needed, and what a wrong relation should be."""

from __future__ import annotations

import difflib
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from symcheck.evidence.context import Context
from symcheck.evidence.judge import Finding, Unit, judge, lemma
from symcheck.proof import Without, combined, fails_at, fails_without, proof_of
from symcheck.reading import edits, read, to_latex
from symcheck.statement import Erratum, Hypothesis, Item, Method, Problem, Role, SymcheckError, Verdict


def needs(finding: Finding, item: Item, added: tuple[Hypothesis, ...]) -> tuple[dict[str, Any], ...]:
    """Each hypothesis with whether the proof needs it, what is lost without it, and the certificate of that.

    Those that are in force only where an inequality is shown to be an equality come last.
    """
    order, equality = _parts(finding, item)
    rows = [_row(h, _source(h, item, added), _need(finding, order, item, h.name)) for h in (*item.given, *added)]
    known = {row["name"] for row in rows}
    others = [h for h in item.equality_given if h.name not in known and item.equality]
    return (*rows, *(_row(h, "for the set of equality", _need(finding, equality, item, h.name)) for h in others))


def _parts(finding: Finding, item: Item) -> tuple[list[Problem], list[Problem]]:
    """What is claimed, and where it is said to be an equality."""
    apart = [bool(item.equality) and problem.claim[0] == "<=>" for problem in finding.concrete]
    pairs = list(zip(finding.concrete, apart, strict=True))
    return [problem for problem, of in pairs if not of], [problem for problem, of in pairs if of]


def _row(hypothesis: Hypothesis, given: str, need: tuple[bool | None, Without | None]) -> dict[str, Any]:
    needed, lost = need
    return {
        "name": hypothesis.name,
        "words": hypothesis.words,
        "states": hypothesis.states,
        "given": given,
        "needed": needed,
        "lost": lost.loss if lost else "",
        "counterexample": lost.certificate if lost else None,
    }


def _source(hypothesis: Hypothesis, item: Item, added: tuple[Hypothesis, ...]) -> str:
    """Where a hypothesis comes from: printed, implied by the subject, added by us, or part of a statement of ours."""
    if item.role is Role.OURS:
        return "stated"
    if hypothesis in added:
        return "added"
    return "printed" if hypothesis.printed else "standing"


def _need(finding: Finding, claims: Sequence[Problem], item: Item, name: str) -> tuple[bool | None, Without | None]:
    """Left out, does a claim fail (True), or are all proved all the same (False)? A lemma may rest on it (None)."""
    if finding.verdict is not Verdict.PROVED or not claims:
        return None, None
    if not any(name in outcome.used for outcome in finding.outcomes) and name not in _under_lemmas(finding):
        return False, None  # the proof does without it
    without = [replace(problem, hypotheses=tuple(h for h in problem.hypotheses if h[0] != name)) for problem in claims]
    if not item.lemmas and all(p.claim[0] == "=" and proof_of(p) is not None for p in without):
        return False, None
    if (lost := next(filter(None, map(fails_without, without)), None)) is not None:
        return True, lost
    if item.lemmas or any(proof_of(problem) is None for problem in without):
        return None, None
    return False, None


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
    return all(problem.claim[1] != problem.claim[2] and proof_of(problem) is not None for problem in problems)


def _is_empty(finding: Finding) -> bool:
    """Whether an inequality is true only because its sides are equal, always."""
    return finding.verdict is Verdict.PROVED and all(
        problem.claim[0] in ("<=", ">=") and proof_of(replace(problem, claim=("=", *problem.claim[1:]))) is not None
        for problem in finding.concrete
    )
