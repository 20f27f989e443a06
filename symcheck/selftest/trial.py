"""What is planted and what became of it: trials, classes of faults, counts with their limits."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from itertools import chain, islice, zip_longest
from random import Random
from typing import TypeVar

from symcheck.ledger import Record
from symcheck.ledger.selftested import MISFITS

T = TypeVar("T")


class Status(StrEnum):
    """What became of something planted (all but the last two), or of something right."""

    REJECTED = "rejected"
    ACCEPTED = "accepted"
    EQUIVALENT = "equivalent"  # shown to say the same, so that it is no fault
    WEAKER = "weaker"  # shown to be true, and to say less
    STRONGER = "stronger"  # shown to be true, and to say more
    OPEN = "open"  # not decided: whether it is a fault, or how much it says
    KEPT = "kept"
    FALSELY_REJECTED = "falsely rejected"


PLANTED = (Status.REJECTED, Status.ACCEPTED, Status.EQUIVALENT, Status.WEAKER, Status.STRONGER, Status.OPEN)


@dataclass(frozen=True)
class Trial:
    """One thing planted: of which kind, what it is in words, its status, and whether its dimensions do not fit."""

    kind: str
    what: str
    status: Status
    misfit: bool = False

    @property
    def is_error(self) -> bool:
        """Whether the audit was wrong: a fault went unnoticed, or something right was rejected."""
        return self.status in (Status.ACCEPTED, Status.FALSELY_REJECTED)


@dataclass(frozen=True)
class FaultClass:
    """One class of faults; each module of this package that declares a CLASS is one.

    kinds   the kinds of its faults, and of right things that must not be rejected
    share   how many of 10,000 faults are planted in it (of a class of right things: how many of these)
    places  where: texts from which a worker process finds the place again
    trials  at one place about so many, drawn with the seeded generator; fewer if the place has no more
    documents  whether they are planted in what documents of one's own print, and not in papers
    by_paper  whether the places are ids of relations, and faults are counted by paper as well as by kind
    """

    name: str
    says: str
    kinds: tuple[str, ...]
    share: int
    places: Callable[[Sequence[Record]], Sequence[str]]
    trials: Callable[[str, int, Random], Iterable[Trial]]
    documents: bool = False
    by_paper: bool = False


@dataclass
class Count:
    """How many trials of one kind have each status, the errors in words, and how many dimension alone exposes."""

    statuses: Counter[Status] = field(default_factory=Counter)
    errors: list[str] = field(default_factory=list)
    misfits: int = 0

    def add(self, trial: Trial) -> None:
        """Count one more trial."""
        self.statuses[trial.status] += 1
        self.misfits += trial.misfit
        if trial.is_error:
            self.errors.append(f"{trial.status} {trial.kind}: {trial.what}")

    def merge(self, other: Count) -> None:
        """Add all trials of another count."""
        self.statuses += other.statuses
        self.misfits += other.misfits
        self.errors += other.errors

    @property
    def planted(self) -> int:
        return sum(self.statuses[status] for status in PLANTED)

    @property
    def right(self) -> int:
        """How many right things were shown to the audit."""
        return self.statuses[Status.KEPT] + self.statuses[Status.FALSELY_REJECTED]

    def to_json(self) -> dict[str, object]:
        """How many there are of each status, the rates with their 95 % limits, and the errors in words."""
        faults = self.statuses[Status.REJECTED] + self.statuses[Status.ACCEPTED]
        return {
            "planted": self.planted,
            **{str(status): self.statuses[status] for status in PLANTED},
            MISFITS: self.misfits,
            "right": self.right,
            "false_rejections": self.statuses[Status.FALSELY_REJECTED],
            "rejected_of_faults": limits(self.statuses[Status.REJECTED], faults),
            "false_rejections_of_right": limits(self.statuses[Status.FALSELY_REJECTED], self.right),
            "errors": self.errors,
        }


def limits(count: int, of: int) -> list[float] | None:
    """The rate count/of with its 95 % limits (Clopper and Pearson), as [low, rate, high]; None of nothing."""
    from scipy.stats import binomtest

    if not of:
        return None
    interval = binomtest(count, of).proportion_ci(0.95, method="exact")
    return [float(interval.low), count / of, float(interval.high)]


def total(counts: Iterable[Count]) -> Count:
    """All counts in one."""
    result = Count()
    for count in counts:
        result.merge(count)
    return result


def drawn(
    members: Iterable[tuple[str, T]], count: int, rng: Random, rare: Sequence[str] = ()
) -> Iterator[tuple[str, T]]:
    """So many members with their kinds, in a random order in which the kinds take turns, rare ones first."""
    by_kind: dict[str, list[T]] = {}
    for kind, member in members:
        by_kind.setdefault(kind, []).append(member)
    return islice(mixed(by_kind, rng, rare), count)


def mixed(by_kind: Mapping[str, Sequence[T]], rng: Random, rare: Sequence[str] = ()) -> Iterator[tuple[str, T]]:
    """All members with their kinds, in a random order in which the kinds take turns: every kind occurs early."""
    order = sorted(rng.sample(list(by_kind), len(by_kind)), key=lambda kind: kind not in rare)
    shuffled = [[(kind, member) for member in rng.sample(by_kind[kind], len(by_kind[kind]))] for kind in order]
    rows: Iterable[tuple[tuple[str, T] | None, ...]] = zip_longest(*shuffled)
    return (pair for pair in chain.from_iterable(rows) if pair is not None)
