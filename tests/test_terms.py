"""Terms: one strict JSON form, substitution that captures nothing, derivatives as those of numbers."""

from __future__ import annotations

import json
import random
from typing import Any

import pytest
import soundness
from mpmath import mp, mpf
from soundness import unfold

from symcheck.coq.meaning import Meaning, NoValue, Smooth
from symcheck.core.calculus import Unknown, derivative, differentiated, functions, letters, polynomial_in, substituted
from symcheck.core.terms import FUNCTIONS, Binder, Call, Malformed, Node, Reader, node

JSON = Any
TERMS: list[JSON] = [
    0, -7, 10**40, "x", "a_12", "sin_x", ["pi"], ["+"], ["+", 1, "x", ["-", "y"]], ["*", 2, "x"], ["/", 1, "x"],
    ["^", "x", -2], *([name, "x"] for name in FUNCTIONS), ["pow", "x", ["/", 1, 2]], ["call", "f", [0], "x"],
    ["call", "f", [1, 0], "x", ["sin", "y"]], ["mean", ["sin", "x"], "x"], ["integral", "x", "x", 0, "x"],
    ["integral", "x", "x", ["-infinity"], ["infinity"]], ["diverges", "x", "x", 0, ["infinity"]],
    ["sum", "k", "k", 1, "n"], ["sum", ["^", 2, -2], "k", 1, ["infinity"]], ["product", "k", "k", 1, "n"],
    ["diff", ["^", "x", 3], "x", 2, "y"],
]  # fmt: skip
FORMULAS: list[JSON] = [
    *([sign, "x", 0] for sign in ("=", "!=", "<", "<=", ">", ">=")), ["and"], ["or"], ["and", ["=", 0, 0]],
    ["=>", ["=", 0, 0], ["=", "x", 1]], ["<=>", ["=", 0, 0], ["=", "x", 1]], ["exists", ["x", "y"], ["=", "x", "y"]],
    ["forall", ["x"], ["exists", ["y"], ["=", "x", "y"]]],
]  # fmt: skip
NO_TERMS: list[JSON] = [
    None, True, False, 1.0, 0.5, float("nan"), "", "_x", "x y", "é", "2x", "x-y", [], [[]], {}, {"x": 1}, ["x"], [0],
    ["=", "x", 0], ["infinity"], ["-infinity"], ["sinh", "x"], ["sin"], ["sin", "x", "y"], ["pi", 1], ["-"],
    ["-", 1, 2], ["/", 1], ["^", "x", "y"], ["^", "x", 2.0], ["^", "x", True], ["^", "x", None], ["pow", "x"],
    ["call", "f", [], "x"], ["call", "f", [0]], ["call", "f", [0, 0], "x"], ["call", "f", [-1], "x"],
    ["call", "f", [9], "x"], ["call", "f", [True], "x"], ["call", "f", 0, "x"], ["call", 0, [0], "x"],
    ["mean", "x", 0], ["mean", "x", ["x"]], ["mean", "x", "x", 0], ["integral", "x", "x", 0], ["sin", ["=", 0, 0]],
    ["integral", "x", "x", 0, ["infinity", 1]], ["product", 1, "k", 1, ["infinity"]],
    ["sum", ["infinity"], "k", 1, 2], ["sum", 1, "k", 1, ["infinity", 1]], ["diff", "x", "x", 0, 1],
    ["diff", "x", "x", 9, 1], ["diff", "x", "x", "n", 1], ["diff", "x", "x", True, 1], ["+", ["infinity"]], [None, 1],
]  # fmt: skip
NO_FORMULAS: list[JSON] = [
    0, "x", True, None, [], {}, ["+", 0, 0], ["="], ["=", 0], ["=", 0, 0, 0], ["~", 0, 0], ["and", 0], ["and", "x"],
    ["=>", ["=", 0, 0]], ["=>", 0, 1], ["not", ["=", 0, 0]], ["=", ["=", 0, 0], 0], ["exists", "x", ["=", 0, 0]],
    ["exists", [], ["=", 0, 0]], ["exists", ["x", "x"], ["=", 0, 0]], ["exists", [0], ["=", 0, 0]],
    ["forall", ["x"], 0],
]  # fmt: skip


