"""Integrals of integrals have values, by which a claim about several of them is proved or refuted."""

from __future__ import annotations

import pytest

from symcheck import decide

CONE = r"J = \int_0^{2\pi} \int_0^h \int_0^{a(1 - z/h)} r z^2 \, dr \, dz \, d\phi"
SHELL = (
    r"C = \int_0^{2\pi} \int_0^\beta \int_0^b r^3 \sin\gamma \cos\gamma \, dr \, d\gamma \, d\phi"
    r" + \int_0^{2\pi} \int_\beta^\pi \int_0^c r^2 \sin\gamma \, dr \, d\gamma \, d\phi"
)
SIZES = (r"0 < \beta < \frac{\pi}{2}", "b > 0", "c > 0")


@pytest.mark.parametrize(
    ("verdict", "relation", "where", "given"),
    [
        ("proved", r"J = \frac{\pi a^2 h^3}{30}", CONE, ("a > 0", "h > 0")),
        ("refuted", r"J = \frac{\pi a^2 h^3}{60}", CONE, ("a > 0", "h > 0")),
        ("proved", r"C = \frac{\pi}{4} b^4 \sin^2\beta + \frac{2\pi}{3} c^3 (1 + \cos\beta)", SHELL, SIZES),
        ("refuted", r"C = \frac{\pi}{4} b^4 \sin^2\beta + \frac{2\pi}{3} c^3 (1 - \cos\beta)", SHELL, SIZES),
        ("proved", r"\int_0^a \int_0^{a-x} x y \, dy \, dx = \frac{a^4}{24}", (), "a > 0"),
        ("refuted", r"\int_0^a \int_0^{a-x} x y \, dy \, dx = \frac{a^4}{12}", (), "a > 0"),
    ],
)
def test_integrals_of_integrals_are_decided_by_their_values(
    verdict: str, relation: str, where: str, given: tuple[str, ...]
) -> None:
    answer = decide(relation, where, given)
    assert answer.verdict == verdict, answer.reason


@pytest.mark.parametrize(
    "relation",
    [
        r"\int_0^1 \int_0^1 \frac{x^2 - y^2}{(x^2 + y^2)^2} \, dx \, dy = \frac{\pi}{4}",  # minus that
        r"\int_{-1}^1 \int_0^1 \frac{y}{x^2} \, dy \, dx = -1",  # it has no value at 0
    ],
)
def test_integrals_of_other_values_or_without_one_are_not_proved(relation: str) -> None:
    assert decide(relation).verdict != "proved"
