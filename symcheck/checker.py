"""Re-checks certificates with the standard library alone: `python -m symcheck.checker DIR`.

A certificate states a claim (nested lists), the definitions and hypotheses it uses, and a proof (see `Checker.prove`)
or an exact point where the hypotheses hold and the claim does not. Whatever it comes down to are equations of terms.
Both sides are computed modulo a prime near 2^253, at a point, drawn once in every run: nobody who writes a certificate
can know them. Right equations always pass; that one of 2^32 false ones does is less probable than 2^-60: of a degree
below 2^100, it is zero at 2^-152 of the points, unless one of 2^92 out of 2^187 primes makes it zero. Sines and cosines
lie on the circle, roots of numbers are roots; a function without a rule here (a power with a letter in the exponent, an
integral) is a random function of the values it depends on; what is true of it is said by the table in `theorems.py`.
A denominator is non-zero by a hypothesis or in "nonzero". Irrational numbers at a point are compared by intervals.
"""

import gc
import json
import os
import re
import sys
from collections.abc import Callable
from glob import escape, glob
from math import prod

from symcheck.enclosures import Any, between, enclosed
from symcheck.residues import Reject, chance, polynomials, require
from symcheck.theorems import BINDING, CONSTANTS, OPAQUE, THEOREMS, Terms, Theorem, Unknown, conjuncts, contrary, sides

SCHEMA, MAX_DEGREE = 1, 1 << 60  # of a definition; powers and the length of a file add 2^40 at most
UNKNOWN = ("", 0, None)  # no assumption
RELATIONS = {"=": {0}, "!=": {-1, 1}, "<": {-1}, "<=": {-1, 0}, ">": {1}, ">=": {0, 1}}  # signs of left - right
CHOSEN = ("sin_", "cos_", "sqrt_")  # letters whose values are not free begin so


