"""`symcheck export`: ledger and errata for other tools."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click

from symcheck.cli.errors import writing
from symcheck.cli.options import SELECTION, AuditOptions, audit_options
from symcheck.cli.records import audited
from symcheck.core.counts import number_of
from symcheck.core.files import put
from symcheck.views.exports import format_names, format_of


@click.command(short_help="Write the ledger and the errata for other tools.")
@SELECTION
@click.option("--format", "name", type=click.Choice(format_names()), required=True, help="What to write.")
@click.option(
    "--output",
    type=click.Path(readable=False, path_type=Path),
    help="The file to write, or the folder for a format of many files; default: standard output, or symcheck-FORMAT.",
)
@audit_options
def export(selection: Sequence[str], name: str, output: Path | None, options: AuditOptions) -> None:
    """Write the ledger and the errata for other tools."""
    chosen = format_of(name)
    records = audited(selection, options)
    if chosen.files:
        folder = output or Path(f"symcheck-{name}")
        contents = chosen.files(records)
        for file, text in contents.items():
            with writing(folder / file):
                put(folder / file, text.encode())
        click.echo(f"{folder}: {number_of(len(contents), 'file')}")
    elif chosen.text:
        text = chosen.text(records)
        if output:
            with writing(output):
                put(output, data := text.encode())
            click.echo(f"{output}: {number_of(len(records), 'item')}, {len(data) / 1e6:.2f} MB")
        else:
            click.echo(text, nl=False)
