"""`symcheck selftest`: plants faults and counts those that go unnoticed."""

from __future__ import annotations

import json
from collections.abc import Sequence

import click

from symcheck.cli.errors import DIFFERS, say
from symcheck.cli.options import SELECTION, AuditOptions, audit_options
from symcheck.cli.records import audited, progress


@click.command(short_help="Plant faults and count those that go unnoticed.")
@SELECTION
@click.option("--json", "as_json", is_flag=True, help="One JSON object with all counts instead of the table.")
@click.option("--seed", type=int, default=0, show_default=True, help="The same seed plants the same faults.")
@click.option("--faults", type=click.IntRange(1), default=21_000, show_default=True, help="About how many to plant.")
@click.option("--record", "recording", is_flag=True, help="Keep the result in generated/, for the report.")
@audit_options
def selftest(
    selection: Sequence[str], as_json: bool, seed: int, faults: int, recording: bool, options: AuditOptions
) -> None:
    """Plant faults and count those that go unnoticed: the error rate of the audit itself.

    In statements, hypotheses, certificates, kernels, notation tables and proof methods; and true statements written
    otherwise, which must not be rejected. Without a selection: in all papers. In the folder of an audit faults are
    planted in the relations that are proved, as the document prints them. Exit code 1 if fewer than 99.9 % of the
    faults were rejected, or anything right was.
    """
    from symcheck.audit.library import executor
    from symcheck.selftest.run import classes, run
    from symcheck.selftest.table import show

    if recording and selection:
        raise click.UsageError("--record keeps what became of all papers; leave the selection out")
    records = audited(selection, options)
    modules = [fault_class.places.__module__ for fault_class in classes().values()]
    with progress("planting faults") as move:
        result = run(records, executor(options.jobs, modules), faults, seed, move)
    content = result.to_json()
    if recording:
        from symcheck import kernels
        from symcheck.ledger import selftested
        from symcheck.views import figures

        say(f"{selftested.record(kernels.folder(), content, records)} written")
        figures.write(kernels.folder())
    if as_json:
        click.echo(json.dumps(content, ensure_ascii=False, indent=1))
    else:
        from symcheck.views.terminal import console

        show(console(), content)
    if not result.is_sound:
        raise click.exceptions.Exit(DIFFERS)
