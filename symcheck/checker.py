"""Re-checks certificates with the standard library alone: `python -m symcheck.checker DIR`.

A certificate states a claim (nested lists), the definitions and hypotheses it uses, and a proof (see `Checker.prove`)
or an exact point where the hypotheses hold and the claim does not. Terms become fractions of polynomials {monomial:
coefficient}, a monomial being a whole number: 16 bits per exponent above 32 bits for the degree; sin x, cos x and the
root of a prime p are variables sin_x, cos_x, sqrt_p. A denominator is non-zero by a hypothesis or listed in "nonzero".
"""

import hashlib
import json
import re
import sys
from collections import Counter
from fractions import Fraction
from math import isqrt, prod
from pathlib import Path
from typing import Any

SCHEMA, MAX_DEGREE, DEGREE = 1, 30_000, (1 << 32) - 1
RELATIONS = {"=": {0}, "!=": {-1, 1}, "<": {-1}, "<=": {-1, 0}, ">": {1}, ">=": {0, 1}}  # signs of left - right
Poly = dict[int, Any]
Divisors = Counter[frozenset[tuple[int, Any]]]  # the terms of each divisor, with its exponent
Ratio = tuple[Poly, Divisors]
ONE, MINUS, NONE = Poly({0: 1}), Poly({0: -1}), Divisors()


class Reject(Exception):
    """The certificate does not prove its claim; the message says where it fails."""


def require(condition: Any, reason: str) -> None:
    """Rejects with the reason unless the condition holds."""
    if not condition:
        raise Reject(reason)


def combine(*addends: tuple[Poly, Poly]) -> Poly:
    """The sum of the products. No exponent is above MAX_DEGREE, so that no sum of two overflows its 16 bits."""
    result: Poly = {}
    for a, b in addends:
        for m, c in a.items():
            for n, d in b.items():
                result[m + n] = result.get(m + n, 0) + c * d
    require(max((m & DEGREE for m in result), default=0) <= MAX_DEGREE, "a polynomial of too high a degree")
    return {m: c for m, c in result.items() if c}


def powers(*factors: tuple[Any, int]) -> Poly:
    """The product of base^exponent, the bases being polynomials or their terms; exponents are small."""
    result = ONE
    for base, exponent in factors:
        require(exponent in range(1000), "a power out of range")
        for _ in range(exponent):
            result = dict(base) if result is ONE else combine((result, dict(base)))
    return result


def total(values: list[Ratio]) -> Ratio:
    """The sum over the least common denominator."""
    common = NONE
    for _, den in values:
        common = common | den if den else common
    return combine(*((num, powers(*(common - den).items()) if common else ONE) for num, den in values)), common


def product(values: list[Ratio]) -> Ratio:
    """The product; a factor that equals one of the divisors cancels with it."""
    common, result = sum((den for _, den in values if den), NONE), ONE
    for num, _ in values:
        if common and common[key := frozenset(num.items())] > 0:
            common[key] -= 1
        else:
            result = num if result is ONE else combine((result, num))
    return result, +common if common else NONE


def proportional(a: Poly, b: Poly) -> Any:
    """The number f with a = f * b, or None."""
    if not a or a.keys() != b.keys():
        return None
    factor = Fraction(next(iter(a.values()))) / b[next(iter(a))]
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


def conjuncts(formula: Any) -> list[Any]:
    """The formula taken apart at "and"."""
    return [part for child in formula[1:] for part in conjuncts(child)] if formula[0] == "and" else [formula]


