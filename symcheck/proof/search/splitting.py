"""Implications, equivalences, alternatives and inequalities: factors first, then Groebner bases, then case splits."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import RELATIONS, Formula, Term, node
from symcheck.proof.algebra.forms import term_of
from symcheck.proof.algebra.knowledge import ORDERS, Knowledge, hints_of, starting
from symcheck.proof.algebra.place import Place
from symcheck.proof.algebra.polynomial import Ring
from symcheck.proof.algebra.variables import circle, prime
from symcheck.proof.rules.absurd import absurd_at, by_conjugates, contrary_signs, of_one_sign, opposite_signs, vanishing
from symcheck.proof.rules.cases_or import split_disjunction
from symcheck.proof.rules.choose import first_of
from symcheck.proof.rules.each import all_of
from symcheck.proof.rules.identity import identity_at, identity_here, identity_times, prove_identity
from symcheck.proof.rules.implies import by_contrary, implication
from symcheck.proof.rules.nonnegative import prove_order
from symcheck.proof.rules.split import Split, shorten, split_basis, split_product
from symcheck.proof.rules.step import Attempt, Search, Step, written
from symcheck.proof.rules.vanish import vanishing_sum
from symcheck.proof.rules.witness import prove_existence
from symcheck.proof.search.angles import compares_angles, prove_about_angles
from symcheck.proof.search.theorem_search import has_functions, prove_with_theorems

MAX_NODES = 240  # places of one search: proofs of the ledger need fewer, and failures cost seconds
LONG_PROOF = 1500  # characters of a proof that `close` leaves for later


def prove(problem: Problem, ring: Ring) -> Step | None:
    """A proof of the claim, or None. Defined letters are left free first: that is the simpler proof, if it exists."""
    kind = problem.claim.tag
    if kind == "=" and (identity := prove_identity(problem, ring)) is not None:
        return identity
    hints = hints_of(problem)

    def finish(goal: Formula, known: Knowledge) -> Step | None:
        return prove_here(goal, known, hints)

    if kind != "exists" and compares_angles(ring) and (proof := prove_about_angles(problem, finish)) is not None:
        return proof
    if has_functions(ring):
        return prove_with_theorems(problem, finish)
    if kind == "exists":
        return prove_existence(problem, ring, prove_here)
    known = starting(problem, ring)
    found = prove_order(problem.claim, known, hints, problem) if kind in ORDERS else finish(problem.claim, known)
    hinted = any(isinstance(hint, Applied) for hint in problem.hints)
    if found is None and (hinted or any(prime(x) or circle(x) for x in ring.names)):  # their signs may be needed
        found = prove_with_theorems(problem, finish)
    return found


def prove_here(goal: Formula, known: Knowledge, forms: Sequence[Term] = ()) -> Step | None:
    """A proof of the goal from what is known at one place, with forms that may be zero as hints."""
    return _Engine(known, forms).prove(goal, known)


class _Engine:
    def __init__(self, known: Knowledge, forms: Sequence[Term]) -> None:
        self.root = Place(known, forms=forms)
        self.nodes = 0

    def prove(self, goal: Formula, known: Knowledge) -> Step | None:
        """A proof of any formula from what is known, by its outermost connective."""
        kind = goal.tag
        if kind == "and" and all(part.tag == "=" for part in goal.formulas):
            return self.search(goal, known) or all_of(goal, known, self.prove)
        if kind in ("and", "<=>"):
            return all_of(goal, known, self.prove)
        if kind == "=>":
            return implication(goal, known, self.prove)
        if kind == "!=":
            found = by_contrary(goal, known, self.search)
            return found or by_contrary(goal, known, lambda _, below: of_one_sign(goal, below))
        if kind in ORDERS:
            signs = self.search(goal, known) or by_contrary(goal, known, lambda _, below: opposite_signs(below))
            return signs or by_conjugates(goal, known) or contrary_signs(goal, known, products=False)
        return self.search(goal, known) if kind in RELATIONS or kind == "or" else None

    def search(self, goal: Formula, known: Knowledge, before: Place | None = None) -> Step | None:
        """Closes the goal here, or learns something and tries again, or splits into cases."""
        self.nodes += 1
        if self.nodes > MAX_NODES:
            return None
        place = Place(known, before or self.root)
        if place.contradiction is not None:
            return vanishing(place.contradiction, place.contradiction.cofactors())
        if place.shorter:
            return shorten(goal, place, self.search)
        while True:
            for light, move in MOVES:
                place.light = light
                proof, done = move(goal, place, self.search)
                if done:
                    return proof
            if not (place.waiting and place.settle()):
                found = split_basis(goal, place, self.search)
                return identity_times(goal, place) if found is None and goal.tag == "=" else found


def close(goal: Formula, place: Place, search: Search) -> Attempt:
    """By what is known here; a long proof is left for the cases of a product, in each of which it will be shorter."""
    proof = absurd_at(place) or _direct(goal, place)
    if proof is not None and place.products and len(written(proof)) > LONG_PROOF:
        return None, False
    return proof, proof is not None


def split_alternatives(goal: Formula, place: Place, search: Search) -> Attempt:
    """One of several equations holds, as the product of their differences is zero."""
    if goal.tag != "or" or any(part.tag != "=" for part in goal.formulas):
        return None, False
    known = place.known
    factors = [known.ring.subtract(*part.terms).num for part in goal.formulas]
    form = node("*", *(node("^", term_of(factor), 1) for factor in factors))
    product = identity_here(node("=", form, 0), known)
    cases = [search(goal, known.with_fact(factor), place) for factor in factors] if product else []
    proofs = tuple(case for case in cases if case is not None)
    if product is None or len(proofs) < len(factors):
        return None, False
    return Split(form, (), product.cofactors, proofs), True  # a polynomial: nothing is multiplied with it


def _direct(goal: Formula, place: Place) -> Step | None:
    match goal.tag:
        case "=":
            return identity_at(goal, place)
        case "and":
            return all_of(goal, place.known, lambda part, _: _direct(part, place))
        case "or":
            return first_of(goal, place.known, lambda part, _: _direct(part, place))
        case "<" | "<=" | ">" | ">=":
            return prove_order(goal, place.known, place.forms)
    return None


# the cheap ways first; each closes the search at a place, or leaves it to the next
MOVES: tuple[tuple[bool, Callable[[Formula, Place, Search], Attempt]], ...] = (
    (True, close),
    (True, vanishing_sum),
    (False, close),
    (False, vanishing_sum),
    (False, split_alternatives),
    (False, split_disjunction),
    (False, split_product),
)
