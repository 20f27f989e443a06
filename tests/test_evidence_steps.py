"""Certificates are told in words without losing or inventing structure."""

from __future__ import annotations

from typing import Any

import pytest

from symcheck.evidence import steps

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
    (["diff", "f", "x", 1], "diff(f, x, 1)"),
    (["+", "a", ["+", "b", "c"]], "a + (b + c)"),
    (["<=", ["+", "a", "b"], 0], "a + b ≤ 0"),
    (["=>", ["and", ["=", "a", 1], ["!=", "b", 0]], ["or", ["<", "a", "b"], [">", "a", "b"]]],
     "a = 1 and b ≠ 0 ⟹ a < b or a > b"),
    (["and", ["or", ["=", "a", 1], ["=", "b", 1]], ["=", "c", 1]], "(a = 1 or b = 1) and c = 1"),
    (["exists", ["c", "s"], ["=", "c", "s"]], "there are c, s with c = s"),
]  # fmt: skip


@pytest.mark.parametrize(("value", "text"), TERMS, ids=[text for _, text in TERMS])
def test_a_term_is_written_with_the_brackets_it_needs(value: Any, text: str) -> None:
    assert steps.term(value) == text


def test_distinct_terms_are_written_differently() -> None:
    texts = [steps.term(value) for value, _ in TERMS]
    assert len(set(texts)) == len(texts)


@pytest.mark.parametrize(
    ("ref", "text"),
    [
        (["hyp", "orthogonal", 0], "orthogonal [1]"),
        (["here", 2], "assumption 3"),
        (["positive", ["+", "a", 1]], "a + 1 > 0"),
        (["something", "new"], '["something", "new"]'),
    ],
)
def test_a_reference_is_told_in_words(ref: list[Any], text: str) -> None:
    assert steps.reference(ref) == text


def test_every_part_of_a_proof_is_told_once() -> None:
    proof = {
        "rule": "split",
        "factors": [["FACTOR_1", 2], ["FACTOR_2", 1]],
        "times": [["here", 0]],
        "cofactors": [[["here", 0], "QUOTIENT"]],
        "nonzero": [["DIVISOR"]],
        "cases": [
            {"rule": "nonnegative", "form": ["^", "FORM", 2], "cofactors": []},
            {"rule": "witness", "point": {"POINT": 1}},
        ],
    }
    text = "\n".join(steps.steps(proof))
    for word in (
        "QUOTIENT",
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


def test_a_theorem_is_told_with_its_premises_and_what_follows() -> None:
    proof = {
        "rule": "theorem",
        "of": ["root", ["+", "RADICAND", 1]],
        "premises": [{"rule": "nonnegative", "form": "FORM", "cofactors": []}],
        "then": {"rule": "identity", "clear": ["DIVISOR"], "cofactors": [[["here", 0], "QUOTIENT", "FACTOR"]]},
    }
    lines = list(steps.steps(proof))
    assert lines[0] == "theorem root (RADICAND + 1): The square root of a number that is not negative."
    assert [line.strip() for line in lines[1:]] == [
        "premise 1:",
        "nonnegative: the larger side less the smaller is the form, whose sign is plain",
        "form: FORM",
        "identity: the difference of the two sides is a combination of what is given",
        "multiplied with: DIVISOR",
        "+ (QUOTIENT) · (FACTOR) · [assumption 1]",
    ]


def test_a_counterexample_is_told_with_both_sides() -> None:
    found = {"values": {"x": "2/7", "y": ["sqrt", 3]}, "sides": ["1", ["-", ["sqrt", 3]]]}
    assert steps.point(found["values"]) == "x = 2/7, y = sqrt(3)"
    assert steps.sides(found) == "the sides are 1 against -sqrt(3)"
    assert steps.sides({}) == ""
    digits = {"values": {}, "enclosed": [[["-", "pi"], 6, ["/", -3141593, 10**6], ["/", -3141592, 10**6]]]}
    assert steps.sides(digits) == "-pi lies between -3.141593 and -3.141592"


def test_a_decimal_is_shown_as_one() -> None:
    assert steps.term(["+", "x", ["-", ["/", -51, 10**6]], ["/", 1, 100]]) == "x - (-0.000051) + 1/100"
    assert steps.term(["/", 12345678, 10**6]) == "12.345678"
