"""`symcheck errata`: what is wrong as printed, with what is right."""

from __future__ import annotations

from collections.abc import Sequence

import click

from symcheck.cli.options import SELECTION, AuditOptions, audit_options
from symcheck.cli.records import audited, print_json


@click.command()
@SELECTION
@click.option("--json", "as_json", is_flag=True, help="One JSON object with these items instead of text.")
@audit_options
def errata(selection: Sequence[str], as_json: bool, options: AuditOptions) -> None:
    """List what is wrong as printed, each with what is right: the weightiest first.

    Formulas and statements come one by one, with a counterexample, the corrected form and its proof; rows of lists and
    cells of tables, and slips such as a lost prime, in one table for each kind; last what the text does not say as it
    stands, and is read otherwise.
    """
    records = [record for record in audited(selection, options, weigh=as_json) if record.corrected]
    if as_json:
        print_json(records)
        return
    from symcheck.core.verdicts import Group
    from symcheck.views import terminal

    out = terminal.console()
    terminal.errata(out, records)
    damaged = sum(record.group is Group.DAMAGED for record in records)
    out.print(f"{len(records) - damaged} errata; {damaged} places of damaged text")
