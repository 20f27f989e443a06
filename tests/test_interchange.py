"""Sums of sequences of which nothing is said, by the coefficients of their members; binomial sums of any numbers."""

from __future__ import annotations

import pytest

from symcheck import decide
from symcheck.core.problems import Problem
from symcheck.core.terms import node
from symcheck.question.interchange import coefficients

N = r"n \in \mathbb{N}"
PROVED = [
    r"\sum_{k=0}^n \sum_{m=0}^k b_m = \sum_{m=0}^n (n - m + 1) b_m",
    r"\sum_{k=0}^n \sum_{m=k}^n b_m = \sum_{m=0}^n (m + 1) b_m",
    r"\sum_{k=0}^n x^k \sum_{m=k}^n \binom{m}{k} b_m = \sum_{m=0}^n b_m (1 + x)^m",
    r"\sum_{k=0}^n \sum_{m=0}^n \binom{m}{k} b_m (-x)^k = \sum_{m=0}^n (1 - x)^m b_m",
    r"\sum_{k=0}^n (b_k + 2 c_k) - \sum_{k=0}^n c_k = \sum_{k=0}^n (b_k + c_k)",
    r"\sum_{k=0}^n \binom{n}{k} (-1)^k x^k = (1 - x)^n",
]
FALSE = [
    r"\sum_{k=0}^n \sum_{m=0}^k b_m = \sum_{m=0}^n (n - m) b_m",
    r"\sum_{k=0}^n \sum_{m=k}^n b_m = \sum_{m=0}^n m b_m",
    r"\sum_{k=0}^n x^k \sum_{m=k}^n \binom{m}{k} b_m = \sum_{m=0}^n b_m (1 - x)^m",
    r"\sum_{k=0}^n \sum_{m=0}^n \binom{m}{k} b_m (-x)^k = \sum_{m=0}^n (1 + x)^m b_m",
    r"\sum_{k=0}^n (b_k + 2 c_k) - \sum_{k=0}^n c_k = \sum_{k=0}^n (b_k - c_k)",
    r"\sum_{k=0}^n \sum_{m=0}^{n-1} b_m = (n + 1) \sum_{m=0}^n b_m",
    r"\sum_{k=0}^n \binom{n}{k} (-1)^k x^k = (1 + x)^n",
]


@pytest.mark.parametrize("relation", PROVED)
def test_sums_are_equal_as_the_coefficients_of_their_members_are(relation: str) -> None:
    answer = decide(relation, given=N)
    assert answer.verdict == "proved", answer.reason


@pytest.mark.parametrize("relation", FALSE)
def test_sums_with_another_coefficient_are_not_proved_to_be_equal(relation: str) -> None:
    assert decide(relation, given=N).verdict != "proved"


SERIES = r"g(x) = \sum_{k=0}^\infty b_k x^k"


@pytest.mark.parametrize(
    ("verdict", "relation"),
    [
        ("proved", r"g(3x) = \sum_{k=0}^\infty 3^k b_k x^k"),
        ("refuted", r"g(3x) = \sum_{k=0}^\infty 3 b_k x^k"),
        ("proved", r"g(-x) = \sum_{k=0}^\infty (-1)^k b_k x^k"),
        ("refuted", r"g(-x) = -\sum_{k=0}^\infty (-1)^k b_k x^k"),
        ("proved", r"g(x^3) = \sum_{k=0}^\infty b_k x^{3k}"),
        ("refuted", r"g(x^3) = \sum_{k=0}^\infty b_k x^{k+3}"),
        ("undecided", r"g(3x) = 2 g(x)"),  # an equation for the coefficients
        ("undecided", r"\sum_{k=0}^\infty b_k x^k = \sum_{k=0}^\infty k b_k x^k"),  # and so is this
        ("undecided", r"g(x) = \sum_{k=0}^\infty a_k x^k"),
    ],
)
def test_a_value_of_a_series_is_the_series_with_the_same_coefficients(verdict: str, relation: str) -> None:
    assert decide(relation, SERIES).verdict == verdict


def test_nothing_is_compared_where_something_is_said_of_a_sequence() -> None:
    u = node("call", "u", (0,), "k")
    claim = node("=", node("sum", u, "k", 0, "n"), node("sum", node("*", "k", u), "k", 0, "n"))
    assert coefficients(Problem("x", claim)) is not None
    assert coefficients(Problem("x", claim, hypotheses=(("said", (node("=", u, "k"),)),))) is None
    assert decide(PROVED[0], given=(N, r"b_1 = 0")).verdict != "refuted"
