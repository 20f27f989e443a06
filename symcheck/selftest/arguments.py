"""Changed arguments of functions, known and unknown ones."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from symcheck.reading import Edit, Tree, to_latex
from symcheck.reading.tree import Add, Call, Mul, Neg, Number, replaced, walk

ARGUMENT = "argument"


def arguments(tree: Tree) -> Iterator[Edit]:
    """All edits of an argument, or exchanges of two, in a fixed order."""
    for path, node in walk(tree):
        if isinstance(node, Call):
            for words, new in _local(node):
                yield Edit(ARGUMENT, f"{words} in {to_latex(node)}", replaced(tree, path, new))


def _local(node: Call) -> Iterator[tuple[str, Tree]]:
    for k, old in enumerate(node.arguments):
        before, after = node.arguments[:k], node.arguments[k + 1 :]
        for new in _others(old):
            yield f"{to_latex(old)} -> {to_latex(new)}", replace(node, arguments=(*before, new, *after))
        for n, other in enumerate(after, k + 1):
            if other != old:
                exchanged = (*before, other, *node.arguments[k + 1 : n], old, *node.arguments[n + 1 :])
                yield f"{to_latex(old)} and {to_latex(other)} exchanged", replace(node, arguments=exchanged)


def _others(old: Tree) -> Iterator[Tree]:
    """Twice as much, the opposite, one more."""
    plain = old.value if isinstance(old, Neg) else old
    yield Mul((Number("2"), *(plain.factors if isinstance(plain, Mul) else (plain,))))
    yield plain if isinstance(old, Neg) else Neg(old)
    yield Add((*(old.terms if isinstance(old, Add) else (old,)), Number("1")))