class Algebra(Terms):
    """Values of terms modulo the prime, definitions unfolded; notes the definitions and divisors it meets."""

    def __init__(self, definitions: list[Any]) -> None:
        super().__init__(dict(definitions))
        taken = [x for x in self.definitions if x.startswith(CHOSEN) or x in CONSTANTS]
        proper = len(self.definitions) == len(definitions) and not taken
        require(proper, "a name is defined twice, or is a sine, a cosine, a root or a constant")
        self.chance, self.prime = chance(), chance().prime
        self.polynomial = self.chance.polynomial
        self.values = {**self.chance.letters}  # of the names met, here or in other certificates
        for name in self.definitions.keys() & self.values.keys():
            del self.values[name]
        self.point: dict[str, Any] | None = None  # where a statement is refuted: all letters have values
        self.settled: dict[int, int] = {}  # values of functions there
        self.scope: dict[str, int] = {}  # values of bound variables
        self.inside, self.exponent = 0, 1
        self.atoms: dict[str, Any] = {}  # terms that stand as letters in polynomials
        self.divisors: dict[int, bool] = {}  # value -> whether it depends on letters or functions

    def value(self, term: Any) -> int:
        """The value of a term; sums and products are not reduced modulo the prime."""
        values, kind = self.values, type(term)
        if kind is str:
            return values[term] if term in values else self.named(term)
        if kind is int:
            return term  # type: ignore[no-any-return]
        sign = term[0]
        if sign == "*" or sign == "+":
            times = sign == "*"
            result = int(times)
            for t in term[1:]:
                value = values[t] if type(t) is str and t in values else self.value(t)
                result = result * value if times else result + value
            return result
        if sign == "^" and term[2] == 2 and type(term[2]) is int and type(term[1]) is str and len(term) == 3:
            return self.value(term[1]) ** 2  # most powers are so
        if sign not in OPERATIONS:
            raise Reject(f"the term {term!r}")
        return OPERATIONS[sign](self, *term[1:])

    def named(self, name: str) -> int:
        """The value of a letter, or of what a defined name stands for."""
        if name in self.scope:
            value = self.scope[name]
        elif name in self.definitions:
            require(self.degrees.get(name, 1), "the definition of {} refers to itself", name)
            self.degrees[name] = 0  # until it is known
            value = self.value(self.definition(name))
            self.degrees[name] = 1 + self.degree(self.definitions[name])
            require(self.degrees[name] < MAX_DEGREE, "the degree of {}", name)
        elif self.point is None or name[:5] == "sqrt_" or name in CONSTANTS:  # pi is transcendental, as a letter is
            value = self.chance.letters[name] = self.chance.letter(name) % self.prime
        else:
            require(name in self.point, "no value for {}", name)
            value = self.value(self.point[name])
        self.values[name] = value % self.prime
        return self.values[name]

    def number(self, name: str) -> Any:
        """What a letter of a closed term stands for, by definition or at the point."""
        known = self.point or {}
        require(name in self.definitions or name in known, "the number {}", name)
        return self.definition(name) if name in self.definitions else known[name]

    def letter(self, name: str) -> int:  # in a polynomial
        return self.value(self.atoms[name]) if name in self.atoms else self.chance.letter(name)

    def power(self, base: Any, exponent: int) -> int:
        size = abs(exponent)
        require(type(exponent) is int and self.exponent * size < 1000, "the exponent {}", exponent)
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
        self.divisors[value] = self.divisors.get(value, False) or not self.exact(term)
        return self.chance.inverse(value)

    def turn(self, term: Any) -> tuple[int, int]:
        """(cos, sin) of whole multiples of letters, by the addition theorem; another number is an angle of its own."""
        if isinstance(term, str) and term not in self.definitions and term not in CONSTANTS:
            return self.value(f"cos_{term}"), self.value(f"sin_{term}")
        cosine, sine, rest = 1, 0, term
        for x in sorted(self.names(term)):
            rate = self.rate(term, x)
            turns, parts = (None if self.names(rate) else self.chance.rational(self.value(rate))) or (0, 0)
            if x == "pi" and parts > 1:
                continue
            require(parts == 1 and abs(turns) < 100, "the angle {}", term)
            c, s = self.value(f"cos_{x}"), self.value(f"sin_{x}") * (1 if turns > 0 else -1)
            for _ in range(abs(turns)):
                cosine, sine = (cosine * c - sine * s) % self.prime, (sine * c + cosine * s) % self.prime
            rest = self.replaced(rest, {x: 0})
        if value := self.value(rest) % self.prime:  # 67 pi / 180, or arctan 2
            require(self.point is None, "the angle {}", term)
            c, s = self.chance.circle(("angle", value))
            cosine, sine = (cosine * c - sine * s) % self.prime, (sine * c + cosine * s) % self.prime
        return cosine, sine

    def opaque(self, kind: str, *terms: Any) -> int:
        """A function of the values; the root of a number and a power with a whole exponent are what they are."""
        values = [self.value(term) % self.prime for term in terms]
        if kind == "sqrt" and (self.point is not None or not self.names(terms[0])):
            return self.chance.root(self.chance.rational(*values))
        if kind == "pow" and (whole := self.chance.rational(values[1])) and whole[1] == 1:
            if whole[0] >= 0:
                return pow(values[0], whole[0], self.prime)
            # under an integral the base of such a power is positive by its meaning, elsewhere that has to be shown
            below = self.chance.inverse(values[0]) if self.inside else self.inverse(terms[0])
            return pow(below, -whole[0], self.prime)
        return self.settle(self.chance.draw((kind, *values)))

    def call(self, name: str, orders: Any, *terms: Any) -> int:
        """A partial derivative of an unknown smooth function: one random number for equal orders and arguments."""
        require(len(orders) == len(terms) and all(n in range(99) for n in orders), "the orders {} of {}", orders, name)
        return self.settle(self.chance.draw(("call", name, *orders, *(self.value(t) % self.prime for t in terms))))

    def settle(self, value: int) -> int:
        """The value of a function, or at a point the one it is proved to have there."""
        require(self.point is None or self.inside or value in self.settled, "no value for a function at the point")
        return self.settled.get(value, value)

    def bound(self, kind: str, body: Any, x: str, *ends: Any) -> int:
        """An integral or a mean: a function of the ends and of the body, which is taken at a value of x of its own."""
        require(len(ends) == 2 * (kind != "mean"), "the {} of {}", kind, body)
        limits = [self.value(end) % self.prime for end in ends]
        kept, self.inside = (self.scope, self.values), self.inside + 1
        key = ("bound", self.inside)
        own = dict(zip((x, f"cos_{x}", f"sin_{x}"), (self.chance.draw(key), *self.chance.circle(key)), strict=True))
        self.scope, self.values = {**self.scope, **own}, {}
        value = self.value(body) % self.prime
        (self.scope, self.values), self.inside = kept, self.inside - 1
        return self.settle(self.chance.draw((kind, value, *limits)))


