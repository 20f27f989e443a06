"""A statement is proved only with a point at which all it rests on holds together."""

from __future__ import annotations

import json
import math
from typing import Any

import pytest
from statements import TRUE, over, sub

from symcheck.audit.checked import reason
from symcheck.core.problems import Problem
from symcheck.core.terms import PI, Formula, Term, node
from symcheck.core.verdicts import Verdict
from symcheck.proof import certificate, identity, proof_of
from symcheck.proof.search.witnesses import find_witnesses, implications

EQUAL = (("h", (node("=", "x", "y"),)),)
AND_NOT: tuple[Formula, ...] = (node("=", "x", 1), node("=", "x", 2))
ZERO = sub("x", "y")
VACUOUS = {
    "nothing by nothing": Problem("0/0", node("=", over(sub("x", "y"), sub("y", "x")), 7), (), EQUAL),
    "nothing by nothing, equal to itself": Problem(
        "0/0", node("=", over(1, sub("x", "y")), over(1, sub("x", "y"))), (), EQUAL
    ),
    "a premise that never holds": Problem("never", node("=>", node("<", node("^", "x", 2), 0), node("=", "x", 5))),
    "hypotheses that contradict each other": Problem("both", node("=", "x", 5), (), (("h", AND_NOT),)),
    "one that is not used contradicts": Problem("unused", node("=", "y", "y"), (), (("h", AND_NOT),)),
    "the second of two implications": Problem(
        "second",
        node(
            "and",
            node("=>", node("=", "x", 1), node("=", "x", 1)),
            node("=>", node("and", *AND_NOT), node("=", "y", 3)),
        ),
    ),
    "an implication after another": Problem(
        "chain", node("=>", node("=", "x", 1), node("=>", node("=", "x", 2), node("=", "y", 3)))
    ),
    "a denominator that a definition makes zero": Problem(
        "defined", node("=", over("a", "u"), over("a", "u")), (("u", sub("x", "y")),), EQUAL
    ),
    "the root of a negative number": Problem(
        "root", node(">=", node("sqrt", node("-", "x")), 0), (), (("h", (node(">", "x", 0), node("<=", "x", 0))),)
    ),
}


@pytest.mark.parametrize("problem", VACUOUS.values(), ids=VACUOUS)
def test_what_is_true_for_want_of_a_case_is_not_proved(problem: Problem) -> None:
    outcome = identity.decide(problem)
    assert outcome.verdict is Verdict.UNDECIDED
    assert "no point was found" in outcome.reason
    assert proof_of(problem) is None


def test_a_fraction_is_cancelled_where_it_has_a_value() -> None:
    problem = Problem("cancelled", node("=", over(sub("x", "y"), sub("y", "x")), node("-", 1)))
    (point,) = certificate(problem, identity.decide(problem))["witnesses"]
    assert point["values"]["x"] != point["values"]["y"]


def test_that_something_never_holds_is_proved_without_a_case_where_it_does() -> None:
    problem = Problem("never", node("=>", node("<", node("^", "x", 2), 0), node("=", 0, 1)))
    assert identity.decide(problem).verdict is Verdict.PROVED


def test_that_hypotheses_contradict_each_other_can_be_proved() -> None:
    assert proof_of(Problem("contradiction", node("=", 0, 1), (), (("h", AND_NOT),))) is not None


def test_each_implication_has_a_case_of_its_own() -> None:
    ways = [node("=>", node("=", "x", n), node("=", node("^", "x", 2), n * n)) for n in (1, 2)]
    problem = Problem("two", node("and", *ways))
    found = find_witnesses(problem)
    assert found is not None
    assert [point.values["x"] for point in found] == [1, 2]
    assert implications(node("=>", node("=", "x", 1), ways[0])) == [node("and", node("=", "x", 1), node("=", "x", 1))]


