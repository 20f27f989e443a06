"""Expectations, variances and covariances."""

from __future__ import annotations

import pytest

from symcheck import decide

MEAN = r"\mu = \mathbb{E}[X]"
CORRELATION = r"\rho = \frac{\operatorname{Cov}(X, Y)}{\sqrt{\operatorname{Var}(X) \operatorname{Var}(Y)}}"
SPREAD = (r"\operatorname{Var}(X) = \sigma^2", r"E[X] = \mu")


@pytest.mark.parametrize(
    ("relation", "where", "verdict"),
    [
        (r"\operatorname{Var}(X) = E[X^2] - (E[X])^2", (), "proved"),
        (r"\operatorname{Var}(X) = E[X^2] + (E[X])^2", (), "refuted"),
        (r"\operatorname{Var}(aX + b) = a^2 \operatorname{Var}(X)", (), "proved"),
        (r"\operatorname{Var}(aX + b) = a \operatorname{Var}(X)", (), "refuted"),
        (r"\mathrm{Cov}(X, Y) = E[XY] - E[X] E[Y]", (), "proved"),
        (r"\mathrm{Var}(X + Y) = \mathrm{Var}(X) + \mathrm{Var}(Y) + 2 \mathrm{Cov}(X, Y)", (), "proved"),
        (r"\mathrm{Var}(X + Y) = \mathrm{Var}(X) + \mathrm{Var}(Y) - 2 \mathrm{Cov}(X, Y)", (), "refuted"),
        (r"\mathbb{E}[(X - \mu)^2] = \mathbb{E}[X^2] - \mu^2", MEAN, "proved"),
        (r"\mathbb{E}[(X - \mu)^2] = \mathbb{E}[X^2] + \mu^2", MEAN, "refuted"),
        (r"E[X^2] = \sigma^2 + \mu^2", SPREAD, "proved"),
        (r"\mathbb{E}[X^2] \ge \mathbb{E}[X]^2", (), "proved"),
        (r"E[aX + bY] = a E[X] - b E[Y]", (), "refuted"),
        (r"(\operatorname{Cov}(X, Y))^2 \le \operatorname{Var}(X) \operatorname{Var}(Y)", (), "proved"),
        (r"2 E[XY]^2 \le E[X^2] E[Y^2]", (), "refuted"),
        (r"\rho^2 \le 1", CORRELATION, "proved"),
        (r"\operatorname{Var}(X/n) = \frac{\operatorname{Var}(X)}{n}", (), "refuted"),
    ],
)
def test_laws_of_expectations_are_decided(relation: str, where: str, verdict: str) -> None:
    assert decide(relation, where=where).verdict == verdict


@pytest.mark.parametrize(
    ("relation", "verdict", "reason"),
    [
        (r"E[XY] = E[X] E[Y]", "ambiguous", "independent"),
        (r"\operatorname{Var}(X + Y) = \operatorname{Var}(X) + \operatorname{Var}(Y)", "ambiguous", "independent"),
        (r"\operatorname{Var}(X) = E[X^2]", "ambiguous", "means are 0"),
        (r"E[X^2] = \sigma^2 + \mu^2", "undecided", "an equation or a condition"),
        (
            r"\operatorname{Var}(AX) = A^2 \operatorname{Var}(X)",
            "undecided",
            "no algebraic form",
        ),  # which of them varies?
        (r"\operatorname{Var}(e^X) = 0", "undecided", "no algebraic form"),
        (r"E(x) = x^2 - 2x", "undecided", "definition"),
        (r"E[n + 1] = E[n] + 1", "undecided", "or times it?"),  # of a sequence
    ],
)
def test_what_may_be_said_of_some_variables_is_not_refuted(relation: str, verdict: str, reason: str) -> None:
    answer = decide(relation)
    assert answer.verdict == verdict
    assert reason in answer.reason