class Algebra:
    """Terms as fractions of polynomials, definitions unfolded; notes the definitions and divisors it meets."""

    def __init__(self, definitions: list[Any]) -> None:
        self.definitions: dict[str, Any] = dict(definitions)
        require(len(self.definitions) == len(definitions), "a name is defined twice")
        self.unfolded: dict[str, Any] = {}
        self.point: dict[str, Poly] = {}  # values of variables, where a statement is to be refuted
        self.met: set[str] = set()
        self.divisors: list[Poly] = []
        self.slots: dict[str, int] = {}
        self.factors: dict[str, tuple[int, Any]] = {}

    def variable(self, name: str) -> Poly:  # the polynomial of one variable
        if name not in self.slots:
            prime = name[:5] != "sqrt_" or root(Fraction(name[5:]))[1] == [int(name[5:])]
            require(prime and re.fullmatch("[A-Za-z][A-Za-z0-9_]*", name), f"the name {name!r}")
            self.slots[name] = 32 + 16 * len(self.slots)
        return {(1 << self.slots[name]) + 1: 1}

    def exponents(self, monomial: int) -> dict[str, int]:  # the variables of a monomial with their exponents
        return {x: e for x, slot in self.slots.items() if (e := monomial >> slot & 0xFFFF)}

    def factor(self, text: str) -> tuple[int, Any]:  # a number or a power of a variable, as (monomial, coefficient)
        if re.fullmatch(r"\d+(/[1-9]\d*)?", text):
            return 0, Fraction(text) if "/" in text else int(text)
        name, _, exponent = text.partition("^")
        require(re.fullmatch(r"\d{0,3}", exponent), f"the factor {text}")
        return next(iter(self.variable(name))) * int(exponent or 1), 1

    def parse(self, text: str) -> Poly:  # a polynomial printed as "3/4*a_11^2*a_12 - I_1 + 2"
        result: Poly = {}
        for term in text.replace(" - ", " + -").split(" + ") if text != "0" else ():
            monomial, coefficient = 0, -1 if term[0] == "-" else 1
            for factor in term.removeprefix("-").split("*"):
                if factor not in self.factors:
                    self.factors[factor] = self.factor(factor)
                m, c = self.factors[factor]
                monomial, coefficient = monomial + m, coefficient * c
            require(coefficient and monomial not in result and monomial & DEGREE < 9999, f"the polynomial {text}")
            result[monomial] = coefficient
        return result

    def name(self, name: str) -> Ratio:  # a variable, or what a defined name stands for
        if name not in self.definitions:
            return self.point[name] if name in self.point else self.variable(name), NONE
        if name not in self.unfolded:
            self.met.add(name)
            self.unfolded[name] = None
            self.unfolded[name] = self.ratio(self.definitions[name])
        require(self.unfolded[name], f"the definition of {name} refers to itself")
        return self.unfolded[name]  # type: ignore[no-any-return]

    def ratio(self, term: Any) -> Ratio:  # the term as a fraction
        match term:
            case int():
                return ({0: int(term)} if term else {}), NONE
            case str():
                return self.name(term)
            case ["+", *parts] if parts:
                return total([self.ratio(part) for part in parts])
            case ["*", *parts] if parts:
                return product([self.ratio(part) for part in parts])
            case ["-", inner]:
                return product([self.ratio(inner), (MINUS, NONE)])
            case ["/", top, bottom]:
                return product([self.ratio(top), self.inverse(bottom)])
            case ["^", base, int(n)] if abs(n) < 1000:
                return product([self.ratio(base) if n >= 0 else self.inverse(base)] * abs(n))
            case ["sin" | "cos" as function, inner]:
                return self.turn(inner)[function == "sin"], NONE
            case ["tan", inner]:
                return self.ratio(["/", ["sin", inner], ["cos", inner]])
            case ["sqrt", inner]:
                num, den = self.ratio(inner)
                require(not den and set(num) <= {0}, "the root of what is not a number")
                outside, primes = root(Fraction(num.get(0, 0)))
                roots = [(self.variable(f"sqrt_{p}"), 1) for p in primes]
                return powers(({0: outside} if outside else {}, 1), *roots), den
            case ["diff", inner, str(x), int(n)] if 0 < n < 9:
                point, memory, self.point, self.unfolded = self.point, self.unfolded, {}, {}
                num, den = self.derivative(self.ratio(["diff", inner, x, n - 1] if n > 1 else inner), x)
                self.point, self.unfolded = point, memory
                if point:
                    self.divisors.append(bottom := self.substitute(powers(*den.items()), point))
                    num, den = self.substitute(num, point), Counter([frozenset(bottom.items())])
                return num, den
        raise Reject(f"the term {term!r}")

    def inverse(self, term: Any) -> Ratio:  # 1 / term, factor by factor; notes the divisors
        match term:
            case ["*", *parts]:
                return product([self.inverse(part) for part in parts])
            case ["^", base, int(n)] if 0 < n < 1000:
                return product([self.inverse(base)] * n)
        divisor, den = self.ratio(term)
        require(divisor, "division by zero")
        exponents = self.exponents(next(iter(divisor)))
        if len(divisor) == 1 and all(x.startswith("sqrt_") for x in exponents):  # 1/sqrt(p) = sqrt(p)/p
            inverses = [(combine((self.variable(x), {0: Fraction(1, int(x[5:]))})), e) for x, e in exponents.items()]
            return powers(*den.items(), ({0: 1 / Fraction(*divisor.values())}, 1), *inverses), NONE
        self.divisors.append(divisor)
        return powers(*den.items()), Counter([frozenset(divisor.items())])

    def turn(self, term: Any) -> tuple[Poly, Poly]:
        """(cos, sin) of an integer combination of variables, by the addition theorem; half angles are rejected."""
        num, den = self.ratio(term)
        cosine, sine = ONE, Poly()
        for monomial, count in num.items():
            require(not den and monomial & DEGREE == 1 and count in range(-99, 100), f"the angle {term}")
            (x,) = self.exponents(monomial)
            c, s = self.name(f"cos_{x}")[0], combine((self.name(f"sin_{x}")[0], ONE if count > 0 else MINUS))
            for _ in range(abs(int(count))):
                cosine, sine = combine((cosine, c), (sine, combine((s, MINUS)))), combine((sine, c), (cosine, s))
        return cosine, sine

    def derivative(self, value: Ratio, name: str) -> Ratio:
        """d/d name by the quotient rule; sin and cos of the name depend on it too."""
        require(name not in self.definitions, f"a derivative by {name}, which is not a free variable")
        x, s, c, (step,) = (self.variable(y) for y in (name, f"sin_{name}", f"cos_{name}", "step"))
        moved = {name: (x, ONE), f"sin_{name}": (s, c), f"cos_{name}": (c, combine((s, MINUS)))}
        values = {y: combine((old, ONE), (change, {step: 1})) for y, (old, change) in moved.items()}
        num, den = value[0], powers(*value[1].items())
        require(not any("step" in self.exponents(m) for m in (*num, *den)), "the name step is taken")
        shifted = [self.substitute(poly, values) for poly in (num, den)]  # the derivative is linear in the step
        rates = [{m - step: k for m, k in p.items() if self.exponents(m).get("step") == 1} for p in shifted]
        return combine((rates[0], den), (powers((num, 1), (MINUS, 1)), rates[1])), value[1] + value[1]

    def substitute(self, poly: Poly, values: dict[str, Poly]) -> Poly:
        """The polynomial with some variables replaced by polynomials."""
        addends = []
        for monomial, coefficient in poly.items():
            bases = [(values[x] if x in values else self.variable(x), e) for x, e in self.exponents(monomial).items()]
            addends.append((powers(*bases), {0: coefficient}))
        return combine(*addends)

    def order(self, poly: Poly) -> int:
        """The sign of a combination of roots of square-free numbers, by integer enclosures."""
        value: dict[int, Fraction] = {}
        for monomial, coefficient in poly.items():
            exponents = self.exponents(monomial)
            require(all(x.startswith("sqrt_") for x in exponents), f"no value for one of {[*exponents]}")
            radicand = prod(int(x[5:]) for x, e in exponents.items() if e % 2)
            coefficient *= prod(int(x[5:]) ** (e // 2) for x, e in exponents.items())
            value[radicand] = value.get(radicand, Fraction(0)) + coefficient
        precision = 1
        while any(value.values()):  # the roots are independent: only then is the sum zero
            low = high = Fraction(0)
            for radicand, coefficient in value.items():
                near = isqrt(radicand * 4**precision)
                ends = [coefficient * Fraction(n, 2**precision) for n in (near, near + (radicand > 1))]
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
        self.stated = json.dumps([certificate["claim"], certificate["definitions"], certificate["hypotheses"]])
        self.used: set[Any] = set()
        self.state: list[tuple[Any, str, Any]] = []  # reference, sign, polynomial (of a disjunction: its parts)

    def learn(self, reference: Any, formula: Any) -> None:
        """Takes in one assumption; what is neither relation nor disjunction stays without use."""
        sign, *sides = formula
        if sign in ("<", "<="):
            sign, sides = sign.replace("<", ">"), sides[::-1]
        difference = ["+", sides[0], ["-", sides[1]]] if sign in RELATIONS else None
        content, den = self.algebra.ratio(difference) if difference else (sides, NONE)
        self.state.append((reference, {">": "!=", ">=": ""}.get(sign, sign) if den else sign, content))

    def branch(self, goal: Any, proof: Any, assumed: Any = ("and",), fact: Poly | None = None) -> None:
        """Proves a goal under more assumptions, numbered in their order and forgotten afterwards."""
        size, own = len(self.state), len(self.hypotheses)
        for part in conjuncts(assumed):
            self.learn(("here", len(self.state) - own), part)
        if fact is not None:
            self.state.append((("here", len(self.state) - own), "=", fact))
        self.prove(goal, proof)
        del self.state[size:]

    def known(self, signs: tuple[str, ...], reference: Any) -> Poly:
        """The polynomial of an assumption with one of the signs; hypotheses are marked as used."""
        match reference:
            case ["axiom", "pythagoras", str(x)]:
                s, c = (self.algebra.variable(f"{function}_{x}") for function in ("sin", "cos"))
                return combine((s, s), (c, c), (MINUS, ONE))
            case ["axiom", "sqrt", int(p)]:
                return combine((r := self.algebra.variable(f"sqrt_{p}"), r), ({0: -p}, ONE))
            case ["positive", term] if ">" in signs:
                require(self.sign(term) == 2, f"{term} is not manifestly positive")
                return self.algebra.ratio(term)[0]
        for name, sign, poly in self.state:
            if name == tuple(reference) and sign in signs:
                self.used.add(name)
                return dict(poly)
        raise Reject(f"{reference} is no such assumption")

    def combination(self, poly: Poly, proof: Any, what: str) -> None:
        """The polynomial, times things that are not zero, is the sum of cofactors times facts."""
        for reference in proof.get("times", ()):
            poly = combine((poly, self.known(("!=", ">"), reference)))
        products = [(self.algebra.parse(cofactor), self.known(("=",), ref)) for ref, cofactor in proof["cofactors"]]
        right = all(q and p for q, p in products) and combine(*products) == poly
        require(right, f"{what} is not the combination of facts it is said to be, all of them used")

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
        num, den = self.algebra.ratio(term)
        for reference, sign, poly in () if den else self.state:  # a positive multiple of an assumption?
            if sign in (">", ">=") and (factor := proportional(num, poly)) and factor > 0:
                self.used.add(reference)
                return 3 - len(sign)
        return self.sign(self.algebra.definitions[term]) if str(term) in self.algebra.definitions else 0

    def prove(self, goal: Any, proof: Any) -> None:
        """One node of a proof. In an order, larger - smaller is a form manifestly not negative (positive for <)."""
        then, form = proof.get("then"), proof.get("form")
        match [proof["rule"], *goal]:
            case ["identity", "=", left, right]:  # num(l - r) = sum q * fact
                self.combination(self.algebra.ratio(["+", left, ["-", right]])[0], proof, "left - right")
            case ["nonnegative", "<" | "<=" as sign, small, large] | ["nonnegative", ">" | ">=" as sign, large, small]:
                require(self.sign(form) >= 3 - len(sign), "the form is not manifestly of one sign")
                gap = self.algebra.ratio(["+", large, ["-", small], ["-", form]])
                self.combination(gap[0], proof, "the difference less the form")
            case ["implies", "=>", assumed, conclusion]:
                self.branch(conclusion, then, assumed)
            case ["implies", "!=", *sides]:  # l = r leads to a contradiction: the empty "or"
                self.branch(["or"], then, ["=", *sides])
            case ["each", "and" | "<=>" as kind, *parts]:
                parts = parts if kind == "and" else [["=>", *parts], ["=>", *parts[::-1]]]
                for part, inner in zip(parts, proof["parts"], strict=True):
                    self.branch(part, inner)
            case ["choose", "or", *parts]:
                self.branch(dict(enumerate(parts))[proof["index"]], then)
            case ["cases_or", *_]:  # the goal in every case of an assumed disjunction
                reference, parts = [(name, parts) for name, sign, parts in self.state if sign == "or"][proof["or"]]
                self.used.add(reference)
                for part, inner in zip(parts, proof["cases"], strict=True):
                    self.branch(goal, inner, part)
            case ["split", *_]:  # (non-zero) * product of powers = sum q * fact: one of the bases is zero
                factors = [(self.algebra.parse(text), exponent) for text, exponent in proof["factors"]]
                require(all(exponent > 0 for _, exponent in factors), "an exponent that is not positive")
                self.combination(powers(*factors), proof, "the product")
                for (base, _), inner in zip(factors, proof["cases"], strict=True):
                    self.branch(goal, inner, fact=base)
            case ["vanish", *_]:  # a sum of non-negative addends is zero, so each addend is
                require(form[0] == "+" and all(map(self.sign, form[1:])), "an addend is not manifestly non-negative")
                self.combination(self.algebra.ratio(form)[0], proof, "the form")
                self.branch(goal, then, ["and", *(["=", addend, 0] for addend in form[1:])])
            case ["absurd", *_]:  # something non-zero = sum q * fact
                self.combination(ONE, proof, "the contradiction")
            case ["witness" | "quarter_turn" as rule, "exists", bound, body] if len(self.state) == len(self.hypotheses):
                (self.witness if rule == "witness" else self.quarter_turn)(bound, body, proof)
            case _:
                raise Reject(f"the rule {proof['rule']} does not fit a goal {goal[0]}")

    def witness(self, bound: Any, body: Any, proof: Any) -> None:
        """Values for the bound variables; they may contain an angle, still to be found."""
        angles, algebra = proof.get("angle", []), self.algebra
        taken = [x for x in angles if f'"{x}"' in self.stated]
        require(proof["point"].keys() == set(bound) and not taken, "values for other variables, or a name taken")
        kept = algebra.definitions, algebra.unfolded
        algebra.definitions, algebra.unfolded = {**algebra.definitions, **proof["point"]}, {}
        self.branch(["exists", angles, body] if angles else body, proof["then"])
        algebra.definitions, algebra.unfolded = kept

    def quarter_turn(self, bound: Any, body: Any, proof: Any) -> None:
        """P turned by 90 degrees is -P: P has a zero on the circle; the other equations are multiples of P there."""
        c, s, algebra = f"cos_{bound[0]}", f"sin_{bound[0]}", self.algebra
        taken = {x for _, sign, p in self.state if sign in RELATIONS for m in p for x in algebra.exponents(m)}
        free = len(bound) == 1 and not (taken | algebra.definitions.keys()) & {c, s, *bound}
        equations = [algebra.ratio(["+", f[1], ["-", f[2]]])[0] for f in conjuncts(body) if f[0] == "="]
        leading, below = equations[proof["index"]], {m for divisor in algebra.divisors for m in divisor}
        plain = any(bound[0] in algebra.exponents(m) for m in leading) or len(equations) < len(conjuncts(body))
        polynomial = not plain and not any({c, s} & algebra.exponents(m).keys() for m in below)
        require(free and polynomial, "no free angle, or no polynomial equations of its sine and cosine")
        values = {c: combine((algebra.variable(s), MINUS)), s: algebra.variable(c)}
        turned = combine((leading, ONE), (algebra.substitute(leading, values), ONE))
        self.combination(turned, proof, "the turned equation")
        for poly, (multiple, cofactors) in zip(equations, proof["others"], strict=True):
            gap = combine((poly, ONE), (leading, combine((algebra.parse(multiple), MINUS))))
            self.combination(gap, {"cofactors": cofactors}, "an equation less a multiple of the turned one")

    def check_proof(self, goal: Any, proof: Any) -> None:
        """The whole proof, and that nothing superfluous is listed."""
        for reference, formula in self.hypotheses.items():
            self.learn(reference, formula)
        self.prove(goal, proof)
        listed = [self.algebra.parse(text) for text in proof.get("nonzero", [])]
        require(all(poly in self.algebra.divisors for poly in listed), "a side condition is no denominator")
        for divisor in self.algebra.divisors:
            by = [name for name, sign, poly in self.state if sign in ("!=", ">") and proportional(divisor, poly)]
            self.used.update(by[:1])
            require(by or divisor in listed, "a denominator may be zero")
        require(self.used >= self.hypotheses.keys(), "a hypothesis is not used")

    def check_point(self, goal: Any, point: Any) -> None:
        """The hypotheses hold at the point, the claim does not, and its sides have the stated values."""
        relation, algebra = goal[0] in RELATIONS, self.algebra
        given = {**point["values"], **{f"side_{k}": v for k, v in enumerate(point["sides"]) if relation}}
        values = {x: algebra.parse(v) if isinstance(v, str) else algebra.ratio(v)[0] for x, v in given.items()}
        angles = {x[4:] for x in values if x[:4] in ("sin_", "cos_")}
        roots = [x for x in values if x.startswith("sqrt_")]
        require(not angles & values.keys() and not roots, "an angle beside its sine, or a value of a root")
        algebra.point = values
        failing = [reference for reference, formula in self.hypotheses.items() if not self.truth(formula)]
        require(not failing and not self.truth(goal), f"{failing or 'the claim'}: not so at the point")
        for k, (side, stated) in enumerate(zip(goal[1:], point["sides"], strict=True)):
            value = self.truth(["=", side, f"side_{k}"] if relation else side)
            require(value == (relation or stated == "true"), "a side has another value at the point")
        circles = [["=", ["+", ["^", f"sin_{x}", 2], ["^", f"cos_{x}", 2]], 1] for x in angles]
        defined = all(map(self.truth, circles)) and all(map(algebra.order, algebra.divisors))
        require(defined, "no point of the unit circle, or a denominator is zero at the point")

    def truth(self, formula: Any) -> bool:  # the formula at the point
        kind, *rest = formula
        if kind in RELATIONS:
            num, den = self.algebra.ratio(["+", rest[0], ["-", rest[1]]])
            return self.algebra.order(num) * self.algebra.order(powers(*den.items())) in RELATIONS[kind]
        parts = [self.truth(part) for part in rest]
        first, last = parts[0], parts[-1]
        return {"and": all(parts), "or": any(parts), "=>": last or not first, "<=>": first == last}[kind]


def check(certificate: dict[str, Any]) -> str | None:
    """None if the certificate proves (or refutes) its claim, else the reason why it does not."""
    try:
        stated = {key: certificate[key] for key in ("id", "claim", "definitions", "hypotheses")}
        digest = hashlib.sha256(json.dumps(stated, sort_keys=True, separators=(",", ":")).encode()).hexdigest()
        require(certificate["digest"] == digest, "the digest belongs to another statement")
        checker = Checker(certificate)
        evidence = {"proved": ("proof", checker.check_proof), "refuted": ("point", checker.check_point)}
        key, verify = evidence[certificate["verdict"]]
        verify(certificate["claim"], certificate[key])
        require(checker.algebra.met >= checker.algebra.definitions.keys(), "a definition is not used")
    except (Reject, LookupError, TypeError, ValueError, AttributeError, ArithmeticError, RecursionError) as error:
        return str(error) if isinstance(error, Reject) else f"malformed ({type(error).__name__}: {error})"
    return None


def unsupported(each: dict[str, Any], proved: list[dict[str, Any]]) -> str | None:
    """For "lemmas imply the claim": None if every lemma is proved under hypotheses that are in force here."""
    force = [formula for formulas in each.get("under", {}).values() for formula in formulas]
    lemmas = [c for c in proved if c["id"] in each.get("lemmas", ()) and "lemmas" not in c]
    lemmas = [c for c in lemmas if all(f in force for formulas in c["hypotheses"].values() for f in formulas)]
    own = dict(each["definitions"])  # a letter defined in a lemma is free here, or defined alike
    lemmas = [c for c in lemmas if all(own.get(name, term) == term for name, term in c["definitions"])]
    found = [part for lemma in lemmas for part in conjuncts(lemma["claim"])]
    right = "lemmas" not in each or all(part in found for part in conjuncts(each["claim"][1]))
    return None if right else "a lemma is not proved, or under other hypotheses or definitions"


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
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
