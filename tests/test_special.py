"""Special functions by their letters: the relations of each family against mpmath, and what is decided with them."""

from __future__ import annotations

import ast
import random
import re
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import mpmath
import pytest
from handbook import pairs

from symcheck import decide
from symcheck.checker.enclosures import ONE, enclosed
from symcheck.core.calculus import substituted
from symcheck.core.terms import node
from symcheck.question.answer import Status
from symcheck.question.special import FAMILIES, INTEGRALS, JOINED, NAMED, written

TRUTH: dict[str, Callable[[Any, Any], Any]] = {
    "P": mpmath.legendre,
    "T": mpmath.chebyt,
    "U": mpmath.chebyu,
    "H": mpmath.hermite,
    "He": lambda n, x: 2 ** (-n / 2) * mpmath.hermite(n, x / mpmath.sqrt(2)),
    "L": lambda n, x: mpmath.laguerre(n, 0, x),
    "J": mpmath.besselj,
    "Y": mpmath.bessely,
    "I": mpmath.besseli,
    "K": mpmath.besselk,
    "j": lambda n, x: mpmath.sqrt(mpmath.pi / (2 * x)) * mpmath.besselj(n + mpmath.mpf(1) / 2, x),
    "y": lambda n, x: mpmath.sqrt(mpmath.pi / (2 * x)) * mpmath.bessely(n + mpmath.mpf(1) / 2, x),
    "Li": mpmath.polylog,
    "Ai": lambda n, x: mpmath.airyai(x),
    "Bi": lambda n, x: mpmath.airybi(x),
    "Si": lambda n, x: mpmath.si(x),
    "Ci": lambda n, x: mpmath.ci(x),
    "Ei": lambda n, x: mpmath.ei(x),
    "Shi": lambda n, x: mpmath.shi(x),
    "Chi": lambda n, x: mpmath.chi(x),
    "Dawson": lambda n, x: mpmath.sqrt(mpmath.pi) / 2 * mpmath.exp(-(x**2)) * mpmath.erfi(x),
    "K_of_k": lambda n, x: mpmath.ellipk(x**2),
    "E_of_k": lambda n, x: mpmath.ellipe(x**2),
    "K_of_m": lambda n, x: mpmath.ellipk(x),
    "E_of_m": lambda n, x: mpmath.ellipe(x),
}
RELATIONS = [text for family in (*FAMILIES, *JOINED) for text in family.relations]
SCALED = {text: family.scaled for family in JOINED for text in family.relations}
DECLARED = {
    "J": "Bessel function of the first kind", "I": "modified Bessel function of the first kind",
    "P": "Legendre polynomial", "H": "Hermite polynomial", "L": "Laguerre polynomial",
    "T": "Chebyshev polynomial of the first kind", "U": "Chebyshev polynomial of the second kind",
}  # fmt: skip


def value(tree: ast.expr, n: Any, x: Any) -> Any:
    """The value of a side of a relation at an order and an argument."""
    match tree:
        case ast.Constant(value=number):
            return number
        case ast.Name(id=name):
            return {"n": n, "x": x, "pi": mpmath.pi}[name]
        case ast.UnaryOp(operand=inner):
            return -value(inner, n, x)
        case ast.BinOp(op=op, left=left, right=right):
            a, b = value(left, n, x), value(right, n, x)
            done = {"Add": lambda: a + b, "Sub": lambda: a - b, "Mult": lambda: a * b, "Div": lambda: a / b}
            return a**b if isinstance(op, ast.Pow) else done[type(op).__name__]()
        case ast.Call(func=ast.Name(id="d"), args=[inner]):
            return mpmath.diff(lambda t: value(inner, n, t), x)
        case ast.Call(func=ast.Name(id=name), args=[inner]) if name in TRUTH:
            return TRUTH[name](value(inner, n, x), x)
        case ast.Call(func=ast.Name(id=name), args=[inner]):
            return getattr(mpmath, name)(value(inner, n, x))
    raise AssertionError(ast.dump(tree))


