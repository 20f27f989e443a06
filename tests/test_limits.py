"""Limits for large numbers: roots of growing order of powers are constant, those of polynomials tend to 1."""

from __future__ import annotations

import pytest

from symcheck import decide

N = {"n": "integer"}


@pytest.mark.parametrize(
    ("relation", "given"),
    [
        (r"\lim_{n \to \infty} \sqrt[n]{7^n y^{4n}} = 7 y^4", ()),
        (r"\lim_{n \to \infty} \sqrt[3n]{|5^n y^{3n}|} = 5^{1/3} |y|", ()),
        (r"\lim_{n \to \infty} (4^n y^{2n})^{1/(2n)} = 2 y", ("y > 0",)),
        (r"\lim_{n \to \infty} \sqrt[n]{n} = 1", ()),
        (r"\lim_{n \to \infty} \sqrt[n]{n^2 + 3} = 1", ()),
        (r"\lim_{n \to \infty} \sqrt[n]{3 \cdot 5^n} = 5", ()),
        (r"\lim_{n \to \infty} \sqrt[n]{\left|\frac{n y^n}{6^n}\right|} = \frac{|y|}{6}", ()),
        (r"\lim_{n \to \infty} \sqrt[2n]{|y|^n} = \sqrt{|y|}", ()),
    ],
)
def test_a_root_of_growing_order_of_a_power_is_constant(relation: str, given: tuple[str, ...]) -> None:
    answer = decide(relation, given=given, letters=N)
    assert answer.verdict == "proved", answer.reason


@pytest.mark.parametrize(
    ("relation", "given"),
    [
        (r"\lim_{n \to \infty} \sqrt[n]{7^n y^{4n}} = 7 y^2", ()),
        (r"\lim_{n \to \infty} \sqrt[3n]{|5^n y^{3n}|} = 5 |y|", ()),
        (r"\lim_{n \to \infty} (4^n y^{2n})^{1/(2n)} = 4 y", ("y > 0",)),
        (r"\lim_{n \to \infty} \sqrt[n]{n^2 + 3} = 3", ()),
        (r"\lim_{n \to \infty} \sqrt[n]{3 \cdot 5^n} = 15", ()),
        (r"\lim_{n \to \infty} \sqrt[n]{\left|\frac{n y^n}{6^n}\right|} = 6 |y|", ()),
    ],
)
def test_a_slip_in_such_a_limit_is_refuted(relation: str, given: tuple[str, ...]) -> None:
    answer = decide(relation, given=given, letters=N)
    assert answer.verdict == "refuted", answer.reason


@pytest.mark.parametrize(
    "relation",
    [
        r"\lim_{n \to \infty} \sqrt[n]{y^n} = y",  # not for negative ones
        r"\lim_{n \to \infty} \sqrt[n]{b n} = 1",  # nor here
        r"\lim_{n \to \infty} \sqrt[n]{|n^{n^2}|} = 1",
        r"\lim_{n \to \infty} \sqrt[n]{|n|^n} = 1",
    ],
)
def test_a_root_without_a_limit_is_not_proved_to_have_one(relation: str) -> None:
    assert decide(relation, letters=N).verdict != "proved"
