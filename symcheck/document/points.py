"""Points at which equations hold, found by Newton's method: what follows from them must hold there, too.

Nothing is proved or refuted by these points: they tell which questions are worth asking.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from contextlib import suppress
from dataclasses import replace
from functools import cache, lru_cache, reduce
from itertools import chain
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from symcheck.core.calculus import letters as letters_of
from symcheck.core.verdicts import SymcheckError
from symcheck.document.applied import NOTHING, Known, is_special, known_of, lettered, valued
from symcheck.document.letters import depends_on, is_of
from symcheck.document.macros import bare
from symcheck.document.quadrature import integral
from symcheck.document.survey import Said
from symcheck.question.antiderivatives import FAULTS
from symcheck.question.cases import CASE
from symcheck.question.matrices import open_matrices
from symcheck.question.prepare import Asked, alone_of, plainly, readings, worded
from symcheck.question.repairs import likely, missing
from symcheck.reading import to_latex, to_sympy

if TYPE_CHECKING:
    from sympy import Basic, Expr, Symbol

    from symcheck.core.problems import Problem

_PRIMED = re.compile(r"'\s*\}?\s*(?:\\left\s*)?\(|\\d+ot\{[^{}]*\}\s*(?:\\left\s*)?\(")  # a rate at a place: w'(a)
# a letter with two indices below it
_ENTRY = re.compile(r"(\\?[A-Za-z]+(?:\{[^{}]*\})?)_\{\s*([a-z0-9])\s*,?\s*([a-z0-9])\s*\}")
TRIED = 6  # points from which Newton's method begins, for letters of the same signs
MANY = 24  # points at which equations are evaluated that say what letters are
POINTS = 4  # that are found: some may lie where a factor is zero that usually is not
ANYWHERE = 12  # points for a relation that ought to hold for all values: at many it has no real ones
ENOUGH = 2  # of these, those at which something does not hold by accident
STEPS = 25  # of the method; those that end at all end in ten
LONGEST = 0.5  # change of a logarithm in one step
FAR = 8.0  # logarithm beyond which letters have run away to zero or infinity
SMALL = 1e-9  # what is left of an equation that holds
EQUAL = 1e-6  # relative difference of sides that are equal at such a point
DIFFERENCE = 1e-6  # for derivatives
MOST_RATES = 12  # that are worked out: equations of motion of three letters have six
TIME = "t"  # the letter by which rates are those of all that moves, and no partial ones
RANK = 1e-5  # relative size of what is no more than noise
Array = np.ndarray[Any, np.dtype[np.float64]]
Own = tuple[tuple[Any, tuple[Any, ...]], ...]  # functions, each with the letters behind it for which it stands alone


class Equation(NamedTuple):
    """Both sides, with the letters on which they depend, in their order."""

    symbols: tuple[Symbol, ...]
    shared: frozenset[Symbol]  # the letters on both sides
    plain: tuple[Expr, Expr]  # the sides with a letter for each function, rate of change and integral of functions
    unknown: frozenset[Expr]  # these functions, rates and integrals
    printed: tuple[Expr, Expr]  # the sides as they are printed
    primed: bool  # is a rate there that of a function at a place? So w'(a) is no rate of w by a


class System(NamedTuple):
    """The sides of equations as steps of NumPy, each with the places of its values among letters, numbers and steps.

    What sides have in common, as the entries of an inverse matrix have nearly all, is one step.
    """

    numbers: tuple[complex, ...]
    steps: tuple[tuple[Callable[..., Any], tuple[int, ...]], ...]
    sides: tuple[tuple[int, int], ...]


class Found(NamedTuple):
    """Whether a relation holds for solutions of its sources, and whether these bind its letters as much as it does."""

    holds: bool
    bound: bool


@lru_cache(4096)  # of many sets that are compared the smaller ones are the same
def compared(relation: str, sources: tuple[str, ...], letters: Said, further: bool = False) -> Found | None:
    """How a relation compares with the equations from which it may follow; None where no points are found.

    Nor where one side alone has further letters, unless it is asked whether it holds for all values of these. Texts
    rarely say that a matrix is symmetric: what holds if those are that nothing says holds.
    """
    found = _compared(relation, sources, letters, further)
    if found is None or found.holds or not (symmetric := _symmetric((relation, *sources), letters)):
        return found
    other = _compared(relation, (*sources, *symmetric), letters, further)
    return other if other is not None and other.holds else found


def _symmetric(texts: Sequence[str], letters: Said) -> list[str]:
    """That the matrices are symmetric of which no equation says what they are."""
    every = dict.fromkeys(x for text in texts for x in _matrices(text, letters))
    whole = [f"{x}^T = {x}" for x in every if not any(bare(text).startswith(f"{bare(x)}=") for text in texts)]
    return whole + symmetric_entries(texts)


def symmetric_entries(texts: Iterable[str]) -> list[str]:
    """That letters are equal of which one has the two indices of the other below it, the other way round."""
    found = {(x, first, second) for text in texts for x, first, second in _ENTRY.findall(text)}
    pairs = sorted((x, a, b) for x, a, b in found if a < b and (x, b, a) in found)
    return [f"{x}_{{{a}{b}}} = {x}_{{{b}{a}}}" for x, a, b in pairs]


@lru_cache(4096)
def _matrices(text: str, letters: Said) -> tuple[str, ...]:
    """The matrices in a text that are no identity, and not made of a vector or printed components."""
    with suppress(SymcheckError, *FAULTS):
        return tuple(open_matrices(readings(plainly(Asked(text, letters=_own(text, letters))))[0]))
    return ()


def _compared(relation: str, sources: tuple[str, ...], letters: Said, further: bool) -> Found | None:
    try:
        asked, own_ = _asked(relation, sources, letters)
        unknown = _unknown(asked)
        given = _all(sources, letters, unknown, own_)
        own, known = ({symbol for equation in every for symbol in equation.symbols} for every in (asked, given))
        free = {symbol for equation in asked for symbol in equation.shared}
        points = _points(sources, letters, unknown, own_) if further or own <= known | free else ()
    except (SymcheckError, *FAULTS):
        return None
    if not points:
        return None
    points = _with_further(points, own)
    zero = {symbol for symbol, value in points[0].items() if value == 0}
    asked, given = ([_without(each, zero) for each in every] for every in (asked, given))
    symbols = [symbol for symbol in points[0] if symbol not in zero]
    if not symbols:
        return Found(_hold(asked, points), bound=False)
    with np.errstate(all="ignore"):
        jacobian = _jacobian(_placed(given, symbols), np.array([points[0][symbol] for symbol in symbols]))
        rest = [k for k, symbol in enumerate(symbols) if symbol not in own]
        parts = max(_rank(_jacobian(_placed(asked, symbols), np.array([points[0][x] for x in symbols]))), 1)
        bound = _is_operated(asked, given, own_) or _rank(jacobian) - _rank(jacobian[:, rest]) >= parts
        return Found(_hold(asked, points) or (bound and _on_a_branch(asked, given, symbols)), bound)


def _is_operated(asked: Iterable[Equation], given: Iterable[Equation], own: Own) -> bool:
    """Is a relation about rates and integrals of functions, or their values at places, which are all said?"""
    known, values = Known(own=dict(own)), {equation.plain[0] for equation in given}
    terms = {lettered(term, known, each.primed)[0] for each in asked for term in each.unknown if not _is_plain(term)}
    return bool(terms) and terms <= values


def _is_plain(term: Expr) -> bool:
    """Is it a function at its own letters?"""
    from sympy.core.function import AppliedUndef

    return isinstance(term, AppliedUndef) and all(x.is_Symbol for x in term.args)


@lru_cache(4096)
def idle(relation: str, sources: tuple[str, ...], letters: Said) -> frozenset[int]:
    """Which sources say nothing of a relation: identities, and those with a letter or rate of their own."""
    try:
        every = [_equations(text, letters) for text in (relation, *sources)]
    except SymcheckError:
        return frozenset()
    known = _known(chain.from_iterable(every[1:]), every[0], letters)
    asked, *each = ([_fitted(equation, known) for equation in own] for own in every)
    unknown = _unknown(chain(asked, *each))
    own = [{symbol for equation in every for symbol in equation.symbols} for every in (asked, *each)]
    with np.errstate(all="ignore"):
        found = {n for n, every in enumerate(each) if _hold(every, _with_further(({},) * POINTS, own[n + 1]))}
    rows = [(n, symbols, symbols) for n, symbols in enumerate(own, -1) if n not in found]
    for n, given in ((n, given) for n, given in enumerate(each) if n not in found):
        rows += [(n, {*x.symbols}, {*x.plain[:1]}) for x in _further(given, unknown, known)]
    while True:
        count = Counter(symbol for _, symbols, _ in rows for symbol in symbols)
        left = [row for row in rows if row[0] < 0 or all(count[x] > 1 for x in row[2])]
        if len(left) == len(rows):
            return frozenset({*range(len(each))} - {n for n, _, _ in rows})
        rows = left


def _with_further(points: Sequence[Mapping[Symbol, float]], own: Set[Symbol]) -> tuple[dict[Symbol, float], ...]:
    """The same points with values of further letters."""
    numbers, further = np.random.default_rng(4), sorted(own - points[0].keys(), key=str)
    return tuple({**point, **{symbol: numbers.uniform(0.3, 1.7) for symbol in further}} for point in points)


def _on_a_branch(asked: Sequence[Equation], given: Sequence[Equation], symbols: Sequence[Symbol]) -> bool:
    """Whether a relation holds for some of the solutions of others, and takes no freedom from these.

    Of a quadratic equation each solution holds, and neither does at points of the other.
    """
    numbers, own, every = np.random.default_rng(2), _placed(given, symbols), _placed([*given, *asked], symbols)
    for signs in _signs(len(symbols), every):
        found = _solved(every, signs * numbers.uniform(0.3, 1.7, signs.shape))
        if any(_rank(_jacobian(every, point)) == _rank(_jacobian(own, point)) for point in found[_is_found(found)]):
            return True
    return False


def slips(relation: str, sources: tuple[str, ...], letters: Said) -> Iterator[str]:
    """The relations one slip of the pen away that hold where the sources do, the likeliest first."""
    try:
        asked, own = _asked(relation, sources, letters)
        points = _points(sources, letters, _unknown(asked), own)
        given = (equation.printed for source in sources for equation in _equations(source, letters))
        known = replace(known_of(given, (), letters), own=dict(own))
        reading = readings(plainly(Asked(relation, sources, (), letters)))[0]
    except (SymcheckError, *FAULTS):
        return
    alone = alone_of(reading)
    if not points:
        return
    values = _Values(points)
    for slip in chain(likely(reading), missing(reading)):
        with suppress(SymcheckError, *FAULTS), np.errstate(all="ignore"):
            equations = [*_sides(worded(alone, slip.tree), known, asked[0].primed)]
            if any(side.free_symbols for both in equations for side in both) and values.hold(equations):
                yield to_latex(slip.tree)


class _Values:
    """Values of expressions at several points. What many relations have in common is evaluated once."""

    def __init__(self, points: Sequence[Mapping[Symbol, float]]) -> None:
        self.points = len(points)
        self.known: dict[Basic, Any] = {x: np.array([point[x] for point in points]) for x in points[0]}
        self.numbers = np.random.default_rng(4)

    def of(self, tree: Basic) -> Any:
        if tree not in self.known:
            self.known[tree] = self._of(tree)
        return self.known[tree]

    def _of(self, tree: Basic) -> Any:
        if tree.is_Symbol:  # of which the points say nothing
            return self.numbers.uniform(0.3, 1.7, self.points)
        if not tree.args:
            return _number(tree)
        return _function(tree)(*map(self.of, _parts(tree)))

    def hold(self, equations: Iterable[Sequence[Expr]]) -> bool:
        """Whether equations hold at several of the points."""
        held = np.full(self.points, True)
        for both in equations:
            left, right = (np.asarray(self.of(side), complex) for side in both)
            left, right = (np.where(side.imag == 0, side.real, np.nan) for side in (left, right))
            held &= np.abs(left - right) <= EQUAL * np.fmax(np.abs(left) + np.abs(right), EQUAL)
        return int(np.count_nonzero(held)) >= min(ENOUGH, self.points)


def _parts(tree: Basic) -> Sequence[Basic]:
    """The parts from whose values an expression has its value; of an integral or a case these are its letters."""
    from sympy import Expr, Integral

    if isinstance(tree, Integral):
        return _integral(tree)[0]
    return tree.args if all(isinstance(part, Expr) for part in tree.args) else sorted(tree.free_symbols, key=str)


def _function(tree: Basic) -> Callable[..., Any]:
    """What makes the value of an expression of those of its parts."""
    from sympy import Integral

    if isinstance(tree, Integral):
        return _integral(tree)[1]
    parts = _parts(tree)
    if parts is tree.args:
        return _evaluated(tree.func, len(parts))
    return _written(parts, tree)


@lru_cache(1024)
def _integral(tree: Any) -> tuple[Sequence[Basic], Callable[..., Any]]:
    """The bounds and other letters of an integral, and what makes its values of theirs."""
    *inner, (variable, *bounds) = tree.limits
    if len(bounds) < len(("low", "high")):
        raise SymcheckError("an integral without bounds has no value")
    body = tree.func(tree.function, *inner) if inner else tree.function
    letters_ = sorted(body.free_symbols - {variable}, key=str)
    system = _placed([_Sides((body, body))], [variable, *letters_])

    def value(low: Any, high: Any, *values: Any) -> Any:
        every = np.broadcast_arrays(low, high, *values)
        count = every[0].size

        def integrand(x: Array) -> Any:
            own = [np.broadcast_to(each.reshape(count, 1), x.shape).ravel() for each in every[2:]]
            differences = _evaluate(system, [x.ravel(), *own])[0]
            return np.broadcast_to(differences, x.size).reshape(x.shape)

        return integral(integrand, every[0].ravel(), every[1].ravel(), count)

    return (*bounds, *letters_), value


class _Sides(NamedTuple):
    """What is evaluated alone."""

    plain: tuple[Expr, Expr]


@cache
def _evaluated(function: Any, count: int) -> Callable[..., Any]:
    """A function of SymPy as one of NumPy; to write out one for each expression would take far longer."""
    from sympy import Add, Dummy, Mul, Pow

    if function in (Add, Mul):
        combined = np.add if function is Add else np.multiply
        return combined if count == 2 else lambda *values: reduce(combined, values)
    if function is Pow:
        return _power
    letters = [Dummy() for _ in range(count)]
    return _written(letters, function(*letters))


def _power(base: Any, exponent: Any) -> Any:
    """A power; that of NumPy takes ten times as long for the usual exponents."""
    if isinstance(exponent, float):
        if exponent == 2.0:
            return base * base
        if exponent == -1.0:
            return np.divide(1.0, base)
        if exponent == 0.5:
            return np.sqrt(base)
    return np.float_power(base, exponent)


def _written(symbols: Sequence[Basic], tree: Basic) -> Callable[..., Any]:
    """A function of NumPy with the value of an expression."""
    from sympy import lambdify

    found: Callable[..., Any] = lambdify(symbols, tree, "numpy")
    return found


def is_source(relation: str, others: tuple[str, ...], letters: Said) -> bool:
    """Does the last one of the others follow from all of them before it and the relation?"""
    *rest, last = others
    found = compared(last, (*rest, relation), letters)
    return found is not None and found.holds and found.bound


def slips_of_source(relation: str, others: tuple[str, ...], letters: Said) -> Iterator[str]:
    """The relations one slip of the pen away that are such a source, the likeliest first."""
    with suppress(SymcheckError, *FAULTS):
        for slip in likely(readings(plainly(Asked(relation, (), (), letters)))[0]):
            if is_source(text := to_latex(slip.tree), others, letters):
                yield text


def _unknown(equations: Iterable[Equation]) -> frozenset[Expr]:
    return frozenset(term for each in equations for term in each.unknown)


def _known(given: Iterable[Equation], others: Iterable[Equation], letters: Said) -> Known:
    return known_of((each.printed for each in given), (each.printed for each in others), letters)


def _fitted(equation: Equation, known: Known) -> Equation:
    """The equation with letters for functions at places, and for integrals, of which others say what they are."""
    from sympy.core.function import AppliedUndef

    applied = {x for side in equation.printed for x in side.atoms(AppliedUndef)} if known.own else ()
    if any(map(is_special, equation.printed)) or any(known.own.get(x.func, x.args) != x.args for x in applied):
        return _equation(equation.printed, equation.primed, known)
    return equation


def _asked(relation: str, sources: tuple[str, ...], letters: Said) -> tuple[list[Equation], Own]:
    """The equations of a relation, and at which letters functions are printed there and in the sources."""
    asked = _equations(relation, letters)
    known = _known((equation for source in sources for equation in _equations(source, letters)), asked, letters)
    return [_fitted(equation, known) for equation in asked], tuple(known.own.items())


def _all(sources: tuple[str, ...], letters: Said, unknown: frozenset[Expr], own: Own) -> list[Equation]:
    """The equations of sources, and what follows from them for what is unknown elsewhere."""
    printed = [equation for source in sources for equation in _equations(source, letters)]
    known = replace(_known(printed, (), letters), own=dict(own))
    found = [_fitted(equation, known) for equation in printed]
    return [*found, *_further(found, unknown | _unknown(found), known)]


def _further(given: Sequence[Equation], unknown: Set[Expr], known: Known) -> Iterator[Equation]:
    """Rates, values at places, and integrals among what is unknown, by equations that say what functions are."""
    yield from _rates(given, unknown)
    for term in sorted(unknown, key=str):
        if (value := valued(term, known)) is not None:
            yield _equation((lettered(term, known)[0], value))


def _rates(given: Sequence[Equation], unknown: Set[Expr]) -> Iterator[Equation]:
    """The rates of change among what is unknown, by equations that say what is differentiated."""
    from sympy import Derivative, Function, Symbol
    from sympy.core.function import AppliedUndef

    solved = {side: other for each in given for side, other in (each.plain, each.plain[::-1]) if side.is_Symbol}
    functions = {_letter(x): x for x in unknown if isinstance(x, AppliedUndef)}
    open_ = {_letter(x): x for x in sorted(unknown, key=str) if isinstance(x, Derivative)}
    done = set[Symbol]()

    def known(rate: Any) -> tuple[Expr, Sequence[Symbol]] | None:
        """What it is a rate of, or what a lower rate is, and by which letters that is differentiated."""
        for n in range(len(rate.variables)):
            of = Derivative(rate.expr, *rate.variables[:n]) if n else rate.expr
            if _letter(of) in solved:
                return solved[_letter(of)], rate.variables[n:]
        return None

    def varying(symbol: Symbol, by: Symbol, asked: Set[Symbol] = frozenset()) -> Any:
        """A letter as a function of another one; of time also what equations make of functions. None if it is none."""
        of = open_.get(symbol, functions.get(symbol))
        if of is not None or str(by) != TIME or symbol not in solved or symbol in asked:
            return of if of is not None and by in of.free_symbols else None
        inside = solved[symbol].free_symbols
        moves = by in inside or any(varying(x, by, {*asked, symbol}) is not None for x in inside)
        return Function(str(symbol), real=True)(by) if moves else None

    while left := [(x, said) for x, rate in open_.items() if x not in done and (said := known(rate)) is not None]:
        for name, (side, variables) in left[: MOST_RATES - len(done)]:
            done.add(name)
            if not all(by.is_Symbol for by in variables):
                continue
            for by in variables:
                total = side.diff(by)
                for symbol in sorted(side.free_symbols - {by}, key=str):
                    if (of := varying(symbol, by)) is not None:
                        open_.setdefault(_letter(of.diff(by)), of.diff(by))
                        total += side.diff(symbol) * _letter(of.diff(by))
                side = total
            if side != 0:  # or nothing is known of what changes
                yield _equation((name, side))
        if len(done) == MOST_RATES:
            return


@lru_cache(1024)
def _points(
    sources: tuple[str, ...], letters: Said, unknown: frozenset[Expr], own: Own
) -> tuple[dict[Symbol, float], ...]:
    """Points at which all equations hold, with letters of the same signs; none if the first is not found."""
    if not sources:
        return ({},) * ANYWHERE
    zero = _zero(equations := _all(sources, letters, unknown, own))
    equations, fixed = [_without(each, zero) for each in equations], dict.fromkeys(zero, 0.0)
    symbols = [*dict.fromkeys(symbol for equation in equations for symbol in equation.symbols)]
    if (points := _explicit(equations, symbols)) is None:
        points = _implicit(equations, symbols)
    return tuple(fixed | dict(zip(symbols, map(float, point), strict=True)) for point in points[:POINTS])


def _implicit(equations: Sequence[Equation], symbols: Sequence[Symbol]) -> Array:
    """Points, one in each row, by Newton's method."""
    numbers, placed = np.random.default_rng(1), _placed(equations, symbols)
    with np.errstate(all="ignore"):
        for signs in _signs(len(symbols), placed):
            found = _solved(placed, signs * numbers.uniform(0.3, 1.7, signs.shape))
            there = _is_found(found)
            if np.any(there):
                same: Array = found[there & np.all(signs == signs[np.argmax(there)], axis=1)]
                return same
    return np.empty((0, len(symbols)))