@pytest.mark.parametrize("text", RELATIONS)
def test_a_relation_of_a_family_holds(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    rng, tree = random.Random(text), ast.parse(text, mode="eval").body
    assert isinstance(tree, ast.Compare)
    whole = re.match(r".*\b(?:P|T|U|H|He|L|Li|j|y)\(", text)
    for letter in SCALED.get(text, ()):
        known = TRUTH[letter]
        monkeypatch.setitem(TRUTH, letter, lambda n, x, known=known: mpmath.pi * known(n, x))
    with mpmath.workdps(30):
        for _ in range(4):
            n = mpmath.mpf(rng.randrange(1, 6)) + (0 if whole else mpmath.mpf(rng.randrange(10)) / 10)
            x = mpmath.mpf(rng.randrange(2, 30)) / 31
            left, right = (value(side, n, x) for side in (tree.left, tree.comparators[0]))
            assert abs(left - right) < 1e-12 * (1 + abs(left)), (n, x)


@pytest.mark.parametrize("family", FAMILIES, ids=lambda family: "_".join(family.names))
def test_members_that_are_known_and_those_after_them_are_right(family: Any) -> None:
    with mpmath.workdps(30):
        x = mpmath.mpf(17) / 31
        for (letter, order), text in family.first.items():
            known = value(ast.parse(text, mode="eval").body, order, x)
            assert abs(known - TRUTH[letter](mpmath.mpf(order.numerator) / order.denominator, x)) < 1e-20
        for letter, text in family.step.items():
            after = value(ast.parse(text, mode="eval").body, 3, x)
            assert abs(after - TRUTH[letter](4, x)) < 1e-15 * (1 + abs(after))
        for letter, sign in family.mirrored.items():
            for n in range(4):
                assert abs(TRUTH[letter](-n, x) - sign**n * TRUTH[letter](n, x)) < 1e-20


@pytest.mark.parametrize("family", [each for each in FAMILIES if each.slopes], ids=lambda each: "_".join(each.names))
def test_the_derivative_of_a_member_is_as_it_is_written_out(family: Any) -> None:
    with mpmath.workdps(30):
        for letter, (order, text) in family.slopes.items():
            for x in (mpmath.mpf(2) / 7, mpmath.mpf(3) / 4):
                slope = mpmath.diff(lambda t, letter=letter: TRUTH[letter](2, t), x, order)
                assert abs(slope - value(ast.parse(text, mode="eval").body, 2, x)) < 1e-10, letter


INTEGRANDS: dict[str, Callable[..., Any]] = {
    "J": lambda n, x, t: mpmath.cos(n * t - x * mpmath.sin(t)),
    "I": lambda n, x, t: mpmath.exp(x * mpmath.cos(t)) * mpmath.cos(n * t),
    "K_of_k": lambda n, x, t: mpmath.pi / 2 / mpmath.sqrt(1 - (x * mpmath.sin(t)) ** 2),
    "E_of_k": lambda n, x, t: mpmath.pi / 2 * mpmath.sqrt(1 - (x * mpmath.sin(t)) ** 2),
    "K_of_m": lambda n, x, t: mpmath.pi / 2 / mpmath.sqrt(1 - x * mpmath.sin(t) ** 2),
    "E_of_m": lambda n, x, t: mpmath.pi / 2 * mpmath.sqrt(1 - x * mpmath.sin(t) ** 2),
}


@pytest.mark.parametrize("letter", INTEGRALS)
@pytest.mark.parametrize("n", range(3))
def test_a_member_of_whole_order_is_its_integral(letter: str, n: int) -> None:
    x = mpmath.mpf(3) / 5
    found = mpmath.quad(lambda t: INTEGRANDS[letter](n, x, t), [0, mpmath.pi]) / mpmath.pi
    assert abs(found - TRUTH[letter](n, x)) < 1e-12
    term = written(letter, next(name for name, (x, _) in NAMED.items() if x == letter), Fraction(n))
    assert term is not None
    enclosure = enclosed(substituted(term, {"x": node("/", 3, 5)}))
    assert enclosure.low <= found * ONE <= enclosure.high
    assert enclosure.high - enclosure.low < ONE / 1000


SPECIAL = [pair for pair in pairs() if pair[0].letters and pair[0].family.startswith("5")]


def test_there_are_relations_of_special_functions() -> None:
    assert len(SPECIAL) >= 30
    assert {name for pair in SPECIAL for _, name in pair[0].letters} <= {*NAMED}


def test_what_is_false_of_a_special_function_is_not_refuted_where_nobody_says_that_it_is_meant() -> None:
    for _, wrong in [pair for pair in SPECIAL if "d}{d" not in pair[1].relation][::15]:
        assert decide(wrong.relation, given=wrong.given).verdict in ("ambiguous", "undecided", "unreadable")


OTHERS = {
    r"P_1(x) = 2x": "ambiguous or undecided: a first member may be anything",
    r"T_2 = 2 T_1": "no arguments",
    r"P_n(x) = x^n": "it may be a power",
    r"J_m(q) = q": "a mass matrix",
}


@pytest.mark.parametrize("relation", OTHERS)
def test_letters_that_mean_something_else_are_not_refuted(relation: str) -> None:
    assert decide(relation).verdict not in ("refuted", "proved")


def test_what_a_letter_is_said_to_be_is_shown() -> None:
    answer = decide(r"P_2(x) = \frac{3x^2 - 1}{2}", letters={"P_n": "Legendre polynomials"})
    assert answer.verdict == "proved"
    assert answer.letters["P_2"] == "a Legendre polynomial (said so)"
    assert decide(r"P_2(x) = \frac{3x^2 - 1}{2}").letters["P_2"] == "a Legendre polynomial (its usual letter)"


def test_a_definition_takes_precedence_over_the_usual_meaning_of_a_letter() -> None:
    assert decide(r"P_2(x) = \frac{3x^2 - 1}{2}", "P_2(x) = x^2").verdict == "refuted"


def test_hermite_polynomials_are_those_that_are_said() -> None:
    relation = r"H_2(x) = x^2 - 1"
    assert decide(relation, letters={"H": "probabilist's Hermite polynomial"}).verdict == "proved"
    assert decide(relation, letters={"H": "Hermite polynomial"}).verdict == "refuted"
    assert decide(relation).verdict not in ("proved", "refuted")


def test_a_bracket_behind_a_function_with_a_factor_after_it_raises_a_doubt() -> None:
    """sin(n+1)x is often meant for the sine of the product."""
    letters = {"U": "Chebyshev polynomial of the second kind"}
    short = r"U_n(\cos\theta) = \frac{\sin(n+1)\theta}{\sin\theta}"
    answer = decide(short, given=r"n \in \mathbb{N}", letters=letters)
    assert (answer.verdict, "brackets" in answer.reason) == (Status.AMBIGUOUS, True)
    clear = short.replace(r"\sin(n+1)\theta", r"\sin((n+1)\theta)")
    assert decide(clear, given=r"n \in \mathbb{N}", letters=letters).verdict is Status.PROVED


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        (
            r"\operatorname{Si}''(x) = \frac{x\cos x - \sin x}{x^2}",
            r"\operatorname{Si}''(x) = \frac{x\cos x + \sin x}{x^2}",
        ),
        (r"\operatorname{Ai}'''(x) = x\operatorname{Ai}'(x) + \operatorname{Ai}(x)", ""),
        (r"\operatorname{Ai}(x)\operatorname{Bi}'(x) - \operatorname{Ai}'(x)\operatorname{Bi}(x) = \frac{1}{\pi}", ""),
        (r"\operatorname{Li}_2'(x) = -\frac{\ln(1-x)}{x}", r"\operatorname{Li}_2'(x) = \frac{\ln(1-x)}{x}"),
        (r"\operatorname{Li}_1(x) = -\ln(1-x)", r"\operatorname{Li}_1(x) = \ln(1-x)"),
        (r"\operatorname{Li}_{n+1}'(x) = \frac{\operatorname{Li}_n(x)}{x}", ""),
    ],
)
def test_functions_with_names_of_their_own_are_known_by_their_derivatives(right: str, wrong: str) -> None:
    assert decide(right, given="0 < x < 1").verdict is Status.PROVED
    if wrong:
        assert decide(wrong, given="0 < x < 1").verdict is Status.REFUTED


