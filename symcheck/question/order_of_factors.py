"""Whether an equation of capital letters relies on the order of factors, as that of matrices does."""

from __future__ import annotations

from collections import Counter
from itertools import pairwise

from symcheck.reading import Tree
from symcheck.reading.tree import Add, Chain, Mul, Name, Neg, Number, Pow

MAX_POWER = 4  # of a sum in capital letters; more is hardly ever printed
Word = tuple[str, ...]  # factors in order; those that are no capital letters before them, sorted


def relies_on_order(tree: Tree, scalars: set[str]) -> bool:
    """Whether sides of an equation are equal only if capital letters, but for some, commute."""
    if not isinstance(tree, Chain) or set(tree.signs) != {"="}:
        return False
    sides = [_expanded(member, scalars) for member in tree.members]
    pairs = [(a, b) for a, b in pairwise(sides) if a is not None and b is not None]
    return any(a != b and _commuted(a) == _commuted(b) for a, b in pairs)


def _commuted(polynomial: dict[Word, int]) -> dict[Word, int] | None:
    return _sum([{tuple(sorted(word)): n} for word, n in polynomial.items()])


def _expanded(tree: Tree, scalars: set[str]) -> dict[Word, int] | None:
    """A polynomial as its words with their coefficients; None if it is something else."""
    match tree:
        case Number(text) if text.isdigit():
            return {(): int(text)} if int(text) else {}
        case Name(letter):
            return {(letter,): 1}
        case Neg(value):
            inner = _expanded(value, scalars)
            return None if inner is None else {word: -n for word, n in inner.items()}
        case Add(terms):
            return _sum([_expanded(term, scalars) for term in terms])
        case Mul(factors):
            return _product([_expanded(factor, scalars) for factor in factors], scalars)
        case Pow(base, Number(text)) if text.isdigit() and 0 < int(text) <= MAX_POWER:
            return _product([_expanded(base, scalars)] * int(text), scalars)
        case Pow(Mul(factors), Neg(Number("1"))):
            return _product([_expanded(Pow(each, Neg(Number("1"))), scalars) for each in reversed(factors)], scalars)
        case Pow(Name(letter), Neg(Number("1"))):
            return {(f"{letter}^-1",): 1}
    return None


def _sum(parts: list[dict[Word, int] | None]) -> dict[Word, int] | None:
    total: Counter[Word] = Counter()
    for part in parts:
        if part is None:
            return None
        total.update(part)
    return {word: n for word, n in total.items() if n}


def _product(parts: list[dict[Word, int] | None], scalars: set[str]) -> dict[Word, int] | None:
    product: dict[Word, int] = {(): 1}
    for part in parts:
        if part is None:
            return None
        terms = [{_ordered(a + b, scalars): m * n} for a, m in product.items() for b, n in part.items()]
        if (product_ := _sum([*terms])) is None:
            return None
        product = product_
    return product


def _ordered(word: Word, scalars: set[str]) -> Word:
    """The word with what commutes in front, and what cancels left out."""
    free = sorted(x for x in word if not _is_capital(x, scalars))
    kept: list[str] = []
    for x in word:
        if x in free:
            continue
        if kept and (kept[-1] == f"{x}^-1" or x == f"{kept[-1]}^-1"):
            kept.pop()
        else:
            kept.append(x)
    return (*free, *kept)


def _is_capital(letter: str, scalars: set[str]) -> bool:
    base = letter.removesuffix("^-1")
    return len(base) == 1 and base.isupper() and base not in scalars
