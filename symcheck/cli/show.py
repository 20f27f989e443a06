"""`symcheck show`: one relation, or one kernel, in full."""

from __future__ import annotations

import click

from symcheck.cli.completion import relations_and_kernels
from symcheck.cli.options import AuditOptions, audit_options, keyed
from symcheck.cli.records import audited


@click.command(short_help="Show one relation or one kernel in full.")
@click.argument("name", metavar="PAPER:NUMBER|KERNEL", callback=keyed, shell_complete=relations_and_kernels)
@click.option("--certificate", is_flag=True, help="Print the whole certificate.")
@audit_options
def show(name: str, certificate: bool, options: AuditOptions) -> None:
    """Show one relation: as printed, as read, hypotheses, steps of the proof, certificate, counterexample, erratum.

    Or one kernel: what it computes, how accurately, and the relations on which it rests.
    """
    from symcheck.views.show import show

    show(name, certificate, lambda selection: audited(selection, options))
