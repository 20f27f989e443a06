"""Integrals of unknown functions: by parts, by the theorem of calculus, over ranges that join, and of moved arguments.

A claim says that a sum of multiples of integrals is what has none. At each end of them the integrands, with their
factors and signs, add up to S, which is the derivative of a term G in the functions and their derivatives. Then the sum
is that of all G at their ends. That the derivative of G is S is proved; what is left to trust is the theorem of
calculus, for functions that are as smooth as is printed, and the substitution of linear functions.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from symcheck.core.calculus import Unknown, functions, letters, nodes, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import Binder, Call, End, Node, T, Term, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.question import jets
from symcheck.question.series import FAULTS, Series
from symcheck.reading import from_sympy, to_sympy

if TYPE_CHECKING:
    from sympy import Expr, Symbol

MOST = 12  # steps to a primitive: each takes one product of derivatives away
PLACE = "place_of_functions"  # the letter of all integrands
# functions by which a false claim is told, in turn
SAMPLES = (("x", "x**2", "1 + x"), ("x**2", "1 + x", "x"), ("1", "x", "x**2"))


@dataclass(frozen=True)
class _Jets:
    """Symbols for the values of functions and their derivatives at the place, by function and order."""

    names: dict[tuple[str, int], str]

    def symbol(self, function: str, order: int) -> Symbol:
        import sympy

        return sympy.Symbol(self.names.setdefault((function, order), f"{function}_{order}_there"), real=True)

    def slope(self, term: Expr) -> Expr:
        """The derivative by the place."""
        import sympy

        found = sympy.diff(term, sympy.Symbol(PLACE, real=True))
        for function, order in [*self.names]:
            found += sympy.diff(term, self.symbol(function, order)) * self.symbol(function, order + 1)
        return sympy.expand(found)

    def orders(self, term: Expr) -> dict[str, int]:
        """The highest derivative of each function that stands in a term."""
        found = dict[str, int]()
        for (function, order), name in self.names.items():
            if any(symbol.name == name for symbol in term.free_symbols):
                found[function] = max(order, found.get(function, 0))
        return found

    def primitive(self, term: Expr) -> Expr:
        """What a term is the derivative of; SymcheckError if nothing is found."""
        import sympy

        whole, rest = sympy.Integer(0), sympy.expand(term)
        for _ in range(MOST):
            if rest == 0:
                return whole
            orders = self.orders(rest)
            top = max(orders.values(), default=-1)
            if top < 0:
                found = sympy.integrate(rest, sympy.Symbol(PLACE, real=True))
                if found.has(sympy.Integral):
                    break
                return whole + found
            function = next(f for f, order in orders.items() if order == top)
            factor = sympy.diff(rest, self.symbol(function, top))
            if top == 0 or any(order >= top for order in self.orders(factor).values()):
                break
            found = sympy.integrate(factor, self.symbol(function, top - 1))
            whole, rest = whole + found, sympy.expand(rest - self.slope(found))
        raise SymcheckError("no primitive")

    def at(self, term: Expr, end: Term) -> Term:
        """A term with the functions at an end."""
        by: dict[str, Term] = {
            name: node("call", function, (order,), end) for (function, order), name in self.names.items()
        }
        return substituted(from_sympy(term), {**by, PLACE: end})


def with_primitives(problem: Problem) -> Series | None:
    """The problem without integrals of unknown functions; None if it has none, or their sum is not known."""
    with suppress(*FAULTS, Unknown):
        if problem.claim.tag != "=" or problem.definitions or not _integrals(problem.claim):
            return None
        return _without(jets.expanded(problem))
    return None


def _integrals(tree: Node) -> list[Binder]:
    found = dict.fromkeys(part for part in nodes(tree) if isinstance(part, Binder) and part.tag == "integral")
    return [*found] if any(functions(each.body) for each in found) else []


def _without(problem: Problem) -> Series:
    import sympy

    found = {part: sympy.Symbol(f"integral_{k}", real=True) for k, part in enumerate(_integrals(problem.claim))}
    names = {part: str(symbol) for part, symbol in found.items()}

    def put(tree: T) -> T:
        if tree in names:
            return names[tree]  # type: ignore[return-value]
        return mapped(tree, put) if isinstance(tree, Node) else tree  # type: ignore[return-value]

    left, right = (put(side) for side in problem.claim.terms)
    gap = sympy.expand(to_sympy(left) - to_sympy(right))
    factors = {part: sympy.diff(gap, symbol) for part, symbol in found.items()}
    if any(factor.free_symbols & {*found.values()} for factor in factors.values()):
        raise SymcheckError("a claim that is not linear in integrals")
    rest = gap.subs(dict.fromkeys(found.values(), 0))
    at = _Jets({})
    ends: dict[Expr, Expr] = {}
    places: dict[Expr, Term] = {}
    sides = list[Problem]()
    for part, factor in factors.items():
        slope, body, (low, high) = _moved(part, at)
        if slope.free_symbols:
            sides.append(replace(problem, claim=node("!=", from_sympy(slope), 0)))
        for end, sign in ((high, 1), (low, -1)):
            key = sympy.expand(to_sympy(end))
            places.setdefault(key, end)
            ends[key] = sympy.expand(ends.get(key, 0) + sign * factor * body)
    whole = [from_sympy(rest)]
    for key, term in ends.items():
        if term == 0:
            continue
        primitive = at.primitive(term)
        slope_of = node("diff", at.at(primitive, PLACE), PLACE, 1, PLACE)
        sides.append(replace(problem, claim=node("=", slope_of, at.at(term, PLACE)), hypotheses=()))
        whole.append(at.at(primitive, places[key]))
    return Series(replace(problem, claim=node("=", node("+", 0, *whole), 0)), tuple(sides))


def _moved(part: Binder, at: _Jets) -> tuple[Expr, Expr, tuple[Term, Term]]:
    """An integral of functions of one linear function u of the letter, by u: its slope, the integrand, and the ends."""
    import sympy

    if any(isinstance(end, End) for end in part.outside):
        raise SymcheckError("an endless integral")
    x, u = sympy.Symbol(part.letter, real=True), sympy.Symbol(PLACE, real=True)
    calls = [each for each in jets.calls_in(part.body) if part.letter in letters(each)]
    arguments = {sympy.expand(to_sympy(term)) for call in calls for term in call.terms}
    line = arguments.pop() if arguments else x
    slope = sympy.diff(line, x)
    if arguments or slope == 0 or slope.has(x) or any(len(call.terms) != 1 for call in calls):
        raise SymcheckError("functions of several arguments")
    by = {call: str(at.symbol(call.function, call.orders[0])) for call in calls}

    def put(tree: T) -> T:
        if isinstance(tree, Call) and tree in by:
            return by[tree]  # type: ignore[return-value]
        if isinstance(tree, Call | Binder):
            raise SymcheckError("a function that is constant there, or an integral of an integral")
        return mapped(tree, put) if isinstance(tree, Node) else tree  # type: ignore[return-value]

    start = line.subs(x, 0)
    body = to_sympy(put(part.body)).subs(x, (u - start) / slope) / slope
    low, high = (from_sympy(sympy.expand(line.subs(x, to_sympy(end)))) for end in part.outside)
    return slope, sympy.expand(body), (low, high)


def is_law(problem: Problem) -> bool:
    """Whether a claim may be meant for all functions: its ends are letters, and it is so of multiples of the functions.

    It may still say where one of the ends is, unless a slip explains why it fails.
    """
    if problem.claim.tag != "=":
        return False
    integrals = _integrals(problem.claim)
    free = [end for part in integrals for end in part.outside if isinstance(end, str)]
    left, right = problem.claim.terms
    same = functions(left) == functions(right) != set()
    degrees = {_degree(left), _degree(right)}
    return same and len({*free}) > 1 and not problem.hypotheses and len(degrees) == 1 and not degrees & {0, None}


def with_slips(problem: Problem) -> Iterator[Problem]:
    """The claims with another sign of one addend, or twice or half of one side."""
    for k, side in enumerate(problem.claim.terms):
        addends = side.outside if isinstance(side, Node) and side.tag == "+" else (side,)
        others: list[Term] = [node("*", 2, side), node("/", side, 2)]
        for j, each in enumerate(addends):
            changed = [*addends[:j], node("-", each), *addends[j + 1 :]]
            others.append(node("+", *changed) if len(changed) > 1 else changed[0])
        for other in others:
            sides = [*problem.claim.terms]
            sides[k] = other
            yield replace(problem, claim=node("=", *sides))


def _degree(tree: Term) -> int | None:
    """How a term grows with all functions: by which power of a number that they are multiplied by; None if by none."""
    match tree:
        case Call():
            return None if any(map(functions, tree.terms)) else 1
        case Binder():
            return _degree(tree.body)
        case Node(tag="*", outside=parts):
            degrees = [*map(_degree, parts)]
            return None if None in degrees else sum(n for n in degrees if n is not None)
        case Node(tag="+", outside=parts):
            several = {_degree(part) for part in parts if part != 0}
            return several.pop() if len(several) == 1 else None
        case Node(tag="-", outside=(inner,)):
            return _degree(inner)
        case Node(tag="/", outside=(top, bottom)) if _degree(bottom) == 0:
            return _degree(top)
        case Node(tag="^", outside=(base, int(n))):
            degree = _degree(base)
            return None if degree is None else n * degree
    return None if functions(tree) else 0


def with_samples(problem: Problem) -> Iterator[tuple[Mapping[str, str], Problem]]:
    """The problem with simple functions in the place of unknown ones, and these."""
    import sympy

    names = sorted(functions(problem.claim))
    x = sympy.Symbol("x", real=True)
    for sample in SAMPLES if len(names) <= len(SAMPLES[0]) else ():
        chosen = dict(zip(names, sample, strict=False))
        with suppress(*FAULTS, Unknown):
            yield chosen, replace(jets.expanded(problem), claim=_put(jets.expanded(problem).claim, chosen, x))


def _put(tree: T, chosen: Mapping[str, str], x: Symbol) -> T:
    import sympy

    if isinstance(tree, Call):
        slope = sympy.diff(sympy.sympify(chosen[tree.function], {"x": x}), x, sum(tree.orders))
        return substituted(from_sympy(slope), {"x": _put(tree.terms[0], chosen, x)})  # type: ignore[return-value]
    return mapped(tree, lambda part: _put(part, chosen, x)) if isinstance(tree, Node) else tree  # type: ignore[return-value]
