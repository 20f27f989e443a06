"""The command line: a module for each command, `options` and `records` for what they share, `program` for the whole."""

from symcheck.cli.program import cli, main

__all__ = ["cli", "main"]