@pytest.mark.parametrize("data", TERMS, ids=json.dumps)
def test_a_term_is_written_as_it_is_read(data: JSON) -> None:
    assert json.loads(json.dumps(Reader().term(data))) == data


@pytest.mark.parametrize("data", FORMULAS, ids=json.dumps)
def test_a_formula_is_written_as_it_is_read(data: JSON) -> None:
    assert json.loads(json.dumps(Reader().formula(data))) == data


@pytest.mark.parametrize("data", NO_TERMS, ids=str)
def test_a_malformed_term_is_refused(data: JSON) -> None:
    for inside in (data, ["+", 1, data], ["mean", data, "x"], ["call", "f", [0], data]):
        with pytest.raises((Malformed, TypeError)):
            Reader().term(inside)


@pytest.mark.parametrize("data", NO_FORMULAS, ids=str)
def test_a_malformed_formula_is_refused(data: JSON) -> None:
    for inside in (data, ["and", data], ["exists", ["z"], data]):
        with pytest.raises((Malformed, TypeError)):
            Reader().formula(inside)


def test_a_definition_is_an_abbreviation() -> None:
    reader = Reader()
    reader.define("d", ["+", "x", 1])
    reader.define("e", ["*", "d", "d"])
    assert reader.term("e") == Reader().term(["*", ["+", "x", 1], ["+", "x", 1]])
    assert reader.term(["mean", "d", "d"]) == Reader().term(["mean", "d", "d"])
    assert reader.term(["mean", "d", "x"]) == Reader().term(["mean", ["+", "x", 1], "x"])
    assert reader.formula(["exists", ["d"], ["=", "d", "e"]])[2][1] == "d"
    with pytest.raises(Malformed, match="twice"):
        reader.define("d", 2)


def test_a_term_that_grows_without_bound_is_refused() -> None:
    reader = Reader()
    reader.define("d_0", ["+", "x", "x"])
    for k in range(17):
        reader.define(f"d_{k + 1}", ["+", f"d_{k}", f"d_{k}"])
    with pytest.raises(Malformed, match="too large"):
        reader.term(["*", *["d_17"] * 8])


def test_letters_are_those_that_are_free() -> None:
    read = Reader()
    assert letters(read.term(["+", "x", ["integral", ["*", "x", "y"], "x", 0, "z"]])) == {"x", "y", "z"}
    assert letters(read.term(["integral", "x", "x", 0, "x"])) == {"x"}
    assert letters(read.term(["diff", ["*", "t", "a"], "t", 1, "b"])) == {"a", "b"}
    assert letters(read.term(["call", "f", [0], "x"])) == {"x"}
    assert letters(read.formula(["exists", ["x"], ["=", "x", "y"]])) == {"y"}
    assert functions(read.term(["mean", ["call", "f", [0], ["call", "g", [1], "x"]], "x"])) == {"f", "g"}


@pytest.mark.parametrize(
    ("before", "by", "after"),
    [
        (["+", "x", "y"], {"x": "y", "y": "x"}, ["+", "y", "x"]),
        (["mean", "x", "x"], {"x": 1}, ["mean", "x", "x"]),
        (["mean", ["*", "x", "y"], "x"], {"y": "x"}, ["mean", ["*", "x_0", "x"], "x_0"]),
        (["mean", ["*", "x", "y", "x_0"], "x"], {"y": "x"}, ["mean", ["*", "x_1", "x", "x_0"], "x_1"]),
        (["integral", "x", "x", 0, "x"], {"x": 2}, ["integral", "x", "x", 0, 2]),
        (["diff", ["^", "x", 2], "x", 1, "x"], {"x": 3}, ["diff", ["^", "x", 2], "x", 1, 3]),
        (
            ["integral", ["integral", ["*", "x", "y", "z"], "y", 0, 1], "x", 0, 1], {"z": ["+", "x", "y"]},
            ["integral", ["integral", ["*", "x_0", "y_0", ["+", "x", "y"]], "y_0", 0, 1], "x_0", 0, 1],
        ),
    ],
)  # fmt: skip
def test_nothing_is_captured_by_a_substitution(before: JSON, by: JSON, after: JSON) -> None:
    read = Reader()
    assert substituted(read.term(before), {x: read.term(t) for x, t in by.items()}) == read.term(after)


