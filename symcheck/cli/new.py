"""`symcheck new`: an audit of a document, to begin with or brought up to date."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import click

from symcheck.cli.options import cores
from symcheck.cli.records import progress
from symcheck.core.verdicts import SymcheckError


@contextmanager
def _writing() -> Iterator[None]:
    """Where files are written beside one another; SymcheckError names the one that cannot be."""
    try:
        yield
    except OSError as error:
        raise SymcheckError(f"{error.filename} cannot be written ({error.strerror}); name another folder") from error


@click.command(short_help="Begin the audit of a document, or update one.")
@click.argument("file", type=click.Path(path_type=Path))
@click.option(
    "--out", type=click.Path(path_type=Path), default=Path("audit"), show_default=True, help="The folder to write to."
)
@click.option("--update", is_flag=True, help="FILE is the folder of an audit whose source was edited.")
@click.option("--jobs", type=click.IntRange(0), default=cores, show_default="cores", help="Worker processes.")
def new(file: Path, out: Path, update: bool, jobs: int) -> None:
    """Begin the audit of a document: `audit.py`, which is yours to edit, and `audit.lock`, what was accepted.

    FILE is what `symcheck look` reads. Each relation is one line that names its label, number or line; what is printed
    is read from the document each time. The role of each relation and what it follows from are guessed. After the
    document was edited, `symcheck new --update audit/` accepts it: it lists what has changed, finds what has moved, and
    adds what is new. Nothing that is there is overwritten.
    """
    from symcheck.audit.library import executor
    from symcheck.document import scaffold
    from symcheck.document.work import Work

    with progress("reading") as move, executor(jobs, ["symcheck.document.checks"]).kept() as workers, _writing():
        work = Work(workers, move)
        done = scaffold.update(file, work) if update else scaffold.new(file, out, work)
    for line in done:
        click.echo(line)
    if not update:
        click.echo(f"Now `symcheck check {out}` decides what it can.")
