"""How a command ends: every error is one line on standard error, with an exit code."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NoReturn

import click

from symcheck.core.interrupts import INTERRUPTED
from symcheck.core.verdicts import SymcheckError

DIFFERS, BAD_INPUT = 1, 2  # as `diff` exits, and as Click does where the usage is wrong
BROKEN_PIPE = 141  # as shells report a process that SIGPIPE ended
MAX_LINES = 30  # differences that are named one by one, about a screen


def say(message: str) -> None:
    """A line on standard error."""
    click.echo(f"symcheck: {message}", err=True)


@contextmanager
def one_line_errors() -> Iterator[None]:
    """Turn what a command raises into a line and an exit code."""
    try:
        yield
    except click.exceptions.NoArgsIsHelpError:
        raise
    except click.UsageError as error:
        where = f"{error.ctx.command_path} --help" if error.ctx else "symcheck --help"
        _leave(f"{error.format_message().rstrip('.')}; see `{where}`", BAD_INPUT)
    except SymcheckError as error:
        _leave(str(error), BAD_INPUT)
    except KeyboardInterrupt as stop:
        _leave(f"interrupted{stop}", INTERRUPTED)
    except BrokenPipeError:
        # What is still buffered must not fail again when the interpreter flushes it at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise click.exceptions.Exit(BROKEN_PIPE) from None


def _leave(message: str, code: int) -> NoReturn:
    say(" ".join(message.split()))
    raise click.exceptions.Exit(code) from None


@contextmanager
def writing(file: Path) -> Iterator[None]:
    """Where a file is written that was asked for; SymcheckError says why it cannot be."""
    try:
        yield
    except OSError as error:
        why = error.strerror or error
        raise SymcheckError(f"{file} cannot be written ({why}); choose another with --output") from error


@contextmanager
def needing(extra: str) -> Iterator[None]:
    """Where a library of an extra is needed; SymcheckError says how to install it."""
    try:
        yield
    except ModuleNotFoundError as error:
        if (error.name or "").partition(".")[0] == "symcheck":
            raise
        raise SymcheckError(f"{error.name} is not installed; run `pip install 'symcheck[{extra}]'`") from error
