"""Sums without an end: the series in the table against mpmath, and what has no value or another one."""

from __future__ import annotations

import mpmath
import pytest
import sympy

from symcheck import decide
from symcheck.question.series import known
from symcheck.reading import to_sympy

K, X = sympy.Symbol("k", real=True), sympy.Symbol("x", real=True)
ADDENDS = {  # each is a multiple of one in the table
    "an exponential": 3 * X**K / sympy.gamma(K + 1),
    "an exponential with a power": K**2 * X**K / sympy.gamma(K + 1),
    "inverse squares": 5 / K**2,
    "inverse fourth powers": 1 / K**4,
    "alternating inverses": (-1) ** K / K,
    "alternating odd inverses": (-1) ** K / (2 * K + 1),
    "alternating inverse squares": (-1) ** K / K**2,
    "a logarithm": X**K / K,
    "a logarithm with later places": (-1) ** K * X**K * (1 / (K + 2) - 5 / (K + 4)),
    "an exponential from a later place on": X**K / sympy.gamma(K + 3),
    "an inverse tangent": (-1) ** K * X ** (2 * K) / (2 * K + 1),
    "an inverse tangent with a later place": (-1) ** K * X ** (2 * K) / (2 * K + 5),
    "an inverse hyperbolic tangent": X ** (2 * K) / (2 * K + 1),
    "a power of 1 - x": X**K * sympy.gamma(K + sympy.Rational(1, 3)) / sympy.gamma(K + 1),
    "a cosine": (-1) ** K * X ** (2 * K) / sympy.gamma(2 * K + 1),
    "a sine": (-1) ** K * X ** (2 * K + 1) / sympy.gamma(2 * K + 2),
    "a hyperbolic cosine": X ** (2 * K) / sympy.gamma(2 * K + 1),
    "a hyperbolic sine": X ** (2 * K + 1) / sympy.gamma(2 * K + 2),
}


@pytest.mark.parametrize("name", ADDENDS)
def test_a_series_in_the_table_has_its_value(name: str) -> None:
    several = [each for each in known(ADDENDS[name], K) if each.multiple != 0]
    assert several
    at = sympy.Rational(3, 7)
    for found in several:
        addend = sympy.lambdify(K, found.addend.subs(X, at), "mpmath")
        total = mpmath.nsum(addend, [found.first, mpmath.inf])
        value = to_sympy(found.value).subs(X, at).evalf(20)
        assert abs(total - mpmath.mpf(str(value))) < 1e-10


DIVERGENT = {
    r"\sum_{k=1}^\infty \frac{1}{k} = 5": (),
    r"\sum_{k=0}^\infty 2^k = -1": (),
    r"\sum_{k=1}^\infty k = -\frac{1}{12}": (),
    r"\sum_{k=0}^\infty x^k = \frac{1}{1-x}": (),
    r"\sum_{k=0}^\infty x^k = \frac{1}{1 - x} ": ("x > 1",),
    r"\sum_{k=1}^\infty \frac{x^k}{k} = -\ln(1-x)": ("x < 1",),
    r"\sum_{k=1}^\infty \frac{k}{k+1} = 0": (),
    r"\sum_{k=0}^\infty (-1)^k = \frac{1}{2}": (),
    r"\sum_{k=1}^\infty \frac{1}{(k-3)(k-2)} = -\frac{1}{2}": (),  # two addends have no value
    r"\sum_{k=0}^\infty \frac{1}{k(k+1)} = 1": (),
    r"\sum_{k=0}^\infty \frac{(-1)^k x^{2k+1}}{2k+1} = \arctan x": ("x > 1",),
}


@pytest.mark.parametrize("relation", DIVERGENT)
def test_what_need_not_converge_is_not_proved(relation: str) -> None:
    assert decide(relation, given=DIVERGENT[relation]).verdict != "proved"


@pytest.mark.parametrize("given", ["0 < x < 1", "|x| < 1"])
def test_a_geometric_series_converges_where_its_quotient_is_small(given: str) -> None:
    assert decide(r"\sum_{k=0}^\infty x^k = \frac{1}{1-x}", given=given).verdict == "proved"
    assert decide(r"\sum_{k=1}^\infty x^k = \frac{1}{1-x}", given=given).verdict == "refuted"


def test_a_certificate_is_about_values_and_addends() -> None:
    answer = decide(r"\sum_{k=0}^\infty k x^k = \frac{x}{(1-x)^2}", given="0 < x < 1")
    assert len(answer.certificate) == 3  # the value, the addend, and that x^2 < 1


SLIPS = {
    r"\sum_{k=0}^\infty \frac{(k+1) z^k}{k!} = (1+z) e^z": r"\frac{(k+2) z^k}{k!}",  # with no divisor that k makes zero
    r"\sum_{k=0}^\infty \frac{(-1)^k z^{2k+1}}{2k+1} = \arctan z": r"\frac{(-1)^k z^{2k}}{2k+1}",
    r"\sum_{k=0}^\infty \frac{z^k}{k+2} = -\frac{\ln(1-z)+z}{z^2}": r"\frac{z^k}{k+1}",
    r"\sum_{k=1}^\infty \frac{z^k}{k(k+1)} = 1 + \frac{(1-z)\ln(1-z)}{z}": r"\frac{z^k}{k(k+2)}",
}


@pytest.mark.parametrize("relation", SLIPS)
def test_a_series_is_known_wherever_it_begins_and_however_it_is_shifted(relation: str) -> None:
    assert decide(relation, given="0 < z < 1").verdict == "proved"
    addend = relation[len(r"\sum_{k=0}^\infty ") : relation.index(" = ")]
    assert decide(relation.replace(addend, SLIPS[relation]), given="0 < z < 1").verdict == "refuted"
