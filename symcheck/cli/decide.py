"""`symcheck decide`: one formula, or a file of formulas, without a paper."""

from __future__ import annotations

import json
import os
import sys
from contextlib import nullcontext
from pathlib import Path

import click

from symcheck.cli.errors import BAD_INPUT, say, writing
from symcheck.cli.options import POSITIVE, cores
from symcheck.core.counts import number_of
from symcheck.core.verdicts import SymcheckError

EXIT = {"proved": 0, "refuted": 1, "unreadable": BAD_INPUT}
UNDECIDED = 3  # 0 to 2 mean proved, refuted, and unreadable or wrong input


@click.command(short_help="Decide one formula in LaTeX, without a paper.")
@click.argument("relation", required=False)
@click.option(
    "--where", multiple=True, metavar="LATEX", help="A definition or an earlier equation; any number of them."
)
@click.option(
    "--given", multiple=True, metavar="LATEX", help="A condition, or several with commas; any number of them."
)
@click.option(
    "--letter",
    "said",
    multiple=True,
    metavar="LETTER=WHAT",
    help=r"What a letter is: 'f=function of x', '\omega=vector'.",
)
@click.option(
    "--unit",
    "units",
    multiple=True,
    metavar="'LETTER: UNIT'",
    help="What a letter measures: 'F: N'; 'c: m/s = 1' if it is not printed because it is 1.",
)
@click.option(
    "--batch",
    type=click.Path(path_type=Path, allow_dash=True),
    help="A file of records, one JSON object a line; - for standard input.",
)
@click.option("--json", "as_json", is_flag=True, help="Print JSON: one object, or one a line for a batch.")
@click.option(
    "--output", type=click.Path(dir_okay=False, path_type=Path), help="Write the answers of a batch to a file."
)
@click.option("--resume", is_flag=True, help="Go on where the file of --output ends.")
@click.option(
    "--jobs", type=click.IntRange(1), default=cores, show_default="cores", help="Worker processes of a batch."
)
@click.option(
    "--timeout",
    type=POSITIVE,
    default=20.0,
    show_default=True,
    help="Seconds of processor time for each formula.",
)
def decide(
    relation: str | None,
    where: tuple[str, ...],
    given: tuple[str, ...],
    said: tuple[str, ...],
    units: tuple[str, ...],
    batch: Path | None,
    as_json: bool,
    output: Path | None,
    resume: bool,
    jobs: int,
    timeout: float,
) -> None:
    r"""Decide one formula, in LaTeX, without a paper and without declarations.

    What the letters are is inferred from what is done with them, and shown. Exit codes: 0 proved, 1 refuted, 3 neither,
    2 bad input. A record of a batch is {"id": ..., "relation": LaTeX, "where": [...], "given": [...],
    "letters": {...}, "units": {...}}; its answer has the same id.
    """
    if (relation is None) == (batch is None):
        raise click.UsageError("give one relation, or --batch with a file")
    if batch is not None:
        if where or given or said or units:
            raise click.UsageError("--where, --given, --letter and --unit stand in the records of a batch")
        _batch(batch, as_json, output, resume, jobs, timeout)
        return
    assert relation is not None
    from symcheck.question.ask import decide as decided
    from symcheck.question.measured import unit
    from symcheck.views.answer import text

    answer = decided(relation, where, given, dict(map(_meaning, said)), dict(map(unit, units)))
    click.echo(json.dumps(answer.as_json()) if as_json else text(answer, measured=bool(units)))
    raise click.exceptions.Exit(EXIT.get(answer.verdict, UNDECIDED))


def _meaning(text: str) -> tuple[str, str]:
    letter, sign, what = text.rpartition("=")
    if not sign or not letter:
        raise click.UsageError(f"--letter {text!r} is not of the form LETTER=WHAT")
    return letter.strip(), what.strip()


def _batch(file: Path, as_json: bool, output: Path | None, resume: bool, jobs: int, timeout: float) -> None:
    """Answers in order, on standard output or in a file; what is wrong with records is said at the end."""
    from symcheck.audit.library import executor
    from symcheck.question.batch import answers, asked, resumed
    from symcheck.views.answer import line

    try:
        with click.open_file(str(file), encoding="utf-8", errors="strict") as stream:
            records = [*asked(stream)]
    except (OSError, UnicodeDecodeError) as error:
        why = getattr(error, "strerror", None) or "it is not UTF-8"
        raise SymcheckError(f"{file} cannot be read ({why}); give a file of JSON objects, one a line") from error
    done = 0
    if resume and output is None:
        raise click.UsageError("--resume goes on with the file of --output")
    if resume and output is not None and output.is_file():
        with output.open(encoding="utf-8") as written:
            done = resumed(records, written)
        _cut(output, done)
    todo, verdicts = records[done:], dict[str, int]()
    tty = sys.stderr.isatty()

    def progress(count: int) -> None:
        if tty:
            click.echo(f"\r{done + count} of {len(records)}", err=True, nl=False)

    with writing(output) if output else nullcontext():
        stream = output.open("a" if done else "w", encoding="utf-8") if output else sys.stdout
        try:
            for record, answer in zip(todo, answers(todo, executor(jobs, ()), timeout, progress), strict=True):
                verdicts[str(answer["verdict"])] = verdicts.get(str(answer["verdict"]), 0) + 1
                stream.write(json.dumps(answer) + "\n" if as_json or output else line(answer) + "\n")
                stream.flush()
                if record.fault:
                    say(record.fault)
        finally:
            if output:
                stream.close()
    if tty:
        click.echo(err=True)
    faults = sum(bool(record.fault) for record in todo)
    counts = ", ".join(f"{count} {verdict}" for verdict, count in sorted(verdicts.items()))
    say(
        f"{number_of(len(todo), 'record')}: {counts or 'nothing to do'}"
        + (f"; {faults} could not be read as records" if faults else "")
    )
    raise click.exceptions.Exit(BAD_INPUT if faults else 0)


def _cut(file: Path, lines: int) -> None:
    """Leave so many lines of a file, and no half one behind them."""
    with file.open("rb+") as stream:
        for _ in range(lines):
            stream.readline()
        stream.truncate(stream.tell())
        os.fsync(stream.fileno())
