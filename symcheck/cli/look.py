"""`symcheck look`: the first look at a document, without a declaration."""

from __future__ import annotations

import json
from pathlib import Path

import click

from symcheck.cli.errors import DIFFERS
from symcheck.cli.options import cores
from symcheck.cli.records import progress


@click.command(short_help="Take a first look at a document, without declarations.")
@click.argument("file", type=click.Path(path_type=Path))
@click.option("--json", "as_json", is_flag=True, help="One JSON object with all of it.")
@click.option("--jobs", type=click.IntRange(1), default=cores, show_default="cores", help="Worker processes.")
def look(file: Path, as_json: bool, jobs: int) -> None:
    """Look at a document for the first time, without a single declaration.

    FILE is LaTeX, Markdown (also of Quarto and MyST), reStructuredText, or a notebook. Its displays and inline
    relations are read, with all macros expanded and all letters inferred together. Then comes what holds for all values
    of the letters, and last what to look at: what fails although everything that it needs is defined before it. Nothing
    is written. Exit codes: 0 nothing to look at, 1 something, 2 bad input.
    """
    from symcheck.document.look import look as looked
    from symcheck.views.look import text

    with progress("looking") as move:
        found = looked(file, jobs=jobs, progress=move)
    click.echo(json.dumps(found.as_json(), ensure_ascii=False) if as_json else text(found))
    raise click.exceptions.Exit(DIFFERS if found.findings else 0)