OPERATIONS: dict[str, Callable[..., int]] = {
    "-": lambda a, term: -a.value(term),
    "/": lambda a, top, bottom: a.value(top) * a.inverse(bottom) % a.prime,
    "^": Algebra.power,
    "cos": lambda a, term: a.turn(term)[0],
    "sin": lambda a, term: a.turn(term)[1],
    "tan": lambda a, term: a.value(["/", ["sin", term], ["cos", term]]),
    "diff": lambda a, term, x, order: a.value(a.derived(term, x, order)),
    "call": Algebra.call,
    **{kind: lambda a, *t, kind=kind: a.opaque(kind, *t) for kind in OPAQUE},
    **{kind: lambda a, *t, kind=kind: a.bound(kind, *t) for kind in BINDING},
}


class Checker:
    """One certificate being checked: facts (that are zero), conditions (not zero), signs, disjunctions."""

    def __init__(self, certificate: dict[str, Any]) -> None:
        self.algebra = Algebra(certificate["definitions"])
        self.hypotheses = {("hyp", n, k): f for n, fs in certificate["hypotheses"].items() for k, f in enumerate(fs)}
        self.claim = certificate["claim"]
        self.used: set[Any] = set()
        self.listed: dict[int, int] = {}  # denominators about which no hypothesis speaks, with their numerators
        self.positive: set[int] = set()  # denominators that are manifestly positive, or negative
        self.state: dict[Any, tuple[str, Any, Any]] = {}  # sign, value (of a disjunction: its parts) and source

    def learn(self, reference: Any, formula: Any) -> None:
        """Takes in one assumption."""
        sign, *content = formula
        if sign in RELATIONS:
            large, small = map(self.algebra.value, content[::-1] if sign[0] == "<" else content)
            sign, content = sign.replace("<", ">"), (large - small) % self.algebra.prime
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
        texts = [name for s in sources if isinstance(s, str) for name in re.findall(r"[A-Za-z]\w*", s)]
        terms = [*(s for s in sources if not isinstance(s, str)), *(self.algebra.atoms.get(t, t) for t in texts)]
        taken = {*self.algebra.definitions, *CONSTANTS}.union(*map(self.algebra.names, [*terms, *beside]))
        require(not {x, f"sin_{x}", f"cos_{x}"} & taken, "the letter {} is taken", x)

    def known(self, signs: tuple[str, ...], reference: Any) -> int:
        """The value of an assumption with one of the signs; hypotheses are marked as used."""
        if reference[0] == "positive" and ">" in signs:
            require(self.sign(reference[1]) == 2, "{} is not manifestly positive", reference[1])
            return self.algebra.value(reference[1])
        reference = tuple(reference)
        sign, value, _ = self.state.get(reference, UNKNOWN)
        require(sign in signs, "{} is no such assumption", reference)
        self.used.add(reference)
        return value  # type: ignore[no-any-return]

    def combination(self, value: Any, proof: Any, what: str) -> None:
        """The value, times denominators and things that are not zero, is the sum of cofactors times facts."""
        for text in proof.get("clear", ()):
            value *= (divisor := self.algebra.polynomial(text))
            met = divisor in self.algebra.divisors or divisor in self.listed.values() or divisor in self.positive
            require(met, "{} is no denominator", text)
        for reference in proof.get("times", ()):
            value *= self.known(("!=", ">"), reference)
        for reference, *cofactor in proof["cofactors"]:
            product = prod(map(self.algebra.polynomial, cofactor), start=self.known(("=",), reference))
            require(product, "{}: the fact {} says nothing", what, reference)
            value -= product
        require(value % self.algebra.prime == 0, "{} is not the combination of facts it is said to be", what)

    def sign(self, term: Any) -> int:
        """2 if manifestly positive, 1 if manifestly not negative, else 0."""
        result = 0
        match term:
            case int():
                return (term >= 0) + (term > 0)
            case ["+", *parts]:
                result = max(levels := [self.sign(part) for part in parts]) * all(levels)
            case ["*", *parts]:  # equal factors pair up to squares
                single: list[Any] = []
                for t in parts:
                    (single.remove if t in single else single.append)(t)
                result = min([1 if len(single) < len(parts) else 2, *map(self.sign, single)])
            case ["/", top, bottom]:
                result = min(self.sign(top), 2 * bool(self.sign(bottom)))
            case ["^", base, int(n)] if n > 0:
                result = self.sign(base) or int(n % 2 == 0)
        if result:
            return result
        value = self.algebra.value(term) % self.algebra.prime
        for reference, (sign, other, _) in self.state.items():
            if value == other and sign in (">", ">="):
                self.used.add(reference)
                return 3 - len(sign)
        defined = type(term) is str and term in self.algebra.definitions
        return self.sign(self.algebra.definitions[term]) if defined else 0

    def theorem(self, goal: Any, name: str, *given: Any) -> Theorem:
        """One of the theorems that are taken for granted, if its letters are free for it."""
        require(name in THEOREMS, "the theorem {}", name)
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
                self.branch(["or"], then, contrary([sign, *sides]))
            case ["each", "and" | "<=>" as kind, *parts]:
                parts = parts if kind == "and" else [["=>", *parts], ["=>", *parts[::-1]]]
                for part, inner in zip(parts, proof["parts"], strict=True):
                    self.branch(part, inner)
            case ["choose", "or", *parts]:
                self.branch(dict(enumerate(parts))[proof["index"]], then)
            case ["cases_or", *_]:  # the goal in every case of an assumed disjunction
                kind, parts, _ = self.state[tuple(proof["or"])]
                require(kind == "or", f"{proof['or']} is no disjunction")
                self.used.add(tuple(proof["or"]))
                for part, inner in zip(parts, proof["cases"], strict=True):
                    self.branch(goal, inner, part)
            case ["split", *_]:  # (non-zero) * product of powers = sum q * fact: one of the bases is zero
                require(all(e in range(1, 1000) for _, e in proof["factors"]), "an exponent that is not a small number")
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
        if "atoms" in proof:
            algebra.atoms, algebra.polynomial = proof["atoms"], polynomials(algebra.chance, algebra.letter)
        for reference, formula in self.hypotheses.items():
            self.learn(reference, formula)
        for term in sides(goal) if "nonzero" in proof else ():
            algebra.value(term)
        for texts in proof.get("nonzero", []):  # a numerator and the denominators in the denominator
            top, *below = map(algebra.polynomial, texts)
            self.listed[top * algebra.chance.inverse(prod(below)) % algebra.prime] = top
        require(self.listed.keys() <= algebra.divisors.keys(), "a side condition is no denominator of the claim")
        positive = [algebra.value(term) % algebra.prime for term in proof.get("positive", ()) if self.sign(term) == 2]
        self.positive = {value for each in positive for value in (each, algebra.prime - each)}
        self.prove(goal, proof)
        known = [(name, value) for name, (sign, value, _) in self.state.items() if value and sign in ("!=", ">")]
        for divisor in (value for value, varies in algebra.divisors.items() if varies):
            inverse = algebra.chance.inverse(divisor)
            by = next((name for name, value in known if algebra.chance.rational(value * inverse)), None)
            require(by or divisor in self.listed or divisor in self.positive, "a denominator may be zero")
            self.used.add(by)
        require(self.used >= self.hypotheses.keys(), "a hypothesis is not used")

    def check_point(self, goal: Any, point: Any) -> None:
        """The hypotheses hold at the point, the claim does not, and its sides have the stated values."""
        if "enclosed" in point:
            return self.check_numbers(goal, point["values"], point["enclosed"])
        if "proof" in point:
            return self.check_contrary(goal, point["values"], [*point.get("facts", ()), [None, point["proof"]]])
        relation, algebra = goal[0] in RELATIONS, self.algebra
        given = {**point["values"], **{f"side_{k}": v for k, v in enumerate(point["sides"]) if relation}}
        angles = {x[4:] for x in given if x[:4] in ("sin_", "cos_")}
        taken = [x for x in given if x[:5] == "sqrt_" or x in CONSTANTS or x in algebra.definitions or x in angles]
        taken += angles & {*CONSTANTS}
        require(not taken, "a value of {}: of a root, of a defined letter, or of an angle beside its sine", taken)
        texts = {x: [*map(int, v.split("/", 1))] for x, v in given.items() if isinstance(v, str)}  # "-3" or "2/7"
        numbers = {**given, **{x: v[0] if len(v) == 1 else ["/", *v] for x, v in texts.items()}}
        plain = [(x, number) for x, number in numbers.items() if x[:4] not in ("sin_", "cos_")]
        for term, value, proof in point.get("functions", ()):  # the values of functions there, with proofs
            inner = Checker({"definitions": plain, "hypotheses": {}, "claim": ["=", term, value]})
            inner.check_proof(inner.claim, proof)
            algebra.settled[inner.algebra.value(term)] = inner.algebra.value(value)
        algebra.point, algebra.values = numbers, {x: v[0] for x, v in texts.items() if len(v) == 1}
        for name, orders, arguments, number in point.get("calls", ()):  # free where the arguments differ
            at, value = [tuple(map(self.number_at, each)) for each in (arguments, [number])]
            key = algebra.chance.draw(("call", name, *orders, *at))
            require(algebra.settled.setdefault(key, value[0]) == value[0], "{} has two values at a point", name)
        failing = [reference for reference, formula in self.hypotheses.items() if not self.truth(formula)]
        require(not failing and not self.truth(goal), f"{failing or 'the claim'}: not so at the point")
        for k, (side, stated) in enumerate(zip(goal[1:], point["sides"], strict=True)):
            value = self.truth(["=", side, f"side_{k}"] if relation else side)
            require(value == (relation or stated == "true"), "a side has another value at the point")
        circles = [["=", ["+", ["^", f"sin_{x}", 2], ["^", f"cos_{x}", 2]], 1] for x in angles]
        require(all(map(self.truth, circles)), "no point of the unit circle")

    def number_at(self, number: Any) -> int:
        """The value of a coordinate of a point, "2/7" or a term of numbers."""
        if isinstance(number, str):
            top, _, bottom = number.partition("/")
            return self.algebra.value(["/", int(top), int(bottom or 1)]) % self.algebra.prime
        require(self.algebra.exact(number), "the number {}", number)
        return self.algebra.value(number) % self.algebra.prime

    def check_numbers(self, goal: Any, values: dict[str, Any], shown: Any) -> None:
        """The same where the letters are numbers such as 67 pi / 180: by interval arithmetic, with the stated ends."""
        self.algebra = Algebra([*self.algebra.definitions.items(), *values.items()])
        failing = [reference for reference, formula in self.hypotheses.items() if not self.truth(formula)]
        require(not failing and not self.truth(goal), f"{failing or 'the claim'}: not so at the point")
        for term, digits, *ends in shown:
            require(ends == [*between(term, self.algebra.number, digits)], "{} lies elsewhere", term)

    def check_contrary(self, goal: Any, values: dict[str, Any], proofs: Any) -> None:
        """The same by proofs where the letters are these numbers: of facts, then of the hypotheses and the contrary."""
        require(not self.algebra.names(["+", *values.values()]) - {"pi"}, "the point is made of letters")
        taken = [x for x in values if x.startswith(CHOSEN) or x in CONSTANTS or x in self.algebra.definitions]
        known = {"point": [["=", x, value] for x, value in values.items()]}
        for fact, proof in proofs:
            require(not taken and "nonzero" not in proof, "a value of {}, or a proof under a condition", taken)
            fact = fact or ["and", *self.hypotheses.values(), contrary(goal)]
            inner = Checker({"definitions": [*self.algebra.definitions.items()], "hypotheses": known, "claim": fact})
            inner.used.update(inner.hypotheses)  # not all are needed each time
            inner.check_proof(fact, proof)
            known["point"].append(fact)
        self.algebra.names(["and", goal, *self.hypotheses.values()])  # notes the definitions

    def order(self, left: Any, right: Any) -> int:
        """The sign of a difference of numbers: by its digits, or zero where the numbers are the same by algebra."""
        chosen = {str([x[:3], x[4:]]): x for x in self.algebra.point or () if x[:4] in ("sin_", "cos_")}
        gap = self.algebra.replaced(["+", left, ["-", right]], chosen)
        digits = enclosed(gap, self.algebra.number)
        near = digits.low <= 0 <= digits.high
        same = near and (digits.low == digits.high or self.algebra.value(gap) % self.algebra.prime == 0)
        require(same or digits.low > 0 or digits.high < 0, "too few digits to compare {} and {}", left, right)
        return (digits.low > 0) - (digits.high < 0)

    def truth(self, formula: Any) -> bool:  # the formula at the point
        kind, *rest = formula
        if kind in RELATIONS and self.algebra.point is None:  # the letters are defined as numbers
            return self.order(*rest) in RELATIONS[kind]
        if kind in RELATIONS:
            gap = (self.algebra.value(rest[0]) - self.algebra.value(rest[1])) % self.algebra.prime
            number = (gap, 1) if kind in ("=", "!=") else self.algebra.chance.rational(gap)
            return ((number[0] > 0) - (number[0] < 0) if number else self.order(*rest)) in RELATIONS[kind]
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
        checker.algebra.names(["and", certificate["claim"], *checker.hypotheses.values()])  # what is stated is used
        require(checker.algebra.met >= dict(certificate["definitions"]).keys(), "a definition is not used")
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