def _explicit(equations: Sequence[Equation], symbols: Sequence[Symbol]) -> Array | None:
    """Points with all letters above zero, if each equation says what a letter is by those said before; else None."""
    rows = (next(((x, y) for x, y in (each.plain, each.plain[::-1]) if x.is_Symbol), None) for each in equations)
    left = [(*row, {*row[1].free_symbols}) for row in rows if row is not None]
    heads: dict[Symbol, Expr] = {}
    said = {head for head, _, _ in left}
    if len(left) < len(equations) or len(said) < len(left):
        return None
    while left:
        ready = [row for row in left if row[2].isdisjoint(said - heads.keys())]
        if not ready:
            return None
        heads |= {head: value for head, value, _ in ready}
        left = [row for row in left if row[0] not in heads]
    free = [symbol for symbol in symbols if symbol not in heads]
    numbers = np.random.default_rng(1)
    points = numbers.uniform(0.3, 1.7, (MANY, len(free)))
    values = dict(zip(free, points.T, strict=True))
    with np.errstate(all="ignore"):
        for head, value in heads.items():
            system = _placed([_Sides((value, value))], own := sorted(value.free_symbols & values.keys(), key=str))
            values[head] = np.broadcast_to(_evaluate(system, [values[x] for x in own])[0], MANY)
    found = np.array([values[x] for x in symbols]).T
    good = found[np.all((found > 0) & np.isfinite(found), axis=1)]
    return good if len(good) >= ENOUGH else None


