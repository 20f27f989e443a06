"""Sums with letters that stand in exponents of e alone, as in moment generating functions."""

from __future__ import annotations

import pytest

from symcheck import decide

POISSON, GEOMETRIC = (
    r"\sum_{k=0}^{\infty}\frac{\lambda^k e^{-\lambda}}{k!}e^{tk}",
    r"\sum_{k=0}^{\infty}p(1-p)^k e^{tk}",
)


@pytest.mark.parametrize(
    ("relation", "given", "verdict"),
    [
        (rf"{POISSON} = e^{{\lambda(e^t-1)}}", r"\lambda > 0", "proved"),
        (rf"{POISSON} = e^{{\lambda e^t}}", r"\lambda > 0", "refuted"),
        (rf"{GEOMETRIC} = \frac{{p}}{{1-(1-p)e^t}}", "0 < p < 1, t < 0", "proved"),
        (rf"{GEOMETRIC} = \frac{{pe^t}}{{1-(1-p)e^t}}", "0 < p < 1, t < 0", "refuted"),
        (rf"{GEOMETRIC} = \frac{{p}}{{1-(1-p)e^t}}", "0 < p < 1, t > 0", "undecided"),  # it may diverge
        (r"\sum_{k=1}^{\infty} e^{-kt} = \frac{1}{e^t-1}", "t > 0", "proved"),
        (r"\sum_{k=1}^{\infty} e^{-kt} = \frac{1}{e^t+1}", "t > 0", "refuted"),
        (r"\sum_{k=0}^{\infty}\binom{k+r-1}{k}p^r(1-p)^k = 1", r"0 < p < 1, r \in \mathbb{N}, r \ge 1", "proved"),
    ],
)
def test_sums_with_exponentials_are_decided(relation: str, given: str, verdict: str) -> None:
    assert decide(relation, given=given).verdict == verdict


LEVELS = r"Z = \sum_{n=0}^{\infty} e^{-\beta \hbar \omega (n + 1/2)}"
POSITIVE = r"\beta > 0, \hbar > 0, \omega > 0"


@pytest.mark.parametrize(
    ("relation", "where", "given", "verdict"),
    [
        (r"Z = \frac{e^{-\beta \hbar \omega/2}}{1 - e^{-\beta \hbar \omega}}", LEVELS, POSITIVE, "proved"),
        (r"Z = \frac{e^{-\beta \hbar \omega}}{1 - e^{-\beta \hbar \omega}}", LEVELS, POSITIVE, "refuted"),
        (r"Z = \frac{1}{2 \sinh(\beta \hbar \omega/2)}", LEVELS, POSITIVE, "proved"),
        (r"Z = \frac{1}{1 - e^{-xy}}", r"Z = \sum_{n=0}^{\infty} e^{-xyn}", "x > 0, y > 0", "proved"),
        (r"Z = \frac{1}{1 - e^{-xy}}", r"Z = \sum_{n=0}^{\infty} e^{-xyn}", "x > 0, y < 0", "undecided"),  # it diverges
        (r"\sum_{n=0}^1 y e^{xyn} = y + e^{xy} y", (), (), "proved"),
    ],
)
def test_sums_of_exponentials_of_products_are_decided(relation: str, where: str, given: str, verdict: str) -> None:
    assert decide(relation, where=where, given=given).verdict == verdict
