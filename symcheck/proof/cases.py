"""Implications, equivalences, alternatives and inequalities: factors first, then Groebner bases, then case splits."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from symcheck.proof.existence import prove_existence
from symcheck.proof.ideal import Fact, Ideal, Ref
from symcheck.proof.identity import prove_identity, written
from symcheck.proof.knowledge import Knowledge, hints_of, proportional, ring_of, starting
from symcheck.proof.nonnegative import prove_order, term_of
from symcheck.proof.polynomial import RELATIONS, Poly, Ring, fraction
from symcheck.statement import Certificate, Formula, Problem, Term

ABSURD: Formula = ("or",)  # the goal of a contradiction: nothing to choose from
MAX_NODES = 80
MAX_TERMS = 14
MAX_DEGREE = 8
PAIRS = 300


def prove(problem: Problem, ring: Ring) -> Certificate | None:
    """A proof of the claim, or None. Defined letters are left free first: what holds for all their values is simpler."""
    kind = problem.claim[0]
    if kind == "=" and (proof := prove_identity(problem, ring)) is not None:
        return proof
    if kind in ("<", "<=", ">", ">="):
        return prove_order(problem.claim, starting(problem, ring), hints_of(problem), problem)
    if kind == "exists":
        return prove_existence(problem, ring)
    if problem.definitions:
        free = replace(problem, definitions=())
        if (proof := _Engine(hints_of(free)).start(free, ring_of(free))) is not None:
            return proof
    return _Engine(hints_of(problem)).start(problem, ring)


def prove_here(goal: Formula, known: Knowledge) -> Certificate | None:
    """A proof of the goal from what is known at one place, without hints."""
    return _Engine(()).prove(goal, known)


@dataclass
class _Place:
    """Knowledge at a node, with the ideal of its short facts; the long ones are used as they stand."""

    known: Knowledge

    def __post_init__(self) -> None:
        facts = self.known.facts
        self.long = [f for f in facts if len(f[1]) > MAX_TERMS or f[1].total_degree() > MAX_DEGREE]
        short = [f for f in facts if len(f[1]) <= MAX_TERMS and f[1].total_degree() <= MAX_DEGREE]
        self.ideal = Ideal(self.known.ring, [*self.known.ring.axioms(), *short], PAIRS)

    def cofactors(self, poly: Poly) -> list[Fact] | None:
        """The polynomial as a combination of facts, at most one of them long."""
        if poly == 0:
            return []
        rest = self.ideal.reduce(poly)
        if rest == 0:
            return self.ideal.cofactors(poly)
        for ref, fact in self.long:
            factor = proportional(rest, self.ideal.reduce(fact))
            if factor is not None:
                multiple = self.known.ring.number(factor)
                others = self.ideal.cofactors(poly - fact * multiple)
                return None if others is None else [(ref, multiple), *others]
        return None


class _Engine:
    def __init__(self, forms: Sequence[Term]) -> None:
        self.forms = list(forms)
        self.nodes = 0

    def start(self, problem: Problem, ring: Ring) -> Certificate | None:
        return self.prove(problem.claim, starting(problem, ring))

    def prove(self, goal: Formula, known: Knowledge) -> Certificate | None:
        """A proof of any formula from what is known, by its outermost connective."""
        kind = goal[0]
        if kind == "and":
            return self._each(goal, known)
        if kind == "=>":
            return _wrap("implies", then=self.prove(goal[2], known.assume(goal[1])))
        if kind == "<=>":
            forward = self.prove(goal[2], known.assume(goal[1]))
            backward = forward and self.prove(goal[1], known.assume(goal[2]))
            return _wrap("iff", forward=forward, backward=backward)
        if kind == "!=":
            return _wrap("nonzero", then=self.search(ABSURD, known.assume(("=", goal[1], goal[2]))))
        if kind in RELATIONS or kind == "or":
            return self.search(goal, known)
        return None

    def _each(self, goal: Formula, known: Knowledge) -> Certificate | None:
        parts = []
        for part in goal[1:]:
            if (proof := self.prove(part, known)) is None:
                return None
            parts.append(proof)
        return {"rule": "each", "parts": parts}

    def search(self, goal: Formula, known: Knowledge) -> Certificate | None:
        """Closes the goal here, or learns something and tries again, or splits into cases."""
        self.nodes += 1
        if self.nodes > MAX_NODES:
            return None
        place = _Place(known)
        if (proof := self._close(goal, place)) is not None:
            return proof
        if (proof := self._vanish(goal, place)) is not None:
            return proof
        polys = [poly for _, poly in known.facts] + place.ideal.polys()
        products = [_Product.of(poly, known) for poly in polys]
        if (proof := self._derive(goal, place, products)) is not None:
            return proof
        if known.pending:
            return self._alternatives(goal, known)
        return self._split(goal, place, products)

    # closing

    def _close(self, goal: Formula, place: _Place) -> Certificate | None:
        if (proof := self._direct(goal, place)) is not None:
            return proof
        return self._absurd(place)

    def _direct(self, goal: Formula, place: _Place) -> Certificate | None:
        kind = goal[0]
        if kind == "=":
            cofactors = place.cofactors(place.known.ring.difference(goal))
            return None if cofactors is None else {"rule": "identity", "cofactors": written(cofactors)}
        if kind == "and":
            parts = [self._direct(part, place) for part in goal[1:]]
            return None if any(p is None for p in parts) else {"rule": "each", "parts": parts}
        if kind == "or":
            for index, part in enumerate(goal[1:]):
                if (proof := self._direct(part, place)) is not None:
                    return {"rule": "choose", "index": index, "then": proof}
        if kind in ("<", "<=", ">", ">="):
            return prove_order(goal, place.known, self.forms)
        return None

    def _absurd(self, place: _Place) -> Certificate | None:
        one = place.known.ring.number(1)
        candidates: list[tuple[list[Ref], Poly]] = [([], one)]
        candidates += [([ref], poly) for ref, poly in place.known.conditions]
        for refs, poly in candidates:
            if (cofactors := place.cofactors(poly)) is not None:
                return {"rule": "absurd", "times": refs, "cofactors": written(cofactors)}
        return None

    # learning

    def _vanish(self, goal: Formula, place: _Place) -> Certificate | None:
        """A sum of non-negative addends that is zero: each addend is."""
        own = [_expanded(poly) for _, poly in place.known.facts if 1 < len(poly) <= MAX_TERMS]
        for form in [*self.forms, *own]:
            if not (isinstance(form, tuple) and form[0] == "+"):
                continue
            signs = [place.known.sign(addend) for addend in form[1:]]
            ratio = place.known.ring.ratio(form)
            if not all(level for level, _ in signs) or ratio.den:
                continue
            addends = [place.known.ring.ratio(addend).num for addend in form[1:]]
            if all(place.cofactors(addend) is not None for addend in addends):
                continue
            cofactors = place.cofactors(ratio.num)
            if cofactors is None:
                continue
            given = sorted({item for _, names in signs for item in names})
            known = place.known.assume(("and", *(("=", addend, 0) for addend in form[1:])))
            then = self.search(goal, known)
            return _wrap("vanish", form=form, cofactors=written(cofactors), given=list(map(list, given)), then=then)
        return None

    def _derive(self, goal: Formula, place: _Place, products: Sequence[_Product]) -> Certificate | None:
        """Divides out of the facts what is not zero, and takes roots."""
        steps: list[dict[str, Any]] = []
        known, seen = place.known, {str(poly) for _, poly in place.known.facts}
        for product in products:
            if not product.shorter or str(product.radical) in seen:
                continue
            if place.ideal.reduce(product.radical) == 0:
                continue
            cofactors = place.cofactors(product.whole())
            if cofactors is None:
                continue
            steps.append(product.step(cofactors))
            known = known.with_fact(product.radical)
            seen.add(str(product.radical))
        if not steps:
            return None
        proof = self.search(goal, known)
        for step in reversed(steps):
            proof = _wrap("derive", **step, then=proof)
        return proof

    # splitting

    def _alternatives(self, goal: Formula, known: Knowledge) -> Certificate | None:
        _, disjunction = known.pending[0]
        cases = []
        for part in disjunction[1:]:
            inner = replace(known, pending=known.pending[1:]).assume(part)
            if (proof := self.search(goal, inner)) is None:
                return None
            cases.append(_shifted(proof))
        return {"rule": "cases_or", "or": 0, "cases": cases}

    def _split(self, goal: Formula, place: _Place, products: Sequence[_Product]) -> Certificate | None:
        """One of the factors of a product is zero: the shortest product first."""
        for product in sorted((p for p in products if len(p.factors) > 1), key=lambda p: p.size):
            cofactors = place.cofactors(product.whole())
            if cofactors is None or any(place.ideal.reduce(factor) == 0 for factor in product.factors):
                continue
            cases = []
            for factor in product.factors:
                proof = self.search(goal, place.known.with_fact(factor))
                if proof is None:
                    return None
                cases.append(proof)
            step = product.step(cofactors)
            return {
                "rule": "split", "factors": [str(f) for f in product.factors], "times": step["times"],
                "cofactors": step["cofactors"], "cases": cases,
            }  # fmt: skip
        return None


@dataclass(frozen=True)
class _Product:
    """A polynomial that is zero, as (things known to be non-zero) times a radical to a power."""

    factors: tuple[Poly, ...]
    times: tuple[Ref, ...]
    outside: Poly  # the product of `times`
    power: int
    radical: Poly
    shorter: bool
    size: tuple[int, int, int]

    @classmethod
    def of(cls, poly: Poly, known: Knowledge) -> _Product:
        one = known.ring.number(1)
        times: list[Ref] = []
        outside, radical, power, factors = one, one, 1, []
        for factor, exponent in poly.factor()[1] if poly != 0 else ():
            refs = known.nonzero(factor)
            if refs is None:
                factors.append(factor)
                radical, power = radical * factor, max(power, int(exponent))
                continue
            for ref in refs * int(exponent):
                times.append(ref)
                outside *= next(p for r, p in known.conditions if r == ref)
        size = (int(radical.total_degree()), len(radical), len(factors))
        shorter = bool(factors) and (bool(times) or any(e > 1 for _, e in poly.factor()[1]))
        return cls(tuple(factors), tuple(times), outside, power, radical, shorter, size)

    def whole(self) -> Poly:
        """The multiple of the polynomial that a certificate shows to be zero."""
        return self.outside * self.radical**self.power

    def step(self, cofactors: list[Fact]) -> dict[str, Any]:
        """The fields of a "derive" step."""
        return {
            "poly": str(self.radical), "power": self.power, "times": list(self.times), "cofactors": written(cofactors)
        }  # fmt: skip


def _expanded(poly: Poly) -> Term:
    """A polynomial as a sum whose first addend is positive."""
    return term_of(poly if fraction(poly.leading_coefficient()) > 0 else -poly)


def _wrap(rule: str, **parts: Any) -> Certificate | None:
    """A rule around inner proofs, None if one of them is missing."""
    if any(parts.get(name, True) is None for name in ("then", "forward", "backward")):
        return None
    return {"rule": rule, **parts}


def _shifted(proof: Any) -> Any:
    """Inner disjunctions counted with the outer one still open in front of them."""
    if isinstance(proof, dict):
        inner = {key: _shifted(value) for key, value in proof.items()}
        return {**inner, "or": proof["or"] + 1} if "or" in proof else inner
    return [_shifted(child) for child in proof] if isinstance(proof, list) else proof
