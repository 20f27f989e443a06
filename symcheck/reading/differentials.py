r"""Differentials outside of derivatives: `dE = m v \, dv`, where each addend has as many of them as any other."""

from __future__ import annotations

from collections.abc import Collection

from symcheck.core.calculus import letters, substituted
from symcheck.core.terms import Term, node
from symcheck.core.verdicts import NoForm, SymcheckError
from symcheck.reading.printing import to_latex
from symcheck.reading.tree import (
    Add,
    Bars,
    BigSum,
    Chain,
    Cross,
    Div,
    Mul,
    Neg,
    Norm,
    Number,
    Pow,
    Total,
    Tree,
    children,
    walk,
)


class Uneven(SymcheckError):
    """Addends differ in the number of their differentials."""


def differential(x: str) -> str:
    """The variable for the differential of a variable."""
    return f"d_{x}"


def total(term: Term, varying: Collection[str]) -> Term:
    """The differential of a term: the rate by each letter that varies, times the differential of that letter."""
    if isinstance(term, str) and term in varying:
        return differential(term)
    parts = [node("*", slope(term, x), differential(x)) for x in sorted(letters(term)) if x in varying]
    return node("+", *parts) if len(parts) > 1 else parts[0] if parts else 0


def slope(term: Term, x: str) -> Term:
    """The rate by a letter, where others that are defined by it are held; it is bound by another name therefore."""
    bound = f"{x}_varied"
    return node("diff", substituted(term, {x: bound}), bound, 1, x)


def refuse_uneven(tree: Tree) -> None:
    """Uneven where addends differ in the number of their differentials; NoForm where these are multiplied."""
    if not any(isinstance(part, Total) for _, part in walk(tree)):
        return
    members = tree.members if isinstance(tree, Chain) else (tree,)
    degrees = {degree(member) for member in members if member != Number("0")}
    if len(degrees) > 1:
        raise Uneven(f"{to_latex(tree)}: the sign of a differential, or a letter d? its sides differ in its number")


def degree(tree: Tree) -> int:
    """How many differentials each addend has as factors."""
    inside = [part for _, part in walk(tree) if isinstance(part, Total)]
    if not inside:
        return 0
    match tree:
        case Total() if len(inside) == 1:
            return 1
        case Neg(value) | Bars(value) | Norm(value):
            return degree(value)
        case Div(top, bottom) if degree(bottom) == 0:
            return degree(top)
        case Pow(base, Number(text)) if text.isdigit():
            return degree(base) * int(text)
        case BigSum(body=body):
            return degree(body)
        case Mul() | Cross():
            degrees = [*map(degree, children(tree))]
            if sum(map(bool, degrees)) > 1:
                raise NoForm(f"{to_latex(tree)}: products of differentials are not decided")
            return sum(degrees)
        case Add(terms):
            degrees = [degree(term) for term in terms if term != Number("0")]
            if len({*degrees}) == 1:
                return degrees[0]
    raise Uneven(f"{to_latex(tree)}: the sign of a differential, or a letter d? say what it is")
