"""Slips of order: a strict sign for one that is not, another end of an interval."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from symcheck.reading import Edit, Tree, to_latex
from symcheck.reading.tree import Chain, Div, Interval, Mul, Number, replaced, walk

LOOSENED = {"<": r"\le", ">": r"\ge", r"\le": "<", r"\ge": ">"}
ENDS = ("[]", "[)", "(]")


def ends(tree: Tree) -> Iterator[Edit]:
    """All edits of the strictness of an order or of the ends of an interval, in a fixed order."""
    for path, node in walk(tree):
        for kind, words, new in _local(node):
            yield Edit(kind, words, replaced(tree, path, new))


def _local(node: Tree) -> Iterator[tuple[str, str, Tree]]:
    if isinstance(node, Chain):
        for k, sign in enumerate(node.signs):
            if other := LOOSENED.get(sign):
                signs = (*node.signs[:k], other, *node.signs[k + 1 :])
                yield "strictness", f"{sign} -> {other} in {to_latex(node)}", replace(node, signs=signs)
        if len(node.members) > 2 and set(node.signs) <= {"<", r"\le"}:
            for k, end in ((0, node.members[0]), (len(node.members) - 1, node.members[-1])):
                for new in _moved(end):
                    members = (*node.members[:k], new, *node.members[k + 1 :])
                    words = f"end {to_latex(end)} -> {to_latex(new)} of {to_latex(node)}"
                    yield "interval end", words, replace(node, members=members)
    elif isinstance(node, Interval):
        yield from _interval(node)


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
