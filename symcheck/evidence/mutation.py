"""Single edits of proved statements: each must be rejected, or be recognised exactly as saying the same."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum

from symcheck.evidence.context import Context
from symcheck.evidence.judge import Unit, judge
from symcheck.proof import equivalent
from symcheck.reading import edits, to_latex
from symcheck.statement import Hypothesis, SymcheckError, Verdict


class Fate(StrEnum):
    """What became of a mutant."""

    REFUTED = "refuted"
    UNDECIDED = "undecided"
    MALFORMED = "malformed"
    EQUIVALENT = "equivalent"
    ACCEPTED = "accepted"


@dataclass(frozen=True)
class Mutant:
    """An edited statement with its fate."""

    id: str
    kind: str
    edit: str
    statement: str
    fate: Fate


def mutants(context: Context, unit: Unit) -> Iterator[tuple[str, str, Unit | None]]:
    """Kind, description and reworded unit of every single edit (None: the edit makes no statement)."""
    for edit in edits(unit.tree, context.notation):
        try:
            yield edit.kind, edit.description, unit.reworded(context, edit.tree)
        except SymcheckError:
            yield edit.kind, edit.description, None


def fate(context: Context, unit: Unit, mutant: Unit | None, given: tuple[Hypothesis, ...]) -> Fate:
    """Decide one mutant of a proved unit."""
    if mutant is None or len(mutant.formulas) != len(unit.formulas):
        return Fate.MALFORMED
    if _same(context, unit, mutant, given):
        return Fate.EQUIVALENT
    verdict = judge(context.having(doubted=True), mutant, given).verdict
    return {Verdict.PROVED: Fate.ACCEPTED, Verdict.REFUTED: Fate.REFUTED}.get(verdict, Fate.UNDECIDED)


def _same(context: Context, unit: Unit, mutant: Unit, given: tuple[Hypothesis, ...]) -> bool:
    """Whether the edit leaves the meaning alone, instance by instance, under the hypotheses."""
    method = context.method(unit.letter)
    return all(
        equivalent(before, after, context.problem(("and", before, after), given, method, n))
        for n, (before, after) in enumerate(zip(unit.formulas, mutant.formulas, strict=True))
    )


def audit(context: Context, unit: Unit, given: tuple[Hypothesis, ...]) -> Iterator[Mutant]:
    """Every mutant of one proved unit with its fate."""
    for kind, description, mutant in mutants(context, unit):
        text = to_latex(mutant.tree) if mutant else ""
        yield Mutant(context.id + unit.letter, kind, description, text, fate(context, unit, mutant, given))
