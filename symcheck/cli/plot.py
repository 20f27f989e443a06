"""`symcheck plot`: draws a figure of the numeric layer."""

from __future__ import annotations

from pathlib import Path

import click

from symcheck.cli.completion import figures
from symcheck.cli.errors import needing, writing
from symcheck.core.verdicts import SymcheckError


@click.command(short_help="Draw a figure of the numeric layer to a file.")
@click.argument("name", required=False, shell_complete=figures)
@click.option(
    "--output",
    type=click.Path(dir_okay=False, readable=False, path_type=Path),
    help="A .png, .pdf or .svg file; default NAME.png.",
)
@click.option("--show", is_flag=True, help="Open the file in the viewer of this system.")
def plot(name: str | None, output: Path | None, show: bool) -> None:
    """Draw a figure of the numeric layer to a file. Without NAME: list the figures."""
    from symcheck.numeric import figures as drawn

    if name is None:
        if output or show:
            raise SymcheckError("which figure? `symcheck plot` lists them")
        names = list(drawn.figures())
        for each in names:
            click.echo(f"{each:{max(map(len, names))}}  {drawn.summary(each)}")
        return
    path = output or Path(f"{name}.png")
    with writing(path), needing("plots"):
        try:
            drawn.draw(name, path)
        except ValueError as error:
            raise SymcheckError(str(error)) from error
    click.echo(str(path))
    if show and click.launch(str(path)) != 0:
        raise SymcheckError(f"no viewer opens {path} here; the file is written")
