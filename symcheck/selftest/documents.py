"""Relations of documents with one slip: each must lose its proof, or say something true all the same.

A slip goes the way of the source: it is printed, and asked again with all that the relation follows from.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from random import Random
from typing import NamedTuple

from symcheck.audit import obligation_of
from symcheck.core.claims import Assertion
from symcheck.core.ids import Id
from symcheck.core.terms import Formula
from symcheck.core.verdicts import Role, Verdict
from symcheck.document.asked import Inquiry
from symcheck.ledger import Record
from symcheck.question import Status as Answered
from symcheck.question.prepare import Reading
from symcheck.reading import Edit, Tree, to_latex
from symcheck.selftest.oracle import fails
from symcheck.selftest.slips import KINDS, every_slip, is_dropped, trials_of
from symcheck.selftest.trial import FaultClass, Status, Trial


class Proved(NamedTuple):
    """A relation of a document that is proved, and how it is read."""

    id: str
    inquiry: Inquiry
    reading: Reading


def is_asked(record: Record) -> bool:
    """Is this a relation of a document, decided as `decide` does it?"""
    return bool(obligation_of(record.declaration).item.question)


def places(records: Sequence[Record]) -> list[str]:
    """The declarations with a proved relation."""
    claims = (r for r in records if r.verdict is Verdict.PROVED and r.role in (Role.CLAIM, Role.OURS))
    return list(dict.fromkeys(str(Id.parse(record.id).declaration) for record in claims))


@cache
def proved(id: str) -> list[Proved]:
    """The proved relations of one declaration; those of matrices of all sizes are planted in as they are read."""
    item = obligation_of(id).item
    inquiry = item.question
    if not isinstance(item, Assertion) or not isinstance(inquiry, Inquiry):
        return []
    found = []
    for letter, link in inquiry.links.items():
        if item.statement.imposes(letter) or inquiry.verdict(link) is not Answered.PROVED:
            continue
        found += [Proved(id + letter, inquiry, reading) for reading in inquiry.readings(link)[:1]]
    return found


def slips(original: Proved) -> Iterator[Edit]:
    """Every single edit of a relation."""
    return every_slip(original.reading.tree, original.reading.inference.notation)


def status_of(original: Proved, edit: Edit) -> Status:
    """What the audit makes of a relation with a slip; what it calls proved is a fault where a point contradicts."""
    latex = to_latex(edit.tree)
    verdict = original.inquiry.verdict(latex)
    if verdict in (Answered.UNREADABLE, Answered.REFUTED):
        return Status.REJECTED
    if verdict is Answered.PROVED and (claims := _claims([original.reading])):  # none of matrices of all sizes

        def stated(tree: Tree) -> list[Formula]:
            same = tree == original.reading.tree
            return claims if same else _claims(original.inquiry.readings(to_latex(tree))[:1])

        if claims == stated(edit.tree):
            dropped = is_dropped(original.reading.tree, edit.tree, stated)
            return Status.ACCEPTED if dropped else Status.EQUIVALENT
    readings = original.inquiry.readings(latex)
    false = any(fails(problem) for reading in readings for problem in reading.problems)
    if verdict is Answered.PROVED:
        return Status.ACCEPTED if false else Status.OPEN  # true, but how much it says is not decided
    return Status.REJECTED if false else Status.OPEN


def _claims(readings: Sequence[Reading]) -> list[Formula]:
    return [problem.claim for reading in readings for problem in reading.problems]


def trials(place: str, count: int, rng: Random) -> Iterator[Trial]:
    """So many slips of the relations of one declaration."""
    return trials_of(proved(place), slips, status_of, count, rng)


CLASS = FaultClass(
    "documents",
    "relations of documents with one slip, before `decide`",
    KINDS,
    share=200,
    places=places,
    trials=trials,
    documents=True,
)
