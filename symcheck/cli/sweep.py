"""`symcheck sweep`: evaluates a function on the outer product of its parameters."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click

from symcheck.cli.options import POSITIVE, cores
from symcheck.cli.records import progress
from symcheck.core.verdicts import SymcheckError


def _chunks(context: click.Context, option: click.Parameter, given: Sequence[str]) -> dict[str, int]:
    pairs = [text.rpartition("=") for text in given]
    wrong = [
        text
        for text, (axis, _, points) in zip(given, pairs, strict=True)
        if not axis or not points.isdecimal() or points == "0"
    ]
    if wrong:
        raise click.BadParameter(f"{wrong[0]!r} must be AXIS=POINTS, as a=100")
    return {axis: int(points) for axis, _, points in pairs}


def _address(context: click.Context, option: click.Parameter, given: str | None) -> str | None:
    if given is not None and not given.strip():
        raise click.BadParameter("it is empty; give tcp://HOST:8786, or leave --scheduler out to compute here")
    return given


@click.command(short_help="Evaluate a function on the outer product of its parameters.")
@click.argument("spec", type=click.Path(path_type=Path))
@click.option(
    "--out", required=True, type=click.Path(path_type=Path), help="FILE.zarr or FILE.nc, written when all is done."
)
@click.option(
    "--scheduler",
    metavar="ADDRESS",
    callback=_address,
    help="A dask.distributed scheduler, as tcp://HOST:8786; default threads.",
)
@click.option("--threads", type=click.IntRange(1), default=cores, show_default="cores", help="Threads of this process.")
@click.option("--chunk", "chunks", multiple=True, metavar="AXIS=POINTS", callback=_chunks, help="Length of a chunk.")
@click.option(
    "--chunk-memory",
    type=POSITIVE,
    default=32.0,
    show_default=True,
    help="Megabytes of results in a chunk, along the axes whose length is not given.",
)
@click.option(
    "--wait", type=POSITIVE, default=10.0, show_default=True, help="Seconds to wait for the scheduler and for workers."
)
def sweep(
    spec: Path,
    out: Path,
    scheduler: str | None,
    threads: int,
    chunks: dict[str, int],
    chunk_memory: float,
    wait: float,
) -> None:
    """Evaluate a function on the outer product of its parameters, as the TOML file SPEC says, and keep the result.

    What was stopped goes on with the same command. Described in `symcheck.numeric.sweep`.
    """
    from symcheck.numeric.sweep import SweepError
    from symcheck.numeric.sweep import sweep as run

    try:
        with progress("sweeping") as move:
            said = run(
                spec,
                out,
                scheduler=scheduler,
                threads=threads,
                chunks=chunks,
                memory=1e6 * chunk_memory,
                patience=wait,
                progress=move,
            )
    except SweepError as error:
        raise SymcheckError(str(error)) from error
    click.echo(said)
