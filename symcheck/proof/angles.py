"""Angles compared with multiples of pi and with arctan, arcsin, arccos: what that says of their sines, and back.

A theorem of `symcheck/checker/theorems.py` turns a comparison such as a < arctan t into one of sin a with t cos a.
What is left is algebra: orders by `farkas`, equations by squares or by ideals.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import prod

from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Problem
from symcheck.core.terms import PI, RELATIONS, Formula, Node, Term, node
from symcheck.core.verdicts import Certificate
from symcheck.proof.applied import Instance, applied, have, step, theorem_of
from symcheck.proof.equations import identity_here
from symcheck.proof.farkas import contradiction, prove_by_contrary
from symcheck.proof.knowledge import Knowledge, hints_of, ring_of, starting
from symcheck.proof.orders import number_term, prove_order, term_of
from symcheck.proof.polynomial import (
    Ring,
    canonical,
    fraction,
    unfold,
    variables,
    with_arguments,
)
from symcheck.proof.variables import atoms, circle, prime, table

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
Prover = Callable[[Formula, Knowledge], Certificate | None]


def compares_angles(ring: Ring) -> bool:
    """Whether angles stand beside their sines, or inverse functions occur."""
    names = with_arguments(ring.names)
    arcs = any(name in atoms() and atoms()[name][0] in INVERSE for name in names)
    return arcs or ("pi" in names and any(turn is not None and turn[1] in names for turn in map(circle, names)))


def prove_about_angles(problem: Problem, prove_here: Prover) -> Certificate | None:
    """A proof of a statement in which angles are compared; `prove_here` is asked for equations of their sines."""
    definitions = dict(problem.definitions)
    ring = Ring(with_arguments(ring_of(problem).names), definitions)
    stated = [part for _, formulas in problem.hypotheses for f in formulas for part in conjuncts(f)]
    found = [each for f in (*stated, problem.claim) for each in compared(unfold(f, definitions), ring)]
    angles = sorted({each.angle for each in found})
    positive = [Comparison.with_pi(">=", angle, Fraction(0)) for angle in angles]
    found += positive
    names = _names_of((i for each in found for i in (*each.theorems(), each.theorem(1))), definitions)
    whole = Ring(with_arguments({"pi", *ring.names, *names}), definitions)
    always = [applied("circle_number"), *_of_atoms(whole)]
    known = starting(problem, Ring({*whole.names, *_names_of(always, definitions)}, definitions))
    signs: list[Instance] = [applied("right_half", angle) for angle in angles]
    signs += [each.theorem(0) for each in positive]
    pending = dict.fromkeys([*always, *_forward(stated, known.ring), *signs])
    return _Prover(prove_here, hints_of(problem)).prove(problem.claim, known, list(pending))


@dataclass(frozen=True)
class Comparison:
    """angle ~ function(t); where a multiple of pi is printed, the multiple."""

    sign: str
    angle: str
    function: str
    t: Term
    multiple: Fraction | None = None

    @classmethod
    def with_pi(cls, sign: str, angle: str, multiple: Fraction) -> Comparison:
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

    def theorems(self) -> Iterator[Instance]:
        """What it says of the sine, and of a well-known angle the cosine itself."""
        yield self.theorem(0)
        if self.sign == "=" and self.multiple is not None:
            yield have(node("=", node("cos", self.angle), KNOWN_SINES[self.multiple][1]))


def multiple_of_pi(multiple: Fraction) -> Term:
    """An angle as a term."""
    return node("*", number_term(multiple), PI) if multiple else 0


def _comparison(formula: Formula, ring: Ring) -> Comparison | None:
    """A relation that compares an angle with an inverse function or a multiple of pi."""
    if formula[0] not in RELATIONS or (gap := ring.subtract(*formula[1:])).den:
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
    sign = formula[0] if scale > 0 else SWAPPED[formula[0]]
    other, factor = next(iter(terms.items()), ("pi", Fraction(0)))
    multiple = -factor / scale
    if other == "pi" and multiple in KNOWN_ANGLES:
        return Comparison.with_pi(sign, angles[0], multiple)
    if other in atoms() and atoms()[other][0] in INVERSE and multiple == 1:
        return Comparison(sign, angles[0], *atoms()[other])
    return None


def compared(formula: Formula, ring: Ring) -> Iterator[Comparison]:
    """Those in a formula without quantifiers."""
    if formula[0] in RELATIONS:
        if (found := _comparison(formula, ring)) is not None:
            yield found
    elif formula[0] != "exists":
        for part in formula.formulas:
            yield from compared(part, ring)


def _forward(formulas: Sequence[Formula], ring: Ring) -> list[Instance]:
    """What the comparisons among assumptions say of the sines."""
    found = (_comparison(formula, ring) for formula in formulas)
    return [instance for each in found if each is not None for instance in each.theorems()]


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


def _known_angle(function: str, t: Term) -> Iterator[Instance]:
    """The theorem about arctan t, arcsin t or arccos t, if that is a well-known angle."""
    for number in range(len(KNOWN_ANGLES) - (function == "arctan")):
        instance = applied(f"known_angle_{function}_{number}")
        value = theorem_of(instance, {}).conclusion.terms[0]
        if isinstance(value, Node) and canonical(value.terms[0]) == canonical(t):
            yield instance


def _names_of(instances: Iterable[Instance], definitions: dict[str, Term]) -> set[str]:
    """The variables that theorems speak of."""
    theorems = (theorem_of(instance, definitions) for instance in instances)
    said = (unfold(f, definitions) for each in theorems for f in (*each.premises, each.conclusion))
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
    prove_here: Prover
    forms: Sequence[Term]

    def prove(self, goal: Formula, known: Knowledge, pending: Sequence[Instance]) -> Certificate | None:
        """First the theorems whose premises hold, as long as there are any, then the goal."""
        for k, instance in enumerate(pending):
            theorem = theorem_of(instance, known.ring.definitions)
            premises = self.premises(theorem.premises, known)
            if premises is not None:
                rest = [*pending[k + 1 :], *pending[:k]]  # what did not hold so far is tried again last
                then = self.prove(goal, known.assume(theorem.conclusion), rest)
                return then and step(instance, premises, then)
        return self.goal(goal, known, pending)

    def goal(self, goal: Formula, known: Knowledge, pending: Sequence[Instance]) -> Certificate | None:
        """By the outermost connective."""
        kind, parts = goal.tag, goal.formulas
        if kind == "=>":
            more = _forward(conjuncts(parts[0]), known.ring)
            then = self.prove(parts[1], known.assume(parts[0]), [*pending, *more])
            return then and {"rule": "implies", "then": then}
        if kind in ("and", "<=>"):
            parts = parts if kind == "and" else (node("=>", *parts), node("=>", *parts[::-1]))
            proofs = []
            for part in parts:
                if (proof := self.goal(part, known, pending)) is None:
                    return None
                proofs.append(proof)
            return {"rule": "each", "parts": proofs}
        if kind == "or":
            tried = ((k, self.goal(part, known, pending)) for k, part in enumerate(parts))
            return next(({"rule": "choose", "index": k, "then": then} for k, then in tried if then), None)
        if kind not in RELATIONS:
            return None
        return self.relation(goal, known) or self.by_sine(goal, known)

    def premises(self, formulas: Sequence[Formula], known: Knowledge) -> list[Certificate] | None:
        """The proofs of them all."""
        proofs = []
        for formula in formulas:
            if (proof := self.relation(formula, known)) is None:
                return None
            proofs.append(proof)
        return proofs

    def by_sine(self, goal: Formula, known: Knowledge) -> Certificate | None:
        """An angle compared by its sine."""
        if (found := _comparison(goal, known.ring)) is None:
            return None
        theorem = theorem_of(instance := found.theorem(1), known.ring.definitions)
        if (premises := self.premises(theorem.premises, known)) is None:
            return None
        then = self.relation(goal, known.assume(theorem.conclusion))
        return then and step(instance, premises, then)

    def relation(self, goal: Formula, known: Knowledge) -> Certificate | None:
        """A relation, by algebra."""
        if goal[0] == "!=":
            then = contradiction(known.assume(node("=", *goal[1:])), goal)
            return {"rule": "implies", "then": then} if then else self.prove_here(goal, known)
        if goal[0] == "=":
            return identity_here(goal, known) or self.by_squares(goal, known) or self.prove_here(goal, known)
        if _comparison(goal, known.ring) is not None:
            return prove_by_contrary(goal, known, products=False)
        return (
            prove_order(goal, known, [*self.forms]) or self.without_roots(goal, known) or prove_by_contrary(goal, known)
        )

    def without_roots(self, goal: Formula, known: Knowledge) -> Certificate | None:
        """An order of roots by that of their squares."""
        if not any(_has_roots(unfold(side, known.ring.definitions)) for side in goal.terms):
            return None
        left, right = (_squared(side, known.ring) for side in goal.terms)
        if left is None or right is None:
            return None
        squared = node(goal.tag, left, right)
        proof = self.relation(squared, known)
        then = proof and prove_by_contrary(goal, known.assume(squared))
        return step(have(squared), [proof], then) if proof and then else None

    def by_squares(self, goal: Formula, known: Knowledge) -> Certificate | None:
        """Two things that are not negative are equal if their squares are."""
        theorem = theorem_of(instance := applied("equal_squares", *goal[1:]), known.ring.definitions)
        *signs, squares = theorem.premises
        last = identity_here(squares, known)
        premises = self.premises(signs, known) if last else None
        then = identity_here(goal, replace(known.assume(theorem.conclusion)))
        return step(instance, [*premises, last], then) if premises and last and then else None
