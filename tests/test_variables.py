"""What a variable of a polynomial stands for: equal terms have one, different terms never, and no letter is one."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest

from symcheck.audit.checked import reason
from symcheck.core.problems import Problem
from symcheck.core.terms import INFINITY, Formula, Term, node
from symcheck.core.verdicts import Verdict
from symcheck.proof import certificate, equivalent, identity
from symcheck.proof.algebra.polynomial import Ring, Unsupported, alone, letters_of, variables
from symcheck.proof.algebra.variables import Table, atoms, one_problem

SHIFTED = [node("sqrt", node("+", "x", number)) for number in (378610, 2312624)]


def verdict(claim: Formula, *hypotheses: Formula) -> Verdict:
    problem = Problem("variables", claim, (), (("h", hypotheses),) if hypotheses else ())
    outcome = identity.decide(problem)
    if outcome.verdict is Verdict.PROVED:
        assert reason(json.loads(json.dumps(certificate(problem, outcome)))) is None
    return outcome.verdict


def test_roots_with_digests_of_one_beginning_are_distinguished() -> None:
    assert verdict(node("=", *SHIFTED)) is Verdict.REFUTED


def test_many_roots_have_as_many_variables() -> None:
    with one_problem("x"):
        roots: list[Term] = [node("sqrt", node("+", "x", number)) for number in range(2000)]
        assert len({name for root in roots for name in variables(root)}) == len(roots)


EQUAL: list[tuple[Term, Term]] = [
    (node("sqrt", node("+", "x", "y")), node("sqrt", node("+", "y", "x"))),
    (node("exp", node("/", node("*", 2, "x"), 2)), node("exp", "x")),
    (
        node("log", node("+", node("^", node("sin", "a"), 2), node("^", node("cos", "a"), 2), "x")),
        node("log", node("+", 1, "x")),
    ),
    (node("integral", node("exp", "t"), "t", 0, "x"), node("integral", node("exp", "s"), "s", 0, "x")),
    (node("call", "f", (0,), node("+", "x", 1)), node("call", "f", (0,), node("+", 1, "x"))),
    (node("mean", node("mean", "x", "x"), "y"), node("mean", node("mean", "z", "z"), "x")),
]
DIFFERENT: list[tuple[Term, Term]] = [
    (node("exp", "x"), node("log", "x")),
    (node("call", "f", (0,), "x"), node("call", "f", (1,), "x")),
    (node("call", "f", (0,), "x"), node("call", "g", (0,), "x")),
    (node("integral", node("*", "t", "bound_0"), "t", 0, 1), node("integral", node("*", "t", "t"), "t", 0, 1)),
    (
        node("integral", node("exp", node("*", "t", "x")), "t", 0, 1),
        node("integral", node("exp", node("*", "t", "t")), "t", 0, 1),
    ),
    (
        node("integral", node("mean", node("*", "s", "t"), "s"), "t", 0, 1),
        node("integral", node("mean", node("*", "s", "s"), "s"), "t", 0, 1),
    ),
]


@pytest.mark.parametrize(("one", "other"), EQUAL)
def test_equal_functions_have_one_variable(one: Term, other: Term) -> None:
    with alone(Problem("both", node("=", one, other))):
        assert variables(one) == variables(other)


@pytest.mark.parametrize(("one", "other"), DIFFERENT)
def test_different_functions_have_different_variables(one: Term, other: Term) -> None:
    with alone(Problem("both", node("=", one, other))):
        assert not variables(one) & variables(other)
    assert verdict(node("=", one, other)) is not Verdict.PROVED


NAMED_LIKE_VALUES: list[tuple[Formula, tuple[Formula, ...]]] = [
    (node("=", node("^", "sqrt_2", 2), 2), ()),
    (node("=", node("+", node("^", "sin_x", 2), node("^", "cos_x", 2)), 1), ()),
    (node("=", "sin_x", node("sin", "x")), ()),
    (node("=", node("cos", "x"), "cos_x"), (node("=", node("sin", "x"), "sin_x"),)),
    (node("=", "Sqrt_1", node("sqrt", "x")), (node(">", "x", 0),)),
    (node("=", "Call_1", node("call", "f", (0,), "x")), ()),
    (node("=", node("call", "x", (0,), "x"), "x"), ()),
]


@pytest.mark.parametrize(("claim", "given"), NAMED_LIKE_VALUES)
def test_a_letter_is_not_confused_with_a_value_of_its_name(claim: Formula, given: tuple[Formula, ...]) -> None:
    assert verdict(claim, *given) is not Verdict.PROVED


def test_values_are_proved_beside_letters_of_their_names() -> None:
    assert verdict(node("=", node("^", node("sqrt", 2), 2), 2), node(">", "sqrt_2", 0)) is Verdict.PROVED
    circle: Term = node("+", node("^", node("sin", "x"), 2), node("^", node("cos", "x"), 2))
    assert verdict(node("=", circle, 1), node(">", "sqrt_2", "Sqrt_1")) is Verdict.PROVED
    with one_problem(("sin_x", "Sqrt_1", "sqrt_2")) as table:
        assert table.circle("sin", "x") == "sin_x_2"
        assert table.root(2) == "sqrt_2_2"
        assert variables(node("sqrt", "y")) == {"Sqrt_1_2"}
        assert table.term("Sqrt_1_2") == node("sqrt", "y")
        assert not table.stands("Sqrt_1")


def test_a_letter_met_too_late_is_refused() -> None:
    table = Table()
    table.root(2)
    with pytest.raises(Unsupported, match="sqrt_2"):
        table.letter("sqrt_2")


def test_the_turn_of_a_witness_is_no_letter_of_the_statement() -> None:
    double: Term = node("+", node("^", node("cos", "a"), 2), node("-", node("^", node("sin", "a"), 2)))
    wave: Term = node("+", node("*", "p", double), node("*", "turn", node("sin", "a"), node("cos", "a")))
    somewhere = node("exists", ("a",), node("=", wave, 0))
    assert verdict(somewhere) is Verdict.PROVED
    assert verdict(node("exists", ("a",), node("=", "a", node("+", "turn", 1)))) is not Verdict.REFUTED


def test_every_name_of_a_problem_is_known_to_be_taken() -> None:
    term = node("integral", node("call", "f", (0,), node("diff", "u", "v", 1, "v")), "t", 0, INFINITY)
    problem = Problem(
        "names", node("exists", ("w",), node("=", term, "x")), (("d", "e"),), (("h", (node("=", "y", 1),)),)
    )
    assert letters_of(problem) >= set("fuvtwxdey")


def test_a_table_is_used_by_one_problem_only() -> None:
    with one_problem("x"):
        outer = Ring(variables(node("sqrt", "x")))
        with one_problem("y"):
            assert variables(node("sqrt", "y")) == {"Sqrt_1"}
        assert atoms()["Sqrt_1"] == node("sqrt", "x")
        assert str(outer.ratio(node("sqrt", "x")).num) == "Sqrt_1"
    first, other = node("=", node("sqrt", "x"), 2), node("=", node("sqrt", "y"), 2)
    assert not equivalent(first, other, Problem("equivalent", first))


SCRIPT = """
import json
from test_functions import TRUE
from symcheck.proof import certificate, identity
from symcheck.core.problems import Problem
for name in ("the square of a sum of roots", "a root of sine and cosine", "a density without flux"):
    problem = Problem(name, TRUE[name][0], (), TRUE[name][1])
    print(json.dumps(certificate(problem, identity.decide(problem))))
