"""Hints about roots: that of a square is the number or its negative, what is not negative has one square, and powers
with fractions for exponents."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from math import lcm

from symcheck.core.calculus import nodes
from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import Node, Relation, Term, Value, node
from symcheck.core.verdicts import SymcheckError
from symcheck.proof.algebra.forms import number_term
from symcheck.proof.algebra.polynomial import number_of
from symcheck.question.antiderivatives import FAULTS, SECONDS
from symcheck.question.limit import OutOfTime, limited
from symcheck.reading import from_sympy, to_sympy

HALF = Fraction(1, 2)
FINEST = 12  # roots of one number: of the twelfth, others are powers
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
        hints += [*shorter, *(Applied("equal_squares", sides, ()) for sides in _without_common(*claim.terms))]
    powers = dict.fromkeys(part for part in nodes(*trees) if part.tag == "pow" and not bound)
    hints += [hint for part in [*powers][:MOST] for hint in _of_power(part)]
    if not bound:
        hints += [*_of_one_root([*powers], roots), *_of_exponentials([*powers], [*nodes(*trees)])]
        hints += [hint for part in [*powers][:MOST] for hint in _of_logarithm(part)]
    if isinstance(claim, Relation) and claim.tag == "=":
        for one, other in (claim.terms, claim.terms[::-1]):
            match one:
                case Value(tag="pow", terms=(base, Value(tag="/", terms=(1, int(q))))) if q > 1:
                    hints.append(Applied("power_inverse", (other, q, base), ()))
    return replace(problem, hints=(*problem.hints, *hints)) if hints else problem


def _without_common(left: Term, right: Term) -> Iterator[tuple[Term, Term]]:
    """Both sides, and both without the factors that they share, of which the signs may be unknown."""
    yield left, right
    first, second = Counter(_factors(left)), Counter(_factors(right))
    if first & second:
        yield _product(first - second), _product(second - first)


def _factors(term: Term) -> tuple[Term, ...]:
    if isinstance(term, Value) and term.tag == "*":
        return tuple(factor for each in term.terms for factor in _factors(each))
    return (term,)


def _product(factors: Counter[Term]) -> Term:
    several = [*factors.elements()]
    return node("*", *several) if len(several) > 1 else several[0] if several else 1


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


def _of_one_root(powers: Sequence[Node], roots: Sequence[Node]) -> Iterator[Applied[Term]]:
    """How powers of one base are those of one root of it, by one more factor at a time."""
    exponents = dict[Term, set[Fraction]]()
    for base, exponent in (power.outside for power in powers):
        if (number := number_of(exponent)) is not None and number > 0 and number.denominator > 1:
            exponents.setdefault(base, set()).add(number)
    for base, fractions in exponents.items():
        root = node("sqrt", base)
        every = fractions | ({HALF} if root in roots else set())
        q = lcm(*(each.denominator for each in every))
        if len(every) == 1 or q > FINEST or max(every) > 1:
            continue
        if root in roots:
            half = node("pow", base, number_term(HALF))
            yield Applied("power_inverse", (base, number_term(HALF), half), ())
            yield Applied("equal_squares", (root, half), ())
        for k in range(2, int(max(every) * q) + 1):
            yield Applied("power_of_sum", (base, number_term(Fraction(k - 1, q)), number_term(Fraction(1, q))), ())


def _of_exponentials(powers: Sequence[Node], parts: Sequence[Node]) -> Iterator[Applied[Term]]:
    """Powers as exponentials, where the logarithm of their base stands in an exponent."""
    exponents = [each for part in parts if part.tag == "exp" for each in nodes(part.outside[0])]
    for base, exponent in (power.outside for power in powers):
        if node("log", base) in exponents:
            yield Applied("power_as_exp", (base, exponent), ())


def _of_logarithm(power: Node) -> Iterator[Applied[Term]]:
    """What a power is whose exponent is a logarithm over that of its base, as in a^(log x/log a)."""
    base, exponent = power.outside
    if not any(part.tag == "/" for part in nodes(exponent)) or node("log", base) not in nodes(exponent):
        return
    whole = node("*", exponent, node("log", base))
    if (lowest := _in_lowest_terms(whole)) is not None:
        yield Applied("power_as_exp", (base, exponent), ())
        yield Applied("congruence", (node("exp", whole), node("exp", lowest)), ())


def _in_lowest_terms(term: Term) -> Term | None:
    import sympy

    with suppress(SymcheckError, OutOfTime, *FAULTS), limited(SECONDS):
        return from_sympy(sympy.cancel(sympy.together(to_sympy(term))))
    return None


def _of_fraction(root: Node) -> Iterator[Applied[Term]]:
    """What the square of a root is in lowest terms, which divide by nothing else."""
    (inner,) = root.outside
    if any(part.tag == "/" for part in nodes(inner)) and (lowest := _in_lowest_terms(inner)) not in (None, inner):
        yield Applied("root", (lowest,), ())


def _of_square(root: Term) -> Iterator[Applied[Term]]:
    match root:
        case Value(terms=(Value(tag="^", terms=(inner, 2)),)) if not isinstance(inner, int):
            yield Applied("equal_squares", (root, inner), ())
            yield Applied("equal_squares", (root, node("-", inner)), ())
