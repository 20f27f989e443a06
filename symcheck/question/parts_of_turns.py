"""Sines and cosines of eighths, twelfths and other parts of half a turn, of which a multiple is well known."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import lcm

from symcheck.core.calculus import letters
from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import PI, Node, T, Term, mapped, node
from symcheck.proof.algebra.forms import number_term
from symcheck.proof.algebra.polynomial import Unsupported, number_of
from symcheck.question.jets import parts

ANGLE = "angle"  # the letter, and the name of the condition that says what it is
FINEST = 24  # parts of half a turn: of smaller ones nobody prints exact values
KNOWN = (1, 2, 3, 4, 6)  # parts whose sines and cosines are well known
_TURNING = ("sin", "cos", "tan")


def with_parts_of_turns(problem: Problem) -> Problem | None:
    """The problem about multiples of one angle a, with a = pi/q; None if there are no such angles."""
    trees = [problem.claim, *(f for _, fs in problem.hypotheses for f in fs), *(t for _, t in problem.definitions)]
    turns = {turn for tree in trees for part in parts(tree) if (turn := _turn(part)) is not None}
    q = lcm(*(turn.denominator for turn in turns))
    if all(turn.denominator in KNOWN for turn in turns) or q > FINEST or ANGLE in set().union(*map(letters, trees)):
        return None

    def put(tree: T) -> T:
        if isinstance(tree, Node) and (turn := _turn(tree)) is not None:
            angle = _times(int(turn * q), ANGLE)
            new = node(tree.tag, angle) if tree.tag != "tan" else node("/", node("sin", angle), node("cos", angle))
            return new  # type: ignore[return-value]
        return mapped(tree, put) if isinstance(tree, Node) else tree  # type: ignore[return-value]

    claim = put(problem.claim)
    hypotheses = tuple((name, tuple(map(put, formulas))) for name, formulas in problem.hypotheses)
    said = node("=", ANGLE, node("/", PI, q))
    multiple = next(m for m in range(1, q + 1) if Fraction(m, q).denominator in KNOWN)
    well_known = node("*", number_term(Fraction(multiple, q)), PI)
    hints: list[Applied[Term]] = [
        Applied("congruence", (node(f, _times(multiple, ANGLE)), node(f, well_known)), ()) for f in ("sin", "cos")
    ]
    hints += [Applied(name, (ANGLE,), ()) for name in ("positive_cosine", "positive_sine")]
    if claim.tag == "=":
        hints.append(Applied("equal_squares", claim.terms, ()))
    return replace(
        problem,
        claim=claim,
        definitions=tuple((name, put(term)) for name, term in problem.definitions),
        hypotheses=(*hypotheses, (ANGLE, (said,))),
        hints=(*problem.hints, *hints),
    )


def _times(number: int, letter: str) -> Term:
    return letter if number == 1 else node("*", number, letter)


def _turn(part: Node) -> Fraction | None:
    """Of a sine or cosine of a number of half turns: that number."""
    if part.tag not in _TURNING or letters(part):
        return None
    try:
        return number_of(node("/", part.outside[0], PI))
    except Unsupported:
        return None