def value(term: Term, at: dict[str, float]) -> float:
    """By floating-point numbers, with no code of the provers; JSON lists are as good as nodes."""
    if isinstance(term, int):
        return term
    if isinstance(term, str):
        return at[term]
    kind, *parts = term
    if kind == "pi":
        return math.pi
    if kind == "^":
        return value(parts[0], at) ** parts[1]
    values = [value(part, at) for part in parts]
    operations: dict[str, Any] = {
        "+": sum, "*": math.prod, "-": lambda v: -v[0], "/": lambda v: v[0] / v[1], "pow": lambda v: v[0] ** v[1],
    }  # fmt: skip
    return float(operations[kind](values) if kind in operations else getattr(math, kind.replace("arc", "a"))(values[0]))


def holds(formula: Formula, at: dict[str, float]) -> bool:
    kind, *parts = formula
    if kind == "and":
        return all(holds(part, at) for part in parts)
    if kind == "or":
        return any(holds(part, at) for part in parts)
    gap = value(parts[0], at) - value(parts[1], at)
    near = abs(gap) < 1e-9
    return {"=": near, "!=": not near, "<": gap < 0, "<=": gap < 0 or near, ">": gap > 0, ">=": gap > 0 or near}[kind]


def coordinates(point: dict[str, Any], definitions: Any) -> dict[str, float]:
    at = {x: value(written, {}) for x, written in point["values"].items()}
    for name, term in definitions:
        if name not in at:
            try:
                at[name] = value(term, at)
            except KeyError:  # of letters about which nothing is said
                continue
    return at


TAN = ("h", (node(">", node("sin", "a"), 0), node("=", node("sin", "a"), node("*", 3, node("cos", "a")))))
GIVEN = [
    Problem("a tangent", node(">", node("cos", "a"), 0), (), (TAN,)),
    Problem(
        "a square", node("=", node("^", "x", 4), over(1, 9)), (), (("h", (node("=", node("^", "x", 2), over(1, 3)),)),)
    ),
    Problem("an interval", node("<", "x", 1), (), (("h", (node("<", "x", over(1, 5)), node(">", "x", over(1, 20)))),)),
    Problem("a root", node(">=", node("sqrt", sub("x", 7)), 0), (), (("h", (node(">=", sub("x", 7), 0),)),)),
]


@pytest.mark.parametrize("problem", [*TRUE, *GIVEN], ids=lambda p: p.id)
def test_at_a_witness_everything_holds(problem: Problem) -> None:
    made = json.loads(json.dumps(certificate(problem, identity.decide(problem))))
    assert reason(made) is None
    premises = implications(problem.claim)
    assert len(made["witnesses"]) in (1, len(premises))
    for n, point in enumerate(made["witnesses"]):
        at = coordinates(point, problem.definitions)
        stated = [f for _, formulas in problem.hypotheses for f in formulas]
        stated += premises if len(made["witnesses"]) == 1 else [premises[n]]
        assert [f for f in stated if not holds(f, at)] == []


def test_angles_that_are_compared_have_witnesses_by_their_digits() -> None:
    acute = ("acute", (node("<", 0, "a"), node("<", "a", over(PI, 2)), node("=", "b", node("arctan", over(5, 8)))))
    (point,) = find_witnesses(Problem("angles", node("=", "a", "a"), (), (acute,))) or ()
    assert point.values["b"] == node("arctan", over(5, 8))
    assert 0 < value(point.values["a"], {}) < math.pi / 2


def test_an_integral_at_a_witness_has_a_proof() -> None:
    whole = ("whole", (node("=", node("integral", "c", "x", 1, 4), 6),))
    problem = Problem("integral", node("=", "c", 2), (), (whole,))
    (point,) = certificate(problem, identity.decide(problem))["witnesses"]
    assert point["values"] == {"c": 2}
    first = point["proof"]
    assert first["rule"] == "have"
    assert first["formula"] == ["=", ["integral", 2, "x", 1, 4], 6]
    assert first["proof"]["rule"] == "theorem"
    assert first["then"]["rule"] == "compute"


def test_the_search_for_a_witness_of_what_cannot_be_gives_none() -> None:
    half: Term = node("sin", over("x", 2))
    assert find_witnesses(Problem("half", node("=", "x", "x"), (), (("h", (node("=", half, 1),)),))) is None
    some = node("exists", ("t",), node("=", "t", "x"))
    assert find_witnesses(Problem("some", node("=", "x", "x"), (), (("h", (some,)),))) is None
