"""Statements about roots, powers, means and integrals: the true ones are proved by theorems, the false ones refuted."""

from __future__ import annotations

import json
from typing import Any

import pytest

from symcheck.evidence.checked import reason as check
from symcheck.proof import certificate, identity
from symcheck.proof.methods import theorems
from symcheck.statement import Formula, Problem, Term, Verdict

A: Term = "a"
SPREAD: Term = ("+", ("*", 3, ("^", "alpha", 2), ("^", "a", 2)), ("*", 4, ("^", "beta", 2)))
FALL: Term = ("+", ("-", ("/", ("*", 4, "gamma"), ("*", 3, ("^", "alpha", 2)))), ("-", ("/", 2, 3)))
DENSITY: Term = ("*", 8, "C", "a", ("pow", SPREAD, FALL))
HALF = (0, "infinity")
WHOLE = (("-", "infinity"), "infinity")
LORENTZ: Term = ("+", ("^", "x", 2), ("^", "k", 2))
NOISE = ("noise", ((">", "alpha", 0), (">", "beta", 0)))
AMPLITUDE = ("amplitude", ((">", "a", 0),))
K = ("k", ((">", "k", 0),))
E_ = ("moments", ((">", "E", 0), (">", "A", "E"), (">=", "b", 0), ("<=", "b", 1)))
REST: Term = ("+", 1, ("-", "b"))
GAP: Term = ("+", "A", ("-", "E"))
DRIFT: Term = ("+", ("*", ("/", 5, 16), "a", ("^", "alpha", 2)), ("/", ("^", "beta", 2), ("*", 4, "a")))
DIFFUSION: Term = ("+", ("*", ("/", 3, 8), ("^", "a", 2), ("^", "alpha", 2)), ("*", ("/", 1, 2), ("^", "beta", 2)))
SQUARES: tuple[Term, Term] = (("^", ("sin", "a"), 2), ("^", ("cos", "a"), 2))
BELOW_FOUR: Term = ("+", 4, ("-", ("*", 3, SQUARES[0])))
ABOVE_ONE: Term = ("+", 1, ("*", 3, SQUARES[1]))


def finite(body: Term, x: str, ends: tuple[Term, Term] = HALF) -> Formula:
    return ("=", ("diverges", body, x, *ends), 0)


def average(value: Term) -> Formula:
    turning: Term = ("+", ("*", "a", ("^", ("cos", "psi"), 4)), ("*", ("sin", "psi"), ("cos", "psi"), "h"))
    return ("=", ("mean", turning, "psi"), value)


def without_flux(drift: Term) -> Formula:
    drift = ("+", drift, ("-", ("*", ("/", "a", 2), "gamma")))
    first: Term = ("*", ("/", 1, 2), ("diff", ("*", DIFFUSION, DENSITY), "a", 1))
    return ("=", first, ("*", drift, DENSITY))


def normalised(constant: Term) -> Formula:
    body: Term = ("*", "C", ("pow", LORENTZ, -2))
    return ("=>", ("=", ("integral", body, "x", *WHOLE), 1), ("=", "C", constant))


def moments(number: int) -> Formula:
    body: Term = ("*", ("pow", "a", "m"), "a", ("pow", SPREAD, FALL))
    bound: Term = ("*", ("^", "alpha", 2), ("+", 2, ("*", 3, "m")))
    return ("<=>", finite(body, "a"), (">", ("*", number, "gamma"), bound))


def square(sign: str) -> Formula:
    first, second = ("sqrt", ("*", "E", REST)), ("sqrt", ("*", "b", GAP))
    inner: Term = ("+", first, second if sign == "+" else ("-", second))
    spread: Term = ("+", ("*", "E", REST), ("*", "b", GAP), ("*", 2, ("sqrt", ("*", "E", REST, "b", GAP))))
    return ("=", spread, ("^", inner, 2))


