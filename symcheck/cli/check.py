"""`symcheck check`: decides, prints the ledger, and compares the verdicts with those recorded."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from symcheck.cli.errors import BAD_INPUT, DIFFERS, MAX_LINES, say
from symcheck.cli.options import AGAINST, SELECTION, AuditOptions, audit_options
from symcheck.cli.records import audited, print_json
from symcheck.core.counts import number_of
from symcheck.core.verdicts import Verdict

if TYPE_CHECKING:
    from symcheck.ledger import Record
    from symcheck.ledger.changes import Change


@click.command(short_help="Decide relations, and compare the verdicts with those recorded.")
@SELECTION
@click.option("--json", "as_json", is_flag=True, help="One JSON object with all items instead of the table.")
@click.option(
    "--format",
    "form",
    type=click.Choice(["table", "plain", "sarif"]),
    default="table",
    show_default=True,
    help="For the list of problems of an editor: `file:line: verdict: message`, or SARIF 2.1.0.",
)
@click.option("--verdict", type=click.Choice([str(v) for v in Verdict]), help="Show only rows of this verdict.")
@AGAINST
@audit_options
def check(
    selection: Sequence[str],
    as_json: bool,
    form: str,
    verdict: str | None,
    against: Path | None,
    options: AuditOptions,
) -> None:
    """Decide the relations and compare the verdicts with those recorded.

    Without a selection: all papers. `mirer2009:2.1` also means its links 2.1a, 2.1b.
    """
    from symcheck.audit import Interrupted
    from symcheck.ledger.changes import changes, older

    if as_json and form != "table":
        raise click.UsageError("--json is another format; leave one of them out")
    if against and form != "table":
        raise click.UsageError(f"--against is told in the table and with --json, not as {form}; leave one of them out")
    form = "json" if as_json else form
    before = older(against) if against else None
    try:
        records = audited(selection, options, weigh=as_json)
    except Interrupted as stop:
        _print_ledger(stop.records, form, verdict, partial=True)
        raise
    told = None
    if against and before is not None:
        told = str(against), changes(records, before, lambda key: not selection or key in selection)
    _print_ledger(records, form, verdict, told=told)
    _compare(selection, records, form != "table")


def _print_ledger(
    records: Sequence[Record],
    form: str,
    verdict: str | None,
    partial: bool = False,
    told: tuple[str, Sequence[Change]] | None = None,
) -> None:
    """The rows of a verdict; a ledger that is partial says so before and after. What changed since another is last."""
    selected = [record for record in records if verdict is None or record.verdict == verdict]
    if form == "json":
        print_json(selected, partial, told)
        return
    if form != "table":
        from symcheck.views import diagnostics

        click.echo(diagnostics.FORMATS[form](selected))
        return
    from symcheck import papers
    from symcheck.ledger import by_paper
    from symcheck.views import terminal

    out = terminal.console()
    note = "PARTIAL: interrupted before all relations were decided" if partial else ""
    out.print(note, end="\n" * partial)
    for key, rows in by_paper(selected).items():
        terminal.ledger(out, key, rows)
    terminal.findings(out, selected)
    if told:
        terminal.changes(out, *told)
    terminal.summary(out, records)
    terminal.next_steps(out, selected, papers.load().folders)
    out.print(note, end="\n" * partial)


def _compare(selection: Sequence[str], records: Sequence[Record], quiet: bool) -> None:
    """Tell how the verdicts differ from those recorded, and exit 1 if they do."""
    from symcheck import papers
    from symcheck.audit import outputs
    from symcheck.ledger import by_paper, store

    differing = [note for key in by_paper(records) for note in papers.load()[key].notes]
    for key, rows in by_paper(records).items():
        complete = not selection or key in selection
        differing += store.disagreements(rows, store.expected(outputs.folder(key), key), complete)
    for line in differing[:MAX_LINES]:
        say(line)
    if len(differing) > MAX_LINES:
        say(f"and {number_of(len(differing) - MAX_LINES, 'more difference')}; ask for a smaller selection to see them")
    if not selection and {*papers.load()} > {record.paper for record in records}:
        raise click.exceptions.Exit(BAD_INPUT)  # of the others it was said why they cannot be read
    if differing:
        raise click.exceptions.Exit(DIFFERS)
    if not quiet:
        click.echo("All verdicts are those recorded.")
