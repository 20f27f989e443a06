"""Identities and near misses of a handbook kind: no verdict is wrong, and most of them are decided."""

from __future__ import annotations

from collections import Counter

import pytest
from handbook import IDENTITIES as FAMILIES
from handbook import Case, cases, pairs

from symcheck import decide

TRUTH = {"proved": True, "refuted": False}
DECIDED = 0.9
PRINTED = 0.75  # of relations as people print them, in whatever notation


def judged(drawn: list[Case]) -> Counter[str]:
    """How many are right and how many are not decided; no verdict is wrong."""
    counts: Counter[str] = Counter()
    for case in drawn:
        answer = decide(case.relation, case.where, case.given, dict(case.letters))
        known = TRUTH.get(answer.verdict)
        assert known in (None, case.true), (case, answer.reading, answer.counterexample)
        counts["undecided" if known is None else "right"] += 1
    return counts


def test_a_sample_of_the_handbook_is_decided_rightly() -> None:
    counts = judged([*cases(len(FAMILIES), seed=7)])
    assert counts["right"] >= DECIDED * counts.total()


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(5))
def test_three_hundred_identities_and_as_many_near_misses_are_decided_rightly(seed: int) -> None:
    counts = judged([*cases(300, seed)])
    assert counts.total() == 600
    assert counts["right"] >= DECIDED * counts.total()


def test_a_sample_of_printed_pairs_is_decided_rightly() -> None:
    judged([case for pair in [*pairs()][::151] for case in pair])


@pytest.mark.slow
@pytest.mark.parametrize("part", sorted({one.family for one, _ in pairs()}))
def test_printed_pairs_are_decided_rightly(part: str) -> None:
    counts = judged([case for pair in pairs() for case in pair if case.family == part])
    assert counts["right"] >= PRINTED * counts.total()


def test_each_printed_pair_is_of_two_relations() -> None:
    drawn = [*pairs()]
    assert len(drawn) > 300
    assert all(one.true and not other.true and one.relation != other.relation for one, other in drawn)
    assert len({(one.relation, one.given, one.where) for one, _ in drawn}) == len(drawn)


def test_the_handbook_is_the_same_for_the_same_seed_and_half_of_it_is_false() -> None:
    drawn = [*cases(20, seed=3)]
    assert drawn == [*cases(20, seed=3)]
    assert sum(case.true for case in drawn) == 20
    assert {case.family for case in drawn} == {*FAMILIES}
