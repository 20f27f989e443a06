"""The variables of polynomials that are no letters, and the terms they stand for: one table for each problem.

A sine or cosine of a letter, the root of a prime and any other function is one variable. Two terms have the same one if
and only if their keys (the kind and the arguments in canonical form) are equal. No name is that of a letter: what a
variable stands for is looked up here, never guessed from its name.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator, Mapping
from contextlib import contextmanager

from symcheck.core.terms import PI, Node, Term, node

CONSTANTS = {"pi": PI}  # names that no letter may have: variables that are there in every problem


class Unsupported(Exception):
    """A term the ring has no room for: a half angle, the root of a letter, a circular definition."""


class Table:
    """Names of variables in the order in which their terms were met."""

    def __init__(self, letters: Iterable[str] = ()) -> None:
        self.letters = {*letters, *CONSTANTS}
        self.circles: dict[str, tuple[str, str]] = {}  # ("sin", x) or ("cos", x)
        self.primes: dict[str, int] = {}
        self.atoms: dict[str, Node] = {}  # all other functions
        self.angles: dict[str, Term] = {}  # what is no letter and stands under a sine or cosine
        self.exponentials: dict[str, tuple[str, Node]] = {}  # by name: the inverse, and the term
        self.texts: dict[Term, str] = {}  # canonical forms
        self._names: dict[Hashable, str] = {}

    def letter(self, name: str) -> str:
        """A letter that was met; Unsupported if a variable was given its name before."""
        if name not in self.letters:
            if self.stands(name) or name in self.angles:
                raise Unsupported(f"the letter {name} has the name of a function value")
            self.letters.add(name)
        return name

    def fresh(self, wish: str) -> str:
        """A name that nothing has: the one wished for, or with a number."""
        name, number = wish, 1
        while name in self.letters or name in self.angles or self.stands(name):
            number += 1
            name = f"{wish}_{number}"
        return name

    def circle(self, function: str, x: str) -> str:
        """The variable of a sine or cosine of a letter."""
        if (function, x) not in self._names:
            name = self._names[function, x] = self.fresh(f"{function}_{x}")
            self.circles[name] = (function, x)
        return self._names[function, x]

    def angle(self, key: Hashable, term: Term) -> str:
        """The name of an angle that is no letter."""
        if ("angle", key) not in self._names:
            name = self._names["angle", key] = self.fresh("Angle")
            self.angles[name] = term
        return self._names["angle", key]

    def exponential(self, key: Hashable, term: Term) -> tuple[str, str]:
        """The variables of e to a term, and of its inverse."""
        if ("exp", key) not in self._names:
            above = self._names["exp", key] = self.fresh("Exp")
            self.exponentials[above] = "", node("exp", term)
            below = self.fresh("Exp")
            self.exponentials[below] = above, node("exp", node("-", term))
            self.exponentials[above] = below, node("exp", term)
        name = self._names["exp", key]
        return name, self.exponentials[name][0]

    def root(self, prime: int) -> str:
        """The variable of the root of a prime."""
        if prime not in self._names:
            name = self._names[prime] = self.fresh(f"sqrt_{prime}")
            self.primes[name] = prime
        return self._names[prime]

    def atom(self, key: tuple[Hashable, ...], tree: Node) -> str:
        """The variable of a function with this key: of the first term that had it."""
        if key not in self._names:
            number = sum(kept[0] == tree[0] for kept in self.atoms.values()) + 1
            name = self._names[key] = self.fresh(f"{tree.tag.title()}_{number}")
            self.atoms[name] = tree
        return self._names[key]

    def term(self, name: str) -> Term:
        """What a variable stands for; a letter for itself."""
        if name in self.primes:
            return node("sqrt", self.primes[name])
        if name in self.circles:
            function, x = self.circles[name]
            return node(function, self.angles.get(x, x))
        if name in self.exponentials:
            return self.exponentials[name][1]
        return (self.atoms | CONSTANTS).get(name, name)

    def stands(self, name: str) -> bool:
        """Whether a variable stands for a term and not for a letter."""
        kinds = (self.circles, self.primes, self.atoms, self.exponentials, CONSTANTS)
        return any(name in kind for kind in kinds)


_TABLES = [Table()]


def table() -> Table:
    """The table in use."""
    return _TABLES[-1]


@contextmanager
def one_problem(letters: Iterable[str]) -> Iterator[Table]:
    """A new table while one problem with these letters is looked at."""
    _TABLES.append(Table(letters))
    try:
        yield _TABLES[-1]
    finally:
        _TABLES.pop()


def atoms() -> Mapping[str, Node]:
    """The functions that stand as one variable each."""
    return table().atoms


def circle(name: str) -> tuple[str, str] | None:
    """("sin" or "cos", the angle) if the variable is a sine or a cosine."""
    return table().circles.get(name)


def prime(name: str) -> int | None:
    """The prime if the variable is its root."""
    return table().primes.get(name)


def sine(x: str) -> str:
    """The variable of a sine."""
    return table().circle("sin", x)


def cosine(x: str) -> str:
    """The variable of a cosine."""
    return table().circle("cos", x)
