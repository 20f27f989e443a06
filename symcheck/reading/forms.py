"""The forms of relations without an algebraic meaning: what is printed, part by part, and nothing that is not.

Whether `\\dot{x} = f(x, u)` is one equation or several cannot be told before it is said what x is, and `\\max_x f(x)`
has no value that can be calculated with. Such relations are statements all the same. Their forms are no terms: provers
and the checker do not read them, so that nothing can follow from what is left open.
"""

from __future__ import annotations

import itertools
import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import fields
from functools import cache
from typing import TypeGuard

from symcheck.core.terms import Node, node
from symcheck.core.verdicts import Doubt, SymcheckError, Unsaid
from symcheck.reading.faces import face
from symcheck.reading.functions import FIELDS
from symcheck.reading.names import INDEX_IN_NAME, INTEGRATED, KINDS_OPEN, STATES, is_expectation
from symcheck.reading.notation import Letter, Notation
from symcheck.reading.printing import to_latex
from symcheck.reading.relations import Relation
from symcheck.reading.tree import (
    Add,
    Bars,
    BigSum,
    Call,
    Chain,
    Div,
    Dots,
    Given,
    Indexed,
    Infinity,
    Interval,
    Limiting,
    Marked,
    MatrixOf,
    Mul,
    Name,
    Neg,
    Norm,
    Number,
    Operated,
    Pair,
    Pow,
    System,
    Transpose,
    Tree,
    Tuple,
    Words,
    children,
    nodes,
)

_LEFT_OPEN = (INDEX_IN_NAME, INTEGRATED, KINDS_OPEN, STATES)  # doubts without a second way to read what is printed
_CHANGES = (r"\Delta", r"\delta", r"\nabla", "d", r"\text{d}")  # signs of changes and of derivatives
# a derivative or an integral of some order, with its beginning at the left
_FRACTIONAL = re.compile(r"\\prescript \{[^{}]*(?:\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\}[^{}]*)*\} \{.*\} \{ [DIJ] \} [_^]")
_WORDS = re.compile(r"\\text\{[^}]*[~ $]")  # several words, or a formula among words
_OPERATORS = (r"\mathbb", r"\mathcal", r"\mathscr", r"\mathfrak")  # faces of expectations, transforms and sets


def form(relation: Relation, notation: Notation) -> Node:
    """The form of a relation: ("form", word, part, ...).

    Parameters
    ----------
    relation
        The relation.
    notation
        What the letters mean; of it only what is in doubt counts.

    Returns
    -------
    Node
        The form. Letters and numbers are words without parts, as they are printed.

    Raises
    ------
    SymcheckError
        If something in it may be meant in two ways.
    """
    tree = System((relation.tree,), relation.qualifiers) if relation.qualifiers else relation.tree
    _refuse(tree, notation)
    return _form(tree)


def _form(part: object) -> Node:
    if isinstance(part, Name | Number | Dots | Infinity):
        return node("form", to_latex(part))
    if isinstance(part, Chain) and len(part.signs) == 1:
        return node("form", part.signs[0], *map(_form, part.members))
    if isinstance(part, Tree):
        parts = (getattr(part, each.name) for each in fields(part))  # type: ignore[arg-type]
        return node("form", type(part).__name__, *map(_form, parts))
    if isinstance(part, tuple):
        return node("form", "", *map(_form, part))
    return node("form", str(part))


