"""Functions that have names: the beta function and the zeta function, where nothing else is meant by their letters."""

from __future__ import annotations

import pytest

from symcheck import decide
from symcheck.question.named import written_out
from symcheck.question.prepare import Asked

STEP, SLIP = r"B(x+1,y) = \frac{x}{x+y} B(x,y)", r"B(x+1,y) = \frac{y}{x+y} B(x,y)"
POSITIVE = "x > 0, y > 0"


def test_what_is_so_of_the_beta_function_is_proved_under_its_usual_letter() -> None:
    answer = decide(STEP, given=POSITIVE)
    assert answer.verdict == "proved"
    assert answer.letters["B"] == "the beta function (its usual letter)"


@pytest.mark.parametrize(
    ("relation", "letters"),
    [(SLIP, {"B": "beta function"}), (SLIP, {"B": "the beta function"}), (SLIP.replace("B", r"\mathrm{B}"), {})],
)
def test_what_is_false_of_the_beta_function_is_refuted_if_it_is_meant(relation: str, letters: dict[str, str]) -> None:
    assert decide(relation, given=POSITIVE, letters=letters).verdict == "refuted"


def test_another_function_may_be_meant_by_the_letter() -> None:
    assert decide(SLIP, given=POSITIVE).verdict == "undecided"
    assert decide("B(x,y) = -B(y,x)", where="B(x,y) = x - y").verdict == "proved"
    assert decide(r"\zeta(2) = 2", where=r"\zeta(t) = t").verdict == "proved"


@pytest.mark.parametrize(
    "relation",
    ["F = B I L", "B(x) = B_0", "B(x,y) = B_0 y", "B(x,y,z) = x", r"\zeta = 2", r"\zeta(s) = x", r"\zeta(1) = 2"],
)
def test_letters_without_such_arguments_are_left_alone(relation: str) -> None:
    assert written_out(Asked(relation), {}) is None


def test_a_letter_that_is_declared_is_left_alone() -> None:
    assert written_out(Asked("B(x,y) = B(y,x)", letters=(("B", "function of x"),)), {}) is None


def test_one_function_may_stand_in_another() -> None:
    assert decide(r"B(\zeta(2), 1) = \frac{6}{\pi^2}").verdict == "proved"


@pytest.mark.parametrize(
    ("relation", "verdict"),
    [
        (r"\zeta(2) = \frac{\pi^2}{6}", "proved"), (r"\zeta(2) = \frac{\pi^2}{8}", "refuted"),
        (r"\zeta(4) = \frac{2}{5} \zeta(2)^2", "proved"), (r"\zeta(4) = \frac{2}{3} \zeta(2)^2", "refuted"),
    ],
)  # fmt: skip
def test_values_of_the_zeta_function(relation: str, verdict: str) -> None:
    assert decide(relation).verdict == verdict


def test_mean_and_variance_of_a_beta_density() -> None:
    density = r"f(x) = \frac{x^{a-1} (1-x)^{b-1}}{B(a,b)}"
    mean = r"\int_0^1 x f(x) dx = \frac{a}{a+b}"
    assert decide(mean, where=density, given="a > 0, b > 0").verdict == "proved"
    letters = {"B": "beta function"}
    false = mean.replace(r"{a}{", "{b}{")
    assert decide(false, where=density, given="a > 0, b > 0", letters=letters).verdict == "refuted"
