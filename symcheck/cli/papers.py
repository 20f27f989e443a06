"""`symcheck papers`: the papers and how much each declares."""

from __future__ import annotations

from collections import Counter

import click


@click.command(short_help="List the papers.")
def papers() -> None:
    """List the papers: key, title, source, number of declarations."""
    from symcheck.audit import decide
    from symcheck.papers import load
    from symcheck.views import terminal

    counts = {key: (paper, Counter(str(o.item.role) for o in decide.expand(paper))) for key, paper in load().items()}
    terminal.papers(terminal.console(), counts)
