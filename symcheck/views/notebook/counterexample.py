"""A refutation evaluated anew, exactly: both sides of each relation that decides, at the certificate's point."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from symcheck.coq.meaning import RELATIONS, Evaluator, Values
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


class Evaluation(Evaluator):
    """The claim of a refuting certificate at its point, in exact numbers of SymPy."""

    def __init__(self, certificate: Certificate, notation: Notation) -> None:
        super().__init__()
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

    def holds(self, formula: Any = None) -> bool:
        """Whether the claim, or a part of it, holds at the point, as evaluated here."""
        return bool(self.truth(formula or self._claim, {}))

    def term(self, node: JSON, at: Values) -> Expr:
        """The exact value of a term: definitions unfolded, functions with their certified values."""
        at_point = substituted(self._meaning.term(node), self._letters)
        return sp.expand_trig(to_sympy(self._known(at_point)))

    def sign(self, relation: Any, at: Values) -> int:
        left, right = (self.term(side, at) for side in relation[1:])
        difference = left - right
        if not difference.is_Rational:
            difference = 0 if sp.simplify(difference) == 0 else sp.N(difference, _DIGITS)
        return int(sp.sign(difference))

    def quantified(self, node: JSON, at: Values) -> bool:
        raise SymcheckError(f"a counterexample to {in_words(node)} cannot be evaluated; look at its certificate")

    def _why(self, formula: Any) -> Iterator[Compared]:
        """What is compared to see that the formula has the truth value it has."""
        head, *parts = formula
        if head in RELATIONS:
            yield self._compared(formula)
            return
        deciding = {("and", False): False, ("or", True): True}.get((head, self.holds(formula)))
        if deciding is not None:  # one part alone decides
            parts = [next(part for part in parts if self.holds(part) is deciding)]
        for part in parts:
            yield from self._why(part)

    def _compared(self, relation: Any) -> Compared:
        head, *sides = relation
        left, right = (self.term(side, {}) for side in sides)
        holds = self.holds(relation)
        stated = f" {_SIGNS[head]} ".join(letters.expression(_plain(Reader().term(s)), self._notation) for s in sides)
        return Compared(stated, _SIGNS[head] if holds else _DENIED[head], left, right, holds)

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