def test_a_quantifier_captures_nothing() -> None:
    read = Reader()
    found = substituted(read.formula(["exists", ["x"], ["forall", ["y"], ["=", "x", "z"]]]), {"z": "y"})
    assert found == read.formula(["exists", ["x"], ["forall", ["y_0"], ["=", "x", "y"]]])


def test_a_function_is_replaced_by_a_term_that_keeps_its_letters() -> None:
    read = Reader()
    body = read.term(["+", "t", "x"])
    found = substituted(read.term(["mean", ["call", "f", [0], "x"], "x"]), {}, {"f": (("t",), body)})
    assert found == read.term(["mean", ["+", "x_0", "x"], "x_0"])
    nested = substituted(read.term(["call", "f", [0], ["call", "f", [0], 1]]), {}, {"f": (("t",), body)})
    assert nested == read.term(["+", ["+", 1, "x"], "x"])
    for other in (["call", "f", [1], "x"], ["call", "f", [0, 0], "x", "x"]):
        with pytest.raises(Malformed):
            substituted(read.term(other), {}, {"f": (("t",), body)})


def places(seed: int) -> dict[str, mpf]:
    rng = random.Random(seed)
    return {x: mpf(rng.randint(1, 60)) / 16 for x in (*soundness.LETTERS, *soundness.BOUND, "d")}


def heavy(t: JSON) -> bool:
    """Whether the value takes long to find: one binder in another, or powers of powers."""
    text = json.dumps(t)
    return "integral" in text or sum(text.count(kind) for kind in ("mean", "diff", "sum", "product", "pow", "exp")) > 1


def test_substitution_is_evaluation_at_another_place() -> None:
    """t with u in place of x has the value of t where x is u, whatever binders do."""
    forger, read, compared = soundness.Forger(3), Reader(), 0
    for seed in range(400):
        t, u = forger.term(3), forger.term(1)
        if heavy(t) or heavy(u):
            continue
        try:
            found = json.loads(json.dumps(substituted(read.term(t), {"x": read.term(u)})))
        except (Malformed, TypeError):
            continue
        meaning, at = Meaning(Smooth(random.Random(seed))), places(seed)
        try:
            there = meaning.term(t, {**at, "x": meaning.term(u, at)})
            assert abs(meaning.term(found, at) - there) < 1e-15 * (1 + abs(there)), (t, u)
            compared += 1
        except (NoValue, ValueError, OverflowError, ZeroDivisionError):
            continue
    assert compared > 80


def test_a_derivative_is_the_limit_of_differences() -> None:
    forger, read, compared = soundness.Forger(4), Reader(), 0
    for seed in range(500):
        t = forger.term(3, ("x", "y"))
        if heavy(t):
            continue
        try:
            rate = json.loads(json.dumps(derivative(read.term(t), "x")))
        except (Malformed, TypeError, Unknown):
            continue
        meaning, at = Meaning(Smooth(random.Random(seed))), places(seed)
        try:
            found = meaning.term(rate, at)
            near = [meaning.term(t, {**at, "x": at["x"] + h}) for h in (mpf(10) ** -12, -(mpf(10) ** -12))]
        except (NoValue, ValueError, OverflowError, ZeroDivisionError):
            continue
        difference = (near[0] - near[1]) / (2 * mpf(10) ** -12)
        if abs(found) < 1e6 and not mp.im(difference):
            assert abs(found - difference) < 1e-9 * (1 + abs(found)), t
            compared += 1
    assert compared > 80


