"""How a command ends: every error is one line on standard error, with an exit code."""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import NoReturn

import click

from symcheck.core.extras import installing
from symcheck.core.interrupts import INTERRUPTED
from symcheck.core.verdicts import SymcheckError

DIFFERS, BAD_INPUT = 1, 2  # as `diff` exits, and as Click does where the usage is wrong
BROKEN_PIPE = 141  # as shells report a process that SIGPIPE ended
NO_ROOM = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO)  # of a stream that is open, and takes no more
MAX_LINES = 30  # differences that are named one by one, about a screen


def say(message: str) -> None:
    """A line on standard error, if that takes it."""
    with suppress(OSError):
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
        _drop_output()
        raise click.exceptions.Exit(BROKEN_PIPE) from None


def output_fails(error: OSError) -> int:
    """The exit code where the standard output takes no more, which is said; any other error is raised again."""
    if error.filename or error.errno not in NO_ROOM:
        raise error
    say(f"the standard output cannot be written ({error.strerror}); what was printed is not whole")
    _drop_output()
    return BAD_INPUT


def _drop_output() -> None:
    """What is still buffered must not fail again when the interpreter flushes it at exit."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _leave(message: str, code: int) -> NoReturn:
    say(" ".join(message.split()))
    raise click.exceptions.Exit(code) from None


@contextmanager
def writing(file: Path, instead: str = "choose another with --output") -> Iterator[None]:
    """Where a file is written that was asked for; SymcheckError says why it cannot be, and what to do instead."""
    try:
        yield
    except OSError as error:
        why = error.strerror or error
        raise SymcheckError(f"{file} cannot be written ({why}); {instead}") from error


@contextmanager
def needing(extra: str) -> Iterator[None]:
    """Where a library of an extra is needed; SymcheckError says how to install it."""
    try:
        yield
    except ModuleNotFoundError as error:
        if (error.name or "").partition(".")[0] == "symcheck":
            raise
        raise SymcheckError(f"{error.name} is not installed; run `{installing(extra)}`") from error
