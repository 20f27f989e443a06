"""Hints about roots: that of a square is the number or its negative, what is not negative has one square, and powers
with fractions for exponents."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

from symcheck.core.calculus import nodes
from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import Node, Relation, Term, Value, node
from symcheck.core.verdicts import SymcheckError
from symcheck.question.antiderivatives import FAULTS, SECONDS
from symcheck.question.limit import OutOfTime, limited
from symcheck.reading import from_sympy, to_sympy

MOST = 4  # absolute values: each doubles the cases


def rooted(problem: Problem) -> Problem:
    """The problem with hints for absolute values, and for an equation with roots of anything else."""
    trees = [problem.claim, *(f for _, fs in problem.hypotheses for f in fs), *(t for _, t in problem.definitions)]
    roots = [*dict.fromkeys(part for part in nodes(*trees) if part.tag == "sqrt")]
    hints = [hint for part in roots[:MOST] for hint in _of_square(part)]
    shorter = [hint for part in roots[:MOST] for hint in _of_fraction(part)]
    claim = problem.claim
    bound = any(part.bound for part in nodes(*trees))
    if isinstance(claim, Relation) and claim.tag == "=" and len(hints) < 2 * len(roots) and not bound:
        hints += [*shorter, Applied("equal_squares", claim.terms, ())]
    powers = dict.fromkeys(part for part in nodes(*trees) if part.tag == "pow" and not bound)
    hints += [hint for part in [*powers][:MOST] for hint in _of_power(part)]
    if isinstance(claim, Relation) and claim.tag == "=":
        for one, other in (claim.terms, claim.terms[::-1]):
            match one:
                case Value(tag="pow", terms=(base, Value(tag="/", terms=(1, int(q))))) if q > 1:
                    hints.append(Applied("power_inverse", (other, q, base), ()))
    return replace(problem, hints=(*problem.hints, *hints)) if hints else problem


def _of_power(power: Node) -> Iterator[Applied[Term]]:
    """Of which number a power with a fraction p/q for its exponent is the root, so that its q-th power is known."""
    match power.outside:
        case (base, Value(tag="/", terms=(int(p), int(q)))) if q > 1:
            raised: Term = base if p == 1 else node("^", base, p)
            root = node("pow", raised, node("/", 1, q))
            if p != 1:
                yield Applied("power_of_power", (base, p, node("/", 1, q)), ())
            yield Applied("power_inverse", (raised, node("/", 1, q), root), ())
            match base:
                case Value(tag="^", terms=(inner, int(n))):
                    yield Applied("power_of_power", (inner, n, node("/", p, q)), ())


def _of_fraction(root: Node) -> Iterator[Applied[Term]]:
    """What the square of a root is in lowest terms, which divide by nothing else."""
    import sympy

    (inner,) = root.outside
    if not any(part.tag == "/" for part in nodes(inner)):
        return
    with suppress(SymcheckError, OutOfTime, *FAULTS), limited(SECONDS):
        lowest = from_sympy(sympy.cancel(sympy.together(to_sympy(inner))))
        if lowest != inner:
            yield Applied("root", (lowest,), ())


def _of_square(root: Term) -> Iterator[Applied[Term]]:
    match root:
        case Value(terms=(Value(tag="^", terms=(inner, 2)),)) if not isinstance(inner, int):
            yield Applied("equal_squares", (root, inner), ())
            yield Applied("equal_squares", (root, node("-", inner)), ())
