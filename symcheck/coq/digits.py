"""A number between two decimals: each step of interval arithmetic is a lemma of `Digits.v`."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from math import floor
from typing import NamedTuple

from mpmath import mp, mpf

from symcheck.coq.assumptions import State
from symcheck.coq.printing import ATOM, spelled
from symcheck.coq.terms import NotExported
from symcheck.coq.values import number, printed_ratio, value
from symcheck.core.terms import Term, Value, node

PLACES = 12  # behind the point, counted from the first digit of a number below 1
PI = Fraction(31415926535, 10**10), Fraction(31415926536, 10**10)
ACUTE = Fraction(157, 100)  # the lemmas about sines and cosines go up to there


class Within(NamedTuple):
    """A proof term of `within t low high`."""

    proof: str
    low: Fraction
    high: Fraction


def taylor(first: int, terms: int, x: Fraction) -> Fraction:
    """Nested 1 - x^2 / (first (first + 1)) (1 - ...), as in `Digits.v`."""
    steps = [first + 2 * k for k in range(terms)]
    return reduce(lambda inner, n: 1 - x * x / (n * (n + 1)) * inner, reversed(steps), Fraction(1))


def sine(x: Fraction, above: bool = False) -> Fraction:
    """Its Taylor polynomial, above or below."""
    return x * taylor(2, 7 + above, x)


def cosine(x: Fraction, above: bool = False) -> Fraction:
    """Its Taylor polynomial, above or below."""
    return taylor(1, 7 + above, x)


def down(x: Fraction) -> Fraction:
    """Rounded down."""
    places = 10 ** (PLACES + (len(str(x.denominator // abs(x.numerator))) if 0 < abs(x) < 1 else 0))
    return Fraction(floor(x * places), places)


def up(x: Fraction) -> Fraction:
    """Rounded up."""
    return -down(-x)


class Enclosure:
    """Encloses terms one after the other; `known` are proofs of letter = number."""

    def __init__(self, state: State, known: Mapping[str, tuple[str, Term]]) -> None:
        self.state, self.known = state, known

    def of(self, term: Term) -> Within:
        """The enclosure of a term, unfolded and without tangents."""
        match term:
            case int() | Value(tag="/", terms=(int(), int())) | Value(tag="-", terms=(int(),)):
                exactly = number(value(term))
                assert exactly is not None
                return Within(f"(number_in {spelled(term, ATOM)})", exactly, exactly)
            case Value(tag="pi"):
                return Within("pi_in", *PI)
            case str() if term in self.known:
                proof, meant = self.known[term]
                inner = self.of(meant)
                return Within(f"(equal_in {proof} {inner.proof})", inner.low, inner.high)
            case Value(tag="-", terms=(part,)):
                found = self.of(part)
                return Within(f"(minus_in {found.proof})", -found.high, -found.low)
            case Value(tag="+" | "*" as sign, terms=(first, *rest)):
                return self.chain(sign, first, rest)
            case Value(tag="/", terms=(top, bottom)):
                return self.product("quotient_in", spelled(term), self.of(top), self.inverse(bottom))
            case Value(tag="^", terms=(base, int(n))) if 0 < n < 9:
                product = base if n == 1 else node("*", *[base] * n)
                found = self.of(product)
                by = f"equal_in (s := {spelled(term)}) (t := {spelled(product)}) ltac:(ring) {found.proof}"
                return Within(f"({by})", found.low, found.high)
            case Value(tag=function, terms=(part,)) if function in FUNCTIONS:
                return FUNCTIONS[function](self, term, self.of(part))
        raise NotExported(f"the digits of {spelled(term)}")

    def step(self, lemma: str, text: str, low: Fraction, high: Fraction, *inner: Within) -> Within:
        """One lemma; what it asks of fractions is left to the tactic."""
        own = self.state.anew("w")
        proofs = " ".join(one.proof for one in inner)
        ends = f"{printed_ratio(low)} {printed_ratio(high)}"
        self.state.emit(f"assert ({own} : within ({text}) {ends}) by (apply ({lemma} {ends} {proofs}); fractions).")
        return Within(own, low, high)

    def chain(self, sign: str, first: Term, rest: list[Term]) -> Within:
        """A sum or product, part by part."""
        found, so_far = self.of(first), [first]
        for part in rest:
            other, so_far = self.of(part), [*so_far, part]
            text = spelled(node(sign, *so_far))
            if sign == "+":
                found = self.step(
                    "sum_in", text, down(found.low + other.low), up(found.high + other.high), found, other
                )
            else:
                found = self.product("product_in", text, found, other)
        return found

    def product(self, lemma: str, text: str, one: Within, other: Within) -> Within:
        corners = [a * b for a in one[1:] for b in other[1:]]
        return self.step(lemma, text, down(min(corners)), up(max(corners)), one, other)

    def inverse(self, term: Term) -> Within:
        found = self.of(term)
        if found.low <= 0:
            raise NotExported("the digits of a quotient with a denominator that is not positive")
        text = f"/ {spelled(term, ATOM)}"
        return self.step("inverse_in", text, down(1 / found.high), up(1 / found.low), found)

    def root(self, term: Value, inner: Within) -> Within:
        low, high = (approximate(mp.sqrt, max(x, Fraction(0))) for x in inner[1:])
        margin = Fraction(1, 10**11)
        return self.step("root_in", spelled(term), max(down(low - margin), Fraction(0)), up(high + margin), inner)

    def circular(self, term: Value, inner: Within) -> Within:
        if inner.low < 0 or inner.high > ACUTE:
            raise NotExported("the digits of a function of an angle that is not between 0 and 89.9 degrees")
        if term.tag == "sin":
            return self.step("sine_in", spelled(term), down(sine(inner.low)), up(sine(inner.high, True)), inner)
        return self.step("cosine_in", spelled(term), down(cosine(inner.high)), up(cosine(inner.low, True)), inner)

    def angle(self, term: Value, inner: Within) -> Within:
        lemma, function = ANGLES[term.tag]
        if inner.low < 0 or (term.tag != "arctan" and inner.high > 1):
            raise NotExported("the digits of an angle that is not acute")
        ends = sorted(approximate(function, x) for x in inner[1:])
        margin = Fraction(1, 10**10)
        low, high = max(down(ends[0] - margin), Fraction(0)), up(ends[1] + margin)
        if high > ACUTE:
            raise NotExported("the digits of an angle near 90 degrees")
        return self.step(lemma, spelled(term), low, high, inner)


ANGLES = {
    "arctan": ("arctangent_in", mp.atan),
    "arcsin": ("arcsine_in", mp.asin),
    "arccos": ("arccosine_in", mp.acos),
}
FUNCTIONS: dict[str, Callable[[Enclosure, Value, Within], Within]] = {
    "sqrt": Enclosure.root,
    **dict.fromkeys(("sin", "cos"), Enclosure.circular),
    **dict.fromkeys(ANGLES, Enclosure.angle),
}


def approximate(function: Callable[[mpf], mpf], x: Fraction) -> Fraction:
    """The value of a function with 15 places."""
    with mp.workdps(30):
        return Fraction(int(mp.floor(function(mpf(x.numerator) / x.denominator) * 10**15)), 10**15)
