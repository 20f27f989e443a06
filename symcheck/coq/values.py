"""Which terms are equal as numbers: values modulo a random prime. This finds the steps of a proof; Coq checks them."""

from __future__ import annotations

from fractions import Fraction

from symcheck.checker.algebra import Algebra, Key
from symcheck.checker.residues import PRIME, inverse, rational
from symcheck.coq.printing import ATOM, spelled
from symcheck.core.terms import Term, node

QUARTER = node("/", node("pi"), 2)
MAX_QUARTERS = 8  # two turns: each quarter is one use of the addition theorems


def value(term: Term) -> int:
    """The value of a term at the point of the checker's algebra."""
    return Algebra({}).value(term) % PRIME


def ratio(one: Term, other: Term) -> Fraction | None:
    """The rational number one / other, if it is one and not zero."""
    below = value(other)
    return number(value(one) * inverse(below)) or None if below else None


def number(residue: int) -> Fraction | None:
    """The rational number that has this value modulo the prime, if there is a small one."""
    found = rational(residue)
    return None if found is None else Fraction(*found)


def quotient(q: Fraction) -> Term:
    """A rational number as a term."""
    return q.numerator if q.denominator == 1 else node("/", q.numerator, q.denominator)


def printed_ratio(q: Fraction) -> str:
    """The same as Coq reads it, in brackets where it needs them."""
    return spelled(quotient(q), ATOM)


def turns(angle: Term) -> tuple[list[tuple[Term, int]], Term]:
    """An angle as whole multiples of letters and of a quarter turn, and a rest."""
    total: dict[Key, int] = {}
    for key, residue in Algebra({}).angles(angle, 1):
        total[key] = total.get(key, 0) + residue
    whole, rest = list[tuple[Term, int]](), list[Term]()
    for key, residue in total.items():
        if (times := number(residue)) is None:
            return [], angle
        match key:
            case "letter", str(x) if times.denominator == 1:
                whole += [(x, int(times))] if times else []
            case "letter", str(x):
                rest.append(node("*", quotient(times), x))
            case ("pi",) if 0 < abs(2 * times) <= MAX_QUARTERS and (2 * times).denominator == 1:
                whole.append((QUARTER, int(2 * times)))
            case ("pi",):
                rest += [node("*", quotient(times), node("pi"))] if times else []
            case "number", int(own) if known := number(own):
                rest.append(quotient(known * times))
            case _:
                return [], angle
    return whole, (rest[0] if len(rest) == 1 else node("+", *rest)) if whole and rest else angle if rest else 0
