"""Witnesses: an exact point at which everything a statement rests on holds together, so that it is not true for want
of a case.

A witness is a counterexample to "0 = 1", and is found as one: its form is that of a counterexample's point.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import chain, islice, product

from symcheck.checker.enclosures import enclosed
from symcheck.core.calculus import Unknown, domain, letters, substituted
from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Problem
from symcheck.core.terms import PI, RELATIONS, Formula, Node, Term, node
from symcheck.proof.algebra.flint import Poly, by_powers, fraction, occurring
from symcheck.proof.algebra.knowledge import stated
from symcheck.proof.algebra.polynomial import alone, subterms, unfold, with_arguments
from symcheck.proof.algebra.variables import Unsupported, atoms, circle, cosine, sine
from symcheck.proof.rules.compute import Point
from symcheck.proof.rules.proof import Prover
from symcheck.proof.search.counterexample import Assignment, Search, Solved, refute
from symcheck.proof.search.number_points import TRIED, inside, refute_at_first
from symcheck.proof.search.values import computed, owed_by, with_values

ZERO_IS_ONE: Formula = node("=", 0, 1)
DRAWS = 3000  # points: the papers' witnesses are among the first 1,900
TRIALS = 60  # points evaluated by digits, of which the papers need two
SMALL, FEW = (1, 2, 3), 3  # whole numbers that are tried for so many letters where no integral is known at a point
_ARCS = ("arctan", "arcsin", "arccos")
Pool = tuple[int | Fraction, ...]
# numbers that a reader can follow, small ones first
VALUES: Pool = (
    *(1, -1, 0, *range(2, 6), *range(-2, -6, -1)),
    *(
        Fraction(n, d)
        for n, d in ((1, 2), (1, 3), (2, 3), (1, 4), (3, 4), (3, 5), (4, 5), (2, 7), (3, 7), (6, 7), (1, 10), (-1, 2))
    ),
)
POSITIVE = tuple(value for value in VALUES if value > 0)
# in turn: few values solve what has many equations, zeros what has many letters
POOLS: tuple[Pool, ...] = (VALUES[:2], VALUES[:4], VALUES, POSITIVE, (0, 0, 0, 1, -1))
Definitions = tuple[tuple[str, Term], ...]


def implications(claim: Formula) -> list[Formula]:
    """The premises of a claim that is an implication, or a conjunction with implications.

    "A => 0 = 1" is how it is said that A never holds: that has no premise.
    """
    found: list[Formula] = []
    for part in conjuncts(claim):
        if part.tag == "=>" and part.formulas[1] not in (ZERO_IS_ONE, node("or")):
            premise, conclusion = part.formulas
            found += [node("and", premise, further) for further in implications(conclusion)] or [premise]
    return found


def find_witnesses(
    problem: Problem, nonzero: Sequence[Term] = (), prove: Prover = lambda _: None
) -> list[Point] | None:
    """Points where the hypotheses hold, definitions have values and the terms `nonzero` are not zero; None if none.

    One point for all implications of the claim, where their premises hold too; or, where there is no such point or it
    is not found, one for each of them.
    """
    premises = implications(problem.claim)
    together = _witness(problem, nonzero, premises, prove)
    points = [together]
    if together is None and len(premises) > 1:
        points = [_witness(problem, nonzero, [premise], prove) for premise in premises]
    found = [whole for point in points if point and (whole := with_values(problem, point, prove)) is not None]
    if len(found) < len(points) and None not in points and len(premises) < 2:  # of whole numbers more is known
        whole_ones = (with_values(problem, point, prove) for point in _small(problem, nonzero, premises))
        found = [*islice(filter(None, whole_ones), 1)]
    return found if len(found) == len(points) else None


def _small(problem: Problem, nonzero: Sequence[Term], premises: Sequence[Formula]) -> Iterator[Point]:
    """Points of a few small whole numbers where digits tell that all hypotheses hold that are orders."""
    given = [formula for _, formula in stated(problem)]
    given += [part for premise in premises for part in conjuncts(premise)]
    said = (*given, *(node("!=", term, 0) for term in nonzero), *domain(problem.claim, *given, divisors=True))
    names = sorted(set().union(*map(letters, (problem.claim, *said))))
    if problem.definitions or len(names) > FEW or any(f.tag not in ("<", "<=", ">", ">=", "!=") for f in said):
        return
    for numbers in product(SMALL, repeat=len(names)):
        point = Point(values=dict(zip(names, numbers, strict=True)))
        if all(_is_met(formula, point, {}) for formula in said):
            yield point


def _witness(problem: Problem, nonzero: Sequence[Term], premises: Sequence[Formula], prove: Prover) -> Point | None:
    given = [formula for _, formula in stated(problem)]
    given += [part for premise in premises for part in conjuncts(premise)]
    given += [node("!=", term, 0) for term in nonzero if not _plainly_nonzero(term)]
    definitions = dict(problem.definitions)
    reached = [term for _, term in problem.definitions]
    conditions = domain(*given, *reached, divisors=True)
    said = tuple(dict.fromkeys((*given, *conditions)))
    under = [each for each in owed_by(problem) if computed(each)]
    # that the claim has a value is often plain
    meant = tuple(dict.fromkeys((*said, *domain(problem.claim, divisors=True), *under)))
    if meant != said and (point := _search(problem.definitions, meant, prove)) is not None:
        return point
    point = _witness_of(problem, said, given, prove)
    own = [*domain(problem.claim), *under]
    return point if point is not None and all(_is_met(formula, point, definitions) for formula in own) else None


def _is_met(condition: Formula, point: Point, definitions: dict[str, Term]) -> bool:
    """Whether digits tell that a condition for a value is met at a point."""
    left, right = condition.terms
    try:
        gap = unfold(node("+", left, node("-", right)), definitions)
        for _ in point.values:  # coordinates may be given by others
            gap = substituted(gap, point.values)
        digits = enclosed(gap)
    except (Unknown, RecursionError):
        return False
    met = {">": digits.low > 0, ">=": digits.high >= 0, "<=": digits.low <= 0, "<": digits.high < 0}
    met["!="] = met[">"] or met["<"]
    return met[condition.tag]


def _witness_of(problem: Problem, said: tuple[Formula, ...], given: list[Formula], prove: Prover) -> Point | None:
    """A point where all this is so; nothing is asked of the terms of the claim."""
    definitions = dict(problem.definitions)
    used = {
        part for formula in said for part in subterms(*with_definitions(definitions, formula)) if isinstance(part, str)
    }
    needed = tuple((x, term) for x, term in problem.definitions if x in used)
    concluded = problem.claim.formulas[1] if problem.claim.tag == "=>" else problem.claim
    if (point := _search(needed, said, prove)) is not None or concluded.tag != "=" or not given:
        return point
    found = _search(problem.definitions, tuple(dict.fromkeys((*said, concluded))), prove)  # it is proved, so true
    found = found or _defining(concluded, problem.definitions, said, prove)
    return found or _proving(concluded, problem.definitions, said, prove)


def _defining(concluded: Formula, definitions: Definitions, said: tuple[Formula, ...], prove: Prover) -> Point | None:
    """The same where a letter is what it is concluded to be, which may be no combination of roots: 2 / pi."""
    letter, said_to_be = concluded.terms
    term = unfold(said_to_be, dict(definitions))
    names = {part for part in subterms(term) if isinstance(part, str)}
    if not isinstance(letter, str) or letter in {*names, *dict(definitions)}:
        return None
    point = _search((*definitions, (letter, term)), said, prove)
    if point is None or not names <= {*point.values}:
        return None
    return replace(point, values={**point.values, letter: substituted(term, point.values)})


def _proving(concluded: Formula, definitions: Definitions, said: tuple[Formula, ...], prove: Prover) -> Point | None:
    """The same where that the equations hold there has proofs: e^t = 2 for t = ln 2."""
    given = [unfold(formula, dict(definitions)) for formula in said]
    letter, term = concluded.terms[0], unfold(concluded.terms[1], dict(definitions))
    names = sorted(set().union(letters(term), *map(letters, given)) - {letter})
    if not isinstance(letter, str) or letter in {*letters(term), *dict(definitions)} or len(names) > FEW:
        return None
    equations = [formula for formula in given if formula.tag == "="]
    if not equations or any(formula.tag not in RELATIONS for formula in given):
        return None
    for numbers in product(SMALL, repeat=len(names)):
        values: dict[str, Term] = dict(zip(names, numbers, strict=True))
        values[letter] = substituted(term, values)
        point = Point(values)
        if all(_is_met(formula, point, {}) for formula in given if formula.tag != "="):
            closed = [substituted(formula, values) for formula in equations]
            proofs = [prove(Problem("value", formula)) for formula in closed]
            if all(proof is not None and not proof.nonzero for proof in proofs):
                shown = zip(closed, proofs, strict=True)
                return replace(point, facts=tuple((formula, proof.step) for formula, proof in shown if proof))
    return None


def _plainly_nonzero(term: Term) -> bool:
    """Whether a term is a number, and its digits say that it is not zero."""
    try:
        digits = enclosed(term)
    except (Unknown, RecursionError):
        return False
    return digits.low > 0 or digits.high < 0


def with_definitions(definitions: Mapping[str, Term], *trees: Term) -> list[Term]:
    """Terms or formulas, and the definitions they rest on."""
    open_, seen, found = [*trees], set[str](), list[Term]()
    while open_:
        found.append(part := open_.pop())
        names = {name for name in subterms(part) if isinstance(name, str)} & definitions.keys() - seen
        open_ += [definitions[name] for name in sorted(names)]
        seen |= names
    return found


_FOUND: dict[tuple[Definitions, tuple[Formula, ...]], Point | None] = {}  # the same hypotheses stand in many problems


def _search(definitions: Definitions, said: tuple[Formula, ...], prove: Prover) -> Point | None:
    key = definitions, said
    if key not in _FOUND:
        problem = Problem("witness", ZERO_IS_ONE, definitions, (("said", said),))
        with alone(problem):
            point = _by_digits(problem, (*_ARCS, "pi")) or refute(problem, prove) or _drawn(problem, prove)
            point = point or _by_digits(problem, ("sin", "cos", "exp", "log"))
        _FOUND[key] = point and point.where()
    return _FOUND[key]


def _by_digits(problem: Problem, about: tuple[str, ...]) -> Point | None:
    """Where these functions occur: letters that are numbers, and trials for the others, by their digits."""
    said = problem.hypotheses[0][1]
    definitions = dict(problem.definitions)
    parts = [*subterms(*with_definitions(definitions, *said))]
    if not any(isinstance(part, Node) and part.tag in about for part in parts):
        return None
    absurd = replace(problem, claim=node("=", PI, 0))
    fixed = {side for f in said if f[0] == "=" for side in f[1:] if isinstance(side, str)}
    free = sorted({part for part in parts if isinstance(part, str)} - fixed - dict(problem.definitions).keys())
    draws = [random.Random(seed) for seed in range(TRIALS)]
    points = ({x: draw.choice(TRIED) if seed else TRIED[0] for x in free} for seed, draw in enumerate(draws))
    return refute_at_first(absurd, chain(points, inside(problem, free)))


def _drawn(problem: Problem, prove: Prover) -> Point | None:
    try:
        return _Draws(problem, ZERO_IS_ONE, prove).run()
    except Unsupported:
        return None


class _Draws(Search):
    """Letters drawn at random, the same in every run; what an equation says of the last letter in it is solved for."""

    primes = (2, 3, 5, 7)

    def _candidates(self, angles: Sequence[str]) -> Iterator[Assignment]:
        scalars = [name for name in self.free if circle(name) is None]
        if any(self._impossible(formula) for formula in self.formulas):
            return
        steps, equations = self._eliminated([poly for poly in self._equations() if poly != 0], scalars)
        last = dict(self._said_by_functions(scalars))
        left = [name for name in scalars if name not in last and name not in [x for x, _, _ in steps]]
        for seed in range(DRAWS):
            if self.tries == 0:
                return
            rng = random.Random(seed)
            point: Assignment = {}
            drawn = self._draw(rng, point, [*left, *angles], equations, POOLS[seed % len(POOLS)])
            if drawn and self._complete(point, steps) and self._ordered(point) and self._evaluate(point):
                try:
                    point.update({x: self._side(term, point) for x, term in last.items()})
                except ZeroDivisionError:
                    continue
                yield point

    def _impossible(self, formula: Formula) -> bool:
        """Whether both sides of an order are the same, or those of an equation differ by a number."""
        if formula[0] not in RELATIONS:
            return False
        gap = self._gap(formula).num
        if formula[0] == "=":
            return bool(gap != 0 and gap.is_constant())
        return bool(gap == 0 and formula[0] in ("!=", "<", ">"))

    def _said_by_functions(self, scalars: Sequence[str]) -> Iterator[tuple[str, Term]]:
        """Letters with what they are said to be, where that has functions in it; nothing else depends on them."""
        inside = set().union(*(with_arguments({name}) - {name} for name in self.functions))
        for f in self.formulas:
            letter, term = f.terms if f.tag == "=" else (0, 0)
            if isinstance(letter, str) and letter in scalars and letter not in inside and self._functions_in(f):
                others = [self._gap(g).num for g in self.formulas if g.tag == "=" and g is not f]
                if letter not in set().union(*map(occurring, others)):
                    yield letter, term

    def _settle(self, name: str, point: Assignment) -> bool:
        """Gamma functions of small whole numbers only; others are not worth a search."""
        kind, *arguments = atoms()[name]
        if kind == "gamma":
            value = self._side(arguments[0], point)
            if value not in (1, 2, 3, 4):
                return False
        return super()._settle(name, point)

    def _eliminated(self, equations: list[Poly], scalars: Sequence[str]) -> tuple[list[Solved], list[Poly]]:
        """What can be solved without division by letters, in order of solution, and the other equations."""
        steps: list[Solved] = []
        while True:
            found = next(
                ((p, x) for p in sorted(equations, key=len) for x in scalars if self._number_times(p, x)), None
            )
            if found is None:
                return steps[::-1], equations
            equation, x = found
            steps.append(self._linear(equation, x))
            equations = self._eliminated_from([p for p in equations if p is not equation], steps[-1])

    def _number_times(self, poly: Poly, x: str) -> bool:
        """Whether a polynomial is a number times x, plus what does not depend on x."""
        powers = by_powers(poly, x)
        return max(powers) == 1 and occurring(powers[1]) <= self.roots.keys()

    def _draw(
        self,
        rng: random.Random,
        point: Assignment,
        left: list[str],
        equations: Sequence[Poly],
        values: Pool,
    ) -> bool:
        """Gives letters and angles values, in a random order; False if an equation has no root."""
        left = rng.sample(left, len(left))
        open_ = list(equations)
        while True:
            open_ = [poly for poly in open_ if poly != 0]
            alone = ((poly, among) for poly in open_ if len(among := self._about(poly)) < 2)
            poly, among = next(alone, (None, set()))
            if poly is None and not left:
                return True
            name = left[-1] if poly is None else next(iter(among), "")
            if not name:
                return False
            fixed = self._fixed(rng, name, poly, values)
            if fixed is None:
                return False
            left.remove(name)
            point.update(fixed)
            open_ = [self._reduce(self._at(poly, fixed)) for poly in open_]

    def _about(self, poly: Poly) -> set[str]:
        """The letters of a polynomial; an angle in place of its sine and cosine."""
        return {(circle(name) or ("", name))[1] for name in self._unknown(poly)}

    def _fixed(self, rng: random.Random, name: str, poly: Poly | None, values: Pool) -> Assignment | None:
        """A letter or an angle with a value drawn, or the one that an equation says it has."""
        sign = rng.choice((1, -1))
        if name in self.free:
            value = self.ring.number(rng.choice(values)) if poly is None else self._zero(poly, name, sign)
            return None if value is None else {name: value}
        if poly is None:
            choices = self._angle(name, 0).choices
            return rng.choice(choices) if choices else None
        s, c = sine(name), cosine(name)
        poly = divmod(poly, self.ring.generator[s] ** 2 + self.ring.generator[c] ** 2 - 1)[1]
        square, other = (s, c) if max(by_powers(poly, s), default=0) < 2 else (c, s)
        _, slope, rest = self._linear(poly, square)
        if slope == 0:
            found = self._zero(rest, other, sign)
            return None if found is None else self._on_circle(other, found, square, rng.choice((1, -1)))
        found = self._zero(self._reduce(rest**2 - slope**2 * (1 - self.ring.generator[other] ** 2)), other, sign)
        if found is None:
            return None
        top, bottom = (self._reduce(self._at(each, {other: found})) for each in (-rest, slope))
        return {other: found, square: self._quotient(top, bottom)} if bottom != 0 else None

    def _on_circle(self, name: str, value: Poly, other: str, sign: int) -> Assignment | None:
        """A point of the unit circle with one coordinate."""
        found = self._zero(self.ring.generator[other] ** 2 + self._reduce(value**2) - 1, other, sign)
        return None if found is None else {name: value, other: found}

    def _possible(self, function: Term, numbers: Mapping[str, Term]) -> Iterator[Term]:
        """Also the whole number that it is said to be."""
        yield from super()._possible(function, numbers)
        said = (f for f in self.formulas if f[0] == "=" and isinstance(f[2], int))
        yield from (f[2] for f in said if unfold(f[1], self.ring.definitions) == function)

    def _unknown(self, poly: Poly) -> list[str]:
        """The variables of a polynomial that are no roots of numbers."""
        used = occurring(poly) - self.roots.keys() - {"pi"}
        return [name for name in self.ring.names if name in used]

    def _zero(self, poly: Poly, x: str, sign: int) -> Poly | None:
        """A zero of a polynomial of degree one or two in x alone."""
        powers = by_powers(poly, x)
        if max(powers, default=0) > 2:
            return None
        c, b, a = (powers.get(degree, self.ring.number(0)) for degree in range(3))
        try:
            if a == 0:
                quotient, rest = divmod(-c, b)
                return quotient if rest == 0 else self._quotient(-c, b)
            b, c = self._quotient(b, 2 * a), self._quotient(c, a)
            square = self._reduce(b * b - c)
            if square != 0 and not square.is_constant():
                return None
            root = self._power(fraction(square.leading_coefficient())) if square != 0 else square
        except (Unsupported, ZeroDivisionError):
            return None
        return root * sign - b

    def _ordered(self, point: Assignment) -> bool:
        """Whether what is said without functions holds."""
        plain = (f for f in self.formulas if f[0] in RELATIONS and not self._functions_in(f))
        try:
            return all(self._truth(formula, point) for formula in plain)
        except ZeroDivisionError:
            return False
