"""A printed statement taken apart into its relations: one for each link of each chain, in printed order."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from symcheck.reading.printing import to_latex
from symcheck.reading.tree import LOGIC, CaseList, Chain, Forall, Located, Qualifier, System, Tree, Values, Words


@dataclass(frozen=True, slots=True)
class Relation:
    """One thing that is true or false: a link of a chain (two members), a list of cases, or a logical formula.

    Parameters
    ----------
    tree
        The relation.
    qualifiers
        What is printed beside it, such as the values of an index.
    """

    tree: Tree
    qualifiers: tuple[Qualifier, ...] = ()

    @property
    def left(self) -> Tree | None:
        """The left side of a link; None for cases and logical formulas."""
        return self.tree.members[0] if isinstance(self.tree, Chain) else None

    @property
    def right(self) -> Tree | None:
        """The right side of a link; None for cases and logical formulas."""
        return self.tree.members[1] if isinstance(self.tree, Chain) else None

    @property
    def sign(self) -> str:
        r"""The sign of a link as canonical LaTeX: "=", `\ne`, "<", `\le`, ">", `\ge`, `\in`, ...; "" otherwise."""
        return self.tree.signs[0] if isinstance(self.tree, Chain) else ""

    @property
    def latex(self) -> str:
        """The relation printed back, with its qualifiers."""
        return to_latex(System((self.tree,), self.qualifiers) if self.qualifiers else self.tree)


def relations(tree: Tree) -> tuple[Relation, ...]:
    """Take a printed statement apart.

    Parameters
    ----------
    tree
        The statement.

    Returns
    -------
    tuple of Relation
        Its relations in printed order, one for each link of each chain; expressions standing alone give none.
    """
    return tuple(_relations(tree, ()))


def _relations(tree: Tree, qualifiers: tuple[Qualifier, ...]) -> Iterator[Relation]:
    if isinstance(tree, Chain):
        for k, sign in enumerate(tree.signs):
            yield Relation(Chain(tree.members[k : k + 2], (sign,)), qualifiers)
    elif isinstance(tree, System):
        for part in tree.parts:
            yield from _relations(part, qualifiers + tree.qualifiers)
    elif isinstance(tree, (*LOGIC, CaseList, Forall, Located, Values, Words)):
        yield Relation(tree, qualifiers)
