"""All slips of a relation: those of `symcheck.reading.edits`, and of order and its ends, arguments, connectives.

One function for each class of slips: what may stand in the place of a node, with the kind of slip and its words.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from random import Random
from typing import Protocol, TypeVar

from symcheck.core.terms import Formula
from symcheck.core.verdicts import SymcheckError
from symcheck.reading import Edit, Iff, Notation, Tree, edits, to_latex
from symcheck.reading.tree import (
    Add,
    And,
    Call,
    Chain,
    Div,
    Implies,
    Interval,
    Mul,
    Neg,
    Number,
    Or,
    children,
    replaced,
    walk,
)
from symcheck.selftest.trial import Status, Trial, drawn

ARGUMENT, CONNECTIVE, EQUATED = "argument", "connective", "order and equality"
LOOSENED = {"<": r"\le", ">": r"\ge", r"\le": "<", r"\ge": ">"}
EQUATIONS = {"=": (r"\le", r"\ge"), r"\le": ("=",), r"\ge": ("=",)}
ENDS = ("[]", "[)", "(]")
Slip = tuple[str, str, Tree]
ONE = Number("1")
RARE = ("strictness", "bound", "interval end", ARGUMENT, CONNECTIVE, EQUATED)
KINDS = ("sign", "factor", "number", "index", "exponent", "term", "letter", "relation", *RARE)


class Original(Protocol):
    """A proved relation in which slips are planted."""

    @property
    def id(self) -> str: ...


T = TypeVar("T", bound=Original)


def every_slip(tree: Tree, notation: Notation) -> Iterator[Edit]:
    """Every single edit of a relation, of its ends, arguments and connectives; none twice."""
    seen = {tree}
    for edit in (
        *edits(tree, notation),
        *(edit for kind in (ends, arguments, connectives) for edit in slips_of(kind, tree)),
    ):
        if edit.tree not in seen:
            seen.add(edit.tree)
            yield edit


def is_dropped(before: Tree, after: Tree, stated: Callable[[Tree], Sequence[Formula]]) -> bool:
    """Is a slip forgotten on the way to formulas? They are the same, and so with any other change at its place."""
    if stated(after) != (formulas := stated(before)):
        return False
    path = _where(before, after)
    try:
        return stated(replaced(before, path, Add((dict(walk(before))[path], Number("7"))))) == formulas
    except SymcheckError:
        return False  # what stands there matters


def _where(before: Tree, after: Tree) -> tuple[int, ...]:
    """The path to the lowest place at which all that is different lies."""
    parts = (children(before), children(after))
    if type(before) is type(after) and len(parts[0]) == len(parts[1]):
        others = [k for k, (one, other) in enumerate(zip(*parts, strict=True)) if one != other]
        if len(others) == 1:
            return (others[0], *_where(parts[0][others[0]], parts[1][others[0]]))
    return ()


def trials_of(
    originals: Sequence[T],
    slips: Callable[[T], Iterator[Edit]],
    status_of: Callable[[T, Edit], Status],
    count: int,
    rng: Random,
    rare: Sequence[str] = RARE,
    is_misfit: Callable[[T, Edit], bool] = lambda original, edit: False,
) -> Iterator[Trial]:
    """So many slips of some relations, what becomes of each, and whether its dimensions tell."""
    planted = ((edit.kind, (original, edit)) for original in originals for edit in slips(original))
    for _, (original, edit) in drawn(planted, count, rng, rare):
        status, misfit = status_of(original, edit), is_misfit(original, edit)
        yield Trial(edit.kind, f"{original.id} {edit.description}", status, misfit)


def slips_of(kind: Callable[[Tree], Iterator[Slip]], tree: Tree) -> Iterator[Edit]:
    """All slips of a class at all places of a tree, in a fixed order."""
    for path, node in walk(tree):
        for name, words, new in kind(node):
            yield Edit(name, words, replaced(tree, path, new))


def ends(node: Tree) -> Iterator[Slip]:
    """Another strictness or bound of an order, other ends of an interval."""
    if isinstance(node, Chain):
        printed = to_latex(node)
        for k, sign in enumerate(node.signs):
            if other := LOOSENED.get(sign):
                signs = (*node.signs[:k], other, *node.signs[k + 1 :])
                yield "strictness", f"{sign} -> {other} in {printed}", replace(node, signs=signs)
        if len(node.members) == 2 and node.signs[0] in LOOSENED:
            larger = node.signs[0] in ("<", r"\le")
            side = node.members[larger]
            changed: list[Tree] = [Add((side, ONE)), Add((side, Neg(ONE)))]
            if Number("0") not in node.members:  # else a multiple of a side says the same
                changed += _moved(side)
            for new in changed:
                pair = (node.members[0], new) if larger else (new, node.members[1])
                yield "bound", f"{to_latex(side)} -> {to_latex(new)} in {printed}", replace(node, members=pair)
        if len(node.members) > 2 and set(node.signs) <= {"<", r"\le"}:
            for k, end in ((0, node.members[0]), (len(node.members) - 1, node.members[-1])):
                for new in _moved(end):
                    members = (*node.members[:k], new, *node.members[k + 1 :])
                    words = f"end {to_latex(end)} -> {to_latex(new)} of {printed}"
                    yield "interval end", words, replace(node, members=members)
    elif isinstance(node, Interval):
        for kind in ENDS:
            if kind != node.ends:
                yield "interval end", f"{node.ends} -> {kind} of {to_latex(node)}", replace(node, ends=kind)
        for name, end in (("low", node.low), ("high", node.high)):
            for new in _moved(end):
                words = f"{name} end {to_latex(end)} -> {to_latex(new)}"
                yield "interval end", words, replace(node, low=new) if name == "low" else replace(node, high=new)


def _moved(end: Tree) -> list[Tree]:
    """Another end: half of it and twice as much, or 1 for 0."""
    return [ONE] if end == Number("0") else [Div(end, Number("2")), Mul((Number("2"), end))]


def arguments(node: Tree) -> Iterator[Slip]:
    """Another argument of a function, known or unknown, or two of them exchanged."""
    if not isinstance(node, Call):
        return
    for k, old in enumerate(node.arguments):
        before, after = node.arguments[:k], node.arguments[k + 1 :]
        for new in _other_arguments(old):
            words = f"{to_latex(old)} -> {to_latex(new)} in {to_latex(node)}"
            yield ARGUMENT, words, replace(node, arguments=(*before, new, *after))
        for n, other in enumerate(after, k + 1):
            if other != old:
                exchanged = (*before, other, *node.arguments[k + 1 : n], old, *node.arguments[n + 1 :])
                words = f"{to_latex(old)} and {to_latex(other)} exchanged in {to_latex(node)}"
                yield ARGUMENT, words, replace(node, arguments=exchanged)


def _other_arguments(old: Tree) -> Iterator[Tree]:
    """Twice as much, the opposite, one more."""
    plain = old.value if isinstance(old, Neg) else old
    yield Mul((Number("2"), *(plain.factors if isinstance(plain, Mul) else (plain,))))
    yield plain if isinstance(old, Neg) else Neg(old)
    yield Add((*(old.terms if isinstance(old, Add) else (old,)), ONE))


def connectives(node: Tree) -> Iterator[Slip]:
    """One direction of an equivalence, the converse, `or` for `and`, an order for an equality, and back."""
    if not isinstance(node, (Iff, Implies, And, Or, Chain)):
        return
    place = f"in {to_latex(node)}"
    match node:
        case Iff(left, right):
            yield CONNECTIVE, f"from left to right only {place}", Implies(left, right)
            yield CONNECTIVE, f"from right to left only {place}", Implies(right, left)
        case Implies(left, right):
            yield CONNECTIVE, f"the converse {place}", Implies(right, left)
            yield CONNECTIVE, f"both directions {place}", Iff(left, right)
        case And(parts) | Or(parts):
            word, exchanged = ("part", "or for and") if isinstance(node, And) else ("alternative", "and for or")
            yield CONNECTIVE, f"{exchanged} {place}", Or(parts) if isinstance(node, And) else And(parts)
            for k in range(len(parts)):
                rest = parts[:k] + parts[k + 1 :]
                yield CONNECTIVE, f"{word} {k + 1} dropped {place}", rest[0] if len(rest) == 1 else type(node)(rest)
        case Chain(signs=signs):
            for k, sign in enumerate(signs):
                for new in EQUATIONS.get(sign, ()):
                    words = f"{sign} -> {new} {place}"
                    yield EQUATED, words, replace(node, signs=(*signs[:k], new, *signs[k + 1 :]))


def stronger(node: Tree) -> Iterator[Slip]:
    """Those of these that may say more: the converse as well, `and` for `or`, an equation for an order."""
    for kind, words, new in connectives(node):
        more = isinstance(node, Implies) and isinstance(new, Iff)
        signs = isinstance(node, Chain) and "=" not in node.signs
        if more or signs or isinstance(node, Or):
            yield kind, words, new
