"""Second engines: the exact point of every refutation, evaluated by SymPy, by plain fractions and by python-flint.

At points with rational coordinates all three are exact. Where a coordinate has roots or is an angle, SymPy's value is
its own 60 digits and flint's a ball of 400 bits; the checker compares such numbers by intervals of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from fractions import Fraction
from functools import reduce
from operator import add, mul
from typing import Any

import flint
import sympy as sp

from symcheck.core.terms import Connective, Formula, Reader, Relation, Term, Value
from symcheck.core.verdicts import Certificate
from symcheck.ledger.record import Record
from symcheck.selftest.evidence import holds

BITS, DIGITS = 400, 60
NEAR = Fraction(1, 10**50)
Point = dict[str, Term]


class Unknown(Exception):
    """What an engine has no value for: an integral, a bound variable, a root in plain fractions."""


@dataclass(frozen=True)
class Engine:
    """How numbers are made and what functions are; sums, products, powers and quotients are Python's operators."""

    name: str
    number: Callable[[int], Any]
    functions: dict[str, Callable[..., Any]]
    sign: Callable[[Any], int | None]  # of a difference; None if it cannot tell

    def value(self, term: Term, point: Point, known: dict[str, Any]) -> Any:
        """The value of a term where the letters are these terms; `known` keeps the values of letters."""
        match term:
            case int():
                return self.number(term)
            case str() if term in point:
                if term not in known:
                    known[term] = self.value(point[term], point, known)
                return known[term]
            case Value(tag="^", terms=(base, int(exponent))):
                return self.value(base, point, known) ** exponent
            case Value(tag="sin" | "cos", terms=(str(x),)) if (half := half_angle(point.get(x, 0))) is not None:
                return self._turned(term.tag, self.value(half, point, known))
            case Value() if term.tag in OPERATORS:
                return OPERATORS[term.tag]([self.value(part, point, known) for part in term.terms])
            case Value() if term.tag in self.functions:
                return self.functions[term.tag](*(self.value(part, point, known) for part in term.terms))
        raise Unknown(str(term))

    def _turned(self, function: str, half: Any) -> Any:
        """The sine or cosine of an angle, from the tangent of its half."""
        one = self.number(1)
        return (2 * half if function == "sin" else one - half * half) / (one + half * half)

    def truth(self, formula: Formula, point: Point, known: dict[str, Any]) -> bool | None:
        """Whether a formula holds at the point, None if it cannot tell."""
        match formula:
            case Relation(terms=(left, right)):
                sign = self.sign(self.value(left, point, known) - self.value(right, point, known))
                return None if sign is None else sign in RELATIONS[formula.tag]
            case Connective(formulas=parts):
                truths = [self.truth(part, point, known) for part in parts]
                return None if None in truths else CONNECTIVES[formula.tag](truths)
        raise Unknown(formula.tag)


def half_angle(value: Term) -> Term | None:
    """What the tangent of half the angle is, if the angle is written as twice an arctangent."""
    match value:
        case Value(tag="*", terms=(2, Value(tag="arctan", terms=(half,)))):
            return half
    return None


RELATIONS = {"=": {0}, "!=": {-1, 1}, "<": {-1}, "<=": {-1, 0}, ">": {1}, ">=": {0, 1}}
CONNECTIVES: dict[str, Callable[[list[Any]], bool]] = {
    "and": all,
    "or": any,
    "=>": lambda truths: not truths[0] or truths[1],
    "<=>": lambda truths: truths[0] == truths[1],
}
OPERATORS: dict[str, Callable[[list[Any]], Any]] = {
    "+": lambda values: reduce(add, values),
    "*": lambda values: reduce(mul, values),
    "-": lambda values: -values[0],
    "/": lambda values: values[0] / values[1],
}


def _sign(number: Any) -> int:
    return bool(number > 0) - bool(number < 0)


