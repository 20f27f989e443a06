"""Which of two true statements says more, shown by proofs that the checker accepts; what is not shown is left open."""

from __future__ import annotations

from dataclasses import replace

from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Problem
from symcheck.core.terms import Connective, Formula, Quantified, Relation, Term, Value, node
from symcheck.proof import equivalent, proof_of
from symcheck.selftest.evidence import is_proved
from symcheck.selftest.trial import Status

MIRROR = {">": "<", ">=": "<="}
IMPLIED = {"=": ("<=",), "<": ("<=", "!=")}  # signs between the same sides
ARITHMETIC = ("+", "-", "*", "/", "^")
TRUE_OF_EQUALS = ("=", "<=", ">=")


def compared(before: Formula, after: Formula, problem: Problem) -> Status:
    """What a true statement is in the place of another true one, under the hypotheses of a problem."""
    less, more = (Strength(problem).entails(*pair) for pair in ((before, after), (after, before)))
    if less and more:
        return Status.EQUIVALENT
    return Status.WEAKER if less else Status.STRONGER if more else Status.OPEN


class Strength:
    """Entailment by form, down to relations.

    A relation that is asserted holds, so that under the hypotheses any other one entails it: its strength is judged
    by what is printed, its sign and its sides. Equations, and equivalences, that hold in each other's place say the
    same, but an equation of something with itself says nothing.
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
        return self._by_form(f, g, asserted) or self._is_proved(node("=>", f, g))

    def _by_form(self, f: Formula, g: Formula, asserted: bool) -> bool:
        if asserted and "and" in (f.tag, g.tag):
            return self._parts(conjuncts(f), conjuncts(g))
        if g.tag == "and":
            return all(self.entails(f, part, False) for part in g.formulas)
        if f.tag == "and":
            return any(self.entails(part, g, False) for part in f.formulas)
        if f.tag == g.tag == "or":
            return all(any(self.entails(p, q, False) for q in g.formulas) for p in f.formulas)
        if g.tag == "or":
            return any(self.entails(f, part, False) for part in g.formulas)
        return self._directed(f, g, asserted)

    def _parts(self, f: list[Formula], g: list[Formula]) -> bool:
        """Part by part, where as many are asserted; else each is one of the others, or follows from its sign."""
        if len(f) == len(g):
            return all(self.entails(*pair) for pair in zip(f, g, strict=True))
        return all(any(part == other or _is_implied(other, part) for other in f) for part in g)

    def _directed(self, f: Formula, g: Formula, asserted: bool) -> bool:
        if f.tag == g.tag == "<=>":
            pairs = [*zip(f.formulas, g.formulas, strict=True)]
            return asserted or all(self.entails(p, q, False) and self.entails(q, p, False) for p, q in pairs)
        if f.tag == "<=>":
            return any(self.entails(direction, g, asserted) for direction in _directions(f))
        if g.tag == "<=>":
            return False
        if f.tag == g.tag == "=>":
            (given, shown), (supposed, wanted) = f.formulas, g.formulas
            return self.entails(supposed, given, False) and self.entails(shown, wanted, False)
        if isinstance(f, Quantified) and isinstance(g, Quantified):
            return f.tag == g.tag and f.bound == g.bound and self.entails(f.body, g.body, False)
        if isinstance(f, Relation) and isinstance(g, Relation):
            return self._relations(f, g, asserted)
        return False

    def _relations(self, f: Relation, g: Relation, asserted: bool) -> bool:
        """Without the hypotheses only the signs between the same sides are compared, or two bounds of the same."""
        if not asserted:
            return False
        if f.tag == g.tag == "=":
            return True
        if _is_implied(f, g):
            return True
        (sign, left, right), (other, low, high) = _smaller_first(f), _smaller_first(g)
        if sign[0] == other[0] == "<" and (sign == "<" or other == "<="):
            if left == low:
                return self._is_proved(node("<=", right, high))
            if right == high:
                return self._is_proved(node("<=", low, left))
        return False

    def _is_proved(self, claim: Formula) -> bool:
        """Whether something follows from the hypotheses."""
        problem = replace(self.problem, claim=claim)
        return is_proved(problem, proof_of(problem))


def _is_implied(f: Formula, g: Formula) -> bool:
    """Whether a relation follows from another one with the same sides by their signs."""
    if not (isinstance(f, Relation) and isinstance(g, Relation)):
        return False
    (sign, *own), (other, *sides) = _smaller_first(f), _smaller_first(g)
    return other in IMPLIED.get(sign, ()) and (own == sides or (sign == "=" and own[::-1] == sides))


def same(f: Formula, g: Formula, problem: Problem) -> bool:
    """Whether two statements are the same by algebra: equations under the hypotheses, orders without them."""
    if f == g:
        return True
    if f.tag == g.tag == "and" and len(f) == len(g):
        return all(same(*pair, problem) for pair in zip(f.formulas, g.formulas, strict=True))
    if is_empty(f) is not is_empty(g):
        return False
    alone = isinstance(f, Relation) and f.tag != "="
    return equivalent(f, g, replace(problem, hypotheses=()) if alone else problem)


def is_empty(formula: Formula) -> bool:
    """Whether a relation says of something that it is what it is, or compares two numbers that are written out."""
    match formula:
        case Connective(tag="and", formulas=parts):
            return all(map(is_empty, parts))
        case Relation(tag=sign, terms=(left, right)):
            return (sign in TRUE_OF_EQUALS and left == right) or all(map(_is_written_out, (left, right)))
    return False


def _is_written_out(term: Term) -> bool:
    if isinstance(term, Value):
        return term.tag in ARITHMETIC and all(map(_is_written_out, term.terms))
    return isinstance(term, int)


def _directions(f: Formula) -> tuple[Formula, Formula]:
    left, right = f.formulas
    return node("=>", left, right), node("=>", right, left)


def _smaller_first(f: Relation) -> tuple[str, Term, Term]:
    left, right = f.terms
    return (MIRROR[f.tag], right, left) if f.tag in MIRROR else (f.tag, left, right)
