"""`symcheck notebooks`: executes the notebooks and compares what they show."""

from __future__ import annotations

from collections.abc import Sequence

import click

from symcheck.cli.completion import notebooks as names
from symcheck.cli.errors import DIFFERS, MAX_LINES, needing, say, writing
from symcheck.cli.records import progress
from symcheck.core.counts import number_of


@click.command(short_help="Execute the notebooks and compare them with what is committed.")
@click.option(
    "--only",
    multiple=True,
    metavar="NAME",
    shell_complete=names,
    help="A notebook, 6_errata, or the beginning of its name.",
)
@click.option("--kernel", is_flag=True, help="Run through a Jupyter kernel instead of in this process.")
@click.option("--write", is_flag=True, help="Accept what comes out: write notebooks/ anew.")
def notebooks(only: Sequence[str], kernel: bool, write: bool) -> None:
    """Execute the notebooks and compare what they show with what is committed; pictures are not compared."""
    from symcheck.views.notebook import committed

    differing = []
    for name in committed.names(only):
        with progress(name) as move, needing("notebooks"):
            found = committed.executed(name, kernel, move)
        if write:
            with writing(committed.folder(), "make the folder writable, or leave --write out"):
                committed.write(name, found)
        differences = committed.differences(name, found)
        differing += differences
        cells = sum("execution_count" in cell for cell in found.cells)
        click.echo(f"{name}: {number_of(cells, 'cell')}, {number_of(len(differences), 'differs', 'differ')}")
    for line in differing[:MAX_LINES]:
        say(line)
    if differing:
        say("run `symcheck notebooks --write` to accept what is shown now")
        raise click.exceptions.Exit(DIFFERS)
