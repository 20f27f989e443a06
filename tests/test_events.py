"""Probabilities of events, and densities with parameters."""

from __future__ import annotations

import pytest

from symcheck import decide

INDEPENDENT = r"P(A \cap B) = P(A) P(B)"
TOTAL = r"P(B|A)P(A) {} P(B|A^c)P(A^c)"


@pytest.mark.parametrize(
    ("relation", "given", "verdict"),
    [
        (r"P(A \cup B) = P(A) + P(B) - P(A \cap B)", (), "proved"),
        (r"P(A \cup B) = P(A) + P(B) + P(A \cap B)", (), "refuted"),
        (r"\Pr(A \cup B) \le \Pr(A) + \Pr(B)", (), "proved"),
        (r"P(A|B) = \frac{P(B|A) P(A)}{P(B)}", (), "proved"),
        (r"P(A|B) = \frac{P(B|A) P(B)}{P(A)}", (), "refuted"),
        (r"\mathbb{P}(\bar{A}) = 1 - \mathbb{P}(A)", (), "proved"),
        (r"P(A^c) = 1 + P(A)", (), "refuted"),
        (f"P(B) = {TOTAL.format('+')}", (), "proved"),
        (f"P(B) = {TOTAL.format('-')}", (), "refuted"),
        (r"P(A \cap B \cap C) = P(A) P(B|A) P(C|A \cap B)", (), "proved"),
        (r"P(A|B, C) = \frac{P(B|A, C) P(A|C)}{P(B|C)}", (), "proved"),
        (r"P(A \setminus B) = P(A) - P(A \cap B)", (), "proved"),
        (r"P(A \cap B^c) = P(A)(1 - P(B))", (INDEPENDENT,), "proved"),
        (r"P(A|B) = P(A)", (INDEPENDENT, "P(B) > 0"), "proved"),
        (r"P(A|B) = \frac{3}{10}", (r"P(A) = \frac12", r"P(B|A) = \frac{3}{10}", r"P(B) = \frac12"), "proved"),
    ],
)
def test_probabilities_of_events_are_decided(relation: str, given: tuple[str, ...], verdict: str) -> None:
    assert decide(relation, given=given).verdict == verdict


@pytest.mark.parametrize(
    ("relation", "verdict", "reason"),
    [
        (r"P(A \cup B) = P(A) + P(B)", "ambiguous", "A, B exclude one another"),
        (r"P(A \cap B) = P(A) P(B)", "ambiguous", "A, B are independent"),
        (r"P(A|B) = P(B|A)", "ambiguous", "A, B are equally likely"),
        (r"P(A|B) = \frac{3}{10}", "undecided", "an equation or a condition"),
        (r"P(A \cup B) = p", "undecided", "definition"),
        (r"P(x|y) = P(y|x)", "undecided", "no algebraic form"),
        (r"P(A|B) = A", "undecided", "no algebraic form"),
    ],
)
def test_what_may_be_said_of_some_events_is_not_refuted(relation: str, verdict: str, reason: str) -> None:
    answer = decide(relation)
    assert answer.verdict == verdict
    assert reason in answer.reason


def test_a_counterexample_gives_numbers_of_outcomes() -> None:
    answer = decide("P(A^c) = 1 + P(A)")
    assert answer.counterexample.keys() <= {"outcomes of A", "outcomes of A^c"}
    assert answer.letters["A"].startswith("an event")


NORMAL = r"p(x|\mu) = \frac{1}{\sqrt{2\pi\sigma^2}} e^{-(x - \mu)^2/(2\sigma^2)}"


@pytest.mark.parametrize(
    ("relation", "where", "given", "verdict"),
    [
        (r"\int_{-\infty}^{\infty} p(x|\mu)\,dx = 1", NORMAL, r"\sigma > 0", "proved"),
        (r"\frac{\partial}{\partial\mu} \ln p(x|\mu) = \frac{x - \mu}{\sigma^2}", NORMAL, r"\sigma > 0", "proved"),
        (r"\frac{\partial}{\partial\mu} \ln p(x|\mu) = \frac{\mu - x}{\sigma^2}", NORMAL, r"\sigma > 0", "refuted"),
        (
            r"\int_0^\infty x f(x;\theta)\,dx = \frac1\theta",
            r"f(x;\theta) = \theta e^{-\theta x}",
            r"\theta > 0",
            "proved",
        ),
        (r"\int_0^\infty x f(x;\theta)\,dx = \theta", r"f(x;\theta) = \theta e^{-\theta x}", r"\theta > 0", "refuted"),
        (r"p(y|x) = p(x|y)", "p(x|y) = y e^{-x}", (), "undecided"),  # the name of a density is what is in its brackets
    ],
)
def test_densities_with_parameters_are_functions(relation: str, where: str, given: str, verdict: str) -> None:
    assert decide(relation, where=where, given=given).verdict == verdict
