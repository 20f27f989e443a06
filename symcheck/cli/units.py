"""`symcheck units`: what the letters of a paper measure."""

from __future__ import annotations

import json
from dataclasses import asdict

import click

from symcheck.cli.completion import relations
from symcheck.cli.options import keyed
from symcheck.core.verdicts import SymcheckError


@click.command(short_help="List the letters of a paper with what each measures.")
@click.argument("key", metavar="PAPER", callback=keyed, shell_complete=relations)
@click.option("--json", "as_json", is_flag=True, help="A JSON list of objects instead of the table.")
def units(key: str, as_json: bool) -> None:
    """List the letters of a paper with what each measures: as declared, or from which relation it follows."""
    from symcheck import papers
    from symcheck.audit.dimensions import table
    from symcheck.views import terminal

    if key not in (known := papers.load()):
        raise SymcheckError(f"there is no paper {key!r}; known papers: {', '.join(known)}")
    rows = table(known[key])
    if as_json:
        click.echo(json.dumps([asdict(row) for row in rows], ensure_ascii=False))
    else:
        terminal.units(terminal.console(), rows)
