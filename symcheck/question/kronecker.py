r"""Kronecker products of matrices of all sizes, by what they do: (A \otimes B) vec X is vec(B X A^T).

Two matrices are equal if they do the same with every X, for which a letter of its own stands. What is left to trust is
that, and that the transpose and the inverse of such a product are those of its factors, and its trace that of both.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from symcheck.core.verdicts import NoForm, SymcheckError
from symcheck.question.prepare import Asked, Reading
from symcheck.reading import Tree, tex, to_latex
from symcheck.reading.tree import Add, Call, Chain, Mul, Name, Neg, Number, Operated, Pow, Transpose, nodes

SIGN = r"\otimes"
LETTERS = "XYZWKGHQ"
TRACES = ("tr", "Tr")
Pair = tuple[int, Tree, Tree]  # a sign and both factors


def without_products(reading: Reading) -> Asked | None:
    """The question about products of matrices that says the same; None where there are no Kronecker products alone."""
    asked, tree = reading.source[0], reading.tree
    if not any(isinstance(part, Operated) for part in nodes(tree)):
        return None
    texts = (asked.relation, *asked.where, *asked.given)
    taken = {text for each in texts for text in tex.texts(each)}
    free = next((x for x in LETTERS if x not in taken), None)
    kinds = {x.latex: x.kind for x in reading.inference.notation.letters}
    names = {part.letter for part in nodes(tree) if isinstance(part, Name)}
    if free is None or asked.where or any(kinds.get(x) != "matrix" for x in names):
        return None
    try:
        if not isinstance(tree, Chain) or tree.signs != ("=",):
            raise NoForm("no equation")
        left, right = tree.members
        sides = _sides(left, right, Name(free))
    except SymcheckError:
        return None
    said = dict(asked.letters) | {x: "matrix" for x in (*sorted(names), free) if x not in dict(asked.letters)}
    relation = to_latex(Chain(sides, ("=",)))
    return replace(asked, relation=relation, letters=tuple(said.items()))


def is_of_matrices(reading: Reading) -> bool:
    """Whether a reading takes for matrices what Kronecker products are made of, and what has columns."""
    kinds = {x.latex: x.kind for x in reading.inference.notation.letters}
    whole = (part for part in nodes(reading.tree) if isinstance(part, Operated) or _is_column(part))
    return all(kinds.get(x.letter) == "matrix" for part in whole for x in nodes(part) if isinstance(x, Name))


def _is_column(tree: Tree) -> bool:
    return isinstance(tree, Call) and tree.function == "vec"


def _sides(left: Tree, right: Tree, x: Tree) -> tuple[Tree, Tree]:
    for made in (_with_traces, _of_columns):
        if (sides := (made(left), made(right))) != (left, right) and None not in sides:
            return sides  # type: ignore[return-value]
    return _applied(left, x), _applied(right, x)


def _with_traces(tree: Tree) -> Tree | None:
    """A number, traces of Kronecker products as products of traces; None if there are other such products."""
    match tree:
        case Call(str() as name, (inner,)) if name in TRACES and _has(inner):
            return _sum((sign, Mul((Call(name, (a,)), Call(name, (b,))))) for sign, a, b in _pairs(inner))
        case Call(str() as name, _) if name in TRACES:
            return tree
        case Mul(factors, ()) | Add(factors):
            parts = [_with_traces(each) for each in factors]
            whole = tuple(each for each in parts if each is not None)
            return type(tree)(whole) if len(whole) == len(parts) else None
    return None


def _of_columns(tree: Tree) -> Tree | None:
    """The matrix whose columns stand below one another; None if it is no such column."""
    match tree:
        case Call("vec", (inner,)):
            return None if _has(inner) else inner
        case Add(terms):
            parts = [_of_columns(each) for each in terms]
            whole = tuple(each for each in parts if each is not None)
            return Add(whole) if len(whole) == len(parts) else None
        case Neg(inner):
            value = _of_columns(inner)
            return None if value is None else Neg(value)
        case Mul((*factors, Call("vec", (inner,))), ()) if not _has(inner):
            return _done(_pairs(Mul(tuple(factors)) if factors[1:] else factors[0]), inner)
    return None


def _applied(tree: Tree, x: Tree) -> Tree:
    return _done(_pairs(tree), x)


def _done(pairs: Sequence[Pair], x: Tree) -> Tree:
    """What a sum of products makes of a matrix."""
    return _sum((sign, Mul((b, x, Transpose(a)))) for sign, a, b in pairs)


def _sum(terms: Iterator[tuple[int, Tree]]) -> Tree:
    signed = tuple(term if sign > 0 else Neg(term) for sign, term in terms)
    return Add(signed) if signed[1:] else signed[0]


def _has(tree: Tree) -> bool:
    return any(isinstance(part, Operated) for part in nodes(tree))


def _pairs(tree: Tree) -> list[Pair]:
    """A sum of Kronecker products; NoForm for anything else."""
    match tree:
        case Operated(sign, left, right) if sign == SIGN and not _has(left) and not _has(right):
            return [(1, left, right)]
        case Add(terms):
            return [pair for term in terms for pair in _pairs(term)]
        case Neg(inner):
            return [(-sign, a, b) for sign, a, b in _pairs(inner)]
        case Transpose(inner):
            return [(sign, Transpose(a), Transpose(b)) for sign, a, b in _pairs(inner)]
        case Mul((first, *rest), ()):
            found = _pairs(first)
            for each in rest:
                found = [(s * t, Mul((a, c)), Mul((b, d))) for s, a, b in found for t, c, d in _pairs(each)]
            return found
        case Pow(base, Neg(Number("1")) as exponent):
            match _pairs(base):
                case [(1, a, b)]:
                    return [(1, Pow(a, exponent), Pow(b, exponent))]
    raise NoForm("no sum of Kronecker products")
