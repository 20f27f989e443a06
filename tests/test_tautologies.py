"""No claim of any paper says of something that it is itself."""

from __future__ import annotations

import pytest

from symcheck import papers
from symcheck.audit import Context, units
from symcheck.core.claims import Assertion, Paper
from symcheck.core.formulas import conjuncts
from symcheck.core.terms import Formula, node

PAPERS = papers.load()
REFLEXIVE = {"=", "<=", ">=", "<=>", "=>"}


def says_nothing(formula: Formula) -> bool:
    """Whether both sides of it, or of all it is put together from, are the same tree."""
    return all(part[0] in REFLEXIVE and part[1] == part[2] for part in conjuncts(formula))


def tautologies(paper: Paper) -> set[str]:
    """The relations that say nothing in all their instances; one component of two equal vectors may."""
    return {
        context.id + unit.letter
        for _, _, item in paper.items()
        if isinstance(item, Assertion)
        for context in [Context(paper, item)]
        for unit in units(context)
        if all(map(says_nothing, unit.formulas)) and not item.statement.imposes(unit.letter)
    }


@pytest.mark.parametrize("key", PAPERS)
def test_no_relation_has_the_same_tree_on_both_sides(key: str) -> None:
    assert tautologies(PAPERS[key]) == set()


@pytest.mark.parametrize(
    ("formula", "empty"),
    [
        (node("=", "a", "a"), True),
        (node("and", node("=", "a", "a"), node("<=", "b", "b")), True),
        (node("and", node("=", "a", "a"), node("=", "a", "b")), False),
        (node("<=>", node("=", "a", "b"), node("=", "a", "b")), True),
        (node("<", "a", "a"), False),
        (node("=", "a", node("+", "a", 0)), False),
    ],
)
def test_empty_statements_are_recognised(formula: Formula, empty: bool) -> None:
    assert says_nothing(formula) is empty
