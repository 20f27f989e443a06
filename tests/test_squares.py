"""Orders of polynomials and roots are proved by sums of squares, and by the squares of both sides."""

from __future__ import annotations

from itertools import product

import pytest

from symcheck import decide
from symcheck.question.prepare import Asked, plainly, readings
from symcheck.question.squares import squared, with_form

POSITIVE = "a > 0, b > 0, c > 0"
COMPONENTS = "a_1^2+a_2^2+a_3^2", "b_1^2+b_2^2+b_3^2"
ORDERS = [
    (rf"(a_1b_1+a_2b_2+a_3b_3)^2 \le ({COMPONENTS[0]})({COMPONENTS[1]})", ""),
    (rf"|a_1b_1+a_2b_2+a_3b_3| \le \sqrt{{{COMPONENTS[0]}}}\sqrt{{{COMPONENTS[1]}}}", ""),
    (r"\|\mathbf{a}+\mathbf{b}\| \le \|\mathbf{a}\|+\|\mathbf{b}\|", ""),
    (r"\frac{2}{\frac{1}{a}+\frac{1}{b}} \le \sqrt{ab}", POSITIVE),
    (r"\frac{2ab}{a+b} \le \sqrt{ab} \le \frac{a+b}{2} \le \sqrt{\frac{a^2+b^2}{2}}", POSITIVE),
    (r"\sqrt{a+b} \le \sqrt{a}+\sqrt{b}", r"a \ge 0, b \ge 0"),
    (r"\sqrt{a^2+b^2} \le |a|+|b|", ""),
    (r"|a|+|b| \le \sqrt{2}\sqrt{a^2+b^2}", ""),
    (r"|\sqrt{a}-\sqrt{b}| \le \sqrt{|a-b|}", r"a \ge 0, b \ge 0"),
    (r"(a+b)(b+c)(c+a) \ge 8abc", POSITIVE),
    (r"\frac{a}{b+c}+\frac{b}{c+a}+\frac{c}{a+b} \ge \frac{3}{2}", POSITIVE),
    (r"a^4+b^4+c^4 \ge abc(a+b+c)", ""),
    (r"\sqrt{a^2+b^2}+\sqrt{c^2+d^2} \ge \sqrt{(a+c)^2+(b+d)^2}", ""),
]


@pytest.mark.parametrize(("relation", "given"), ORDERS)
def test_orders_are_proved_and_their_contraries_are_not(relation: str, given: str) -> None:
    assert decide(relation, given=given).verdict == "proved"
    sign, contrary = (r"\le ", r"\ge ") if r"\le " in relation else (r"\ge ", r"\le ")
    assert decide(relation.replace(sign, contrary), given=given).verdict != "proved"
    strict = "<" if sign == r"\le " else ">"
    assert decide(relation.replace(sign, strict), given=given).verdict != "proved"  # both sides are equal somewhere


@pytest.mark.parametrize(
    ("relation", "given"),
    [
        (r"\frac{a+b}{2} \ge \sqrt{ab}", r"ab \ge 0"),  # both may be negative
        (r"a^3+b^3 \ge a^2b+ab^2", ""),
        (r"(a+b)(b+c)(c+a) \ge 9abc", POSITIVE),
        (r"\sqrt{a}+\sqrt{b} \le \sqrt{a+b}", r"a \ge 0, b \ge 0"),
        (r"a-b \le \sqrt{a^2-b^2}", r"a \ge b"),
        (r"a \le \sqrt{a}", r"a \ge 0"),
        (r"(a-b)^2 > 0", ""),  # it is 0 somewhere
        (r"|a+b| < |a|+|b|", ""),
    ],
)
def test_orders_that_fail_somewhere_are_not_proved(relation: str, given: str) -> None:
    assert decide(relation, given=given).verdict != "proved"


def test_no_sum_of_squares_and_no_squaring_is_found_for_orders_that_fail_somewhere() -> None:
    for k, m, n in product(range(-2, 3), repeat=3):
        relation = rf"a^2+{k + 2}ab+{m + 2}b^2+{n + 2} \ge {2 - n}"
        (problem,) = readings(plainly(Asked(relation)))[0].problems
        least = min(x * x + (k + 2) * x * y + (m + 2) * y * y + 2 * n for x in range(-9, 10) for y in range(-9, 10))
        if least < 0:
            assert with_form(problem) is None
            assert squared(problem) is None


@pytest.mark.parametrize(
    "relation",
    [
        r"|a+b| \le |a|+|b|, \quad |a/b| \le |a|/c",
        r"\left|\frac{1}{\sqrt{x+a}} - \frac{1}{\sqrt{x}}\right| \le \frac{|a|}{2(x-|a|)^{3/2}}",
        r"\left|\frac{1}{b+k}\right| \le \frac{1}{|b+n|}",
    ],
)
def test_what_squaring_does_not_show_is_an_answer_with_a_reason(relation: str) -> None:
    answer = decide(relation)
    assert answer.verdict == "undecided"
    assert "internal" not in answer.reason
