"""What is given of an exponential, as it is of its exponent: `e^{-k t} = 1/2` is `-k t = ln(1/2)`."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

from symcheck.core.calculus import letters, nodes, substituted
from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import Formula, Node, Relation, Term, node
from symcheck.core.verdicts import SymcheckError
from symcheck.proof.algebra.polynomial import unfold
from symcheck.proof.rules.compute import Point
from symcheck.proof.search.methods import whole_proof
from symcheck.proof.search.number_points import refute_at, refute_at_some
from symcheck.proof.search.wellformed import checked
from symcheck.question.series import FAULTS
from symcheck.reading import from_sympy, to_sympy

MOST = 3  # exponentials


def with_exponents(problem: Problem) -> Problem:
    """The problem with hints that logarithms of equal numbers are equal, where a given equation has an exponential."""
    hints = [hint for _, formulas in problem.hypotheses for each in formulas for hint in _hints(each)]
    return replace(problem, hints=(*problem.hints, *hints[:MOST])) if hints else problem


def refuted(problem: Problem) -> Point | None:
    """A point where a given equation is solved for a letter in its exponent, with the proof that it holds there."""
    definitions = dict(problem.definitions)
    for name, formulas in problem.hypotheses:
        for given in formulas:
            equation = unfold(given, definitions)
            found = {x: value for x, value in _solved(equation) if x not in definitions}
            for letter, value in sorted(found.items(), key=lambda each: each[0] not in problem.claim.outside):
                others = tuple((n, tuple(f for f in fs if f != given or n != name)) for n, fs in problem.hypotheses)
                solved = replace(problem, definitions=((letter, value), *problem.definitions), hypotheses=others)
                there = checked(solved)
                if (point := refute_at_some(there) or refute_at(there, {})) is None:
                    continue
                values = {**point.values, letter: substituted(value, point.values)}
                closed = substituted(equation, values)
                proof = whole_proof(Problem("value", closed))
                if proof is not None and not proof.nonzero:
                    return replace(point, values=values, facts=(*point.facts, (closed, proof.step)))
    return None


def _solved(equation: Formula) -> Iterator[tuple[str, Term]]:
    """The letters that an equation is solved for, in the exponent of its only exponential."""
    for power, value in _only_exponential(equation):
        import sympy

        (exponent,) = power.outside
        for letter in sorted(letters(exponent) - letters(value)):
            with suppress(SymcheckError, sympy.PolynomialError, *FAULTS):
                x = sympy.Symbol(letter, real=True)
                line = sympy.Poly(to_sympy(exponent), x)
                if line.degree() == 1:
                    yield letter, from_sympy((sympy.log(to_sympy(value)) - line.nth(0)) / line.nth(1))


def _hints(equation: Formula) -> Iterator[Applied[Term]]:
    """That the logarithm of its only exponential is that of what the equation says it is."""
    for power, value in _only_exponential(equation):
        yield Applied("congruence", (node("log", power), node("log", value)), ())


def _only_exponential(equation: Formula) -> Iterator[tuple[Node, Term]]:
    """The only exponential in an equation, with what the equation says it is."""
    found = dict.fromkeys(part for part in nodes(equation) if part.tag == "exp" and letters(part))
    if len(found) != 1 or not isinstance(equation, Relation) or equation.tag != "=":
        return
    import sympy

    (power,) = found
    left, right = equation.terms
    with suppress(SymcheckError, sympy.PolynomialError, *FAULTS):
        letter = sympy.Dummy(real=True)
        gap = (to_sympy(left) - to_sympy(right)).subs(to_sympy(power), letter)
        linear = sympy.Poly(sympy.fraction(sympy.together(gap))[0], letter)
        if linear.degree() == 1:
            yield power, from_sympy(sympy.cancel(-linear.nth(0) / linear.nth(1)))
