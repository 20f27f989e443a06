"""Functions that linear differential equations with initial values determine: what they are takes their place.

Such an equation, with coefficients that are smooth everywhere and a leading one that is not zero, has one solution with
given values at a place, on the whole line. That a term is that solution is proved before it is put in.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import lru_cache

from symcheck.core.calculus import Lambda, Unknown, derivative, functions, is_entire, letters, nodes, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import Call, Formula, Malformed, Node, T, Term, mapped, node
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.proof import identity
from symcheck.proof.algebra.polynomial import Unsupported, unfold
from symcheck.question.jets import calls_in, expanded
from symcheck.question.limit import OutOfTime, limited
from symcheck.question.places import is_at_one_place
from symcheck.reading import from_sympy, to_sympy

Hypotheses = tuple[tuple[str, tuple[Formula, ...]], ...]
# what SymPy raises for what it cannot do
FAULTS = (ArithmeticError, ValueError, TypeError, AttributeError, NotImplementedError, RecursionError)
SECONDS = 5.0  # for one equation: those that SymPy solves at all it solves in one


def with_solutions(problem: Problem) -> Problem | None:
    """The problem with what its functions are in their place; None if some function is not determined."""
    try:
        plain = expanded(problem)
    except (Unknown, Unsupported):
        return None
    meant = dict(plain.definitions)
    claim = unfold(plain.claim, meant)
    hypotheses = [(name, unfold(f, meant)) for name, fs in plain.hypotheses for f in fs]
    known: dict[str, Lambda] = {}
    while (found := next(_solved([f for _, f in hypotheses], known), None)) is not None:
        if not all(_reaches(formula, found, hypotheses) for formula in (claim, *(f for _, f in hypotheses))):
            return None
        known |= found
        claim, hypotheses = _put(claim, found), [(name, _put(f, found)) for name, f in hypotheses]
        given = _conditions([f for _, f in hypotheses])
        hypotheses = [(n, f) for n, f in hypotheses if f.tag != "=" or functions(f) or not _is_proved(f, given)]
    if not known or any(map(functions, (claim, *(f for _, f in hypotheses)))):
        return None
    stated: dict[str, tuple[Formula, ...]] = {}
    for name, formula in hypotheses:
        stated[name] = (*stated.get(name, ()), formula)
    return replace(problem, claim=claim, definitions=(), hypotheses=tuple(stated.items()))


def _reaches(formula: Formula, known: Mapping[str, Lambda], hypotheses: Sequence[tuple[str, Formula]]) -> bool:
    """Whether functions are asked for where their equations hold, under the conditions on their letters."""
    given = _conditions([f for _, f in hypotheses])
    places = {(call.terms[0], known[call.function][0][0]) for call in calls_in(formula) if call.function in known}
    return all(place == x or _is_within(x, place, given) for place, x in places)


def _conditions(formulas: Sequence[Formula]) -> Hypotheses:
    """What is given that is no equation and speaks of no function."""
    return tuple((f"given{n}", (f,)) for n, f in enumerate(formulas) if f.tag != "=" and not functions(f))


def _is_proved(formula: Formula, given: Hypotheses) -> bool:
    return identity.decide(Problem("met", formula, (), given)).verdict is Verdict.PROVED


def _put(formula: T, known: Mapping[str, Lambda]) -> T:
    """A formula with terms in the place of functions and of their derivatives."""

    def put(tree: Term) -> Term:
        if not isinstance(tree, Node):
            return tree
        new = mapped(tree, put)
        if not isinstance(new, Call) or new.function not in known:
            return new
        ((x,), body), (order,), (place,) = known[new.function], new.orders, new.terms
        for _ in range(order):
            body = derivative(body, x)
        return substituted(body, {x: place})

    return put(formula)  # type: ignore[return-value, arg-type]


def _solved(formulas: Sequence[Formula], known: Mapping[str, Lambda]) -> Iterator[dict[str, Lambda]]:
    """Functions of one letter with what they are, by an equation that speaks of one of them at that letter."""
    for equation in formulas:
        calls = {part for part in nodes(equation) if isinstance(part, Call)}
        if equation.tag != "=" or len({(call.function, call.terms) for call in calls}) != 1:
            continue
        function, place = next((call.function, call.terms) for call in calls)
        x = place[0]
        alone = not any(f.tag == "=" and x in letters(f) and not functions(f) for f in formulas)
        if len(place) != 1 or not isinstance(x, str) or function in known or not alone:
            continue
        if is_at_one_place(equation, x):
            continue
        with suppress(SymcheckError, Unknown, Unsupported, Malformed, OutOfTime, *FAULTS), limited(SECONDS):
            if (body := _determined(equation, function, x, tuple(formulas))) is not None:
                yield {function: ((x,), body)}


@lru_cache(64)  # repairs of one relation have the same equations
def _determined(equation: Formula, function: str, x: str, formulas: Sequence[Formula]) -> Term | None:
    """The one solution of a linear equation with the values that are given at one place."""
    import sympy

    given = _conditions(formulas)
    calls = {part.orders[0]: part for part in nodes(equation) if isinstance(part, Call)}
    names: dict[Term, Term] = {call: f"order_{n}" for n, call in calls.items()}
    gap = _renamed(node("+", equation.terms[0], node("-", equation.terms[1])), names)
    slopes = {n: derivative(gap, f"order_{n}") for n in calls}
    rest = from_sympy(to_sympy(substituted(gap, dict.fromkeys(map(str, names.values()), 0))))
    top = max(calls)
    if rest == 0 and len(calls) == 1:
        return None  # as f'(x) = 0, which may be said of one place
    if any(letters(slope) & {*names.values()} for slope in slopes.values()) or x in letters(slopes[top]):
        return None
    if not isinstance(slopes[top], int) and not _is_proved(node("!=", slopes[top], 0), given):
        return None
    if not top and x not in letters(rest) | letters(slopes[0]):
        return None  # as v = v_0, which may be said of one moment
    if not top:
        return from_sympy(-to_sympy(rest) / to_sympy(slopes[0]))
    starts = _starts(formulas, function)
    if starts is None or {*starts[1]} != {*range(top)} or not _is_within(x, starts[0], given):
        return None
    if not all(is_entire(part, x) for part in (*slopes.values(), rest)):
        return None
    y, place = sympy.Function("solution")(to_sympy(x)), to_sympy(starts[0])
    first = {y.diff(to_sympy(x), n).subs(to_sympy(x), place): to_sympy(value) for n, value in starts[1].items()}
    left = sum((to_sympy(slope) * y.diff(to_sympy(x), n) for n, slope in slopes.items()), to_sympy(rest))
    positive = {
        to_sympy(f.terms[0]): sympy.Symbol(f.terms[0], positive=True)
        for _, (f,) in given
        if f.tag == ">" and isinstance(f.terms[0], str) and f.terms[1] == 0 and f.terms[0] != x
    }
    plainly = {back: symbol for symbol, back in positive.items()}
    ics = {k.subs(positive): v.subs(positive) for k, v in first.items()}
    found = sympy.dsolve(left.subs(positive), y.subs(positive), ics=ics).rhs.subs(plainly)
    if found.has(sympy.Integral, sympy.I) or any(
        str(symbol).startswith("C") and str(symbol)[1:].isdigit() for symbol in found.free_symbols
    ):
        return None
    body = from_sympy(found)
    solution: dict[str, Lambda] = {function: ((x,), body)}
    met = [_put(equation, solution)]
    met += [_put(node("=", node("call", function, (n,), starts[0]), value), solution) for n, value in starts[1].items()]
    return body if all(_is_proved(formula, given) for formula in met) else None


def _starts(formulas: Sequence[Formula], function: str) -> tuple[Term, dict[int, Term]] | None:
    """The one place at which values of a function and of its derivatives are given, and these."""
    found: dict[Term, dict[int, Term]] = {}
    for formula in formulas:
        match formula.terms if formula.tag == "=" else ():
            case (Call() as call, value) if call.function == function and not functions(value):
                if len(call.terms) == 1 and not isinstance(call.terms[0], str):
                    found.setdefault(call.terms[0], {})[call.orders[0]] = value
    return next(iter(found.items())) if len(found) == 1 else None


def _is_within(x: str, place: Term, given: Hypotheses) -> bool:
    """Whether a place is one of those that x may have, or at their end: there the equation holds, too."""
    weak = {"<": "<=", ">": ">="}
    about = [f for _, (f,) in given if x in letters(f) and f.tag != "!="]
    others = tuple((name, (f,)) for name, (f,) in given if x not in letters(f))
    ends = (substituted(node(weak.get(f.tag, f.tag), *f.outside), {x: place}) for f in about)
    return all(_is_proved(end, others) for end in ends)


def _renamed(tree: Term, names: Mapping[Term, Term]) -> Term:
    if isinstance(tree, Node) and tree in names:
        return names[tree]
    return mapped(tree, lambda part: _renamed(part, names)) if isinstance(tree, Node) else tree
