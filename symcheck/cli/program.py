"""The program `symcheck`: the group of all commands, and the entry point."""

from __future__ import annotations

import io
import sys

import click
from click.shell_completion import add_completion_class

from symcheck import __version__
from symcheck.cli.check import check
from symcheck.cli.completion import Bash
from symcheck.cli.decide import decide
from symcheck.cli.errata import errata
from symcheck.cli.errors import one_line_errors, output_fails
from symcheck.cli.export import export
from symcheck.cli.generate import generate
from symcheck.cli.lint import lint
from symcheck.cli.look import look
from symcheck.cli.new import new
from symcheck.cli.notebooks import notebooks
from symcheck.cli.papers import papers
from symcheck.cli.plot import plot
from symcheck.cli.report import report
from symcheck.cli.selftest import selftest
from symcheck.cli.show import show
from symcheck.cli.sweep import sweep
from symcheck.cli.units import units
from symcheck.core.interrupts import INTERRUPTED, leave, raise_from_now_on


class Commands(click.Group):
    """A group whose every error is one line on standard error."""

    def make_context(
        self,
        info_name: str | None,
        args: list[str],
        parent: click.Context | None = None,
        **extra: object,
    ) -> click.Context:
        with one_line_errors():
            raise_from_now_on()
            return super().make_context(info_name, args, parent, **extra)

    def invoke(self, ctx: click.Context) -> object:
        with one_line_errors():
            return super().invoke(ctx)


@click.group(cls=Commands, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="symcheck")
def cli() -> None:
    """Audit the printed equations of mechanics papers: proved, refuted or undecided.

    Exit codes: 0 the verdicts are those recorded, 1 they differ, 2 bad input, 130 interrupted.
    """


for command in (
    check,
    decide,
    look,
    new,
    lint,
    show,
    errata,
    papers,
    units,
    generate,
    plot,
    sweep,
    notebooks,
    selftest,
    report,
    export,
):
    cli.add_command(command)
add_completion_class(Bash)


def main() -> None:
    """The entry point `symcheck`."""
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:  # closed by whoever started this
            setattr(sys, name, io.StringIO())
        elif hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")
    try:
        try:
            cli(prog_name="symcheck")
        finally:
            sys.stdout.flush()
    except SystemExit as stop:
        if stop.code == INTERRUPTED:
            leave()
        raise
    except OSError as error:
        sys.exit(output_fails(error))
