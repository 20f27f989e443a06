"""Powers with whole letters for exponents, of numbers of any sign and of complex numbers."""

from __future__ import annotations

import pytest

from symcheck import decide

WHOLE = r"n \in \mathbb{N}"
COMPLEX = {"z": "complex", "w": "complex"}


@pytest.mark.parametrize(
    "relation",
    [
        "(ab)^n = a^n b^n",
        "(-a)^n = (-1)^n a^n",
        "(-a)^{2n} = a^{2n}",
        r"\left(\frac{a}{b}\right)^n = \frac{a^n}{b^n}",
        "x^{n+1} - x^n = x^n(x-1)",
        r"(\cos x+i\sin x)^n = \cos nx+i\sin nx",
        r"(\cos x+i\sin x)^{-n} = \cos nx-i\sin nx",
        r"\left(r e^{ix}\right)^n = r^n e^{inx}",
        "(1+i)^{2n} = (2i)^n",
        "i^{n+2} = -i^n",
    ],
)
def test_whole_powers_are_those_of_numbers_of_any_sign(relation: str) -> None:
    assert decide(relation, given=WHOLE).verdict == "proved"


@pytest.mark.parametrize(
    "relation",
    [
        r"a^n \ge 0",
        "|a|^n = a^n",
        r"\sqrt{a^{2n}} = a^n",
        r"(\cos x+i\sin x)^n = \cos nx-i\sin nx",
        r"(\sin x+i\cos x)^n = \sin nx+i\cos nx",
        r"(\cos x+i\sin x)^{1/n} = \cos\frac{x}{n}+i\sin\frac{x}{n}",
        "(1+i)^{2n} = 2^n",
    ],
)
def test_what_is_false_of_some_whole_power_is_not_proved(relation: str) -> None:
    assert decide(relation, given=WHOLE).verdict != "proved"


def test_a_line_above_more_than_a_letter_is_the_conjugate_where_that_is_said() -> None:
    assert decide(r"\overline{zw} = \bar z\bar w", letters=COMPLEX).verdict == "proved"
    assert decide(r"\overline{z+w} = \bar z-\bar w", letters=COMPLEX).verdict == "refuted"
    assert decide(r"\overline{a+ib} = a-ib").verdict == "proved"


def test_a_line_that_may_be_a_mean_refutes_nothing_and_proves_nothing_of_products() -> None:
    assert decide(r"\overline{xy} = \bar x\bar y").verdict not in ("proved", "refuted")
    assert decide(r"\overline{a+ib} = a+ib").verdict not in ("proved", "refuted")


def test_the_argument_of_a_complex_number_has_two_usual_ranges() -> None:
    assert decide(r"\arg(1+i) = \frac{\pi}{4}").verdict == "proved"
    assert decide(r"\arg(1+i) = \frac{3\pi}{4}").verdict == "refuted"
    for value in (r"\frac{5\pi}{4}", r"-\frac{3\pi}{4}"):
        assert decide(rf"\arg(-1-i) = {value}").verdict == "ambiguous"
