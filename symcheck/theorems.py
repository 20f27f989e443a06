"""What the checker takes for granted of functions: how terms are differentiated, and a table of theorems.

Terms and formulas are nested lists, as in `checker.py`; this file too uses the standard library alone.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

RELATIONS = ("=", "!=", "<", "<=", ">", ">=")


class Unknown(Exception):
    """A term, or a theorem, about which nothing is known here; the message names it."""


def conjuncts(formula: Any) -> list[Any]:
    """The formula taken apart at "and"."""
    return [part for child in formula[1:] for part in conjuncts(child)] if formula[0] == "and" else [formula]


def terms(formula: Any) -> list[Any]:
    """Both sides of every relation in a formula."""
    if formula[0] in RELATIONS:
        return list(formula[1:])
    return [term for part in formula[1 + (formula[0] == "exists") :] for term in terms(part)]


class Terms:
    """Terms over definitions, taken apart by their structure."""

    def __init__(self, definitions: dict[str, Any]) -> None:
        self.definitions = definitions
        self.met: set[str] = set()  # the definitions used
        self.degrees: dict[str, int] = {}  # of defined names

    def definition(self, name: str) -> Any:
        """What a defined name stands for."""
        self.met.add(name)
        return self.definitions[name]

    def degree(self, term: Any) -> int:
        """A bound of the degree, definitions having one already."""
        if not isinstance(term, list):
            return self.degrees.get(term, 1) if isinstance(term, str) else 0
        return abs(term[2]) * self.degree(term[1]) if term[0] == "^" else sum(map(self.degree, term[1:]))

    def names(self, term: Any) -> set[str]:
        """The letters a term or formula depends on, definitions unfolded."""
        if isinstance(term, str):
            return self.names(self.definitions[term]) if term in self.definitions else {term}
        return set().union(*map(self.names, term[1:])) if isinstance(term, (list, tuple)) else set()

    def derived(self, term: Any, x: str, order: int) -> Any:
        """The derivative of that order, as a term."""
        if x in self.definitions or order not in range(1, 9):
            raise Unknown(f"a derivative by {x}, which is not a free variable, or of the order {order}")
        for _ in range(order):
            term = self.rate(term, x)
        return term

    def rate(self, term: Any, x: str) -> Any:
        """The first derivative."""
        if x not in self.names(term):
            return 0
        match term:
            case str():
                return self.rate(self.definition(term), x) if term in self.definitions else 1
            case ["+" | "-" as sign, *parts]:
                return [sign, *(self.rate(part, x) for part in parts)]
            case ["*", *parts]:
                rates = [(k, self.rate(part, x)) for k, part in enumerate(parts) if x in self.names(part)]
                return ["+", *(["*", *parts[:k], rate, *parts[k + 1 :]] for k, rate in rates)]
            case ["/", top, bottom]:
                gain, loss = ["*", self.rate(top, x), bottom], ["*", top, self.rate(bottom, x)]
                return ["/", ["+", gain, ["-", loss]], ["^", bottom, 2]]
            case ["^", base, int(n)]:
                return ["*", n, ["^", base, n - 1], self.rate(base, x)]
            case ["pow", base, exponent]:
                first = ["/", ["*", exponent, self.rate(base, x)], base]
                return ["*", term, ["+", first, ["*", ["log", base], self.rate(exponent, x)]]]
            case ["sin" | "cos" | "tan" | "sqrt" | "log" as function, inner]:
                outer = {"sin": ["cos", inner], "cos": ["-", ["sin", inner]], "tan": ["^", ["cos", inner], -2]}
                outer |= {"sqrt": ["/", 1, ["*", 2, term]], "log": ["/", 1, inner]}
                return ["*", outer[function], self.rate(inner, x)]
            case ["diff", inner, str(y), int(n)]:
                return self.rate(self.derived(inner, y, n), x)
        raise Unknown(f"the derivative of {term!r}")

    def polynomial_in(self, term: Any, *atoms: Any) -> bool:
        """Whether the term is a polynomial in the atoms (x, or sin x and cos x) over what does not depend on them."""
        letters = self.names(["+", *atoms])
        if term in atoms or not self.names(term) & letters:
            return True
        match term:
            case str():
                return term in self.definitions and self.polynomial_in(self.definitions[term], *atoms)
            case ["+" | "*" | "-", *parts]:
                return all(self.polynomial_in(part, *atoms) for part in parts)
            case ["/", top, bottom]:
                return self.polynomial_in(top, *atoms) and not self.names(bottom) & letters
            case ["^", base, int(n)]:
                return n >= 0 and self.polynomial_in(base, *atoms)
        return False

    def replaced(self, term: Any, by: dict[str, Any]) -> Any:
        """The term with each part whose text is a key replaced, definitions unfolded."""
        if str(term) in by:
            return by[str(term)]
        if isinstance(term, str) and term in self.definitions:
            return self.replaced(self.definition(term), by)
        parts = term[1:] if isinstance(term, (list, tuple)) else ()
        return [term[0], *(self.replaced(part, by) for part in parts)] if parts else term


@dataclass(frozen=True)
class Theorem:
    """The premises imply the conclusion.

    `anew` is a letter said to exist: nothing else may be known or said of it. `free` is one for which the premises
    hold whatever its value is: nothing may be assumed of it, and the terms `without` do not depend on it.
    """

    premises: list[Any]
    conclusion: Any
    anew: str = ""
    free: str = ""
    without: tuple[Any, ...] = ()


def have(_: Terms, formula: Any) -> Theorem:
    """What is proved once may be used often."""
    return Theorem([formula], formula)


def root(_: Terms, t: Any) -> Theorem:
    """The square root of a number that is not negative."""
    return Theorem([[">=", t, 0]], ["and", [">=", ["sqrt", t], 0], ["=", ["^", ["sqrt", t], 2], t]])


def mean(terms: Terms, f: Any, x: str, m: Any, g: Any) -> Theorem:
    """Over one turn f has the mean m if f = m + g' with polynomials f, g in sin x and cos x."""
    if not all(terms.polynomial_in(t, ["sin", x], ["cos", x]) for t in (f, g)):
        raise Unknown(f"no polynomial in the sine and cosine of {x}")
    return Theorem([["=", f, ["+", m, ["diff", g, x, 1]]]], ["=", ["mean", f, x], m], free=x, without=(m,))


def quarter_turn(terms: Terms, p: Any, x: str) -> Theorem:
    """A polynomial p in sin x and cos x with p(x + 90 degrees) = -p(x) is zero somewhere."""
    sine, cosine = ["sin", x], ["cos", x]
    if not terms.polynomial_in(p, sine, cosine):
        raise Unknown(f"no polynomial in the sine and cosine of {x}")
    turned = terms.replaced(p, {str(sine): cosine, str(cosine): ["-", sine]})
    return Theorem([["=", turned, ["-", p]]], ["=", p, 0], anew=x)


def intermediate_value(terms: Terms, p: Any, x: str, low: Any, high: Any) -> Theorem:
    """A polynomial p in x with values of two signs at the ends of an interval is zero inside."""
    if not terms.polynomial_in(p, x):
        raise Unknown(f"no polynomial in {x}")
    ends = ["*", *(terms.replaced(p, {x: end}) for end in (low, high))]
    inside = ["and", ["<", low, x], ["<", x, high], ["=", p, 0]]
    return Theorem([["<", low, high], ["<", ends, 0]], inside, anew=x, without=(low, high))


THEOREMS: dict[str, Callable[..., Theorem]] = {
    each.__name__: each for each in (have, root, mean, quarter_turn, intermediate_value)
}