def _refuse(tree: Tree, notation: Notation) -> None:
    """SymcheckError for what may be meant in two ways."""
    parts = [*nodes(tree)]
    beside = {part.name for part in parts if isinstance(part, Words)}
    calls = [part for part in parts if isinstance(part, Call) and part.arguments]
    clear = Counter(part.function for part in calls if not isinstance(part.arguments[0], Add))
    names = Counter(part for part in parts if isinstance(part, Name))
    for part in parts:
        if isinstance(part, Name) and part not in beside:
            if _WORDS.match(part.letter):
                raise SymcheckError(f"{to_latex(part)}: words within a formula; write them beside it")
            letter = notation.find(part.letter, len(part.subscripts))
            if letter is not None and letter.doubt and not letter.doubt.startswith(_LEFT_OPEN):
                refuse_doubt(part, letter)
            if letter is not None and letter.open and names[part] > clear[part]:
                raise Doubt(f"{to_latex(part)}: a factor before brackets, or a function? say what it is")
        refuse_bare(part, notation)
        if isinstance(part, Mul):
            refuse_order(part, notation)
        if isinstance(part, Mul) and (factor := _applied(part)) is not None:
            raise SymcheckError(f"{to_latex(part)}: is {to_latex(factor)} a factor, or applied to what follows?")
        if isinstance(part, Pow) and isinstance(part.base, Call) and part.base.arguments:
            raised = isinstance(part.base.function, Name) and not isinstance(part.exponent, Number)
            if raised and part.exponent != Neg(Number("1")):
                raise SymcheckError(f"{to_latex(part)}: a power, or a label? write brackets around the base")
        if isinstance(part, Pow) and any(isinstance(x, Name) for x in nodes(part.exponent)):
            factors = part.base.factors if isinstance(part.base, Mul) else (part.base,)
            kinds = [notation.find(x.letter, len(x.subscripts)) for x in factors if isinstance(x, Name)]
            if any(letter is not None and letter.latex.startswith((r"\underline", r"\vec")) for letter in kinds):
                raise SymcheckError(f"{to_latex(part)}: a power of a vector, or a label? say what it is")
        if isinstance(part, Pow) and isinstance(part.base, Marked) and not isinstance(part.base.value, Norm | Bars):
            raise SymcheckError(f"{to_latex(part)}: between two places, or a power? write brackets around its base")
        averaged = part.base if isinstance(part, Pow) and isinstance(part.base, Call) else None
        if averaged and averaged.function == "average" and isinstance(averaged.arguments[0], Add):
            raise SymcheckError(f"{to_latex(part)}: the average of a sum, or its positive part? say what it is")
        if isinstance(part, Transpose) and _is_called(part.value) and Call(part.value.function, ()) in parts:
            raise SymcheckError(f"{to_latex(part)}: are these its arguments? write them before the T, or a product")
        if isinstance(part, Chain) and any(isinstance(x, MatrixOf) for x in part.members):
            refuse_laplacian(part)
        if isinstance(part, Chain) and part.signs[0] == "=" and any(map(_is_pair_in_braces, part.members)):
            raise SymcheckError(f"{to_latex(part)}: the bracket of two operators, or a set? say what it means")
        if isinstance(part, Add | Div | Neg) and any(
            _is_commutator(x) or _is_pair_in_braces(x) for x in children(part)
        ):
            raise SymcheckError(f"{to_latex(part)}: the bracket of two operators, or a list? say what it means")
        if isinstance(part, Marked) and isinstance(part.value, Call) and isinstance(part.value.function, str):
            raise SymcheckError(f"{to_latex(part)}: is that a function here? say what it is")
        if isinstance(part, Limiting) and part.operator == "int":
            raise SymcheckError(f"{to_latex(part)}: the integral does not say what it is taken over")
        if isinstance(part, Add) and (index := _index_behind(part)):
            raise SymcheckError(f"index {index} is summed over, and used outside of its sum, in {to_latex(part)}")
        if (
            isinstance(part, Operated)
            and part.sign == r"\circ"
            and isinstance(part.right, Call)
            and part.right.arguments
        ):
            raise SymcheckError(f"{to_latex(part)}: are both functions applied to these arguments? write brackets")
        if isinstance(part, Call) and is_of_value(part):
            raise SymcheckError(f"{to_latex(part)}: at this place, or of this value? write brackets")
        if isinstance(part, Indexed) and not is_sequence(part):
            raise SymcheckError(f"{to_latex(part)}: a factor before brackets, or a function? write round brackets")


def is_of_value(tree: Call) -> bool:
    r"""Whether a field is differentiated of which a value at numbers is printed, as in `\nabla f(2)`.

    Parameters
    ----------
    tree
        Anything with arguments.
    """
    if isinstance(tree.function, Name):
        return tree.function.letter.startswith(r"\nabla") and _is_value(tree)
    field = tree.function.partition("_")[0] in FIELDS
    return field and any(_is_value(part) for each in tree.arguments for part in nodes(each) if isinstance(part, Call))


def _is_value(tree: Call) -> bool:
    inside = [part for each in tree.arguments for part in nodes(each)]
    return any(isinstance(part, Number) for part in inside) and not any(isinstance(part, Name) for part in inside)


# `\sum_i^N`, over a set, and over pairs
_SUMMED = re.compile(
    r"_\s*\{\s*(?:\(\s*)?([a-z])(?![A-Za-z])[^<>=]*\}|_\s*\{\s*(?:<|\\langle)\s*([a-z])(?![A-Za-z]).*\}"
)


def _index_behind(tree: Add) -> str:
    """An index under a sum that stands in the terms behind it too, so that the sum may reach further."""
    for k, each in enumerate(tree.terms):
        used = ""
        for last in _reaching(each.value if isinstance(each, Neg) else each):
            rest = tree.terms[k + 1 :]
            used = used or "".join(map(to_latex, rest))
            if isinstance(last, BigSum):
                again = {index for term in rest for x in nodes(term) if isinstance(x, BigSum) for index in x.indices}
                open_ = (index for index in last.indices if index not in again and _labelled_by(index).search(used))
                if index := next(open_, ""):
                    return index
                continue
            found = _SUMMED.match(last.scripts)
            index = (found[1] or found[2]) if found else ""
            if (
                index
                and rf"_{{ {index} " not in used
                and re.search(rf"[_\[]\s*\{{?(?:[^{{}}\[\]]*[^A-Za-z\\])?{index}(?![A-Za-z])", used)
            ):
                return index
    return ""


