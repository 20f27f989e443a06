"""Which of two true statements says more, shown by proofs that the checker accepts; what is not shown is left open."""

from __future__ import annotations

from dataclasses import replace

from symcheck.proof import equivalent, proof_of
from symcheck.proof.theorems import RELATIONS, conjuncts
from symcheck.selftest.evidence import is_shown
from symcheck.selftest.trial import Fate
from symcheck.statement import Formula, Problem, Term

MIRROR = {">": "<", ">=": "<="}
IMPLIED = {"=": ("<=",), "<": ("<=", "!=")}  # signs between the same sides
ARITHMETIC = ("+", "-", "*", "/", "^")
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
        if same(f, g, self.problem) if asserted else equivalent(f, g, self.problem):
            return True
        if asserted:
            return self._by_form(f, g, asserted)
        return self._by_form(f, g, asserted) or self._shown(("=>", f, g))

    def _by_form(self, f: Formula, g: Formula, asserted: bool) -> bool:
        if asserted and (f[0] == "and" or g[0] == "and"):
            return self._parts(conjuncts(f), conjuncts(g))
        if g[0] == "and":
            return all(self.entails(f, part, False) for part in g[1:])
        if f[0] == "and":
            return any(self.entails(part, g, False) for part in f[1:])
        if f[0] == "or" and g[0] == "or":
            return all(any(self.entails(p, q, False) for q in g[1:]) for p in f[1:])
        if g[0] == "or":
            return any(self.entails(f, part, False) for part in g[1:])
        return self._directed(f, g, asserted)

    def _parts(self, f: list[Formula], g: list[Formula]) -> bool:
        """Part by part, where as many are asserted; else each is one of the others, or follows from its sign."""
        if len(f) == len(g):
            return all(self.entails(*pair) for pair in zip(f, g, strict=True))
        return all(any(part == other or _is_implied(other, part) for other in f) for part in g)

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
        if _is_implied(f, g):
            return True
        one, two = _smaller_first(f), _smaller_first(g)
        if one[0][0] == "<" and two[0][0] == "<" and (one[0] == "<" or two[0] == "<="):
            if one[1] == two[1]:
                return self._shown(("<=", one[2], two[2]))
            if one[2] == two[2]:
                return self._shown(("<=", two[1], one[1]))
        return False

    def _shown(self, claim: Formula) -> bool:
        """Whether something follows from the hypotheses."""
        problem = replace(self.problem, claim=claim)
        return is_shown(problem, proof_of(problem))


def _is_implied(f: Formula, g: Formula) -> bool:
    """Whether a relation follows from another one with the same sides by their signs."""
    one, two = _smaller_first(f), _smaller_first(g)
    return two[0] in IMPLIED.get(one[0], ()) and (one[1:] == two[1:] or (one[0] == "=" and one[:0:-1] == two[1:]))


def same(f: Formula, g: Formula, problem: Problem) -> bool:
    """Whether two statements are the same by algebra: equations under the hypotheses, orders without them."""
    if f == g:
        return True
    if f[0] == g[0] == "and" and len(f) == len(g):
        return all(same(*pair, problem) for pair in zip(f[1:], g[1:], strict=True))
    if is_empty(f) is not is_empty(g):
        return False
    alone = f[0] in RELATIONS and f[0] != "="
    return equivalent(f, g, replace(problem, hypotheses=()) if alone else problem)


def is_empty(formula: Formula) -> bool:
    """Whether a relation says of something that it is what it is, or compares two numbers that are written out."""
    if formula[0] == "and":
        return all(map(is_empty, formula[1:]))
    return (formula[0] in TRUE_OF_EQUALS and formula[1] == formula[2]) or (
        formula[0] in RELATIONS and all(map(_is_written_out, formula[1:]))
    )


def _is_written_out(term: Term) -> bool:
    if isinstance(term, tuple):
        return term[0] in ARITHMETIC and all(map(_is_written_out, term[1:]))
    return isinstance(term, int)


def _directions(f: Formula) -> tuple[Formula, Formula]:
    return ("=>", f[1], f[2]), ("=>", f[2], f[1])


def _smaller_first(f: Formula) -> Formula:
    return (MIRROR[f[0]], f[2], f[1]) if f[0] in MIRROR else f
