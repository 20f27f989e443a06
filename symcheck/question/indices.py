"""Relations with Kronecker's delta and Levi-Civita's symbol, summed over repeated indices.

Each is written out for all values of its free indices. Where there is no symbol with three indices, nothing says of how
many dimensions they run: what is proved holds in two, three and four.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import product

from symcheck.core.problems import Problem
from symcheck.core.terms import Term, node
from symcheck.core.verdicts import NoForm
from symcheck.reading import Tree
from symcheck.reading.tree import Add, Chain, Div, Mul, Name, Neg, Number

DELTAS, EPSILONS = frozenset({r"\delta"}), frozenset({r"\epsilon", r"\varepsilon"})
# such a symbol with letters for indices
SYMBOL = re.compile(r"\\delta\s*_\s*\{\s*[i-npqrs]\s*[i-npqrs]\s*\}|\\(?:var)?epsilon\s*_\s*\{(?:\s*[i-npqrs]){3}\s*\}")
# a letter with such indices alone
_INDEXED = re.compile(r"(\\?[A-Za-z]+)_(?:\{([i-npqrs]+)\}|([i-npqrs]))")
MOST = 300  # values of free indices: relations with more than five are not printed
DIMENSIONS = (2, 3, 4)  # of the plane, of space, of space and time

Factor = tuple[str, str]  # a letter and its indices
Addend = tuple[Fraction, tuple[Factor, ...]]


@dataclass(frozen=True)
class Indexed:
    """A relation with such symbols: the addends of both sides and the indices that are free in all of them."""

    sides: tuple[list[Addend], list[Addend]]
    free: str

    @property
    def dimensions(self) -> tuple[int, ...]:
        """The numbers of values of an index that are possible."""
        three = any(_is_epsilon(factor) for side in self.sides for _, factors in side for factor in factors)
        return (3,) if three else DIMENSIONS

    @property
    def is_law(self) -> bool:
        """Whether the same letters besides the symbols stand on both sides, as in no definition and no condition."""
        left, right = ({x for _, fs in side for x, i in fs if not _is_symbol((x, i))} for side in self.sides)
        return left == right

    def problems(self, dimension: int) -> Iterator[Problem]:
        """What it says for each choice of its free indices."""
        for numbers in product(range(1, dimension + 1), repeat=len(self.free)):
            at = dict(zip(self.free, numbers, strict=True))
            left, right = (_written_out(side, at, dimension) for side in self.sides)
            yield Problem("question", node("=", left, right))


def indexed(tree: Tree) -> Indexed | None:
    """The relation, if it is an equation between sums of products of such symbols and of letters with indices."""
    if not isinstance(tree, Chain) or tree.signs != ("=",):
        return None
    try:
        left, right = (_addends(side) for side in tree.members)
    except NoForm:
        return None
    free = {_free(factors) for c, factors in (*left, *right) if c}
    if len(free) != 1 or not any(_is_symbol(factor) for _, factors in (*left, *right) for factor in factors):
        return None
    (found,) = free
    return Indexed((left, right), found) if found is not None and 4 ** len(found) <= MOST else None


def _addends(tree: Tree) -> list[Addend]:
    match tree:
        case Number(text):
            return [(Fraction(text), ())]
        case Name(latex, (), 0, 0):
            found = _INDEXED.fullmatch(latex.replace(" ", ""))
            if found is None and "_" in latex:
                raise NoForm("a subscript that is no index")
            return [(Fraction(1), ((found[1], found[2] or found[3]) if found else (latex, ""),))]
        case Add(terms):
            return [addend for term in terms for addend in _addends(term)]
        case Neg(value):
            return [(-c, factors) for c, factors in _addends(value)]
        case Div(top, Number(text)) if Fraction(text):
            return [(c / Fraction(text), factors) for c, factors in _addends(top)]
        case Mul(factors):
            found_: list[Addend] = [(Fraction(1), ())]
            for factor in factors:
                found_ = [(c * d, (*xs, *ys)) for c, xs in found_ for d, ys in _addends(factor)]
            return found_
    raise NoForm(f"{type(tree).__name__} has no indices")


def _free(factors: tuple[Factor, ...]) -> str | None:
    """The indices that stand once; None if one stands three times."""
    counts = Counter(index for _, indices in factors for index in indices)
    if any(n > 2 for n in counts.values()):
        return None
    return "".join(sorted(index for index, n in counts.items() if n == 1))


def _is_epsilon(factor: Factor) -> bool:
    return factor[0] in EPSILONS and len(factor[1]) == 3


def _is_symbol(factor: Factor) -> bool:
    return _is_epsilon(factor) or (factor[0] in DELTAS and len(factor[1]) == 2)


def _written_out(side: list[Addend], at: Mapping[str, int], dimension: int) -> Term:
    """A side with numbers for its free indices, summed over the others."""
    total = dict[tuple[str, ...], Fraction]()
    for c, factors in side:
        bound = sorted({index for _, indices in factors for index in indices} - at.keys())
        for numbers in product(range(1, dimension + 1), repeat=len(bound)):
            values = {**at, **dict(zip(bound, numbers, strict=True))}
            size, names = c, list[str]()
            for letter, indices in factors:
                places = [values[index] for index in indices]
                if not _is_symbol((letter, indices)):
                    names.append("_".join([re.sub(r"\W", "", letter), *map(str, places)]))
                else:
                    size *= _sign(places) if letter in EPSILONS else places[0] == places[1]
            key = tuple(sorted(names))
            total[key] = total.get(key, Fraction()) + size
    addends = [_product(c, names) for names, c in total.items() if c]
    return node("+", *addends) if len(addends) > 1 else addends[0] if addends else 0


def _sign(places: list[int]) -> int:
    i, j, k = places
    return (i - j) * (j - k) * (k - i) // 2


def _product(c: Fraction, names: tuple[str, ...]) -> Term:
    number: Term = c.numerator if c.denominator == 1 else node("/", c.numerator, c.denominator)
    return node("*", number, *names) if names else number


def shown(found: Indexed) -> dict[str, str]:
    """What the symbols are taken for."""
    used = {factor for side in found.sides for _, factors in side for factor in factors if _is_symbol(factor)}
    names = {x: "Levi-Civita's symbol" if x in EPSILONS else "Kronecker's delta" for x, _ in used}
    return {x: f"{name}, summed over repeated indices (its usual letter)" for x, name in names.items()}
