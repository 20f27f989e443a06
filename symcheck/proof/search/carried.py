"""Proofs carried over: of a statement about some quantities to the same statement about multiples of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from symcheck.core.calculus import substituted
from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Form, Outcome, Problem
from symcheck.core.terms import RELATIONS, Formula, Term, node
from symcheck.proof.algebra.facts import Assumed, Hypothesis, Reference
from symcheck.proof.algebra.flint import fraction
from symcheck.proof.algebra.forms import term_of
from symcheck.proof.algebra.knowledge import ORDERS, ring_of
from symcheck.proof.algebra.polynomial import alone
from symcheck.proof.rules.each import Each
from symcheck.proof.rules.have import Have
from symcheck.proof.rules.implies import Implies
from symcheck.proof.rules.proof import Proof
from symcheck.proof.rules.step import Step, Whole, mentioned
from symcheck.proof.search.decide import prove, proved
from symcheck.proof.search.methods import LIMITS, find_witnesses

GIVEN = "what was proved, or is assumed"


def carried(proof: Proof, stated: Problem, mean: Mapping[str, Term], wanted: Problem) -> Outcome | None:
    """The proof of one statement as a proof of another, which says the same of other terms.

    Parameters
    ----------
    proof
        The proof of what is stated.
    stated
        The statement that has this proof.
    mean
        What letters of the statement stand for, in letters of the one that is wanted. Its hypotheses with this put in
        are those of the wanted one; its claim is so up to factors of both sides of relations.
    wanted
        The statement to prove.

    Returns
    -------
    Outcome or None
        The proof; None if the claims have different forms, or a relation does not follow from that put in its place.
        It is checked as all others are.
    """
    meant, now = dict(mean), dict(wanted.definitions)
    for name, term in stated.definitions:
        if now.get(name) != term:  # it stands for something else there, so that what it stood for is written out
            meant[name] = substituted(term, meant)
    whole = proof.step if isinstance(proof.step, Whole) else Whole(proof.step)
    with alone(wanted):
        try:
            nonzero = dict.fromkeys(substituted(term, meant) for term in proof.nonzero)
            carrier = _Carrier(wanted, meant, whole, nonzero)
            step = carrier.carry(stated.claim, whole.step, wanted.claim, 0)
            mentioned(step or whole, now)  # a theorem may say nothing of the other terms
        except LIMITS:
            return None
    if step is None:
        return None
    divisors = tuple(carrier.nonzero)
    points = find_witnesses(wanted, divisors)
    if points is None:
        return None
    return proved(wanted, Proof(Whole(step), proof.given | frozenset(carrier.given), divisors, tuple(points)))


@dataclass
class _Carrier:
    """Carries the parts of a proof; `given` are hypotheses that are used besides, `nonzero` what is divided by."""

    wanted: Problem
    mean: Mapping[str, Term]
    whole: Whole
    nonzero: dict[Term, None]
    given: set[Hypothesis] = field(default_factory=set)

    def carry(self, stated: Formula, proof: Step, goal: Formula, depth: int) -> Step | None:
        """The proof of a goal where so many facts are assumed, to which the proof of what is stated refers."""
        about = substituted(stated, self.mean)
        if about == goal:
            return self._about(proof)
        if stated.tag != goal.tag:
            return None
        match proof:
            case Each(parts):
                return self._each(_directions(stated), parts, _directions(goal), depth)
            case Implies(then) if stated.tag == "=>":
                return self._implication(stated, then, goal, depth)
        facts, goals = conjuncts(about), conjuncts(goal)
        if any(fact.tag not in RELATIONS for fact in facts):
            return None
        pairs = enumerate(zip(facts, goals, strict=True), depth)
        found = [self._follows(fact, number, part, depth + len(facts)) for number, (fact, part) in pairs]
        if (proofs := _all(found)) is None:
            return None
        return Have(about, self._about(proof), Each(proofs) if goal.tag == "and" else proofs[0])

    def _about(self, proof: Step) -> Whole:
        """A part of the proof, about the other terms."""
        return Whole(proof, self.whole.atoms, self.whole.positive).at(self.mean)

    def _each(
        self, stated: Sequence[Formula], parts: Sequence[Step], goals: Sequence[Formula], depth: int
    ) -> Each | None:
        """Part by part."""
        every = zip(stated, parts, goals, strict=True)
        proofs = _all([self.carry(part, proof, goal, depth) for part, proof, goal in every])
        return None if proofs is None else Each(proofs)

    def _implication(self, stated: Formula, then: Step, goal: Formula, depth: int) -> Implies | None:
        """Under the premises of the goal those of the statement hold; from these its proof goes on."""
        (before, after), (premise, conclusion) = stated.formulas, goal.formulas
        premises, wanted = conjuncts(premise), [substituted(part, self.mean) for part in conjuncts(before)]
        count = len(premises)
        step = self.carry(after, then.shifted(count, depth), conclusion, depth + 2 * count)
        for k, (fact, part) in reversed([*enumerate(zip(premises, wanted, strict=True))]):
            own = self._follows(fact, depth + k, part, depth + count + k)
            if step is None or own is None:
                return None
            step = Have(part, own, step)
        return None if step is None else Implies(step)

    def _follows(self, fact: Formula, number: int, goal: Formula, depth: int) -> Step | None:
        """The proof of a relation from the fact with a number, where so many are assumed."""
        given = (*self.wanted.hypotheses, (GIVEN, (fact,)))
        problem = Problem("", goal, self.wanted.definitions, given)
        proof = prove(replace(problem, hints=_multiple(problem, fact)))
        if proof is None:
            return None
        self.nonzero |= dict.fromkeys(proof.nonzero)
        self.given |= {hypothesis for hypothesis in proof.given if hypothesis.name != GIVEN}

        def change(ref: Reference) -> Reference:
            match ref:
                case Hypothesis(name, _) if name == GIVEN:
                    return Assumed(number)
                case Assumed(k):
                    return Assumed(depth + k)
            return ref

        return proof.step.mapped(change)


def _all(found: Sequence[Step | None]) -> tuple[Step, ...] | None:
    """The proofs, if none is missing."""
    proofs = tuple(step for step in found if step is not None)
    return proofs if len(proofs) == len(found) else None


def _multiple(problem: Problem, fact: Formula) -> tuple[Form[Term], ...]:
    """For an order: its difference as that of the fact, times what one is of the other."""
    if fact.tag not in ORDERS:
        return ()
    ring = ring_of(problem)
    gap, goal = (node("+", large, node("-", small)) for small, large in map(_ordered, (fact, problem.claim)))
    known, wanted = ring.ratio(gap), ring.ratio(goal)
    above, below = wanted.num * known.bottom(), known.num * wanted.bottom()
    common = above.gcd(below)
    if common == 0:
        return ()
    top, bottom = divmod(above, common)[0], divmod(below, common)[0]
    if fraction(bottom.leading_coefficient()) < 0:
        top, bottom = -top, -bottom
    factor = node("/", term_of(top), term_of(bottom))
    return (Form(node("*", factor, gap)),)


def _ordered(order: Formula) -> tuple[Term, Term]:
    """The smaller side, and the larger one."""
    left, right = order.terms
    return (left, right) if order.tag[0] == "<" else (right, left)


def _directions(formula: Formula) -> tuple[Formula, ...]:
    """The parts of a conjunction, both directions of an equivalence."""
    if formula.tag == "<=>":
        return node("=>", *formula.formulas), node("=>", *formula.formulas[::-1])
    return formula.formulas
