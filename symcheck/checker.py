"""Re-checks certificates with the standard library alone: `python -m symcheck.checker DIR`.

A certificate states a claim (nested lists), the definitions and hypotheses it uses, and a proof (see `Checker.prove`)
or an exact point where the hypotheses hold and the claim does not. Whatever it comes down to are equations of terms.
Both sides are computed modulo a prime near 2^253, at a point, both drawn anew in every run: nobody who writes a
certificate can know them, so a false equation passes with probability below 2^-60 (degrees are bounded for that) and
a right one always. Sines and cosines lie on the circle and roots of numbers are roots; a function without a rule here
(a power with a letter in the exponent, an integral) is a random function of the values it depends on, and what is
true of it is said by the table in `theorems.py`. A denominator is non-zero by a hypothesis or in "nonzero".
"""

import json
import os
import re
import sys
from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache
from math import prod
from pathlib import Path
from typing import Any

from symcheck.theorems import THEOREMS, Terms, Theorem, Unknown, conjuncts, terms

SCHEMA, HEIGHT, MAX_DEGREE = 1, 1 << 96, 1 << 60
RELATIONS = {"=": {0}, "!=": {-1, 1}, "<": {-1}, "<=": {-1, 0}, ">": {1}, ">=": {0, 1}}  # signs of left - right
CONTRARY = {"!=": "=", "<": ">=", "<=": ">", ">": "<=", ">=": "<"}
FACTOR = re.compile(r"(\d+)(?:/(\d+))?|([A-Za-z]\w*)(?:\^(\d{1,3}))?", re.ASCII)
CHOSEN = re.compile("(sin|cos|sqrt)_")  # letters whose values are not free
PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43)


class Reject(Exception):
    """The certificate does not prove its claim; the message says where it fails."""


def require(condition: Any, reason: str) -> None:
    """Rejects with the reason unless the condition holds."""
    if not condition:
        raise Reject(reason)


power = lru_cache(None)(pow)  # the same roots and inverses are needed again and again


