"""Equations and conditions: they say how letters depend on each other, and nobody means them for all values."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Set
from contextlib import suppress

from symcheck.core.calculus import Unknown, functions, letters
from symcheck.core.problems import Problem
from symcheck.core.terms import Call, Connective, Formula, Node, Relation, Term
from symcheck.proof.algebra.polynomial import Unsupported, unfold
from symcheck.question import jets
from symcheck.question.conventions import mentioned, names
from symcheck.question.prepare import SIZE_SAID, Reading
from symcheck.reading import Notation, Tree
from symcheck.reading.evidence import spellings
from symcheck.reading.landau import terms_of_order
from symcheck.reading.tree import Chain, Limiting, MatrixOf, Mul, Name, Neg, Number, Piecewise, Pow, Transpose, walk

EQUATION = "it says how letters depend on each other of which nothing else is said: an equation or a condition"
FACTORS = frozenset({"-", "*", "/", "^", "sqrt", "pi"})  # what a product of letters is made of
ALGEBRAIC = FACTORS | {"+"}
PARTS = (r"^ { \Re }", r"^ { \Im }")  # the real and the imaginary part of a complex letter
Atom = tuple[str, ...]  # a letter, or an unknown function with its orders


def relates(problem: Problem, reading: Reading) -> bool:
    """Whether the claim says something of letters of which nothing else says anything.

    What is meant for all values of its letters has the same ones on both sides, but for a slip of the pen; here each
    side has letters of its own, or one of them is solved for what only it has.
    """
    asked, notation, tree = reading.source[0], reading.inference.notation, reading.tree
    if terms_of_order(tree, notation=notation) or any(isinstance(part, Limiting) for _, part in walk(tree)):
        return False  # what is claimed then is about coefficients and limits
    if _is_of_one_matrix(tree, notation) or _is_rough(tree):
        return True
    context = (*asked.where, *(text for text in asked.given if not SIZE_SAID.search(text)))
    known = spellings(*context) | {
        x.latex for x in notation.letters if len(x.latex) > 1 and mentioned(x.latex, context)
    }
    known |= {x.skew for x in notation.letters if x.skew and x.latex in known}
    known |= {x.latex for x in notation.letters if x.latex.endswith(PARTS) and x.latex.partition(" ^ ")[0] in known}
    integrated = any(part.tag == "integral" for part in jets.parts(problem.claim))
    with suppress(Unknown, Unsupported):
        problem = jets.expanded(problem)
    try:
        claim = unfold(problem.claim, dict(problem.definitions))
    except Unsupported:
        return True  # a derivative by a letter that is defined: nothing tells which others depend on it
    return _relates(claim, known, notation, _has_constant(tree), integrated)


def _has_constant(tree: Tree) -> bool:
    """Whether a member of a chain, or an entry of a matrix, is a number as printed."""
    members = [each for _, part in walk(tree) if isinstance(part, Chain) for each in part.members]
    entries = [each for _, part in walk(tree) if isinstance(part, MatrixOf) for row in part.rows for each in row]
    values = [each for _, part in walk(tree) if isinstance(part, Piecewise) for each, _ in part.cases]
    return any(not names(each) - {r"\pi"} for each in (*members, *entries, *values))


def _is_of_one_matrix(tree: Tree, notation: Notation) -> bool:
    """Is it an equation between products of one capital letter alone, as P^2 = P or A^{-1} = A^T?"""
    members = tree.members if isinstance(tree, Chain) else ()
    parts = [part for each in members for _, part in walk(each)]
    letter = names(tree) - {r"\pi"} - {each.latex for each in notation.letters if each.identity}
    capital = all(x.rstrip("}")[-1:].isupper() for x in letter)
    return (
        len(letter) == 1 and capital and all(isinstance(x, Mul | Pow | Transpose | Neg | Name | Number) for x in parts)
    )


def _is_rough(tree: Tree) -> bool:
    """Is it an equation of letters that holds nearly, for values that it does not tell?"""
    return isinstance(tree, Chain) and r"\approx" in tree.signs and bool(names(tree) - {r"\pi"})


def _relates(claim: Formula, known: Set[str], notation: Notation, constant: bool, integrated: bool) -> bool:
    if isinstance(claim, Connective):
        parts = claim.formulas[1:] if claim.tag == "=>" else claim.formulas
        return claim.tag != "<=>" and all(_relates(part, known, notation, constant, integrated) for part in parts)
    if not isinstance(claim, Relation):
        return False
    counts = [Counter(_atoms(side)) for side in claim.terms]
    printed = [{_printed(atom, notation) for atom in count} for count in counts]
    own = [
        {
            atom
            for atom in counts[k]
            if _latex(atom, notation) not in known and _printed(atom, notation) not in printed[1 - k]
        }
        for k in (0, 1)
    ]
    if all(own) or (not integrated and _is_property(claim, known, notation)):
        return True
    left, right = claim.terms
    return any(
        _says(side, other, mine)
        for side, other, mine in ((left, right, own[0]), (right, left, own[1]))
        if constant or letters(other) or functions(other)
    )


def _says(side: Term, other: Term, own: Set[Atom]) -> bool:
    """Whether a side says what its own letters are: a product of them, an unknown function, or what is constant."""
    if not own:
        return False
    if {name for name, *orders in own if orders} - functions(other) or _is_made_of(side, FACTORS):
        return True
    if letters(other) or functions(other):
        return False
    count, solvable = Counter(_atoms(side)), {*_atoms(side, ALGEBRAIC)}
    if any(count[atom] == 1 for atom in own & solvable):
        return True
    return _is_made_of(side, ALGEBRAIC) and (other == 0 or len(count) == 1)


def _is_property(claim: Relation, known: Set[str], notation: Notation) -> bool:
    """Is it of unknown functions at several places, as f(-x) = f(x)?"""
    calls = [part for part in jets.parts(claim) if isinstance(part, Call)]
    if any(part.bound for part in jets.parts(claim)):
        return False
    places = {call.function: {each.terms for each in calls if each.function == call.function} for call in calls}
    return any(len(several) > 1 and _latex((name,), notation) not in known for name, several in places.items())


def _atoms(tree: Term, through: Set[str] = frozenset()) -> Iterator[Atom]:
    """The letters and unknown functions as often as they stand there, perhaps under these operations alone."""
    if isinstance(tree, str):
        yield (tree,)
    elif isinstance(tree, Call):
        yield (tree.function, *map(str, tree.orders))
        for part in tree.terms if not through else ():
            yield from _atoms(part) if isinstance(part, Node) else ()
    elif isinstance(tree, Node) and (not through or tree.tag in through):
        for body in tree.inside if not through else ():
            yield from (atom for atom in _atoms(body) if atom[0] not in tree.bound)
        for part in tree.outside:
            yield from _atoms(part, through)


def _is_made_of(tree: Term, tags: Set[str]) -> bool:
    """Whether nothing but letters, unknown functions and numbers stands under these operations."""
    if not isinstance(tree, Node) or isinstance(tree, Call):
        return True
    return tree.tag in tags and all(_is_made_of(part, tags) for part in tree.outside)


def _printed(atom: Atom, notation: Notation) -> Atom:
    """The atom with the vector or matrix in the place of its component."""
    owner = notation.owner(atom[0])
    if owner is None or owner.kind == "scalar":
        return atom
    return owner.latex + "'" * atom[0].count("prime"), *atom[1:]


def _latex(atom: Atom, notation: Notation) -> str:
    owner = notation.owner(atom[0])
    return atom[0] if owner is None else owner.latex
