"""Other logic: one direction of an equivalence, the converse, `or` for `and`, an order for an equality, and back."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from symcheck.reading import Edit, Iff, Tree, to_latex
from symcheck.reading.tree import And, Chain, Implies, Or, replaced, walk

CONNECTIVE, EQUATED = "connective", "order and equality"
LOOSER = {"=": (r"\le", r"\ge"), r"\le": ("=", "<"), r"\ge": ("=", ">"), r"\ne": ("<", ">"), "<": (), ">": ()}


def connectives(tree: Tree) -> Iterator[Edit]:
    """All edits of one connective, or of one sign between an order and an equation, in a fixed order."""
    for path, node in walk(tree):
        for kind, words, new in _local(node):
            yield Edit(kind, f"{words} in {to_latex(node)}", replaced(tree, path, new))


def stronger(tree: Tree) -> Iterator[Edit]:
    """Those of these edits that may say more: the converse as well, `and` for `or`, an equation for an order."""
    for path, node in walk(tree):
        for kind, words, new in _local(node):
            more = isinstance(node, Implies) and isinstance(new, Iff)
            signs = isinstance(node, Chain) and kind == EQUATED and "=" not in node.signs
            if more or signs or isinstance(node, Or):
                yield Edit(kind, f"{words} in {to_latex(node)}", replaced(tree, path, new))


def _local(node: Tree) -> Iterator[tuple[str, str, Tree]]:
    match node:
        case Iff(left, right):
            yield CONNECTIVE, "from left to right only", Implies(left, right)
            yield CONNECTIVE, "from right to left only", Implies(right, left)
        case Implies(left, right):
            yield CONNECTIVE, "the converse", Implies(right, left)
            yield CONNECTIVE, "both directions", Iff(left, right)
        case And(parts):
            yield CONNECTIVE, "or for and", Or(parts)
            for k in range(len(parts)):
                rest = parts[:k] + parts[k + 1 :]
                yield CONNECTIVE, f"part {k + 1} dropped", rest[0] if len(rest) == 1 else And(rest)
        case Or(parts):
            yield CONNECTIVE, "and for or", And(parts)
            for k in range(len(parts)):
                rest = parts[:k] + parts[k + 1 :]
                yield CONNECTIVE, f"alternative {k + 1} dropped", rest[0] if len(rest) == 1 else Or(rest)
        case Chain(signs=signs):
            for k, sign in enumerate(signs):
                for other in LOOSER.get(sign, ()):
                    new = (*signs[:k], other, *signs[k + 1 :])
                    if sign == "=" or other == "=":
                        yield EQUATED, f"{sign} -> {other}", replace(node, signs=new)
