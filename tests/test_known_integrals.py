"""Integrals by their known values: the densities of Weibull and Cauchy, their moments and distribution functions."""

from __future__ import annotations

import pytest
from sampling import every

from symcheck import decide
from symcheck.core.problems import Problem
from symcheck.core.terms import INFINITY, MINUS_INFINITY, node
from symcheck.question.known_integrals import with_values

WEIBULL = r"\frac{k}{\lambda}\left(\frac{x}{\lambda}\right)^{k-1} e^{-(x/\lambda)^k}"
CAUCHY = r"\frac{1}{\pi}\frac{\gamma}{(t-x_0)^2+\gamma^2}"
SHAPE, WIDTH = "k > 0, \\lambda > 0", r"\gamma > 0"
PAIRS = [
    (rf"\int_0^\infty {WEIBULL}\,dx = 1", rf"\int_0^\infty x {WEIBULL}\,dx = 1", SHAPE),
    (
        rf"\int_0^\infty x {WEIBULL}\,dx = \lambda\Gamma\left(1+\frac1k\right)",
        rf"\int_0^\infty x {WEIBULL}\,dx = \lambda\Gamma\left(1+\frac2k\right)",
        SHAPE,
    ),
    (
        rf"\int_0^\infty x^2 {WEIBULL}\,dx = \lambda^2\Gamma\left(1+\frac2k\right)",
        rf"\int_0^\infty x^2 {WEIBULL}\,dx = \lambda\Gamma\left(1+\frac2k\right)",
        SHAPE,
    ),
    (
        rf"\int_0^s {WEIBULL}\,dx = 1 - e^{{-(s/\lambda)^k}}",
        rf"\int_0^s {WEIBULL}\,dx = e^{{-(s/\lambda)^k}}",
        SHAPE + ", s > 0",
    ),
    (
        r"\int_0^\infty e^{-x^p}dx = \Gamma\left(1+\frac1p\right)",
        r"\int_0^\infty e^{-x^p}dx = \Gamma\left(\frac1p\right)",
        "p > 0",
    ),
    (
        rf"\int_{{-\infty}}^x {CAUCHY}\,dt = \frac12 + \frac1\pi\arctan\frac{{x-x_0}}{{\gamma}}",
        rf"\int_{{-\infty}}^x {CAUCHY}\,dt = \frac1\pi\arctan\frac{{x-x_0}}{{\gamma}}",
        WIDTH,
    ),
    (rf"\int_{{-\infty}}^{{x_0}} {CAUCHY}\,dt = \frac12", rf"\int_{{-\infty}}^{{x_0}} {CAUCHY}\,dt = 1", WIDTH),
    (
        r"\int_0^\infty \frac{2}{\pi\gamma}\frac{1}{1+x^2/\gamma^2}\,dx = 1",
        r"\int_0^\infty \frac{1}{\pi\gamma}\frac{1}{1+x^2/\gamma^2}\,dx = 1",
        WIDTH,
    ),
]


TURNS = [
    (
        r"\int_0^{\pi}\frac{dx}{a+b\cos x} = \frac{\pi}{\sqrt{a^2-b^2}}",
        r"\int_0^{\pi}\frac{dx}{a+b\cos x} = \frac{2\pi}{\sqrt{a^2-b^2}}",
        "a > b > 0",
    ),
    (
        r"\int_0^{2\pi}\frac{dx}{(a+b\cos x)^2} = \frac{2\pi a}{(a^2-b^2)^{3/2}}",
        r"\int_0^{2\pi}\frac{dx}{(a+b\cos x)^2} = \frac{2\pi b}{(a^2-b^2)^{3/2}}",
        "a > b > 0",
    ),
    (
        r"\int_0^{\pi/2}\frac{dx}{a^2\cos^2 x+b^2\sin^2 x} = \frac{\pi}{2ab}",
        r"\int_0^{\pi/2}\frac{dx}{a^2\cos^2 x+b^2\sin^2 x} = \frac{\pi}{ab}",
        "a > 0, b > 0",
    ),
    (
        r"\int_0^{2\pi}\frac{\cos 2x}{5+4\cos x}\,dx = \frac{\pi}{6}",
        r"\int_0^{2\pi}\frac{\cos 2x}{5+4\cos x}\,dx = -\frac{\pi}{6}",
        "",
    ),
]


WALD = r"\sqrt{\frac{\lambda}{2\pi x^3}}\exp\left(-\frac{\lambda(x-\mu)^2}{2\mu^2 x}\right)"
BOTH = [
    (rf"\int_0^\infty {WALD}\,dx = 1", rf"\int_0^\infty x^2 {WALD}\,dx = \mu", r"\lambda > 0, \mu > 0"),
    (
        rf"\int_0^\infty (x-\mu)^2 {WALD}\,dx = \frac{{\mu^3}}{{\lambda}}",
        rf"\int_0^\infty (x-\mu)^2 {WALD}\,dx = \frac{{\mu^2}}{{\lambda}}",
        r"\lambda > 0, \mu > 0",
    ),
    (
        r"\int_0^\infty e^{-px^2-q/x^2}\,dx = \frac12\sqrt{\frac{\pi}{p}}e^{-2\sqrt{pq}}",
        r"\int_0^\infty e^{-px^2-q/x^2}\,dx = \frac12\sqrt{\frac{\pi}{p}}e^{-\sqrt{pq}}",
        "p > 0, q > 0",
    ),
    (
        r"\int_0^\infty \frac{b}{\sqrt{2\pi t^3}}e^{-b^2/(2t)}e^{-rt}\,dt = e^{-b\sqrt{2r}}",
        r"\int_0^\infty \frac{b}{\sqrt{2\pi t^3}}e^{-b^2/(2t)}e^{-rt}\,dt = e^{-b\sqrt{r}}",
        "b > 0, r > 0",
    ),
]


