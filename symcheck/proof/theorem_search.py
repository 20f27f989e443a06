"""Statements about functions, proved by theorems: those whose premises can be proved, then what follows from them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import Formula, Term, node
from symcheck.core.verdicts import Certificate
from symcheck.proof.applied import Instance, Theorem, applied, step, theorem_of
from symcheck.proof.closed import order_of_numbers
from symcheck.proof.equations import equations_here, identity_here
from symcheck.proof.functions import instances, simplified
from symcheck.proof.knowledge import Knowledge, ring_of, starting
from symcheck.proof.orders import positive_form, prove_order, term_of
from symcheck.proof.polynomial import (
    Ratio,
    Ring,
    fraction,
    unfold,
    variables,
    with_arguments,
)
from symcheck.proof.variables import Unsupported, atoms, prime

Prover = Callable[[Formula, Knowledge], Certificate | None]
MAX_INSTANCES = 40
MAX_CASES = 4


def has_functions(ring: Ring) -> bool:
    """Whether atoms are among the variables."""
    return any(name in atoms() for name in ring.names)


def prove_with_theorems(problem: Problem, prove_here: Prover) -> Certificate | None:
    """A proof of a statement about functions; `prove_here` finishes it when no theorem is left to apply."""
    plan = _Plan.of(problem)
    return _Search(prove_here, plan.inner).prove(problem.claim, plan.known, plan.outer)


def values_of(term: Term, numbers: Mapping[str, Term]) -> Iterator[Term]:
    """What a function may be where letters have these numbers; each is still to be proved."""
    assert isinstance(term, tuple)
    if term[0] == "diverges":
        yield from (0, 1)
        return
    plain = unfold(term, numbers)
    name = next(iter(variables(plain)))
    plan = _Plan.of(Problem("value", node("=", plain, 0)))
    known = _Search(lambda goal, known: None, plan.inner).all_known(plan.known, plan.outer)
    value = known.ideal().reduce(known.ring.generator[name])
    used = {n for n, degree in zip(known.ring.names, value.degrees(), strict=True) if degree} if value != 0 else set()
    if all(n == "pi" or prime(n) for n in used):
        yield term_of(value)


@dataclass
class _Plan:
    """The theorems about the functions of a statement: `outer` ones, and `inner` ones that speak of bound variables."""

    definitions: Mapping[str, Term]
    names: set[str]
    assumed: Knowledge
    outer: list[Instance] = field(default_factory=list)
    inner: list[Instance] = field(default_factory=list)
    known: Knowledge = field(init=False)

    @classmethod
    def of(cls, problem: Problem) -> _Plan:
        """All theorems that may help."""
        definitions, own = dict(problem.definitions), ring_of(problem)
        assumed = starting(problem, Ring(with_arguments(own.names), definitions))
        if problem.claim[0] == "=>":
            assumed = assumed.assume(problem.claim.formulas[0])
        plan = cls(definitions, set(own.names), assumed)
        for instance in _hinted(problem):
            plan._add(instance, plan.outer)
        plan._collect()
        for p in [p for p in map(prime, sorted(plan.names)) if p is not None]:
            plan._add(applied("root", p), plan.outer)
        if "pi" in plan.names:
            plan._add(applied("circle_number"), plan.outer)
        plan.known = starting(problem, Ring(plan.names, definitions))
        return plan

    def _collect(self) -> None:
        seen: set[str] = set()
        while fresh := sorted(name for name in self.names - seen if name in atoms()):
            seen |= set(fresh)
            bound = {x for name in seen for x in atoms()[name].bound}
            for instance in (i for name in fresh for i in self._instances(name)):
                about = variables(*instance.terms) if not instance.letter else set()
                kept = (
                    self.inner if with_arguments(about) & bound else self.outer
                )  # nothing is assumed of what is bound
                if instance not in kept and len(kept) < MAX_INSTANCES:
                    self._add(instance, kept)

    def _instances(self, name: str) -> Iterator[Instance]:
        yield from simplified(name, self.assumed)
        yield from instances(name, self.names)

    def _add(self, instance: Instance, kept: list[Instance]) -> None:
        try:
            theorem = theorem_of(instance, self.definitions)
            said = (unfold(formula, self.definitions) for formula in (*theorem.premises, theorem.conclusion))
            needed = set().union(*map(variables, said))
        except Unsupported:
            return
        kept.append(instance)
        self.names |= needed


def _hinted(problem: Problem) -> list[Instance]:
    """The theorems that the declaration names."""
    return [applied(hint.theorem, *hint.terms) for hint in problem.hints if isinstance(hint, Applied)]


@dataclass(frozen=True)
class _Search:
    prove_here: Prover
    inner: Sequence[Instance]

    def prove(
        self, goal: Formula, known: Knowledge, pending: Sequence[Instance], cases: int = MAX_CASES
    ) -> Certificate | None:
        """Assumptions first, then every theorem whose premises hold, then the goal itself, then a case more."""
        if goal.tag == "=>":
            then = self.prove(goal.formulas[1], known.assume(goal.formulas[0]), pending, cases)
            return None if then is None else {"rule": "implies", "then": then}
        if goal[0] == "<=>":
            ways = [node("=>", goal[1], goal[2]), node("=>", goal[2], goal[1])]
            parts = [self.prove(way, known, pending, cases) for way in ways]
            return None if None in parts else {"rule": "each", "parts": parts}
        for k, instance in enumerate(pending):
            theorem = _theorem(instance, known)
            premises = self._premises(theorem.premises, known)
            if premises is not None:
                then = self.prove(goal, known.assume(theorem.conclusion), [*pending[:k], *pending[k + 1 :]], cases)
                return None if then is None else step(instance, premises, then)
        found = equations_here(goal, known) or self.prove_here(goal, known)
        return found or (self._by_cases(goal, known, pending, cases) if cases else None)

    def all_known(self, known: Knowledge, pending: Sequence[Instance]) -> Knowledge:
        """What all theorems say whose premises hold."""
        for instance in pending:
            theorem = _theorem(instance, known)
            if self._premises(theorem.premises, known) is not None:
                known = known.assume(theorem.conclusion)
        return known

    def _premises(self, formulas: Sequence[Formula], known: Knowledge) -> list[Certificate] | None:
        proofs = []
        for formula in formulas:
            if (proof := self._premise(formula, known)) is None:
                return None
            proofs.append(proof)
        return proofs

    def _premise(self, formula: Formula, known: Knowledge) -> Certificate | None:
        kind, parts = formula.tag, formula.formulas
        if kind == "=":
            return identity_here(formula, known)
        if kind == "=>":
            below = known.assume(parts[0])
            then = self._premise(parts[1], below)
            if then is None and self.inner:  # here something is assumed of the bound variable
                then = _Search(self._premise, ()).prove(parts[1], below, self.inner, 0)
            return None if then is None else {"rule": "implies", "then": then}
        if kind == "and":
            shown = self._premises(parts, known)
            return None if shown is None else {"rule": "each", "parts": shown}
        if kind == "or":
            proofs = ((k, self._premise(part, known)) for k, part in enumerate(parts))
            return next(({"rule": "choose", "index": k, "then": then} for k, then in proofs if then is not None), None)
        if kind == "!=":
            return self.prove_here(formula, known)
        return prove_order(formula, known, []) or order_of_numbers(formula, known.ring.definitions)

    def _by_cases(self, goal: Formula, known: Knowledge, pending: Sequence[Instance], cases: int) -> Certificate | None:
        """What a theorem about an integral asks for holds, or it does not."""
        for instance in (each for each in pending if each.name == "beta"):
            for premise in _theorem(instance, known).premises:
                if premise[0] != ">" or self._premise(premise, known) is not None:
                    continue
                t = _deciding(known.ring.ratio(premise[1]), known)
                if known.sign(t)[0] or known.sign(node("-", t))[0]:
                    continue  # a case already, and of no use
                ref = ["here", known.count]  # of the alternative, which is a fact of its own
                ways = (node(">", t, 0), node("<=", t, 0))
                belows = (replace(known, count=known.count + 1).assume(way) for way in ways)
                proofs = [self.prove(goal, below, pending, cases - 1) for below in belows]
                split = {"rule": "cases_or", "or": ref, "cases": proofs}
                return None if None in proofs else step(applied("dichotomy", t), [], split)
        return None


def _theorem(instance: Instance, known: Knowledge) -> Theorem:
    memory, key = known.ring.memory, ("theorem", instance)
    if key not in memory:
        memory[key] = theorem_of(instance, known.ring.definitions)
    found: Theorem = memory[key]
    return found


def _deciding(value: Ratio, known: Knowledge) -> Term:
    """The factors of a fraction whose signs are not known, as a term that has its sign."""
    unit, factors = value.num.factor()
    rest = known.ring.number(1 if fraction(unit) > 0 else -1)
    for poly, exponent in factors:
        if positive_form(poly, known) is None and exponent % 2:
            rest *= poly
    return term_of(rest)
