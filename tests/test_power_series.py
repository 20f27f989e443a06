"""Hypergeometric functions: what is said of their coefficients against mpmath, and what is decided by that."""

from __future__ import annotations

import random
from fractions import Fraction

import mpmath
import pytest

from symcheck import decide
from symcheck.core.calculus import letters, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import INFINITY, Binder, Node, Relation, Term, node
from symcheck.proof.algebra.forms import number_term
from symcheck.proof.algebra.polynomial import number_of
from symcheck.question.ask import decided_one
from symcheck.question.power_series import as_sums, by_coefficients, terminated, with_letters
from symcheck.question.prepare import Asked, plainly

F, G, D = "{}_2F_1", "{}_1F_1", r"\frac{d}{dz}"
PAIRS = {  # each with a slip
    rf"{D} {F}(a,b;c;z) = \frac{{ab}}{{c}} {F}(a+1,b+1;c+1;z)": rf"{D} {F}(a,b;c;z) = \frac{{ab}}{{c}} {F}(a+1,b+1;c;z)",  # noqa: E501
    rf"{D} {G}(a;b;z) = \frac{{a}}{{b}} {G}(a+1;b+1;z)": rf"{D} {G}(a;b;z) = \frac{{a}}{{b}} {G}(a+1;b;z)",
    rf"z(1-z)\frac{{d^2}}{{dz^2}} {F}(a,b;c;z) + (c-(a+b+1)z){D} {F}(a,b;c;z) = ab {F}(a,b;c;z)": rf"z(1-z)\frac{{d^2}}{{dz^2}} {F}(a,b;c;z) + (c-(a+b)z){D} {F}(a,b;c;z) = ab {F}(a,b;c;z)",  # noqa: E501
    rf"(b-a){G}(a-1;b;z) + (2a-b+z){G}(a;b;z) = a{G}(a+1;b;z)": rf"(b-a){G}(a-1;b;z) + (2a-b-z){G}(a;b;z) = a{G}(a+1;b;z)",  # noqa: E501
    rf"{F}(a,b;c;z) = {F}(b,a;c;z)": rf"{F}(a,b;c;z) = {F}(a,c;b;z)",
    rf"{F}(-2,b;c;z) = 1 - \frac{{2b}}{{c}}z + \frac{{b(b+1)}}{{c(c+1)}}z^2": rf"{F}(-2,b;c;z) = 1 + \frac{{2b}}{{c}}z",
    rf"{G}(a;a;z) = e^z": rf"{G}(a;a;z) = e^{{-z}}",
    rf"{G}(1;2;z) = \frac{{e^z-1}}{{z}}": rf"{G}(1;2;z) = \frac{{e^z+1}}{{z}}",
}
INSIDE = {  # where 0 < z < 1
    rf"{F}(1,1;2;-z) = \frac{{\ln(1+z)}}{{z}}": rf"{F}(1,1;2;-z) = \ln(1+z)",
    rf"{F}(a,b;b;z) = (1-z)^{{-a}}": rf"{F}(a,b;b;z) = (1-z)^a",
    rf"{F}\left(\frac{{1}}{{2}},1;\frac{{3}}{{2}};-z^2\right) = \frac{{\arctan z}}{{z}}": rf"{F}\left(\frac{{1}}{{2}},1;\frac{{3}}{{2}};-z^2\right) = z\arctan z",  # noqa: E501
}


@pytest.mark.parametrize("relation", [*PAIRS, *INSIDE])
def test_a_relation_of_hypergeometric_functions_is_proved_and_its_slip_refuted(relation: str) -> None:
    given = "0 < z < 1" if relation in INSIDE else ()
    answer = decide(relation, given=given)
    assert (answer.verdict, answer.reason) == ("proved", "")
    assert any("hypergeometric" in what for what in answer.letters.values())
    assert decide((PAIRS | INSIDE)[relation], given=given).verdict == "refuted"


@pytest.mark.parametrize(
    "relation",
    [
        r"{}_2F_0(a,b;;z) = 1",  # a series that diverges
        r"{}_3F_1(a,b,c;d;z) = {}_3F_1(b,a,c;d;z)",
        rf"{G}(a;b;z) = e^z {F}(b-a,b;b;-z)",
    ],
)
def test_what_is_said_of_no_coefficients_is_left_open(relation: str) -> None:
    assert decide(relation).verdict not in ("proved", "refuted")


def test_a_condition_excludes_the_points_at_which_the_series_ends() -> None:
    relation = rf"{D} {G}(a;b;z) = \frac{{a}}{{b}} {G}(a+1;b;z)"
    assert decide(relation, given="a > 0, b > 0").verdict == "undecided"


def test_letters_stand_for_functions_of_each_number_of_parameters() -> None:
    found = with_letters(plainly(Asked(rf"{F}(a,b;c;z) + {G}(a;b;x) + F = 1")))
    assert found is not None
    assert found.of == {"G": (1, 1), "H": (2, 1)}
    assert found.asked.relation.replace(" ", "") == "H(a,b,c,z)+G(a,b,x)+F=1"


def call(name: str, parameters: list[Term], at: Term = "z", order: int = 0) -> Term:
    whole = node("call", name, (0,) * (len(parameters) + 1), *parameters, at)
    return node("diff", whole, "z", order, "z") if order else whole