def test_what_functions_with_names_of_their_own_are_not_is_not_proved() -> None:
    for wrong in (
        r"\operatorname{Ai}''(x) = -x\operatorname{Ai}(x)",
        r"\operatorname{Si}(x) = \sin x",
        r"\operatorname{Li}_3'(x) = \operatorname{Li}_2(x)",
        r"\operatorname{Ei}'(x) = \operatorname{Ei}(x)",
    ):
        assert decide(wrong, given="0 < x < 1").verdict is not Status.PROVED


def test_elliptic_integrals_are_those_of_the_modulus_or_of_the_parameter() -> None:
    relation = r"E'(k) = \frac{E(k) - K(k)}{k}"
    for of, verdict in (("modulus", Status.PROVED), ("parameter", Status.REFUTED)):
        letters = {
            x: f"complete elliptic integral of the {which} kind of the {of}"
            for x, which in (("K", "first"), ("E", "second"))
        }
        assert decide(relation, given="0 < k < 1", letters=letters).verdict is verdict
    answer = decide(relation, letters={"E": "complete elliptic integral of the second kind"})
    assert (answer.verdict, "say which" in answer.reason) == (Status.UNREADABLE, True)


BESSEL = {"J": "Bessel function of the first kind", "Y": "Bessel function of the second kind"}
EQUATION = r"x^2\frac{d^2y}{dx^2} + x\frac{dy}{dx} + (a^2x^2-\nu^2)y = 0"


