"""Roots and powers of fractions and of zero: a method decides or does not, and never raises."""

from __future__ import annotations

import pytest

from symcheck.core.problems import Problem
from symcheck.core.terms import node
from symcheck.core.verdicts import Verdict
from symcheck.proof import identity
from symcheck.reading import Letter, Notation, lower, read

NOTATION = Notation([Letter("x"), Letter("a")])
POSITIVE = ("a is positive", (node(">", "a", 0),))
BASES = (r"\frac{1}{a}", r"\frac{a}{a}", r"\frac{4}{a^2}", r"\frac{x}{a}", r"-\frac{1}{a}", "0", "a - a", "4", "a^2")
EXPONENTS = (r"\frac14", r"\frac12", r"-\frac14", r"\frac{a}{2}", "a")


def problem(latex: str) -> Problem:
    (formula,) = lower(read(latex, NOTATION), NOTATION)
    return Problem("powers", formula, (), (POSITIVE,))


@pytest.mark.parametrize("exponent", EXPONENTS)
@pytest.mark.parametrize("base", BASES)
def test_no_method_raises_on_a_power(base: str, exponent: str) -> None:
    stated = problem(rf"x = \left({base}\right)^{{{exponent}}}")
    assert identity.decide(stated).verdict is not Verdict.PROVED


def test_a_root_of_a_fraction_is_itself() -> None:
    root = r"\left(\frac{1}{a}\right)^{\frac14}"
    assert identity.decide(problem(f"{root} = {root}")).verdict is Verdict.PROVED
