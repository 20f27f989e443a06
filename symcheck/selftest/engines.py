"""Second engines: the exact point of every refutation, evaluated with 50 digits, by plain fractions and by balls.

At points with rational coordinates fractions and balls are exact. Where a coordinate has roots or is an angle, a ball
has 400 bits and fractions have no value; the checker compares such numbers with its own intervals.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import reduce
from operator import add, mul, neg, truediv

import flint

from symcheck.coq.meaning import Evaluator, Meaning, NoValue, Number, Tree, Values
from symcheck.core.certificates import Certificate
from symcheck.ledger import Record
from symcheck.selftest.evidence import holds

BITS = 400  # twice those of TINY, so that a value lost by cancellation is still distinguished from zero
TINY = flint.arb(2) ** -200  # a ball that is smaller and contains zero counts as zero
ARITHMETIC: dict[str, Callable[..., Number]] = {
    "+": lambda *parts: reduce(add, parts), "*": lambda *parts: reduce(mul, parts), "-": neg, "/": truediv,
}  # fmt: skip


def whole_power(base: Fraction, exponent: Fraction) -> Fraction:
    """A power that needs no root."""
    if exponent.denominator != 1:
        raise NoValue("a root")
    return Fraction(base**exponent.numerator)


def ball(method: str) -> Callable[..., Number]:
    """A function of python-flint, of numbers of any kind."""
    return lambda t: getattr(flint.arb(t), method)()


RATIONAL = {**ARITHMETIC, "pow": whole_power}
BALLS: dict[str, Callable[..., Number]] = {
    **ARITHMETIC, "pi": flint.arb.pi, "pow": lambda base, exponent: flint.arb(base) ** flint.arb(exponent),
    **{name: ball(name) for name in ("sin", "cos", "tan", "sqrt", "exp", "log", "gamma")},
    **{f"arc{name}": ball(f"a{name}") for name in ("sin", "cos", "tan")},
}  # fmt: skip


class Exact(Evaluator):
    """Exact where numbers are rational. The sine of an angle that twice an arctangent is given for is so, too."""

    def term(self, node: Tree, at: Values) -> Number:
        match node:
            case ["sin" | "cos" as function, str(x)]:
                match self.definitions.get(x):
                    case ["*", 2, ["arctan", half]]:
                        t, one = self.term(half, at), self.number(1)
                        return (2 * t if function == "sin" else one - t * t) / (one + t * t)
        return super().term(node, at)


class Fractions(Exact):
    """Plain fractions: no roots, and no angles."""

    name = "fractions"
    operations = RATIONAL

    def number(self, n: int) -> Number:
        return Fraction(n)

    def sign(self, relation: Tree, at: Values) -> int:
        gap = self.term(relation[1], at) - self.term(relation[2], at)
        return bool(gap > 0) - bool(gap < 0)


class Balls(Exact):
    """Rational numbers and balls of python-flint."""

    name = "flint"

    operations = BALLS

    def number(self, n: int) -> Number:
        return flint.fmpq(n)

    def sign(self, relation: Tree, at: Values) -> int:
        gap = self.term(relation[1], at) - self.term(relation[2], at)
        if gap > 0 or gap < 0 or isinstance(gap, flint.fmpq):
            return bool(gap > 0) - bool(gap < 0)
        if abs(gap).upper() < TINY:
            return 0
        raise NoValue("a ball about zero")


ENGINES: dict[str, Callable[[Mapping[str, Tree]], Evaluator]] = {
    Meaning.name: lambda definitions: Meaning(definitions=definitions),
    Fractions.name: Fractions,
    Balls.name: Balls,
}


def refutes(engine: str, evidence: Certificate) -> bool | None:
    """Whether an engine finds the hypotheses true and the claim false at the point; None if it has no such numbers."""
    evaluator = ENGINES[engine]({**dict(evidence["definitions"]), **evidence["point"]["values"]})
    values: Values = {}
    given = [evaluator.formula(f, values) for stated in evidence["hypotheses"].values() for f in stated]
    claim = evaluator.formula(evidence["claim"], values)
    return None if claim is None or None in given else all(given) and not claim


@dataclass
class Agreement:
    """How many refutations each engine evaluates, and those about which one disagrees with the checker."""

    points: int = 0
    evaluated: dict[str, int] = field(default_factory=lambda: dict.fromkeys(ENGINES, 0))
    all_three: int = 0
    disagreements: list[str] = field(default_factory=list)

    def add(self, evidence: Certificate) -> None:
        """Add one refutation."""
        answers = {name: refutes(name, evidence) for name in ENGINES}
        self.points += 1
        self.all_three += None not in answers.values()
        for name, answer in answers.items():
            self.evaluated[name] += answer is not None
        if False in answers.values() or not holds(evidence):
            listed = ", ".join(f"{name}: {answer}" for name, answer in answers.items())
            self.disagreements.append(f"{evidence['id']} ({listed}, checker: {holds(evidence)})")


def agreement(records: Iterable[Record]) -> Agreement:
    """All refutations of some records, those without a hypothesis included, before all engines."""
    result = Agreement()
    with flint.ctx.workprec(BITS):
        for record in records:
            for evidence in record.all_certificates():
                if evidence["verdict"] == "refuted":
                    result.add(evidence)
    return result
