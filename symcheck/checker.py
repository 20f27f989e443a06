"""Re-checks certificates with the standard library alone: `python -m symcheck.checker DIR`. Shares no code with the prover.

A certificate states a claim (nested lists), the definitions and hypotheses it rests on, and a proof (a tree of rules,
each a method `rule_...` below) or an exact point where the hypotheses hold and the claim does not. What is listed must
be used: a hypothesis, definition or side condition that the proof does not need is rejected too.

Terms become fractions of polynomials: {monomial: coefficient}, a monomial being a whole number with 16 bits for the
exponent of each variable above 32 bits for the degree. sin x and cos x are the variables sin_x, cos_x; the root of a
prime p is sqrt_p. A statement with denominators is meant wherever they are not zero; each denominator is non-zero by
a hypothesis, or is listed under "nonzero" as a side condition.
"""

import hashlib
import json
import re
import sys
from fractions import Fraction
from math import isqrt
from pathlib import Path
from typing import Any

SCHEMA, MAX_DEGREE, DEGREE = 1, 30_000, (1 << 32) - 1
RELATIONS = {"=": {0}, "!=": {-1, 1}, "<": {-1}, "<=": {-1, 0}, ">": {1}, ">=": {0, 1}}  # signs of left - right
Poly = dict[int, Any]
Ratio = tuple[Poly, dict[Any, tuple[Poly, int]]]  # numerator, {terms of a divisor: (divisor, exponent)}
ONE: Poly = {0: 1}


class Reject(Exception):
    """The certificate does not prove its claim; the message says where it fails."""


def require(condition: Any, reason: str) -> None:
    """Rejects with the reason unless the condition holds."""
    if not condition:
        raise Reject(reason)


def combine(*addends: tuple[Poly, Poly]) -> Poly:
    """The sum of the products."""
    result: Poly = {}
    for a, b in addends:
        degree = max((m & DEGREE for m in a), default=0) + max((m & DEGREE for m in b), default=0)
        require(degree <= MAX_DEGREE, "a polynomial of too high a degree")
        for m, c in a.items():
            for n, d in b.items():
                result[m + n] = result.get(m + n, 0) + c * d
    return {m: c for m, c in result.items() if c}


def power(base: Poly, exponent: int) -> Poly:
    """base^exponent; exponents are small."""
    require(exponent in range(1000), "a power out of range")
    result = ONE
    for _ in range(exponent):
        result = combine((result, base))
    return result


def total(values: list[Ratio]) -> Ratio:
    """The sum over the least common denominator."""
    common: dict[Any, tuple[Poly, int]] = {}
    for _, den in values:
        for key, (divisor, exponent) in den.items():
            common[key] = divisor, max(exponent, common.get(key, (divisor, 0))[1])
    nums = []
    for num, den in values:
        for key, (divisor, exponent) in common.items():
            num = combine((num, power(divisor, exponent - den.get(key, (divisor, 0))[1])))
        nums.append(num)
    return combine(*((num, ONE) for num in nums)), common


def product(values: list[Ratio]) -> Ratio:
    """The product; a factor that equals one of the divisors cancels with it."""
    common: dict[Any, tuple[Poly, int]] = {}
    for _, den in values:
        for key, (divisor, exponent) in den.items():
            common[key] = divisor, exponent + common.get(key, (divisor, 0))[1]
    result = ONE
    for num, _ in values:
        if common and (key := frozenset(num.items())) in common:
            divisor, exponent = common.pop(key)
            common.update({key: (divisor, exponent - 1)} if exponent > 1 else {})
        else:
            result = combine((result, num))
    return result, common


def negative(value: Ratio) -> Ratio:
    """-value."""
    return combine((value[0], {0: -1})), value[1]


def proportional(a: Poly, b: Poly) -> Any:
    """The number f with a = f * b, or None."""
    if not a or a.keys() != b.keys():
        return None
    first = next(iter(a))
    factor = Fraction(a[first]) / b[first]
    return factor if all(c == factor * b[m] for m, c in a.items()) else None