@pytest.mark.parametrize("letters", [BESSEL, {}])
def test_a_member_that_a_letter_is_defined_as_is_known(letters: dict[str, str]) -> None:
    """The equation was refuted, as if J_\\nu were any function."""
    assert decide(EQUATION, r"y = J_\nu(ax)", "x > 0", letters).verdict is Status.PROVED
    wrong = decide(EQUATION.replace("a^2x^2-", "a^2x^2+"), r"y = J_\nu(ax)", "x > 0", letters).verdict
    assert wrong is (Status.REFUTED if letters else Status.AMBIGUOUS)


def test_functions_without_arguments_are_of_the_letter_by_which_they_are_differentiated() -> None:
    """The first one was refuted, with numbers for K and E."""
    letters = {
        x: f"complete elliptic integral of the {which} kind of the modulus"
        for x, which in (("K", "first"), ("E", "second"))
    }
    right = r"\frac{dK}{dk} = \frac{E - (1-k^2)K}{k(1-k^2)}"
    assert decide(right, given="0 < k < 1", letters=letters).verdict is Status.PROVED
    wrong = right.replace("(1-k^2)}", "(1+k^2)}")
    assert decide(wrong, given="0 < k < 1", letters=letters).verdict is Status.REFUTED
    assert decide(r"E - K = k^2 E", given="0 < k < 1", letters=letters).verdict not in ("proved", "refuted")


def test_what_is_said_to_be_a_known_function_is_no_number() -> None:
    answer = decide("y'' = 0", "y = J_0 x", letters={"J": BESSEL["J"]})
    assert (answer.verdict, "nothing is known here" in answer.reason) == (Status.AMBIGUOUS, True)


@pytest.mark.parametrize(
    ("right", "wrong", "letters"),
    [
        (
            r"J_{\nu+1}(x)Y_\nu(x) - J_\nu(x)Y_{\nu+1}(x) = \frac{2}{\pi x}",
            r"J_{\nu+1}(x)Y_\nu(x) - J_\nu(x)Y_{\nu+1}(x) = -\frac{2}{\pi x}",
            BESSEL,
        ),
        (
            r"J_\nu(x)Y_\nu'(x) - J_\nu'(x)Y_\nu(x) = \frac{2}{\pi x}",
            r"J_\nu(x)Y_\nu'(x) - J_\nu'(x)Y_\nu(x) = \frac{1}{\pi x}",
            BESSEL,
        ),
        (
            r"I_\nu(x)K_{\nu+1}(x) + I_{\nu+1}(x)K_\nu(x) = \frac1x",
            r"I_\nu(x)K_{\nu+1}(x) + I_{\nu+1}(x)K_\nu(x) = \frac2x",
            {"I": "modified Bessel function of the first kind", "K": "modified Bessel function of the second kind"},
        ),
        (
            r"\frac{d}{dx}J_0(ax) = -aJ_1(ax)",
            r"\frac{d}{dx}J_0(ax) = aJ_1(ax)",
            BESSEL,
        ),
        (
            r"He_{n+1}(x) = xHe_n(x) - nHe_{n-1}(x)",
            r"He_{n+1}(x) = xHe_n(x) - 2nHe_{n-1}(x)",
            {"He": "probabilist's Hermite polynomial"},
        ),
    ],
)
def test_functions_of_several_families_and_of_multiples_are_related(
    right: str, wrong: str, letters: dict[str, str]
) -> None:
    assert decide(right, given="x > 0", letters=letters).verdict is Status.PROVED
    assert decide(wrong, given="x > 0", letters=letters).verdict is Status.REFUTED


OTHERS = {  # what equations say otherwise than names do
    r"P_2(x) = \frac{3 x^2 - 1}{2}": r"P_2(x) = \frac{d^2}{dx^2} \frac{(x^2 - 1)^2}{4}",
    "T_2(x) = 2 x^2 - 1": "T_2(x) = x^2 - 1",
    "H_3(x) = 8 x^3 - 12 x": "H_{n+1}(x) = x H_n(x) - n H_{n-1}(x); H_0(x) = 1; H_1(x) = x",
    "J_0(0) = 1": r"J_0(x) = 2 \cos x",
    "M(a, b, z) = e^z M(b - a, b, -z)": "M(a, b, z) = a + b + z",
    r"\frac{d}{dx}\operatorname{erf}(x) = \frac{2}{\sqrt\pi} e^{-x^2}": r"\operatorname{erf}(x) = \int_0^x e^{-t^2} dt",
}


@pytest.mark.parametrize(("relation", "where"), OTHERS.items())
def test_what_an_equation_says_of_a_letter_goes_before_its_usual_meaning(relation: str, where: str) -> None:
    assert decide(relation).verdict != "refuted"
    assert decide(relation, where=where.split("; ")).verdict != "proved"
