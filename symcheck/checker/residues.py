"""Numbers modulo a random prime: residues of letters, circle points, roots, polynomials."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from functools import lru_cache
from math import factorial, gcd, prod

HEIGHT = 1 << 96  # numerators and denominators stay below; p > 2 HEIGHT^2 makes the fraction of a residue unique
# the prime is chosen so that these have square roots; no other primes are needed under the papers' roots
PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43)
SIEVE = factorial(2000)  # most candidates have a small divisor


class Reject(Exception):
    """The certificate does not prove its claim; the message says where it fails."""


def require(condition: object, reason: str, *about: object) -> None:
    """Rejects with the reason, and what it is about, unless the condition holds."""
    if not condition:
        raise Reject(reason.format(*(str(each)[:200] for each in about)) if about else reason)


def prime() -> int:
    """A random prime, -1 modulo 8 and modulo the small primes, so that their roots exist."""
    while True:
        p = 4 * prod(PRIMES) * (2**198 + int.from_bytes(os.urandom(24), "big")) - 1
        bases = (int.from_bytes(os.urandom(16), "big") for _ in range(6))
        if gcd(p, SIEVE) == 1 and all(pow(base, p >> 1, p) in (1, p - 1) for base in bases):
            return p


PRIME = prime()  # of this run
power = lru_cache(None)(pow)  # the same roots and inverses are needed again and again


@lru_cache(None)
def draw(*key: object) -> int:
    """The random number that belongs to the key: a letter, a function with values of its arguments, ..."""
    return int.from_bytes(os.urandom(40), "big") % PRIME


@lru_cache(None)
def circle(*key: object) -> tuple[int, int]:
    """The point (cos, sin) of the unit circle that belongs to the key."""
    return rotation(draw("half", *key))


def rotation(half: int) -> tuple[int, int]:
    """(cos, sin) of an angle by the tangent of its half."""
    below = inverse(1 + half * half)
    return (1 - half * half) * below % PRIME, 2 * half * below % PRIME


def inverse(value: int) -> int:
    """1 / value."""
    require(value % PRIME, "division by zero")
    return power(value % PRIME, -1, PRIME)


@lru_cache(None)
def rational(value: int) -> tuple[int, int] | None:
    """(n, d) with d > 0 if n/d in lowest terms has this value; None if there are none below HEIGHT."""
    a, b, u, v = PRIME, value % PRIME, 0, 1
    while b >= HEIGHT:
        q, rest = divmod(a, b)
        a, b, u, v = b, rest, v, u - q * v
    return None if abs(v) >= HEIGHT else (b, v) if v > 0 else (-b, -v)


@lru_cache(None)
def has_root(fraction: tuple[int, int] | None) -> bool:
    """Whether a rational number is zero, or a product of small primes, so that its root is known."""
    top, bottom = fraction or (-1, 1)
    rest = max(top, 0) * bottom
    for p in PRIMES if rest else ():
        while rest % p == 0:
            rest //= p
    return rest == 1 or top == 0


def root(fraction: tuple[int, int] | None) -> int:
    """The root of a rational number: a square modulo the prime, as the roots of the small primes are chosen."""
    require(has_root(fraction), f"the root of {fraction}: only of products of primes up to {PRIMES[-1]}")
    top, bottom = fraction or (0, 1)
    return power(top * inverse(bottom) % PRIME, (PRIME + 1) // 4, PRIME)


def polynomials(values: Mapping[str, int]) -> Callable[[str], int]:
    """Gives the values of polynomials printed as "3/4*a_11^2*a_12 - I_1 + 2"; most parts occur again and again.

    Letters have the values given, else those that are drawn for them.
    """

    @lru_cache(None)
    def factor(text: str) -> int:
        if text[:1] == "-":
            return -factor(text[1:])
        if text[:1].isdecimal():
            top, slash, bottom = text.partition("/")
            require((top + bottom).isdecimal() and bool(bottom) == bool(slash), "the factor {}", text)
            return int(top) * inverse(int(bottom or 1))
        name, hat, exponent = text.partition("^")
        proper = name.isidentifier() and bool(exponent) == bool(hat) and (exponent or "1").isdecimal()  # no division
        require(proper and len(exponent) < 4, "the factor {}", text)
        return pow(values[name] if name in values else draw("letter", name), int(exponent or 1), PRIME)

    @lru_cache(None)
    def monomial(text: str) -> int:
        return prod(map(factor, text.split("*")))

    return lru_cache(None)(lambda text: sum(map(monomial, text.replace(" - ", " + -").split(" + "))) % PRIME)