def _zero(equations: Iterable[Equation]) -> set[Symbol]:
    """The letters of which an equation says that they are zero, so that they have no logarithm."""
    found: set[Symbol] = set()
    for each in equations:
        if len(each.symbols) == 1:
            with np.errstate(all="ignore"):
                differences, _ = _values(_placed([each], each.symbols), np.array([[0.0], [0.7], [1.3]]))
                there, *elsewhere = np.abs(differences[:, 0])
            if there == 0 and all(gap > EQUAL for gap in elsewhere):
                found.update(each.symbols)
    return found


def _without(equation: Equation, zero: Set[Symbol]) -> Equation:
    """An equation in which some letters are zero."""
    if zero.isdisjoint(equation.symbols):
        return equation
    free = tuple(symbol for symbol in equation.symbols if symbol not in zero)
    return equation._replace(symbols=free, shared=equation.shared - zero)


def _hold(equations: Iterable[Equation], points: Sequence[dict[Symbol, float]]) -> bool:
    """Whether equations hold at several points."""
    count = 0
    for point in points:
        own, values = _placed(equations, [*point]), np.array([[*point.values()]])
        differences, sizes = _values(own, values)
        count += bool(np.all(np.abs(differences) <= EQUAL * np.fmax(sizes, EQUAL)))
    return count >= min(ENOUGH, len(points))


