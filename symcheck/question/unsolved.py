"""Whether a relation that stands alone is meant for some values of its letters: an equation to be solved, a condition.

What is meant for all values is nearly always one slip of the pen away from something true; what is to be solved is not.
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterator
from contextlib import suppress
from fractions import Fraction
from itertools import pairwise

from symcheck.checker.enclosures import enclosed
from symcheck.core.calculus import Unknown, functions, letters, nodes, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import Binder, Call, Connective, Formula, Malformed, Node, Relation, Term, mapped, node
from symcheck.proof.algebra.polynomial import Unsupported, unfold
from symcheck.question import jets
from symcheck.question.conventions import names
from symcheck.question.prepare import DEFINED, Reading
from symcheck.reading import Notation, Tree
from symcheck.reading.landau import terms_of_order
from symcheck.reading.tree import Chain, Limiting, Mul, Name, Neg, Pow, Transpose, walk

SAMPLED = tuple(
    Fraction(n, 6) for n in (1, 2, 4, 5, 7, 9, 11, 13, 16, 19, 25, 31, 62, 125, -1, -4, -7, -11, -16, -25, -80)
)
POINTS = 60  # nearly all that changes its sign does so among the first twenty
FEW = 4  # addends of sums to a letter
OPERATORS = frozenset({"integral", "sum", "product", "diff", "mean"})  # what is to be worked out


def may_be_solved(problem: Problem, reading: Reading) -> bool:
    """Whether it may be an equation or a condition, as nothing else is said and it is so of some values alone."""
    notation = reading.inference.notation
    inexact = terms_of_order(reading.tree, notation=notation) or any(
        isinstance(part, Limiting) for _, part in walk(reading.tree)
    )
    if _rests_on_more(problem, reading) or inexact:
        return False  # what is claimed of limits is about coefficients
    worked_out = any(part.tag in OPERATORS for part in nodes(problem.claim))
    with suppress(Unknown, Unsupported):
        problem = jets.expanded(problem)
    claim = unfold(problem.claim, dict(problem.definitions))
    parts = [*_relations(claim)]
    return any(_has_own(part, notation) or _is_circular(part) for part in parts) or (
        _is_of_other_matrices(reading.tree, notation)
        or (not worked_out and isinstance(claim, Relation) and _is_of_numbers(reading) and _changes_sign(claim))
    )


def is_condition(problem: Problem, reading: Reading) -> bool:
    """Whether it is an order that is strictly so at some places and not at others, and nothing else is said."""
    claim = _concluded(unfold(problem.claim, dict(problem.definitions)))
    order = isinstance(claim, Relation) and claim.tag in ("<", "<=", ">", ">=")
    return order and not _rests_on_more(problem, reading) and _changes_sign(claim)


def _rests_on_more(problem: Problem, reading: Reading) -> bool:
    """Is anything else said of its letters? An equation that only says what another letter is, is not about them."""
    asked, _, defined, *_ = reading.source
    said = problem.definitions or any(name != DEFINED for name, _ in problem.hypotheses)
    return bool(asked.given or (asked.where and (said or names(reading.tree) & defined.keys())))


def _concluded(claim: Formula) -> Formula:
    return claim.formulas[1] if isinstance(claim, Connective) and claim.tag == "=>" else claim


def _is_of_numbers(reading: Reading) -> bool:
    printed = names(reading.tree)
    return all(
        x.kind in ("scalar", "function", "index") for x in reading.inference.notation.letters if x.latex in printed
    )


def _relations(claim: Formula) -> Iterator[Relation]:
    claim = _concluded(claim)
    if isinstance(claim, Relation) and claim.tag == "=":
        yield claim
    elif isinstance(claim, Connective) and claim.tag in ("and", "or"):
        for part in claim.formulas:
            yield from _relations(part)


def _has_own(claim: Relation, notation: Notation) -> bool:
    """Whether a side has a letter that the other has not, or which alone is compared with a number."""
    own, every = (
        [{_owner(x, notation) for x in letters_in(side)} for side in claim.terms] for letters_in in (_atoms, _names)
    )
    return bool(own[0] - every[1] or own[1] - every[0])


def _names(tree: Term) -> set[str]:
    return letters(tree) | functions(tree)


def _owner(atom: str, notation: Notation) -> str:
    """The vector or matrix in the place of its component."""
    letter = notation.owner(atom)
    return atom if letter is None else letter.latex


def _atoms(tree: Term) -> Iterator[str]:
    """The letters and unknown functions, but those that stand in a term beside the letter that it binds."""
    if isinstance(tree, str):
        yield tree
    elif isinstance(tree, Call):
        yield tree.function
    elif isinstance(tree, Node):
        for body in tree.inside:
            if not isinstance(tree, Binder) or tree.letter not in letters(body):
                yield from _atoms(body)
        for part in tree.outside:
            yield from _atoms(part)


def _is_circular(claim: Relation) -> bool:
    """Does it say of a letter what it is by that letter and others?"""
    left, right = claim.terms
    return any(
        isinstance(side, str) and side in letters(other) and letters(other) - {side}
        for side, other in ((left, right), (right, left))
    )


def _is_of_other_matrices(tree: Tree, notation: Notation) -> bool:
    """Is it an equation between products of matrices that are not the same ones on both sides, as M^T J M = J?"""
    members = tree.members if isinstance(tree, Chain) else ()
    found = [_matrices(each, notation) for each in members]
    return None not in found and any(a != b for a, b in pairwise(found))


def _matrices(tree: Tree, notation: Notation) -> Counter[str] | None:
    match tree:
        case Neg(inner) | Transpose(inner) | Pow(inner, _):
            return _matrices(inner, notation)
        case Mul(factors):
            parts = [_matrices(each, notation) for each in factors]
            return None if None in parts else sum(filter(None, parts), Counter())
        case Name(latex):
            letter = notation.find(latex, 0)
            return Counter([latex]) if letter is not None and letter.kind == "matrix" else None
    return None


def _changes_sign(claim: Formula) -> bool:
    """Whether one side is greater at some places and less at others; not where both are the same at many."""
    left, right = claim.terms
    gap = node("+", left, node("-", right))
    plain = _without_calls(gap, {})
    free, rng, signs, same = sorted(letters(plain)), random.Random(1), set[bool](), 0
    whole = {x for part in nodes(plain) if part.tag in ("sum", "product") for x in letters(node("+", *part.outside))}
    for point in range(POINTS if free else 0):
        values = [SAMPLED[point]] if len(free) == 1 and point < len(SAMPLED) else rng.choices(SAMPLED, k=len(free))
        numbers: dict[str, Term] = {x: node("/", q.numerator, q.denominator) for x, q in zip(free, values, strict=True)}
        numbers |= dict.fromkeys(whole & {*free}, 1 + point % FEW)
        with suppress(Unknown, Malformed, RecursionError, ArithmeticError):
            digits = enclosed(substituted(plain, numbers))
            if digits.low > 0 or digits.high < 0:
                signs.add(digits.low > 0)
            else:
                same += 1
    return len(signs) == 2 and same < POINTS // 4


def _without_calls(tree: Term, known: dict[Term, str]) -> Term:
    if isinstance(tree, Call):
        return known.setdefault(tree, f"value_{len(known)}")
    return mapped(tree, lambda part: _without_calls(part, known)) if isinstance(tree, Node) else tree
