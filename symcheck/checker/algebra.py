"""Values of terms modulo a random prime at a random point.

Nobody who writes a certificate can know prime and point: they are drawn once in every run, the prime near 2^253. Right
equations always pass. A false one, of a degree below 2^100, is zero at 2^-152 of the points unless one of 2^92 out of
2^187 primes makes it zero: that one of 2^32 passes is less probable than 2^-60. Sines and cosines lie on the circle,
roots of numbers are roots. Every other function is a random function of its arguments' values, an integral one of its
integrand's value at a random place: whatever holds for random functions holds for these.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from math import prod

from symcheck.checker.enclosures import enclosed
from symcheck.checker.residues import PRIME, Reject, circle, draw, has_root, inverse, rational, require, root, rotation
from symcheck.core.calculus import Unknown, differentiated, domain, letters, substituted
from symcheck.core.terms import Binder, Call, Connective, End, Formula, Node, Relation, Term, Value, node

STEEPEST = 1 << 40  # product of nested exponents, multiples of angles and the like; a term has 2^20 nodes at most
SIGNS = {"=": {0}, "!=": {-1, 1}, "<": {-1}, "<=": {-1, 0}, ">": {1}, ">=": {0, 1}}  # of left - right
Key = tuple[object, ...]
Divisors = dict[int, "Term | None"]  # by their values and binders above; None for those that stand under a binder
Known = dict[int, dict[int, tuple[int, Divisors]]]  # of shared nodes, by identity: values, by the exponents around
PI: Key = ("pi",)
LETTERS: dict[str, int] = {}  # what was drawn for free letters


class Inexact(Reject):
    """At a point, a function whose value there is not known exactly."""


class Algebra:
    """Values of terms; notes the divisors it meets. With a point, letters have the values stated there."""

    def __init__(self, known: Known, point: Mapping[str, Term] | None = None) -> None:
        self.known, self.point = known, point
        self.letters = LETTERS if point is None else {}  # their values
        self.bound: dict[str, Key] = {}  # what is drawn for bound letters
        self.binders: Key = ()  # the binders above, each with its ends
        self.settled: dict[int, int] = {}  # values of functions at the point, by what is drawn for them
        self.scale = 1  # product of the exponents around
        self.divisors: Divisors = {}  # that were met
        self.outermost: Term | None = None  # at a point, the binder inside of which values are taken
        self.asked = point is None  # whether somebody asks later about divisors under binders

    def value(self, term: Term) -> int:
        """The value of a term; sums and products are not reduced modulo the prime."""
        if isinstance(term, str):
            return self.letters[term] if term in self.letters else self.letter(term)
        if isinstance(term, int):
            return term
        if self.bound or id(term) not in self.known:
            return self.computed(term)
        values = self.known[id(term)]  # of a shared node: its divisors are met wherever it stands
        if self.scale not in values:
            around, self.divisors = self.divisors, {}
            values[self.scale] = self.computed(term), self.divisors
            self.divisors = around
        value, divisors = values[self.scale]
        self.divisors.update(divisors)
        return value

    def computed(self, term: Node) -> int:
        """The value of a node from those of its parts."""
        match term[0]:
            case "+":
                return sum(map(self.value, term.outside))
            case "*":
                return prod(map(self.value, term.outside))
            case "-":
                return -self.value(term.outside[0])
            case "^":
                base, exponent = term.outside
                return self.raised(base, exponent)  # type: ignore[arg-type]
            case "/":
                top, bottom = term.outside
                return self.value(top) * self.inverse(bottom) % PRIME
            case "sin" | "cos" as name:
                return self.turn(term.outside[0])[name == "sin"]
        match term:
            case Relation():
                return self.order(term) in SIGNS[term.tag]
            case Call():
                return self.settle("call", term.function, term.orders, *self.residues(term.terms))
            case Binder():
                return self.binder(term)
            case Value():
                return self.function(term)
        raise AssertionError(term)

    def residues(self, terms: Iterable[Term]) -> list[int]:
        return [self.value(t) % PRIME for t in terms]

    def letter(self, name: str) -> int:
        """The value of a letter that is not bound: at a point the one that it has there, else a random one."""
        if self.point is None:
            self.letters[name] = draw("letter", name)
        else:
            require(name in self.point, "no value for {}", name)
            kept, self.bound = self.bound, {}
            self.letters[name] = self.value(self.point[name]) % PRIME
            self.bound = kept
        return self.letters[name]

    def raised(self, base: Term, exponent: int) -> int:
        """The power of a term; of what is divided by, note is taken."""
        around = self.scale
        self.scale = self.steeper(exponent)
        value = self.value(base) if exponent >= 0 else self.inverse(base)
        self.scale = around
        return pow(value, abs(exponent), PRIME)

    def steeper(self, factor: int) -> int:
        """The product of the exponents around, and of one more."""
        scale = self.scale * max(abs(factor), 1)
        require(scale < STEEPEST, "the exponent {}", abs(factor))
        return scale

    def inverse(self, term: Term) -> int:
        """1 / term, factor by factor (what is shared, as a whole); notes the divisors."""
        if isinstance(term, Value) and id(term) not in self.known:
            if term.tag == "*":
                return prod(map(self.inverse, term.terms)) % PRIME
            if term.tag == "^" and (exponent := term.terms[1]) > 0:  # type: ignore[operator]
                return self.raised(term.terms[0], -exponent)  # type: ignore[operator]
        value = self.value(term) % PRIME
        if self.bound and sign(term) == 2:
            return inverse(value)
        if self.point is not None and self.bound:
            shown = exact(term) or rational(value) or (self.outermost is not None and has_digits(self.outermost))
            require(shown or self.asked, "{} may be zero under a binder", term)
            if shown:
                return inverse(value)
        if self.bound and letters(term) & self.bound.keys():  # between other ends the same divisor may be zero
            self.divisors[draw("divisor", value, *self.binders)] = None
        else:
            self.divisors[value] = self.divisors.get(value) or (term if exact(term) or not self.bound else None)
        return inverse(value)

    def function(self, term: Value) -> int:
        """A known function: sines by the addition theorem, roots of numbers, whole powers; else a random function."""
        name = term.tag
        if name == "pi":
            return draw("pi")  # transcendental, as a letter is
        inner = term.terms[0]
        if name == "tan" and isinstance(inner, Value) and inner.tag == "arctan":
            return self.value(inner.terms[0])
        if name == "exp":
            return self.exponential(inner)
        if name == "tan":
            return self.turn(inner)[1] * self.inverse(node("cos", inner)) % PRIME
        values = self.residues(term.terms)
        if name == "sqrt" and (
            exact(inner, roots=False) or (self.point is not None and not letters(inner) & self.bound.keys())
        ):
            fraction = rational(values[0])
            self.exactly(fraction is not None and has_root(fraction), name)
            return root(fraction)
        if name == "pow" and (whole := rational(values[1])) and whole[1] == 1:
            return self.raised(inner, whole[0])
        return self.settle(name, *values)

    def settle(self, *key: object) -> int:
        """The value drawn for a function, or at a point the one that it is known to have there."""
        value = draw(*key)
        self.exactly(value in self.settled, key[0])
        return self.settled.get(value, value)

    def exactly(self, known: bool, what: object) -> None:
        """At a point nothing is drawn, except under an integral."""
        if not (known or self.point is None or self.bound):
            raise Inexact(f"no value for {what} at the point")

    def binder(self, term: Binder) -> int:
        """An integral, mean, sum or product: a function of its ends and of its body's value at a random place.

        The place belongs to the height, the number of binders below it: so it differs from that of every binder above.
        """
        if term.tag == "diff":
            for x in letters(term) - self.bound.keys() if self.point is not None else ():
                self.value(x)  # also of what the derivative is free of
            for each in domain(term) if self.point is not None and not self.bound else ():
                require(self.holds(each), "no derivative where {} is not so", each)
            return self.value(differentiated(term))
        ends = [e.tag if isinstance(e, End) else self.value(e) % PRIME for e in term.outside]
        kept = self.bound, self.letters, self.binders
        if self.point is not None and not self.bound:
            self.outermost = substituted(term, self.point)
        self.bound = {**self.bound, term.letter: ("bound", height(term))}
        self.letters = {**self.letters, term.letter: draw(*self.bound[term.letter])}
        self.binders = (*self.binders, (term.tag, *ends))
        value = self.value(term.body) % PRIME
        self.bound, self.letters, self.binders = kept
        return self.settle(term.tag, value, *ends)

    def turn(self, term: Term) -> tuple[int, int]:
        """(cos, sin) by the addition theorem, for whole multiples of letters and quarters of a turn.

        Twice the arctangent of a rational number has both rational; any other number is an angle of its own.
        """
        if isinstance(term, str) and self.point is None and term not in self.bound:
            return circle("letter", term)  # as below, and in a fraction of the time
        total: dict[Key, int] = {}
        for key, times in self.angles(term, 1):
            total[key] = total.get(key, 0) + times
        cosine, sine = 1, 0
        for key, times in total.items():
            (c, s), n = self.multiple(key, times % PRIME)
            require(abs(n) < 1000, "the multiple {} of an angle", n)
            self.steeper(n)
            for _ in range(abs(n)):
                s_ = s if n > 0 else -s
                cosine, sine = (cosine * c - sine * s_) % PRIME, (sine * c + cosine * s_) % PRIME
        return cosine, sine

    def exponential(self, term: Term) -> int:
        """e to a sum is the product of its powers: whole powers of e to letters, to pi and to other terms."""
        total: dict[Key, int] = {}
        for key, times in self.angles(term, 1):
            total[key] = total.get(key, 0) + times
        product = 1
        for key, times in total.items():
            n, d = rational(times % PRIME) or (1, 0)
            if n == 0:
                continue
            self.exactly(False, "e to a number")
            if d == 1 and abs(n) < 1000:
                self.steeper(n)
                product = product * pow(draw("exp", *key), n, PRIME) % PRIME
            else:
                value = times * draw(*key) % PRIME
                half = min(value, PRIME - value)  # e to a number and to its contrary are inverse
                product = product * pow(draw("exp", half), 1 if half == value else -1, PRIME) % PRIME
        return product

    def multiple(self, key: Key, times: int) -> tuple[tuple[int, int], int]:
        """So many times an angle as whole multiples: ((cos, sin), how many)."""
        n, d = rational(times) or (times, 0)
        if n == 0:
            return (1, 0), 0
        if key == PI and d in (1, 2):
            return (0, 1), 2 * n // d % 4
        if key[0] == "arctan" and d == 1 and n % 2 == 0:
            t = key[1]
            assert isinstance(t, int)
            return rotation(t), n // 2
        self.exactly(False, "a sine or cosine")
        if d == 1 and key != PI:
            return circle(*key), n
        value = times * draw(*key) % PRIME
        half = min(value, PRIME - value)  # the angle and its contrary go together
        return circle("angle", half), 1 if half == value else -1

    def angles(self, term: Term, times: int) -> Iterator[tuple[Key, int]]:
        """So many times an angle taken apart into multiples of letters, of pi, of arctangents and of other terms."""
        match term:
            case str() if self.point is not None and term not in self.bound:
                require(term in self.point, "no value for {}", term)
                yield from self.angles(self.point[term], times)
            case str():
                yield self.bound.get(term, ("letter", term)), times
            case Value(tag="+", terms=parts):
                for part in parts:
                    yield from self.angles(part, times)
            case Value(tag="-", terms=(inner,)):
                yield from self.angles(inner, -times)
            case Value(tag="*", terms=factors) if rest := [t for t in factors if not exact(t, roots=False)]:
                numbers = [self.value(t) for t in factors if exact(t, roots=False)]
                if len(rest) == 1:
                    yield from self.angles(rest[0], times * prod(numbers) % PRIME)
                else:
                    yield from self.other(prod(map(self.value, rest)) % PRIME, times * prod(numbers) % PRIME)
            case Value(tag="/", terms=(top, bottom)) if exact(bottom, roots=False):
                yield from self.angles(top, times * self.inverse(bottom) % PRIME)
            case Value(tag="pi"):
                yield PI, times
            case Value(tag="arctan", terms=(t,)) if exact(t):
                yield ("arctan", self.value(t) % PRIME), times
            case _:
                yield from self.other(self.value(term) % PRIME, times)

    @staticmethod
    def other(value: int, times: int) -> Iterator[tuple[Key, int]]:
        """So many times a number that is no letter; it and its contrary go together."""
        if value:
            half = min(value, PRIME - value)
            yield ("number", half), times if half == value else -times

    def holds(self, formula: Formula) -> bool:
        """Whether a formula holds where all its letters have values."""
        if isinstance(formula, Relation):
            return bool(self.value(formula))
        if not isinstance(formula, Connective):
            raise Reject(f"{formula} is not about numbers")
        parts = [self.holds(part) for part in formula.formulas]
        if formula.tag in ("and", "or"):
            return all(parts) if formula.tag == "and" else any(parts)
        return parts[0] == parts[1] if formula.tag == "<=>" else parts[1] or not parts[0]

    def order(self, relation: Relation) -> int:
        """The sign of left - right: from the exact difference, or else by interval arithmetic, or 0 by algebra."""
        left, right = relation.terms
        kept = self.scale, self.bound, self.letters, self.binders, self.divisors
        try:
            gap = (self.value(left) - self.value(right)) % PRIME
            number = (gap, 1) if relation.tag in ("=", "!=") else rational(gap)
            if number:
                return (number[0] > 0) - (number[0] < 0)
        except Inexact:
            self.scale, self.bound, self.letters, self.binders, self.divisors = kept
        difference = substituted(node("+", left, node("-", right)), self.point or {})
        digits = enclosed(difference)
        if digits.low <= 0 <= digits.high and digits.low < digits.high:
            require(Algebra({}).value(difference) % PRIME == 0, "too few digits to compare {} and {}", left, right)
            return 0
        return (digits.low > 0) - (digits.high < 0)


def has_digits(term: Term) -> bool:
    """Whether a closed term has an enclosure, so that nothing in it is divided by zero, wherever bound letters are."""
    try:
        enclosed(term)
    except Unknown:
        return False
    return True


def sign(term: Term, told: Callable[[Term, int], int] | None = None) -> int:
    """2 if manifestly positive for all real letters, 1 if manifestly not negative, else 0: by its form.

    `told` may know better of a part, of which the form tells so much.
    """
    level = 0
    match term:
        case int():
            return (term >= 0) + (term > 0)
        case Value(tag="pi" | "exp"):
            return 2
        case Value(tag="+", terms=parts) if parts:
            level = max(levels := [sign(t, told) for t in parts]) * all(levels)
        case Value(tag="*", terms=parts):  # equal factors pair up to squares
            single: list[Term] = []
            for t in parts:
                (single.remove if t in single else single.append)(t)
            level = min([1 if len(single) < len(parts) else 2, *(sign(t, told) for t in single)])
        case Value(tag="/", terms=(top, bottom)):
            level = min(sign(top, told), 2 * bool(sign(bottom, told)))
        case Value(tag="^", terms=(base, int(n))) if n > 0:
            level = sign(base, told) or int(n % 2 == 0)
    return level if level == 2 or told is None else told(term, level)


def exact(term: Term, roots: bool = True) -> bool:
    """Whether a term is made of whole numbers, and of their roots: its residue tells whether it is zero."""
    if not isinstance(term, Node):
        return isinstance(term, int)
    if term.tag == "sqrt":
        return roots and exact(term.outside[0], roots=False)
    return term.tag in ("+", "*", "-", "/", "^") and all(exact(part, roots) for part in term.outside)


def height(term: Term) -> int:
    """How many binders stand one in another."""
    parts = (*term.inside, *term.outside) if isinstance(term, Node) else ()
    return max(map(height, parts), default=0) + (isinstance(term, Binder) and term.tag != "diff")
