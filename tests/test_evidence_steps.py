"""Certificates are told in words without losing or inventing structure."""

from __future__ import annotations

from typing import Any

import pytest

from symcheck.core.terms import node
from symcheck.core.words import term
from symcheck.views import steps

TERMS: list[tuple[Any, str]] = [
    (["+", "a", ["-", "b"], "c"], "a - b + c"),
    (["+", ["-", "a"], "b"], "-a + b"),
    (["+", "a", ["-", ["+", "b", "c"]]], "a - (b + c)"),
    (["-", ["*", 2, "b"]], "-2*b"),
    (["-", ["+", "a", "b"]], "-(a + b)"),
    (["*", ["+", "a", "b"], "c"], "(a + b)*c"),
    (["*", "a", ["-", "b"]], "a*(-b)"),
    (["/", 1, ["*", "a", "b"]], "1/(a*b)"),
    (["/", ["/", 1, 2], 3], "(1/2)/3"),
    (["^", ["+", "a", 1], 2], "(a + 1)^2"),
    (["^", ["^", "a", 2], 3], "(a^2)^3"),
    (["^", ["-", "a"], 2], "(-a)^2"),
    (["sin", ["+", "a", "b"]], "sin(a + b)"),
    (["diff", "f", "x", 1, "x"], "diff(f, x, 1)"),
    (["diff", "f", "x", 1, 0], "diff(f, x, 1, 0)"),
    (["call", "f", [0, 0], "x", "y"], "f(x, y)"),
    (["call", "f", [1, 0], "x", "y"], "f[1, 0](x, y)"),
    (["integral", "x", "x", 0, ["infinity"]], "integral(x, x, 0, infinity)"),
    (["*", 2, ["pi"]], "2*pi"),
    (["forall", ["c"], [">", "c", 0]], "for all c: c > 0"),
    (["or"], "false"),
    (["+", "a", ["+", "b", "c"]], "a + (b + c)"),
    (["<=", ["+", "a", "b"], 0], "a + b ≤ 0"),
    (["=>", ["and", ["=", "a", 1], ["!=", "b", 0]], ["or", ["<", "a", "b"], [">", "a", "b"]]],
     "a = 1 and b ≠ 0 ⟹ a < b or a > b"),
    (["and", ["or", ["=", "a", 1], ["=", "b", 1]], ["=", "c", 1]], "(a = 1 or b = 1) and c = 1"),
    (["exists", ["c", "s"], ["=", "c", "s"]], "there are c, s with c = s"),
]  # fmt: skip


@pytest.mark.parametrize(("value", "text"), TERMS, ids=[text for _, text in TERMS])
def test_a_term_is_written_with_the_brackets_it_needs(value: Any, text: str) -> None:
    assert term(value) == text


def test_distinct_terms_are_written_differently() -> None:
    texts = [term(value) for value, _ in TERMS]
    assert len(set(texts)) == len(texts)


@pytest.mark.parametrize(
    ("ref", "text"),
    [
        (["hyp", "orthogonal", 0], "orthogonal [1]"),
        (["here", 2], "assumption 3"),
        (["point", 0], "value 1 at the point"),
        (["nonzero", 1], "denominator 2"),
        (["positive", ["+", "a", 1]], "a + 1 > 0"),
        (["something", "new"], '["something", "new"]'),
    ],
)
def test_a_reference_is_put_in_words(ref: list[Any], text: str) -> None:
    assert steps.reference(ref) == text


def test_every_part_of_a_proof_is_shown_once() -> None:
    proof = {
        "rule": "split",
        "form": ["*", ["^", "FACTOR_1", 2], "FACTOR_2"],
        "times": [["here", 0], "DENOMINATOR"],
        "cofactors": [[["here", 0], "QUOTIENT"]],
        "cases": [
            {"rule": "nonnegative", "form": ["^", "FORM", 2], "cofactors": []},
            {"rule": "witness", "point": {"POINT": 1}},
        ],
    }
    text = "\n".join(steps.proof_lines({"proof": proof, "lemmas": [["LEMMA", ["=", 0, 0]]], "nonzero": ["DIVISOR"]}))
    for word in (
        "LEMMA",
        "QUOTIENT",
        "multiplied with: DENOMINATOR",
        "(power 2)",
        "DIVISOR",
        "FACTOR_1",
        "FACTOR_2",
        "FORM^2",
        "POINT = 1",
        "case 1:",
        "case 2:",
        "not zero",
    ):
        assert text.count(word) == 1, word


