"""Inequalities between functions, by the growth of the difference of their sides."""

from __future__ import annotations

import pytest

from symcheck import decide

TRUE = (
    (r"e^x \ge 1 + x", ()),
    (r"e^x \ge e x", ()),
    (r"e^{-x} \ge 1 - x", ()),
    (r"\ln(1+x) \le x", ("x > -1",)),
    (r"1 - \frac{1}{x} \le \ln x \le x - 1", ("x > 0",)),
    (r"\ln x < x", ("x > 0",)),
    (r"\sin x \ge x - \frac{x^3}{6}", (r"x \ge 0",)),
    (r"\cos x \ge 1 - \frac{x^2}{2}", ()),
    (r"\tan x \ge x", (r"0 \le x", r"x < \pi/2")),
    (r"\arctan x \le x", (r"x \ge 0",)),
    (r"\tanh x \le x", (r"x \ge 0",)),
    (r"\cosh x \ge 1 + \frac{x^2}{2}", ()),
)
FALSE = (
    (r"e^x > 1 + x", ()),
    (r"e^x \ge 1 + x + \frac{x^2}{2}", ()),
    (r"\ln(1+x) \le \frac{x}{2}", ("x > -1",)),
    (r"\sin x \ge x", (r"x \ge 0",)),
    (r"\sin x \le x", ()),
    (r"\tan x \ge x", (r"0 \le x",)),
    (r"\arctan x \le x", ()),
    (r"\cos x \ge 1 - \frac{x^2}{3}", ()),
    (r"\frac{1}{x} \ge 2 - x", ()),
)


@pytest.mark.parametrize(("relation", "given"), TRUE, ids=[relation for relation, _ in TRUE])
def test_an_order_is_proved_by_how_the_difference_grows(relation: str, given: tuple[str, ...]) -> None:
    assert decide(relation, given=given).verdict == "proved"


@pytest.mark.parametrize(("relation", "given"), FALSE, ids=[relation for relation, _ in FALSE])
def test_an_order_that_fails_somewhere_is_not_proved(relation: str, given: tuple[str, ...]) -> None:
    assert decide(relation, given=given).verdict != "proved"
