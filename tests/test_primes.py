"""Primes of functions of several letters, where it is said what they are; differentials that are said to be some."""

from __future__ import annotations

import pytest

from symcheck import decide

SAID = r"g'(t, c) = \frac{\partial g}{\partial t}(t, c)"
G = r"g(t, c) = c^2 u(t) + t v(t)"
U = {"u": "function of t", "v": "function of t"}


@pytest.mark.parametrize(
    ("verdict", "relation"),
    [
        ("proved", r"g'(t, c) = c^2 u'(t) + v(t) + t v'(t)"),
        ("refuted", r"g'(t, c) = c^2 u'(t) + t v'(t)"),
        ("refuted", r"g'(t, c) = 2 c u(t)"),
    ],
)
def test_a_prime_is_the_derivative_that_it_is_said_to_be(verdict: str, relation: str) -> None:
    assert decide(relation, [G, SAID], letters=U).verdict == verdict


@pytest.mark.parametrize(
    ("where", "verdict"),
    [
        ([G], "undecided"),  # nobody says by which
        ([G, r"g'(t, c) = \frac{\partial g}{\partial c}(t, c)"], "refuted"),
    ],
)
def test_a_prime_is_none_that_it_is_not_said_to_be(where: list[str], verdict: str) -> None:
    assert decide(r"g'(t, c) = c^2 u'(t) + v(t) + t v'(t)", where, letters=U).verdict == verdict


@pytest.mark.parametrize(
    ("verdict", "relation", "where"),
    [
        ("proved", r"\frac{\partial g}{\partial t} = 3 u'(t) + c", ["g(t, c) = 3 u(t) + c t"]),
        ("refuted", r"\frac{\partial g}{\partial t} = 3 u'(t)", ["g(t, c) = 3 u(t) + c t"]),
        ("undecided", r"\frac{\partial g}{\partial t} = 3 u'(t) + c", ["g = 3 u(t) + c t"]),  # u may be held constant
    ],
)
def test_what_is_no_argument_of_a_function_is_not_held_constant(verdict: str, relation: str, where: list[str]) -> None:
    assert decide(relation, where).verdict == verdict


@pytest.mark.parametrize(
    ("verdict", "relation"),
    [("proved", r"dA = 2 r \, dr"), ("refuted", r"dA = r \, dr")],
)
def test_differentials_may_be_said_to_be_some(verdict: str, relation: str) -> None:
    assert decide(relation, "A = r^2", letters={"dr": "differential"}).verdict == verdict
