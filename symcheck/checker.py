"""Re-checks certificates with the standard library alone: `python -m symcheck.checker DIR`. Shares no code with the prover.

A certificate states a claim (nested lists), the definitions and hypotheses it rests on, and either a proof (a tree of
rules, each a method `rule_...` below) or an exact point where the hypotheses hold and the claim does not. What is
listed must be used: a hypothesis, definition or side condition that the proof does not need is rejected too.

Terms become fractions of polynomials. A polynomial maps monomials, exponents packed 16 bits each, to rationals.
sin x and cos x are the variables sin_x, cos_x; the root of a prime p is sqrt_p. A statement with denominators is meant
wherever they are not zero; each denominator is non-zero by a hypothesis or listed under "nonzero" in the proof.
"""

import hashlib
import json
import re
import sys
from fractions import Fraction
from math import gcd, isqrt
from pathlib import Path
from typing import Any

SCHEMA = 1
MAX_DEGREE = 30_000
RELATIONS = ("=", "!=", "<", "<=", ">", ">=")
Formula = Any
Term = Any


class Reject(Exception):
    """The certificate does not prove its claim; the message says where it fails."""


def require(condition: Any, reason: str) -> None:
    """Rejects with the reason unless the condition holds."""
    if not condition:
        raise Reject(reason)


class Poly:
    """A polynomial: packed monomial -> coefficient; `degree` bounds every exponent, so that no slot runs over."""

    __slots__ = ("degree", "terms")

    def __init__(self, terms: dict[int, Any], degree: int) -> None:
        require(degree <= MAX_DEGREE, "a polynomial of too high a degree")
        self.terms, self.degree = terms, degree

    def __add__(self, other: "Poly") -> "Poly":
        total = dict(self.terms)
        for monomial, coefficient in other.terms.items():
            value = total.get(monomial, 0) + coefficient
            if value:
                total[monomial] = value
            else:
                del total[monomial]
        return Poly(total, max(self.degree, other.degree))

    def __mul__(self, other: "Poly") -> "Poly":
        total: dict[int, Any] = {}
        get = total.get
        for m, c in self.terms.items():
            for n, d in other.terms.items():
                total[m + n] = get(m + n, 0) + c * d
        return Poly({m: c for m, c in total.items() if c}, self.degree + other.degree)

    def __pow__(self, exponent: int) -> "Poly":
        require(0 <= exponent * self.degree <= MAX_DEGREE and exponent <= MAX_DEGREE, "a power out of range")
        result = ONE
        for _ in range(exponent):
            result = result * self
        return result

    def scale(self, factor: Any) -> "Poly":
        """The polynomial times a number."""
        return Poly({m: c * factor for m, c in self.terms.items()} if factor else {}, self.degree)

    def key(self) -> Any:
        """Equal for equal polynomials only."""
        return frozenset(self.terms.items())


ONE, ZERO = Poly({0: 1}, 0), Poly({}, 0)


class Ratio:
    """num / product of divisors, kept as they occur in the term: {terms of the divisor: (divisor, exponent)}."""

    __slots__ = ("den", "num")

    def __init__(self, num: Poly, den: dict[Any, tuple[Poly, int]] | None = None) -> None:
        self.num, self.den = num, den or {}


def total(values: list[Ratio]) -> Ratio:
    """The sum over the least common denominator."""
    common: dict[Any, tuple[Poly, int]] = {}
    for value in values:
        for key, (divisor, exponent) in value.den.items():
            common[key] = (divisor, max(exponent, common.get(key, (divisor, 0))[1]))
    result = ZERO
    for value in values:
        num = value.num
        for key, (divisor, exponent) in common.items():
            num = num * divisor ** (exponent - value.den.get(key, (divisor, 0))[1])
        result = result + num
    return Ratio(result, common)


def product(values: list[Ratio]) -> Ratio:
    """The product; a factor that equals one of the divisors cancels with it."""
    den: dict[Any, tuple[Poly, int]] = {}
    for value in values:
        for key, (divisor, exponent) in value.den.items():
            den[key] = (divisor, exponent + den.get(key, (divisor, 0))[1])
    num = ONE
    for value in values:
        if den and (key := value.num.key()) in den:
            divisor, exponent = den.pop(key)
            den.update({key: (divisor, exponent - 1)} if exponent > 1 else {})
        else:
            num = num * value.num
    return Ratio(num, den)


