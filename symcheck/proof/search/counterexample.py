"""Exact counterexamples: a point where every hypothesis holds and the claim does not.

Candidates come in order of size: matrices, sines and cosines, numbers; equations linear in a number are then solved.
A point counts only after exact evaluation of everything, so nothing here has to be trusted.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from itertools import cycle, islice, permutations, product
from math import isqrt, prod

from symcheck.core.calculus import domain, letters
from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Candidate, Problem
from symcheck.core.terms import PI, RELATIONS, Formula, Node, Quantified, Term, Value, mapped, node
from symcheck.proof.algebra.flint import Poly, Rational, by_powers, fraction, occurring, rational
from symcheck.proof.algebra.forms import number_term, term_of
from symcheck.proof.algebra.knowledge import formulas_of, ring_of, stated
from symcheck.proof.algebra.polynomial import (
    Ratio,
    Ring,
    Unsupported,
    alone,
    number_of,
    square_free,
    subterms,
    unfold,
    variables,
    with_arguments,
)
from symcheck.proof.algebra.variables import atoms, circle, cosine, prime, sine, table
from symcheck.proof.rules.compute import Point
from symcheck.proof.rules.proof import Prover
from symcheck.proof.rules.step import Step
from symcheck.proof.search.angle_points import refute_about_angles, refute_with_hints
from symcheck.proof.search.number_points import refute_at, refute_at_some, refute_numbers
from symcheck.proof.search.theorem_search import values_of

Assignment = dict[str, Poly]
Solved = tuple[str, Poly, Poly]  # (x, a, b): a x + b = 0
Rows = Sequence[Sequence[Term | Fraction]]
ZERO = rational(0)
TRIES = 400  # points: the papers' counterexamples are among the first 312
FUNCTION_TRIES = 12  # integrals and means to be evaluated by proofs, which cost up to a second: the papers need 7
MAX_POWER = 40  # of a number at a point, which people are to read: the papers need 34
MAX_INDEX = 40, 6  # of the values tried of up to three groups, and of more: all tuples of indices are sorted
MAX_BITS = 4096  # when signs of sums of roots are told apart: those of the papers need 8
SEVENTHS = ((2, 3, 6), (6, 2, -3), (-3, 6, -2))  # 7 times the rows of a rotation none of whose cosines is 0 or 1


def refute(problem: Problem, prove: Prover = lambda _: None) -> Point | None:
    """A point of a certificate, or None if none was found (also for terms that have no place in a ring).

    What functions such as integrals are at the point is proved.
    """
    ways: tuple[Callable[[Problem], Point | None], ...] = (
        refute_numbers,
        partial(_point, prove=prove),
        partial(_point, prove=prove, framed=True),
        refute_at_some,
        partial(_point, prove=prove, spheres=True),
        partial(refute_about_angles, prove=prove),
        partial(refute_with_hints, prove=prove),
    )
    for way in ways:
        try:
            if (point := way(problem)) is not None:
                return point
        except Unsupported:
            continue
    return None


def fails_at(problem: Problem, values: Mapping[str, Term]) -> bool:
    """Tell whether the hypotheses hold at a point and the claim does not.

    Parameters
    ----------
    problem
        Hypotheses and claim.
    values
        The values of the letters, as in a certificate.

    Returns
    -------
    bool
        True if the point refutes the claim.
    """
    try:
        with alone(problem):
            search = Search(problem, problem.claim, lambda _: None)
            point = {x: value for x in search.free if (value := search._coordinate(x, values)) is not None}
            return len(point) == len(search.free) and search._evaluate(point) and search._refutes(point)
    except KeyError:  # a function that has no value in the ring, such as arctan 2
        return refute_at(problem, dict(values)) is not None
    except (Unsupported, ZeroDivisionError):
        return False


def failing(problem: Problem) -> Callable[[Mapping[str, int]], bool] | None:
    """The same for whole numbers at many points, where no functions occur; None for terms without a place in a ring."""
    try:
        search = Search(problem, problem.claim, lambda _: None)
    except Unsupported:
        return None

    def fails(values: Mapping[str, int]) -> bool:
        try:
            point = {name: search.ring.number(values[name]) for name in search.free}
            return all(search._truth(f, point) for f in search.formulas) and search._refutes(point)
        except (Unsupported, ZeroDivisionError):
            return False

    return fails


def _point(problem: Problem, prove: Prover, *, framed: bool = False, spheres: bool = False) -> Point | None:
    claim = problem.claim
    if framed and not _framed(problem):
        return None
    if any(isinstance(part, Quantified) for part in subterms(claim)):
        return None
    if claim[0] == "<=>":
        directions = [node("=>", claim[1], claim[2]), node("=>", claim[2], claim[1])]
        points = (Search(problem, direction, prove, framed, spheres).run() for direction in directions)
        return next((point for point in points if point), None)
    return Search(problem, claim, prove, framed, spheres).run()


def _framed(problem: Problem, size: int = 3) -> tuple[str, ...]:
    """The vectors with so many components of which an equation says lengths or angles, if they are no more than it."""
    found: dict[str, None] = {}
    for _, formula in stated(problem):
        if formula.tag != "=":
            continue
        inside = letters(unfold(formula, dict(problem.definitions)))
        stems = [name[:-2] for name in sorted(inside) if name.endswith("_1")]
        if inside and inside == {f"{stem}_{k + 1}" for stem in stems for k in range(size)}:
            found |= dict.fromkeys(stems)
    return (tuple(found) if len(found) <= size else ()) or (_framed(problem, 2) if size == 3 else ())


@dataclass(frozen=True)
class _Group:
    """Variables that take values together, and the values to try."""

    names: tuple[str, ...]
    choices: tuple[Assignment, ...]


class Search:
    """The candidates for one claim, and what holds at them."""

    primes: tuple[int, ...] = (2, 3)  # their roots may occur in coordinates

    def __init__(
        self, problem: Problem, direction: Formula, prove: Prover, framed: bool = False, spheres: bool = False
    ) -> None:
        base = ring_of(problem)
        self.spheres = spheres
        self.framed = _framed(problem) if framed else ()
        self.problem = problem
        names = {*with_arguments(base.names), *map(table().root, self.primes)}
        if any(name in atoms() for name in names):
            names |= {*map(table().root, (5, 7)), "pi"}
        self.ring = Ring(names, base.definitions)
        functions = sorted((name for name in self.ring.names if name in atoms()), key=lambda n: len(str(atoms()[n])))
        self.calls = [name for name in functions if atoms()[name][0] == "call"]  # their values are free
        self.functions = [name for name in functions if name not in self.calls]
        self.formulas = [formula for _, formula in stated(problem)]
        if direction[0] == "=>":
            self.formulas += conjuncts(direction.formulas[0])
        conditions = domain(problem.claim, *self.formulas)
        self.conditions = [f for f in conditions if variables(unfold(f, base.definitions)) <= {*self.ring.names}]
        self.gaps: dict[Formula, Ratio] = {}
        self.roots = {name: p for name in self.ring.names if (p := prime(name)) is not None}
        self.free = [name for name in self.ring.names if name not in (*self.roots, *self.functions, "pi")]
        self.prove, self.tries = prove, FUNCTION_TRIES
        self.settled: list[tuple[Term, Term, Step]] = []  # functions, their values at the point, and the proofs

    def run(self) -> Point | None:
        """The first candidate that stands the exact test."""
        angles = {turn[1] for turn in map(circle, self.free) if turn is not None}
        if table().angles.keys() & angles or table().exponentials.keys() & {*self.free}:
            return None  # their values follow from those of letters
        if angles & {*self.free, "pi"} or len({*map(_key, self.free)}) < len(self.free):
            return None
        for point in self._candidates(sorted(angles)):
            try:
                if self._refutes(point):
                    return self._display(point)
            except ZeroDivisionError:
                continue
        return None

    # candidates

    def _candidates(self, angles: Sequence[str]) -> Iterator[Assignment]:
        hinted = dict(pair for hint in self.problem.hints if isinstance(hint, Candidate) for pair in hint.values)
        letters = [name for name in self.free if not table().stands(name)]
        groups = [self._matrix(stem, names) for stem, names in _matrices(letters)]
        groups += [self._angle(x, k) for k, x in enumerate(angles)]
        groups += [self._frame()] if self.framed else []
        taken = {name for group in groups for name in group.names}
        spheres = [*self._spheres([name for name in letters if name not in taken])] if self.spheres else []
        if self.spheres and not spheres:
            return
        groups += spheres
        taken |= {name for group in spheres for name in group.names}
        scalars = [name for name in self.free if name not in taken]
        if hinted:
            point = {x: self._value(hinted.get(_key(x), 1)) for x in self.free}
            if self._evaluate(point):
                yield point
        solved: dict[tuple[int, ...], list[Solved] | None] = {}
        for indices in islice(_by_size([len(g.choices) for g in groups] + [len(_PATTERNS)]), TRIES):
            fixed: Assignment = {}
            for group, index in zip(groups, indices[:-1], strict=True):
                fixed.update(group.choices[index])
            if indices[:-1] not in solved:
                solved[indices[:-1]] = self._solve(fixed, scalars)
            steps = solved[indices[:-1]]
            if steps is not None:
                point = {**fixed, **self._numbers(scalars, indices[-1])}
                if self._complete(point, steps) and self._evaluate(point):
                    yield point

    def _value(self, value: Term | Fraction) -> Poly:
        if isinstance(value, str):
            return self.ring.number(Fraction(value))
        return self.ring.number(value) if isinstance(value, Fraction | int) else self.ring.poly(value)

    def _coordinate(self, name: str, values: Mapping[str, Term]) -> Poly | None:
        """The value of a variable at the point of a certificate."""
        function, x = circle(name) or ("", name)
        if x not in values:
            return None
        return self._side(turn_of(values[x])[function == "sin"] if function else values[x], {})

    def _matrix(self, stem: str, names: tuple[str, ...]) -> _Group:
        own = node("and", *(f for f in self.formulas if self._support(f) <= set(names)))
        matrices = tuple(_matrix_values())
        key = names, unfold(own, self.ring.definitions)
        if key not in _ALLOWED:  # the same for every statement about matrices of one kind
            points = (self._entries(rows, names) for rows in matrices)
            _ALLOWED[key] = [k for k, point in enumerate(points) if self._truth(own, point)]
        return _Group(names, tuple(self._entries(matrices[k], names) for k in _ALLOWED[key]))

    def _frame(self) -> _Group:
        """Vectors as rows of the matrices, most of which are rotations."""
        places = {f"{stem}_{k}": (row, k - 1) for row, stem in enumerate(self.framed) for k in (1, 2, 3)}
        names = tuple(name for name in places if name in self.free)
        flat = not any(name.endswith("_3") for name in names)
        matrices = [rows for rows in _matrix_values() if not flat or [*rows[2]] == [0, 0, 1]]
        points = [{n: self._value(rows[places[n][0]][places[n][1]]) for n in names} for rows in matrices]
        return _Group(names, tuple(points))

    def _spheres(self, names: Sequence[str]) -> Iterator[_Group]:
        """Letters the sum of whose squares is said to be the square of a number, as of a unit quaternion."""
        left = {*names}
        for formula in self.formulas:
            found, radius = self._sphere(formula)
            if radius and found <= left:
                left -= found
                own = tuple(name for name in names if name in found)
                points = (islice(cycle(point), k, k + len(own)) for point in _on_sphere(len(own)) for k in (0, 1))
                yield _Group(
                    own, tuple({x: self._value(radius * c) for x, c in zip(own, p, strict=True)} for p in points)
                )

    def _sphere(self, formula: Formula) -> tuple[set[str], Fraction]:
        """The letters and the radius of a sphere about zero; radius 0 where an equation says something else."""
        match formula.outside:
            case (Value(tag="sqrt", terms=(inside,)), int(root)) if formula.tag == "=":
                formula = node("=", inside, root * root)
        if formula.tag != "=" or self._functions_in(formula):
            return set(), Fraction(0)
        number, squares = Fraction(0), dict[str, Fraction]()
        for powers, coefficient in self._gap(formula).num.terms():
            names = [name for name, power in zip(self.ring.names, powers, strict=True) if power]
            if sum(powers) != 2 * len(names) or len(names) > 1:
                return set(), Fraction(0)
            number = number if names else -fraction(coefficient)
            squares |= dict.fromkeys(names, fraction(coefficient))
        if len(squares) < 2 or len({*squares.values()}) > 1:
            return set(), Fraction(0)
        square = number / next(iter(squares.values()))
        radius = Fraction(isqrt(max(0, square.numerator)), isqrt(square.denominator))
        return ({*squares}, radius) if radius * radius == square else (set(), Fraction(0))

    def _entries(self, rows: Rows, names: tuple[str, ...]) -> Assignment:
        return {n: self._value(rows[int(n[-2]) - 1][int(n[-1]) - 1]) for n in names}

    def _angle(self, x: str, shift: int) -> _Group:
        names = sine(x), cosine(x)
        own = [f for f in self.formulas if self._support(f) <= set(names)]
        choices = []
        for s, c in _CIRCLE[shift:] + _CIRCLE[:shift]:
            try:
                point = {names[0]: self._value(s), names[1]: self._value(c)}
            except (Unsupported, KeyError):
                continue
            if all(self._truth(f, point) for f in own):
                choices.append(point)
        return _Group(names, tuple(choices))

    def _numbers(self, names: Sequence[str], index: int) -> Assignment:
        """Values for the scalars: members of a family I_1, I_2, I_3 by their number, others from the end.

        The empty pattern gives every letter another value, to tell apart what the others make equal; what is scattered
        lies on no line, so that vectors are independent.
        """
        pattern, point, place = _PATTERNS[index], {}, 0
        if pattern == SCATTERED:
            return {name: self.ring.number((7 * k * k + 3 * k + 1) % 23 - 9) for k, name in enumerate(names)}
        if not pattern:
            return {name: self.ring.number(Fraction(7 * k + 5, 3)) for k, name in enumerate(names)}
        for name in names:
            tail = name.rpartition("_")[2]
            if tail.isdigit() and len(tail) == 1:
                where = int(tail) - 1
            else:
                place += 1
                where = -place
            point[name] = self.ring.number(pattern[where % len(pattern)])
        return point

    def _support(self, formula: Formula) -> set[str]:
        if formula[0] not in RELATIONS:
            return set().union(*map(self._support, formula.formulas))
        return occurring(self._gap(formula).num) - self.roots.keys()

    def _equations(self) -> list[Poly]:
        """What the equations without functions say is zero."""
        return [self._gap(f).num for f in self.formulas if f.tag == "=" and not self._functions_in(f)]

    def _solve(self, fixed: Assignment, scalars: Sequence[str]) -> list[Solved] | None:
        """The equations at fixed matrices and angles, in order of solution."""
        open_ = [q for q in (self._reduce(self._at(p, fixed)) for p in self._equations()) if q != 0]
        steps: list[Solved] = []
        while open_:
            open_.sort(key=len)
            equation = open_.pop(0)
            degrees = dict(zip(self.ring.names, equation.degrees(), strict=True))
            choice = next((x for x in reversed(scalars) if degrees[x] == 1), None)
            if choice is None:
                if not any(degrees[x] for x in scalars):
                    return None
                continue
            steps.append(self._linear(equation, choice))
            open_ = self._eliminated_from(open_, steps[-1])
        return steps[::-1]

    def _linear(self, equation: Poly, x: str) -> Solved:
        """An equation of the first degree in a variable, solved for it."""
        slope = equation.derivative(x)
        return x, slope, equation - slope * self.ring.generator[x]

    def _eliminated_from(self, polys: Sequence[Poly], step: Solved) -> list[Poly]:
        """What is left of the polynomials, times a power of the slope, without the variable that is solved for."""
        x, slope, rest = step
        left: list[Poly] = []
        for poly in polys:
            powers, total = by_powers(poly, x), self.ring.number(0)
            for power, coefficient in powers.items():
                total += coefficient * (-rest) ** power * slope ** (max(powers) - power)
            left.append(self._reduce(total))
        return [poly for poly in left if poly != 0]

    def _complete(self, point: Assignment, steps: Sequence[Solved]) -> bool:
        for x, slope, rest in steps:
            bottom = self._reduce(self._at(slope, point))
            if bottom == 0:
                if self._reduce(self._at(rest, point)) != 0:
                    return False
                continue
            try:
                point[x] = self._quotient(-self._reduce(self._at(rest, point)), bottom)
            except ZeroDivisionError:
                return False
        return True

    def _functions_in(self, formula: Formula) -> bool:
        return not occurring(self._gap(formula).num).isdisjoint(self.functions)

    def _evaluate(self, point: Assignment) -> bool:
        """Gives roots and powers their values, the innermost first; False if one is not a combination of roots."""
        self.settled = []
        for name in self.functions:
            kind, *arguments = atoms()[name]
            if kind not in ("sqrt", "pow"):
                if self.tries == 0 or not self._settle(name, point):
                    return False
                continue
            try:
                values = [self._side(term, point) for term in arguments]
                if not all(value == 0 or value.is_constant() for value in values):
                    return False
                numbers = [fraction(v.leading_coefficient()) if v != 0 else Fraction(0) for v in values]
                point[name] = self._reduce(self._power(*numbers))
            except (Unsupported, ZeroDivisionError):
                return False
        return True

    def _settle(self, name: str, point: Assignment) -> bool:
        """The value of an integral or a mean, with its proof."""
        self.tries -= 1
        function = atoms()[name]
        free = letters(function)  # what is bound in it has no value
        if not free <= point.keys():
            return False  # an angle, of which a point has sine and cosine alone
        defined = tuple((x, term_of(p)) for x, p in point.items() if x in free)
        for value in self._possible(function, dict(defined)):
            proof = self.prove(Problem(name, node("=", function, value), defined))
            if proof is not None:
                self.settled.append((function, value, proof.step))
                point[name] = self.ring.poly(value)
                return True
        return False

    def _possible(self, function: Term, numbers: Mapping[str, Term]) -> Iterator[Term]:
        """What a function may be where letters have these numbers."""
        yield from values_of(function, numbers)

    def _power(self, base: Fraction, exponent: Fraction | None = None) -> Poly:
        if exponent is None:
            outside, primes = square_free(base)
            roots = [*map(table().root, primes)]
            if not self.roots.keys() >= {*roots}:
                raise Unsupported(f"the root of {base}")
            return prod((self.ring.generator[root] for root in roots), start=self.ring.number(outside))
        if exponent.denominator != 1 or base <= 0 or abs(exponent) > MAX_POWER:
            raise Unsupported(f"{base} to the power {exponent}")
        return self.ring.number(base**exponent.numerator)

    # exact evaluation

    def _gap(self, formula: Formula) -> Ratio:
        if formula not in self.gaps:
            self.gaps[formula] = self.ring.subtract(formula[1], formula[2])
        return self.gaps[formula]

    def _at(self, poly: Poly, point: Mapping[str, Poly]) -> Poly:
        values = [point.get(name, self.ring.generator[name]) for name in self.ring.names]
        return poly.compose(*values, ctx=self.ring.context)

    def _reduce(self, poly: Poly) -> Poly:
        for name, p in self.roots.items():
            poly = divmod(poly, self.ring.generator[name] ** 2 - p)[1]
        return poly

    def _quotient(self, top: Poly, bottom: Poly) -> Poly:
        """top / bottom for combinations of roots, by conjugates."""
        for name in self.roots:
            if name in occurring(bottom):
                conjugate = self._at(bottom, {name: -self.ring.generator[name]})
                top, bottom = self._reduce(top * conjugate), self._reduce(bottom * conjugate)
        if not bottom.is_constant() or bottom == 0:
            raise ZeroDivisionError
        return top / bottom.leading_coefficient()

    def _sign(self, poly: Poly, point: Assignment) -> int:
        if (number := self._rational(poly, point)) is not None:
            return int(number > 0) - int(number < 0)
        value = self._reduce(self._at(poly, point))
        if value == 0:
            return 0
        if value.is_constant():
            return 1 if value.leading_coefficient() > 0 else -1
        return self._sign_of_roots(value)

    def _rational(self, poly: Poly, point: Assignment) -> Rational | None:
        """The value where only rational numbers enter, much faster than by substitution; else None."""
        values = [ZERO] * len(self.ring.names)
        for k, degree in enumerate(poly.degrees()):
            if not degree or (value := point.get(self.ring.names[k])) == 0:
                continue
            if value is None or not value.is_constant():
                return None
            values[k] = value.leading_coefficient()
        return poly(*values)

    def _sign_of_roots(self, value: Poly) -> int:
        precision = 8
        while precision < MAX_BITS:
            low = high = Fraction(0)
            for exponents, coefficient in value.terms():
                radicand = 1
                for name, exponent in zip(self.ring.names, exponents, strict=True):
                    if exponent and name not in self.roots:
                        raise ZeroDivisionError  # a variable without a value
                    radicand *= self.roots[name] if exponent else 1
                near = isqrt(radicand << (2 * precision))
                ends = [fraction(coefficient) * Fraction(n, 1 << precision) for n in (near, near + 1)]
                low, high = low + min(ends), high + max(ends)
            if low > 0 or high < 0:
                return 1 if low > 0 else -1
            precision *= 2
        raise ZeroDivisionError

    def _truth(self, formula: Formula, point: Assignment) -> bool:
        kind = formula[0]
        if isinstance(formula, Quantified):
            raise Unsupported("a quantifier inside a statement")
        if kind not in RELATIONS:
            parts = [self._truth(f, point) for f in formula.formulas]
            if kind in ("and", "or"):
                return all(parts) if kind == "and" else any(parts)
            return parts[0] == parts[1] if kind == "<=>" else parts[1] or not parts[0]
        gap = self._gap(formula)
        if "pi" in self.ring.generator and kind in ("=", "!="):  # transcendental: no polynomial in it is zero by chance
            zero = bool(self._reduce(self._at(gap.num, point)) == 0)
            return zero if kind == "=" else not zero
        order = self._sign(gap.num, point)
        for divisor, exponent in gap.den.values():
            order *= self._sign(divisor, point) ** exponent
        return {
            "=": order == 0, "!=": order != 0, "<": order < 0, "<=": order <= 0, ">": order > 0, ">=": order >= 0
        }[kind]  # fmt: skip

    def _refutes(self, point: Assignment) -> bool:
        if self._truth(self.problem.claim, point) or not all(self._truth(f, point) for f in self.formulas):
            return False
        divisors = [d for gap in list(self.gaps.values()) for d, _ in gap.den.values()] + list(
            self.ring.divisors.values()
        )
        axioms = [poly for poly in self.ring.axioms().values() if not poly.is_constant()]
        if any(self._reduce(self._at(d, point)) == 0 for d in divisors) or not self._consistent(point):
            return False
        if not all(self._truth(formula, point) for formula in self.conditions):
            return False
        return all(self._reduce(self._at(poly, point)) == 0 for poly in axioms)

    def _called(self, point: Assignment) -> list[tuple[Node, Poly]]:
        """What unknown functions are at the point, at the numbers that their arguments are there."""
        places = (mapped(atoms()[call], lambda term: self._written(self._side(term, point))) for call in self.calls)
        return [(place, self._reduce(point[call])) for place, call in zip(places, self.calls, strict=True)]

    def _consistent(self, point: Assignment) -> bool:
        """Whether unknown functions have equal values at equal arguments; no others depend on each other."""
        known: dict[Node, Poly] = {}
        return all(known.setdefault(place, value) == value for place, value in self._called(point))

    # display

    def _display(self, point: Assignment) -> Point:
        claim = self.problem.claim
        needed = self._needed_names()
        known = {name: self._written(self._reduce(p)) for name, p in point.items() if name in needed - atoms().keys()}
        values = {name: value for name, value in known.items() if circle(name) is None}
        values |= {x: angle_of(known[cosine(x)], known[sine(x)]) for _, x in filter(None, map(circle, known))}
        values |= dict.fromkeys(sorted(self._mentioned() - values.keys()), 1)  # those on which nothing depends
        sides: list[Term | bool] = [self._written_side(side, point) for side in claim.terms]
        sides += [self._truth(part, point) for part in claim.formulas]
        called: dict[Term, Term] = {place: self._written(value) for place, value in self._called(point)}
        return Point(values, tuple(sides), tuple(called.items()), tuple(self.settled))

    def _needed_names(self) -> set[str]:
        definitions = self.ring.definitions
        return with_arguments(variables(*(unfold(formula, definitions) for formula in formulas_of(self.problem))))

    def _mentioned(self) -> set[str]:
        """The free letters of what is stated, also those whose value changes nothing."""
        stated = self.problem.claim, *self.formulas
        return set().union(*(letters(unfold(formula, self.ring.definitions)) for formula in stated))

    def _written_side(self, side: Term, point: Assignment) -> Term:
        """The value of a side; pi may stand in its denominator."""
        ratio = self.ring.ratio(side)
        top, bottom = (self._reduce(self._at(poly, point)) for poly in (ratio.num, ratio.bottom()))
        if "pi" not in occurring(top) | occurring(bottom):
            return self._written(self._side(side, point))
        common = top.gcd(bottom)
        return node("/", term_of(divmod(top, common)[0]), term_of(divmod(bottom, common)[0]))

    def _side(self, side: Term, point: Assignment) -> Poly:
        ratio = self.ring.ratio(side)
        top, bottom = self._at(ratio.num, point), self.ring.number(1)
        for divisor, exponent in ratio.den.values():
            bottom *= self._at(divisor, point) ** exponent
        return self._quotient(self._reduce(top), self._reduce(bottom))

    def _written(self, value: Poly) -> Term:
        """A number as a term of integers and roots."""
        if value == 0:
            return 0
        addends: list[Term] = []
        for exponents, coefficient in value.terms():
            number, radicand, turns = fraction(coefficient), 1, 0
            for name, exponent in zip(self.ring.names, exponents, strict=True):
                if name == "pi":
                    turns = int(exponent)
                else:
                    radicand *= self.roots[name] if exponent else 1
            factors: list[Term] = [number_term(number)]
            factors += [node("sqrt", radicand)] * (radicand > 1) + [node("^", PI, turns)] * (turns > 0)
            addends.append(node("*", *factors) if len(factors) > 1 else factors[0])
        return addends[0] if len(addends) == 1 else node("+", *addends)


def angle_of(cosine: Term, sine: Term) -> Term:
    """The angle of a point of the unit circle: twice the arctangent of its half."""
    if cosine == -1:
        return PI
    half = node("/", sine, node("+", 1, cosine))
    number = number_of(half)
    return node("*", 2, node("arctan", half if number is None else number_term(number)))


def turn_of(angle: Term) -> tuple[Term, Term]:
    """(cosine, sine) of such an angle; KeyError for others."""
    match angle:
        case Value(tag="pi"):
            return -1, 0
        case Value(tag="*", terms=(2, Value(tag="arctan", terms=(half,)))):
            square = node("^", half, 2)
            below = node("+", 1, square)
            return node("/", node("+", 1, node("-", square)), below), node("/", node("*", 2, half), below)
    raise KeyError(angle)


def _key(name: str) -> str:
    """The name of a coordinate in a hint: "sin_x" for the sine of x."""
    return "_".join(circle(name) or (name,))


def _matrices(names: Sequence[str]) -> list[tuple[str, tuple[str, ...]]]:
    """Families of variables with two indices, at least four of them."""
    stems: dict[str, list[str]] = {}
    for name in names:
        stem, _, tail = name.rpartition("_")
        if len(tail) == 2 and set(tail) <= set("123"):
            stems.setdefault(stem, []).append(name)
    return [(stem, tuple(members)) for stem, members in stems.items() if len(members) > 3]


def _by_size(lengths: Sequence[int]) -> Iterator[tuple[int, ...]]:
    """All index tuples below the lengths, those with small sums first."""
    if 0 in lengths:
        return
    largest = MAX_INDEX[len(lengths) > 3]
    limited = [min(n, largest) for n in lengths]
    yield from sorted(product(*(range(n) for n in limited)), key=lambda t: (sum(t), t))


def _turned(rows: Rows) -> Iterator[Rows]:
    for order in permutations(range(3)):
        yield [list(rows[i]) for i in order]


def _cayley(seed: int) -> list[list[Fraction]]:
    """A rotation from a quaternion with 62-bit entries."""
    source = random.Random(seed)
    w, x, y, z = (Fraction(source.getrandbits(62) - 2**61) for _ in range(4))
    n = w * w + x * x + y * y + z * z
    return [
        [(w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n],
        [2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n],
        [2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n],
    ]


def _on_sphere(count: int) -> Iterator[list[Fraction]]:
    """Rational points of the unit sphere in so many dimensions, those first whose coordinates are none of them 0."""
    whole = sorted(_WHOLE, key=lambda point: len(point) != count)
    for point in whole:
        if len(point) <= count:
            length = isqrt(sum(x * x for x in point))
            yield [Fraction(x, length) for x in (*point, *[0] * (count - len(point)))]


# whole numbers the sum of whose squares is a square
_WHOLE = (
    *((1, 2, 2, 4), (1, 1, 1, 1), (2, 4, -5, 6), (4, -1, 2, 2), (-1, 3, 3, 9), (2, 5, 4, 2)),
    *((2, 3, 6), (1, 2, 2), (6, 2, -3), (-2, 1, 2), (4, 4, 7)),
    *((3, 4), (5, 12), (-4, 3), (8, 15)),
    *((1,), (-1,)),
)
# which matrices satisfy the formulas about them alone; a memory of pure results
_ALLOWED: dict[tuple[tuple[str, ...], Formula], list[int]] = {}


def _matrix_values() -> Iterator[Rows]:
    """Rotations, reflections and other matrices, small ones first."""
    f = Fraction
    seventh = [[f(x, 7) for x in row] for row in SEVENTHS]  # a rotation; its negative is a reflection
    eye: Rows = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    r2, r3, r6 = node("sqrt", 2), node("sqrt", 3), node("sqrt", 6)
    surd: Rows = [
        [node("/", 2, r6), node("/", -1, r6), node("/", 1, r6)],
        [node("/", 1, r3), node("/", 1, r3), node("/", -1, r3)],
        [0, node("/", 1, r2), node("/", 1, r2)],
    ]
    half: Rows = [[node("/", 1, r2), node("/", 1, r2), 0], [node("/", -1, r2), node("/", 1, r2), 0], [0, 0, 1]]
    turns: list[Rows] = [
        [[f(3, 5), f(4, 5), 0], [f(-4, 5), f(3, 5), 0], [0, 0, 1]],
        [[1, 0, 0], [0, f(3, 5), f(4, 5)], [0, f(-4, 5), f(3, 5)]],
        [[f(3, 5), 0, f(-4, 5)], [0, 1, 0], [f(4, 5), 0, f(3, 5)]],
    ]
    yield seventh
    yield eye
    yield [[-x for x in row] for row in seventh]
    yield turns[0]
    yield surd
    yield half
    yield from turns[1:]
    yield ((1, 2, 3), (4, 5, 7), (6, 9, 8))
    yield ((1, 2, 3), (2, 5, 4), (3, 4, 7))
    yield from islice(_turned(eye), 1, None)
    yield [[1, 0, 0], [0, 1, 0], [0, 0, -1]]
    yield [[0, 0, 0], [0, 0, 0], [0, 0, 0]]
    yield [[2, 0, 0], [0, f(1, 2), 0], [0, 0, 1]]
    yield [[2, 0, 0], [0, 3, 0], [0, 0, 5]]
    yield from islice(_turned(seventh), 1, None)
    yield from islice(_turned(surd), 1, None)
    for rows in turns:
        yield from islice(_turned(rows), 1, None)
    yield from (_cayley(seed) for seed in (1, 2))


# (sine, cosine): rational points of the circle first, which keep numbers short
_CIRCLE: tuple[tuple[Term | Fraction, Term | Fraction], ...] = (
    (Fraction(3, 5), Fraction(4, 5)),
    (Fraction(5, 13), Fraction(12, 13)),
    (Fraction(8, 17), Fraction(15, 17)),
    (0, 1),
    (1, 0),
    (Fraction(-4, 5), Fraction(3, 5)),
    (Fraction(3, 5), Fraction(-4, 5)),
    (0, -1),
    (node("/", 1, node("sqrt", 3)), node("/", node("*", node("sqrt", 2), node("sqrt", 3)), 3)),
    (node("/", 1, node("sqrt", 2)), node("/", 1, node("sqrt", 2))),
    (node("/", 1, node("sqrt", 3)), node("/", node("*", -1, node("sqrt", 2), node("sqrt", 3)), 3)),
    (Fraction(1, 2), node("/", node("sqrt", 3), 2)),
)

# long numbers, at which no polynomial that is not zero vanishes by chance
_BIG = tuple(random.Random(7).getrandbits(62) for _ in range(12))
SCATTERED = (0,)  # stands for `_BIG` in the list of patterns
# values of the other letters, repeated where there are more: different ones, equal ones, zeros, negative ones
_PATTERNS: tuple[tuple[int | Fraction, ...], ...] = (
    (1, 2, 3),
    (),
    (2, 1, 3, 5, 7, 11),
    (2, 3, 4, 6, 5),
    (1, -1),
    (1, 9, 1),
    (1, 1, 2),
    (1, 2, 1),
    (2, 1, 1),
    (1, 1, 1),
    (1, 0, 2),
    (0, 1, 2),
    (1, 2, 0),
    (0, 0, 1),
    (0, 0, 0),
    (3, 2, 1, -1),
    (-1, 2, 3),
    (1, -2, 3),
    (-1, -2, -3),
    (Fraction(1, 2), Fraction(2, 3), Fraction(3, 5), Fraction(5, 7)),
    (5, 1, 1, 9),
    (4, -3, Fraction(1, 7), 11, 2),
    _BIG,
    SCATTERED,
)
