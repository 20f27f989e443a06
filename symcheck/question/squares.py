"""Orders of polynomials and roots, by sums of squares, and by the squares of both sides.

The larger side less the smaller one is a polynomial in letters and roots, over something positive. It is looked for as
a sum of squares of differences and sums of two products, times what is not negative, by linear programming. If there is
none, l <= r follows from l^2 <= r^2 where r is not negative; what is left to trust then is that.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from itertools import combinations, product
from typing import TYPE_CHECKING

from symcheck.core.calculus import functions, nodes
from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Applied, Form, Problem
from symcheck.core.terms import Node, Relation, T, Term, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.proof.algebra.forms import number_term
from symcheck.proof.algebra.polynomial import number_of
from symcheck.proof.algebra.simplex import Column, positive_relation
from symcheck.question.limit import OutOfTime, limited
from symcheck.question.series import FAULTS, Series
from symcheck.reading import from_sympy, to_sympy

if TYPE_CHECKING:
    from sympy import Expr, Poly, Symbol

SECONDS = 3.0  # for one sum of squares
MOST_POINTS, MOST_BOX = 90, 5000  # products that may be squared, and those among which they are looked for
DEEPEST = 3  # how often both sides are squared
KNOWN = frozenset({"+", "-", "*", "/", "^", "sqrt"})
Powers = tuple[int, ...]


def with_form(problem: Problem) -> Problem | None:
    """The problem with a sum of squares that is the difference of its sides as a hint; None if none is found."""
    import sympy

    with suppress(*FAULTS, sympy.PolynomialError, OutOfTime), limited(SECONDS):
        found = _Order(problem)
        form = found.form(found.gap)
        return replace(problem, hints=(*problem.hints, *found.hints(), Form(form))) if form is not None else None
    return None


def squared(problem: Problem) -> Series | None:
    """The order of the squares of both sides, from which that of these follows, and what has to hold for that."""
    sides = list[Problem]()
    if problem.claim.tag not in ("<=", ">="):
        return None
    import sympy

    with suppress(*FAULTS, sympy.PolynomialError, OutOfTime), limited(SECONDS):
        order = _Order(problem)
        small, large = order.sides
        for _ in range(DEEPEST):
            if not order.is_positive(large):
                return None
            sides.append(_stated(problem, ">=", order.term(large), 0))
            gap = order.reduced(large**2 - small**2)
            if order.form(gap) is not None:
                return Series(_stated(problem, ">=", order.term(gap), 0), (*sides,))
            small, large = order.isolated(gap)
    return None


def _stated(problem: Problem, sign: str, left: Term, right: Term) -> Problem:
    return replace(problem, claim=node(sign, left, right))


class _Order:
    """Both sides of an order as polynomials in symbols for letters and roots."""

    def __init__(self, problem: Problem) -> None:
        import sympy

        claim = problem.claim
        if not isinstance(claim, Relation) or claim.tag not in ("<=", ">=", "<", ">") or problem.definitions:
            raise SymcheckError("no order")
        if functions(claim) or any(part.bound or part.tag not in KNOWN for side in claim.terms for part in nodes(side)):
            raise SymcheckError("no polynomials and roots")
        self.roots, self.positive = dict[str, Term](), _positive(problem)
        self.symbols: dict[Node, Symbol] = {}
        self.products = list[tuple[Term, Term]]()
        small, large = claim.terms if claim.tag[0] == "<" else claim.terms[::-1]
        self.sides = tuple(sympy.together(to_sympy(self._without_roots(each))) for each in (small, large))
        self.squares: dict[Symbol, Expr] = {}
        while open_ := [root for root, symbol in self.symbols.items() if symbol not in self.squares]:
            for root in open_:
                self.squares[self.symbols[root]] = to_sympy(self._without_roots(root.outside[0]))
        self.letters = {
            square: root**2
            for root, square in self.squares.items()
            if square.is_Symbol and str(square) not in self.roots
        }
        self.squares = {
            root: square.subs(self.letters) for root, square in self.squares.items() if square not in self.letters
        }
        self.least: dict[str, Fraction] = {}
        if not self.symbols:  # then letters stand for what they are above their least values
            self.least = {x: least for x, least in self.positive.items() if least > 0}
            above = {
                s: s + sympy.Rational(n.numerator, n.denominator)
                for x, n in self.least.items()
                for s in [sympy.Symbol(x, real=True)]
            }
            self.sides = tuple(sympy.together(side.subs(above, simultaneous=True)) for side in self.sides)
        self.gap = self.reduced(self.sides[1] - self.sides[0])

    def hints(self) -> list[Applied[Term]]:
        """That roots of products are those of their factors."""
        return [Applied("root_of_product", each, ()) for each in self.products]

    def _without_roots(self, tree: T) -> T:
        if not isinstance(tree, Node):
            return tree
        if tree.tag == "sqrt":
            return self._root(tree.outside[0])  # type: ignore[return-value]
        return mapped(tree, self._without_roots)  # type: ignore[return-value]

    def _root(self, inner: Term) -> Term:
        import sympy

        match inner:
            case Node(tag="*", outside=(one, other)) if {one, other} <= self.positive.keys():
                self.products.append((one, other))
                return node("*", self._root(one), self._root(other))
        root = node("sqrt", inner)
        if root not in self.symbols:
            self.symbols[root] = sympy.Symbol(f"root_{len(self.symbols) + 1}", real=True)
        name = str(self.symbols[root])
        self.roots[name] = root
        return name

    def reduced(self, expr: Expr) -> Expr:
        """A term with squares of roots worked out, over its divisor; letters with a root are its squares."""
        import sympy

        above, below = sympy.fraction(sympy.together(expr))
        above, below = (each.subs(self.letters) for each in (above, below))
        for root, square in [*self.squares.items()] * DEEPEST:
            above = sympy.rem(sympy.expand(above), root**2 - square, root)
        return sympy.expand(above) / sympy.factor(below)

    def nonnegative(self, symbol: Symbol) -> bool:
        """Is a letter or root not negative?"""
        return symbol.name in self.roots or symbol.name in self.positive

    def is_positive(self, expr: Expr) -> bool:
        """Is it manifestly not negative: are all numbers in it, and what they are multiplied by?"""
        import sympy

        for each in sympy.fraction(sympy.together(expr)):
            whole = sympy.expand(each)
            gens = sorted(whole.free_symbols, key=str)
            terms = sympy.Poly(whole, *gens).terms() if gens else [((), whole)]
            for powers, c in terms:
                known = all(e % 2 == 0 or self.nonnegative(s) for s, e in zip(gens, powers, strict=True))
                if not known or not c >= 0:
                    return False
        return True

    def isolated(self, gap: Expr) -> tuple[Expr, Expr]:
        """Sides of gap >= 0 with what has roots on one side."""
        import sympy

        above, below = sympy.fraction(gap)
        if not self.is_positive(below):
            raise SymcheckError("a divisor of unknown sign")
        rooted = {*self.squares}
        with_roots = sympy.Add(*(each for each in sympy.Add.make_args(above) if each.free_symbols & rooted))
        others = sympy.expand(above - with_roots)
        return (-others, with_roots) if self.is_positive(with_roots) else (sympy.expand(-with_roots), others)

    def term(self, expr: Expr) -> Term:
        """The term of an expression, with its roots."""

        def put(tree: T) -> T:
            if isinstance(tree, str) and tree in self.roots:
                return self.roots[tree]  # type: ignore[return-value]
            if isinstance(tree, str) and tree in self.least:
                return node("+", tree, node("-", number_term(self.least[tree])))  # type: ignore[return-value]
            return mapped(tree, put) if isinstance(tree, Node) else tree  # type: ignore[return-value]

        return put(from_sympy(expr))

    def form(self, gap: Expr) -> Term | None:
        """The sum of squares that something is."""
        import sympy

        above, below = sympy.fraction(gap)
        if not self.is_positive(below):
            return None
        if not above.free_symbols:
            return from_sympy(gap) if above >= 0 else None
        gens = sorted(above.free_symbols, key=str)
        poly = sympy.Poly(above, *gens)
        if not all(c.is_Rational for c in poly.coeffs()):
            return None
        odd = [self.nonnegative(s) for s in gens]
        found = _squares(poly, odd)
        if found is None:
            return None
        addends = [self._square(gens, *each) for each in found]
        total = node("+", *addends) if len(addends) > 1 else addends[0]
        return total if below == 1 else node("/", total, self.term(below))

    def _square(self, gens: Sequence[Symbol], c: Fraction, one: Powers, other: Powers, sign: int) -> Term:
        """c m (u - v)^2 of the products m u^2 and m v^2."""
        import sympy

        common = [min(p, q) for p, q in zip(one, other, strict=True)]
        outside = sympy.Mul(*(s**e for s, e in zip(gens, common, strict=True)))
        u, v = (
            sympy.Mul(*(s ** ((e - k) // 2) for s, e, k in zip(gens, powers, common, strict=True)))
            for powers in (one, other)
        )
        powers = [(self.term(x), int(e)) for x, e in outside.as_powers_dict().items() if x != 1]
        factors = [node("^", x, e) if e > 1 else x for x, e in powers]
        factors += [node("^", self.term(u + sign * v), 2)] if one != other else []
        factors = [number_term(c), *factors] if c != 1 or not factors else factors
        return node("*", *factors) if len(factors) > 1 else factors[0]


def _positive(problem: Problem) -> dict[str, Fraction]:
    """The letters that are said not to be negative, with a number that they are not below."""
    found = dict[str, Fraction]()
    stated = [part for _, fs in problem.hypotheses for f in fs for part in conjuncts(f)]
    for _ in range(len(stated)):
        for formula in stated:
            if isinstance(formula, Relation) and formula.tag in (">", ">=", "<", "<="):
                small, large = formula.terms if formula.tag[0] == "<" else formula.terms[::-1]
                number = found.get(small) if isinstance(small, str) else number_of(small)
                if isinstance(large, str) and number is not None and number >= 0:
                    found[large] = max(number, found.get(large, Fraction(0)))
    return found


def _squares(poly: Poly, odd: Sequence[bool]) -> list[tuple[Fraction, Powers, Powers, int]] | None:
    """A polynomial as a sum of multiples of m (u + v)^2, m (u - v)^2 and m u^2: each by m u^2, m v^2 and the sign."""
    terms = {powers: Fraction(int(c.p), int(c.q)) for powers, c in poly.terms()}
    points = [*_hull([*terms])]
    if len(points) > MOST_POINTS:
        return None
    parities = dict[Powers, list[Powers]]()
    for point in points:
        if all(e % 2 == 0 or known for e, known in zip(point, odd, strict=True)):
            parities.setdefault(tuple(e % 2 for e in point), []).append(point)
    columns: list[tuple[Column, bool]] = [({powers: -c for powers, c in terms.items()}, True)]
    meant = [(points[0], points[0], 0)]
    for several in parities.values():
        for point in several:
            columns.append(({point: Fraction(1)}, False))
            meant.append((point, point, 0))
        for one, other in combinations(several, 2):
            middle = tuple((p + q) // 2 for p, q in zip(one, other, strict=True))
            for sign in (-1, 1):
                columns.append(({one: Fraction(1), other: Fraction(1), middle: Fraction(2 * sign)}, False))
                meant.append((one, other, sign))
    found = positive_relation(columns)
    if found is None:
        return None
    return [(value / found[0], *meant[k]) for k, value in found.items() if k]


def _hull(points: Sequence[Powers]) -> Iterator[Powers]:
    """The whole points among means of some."""
    ranges = [range(min(es), max(es) + 1) for es in zip(*points, strict=True)]
    size = 1
    for each in ranges:
        size *= len(each)
    if size > MOST_BOX:
        raise SymcheckError("a polynomial of many letters")
    least, most = min(map(sum, points)), max(map(sum, points))
    own = {*points}
    corners: list[tuple[Column, bool]] = [(_column(each, 1), False) for each in points]
    for point in product(*ranges):
        inside = least <= sum(point) <= most
        if point in own or (inside and positive_relation([*corners, (_column(point, -1), True)]) is not None):
            yield point


def _column(point: Iterable[int], sign: int) -> Column:
    found: Column = {(k,): Fraction(sign * e) for k, e in enumerate(point) if e}
    return {**found, (-1,): Fraction(sign)}