def root(value: Fraction) -> tuple[Fraction, list[int]]:
    """(r, primes) with sqrt(value) = r * product of the roots of distinct primes."""
    require(0 <= value and value.numerator * value.denominator < 10**12, f"the root of {value}")
    rest, outside, primes, p = value.numerator * value.denominator, Fraction(1, value.denominator), [], 2
    while rest > 1:
        p = rest if p * p > rest else p
        while rest % (p * p) == 0:
            rest, outside = rest // (p * p), outside * p
        if rest % p == 0:
            rest //= p
            primes.append(p)
        p += 1
    return (outside if value else Fraction(0)), primes


def angle(term: Term) -> dict[str, int]:
    """An integer combination of variables; anything else, such as a half angle, is rejected."""
    if isinstance(term, str):
        return {term: 1}
    if isinstance(term, list) and term[0] == "-":
        return {x: -n for x, n in angle(term[1]).items()}
    if isinstance(term, list) and term[0] == "+":
        sums: dict[str, int] = {}
        for part in term[1:]:
            for x, n in angle(part).items():
                sums[x] = sums.get(x, 0) + n
        return sums
    if isinstance(term, list) and term[0] == "*" and sum(type(t) is not int for t in term[1:]) == 1:
        scale, rest = 1, None
        for t in term[1:]:
            scale, rest = (scale * t, rest) if type(t) is int else (scale, t)
        return {x: scale * n for x, n in angle(rest).items()}
    require(term == 0, f"the angle {term}")
    return {}


def replace(node: Any, values: dict[str, Any]) -> Any:
    """The term or formula with variables replaced by terms; names bound by "exists" or "diff" must not be among them."""
    if isinstance(node, str):
        return values.get(node, node)
    if not isinstance(node, list):
        return node
    if node[0] == "exists":
        require(not set(node[1]) & set(values), "a bound variable is replaced")
        return ["exists", node[1], replace(node[2], values)]
    if node[0] == "diff":
        require(node[2] not in values, f"a derivative by {node[2]}, which is not a free variable")
        return ["diff", replace(node[1], values), *node[2:]]
    return [node[0], *(replace(child, values) for child in node[1:])]


def names(node: Any) -> set[str]:
    """All names in a term or formula, function and relation signs aside."""
    if isinstance(node, str):
        return {node}
    if not isinstance(node, list):
        return set()
    return set().union(*(names(child) for child in (node if node and isinstance(node[0], list) else node[1:])))


def conjuncts(formula: Formula) -> list[Formula]:
    """The formula taken apart at "and"."""
    return [part for child in formula[1:] for part in conjuncts(child)] if formula[0] == "and" else [formula]


