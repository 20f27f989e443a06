"""What is known at one place of a proof: equalities, things that are not zero, signs, open disjunctions.

References name where each came from, the way the checker names them.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Form, Problem, Witness
from symcheck.core.terms import RELATIONS, Formula, Node, Term, Value, node
from symcheck.proof.algebra.facts import NOTHING, Assumed, Fact, Grounds, Hypothesis, Reference, by_construction
from symcheck.proof.algebra.flint import Poly, fraction
from symcheck.proof.algebra.ideal import Ideal
from symcheck.proof.algebra.polynomial import Ring, unfold, variables
from symcheck.proof.algebra.variables import table

ORDERS = ("<", "<=", ">", ">=")


@dataclass(frozen=True)
class Sign:
    """A term known to be >= 0 (level 1) or > 0 (level 2), as it stands and as a polynomial."""

    ref: Reference
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
    pending: tuple[tuple[Reference, Formula], ...] = ()
    count: int = 0

    def ideal(self) -> Ideal:
        """The ideal of all facts and of the relations of sines, cosines and roots."""
        key = "ideal", tuple(map(id, self.facts))
        return self.ring.remembered(key, self._ideal, self.facts)

    def _ideal(self) -> Ideal:
        return Ideal(self.ring, [*by_construction(self.ring), *self.facts])

    def learn(self, ref: Reference, formula: Formula) -> Knowledge:
        """One more assumption, not a conjunction."""
        if formula[0] == "or":
            return replace(self, pending=(*self.pending, (ref, formula)))
        if formula[0] not in RELATIONS:
            return self
        sign, left, right = larger_first(formula)
        gap = self.ring.subtract(left, right)
        known = self
        if sign == "=" and gap.num not in self.ring.axioms().values():
            equation = gap.reduced()
            known = replace(known, facts=(*known.facts, (replace(ref, cleared=equation.divisors()), equation.num)))
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
            known = replace(known.learn(Assumed(known.count), part), count=known.count + 1)
        return known

    def with_fact(self, poly: Poly) -> Knowledge:
        """One more polynomial that is zero."""
        return replace(self, facts=(*self.facts, (Assumed(self.count), poly)), count=self.count + 1)

    def sign(self, term: Term) -> tuple[int, Grounds]:
        """(2 if manifestly positive, 1 if manifestly not negative, else 0; the hypotheses that say so)."""
        if isinstance(term, int):
            return (0 if term < 0 else 1 + (term > 0)), NOTHING
        level, given = self._sign_of_value(term) if isinstance(term, Value) else (0, NOTHING)
        if not level:
            level, given = self._bound(term)
        if not level and isinstance(term, str) and term in self.ring.definitions:
            return self.sign(self.ring.definitions[term])
        return level, given

    def _sign_of_value(self, term: Value) -> tuple[int, Grounds]:
        kind, parts = term.tag, term.terms
        match kind, parts:
            case (("exp" | "pi"), _):
                return 2, NOTHING
            case "+", _:
                signs = [self.sign(t) for t in parts]
                level = max(sign for sign, _ in signs) if all(sign for sign, _ in signs) else 0
                return level, NOTHING.union(*(grounds for _, grounds in signs))
            case "*", _:
                single: list[Term] = []  # equal factors pair up to squares
                for t in parts:
                    (single.remove if t in single else single.append)(t)
                signs = [self.sign(t) for t in single]
                paired = 1 if len(single) < len(parts) else 2
                return min([paired, *(sign for sign, _ in signs)]), NOTHING.union(*(grounds for _, grounds in signs))
            case "/", (top, bottom):
                (above, first), (below, second) = self.sign(top), self.sign(bottom)
                return min(above, 2 * bool(below)), first | second
            case "^", (base, int(exponent)) if exponent > 0:
                level, grounds = self.sign(base)
                if level or exponent % 2:
                    return level, grounds
                value = self.ring.ratio(base)
                refs = None if value.den else self.nonzero(value.num)
                return (1, NOTHING) if refs is None else (2, hypotheses_of(refs))
        return 0, NOTHING

    def _bound(self, term: Term) -> tuple[int, Grounds]:
        """The sign of something assumed to be >= 0."""
        if not self.signs and not self.fractions:
            return 0, NOTHING
        gap = self.ring.ratio(term)
        for sign in self.fractions if gap.den else self.signs:
            if gap.num == sign.poly and (not gap.den or gap.den == self.ring.ratio(sign.term).den):
                if _is_number(term) and (gap.num == 0 or fraction(gap.num.leading_coefficient()) > 0):
                    return 1 + (gap.num != 0), NOTHING  # a number needs no hypothesis
                return sign.level, hypotheses_of([sign.ref])
        return 0, NOTHING

    def nonzero(self, poly: Poly) -> list[Reference] | None:
        """A reference to a condition that the polynomial is a multiple of, none for a number; None if there is none.

        Or to one that says that a number is positive of which the polynomial is the root.
        """
        if poly.is_constant():
            return [] if poly != 0 else None
        found = next(([ref] for ref, condition in self.conditions if proportional(poly, condition) is not None), None)
        return found or self._of_positive_root(poly)

    def _of_positive_root(self, poly: Poly) -> list[Reference] | None:
        names = [x for x, generator in self.ring.generator.items() if generator == poly] if len(poly) == 1 else []
        root = table().term(names[0]) if names else 0
        if not (isinstance(root, Value) and root.tag == "sqrt") or not variables(root.terms[0]) <= {*self.ring.names}:
            return None
        inner = self.ring.ratio(root.terms[0])
        return next(([s.ref] for s in self.signs if s.level == 2 and not inner.den and s.poly == inner.num), None)


def larger_first(relation: Formula) -> Formula:
    """An order with its larger side first; other relations as they are."""
    mirrored = {"<": ">", "<=": ">="}.get(relation.tag)
    return node(mirrored, *relation.terms[::-1]) if mirrored else relation


def _is_number(term: Term) -> bool:
    """Whether a term is made of whole numbers alone."""
    if not isinstance(term, Node):
        return isinstance(term, int)
    return term.tag in ("+", "*", "-", "/", "^") and all(map(_is_number, term.outside))


def hypotheses_of(refs: Iterable[Reference]) -> Grounds:
    """The hypotheses among references."""
    return frozenset(ref for ref in refs if isinstance(ref, Hypothesis))


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
    hinted = (term for hint in problem.hints if isinstance(hint, Form | Witness) for term in hint.terms)
    return Ring(variables(*(unfold(tree, definitions) for tree in (*formulas_of(problem), *hinted))), definitions)


def stated(problem: Problem) -> list[tuple[Hypothesis, Formula]]:
    """The conjuncts of every hypothesis, with their references."""
    parts = ((name, [part for f in formulas for part in conjuncts(f)]) for name, formulas in problem.hypotheses)
    return [(Hypothesis(name, k), formula) for name, formulas in parts for k, formula in enumerate(formulas)]


def formulas_of(problem: Problem) -> list[Formula]:
    """The claim, and the conjuncts of every hypothesis."""
    return [problem.claim, *(formula for _, formula in stated(problem))]


def starting(problem: Problem, ring: Ring, names: Sequence[str] | None = None) -> Knowledge:
    """What the hypotheses (all, or the named ones) say."""
    known = Knowledge(ring)
    for ref, formula in stated(problem):
        if names is None or ref.name in names:
            known = known.learn(ref, formula)
    return known
