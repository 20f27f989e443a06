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

from symcheck.evidence.checked import certificates
from symcheck.evidence.record import Record
from symcheck.selftest.evidence import frozen, holds
from symcheck.statement import Certificate, Formula, Term

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
        if isinstance(term, int):
            return self.number(term)
        if isinstance(term, str):
            if term not in known:
                known[term] = self._letter(term, point, known)
            return known[term]
        head, *parts = term
        if head == "^":
            return self.value(parts[0], point, known) ** int(parts[1])
        if head in ("sin", "cos") and f"{head}_{parts[0]}" in point:
            return self.value(f"{head}_{parts[0]}", point, known)
        values = [self.value(part, point, known) for part in parts if head in OPERATORS or head in self.functions]
        if head in OPERATORS:
            return OPERATORS[head](values)
        if head not in self.functions or any(value is None for value in values):
            raise Unknown(head)
        return self.functions[head](*values)

    def _letter(self, name: str, point: Point, known: dict[str, Any]) -> Any:
        if name in point:
            return self.value(point[name], point, known)
        if name in self.functions:
            return self.functions[name]()
        raise Unknown(name)

    def truth(self, formula: Formula, point: Point, known: dict[str, Any]) -> bool | None:
        """Whether a formula holds at the point, None if it cannot tell."""
        head, *parts = formula
        if head in RELATIONS:
            sign = self.sign(self.value(parts[0], point, known) - self.value(parts[1], point, known))
            return None if sign is None else sign in RELATIONS[head]
        if head not in CONNECTIVES:
            raise Unknown(head)
        truths = [self.truth(part, point, known) for part in parts]
        return None if None in truths else CONNECTIVES[head](truths)


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
    values = {name: _coordinate(value) for name, value in evidence["point"]["values"].items()}
    return {**{name: frozen(term) for name, term in evidence["definitions"]}, **values}


def _coordinate(value: Any) -> Term:
    if isinstance(value, str):
        return ("/", *Fraction(value).as_integer_ratio())
    term: Term = frozen(value)
    return term


def refutes(engine: Engine, evidence: Certificate) -> bool | None:
    """Whether an engine finds the hypotheses true and the claim false at the point; None if it has no such numbers."""
    point, known = point_of(evidence), dict[str, Any]()
    try:
        given = [engine.truth(frozen(f), point, known) for stated in evidence["hypotheses"].values() for f in stated]
        claim = engine.truth(frozen(evidence["claim"]), point, known)
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
            for each in certificates(record):
                if each["verdict"] == "refuted":
                    result.add(each)
    return result
