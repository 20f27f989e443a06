"""Generating functions of families of polynomials."""

from __future__ import annotations

import pytest

from symcheck import decide

INSIDE = r"|t| < 1, |x| \le 1"


@pytest.mark.parametrize(
    ("letter", "name", "true", "false", "given"),
    [
        (
            "P_n",
            "Legendre polynomial",
            r"P_n(x)t^n = \frac{1}{\sqrt{1-2xt+t^2}}",
            r"P_n(x)t^n = \frac{1}{\sqrt{1+2xt+t^2}}",
            INSIDE,
        ),
        (
            "P_n",
            "Legendre polynomial",
            r"(-1)^n P_n(x)t^n = \frac{1}{\sqrt{1+2xt+t^2}}",
            r"P_n(x)t^n = \frac{1}{1-2xt+t^2}",
            INSIDE,
        ),
        (
            "P_n",
            "Legendre polynomial",
            r"(n+1)P_n(x)t^n = \frac{1-xt}{(1-2xt+t^2)^{3/2}}",
            r"(n+1)P_n(x)t^n = \frac{1+xt}{(1-2xt+t^2)^{3/2}}",
            INSIDE,
        ),
        (
            "H_n",
            "Hermite polynomial",
            r"H_n(x)\frac{t^n}{n!} = e^{2xt-t^2}",
            r"H_n(x)\frac{t^n}{n!} = e^{xt-t^2}",
            "",
        ),
        (
            "He_n",
            "probabilist's Hermite polynomial",
            r"He_n(x)\frac{t^n}{n!} = e^{xt-t^2/2}",
            r"He_n(x)\frac{t^n}{n!} = e^{xt-t^2}",
            "",
        ),
        (
            "L_n",
            "Laguerre polynomial",
            r"L_n(x)t^n = \frac{1}{1-t}e^{-\frac{xt}{1-t}}",
            r"L_n(x)t^n = \frac{1}{1-t}e^{\frac{xt}{1-t}}",
            "|t| < 1",
        ),
        (
            "T_n",
            "Chebyshev polynomial of the first kind",
            r"T_n(x)t^n = \frac{1-xt}{1-2xt+t^2}",
            r"T_n(x)t^n = \frac{1+xt}{1-2xt+t^2}",
            INSIDE,
        ),
        (
            "U_n",
            "Chebyshev polynomial of the second kind",
            r"U_n(x)t^n = \frac{1}{1-2xt+t^2}",
            r"U_n(x)t^n = \frac{1}{1-xt+t^2}",
            INSIDE,
        ),
    ],
)
def test_generating_functions_are_decided(letter: str, name: str, true: str, false: str, given: str) -> None:
    total = r"\sum_{n=0}^{\infty} "
    assert decide(total + true, given=given, letters={letter: name}).verdict == "proved"
    assert decide(total + false, given=given, letters={letter: name}).verdict == "refuted"
    if letter != "He_n":  # the others are known by their letters, but may mean something else where the claim is false
        assert decide(total + true, given=given).verdict == "proved"
        assert decide(total + false, given=given).verdict == "ambiguous"


@pytest.mark.parametrize("given", ["", r"|t| < 2, |x| \le 1", "|t| < 1"])
def test_a_sum_that_may_not_converge_has_no_value(given: str) -> None:
    claim = r"\sum_{n=0}^{\infty} P_n(x)t^n = \frac{1}{\sqrt{1-2xt+t^2}}"
    assert decide(claim, given=given).verdict == "undecided"


def test_a_root_of_a_square_is_not_continued_beyond_its_zero() -> None:
    claim = r"\sum_{n=0}^{\infty} T_n(x)t^n = \frac{(1-xt)\sqrt{(1-2t)^2}}{(1-2t)(1-2xt+t^2)}"
    assert decide(claim, given=INSIDE).verdict != "proved"