class Algebra:
    """Terms as fractions of polynomials, with definitions unfolded; notes the definitions and divisors it meets."""

    def __init__(self, definitions: list[Any]) -> None:
        self.definitions = dict(definitions)
        require(len(self.definitions) == len(definitions), "a name is defined twice")
        self.unfolded: set[str] = set()
        self.divisors: list[Poly] = []
        self._slots: dict[str, int] = {}
        self._named: dict[str, Ratio] = {}
        self._open: list[str] = []

    def variable(self, name: str) -> Poly:
        """The polynomial of one variable."""
        require(re.fullmatch("[A-Za-z][A-Za-z0-9_]*", name), f"the name {name!r}")
        return Poly({1 << self._slots.setdefault(name, 16 * len(self._slots)): 1}, 1)

    def exponents(self, monomial: int) -> dict[str, int]:
        """The variables of a monomial with their exponents."""
        return {x: e for x, slot in self._slots.items() if (e := monomial >> slot & 0xFFFF)}

    def parse(self, text: str) -> Poly:
        """A polynomial printed as "3/4*a_11^2*a_12 - I_1 + 2"."""
        require(isinstance(text, str), f"{text!r} is no polynomial")
        result: dict[int, Any] = {}
        degree = 0
        for sign, body in re.findall(r"([+-]?)([^+-]+)", text.replace(" ", "")) or [("", "?")]:
            monomial, coefficient, size = 0, Fraction(-1 if sign == "-" else 1), 0
            for factor in body.split("*"):
                found = re.fullmatch(r"(\d+(?:/\d+)?)|([A-Za-z]\w*)(?:\^(\d{1,4}))?", factor)
                require(found, f"{text!r} is no polynomial")
                assert found is not None
                if found[1]:
                    coefficient *= Fraction(found[1])
                else:
                    power = int(found[3] or 1)
                    monomial += next(iter(self.variable(found[2]).terms)) * power
                    size += power
            degree = max(degree, size)
            value = result.pop(monomial, 0) + (coefficient.numerator if coefficient.denominator == 1 else coefficient)
            if value:
                result[monomial] = value
        return Poly(result, degree)

    def name(self, name: str) -> Ratio:
        """A variable, or what a defined name stands for."""
        if name not in self.definitions:
            return Ratio(self.variable(name))
        self.unfolded.add(name)
        if name not in self._named:
            require(name not in self._open, f"the definition of {name} refers to itself")
            self._open.append(name)
            self._named[name] = self.ratio(self.definitions[name])
            self._open.pop()
        return self._named[name]

    def ratio(self, term: Term) -> Ratio:
        """The term as a fraction."""
        if type(term) is int:
            return Ratio(Poly({0: term} if term else {}, 0))
        if isinstance(term, str):
            return self.name(term)
        require(isinstance(term, list) and len(term) > 1, f"the term {term!r}")
        kind, *rest = term
        if kind == "+":
            return total([self.ratio(t) for t in rest])
        if kind == "*":
            return product([self.ratio(t) for t in rest])
        if kind == "-" and len(rest) == 1:
            return negative(self.ratio(rest[0]))
        if kind == "/" and len(rest) == 2:
            return product([self.ratio(rest[0]), self.inverse(rest[1])])
        if kind == "^" and len(rest) == 2 and type(rest[1]) is int and abs(rest[1]) <= MAX_DEGREE:
            return product([self.ratio(rest[0]) if rest[1] >= 0 else self.inverse(rest[0])] * abs(rest[1]))
        if kind in ("sin", "cos") and len(rest) == 1:
            return Ratio(self.turn(angle(self.unfold(rest[0])))[kind == "sin"])
        if kind == "tan" and len(rest) == 1:
            return self.ratio(["/", ["sin", rest[0]], ["cos", rest[0]]])
        if kind == "sqrt" and len(rest) == 1:
            return Ratio(self.root_of(self.ratio(rest[0])))
        require(kind == "diff" and len(rest) == 3 and rest[2] in range(9), f"the term {term!r}")
        require(rest[1] not in self.definitions, f"a derivative by {rest[1]}, which is not a free variable")
        result = self.ratio(rest[0])
        for _ in range(rest[2]):
            result = self.derivative(result, rest[1])
        return result

    def unfold(self, term: Term) -> Term:
        """The term with definitions unfolded, for the argument of a sine."""
        while found := names(term) & set(self.definitions):
            for name in found:
                self.name(name)  # notes the use, refuses circles
            term = replace(term, {name: self.definitions[name] for name in found})
        return term

    def inverse(self, term: Term) -> Ratio:
        """1 / term, factor by factor; notes the divisors."""
        if isinstance(term, str) and term in self.definitions:
            self.name(term)
            return self.inverse(self.definitions[term])
        if isinstance(term, list) and term[0] == "*":
            return product([self.inverse(t) for t in term[1:]])
        if isinstance(term, list) and term[0] == "^" and type(term[2]) is int and 0 < term[2] <= MAX_DEGREE:
            return product([self.inverse(term[1])] * term[2])
        value = self.ratio(term)
        num, divisor = ONE, value.num
        for poly, exponent in value.den.values():
            num = num * poly**exponent
        require(divisor.terms, "division by zero")
        if len(divisor.terms) == 1:
            ((monomial, coefficient),) = divisor.terms.items()
            unit = Poly({0: 1 / Fraction(coefficient)}, 0)
            exponents = self.exponents(monomial)
            if all(x.startswith("sqrt_") for x in exponents):
                for x, e in exponents.items():
                    unit = unit * self.variable(x).scale(Fraction(1, int(x[5:]))) ** e
                return Ratio(num * unit)
        self.divisors.append(divisor)
        return Ratio(num, {divisor.key(): (divisor, 1)})

    def turn(self, combination: dict[str, int]) -> tuple[Poly, Poly]:
        """(cos, sin) of an integer combination of variables."""
        cosine, sine = ONE, ZERO
        for x, count in combination.items():
            c, s = self.variable(f"cos_{x}"), self.variable(f"sin_{x}").scale(1 if count > 0 else -1)
            require(abs(count) <= 99, "an angle times more than 99")
            for _ in range(abs(count)):
                cosine, sine = cosine * c + (sine * s).scale(-1), sine * c + cosine * s
        return cosine, sine

    def root_of(self, value: Ratio) -> Poly:
        """The root of a non-negative rational number."""
        require(not value.den and set(value.num.terms) <= {0}, "the root of what is not a number")
        outside, primes = root(Fraction(value.num.terms.get(0, 0)))
        result = Poly({0: outside} if outside else {}, 0)
        for p in primes:
            result = result * self.variable(f"sqrt_{p}")
        return result

    def derivative(self, value: Ratio, name: str) -> Ratio:
        """d/d name, by the quotient rule."""
        den = ONE
        for divisor, exponent in value.den.values():
            den = den * divisor**exponent
        num = self.rate(value.num, name) * den + (value.num * self.rate(den, name)).scale(-1)
        return Ratio(num, {key: (d, 2 * e) for key, (d, e) in value.den.items()})

    def rate(self, poly: Poly, name: str) -> Poly:
        """The derivative of a polynomial; sin and cos of the name depend on it too."""
        result = self.partial(poly, name)
        if f"sin_{name}" in self._slots or f"cos_{name}" in self._slots:
            s, c = f"sin_{name}", f"cos_{name}"
            result = result + self.partial(poly, s) * self.variable(c)
            result = result + (self.partial(poly, c) * self.variable(s)).scale(-1)
        return result

    def substitute(self, poly: Poly, values: dict[str, Poly]) -> Poly:
        """The polynomial with some variables replaced by polynomials."""
        result = ZERO
        for monomial, coefficient in poly.terms.items():
            part = Poly({0: coefficient}, 0)
            for x, e in self.exponents(monomial).items():
                part = part * (values[x] if x in values else self.variable(x)) ** e
            result = result + part
        return result

    def partial(self, poly: Poly, name: str) -> Poly:
        """The partial derivative by one variable."""
        (unit,) = self.variable(name).terms
        slot = self._slots[name]
        return Poly({m - unit: c * e for m, c in poly.terms.items() if (e := m >> slot & 0xFFFF)}, poly.degree)


