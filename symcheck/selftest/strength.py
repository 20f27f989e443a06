"""Which of two true statements says more, shown by proofs that the checker accepts; what is not shown is left open."""

from __future__ import annotations

from dataclasses import replace

from symcheck.proof import equivalent, proof_of
from symcheck.proof.theorems import RELATIONS
from symcheck.selftest.evidence import is_shown
from symcheck.selftest.trial import Fate
from symcheck.statement import Formula, Problem

MIRROR = {">": "<", ">=": "<="}
IMPLIED = {"=": ("<=",), "<": ("<=", "!=")}  # signs between the same sides
TRUE_OF_EQUALS = ("=", "<=", ">=")


def compared(before: Formula, after: Formula, problem: Problem) -> Fate:
    """What a true statement is in the place of another true one, under the hypotheses of a problem."""
    less, more = (Strength(problem).entails(*pair) for pair in ((before, after), (after, before)))
    if less and more:
        return Fate.EQUIVALENT
    return Fate.WEAKER if less else Fate.STRONGER if more else Fate.OPEN


class Strength:
    """Entailment by form, down to relations.

    A relation that is asserted holds, so that under the hypotheses any other one entails it: its strength is told by
    what is printed, its sign and its sides. Equations, and equivalences, that hold in each other's place say as much,
    but an equation of something with itself says nothing.
    """

    def __init__(self, problem: Problem) -> None:
        self.problem = problem

    def entails(self, f: Formula, g: Formula, asserted: bool = True) -> bool:
        """Whether the first is shown to say no less than the second."""
        if f == g or is_empty(g):
            return True
        if is_empty(f):
            return False
        if (not asserted or idle(f) == idle(g)) and self._same(f, g):
            return True
        if asserted:
            return self._by_form(f, g, asserted)
        return self._by_form(f, g, asserted) or self._shown(("=>", f, g))

    def _by_form(self, f: Formula, g: Formula, asserted: bool) -> bool:
        if g[0] == "and":
            return all(self.entails(f, part, asserted) for part in g[1:])
        if f[0] == "and":
            return any(self.entails(part, g, asserted) for part in f[1:])
        if f[0] == "or" and g[0] == "or":
            return all(any(self.entails(p, q, False) for q in g[1:]) for p in f[1:])
        if g[0] == "or":
            return any(self.entails(f, part, False) for part in g[1:])
        return self._directed(f, g, asserted)

    def _directed(self, f: Formula, g: Formula, asserted: bool) -> bool:
        if f[0] == "<=>" and g[0] == "<=>":
            pairs = [*zip(f[1:], g[1:], strict=True)]
            return asserted or all(self.entails(p, q, False) and self.entails(q, p, False) for p, q in pairs)
        if f[0] == "<=>":
            return any(self.entails(each, g, asserted) for each in _directions(f))
        if g[0] == "<=>":
            return False
        if f[0] == g[0] == "=>":
            return self.entails(g[1], f[1], False) and self.entails(f[2], g[2], False)
        if f[0] == g[0] == "exists":
            return f[1] == g[1] and self.entails(f[2], g[2], False)
        if f[0] in RELATIONS and g[0] in RELATIONS:
            return self._relations(f, g, asserted)
        return False

    def _relations(self, f: Formula, g: Formula, asserted: bool) -> bool:
        """Without the hypotheses only the signs between the same sides are compared, or two bounds of the same."""
        if not asserted:
            return False
        if f[0] == g[0] == "=":
            return True
        one, two = _smaller_first(f), _smaller_first(g)
        if two[0] in IMPLIED.get(one[0], ()) and (one[1:] == two[1:] or (one[0] == "=" and one[:0:-1] == two[1:])):
            return True
        if one[0][0] == "<" and two[0][0] == "<" and (one[0] == "<" or two[0] == "<="):
            if one[1] == two[1]:
                return self._shown(("<=", one[2], two[2]))
            if one[2] == two[2]:
                return self._shown(("<=", two[1], one[1]))
        return False

    def _same(self, f: Formula, g: Formula) -> bool:
        return equivalent(f, g, replace(self.problem, claim=("and", f, g)))

    def _shown(self, claim: Formula) -> bool:
        """Whether something follows from the hypotheses."""
        problem = replace(self.problem, claim=claim)
        return is_shown(problem, proof_of(problem))


def is_empty(formula: Formula) -> bool:
    """Whether a relation says of something that it is what it is."""
    return formula[0] in TRUE_OF_EQUALS and formula[1] == formula[2]


def idle(formula: Formula) -> int:
    """How many relations of a statement, taken apart at "and", are empty."""
    return sum(map(idle, formula[1:])) if formula[0] == "and" else int(is_empty(formula))


def _directions(f: Formula) -> tuple[Formula, Formula]:
    return ("=>", f[1], f[2]), ("=>", f[2], f[1])


def _smaller_first(f: Formula) -> Formula:
    return (MIRROR[f[0]], f[2], f[1]) if f[0] in MIRROR else f
