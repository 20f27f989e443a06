"""Floors, ceilings and logarithms to any base: what is true is proved, what is false is refuted."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import pairwise
from math import ceil, floor

import pytest

from symcheck import decide
from symcheck.checker import check
from symcheck.question.floors import with_whole_numbers
from symcheck.question.logarithms import with_natural_logarithms
from symcheck.question.prepare import Asked

WHOLE = [r"n \in \mathbb{Z}"]
FLOORS = [  # true, false in one place, under what
    (r"\lfloor x + 1\rfloor = \lfloor x\rfloor + 1", r"\lfloor x + 1\rfloor = \lfloor x\rfloor", []),
    (r"\lfloor -x\rfloor = -\lceil x\rceil", r"\lfloor -x\rfloor = -\lfloor x\rfloor", []),
    (r"\left\lfloor \lceil x\rceil \right\rfloor = \lceil x\rceil", r"\lfloor 2x\rfloor = 2\lfloor x\rfloor", []),
    (r"\lfloor x\rfloor \le x < \lfloor x\rfloor + 1", r"\lfloor x\rfloor = x", []),
    (
        r"\lfloor x + y\rfloor \ge \lfloor x\rfloor + \lfloor y\rfloor",
        r"\lfloor x + y\rfloor \le \lfloor x\rfloor + \lfloor y\rfloor",
        [],
    ),
    (r"\lfloor x + n\rfloor = \lfloor x\rfloor + n", r"\lfloor x - n\rfloor = \lfloor x\rfloor + n", WHOLE),
    (
        r"\left\lfloor\frac{n}{2}\right\rfloor + \left\lceil\frac{n}{2}\right\rceil = n",
        r"2\left\lfloor\frac{n}{2}\right\rfloor = n",
        WHOLE,
    ),
    (r"\lceil x\rceil < x + 1", r"\lceil x\rceil > x", []),
    (r"\lceil x\rceil \le \lfloor x\rfloor + 1", r"\lceil x\rceil = \lfloor x\rfloor + 1", []),
]
LOGARITHMS = [
    (r"\log_a b = \frac{\ln b}{\ln a}", r"\log_a b = \frac{\ln a}{\ln b}"),
    (r"a^{\log_a b} = b", r"a^{\log_a b} = a"),
    (r"\log_a b = -\log_{1/a} b", r"\log_a b = \log_{1/a} b"),
    (r"\log_{a^2} b = \frac{1}{2}\log_a b", r"\log_{a^2} b = 2\log_a b"),
    (r"\log_a b \log_b c = \log_a c", r"\log_a b \log_b c = \log_c a"),
    (r"\log_a(bc) = \log_a b + \log_a c", r"\log_a(b + c) = \log_a b + \log_a c"),
    (
        r"\log_a\left(\frac{b}{c}\right) = \log_a b - \log_a c",
        r"\log_a\left(\frac{b}{c}\right) = \frac{\log_a b}{\log_a c}",
    ),
]
POSITIVE = ["a > 0", r"a \ne 1", "b > 0", r"b \ne 1", "c > 0", r"c \ne 1"]


@pytest.mark.parametrize(("true", "false", "given"), FLOORS)
def test_floors_and_ceilings_are_decided(true: str, false: str, given: list[str]) -> None:
    proved, refuted = decide(true, given=given), decide(false, given=given)
    assert (proved.verdict, refuted.verdict) == ("proved", "refuted")
    assert all(check(made) is None for made in (*proved.certificate, *refuted.certificate))
    assert {*refuted.counterexample} <= {"x", "y", "n"}


@pytest.mark.parametrize(
    ("relation", "given"),
    [
        (r"\lfloor x\rfloor = 3", []),  # to be solved
        (r"\lceil x\rceil - \lfloor x\rfloor = 1", []),
        (r"\lfloor 2x\rfloor = \lfloor x\rfloor + \lfloor x + \frac12\rfloor", []),  # true, but not by one step
        (r"\lfloor x + n\rfloor = \lfloor x\rfloor + n", []),  # true if n is whole, of which nothing is said
        (r"\sum_{k=1}^n \lfloor k x\rfloor = n x", []),
        (r"\frac{d}{dx} \lfloor x\rfloor = 0", []),
        (r"\arctan x = \arctan\frac{p}{q} + \arctan w, \quad p = \lfloor qx \rfloor", []),  # it says what p is
    ],
)
def test_what_is_not_known_of_floors_is_not_decided(relation: str, given: list[str]) -> None:
    assert decide(relation, given=given).verdict not in ("proved", "refuted")


def test_the_values_of_floors_are_those_of_the_standard_library() -> None:
    rng = random.Random(5)
    for _ in range(20):
        x = Fraction(rng.randint(-20, 20), rng.randint(4, 9))
        number = rf"\frac{{{x.numerator}}}{{{x.denominator}}}"
        assert decide(rf"\lfloor{number}\rfloor = {floor(x)}").verdict == "proved"
        assert decide(rf"\lceil{number}\rceil = {ceil(x)}").verdict == "proved"
        assert decide(rf"\lfloor{number}\rfloor = {floor(x) + rng.choice([-1, 1])}").verdict == "refuted"


def test_each_floor_has_a_letter_of_its_own_and_bound_letters_none() -> None:
    found = with_whole_numbers(
        Asked(r"\lfloor F + \lceil x\rceil\rfloor = \lfloor x\rfloor + \lceil x\rceil", (), (), ())
    )
    assert found is not None
    assert [*found.stand.values()] == [r"\lceil x \rceil", r"\lfloor x \rfloor", r"\lfloor F + \lceil x \rceil \rfloor"]
    assert "F" not in found.stand
    assert all(one != other for one, other in pairwise(sorted(found.stand)))
    assert with_whole_numbers(Asked(r"\int_0^1 \lfloor x\rfloor\,dx = 0", (), (), ())) is None


@pytest.mark.parametrize(("true", "false"), LOGARITHMS)
def test_logarithms_to_any_base_are_decided(true: str, false: str) -> None:
    assert (decide(true, given=POSITIVE).verdict, decide(false, given=POSITIVE).verdict) == ("proved", "refuted")


@pytest.mark.parametrize(
    "latex", [r"\log_a xy", r"\log_a x y + 1", r"\log_a(x)^2", r"\log_a^2 x", r"\log_2 x", r"\log x"]
)
def test_an_argument_of_a_logarithm_that_is_open_is_left(latex: str) -> None:
    assert with_natural_logarithms(latex) == latex
