"""Positive numbers in polar form have the angle 0 where it is between -2 pi and 2 pi: exponents of complex numbers."""

from __future__ import annotations

import pytest

from symcheck import decide
from symcheck.core.problems import Problem
from symcheck.core.terms import node
from symcheck.question.principal import in_general, in_turn

TURN = r"-\pi < \alpha \le \pi"
NOME = (r"w = e^{i\sigma}", r"w = e^{-b/a}")
STRIP = ("a > 0", r"-\pi < \operatorname{Re} \sigma \le \pi")
SIGMA = {r"\sigma": "complex"}


@pytest.mark.parametrize(
    ("relation", "where", "given", "letters"),
    [
        (r"\alpha = 0", r"e^{i\alpha} = 1", TURN, {}),
        (r"\sigma = i \frac{b}{a}", NOME, STRIP, SIGMA),
    ],
)
def test_an_exponent_is_told_by_the_exponential_within_a_turn(
    relation: str, where: tuple[str, ...], given: tuple[str, ...], letters: dict[str, str]
) -> None:
    answer = decide(relation, where, given, letters)
    assert answer.verdict == "proved", answer.reason


@pytest.mark.parametrize(
    ("relation", "where", "given", "letters"),
    [
        (r"\alpha = \pi", r"e^{i\alpha} = 1", TURN, {}),
        (r"\alpha = 0", r"e^{i\alpha} = 1", r"-3\pi < \alpha \le 3\pi", {}),  # or a whole turn
        (r"\alpha = 0", r"e^{i\alpha} = -1", TURN, {}),
        (r"\sigma = -i \frac{b}{a}", NOME, STRIP, SIGMA),
        (r"\sigma = i \frac{b}{a}", NOME, "a > 0", SIGMA),  # of the angle nothing is said
    ],
)
def test_another_exponent_is_not_proved(
    relation: str, where: tuple[str, ...], given: tuple[str, ...], letters: dict[str, str]
) -> None:
    assert decide(relation, where, given, letters).verdict != "proved"


def test_a_letter_below_one_is_not_asked_to_be_whole() -> None:
    assert decide(r"\sqrt{1 - m} = 1 - m", (), "0 < m < 1").verdict == "refuted"
    assert decide(r"\sqrt{2 - m} = m^2", (), "0 < m < 2").verdict != "proved"


def test_a_letter_stands_for_an_integral_only_where_nothing_in_it_is_bound_elsewhere() -> None:
    inner = node("integral", node("*", "x", "t"), "t", 0, 1)
    free, under = (Problem("p", node("=", each, "y")) for each in (inner, node("diff", inner, "x", 1, "x")))
    assert isinstance(in_general(free).claim[1], str)
    assert in_general(under).claim == under.claim


def test_equations_for_one_letter_are_not_lost() -> None:
    said = [node("=", "x", 0), node("=", "x", "w"), node("=", "y", node("*", 2, "x"))]
    known, rest = in_turn(said)
    assert known == {"x": 0, "y": node("*", 2, 0)}
    assert rest == (node("=", 0, "w"),)
