"""Powers of any number with whole letters for exponents: b^(n + 1) is b times b^n, also for negative b.

Each b^n with a letter n has a letter of its own: what holds of all numbers in its place holds of the power. Where b is
0 and something is divided by it, both sides are the limits of what they are beside it.
"""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from dataclasses import replace

from symcheck.core.calculus import differentiated, domain, letters, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import PI, Binder, Formula, Node, T, Term, mapped, node
from symcheck.proof.algebra.polynomial import number_of
from symcheck.question.prepare import DEFINED
from symcheck.question.series import FAULTS
from symcheck.reading import to_sympy


def with_whole_powers(problem: Problem, whole: set[str]) -> Problem:
    """The problem with derivatives worked out, definitions put in, and letters for b^n with whole n and any b."""
    problem = inlined(problem)
    powers = _Powers(whole, letters(problem.claim))
    claim = powers.put(_worked(problem.claim))
    valued = domain(powers.put(problem.claim), divisors=True)
    return with_claim(problem, claim, (each for each in valued if letters(each).isdisjoint(powers.names.values())))


def inlined(problem: Problem) -> Problem:
    """The problem with definitions put in."""
    by = dict(problem.definitions)
    for _ in by:
        by = {x: substituted(term, by) for x, term in by.items()}
    given = tuple((name, tuple(substituted(f, by) for f in fs)) for name, fs in problem.hypotheses)
    return replace(problem, claim=substituted(problem.claim, by), definitions=(), hypotheses=given)


def with_claim(problem: Problem, claim: Formula, valued: Iterable[Formula]) -> Problem:
    """The problem with another claim, and what has to hold that this has a value."""
    given = (*(each for each in problem.hypotheses if each[0] != DEFINED), (DEFINED, tuple(valued)))
    kept = ((name, tuple(f for f in fs if letters(f))) for name, fs in given)
    return replace(problem, claim=claim, hypotheses=tuple((name, fs) for name, fs in kept if fs))


def _worked(tree: T) -> T:
    """The same with its derivatives worked out."""
    if not isinstance(tree, Node):
        return tree
    new = mapped(tree, _worked)
    return differentiated(new) if isinstance(new, Binder) and new.tag == "diff" else new  # type: ignore[return-value]


class _Powers:
    """Letters for powers, by base and exponent."""

    def __init__(self, whole: set[str], taken: set[str]) -> None:
        self.whole, self.taken, self.names = whole, taken, dict[tuple[Term, str], str]()

    def put(self, tree: T) -> T:
        """A tree with letters for powers."""
        if not isinstance(tree, Node):
            return tree
        new = mapped(tree, self.put)
        if new.tag == "pow" and (found := self._power(*new.outside)) is not None:
            return found  # type: ignore[return-value]
        return new  # type: ignore[return-value]

    def _power(self, base: Term, exponent: Term) -> Term | None:
        import sympy

        if not letters(exponent) or not letters(exponent) <= self.whole or number_of(base) is not None:
            return None
        with suppress(*FAULTS, sympy.PolynomialError):
            shift, moving = sympy.expand(to_sympy(exponent)).as_coeff_Add()
            line = sympy.Poly(moving, *sorted(moving.free_symbols, key=str))
            counts = [(str(x), line.coeff_monomial(x)) for x in line.gens]
            if not line.is_linear or not all(n.is_Integer for n in (shift, *(n for _, n in counts))):
                return None
            factors = [part for x, n in counts for part in self._parts(base, x, int(n))]
            return node("*", 1, *factors, _whole(base, int(shift)))
        return None

    def _parts(self, base: Term, x: str, n: int) -> list[Term]:
        """The factors of a power of a product."""
        match base:
            case Node(tag="*", outside=several):
                return [part for each in several for part in self._parts(each, x, n)]
            case Node(tag="/", outside=(top, bottom)):
                return [*self._parts(top, x, n), *self._parts(bottom, x, -n)]
            case Node(tag="^", outside=(inner, int(k))):
                return self._parts(inner, x, k * n)
            case Node(tag="-", outside=(inner,)):
                return [*([node("cos", node("*", PI, x))] if n % 2 else []), *self._parts(inner, x, n)]
            case Node(tag="exp", outside=(inner,)):
                return [node("exp", node("*", n, x, inner))]
        if number_of(base) is not None:
            return [node("pow", base, node("*", n, x))] if base != 1 else []
        spelled = (f"power_{k}" for k in range(1, len(self.taken) + len(self.names) + 2))
        free = (name for name in spelled if name not in self.taken and name not in self.names.values())
        return [_whole(self.names.setdefault((base, x), next(free)), n)]


def _whole(base: Term, n: int) -> Term:
    power = node("^", base, abs(n))
    return 1 if n == 0 else power if n > 0 else node("/", 1, power)