TRUE: dict[str, tuple[Formula, tuple[Any, ...]]] = {
    "the square of a root": (("=", ("^", ("sqrt", ("*", "E", REST)), 2), ("*", "E", REST)), (E_,)),
    "the square of a sum of roots": (square("+"), (E_,)),
    "an average": (average(("*", ("/", 3, 8), "a")), ()),
    "a density without flux": (without_flux(DRIFT), (NOISE, AMPLITUDE)),
    "which moments are finite": (moments(8), (NOISE, ("order", ((">", "m", 0),)))),
    "the constant of a density": (normalised(("/", ("*", 2, ("^", "k", 3)), "pi")), (K,)),
    "an odd moment": (("=", ("integral", ("*", "x", ("pow", LORENTZ, -2)), "x", *WHOLE), 0), (K,)),
    "no power is integrable": (("!=", ("diverges", ("pow", "x", "n"), "x", *HALF), 0), ()),
    "the integral of a constant": (("=", ("integral", "c", "x", 1, 4), ("*", 3, "c")), ()),
    "the slope of an exponential": (
        ("=", ("diff", ("exp", ("*", 2, "x")), "x", 1), ("*", 2, ("exp", ("*", 2, "x")))),
        (),
    ),
    "a power is positive": ((">", ("pow", LORENTZ, "n"), 0), (K,)),
    "a sine is one at most": ((">", BELOW_FOUR, 0), ()),
    "below a root too": ((">=", ("sqrt", ("/", 3, BELOW_FOUR)), 0), ()),
    "a root of sine and cosine": (
        ("=", ("sqrt", ("+", ("*", 4, SQUARES[0]), ("*", 16, SQUARES[1]))), ("*", 2, ("sqrt", ABOVE_ONE))),
        (),
    ),
    "roots whose arguments are equal on the circle": (("=", ("sqrt", BELOW_FOUR), ("sqrt", ABOVE_ONE)), ()),
    "the root of a number": ((">=", ("*", ("sqrt", 3), "b"), 0), (("b", ((">=", "b", 0),)),)),
}
FALSE: dict[str, tuple[Formula, tuple[Any, ...]]] = {
    "the square of a difference of roots": (square("-"), (E_,)),
    "another average": (average(("*", ("/", 1, 2), "a")), ()),
    "a density with flux": (without_flux(("*", 2, DRIFT)), (NOISE, AMPLITUDE)),
    "other moments": (moments(20), (NOISE, ("order", ((">=", "m", 1),)))),
    "the integral of another constant": (("=", ("integral", "c", "x", 1, 4), ("*", 4, "c")), ()),
    "a sine is less than one": ((">", ("+", 3, ("-", ("*", 3, SQUARES[0]))), 0), ()),
    "roots whose arguments differ": (("=", ("sqrt", BELOW_FOUR), ("sqrt", ("+", 1, SQUARES[1]))), ()),
    "the root of a number, negative": (("<", ("*", ("sqrt", 3), "b"), 0), (("b", ((">=", "b", 0),)),)),
}


def decided(name: str, claim: Formula, hypotheses: tuple[Any, ...], verdict: Verdict) -> None:
    problem = Problem(name, claim, (), hypotheses)
    outcome = identity.decide(problem)
    assert outcome.verdict is verdict, outcome.reason
    assert check(json.loads(json.dumps(certificate(problem, outcome)))) is None


@pytest.mark.parametrize("name", TRUE)
def test_a_true_statement_about_functions_is_proved(name: str) -> None:
    decided(name, *TRUE[name], Verdict.PROVED)


@pytest.mark.parametrize("name", FALSE)
def test_a_false_statement_about_functions_is_refuted_at_a_point(name: str) -> None:
    decided(name, *FALSE[name], Verdict.REFUTED)


NOT_PROVED: dict[str, tuple[Formula, tuple[Any, ...]]] = {
    "the root of a square without a sign": (("=", ("sqrt", ("^", "x", 2)), "x"), ()),
    "the square of a root of something negative": (
        ("=", ("^", ("sqrt", ("-", ("^", "x", 2))), 2), ("-", ("^", "x", 2))),
        (),
    ),
    "a power of a sum": (("=", ("pow", ("+", "x", "y"), "n"), ("+", ("pow", "x", "n"), ("pow", "y", "n"))), ()),
    "a constant of another density": (normalised(("/", ("*", 3, ("^", "k", 3)), "pi")), (K,)),
    "an even moment": (("=", ("integral", ("pow", LORENTZ, -2), "x", *WHOLE), 0), (K,)),
    "the order of two functions": (("<", ("exp", "x"), ("exp", ("*", 2, "x"))), ()),
    "an odd moment that need not be finite": (
        ("=", ("integral", ("*", "x", ("pow", LORENTZ, "n")), "x", *WHOLE), 0),
        (K,),
    ),
}


@pytest.mark.parametrize("name", NOT_PROVED)
def test_what_no_theorem_says_is_not_proved(name: str) -> None:
    claim, hypotheses = NOT_PROVED[name]
    assert identity.decide(Problem(name, claim, (), hypotheses)).verdict is not Verdict.PROVED


def test_a_declared_theorem_helps() -> None:
    claim: Formula = ("=>", ("=", ("^", "x", 2), ("^", "y", 2)), ("=", "x", "y"))
    signs = ("signs", ((">=", "x", 0), (">=", "y", 0)))
    method = theorems(("equal_squares", "x", "y"))
    hints = tuple((name, latex) for name, latex in method.hints)
    problem = Problem("squares", claim, (), (signs,), hints)
    assert identity.decide(problem).verdict is Verdict.PROVED


def test_a_proof_does_not_depend_on_what_was_decided_before() -> None:
    signs = ("signs", ((">=", "x", 0), (">=", "y", 0)))
    roots: list[Term] = [("sqrt", ("+", "x", "y")), ("sqrt", ("+", "y", "x"))]
    problems = [Problem("root", (">=", root, 0), (), (signs,)) for root in roots]
    first = [identity.decide(problem).proof for problem in problems]
    again = [identity.decide(problem).proof for problem in reversed(problems)][::-1]
    assert first == again
    assert first[0] != first[1]
