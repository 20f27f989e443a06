r"""Relations up to terms of an order: `f(x) = p(x) + O(x^n)` says that the derivatives of f - p below n vanish at 0.

Of a quotient by a power of x, the derivatives of the top vanish below as many more.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce

from symcheck.core.calculus import letters
from symcheck.core.terms import Formula, Term, Value, node
from symcheck.core.verdicts import NoForm
from symcheck.reading.limits import quotient
from symcheck.reading.notation import Notation
from symcheck.reading.printing import to_latex
from symcheck.reading.tree import Add, Call, Div, Mul, Name, Neg, Number, Path, Tree, children, replaced, walk

INFINITE = ("n", "N", "m", "M", "T")  # of which orders are stated where they are large
MOST = 12  # derivatives: each is longer than the one before


def terms_of_order(*trees: Tree, notation: Notation) -> list[tuple[Tree, Path, Call]]:
    """The terms O(...) and o(...), with the tree in which they stand and where."""
    if all(letter.order is None for letter in notation.letters):
        return []
    return [
        (tree, path, part)
        for tree in trees
        for path, part in walk(tree)
        if isinstance(part, Call) and isinstance(part.function, Name) and _steps(part.function, notation) is not None
    ]


def _steps(name: Name, notation: Notation) -> int | None:
    letter = notation.find(name.letter, len(name.subscripts))
    return None if letter is None else letter.order


def without(tree: Tree, path: Path) -> Tree:
    """The tree without an addend there, or with a 0."""
    above = reduce(lambda part, k: children(part)[k], path[:-1], tree)
    if not path or not isinstance(above, Add):
        return replaced(tree, path, Number("0"))
    rest = tuple(part for k, part in enumerate(above.terms) if k != path[-1])
    return replaced(tree, path[:-1], Add(rest) if len(rest) > 1 else rest[0])


def coefficient(tree: Tree, path: Path) -> Tree:
    """What multiplies the addend at a path."""
    if not path:
        return Number("1")
    k, *below = path
    match tree:
        case Add():
            return coefficient(tree.terms[k], tuple(below))
        case Neg():
            return Neg(coefficient(tree.value, tuple(below)))
        case Mul():
            inner = coefficient(tree.factors[k], tuple(below))
            return Mul((*tree.factors[:k], inner, *tree.factors[k + 1 :]), tree.dotted)
        case Div() if k == 0:
            return Div(coefficient(tree.top, tuple(below)), tree.bottom)
    raise NoForm(f"{to_latex(tree)}: a term of an order that is no addend has no algebraic form")


def vanishing(gaps: Sequence[Term], size: Term, steps: int, factor: Term, printed: Tree) -> tuple[str, list[Formula]]:
    """The letter that goes to 0, and that the derivatives of each gap up to the order vanish there."""
    match size:
        case str(x):
            power = 1
        case Value(tag="^", terms=(str(x), int(power))) if power > 0:
            pass
        case _:
            raise NoForm(f"{to_latex(printed)}: only the order of a power of a letter that goes to 0 is decided")
    if power + steps > MOST:
        raise NoForm(f"{to_latex(printed)}: no order above {MOST} is decided")
    if x in INFINITE:
        raise NoForm(f"{to_latex(printed)}: does {x} go to 0, or to infinity? {x} is mostly a whole number")
    if x in letters(factor):
        raise NoForm(f"{to_latex(printed)}: its factor depends on {x}; write the product as one order")
    scaled = [gap if isinstance(factor, int) else node("/", gap, factor) for gap in gaps]
    tops = [_undivided(gap, x) for gap in scaled]
    if power + steps + max(more for _, more in tops) > MOST:
        raise NoForm(f"{to_latex(printed)}: no order above {MOST} is decided")
    formulas = [node("=", node("diff", top, x, n, 0), 0) for top, more in tops for n in range(power + steps + more)]
    return x, formulas


def _undivided(gap: Term, x: str) -> tuple[Term, int]:
    """What is divided by a power of the letter that goes to 0, and that power, by which the order of it is higher."""
    top, bottom = quotient(gap)
    if x not in letters(bottom):
        return gap, 0
    power = 0
    for factor in bottom.outside if isinstance(bottom, Value) and bottom.tag == "*" else (bottom,):
        match factor:
            case str() if factor == x:
                power += 1
            case Value(tag="^", terms=(base, int(n))) if base == x and n > 0:
                power += n
            case Value(tag="*", terms=parts) if all(part == x or x not in letters(part) for part in parts):
                power += sum(part == x for part in parts)
            case _ if x in letters(factor):
                return gap, 0
    return top, power
