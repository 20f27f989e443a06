"""Every single slip in a proved statement is rejected, or shown to say something true; an oracle agrees."""

from __future__ import annotations

import random
from collections import Counter

import pytest

from symcheck import papers
from symcheck.audit.obligation import expand
from symcheck.core.claims import Assertion
from symcheck.reading import Edit
from symcheck.selftest.statements import Proved, proved, slips, status_of
from symcheck.selftest.trial import Status

DECLARATIONS, SAMPLE = 5, 8
PARTS = 8
PAPERS = papers.load()
LEAST = {
    "mirer2009": 1000,
    "poloskov2004": 500,
    "esenkov2006": 150,
    "ignatov2005": 3000,
}  # slips in each that are faults


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


@pytest.mark.parametrize("key", LEAST)
def test_no_slip_of_a_seeded_sample_is_accepted(key: str) -> None:
    rng = random.Random(55)
    counts = run(rng.sample(slips_of(rng.sample(decided(key), DECLARATIONS)), SAMPLE))
    assert counts[Status.REJECTED] >= SAMPLE / 2


def test_every_paper_has_its_slips() -> None:
    assert LEAST.keys() == PAPERS.keys()


@pytest.mark.slow
@pytest.mark.parametrize("part", range(PARTS))
@pytest.mark.parametrize("key", LEAST)
def test_no_slip_at_all_is_accepted(key: str, part: int) -> None:
    counts = run(slips_of(decided(key)[part::PARTS]))
    print(key, dict(counts))
    assert counts[Status.REJECTED] >= LEAST[key] / PARTS / 2
