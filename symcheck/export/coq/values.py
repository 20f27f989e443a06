"""Which terms are equal as numbers: values modulo a random prime. This finds the steps of a proof; Coq checks them."""

from __future__ import annotations

from fractions import Fraction
from math import prod
from typing import Any

from symcheck.checker.residues import PRIME, Reject, circle, draw, inverse, rational, root
from symcheck.export.coq.terms import NotExported, is_number

OPAQUE = ("sqrt", "pow", "exp", "log", "gamma", "arctan", "arcsin", "arccos")


def linear(term: Any) -> dict[Any, Fraction] | None:
    """The term as a combination of letters with rational coefficients (those of "" are numbers); None if it is none."""
    match term:
        case int():
            return {"": Fraction(term)}
        case str():
            return {term: Fraction(1)}
        case ["-", inner] if (found := linear(inner)) is not None:
            return {x: -c for x, c in found.items()}
        case ["+", *parts]:
            total: dict[Any, Fraction] = {}
            for part in map(linear, parts):
                if part is None:
                    return None
                for x, c in part.items():
                    total[x] = total.get(x, Fraction(0)) + c
            return total
        case ["*" | "/" as sign, *parts]:
            found_parts = [linear(part) for part in parts]
            if any(part is None for part in found_parts):
                return None
            if sign == "/" and set(found_parts[1] or {}) != {""}:
                return None
            moving = [p for p in found_parts[: 1 if sign == "/" else None] if p is not None and set(p) != {""}]
            if len(moving) > 1:
                return None
            numbers = [p[""] for p in found_parts if p is not None and set(p) == {""}]
            if sign == "/":
                bottom = (found_parts[1] or {})[""]
                numbers[-1] = 1 / bottom if bottom else Fraction(0)
            factor = prod(numbers, start=Fraction(1))
            return {x: c * factor for x, c in moving[0].items()} if moving else {"": factor}
    return None


class Values:
    """Values of unfolded terms at one random point; roots of numbers are roots, other functions are random."""

    def value(self, term: Any) -> int:
        """The value of a term."""
        try:
            return self._value(term) % PRIME
        except Reject as reason:
            raise NotExported(str(reason)) from reason

    def ratio(self, one: Any, other: Any) -> Fraction | None:
        """The rational number one / other, if it is one."""
        below = self.value(other)
        return self.rational(self.value(one) * inverse(below)) if below else None

    def rational(self, value: int) -> Fraction | None:
        """The rational number that has this value modulo the prime, if there is a small one."""
        found = rational(value)
        return None if found is None else Fraction(*found)

    def _value(self, term: Any) -> int:
        match term:
            case int():
                return term
            case str():
                return draw("letter", term)
            case ["+", *parts]:
                return sum(map(self._value, parts))
            case ["-", inner]:
                return -self._value(inner)
            case ["*", *parts]:
                return prod(map(self._value, parts)) % PRIME
            case ["/", top, bottom]:
                return self._value(top) * inverse(self._value(bottom))
            case ["^", base, int(n)]:
                value = self._value(base) if n >= 0 else inverse(self._value(base))
                return pow(value, abs(n), PRIME)
            case ["sin", angle]:
                return self._turn(angle)[1]
            case ["cos", angle]:
                return self._turn(angle)[0]
            case ["tan", angle]:
                cosine, sine = self._turn(angle)
                return sine * inverse(cosine)
            case ["sqrt", inner] if is_number(inner):
                return root(rational(self.value(inner)))
            case [function, *arguments] if function in OPAQUE:
                return draw(function, *map(self.value, arguments))
            case ["call", function, orders, *arguments]:
                return draw("call", function, *orders, *map(self.value, arguments))
            case ["diff" | "mean" | "integral" | "diverges", *_]:
                return draw(str(term))
        raise NotExported(f"the term {term!r}")

    def _turn(self, angle: Any) -> tuple[int, int]:
        counts, rest = turns(angle)
        cosine, sine = circle("angle", self.value(rest)) if rest != 0 else (1, 0)
        for x, n in counts:
            c, s = circle("letter", x)
            s = s if n > 0 else -s
            for _ in range(abs(n)):
                cosine, sine = (cosine * c - sine * s) % PRIME, (sine * c + cosine * s) % PRIME
        return cosine, sine


def turns(angle: Any) -> tuple[list[tuple[str, int]], Any]:
    """An angle as whole multiples of letters and a rest."""
    found = linear(angle)
    if found is None:
        return [], angle
    whole = [(x, int(c)) for x, c in found.items() if x not in ("", "pi") and c and c.denominator == 1]
    rest = {x: c for x, c in found.items() if c and (x in ("", "pi") or c.denominator != 1)}
    if not rest:
        return whole, 0
    terms = [
        ["*", ["/", c.numerator, c.denominator], x] if x else ["/", c.numerator, c.denominator] for x, c in rest.items()
    ]
    return whole, angle if not whole else terms[0] if len(terms) == 1 else ["+", *terms]
