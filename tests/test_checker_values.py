"""What the checker takes the values of terms to be, and where they have none."""

from __future__ import annotations

from typing import Any

import pytest

from symcheck.checker import check
from symcheck.core.calculus import domain
from symcheck.core.terms import Reader

NO_POINT = "no point where all that is assumed holds"


def proved(claim: Any, **more: Any) -> str | None:
    proof = {"rule": "identity"}
    return check({"id": "a", "verdict": "proved", "hypotheses": {}, "claim": claim, "proof": proof, **more})


def at(**values: Any) -> list[dict[str, Any]]:
    return [{"values": values}]


@pytest.mark.parametrize("n", range(-5, 6))
def test_multiples_of_an_angle_follow_the_addition_theorem(n: int) -> None:
    cosines = [1, ["cos", "x"]]
    while len(cosines) <= abs(n):  # cos(n x) = 2 cos x cos((n - 1) x) - cos((n - 2) x)
        cosines.append(["+", ["*", 2, ["cos", "x"], cosines[-1]], ["-", cosines[-2]]])
    assert proved(["=", ["cos", ["*", n, "x"]], cosines[abs(n)]]) is None
    assert proved(["=", ["cos", ["*", n, "x"]], ["+", 1, cosines[abs(n)]]]) is not None


@pytest.mark.parametrize("sign", [1, -1])
def test_a_difference_of_angles_is_no_sum(sign: int) -> None:
    products = [["*", ["cos", "x"], ["cos", "y"]], ["*", sign, ["sin", "x"], ["sin", "y"]]]
    right = proved(["=", ["cos", ["+", "x", ["-", "y"]]], ["+", *products]]) is None
    assert right == (sign == 1)


@pytest.mark.parametrize(
    ("term", "here", "elsewhere"),
    [
        (["sqrt", "x"], 4, -1),
        (["log", "x"], 1, 0),
        (["gamma", "x"], 2, -1),
        (["pow", "x", "y"], 2, -2),
        (["arcsin", "x"], ["/", 1, 2], 2),
        (["arccos", "x"], -1, -2),
    ],
)
def test_a_claim_needs_a_point_where_its_terms_have_values(term: Any, here: Any, elsewhere: Any) -> None:
    assert proved(["=", term, term]) == NO_POINT
    assert proved(["=", term, term], witnesses=at(x=here)) is None
    assert "is not so" in str(proved(["=", term, term], witnesses=at(x=elsewhere)))


def test_a_claim_about_values_that_are_nowhere_is_not_proved() -> None:
    nowhere = ["sqrt", ["+", -1, ["-", ["^", "x", 2]]]]
    assert "is not so" in str(proved(["=", nowhere, nowhere], witnesses=at(x=0)))
    assert "is not so" in str(proved(["=", ["log", ["-", 3]], ["log", -3]]))


def test_numbers_that_have_values_need_no_point() -> None:
    assert proved(["=", ["^", ["sqrt", 3], 2], 3]) is None
    assert proved(["=", ["log", ["sqrt", 3]], ["log", ["sqrt", 3]]]) is None


def test_of_what_stands_under_a_binder_nothing_is_asked() -> None:
    formula = Reader().formula(["=", ["integral", ["sqrt", "x"], "x", ["sqrt", "y"], 1], ["/", 1, "z"]])
    assert [*map(str, domain(formula))] == ["('>=', 'y', 0)"]
    assert len(domain(formula, divisors=True)) == 2
