"""`symcheck lint`: what an audit leaves open, or says in a circle."""

from __future__ import annotations

from collections.abc import Sequence

import click

from symcheck.cli.errors import DIFFERS
from symcheck.cli.options import SELECTION, AuditOptions, audit_options
from symcheck.cli.records import audited


@click.command(short_help="Tell what an audit leaves open.")
@SELECTION
@audit_options
def lint(selection: Sequence[str], options: AuditOptions) -> None:
    """Tell what an audit leaves open: one line each, `file:line: message`.

    Relations without a role, refutations without a correction, claims that fail unless a condition is missing, claims
    that are assumed for their own proof or use a later one, letters without a unit. Exit codes: 0 nothing, 1 something,
    2 bad input.
    """
    from symcheck import papers
    from symcheck.document.lint import faults
    from symcheck.ledger import by_paper
    from symcheck.views import diagnostics

    found = list[str]()
    for key, records in by_paper(audited(selection, options, weigh=False)).items():
        paper = papers.load()[key]
        for item, file, line, message in faults(paper, records):
            at = (
                f"{diagnostics.file_of(paper, item)}:{item.source.line}" if item else f"{diagnostics.near(file)}:{line}"
            )
            found.append(" ".join(f"{at}: {message}".split()))
    for each in dict.fromkeys(found):
        click.echo(each)
    raise click.exceptions.Exit(DIFFERS if found else 0)
