"""The records that a command asks for, with a progress bar while they are decided, and how they are printed as JSON."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict
from typing import TYPE_CHECKING

import click

from symcheck.cli.errors import say
from symcheck.cli.options import AuditOptions

if TYPE_CHECKING:
    from symcheck.ledger import Record
    from symcheck.ledger.changes import Change


def audited(selection: Iterable[str], options: AuditOptions, *, weigh: bool = True) -> list[Record]:
    """The records of a selection, with which hypotheses are needed if asked; an interrupt says how far it had come."""
    from symcheck.audit import Interrupted, check

    done, total = 0, 0
    try:
        with progress("deciding") as move:

            def follow(now: int, of: int) -> None:
                nonlocal done, total
                done, total = now, of
                move(now, of)

            return check(
                selection,
                jobs=options.jobs,
                timeout=options.timeout,
                cache=options.cache,
                weigh=weigh,
                progress=follow,
                warn=say,
            )
    except Interrupted as stop:
        kept = f"{done} of {total} declarations are decided and kept" if options.cache else "nothing is kept"
        raise Interrupted(stop.records, f"; {kept}") from None


@contextmanager
def progress(what: str) -> Iterator[Callable[[int, int], None]]:
    """A function (done, total) that moves a progress bar, if there is somebody to see it."""
    if not sys.stderr.isatty():
        yield lambda done, total: None
        return
    from symcheck.views.terminal import progress_bar

    with progress_bar(what) as move:
        yield move


def print_json(
    records: Sequence[Record], partial: bool = False, told: tuple[str, Sequence[Change]] | None = None
) -> None:
    """One JSON object with all records, a line for each, and what changed since an older ledger."""
    items = ",\n".join(json.dumps(record.to_json(), ensure_ascii=False) for record in records)
    said = '"partial": true, ' if partial else ""
    if told:
        against = {"against": told[0], "changes": [asdict(each) for each in told[1]]}
        said += json.dumps(against, ensure_ascii=False)[1:-1] + ", "
    click.echo(f'{{"schema": 1, {said}"items": [\n{items}\n]}}')
