"""Transformations of hypergeometric functions: solutions of one differential equation with one value at zero.

A claim is brought to the form F(c x^m) = G(x), where F is a hypergeometric function and G an elementary function, times
another hypergeometric function of an elementary one perhaps. It is shown that G solves the differential equation of the
left side at all small x > 0, that its value at 0 is 1, and that both sides are analytic between 0 and x. What is left
to trust is that the equation has one solution with that value which is analytic at 0, as no power of x but the first
can be chosen freely, and that functions which are analytic along a way and equal at its beginning are equal.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from math import factorial

from symcheck.core.calculus import derivative, fresh, functions, letters, regular, substituted
from symcheck.core.certificates import Certificate
from symcheck.core.problems import Problem
from symcheck.core.terms import Call, Formula, Node, T, Term, Value, mapped, node
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.proof.algebra.polynomial import number_of
from symcheck.question.power_series import FAULTS, Member, members_in
from symcheck.reading import to_sympy

Decide = Callable[[Problem], tuple[Verdict, Certificate | None, tuple[str, ...]]]
INNER, VALUE = "inner_function", "value_of_inner"  # the other function, and letters for its derivatives
MOST = 3  # the order of a zero that is divided out at 0
POWERS = range(1, 5)  # of x in the argument


@dataclass(frozen=True)
class Shown:
    """The cases of a proof, all decided, with their certificates."""

    cases: tuple[Problem, ...]
    certificates: tuple[Certificate, ...]


def transformed(problem: Problem, of: Mapping[str, tuple[int, int]], decide: Decide) -> Shown | None:
    """The proof that a hypergeometric function is another one, or an elementary function; None if none is found."""
    with suppress(*FAULTS):
        found = dict(members_in(problem.claim, of))
        if problem.claim.tag != "=" or problem.definitions or not 0 < len({*found.values()}) <= 2:
            return None
        for call, main in found.items():
            with suppress(*FAULTS):
                other = next((each for each in found.values() if each != main), None)
                left, right = problem.claim.outside
                whole = next(iter((*_alone(left, right, call), *_alone(right, left, call))), None)
                if whole is None or main.order or (other is not None and other.order):
                    continue
                inner = {part: node("call", INNER, (0,), each.at) for part, each in found.items() if each == other}
                return _Transformation(problem, main, other, _put(whole, inner), decide).shown()
    return None


def _put(tree: T, by: Mapping[Node, Term]) -> T:
    if tree in by:
        return by[tree]  # type: ignore[index, return-value]
    return mapped(tree, lambda part: _put(part, by)) if isinstance(tree, Node) else tree  # type: ignore[return-value]


def _alone(side: Term, other: Term, call: Node) -> Iterator[Term]:
    """What a factor of one side is by the other side."""
    match side:
        case _ if side == call:
            yield other
        case Value(tag="-", terms=(inner,)):
            yield from _alone(inner, node("-", other), call)
        case Value(tag="/", terms=(top, bottom)):
            yield from _alone(top, node("*", other, bottom), call)
        case Value(tag="*", terms=factors):
            for k, factor in enumerate(factors):
                rest = [*factors[:k], *factors[k + 1 :]]
                yield from _alone(factor, node("/", other, node("*", 1, *rest)), call)


class _Transformation:
    """The claim that a function is what is said, in which the other one is an unknown function of one argument."""

    def __init__(self, problem: Problem, main: Member, other: Member | None, whole: Term, decide: Decide) -> None:
        self.problem, self.main, self.other, self.whole, self.decide = problem, main, other, whole, decide
        self.cases, self.certificates = list[Problem](), list[Certificate]()
        parameters = (*main.above, *main.below, *(() if other is None else (*other.above, *other.below)))
        self.x, self.m = _monomial(main.at, set().union(*map(letters, parameters)))
        if functions(whole) - {INNER}:
            raise SymcheckError("the function stands on both sides")
        for b in main.below:
            free = number_of(b)
            if (free is None and self.m > 1) or (free is not None and (n := self.m * (1 - free)) > 0 == n % 1):
                raise SymcheckError("the solution is not determined by its value at 0")

    def shown(self) -> Shown | None:
        tops, bottoms = map(_product, _apart(self.whole))
        near = [*regular(tops), *regular(bottoms)]
        at_zero = all(self._is_so(self._at(condition)) for condition in near if self.x in letters(condition))
        if not at_zero or (self.other and not self._is_so(node("=", self._at(self.other.at), 0))):
            return None
        if not self._begins_with_one(tops, bottoms) or not self._solves() or not self._reaches(near):
            return None
        return Shown(tuple(self.cases), tuple(self.certificates))

    def _is_so(self, claim: Formula, *more: Formula, kept: Callable[[Formula], bool] | None = None) -> bool:
        """Whether something is proved by the conditions without x, or by those that are kept, and more."""
        kept = kept or (lambda f: self.x not in letters(f))
        given = tuple((name, tuple(f for f in fs if kept(f))) for name, fs in self.problem.hypotheses)
        hypotheses = (*((name, fs) for name, fs in given if fs), *((f"near {k}", (f,)) for k, f in enumerate(more)))
        case = replace(self.problem, claim=claim, hypotheses=hypotheses)
        verdict, made, _ = self.decide(case)
        if verdict is not Verdict.PROVED or made is None:
            return False
        self.cases.append(case)
        self.certificates.append(made)
        return True

    def _at(self, tree: T) -> T:
        """The same at x = 0, where the other function is 1 and its derivatives are its coefficients."""
        tree = substituted(tree, {self.x: 0})
        other = self.other

        def put(part: Term) -> Term:
            if isinstance(part, Call) and part.function == INNER and other is not None:
                (order,) = part.orders
                return node("*", factorial(order), other.coefficient(order))
            return mapped(part, put) if isinstance(part, Node) else part

        return put(tree)  # type: ignore[return-value, arg-type]

    def _begins_with_one(self, top: Term, bottom: Term) -> bool:
        """Whether the quotient tends to 1 at 0, where both may vanish together."""
        for _ in range(MOST + 1):
            high, low = self._at(top), self._at(bottom)
            if self._is_so(node("!=", low, 0)):
                return self._is_so(node("=", high, low))
            if not self._is_so(node("=", low, 0)) or not self._is_so(node("=", high, 0)):
                return False
            top, bottom = derivative(top, self.x), derivative(bottom, self.x)
        return False

    def _solves(self) -> bool:
        """Whether the other side solves the differential equation of the function where x is small and positive."""
        x = self.x

        def steps(tree: Term, parameter: Term) -> Term:
            slope = node("/", node("*", x, derivative(tree, x)), self.m)
            return node("+", slope, node("*", parameter, tree)) if parameter != 0 else slope

        left, right = self.whole, self.whole
        for b in (*self.main.below, 1):
            left = steps(left, node("+", b, -1) if b != 1 else 0)
        for a in self.main.above:
            right = steps(right, a)
        known = _Derivatives(self.other) if self.other is not None else None
        claim = node("=", left, node("*", self.main.at, right))
        claim = known.put(claim) if known is not None else claim
        near = [*regular(self.whole), *(known.conditions if known is not None else ())]
        near = [condition for condition in dict.fromkeys(near) if x in letters(condition)]
        if any(not self._holds_near(condition) for condition in near):
            return False
        return self._is_so(claim, node(">", x, 0), *near)

    def _holds_near(self, condition: Formula) -> bool:
        """Whether it holds at small x > 0: at 0 itself, or what is not to vanish has a zero of some order there."""
        if condition.tag != "!=":
            return self._is_so(self._at(condition))
        part: Term = condition.outside[0]
        for _ in range(MOST + 1):
            if self._is_so(node("!=", self._at(part), 0)):
                return True
            if not self._is_so(node("=", self._at(part), 0)):
                return False
            part = derivative(part, self.x)
        return False

    def _reaches(self, near: Sequence[Formula]) -> bool:
        """Whether both sides are analytic at all y between 0 and x."""
        x = self.x
        singular = [each for each in (self.main, self.other) if each is not None and len(each.above) > len(each.below)]
        wanted = [*near, *(node("<", each.at, 1) for each in singular)]
        wanted = [condition for condition in dict.fromkeys(wanted) if x in letters(condition)]
        taken = set().union(*map(letters, wanted), *(letters(f) for _, fs in self.problem.hypotheses for f in fs))
        y = fresh(x, taken)
        ways = [(node("<=", 0, y), node("<=", y, x)), (node("<=", x, y), node("<=", y, 0))]
        for k, sign in enumerate((">=", "<=")):
            if wanted and self._is_so(node(sign, x, 0), kept=lambda _: True):
                ways = [ways[k]]
                break
        return all(
            self._is_so(substituted(condition, {x: y}), *way, kept=lambda _: True)
            for condition in wanted
            for way in ways
        )


class _Derivatives:
    """The derivatives of a function, by its differential equation, as letters for the value and the lowest ones."""

    def __init__(self, member: Member) -> None:
        self.at, self.order = member.at, len(member.below) + 1
        u = "argument_of_inner"
        left, right = (node("call", INNER, (0,), u),) * 2
        for b in (*member.below, 1):
            slope = node("*", u, derivative(left, u))
            left = node("+", slope, node("*", node("+", b, -1), left)) if b != 1 else slope
        for a in member.above:
            right = node("+", node("*", u, derivative(right, u)), node("*", a, right))
        rest = substituted(
            self._without_highest(node("+", node("*", u, right), node("-", left))), {u: member.at}
        )  # of the equation u^n f^(n) = rest, or u^n (1 - u) f^(n) = rest, where n is the order
        top, bottom = map(_product, _apart(member.at))
        gap = node("+", bottom, node("-", top))
        factors = [node("^", node("/", bottom, top), self.order)]
        self.conditions = [node("!=", top, 0), node("!=", bottom, 0)]
        if len(member.above) > len(member.below):
            factors.append(node("/", bottom, gap))
            self.conditions.append(node("!=", gap, 0))
        self.highest = node("*", rest, *factors)

    def _without_highest(self, tree: T) -> T:
        """The part of the equation without the derivative of the highest order."""
        if isinstance(tree, Call) and tree.function == INNER:
            return 0 if tree.orders[0] == self.order else tree  # type: ignore[return-value]
        return mapped(tree, self._without_highest) if isinstance(tree, Node) else tree  # type: ignore[return-value]

    def put(self, tree: T) -> T:
        """The same with letters for the value and the lowest derivatives."""
        if isinstance(tree, Call) and tree.function == INNER:
            (order,) = tree.orders
            if order > self.order:
                raise SymcheckError("a derivative of a higher order")
            return f"{VALUE}_{order}" if order < self.order else self.put(self.highest)  # type: ignore[return-value]
        return mapped(tree, self.put) if isinstance(tree, Node) else tree  # type: ignore[return-value]


def _monomial(at: Term, but: set[str]) -> tuple[str, int]:
    """(x, m) with a multiple of x^m."""
    import sympy

    expr = to_sympy(at)
    for symbol in sorted(expr.free_symbols, key=str) if expr.is_rational_function() else ():
        for m in POWERS:
            if str(symbol) not in but and not sympy.cancel(expr / symbol**m).has(symbol):
                return str(symbol), m
    raise SymcheckError("no multiple of a power")


def _apart(tree: Term) -> tuple[list[Term], list[Term]]:
    """The factors above and below the line."""
    match tree:
        case Value(tag="*", terms=factors):
            pairs = [_apart(factor) for factor in factors]
            return [t for above, _ in pairs for t in above], [t for _, below in pairs for t in below]
        case Value(tag="/", terms=(top, bottom)):
            (above, below), (under, over) = _apart(top), _apart(bottom)
            return [*above, *over], [*below, *under]
        case Value(tag="-", terms=(inner,)):
            above, below = _apart(inner)
            return [-1, *above], below
        case Value(tag="^", terms=(base, int(n))) if n < 0:
            return [], [node("^", base, -n) if n != -1 else base]
    return [tree], []


def _product(factors: Sequence[Term]) -> Term:
    return node("*", *factors) if len(factors) > 1 else factors[0] if factors else 1
