"""Angles compared with multiples of pi and with arctan, arcsin, arccos: what that says of their sines, and back.

A theorem of `symcheck/checker/theorems.py` turns a comparison such as a < arctan t into one of sin a with t cos a.
What is left is algebra: orders by contradictions among signs (`absurd`), equations by squares or by ideals.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence, Set
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from math import prod

from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Problem
from symcheck.core.terms import PI, RELATIONS, Formula, Node, Term, node
from symcheck.proof.algebra.flint import fraction
from symcheck.proof.algebra.forms import number_term, term_of
from symcheck.proof.algebra.knowledge import Knowledge, formulas_of, hints_of, ring_of, starting
from symcheck.proof.algebra.polynomial import Ring, canonical, unfold, variables, with_arguments
from symcheck.proof.algebra.variables import atoms, circle, prime, table
from symcheck.proof.rules.absurd import contradiction, contrary_signs
from symcheck.proof.rules.choose import first_of
from symcheck.proof.rules.each import all_of, prove_all
from symcheck.proof.rules.have import Have, Lemma
from symcheck.proof.rules.identity import identity_here
from symcheck.proof.rules.implies import by_contrary, implication
from symcheck.proof.rules.nonnegative import prove_order
from symcheck.proof.rules.step import Prove, Step
from symcheck.proof.rules.theorem import Instance, applied
from symcheck.proof.search.functions import is_compared, signs

INVERSE = {"arctan": "arctangent", "arcsin": "arcsine", "arccos": "arccosine"}
SWAPPED = {"=": "=", "!=": "!=", "<": ">", "<=": ">=", ">": "<", ">=": "<="}
KNOWN_ANGLES: dict[Fraction, Node] = {  # by multiples of pi
    Fraction(0): node("arctan", 0),
    Fraction(1, 6): node("arctan", node("/", 1, node("sqrt", 3))),
    Fraction(1, 4): node("arctan", 1),
    Fraction(1, 3): node("arctan", node("sqrt", 3)),
    Fraction(1, 2): node("arccos", 0),
}
_HALF: Term = node("/", 1, 2)
_TWO, _THREE = (node("/", node("sqrt", n), 2) for n in (2, 3))
_SINES: tuple[tuple[Term, Term], ...] = ((0, 1), (_HALF, _THREE), (_TWO, _TWO), (_THREE, _HALF), (1, 0))
KNOWN_SINES = dict(zip(KNOWN_ANGLES, _SINES, strict=True))  # and cosines


def compares_angles(ring: Ring) -> bool:
    """Whether angles occur together with their sines, or inverse functions occur."""
    names = with_arguments(ring.names)
    arcs = any(name in atoms() and atoms()[name][0] in INVERSE for name in names)
    return arcs or ("pi" in names and any(turn is not None and turn[1] in names for turn in map(circle, names)))


def prove_about_angles(problem: Problem, prove_here: Prove) -> Step | None:
    """A proof of a statement in which angles are compared; `prove_here` is asked for equations of their sines."""
    definitions = dict(problem.definitions)
    ring = Ring(with_arguments(ring_of(problem).names), definitions)
    claim, *given = formulas_of(problem)
    comparisons = [pair for f in (*given, claim) for pair in compared(unfold(f, definitions), ring)]
    arcs = [pair for part in conjuncts(claim) for pair in _arcs(unfold(part, definitions), ring)]
    comparisons += arcs
    angles = sorted({pair.angle for pair in comparisons if isinstance(pair.angle, str)})
    positive = [Comparison.with_pi(">=", angle, Fraction(0)) for angle in angles]
    comparisons += positive
    names = _names_of((i for pair in comparisons for i in (*pair.theorems(), pair.theorem(1))), definitions)
    whole = Ring(with_arguments({"pi", *ring.names, *names}), definitions)
    always = [applied("circle_number"), *_of_atoms(whole), *(_circular(whole) if arcs else ())]
    known = starting(problem, Ring({*whole.names, *_names_of(always, definitions)}, definitions))
    of_angles = [applied("right_half", angle) for angle in angles] + [pair.theorem(0) for pair in positive]
    pending = list(dict.fromkeys((*always, *_forward(given, known.ring), *of_angles)))
    turned = {turn[1] for turn in map(circle, ring.names) if turn is not None}.intersection(ring.names)
    more = [instance for angle in sorted(turned) if is_compared(angle, known) for instance in signs(angle)]
    prover = _Prover(prove_here, hints_of(problem), frozenset(arcs))
    found = prover.prove(claim, known, pending)
    return prover.prove(claim, known, [*pending, *more]) if found is None and more else found


Usable = Instance | Lemma  # in a proof, once its premises have proofs


@dataclass(frozen=True)
class Comparison:
    """angle ~ function(t); where a multiple of pi is printed, the multiple."""

    sign: str
    angle: Term
    function: str
    t: Term
    multiple: Fraction | None = None

    @classmethod
    def with_pi(cls, sign: str, angle: Term, multiple: Fraction) -> Comparison:
        """angle ~ multiple pi."""
        known = KNOWN_ANGLES[multiple]
        return cls(sign, angle, known.tag, known.terms[0], multiple)

    @property
    def end(self) -> Term:
        """What the angle is compared with."""
        return node(self.function, self.t) if self.multiple is None else multiple_of_pi(self.multiple)

    def theorem(self, back: int) -> Instance:
        """From the angle to its sine, or back."""
        name = f"{INVERSE[self.function]} {self.sign}{' back' * back}"
        return applied(name, self.angle, self.t)

    def theorems(self) -> Iterator[Usable]:
        """What it says of the sine, and of a well-known angle the cosine itself."""
        yield self.theorem(0)
        if self.sign == "=" and self.multiple is not None:
            yield Lemma(node("=", node("cos", self.angle), KNOWN_SINES[self.multiple][1]))


def _arcs(formula: Formula, ring: Ring) -> Iterator[Comparison]:
    """A sum of angles with an inverse function among them: that is compared with the rest."""
    if formula.tag not in RELATIONS or (gap := ring.subtract(*formula.terms)).den:
        return
    for exponents, coefficient in gap.num.terms():
        name = next((name for name, e in zip(ring.names, exponents, strict=True) if e), "")
        if sum(exponents) == 1 and fraction(coefficient) in (1, -1) and name in atoms() and atoms()[name][0] in INVERSE:
            arc = node(*atoms()[name])
            sign = formula.tag if coefficient < 0 else SWAPPED[formula.tag]
            yield Comparison(sign, term_of((gap.num - ring.poly(arc) * coefficient) * -coefficient), *atoms()[name])


def multiple_of_pi(multiple: Fraction) -> Term:
    """An angle as a term."""
    return node("*", number_term(multiple), PI) if multiple else 0


def _comparison(formula: Formula, ring: Ring) -> Comparison | None:
    """A relation that compares an angle with an inverse function or a multiple of pi."""
    if formula.tag not in RELATIONS or (gap := ring.subtract(*formula.terms)).den:
        return None
    terms = {}
    for exponents, coefficient in gap.num.terms():
        used = [(name, int(e)) for name, e in zip(ring.names, exponents, strict=True) if e]
        if len(used) != 1 or used[0][1] != 1:
            return None
        terms[used[0][0]] = fraction(coefficient)
    angles = [name for name in terms if name != "pi" and not table().stands(name)]
    if len(angles) != 1 or len(terms) > 2:
        return None
    scale = terms.pop(angles[0])
    sign = formula.tag if scale > 0 else SWAPPED[formula.tag]
    other, factor = next(iter(terms.items()), ("pi", Fraction(0)))
    multiple = -factor / scale
    if other == "pi" and multiple in KNOWN_ANGLES:
        return Comparison.with_pi(sign, angles[0], multiple)
    if other in atoms() and atoms()[other][0] in INVERSE and multiple == 1:
        return Comparison(sign, angles[0], *atoms()[other])
    return None


def compared(formula: Formula, ring: Ring) -> Iterator[Comparison]:
    """Those in a formula without quantifiers."""
    if formula.tag in RELATIONS:
        if (pair := _comparison(formula, ring)) is not None:
            yield pair
    elif formula.tag != "exists":
        for part in formula.formulas:
            yield from compared(part, ring)


def _forward(formulas: Sequence[Formula], ring: Ring) -> list[Usable]:
    """What the comparisons among assumptions say of the sines."""
    pairs = (_comparison(formula, ring) for formula in formulas)
    return [instance for pair in pairs if pair is not None for instance in pair.theorems()]


def _of_atoms(ring: Ring) -> Iterator[Instance]:
    """What is always true of the functions in a ring."""
    for name in ring.names:
        function, *arguments = atoms().get(name, ("",))
        if (p := prime(name)) is not None:
            yield applied("root", p)
        elif function == "sqrt":
            yield applied("root", *arguments)
        elif function in INVERSE:
            yield from _known_angle(function, *arguments)
            yield applied(f"principal_value_{function}", *arguments)
            yield applied(f"first_quadrant_{function}", *arguments)


def _circular(ring: Ring) -> Iterator[Instance]:
    """The sines and cosines of inverse functions."""
    for name in ring.names:
        function, *arguments = atoms().get(name, ("",))
        if function in INVERSE:
            yield applied(f"circular_of_{function}", *arguments)


def _known_angle(function: str, t: Term) -> Iterator[Instance]:
    """The theorem about arctan t, arcsin t or arccos t, if that is a well-known angle."""
    for number in range(len(KNOWN_ANGLES) - (function == "arctan")):
        instance = applied(f"known_angle_{function}_{number}")
        value = instance.said({}).conclusion.terms[0]
        if isinstance(value, Node) and canonical(value.terms[0]) == canonical(t):
            yield instance


def _names_of(instances: Iterable[Usable], definitions: dict[str, Term]) -> set[str]:
    """The variables that theorems speak of."""
    theorems = (instance.said(definitions) for instance in instances)
    said = (unfold(f, definitions) for premises, conclusion in theorems for f in (*premises, conclusion))
    return set().union(*map(variables, said))


def _has_roots(term: Term) -> bool:
    return any(atoms().get(name, ("",))[0] == "sqrt" for name in variables(term))


def _squared(side: Term, ring: Ring) -> Term | None:
    """The square of a side as a term without roots of letters; None if there is no such term."""
    roots = {k: ring.ratio(atoms()[x][1]) for k, x in enumerate(ring.names) if atoms().get(x, ())[:1] == ("sqrt",)}
    ratio, total = ring.ratio(side), ring.number(0)
    if ratio.den or any(radicand.den for radicand in roots.values()):
        return None
    for exponents, coefficient in (ratio.num**2).terms():
        if any(exponents[k] % 2 for k in roots):
            return None
        rest = tuple(0 if k in roots else int(e) for k, e in enumerate(exponents))
        powers = (radicand.num ** (int(exponents[k]) // 2) for k, radicand in roots.items())
        total += prod(powers, start=ring.context.from_dict({rest: coefficient}))
    return term_of(total)


@dataclass(frozen=True)
class _Prover:
    prove_here: Prove
    forms: Sequence[Term]
    arcs: Set[Comparison]  # sums of angles that may be compared by their sines: these are in the ring

    def prove(self, goal: Formula, known: Knowledge, pending: Sequence[Usable]) -> Step | None:
        """First the theorems whose premises hold, as long as there are any, then the goal."""
        for k, instance in enumerate(pending):
            theorem = instance.said(known.ring.definitions)
            premises = prove_all(theorem.premises, known, self.relation)
            if premises is not None:
                rest = [*pending[k + 1 :], *pending[:k]]  # what did not hold so far is tried again last
                then = self.prove(goal, known.assume(theorem.conclusion), rest)
                return then and instance.step(premises, then)
        return self.goal(goal, known, pending)

    def goal(self, goal: Formula, known: Knowledge, pending: Sequence[Usable]) -> Step | None:
        """By the outermost connective."""
        match goal.tag:
            case "=>":
                more = [*pending, *_forward(conjuncts(goal.formulas[0]), known.ring)]
                return implication(goal, known, partial(self.prove, pending=more))
            case "and" | "<=>":
                return all_of(goal, known, partial(self.goal, pending=pending))
            case "or":
                return first_of(goal, known, partial(self.goal, pending=pending))
        return self.relation(goal, known) or self.by_sine(goal, known) if goal.tag in RELATIONS else None

    def by_sine(self, goal: Formula, known: Knowledge) -> Step | None:
        """An angle compared by its sine."""
        pair = _comparison(goal, known.ring)
        for each in [pair] if pair else (arc for arc in _arcs(goal, known.ring) if arc in self.arcs):
            theorem = (instance := each.theorem(1)).said(known.ring.definitions)
            premises = prove_all(theorem.premises, known, self.relation)
            if premises is not None and (then := self.relation(goal, known.assume(theorem.conclusion))):
                return instance.step(premises, then)
        return None

    def relation(self, goal: Formula, known: Knowledge) -> Step | None:
        """A relation, by algebra."""
        if goal.tag == "!=":
            return by_contrary(goal, known, lambda _, below: contradiction(below, goal)) or self.prove_here(goal, known)
        if goal.tag == "=":
            return identity_here(goal, known) or self.by_squares(goal, known) or self.prove_here(goal, known)
        if _comparison(goal, known.ring) is not None:
            return contrary_signs(goal, known, products=False) or prove_order(goal, known)
        return prove_order(goal, known, self.forms) or self.without_roots(goal, known) or contrary_signs(goal, known)

    def without_roots(self, goal: Formula, known: Knowledge) -> Step | None:
        """An order of roots by that of their squares."""
        if not any(_has_roots(unfold(side, known.ring.definitions)) for side in goal.terms):
            return None
        left, right = (_squared(side, known.ring) for side in goal.terms)
        if left is None or right is None:
            return None
        squared = node(goal.tag, left, right)
        proof = self.relation(squared, known)
        then = proof and contrary_signs(goal, known.assume(squared))
        return Have(squared, proof, then) if proof and then else None

    def by_squares(self, goal: Formula, known: Knowledge) -> Step | None:
        """Two things that are not negative are equal if their squares are."""
        theorem = (instance := applied("equal_squares", *goal.terms)).said(known.ring.definitions)
        *signs, squares = theorem.premises
        last = identity_here(squares, known)
        premises = prove_all(signs, known, self.relation) if last else None
        then = identity_here(goal, known.assume(theorem.conclusion))
        return instance.step([*premises, last], then) if premises and last and then else None