def _equations(text: str, letters: Said) -> tuple[Equation, ...]:
    if not (found := _read(text, _own(text, letters))):
        raise SymcheckError("no equation is read here")
    return found


def _own(text: str, letters: Said) -> Said:
    """What is said of the letters of a text."""
    whole = bare(text)
    here = [(x, phrase) for x, phrase in letters if bare(x) in whole]
    return tuple((x, said) for x, said in here if is_of({y for y in depends_on(said) if bare(y) in whole}, said))


@lru_cache(4096)
def _read(text: str, letters: Said) -> tuple[Equation, ...]:
    primed = _PRIMED.search(text) is not None
    with suppress(SymcheckError, *FAULTS):
        return tuple(_of(readings(plainly(Asked(text, letters=letters)))[0].problems, primed))
    return ()


def _of(problems: Iterable[Problem], primed: bool) -> Iterator[Equation]:
    """The equations that these problems claim."""
    for both in _printed(problems):
        yield _equation(both, primed)


def _sides(problems: Iterable[Problem], known: Known, primed: bool) -> Iterator[list[Expr]]:
    """The sides of the equations that these problems claim, with letters and values for what is unknown there."""
    for both in _printed(problems):
        sides = [lettered(side, known, primed) for side in both]
        values = {letter: valued(term, known) for _, opened in sides for term, letter in opened.items()}
        said = {letter: value for letter, value in values.items() if value is not None}
        yield [side.xreplace(said) for side, _ in sides]


