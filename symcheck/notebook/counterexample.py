"""A refutation evaluated anew, exactly: both sides of every equality that tells, at the certificate's point."""

from __future__ import annotations

import operator as op
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from symcheck.evidence.steps import term as in_words
from symcheck.lazy import lazy
from symcheck.notebook import letters
from symcheck.reading import Notation, to_sympy
from symcheck.statement import Certificate, SymcheckError

sp = lazy("sympy")

_HOLDS = {"=": op.eq, "!=": op.ne, "<": op.lt, "<=": op.le, ">": op.gt, ">=": op.ge}
_SIGNS = {"=": "=", "!=": r"\ne", "<": "<", "<=": r"\le", ">": ">", ">=": r"\ge"}
_DENIED = {"=": r"\ne", "!=": "=", "<": r"\not<", "<=": r"\not\le", ">": r"\not>", ">=": r"\not\ge"}
SHORT = 24  # signs of a value that is shown exactly
_ON_THE_CIRCLE = ("sin", "cos")
_DIGITS = 30  # of numbers that are compared as decimals; those of a certificate differ in the first six


class Compared(NamedTuple):
    """One relation at the point: as LaTeX, its sign, both values, whether it holds there."""

    statement: str
    sign: str
    left: Any
    right: Any
    holds: bool


class Evaluation:
    """The claim of a refuting certificate at its point."""

    def __init__(self, certificate: Certificate, notation: Notation) -> None:
        self._notation = notation
        self._claim = _tuples(certificate["claim"])
        self._definitions = {name: _tuples(value) for name, value in certificate["definitions"]}
        self._functions = {
            _tuples(each): _tuples(value) for each, value, *_ in certificate["point"].get("functions", ())
        }
        self.values = {name: _exact(value) for name, value in certificate["point"]["values"].items()}
        self._letters = {sp.Symbol(name, real=True): value for name, value in self.values.items()}
        self._circle = {  # sines and cosines that are given in the place of their angle
            getattr(sp, function)(sp.Symbol(angle, real=True)): value
            for name, value in self.values.items()
            for function, _, angle in [name.partition("_")]
            if function in _ON_THE_CIRCLE and angle
        }

    def compared(self) -> list[Compared]:
        """The relations that show why the claim is false at the point."""
        return list(self._why(self._claim))

    def holds(self) -> bool:
        """Whether the claim holds at the point, as evaluated here."""
        return self._truth(self._claim)

    def _truth(self, formula: Any) -> bool:
        head, *parts = formula
        if head in _HOLDS:
            return self._compare(formula).holds
        truths = [self._truth(part) for part in parts]
        match head:
            case "and":
                return all(truths)
            case "or":
                return any(truths)
            case "=>":
                return truths[1] or not truths[0]
            case "<=>":
                return truths[0] == truths[1]
        raise SymcheckError(f"a counterexample to {in_words(formula)} cannot be evaluated; look at its certificate")

    def _why(self, formula: Any) -> Iterator[Compared]:
        """What is compared to see that the formula has the truth value it has."""
        head, *parts = formula
        if head in _HOLDS:
            yield self._compare(formula)
            return
        deciding = {("and", False): False, ("or", True): True}.get((head, self._truth(formula)))
        if deciding is not None:  # one part alone decides
            parts = [next(part for part in parts if self._truth(part) is deciding)]
        for part in parts:
            yield from self._why(part)

    def _compare(self, formula: Any) -> Compared:
        head, *sides = formula
        left, right = (self._value(side) for side in sides)
        difference = left - right
        exact = difference.is_Rational or sp.simplify(difference) == 0
        number = difference if difference.is_Rational else sp.Integer(0) if exact else sp.N(difference, _DIGITS)
        holds = bool(_HOLDS[head](number, 0))
        stated = f" {_SIGNS[head]} ".join(letters.expression(_plain(side), self._notation) for side in sides)
        return Compared(stated, _SIGNS[head] if holds else _DENIED[head], left, right, holds)

    def _value(self, term: Any) -> Any:
        """The exact value of a term: definitions unfolded, functions with their certified values."""
        value = to_sympy(self._unfolded(term))
        if self._circle:
            value = sp.expand_trig(value).subs(self._circle)
        while (put := value.subs(self._letters)) != value:  # a letter may be given by others
            value = put
        return value

    def _unfolded(self, term: Any) -> Any:
        if isinstance(term, str):
            return self._unfolded(self._definitions[term]) if term in self._definitions else term
        if not isinstance(term, tuple):
            return term
        whole = (term[0], *(self._unfolded(part) for part in term[1:]))
        return self._functions.get(whole, whole)


def _exact(value: Any) -> Any:
    """A value of a certificate: a term, or a fraction as text."""
    return sp.Rational(value) if isinstance(value, str) else to_sympy(_tuples(value))


def _plain(term: Any) -> Any:
    """A term as an expression, for display; what SymPy has no word for is a function by its name."""
    if isinstance(term, tuple) and term[0] == "diverges":
        body, *bound = term[1:]
        return sp.Function("diverges")(_plain(("integral", body, *bound)))
    return to_sympy(term)


def _tuples(value: Any) -> Any:
    return tuple(map(_tuples, value)) if isinstance(value, list) else value


def number(value: Any) -> str:
    """A value as LaTeX: exact where it is short, else six digits of it."""
    exact: str = sp.latex(value)
    if letters.width(exact) <= SHORT and not value.has(sp.Float):
        return exact
    return rf"{sp.latex(sp.N(value, 6))}\ldots"


def point(values: Mapping[str, Any], notation: Notation) -> str:
    """The point as LaTeX, "letter = value"."""
    return r" \quad ".join(f"{_name(name, notation)} = {sp.latex(value)}" for name, value in values.items())


def _name(name: str, notation: Notation) -> str:
    function, _, rest = name.partition("_")
    if function in _ON_THE_CIRCLE and rest:
        return rf"\{function} {letters.letter(rest, notation)}"
    return letters.letter(name, notation)
