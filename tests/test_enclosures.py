"""Numbers told apart by their digits: intervals against mpmath, statements true and false, forged evidence."""

from __future__ import annotations

import copy
import json
import random
from typing import Any

import mpmath
import pytest

from symcheck.audit.checked import reason as check
from symcheck.checker.enclosures import ONE, between, enclosed
from symcheck.core.calculus import Unknown
from symcheck.core.certificates import Certificate
from symcheck.core.problems import Outcome, Problem
from symcheck.core.terms import INFINITY, PI, Term, node
from symcheck.core.verdicts import Verdict
from symcheck.proof import certificate, identity, proof_of
from symcheck.proof.rules.enclosure import order_of_numbers
from symcheck.proof.rules.nonnegative import Nonnegative
from symcheck.proof.rules.step import written
from symcheck.reading import Letter, Notation, lower, read

LETTERS = Notation([*map(Letter, ("a", "b", "u")), Letter(r"\pi")], decimals="rounded")
ANGLES = (r"a = 67^\circ", r"32^\circ = b")
PRECISE = mpmath.mp.clone()
PRECISE.dps = 120


# --- interval arithmetic


def value(term: Any) -> Any:
    """The value with 120 digits; ArithmeticError or ValueError where there is none."""
    match term:
        case int():
            return PRECISE.mpf(term)
        case ("pi",):
            return +PRECISE.pi
        case ("^", base, n):
            return value(base) ** n
        case ("-", part):
            return -value(part)
        case ("+" | "*" | "/" as sign, left, right):
            a, b = value(left), value(right)
            return a + b if sign == "+" else a * b if sign == "*" else a / b
        case ("pow", base, exponent):
            found = value(base) ** value(exponent)
            if isinstance(found, PRECISE.mpc):
                raise ValueError(term)
            return found
        case (function, inner):
            names = {"arctan": "atan", "arcsin": "asin", "arccos": "acos"}
            found = getattr(PRECISE, names.get(function, function))(value(inner))
            if isinstance(found, PRECISE.mpc):
                raise ValueError(term)
            return found
    raise AssertionError(term)


def some_term(rng: random.Random, depth: int) -> Term:
    if depth == 0:
        return rng.choice([rng.randrange(-9, 10), rng.randrange(1, 400), PI])
    functions = ["sqrt", "exp", "log", "sin", "cos", "tan", "arctan", "arcsin", "arccos", "gamma"]
    kind = rng.choice(["+", "*", "/", "-", "^", "pow", *functions])
    if kind in ("+", "*", "/", "pow"):
        return node(kind, some_term(rng, depth - 1), some_term(rng, rng.randrange(depth)))
    return node(kind, some_term(rng, depth - 1), *([rng.randrange(-3, 5)] if kind == "^" else []))


def test_an_enclosure_contains_the_value_of_every_random_term() -> None:
    rng, met, sharp = random.Random(2005), 0, 0
    for _ in range(3000):
        term = some_term(rng, rng.randrange(1, 5))
        try:
            found = enclosed(term)
        except Unknown:
            continue
        try:
            exact = value(term) * ONE
        except (ArithmeticError, ValueError):
            pytest.fail(f"{term} has no value, but the enclosure {found.low}, {found.high}")
        slack = abs(exact) * PRECISE.mpf(10) ** -100 + PRECISE.mpf(10) ** -60
        assert found.low - slack <= exact <= found.high + slack, term
        met, sharp = met + 1, sharp + (found.high - found.low < ONE >> 100)
    assert met > 1500
    assert sharp > 0.9 * met