def _printed(problems: Iterable[Problem]) -> Iterator[tuple[Expr, Expr]]:
    """The sides of the equations that these problems claim."""
    for problem in problems:
        if any(letters_of(value) & letters_of(problem.claim) for _, value in problem.definitions):
            raise SymcheckError("a value is defined here, and not compared")
        if any(name == CASE for name, _ in problem.hypotheses):
            raise SymcheckError("it is stated case by case")
        left, right = (to_sympy(side) for side in problem.claim.terms)
        yield left, right


def _equation(printed: tuple[Expr, Expr], primed: bool = False, known: Known = NOTHING) -> Equation:
    (left, in_left), (right, in_right) = (lettered(side, known, primed) for side in printed)
    symbols = tuple(sorted(left.free_symbols | right.free_symbols, key=str))
    shared = frozenset(left.free_symbols & right.free_symbols)
    found = Equation(symbols, shared, (left, right), frozenset((*in_left, *in_right)), printed, primed)
    _placed([found], symbols)  # which is refused where a side has no value in numbers
    return found


def _signs(count: int, equations: System) -> Iterator[Array]:
    """Signs of letters in rows, the likeliest first: all above zero, those of a solution, one of them below zero."""
    yield np.ones((TRIED, count))
    free = _solved(equations, np.random.default_rng(3).uniform(0.3, 1.7, (TRIED, count)), free=True)
    if np.any(negative := np.any(free < 0, axis=1)):
        yield np.tile(np.sign(free[np.argmax(negative)]), (TRIED, 1))
    yield np.repeat(1.0 - 2.0 * np.eye(count), ENOUGH, axis=0)


