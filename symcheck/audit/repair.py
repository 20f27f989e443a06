"""What a wrong relation should be: the proof of its correction, and every single edit that repairs it."""

from __future__ import annotations

import difflib
import re
from dataclasses import replace
from typing import Any

from symcheck.audit.checked import reasons
from symcheck.audit.context import Context
from symcheck.audit.judge import Finding, Unit, judge, proofs
from symcheck.core.claims import Erratum, Hypothesis
from symcheck.core.terms import node
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.ledger import Correction, Edit, Repair
from symcheck.proof import fails_at
from symcheck.reading import Tree, edits, read, to_latex
from symcheck.reading.tree import Div, walk


def corrected(context: Context, unit: Unit, erratum: Erratum, printed: Finding) -> Correction:
    """The proof of the corrected form, the edit from the printed one, and every single edit that repairs it.

    A sentence is not searched for edits (its words are ours), nor a relation that is true but empty.
    """
    statement, edit = context.item.statement, tuple[Edit, ...]()
    if erratum.corrected:
        right = unit.reworded(context, read(erratum.corrected, context.notation))
        finding = judge(context.as_corrected(erratum), right, statement.given, erratum.needs)
        edit = differences(to_latex(unit.tree), to_latex(right.tree))
    else:
        finding = judge(context, unit, statement.given, erratum.needs)
    searched = bool(erratum.corrected) and not context.item.stated and printed.verdict is Verdict.REFUTED
    repairs = _repairs(context, unit, printed, (*statement.given, *erratum.needs)) if searched else None
    return Correction(
        verdict=finding.verdict,
        reason=finding.reason,
        certificates=finding.certificates,
        edit=edit,
        added=tuple(hypothesis.words for hypothesis in erratum.needs),
        repairs=repairs,
        unique=None if repairs is None else len(repairs) == 1,
        empty=_is_empty(printed),
        row=bool(erratum.shown),
        summary=erratum.summary,
        instead=erratum.instead,
    )


def differences(before: str, after: str) -> tuple[Edit, ...]:
    """The places where two LaTeX forms differ, token by token."""
    tokens = re.compile(r"\\[A-Za-z]+|\\.|\d+|\S")
    left, right = tokens.findall(before), tokens.findall(after)
    matcher = difflib.SequenceMatcher(None, left, right, autojunk=False)
    return tuple(
        Edit(printed=" ".join(left[i:j]), corrected=" ".join(right[k:m]))
        for kind, i, j, k, m in matcher.get_opcodes()
        if kind != "equal"
    )


def _repairs(context: Context, unit: Unit, printed: Finding, given: tuple[Hypothesis, ...]) -> tuple[Repair, ...]:
    """All single edits of the printed relation that are proved and are not empty.

    An edit that is wrong at the printed relation's own counterexample needs no further thought.
    """
    points = [outcome.point.values for outcome in printed.outcomes if outcome.point]
    found = []
    for edit in edits(unit.tree, context.notation):
        if _cancels(edit.tree) and not _cancels(unit.tree):
            continue  # nobody writes J_x/J_x
        try:
            changed = unit.reworded(context, edit.tree)
            if _is_proved(context, changed, given, points):
                found.append(Repair(kind=edit.kind, edit=edit.description, relation=to_latex(edit.tree)))
        except SymcheckError:
            continue  # an edit that makes no statement repairs nothing
    return tuple(found)


def _cancels(tree: Tree) -> bool:
    """Whether some fraction has the same above and below."""
    return any(isinstance(node, Div) and node.top == node.bottom for _, node in walk(tree))


def _is_proved(context: Context, unit: Unit, given: tuple[Hypothesis, ...], points: list[Any]) -> bool:
    """Whether an edited relation has a proof and is not empty; counterexamples are not looked for."""
    method = context.method(unit.letter)
    problems = [context.problem(formula, given, method, n) for n, formula in enumerate(unit.formulas)]
    if any(fails_at(problem, point) for problem in problems for point in points):
        return False
    if any(problem.claim[1] == problem.claim[2] for problem in problems):
        return False
    return (found := proofs(problems)) is not None and not any(reasons(found))


def _is_empty(finding: Finding) -> bool:
    """Whether an inequality is true only because its sides are equal, always."""
    if finding.verdict is not Verdict.PROVED or any(p.claim[0] not in ("<=", ">=") for p in finding.concrete):
        return False
    found = proofs(replace(problem, claim=node("=", *problem.claim[1:])) for problem in finding.concrete)
    return found is not None and not any(reasons(found))
