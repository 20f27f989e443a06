"""All single edits of a printed statement: what a slip of the pen could have made of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from symcheck.reading.notation import Notation
from symcheck.reading.printing import to_latex
from symcheck.reading.tree import (
    Add,
    Bars,
    BigSum,
    Call,
    Chain,
    Derivative,
    Diag,
    Div,
    ElementsOf,
    Integral,
    MatrixOf,
    Mean,
    Mul,
    Name,
    Neg,
    Number,
    Path,
    PlusMinus,
    Pow,
    Sqrt,
    Tree,
    Tuple,
    replaced,
    walk,
)

KINDS = ("sign", "index", "exponent", "factor", "number", "term", "letter", "relation")
_TURNED = {"<": ">", ">": "<", r"\le": r"\ge", r"\ge": r"\le"}
_SISTER = {"sin": "cos", "cos": "sin", "tg": "ctg", "ctg": "tg", "tan": "cot", "cot": "tan"}
_SINGLE_TERMED = (Chain, Tuple, MatrixOf, Diag)


@dataclass(frozen=True, slots=True)
class Edit:
    """One edit of a printed statement.

    Parameters
    ----------
    kind
        One of "sign", "index", "exponent", "factor", "number", "term", "letter", "relation".
    description
        What it does, in words.
    tree
        The statement after the edit.
    """

    kind: str
    description: str
    tree: Tree


Local = tuple[str, str, Tree]


def edits(tree: Tree, notation: Notation | None = None) -> Iterator[Edit]:
    """Generate what a slip of the pen could have made of a printed statement.

    Parameters
    ----------
    tree
        The statement.
    notation
        With a notation the indices run over the range of their letter (otherwise 1, 2, 3), and only letters of one
        kind are exchanged.

    Yields
    ------
    Edit
        Each single edit in a fixed order, no tree twice and never the tree itself. An edited statement need not make
        sense: lowering it may be an error.
    """
    seen = {tree}
    for path, node, above in _places(tree):
        for kind, description, new in _local(node, above, tree, notation):
            edited = replaced(tree, path, new)
            if edited not in seen:
                seen.add(edited)
                yield Edit(kind, description, edited)


def _places(tree: Tree) -> Iterator[tuple[Path, Tree, Tree | None]]:
    nodes = dict(walk(tree))
    for path, node in nodes.items():
        yield path, node, nodes[path[:-1]] if path else None


def _local(node: Tree, above: Tree | None, whole: Tree, notation: Notation | None) -> Iterator[Local]:
    """The edits at one node."""
    if isinstance(above, Call) and above.function is node:
        return
    if isinstance(above, _SINGLE_TERMED):
        yield from _member(node)
    if isinstance(node, Add):
        yield from _terms(node)
    elif isinstance(node, Mul):
        yield from _factors(node)
        yield from _common_letter(node, whole, notation)
    elif isinstance(node, Pow):
        yield from _exponent(node)
    elif isinstance(node, Name):
        yield from _indices(node, whole, notation)
        yield from _letters(node, whole, notation)
        if not isinstance(above, Pow) and _is_factor(node, above, notation):
            yield "exponent", f"{to_latex(node)} squared", Pow(node, Number("2"))
    elif isinstance(node, Number):
        if not isinstance(above, Pow) or above.exponent is not node:
            yield from _number(node)
    elif isinstance(node, Chain):
        yield from _chain(node)
    elif isinstance(node, Div):
        yield from _fraction(node)
    elif isinstance(node, Derivative):
        yield from _order(node)
    elif isinstance(node, Sqrt):
        yield "exponent", f"root of {to_latex(node.value)} dropped", node.value
    elif isinstance(node, Call) and isinstance(node.function, str) and node.function in _SISTER:
        sister = _SISTER[node.function]
        yield "letter", f"{node.function} -> {sister} in {to_latex(node)}", replace(node, function=sister)


def _is_factor(node: Name, above: Tree | None, notation: Notation | None) -> bool:
    """Is this a scalar in a place where an exponent makes sense?"""
    if isinstance(above, Call | ElementsOf | Bars | Derivative | Integral | Mean):
        return False
    return _kind(node, notation) == "scalar"


def _kind(node: Name, notation: Notation | None) -> str:
    if notation is not None:
        letter = notation.find(node.letter, len(node.subscripts))
        return letter.kind if letter else "index"
    return "bold" if r"\mathbf" in node.letter or r"\boldsymbol" in node.letter else "scalar"


def _flipped(term: Tree) -> Tree:
    if isinstance(term, PlusMinus):
        return replace(term, minus=not term.minus)
    return term.value if isinstance(term, Neg) else Neg(term)


def _bare(term: Tree) -> Tree:
    return term.value if isinstance(term, Neg | PlusMinus) else term


def _member(node: Tree) -> Iterator[Local]:
    """A member of a chain or an entry of a matrix that is one term."""
    if not isinstance(node, Add) and node != Number("0"):
        yield "sign", f"sign of {to_latex(_bare(node))} changed", _flipped(node)
    if not isinstance(node, Number):
        yield "factor", f"factor 2 before {to_latex(node)}", _doubled(node)


def _doubled(term: Tree) -> Tree:
    if isinstance(term, Neg):
        return Neg(_doubled(term.value))
    return Mul((Number("2"), *(term.factors if isinstance(term, Mul) else (term,))))


def _terms(node: Add) -> Iterator[Local]:
    for k, term in enumerate(node.terms):
        before, after, shown = node.terms[:k], node.terms[k + 1 :], to_latex(_bare(term))
        rest = before + after
        yield "sign", f"sign of the term {shown} changed", Add((*before, _flipped(term), *after))
        yield "term", f"term {shown} dropped", rest[0] if len(rest) == 1 else Add(rest)
        yield "term", f"term {shown} printed twice", Add((*before, term, term, *after))
        if not isinstance(_bare(term), Number):
            yield "factor", f"factor 2 before the term {shown}", Add((*before, _doubled(term), *after))


def _factors(node: Mul) -> Iterator[Local]:
    for k, factor in enumerate(node.factors):
        before, after, shown = node.factors[:k], node.factors[k + 1 :], to_latex(factor)
        rest = before + after
        yield "factor", f"factor {shown} dropped", rest[0] if len(rest) == 1 else Mul(rest)
        if not isinstance(factor, Number | BigSum):
            yield "factor", f"factor {shown} printed twice", Mul((*before, factor, factor, *after))
        for neighbour in (*before[-1:], *after[:1]):
            if not isinstance(factor, Number) and not isinstance(neighbour, Number | BigSum):
                yield "factor", f"factor {shown} -> {to_latex(neighbour)}", Mul((*before, neighbour, *after))
        if after:
            yield from _exchanged(node, k)


def _exchanged(node: Mul, k: int) -> Iterator[Local]:
    """The indices of two neighbouring factors exchanged: all of them, or the last ones."""
    first, second = (f.base if isinstance(f, Pow) else f for f in node.factors[k : k + 2])
    if not (isinstance(first, Name) and isinstance(second, Name)) or len(first.subscripts) != len(second.subscripts):
        return
    pair = node.factors[k : k + 2]
    for kept in range(len(first.subscripts)):
        a = replace(first, subscripts=first.subscripts[:kept] + second.subscripts[kept:])
        b = replace(second, subscripts=second.subscripts[:kept] + first.subscripts[kept:])
        swapped = [replace(f, base=n) if isinstance(f, Pow) else n for f, n in zip(pair, (a, b), strict=True)]
        factors = (*node.factors[:k], *swapped, *node.factors[k + 2 :])
        yield "index", f"indices of {to_latex(first)} and {to_latex(second)} exchanged", Mul(factors)


def _exponent(node: Pow) -> Iterator[Local]:
    base, shown = node.base, to_latex(node)
    yield "exponent", f"exponent of {shown} dropped", base
    if isinstance(node.exponent, Number) and node.exponent.text.isdigit():
        value = int(node.exponent.text)
        for new in (value - 1, value + 1):
            if new > 1:
                yield "exponent", f"exponent {value} -> {new} in {shown}", Pow(base, Number(str(new)))


def _order(node: Derivative) -> Iterator[Local]:
    for k, (by, order) in enumerate(node.variables):
        for new in (order - 1, order + 1):
            if new:
                variables = (*node.variables[:k], (by, new), *node.variables[k + 1 :])
                yield "exponent", f"order {order} -> {new} of {to_latex(node)}", replace(node, variables=variables)


def _number(node: Number) -> Iterator[Local]:
    if node.text.isdigit():
        for new in (int(node.text) - 1, int(node.text) + 1):
            if new >= 0:
                yield "number", f"number {node.text} -> {new}", Number(str(new))


def _indices(node: Name, whole: Tree, notation: Notation | None) -> Iterator[Local]:
    subscripts = [s for n in _names(whole) for s in n.subscripts]
    letters = dict.fromkeys(s for s in subscripts if isinstance(s, str))
    letter = notation.find(node.letter, len(node.subscripts)) if notation is not None else None
    choices: list[int | str] = [*(letter.range if letter else (1, 2, 3)), *letters]
    for k, old in enumerate(node.subscripts):
        for new in choices:
            if new != old:
                changed: tuple[int | str, ...] = (*node.subscripts[:k], new, *node.subscripts[k + 1 :])
                yield "index", f"index {old} -> {new} in {to_latex(node)}", replace(node, subscripts=changed)
    if len(node.subscripts) == 2:
        yield "index", f"indices of {to_latex(node)} exchanged", replace(node, subscripts=node.subscripts[::-1])


def _names(whole: Tree) -> list[Name]:
    """All letters in printed order, without those of functions."""
    functions = {node.function for _, node in walk(whole) if isinstance(node, Call)}
    return [node for _, node in walk(whole) if isinstance(node, Name) and node not in functions]


def _likes(node: Name, whole: Tree, notation: Notation | None) -> list[str]:
    """The other letters of the statement with as many indices, of the same kind."""
    names = [n for n in _names(whole) if len(n.subscripts) == len(node.subscripts)]
    kind = _kind(node, notation)
    return list(dict.fromkeys(n.letter for n in names if n.letter != node.letter and _kind(n, notation) == kind))


def _letters(node: Name, whole: Tree, notation: Notation | None) -> Iterator[Local]:
    for letter in _likes(node, whole, notation):
        yield "letter", f"letter {node.letter} -> {letter} in {to_latex(node)}", replace(node, letter=letter)


def _common_letter(node: Mul, whole: Tree, notation: Notation | None) -> Iterator[Local]:
    """A letter that two or more factors share, another throughout: `J_1 J_2 J_3` -> `I_1 I_2 I_3`."""
    names = [f for f in node.factors if isinstance(f, Name)]
    for letter in dict.fromkeys(n.letter for n in names):
        alike = [n for n in names if n.letter == letter]
        for other in _likes(alike[0], whole, notation) if len(alike) > 1 else ():
            factors = tuple(replace(f, letter=other) if isinstance(f, Name) and f in alike else f for f in node.factors)
            yield "letter", f"letter {letter} -> {other} throughout {to_latex(node)}", Mul(factors)


def _fraction(node: Div) -> Iterator[Local]:
    yield "factor", f"{to_latex(node)} turned upside down", Div(node.bottom, node.top)
    yield "factor", f"denominator {to_latex(node.bottom)} dropped", node.top


def _chain(node: Chain) -> Iterator[Local]:
    for k, sign in enumerate(node.signs):
        if turned := _TURNED.get(sign):
            signs = (*node.signs[:k], turned, *node.signs[k + 1 :])
            yield "relation", f"{sign} turned into {turned}", Chain(node.members, signs)
    for k, member in enumerate(node.members):
        for other in dict.fromkeys(node.members):
            if other != member:
                members = (*node.members[:k], other, *node.members[k + 1 :])
                yield "relation", f"member {to_latex(member)} -> {to_latex(other)}", Chain(members, node.signs)


__all__ = ["KINDS", "Edit", "edits"]
