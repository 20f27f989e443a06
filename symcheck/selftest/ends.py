"""Slips of order: a strict sign for one that is not, a looser or tighter bound, another end of an interval."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from symcheck.reading import Edit, Tree, to_latex
from symcheck.reading.tree import Add, Chain, Div, Interval, Mul, Neg, Number, replaced, walk

LOOSENED = {"<": r"\le", ">": r"\ge", r"\le": "<", r"\ge": ">"}
ENDS = ("[]", "[)", "(]")


def ends(tree: Tree) -> Iterator[Edit]:
    """All edits of the strictness or the bound of an order, or of the ends of an interval, in a fixed order."""
    for path, node in walk(tree):
        for kind, words, new in _local(node):
            yield Edit(kind, words, replaced(tree, path, new))


def _local(node: Tree) -> Iterator[tuple[str, str, Tree]]:
    if isinstance(node, Chain):
        for k, sign in enumerate(node.signs):
            if other := LOOSENED.get(sign):
                signs = (*node.signs[:k], other, *node.signs[k + 1 :])
                yield "strictness", f"{sign} -> {other} in {to_latex(node)}", replace(node, signs=signs)
        if len(node.members) == 2 and node.signs[0] in LOOSENED:
            yield from _bounds(node)
        if len(node.members) > 2 and set(node.signs) <= {"<", r"\le"}:
            for k, end in ((0, node.members[0]), (len(node.members) - 1, node.members[-1])):
                for new in _moved(end):
                    members = (*node.members[:k], new, *node.members[k + 1 :])
                    words = f"end {to_latex(end)} -> {to_latex(new)} of {to_latex(node)}"
                    yield "interval end", words, replace(node, members=members)
    elif isinstance(node, Interval):
        yield from _interval(node)


def _bounds(node: Chain) -> Iterator[tuple[str, str, Tree]]:
    """The larger side made larger or smaller."""
    larger = node.signs[0] in ("<", r"\le")
    side = node.members[larger]
    changed: list[Tree] = [Add((side, Number("1"))), Add((side, Neg(Number("1"))))]
    if Number("0") not in node.members:  # else a multiple of a side says the same
        changed += _moved(side)
    for new in changed:
        members = (node.members[0], new) if larger else (new, node.members[1])
        yield "bound", f"{to_latex(side)} -> {to_latex(new)} in {to_latex(node)}", replace(node, members=members)


def _interval(node: Interval) -> Iterator[tuple[str, str, Tree]]:
    for kind in ENDS:
        if kind != node.ends:
            yield "interval end", f"{node.ends} -> {kind} of {to_latex(node)}", replace(node, ends=kind)
    for new in _moved(node.low):
        yield "interval end", f"low end {to_latex(node.low)} -> {to_latex(new)}", replace(node, low=new)
    for new in _moved(node.high):
        yield "interval end", f"high end {to_latex(node.high)} -> {to_latex(new)}", replace(node, high=new)


def _moved(end: Tree) -> Iterator[Tree]:
    """Another end: half of it and twice as much, or 1 for 0."""
    if end == Number("0"):
        yield Number("1")
        return
    yield Div(end, Number("2"))
    yield Mul((Number("2"), end))
