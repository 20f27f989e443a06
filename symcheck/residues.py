"""Numbers to compute with modulo a random prime: residues of letters, of points of the circle, and of roots.

The standard library alone: this is a part of the checker.
"""

import os
import re
from fractions import Fraction
from functools import lru_cache
from math import factorial, gcd, prod
from typing import Any

HEIGHT = 1 << 96
PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43)
SIEVE = factorial(2000)  # most candidates have a small divisor


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
            if gcd(p, SIEVE) > 1:
                continue
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
def chance() -> Chance:
    """The prime and the point of this run."""
    return Chance()
