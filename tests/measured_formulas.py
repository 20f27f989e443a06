"""Formulas with dimensions made up by a small grammar, faults in them, and what the dimension of a term is, by numbers.

The evaluator shares nothing with `symcheck.dimensions`: it knows what every letter measures and works upwards.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction

from symcheck.core.terms import FUNCTIONS, RELATIONS, Formula, Node, Term, node

Vector = tuple[Fraction, ...]  # exponents of kg, m, s
BASES = ("kg", "m", "s")
PLAIN: Vector = (Fraction(0),) * 3


def vector(kg: int, m: int, s: int) -> Vector:
    return Fraction(kg), Fraction(m), Fraction(s)


LETTERS: dict[str, Vector] = {
    "m": vector(1, 0, 0), "M": vector(1, 0, 0), "x": vector(0, 1, 0), "r": vector(0, 1, 0), "t": vector(0, 0, 1),
    "tau": vector(0, 0, 1), "v": vector(0, 1, -1), "F": vector(1, 1, -2), "E": vector(1, 2, -2),
    "rho": vector(1, -3, 0), "omega": vector(0, 0, -1), "phi": PLAIN, "n": PLAIN, "I_1": vector(1, 2, 0),
    "I_2": vector(1, 2, 0),
}  # fmt: skip
FUNCTION_OF_TIME, LENGTH = "f", vector(0, 1, 0)  # f(t) is a length
ROWS, COLUMNS = (vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)), (PLAIN, vector(0, 1, -1), vector(1, 0, 1))


def plus(one: Vector, other: Vector, factor: Fraction | int = 1) -> Vector:
    return tuple(a + factor * b for a, b in zip(one, other, strict=True))


MATRIX = {f"A_{i + 1}{j + 1}": plus(ROWS[i], COLUMNS[j], -1) for i in range(3) for j in range(3)}
KNOWN: dict[str, Vector] = {**LETTERS, **MATRIX, FUNCTION_OF_TIME: LENGTH}


class Misfit(Exception):
    """Terms that do not measure the same, or what should be a number and is none."""


class Vanishing(Exception):
    """A sum of numbers that is 0, which may measure anything: nothing is asked of such formulas."""


def number(term: Term) -> Fraction | None:
    """The value of a term of whole numbers."""
    if isinstance(term, int):
        return Fraction(term)
    if not isinstance(term, Node) or term.tag not in ("+", "-", "*", "/", "^"):
        return None
    found = [number(part) for part in term.outside]
    if any(each is None for each in found):
        return None
    first, *rest = (each for each in found if each is not None)
    if term.tag == "-":
        return -first
    for each in rest:
        if term.tag == "^":
            first = first ** int(each) if first else first
        else:
            first = {"+": first + each, "*": first * each, "/": first / (each or 1)}[term.tag]
    return first


def measured(term: Term, letters: Mapping[str, Vector]) -> tuple[Vector, Vector]:
    """The exponents of a term, and of that whose logarithm it is."""
    if isinstance(term, int):
        return PLAIN, PLAIN
    if isinstance(term, str):
        return letters[term], PLAIN
    tag, *parts = term
    if tag == "+":
        if number(term) == 0:
            raise Vanishing
        found = [measured(part, letters) for part in parts]
        if len({own for own, _ in found}) > 1:
            raise Misfit
        logs = PLAIN
        for _, each in found:
            logs = plus(logs, each)
        return found[0][0], logs
    if tag == "-":
        own, logs = measured(parts[0], letters)
        return own, plus(PLAIN, logs, -1)
    if tag in ("*", "/"):
        total = PLAIN
        for k, part in enumerate(parts):
            total = plus(total, plain(part, letters), -1 if tag == "/" and k else 1)
        return total, PLAIN
    if tag == "^":
        return plus(PLAIN, plain(parts[0], letters), parts[1]), PLAIN
    if tag == "sqrt":
        return plus(PLAIN, plain(parts[0], letters), Fraction(1, 2)), PLAIN
    if tag == "log":
        return PLAIN, plain(parts[0], letters)
    if tag == "exp":
        own, logs = measured(parts[0], letters)
        if own != PLAIN:
            raise Misfit
        return logs, PLAIN
    if tag in FUNCTIONS:
        if plain(parts[0], letters) != PLAIN:
            raise Misfit
        return PLAIN, PLAIN
    if tag == "call":
        name, (order,), argument = parts
        return plus(letters[name], plain(argument, letters), -order), PLAIN
    if tag == "mean":
        return plain(parts[0], {**letters, parts[1]: PLAIN}), PLAIN
    if tag == "sum":
        return plain(parts[0], {**letters, parts[1]: PLAIN}), PLAIN
    if tag == "diff":
        body, x, order, at = parts
        place = plain(at, letters)
        return plus(plain(body, {**letters, x: place}), place, -order), PLAIN
    if tag == "integral":
        body, x, low, high = parts
        place = plain(high, letters)
        if plain(low, letters) != place:
            raise Misfit
        return plus(plain(body, {**letters, x: place}), place), PLAIN
    raise AssertionError(tag)


def plain(term: Term, letters: Mapping[str, Vector]) -> Vector:
    """The exponents of what is no logarithm of a quantity."""
    own, logs = measured(term, letters)
    if logs != PLAIN:
        raise Misfit
    return own


def fits(formula: Formula, letters: Mapping[str, Vector] = KNOWN) -> bool:
    """Whether all sums, arguments and sides of a formula fit."""
    try:
        if formula[0] in RELATIONS:
            return measured(formula[1], letters) == measured(formula[2], letters)
        return all(fits(part, letters) for part in formula[1:])
    except Misfit:
        return False


class Grammar:
    """Terms of a dimension that is asked for."""

    def __init__(self, rng: random.Random) -> None:
        self.rng = rng
        self.bound = 0

    def relation(self, depth: int = 3) -> Formula:
        """A relation, or several, that fit."""
        if self.rng.random() < 0.1:
            return node("and", self.relation(depth - 1), self.relation(depth - 1))
        if self.rng.random() < 0.1:
            return self.matrix()
        if self.rng.random() < 0.07:
            one, other = self.dimension(), [self.dimension()]
            return node("=", self.logs(one), self.logs(one, *other))
        of = self.dimension()
        return node(self.rng.choice(("=", "=", "=", "<", ">=")), self.term(of, depth), self.term(of, depth))

    def dimension(self) -> Vector:
        return self.rng.choice([*LETTERS.values()])

    def logs(self, of: Vector, *more: Vector) -> Term:
        """A sum of logarithms of this dimension, in which others cancel."""
        parts: list[Term] = [node("log", self.term(of, 1))]
        for each in more:
            parts += [node("log", self.term(each, 1)), node("-", node("log", self.term(each, 1)))]
        self.rng.shuffle(parts)
        return node("+", *parts) if len(parts) > 1 else parts[0]

    def matrix(self) -> Formula:
        """A line of a product of a matrix, and its determinant or a minor, entry by entry."""
        i, j = self.rng.sample(range(3), 2)
        if self.rng.random() < 0.5:
            cells = [node("*", f"A_{i + 1}{k + 1}", self.term(COLUMNS[k], 1)) for k in range(3)]
            return node("=", node("+", *cells), self.term(ROWS[i], 1))
        a, b = self.rng.sample(range(3), 2)
        names = [f"A_{p + 1}{q + 1}" for p, q in ((i, a), (j, b), (i, b), (j, a))]
        of = plus(plus(ROWS[i], ROWS[j]), plus(COLUMNS[a], COLUMNS[b]), -1)
        minor = node("+", node("*", *names[:2]), node("-", node("*", *names[2:])))
        return node("=", minor, self.term(of, 1))

    def term(self, of: Vector, depth: int) -> Term:
        """A term of this dimension."""
        ways: list[Callable[[Vector, int], Term]] = [self.product]
        if depth > 0:
            ways += [self.product, self.sum, self.quotient, self.root, self.integral, self.derivative, self.mean]
            ways += [self.function, self.function] if of == PLAIN else [self.scaled, self.rate, self.exponential]
        return self.rng.choice(ways)(of, depth - 1)

    def product(self, of: Vector, depth: int) -> Term:
        """Letters and powers of them that make up this dimension, and a number at times."""
        rest, factors = of, list[Term]()
        if depth > 0 and self.rng.random() < 0.6:
            name = self.rng.choice([*LETTERS])
            factors.append(name)
            rest = plus(rest, LETTERS[name], -1)
        factors += self.filled(rest)
        if not factors or self.rng.random() < 0.3:
            factors.append(self.rng.randint(2, 9))
        self.rng.shuffle(factors)
        return factors[0] if len(factors) == 1 else node("*", *factors)

    def filled(self, of: Vector) -> Iterator[Term]:
        for base, n in zip("mxt", of, strict=True):
            name = {"m": self.rng.choice("mM"), "x": self.rng.choice("xr"), "t": self.rng.choice(("t", "tau"))}[base]
            if n.denominator == 2:
                yield node("sqrt", node("^", name, int(2 * n)) if n != Fraction(1, 2) else name)
            elif n:
                assert n.denominator == 1
                yield name if n == 1 else node("^", name, int(n))

    def sum(self, of: Vector, depth: int) -> Term:
        parts = [self.term(of, depth) for _ in range(self.rng.randint(2, 3))]
        return node("+", *(part if self.rng.random() < 0.7 else node("-", part) for part in parts))

    def quotient(self, of: Vector, depth: int) -> Term:
        below = self.dimension()
        return node("/", self.term(plus(of, below), depth), self.term(below, depth))

    def root(self, of: Vector, depth: int) -> Term:
        if any(n.denominator > 1 for n in of):
            return self.product(of, depth)
        return node("sqrt", self.term(plus(of, of), depth))

    def integral(self, of: Vector, depth: int) -> Term:
        self.bound += 1
        name, along = f"z{self.bound}", self.rng.choice(("x", "t"))
        body = self.term(plus(of, LETTERS[along], -1), depth)
        other = {"x": "r", "t": "tau"}[along]
        return node("integral", replaced(body, along, name), name, along, other)

    def derivative(self, of: Vector, depth: int) -> Term:
        order = self.rng.randint(1, 2)
        return node("diff", self.term(plus(of, LETTERS["t"], order), depth), "t", order, "t")

    def rate(self, of: Vector, depth: int) -> Term:
        order = self.rng.randint(0, 2)
        rest = plus(of, plus(LENGTH, LETTERS["t"], -order), -1)
        return node("*", node("call", "f", (order,), self.rng.choice(("t", "tau"))), self.product(rest, 0))

    def mean(self, of: Vector, depth: int) -> Term:
        return node("mean", node("*", node("cos", "phi"), self.term(of, depth)), "phi")

    def scaled(self, of: Vector, depth: int) -> Term:
        return node("*", self.function(PLAIN, depth), self.term(of, depth))

    def exponential(self, of: Vector, depth: int) -> Term:
        return node("*", node("exp", node("-", self.term(PLAIN, depth))), self.term(of, depth))

    def function(self, of: Vector, depth: int) -> Term:
        name = self.rng.choice(("sin", "cos", "tan", "exp", "arctan", "gamma"))
        return node(name, self.term(PLAIN, depth))


def replaced(tree: Term, name: str, by: Term) -> Term:
    """The term with another in the place of a letter, wherever it is printed and not bound."""
    if tree == name:
        return by
    if not isinstance(tree, Node):
        return tree
    if name in tree.bound:
        fields = [replaced(part, name, by) if k > 2 else part for k, part in enumerate(tree)]
    else:
        fields = [
            part if k == 0 or not isinstance(part, str | Node) else replaced(part, name, by)
            for k, part in enumerate(tree)
        ]
    return tuple.__new__(type(tree), fields)


def places(tree: Term, path: tuple[int, ...] = ()) -> Iterator[tuple[tuple[int, ...], Term]]:
    """All terms below, with the way to them; letters of binders and names of functions are none."""
    yield path, tree
    if isinstance(tree, Node):
        for k, part in enumerate(tree):
            first = 3 if tree.tag == "call" else 1  # behind the name of a function and its orders
            fixed = (tree.tag == "^" and k == 2) or (tree.bound and k == 2) or (tree.tag == "diff" and k == 3)
            if k >= first and not fixed:
                yield from places(part, (*path, k))


def put(tree: Term, path: tuple[int, ...], new: Term) -> Term:
    if not path:
        return new
    assert isinstance(tree, Node)
    k, *rest = path
    return tuple.__new__(type(tree), (*tree[:k], put(tree[k], tuple(rest), new), *tree[k + 1 :]))


def faulty(formula: Formula, rng: random.Random) -> Formula:
    """The formula with one slip at some place: another letter, a factor more, another power, a function put around."""
    spots = [(path, term) for path, term in places(formula) if path and term_like(term)]
    path, term = rng.choice(spots)
    name = rng.choice([*LETTERS])
    kind = rng.randrange(4)
    new: Term
    if kind == 0:
        new = name
    elif kind == 1:
        new = node("*", name, term)
    elif kind == 2:
        new = node("^", term, rng.choice((2, 3, -1)))
    else:
        new = node(rng.choice(("sin", "sqrt")), term)
    return put(formula, path, new)  # type: ignore[return-value]


def term_like(term: Term) -> bool:
    return not isinstance(term, Node) or (term.tag not in RELATIONS and term.tag != "and")
