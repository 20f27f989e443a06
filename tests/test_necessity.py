"""A hypothesis is needed if without it the relation fails, a term has no value, or nothing of the kind exists."""

from __future__ import annotations

import pytest
from stand_in import hypothesis

from symcheck.audit.checked import reason
from symcheck.core.problems import Problem
from symcheck.core.terms import Formula, node
from symcheck.core.verdicts import Loss
from symcheck.ledger import Need
from symcheck.proof import fails_without, refute
from symcheck.views.model import condition

E = node("sin", "a")
SHORTER = (("e", E),)
EXISTS: Formula = node("exists", ("c",), node("and", node(">", node("*", "c", "e"), 0), node(">", "c", 0)))
B_POSITIVE = (("b positive", (node(">", node("sin", "b"), 0),)),)

NEEDED = {
    "a square of a negative number": (Problem("x", node(">", "x", 0)), Loss.TRUTH, "x = "),
    "a denominator": (Problem("x", node("=", node("/", "x", "x"), 1)), Loss.VALUE, "x = 0: x ≠ 0 is wrong"),
    "a denominator in a definition": (
        Problem("x", node("=", node("+", "y", 1), node("+", 1, "y")), (("y", node("/", 1, "x")),)),
        Loss.VALUE,
        "x = 0: x ≠ 0 is wrong",
    ),
    "a root": (Problem("x", node("=", node("^", node("sqrt", "x"), 2), "x")), Loss.VALUE, "x = -1: x ≥ 0 is wrong"),
    "a direction at a right angle": (Problem("x", EXISTS, SHORTER), Loss.EXISTENCE, "sine_of_a = 0"),
    "a direction while another angle stays": (
        Problem("x", EXISTS, SHORTER, B_POSITIVE),
        Loss.EXISTENCE,
        "sine_of_a = 0",
    ),
}
D: Formula = node(
    ">",
    node(
        "+",
        node("^", "d", 2),
        node("*", 2, "d", node("+", node("*", "a", "b"), "e", node("*", -2, "e", "b"))),
        node("^", node("+", node("*", "a", "b"), node("-", "e")), 2),
    ),
    0,
)
BY_CHANCE = Problem("x", D, (), (("e positive", (node(">", "e", 0),)), ("b negative", (node("<", "b", 0),))))


def test_a_point_that_no_search_finds_may_be_drawn() -> None:
    assert refute(BY_CHANCE) is None
    found = fails_without(BY_CHANCE)
    assert found is not None
    assert found.loss is Loss.TRUTH
    assert reason(found.certificate) is None


NOT_KNOWN = {
    "an identity": Problem("x", node("=", node("+", "x", "x"), node("*", 2, "x"))),
    "something that exists everywhere": Problem(
        "x", node("exists", ("c",), node("and", node(">", "c", E), node(">", "c", 0)))
    ),
    "something whose hypotheses exclude the right angle": Problem(
        "x", EXISTS, SHORTER, (("a positive", (node(">", E, 0),)),)
    ),
}


@pytest.mark.parametrize("name", NEEDED)
def test_what_is_lost_has_a_certificate_and_is_told(name: str) -> None:
    problem, loss, told = NEEDED[name]
    found = fails_without(problem)
    assert found is not None
    assert found.loss is loss
    assert reason(found.certificate) is None
    need = Need(needed=True, lost=found.loss, counterexample=found.certificate)
    assert told in condition(hypothesis("x", "", "printed", need)).without


@pytest.mark.parametrize("name", NOT_KNOWN)
def test_nothing_is_said_to_be_lost_where_nothing_is(name: str) -> None:
    assert fails_without(NOT_KNOWN[name]) is None