@pytest.mark.parametrize("case", every(2, BOTH), ids=lambda case: case[0])
def test_an_integral_with_an_essential_singularity_is_proved_and_its_slip_refuted(case: tuple[str, str, str]) -> None:
    right, wrong, given = case
    assert decide(right, given=given).verdict == "proved"
    assert decide(wrong, given=given).verdict == "refuted"


WAVES = [
    (
        r"\int_{-\infty}^\infty \sin(x^2)\,dx = \sqrt{\frac{\pi}{2}}",
        r"\int_{-\infty}^\infty \sin(x^2)\,dx = \sqrt{\pi}",
        "",
    ),
    (r"\int_0^\infty \frac{\sin x}{x}\,dx = \frac\pi2", r"\int_0^\infty \frac{\sin x}{x}\,dx = \pi", ""),
    (
        r"\int_0^\infty \frac{\cos(bt)}{\sqrt t}\,dt = \sqrt{\frac{\pi}{2b}}",
        r"\int_0^\infty \frac{\cos(bt)}{\sqrt t}\,dt = \sqrt{\frac{\pi}{b}}",
        "b > 0",
    ),
]


@pytest.mark.parametrize("case", every(2, WAVES), ids=lambda case: case[0])
def test_an_integral_of_a_wave_is_proved_and_its_slip_refuted(case: tuple[str, str, str]) -> None:
    right, wrong, given = case
    assert decide(right, given=given).verdict == "proved"
    assert decide(wrong, given=given).verdict == "refuted"


@pytest.mark.parametrize(
    ("relation", "given"),
    [
        (r"\int_0^\infty \sin(bt)\,dt = \frac1b", "b > 0"),  # these have no value
        (r"\int_0^\infty t\sin(bt)\,dt = \frac{1}{b^2}", "b > 0"),
        (r"\int_0^\infty \frac{\cos x}{x}\,dx = 0", ""),
    ],
)
def test_a_wave_that_does_not_decay_is_neither_proved_nor_refuted(relation: str, given: str) -> None:
    assert decide(relation, given=given).verdict == "undecided"


@pytest.mark.parametrize("case", every(2, TURNS), ids=lambda case: case[0])
def test_an_integral_over_turns_is_proved_and_its_slip_refuted(case: tuple[str, str, str]) -> None:
    right, wrong, given = case
    assert decide(right, given=given).verdict == "proved"
    assert decide(wrong, given=given).verdict == "refuted"


@pytest.mark.parametrize("case", every(3, PAIRS), ids=lambda case: case[0])
def test_a_known_integral_is_proved_and_its_slip_refuted(case: tuple[str, str, str]) -> None:
    right, wrong, given = case
    assert decide(right, given=given).verdict == "proved"
    assert decide(wrong, given=given).verdict == "refuted"


@pytest.mark.parametrize(
    ("relation", "given"),
    [
        (r"\int_0^\infty k x^{k-1} e^{-x^k}\,dx = 1", "k < 0"),
        (r"\int_0^\infty x^{-u} e^{-x^k}\,dx = \frac1k\Gamma\left(\frac{1-u}{k}\right)", "k > 0, u > 1"),  # it diverges
        (r"\int_0^\infty e^{x^k}\,dx = \Gamma\left(1+\frac1k\right)", "k > 0"),
        (rf"\int_{{-\infty}}^{{x_0}} {CAUCHY}\,dt = \frac12", r"\gamma < 0"),
        (r"\int_{-\infty}^{\infty} \left(\sqrt{x} - \sqrt{x} + \frac{1}{1+x^2}\right) dx = \pi", ""),  # no value
        (r"\int_0^\infty e^{-px^2-q/x^2}\,dx = \frac12\sqrt{\frac{\pi}{p}}e^{-2\sqrt{pq}}", "p > 0"),
        (r"\int_0^\infty e^{-px-q/x^2}\,dx = \frac12\sqrt{\frac{\pi}{p}}e^{-2\sqrt{pq}}", "p > 0, q > 0"),
        (r"\int_0^{2\pi}\frac{dx}{4+5\cos x} = \frac{2\pi}{3}", ""),  # it diverges
        (r"\int_0^{\pi}\frac{dx}{3+2\sin x} = \frac{\pi}{\sqrt{5}}", ""),  # no half turns of a sine are alike
        (r"\int_{\pi/2}^{3\pi/2}\frac{dx}{2+\cos x} = \frac{\pi}{\sqrt{3}}", ""),  # nor those from elsewhere
        (r"\int_{-\infty}^x \frac{1}{t^2-1}\,dt = \arctan x + \frac\pi2", "x < -1"),
    ],
)
def test_where_an_integral_diverges_or_has_another_sign_nothing_is_proved(relation: str, given: str) -> None:
    assert decide(relation, given=given).verdict != "proved"


def test_the_conditions_of_a_value_are_claims_of_their_own() -> None:
    body = node("/", 1, node("+", node("^", "t", 2), node("^", "s", 2)))
    found = with_values(Problem("x", node("=", node("integral", body, "t", MINUS_INFINITY, INFINITY), "y")))
    assert found is not None
    assert node(">", "s", 0) in [side.claim for side in found.sides]
