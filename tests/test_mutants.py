"""A single slip in a proved statement is rejected, or shown to say something true; an oracle agrees."""

from __future__ import annotations

import random
from collections import Counter

import pytest

from symcheck import papers
from symcheck.audit import expand
from symcheck.core.claims import Assertion
from symcheck.reading import Edit
from symcheck.selftest.statements import Proved, proved, slips, status_of
from symcheck.selftest.trial import Status

DECLARATIONS, SAMPLE = 5, 8
# all slips take hours, as each that is not rejected is evaluated in full: the self-test samples them
LONG_RUNS, LONG_DECLARATIONS, LONG_SAMPLE = 4, 12, 60
PAPERS = papers.load()


def decided(key: str) -> list[str]:
    return [each.id for each in expand(PAPERS[key]) if isinstance(each.item, Assertion)]


def slips_of(ids: list[str]) -> list[tuple[Proved, Edit]]:
    """All slips in all proved relations of some declarations."""
    return [(original, edit) for id in ids for original in proved(id) for edit in slips(original)]


def run(sample: list[tuple[Proved, Edit]]) -> Counter[Status]:
    """Counts by status; none is accepted."""
    statuses = [(status_of(original, edit), f"{original.id} {edit.description}") for original, edit in sample]
    assert [what for each, what in statuses if each is Status.ACCEPTED] == []
    return Counter(each for each, _ in statuses)


@pytest.mark.parametrize("key", PAPERS)
def test_no_slip_of_a_seeded_sample_is_accepted(key: str) -> None:
    rng = random.Random(55)
    counts = run(rng.sample(slips_of(rng.sample(decided(key), DECLARATIONS)), SAMPLE))
    assert counts[Status.REJECTED] >= SAMPLE / 2


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(LONG_RUNS))
@pytest.mark.parametrize("key", PAPERS)
def test_no_slip_of_a_long_seeded_sample_is_accepted(key: str, seed: int) -> None:
    rng = random.Random(seed)
    counts = run(rng.sample(slips_of(rng.sample(decided(key), LONG_DECLARATIONS)), LONG_SAMPLE))
    assert counts[Status.REJECTED] >= LONG_SAMPLE / 4