def root(value: Fraction) -> tuple[Fraction, list[int]]:
    """(r, primes) with sqrt(value) = r * product of the roots of distinct primes."""
    rest, outside, primes, p = value.numerator * value.denominator, Fraction(bool(value), value.denominator), [], 2
    require(0 <= rest < 10**12, f"the root of {value}")
    while rest > 1:
        p = rest if p * p > rest else p
        while rest % (p * p) == 0:
            rest, outside = rest // (p * p), outside * p
        if rest % p == 0:
            rest //= p
            primes.append(p)
        p += 1
    return outside, primes


def angle(term: Any) -> dict[str, int]:
    """An integer combination of variables; anything else, such as a half angle, is rejected."""
    if isinstance(term, str):
        return {term: 1}
    require(isinstance(term, list) and term[0] in ("+", "-", "*"), f"the angle {term}")
    scale, parts = -1 if term[0] == "-" else 1, term[1:]
    if term[0] == "*":
        for number in (t for t in parts if type(t) is int):
            scale *= number
        parts = [t for t in parts if type(t) is not int]
        require(len(parts) == 1, f"the angle {term}")
    sums: dict[str, int] = {}
    for part in parts:
        for x, n in angle(part).items():
            sums[x] = sums.get(x, 0) + scale * n
    return sums


def replace(node: Any, values: dict[str, Any]) -> Any:
    """The term or formula with variables replaced by terms."""
    if isinstance(node, str):
        return values.get(node, node)
    if not isinstance(node, list):
        return node
    if node[0] in ("exists", "diff"):
        bound, at = (node[1], 2) if node[0] == "exists" else ([node[2]], 1)
        require(not set(bound) & set(values), f"{bound} does not stand for free variables")
        return [replace(child, values) if k == at else child for k, child in enumerate(node)]
    return [node[0], *(replace(child, values) for child in node[1:])]


def names(node: Any) -> set[str]:
    """All names in a term, a formula or a list of them."""
    if isinstance(node, str):
        return {node}
    children = node if isinstance(node, list) else []
    return set().union(*(names(child) for child in children[bool(children) and isinstance(children[0], str) :]))


def conjuncts(formula: Any) -> list[Any]:
    """The formula taken apart at "and"."""
    return [part for child in formula[1:] for part in conjuncts(child)] if formula[0] == "and" else [formula]


