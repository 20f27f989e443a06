r"""Sums over data x_1, ..., x_n, by sums of powers: that of (x_i - a)^2 is that of x_i^2 - 2a x_i, plus n a^2.

What holds of any numbers in the places of the sums of powers holds of all data. What is left to trust is that sums are
linear, and that n addends that are alike add up to n of them.
"""

from __future__ import annotations

from contextlib import suppress

from symcheck.core.verdicts import NoForm, SymcheckError
from symcheck.question.monomials import Monomial, Named, expanded, total
from symcheck.question.prepare import Asked, unlowered
from symcheck.reading import Tree, read, tex, to_latex
from symcheck.reading.tree import BigProduct, BigSum, Name, Number, children, nodes, with_children

LETTERS = ("S", "U", "W", "Q")


def with_sums_of_powers(asked: Asked) -> Asked | None:
    """The question with letters for sums of powers of data; None if there are none, or something else is summed."""
    if not any(r"\sum" in text for text in (asked.relation, *asked.where)):
        return None
    with suppress(SymcheckError, StopIteration):
        reading = unlowered(asked)[0]
        trees = [reading.tree, *(read(text, reading.inference.notation) for text in (*asked.where, *asked.given))]
        sums = [part for tree in trees for part in nodes(tree) if isinstance(part, BigSum)]
        taken = {token for text in (asked.relation, *asked.where, *asked.given) for token in tex.texts(text)}
        named = Named(next(x for x in LETTERS if x not in taken))
        counts = {_count(each) for each in sums}
        if len(counts) != 1:
            return None
        (count,) = counts
        relation, *others = (to_latex(_put(tree, count, named)) for tree in trees)
        where, given = tuple(others[: len(asked.where)]), others[len(asked.where) :]
        conditions = (f"{to_latex(count)} > 0", *(rf"{name} \ge 0" for _, name in named.even()))
        return Asked(relation, where, (*given, *conditions), asked.letters) if named.names else None
    return None


def _count(tree: BigSum) -> Name:
    """The letter for the number of addends."""
    match tree:
        case BigSum((_,), Number("1"), Name() as high) if not isinstance(tree, BigProduct):
            return high
    raise NoForm(f"{to_latex(tree)}: no sum over data")


def _put(tree: Tree, count: Name, named: Named) -> Tree:
    """The same with sums of powers."""

    def of(monomial: Monomial) -> Tree:
        return named(monomial) if monomial else count

    if isinstance(tree, BigSum):
        (index,) = tree.indices

        def own(part: Tree) -> str:
            varies = isinstance(part, Name) and index in part.subscripts
            if isinstance(part, Name) and (part.letter == index or (varies and part.subscripts != (index,))):
                raise NoForm(f"{to_latex(part)} is no date")
            return part.letter if isinstance(part, Name) and varies and not (part.dots or part.primes) else ""

        return total(expanded(tree.body, own, lambda part: _put(part, count, named)), of)
    if isinstance(tree, Name) and tree.subscripts:
        raise NoForm(f"{to_latex(tree)}: one of the data")
    return with_children(tree, tuple(_put(each, count, named) for each in children(tree)))
