"""What is known at a place of a proof, by the names it has in Coq, and the lines written so far."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import NamedTuple

from symcheck.checker.rules import Reference, reference
from symcheck.coq.printing import spelled
from symcheck.coq.terms import Definitions, NotExported, Tree, without_tangents
from symcheck.core.terms import JSON, Connective, Formula, Node, Relation, Term, mapped, node


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


@dataclass
class State:
    """The proof that is being written: its lines, and what is known where they end."""

    definitions: Definitions
    scope: set[str]  # the letters there are
    lines: list[str] = field(default_factory=list)
    known: dict[Reference, Known] = field(default_factory=dict)
    hypotheses: int = 0  # how many of them are hypotheses of the statement
    rewritten: dict[Node, Term] = field(default_factory=dict)  # what terms are rewritten to
    nonzero: dict[str, tuple[str, Term]] = field(default_factory=dict)  # text -> name of the fact, term
    hints: list[str] = field(default_factory=list)  # equations for `ring` and `field`
    divides: bool = False
    count: int = 0
    atoms: dict[str, Term] = field(default_factory=dict)  # what the letters of cofactors stand for
    listed: list[tuple[Term, Term]] = field(default_factory=list)  # numerators of divisors, and their denominators
    functions: dict[int, Term] = field(default_factory=dict)  # unknown and opaque functions by their values
    settled: set[str] = field(default_factory=set)  # the functions of which everything is said

    def read(self, data: JSON) -> Term:
        """A term of the proof as it stands in Coq."""
        return self.full(self.definitions.read(data))

    def read_formula(self, data: JSON) -> Formula:
        """A formula of the proof as it stands in Coq."""
        return self.full(self.definitions.formula(data))

    def full(self, tree: Tree) -> Tree:
        """A term or formula as it stands in Coq after the beginning: unfolded, without tangents and derivatives."""
        return self.worked(without_tangents(self.definitions.unfolded(tree)))

    def worked(self, tree: Tree) -> Tree:
        """The term or formula with everything rewritten that has been rewritten in Coq."""
        if not isinstance(tree, Node) or not self.rewritten:
            return tree
        return self.rewritten[tree] if tree in self.rewritten else mapped(tree, self.worked)  # type: ignore[return-value]

    def emit(self, line: str) -> None:
        self.lines.append(line)

    def anew(self, stem: str) -> str:
        """A name that nothing has yet."""
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
        """An equation from a lemma for `ring` and `field`."""
        name = self.anew("e")
        self.emit(f"pose proof {proof} as {name}.")
        self.hints.append(name)

    def prove_aside(self, formula: Formula, stem: str, by: str) -> str:
        """An auxiliary fact with a proof of one line; its name."""
        name = self.anew(stem)
        self.emit(f"assert ({name} : {spelled(formula)}) by ({by}).")
        return name

    def assume(self, formula: Formula, reference: Reference | None = None) -> str:
        """Takes in an assumption, part by part; the pattern that takes it apart in Coq."""
        return self._pattern(self.full(formula), reference)

    def _pattern(self, formula: Formula, reference: Reference | None = None) -> str:
        if isinstance(formula, Connective) and formula.tag == "and":
            return pattern([self._pattern(part) for part in formula.formulas])
        name = self.anew("h")
        self.learn(formula, name, reference)
        return name

    def learn(self, formula: Formula, name: str, reference: Reference | None = None) -> None:
        self.known[reference or ("here", len(self.known) - self.hypotheses)] = Known(formula, name)

    def turn_orders(self) -> None:
        """An assumption a >= b is turned round: 0 <= a - b is what is used of it."""
        for known in self.known.values():
            line = f"apply Rge_le in {known.hypothesis}."
            if known.formula.tag == ">=" and line not in self.lines:
                self.emit(line)

    def facts(self, *signs: str) -> Iterator[Known]:
        """The facts with these signs."""
        return (known for known in self.known.values() if known.sign in signs)

    def fact(self, data: JSON, signs: Iterable[str]) -> Known:
        """The fact that a proof refers to."""
        known = self.known.get(reference(data))
        if known is None or known.sign not in signs:
            raise NotExported(f"the assumption {data}")
        return known

    @contextmanager
    def inside(self) -> Iterator[None]:
        """Braces around a subgoal; what is learned in it is forgotten afterwards."""
        kept = dict(self.known), dict(self.nonzero), list(self.hints), set(self.scope), set(self.settled)
        self.emit("{")
        yield
        self.emit("}")
        self.known, self.nonzero, self.hints, self.scope, self.settled = kept


def pattern(parts: list[str]) -> str:
    """The pattern that takes a conjunction apart."""
    *front, last = parts or ["_"]
    return f"[{' ['.join(front)} {last}{']' * len(front)}" if front else last