@pytest.mark.parametrize("order", range(1, 5))
def test_a_derivative_at_a_place_has_its_order(order: int) -> None:
    data = ["diff", ["*", ["sin", ["*", 2, "x"]], ["exp", "x"]], "x", order, ["/", "y", 3]]
    term = Reader().term(data)
    assert isinstance(term, Binder)
    meaning, at = Meaning(Smooth(random.Random(1))), places(order)
    assert abs(meaning.term(json.loads(json.dumps(differentiated(term))), at) - meaning.term(data, at)) < 1e-20


def test_a_derivative_without_a_rule_is_unknown() -> None:
    with pytest.raises(Unknown):
        derivative(node("gamma", "x"), "x")
    assert derivative(node("gamma", "y"), "x") == 0


@pytest.mark.parametrize(
    ("data", "rate"),
    [
        (["sum", ["sin", "y"], "k", 1, "n"], ["sum", ["+", ["cos", "y"]], "k", 1, "n"]),
        (
            ["sum", ["call", "f", [0, 1], "k", "y"], "k", 1, 3],
            ["sum", ["+", ["call", "f", [0, 2], "k", "y"]], "k", 1, 3],
        ),
        (["sum", ["call", "f", [0], "k"], "k", 1, "n"], 0),
        (["sum", "y", "y", 1, 3], 0),
    ],
)
def test_a_sum_of_what_is_smooth_is_differentiated_addend_by_addend(data: JSON, rate: JSON) -> None:
    found = derivative(Reader().term(data), "y")
    assert found == rate if isinstance(rate, int) else json.loads(json.dumps(found)) == rate


@pytest.mark.parametrize(
    ("data", "rate"),
    [
        (["integral", 1, "x", 0, "y"], 1),
        (["integral", ["sin", "x"], "x", "y", 2], ["-", ["sin", "y"]]),
        (["integral", ["+", "x", "y"], "x", 0, 1], ["integral", ["+", 1], "x", 0, 1]),
        (["integral", ["exp", "y"], "y", 0, "y"], ["exp", "y"]),
    ],
)
def test_an_integral_of_what_is_smooth_is_differentiated_by_its_ends_and_under_its_sign(data: JSON, rate: JSON) -> None:
    found = derivative(Reader().term(data), "y")
    assert json.loads(json.dumps(found)) == rate


@pytest.mark.parametrize(
    "data",
    [
        ["mean", ["*", "x", "y"], "x"],
        ["sum", ["sqrt", "y"], "k", 1, 3],
        ["sum", "y", "k", 1, ["infinity"]],
        ["sum", "k", "k", 1, "y"],
        ["integral", ["sqrt", "y"], "x", 0, 1],
        ["integral", ["/", 1, "x"], "x", 1, "y"],
        ["integral", "y", "x", 0, ["infinity"]],
    ],
)
def test_the_derivative_of_a_binder_is_unknown(data: JSON) -> None:
    with pytest.raises(Unknown):
        derivative(Reader().term(data), "y")
    assert derivative(Reader().term(data), "z") == 0


def test_a_polynomial_has_no_letter_below_a_line() -> None:
    read = Reader()
    wave = [read.term(["sin", "x"]), read.term(["cos", "x"])]
    for data in (1, "y", ["sin", "y"], ["sin", "x"], ["*", ["/", 1, "y"], ["^", ["cos", "x"], 3]], ["mean", "x", "x"]):
        assert polynomial_in(read.term(data), *wave), data
    for data in ("x", ["sin", ["*", 2, "x"]], ["/", 1, ["sin", "x"]], ["^", ["sin", "x"], -1], ["tan", "x"]):
        assert not polynomial_in(read.term(data), *wave), data
    assert polynomial_in(read.term(["+", ["^", "x", 2], "y"]), "x")
    assert not polynomial_in(read.term(["sqrt", "x"]), "x")


def test_nodes_are_equal_if_they_are_the_same() -> None:
    read = Reader()
    assert read.term(["sin", "x"]) == node("sin", "x") != node("cos", "x")
    assert isinstance(read.term(["call", "f", [0], "x"]), Call)
    assert hash(read.term(["+", "x", 1])) == hash(node("+", "x", 1))
    assert not isinstance("x", Node)
    assert unfold(["mean", "x", "x"], {"x": 1}) == ["mean", "x", "x"]
