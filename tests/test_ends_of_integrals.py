"""Integrals to infinity, logarithms and powers at an end, other letters of integrals: what is so, and what is not.

What an integral without a value is said to be is neither proved nor refuted.
"""

from __future__ import annotations

import pytest

from symcheck import decide

A = ("a > 0",)
AB = ("a > 0", "b > 0")
PROVED: dict[str, tuple[str, ...]] = {
    r"\int_1^\infty \frac{dx}{x(x+1)} = \ln 2": (),
    r"\int_2^\infty \frac{dx}{x^2-1} = \frac{\ln 3}{2}": (),
    r"\int_1^\infty \frac{dx}{x(x+a)} = \frac{\ln(1+a)}{a}": A,
    r"\int_0^\infty \frac{x}{(1+x)^3} dx = \frac12": (),
    r"\int_1^\infty \frac{\ln x}{x^2} dx = 1": (),
    r"\int_0^1 x\ln x\,dx = -\frac14": (),
    r"\int_0^a x^2\ln x\,dx = \frac{a^3(3\ln a - 1)}{9}": (),  # the logarithm says that a > 0
    r"\int_0^1 x^n\ln x\,dx = -\frac{1}{(n+1)^2}": ("n > -1",),
    r"\int_0^1 x^{a-1}(1-x)^{b-1} dx = \frac{\Gamma(a)\Gamma(b)}{\Gamma(a+b)}": AB,
    r"\int_{-a}^0 e^{-x^2} dx = \int_0^a e^{-x^2} dx": (),
    r"\int_0^a f(x) dx = \int_0^a f(a-x) dx": (),
    r"\int_0^a e^{-c^2x^2} dx = \frac{1}{c}\int_0^{ac} e^{-x^2} dx": (),  # c is not zero, as it is divided by
    r"\operatorname{erf}(-x) = -\operatorname{erf}(x)": (),
    r"\Gamma(x)\Gamma(1-x) = \frac{\pi}{\sin\pi x}": ("0 < x < 1",),
    r"\Gamma(x)\Gamma\left(x+\frac12\right) = 2^{1-2x}\sqrt{\pi}\,\Gamma(2x)": ("x > 0",),
    r"\sum_{k=0}^\infty\frac{x^k}{k!} = e^x": (),
    r"q - 2\sum_{k=0}^{n} k\binom{n}{k} = q - n \cdot 2^n": (r"n \in \mathbb{Z}_{>0}",),
}
REFUTED: dict[str, tuple[str, ...]] = {
    r"\int_1^\infty \frac{dx}{x(x+1)} = \ln 3": (),
    r"\int_0^\infty \frac{x}{(1+x)^3} dx = \frac13": (),
    r"\int_1^\infty \frac{\ln x}{x^2} dx = 2": (),
    r"\int_0^1 x\ln x\,dx = -\frac12": (),
    r"\int_0^1 x^a(1-x)^b dx = \frac{\Gamma(a+1)\Gamma(b+1)}{\Gamma(a+b+1)}": AB,
    r"\operatorname{erf}(-x) = \operatorname{erf}(x)": (),
    r"\Gamma(x)\Gamma(1-x) = \frac{\pi}{\cos\pi x}": ("0 < x < 1",),
    r"\Gamma(x)\Gamma\left(x+\frac12\right) = 2^{2x-1}\sqrt{\pi}\,\Gamma(2x)": ("x > 0",),
    r"\sum_{k=1}^\infty\frac{x^k}{k!} = e^x": ("x > 0",),
    r"q - 2\sum_{k=0}^{n} k\binom{n}{k} = q - n \cdot 2^{n-1}": (r"n \in \mathbb{Z}_{>0}",),
}
OPEN: dict[str, tuple[str, ...]] = {
    r"\int_0^\infty \frac{dx}{1+x} = 0": (),
    r"\int_0^\infty \frac{dx}{x^2-1} = 0": (),  # a pole between the ends
    r"\int_1^\infty \frac{dx}{x(x+a)} = \frac{\ln(1+a)}{a}": (),  # for a = -2 it has a pole
    r"\int_0^1 x^{-1}\ln x\,dx = 0": (),
    r"\int_0^1 x^n\ln x\,dx = -\frac{1}{(n+1)^2}": (),  # for n = -2 it has no value
    r"\int_0^1 x^{a-1}(1-x)^{b-1} dx = \frac{1}{ab}": ("a = -1",),
    r"\int_0^a f(x) dx = \int_0^a f(x-a) dx": (),
}


@pytest.mark.parametrize("relation", PROVED)
def test_what_is_so_is_proved(relation: str) -> None:
    assert decide(relation, given=PROVED[relation]).verdict == "proved"


@pytest.mark.parametrize("relation", REFUTED)
def test_what_is_not_so_is_refuted(relation: str) -> None:
    assert decide(relation, given=REFUTED[relation]).verdict == "refuted"


LONG = (r"\int_0^\infty \frac{dx}{x^2-1} = 0", r"\int_0^1 x^n\ln x\,dx = -\frac{1}{(n+1)^2}")


@pytest.mark.parametrize(
    "relation", [pytest.param(each, marks=pytest.mark.slow) if each in LONG else each for each in OPEN]
)
def test_what_has_no_value_or_holds_under_conditions_alone_is_neither(relation: str) -> None:
    assert decide(relation, given=OPEN[relation]).verdict not in ("proved", "refuted")
