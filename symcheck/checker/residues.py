"""Numbers modulo a random prime: residues of letters, circle points, roots, polynomials."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import lru_cache
from math import factorial, gcd, prod

HEIGHT = 1 << 96
PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43)
SIEVE = factorial(2000)  # most candidates have a small divisor


class Reject(Exception):
    """The certificate does not prove its claim; the message says where it fails."""


def require(condition: object, reason: str, *about: object) -> None:
    """Rejects with the reason, and what it is about, unless the condition holds."""
    if not condition:
        raise Reject(reason.format(*(str(each)[:200] for each in about)) if about else reason)


power = lru_cache(None)(pow)  # the same roots and inverses are needed again and again


class Chance:
    """A random prime, -1 modulo 8 and the small primes so that their roots exist, and random values of all letters."""

    def __init__(self) -> None:
        self.prime = 0
        while not self.prime:
            p = 4 * prod(PRIMES) * (2**198 + int.from_bytes(os.urandom(24), "big")) - 1
            if gcd(p, SIEVE) > 1:
                continue
            bases = (int.from_bytes(os.urandom(16), "big") for _ in range(6))
            self.prime = p if all(pow(base, p >> 1, p) in (1, p - 1) for base in bases) else 0
        self.drawn: dict[object, int] = {}

    def draw(self, *key: object) -> int:
        """The random number that belongs to the key."""
        if key not in self.drawn:
            self.drawn[key] = int.from_bytes(os.urandom(40), "big") % self.prime
        return self.drawn[key]

    def letter(self, name: str) -> int:
        """The value of a free letter."""
        return self.draw("letter", name)

    def circle(self, *key: object) -> tuple[int, int]:
        """The point (cos, sin) of the unit circle that belongs to the key."""
        half = self.draw("half", *key)
        below = self.inverse(1 + half * half)
        return (1 - half * half) * below % self.prime, 2 * half * below % self.prime

    def inverse(self, value: int) -> int:
        """1 / value."""
        require(value % self.prime, "division by zero")
        return power(value, -1, self.prime)

    def rational(self, value: int) -> tuple[int, int] | None:
        """(n, d) with d > 0 if n/d in lowest terms has this value; None if there are none below HEIGHT."""
        a, b, u, v = self.prime, value % self.prime, 0, 1
        while b >= HEIGHT:
            q, rest = divmod(a, b)
            a, b, u, v = b, rest, v, u - q * v
        return None if abs(v) >= HEIGHT else (b, v) if v > 0 else (-b, -v)

    def root(self, number: tuple[int, int] | None) -> int:
        """The root of a rational number: a square modulo the prime, as the roots of the small primes are chosen."""
        top, bottom = number or (-1, 1)
        rest = max(top, 0) * bottom
        for p in PRIMES if rest else ():
            while rest % p == 0:
                rest //= p
        require(rest == 1 or top == 0, f"the root of {number}: only of products of primes up to {PRIMES[-1]}")
        return power(top * self.inverse(bottom) % self.prime, (self.prime + 1) // 4, self.prime)


CHANCE = Chance()  # of this run


def polynomials(letter: Callable[[str], int]) -> Callable[[str], int]:
    """Gives the values of polynomials printed as "3/4*a_11^2*a_12 - I_1 + 2"; most parts occur again and again."""

    @lru_cache(None)
    def factor(text: str) -> int:
        if text[:1] == "-":
            return -factor(text[1:])
        if text[:1].isdecimal():
            top, slash, bottom = text.partition("/")
            require((top + bottom).isdecimal() and bool(bottom) == bool(slash), "the factor {}", text)
            return int(top) * CHANCE.inverse(int(bottom or 1))
        name, power_, exponent = text.partition("^")
        require(name.isidentifier() and bool(exponent) == bool(power_), "the factor {}", text)
        require((exponent or "1").isdecimal() and len(exponent) < 4, "the factor {}", text)  # no division
        return pow(letter(name), int(exponent or 1), CHANCE.prime)

    @lru_cache(None)
    def monomial(text: str) -> int:
        return prod(map(factor, text.split("*")))

    return lru_cache(None)(lambda text: sum(map(monomial, text.replace(" - ", " + -").split(" + "))) % CHANCE.prime)