def value(tree: Term, at: dict[str, Fraction]) -> mpmath.mpf:
    """The value of a relation's side, functions by mpmath."""
    if isinstance(tree, (int, str)):
        number = at[tree] if isinstance(tree, str) else Fraction(tree)
        return mpmath.mpf(number.numerator) / number.denominator
    match tree[0]:
        case "+":
            return mpmath.fsum(value(t, at) for t in tree.outside)
        case "*":
            return mpmath.fprod(value(t, at) for t in tree.outside)
        case "-":
            return -value(tree.outside[0], at)
        case "^":
            return value(tree.outside[0], at) ** tree.outside[1]
        case "/":
            return value(tree.outside[0], at) / value(tree.outside[1], at)
        case "call":
            *parameters, z = (value(t, at) for t in tree.terms)  # type: ignore[attr-defined]
            above = 2 if tree.function == "F" else 1  # type: ignore[attr-defined]
            return mpmath.hyper(parameters[:above], parameters[above:], z)
        case "diff":
            order, x = tree.outside[0], tree.letter  # type: ignore[attr-defined]
            inner = tree.body  # type: ignore[attr-defined]
            return mpmath.diff(lambda t: value(inner, at | {x: Fraction(str(t))}), value("z", at), order)
    raise AssertionError(tree)


def random_side(rng: random.Random, name: str) -> Term:
    """A sum of multiples of functions with neighbouring parameters."""
    addends = list[Term]()
    for _ in range(rng.randint(1, 3)):
        parameters: list[Term] = [node("+", x, rng.randint(-1, 1)) for x in ("abc" if name == "F" else "ac")]
        factor: Term = rng.choice(["a", "c", 1, 2, node("+", "a", node("-", "c"))])
        power = node("^", "z", rng.randint(0, 2))
        addends.append(node("*", factor, power, call(name, parameters, order=rng.choice([0, 0, 1]))))
    return node("+", 0, *addends)


@pytest.mark.parametrize("seed", range(30))
def test_coefficients_vanish_for_what_is_so_and_for_nothing_else(seed: int) -> None:
    rng = random.Random(seed)
    name = rng.choice("FG")
    of = {name: (2, 1) if name == "F" else (1, 1)}
    if seed % 2:  # true: the derivative in the place of what it is
        shifted: list[Term] = [node("+", x, 1) for x in ("abc" if name == "F" else "ac")]
        above = ["a", "b"] if name == "F" else ["a"]
        ratio = node("/", node("*", 1, *above), "c")
        more = random_side(rng, name)
        own = call(name, ["a", "b", "c"] if name == "F" else ["a", "c"], order=1)
        claim = node("=", node("+", own, more), node("+", more, node("*", ratio, call(name, shifted))))
    else:
        claim = node("=", random_side(rng, name), random_side(rng, name))
    assert isinstance(claim, Relation)
    at = {x: Fraction(rng.randint(12, 40), 7) for x in "abc"} | {"z": Fraction(rng.randint(1, 5), 11)}
    with mpmath.workdps(30):
        true = abs(value(claim.terms[0], at) - value(claim.terms[1], at)) < mpmath.mpf(10) ** -10
    cases = by_coefficients(Problem("x", claim), of)
    assert cases is not None
    assert all(decided_one(case)[0] == "proved" for case in cases) == true
    for numbers, there in terminated(Problem("x", claim), of):
        assert numbers.keys() <= {"a"} | {"b"}
        assert not (true and decided_one(there)[0] == "refuted")


@pytest.mark.parametrize("seed", range(20))
def test_the_addends_of_a_sum_are_the_coefficients(seed: int) -> None:
    rng = random.Random(seed)
    parameters: list[Term] = [number_term(Fraction(rng.randint(1, 6), rng.randint(1, 2))) for _ in range(3)]
    problem = as_sums(Problem("x", node("=", call("F", parameters), 0)), {"F": (2, 1)})
    assert problem is not None
    total = problem.claim.outside[0]
    assert isinstance(total, Binder)
    assert total.outside == (0, INFINITY)
    a, b, c = (mpmath.mpf(n.numerator) / n.denominator for n in map(number_of, parameters) if n is not None)
    for k in range(4):
        addend = substituted(total.body, {total.letter: k, "z": 1})
        expected = mpmath.rf(a, k) * mpmath.rf(b, k) / mpmath.rf(c, k) / mpmath.factorial(k)
        assert abs(_number(addend) - expected) < 1e-9
        assert not letters(addend)


def _number(tree: Term) -> mpmath.mpf:
    if isinstance(tree, Node) and tree.tag in ("gamma", "pow"):
        parts = [_number(t) for t in tree.outside]  # type: ignore[arg-type]
        return mpmath.gamma(parts[0]) if tree.tag == "gamma" else parts[0] ** parts[1]
    if isinstance(tree, Node) and tree.tag in ("+", "*", "/"):
        parts = [_number(t) for t in tree.outside]  # type: ignore[arg-type]
        return {"+": mpmath.fsum, "*": mpmath.fprod, "/": lambda p: p[0] / p[1]}[tree.tag](parts)
    number = number_of(tree)
    assert number is not None
    return mpmath.mpf(number.numerator) / number.denominator
