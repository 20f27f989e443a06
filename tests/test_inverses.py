"""What is given of an exponential says what its exponent is."""

from __future__ import annotations

import pytest

from symcheck import decide

POSITIVE = ("k > 0", "N > 0", "v > 0", "a > 0", "b > 0")
PAIRS = (
    (r"t = \ln 2", r"t = \ln 3", r"e^t = 2"),
    (r"t = \frac{\ln 2}{k}", r"t = \frac{2}{k}", r"e^{-kt} = \frac12"),
    (r"t = \frac{\ln 2}{k}", r"t = \frac{\ln 3}{k}", r"N e^{-kt} = \frac{N}{2}"),
    (r"t = -\frac{\ln y}{k}", r"t = \frac{\ln y}{k}", r"e^{-kt} = y"),
    (r"w = v \ln\frac{b}{a}", r"w = v \ln\frac{a}{b}", r"e^{-w/v} = \frac{a}{b}"),
)


@pytest.mark.parametrize(("true", "false", "given"), PAIRS)
def test_the_exponent_is_the_logarithm_of_what_is_given(true: str, false: str, given: str) -> None:
    used = tuple(each for each in POSITIVE if each[0] in true + given)
    assert decide(true, given=(given, *used)).verdict == "proved"
    assert decide(false, given=(given, *used)).verdict == "refuted"


def test_what_no_number_satisfies_is_not_proved() -> None:
    assert decide(r"t = \ln 2", given=(r"e^t = -2",)).verdict not in ("proved", "refuted")
    assert decide(r"t = \ln(-y)", given=(r"e^t = -y", "y > 0")).verdict not in ("proved", "refuted")


def test_an_implication_between_functions_at_one_place_is_an_answer() -> None:
    answer = decide(r"C(t) = \frac{D}{V} e^{-kt} \Rightarrow \frac{dC}{dt} = -k C")
    assert answer.verdict == "undecided"
    assert "internal" not in answer.reason