def main(arguments: list[str], end: Callable[[int], int] = int) -> int:
    """Checks the files named, or those in the folders named: 0 all hold, 1 some do not, 2 a file cannot be read.

    `end` may end the process: to clear the memory up would take longer than many a certificate.
    """
    results: list[tuple[str, str, str | None]] = []
    for path in [p for a in arguments for p in sorted(glob(escape(a) + "/*.json")) or [a]] or ["certificates"]:
        try:
            with open(path, encoding="utf-8") as file:
                data = json.load(file)
            require(isinstance(data, dict) and data.get("schema") == SCHEMA, f"its schema is not {SCHEMA}")
            checked = [(each, check(each)) for each in data["certificates"]]
            proved = [each for each, reason in checked if not reason and "proof" in each]
            results += [(path, each["id"], reason or unsupported(each, proved)) for each, reason in checked]
        except (Reject, OSError, ValueError, KeyError, TypeError, RecursionError) as error:
            print(f"checker: {path} cannot be read ({error}); name a folder or file of certificates", file=sys.stderr)
            return 2
    failures = [f"{path}: {identifier}: {reason}" for path, identifier, reason in results if reason]
    summary = f"{len(failures)} do not hold" if failures else "all hold"
    print(*failures, f"{len(results)} certificates, {summary}", sep="\n", flush=True)
    return end(bool(failures))


if __name__ == "__main__":
    gc.disable()  # nothing is thrown away before the end
    sys.exit(main(sys.argv[1:], os._exit))
