"""`symcheck errata`: what is wrong as printed, with what is right."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from symcheck.cli.errors import writing
from symcheck.cli.options import SELECTION, AuditOptions, audit_options
from symcheck.cli.records import audited, print_json

if TYPE_CHECKING:
    from symcheck.ledger import Record


@click.command(short_help="List what is wrong as printed, and what is right.")
@SELECTION
@click.option("--json", "as_json", is_flag=True, help="One JSON object with these items instead of text.")
@click.option(
    "--format",
    "kind",
    type=click.Choice(["text", "letter"]),
    default="text",
    show_default=True,
    help="A letter to the authors of one paper instead of the list.",
)
@click.option(
    "--as",
    "form",
    type=click.Choice(["markdown", "latex", "html"]),
    help="How the letter is written.  [default: as the name of the file says, else markdown]",
)
@click.option(
    "--output",
    type=click.Path(dir_okay=False, readable=False, path_type=Path),
    help="The file to write the letter to: .md, .tex or .html.",
)
@audit_options
def errata(
    selection: Sequence[str], as_json: bool, kind: str, form: str | None, output: Path | None, options: AuditOptions
) -> None:
    """List what is wrong as printed, each with what is right: the weightiest first.

    Formulas and statements come one by one, with a counterexample, the corrected form and its proof; rows of lists and
    cells of tables, and slips such as a lost prime, in one table for each kind; last what the text does not say as it
    stands, and is read otherwise.

    `--format letter` writes what an editor expects: numbered corrections with line, printed form, correct form and one
    sentence of reason, and two tables. What only the digitisation damaged is not in it.
    """
    if as_json and kind == "letter":
        raise click.UsageError("--json is another form than a letter; leave one of them out")
    if kind == "text" and (form or output):
        raise click.UsageError("--as and --output are of a letter; add --format letter")
    records = [record for record in audited(selection, options, weigh=as_json) if record.is_erratum]
    if as_json:
        print_json(records)
    elif kind == "letter":
        _write_letter(records, form, output)
    else:
        _list(records)


def _list(records: Sequence[Record]) -> None:
    from symcheck.views import terminal

    out = terminal.console()
    terminal.errata(out, records)
    terminal.counted_errata(out, records)


def _write_letter(records: Sequence[Record], form: str | None, output: Path | None) -> None:
    from symcheck.core.files import put
    from symcheck.views.letter import SUFFIXES, Form, letter, written

    by_name = SUFFIXES.get(output.suffix.lower()) if output else Form.MARKDOWN
    if by_name is None and not form:
        raise click.UsageError(f"{output} ends in none of {', '.join(SUFFIXES)}; add --as markdown, latex or html")
    text = written(letter(records), Form(form) if form else by_name or Form.MARKDOWN)
    if output is None:
        click.echo(text, nl=False)
        return
    with writing(output):
        put(output, text.encode())
    click.echo(f"{output}: {len(text) / 1e3:.0f} kB")
