"""The forms of relations without an algebraic meaning: what is printed, part by part, and nothing that is not.

Whether `\\dot{x} = f(x, u)` is one equation or several cannot be told before it is said what x is, and `\\max_x f(x)`
has no value that can be calculated with. Such relations are statements all the same. Their forms are no terms: provers
and the checker do not read them, so that nothing can follow from what is left open.
"""

from __future__ import annotations

import itertools
import re
from collections import Counter
from dataclasses import fields

from symcheck.core.terms import Node, node
from symcheck.core.verdicts import Doubt, SymcheckError, Unsaid
from symcheck.reading.names import EXPECTED, INDEX_IN_NAME, INTEGRATED, KINDS_OPEN
from symcheck.reading.notation import Letter, Notation
from symcheck.reading.printing import to_latex
from symcheck.reading.relations import Relation
from symcheck.reading.tree import (
    Add,
    Call,
    Chain,
    Dots,
    Given,
    Indexed,
    Infinity,
    Interval,
    Limiting,
    Marked,
    Mul,
    Name,
    Neg,
    Number,
    Pair,
    Pow,
    System,
    Transpose,
    Tree,
    Tuple,
    Words,
    nodes,
)

_LEFT_OPEN = (INDEX_IN_NAME, INTEGRATED, KINDS_OPEN)  # doubts without a second way to read what is printed
_CHANGES = (r"\Delta", r"\delta", r"\nabla", "d", r"\text{d}")  # signs of changes and of derivatives
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
    beside = {part.name for part in nodes(tree) if isinstance(part, Words)}
    calls = [part for part in nodes(tree) if isinstance(part, Call) and part.arguments]
    clear = Counter(part.function for part in calls if not isinstance(part.arguments[0], Add))
    names = Counter(part for part in nodes(tree) if isinstance(part, Name))
    for part in nodes(tree):
        if isinstance(part, Name) and part not in beside:
            if _WORDS.match(part.letter):
                raise SymcheckError(f"{to_latex(part)}: words within a formula; write them beside it")
            letter = notation.find(part.letter, len(part.subscripts))
            if letter is not None and letter.doubt and not letter.doubt.startswith(_LEFT_OPEN):
                refuse_doubt(part, letter)
            if letter is not None and letter.open and names[part] > clear[part]:
                raise Doubt(f"{to_latex(part)}: a factor before brackets, or a function? say what it is")
        refuse_bare(part, notation)
        if isinstance(part, Mul) and (factor := _applied(part)) is not None:
            raise SymcheckError(f"{to_latex(part)}: is {to_latex(factor)} a factor, or applied to what follows?")
        if isinstance(part, Pow) and isinstance(part.base, Call) and part.base.arguments:
            raised = isinstance(part.base.function, Name) and not isinstance(part.exponent, Number)
            if raised and part.exponent != Neg(Number("1")):
                raise SymcheckError(f"{to_latex(part)}: a power, or a label? write brackets around the base")
        if isinstance(part, Marked) and isinstance(part.value, Call) and isinstance(part.value.function, str):
            raise SymcheckError(f"{to_latex(part)}: is that a function here? say what it is")
        if isinstance(part, Limiting) and part.operator == "int":
            raise SymcheckError(f"{to_latex(part)}: the integral does not say what it is taken over")
        if isinstance(part, Add) and (index := _index_behind(part)):
            raise SymcheckError(f"index {index} is summed over, and used outside of its sum, in {to_latex(part)}")
        if isinstance(part, Indexed) and not is_sequence(part):
            raise SymcheckError(f"{to_latex(part)}: a factor before brackets, or a function? write round brackets")


_SUMMED = re.compile(r"_\s*\{\s*(?:\(\s*)?([a-z])(?![A-Za-z])[^{}<>=]*\}")  # `\sum_i^N`, and over a set


def _index_behind(tree: Add) -> str:
    """An index under a sum that stands in the terms behind it too, so that the sum may reach further."""
    for k, each in enumerate(tree.terms):
        inner = each.value if isinstance(each, Neg) else each
        last = inner.factors[-1] if isinstance(inner, Mul) else inner
        found = _SUMMED.match(last.scripts) if isinstance(last, Limiting) and last.operator == "sum" else None
        used = "".join(map(to_latex, tree.terms[k + 1 :])) if found else ""
        if found and re.search(rf"[_\[]\s*\{{?(?:[^{{}}\[\]]*[^A-Za-z\\])?{found[1]}(?![A-Za-z])", used):
            return found[1]
    return ""


def _applied(tree: Mul) -> Tree | None:
    """What may be applied to, or be one name with, what stands behind it: no factor for certain."""
    row = isinstance(tree.factors[0], Tuple) and tree.factors[0].kind == "[]"
    lists = [each for each in tree.factors[row:] if isinstance(each, Dots | Tuple | Pair | Interval | Given)]
    if not all(isinstance(each, Tuple) and each.kind == "{}" and len(each.items) == 1 for each in lists):
        return tree.factors[0]
    for factor, after in itertools.pairwise(tree.factors):
        if isinstance(after, Tuple) and isinstance(factor.base if isinstance(factor, Pow) else factor, Name):
            return factor
        if isinstance(factor, Name) and _is_operator(factor):
            return factor
        if isinstance(after, Call) and isinstance(after.function, Name) and after.arguments:
            capitals = [
                isinstance(each, Name) and re.fullmatch("[A-Z]", each.letter) for each in (factor, after.function)
            ]
            if all(capitals):
                return factor
    return None


def _is_operator(name: Name) -> bool:
    """May this letter be an operator or a sign of a change?"""
    return name.letter.startswith(_OPERATORS) or (name.letter in _CHANGES and not name.subscripts)


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
    expected = isinstance(tree.name, Name) and tree.name.letter in EXPECTED
    return expected or len(tree.places) > 1 or all(map(_is_place, tree.places))


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
