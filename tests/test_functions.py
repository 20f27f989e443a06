"""Statements about roots, powers, means and integrals: the true ones are proved by theorems, the false ones refuted."""

from __future__ import annotations

import json
from typing import Any

import pytest

from symcheck.audit.checked import reason as check
from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import INFINITY, MINUS_INFINITY, PI, Formula, Term, node
from symcheck.core.verdicts import Verdict
from symcheck.proof import certificate, identity
from symcheck.proof.search.methods import theorems

A: Term = "a"
SPREAD: Term = node("+", node("*", 3, node("^", "alpha", 2), node("^", "a", 2)), node("*", 4, node("^", "beta", 2)))
FALL: Term = node(
    "+", node("-", node("/", node("*", 4, "gamma"), node("*", 3, node("^", "alpha", 2)))), node("-", node("/", 2, 3))
)
DENSITY: Term = node("*", 8, "C", "a", node("pow", SPREAD, FALL))
HALF = (0, INFINITY)
WHOLE = (MINUS_INFINITY, INFINITY)
LORENTZ: Term = node("+", node("^", "x", 2), node("^", "k", 2))
NOISE = ("noise", (node(">", "alpha", 0), node(">", "beta", 0)))
AMPLITUDE = ("amplitude", (node(">", "a", 0),))
K = ("k", (node(">", "k", 0),))
E_ = ("moments", (node(">", "E", 0), node(">", "A", "E"), node(">=", "b", 0), node("<=", "b", 1)))
REST: Term = node("+", 1, node("-", "b"))
GAP: Term = node("+", "A", node("-", "E"))
DRIFT: Term = node(
    "+", node("*", node("/", 5, 16), "a", node("^", "alpha", 2)), node("/", node("^", "beta", 2), node("*", 4, "a"))
)
DIFFUSION: Term = node(
    "+",
    node("*", node("/", 3, 8), node("^", "a", 2), node("^", "alpha", 2)),
    node("*", node("/", 1, 2), node("^", "beta", 2)),
)
SQUARES: tuple[Term, Term] = (node("^", node("sin", "a"), 2), node("^", node("cos", "a"), 2))
BELOW_FOUR: Term = node("+", 4, node("-", node("*", 3, SQUARES[0])))
ABOVE_ONE: Term = node("+", 1, node("*", 3, SQUARES[1]))


def finite(body: Term, x: str, ends: tuple[Term, Term] = HALF) -> Formula:
    return node("=", node("diverges", body, x, *ends), 0)


def average(value: Term) -> Formula:
    turning: Term = node(
        "+", node("*", "a", node("^", node("cos", "psi"), 4)), node("*", node("sin", "psi"), node("cos", "psi"), "h")
    )
    return node("=", node("mean", turning, "psi"), value)


def without_flux(drift: Term) -> Formula:
    drift = node("+", drift, node("-", node("*", node("/", "a", 2), "gamma")))
    first: Term = node("*", node("/", 1, 2), node("diff", node("*", DIFFUSION, DENSITY), "a", 1, "a"))
    return node("=", first, node("*", drift, DENSITY))


def normalised(constant: Term) -> Formula:
    body: Term = node("*", "C", node("pow", LORENTZ, -2))
    return node("=>", node("=", node("integral", body, "x", *WHOLE), 1), node("=", "C", constant))


def moments(number: int) -> Formula:
    body: Term = node("*", node("pow", "a", "m"), "a", node("pow", SPREAD, FALL))
    bound: Term = node("*", node("^", "alpha", 2), node("+", 2, node("*", 3, "m")))
    return node("<=>", finite(body, "a"), node(">", node("*", number, "gamma"), bound))


def square(sign: str) -> Formula:
    first, second = node("sqrt", node("*", "E", REST)), node("sqrt", node("*", "b", GAP))
    inner: Term = node("+", first, second if sign == "+" else node("-", second))
    spread: Term = node(
        "+", node("*", "E", REST), node("*", "b", GAP), node("*", 2, node("sqrt", node("*", "E", REST, "b", GAP)))
    )
    return node("=", spread, node("^", inner, 2))