def test_a_theorem_is_shown_with_its_premises_and_what_follows() -> None:
    proof = {
        "rule": "theorem",
        "of": "root",
        "with": {"t": ["+", "RADICAND", 1]},
        "premises": [{"rule": "nonnegative", "form": "FORM", "cofactors": []}],
        "then": {"rule": "identity", "times": ["DIVISOR"], "cofactors": [[["here", 0], "QUOTIENT", "FACTOR"]]},
    }
    lines = list(steps.steps(proof))
    assert lines[0] == "theorem root (t = RADICAND + 1): t >= 0 |- sqrt(t) >= 0 and sqrt(t)**2 == t"
    assert [line.strip() for line in lines[1:]] == [
        "premise 1:",
        "nonnegative: the larger side less the smaller is the form, whose sign is plain",
        "form: FORM",
        "identity: the difference of the two sides is a combination of what is given",
        "multiplied with: DIVISOR",
        "+ (QUOTIENT) · (FACTOR) · [assumption 1]",
    ]


def test_functions_and_existence_are_shown_with_their_letters() -> None:
    proof = {
        "rule": "theorem",
        "of": "quarter_turn",
        "with": {"f": {"letter": "x", "term": ["sin", "x"]}},
        "letters": ["NEW"],
        "premises": [{"rule": "every", "letters": ["x"], "then": {"rule": "identity"}}],
        "then": {"rule": "compute", "values": [["here", 0], ["point", 1]]},
    }
    text = "\n".join(steps.steps(proof))
    assert "theorem quarter turn (f(x) = sin(x)): " in text
    for words in ("every: ", "with the new letters x", "with the new letters NEW", "compute: "):
        assert text.count(words) == 1, words
    assert text.endswith("from assumption 1, value 2 at the point")


def test_what_is_proved_first_is_shown_first() -> None:
    then = {"rule": "compute"}
    proof = {"rule": "have", "formula": ["=", "FACT", 1], "proof": {"rule": "identity"}, "then": then}
    first, *rest = (line.strip() for line in steps.steps(proof))
    assert first == "first: FACT = 1"
    assert [line.partition(":")[0] for line in rest] == ["proof", "identity", "compute"]


def test_a_counterexample_is_shown_with_both_sides() -> None:
    found = {"values": {"x": ["/", 2, 7], "y": ["sqrt", 3]}, "shown": [["=", "x", 1], ["=", "y", ["-", ["sqrt", 3]]]]}
    assert steps.point(found["values"]) == "x = 2/7, y = sqrt(3)"
    assert steps.sides(found) == "the sides are 1 against -sqrt(3)"
    false, true = ["=>", ["<", "x", 0], ["or"]], ["=", "x", "y"]
    for shown, told in (
        ([true, false], "part 2 of 2 is false"),
        ([false, true, false], "parts 1 and 3 of 3 are false"),
        ([false, false], "all its parts are false"),
        ([false], "it is false"),
    ):
        assert steps.sides({"shown": shown}) == told
    assert steps.sides({}) == ""
    low, high = ["/", -3141593, 10**6], ["/", -3141592, 10**6]
    digits = {"values": {}, "shown": [["and", ["<=", low, ["-", ["pi"]]], ["<=", ["-", ["pi"]], high]]]}
    assert steps.sides(digits) == "-pi lies between -3.141593 and -3.141592"


def test_an_angle_is_given_by_its_sine_and_cosine() -> None:
    third = ["*", 2, ["arctan", ["/", 1, 3]]]
    assert steps.point({"a": third, "b": ["*", 2, ["arctan", 0]]}) == "sin a = 3/5, cos a = 4/5, sin b = 0, cos b = 1"
    assert steps.point({"a": ["*", 2, ["arctan", ["sqrt", 2]]]}) == "a = 2*arctan(sqrt(2))"


def test_an_angle_that_others_depend_on_comes_first() -> None:
    inner = ["arctan", ["/", 5, 8]]
    outer = ["arctan", ["/", 2, ["cos", inner]]]
    values = {"H": ["*", 4, ["cos", outer], ["sin", inner]], "J": 3, "a": outer, "b": inner, "c": inner}
    told = steps.point(values)
    assert told == "J = 3, b = arctan(5/8), c = arctan(5/8), a = arctan(2/cos(b)), H = 4*cos(a)*sin(b)"
    same = node("cos", node("arctan", 2))
    assert steps.point({"x": same, "y": same}) == "x = cos(arctan(2)), y = cos(arctan(2))"


def test_a_decimal_is_shown_as_one() -> None:
    assert term(["+", "x", ["-", ["/", -51, 10**6]], ["/", 1, 100]]) == "x - (-0.000051) + 1/100"
    assert term(["/", 12345678, 10**6]) == "12.345678"
