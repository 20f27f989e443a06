"""Kronecker's delta of letters that stand elsewhere, too."""

from __future__ import annotations

import pytest

from symcheck import decide

STATES = r"\psi_n(x) = \sqrt{\frac{2}{L}} \sin\frac{n\pi x}{L}"
FROM_ONE = r"m, n \in \mathbb{N}, m \ge 1, n \ge 1"
SINES = r"\int_0^\pi \sin mx \sin nx\,dx"


@pytest.mark.parametrize(
    ("relation", "where", "given", "verdict"),
    [
        (r"\int_0^L \psi_m(x) \psi_n(x)\,dx = \delta_{mn}", STATES, f"{FROM_ONE}, L > 0", "proved"),
        (rf"{SINES} = \frac{{\pi}}{{2}} \delta_{{mn}}", (), FROM_ONE, "proved"),
        (rf"{SINES} = \pi \delta_{{mn}}", (), FROM_ONE, "refuted"),
        (rf"{SINES} = \frac{{\pi}}{{2}} \delta_{{mn}}", (), r"m, n \in \mathbb{Z}", "ambiguous"),  # 0 for m = n = 0
        (r"\delta_{mn} a_n = a_m", (), (), "proved"),  # summed over n
    ],
)
def test_both_cases_of_the_delta_are_decided(relation: str, where: str, given: str, verdict: str) -> None:
    answer = decide(relation, where=where, given=given)
    assert answer.verdict == verdict, answer.reason
