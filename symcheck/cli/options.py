"""Arguments and options that several commands share."""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from dataclasses import dataclass
from functools import wraps
from pathlib import Path
from typing import Any

import click

from symcheck.cli.completion import relations


def keyed(
    context: click.Context, parameter: click.Parameter, selection: str | tuple[str, ...]
) -> str | tuple[str, ...]:
    """What is selected, with the key of a paper in the place of its folder: "audit/" or "audit/:2.1"."""
    return _keyed(selection) if isinstance(selection, str) else tuple(map(_keyed, selection))


def _keyed(text: str) -> str:
    from symcheck.papers import FILES, add, load

    path, colon, place = (text, "", "") if _exists(text) else text.rpartition(":")
    if not path or not _exists(path) or (os.sep not in path and path in load()):
        return text
    folder = Path(path)
    return add(folder.parent if folder.name in FILES else folder) + colon + place


def _exists(path: str) -> bool:
    try:
        return Path(path).exists()
    except (OSError, ValueError):  # too long, or with a null character
        return False


class _Positive(click.FloatRange):
    """A finite number above 0; a range lets NaN through, which compares with nothing."""

    def __init__(self) -> None:
        super().__init__(0, min_open=True)

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        number = float(super().convert(value, param, ctx))
        if not math.isfinite(number):
            self.fail(f"{number} is not a finite number.", param, ctx)
        return number


POSITIVE = _Positive()
SELECTION = click.argument(
    "selection", nargs=-1, metavar="[PAPER[:NUMBER]]...", callback=keyed, shell_complete=relations
)
AGAINST = click.option(
    "--against",
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="LEDGER",
    help="Tell what changed since an older ledger, as `check --json` writes it, or generated/expected/PAPER.json.",
)


@dataclass(frozen=True)
class AuditOptions:
    """How a command that needs verdicts gets them."""

    jobs: int
    timeout: float
    cache: bool


def cores() -> int:
    """The processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def audit_options(command: Callable[..., None]) -> Callable[..., None]:
    """Add the options of `AuditOptions` to a command, which receives them as its parameter `options`."""

    @click.option(
        "--jobs",
        type=click.IntRange(0),
        default=cores,
        show_default="cores",
        help="Worker processes; 0 decides in this process, without a time limit.",
    )
    @click.option(
        "--timeout",
        type=POSITIVE,
        default=60.0,
        show_default=True,
        help="Seconds that one declaration may take.",
    )
    @click.option("--no-cache", is_flag=True, help="Decide everything anew and keep nothing.")
    @wraps(command)
    def with_options(*args: object, jobs: int, timeout: float, no_cache: bool, **kwargs: object) -> None:
        command(*args, options=AuditOptions(jobs, timeout, not no_cache), **kwargs)

    return with_options
