"""Statements about functions, proved by theorems: those whose premises can be proved, then what follows from them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, field, replace
from functools import partial

from symcheck.checker.theorems import SMOOTHLY
from symcheck.core.calculus import divisor as divided_by
from symcheck.core.calculus import letters, nodes
from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import Formula, Term, Value, node
from symcheck.proof.algebra.facts import Assumed
from symcheck.proof.algebra.flint import fraction, occurring
from symcheck.proof.algebra.forms import positive_form, term_of
from symcheck.proof.algebra.knowledge import Knowledge, ring_of, starting
from symcheck.proof.algebra.polynomial import Ratio, Ring, beneath, unfold, variables, with_arguments
from symcheck.proof.algebra.printed import term_of_text
from symcheck.proof.algebra.variables import Unsupported, atoms, circle, prime, table
from symcheck.proof.rules.cases_or import in_cases
from symcheck.proof.rules.choose import first_of
from symcheck.proof.rules.each import all_of, prove_all
from symcheck.proof.rules.enclosure import order_of_numbers
from symcheck.proof.rules.have import Have
from symcheck.proof.rules.identity import equations_here, identity_here
from symcheck.proof.rules.implies import implication
from symcheck.proof.rules.nonnegative import prove_order
from symcheck.proof.rules.step import Prove, Step
from symcheck.proof.rules.theorem import Instance, Said, applied
from symcheck.proof.search.functions import SIGNS, expanded, instances, is_compared, signs, simplified

MAX_INSTANCES = 40  # theorems: whenever one has been applied, all others are tried again
# theorems whose premises of this sign may hold in some cases alone
SPLIT = {"beta": ">", "equal_squares": ">=", "rising": ">=", "rising_strictly": ">"}
MAX_CASES = 4  # one inside another, each of which doubles the work: the papers need one


def has_functions(ring: Ring) -> bool:
    """Whether atoms are among the variables, or anything but letters in arguments of sines, cosines, exponentials."""
    return any(name in atoms() or any(expanded(name)) for name in with_arguments(ring.names))


def prove_with_theorems(problem: Problem, prove_here: Prove) -> Step | None:
    """A proof of a statement about functions; `prove_here` finishes it when no theorem is left to apply."""
    plan = _Plan.of(problem)
    found = _Search(prove_here, plan.inner).prove(problem.claim, plan.known, plan.outer)
    if found is None and plan.add_signs(problem):
        found = _Search(prove_here, plan.inner).prove(problem.claim, plan.known, plan.outer)
    return found


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
    if all(n == "pi" or prime(n) for n in occurring(value)):
        yield term_of(value)


@dataclass
class _Plan:
    """The theorems about the functions of a statement: `outer` ones, and `inner` ones that speak of bound variables."""

    definitions: Mapping[str, Term]
    names: set[str]
    assumed: Knowledge
    hinted: frozenset[str] = frozenset()  # letters of theorems that the declaration names
    outer: list[Instance] = field(default_factory=list)
    inner: list[Instance] = field(default_factory=list)
    known: Knowledge = field(init=False)

    @classmethod
    def of(cls, problem: Problem) -> _Plan:
        """All theorems that may help, but for those about the signs of sines and cosines."""
        definitions, own = dict(problem.definitions), ring_of(problem)
        assumed = starting(problem, Ring(with_arguments(own.names), definitions))
        if problem.claim[0] == "=>":
            assumed = assumed.assume(problem.claim.formulas[0])
        inner = variables(*(part for name in own.names for part in beneath(name)))
        hinted = _hinted(problem)
        plan = cls(definitions, {*own.names, *inner}, assumed, frozenset(each.letter for each in hinted if each.letter))
        for instance in hinted:
            plan._add(instance, plan.inner if _around(instance) & plan.hinted else plan.outer)
        plan._collect()
        for p in [p for p in map(prime, sorted(plan.names)) if p is not None]:
            plan._add(applied("root", p), plan.outer)
        if "pi" in plan.names:
            plan._add(applied("circle_number"), plan.outer)
        plan.known = starting(problem, Ring(plan.names, definitions))
        return plan

    def _collect(self) -> None:
        seen: set[str] = set()
        while fresh := sorted(name for name in self.names - seen if name in atoms() or beneath(name)):
            seen |= set(fresh)
            bound = self._bound(seen)
            for instance in (i for name in fresh for i in self._instances(name)):
                about = variables(*instance.terms) if not instance.letter else _around(instance)
                kept = (
                    self.inner if with_arguments(about) & bound else self.outer
                )  # nothing is assumed of what is bound
                if instance not in kept and len(kept) < MAX_INSTANCES:
                    self._add(instance, kept)

    def _bound(self, names: Set[str]) -> set[str]:
        """The letters that integrals and sums bind, and those of theorems that the declaration names."""
        return {x for name in names & atoms().keys() for x in atoms()[name].bound} | self.hinted

    def add_signs(self, problem: Problem) -> bool:
        """The signs of sines and cosines whose angles are bound or compared with something; False if there are none."""
        bound = self._bound(self.names)
        first, before = list[Instance](), len(self.inner)  # what is not zero by them may be divided by in all others
        for x in dict.fromkeys(turn[1] for turn in map(circle, sorted(self.names)) if turn is not None):
            term = table().angles.get(x, x)
            inside = bool(letters(term) & bound)
            for instance in signs(term) if inside or not letters(term) or is_compared(term, self.assumed) else ():
                self._add(instance, self.inner if inside else first)
        self.outer[:0] = first
        self.known = starting(problem, Ring(self.names, self.definitions))
        return bool(first) or len(self.inner) > before

    def _instances(self, name: str) -> Iterator[Instance]:
        if name not in atoms():
            yield from expanded(name)
            return
        yield from simplified(name, self.assumed)
        yield from instances(name, self.names)

    def _add(self, instance: Instance, kept: list[Instance]) -> None:
        try:
            theorem = instance.said(self.definitions)
            said = (unfold(formula, self.definitions) for formula in (*theorem.premises, theorem.conclusion))
            needed = set().union(*map(variables, said))
        except Unsupported:
            return
        kept.append(instance)
        self.names |= needed


def _hinted(problem: Problem) -> list[Instance]:
    """The theorems that the declaration names."""
    return [applied(hint.theorem, *hint.functions, *hint.terms) for hint in problem.hints if isinstance(hint, Applied)]


@dataclass(frozen=True)
class _Search:
    prove_here: Prove
    inner: Sequence[Instance]

    def prove(
        self, goal: Formula, known: Knowledge, pending: Sequence[Instance], cases: int = MAX_CASES
    ) -> Step | None:
        """Assumptions first, then every theorem whose premises hold, then the goal itself, then a case more."""
        if goal.tag in ("=>", "<=>"):
            below = partial(self.prove, pending=pending, cases=cases)
            return (implication if goal.tag == "=>" else all_of)(goal, known, below)
        for k, instance in enumerate(pending):
            theorem = _said(instance, known)
            if instance.name in SIGNS:
                premises = prove_all(theorem.premises, _linear(known), prove_order)
            else:
                premises = self._premises(theorem.premises, known, instance.letter)
            if premises is not None:
                then = self.prove(goal, known.assume(theorem.conclusion), [*pending[:k], *pending[k + 1 :]], cases)
                return None if then is None else instance.step(premises, then)
        proof = equations_here(goal, known) or self.prove_here(goal, known)
        return proof or (self._by_cases(goal, known, pending, cases) if cases else None)

    def all_known(self, known: Knowledge, pending: Sequence[Instance]) -> Knowledge:
        """What all theorems say whose premises hold."""
        for instance in pending:
            theorem = _said(instance, known)
            if self._premises(theorem.premises, known, instance.letter) is not None:
                known = known.assume(theorem.conclusion)
        return known

    def _premises(self, formulas: Sequence[Formula], known: Knowledge, letter: str) -> tuple[Step, ...] | None:
        """The proofs of premises, some of which are so of all numbers that a letter stands for."""

        def prove(formula: Formula, known: Knowledge) -> Step | None:
            of_all = formula.tag == "=" and letter in letters(formula)
            return self._conclusion(formula, known, letter) if of_all else self._premise(formula, known)

        return prove_all(formulas, known, prove)

    def _premise(self, formula: Formula, known: Knowledge) -> Step | None:
        match formula.tag:
            case "=":
                direct = identity_here(formula, known) or self._with_inner(formula, known)
                return direct or (self.prove_here(formula, known) if _has_factors(formula) else None)
            case "=>":
                return implication(formula, known, self._conclusion)
            case "and":
                return all_of(formula, known, self._premise)
            case "or":
                return first_of(formula, known, self._premise)
            case "!=":
                return self.prove_here(formula, _not_divided_by(formula, known))
        return prove_order(formula, known) or order_of_numbers(formula, known.ring.definitions)

    def _conclusion(
        self, formula: Formula, known: Knowledge, letter: str = "", shown: frozenset[Term] = frozenset()
    ) -> Step | None:
        """What a premise says of a bound variable, under an assumption perhaps, where theorems may speak of that.

        With a letter, only what it divides by that contains this letter is shown not to be zero, but for what is shown.
        """
        met = (part for each in map(divided_by, nodes(formula)) for part in (each, *_fractions(each)))
        for divisor in dict.fromkeys(part for part in met if part not in shown):
            positive = node(">", divisor, 0)
            if letter in {"", *letters(divisor)} and (why := _shown_here(divisor, known)) is not None:
                then = self._conclusion(formula, known.assume(positive), letter, shown | {divisor})
                return None if then is None else Have(positive, why, then)
        again = formula.tag != "="  # of an equation this has been tried
        return self._premise(formula, known) or (self._with_inner(formula, known) if again else None)

    def _with_inner(self, formula: Formula, known: Knowledge) -> Step | None:
        below = _Search(self.prove_here, ())
        nested = [instance for instance in self.inner if instance.name.startswith(SMOOTHLY)]
        bound = {instance.letter for instance in nested}
        deeper = [instance for instance in nested if _around(instance) & bound]
        apart = nested if formula.tag == "!=" else deeper  # what they say may divide by what is to be shown not to be 0
        met = with_arguments(variables(formula))
        others = [i for i in nested if i not in apart and not _decides(i, known) & met]
        here = [instance for instance in self.inner if instance not in (*apart, *others)]
        return _Search(below._premise, deeper).prove(formula, known, here, 0) if here else None

    def _by_cases(self, goal: Formula, known: Knowledge, pending: Sequence[Instance], cases: int) -> Step | None:
        """What a theorem about an integral or an absolute value asks for holds, or it does not."""
        for instance in pending:
            for premise in _said(instance, known).premises if instance.name in SPLIT else ():
                if premise.tag != SPLIT[instance.name] or self._premise(premise, known) is not None:
                    continue
                t = _deciding(known.ring.ratio(premise.terms[0]), known)
                if known.sign(t)[0] or known.sign(node("-", t))[0]:
                    continue  # a case already, and of no use
                ways, below = (node(">", t, 0), node("<=", t, 0)), replace(known, count=known.count + 1)
                alternative = Assumed(known.count)
                split = in_cases(goal, alternative, ways, below, partial(self.prove, pending=pending, cases=cases - 1))
                return split and applied("dichotomy", t).step([], split)
        return None


def _fractions(divisor: Term) -> Iterator[Term]:
    """The factors of a divisor in which something is divided: each of them has to be shown not to be zero."""
    match divisor:
        case Value(tag="*", terms=factors):
            yield from (each for factor in factors for each in (factor, *_fractions(factor)) if _divides(each))
        case Value(tag="^", terms=(base, _)) if _divides(base):
            yield base


def _divides(term: Term) -> bool:
    return any(part.tag == "/" for part in nodes(term))


def _shown_here(divisor: Term, known: Knowledge) -> Step | None:
    """Why a divisor is positive, if its form does not say so."""
    known_here = letters(divisor) and variables(divisor) <= {*known.ring.names}
    if not known_here or Knowledge(known.ring).sign(divisor)[0]:
        return None
    value = known.ring.ratio(divisor)
    if not value.den and known.nonzero(value.num) is not None:
        return None  # for the checker a fraction is not its numerator
    return prove_order(node(">", divisor, 0), known)


def _linear(known: Knowledge) -> Knowledge:
    """What is known of sizes: all that the order of angles follows from, without a basis of everything."""
    return replace(known, facts=tuple(fact for fact in known.facts if fact[1].total_degree() == 1))


def _not_divided_by(formula: Formula, known: Knowledge) -> Knowledge:
    """What is known without equations that divide by what is to be shown not to be zero: these hold if it is so."""
    about = variables(*formula.terms)
    kept = tuple(fact for fact in known.facts if not any(about & variables(term_of_text(t)) for t in fact[0].cleared))
    return replace(known, facts=kept)


def _has_factors(formula: Formula) -> bool:
    """Whether squares are compared, or an exponential with anything: factors may have to be divided out of facts."""
    tags = [side.tag if isinstance(side, Value) else "" for side in formula.terms]
    return tags == ["^", "^"] or tags[0] == "exp"


def _around(instance: Instance) -> set[str]:
    """The letters but its own of which a theorem speaks."""
    return set().union(*map(letters, instance.terms)) - {instance.letter}


def _decides(instance: Instance, known: Knowledge) -> set[str]:
    """The variables of what it gives a value to, or of both sides of an order."""
    conclusion = _said(instance, known).conclusion
    return variables(*conclusion.terms[: 1 if conclusion.tag == "=" else 2])


def _said(instance: Instance, known: Knowledge) -> Said:
    return known.ring.remembered(("theorem", instance), lambda: instance.said(known.ring.definitions))


def _deciding(value: Ratio, known: Knowledge) -> Term:
    """The factors of a fraction whose signs are not known, as a term that has its sign."""
    unit, factors = value.num.factor()
    rest = known.ring.number(1 if fraction(unit) > 0 else -1)
    for poly, exponent in factors:
        if positive_form(poly, known) is None and exponent % 2:
            rest *= poly
    return term_of(rest)
