"""Ledgers as cells show them: how many relations have which verdict, what there is, what is not proved."""

from __future__ import annotations

from collections import Counter

from symcheck.core.verdicts import Role, Verdict
from symcheck.views.model import roles as counted_roles
from symcheck.views.notebook.output import Heading, Output, Part, Table
from symcheck.views.notebook.records import declared, paper, recorded


def ledger(*keys: str) -> Output:
    """How many relations of each paper have which recorded verdict, and how many declarations claim nothing."""
    table = []
    for key in keys:
        counts = Counter(recorded(key).values())
        table.append((key, *(str(counts[verdict]) for verdict in Verdict), str(counts[None])))
    return Output((Table(("paper", *Verdict, "claim nothing"), tuple(table)),))


def contents(key: str) -> Output:
    """The sections of a paper, with the number of declarations of each role."""
    counts: dict[str, Counter[Role]] = {}
    for title, item in declared(key):
        counts.setdefault(title, Counter())[item.role] += 1
    lines = ((title, counted_roles(roles)) for title, roles in counts.items())
    return Output((Heading(f"**{paper(key).title}**"), Table(("section", "declarations"), tuple(lines))))


def not_proved(key: str) -> Output:
    """What is not decided: relations without a verdict, exclusions with their reasons, premises that are assumed."""
    undecided = [id for id, verdict in recorded(key).items() if verdict is Verdict.UNDECIDED]
    items = [item for _, item in declared(key)]
    parts: list[Part] = [Heading(f"**Undecided:** {', '.join(undecided) or 'no relation'}.")]
    for role, words in ((Role.PREMISE, "Assumed"), (Role.EXCLUSION, "Left out, with the reason")):
        found = [item for item in items if item.role is role]
        table = tuple(
            (
                item.number,
                str(item.source.line),
                _in_one_line(item.source.words or item.name.replace("_", " ")),
                _in_one_line(item.reason),
            )
            for item in found
        )
        parts += [Heading(f"**{words} ({len(found)}):**"), Table(("number", "line", "what", "why"), table)]
    return Output(tuple(parts))


def _in_one_line(words: str) -> str:
    return " ".join(words.split())
