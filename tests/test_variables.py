"""What a variable of a polynomial stands for: equal terms have one, different terms never, and no letter is one."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest

from symcheck.evidence.checked import reason
from symcheck.proof import certificate, equivalent, identity
from symcheck.proof.polynomial import Ring, Unsupported, alone, letters_of, variables
from symcheck.proof.variables import Table, atoms, one_problem
from symcheck.statement import Formula, Problem, Term, Verdict

SHIFTED = [("sqrt", ("+", "x", number)) for number in (378610, 2312624)]


def verdict(claim: Formula, *hypotheses: Formula) -> Verdict:
    problem = Problem("variables", claim, (), (("h", hypotheses),) if hypotheses else ())
    outcome = identity.decide(problem)
    if outcome.verdict is Verdict.PROVED:
        assert reason(json.loads(json.dumps(certificate(problem, outcome)))) is None
    return outcome.verdict


def test_roots_whose_digests_began_alike_are_told_apart() -> None:
    assert verdict(("=", *SHIFTED)) is Verdict.REFUTED


def test_many_roots_have_as_many_variables() -> None:
    with one_problem("x"):
        roots: list[Term] = [("sqrt", ("+", "x", number)) for number in range(2000)]
        assert len({name for root in roots for name in variables(root)}) == len(roots)


EQUAL: list[tuple[Term, Term]] = [
    (("sqrt", ("+", "x", "y")), ("sqrt", ("+", "y", "x"))),
    (("exp", ("/", ("*", 2, "x"), 2)), ("exp", "x")),
    (("log", ("+", ("^", ("sin", "a"), 2), ("^", ("cos", "a"), 2), "x")), ("log", ("+", 1, "x"))),
    (("integral", ("exp", "t"), "t", 0, "x"), ("integral", ("exp", "s"), "s", 0, "x")),
    (("call", "f", (0,), ("+", "x", 1)), ("call", "f", (0,), ("+", 1, "x"))),
    (("mean", ("mean", "x", "x"), "y"), ("mean", ("mean", "z", "z"), "x")),
]
DIFFERENT: list[tuple[Term, Term]] = [
    (("exp", "x"), ("log", "x")),
    (("call", "f", (0,), "x"), ("call", "f", (1,), "x")),
    (("call", "f", (0,), "x"), ("call", "g", (0,), "x")),
    (("integral", ("*", "t", "bound_0"), "t", 0, 1), ("integral", ("*", "t", "t"), "t", 0, 1)),
    (("integral", ("exp", ("*", "t", "x")), "t", 0, 1), ("integral", ("exp", ("*", "t", "t")), "t", 0, 1)),
    (("integral", ("mean", ("*", "s", "t"), "s"), "t", 0, 1), ("integral", ("mean", ("*", "s", "s"), "s"), "t", 0, 1)),
]


@pytest.mark.parametrize(("one", "other"), EQUAL)
def test_equal_functions_have_one_variable(one: Term, other: Term) -> None:
    with alone(Problem("both", ("=", one, other))):
        assert variables(one) == variables(other)


@pytest.mark.parametrize(("one", "other"), DIFFERENT)
def test_different_functions_have_different_variables(one: Term, other: Term) -> None:
    with alone(Problem("both", ("=", one, other))):
        assert not variables(one) & variables(other)
    assert verdict(("=", one, other)) is not Verdict.PROVED


NAMED_LIKE_VALUES: list[tuple[Formula, tuple[Formula, ...]]] = [
    (("=", ("^", "sqrt_2", 2), 2), ()),
    (("=", ("+", ("^", "sin_x", 2), ("^", "cos_x", 2)), 1), ()),
    (("=", "sin_x", ("sin", "x")), ()),
    (("=", ("cos", "x"), "cos_x"), (("=", ("sin", "x"), "sin_x"),)),
    (("=", "Sqrt_1", ("sqrt", "x")), ((">", "x", 0),)),
    (("=", "Call_1", ("call", "f", (0,), "x")), ()),
    (("=", ("call", "x", (0,), "x"), "x"), ()),
]


@pytest.mark.parametrize(("claim", "given"), NAMED_LIKE_VALUES)
def test_a_letter_is_not_confused_with_a_value_of_its_name(claim: Formula, given: tuple[Formula, ...]) -> None:
    assert verdict(claim, *given) is not Verdict.PROVED


def test_values_are_proved_beside_letters_of_their_names() -> None:
    assert verdict(("=", ("^", ("sqrt", 2), 2), 2), (">", "sqrt_2", 0)) is Verdict.PROVED
    circle: Term = ("+", ("^", ("sin", "x"), 2), ("^", ("cos", "x"), 2))
    assert verdict(("=", circle, 1), (">", "sqrt_2", "Sqrt_1")) is Verdict.PROVED
    with one_problem(("sin_x", "Sqrt_1", "sqrt_2")) as table:
        assert table.circle("sin", "x") == "sin_x_2"
        assert table.root(2) == "sqrt_2_2"
        assert variables(("sqrt", "y")) == {"Sqrt_1_2"}
        assert table.term("Sqrt_1_2") == ("sqrt", "y")
        assert not table.stands("Sqrt_1")


def test_a_letter_met_too_late_is_refused() -> None:
    table = Table()
    table.root(2)
    with pytest.raises(Unsupported, match="sqrt_2"):
        table.letter("sqrt_2")


def test_the_turn_of_a_witness_is_no_letter_of_the_statement() -> None:
    double: Term = ("+", ("^", ("cos", "a"), 2), ("-", ("^", ("sin", "a"), 2)))
    wave: Term = ("+", ("*", "p", double), ("*", "turn", ("sin", "a"), ("cos", "a")))
    somewhere = ("exists", ("a",), ("=", wave, 0))
    assert verdict(somewhere) is Verdict.PROVED
    assert verdict(("exists", ("a",), ("=", "a", ("+", "turn", 1)))) is not Verdict.REFUTED


def test_every_name_of_a_problem_is_known_to_be_taken() -> None:
    term = ("integral", ("call", "f", (0,), ("diff", "u", "v", 1)), "t", 0, "infinity")
    problem = Problem("names", ("exists", ("w",), ("=", term, "x")), (("d", "e"),), (("h", (("=", "y", 1),)),))
    assert letters_of(problem) >= set("fuvtwxdey")


def test_a_table_is_used_by_one_problem_only() -> None:
    with one_problem("x"):
        outer = Ring(variables(("sqrt", "x")))
        with one_problem("y"):
            assert variables(("sqrt", "y")) == {"Sqrt_1"}
        assert atoms()["Sqrt_1"] == ("sqrt", "x")
        assert str(outer.ratio(("sqrt", "x")).num) == "Sqrt_1"
    first, other = ("=", ("sqrt", "x"), 2), ("=", ("sqrt", "y"), 2)
    assert not equivalent(first, other, Problem("equivalent", first))


SCRIPT = """
import json
from test_functions import TRUE
from symcheck.proof import certificate, identity
from symcheck.statement import Problem
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
    return ("call", name, orders or (0,) * len(arguments), *arguments)


