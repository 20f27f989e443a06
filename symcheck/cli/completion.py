"""What a shell completes: papers, their relations, kernels, figures, notebooks, and folders of audits.

`eval "$(_SYMCHECK_COMPLETE=bash_source symcheck)"` switches it on in Bash; `zsh_source` and `fish_source` in others.
"""

from __future__ import annotations

import os
from collections.abc import Iterable

import click
from click.shell_completion import BashComplete, CompletionItem, split_arg_string

from symcheck.core.verdicts import SymcheckError


def relations(context: click.Context, parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """Papers and folders, and after a colon the numbers of a paper: as recorded, so that no paper is imported."""
    from symcheck.papers import load

    key, colon, _ = incomplete.partition(":")
    keys = load().built_in
    if not colon:
        return [CompletionItem(incomplete, type="dir"), *_beginning(keys, incomplete)]
    return _beginning(_recorded(key), incomplete) if key in keys else []


def _recorded(key: str) -> Iterable[str]:
    from symcheck.audit import outputs
    from symcheck.ledger import store

    return store.expected(outputs.folder(key), key)


def relations_and_kernels(context: click.Context, parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """The same, and kernels by name."""
    from symcheck.audit import kernels
    from symcheck.papers import load

    named = [] if ":" in incomplete else [name for key in load().built_in for name in kernels.declared(key)]
    return [*relations(context, parameter, incomplete), *_beginning(named, incomplete)]


def figures(context: click.Context, parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """The figures of the numeric layer."""
    from symcheck.numeric import figures

    return _beginning(figures.figures(), incomplete)


def notebooks(context: click.Context, parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """The notebooks of a checkout, if this is one."""
    from symcheck.views.notebook import committed

    try:
        return _beginning(committed.names(), incomplete)
    except SymcheckError:
        return []


def _beginning(names: Iterable[str], with_this: str) -> list[CompletionItem]:
    return [CompletionItem(name) for name in names if name.startswith(with_this)]


class Bash(BashComplete):
    """Bash takes a colon for a word of its own, and completes what stands behind it."""

    def get_completion_args(self) -> tuple[list[str], str]:
        """The words before the one to complete, and this one, put together again."""
        words = split_arg_string(os.environ["COMP_WORDS"])[1 : int(os.environ["COMP_CWORD"]) + 1]
        words += [""] * (int(os.environ["COMP_CWORD"]) - len(words))
        joined = list[str]()
        for n, word in enumerate(words):
            if joined and (word == ":" or words[n - 1] == ":"):
                joined[-1] += word
            else:
                joined.append(word)
        return joined[:-1], joined[-1]

    def get_completions(self, args: list[str], incomplete: str) -> list[CompletionItem]:
        """Of each possible word what stands behind the last colon that is typed."""
        typed = incomplete.rpartition(":")[0]
        found = super().get_completions(args, incomplete)
        return [CompletionItem(each.value.removeprefix(f"{typed}:"), each.type) for each in found] if typed else found
