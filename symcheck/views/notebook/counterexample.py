"""A refutation evaluated anew, exactly: both sides of every equality that tells, at the certificate's point."""

from __future__ import annotations

import operator as op
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from symcheck.core.calculus import substituted
from symcheck.core.certificates import Certificate
from symcheck.core.lazy import lazy
from symcheck.core.terms import JSON, Binder, Node, Reader, Term, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.core.words import term as in_words
from symcheck.reading import Notation, to_sympy
from symcheck.views.notebook import letters
from symcheck.views.steps import coordinates

if TYPE_CHECKING:
    from sympy import Expr

sp = lazy("sympy")

_HOLDS = {"=": op.eq, "!=": op.ne, "<": op.lt, "<=": op.le, ">": op.gt, ">=": op.ge}
_SIGNS = {"=": "=", "!=": r"\ne", "<": "<", "<=": r"\le", ">": ">", ">=": r"\ge"}
_DENIED = {"=": r"\ne", "!=": "=", "<": r"\not<", "<=": r"\not\le", ">": r"\not>", ">=": r"\not\ge"}
SHORT = 24  # signs of a value that is shown exactly
_DIGITS = 30  # of numbers that are compared as decimals; those of a certificate differ in the first six


class Compared(NamedTuple):
    """One relation at the point: as LaTeX, its sign, both values, whether it holds there."""

    statement: str
    sign: str
    left: Expr
    right: Expr
    holds: bool


class Evaluation:
    """The claim of a refuting certificate at its point."""

    def __init__(self, certificate: Certificate, notation: Notation) -> None:
        self._notation = notation
        self._claim = certificate["claim"]
        self._meaning = Reader()  # of terms in which definitions are unfolded
        for name, value in certificate["definitions"]:
            self._meaning.define(name, value)
        self.values = certificate["point"]["values"]
        self._letters = {name: Reader().term(value) for name, value in self.values.items()}
        self._functions = dict(_functions(certificate["point"].get("proof", {})))

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
        shown = (letters.expression(_plain(Reader().term(side)), self._notation) for side in sides)
        stated = f" {_SIGNS[head]} ".join(shown)
        return Compared(stated, _SIGNS[head] if holds else _DENIED[head], left, right, holds)

    def _value(self, term: JSON) -> Expr:
        """The exact value of a term: definitions unfolded, functions with their certified values."""
        at_point = substituted(self._meaning.term(term), self._letters)
        return sp.expand_trig(to_sympy(self._known(at_point)))

    def _known(self, term: Term) -> Term:
        if term in self._functions:
            return self._functions[term]
        return mapped(term, self._known) if isinstance(term, Node) else term


def _functions(proof: Mapping[str, Any]) -> Iterator[tuple[Term, Term]]:
    """The values of functions that are proved first of all at a point."""
    while proof.get("rule") == "have":
        sign, *sides = proof["formula"]
        if sign == "=":
            function, value = map(Reader().term, sides)
            yield function, value
        proof = proof["then"]


def _plain(term: Term) -> Expr:
    """A term as an expression, for display; what SymPy has no word for is a function by its name."""
    if isinstance(term, Binder) and term.tag == "diverges":
        return sp.Function("diverges")(_plain(node("integral", *term[1:])))
    return to_sympy(term)


def number(value: Expr) -> str:
    """A value as LaTeX: exact where it is short, else six digits of it."""
    exact: str = sp.latex(value)
    if letters.width(exact) <= SHORT and not value.has(sp.Float):
        return exact
    return rf"{sp.latex(sp.N(value, 6))}\ldots"


def point(values: Mapping[str, JSON], notation: Notation) -> str:
    """The point as LaTeX, "letter = value"."""
    shown = (
        (rf"\{function} " if function else "", letters.letter(name, notation), to_sympy(Reader().term(value)))
        for function, name, value in coordinates(values)
    )
    return r" \quad ".join(f"{function}{name} = {sp.latex(value)}" for function, name, value in shown)