SQUARE: Term = ("^", "x", 2)
FIELD = call("f", "x", "y")
UNKNOWN_FUNCTIONS: dict[str, tuple[Formula, Verdict]] = {
    "equal arguments": (("=", call("f", ("+", "x", 1)), call("f", ("+", 1, "x"))), Verdict.PROVED),
    "other arguments": (("=", call("f", "x"), call("f", "y")), Verdict.REFUTED),
    "arguments said to be equal": (("=>", ("=", "x", "y"), ("=", call("f", "x"), call("f", "y"))), Verdict.PROVED),
    "arguments exchanged": (("=", call("f", "x", "y"), call("f", "y", "x")), Verdict.REFUTED),
    "a function of itself": (("=", call("f", call("f", "x")), call("f", "x")), Verdict.REFUTED),
    "the chain rule": (
        ("=", ("diff", call("f", SQUARE, "y"), "x", 1), ("*", 2, "x", call("f", SQUARE, "y", orders=(1, 0)))),
        Verdict.PROVED,
    ),
    "the chain rule for both arguments": (
        (
            "=",
            ("diff", call("f", "x", ("*", 3, "x")), "x", 1),
            ("+", call("f", "x", ("*", 3, "x"), orders=(1, 0)), ("*", 3, call("f", "x", ("*", 3, "x"), orders=(0, 1)))),
        ),
        Verdict.PROVED,
    ),
    "the derivative by another argument": (
        ("=", ("diff", call("f", "x", "y"), "x", 1), call("f", "x", "y", orders=(0, 1))),
        Verdict.REFUTED,
    ),
    "a derivative that is not zero": (("=", ("diff", call("f", "x"), "x", 1), 0), Verdict.REFUTED),
    "a derivative by what it does not depend on": (("=", ("diff", call("f", "y"), "x", 1), 0), Verdict.PROVED),
    "mixed derivatives": (
        ("=", ("diff", ("diff", FIELD, "x", 1), "y", 1), ("diff", ("diff", FIELD, "y", 1), "x", 1)),
        Verdict.PROVED,
    ),
    "the root of what is said to be positive": (
        ("=>", (">", call("f", "x"), 0), ("=", ("^", ("sqrt", call("f", "x")), 2), call("f", "x"))),
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
    point = identity.decide(Problem("even", ("=", call("f", "x"), call("f", ("-", "x"))))).point
    assert point is not None
    (first, second) = point["calls"]
    assert first[2] != second[2]
    for claim in (("!=", call("f", "x"), call("f", "y")), ("<", call("f", ("^", "x", 2)), call("f", ("^", "y", 2)))):
        problem = Problem("one value", claim, (), (("h", (("=", ("^", "x", 2), ("^", "y", 2)), ("!=", "x", 0))),))
        outcome = identity.decide(problem)
        assert outcome.point is not None
        seen: dict[str, str] = {}
        assert all(seen.setdefault(str(each[:3]), each[3]) == each[3] for each in outcome.point["calls"])
        assert reason(json.loads(json.dumps(certificate(problem, outcome)))) is None


def test_a_point_at_which_an_unknown_function_has_two_values_is_rejected() -> None:
    problem = Problem("even", ("=", call("f", "x"), call("f", ("-", "x"))))
    made = json.loads(json.dumps(certificate(problem, identity.decide(problem))))
    assert reason(made) is None
    made["point"]["calls"][1][2] = made["point"]["calls"][0][2]
    assert "two values" in str(reason(made))