TRUE: dict[str, tuple[Formula, tuple[Any, ...]]] = {
    "the square of a root": (node("=", node("^", node("sqrt", node("*", "E", REST)), 2), node("*", "E", REST)), (E_,)),
    "the square of a sum of roots": (square("+"), (E_,)),
    "an average": (average(node("*", node("/", 3, 8), "a")), ()),
    "a density without flux": (without_flux(DRIFT), (NOISE, AMPLITUDE)),
    "which moments are finite": (moments(8), (NOISE, ("order", (node(">", "m", 0),)))),
    "an odd moment": (node("=", node("integral", node("*", "x", node("pow", LORENTZ, -2)), "x", *WHOLE), 0), (K,)),
    "no power is integrable": (node("!=", node("diverges", node("pow", "x", "n"), "x", *HALF), 0), ()),
    "the integral of a constant": (node("=", node("integral", "c", "x", 1, 4), node("*", 3, "c")), ()),
    "the slope of an exponential": (
        node(
            "=", node("diff", node("exp", node("*", 2, "x")), "x", 1, "x"), node("*", 2, node("exp", node("*", 2, "x")))
        ),
        (),
    ),
    "a power is positive": (node(">", node("pow", LORENTZ, "n"), 0), (K,)),
    "a sine is one at most": (node(">", BELOW_FOUR, 0), ()),
    "below a root too": (node(">=", node("sqrt", node("/", 3, BELOW_FOUR)), 0), ()),
    "a root of sine and cosine": (
        node(
            "=",
            node("sqrt", node("+", node("*", 4, SQUARES[0]), node("*", 16, SQUARES[1]))),
            node("*", 2, node("sqrt", ABOVE_ONE)),
        ),
        (),
    ),
    "roots whose arguments are equal on the circle": (node("=", node("sqrt", BELOW_FOUR), node("sqrt", ABOVE_ONE)), ()),
    "the root of a number": (node(">=", node("*", node("sqrt", 3), "b"), 0), (("b", (node(">=", "b", 0),)),)),
}
FALSE: dict[str, tuple[Formula, tuple[Any, ...]]] = {
    "the square of a difference of roots": (square("-"), (E_,)),
    "another average": (average(node("*", node("/", 1, 2), "a")), ()),
    "a density with flux": (without_flux(node("*", 2, DRIFT)), (NOISE, AMPLITUDE)),
    "other moments": (moments(20), (NOISE, ("order", (node(">=", "m", 1),)))),
    "the integral of another constant": (node("=", node("integral", "c", "x", 1, 4), node("*", 4, "c")), ()),
    "a sine is less than one": (node(">", node("+", 3, node("-", node("*", 3, SQUARES[0]))), 0), ()),
    "roots whose arguments differ": (node("=", node("sqrt", BELOW_FOUR), node("sqrt", node("+", 1, SQUARES[1]))), ()),
    "the root of a number, negative": (node("<", node("*", node("sqrt", 3), "b"), 0), (("b", (node(">=", "b", 0),)),)),
}


def decided(name: str, claim: Formula, hypotheses: tuple[Any, ...], verdict: Verdict) -> None:
    problem = Problem(name, claim, (), hypotheses)
    outcome = identity.decide(problem)
    assert outcome.verdict is verdict, outcome.reason
    assert check(json.loads(json.dumps(certificate(problem, outcome)))) is None


def test_a_power_that_divides_under_an_integral_has_to_be_shown_not_to_vanish() -> None:
    problem = Problem("constant", normalised(node("/", node("*", 2, node("^", "k", 3)), PI)), (), (K,))
    outcome = identity.decide(problem)
    assert outcome.verdict is Verdict.PROVED
    assert check(json.loads(json.dumps(certificate(problem, outcome)))) == "a denominator may be zero: under a binder"


@pytest.mark.parametrize("name", TRUE)
def test_a_true_statement_about_functions_is_proved(name: str) -> None:
    decided(name, *TRUE[name], Verdict.PROVED)


@pytest.mark.parametrize("name", FALSE)
def test_a_false_statement_about_functions_is_refuted_at_a_point(name: str) -> None:
    decided(name, *FALSE[name], Verdict.REFUTED)


NOT_PROVED: dict[str, tuple[Formula, tuple[Any, ...]]] = {
    "the root of a square without a sign": (node("=", node("sqrt", node("^", "x", 2)), "x"), ()),
    "the square of a root of something negative": (
        node("=", node("^", node("sqrt", node("-", node("^", "x", 2))), 2), node("-", node("^", "x", 2))),
        (),
    ),
    "a power of a sum": (
        node("=", node("pow", node("+", "x", "y"), "n"), node("+", node("pow", "x", "n"), node("pow", "y", "n"))),
        (),
    ),
    "a constant of another density": (normalised(node("/", node("*", 3, node("^", "k", 3)), PI)), (K,)),
    "an even moment": (node("=", node("integral", node("pow", LORENTZ, -2), "x", *WHOLE), 0), (K,)),
    "the order of two functions": (node("<", node("exp", "x"), node("exp", node("*", 2, "x"))), ()),
    "an odd moment that need not be finite": (
        node("=", node("integral", node("*", "x", node("pow", LORENTZ, "n")), "x", *WHOLE), 0),
        (K,),
    ),
}


@pytest.mark.parametrize("name", NOT_PROVED)
def test_what_no_theorem_says_is_not_proved(name: str) -> None:
    claim, hypotheses = NOT_PROVED[name]
    assert identity.decide(Problem(name, claim, (), hypotheses)).verdict is not Verdict.PROVED


def test_a_declared_theorem_helps() -> None:
    claim: Formula = node("=>", node("=", node("^", "x", 2), node("^", "y", 2)), node("=", "x", "y"))
    signs = ("signs", (node(">=", "x", 0), node(">=", "y", 0)))
    method = theorems(Applied("equal_squares", ("x", "y")))
    problem = Problem("squares", claim, (), (signs,), tuple(hint.mapped(str) for hint in method.hints))
    assert identity.decide(problem).verdict is Verdict.PROVED


def test_a_proof_does_not_depend_on_what_was_decided_before() -> None:
    signs = ("signs", (node(">=", "x", 0), node(">=", "y", 0)))
    roots: list[Term] = [node("sqrt", node("+", "x", "y")), node("sqrt", node("+", "y", "x"))]
    problems = [Problem("root", node(">=", root, 0), (), (signs,)) for root in roots]
    first = [identity.decide(problem).proof for problem in problems]
    again = [identity.decide(problem).proof for problem in reversed(problems)][::-1]
    assert first == again
    assert first[0] != first[1]