"""


def test_certificates_do_not_depend_on_the_seed_of_hashes() -> None:
    run = [
        subprocess.run(
            [sys.executable, "-c", SCRIPT],
            env={"PYTHONHASHSEED": seed, "PYTHONPATH": "tests:."},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "2")
    ]
    assert run[0] == run[1] != ""


def call(name: str, *arguments: Term, orders: tuple[int, ...] = ()) -> Term:
    return node("call", name, orders or (0,) * len(arguments), *arguments)


SQUARE: Term = node("^", "x", 2)
FIELD = call("f", "x", "y")


def rate(term: Term, x: str) -> Term:
    return node("diff", term, x, 1, x)


BY_FIRST, BY_SECOND = (call("f", "x", node("*", 3, "x"), orders=orders) for orders in ((1, 0), (0, 1)))
UNKNOWN_FUNCTIONS: dict[str, tuple[Formula, Verdict]] = {
    "equal arguments": (node("=", call("f", node("+", "x", 1)), call("f", node("+", 1, "x"))), Verdict.PROVED),
    "other arguments": (node("=", call("f", "x"), call("f", "y")), Verdict.REFUTED),
    "arguments said to be equal": (
        node("=>", node("=", "x", "y"), node("=", call("f", "x"), call("f", "y"))),
        Verdict.PROVED,
    ),
    "arguments exchanged": (node("=", call("f", "x", "y"), call("f", "y", "x")), Verdict.REFUTED),
    "a function of itself": (node("=", call("f", call("f", "x")), call("f", "x")), Verdict.REFUTED),
    "the chain rule": (
        node("=", rate(call("f", SQUARE, "y"), "x"), node("*", 2, "x", call("f", SQUARE, "y", orders=(1, 0)))),
        Verdict.PROVED,
    ),
    "the chain rule for both arguments": (
        node("=", rate(call("f", "x", node("*", 3, "x")), "x"), node("+", BY_FIRST, node("*", 3, BY_SECOND))),
        Verdict.PROVED,
    ),
    "the derivative by another argument": (
        node("=", rate(call("f", "x", "y"), "x"), call("f", "x", "y", orders=(0, 1))),
        Verdict.REFUTED,
    ),
    "a derivative that is not zero": (node("=", rate(call("f", "x"), "x"), 0), Verdict.REFUTED),
    "a derivative by what it does not depend on": (node("=", rate(call("f", "y"), "x"), 0), Verdict.PROVED),
    "mixed derivatives": (
        node("=", rate(rate(FIELD, "x"), "y"), rate(rate(FIELD, "y"), "x")),
        Verdict.PROVED,
    ),
    "the root of what is said to be positive": (
        node("=>", node(">", call("f", "x"), 0), node("=", node("^", node("sqrt", call("f", "x")), 2), call("f", "x"))),
        Verdict.PROVED,
    ),
}  # fmt: skip


@pytest.mark.parametrize(("claim", "expected"), UNKNOWN_FUNCTIONS.values(), ids=UNKNOWN_FUNCTIONS)
def test_an_unknown_function_depends_on_its_arguments_alone(claim: Formula, expected: Verdict) -> None:
    problem = Problem("function", claim)
    outcome = identity.decide(problem)
    assert outcome.verdict is expected, outcome.reason
    assert reason(json.loads(json.dumps(certificate(problem, outcome)))) is None


def test_an_unknown_function_has_one_value_at_a_point() -> None:
    point = identity.decide(Problem("even", node("=", call("f", "x"), call("f", node("-", "x"))))).point
    assert point is not None
    (first, second) = point.calls
    assert first[0] != second[0]
    for claim in (
        node("!=", call("f", "x"), call("f", "y")),
        node("<", call("f", node("^", "x", 2)), call("f", node("^", "y", 2))),
    ):
        problem = Problem(
            "one value", claim, (), (("h", (node("=", node("^", "x", 2), node("^", "y", 2)), node("!=", "x", 0))),)
        )
        outcome = identity.decide(problem)
        assert outcome.point is not None
        seen: dict[str, str] = {}
        assert all(seen.setdefault(str(known), str(value)) == str(value) for known, value in outcome.point.calls)
        assert reason(json.loads(json.dumps(certificate(problem, outcome)))) is None


def test_a_point_at_which_an_unknown_function_has_two_values_is_rejected() -> None:
    problem = Problem("even", node("=", call("f", "x"), call("f", node("-", "x"))))
    made = json.loads(json.dumps(certificate(problem, identity.decide(problem))))
    assert reason(made) is None
    made["point"]["calls"][1][0] = made["point"]["calls"][0][0]
    assert "two values" in str(reason(made))
