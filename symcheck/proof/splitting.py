"""Implications, equivalences, alternatives and inequalities: factors first, then Groebner bases, then case splits."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from symcheck.core.problems import Problem
from symcheck.core.terms import RELATIONS, Formula, Node, Term, node
from symcheck.core.verdicts import Certificate
from symcheck.proof.angles import compares_angles, prove_about_angles
from symcheck.proof.equations import cleared, prove_identity, written
from symcheck.proof.existence import prove_existence
from symcheck.proof.groebner import Monomial
from symcheck.proof.ideal import Fact, Ideal, Ref
from symcheck.proof.knowledge import Knowledge, hints_of, proportional, starting
from symcheck.proof.orders import fraction_form, positive_form, prove_order, term_of
from symcheck.proof.polynomial import Poly, Ring, fraction, power_of
from symcheck.proof.pruning import without
from symcheck.proof.theorem_search import has_functions, prove_with_theorems
from symcheck.proof.variables import prime

CONTRARY = {"<": ">=", "<=": ">", ">": "<=", ">=": "<"}
ABSURD: Formula = node("or")  # the goal of a contradiction: nothing to choose from
MAX_NODES = 240
MAX_TERMS = 14
MAX_DEGREE = 8
PAIRS = 300
LONG_PROOF = 1500  # characters

Attempt = tuple[Certificate | None, bool]  # a proof, and whether the search at this place is over


def prove(problem: Problem, ring: Ring) -> Certificate | None:
    """A proof of the claim, or None. Defined letters are left free first: that is the simpler proof, if it exists."""
    kind = problem.claim[0]
    if kind == "=" and (proof := prove_identity(problem, ring)) is not None:
        return proof
    hints = hints_of(problem)

    def finish(goal: Formula, known: Knowledge) -> Certificate | None:
        return _Engine(known, hints).prove(goal, known)

    if kind != "exists" and compares_angles(ring) and (proof := prove_about_angles(problem, finish)) is not None:
        return proof
    if has_functions(ring):
        return prove_with_theorems(problem, finish)
    if kind == "exists":
        return prove_existence(problem, ring, prove_here)
    known = starting(problem, ring)
    if kind in ("<", "<=", ">", ">="):
        proof = prove_order(problem.claim, known, hints, problem)
    else:
        proof = finish(problem.claim, known)
    if proof is None and any(prime(name) for name in ring.names):  # their signs may be needed
        proof = prove_with_theorems(problem, finish)
    return proof


def prove_here(goal: Formula, known: Knowledge) -> Certificate | None:
    """A proof of the goal from what is known at one place, without hints."""
    return _Engine(known).prove(goal, known)


class _Place:
    """Knowledge at a node of the search. Facts enter the ideal late: first those that are a variable alone, products
    never (they are split), the rest when nothing is left to split. Until then they are used in linear combinations."""

    def __init__(self, known: Knowledge, before: _Place | None = None) -> None:
        self.known = known
        self.base: Ideal = before.base if before else self._short_hypotheses()
        self._normal: dict[str, Poly] = before._normal if before else {}
        self.contradiction: _Product | None = None  # a fact that says that something non-zero is zero
        self._answers: dict[tuple[str, bool], list[Fact] | None] = {}
        self.light = False  # without the ideal, by linear combinations only
        self._ideal = before.ideal_so_far() if before else (self.base, [])
        self.rows: list[tuple[Monomial, Poly, list[Fact]]] = []
        self.monomials = [fact for fact in known.facts if len(fact[1]) == 1]
        in_base = {str(ref) for ref, _ in self.base.facts}
        for fact in known.facts:
            if len(fact[1]) > 1 and str(fact[0]) not in in_base:
                self._add_row(fact)
        self.waiting: list[Fact] = list(before.waiting) if before else []
        self.products: list[_Product] = list(before.products) if before else []
        self.shorter: list[_Product] = []
        for fact in known.facts[len(before.known.facts) if before else len(known.facts) :]:
            product = _Product.of(fact, known)
            if product.times and not product.factors:
                self.contradiction = product
            elif product.shorter:
                self.shorter.append(product)
            elif len(product.factors) > 1 and not _is_square_minus_number(fact[1]):
                self.products.append(product)
            elif len(fact[1]) == 1:
                self._ideal = (self._ideal[0], [*self._ideal[1], fact])
            else:
                self.waiting.append(fact)

    def _short_hypotheses(self) -> Ideal:
        """The ideal of what is short among the hypotheses; the long ones are used in linear combinations only."""
        short = [fact for fact in self.known.facts if _short(fact[1])]
        return Ideal(self.known.ring, [*self.known.ring.axioms(), *short])

    def _strip(self, poly: Poly) -> tuple[Poly, list[Fact]]:
        """(rest, quotients) of the division by the facts that are monomials."""
        quotients: list[Fact] = []
        for ref, monomial in self.monomials:
            quotient, poly = divmod(poly, monomial)
            if quotient != 0:
                quotients.append((ref, quotient))
        return poly, quotients

    def _thin(self, poly: Poly) -> Poly:
        """What monomials and hypotheses leave of a polynomial; linear in it."""
        return self._strip(self.normal(self._strip(poly)[0]))[0]

    def normal(self, poly: Poly) -> Poly:
        """The normal form modulo the hypotheses."""
        text = str(poly)
        if text not in self._normal:
            self._normal[text] = self.base.reduce(poly)
        return self._normal[text]

    def ideal_so_far(self) -> tuple[Ideal, list[Fact]]:
        """The ideal worked out last and the facts to enter it next."""
        return self._ideal

    @property
    def ideal(self) -> Ideal:
        """The hypotheses and the facts let in so far; worked out when first needed."""
        if self._ideal[1]:
            self._ideal = (self._ideal[0].extended(self._ideal[1], PAIRS), [])
        return self._ideal[0]

    def _add_row(self, fact: Fact) -> None:
        """One more row of the echelon form of the facts modulo the hypotheses."""
        row, combination = self._eliminate(self._thin(fact[1]))
        if row != 0:
            scale = row.leading_coefficient()
            combination = [(ref, -q) for ref, q in combination] + [(fact[0], self.known.ring.number(1))]
            self.rows.append((tuple(map(int, row.monomial(0))), row / scale, [(r, q / scale) for r, q in combination]))

    def _eliminate(self, poly: Poly) -> tuple[Poly, list[Fact]]:
        used: list[Fact] = []
        for lead, row, combination in self.rows:
            coefficient = poly[lead]
            if coefficient != 0:
                poly -= row * coefficient
                used += [(ref, q * coefficient) for ref, q in combination]
        return poly, merged(used)

    def relatives(self) -> list[Poly]:
        """The hypotheses with squares replaced by the numbers they are said to be here."""
        squares = [poly for _, poly in self.waiting if _is_square_minus_number(poly)]
        found = []
        for _, poly in self.base.facts if squares else ():
            rest = poly
            for square in squares:
                rest = divmod(rest, square)[1]
            if len(rest) < len(poly):
                found.append(rest)
        return found

    def settle(self) -> bool:
        """Lets the waiting facts into the ideal; False if none was waiting."""
        facts = [f for f in self.waiting if _short(f[1])]
        self.waiting = []
        self._answers = {}
        self._ideal = (self._ideal[0], [*self._ideal[1], *facts])
        return bool(facts)

    def vanishes(self, poly: Poly) -> bool:
        """Whether the polynomial is zero by what is in the ideal so far."""
        return bool(self._eliminate(self._thin(poly))[0] == 0 or self.ideal.reduce(poly) == 0)

    def cofactors(self, poly: Poly) -> list[Fact] | None:
        """The polynomial as a combination of facts: of few, if that is enough."""
        if poly == 0:
            return []
        key = str(poly), self.light
        if key not in self._answers:
            self._answers[key] = self._find_cofactors(poly)
        return self._answers[key]

    def _find_cofactors(self, poly: Poly) -> list[Fact] | None:
        rest, used = self._eliminate(self._thin(poly))
        if rest == 0:
            known = {str(ref): fact for ref, fact in self.known.facts}
            for ref, q in used:
                poly -= q * known[str(ref)]
            poly, before = self._strip(poly)
            normal = self.normal(poly)
            outer = self.base.cofactors(poly - normal) or []
            return merged([*before, *outer, *self._strip(normal)[1], *used])
        return None if self.light or self.ideal is self.base else self.ideal.cofactors(poly)

    def of_term(self, term: Term) -> list[Fact] | None:
        """Cofactors of a term by its structure: a product is zero as soon as one factor is."""
        kind, rest = (term.tag, term.terms) if isinstance(term, Node) else ("", ())
        if kind == "+":
            parts = [self.of_term(t) for t in rest]
            if all(p is not None for p in parts):
                return merged([f for p in parts for f in p or ()])
        if isinstance(term, Node) and kind == "^":
            base, exponent = power_of(term)
            if (found := self._multiple(base, node("^", base, exponent - 1))) is not None:
                return found
        if kind == "*":
            for k, factor in enumerate(rest):
                found = self._multiple(factor, node("*", 1, *rest[:k], *rest[k + 1 :]))
                if found is not None:
                    return found
        ratio = self.known.ring.ratio(term)
        return None if ratio.den else self.cofactors(ratio.num)

    def _multiple(self, factor: Term, rest: Term) -> list[Fact] | None:
        found = self.of_term(factor)
        if found is None or (ratio := self.known.ring.ratio(rest)).den:
            return None
        return [(ref, q * ratio.num) for ref, q in found]


def _may_be_sum_of_squares(poly: Poly) -> bool:
    """Whether all coefficients have one sign and no addend is a number."""
    signs = {coefficient > 0 for coefficient in poly.coeffs()}
    return len(signs) == 1 and sum(map(int, poly.monomial(len(poly) - 1))) > 0


def _is_square_minus_number(poly: Poly) -> bool:
    """x^2 - r: it says more as it stands than split into x = s or x = -s."""
    return len(poly) == 2 and poly.total_degree() == 2 and sum(map(int, poly.monomial(1))) == 0


def _short(poly: Poly) -> bool:
    return len(poly) <= MAX_TERMS and poly.total_degree() <= MAX_DEGREE


def merged(cofactors: Sequence[Fact]) -> list[Fact]:
    """Cofactors of the same fact added up."""
    total: dict[str, Fact] = {}
    for ref, q in cofactors:
        known = total.get(str(ref))
        total[str(ref)] = (ref, q if known is None else known[1] + q)
    return [fact for fact in total.values() if fact[1] != 0]


class _Engine:
    def __init__(self, known: Knowledge, forms: Sequence[Term] = (), limit: int = MAX_NODES) -> None:
        self.root = _Place(known)
        self.forms = list(forms)
        self.limit = limit
        self.nodes = 0

    def prove(self, goal: Formula, known: Knowledge) -> Certificate | None:
        """A proof of any formula from what is known, by its outermost connective."""
        kind, parts = goal.tag, goal.formulas
        if kind == "and":
            together = all(part.tag == "=" for part in parts)
            return (self.search(goal, known) if together else None) or self._each(goal, known)
        if kind == "=>":
            return _wrap("implies", then=self.prove(parts[1], known.assume(parts[0])))
        if kind == "<=>":
            return self._each(node("and", node("=>", *parts), node("=>", *parts[::-1])), known)
        if kind == "!=":
            return _wrap("implies", then=self.search(ABSURD, known.assume(node("=", *goal.terms))))
        if kind in RELATIONS or kind == "or":
            return self.search(goal, known) or (self._contrary(goal, known) if kind in CONTRARY else None)
        return None

    def _contrary(self, goal: Formula, known: Knowledge) -> Certificate | None:
        """An order follows if its contrary contradicts a sign that is known."""
        below = known.assume(node(CONTRARY[goal.tag], *goal.terms))
        return _wrap("implies", then=_opposite_signs(below))

    def _each(self, goal: Formula, known: Knowledge) -> Certificate | None:
        parts = []
        for part in goal.formulas:
            if (proof := self.prove(part, known)) is None:
                return None
            parts.append(proof)
        return {"rule": "each", "parts": parts}

    def search(self, goal: Formula, known: Knowledge, before: _Place | None = None) -> Certificate | None:
        """Closes the goal here, or learns something and tries again, or splits into cases."""
        self.nodes += 1
        if self.nodes > self.limit:
            return None
        place = _Place(known, before or self.root)
        if (product := place.contradiction) is not None:
            return {"rule": "absurd", **product.grounds(product.cofactors())}
        if place.shorter:
            return self._shorten(goal, place)
        while True:
            for light, move in _MOVES:
                place.light = light
                proof, done = move(self, goal, place)
                if done:
                    return proof
            if place.waiting and place.settle():
                continue
            return self._from_basis(goal, place)

    # closing

    def _close(self, goal: Formula, place: _Place) -> Attempt:
        proof = self._absurd(place) or self._direct(goal, place)
        if proof is not None and place.products and len(str(proof)) > LONG_PROOF:
            return None, False  # in each case of a product it will be shorter
        return proof, proof is not None

    def _direct(self, goal: Formula, place: _Place) -> Certificate | None:
        kind = goal[0]
        if kind == "=":
            cofactors = self._through_form(goal, place) or place.cofactors(place.known.ring.difference(goal))
            clear = cleared(place.known.ring.subtract(*goal.terms))
            return None if cofactors is None else {"rule": "identity", **clear, "cofactors": written(cofactors)}
        if kind == "and":
            parts = [self._direct(part, place) for part in goal.formulas]
            return None if any(p is None for p in parts) else {"rule": "each", "parts": parts}
        if kind == "or":
            for index, part in enumerate(goal.formulas):
                if (proof := self._direct(part, place)) is not None:
                    return {"rule": "choose", "index": index, "then": proof}
        if kind in ("<", "<=", ">", ">="):
            return prove_order(goal, place.known, self.forms)
        return None

    def _through_form(self, goal: Formula, place: _Place) -> list[Fact] | None:
        """left - right is a multiple of a hinted form by linear combination, and the form is zero here."""
        gap = place.known.ring.difference(goal)
        for form in self.forms:
            ratio = place.known.ring.ratio(form)
            if ratio.den or (inner := place.of_term(form)) is None:
                continue
            for factor in (proportional(place.normal(gap), place.normal(ratio.num)) or 1, -1):
                multiple = place.known.ring.number(factor)
                outer = place.cofactors(gap - ratio.num * multiple)
                if outer is not None:
                    return merged([*outer, *((ref, q * multiple) for ref, q in inner)])
        return None

    def _absurd(self, place: _Place) -> Certificate | None:
        if (proof := _opposite_signs(place.known)) is not None:
            return proof
        one = place.known.ring.number(1)
        candidates: list[tuple[list[Ref], Poly]] = [([], one)]
        candidates += [([ref], poly) for ref, poly in place.known.conditions]
        for refs, poly in candidates:
            if (cofactors := place.cofactors(poly)) is not None:
                return {"rule": "absurd", "times": refs, "cofactors": written(cofactors)}
        return None

    # learning

    def _vanish(self, goal: Formula, place: _Place) -> Attempt:
        """A sum of non-negative addends that is zero: each addend is."""
        ring = place.known.ring
        polys = [poly for _, poly in place.known.facts]
        polys += place.relatives()
        own = [_expanded(poly) for poly in polys if 1 < len(poly) <= MAX_TERMS and _may_be_sum_of_squares(poly)]
        for form in [*self.forms, *own]:
            if not (isinstance(form, tuple) and form[0] == "+"):
                continue
            signs = [place.known.sign(addend) for addend in form[1:]]
            if not all(level for level, _ in signs) or any(ring.ratio(addend).den for addend in form[1:]):
                continue
            radicals = [_Product.of(([], ring.ratio(addend).num), place.known).radical for addend in form[1:]]
            if all(place.cofactors(radical) is not None for radical in radicals):
                continue
            cofactors = place.cofactors(ring.ratio(form).num)
            if cofactors is None:
                continue
            given = sorted({item for _, names in signs for item in names})
            known = place.known.assume(node("and", *(node("=", addend, 0) for addend in form[1:])))
            then = self.search(goal, known, place)
            step = {"form": form, "cofactors": written(cofactors), "given": list(map(list, given))}
            added = range(place.known.count, known.count)
            return (then and without(then, added)) or _wrap("vanish", **step, then=then), True
        return None, False

    def _shorten(self, goal: Formula, place: _Place) -> Certificate | None:
        """Divides out of the new facts what is not zero, and takes roots."""
        steps: list[_Product] = []
        known, seen = place.known, {str(poly) for _, poly in place.known.facts}
        for product in place.shorter:
            if str(product.radical) not in seen:
                steps.append(product)
                known = known.with_fact(product.radical)
                seen.add(str(product.radical))
        place.shorter = []
        proof = self.search(goal, known, place)
        for number, product in reversed([*enumerate(steps, place.known.count)]):
            proof = product.split([product.radical], product.cofactors(), [proof], number)
        return proof

    def _from_basis(self, goal: Formula, place: _Place) -> Certificate | None:
        """What the elements of the Groebner basis say when something non-zero is divided out, or split."""
        products = [_Product.of((["basis"], poly), place.known) for poly in place.ideal.polys()]
        for product in products:
            if not product.factors and product.times and (cofactors := place.cofactors(product.whole())) is not None:
                return {"rule": "absurd", **product.grounds(cofactors)}
        products = [p for p in products if p.factors and (p.shorter or len(p.factors) > 1)]
        for product in sorted(products, key=lambda p: (len(p.factors), p.size)):
            if any(place.vanishes(factor) for factor in product.factors):
                continue
            cofactors = place.cofactors(product.whole())
            if cofactors is None:
                continue
            if len(product.factors) > 1:
                return self._cases(goal, place, product, cofactors)
            then = self.search(goal, place.known.with_fact(product.radical), place)
            return product.split([product.radical], cofactors, [then], place.known.count)
        return None

    def _alternatives(self, goal: Formula, place: _Place) -> Attempt:
        known = place.known
        if not known.pending:
            return None, False
        ref, disjunction = known.pending[0]
        cases = []
        for part in disjunction.formulas:
            inner = replace(known, pending=known.pending[1:]).assume(part)
            if (proof := self.search(goal, inner, place)) is None:
                return None, True
            cases.append(proof)
        return {"rule": "cases_or", "or": ref, "cases": cases}, True

    def _split(self, goal: Formula, place: _Place) -> Attempt:
        """One of the factors of a fact is zero: the shortest fact first."""
        for product in sorted(place.products, key=lambda p: p.size):
            place.products.remove(product)
            if not any(place.vanishes(factor) for factor in product.factors):
                return self._cases(goal, place, product, product.cofactors()), True
        return None, False

    def _cases(self, goal: Formula, place: _Place, product: _Product, cofactors: list[Fact]) -> Certificate | None:
        cases: list[Certificate | None] = []
        for factor in product.factors:
            if (proof := self.search(goal, place.known.with_fact(factor), place)) is None:
                return None
            cases.append(proof)
            if without(proof, [place.known.count]) is not None:  # the other cases are like this one
                break
        return product.split(product.factors, cofactors, cases, place.known.count)


def _opposite_signs(known: Knowledge) -> Certificate | None:
    """A contradiction: something positive that is zero, the sum of what was assumed last and of its negative."""
    for sign in (*known.fractions[::-1], *known.signs[::-1])[:2]:
        if sign.ref[0] != "here":
            continue
        others = replace(
            known,
            signs=tuple(s for s in known.signs if s is not sign),
            fractions=tuple(s for s in known.fractions if s is not sign),
        )
        form = fraction_form(node("-", sign.term), others)
        if form is not None and (level := known.sign(form)[0]) and sign.level + level > 2:
            given = sorted(map(list, known.sign(form)[1]))
            whole: Term = node("+", sign.term, form)
            return {"rule": "absurd", "times": [["positive", whole]], "cofactors": [], "given": given}
    return None


# the cheap ways first; each closes the search at a place, or leaves it to the next
_MOVES = (
    (True, _Engine._close),
    (True, _Engine._vanish),
    (False, _Engine._close),
    (False, _Engine._vanish),
    (False, _Engine._alternatives),
    (False, _Engine._split),
)


@dataclass(frozen=True)
class _Product:
    """A polynomial that is zero, as (things known to be non-zero) times a radical to a power."""

    factors: tuple[Poly, ...]
    times: tuple[Ref, ...]
    outside: Poly  # the product of `times`
    power: int
    radical: Poly
    shorter: bool
    given: tuple[tuple[str, int], ...]
    size: tuple[int, int, int]
    fact: Fact

    @classmethod
    def of(cls, fact: Fact, known: Knowledge) -> _Product:
        """The product a fact is, given what is known not to be zero."""
        poly = fact[1]
        one = known.ring.number(1)
        times: list[Ref] = []
        outside, radical, power, factors = one, one, 1, []
        for factor, exponent in poly.factor()[1] if poly != 0 else ():
            refs, value = _nonzero(factor, known)
            if refs is None:
                factors.append(factor)
                radical, power = radical * factor, max(power, int(exponent))
                continue
            times += refs * int(exponent)
            outside *= value ** int(exponent)
        forms = [ref[1] for ref in times if ref[0] == "positive"]
        given = tuple(sorted({item for form in forms for item in known.sign(form)[1]}))
        size = (int(radical.total_degree()), len(radical), len(factors))
        shorter = bool(factors) and (bool(times) or any(e > 1 for _, e in poly.factor()[1]))
        return cls(tuple(factors), tuple(times), outside, power, radical, shorter, given, size, fact)

    def whole(self) -> Poly:
        """The multiple of the polynomial that a certificate shows to be zero."""
        return self.outside * self.radical**self.power

    def cofactors(self) -> list[Fact]:
        """That multiple as a multiple of the fact itself."""
        return [(self.fact[0], divmod(self.whole(), self.fact[1])[0])]

    def split(
        self, bases: Sequence[Poly], cofactors: list[Fact], cases: list[Certificate | None], number: int
    ) -> Certificate | None:
        """The rule "split": one of the bases is zero; with one base that is a derivation, not a case.

        A case that does without what is assumed there, under that number, is a proof by itself.
        """
        if None in cases:
            return None
        shorter: list[Certificate | None] = [without(case, [number]) for case in cases]
        if any(shorter):
            return next(filter(None, shorter))
        factors = [[str(base), self.power] for base in bases]
        return {"rule": "split", "factors": factors, **self.grounds(cofactors), "cases": cases}

    def grounds(self, cofactors: list[Fact]) -> dict[str, Any]:
        """Why the product is zero."""
        given = [list(item) for item in self.given]
        return {"times": list(self.times), "cofactors": written(cofactors), "given": given}


def _nonzero(poly: Poly, known: Knowledge) -> tuple[list[Ref] | None, Poly]:
    """References that say that the polynomial is not zero, and the multiple of it they speak of."""
    memory = known.ring.memory
    key = (str(poly), tuple(map(id, known.conditions)), tuple(map(id, known.signs)))
    if key not in memory:  # the knowledge is kept beside the answer so that the ids stay its own
        memory[key] = known, _find_nonzero(poly, known)
    found: tuple[list[Ref] | None, Poly] = memory[key][1]
    return found


def _find_nonzero(poly: Poly, known: Knowledge) -> tuple[list[Ref] | None, Poly]:
    for ref, condition in known.conditions:
        if proportional(poly, condition) is not None:
            return [ref], condition
    for candidate in (poly, -poly):
        form = positive_form(candidate, known)
        if form is not None and known.sign(form)[0] == 2:
            return [["positive", form]], known.ring.poly(form)
    return None, poly


def _expanded(poly: Poly) -> Term:
    """A polynomial as a sum whose first addend is positive."""
    return term_of(poly if fraction(poly.leading_coefficient()) > 0 else -poly)


def _wrap(rule: str, **parts: Any) -> Certificate | None:
    """A rule around inner proofs, None if one of them is missing."""
    if any(parts.get(name, True) is None for name in ("then",)):
        return None
    return {"rule": rule, **parts}
