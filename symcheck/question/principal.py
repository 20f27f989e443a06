"""Complex numbers that are positive, in polar form: their angle is 0 where it is between -2 pi and 2 pi.

Given are f cos v = s and f sin v = 0. That f and s are positive, unless they are exponentials, and that v is between
-2 pi and 2 pi, are claims of their own; then v is 0 and f is s, and if both are exponentials, their exponents are
equal. What is left to trust is that a cosine and a sine which are 1 and 0 have no other angle there, and that
exponentials are positive and no two real numbers have the same.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import replace

from symcheck.core.calculus import fresh, letters, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import PI, Binder, Formula, Node, T, Term, mapped, node
from symcheck.question.series import FAULTS, Series
from symcheck.question.whole_powers import inlined
from symcheck.reading import from_sympy, to_sympy


def with_angles(problem: Problem) -> Series | None:
    """The problem with what such numbers say of their angles and sizes; None if there are none among what is given."""
    plain = inlined(problem)
    equations = [(name, f) for name, fs in plain.hypotheses for f in fs if f.tag == "="]
    for name, real in equations:
        for size, angle, whole in _polar(real):
            part = next((f for _, f in equations if _is_zero(f, size, angle)), None)
            if part is None or not letters(angle):
                continue
            beside = (real, part)
            said = [*_solved(angle, 0), *_equal(size, whole)]
            kept = [(other, tuple(f for f in fs if f not in beside)) for other, fs in plain.hypotheses]
            kept = [(other, fs) for other, fs in kept if fs]
            turn = node("*", 2, PI)
            sides = [node("<", angle, turn), node("<", node("-", turn), angle)]
            sides += [node(">", each, 0) for each in (size, whole) if not _is_exponential(each)]
            needed = tuple(replace(plain, claim=each, hypotheses=tuple(kept)) for each in sides)
            known, rest = in_turn(said)
            given = [(other, tuple(substituted(f, known) for f in fs)) for other, fs in (*kept, (name, rest)) if fs]
            there = replace(plain, claim=substituted(plain.claim, known), hypotheses=tuple(given))
            return Series(there, needed)
    return None


def in_general(problem: Problem) -> Problem:
    """The problem with letters for integrals and sums: what is proved of all numbers is so of these."""
    names = dict[Term, str]()
    trees = [problem.claim, *(f for _, fs in problem.hypotheses for f in fs), *(t for _, t in problem.definitions)]
    taken = set().union(*map(letters, trees))

    def put(tree: T) -> T:
        if isinstance(tree, Binder) and tree.tag in ("integral", "sum", "product"):
            return names.setdefault(tree, fresh(f"value_{len(names)}", taken))  # type: ignore[return-value]
        plain = isinstance(tree, Node) and not tree.bound  # inside of others they may depend on what is bound there
        return mapped(tree, put) if plain else tree  # type: ignore[return-value, arg-type, unused-ignore]

    given = tuple((name, tuple(map(put, fs))) for name, fs in problem.hypotheses)
    definitions = tuple((x, put(t)) for x, t in problem.definitions)
    return replace(problem, claim=put(problem.claim), hypotheses=given, definitions=definitions)


def _is_exponential(term: Term) -> bool:
    return term == 1 or (isinstance(term, Node) and term.tag == "exp")


def in_turn(equations: Iterable[Formula]) -> tuple[dict[str, Term], tuple[Formula, ...]]:
    """The letters that equations are solved for, each without the others, and the equations that say more of them."""
    known, rest = dict[str, Term](), list[Formula]()
    for equation in equations:
        head, value = substituted(equation, known).outside
        if isinstance(head, str) and head not in letters(value):
            known = {x: substituted(t, {head: value}) for x, t in known.items()} | {head: value}
        else:
            rest.append(node("=", head, value))
    return known, tuple(rest)


def _polar(equation: Formula) -> Iterator[tuple[Term, Term, Term]]:
    """(f, v, s) with f cos v = s."""
    for side, other in (equation.terms, equation.terms[::-1]):
        factors = side.outside if isinstance(side, Node) and side.tag == "*" else (side,)
        for k, factor in enumerate(factors):
            if isinstance(factor, Node) and factor.tag == "cos":
                yield _product(*factors[:k], *factors[k + 1 :]), factor.outside[0], other


def _is_zero(equation: Formula, size: Term, angle: Term) -> bool:
    """Does it say that f sin v is 0?"""
    wave = node("sin", angle)
    for side, other in (equation.terms, equation.terms[::-1]):
        factors = side.outside if isinstance(side, Node) and side.tag == "*" else (side,)
        if other == 0 and wave in factors:
            k = factors.index(wave)
            return _product(*factors[:k], *factors[k + 1 :]) == size
    return False


def _product(*factors: Term) -> Term:
    return node("*", *factors) if len(factors) > 1 else factors[0] if factors else 1


def _equal(size: Term, whole: Term) -> Iterator[Formula]:
    match size, whole:
        case Node(tag="exp", outside=(u,)), Node(tag="exp", outside=(w,)):
            yield from _solved(u, w)
        case Node(tag="exp", outside=(u,)), _:
            yield from _solved(u, 0 if whole == 1 else node("log", whole))
        case _:
            yield from _solved(size, whole)


def _solved(left: Term, right: Term) -> Iterator[Formula]:
    """An equation, solved for a letter that is multiplied by numbers alone."""
    import sympy

    with suppress(*FAULTS, sympy.PolynomialError):
        for x in sorted(letters(left) - letters(right)):
            line = sympy.Poly(to_sympy(left), sympy.Symbol(x, real=True))
            if line.degree() == 1 and line.nth(1).is_number and not line.nth(0).free_symbols:
                rest = node("+", right, node("-", from_sympy(line.nth(0)))) if line.nth(0) != 0 else right
                yield node("=", x, 0 if rest == 0 else node("/", rest, from_sympy(line.nth(1))))
                return
    yield node("=", left, right)
