"""Identities and near misses of a handbook kind: no verdict is wrong, and nearly all of them are decided."""

from __future__ import annotations

from collections import Counter

import pytest
from handbook import IDENTITIES as FAMILIES
from handbook import Case, cases

from symcheck import decide

TRUTH = {"proved": True, "refuted": False}
DECIDED = 0.9


def judged(drawn: list[Case]) -> Counter[str]:
    """How many are right and how many are not decided; no verdict is wrong."""
    counts: Counter[str] = Counter()
    for case in drawn:
        answer = decide(case.relation, given=case.given)
        known = TRUTH.get(answer.verdict)
        assert known in (None, case.true), (case, answer.reading, answer.counterexample)
        counts["undecided" if known is None else "right"] += 1
    return counts


def test_a_sample_of_the_handbook_is_decided_rightly() -> None:
    counts = judged([*cases(2 * len(FAMILIES), seed=7)])
    assert counts["right"] >= DECIDED * counts.total()


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
def test_three_hundred_identities_and_as_many_near_misses_are_decided_rightly(seed: int) -> None:
    counts = judged([*cases(300, seed)])
    assert counts.total() == 600
    assert counts["right"] >= DECIDED * counts.total()


def test_the_handbook_is_the_same_for_the_same_seed_and_half_of_it_is_false() -> None:
    drawn = [*cases(20, seed=3)]
    assert drawn == [*cases(20, seed=3)]
    assert sum(case.true for case in drawn) == 20
    assert {case.family for case in drawn} == {*FAMILIES}