class Chance:
    """A random prime, -1 modulo 8 and the small primes so that their roots exist, and random values of all letters."""

    def __init__(self) -> None:
        self.prime = 0
        while not self.prime:
            p = 4 * prod(PRIMES) * (2**198 + int.from_bytes(os.urandom(24), "big")) - 1
            bases = (int.from_bytes(os.urandom(16), "big") for _ in range(6))
            self.prime = p if all(pow(base, p >> 1, p) in (1, p - 1) for base in bases) else 0
        self.drawn: dict[Any, int] = {}
        self.monomials: dict[str, int] = {}

    def draw(self, key: Any) -> int:
        """The random number that belongs to the key."""
        if key not in self.drawn:
            self.drawn[key] = int.from_bytes(os.urandom(40), "big") % self.prime
        return self.drawn[key]

    def letter(self, name: str) -> int:
        """The value of a letter; sin_x and cos_x are a point of the circle, sqrt_2 is the root of 2."""
        if name not in self.drawn:
            require(re.fullmatch("[A-Za-z][A-Za-z0-9_]*", name), f"the name {name!r}")
            if name[:4] in ("sin_", "cos_"):
                self.drawn[name] = self.circle(name[4:])[name[0] == "s"]
            elif name[:5] == "sqrt_":
                self.drawn[name] = self.root(Fraction(name[5:]))
        return self.draw(name)

    def circle(self, key: Any) -> tuple[int, int]:
        """A point of the unit circle, (cos, sin)."""
        half = self.draw(("half", key))
        return (1 - half * half) * self.inverse(1 + half * half), 2 * half * self.inverse(1 + half * half)

    def inverse(self, value: int) -> int:
        """1 / value."""
        require(value % self.prime, "division by zero")
        return power(value, -1, self.prime)

    def rational(self, value: int) -> Fraction | None:
        """The number n/d with this value; None if there is none with n and d below HEIGHT."""
        a, b, u, v = self.prime, value % self.prime, 0, 1
        while b >= HEIGHT:
            q = a // b
            a, b, u, v = b, a - q * b, v, u - q * v
        return Fraction(b, v) if abs(v) < HEIGHT else None

    def root(self, number: Fraction | None) -> int:
        """The root of a positive number: a square modulo the prime, as the roots of the small primes are chosen."""
        rest = 0 if number is None or number < 0 else number.numerator * number.denominator
        value = rest * self.inverse(number.denominator**2) % self.prime if number else 0
        for p in PRIMES if rest else ():
            while rest % p == 0:
                rest //= p
        require(rest == 1 or number == 0, f"the root of {number}: only of products of primes up to {PRIMES[-1]}")
        return power(value, (self.prime + 1) // 4, self.prime)


@lru_cache(1)
def chance() -> Chance:  # the prime and the point of this run
    return Chance()


class Algebra(Terms):
    """Values of terms modulo the prime, definitions unfolded; notes the definitions and divisors it meets."""

    def __init__(self, definitions: list[Any]) -> None:
        super().__init__(dict(definitions))
        proper = len(self.definitions) == len(definitions) and not any(map(CHOSEN.match, self.definitions))
        require(proper, "a name is defined twice, or is a sine, a cosine or a root")
        self.chance, self.prime = chance(), chance().prime
        self.monomials = self.chance.monomials
        self.values: dict[str, int] = {}  # of the names met
        self.point: dict[str, Any] | None = None  # where a statement is refuted: all letters have values
        self.scope: dict[str, int] = {}  # values of bound variables
        self.inside, self.exponent = 0, 1
        self.divisors: dict[int, bool] = {}  # value -> whether it depends on letters

    def value(self, term: Any) -> int:
        """The value of a term; sums are not reduced modulo the prime."""
        values, kind = self.values, type(term)
        if kind is str:
            return values[term] if term in values else self.named(term)
        if kind is int:
            return term  # type: ignore[no-any-return]
        sign = term[0]
        if sign == "*":
            result = 1
            for t in term[1:]:
                result = result * (values[t] if type(t) is str and t in values else self.value(t)) % self.prime
            return result
        if sign == "+":
            return sum([values[t] if type(t) is str and t in values else self.value(t) for t in term[1:]])
        require(sign in OPERATIONS, f"the term {term!r}")
        return OPERATIONS[sign](self, *term[1:])

    def named(self, name: str) -> int:
        """The value of a letter, or of what a defined name stands for."""
        if name in self.scope:
            value = self.scope[name]
        elif name in self.definitions:
            require(self.degrees.get(name, 1), f"the definition of {name} refers to itself")
            self.degrees[name] = 0  # until it is known
            value = self.value(self.definition(name))
            self.degrees[name] = 1 + self.degree(self.definitions[name])
            require(self.degrees[name] < MAX_DEGREE, f"the degree of {name}")
        elif self.point is None or name[:5] == "sqrt_":
            value = self.chance.letter(name)
        else:
            require(name in self.point, f"no value for {name}")
            given = self.point[name]
            value = self.polynomial(given) if isinstance(given, str) else self.value(given)
        self.values[name] = value % self.prime
        return self.values[name]

    def polynomial(self, text: str) -> int:
        """The value of a polynomial printed as "3/4*a_11^2*a_12 - I_1 + 2"."""
        result = 0
        for term in text.replace(" - ", " + -").split(" + "):
            if term not in self.monomials:
                self.monomials[term] = self.monomial(term)
            result += self.monomials[term]
        return result % self.prime

    def monomial(self, text: str) -> int:
        """The value of one term of such a polynomial."""
        result = -1 if text[:1] == "-" else 1
        for factor in text.removeprefix("-").split("*"):
            value = self.monomials.get(factor)
            if value is None:
                found = FACTOR.fullmatch(factor)
                require(found, f"the factor {factor!r}")
                number, below, name, exponent = found.groups()  # type: ignore[union-attr]
                base = int(number) if number else self.chance.letter(name) if self.point is None else self.value(name)
                value = pow(base, int(exponent or 1), self.prime) * self.chance.inverse(int(below or 1)) % self.prime
                self.monomials[factor] = value
            result = result * value % self.prime
        return result

    def power(self, base: Any, exponent: int) -> int:
        size = abs(exponent)
        require(type(exponent) is int and self.exponent * size < 1000, f"the exponent {exponent}")
        self.exponent *= size or 1
        value = self.value(base) if exponent >= 0 else self.inverse(base)
        self.exponent //= size or 1
        return pow(value, size, self.prime)

    def inverse(self, term: Any) -> int:
        """1 / term, factor by factor; notes the divisors."""
        match term:
            case ["*", *parts]:
                return prod(map(self.inverse, parts)) % self.prime
            case ["^", base, int(n)] if n > 0:
                return pow(self.inverse(base), n, self.prime)
        value = self.value(term) % self.prime
        self.divisors[value] = self.divisors.get(value, False) or bool(self.names(term))
        return self.chance.inverse(value)

    def turn(self, term: Any) -> tuple[int, int]:
        """(cos, sin) of an integer combination of letters, by the addition theorem; half angles are rejected."""
        cosine, sine, rest = 1, 0, term
        for x in sorted(self.names(term)):
            rate, rest = self.rate(term, x), self.replaced(rest, {x: 0})
            count = None if self.names(rate) else self.chance.rational(self.value(rate))
            require(count is not None and count.denominator == 1 and abs(count) < 100, f"the angle {term}")
            c, s = self.value(f"cos_{x}"), self.value(f"sin_{x}") * (1 if count > 0 else -1)  # type: ignore[operator]
            for _ in range(abs(int(count))):  # type: ignore[arg-type]
                cosine, sine = (cosine * c - sine * s) % self.prime, (sine * c + cosine * s) % self.prime
        require(self.value(rest) == 0, f"the angle {term}")
        return cosine, sine

    def opaque(self, kind: str, *terms: Any) -> int:
        """A function of the values; the root of a number and a power with a whole exponent are what they are."""
        values = [self.value(term) % self.prime for term in terms]
        if kind == "sqrt" and (self.point is not None or not self.names(terms[0])):
            return self.chance.root(self.chance.rational(*values))
        if kind == "pow" and (whole := self.chance.rational(values[1])) is not None and whole.denominator == 1:
            return self.power(terms[0], int(whole))
        require(self.point is None, f"no value for {kind} at a point")
        return self.chance.draw((kind, *values))

    def bound(self, kind: str, body: Any, x: str, *ends: Any) -> int:
        """An integral or a mean: a function of the ends and of the body, which is taken at a value of x of its own."""
        require(self.point is None and len(ends) == 2 * (kind != "mean"), f"the {kind} of {body}")
        limits = [self.value(end) % self.prime for end in ends]
        kept, self.inside = (self.scope, self.values), self.inside + 1
        key = ("bound", self.inside)
        own = dict(zip((x, f"cos_{x}", f"sin_{x}"), (self.chance.draw(key), *self.chance.circle(key)), strict=True))
        self.scope, self.values = {**self.scope, **own}, {}
        value = self.value(body) % self.prime
        (self.scope, self.values), self.inside = kept, self.inside - 1
        return self.chance.draw((kind, value, *limits))


OPERATIONS: dict[str, Callable[..., int]] = {
    "-": lambda a, term: -a.value(term),
    "/": lambda a, top, bottom: a.value(top) * a.inverse(bottom) % a.prime,
    "^": Algebra.power,
    "cos": lambda a, term: a.turn(term)[0],
    "sin": lambda a, term: a.turn(term)[1],
    "tan": lambda a, term: a.value(["/", ["sin", term], ["cos", term]]),
    "diff": lambda a, term, x, order: a.value(a.derived(term, x, order)),
    **{kind: lambda a, *t, kind=kind: a.opaque(kind, *t) for kind in ("sqrt", "pow", "log", "gamma")},
    **{kind: lambda a, *t, kind=kind: a.bound(kind, *t) for kind in ("integral", "diverges", "mean")},
}


class Checker:
    """One certificate being checked: facts (that are zero), conditions (not zero), signs, disjunctions."""

    def __init__(self, certificate: dict[str, Any]) -> None:
        self.algebra = Algebra(certificate["definitions"])
        self.hypotheses = {("hyp", n, k): f for n, fs in certificate["hypotheses"].items() for k, f in enumerate(fs)}
        self.claim = certificate["claim"]
        self.used: set[Any] = set()
        self.listed: dict[int, int] = {}  # denominators about which no hypothesis speaks, with their numerators
        self.state: dict[Any, tuple[str, Any, Any]] = {}  # sign, value (of a disjunction: its parts) and source

    def learn(self, reference: Any, formula: Any) -> None:
        """Takes in one assumption."""
        sign, *content = formula
        if sign in RELATIONS:
            sign, content = (sign.replace("<", ">"), content[::-1]) if sign[0] == "<" else (sign, content)
            content = (self.algebra.value(content[0]) - self.algebra.value(content[1])) % self.algebra.prime
        self.state[reference] = sign, content, formula

    def branch(self, goal: Any, proof: Any, assumed: Any = ("and",), fact: str = "") -> None:
        """Proves a goal under more assumptions, numbered in their order and forgotten afterwards."""
        size, own = len(self.state), len(self.hypotheses)
        for part in conjuncts(assumed):
            self.learn(("here", len(self.state) - own), part)
        if fact:
            self.state["here", len(self.state) - own] = "=", self.algebra.polynomial(fact), fact
        self.prove(goal, proof)
        while len(self.state) > size:
            self.state.popitem()

    def fresh(self, x: str, *beside: Any) -> None:
        """Rejects unless nothing is assumed of x, nor said of it in the terms and formulas beside."""
        sources = [source for *_, source in self.state.values()]  # formulas, and the texts of polynomials
        names = (re.findall(r"[A-Za-z]\w*", s) if isinstance(s, str) else self.algebra.names(s) for s in sources)
        taken = set(self.algebra.definitions).union(*names, *map(self.algebra.names, beside))
        require(not {x, f"sin_{x}", f"cos_{x}"} & taken, f"the letter {x} is taken")

    def known(self, signs: tuple[str, ...], reference: Any) -> int:
        """The value of an assumption with one of the signs; hypotheses are marked as used."""
        if reference[0] == "positive" and ">" in signs:
            require(self.sign(reference[1]) == 2, f"{reference[1]} is not manifestly positive")
            return self.algebra.value(reference[1])
        sign, value, _ = self.state.get(tuple(reference), ("", 0, 0))
        require(sign in signs, f"{reference} is no such assumption")
        self.used.add(tuple(reference))
        return int(value)

    def combination(self, value: Any, proof: Any, what: str) -> None:
        """The value, times denominators and things that are not zero, is the sum of cofactors times facts."""
        for text in proof.get("clear", ()):
            value *= (divisor := self.algebra.polynomial(text))
            require(divisor in self.algebra.divisors or divisor in self.listed.values(), f"{text} is no denominator")
        for reference in proof.get("times", ()):
            value *= self.known(("!=", ">"), reference)
        for reference, *cofactor in proof["cofactors"]:
            product = prod(map(self.algebra.polynomial, cofactor), start=self.known(("=",), reference))
            require(product, f"{what}: the fact {reference} says nothing")
            value -= product
        require(value % self.algebra.prime == 0, f"{what} is not the combination of facts it is said to be")

    def sign(self, term: Any) -> int:
        """2 if manifestly positive, 1 if manifestly not negative, else 0."""
        result = 0
        match term:
            case int():
                return (term >= 0) + (term > 0)
            case ["+", *parts]:
                result = max(levels := [self.sign(part) for part in parts]) * all(levels)
            case ["*", *parts]:  # equal factors pair up to squares
                single = [t for k, t in enumerate(parts) if parts.count(t) % 2 and t not in parts[:k]]
                result = min([1 if len(single) < len(parts) else 2, *(self.sign(t) for t in single)])
            case ["/", top, bottom]:
                result = min(self.sign(top), 2 * bool(self.sign(bottom)))
            case ["^", base, int(n)] if n > 0:
                result = self.sign(base) or int(n % 2 == 0)
        if result:
            return result
        value = self.algebra.value(term) % self.algebra.prime
        for reference, (sign, other, _) in self.state.items():
            if sign in (">", ">=") and value == other:
                self.used.add(reference)
                return 3 - len(sign)
        return self.sign(self.algebra.definitions[term]) if str(term) in self.algebra.definitions else 0

    def theorem(self, goal: Any, name: str, *given: Any) -> Theorem:
        """One of the theorems that are taken for granted, if its letters are free for it."""
        require(name in THEOREMS, f"the theorem {name}")
        theorem = THEOREMS[name](self.algebra, *given)
        if theorem.anew or theorem.free:
            self.fresh(theorem.anew or theorem.free, *theorem.without, *([goal, self.claim] if theorem.anew else []))
        return theorem

    def prove(self, goal: Any, proof: Any) -> None:
        """One node of a proof. In an order, larger - smaller is a form manifestly not negative (positive for <)."""
        then, form = proof.get("then"), proof.get("form")
        match [proof["rule"], *goal]:
            case ["identity", "=", left, right]:  # num(l - r) = sum q * fact
                self.combination(self.algebra.value(left) - self.algebra.value(right), proof, "left - right")
            case ["nonnegative", "<" | "<=" as sign, small, large] | ["nonnegative", ">" | ">=" as sign, large, small]:
                require(self.sign(form) >= 3 - len(sign), "the form is not manifestly of one sign")
                gap = self.algebra.value(["+", large, ["-", small], ["-", form]])
                self.combination(gap, proof, "the difference less the form")
            case ["implies", "=>", assumed, conclusion]:
                self.branch(conclusion, then, assumed)
            case ["implies", "!=" | "<" | "<=" | ">" | ">=" as sign, *sides]:  # the contrary leads to a contradiction
                self.branch(["or"], then, [CONTRARY[sign], *sides])
            case ["each", "and" | "<=>" as kind, *parts]:
                parts = parts if kind == "and" else [["=>", *parts], ["=>", *parts[::-1]]]
                for part, inner in zip(parts, proof["parts"], strict=True):
                    self.branch(part, inner)
            case ["choose", "or", *parts]:
                self.branch(dict(enumerate(parts))[proof["index"]], then)
            case ["cases_or", *_]:  # the goal in every case of an assumed disjunction
                reference = [name for name, (sign, *_) in self.state.items() if sign == "or"][proof["or"]]
                self.used.add(reference)
                for part, inner in zip(self.state[reference][1], proof["cases"], strict=True):
                    self.branch(goal, inner, part)
            case ["split", *_]:  # (non-zero) * product of powers = sum q * fact: one of the bases is zero
                require(all(exponent > 0 for _, exponent in proof["factors"]), "an exponent that is not positive")
                bases = (self.algebra.polynomial(text) ** exponent for text, exponent in proof["factors"])
                self.combination(prod(bases), proof, "the product")
                for (base, _), inner in zip(proof["factors"], proof["cases"], strict=True):
                    self.branch(goal, inner, fact=base)
            case ["vanish", *_]:  # a sum of non-negative addends is zero, so each addend is
                require(form[0] == "+" and all(map(self.sign, form[1:])), "an addend is not manifestly non-negative")
                self.combination(self.algebra.value(form), proof, "the form")
                self.branch(goal, then, ["and", *(["=", addend, 0] for addend in form[1:])])
            case ["absurd", *_]:  # something non-zero = sum q * fact
                self.combination(1, proof, "the contradiction")
            case ["theorem", *_]:  # its premises have proofs, its conclusion is one more assumption
                theorem = self.theorem(goal, *proof["of"])
                for premise, inner in zip(theorem.premises, proof["premises"], strict=True):
                    self.branch(premise, inner)
                self.branch(goal, then, theorem.conclusion)
            case ["witness", "exists", bound, body]:  # values of the bound variables
                require(proof["point"].keys() == set(bound), "values for other variables")
                for x in bound:
                    self.fresh(x, *proof["point"].values())
                kept, self.algebra.values = (self.algebra.definitions, self.algebra.values), {}
                self.algebra.definitions = {**self.algebra.definitions, **proof["point"]}
                self.branch(body, then)
                self.algebra.definitions, self.algebra.values = kept
            case _:
                raise Reject(f"the rule {proof['rule']} does not fit a goal {goal[0]}")

    def check_proof(self, goal: Any, proof: Any) -> None:
        """The whole proof, and that nothing superfluous is listed."""
        algebra = self.algebra
        for reference, formula in self.hypotheses.items():
            self.learn(reference, formula)
        for term in terms(goal) if "nonzero" in proof else ():
            algebra.value(term)
        for texts in proof.get("nonzero", []):  # a numerator and the denominators in the denominator
            top, *below = map(algebra.polynomial, texts)
            self.listed[top * algebra.chance.inverse(prod(below)) % algebra.prime] = top
        require(self.listed.keys() <= algebra.divisors.keys(), "a side condition is no denominator of the claim")
        self.prove(goal, proof)
        positive = [algebra.value(term) % algebra.prime for term in proof.get("positive", ()) if self.sign(term) == 2]
        known = [(name, value) for name, (sign, value, _) in self.state.items() if sign in ("!=", ">")]
        for divisor in (value for value, varies in algebra.divisors.items() if varies):
            inverse = algebra.chance.inverse(divisor)
            by = [name for name, value in known if value == divisor or algebra.chance.rational(value * inverse)]
            self.used.update(by[:1])
            require(by or divisor in self.listed or divisor in positive, "a denominator may be zero")
        require(self.used >= self.hypotheses.keys(), "a hypothesis is not used")

    def check_point(self, goal: Any, point: Any) -> None:
        """The hypotheses hold at the point, the claim does not, and its sides have the stated values."""
        relation, algebra = goal[0] in RELATIONS, self.algebra
        given = {**point["values"], **{f"side_{k}": v for k, v in enumerate(point["sides"]) if relation}}
        angles = {x[4:] for x in given if x[:4] in ("sin_", "cos_")}
        taken = [x for x in given if x[:5] == "sqrt_" or x in algebra.definitions or x in angles]
        require(not taken, f"a value of {taken}: of a root, of a defined letter, or of an angle beside its sine")
        algebra.point, algebra.monomials = given, {}
        failing = [reference for reference, formula in self.hypotheses.items() if not self.truth(formula)]
        require(not failing and not self.truth(goal), f"{failing or 'the claim'}: not so at the point")
        for k, (side, stated) in enumerate(zip(goal[1:], point["sides"], strict=True)):
            value = self.truth(["=", side, f"side_{k}"] if relation else side)
            require(value == (relation or stated == "true"), "a side has another value at the point")
        circles = [["=", ["+", ["^", f"sin_{x}", 2], ["^", f"cos_{x}", 2]], 1] for x in angles]
        require(all(map(self.truth, circles)), "no point of the unit circle")

    def truth(self, formula: Any) -> bool:  # the formula at the point
        kind, *rest = formula
        if kind in RELATIONS:
            gap = (self.algebra.value(rest[0]) - self.algebra.value(rest[1])) % self.algebra.prime
            number = Fraction(gap > 0) if kind in ("=", "!=") else self.algebra.chance.rational(gap)
            require(number is not None, f"the sign of {formula}: an irrational number, or too many digits")
            return (number > 0) - (number < 0) in RELATIONS[kind]  # type: ignore[operator]
        parts = [self.truth(part) for part in rest]
        first, last = parts[0], parts[-1]
        return {"and": all(parts), "or": any(parts), "=>": last or not first, "<=>": first == last}[kind]


def check(certificate: dict[str, Any]) -> str | None:
    """None if the certificate proves (or refutes) its claim, else the reason why it does not."""
    try:
        checker = Checker(certificate)
        evidence = {"proved": ("proof", checker.check_proof), "refuted": ("point", checker.check_point)}
        key, verify = evidence[certificate["verdict"]]
        verify(certificate["claim"], certificate[key])
        require(checker.algebra.met >= checker.algebra.definitions.keys(), "a definition is not used")
    except (Reject, Unknown) as error:
        return str(error)
    except (LookupError, TypeError, ValueError, AttributeError, ArithmeticError, RecursionError) as error:
        return f"malformed ({type(error).__name__}: {error})"
    return None


def unsupported(each: dict[str, Any], proved: list[dict[str, Any]]) -> str | None:
    """For "lemmas imply the claim": None if every lemma is proved under hypotheses that are in force here."""
    if "lemmas" not in each:
        return None
    force = [formula for formulas in each.get("under", {}).values() for formula in formulas]
    own = dict(each["definitions"])  # a letter defined in a lemma is free here, or defined alike
    found = [
        part
        for lemma in proved
        if lemma["id"] in each["lemmas"] and "lemmas" not in lemma
        if all(formula in force for formulas in lemma["hypotheses"].values() for formula in formulas)
        if all(own.get(name, term) == term for name, term in lemma["definitions"])
        for part in conjuncts(lemma["claim"])
    ]
    missing = [part for part in conjuncts(each["claim"][1]) if part not in found]
    return "a lemma is not proved, or under other hypotheses or definitions" if missing else None


def main(arguments: list[str]) -> int:
    """Checks the files named, or those in the folders named: 0 all hold, 1 some do not, 2 a file cannot be read."""
    results: list[tuple[Path, str, str | None]] = []
    paths = [p for a in map(Path, arguments) for p in (sorted(a.glob("*.json")) if a.is_dir() else [a])]
    for path in paths or [Path("certificates")]:
        try:
            data = json.loads(path.read_text(encoding="utf-8"))
            require(isinstance(data, dict) and data.get("schema") == SCHEMA, f"its schema is not {SCHEMA}")
            checked = [(each, check(each)) for each in data["certificates"]]
            proved = [each for each, reason in checked if not reason and "proof" in each]
            results += [(path, each["id"], reason or unsupported(each, proved)) for each, reason in checked]
        except (Reject, OSError, ValueError, KeyError, TypeError, RecursionError) as error:
            print(f"checker: {path} cannot be read ({error}); name a folder or file of certificates", file=sys.stderr)
            return 2
    failures = [f"{path}: {identifier}: {reason}" for path, identifier, reason in results if reason]
    summary = f"{len(failures)} do not hold" if failures else "all hold"
    print(*failures, f"{len(results)} certificates, {summary}", sep="\n")
    return int(bool(failures))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
