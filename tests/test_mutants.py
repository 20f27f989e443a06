"""Every single edit of a proved statement is rejected, or says the same; an independent oracle agrees."""

from __future__ import annotations

import random
from collections import Counter
from functools import cache

import pytest

from symcheck import papers
from symcheck.evidence.context import Context
from symcheck.evidence.judge import Unit, judge, units
from symcheck.evidence.mutation import Fate, fate, mutants
from symcheck.evidence.obligation import expand
from symcheck.reading import Iff
from symcheck.selftest import oracle
from symcheck.statement import Hypothesis, Role, Verdict

SAMPLE = 200
POINTS = 3
PARTS = 8


PAPERS = papers.load()
LEAST = {
    "mirer2009": 1000,
    "poloskov2004": 500,
    "esenkov2006": 150,
    "ignatov2005": 3000,
}  # mutants of each that are no equivalents


@cache
def proved_units(key: str) -> list[tuple[Context, Unit, tuple[Hypothesis, ...]]]:
    """Every proved relation that is printed, or an equivalence, with the hypotheses under which it is proved.

    Other statements in words are left out: an implication stays true when its condition is narrowed.
    """
    found, paper = [], PAPERS[key]
    for obligation in expand(paper):
        item = obligation.item
        if item.role not in (Role.CLAIM, Role.OURS):
            continue
        context = Context(paper, item)
        for unit in units(context):
            if unit.letter in item.imposed and unit.letter:
                continue
            if (item.formal or item.parts) and not isinstance(unit.tree, Iff):
                continue
            if unit.letter in item.errata and item.errata[unit.letter].corrected:
                continue
            given = item.given + (item.needs if unit.letter in item.errata else ())
            if judge(context, unit, given).verdict is Verdict.PROVED:
                found.append((context, unit, given))
    return found


@cache
def all_mutants(key: str) -> list[tuple[int, str, str, Unit | None]]:
    return [
        (n, kind, description, mutant)
        for n, (context, unit, _) in enumerate(proved_units(key))
        for kind, description, mutant in mutants(context, unit)
    ]


def disagreement(context: Context, unit: Unit, mutant: Unit, given: tuple[Hypothesis, ...]) -> bool | None:
    """Whether the oracle finds a point where the mutant fails and the original does not.

    None if it cannot sample the hypotheses, or cannot tell the original right (a numeric second derivative).
    """
    rng = random.Random(20090055)
    seen = False
    for n, formula in enumerate(mutant.formulas):
        problem = context.problem(formula, given, context.method(unit.letter))
        original = unit.formulas[n] if len(unit.formulas) == len(mutant.formulas) else None
        for _ in range(POINTS):
            at = oracle.point(problem, rng)
            if at is None:
                continue
            try:
                unfold = dict(problem.definitions)
                if original and not oracle.holds(original, at, unfold | dict(context.used_definitions(original))):
                    continue
                seen = True
                if not oracle.holds(formula, at, unfold):
                    return True
            except (ZeroDivisionError, KeyError):
                continue
    return False if seen else None


def run(key: str, sample: list[tuple[int, str, str, Unit | None]]) -> Counter[str]:
    """Counts by fate. Wrong is what the oracle contradicts, and a proved mutant that the oracle cannot vouch for.

    A proved equation that also holds at every point of the oracle changes nothing under the hypotheses, nor does one
    with the same on both sides; an order that is proved with its set of equality, or an equivalence, says the same as
    the original.
    """
    counts: Counter[str] = Counter()
    wrong = []
    for n, kind, description, mutant in sample:
        context, unit, given = proved_units(key)[n]
        result = fate(context, unit, mutant, given)
        if result in (Fate.ACCEPTED, Fate.EQUIVALENT) and mutant:
            fails = disagreement(context, unit, mutant, given)
            empty = all(formula[1] == formula[2] for formula in mutant.formulas)
            same = isinstance(unit.tree, Iff) or (mutant.formulas[0][0] == "=" and (empty or fails is False))
            if fails or (result is Fate.ACCEPTED and not same):
                wrong.append(f"{context.id}{unit.letter} {result} {kind}: {description}")
            result = Fate.EQUIVALENT
        counts[result] += 1
    assert not wrong
    return counts


@pytest.mark.parametrize("key", LEAST)
def test_no_mutant_of_a_seeded_sample_is_accepted(key: str) -> None:
    counts = run(key, random.Random(55).sample(all_mutants(key), SAMPLE))
    assert counts.total() - counts[Fate.EQUIVALENT] - counts[Fate.MALFORMED] >= 150


def test_every_paper_has_its_mutants() -> None:
    assert LEAST.keys() == PAPERS.keys()


@pytest.mark.slow
@pytest.mark.parametrize("part", range(PARTS))
@pytest.mark.parametrize("key", LEAST)
def test_no_mutant_at_all_is_accepted(key: str, part: int) -> None:
    counts = run(key, all_mutants(key)[part::PARTS])
    print(key, dict(counts))
    assert counts[Fate.REFUTED] + counts[Fate.UNDECIDED] >= LEAST[key] / PARTS