def _letter(term: Expr) -> Symbol:
    """The letter for a function, or its rate of change."""
    from sympy import Symbol
    from sympy.core.function import AppliedUndef

    named = isinstance(term, AppliedUndef) and all(isinstance(each, Symbol) for each in term.args)
    return Symbol(term.func.__name__ if named else str(term), real=True)


def _placed(equations: Iterable[Equation | _Sides], symbols: Sequence[Symbol]) -> System:
    """The equations as steps for values of these letters; all other letters are zero."""
    numbers: dict[Basic, complex] = {}
    later: dict[Basic, None] = {}

    def visit(tree: Basic) -> None:
        if tree in known or tree in numbers or tree in later:
            return
        parts = _parts(tree) if tree.args else ()
        for part in parts:
            visit(part)
        if parts:
            later[tree] = None
        else:
            numbers[tree] = 0.0 if tree.is_Symbol else _number(tree)

    known, every = {*symbols}, [each.plain for each in equations]
    for side in chain.from_iterable(every):
        visit(side)
    places: dict[Basic, int] = {tree: n for n, tree in enumerate((*symbols, *numbers, *later))}
    steps = tuple((_function(tree), tuple(places[part] for part in _parts(tree))) for tree in later)
    return System(tuple(numbers.values()), steps, tuple((places[left], places[right]) for left, right in every))