@cache
def _labelled_by(index: str) -> re.Pattern[str]:
    """An index that stands in brackets above a letter: `y^{(i)}`."""
    return re.compile(rf"\^\s*\{{\s*\(\s*{re.escape(index)}\s*\)\s*\}}")


def _reaching(tree: Tree) -> Iterator[Limiting | BigSum]:
    """The sums and products that reach to the end of a term."""
    last = tree.factors[-1] if isinstance(tree, Mul) else tree
    if isinstance(last, BigSum):
        yield last
        yield from _reaching(last.body)
    if isinstance(last, Limiting) and last.operator in ("sum", "prod"):
        yield last
        yield from _reaching(last.body)


def _applied(tree: Mul) -> Tree | None:
    """What may be applied to, or be one name with, what stands behind it: no factor for certain."""
    row = isinstance(tree.factors[0], Tuple) and tree.factors[0].kind == "[]"
    lists = [each for each in tree.factors[row:] if isinstance(each, Dots | Tuple | Pair | Interval | Given)]
    if not all(isinstance(each, Tuple) and each.kind == "{}" and len(each.items) == 1 for each in lists):
        return tree.factors[0]
    for factor, after in itertools.pairwise(tree.factors):
        if isinstance(after, Tuple) and isinstance(factor.base if isinstance(factor, Pow) else factor, Name):
            return factor
        if isinstance(factor, Indexed) and isinstance(factor.name, Name) and _is_operator(factor.name):
            return factor
        if isinstance(factor, Name) and (_is_operator(factor) or (factor == Name(factor.letter) and _is_entry(after))):
            return factor
        if isinstance(after, Call) and isinstance(after.function, Name) and after.arguments:
            capitals = [
                isinstance(each, Name) and re.fullmatch("[A-Z]", each.letter) for each in (factor, after.function)
            ]
            if all(capitals):
                return factor
    return None


# a capital letter, bold or not, perhaps with an index
_CAPITAL = re.compile(r"(?:\\(?:mathbf|boldsymbol|bm)\{)?[A-Z]\}?(?:_.+)?")


def refuse_operator(tree: Tree, notation: Notation) -> None:
    """An error for an equation that begins with a capital before the value of a function and nothing more: `T f(x) =`.

    Parameters
    ----------
    tree
        A relation.
    notation
        What the letters mean; only those that were inferred may be operators.
    """
    first = tree.members[0] if isinstance(tree, Chain) and notation.inferred and tree.signs[0] == "=" else None
    if not isinstance(first, Mul) or len(first.factors) != 2:
        return
    name, value = first.factors
    if (
        not isinstance(value, Call)
        or not isinstance(value.function, Name)
        or value.function.dots
        or not value.arguments
    ):
        return
    if isinstance(name, Name) and _CAPITAL.fullmatch(name.letter) and Counter(nodes(tree))[name] == 1:
        shown = to_latex(name)
        raise Doubt(
            f"{shown}: a factor, or applied to {to_latex(value.function)}? write \\cdot, or brackets around both"
        )


def refuse_factor(tree: Tree, notation: Notation) -> None:
    """An error for a letter before brackets with a product that is transposed elsewhere: `(A B)^T W (A B)`.

    Parameters
    ----------
    tree
        A relation.
    notation
        What the letters mean; only those that were inferred may be factors.
    """
    found = [part.value for part in nodes(tree) if isinstance(part, Transpose) and isinstance(part.value, Mul)]
    for part in nodes(tree) if found and notation.inferred else ():
        if isinstance(part, Call) and isinstance(part.function, Name) and part.arguments[:1] in [(x,) for x in found]:
            raise Doubt(f"{to_latex(part.function)}: a factor before brackets, or a function? say what it is")


def _is_entry(tree: Tree) -> bool:
    """May this be an entry of what a function before it gives: `f(x)_i`?"""
    values = (Name, Mul, Call)
    return isinstance(tree, Marked) and tree.mark.startswith("_") and isinstance(tree.value, values)


def _is_called(tree: Tree) -> TypeGuard[Call]:
    """Is this a function before brackets that hold more than one letter, as those of `x(t)` do?"""
    return isinstance(tree, Call) and bool(tree.arguments) and not all(map(_is_plain, tree.arguments))


