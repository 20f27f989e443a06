"""Sums of binomials and the like up to a letter, by the method of Wilf and Zeilberger.

The claim is that a sum of F(n, k) over k is C(n), where the ratios of F at neighbouring numbers, and of C, are rational
functions. Gosper's algorithm finds a rational function T with F(n + 1, k) - r F(n, k) = G(k + 1) - G(k), where r is
C(n + 1)/C(n) and G(k) = T(k) F(n, k - 1). Added up over k this leaves the ends alone, which vanish: so the sum has the
recurrence of C. What is left to trust is that sums telescope, and induction over n.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from math import factorial
from typing import TYPE_CHECKING

from symcheck.core.calculus import domain, letters, nodes, substituted
from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Problem
from symcheck.core.terms import Binder, End, Formula, Malformed, Node, Relation, T, Term, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.proof.algebra.knowledge import larger_first
from symcheck.proof.algebra.polynomial import Unsupported, number_of
from symcheck.question.prepare import DEFINED
from symcheck.reading import from_sympy, to_sympy

if TYPE_CHECKING:
    from sympy import Expr, Symbol

TRIED = 3  # numbers at which a claim is looked at: most false ones fail at one of them
MOST = 40  # the largest whole number of which a factorial is worked out: sums are added up at the first few


@dataclass(frozen=True)
class Summation:
    """What shows that a sum up to a whole letter is what is claimed, if all of it holds.

    Parameters
    ----------
    first
        The claim at the first numbers; some of them only tell false claims early.
    step
        How what is claimed, addends and ends differ at neighbouring numbers; None where no rational function is found.
    whole
        The letters of the sum, which are whole numbers.
    """

    first: tuple[Problem, ...]
    step: Callable[[], tuple[Problem, ...] | None]
    whole: frozenset[str]


def added_up(problem: Problem, whole: Iterable[str]) -> Summation | None:
    """The cases of a claim about a sum of what depends on its end too; None where there is no such sum."""
    found = _sum_alone(problem.claim)
    if found is None:
        return None
    total, claimed = found
    low, high = total.outside
    if not isinstance(low, int) or isinstance(high, End) or len(letters(high)) != 1:
        return None
    (n,) = letters(high)
    others = [claimed, *dict(problem.definitions).values(), *(f for name, fs in problem.hypotheses for f in fs)]
    said = set().union(*map(letters, others), dict(problem.definitions))
    defined = set().union(*map(letters, dict(problem.definitions).values()), dict(problem.definitions))
    gammas = any(part.tag == "gamma" for part in nodes(total.body))
    if n not in {*whole} - defined or total.letter in said or not (gammas or n in letters(total.body)):
        return None
    first, shift = _first(problem, n), number_of(substituted(high, {n: 0}))
    if first is None or shift is None or high not in (n, *_moved(n, int(shift))):
        return None
    start = first + int(shift)
    first += max(0, low - start)
    vanishing = list[Problem]()
    while len(vanishing) + 1 < TRIED and (zero := _vanishes(problem, total, n, low, first)) is not None:
        vanishing.append(zero)
        low += 1
    s = _Sum(total.body, total.letter, n, low, int(shift), claimed)

    def step() -> tuple[Problem, ...] | None:
        with suppress(SymcheckError, Malformed, Unsupported, ValueError, ArithmeticError, NotImplementedError):
            return (*vanishing, *_steps(problem, s, first + len(vanishing)))
        return None

    return Summation(tuple(_at(problem, s, first + more) for more in range(TRIED)), step, frozenset({n, total.letter}))


class _Sum:
    """The sum over `k` from `low` to `n + shift`, with what it is claimed to be."""

    def __init__(self, body: Term, k: str, n: str, low: int, shift: int, claimed: Term) -> None:
        self.body, self.k, self.n, self.low, self.shift, self.claimed = body, k, n, low, shift, claimed

    def addend(self, k: Term, n: Term | None = None) -> Term:
        """F at a place, at n if nothing else is said."""
        return substituted(self.body, {self.k: k, self.n: self.n if n is None else n})

    def end(self, more: int = 0) -> Term:
        """The last k, or one so many behind it."""
        return _sum(self.n, self.shift + more)

    def certificate(self) -> tuple[Term, Term]:
        """The ratio r of the claimed values at neighbouring numbers, and T."""
        import sympy
        from sympy.concrete.gosper import gosper_term

        k, n = (sympy.Symbol(x, real=True) for x in (self.k, self.n))
        body, claimed = (plainly(to_sympy(each), k, n) for each in (self.body, self.claimed))
        r = sympy.Integer(0) if claimed == 0 else ratio(claimed, n)
        ahead, back = ratio(body, n), 1 / ratio(body, k).subs(k, k - 1)
        rest = sympy.factor(ahead - r)
        if rest == 0:
            return from_sympy(r), 0
        found = gosper_term(rest * body, k)
        if found is None:
            raise SymcheckError("it does not telescope")
        return from_sympy(sympy.factor(r)), from_sympy(sympy.factor(sympy.cancel(found * rest / back)))


def plainly(expr: Expr, *of: Symbol) -> Expr:
    """With a cosine of multiples of pi as a power of -1."""
    import sympy

    def power(angle: Expr) -> Expr:
        times = sympy.expand(angle / sympy.pi)
        return (-1) ** times if times.has(*of) else sympy.cos(angle)

    return expr.replace(sympy.cos, power)


def ratio(expr: Expr, x: Symbol) -> Expr:
    """That of neighbouring values: a rational function of the letter."""
    from sympy import factor
    from sympy.simplify.simplify import hypersimp

    found = hypersimp(expr, x)
    if found is None:
        raise SymcheckError("the ratio of neighbouring values is not rational")
    return factor(found)


def _sum_alone(claim: Formula) -> tuple[Binder, Term] | None:
    """A sum that is one side of an equation, with the other side; signs, factors and addends are brought there."""
    if not isinstance(claim, Relation) or claim.tag != "=":
        return None
    for side, other in (claim.terms, claim.terms[::-1]):
        if any(part.tag == "sum" for part in nodes(other)):
            continue
        match side:
            case Binder(tag="sum"):
                return side, other
            case Node(tag="-", outside=(inner,)) if any(part.tag == "sum" for part in nodes(inner)):
                return _sum_alone(node("=", inner, node("-", other)))
            case Node(tag="*", outside=factors):
                sums = [part for part in factors if isinstance(part, Binder) and part.tag == "sum"]
                rest = [part for part in factors if part not in sums]
                if len(sums) == 1 and rest and not any(part.tag == "sum" for part in nodes(*rest)):
                    return sums[0], node("/", other, node("*", *rest) if rest[1:] else rest[0])
            case Node(tag="+", outside=addends):
                own = [part for part in addends if any(inner.tag == "sum" for inner in nodes(part))]
                beside = [node("-", part) for part in addends if part not in own]
                if len(own) == 1:
                    return _sum_alone(node("=", own[0], node("+", other, *beside)))
    return None


def _moved(n: str, shift: int) -> tuple[Term, ...]:
    """The ways in which a number of places behind a letter is said."""
    return node("+", n, shift), node("+", shift, n), node("+", n, node("-", -shift))


def _sum(n: Term, more: int) -> Term:
    return node("+", n, more) if more else n


def _first(problem: Problem, n: str) -> int | None:
    """The least number that conditions allow; None if there is none, or they say more of the letter."""
    bounds = list[int]()
    for name, formula in ((name, part) for name, fs in problem.hypotheses for f in fs for part in conjuncts(f)):
        match larger_first(formula):
            case Node(tag=">" | ">=" as sign, outside=(x, int(k))) if x == n:
                bounds.append(k + (sign == ">"))
            case other if n in letters(other) and name != DEFINED:
                return None
    return max(bounds, default=None)


def _without(problem: Problem, n: str) -> list[tuple[str, tuple[Formula, ...]]]:
    """The hypotheses that do not speak of a letter."""
    found = ((name, tuple(f for f in fs if n not in letters(f))) for name, fs in problem.hypotheses)
    return [(name, fs) for name, fs in found if fs]


def _at(problem: Problem, s: _Sum, number: int) -> Problem:
    """The claim at a number, its addends added up."""
    addends = [worked_out(s.addend(k, number)) for k in range(s.low, number + s.shift + 1)]
    value = node("+", 0, *addends)
    claim = node("=", value, worked_out(substituted(s.claimed, {s.n: number})))
    return replace(problem, claim=claim, hypotheses=tuple(_without(problem, s.n)))


def _vanishes(problem: Problem, total: Binder, n: str, low: int, first: int) -> Problem | None:
    """That the first addend is zero, if a factor of it is."""
    addend = substituted(total.body, {total.letter: low})
    factors = addend.outside if isinstance(addend, Node) and addend.tag == "*" else (addend,)
    if not any(number_of(factor) == 0 for factor in factors):
        return None
    hypotheses = (*_without(problem, n), ("whole", (node(">=", n, first),)))
    return replace(problem, claim=node("=", addend, 0), hypotheses=hypotheses)


def _steps(problem: Problem, s: _Sum, first: int) -> tuple[Problem, ...]:
    """That claimed values have the ratio r, that of neighbouring addends, and that nothing is left at the ends."""
    r, t = s.certificate()
    later, k = node("+", s.n, 1), s.k

    def differ(k: Term) -> Term:
        return node("+", s.addend(k, later), node("-", node("*", r, s.addend(k))))

    def ahead(k: Term, more: int) -> Term:
        """G at a place that many ahead, where F has a value at the place."""
        return node("*", substituted(t, {s.k: _sum(k, more)}), s.addend(_sum(k, more - 1)))

    left = node("+", differ(s.low), s.addend(s.end(1), later), ahead(s.end(), 1), node("-", ahead(s.low, 1)))
    here = [*_without(problem, s.n), ("whole", (node(">=", s.n, first),))]
    inside = [*here, ("inside", (node(">=", k, s.low + 1), node("<=", k, s.end())))]
    claims = (
        (node("=", substituted(s.claimed, {s.n: later}), node("*", r, s.claimed)), here),
        (node("=", differ(k), node("+", ahead(k, 1), node("-", ahead(k, 0)))), inside),
        (node("=", left, 0), here),
    )
    stated = [(_tidy(claim), given) for claim, given in claims]
    valued = [
        (each, given)
        for claim, given in stated
        for each in dict.fromkeys(part for whole in domain(claim, divisors=True) for part in not_zero(whole))
        if letters(each) & {s.n, k}
    ]
    return tuple(replace(problem, claim=claim, hypotheses=tuple(given)) for claim, given in (*stated, *valued))


def not_zero(condition: Formula) -> Iterator[Formula]:
    """The conditions that no factor of a divisor vanishes; a gamma function is positive where it has a value."""
    match condition:
        case Node(tag="!=", outside=(Node(tag="*", outside=factors), 0)):
            for factor in factors:
                yield from not_zero(node("!=", factor, 0))
        case Node(tag="!=", outside=(Node(tag="^", outside=(base, int())), 0)):
            yield from not_zero(node("!=", base, 0))
        case Node(tag="!=", outside=(Node(tag="gamma" | "pow"), 0)):
            pass
        case _:
            yield condition


def without_gammas(problem: Problem) -> Problem:
    """The problem without what is said of gamma functions, which are positive where they have a value."""
    found = (
        (name, tuple(f for f in fs if not any(part.tag == "gamma" for part in nodes(f))))
        for name, fs in problem.hypotheses
    )
    return replace(problem, hypotheses=tuple((name, fs) for name, fs in found if fs))


def _tidy(tree: T) -> T:
    """The same with the arguments of gamma functions expanded, so that those a whole number apart are seen to be."""
    from sympy import expand

    if not isinstance(tree, Node):
        return tree
    new = mapped(tree, _tidy)
    return node("gamma", from_sympy(expand(to_sympy(new.outside[0])))) if new.tag == "gamma" else new  # type: ignore[return-value]


def worked_out(tree: T) -> T:
    """The same with factorials for the gamma function of whole numbers, and powers with whole exponents as such."""
    if not isinstance(tree, Node):
        return tree
    match tree:
        case Node(tag="pow", outside=(base, int(exponent))):
            power = node("^", worked_out(base), abs(exponent)) if exponent else 1
            return power if exponent >= 0 else node("/", 1, power)  # type: ignore[return-value]
    if tree.tag == "gamma" and (n := number_of(tree.outside[0])) is not None and n in range(1, MOST):
        return factorial(int(n) - 1)  # type: ignore[return-value]
    return mapped(tree, worked_out)  # type: ignore[return-value]
