"""`symcheck report`: the audit as one page."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path

import click

from symcheck.cli.errors import writing
from symcheck.cli.options import AGAINST, SELECTION, AuditOptions, audit_options
from symcheck.cli.records import audited
from symcheck.core.counts import number_of
from symcheck.core.files import put
from symcheck.core.verdicts import SymcheckError


@click.command(short_help="Write the audit as one page for a browser.")
@SELECTION
@click.option(
    "--output",
    type=click.Path(dir_okay=False, readable=False, path_type=Path),
    default=Path("symcheck-report.html"),
    show_default=True,
    help="The file to write.",
)
@click.option("--open", "show", is_flag=True, help="Open the file in the browser of this system.")
@AGAINST
@audit_options
def report(selection: Sequence[str], output: Path, show: bool, against: Path | None, options: AuditOptions) -> None:
    """Write the audit as one page to look at: errata, ledger, certificates, pictures.

    The page needs no network and no server. Notebooks in a folder notebooks/ here are searched for cells that name a
    claim.
    """
    from symcheck import kernels, papers
    from symcheck.ledger import selftested
    from symcheck.ledger.changes import changes, older
    from symcheck.views import pictures
    from symcheck.views.page import sources
    from symcheck.views.page.page import Extras, page

    before = older(against) if against else None
    records, known = audited(selection, options), papers.load()
    changed = () if before is None else changes(records, before, lambda key: not selection or key in selection)
    extras = Extras(
        sources.kernels(known, kernels.folder()),
        sources.cells(Path("notebooks")),
        pictures.envelopes(),
        pictures.densities(),
        pictures.stability(),
        selftested.recorded(kernels.folder()),
        sources.meanings(known, records),
        datetime.now(UTC).date().isoformat(),
        against.name if against else "",
        changed,
    )
    text = page(records, sources.publications(known), extras).encode()
    with writing(output):
        put(output, text)
    click.echo(f"{output}: {number_of(len(records), 'item')}, {len(text) / 1e6:.2f} MB")
    if show and click.launch(str(output)) != 0:
        raise SymcheckError(f"no browser opens {output} here; the file is written")
