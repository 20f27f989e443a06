"""What is known at one place of a proof: equalities, things that are not zero, signs, open disjunctions.

References name where each came from, the way the checker names them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Form, Problem, Witness
from symcheck.core.terms import RELATIONS, Formula, Node, Term, node
from symcheck.proof.ideal import Fact, Ideal, Ref
from symcheck.proof.polynomial import Poly, Ring, fraction, unfold, variables

MIRROR = {"<": ">", "<=": ">="}
Given = frozenset[tuple[str, int]]
NOTHING: Given = frozenset()


class Cleared(list[Any]):
    """The reference of an equation with denominators: the polynomial that stands for it is multiplied with them."""

    def __init__(self, ref: Ref, den: Mapping[str, tuple[Poly, int]]) -> None:
        super().__init__(ref)
        self.den = [text for text, (_, exponent) in den.items() for _ in range(exponent)]


@dataclass(frozen=True)
class Sign:
    """A term known to be >= 0 (level 1) or > 0 (level 2), as it stands and as a polynomial."""

    ref: Ref
    term: Term
    level: int
    poly: Poly


@dataclass(frozen=True)
class Knowledge:
    """The assumptions at one place of a proof; `assume` and `with_fact` give enlarged copies."""

    ring: Ring
    facts: tuple[Fact, ...] = ()
    conditions: tuple[Fact, ...] = ()
    signs: tuple[Sign, ...] = ()
    fractions: tuple[Sign, ...] = ()  # those of terms with denominators
    pending: tuple[tuple[Ref, Formula], ...] = ()
    count: int = 0

    def ideal(self, pairs: int = 2000) -> Ideal:
        """The ideal of all facts and of the relations of sines, cosines and roots."""
        memory, key = self.ring.memory, ("ideal", tuple(map(id, self.facts)), pairs)
        if key not in memory:  # the facts are kept beside the answer so that the ids stay their own
            memory[key] = self.facts, Ideal(self.ring, [*self.ring.axioms(), *self.facts], pairs)
        found: Ideal = memory[key][1]
        return found

    def learn(self, ref: Ref, formula: Formula) -> Knowledge:
        """One more assumption, not a conjunction."""
        if formula[0] == "or":
            return replace(self, pending=(*self.pending, (ref, formula)))
        if formula[0] not in RELATIONS:
            return self
        sign, left, right = formula
        if sign in MIRROR:
            sign, left, right = MIRROR[sign], right, left
        gap = self.ring.subtract(left, right)
        known = self
        if sign == "=" and all(gap.num != axiom for _, axiom in self.ring.axioms()):
            known = replace(known, facts=(*known.facts, (Cleared(ref, gap.den) if gap.den else ref, gap.num)))
        if sign in ("!=", ">") and not gap.den:
            known = replace(known, conditions=(*known.conditions, (ref, gap.num)))
        if sign in (">", ">="):
            term = left if right == 0 else node("+", left, node("-", right))
            one = Sign(ref, term, 1 + (sign == ">"), gap.num)
            known = (
                replace(known, fractions=(*known.fractions, one))
                if gap.den
                else replace(known, signs=(*known.signs, one))
            )
        return known

    def assume(self, formula: Formula) -> Knowledge:
        """The conjuncts of a formula, numbered in order."""
        known = self
        for part in conjuncts(formula):
            known = replace(known.learn(["here", known.count], part), count=known.count + 1)
        return known

    def with_fact(self, poly: Poly) -> Knowledge:
        """One more polynomial that is zero."""
        return replace(self, facts=(*self.facts, (["here", self.count], poly)), count=self.count + 1)

    def sign(self, term: Term) -> tuple[int, Given]:
        """(2 if manifestly positive, 1 if manifestly not negative, else 0; the hypotheses that say so)."""
        if isinstance(term, int):
            return (0 if term < 0 else 1 + (term > 0)), NOTHING
        level, given = self._sign_of_operation(term) if isinstance(term, tuple) else (0, NOTHING)
        if not level:
            level, given = self._bound(term)
        if not level and isinstance(term, str) and term in self.ring.definitions:
            return self.sign(self.ring.definitions[term])
        return level, given

    def _sign_of_operation(self, term: tuple[object, ...]) -> tuple[int, Given]:
        kind, rest = term[0], term[1:]
        parts: list[tuple[int, Given]]
        if kind == "+":
            parts = [self.sign(t) for t in rest]  # type: ignore[arg-type]
            level = max(p[0] for p in parts) if all(p[0] for p in parts) else 0
            return level, NOTHING.union(*(p[1] for p in parts))
        if kind == "*":
            odd: list[object] = []
            for t in rest:
                if t in odd:
                    odd.remove(t)
                else:
                    odd.append(t)
            parts = [self.sign(t) for t in odd]  # type: ignore[arg-type]
            paired = 1 if len(odd) < len(rest) else 2
            return min([paired, *(p[0] for p in parts)]), NOTHING.union(*(p[1] for p in parts))
        if kind == "/":
            (a, first), (b, second) = (self.sign(t) for t in rest)  # type: ignore[arg-type]
            return min(a, 2 * bool(b)), first | second
        if kind == "^" and isinstance(rest[1], int) and rest[1] > 0:
            level, given = self.sign(rest[0])  # type: ignore[arg-type]
            return (level, given) if level else (int(rest[1] % 2 == 0), NOTHING)
        return 0, NOTHING

    def _bound(self, term: Term) -> tuple[int, Given]:
        """The sign of something assumed to be >= 0."""
        if not self.signs and not self.fractions:
            return 0, NOTHING
        gap = self.ring.ratio(term)
        for sign in self.fractions if gap.den else self.signs:
            if gap.num == sign.poly and (not gap.den or gap.den == self.ring.ratio(sign.term).den):
                if _is_number(term) and (gap.num == 0 or fraction(gap.num.leading_coefficient()) > 0):
                    return 1 + (gap.num != 0), NOTHING  # a number needs no hypothesis
                return sign.level, given_of([sign.ref])
        return 0, NOTHING

    def nonzero(self, poly: Poly) -> list[Ref] | None:
        """References to conditions whose product is a multiple of the polynomial, or None."""
        if poly.is_constant():
            return [] if poly != 0 else None
        for ref, condition in self.conditions:
            if proportional(poly, condition) is not None:
                return [ref]
        return None


def _is_number(term: Term) -> bool:
    """Whether a term is made of whole numbers alone."""
    if not isinstance(term, Node):
        return isinstance(term, int)
    return term.tag in ("+", "*", "-", "/", "^") and all(map(_is_number, term.outside))


def given_of(refs: Iterable[Ref]) -> Given:
    """The hypotheses among references."""
    return frozenset((ref[1], ref[2]) for ref in refs if ref[0] == "hyp")


def proportional(a: Poly, b: Poly) -> Fraction | None:
    """The number f with a = f * b, if there is one."""
    if len(a) != len(b) or not len(a) or a.monomial(0) != b.monomial(0):
        return None
    factor = a.leading_coefficient() / b.leading_coefficient()
    return fraction(factor) if a == b * factor else None


def hints_of(problem: Problem) -> list[Term]:
    """The hinted terms (forms) of a problem, in order."""
    return [hint.sum for hint in problem.hints if isinstance(hint, Form)]


def ring_of(problem: Problem) -> Ring:
    """The ring of everything the problem mentions."""
    definitions = dict(problem.definitions)
    nodes = [
        problem.claim,
        *(f for _, formulas in problem.hypotheses for f in formulas),
        *(term for hint in problem.hints if isinstance(hint, Form | Witness) for term in hint.terms),
    ]
    names: set[str] = set()
    for tree in nodes:
        names |= variables(unfold(tree, definitions))
    return Ring(names, definitions)


def starting(problem: Problem, ring: Ring, names: Sequence[str] | None = None) -> Knowledge:
    """What the hypotheses (all, or the named ones) say."""
    known = Knowledge(ring)
    for name, formulas in problem.hypotheses:
        if names is None or name in names:
            for k, formula in enumerate(part for f in formulas for part in conjuncts(f)):
                known = known.learn(["hyp", name, k], formula)
    return known
