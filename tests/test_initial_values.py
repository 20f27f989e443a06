"""Transformations of hypergeometric functions: what solves the same equation with the same value at zero is equal."""

from __future__ import annotations

import mpmath
import pytest
from sampling import every

from symcheck import decide
from symcheck.core.calculus import substituted
from symcheck.core.terms import Term, node
from symcheck.question.power_series import VALUES
from symcheck.question.special import term_of

F, G = "{}_2F_1", "{}_1F_1"
PAIRS = [  # true, with a slip, where; with numbers in DLMF
    (rf"{G}(a;b;z) = e^z {G}(b-a;b;-z)", rf"{G}(a;b;z) = e^z {G}(b-a;b;z)", ""),  # 13.2.39
    (rf"{G}(a;b;z) = e^z {G}(b-a;b;-z)", rf"{G}(a;b;z) = e^{{-z}} {G}(b-a;b;-z)", "a > 0, b > 0"),
    (
        rf"{F}(a,b;c;z) = (1-z)^{{c-a-b}}{F}(c-a,c-b;c;z)",  # 15.8.1
        rf"{F}(a,b;c;z) = (1-z)^{{a+b-c}}{F}(c-a,c-b;c;z)",
        "|z| < 1",
    ),
    (
        rf"{F}(a,b;c;z) = (1-z)^{{-a}}{F}\left(a,c-b;c;\frac{{z}}{{z-1}}\right)",  # 15.8.1
        rf"{F}(a,b;c;z) = (1-z)^{{-a}}{F}\left(a,b;c;\frac{{z}}{{z-1}}\right)",
        "-1 < z < 1/2",
    ),
    (
        rf"{F}\left(\frac12,\frac12;\frac32;z^2\right) = \frac{{\arcsin z}}{{z}}",  # 15.4.4
        rf"{F}\left(\frac12,\frac12;\frac32;z^2\right) = \frac{{\arcsin z}}{{2z}}",
        "0 < z < 1",
    ),
    (rf"{F}(1,1;2;-z) = \frac{{\ln(1+z)}}{{z}}", "", "z > -1"),  # 15.4.1
    (rf"{F}(a,b;c;1) = \frac{{\Gamma(c)\Gamma(c-a-b)}}{{\Gamma(c-a)\Gamma(c-b)}}", "", ""),  # 15.4.20
    (
        rf"{F}(a,b;a-b+1;-1) = \frac{{\Gamma(a-b+1)\Gamma(\frac a2+1)}}{{\Gamma(a+1)\Gamma(\frac a2-b+1)}}",  # 15.4.26
        rf"{F}(a,b;a-b+1;-1) = \frac{{\Gamma(a-b+1)\Gamma(\frac a2+1)}}{{\Gamma(a)\Gamma(\frac a2-b+1)}}",
        "",
    ),
]


@pytest.mark.parametrize("case", every(3, PAIRS), ids=lambda case: case[0])
def test_a_transformation_is_proved_and_its_slip_is_not(case: tuple[str, str, str]) -> None:
    right, wrong, given = case
    answer = decide(right, given=given)
    assert (answer.verdict, answer.reason) == ("proved", "")
    assert not wrong or decide(wrong, given=given).verdict in ("refuted", "undecided")


@pytest.mark.parametrize(
    ("relation", "given"),
    [
        (rf"{G}(a;b;z) = z^{{1-b}} {G}(a-b+1;2-b;z)", "z > 0"),  # the other solution, which is not analytic at 0
        (rf"{G}(a;b;z) = 2 e^z {G}(b-a;b;-z)", "z > 0"),  # another value at 0
        (rf"{F}\left(\frac12,\frac12;\frac32;z^2\right) = \frac{{\arcsin z}}{{\sqrt{{z^2}}}}", ""),  # not where z < 0
        (  # for z > 1 the argument on the left is below 1, and the left side another branch
            rf"{F}\left(\frac12,\frac12;1;\frac{{4z}}{{(1+z)^2}}\right) = (1+z){F}\left(\frac12,\frac12;1;z^2\right)",
            "z > 1",
        ),
        (rf"{G}(1;-2;z) = e^z {G}(-3;-2;-z)", ""),  # the parameter below is a pole
        (rf"{F}(a,b;c;1) = \frac{{\Gamma(c)\Gamma(c-a-b)}}{{\Gamma(c-a)}}\Gamma(c-b)", ""),
        (rf"{F}(a,b;c;1) = {F}(a,b;c;1) + c - a - b", ""),
    ],
)
def test_what_is_no_transformation_is_not_proved(relation: str, given: str) -> None:
    assert decide(relation, given=given).verdict != "proved"


@pytest.mark.parametrize("letters", [{"M": "Kummer function"}, {}])
def test_m_of_three_arguments_is_kummers_function(letters: dict[str, str]) -> None:
    assert decide("M(a,b,z) = e^z M(b-a,b,-z)", letters=letters).verdict == "proved"
    wrong = decide("M(a,b,z) = e^{-z} M(b-a,b,-z)", letters=letters).verdict
    assert (wrong == "refuted") == bool(letters)


def value(term: Term) -> mpmath.mpf:
    """The value of a term without letters."""
    if isinstance(term, int):
        return mpmath.mpf(term)
    assert not isinstance(term, str)
    parts = [value(part) for part in term.outside]
    match term.tag:
        case "+":
            return mpmath.fsum(parts)
        case "-":
            return -parts[0]
        case "*":
            return mpmath.fprod(parts)
        case "/":
            return parts[0] / parts[1]
        case "pi":
            return mpmath.pi
    return getattr(mpmath, term.tag)(*parts)


@pytest.mark.parametrize("known", VALUES, ids=lambda known: known.below)
def test_a_value_at_a_number_is_right(known: object) -> None:
    a, b = node("/", 1, 3), node("/", 2, 7)
    below = substituted(term_of(known.below), {"a": a, "b": b, "c": node("/", 9, 4)})  # type: ignore[attr-defined]
    claimed = substituted(term_of(known.value), {"a": a, "b": b, "c": below})  # type: ignore[attr-defined]
    at = mpmath.mpf(known.at.numerator) / known.at.denominator  # type: ignore[attr-defined]
    assert abs(mpmath.hyp2f1(value(a), value(b), value(below), at) - value(claimed)) < 1e-12