FIGURES: dict[str, tuple[Term, Any]] = {  # terms with a bound letter, and their values
    "a sum": (node("sum", node("/", 1, node("^", "k", 2)), "k", 1, 9), PRECISE.mpf(9778141) / 6350400),
    "an empty sum": (node("sum", "k", "k", 1, 0), 0),
    "an empty product": (node("product", "k", "k", 1, 0), 1),
    "a product": (node("product", node("exp", "k"), "k", 1, 4), PRECISE.exp(10)),
    "a sum of integrals": (node("sum", node("integral", node("*", "k", "x"), "x", 0, "k"), "k", 1, 3), 18),
    "a derivative": (node("diff", node("sin", node("^", "x", 2)), "x", 2, 1), 2 * PRECISE.cos(1) - 4 * PRECISE.sin(1)),
    "an integral": (node("integral", node("exp", "x"), "x", 0, 1), PRECISE.e - 1),
    "an integral the other way": (node("integral", node("exp", "x"), "x", 1, 0), 1 - PRECISE.e),
    "an integral to an irrational number": (node("integral", node("sin", "x"), "x", 0, PI), 2),
    "an integral of an inverse": (node("integral", node("/", 1, "x"), "x", 1, 2), PRECISE.log(2)),
    "an integral of a root": (node("integral", node("sqrt", "x"), "x", 1, 4), PRECISE.mpf(14) / 3),
    "an integral of a power": (node("integral", node("pow", "x", node("/", 1, 3)), "x", 1, 8), PRECISE.mpf(45) / 4),
    "an integral in an integral": (
        node("integral", node("*", "x", node("diff", node("exp", "y"), "y", 1, 0)), "x", 0, 2),
        2,
    ),
}


