"""Values of terms modulo a random prime at a random point.

Nobody who writes a certificate can know prime and point: they are drawn once in every run, the prime near 2^253. Right
equations always pass. A false one, of a degree below 2^100, is zero at 2^-152 of the points unless one of 2^92 out of
2^187 primes makes it zero: that one of 2^32 passes is less probable than 2^-60. Sines and cosines lie on the circle,
roots of numbers are roots. Every other function is a random function of its arguments' values, an integral one of its
integrand's value at a random place: whatever holds for random functions holds for these.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from math import prod

from symcheck.checker.residues import CHANCE, Reject, polynomials, require
from symcheck.core.calculus import differentiated
from symcheck.core.terms import (
    Binder,
    Call,
    End,
    Minus,
    Power,
    Product,
    Quotient,
    Sum,
    Term,
    Value,
    children,
    letters,
    node,
)

STEEPEST = 1 << 40  # product of nested exponents, multiples of angles and the like; a term has 2^20 nodes at most
Key = tuple[object, ...]
PI: Key = ("turn", "pi")
POLYNOMIAL = polynomials(CHANCE.letter)


class Inexact(Reject):
    """At a point, a function whose value there is not known exactly."""


class Algebra:
    """Values of terms; notes the divisors it meets. With a point, letters have the values stated there."""

    def __init__(self, shared: Mapping[str, Term], point: Mapping[str, Term] | None = None) -> None:
        self.chance, self.prime, self.point = CHANCE, CHANCE.prime, point
        self.shared = {
            id(term): term for term in shared.values() if isinstance(term, tuple)
        }  # what definitions stand for
        self.known: dict[int, tuple[int, int]] = {}  # their values, and how steep they are
        self.values: dict[str, int] = {}  # of letters
        self.bound: dict[str, tuple[object, ...]] = {}  # the keys of bound letters
        self.settled: dict[int, int] = {}  # values of functions at the point, by what is drawn for them
        self.scale = self.steepest = 1
        self.divisors: dict[int, bool] = {}  # value -> whether it depends on letters or functions
        self.atoms: dict[str, Term] = {}  # terms that stand as letters in polynomials
        self.polynomial = POLYNOMIAL

    def naming(self, atoms: dict[str, Term]) -> dict[str, Term]:
        """Takes other terms as the letters of polynomials; gives those of before."""
        before, self.atoms = self.atoms, atoms
        values = {name: self.value(term) % self.prime for name, term in atoms.items()}
        draw = self.chance.letter
        self.polynomial = polynomials(lambda x: values[x] if x in values else draw(x)) if values else POLYNOMIAL
        return before

    def value(self, term: Term) -> int:
        """The value of a term; sums and products are not reduced modulo the prime."""
        if id(term) in self.shared and not self.bound:
            if id(term) not in self.known:
                before, self.steepest = self.steepest, self.scale
                value = OPERATIONS[type(term)](self, term) % self.prime
                self.known[id(term)] = value, self.steepest // self.scale
                self.steepest = max(before, self.steepest)
            value, factor = self.known[id(term)]
            self.steeper(factor)
            self.scale //= factor
            return value
        return OPERATIONS[type(term)](self, term)

    def letter(self, name: str) -> int:
        """The value of a letter: at a point the one that it has there, else a random one."""
        if name in self.bound:
            return self.chance.draw(*self.bound[name])
        if name not in self.values:
            if self.point is None:
                self.values[name] = self.chance.letter(name)
            else:
                require(name in self.point, "no value for {}", name)
                kept, self.bound = self.bound, {}
                self.values[name] = self.value(self.point[name]) % self.prime
                self.bound = kept
        return self.values[name]

    def sum(self, term: Sum) -> int:
        total, values = 0, self.values if not self.bound else {}
        for part in term[1:]:
            total += values[part] if type(part) is str and part in values else self.value(part)  # type: ignore[arg-type]
        return total

    def product(self, term: Product) -> int:
        total, values = 1, self.values if not self.bound else {}
        for part in term[1:]:
            total *= values[part] if type(part) is str and part in values else self.value(part)  # type: ignore[arg-type]
        return total

    def quotient(self, term: Quotient) -> int:
        return self.value(term.top) * self.inverse(term.bottom) % self.prime

    def power(self, term: Power) -> int:
        return self.raised(term.base, term.exponent)

    def raised(self, base: Term, exponent: int) -> int:
        """The power of a term; of what is divided by, note is taken."""
        with_size = max(abs(exponent), 1)
        self.steeper(with_size)
        value = self.value(base) if exponent >= 0 else self.inverse(base)
        self.scale //= with_size
        return pow(value, abs(exponent), self.prime)

    def steeper(self, factor: int) -> None:
        self.scale *= factor
        self.steepest = max(self.steepest, self.scale)
        require(self.scale < STEEPEST, "the exponent {}", factor)

    def inverse(self, term: Term) -> int:
        """1 / term, factor by factor (what has a name, as a whole); notes the divisors."""
        whole = id(term) in self.shared
        if isinstance(term, Product) and not whole:
            return prod(map(self.inverse, term.terms)) % self.prime
        if isinstance(term, Power) and term.exponent > 0 and not whole:
            self.steeper(term.exponent)
            value = self.inverse(term.base)
            self.scale //= term.exponent
            return pow(value, term.exponent, self.prime)
        value = self.value(term) % self.prime
        self.divisors[value] = self.divisors.get(value, False) or not exact(term)
        if self.point is not None and self.bound:  # nobody asks later
            require(exact(term) or self.chance.rational(value), "{} may be zero under a binder", term)
        return self.chance.inverse(value)

    def function(self, term: Value) -> int:
        """A known function: sines by the addition theorem, roots of numbers, whole powers; else a random function."""
        name = term.tag
        if name == "pi":
            return self.chance.draw("pi")  # transcendental, as a letter is
        inner = term.arguments[0]
        if name in ("sin", "cos"):
            return self.turn(inner)[name == "sin"]
        if name == "tan":
            return self.turn(inner)[1] * self.inverse(node("cos", inner)) % self.prime
        values = [self.value(argument) % self.prime for argument in term.arguments]
        if name == "sqrt" and (
            exact(inner, roots=False) or (self.point is not None and not letters(inner) & self.bound.keys())
        ):
            number = self.chance.rational(values[0])
            self.exactly(number is not None, name)
            return self.chance.root(number)
        if name == "pow" and (whole := self.chance.rational(values[1])) and whole[1] == 1:
            if whole[0] >= 0 or not self.bound:  # under an integral the base is positive by the meaning of such a power
                return self.raised(inner, whole[0])
            return self.chance.inverse(pow(values[0], -whole[0], self.prime))
        return self.settle(name, *values)

    def call(self, term: Call) -> int:
        """An unknown function: a random one."""
        return self.settle("call", term.function, term.orders, *(self.value(t) % self.prime for t in term.arguments))

    def settle(self, *key: object) -> int:
        """The value drawn for a function, or at a point the one that it is known to have there."""
        value = self.chance.draw(*key)
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
        ends = [e.tag if isinstance(e, End) else self.value(e) % self.prime for e in term.ends]
        kept, self.bound = self.bound, {**self.bound, term.letter: ("bound", height(term))}
        value = self.value(term.body) % self.prime
        self.bound = kept
        return self.settle(term.tag, value, *ends)

    def turn(self, term: Term) -> tuple[int, int]:
        """(cos, sin) by the addition theorem, for whole multiples of letters and quarters of a turn.

        Twice the arctangent of a rational number has both rational; any other number is an angle of its own.
        """
        total: dict[Key, tuple[int, int]] = {}
        for key, n, d in self.angles(term, 1, 1):
            old = total.get(key, (0, 1))
            total[key] = (old[0] * d + n * old[1], old[1] * d)
        cosine, sine = 1, 0
        for key, (n, d) in total.items():
            (c, s), times = self.multiple(key, n, d)
            require(abs(times) < 1000, "the multiple {} of an angle", times)
            self.steeper(max(abs(times), 1))
            s = s if times > 0 else -s  # the other way round
            for _ in range(abs(times)):
                cosine, sine = (cosine * c - sine * s) % self.prime, (sine * c + cosine * s) % self.prime
            self.scale //= max(abs(times), 1)
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
            below = self.chance.inverse(1 + t * t)
            return ((1 - t * t) * below % self.prime, 2 * t * below % self.prime), n // (2 * d)
        self.exactly(False, "a sine or cosine")
        if n % d == 0 and key != PI:
            return self.chance.circle(*key), n // d
        value = n * self.chance.draw(*key[1:]) * self.chance.inverse(d) % self.prime
        half = min(value, self.prime - value)  # the angle and its contrary go together
        return self.chance.circle("angle", half), 1 if half == value else -1

    def angles(self, term: Term, n: int, d: int) -> Iterator[tuple[Key, int, int]]:
        """An angle taken apart into multiples n / d of letters, of pi, of arctangents and of other terms."""
        match term:
            case str() if self.point is not None and term not in self.bound:
                require(term in self.point, "no value for {}", term)
                yield from self.angles(self.point[term], n, d)
            case str():
                yield ("turn", *self.bound.get(term, ("letter", term))), n, d
            case Sum(terms=parts):
                for part in parts:
                    yield from self.angles(part, n, d)
            case Minus(inner=inner):
                yield from self.angles(inner, -n, d)
            case Product(terms=factors) if len(rest := [t for t in factors if ratio(t) is None]) == 1:
                for top, bottom in filter(None, map(ratio, factors)):
                    n, d = n * top, d * bottom
                yield from self.angles(rest[0], n, d)
            case Quotient(top=top, bottom=int(bottom)) if bottom:
                yield from self.angles(top, n, d * bottom)
            case Value(tag="pi"):
                yield PI, n, d
            case Value(tag="arctan", arguments=(t,)) if exact(t):
                yield ("arctan", self.value(t) % self.prime), n, d
            case _ if value := self.value(term) % self.prime:
                yield ("turn", "number", value), n, d


def ratio(term: Term) -> tuple[int, int] | None:
    """(n, d) of a number written as such: n, n/d or its negative."""
    match term:
        case int():
            return term, 1
        case Quotient(top=int(n), bottom=int(d)) if d:
            return n, d
        case Minus(inner=inner) if known := ratio(inner):
            return -known[0], known[1]
    return None


def exact(term: Term, roots: bool = True) -> bool:
    """Whether a term is made of whole numbers, and of their roots: its residue tells whether it is zero."""
    match term:
        case Sum() | Product() | Minus() | Quotient():
            return all(exact(part, roots) for part in term[1:])  # type: ignore[arg-type]
        case Power(base=base):
            return exact(base, roots)
        case Value(tag="sqrt", arguments=(inner,)):
            return roots and exact(inner, roots=False)
    return isinstance(term, int)


def height(term: Term) -> int:
    """How many binders stand one in another."""
    if not isinstance(term, tuple):
        return 0
    return max((height(child) for child, _ in children(term)), default=0) + (
        isinstance(term, Binder) and term.tag != "diff"
    )


OPERATIONS: dict[type, Callable[..., int]] = {
    str: Algebra.letter, int: lambda algebra, term: term,
    Sum: Algebra.sum, Product: Algebra.product, Minus: lambda algebra, term: -algebra.value(term[1]),
    Quotient: Algebra.quotient, Power: Algebra.power, Value: Algebra.function, Call: Algebra.call,
    Binder: Algebra.binder,
}  # fmt: skip
