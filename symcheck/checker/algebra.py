"""Values of terms modulo a random prime at a random point.

Nobody who writes a certificate can know prime and point: they are drawn once in every run, the prime near 2^253. Right
equations always pass. A false one, of a degree below 2^100, is zero at 2^-152 of the points unless one of 2^92 out of
2^187 primes makes it zero: that one of 2^32 passes is less probable than 2^-60. Sines and cosines lie on the circle,
roots of numbers are roots. Every other function is a random function of its arguments' values, an integral one of its
integrand's value at a random place: whatever holds for random functions holds for these.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from math import prod

from symcheck.checker.residues import PRIME, Reject, circle, draw, inverse, rational, require, root, rotation
from symcheck.core.calculus import differentiated, letters
from symcheck.core.terms import Binder, Call, End, Node, Term, Value, node

STEEPEST = 1 << 40  # product of nested exponents, multiples of angles and the like; a term has 2^20 nodes at most
Key = tuple[object, ...]
PI: Key = ("pi",)
LETTERS: dict[str, int] = {}  # what was drawn for free letters


class Inexact(Reject):
    """At a point, a function whose value there is not known exactly."""


class Algebra:
    """Values of terms; notes the divisors it meets. With a point, letters have the values stated there."""

    def __init__(self, shared: Mapping[str, Term], point: Mapping[str, Term] | None = None) -> None:
        self.point = point
        self.shared = {id(t): t for t in shared.values() if isinstance(t, Node)}  # what definitions stand for
        self.known: dict[tuple[int, int], int] = {}  # their values, by how steep they are where they stand
        self.letters = LETTERS if point is None else {}  # their values
        self.bound: dict[str, Key] = {}  # what is drawn for bound letters
        self.settled: dict[int, int] = {}  # values of functions at the point, by what is drawn for them
        self.scale = 1  # product of the exponents around
        self.divisors: dict[int, Term | None] = {}  # by their values; None for those that stand under a binder

    def value(self, term: Term) -> int:
        """The value of a term; sums and products are not reduced modulo the prime."""
        if isinstance(term, int):
            return term
        if isinstance(term, str):
            return self.letters[term] if term in self.letters else self.letter(term)
        named = id(term) in self.shared and not self.bound
        if named and (id(term), self.scale) in self.known:
            return self.known[id(term), self.scale]
        match term[0]:
            case "+" | "*" as sign:
                result, known = int(sign == "*"), self.letters
                for t in term.outside:
                    value = known[t] if type(t) is str and t in known else self.value(t)  # most are letters
                    result = result * value if sign == "*" else result + value
            case "-":
                result = -self.value(term[1])
            case "sin" | "cos" as name:
                result = self.turn(term[1])[name == "sin"]
            case _:
                result = self.operation(term)
        if named:
            self.known[id(term), self.scale] = result
        return result

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

    def operation(self, term: Node) -> int:
        """The value of a power or quotient, of a function, or of a binder."""
        match term:
            case Value(tag="^", terms=(base, int(exponent))):
                return self.raised(base, exponent)
            case Value(tag="/", terms=(top, bottom)):
                return self.value(top) * self.inverse(bottom) % PRIME
            case Value():
                return self.function(term)
            case Call():
                return self.settle("call", term.function, term.orders, *self.residues(term.terms))
            case Binder():
                return self.binder(term)
        raise AssertionError(term)

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
        """1 / term, factor by factor (what has a name, as a whole); notes the divisors."""
        match term:
            case Value() if id(term) in self.shared:
                pass
            case Value(tag="*", terms=factors):
                return prod(map(self.inverse, factors)) % PRIME
            case Value(tag="^", terms=(base, int(exponent))) if exponent > 0:
                return self.raised(base, -exponent)
        value = self.value(term) % PRIME
        self.divisors[value] = self.divisors.get(value) or (term if exact(term) or not self.bound else None)
        if self.point is not None and self.bound:  # nobody asks later
            require(exact(term) or rational(value), "{} may be zero under a binder", term)
        return inverse(value)

    def function(self, term: Value) -> int:
        """A known function: sines by the addition theorem, roots of numbers, whole powers; else a random function."""
        name = term.tag
        if name == "pi":
            return draw("pi")  # transcendental, as a letter is
        inner = term.terms[0]
        if name == "tan" and isinstance(inner, Value) and inner.tag == "arctan":
            return self.value(inner.terms[0])
        if name == "tan":
            return self.turn(inner)[1] * self.inverse(node("cos", inner)) % PRIME
        values = self.residues(term.terms)
        if name == "sqrt" and (
            exact(inner, roots=False) or (self.point is not None and not letters(inner) & self.bound.keys())
        ):
            fraction = rational(values[0])
            self.exactly(fraction is not None, name)
            return root(fraction)
        if name == "pow" and (whole := rational(values[1])) and whole[1] == 1:
            if whole[0] >= 0 or not self.bound:  # under an integral the base is positive by the meaning of such a power
                return self.raised(inner, whole[0])
            return inverse(pow(values[0], -whole[0], PRIME))
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
            return self.value(differentiated(term))
        ends = [e.tag if isinstance(e, End) else self.value(e) % PRIME for e in term.outside]
        kept = self.bound, self.letters
        self.bound = {**self.bound, term.letter: ("bound", height(term))}
        self.letters = {**self.letters, term.letter: draw(*self.bound[term.letter])}
        value = self.value(term.body) % PRIME
        self.bound, self.letters = kept
        return self.settle(term.tag, value, *ends)

    def turn(self, term: Term) -> tuple[int, int]:
        """(cos, sin) by the addition theorem, for whole multiples of letters and quarters of a turn.

        Twice the arctangent of a rational number has both rational; any other number is an angle of its own.
        """
        if isinstance(term, str) and self.point is None and term not in self.bound:
            return circle("letter", term)  # as below, and in a fraction of the time
        total: dict[Key, tuple[int, int]] = {}
        for key, n, d in self.angles(term, 1, 1):
            a, b = total.get(key, (0, 1))
            total[key] = a * d + n * b, b * d
        cosine, sine = 1, 0
        for key, (n, d) in total.items():
            (c, s), times = self.multiple(key, n, d)
            require(abs(times) < 1000, "the multiple {} of an angle", times)
            self.steeper(times)
            for _ in range(abs(times)):
                s_ = s if times > 0 else -s
                cosine, sine = (cosine * c - sine * s_) % PRIME, (sine * c + cosine * s_) % PRIME
        return cosine, sine

    def multiple(self, key: Key, n: int, d: int) -> tuple[tuple[int, int], int]:
        """An angle n / d times as whole multiples: ((cos, sin), how many)."""
        if n == 0:
            return (1, 0), 0
        if key == PI and 2 * n % d == 0:
            return (0, 1), 2 * n // d % 4
        if key[0] == "arctan" and n % (2 * d) == 0:
            t = key[1]
            assert isinstance(t, int)
            return rotation(t), n // (2 * d)
        self.exactly(False, "a sine or cosine")
        if n % d == 0 and key != PI:
            return circle(*key), n // d
        value = n * draw(*key) * inverse(d) % PRIME
        half = min(value, PRIME - value)  # the angle and its contrary go together
        return circle("angle", half), 1 if half == value else -1

    def angles(self, term: Term, n: int, d: int) -> Iterator[tuple[Key, int, int]]:
        """An angle taken apart into multiples n / d of letters, of pi, of arctangents and of other terms."""
        match term:
            case str() if self.point is not None and term not in self.bound:
                require(term in self.point, "no value for {}", term)
                yield from self.angles(self.point[term], n, d)
            case str():
                yield self.bound.get(term, ("letter", term)), n, d
            case Value(tag="+", terms=parts):
                for part in parts:
                    yield from self.angles(part, n, d)
            case Value(tag="-", terms=(inner,)):
                yield from self.angles(inner, -n, d)
            case Value(tag="*", terms=factors) if len(rest := [t for t in factors if ratio(t) is None]) == 1:
                for top, bottom in filter(None, map(ratio, factors)):
                    n, d = n * top, d * bottom
                yield from self.angles(rest[0], n, d)
            case Value(tag="/", terms=(top, int(bottom))) if bottom:
                yield from self.angles(top, n, d * bottom)
            case Value(tag="pi"):
                yield PI, n, d
            case Value(tag="arctan", terms=(t,)) if exact(t):
                yield ("arctan", self.value(t) % PRIME), n, d
            case _ if value := self.value(term) % PRIME:
                yield ("number", value), n, d


def ratio(term: Term) -> tuple[int, int] | None:
    """(n, d) of a number written as such: n, n/d or its negative."""
    match term:
        case int():
            return term, 1
        case Value(tag="/", terms=(int(n), int(d))) if d:
            return n, d
        case Value(tag="-", terms=(inner,)) if known := ratio(inner):
            return -known[0], known[1]
    return None


def exact(term: Term, roots: bool = True) -> bool:
    """Whether a term is made of whole numbers, and of their roots: its residue tells whether it is zero."""
    match term:
        case Value(tag="+" | "*" | "-" | "/" | "^", terms=parts):
            return all(exact(part, roots) for part in parts)
        case Value(tag="sqrt", terms=(inner,)):
            return roots and exact(inner, roots=False)
    return isinstance(term, int)


def height(term: Term) -> int:
    """How many binders stand one in another."""
    parts = (*term.inside, *term.outside) if isinstance(term, Node) else ()
    return max(map(height, parts), default=0) + (isinstance(term, Binder) and term.tag != "diff")
