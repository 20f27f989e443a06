"""Points at which equations hold, found by Newton's method: what follows from them must hold there, too.

Nothing is proved or refuted by these points: they tell which questions are worth asking.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence, Set
from contextlib import suppress
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from symcheck.core.verdicts import SymcheckError
from symcheck.document.letters import depends_on
from symcheck.document.survey import Said
from symcheck.question.antiderivatives import FAULTS
from symcheck.question.prepare import Asked, plainly, readings
from symcheck.question.repairs import likely
from symcheck.reading import to_latex, to_sympy

if TYPE_CHECKING:
    from sympy import Expr, Symbol

TRIED = 6  # points from which Newton's method begins, for letters of the same signs
POINTS = 4  # that are found: some may lie where a factor is zero that usually is not
ENOUGH = 2  # of these, those at which something does not hold by accident
STEPS = 25  # of the method; those that end at all end in ten
LONGEST = 0.5  # change of a logarithm in one step
FAR = 8.0  # logarithm beyond which letters have run away to zero or infinity
SMALL = 1e-9  # what is left of an equation that holds
EQUAL = 1e-6  # relative difference of sides that are equal at such a point
DIFFERENCE = 1e-6  # for derivatives
RANK = 1e-5  # relative size of what is no more than noise
Array = np.ndarray[Any, np.dtype[np.float64]]


class Equation(NamedTuple):
    """The difference of both sides, its size, and the letters on which it depends, in their order."""

    symbols: tuple[Symbol, ...]
    value: Callable[..., Any]
    size: Callable[..., Any]


class Placed(NamedTuple):
    """An equation, and where its letters stand among others."""

    equation: Equation
    places: tuple[int, ...]


class Found(NamedTuple):
    """Whether a relation holds for solutions of its sources, and whether these bind its letters to each other."""

    holds: bool
    bound: bool


@lru_cache(4096)  # of many sets that are compared the smaller ones are the same
def compared(relation: str, sources: tuple[str, ...], letters: Said, further: bool = False) -> Found | None:
    """How a relation compares with the equations from which it may follow; None where no points are found.

    Nor where it has further letters, unless it is asked whether it holds for all values of these.
    """
    try:
        asked, given, points = _equations(relation, letters), _all(sources, letters), _points(sources, letters)
    except (SymcheckError, *FAULTS):
        return None
    own = {symbol for equation in asked for symbol in equation.symbols}
    if not points or not (further or own <= points[0].keys()):
        return None
    points = _with_further(points, own)
    symbols = [*points[0]]
    with np.errstate(all="ignore"):
        jacobian = _jacobian(_placed(given, symbols), np.array([*points[0].values()]))
        rest = [k for k, symbol in enumerate(symbols) if symbol not in own]
        bound = _rank(jacobian) > _rank(jacobian[:, rest])
        return Found(_hold(asked, points) or (bound and _on_a_branch(asked, given, symbols)), bound)


def _with_further(points: Sequence[dict[Symbol, float]], own: Set[Symbol]) -> tuple[dict[Symbol, float], ...]:
    """The same points with values of further letters."""
    numbers, further = np.random.default_rng(4), sorted(own - points[0].keys(), key=str)
    return tuple(point | {symbol: numbers.uniform(0.3, 1.7) for symbol in further} for point in points)


def _on_a_branch(asked: Sequence[Equation], given: Sequence[Equation], symbols: Sequence[Symbol]) -> bool:
    """Whether a relation holds for some of the solutions of others, and takes no freedom from these.

    Of a quadratic equation each solution holds, and neither does at points of the other.
    """
    numbers, own, every = np.random.default_rng(2), _placed(given, symbols), _placed([*given, *asked], symbols)
    for signs in _signs(len(symbols), every):
        for _ in range(TRIED if np.all(signs > 0) else 1):
            point = _solved(every, signs * numbers.uniform(0.3, 1.7, len(symbols)))
            if point is not None and _rank(_jacobian(every, point)) == _rank(_jacobian(own, point)):
                return True
    return False


def slips(relation: str, sources: tuple[str, ...], letters: Said) -> Iterator[str]:
    """The relations one slip of the pen away that hold where the sources do, the likeliest first."""
    try:
        points = _points(sources, letters)
        reading = readings(plainly(Asked(relation, sources, (), letters)))[0]
    except (SymcheckError, *FAULTS):
        return
    for slip in likely(reading) if points else ():
        with suppress(SymcheckError, *FAULTS), np.errstate(all="ignore"):
            text = to_latex(slip.tree)
            equations = _equations(text, letters)
            own = {symbol for equation in equations for symbol in equation.symbols}
            if own and _hold(equations, _with_further(points, own)):
                yield text


def _all(sources: tuple[str, ...], letters: Said) -> list[Equation]:
    return [equation for source in sources for equation in _equations(source, letters)]


@lru_cache(1024)
def _points(sources: tuple[str, ...], letters: Said) -> tuple[dict[Symbol, float], ...]:
    """Points at which all equations hold, with letters of the same signs; none if the first is not found."""
    equations = _all(sources, letters)
    symbols = [*dict.fromkeys(symbol for equation in equations for symbol in equation.symbols)]
    numbers, placed = np.random.default_rng(1), _placed(equations, symbols)
    found: list[dict[Symbol, float]] = []
    with np.errstate(all="ignore"):
        for signs in _signs(len(symbols), placed):
            for tried in range(TRIED):
                point = _solved(placed, signs * numbers.uniform(0.3, 1.7, len(symbols)))
                if point is not None:
                    found.append(dict(zip(symbols, map(float, point), strict=True)))
                if len(found) == POINTS:
                    return tuple(found)
                if tried and not found:
                    break
            if found:
                break
    return tuple(found)


def _hold(equations: Sequence[Equation], points: Sequence[dict[Symbol, float]]) -> bool:
    """Whether equations hold at several points."""
    count = 0
    for point in points:
        values = np.array([*point.values()])
        count += all(_is_zero(each, values) for each in _placed(equations, [*point]))
    return count >= min(ENOUGH, len(points))


@lru_cache(4096)
def _equations(text: str, letters: Said) -> tuple[Equation, ...]:
    from sympy import lambdify

    own = tuple((x, phrase) for x, phrase in letters if x in text and all(y in text for y in depends_on(phrase)))
    found = []
    for problem in readings(plainly(Asked(text, letters=own)))[0].problems:
        left, right = (_plain(to_sympy(side)) for side in problem.claim.terms)
        if problem.definitions:
            raise SymcheckError("a value is defined here, and not compared")
        symbols = tuple(sorted(left.free_symbols | right.free_symbols, key=str))
        value, size = (lambdify(symbols, each, "numpy") for each in (left - right, abs(left) + abs(right)))
        found.append(Equation(symbols, value, size))
    return tuple(found)


def _signs(count: int, equations: Sequence[Placed]) -> Iterator[Array]:
    """Signs of letters, the likeliest first: all above zero, those of a solution, one of them below zero."""
    yield np.ones(count)
    numbers = np.random.default_rng(3)
    for _ in range(TRIED):
        point = _solved(equations, numbers.uniform(0.3, 1.7, count), free=True)
        if point is not None and np.any(point < 0):
            yield np.sign(point)
            break
    yield from 1.0 - 2.0 * np.eye(count)


def _plain(side: Expr) -> Expr:
    """A side with a letter for each function and rate of change: nothing but their values counts."""
    from sympy import Derivative, Symbol
    from sympy.core.function import AppliedUndef

    def letter(term: Expr) -> Symbol:
        named = isinstance(term, AppliedUndef) and all(isinstance(each, Symbol) for each in term.args)
        return Symbol(term.func.__name__ if named else str(term), real=True)

    for kind in (Derivative, AppliedUndef):
        side = side.replace(lambda term, kind=kind: isinstance(term, kind), letter)
    return side


def _placed(equations: Iterable[Equation], symbols: Sequence[Symbol]) -> list[Placed]:
    """To look for a letter takes SymPy longer than to evaluate an equation: it is done once."""
    places = {symbol: k for k, symbol in enumerate(symbols)}
    return [Placed(each, tuple(places[symbol] for symbol in each.symbols)) for each in equations]


def _at(function: Callable[..., Any], places: Sequence[int], point: Sequence[float]) -> float:
    value = complex(function(*[point[k] for k in places]))
    return value.real if not value.imag else float("nan")


def _values(equations: Sequence[Placed], point: Array) -> Array:
    numbers = [*point]
    return np.array([_at(each.equation.value, each.places, numbers) for each in equations])


def _jacobian(equations: Sequence[Placed], point: Array) -> Array:
    """Derivatives by the logarithms of the letters, which keep their signs so."""
    columns = []
    for k in range(len(point)):
        factor = np.ones(len(point))
        factor[k] += DIFFERENCE
        ahead, back = (_values(equations, each) for each in (point * factor, point / factor))
        columns.append((ahead - back) / (2 * DIFFERENCE))
    return np.array(columns).T.reshape(len(equations), len(point))


def _solved(equations: Sequence[Placed], point: Array, free: bool = False) -> Array | None:
    """A point near another one, with letters of the same signs unless they are free, at which all equations hold."""
    for _ in range(STEPS):
        values = _values(equations, point)
        if not np.all(np.isfinite(values)) or np.max(np.abs(np.log(np.abs(point))), initial=0.0) > FAR:
            return None
        if np.max(np.abs(values), initial=0.0) < SMALL:
            return point
        jacobian = _jacobian(equations, point)
        if not np.all(np.isfinite(jacobian)):
            return None
        if free:
            point = point + np.linalg.lstsq(jacobian / point, -values, rcond=RANK)[0]
            continue
        step = np.linalg.lstsq(jacobian, -values, rcond=RANK)[0]
        point = point * np.exp(step * min(1.0, LONGEST / max(float(np.max(np.abs(step))), LONGEST)))
    return None


def _is_zero(each: Placed, point: Array) -> bool:
    value, size = (_at(one, each.places, [*point]) for one in (each.equation.value, each.equation.size))
    return abs(value) <= EQUAL * max(size, EQUAL)


def _rank(jacobian: Array) -> int:
    if not jacobian.size or not np.all(np.isfinite(jacobian)):
        return 0
    sizes = np.linalg.svd(jacobian, compute_uv=False)
    return int(np.sum(sizes > RANK * max(float(sizes[0]), RANK)))
