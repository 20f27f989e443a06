"""Sums over data, to a number of them that is a letter."""

from __future__ import annotations

import pytest

from symcheck import decide

MEANS = (r"\bar x = \frac1n \sum_{i=1}^n x_i", r"\bar y = \frac1n \sum_{i=1}^n y_i")
VARIANCE = r"s^2 = \frac{1}{n-1} \sum_{i=1}^n (x_i - \bar x)^2"
PRODUCTS = r"\sum_{i=1}^n (x_i - \bar x)(y_i - \bar y)"
ABOUT = r"\sum_{i=1}^n (x_i - \mu)^2 = \sum_{i=1}^n (x_i - \bar x)^2"


@pytest.mark.parametrize(
    ("relation", "verdict"),
    [
        (r"s^2 = \frac{1}{n-1} \left(\sum_{i=1}^n x_i^2 - n \bar x^2\right)", "proved"),
        (r"s^2 = \frac{1}{n-1} \left(\sum_{i=1}^n x_i^2 + n \bar x^2\right)", "refuted"),
        (rf"{PRODUCTS} = \sum_{{i=1}}^n x_i y_i - n \bar x \bar y", "proved"),
        (rf"{PRODUCTS} = \sum_{{i=1}}^n x_i (y_i - \bar y)", "proved"),
        (rf"{PRODUCTS} = \sum_{{i=1}}^n x_i (y_i + \bar y)", "refuted"),
        (rf"{ABOUT} + n (\bar x - \mu)^2", "proved"),
        (rf"{ABOUT} - n (\bar x - \mu)^2", "refuted"),
        (r"\sum_{i=1}^n x_i y_i = \sum_{i=1}^n x_i \sum_{i=1}^n y_i", "refuted"),
        (r"\sum_{i=1}^n (x_i - \bar x) x_1 = 0", "proved"),  # one of the data beside them
    ],
)
def test_sums_over_data_are_decided(relation: str, verdict: str) -> None:
    where = [text for text in (*MEANS, VARIANCE) if text.split("=")[0].strip() in relation]
    where += [MEANS[0]] if VARIANCE in where and MEANS[0] not in where else []
    assert decide(relation, where=where).verdict == verdict