@pytest.mark.parametrize("name", FIGURES)
def test_an_enclosure_contains_the_value_of_a_term_with_a_bound_letter(name: str) -> None:
    term, exact = FIGURES[name]
    found, exact = enclosed(term), exact * ONE
    slack = abs(exact) * PRECISE.mpf(10) ** -100
    assert found.low - slack <= exact <= found.high + slack
    assert found.high - found.low < ONE // 1000  # it tells them from wrong ones
    for wrong in (exact + ONE // 500, exact - ONE // 500):
        assert not found.low <= wrong <= found.high


def test_an_enclosure_contains_the_value_of_every_random_integral() -> None:
    rng, met = random.Random(1687), 0
    while met < 25:
        inner = some_term(rng, 2)
        body = node(rng.choice(["sin", "exp", "arctan", "-"]), node("+", node("*", inner, "x"), rng.randrange(3)))
        low, high = (node("/", rng.randrange(-6, 7), 4) for _ in range(2))
        try:
            found = enclosed(node("integral", body, "x", low, high))
            slope = value(inner)
        except Unknown:
            continue
        function = getattr(PRECISE, {"arctan": "atan", "-": "mpf"}.get(body.tag, body.tag))
        sign = -1 if body.tag == "-" else 1
        if abs(slope) > 50:
            continue
        shift = body.terms[0].terms[1]
        with PRECISE.workdps(40):
            exact = sign * PRECISE.quad(
                lambda x, f=function, a=slope, b=shift: f(a * x + b), PRECISE.linspace(value(low), value(high), 20)
            )
        slack = (abs(exact) + 1) * PRECISE.mpf(10) ** -25
        assert found.low / PRECISE.mpf(ONE) - slack <= exact <= found.high / PRECISE.mpf(ONE) + slack, body
        met += 1


@pytest.mark.parametrize("function", ["exp", "log", "gamma"])
def test_functions_of_positive_numbers_are_known_to_thirty_digits(function: str) -> None:
    for n in [*range(-40 if function == "exp" else 1, 41), 10**40 if function == "log" else 700]:
        term = node(function, node("/", n, 7))
        found, exact = enclosed(term), value(term) * ONE
        assert found.low <= exact + 1, n
        assert exact - 1 <= found.high, n
        assert found.high - found.low < 10**-30 * ONE * (1 + abs(exact) / ONE), n


@pytest.mark.parametrize("function", ["sin", "cos", "tan", "arctan"])
def test_functions_are_known_to_forty_digits_on_both_sides_of_zero(function: str) -> None:
    for n in [*range(-40, 41), 10**4]:
        term = node(function, node("/", n, 7))
        found, exact = enclosed(term), value(term) * ONE
        assert found.low <= exact + 1, n
        assert exact - 1 <= found.high, n
        assert found.high - found.low < 10**-40 * ONE * (1 + abs(exact) / ONE) ** 2, n


HOSTILE: list[Term] = [
    node("/", 1, node("sin", PI)),
    node("/", 1, 0),
    node("^", 0, -1),
    node("^", node("cos", node("/", PI, 2)), -2),
    node("tan", node("/", PI, 2)),
    node("/", 1, node("+", node("^", node("sqrt", 2), 2), node("-", 2))),
    node("sqrt", node("-", 1)),
    node("sqrt", node("-", node("^", node("sin", 1), 2))),
    node("arcsin", 2),
    node("arccos", node("-", node("/", PI, 3))),
    node("sin", node("^", 10, 60)),
    node("sin", node("tan", node("/", node("*", 10**50, PI), node("+", 2 * 10**50, 1)))),
    node("^", node("^", 10, 999), 999),
    node("^", 2, 10**9),
    node("arctan", node("^", 10, 700)),
    node("exp", 10**6),
    node("exp", node("-", 10**6)),
    node("pow", -2, node("/", 1, 2)),
    node("pow", 0, node("/", 1, 2)),
    node("pow", 0, -1),
    node("log", 0),
    node("log", -1),
    node("log", node("sin", PI)),
    node("sum", node("/", 1, "k"), "k", -1, 1),
    node("sum", 1, "k", 1, node("/", 5, 2)),
    node("sum", 1, "k", 1, node("sqrt", 4)),
    node("sum", 1, "k", 1, 10**9),
    node("sum", node("^", 2, -2), "k", 1, INFINITY),
    node("product", "n", "k", 1, 2),
    node("integral", node("/", 1, "x"), "x", -1, 1),
    node("integral", node("/", 1, node("^", "x", 2)), "x", -1, 1),
    node("integral", node("*", 0, node("/", 1, "x")), "x", -1, 1),
    node("integral", node("^", node("/", 1, "x"), 0), "x", -1, 1),
    node("integral", node("tan", "x"), "x", 0, 2),
    node("integral", node("log", "x"), "x", 0, 1),
    node("integral", node("sqrt", "x"), "x", 0, 1),
    node("integral", node("exp", node("-", "x")), "x", 0, INFINITY),
    node("integral", node("call", "f", (0,), "x"), "x", 0, 1),
    node("diff", node("log", "x"), "x", 1, -1),
    node("diff", node("sqrt", node("^", "x", 2)), "x", 1, 0),
    node("integral", node("/", 1, "x"), "x", 0, 1),
    node("sum", 1, "k", 1, 10**4),
    node("gamma", 0),
    node("mean", node("sin", "x"), "x"),
    node("diff", node("sqrt", "x"), "x", 1, 0),
    node("diff", node("sin", 1), "x", 1, "x"),
    node("diff", node("*", 0, node("sqrt", "x")), "x", 1, -1),
    INFINITY,
    "a",
    "sin_pi",
    ("sin", 1, 2),
    ("/", 1, 2, 3),
    node("+"),
    node("^", 2, node("/", 1, 2)),
    (),
]


@pytest.mark.parametrize("term", HOSTILE, ids=str)
def test_what_is_no_number_has_no_enclosure(term: Term) -> None:
    with pytest.raises(Unknown):
        enclosed(term)


ANALYTIC: list[tuple[Term, object]] = [
    (node("exp", 1), PRECISE.e),
    (node("exp", -30), PRECISE.exp(-30)),
    (node("log", 7), PRECISE.log(7)),
    (node("log", node("/", 1, 10**9)), PRECISE.log(PRECISE.mpf(10) ** -9)),
    (node("pow", 2, node("/", 1, 2)), PRECISE.sqrt(2)),
    (node("pow", node("/", 3, 7), PI), (PRECISE.mpf(3) / 7) ** PRECISE.pi),
    (node("diff", node("sin", "x"), "x", 1, 1), PRECISE.cos(1)),
    (node("diff", node("exp", node("^", "x", 2)), "x", 1, 1), 2 * PRECISE.e),
    (node("integral", node("/", 1, "x"), "x", 1, 2), PRECISE.log(2)),
    (node("integral", node("/", 1, "x"), "x", 2, 1), -PRECISE.log(2)),
    (node("sum", node("/", 1, "k"), "k", 1, 10), PRECISE.mpf(7381) / 2520),
    (node("sum", "k", "k", 1, 0), PRECISE.mpf(0)),
    (node("product", "k", "k", 1, 6), PRECISE.mpf(720)),
]


@pytest.mark.parametrize(("term", "exact"), ANALYTIC, ids=str)
def test_an_enclosure_of_analysis_contains_the_value(term: Term, exact: Any) -> None:
    found, slack = enclosed(term), PRECISE.mpf(10) ** -50 * ONE
    assert found.low <= exact * ONE + slack
    assert exact * ONE - slack <= found.high
    assert found.high - found.low < 10**-4 * ONE * max(1, abs(exact))


def test_decimals_are_rounded_outward() -> None:
    assert between(PI, 3) == (node("/", 3141, 1000), node("/", 3142, 1000))
    assert between(node("-", PI), 0) == (node("/", -4, 1), node("/", -3, 1))
    assert between(node("/", 5, 4), 2) == (node("/", 125, 100), node("/", 125, 100))
    for digits in (-1, 41, 10**9):
        with pytest.raises(Unknown):
            between(PI, digits)


# --- statements


def problem(latex: str, given: tuple[str, ...] = ANGLES, **definitions: Term) -> Problem:
    (claim,) = lower(read(latex, LETTERS), LETTERS)
    hypotheses = tuple((f"given {k}", lower(read(each, LETTERS), LETTERS)) for k, each in enumerate(given))
    return Problem("number", claim, tuple(definitions.items()), hypotheses)


def decided(question: Problem) -> tuple[Outcome, Certificate | None]:
    outcome = identity.decide(question)
    if outcome.verdict is Verdict.UNDECIDED:
        return outcome, None
    return outcome, json.loads(json.dumps(certificate(question, outcome)))


TRUE = [
    (r"4 \sin a \sin b \approx 1.951", ANGLES),
    (r"4 \sin a \sin b = 1.951", ANGLES),
    (r"-2 \sin a \cos b = -1.561", ANGLES),
    (r"1.951 \approx 1.951", ()),
    (r"4 \sin 67^\circ \cos 32^\circ = 3.123", ()),
    (r"\operatorname{arctg} \sqrt{2} = 54.7^\circ", ()),
    (r"\operatorname{arctg} \frac{5}{8} \approx 32^\circ", ()),
    (r"\operatorname{arctg} \frac{5}{8} \ne 32^\circ", ()),
    (r"\operatorname{arctg} \frac{5}{8} > 32^\circ", ()),
    (r"32^\circ < \operatorname{arctg} \frac{5}{8}", ()),
    (r"\arcsin \frac{2}{\sqrt{7}} \approx 49.1^\circ", ()),
    (r"\arccos \frac{1}{\sqrt{6}} \approx 65.9^\circ", ()),
    (r"a \approx 67^\circ", (r"a = \operatorname{arctg} \frac{2}{\cos b}", r"b = \operatorname{arctg} \frac{5}{8}")),
    (r"\operatorname{tg} a = 2.36", ANGLES),
    (r"\frac{1}{\sqrt{1 - \sin^2 a \cos^2 b}} \approx 1.60", ANGLES),
    (r"\frac{2}{\cos 32^\circ} \approx 2.36", ()),
    (r"\frac{180}{\pi} \operatorname{arctg} \frac{5}{8} = 32.0", ()),
    (r"\sqrt{2} = 1.41 \land \sqrt{3} = 1.73 \land \sqrt{2} \ne \sqrt{3}", ()),
]


@pytest.mark.parametrize(("latex", "given"), TRUE)
def test_a_true_statement_about_numbers_is_proved(latex: str, given: tuple[str, ...]) -> None:
    outcome, evidence = decided(problem(latex, given))
    assert outcome.verdict is Verdict.PROVED
    assert evidence is not None
    assert check(evidence) is None


FALSE = [
    (r"4 \sin a \sin b \approx 1.952", ANGLES),
    (r"4 \sin a \sin b = -1.951", ANGLES),
    (r"4 \cos a \sin b = 1.951", ANGLES),
    (r"4 \sin a \cos b = 1.951", ANGLES),
    (r"4 \sin 67^\circ \cos 32^\circ = 1.951", ()),
    (r"\operatorname{arctg} \sqrt{2} = 54.8^\circ", ()),
    (r"\operatorname{arctg} \frac{5}{8} = 32^\circ", ()),
    (r"\operatorname{arctg} \frac{5}{8} < 32^\circ", ()),
    (r"\arccos \frac{1}{\sqrt{6}} \approx 66.0^\circ", ()),
    (r"a \approx 68^\circ", (r"a = \operatorname{arctg} \frac{2}{\cos b}", r"b = \operatorname{arctg} \frac{5}{8}")),
    (r"\operatorname{tg} a = 2.37", (*ANGLES, r"\sin a > 0 \land u = 1")),
    (r"\sqrt{2} = 1.41 \land \sqrt{3} = 1.72", ()),
    (r"\sqrt{2} = 1.42 \lor \sqrt{3} = 1.72", ()),
    (r"\sqrt{2} = 1.41 \Rightarrow \sqrt{3} = 1.72", ()),
    (r"\sqrt{2} = 1.41 \Leftrightarrow \sqrt{3} = 1.72", ()),
    (r"4 \sin a \sin b = 1.951", ANGLES[:1]),
    (r"4 \sin a \sin b = 1.951", ()),
    (r"\operatorname{arctg} u < u", (r"u \ge 0 \lor u < -2",)),
]


@pytest.mark.parametrize(("latex", "given"), FALSE)
def test_a_false_statement_about_numbers_is_refuted(latex: str, given: tuple[str, ...]) -> None:
    outcome, evidence = decided(problem(latex, given))
    assert outcome.verdict is Verdict.REFUTED
    assert evidence is not None
    assert check(evidence) is None


def test_the_counterexample_shows_the_numbers_that_decide() -> None:
    outcome, _ = decided(problem(r"4 \sin a \sin b \approx 1.952"))
    assert outcome.point is not None
    assert set(outcome.point.values) == {"a", "b"}
    ((term, low, high),) = outcome.point.enclosed
    assert term == node("*", 4, node("sin", "a"), node("sin", "b"))
    assert (low, high) == (node("/", 1951173, 10**6), node("/", 1951174, 10**6))


def test_a_letter_may_be_defined_instead() -> None:
    for latex, verdict in ((r"2 \sin a = 1.84", Verdict.PROVED), (r"2 \sin a = 1.85", Verdict.REFUTED)):
        outcome, evidence = decided(problem(latex, (), a=node("/", node("*", 67, PI), 180)))
        assert outcome.verdict is verdict
        assert evidence is not None
        assert check(evidence) is None


def test_every_other_digit_of_a_cell_is_refuted() -> None:
    for k, digit in enumerate("1951"):
        for other in set("0123456789") - {digit}:
            text = "1951"[:k] + other + "1951"[k + 1 :]
            outcome, evidence = decided(problem(rf"4 \sin a \sin b = {text[0]}.{text[1:]}"))
            assert outcome.verdict is Verdict.REFUTED, text
            assert evidence is not None
            assert check(evidence) is None, text


NEAR = 11071487177940905030170654601785370400  # arctan 2 lies between this and the next over 10^37


UNDECIDED = [
    node("<=", node("arctan", 2), node("/", NEAR + 1, 10**37)),
    node(">", node("arctan", 2), node("/", NEAR + 1, 10**37)),
    node("!=", node("arctan", 2), node("/", NEAR, 10**37)),
    node("<", node("/", 1, node("sin", PI)), 1),
    node(">", node("sqrt", node("-", 1)), 1),
    node("<", node("tan", node("/", PI, 2)), 1),
    node("<", node("sin", node("^", 10, 80)), node("/", 1, 2)),
    node("<", 0, node("/", PI, node("+", node("^", node("sqrt", 5), 2), node("-", 5)))),
    node("=", node("cos", node("/", PI, 5)), node("/", node("+", 1, node("sqrt", 5)), 4)),
]


@pytest.mark.parametrize("claim", UNDECIDED, ids=str)
def test_what_is_too_close_or_no_number_is_not_decided_by_digits(claim: Any) -> None:
    outcome, _ = decided(Problem("number", claim))
    assert outcome.verdict is Verdict.UNDECIDED


def test_the_sine_of_half_a_turn_is_known_without_digits() -> None:
    for sign, verdict in (("=", Verdict.PROVED), ("!=", Verdict.REFUTED)):
        outcome, evidence = decided(Problem("number", node(sign, node("sin", PI), 0)))
        assert outcome.verdict is verdict
        assert evidence is not None
        assert check(evidence) is None


def test_an_exact_half_rounds_both_ways() -> None:
    for latex in (r"\frac{\sqrt{4}}{16} = 0.12", r"\frac{\sqrt{4}}{16} = 0.13"):
        outcome, evidence = decided(problem(latex, ()))
        assert outcome.verdict is Verdict.PROVED
        assert evidence is not None
        assert check(evidence) is None


def test_contradictory_hypotheses_refute_nothing() -> None:
    outcome, _ = decided(problem(r"\operatorname{tg} a = 2.37", (*ANGLES, r"\sin a < 0")))
    assert outcome.verdict is not Verdict.REFUTED


def test_an_order_of_numbers_inside_a_larger_proof() -> None:
    less = node("<", node("arcsin", node("/", node("sqrt", 2), 2)), node("arcsin", node("/", 2, node("sqrt", 7))))
    found = order_of_numbers(less, {})
    assert found is not None
    assert claimed(less, json.loads(written(found))) is None
    assert order_of_numbers(node(">", *less[1:]), {}) is None
    assert order_of_numbers(node("<", "a", PI), {}) is None


# --- forged evidence


def plain(value: Any) -> Any:
    return json.loads(json.dumps(value))


def theorem(t: Any, digits: Any, **numbers: Any) -> Certificate:
    """The step of a proof that encloses a number, its letters being what the hypothesis says."""
    premises = [{"rule": "identity", "cofactors": [[["hyp", "given", k], "1"]]} for k, _ in enumerate(numbers)]
    given = {"with": {"t": t, "digits": digits}, "numbers": numbers}
    return {"rule": "theorem", "of": "enclosure", **given, "premises": premises}


def claimed(claim: Any, by: Certificate, *given: Any) -> str | None:
    hypotheses = {"given": [*given]} if given else {}
    stated = {"id": "n", "verdict": "proved", "claim": claim, "definitions": [], "hypotheses": hypotheses}
    made = {**stated, "proof": by, "witnesses": [{"values": {"a": A}}] if given else []}
    return check(plain(made))


SINE, A = ["sin", "a"], ["/", ["*", 67, ["pi"]], 180]


def above(t: Any, low: Any, rest: Any) -> Certificate:
    return {"rule": "nonnegative", "form": ["+", ["+", t, ["-", low]], rest], "cofactors": []}


def test_a_proof_by_enclosure_holds_and_its_forgeries_do_not() -> None:
    low, rest, bound = ["/", 92, 100], ["/", 1, 100], ["/", 91, 100]  # sin 67 degrees = 0.9205...
    claim, given = [">", SINE, bound], ["=", "a", A]
    step = {**theorem(SINE, 2, a=A), "then": above(SINE, low, rest)}
    assert claimed(claim, step, given) is None

    other = ["=", "a", ["/", ["*", 68, ["pi"]], 180]]
    assert claimed(claim, step, other), "the premise is another equation"
    assert claimed(claim, step | {"premises": []}, given), "no premise"
    assert claimed(claim, step | {"numbers": {}, "premises": []}, given), "a letter that stands for nothing"
    assert claimed(claim, step | {"numbers": {"b": A}}, given), "another letter"
    assert claimed(claim, step, [">=", "a", A]), "no equation"
    assert claimed([">", SINE, ["/", 92, 100]], step, given), "more than is known with two digits"
    assert claimed([">", SINE, ["/", 93, 100]], {**step, "then": above(SINE, ["/", 93, 100], 0)}, given), "false"
    assert claimed(["<", SINE, bound], step, given), "the other order"
    assert claimed([">", ["cos", "a"], bound], step, given), "another function"
    assert claimed([">", ["sin", "b"], bound], step, given), "another letter"


@pytest.mark.parametrize("term", [term for term in HOSTILE if term != node("+")], ids=str)  # to the checker that is 0
def test_no_proof_encloses_what_is_no_number(term: Any) -> None:
    low, claim = ["/", -(10**6), 1], [">", term, ["/", -(10**7), 1]]
    step = {**theorem(plain(term), 0), "then": above(plain(term), low, 9 * 10**6)}
    assert claimed(claim, step)
    stated = {"id": "n", "definitions": [], "hypotheses": {}, "claim": ["<", term, low]}
    assert check(plain({**stated, "verdict": "refuted", "point": {"values": {}}}))


def refuted() -> Certificate:
    _, evidence = decided(problem(r"4 \sin a \sin b \approx 1.952"))
    assert evidence is not None
    return evidence


def test_forged_points_are_rejected() -> None:
    assert check(refuted()) is None

    def forged(change: Any) -> str | None:
        made = copy.deepcopy(refuted())
        change(made)
        return check(made)

    degrees = ["/", ["*", 68, ["pi"]], 180]
    assert forged(lambda c: c["point"]["values"].update(a=degrees)), "the hypothesis is false there"
    assert forged(lambda c: c["point"]["values"].pop("a")), "a letter without a value"
    assert forged(lambda c: c["point"]["values"].update(a="a")), "a letter that is itself"
    assert forged(lambda c: c["point"]["values"].update(a="u")), "a letter that is another"
    assert forged(lambda c: c["point"]["values"].update({"sin(a)": 1})), "the sine of an angle beside it"
    assert forged(lambda c: c["point"]["values"].update({"[pi]": 3})), "a constant"
    assert forged(lambda c: c["point"]["values"].update(pi=3, sin_a=1)) is None, "letters that say nothing of these"
    assert forged(lambda c: c["point"]["shown"][0][1].__setitem__(1, ["/", 1951174, 10**6])), "other digits"
    assert forged(lambda c: c["hypotheses"].update(more=[["<", ["sin", "a"], 0]])), "a hypothesis that is false there"
    assert forged(lambda c: c["hypotheses"].update(more=[["<", "u", 0]])), "a hypothesis about another letter"
    assert forged(lambda c: c.update(claim=["<=", ["/", 1951, 1000], c["claim"][1][2]])), "a claim that is true"
    assert forged(lambda c: c.update(claim=["=", ["sin", ["pi"]], 0])), "another claim that is true"


def test_irrational_numbers_at_a_point_are_compared_by_digits() -> None:
    values = {"a": ["*", 2, ["arctan", ["/", 1, 3]]], "u": ["*", ["/", -3, 2500], ["sqrt", 3]]}
    given = {"given": [["=", "u", ["-", ["/", ["*", 2, ["sqrt", 3], SINE], 1000]]]]}
    low, high = ["/", 13, 4000], ["/", 67, 20000]

    def at(claim: Any, *true: bool) -> str | None:
        shown = [part if so else ["=>", part, ["or"]] for part, so in zip(claim[1:], true, strict=True)]
        stated = {"id": "n", "verdict": "refuted", "claim": claim, "definitions": [], "hypotheses": given}
        return check({**stated, "point": {"values": values, "shown": shown}})

    assert at(["and", ["<=", low, ["-", "u"]], ["<=", ["-", "u"], high]], False, True) is None
    assert at(["and", ["<=", low, ["-", "u"]], ["<=", ["-", "u"], high]], True, False)
    assert at(["and", ["<=", "u", high], ["<=", low, ["+", "u", SINE]]], True, True)
    assert at(["and", ["<=", "u", high], ["<", ["+", "u", SINE], low]], True, False) is None


def test_the_sine_of_a_number_is_not_chosen_at_a_point() -> None:
    for claim, values in (
        (["=", ["sin", ["pi"]], 0], {"sin_pi": ["/", 3, 5], "cos_pi": ["/", 4, 5]}),
        (["<", ["sin", ["/", ["*", 67, ["pi"]], 180]], 1], {"sin_pi": 1, "cos_pi": 0}),
    ):
        stated = {"id": "n", "verdict": "refuted", "claim": claim, "definitions": [], "hypotheses": {}}
        for shown in ({}, {"shown": [["=", claim[1], ["/", 3, 5]], ["=", claim[2], 0]]}):
            assert check({**stated, "point": {"values": values, **shown}})


def test_parts_of_a_turn_are_angles_of_their_own() -> None:
    """What follows for every angle follows for them; nothing else does."""
    sine, cosine = (["^", [f, A], 2] for f in ("sin", "cos"))
    by = {"rule": "identity", "cofactors": []}
    assert claimed(["=", ["+", sine, cosine], 1], by) is None
    assert claimed(["=", sine, cosine], by)
    assert claimed(["=", ["sin", ["/", ["pi"], 2]], 1], by) is None, "a quarter of a turn is known"
    assert claimed(["=", ["sin", ["/", ["pi"], 2]], ["cos", ["/", ["pi"], 2]]], by)
    half = ["sin", ["/", "x", 2]]
    assert claimed(["=", half, half], by) is None
    assert claimed(["=", half, ["sin", "x"]], by), "half of a letter"


def test_other_statements_are_not_touched() -> None:
    assert order_of_numbers(node("<", node("/", 1, 3), node("/", 1, 2)), {}) is None
    rational = Problem("number", node("<", "x", 2), (), (("x", (node("=", "x", 1),)),))
    outcome = proof_of(rational)
    assert outcome is not None
    assert outcome.proof is not None
    assert isinstance(outcome.proof.step.step, Nonnegative)
