"""Counterexamples where vectors are units and matrices turns, also where long formulas are given; skew matrices."""

from __future__ import annotations

import pytest

from symcheck import decide

SKEW = {r"\hat{u}": "skew matrix of u", r"\hat{v}": "skew matrix of v"}
GIVEN = (r"A \in SO(3)", r"u \in \mathbb{R}^3")


@pytest.mark.parametrize(
    ("verdict", "relation"),
    [("refuted", r"e^{\hat{v}} = -A^T e^{\hat{u}} A"), ("refuted", r"e^{\hat{v}} = 2 A^T e^{-\hat{u}} A")],
)
def test_what_is_false_of_exponentials_of_skew_matrices_is_refuted_under_an_equation(
    verdict: str, relation: str
) -> None:
    answer = decide(relation, r"A e^{\hat{v}} = e^{-\hat{u}} A", GIVEN, {"A": "matrix", **SKEW})
    assert answer.verdict == verdict, answer.reason


def test_an_equation_of_which_nothing_else_is_said_stays_one() -> None:
    assert decide(r"e^{\hat{v}} = -A^T e^{\hat{u}} A", (), GIVEN, {"A": "matrix", **SKEW}).verdict != "refuted"