def _is_pair_in_braces(tree: object) -> bool:
    """Is this `{f, g}`, which may be the bracket of both, and hardly a set of numbers?"""
    pair = tree.items if isinstance(tree, Tuple) and tree.kind == "{}" else ()
    return len(pair) == 2 and all(isinstance(part, Name | Call) for part in pair)


def _is_commutator(tree: object) -> bool:
    return isinstance(tree, Tuple) and tree.kind == "[]" and len(tree.items) == 2


def _has_letters(tree: Tree) -> bool:
    return any(isinstance(part, Name) for part in nodes(tree))


def refuse_order(tree: Mul, notation: Notation) -> None:
    """An error for a product of numbers in which a letter stands twice, but not as a power of it.

    Parameters
    ----------
    tree
        The product.
    notation
        What the letters mean; only those that were inferred may be other than numbers.
    """
    if not notation.inferred or len(tree.factors) < 3:
        return
    names = [factor.base if isinstance(factor, Pow) else factor for factor in tree.factors]
    for k, name in enumerate(names):
        if not isinstance(name, Name) or name not in names[k + 2 :] or names[k + 1] == name:
            continue
        letter = notation.find(name.letter, len(name.subscripts))
        own = [factor for factor, other in zip(tree.factors[k:], names[k:], strict=True) if other == name]
        if name.letter.islower() and any(isinstance(each, Pow) and _has_letters(each.exponent) for each in own):
            continue  # a density times its variable
        if (
            letter is not None
            and letter.kind == "scalar"
            and not (letter.depends or letter.components or letter.number or letter.doubt)
        ):
            raise Doubt(
                f"{to_latex(tree)}: does the order of its factors count? write the power of {to_latex(name)}, or say "
                "that it is a matrix"
            )


def _is_operator(name: Name) -> bool:
    """May this letter be an operator or a sign of a change?"""
    return (
        name.letter.startswith(_OPERATORS)
        or _FRACTIONAL.match(name.letter) is not None
        or (name.letter in _CHANGES and not name.subscripts)
    )


def refuse_doubt(tree: Tree, letter: Letter) -> None:
    """An error if something is in doubt about a letter.

    Parameters
    ----------
    tree
        Where it stands.
    letter
        The letter.
    """
    if letter.doubt:
        error = Unsaid if letter.doubt.startswith(_LEFT_OPEN) else Doubt
        raise error(f"{to_latex(tree)}: {letter.doubt}")


def refuse_laplacian(chain: Chain) -> None:
    """An error for a matrix that is equal to a Laplacian: some print the matrix of second derivatives so."""
    for member in chain.members:
        if isinstance(member, Call) and member.function == "laplacian":
            raise SymcheckError(f"{to_latex(member)}: the Laplacian, or the matrix of second derivatives? say which")


def refuse_bare(tree: Tree, notation: Notation) -> None:
    """An error for a function that is transposed, and behind which brackets were taken for a factor.

    Parameters
    ----------
    tree
        Any part of a relation.
    notation
        What the letters mean; one that was inferred has functions only where brackets always stand behind them.
    """
    if notation.inferred and isinstance(tree, Transpose) and isinstance(tree.value, Call) and not tree.value.arguments:
        name = tree.value.function
        letter = notation.find(name.letter, len(name.subscripts)) if isinstance(name, Name) else None
        if letter is not None and letter.kind == "function":
            raise SymcheckError(
                f"{to_latex(tree)} before brackets: do they hold its arguments? write them before the T"
            )


def is_sequence(tree: Indexed) -> bool:
    """Whether the places are such as of a sequence or a function, around which nobody puts brackets of a product.

    Parameters
    ----------
    tree
        A letter before square brackets.
    """
    expected = isinstance(tree.name, Name) and is_expectation(tree.name.letter)
    listed = len(tree.places) > 1 and not any(
        isinstance(part, _NO_PLACES) or _is_bold(part) for place in tree.places for part in nodes(place)
    )
    return expected or listed or all(map(_is_place, tree.places))


def _is_bold(tree: Tree) -> bool:
    return isinstance(tree, Name) and bool(face(tree.letter))


_NO_PLACES = (Mul, Div, Limiting, Transpose)


def _is_place(tree: Tree) -> bool:
    """Is this a number, a plain letter, or one more or less than that?"""
    if isinstance(tree, Add | Neg):
        return any(isinstance(part, Number) for part in nodes(tree)) and all(
            isinstance(part, Add | Neg | Number) or _is_plain(part) for part in nodes(tree)
        )
    return isinstance(tree, Number) or _is_plain(tree)


def _is_plain(tree: Tree) -> bool:
    if not isinstance(tree, Name) or tree != Name(tree.letter):
        return False
    return tree.letter in _LAST or (tree.letter.isalpha() and tree.letter.islower())


_LAST = frozenset("NMKT")  # places of the last entry of a sequence
