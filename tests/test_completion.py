"""A shell completes papers, relations, kernels, figures and notebooks."""

from __future__ import annotations

import pytest
from click.shell_completion import ZshComplete

from symcheck.cli import cli
from symcheck.cli.completion import Bash

COMPLETED = {
    "check mirer": "mirer2009",
    "errata mirer2009:2.12": "mirer2009:2.12",
    "check poloskov2004 mirer2009:2.1": "mirer2009:2.1a",
    "show axial": "axial_moments",
    "show mirer2009:2.17": "mirer2009:2.17",
    "plot liquid-f": "liquid-frequencies",
    "notebooks --only 6": "6_errata",
}


@pytest.mark.parametrize("typed", COMPLETED)
def test_the_names_that_begin_so_are_offered(typed: str) -> None:
    *before, incomplete = typed.split()
    found = ZshComplete(cli, {}, "symcheck", "_SYMCHECK_COMPLETE").get_completions(before, incomplete)
    names = [each.value for each in found if each.type == "plain"]
    assert COMPLETED[typed] in names
    assert all(name.startswith(incomplete) for name in names)


@pytest.mark.parametrize("typed", COMPLETED)
def test_bash_which_parts_words_at_colons_gets_the_rest(typed: str, monkeypatch: pytest.MonkeyPatch) -> None:
    words = ["symcheck", *typed.replace(":", " : ").split()]
    monkeypatch.setenv("COMP_WORDS", " ".join(words))
    monkeypatch.setenv("COMP_CWORD", str(len(words) - 1))
    assert f"plain,{COMPLETED[typed].rpartition(':')[2]}" in completed_in_bash()


def test_bash_gets_all_numbers_behind_a_colon(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COMP_WORDS", "symcheck check mirer2009 :")
    monkeypatch.setenv("COMP_CWORD", "3")
    assert {"plain,2.12", "plain,2.1a"} <= {*completed_in_bash()}


def test_a_paper_that_is_none_completes_nothing() -> None:
    found = ZshComplete(cli, {}, "symcheck", "_SYMCHECK_COMPLETE").get_completions(["check"], "nobody1999:2")
    assert found == []


def completed_in_bash() -> list[str]:
    return Bash(cli, {}, "symcheck", "_SYMCHECK_COMPLETE").complete().splitlines()
