"""What is known at a place of a proof, by the names it has in Coq, and the lines written so far."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import NamedTuple

from symcheck.checker.rules import Reference, reference
from symcheck.coq.printing import spelled
from symcheck.coq.statements import Statement
from symcheck.coq.terms import Definitions, NotExported, Tree, rebuilt, without_tangents
from symcheck.core.terms import JSON, Connective, Formula, Node, Relation, Term, node


class Known(NamedTuple):
    """An assumption in force, and its name in Coq."""

    formula: Formula
    hypothesis: str

    @property
    def sign(self) -> str:
        return self.formula.tag.replace("<", ">") if isinstance(self.formula, Relation) else self.formula.tag

    @property
    def sides(self) -> tuple[Term, Term]:
        """Of an order the greater side comes first."""
        assert isinstance(self.formula, Relation)
        left, right = self.formula.terms
        return (right, left) if self.formula.tag[0] == "<" else (left, right)

    @property
    def difference(self) -> Term:
        """By how much the first side exceeds the second."""
        great, small = self.sides
        return great if small == 0 else node("+", great, node("-", small))

    @property
    def apart(self) -> str:
        """A proof that the difference is not zero."""
        return f"(sub_nz {self.hypothesis})" if self.sign == "!=" else f"(pos_nz (lt_pos {self.hypothesis}))"


class Assumptions:
    """The context of a proof that is being written."""

    def __init__(self, statement: Statement) -> None:
        self.statement = statement
        self.rewritten: dict[Node, Term] = {}  # what terms are rewritten to
        self.lines: list[str] = []
        self.state: dict[Reference, Known] = {}
        self.own = 0  # how many of them are hypotheses
        self.nonzero: dict[str, tuple[str, Term]] = {}  # text -> name of the fact, term
        self.hints: list[str] = []
        self.divides = False
        self.count = 0
        self.atoms: dict[str, Term] = {}
        self.listed: list[tuple[Term, Term]] = []  # numerators of divisors, and what they are divided by
        self.scope: set[str] = set(statement.variables)  # the letters there are
        self.seen: dict[int, Term] = {}  # functions by their values, as first met
        self.settled: set[str] = set()  # the functions of which everything is said

    @property
    def definitions(self) -> Definitions:
        return self.statement.definitions

    def read(self, data: JSON) -> Term:
        """A term of the proof as it stands in Coq."""
        return self.full(self.definitions.read(data))

    def full(self, tree: Tree) -> Tree:
        """A term or formula as it stands in Coq after the beginning: unfolded, without tangents and derivatives."""
        return self.worked(without_tangents(self.definitions.unfolded(tree)))

    def worked(self, tree: Tree) -> Tree:
        if isinstance(tree, Node) and tree in self.rewritten:
            return self.rewritten[tree]  # type: ignore[return-value]
        return rebuilt(tree, self.worked, self.worked) if self.rewritten else tree

    def emit(self, line: str) -> None:
        self.lines.append(line)

    def anew(self, stem: str) -> str:
        self.count += 1
        return f"{stem}{self.count}'"

    @property
    def algebra(self) -> str:
        """The tactic that ends every computation."""
        return f"field{self.hinted}; nonzero" if self.divides else f"ring{self.hinted}"

    @property
    def hinted(self) -> str:
        return f" [{' '.join(self.hints)}]" if self.hints else ""

    def hint(self, proof: str) -> None:
        own = self.anew("e")
        self.emit(f"pose proof {proof} as {own}.")
        self.hints.append(own)

    def prove_aside(self, formula: Formula, stem: str, by: str) -> str:
        """An auxiliary fact with a proof of one line; its name."""
        own = self.anew(stem)
        self.emit(f"assert ({own} : {spelled(formula)}) by ({by}).")
        return own

    def assume(self, formula: Formula, reference: Reference | None = None) -> str:
        """Takes in an assumption, part by part; the pattern that takes it apart in Coq."""
        return self._pattern(self.full(formula), reference)

    def _pattern(self, formula: Formula, reference: Reference | None) -> str:
        if isinstance(formula, Connective) and formula.tag == "and":
            return pattern([self._pattern(part, None) for part in formula.formulas])
        own = self.anew("h")
        self.learn(formula, own, reference)
        return own

    def learn(self, formula: Formula, own: str, reference: Reference | None = None) -> None:
        self.state[reference or ("here", len(self.state) - self.own)] = Known(formula, own)

    def emit_later(self) -> None:
        """An assumption a >= b is turned round: 0 <= a - b is what is used of it."""
        for known in self.state.values():
            line = f"apply Rge_le in {known.hypothesis}."
            if known.formula.tag == ">=" and line not in self.lines:
                self.emit(line)

    def facts(self, *signs: str) -> Iterator[Known]:
        """The facts with these signs."""
        return (known for known in self.state.values() if known.sign in signs)

    def fact(self, data: JSON, signs: Iterable[str]) -> Known:
        """The fact that a proof refers to."""
        known = self.state.get(reference(data))
        if known is None or known.sign not in signs:
            raise NotExported(f"the assumption {data}")
        return known

    @contextmanager
    def inside(self) -> Iterator[None]:
        """Braces around a subgoal; what is learned in it is forgotten afterwards."""
        kept = dict(self.state), dict(self.nonzero), list(self.hints), set(self.scope), set(self.settled)
        self.emit("{")
        yield
        self.emit("}")
        self.state, self.nonzero, self.hints, self.scope, self.settled = kept


def pattern(parts: list[str]) -> str:
    """The pattern that takes a conjunction apart."""
    *front, last = parts or ["_"]
    return f"[{' ['.join(front)} {last}{']' * len(front)}" if front else last
