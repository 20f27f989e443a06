"""Derivatives whose order is a letter are decided by induction over the order."""

from __future__ import annotations

import pytest

from symcheck import decide

WHOLE = r"n \in \mathbb{N}"


@pytest.mark.parametrize(
    ("relation", "given", "verdict"),
    [
        (r"\frac{d^n}{dx^n}e^{ax} = a^n e^{ax}", WHOLE, "proved"),  # for negative numbers a too
        (r"\frac{d^n}{dx^n}e^{ax} = n a e^{ax}", WHOLE, "refuted"),
        (r"\frac{d^n}{dx^n}x^n = n!", "", "proved"),
        (r"\frac{d^n}{dx^n}(ax+b)^n = a^n n!", WHOLE, "proved"),
        (r"\frac{d^n}{dx^n}(ax+b)^n = a n!", WHOLE, "refuted"),
        (r"\frac{d^{2n+1}}{dx^{2n+1}}\cos x = (-1)^{n+1}\sin x", WHOLE, "proved"),
        (r"\frac{d^{2n+1}}{dx^{2n+1}}\cos x = (-1)^n\sin x", WHOLE, "refuted"),
        (r"\frac{d^n}{dx^n}x^2 = 0", r"n \ge 3", "proved"),
        (r"\frac{d^n}{dx^n}x^3 = 0", r"n \ge 3", "refuted"),
    ],
)
def test_derivatives_of_all_orders_are_decided(relation: str, given: str, verdict: str) -> None:
    assert decide(relation, given=given).verdict == verdict


def test_what_is_differentiated_may_be_said_beside_it() -> None:
    where = r"f(x) = \frac{1}{x}"
    assert decide(r"f^{(n)}(x) = \frac{(-1)^n n!}{x^{n+1}}", where, "x > 0").verdict == "proved"
    assert decide(r"f^{(n)}(x) = \frac{(-1)^n n!}{x^n}", where, "x > 0").verdict == "refuted"


def test_a_claim_that_has_no_value_at_the_first_order_holds_of_those_above_it_or_is_in_doubt() -> None:
    claim = r"\frac{d^n}{dx^n}\ln x = \frac{(-1)^{n-1}(n-1)!}{x^n}"
    assert decide(claim, given="x > 0").verdict == "proved"  # of orders from 1 on
    assert decide(claim, given=("x > 0", WHOLE)).verdict == "ambiguous"
    assert decide(claim, given=("x > 0", WHOLE, r"n \ge 1")).verdict == "proved"


@pytest.mark.parametrize(
    ("relation", "given"),
    [
        (r"\frac{d^n}{dx^n}f(x) = 0", WHOLE),  # a condition on f
        (r"\frac{d^n y}{dx^n} = n y", WHOLE),
        (r"\frac{d^n}{dx^n}x^2 = 0", "x = 0"),  # where a value alone is known, no derivative is
    ],
)
def test_no_verdict_is_given_on_what_is_no_claim_about_a_known_function(relation: str, given: str) -> None:
    assert decide(relation, given=given).verdict not in ("proved", "refuted")