def _number(tree: Basic) -> complex:
    return complex(tree) if tree.is_real is False else float(tree)


def _evaluate(system: System, letters_: Sequence[Any]) -> list[Any]:
    """Both sides of each equation, one after the other, for values of the letters; NaN where one is no real number."""
    found: list[Any] = [*letters_, *system.numbers]
    for function, places in system.steps:
        found.append(function(*[found[n] for n in places]))
    sides = [np.asarray(found[n]) for both in system.sides for n in both]
    return [np.where(x.imag == 0, x.real, np.nan) if x.dtype.kind == "c" else x for x in sides]


def _values(system: System, points: Array) -> tuple[Array, Array]:
    """Differences of the sides at points, one in each row, and their sizes; NaN where a side is no real number."""
    sides = np.empty((2 * len(system.sides), len(points)))
    for values, side in zip(sides, _evaluate(system, [*points.T]), strict=True):
        values[:] = side
    left, right = sides[::2].T, sides[1::2].T
    return left - right, np.abs(left) + np.abs(right)


def _slopes(equations: System, points: Array) -> tuple[Array, Array]:
    """Differences at each point, and their derivatives by the logarithms of the letters, which keep their signs so."""
    many, count = points.shape
    factors = 1.0 + DIFFERENCE * np.eye(count)
    around = np.concatenate(
        [points[:, None], points[:, None] * factors, points[:, None] / factors], axis=1
    )  # points, places around each, letters
    values = _values(equations, around.reshape(-1, count))[0].reshape(many, 2 * count + 1, len(equations.sides))
    slopes = np.asarray((values[:, 1 : count + 1] - values[:, count + 1 :]) / (2 * DIFFERENCE), float)
    return values[:, 0], np.transpose(slopes, (0, 2, 1))