def negative(value: Ratio) -> Ratio:
    """-value."""
    return Ratio(value.num.scale(-1), value.den)


class Checker:
    """One certificate being checked: facts (polynomials that are zero), conditions (not zero), signs, disjunctions."""

    def __init__(self, certificate: dict[str, Any]) -> None:
        self.algebra = Algebra(certificate["definitions"])
        self.hypotheses = {(n, k): f for n, fs in certificate["hypotheses"].items() for k, f in enumerate(fs)}
        self.used: set[Any] = set()
        self.zeros: dict[Any, Poly] = {}
        self.conditions: dict[Any, Poly] = {}
        self.signs: list[tuple[Any, Term, int, Poly]] = []  # (reference, term >= 0, 2 if > 0, its polynomial)
        self.pending: list[tuple[Any, Formula]] = []
        self.counts = {"fact": 0, "cond": 0, "free": 0}
        for reference, formula in self.hypotheses.items():
            self.learn(("hyp", *reference), formula)

    def difference(self, left: Term, right: Term) -> Ratio:
        """left - right as a fraction."""
        return total([self.algebra.ratio(left), negative(self.algebra.ratio(right))])

    def learn(self, reference: Any, formula: Formula) -> None:
        """Takes an assumed formula (no "and") into the state; what is no relation or disjunction stays unused."""
        if formula[0] == "or":
            self.pending.append((reference, formula))
        if formula[0] not in RELATIONS:
            return
        sign, left, right = formula
        left, right, sign = (right, left, {"<": ">", "<=": ">="}[sign]) if sign in ("<", "<=") else (left, right, sign)
        gap = self.difference(left, right)
        if sign == "=":
            self.zeros[reference] = gap.num
        if sign in ("!=", ">"):
            self.conditions[reference] = gap.num
        if sign in (">", ">=") and not gap.den:
            self.signs.append((reference, left if right == 0 else ["+", left, ["-", right]], 1 + (sign == ">"), gap.num))

    def assume(self, formula: Formula) -> None:
        """Learns the conjuncts of a formula: equalities are the next facts, inequalities the next conditions."""
        for part in conjuncts(formula):
            kind = {"=": "fact", "!=": "cond", "<": "cond", ">": "cond"}.get(part[0], "free")
            self.learn((kind, self.counts[kind]), part)
            self.counts[kind] += 1

    def add_fact(self, poly: Poly) -> None:
        """One more polynomial that is zero."""
        self.zeros["fact", self.counts["fact"]] = poly
        self.counts["fact"] += 1

    def branch(self, goal: Formula, proof: Any, *assumed: Formula, fact: Poly | None = None) -> None:
        """Proves a goal under more assumptions, which are forgotten afterwards."""
        kept = dict(self.zeros), dict(self.conditions), list(self.signs), list(self.pending), dict(self.counts)
        for formula in assumed:
            self.assume(formula)
        if fact is not None:
            self.add_fact(fact)
        self.prove(goal, proof)
        self.zeros, self.conditions, self.signs, self.pending, self.counts = kept

    def note(self, reference: Any) -> Any:
        """Marks a hypothesis as used."""
        if reference[0] == "hyp":
            self.used.add(tuple(reference[1:]))
        return reference

    def zero(self, reference: Any) -> Poly:
        """The polynomial a reference says is zero."""
        if reference[:2] == ["axiom", "pythagoras"]:
            s, c = (self.algebra.variable(f"{f}_{reference[2]}") for f in ("sin", "cos"))
            return s * s + c * c + Poly({0: -1}, 0)
        if reference[:2] == ["axiom", "sqrt"]:
            require(root(Fraction(reference[2]))[1] == [reference[2]], f"the root of {reference[2]} is no variable")
            return self.algebra.variable(f"sqrt_{reference[2]}") ** 2 + Poly({0: -reference[2]}, 0)
        require(tuple(reference) in self.zeros, f"there is no equality {reference}")
        return self.zeros[self.note(tuple(reference))]

    def times(self, listed: Any) -> Poly:
        """The product of things that are not zero."""
        result = ONE
        for reference in listed:
            if reference[0] == "positive":
                require(self.sign(reference[1]) == 2, f"{reference[1]} is not manifestly positive")
                result = result * self.algebra.ratio(reference[1]).num
            else:
                require(tuple(reference) in self.conditions, f"there is no condition {reference}")
                result = result * self.conditions[self.note(tuple(reference))]
        return result

    def combination(self, poly: Poly, proof: Any, what: str) -> None:
        """The polynomial is the sum of cofactors times facts the proof names."""
        rest = poly.scale(-1)
        for reference, cofactor in proof["cofactors"]:
            rest = rest + self.algebra.parse(cofactor) * self.zero(reference)
        require(not rest.terms, f"{what} is not the combination of facts it is said to be")

    def sign(self, term: Term) -> int:
        """2 if manifestly positive, 1 if manifestly not negative, else 0."""
        known = max((s for s in self.signs if s[1] == term), key=lambda s: s[2], default=None)
        if known:
            self.note(known[0])
            return known[2]
        if type(term) is int:
            return 0 if term < 0 else 1 + (term > 0)
        if isinstance(term, str):
            defined = self.algebra.definitions
            return self.algebra.name(term) and self.sign(defined[term]) if term in defined else 0
        kind, *rest = term
        result = 0
        if kind == "+":
            parts = [self.sign(t) for t in rest]
            result = max(parts) if all(parts) else 0
        elif kind == "*":
            odd: list[Term] = []
            for t in rest:
                odd.remove(t) if t in odd else odd.append(t)
            paired = len(odd) < len(rest)
            parts = [self.sign(t) for t in odd]
            result = min([*parts, 1 if paired else 2])
        elif kind == "/":
            result = min(self.sign(rest[0]), 2 * bool(self.sign(rest[1])))
        elif kind == "^" and rest[1] > 0:
            result = self.sign(rest[0]) or int(rest[1] % 2 == 0)
        elif kind == "sqrt":
            result = self.sign(rest[0])
        return result or self.bound(term)

    def bound(self, term: Term) -> int:
        """The sign of a term that is a positive multiple of something assumed to be >= 0 or > 0."""
        gap = self.algebra.ratio(term) if self.signs and term[0] in ("+", "-") else Ratio(ZERO, {None: (ONE, 1)})
        for reference, _, sign, poly in self.signs:
            if not gap.den and (factor := proportional(gap.num, poly)) and factor > 0:
                self.note(reference)
                return sign
        return 0

    def prove(self, goal: Formula, proof: Any) -> None:
        """Checks one node of a proof."""
        rule = getattr(self, f"rule_{proof['rule']}", None)
        require(rule, f"there is no rule {proof['rule']}")
        assert rule is not None
        rule(goal, proof)

    def rule_identity(self, goal: Formula, proof: Any) -> None:
        """num(l - r) = sum q * fact."""
        require(goal[0] == "=", "an identity is claimed of something else")
        self.combination(self.difference(goal[1], goal[2]).num, proof, "left - right")

    def rule_nonnegative(self, goal: Formula, proof: Any) -> None:
        """(larger - smaller) * multiplier = form, which is manifestly not negative."""
        require(goal[0] in ("<", "<=", ">", ">="), "an order is claimed of something else")
        small, large = (goal[1], goal[2]) if goal[0][0] == "<" else (goal[2], goal[1])
        form, factor = proof["form"], proof.get("multiplier", 1)
        require(self.sign(factor) == 2, "the multiplier is not manifestly positive")
        require(self.sign(form) >= (2 if len(goal[0]) == 1 else 1), "the form is not manifestly of one sign")
        gap = self.difference(["*", factor, ["+", large, ["-", small]]], form)
        self.combination(gap.num, proof, "the difference less the form")

    def rule_nonzero(self, goal: Formula, proof: Any) -> None:
        """l != r: supposing l = r is absurd."""
        require(goal[0] == "!=", "an inequality is claimed of something else")
        self.branch(goal, proof["then"], ["=", goal[1], goal[2]])

    def rule_implies(self, goal: Formula, proof: Any) -> None:
        """f => g: g, supposing f."""
        require(goal[0] == "=>", "an implication is claimed of something else")
        self.branch(goal[2], proof["then"], goal[1])

    def rule_iff(self, goal: Formula, proof: Any) -> None:
        """Both directions."""
        require(goal[0] == "<=>", "an equivalence is claimed of something else")
        self.branch(goal[2], proof["forward"], goal[1])
        self.branch(goal[1], proof["backward"], goal[2])

    def rule_each(self, goal: Formula, proof: Any) -> None:
        """Every part of a conjunction."""
        require(goal[0] == "and" and len(goal) == len(proof["parts"]) + 1, "a conjunction of other parts")
        for part, inner in zip(goal[1:], proof["parts"], strict=True):
            self.branch(part, inner)

    def rule_choose(self, goal: Formula, proof: Any) -> None:
        """One part of a disjunction."""
        require(goal[0] == "or" and proof["index"] in range(len(goal) - 1), "there is no such alternative")
        self.branch(goal[1 + proof["index"]], proof["then"])

    def rule_cases_or(self, goal: Formula, proof: Any) -> None:
        """The goal in every case of an assumed disjunction."""
        require(proof["or"] in range(len(self.pending)), "there is no such disjunction")
        reference, disjunction = self.pending[proof["or"]]
        require(len(disjunction) == len(proof["cases"]) + 1, "a case is missing")
        self.note(reference)
        for part, inner in zip(disjunction[1:], proof["cases"], strict=True):
            self.branch(goal, inner, part)

    def rule_derive(self, goal: Formula, proof: Any) -> None:
        """(non-zero) * poly^power = sum q * fact, so poly = 0."""
        poly = self.algebra.parse(proof["poly"])
        require(proof["power"] > 0, "a power that is not positive")
        self.combination(self.times(proof["times"]) * poly ** proof["power"], proof, "the derived polynomial")
        self.branch(goal, proof["then"], fact=poly)

    def rule_vanish(self, goal: Formula, proof: Any) -> None:
        """A sum of manifestly non-negative addends is zero, so each addend is."""
        form = proof["form"]
        require(form[0] == "+" and all(self.sign(t) for t in form[1:]), "an addend is not manifestly non-negative")
        self.combination(self.algebra.ratio(form).num, proof, "the form")
        self.branch(goal, proof["then"], *(["=", t, 0] for t in form[1:]))

    def rule_split(self, goal: Formula, proof: Any) -> None:
        """(non-zero) * product of factors = sum q * fact: one of the factors is zero."""
        factors, whole = [self.algebra.parse(f) for f in proof["factors"]], self.times(proof["times"])
        require(len(factors) == len(proof["cases"]), "a case is missing")
        for factor in factors:
            whole = whole * factor
        self.combination(whole, proof, "the product")
        for factor, inner in zip(factors, proof["cases"], strict=True):
            self.branch(goal, inner, fact=factor)

    def rule_absurd(self, _: Formula, proof: Any) -> None:
        """Something non-zero = sum q * fact: the assumptions contradict each other."""
        self.combination(self.times(proof["times"]), proof, "the contradiction")

    def rule_witness(self, goal: Formula, proof: Any) -> None:
        """Values for the bound variables, in terms of a point (u, v) of the unit circle that remains to be found."""
        require(goal[0] == "exists" and set(proof["point"]) == set(goal[1]), "values for other variables")
        fresh = proof.get("fresh", [])
        taken = names(goal[2]) | names([*self.hypotheses.values()]) | set(self.algebra.definitions)
        require(not self.counts["fact"] and len(fresh) in (0, 2) and not set(fresh) & taken, "the names are taken")
        body = replace(self.algebra.unfold(goal[2]), proof["point"])
        if fresh:
            circle = ["=", ["+", ["^", fresh[0], 2], ["^", fresh[1], 2]], 1]
            body = ["exists", fresh, ["and", circle, body]]
        self.branch(body, proof["then"])

    def rule_quarter_turn(self, goal: Formula, proof: Any) -> None:
        """P(-s, c) = -P(c, s): P has a zero on the circle; the other equations are multiples of P there."""
        require(goal[0] == "exists" and all(f[0] == "=" for f in conjuncts(goal[2])), "no equations on a circle")
        c, s = proof["cos"], proof["sin"]
        angle_form = len(goal[1]) == 1 and [c, s] == [f"cos_{goal[1][0]}", f"sin_{goal[1][0]}"]
        assumed = names([*self.hypotheses.values()]) | set(self.algebra.definitions)
        require(angle_form or (set(goal[1]) == {c, s} and c != s), "the circle is another one")
        require(not self.counts["fact"] and not assumed & {c, s, *goal[1]}, "the names are taken")
        known, equations = len(self.algebra.divisors), [self.difference(*f[1:]).num for f in conjuncts(goal[2])]
        require(len(self.algebra.divisors) == known, "a denominator under a quantifier")
        x, y = self.algebra.variable(c), self.algebra.variable(s)
        circle = x * x + y * y + Poly({0: -1}, 0)
        require(angle_form or any(proportional(p, circle) for p in equations), "the circle is not asked for")
        self.add_fact(circle)
        leading = equations[proof["index"]]
        self.combination(leading + self.algebra.substitute(leading, {c: y.scale(-1), s: x}), proof, "the turned equation")
        require(len(proof["others"]) == len(equations), "an equation is missing")
        for poly, (multiple, cofactors) in zip(equations, proof["others"], strict=True):
            gap = poly + (leading * self.algebra.parse(multiple)).scale(-1)
            self.combination(gap, {"cofactors": cofactors}, "an equation less a multiple of the turned one")

    def justified(self, divisor: Poly, listed: list[Poly]) -> bool:
        """Whether a divisor is non-zero by a hypothesis; if not, it must be listed."""
        for reference, poly in self.conditions.items():
            if proportional(divisor, poly):
                return bool(self.note(reference))
        return any(d.terms == divisor.terms for d in listed)

    def check_proof(self, goal: Formula, proof: Any) -> None:
        """The whole proof, and that nothing superfluous is listed."""
        self.prove(goal, proof)
        listed = [self.algebra.parse(text) for text in proof.get("nonzero", [])]
        for divisor in self.algebra.divisors:
            require(self.justified(divisor, listed), "a denominator may be zero")
        for poly in listed:
            require(any(d.terms == poly.terms for d in self.algebra.divisors), "a side condition is no denominator")
        unused = [name for name, k in self.hypotheses if (name, k) not in self.used]
        require(not unused, f"the hypothesis {unused[:1]} is not used")

    def check_point(self, goal: Formula, point: Any) -> None:
        """The hypotheses hold at the point, the claim does not, and its sides have the stated values."""
        algebra = self.algebra
        values = {x: algebra.ratio(number(v)).num for x, v in point["values"].items()}
        angles = {x[4:] for x in values if x[:4] in ("sin_", "cos_")}
        require(not angles & set(values), "an angle and its sine are both given")
        holds = [self.truth(f, values) for f in self.hypotheses.values()]
        require(all(holds), "a hypothesis fails at the point")
        require(not self.truth(goal, values), "the claim holds at the point")
        for x in angles:
            require(not self.at(self.zero(["axiom", "pythagoras", x]), values).terms, "sine and cosine do not fit")
        for divisor in algebra.divisors:
            require(self.at(divisor, values).terms, "a denominator is zero at the point")
        for side, stated in zip(goal[1:], point["sides"], strict=True):
            if goal[0] in RELATIONS:
                require(self.truth(["=", side, number(stated)], values), "a side has another value at the point")
            else:
                require(self.truth(side, values) == (stated == "true"), "a part has another truth at the point")

    def at(self, poly: Poly, values: dict[str, Poly]) -> Poly:
        """The value of a polynomial, a combination of roots of square-free integers."""
        value, result = self.algebra.substitute(poly, values), ZERO
        for monomial, coefficient in value.terms.items():
            part = Poly({0: coefficient}, 0)
            for x, e in self.algebra.exponents(monomial).items():
                require(x.startswith("sqrt_"), f"the point gives no value for {x}")
                part = part * self.algebra.variable(x) ** (e % 2) * Poly({0: int(x[5:]) ** (e // 2)}, 0)
            result = result + part
        return result

    def order(self, value: Poly) -> int:
        """The sign of a combination of roots, by integer enclosures."""
        precision = 1
        while value.terms:
            low = high = Fraction(0)
            for monomial, coefficient in value.terms.items():
                radicand = 1
                for x in self.algebra.exponents(monomial):
                    radicand *= int(x[5:])
                near = isqrt(radicand * 4**precision)
                ends = [coefficient * Fraction(n, 2**precision) for n in (near, near + (near**2 < radicand * 4**precision))]
                low, high = low + min(ends), high + max(ends)
            if low > 0 or high < 0:
                return 1 if low > 0 else -1
            precision *= 2
        return 0

    def truth(self, formula: Formula, values: dict[str, Poly]) -> bool:
        """The formula at a point."""
        kind, *rest = formula
        if kind not in RELATIONS:
            require(kind in ("and", "or", "=>", "<=>"), f"{kind} at a point")
            parts = [self.truth(f, values) for f in rest]
            return {"and": all(parts), "or": any(parts), "=>": not parts[0] or parts[-1], "<=>": parts[0] == parts[-1]}[kind]
        gap = self.difference(*rest)
        order = self.order(self.at(gap.num, values))
        for divisor, exponent in gap.den.values():
            order *= self.order(self.at(divisor, values)) ** exponent
        return {"=": order == 0, "!=": order != 0, "<": order < 0, "<=": order <= 0, ">": order > 0, ">=": order >= 0}[kind]


def number(value: Any) -> Term:
    """A stated value: "2/7", or a term of integers and roots."""
    if isinstance(value, str):
        require(re.fullmatch(r"-?\d+(/\d+)?", value), f"the value {value!r}")
        return ["/", *map(int, (value + "/1").split("/")[:2])]
    return value


def proportional(a: Poly, b: Poly) -> Any:
    """The number f with a = f * b, or None."""
    if not a.terms or a.terms.keys() != b.terms.keys():
        return None
    monomial = next(iter(a.terms))
    factor = Fraction(a.terms[monomial]) / b.terms[monomial]
    return factor if all(c == factor * b.terms[m] for m, c in a.terms.items()) else None


def digest(certificate: dict[str, Any]) -> str:
    """SHA-256 of what is claimed, in canonical JSON."""
    stated = {key: certificate[key] for key in ("id", "claim", "definitions", "hypotheses")}
    return hashlib.sha256(json.dumps(stated, sort_keys=True, separators=(",", ":")).encode()).hexdigest()


def check(certificate: dict[str, Any]) -> str | None:
    """None if the certificate proves (or refutes) its claim, else the reason why it does not."""
    try:
        require(certificate["digest"] == digest(certificate), "the digest belongs to another statement")
        checker = Checker(certificate)
        if certificate["verdict"] == "proved":
            checker.check_proof(certificate["claim"], certificate["proof"])
        else:
            require(certificate["verdict"] == "refuted", "there is no such verdict")
            checker.check_point(certificate["claim"], certificate["point"])
        unused = set(checker.algebra.definitions) - checker.algebra.unfolded
        require(not unused, f"the definition of {min(unused, default='')} is not used")
    except Reject as error:
        return str(error)
    except (KeyError, IndexError, TypeError, ValueError, AttributeError, ZeroDivisionError, RecursionError) as error:
        return f"malformed ({type(error).__name__}: {error})"
    return None


def read(path: Path) -> list[dict[str, Any]]:
    """The certificates of one file; ValueError if it is not such a file."""
    data = json.loads(path.read_text(encoding="utf-8"))
    if not isinstance(data, dict) or data.get("schema") != SCHEMA or not isinstance(data.get("certificates"), list):
        raise ValueError(f"not a certificate file of schema {SCHEMA}")
    return data["certificates"]


def main(arguments: list[str]) -> int:
    """Checks all files named, or in the folders named: 0 all hold, 1 some do not, 2 a file cannot be read."""
    failures = count = 0
    paths = [p for a in map(Path, arguments) for p in (sorted(a.glob("*.json")) if a.is_dir() else [a])]
    if not paths:
        print("checker: no certificate file; name a folder or a file, such as generated/certificates", file=sys.stderr)
        return 2
    for path in paths:
        try:
            certificates = read(path)
        except (OSError, ValueError) as error:
            print(f"checker: {path}: {error}", file=sys.stderr)
            return 2
        for certificate in certificates:
            count += 1
            known = isinstance(certificate, dict)
            if reason := check(certificate) if known else "malformed":
                failures += 1
                print(f"{path}: {certificate.get('id') if known else '?'}: {reason}")
    print(f"{count} certificates, " + (f"{failures} do not hold" if failures else "all hold"))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