def _sign_by_sympy(number: Any) -> int | None:
    number = sp.expand(number)
    if number.is_Rational:
        return _sign(number)
    near = abs(number.evalf(DIGITS)) < sp.Rational(NEAR.numerator, NEAR.denominator)
    return 0 if near and sp.nsimplify(sp.radsimp(number)).equals(0) else None if near else _sign(number.evalf(DIGITS))


def _sign_of_ball(number: Any) -> int | None:
    """The sign of a ball; one that is tiny and contains zero counts as zero."""
    if isinstance(number, flint.fmpq):
        return _sign(number)
    if number > 0 or number < 0:
        return 1 if number > 0 else -1
    return 0 if abs(number).upper() < flint.arb(2) ** -200 else None


def _half_power(base: Any, exponent: Any) -> Any:
    if exponent.denominator != 1:
        raise Unknown("pow")
    return base**exponent.numerator


FUNCTIONS_OF_SYMPY = {
    **{name: getattr(sp, name) for name in ("sin", "cos", "tan", "sqrt", "exp", "log", "gamma")},
    **{f"arc{name}": getattr(sp, f"a{name}") for name in ("sin", "cos", "tan")},
    "pow": lambda base, exponent: base**exponent,
    "pi": lambda: sp.pi,
}
FUNCTIONS_OF_FLINT = {
    **{
        name: lambda x, name=name: getattr(flint.arb(x), name)() for name in ("sin", "cos", "tan", "sqrt", "exp", "log")
    },
    **{f"arc{name}": lambda x, name=f"a{name}": getattr(flint.arb(x), name)() for name in ("sin", "cos", "tan")},
    "gamma": lambda x: flint.arb(x).gamma(),
    "pow": lambda base, exponent: flint.arb(base) ** flint.arb(exponent),
    "pi": flint.arb.pi,
}
ENGINES = (
    Engine("SymPy", sp.Integer, FUNCTIONS_OF_SYMPY, _sign_by_sympy),
    Engine("fractions", Fraction, {"pow": _half_power}, _sign),
    Engine("flint", flint.fmpq, FUNCTIONS_OF_FLINT, _sign_of_ball),
)


def point_of(evidence: Certificate) -> Point:
    """The coordinates of a refutation as terms, with the definitions that are in force."""
    stated = (*evidence["definitions"], *evidence["point"]["values"].items())
    return {name: Reader().term(value) for name, value in stated}


def refutes(engine: Engine, evidence: Certificate) -> bool | None:
    """Whether an engine finds the hypotheses true and the claim false at the point; None if it has no such numbers."""
    point, known, read = point_of(evidence), dict[str, Any](), Reader().formula
    try:
        given = [engine.truth(read(f), point, known) for stated in evidence["hypotheses"].values() for f in stated]
        claim = engine.truth(read(evidence["claim"]), point, known)
    except Unknown:
        return None
    return None if claim is None or None in given else all(given) and not claim


@dataclass
class Agreement:
    """How many refutations each engine evaluates, and those about which one disagrees with the checker."""

    points: int = 0
    evaluated: dict[str, int] = field(default_factory=lambda: {engine.name: 0 for engine in ENGINES})
    all_three: int = 0
    disagreements: list[str] = field(default_factory=list)

    def add(self, evidence: Certificate) -> None:
        """One refutation more."""
        answers = {engine.name: refutes(engine, evidence) for engine in ENGINES}
        self.points += 1
        self.all_three += None not in answers.values()
        for name, answer in answers.items():
            self.evaluated[name] += answer is not None
        if False in answers.values() or not holds(evidence):
            told = ", ".join(f"{name}: {answer}" for name, answer in answers.items())
            self.disagreements.append(f"{evidence['id']} ({told}, checker: {holds(evidence)})")


def agreement(records: Iterable[Record]) -> Agreement:
    """All refutations of some records, those without a hypothesis included, before all engines."""
    result = Agreement()
    with flint.ctx.workprec(BITS):
        for record in records:
            for each in record.all_certificates():
                if each["verdict"] == "refuted":
                    result.add(each)
    return result