def _jacobian(equations: System, point: Array) -> Array:
    _, (jacobian,) = _slopes(equations, point[None])
    return np.asarray(jacobian, float)


def _solved(equations: System, points: Array, free: bool = False) -> Array:
    """Points near others, with letters of the same signs unless they are free, at which all equations hold; or NaN."""
    found, rows = np.full(points.shape, np.nan), np.arange(len(points))
    for _ in range(STEPS):
        values, jacobian = _slopes(equations, points)
        left = np.max(np.abs(values), axis=1, initial=0.0)
        near = np.max(np.abs(np.log(np.abs(points))), axis=1, initial=0.0) <= FAR
        found[rows[near & (left < SMALL)]] = points[near & (left < SMALL)]
        going = near & (left >= SMALL) & np.all(np.isfinite(jacobian), axis=(1, 2))
        if not np.any(going):
            break
        rows, points, values, jacobian = rows[going], points[going], values[going], jacobian[going]
        inverse = np.linalg.pinv(jacobian / points[:, None] if free else jacobian, rcond=RANK)
        step = -(inverse @ values[:, :, None])[:, :, 0]
        longest = np.max(np.abs(step), axis=1, initial=LONGEST, keepdims=True)
        points = points + step if free else points * np.exp(step * LONGEST / longest)
    return found


def _is_found(points: Array) -> np.ndarray[Any, np.dtype[np.bool_]]:
    return np.array(np.isfinite(points).all(axis=1))


def _rank(jacobian: Array) -> int:
    if not jacobian.size or not np.all(np.isfinite(jacobian)):
        return 0
    lengths = np.linalg.norm(jacobian, axis=1, keepdims=True)
    sizes = np.linalg.svd(jacobian / np.fmax(lengths, SMALL), compute_uv=False)
    return int(np.sum(sizes > RANK * max(float(sizes[0]), RANK)))
