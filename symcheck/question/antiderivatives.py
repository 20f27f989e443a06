"""Hints about integrals and sums that SymPy works out: the proof then has to differentiate, or to take the step."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from functools import lru_cache
from itertools import permutations
from typing import TYPE_CHECKING

from symcheck.core.calculus import is_entire, letters, nodes, substituted
from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import INFINITY, Binder, End, Formula, Node, Term, Value, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.question.improper import improper, inverted
from symcheck.question.limit import OutOfTime, limited
from symcheck.reading import from_sympy, to_sympy

if TYPE_CHECKING:
    from sympy import Expr, Piecewise

THEOREMS = {"integral": ("antiderivative", "antiderivative_everywhere"), "sum": ("telescope",)}
CONVERGES = "antiderivative_converges"
INDUCTIVE = {"sum": "telescope", "product": "telescoping_product"}
# what SymPy raises for what it cannot do
FAULTS = (ArithmeticError, ValueError, TypeError, AttributeError, NotImplementedError, RecursionError)
KEPT = 512  # integrals and sums: what is one slip away from a relation has the same ones
SECONDS = 2.0  # for one integral: those that SymPy finds at all it finds in one


def hinted(problem: Problem) -> Problem:
    """The problem with hints for the integrals and sums to numbers or letters, the outer ones before those in them."""
    trees = [problem.claim, *(f for _, fs in problem.hypotheses for f in fs), *(t for _, t in problem.definitions)]
    found = dict.fromkeys(each for tree in trees for each in outermost(tree))
    hints = [hint for each in found for hint in _hints(each)[1]]
    hints += [hint for pair in permutations(found, 2) for hint in (*_scaled(*pair), *_moved(*pair))]
    hints += _claimed(problem.claim)
    return replace(problem, hints=(*problem.hints, *hints)) if hints else problem


def _claimed(claim: Formula) -> Iterator[Applied[Term]]:
    """That a sum or product up to a letter is what is claimed: the proof has to take the step from each number on."""
    for total, said in permutations(claim.terms, 2) if claim.tag == "=" else ():
        if isinstance(total, Binder) and total.tag in INDUCTIVE and _is_finite(total):
            (low, high), x = total.outside, total.letter
            last, ahead = _letter_of(high)
            if last and not {x, last} & letters(low) and x not in letters(said) and last not in letters(total.body):
                value = substituted(said, {last: node("+", x, -ahead) if ahead else x})
                if any(part.tag in ("sin", "cos") and x in letters(part) for part in nodes(value)):
                    continue  # as it may have a period, no theorem speaks of it
                yield Applied(INDUCTIVE[total.tag], (low, high), (((x,), total.body), ((x,), value)))


def _letter_of(end: Term) -> tuple[str, int]:
    """The letter of an upper end n or n + 1, and by how much the end is ahead of it; no letter for any other end."""
    match end:
        case str(x):
            return x, 0
        case Value(tag="+", terms=(str(x), int(k))):
            return x, k
        case Value(tag="+", terms=(str(x), Value(tag="-", terms=(int(k),)))):
            return x, -k
    return "", 0


def outermost(tree: Term) -> Iterator[Binder]:
    """Those that stand under no other."""
    if not isinstance(tree, Node):
        return
    if isinstance(tree, Binder) and tree.tag in THEOREMS:
        yield tree
    for part in tree.outside:
        yield from outermost(part)


def value_of(binder: Binder) -> Term:
    """What an integral or sum is by antiderivatives; itself if that is not found."""
    return _hints(binder)[0]


def _is_finite(binder: Binder) -> bool:
    return not any(isinstance(end, End) for end in binder.outside)


def _hints(binder: Binder) -> tuple[Term, list[Applied[Term]]]:
    """What an integral or sum is, with the theorems that say so; itself and none if that is not found."""
    inner: list[Applied[Term]] = []

    def known(tree: Term) -> Term:
        """The same without the integrals and sums that stand in it."""
        if isinstance(tree, Binder):
            value, more = _hints(tree) if tree.tag in THEOREMS and _is_finite(tree) else (tree, [])
            inner.extend(more)
            return value
        return mapped(tree, known) if isinstance(tree, Node) else tree

    body = known(binder.body)
    own = (binder.letter,)
    if not _is_finite(binder):
        return binder, [*_improper(binder), *inner]
    if binder.tag == "integral" and (kinks := _kinks(binder)):
        return binder, [*_in_pieces(binder, *kinks), *inner]
    if (closed := _closed(binder, body)) is None:
        return binder, [*_improper(binder), *inner]
    names = THEOREMS[binder.tag]
    if binder.tag == "integral" and is_entire(body, binder.letter) and is_entire(closed, binder.letter):
        names = names[1:]  # then the order of the ends does not matter
    outer = [Applied(name, tuple(binder.outside), ((own, binder.body), (own, closed))) for name in names]
    low, high = binder.outside
    at = [substituted(closed, {binder.letter: end}) for end in (high, low)]
    value = node("+", at[0], node("-", at[1])) if binder.tag == "integral" else at[0]
    endless = any(part.tag in ("pow", "log") for part in nodes(binder.body))  # at an end, perhaps
    return value, [*outer, *(_improper(binder) if endless else ()), *inner]


def _kinks(binder: Binder) -> list[tuple[Value, Term, Term]]:
    """The absolute values of increasing linear functions in an integrand, each with the function and its zero."""
    import sympy

    x, found = sympy.Symbol(binder.letter, real=True), list[tuple[Value, Term, Term]]()
    for part in dict.fromkeys(nodes(binder.body)):
        match part:
            case Value(tag="sqrt", terms=(Value(tag="^", terms=(inner, 2)),)) if binder.letter in letters(inner):
                with suppress(SymcheckError, *FAULTS):
                    line = sympy.expand(to_sympy(inner))
                    slope = sympy.diff(line, x)
                    if slope.is_positive and not slope.has(x):
                        found.append((part, inner, from_sympy(sympy.expand(x - line / slope))))
                    elif slope.is_negative and not slope.has(x):
                        found.append((part, node("-", inner), from_sympy(sympy.expand(x - line / slope))))
    return found


def _in_pieces(binder: Binder, kink: tuple[Value, Term, Term], *_: tuple[Value, Term, Term]) -> Iterator[Applied[Term]]:
    """The integral from both sides of where an absolute value has its corner."""
    root, line, place = kink
    own, (low, high) = (binder.letter,), binder.outside
    yield Applied("pieces", (place, low, high), ((own, binder.body),))
    for ends, side in (((low, place), node("-", line)), ((place, high), line)):
        yield Applied("equal_squares", (root, side), ())
        for call in (part for part in nodes(binder.body) if part.tag in ("exp", "sin", "cos")):
            if (other := replaced(call, root, side)) != call:
                yield Applied("congruence", (call, other), ())
        body = replaced(binder.body, root, side)
        if (closed := _closed(node("integral", body, binder.letter, *ends), body)) is not None:
            yield Applied("antiderivative", ends, ((own, binder.body), (own, closed)))


def replaced(tree: Term, part: Term, new: Term) -> Term:
    """The same with another term in the place of one."""
    if tree == part:
        return new
    return mapped(tree, lambda inner: replaced(inner, part, new)) if isinstance(tree, Node) else tree


def _scaled(wide: Binder, plain: Binder) -> Iterator[Applied[Term]]:
    """How one integral to infinity is another one, of which the letter is a multiple."""
    import sympy

    ends = wide.outside, plain.outside
    if wide.tag != "integral" or plain.tag != "integral" or any(end[1] != INFINITY or end[0] == 0 for end in ends):
        return
    with suppress(SymcheckError, OutOfTime, *FAULTS), limited(SECONDS):
        x = sympy.Symbol(wide.letter, positive=True)
        f, g, low, high = (_positive(each) for each in (wide.body, plain.body, ends[0][0], ends[1][0]))
        c = sympy.cancel(high / low)
        ratio = f / g.subs(sympy.Symbol(plain.letter, positive=True), c * x)
        a = sympy.simplify(sympy.powsimp(sympy.expand_power_base(ratio)))
        if not a.has(x):
            lambdas = ((wide.letter,), wide.body), ((plain.letter,), plain.body)
            yield Applied("scaled", (from_sympy(a), from_sympy(c), ends[0][0]), lambdas)


def _positive(tree: Term) -> Expr:
    """The same with all letters positive, as they are where powers of them are taken apart."""
    import sympy

    found = to_sympy(tree)
    return found.subs({symbol: sympy.Symbol(symbol.name, positive=True) for symbol in found.free_symbols})


def _moved(one: Binder, other: Binder) -> Iterator[Applied[Term]]:
    """How one integral between two ends is another one, of which the letter is a linear function."""
    if one.tag != "integral" or other.tag != "integral" or not (_is_finite(one) and _is_finite(other)):
        return
    import sympy

    with suppress(SymcheckError, OutOfTime, *FAULTS), limited(SECONDS):
        s, t, low, high = map(to_sympy, (*one.outside, *other.outside))
        for first, last in ((low, high), (high, low)):
            a = sympy.cancel((last - first) / (t - s))
            b = sympy.expand(first - a * s)
            if a.is_finite is not False and (a, b) != (1, 0):
                lambdas = ((one.letter,), one.body), ((other.letter,), other.body)
                yield Applied("moved", (from_sympy(a), from_sympy(b), *one.outside), lambdas)


@lru_cache(KEPT)
def _improper(binder: Binder) -> list[Applied[Term]]:
    import sympy  # noqa: F401 (an import that is interrupted by the limit would leave it broken)

    if binder.tag != "integral":
        return []
    for way in (improper, _inverted):
        with suppress(SymcheckError, OutOfTime, *FAULTS), limited(SECONDS):
            return way(binder.body, binder.letter, *binder.outside)
    return []


def _inverted(body: Term, x: str, low: Term, high: Term) -> list[Applied[Term]]:
    """An integral to infinity as one from 0 to 1, with the theorems that say what that is."""
    if high != INFINITY or isinstance(low, End):
        return []
    hints, inside = inverted(body, x, low)
    there = node("integral", inside, x, 0, 1)
    assert isinstance(there, Binder)
    hints += _hints(there)[1]
    primitives = [hint for hint in hints if hint.theorem.startswith("antiderivative")][:1]
    return [*hints, *(replace(hint, theorem=CONVERGES) for hint in primitives)]


@lru_cache(KEPT)
def _closed(binder: Binder, body: Term) -> Term | None:
    """The antiderivative of a body, or its sum up to a letter, if SymPy finds it."""
    import sympy

    x = sympy.Symbol(binder.letter, real=True)
    try:
        with limited(SECONDS):
            if binder.tag == "integral":
                found = sympy.integrate(to_sympy(body), x)
            else:
                found = sympy.summation(to_sympy(body), (x, to_sympy(binder.outside[0]), x))
            if found.has(sympy.Piecewise) and isinstance(found := sympy.piecewise_fold(found), sympy.Piecewise):
                found = _generic(found)  # the proof shows whether it is so
            if found.has(sympy.Integral, sympy.Sum, sympy.Piecewise):
                return None
            return from_sympy(_apart(found))
    except (SymcheckError, OutOfTime, *FAULTS):
        return None


def _apart(found: Expr) -> Expr:
    """The same with divisors as products, of whose factors is known that they do not vanish."""
    import sympy

    return found.replace(
        lambda e: e.is_Pow and e.exp.is_negative and e.base.is_Add, lambda e: sympy.factor(e.base) ** e.exp
    )


def _generic(found: Piecewise) -> Expr:
    """The piece for letters without special values."""
    import sympy

    primes = map(sympy.prime, range(5, 5 + len(found.free_symbols)))
    somewhere = dict(zip(sorted(found.free_symbols, key=str), map(sympy.sqrt, primes), strict=True))
    pieces = (piece.expr for piece in found.args if piece.cond.subs(somewhere) == sympy.true)
    return next(pieces, found.args[0].expr)
