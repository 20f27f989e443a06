"""What is known at a place of a proof, by the names it has in Coq, and the lines written so far."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from fractions import Fraction
from typing import Any, NamedTuple

from symcheck.export.coq.arithmetic import without_tangents
from symcheck.export.coq.printing import ATOM, spelled
from symcheck.export.coq.statements import Statement
from symcheck.export.coq.terms import NotExported, rebuilt
from symcheck.export.coq.values import Values
from symcheck.proof.theorems import RELATIONS


class Known(NamedTuple):
    """An assumption in force: a relation great ~ small (">" and "<" alike), or another formula; and its name in Coq."""

    sign: str
    great: Any
    small: Any
    formula: Any
    hypothesis: str


class Assumptions:
    """The context of a proof that is being written."""

    def __init__(self, statement: Statement) -> None:
        self.statement, self.values = statement, Values()
        self.rewritten: dict[str, Any] = {}  # text of a term -> what it is rewritten to
        self.lines: list[str] = []
        self.state: dict[Any, Known] = {}
        self.own = 0  # how many of them are hypotheses
        self.nonzero: dict[str, tuple[str, Any]] = {}  # text -> name of the fact, term
        self.hints: list[str] = []
        self.divides = False
        self.count = 0
        self.atoms: dict[str, Any] = {}
        self.listed: list[tuple[Any, list[Any]]] = []  # numerators of divisors, and what they are divided by
        self.scope: set[str] = set(statement.variables)  # the letters there are
        self.seen: dict[int, Any] = {}  # functions by their values, as first met
        self.settled: set[str] = set()  # the functions of which everything is said

    def full(self, node: Any) -> Any:
        """A term or formula as it stands in Coq after the beginning: unfolded, without tangents and derivatives."""
        return self.worked(without_tangents(self.statement.definitions.unfolded(node)))

    def worked(self, node: Any) -> Any:
        if not self.rewritten or not isinstance(node, list):
            return node
        return self.rewritten.get(str(node)) or rebuilt(node, self.worked)

    def emit(self, line: str) -> None:
        self.lines.append(line)

    def anew(self, stem: str) -> str:
        self.count += 1
        return f"{stem}{self.count}'"

    def text(self, term: Any) -> str:
        return spelled(term)

    def bracketed(self, term: Any) -> str:
        return spelled(term, ATOM)

    @property
    def algebra(self) -> str:
        """The tactic that ends every computation."""
        hints = f" [{' '.join(self.hints)}]" if self.hints else ""
        return f"field{hints}; nonzero" if self.divides else f"ring{hints}"

    def hinted(self) -> str:
        return f" [{' '.join(self.hints)}]" if self.hints else ""

    def hint(self, proof: str) -> None:
        own = self.anew("e")
        self.emit(f"pose proof {proof} as {own}.")
        self.hints.append(own)

    def prove_aside(self, formula: Any, stem: str, by: str) -> str:
        """An auxiliary fact with a proof of one line; its name."""
        own = self.anew(stem)
        self.emit(f"assert ({own} : {spelled(formula)}) by ({by}).")
        return own

    def assume(self, formula: Any, reference: Any = None) -> str:
        """Takes in an assumption, part by part; the pattern that takes it apart in Coq."""
        return self._pattern(self.full(formula), reference)

    def _pattern(self, formula: Any, reference: Any) -> str:
        if formula[0] == "and":
            parts = [self._pattern(part, None) for part in formula[1:]]
            if not parts:
                return "_"
            return parts[0] if len(parts) == 1 else f"[{' ['.join(parts[:-1])} {parts[-1]}{']' * (len(parts) - 1)}"
        own = self.anew("h")
        self.learn(formula, own, reference)
        return own

    def learn(self, formula: Any, own: str, reference: Any = None) -> None:
        sign, *content = formula
        great, small = content if sign in RELATIONS else (None, None)
        if sign in ("<", "<="):
            sign, great, small = sign.replace("<", ">"), small, great
        if reference is None:
            reference = ("here", len(self.state) - self.own)
        self.state[reference] = Known(sign, great, small, formula, own)

    def emit_later(self) -> None:
        """An assumption a >= b is turned round: 0 <= a - b is what is used of it."""
        for known in self.state.values():
            line = f"apply Rge_le in {known.hypothesis}."
            if known.formula[0] == ">=" and line not in self.lines:
                self.emit(line)

    def fact(self, reference: Any, signs: Iterable[str]) -> Known:
        known = self.state.get(tuple(reference))
        if known is None or known.sign not in signs:
            raise NotExported(f"the assumption {reference}")
        return known

    @contextmanager
    def inside(self) -> Iterator[None]:
        """Braces around a subgoal; what is learned in it is forgotten afterwards."""
        kept = dict(self.state), dict(self.nonzero), list(self.hints), set(self.scope), set(self.settled)
        self.emit("{")
        yield
        self.emit("}")
        self.state, self.nonzero, self.hints, self.scope, self.settled = kept

    def ratio(self, one: Any, other: Any) -> Fraction | None:
        """one / other, if that is a rational number and not zero."""
        return self.values.ratio(one, other) or None

    def apart(self, known: Known) -> str:
        """A proof that the difference of an assumption is not zero."""
        return f"(sub_nz {known.hypothesis})" if known.sign == "!=" else f"(pos_nz (lt_pos {known.hypothesis}))"


def difference(known: Known) -> Any:
    """great - small."""
    return known.great if known.small == 0 else ["+", known.great, ["-", known.small]]