class Algebra:
    """Terms as fractions of polynomials, definitions unfolded; notes the definitions and divisors it meets."""

    def __init__(self, definitions: list[Any]) -> None:
        self.definitions: dict[str, Any] = dict(definitions)
        require(len(self.definitions) == len(definitions), "a name is defined twice")
        self.unfolded: dict[str, Ratio | None] = {}
        self.divisors: list[Poly] = []
        self.slots: dict[str, int] = {}
        self.powers: dict[str, int] = {}

    def variable(self, name: str) -> Poly:
        """The polynomial of one variable."""
        if name not in self.slots:
            require(re.fullmatch("[A-Za-z][A-Za-z0-9_]*", name), f"the name {name!r}")
            self.slots[name] = 32 + 16 * len(self.slots)
        return {(1 << self.slots[name]) + 1: 1}

    def exponents(self, monomial: int) -> dict[str, int]:
        """The variables of a monomial with their exponents."""
        return {x: e for x, slot in self.slots.items() if (e := monomial >> slot & 0xFFFF)}

    def parse(self, text: str) -> Poly:
        """A polynomial printed as "3/4*a_11^2*a_12 - I_1 + 2"."""
        result: Poly = {}
        if text == "0":
            return result
        for term in text.replace("- ", "+ -").split(" + " if not text.startswith("- ") else "?"):
            monomial, coefficient = 0, -1 if term.startswith("-") else 1
            for factor in term.removeprefix("-").split("*"):
                if factor[0].isdigit():
                    require(re.fullmatch(r"\d+(/[1-9]\d*)?", factor), f"the polynomial {text}")
                    coefficient *= int(factor) if factor.isdigit() else Fraction(factor)
                    continue
                if factor not in self.powers:
                    require(re.fullmatch(r"\w+(\^\d{1,4})?", factor), f"the polynomial {text}")
                    name, _, exponent = factor.partition("^")
                    self.powers[factor] = next(iter(self.variable(name))) * int(exponent or 1)
                monomial += self.powers[factor]
            require(
                coefficient and monomial not in result and monomial & DEGREE <= MAX_DEGREE, f"the polynomial {text}"
            )
            result[monomial] = coefficient
        return result

    def name(self, name: str) -> Ratio:
        """A variable, or what a defined name stands for."""
        if name not in self.definitions:
            return self.variable(name), {}
        if name not in self.unfolded:
            self.unfolded[name] = None
            self.unfolded[name] = self.ratio(self.definitions[name])
        value = self.unfolded[name]
        require(value, f"the definition of {name} refers to itself")
        return value  # type: ignore[return-value]

    def ratio(self, term: Any) -> Ratio:
        """The term as a fraction."""
        if type(term) is int:
            return {0: term} if term else {}, {}
        if isinstance(term, str):
            return self.name(term)
        require(isinstance(term, list) and len(term) > 1, f"the term {term!r}")
        kind, first, *rest = term
        if kind == "+":
            return total([self.ratio(t) for t in term[1:]])
        if kind == "*":
            return product([self.ratio(t) for t in term[1:]])
        if kind == "/" and len(rest) == 1:
            return product([self.ratio(first), self.inverse(rest[0])])
        if kind == "^" and len(rest) == 1 and type(rest[0]) is int and abs(rest[0]) < 1000:
            return product([self.ratio(first) if rest[0] >= 0 else self.inverse(first)] * abs(rest[0]))
        if kind == "diff" and len(rest) == 2 and rest[1] in range(9):
            value = self.ratio(first)
            for _ in range(rest[1]):
                value = self.derivative(value, rest[0])
            return value
        require(not rest, f"the term {term!r}")
        if kind == "-":
            return negative(self.ratio(first))
        if kind in ("sin", "cos"):
            return self.turn(angle(self.unfold(first)))[kind == "sin"], {}
        if kind == "tan":
            return self.ratio(["/", ["sin", first], ["cos", first]])
        require(kind == "sqrt", f"the term {term!r}")
        num, den = self.ratio(first)
        require(not den and set(num) <= {0}, "the root of what is not a number")
        outside, primes = root(Fraction(num.get(0, 0)))
        return product([({0: outside} if outside else {}, {}), *((self.variable(f"sqrt_{p}"), {}) for p in primes)])

    def unfold(self, node: Any) -> Any:
        """The term or formula with definitions unfolded."""
        while found := names(node) & set(self.definitions):
            for name in found:
                self.name(name)  # notes the use, refuses circles
            node = replace(node, {name: self.definitions[name] for name in found})
        return node

    def inverse(self, term: Any) -> Ratio:
        """1 / term, factor by factor; notes the divisors."""
        if isinstance(term, str) and term in self.definitions:
            self.name(term)
            return self.inverse(self.definitions[term])
        if isinstance(term, list) and term[0] == "*":
            return product([self.inverse(t) for t in term[1:]])
        if isinstance(term, list) and term[0] == "^" and term[2] in range(1, 1000):
            return product([self.inverse(term[1])] * term[2])
        divisor, den = self.ratio(term)
        require(divisor, "division by zero")
        result: list[Ratio] = [(power(poly, exponent), {}) for poly, exponent in den.values()]
        exponents = self.exponents(next(iter(divisor)))
        if len(divisor) == 1 and all(x.startswith("sqrt_") for x in exponents):
            result.append(({0: 1 / Fraction(*divisor.values())}, {}))
            for x, e in exponents.items():
                result += [(combine((self.variable(x), {0: Fraction(1, int(x[5:]))})), {})] * e
            return product(result)
        self.divisors.append(divisor)
        return product(result)[0], {frozenset(divisor.items()): (divisor, 1)}

    def turn(self, combination: dict[str, int]) -> tuple[Poly, Poly]:
        """(cos, sin) of an integer combination of variables, by the addition theorem."""
        cosine, sine = ONE, Poly()
        for x, count in combination.items():
            require(abs(count) < 100, "an angle times more than 99")
            c, s = self.variable(f"cos_{x}"), combine((self.variable(f"sin_{x}"), {0: 1 if count > 0 else -1}))
            minus = combine((s, {0: -1}))
            for _ in range(abs(count)):
                cosine, sine = combine((cosine, c), (sine, minus)), combine((sine, c), (cosine, s))
        return cosine, sine

    def derivative(self, value: Ratio, name: str) -> Ratio:
        """d/d name by the quotient rule; sin and cos of the name depend on it too."""
        require(name not in self.definitions, f"a derivative by {name}, which is not a free variable")
        num, den = value[0], ONE
        for divisor, exponent in value[1].values():
            den = combine((den, power(divisor, exponent)))

        def rate(poly: Poly) -> Poly:
            s, c = f"sin_{name}", f"cos_{name}"
            inner = [(name, ONE), (s, self.variable(c)), (c, combine((self.variable(s), {0: -1})))]
            return combine(*((self.partial(poly, x), by) for x, by in inner))

        doubled = {key: (divisor, 2 * exponent) for key, (divisor, exponent) in value[1].items()}
        return combine((rate(num), den), (num, combine((rate(den), {0: -1})))), doubled

    def partial(self, poly: Poly, name: str) -> Poly:
        """The partial derivative by one variable."""
        (unit,) = self.variable(name)
        return {m - unit: c * e for m, c in poly.items() if (e := m >> self.slots[name] & 0xFFFF)}

    def substitute(self, poly: Poly, values: dict[str, Poly]) -> Poly:
        """The polynomial with some variables replaced by polynomials."""
        parts = []
        for monomial, coefficient in poly.items():
            part: Poly = {0: coefficient}
            for x, e in self.exponents(monomial).items():
                part = combine((part, power(values.get(x) if x in values else self.variable(x), e)))  # type: ignore
            parts.append((part, ONE))
        return combine(*parts)

    def at(self, poly: Poly, values: dict[str, Poly]) -> Poly:
        """The value at a point: a combination of roots of square-free numbers."""
        parts = []
        for monomial, coefficient in self.substitute(poly, values).items():
            part: Poly = {0: coefficient}
            for x, e in self.exponents(monomial).items():
                require(x.startswith("sqrt_"), f"the point gives no value for {x}")
                part = combine((part, power(self.variable(x), e % 2)), ({}, {}))
                part = combine((part, {0: int(x[5:]) ** (e // 2)}))
            parts.append((part, ONE))
        return combine(*parts)

    def order(self, value: Poly) -> int:
        """The sign of a combination of roots, by integer enclosures; no such combination but {} is zero."""
        precision = 1
        while value:
            low = high = Fraction(0)
            for monomial, coefficient in value.items():
                radicand = 4**precision
                for x in self.exponents(monomial):
                    radicand *= int(x[5:])
                near = isqrt(radicand)
                ends = [coefficient * Fraction(n, 2**precision) for n in (near, near + (near**2 < radicand))]
                low, high = low + min(ends), high + max(ends)
            if low > 0 or high < 0:
                return 1 if low > 0 else -1
            precision *= 2
        return 0


class Checker:
    """One certificate being checked: facts (polynomials that are zero), conditions (not zero), signs, disjunctions."""

    def __init__(self, certificate: dict[str, Any]) -> None:
        self.algebra = Algebra(certificate["definitions"])
        self.hypotheses = {("hyp", n, k): f for n, fs in certificate["hypotheses"].items() for k, f in enumerate(fs)}
        self.used: set[Any] = set()
        self.facts: dict[Any, Poly] = {}
        self.conditions: dict[Any, Poly] = {}
        self.signs: list[tuple[Any, Any, int, Poly]] = []  # reference, term, 1 if >= 0 or 2 if > 0, its polynomial
        self.pending: list[tuple[Any, Any]] = []
        self.counts = {"fact": 0, "cond": 0, "free": 0}
        for reference, formula in self.hypotheses.items():
            self.learn(reference, formula)

    def difference(self, left: Any, right: Any) -> Ratio:
        """left - right as a fraction."""
        return total([self.algebra.ratio(left), negative(self.algebra.ratio(right))])

    def learn(self, reference: Any, formula: Any) -> None:
        """Takes in one assumption; what is neither relation nor disjunction stays without use."""
        if formula[0] == "or":
            self.pending.append((reference, formula))
        if formula[0] not in RELATIONS:
            return
        sign, left, right = formula
        if sign in ("<", "<="):
            sign, left, right = {"<": ">", "<=": ">="}[sign], right, left
        num, den = self.difference(left, right)
        if sign == "=":
            self.facts[reference] = num
        if sign in ("!=", ">"):
            self.conditions[reference] = num
        if sign in (">", ">=") and not den:
            self.signs.append((reference, left if right == 0 else ["+", left, ["-", right]], 1 + (sign == ">"), num))

    def branch(self, goal: Any, proof: Any, assumed: Any = ("and",), fact: Poly | None = None) -> None:
        """Proves a goal under more assumptions, numbered in their order and forgotten afterwards."""
        kept = dict(self.facts), dict(self.conditions), list(self.signs), list(self.pending), dict(self.counts)
        for part in conjuncts(assumed):
            kind = {"=": "fact", "!=": "cond", "<": "cond", ">": "cond"}.get(part[0], "free")
            self.learn((kind, self.counts[kind]), part)
            self.counts[kind] += 1
        if fact is not None:
            self.facts["fact", self.counts["fact"]] = fact
            self.counts["fact"] += 1
        rule = getattr(self, f"rule_{proof['rule']}", None)
        require(rule, f"there is no rule {proof['rule']}")
        rule(goal, proof)  # type: ignore[misc]
        self.facts, self.conditions, self.signs, self.pending, self.counts = kept

    def fact(self, reference: Any) -> Poly:
        """The polynomial a reference says is zero."""
        kind, *rest = reference
        if rest[0] == "pythagoras":
            s, c = (self.algebra.variable(f"{function}_{rest[1]}") for function in ("sin", "cos"))
            return combine((s, s), (c, c), ({0: -1}, ONE))
        if rest[0] == "sqrt" and kind == "axiom":
            require(root(Fraction(rest[1]))[1] == [rest[1]], f"the root of {rest[1]} is no variable")
            return combine((r := self.algebra.variable(f"sqrt_{rest[1]}"), r), ({0: -rest[1]}, ONE))
        return self.known(self.facts, reference)

    def known(self, where: dict[Any, Poly], reference: Any) -> Poly:
        """What a reference stands for; hypotheses are marked as used."""
        require(tuple(reference) in where, f"{reference} is no such assumption")
        self.used.add(tuple(reference))
        return where[tuple(reference)]

    def times(self, listed: Any) -> Poly:
        """The product of things that are not zero."""
        result = ONE
        for reference in listed:
            if reference[0] == "positive":
                require(self.sign(reference[1]) == 2, f"{reference[1]} is not manifestly positive")
                result = combine((result, self.algebra.ratio(reference[1])[0]))
            else:
                result = combine((result, self.known(self.conditions, reference)))
        return result

    def combination(self, poly: Poly, cofactors: Any, what: str) -> None:
        """The polynomial is the sum of cofactors times facts."""
        products = [(self.algebra.parse(cofactor), self.fact(reference)) for reference, cofactor in cofactors]
        require(all(q and p for q, p in products), f"{what}: a cofactor or a fact is zero")
        require(combine(*products) == poly, f"{what} is not the combination of facts it is said to be")

    def sign(self, term: Any) -> int:
        """2 if manifestly positive, 1 if manifestly not negative, else 0."""
        same = [s for s in self.signs if s[1] == term]
        if same:
            best = max(same, key=lambda s: s[2])
            self.used.add(best[0])
            return best[2]
        if type(term) is int:
            return (term >= 0) + (term > 0)
        if isinstance(term, str):
            return (
                self.sign(self.algebra.definitions[term])
                if self.algebra.name(term) and term in self.algebra.unfolded
                else 0
            )
        kind, *rest = term
        result = 0
        if kind == "+" and all(parts := [self.sign(t) for t in rest]):
            result = max(parts)
        elif kind == "*":
            single = [t for k, t in enumerate(rest) if rest.count(t) % 2 and t not in rest[:k]]
            result = min([1 if len(single) < len(rest) else 2, *(self.sign(t) for t in single)])
        elif kind == "/":
            result = min(self.sign(rest[0]), 2 * bool(self.sign(rest[1])))
        elif kind == "^" and rest[1] > 0:
            result = self.sign(rest[0]) or int(rest[1] % 2 == 0)
        elif kind == "sqrt":
            result = self.sign(rest[0])
        if not result and kind in ("+", "-") and self.signs:  # a positive multiple of something assumed >= 0?
            num, den = self.algebra.ratio(term)
            for reference, _, level, poly in [] if den else self.signs:
                if (factor := proportional(num, poly)) and factor > 0:
                    self.used.add(reference)
                    return level
        return result

    def rule_identity(self, goal: Any, proof: Any) -> None:
        """l = r: num(l - r) = sum q * fact."""
        require(goal[0] == "=", "an identity is claimed of something else")
        self.combination(self.difference(goal[1], goal[2])[0], proof["cofactors"], "left - right")

    def rule_nonnegative(self, goal: Any, proof: Any) -> None:
        """l <= r: (r - l) * multiplier = form by the facts; the form is manifestly not negative (positive for <)."""
        require(goal[0] in ("<", "<=", ">", ">="), "an order is claimed of something else")
        small, large = goal[1:] if goal[0][0] == "<" else goal[:0:-1]
        require(self.sign(proof.get("multiplier", 1)) == 2, "the multiplier is not manifestly positive")
        require(self.sign(proof["form"]) >= 3 - len(goal[0]), "the form is not manifestly of one sign")
        scaled = ["*", proof.get("multiplier", 1), ["+", large, ["-", small]]]
        self.combination(self.difference(scaled, proof["form"])[0], proof["cofactors"], "the difference less the form")

    def rule_implies(self, goal: Any, proof: Any) -> None:
        """f => g: g, supposing f. l != r: supposing l = r, a contradiction (an empty "or")."""
        require(goal[0] in ("=>", "!="), "an implication is claimed of something else")
        self.branch(
            *(goal[2] if goal[0] == "=>" else ["or"], proof["then"]), goal[1] if goal[0] == "=>" else ["=", *goal[1:]]
        )

    def rule_each(self, goal: Any, proof: Any) -> None:
        """Every part of a conjunction, both directions of an equivalence."""
        both = [["=>", *goal[1:]], ["=>", *goal[:0:-1]]] if goal[0] == "<=>" else goal[1:]
        require(goal[0] in ("and", "<=>"), "no conjunction")
        for part, inner in zip(both, proof["parts"], strict=True):
            self.branch(part, inner)

    def rule_choose(self, goal: Any, proof: Any) -> None:
        """One part of a disjunction."""
        require(goal[0] == "or" and proof["index"] in range(len(goal) - 1), "there is no such alternative")
        self.branch(goal[1 + proof["index"]], proof["then"])

    def rule_cases_or(self, goal: Any, proof: Any) -> None:
        """The goal in every case of an assumed disjunction."""
        reference, disjunction = self.pending[proof["or"]]
        self.used.add(reference)
        for part, inner in zip(disjunction[1:], proof["cases"], strict=True):
            self.branch(goal, inner, part)

    def rule_split(self, goal: Any, proof: Any) -> None:
        """(non-zero) * product of powers = sum q * fact: one of the bases is zero (the only one, if there is but one)."""
        bases, whole = [self.algebra.parse(text) for text, _ in proof["factors"]], self.times(proof["times"])
        for base, (_, exponent) in zip(bases, proof["factors"], strict=True):
            require(exponent > 0, "an exponent that is not positive")
            whole = combine((whole, power(base, exponent)))
        self.combination(whole, proof["cofactors"], "the product")
        for base, inner in zip(bases, proof["cases"], strict=True):
            self.branch(goal, inner, fact=base)

    def rule_vanish(self, goal: Any, proof: Any) -> None:
        """A sum of manifestly non-negative addends is zero, so each addend is."""
        kind, *addends = proof["form"]
        require(kind == "+" and all(self.sign(t) for t in addends), "an addend is not manifestly non-negative")
        self.combination(self.algebra.ratio(proof["form"])[0], proof["cofactors"], "the form")
        self.branch(goal, proof["then"], ["and", *(["=", t, 0] for t in addends)])

    def rule_absurd(self, _: Any, proof: Any) -> None:
        """Something non-zero = sum q * fact: the assumptions contradict each other."""
        self.combination(self.times(proof["times"]), proof["cofactors"], "the contradiction")

    def rule_witness(self, goal: Any, proof: Any) -> None:
        """Values for the bound variables; they may contain a point (u, v) of the unit circle that remains to be found."""
        require(goal[0] == "exists" and set(proof["point"]) == set(goal[1]), "values for other variables")
        body, fresh = self.algebra.unfold(goal[2]), proof.get("fresh", [])
        taken = names(body) | names([*self.hypotheses.values()]) | set(self.algebra.definitions)
        require(not self.counts["fact"] and len(fresh) in (0, 2) and not set(fresh) & taken, "the names are taken")
        body = replace(body, proof["point"])
        circle = ["=", ["+", *(["^", x, 2] for x in fresh)], 1]
        self.branch(["exists", fresh, ["and", circle, body]] if fresh else body, proof["then"])

    def rule_quarter_turn(self, goal: Any, proof: Any) -> None:
        """P(-s, c) = -P(c, s): P has a zero on the circle; the other equations are multiples of P there."""
        require(goal[0] == "exists" and all(f[0] == "=" for f in conjuncts(goal[2])), "no equations on a circle")
        c, s, known = proof["cos"], proof["sin"], len(self.algebra.divisors)
        angular = [[c, s]] == [[f"cos_{x}", f"sin_{x}"] for x in goal[1]]
        taken = names([*self.hypotheses.values()]) | set(self.algebra.definitions)
        require(not self.counts["fact"] and not taken & {c, s, *goal[1]}, "the names are taken")
        equations = [self.difference(*f[1:])[0] for f in conjuncts(goal[2])]
        require(len(self.algebra.divisors) == known, "a denominator under a quantifier")
        x, y = self.algebra.variable(c), self.algebra.variable(s)
        self.facts["fact", 0] = circle = combine((x, x), (y, y), ({0: -1}, ONE))
        asked = sorted(goal[1]) == sorted([c, s]) and c != s and any(proportional(p, circle) for p in equations)
        require(angular or asked, "the circle is another one")
        leading = equations[proof["index"]]
        turned = self.algebra.substitute(leading, {c: combine((y, {0: -1})), s: x})
        self.combination(combine((leading, ONE), (turned, ONE)), proof["cofactors"], "the turned equation")
        for poly, (multiple, cofactors) in zip(equations, proof["others"], strict=True):
            gap = combine((poly, ONE), (leading, combine((self.algebra.parse(multiple), {0: -1}))))
            self.combination(gap, cofactors, "an equation less a multiple of the turned one")

    def check_proof(self, goal: Any, proof: Any) -> None:
        """The whole proof, and that nothing superfluous is listed."""
        self.branch(goal, proof)
        listed = [self.algebra.parse(text) for text in proof.get("nonzero", [])]
        for divisor in self.algebra.divisors:
            by = [r for r, poly in self.conditions.items() if proportional(divisor, poly)]
            self.used.update(by[:1])
            require(by or divisor in listed, "a denominator may be zero")
        require(all(poly in self.algebra.divisors for poly in listed), "a side condition is no denominator")
        unused = [reference for reference in self.hypotheses if reference not in self.used]
        require(not unused, f"the hypothesis {unused[:1]} is not used")

    def check_point(self, goal: Any, point: Any) -> None:
        """The hypotheses hold at the point, the claim does not, and its sides have the stated values."""
        values = {x: self.algebra.ratio(number(v))[0] for x, v in point["values"].items()}
        angles = {x[4:] for x in values if x[:4] in ("sin_", "cos_")}
        require(not angles & set(values), "an angle and its sine are both given")
        for reference, formula in self.hypotheses.items():
            require(self.truth(formula, values), f"the hypothesis {reference} fails at the point")
        require(not self.truth(goal, values), "the claim holds at the point")
        for x in angles:
            require(not self.algebra.at(self.fact(["axiom", "pythagoras", x]), values), "no point of the unit circle")
        for divisor in self.algebra.divisors:
            require(self.algebra.at(divisor, values), "a denominator is zero at the point")
        for side, stated in zip(goal[1:], point["sides"], strict=True):
            right = self.truth(["=", side, number(stated)] if goal[0] in RELATIONS else side, values)
            require(right == (goal[0] in RELATIONS or stated == "true"), "a side has another value at the point")

    def truth(self, formula: Any, values: dict[str, Poly]) -> bool:
        """The formula at a point."""
        kind, *rest = formula
        if kind in RELATIONS:
            num, den = self.difference(*rest)
            order = self.algebra.order(self.algebra.at(num, values))
            for divisor, exponent in den.values():
                order *= self.algebra.order(self.algebra.at(divisor, values)) ** exponent
            return order in RELATIONS[kind]
        require(kind in ("and", "or", "=>", "<=>"), f"{kind} at a point")
        parts = [self.truth(part, values) for part in rest]
        if kind in ("and", "or"):
            return all(parts) if kind == "and" else any(parts)
        return parts[0] == parts[1] or (kind == "=>" and parts[1])


def number(value: Any) -> Any:
    """A stated value, "2/7" or a term of integers and roots, as a term."""
    require(not isinstance(value, str) or re.fullmatch(r"-?\d+(/\d+)?", value), f"the value {value!r}")
    return ["/", *map(int, (value + "/1").split("/")[:2])] if isinstance(value, str) else value


def digest(certificate: dict[str, Any]) -> str:
    """SHA-256 of what is claimed, in canonical JSON."""
    stated = {key: certificate[key] for key in ("id", "claim", "definitions", "hypotheses")}
    return hashlib.sha256(json.dumps(stated, sort_keys=True, separators=(",", ":")).encode()).hexdigest()


def check(certificate: dict[str, Any]) -> str | None:
    """None if the certificate proves (or refutes) its claim, else the reason why it does not."""
    try:
        require(certificate["digest"] == digest(certificate), "the digest belongs to another statement")
        require(certificate["verdict"] in ("proved", "refuted"), "there is no such verdict")
        checker = Checker(certificate)
        if certificate["verdict"] == "proved":
            checker.check_proof(certificate["claim"], certificate["proof"])
        else:
            checker.check_point(certificate["claim"], certificate["point"])
        unused = checker.algebra.definitions.keys() - checker.algebra.unfolded.keys()
        require(not unused, f"the definition of {min(unused, default='')} is not used")
    except Reject as error:
        return str(error)
    except (KeyError, IndexError, TypeError, ValueError, AttributeError, ZeroDivisionError, RecursionError) as error:
        return f"malformed ({type(error).__name__}: {error})"
    return None


def main(arguments: list[str]) -> int:
    """Checks the files named, or those in the folders named: 0 all hold, 1 some do not, 2 a file cannot be read."""
    failures = count = 0
    paths = [p for a in map(Path, arguments) for p in (sorted(a.glob("*.json")) if a.is_dir() else [a])]
    if not paths:
        print("checker: no certificate file; name a folder or a file, such as generated/certificates", file=sys.stderr)
        return 2
    for path in paths:
        try:
            data = json.loads(path.read_text(encoding="utf-8"))
            if not isinstance(data, dict) or data.get("schema") != SCHEMA:
                raise ValueError(f"not a certificate file of schema {SCHEMA}")
            reasons = [(certificate["id"], check(certificate)) for certificate in data["certificates"]]
        except (OSError, ValueError, KeyError, TypeError, RecursionError) as error:
            print(f"checker: {path} cannot be read ({error}); generate it anew", file=sys.stderr)
            return 2
        count += len(reasons)
        for identifier, reason in reasons:
            if reason:
                failures += 1
                print(f"{path}: {identifier}: {reason}")
    print(f"{count} certificates, " + (f"{failures} do not hold" if failures else "all hold"))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
